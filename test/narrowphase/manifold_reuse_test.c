/*
 * test/narrowphase/manifold_reuse_test.c - lanes that are followed (narrowphase/manifold_reuse.c) against manifolds computed anew.
 *
 * A world is stepped; then its lanes are followed for the poses as they are, copied, loosened, and computed by the
 * narrowphase. Both must say the same of where and how the shapes touch. What a user changes (material, mass, poses,
 * types) must end following where it matters. If a difference is large, look at the frames in contacts/manifold_reuse_kernel.h.
 */
#include "model/world.h"
#include "narrowphase/touch.h"
#include "world/fixture.h"

#include <string.h>

#define LANES_MOST 4096

typedef struct lane_copy {
	int32_t contact;
	float nx, ny, dn, dt, fa, fb, tm;
	float at[2], an[2], s0[2], nm[2];
} lane_copy;

static lane_copy copies[LANES_MOST];
static int32_t left[LANES_MOST];

static lane_copy lane_read(const cn_world *world, int32_t contact)
{
	int32_t slot = cni_contact_at(world, contact)->slot, l = slot % CNI_LANES, k;
	const cni_contact_block *b = cni_block_at(world, slot / CNI_LANES);
	lane_copy c;
	c.contact = contact;
	c.nx = b->nx[l];
	c.ny = b->ny[l];
	c.dn = b->dn[l];
	c.dt = b->dt[l];
	c.fa = b->fa[l];
	c.fb = b->fb[l];
	c.tm = b->tm[l];
	for (k = 0; k < 2; ++k) {
		c.at[k] = b->p[k].at[l];
		c.an[k] = b->p[k].an[l];
		c.s0[k] = b->p[k].s0[l];
		c.nm[k] = b->p[k].nm[l];
	}
	return c;
}

static int32_t contains(const int32_t *list, int32_t count, int32_t value)
{
	while (count > 0)
		if (list[--count] == value)
			return 1;
	return 0;
}

/* Follows, copies what was followed, and loosens all. Returns the number of copies; total: lanes. */
static int32_t follow_all(cn_world *world, int32_t *total)
{
	int32_t missed = cni_manifolds_reuse(world, FRAME_S, left), count = 0, k;
	*total = 0;
	for (k = 0; k < world->contact_used; ++k) {
		if (!cni_contact_has_lane(cni_contact_at(world, k)))
			continue;
		++*total;
		if (!contains(left, missed, k) && count < LANES_MOST)
			copies[count++] = lane_read(world, k);
		cni_contact_invalidate(world, k);
	}
	return count;
}

/*
 * What following may miss. Until a manifold is computed again, one surface slides along the other by a 256th of the smaller
 * body's extent at most, and by no more than a quarter of the slop, 1.25 mm; one body turns against the other by a 512th. While they move,
 * a body on a face slides by a 16th, no more than three slops, 15 mm.
 *   normal      between faces, that turn; at a box's corner a ball's centre moves along by what it slid: 1 / 256
 *   arms        what slid, where the points are corners of both bodies, and what the normal missed times the distance of the centres, 0.72 m
 *               for two boxes; balls slide less, and nearer
 *   separation  what slid times the angle between clipped edges; in motion as well, as edge_holds limits that
 */
#define NORMAL_OF_FACES (1.0 / 512.0)
#define NORMAL_OF_BALLS (1.0 / 256.0)
#define ARM (1.25e-3 + 0.72 * NORMAL_OF_FACES)
#define ARM_IN_MOTION (15e-3 + 0.72 * NORMAL_OF_FACES)
#define SEPARATION 2.5e-4

/*
 * Corner on corner, the normal hangs on micrometres and may be any; a point may just have reached the margin. How many lanes of
 * a pile miss more than the above is chance: so several piles are looked at, and the part of such lanes is bound. What counts
 * in the end is where the surfaces are. With any other normal they are off by no more than what slid at the point that was followed, and,
 * where another corner is the nearest now, by its turn: over twice the extent it is limited to what may slide (manifold_reuse_kernel.h).
 */
#define OTHER_PART (1.0 / 250.0)
#define SEPARATION_OF_CORNERS (2.0 * 1.25e-3)
static const float shifts[] = { 0.02f, 0.0201f, 0.0205f, 0.0204f, 0.0211f, 0.0212f, 0.022f }; /* of one row of a pile against the next */
enum { PILES = sizeof shifts / sizeof shifts[0] };

