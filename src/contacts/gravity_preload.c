/*
 * contacts/gravity_preload.c - computes the impulses and loads of a large new pile top-down.
 *
 * Soft contacts yield around their load (contacts/contact_kernel.h), and a sweep carries a weight down by only a few bodies. A
 * new pile would sag by its softness until its loads are known. Small piles are solved directly (direct/solver_selection.c). In
 * a pile that is too large for that, this pass visits bodies from the highest to the lowest (the method of jump propagation,
 * Guendelman, Bridson and Fedkiw, 2003). Each body has its own weight and the momentum of the bodies on it. Its supports, taken
 * as fixed, cancel all of its momentum of a substep by least-squares impulses, none of which pulls. The supports pass these
 * impulses on to the bodies below. So every body is in balance, and a pile with these impulses and loads does not move at all.
 *
 * The pass runs once, when most contacts of a quiet island are new. Loads that were corrected repeatedly would drive a swinging
 * pile. A single body that is set down is a pile of one: it stands, or begins to slide, without a false first step. An island
 * with a body that the bodies below cannot hold (an arch, a bridge) is left to the direct solver (direct/solver_selection.c).
 *
 * Reads lanes, external accelerations, motion, and the new contacts of islands that direct/solver_selection.c counted; writes
 * lanes' jn, jt, load.
 */
#include "contacts/contacts.h"
#include "base/sort.h"

#include <string.h>

#define SUPPORTS_MOST 24       /* contacts of one body with what is below it */

/* By dense index: the body's momentum of a substep, from forces and from the bodies on it; its height. */
typedef struct weight {
	float x, y, turn, height;
} weight;

typedef struct row {
	float x, y, turn;      /* momentum that a unit impulse takes from the body; turn over its radius of gyration */
	float support_turn;    /* angular momentum that it gives to the support */
	float share, impulse;
} row;

/* A contact with a support: below the body, or beside it and later in the order. Rows: two points, friction. */
typedef struct support {
	cni_contact_block *lanes;
	int32_t lane, below;
	float sticks, slides;    /* coefficients of friction */
	row rows[3];
} support;

/* One body on its supports. */
typedef struct balance {
	support supports[SUPPORTS_MOST];
	int32_t count;
	float wanted[3], left[3]; /* momentum to cancel, and its residual */
	float down_x, down_y;
} balance;

typedef struct pile {
	cn_world *world;
	weight *weights;
	uint64_t *order;         /* highest first */
	int32_t count;
	int32_t stressed;        /* some contact bears more than soft contacts can */
	int32_t leans;           /* some body bears its load far from the middle of its supports */
	float h;                 /* of a substep */
	float weight_speed;      /* speed that gravity gives in it */
	float warm_scale;        /* of the step's warm start */
} pile;

uint64_t cni_gravity_preload_bytes(int32_t bodies)
{
	return (sizeof(weight) + sizeof(uint64_t)) * (uint64_t)(bodies + 1) + 128u;
}

/* ---- one body ---- */

static row row_make(float x, float y, float turn, float support_turn)
{
	row r = { x, y, turn, support_turn, 0.0f, 0.0f };
	return r;
}

/* The lane from the view of the body, which is its a or its b; scale: 1 / radius of gyration. */
static void support_read(support *p, cni_contact_block *k, int32_t l, int32_t is_b, float scale)
{
	float sign = is_b ? -1.0f : 1.0f, nx = sign * k->nx[l], ny = sign * k->ny[l];
	p->lanes = k;
	p->lane = l;
	p->below = is_b ? k->ia[l] : k->ib[l];
	p->sticks = k->static_friction[l];
	p->slides = k->dynamic_friction[l];
	for (int32_t i = 0; i < 2; ++i) {
		float at = k->p[i].at[l], bt = at - k->dt[l];
		p->rows[i] = is_b ? row_make(nx, ny, -scale * bt, -at) : row_make(nx, ny, scale * at, bt);
	}
	p->rows[2] = is_b ? row_make(ny, -nx, scale * k->fb[l], k->fa[l]) : row_make(ny, -nx, -scale * k->fa[l], -k->fb[l]);
}

