/*
 * test/families/meddle.c - what users do to a scene while it runs. One kind a seed, from 0.35 s on, an act each half second.
 *
 * Acts follow the clock and not frames, and draw their numbers from the seed, so that each solver gets the same ones. Energy and
 * displacement are not judged then.
 */
#include "families.h"

#include <math.h>

#define FIRST_S 0.35
#define PERIOD_S 0.5  /* from act to act */
#define HOLD_S 0.3    /* the mouse, hands and other gravity last so long */
#define CARRIED_MPS 2.0

enum {
	MEDDLE_BLOW = 1, /* an impulse that gives 1 to 30 m/s */
	MEDDLE_VELOCITY, /* is set */
	MEDDLE_DRAG,     /* the mouse pulls a part up to 3 m away, with 10 to 1,000 of its weights */
	MEDDLE_CUT,      /* a joint is destroyed */
	MEDDLE_GRAVITY,  /* turns for a while */
	MEDDLE_HOLD,     /* a part is static for a while */
	MEDDLE_MASS,     /* of a part times 0.1 to 10 */
	MEDDLE_CARRY,    /* a fixed part is moved by setting its pose in each frame */
	MEDDLE_PUT,      /* a part is put 0.1 to 3 m away */
	MEDDLE_PULL,     /* a part is kinematic for a while, and goes on at its speed */
	MEDDLE_LOCK,     /* a part is kept from moving along x, y or both, or from turning, for a while */
	MEDDLE_LIMIT,    /* a joint gets limits about where it is or up to half a radian or metre away */
	MEDDLE_MOTOR,    /* a joint gets a motor for a while */
	MEDDLE_VANISH,   /* a part is disabled for a while */
	MEDDLE_TIE,      /* a rod joins a part to another for a while */
	MEDDLE_GROW,     /* a part changes its size by 0.7 to 1.4 */
	MEDDLE_TURN,     /* a part is turned, by up to half a turn */
	MEDDLE_CHANGE,   /* a rod changes its length by 0.5 to 2, a weld or slide its angle by up to a radian */
	MEDDLE_SOFTEN,   /* a joint has a stiffness of 1 to 60 Hz, or a greatest force of 0.1 to 10 weights, for a while */
	MEDDLE_STEP,     /* the number of substeps is 1 to 16 for a while */
	MEDDLE_JOIN,     /* a part is welded or pinned to another where both are */
	MEDDLE_KINDS = MEDDLE_JOIN,
	MEDDLE_SOLVER    /* a part and a joint are solved directly, or softly, for a while: by its number alone */
};

void meddle_begin(scene *s, int32_t kind)
{
	if (kind == 0)
		return;
	s->meddle = kind > 0 ? kind : pick_int(s, 1, MEDDLE_KINDS);
	s->next_act_s = FIRST_S;
	s->flags = (s->flags & ~(uint32_t)SCENE_STANDS) | SCENE_NO_ENERGY;
}

/* A body that the act may change, WORLD if there is none after some draws. */
static int32_t pick_body(scene *s, int32_t dynamic)
{
	int32_t k;
	for (k = 0; k < 50; ++k) {
		int32_t body = pick_int(s, 0, s->body_count - 1);
		if (s->bodies[body].dynamic == dynamic && s->bodies[body].reach < 20.0)
			return body;
	}
	return WORLD;
}

static cn_result act_drag(scene *s, const scene_body *b)
{
	cn_mouse_def def;
	cn_mouse_def_init(&def);
	def.base.body_b = b->handle;
	def.base.anchor_b_m.x = def.base.anchor_b_m.y = 0.0f;
	def.target_m.x = (float)(b->px + pick(s, -3.0, 3.0));
	def.target_m.y = (float)(b->py + pick(s, -1.0, 3.0));
	def.base.force_max_N = (float)(b->mass * GRAVITY * pick_log(s, 10.0, 1000.0));
	return cn_joint_create_mouse(s->world, &def, &s->mouse);
}

static cn_result act_cut(scene *s)
{
	int32_t k = s->joint_count > 0 ? pick_int(s, 0, s->joint_count - 1) : -1;
	cn_joint handle;
	if (k < 0 || s->joints[k].handle == 0)
		return CN_OK;
	s->joints[k].type = -1; /* no error is measured */
	handle = s->joints[k].handle;
	s->joints[k].handle = 0;
	return cn_joint_destroy(s->world, handle);
}

