/*
 * contacts/restitution.c - contacts that bounce.
 *
 * Before each substep's solve, every lane with restitution that closes faster than the threshold and would meet within the
 * substep gets Newton's impact law as a direct impulse: n.v' = e |n.v|. Impulses act one contact after the other, so each one
 * takes energy or keeps it (e <= 1), and momentum is kept. No accumulated impulse remains that could push again. (The late
 * restitution pass of Box2D lets the energy of a cluster rise.) The following solve does not brake a contact with restitution
 * that still closes faster than the threshold and has no impulse: braking would take the speed that the impact should return.
 * The sweeps of the next substep handle it. The solve brakes only a contact that overlaps by more than it closes in several
 * substeps: another constraint, such as a joint, undid its impacts.
 *
 * The law uses the velocities in start: the true velocities of the bodies. motion.v also holds the response to the last
 * substep's impulses, a guess that the solve has yet to correct. For a light body between heavy ones the guess is far off, and
 * returning such a speed would add energy.
 *
 * A contact with an impulse gets an impact only if that needs more than the impulse of the last substep, m v > j. In a crowd
 * under more pressure than the solver can balance, bodies close all the time, and none of it is an impact.
 *
 * Meeting early costs no energy: with the closing acceleration a from the bodies' external accelerations, the law is applied to
 * the speed at the true moment of contact, v^2 + 2 a s. The outgoing speed is the one at the end of the substep, s + h v' above
 * the surface: v'^2 = e^2 (v^2 + 2 a s) - 2 a (s + h v').
 *
 * Few lanes of a sweep close that fast. The kernel finds them with vectors; only they are gathered from the blocks of a colour
 * and solved by the kernel of restitution_kernel.h, up to LANES_FEW one by one. A lane without a hit in one sweep gets none in
 * the next unless one of its bodies was hit since: later sweeps skip lanes without such a body.
 *
 * Reads blocks, motion and start; writes motion velocities and start (so that the warm start of the next substep does not
 * contain the impact).
 */
#include "contacts/contacts.h"
#include "base/bitset.h"
#include "contacts/contact_pass.h"

#include <string.h>

#define BLOCKS_A_RANGE 16 /* of one colour: most of them do not bounce */
#define BLOCKS_AT_ONCE 16 /* that are searched before what was found is solved: they stay in the cache */
#define LANES_FEW 3       /* that are solved faster one by one than as a vector */
#define BODIES_MANY 4096  /* that are awake: those of lanes that were found are not near anyway, and asked for early */
/* start.jumped of bodies that sweep k hits. */
#define HIT_MARK(k) (1.0f + (float)(k) / (float)CNI_RESTITUTION_SWEEPS)

static const cni_contact_block no_rows = { 0 };
static const cni_block_extra no_extra = { 0 };

/* Base of a lane's rows in a block, in the form that the kernel reads. */
static const float *lane_floats(const void *block, int32_t lane)
{
	return (const float *)block + lane;
}

static const float *record_of(const cn_world *world, int32_t index)
{
	return cni_record_floats(cni_body_at(world, cni_awake_ids(world)[index]));
}

/* Adds the lane's extra rows. Once one lane has extra rows, the others point to zero rows. */
static void extra_add(cni_impact_lanes *lanes, const cni_block_extra *extra, int32_t from, int32_t l)
{
	for (int32_t k = 0; k < CNI_LANES && !lanes->has_extra; ++k)
		lanes->extra[k] = lane_floats(&no_extra, 0);
	lanes->has_extra = 1;
	lanes->extra[l] = lane_floats(extra, from);
}

static void lane_add(const cn_world *world, const cni_listed_block *b, int32_t from, cni_impact_lanes *lanes, int32_t l)
{
	int32_t ia = b->rows->ia[from], ib = b->rows->ib[from];
	lanes->ia[l] = ia;
	lanes->ib[l] = ib;
	lanes->restitution[l] = b->info->restitution[from];
	lanes->rows[l] = lane_floats(b->rows, from);
	if (b->extra != NULL)
		extra_add(lanes, b->extra, from, l);
	lanes->a[l] = record_of(world, ia);
	lanes->b[l] = ib != 0 ? record_of(world, ib) : cni_record_floats(&cni_body_none);
	lanes->at_world |= (uint32_t)(ib == 0) << l;
}

/* Fills the unused lanes from count on. */
static void lanes_end(cni_impact_lanes *lanes, int32_t count)
{
	for (int32_t l = count; l < CNI_LANES; ++l) {
		lanes->ia[l] = lanes->ib[l] = 0;
		lanes->restitution[l] = 0.0f;
		lanes->rows[l] = lane_floats(&no_rows, 0);
		lanes->a[l] = lanes->b[l] = cni_record_floats(&cni_body_none);
	}
}

/* A sweep over the blocks of one colour. Its lanes share no body that is written. */
typedef struct color_sweep {
	cn_world *world;
	const cni_contact_kernel *kernel;
	cni_impact_pass pass;
	float since;                    /* start.jumped of bodies hit in the last sweep or this one is not less */
	int32_t prefetches;
	const cni_listed_block *blocks;
	uint32_t hits;
} color_sweep;

/* Prefetches the bodies of a lane. */
CNI_INLINE void bodies_prefetch(const cni_impact_pass *pass, const cni_impact_lanes *lanes, int32_t l)
{
	CNI_PREFETCH(lanes->a[l]);
	CNI_PREFETCH(lanes->b[l]);
	CNI_PREFETCH(pass->motions + lanes->ia[l]);
	CNI_PREFETCH(pass->motions + lanes->ib[l]);
	CNI_PREFETCH(pass->externals + lanes->ia[l]);
	CNI_PREFETCH(pass->externals + lanes->ib[l]);
}

