/*
 * direct/heavy_contacts.c - contacts with lighter bodies that exact joints hold, solved with the response of the joints.
 *
 * The contact kernel takes the stiffness and the steps of a contact from the masses of its two bodies. A box that falls on a light board of a
 * cantilever sinks by the ratio of their masses: a pass stops as much of it as the board weighs, and the contact yields as if the board
 * were free. Here the contacts of a component have the inverse effective mass of all their rows (two normals and friction each) with the joints,
 * a dense matrix: one solution of the joints' system for each row, once a step. Each pass, after the joints, solves the contacts in a few
 * Gauss-Seidel rounds with that matrix, and applies the sum of their impulses through the joints, which stay closed, by one solution.
 *
 * No step may be too long, or the impulses grow from pass to pass: direct/heavy_response.c.
 *
 * A contact yields, as soft ones do, by what it bears more than in the last step: a box at rest would sink in as far as the board below it is light.
 * The kernel's passes include these lanes. Their loads equal their impulses, so there they do not yield. Rolling resistance is the kernel's.
 *
 * The impacts of contacts/restitution.c are those of free bodies: the joints would stop the board that was hit, and with it the bounce. These
 * contacts bounce once, after the substeps, to the speed of Newton's law, and against the response of the joints. Until then they are
 * inelastic.
 *
 * Reads systems of joints, lanes; writes impulses and loads of lanes, velocities, impulses of joint constraints.
 */
#include "contacts/contacts.h"
#include "direct/heavy_response.h"

#include <string.h>

/* Passes of a substep are numbered by their bias; PASS_AGAIN has one, too. */
enum { PASS_BOUNCE = 2, PASS_AGAIN = 3 };

/* ---- groups ---- */

/* Index behind the contacts that are of the same component as contact begin. */
static int32_t end_of(const cni_sparse *sparse, int32_t begin)
{
	int32_t end = begin + 1;
	while (end < sparse->heavy_count && sparse->heavies[end].component == sparse->heavies[begin].component)
		++end;
	return end;
}

static int32_t response_numbers(int32_t contacts)
{
	return CNI_HEAVY_ROWS * contacts * CNI_HEAVY_LANES * contacts;
}

/* Bytes that a group of contacts needs at work. */
static uint64_t work_bytes(const cni_sparse *sparse, int32_t begin, int32_t end)
{
	const cni_component *c = &sparse->components[sparse->heavies[begin].component];
	return CNI_HEAVY_POINT_BYTES * (uint64_t)(end - begin) + sizeof(float) * (uint64_t)cni_heavy_half_floats(end - begin, c->end - c->begin);
}

/* Chains the groups of each island: two of them may have a free body in common. Those that workers share come first. islands 0: all groups.
   last: by island, and one more. */
static void groups_chain(const cn_world *world, cni_sparse *sparse, int32_t islands, int32_t *last)
{
	for (int32_t k = 0; k <= islands; ++k)
		last[k] = CNI_NONE;
	for (int32_t k = 0; k < sparse->heavy_group_count; ++k) {
		const cni_component *c = &sparse->components[sparse->heavy_groups[k].component];
		int32_t number = islands > 0 ? cni_awake_island_number(world, sparse->bodies[c->body_begin]) : 0, *of = &last[number == CNI_NONE ? islands : number];
		*(*of == CNI_NONE ? &sparse->heavy_chains[sparse->heavy_chain_count++] : &sparse->heavy_groups[*of].next) = k;
		*of = k;
	}
	for (int32_t k = 0; k < sparse->heavy_chain_count; ++k) {
		int32_t chain = sparse->heavy_chains[k], serial = 0; /* 1: a component is at a kinematic body, whose rotation it shares */
		for (int32_t g = chain; g != CNI_NONE; g = sparse->heavy_groups[g].next)
			serial |= sparse->components[sparse->heavy_groups[g].component].meets_kinematic;
		if (serial)
			continue;
		sparse->heavy_chains[k] = sparse->heavy_chains[sparse->heavy_shared_count];
		sparse->heavy_chains[sparse->heavy_shared_count++] = chain;
	}
}

