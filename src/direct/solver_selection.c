/*
 * direct/solver_selection.c - selects the islands whose joints and contacts are solved directly in this step.
 *
 * Soft contacts converge from step to step: they are exact at rest once their loads are, and new piles get their loads top-down
 * (contacts/gravity_preload.c). That fails where bodies lean on each other, and where a heavy body crushes a light one below it. A quiet
 * island is solved directly (direct/direct_contacts.c), after some steps of this state if it still moves,
 *   - when a contact overlaps by more than the accuracy;
 *   - when a contact overlaps by more than a tenth of it, or is new, and carries or may carry more than soft contacts can, or is
 *     between bodies that lean;
 *   - when the top-down sweep left some body unsupported.
 * An island of few bodies is solved directly at once, however fast it moves, in a step in which a body strikes another of far less mass: a soft
 * contact stops as much of the heavy body in a pass as the light one weighs, so that it sinks in, and is thrown up again.
 * One whose bodies have yet to meet waits: exact contacts let them fall until their gaps have closed, each step anew. So does one of thin
 * bodies deep in each other: where other sides touch than those that should, no set holds.
 * It stays direct until it has been good for a while or, where bodies lean on each other, until it sleeps; its loads are then exact, and
 * the soft solver starts from them. The stay grows fourfold each time the island turns bad again. An island is barred for a time, longer
 * each time, when its system was refused for its work or its kind, when no solution was found, or when it falls.
 *
 * A scene without bad contacts costs one scan of the separations of its lanes.
 *
 * The automatic selection skips islands with joints: their joints are solved directly anyway (direct/direct_joints.c). In a system of taut
 * joints and contacts, one step in hundreds finds no active set, and that step does more harm than the others do good. An island that gets
 * joints becomes soft again. A body's own solver setting takes such islands too.
 *
 * CN_SOLVER_DIRECT takes every island, quiet or not, and keeps it. A body's own solver setting does the same for its island, or keeps it
 * soft.
 *
 * Each decision stores the reason of the island's tier: world/islands.c reports it.
 *
 * Reads lanes, islands, motion; writes islands' tier fields, world->direct_islands.
 */
#include "direct/direct.h"
#include "contacts/contacts.h"
#include "contacts/deep_lanes.h"
#include "direct/direct_contact.h"

#define ISLANDS_MOST 64        /* solved directly at the same time, of CN_SOLVER_AUTO */
#define BLOCKS_AHEAD 8         /* whose memory is asked for */

typedef struct lane_scan {
	float most;    /* metres: bad overlap of a contact with much load */
	float h;       /* substep length */
	float dt;      /* step length */
	int32_t done;  /* an island whose further lanes change nothing, CNI_NONE */
} lane_scan;

static int32_t *direct_list(const cn_world *world)
{
	return (int32_t *)world->direct_islands.data;
}

/* Contacts of an island with joints are solved directly only where a body asks for it. */
static int32_t takes_contacts(const cn_world *world, int32_t island)
{
	return cni_island_at(world, island)->solver == CN_SOLVER_DIRECT || !cni_island_has_joints(world, island);
}

/* 1: so long ago that the next span of this kind begins anew. */
static int32_t is_long_ago(const cn_world *world, uint32_t step, int32_t steps)
{
	return world->step_count - step > (uint32_t)CNI_SELECTION_FORGET_FACTOR * (uint32_t)steps;
}

static void island_take(cn_world *world, int32_t island, int32_t reason)
{
	cni_island *i = cni_island_at(world, island);
	if (!CNI_ON(DIRECT_CONTACTS))
		return;
	if (!cni_array_reserve(&world->direct_islands, &world->memory, world->direct_islands.count + 1)) {
		world->warnings |= CN_WARNING_FRAME_MEMORY;
		return;
	}
	i->tier = CNI_TIER_DIRECT;
	i->reason = reason;
	if (is_long_ago(world, i->given_step, i->stay_steps))
		i->stay_steps = 0;
	i->good_steps = 0;
	direct_list(world)[world->direct_islands.count++] = island;
}

int32_t cni_island_is_refused(const cni_island *i, uint32_t step)
{
	return i->refused_steps > 0 && step - i->refused_step < (uint32_t)i->refused_steps;
}

int32_t cni_island_is_unsolved(const cni_island *i, uint32_t step)
{
	return i->tier == CNI_TIER_SOFT && i->reason == CN_TIER_REASON_NO_SET && cni_island_is_refused(i, step);
}

