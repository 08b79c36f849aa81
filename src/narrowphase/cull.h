/*
 * narrowphase/cull.h - which contacts the narrowphase has to look at: all that touch, and of the others those that
 * are not certain to stay apart.
 */
#ifndef CNI_NARROWPHASE_CULL_H
#define CNI_NARROWPHASE_CULL_H

#include "narrowphase/touch.h"

/* Contacts that are sifted at a time: one bit each. */
#define CNI_SIFT_BATCH 32

/* What of a body tells how far it is: of a step. */
typedef struct cni_sift_body {
	float x, y;
	float ahead_x, ahead_y; /* change of position by velocity; the four are read as one vector */
	float radius;           /* of a circle around it, with what it turns; its sign is set where the body is not awake */
} cni_sift_body;

/* Contacts to sift, of which ranges may be sifted side by side. */
typedef struct cni_sift_list {
	cn_world *world;
	const int32_t *contacts;   /* first those that do not touch */
	int32_t apart, count;
	float dt, margin;
	cni_sift_body *bodies;     /* by record, when there is memory and so many contacts that it is worth it; else NULL */
	int32_t prefetches;
} cni_sift_list;

typedef struct cni_sift {
	cni_sift_list of;
	int32_t at, end;           /* first contact that was not sifted yet; end of the range */
	int32_t batch;             /* first contact of the last batch that was sifted */
	uint32_t left;             /* which of that are to be looked at and were not handed out yet, as bits */
} cni_sift;

/* A list of contacts, the first `apart` of which do not touch. Every open has its close; what was pushed on the frame arena in
   between must be popped by then. */
void cni_sift_open(cni_sift_list *list, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt);
void cni_sift_close(cni_sift_list *list);
/* Contacts begin to end - 1 of the list. */
void cni_sift_begin(cni_sift *s, const cni_sift_list *list, int32_t begin, int32_t end);
/* The next `most` of those that have to be looked at, in the order of the list: returns how many, fewer only where there are no
   more. */
int32_t cni_sift_next(cni_sift *s, cni_touch_pair *out, int32_t most);

#endif
