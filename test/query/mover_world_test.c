/*
 * mover_world_test - promise: a character is carried by what moves, passes one-way platforms from below only, pushes with bounded force,
 * is never in anything, and moves by the same bits every time.
 *
 * If a test here fails while mover_test passes, look first in: src/query/mover.c (carrying, pushing), mover_plane.c (one-way).
 */
#include "movers.h"

/* ------------------------------------------------------------------ one-way platforms */

static cn_body platform(float x, float y, int32_t type, uint32_t flags)
{
	cn_body body = fixture_body(w, type, x, y, 0.0f);
	cn_shape_def sd = fixture_shape_def(body, 0.6f, 0.0f);
	sd.flags = flags;
	fixture_box_shape(w, &sd, 2.0f, 0.1f);
	return body;
}

static void t_one_way_from_below_and_above(void)
{
	double top = 0.0;
	int32_t k;
	begin(0.0f, 0.8f);
	ground();
	platform(0.0f, 1.9f, CN_BODY_STATIC, CN_SHAPE_ONE_WAY); /* its top at 2 m */
	walk(0.0f, 2);
	mover.velocity_mps.y = 7.0f;
	for (k = 0; k < 120; ++k) {
		walk(0.0f, 1);
		top = greater(top, feet());
	}
	CHECK_LE("error of the height of a jump through it", fabs(top - 2.45), 1e-3, "m");
	CHECK_LE("error of the height of standing on it", fabs(feet() - 2.0), 1e-5, "m");
	CHECK(on_ground());
	/* Walls of it do not stop either. */
	mover.position_m.x = -4.0f;
	mover.position_m.y = 2.0f;
	walk(4.0f, 1);
	CHECK_LE("distance from where its speed takes it beside the platform", fabs((double)mover.position_m.x + 4.0 - 4.0 / 60.0), 1e-5, "m");
	/* Dropping through. */
	mover.position_m.x = 0.0f;
	mover.position_m.y = 2.8f;
	walk(0.0f, 5);
	CHECK(on_ground());
	md.flags = CN_MOVER_DROP;
	walk(0.0f, 10);
	md.flags = 0;
	walk(0.0f, 120);
	CHECK_LE("height after dropping through", fabs(feet()), 1e-5, "m");
	cn_world_destroy(w);
}

/* Falls on a platform that rises at 6 m/s, as far in a step as it falls itself. */
static void t_one_way_platforms_catch_while_they_rise(void)
{
	int32_t start;
	for (start = 0; start < 24; ++start) { /* over more than both go in a step */
		cn_body rising;
		begin(0.0f, 6.0f + 0.013f * (float)start);
		mover.velocity_mps.y = -5.0f;
		rising = platform(0.0f, 0.0f, CN_BODY_KINEMATIC, CN_SHAPE_ONE_WAY);
		fixture_set_velocity(w, rising, 0.0f, 6.0f, 0.0f);
		walk(0.0f, 90);
		CHECK_LE("height over the platform", fabs(feet() - (double)fixture_pose(w, rising).position_m.y - 0.1), 1e-4, "m");
		cn_world_destroy(w);
	}
}

/* ------------------------------------------------------------------ moving platforms */

static void t_is_carried_by_platforms(void)
{
	static const float velocities[5][2] = { { 3.0f, 0.0f }, { 0.0f, 2.0f }, { 0.0f, -2.0f }, { -2.0f, -4.0f }, { 5.0f, 3.0f } };
	int32_t v, k;
	for (v = 0; v < 5; ++v) {
		cn_body carrier;
		double worst = 0.0;
		cn_vec2 from, at;
		begin(0.5f, 0.9f);
		carrier = platform(0.0f, 0.0f, CN_BODY_KINEMATIC, 0);
		walk(0.0f, 2);
		fixture_set_velocity(w, carrier, velocities[v][0], velocities[v][1], 0.0f);
		from = mover.position_m;
		for (k = 0; k < 240; ++k) {
			if (k % 60 == 30)
				fixture_set_velocity(w, carrier, -velocities[v][0], -velocities[v][1], 0.0f);
			walk(0.0f, 1);
			at = fixture_pose(w, carrier).position_m;
			worst = greater(worst, hypot((double)(mover.position_m.x - at.x - from.x), (double)(mover.position_m.y - at.y - from.y)));
		}
		CHECK_LE("off its place on a platform", worst, 1e-3, "m");
		CHECK(on_ground());
		cn_world_destroy(w);
	}
}

