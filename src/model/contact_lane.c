/*
 * model/contact_lane.c - writes manifolds into lanes, where the solver reads them, with the anchors for manifold reuse; and
 * reads lanes back for the public API.
 */
#include "model/world.h"

#include <string.h>

/* The poses that convert a manifold (in body 0's frame) into a lane (world directions, lane bodies). */
typedef struct lane_frame {
	const cni_body *a, *b; /* lane bodies */
	cni_vec2 d;            /* ra - rb: centre b - centre a if the contact points coincide */
	cni_vec2 n, t;
	uint32_t locks;        /* CN_BODY_LOCK_ flags of either body */
} lane_frame;

/* a, b: the contact's bodies. */
CNI_INLINE lane_frame frame_make(const cni_body *a, const cni_body *b, int32_t flipped, cni_vec2 normal)
{
	lane_frame f;
	f.a = flipped ? b : a;
	f.b = flipped ? a : b;
	f.d = cni_body_a_to_b(f.a, f.b);
	f.n = flipped ? cni_neg(normal) : normal;
	f.t = cni_right_perp(f.n);
	f.locks = (cni_body_flags(f.a) | cni_body_flags(f.b)) & (CN_BODY_LOCK_X | CN_BODY_LOCK_Y);
	return f;
}

static void lane_clear_point(cni_contact_row *p, uint32_t lane)
{
	p->at[lane] = p->an[lane] = p->s0[lane] = p->nm[lane] = p->jn[lane] = p->load[lane] = 0.0f;
}

/* The state of a point that a lane keeps across manifolds. */
typedef struct old_point {
	uint32_t id; /* 0: none; no point has this id */
	float jn, load;
} old_point;

static void restitution_write(cni_block_info *info, int32_t lane, float restitution)
{
	info->restitution[lane] = restitution;
	if (restitution > 0.0f)
		info->flags |= CNI_BLOCK_RESTITUTION;
	if (restitution > CNI_BOUNCE_DELAY_RESTITUTION)
		info->flags |= CNI_BLOCK_BOUNCES;
}

static void lane_write_material(cn_world *world, const cni_contact *c, cni_contact_block *block, int32_t lane)
{
	cn_material m = cni_material_mix(world, cni_proxy_at(world, c->proxy[0])->shape, cni_proxy_at(world, c->proxy[1])->shape);
	cni_block_info *info = cni_block_info_at(world, c->slot / CNI_LANES);
	block->static_friction[lane] = m.static_friction;
	block->dynamic_friction[lane] = m.dynamic_friction;
	restitution_write(info, lane, m.restitution);
	if ((m.rolling_resistance > 0.0f || m.tangent_speed_mps != 0.0f) && !cni_lane_reserve_extra(world))
		world->warnings |= CN_WARNING_FRAME_MEMORY; /* first conveyor of a resting contact: it has none */
	cni_block_extra *extra = cni_block_extra_at(world, c->slot / CNI_LANES);
	if (extra == NULL)
		return;
	extra->tangent_speed[lane] = m.tangent_speed_mps;
	extra->rolling[lane] = m.rolling_resistance;
	if (m.rolling_resistance > 0.0f || m.tangent_speed_mps != 0.0f)
		info->flags |= CNI_BLOCK_EXTRA;
}

/* Rounding radius of the shape of a lane's first body. */
static float lane_radius(const cn_world *world, const cni_contact *c)
{
	int32_t flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0;
	const cni_shape *s = cni_shape_at(world, cni_proxy_at(world, c->proxy[flipped])->shape);
	return cni_shape_geometry(&world->blocks, s)->radius;
}

static float lock(const cni_body *b, uint32_t flag)
{
	return cni_body_flags(b) & flag ? 1.0f : 0.0f;
}

