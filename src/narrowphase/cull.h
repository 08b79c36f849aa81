/*
 * narrowphase/cull.h - which contacts the narrowphase has to look at: all that touch, and of the others those that
 * are not certain to stay apart.
 */
#ifndef CNI_NARROWPHASE_CULL_H
#define CNI_NARROWPHASE_CULL_H

#include "narrowphase/touch.h"

/* Contacts that are culled at a time: one bit each. */
#define CNI_CULL_BATCH 32

/* What of a body tells how far it is: of a step. */
typedef struct cni_cull_body {
	float x, y;
	float ahead_x, ahead_y; /* change of position by velocity; the four are read as one vector */
	float radius;           /* of a circle around it, with what it turns; its sign is set where the body is not awake */
} cni_cull_body;

/* Contacts to cull, of which ranges may be culled side by side. */
typedef struct cni_cull_list {
	cn_world *world;
	const int32_t *contacts;   /* first those that do not touch */
	int32_t apart, count;
	float dt, margin;
	cni_cull_body *bodies;     /* by record, when there is memory and so many contacts that it is worth it; else NULL */
	int32_t prefetches;
} cni_cull_list;

typedef struct cni_cull {
	cni_cull_list of;
	int32_t at, end;           /* first contact that was not culled yet; end of the range */
	int32_t batch;             /* first contact of the last batch that was culled */
	uint32_t left;             /* which of that are to be looked at and were not handed out yet, as bits */
} cni_cull;

/* A list of contacts, the first `apart` of which do not touch. Every open has its close; what was pushed on the frame arena in
   between must be popped by then. */
void cni_cull_open(cni_cull_list *list, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt);
void cni_cull_close(cni_cull_list *list);
/* Contacts begin to end - 1 of the list. */
void cni_cull_begin(cni_cull *s, const cni_cull_list *list, int32_t begin, int32_t end);
/* The next `most` of those that have to be looked at, in the order of the list: returns how many, fewer only where there are no
   more. */
int32_t cni_cull_next(cni_cull *s, cni_touch_pair *out, int32_t most);

#endif
