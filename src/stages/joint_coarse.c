/*
 * stages/joint_coarse.c - large nets of pins at rest: the part of their motion that passes over joints do not see is taken out
 * in every substep. What and why is in stages/joint_coarse.h; patches are made in stages/joint_patches.c.
 *
 * Reads joint blocks, motion, awake ids; writes world->coarse, motion velocities, and in islands when their nets rested.
 */
#include "stages/joint_coarse.h"

#include <string.h>

#define TURN_MOST 0.04f      /* radians, over the square root of a net's bodies */
#define MAKING 32            /* what making patches costs of a credit that grows by one a step ... */
#define CREDIT_MOST 128      /* ... up to this */
#define BALANCED_PART 0.01f  /* of what gravity gives in a substep */
#define BALANCED_SPEED 1e-5f /* length units a second, where there is little gravity */
#define BLOCKS_LEAST 4       /* of joints: fewer are no large net */
#define PINS_A_RANGE 512
#define PATCHES_A_RANGE 8

uint64_t cni_coarse_lay_out(cni_coarse_view *v, const cni_coarse *head, uint8_t *memory)
{
	uint64_t at = 0;
	v->head = (cni_coarse *)cni_coarse_piece(memory, &at, sizeof(cni_coarse));
	v->nets = (cni_net_range *)cni_coarse_piece(memory, &at, sizeof(cni_net_range) * (uint64_t)head->net_count);
	v->bodies = (cni_net_body *)cni_coarse_piece(memory, &at, sizeof(cni_net_body) * (uint64_t)head->body_count);
	v->pins = (cni_net_pin *)cni_coarse_piece(memory, &at, sizeof(cni_net_pin) * (uint64_t)head->pin_count);
	v->patches = (cni_patch *)cni_coarse_piece(memory, &at, sizeof(cni_patch) * (uint64_t)head->patch_count);
	v->entries = (double *)cni_coarse_piece(memory, &at, sizeof(double) * (uint64_t)head->entry_count);
	v->speeds = (double *)cni_coarse_piece(memory, &at, 2 * sizeof(double) * (uint64_t)head->mode_count);
	v->parts = (float *)cni_coarse_piece(memory, &at, sizeof(float) * (uint64_t)head->part_count);
	return at;
}

cni_coarse_view cni_coarse_view_of(const cn_world *world)
{
	cni_coarse_view v;
	(void)cni_coarse_lay_out(&v, (const cni_coarse *)world->coarse.data, (uint8_t *)world->coarse.data);
	return v;
}

/* ---- do they still hold ---- */

/* Pins that are in lanes of colours and not solved directly; *fixed: how many of them are to what cannot move, for by one a net
   may come to be held. */
static int32_t lanes_count(const cn_world *world, int32_t *fixed)
{
	int32_t color, index, l, count = 0;
	*fixed = 0;
	for (color = 0; color < CNI_JOINT_COLORS; ++color)
		for (index = world->joint_colors[color].first; index != CNI_NONE; index = cni_joint_blocks(world)[index].next)
			for (l = 0; l < CNI_LANES; ++l) {
				const cni_joint_block *block = &cni_joint_blocks(world)[index];
				int32_t takes = cni_coarse_takes(block, l);
				count += takes;
				*fixed += takes & (block->ia[l] == 0 || block->ib[l] == 0);
			}
	return count;
}

static float turn_most(const cni_net_range *net)
{
	return TURN_MOST / cni_sqrt((float)(net->body_end - net->body_begin));
}

/* All awake, as heavy and free as they were, and slow. */
static int32_t bodies_hold(const cn_world *world, const cni_coarse_view *v, const cni_net_range *net, float dt)
{
	const int32_t *ids = cni_awake_ids(world);
	float fast = turn_most(net) / dt;
	int32_t k;
	for (k = net->body_begin; k < net->body_end; ++k) {
		cni_net_body *b = &v->bodies[k];
		const cni_motion *m;
		if (b->index >= world->awake_count || ids[b->index] != b->body) {
			b->index = cni_body_at(world, b->body)->awake;
			if (b->index == 0 || b->index >= world->awake_count || ids[b->index] != b->body)
				return 0;
		}
		m = cni_motions(world) + b->index;
		if (m->inv_mass != b->inv_mass || m->inv_inertia != b->inv_inertia || cni_abs(m->w) > fast || (cni_drives(world)[b->index].flags & (CNI_DRIVE_LOCK_X | CNI_DRIVE_LOCK_Y)))
			return 0;
	}
	return 1;
}

