/*
 * stages/contact_write.h - the kernel that writes manifolds into the lanes of a block, included by each width's contact
 * kernel after stages/contact_follow.h, of which it uses the offsets in records, store_where and normal_lags. The bits are those of cni_contact_write, operation by operation; what few lanes need is left to that one:
 * see stages/narrowphase_write.c.
 */
#include "stages/contact_pass.h"

/* Where the floats of a manifold are. */
enum { MANIFOLD_NORMAL = 0, MANIFOLD_POINT = 4 };

/* The two bodies of each lane, and the frame of the contact's first body, which is either's. */
typedef struct write_frame {
	cni_mask flipped;
	cni_wide dx, dy;         /* centre b - centre a */
	cni_wide ac, as, bc, bs; /* rotations */
	cni_wide qc, qs, cx, cy; /* of the contact's first body: rotation, centre of mass in its frame */
	cni_wide nx, ny, dn, dt;
	cni_wide mass, ia, ib;   /* inverse: sum, of turning */
	cni_wide wa, wb;         /* spins */
} write_frame;

CNI_INLINE write_frame write_frame_make(const cni_motion *motions, const cni_contact_block *k, const cni_write_lanes *w, int32_t l)
{
	const float *base = (const float *)(const void *)motions;
	cni_wide ax, ay, axl, ayl, acx, acy, bx, by, bxl, byl, bcx, bcy, mx, my, u, v, x;
	write_frame f;
	f.flipped = cni_mask_of_bits(w->flipped >> l);
	cni_wide_gather4_from(w->a + l, BODY_POSE, &ax, &ay, &axl, &ayl);
	cni_wide_gather4_from(w->b + l, BODY_POSE, &bx, &by, &bxl, &byl);
	f.dx = (bx - ax) + (bxl - axl);
	f.dy = (by - ay) + (byl - ayl);
	cni_wide_gather4_from(w->a + l, BODY_TURN, &f.ac, &f.as, &acx, &acy);
	cni_wide_gather4_from(w->b + l, BODY_TURN, &f.bc, &f.bs, &bcx, &bcy);
	f.qc = cni_wide_select(f.flipped, f.bc, f.ac);
	f.qs = cni_wide_select(f.flipped, f.bs, f.as);
	f.cx = cni_wide_select(f.flipped, bcx, acx);
	f.cy = cni_wide_select(f.flipped, bcy, acy);
	cni_wide_gather4_from(w->manifold + l, MANIFOLD_NORMAL, &mx, &my, &u, &v);
	f.nx = f.qc * mx - f.qs * my;
	f.ny = f.qs * mx + f.qc * my;
	f.nx = cni_wide_select(f.flipped, -f.nx, f.nx);
	f.ny = cni_wide_select(f.flipped, -f.ny, f.ny);
	f.dn = f.dx * f.nx + f.dy * f.ny;
	f.dt = f.dx * f.ny - f.dy * f.nx;
	cni_wide_gather4(base, MOTION_FLOATS, k->ia + l, &u, &v, &f.wa, &mx);
	cni_wide_gather4(base, MOTION_FLOATS, k->ib + l, &u, &v, &f.wb, &my);
	f.mass = mx + my;
	cni_wide_gather4(base + 4, MOTION_FLOATS, k->ia + l, &u, &v, &x, &f.ia);
	cni_wide_gather4(base + 4, MOTION_FLOATS, k->ib + l, &u, &v, &x, &f.ib);
	return f;
}

/* 1 / (inverse mass felt through arms on both bodies), 0 where nothing moves. */
CNI_INLINE cni_wide write_mass(const write_frame *f, cni_wide arm_a, cni_wide arm_b)
{
	cni_wide k = f->mass + f->ia * arm_a * arm_a + f->ib * arm_b * arm_b;
	return cni_wide_select(k > cni_wide_of(0.0f), 1.0f / k, cni_wide_of(0.0f));
}

/* What the points had before. */
typedef struct write_old {
	cni_wide jn[2], load[2];
} write_old;

/* Writes one point where it is there and clears it in the other lanes that are written. Returns its arm on a along n from
   the surface; *s: its separation, 0 where it is not there. */
