/*
 * model/body_shapes.c - the numbers that a body has from its shapes: mass, centre of mass, inertia, extent, core. They are computed from all
 * shapes, except while shapes are added to a body of many, removed or changed one by one: then they are updated, and computed when the next
 * step begins.
 */
#include "model/world.h"

#include <float.h>

#define MASSES_KEPT 4

/* Mass, centre and inertia of all shapes: first the centre, then the inertia about it (Steiner). Few shapes' own are computed once. */
static cn_mass_data shapes_mass(const cn_world *world, const cni_body *b)
{
	cn_mass_data total = { 0.0f, 0.0f, { 0.0f, 0.0f } }, kept[MASSES_KEPT];
	int32_t index, k = 0;
	for (index = b->shape_first; index != CNI_NONE; index = cni_shape_at(world, index)->next, ++k) {
		const cni_shape *s = cni_shape_at(world, index);
		cn_mass_data m = cni_geometry_mass(cni_shape_geometry(&world->blocks, s), s->density);
		total.mass_kg += m.mass_kg;
		total.center_m = cni_madd(total.center_m, m.mass_kg, m.center_m);
		if (k < MASSES_KEPT)
			kept[k] = m;
	}
	if (total.mass_kg <= 0.0f)
		return total;
	total.center_m = cni_mul(1.0f / total.mass_kg, total.center_m);
	for (index = b->shape_first, k = 0; index != CNI_NONE; index = cni_shape_at(world, index)->next, ++k) {
		const cni_shape *s = cni_shape_at(world, index);
		cn_mass_data m = k < MASSES_KEPT ? kept[k] : cni_geometry_mass(cni_shape_geometry(&world->blocks, s), s->density);
		total.inertia_kgm2 += m.inertia_kgm2 + m.mass_kg * cni_distance_sq(m.center_m, total.center_m);
	}
	return total;
}

/* Distance of a shape's farthest point from the centre of mass, without the rounding radius. */
static float shape_turn_reach(const cni_body *b, const cni_geometry *g)
{
	cni_vec2 storage[2];
	float most_sq = 0.0f;
	if (cni_is_chain(g->type))
		return g->extent + cni_length(b->local_center);
	cni_proxy_points set = cni_geometry_proxy(g, 0, storage);
	for (int32_t k = 0; k < set.count; ++k)
		most_sq = cni_max(most_sq, cni_distance_sq(set.points[k], b->local_center));
	return cni_sqrt(most_sq);
}

int32_t cni_body_spans(const cn_world *world, const cni_body *b, int32_t shape)
{
	const cni_geometry *g = cni_shape_geometry(&world->blocks, cni_shape_at(world, shape));
	float rounding = 1e-5f * b->extent, turn_reach = cni_is_chain(g->type) ? 0.0f : shape_turn_reach(b, g);
	return b->type == CN_BODY_STATIC || (turn_reach <= cni_body_turn_reach(b) + rounding && turn_reach + g->radius <= b->extent + rounding);
}

/* Rounds up, after subtracting the rounding error of a centre of mass; CNI_BODY_ROUNDING is larger. */
static uint8_t turn_reach_pack(float turn_reach, float extent)
{
	float part = extent > 0.0f ? (turn_reach / extent - 1e-6f) / CNI_TURN_REACH_UNIT : 0.0f, up = part > 0.0f ? part + 1.0f : 0.0f;
	return (uint8_t)cni_min(up, 255.0f);
}

static void shape_measure(const cn_world *world, cni_body *b, const cni_geometry *g)
{
	b->extent = cni_max(b->extent, g->extent);
	b->core = cni_min(b->core, g->inner_radius > 0.0f ? g->inner_radius : world->settings.slop);
}

static void measure_shapes(const cn_world *world, cni_body *b)
{
	float turn_reach = 0.0f;
	b->extent = 0.0f;
	b->core = b->shape_first == CNI_NONE ? 0.0f : FLT_MAX;
	for (int32_t index = b->shape_first; index != CNI_NONE; index = cni_shape_at(world, index)->next) {
		const cni_geometry *g = cni_shape_geometry(&world->blocks, cni_shape_at(world, index));
		shape_measure(world, b, g);
		if (b->type != CN_BODY_STATIC)
			turn_reach = cni_max(turn_reach, shape_turn_reach(b, g));
	}
	b->extent += cni_length(b->local_center);
	b->turn_reach = turn_reach_pack(turn_reach, b->extent);
	cni_body_forget_room(b);
}