/* The lane of every joint by its slot; NULL: no memory. */
static int32_t *lanes_look_up(cn_world *world)
{
	const int32_t *joints = (const int32_t *)world->awake_joints.data;
	int32_t *lanes = (int32_t *)cni_arena_push_once(&world->arena, sizeof(int32_t) * (uint64_t)cni_table_capacity(&world->joints));
	int32_t k;
	for (k = 0; lanes != NULL && k < cni_table_capacity(&world->joints); ++k)
		lanes[k] = CNI_NONE;
	for (k = 0; lanes != NULL && k < world->awake_joints.count; ++k)
		lanes[joints[k]] = cni_joint_works(world)[k].flags & (CNI_WORK_SWUNG | CNI_WORK_DIRECT | CNI_WORK_HERD) ? CNI_NONE : cni_joint_works(world)[k].lane;
	return lanes;
}

static int32_t have_turned(const cni_arms *now, const cni_arms *then, float most)
{
	float ax = now->ax - then->ax, ay = now->ay - then->ay, bx = now->bx - then->bx, by = now->by - then->by;
	return ax * ax + ay * ay > most * most * (then->ax * then->ax + then->ay * then->ay) ||
	       bx * bx + by * by > most * most * (then->bx * then->bx + then->by * then->by);
}

static int32_t index_of(const cni_coarse_view *v, int32_t net_body)
{
	return net_body == CNI_NONE ? 0 : v->bodies[net_body].index;
}

/* Is the pin in this lane? Arms that have turned show that it is not the one it was. */
static int32_t pin_is_at(const cn_world *world, const cni_coarse_view *v, const cni_net_pin *p, int32_t lane, float most)
{
	const cni_joint_block *k;
	cni_arms now;
	int32_t l = lane % CNI_LANES;
	if (lane == CNI_NONE || lane / CNI_LANES >= world->joint_blocks.count)
		return 0;
	k = cni_joint_blocks(world) + lane / CNI_LANES;
	if (k->ia[l] != index_of(v, p->a) || k->ib[l] != index_of(v, p->b))
		return 0;
	now = cni_coarse_arms(k, l);
	return !k->herd && cni_coarse_takes(k, l) && !have_turned(&now, &p->arms, most);
}

typedef struct pins_loop {
	const cn_world *world;
	const cni_coarse_view *v;
	const cni_net_range *net;
	uint32_t missed; /* 1: some pin is not where it was */
} pins_loop;

static void pins_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	pins_loop *loop = (pins_loop *)context;
	const cni_net_pin *pins = loop->v->pins + loop->net->pin_begin;
	float most = turn_most(loop->net);
	int32_t k;
	(void)worker;
	for (k = begin; k < end && !cni_atomic_peek(&loop->missed); ++k)
		if (!pin_is_at(loop->world, loop->v, &pins[k], pins[k].lane, most))
			cni_atomic_put(&loop->missed, 1);
}

/* Mostly all pins are where they were. */
static int32_t pins_stay(const cn_world *world, const cni_coarse_view *v, const cni_net_range *net)
{
	pins_loop loop = { world, v, net, 0 };
	cni_parallel_for(world, net->pin_end - net->pin_begin, PINS_A_RANGE, pins_range, &loop);
	return !loop.missed;
}

static int32_t pins_hold(cn_world *world, const cni_coarse_view *v, const cni_net_range *net, int32_t **lanes)
{
	float most = turn_most(net);
	int32_t k;
	if (pins_stay(world, v, net))
		return 1;
	for (k = net->pin_begin; k < net->pin_end; ++k) {
		cni_net_pin *p = &v->pins[k];
		if (pin_is_at(world, v, p, p->lane, most))
			continue;
		if (*lanes == NULL && (*lanes = lanes_look_up(world)) == NULL)
			return 0;
		p->lane = (*lanes)[p->joint];
		if (!pin_is_at(world, v, p, p->lane, most))
			return 0;
	}
	return 1;
}

/* Which nets hold; returns how many do not. */
static int32_t nets_look(cn_world *world, const cni_coarse_view *v, float dt)
{
	int32_t *lanes = NULL, k, failed = 0;
	for (k = 0; k < v->head->net_count; ++k) {
		cni_net_range *net = &v->nets[k];
		net->holds = !net->dear && bodies_hold(world, v, net, dt) && pins_hold(world, v, net, &lanes);
		net->rests = 0;
		failed += !net->dear && !net->holds;
	}
	(void)cni_arena_pop(&world->arena, lanes);
	return failed;
}

/* ---- the step ---- */

static uint32_t credit_of(const cn_world *world, const cni_coarse *old)
{
	uint32_t credit = old->credit + (world->step_count - old->made_step);
	return credit < CREDIT_MOST ? credit : CREDIT_MOST;
}

