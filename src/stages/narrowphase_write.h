/*
 * stages/narrowphase_write.h - writes manifolds into lanes, a block's at a time.
 */
#ifndef CNI_STAGES_NARROWPHASE_WRITE_H
#define CNI_STAGES_NARROWPHASE_WRITE_H

#include "base/bitset.h"
#include "stages/contact_pass.h"
#include "stages/narrowphase_touch.h"

/* Lanes of one block that wait to be written. */
typedef struct cni_writer {
	cn_world *world;
	cni_contact_write_fn *kernel;      /* NULL: there is none, each is written by itself */
	int32_t block;                     /* CNI_NONE: none waits */
	uint32_t lanes;                    /* as bits */
	const cni_touch *touch[CNI_LANES]; /* of each */
	int32_t opened;                    /* 1: pointers of `of` can all be read */
	cni_write_lanes of;
} cni_writer;

void cni_writer_begin(cni_writer *w, cn_world *world);
/* Writes what was found into the contact's lane, now or with others of its block: it must stay until then. */
void cni_writer_add(cni_writer *w, const cni_touch *t);
/* Writes what waits. */
void cni_writer_flush(cni_writer *w);

#endif