static void lane_write_locks(const cn_world *world, const cni_contact *c, const lane_frame *f)
{
	int32_t lane = c->slot % CNI_LANES;
	cni_block_extra *extra = cni_block_extra_at(world, c->slot / CNI_LANES);
	extra->lock_ax[lane] = lock(f->a, CN_BODY_LOCK_X);
	extra->lock_ay[lane] = lock(f->a, CN_BODY_LOCK_Y);
	extra->lock_bx[lane] = lock(f->b, CN_BODY_LOCK_X);
	extra->lock_by[lane] = lock(f->b, CN_BODY_LOCK_Y);
}

/* Inverse mass along a direction, reduced by locked axes, and of the turn about an arm. */
static float mobility_of(const cni_body *b, const cni_motion *m, cni_vec2 n, float arm)
{
	uint32_t flags = cni_body_flags(b);
	float x = flags & CN_BODY_LOCK_X ? 0.0f : n.x, y = flags & CN_BODY_LOCK_Y ? 0.0f : n.y;
	return m->inv_mass * (x * x + y * y) + m->inv_inertia * arm * arm;
}

/* Effective mass of a row along n at the arms of both bodies; 0 if an impulse moves neither by CNI_MOBILITY_LEAST_PART of what it would without
   locked axes. */
static float locked_row_mass(const cn_world *world, const lane_frame *f, cni_vec2 n, float arm_a, float arm_b)
{
	const cni_motion *ma = cni_motions(world) + f->a->awake, *mb = cni_motions(world) + f->b->awake;
	float a = mobility_of(f->a, ma, n, arm_a), b = mobility_of(f->b, mb, n, arm_b);
	int32_t moves_a = ma->inv_mass > 0.0f && a >= CNI_MOBILITY_LEAST_PART * ma->inv_mass;
	int32_t moves_b = mb->inv_mass > 0.0f && b >= CNI_MOBILITY_LEAST_PART * mb->inv_mass;
	return moves_a || moves_b ? 1.0f / (a + b) : 0.0f;
}

/* The rows of a lane that was written as if no axis were locked. */
static void lane_lock_rows(const cn_world *world, const cni_contact *c, const lane_frame *f)
{
	int32_t l = c->slot % CNI_LANES;
	cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	for (int32_t k = 0; k < 2 && block->p[k].nm[l] > 0.0f; ++k) {
		cni_contact_row *p = &block->p[k];
		p->nm[l] = locked_row_mass(world, f, f->n, p->at[l], p->at[l] - block->dt[l]);
		if (p->nm[l] == 0.0f)
			p->jn[l] = p->load[l] = 0.0f;
	}
	block->tm[l] = locked_row_mass(world, f, f->t, block->fa[l], block->fb[l]);
}

/* Rare data of a lane: locked axes, a changed material, rolling resistance. Without memory for the extra rows that a locked axis needs, the
   kernel takes the body as free along it: a reduced mass would push it too hard, and more in each pass. The solver then only clears the locked
   velocity afterwards. */
static void lane_write_rare(cn_world *world, cni_contact *c, const lane_frame *f)
{
	int32_t block = c->slot / CNI_LANES;
	cni_block_info *info = cni_block_info_at(world, block);
	if (f->locks && cni_lane_reserve_extra(world)) {
		info->flags |= CNI_BLOCK_EXTRA;
		lane_lock_rows(world, c, f);
	} else if (f->locks) {
		world->warnings |= CN_WARNING_FRAME_MEMORY;
	}
	if (info->flags & CNI_BLOCK_EXTRA)
		lane_write_locks(world, c, f);
	if (c->flags & CNI_CONTACT_REFRESH) {
		lane_write_material(world, c, cni_block_at(world, block), c->slot % CNI_LANES);
		c->flags &= ~(uint32_t)CNI_CONTACT_REFRESH;
	}
	if (info->flags & CNI_BLOCK_EXTRA)
		cni_block_extra_at(world, block)->rolling_mass[c->slot % CNI_LANES] =
			cni_inverse_or_zero(cni_motions(world)[f->a->awake].inv_inertia + cni_motions(world)[f->b->awake].inv_inertia);
}

/* Manifold reuse excludes contacts that the narrowphase must visit in each step, and lanes with rare rows that depend on more than
   poses. */
