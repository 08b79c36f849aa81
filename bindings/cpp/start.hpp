/*
 * cairn.hpp - Cairn for C++17, a thin layer on cairn.h: worlds and trees that destroy themselves, handles of distinct types,
 * definitions that start with their defaults, slices and vectors for arrays, results that hold a value or an error.
 * @NOTICE@
 *
 *     cairn::World world;                                     // or cairn::World::create(def)
 *     cairn::Body body = world.body_create(cairn::BodyDef()).value();
 *     cairn::ShapeDef shape; shape.body = body;
 *     world.shape_create_box(shape, 0.5f, 0.5f, 0.0f).value();
 *     world.step(1.0f / 60.0f).check();
 *     cn_pose pose = world.body_get_pose(body).value();
 *
 * A method is the C function without cn_ and without the world: cn_body_get_pose(world, body, &out) is world.body_get_pose(body).
 * Outputs are returned, several as a tuple. value() and check() of a failed call throw cairn::Error, and end the program where
 * exceptions are off; test with `if (result)`, result.code() or value_or() to do without them.
 */
#ifndef CAIRN_HPP
#define CAIRN_HPP

#include "cairn.h"
#include <cstddef>
#include <cstdlib>
#include <string>
#include <tuple>
#include <utility>
#include <vector>
#if defined(__cpp_exceptions)
#include <stdexcept>
#endif

namespace cairn {

#if defined(__cpp_exceptions)
/// What value() and check() of a failed call throw. what() is the library's sentence where the call was on a world that may change.
class Error : public std::runtime_error {
public:
	Error(cn_result code, const char *text) : std::runtime_error(text), code_(code) {}
	cn_result code() const noexcept { return code_; }

private:
	cn_result code_;
};
#endif

[[noreturn]] inline void fail(cn_result code, const cn_world *world)
{
	const char *text = world != nullptr ? cn_world_error_text(world) : "";
	if (*text == 0)
		text = cn_result_text(code);
#if defined(__cpp_exceptions)
	throw Error(code, text);
#else
	(void)text;
	std::abort();
#endif
}

/// What became of a call that returns nothing else.
class Status {
public:
	Status(cn_result code, const cn_world *world) noexcept : code_(code), world_(world) {}
	explicit operator bool() const noexcept { return code_ == CN_OK; }
	cn_result code() const noexcept { return code_; }
	/// Throws, or ends the program, if the call failed.
	void check() const
	{
		if (code_ != CN_OK)
			fail(code_, world_);
	}

private:
	cn_result code_;
	const cn_world *world_; // that knows the sentence, or null
};

/// A value, or the error that there is instead. Read the error's sentence before the next call on the world.
template <class T> class [[nodiscard]] Result {
public:
	Result(Status status, T &&value) : status_(status), value_(std::move(value)) {}
	explicit operator bool() const noexcept { return static_cast<bool>(status_); }
	cn_result code() const noexcept { return status_.code(); }
	/// The value; throws, or ends the program, if there is none.
	T &value() &
	{
		status_.check();
		return value_;
	}
	T value() &&
	{
		status_.check();
		return std::move(value_);
	}
	T value_or(T other) const { return status_ ? value_ : other; }

private:
	Status status_;
	T value_;
};

/// A number of elements in a row that belong to someone else, as std::span: made from arrays, vectors, and pointer and size.
template <class T> class Slice {
public:
	Slice() noexcept = default;
	Slice(T *data, std::size_t size) noexcept : data_(data), size_(size) {}
	template <std::size_t N> Slice(T (&array)[N]) noexcept : data_(array), size_(N) {}
	template <class C, class = decltype(static_cast<T *>(std::declval<C &>().data()))>
	Slice(C &&container) noexcept : data_(container.data()), size_(container.size()) {}
	T *data() const noexcept { return data_; }
	std::size_t size() const noexcept { return size_; }
	T *begin() const noexcept { return data_; }
	T *end() const noexcept { return data_ + size_; }
	T &operator[](std::size_t i) const noexcept { return data_[i]; }

private:
	T *data_ = nullptr;
	std::size_t size_ = 0;
};

/// A handle of one kind. It turns into C's by itself, and back only when asked to.
template <class C, int Kind> struct Handle {
	C id{};
	Handle() noexcept = default;
	explicit Handle(C from) noexcept : id(from) {}
	operator C() const noexcept { return id; }
};