/* Takes memory for the groups of the listed contacts. Without it there are none. With one worker all have the same memory at work. */
static void groups_take(cn_world *world, cni_sparse *sparse)
{
	int32_t shared = world->team != NULL && !world->memory.fixed, islands = shared ? world->step_island_count : 0, numbers = 0, groups = 0;
	uint64_t bytes = 0;
	for (int32_t begin = 0, end; begin < sparse->heavy_count; begin = end, ++groups) {
		end = end_of(sparse, begin);
		numbers += response_numbers(end - begin);
		uint64_t own = work_bytes(sparse, begin, end);
		bytes = shared ? bytes + own : own > bytes ? own : bytes;
	}
	if (groups == 0)
		return;
	uint8_t *work = (uint8_t *)cni_scratch_push(world, bytes);
	sparse->heavy_groups = (cni_heavy_group *)cni_scratch_push(world, sizeof(cni_heavy_group) * (uint64_t)groups + sizeof(float) * (uint64_t)numbers);
	sparse->heavy_chains = (int32_t *)cni_scratch_push(world, sizeof(int32_t) * (uint64_t)(groups + islands + 1));
	if (work == NULL || sparse->heavy_groups == NULL || sparse->heavy_chains == NULL)
		return;
	float *response = (float *)(void *)(sparse->heavy_groups + groups);
	for (int32_t begin = 0, end; begin < sparse->heavy_count; begin = end) {
		end = end_of(sparse, begin);
		cni_heavy_group g = { sparse->heavies[begin].component, begin, end, CNI_NONE, 0.0f, 0, response, (cni_direct_contact *)(void *)work,
			(float *)(void *)(work + CNI_HEAVY_POINT_BYTES * (size_t)(end - begin)) };
		sparse->heavy_groups[sparse->heavy_group_count++] = g;
		response += response_numbers(end - begin);
		work += shared ? (size_t)work_bytes(sparse, begin, end) : 0;
	}
	groups_chain(world, sparse, islands, sparse->heavy_chains + groups);
}

/* ---- loops over groups, which workers share island by island ---- */

typedef void group_fn(cn_world *world, const cni_solve *s, cni_heavy_group *g, int32_t argument);

typedef struct chain_loop {
	cn_world *world;
	const cni_solve *s;
	group_fn *fn;
	int32_t argument;
} chain_loop;

static void chains_range(void *context, int32_t begin, int32_t end)
{
	const chain_loop *l = (const chain_loop *)context;
	const cni_sparse *sparse = l->s->direct;
	for (int32_t k = begin; k < end; ++k)
		for (int32_t g = sparse->heavy_chains[k]; g != CNI_NONE; g = sparse->heavy_groups[g].next)
			l->fn(l->world, l->s, &sparse->heavy_groups[g], l->argument);
}

static void groups_run(cn_world *world, const cni_solve *s, cni_team *team, group_fn *fn, int32_t argument)
{
	chain_loop l = { world, s, fn, argument };
	cni_team_for(team, s->direct->heavy_shared_count, 1, chains_range, &l);
	chains_range(&l, s->direct->heavy_shared_count, s->direct->heavy_chain_count);
	for (int32_t k = 0; k < s->direct->heavy_group_count; ++k)
		cni_component_give_up(world, s->direct, &s->direct->components[s->direct->heavy_groups[k].component]);
}

/* Do the joints bear an impact with it? */
static int32_t is_borne(const cni_heavy_pass *q, int32_t contact)
{
	for (int32_t k = 0; k < 2; ++k)
		if (q->points[contact].mass[k] > 0.0f && q->points[contact].mass[k] * cni_heavy_inverse_mass(q, contact, k) < CNI_HEAVY_BOUNCE_PART)
			return 1;
	return 0;
}

static void masses_find(const cni_heavy_pass *q)
{
	float mass = 0.0f;
	for (int32_t k = q->c->body_begin; k < q->c->body_end; ++k)
		mass += cni_inverse_or_zero(cni_motions(q->world)[q->sparse->bodies[k]].inv_mass);
	for (int32_t k = 0; k < q->count; ++k)
		q->heavies[k].mass = mass + cni_inverse_or_zero(cni_heavy_body(q, k, 0)->inv_mass) + cni_inverse_or_zero(cni_heavy_body(q, k, 1)->inv_mass);
}