static int32_t may_be_reused(const cn_world *world, const cni_contact *c, const cni_block_info *info, const lane_frame *f)
{
	const uint32_t visited = CNI_CONTACT_ENTERED | CNI_CONTACT_ENTER_OWED | CNI_CONTACT_CREATED_OWED | CNI_CONTACT_ONE_WAY | CNI_CONTACT_PRE_SOLVE;
	int32_t l = c->slot % CNI_LANES;
	if ((c->flags & visited) || f->locks)
		return 0;
	if (!(info->flags & CNI_BLOCK_EXTRA))
		return 1;
	const cni_block_extra *extra = cni_block_extra_at(world, c->slot / CNI_LANES);
	return extra->rolling[l] == 0.0f && extra->tangent_speed[l] == 0.0f;
}

/* Bits 0 and 8 of the result, in this order or swapped: the features of b and a are edges (CNI_FEATURE_EDGE), not corners or circles. */
CNI_INLINE uint32_t edges_of(uint32_t id, uint32_t swap)
{
	uint32_t edges = (id - 0x0101u) >> 4;
	return swap ? edges >> 8 | edges << 8 : edges;
}

static uint32_t is_circle(const cn_world *world, int32_t proxy)
{
	return cni_shape_geometry(&world->blocks, cni_shape_at(world, cni_proxy_at(world, proxy)->shape))->type == CN_SHAPE_CIRCLE;
}

/* What normal and points move with. The manifold's axis names the face, where there is one; a single corner on a corner has none. Points are
   taken to be of the face's body unless all are corners of the other. */
typedef struct lane_kind {
	uint32_t has_face, face_of_b, points_of_b;
} lane_kind;

CNI_INLINE lane_kind lane_kind_of(const cni_contact *c, int32_t points)
{
	uint32_t axis_of_b = c->cache.axis > CN_POLYGON_MAX_VERTICES;
	uint32_t edges = edges_of(c->id[0], axis_of_b), others = points == 2 ? edges_of(c->id[1], axis_of_b) : edges; /* bit 8: of the face's body */
	uint32_t incident = edges >> 8 & ~edges & others >> 8 & ~others & 1u;
	lane_kind k;
	k.has_face = c->cache.axis != 0 && (points == 2 || ((edges ^ edges >> 8) & 1u));
	k.face_of_b = axis_of_b ^ ((c->flags & CNI_CONTACT_FLIPPED) != 0);
	k.points_of_b = k.face_of_b ^ incident;
	return k;
}

CNI_INLINE void anchor_write_kind(const cn_world *world, const cni_contact *c, int32_t ib, cni_block_info *info, uint32_t l, lane_kind kind)
{
	uint32_t of_b = kind.has_face & kind.face_of_b, face = kind.has_face & (of_b | (ib != 0));
	uint32_t circles = c->cache.axis == 0 && is_circle(world, c->proxy[0]) && is_circle(world, c->proxy[1]);
	info->of_b = (cni_lane_bits)cni_bits_with(info->of_b, l, of_b | circles);
	info->face = (cni_lane_bits)cni_bits_with(info->face, l, face);
	info->points_of_b = (cni_lane_bits)cni_bits_with(info->points_of_b, l, face ? kind.points_of_b : ib == 0);
}

/* Keeps the normal in the frame of lane body a, or of b, whose rotation is q. */
CNI_INLINE void normal_keep(cni_block_info *info, cni_block_anchor *anchor, uint32_t l, uint32_t of_b, cni_rot q, cni_vec2 normal)
{
	cni_vec2 n = cni_unrotate(q, normal);
	info->of_b = (cni_lane_bits)cni_bits_with(info->of_b, l, of_b);
	anchor->x.nx[l] = n.x;
	anchor->ny[l] = n.y;
}

