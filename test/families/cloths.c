/*
 * test/families/cloths.c - cloths and nets of rods, pins and springs: hung, draped, jumped, falling.
 */
#include "families.h"

#include <math.h>

#define COLUMNS_MAX 30
#define ROWS_MAX 20

typedef struct sheet {
	int32_t columns, rows;
	double spacing, x, y;                 /* of its top left node */
	int32_t node[ROWS_MAX][COLUMNS_MAX];
	double missing;                       /* share of links that are torn */
} sheet;

enum { LINK_ROD, LINK_PIN, LINK_SPRING };

typedef struct sheet_link {
	int kind;
	double hertz, damping, give;
} sheet_link;

static sheet pick_sheet(scene *s, int32_t columns_max, int32_t rows_max)
{
	sheet sh;
	sh.columns = pick_int_log(s, 8, columns_max);
	sh.rows = pick_int_log(s, 6, rows_max);
	sh.spacing = pick(s, 0.25, 1.0);
	sh.missing = chance(s, 0.3) ? 0.1 : 0.0;
	sh.x = -0.5 * sh.spacing * (double)(sh.columns - 1);
	sh.y = 1.0 + sh.spacing * (double)sh.rows;
	return sh;
}

static double node_x(const sheet *sh, int32_t column) { return sh->x + sh->spacing * (double)column; }
static double node_y(const sheet *sh, int32_t row) { return sh->y - sh->spacing * (double)row; }

static void add_nodes(scene *s, sheet *sh)
{
	int32_t i, k;
	for (i = 0; i < sh->rows; ++i)
		for (k = 0; k < sh->columns; ++k)
			sh->node[i][k] = add_disc(s, CN_BODY_DYNAMIC, node_x(sh, k), node_y(sh, i), 0.2 * sh->spacing);
}

static void add_link(scene *s, const sheet *sh, const sheet_link *link, int32_t row, int32_t column, int32_t row_2, int32_t column_2)
{
	double ax = node_x(sh, column), ay = node_y(sh, row), bx = node_x(sh, column_2), by = node_y(sh, row_2);
	int32_t a = sh->node[row][column], b = sh->node[row_2][column_2];
	if (chance(s, sh->missing))
		return;
	if (link->kind == LINK_PIN)
		add_pin(s, a, b, 0.5 * (ax + bx), 0.5 * (ay + by));
	else if (link->kind == LINK_ROD)
		add_rod(s, a, b, ax, ay, bx, by);
	else
		add_spring(s, a, b, ax, ay, bx, by, link->hertz, link->damping, link->give);
}

static void add_links(scene *s, const sheet *sh, const sheet_link *link, int diagonals)
{
	int32_t i, k;
	for (i = 0; i < sh->rows; ++i)
		for (k = 0; k < sh->columns; ++k) {
			if (k > 0)
				add_link(s, sh, link, i, k - 1, i, k);
			if (i > 0)
				add_link(s, sh, link, i - 1, k, i, k);
			if (diagonals && i > 0 && k > 0)
				add_link(s, sh, link, i - 1, k - 1, i, k);
		}
}

/* Pins 2 to all nodes of the top row to the world, evenly spread, both corners among them. */
static void hang(scene *s, const sheet *sh)
{
	int32_t held = chance(s, 0.3) ? 2 : pick_int(s, 2, sh->columns), k;
	for (k = 0; k < held; ++k) {
		int32_t column = (int32_t)lround((double)k * (double)(sh->columns - 1) / (double)(held - 1));
		add_pin(s, WORLD, sh->node[0][column], node_x(sh, column), node_y(sh, 0));
	}
}

/* A third swings: it starts with a speed that grows downwards. */
static void swing(scene *s, const sheet *sh)
{
	double speed = chance(s, 0.33) ? pick(s, 1.0, 5.0) : 0.0;
	int32_t i, k;
	for (i = 1; speed > 0.0 && i < sh->rows; ++i)
		for (k = 0; k < sh->columns; ++k)
			set_velocity(s, sh->node[i][k], speed * (double)i / (double)sh->rows, 0.0, 0.0);
}

static void hung_sheet(scene *s, const sheet_link *link, int32_t columns_max, int32_t rows_max, int diagonals)
{
	sheet sh = pick_sheet(s, columns_max, rows_max);
	s->group = chance(s, 0.5) ? -1 : 0;
	add_nodes(s, &sh);
	add_links(s, &sh, link, diagonals);
	hang(s, &sh);
	swing(s, &sh);
	s->group = 0;
	add_floor(s);
}

/* Discs in a square grid of 8 x 6 to 30 x 20, 0.25 to 1 m apart, rods between neighbours; half with diagonals in one
   direction, a third with 10% of the rods missing; hung from 2 to all of the top row; nodes collide in half of them. */