int32_t cni_lane_is_plain(const cn_world *world, int32_t block, int32_t l)
{
	const cni_block_extra *x = cni_block_info_at(world, block)->flags & CNI_BLOCK_EXTRA ? cni_block_extra_at(world, block) : NULL;
	return x == NULL || ((x->rolling[l] == 0.0f || cni_block_at(world, block)->p[1].nm[l] > 0.0f) && x->tangent_speed[l] == 0.0f &&
	                     x->lock_ax[l] + x->lock_ay[l] + x->lock_bx[l] + x->lock_by[l] == 0.0f);
}

static int32_t is_above(const pile *q, int32_t other, int32_t body)
{
	float a = q->weights[other].height, b = q->weights[body].height;
	return a > b || (a == b && other < body);
}

/* 0: too many supports, or a contact that is not preloaded. */
static int32_t supports_collect(const pile *q, int32_t index, float scale, balance *out)
{
	const cni_body *b = cni_body_at(q->world, cni_awake_ids(q->world)[index]);
	out->count = 0;
	for (int32_t key = b->contact_first; key != CNI_NONE; key = cni_contact_of_key(q->world, key)->next[key & 1]) {
		const cni_contact *c = cni_contact_of_key(q->world, key);
		int32_t other = c->body[1 - (key & 1)], block = c->slot / CNI_LANES, l = c->slot % CNI_LANES;
		if (!cni_contact_has_lane(c))
			continue;
		if (cni_body_at(q->world, other)->type == CN_BODY_DYNAMIC && is_above(q, cni_body_at(q->world, other)->awake, index))
			continue;
		if (out->count == SUPPORTS_MOST || !cni_lane_is_plain(q->world, block, l))
			return 0;
		support_read(&out->supports[out->count++], cni_block_at(q->world, block), l, cni_block_at(q->world, block)->ia[l] != index, scale);
	}
	return 1;
}

/* Selects the rows. Stage 0: points of contacts steep enough to support by themselves; 1: also their friction; 2: all contacts. */
static void shares_set(balance *b, int32_t stage)
{
	for (int32_t k = 0; k < b->count; ++k) {
		support *p = &b->supports[k];
		int32_t bears = p->rows[0].x * b->down_x + p->rows[0].y * b->down_y >= CNI_PRELOAD_SUPPORT_COSINE;
		for (int32_t i = 0; i < 2; ++i)
			p->rows[i].share = p->lanes->p[i].nm[p->lane] > 0.0f && (bears || stage == 2) ? 1.0f : 0.0f;
		p->rows[2].share = stage > 0 && p->rows[0].share + p->rows[1].share > 0.0f ? CNI_PRELOAD_FRICTION_SHARE : 0.0f;
	}
}

static void row_push(balance *b, row *r, float impulse)
{
	r->impulse += impulse;
	b->left[0] -= r->x * impulse;
	b->left[1] -= r->y * impulse;
	b->left[2] -= r->turn * impulse;
}

