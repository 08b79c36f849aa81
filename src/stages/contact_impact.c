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
 * Few lanes of a sweep close that fast: the kernel finds them side by side, and only they are looked at one by one.
 *
 * Reads blocks, motion and start; writes motion velocities and start (so that the warm start of the next substep does
 * not contain the impact).
 */
#include "base/bitset.h"
#include "stages/contact_pass.h"

#define BLOCKS_A_RANGE 64 /* of one colour: most of them do not bounce */
#define SWEEPS 4 /* a wave through touching balls may need several; the solve after takes the rest */

typedef struct impact_point {
	float at, bt, vn, out, k; /* k = n K n */
	int32_t hits;
} impact_point;

typedef struct impact_lane {
	cni_motion *a, *b;
	cni_velocity_start *sa, *sb; /* the velocities that meet */
	int32_t ia, ib;
	float nx, ny;
	float ax, ay, bx, by; /* inverse masses along x and y: 0 for a locked axis */
	float mass;          /* sum of inverse masses along n */
	float dn, dt;        /* from a's centre to b's, now: both arms end in one point */
	float closing;       /* acceleration that brings the bodies together */
	float restitution;
	int32_t one_sided;   /* body b cannot move, and others may be looking at it: it is not written */
} impact_lane;

static float point_speed(const impact_lane *c, float at, float bt)
{
	return c->nx * (c->sb->vx - c->sa->vx) + c->ny * (c->sb->vy - c->sa->vy) + c->sb->w * bt - c->sa->w * at;
}

/* First-order separation now: turns within a step are small next to the gap when speeds are impact speeds. */
static float point_separation(const impact_lane *c, float s0, float an, float dn, float at, float bt)
{
	float ta = c->a->theta, tb = c->b->theta;
	return s0 + c->nx * (c->b->dpx - c->a->dpx) + c->ny * (c->b->dpy - c->a->dpy) +
	       (tb * bt - 0.5f * tb * tb * (an - dn)) - (ta * at - 0.5f * ta * ta * an);
}

/* Outgoing speed at the end of the substep, >= 0 (see the file comment). before: speed at its start. */
static float outgoing_speed(float before, float s, float a, float e, float h)
{
	float meet_sq = before * before + 2.0f * a * s;
	float inside = a * a * h * h - 2.0f * a * s + e * e * cni_max(meet_sq, 0.0f);
	return cni_max(cni_sqrt(cni_max(inside, 0.0f)) - a * h, 0.0f);
}

/*
 * An impulse and its opposite must act along one line, or they turn the two bodies by what they have no right to. A lane's
 * arms are those of the step's beginning, or of where bodies that are still apart will meet; so the arms of b are taken from a's and
 * from where the centres are now.
 */
static void centers_part(const cn_world *world, const cni_contact_block *k, int32_t l, impact_lane *c)
{
	const cni_body *a = cni_body_at(world, cni_awake_ids(world)[c->ia]), *b;
	float x, y;
	c->dn = k->fa[l] - k->fb[l];
	c->dt = k->dt[l];
	if (c->ib == 0)
		return;
	b = cni_body_at(world, cni_awake_ids(world)[c->ib]);
	x = (b->cx - a->cx) + (b->cx_low - a->cx_low) + (c->b->dpx - c->a->dpx);
	y = (b->cy - a->cy) + (b->cy_low - a->cy_low) + (c->b->dpy - c->a->dpy);
	c->dn = c->nx * x + c->ny * y;
	c->dt = c->ny * x - c->nx * y;
}

static impact_lane lane_make(cn_world *world, const cni_contact_block *k, const cni_block_info *info, int32_t l, int32_t color)
{
	const cni_drive *da = cni_drives(world) + k->ia[l], *db = cni_drives(world) + k->ib[l];
	impact_lane c;
	c.ia = k->ia[l];
	c.ib = k->ib[l];
	c.a = cni_motions(world) + c.ia;
	c.b = cni_motions(world) + c.ib;
	c.sa = cni_starts(world) + c.ia;
	c.sb = cni_starts(world) + c.ib;
	c.nx = k->nx[l];
	c.ny = k->ny[l];
	c.ax = da->flags & CNI_DRIVE_LOCK_X ? 0.0f : c.a->inv_mass;
	c.ay = da->flags & CNI_DRIVE_LOCK_Y ? 0.0f : c.a->inv_mass;
	c.bx = db->flags & CNI_DRIVE_LOCK_X ? 0.0f : c.b->inv_mass;
	c.by = db->flags & CNI_DRIVE_LOCK_Y ? 0.0f : c.b->inv_mass;
	c.mass = c.nx * c.nx * (c.ax + c.bx) + c.ny * c.ny * (c.ay + c.by);
	centers_part(world, k, l, &c);
	c.closing = c.nx * (da->ax - db->ax) + c.ny * (da->ay - db->ay);
	c.restitution = info->restitution[l];
	c.one_sided = c.ib == 0 || (color >= CNI_COLOR_STATIC && color != CNI_COLOR_OVERFLOW);
	return c;
}

static impact_point point_make(const impact_lane *c, const cni_contact_block *k, int32_t point, int32_t l, const cni_solve *s)
{
	const cni_contact_row *p = &k->p[point];
	impact_point q;
	float separation;
	q.at = p->at[l];
	q.bt = q.at - c->dt;
	q.vn = point_speed(c, q.at, q.bt);
	q.k = c->mass + c->a->inv_inertia * q.at * q.at + c->b->inv_inertia * q.bt * q.bt;
	q.out = 0.0f;
	q.hits = p->nm[l] > 0.0f && q.vn < -s->restitution_threshold;
	if (!q.hits)
		return q;
	separation = point_separation(c, p->s0[l], p->an[l], k->dn[l], q.at, q.at - k->dt[l]);
	q.hits = separation + s->h * q.vn < 0.0f;
	q.out = outgoing_speed(q.vn + s->h * c->closing, separation, c->closing, c->restitution, s->h);
	/* Never more than the law gives at this instant plus what the drive adds: two fast bodies that were
	   just struck by others must not gain. */
	q.out = cni_min(q.out, c->restitution * -q.vn + cni_abs(c->closing) * s->h);
	return q;
}

