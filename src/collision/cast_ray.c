/*
 * collision/cast_ray.c - rays against every type of shape.
 *
 * Convex skeletons are clipped face by face (Cyrus, Beck 1978) against the planes moved out by the radius.
 * That finds the face through which the ray enters. If the ray enters beyond the face's ends, it can only hit the disc
 * around that end, because the clipped ray is then in the corner between the two planes and the disc:
 *
 *        plane of the next face \   . ray enters beyond the end
 *                                \ /
 *              ---------------- (v)      disc around v
 *
 * The same holds for a start in such a corner. The disc test begins at the point of the line that is nearest to the
 * centre, so that distant origins lose no digits to differences of squares.
 */
#include "collision/cast.h"

static int32_t hit_make(float fraction, cni_vec2 point, cni_vec2 normal, float depth, int32_t inside, cni_cast_hit *out)
{
	const cni_cast_hit hit = { fraction, point, normal, cni_max(depth, 0.0f), inside };
	*out = hit;
	return 1;
}

/* ------------------------------------------------------------------ disc */

/* The origin is outside. */
static int32_t disc_enter(cni_vec2 center, float radius, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out)
{
	float length = cni_length(translation);
	cni_vec2 direction = cni_normalize(translation);
	cni_vec2 from = cni_sub(origin, center), normal;
	float nearest = -cni_dot(from, direction);
	float off_sq = cni_length_sq(cni_madd(from, nearest, direction));
	if (!(length > 0.0f) || !(off_sq <= radius * radius))
		return 0;
	float at = nearest - cni_sqrt(radius * radius - off_sq);
	if (nearest < 0.0f || at > length)
		return 0;
	at = cni_max(at, 0.0f);
	normal = cni_normalize(cni_madd(from, at, direction));
	return hit_make(cni_min(at / length, 1.0f), cni_madd(center, radius, normal), normal, 0.0f, 0, out);
}

/* ------------------------------------------------------------------ convex skeleton */

static int32_t next_of(const cni_faces *hull, int32_t i)
{
	return i + 1 < hull->count ? i + 1 : 0;
}

static cni_vec2 face_normal(const cni_faces *hull, int32_t i)
{
	if (hull->normals != NULL)
		return hull->normals[i];
	return cni_normalize(cni_right_perp(cni_sub(hull->points[next_of(hull, i)], hull->points[i])));
}

/* The point of the outline that is nearest to the origin of the ray. */
typedef struct outline {
	cni_vec2 point;
	float distance_sq;
	int32_t feature;
} outline;

static outline outline_nearest(const cni_faces *hull, cni_vec2 origin)
{
	outline best = { hull->points[0], 0.0f, 0 };
	best.distance_sq = cni_distance_sq(origin, hull->points[0]);
	for (int32_t i = 0; i < hull->count && hull->count > 1; ++i) {
		cni_vec2 a = hull->points[i], edge = cni_sub(hull->points[next_of(hull, i)], a);
		float t = cni_segment_fraction(origin, a, edge);
		cni_vec2 point = cni_madd(a, t, edge);
		float distance_sq = cni_distance_sq(origin, point);
		if (distance_sq >= best.distance_sq)
			continue;
		best.point = point;
		best.distance_sq = distance_sq;
		best.feature = t <= 0.0f ? i : t >= 1.0f ? next_of(hull, i) : hull->count + i;
	}
	return best;
}

/* An origin within the radius of the outline: the hit at the start; 0 when the origin is not. */
static int32_t inside_outline(const cni_faces *hull, cni_vec2 origin, cni_cast_hit *out, int32_t *out_feature)
{
	outline near = outline_nearest(hull, origin);
	float distance = cni_sqrt(near.distance_sq);
	cni_vec2 offset = cni_sub(origin, near.point), normal = cni_normalize(offset);
	if (near.distance_sq > hull->radius * hull->radius)
		return 0;
	if (near.feature >= hull->count || !(distance > 0.0f)) { /* a face's own normal has more digits than a short offset */
		normal = hull->count > 1 ? face_normal(hull, near.feature % hull->count) : cni_v(0.0f, 1.0f);
		normal = cni_dot(normal, offset) < 0.0f ? cni_neg(normal) : normal;
	}
	*out_feature = near.feature;
	return hit_make(0.0f, cni_madd(near.point, hull->radius, normal), normal, hull->radius - distance, 1, out);
}

static int32_t nearest_vertex(const cni_faces *hull, cni_vec2 point)
{
	int32_t best = 0;
	for (int32_t i = 1; i < hull->count; ++i)
		if (cni_distance_sq(point, hull->points[i]) < cni_distance_sq(point, hull->points[best]))
			best = i;
	return best;
}

/* The ray clipped against the planes moved out by the radius. */
typedef struct clip {
	float enter, leave;
	cni_vec2 normal;      /* of the face through which the ray enters */
	int32_t face;         /* CNI_NONE: the origin is behind all moved planes */
	float height_most;    /* greatest height of the origin over the skeleton's own planes */
	int32_t face_most;    /* ... the face of that plane */
} clip;