/* What the contact bore in the last step, up to a number of weights of all that it could bear: more is a squeeze. A chain that winds up on a drum of
   its own yields as others do: each link that arrives would pluck it. */
static void load_read(const cni_heavy_pass *q, int32_t contact)
{
	cni_heavy_contact *h = &q->heavies[contact];
	float most = CNI_HEAVY_CONTACT_STRESS * cni_length(q->world->settings.gravity) * q->s->h * h->mass;
	for (int32_t k = 0; k < 2; ++k)
		h->load[k] = cni_heavy_is_inner(q, contact) ? 0.0f : cni_min(q->points[contact].j[k], most);
}

static void group_find(cn_world *world, const cni_solve *s, cni_heavy_group *g, int32_t argument)
{
	cni_heavy_pass q;
	(void)argument;
	cni_heavy_pass_open(&q, world, s, s->direct, g);
	if (q.c->batches)
		cni_tree_lane_system(s, q.c);
	cni_heavy_response_find(&q);
	masses_find(&q);
	for (int32_t i = 0; i < q.count; ++i) {
		load_read(&q, i);
		q.heavies[i].is_left = (uint8_t)(q.heavies[i].is_light && !is_borne(&q, i));
		if (!q.heavies[i].is_left)
			*cni_heavy_restitution(world, q.heavies[i].contact) = 0.0f;
	}
}

void cni_heavy_contacts_find(cn_world *world, const cni_solve *s)
{
	groups_take(world, s->direct);
	groups_run(world, s, cni_components_team(world, s->direct, 2), group_find, 0);
}

/* ---- a pass ---- */

/* Target of a normal impulse: a pass as in contacts/contact_kernel.h, without hardening, with the mass m. A point that parts faster than `leaving`
   keeps no load. */
static float normal_target(const cni_solve *s, const cni_direct_contact *p, int32_t row, float load, float leaving, float m, float speed, float separation, int32_t bias)
{
	const cni_contact_pass *pass = &s->contact[0];
	float soft = pass->soft.mass_scale, push = cni_max(pass->soft.bias_scale * separation, -s->push_speed * soft);
	if (separation > 0.0f && !bias && speed < pass->impact_speed && p->j[row] <= 0.0f)
		return 0.0f;
	if (separation <= 0.0f && bias) {
		float kept = soft * speed + push > leaving ? 0.0f : (1.0f - soft) * cni_min(p->j[row], load);
		return cni_max(soft * p->j[row] + kept - m * (soft * speed + push), 0.0f);
	}
	return cni_max(p->j[row] - m * (speed + cni_max(separation * s->inv_h, 0.0f)), 0.0f);
}

static float friction_target(const cni_direct_contact *p, float m, float speed)
{
	float target = p->j[2] - m * speed, normal = p->j[0] + p->j[1], stick = p->static_friction * normal;
	float most = cni_abs(target) <= CNI_STICK_MARGIN * stick ? stick : p->dynamic_friction * normal;
	return cni_clamp(target, -most, most);
}

/* A contact that is pressed harder than `most` is pressed by what cannot give way, and its impulse would grow from pass to pass: beyond, the
   kernel alone raises it, as if the joints were not there. */
static float row_target(const cni_heavy_pass *q, int32_t contact, int32_t row)
{
	const cni_heavy_contact *h = &q->heavies[contact];
	const cni_direct_contact *p = &q->points[contact];
	float m = q->mass[cni_heavy_at(contact, row)], speed = q->speed[cni_heavy_at(contact, row)], separation = q->separation[cni_heavy_at(contact, row)];
	if (row == 2)
		return q->pass == PASS_BOUNCE ? p->j[2] : friction_target(p, m, speed - h->tangent_speed);
	if (q->pass == PASS_BOUNCE) /* what touches reaches its speed after the impact */
		return separation > q->world->settings.slop ? p->j[row] : cni_max(p->j[row] + m * (h->bounce[row] - speed), 0.0f);
	return cni_min(cni_max(q->speed_most * h->mass, p->j[row]), normal_target(q->s, p, row, h->load[row], q->leaving, m, speed, separation, q->pass));
}

