/*
 * contacts/manifold_reuse_kernel.h - the kernel of manifold reuse: updates lanes from their anchors instead of a new manifold.
 * Included by each width's contact kernel, called by narrowphase/manifold_reuse.c.
 *
 * Corners of one body, the incident one, touch a face of the other: in the frame of the face's body, the normal is at rest, and the
 * incident body has moved by the change of the centres and turned by a small angle. With the letters of model/contact.h, r the arms of the
 * incident body's corners without their rounding, and turned(r) the change of an arm by that angle,
 *   s = less + dn' + turned(rb).n      separation now, if the face is a's
 *   s = less + dn' - turned(ra).n      if it is b's (info.of_b), or if b is static: the frame is then the world's
 *   drift = dt' - dt + turned(rb).t, or - turned(ra).t      sliding of the incident body along the face
 * This is exact until other features touch, but for the slope of edges: edge_holds. Points slide along with the body of which they are
 * corners (info.points_of_b), or stay on the face; the arm of a corner alone, of which the lane has that of the anchor, turns, too. For a
 * circle about its body's centre, turning changes nothing; between two such circles the normal is that of the centres. Of other pairs (two
 * corners, one-sided chains) the normal only seems to be at rest, and they may slide less: CNI_REUSE_PART. The lane's normal may lag behind
 * the face's: CNI_NORMAL_LAG.
 *
 * The kernel rejects a pair that slid or turned farther than a small part of its size, as other features may touch, a pair with a
 * separation beyond the contact margin or a deep overlap, and a pair so fast that it may leave these limits within the step. Rejected
 * lanes stay unchanged.
 */
#include "contacts/contact_pass.h"

/* Float offsets in a body record: see cni_body. The flags, which follow, are not read: another worker may write them. */
enum { BODY_POSE = 0 /* centre, its low part */, BODY_TURN = 4 /* rotation, local centre */, BODY_TO_EXTENT = 5 /* extent is the fourth */ };

/* The two bodies of each lane, and b's rotation in a's frame. */
typedef struct reuse_pair {
	cni_wide vx, vy, wa, wb;     /* velocity of b's centre less a's; angular velocities */
	cni_wide ma, ia, mb, ib;     /* inverse masses */
	cni_wide dx, dy;             /* centre b - centre a */
	cni_wide ac, as, bc, bs, turn_c, turn_s;
	cni_wide extent;             /* extent of the smaller body */
} reuse_pair;

/* Poses of one side's bodies. */
typedef struct reuse_pose {
	cni_wide x, y, x_low, y_low, c, s, extent, inv_inertia;
} reuse_pose;

#define POSE_FLOATS ((int32_t)(sizeof(cni_reuse_pose) / sizeof(float)))

CNI_INLINE void pose_gather(const cni_reuse_pose *poses, const int32_t *index, reuse_pose *out)
{
	const float *base = (const float *)(const void *)poses;
	cni_wide_gather4(base, POSE_FLOATS, index, &out->x, &out->y, &out->x_low, &out->y_low);
	cni_wide_gather4(base + 4, POSE_FLOATS, index, &out->c, &out->s, &out->extent, &out->inv_inertia);
}

CNI_INLINE void pose_gather_from(const cni_motion *motions, const int32_t *index, const float *const *records, reuse_pose *out)
{
	cni_wide u, v, w;
	cni_wide_gather4_from(records, BODY_POSE, &out->x, &out->y, &out->x_low, &out->y_low);
	cni_wide_gather4_from(records, BODY_TURN, &out->c, &out->s, &u, &v);
	cni_wide_gather4_from(records, BODY_TO_EXTENT, &u, &v, &w, &out->extent);
	cni_wide_gather4((const float *)(const void *)motions + 4, MOTION_FLOATS, index, &u, &v, &w, &out->inv_inertia);
}