typedef struct worst {
	double normal_most;           /* radians: how much may be missed */
	double separation, arm, normal, mass; /* of lanes that missed no more: metres, metres, radians, relative */
	double separation_of_others;  /* metres */
	int32_t lanes, followed;
	int32_t slid;                 /* lanes whose arms missed more than ARM */
	int32_t other;                /* lanes that missed more */
} worst;

static double apart(float a, float b) { return fabs((double)a - (double)b); }

static int32_t points_of(const lane_copy *c)
{
	return (c->nm[0] > 0.0f) + (c->nm[1] > 0.0f);
}

static double angle_between(const lane_copy *a, const lane_copy *b)
{
	double ax = (double)a->nx, ay = (double)a->ny, bx = (double)b->nx, by = (double)b->ny;
	return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by));
}

/* A normal between corners that are apart may turn much; it matters once they touch. */
static int32_t bears(const lane_copy *c)
{
	return (c->nm[0] > 0.0f && c->s0[0] < 1e-3f) || (c->nm[1] > 0.0f && c->s0[1] < 1e-3f);
}

/* What one lane missed. */
static worst lane_missed(const lane_copy *a, const lane_copy *b)
{
	worst w;
	int32_t k, points = points_of(a);
	memset(&w, 0, sizeof w);
	w.normal = angle_between(a, b);
	w.arm = greater(greater(apart(a->fa, b->fa), apart(a->fb, b->fb)), greater(apart(a->dn, b->dn), apart(a->dt, b->dt)));
	w.mass = fabs((double)(a->tm / b->tm) - 1.0);
	for (k = 0; k < points; ++k) {
		w.separation = greater(w.separation, apart(a->s0[k], b->s0[k]));
		w.arm = greater(w.arm, greater(apart(a->at[k], b->at[k]), apart(a->an[k], b->an[k])));
		w.mass = greater(w.mass, fabs((double)(a->nm[k] / b->nm[k]) - 1.0));
	}
	return w;
}

static void compare(worst *w, const lane_copy *a, const lane_copy *b)
{
	worst one;
	if (!bears(a))
		return;
	if (points_of(a) != points_of(b)) {
		++w->other;
		return;
	}
	one = lane_missed(a, b);
	if (one.normal > w->normal_most || one.separation > SEPARATION) {
		++w->other;
		w->separation_of_others = greater(w->separation_of_others, one.separation);
		return;
	}
	w->separation = greater(w->separation, one.separation);
	w->arm = greater(w->arm, one.arm);
	w->slid += one.arm > ARM;
	w->normal = greater(w->normal, one.normal);
	w->mass = greater(w->mass, one.mass);
}

/* Steps the world, and after every tenth step compares. */
static void run(cn_world *world, int32_t steps, worst *w)
{
	int32_t step, k, total;
	for (step = 1; step <= steps; ++step) {
		int32_t count;
		fixture_step(world, 1);
		if (step % 10 != 0)
			continue;
		count = follow_all(world, &total);
		w->followed += count;
		w->lanes += total;
		must(cn_world_step(world, 0.0f), world, "cn_world_step");
		for (k = 0; k < count; ++k) {
			if (cni_contact_has_lane(cni_contact_at(world, copies[k].contact))) {
				lane_copy now = lane_read(world, copies[k].contact);
				compare(w, &copies[k], &now);
			} else
				++w->other;
		}
	}
}

static void build_pile(cn_world *world, int32_t kinds, float shift)
{
	int32_t k;
	fixture_floor(world, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, -4.5f, 2.0f, 0.1f, 0.5f, 4.0f, 0.6f, 0.0f);
	fixture_box(world, CN_BODY_STATIC, 4.5f, 2.0f, -0.1f, 0.5f, 4.0f, 0.6f, 0.0f);
	for (k = 0; k < 150; ++k) {
		float x = -3.0f + 0.67f * (float)(k % 10) + shift * (float)(k / 10), y = 0.5f + 0.75f * (float)(k / 10);
		if (k % kinds == 0)
			fixture_box(world, CN_BODY_DYNAMIC, x, y, 0.1f * (float)(k % 7), 0.3f, 0.2f, 0.6f, 0.0f);
		else
			fixture_circle(world, CN_BODY_DYNAMIC, x, y, 0.25f, 0.6f, 0.0f);
	}
}