/* Lanes that may meet. Each block has few: they are collected over blocks and solved as vectors. */
typedef struct found_lanes {
	cni_impact_lanes lanes;
	int32_t count, hits;
	const cni_listed_block *block[CNI_LANES]; /* of each lane, and its number there */
	int32_t from[CNI_LANES];
} found_lanes;

/* Adds an impact to the sums of a contact that reports its impulse: of a block without sums, one that began to touch and has no anchor. */
static void impact_add(cn_world *world, const cni_listed_block *b, int32_t lane, const cni_impact_record *record, int32_t l)
{
	if (CNI_HAS_EVENTS && record->jn[l] != 0.0f && (world->sums != NULL || !(b->info->anchored >> lane & 1u)))
		cni_impulse_sums_strike(world, b->info->contact[lane], record->jn[l], record->jt[l], record->closing[0][l], record->closing[1][l]);
}

static void found_begin(found_lanes *found)
{
	found->count = found->lanes.has_extra = 0;
	found->lanes.at_world = 0;
}

static void found_solve(const color_sweep *c, found_lanes *found)
{
	const cni_contact_kernel *kernel = found->count <= LANES_FEW ? &cni_contact_kernel_plain : c->kernel;
	cni_impact_pass pass = c->pass;
	cni_impact_record record;
	if (kernel != &cni_contact_kernel_plain)
		lanes_end(&found->lanes, found->count);
	if (c->world->sums_active) {
		memset(&record, 0, sizeof record);
		pass.record = &record;
	}
	found->hits += kernel->impact(&pass, &found->lanes, found->count);
	for (int32_t l = 0; l < found->count && pass.record != NULL; ++l)
		impact_add(c->world, found->block[l], found->from[l], &record, l);
	found_begin(found);
}

static void found_add(const color_sweep *c, found_lanes *found, const cni_listed_block *b, uint32_t closing)
{
	for (; closing != 0; closing &= closing - 1) {
		int32_t l = found->count++;
		found->block[l] = b;
		found->from[l] = cni_bit_lowest32(closing);
		lane_add(c->world, b, found->from[l], &found->lanes, l);
		if (c->prefetches)
			bodies_prefetch(&c->pass, &found->lanes, l);
		if (l == CNI_LANES - 1)
			found_solve(c, found);
	}
}

static void color_sweep_run(void *context, int32_t begin, int32_t end)
{
	color_sweep *c = (color_sweep *)context;
	found_lanes found;
	found.hits = 0;
	found_begin(&found);
	for (int32_t from = begin; from < end; from += BLOCKS_AT_ONCE) {
		uint32_t closing[BLOCKS_AT_ONCE];
		int32_t count = cni_min_i(end - from, BLOCKS_AT_ONCE);
		c->kernel->closing(c->pass.starts, c->blocks + from, count, c->pass.speed, c->since, closing);
		for (int32_t k = 0; k < count; ++k)
			if (closing[k] != 0)
				found_add(c, &found, &c->blocks[from + k], closing[k]);
	}
	if (found.count > 0)
		found_solve(c, &found);
	if (found.hits > 0)
		cni_atomic_add(&c->hits, (uint32_t)found.hits);
}

/* In the overflow colour a body may be in several lanes, and one impact may cause another: lanes are searched and solved one by one. */
static void overflow_sweep(color_sweep *c, int32_t count)
{
	found_lanes found;
	found.hits = 0;
	found_begin(&found);
	c->kernel = &cni_contact_kernel_plain;
	for (int32_t k = 0; k < count; ++k)
		for (int32_t l = 0; l < c->blocks[k].lanes; ++l) {
			cni_listed_block lane = c->blocks[k];
			uint32_t closing;
			lane.begin = (cni_listed_number)l;
			lane.lanes = (cni_listed_number)(l + 1);
			c->kernel->closing(c->pass.starts, &lane, 1, c->pass.speed, c->since, &closing);
			if (closing == 0)
				continue;
			c->pass.one_sided = c->blocks[k].rows->ib[l] == 0;
			found_add(c, &found, &c->blocks[k], closing);
			found_solve(c, &found);
		}
	c->hits += (uint32_t)found.hits;
}

static uint32_t sweep(cn_world *world, const cni_solve *s, int32_t number)
{
	const cni_impact_pass pass = { cni_motions(world), cni_starts(world), cni_externals(world), s->h, s->restitution_threshold, HIT_MARK(number), 0, NULL };
	color_sweep c = { world, s->kernel, pass, number == 0 ? 0.0f : HIT_MARK(number - 1), world->awake_count >= BODIES_MANY, NULL, 0 };
	for (uint32_t left = s->contact_colors & ~(1u << CNI_COLOR_OVERFLOW); left != 0; left &= left - 1u) {
		int32_t color = cni_bit_lowest32(left);
		c.pass.one_sided = color >= CNI_COLOR_STATIC;
		c.blocks = cni_listed_blocks(world, color);
		cni_team_for(s->team, world->colors[color].listed_count, BLOCKS_A_RANGE, color_sweep_run, &c);
	}
	c.blocks = cni_listed_blocks(world, CNI_COLOR_OVERFLOW);
	overflow_sweep(&c, world->colors[CNI_COLOR_OVERFLOW].listed_count);
	return c.hits;
}

void cni_contacts_impact(cn_world *world, const cni_solve *s)
{
	for (int32_t k = 0; k < CNI_RESTITUTION_SWEEPS && s->bounces; ++k)
		if (sweep(world, s, k) == 0)
			return;
}
