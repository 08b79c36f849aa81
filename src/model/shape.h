/*
 * model/shape.h - the shape record: geometry, material and filter of a part of a body, and its boxes in the broadphase.
 *
 * Geometry is a variable-size piece in the world's blocks. A shape has broadphase proxies only while it is attached to an
 * enabled body. A chain has one proxy for each edge, with a run of ids in a piece of the blocks; other shapes store their proxy
 * id directly.
 */
#ifndef CNI_MODEL_SHAPE_H
#define CNI_MODEL_SHAPE_H

#include "base/blocks.h"
#include "geometry/shape.h"
#include "broadphase/proxy.h"

typedef struct cni_shape {
	int32_t body;          /* CNI_NONE: unattached */
	int32_t next, prev;    /* in the body's list, in order of attachment; the first one's prev is the last */
	uint8_t type;          /* CN_SHAPE_CIRCLE ... */
	uint8_t event_mask;    /* 1 << CN_EVENT_ bits */
	uint8_t flags;         /* CN_SHAPE_SENSOR ... */
	uint8_t mix;           /* friction's CN_MIX_ rule, restitution's << 4 */
	cni_ref geometry;
	cni_ref extra;         /* cni_shape_extra; 0: none */
	union {
		int32_t proxy;     /* children == 1 and placed: the proxy id, else CNI_NONE */
		cni_ref proxies;   /* a chain and placed: int32_t ids[children] in the blocks, else 0 */
	} box;
	float density;
	float static_friction, dynamic_friction, restitution;
	float rolling_resistance, tangent_speed;
	int32_t group;
	uint64_t category, mask;
	uint64_t user_data;
} cni_shape;

/* What few shapes have, in a piece of the blocks. */
typedef struct cni_shape_extra {
	uint32_t material_id;  /* cn_material.user_id */
} cni_shape_extra;

static inline cni_shape_extra *cni_shape_extra_of(const cni_blocks *blocks, const cni_shape *s)
{
	return s->extra != 0 ? (cni_shape_extra *)cni_blocks_at(blocks, s->extra) : NULL;
}
/* Gives the shape its extra piece, all zero; 0: no memory. */
int32_t cni_shape_reserve_extra(cn_world *world, cni_shape *s);
static inline const cni_geometry *cni_shape_geometry(const cni_blocks *blocks, const cni_shape *s)
{
	return (const cni_geometry *)cni_blocks_at(blocks, s->geometry);
}
/* Number of its boxes: the edges of a chain, else 1. */
static inline int32_t cni_shape_children(const cni_blocks *blocks, const cni_shape *s)
{
	return !cni_is_chain(s->type) ? 1 : cni_geometry_children(cni_shape_geometry(blocks, s));
}
static inline const cni_geometry *cni_proxy_geometry(const cni_blocks *blocks, const cni_proxy *p)
{
	return (const cni_geometry *)cni_blocks_at(blocks, p->geometry);
}
/*
 * Bytes of a geometry of so many points in the blocks. In a fixed block all shapes except long chains take the same size, and so
 * do proxy ids: in any order of creation and destruction the reserved pieces fit.
 */
uint64_t cni_shape_piece_bytes(const cn_world *world, int32_t type, int32_t count);
void cni_shape_free_geometry(cn_world *world, int32_t shape);
/* In a fixed block: proxy ids of chains of at most 8 edges (longer ones take the piece of a geometry), and extra pieces: two a shape. */
#define CNI_SHAPE_IDS_BYTES 32u
/* Bytes of the piece for a chain's proxy ids. */
uint64_t cni_shape_ids_bytes(const cn_world *world, int32_t children);
/* Proxy id of a chain's edge, CNI_NONE without boxes. */
int32_t cni_shape_edge_proxy(const cn_world *world, const cni_shape *s, int32_t child);
/* ... of any shape's child. */
static inline int32_t cni_shape_proxy(const cn_world *world, const cni_shape *s, int32_t child)
{
	return !cni_is_chain(s->type) ? s->box.proxy : cni_shape_edge_proxy(world, s, child);
}

/* Reserves memory for extra more proxies. */
cn_result cni_proxy_reserve(cn_world *world, int32_t extra);
/* Creates an attached shape's boxes; CN_ERROR_MEMORY changes nothing. Already placed: CN_OK. */
cn_result cni_shape_place(cn_world *world, int32_t shape);
/* Removes the boxes and ends the contacts (after cni_contact_reserve_end). */
void cni_shape_unplace(cn_world *world, int32_t shape);
/* Replaces the geometry of a shape that is no chain, in its piece or in a new one (0: none is needed), and fits its box. */
void cni_shape_set_piece(cn_world *world, int32_t shape, cni_ref piece, const cni_geometry *g);
/* Replaces the geometry of a chain by a built piece; its contacts end (after cni_contact_reserve_end). CN_ERROR_MEMORY changes nothing. */
cn_result cni_shape_replace_chain(cn_world *world, int32_t shape, cni_ref piece);
/* Adds to or removes from the body's list, without boxes and without mass. */
void cni_shape_link(cn_world *world, int32_t shape, int32_t body);
void cni_shape_unlink(cn_world *world, int32_t shape);

/* Margin of a shape's fat box, from the type of its body and its tight box. */
float cni_box_margin(const cn_world *world, int32_t body_type, const cni_aabb *tight);
/* Notes that static shapes were added, removed, moved or changed there: the next step finds hidden corners (collision/seam.c) again. */
void cni_seams_change(cn_world *world, const cni_aabb *box);
/* All pairs of the shape's boxes count as new in the next step (filter, type or joint changed). */
void cni_shape_refilter(cn_world *world, int32_t shape);

/* Convert a material between the record and the public struct. Storing it returns 0 without memory for a user id; nothing changes. */
int32_t cni_shape_store_material(cn_world *world, cni_shape *s, const cn_material *material);
cn_material cni_shape_material(const cn_world *world, const cni_shape *s);
static inline uint32_t cni_shape_material_id(const cni_blocks *blocks, const cni_shape *s)
{
	const cni_shape_extra *extra = cni_shape_extra_of(blocks, s);
	return extra != NULL ? extra->material_id : 0;
}
/* Material of a pair of shapes: mixed by their rules, then by the user's callback if there is one. */
cn_material cni_material_mix(cn_world *world, int32_t shape_a, int32_t shape_b);

/* Do the filters allow a contact between these shapes? */
int32_t cni_filter_allows(const cni_shape *a, const cni_shape *b);

#endif