/* The impulses j = share (row . m) that cancel the momentum: (sum of share row row') m = left. 0: no row is selected. */
static int32_t impulses_find(balance *b)
{
	float a00 = 0.0f, a10 = 0.0f, a11 = 0.0f, a20 = 0.0f, a21 = 0.0f, a22 = 0.0f, more, l10, l20, l21, d1, d2;
	memcpy(b->left, b->wanted, sizeof b->left);
	for (int32_t k = 0; k < b->count; ++k)
		for (int32_t i = 0; i < 3; ++i) {
			row *r = &b->supports[k].rows[i];
			r->impulse = 0.0f;
			a00 += r->share * r->x * r->x;
			a10 += r->share * r->y * r->x;
			a11 += r->share * r->y * r->y;
			a20 += r->share * r->turn * r->x;
			a21 += r->share * r->turn * r->y;
			a22 += r->share * r->turn * r->turn;
		}
	more = CNI_PRELOAD_REGULARIZATION * (a00 + a11 + a22);
	if (!(more > 0.0f))
		return 0;
	a00 += more;
	l10 = a10 / a00;
	l20 = a20 / a00;
	d1 = a11 + more - l10 * a10;
	l21 = (a21 - l20 * a10) / d1;
	d2 = a22 + more - l20 * a20 - l21 * l21 * d1;
	for (int32_t pass = 0; pass < CNI_PRELOAD_REFINEMENTS; ++pass) {
		float y1 = b->left[1] - l10 * b->left[0], y2 = b->left[2] - l20 * b->left[0] - l21 * y1;
		float m2 = y2 / d2, m1 = y1 / d1 - l21 * m2, m0 = b->left[0] / a00 - l10 * m1 - l20 * m2;
		for (int32_t k = 0; k < b->count; ++k)
			for (int32_t i = 0; i < 3; ++i) {
				row *r = &b->supports[k].rows[i];
				row_push(b, r, r->share * (r->x * m0 + r->y * m1 + r->turn * m2));
			}
	}
	return 1;
}

/* Drops points that pull; clamps friction that slides and lowers its share. 1: something changed. */
static int32_t impulses_bound(balance *b)
{
	int32_t changed = 0;
	for (int32_t k = 0; k < b->count; ++k) {
		support *p = &b->supports[k];
		row *f = &p->rows[2];
		for (int32_t i = 0; i < 2; ++i)
			if (p->rows[i].impulse < 0.0f) {
				row_push(b, &p->rows[i], -p->rows[i].impulse);
				p->rows[i].share = 0.0f;
				changed = 1;
			}
		float normal = p->rows[0].impulse + p->rows[1].impulse;
		float most = p->slides * normal;
		if (cni_abs(f->impulse) > p->sticks * normal) {
			row_push(b, f, cni_clamp(f->impulse, -most, most) - f->impulse);
			f->share *= CNI_PRELOAD_SLIDING_FACTOR;
			changed = 1;
		}
	}
	return changed;
}

static int32_t residual_is_below(const balance *b, float most)
{
	return b->left[0] * b->left[0] + b->left[1] * b->left[1] + b->left[2] * b->left[2] <= most * most;
}

/* 0: the supports cannot hold the body. own: its weight. */
static int32_t balance_solve(balance *b, float own)
{
	for (int32_t stage = 0; stage < 3; ++stage) {
		shares_set(b, stage);
		for (int32_t round = 0; round < CNI_PRELOAD_ROUNDS; ++round)
			if (!impulses_find(b) || !impulses_bound(b))
				break;
		if (residual_is_below(b, CNI_PRELOAD_RESIDUAL_GOOD * own))
			return 1;
	}
	return residual_is_below(b, CNI_PRELOAD_RESIDUAL_MAX * own);
}

/* ---- a pile ---- */

static void supports_load(const pile *q, const balance *b)
{
	for (int32_t k = 0; k < b->count; ++k) {
		const support *p = &b->supports[k];
		weight *w = &q->weights[p->below];
		if (cni_motions(q->world)[p->below].inv_mass == 0.0f)
			continue;
		for (int32_t i = 0; i < 3; ++i) {
			w->x += p->rows[i].x * p->rows[i].impulse;
			w->y += p->rows[i].y * p->rows[i].impulse;
			w->turn += p->rows[i].support_turn * p->rows[i].impulse;
		}
	}
}

/*
 * Stored impulses are those of the last step's substeps; the warm start scales them to this step's. A single body with dynamic
 * below static friction gets no load: on a full load a sudden push rocks it, the friction limit is exceeded for a substep, and
 * it would not stop again.
 */