static cn_result act_mass(scene *s, const scene_body *b)
{
	cn_mass_data mass;
	double ratio = pick_log(s, 0.1, 10.0);
	cn_result result = cn_body_get_mass_data(s->world, b->handle, &mass);
	if (result != CN_OK)
		return result;
	mass.mass_kg *= (float)ratio;
	mass.inertia_kgm2 *= (float)ratio;
	return cn_body_set_mass_data(s->world, b->handle, &mass);
}

static scene_joint *pick_joint(scene *s)
{
	scene_joint *j = s->joint_count > 0 ? &s->joints[pick_int(s, 0, s->joint_count - 1)] : NULL;
	return j != NULL && j->handle != 0 && (j->type == CN_JOINT_REVOLUTE || j->type == CN_JOINT_PRISMATIC || j->type == CN_JOINT_DISTANCE) ? j : NULL;
}

static cn_result joint_flag(scene *s, cn_joint joint, uint32_t flag, int32_t set)
{
	uint32_t flags;
	cn_result result = cn_joint_get_flags(s->world, joint, &flags);
	return result == CN_OK ? cn_joint_set_flags(s->world, joint, set ? flags | flag : flags & ~flag) : result;
}

static cn_result change_angle(scene *s, scene_joint *j, double by)
{
	cn_fixed_def weld;
	cn_prismatic_def slide;
	cn_result result;
	j->reference += by;
	if (j->type == CN_JOINT_FIXED) {
		result = cn_joint_get_fixed(s->world, j->handle, &weld);
		weld.reference_angle_rad += (float)by;
		return result == CN_OK ? cn_joint_set_fixed(s->world, j->handle, &weld) : result;
	}
	result = cn_joint_get_prismatic(s->world, j->handle, &slide);
	slide.reference_angle_rad += (float)by;
	return result == CN_OK ? cn_joint_set_prismatic(s->world, j->handle, &slide) : result;
}

static cn_result act_change(scene *s)
{
	scene_joint *j = s->joint_count > 0 ? &s->joints[pick_int(s, 0, s->joint_count - 1)] : NULL;
	double by = pick(s, -1.0, 1.0), times = pick_log(s, 0.5, 2.0);
	cn_distance_def rod;
	cn_result result;
	if (j == NULL || j->handle == 0)
		return CN_OK;
	if (j->type == CN_JOINT_FIXED || j->type == CN_JOINT_PRISMATIC)
		return change_angle(s, j, by);
	if (j->type != CN_JOINT_DISTANCE || j->lower != j->upper)
		return CN_OK;
	result = cn_joint_get_distance(s->world, j->handle, &rod);
	rod.length_m *= (float)times;
	j->lower *= times;
	j->upper *= times;
	return result == CN_OK ? cn_joint_set_distance(s->world, j->handle, &rod) : result;
}

/* Of the joint that s->driven is; weak 0: as strong as any. */
static cn_result strength_set(scene *s, double weak, double hertz)
{
	cn_joint_base base;
	cn_result result = cn_joint_get_base(s->world, s->driven, &base);
	base.force_max_N = base.torque_max_Nm = weak > 0.0 ? (float)weak : (float)CN_DEFAULT;
	base.stiffness_hertz = hertz > 0.0 ? (float)hertz : (float)CN_DEFAULT;
	base.stiffness_damping_ratio = 0.5f;
	return result == CN_OK ? cn_joint_set_base(s->world, s->driven, &base) : result;
}

static cn_result act_soften(scene *s)
{
	scene_joint *j = s->joint_count > 0 ? &s->joints[pick_int(s, 0, s->joint_count - 1)] : NULL;
	double hertz = pick_log(s, 1.0, 60.0), weights = pick_log(s, 0.1, 10.0);
	int32_t weak = chance(s, 0.5);
	if (j == NULL || j->handle == 0 || j->type < 0 || j->type >= ANGLE_CONSTRAINT)
		return CN_OK;
	s->driven = j->handle;
	return strength_set(s, weak ? weights * GRAVITY * s->bodies[j->b].mass : 0.0, weak ? 0.0 : hertz);
}

