// The falling-hinges scene of examples/scenes/joints.c through cairn.hpp; prints what bindings/test/hinges.c prints. With the word
// times: nanoseconds per body for reading 1,000 poses, into the caller's array.
#include "cairn.hpp"
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <ctime>

static constexpr float HALF = 0.25f, RADIUS = 0.025f, LEAN = 0.06f, PI = 3.14159265f;

static cairn::Body create_body(cairn::World &world, int32_t type, float x, float y)
{
	cairn::BodyDef def;
	def.type = type;
	def.position_m = { x, y };
	return world.body_create(def).value();
}

static void add_box(cairn::World &world, cairn::Body body, float friction, float half_width, float half_height, float radius)
{
	cairn::ShapeDef def;
	def.body = body;
	def.material.static_friction = def.material.dynamic_friction = friction;
	world.shape_create_box(def, half_width, half_height, radius).value();
}

static void add_column(cairn::World &world, float x, int rows)
{
	cairn::Body below;
	for (int i = 0; i < rows; ++i) {
		float row = static_cast<float>(i);
		cairn::Body body = create_body(world, CN_BODY_DYNAMIC, x + LEAN * row, HALF + 2.0f * HALF * row);
		add_box(world, body, 0.3f, HALF - RADIUS, HALF - RADIUS, RADIUS);
		if (i % 2 == 1) {
			cairn::RevoluteDef def;
			def.base.body_a = below;
			def.base.body_b = body;
			def.base.anchor_a_m = { HALF, HALF };
			def.base.anchor_b_m = { HALF - LEAN, -HALF };
			def.base.flags = CN_JOINT_LIMIT;
			def.lower_angle_rad = -0.3f * PI;
			def.upper_angle_rad = 0.1f * PI;
			world.joint_create_revolute(def).value();
		}
		below = body;
	}
}

static void hinges()
{
	const int columns = 4, rows = 30, steps = 480;
	cairn::World world;
	add_box(world, create_body(world, CN_BODY_STATIC, 0.0f, -1.0f), 0.6f, 30.0f, 1.0f, 0.0f);
	for (int j = 0; j < columns; ++j)
		add_column(world, 2.5f * static_cast<float>(j) - 0.5f * 2.5f * static_cast<float>(columns - 1), rows);
	std::vector<cn_pose> poses(world.get_bodies().value().size());
	std::size_t entered = 0;
	int called = 0;
	uint32_t sum = 0;
	auto count_call = [&called](const cn_contact_event &event) { called += event.kind == CN_EVENT_ENTER; };
	world.on_contact(CN_EVENT_ENTER, count_call).check();
	for (int i = 0; i < steps; ++i) {
		world.step(1.0f / 60.0f).check();
		world.read_poses({}, poses).check();
		entered += world.contact_events(CN_EVENT_ENTER).value().size();
		for (const cn_pose &pose : poses) {
			uint32_t words[4];
			std::memcpy(words, &pose, sizeof words);
			for (uint32_t word : words)
				sum = 31u * sum + word;
		}
	}
	std::printf("falling_hinges: %d steps, %zu bodies, %zu entered, %d called, poses %08" PRIx32 ", hash %016" PRIx64 "\n", steps, poses.size(), entered,
		called, sum, world.hash().value());
	world.on_contact(CN_EVENT_ENTER, nullptr).check();
}

static void times()
{
	const int bodies = 1000, rounds = 5000;
	cairn::World world;
	std::vector<cn_pose> poses(bodies);
	for (int i = 0; i < bodies; ++i)
		create_body(world, CN_BODY_DYNAMIC, static_cast<float>(i), 0.0f);
	std::clock_t start = std::clock();
	for (int i = 0; i < rounds; ++i)
		world.read_poses({}, poses).check();
	std::printf("%.2f\n", static_cast<double>(std::clock() - start) * 1e9 / CLOCKS_PER_SEC / rounds / bodies);
}

// What the layer adds: moved worlds, results without exceptions, the library's sentence.
static int layer()
{
	cairn::World first, world(std::move(first));
	cairn::BodyDef bad;
	bad.angle_rad = 1e9f;
	auto refused = world.body_create(bad);
	if (refused || refused.code() != CN_ERROR_ARGUMENT || refused.value_or(cairn::Body(7)).id != 7)
		return std::puts("a bad definition was not refused");
#if defined(__cpp_exceptions)
	try {
		world.step(-1.0f).check();
		return std::puts("a negative step did not throw");
	} catch (const cairn::Error &error) {
		if (std::strstr(error.what(), "dt_s") == nullptr)
			return std::puts(error.what());
	}
#endif
	std::vector<cn_pose> poses(2);
	cn_body one[1] = { create_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f) };
	if (world.read_poses(one, poses))
		return std::puts("one body filled two poses");
	std::vector<unsigned char> saved = world.save().value();
	uint64_t before = world.hash().value();
	world.step(0.1f).check();
	std::vector<unsigned char> later = world.save().value(), delta = cairn::save_delta(saved, later).value();
	if (cairn::save_apply(saved, delta).value() != later || delta.size() >= saved.size())
		return std::puts("the delta gave another save");
	world.restore(saved).check();
	cairn::Result<cairn::World> read = cairn::World::read(world.write().value());
	if (!read || read.value().hash().value() != before || cairn::World::read(delta).code() != CN_ERROR_FORMAT)
		return std::puts("the file has another world");
	if (world.hash().value() != before || std::string(world.body_get_name(cairn::Body(one[0])).value()) != "")
		return std::puts("restore gave another world");
	static_assert(!std::is_convertible<cairn::Shape, cairn::Body>::value && !std::is_convertible<cn_body, cairn::Body>::value, "handles mix");
	static_assert(!std::is_copy_constructible<cairn::World>::value, "a world is copied");
	return 0;
}

int main(int count, char **words)
{
	if (count > 1 && std::strcmp(words[1], "times") == 0)
		times();
	else if (layer() == 0)
		hinges();
	return 0;
}
