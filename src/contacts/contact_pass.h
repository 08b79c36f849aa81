/*
 * contacts/contact_pass.h - interface of the contact kernels: the arguments of a pass over blocks (contact_solve.c), of a
 * restitution sweep (restitution.c) and of manifold reuse (narrowphase/manifold_reuse.c), and the table of kernels of one vector
 * width.
 */
#ifndef CNI_CONTACTS_CONTACT_PASS_H
#define CNI_CONTACTS_CONTACT_PASS_H

#include "contacts/contacts.h"

/* A pass over blocks. Without a team the blocks may belong to several colours, in order. */
typedef struct cni_color_pass {
	const cni_contact_pass *kinds; /* by CNI_CONTACTS_ */
	cni_motion *motions;
	const cni_external *externals; /* NULL: no body has settled */
	const cni_listed_block *blocks;
	int32_t prefetches;            /* 1: blocks and bodies exceed the cache */
} cni_color_pass;

/* Solves the lanes of blocks begin to end - 1. The last vector may include empty lanes. Fresh lanes iterate between normals and
   friction. */
typedef void cni_contact_kernel_fn(const cni_color_pass *c, int32_t begin, int32_t end);

/* For each of count blocks, writes as bits its lanes from begin on that have restitution, a point that closes faster than speed, and a body
   of which start.jumped is not less than since. */
typedef void cni_contact_closing_fn(const cni_velocity_start *starts, const cni_listed_block *blocks, int32_t count, float speed, float since, uint32_t *closing);

/* Lanes that may bounce, gathered from any blocks of one colour. Row r of a lane is rows[r * CNI_LANES]. */
typedef struct cni_impact_lanes {
	int32_t ia[CNI_LANES], ib[CNI_LANES];
	float restitution[CNI_LANES];
	const float *rows[CNI_LANES];             /* of cni_contact_block */
	const float *extra[CNI_LANES];            /* of cni_block_extra, where has_extra is not 0 */
	const float *a[CNI_LANES], *b[CNI_LANES]; /* records of the bodies */
	uint32_t at_world;                        /* bits of the lanes with the world as body b */
	int32_t has_extra;                        /* 0: all extra rows are zero */
} cni_impact_lanes;

/* What an impact did to each lane: impulses, and closing speeds of the points; all 0 for lanes and points that do not meet. */
typedef struct cni_impact_record {
	float jn[CNI_LANES], jt[CNI_LANES], closing[2][CNI_LANES];
} cni_impact_record;

typedef struct cni_impact_pass {
	cni_motion *motions;
	cni_velocity_start *starts;
	const cni_external *externals;
	float h;
	float speed;       /* > 0: slower approaches do not bounce */
	float jumped;      /* start.jumped of bodies that are hit: grows from sweep to sweep */
	int32_t one_sided; /* lane bodies b are not written */
	struct cni_impact_record *record; /* NULL: not wanted */
} cni_impact_pass;

/* Applies impacts to the first count lanes that meet, and returns how many did. Lanes share no body that is written. The rest of the
   last vector is read. */
typedef int32_t cni_contact_impact_fn(const cni_impact_pass *pass, const cni_impact_lanes *lanes, int32_t count);

/* Passes ask early for memory where this many bodies are awake: those of fewer, and their blocks, are in the cache anyway. */
#define CNI_PREFETCH_BODIES 16384

CNI_INLINE void cni_lines_prefetch(const void *from, int32_t bytes)
{
	for (int32_t at = 0; at < bytes; at += 64)
		CNI_PREFETCH((const char *)from + at);
}

/* Prefetches the rows of the block after the next, and the bodies of the next. */
CNI_INLINE void cni_blocks_prefetch(const cni_color_pass *c, int32_t k, int32_t end)
{
	if (k + 2 < end)
		cni_lines_prefetch(c->blocks[k + 2].rows, (int32_t)sizeof(cni_contact_block));
	if (k + 1 >= end)
		return;
	for (int32_t l = 0; l < CNI_LANES; ++l) {
		CNI_PREFETCH(&c->motions[c->blocks[k + 1].rows->ia[l]]);
		CNI_PREFETCH(&c->motions[c->blocks[k + 1].rows->ib[l]]);
	}
}

/* Pose of a body for manifold reuse, by dense index. */
typedef struct cni_reuse_pose {
	float x, y, x_low, y_low;
	float c, s;
	float extent;      /* < 0: some axis is locked, its lanes are not reused */
	float inv_inertia;
} cni_reuse_pose;

/* Parameters of manifold reuse: see contacts/manifold_reuse_kernel.h. */
typedef struct cni_reuse_pass {
	const cni_motion *motions;
	const cni_reuse_pose *poses; /* NULL: records are read instead */
	float dt;          /* of the step */
	float drift_most;  /* limit of the sliding of surfaces along each other, metres */
	float drift_most_of_faces; /* likewise of lanes with a bit in info.face, and of two circles */
	float tiny;        /* CNI_ROUND_PER_SLOP, metres */
	float hair;        /* limit of the motion of a separated pair in the step, metres */
	float apart_most;  /* limit of the separation, metres */
	float depth_most;  /* limit of the overlap, metres */
	float advance_most; /* limit of the advance of arms, metres */
	float lag_sq;      /* cni_normal_lag_sq */
} cni_reuse_pass;

/* Records of the lanes' bodies as floats, for a pass without poses. */
typedef struct cni_reuse_bodies {
	const float *a[CNI_LANES], *b[CNI_LANES];
} cni_reuse_bodies;

/* Updates lanes with an anchor, and returns bits of the lanes that remain valid. bodies NULL: poses come from the pass. */
typedef uint32_t cni_manifold_reuse_fn(const cni_reuse_pass *pass, cni_contact_block *block, const cni_block_info *info, const cni_block_anchor *anchor, const cni_reuse_bodies *bodies, uint32_t anchored);

typedef struct cni_contact_kernel {
	cni_contact_kernel_fn *pass[CNI_PASSES];
	cni_contact_closing_fn *closing;
	cni_contact_impact_fn *impact;
	cni_manifold_reuse_fn *reuse;
} cni_contact_kernel;

extern const cni_contact_kernel cni_contact_kernel_plain; /* width 1: any compiler */
extern const cni_contact_kernel cni_contact_kernel_4;     /* SSE2, NEON, WASM SIMD */
extern const cni_contact_kernel cni_contact_kernel_8;     /* AVX2, chosen at run time */

/* The widest kernel that this build and this processor support. */
const cni_contact_kernel *cni_contact_kernel_choose(void);

#endif