/* Writes the anchor, after the lane's rows. A face that turns over the corner of a static body has none: there is no room for its normal. */
CNI_INLINE void anchor_write(cn_world *world, const cni_contact *c, cni_contact_block *block, cni_block_info *info, const lane_frame *f, int32_t points, lane_kind kind, float gap)
{
	uint32_t slot = (uint32_t)c->slot, l = slot % CNI_LANES, of_b;
	int32_t rolls_on_static = CNI_HAS_CIRCLES && points == 1 && block->ib[l] == 0 && kind.has_face && !kind.face_of_b;
	cni_block_anchor *anchor = cni_block_anchor_at(world, (int32_t)(slot / CNI_LANES));
	if (gap != 0.0f || rolls_on_static || !may_be_reused(world, c, info, f)) {
		cni_lane_invalidate(world, c->slot);
		anchor->of.fresh.gap[l] = gap;
		if (points == 2 && block->ib[l] != 0)
			normal_keep(info, anchor, l, 0, f->a->q, f->n); /* for lane_normal */
		return;
	}
	anchor_write_kind(world, c, block->ib[l], info, l, kind);
	of_b = info->of_b >> l & 1u;
	normal_keep(info, anchor, l, of_b, of_b ? f->b->q : f->a->q, f->n);
	cni_rot turn = cni_rot_between(f->a->q, f->b->q);
	float centers = cni_dot(f->d, f->n);
	info->anchored = (uint16_t)(info->anchored | 1u << l);
	if (block->ib[l] == 0)
		anchor->x.body[l] = c->body[1 - ((c->flags & CNI_CONTACT_FLIPPED) != 0)];
	anchor->dt[l] = block->dt[l];
	anchor->c[l] = turn.c;
	anchor->s[l] = turn.s;
	anchor->of.less[0][l] = block->p[0].s0[l] - centers;
	anchor->of.less[1][l] = block->p[1].s0[l] - centers;
	if (CNI_HAS_CIRCLES && points == 1)
		block->p[1].at[l] = block->p[0].at[l] - (info->points_of_b >> l & 1u ? block->dt[l] : 0.0f);
}

CNI_INLINE old_point old_point_take(cni_contact *c, const cni_contact_block *block, int32_t k, uint32_t lane)
{
	old_point old = { c->id[k], block->p[k].jn[lane], block->p[k].load[lane] };
	c->id[k] = 0;
	return old;
}

/* Does a lane with two points before and now keep its old normal? See CNI_NORMAL_LAG. */
static int32_t normal_lags(const cn_world *world, const cni_contact_block *block, uint32_t lane, cni_vec2 n)
{
	const cni_motion *motions = cni_motions(world);
	float x = n.x - block->nx[lane], y = n.y - block->ny[lane], most_sq = cni_normal_lag_sq(world);
	if (most_sq < 0.0f || block->ib[lane] == 0 || !(x * x + y * y <= most_sq))
		return 0;
	return cni_max(cni_abs(motions[block->ia[lane]].w), cni_abs(motions[block->ib[lane]].w)) <= CNI_NORMAL_LAG_SPIN;
}

/*
 * Puts normal and arms of a round corner that bears on a face, alone, half a step ahead: at the beginning of the step they are half a step late
 * on average, and what rolls to and fro gains energy. One that does not bear may be struck in the step, and move otherwise. Seen from the
 * face, whose body turns with w, a corner of a and the centre of b move along t by
 *   at' = (w - wa) an,  dt' = t.(vb - va) + w d.n      (a corner of b: (at - dt)' = (w - wb) (an - dn))
 */
