/*
 * figures_test - promises: figures of capsules whose joints have limits come to rest.
 *
 * If this fails, look at body_contacts_list in direct/heavy_contacts_list.c, heaps: cni_direct_settle in direct/joint_projection.c.
 */
#include "joints.h"

#define FIGURES 20
#define PARTS 10
#define HEAPS TEST_MANY(16)

/* A capsule from its middle along (half_x, half_y) to both sides. */
static cn_body part(cn_world *world, float x, float y, float half_x, float half_y, float radius)
{
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, x, y, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.6f, 0.0f);
	cn_capsule capsule;
	capsule.a_m = at(-half_x, -half_y);
	capsule.b_m = at(half_x, half_y);
	capsule.radius_m = radius;
	must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "cn_shape_create_capsule");
	return body;
}

static cn_vec2 local_point(cn_world *world, cn_body body, float x, float y)
{
	cn_vec2 point;
	must(cn_body_get_local_point(world, body, x, y, &point), world, "cn_body_get_local_point");
	return point;
}

static void pin(cn_world *world, cn_body a, cn_body b, float x, float y)
{
	cn_revolute_def def = revolute_def(a, local_point(world, a, x, y), b, local_point(world, b, x, y));
	def.base.flags |= CN_JOINT_LIMIT;
	def.lower_angle_rad = -1.2f;
	def.upper_angle_rad = 1.2f;
	(void)make_revolute(world, &def);
}

/* Ten parts of unlike sizes, above a floor. */
static void figure(cn_world *world, float x, float y, float vx, float vy)
{
	cn_body trunk = part(world, x, y, 0.0f, 0.25f, 0.15f), parts[PARTS];
	int32_t count = 0;
	parts[count++] = trunk;
	parts[count++] = part(world, x, y + 0.6f, 0.0f, 0.005f, 0.18f);
	pin(world, trunk, parts[1], x, y + 0.42f);
	for (int32_t k = -1; k <= 1; k += 2) {
		float side = (float)k;
		parts[count++] = part(world, x + side * 0.35f, y + 0.2f, 0.18f, 0.0f, 0.07f);
		pin(world, trunk, parts[count - 1], x + side * 0.15f, y + 0.2f);
		parts[count++] = part(world, x + side * 0.75f, y + 0.2f, 0.16f, 0.0f, 0.06f);
		pin(world, parts[count - 2], parts[count - 1], x + side * 0.55f, y + 0.2f);
		parts[count++] = part(world, x + side * 0.1f, y - 0.6f, 0.0f, 0.2f, 0.09f);
		pin(world, trunk, parts[count - 1], x + side * 0.1f, y - 0.35f);
		parts[count++] = part(world, x + side * 0.1f, y - 1.1f, 0.0f, 0.2f, 0.08f);
		pin(world, parts[count - 2], parts[count - 1], x + side * 0.1f, y - 0.85f);
	}
	for (int32_t k = 0; k < count; ++k)
		fixture_set_velocity(world, parts[k], vx, vy, 0.0f);
}

static void t_figures_come_to_rest(void)
{
	int32_t asleep = 0;
	for (uint32_t seed = 1; seed <= FIGURES; ++seed) {
		uint32_t random = seed * 2654435761u + 1u;
		cn_world *world = fixture_world(-10.0f, 1);
		fixture_floor(world, 0.6f, 0.0f);
		float vx = fixture_random(&random, -2.0f, 2.0f), vy = fixture_random(&random, -2.0f, 2.0f);
		figure(world, 0.0f, 2.5f, vx, vy);
		fixture_step(world, 1200);
		asleep += fixture_counters(world).bodies_awake == 0;
		cn_world_destroy(world);
	}
	CHECK_GE("figures of 20 that sleep after 20 s", asleep, FIGURES, "");
}

/* Two to five in a pit of 7 m. Exact joints and contacts that know two masses left speeds of 0.1 to 0.5 m/s for ever. */
static void t_heaps_of_figures_come_to_rest(void)
{
	int32_t asleep = 0;
	for (uint32_t seed = 1; seed <= HEAPS; ++seed) {
		uint32_t random = seed * 2654435761u + 1u;
		cn_world *world = fixture_world(-10.0f, 1);
		fixture_floor(world, 0.6f, 0.0f);
		for (int32_t k = -1; k <= 1; k += 2)
			fixture_box(world, CN_BODY_STATIC, 4.0f * (float)k, 5.0f, 0.0f, 0.5f, 5.0f, 0.6f, 0.0f);
		for (uint32_t k = 0; k < 2 + seed % 4; ++k)
			figure(world, fixture_random(&random, -1.5f, 1.5f), 2.5f + 2.0f * (float)k, 0.0f, 0.0f);
		fixture_step(world, 1200);
		asleep += fixture_counters(world).bodies_awake == 0;
		cn_world_destroy(world);
	}
	CHECK_GE("heaps that sleep after 20 s", asleep, HEAPS - TEST_FORM(3, 1, 0), "");
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_figures_come_to_rest);
	RUN(t_heaps_of_figures_come_to_rest);
	return test_end();
}
