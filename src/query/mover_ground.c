/*
 * query/mover_ground.c - the ground of a mover: a touched surface, a surface slightly below it, or the top of a step.
 *
 * Ground is a surface no steeper than the slope limit. A round shape touches the corner of a step at any angle, so the
 * surface behind the corner decides: a short ray down beside the contact point finds it.
 */
#include "query/mover.h"

/* Of the slop: how far beside a corner the surface behind it is looked for. */
#define BESIDE_PER_SLOP 1.0f
/* Sine of a slope below which a surface is level. */
#define LEVEL_SINE 1e-4f
/* Away from the ground, in length units a second, beyond which it is left: more than rounding. */
#define LEAVING_SPEED 1e-3f
/* Of the slop: nearer to the ground it does not hover. */
#define HOVER_PER_SLOP 0.002f

void cni_ground_none(cni_move *m)
{
	const cni_vec2 zero = { 0.0f, 0.0f };
	cn_mover *mover = m->mover;
	mover->flags &= ~(uint32_t)CN_MOVER_ON_GROUND;
	mover->ground_body = 0;
	mover->ground_shape = 0;
	mover->ground_normal = mover->ground_point_m = mover->ground_local_m = mover->ground_velocity_mps = zero;
}

static void ground_set(cni_move *m, cn_body body, cn_shape shape, cni_vec2 point, cni_vec2 normal)
{
	cn_mover *mover = m->mover;
	const cni_body *b = cni_body_at(m->world, cni_body_index(m->world, body));
	const cni_shape *s = cni_shape_at(m->world, cni_shape_index(m->world, shape));
	mover->flags |= CN_MOVER_ON_GROUND;
	mover->ground_body = body;
	mover->ground_shape = shape;
	mover->ground_normal = normal;
	mover->ground_local_m = cni_body_to_local(b, point);
	/* Computed as in the next move, so that a body at rest carries the mover by exactly 0. */
	mover->ground_point_m = cni_body_to_world(b, mover->ground_local_m);
	mover->ground_velocity_mps = cni_madd(cni_mover_velocity_at(m->world, body, point), s->tangent_speed, cni_right_perp(normal));
}

static int32_t is_walkable(const cni_move *m, const cn_ray_hit *hit)
{
	return hit->shape != 0 && cni_dot(hit->normal, m->up) >= m->walkable;
}

/* Normal of the surface at a contact: at a corner that of the surface uphill beside it, along which the mover continues. Returns 0 and
   the contact's own normal if that surface is not walkable. */
static int32_t surface_normal(const cni_move *m, cni_vec2 point, cni_vec2 normal, cni_vec2 *out)
{
	float beside = BESIDE_PER_SLOP * m->world->settings.slop;
	cni_vec2 level = cni_madd(normal, -cni_dot(normal, m->up), m->up);
	cni_vec2 from = cni_madd(cni_madd(point, -beside, cni_normalize(level)), 3.0f * beside, m->up);
	cn_ray_hit behind;
	*out = normal;
	if (!(cni_length(level) > LEVEL_SINE))
		return 1;
	behind = cni_ray_cast(&m->sight, from, cni_mul(-6.0f * beside, m->up));
	if (!is_walkable(m, &behind) || !(behind.fraction > 0.0f))
		return 0;
	*out = behind.normal;
	return 1;
}

/* Takes a plane as ground; moves a mover that hovers within the margin down to it. */
static void ground_take(cni_move *m, const cn_plane *p)
{
	float above = p->separation_m / cni_dot(p->normal, m->up);
	cni_vec2 normal;
	if (above > HOVER_PER_SLOP * m->world->settings.slop)
		cni_move_place(m, cni_madd(m->mover->position_m, -above, m->up));
	surface_normal(m, p->point_m, p->normal, &normal);
	ground_set(m, p->body, p->shape, p->point_m, normal);
}

