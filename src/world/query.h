/*
 * world/query.h - what all queries share: which shapes they see, points in and out of a body's frame, the
 * convex region that is looked at or moved, and lists that keep the first few of a stream in order.
 *
 * Queries only read: they may run on several threads at once, and take no memory. What they find does not
 * depend on the order in which the broadphase visits: equals are told apart by shape and child.
 */
#ifndef CNI_WORLD_QUERY_H
#define CNI_WORLD_QUERY_H

#include "world/error.h"
#include "collision/distance.h"

/* One broadphase box that a query looks at. */
typedef struct cni_query_target {
	const cni_shape *shape;
	const cni_body *body;          /* NULL for an unattached shape: its frame is the world */
	const cni_geometry *geometry;
	int32_t index;                 /* of the shape */
	int32_t child;
} cni_query_target;

enum { CNI_SIGHT_WITHOUT_SENSORS = 1u << 0, CNI_SIGHT_WITHOUT_ONE_WAY = 1u << 1 };
/* A filter as a query works with it. */
typedef struct cni_sight {
	const cn_world *world;
	cn_query_filter filter;
	int32_t ignored;       /* body index, CNI_NONE */
	uint32_t without;      /* CNI_SIGHT_WITHOUT_*: what is not seen whatever the filter says; 0 */
	float touch;           /* casts: what the start is in up to this depth is met only by going farther in */
} cni_sight;

/* NULL means the defaults. Checks flags and the ignored body. */
cni_sight cni_check_filter(cni_call *call, const cn_query_filter *filter);
/* The one place that decides whether a query sees a shape. */
int32_t cni_sight_sees(const cni_sight *sight, const cni_shape *shape);
/* 0 when the filter does not see its shape. */
int32_t cni_query_target_of(const cni_sight *sight, int32_t proxy, cni_query_target *out);
/* Queries without a direction do not see one-way shapes, if these are asked for. */
static inline int32_t cni_sight_hides_one_way(const cni_sight *sight, const cni_shape *shape)
{
	return (sight->filter.flags & CN_QUERY_ONE_WAY) && (shape->flags & CN_SHAPE_ONE_WAY);
}
/* What the user says of it: CN_QUERY_*. */
int32_t cni_sight_ask(const cni_sight *sight, const cn_ray_hit *hit);
/* ... of a shape of which no more is known. */
int32_t cni_sight_ask_target(const cni_sight *sight, const cni_query_target *t);

/* Between the world and a body's frame by differences from its centre of mass; body may be NULL. */
cni_vec2 cni_query_to_local(const cni_body *body, cni_vec2 point);
cni_vec2 cni_query_to_world(const cni_body *body, cni_vec2 local);
cni_vec2 cni_query_turn_to_local(const cni_body *body, cni_vec2 vector);
cni_vec2 cni_query_turn_to_world(const cni_body *body, cni_vec2 local);

/* ---- a convex shape as geometry, in the frame of its points; 1, 2 or more of them */

typedef struct cni_solid {
	cni_geometry g;
	cni_vec2 rest[2 * CN_POLYGON_MAX_VERTICES];
} cni_solid;
void cni_solid_make(const cn_polygon *p, cni_solid *out);

/* ---- a convex region: points relative to one of them, so that checks and distances keep their digits */

typedef struct cni_region {
	cni_vec2 origin;
	cni_vec2 points[CN_POLYGON_MAX_VERTICES]; /* counter-clockwise, from origin */
	int32_t count;
	float radius;
	cni_vec2 center;  /* mean of the points */
} cni_region;

/* 1 or 2 points need a radius > 0. */
void cni_check_region(cni_call *call, const cn_polygon *polygon, cni_region *out);
/* May a way so long be moved? */
void cni_check_translation(cni_call *call, cn_vec2 translation);
/* The nearest hit of a ray, and of a region that moves. */
cn_ray_hit cni_ray_cast(const cni_sight *sight, cni_vec2 origin, cni_vec2 translation);
cn_ray_hit cni_region_cast(const cni_sight *sight, const cni_region *region, cni_vec2 translation);
/* In the world, moved by offset. */
cni_aabb cni_region_box(const cni_region *region, cni_vec2 offset);
cni_proxy_points cni_region_points(const cni_region *region);
/* Maps the region's points into the body's frame. */
cni_transform cni_region_in(const cni_region *region, const cni_body *body);

/* ---- the first `capacity` items of a stream by their order, in the caller's array */

/* 1 when a comes before b; never for equals. */
typedef int32_t cni_before_fn(const void *a, const void *b);

typedef struct cni_first {
	uint8_t *items;       /* while adding: a heap with the last one on top (Williams 1964) */
	int32_t item_bytes;   /* at most CNI_FIRST_ITEM_BYTES */
	int32_t capacity;
	int32_t held;
	int32_t total;        /* ever added */
	cni_before_fn *before;
} cni_first;
#define CNI_FIRST_ITEM_BYTES 64

void cni_first_begin(cni_first *first, void *items, int32_t item_bytes, int32_t capacity, cni_before_fn *before);
void cni_first_add(cni_first *first, const void *item);
/* Brings what is held into order. */
void cni_first_end(cni_first *first);

#endif