CNI_INLINE cni_wide write_point(const write_frame *f, cni_contact_block *k, const cni_write_lanes *w, const write_old *old, int32_t which, int32_t l,
                                cni_mask where, cni_mask used, cni_wide *s)
{
	const cni_wide zero = cni_wide_of(0.0f);
	cni_mask from0 = cni_mask_of_bits(w->from[which][0] >> l), from1 = cni_mask_of_bits(w->from[which][1] >> l);
	cni_contact_row *p = &k->p[which];
	cni_wide x, y, id, rx, ry, at, an;
	cni_wide_gather4_from(w->manifold + l, MANIFOLD_POINT + 4 * which, &x, &y, s, &id);
	x = x - f->cx;
	y = y - f->cy;
	rx = f->qc * x - f->qs * y;
	ry = f->qs * x + f->qc * y;
	rx = cni_wide_select(f->flipped, rx + f->dx, rx); /* from lane b's centre to lane a's */
	ry = cni_wide_select(f->flipped, ry + f->dy, ry);
	at = rx * f->ny - ry * f->nx;
	an = rx * f->nx + ry * f->ny - cni_wide_load(w->radius_a + l);
	*s = cni_wide_select(used, *s, zero);
	store_where(p->at + l, where, cni_wide_select(used, at, zero));
	store_where(p->an + l, where, cni_wide_select(used, an, zero));
	store_where(p->s0 + l, where, *s);
	store_where(p->nm + l, where, cni_wide_select(used, write_mass(f, at, at - f->dt), zero));
	store_where(p->jn + l, where, cni_wide_select(from0, old->jn[0], cni_wide_select(from1, old->jn[1], zero)));
	store_where(p->load + l, where, cni_wide_select(from0, old->load[0], cni_wide_select(from1, old->load[1], zero)));
	return an;
}

/* After the rows. */
CNI_INLINE void write_anchor(const write_frame *f, cni_block_anchor *anchor, int32_t l, cni_mask where, const cni_wide s[2])
{
	store_where(anchor->x.nx + l, where, f->ac * f->nx + f->as * f->ny);
	store_where(anchor->ny + l, where, f->ac * f->ny - f->as * f->nx);
	store_where(anchor->dt + l, where, f->dt);
	store_where(anchor->c + l, where, f->ac * f->bc + f->as * f->bs);
	store_where(anchor->s + l, where, f->ac * f->bs - f->as * f->bc);
	store_where(anchor->of.less[0] + l, where, s[0] - f->dn);
	store_where(anchor->of.less[1] + l, where, s[1] - f->dn);
}

CNI_INLINE void write_group(const cni_motion *motions, cni_contact_block *k, cni_block_anchor *anchor, const cni_write_lanes *w, uint32_t lanes, int32_t l)
{
	cni_mask where = cni_mask_of_bits(lanes >> l), two = cni_mask_of_bits(w->two >> l);
	cni_mask kept = cni_mask_of_bits((w->from[0][0] | w->from[0][1] | w->from[1][0] | w->from[1][1]) >> l); /* some point is what one was */
	write_frame f = write_frame_make(motions, k, w, l);
	cni_wide radius_a = cni_wide_load(w->radius_a + l), s[2], fa, second;
	write_old old;
	cni_mask was_two = cni_wide_load(k->p[1].nm + l) > cni_wide_of(0.0f);
	cni_mask turned = where & ~normal_lags(k, l, two & was_two, f.nx, f.ny, f.wa, f.wb, w->lag_sq);
	old.jn[0] = cni_wide_load(k->p[0].jn + l);
	old.jn[1] = cni_wide_load(k->p[1].jn + l);
	old.load[0] = cni_wide_load(k->p[0].load + l);
	old.load[1] = cni_wide_load(k->p[1].load + l);
	fa = write_point(&f, k, w, &old, 0, l, where, where, &s[0]) + radius_a;
	second = write_point(&f, k, w, &old, 1, l, where, two, &s[1]) + radius_a;
	fa = cni_wide_select(two, (fa + second) * 0.5f, fa);
	store_where(k->nx + l, turned, f.nx);
	store_where(k->ny + l, turned, f.ny);
	store_where(k->dn + l, where, f.dn - radius_a - cni_wide_load(w->radius_b + l));
	store_where(k->dt + l, where, f.dt);
	store_where(k->fa + l, where, fa);
	store_where(k->fb + l, where, fa - f.dn);
	store_where(k->tm + l, where, write_mass(&f, fa, fa - f.dn));
	store_where(k->jt + l, where, cni_wide_select(kept, cni_wide_load(k->jt + l), cni_wide_of(0.0f)));
	write_anchor(&f, anchor, l, where, s);
}

static void kernel_write(const cni_motion *motions, cni_contact_block *k, cni_block_anchor *anchor, const cni_write_lanes *w, uint32_t lanes)
{
	int32_t l;
	for (l = 0; l < CNI_LANES; l += CNI_WIDTH) {
		uint32_t here = lanes & ((1u << CNI_WIDTH) - 1u) << l;
		if (here != 0)
			write_group(motions, k, anchor, w, here, l);
	}
}