static cni_island *awake_island(const cn_world *world, int32_t index)
{
	int32_t island = cni_awake_island(world, index);
	return island != CNI_NONE ? cni_island_at(world, island) : NULL;
}

/* Counted for contacts/gravity_preload.c. */
static void new_contact_count(cn_world *world, int32_t index)
{
	cni_island *i = awake_island(world, index);
	world->piles_new = 1;
	if (i == NULL) {
		cni_body_at(world, cni_awake_ids(world)[index])->flags |= CNI_BODY_SET_DOWN;
		return;
	}
	if (i->new_step != world->step_count + 1u)
		i->new_contacts = 0;
	i->new_step = world->step_count + 1u;
	++i->new_contacts;
}

/* 1: no body moves in the frame of the island faster than one that may sleep. */
static int32_t island_is_still(const cn_world *world, cni_island *i)
{
	cni_vec2 frame = cni_island_frame(world, i);
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		if (!cni_motion_is_slow(world, cni_body_at(world, body)->awake, frame))
			return 0;
	return 1;
}

/*
 * 1: its bodies have yet to meet: no contact bears anything, and many have a small gap (those of two dynamic bodies count twice). 2: they move
 * on their way: many gaps exceed a slop, or overlaps a good part of thin bodies, which may be pushed out on either side.
 */
static int32_t island_is_meeting(const cn_world *world, const cni_island *i)
{
	int32_t near = 0, far = 0;
	float slop = world->settings.slop;
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next) {
		float most = cni_max(CNI_SELECTION_DEEP_PART * cni_body_at(world, body)->core, slop);
		for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *c = cni_contact_of_key(world, key);
			const cni_contact_block *k = cni_contact_has_lane(c) ? cni_block_at(world, c->slot / CNI_LANES) : NULL;
			int32_t l = c->slot % CNI_LANES;
			if (k == NULL)
				continue;
			if (k->p[0].jn[l] + k->p[1].jn[l] > 0.0f)
				return 0;
			float deep = cni_lane_overlap(k, l);
			near += deep < -0.1f * slop && deep > -slop;
			far += deep > most || (deep <= -slop && deep > -world->settings.contact_margin);
		}
	}
	return 2 * far > i->count ? 2 : 2 * (near + far) > i->count;
}

/* 0: the island moves and may soon be another one. Most islands of a heap that is being poured live for some steps, and planning
   their systems costs more than the steps that are solved by them. */
static int32_t island_has_waited(const cn_world *world, cni_island *i)
{
	i->asked_steps = i->asked_step == world->step_count ? i->asked_steps + 1 : 1;
	i->asked_step = world->step_count + 1u;
	return i->asked_steps > CNI_SELECTION_WAIT_STEPS || island_is_still(world, i);
}

/* An island that moved is not asked before it has rested for as many steps as it has bodies: poured heaps fall asleep before. */
static void motion_owes(const cn_world *world, cni_island *i)
{
	cni_cone_debt_set(world, i, cni_max_i(cni_cone_debt(world, i), CNI_CONE_DEBT + CNI_CONE_REFILL * i->count));
}

/* Records a bad contact of the island. Of several reasons the highest is reported. */
static void island_mark_bad(cn_world *world, int32_t island, int32_t reason)
{
	cni_island *i = cni_island_at(world, island);
	int32_t meeting;
	i->good_steps = 0;
	if (i->tier == CNI_TIER_DIRECT && i->reason < reason)
		i->reason = reason;
	if (i->tier == CNI_TIER_DIRECT || i->looked_step == world->step_count + 1u)
		return;
	i->looked_step = world->step_count + 1u;
	if (i->given_step != 0)
		cni_island_let_go(world, i, cni_island_frame(world, i));
	if (cni_island_is_refused(i, world->step_count) || i->solver == CN_SOLVER_SOFT)
		return;
	if (world->direct_islands.count >= ISLANDS_MOST || 2 * i->count > CNI_DIRECT_CONTACT_MOST)
		i->reason = CN_TIER_REASON_CROWDED;
	else if (!cni_island_is_quiet(world, i)) {
		i->reason = CN_TIER_REASON_MOVING;
		motion_owes(world, i);
	}
	else if (cni_island_has_joints(world, island))
		i->reason = CN_TIER_REASON_JOINTED;
	else if (cni_cone_debt(world, i) > CNI_CONE_DEBT)
		i->reason = i->reason == CN_TIER_REASON_NO_SET ? CN_TIER_REASON_NO_SET : CN_TIER_REASON_MOVING; /* what it owes for */
	else if ((meeting = island_is_meeting(world, i)) > 0) {
		cni_island_refuse(world, island, CN_TIER_REASON_MOVING);
		i->refused_steps = CNI_SELECTION_MEET_STEPS;
		if (meeting > 1)
			motion_owes(world, i);
	}
	else if (!island_has_waited(world, i))
		i->reason = CN_TIER_REASON_MOVING;
	else
		island_take(world, island, reason);
}

