/*
 * test/query/queries.h - what the query tests share: random worlds with every type of shape, filters, sensors,
 * disabled and sleeping bodies; what games do to them between two steps; which shapes a query may see; and
 * everything that can be asked, in one struct.
 */
#ifndef CAIRN_TEST_QUERIES_H
#define CAIRN_TEST_QUERIES_H

#include "world/fixture.h"
#include "collision/sets.h"
#include "model/world.h"

#define BODIES 220
#define SHAPES_MAX 1024
#define HALF 24.0f

static cn_world *w;
static cn_body bodies[BODIES];
static uint32_t seed;
static int32_t broadphase_kind = CN_BROADPHASE_SWEEP;

static inline float rnd(float lower, float upper) { return fixture_random(&seed, lower, upper); }
static inline int32_t below(int32_t count) { return (int32_t)rnd(0.0f, (float)count - 0.001f); }

/* Where a body is put; one call a number, in a fixed order on every compiler. */
typedef struct place { float x, y, angle; } place;

static inline place random_place(float center, float half)
{
	place p;
	p.x = center + rnd(-half, half);
	p.y = rnd(-half, half);
	p.angle = rnd(-3.0f, 3.0f);
	return p;
}

/* ------------------------------------------------------------------ random worlds */

static inline void random_chain(const cn_shape_def *sd)
{
	cn_vec2 points[24];
	cn_chain chain = { points, 0, 0 };
	int32_t k;
	chain.loop = below(2) ? 1u : 0u;
	chain.count = chain.loop ? 3 + below(10) : 2 + below(22);
	for (k = 0; k < chain.count; ++k) {
		double angle = 6.2831853 * (double)k / (double)chain.count;
		points[k].x = chain.loop ? 2.0f * (float)cos(angle) : 0.7f * (float)(chain.count / 2 - k);
		points[k].y = chain.loop ? 1.5f * (float)sin(angle) : rnd(-0.4f, 0.4f);
	}
	must(cn_shape_create_chain(w, sd, &chain, NULL), w, "chain");
}

static inline void random_shape(cn_body body, int32_t type)
{
	cn_shape_def sd = fixture_shape_def(body, 0.5f, 0.0f);
	cn_circle circle = { { 0.0f, 0.0f }, 0.0f };
	cn_capsule capsule = { { 0.0f, 0.0f }, { 0.0f, 0.0f }, 0.0f };
	cn_edge edge = { { -1.0f, 0.0f }, { 1.0f, 0.2f } };
	cn_vec2 cloud[12];
	cn_polygon hull;
	int32_t k;
	sd.offset_m.x = rnd(-0.5f, 0.5f);
	sd.offset_m.y = rnd(-0.5f, 0.5f);
	sd.angle_rad = rnd(-3.0f, 3.0f);
	sd.filter.category = 1ull << below(4);
	sd.filter.mask = below(4) ? ~0ull : 1ull << below(4);
	sd.flags = below(8) ? 0u : CN_SHAPE_SENSOR | (below(2) ? (uint32_t)CN_SHAPE_SENSOR_SEEN : 0u);
	circle.radius_m = rnd(0.1f, 1.0f);
	capsule.a_m.x = -rnd(0.2f, 1.0f);
	capsule.b_m.x = -capsule.a_m.x;
	capsule.radius_m = rnd(0.1f, 0.5f);
	switch (type) {
	case CN_SHAPE_CIRCLE: must(cn_shape_create_circle(w, &sd, &circle, NULL), w, "circle"); break;
	case CN_SHAPE_CAPSULE: must(cn_shape_create_capsule(w, &sd, &capsule, NULL), w, "capsule"); break;
	case CN_SHAPE_EDGE: must(cn_shape_create_edge(w, &sd, &edge, NULL), w, "edge"); break;
	case CN_SHAPE_CHAIN: random_chain(&sd); break;
	default:
		for (k = 0; k < 12; ++k) {
			cloud[k].x = rnd(-1.0f, 1.0f);
			cloud[k].y = rnd(-0.8f, 0.8f);
		}
		must(cn_polygon_make_hull(cloud, 12, below(2) ? 0.0f : rnd(0.02f, 0.3f), &hull), NULL, "hull");
		must(cn_shape_create_polygon(w, &sd, &hull, NULL), w, "polygon");
	}
}

