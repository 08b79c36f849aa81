/*
 * contacts/contact_pass.h - what contact_solve.c, restitution.c and manifold_reuse.c hand to a kernel:
 * blocks or lanes, and the numbers of the pass.
 */
#ifndef CNI_CONTACTS_CONTACT_PASS_H
#define CNI_CONTACTS_CONTACT_PASS_H

#include "model/solve.h"

/* A pass over blocks. Without a team they may be those of several colours, in order. */
typedef struct cni_color_pass {
	const cni_contact_pass *kinds; /* by CNI_CONTACTS_ */
	cni_motion *motions;
	const cni_external *drives;   /* NULL: nothing has settled */
	const cni_listed_block *blocks;
	int32_t prefetches;        /* 1: they are not in the cache */
} cni_color_pass;

/* Works on the lanes of blocks begin to end - 1, and on those behind them up to a whole vector, which are empty. Fresh lanes
   go more than once between normals and friction. */
typedef void cni_contact_kernel_fn(const cni_color_pass *c, int32_t begin, int32_t end);

/* The passes of a kernel. */
enum { CNI_PASS_WARM, CNI_PASS_SOLVE, CNI_PASS_RELAX, CNI_PASSES };

/* Of the lanes of so many blocks those, as bits of each, that bounce and have a point that closes faster than the speed. Groups of
   lanes whose bodies have a start.jumped less than `since` may be skipped. */
typedef void cni_contact_closing_fn(const cni_velocity_start *starts, const cni_listed_block *blocks, int32_t count, float speed, float since, uint32_t *closing);

/* Lanes that may bounce, from any blocks of one colour. Row r of a lane is rows[r * CNI_LANES]. */
typedef struct cni_impact_lanes {
	int32_t ia[CNI_LANES], ib[CNI_LANES];
	float restitution[CNI_LANES];
	const float *rows[CNI_LANES];             /* of cni_contact_block */
	const float *extra[CNI_LANES];            /* of cni_block_extra, where has_extra is not 0 */
	const float *a[CNI_LANES], *b[CNI_LANES]; /* records of the bodies */
	uint32_t at_world;                        /* lanes, as bits, whose body b is the world */
	int32_t has_extra;                        /* 0: all extra rows are zero */
} cni_impact_lanes;

typedef struct cni_impact_pass {
	cni_motion *motions;
	cni_velocity_start *starts;
	const cni_external *drives;
	float h;
	float speed;       /* > 0: what closes no faster does not bounce */
	float jumped;      /* start.jumped of bodies that are hit: grows from sweep to sweep, and is less than CNI_SHOCKED */
	int32_t one_sided; /* lane bodies b are not written */
} cni_impact_pass;

/* Lets the first lanes bounce where they meet, and returns how many did. They share no body that is written; those behind
   them up to a whole vector are read. */
typedef int32_t cni_contact_impact_fn(const cni_impact_pass *pass, const cni_impact_lanes *lanes, int32_t count);

/* Passes ask early for memory where this many bodies are awake: those of fewer, and their blocks, are in the cache anyway. */
#define CNI_PREFETCH_BODIES 16384

/* Inlined by force: compilers take a function that only prefetches for one that does nothing. */
CNI_INLINE void cni_lines_prefetch(const void *from, int32_t bytes)
{
	int32_t at;
	for (at = 0; at < bytes; at += 64)
		CNI_PREFETCH((const char *)from + at);
}

/* Asks for the rows of the block after the next, and for the bodies of the next. Inlined by force: as above. */
CNI_INLINE void cni_blocks_prefetch(const cni_color_pass *c, int32_t k, int32_t end)
{
	int32_t l;
	if (k + 2 < end)
		cni_lines_prefetch(c->blocks[k + 2].rows, (int32_t)sizeof(cni_contact_block));
	if (k + 1 >= end)
		return;
	for (l = 0; l < CNI_LANES; ++l) {
		CNI_PREFETCH(&c->motions[c->blocks[k + 1].rows->ia[l]]);
		CNI_PREFETCH(&c->motions[c->blocks[k + 1].rows->ib[l]]);
	}
}

/* What following reads of a body, by its dense index. */
typedef struct cni_reuse_pose {
	float x, y, x_low, y_low;
	float c, s;
	float extent;      /* < 0: some axis is locked, its lanes are not followed */
	float inv_inertia;
} cni_reuse_pose;

/* Numbers of following: see contacts/manifold_reuse_kernel.h. */
typedef struct cni_reuse_pass {
	const cni_motion *motions;
	const cni_reuse_pose *poses; /* NULL: records are read instead */
	float dt;          /* of the step */
	float drift_most;  /* metres that surfaces may slide along each other */
	float hair;        /* ... that a pair which is apart may move in the step */
	float apart_most;  /* separation that is followed */
	float depth_most;  /* ... and overlap */
	float lag_sq;      /* cni_normal_lag_sq */
} cni_reuse_pass;

/* ... and what part of the smaller body's extent. */
#define CNI_REUSE_PART (1.0f / 256.0f)

/* Records of the lanes' bodies, as floats, where poses do not tell. */
typedef struct cni_reuse_bodies {
	const float *a[CNI_LANES], *b[CNI_LANES];
} cni_reuse_bodies;

/* Brings lanes with an anchor up to date; returns those, as bits, for which that holds good. bodies NULL: by the pass's poses. */
typedef uint32_t cni_manifold_reuse_fn(const cni_reuse_pass *pass, cni_contact_block *block, const cni_block_anchor *anchor, const cni_reuse_bodies *bodies, uint32_t anchored);

typedef struct cni_contact_kernel {
	cni_contact_kernel_fn *pass[CNI_PASSES];
	cni_contact_closing_fn *closing;
	cni_contact_impact_fn *impact;
	cni_manifold_reuse_fn *follow;
} cni_contact_kernel;

extern const cni_contact_kernel cni_contact_kernel_plain; /* width 1: any compiler */
extern const cni_contact_kernel cni_contact_kernel_4;     /* SSE2, NEON, WASM SIMD */
extern const cni_contact_kernel cni_contact_kernel_8;     /* AVX2, chosen at run time */

/* The widest that this build and this processor have. */
const cni_contact_kernel *cni_contact_kernel_choose(void);

#endif
