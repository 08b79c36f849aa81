/*
 * cairn.hpp - Cairn for C++17, a thin layer on cairn.h: worlds and trees that destroy themselves, handles of distinct types,
 * definitions that start with their defaults, slices and vectors for arrays, results that hold a value or an error.
 * Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
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
using Body = Handle<cn_body, 0>;
using Shape = Handle<cn_shape, 1>;
using Joint = Handle<cn_joint, 2>;
using Constraint = Handle<cn_constraint, 3>;

/// cn_world_def with its defaults.
struct WorldDef : cn_world_def {
	WorldDef() noexcept : cn_world_def() { cn_world_def_init(this); }
};
/// cn_body_def with its defaults.
struct BodyDef : cn_body_def {
	BodyDef() noexcept : cn_body_def() { cn_body_def_init(this); }
};
/// cn_shape_def with its defaults.
struct ShapeDef : cn_shape_def {
	ShapeDef() noexcept : cn_shape_def() { cn_shape_def_init(this); }
};
/// cn_revolute_def with its defaults.
struct RevoluteDef : cn_revolute_def {
	RevoluteDef() noexcept : cn_revolute_def() { cn_revolute_def_init(this); }
};
/// cn_distance_def with its defaults.
struct DistanceDef : cn_distance_def {
	DistanceDef() noexcept : cn_distance_def() { cn_distance_def_init(this); }
};
/// cn_fixed_def with its defaults.
struct FixedDef : cn_fixed_def {
	FixedDef() noexcept : cn_fixed_def() { cn_fixed_def_init(this); }
};
/// cn_prismatic_def with its defaults.
struct PrismaticDef : cn_prismatic_def {
	PrismaticDef() noexcept : cn_prismatic_def() { cn_prismatic_def_init(this); }
};
/// cn_wheel_def with its defaults.
struct WheelDef : cn_wheel_def {
	WheelDef() noexcept : cn_wheel_def() { cn_wheel_def_init(this); }
};
/// cn_motor_def with its defaults.
struct MotorDef : cn_motor_def {
	MotorDef() noexcept : cn_motor_def() { cn_motor_def_init(this); }
};
/// cn_mouse_def with its defaults.
struct MouseDef : cn_mouse_def {
	MouseDef() noexcept : cn_mouse_def() { cn_mouse_def_init(this); }
};
/// cn_gear_def with its defaults.
struct GearDef : cn_gear_def {
	GearDef() noexcept : cn_gear_def() { cn_gear_def_init(this); }
};
/// cn_pulley_def with its defaults.
struct PulleyDef : cn_pulley_def {
	PulleyDef() noexcept : cn_pulley_def() { cn_pulley_def_init(this); }
};
/// cn_ratchet_def with its defaults.
struct RatchetDef : cn_ratchet_def {
	RatchetDef() noexcept : cn_ratchet_def() { cn_ratchet_def_init(this); }
};
/// cn_rotary_spring_def with its defaults.
struct RotarySpringDef : cn_rotary_spring_def {
	RotarySpringDef() noexcept : cn_rotary_spring_def() { cn_rotary_spring_def_init(this); }
};
/// cn_groove_def with its defaults.
struct GrooveDef : cn_groove_def {
	GrooveDef() noexcept : cn_groove_def() { cn_groove_def_init(this); }
};
/// cn_filter_joint_def with its defaults.
struct FilterJointDef : cn_filter_joint_def {
	FilterJointDef() noexcept : cn_filter_joint_def() { cn_filter_joint_def_init(this); }
};
/// cn_angle_constraint_def with its defaults.
struct AngleConstraintDef : cn_angle_constraint_def {
	AngleConstraintDef() noexcept : cn_angle_constraint_def() { cn_angle_constraint_def_init(this); }
};
/// cn_line_constraint_def with its defaults.
struct LineConstraintDef : cn_line_constraint_def {
	LineConstraintDef() noexcept : cn_line_constraint_def() { cn_line_constraint_def_init(this); }
};
/// cn_query_filter with its defaults.
struct QueryFilter : cn_query_filter {
	QueryFilter() noexcept : cn_query_filter() { cn_query_filter_init(this); }
};
/// cn_mover_def with its defaults.
struct MoverDef : cn_mover_def {
	MoverDef() noexcept : cn_mover_def() { cn_mover_def_init(this); }
};
/// cn_area_def with its defaults.
struct AreaDef : cn_area_def {
	AreaDef() noexcept : cn_area_def() { cn_area_def_init(this); }
};
/// cn_explosion_def with its defaults.
struct ExplosionDef : cn_explosion_def {
	ExplosionDef() noexcept : cn_explosion_def() { cn_explosion_def_init(this); }
};
/// cn_debug_draw with its defaults.
struct DebugDraw : cn_debug_draw {
	DebugDraw() noexcept : cn_debug_draw() { cn_debug_draw_init(this); }
};

/// Owns a cn_world.
class World {
public:
	/// A world with the defaults, or of a definition; an error if there is no memory or a value is bad.
	static Result<World> create(const cn_world_def &def)
	{
		cn_world *out = nullptr;
		cn_result code = cn_world_create(&def, &out);
		return { Status(code, nullptr), World(out) };
	}
	/// A world from bytes of write. Of the definition only memory, workers and capacities are used.
	static Result<World> read(Slice<const unsigned char> file, const cn_world_def *def = nullptr)
	{
		cn_world *out = nullptr;
		cn_result code = cn_world_read(def, file.data(), file.size(), &out);
		return { Status(code, nullptr), World(out) };
	}
	/// As create, which throws or ends the program instead.
	explicit World(const cn_world_def &def = WorldDef()) : World(create(def).value()) {}
	explicit World(cn_world *owned) noexcept : world_(owned) {}
	World(World &&other) noexcept : world_(std::exchange(other.world_, nullptr)) {}
	World &operator=(World &&other) noexcept
	{
		std::swap(world_, other.world_);
		return *this;
	}
	~World() { cn_world_destroy(world_); }
	/// For functions of cairn.h.
	cn_world *get() const noexcept { return world_; }
	/// The sentence of the last call that failed, "" if none did.
	const char *error_text() const noexcept { return cn_world_error_text(world_); }
	/// Calls function(event) for contact events of one kind, while the world is locked; null ends that. The function stays the
	/// caller's and must live as long as it may be called. No exception may leave it.
	template <class F> Status on_contact(int32_t kind, F &function)
	{
		auto call = [](cn_world *, const cn_contact_event *event, void *user) { (*static_cast<F *>(user))(*event); };
		return { cn_world_set_contact_callback(world_, kind, call, &function), world_ };
	}
	Status on_contact(int32_t kind, std::nullptr_t) { return { cn_world_set_contact_callback(world_, kind, nullptr, nullptr), world_ }; }

	/// Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
	/// O(awake bodies and their contacts and joints).
	Status step(float dt_s)
	{
		return Status(cn_world_step(world_, dt_s), world_);
	}

	/// Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).
	Status set_gravity(float gravity_x_mps2, float gravity_y_mps2)
	{
		return Status(cn_world_set_gravity(world_, gravity_x_mps2, gravity_y_mps2), world_);
	}

	/// Reads gravity in m/s^2.
	Result<cn_vec2> get_gravity() const
	{
		cn_vec2 out_mps2{};
		cn_result code = cn_world_get_gravity(world_, &out_mps2);
		return { Status(code, nullptr), std::move(out_mps2) };
	}

	/// Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.
	Status set_substep_count(int32_t count)
	{
		return Status(cn_world_set_substep_count(world_, count), world_);
	}

	/// Reads the substeps of a step.
	Result<int32_t> get_substep_count() const
	{
		int32_t out_count{};
		cn_result code = cn_world_get_substep_count(world_, &out_count);
		return { Status(code, nullptr), std::move(out_count) };
	}

	/// Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
	/// memory of the solver it was created with; a solver that needs more works without direct solving
	/// (CN_WARNING_FRAME_MEMORY).
	Status set_solver(int32_t solver)
	{
		return Status(cn_world_set_solver(world_, solver), world_);
	}

	/// Reads the solver (CN_SOLVER_*).
	Result<int32_t> get_solver() const
	{
		int32_t out_solver{};
		cn_result code = cn_world_get_solver(world_, &out_solver);
		return { Status(code, nullptr), std::move(out_solver) };
	}

	/// Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.
	Status set_accuracy(float accuracy_m, int32_t work_budget)
	{
		return Status(cn_world_set_accuracy(world_, accuracy_m, work_budget), world_);
	}

	/// Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
	/// (CN_DEFAULT: none).
	Result<std::tuple<float, int32_t>> get_accuracy() const
	{
		float out_accuracy_m{};
		int32_t out_work_budget{};
		cn_result code = cn_world_get_accuracy(world_, &out_accuracy_m, &out_work_budget);
		return { Status(code, nullptr), { std::move(out_accuracy_m), std::move(out_work_budget) } };
	}

	/// Reads how many workers a step can use: 1, or worker_count where the library supports threads.
	Result<int32_t> get_worker_count() const
	{
		int32_t out_count{};
		cn_result code = cn_world_get_worker_count(world_, &out_count);
		return { Status(code, nullptr), std::move(out_count) };
	}

	/// Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).
	Status set_flags(uint32_t flags)
	{
		return Status(cn_world_set_flags(world_, flags), world_);
	}

	/// Reads the CN_WORLD_ flags.
	Result<uint32_t> get_flags() const
	{
		uint32_t out_flags{};
		cn_result code = cn_world_get_flags(world_, &out_flags);
		return { Status(code, nullptr), std::move(out_flags) };
	}

	/// Impacts slower than this, in m/s, do not bounce; >= 0.
	Status set_restitution_threshold(float speed_mps)
	{
		return Status(cn_world_set_restitution_threshold(world_, speed_mps), world_);
	}

	/// Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.
	Status set_hit_speed(float speed_mps)
	{
		return Status(cn_world_set_hit_speed(world_, speed_mps), world_);
	}

	/// Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster bodies
	/// down to them and keeps the direction.
	Status set_speed_limits(float linear_mps, float angular_radps)
	{
		return Status(cn_world_set_speed_limits(world_, linear_mps, angular_radps), world_);
	}

	/// Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
	/// they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
	/// others that no joint holds and that are slower than four times the speed lose theirs within a second or
	/// two: what rocks in a hollow would keep all of a heap awake.
	Status set_sleep(float speed_mps, float delay_s)
	{
		return Status(cn_world_set_sleep(world_, speed_mps, delay_s), world_);
	}

	/// Stores a number for the user.
	Status set_user_data(uint64_t user_data)
	{
		return Status(cn_world_set_user_data(world_, user_data), world_);
	}

	/// Reads the user's number.
	Result<uint64_t> get_user_data() const
	{
		uint64_t out_user_data{};
		cn_result code = cn_world_get_user_data(world_, &out_user_data);
		return { Status(code, nullptr), std::move(out_user_data) };
	}

	/// Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
	/// capacity is 0. out_count is their number. O(slots).
	Result<std::vector<cn_body>> get_bodies() const
	{
		std::vector<cn_body> list;
		int32_t count = 0;
		cn_result code = cn_world_get_bodies(world_, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_get_bodies(world_, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots).
	Result<std::vector<cn_shape>> get_shapes() const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_world_get_shapes(world_, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_get_shapes(world_, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
	/// cn_world_get_bodies. O(slots).
	Result<std::vector<cn_joint>> get_joints() const
	{
		std::vector<cn_joint> list;
		int32_t count = 0;
		cn_result code = cn_world_get_joints(world_, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_get_joints(world_, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Reads counts of objects and what the last step reported. O(bodies + islands).
	Result<cn_counters> get_counters() const
	{
		cn_counters out_out{};
		cn_result code = cn_world_get_counters(world_, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in a
	/// deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their number. A
	/// step does no work for it. O(bodies + contacts and joints of the islands written).
	Result<std::vector<cn_island_report>> get_islands() const
	{
		std::vector<cn_island_report> list;
		int32_t count = 0;
		cn_result code = cn_world_get_islands(world_, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_get_islands(world_, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Reads the seconds of the last step by stage.
	Result<cn_profile> get_profile() const
	{
		cn_profile out_out{};
		cn_result code = cn_world_get_profile(world_, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads the memory statistics.
	Result<cn_memory_stats> get_memory_stats() const
	{
		cn_memory_stats out_out{};
		cn_result code = cn_world_get_memory_stats(world_, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position p
	/// becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes, world
	/// anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay, and no
	/// event is reported. Distances between bodies keep their digits; world anchors are rounded to floats at the
	/// new place. Arrays returned before become invalid; the user moves their own points (movers, rays, cached
	/// poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all pairs
	/// again.
	Status shift_origin(float x_m, float y_m)
	{
		return Status(cn_world_shift_origin(world_, x_m, y_m), world_);
	}

	/// 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
	/// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on every
	/// compiler, CPU and thread count. O(bodies + contacts + joints).
	Result<uint64_t> hash() const
	{
		uint64_t out_hash{};
		cn_result code = cn_world_hash(world_, &out_hash);
		return { Status(code, nullptr), std::move(out_hash) };
	}

	/// Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).
	Result<uint64_t> save_size() const
	{
		uint64_t out_bytes{};
		cn_result code = cn_world_save_size(world_, &out_bytes);
		return { Status(code, nullptr), std::move(out_bytes) };
	}

	/// Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
	/// number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
	/// about 1 KB per body.
	Result<std::vector<unsigned char>> save() const
	{
		uint64_t bytes = 0;
		std::vector<unsigned char> out;
		cn_result code = cn_world_save_size(world_, &bytes);
		out.resize(static_cast<std::size_t>(bytes));
		if (code == CN_OK)
			code = cn_world_save(world_, out.data(), bytes, &bytes);
		out.resize(static_cast<std::size_t>(bytes));
		return { Status(code, nullptr), std::move(out) };
	}

	/// Restores a saved state, into the saved world or one created with the same definition (broadphase, length
	/// unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT for
	/// damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the objects alive then (a
	/// world in a caller's block has room for its own saves). Arrays returned before become invalid. Handles of
	/// objects alive at the save are valid again, also of objects destroyed since; handles created since are
	/// refused until the same handle is given to a new object: with the same calls to the same object. O(memory
	/// of the world).
	Status restore(Slice<const unsigned char> save)
	{
		return Status(cn_world_restore(world_, save.data(), save.size()), world_);
	}

	/// Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).
	Result<uint64_t> write_size() const
	{
		uint64_t out_bytes{};
		cn_result code = cn_world_write_size(world_, &out_bytes);
		return { Status(code, nullptr), std::move(out_bytes) };
	}

	/// Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number of
	/// bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1 KB
	/// per body.
	Result<std::vector<unsigned char>> write() const
	{
		uint64_t bytes = 0;
		std::vector<unsigned char> out;
		cn_result code = cn_world_write_size(world_, &bytes);
		out.resize(static_cast<std::size_t>(bytes));
		if (code == CN_OK)
			code = cn_world_write(world_, out.data(), bytes, &bytes);
		out.resize(static_cast<std::size_t>(bytes));
		return { Status(code, nullptr), std::move(out) };
	}

	/// Creates a body. O(1) amortized.
	Result<Body> body_create(const cn_body_def &def)
	{
		cn_body out_body{};
		cn_result code = cn_body_create(world_, &def, &out_body);
		return { Status(code, world_), Body(out_body) };
	}

	/// Creates count (>= 0) bodies from an array of definitions, all or none. O(count).
	Status body_create_many(Slice<const cn_body_def> defs, Slice<cn_body> out_bodies)
	{
		if (defs.size() != out_bodies.size())
			return { CN_ERROR_ARGUMENT, nullptr };
		return Status(cn_body_create_many(world_, defs.data(), static_cast<int32_t>(out_bodies.size()), out_bodies.data()), world_);
	}

	/// Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
	/// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts +
	/// joints + shapes).
	Status body_destroy(Body body)
	{
		return Status(cn_body_destroy(world_, body), world_);
	}

	/// Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice. O(their
	/// contacts + joints + shapes).
	Status body_destroy_many(Slice<const cn_body> bodies)
	{
		return Status(cn_body_destroy_many(world_, bodies.data(), static_cast<int32_t>(bodies.size())), world_);
	}

	/// 1 if the handle names a living body of this world, else 0 (also for a NULL world).
	bool body_is_valid(Body body) const noexcept
	{
		return cn_body_is_valid(world_, body) != 0;
	}

	/// Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that
	/// still overlap begin again in the next step), with its forces and any mass override; a body made static
	/// stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints + shapes).
	Status body_set_type(Body body, int32_t type)
	{
		return Status(cn_body_set_type(world_, body, type), world_);
	}

	/// Reads the type (CN_BODY_*).
	Result<int32_t> body_get_type(Body body) const
	{
		int32_t out_type{};
		cn_result code = cn_body_get_type(world_, body, &out_type);
		return { Status(code, nullptr), std::move(out_type) };
	}

	/// Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
	/// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints are
	/// inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.
	Status body_set_flags(Body body, uint32_t flags)
	{
		return Status(cn_body_set_flags(world_, body, flags), world_);
	}

	/// Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.
	Result<uint32_t> body_get_flags(Body body) const
	{
		uint32_t out_flags{};
		cn_result code = cn_body_get_flags(world_, body, &out_flags);
		return { Status(code, nullptr), std::move(out_flags) };
	}

	/// 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled
	/// bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).
	Status body_set_awake(Body body, int32_t awake)
	{
		return Status(cn_body_set_awake(world_, body, awake), world_);
	}

	/// Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <= 1e4).
	/// Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports them. Gaps
	/// of its joints close at some 15 length units a second. Wakes the body and its new and old neighbours.
	/// O(contacts + joints + shapes).
	Status body_set_pose(Body body, float position_x_m, float position_y_m, float angle_rad)
	{
		return Status(cn_body_set_pose(world_, body, position_x_m, position_y_m, angle_rad), world_);
	}

	/// Reads the position of the origin and the rotation.
	Result<cn_pose> body_get_pose(Body body) const
	{
		cn_pose out_out{};
		cn_result code = cn_body_get_pose(world_, body, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads the position of the origin as the sum of two floats: the high part is within rounding that of
	/// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in double
	/// is more precise; so is a difference of two bodies, taken high from high and low from low, in floats.
	Result<std::tuple<cn_vec2, cn_vec2>> body_get_position_parts(Body body) const
	{
		cn_vec2 out_high_m{};
		cn_vec2 out_low_m{};
		cn_result code = cn_body_get_position_parts(world_, body, &out_high_m, &out_low_m);
		return { Status(code, nullptr), { std::move(out_high_m), std::move(out_low_m) } };
	}

	/// Reads the angle in radians, in (-pi, pi].
	Result<float> body_get_angle(Body body) const
	{
		float out_rad{};
		cn_result code = cn_body_get_angle(world_, body, &out_rad);
		return { Status(code, nullptr), std::move(out_rad) };
	}

	/// Reads the world position of the centre of mass, in metres.
	Result<cn_vec2> body_get_center(Body body) const
	{
		cn_vec2 out_m{};
		cn_result code = cn_body_get_center(world_, body, &out_m);
		return { Status(code, nullptr), std::move(out_m) };
	}

	/// Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
	/// CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.
	Status body_set_velocity(Body body, float linear_x_mps, float linear_y_mps, float angular_radps)
	{
		return Status(cn_body_set_velocity(world_, body, linear_x_mps, linear_y_mps, angular_radps), world_);
	}

	/// Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).
	Result<cn_velocity> body_get_velocity(Body body) const
	{
		cn_velocity out_out{};
		cn_result code = cn_body_get_velocity(world_, body, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes
	/// it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike
	/// after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this before every
	/// step, or stop the body after it.
	Status body_set_target_pose(Body body, float position_x_m, float position_y_m, float angle_rad, float dt_s)
	{
		return Status(cn_body_set_target_pose(world_, body, position_x_m, position_y_m, angle_rad, dt_s), world_);
	}

	/// Velocity in m/s of the body's material at a world point in metres.
	Result<cn_vec2> body_get_velocity_at(Body body, float point_x_m, float point_y_m) const
	{
		cn_vec2 out_mps{};
		cn_result code = cn_body_get_velocity_at(world_, body, point_x_m, point_y_m, &out_mps);
		return { Status(code, nullptr), std::move(out_mps) };
	}

	/// World position of a point given in the body's frame, both in metres.
	Result<cn_vec2> body_get_world_point(Body body, float local_x_m, float local_y_m) const
	{
		cn_vec2 out_m{};
		cn_result code = cn_body_get_world_point(world_, body, local_x_m, local_y_m, &out_m);
		return { Status(code, nullptr), std::move(out_m) };
	}

	/// Position in the body's frame of a world point, both in metres.
	Result<cn_vec2> body_get_local_point(Body body, float world_x_m, float world_y_m) const
	{
		cn_vec2 out_m{};
		cn_result code = cn_body_get_local_point(world_, body, world_x_m, world_y_m, &out_m);
		return { Status(code, nullptr), std::move(out_m) };
	}

	/// Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
	/// O(shapes).
	Result<cn_aabb> body_get_aabb(Body body) const
	{
		cn_aabb out_out{};
		cn_result code = cn_body_get_aabb(world_, body, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic
	/// and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.
	Status body_apply_force(Body body, float force_x_N, float force_y_N)
	{
		return Status(cn_body_apply_force(world_, body, force_x_N, force_y_N), world_);
	}

	/// Adds a force in newtons at a world point in metres, hence a torque too; otherwise as cn_body_apply_force.
	Status body_apply_force_at(Body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m)
	{
		return Status(cn_body_apply_force_at(world_, body, force_x_N, force_y_N, point_x_m, point_y_m), world_);
	}

	/// Adds a torque in newton metres; otherwise as cn_body_apply_force.
	Status body_apply_torque(Body body, float torque_Nm)
	{
		return Status(cn_body_apply_torque(world_, body, torque_Nm), world_);
	}

	/// Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
	/// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity overflows.
	Status body_apply_impulse(Body body, float impulse_x_Ns, float impulse_y_Ns)
	{
		return Status(cn_body_apply_impulse(world_, body, impulse_x_Ns, impulse_y_Ns), world_);
	}

	/// Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too;
	/// otherwise as cn_body_apply_impulse.
	Status body_apply_impulse_at(Body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m)
	{
		return Status(cn_body_apply_impulse_at(world_, body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m), world_);
	}

	/// Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
	/// cn_body_apply_impulse.
	Status body_apply_angular_impulse(Body body, float impulse_Nms)
	{
		return Status(cn_body_apply_angular_impulse(world_, body, impulse_Nms), world_);
	}

	/// Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
	/// shapes have no mass weighs 1 kg; without shapes it does not rotate.
	Result<cn_mass_data> body_get_mass_data(Body body) const
	{
		cn_mass_data out_out{};
		cn_result code = cn_body_get_mass_data(world_, body, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
	/// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes
	/// the body.
	Status body_set_mass_data(Body body, const cn_mass_data &mass)
	{
		return Status(cn_body_set_mass_data(world_, body, &mass), world_);
	}

	/// Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).
	Status body_reset_mass_data(Body body)
	{
		return Status(cn_body_reset_mass_data(world_, body), world_);
	}

	/// Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.
	Status body_set_damping(Body body, float linear_per_s, float angular_per_s)
	{
		return Status(cn_body_set_damping(world_, body, linear_per_s, angular_per_s), world_);
	}

	/// Reads the linear and angular damping in 1/s.
	Result<std::tuple<float, float>> body_get_damping(Body body) const
	{
		float out_linear_per_s{};
		float out_angular_per_s{};
		cn_result code = cn_body_get_damping(world_, body, &out_linear_per_s, &out_angular_per_s);
		return { Status(code, nullptr), { std::move(out_linear_per_s), std::move(out_angular_per_s) } };
	}

	/// Sets the factor on gravity for this body, finite. A change wakes the body.
	Status body_set_gravity_scale(Body body, float scale)
	{
		return Status(cn_body_set_gravity_scale(world_, body, scale), world_);
	}

	/// Reads the factor on gravity.
	Result<float> body_get_gravity_scale(Body body) const
	{
		float out_scale{};
		cn_result code = cn_body_get_gravity_scale(world_, body, &out_scale);
		return { Status(code, nullptr), std::move(out_scale) };
	}

	/// Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.
	Status body_set_sleep_speed(Body body, float speed_mps)
	{
		return Status(cn_body_set_sleep_speed(world_, body, speed_mps), world_);
	}

	/// Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
	/// (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other bodies
	/// ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and within the
	/// work_budget. Takes effect with the next step; does not wake.
	Status body_set_solver(Body body, int32_t solver)
	{
		return Status(cn_body_set_solver(world_, body, solver), world_);
	}

	/// Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
	Result<int32_t> body_get_solver(Body body) const
	{
		int32_t out_solver{};
		cn_result code = cn_body_get_solver(world_, body, &out_solver);
		return { Status(code, nullptr), std::move(out_solver) };
	}

	/// Stores a number for the user.
	Status body_set_user_data(Body body, uint64_t user_data)
	{
		return Status(cn_body_set_user_data(world_, body, user_data), world_);
	}

	/// Reads the user's number.
	Result<uint64_t> body_get_user_data(Body body) const
	{
		uint64_t out_user_data{};
		cn_result code = cn_body_get_user_data(world_, body, &out_user_data);
		return { Status(code, nullptr), std::move(out_user_data) };
	}

	/// Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
	/// O(length).
	Status body_set_name(Body body, const char *name)
	{
		return Status(cn_body_set_name(world_, body, name), world_);
	}

	/// Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.
	Result<const char *> body_get_name(Body body) const
	{
		const char *name = "";
		cn_result code = cn_body_get_name(world_, body, &name);
		return { Status(code, nullptr), std::move(name) };
	}

	/// Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).
	Result<std::vector<cn_shape>> body_get_shapes(Body body) const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_body_get_shapes(world_, body, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_body_get_shapes(world_, body, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Handles of the body's joints without constraints; out, capacity and *out_count as in cn_world_get_bodies.
	/// O(joints).
	Result<std::vector<cn_joint>> body_get_joints(Body body) const
	{
		std::vector<cn_joint> list;
		int32_t count = 0;
		cn_result code = cn_body_get_joints(world_, body, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_body_get_joints(world_, body, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be
	/// their number. One bad handle fails the whole call. O(count).
	Status read_poses(Slice<const cn_body> bodies, Slice<cn_pose> out) const
	{
		if (bodies.data() != nullptr && bodies.size() != out.size())
			return { CN_ERROR_ARGUMENT, nullptr };
		return Status(cn_world_read_poses(world_, bodies.data(), static_cast<int32_t>(out.size()), out.data()), nullptr);
	}

	/// Reads count velocities; bodies and count as in cn_world_read_poses. O(count).
	Status read_velocities(Slice<const cn_body> bodies, Slice<cn_velocity> out) const
	{
		if (bodies.data() != nullptr && bodies.size() != out.size())
			return { CN_ERROR_ARGUMENT, nullptr };
		return Status(cn_world_read_velocities(world_, bodies.data(), static_cast<int32_t>(out.size()), out.data()), nullptr);
	}

	/// Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
	/// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).
	Status write_velocities(Slice<const cn_body> bodies, Slice<const cn_velocity> velocities)
	{
		if (bodies.data() != nullptr && bodies.size() != velocities.size())
			return { CN_ERROR_ARGUMENT, nullptr };
		return Status(cn_world_write_velocities(world_, bodies.data(), static_cast<int32_t>(velocities.size()), velocities.data()), world_);
	}

	/// Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The
	/// first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.
	Result<Slice<const cn_body_moved>> moved()
	{
		const cn_body_moved *data = nullptr;
		int32_t count = 0;
		cn_result code = cn_world_moved(world_, &data, &count);
		return { Status(code, world_), Slice<const cn_body_moved>(data, static_cast<std::size_t>(count)) };
	}

	/// Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.
	Result<Shape> shape_create_circle(const cn_shape_def &def, const cn_circle &circle)
	{
		cn_shape out_shape{};
		cn_result code = cn_shape_create_circle(world_, &def, &circle, &out_shape);
		return { Status(code, world_), Shape(out_shape) };
	}

	/// Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body. out_shape
	/// may be NULL.
	Result<Shape> shape_create_capsule(const cn_shape_def &def, const cn_capsule &capsule)
	{
		cn_shape out_shape{};
		cn_result code = cn_shape_create_capsule(world_, &def, &capsule, &out_shape);
		return { Status(code, world_), Shape(out_shape) };
	}

	/// Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.
	Result<Shape> shape_create_edge(const cn_shape_def &def, const cn_edge &edge)
	{
		cn_shape out_shape{};
		cn_result code = cn_shape_create_edge(world_, &def, &edge, &out_shape);
		return { Status(code, world_), Shape(out_shape) };
	}

	/// Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
	/// out_shape may be NULL.
	Result<Shape> shape_create_polygon(const cn_shape_def &def, const cn_polygon &polygon)
	{
		cn_shape out_shape{};
		cn_result code = cn_shape_create_polygon(world_, &def, &polygon, &out_shape);
		return { Status(code, world_), Shape(out_shape) };
	}

	/// Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body. out_shape
	/// may be NULL.
	Result<Shape> shape_create_box(const cn_shape_def &def, float half_width_m, float half_height_m, float radius_m)
	{
		cn_shape out_shape{};
		cn_result code = cn_shape_create_box(world_, &def, half_width_m, half_height_m, radius_m, &out_shape);
		return { Status(code, world_), Shape(out_shape) };
	}

	/// Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape
	/// may be NULL. O(count).
	Result<Shape> shape_create_chain(const cn_shape_def &def, const cn_chain &chain)
	{
		cn_shape out_shape{};
		cn_result code = cn_shape_create_chain(world_, &def, &chain, &out_shape);
		return { Status(code, world_), Shape(out_shape) };
	}

	/// Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one.
	/// CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).
	Status shape_attach(Shape shape, Body body)
	{
		return Status(cn_shape_attach(world_, shape, body), world_);
	}

	/// Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body.
	/// O(contacts + shapes of the body).
	Status shape_detach(Shape shape)
	{
		return Status(cn_shape_detach(world_, shape), world_);
	}

	/// Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).
	Status shape_destroy(Shape shape)
	{
		return Status(cn_shape_destroy(world_, shape), world_);
	}

	/// 1 if the handle names a living shape of this world, else 0 (also for a NULL world).
	bool shape_is_valid(Shape shape) const noexcept
	{
		return cn_shape_is_valid(world_, shape) != 0;
	}

	/// Reads the type (CN_SHAPE_CIRCLE to _CHAIN).
	Result<int32_t> shape_get_type(Shape shape) const
	{
		int32_t out_type{};
		cn_result code = cn_shape_get_type(world_, shape, &out_type);
		return { Status(code, nullptr), std::move(out_type) };
	}

	/// Reads the body; 0 if unattached.
	Result<Body> shape_get_body(Shape shape) const
	{
		cn_body out_body{};
		cn_result code = cn_shape_get_body(world_, shape, &out_body);
		return { Status(code, nullptr), Body(out_body) };
	}

	/// Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
	/// body).
	Status shape_set_material(Shape shape, const cn_material &material)
	{
		return Status(cn_shape_set_material(world_, shape, &material), world_);
	}

	/// Reads the material.
	Result<cn_material> shape_get_material(Shape shape) const
	{
		cn_material out_out{};
		cn_result code = cn_shape_get_material(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and wakes
	/// the body. O(shapes of the body).
	Status shape_set_density(Shape shape, float density_kgpm2)
	{
		return Status(cn_shape_set_density(world_, shape, density_kgpm2), world_);
	}

	/// Reads the density in kg/m^2.
	Result<float> shape_get_density(Shape shape) const
	{
		float out_kgpm2{};
		cn_result code = cn_shape_get_density(world_, shape, &out_kgpm2);
		return { Status(code, nullptr), std::move(out_kgpm2) };
	}

	/// Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
	/// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
	Status shape_set_filter(Shape shape, const cn_filter &filter)
	{
		return Status(cn_shape_set_filter(world_, shape, &filter), world_);
	}

	/// Reads the filter.
	Result<cn_filter> shape_get_filter(Shape shape) const
	{
		cn_filter out_out{};
		cn_result code = cn_shape_get_filter(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts of
	/// the body).
	Status shape_set_event_mask(Shape shape, uint32_t event_mask)
	{
		return Status(cn_shape_set_event_mask(world_, shape, event_mask), world_);
	}

	/// Reads the event mask.
	Result<uint32_t> shape_get_event_mask(Shape shape) const
	{
		uint32_t out_event_mask{};
		cn_result code = cn_shape_get_event_mask(world_, shape, &out_event_mask);
		return { Status(code, nullptr), std::move(out_event_mask) };
	}

	/// Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next
	/// step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
	Status shape_set_flags(Shape shape, uint32_t flags)
	{
		return Status(cn_shape_set_flags(world_, shape, flags), world_);
	}

	/// Reads the CN_SHAPE_ flags.
	Result<uint32_t> shape_get_flags(Shape shape) const
	{
		uint32_t out_flags{};
		cn_result code = cn_shape_get_flags(world_, shape, &out_flags);
		return { Status(code, nullptr), std::move(out_flags) };
	}

	/// Stores a number for the user.
	Status shape_set_user_data(Shape shape, uint64_t user_data)
	{
		return Status(cn_shape_set_user_data(world_, shape, user_data), world_);
	}

	/// Reads the user's number.
	Result<uint64_t> shape_get_user_data(Shape shape) const
	{
		uint64_t out_user_data{};
		cn_result code = cn_shape_get_user_data(world_, shape, &out_user_data);
		return { Status(code, nullptr), std::move(out_user_data) };
	}

	/// AABB without margin, in the world (in the shape's own space when unattached). O(points).
	Result<cn_aabb> shape_get_aabb(Shape shape) const
	{
		cn_aabb out_out{};
		cn_result code = cn_shape_get_aabb(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Mass at the present density, centre in the body's frame, inertia about the shape's own centre. O(points).
	Result<cn_mass_data> shape_get_mass_data(Shape shape) const
	{
		cn_mass_data out_out{};
		cn_result code = cn_shape_get_mass_data(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.
	Result<cn_circle> shape_get_circle(Shape shape) const
	{
		cn_circle out_out{};
		cn_result code = cn_shape_get_circle(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.
	Result<cn_capsule> shape_get_capsule(Shape shape) const
	{
		cn_capsule out_out{};
		cn_result code = cn_shape_get_capsule(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.
	Result<cn_edge> shape_get_edge(Shape shape) const
	{
		cn_edge out_out{};
		cn_result code = cn_shape_get_edge(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.
	Result<cn_polygon> shape_get_polygon(Shape shape) const
	{
		cn_polygon out_out{};
		cn_result code = cn_shape_get_polygon(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
	/// NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points written).
	Result<std::vector<cn_vec2>> shape_get_chain_points(Shape shape) const
	{
		std::vector<cn_vec2> list;
		int32_t count = 0;
		cn_result code = cn_shape_get_chain_points(world_, shape, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_shape_get_chain_points(world_, shape, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks of
	/// creation: the handle and all other properties stay. Mass and box are those of the new geometry at once;
	/// contacts stay unless the boxes no longer overlap, and the next step computes them anew, without the
	/// impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box meets. A
	/// shape that grows into others is pushed out of them at push_speed_max_mps at most. CN_ERROR_STATE for
	/// another type. O(contacts + shapes of the body).
	Status shape_set_circle(Shape shape, const cn_circle &circle)
	{
		return Status(cn_shape_set_circle(world_, shape, &circle), world_);
	}

	/// Replaces a capsule in place; otherwise as cn_shape_set_circle.
	Status shape_set_capsule(Shape shape, const cn_capsule &capsule)
	{
		return Status(cn_shape_set_capsule(world_, shape, &capsule), world_);
	}

	/// Replaces an edge in place; otherwise as cn_shape_set_circle.
	Status shape_set_edge(Shape shape, const cn_edge &edge)
	{
		return Status(cn_shape_set_edge(world_, shape, &edge), world_);
	}

	/// Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.
	Status shape_set_polygon(Shape shape, const cn_polygon &polygon)
	{
		return Status(cn_shape_set_polygon(world_, shape, &polygon), world_);
	}

	/// Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
	/// begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body + count).
	Status shape_set_chain(Shape shape, const cn_chain &chain)
	{
		return Status(cn_shape_set_chain(world_, shape, &chain), world_);
	}

	/// out_inside is 1 if the shape contains a world point in metres (in the shape's own space when unattached),
	/// else 0. Edges and chains contain no point. O(points).
	Result<int32_t> shape_test_point(Shape shape, float point_x_m, float point_y_m) const
	{
		int32_t out_inside{};
		cn_result code = cn_shape_test_point(world_, shape, point_x_m, point_y_m, &out_inside);
		return { Status(code, nullptr), std::move(out_inside) };
	}

	/// The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
	/// for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
	/// inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
	/// apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
	/// pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
	/// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of the
	/// step, and got an impulse; bodies that pass a blow on to others that already touch them, without closing,
	/// have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which they begin),
	/// STAY or HIT.
	Result<Slice<const cn_contact_event>> contact_events(int32_t kind)
	{
		const cn_contact_event *data = nullptr;
		int32_t count = 0;
		cn_result code = cn_world_contact_events(world_, kind, &data, &count);
		return { Status(code, world_), Slice<const cn_contact_event>(data, static_cast<std::size_t>(count)) };
	}

	/// The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
	/// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
	/// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or chains.
	/// A pair without an awake body reports nothing until one wakes.
	Result<Slice<const cn_sensor_event>> sensor_events() const
	{
		const cn_sensor_event *data = nullptr;
		int32_t count = 0;
		cn_result code = cn_world_sensor_events(world_, &data, &count);
		return { Status(code, nullptr), Slice<const cn_sensor_event>(data, static_cast<std::size_t>(count)) };
	}

	/// The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
	/// sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
	/// impulses of the last substep. At rest their force is that of the points times substep_count (with
	/// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0.
	/// *out_count is their number. O(contacts).
	Result<std::vector<cn_contact_event>> body_get_contacts(Body body) const
	{
		std::vector<cn_contact_event> list;
		int32_t count = 0;
		cn_result code = cn_body_get_contacts(world_, body, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_body_get_contacts(world_, body, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
	/// cn_body_get_contacts. O(contacts of its body).
	Result<std::vector<cn_contact_event>> shape_get_contacts(Shape shape) const
	{
		std::vector<cn_contact_event> list;
		int32_t count = 0;
		cn_result code = cn_shape_get_contacts(world_, shape, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_shape_get_contacts(world_, shape, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
	/// and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of its
	/// body), squared for chains.
	Result<std::vector<cn_shape>> shape_get_visitors(Shape sensor) const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_shape_get_visitors(world_, sensor, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_shape_get_visitors(world_, sensor, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
	/// destroyed since are stale.
	Result<Slice<const cn_body>> fell_asleep() const
	{
		const cn_body *data = nullptr;
		int32_t count = 0;
		cn_result code = cn_world_fell_asleep(world_, &data, &count);
		return { Status(code, nullptr), Slice<const cn_body>(data, static_cast<std::size_t>(count)) };
	}

	/// Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
	/// is dynamic. O(contacts of body_a).
	Result<Joint> joint_create_revolute(const cn_revolute_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_revolute(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
	/// is dynamic. O(contacts of body_a).
	Result<Joint> joint_create_distance(const cn_distance_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_distance(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_fixed(const cn_fixed_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_fixed(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
	/// is dynamic. O(contacts of body_a).
	Result<Joint> joint_create_prismatic(const cn_prismatic_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_prismatic(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_wheel(const cn_wheel_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_wheel(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_motor(const cn_motor_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_motor(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic, or body_a is not 0. O(contacts of body_a).
	Result<Joint> joint_create_mouse(const cn_mouse_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_mouse(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_gear(const cn_gear_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_gear(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_pulley(const cn_pulley_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_pulley(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_ratchet(const cn_ratchet_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_ratchet(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic. O(contacts of body_a).
	Result<Joint> joint_create_rotary_spring(const cn_rotary_spring_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_rotary_spring(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	/// dynamic, or the slot has no length. O(contacts of body_a).
	Result<Joint> joint_create_groove(const cn_groove_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_groove(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
	/// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
	/// body_a).
	Result<Joint> joint_create_filter(const cn_filter_joint_def &def)
	{
		cn_joint out_joint{};
		cn_result code = cn_joint_create_filter(world_, &def, &out_joint);
		return { Status(code, world_), Joint(out_joint) };
	}

	/// Destroys a joint and wakes its bodies. No event is reported.
	Status joint_destroy(Joint joint)
	{
		return Status(cn_joint_destroy(world_, joint), world_);
	}

	/// 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).
	bool joint_is_valid(Joint joint) const noexcept
	{
		return cn_joint_is_valid(world_, joint) != 0;
	}

	/// Reads the type (CN_JOINT_REVOLUTE to _FILTER).
	Result<int32_t> joint_get_type(Joint joint) const
	{
		int32_t out_type{};
		cn_result code = cn_joint_get_type(world_, joint, &out_type);
		return { Status(code, nullptr), std::move(out_type) };
	}

	/// Reads both bodies; 0 stands for the world.
	Result<std::tuple<Body, Body>> joint_get_bodies(Joint joint) const
	{
		cn_body out_a{};
		cn_body out_b{};
		cn_result code = cn_joint_get_bodies(world_, joint, &out_a, &out_b);
		return { Status(code, nullptr), { Body(out_a), Body(out_b) } };
	}

	/// Reads the world positions of both anchors, in metres.
	Result<std::tuple<cn_vec2, cn_vec2>> joint_get_anchors(Joint joint) const
	{
		cn_vec2 out_world_a_m{};
		cn_vec2 out_world_b_m{};
		cn_result code = cn_joint_get_anchors(world_, joint, &out_world_a_m, &out_world_b_m);
		return { Status(code, nullptr), { std::move(out_world_a_m), std::move(out_world_b_m) } };
	}

	/// Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
	/// after a change of type or of CN_BODY_ENABLED of one of its bodies.
	Result<std::tuple<cn_vec2, float>> joint_get_reaction(Joint joint) const
	{
		cn_vec2 out_force_N{};
		float out_torque_Nm{};
		cn_result code = cn_joint_get_reaction(world_, joint, &out_force_N, &out_torque_Nm);
		return { Status(code, nullptr), { std::move(out_force_N), std::move(out_torque_Nm) } };
	}

	/// Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
	/// (angles beyond limits).
	Result<std::tuple<float, float>> joint_get_error(Joint joint) const
	{
		float out_m{};
		float out_rad{};
		cn_result code = cn_joint_get_error(world_, joint, &out_m, &out_rad);
		return { Status(code, nullptr), { std::move(out_m), std::move(out_rad) } };
	}

	/// Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
	/// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
	/// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a
	/// world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step;
	/// does not wake.
	Status joint_set_solver(Joint joint, int32_t solver)
	{
		return Status(cn_joint_set_solver(world_, joint, solver), world_);
	}

	/// Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
	Result<int32_t> joint_get_solver(Joint joint) const
	{
		int32_t out_solver{};
		cn_result code = cn_joint_get_solver(world_, joint, &out_solver);
		return { Status(code, nullptr), std::move(out_solver) };
	}

	/// Stores a number for the user.
	Status joint_set_user_data(Joint joint, uint64_t user_data)
	{
		return Status(cn_joint_set_user_data(world_, joint, user_data), world_);
	}

	/// Reads the user's number.
	Result<uint64_t> joint_get_user_data(Joint joint) const
	{
		uint64_t out_user_data{};
		cn_result code = cn_joint_get_user_data(world_, joint, &out_user_data);
		return { Status(code, nullptr), std::move(out_user_data) };
	}

	/// Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	Status joint_set_flags(Joint joint, uint32_t flags)
	{
		return Status(cn_joint_set_flags(world_, joint, flags), world_);
	}

	/// Reads the CN_JOINT_ flags.
	Result<uint32_t> joint_get_flags(Joint joint) const
	{
		uint32_t out_flags{};
		cn_result code = cn_joint_get_flags(world_, joint, &out_flags);
		return { Status(code, nullptr), std::move(out_flags) };
	}

	/// Reads the definition of a revolute joint. CN_ERROR_STATE for another type.
	Result<cn_revolute_def> joint_get_revolute(Joint joint) const
	{
		cn_revolute_def out_out{};
		cn_result code = cn_joint_get_revolute(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_revolute(Joint joint, const cn_revolute_def &def)
	{
		return Status(cn_joint_set_revolute(world_, joint, &def), world_);
	}

	/// Reads the definition of a distance joint. CN_ERROR_STATE for another type.
	Result<cn_distance_def> joint_get_distance(Joint joint) const
	{
		cn_distance_def out_out{};
		cn_result code = cn_joint_get_distance(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_distance(Joint joint, const cn_distance_def &def)
	{
		return Status(cn_joint_set_distance(world_, joint, &def), world_);
	}

	/// Reads the definition of a fixed joint. CN_ERROR_STATE for another type.
	Result<cn_fixed_def> joint_get_fixed(Joint joint) const
	{
		cn_fixed_def out_out{};
		cn_result code = cn_joint_get_fixed(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_fixed(Joint joint, const cn_fixed_def &def)
	{
		return Status(cn_joint_set_fixed(world_, joint, &def), world_);
	}

	/// Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.
	Result<cn_prismatic_def> joint_get_prismatic(Joint joint) const
	{
		cn_prismatic_def out_out{};
		cn_result code = cn_joint_get_prismatic(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_prismatic(Joint joint, const cn_prismatic_def &def)
	{
		return Status(cn_joint_set_prismatic(world_, joint, &def), world_);
	}

	/// Reads the definition of a wheel joint. CN_ERROR_STATE for another type.
	Result<cn_wheel_def> joint_get_wheel(Joint joint) const
	{
		cn_wheel_def out_out{};
		cn_result code = cn_joint_get_wheel(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_wheel(Joint joint, const cn_wheel_def &def)
	{
		return Status(cn_joint_set_wheel(world_, joint, &def), world_);
	}

	/// Reads the definition of a motor joint. CN_ERROR_STATE for another type.
	Result<cn_motor_def> joint_get_motor_to(Joint joint) const
	{
		cn_motor_def out_out{};
		cn_result code = cn_joint_get_motor_to(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_motor_to(Joint joint, const cn_motor_def &def)
	{
		return Status(cn_joint_set_motor_to(world_, joint, &def), world_);
	}

	/// Reads the definition of a mouse joint. CN_ERROR_STATE for another type.
	Result<cn_mouse_def> joint_get_mouse(Joint joint) const
	{
		cn_mouse_def out_out{};
		cn_result code = cn_joint_get_mouse(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
	/// CN_JOINT_COLLIDE changes.
	Status joint_set_mouse(Joint joint, const cn_mouse_def &def)
	{
		return Status(cn_joint_set_mouse(world_, joint, &def), world_);
	}

	/// Reads the definition of a gear joint. CN_ERROR_STATE for another type.
	Result<cn_gear_def> joint_get_gear(Joint joint) const
	{
		cn_gear_def out_out{};
		cn_result code = cn_joint_get_gear(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
	/// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	Status joint_set_gear(Joint joint, const cn_gear_def &def)
	{
		return Status(cn_joint_set_gear(world_, joint, &def), world_);
	}

	/// Reads the definition of a pulley joint. CN_ERROR_STATE for another type.
	Result<cn_pulley_def> joint_get_pulley(Joint joint) const
	{
		cn_pulley_def out_out{};
		cn_result code = cn_joint_get_pulley(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_pulley(Joint joint, const cn_pulley_def &def)
	{
		return Status(cn_joint_set_pulley(world_, joint, &def), world_);
	}

	/// Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.
	Result<cn_ratchet_def> joint_get_ratchet(Joint joint) const
	{
		cn_ratchet_def out_out{};
		cn_result code = cn_joint_get_ratchet(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both
	/// bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	Status joint_set_ratchet(Joint joint, const cn_ratchet_def &def)
	{
		return Status(cn_joint_set_ratchet(world_, joint, &def), world_);
	}

	/// Reads the definition of a rotary spring. CN_ERROR_STATE for another type.
	Result<cn_rotary_spring_def> joint_get_rotary_spring(Joint joint) const
	{
		cn_rotary_spring_def out_out{};
		cn_result code = cn_joint_get_rotary_spring(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_rotary_spring(Joint joint, const cn_rotary_spring_def &def)
	{
		return Status(cn_joint_set_rotary_spring(world_, joint, &def), world_);
	}

	/// Reads the definition of a groove joint. CN_ERROR_STATE for another type.
	Result<cn_groove_def> joint_get_groove(Joint joint) const
	{
		cn_groove_def out_out{};
		cn_result code = cn_joint_get_groove(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
	/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
	/// changes.
	Status joint_set_groove(Joint joint, const cn_groove_def &def)
	{
		return Status(cn_joint_set_groove(world_, joint, &def), world_);
	}

	/// Reads the base of a joint of any type.
	Result<cn_joint_base> joint_get_base(Joint joint) const
	{
		cn_joint_base out_out{};
		cn_result code = cn_joint_get_base(world_, joint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as
	/// in cn_joint_base. Wakes both bodies.
	Status joint_set_base(Joint joint, const cn_joint_base &base)
	{
		return Status(cn_joint_set_base(world_, joint, &base), world_);
	}

	/// Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE
	/// for another type. Wakes the body.
	Status joint_set_target(Joint joint, float target_x_m, float target_y_m)
	{
		return Status(cn_joint_set_target(world_, joint, target_x_m, target_y_m), world_);
	}

	/// Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
	/// reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the translation
	/// along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet, rotary
	/// spring: angle b - angle a; these three over whole turns.
	Result<float> joint_get_position(Joint joint) const
	{
		float out_position{};
		cn_result code = cn_joint_get_position(world_, joint, &out_position);
		return { Status(code, nullptr), std::move(out_position) };
	}

	/// Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A positive
	/// motor speed has the same sign.
	Result<float> joint_get_speed(Joint joint) const
	{
		float out_speed{};
		cn_result code = cn_joint_get_speed(world_, joint, &out_speed);
		return { Status(code, nullptr), std::move(out_speed) };
	}

	/// Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
	/// prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.
	Status joint_set_motor(Joint joint, float speed, float force_or_torque_max)
	{
		return Status(cn_joint_set_motor(world_, joint, speed, force_or_torque_max), world_);
	}

	/// Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0), prismatic
	/// or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.
	Status joint_set_limits(Joint joint, float lower, float upper)
	{
		return Status(cn_joint_set_limits(world_, joint, lower, upper), world_);
	}

	/// Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body
	/// in that step or between it and the step before.
	Result<Slice<const cn_joint_event>> joint_events() const
	{
		const cn_joint_event *data = nullptr;
		int32_t count = 0;
		cn_result code = cn_world_joint_events(world_, &data, &count);
		return { Status(code, nullptr), Slice<const cn_joint_event>(data, static_cast<std::size_t>(count)) };
	}

	/// Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
	/// not dynamic. Wakes the body.
	Result<Constraint> constraint_create_angle(const cn_angle_constraint_def &def)
	{
		cn_constraint out_constraint{};
		cn_result code = cn_constraint_create_angle(world_, &def, &out_constraint);
		return { Status(code, world_), Constraint(out_constraint) };
	}

	/// Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
	/// dynamic. Wakes the body.
	Result<Constraint> constraint_create_line(const cn_line_constraint_def &def)
	{
		cn_constraint out_constraint{};
		cn_result code = cn_constraint_create_line(world_, &def, &out_constraint);
		return { Status(code, world_), Constraint(out_constraint) };
	}

	/// Destroys a constraint and wakes its body. No event is reported.
	Status constraint_destroy(Constraint constraint)
	{
		return Status(cn_constraint_destroy(world_, constraint), world_);
	}

	/// 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).
	bool constraint_is_valid(Constraint constraint) const noexcept
	{
		return cn_constraint_is_valid(world_, constraint) != 0;
	}

	/// Reads the type (CN_CONSTRAINT_ANGLE or _LINE).
	Result<int32_t> constraint_get_type(Constraint constraint) const
	{
		int32_t out_type{};
		cn_result code = cn_constraint_get_type(world_, constraint, &out_type);
		return { Status(code, nullptr), std::move(out_type) };
	}

	/// Reads the body.
	Result<Body> constraint_get_body(Constraint constraint) const
	{
		cn_body out_body{};
		cn_result code = cn_constraint_get_body(world_, constraint, &out_body);
		return { Status(code, nullptr), Body(out_body) };
	}

	/// Reads the definition of an angle constraint. CN_ERROR_STATE for another type.
	Result<cn_angle_constraint_def> constraint_get_angle(Constraint constraint) const
	{
		cn_angle_constraint_def out_out{};
		cn_result code = cn_constraint_get_angle(world_, constraint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
	/// body.
	Status constraint_set_angle(Constraint constraint, const cn_angle_constraint_def &def)
	{
		return Status(cn_constraint_set_angle(world_, constraint, &def), world_);
	}

	/// Reads the definition of a line constraint. CN_ERROR_STATE for another type.
	Result<cn_line_constraint_def> constraint_get_line(Constraint constraint) const
	{
		cn_line_constraint_def out_out{};
		cn_result code = cn_constraint_get_line(world_, constraint, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
	/// body.
	Status constraint_set_line(Constraint constraint, const cn_line_constraint_def &def)
	{
		return Status(cn_constraint_set_line(world_, constraint, &def), world_);
	}

	/// Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
	/// along the axis, in metres from origin.
	Result<float> constraint_get_position(Constraint constraint) const
	{
		float out_position{};
		cn_result code = cn_constraint_get_position(world_, constraint, &out_position);
		return { Status(code, nullptr), std::move(out_position) };
	}

	/// Force in newtons and torque in newton metres that the constraint applied to the body in the last substep.
	Result<std::tuple<cn_vec2, float>> constraint_get_reaction(Constraint constraint) const
	{
		cn_vec2 out_force_N{};
		float out_torque_Nm{};
		cn_result code = cn_constraint_get_reaction(world_, constraint, &out_force_N, &out_torque_Nm);
		return { Status(code, nullptr), { std::move(out_force_N), std::move(out_torque_Nm) } };
	}

	/// Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle constraint.
	Result<std::tuple<float, float>> constraint_get_error(Constraint constraint) const
	{
		float out_m{};
		float out_rad{};
		cn_result code = cn_constraint_get_error(world_, constraint, &out_m, &out_rad);
		return { Status(code, nullptr), { std::move(out_m), std::move(out_rad) } };
	}

	/// Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
	/// O(slots).
	Result<std::vector<cn_constraint>> get_constraints() const
	{
		std::vector<cn_constraint> list;
		int32_t count = 0;
		cn_result code = cn_world_get_constraints(world_, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_get_constraints(world_, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
	/// constraints of the body).
	Result<std::vector<cn_constraint>> body_get_constraints(Body body) const
	{
		std::vector<cn_constraint> list;
		int32_t count = 0;
		cn_result code = cn_body_get_constraints(world_, body, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_body_get_constraints(world_, body, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an
	/// update, 1 to 1000, default 8.
	Status set_fixed_step(float step_s, int32_t steps_max)
	{
		return Status(cn_world_set_fixed_step(world_, step_s, steps_max), world_);
	}

	/// Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
	/// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.
	Result<cn_update_report> update(float elapsed_s)
	{
		cn_update_report out_out{};
		cn_result code = cn_world_update(world_, elapsed_s, &out_out);
		return { Status(code, world_), std::move(out_out) };
	}

	/// Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step, 1
	/// after it. Bodies that did not take part in the last step have their present pose. bodies and count as in
	/// cn_world_read_poses. O(count).
	Status read_poses_interpolated(Slice<const cn_body> bodies, float factor, Slice<cn_pose> out) const
	{
		if (bodies.data() != nullptr && bodies.size() != out.size())
			return { CN_ERROR_ARGUMENT, nullptr };
		return Status(cn_world_read_poses_interpolated(world_, bodies.data(), static_cast<int32_t>(out.size()), factor, out.data()), nullptr);
	}

	/// Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from
	/// their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child. filter
	/// may be NULL: the defaults. O(log shapes) to O(shapes along the ray).
	Result<cn_ray_hit> cast_ray(const cn_ray &ray, const cn_query_filter *filter) const
	{
		cn_ray_hit out_out{};
		cn_result code = cn_world_cast_ray(world_, &ray, filter, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log
	/// shapes) to O(shapes along the ray).
	Result<int32_t> cast_ray_any(const cn_ray &ray, const cn_query_filter *filter) const
	{
		int32_t out_hit{};
		cn_result code = cn_world_cast_ray_any(world_, &ray, filter, &out_hit);
		return { Status(code, nullptr), std::move(out_hit) };
	}

	/// Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found. A
	/// chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).
	Result<std::vector<cn_ray_hit>> cast_ray_all(const cn_ray &ray, const cn_query_filter *filter) const
	{
		std::vector<cn_ray_hit> list;
		int32_t count = 0;
		cn_result code = cn_world_cast_ray_all(world_, &ray, filter, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_cast_ray_all(world_, &ray, filter, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call. filter
	/// may be NULL. O(sum of the rays).
	Status cast_rays(Slice<const cn_ray> rays, const cn_query_filter *filter, Slice<cn_ray_hit> out) const
	{
		if (rays.size() != out.size())
			return { CN_ERROR_ARGUMENT, nullptr };
		return Status(cn_world_cast_rays(world_, rays.data(), static_cast<int32_t>(out.size()), filter, out.data()), nullptr);
	}

	/// Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
	/// O(points of the shape).
	Result<cn_ray_hit> shape_cast_ray(Shape shape, const cn_ray &ray) const
	{
		cn_ray_hit out_out{};
		cn_result code = cn_shape_cast_ray(world_, shape, &ray, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
	/// way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or 2:
	/// circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the
	/// moving points is in front of it. filter may be NULL. O(shapes along the way).
	Result<cn_ray_hit> cast_shape(const cn_polygon &shape, float translation_x_m, float translation_y_m, const cn_query_filter *filter) const
	{
		cn_ray_hit out_out{};
		cn_result code = cn_world_cast_shape(world_, &shape, translation_x_m, translation_y_m, filter, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
	/// cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found.
	/// filter may be NULL. O(log shapes) to O(boxes in the region).
	Result<std::vector<cn_shape>> overlap_aabb(const cn_aabb &box, const cn_query_filter *filter) const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_world_overlap_aabb(world_, &box, filter, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_overlap_aabb(world_, &box, filter, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb. Edges
	/// and chains are lines here, seen from both sides.
	Result<std::vector<cn_shape>> overlap_circle(const cn_circle &circle, const cn_query_filter *filter) const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_world_overlap_circle(world_, &circle, filter, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_overlap_circle(world_, &circle, filter, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as in
	/// cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
	Result<std::vector<cn_shape>> overlap_polygon(const cn_polygon &polygon, const cn_query_filter *filter) const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_world_overlap_polygon(world_, &polygon, filter, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_overlap_polygon(world_, &polygon, filter, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Shapes that contain a world point in metres; order, capacity, filter and cost as in
	/// cn_world_overlap_aabb. Edges and chains contain no point.
	Result<std::vector<cn_shape>> overlap_point(float x_m, float y_m, const cn_query_filter *filter) const
	{
		std::vector<cn_shape> list;
		int32_t count = 0;
		cn_result code = cn_world_overlap_point(world_, x_m, y_m, filter, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_world_overlap_point(world_, x_m, y_m, filter, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
	/// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.
	Result<cn_closest> closest_point(float x_m, float y_m, float distance_max_m, const cn_query_filter *filter) const
	{
		cn_closest out_out{};
		cn_result code = cn_world_closest_point(world_, x_m, y_m, distance_max_m, filter, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved
	/// by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of least
	/// separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way
	/// shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the length unit plus
	/// its rise in the last step. Shapes wholly behind the plane of another shape are left out, so that seams of
	/// tiles do not catch (not if capacity is too small for all). O(shapes nearby, squared).
	Result<std::vector<cn_plane>> mover_collide(const cn_polygon &shape, float position_x_m, float position_y_m, float margin_m, const cn_query_filter *filter) const
	{
		std::vector<cn_plane> list;
		int32_t count = 0;
		cn_result code = cn_mover_collide(world_, &shape, position_x_m, position_y_m, margin_m, filter, nullptr, 0, &count);
		list.resize(static_cast<std::size_t>(count));
		if (code == CN_OK && count > 0)
			code = cn_mover_collide(world_, &shape, position_x_m, position_y_m, margin_m, filter, list.data(), count, &count);
		return { Status(code, nullptr), std::move(list) };
	}

	/// Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step behind
	/// the ground that carries it. 1. carried   by the motion of its ground since the last move: of the point of
	/// ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across up, along the
	/// ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A step up where a
	/// too steep surface blocks it: up by step_height_m, forward, down on walkable ground flying    in the air:
	/// velocity_mps and gravity (exact for constant gravity). Jumping and walking off keep ground_velocity_mps
	/// 3. sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed
	/// passes through a wall 4. pushing   dynamic bodies in the way get a force for the next step that brings
	/// them to the character's velocity, of at most push_force_N each 5. ground    ground that it touches, or
	/// that lies within snap_m below a walking character; velocity_mps loses blocked components The result
	/// depends on the world, def and mover alone: equal calls give equal bits. The loop of planes, solver and
	/// cast is that of Box2D 3's sample of a character mover (Catto, 2025). Pushed bodies wake; nothing else in
	/// the world changes. O(shapes nearby x iterations_max): about 1 us standing, 3 us walking, 10 us against a
	/// wall.
	Status mover_move(const cn_mover_def &def, float dt_s, cn_mover &mover)
	{
		return Status(cn_mover_move(world_, &def, dt_s, &mover), world_);
	}

	/// Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter says
	/// which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an area that
	/// loses the flag later does nothing while it is without. Gravity, and damping without density, act on
	/// bodies whose centre of mass is in the area (on its border too) while one of their shapes touches it: on a
	/// body half in it in full or not at all. The medium acts on the part of each shape that is in the area,
	/// exactly for polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The
	/// surface of a circle or capsule is flat across a body, as of a planet. Shapes of a body do not shade each
	/// other. The area's body feels no reaction. Between steps nothing happens: the acceleration is that in the
	/// middle of the next step (leapfrog), so bodies on orbits and floating bodies keep their energy. Damping
	/// and drag are implicit: stable at any strength, mass and time step, with exact terminal speeds. Bodies
	/// that enter or leave, that are in an area that moves, and those in it now, wake; bodies at rest in it may
	/// sleep. Areas are in saves and files. Floats whose draught is less than about g dt^2 (3 mm at 60 steps a
	/// second) are damped, and carry less under a load. An area takes 64 bytes of the world's memory; a step
	/// takes about 0.15 us for each shape in an area, 0.35 us in a medium. Best on a body of its own: O(contacts
	/// of the body).
	Status shape_set_area(Shape shape, const cn_area_def *def)
	{
		return Status(cn_shape_set_area(world_, shape, def), world_);
	}

	/// Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).
	Result<cn_area_def> shape_get_area(Shape shape) const
	{
		cn_area_def out_out{};
		cn_result code = cn_shape_get_area(world_, shape, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each step.
	/// flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w across it,
	/// with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton (1687), and
	/// across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle between surface and
	/// flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the whole outline, round
	/// parts included, and drag along straight edges also for turning bodies; edges and chains are plates with
	/// two sides. Solved implicitly, so that wind never reverses the motion relative to it, at any speed, mass
	/// and time; a pure drag is the exact solution of m v' = -k v^2. wake 0: sleeping bodies stay asleep and
	/// unchanged; else they wake. Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE for a
	/// shape without a body. O(points).
	Status shape_apply_wind(Shape shape, float flow_x_mps, float flow_y_mps, float drag_kgpm2, float lift_kgpm2, float dt_s, int32_t wake)
	{
		return Status(cn_shape_apply_wind(world_, shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake), world_);
	}

	/// Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
	/// them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).
	Status explode(const cn_explosion_def &def)
	{
		return Status(cn_world_explode(world_, &def), world_);
	}

private:
	cn_world *world_;
};

/// Owns a cn_tree.
class Tree {
public:
	/// An empty tree in memory of malloc.
	static Result<Tree> create(float margin_m)
	{
		cn_tree *out = nullptr;
		cn_result code = cn_tree_create(margin_m, nullptr, nullptr, nullptr, &out);
		return { Status(code, nullptr), Tree(out) };
	}
	explicit Tree(cn_tree *owned) noexcept : tree_(owned) {}
	Tree(Tree &&other) noexcept : tree_(std::exchange(other.tree_, nullptr)) {}
	Tree &operator=(Tree &&other) noexcept
	{
		std::swap(tree_, other.tree_);
		return *this;
	}
	~Tree() { cn_tree_destroy(tree_); }
	/// For functions of cairn.h.
	cn_tree *get() const noexcept { return tree_; }

	/// Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).
	Result<uint32_t> insert(const cn_aabb &box, uint64_t user_data)
	{
		uint32_t out_item{};
		cn_result code = cn_tree_insert(tree_, &box, user_data, &out_item);
		return { Status(code, nullptr), std::move(out_item) };
	}

	/// Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).
	Status remove(uint32_t item)
	{
		return Status(cn_tree_remove(tree_, item), nullptr);
	}

	/// Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n).
	/// CN_ERROR_HANDLE for a stale item.
	Status move(uint32_t item, const cn_aabb &box)
	{
		return Status(cn_tree_move(tree_, item, &box), nullptr);
	}

	/// Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.
	Result<cn_aabb> get_box(uint32_t item) const
	{
		cn_aabb out_out{};
		cn_result code = cn_tree_get_box(tree_, item, &out_out);
		return { Status(code, nullptr), std::move(out_out) };
	}

	/// Reads the number of items and the height of the tree.
	Result<std::tuple<int32_t, int32_t>> get_stats() const
	{
		int32_t out_count{};
		int32_t out_height{};
		cn_result code = cn_tree_get_stats(tree_, &out_count, &out_height);
		return { Status(code, nullptr), { std::move(out_count), std::move(out_height) } };
	}

private:
	cn_tree *tree_;
};

/// Version of the library as major * 1000000 + minor * 1000 + patch.
inline int32_t version() noexcept
{
	return cn_version();
}

/// CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
inline int32_t abi_version() noexcept
{
	return cn_abi_version();
}

/// English text for a result code: static, never NULL.
inline const char *result_text(cn_result result) noexcept
{
	return cn_result_text(result);
}

/// Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).
inline Result<uint64_t> save_delta_size(Slice<const unsigned char> base, Slice<const unsigned char> save)
{
	uint64_t out_bytes{};
	cn_result code = cn_save_delta_size(base.data(), base.size(), save.data(), save.size(), &out_bytes);
	return { Status(code, nullptr), std::move(out_bytes) };
}

/// Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).
inline Result<std::vector<unsigned char>> save_delta(Slice<const unsigned char> base, Slice<const unsigned char> save)
{
	uint64_t bytes = 0;
	std::vector<unsigned char> out;
	cn_result code = cn_save_delta_size(base.data(), base.size(), save.data(), save.size(), &bytes);
	out.resize(static_cast<std::size_t>(bytes));
	if (code == CN_OK)
		code = cn_save_delta(base.data(), base.size(), save.data(), save.size(), out.data(), bytes, &bytes);
	out.resize(static_cast<std::size_t>(bytes));
	return { Status(code, nullptr), std::move(out) };
}

/// Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
/// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
/// CN_ERROR_CAPACITY if out is too small. O(bytes).
inline Result<std::vector<unsigned char>> save_apply(Slice<const unsigned char> base, Slice<const unsigned char> delta)
{
	uint64_t bytes = 0;
	std::vector<unsigned char> out;
	cn_result code = CN_OK;
	bytes = base.size() + delta.size();
	out.resize(static_cast<std::size_t>(bytes));
	if (code == CN_OK)
		code = cn_save_apply(base.data(), base.size(), delta.data(), delta.size(), out.data(), bytes, &bytes);
	out.resize(static_cast<std::size_t>(bytes));
	return { Status(code, nullptr), std::move(out) };
}

/// Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
/// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
/// area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
/// mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
/// O(count^2) at worst.
inline Result<cn_polygon> polygon_make_hull(Slice<const cn_vec2> points_m, float radius_m)
{
	cn_polygon out_out{};
	cn_result code = cn_polygon_make_hull(points_m.data(), static_cast<int32_t>(points_m.size()), radius_m, &out_out);
	return { Status(code, nullptr), std::move(out_out) };
}

/// A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
/// (|angle| <= 1e4); radius_m >= 0.
inline Result<cn_polygon> polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m)
{
	cn_polygon out_out{};
	cn_result code = cn_polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m, &out_out);
	return { Status(code, nullptr), std::move(out_out) };
}

/// Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
/// in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
/// without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
/// Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and pieces
/// thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no
/// area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0.
/// *out_count is the number of all. 34 KB of stack. O(count^2).
inline Result<std::vector<cn_polygon>> outline_decompose(Slice<const cn_vec2> points_m, float length_unit_m)
{
	std::vector<cn_polygon> list;
	int32_t count = 0;
	cn_result code = cn_outline_decompose(points_m.data(), static_cast<int32_t>(points_m.size()), length_unit_m, nullptr, 0, &count);
	list.resize(static_cast<std::size_t>(count));
	if (code == CN_OK && count > 0)
		code = cn_outline_decompose(points_m.data(), static_cast<int32_t>(points_m.size()), length_unit_m, list.data(), count, &count);
	return { Status(code, nullptr), std::move(list) };
}

/// Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
/// tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
/// 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
/// afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be
/// points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst.
inline Result<std::vector<cn_vec2>> outline_simplify(Slice<const cn_vec2> points_m, int32_t closed, float tolerance_m)
{
	std::vector<cn_vec2> list;
	int32_t count = 0;
	cn_result code = cn_outline_simplify(points_m.data(), static_cast<int32_t>(points_m.size()), closed, tolerance_m, nullptr, 0, &count);
	list.resize(static_cast<std::size_t>(count));
	if (code == CN_OK && count > 0)
		code = cn_outline_simplify(points_m.data(), static_cast<int32_t>(points_m.size()), closed, tolerance_m, list.data(), count, &count);
	return { Status(code, nullptr), std::move(list) };
}

/// An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
/// squares of side cell_m > 0 with the lower left corner of the first at the origin. cells[row * columns +
/// column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is
/// 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
/// counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
/// touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points
/// (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a
/// boundary of n edges.
inline Result<std::vector<cn_vec2>> outline_from_cells(Slice<const uint8_t> cells, int32_t columns, float origin_x_m, float origin_y_m, float cell_m, int32_t outline)
{
	std::vector<cn_vec2> list;
	int32_t count = 0;
	cn_result code = cn_outline_from_cells(cells.data(), static_cast<int32_t>(cells.size()), columns, origin_x_m, origin_y_m, cell_m, outline, nullptr, 0, &count);
	list.resize(static_cast<std::size_t>(count));
	if (code == CN_OK && count > 0)
		code = cn_outline_from_cells(cells.data(), static_cast<int32_t>(cells.size()), columns, origin_x_m, origin_y_m, cell_m, outline, list.data(), count, &count);
	return { Status(code, nullptr), std::move(list) };
}

/// The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
/// finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
/// columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at
/// least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
/// another one. cn_outline_simplify removes its collinear points. O(values + n log n).
inline Result<std::vector<cn_vec2>> outline_from_field(Slice<const float> values, int32_t columns, float threshold, float origin_x_m, float origin_y_m, float spacing_m, int32_t outline)
{
	std::vector<cn_vec2> list;
	int32_t count = 0;
	cn_result code = cn_outline_from_field(values.data(), static_cast<int32_t>(values.size()), columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, nullptr, 0, &count);
	list.resize(static_cast<std::size_t>(count));
	if (code == CN_OK && count > 0)
		code = cn_outline_from_field(values.data(), static_cast<int32_t>(values.size()), columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, list.data(), count, &count);
	return { Status(code, nullptr), std::move(list) };
}

/// Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
/// radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).
inline Result<cn_distance> polygon_distance(const cn_polygon &a, const cn_pose &pose_a, const cn_polygon &b, const cn_pose &pose_b)
{
	cn_distance out_out{};
	cn_result code = cn_polygon_distance(&a, &pose_a, &b, &pose_b, &out_out);
	return { Status(code, nullptr), std::move(out_out) };
}

/// Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
/// as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).
inline Result<std::tuple<cn_ray_hit, int32_t>> polygon_cast(const cn_polygon &a, const cn_pose &pose_a, const cn_polygon &b, const cn_pose &pose_b, float translation_x_m, float translation_y_m)
{
	cn_ray_hit out_out{};
	int32_t out_hit{};
	cn_result code = cn_polygon_cast(&a, &pose_a, &b, &pose_b, translation_x_m, translation_y_m, &out_out, &out_hit);
	return { Status(code, nullptr), { std::move(out_out), std::move(out_hit) } };
}

/// Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
/// to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
/// O(points).
inline Result<cn_manifold> polygon_collide(const cn_polygon &a, const cn_pose &pose_a, const cn_polygon &b, const cn_pose &pose_b, float margin_m)
{
	cn_manifold out_out{};
	cn_result code = cn_polygon_collide(&a, &pose_a, &b, &pose_b, margin_m, &out_out);
	return { Status(code, nullptr), std::move(out_out) };
}

/// First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
/// start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
/// hit. Needs no world; runs in any thread.
inline Result<cn_impact> polygon_time_of_impact(const cn_polygon &a, const cn_sweep &sweep_a, const cn_polygon &b, const cn_sweep &sweep_b, float distance_m)
{
	cn_impact out_out{};
	cn_result code = cn_polygon_time_of_impact(&a, &sweep_a, &b, &sweep_b, distance_m, &out_out);
	return { Status(code, nullptr), std::move(out_out) };
}

/// The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
/// dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
/// finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum
/// of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their
/// limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.
inline Result<std::tuple<cn_vec2, float>> mover_solve(Slice<cn_plane> planes, float translation_x_m, float translation_y_m)
{
	cn_vec2 out_translation_m{};
	float out_overlap_m{};
	cn_result code = cn_mover_solve(planes.data(), static_cast<int32_t>(planes.size()), translation_x_m, translation_y_m, &out_translation_m, &out_overlap_m);
	return { Status(code, nullptr), { std::move(out_translation_m), std::move(out_overlap_m) } };
}

/// The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
/// cn_mover_solve. Needs no world. O(count^2).
inline Result<cn_vec2> mover_clip(Slice<const cn_plane> planes, float velocity_x_mps, float velocity_y_mps)
{
	cn_vec2 out_mps{};
	cn_result code = cn_mover_clip(planes.data(), static_cast<int32_t>(planes.size()), velocity_x_mps, velocity_y_mps, &out_mps);
	return { Status(code, nullptr), std::move(out_mps) };
}

} // namespace cairn

#endif