void cni_body_set_center(cn_world *world, cni_body *b, cni_vec2 local_center)
{
	cni_vec2 shift = cni_rotate(b->q, cni_sub(local_center, b->local_center));
	cn_velocity v = cni_body_velocity(world, b);
	v.linear_mps = cni_madd(v.linear_mps, v.angular_radps, cni_left_perp(shift));
	v.linear_mps = cni_v(cni_saturate(v.linear_mps.x), cni_saturate(v.linear_mps.y));
	b->cx += shift.x;
	b->cy += shift.y;
	b->local_center = local_center;
	cni_contacts_invalidate_body(world, b);
	if (b->type != CN_BODY_STATIC)
		cni_body_store_velocity(world, b, v);
}

void cni_body_update_mass(cn_world *world, int32_t body)
{
	cni_body *b = cni_body_at(world, body);
	if (b->type != CN_BODY_DYNAMIC) {
		b->mass = b->inertia = 0.0f;
		cni_body_set_center(world, b, cni_v(0.0f, 0.0f));
	} else if (!(b->flags & CNI_BODY_MASS_OVERRIDE)) {
		cn_mass_data m = shapes_mass(world, b);
		b->mass = m.mass_kg > 0.0f ? m.mass_kg : 1.0f;
		b->inertia = m.mass_kg > 0.0f ? m.inertia_kgm2 : 0.0f;
		cni_body_set_center(world, b, m.center_m);
	}
	cni_readback_store(world, body);
	measure_shapes(world, b);
	cni_body_refresh_motion(world, b);
}

static int32_t has_mass_of_shapes(const cni_body *b) { return b->type == CN_BODY_DYNAMIC && !(b->flags & CNI_BODY_MASS_OVERRIDE); }

static int32_t has_shapes(const cn_world *world, const cni_body *b, int32_t least)
{
	int32_t shape = b->shape_first;
	while (shape != CNI_NONE && --least > 0)
		shape = cni_shape_at(world, shape)->next;
	return shape != CNI_NONE;
}

/* ---- many shapes, added, removed or changed one by one ---- */

#define SHAPES_MANY 16

void cni_body_masses_settle(cn_world *world)
{
	for (int32_t k = 0; k < world->masses_estimated; ++k) {
		int32_t body = cni_handles_find(&world->body_handles, world->estimated[k]);
		if (body != CNI_NONE)
			cni_body_update_mass(world, body);
	}
	world->masses_estimated = 0;
}

static void estimated_list_add(cn_world *world, int32_t body)
{
	cn_body handle = cni_handles_of(&world->body_handles, body);
	for (int32_t k = world->masses_estimated - 1; k >= 0; --k)
		if (world->estimated[k] == handle)
			return;
	if (world->masses_estimated == CNI_ESTIMATED_MOST)
		cni_body_masses_settle(world);
	world->estimated[world->masses_estimated++] = handle;
}

/* Mass, centre and inertia of the body with one more part (Steiner). */
static void mass_add(cn_world *world, cni_body *b, cn_mass_data m)
{
	float total = b->mass + m.mass_kg;
	cni_vec2 center = cni_madd(b->local_center, m.mass_kg / total, cni_sub(m.center_m, b->local_center));
	b->inertia += b->mass * cni_distance_sq(b->local_center, center) + m.inertia_kgm2 + m.mass_kg * cni_distance_sq(m.center_m, center);
	b->mass = total;
	cni_body_set_center(world, b, center);
}

static int32_t exponent_of(float x)
{
	return (int32_t)(cni_bits_of(x) >> 23);
}

/* Mass, centre and inertia of the body without one of its parts. Returns 0, and changes nothing, where mass or inertia falls below a power
   of two: what is subtracted from leaves its rounding error to the rest, so all is computed anew each time that about half is gone. */