/*
 * The loads of a directly solved island held it in balance. Soft contacts yield around these loads: in an island that moves after all, the
 * thrust of an arch would drive it apart, and a tower that sways would be pushed on by loads that lie on one edge of its boxes. Clearing them
 * lets the soft solver find new ones.
 */
static void loads_clear(const cn_world *world, const cni_island *i)
{
	for (int32_t body = i->first; body != CNI_NONE; body = cni_body_at(world, body)->island_next)
		for (int32_t key = cni_body_at(world, body)->contact_first; key != CNI_NONE; key = cni_contact_of_key(world, key)->next[key & 1]) {
			const cni_contact *c = cni_contact_of_key(world, key);
			if (!cni_contact_has_lane(c))
				continue;
			cni_block_at(world, c->slot / CNI_LANES)->p[0].load[c->slot % CNI_LANES] = 0.0f;
			cni_block_at(world, c->slot / CNI_LANES)->p[1].load[c->slot % CNI_LANES] = 0.0f;
		}
}

/*
 * Exact impulses on both sides of a light body cancel to a small part of them. Soft passes change each by what the body weighs, and once it moves they
 * would throw it.
 */
static void impulses_hand_over(cn_world *world, cni_island *i)
{
	i->given_step = world->step_count;
	cni_island_let_go(world, i, cni_island_frame(world, i));
}

void cni_island_refuse(cn_world *world, int32_t island, int32_t reason)
{
	cni_island *i = cni_island_at(world, island);
	int32_t first = reason == CN_TIER_REASON_NO_SET || reason == CN_TIER_REASON_MOVING ? (int32_t)CNI_SELECTION_RETRY_FIRST :
		(int32_t)CNI_SELECTION_REFUSED_FIRST;
	if (i->tier == CNI_TIER_DIRECT && i->falls_steps > 0 && world->step_count + 1u - i->gives_step < 3u)
		loads_clear(world, i);
	if (i->tier == CNI_TIER_DIRECT && reason != CN_TIER_REASON_NO_SET) /* found in the passes of a step: island_stays */
		impulses_hand_over(world, i);
	i->tier = CNI_TIER_SOFT;
	i->reason = reason;
	if (is_long_ago(world, i->refused_step, i->refused_steps))
		i->refused_steps = 0;
	i->refused_step = world->step_count;
	i->refused_steps = CNI_ON(RETRY_DELAY) ? cni_min_i(cni_max_i(2 * i->refused_steps, first), CNI_SELECTION_REFUSED_MAX) : 1;
}

/* ---- the search for bad contacts ---- */

/* 1: the contact may come to carry that much: a much heavier body lies on it, or it carries half as much already. */
static int32_t may_be_stressed(const cn_world *world, const cni_contact_block *k, int32_t l, float h)
{
	float inv_a = cni_motions(world)[k->ia[l]].inv_mass, inv_b = cni_motions(world)[k->ib[l]].inv_mass;
	if (inv_b > 0.0f && cni_max(inv_a, inv_b) > CNI_SELECTION_MASS_RATIO * cni_min(inv_a, inv_b))
		return 1;
	return cni_is_stressed(world, k->ia[l], k->ib[l], k->p[0].jn[l] + k->p[1].jn[l], h, 0.5f);
}

/* Leaning bodies: the top-down sweep could not load them, or they sink while nothing moves. */
static int32_t is_leaning(const cn_world *world, const cni_contact_block *k, int32_t l)
{
	cni_island *i = awake_island(world, k->ia[l]);
	if (i == NULL)
		return 0;
	if (i->unheld_step != 0)
		return 1;
	cni_vec2 frame = cni_island_frame(world, i);
	return cni_motion_is_slow(world, k->ia[l], frame) && cni_motion_is_slow(world, k->ib[l], frame);
}