CNI_INLINE reuse_pair reuse_gather(const cni_reuse_pass *pass, const cni_contact_block *k, const cni_reuse_bodies *bodies, int32_t l)
{
	const float *base = (const float *)(const void *)pass->motions;
	reuse_pair p;
	reuse_pose a, b;
	cni_wide avx, avy;
	cni_wide_gather4(base, MOTION_FLOATS, k->ia + l, &avx, &avy, &p.wa, &p.ma);
	cni_wide_gather4(base, MOTION_FLOATS, k->ib + l, &p.vx, &p.vy, &p.wb, &p.mb);
	p.vx -= avx;
	p.vy -= avy;
	if (bodies == NULL) {
		pose_gather(pass->poses, k->ia + l, &a);
		pose_gather(pass->poses, k->ib + l, &b);
	} else {
		pose_gather_from(pass->motions, k->ia + l, bodies->a + l, &a);
		pose_gather_from(pass->motions, k->ib + l, bodies->b + l, &b);
	}
	p.ia = a.inv_inertia;
	p.ib = b.inv_inertia;
	p.dx = (b.x - a.x) + (b.x_low - a.x_low);
	p.dy = (b.y - a.y) + (b.y_low - a.y_low);
	p.ac = a.c;
	p.as = a.s;
	p.bc = b.c;
	p.bs = b.s;
	p.turn_c = a.c * b.c + a.s * b.s;
	p.turn_s = a.c * b.s - a.s * b.c;
	p.extent = cni_wide_min(a.extent, b.extent);
	return p;
}

/* What the vector's lanes are: bits of cni_block_info. */
typedef struct reuse_kind {
	cni_mask fixed, of_b, face, points_of_b;
	cni_mask corner;  /* a corner or circle alone on a face */
	cni_mask circles; /* two circles about their bodies' centres */
	cni_mask round;   /* the incident one is such a circle: turning changes nothing */
} reuse_kind;

/* The arm of a point is none, less the radius: a circle about the body's centre. s: separation, of which the point is in the middle. */
CNI_INLINE cni_mask is_round(const cni_reuse_pass *pass, cni_wide along_t, cni_wide along_n, cni_wide s)
{
	cni_mask t = cni_wide_abs(along_t) <= cni_wide_of(pass->tiny), n = cni_wide_abs(along_n) <= pass->tiny + cni_wide_abs(s);
	return t & n;
}

CNI_INLINE reuse_kind reuse_kind_of(const cni_reuse_pass *pass, const reuse_pair *f, const cni_contact_block *k, const cni_block_info *info, int32_t l)
{
	cni_mask alone = cni_wide_load(k->p[1].nm + l) == cni_wide_of(0.0f), of_b = cni_mask_of_bits((uint32_t)info->of_b >> l);
	reuse_kind r;
	r.fixed = cni_mask_of_zero(k->ib + l);
	r.face = cni_mask_of_bits((uint32_t)info->face >> l);
	r.of_b = r.fixed | (r.face & of_b);
	r.points_of_b = cni_mask_of_bits((uint32_t)info->points_of_b >> l);
	r.corner = alone & r.face;
	r.circles = r.round = cni_mask_of_bits(0);
	if (cni_mask_bits(alone) != 0) {
		cni_wide at = cni_wide_load(k->p[0].at + l), an = cni_wide_load(k->p[0].an + l), s = cni_wide_load(k->p[0].s0 + l);
		cni_mask a = is_round(pass, at, an, s), b = is_round(pass, at - cni_wide_load(k->dt + l), an - cni_wide_load(k->dn + l), s);
		r.circles = alone & a & b & of_b & ~r.face;
		a = a & (f->ma > cni_wide_of(0.0f)); /* the centre of a body without mass may be a corner of its shape */
		b = b & (f->mb > cni_wide_of(0.0f));
		r.round = r.circles | (alone & r.face & ((r.of_b & a) | (~r.of_b & b)));
	}
	return r;
}

/* Motion since the anchor was taken, in the frame of the normal. */
typedef struct reuse_change {
	cni_wide nx, ny, dn, dt;
	cni_wide dn_change;   /* since the lane's last update */
	cni_wide slide;       /* dt' - dt */
	cni_wide sin, cos1;   /* of the turn of the incident body: sin, cos - 1 */
} reuse_change;

/* Normals of two circles. */
CNI_INLINE void centers_normal(const reuse_pair *f, cni_mask circles, reuse_change *g)
{
	if (cni_mask_bits(circles) == 0)
		return;
	cni_wide inv = 1.0f / cni_wide_sqrt(f->dx * f->dx + f->dy * f->dy);
	g->nx = cni_wide_select(circles, f->dx * inv, g->nx);
	g->ny = cni_wide_select(circles, f->dy * inv, g->ny);
}

