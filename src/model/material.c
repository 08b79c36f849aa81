/*
 * model/material.c - materials of shapes, and their mixture for a pair.
 */
#include "model/world.h"

int32_t cni_shape_store_material(cn_world *world, cni_shape *s, const cn_material *material)
{
	if (material->user_id != 0 && !cni_shape_reserve_extra(world, s))
		return 0;
	s->static_friction = material->static_friction;
	s->dynamic_friction = material->dynamic_friction;
	s->restitution = material->restitution;
	s->rolling_resistance = material->rolling_resistance;
	s->tangent_speed = material->tangent_speed_mps;
	s->mix = (uint8_t)(material->friction_mix | material->restitution_mix << 4);
	if (s->extra != 0)
		cni_shape_extra_of(&world->blocks, s)->material_id = material->user_id;
	return 1;
}

cn_material cni_shape_material(const cn_world *world, const cni_shape *s)
{
	cn_material m = { s->static_friction, s->dynamic_friction, s->restitution, s->rolling_resistance, s->tangent_speed, s->mix & 15, s->mix >> 4,
		cni_shape_material_id(&world->blocks, s) };
	return m;
}

static float mix(int32_t rule, float a, float b)
{
	switch (rule) {
	case CN_MIX_AVERAGE: return 0.5f * (a + b);
	case CN_MIX_GEOMETRIC: return cni_sqrt(a * b);
	case CN_MIX_MINIMUM: return cni_min(a, b);
	case CN_MIX_MULTIPLY: return a * b;
	default: return cni_max(a, b);
	}
}

/* Conveyor speeds add up: each surface moves to the right of its own outward normal. */
static cn_material mix_by_rules(const cn_material *a, const cn_material *b)
{
	int32_t friction_rule = cni_max_i(a->friction_mix, b->friction_mix);
	int32_t restitution_rule = cni_max_i(a->restitution_mix, b->restitution_mix);
	float sticking = mix(friction_rule, a->static_friction, b->static_friction);
	float sliding = cni_min(mix(friction_rule, a->dynamic_friction, b->dynamic_friction), sticking);
	cn_material m = { sticking, sliding, mix(restitution_rule, a->restitution, b->restitution), cni_max(a->rolling_resistance, b->rolling_resistance),
		a->tangent_speed_mps + b->tangent_speed_mps, friction_rule, restitution_rule, 0 };
	return m;
}

/* Clamps the output of the user's callback to the ranges of a material; NaN becomes the value of the mixing rules. */
static float clamp_or(float x, float upper, float otherwise)
{
	return cni_is_finite(x) ? cni_clamp(x, 0.0f, upper) : otherwise;
}

static void material_clamp(cn_material *m, const cn_material *rules)
{
	m->static_friction = clamp_or(m->static_friction, 100.0f, rules->static_friction);
	m->dynamic_friction = clamp_or(m->dynamic_friction, m->static_friction, rules->dynamic_friction);
	m->restitution = clamp_or(m->restitution, 1.0f, rules->restitution);
	m->rolling_resistance = clamp_or(m->rolling_resistance, 1e3f, rules->rolling_resistance);
	m->tangent_speed_mps = cni_is_finite(m->tangent_speed_mps) ? cni_clamp(m->tangent_speed_mps, -1e4f, 1e4f) : rules->tangent_speed_mps;
}

cn_material cni_material_mix(cn_world *world, int32_t shape_a, int32_t shape_b)
{
	cn_material a = cni_shape_material(world, cni_shape_at(world, shape_a)), b = cni_shape_material(world, cni_shape_at(world, shape_b));
	cn_material m = mix_by_rules(&a, &b), rules = m;
	if (world->material_mix == NULL)
		return m;
	++world->locked;
	world->material_mix(world, cni_handles_of(&world->shape_handles, shape_a), cni_handles_of(&world->shape_handles, shape_b), &m, world->material_mix_user);
	--world->locked;
	material_clamp(&m, &rules);
	return m;
}
