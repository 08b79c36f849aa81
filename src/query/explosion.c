/*
 * query/explosion.c - the public function that pushes bodies away from a point.
 *
 * Each piece (a shape, or an edge of a chain) of a dynamic body within reach gets one impulse at its
 * point nearest to the centre, along the line from the centre to that point; at its centroid if the centre
 * is inside. The impulse is proportional to the piece's width across that line.
 *
 * The pieces are sorted by body, shape and child first, so that the order in which bodies wake does not
 * depend on the broadphase. All velocities are computed and checked before any is stored, so that a failed
 * call changes nothing.
 */
#include "query/query.h"
#include "base/sort.h"
#include "collision/distance.h"

#include <string.h>

void cn_explosion_def_init(cn_explosion_def *def)
{
	if (!cni_def_begin(def, sizeof *def))
		return;
	def->radius_m = 1.0f;
	cn_query_filter_init(&def->filter);
}

/* ------------------------------------------------------------------ finding the pieces */

typedef struct explosion {
	cn_world *world;
	const cn_explosion_def *def;
	const cni_sight *sight;
	uint64_t *keys;   /* body << 36 | shape << 16 | child; NULL: count only */
	int32_t count;
	int32_t capacity; /* of keys: the second call of the user's filter may have another result */
} explosion;

static float explosion_visit(void *context, int32_t proxy, float limit)
{
	explosion *e = (explosion *)context;
	cni_query_target t;
	if (!cni_query_target_of(e->sight, proxy, &t) || cni_sight_hides_one_way(e->sight, t.shape) || t.body->type != CN_BODY_DYNAMIC)
		return limit;
	cni_nearest n = cni_geometry_nearest(t.geometry, t.child, cni_body_to_local(t.body, e->def->center_m));
	if (n.distance > e->def->radius_m + e->def->falloff_m || cni_sight_ask_target(e->sight, &t) == CN_QUERY_SKIP)
		return limit;
	if (e->keys != NULL && e->count == e->capacity)
		return limit;
	if (e->keys != NULL)
		e->keys[e->count] = (uint64_t)(uint32_t)t.shape->body << 36 | (uint64_t)(uint32_t)t.index << 16 | (uint64_t)(uint32_t)t.child;
	++e->count;
	return limit;
}

static void find_pieces(explosion *e, uint64_t *keys)
{
	cni_aabb box = cni_box_fatten(cni_aabb_of(e->def->center_m, e->def->center_m), e->def->radius_m + e->def->falloff_m);
	e->keys = keys;
	e->capacity = e->count;
	e->count = 0;
	++e->world->locked; /* the filter may call the user's callback */
	e->world->broadphase_ops->query(e->world->broadphase, &box, explosion_visit, e);
	--e->world->locked;
}

/* ------------------------------------------------------------------ pushing */

/* Extent of a piece across a direction. */
static float width_across(const cni_geometry *g, int32_t child, cni_vec2 direction)
{
	cni_vec2 storage[2], side = cni_left_perp(direction);
	cni_proxy_points set = cni_geometry_proxy(g, child, storage);
	float least = cni_points_lowest(set.points, set.count, side), most = -cni_points_lowest(set.points, set.count, cni_neg(side));
	return most - least + 2.0f * set.radius;
}

static float strength_at(const cn_explosion_def *def, float distance)
{
	if (distance <= def->radius_m)
		return def->impulse_Nspm;
	return def->impulse_Nspm * cni_clamp(1.0f - (distance - def->radius_m) / def->falloff_m, 0.0f, 1.0f);
}

/* Adds the effect of one piece to its body's velocity; computes in the body's frame until the end. */
static void piece_push(const explosion *e, const cni_body *b, uint64_t key, cn_velocity *v)
{
	const cni_shape *s = cni_shape_at(e->world, (int32_t)(key >> 16 & 0xFFFFFu));
	const cni_geometry *g = cni_shape_geometry(&e->world->blocks, s);
	int32_t child = (int32_t)(key & 0xFFFFu);
	cni_vec2 center = cni_body_to_local(b, e->def->center_m);
	cni_nearest n = cni_geometry_nearest(g, child, center);
	cni_vec2 point = n.distance > 0.0f ? n.point : g->centroid;
	cni_vec2 direction = n.distance > 0.0f ? cni_neg(n.normal) : cni_normalize(cni_sub(point, center));
	cni_vec2 impulse = cni_mul(strength_at(e->def, n.distance) * width_across(g, child, direction), direction);
	cni_vec2 turned = cni_rotate(b->q, impulse);
	v->linear_mps = cni_add(v->linear_mps, cni_v(turned.x / b->mass, turned.y / b->mass));
	if (b->inertia > 0.0f)
		v->angular_radps += cni_cross(cni_sub(point, b->local_center), impulse) / b->inertia;
}

static int32_t key_body(uint64_t key)
{
	return (int32_t)(key >> 36);
}

/* Velocity of the body of piece *k after the impulses on all its pieces; moves *k past them. */
static cn_velocity body_push(const explosion *e, int32_t *k)
{
	int32_t body = key_body(e->keys[*k]);
	const cni_body *b = cni_body_at(e->world, body);
	cn_velocity v = cni_body_velocity(e->world, b);
	for (; *k < e->count && key_body(e->keys[*k]) == body; ++*k)
		piece_push(e, b, e->keys[*k], &v);
	return v;
}

static void check_velocities(cni_call *call, const explosion *e)
{
	int32_t k = 0;
	while (k < e->count && call->result == CN_OK) {
		cn_velocity v = body_push(e, &k);
		if (!cni_is_finite2(v.linear_mps) || !cni_is_finite(v.angular_radps))
			cni_refuse_float(call, "impulse_Nspm", e->def->impulse_Nspm, "must leave all velocities finite");
	}
}

static void apply(explosion *e)
{
	int32_t k = 0;
	while (k < e->count) {
		int32_t body = key_body(e->keys[k]);
		cn_velocity v = body_push(e, &k);
		cni_body_wake(e->world, body);
		cni_body_store_velocity(e->world, cni_body_at(e->world, body), v);
	}
}

static void check_def(cni_call *call, const cn_explosion_def *def)
{
	if (!cni_check_def(call, def, sizeof *def, "cn_explosion_def_init"))
		return;
	float limit = CNI_POSITION_MAX_UNITS * call->world->settings.length_unit;
	cni_check_range(call, "radius_m", def->radius_m, 0.0f, limit);
	cni_check_range(call, "falloff_m", def->falloff_m, 0.0f, limit);
	cni_check_finite(call, "impulse_Nspm", def->impulse_Nspm);
	cni_check_position(call, "center_m", def->center_m);
}

cn_result cn_world_explode(cn_world *world, const cn_explosion_def *def)
{
	cni_call call = cni_enter(world, __func__);
	cni_sight sight;
	explosion e = { world, def, &sight, NULL, 0, 0 };
	check_def(&call, def);
	sight = cni_check_filter(&call, call.result == CN_OK ? &def->filter : NULL);
	if (call.result != CN_OK)
		return call.result;
	find_pieces(&e, NULL);
	if (e.count == 0)
		return CN_OK;
	uint64_t *keys = (uint64_t *)cni_arena_push(&world->arena, (uint64_t)e.count * 2u * sizeof(uint64_t));
	if (keys == NULL)
		return cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the list of shapes");
	find_pieces(&e, keys);
	cni_sort_keys(keys, keys + e.count, e.count);
	check_velocities(&call, &e);
	if (call.result == CN_OK)
		apply(&e);
	cni_arena_pop(&world->arena, keys);
	return call.result;
}