static cn_result act_join(scene *s, int32_t body)
{
	int32_t other = pick_body(s, 1);
	const scene_body *b = &s->bodies[body], *a = other == WORLD ? NULL : &s->bodies[other];
	int32_t weld = chance(s, 0.5);
	cn_vec2 local;
	cn_joint joint;
	cn_fixed_def fixed;
	cn_revolute_def pin;
	if (a == NULL || other == body || hypot(a->px - b->px, a->py - b->py) > a->reach + b->reach + 1.0)
		return CN_OK;
	cn_fixed_def_init(&fixed);
	cn_revolute_def_init(&pin);
	if (cn_body_get_local_point(s->world, a->handle, (float)b->px, (float)b->py, &local) != CN_OK)
		return CN_OK;
	fixed.base.body_a = pin.base.body_a = a->handle;
	fixed.base.body_b = pin.base.body_b = b->handle;
	fixed.base.anchor_a_m = pin.base.anchor_a_m = local;
	fixed.reference_angle_rad = (float)remainder(b->turned - a->turned, 2.0 * PI);
	fixed.base.flags |= CN_JOINT_COLLIDE;
	pin.base.flags |= CN_JOINT_COLLIDE;
	return weld ? cn_joint_create_fixed(s->world, &fixed, &joint) : cn_joint_create_revolute(s->world, &pin, &joint);
}

static cn_result act_solver(scene *s, int32_t body)
{
	scene_joint *j = s->joint_count > 0 ? &s->joints[pick_int(s, 0, s->joint_count - 1)] : NULL;
	int32_t of_body = pick_int(s, CN_SOLVER_SOFT, CN_SOLVER_DIRECT), of_joint = pick_int(s, CN_SOLVER_SOFT, CN_SOLVER_DIRECT);
	cn_result result = CN_OK;
	if (j != NULL && j->handle != 0 && j->type >= 0 && j->type < ANGLE_CONSTRAINT) {
		s->driven = j->handle;
		result = cn_joint_set_solver(s->world, j->handle, of_joint);
	}
	return result == CN_OK ? cn_body_set_solver(s->world, s->bodies[body].handle, of_body) : result;
}

static cn_result act_limit(scene *s)
{
	scene_joint *j = pick_joint(s);
	double away = pick(s, -0.5, 0.5), room = pick(s, 0.0, 0.5);
	float now, lower, upper;
	cn_result result;
	if (j == NULL)
		return CN_OK;
	result = cn_joint_get_position(s->world, j->handle, &now);
	if (chance(s, 0.5))
		away = 0.0;
	lower = now + (float)(away - room);
	upper = now + (float)(away + room);
	if (j->type == CN_JOINT_DISTANCE && lower < 0.0f)
		lower = 0.0f;
	if (result != CN_OK || upper < lower || (j->type == CN_JOINT_REVOLUTE && (lower < -3.0f || upper > 3.0f)))
		return result;
	j->lower = (double)lower;
	j->upper = (double)upper;
	result = cn_joint_set_limits(s->world, j->handle, lower, upper);
	return result == CN_OK ? joint_flag(s, j->handle, CN_JOINT_LIMIT, 1) : result;
}

static cn_result act_motor(scene *s)
{
	scene_joint *j = pick_joint(s);
	double speed = pick(s, -10.0, 10.0), weights = pick_log(s, 1.0, 1000.0);
	cn_result result;
	if (j == NULL || j->type == CN_JOINT_DISTANCE)
		return CN_OK;
	s->driven = j->handle;
	result = cn_joint_set_motor(s->world, j->handle, (float)speed, (float)(weights * GRAVITY * s->bodies[j->b].mass));
	return result == CN_OK ? joint_flag(s, j->handle, CN_JOINT_MOTOR, 1) : result;
}

static cn_result act_tie(scene *s, const scene_body *b)
{
	int32_t other = pick_body(s, 1);
	cn_distance_def def;
	if (other == WORLD || s->bodies[other].handle == b->handle)
		return CN_OK;
	cn_distance_def_init(&def);
	def.base.body_a = s->bodies[other].handle;
	def.base.body_b = b->handle;
	def.base.flags |= CN_JOINT_COLLIDE;
	def.length_m = (float)hypot(b->px - s->bodies[other].px, b->py - s->bodies[other].py);
	return cn_joint_create_distance(s->world, &def, &s->mouse);
}