/* Does the contact take part in this pass? */
static int32_t takes_part(const cni_heavy_pass *q, int32_t contact)
{
	const cni_heavy_contact *h = &q->heavies[contact];
	if (q->pass == PASS_AGAIN && !h->is_of_free)
		return 0;
	return !h->is_left && (q->pass != PASS_BOUNCE || (h->is_hit && cni_heavy_bounces(h)));
}

/* Returns 1 where impulses changed by more than rounding. */
static int32_t contact_rows_solve(cni_heavy_pass *q, int32_t contact)
{
	cni_direct_contact *p = &q->points[contact];
	float *speed = q->speed;
	int32_t row, k, lanes = CNI_HEAVY_LANES * q->count, changed = 0;
	for (row = 0; row < CNI_HEAVY_ROWS; ++row) {
		const float *column = cni_heavy_column(q, contact, row);
		if (p->mass[row] <= 0.0f)
			continue;
		float target = row_target(q, contact, row);
		float change = target - p->j[row];
		p->j[row] = target;
		if (change == 0.0f)
			continue;
		changed |= cni_abs(change) > q->speed_least * q->mass[cni_heavy_at(contact, row)];
		for (k = 0; k < lanes; k += CNI_HEAVY_LANES)
			cni_four_store(speed + k, cni_four_add(cni_four_load(speed + k), cni_four_scale(cni_four_load(column + k), change)));
	}
	return changed;
}

/* 1: the change of impulse is more than rounding: a contact at rest costs no solution of the joints. */
static int32_t changes_speed(const cni_heavy_pass *q, int32_t contact)
{
	const cni_direct_contact *p = &q->points[contact];
	for (int32_t k = 0; k < CNI_HEAVY_ROWS; ++k)
		if (p->mass[k] > 0.0f && !(cni_abs(p->j[k] - p->first[k]) <= q->speed_least * q->mass[cni_heavy_at(contact, k)]))
			return 1;
	return 0;
}

/* Speeds, masses and separations before the impulses of a pass. */
static void rows_begin(const cni_heavy_pass *q)
{
	cni_heavy_speeds(q, q->speed);
	for (int32_t i = 0; i < q->count; ++i) {
		for (int32_t k = 0; k < CNI_HEAVY_ROWS; ++k) {
			q->mass[cni_heavy_at(i, k)] = cni_inverse_or_zero(cni_heavy_inverse_mass(q, i, k));
			q->separation[cni_heavy_at(i, k)] = k < 2 ? cni_direct_contact_separation(&q->points[i], k, cni_heavy_body(q, i, 0), cni_heavy_body(q, i, 1)) : 0.0f;
		}
	}
}

/* Finds the impulses of all contacts. Returns 0 where they change nothing. */
static int32_t impulses_find(cni_heavy_pass *q)
{
	int32_t round, k, changed = 1;
	rows_begin(q);
	for (round = 0; changed && round < CNI_HEAVY_CONTACT_ROUNDS; ++round)
		for (changed = 0, k = 0; k < q->count; ++k)
			changed |= takes_part(q, k) && contact_rows_solve(q, k);
	changed = 0;
	for (k = 0; k < q->count; ++k) {
		cni_direct_contact *p = &q->points[k];
		if (takes_part(q, k) && changes_speed(q, k))
			changed = 1;
		else
			memcpy(p->j, p->first, sizeof p->j);
	}
	return changed;
}

static void impulses_push(const cni_heavy_pass *q, float sign)
{
	for (int32_t i = 0; i < q->count; ++i)
		for (int32_t k = 0; k < CNI_HEAVY_ROWS; ++k)
			cni_heavy_push(q, i, k, sign * (q->points[i].j[k] - q->points[i].first[k]));
}

/* Applies them through the joints. Where these have no solution their impulses are taken back: some cancel each other by the joints alone. */
static void impulses_apply(cni_heavy_pass *q)
{
	cni_heavy_set_aside(q);
	impulses_push(q, 1.0f);
	cni_heavy_sides_set(q);
	cni_heavy_return(q);
	if (cni_direct_apply(q->world, q->sparse, q->c)) {
		if (q->c->batches)
			cni_tree_lane_add(q->s, q->c);
		return;
	}
	q->c->pending = CNI_FAILED_CONTACTS;
	impulses_push(q, -1.0f);
	for (int32_t i = 0; i < q->count; ++i)
		memcpy(q->points[i].j, q->points[i].first, sizeof q->points[i].j);
}

