/*
 * test/world/arguments_queries.h - entries of arguments_test for queries, explosions and trees: good and bad calls of each
 * function. Included by arguments_test.c only, after its macros.
 */
#ifndef CAIRN_TEST_ARGUMENTS_QUERIES_H
#define CAIRN_TEST_ARGUMENTS_QUERIES_H

/* ---- queries */

static cn_ray ray;
static cn_ray_hit hit_list[2];
static cn_query_filter query_filter;
static cn_explosion_def blast;
static cn_aabb region_box;

static int reset_queries(void)
{
	reset();
	ray.origin_m = v2(-3.0f, 0.5f);
	ray.translation_m = v2(6.0f, 0.0f);
	cn_query_filter_init(&query_filter);
	cn_explosion_def_init(&blast);
	blast.center_m = v2(0.2f, 0.0f);
	blast.radius_m = 100.0f;
	blast.impulse_Nspm = 1.0f;
	region_box.lower_m = v2(-1.0f, -1.0f);
	region_box.upper_m = v2(1.0f, 1.0f);
	return 0;
}
static const cn_ray *good_ray(void) { reset_queries(); return &ray; }
static const cn_ray *ray_from(cn_vec2 v) { reset_queries(); ray.origin_m = v; return &ray; }
static const cn_ray *ray_along(cn_vec2 v) { reset_queries(); ray.translation_m = v; return &ray; }
/* The second of two is bad. */
static const cn_ray *ray_pair(cn_vec2 v) { static cn_ray two[2]; two[0] = *good_ray(); two[1] = *ray_along(v); return two; }
static const cn_polygon *region_points(int32_t count, float radius, cn_vec2 first)
{
	reset_queries();
	polygon.count = count;
	polygon.radius_m = radius;
	polygon.points_m[0] = first;
	return &polygon;
}
static const cn_aabb *region_from(cn_vec2 v) { reset_queries(); region_box.lower_m = v; return &region_box; }
static const cn_aabb *region_to(cn_vec2 v) { reset_queries(); region_box.upper_m = v; return &region_box; }

#define RAYS(call) do { ARG(call(NULL)); POSITION(v, call(ray_from(v))); VECTOR(v, call(ray_along(v))); ARG(call(ray_along(v2(2.1e6f, 0.0f)))); } while (0)
/* Polygons of one or two points need a radius. */
#define REGIONS(call) do { cn_vec2 o_ = v2(-0.5f, -0.5f); ARG(call(NULL)); INTEGER(x, 0, 17, call(region_points(x, 0.1f, o_))); \
	NOT_NEGATIVE(x, call(region_points(4, x, o_))); ARG(call(region_points(4, 1.1e6f, o_))); \
	{ int32_t n_; for (n_ = 1; n_ < 3; ++n_) POSITIVE(x, call(region_points(n_, x, o_))); } \
	POSITION(v, call(region_points(4, 0.0f, v))); ARG(call(region_points(4, 0.0f, v2(0.4f, 0.4f)))); ARG(call(region_points(2, 0.1f, v2(0.5f, -0.5f)))); } while (0)
#define OUTPUT_LIST(name, region) \
	NOW(name(NULL, region, NULL, OUT(cn_shape) + 4, 8, INT)); ARG(name(W, region, NULL, NULL, 1, INT)); \
	ARG(name(W, region, NULL, OUT(cn_shape) + 4, -1, INT)); ARG(name(W, region, NULL, OUT(cn_shape) + 4, 8, NULL));

