/*
 * stages/contact_write_lanes.h - writes manifolds into lanes, a block's at a time: stages/contact_write.c.
 */
#ifndef CNI_STAGES_CONTACT_WRITE_LANES_H
#define CNI_STAGES_CONTACT_WRITE_LANES_H

#include "base/bitset.h"
#include "stages/contact_pass.h"
#include "stages/narrowphase_touch.h"

/* Lanes of one block that wait to be written. */
typedef struct cni_writer {
	cn_world *world;
	const cni_contact_kernel *kernel;
	int32_t block;                    /* CNI_NONE: none waits */
	int32_t extra;                    /* it has rows that the kernel does not write */
	uint32_t lanes;                   /* as bits */
	cni_write_lanes of;
} cni_writer;

void cni_writer_begin(cni_writer *w, cn_world *world);
/* Writes what was found into the contact's lane, now or with others of its block: what it points to must stay until then. */
void cni_writer_add(cni_writer *w, const cni_touch *t);
/* Writes what waits. */
void cni_writer_flush(cni_writer *w);

#endif