static void polygon_grow(cn_polygon *hull, float by)
{
	int32_t k;
	for (k = 0; k < hull->count; ++k) {
		hull->points_m[k].x *= by;
		hull->points_m[k].y *= by;
	}
	hull->radius_m *= by;
}

/* About the body's origin. */
static cn_result shape_grow(cn_world *world, cn_shape shape, scene_shape *measured, double by)
{
	cn_circle circle;
	cn_capsule capsule;
	cn_polygon hull;
	int32_t k;
	float f = (float)by;
	for (k = 0; k < measured->count; ++k) {
		measured->points[k][0] *= by;
		measured->points[k][1] *= by;
	}
	measured->radius *= by;
	if (cn_shape_get_circle(world, shape, &circle) == CN_OK) {
		circle.center_m.x *= f;
		circle.center_m.y *= f;
		circle.radius_m *= f;
		return cn_shape_set_circle(world, shape, &circle);
	}
	if (cn_shape_get_capsule(world, shape, &capsule) == CN_OK) {
		capsule.a_m.x *= f;
		capsule.a_m.y *= f;
		capsule.b_m.x *= f;
		capsule.b_m.y *= f;
		capsule.radius_m *= f;
		return cn_shape_set_capsule(world, shape, &capsule);
	}
	if (cn_shape_get_polygon(world, shape, &hull) != CN_OK)
		return CN_OK;
	polygon_grow(&hull, f);
	return cn_shape_set_polygon(world, shape, &hull);
}

static cn_result act_grow(scene *s, int32_t body)
{
	double by = pick_log(s, 0.7, 1.4);
	cn_shape shapes[16];
	int32_t count = 0, k, of = 0;
	cn_result result = cn_body_get_shapes(s->world, s->bodies[body].handle, shapes, 16, &count);
	for (k = 0; k < s->shape_count && of < count && of < 16 && result == CN_OK; ++k)
		if (s->shapes[k].body == body)
			result = shape_grow(s->world, shapes[of++], &s->shapes[k], by);
	s->bodies[body].reach *= by;
	return result;
}

/* The act of a kind with a body. What lasts is undone by act_end. */
static cn_result act_begin(scene *s)
{
	double angle = pick(s, -PI, PI), speed = pick_log(s, 1.0, 30.0);
	int32_t body = pick_body(s, s->meddle != MEDDLE_CARRY);
	const scene_body *b = body == WORLD ? NULL : &s->bodies[body];
	s->held = body;
	s->held_angle = angle;
	if (s->meddle == MEDDLE_CUT)
		return act_cut(s);
	if (s->meddle == MEDDLE_LIMIT)
		return act_limit(s);
	if (s->meddle == MEDDLE_MOTOR)
		return act_motor(s);
	if (s->meddle == MEDDLE_CHANGE)
		return act_change(s);
	if (s->meddle == MEDDLE_SOFTEN)
		return act_soften(s);
	if (s->meddle == MEDDLE_STEP)
		return cn_world_set_substep_count(s->world, pick_int_log(s, 1, 16));
	if (s->meddle == MEDDLE_GRAVITY)
		return cn_world_set_gravity(s->world, (float)(GRAVITY * sin(angle)), (float)(-GRAVITY * cos(angle)));
	if (b == NULL)
		return CN_OK;
	switch (s->meddle) {
	case MEDDLE_BLOW:
		return cn_body_apply_impulse(s->world, b->handle, (float)(b->mass * speed * cos(angle)), (float)(b->mass * speed * sin(angle)));
	case MEDDLE_VELOCITY:
		return cn_body_set_velocity(s->world, b->handle, (float)(speed * cos(angle)), (float)(speed * sin(angle)), (float)(0.3 * speed));
	case MEDDLE_DRAG:
		return act_drag(s, b);
	case MEDDLE_HOLD:
		return cn_body_set_type(s->world, b->handle, CN_BODY_STATIC);
	case MEDDLE_PULL:
		return cn_body_set_type(s->world, b->handle, CN_BODY_KINEMATIC); /* goes on at its velocity */
	case MEDDLE_LOCK:
		return cn_body_set_flags(s->world, b->handle, (uint32_t)CN_BODY_ENABLED | (uint32_t)CN_BODY_SLEEP | (uint32_t)pick_int(s, 1, 7));
	case MEDDLE_VANISH:
		return cn_body_set_flags(s->world, b->handle, CN_BODY_SLEEP);
	case MEDDLE_TIE:
		return act_tie(s, b);
	case MEDDLE_GROW:
		return act_grow(s, body);
	case MEDDLE_SOLVER:
		return act_solver(s, body);
	case MEDDLE_JOIN:
		return act_join(s, body);
	case MEDDLE_TURN:
		return cn_body_set_pose(s->world, b->handle, (float)b->px, (float)b->py, (float)(b->turned + angle));
	case MEDDLE_MASS:
		return act_mass(s, b);
	case MEDDLE_PUT:
		return cn_body_set_pose(s->world, b->handle, (float)(b->px + 0.1 * speed * cos(angle)), (float)(b->py + 0.1 * speed * sin(angle)), (float)b->turned);
	default:
		return CN_OK;
	}
}