ENTRY(cn_query_filter_init, (cn_query_filter_init(&query_filter), CN_OK), cn_query_filter_init(NULL);)
ENTRY(cn_explosion_def_init, (cn_explosion_def_init(&blast), CN_OK), cn_explosion_def_init(NULL);)
#define CAST_RAY(r) cn_world_cast_ray(W, r, NULL, OUT(cn_ray_hit))
ENTRY(cn_world_cast_ray, cn_world_cast_ray(W, good_ray(), &query_filter, OUT(cn_ray_hit)),
	RAYS(CAST_RAY); NOW(cn_world_cast_ray(NULL, good_ray(), NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_ray(W, good_ray(), NULL, NULL));)
#define CAST_RAY_ANY(r) cn_world_cast_ray_any(W, r, NULL, INT)
ENTRY(cn_world_cast_ray_any, cn_world_cast_ray_any(W, good_ray(), &query_filter, INT),
	RAYS(CAST_RAY_ANY); NOW(cn_world_cast_ray_any(NULL, good_ray(), NULL, INT)); ARG(cn_world_cast_ray_any(W, good_ray(), NULL, NULL));)
#define CAST_RAY_ALL(r) cn_world_cast_ray_all(W, r, NULL, OUT(cn_ray_hit) + 4, 8, INT)
ENTRY(cn_world_cast_ray_all, cn_world_cast_ray_all(W, good_ray(), &query_filter, OUT(cn_ray_hit) + 4, 8, INT),
	RAYS(CAST_RAY_ALL); NOW(cn_world_cast_ray_all(NULL, good_ray(), NULL, OUT(cn_ray_hit) + 4, 8, INT));
	ARG(cn_world_cast_ray_all(W, good_ray(), NULL, NULL, 1, INT)); ARG(cn_world_cast_ray_all(W, good_ray(), NULL, OUT(cn_ray_hit) + 4, -1, INT));
	ARG(cn_world_cast_ray_all(W, good_ray(), NULL, OUT(cn_ray_hit) + 4, 8, NULL));)
#define CAST_RAYS(r) cn_world_cast_rays(W, r, 1, NULL, OUT(cn_ray_hit))
ENTRY(cn_world_cast_rays, cn_world_cast_rays(W, ray_pair(v2(1.0f, 0.0f)), 2, &query_filter, hit_list),
	RAYS(CAST_RAYS); NOW(cn_world_cast_rays(NULL, good_ray(), 1, NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_rays(W, good_ray(), -1, NULL, OUT(cn_ray_hit)));
	ARG(cn_world_cast_rays(W, good_ray(), 1, NULL, NULL)); VECTOR(v, cn_world_cast_rays(W, ray_pair(v), 2, NULL, OUT(cn_ray_hit)));)
#define CAST_RAY_SHAPE(r) cn_shape_cast_ray(W, f.chain, r, OUT(cn_ray_hit))
ENTRY(cn_shape_cast_ray, cn_shape_cast_ray(W, f.chain, good_ray(), OUT(cn_ray_hit)),
	RAYS(CAST_RAY_SHAPE); NOW(cn_shape_cast_ray(NULL, f.chain, good_ray(), OUT(cn_ray_hit))); SHAPE(h, cn_shape_cast_ray(W, h, good_ray(), OUT(cn_ray_hit)));
	ARG(cn_shape_cast_ray(W, f.chain, good_ray(), NULL));)
#define CAST_SHAPE(p) cn_world_cast_shape(W, p, 1.0f, -2.0f, NULL, OUT(cn_ray_hit))
ENTRY(cn_world_cast_shape, cn_world_cast_shape(W, (reset_queries(), &polygon), 1.0f, -2.0f, &query_filter, OUT(cn_ray_hit)),
	REGIONS(CAST_SHAPE); NOW(cn_world_cast_shape(NULL, (reset_queries(), &polygon), 1.0f, -2.0f, NULL, OUT(cn_ray_hit)));
	VECTOR(v, cn_world_cast_shape(W, (reset_queries(), &polygon), v.x, v.y, NULL, OUT(cn_ray_hit)));
	ARG(cn_world_cast_shape(W, (reset_queries(), &polygon), 0.0f, 2.1e6f, NULL, OUT(cn_ray_hit))); ARG(cn_world_cast_shape(W, (reset_queries(), &polygon), 1.0f, 0.0f, NULL, NULL));)
#define OVERLAP_AABB(b) cn_world_overlap_aabb(W, b, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_aabb, cn_world_overlap_aabb(W, (reset_queries(), &region_box), &query_filter, OUT(cn_shape) + 4, 8, INT),
	OUTPUT_LIST(cn_world_overlap_aabb, (reset_queries(), &region_box)) ARG(OVERLAP_AABB(NULL)); POSITION(v, OVERLAP_AABB(region_from(v)));
	POSITION(v, OVERLAP_AABB(region_to(v))); ARG(OVERLAP_AABB(region_to(v2(-2.0f, 1.0f)))); ARG(OVERLAP_AABB(region_to(v2(1.0f, -2.0f))));)
#define OVERLAP_CIRCLE(c) cn_world_overlap_circle(W, c, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_circle, cn_world_overlap_circle(W, (reset_queries(), &circle), &query_filter, OUT(cn_shape) + 4, 8, INT),
	OUTPUT_LIST(cn_world_overlap_circle, (reset_queries(), &circle)) ARG(OVERLAP_CIRCLE(NULL)); POSITION(v, OVERLAP_CIRCLE(CI(center_m, v)));
	POSITIVE(x, OVERLAP_CIRCLE(CI(radius_m, x))); ARG(OVERLAP_CIRCLE(CI(radius_m, 1.1e6f)));)
