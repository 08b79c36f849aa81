/*
 * query/mover.c - the character mover: one move of a caller's cn_mover through the world (see cn_mover_move in cairn.h).
 *
 * Reads the world; writes the mover, and forces on dynamic bodies that it pushes. The world stores nothing of a mover.
 *
 * The mover touches surfaces exactly, by planes at separation 0. The casts that prevent tunnelling move a core that is
 * smaller by a skin of half a slop, so that the ground or a wall along which the mover slides never stops a cast. The whole
 * shape overlaps a surface that stops the cast by the skin, and the next round of planes resolves it.
 *
 * Ground is a surface no steeper than the slope limit: a touched one, one slightly below, or the top of a step. A round shape touches the
 * corner of a step at any angle, so the surface behind the corner decides: a short ray down beside the contact point finds it.
 */
#include "query/mover.h"

/* Of the slop: the skin, and the distance at which surfaces are touched. */
#define SKIN_PER_SLOP 0.5f
#define MARGIN_PER_SLOP 0.1f
/* Sine of the normal's height below which a surface is a ceiling. */
#define CEILING_SINE 0.5f
/* A velocity along up, in length units a second, above which a mover on the ground jumps: more than rounding. */
#define JUMP_SPEED 1e-3f
/* Of the slop: how far beside a corner the surface behind it is looked for. */
#define BESIDE_PER_SLOP 1.0f
/* Sine of a slope below which a surface is level. */
#define LEVEL_SINE 1e-4f
/* Away from the ground, in length units a second, beyond which it is left: more than rounding. */
#define LEAVING_SPEED 1e-3f
/* Of the slop: nearer to the ground it does not hover. */
#define HOVER_PER_SLOP 0.002f

void cn_mover_def_init(cn_mover_def *def)
{
	if (!cni_def_begin(def, sizeof *def))
		return;
	def->shape.count = 2;
	def->shape.radius_m = 0.3f;
	def->shape.points_m[0].y = -0.5f;
	def->shape.points_m[1].y = 0.5f;
	cn_query_filter_init(&def->filter);
	def->up.y = 1.0f;
	def->slope_limit_rad = 0.87f;
	def->step_height_m = 0.3f;
	def->snap_m = 0.3f;
	def->gravity_scale = 1.0f;
	def->push_force_N = 200.0f;
	def->iterations_max = 8;
}

/* ------------------------------------------------------------------ arguments */