static void rolling_advance(const cn_world *world, cni_contact_block *block, uint32_t lane, lane_kind kind, float radius)
{
	const cni_motion *a = cni_motions(world) + block->ia[lane], *b = cni_motions(world) + block->ib[lane];
	cni_contact_row *p = &block->p[0];
	block->p[1].an[lane] = kind.has_face ? radius : 0.0f;
	if (!(block->p[1].an[lane] > 0.0f) || !(p->jn[lane] > 0.0f))
		return;
	float h = 0.5f * world->step_dt, w = kind.face_of_b ? b->w : a->w, apart = block->fa[lane] - block->fb[lane], nx = block->nx[lane], ny = block->ny[lane];
	float slide = h * (ny * (b->vx - a->vx) - nx * (b->vy - a->vy) + w * apart);
	float turn = kind.points_of_b ? h * (w - b->w) * (p->an[lane] - block->dn[lane]) : h * (w - a->w) * p->an[lane];
	float of_a = kind.points_of_b ? turn + slide : turn, of_b = of_a - slide;
	float u = 0.5f * h * w, sine = 2.0f * u / (1.0f + u * u), cosine = 1.0f - u * sine; /* of the angle h w, nearly */
	if (!(cni_max(cni_abs(of_a), cni_abs(of_b)) <= CNI_ROLLING_ADVANCE_SLOPS * world->settings.slop))
		return;
	block->nx[lane] = cosine * nx - sine * ny;
	block->ny[lane] = cosine * ny + sine * nx;
	float at = p->at[lane] += of_a, dt = block->dt[lane] += slide, bt = at - dt;
	p->nm[lane] = cni_inverse_or_zero(a->inv_mass + b->inv_mass + a->inv_inertia * at * at + b->inv_inertia * bt * bt);
}

void cni_contact_write(cn_world *world, cni_contact *c, const cni_body *a, const cni_body *b, const cni_touch_result *touch)
{
	const cni_manifold *manifold = &touch->manifold;
	uint32_t slot = (uint32_t)c->slot, lane = slot % CNI_LANES;
	cni_contact_block *block = cni_block_at(world, (int32_t)(slot / CNI_LANES));
	cni_block_info *info = cni_block_info_at(world, (int32_t)(slot / CNI_LANES));
	int32_t flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0, kept = 0;
	cni_vec2 normal = cni_rotate(a->q, manifold->normal), gap = cni_rotate(a->q, touch->gap);
	lane_frame f = frame_make(a, b, flipped, normal);
	const cni_motion *ma = cni_motions(world) + a->awake, *mb = cni_motions(world) + b->awake;
	float inv_mass = ma->inv_mass + mb->inv_mass, ia = (flipped ? mb : ma)->inv_inertia, ib = (flipped ? ma : mb)->inv_inertia;
	float radius_a = touch->radius[flipped], fa = 0.0f, fb, ahead, dn, dt;
	const old_point first = old_point_take(c, block, 0, lane), second = old_point_take(c, block, 1, lane), none = { 0, 0.0f, 0.0f };
	ahead = cni_dot(gap, normal);
	f.d = flipped ? cni_add(f.d, gap) : cni_sub(f.d, gap);
	dn = cni_dot(f.d, f.n);
	dt = cni_dot(f.d, f.t);
	if (manifold->count < 2 || block->p[1].nm[lane] == 0.0f || !normal_lags(world, block, lane, f.n)) {
		block->nx[lane] = f.n.x;
		block->ny[lane] = f.n.y;
	}
	block->dn[lane] = dn - radius_a - touch->radius[1 - flipped];
	block->dt[lane] = dt;
	for (int32_t k = 0; k < manifold->count; ++k) {
		const cni_manifold_point *point = &manifold->points[k];
		cni_contact_row *p = &block->p[k];
		cni_vec2 r = cni_rotate(a->q, cni_sub(point->point, a->local_center));
		old_point was = point->id == first.id ? first : point->id == second.id ? second : none;
		if (flipped)
			r = cni_add(r, f.d); /* from lane a's centre, not lane b's */
		float at = cni_dot(r, f.t);
		float bt = at - dt;
		float an = cni_dot(r, f.n) - radius_a;
		p->at[lane] = at;
		p->an[lane] = an;
		p->s0[lane] = point->separation;
		p->nm[lane] = cni_inverse_or_zero(inv_mass + ia * at * at + ib * bt * bt);
		p->jn[lane] = p->nm[lane] > 0.0f ? was.jn : 0.0f; /* if nothing can move, the kernels see a zero row */
		p->load[lane] = p->nm[lane] > 0.0f ? was.load : 0.0f;
		kept |= was.id != 0;
		c->id[k] = (uint16_t)point->id;
		fa += an + radius_a;
	}
	if (manifold->count == 1)
		lane_clear_point(&block->p[1], lane);
	if (!kept)
		block->jt[lane] = 0.0f;
	if (manifold->count == 2)
		fa *= 0.5f;
	/* Friction acts on the contact line, at the mean height of the points along the normal: one row is exact in 2D if the points share it. */
	fb = fa - dn;
	block->fa[lane] = fa;
	block->fb[lane] = fb;
	block->tm[lane] = cni_inverse_or_zero(inv_mass + ia * fa * fa + ib * fb * fb);
	if ((c->flags & CNI_CONTACT_REFRESH) || f.locks || (info->flags & CNI_BLOCK_EXTRA))
		lane_write_rare(world, c, &f);
	lane_kind kind = lane_kind_of(c, manifold->count);
	anchor_write(world, c, block, info, &f, manifold->count, kind, ahead);
	if (CNI_HAS_CIRCLES && manifold->count == 1 && !f.locks)
		rolling_advance(world, block, lane, kind, touch->radius[kind.points_of_b ^ (uint32_t)flipped]);
}

