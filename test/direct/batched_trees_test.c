/*
 * test/direct/batched_trees_test.c - trees that are alike, solved side by side (direct/batched_trees.c, linear/topology_class.c).
 *
 * A batch is held to what its trees do alone: a world with one of them and nothing else, in whose batch it is alone, must
 * give the same bits. If it does not, look in direct/batched_trees_kernel.h; if trees are not in batches, in
 * linear/topology_class.c.
 */
#include "joints/joint_pass.h"
#include "world/fixture.h"

#define CREATURES 20
#define HANGING 10 /* from this one on they hang from the world */
#define LIMBS 3
#define BODIES (1 + 2 * LIMBS)
#define JOINTS (2 * LIMBS)

typedef struct creature {
	cn_body body[BODIES];
	cn_joint joint[JOINTS + 1];
} creature;

/* xorshift32 (Marsaglia, 2003) */
static uint32_t next(uint32_t *state)
{
	*state ^= *state << 13;
	*state ^= *state >> 17;
	*state ^= *state << 5;
	return *state;
}

static void add_body(cn_world *world, creature *c, int32_t k, float x, float y, float hx, float hy, int32_t number)
{
	cn_shape_def def;
	c->body[k] = fixture_body(world, CN_BODY_DYNAMIC, x, y, 0.0f);
	def = fixture_shape_def(c->body[k], 0.5f, 0.1f);
	def.density_kgpm2 = 1.0f + 0.3f * (float)number;
	def.filter.group = -1 - number;
	fixture_box_shape(world, &def, hx, hy);
}

/* Of parts of a kind, but no two creatures have the same springs, motors and limits. */
static cn_joint join(cn_world *world, cn_body a, float ax, float ay, cn_body b, float bx, float by, int32_t number)
{
	static const uint32_t flags[] = { CN_JOINT_SPRING, CN_JOINT_MOTOR, CN_JOINT_SPRING | CN_JOINT_LIMIT, CN_JOINT_MOTOR | CN_JOINT_LIMIT, CN_JOINT_SPRING | CN_JOINT_MOTOR | CN_JOINT_LIMIT };
	cn_revolute_def def;
	cn_joint joint = 0;
	cn_revolute_def_init(&def);
	def.base.body_a = a;
	def.base.body_b = b;
	def.base.anchor_a_m.x = ax;
	def.base.anchor_a_m.y = ay;
	def.base.anchor_b_m.x = bx;
	def.base.anchor_b_m.y = by;
	def.base.flags |= flags[number % 5];
	def.lower_angle_rad = -0.4f - 0.02f * (float)number;
	def.upper_angle_rad = 0.3f + 0.02f * (float)number;
	def.motor_torque_max_Nm = 0.05f * (float)number;
	def.spring_hertz = 1.0f + 0.3f * (float)number;
	def.spring_damping_ratio = 0.2f;
	must(cn_joint_create_revolute(world, &def, &joint), world, "cn_joint_create_revolute");
	return joint;
}

/* Joint k: of limb k / 2, at the trunk (0) or between its parts (1); the last one at the world. */
static void add_joint(cn_world *world, creature *c, int32_t k, int32_t number)
{
	int32_t limb = k / 2;
	float x = 0.4f * (float)(limb - 1);
	if (k == JOINTS)
		c->joint[k] = join(world, 0, 6.0f * (float)number, 3.4f, c->body[0], 0.0f, 0.4f, number);
	else if (k % 2 == 0)
		c->joint[k] = join(world, c->body[0], x, 0.0f, c->body[1 + k], 0.0f, 0.3f, number);
	else
		c->joint[k] = join(world, c->body[k], 0.0f, -0.3f, c->body[1 + k], 0.0f, 0.3f, number);
}

static int32_t joints_of(int32_t number)
{
	return number >= HANGING ? JOINTS + 1 : JOINTS;
}

/* Joints in an order of the creature's own. */
static void add_creature(cn_world *world, creature *c, int32_t number)
{
	float x = 6.0f * (float)number, y = 3.0f;
	uint32_t random = 77u + (uint32_t)number, made = 0;
	int32_t k, count;
	add_body(world, c, 0, x, y, 0.5f, 0.08f, number);
	for (k = 0; k < LIMBS; ++k) {
		float at = x + 0.4f * (float)(k - 1);
		add_body(world, c, 1 + 2 * k, at, y - 0.3f, 0.08f, 0.3f, number);
		add_body(world, c, 2 + 2 * k, at, y - 0.9f, 0.08f, 0.3f, number);
	}
	for (count = 0; count < joints_of(number);) {
		k = (int32_t)(next(&random) % (uint32_t)joints_of(number));
		if (made >> k & 1u)
			continue;
		made |= 1u << k;
		add_joint(world, c, k, number);
		++count;
	}
	fixture_set_velocity(world, c->body[0], 0.1f * (float)number, -1.0f, 0.5f + 0.1f * (float)number);
}

