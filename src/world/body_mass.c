/*
 * world/body_mass.c - public functions on mass data, damping, gravity scale and sleep speed of a body. Mass data come from the
 * shapes unless CNI_BODY_MASS_OVERRIDE is set.
 */
#include "world/define.h"

static cn_mass_data mass_of(const cni_body *b)
{
	cn_mass_data m = { b->mass, b->inertia, b->local_center };
	return m;
}

CNI_DEFINE_GET(body, mass_data, cn_mass_data, mass_of(record))

cn_result cn_body_set_mass_data(cn_world *world, cn_body body, const cn_mass_data *mass)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	cni_check_pointer(&call, "mass", mass);
	cni_check(&call, b == NULL || b->type == CN_BODY_DYNAMIC, CN_ERROR_STATE, "the body is not dynamic");
	if (call.result != CN_OK)
		return call.result;
	cni_check_range(&call, "mass_kg", mass->mass_kg, 1e-20f, 1e20f);
	if (mass->inertia_kgm2 != 0.0f)
		cni_check_range(&call, "inertia_kgm2", mass->inertia_kgm2, 1e-35f, 1e35f);
	cni_check_position(&call, "center_m", mass->center_m);
	if (call.result != CN_OK)
		return call.result;
	b->flags |= CNI_BODY_MASS_OVERRIDE;
	b->mass = mass->mass_kg;
	b->inertia = mass->inertia_kgm2;
	cni_body_set_center(world, b, mass->center_m);
	cni_body_update_mass(world, cni_body_index(world, body));
	cni_body_wake(world, cni_body_index(world, body));
	return CN_OK;
}

cn_result cn_body_reset_mass_data(cn_world *world, cn_body body)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	if (call.result != CN_OK)
		return call.result;
	b->flags &= ~(uint32_t)CNI_BODY_MASS_OVERRIDE;
	cni_body_update_mass(world, cni_body_index(world, body));
	cni_body_wake(world, cni_body_index(world, body));
	return CN_OK;
}

cn_result cn_body_set_damping(cn_world *world, cn_body body, float linear_per_s, float angular_per_s)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	cni_check_at_least(&call, "linear_per_s", linear_per_s, 0.0f);
	cni_check_at_least(&call, "angular_per_s", angular_per_s, 0.0f);
	if (call.result != CN_OK)
		return call.result;
	b->linear_damping = linear_per_s;
	b->angular_damping = angular_per_s;
	return CN_OK;
}

CNI_DEFINE_GET2(body, damping, float, float, (*out_a = record->linear_damping, *out_b = record->angular_damping))

cn_result cn_body_set_gravity_scale(cn_world *world, cn_body body, float scale)
{
	cni_call call = cni_enter(world, __func__);
	cni_body *b = cni_check_body(&call, "body", body);
	cni_check_finite(&call, "scale", scale);
	if (call.result != CN_OK)
		return call.result;
	if (scale != b->gravity_scale)
		cni_body_wake(world, cni_body_index(world, body));
	b->gravity_scale = scale;
	return CN_OK;
}

CNI_DEFINE_GET(body, gravity_scale, float, record->gravity_scale)

CNI_DEFINE_SET(body, sleep_speed, float, speed_mps, cni_check_at_least_or_default(&call, "speed_mps", speed_mps), record->sleep_speed = speed_mps)
