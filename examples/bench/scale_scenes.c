/*
 * examples/bench/scale_scenes.c - the field that is stirred and the pyramids that stand, of any number of bodies.
 */
#include "bench/scale_scenes.h"
#include "scenes/build.h"
#include <string.h>

/* ------------------------------------------------------------------ cells */

typedef struct cells {
	float width_m, height_m; /* of one */
	int32_t columns, rows;
} cells;

/* As many rows as make the whole no higher than wide. */
static cells cells_for(int32_t bodies, int32_t per_cell, float width_m, float height_m)
{
	int32_t count = (bodies + per_cell - 1) / per_cell;
	cells c = {width_m, height_m, count, 1};
	for (int32_t rows = 2; rows <= count; ++rows) {
		int32_t columns = (count + rows - 1) / rows;
		if ((float)rows * height_m > (float)columns * width_m)
			break;
		c.columns = columns;
		c.rows = rows;
	}
	return c;
}

/* Lower left corner. */
static cn_vec2 cell_corner(const cells *c, int32_t index)
{
	return scene_vec((float)(index % c->columns) * c->width_m, (float)(index / c->columns) * c->height_m);
}

/* A shelf under each row, a roof, and walls at both ends. */
static void add_shelves(scene_run *run, const cells *c)
{
	float right = (float)c->columns * c->width_m, top = (float)c->rows * c->height_m;
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_STATIC, 0.0f, 0.0f), 1.0f, 0.6f, 0.0f);
	for (int32_t i = 0; i <= c->rows; ++i) {
		float y = (float)i * c->height_m;
		scene_edge(run, &def, scene_vec(0.0f, y), scene_vec(right, y));
	}
	scene_edge(run, &def, scene_vec(0.0f, 0.0f), scene_vec(0.0f, top));
	scene_edge(run, &def, scene_vec(right, 0.0f), scene_vec(right, top));
}

static void describe(scene *out, const char *name, void (*create)(scene_run *run), int32_t bodies, const cells *c)
{
	memset(out, 0, sizeof *out);
	out->name = name;
	out->title = name;
	out->create = create;
	out->size = bodies;
	out->gravity_mps2 = scene_vec(0.0f, -10.0f);
	out->bounds_m.upper_m = scene_vec((float)c->columns * c->width_m, (float)c->rows * c->height_m);
	out->view_m = out->bounds_m;
}

/* ------------------------------------------------------------------ field */

/* A cell, 6 m by 7 m: the paddle lies level at the start, four rows of six bodies below it and three above. */
enum { FIELD_COLUMNS = 6, FIELD_ROWS_BELOW = 4, FIELD_ROWS = 7, FIELD_BODIES = FIELD_COLUMNS * FIELD_ROWS };
#define FIELD_ROW_M 0.75f
#define PADDLE_Y_M 3.15f

static cells field_cells(int32_t bodies) { return cells_for(bodies, FIELD_BODIES, 6.0f, 7.0f); }

/* Clear of the shelf by more than the largest body, so that none stays jammed. Neighbours turn against each other, and
   at different speeds, so that they do not keep time. */
static void add_paddle(scene_run *run, const cells *c, int32_t cell)
{
	cn_vec2 corner = cell_corner(c, cell);
	float speed_radps = 1.2f + 0.37f * (float)(cell % 5);
	cn_body_def body_def;
	cn_body_def_init(&body_def);
	body_def.type = CN_BODY_KINEMATIC;
	body_def.position_m = scene_vec(corner.x + 0.5f * c->width_m, corner.y + PADDLE_Y_M);
	body_def.angular_velocity_radps = cell % 2 == 0 ? speed_radps : -speed_radps;
	cn_shape_def def = scene_surface(scene_body_with(run, &body_def), 1.0f, 0.6f, 0.0f);
	scene_box(run, &def, 1.9f, 0.15f, 0.0f);
}

/* From 0.2 m to 0.35 m, in no order (multiplicative hashing: Knuth, 1973). */
static float half_size_m(int32_t index) { return 0.2f + 0.15f * (float)((uint32_t)index * 2654435761u >> 8) / 16777216.0f; }

static void add_field_body(scene_run *run, const cells *c, int32_t index)
{
	cn_vec2 corner = cell_corner(c, index / FIELD_BODIES);
	int32_t column = index % FIELD_COLUMNS, row = index % FIELD_BODIES / FIELD_COLUMNS;
	float x = corner.x + (float)column + 0.5f, y = corner.y + 0.4f + FIELD_ROW_M * (float)row;
	if (row >= FIELD_ROWS_BELOW)
		y = corner.y + PADDLE_Y_M + 0.6f + FIELD_ROW_M * (float)(row - FIELD_ROWS_BELOW);
	float half_m = half_size_m(index);
	cn_shape_def def = scene_surface(scene_body(run, CN_BODY_DYNAMIC, x, y), 1.0f, 0.3f, 0.2f);
	if (index % 2 == 0)
		scene_box(run, &def, half_m, half_m, 0.0f);
	else
		scene_circle(run, &def, half_m);
}

static void create_field(scene_run *run)
{
	int32_t bodies = run->scene->size;
	cells c = field_cells(bodies);
	add_shelves(run, &c);
	for (int32_t i = 0; i < bodies; ++i) {
		if (i % FIELD_BODIES == 0)
			add_paddle(run, &c, i / FIELD_BODIES);
		add_field_body(run, &c, i);
	}
}

void scale_field(scene *out, int32_t bodies)
{
	cells c = field_cells(bodies);
	describe(out, "field", create_field, bodies, &c);
}

/* ------------------------------------------------------------------ piles */

enum { PILE_BASE = 10, PILE_BODIES = PILE_BASE * (PILE_BASE + 1) / 2 };

static cells pile_cells(int32_t bodies) { return cells_for(bodies, PILE_BODIES, 11.0f, 11.0f); }

/* Row by row from the shelf up, bodies of them at most. */
static void add_pile(scene_run *run, cn_vec2 corner, int32_t bodies)
{
	int32_t made = 0;
	for (int32_t row = 0; row < PILE_BASE; ++row) {
		for (int32_t i = row; i < PILE_BASE && made < bodies; ++i, ++made)
			scene_simple_box(run, corner.x + 1.0f + (float)i - 0.5f * (float)row, corner.y + 0.5f + (float)row, 0.5f, 0.5f);
	}
}

static void create_piles(scene_run *run)
{
	cells c = pile_cells(run->scene->size);
	add_shelves(run, &c);
	for (int32_t made = 0; made < run->scene->size; made += PILE_BODIES)
		add_pile(run, cell_corner(&c, made / PILE_BODIES), run->scene->size - made);
}

void scale_piles(scene *out, int32_t bodies)
{
	cells c = pile_cells(bodies);
	describe(out, "piles", create_piles, bodies, &c);
	out->flags = SCENE_STANDS;
}