/* Piles of which each kinds-th body is a box, after so many steps. */
static worst piles_run(int32_t kinds, int32_t before, int32_t steps, double normal_most, double arm_most)
{
	worst w;
	int32_t pile;
	memset(&w, 0, sizeof w);
	w.normal_most = normal_most;
	for (pile = 0; pile < PILES; ++pile) {
		cn_world *world = fixture_world(-10.0f, 0);
		build_pile(world, kinds, shifts[pile]);
		fixture_step(world, before);
		run(world, steps, &w);
		cn_world_destroy(world);
	}
	printf("  %d lanes, %d followed; separation %.2g m, arms %.2g m, normal %.2g rad, masses %.2g; others %d, their separation %.2g m\n", (int)w.lanes,
	       (int)w.followed, w.separation, w.arm, w.normal, w.mass, (int)w.other, w.separation_of_others);
	CHECK_LE("arms", w.arm, arm_most, "m");
	CHECK_LE("part of the lanes that are others", (double)w.other / (double)w.followed, OTHER_PART, "");
	CHECK_LE("separation of others", w.separation_of_others, SEPARATION_OF_CORNERS, "m");
	return w;
}

/* A body may have slid as its overlaps were projected: few lanes at rest are off by more than a quarter of the slop, by what those in motion may. */
static void a_pile_at_rest_is_followed(void)
{
	worst w = piles_run(1, 600, 100, NORMAL_OF_FACES, ARM_IN_MOTION);
	CHECK_GE("part of the lanes that is followed", (double)w.followed / (double)w.lanes, 0.9, "");
	CHECK_LE("part of the lanes that slid", (double)w.slid / (double)w.followed, 0.002, "");
	CHECK_LE("masses", w.mass, 1e-2, "");
}

static void a_pile_in_motion_is_followed(void)
{
	worst w = piles_run(3, 0, 300, NORMAL_OF_BALLS, ARM_IN_MOTION);
	double part = (double)w.followed / (double)w.lanes;
	CHECK_GE("part of the lanes that is followed", part, 0.75, "");
	CHECK_LE("... and not all of them are", part, 0.95, "");
}

/* What lies on a turning, climbing platform is at rest in its frame. */
static void what_rides_along_is_followed(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body platform = fixture_box(world, CN_BODY_KINEMATIC, 1000.0f, 0.0f, 0.0f, 3.0f, 0.5f, 0.9f, 0.0f);
	worst w;
	fixture_box(world, CN_BODY_DYNAMIC, 999.0f, 1.0f, 0.0f, 0.5f, 0.5f, 0.9f, 0.0f);
	fixture_box(world, CN_BODY_DYNAMIC, 999.0f, 2.0f, 0.0f, 0.5f, 0.5f, 0.9f, 0.0f);
	fixture_step(world, 120);
	must(cn_body_set_velocity(world, platform, 0.3f, 0.5f, 0.1f), world, "cn_body_set_velocity");
	memset(&w, 0, sizeof w);
	w.normal_most = NORMAL_OF_FACES;
	run(world, 120, &w);
	CHECK_GE("part of the lanes that is followed", (double)w.followed / (double)w.lanes, 0.5, "");
	/* Nothing slides or turns there, so far less is missed than could be. */
	CHECK_LE("separation", w.separation, SEPARATION / 50.0, "m");
	CHECK_LE("normal", w.normal, NORMAL_OF_FACES / 10.0, "rad");
	CHECK_LE("lanes with another manifold", w.other, 0, "of 24");
	cn_world_destroy(world);
}

/* A heavy block of 2 m on a floor, and what slides over it by 14 mm between two looks, without friction. order: which is made first. */
static worst sliders_run(int32_t order, int32_t round, float x, int32_t with_second_foot)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body slider = 0;
	worst w;
	int32_t k;
	fixture_floor(world, 0.0f, 0.0f);
	for (k = 0; k < 2; ++k) {
		if (k == order) {
			cn_body block = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f);
			cn_shape_def def = fixture_shape_def(block, 0.0f, 0.0f);
			def.density_kgpm2 = 100.0f;
			fixture_box_shape(world, &def, 1.0f, 0.5f);
		} else {
			cn_shape_def def;
			slider = fixture_body(world, CN_BODY_DYNAMIC, x, round ? 1.3f : 1.1f, 0.0f);
			def = fixture_shape_def(slider, 0.0f, 0.0f);
			if (round) {
				cn_circle circle = { { 0.0f, 0.0f }, 0.3f };
				must(cn_shape_create_circle(world, &def, &circle, NULL), world, "cn_shape_create_circle");
			} else {
				fixture_box_shape(world, &def, 0.1f, 0.1f);
			}
			if (with_second_foot) {
				def.offset_m.x = 2.0f;
				fixture_box_shape(world, &def, 0.1f, 0.1f);
			}
		}
	}
	fixture_box(world, CN_BODY_STATIC, 2.6f, 0.5f, 0.0f, 1.2f, 0.5f, 0.0f, 0.0f);
	fixture_step(world, 60);
	must(cn_body_set_velocity(world, slider, 0.085f, 0.0f, round ? -0.085f / 0.3f : 0.0f), world, "cn_body_set_velocity");
	memset(&w, 0, sizeof w);
	w.normal_most = NORMAL_OF_FACES;
	run(world, 180, &w);
	cn_world_destroy(world);
	return w;
}