/* Reason why a lane is bad, 0: it is good. */
static int32_t lane_reason(const cn_world *world, const lane_scan *q, const cni_contact_block *k, int32_t l, int32_t is_new)
{
	float deep = cni_lane_overlap(k, l);
	if (deep > world->settings.accuracy)
		return CN_TIER_REASON_OVERLAP;
	if ((deep <= q->most && !is_new) || (!is_leaning(world, k, l) && !may_be_stressed(world, k, l, q->h)))
		return 0;
	return deep > q->most ? CN_TIER_REASON_OVERLAP : CN_TIER_REASON_NEW_CONTACT;
}

static void lane_check(cn_world *world, lane_scan *q, const cni_contact_block *k, int32_t l, int32_t is_new)
{
	int32_t island = cni_awake_island(world, k->ia[l]), reason;
	if (island == CNI_NONE)
		return;
	if (cni_island_at(world, island)->tier != CNI_TIER_DIRECT && cni_island_at(world, island)->looked_step == world->step_count + 1u) {
		q->done = island; /* it was found bad in this step and stays soft */
		return;
	}
	reason = lane_reason(world, q, k, l, is_new);
	if (reason != 0)
		island_mark_bad(world, island, reason);
}

/* 1: the last solution of the island failed, and it was the first that did. */
static int32_t has_failed_once(const cn_world *world, const cni_island *i)
{
	return cni_island_is_unsolved(i, world->step_count) && i->refused_steps <= CNI_SELECTION_RETRY_FIRST;
}

/* 1: a body strikes one of far less mass in this step, or has sunk into it in a step without a solution. */
static int32_t strikes(const cn_world *world, const lane_scan *q, const cni_contact_block *k, int32_t l, int32_t failed)
{
	const cni_motion *a = cni_motions(world) + k->ia[l], *b = cni_motions(world) + k->ib[l];
	if (!(b->inv_mass > 0.0f) || cni_max(a->inv_mass, b->inv_mass) <= CNI_SELECTION_MASS_RATIO * cni_min(a->inv_mass, b->inv_mass))
		return 0;
	if (failed && cni_lane_overlap(k, l) > world->settings.slop)
		return 1;
	for (int32_t i = 0; i < 2; ++i) {
		const cni_contact_row *p = &k->p[i];
		float at = p->at[l], bt = at - k->dt[l], speed = k->nx[l] * (b->vx - a->vx) + k->ny[l] * (b->vy - a->vy) + b->w * bt - a->w * at;
		if (p->nm[l] > 0.0f && speed < -CNI_SELECTION_STRIKE_SPEED * world->settings.length_unit && p->s0[l] + q->dt * speed < world->settings.slop)
			return 1;
	}
	return 0;
}

static void strike_check(cn_world *world, const lane_scan *q, const cni_contact_block *k, int32_t l)
{
	int32_t island = cni_awake_island(world, k->ia[l]), failed;
	const cni_island *i = island != CNI_NONE ? cni_island_at(world, island) : NULL;
	if (i == NULL || i->tier == CNI_TIER_DIRECT || i->solver == CN_SOLVER_SOFT || i->count > CNI_SELECTION_STRIKE_BODIES)
		return;
	failed = has_failed_once(world, i);
	if (cni_island_is_refused(i, world->step_count) && i->reason != CN_TIER_REASON_MOVING && !failed)
		return;
	if (world->direct_islands.count < ISLANDS_MOST && strikes(world, q, k, l, failed) && !cni_island_has_joints(world, island))
		island_take(world, island, CN_TIER_REASON_NEW_CONTACT);
}

static void new_lane_check(cn_world *world, lane_scan *q, const cni_contact_block *k, int32_t l)
{
	int32_t is_new = k->p[0].jn[l] + k->p[1].jn[l] == 0.0f && cni_lane_overlap(k, l) > -0.1f * world->settings.slop;
	if (is_new)
		new_contact_count(world, k->ia[l]);
	if (cni_awake_island(world, k->ia[l]) != q->done)
		lane_check(world, q, k, l, is_new);
}