static inline cn_world *make_world(float gravity)
{
	cn_world_def def;
	cn_world *world = NULL;
	cn_world_def_init(&def);
	def.gravity_mps2.y = gravity;
	def.broadphase = broadphase_kind;
	must(cn_world_create(&def, &world), NULL, "cn_world_create");
	return world;
}

static inline void random_world(uint32_t with_seed, float center)
{
	int32_t k, n;
	seed = with_seed;
	w = make_world(-10.0f);
	fixture_box(w, CN_BODY_STATIC, center, -HALF - 1.0f, 0.0f, 2.0f * HALF, 1.0f, 0.6f, 0.0f);
	for (k = 0; k < BODIES; ++k) {
		int32_t type = below(3);
		place at = random_place(center, HALF);
		bodies[k] = fixture_body(w, type, at.x, at.y, at.angle);
		for (n = 1 + below(3); n > 0; --n)
			random_shape(bodies[k], type == CN_BODY_DYNAMIC ? below(3) : below(5));
	}
	fixture_step(w, 40);
}

/* What games do between two steps. */
static inline void shuffle_bodies(float center)
{
	cn_shape shapes[8];
	place at;
	int32_t k, count;
	for (k = 0; k < BODIES; ++k) {
		if (!cn_body_is_valid(w, bodies[k]))
			continue;
		switch (below(12)) {
		case 0:
		case 1:
		case 2:
			at = random_place(center, HALF);
			must(cn_body_set_pose(w, bodies[k], at.x, at.y, at.angle), w, "set_pose");
			break;
		case 3: must(cn_body_destroy(w, bodies[k]), w, "destroy"); break;
		case 4: must(cn_body_set_flags(w, bodies[k], below(2) ? CN_BODY_SLEEP : CN_BODY_SLEEP | CN_BODY_ENABLED), w, "set_flags"); break;
		case 5: must(cn_body_set_awake(w, bodies[k], 0), w, "set_awake"); break;
		case 6:
			must(cn_body_get_shapes(w, bodies[k], shapes, 8, &count), w, "get_shapes");
			if (count > 1)
				must(cn_shape_detach(w, shapes[0]), w, "detach");
			break;
		default: break;
		}
	}
}

static inline cn_query_filter random_filter(void)
{
	cn_query_filter f;
	cn_query_filter_init(&f);
	if (below(3) == 0)
		f.mask = 1ull << below(4);
	if (below(3) == 0)
		f.category = 1ull << below(4);
	return f;
}

/* ------------------------------------------------------------------ reference */

static cn_shape all_shapes[SHAPES_MAX];
static int32_t all_count;

/* By the public API alone. */
static inline int seen_by(cn_shape shape, const cn_query_filter *filter)
{
	cn_body body = 0;
	cn_filter f;
	uint32_t flags = 0, body_flags = 0;
	must(cn_shape_get_body(w, shape, &body), w, "get_body");
	must(cn_shape_get_filter(w, shape, &f), w, "get_filter");
	must(cn_shape_get_flags(w, shape, &flags), w, "get_flags");
	if (body == 0)
		return 0;
	must(cn_body_get_flags(w, body, &body_flags), w, "body_get_flags");
	if (!(body_flags & CN_BODY_ENABLED) || ((flags & CN_SHAPE_SENSOR) && !(flags & CN_SHAPE_SENSOR_SEEN)))
		return 0;
	return (f.category & filter->mask) != 0 && (f.mask & filter->category) != 0;
}

static inline void list_shapes(void)
{
	must(cn_world_get_shapes(w, all_shapes, SHAPES_MAX, &all_count), w, "get_shapes");
}

static inline const cni_shape *record_of(cn_shape shape) { return cni_shape_at(w, (int32_t)(shape & 0xFFFFFu)); }

static inline double_set child_set(const cni_shape *s, int32_t child)
{
	cni_vec2 storage[2];
	return set_of(cni_geometry_proxy(cni_shape_geometry(&w->blocks, s), child, storage), cni_body_transform(cni_body_at(w, s->body)));
}

static inline int same(const void *a, const void *b, size_t bytes) { return memcmp(a, b, bytes) == 0; }

