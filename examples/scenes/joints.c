/*
 * examples/scenes/joints.c - scenes that lean on revolute joints: a grid of circles, a long bridge
 * with a load, and stacks of hinged boxes that topple (the scene of the golden hashes).
 */
#include "scenes/build.h"
#include <math.h>

/* ------------------------------------------------------------------ joint grid */

#define GRID_MAX 100

static int32_t grid_is_fixed(int32_t k, int32_t i, int32_t side) { return i == 0 && k >= side / 2 - 3 && k <= side / 2 + 3; }

/* Column k, row i at (k, -i). Neighbours that are both static need no joint and may have none. */
void scene_create_joint_grid(scene_run *run)
{
	cn_body above = 0, left[GRID_MAX] = {0};
	int32_t side = run->scene->size;
	for (int32_t k = 0; k < side; ++k) {
		for (int32_t i = 0; i < side; ++i) {
			int32_t fixed = grid_is_fixed(k, i, side);
			cn_body body = scene_body(run, fixed ? CN_BODY_STATIC : CN_BODY_DYNAMIC, (float)k, (float)-i);
			cn_shape_def def = scene_surface(body, 1.0f, 0.6f, 0.0f);
			def.filter.category = 2;
			def.filter.mask = ~(uint64_t)2;
			scene_circle(run, &def, 0.4f);
			if (i > 0) {
				cn_revolute_def joint = scene_revolute(above, scene_vec(0.0f, -0.5f), body, scene_vec(0.0f, 0.5f));
				scene_join(run, &joint);
			}
			if (k > 0 && !(fixed && grid_is_fixed(k - 1, i, side))) {
				cn_revolute_def joint = scene_revolute(left[i], scene_vec(0.5f, 0.0f), body, scene_vec(-0.5f, 0.0f));
				scene_join(run, &joint);
			}
			above = body;
			left[i] = body;
		}
	}
}

/* ------------------------------------------------------------------ bridge */

#define BRIDGE_LINK_M 0.5f
#define BRIDGE_MAX 200

/* Points on the parabola y = x^2 / 120 - sag, one link apart, from the middle to the right. */
static void bridge_points(cn_vec2 *points, int32_t count)
{
	points[0] = scene_vec(0.0f, 0.0f);
	for (int32_t i = 1; i < count; ++i) {
		double x = (double)points[i - 1].x, slope = x / 60.0;
		double middle = slope + 0.25 / 60.0; /* slope near the middle of the link; sqrt is exact in IEEE 754 */
		double next = x + (double)BRIDGE_LINK_M / sqrt(1.0 + middle * middle);
		points[i] = scene_vec((float)next, (float)(next * next / 120.0));
	}
}

static cn_vec2 bridge_point(const cn_vec2 *half, int32_t half_count, int32_t i)
{
	cn_vec2 p = half[i < half_count ? half_count - i : i - half_count];
	return i < half_count ? scene_vec(-p.x, p.y) : p;
}

static void add_bridge_load(scene_run *run)
{
	for (int32_t i = 0; i < 14; ++i) {
		float x = -26.0f + 4.0f * (float)i;
		cn_body body = scene_body(run, CN_BODY_DYNAMIC, x, 14.0f + (float)(i % 3) * 3.0f);
		cn_shape_def def = scene_surface(body, 1.0f, 0.6f, 0.0f);
		if (i % 2 == 0)
			scene_box(run, &def, 1.2f, 1.0f, 0.0f);
		else
			scene_circle(run, &def, 1.1f);
	}
}

/* The links hang in a curve from two anchors; boxes and balls fall on them. */
void scene_create_bridge(scene_run *run)
{
	cn_vec2 half[BRIDGE_MAX / 2 + 1];
	int32_t count = run->scene->size, half_count = count / 2;
	cn_body previous = 0;
	bridge_points(half, half_count + 1);
	for (int32_t i = 0; i < count; ++i) {
		cn_vec2 a = bridge_point(half, half_count, i), b = bridge_point(half, half_count, i + 1);
		cn_body_def body_def;
		cn_body_def_init(&body_def);
		body_def.position_m = scene_vec(0.5f * (a.x + b.x), 0.5f * (a.y + b.y));
		float s = (b.y - a.y) / BRIDGE_LINK_M;
		body_def.angle_rad = s + s * s * s / 6.0f + 0.075f * s * s * s * s * s; /* asin to 2 mrad: joints close the rest */
		cn_body link = scene_body_with(run, &body_def);
		cn_shape_def def = scene_surface(link, 20.0f, 0.6f, 0.0f);
		scene_box(run, &def, 0.5f * BRIDGE_LINK_M, 0.15f, 0.0f);
		cn_revolute_def joint =
			scene_revolute(previous, i == 0 ? a : scene_vec(0.5f * BRIDGE_LINK_M, 0.0f), link, scene_vec(-0.5f * BRIDGE_LINK_M, 0.0f));
		scene_join(run, &joint);
		previous = link;
	}
	cn_revolute_def last = scene_revolute(previous, scene_vec(0.5f * BRIDGE_LINK_M, 0.0f), 0, bridge_point(half, half_count, count));
	scene_join(run, &last);
	add_bridge_load(run);
}

/* ------------------------------------------------------------------ falling hinges */

/* Columns of slightly rounded boxes, each second one hinged by its right corner to the one below, with
   limits. Every row stands a little farther to the right, so that the columns topple onto each other. */
static void add_hinge_column(scene_run *run, float x_m, int32_t rows)
{
	const float half = 0.25f, radius = 0.025f, lean = 0.06f;
	cn_body below = 0;
	for (int32_t i = 0; i < rows; ++i) {
		cn_body body = scene_body(run, CN_BODY_DYNAMIC, x_m + lean * (float)i, half + 2.0f * half * (float)i);
		cn_shape_def def = scene_surface(body, 1.0f, 0.3f, 0.0f);
		scene_box(run, &def, half - radius, half - radius, radius);
		if (i % 2 == 1) {
			cn_revolute_def joint = scene_revolute(below, scene_vec(half, half), body, scene_vec(half - lean, -half));
			joint.base.flags = CN_JOINT_LIMIT;
			joint.lower_angle_rad = -0.3f * SCENE_PI;
			joint.upper_angle_rad = 0.1f * SCENE_PI;
			scene_join(run, &joint);
		}
		below = body;
	}
}

void scene_create_hinges(scene_run *run)
{
	const int32_t columns = 4;
	cn_shape_def ground = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, -1.0f), 1.0f, 0.6f, 0.0f);
	scene_box(run, &ground, 30.0f, 1.0f, 0.0f);
	for (int32_t j = 0; j < columns; ++j)
		add_hinge_column(run, 2.5f * (float)j - 0.5f * 2.5f * (float)(columns - 1), run->scene->size);
}