/* Corners and balls take their points along over the whole way: nothing is missed but rounding, and what overlaps change in a step. */
static void points_slide_with_their_corners(void)
{
	int32_t order, round;
	for (order = 0; order < 2; ++order)
		for (round = 0; round < 2; ++round) {
			worst w = sliders_run(order, round, -0.3f, 0);
			printf("  %s, made %s: %d lanes, %d followed, arms %.2g m, masses %.2g, separation %.2g m\n", round ? "ball" : "box", order ? "before the block" : "after it",
			       (int)w.lanes, (int)w.followed, w.arm, w.mass, w.separation);
			CHECK_GE("followed", w.followed, 24, "lanes");
			CHECK_LE("arms", w.arm, 1e-4, "m");
			CHECK_LE("others", w.other, 0, "");
		}
}

/* The first foot of a slider goes over the end of the block, while the second one bears it. */
static void what_slides_off_a_face_is_computed_anew(void)
{
	int32_t order;
	for (order = 0; order < 2; ++order) {
		worst w = sliders_run(order, 0, 0.95f, 1);
		printf("  %d lanes, %d followed, others %d\n", (int)w.lanes, (int)w.followed, (int)w.other);
		CHECK_GE("followed", w.followed, 24, "lanes");
		CHECK_LE("others", w.other, 0, "");
	}
}

/* A ball rolls off the origin of its ground's body, or off the middle of a heavy capsule. Returns by how much it sinks. */
static double sinking(int32_t ground, float speed)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body below, ball;
	cn_shape_def def;
	cn_pose pose;
	float top = ground == 4 ? 0.4f : 0.0f;
	double lowest = 1.0;
	int32_t k;
	if (ground == 4)
		fixture_floor(world, 0.6f, 0.0f);
	below = fixture_body(world, ground == 4 ? CN_BODY_DYNAMIC : ground == 3 ? CN_BODY_KINEMATIC : CN_BODY_STATIC, 0.0f, 0.5f * top, 0.0f);
	def = fixture_shape_def(below, 0.6f, 0.0f);
	def.density_kgpm2 = 1000.0f;
	for (k = -1; k <= 1; ++k) {
		cn_edge edge = { { ground == 1 ? -3.0f : 1.5f * (float)(k - 1), 0.0f }, { ground == 1 ? 3.0f : 1.5f * (float)(k + 1), 0.0f } };
		cn_capsule capsule = { { -3.0f, 0.0f }, { 3.0f, 0.0f }, 0.2f };
		def.offset_m.y = ground == 0 || ground == 3 ? -0.5f : 0.0f;
		if (k == 0 && (ground == 0 || ground == 3))
			fixture_box_shape(world, &def, 3.0f, 0.5f);
		if (ground == 1 ? k == 0 : ground == 2 && k != 0)
			must(cn_shape_create_edge(world, &def, &edge, NULL), world, "cn_shape_create_edge");
		if (k == 0 && ground == 4)
			must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "cn_shape_create_capsule");
	}
	ball = fixture_circle(world, CN_BODY_DYNAMIC, 0.0f, top + 0.2f, 0.2f, 0.6f, 0.0f);
	must(cn_body_set_velocity(world, ball, speed, 0.0f, -speed / 0.2f), world, "cn_body_set_velocity");
	for (k = 0; k < 180; ++k) {
		fixture_step(world, 1);
		must(cn_body_get_pose(world, ball, &pose), world, "cn_body_get_pose");
		lowest = fmin(lowest, (double)pose.position_m.y);
	}
	cn_world_destroy(world);
	return (double)top + 0.2 - lowest;
}

/* Such a point of a body has no arm either, but the body is no circle. */
static void what_rolls_over_a_center_stays_above(void)
{
	static const char *const grounds[] = { "box", "edge", "two edges", "kinematic box", "capsule" };
	int32_t ground, k;
	for (ground = 0; ground < 5; ++ground) {
		double deepest = 0.0;
		for (k = 0; k < 30; ++k)
			deepest = fmax(deepest, sinking(ground, 0.5f * powf(0.8f, (float)k)));
		printf("  %s:\n", grounds[ground]);
		CHECK_LE("sinks by", deepest, SAG_M, "m");
	}
}

