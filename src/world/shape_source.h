/*
 * world/shape_source.h - public geometry of a shape (cn_circle ... cn_chain), checked: what shapes are created from
 * (shape_create.c) and changed to (shape_change.c).
 */
#ifndef CNI_WORLD_SHAPE_SOURCE_H
#define CNI_WORLD_SHAPE_SOURCE_H

#include "world/error.h"

typedef struct cni_shape_source {
	int32_t type;
	int32_t count;      /* points */
	const void *given; /* cn_circle, cn_capsule, ... */
} cni_shape_source;

/* Check a geometry; the source is usable if the call has not failed. */
cni_shape_source cni_source_circle(cni_call *call, const cn_world *world, const cn_circle *circle);
cni_shape_source cni_source_capsule(cni_call *call, const cn_world *world, const cn_capsule *capsule);
cni_shape_source cni_source_edge(cni_call *call, const cn_world *world, const cn_edge *edge);
cni_shape_source cni_source_polygon(cni_call *call, const cn_world *world, const cn_polygon *polygon);
cni_shape_source cni_source_chain(cni_call *call, const cn_world *world, const cn_chain *chain);
/* Writes the stored form into memory of cni_geometry_bytes. */
void cni_source_build(cni_geometry *out, const cni_shape_source *from, cni_transform offset);

#endif