static cn_result act_end(scene *s)
{
	cn_result result = CN_OK;
	if (s->mouse != 0)
		result = cn_joint_destroy(s->world, s->mouse);
	if (s->meddle == MEDDLE_GRAVITY)
		result = cn_world_set_gravity(s->world, 0.0f, (float)-GRAVITY);
	if ((s->meddle == MEDDLE_HOLD || s->meddle == MEDDLE_PULL) && s->held != WORLD)
		result = cn_body_set_type(s->world, s->bodies[s->held].handle, CN_BODY_DYNAMIC);
	if (s->driven != 0 && s->meddle == MEDDLE_SOLVER)
		result = cn_joint_set_solver(s->world, s->driven, CN_SOLVER_AUTO);
	else if (s->driven != 0)
		result = s->meddle == MEDDLE_SOFTEN ? strength_set(s, 0.0, 0.0) : joint_flag(s, s->driven, CN_JOINT_MOTOR, 0);
	if (s->meddle == MEDDLE_SOLVER && s->held != WORLD)
		result = cn_body_set_solver(s->world, s->bodies[s->held].handle, CN_SOLVER_AUTO);
	if (s->meddle == MEDDLE_STEP)
		result = cn_world_set_substep_count(s->world, s->substeps);
	s->driven = 0;
	if ((s->meddle == MEDDLE_LOCK || s->meddle == MEDDLE_VANISH) && s->held != WORLD)
		result = cn_body_set_flags(s->world, s->bodies[s->held].handle, (uint32_t)CN_BODY_ENABLED | (uint32_t)CN_BODY_SLEEP);
	s->mouse = 0;
	s->held = WORLD;
	return result;
}

/* A fixed part that its user carries by setting its pose in each frame. */
static cn_result act_carry(scene *s, double dt_s)
{
	const scene_body *b = &s->bodies[s->held];
	double way = CARRIED_MPS * dt_s;
	return cn_body_set_pose(s->world, b->handle, (float)(b->px + way * cos(s->held_angle)), (float)(b->py + way * sin(s->held_angle)), (float)b->turned);
}

cn_result meddle(scene *s, double now_s, double dt_s)
{
	cn_result result = CN_OK;
	if (s->meddle == 0)
		return CN_OK;
	if (s->act_end_s > 0.0 && now_s >= s->act_end_s) {
		result = act_end(s);
		s->act_end_s = 0.0;
	}
	if (result == CN_OK && now_s >= s->next_act_s) {
		result = act_begin(s);
		s->act_end_s = s->next_act_s + HOLD_S;
		s->next_act_s += PERIOD_S;
	}
	if (result == CN_OK && s->meddle == MEDDLE_CARRY && s->act_end_s > 0.0 && s->held != WORLD)
		result = act_carry(s, dt_s);
	return result == CN_ERROR_STATE ? CN_OK : result; /* a joint would be left without a dynamic body: the part is not held */
}
