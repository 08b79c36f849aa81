/*
 * stages/narrowphase_sift.h - which contacts the narrowphase has to look at: all that touch, and of the others those that
 * are not certain to stay apart.
 */
#ifndef CNI_STAGES_NARROWPHASE_SIFT_H
#define CNI_STAGES_NARROWPHASE_SIFT_H

#include "stages/narrowphase_touch.h"

/* Contacts that are sifted at a time; also how far ahead memory is asked for. */
#define CNI_SIFT_BATCH 32

/* What of a body tells how far it is: of a step. */
typedef struct cni_sift_body {
	float x, y;
	float radius;           /* of a circle around it, with what it turns; less than nothing: the body is not awake */
	float ahead_x, ahead_y; /* change of position by velocity */
} cni_sift_body;

/* A contact whose record has come. */
typedef struct cni_sift_item {
	cni_contact *contact;
	const cni_proxy *proxy[2];
} cni_sift_item;

/* Contacts to sift, of which ranges may be sifted side by side. */
typedef struct cni_sift_list {
	cn_world *world;
	const int32_t *contacts;   /* first those that do not touch */
	int32_t apart, count;
	float dt;
	cni_sift_body *bodies;     /* by record, when there is memory and so many contacts that it is worth it; else NULL */
	int32_t prefetches;
} cni_sift_list;

typedef struct cni_sift {
	cni_sift_list of;
	int32_t at, end;           /* first contact that was not sifted yet; end of the range */
	int32_t side;              /* of batch that begins there */
	cni_sift_item batch[2][CNI_SIFT_BATCH];
	cni_contact *records[CNI_SIFT_BATCH]; /* of the batch after */
} cni_sift;

/* A list of contacts, the first `apart` of which do not touch. Every open has its close; what was pushed on the frame arena in
   between must be popped by then. */
void cni_sift_open(cni_sift_list *list, cn_world *world, const int32_t *contacts, int32_t apart, int32_t count, float dt);
void cni_sift_close(cni_sift_list *list);
/* Contacts begin to end - 1 of the list. */
void cni_sift_begin(cni_sift *s, const cni_sift_list *list, int32_t begin, int32_t end);
/* Sifts one batch in the order of the list: returns how many of it have to be looked at, CNI_NONE when there is none left. */
int32_t cni_sift_batch(cni_sift *s, cni_touch_pair *out);

#endif
