/*
 * query/mover_slide.c - moves a mover by a translation: casts, touched planes, sliding along them.
 */
#include "query/mover.h"

/* A round of sliding that moves by less, in slops, is the last one. */
#define MOVED_PER_SLOP 0.002f

void cni_move_place(cni_move *m, cni_vec2 position)
{
	m->mover->position_m = position;
	m->full.origin = m->core.origin = cni_add(position, m->offset);
}

/* Finds the planes that it touches. */
static void touch(cni_move *m)
{
	int32_t found;
	cni_planes_find(&m->sight, &m->full, &m->solid, m->margin, m->planes.at, CNI_MOVER_PLANES_MAX, &found);
	m->planes.count = cni_min_i(found, CNI_MOVER_PLANES_MAX);
}

cni_vec2 cni_move_block_steep(const cni_move *m, cni_vec2 v)
{
	int32_t k;
	for (k = 0; k < m->planes.count; ++k) {
		cni_vec2 normal = m->planes.at[k].normal;
		float height = cni_dot(normal, m->up), into;
		cni_vec2 level = cni_normalize(cni_madd(normal, -height, m->up));
		if (!(height > 0.0f && height < m->walkable))
			continue;
		into = cni_dot(level, v);
		if (into < 0.0f)
			v = cni_madd(v, -into, level);
	}
	return v;
}

void cni_move_slide(cni_move *m, cni_vec2 translation)
{
	cni_vec2 target = cni_add(m->mover->position_m, translation);
	float least = MOVED_PER_SLOP * m->world->settings.slop;
	int32_t k;
	for (k = 0; k <= m->def->iterations_max; ++k) {
		cn_ray_hit hit;
		cni_vec2 wanted = cni_sub(target, m->mover->position_m);
		if (k == m->def->iterations_max) /* only out of the surfaces that the last round hit */
			wanted = cni_v(0.0f, 0.0f);
		touch(m);
		wanted = cni_planes_solve(m->planes.at, m->planes.count, cni_move_block_steep(m, wanted), &m->mover->squeezed_m);
		if (cni_length(wanted) <= least) {
			cni_move_place(m, cni_add(m->mover->position_m, wanted));
			return;
		}
		hit = cni_region_cast(&m->sight, &m->core, wanted);
		cni_move_place(m, cni_madd(m->mover->position_m, hit.fraction, wanted));
	}
	touch(m);
}