#define OVERLAP_POLYGON(p) cn_world_overlap_polygon(W, p, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_polygon, cn_world_overlap_polygon(W, (reset_queries(), &polygon), &query_filter, OUT(cn_shape) + 4, 8, INT),
	OUTPUT_LIST(cn_world_overlap_polygon, (reset_queries(), &polygon)) REGIONS(OVERLAP_POLYGON);)
#define OVERLAP_POINT(v) cn_world_overlap_point(W, v.x, v.y, NULL, OUT(cn_shape) + 4, 8, INT)
ENTRY(cn_world_overlap_point, cn_world_overlap_point(W, 0.0f, 0.5f, &query_filter, OUT(cn_shape) + 4, 8, INT),
	POSITION(v, OVERLAP_POINT(v)); NOW(cn_world_overlap_point(NULL, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, 8, INT));
	ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, NULL, 1, INT)); ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, -1, INT));
	ARG(cn_world_overlap_point(W, 0.0f, 0.5f, NULL, OUT(cn_shape) + 4, 8, NULL));)
ENTRY(cn_world_closest_point, cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, &query_filter, OUT(cn_closest)),
	POSITION(v, cn_world_closest_point(W, v.x, v.y, 5.0f, NULL, OUT(cn_closest))); RANGE(x, -1e-30f, 4.1e6f, cn_world_closest_point(W, 0.0f, 3.0f, x, NULL, OUT(cn_closest)));
	NOW(cn_world_closest_point(NULL, 0.0f, 3.0f, 5.0f, NULL, OUT(cn_closest))); ARG(cn_world_closest_point(W, 0.0f, 3.0f, 5.0f, NULL, NULL));)
#define BLAST(field, value) (reset_queries(), blast.field = (value), &blast)
ENTRY(cn_world_explode, cn_world_explode(W, BLAST(radius_m, 100.0f)),
	NOW(cn_world_explode(NULL, BLAST(radius_m, 1.0f))); ARG(cn_world_explode(W, NULL)); SIZES(x, cn_world_explode(W, BLAST(struct_size, x)));
	RANGE(x, -1e-30f, 1.1e6f, cn_world_explode(W, BLAST(radius_m, x))); RANGE(x, -1e-30f, 1.1e6f, cn_world_explode(W, BLAST(falloff_m, x)));
	FLOAT(x, cn_world_explode(W, BLAST(impulse_Nspm, x))); POSITION(v, cn_world_explode(W, BLAST(center_m, v)));
	ARG(cn_world_explode(W, BLAST(impulse_Nspm, 3e38f)));)

/* ---- trees */

static cn_tree *tree;
static uint32_t tree_item, tree_stale;
static cn_aabb tree_box;
static cn_ray tree_ray;

/* A tree with one item, and the name of one that is gone. */
static int tree_make(void)
{
	tree_box.lower_m = v2(-1.0f, 0.0f);
	tree_box.upper_m = v2(1.0f, 2.0f);
	tree_ray.origin_m = v2(-5.0f, 1.0f);
	tree_ray.translation_m = v2(10.0f, 0.0f);
	CHECK(cn_tree_create(0.1f, NULL, NULL, NULL, &tree) == CN_OK);
	CHECK(cn_tree_insert(tree, &tree_box, 1, &tree_stale) == CN_OK && cn_tree_remove(tree, tree_stale) == CN_OK);
	CHECK(cn_tree_insert(tree, &tree_box, 2, &tree_item) == CN_OK);
	return 0;
}

static cn_result tree_end(cn_result result)
{
	cn_tree_destroy(tree);
	tree = NULL;
	return result;
}

static int32_t tree_visit(uint32_t item, uint64_t user_data, void *user) { return item != 0 && user_data == 2 && user == NULL; }
static float tree_hit(uint32_t item, uint64_t user_data, float fraction, void *user) { return item != 0 && user_data == 2 && user == NULL ? fraction : 0.0f; }