/* Patches are made anew at once where that has not been necessary for long, and then ever more rarely. 0: not now, or no memory. */
static int32_t make_anew(cn_world *world, int32_t lanes, int32_t fixed)
{
	const cni_coarse *old = world->coarse.count > 0 ? (const cni_coarse *)world->coarse.data : NULL;
	uint32_t credit = old == NULL ? CREDIT_MOST : credit_of(world, old);
	int32_t made;
	cni_coarse *head;
	if (credit < MAKING)
		return 0;
	made = cni_coarse_make(world, lanes);
	if (!made)
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	if (world->coarse.count == 0)
		return 0;
	head = (cni_coarse *)world->coarse.data;
	head->made_step = world->step_count;
	head->credit = credit - MAKING;
	if (made) { /* else it is asked for again */
		head->lanes = lanes;
		head->fixed = fixed;
	}
	return made;
}

void cni_coarse_prepare(cn_world *world, cni_solve *s)
{
	const cni_coarse *head;
	int32_t lanes, fixed, k;
	cni_coarse_view v;
	/* A world in a caller's block has set nothing aside for it. */
	if (world->joint_blocks.count < BLOCKS_LEAST || world->settings.solver != CN_SOLVER_AUTO || world->memory.fixed)
		return;
	lanes = lanes_count(world, &fixed);
	head = (const cni_coarse *)world->coarse.data;
	if (world->coarse.count == 0 || head->lanes != lanes || head->fixed != fixed)
		(void)make_anew(world, lanes, fixed);
	if (world->coarse.count == 0)
		return;
	v = cni_coarse_view_of(world);
	if (nets_look(world, &v, s->dt) > 0 && make_anew(world, lanes, fixed)) {
		v = cni_coarse_view_of(world);
		(void)nets_look(world, &v, s->dt);
	}
	for (k = 0; k < v.head->net_count; ++k)
		s->coarse |= v.nets[k].holds;
}

/* ---- a substep ---- */

/* q = F' M v */
static void speeds_find(const cn_world *world, const cni_coarse_view *v, const cni_patch *p)
{
	float sum[CNI_PATCH_MODES] = { 0.0f };
	const float *part = v->parts + p->part;
	int32_t k, i;
	for (k = p->body_begin; k < p->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + v->bodies[k].index;
		float px = m->vx / m->inv_mass, py = m->vy / m->inv_mass, turn = m->w / m->inv_inertia;
		for (i = 0; i < p->modes; ++i, part += 3)
			sum[i] += part[0] * px + part[1] * py + part[2] * turn;
	}
	for (i = 0; i < p->modes; ++i)
		v->speeds[p->mode + i] = (double)sum[i];
}

/* The velocity that the modes give a body; part: those of the body. */
CNI_INLINE cni_motion modes_velocity(const float *part, const float *speed, int32_t modes)
{
	cni_motion sum = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
	int32_t i;
	for (i = 0; i < modes; ++i, part += 3) {
		sum.vx += part[0] * speed[i];
		sum.vy += part[1] * speed[i];
		sum.w += part[2] * speed[i];
	}
	return sum;
}

/* Is what modes do not hold of the patch's velocity no more than forces that nearly balance leave behind? Energies. */
static int32_t is_balanced(const cn_world *world, const cni_coarse_view *v, const cni_patch *p, const float *speed, float least_speed)
{
	float left = 0.0f, most = 0.0f;
	int32_t k;
	for (k = p->body_begin; k < p->body_end; ++k) {
		const cni_motion *m = cni_motions(world) + v->bodies[k].index;
		cni_motion held = modes_velocity(v->parts + p->part + 3 * (k - p->body_begin) * p->modes, speed, p->modes);
		float x = m->vx - held.vx, y = m->vy - held.vy, turn = m->w - held.w;
		left += (x * x + y * y) / m->inv_mass + turn * turn / m->inv_inertia;
		most += 1.0f / m->inv_mass;
	}
	return left <= most * (least_speed * least_speed);
}

