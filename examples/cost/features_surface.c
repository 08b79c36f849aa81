/*
 * examples/cost/features_surface.c - materials, sensors, one-way platforms, edges and chains (cost.h).
 */
#include "cost/cost.h"

#define GROUND_POINTS 32
#define FAR_POINTS 100

/* ------------------------------------------------------------------ materials */

static void change_material(cost_world *w, cn_shape shape, float restitution, float rolling_m, float tangent_mps)
{
	cn_material material;
	scene_check(&w->run, cn_shape_get_material(w->run.world, shape, &material));
	material.restitution = restitution;
	material.rolling_resistance = rolling_m;
	material.tangent_speed_mps = tangent_mps;
	scene_check(&w->run, cn_shape_set_material(w->run.world, shape, &material));
}

static void set_restitution(cost_world *w, cn_shape shape) { change_material(w, shape, 0.5f, 0.0f, 0.0f); }
static void set_rolling(cost_world *w, cn_shape shape) { change_material(w, shape, 0.0f, 0.01f, 0.0f); }
static void set_conveyor(cost_world *w, cn_shape shape) { change_material(w, shape, 0.0f, 0.0f, 0.2f); }

/* ------------------------------------------------------------------ sensors, one-way platforms */

static void make_sensor(cost_world *w, cn_shape shape)
{
	if (w->form == COST_UNUSED)
		scene_check(&w->run, cn_shape_set_flags(w->run.world, shape, CN_SHAPE_SENSOR));
}

/* A static box around the middle of the drum; used: with the flag that is the feature's parameter. */
static void build_middle(cost_world *w, float half_width_m, float half_height_m)
{
	cn_body body = scene_body(&w->run, CN_BODY_STATIC, 0.0f, 0.0f);
	cn_shape_def surface = scene_surface(body, 0.0f, 0.6f, 0.0f);
	surface.flags = w->form == COST_USED ? (uint32_t)w->feature->parameter : 0u;
	scene_box(&w->run, &surface, half_width_m, half_height_m, 0.0f);
}

static void build_sensor(cost_world *w)
{
	if (w->form == COST_USED)
		build_middle(w, 18.0f, 18.0f);
}

static void make_one_way(cost_world *w, cn_shape shape)
{
	if (w->form == COST_UNUSED)
		scene_check(&w->run, cn_shape_set_flags(w->run.world, shape, CN_SHAPE_ONE_WAY));
}

static void build_one_way(cost_world *w)
{
	if (w->form >= COST_PLAIN)
		build_middle(w, 6.0f, 0.2f);
}

/* ------------------------------------------------------------------ edges and chains */

/* Clockwise around the inside of the drum: what is solid lies outside. */
static void list_ground(cn_vec2 points[GROUND_POINTS])
{
	const float half = 11.3f, way = 8.0f * half / (float)GROUND_POINTS;
	for (int32_t i = 0; i < GROUND_POINTS; ++i) {
		float along = -half + way * (float)(i % (GROUND_POINTS / 4));
		switch (i / (GROUND_POINTS / 4)) {
		case 0: points[i] = scene_vec(-half, along); break;
		case 1: points[i] = scene_vec(along, half); break;
		case 2: points[i] = scene_vec(half, -along); break;
		default: points[i] = scene_vec(-along, -half); break;
		}
	}
}

static void add_edges(cost_world *w)
{
	cn_vec2 points[GROUND_POINTS];
	cn_shape_def surface = scene_surface(w->drum, 0.0f, 0.6f, 0.0f);
	list_ground(points);
	for (int32_t i = 0; i < GROUND_POINTS; ++i)
		scene_edge(&w->run, &surface, points[i], points[(i + 1) % GROUND_POINTS]);
}

static void build_edges(cost_world *w)
{
	if (w->form == COST_UNUSED) {
		cn_body body = scene_body(&w->run, CN_BODY_STATIC, 300.0f, 0.0f);
		cn_shape_def surface = scene_surface(body, 0.0f, 0.6f, 0.0f);
		for (int32_t i = 0; i < FAR_POINTS; ++i)
			scene_edge(&w->run, &surface, scene_vec((float)i, 0.0f), scene_vec((float)i + 1.0f, 0.0f));
	}
	if (w->form == COST_USED)
		add_edges(w);
}

static void build_chain(cost_world *w)
{
	if (w->form == COST_UNUSED) {
		cn_vec2 points[FAR_POINTS];
		cn_body body = scene_body(&w->run, CN_BODY_STATIC, 300.0f, 0.0f);
		cn_shape_def surface = scene_surface(body, 0.0f, 0.6f, 0.0f);
		for (int32_t i = 0; i < FAR_POINTS; ++i)
			points[i] = scene_vec(-(float)i, 0.0f);
		scene_chain(&w->run, &surface, points, FAR_POINTS, 0);
	}
	if (w->form == COST_PLAIN)
		add_edges(w);
	if (w->form == COST_USED) {
		cn_vec2 points[GROUND_POINTS];
		cn_shape_def surface = scene_surface(w->drum, 0.0f, 0.6f, 0.0f);
		list_ground(points);
		scene_chain(&w->run, &surface, points, GROUND_POINTS, 1);
	}
}

const cost_feature cost_surface_features[] = {
	{"restitution", "0.5 for 150 bodies", 150, 1, 0, NULL, NULL, NULL, set_restitution, NULL},
	{"rolling resistance", "150 bodies", 150, 1, 0, NULL, NULL, NULL, set_rolling, NULL},
	{"conveyor", "150 bodies", 150, 1, 0, NULL, NULL, NULL, set_conveyor, NULL},
	{"sensor", "sees 150 bodies", 150, 1, CN_SHAPE_SENSOR, NULL, build_sensor, NULL, make_sensor, NULL},
	{"one-way", "a platform", 0, 1, CN_SHAPE_ONE_WAY, NULL, build_one_way, NULL, make_one_way, NULL},
	{"edges", "32 before the walls", 0, 1, 0, NULL, build_edges, NULL, NULL, NULL},
	{"chain beside edges", "32 edges", 0, 1, 0, NULL, build_chain, NULL, NULL, NULL},
};
const int32_t cost_surface_feature_count = (int32_t)(sizeof cost_surface_features / sizeof cost_surface_features[0]);