CNI_INLINE reuse_change reuse_change_make(const reuse_pair *f, const reuse_kind *r, const cni_contact_block *k, const cni_block_anchor *anchor, int32_t l)
{
	cni_wide x = cni_wide_load(anchor->x.nx + l), y = cni_wide_load(anchor->ny + l), sin;
	cni_wide c = cni_wide_select(r->of_b, f->bc, f->ac), s = cni_wide_select(r->of_b, f->bs, f->as);
	reuse_change g;
	g.nx = cni_wide_select(r->fixed, cni_wide_load(k->nx + l), c * x - s * y);
	g.ny = cni_wide_select(r->fixed, cni_wide_load(k->ny + l), s * x + c * y);
	centers_normal(f, r->circles, &g);
	g.dn = f->dx * g.nx + f->dy * g.ny;
	g.dt = f->dx * g.ny - f->dy * g.nx;
	g.dn_change = g.dn - (cni_wide_load(k->fa + l) - cni_wide_load(k->fb + l));
	g.slide = g.dt - cni_wide_load(anchor->dt + l);
	sin = cni_wide_load(anchor->c + l) * f->turn_s - cni_wide_load(anchor->s + l) * f->turn_c;
	g.sin = cni_wide_select(r->round, cni_wide_of(0.0f), cni_wide_select(r->of_b, -sin, sin));
	g.cos1 = -0.5f * g.sin * g.sin;
	return g;
}

typedef struct reuse_point {
	cni_wide at, an, s, drift; /* arms and separation now; how far the incident body slid along the face */
	cni_wide shift;            /* change of the arm on a along n */
	cni_mask used;
} reuse_point;

CNI_INLINE reuse_point reuse_point_make(const reuse_change *g, const reuse_kind *r, const cni_contact_block *k, const cni_block_anchor *anchor, int32_t which, int32_t l)
{
	const cni_contact_row *p = &k->p[which];
	const cni_wide zero = cni_wide_of(0.0f);
	cni_mask incident = r->points_of_b ^ r->of_b, corner = CNI_HAS_CIRCLES && which == 0 ? r->corner : cni_mask_of_bits(0);
	cni_wide an = cni_wide_load(p->an + l), at = cni_wide_load(p->at + l), then = cni_wide_load(anchor->dt + l);
	cni_wide own = cni_wide_select(corner, cni_wide_load(k->p[1].at + l), at - cni_wide_select(r->points_of_b, cni_wide_load(k->dt + l), zero));
	cni_wide arm_n = cni_wide_select(r->of_b, an, an - cni_wide_load(k->dn + l));
	cni_wide arm_t = own + cni_wide_select(incident, zero, cni_wide_select(r->of_b, then, -then));
	cni_wide along_n = g->cos1 * arm_n + g->sin * arm_t, along_t = g->cos1 * arm_t - g->sin * arm_n;
	reuse_point q;
	q.s = cni_wide_load(anchor->of.less[which] + l) + g->dn + cni_wide_select(r->of_b, -along_n, along_n);
	q.drift = g->slide + cni_wide_select(r->of_b, -along_t, along_t);
	own += cni_wide_select(corner & incident, along_t, zero);
	q.at = own + cni_wide_select(r->points_of_b, g->dt, zero);
	q.shift = 0.5f * (q.s - cni_wide_load(p->s0 + l)); /* the point stays midway between the surfaces */
	q.shift = cni_wide_select(r->of_b, g->dn_change - q.shift, q.shift);
	q.an = an + q.shift;
	q.used = cni_wide_load(p->nm + l) > cni_wide_of(0.0f);
	return q;
}

/* Lanes whose second point is still there. An edge that slides over points that stay on the face changes their separations by its slope,
   which is left out: by as much as other pairs may slide, at most. */
CNI_INLINE cni_mask edge_holds(const cni_reuse_pass *pass, const reuse_kind *r, const reuse_point *p, const reuse_point *q)
{
	cni_wide slid = cni_wide_abs(q->drift), wide = cni_wide_abs(q->at - p->at);
	cni_mask incident = r->points_of_b ^ r->of_b;
	return ~q->used | ((slid <= wide) & (incident | (cni_wide_abs(q->s - p->s) * slid <= pass->drift_most * wide)));
}

