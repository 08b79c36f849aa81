/*
 * test/model/turn_reach_test.c - cni_body_turn_reach bounds how far turning moves the shapes of a body. It is what the boxes ahead, the
 * narrowphase and continuous collision ask.
 *
 * If a test here fails, look first in: model/body.c (measure_shapes).
 */
#include "world/fixture.h"
#include "model/world.h"

enum { WHEEL, TWO_DISCS, CAPSULE, BOX, TRIANGLE, DISC_AND_BOX, KINDS };

static void disc(cn_world *world, const cn_shape_def *def, float x, float y, float radius)
{
	cn_circle circle;
	circle.center_m.x = x;
	circle.center_m.y = y;
	circle.radius_m = radius;
	must(cn_shape_create_circle(world, def, &circle, NULL), world, "disc");
}

static cn_body turning_body(cn_world *world, int32_t kind)
{
	static const cn_capsule capsule = { { -0.3f, 0.1f }, { 0.5f, 0.2f }, 0.25f };
	static const cn_polygon triangle = { 3, 0.15f, { { -0.5f, -0.2f }, { 0.7f, -0.1f }, { 0.1f, 0.4f } } };
	cn_body body = fixture_body(world, CN_BODY_DYNAMIC, 0.0f, 0.0f, 0.0f);
	cn_shape_def def = fixture_shape_def(body, 0.5f, 0.0f);
	switch (kind) {
	case WHEEL: disc(world, &def, 0.37f, -0.21f, 0.5f); break;
	case TWO_DISCS:
		disc(world, &def, 0.6f, 0.3f, 0.5f);
		disc(world, &def, -0.8f, 0.1f, 0.2f);
		break;
	case CAPSULE: must(cn_shape_create_capsule(world, &def, &capsule, NULL), world, "capsule"); break;
	case BOX: fixture_box_shape(world, &def, 0.4f, 0.2f); break;
	case TRIANGLE: must(cn_shape_create_polygon(world, &def, &triangle, NULL), world, "triangle"); break;
	default:
		disc(world, &def, 0.6f, 0.3f, 0.5f);
		fixture_box_shape(world, &def, 0.4f, 0.2f);
	}
	return body;
}

static cn_aabb turned_bounds(cn_world *world, cn_body body, float angle)
{
	cn_aabb all = { { INFINITY, INFINITY }, { -INFINITY, -INFINITY } };
	cn_shape shapes[2];
	cn_vec2 c;
	int32_t k, count;
	must(cn_body_set_pose(world, body, 0.0f, 0.0f, angle), world, "pose");
	must(cn_body_get_shapes(world, body, shapes, 2, &count), world, "shapes");
	must(cn_body_get_center(world, body, &c), world, "centre");
	for (k = 0; k < count; ++k) {
		cn_aabb one;
		must(cn_shape_get_aabb(world, shapes[k], &one), world, "box");
		all.lower_m.x = fminf(all.lower_m.x, one.lower_m.x - c.x);
		all.lower_m.y = fminf(all.lower_m.y, one.lower_m.y - c.y);
		all.upper_m.x = fmaxf(all.upper_m.x, one.upper_m.x - c.x);
		all.upper_m.y = fmaxf(all.upper_m.y, one.upper_m.y - c.y);
	}
	return all;
}

/* cni_body_turn_reach: what is asked of how far turning moves a body, wherever a step looks ahead. */
static void turning_moves_shapes_by_their_swing(void)
{
	cn_world *world = fixture_world(0.0f, 0);
	uint32_t random = 271828u;
	double beyond = -1.0, wheel = 0.0;
	int32_t kind, k;
	for (kind = 0; kind < KINDS; ++kind) {
		cn_body body = turning_body(world, kind);
		float swing = cni_body_turn_reach(cni_body_at(world, cni_handles_find(&world->body_handles, body))), most = 0.0f;
		for (k = 0; k < 300; ++k) {
			float from = fixture_random(&random, -3.0f, 3.0f), turn = fixture_random(&random, -1.0f, 1.0f), moved;
			cn_aabb a = turned_bounds(world, body, from), b = turned_bounds(world, body, from + turn);
			moved = fmaxf(fmaxf(fabsf(a.lower_m.x - b.lower_m.x), fabsf(a.lower_m.y - b.lower_m.y)), fmaxf(fabsf(a.upper_m.x - b.upper_m.x), fabsf(a.upper_m.y - b.upper_m.y)));
			beyond = greater(beyond, (double)moved - (double)fabsf(turn) * (double)swing);
			most = fmaxf(most, moved / fabsf(turn));
		}
		printf("  kind %d: swing %.3f m, %.3f seen\n", (int)kind, (double)swing, (double)most);
		if (kind == WHEEL)
			wheel = (double)swing;
	}
	CHECK_LE("movement beyond turn x swing", beyond, 4e-6, "m"); /* CNI_BODY_ROUNDING */
	CHECK_LE("swing of a disc about its centre", wheel, 0.0, "m");
	cn_world_destroy(world);
}

int main(int argc, char **argv)
{
	test_begin(argc, argv);
	RUN(turning_moves_shapes_by_their_swing);
	return test_end();
}