/* lanes: bits of the deep or new ones. In a moving heap nearly all are deep, and belong to the island q->done. */
static void block_check(cn_world *world, lane_scan *q, const cni_listed_block *b, uint32_t lanes)
{
	const cni_contact_block *k = b->rows;
	for (int32_t l = 0; lanes >> l != 0; ++l) {
		if (!(lanes >> l & 1u))
			continue;
		strike_check(world, q, k, l);
		if (b->fresh >> l & 1u)
			new_lane_check(world, q, k, l);
		else if (cni_awake_island(world, k->ia[l]) != q->done)
			lane_check(world, q, k, l, 0);
	}
}

/* Islands in which the top-down sweep of the last step left a body unsupported. */
static void unheld_check(cn_world *world)
{
	for (int32_t k = 1; k < world->awake_count; ++k) {
		const cni_island *i = awake_island(world, k);
		if (i != NULL && i->unheld_step == world->step_count && world->step_count > 0)
			island_mark_bad(world, cni_awake_island(world, k), CN_TIER_REASON_NEW_CONTACT);
	}
}

static void lanes_check(cn_world *world, float h)
{
	lane_scan q = { CNI_BAD_PART * world->settings.accuracy, h, h * (float)world->settings.substeps, CNI_NONE };
	const cni_listed_block *list = (const cni_listed_block *)world->block_list.data;
	int32_t count = world->colors[CNI_COLORS - 1].listed + world->colors[CNI_COLORS - 1].listed_count;
	for (int32_t k = 0; k < count; ++k) {
		if (k + BLOCKS_AHEAD < count) {
			CNI_PREFETCH(list[k + BLOCKS_AHEAD].rows->p[0].s0);
			CNI_PREFETCH(list[k + BLOCKS_AHEAD].rows->p[1].s0);
		}
		block_check(world, &q, &list[k], list[k].fresh | cni_deep_lanes(list[k].rows, q.most));
	}
	if (world->piles_unheld)
		unheld_check(world);
	world->piles_unheld = 0;
}

/* An island of leaning bodies stays direct until it sleeps or moves: soft contacts yield, and the yield is not recovered. */
static void leaning_island_keep(cn_world *world, int32_t island, float h)
{
	cni_island *i = cni_island_at(world, island);
	if (i->good_steps >= cni_max_i(i->stay_steps, CNI_SELECTION_STAY_FIRST) && i->solver != CN_SOLVER_SOFT &&
	    !cni_island_has_joints(world, island) && cni_island_is_quiet(world, i) && !cni_pile_is_supported(world, island, h))
		i->good_steps = 0;
}

/* The soft solver gets back an island that has been good for long enough, or was asked to. */
static void island_give_back(cn_world *world, cni_island *i)
{
	if (!island_is_still(world, i))
		loads_clear(world, i);
	i->tier = CNI_TIER_SOFT;
	i->reason = CN_TIER_REASON_NONE;
	impulses_hand_over(world, i);
	if (i->solver == CN_SOLVER_SOFT)
		return;
	i->refused_steps = 0; /* it was solved */
	i->stay_steps = cni_min_i(CNI_SELECTION_STAY_FACTOR * cni_max_i(i->stay_steps, CNI_SELECTION_STAY_FIRST), CNI_SELECTION_STAY_MAX);
}

/* 1: the island stays direct. It does not when it has been good for long enough, moves, sleeps, has got joints, or no longer exists. */
static int32_t island_stays(cn_world *world, int32_t island, float h)
{
	cni_island *i = cni_island_at(world, island);
	if (i->first == CNI_NONE)
		return 0;
	if (i->tier != CNI_TIER_DIRECT) {
		if (i->reason == CN_TIER_REASON_NO_SET) /* a part of it, or a pass, had none: the others may press by any force */
			(void)cni_island_limit_impulses(world, i);
		return 0;
	}
	if (!i->awake) {
		i->tier = CNI_TIER_SOFT;
		i->given_step = world->step_count;
		return 0;
	}
	if (!takes_contacts(world, island)) { /* it merged with an island with joints */
		impulses_hand_over(world, i);
		i->tier = CNI_TIER_SOFT;
		i->reason = CN_TIER_REASON_JOINTED;
		return 0;
	}
	if (i->solver != CN_SOLVER_DIRECT && i->gives_step == world->step_count && i->falls_steps >= CNI_SELECTION_FALL_STEPS) {
		/* it has moved for so long that no impulses hold it, and an exact solution of its fall is not worth its work */
		cni_island_refuse(world, island, CN_TIER_REASON_MOVING);
		return 0;
	}
	leaning_island_keep(world, island, h);
	int32_t good = i->good_steps;
	i->good_steps = cni_min_i(good, CNI_SELECTION_STAY_MAX - 1) + (i->solver != CN_SOLVER_SOFT);
	if (i->solver == CN_SOLVER_DIRECT || (i->solver == CN_SOLVER_AUTO && good < cni_max_i(i->stay_steps, CNI_SELECTION_STAY_FIRST))) {
		i->reason = CN_TIER_REASON_SETTLING;
		return 1;
	}
	island_give_back(world, i);
	return 0;
}

