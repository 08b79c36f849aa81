/*
 * stages/contact_impact.c - contacts that bounce.
 *
 * Before each substep's solve, every lane with restitution that is closing faster than the threshold and
 * would meet within the substep gets Newton's impact law by a direct impulse: n.v' = e |n.v|. Impulses act
 * one contact after the other, so each one takes energy or keeps it (e <= 1) and momentum is kept; no
 * accumulated impulse is left behind that could push again. The soft solve that follows treats the contact
 * as an ordinary one (in place of the late restitution pass of Box2D, which lets the energy of a cluster rise).
 *
 * The velocities that meet are those in start: what bodies really have. motion.v also holds the response to
 * the last substep's impulses, a guess that the solve has yet to correct; for a light body between heavy ones it is
 * far off, and returning such a speed would make energy of it.
 *
 * Meeting early costs no energy: with closing acceleration a from the bodies' drives, the law is applied to the
 * speed at the true moment of contact, v^2 + 2 a s, and the outgoing speed is the one that a body has
 * at the end of the substep, s + h v' above the surface: v'^2 = e^2 (v^2 + 2 a s) - 2 a (s + h v').
 *
 * Few lanes of a sweep close that fast: the kernel finds them side by side, and they alone are gathered from the blocks of
 * a colour and solved, by the kernel of contact_impact.h.
 *
 * Reads blocks, motion and start; writes motion velocities and start (so that the warm start of the next substep does
 * not contain the impact).
 */
#include "base/bitset.h"
#include "stages/contact_pass.h"

#include <string.h>

#define BLOCKS_A_RANGE 64 /* of one colour: most of them do not bounce */
#define BLOCKS_AHEAD 2    /* whose memory is asked for */
#define SWEEPS 4 /* a wave through touching balls may need several; the solve after takes the rest */

static const float *record_of(const cn_world *world, int32_t index)
{
	return cni_record_floats(index == 0 ? &cni_body_nowhere : cni_body_at(world, cni_awake_ids(world)[index]));
}

static void lanes_clear(cni_impact_lanes *lanes)
{
	int32_t l;
	memset(lanes, 0, sizeof *lanes);
	for (l = 0; l < CNI_LANES; ++l)
		lanes->a[l] = lanes->b[l] = cni_record_floats(&cni_body_nowhere);
}

static void point_copy(const cni_contact_row *row, int32_t from, cni_impact_lanes *lanes, int32_t which, int32_t l)
{
	lanes->at[which][l] = row->at[from];
	lanes->an[which][l] = row->an[from];
	lanes->s0[which][l] = row->s0[from];
	lanes->nm[which][l] = row->nm[from];
}

static void lane_copy(const cn_world *world, const cni_listed_block *b, int32_t from, cni_impact_lanes *lanes, int32_t l)
{
	const cni_contact_block *k = b->rows;
	lanes->ia[l] = k->ia[from];
	lanes->ib[l] = k->ib[from];
	lanes->nx[l] = k->nx[from];
	lanes->ny[l] = k->ny[from];
	lanes->dynamic_friction[l] = k->dynamic_friction[from];
	lanes->restitution[l] = b->info->restitution[from];
	lanes->dn[l] = k->dn[from];
	lanes->dt[l] = k->dt[from];
	lanes->fa[l] = k->fa[from];
	lanes->fb[l] = k->fb[from];
	lanes->tm[l] = k->tm[from];
	point_copy(&k->p[0], from, lanes, 0, l);
	point_copy(&k->p[1], from, lanes, 1, l);
	lanes->lock_ax[l] = b->extra != NULL ? b->extra->lock_ax[from] : 0.0f;
	lanes->lock_ay[l] = b->extra != NULL ? b->extra->lock_ay[from] : 0.0f;
	lanes->lock_bx[l] = b->extra != NULL ? b->extra->lock_bx[from] : 0.0f;
	lanes->lock_by[l] = b->extra != NULL ? b->extra->lock_by[from] : 0.0f;
	lanes->at_world[l] = k->ib[from] == 0 ? 1.0f : 0.0f;
	lanes->a[l] = record_of(world, k->ia[from]);
	lanes->b[l] = record_of(world, k->ib[from]);
}

/* A sweep over the blocks of one colour: they share no body that they write. */
typedef struct color_sweep {
	cn_world *world;
	const cni_contact_kernel *kernel;
	cni_impact_pass pass;
	const cni_listed_block *blocks;
	uint32_t hits;
} color_sweep;

