/*
 * geometry/shape.h - the stored form of every shape's geometry and the pure functions on it: builders, checks, hull, mass,
 * bounds, point test.
 *
 * One variable-size record serves all types. Points are in the body's local frame (the shape's offset is already applied).
 * Polygons are counter-clockwise and store outward unit normals behind the points; so do segments (capsules, edges), which
 * are polygons of two corners:
 *
 *   | header 32 bytes | points[count] | normals[count] (not for circles and chains) |
 *
 *   circle   count 1, radius > 0          capsule  count 2, radius > 0
 *   edge     count 2, radius 0            polygon  count 3..16, radius >= 0, normals
 *   chain    count n, radius 0; child i is the edge points[i] -> points[i + 1 mod n]; n - 1 children,
 *            n when it is a loop
 */
#ifndef CNI_GEOMETRY_SHAPE_H
#define CNI_GEOMETRY_SHAPE_H

#include "base/maths.h"

typedef struct cni_geometry {
	int32_t type;       /* CN_SHAPE_* */
	int32_t count;
	float radius;
	uint32_t seams;     /* chain: 1 if it is a loop; others: hidden ends of faces and covered faces, see collision/seam.c */
	cni_vec2 centroid;  /* of the area (polygon, capsule, circle), else the mean of the points */
	float extent;       /* farthest surface point from the local origin */
	float inner_radius; /* radius of a circle inside the shape around its centroid, 0 for edges and chains */
	/* cni_vec2 points[count]; cni_vec2 normals[count] */
} cni_geometry;

/* A constant in builds without chains. */
static inline int32_t cni_is_chain(int32_t type) { return CNI_HAS_CHAINS && type == CN_SHAPE_CHAIN; }
static inline const cni_vec2 *cni_geometry_points(const cni_geometry *g) { return (const cni_vec2 *)(const void *)(g + 1); }
static inline const cni_vec2 *cni_geometry_normals(const cni_geometry *g) { return cni_geometry_points(g) + g->count; }

/* Least height of the points along a direction. */
static inline float cni_points_lowest(const cni_vec2 *points, int32_t count, cni_vec2 direction)
{
	float low = cni_dot(direction, points[0]);
	for (int32_t i = 1; i < count; ++i)
		low = cni_min(cni_dot(direction, points[i]), low);
	return low;
}

/* Bytes of a record. */
int32_t cni_geometry_bytes(int32_t type, int32_t count);
/* Number of broadphase boxes (children) of a shape: 1, or the chain's edge count. */
int32_t cni_geometry_children(const cni_geometry *g);

/* Builders: write a whole record into memory of cni_geometry_bytes. The input must have passed the matching check. offset
   transforms the points into the body's frame. */
void cni_geometry_circle(cni_geometry *out, const cn_circle *circle, cni_transform offset);
void cni_geometry_capsule(cni_geometry *out, const cn_capsule *capsule, cni_transform offset);
void cni_geometry_edge(cni_geometry *out, const cn_edge *edge, cni_transform offset);
/* Clockwise input is reversed. */
void cni_geometry_polygon(cni_geometry *out, const cn_polygon *polygon, cni_transform offset);
void cni_geometry_chain(cni_geometry *out, const cn_chain *chain, cni_transform offset);

/* Coordinates and radii above this are refused. */
#define CNI_COORDINATE_MAX 1.0e6f

/* Checks: NULL when valid, else a static English fragment that states the requirement, such as "points must be convex" (the
   caller adds the function name and values). tolerance: points closer than this coincide; a vertex that rises less than a
   tenth of it (or less than the float resolution of its coordinates) above the line through its neighbours is collinear
   with them. The checks include finiteness. A capsule's ends may not coincide; a chain refuses coinciding consecutive
   points (also last and first of a loop). */
extern const char cni_points_near[]; /* returned by a check when points coincide: the caller knows the tolerance's name */
/* Least distance between consecutive points; closed: also between the last and the first. */
float cni_least_distance(const cni_vec2 *points, int32_t count, int32_t closed);
const char *cni_check_circle(const cn_circle *circle, float tolerance);
const char *cni_check_capsule(const cn_capsule *capsule, float tolerance);
const char *cni_check_edge(const cn_edge *edge, float tolerance);
/* Requires a convex polygon of either winding, once around, with each vertex strictly convex in the sense above. */
const char *cni_check_polygon(const cn_polygon *polygon, float tolerance);
const char *cni_check_chain(const cn_chain *chain, float tolerance);

/* Counter-clockwise hull of the points that cni_check_polygon accepts, with at most CN_POLYGON_MAX_VERTICES vertices (it
   keeps those that add the most area) and radius_m 0. Returns NULL, or an error text as the checks. count <= 65536. No
   allocation: repeated farthest-point insertion, see hull.c. */
const char *cni_hull_make(const cni_vec2 *points, int32_t count, float tolerance, cn_polygon *out);

/* Points of a row: the lowest of the leftmost, the first of the farthest. */
int32_t cni_point_leftmost(const cni_vec2 *points, int32_t count);
int32_t cni_point_farthest(const cni_vec2 *points, int32_t count, cni_vec2 from);
/* Removes a point; returns the new count. */
int32_t cni_point_remove(cni_vec2 *points, int32_t count, int32_t at);

/* Tight box of child (0 for all but chains) with the body's origin at transform->t. */
void cni_geometry_box(const cni_geometry *g, int32_t child, const cni_transform *transform, cni_aabb *out);
static inline cni_aabb cni_geometry_aabb(const cni_geometry *g, int32_t child, cni_transform transform)
{
	cni_aabb box;
	cni_geometry_box(g, child, &transform, &box);
	return box;
}
/* Box of all children. */
cni_aabb cni_geometry_bounds(const cni_geometry *g, cni_transform transform);
/* Height of a vertex above the line through its neighbours below which it counts as collinear. */
float cni_collinear_height(const cni_vec2 *points, int32_t count, float tolerance);

/* Mass, centre in the body's frame, and inertia about that centre. Edges and chains: 0. A polygon with a radius is the exact
   Minkowski sum with a disc. Closed forms. */
cn_mass_data cni_geometry_mass(const cni_geometry *g, float density);
/* local is in the body's frame. Edges and chains contain nothing. */
int32_t cni_geometry_contains(const cni_geometry *g, cni_vec2 local);

/* A child of a geometry as a rounded convex point set: all of its points, or the two of a chain's edge. */
typedef struct cni_proxy_points {
	const cni_vec2 *points;
	int32_t count;
	float radius;
} cni_proxy_points;
cni_proxy_points cni_geometry_proxy(const cni_geometry *g, int32_t child, cni_vec2 edge_storage[2]);

/* A convex skeleton: points counter-clockwise, normals[i] of the face points[i] -> points[i + 1]. */
typedef struct cni_faces {
	const cni_vec2 *points;
	const cni_vec2 *normals;
	int32_t count;
	float radius;
} cni_faces;

/* Skeleton of a polygon or a segment in its own frame. */
static inline cni_faces cni_faces_of(const cni_geometry *g)
{
	cni_faces f = { cni_geometry_points(g), cni_geometry_normals(g), g->count, g->radius };
	return f;
}

#endif