static int32_t lanes_followed(cn_world *world)
{
	int32_t total, k, lanes = 0;
	for (k = 0; k < CNI_COLORS; ++k)
		lanes += world->colors[k].lanes;
	total = cni_manifolds_reuse(world, FRAME_S, left);
	return lanes - total;
}

static void what_changes_is_computed_anew(void)
{
	cn_world *world = fixture_world(-10.0f, 0);
	cn_body box;
	cn_shape shape;
	cn_shape_def def;
	cn_material material;
	fixture_floor(world, 0.6f, 0.0f);
	box = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.5f, 0.0f);
	def = fixture_shape_def(box, 0.6f, 0.0f);
	shape = fixture_box_shape(world, &def, 0.5f, 0.5f);
	fixture_step(world, 60);
	printf("  followed at rest: %d\n", (int)lanes_followed(world));
	CHECK(lanes_followed(world) == 1);
	material = def.material;
	material.static_friction = material.dynamic_friction = 0.1f;
	must(cn_shape_set_material(world, shape, &material), world, "cn_shape_set_material");
	printf("  followed after a change of material: %d\n", (int)lanes_followed(world));
	CHECK(lanes_followed(world) == 0);
	fixture_step(world, 2);
	printf("  followed two steps later: %d\n", (int)lanes_followed(world));
	CHECK(lanes_followed(world) == 1);
	must(cn_shape_create_box(world, &def, 0.2f, 0.2f, 0.0f, &shape), world, "cn_shape_create_box");
	must(cn_shape_set_density(world, shape, 3.0f), world, "cn_shape_set_density");
	printf("  followed after a change of the centre of mass: %d\n", (int)lanes_followed(world));
	CHECK(lanes_followed(world) == 0);
	fixture_step(world, 2);
	CHECK_GE("followed two steps later", lanes_followed(world), 1, "");
	must(cn_body_set_pose(world, box, 0.0f, 0.6f, 0.0f), world, "cn_body_set_pose");
	printf("  followed after a jump: %d\n", (int)lanes_followed(world));
	CHECK(lanes_followed(world) == 0);
	fixture_step(world, 60);
	must(cn_body_set_velocity(world, box, 3.0f, 0.0f, 0.0f), world, "cn_body_set_velocity");
	printf("  followed after a kick: %d\n", (int)lanes_followed(world));
	CHECK(lanes_followed(world) == 0);
	cn_world_destroy(world);
}

/* Where few bodies touch anything their records are read, else their poses are brought together first: the same bits. */
static void how_poses_are_read_does_not_matter(void)
{
	int32_t with, k, strangers = 200, base = 8, bodies = base * (base + 1) / 2, differ = 0;
	cn_pose poses[2][64];
	for (with = 0; with < 2; ++with) {
		cn_world *world = fixture_world(-10.0f, 0);
		cn_body list[64 + 200 + 1];
		int32_t count, followed = 0;
		fixture_pyramid(world, base);
		for (k = 0; with && k < strangers; ++k)
			fixture_circle(world, CN_BODY_DYNAMIC, 300.0f + 3.0f * (float)k, 0.0f, 0.5f, 0.5f, 0.0f);
		fixture_step(world, 40);
		must(cn_world_get_bodies(world, list, 64 + 200 + 1, &count), world, "cn_world_get_bodies");
		CHECK(count == 1 + bodies + with * strangers);
		for (k = 0; k < bodies; ++k)
			must(cn_body_get_pose(world, list[1 + k], &poses[with][k]), world, "cn_body_get_pose");
		followed = lanes_followed(world);
		printf("  %s: followed %d lanes of %d bodies\n", with ? "records" : "poses", (int)followed, (int)world->awake_count - 1);
		CHECK(with ? followed < world->awake_count / 2 : followed > world->awake_count / 2);
		cn_world_destroy(world);
	}
	for (k = 0; k < bodies; ++k)
		differ += memcmp(&poses[0][k], &poses[1][k], sizeof poses[0][k]) != 0;
	CHECK_LE("bodies that differ", differ, 0, "");
}

int main(void)
{
	RUN(how_poses_are_read_does_not_matter);
	RUN(a_pile_at_rest_is_followed);
	RUN(a_pile_in_motion_is_followed);
	RUN(what_rides_along_is_followed);
	RUN(points_slide_with_their_corners);
	RUN(what_slides_off_a_face_is_computed_anew);
	RUN(what_rolls_over_a_center_stays_above);
	RUN(what_changes_is_computed_anew);
	return test_end();
}