static uint32_t lanes_closing(const color_sweep *c, const cni_listed_block *b)
{
	if (!(b->info->flags & CNI_BLOCK_RESTITUTION))
		return 0;
	return c->kernel->closing(c->pass.starts, b->rows, b->info, c->pass.speed, b->lanes);
}

/* Asks for what the search for lanes reads of a block to come. */
CNI_INLINE void block_prefetch(const cni_listed_block *b)
{
	const cni_contact_block *k = b->rows;
	if (!(b->info->flags & CNI_BLOCK_RESTITUTION))
		return;
	CNI_PREFETCH(b->info->restitution);
	CNI_PREFETCH(k->ia);
	CNI_PREFETCH(k->ib);
	CNI_PREFETCH(k->nx);
	CNI_PREFETCH(k->ny);
	CNI_PREFETCH(k->dt);
	CNI_PREFETCH(k->p[0].at);
	CNI_PREFETCH(k->p[0].nm);
	CNI_PREFETCH(k->p[1].at);
	CNI_PREFETCH(k->p[1].nm);
}

/* ... and for the bodies of a lane that was found. */
CNI_INLINE void bodies_prefetch(const cni_impact_pass *pass, const cni_impact_lanes *lanes, int32_t l)
{
	CNI_PREFETCH(lanes->a[l]);
	CNI_PREFETCH(lanes->b[l]);
	CNI_PREFETCH(pass->motions + lanes->ia[l]);
	CNI_PREFETCH(pass->motions + lanes->ib[l]);
	CNI_PREFETCH(pass->drives + lanes->ia[l]);
	CNI_PREFETCH(pass->drives + lanes->ib[l]);
}

/* Lanes that may meet are few in each block: they are brought together, and solved side by side. */
static void color_sweep_run(void *context, int32_t begin, int32_t end, int32_t worker)
{
	color_sweep *c = (color_sweep *)context;
	cni_impact_lanes lanes;
	int32_t k, count = 0, clear = 0, hits = 0;
	(void)worker;
	for (k = begin; k < end; ++k) {
		uint32_t closing;
		if (k + 2 * BLOCKS_AHEAD < end)
			CNI_PREFETCH(&c->blocks[k + 2 * BLOCKS_AHEAD].info->flags);
		if (k + BLOCKS_AHEAD < end)
			block_prefetch(&c->blocks[k + BLOCKS_AHEAD]);
		closing = lanes_closing(c, &c->blocks[k]);
		if (closing != 0 && !clear) {
			lanes_clear(&lanes);
			clear = 1;
		}
		for (; closing != 0; closing &= closing - 1) {
			lane_copy(c->world, &c->blocks[k], cni_bit_lowest32(closing), &lanes, count);
			bodies_prefetch(&c->pass, &lanes, count++);
			if (count < CNI_LANES)
				continue;
			hits += c->kernel->impact(&c->pass, &lanes, count);
			count = 0;
		}
	}
	if (count > 0)
		hits += c->kernel->impact(&c->pass, &lanes, count);
	if (hits > 0)
		cni_atomic_add(&c->hits, (uint32_t)hits);
}

/* In the overflow colour a body is in several lanes, and one may make another meet. */
static void overflow_sweep(color_sweep *c, int32_t count)
{
	cni_impact_lanes one;
	int32_t k, l;
	for (k = 0; k < count; ++k) {
		const cni_listed_block *b = &c->blocks[k];
		for (l = 0; l < b->lanes; ++l) {
			if (b->info->restitution[l] == 0.0f)
				continue;
			lane_copy(c->world, b, l, &one, 0);
			c->pass.one_sided = b->rows->ib[l] == 0;
			c->hits += (uint32_t)cni_contact_kernel_plain.impact(&c->pass, &one, 1);
		}
	}
}

static uint32_t sweep(cn_world *world, const cni_solve *s)
{
	color_sweep c;
	int32_t color;
	c.world = world;
	c.kernel = s->kernel;
	c.pass.motions = cni_motions(world);
	c.pass.starts = cni_starts(world);
	c.pass.drives = cni_drives(world);
	c.pass.h = s->h;
	c.pass.speed = s->restitution_threshold;
	c.hits = 0;
	for (color = 0; color < CNI_COLOR_OVERFLOW; ++color) {
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
	int32_t k;
	for (k = 0; k < SWEEPS && s->bounces; ++k)
		if (sweep(world, s) == 0)
			return;
}