static void lanes_write(pile *q, const balance *b)
{
	float scale = 1.0f / q->warm_scale;
	for (int32_t k = 0; k < b->count; ++k) {
		const support *p = &b->supports[k];
		for (int32_t i = 0; i < 2; ++i) {
			cni_contact_row *r = &p->lanes->p[i];
			r->jn[p->lane] = scale * p->rows[i].impulse;
			r->load[p->lane] = q->count > 1 || p->sticks == p->slides ? r->jn[p->lane] : 0.0f;
		}
		p->lanes->jt[p->lane] = scale * p->rows[2].impulse;
		q->stressed |= cni_is_stressed(q->world, p->lanes->ia[p->lane], p->lanes->ib[p->lane], p->rows[0].impulse + p->rows[1].impulse, q->h, 1.0f);
	}
}

/* 1: the resultant of the normal impulses is far from the middle of the points: the soft solver's fluctuations lift the lighter side. */
static int32_t is_leaning(const balance *b)
{
	float from = FLT_MAX, to = -FLT_MAX, sum = 0.0f, turn = 0.0f;
	for (int32_t k = 0; k < b->count; ++k)
		for (int32_t i = 0; i < 2; ++i) {
			const support *p = &b->supports[k];
			if (p->lanes->p[i].nm[p->lane] <= 0.0f)
				continue;
			from = cni_min(from, p->rows[i].turn);
			to = cni_max(to, p->rows[i].turn);
			sum += p->rows[i].impulse;
			turn += p->rows[i].impulse * p->rows[i].turn;
		}
	return cni_abs(2.0f * turn - (from + to) * sum) > CNI_PRELOAD_LEANING_PART * (to - from) * sum;
}

static float height_of(const cn_world *world, const cni_body *b)
{
	return -(b->cx * world->settings.gravity.x + b->cy * world->settings.gravity.y);
}

/* Starts each body with its own weight: the momentum from the forces of a substep. */
static void weights_begin(const pile *q)
{
	for (int32_t k = 0; k < q->count; ++k) {
		int32_t index = (int32_t)(q->order[k] & 0xFFFFFFFFu);
		const cni_motion *m = cni_motions(q->world) + index;
		const cni_external *d = cni_externals(q->world) + index;
		weight *w = &q->weights[index];
		w->x = q->h * d->ax * cni_inverse_or_zero(m->inv_mass);
		w->y = q->h * d->ay * cni_inverse_or_zero(m->inv_mass);
		w->turn = q->h * d->alpha * cni_inverse_or_zero(m->inv_inertia);
		w->height = height_of(q->world, cni_body_at(q->world, cni_awake_ids(q->world)[index]));
	}
}

/* 0: some body has no sufficient support. */
static int32_t pile_solve(pile *q, int32_t write)
{
	balance b;
	float g = q->weight_speed / q->h;
	weights_begin(q);
	b.down_x = q->world->settings.gravity.x / g;
	b.down_y = q->world->settings.gravity.y / g;
	for (int32_t k = 0; k < q->count; ++k) {
		int32_t index = (int32_t)(q->order[k] & 0xFFFFFFFFu);
		const cni_motion *m = cni_motions(q->world) + index;
		const weight *w = &q->weights[index];
		float scale = m->inv_mass > 0.0f ? cni_sqrt(m->inv_inertia / m->inv_mass) : 0.0f;
		b.wanted[0] = w->x;
		b.wanted[1] = w->y;
		b.wanted[2] = scale * w->turn;
		if (m->inv_mass == 0.0f || !supports_collect(q, index, scale, &b) || !balance_solve(&b, q->weight_speed / m->inv_mass))
			return 0;
		q->leans |= is_leaning(&b);
		supports_load(q, &b);
		if (write)
			lanes_write(q, &b);
	}
	return 1;
}