/* v += F (q' - q), or where balance is near F q' */
static void velocities_change(const cn_world *world, const cni_coarse_view *v, const cni_patch *p, const double *old, float least_speed)
{
	float before[CNI_PATCH_MODES], now[CNI_PATCH_MODES], keep;
	int32_t k, i;
	for (i = 0; i < p->modes; ++i) {
		before[i] = (float)old[p->mode + i];
		now[i] = (float)v->speeds[p->mode + i];
	}
	keep = is_balanced(world, v, p, before, least_speed) ? 0.0f : 1.0f;
	for (i = 0; i < p->modes && keep != 0.0f; ++i)
		now[i] = (float)(v->speeds[p->mode + i] - old[p->mode + i]);
	for (k = p->body_begin; k < p->body_end; ++k) {
		cni_motion *m = cni_motions(world) + v->bodies[k].index;
		cni_motion change = modes_velocity(v->parts + p->part + 3 * (k - p->body_begin) * p->modes, now, p->modes);
		m->vx = keep * m->vx + change.vx;
		m->vy = keep * m->vy + change.vy;
		m->w = keep * m->w + change.w;
	}
}

typedef struct patches_loop {
	const cn_world *world;
	const cni_coarse_view *v;
	const cni_patch *patches;
	const double *old;
	float least_speed;
} patches_loop;

static void speeds_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const patches_loop *loop = (const patches_loop *)context;
	int32_t k;
	(void)worker;
	for (k = begin; k < end; ++k)
		speeds_find(loop->world, loop->v, &loop->patches[k]);
}

static void velocities_range(void *context, int32_t begin, int32_t end, int32_t worker)
{
	const patches_loop *loop = (const patches_loop *)context;
	int32_t k;
	(void)worker;
	for (k = begin; k < end; ++k)
		velocities_change(loop->world, loop->v, &loop->patches[k], loop->old, loop->least_speed);
}

/* A body is in one patch. */
static void net_solve(const cn_world *world, const cni_solve *s, const cni_coarse_view *v, const cni_net_range *net)
{
	float least_speed = cni_max(BALANCED_PART * s->h * cni_length(world->settings.gravity), BALANCED_SPEED * world->settings.length_unit);
	double *old = v->speeds + v->head->mode_count;
	patches_loop loop = { world, v, v->patches + net->patch_begin, old, least_speed };
	int32_t p, patches = net->patch_end - net->patch_begin;
	cni_team_for(s->team, patches, PATCHES_A_RANGE, speeds_range, &loop);
	for (p = net->mode_begin; p < net->mode_end; ++p)
		old[p] = v->speeds[p];
	cni_coarse_system_solve(v, net);
	cni_team_for(s->team, patches, PATCHES_A_RANGE, velocities_range, &loop);
}

void cni_coarse_solve(cn_world *world, const cni_solve *s)
{
	cni_coarse_view v;
	int32_t k;
	if (!s->coarse)
		return;
	v = cni_coarse_view_of(world);
	for (k = 0; k < v.head->net_count; ++k)
		if (v.nets[k].holds && !v.nets[k].rests)
			net_solve(world, s, &v, &v.nets[k]);
}

/* ---- rest ---- */

/* Does nothing else join the net's bodies? */
static int32_t is_alone(const cn_world *world, const cni_coarse_view *v, const cni_net_range *net)
{
	int32_t k, ends = net->ends;
	for (k = net->body_begin; k < net->body_end; ++k)
		ends -= cni_body_at(world, v->bodies[k].body)->joint_count;
	return ends == 0;
}

void cni_coarse_netted(const cn_world *world, uint8_t *netted)
{
	cni_coarse_view v = cni_coarse_view_of(world);
	int32_t n, k;
	memset(netted, 0, (size_t)world->awake_count);
	for (n = 0; n < v.head->net_count; ++n) {
		if (!v.nets[n].holds || !is_alone(world, &v, &v.nets[n]))
			continue;
		for (k = v.nets[n].body_begin; k < v.nets[n].body_end; ++k)
			netted[v.bodies[k].index] = 1;
	}
}

/* It is in an island that rests, unless its indices are old. */
static int32_t net_rests(const cn_world *world, const cni_coarse_view *v, const cni_net_range *net)
{
	return net->holds && (cni_drives(world)[v->bodies[net->body_begin].index].flags & CNI_DRIVE_SWUNG);
}

/* Its bodies' flag may mean that they swing, so the island's record tells who asks later: world/islands.c. */
static void island_note(const cn_world *world, int32_t body)
{
	int32_t island = cni_body_at(world, body)->island;
	if (island != CNI_NONE)
		cni_island_at(world, island)->net_rest_step = world->step_count + 1u;
}

void cni_coarse_rest(cn_world *world)
{
	cni_coarse_view v = cni_coarse_view_of(world);
	int32_t n;
	for (n = 0; n < v.head->net_count; ++n) {
		if (!net_rests(world, &v, &v.nets[n]))
			continue;
		v.nets[n].rests = 1;
		island_note(world, v.bodies[v.nets[n].body_begin].body);
	}
	cni_joint_blocks_rest(world);
}
