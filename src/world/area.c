/*
 * world/area.c - public functions on areas (sensors with gravity, damping and a medium) and on wind.
 */
#include "world/error.h"
#include "geometry/medium.h"

#include <string.h>

#define COEFFICIENT_MAX 1e9f

void cn_area_def_init(cn_area_def *def)
{
	if (!cni_def_begin(def, sizeof *def))
		return;
	def->pull_distance_m = CN_DEFAULT;
}

static void check_def(cni_call *call, const cn_area_def *def)
{
	if (!cni_check_def(call, def, sizeof *def, "cn_area_def_init"))
		return;
	cni_check_flags(call, "flags", def->flags, CNI_AREA_FLAGS);
	cni_check_finite2(call, "gravity_mps2", def->gravity_mps2);
	cni_check_position(call, "center_m", def->center_m);
	cni_check_finite(call, "pull_mps2", def->pull_mps2);
	cni_check_above_0_or_default(call, "pull_distance_m", def->pull_distance_m, CNI_POSITION_MAX_UNITS * call->world->settings.length_unit);
	cni_check_range(call, "linear_damping_per_s", def->linear_damping_per_s, 0.0f, COEFFICIENT_MAX);
	cni_check_range(call, "angular_damping_per_s", def->angular_damping_per_s, 0.0f, COEFFICIENT_MAX);
	cni_check_range(call, "density_kgpm2", def->density_kgpm2, 0.0f, COEFFICIENT_MAX);
	cni_check_range(call, "drag_kgpm2", def->drag_kgpm2, 0.0f, COEFFICIENT_MAX);
	cni_check_range(call, "lift_kgpm2", def->lift_kgpm2, 0.0f, COEFFICIENT_MAX);
	cni_check_finite2(call, "flow_mps", def->flow_mps);
}

cn_result cn_shape_set_area(cn_world *world, cn_shape shape, const cn_area_def *def)
{
	cni_call call = cni_enter(world, __func__);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	int32_t index = cni_shape_index(world, shape);
	cni_area area;
	cni_check(&call, CNI_HAS_AREAS, CN_ERROR_STATE, "this build has no areas: CN_NO_AREAS");
	if (call.result == CN_OK && (def != NULL || cni_area_of_shape(world, index) == NULL)) {
		cni_check(&call, (s->flags & CN_SHAPE_SENSOR) != 0, CN_ERROR_STATE, "the shape is no sensor");
		cni_check(&call, s->type != CN_SHAPE_EDGE && s->type != CN_SHAPE_CHAIN, CN_ERROR_STATE, "edges and chains have no inside");
	}
	if (def != NULL && call.result == CN_OK)
		check_def(&call, def);
	if (call.result != CN_OK)
		return call.result;
	if (def != NULL) {
		area.shape = index;
		area.def = *def;
		area.def.struct_size = 0;
		area.def.pull_distance_m = cni_zero_of_default(def->pull_distance_m);
		if (!cni_area_set(world, &area))
			return cni_refuse(&call, CN_ERROR_MEMORY, "no memory for the area");
	} else {
		cni_area_remove(world, index);
	}
	cni_area_wake(world, index);
	return CN_OK;
}

cn_result cn_shape_get_area(const cn_world *world, cn_shape shape, cn_area_def *out)
{
	cni_call call = cni_enter_const(world);
	cni_check_shape(&call, "shape", shape);
	cni_check_pointer(&call, "out", out);
	if (call.result != CN_OK)
		return call.result;
	const cni_area *a = cni_area_of_shape(world, cni_shape_index(world, shape));
	if (a == NULL)
		return cni_refuse(&call, CN_ERROR_STATE, "the shape is no area");
	*out = a->def;
	out->struct_size = (uint32_t)sizeof *out;
	out->pull_distance_m = cni_default_of_zero(out->pull_distance_m);
	return CN_OK;
}

/* ------------------------------------------------------------------ wind */

/* Velocity of a body after wind on one of its shapes. */
static cn_velocity velocity_in_wind(const cn_world *world, const cni_body *b, const cni_shape *s, const cni_medium *wind, float dt)
{
	static const cni_medium_region everywhere = { { { 0.0f, 0.0f } }, { 0.0f }, 0 };
	cn_velocity v = cni_body_velocity(world, b);
	const cni_in_medium in = { cni_shape_geometry(&world->blocks, s), b->local_center, b->q, v.linear_mps, v.angular_radps };
	cni_medium_force force;
	const float mass[3] = { b->flags & CN_BODY_LOCK_X ? 0.0f : b->mass, b->flags & CN_BODY_LOCK_Y ? 0.0f : b->mass, b->flags & CN_BODY_LOCK_ROTATION ? 0.0f : b->inertia };
	float change[3];
	memset(&force, 0, sizeof force);
	cni_medium_add(&force, wind, &everywhere, &in);
	cni_medium_solve(&force, mass, dt, change);
	v.linear_mps = cni_add(v.linear_mps, cni_v(change[0], change[1]));
	v.angular_radps += change[2];
	return v;
}

cn_result cn_shape_apply_wind(cn_world *world, cn_shape shape, float flow_x_mps, float flow_y_mps, float drag_kgpm2, float lift_kgpm2, float dt_s, int32_t wake)
{
	cni_call call = cni_enter(world, __func__);
	const cni_shape *s = cni_check_shape(&call, "shape", shape);
	cni_medium wind = { { 0.0f, 1.0f }, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, { 0.0f, 0.0f } };
	wind.flow = cni_v(flow_x_mps, flow_y_mps);
	wind.drag = drag_kgpm2;
	wind.lift = lift_kgpm2;
	cni_check_finite2(&call, "flow_mps", wind.flow);
	cni_check_range(&call, "drag_kgpm2", drag_kgpm2, 0.0f, COEFFICIENT_MAX);
	cni_check_range(&call, "lift_kgpm2", lift_kgpm2, 0.0f, COEFFICIENT_MAX);
	cni_check_range(&call, "dt_s", dt_s, 0.0f, 1.0f);
	cni_check(&call, s == NULL || s->body != CNI_NONE, CN_ERROR_STATE, "the shape is not attached");
	if (call.result != CN_OK)
		return call.result;
	cni_body *b = cni_body_at(world, s->body);
	if (b->type != CN_BODY_DYNAMIC || !(b->flags & CN_BODY_ENABLED) || (wake == 0 && b->awake == 0))
		return CN_OK;
	cn_velocity v = velocity_in_wind(world, b, s, &wind, dt_s);
	if (!cni_is_finite2(v.linear_mps) || !cni_is_finite(v.angular_radps))
		return cni_refuse(&call, CN_ERROR_ARGUMENT, "the velocity after the wind must stay finite");
	cni_body_wake(world, s->body);
	cni_body_store_velocity(world, b, v);
	cni_body_kick(world, s->body);
	return CN_OK;
}
