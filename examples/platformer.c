/* examples/platformer.c - a small platformer without a window: a stair, a slope, a crate to push, a moving platform over a pit, a
   platform to jump through. A script plays it; what happens is printed, and drawn if a file is named. */
#include "cairn.h"
#include "demo/draw.h"
#include "demo/palette.h"
#include "demo/png.h"
#include <stdio.h>
#include <string.h>

#define DT (1.0f / 60.0f)

/* ---- the character: up to hero_update ---- */

typedef struct keys { float run; int jump, drop; } keys; /* -1 to 1; held */

typedef struct hero {
	cn_mover_def def;
	cn_mover mover;
	float coyote_s;  /* may still jump for this long after walking off an edge */
	float wish_s;    /* a jump that was pressed too early is remembered for this long */
	int jump_was;
} hero;

static void hero_init(hero *h, cn_vec2 position)
{
	memset(h, 0, sizeof *h);
	cn_mover_def_init(&h->def); /* a capsule 1.6 m high, steps of 0.3 m, slopes of 50 degrees, 200 N */
	h->def.gravity_scale = 2.0f;
	h->mover.position_m = position;
}

static void hero_update(cn_world *world, hero *h, keys k)
{
	cn_vec2 *v = &h->mover.velocity_mps;
	int grounded = (h->mover.flags & CN_MOVER_ON_GROUND) != 0;
	float change = 5.0f * k.run - v->x, most = (grounded ? 60.0f : 20.0f) * DT; /* a run of 5 m/s */
	v->x += change > most ? most : change < -most ? -most : change;
	h->coyote_s = grounded ? 0.1f : h->coyote_s - DT;
	h->wish_s = k.jump && !h->jump_was ? 0.1f : h->wish_s - DT;
	h->jump_was = k.jump;
	if (h->wish_s > 0.0f && h->coyote_s > 0.0f) {
		v->y = 8.5f; /* 1.8 m high */
		h->wish_s = h->coyote_s = 0.0f;
	}
	if (!grounded && !k.jump && v->y > 3.0f)
		v->y = 3.0f; /* released early: a low jump */
	h->def.flags = k.drop ? CN_MOVER_DROP : 0;
	cn_mover_move(world, &h->def, DT, &h->mover);
}

static cn_body block(cn_world *world, int type, uint32_t flags, cn_vec2 at, float half_width, float half_height)
{
	cn_body_def bd;
	cn_shape_def sd;
	cn_body body = 0;
	cn_body_def_init(&bd);
	bd.type = type;
	bd.position_m = at;
	cn_body_create(world, &bd, &body);
	cn_shape_def_init(&sd);
	sd.body = body;
	sd.flags = flags;
	cn_shape_create_box(world, &sd, half_width, half_height, 0.0f, NULL);
	return body;
}

/* Ground from right to left: level, a pit, level, a slope, level, a wall. */
static const cn_vec2 ground[10] = { { 52, 8 }, { 52, 2 }, { 36, 2 }, { 36, -2 }, { 24, -2 },
	{ 24, 2 }, { 18, 2 }, { 12, 0 }, { -3, 0 }, { -3, 6 } };

static void level_make(cn_world *world, cn_body *lift, cn_body *crate)
{
	cn_shape_def sd;
	cn_chain chain = { ground, 10, 0 };
	cn_body base = block(world, CN_BODY_STATIC, 0, (cn_vec2){ 5.0f, 0.12f }, 2.0f, 0.12f);
	block(world, CN_BODY_STATIC, 0, (cn_vec2){ 5.0f, 0.37f }, 1.0f, 0.13f);
	block(world, CN_BODY_STATIC, CN_SHAPE_ONE_WAY, (cn_vec2){ 43.0f, 3.4f }, 2.5f, 0.1f);
	*lift = block(world, CN_BODY_KINEMATIC, 0, (cn_vec2){ 25.6f, 1.8f }, 1.5f, 0.2f);
	*crate = block(world, CN_BODY_DYNAMIC, 0, (cn_vec2){ 20.5f, 2.6f }, 0.6f, 0.6f);
	cn_shape_def_init(&sd);
	sd.body = base;
	sd.offset_m = (cn_vec2){ -5.0f, -0.12f };
	cn_shape_create_chain(world, &sd, &chain, NULL);
}