/* Lanes in which the same features touch at the same place, now and after the step. */
CNI_INLINE cni_mask reuse_holds(const cni_reuse_pass *pass, const reuse_pair *f, const reuse_change *g, const reuse_point *p, const reuse_point *q,
                                 cni_wide fa, cni_wide fb, const reuse_kind *r)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_mask exact = r->face | r->circles, alone = r->face & ~q->used & ~r->round; /* a corner alone may slide off the face unseen */
	cni_wide second = cni_wide_select(q->used, cni_wide_abs(q->drift), zero), nearest = cni_wide_min(p->s, cni_wide_select(q->used, q->s, p->s));
	cni_wide un = g->nx * f->vx + g->ny * f->vy + f->wb * (p->at - g->dt) - f->wa * p->at;
	cni_wide spin_a = cni_wide_select(r->round & r->of_b, zero, f->wa), spin_b = cni_wide_select(r->round & ~r->of_b, zero, f->wb); /* circles roll */
	cni_wide ut = g->ny * f->vx - g->nx * f->vy - spin_b * fb + spin_a * fa;
	cni_wide turn = cni_wide_select(r->round, zero, 2.0f * f->extent * cni_wide_abs(f->wb - f->wa));
	cni_wide ahead = cni_wide_max(cni_wide_max(cni_wide_abs(un), cni_wide_abs(ut)), turn) * pass->dt; /* motion in the step */
	cni_wide least = cni_wide_min(f->extent * CNI_REUSE_PART, cni_wide_of(pass->drift_most));
	cni_wide most = cni_wide_select(exact, cni_wide_min(f->extent * CNI_REUSE_FACE_PART, cni_wide_of(pass->drift_most_of_faces)), least);
	most *= cni_wide_select(alone, cni_wide_of(CNI_REUSE_CORNER_PART), cni_wide_of(1.0f));
	cni_wide reach = cni_wide_max(least, cni_wide_min(most, CNI_REUSE_STEPS * ahead));
	return p->used & (cni_wide_max(cni_wide_abs(p->drift), second) <= reach) & (2.0f * f->extent * cni_wide_abs(g->sin) <= reach) &
	       (nearest <= cni_wide_of(pass->apart_most)) & (nearest >= -cni_wide_min(0.25f * f->extent, cni_wide_of(pass->depth_most))) &
	       (ahead <= cni_wide_select(nearest > cni_wide_of(pass->tiny), cni_wide_of(pass->hair), most));
}

CNI_INLINE void reuse_point_store(const reuse_pair *f, cni_contact_row *row, int32_t l, cni_mask where, const reuse_point *p, cni_wide dt)
{
	cni_wide bt = p->at - dt;
	where = where & p->used;
	cni_wide_store_where(row->at + l, where, p->at);
	cni_wide_store_where(row->an + l, where, p->an);
	cni_wide_store_where(row->s0 + l, where, p->s);
	cni_wide_store_where(row->nm + l, where, 1.0f / (f->ma + f->mb + f->ia * p->at * p->at + f->ib * bt * bt));
}

/* Puts what rolls half a step ahead: see rolling_advance of model/contact_lane.c. Returns dt. */
CNI_INLINE cni_wide rolling_advance(const cni_reuse_pass *pass, const reuse_pair *f, const cni_contact_block *k, int32_t l, const reuse_kind *r, cni_wide dn, reuse_change *g, reuse_point *p)
{
	const cni_wide zero = cni_wide_of(0.0f), h = cni_wide_of(0.5f * pass->dt);
	cni_mask rolls = r->corner & (cni_wide_load(k->p[1].an + l) > zero) & (cni_wide_load(k->p[0].jn + l) > zero);
	if (!CNI_HAS_CIRCLES || cni_mask_bits(rolls) == 0)
		return g->dt;
	cni_wide w = cni_wide_select(r->of_b, f->wb, f->wa), slide = h * (g->ny * f->vx - g->nx * f->vy + w * g->dn);
	cni_wide turn = h * cni_wide_select(r->points_of_b, (w - f->wb) * (p->an - dn), (w - f->wa) * p->an);
	cni_wide of_a = cni_wide_select(r->points_of_b, turn + slide, turn), of_b = of_a - slide;
	rolls = rolls & (cni_wide_max(cni_wide_abs(of_a), cni_wide_abs(of_b)) <= cni_wide_of(pass->advance_most));
	cni_wide u = cni_wide_select(rolls, 0.5f * h * w, zero), sine = 2.0f * u / (1.0f + u * u), cosine = 1.0f - u * sine, nx = g->nx;
	g->nx = cosine * nx - sine * g->ny;
	g->ny = cosine * g->ny + sine * nx;
	p->at += cni_wide_select(rolls, of_a, zero);
	return g->dt + cni_wide_select(rolls, slide, zero);
}