void cni_contact_write_empty(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	uint32_t lane = (uint32_t)c->slot % CNI_LANES;
	lane_clear_point(&block->p[0], lane);
	lane_clear_point(&block->p[1], lane);
	block->tm[lane] = block->jt[lane] = 0.0f;
	c->id[0] = c->id[1] = 0;
	cni_lane_invalidate(world, c->slot);
}

/* Row indices: see cni_contact_block. */
enum { ROW_NX = 0, ROW_NY = 1, ROW_DT = 5, ROW_FA = 6, ROW_FB = 7, ROW_JT = 9, ROW_POINT = 10, ROW_POINT_COUNT = 6 };

/* The true normal of a lane between awake bodies, which the lane's may lag behind (CNI_NORMAL_LAG). */
static cni_vec2 lane_normal(const cn_world *world, const cni_contact *c)
{
	int32_t block = c->slot / CNI_LANES, l = c->slot % CNI_LANES;
	const cni_contact_block *rows = cni_block_at(world, block);
	const cni_block_anchor *anchor = cni_block_anchor_at(world, block);
	uint32_t flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0, of_b = cni_block_info_at(world, block)->of_b >> l & 1u;
	if (rows->p[1].nm[l] == 0.0f || rows->ib[l] == 0 || cni_normal_lag_sq(world) < 0.0f)
		return cni_v(rows->nx[l], rows->ny[l]);
	return cni_rotate(cni_body_at(world, c->body[flipped ^ of_b])->q, cni_v(anchor->x.nx[l], anchor->ny[l]));
}

static void extra_to_sleep(const cn_world *world, const cni_contact *c, cni_sleep_lane *s)
{
	const float *rows = (const float *)(const void *)cni_block_extra_at(world, c->slot / CNI_LANES);
	for (int32_t row = 0; row < CNI_SLEEP_EXTRA_ROWS; ++row)
		s->extra[row] = rows != NULL ? rows[row * CNI_LANES + c->slot % CNI_LANES] : 0.0f;
	if (!cni_sleep_lane_needs_extra(s))
		memset(s->extra, 0, sizeof s->extra);
}

/* Copies of a lane's rows and of what is beside them. The normal is the true one: a pile at rest has leaned as far as it will. */
static void lane_read(const cn_world *world, int32_t contact, cni_sleep_lane *s)
{
	const cni_contact *c = cni_contact_at(world, contact);
	int32_t block = c->slot / CNI_LANES, l = c->slot % CNI_LANES;
	const float *rows = (const float *)(const void *)cni_block_at(world, block) + l;
	cni_vec2 n = lane_normal(world, c);
	for (int32_t row = 0; row < CNI_SLEEP_ROWS; ++row)
		s->rows[row] = rows[(row + 2) * CNI_LANES];
	s->rows[ROW_NX] = n.x;
	s->rows[ROW_NY] = n.y;
	s->restitution = cni_block_info_at(world, block)->restitution[l];
	extra_to_sleep(world, c, s);
	s->contact = contact;
}