/* What a player would do: waits for the platform, rides it, jumps on the last one and drops through it. */
static keys play(const hero *h, float lift_x)
{
	keys k = { 1.0f, 0, 0 };
	float x = h->mover.position_m.x, y = h->mover.position_m.y;
	if ((x > 22.5f && x < 23.2f && lift_x > 26.2f) || (x > lift_x && x < 36.0f && y > 2.0f && lift_x < 33.8f))
		k.run = 0.0f;
	k.jump = (x > 34.6f && x < 36.0f && y > 2.0f) || (x > 40.0f && x < 42.0f && y < 4.5f);
	k.drop = x > 44.0f && x < 45.5f;
	return k;
}

static int picture(const char *path, const cn_world *world, const cn_vec2 *trail, int count)
{
	static palette colors;
	static uint8_t pixels[1140 * 260];
	const cn_aabb box = { { -4.0f, -4.0f }, { 53.0f, 9.0f } };
	canvas c;
	if (!canvas_open(&c, 1140, 260))
		return 0;
	const draw_view view = draw_fit(&c, &box);
	draw_world(&c, &view, world, DRAW_SHOW_BODIES);
	for (int k = 0; k < count; k += 6) {
		const float x = (trail[k].x - view.lower_m.x) * view.scale, y = 260.0f - (trail[k].y - view.lower_m.y) * view.scale;
		const float half = k % 36 == 0 ? 0.5f * view.scale : 0.0f, radius = k % 36 == 0 ? 0.3f * view.scale : 1.5f;
		canvas_capsule(&c, (canvas_point){ x, y - half }, (canvas_point){ x, y + half }, radius, draw_colors[DRAW_BODY], draw_colors[DRAW_OUTLINE], 1.0f);
	}
	palette_make(&colors, draw_colors, DRAW_COLORS);
	palette_apply(&colors, &c, pixels);
	canvas_close(&c);
	return png_write(path, 1140, 260, pixels, colors.rgb, colors.count);
}

int main(int argc, char **argv)
{
	static cn_vec2 trail[1200];
	cn_world_def wd;
	cn_world *world;
	cn_body lift, crate, ground_was = 0;
	cn_pose lift_at, crate_at;
	hero h;
	int step = 0;
	cn_world_def_init(&wd);
	if (cn_world_create(&wd, &world) != CN_OK)
		return 1;
	level_make(world, &lift, &crate);
	hero_init(&h, (cn_vec2){ 0.0f, 1.0f });
	for (; step < 1200 && h.mover.position_m.x < 50.0f; ++step) {
		cn_body_set_velocity(world, lift, step / 264 % 2 ? -2.0f : 2.0f, 0.0f, 0.0f);
		cn_world_step(world, DT);
		cn_body_get_pose(world, lift, &lift_at);
		cn_body_get_pose(world, crate, &crate_at);
		hero_update(world, &h, play(&h, lift_at.position_m.x));
		trail[step] = h.mover.position_m;
		if (h.mover.ground_body == ground_was && step % 60 != 0)
			continue;
		ground_was = h.mover.ground_body;
		printf("%5.2f s: at (%5.2f, %5.2f) %s; crate at %5.2f\n", step / 60.0, (double)trail[step].x, (double)trail[step].y,
			ground_was == lift ? "on the platform" : ground_was ? "on the ground" : "in the air", (double)crate_at.position_m.x);
	}
	const int drawn = argc < 2 || picture(argv[1], world, trail, step);
	cn_world_destroy(world);
	return !drawn || h.mover.position_m.x < 50.0f;
}