static void t_walks_on_platforms_and_takes_their_speed_along(void)
{
	cn_body carrier;
	double before;
	begin(0.0f, 0.9f);
	carrier = platform(0.0f, 0.0f, CN_BODY_KINEMATIC, 0);
	walk(0.0f, 2);
	fixture_set_velocity(w, carrier, 3.0f, 0.0f, 0.0f);
	walk(0.0f, 2);
	before = (double)mover.position_m.x;
	walk(1.0f, 60);
	CHECK_LE("off the way of 4 m/s", fabs((double)mover.position_m.x - before - 4.0), 1e-3, "m");
	mover.velocity_mps.y = 4.0f;
	move();
	CHECK_LE("speed after the jump off 4 m/s", fabs((double)mover.velocity_mps.x - 4.0), 1e-4, "m/s");
	CHECK(!on_ground());
	cn_world_destroy(w);
}

/* A platform that turns carries by the place under the feet; a conveyor by its surface. */
static void t_is_carried_by_turning_platforms_and_conveyors(void)
{
	cn_body carrier;
	cn_material material;
	cn_vec2 under;
	double worst = 0.0, before;
	int32_t k;
	begin(1.0f, 0.9f);
	carrier = platform(0.0f, 0.0f, CN_BODY_KINEMATIC, 0);
	walk(0.0f, 2);
	fixture_set_velocity(w, carrier, 0.0f, 0.0f, 0.3f);
	for (k = 0; k < 120; ++k) {
		walk(0.0f, 1);
		must(cn_body_get_world_point(w, carrier, mover.ground_local_m.x, mover.ground_local_m.y, &under), w, "world_point");
		worst = greater(worst, hypot((double)(under.x - mover.ground_point_m.x), (double)(under.y - mover.ground_point_m.y)));
	}
	CHECK(on_ground());
	CHECK_LE("off the place under its feet", worst, 1e-5, "m");
	CHECK_GE("height at the end", (double)mover.position_m.y, 1.2, "m");
	cn_world_destroy(w);
	begin(0.0f, 0.9f);
	carrier = platform(0.0f, 0.0f, CN_BODY_STATIC, 0);
	must(cn_shape_get_material(w, fixture_first_shape(w, carrier), &material), w, "get_material");
	material.tangent_speed_mps = 1.5f;
	must(cn_shape_set_material(w, fixture_first_shape(w, carrier), &material), w, "set_material");
	walk(0.0f, 2);
	before = (double)mover.position_m.x;
	walk(0.0f, 60);
	CHECK_LE("off the way of a conveyor", fabs((double)mover.position_m.x - before - 1.5), 1e-3, "m");
	cn_world_destroy(w);
}