static void check_def(cni_call *call, const cn_mover_def *def)
{
	if (!cni_check_def(call, def, sizeof *def, "cn_mover_def_init"))
		return;
	cni_check_flags(call, "flags", def->flags, CN_MOVER_DROP);
	cni_check_range(call, "up.x", def->up.x, -1e6f, 1e6f);
	cni_check_range(call, "up.y", def->up.y, -1e6f, 1e6f);
	cni_check(call, cni_length(def->up) > 1e-6f, CN_ERROR_ARGUMENT, "up must have a length > 0");
	cni_check_range(call, "slope_limit_rad", def->slope_limit_rad, 0.0f, 0.5f * CNI_PI);
	cni_check_range(call, "step_height_m", def->step_height_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_range(call, "snap_m", def->snap_m, 0.0f, CNI_COORDINATE_MAX);
	cni_check_range(call, "gravity_scale", def->gravity_scale, -1e6f, 1e6f);
	cni_check_range(call, "push_force_N", def->push_force_N, 0.0f, 1e20f);
	cni_check_range_int(call, "iterations_max", def->iterations_max, 1, 64);
}

static void check_mover(cni_call *call, const cn_mover *mover)
{
	cni_check_pointer(call, "mover", mover);
	if (call->result != CN_OK)
		return;
	cni_check_position(call, "position_m", mover->position_m);
	cni_check_range(call, "velocity_mps.x", mover->velocity_mps.x, -1e6f, 1e6f);
	cni_check_range(call, "velocity_mps.y", mover->velocity_mps.y, -1e6f, 1e6f);
	cni_check_finite2(call, "ground_normal", mover->ground_normal);
	cni_check_finite2(call, "ground_point_m", mover->ground_point_m);
	cni_check_finite2(call, "ground_local_m", mover->ground_local_m);
	cni_check_finite2(call, "ground_velocity_mps", mover->ground_velocity_mps);
	cni_check_flags(call, "flags", mover->flags, CN_MOVER_ON_GROUND | CN_MOVER_ON_WALL | CN_MOVER_ON_CEILING);
}

/* The core: a region with a radius, or else points, reduced by the skin. */
static cni_region core_of(const cni_region *full, const cni_geometry *g, float skin)
{
	cni_region core = *full;
	float scale = 1.0f - cni_min(skin / cni_max(g->inner_radius, skin), 0.5f);
	if (full->radius > 0.0f) {
		core.radius -= cni_min(skin, 0.5f * full->radius);
		return core;
	}
	for (int32_t k = 0; k < core.count; ++k)
		core.points[k] = cni_madd(core.center, scale, cni_sub(core.points[k], core.center));
	return core;
}

static void move_begin(cni_move *m, cn_world *world, const cn_mover_def *def, const cni_region *region, cn_mover *mover, float dt)
{
	float slop = world->settings.slop;
	cn_polygon from_origin = cni_region_polygon(region);
	m->world = world;
	m->def = def;
	m->mover = mover;
	m->dt = dt;
	m->skin = SKIN_PER_SLOP * slop;
	m->margin = MARGIN_PER_SLOP * slop;
	m->up = cni_normalize(def->up);
	m->right = cni_right_perp(m->up);
	m->walkable = cni_sincos(def->slope_limit_rad).c;
	m->planes.count = 0;
	cni_solid_make(&from_origin, &m->solid);
	m->full = *region;
	m->core = core_of(region, &m->solid.g, m->skin);
	m->offset = region->origin;
	m->sight.filter.flags |= CN_QUERY_ONE_WAY;
	m->sight.touch = FLT_MAX;
	m->sight.without = CN_SHAPE_SENSOR | (def->flags & CN_MOVER_DROP ? (uint32_t)CN_SHAPE_ONE_WAY : 0u);
	mover->squeezed_m = 0.0f;
	cni_move_place(m, mover->position_m);
}

/* Moves the mover with its ground: the motion of its point of the ground since the last move, and conveyors. */
static void carry(cni_move *m)
{
	cn_mover *mover = m->mover;
	int32_t body = cni_handles_find(&m->world->body_handles, mover->ground_body);
	int32_t shape = cni_handles_find(&m->world->shape_handles, mover->ground_shape);
	cni_vec2 way = { 0.0f, 0.0f };
	if (!(mover->flags & CN_MOVER_ON_GROUND) || body == CNI_NONE)
		return;
	if (cni_body_at(m->world, body)->type != CN_BODY_STATIC)
		way = cni_sub(cni_body_to_world(cni_body_at(m->world, body), mover->ground_local_m), mover->ground_point_m);
	if (shape != CNI_NONE)
		way = cni_madd(way, cni_shape_at(m->world, shape)->tangent_speed * m->dt, cni_right_perp(mover->ground_normal));
	if (way.x != 0.0f || way.y != 0.0f)
		cni_move_slide(m, way);
}

/* ------------------------------------------------------------------ ground */

/* Clears the mover's ground. The functions below set it and return 1 if there is ground. */
static void ground_none(cni_move *m)
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
	*out = normal;
	if (!(cni_length(level) > LEVEL_SINE))
		return 1;
	cn_ray_hit behind = cni_ray_cast(&m->sight, from, cni_mul(-6.0f * beside, m->up));
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

/* Takes the most level walkable plane touched, unless the mover leaves it at velocity v. */
static int32_t ground_of_planes(cni_move *m, cni_vec2 v)
{
	const cn_plane *best = NULL;
	for (int32_t k = 0; k < m->planes.count; ++k) {
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
	int32_t equals = 1;
	for (int32_t k = 1; k < m->full.count; ++k) {
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

/* Finds ground within the snap distance below and moves down to it. */
static int32_t ground_snap(cni_move *m)
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
	cni_move_place(m, start);
	rise = step * cni_region_cast(&m->sight, &m->core, cni_mul(step, m->up)).fraction;
	cni_vec2 lifted = cni_madd(start, rise, m->up);
	cni_move_place(m, lifted);
	forward = way * cni_region_cast(&m->sight, &m->core, cni_mul(way, m->right)).fraction;
	cni_vec2 down = cni_mul(-(rise + m->def->snap_m), m->up);
	cni_move_place(m, cni_madd(lifted, forward, m->right));
	*hit = cni_region_cast(&m->sight, &m->full, down);
	if (hit->shape == 0 || cni_dot(m->up, cni_sub(hit->point_m, start)) - feet > step + m->skin)
		return 0;
	cni_move_place(m, cni_madd(m->mover->position_m, hit->fraction, down));
	return surface_normal(m, hit->point_m, hit->normal, normal) || is_walkable(m, hit);
}

/* Tries a step up from start and the distance way along `right`, of which sliding moved only `progress`. */
static int32_t ground_step(cni_move *m, cni_vec2 start, float way, float progress)
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

/* ------------------------------------------------------------------ pushing */

/* Applies a force to a dynamic body in the way, of at most push_force_N, that brings it to the mover's velocity in the next step. A force,
   not an impulse: if it is too weak to overcome friction, it does not move the body at all. */
static void push(const cni_move *m, const cn_plane *p, cni_vec2 velocity)
{
	const cni_body *b = cni_body_at(m->world, cni_body_index(m->world, p->body));
	float closing = cni_dot(cni_sub(cni_mover_velocity_at(m->world, p->body, p->point_m), velocity), p->normal);
	float lever = cni_cross(cni_body_arm(b, p->point_m), p->normal), yields;
	if (b->type != CN_BODY_DYNAMIC || !(closing > 0.0f) || !(m->def->push_force_N > 0.0f))
		return;
	yields = 1.0f / b->mass + (b->inertia > 0.0f ? lever * lever / b->inertia : 0.0f);
	cni_vec2 force = cni_mul(-cni_min(closing / (yields * m->dt), m->def->push_force_N), p->normal);
	(void)cn_body_apply_force_at(m->world, p->body, force.x, force.y, p->point_m.x, p->point_m.y);
}

static void push_all(const cni_move *m, cni_vec2 velocity)
{
	--m->world->locked;
	for (int32_t k = 0; k < m->planes.count; ++k)
		push(m, &m->planes.at[k], velocity);
	++m->world->locked;
}

/* ------------------------------------------------------------------ velocities */

/* Velocity without its parts into touched surfaces. */
static cni_vec2 clip(const cni_move *m, cni_vec2 v)
{
	float speeds[CNI_MOVER_PLANES_MAX];
	for (int32_t k = 0; k < m->planes.count; ++k) {
		const cn_plane *p = &m->planes.at[k];
		speeds[k] = cni_dot(p->normal, cni_mover_velocity_at(m->world, p->body, p->point_m));
	}
	return cni_planes_clip(m->planes.at, speeds, m->planes.count, cni_move_block_steep(m, v));
}

static void note_walls(const cni_move *m)
{
	m->mover->flags &= ~(uint32_t)(CN_MOVER_ON_WALL | CN_MOVER_ON_CEILING);
	for (int32_t k = 0; k < m->planes.count; ++k) {
		float height = cni_dot(m->planes.at[k].normal, m->up);
		if (height < -CEILING_SINE)
			m->mover->flags |= CN_MOVER_ON_CEILING;
		else if (height < m->walkable)
			m->mover->flags |= CN_MOVER_ON_WALL;
	}
}

/* ------------------------------------------------------------------ walking and flying */

static void walk(cni_move *m)
{
	cn_mover *mover = m->mover;
	float speed = cni_dot(mover->velocity_mps, m->right), progress, wanted;
	cni_vec2 along = cni_right_perp(mover->ground_normal), start = mover->position_m;
	cni_vec2 velocity = cni_madd(mover->ground_velocity_mps, speed, along), carried = mover->ground_velocity_mps;
	cni_move_slide(m, cni_mul(speed * m->dt, along));
	push_all(m, velocity);
	wanted = speed * m->dt * cni_dot(along, m->right);
	progress = cni_dot(cni_sub(mover->position_m, start), m->right);
	if ((wanted < 0.0f ? progress - wanted : wanted - progress) > m->margin) {
		if (ground_step(m, start, wanted, progress)) {
			mover->velocity_mps = cni_mul(speed, m->right);
			return;
		}
		speed = progress / m->dt;
	}
	if (ground_of_planes(m, carried) || ground_snap(m)) {
		mover->velocity_mps = cni_mul(speed, m->right);
		return;
	}
	ground_none(m);
	mover->velocity_mps = cni_madd(carried, speed, along);
}

static void fly(cni_move *m)
{
	cn_mover *mover = m->mover;
	cni_vec2 gravity = cni_mul(m->def->gravity_scale, m->world->settings.gravity);
	cni_vec2 v = mover->velocity_mps, way;
	if (mover->flags & CN_MOVER_ON_GROUND)
		v = cni_add(v, mover->ground_velocity_mps);
	ground_none(m);
	way = cni_madd(cni_mul(m->dt, v), 0.5f * m->dt * m->dt, gravity);
	v = cni_madd(v, m->dt, gravity);
	cni_move_slide(m, way);
	push_all(m, v);
	if (ground_of_planes(m, v))
		mover->velocity_mps = cni_mul(cni_dot(cni_sub(clip(m, v), mover->ground_velocity_mps), m->right), m->right);
	else
		mover->velocity_mps = clip(m, v);
}

cn_result cn_mover_move(cn_world *world, const cn_mover_def *def, float dt_s, cn_mover *mover)
{
	cni_call call = cni_enter(world, __func__);
	cni_move m;
	cni_region region;
	check_def(&call, def);
	if (call.result == CN_OK) {
		m.sight = cni_check_filter(&call, &def->filter);
		cni_check_region(&call, &def->shape, &region);
	}
	cni_check_range(&call, "dt_s", dt_s, FLT_MIN, 1.0f);
	check_mover(&call, mover);
	if (call.result != CN_OK)
		return call.result;
	move_begin(&m, world, def, &region, mover, dt_s);
	++world->locked; /* the filter may call the user's callback */
	carry(&m);
	if ((mover->flags & CN_MOVER_ON_GROUND) && !(cni_dot(mover->velocity_mps, m.up) > JUMP_SPEED * world->settings.length_unit))
		walk(&m);
	else
		fly(&m);
	--world->locked;
	note_walls(&m);
	return CN_OK;
}