static void list_update(cn_world *world, float h)
{
	int32_t kept = 0;
	for (int32_t k = 0; k < world->direct_islands.count; ++k)
		if (island_stays(world, direct_list(world)[k], h))
			direct_list(world)[kept++] = direct_list(world)[k];
	world->direct_islands.count = kept;
}

void cni_solver_selection_reset(cn_world *world)
{
	for (int32_t k = 0; k < world->direct_islands.count; ++k)
		cni_island_at(world, direct_list(world)[k])->tier = CNI_TIER_SOFT;
	world->direct_islands.count = 0;
	world->direct_work = world->direct_failed = 0;
}

static void joint_solver_gather(cn_world *world, const cni_joint *j)
{
	for (int32_t side = 0; side < 2; ++side) {
		int32_t index = j->body[side] != CNI_NONE ? cni_body_at(world, j->body[side])->awake : 0;
		cni_island *i = index != 0 ? awake_island(world, index) : NULL;
		if (i == NULL)
			continue;
		i->joints_solver = CN_SOLVER_DIRECT;
		world->solvers_asked = 1;
	}
}

static void solvers_reset(const cn_world *world)
{
	for (int32_t k = 1; k < world->awake_count; ++k) {
		cni_island *i = awake_island(world, k);
		if (i != NULL)
			i->solver = i->joints_solver = CN_SOLVER_AUTO;
	}
}

/* Writes the solver settings of bodies and joints to their islands. Islands that wake, and new ones, have none yet. */
static void solvers_gather(cn_world *world)
{
	if (world->solvers_asked)
		solvers_reset(world);
	world->solvers_asked = 0;
	for (int32_t k = 0; k < world->awake_joints.count; ++k) {
		const cni_joint *j = cni_joint_at(world, ((const int32_t *)world->awake_joints.data)[k]);
		if (j->solver == CN_SOLVER_DIRECT)
			joint_solver_gather(world, j);
	}
	for (int32_t k = 1; k < world->awake_count; ++k) {
		int32_t solver = cni_body_solver(cni_body_at(world, cni_awake_ids(world)[k]));
		cni_island *i = solver != CN_SOLVER_AUTO ? awake_island(world, k) : NULL;
		if (i == NULL)
			continue;
		world->solvers_asked = 1;
		if (i->solver != CN_SOLVER_SOFT)
			i->solver = (uint16_t)solver;
	}
}

/* Every awake island whose contacts may be solved directly (every 1), or those with a body that asks for it; islands that a body keeps soft
   are skipped. */
static void awake_islands_take(cn_world *world, int32_t every)
{
	for (int32_t k = 1; k < world->awake_count; ++k) {
		cni_island *i = awake_island(world, k);
		if (i == NULL || i->tier == CNI_TIER_DIRECT || i->solver == CN_SOLVER_SOFT || (!every && i->solver != CN_SOLVER_DIRECT) ||
		    i->looked_step == world->step_count + 1u)
			continue;
		i->looked_step = world->step_count + 1u;
		if (!takes_contacts(world, cni_awake_island(world, k))) {
			i->reason = CN_TIER_REASON_JOINTED;
			continue;
		}
		island_take(world, cni_awake_island(world, k), every ? CN_TIER_REASON_SOLVER : CN_TIER_REASON_OVERRIDE);
	}
}

void cni_stage_select_solvers(cn_world *world, float h)
{
	world->direct_work = world->direct_failed = world->piles_new = world->cone_work = world->set_work = 0;
	if (world->overridden)
		solvers_gather(world);
	if (world->settings.solver == CN_SOLVER_DIRECT) {
		cni_solver_selection_reset(world);
		awake_islands_take(world, 1);
	} else if (world->settings.solver == CN_SOLVER_AUTO) {
		list_update(world, h);
		if (world->solvers_asked)
			awake_islands_take(world, 0);
		lanes_check(world, h);
	}
}