/* A wall that moves pushes it, along the ground and not through the wall behind. */
static void t_moving_walls_push_and_squeeze(void)
{
	cn_body wall;
	double squeezed = 0.0;
	int32_t k;
	begin(0.0f, 0.8f);
	ground();
	box(4.0f, 2.0f, 0.5f, 4.0f, 0.0f);
	wall = fixture_box(w, CN_BODY_KINEMATIC, -2.0f, 2.0f, 0.0f, 0.5f, 1.9f, 0.6f, 0.0f);
	fixture_set_velocity(w, wall, 3.0f, 0.0f, 0.0f);
	walk(0.0f, 60);
	CHECK_LE("off the moving wall's face", fabs((double)(mover.position_m.x - fixture_pose(w, wall).position_m.x) - 0.5 - RADIUS), 1e-4, "m");
	CHECK_LE("height", fabs(feet()), 1e-4, "m");
	CHECK_LE("squeezed by", (double)mover.squeezed_m, 1e-5, "m");
	for (k = 0; k < 60; ++k) {
		walk(0.0f, 1);
		squeezed = greater(squeezed, (double)mover.squeezed_m);
	}
	CHECK_GE("squeezed by", squeezed, 0.1, "m");
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ pushing */

static void t_pushes_crates_with_bounded_force(void)
{
	static const float forces[3] = { 0.0f, 60.0f, 200.0f };
	int32_t f, k;
	for (f = 0; f < 3; ++f) {
		cn_body crate;
		double fastest = 0.0, jump = 0.0, deepest = 0.0;
		begin(0.0f, 0.8f);
		md.push_force_N = forces[f];
		ground();
		/* 16 kg with a friction of 0.5: 80 N hold it. */
		crate = fixture_box(w, CN_BODY_DYNAMIC, 2.0f, 2.0f, 0.0f, 2.0f * 0.5f, 2.0f, 0.5f, 0.0f);
		must(cn_shape_set_density(w, fixture_first_shape(w, crate), 2.0f), w, "density");
		walk(0.0f, 30);
		for (k = 0; k < 180; ++k) {
			double before = (double)fixture_velocity(w, crate).linear_mps.x;
			walk(2.0f, 1);
			jump = greater(jump, ((double)fixture_velocity(w, crate).linear_mps.x - before) * 16.0 * 60.0);
			fastest = greater(fastest, (double)fixture_velocity(w, crate).linear_mps.x);
			deepest = greater(deepest, (double)(mover.position_m.x - fixture_pose(w, crate).position_m.x) + 1.0 + RADIUS);
		}
		printf("  force %g N: the crate went %g m\n", (double)forces[f], (double)fixture_pose(w, crate).position_m.x - 2.0);
		CHECK_LE("speed of the crate", fastest, 2.0 + 1e-3, "m/s");
		CHECK_LE("force on the crate", jump, (double)forces[f] * 1.01 + 1e-3, "N");
		CHECK_LE("overlap with the crate", deepest, 1e-3, "m");
		if (forces[f] < 80.0f)
			CHECK_LE("way of the crate", fabs((double)fixture_pose(w, crate).position_m.x - 2.0), 0.02, "m");
		else
			CHECK_GE("way of the crate", (double)fixture_pose(w, crate).position_m.x - 2.0, 2.0, "m");
		cn_world_destroy(w);
	}
}

/* ------------------------------------------------------------------ other worlds */

/* Gravity and up along any direction, kilometres from the origin, with and without a step. */
static void t_up_may_be_anywhere(void)
{
	static const float angles[4] = { 0.0f, 1.5707963f, 2.5f, -0.7f };
	int32_t a, k;
	for (a = 0; a < 8; ++a) {
		float angle = angles[a % 4], far_x = a >= 4 ? 2000.0f : 0.0f, step = 0.2f;
		double c = cos((double)angle), s = sin((double)angle), x, y, epsilon = a >= 4 ? 0.02 : 1e-3;
		begin(far_x - 0.8f * (float)s, 0.8f * (float)c);
		must(cn_world_set_gravity(w, 10.0f * (float)s, -10.0f * (float)c), w, "gravity");
		md.up.x = -3.0f * (float)s;
		md.up.y = 3.0f * (float)c;
		md.shape.points_m[0].x = 0.5f * (float)s;
		md.shape.points_m[0].y = -0.5f * (float)c;
		md.shape.points_m[1].x = -0.5f * (float)s;
		md.shape.points_m[1].y = 0.5f * (float)c;
		box(far_x + (float)s, -(float)c, 50.0f, 1.0f, angle);
		box(far_x + (float)(3.0 * c - 0.5 * (double)step * s), (float)(3.0 * s + 0.5 * (double)step * c), 1.0f, 0.5f * step, angle);
		for (k = 0; k < 120; ++k) {
			fixture_step(w, 1);
			mover.velocity_mps.x = 1.5f * (float)c;
			mover.velocity_mps.y = 1.5f * (float)s;
			move();
		}
		x = ((double)mover.position_m.x - (double)far_x) * c + (double)mover.position_m.y * s;
		y = ((double)mover.position_m.y) * c - ((double)mover.position_m.x - (double)far_x) * s;
		CHECK(on_ground());
		CHECK_LE("way along the ground off 3 m", fabs(x - 3.0), epsilon, "m");
		CHECK_LE("height off the step's", fabs(y - 0.8 - (double)step), epsilon, "m");
		cn_world_destroy(w);
	}
}

static void t_ignores_what_its_filter_does(void)
{
	cn_body own;
	begin(0.0f, 0.8f);
	ground();
	own = fixture_box(w, CN_BODY_KINEMATIC, 0.0f, 0.8f, 0.0f, 0.3f, 0.8f, 0.6f, 0.0f);
	md.filter.ignored_body = own;
	walk(0.0f, 2);
	walk(3.0f, 60);
	CHECK_LE("off the way of 3 m, with a body of its own around it", fabs((double)mover.position_m.x - 3.0), 1e-4, "m");
	cn_world_destroy(w);
}

/* On a crate that rests on the ground, and on one that falls over: what is dynamic carries as well as what is not. */
static void t_stands_on_dynamic_bodies(void)
{
	cn_body crate;
	double worst = 0.0;
	int32_t k, off = 0;
	begin(0.0f, 1.9f);
	ground();
	crate = fixture_box(w, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f, 1.0f, 0.5f, 0.6f, 0.0f);
	walk(0.0f, 60);
	CHECK(mover.ground_body == crate);
	fixture_set_velocity(w, crate, 3.0f, 0.0f, 0.0f);
	for (k = 0; k < 60; ++k) {
		cn_vec2 under;
		walk(0.0f, 1);
		must(cn_body_get_world_point(w, crate, mover.ground_local_m.x, mover.ground_local_m.y, &under), w, "world_point");
		worst = greater(worst, fabs((double)(under.x - mover.position_m.x)));
		off += mover.ground_body != crate;
	}
	CHECK_LE("off its place on a sliding crate", worst, 1e-3, "m");
	CHECK_LE("frames off it", off, 0, "");
	CHECK_GE("way of the crate", (double)fixture_pose(w, crate).position_m.x, 0.5, "m");
	must(cn_body_destroy(w, crate), w, "destroy");
	walk(0.0f, 60);
	CHECK_LE("height after the crate went away", fabs(feet()), 1e-5, "m");
	cn_world_destroy(w);
}

/* ------------------------------------------------------------------ anything */

static float random_in(uint32_t *state, float lower, float upper) { return fixture_random(state, lower, upper); }

/* A room full of boxes, edges and hulls at all angles, and a mover of any shape that is thrown about in it. */
static void clutter(uint32_t *state)
{
	int32_t k, i;
	box(0.0f, -11.0f, 22.0f, 1.0f, 0.0f);
	box(0.0f, 11.0f, 22.0f, 1.0f, 0.0f);
	box(-21.0f, 0.0f, 1.0f, 12.0f, 0.0f);
	box(21.0f, 0.0f, 1.0f, 12.0f, 0.0f);
	for (k = 0; k < 60; ++k) {
		float x = random_in(state, -19.0f, 19.0f), y = random_in(state, -10.0f, 8.0f), angle = k % 3 ? random_in(state, -3.0f, 3.0f) : 0.0f;
		cn_body body = fixture_body(w, CN_BODY_STATIC, x, y, angle);
		cn_shape_def sd = fixture_shape_def(body, 0.6f, 0.0f);
		cn_edge edge = { { -1.0f, 0.0f }, { 1.0f, 0.3f } };
		cn_vec2 cloud[8];
		cn_polygon hull;
		for (i = 0; i < 8; ++i) {
			cloud[i].x = random_in(state, -1.0f, 1.0f);
			cloud[i].y = random_in(state, -1.0f, 1.0f);
		}
		must(cn_polygon_make_hull(cloud, 8, k % 4 ? 0.0f : 0.1f, &hull), NULL, "hull");
		if (k % 3 == 0)
			fixture_box_shape(w, &sd, 1.0f, 0.2f);
		else if (k % 3 == 1)
			must(cn_shape_create_edge(w, &sd, &edge, NULL), w, "edge");
		else
			must(cn_shape_create_polygon(w, &sd, &hull, NULL), w, "hull");
	}
}

static int32_t deepest_of(const cn_world *world, const cn_ray_hit *hit, void *user)
{
	(void)world;
	*(double *)user = greater(*(double *)user, (double)hit->depth_m);
	return CN_QUERY_SKIP;
}

/* Deepest overlap with anything. */
static double depth_of_mover(void)
{
	cn_polygon there = md.shape;
	cn_query_filter filter;
	cn_ray_hit hit;
	int32_t k;
	double deepest = 0.0;
	for (k = 0; k < there.count; ++k) {
		there.points_m[k].x += mover.position_m.x;
		there.points_m[k].y += mover.position_m.y;
	}
	cn_query_filter_init(&filter);
	filter.visit = deepest_of;
	filter.user = &deepest;
	must(cn_world_cast_shape(w, &there, 0.0f, 0.0f, &filter, &hit), w, "cast");
	return deepest;
}

static void t_never_in_anything(void)
{
	uint32_t state = 77u;
	int32_t round, k, outside = 0, squeezed = 0, frames = 0, deep = 0, stood = 0;
	double worst = 0.0;
	for (round = 0; round < 24; ++round) {
		int32_t free_place = 0;
		begin(0.0f, 0.0f);
		clutter(&state);
		if (round % 3 == 1)
			must(cn_polygon_make_box(0.3f, 0.6f, 0.0f, 0.0f, 0.0f, 0.0f, &md.shape), NULL, "box");
		if (round % 3 == 2) {
			md.shape.count = 1;
			md.shape.points_m[0].y = 0.0f;
			md.shape.radius_m = 0.5f;
		}
		for (k = 0; k < 300 && !free_place; ++k) {
			mover.position_m.x = random_in(&state, -18.0f, 18.0f);
			mover.position_m.y = random_in(&state, -9.0f, 9.0f);
			free_place = depth_of_mover() == 0.0;
		}
		CHECK(free_place);
		for (k = 0; k < 1500; ++k) {
			if (k % 10 == 0)
				mover.velocity_mps.x = random_in(&state, -8.0f, 8.0f);
			if (k % 37 == 0)
				mover.velocity_mps.y = random_in(&state, 0.0f, 12.0f);
			if (k % 101 == 0) {
				mover.velocity_mps.x = random_in(&state, -200.0f, 200.0f);
				mover.velocity_mps.y = random_in(&state, -200.0f, 200.0f);
			}
			move();
			++frames;
			stood += on_ground();
			outside += fabsf(mover.position_m.x) > 20.0f || fabsf(mover.position_m.y) > 10.0f;
			if (mover.squeezed_m > 1e-4f) {
				++squeezed;
				continue;
			}
			double depth = depth_of_mover();
			deep += depth > 1e-4;
			worst = greater(worst, depth);
		}
		cn_world_destroy(w);
	}
	printf("  %d frames, %d on the ground, %d squeezed, %d deeper than 0.1 mm\n", (int)frames, (int)stood, (int)squeezed, (int)deep);
	CHECK_LE("frames outside of the room", outside, 0, "");
	CHECK_LE("deepest overlap", worst, 2e-4, "m");
	CHECK_GE("frames on the ground", stood, frames / 10, "");
	CHECK_LE("frames squeezed", squeezed, frames / 50, "");
}

/* ------------------------------------------------------------------ the same bits */

static uint64_t fnv(uint64_t hash, const void *bytes, size_t count)
{
	for (size_t k = 0; k < count; ++k)
		hash = (hash ^ ((const uint8_t *)bytes)[k]) * 1099511628211ull;
	return hash;
}

/* A run over everything, with random keys; from `again` on a second time with the state of then. */
static uint64_t session(int32_t broadphase, int32_t crates)
{
	uint64_t hash = 14695981039346656037ull;
	uint32_t seed = 5u;
	cn_body lift;
	cn_world_def wd;
	int32_t k;
	begin(0.0f, 3.0f);
	cn_world_destroy(w);
	cn_world_def_init(&wd);
	wd.broadphase = broadphase;
	must(cn_world_create(&wd, &w), NULL, "world");
	tiles(0);
	box(-6.0f, 2.0f, 0.5f, 3.0f, 0.0f);
	box(20.0f, 2.0f, 0.5f, 3.0f, 0.0f);
	box(8.0f, 0.0f, 3.0f, 0.4f, 0.4f);
	box(14.0f, 0.1f, 0.5f, 0.1f, 0.0f);
	platform(0.0f, 1.7f, CN_BODY_STATIC, CN_SHAPE_ONE_WAY);
	lift = platform(4.0f, 1.0f, CN_BODY_KINEMATIC, 0);
	for (k = 0; k < crates; ++k)
		fixture_box(w, CN_BODY_DYNAMIC, -4.0f + 1.5f * (float)k, 4.0f, 0.3f, 0.3f, 0.3f, 0.5f, 0.0f);
	for (k = 0; k < 1200; ++k) {
		cn_mover copy = mover, kept;
		float keys = fixture_random(&seed, -1.0f, 1.0f);
		fixture_set_velocity(w, lift, 0.0f, k / 90 % 2 ? 1.0f : -1.0f, 0.0f);
		fixture_step(w, 1);
		md.push_force_N = 0.0f;
		move();
		kept = mover;
		mover = copy;
		move(); /* without pushing, a move changes nothing: the same again */
		CHECK(memcmp(&kept, &mover, sizeof kept) == 0);
		mover = copy;
		md.push_force_N = 200.0f;
		if (k % 20 == 0)
			mover.velocity_mps.x = 6.0f * keys;
		if (on_ground() && keys > 0.95f)
			mover.velocity_mps.y = 6.0f;
		move();
		hash = fnv(hash, &mover, sizeof mover);
	}
	CHECK(fixture_is_valid(w));
	cn_world_destroy(w);
	return hash;
}

/* Of the run without crates, which depends on the mover alone. */
#define GOLDEN 0x3241aee3f38ca5c1ull

static void t_same_bits(void)
{
	uint64_t sweep = session(CN_BROADPHASE_SWEEP, 6), alone = session(CN_BROADPHASE_SWEEP, 0);
	printf("  %016llx, without crates %016llx\n", (unsigned long long)sweep, (unsigned long long)alone);
	CHECK(sweep == session(CN_BROADPHASE_SWEEP, 6) && sweep == session(CN_BROADPHASE_TREE, 6));
	CHECK(test_golden_holds(alone, GOLDEN));
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(t_one_way_from_below_and_above);
	RUN(t_one_way_platforms_catch_while_they_rise);
	RUN(t_is_carried_by_platforms);
	RUN(t_walks_on_platforms_and_takes_their_speed_along);
	RUN(t_is_carried_by_turning_platforms_and_conveyors);
	RUN(t_moving_walls_push_and_squeeze);
	RUN(t_pushes_crates_with_bounded_force);
	RUN(t_up_may_be_anywhere);
	RUN(t_ignores_what_its_filter_does);
	RUN(t_stands_on_dynamic_bodies);
	RUN(t_never_in_anything);
	RUN(t_same_bits);
	return test_end();
}
