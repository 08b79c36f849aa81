/*
 * contacts/impulse_sums.c - impulses of contacts over a whole step, and blows, for contacts that report them.
 *
 * A lane holds the impulse of one substep. Blocks with a lane whose contact reports STAY or HIT get a record of sums in the frame
 * arena. Contacts that began to touch in this step and report ENTER alone have their sums in the lane's anchor, which has no other use
 * yet. Other lanes cost nothing. A sum takes in each substep the impulse that the passes leave in the lane, and the impacts of
 * restitution.c, which leave none there. Blocks at rest take one substep (step/early_rest.c) and keep its
 * impulse for the others, so their sums are those of the whole step.
 *
 * A blow is an impact, or a substep in which a point that closes gets an impulse. Its speed is the closing speed before the impact, or
 * at the substep's beginning: the greatest of the step is reported, if it reaches the world's hit speed. So blows count within a
 * touching pair too, and resting contacts, which close at the speed that gravity gives in a substep, do not.
 *
 * The sums account for all momentum that contacts exchange. step/angular_momentum.c moves a little more within groups in flight.
 *
 * Reads blocks, contacts, motion and start; writes the sums and the event logs.
 */
#include "contacts/contacts.h"
#include "base/bitset.h"

#include <string.h>

#define BLOCKS_A_RANGE 16

/* ---- which blocks ---- */

/* Bits of the block's lanes whose contacts report hits. */
static uint32_t lanes_with_hits(const cn_world *world, const cni_block_info *info)
{
	uint32_t lanes = 0;
	for (int32_t l = 0; l < CNI_LANES; ++l)
		if (info->contact[l] != CNI_NONE)
			lanes |= (cni_contact_at(world, info->contact[l])->flags >> CNI_CONTACT_EVENTS_SHIFT >> CN_EVENT_HIT & 1u) << l;
	return lanes;
}

/* Numbers the blocks with sums, clears these where there is memory for them already, and counts the blocks. */
static int32_t blocks_number(const cn_world *world)
{
	int32_t count = 0;
	for (int32_t color = 0; color < CNI_COLORS; ++color)
		for (int32_t block = world->colors[color].first; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
			cni_block_info *info = cni_block_info_at(world, block);
			info->sums = info->flags & CNI_BLOCK_SUMS ? count++ : CNI_NONE;
			if (info->sums != CNI_NONE && world->sums != NULL) {
				memset(world->sums + info->sums, 0, sizeof *world->sums);
				world->sums[info->sums].block = block;
				world->sums[info->sums].hits = lanes_with_hits(world, info);
			}
		}
	return count;
}

/* Where no block has sums, world.sums is NULL. */
void cni_impulse_sums_make(cn_world *world)
{
	int32_t count = blocks_number(world);
	world->sums_active = count > 0 || world->events.log[CN_EVENT_ENTER].count > 0;
	if (count > 0)
		world->sums = (cni_block_sums *)cni_scratch_push(world, sizeof(cni_block_sums) * (uint64_t)count);
	if (world->sums != NULL)
		world->sums_count = blocks_number(world);
}

/* ---- a substep ---- */

typedef struct sums_loop {
	cn_world *world;
	int32_t from_starts; /* velocities are in start, else in motion */
} sums_loop;

/* The first three floats of either record: vx, vy, w. */
static const float *speed_of(const sums_loop *loop, int32_t index)
{
	const void *start = cni_starts(loop->world) + index, *motion = cni_motions(loop->world) + index;
	return (const float *)(loop->from_starts ? start : motion);
}

static void lane_open(const sums_loop *loop, cni_block_sums *sums, int32_t l)
{
	const cni_contact_block *k = cni_block_at(loop->world, sums->block);
	const float *a = speed_of(loop, k->ia[l]), *b = speed_of(loop, k->ib[l]);
	float n = k->nx[l] * (b[0] - a[0]) + k->ny[l] * (b[1] - a[1]);
	for (int32_t p = 0; p < 2; ++p)
		sums->closing[p][l] = -(n + b[2] * (k->p[p].at[l] - k->dt[l]) - a[2] * k->p[p].at[l]);
}

static void open_range(void *context, int32_t begin, int32_t end)
{
	const sums_loop *loop = (const sums_loop *)context;
	for (int32_t k = begin; k < end; ++k) {
		cni_block_sums *sums = loop->world->sums + k;
		for (uint32_t left = sums->hits; left != 0; left &= left - 1u)
			lane_open(loop, sums, cni_bit_lowest32(left));
	}
}

static void sums_run(cn_world *world, const cni_solve *s, cni_range_fn *run)
{
	sums_loop loop = { world, world->settings.solver != CN_SOLVER_SEQUENTIAL };
	if (world->sums_count > 0)
		cni_team_for(s->team, world->sums_count, BLOCKS_A_RANGE, run, &loop);
}

void cni_impulse_sums_open(cn_world *world, const cni_solve *s)
{
	sums_run(world, s, open_range);
}

/* A blow at a point: the fastest one counts. */
static void lane_strike(cni_block_sums *sums, int32_t l, int32_t point, float closing)
{
	if (!(sums->hits >> l & 1u) || closing <= sums->approach[l])
		return;
	sums->approach[l] = closing;
	sums->struck = (sums->struck & ~(1u << l)) | (uint32_t)point << l;
}