static cn_world *empty_world(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	fixture_box(world, CN_BODY_STATIC, 60.0f, -1.0f, 0.0f, 100.0f, 1.0f, 0.6f, 0.0f);
	return world;
}

static int32_t works_in_herds(const cn_world *world)
{
	int32_t k, count = 0;
	for (k = 0; k < world->awake_joints.count; ++k)
		count += (cni_joint_constraints(world)[k].flags & CNI_CONSTRAINT_BATCHED) != 0;
	return count;
}

/* Joints in batches whose pins are no longer solved directly. */
static int32_t works_single(const cn_world *world)
{
	int32_t k, count = 0;
	for (k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint_constraint *w = cni_joint_constraints(world) + k;
		count += (w->flags & CNI_CONSTRAINT_BATCHED) && !(cni_joint_block_of(world, w)->direct >> w->lane % CNI_LANES & 1u);
	}
	return count;
}

/* In the first so many bodies. */
static int32_t bodies_differ(const cn_world *a, const creature *ca, const cn_world *b, const creature *cb, int32_t bodies)
{
	int32_t k;
	for (k = 0; k < bodies; ++k) {
		cn_pose pa = fixture_pose(a, ca->body[k]), pb = fixture_pose(b, cb->body[k]);
		cn_velocity va = fixture_velocity(a, ca->body[k]), vb = fixture_velocity(b, cb->body[k]);
		if (memcmp(&pa, &pb, sizeof pa) != 0 || memcmp(&va, &vb, sizeof va) != 0)
			return 1;
	}
	return 0;
}

static int32_t differs(const cn_world *a, const creature *ca, const cn_world *b, const creature *cb)
{
	return bodies_differ(a, ca, b, cb, BODIES);
}

/* Falling, landing and lying; hanging and swinging: all with the bits of one that is alone. */
static void herds_have_the_bits_of_one(void)
{
	static creature batch[CREATURES];
	cn_world *world = empty_world();
	int32_t k, step, different = 0, least = CREATURES * (JOINTS + 1), alone_in_herds = 0;
	for (k = 0; k < CREATURES; ++k)
		add_creature(world, &batch[k], k);
	for (step = 0; step < 180; ++step) {
		fixture_step(world, 1);
		if (step < 20)
			least = cni_min_i(least, works_in_herds(world));
	}
	for (k = 0; k < CREATURES; ++k) {
		creature c;
		cn_world *lone = empty_world();
		add_creature(lone, &c, k);
		fixture_step(lone, 1); /* later some lie down, and their contacts take them out of the batch */
		alone_in_herds += works_in_herds(lone);
		fixture_step(lone, 179);
		different += differs(world, &batch[k], lone, &c);
		cn_world_destroy(lone);
	}
	CHECK_GE("joints in batches, least of the first 20 steps", least, HANGING * JOINTS + (CREATURES - HANGING) * (JOINTS + 1), "");
	CHECK(alone_in_herds == HANGING * JOINTS + (CREATURES - HANGING) * (JOINTS + 1));
	CHECK_LE("creatures that move otherwise than alone", different, 0, "of 20");
	cn_world_destroy(world);
}

/* Two boxes on one pin. */
static void add_pair(cn_world *world, creature *c, int32_t number)
{
	float x = 6.0f * (float)number;
	add_body(world, c, 0, x, 2.0f, 0.5f, 0.08f, number);
	add_body(world, c, 1, x + 0.7f, 2.0f, 0.3f, 0.1f, number);
	c->joint[0] = join(world, c->body[0], 0.45f, 0.0f, c->body[1], -0.25f, 0.0f, number);
	fixture_set_velocity(world, c->body[0], 0.1f * (float)number, -1.0f, 0.5f + 0.1f * (float)number);
}