/* Changes a body's velocity, and with it what the last impulses' response is added to. */
static void body_strike(cni_motion *m, cni_velocity_start *start, float dvx, float dvy, float dw)
{
	start->vx += dvx;
	start->vy += dvy;
	start->w += dw;
	start->struck = 1.0f;
	m->vx += dvx;
	m->vy += dvy;
	m->w += dw;
}

/* Impulse jn along n with moment arms, and friction opposing the sliding speed within mu jn. */
static void lane_strike(impact_lane *c, const cni_contact_block *k, int32_t l, float jn, float moment_a, float moment_b)
{
	float tx = c->ny, ty = -c->nx, fa = k->fa[l], fb = fa - c->dn;
	float wa = -c->a->inv_inertia * moment_a, wb = c->b->inv_inertia * moment_b;
	float vt = tx * (c->sb->vx - c->sa->vx) + ty * (c->sb->vy - c->sa->vy) - (c->sb->w + wb) * fb + (c->sa->w + wa) * fa;
	float most = k->dynamic_friction[l] * jn, jt = cni_clamp(-k->tm[l] * vt, -most, most);
	float px = jn * c->nx + jt * tx, py = jn * c->ny + jt * ty;
	body_strike(c->a, c->sa, -c->ax * px, -c->ay * py, wa + c->a->inv_inertia * fa * jt);
	if (!c->one_sided)
		body_strike(c->b, c->sb, c->bx * px, c->by * py, wb - c->b->inv_inertia * fb * jt);
}

/* Both points at once when both hit and both impulses come out positive, else the one that closes faster. */
static int32_t lane_impact(cn_world *world, const cni_contact_block *k, const cni_block_info *info, int32_t l, int32_t color, const cni_solve *s)
{
	impact_lane c = lane_make(world, k, info, l, color);
	impact_point p = point_make(&c, k, 0, l, s), q = point_make(&c, k, 1, l, s);
	if (!p.hits && !q.hits)
		return 0;
	if (p.hits && q.hits) {
		float k12 = c.mass + c.a->inv_inertia * p.at * q.at + c.b->inv_inertia * p.bt * q.bt;
		float det = p.k * q.k - k12 * k12, dp = p.out - p.vn, dq = q.out - q.vn;
		float jp = q.k * dp - k12 * dq, jq = p.k * dq - k12 * dp;
		if (det > 1e-4f * p.k * q.k && jp >= 0.0f && jq >= 0.0f) {
			jp /= det;
			jq /= det;
			lane_strike(&c, k, l, jp + jq, p.at * jp + q.at * jq, p.bt * jp + q.bt * jq);
			return 1;
		}
	}
	if (!p.hits || (q.hits && q.vn < p.vn))
		p = q;
	{
		float j = (p.out - p.vn) / p.k;
		lane_strike(&c, k, l, j, p.at * j, p.bt * j);
	}
	return 1;
}

/* Lanes of a block that may meet. In the overflow colour a body is in several lanes, and one may make another meet. */
static uint32_t lanes_closing(cn_world *world, const cni_listed_block *b, int32_t color, const cni_solve *s)
{
	if (color == CNI_COLOR_OVERFLOW)
		return (1u << b->lanes) - 1u;
	return s->kernel->closing(cni_starts(world), b->rows, b->info, s->restitution_threshold, b->lanes);
}

static uint32_t block_sweep(cn_world *world, const cni_listed_block *b, int32_t color, const cni_solve *s)
{
	uint32_t closing = lanes_closing(world, b, color, s), hits = 0;
	for (; closing != 0; closing &= closing - 1) {
		int32_t l = cni_bit_lowest32(closing);
		if (b->info->restitution[l] > 0.0f)
			hits += (uint32_t)lane_impact(world, b->rows, b->info, l, color, s);
	}
	return hits;
}

/* A sweep over the blocks of one colour: they share no body that they write, but for those of the overflow colour. */
typedef struct color_sweep {
	cn_world *world;
	const cni_solve *s;
	const cni_listed_block *blocks;
	int32_t color;
	uint32_t hits;
} color_sweep;

static void color_sweep_run(void *context, int32_t begin, int32_t end, int32_t worker)
{
	color_sweep *c = (color_sweep *)context;
	uint32_t hits = 0;
	int32_t k;
	(void)worker;
	for (k = begin; k < end; ++k)
		if (c->blocks[k].info->flags & CNI_BLOCK_RESTITUTION)
			hits += block_sweep(c->world, &c->blocks[k], c->color, c->s);
	if (hits > 0)
		cni_atomic_add(&c->hits, hits);
}

static uint32_t sweep(cn_world *world, const cni_solve *s)
{
	color_sweep c;
	c.world = world;
	c.s = s;
	c.hits = 0;
	for (c.color = 0; c.color < CNI_COLORS; ++c.color) {
		c.blocks = cni_listed_blocks(world, c.color);
		cni_team_for(c.color == CNI_COLOR_OVERFLOW ? NULL : s->team, world->colors[c.color].listed_count, BLOCKS_A_RANGE, color_sweep_run, &c);
	}
	return c.hits;
}

void cni_contacts_impact(cn_world *world, const cni_solve *s)
{
	int32_t k;
	for (k = 0; k < SWEEPS && s->bounces; ++k)
		if (sweep(world, s) == 0)
			return;
}