static inline cn_ray random_ray(float center)
{
	cn_ray ray;
	ray.origin_m.x = center + rnd(-HALF, HALF);
	ray.origin_m.y = rnd(-HALF, HALF);
	ray.translation_m.x = rnd(-1.0f, 1.0f) * (below(2) ? 50.0f : 5.0f);
	ray.translation_m.y = rnd(-1.0f, 1.0f) * (below(2) ? 50.0f : 5.0f);
	if (below(12) == 0)
		ray.translation_m.x = 0.0f;
	if (below(12) == 0)
		ray.translation_m.y = 0.0f;
	return ray;
}

static inline cn_polygon random_region(float center, int32_t points)
{
	cn_polygon p;
	cn_vec2 cloud[10];
	float x = center + rnd(-HALF, HALF), y = rnd(-HALF, HALF), size = below(3) ? rnd(0.2f, 2.0f) : rnd(3.0f, 10.0f);
	int32_t k;
	for (k = 0; k < 10; ++k) {
		cloud[k].x = x + rnd(-size, size);
		cloud[k].y = y + rnd(-size, size);
	}
	if (points > 2) {
		must(cn_polygon_make_hull(cloud, 10, 0.0f, &p), NULL, "hull");
	} else {
		memset(&p, 0, sizeof p);
		p.count = points;
		p.points_m[0] = cloud[0];
		p.points_m[1] = cloud[1];
	}
	p.radius_m = points > 2 && below(2) ? 0.0f : rnd(0.05f, 1.0f);
	if (points > 2 && below(3) == 0)
		for (k = 0; k < p.count / 2; ++k) { /* clockwise is as good */
			cn_vec2 kept = p.points_m[k];
			p.points_m[k] = p.points_m[p.count - 1 - k];
			p.points_m[p.count - 1 - k] = kept;
		}
	return p;
}

static inline double_set region_set(const cn_polygon *p)
{
	cni_transform none = { { 1.0f, 0.0f }, { 0.0f, 0.0f } };
	cni_vec2 points[CN_POLYGON_MAX_VERTICES];
	cni_proxy_points set;
	int32_t k;
	set.points = points;
	set.count = p->count;
	set.radius = p->radius_m;
	memcpy(points, p->points_m, sizeof points);
	if (p->count > 2 && (points[1].x - points[0].x) * (points[2].y - points[0].y) < (points[1].y - points[0].y) * (points[2].x - points[0].x))
		for (k = 0; k < p->count; ++k)
			points[k] = p->points_m[p->count - 1 - k];
	return set_of(set, none);
}

/* ------------------------------------------------------------------ everything that can be asked */

typedef struct answers {
	cn_ray_hit hit, moved, list[8];
	cn_closest closest;
	cn_shape shapes[3][16];
	int32_t counts[4];
} answers;

static inline void answer(answers *a, const cn_ray *ray, const cn_polygon *polygon, const cn_query_filter *filter)
{
	cn_aabb box;
	memset(a, 0, sizeof *a);
	box.lower_m = ray->origin_m;
	box.upper_m.x = ray->origin_m.x + 8.0f;
	box.upper_m.y = ray->origin_m.y + 8.0f;
	must(cn_world_cast_ray(w, ray, filter, &a->hit), w, "cast_ray");
	must(cn_world_cast_ray_all(w, ray, filter, a->list, 8, &a->counts[0]), w, "cast_ray_all");
	must(cn_world_cast_shape(w, polygon, ray->translation_m.x, ray->translation_m.y, filter, &a->moved), w, "cast_shape");
	must(cn_world_overlap_aabb(w, &box, filter, a->shapes[0], 16, &a->counts[1]), w, "overlap_aabb");
	must(cn_world_overlap_polygon(w, polygon, filter, a->shapes[1], 16, &a->counts[2]), w, "overlap_polygon");
	must(cn_world_overlap_point(w, ray->origin_m.x, ray->origin_m.y, filter, a->shapes[2], 16, &a->counts[3]), w, "overlap_point");
	must(cn_world_closest_point(w, ray->origin_m.x, ray->origin_m.y, 20.0f, filter, &a->closest), w, "closest_point");
}

#endif