static void build_cloth(scene *s)
{
	sheet_link link = { LINK_ROD, 0.0, 0.0, 0.0 };
	int diagonals = chance(s, 0.5);
	hung_sheet(s, &link, COLUMNS_MAX, ROWS_MAX, diagonals);
}

/* The same without diagonals, 8 x 6 to 18 x 12: neighbours are pinned half way. */
static void build_pin_net(scene *s)
{
	sheet_link link = { LINK_PIN, 0.0, 0.0, 0.0 };
	hung_sheet(s, &link, 18, 12, 0);
}

/* The same, of springs of 2 to 20 Hz with damping 0 to 1; half may stretch and shrink by 20% at most. */
static void build_spring_net(scene *s)
{
	sheet_link link = { LINK_SPRING, 0.0, 0.0, 0.0 };
	int diagonals = chance(s, 0.5);
	link.hertz = pick_log(s, 2.0, 20.0);
	link.damping = pick(s, 0.0, 1.0);
	link.give = chance(s, 0.5) ? 0.2 : 0.0;
	hung_sheet(s, &link, 18, 12, diagonals);
}

/* A sheet 8 to 20 wide and 1 to 4 deep falls level onto a disc and the floor. */
static void drape(scene *s)
{
	sheet_link link = { LINK_ROD, 0.0, 0.0, 0.0 };
	sheet sh = pick_sheet(s, 20, 8);
	double radius = pick(s, 1.0, 3.0);
	int diagonals = chance(s, 0.5);
	sh.rows = pick_int(s, 1, 4);
	sh.y = 2.0 * radius + sh.spacing * (double)sh.rows + pick(s, 0.0, 2.0);
	s->group = -1;
	add_nodes(s, &sh);
	add_links(s, &sh, &link, diagonals);
	s->group = 0;
	add_disc(s, CN_BODY_STATIC, pick(s, -1.0, 1.0), radius, radius);
}

/* A hung sheet is jumped by a disc of 1 to 1000 times a node's mass at 2 to 20 m/s. */
static void strike(scene *s)
{
	sheet_link link = { LINK_ROD, 0.0, 0.0, 0.0 };
	sheet sh = pick_sheet(s, 16, 14);
	double node_mass = PI * 0.04 * sh.spacing * sh.spacing, radius = pick(s, 0.3, 1.0);
	double height, speed;
	int32_t ball;
	s->group = -1;
	add_nodes(s, &sh);
	add_links(s, &sh, &link, 0);
	hang(s, &sh);
	s->group = 0;
	height = node_y(&sh, sh.rows - 1) + 0.5 * sh.spacing * (double)sh.rows;
	set_mass(s, node_mass * pick_log(s, 1.0, 1000.0), PI * radius * radius);
	ball = add_disc(s, CN_BODY_DYNAMIC, sh.x - radius - 1.0, height, radius);
	speed = pick(s, 2.0, 20.0);
	set_velocity(s, ball, speed, 2.0, 0.0);
}

/* A sheet falls freely onto the floor, turning. */
static void fall(scene *s)
{
	sheet_link link = { LINK_ROD, 0.0, 0.0, 0.0 };
	sheet sh = pick_sheet(s, 16, 12);
	double spin = pick(s, -1.0, 1.0);
	int diagonals = chance(s, 0.5);
	int32_t i, k;
	s->group = chance(s, 0.5) ? -1 : 0;
	add_nodes(s, &sh);
	add_links(s, &sh, &link, diagonals);
	for (i = 0; i < sh.rows; ++i)
		for (k = 0; k < sh.columns; ++k)
			set_velocity(s, sh.node[i][k], -spin * (node_y(&sh, i) - sh.y), spin * node_x(&sh, k), spin);
	s->group = 0;
}

/* A cloth of rods draped over a fixed disc, jumped by a heavy one, or falling onto the floor; friction 0 to 1. */
static void build_cloth_hit(scene *s)
{
	int32_t kind = pick_int(s, 0, 2);
	s->friction = pick(s, 0.0, 1.0);
	if (kind == 0)
		drape(s);
	else if (kind == 1)
		strike(s);
	else
		fall(s);
	s->density = 1.0;
	add_floor(s);
}

const family cloth_families[] = {
	{ "cloth", build_cloth, 0 },
	{ "pin_net", build_pin_net, 0 },
	{ "spring_net", build_spring_net, SCENE_NO_ENERGY },
	{ "cloth_hit", build_cloth_hit, 0 },
};
const int32_t cloth_family_count = FAMILY_COUNT(cloth_families);