/* Lanes that keep their normal although the true one is now (nx, ny). two: both points exist; wa, wb: angular velocities. */
CNI_INLINE cni_mask normal_lags(const cni_contact_block *k, int32_t l, cni_mask two, cni_wide nx, cni_wide ny, cni_wide wa, cni_wide wb, float lag_sq)
{
	cni_wide x = nx - cni_wide_load(k->nx + l), y = ny - cni_wide_load(k->ny + l), spin = cni_wide_max(cni_wide_abs(wa), cni_wide_abs(wb));
	return two & ~cni_mask_of_zero(k->ib + l) & (x * x + y * y <= cni_wide_of(lag_sq)) & (spin <= cni_wide_of(CNI_NORMAL_LAG_SPIN));
}

/* Updates one vector of lanes; returns bits of the reused lanes. */
CNI_INLINE uint32_t reuse_group(const cni_reuse_pass *pass, cni_contact_block *k, const cni_block_info *info, const cni_block_anchor *anchor, const cni_reuse_bodies *bodies, uint32_t anchored, int32_t l)
{
	reuse_pair f = reuse_gather(pass, k, bodies, l);
	reuse_kind r = reuse_kind_of(pass, &f, k, info, l);
	reuse_change g = reuse_change_make(&f, &r, k, anchor, l);
	reuse_point p = reuse_point_make(&g, &r, k, anchor, 0, l), q = reuse_point_make(&g, &r, k, anchor, 1, l);
	cni_wide fa = cni_wide_load(k->fa + l) + cni_wide_select(q.used, 0.5f * (p.shift + q.shift), p.shift), fb = fa - g.dn;
	cni_wide dn = cni_wide_load(k->dn + l) + g.dn_change, dt;
	cni_mask turned, good = cni_mask_of_bits(anchored >> l) & (cni_wide_load(anchor->c + l) * f.turn_c + cni_wide_load(anchor->s + l) * f.turn_s > cni_wide_of(0.0f));
	good = good & edge_holds(pass, &r, &p, &q) & reuse_holds(pass, &f, &g, &p, &q, fa, fb, &r);
	dt = rolling_advance(pass, &f, k, l, &r, dn, &g, &p);
	reuse_point_store(&f, &k->p[0], l, good, &p, dt);
	reuse_point_store(&f, &k->p[1], l, good, &q, dt);
	turned = good & ~normal_lags(k, l, q.used, g.nx, g.ny, f.wa, f.wb, pass->lag_sq);
	cni_wide_store_where(k->nx + l, turned, g.nx);
	cni_wide_store_where(k->ny + l, turned, g.ny);
	cni_wide_store_where(k->dn + l, good, dn);
	cni_wide_store_where(k->dt + l, good, dt);
	cni_wide_store_where(k->fa + l, good, fa);
	cni_wide_store_where(k->fb + l, good, fb);
	cni_wide_store_where(k->tm + l, good, 1.0f / (f.ma + f.mb + f.ia * fa * fa + f.ib * fb * fb));
	return cni_mask_bits(good) << l;
}

static uint32_t kernel_reuse(const cni_reuse_pass *pass, cni_contact_block *k, const cni_block_info *info, const cni_block_anchor *anchor, const cni_reuse_bodies *bodies, uint32_t anchored)
{
	uint32_t reused = 0;
	for (int32_t l = 0; l < CNI_LANES && CNI_ON(MANIFOLD_REUSE); l += CNI_WIDTH) {
		uint32_t lanes = anchored & ((1u << CNI_WIDTH) - 1u) << l;
		if (lanes != 0)
			reused |= reuse_group(pass, k, info, anchor, bodies, lanes, l);
	}
	return reused;
}