/* Adds impulses to the sums of the contact's lane *l, or to its ENTER event alone: returns NULL. */
static cni_block_sums *sums_add(cn_world *world, int32_t contact, float normal, float friction, int32_t *l)
{
	const cni_contact *c = cni_contact_at(world, contact);
	cni_block_sums *sums = cni_block_sums_at(world, c->slot / CNI_LANES);
	*l = c->slot % CNI_LANES;
	if (sums == NULL) {
		cni_contact_add_enter_impulses(world, c, normal, friction);
		return NULL;
	}
	sums->normal[*l] += normal;
	sums->friction[*l] += friction;
	return sums;
}

void cni_impulse_sums_strike(cn_world *world, int32_t contact, float normal, float friction, float first_closing, float second_closing)
{
	int32_t point = second_closing > first_closing, l;
	cni_block_sums *sums = sums_add(world, contact, normal, friction, &l);
	if (sums != NULL)
		lane_strike(sums, l, point, point ? second_closing : first_closing);
}

static void lane_blow(cni_block_sums *sums, int32_t l, float first, float second)
{
	if (first > 0.0f)
		lane_strike(sums, l, 0, sums->closing[0][l]);
	if (second > 0.0f)
		lane_strike(sums, l, 1, sums->closing[1][l]);
}

void cni_impulse_sums_take(cn_world *world, int32_t contact, float first, float second, float friction)
{
	int32_t l;
	cni_block_sums *sums = sums_add(world, contact, first + second, friction, &l);
	if (sums != NULL)
		lane_blow(sums, l, first, second);
}

static void take_range(void *context, int32_t begin, int32_t end)
{
	const sums_loop *loop = (const sums_loop *)context;
	int32_t l;
	for (int32_t k = begin; k < end; ++k) {
		cni_block_sums *sums = loop->world->sums + k;
		const cni_contact_block *block = cni_block_at(loop->world, sums->block);
		for (l = 0; l < CNI_LANES; ++l)
			sums->normal[l] += block->p[0].jn[l] + block->p[1].jn[l];
		for (l = 0; l < CNI_LANES; ++l)
			sums->friction[l] += block->jt[l];
		for (uint32_t left = sums->hits; left != 0; left &= left - 1u) {
			l = cni_bit_lowest32(left);
			lane_blow(sums, l, block->p[0].jn[l], block->p[1].jn[l]);
		}
	}
}

/* Adds the impulses of the substep to the ENTER events of contacts without sums. A lane has no anchor in the step of its event. */
static void enters_add(const cn_world *world)
{
	const cni_array *log = &world->events.log[CN_EVENT_ENTER];
	for (int32_t k = 0; k < log->count; ++k) {
		const cni_contact *c = cni_contact_at(world, ((const cni_event *)log->data)[k].contact);
		int32_t block = c->slot / CNI_LANES, l = c->slot % CNI_LANES;
		if (cni_contact_has_lane(c) && cni_block_sums_at(world, block) == NULL) {
			const cni_contact_block *rows = cni_block_at(world, block);
			CNI_ASSERT(!(cni_block_info_at(world, block)->anchored >> l & 1u));
			cni_block_anchor_at(world, block)->c[l] += rows->p[0].jn[l] + rows->p[1].jn[l];
			cni_block_anchor_at(world, block)->s[l] += rows->jt[l];
		}
	}
}

/* Adds the sums of a step to the ENTER events of contacts with sums. */
static void enters_add_sums(cn_world *world)
{
	const cni_array *log = &world->events.log[CN_EVENT_ENTER];
	for (int32_t k = 0; k < log->count && world->sums != NULL; ++k) {
		const cni_contact *c = cni_contact_at(world, ((const cni_event *)log->data + k)->contact);
		const cni_block_sums *sums = cni_contact_has_lane(c) ? cni_block_sums_at(world, c->slot / CNI_LANES) : NULL;
		if (sums != NULL)
			cni_contact_add_enter_impulses(world, c, sums->normal[c->slot % CNI_LANES], sums->friction[c->slot % CNI_LANES]);
	}
}

void cni_impulse_sums_close(cn_world *world, const cni_solve *s)
{
	if (!world->sums_active)
		return;
	enters_add(world);
	sums_run(world, s, take_range);
}

/* ---- reports ---- */

static void lane_report(cn_world *world, const cni_block_sums *sums, int32_t l)
{
	int32_t contact = cni_block_info_at(world, sums->block)->contact[l];
	cni_event_sums of = { sums->normal[l], sums->friction[l], sums->approach[l], (int32_t)(sums->struck >> l & 1u) };
	if (contact == CNI_NONE)
		return;
	cni_event_log_stay(world, contact, &of);
	if (of.normal > 0.0f && of.approach > 0.0f && of.approach >= world->settings.hit_speed && (sums->hits >> l & 1u))
		cni_event_log_hit(world, contact, &of);
}

void cni_impulse_sums_report(cn_world *world)
{
	if (!world->sums_active)
		return;
	enters_add_sums(world);
	for (int32_t k = 0; k < world->sums_count; ++k)
		for (int32_t l = 0; l < CNI_LANES; ++l)
			lane_report(world, world->sums + k, l);
	world->sums = NULL; /* the arena frees them when the step ends */
	world->sums_count = world->sums_active = 0;
}