/* The contact's rows with its true normal: where it sleeps, or copied. */
static const float *rows_of(const cn_world *world, int32_t contact, cni_sleep_lane *copy)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (!CNI_SLEEP_IN_BLOCKS && (c->flags & CNI_CONTACT_ASLEEP))
		return ((const cni_sleep_lane *)world->sleep_lanes.data)[c->slot].rows;
	lane_read(world, contact, copy);
	return copy->rows;
}

/* A lane describes the beginning of the step, and the middle of what rolls. The distance by which its anchors on the two bodies have separated since is the change of
   separation along n; the point stays midway and moves by half of it. Turning is ignored. Reported is the normal along which impulses act. */
static void describe_manifold(const cn_world *world, int32_t contact, cn_manifold *out)
{
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_contact_block *block = cni_contact_has_lane(c) ? cni_block_at(world, c->slot / CNI_LANES) : NULL;
	cni_sleep_lane copy;
	const float *rows = rows_of(world, contact, &copy);
	int32_t flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0;
	float radius = lane_radius(world, c), gap = cni_contact_gap(world, c), moved_n, moved_t;
	cni_vec2 n = cni_v(rows[ROW_NX], rows[ROW_NY]), push = n, t = cni_right_perp(n), middle;
	if (block != NULL)
		push = cni_v(block->nx[c->slot % CNI_LANES], block->ny[c->slot % CNI_LANES]);
	lane_frame f = frame_make(cni_body_at(world, c->body[0]), cni_body_at(world, c->body[1]), flipped, flipped ? cni_neg(n) : n);
	moved_n = cni_dot(f.d, n) - (rows[ROW_FA] - rows[ROW_FB]);
	moved_t = cni_dot(f.d, t) - rows[ROW_DT];
	middle = cni_madd(cni_madd(cni_v(f.a->cx, f.a->cy), 0.5f * moved_n, n), 0.5f * moved_t, t);
	out->normal = flipped ? cni_neg(push) : push;
	out->friction_impulse_Ns = rows[ROW_JT]; /* n, t and the bodies all flip: the sign stays */
	for (int32_t k = 0; k < 2; ++k) {
		const float *p = rows + ROW_POINT + k * ROW_POINT_COUNT; /* at an s0 nm jn load */
		cn_manifold_point *point = &out->points[out->point_count];
		cni_vec2 r = cni_add(cni_mul(p[0], t), cni_mul(p[1] + radius, n));
		if (c->id[k] == 0)
			continue;
		point->point_m = cni_add(middle, r);
		point->separation_m = p[2] - gap + moved_n;
		point->normal_impulse_Ns = p[4];
		point->feature_id = c->id[k];
		++out->point_count;
	}
}

void cni_contact_describe(const cn_world *world, int32_t contact, int32_t kind, cn_contact_event *out)
{
	const cni_contact *c = cni_contact_at(world, contact);
	const cni_proxy *a = cni_proxy_at(world, c->proxy[0]), *b = cni_proxy_at(world, c->proxy[1]);
	memset(out, 0, sizeof *out);
	out->shape_a = cni_handles_of(&world->shape_handles, a->shape);
	out->shape_b = cni_handles_of(&world->shape_handles, b->shape);
	out->body_a = cni_handles_of(&world->body_handles, c->body[0]);
	out->body_b = cni_handles_of(&world->body_handles, c->body[1]);
	out->child_a = cni_proxy_child(a);
	out->child_b = cni_proxy_child(b);
	out->contact_id = (uint32_t)contact + 1u;
	out->kind = kind;
	out->material_a = cni_shape_material_id(&world->blocks, cni_shape_at(world, a->shape));
	out->material_b = cni_shape_material_id(&world->blocks, cni_shape_at(world, b->shape));
	if (c->flags & CNI_CONTACT_TOUCHING)
		describe_manifold(world, contact, &out->manifold);
}