#define TREE(call) (tree_make(), tree_end(call))
#define TREE_BOXES(call) do { const cn_aabb *b_ = NULL; ARG(call(b_)); b_ = &tree_box; \
	VECTOR(v, (tree_box.lower_m = v, call(b_))); tree_box.lower_m = v2(-1.0f, 0.0f); VECTOR(v, (tree_box.upper_m = v, call(b_))); \
	tree_box.upper_m = v2(-1.5f, 2.0f); ARG(call(b_)); tree_box.upper_m = v2(1.0f, -0.5f); ARG(call(b_)); tree_box.upper_m = v2(1.0f, 2.0f); } while (0)
#define TREE_ITEMS(h, call) do { uint32_t h = 0; BAD(CN_ERROR_HANDLE, call); h = tree_stale; BAD(CN_ERROR_HANDLE, call); \
	h = tree_item + 1; BAD(CN_ERROR_HANDLE, call); h = 0xFFFFFFFFu; BAD(CN_ERROR_HANDLE, call); } while (0)

ENTRY(cn_tree_create, TREE(CN_OK), NOT_NEGATIVE(x, cn_tree_create(x, NULL, NULL, NULL, OUT(cn_tree *))); ARG(cn_tree_create(0.1f, NULL, NULL, NULL, NULL));
	ARG(cn_tree_create(0.1f, test_alloc, NULL, NULL, OUT(cn_tree *))); ARG(cn_tree_create(0.1f, NULL, test_free, NULL, OUT(cn_tree *)));)
ENTRY(cn_tree_destroy, TREE(CN_OK), cn_tree_destroy(NULL);)
#define INSERT_BOX(b) cn_tree_insert(tree, b, 0, OUT(uint32_t))
ENTRY(cn_tree_insert, TREE(cn_tree_insert(tree, &tree_box, 3, &tree_item)),
	tree_make(); TREE_BOXES(INSERT_BOX); NOW(cn_tree_insert(NULL, &tree_box, 0, OUT(uint32_t))); ARG(cn_tree_insert(tree, &tree_box, 0, NULL)); tree_end(CN_OK);)
ENTRY(cn_tree_remove, TREE(cn_tree_remove(tree, tree_item)),
	tree_make(); TREE_ITEMS(h, cn_tree_remove(tree, h)); NOW(cn_tree_remove(NULL, tree_item)); tree_end(CN_OK);)
#define MOVE_BOX(b) cn_tree_move(tree, tree_item, b)
ENTRY(cn_tree_move, TREE(cn_tree_move(tree, tree_item, &tree_box)),
	tree_make(); TREE_BOXES(MOVE_BOX); TREE_ITEMS(h, cn_tree_move(tree, h, &tree_box)); NOW(cn_tree_move(NULL, tree_item, &tree_box)); tree_end(CN_OK);)
ENTRY(cn_tree_get_box, TREE(cn_tree_get_box(tree, tree_item, OUT(cn_aabb))),
	tree_make(); TREE_ITEMS(h, cn_tree_get_box(tree, h, OUT(cn_aabb))); NOW(cn_tree_get_box(NULL, tree_item, OUT(cn_aabb)));
	ARG(cn_tree_get_box(tree, tree_item, NULL)); tree_end(CN_OK);)
#define QUERY_BOX(b) cn_tree_query(tree, b, tree_visit, NULL)
ENTRY(cn_tree_query, TREE(cn_tree_query(tree, &tree_box, tree_visit, NULL)),
	tree_make(); TREE_BOXES(QUERY_BOX); NOW(cn_tree_query(NULL, &tree_box, tree_visit, NULL)); ARG(cn_tree_query(tree, &tree_box, NULL, NULL)); tree_end(CN_OK);)
ENTRY(cn_tree_cast_ray, TREE(cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL)),
	tree_make(); NOW(cn_tree_cast_ray(NULL, &tree_ray, tree_hit, NULL)); ARG(cn_tree_cast_ray(tree, NULL, tree_hit, NULL));
	ARG(cn_tree_cast_ray(tree, &tree_ray, NULL, NULL)); VECTOR(v, (tree_ray.origin_m = v, cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL)));
	tree_ray.origin_m = v2(0.0f, 0.0f); VECTOR(v, (tree_ray.translation_m = v, cn_tree_cast_ray(tree, &tree_ray, tree_hit, NULL))); tree_end(CN_OK);)
ENTRY(cn_tree_get_stats, TREE(cn_tree_get_stats(tree, INT, INT)),
	tree_make(); NOW(cn_tree_get_stats(NULL, INT, INT)); ARG(cn_tree_get_stats(tree, NULL, INT)); ARG(cn_tree_get_stats(tree, INT, NULL)); tree_end(CN_OK);)

#endif