int32_t cni_ground_of_planes(cni_move *m, cni_vec2 v)
{
	const cn_plane *best = NULL;
	int32_t k;
	for (k = 0; k < m->planes.count; ++k) {
		const cn_plane *p = &m->planes.at[k];
		float height = cni_dot(p->normal, m->up);
		float leaving = cni_dot(p->normal, cni_sub(v, cni_mover_velocity_at(m->world, p->body, p->point_m)));
		if (height < m->walkable || leaving > LEAVING_SPEED * m->world->settings.length_unit)
			continue;
		if (best == NULL || height > cni_dot(best->normal, m->up))
			best = p;
	}
	if (best != NULL)
		ground_take(m, best);
	return best != NULL;
}

/* Lowest point of the mover. */
static cni_vec2 foot(const cni_move *m)
{
	cni_vec2 low = m->full.points[0];
	int32_t k, equals = 1;
	for (k = 1; k < m->full.count; ++k) {
		float rise = cni_dot(m->up, cni_sub(m->full.points[k], low));
		if (rise < -m->margin) {
			low = m->full.points[k];
			equals = 1;
		} else if (rise <= m->margin) { /* the mean of the points of a flat foot */
			++equals;
			low = cni_lerp(low, m->full.points[k], 1.0f / (float)equals);
		}
	}
	return cni_madd(cni_add(m->full.origin, low), -m->full.radius, m->up);
}

int32_t cni_ground_snap(cni_move *m)
{
	cni_vec2 down = cni_mul(-m->def->snap_m, m->up);
	cn_ray_hit hit = cni_region_cast(&m->sight, &m->full, down), ground = hit;
	if (hit.shape == 0)
		return 0;
	if (is_walkable(m, &hit))
		surface_normal(m, hit.point_m, hit.normal, &ground.normal);
	else /* over the corner of a step the ground under the foot decides */
		ground = cni_ray_cast(&m->sight, cni_madd(foot(m), m->skin, m->up), cni_madd(down, -m->skin, m->up));
	if (!is_walkable(m, &hit) && !is_walkable(m, &ground))
		return 0;
	cni_move_place(m, cni_madd(m->mover->position_m, hit.fraction, down));
	ground_set(m, ground.body, ground.shape, ground.point_m, ground.normal);
	return 1;
}

/* Moves up by a step, forward, and down: 1 if it lands on a walkable surface no higher than a step. */
static int32_t step_lands(cni_move *m, cni_vec2 start, float way, cn_ray_hit *hit, cni_vec2 *normal)
{
	float step = m->def->step_height_m, feet = cni_dot(m->up, cni_sub(foot(m), m->mover->position_m)), rise, forward;
	cni_vec2 lifted, down;
	cni_move_place(m, start);
	rise = step * cni_region_cast(&m->sight, &m->core, cni_mul(step, m->up)).fraction;
	lifted = cni_madd(start, rise, m->up);
	cni_move_place(m, lifted);
	forward = way * cni_region_cast(&m->sight, &m->core, cni_mul(way, m->right)).fraction;
	down = cni_mul(-(rise + m->def->snap_m), m->up);
	cni_move_place(m, cni_madd(lifted, forward, m->right));
	*hit = cni_region_cast(&m->sight, &m->full, down);
	if (hit->shape == 0 || cni_dot(m->up, cni_sub(hit->point_m, start)) - feet > step + m->skin)
		return 0;
	cni_move_place(m, cni_madd(m->mover->position_m, hit->fraction, down));
	return surface_normal(m, hit->point_m, hit->normal, normal) || is_walkable(m, hit);
}

int32_t cni_ground_step(cni_move *m, cni_vec2 start, float way, float progress)
{
	cni_vec2 end = m->mover->position_m, normal;
	cni_planes planes = m->planes;
	cn_ray_hit hit;
	if (step_lands(m, start, way, &hit, &normal)) {
		cni_move_slide(m, cni_v(0.0f, 0.0f));
		if (cni_abs(cni_dot(m->right, cni_sub(m->mover->position_m, start))) > cni_abs(progress) + m->margin) {
			ground_set(m, hit.body, hit.shape, hit.point_m, normal);
			return 1;
		}
	}
	cni_move_place(m, end);
	m->planes = planes;
	return 0;
}