/* 0 when the ray misses. */
static int32_t hull_clip(const cni_faces *hull, cni_vec2 origin, cni_vec2 translation, clip *c)
{
	c->enter = -1.0f;
	c->leave = 1.0f;
	c->face = CNI_NONE;
	c->height_most = -FLT_MAX;
	c->face_most = 0;
	for (int32_t i = 0; i < hull->count; ++i) {
		cni_vec2 n = face_normal(hull, i);
		float height = cni_dot(n, cni_sub(origin, hull->points[i]));
		float speed = cni_dot(n, translation);
		if (height > c->height_most) {
			c->height_most = height;
			c->face_most = i;
		}
		height -= hull->radius;
		if (height > 0.0f && speed >= 0.0f)
			return 0;
		if (height > 0.0f && height / -speed > c->enter) {
			c->enter = height / -speed;
			c->normal = n;
			c->face = i;
		} else if (speed > 0.0f) {
			c->leave = cni_min(c->leave, -height / speed);
		}
	}
	return c->enter <= c->leave;
}

static int32_t vertex_enter(const cni_faces *hull, int32_t vertex, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out, int32_t *out_feature)
{
	*out_feature = vertex;
	return hull->radius > 0.0f && disc_enter(hull->points[vertex], hull->radius, origin, translation, out);
}

static int32_t face_enter(const cni_faces *hull, const clip *c, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out, int32_t *out_feature)
{
	int32_t next = next_of(hull, c->face);
	cni_vec2 a = hull->points[c->face], edge = cni_sub(hull->points[next], a);
	float at = cni_dot(cni_sub(cni_madd(origin, c->enter, translation), a), edge);
	float length_sq = cni_length_sq(edge);
	if (hull->radius > 0.0f && at < 0.0f)
		return vertex_enter(hull, c->face, origin, translation, out, out_feature);
	if (hull->radius > 0.0f && at > length_sq)
		return vertex_enter(hull, next, origin, translation, out, out_feature);
	*out_feature = hull->count + c->face;
	a = cni_madd(a, cni_clamp(at / length_sq, 0.0f, 1.0f), edge);
	return hit_make(c->enter, cni_madd(a, hull->radius, c->normal), c->normal, 0.0f, 0, out);
}

/* An origin inside the skeleton: the way out is through the nearest face. */
static int32_t inside_skeleton(const cni_faces *hull, const clip *c, cni_vec2 origin, cni_cast_hit *out, int32_t *out_feature)
{
	cni_vec2 normal = face_normal(hull, c->face_most);
	cni_vec2 on_skeleton = cni_madd(origin, -c->height_most, normal);
	*out_feature = hull->count + c->face_most;
	return hit_make(0.0f, cni_madd(on_skeleton, hull->radius, normal), normal, hull->radius - c->height_most, 1, out);
}

int32_t cni_cast_hull_ray(const cni_faces *hull, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out, int32_t *out_feature)
{
	clip c;
	*out_feature = CNI_NONE;
	if (hull->count == 1)
		return inside_outline(hull, origin, out, out_feature) || vertex_enter(hull, 0, origin, translation, out, out_feature);
	if (!hull_clip(hull, origin, translation, &c))
		return 0;
	if (c.face != CNI_NONE)
		return face_enter(hull, &c, origin, translation, out, out_feature);
	if (hull->count > 2 && c.height_most <= 0.0f)
		return inside_skeleton(hull, &c, origin, out, out_feature);
	if (inside_outline(hull, origin, out, out_feature))
		return 1;
	return vertex_enter(hull, nearest_vertex(hull, origin), origin, translation, out, out_feature);
}

/* ------------------------------------------------------------------ edge */

/* The side of the ray's line on which an end lies is computed from that end alone, so that no ray passes between two edges
   that share an end. */
static int32_t edge_enter(cni_vec2 a, cni_vec2 b, int32_t one_sided, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out)
{
	cni_vec2 edge = cni_sub(b, a), normal = cni_normalize(cni_right_perp(edge));
	float speed = cni_dot(normal, translation);
	float height = cni_dot(normal, cni_sub(origin, a));
	float side_a = cni_cross(translation, cni_sub(a, origin));
	float side_b = cni_cross(translation, cni_sub(b, origin));
	if ((side_a < 0.0f && side_b < 0.0f) || (side_a > 0.0f && side_b > 0.0f) || side_a == side_b)
		return 0;
	if (speed > 0.0f && !one_sided) {
		normal = cni_neg(normal);
		speed = -speed;
		height = -height;
	}
	if (!(speed < 0.0f && height >= 0.0f && height <= -speed))
		return 0;
	return hit_make(height / -speed, cni_madd(a, side_a / (side_a - side_b), edge), normal, 0.0f, 0, out);
}

/* ------------------------------------------------------------------ any shape */

int32_t cni_cast_ray(const cni_geometry *g, int32_t child, cni_vec2 origin, cni_vec2 translation, cni_cast_hit *out)
{
	cni_vec2 storage[2];
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	cni_faces hull = { set.points, g->type == CN_SHAPE_POLYGON ? cni_geometry_normals(g) : NULL, set.count, set.radius };
	int32_t feature;
	if (g->type == CN_SHAPE_EDGE || g->type == CN_SHAPE_CHAIN)
		return edge_enter(set.points[0], set.points[1], g->type == CN_SHAPE_CHAIN, origin, translation, out);
	return cni_cast_hull_ray(&hull, origin, translation, out, &feature);
}