static void lane_write(const cni_heavy_pass *q, int32_t contact)
{
	const cni_direct_contact *p = &q->points[contact];
	cni_contact_block *block = cni_block_at(q->world, p->block);
	q->heavies[contact].is_hit |= (uint8_t)(p->j[0] + p->j[1] > 0.0f);
	block->jt[p->lane] = p->j[2];
	for (int32_t k = 0; k < 2; ++k)
		block->p[k].jn[p->lane] = block->p[k].load[p->lane] = p->j[k];
}

static void group_solve(cn_world *world, const cni_solve *s, cni_heavy_group *g, int32_t pass)
{
	cni_heavy_pass q;
	if (s->direct->components[g->component].done)
		return;
	cni_heavy_pass_open(&q, world, s, s->direct, g);
	q.pass = pass;
	if (q.c->batches && !pass)
		cni_tree_lane_system(s, q.c);
	if (q.c->set_changes != g->set_changes || (!pass && cni_heavy_turn(&q) > g->turn_most))
		cni_heavy_response_find(&q);
	if (impulses_find(&q))
		impulses_apply(&q);
	for (int32_t k = 0; k < q.count; ++k)
		if (takes_part(&q, k))
			lane_write(&q, k);
}

void cni_heavy_contacts_solve(cn_world *world, const cni_solve *s, int32_t bias)
{
	groups_run(world, s, s->team, group_solve, bias);
}

/* Have contacts opened the joints of a component that a free body presses? Those with static and jointed bodies are left: more passes over them cost
   7% in a scene of flails, and overlaps got larger as often as smaller. */
static int32_t is_opened(const cni_sparse *sparse, const cni_heavy_group *g)
{
	int32_t k = g->begin;
	while (k < g->end && !sparse->heavies[k].is_of_free)
		++k;
	return k < g->end && sparse->projections[g->component].opening;
}

static void group_project(cn_world *world, const cni_solve *s, cni_heavy_group *g, int32_t pass)
{
	if (is_opened(s->direct, g))
		group_solve(world, s, g, pass);
}

void cni_heavy_contacts_project(cn_world *world, const cni_solve *s)
{
	int32_t k = 0;
	while (k < s->direct->heavy_group_count && !is_opened(s->direct, &s->direct->heavy_groups[k]))
		++k;
	if (k < s->direct->heavy_group_count) /* else no worker is asked */
		groups_run(world, s, s->team, group_project, PASS_AGAIN);
}

/* ---- bounces ---- */

/* The impulses are no loads: they do not stay in the lanes. */
static void group_bounce(cn_world *world, const cni_solve *s, cni_heavy_group *g, int32_t pass)
{
	cni_heavy_pass q;
	int32_t k, bouncing = 0;
	for (k = g->begin; k < g->end; ++k)
		bouncing |= s->direct->heavies[k].is_hit && cni_heavy_bounces(&s->direct->heavies[k]);
	if (!bouncing || s->direct->components[g->component].done)
		return;
	cni_heavy_pass_open(&q, world, s, s->direct, g);
	q.pass = pass;
	for (k = 0; k < q.count; ++k) {
		memset(q.points[k].j, 0, sizeof q.points[k].j);
		memset(q.points[k].first, 0, sizeof q.points[k].first);
	}
	if (impulses_find(&q))
		impulses_apply(&q);
	for (k = 0; k < q.count; ++k)
		if (CNI_HAS_EVENTS && world->sums_active && takes_part(&q, k))
			cni_impulse_sums_strike(world, q.heavies[k].contact, q.points[k].j[0] + q.points[k].j[1], 0.0f, 0.0f, 0.0f);
}

void cni_heavy_contacts_bounce(cn_world *world, const cni_solve *s)
{
	groups_run(world, s, NULL, group_bounce, PASS_BOUNCE); /* they share sums of impulses */
	for (int32_t k = 0; k < s->direct->heavy_count; ++k)
		if (!s->direct->heavies[k].is_left)
			*cni_heavy_restitution(world, s->direct->heavies[k].contact) = s->direct->heavies[k].restitution;
}
