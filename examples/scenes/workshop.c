/*
 * examples/scenes/workshop.c - many machines, each alone on its lot: what a game has of vehicles, bridges and cranes. No two of a kind are alike.
 */
#include "scenes/build.h"

#define LOT_WIDTH_M 30.0f
#define LOT_HEIGHT_M 24.0f
#define COLUMNS 10

typedef struct lot {
	scene_run *run;
	float x_m, y_m; /* middle of its ground */
	int32_t index;
} lot;

static cn_body add_part(const lot *l, float x_m, float y_m, float half_width_m, float half_height_m, float density)
{
	cn_body body = scene_body(l->run, CN_BODY_DYNAMIC, l->x_m + x_m, l->y_m + y_m);
	cn_shape_def def = scene_surface(body, density, 0.6f, 0.0f);
	def.filter.group = -1 - l->index;
	scene_box(l->run, &def, half_width_m, half_height_m, 0.0f);
	return body;
}

static void add_load(const lot *l, float x_m, float y_m, float half_m, float density)
{
	cn_body body = scene_body(l->run, CN_BODY_DYNAMIC, l->x_m + x_m, l->y_m + y_m);
	cn_shape_def def = scene_surface(body, density, 0.6f, 0.0f);
	scene_box(l->run, &def, half_m, half_m, 0.0f);
}

/* A row of parts from (x, y) to the right, each pinned to the last, the first to `from` at this anchor. Returns the last. */
static cn_body add_row(const lot *l, cn_body from, cn_vec2 anchor_m, float x_m, float y_m, int32_t count, float half_m, float density)
{
	for (int32_t i = 0; i < count; ++i) {
		cn_body part = add_part(l, x_m + half_m * (float)(2 * i + 1), y_m, half_m, 0.1f, density);
		cn_revolute_def joint = scene_revolute(from, anchor_m, part, scene_vec(-half_m, 0.0f));
		scene_join(l->run, &joint);
		from = part;
		anchor_m = scene_vec(half_m, 0.0f);
	}
	return from;
}

/* Planks between two fixed ends, under boxes of up to 20 times a plank's density. */
static void add_bridge(const lot *l)
{
	int32_t count = 8 + l->index % 9;
	float left = -0.5f * (float)count;
	cn_body last = add_row(l, 0, scene_vec(l->x_m + left, l->y_m + 6.0f), left, 6.0f, count, 0.5f, 1.0f);
	cn_revolute_def joint = scene_revolute(last, scene_vec(0.5f, 0.0f), 0, scene_vec(l->x_m - left, l->y_m + 6.0f));
	scene_join(l->run, &joint);
	for (int32_t i = 0; i < 4; ++i)
		add_load(l, 0.4f * left * (1.0f - 0.66f * (float)i), 8.0f + 0.3f * (float)i, 0.4f, 1.0f + 6.0f * (float)((l->index + i) % 4));
}

/* Links that swing freely. */
static void add_pendulum(const lot *l)
{
	(void)add_row(l, 0, scene_vec(l->x_m, l->y_m + 20.0f), 0.0f, 20.0f, 8 + l->index % 7, 0.5f, 1.0f);
}

/* Welded boards from a wall, to the right (side 1) or to the left (-1). */
static void add_jib(const lot *l, int32_t side, float wall_x_m, int32_t count)
{
	cn_body from = 0;
	for (int32_t i = 0; i < count; ++i) {
		cn_body board = add_part(l, wall_x_m + (float)side * (0.5f + (float)i), 5.0f, 0.5f, 0.1f, 1.0f);
		cn_joint weld;
		cn_fixed_def def;
		cn_fixed_def_init(&def);
		def.base.body_a = from;
		def.base.body_b = board;
		def.base.anchor_a_m = i == 0 ? scene_vec(l->x_m + wall_x_m, l->y_m + 5.0f) : scene_vec(0.5f * (float)side, 0.0f);
		def.base.anchor_b_m = scene_vec(-0.5f * (float)side, 0.0f);
		scene_check(l->run, cn_joint_create_fixed(l->run->world, &def, &weld));
		from = board;
	}
}

/* A heavy box lands on the tips of two jibs at once. */
static void add_jibs(const lot *l)
{
	int32_t count = 3 + l->index % 4;
	add_jib(l, 1, -0.25f - (float)count, count);
	add_jib(l, -1, 0.25f + (float)count, count);
	add_load(l, 0.0f, 7.0f, 0.8f, 20.0f);
}

/* A cart on two driven wheels that drags a chain past boxes. */
static void add_cart(const lot *l)
{
	cn_body chassis = add_part(l, 0.0f, 1.2f, 1.2f, 0.3f, 2.0f);
	for (int32_t side = -1; side <= 1; side += 2) {
		cn_body wheel = scene_body(l->run, CN_BODY_DYNAMIC, l->x_m + 0.9f * (float)side, l->y_m + 0.5f);
		cn_shape_def def = scene_surface(wheel, 1.0f, 0.9f, 0.0f);
		def.filter.group = -1 - l->index;
		scene_circle(l->run, &def, 0.5f);
		scene_join_motor(l->run, chassis, scene_vec(0.9f * (float)side, -0.7f), wheel, scene_vec(0.0f, 0.0f), 1.0f + (float)(l->index % 5), 30.0f);
	}
	(void)add_row(l, chassis, scene_vec(1.2f, 0.0f), 1.2f, 1.2f, 3 + l->index % 5, 0.15f, 1.0f);
	for (int32_t i = 0; i < 4; ++i)
		add_load(l, -4.0f - 1.5f * (float)i, 0.4f, 0.4f, 1.0f);
}

/* Two ropes of links from one beam, a kinematic body that turns. */
static void add_swing(const lot *l)
{
	cn_body_def def;
	cn_body_def_init(&def);
	def.type = CN_BODY_KINEMATIC;
	def.position_m = scene_vec(l->x_m, l->y_m + 12.0f);
	def.angular_velocity_radps = 0.5f;
	cn_body beam = scene_body_with(l->run, &def);
	(void)add_row(l, beam, scene_vec(3.0f, 0.0f), 3.0f, 12.0f, 4, 0.5f, 1.0f);
	(void)add_row(l, beam, scene_vec(-8.0f, 0.0f), -8.0f, 12.0f, 4, 0.5f, 1.0f);
}

void scene_create_workshop(scene_run *run)
{
	static void (*const machines[])(const lot *l) = { add_bridge, add_pendulum, add_jibs, add_cart, add_swing };
	for (int32_t k = 0; k < run->scene->size; ++k) {
		lot l = { run, LOT_WIDTH_M * (float)(k % COLUMNS), LOT_HEIGHT_M * (float)(k / COLUMNS), k };
		cn_shape_def ground = scene_surface(scene_body(run, CN_BODY_STATIC, l.x_m, l.y_m - 0.5f), 1.0f, 0.6f, 0.0f);
		scene_box(run, &ground, 0.45f * LOT_WIDTH_M, 0.5f, 0.0f);
		machines[k % (int32_t)(sizeof machines / sizeof *machines)](&l);
	}
}