static int32_t mass_subtract(cn_world *world, cni_body *b, cn_mass_data m)
{
	float rest = b->mass - m.mass_kg, inertia;
	if (!(rest > 0.0f) || exponent_of(rest) != exponent_of(b->mass))
		return 0;
	cni_vec2 center = cni_madd(b->local_center, -m.mass_kg / rest, cni_sub(m.center_m, b->local_center));
	inertia = b->inertia - m.inertia_kgm2 - m.mass_kg * cni_distance_sq(m.center_m, b->local_center) - rest * cni_distance_sq(b->local_center, center);
	if (!(inertia > 0.0f) || exponent_of(inertia) != exponent_of(b->inertia))
		return 0;
	b->mass = rest;
	b->inertia = inertia;
	cni_body_set_center(world, b, center);
	return 1;
}

/* The centre has moved from an earlier place, and g, unless NULL, is one more shape. Rounding must not make the extent too small. */
static void measure_add(cn_world *world, int32_t body, const cni_geometry *g, cni_vec2 earlier)
{
	cni_body *b = cni_body_at(world, body);
	float turn_reach = cni_body_turn_reach(b) + cni_length(cni_sub(b->local_center, earlier));
	b->extent = (1.0f + 4.0f * FLT_EPSILON) * b->extent - cni_length(earlier);
	if (g != NULL) {
		shape_measure(world, b, g);
		turn_reach = cni_max(turn_reach, shape_turn_reach(b, g));
	}
	b->extent += cni_length(b->local_center);
	b->turn_reach = turn_reach_pack(turn_reach, b->extent);
	cni_body_forget_room(b);
	cni_readback_store(world, body);
	cni_body_refresh_motion(world, b);
}

/* 1: the shape was added to a moving body of many shapes. A body whose shapes have no mass so far has a mass that is not theirs. */
static int32_t estimate_add(cn_world *world, int32_t body, int32_t added)
{
	cni_body *b = cni_body_at(world, body);
	const cni_shape *s = cni_shape_at(world, added);
	const cni_geometry *g = cni_shape_geometry(&world->blocks, s);
	cni_vec2 earlier = b->local_center;
	int32_t sums = has_mass_of_shapes(b);
	if (!has_shapes(world, b, SHAPES_MANY) || (sums && b->inertia <= 0.0f))
		return 0;
	estimated_list_add(world, body);
	if (sums)
		mass_add(world, b, cni_geometry_mass(g, s->density));
	measure_add(world, body, g, earlier);
	return 1;
}

int32_t cni_body_shape_leaves(cn_world *world, int32_t body, int32_t shape)
{
	cni_body *b = cni_body_at(world, body);
	const cni_shape *s = cni_shape_at(world, shape);
	cni_vec2 earlier = b->local_center;
	if (b->type == CN_BODY_STATIC || !has_shapes(world, b, SHAPES_MANY))
		return 0;
	if (has_mass_of_shapes(b) && !mass_subtract(world, b, cni_geometry_mass(cni_shape_geometry(&world->blocks, s), s->density)))
		return 0;
	estimated_list_add(world, body);
	measure_add(world, body, NULL, earlier);
	return 1;
}

void cni_body_shape_replaced(cn_world *world, int32_t body, int32_t shape, int32_t left)
{
	if (left || cni_body_at(world, body)->type == CN_BODY_STATIC)
		cni_body_shapes_changed(world, body, shape);
	else
		cni_body_update_mass(world, body);
}

void cni_body_shapes_changed(cn_world *world, int32_t body, int32_t added)
{
	cni_body *b = cni_body_at(world, body);
	if (b->type != CN_BODY_STATIC && added != CNI_NONE && estimate_add(world, body, added))
		return;
	if (b->type != CN_BODY_STATIC || !has_shapes(world, b, 2)) {
		cni_body_update_mass(world, body);
		return;
	}
	if (added != CNI_NONE)
		shape_measure(world, b, cni_shape_geometry(&world->blocks, cni_shape_at(world, added)));
	cni_contacts_invalidate_body(world, b);
	cni_body_forget_room(b);
}