/* Sorts the bodies. The weights do not exist yet: their memory is the scratch of the sort. */
static void order_find(pile *q, int32_t island)
{
	for (int32_t body = cni_island_at(q->world, island)->first; body != CNI_NONE; body = cni_body_at(q->world, body)->island_next) {
		const cni_body *b = cni_body_at(q->world, body);
		q->order[q->count++] = (uint64_t)~cni_sort_float_key(height_of(q->world, b)) << 32 | (uint32_t)b->awake;
	}
	cni_sort_keys(q->order, (uint64_t *)(void *)q->weights, q->count);
}

/* Computes the whole pile before it writes anything. 0: the direct solver should take the island. */
static int32_t pile_preload(pile *q)
{
	q->stressed = 0;
	return pile_solve(q, 0) && pile_solve(q, 1) && !q->stressed;
}

/* Are most contacts new, in an island that is quiet, without joints, and neither solved directly nor set to CN_SOLVER_SOFT? */
static int32_t island_is_due(const cn_world *world, int32_t island)
{
	cni_island *i = cni_island_at(world, island);
	return i->new_step == world->step_count + 1u && 2 * i->new_contacts >= i->count && i->tier != CNI_TIER_DIRECT &&
	       i->solver != CN_SOLVER_SOFT && cni_island_is_quiet(world, i) && !cni_island_has_joints(world, island);
}

/* Orders what is due at a body: the body itself, or its island at the island's first body. */
static void due_find(pile *q, int32_t index, int32_t island)
{
	int32_t body = cni_awake_ids(q->world)[index];
	if (island == CNI_NONE) {
		cni_body *b = cni_body_at(q->world, body);
		if ((b->flags & CNI_BODY_SET_DOWN) && !cni_body_is_jointed(q->world, b) && cni_body_is_quiet(q->world, b))
			q->order[q->count++] = (uint32_t)index;
		b->flags &= ~(uint32_t)CNI_BODY_SET_DOWN;
	} else if (cni_island_at(q->world, island)->first == body && island_is_due(q->world, island)) {
		order_find(q, island);
	}
}

static void piles_find(pile *q)
{
	for (int32_t k = 1; k < q->world->awake_count; ++k) {
		int32_t island = cni_awake_island(q->world, k);
		q->count = 0;
		due_find(q, k, island);
		if (q->count > 0 && !pile_preload(q) && island != CNI_NONE) {
			cni_island_at(q->world, island)->unheld_step = q->world->step_count + 1u;
			q->world->piles_unheld = 1;
		}
	}
}

/* 0: no scratch memory, or no weight. */
static int32_t pile_begin(pile *q, cn_world *world, float h, float warm_scale)
{
	uint64_t room = (uint64_t)world->awake_count;
	memset(q, 0, sizeof *q);
	q->world = world;
	q->h = h;
	q->weight_speed = h * cni_length(world->settings.gravity);
	q->warm_scale = warm_scale;
	if (q->weight_speed == 0.0f)
		return 0;
	q->order = (uint64_t *)cni_scratch_push(world, sizeof(uint64_t) * room);
	q->weights = q->order == NULL ? NULL : (weight *)cni_scratch_push(world, sizeof(weight) * room);
	return q->weights != NULL;
}

static void pile_end(pile *q)
{
	(void)cni_arena_pop(&q->world->arena, q->weights);
	(void)cni_arena_pop(&q->world->arena, q->order);
}

int32_t cni_pile_is_supported(cn_world *world, int32_t island, float h)
{
	pile q;
	int32_t stands = 1;
	if (pile_begin(&q, world, h, 1.0f)) {
		order_find(&q, island);
		stands = pile_solve(&q, 0) && !q.leans;
	}
	pile_end(&q);
	return stands;
}

void cni_gravity_preload(cn_world *world, const cni_solve *s)
{
	pile q;
	if (!world->piles_new || s->warm_scale == 0.0f)
		return;
	if (pile_begin(&q, world, s->h, s->warm_scale))
		piles_find(&q);
	pile_end(&q);
}
