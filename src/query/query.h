/*
 * query/query.h - shared by all queries: which shapes they see, the convex region that is tested or moved, and lists that
 * keep the first items of a stream in order.
 *
 * Queries only read: they may run on several threads at once and allocate nothing. Results do not depend on
 * the order in which the broadphase visits boxes: shape and child order equal results.
 */
#ifndef CNI_WORLD_QUERY_H
#define CNI_WORLD_QUERY_H

#include "world/error.h"
#include "collision/distance.h"

/* One broadphase box that a query visits. */
typedef struct cni_query_target {
	const cni_shape *shape;
	const cni_body *body;          /* NULL for an unattached shape (cn_shape_cast_ray): its frame is the world */
	const cni_geometry *geometry;
	int32_t index;                 /* of the shape */
	int32_t child;
} cni_query_target;

/* A checked filter, as queries use it. */
typedef struct cni_sight {
	const cn_world *world;
	cn_query_filter filter;
	int32_t ignored;       /* body index, CNI_NONE */
	uint32_t without;      /* CN_SHAPE_ flags: shapes with one of them are ignored, whatever the filter is; default 0 */
	float touch;           /* casts: a shape that contains the start up to this depth is hit only by moving farther in */
} cni_sight;

/* The defaults for NULL. Checks flags and the ignored body. */
cni_sight cni_check_filter(cni_call *call, const cn_query_filter *filter);
/* Returns 0 if the filter excludes the shape of the proxy. */
int32_t cni_query_target_of(const cni_sight *sight, int32_t proxy, cni_query_target *out);
/* Whether a query without a direction ignores a one-way shape: with CN_QUERY_ONE_WAY. */
static inline int32_t cni_sight_hides_one_way(const cni_sight *sight, const cni_shape *shape)
{
	return (sight->filter.flags & CN_QUERY_ONE_WAY) && (shape->flags & CN_SHAPE_ONE_WAY);
}
/* Result of the user's filter callback for a hit: CN_QUERY_*. */
int32_t cni_sight_ask(const cni_sight *sight, const cn_ray_hit *hit);
/* The same for a shape without a hit. */
int32_t cni_sight_ask_target(const cni_sight *sight, const cni_query_target *t);

/* The order of results at the same distance: by shape, then by child. */
static inline int32_t cni_part_before(cn_shape shape, int32_t child, cn_shape other, int32_t other_child)
{
	return shape != other ? cni_order_of(shape) < cni_order_of(other) : child < other_child;
}

/* Least cosine between a one-way shape's upper side and the normal at which it is met. */
#define CNI_ONE_WAY_COSINE 0.7f

/* ---- a convex shape of 1 or more points as geometry, in the frame of its points */

typedef struct cni_solid {
	cni_geometry g;
	cni_vec2 rest[2 * CN_POLYGON_MAX_VERTICES];
} cni_solid;
void cni_solid_make(const cn_polygon *p, cni_solid *out);

/* ---- a convex region: points relative to the first one, so that checks and distances keep all digits */

typedef struct cni_region {
	cni_vec2 origin;
	cni_vec2 points[CN_POLYGON_MAX_VERTICES]; /* counter-clockwise, from origin */
	int32_t count;
	float radius;
	cni_vec2 center;  /* mean of the points */
} cni_region;

/* Checks a polygon and stores it as a region; 1 or 2 points need a radius > 0. */
void cni_check_region(cni_call *call, const cn_polygon *polygon, cni_region *out);
/* A translation may be as long as the world is wide. */
void cni_check_translation(cni_call *call, cn_vec2 translation);
/* Nearest hit of a ray and of a moving region. */
cn_ray_hit cni_ray_cast(const cni_sight *sight, cni_vec2 origin, cni_vec2 translation);
cn_ray_hit cni_region_cast(const cni_sight *sight, const cni_region *region, cni_vec2 translation);
/* AABB in the world after a move by offset. */
cni_aabb cni_region_box(const cni_region *region, cni_vec2 offset);
/* Its points as a polygon. */
cn_polygon cni_region_polygon(const cni_region *region);
/* What makes points no shape, NULL: nothing. One or two points are a circle and a capsule. */
const char *cni_check_convex(const cn_polygon *p, float tolerance);
/* Transform of the region's points into the body's frame. */
cni_transform cni_region_in(const cni_region *region, const cni_body *body);

/* ---- the first `capacity` items of a stream in an order, in the caller's array */

/* 1 when a comes before b; never for equals. */
typedef int32_t cni_before_fn(const void *a, const void *b);

typedef struct cni_first {
	uint8_t *items;       /* while adding: a heap with the last item on top (Williams 1964) */
	int32_t item_bytes;   /* at most CNI_FIRST_ITEM_BYTES */
	int32_t capacity;
	int32_t held;
	int32_t total;        /* items added */
	cni_before_fn *before;
} cni_first;
#define CNI_FIRST_ITEM_BYTES 64

void cni_first_begin(cni_first *first, void *items, int32_t item_bytes, int32_t capacity, cni_before_fn *before);
void cni_first_add(cni_first *first, const void *item);
/* Sorts the items held. */
void cni_first_end(cni_first *first);

#endif