/* Fills its place in the array with the last one. */
static void stored_free(cn_world *world, const cni_contact *c)
{
	cni_sleep_lane *lanes = (cni_sleep_lane *)world->sleep_lanes.data;
	int32_t last = --world->sleep_lanes.count;
	if (c->slot != last) {
		lanes[c->slot] = lanes[last];
		cni_contact_at(world, lanes[last].contact)->slot = c->slot;
	}
}

void cni_contact_sleep_lane_free(cn_world *world, cni_contact *c)
{
	if (CNI_SLEEP_IN_BLOCKS)
		cni_lane_free(world, cni_block_info_at(world, c->slot)->contact[0]);
	else
		stored_free(world, c);
	c->flags &= ~(uint32_t)CNI_CONTACT_ASLEEP;
	c->slot = CNI_NONE;
}

static void sleep_to_extra(const cn_world *world, const cni_contact *c, const cni_sleep_lane *s)
{
	float *rows = (float *)(void *)cni_block_extra_at(world, c->slot / CNI_LANES);
	if (rows == NULL)
		return;
	for (int32_t row = 0; row < CNI_SLEEP_EXTRA_ROWS; ++row)
		rows[row * CNI_LANES + c->slot % CNI_LANES] = s->extra[row];
	if (cni_sleep_lane_needs_extra(s))
		cni_block_info_at(world, c->slot / CNI_LANES)->flags |= CNI_BLOCK_EXTRA;
}

static void lane_write(const cn_world *world, const cni_contact *c, const cni_sleep_lane *s)
{
	int32_t block = c->slot / CNI_LANES, l = c->slot % CNI_LANES;
	float *rows = (float *)(void *)cni_block_at(world, block) + l;
	for (int32_t row = 0; row < CNI_SLEEP_ROWS; ++row)
		rows[(row + 2) * CNI_LANES] = s->rows[row];
	restitution_write(cni_block_info_at(world, block), l, s->restitution);
	sleep_to_extra(world, c, s);
}

void cni_contact_lane_to_sleep(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	cni_contact_block *block = cni_block_at(world, c->slot / CNI_LANES);
	cni_sleep_lane own, *s = CNI_SLEEP_IN_BLOCKS ? &own : (cni_sleep_lane *)world->sleep_lanes.data + world->sleep_lanes.count;
	float gap = cni_contact_gap(world, c);
	CNI_ASSERT(CNI_SLEEP_IN_BLOCKS || world->sleep_lanes.count < world->sleep_lanes.capacity);
	for (int32_t k = 0; k < 2; ++k)
		block->p[k].s0[c->slot % CNI_LANES] -= gap;
	lane_read(world, contact, s);
	cni_lane_free(world, contact);
	c->flags |= CNI_CONTACT_ASLEEP;
	if (!CNI_SLEEP_IN_BLOCKS) {
		c->slot = world->sleep_lanes.count++;
		return;
	}
	cni_lane_take_asleep(world, contact);
	lane_write(world, c, s);
}

void cni_contact_sleep_to_lane(cn_world *world, int32_t contact)
{
	cni_contact *c = cni_contact_at(world, contact);
	cni_sleep_lane s;
	if (CNI_SLEEP_IN_BLOCKS)
		lane_read(world, contact, &s);
	else
		s = ((const cni_sleep_lane *)world->sleep_lanes.data)[c->slot];
	cni_contact_sleep_lane_free(world, c);
	cni_lane_take(world, contact);
	lane_write(world, c, &s);
	if (cni_block_at(world, c->slot / CNI_LANES)->ib[c->slot % CNI_LANES] != 0)
		normal_keep(cni_block_info_at(world, c->slot / CNI_LANES), cni_block_anchor_at(world, c->slot / CNI_LANES), (uint32_t)c->slot % CNI_LANES, 0,
			cni_body_at(world, c->body[(c->flags & CNI_CONTACT_FLIPPED) != 0])->q, cni_v(s.rows[ROW_NX], s.rows[ROW_NY]));
	if (!world->events.in_step)
		c->flags |= CNI_CONTACT_ENTERED; /* no STAY for the last step: it slept */
	cni_contact_mark_sums(world, c);
}