/* The least tree: one pin between two bodies. */
static void pairs_have_the_bits_of_one(void)
{
	static creature batch[CREATURES];
	cn_world *world = empty_world();
	int32_t k, different = 0, alone_in_herds = 0;
	for (k = 0; k < CREATURES; ++k)
		add_pair(world, &batch[k], k);
	fixture_step(world, 1);
	CHECK(works_in_herds(world) == CREATURES);
	fixture_step(world, 179);
	for (k = 0; k < CREATURES; ++k) {
		creature c;
		cn_world *lone = empty_world();
		add_pair(lone, &c, k);
		fixture_step(lone, 1); /* later some lie down, and their contacts take them out of the batch */
		alone_in_herds += works_in_herds(lone);
		fixture_step(lone, 179);
		different += bodies_differ(world, &batch[k], lone, &c, 2);
		cn_world_destroy(lone);
	}
	CHECK(alone_in_herds == CREATURES);
	CHECK_LE("pairs that move otherwise than alone", different, 0, "of 20");
	cn_world_destroy(world);
}

/* Joints that come and go shuffle the lists, and do not make strangers of those that are alike. */
static void shuffled_joints_stay_of_a_kind(void)
{
	static creature batch[HANGING];
	cn_world *world = empty_world();
	uint32_t random = 5;
	int32_t k, round;
	for (k = 0; k < HANGING; ++k)
		add_creature(world, &batch[k], k);
	for (round = 0; round < 50; ++round) {
		int32_t number = (int32_t)(next(&random) % HANGING), joint = (int32_t)(next(&random) % JOINTS);
		must(cn_joint_destroy(world, batch[number].joint[joint]), world, "cn_joint_destroy");
		add_joint(world, &batch[number], joint, number);
	}
	fixture_step(world, 1);
	CHECK(works_in_herds(world) == HANGING * JOINTS);
	cn_world_destroy(world);
}

/* Heavy boxes fall on trees, which stay in their batch: direct/heavy_contacts.c solves those contacts with factors from their lanes. */
static void struck_trees_stay(void)
{
	static creature batch[4];
	cn_world *world = empty_world();
	int32_t k, step, least = 4;
	for (k = 0; k < 4; ++k) {
		cn_revolute_def pin;
		cn_shape_def def;
		add_pair(world, &batch[k], k);
		must(cn_joint_destroy(world, batch[k].joint[0]), world, "cn_joint_destroy");
		cn_revolute_def_init(&pin); /* without a spring, motor or limit */
		pin.base.body_a = batch[k].body[0];
		pin.base.body_b = batch[k].body[1];
		pin.base.anchor_a_m.x = 0.45f;
		pin.base.anchor_b_m.x = -0.25f;
		must(cn_joint_create_revolute(world, &pin, &batch[k].joint[0]), world, "cn_joint_create_revolute");
		def = fixture_shape_def(fixture_body(world, CN_BODY_DYNAMIC, 6.0f * (float)k, 2.5f, 0.0f), 0.5f, 0.0f);
		def.density_kgpm2 = 100.0f;
		fixture_box_shape(world, &def, 0.2f, 0.2f);
	}
	for (step = 0; step < 60; ++step) {
		fixture_step(world, 1);
		if (step >= 36) /* until they touch something RATTLE takes them */
			least = cni_min_i(least, works_in_herds(world));
	}
	CHECK_GE("joints in batches, least of 24 steps", least, 4, "");
	cn_world_destroy(world);
}

static cni_motion *motion_of(const cn_world *world, cn_body body)
{
	return cni_motions(world) + cni_body_at(world, cni_handles_find(&world->body_handles, body))->awake;
}

/* One whose system floats cannot hold leaves its batch, and nobody else knows. */
static void broken_systems_leave(void)
{
	static creature batch[4];
	cn_world *world = empty_world();
	creature c;
	cn_world *lone = empty_world();
	int32_t k, different = 0;
	for (k = 0; k < 4; ++k)
		add_creature(world, &batch[k], k);
	motion_of(world, batch[1].body[0])->vy = (float)NAN;
	fixture_step(world, 1);
	CHECK(works_in_herds(world) == 4 * JOINTS);
	CHECK(works_single(world) == JOINTS);
	for (k = 0; k < 4; ++k) {
		if (k == 1)
			continue;
		cn_world_destroy(lone);
		lone = empty_world();
		add_creature(lone, &c, k);
		fixture_step(lone, 1);
		different += differs(world, &batch[k], lone, &c);
	}
	CHECK_LE("creatures that move otherwise than alone", different, 0, "of 3");
	cn_world_destroy(lone);
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(herds_have_the_bits_of_one);
	RUN(pairs_have_the_bits_of_one);
	RUN(shuffled_joints_stay_of_a_kind);
	RUN(struck_trees_stay);
	RUN(broken_systems_leave);
	return test_end();
}
