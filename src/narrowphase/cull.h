/*
 * narrowphase/cull.h - selects the contacts that need a manifold: all that touch, and of the others those that culling
 * cannot prove to stay apart.
 */
#ifndef CNI_NARROWPHASE_CULL_H
#define CNI_NARROWPHASE_CULL_H

#include "narrowphase/touch.h"

/* Pairs culled at once, at most the bits of a word. Small builds cull one contact after the other, from the records. */
#ifdef CN_SMALL_BLOCKS
#define CNI_CULL_BATCH 4
#define CNI_CULL_LOOKS_AHEAD 0
#else
#define CNI_CULL_BATCH 32
#define CNI_CULL_LOOKS_AHEAD 1
#endif

/* Position and reach of a body in a step. */
typedef struct cni_cull_body {
	float x, y;
	float ahead_x, ahead_y; /* change of position by velocity; the four are read as one vector */
	float radius;           /* of a circle around its centre; negative: the body is not awake */
} cni_cull_body;

/* Contacts to cull; workers may cull ranges of it in parallel. */
typedef struct cni_cull_list {
	cn_world *world;
	const int32_t *contacts;   /* first those that do not touch */
	int32_t apart, count;
	float dt, margin;
	cni_cull_body *bodies;     /* by record; NULL: too few contacts, or no memory */
	int32_t prefetches;
} cni_cull_list;

/* Places of records and proxies, by position in the range modulo this: those of the last batch, and those found ahead for prefetching. */
#define CNI_CULL_PLACES (CNI_CULL_LOOKS_AHEAD ? 2 * CNI_CULL_BATCH : CNI_CULL_BATCH)
/* ... of touching pairs found ahead. */
#define CNI_CULL_MEMBERS (CNI_CULL_LOOKS_AHEAD ? 16 : 1)

static inline cni_cull_body *cni_cull_bodies(const cni_cull_list *list) { return CNI_CULL_LOOKS_AHEAD ? list->bodies : NULL; }
static inline int32_t cni_cull_prefetches(const cni_cull_list *list) { return CNI_CULL_LOOKS_AHEAD && list->prefetches; }

typedef struct cni_cull {
	cni_cull_list of;
	int32_t begin, at, end;    /* range; next contact to cull */
	int32_t batch;             /* first contact of the last batch */
	cni_contact *record[CNI_CULL_PLACES];
	const cni_proxy *proxy[CNI_CULL_PLACES][2]; /* of contacts that do not touch */
	cni_touch_pair touching[CNI_CULL_MEMBERS];  /* ... those that do; only with of.prefetches */
	uint32_t left;             /* contacts of the batch that need a manifold and were not returned yet, as bits */
} cni_cull;

/* A list of contacts; the first `apart` do not touch. Every open needs a close; pushes on the frame arena in between must be
   popped before it. */
void cni_cull_open(cni_cull_list *list, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt);
void cni_cull_close(cni_cull_list *list);
/* Contacts begin to end - 1 of the list. */
void cni_cull_begin(cni_cull *s, const cni_cull_list *list, int32_t begin, int32_t end);
/* Writes the next contacts that need a manifold, at most `most`, in the order of the list. Returns how many; fewer than `most` only
   at the end of the range. */
int32_t cni_cull_next(cni_cull *s, cni_touch_pair *out, int32_t most);

#endif
