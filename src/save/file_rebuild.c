/*
 * save/file_rebuild.c - what follows from the records of a file: pieces of memory (geometry, names, proxy ids), counts, the look-ahead
 * of the free contacts, and the broadphase.
 *
 * A broadphase only answers which boxes overlap, in an order that is sorted afterwards, so a new one gives the bits of the
 * written one.
 */
#include "save/file.h"

#include <stddef.h>
#include <string.h>

/* ---- geometry: a piece for each live shape, in their order ---- */

static int32_t points_are_possible(int32_t type, uint32_t count, uint32_t seams)
{
	switch (type) {
	case CN_SHAPE_CIRCLE: return CNI_HAS_CIRCLES && count == 1;
	case CN_SHAPE_CAPSULE:
	case CN_SHAPE_EDGE: return count == 2;
	case CN_SHAPE_POLYGON: return count >= 3 && count <= CN_POLYGON_MAX_VERTICES;
	case CN_SHAPE_CHAIN: return CNI_HAS_CHAINS && count <= 65535 && seams <= 1 && count >= (seams ? 3u : 2u);
	default: return 0;
	}
}

/* Words of a geometry in the file: count, seams, radius, centroid (2), extent, inner radius, points and normals. */
static uint32_t geometry_words(int32_t type, uint32_t count)
{
	return ((uint32_t)cni_geometry_bytes(type, (int32_t)count) - (uint32_t)sizeof(cni_geometry)) / 4u + 7u;
}

/* What follows count and seams. */
static void geometry_pass(cni_file *f, cni_geometry *g)
{
	static const cni_field fields[] = {
		{ offsetof(cni_geometry, radius), 1, CNI_FIELD_FLOAT }, { offsetof(cni_geometry, centroid), 2, CNI_FIELD_FLOAT },
		{ offsetof(cni_geometry, extent), 1, CNI_FIELD_FLOAT }, { offsetof(cni_geometry, inner_radius), 1, CNI_FIELD_FLOAT }
	};
	static const cni_field vector_fields[] = { { 0, 2, CNI_FIELD_FLOAT } };
	static const cni_record record = { fields, 4, (int32_t)sizeof(cni_geometry) }, vector = { vector_fields, 1, (int32_t)sizeof(cni_vec2) };
	uint32_t vectors = (geometry_words(g->type, (uint32_t)g->count) - 7u) / 2u;
	cni_file_record(f, &record, g, 5 * 4);
	for (uint32_t k = 0; k < vectors; ++k)
		cni_file_record(f, &vector, (cni_vec2 *)(void *)(g + 1) + k, 2 * 4);
}

/* Without it a body's extent would not span the shape after its mass changes. */
static int32_t extent_spans_points(const cni_geometry *g)
{
	int32_t good = 1;
	for (int32_t k = 0; k < g->count; ++k)
		good &= cni_length(cni_geometry_points(g)[k]) + g->radius <= (1.0f + 1e-5f) * g->extent;
	return good;
}

static void geometry_read(cn_world *world, cni_file *f, cni_shape *s)
{
	uint32_t count = cni_file_word(f, 0), seams = cni_file_word(f, 0);
	cni_file_need(f, points_are_possible(s->type, count, seams) && cni_file_left(f) / 4u >= geometry_words(s->type, count) - 2u, CN_ERROR_FORMAT);
	if (f->result != CN_OK)
		return;
	s->geometry = cni_blocks_alloc(&world->blocks, cni_shape_piece_bytes(world, s->type, (int32_t)count));
	if (s->geometry == 0) {
		cni_file_fail(f, CN_ERROR_MEMORY);
		return;
	}
	cni_geometry *g = (cni_geometry *)cni_blocks_at(&world->blocks, s->geometry);
	memset(g, 0, sizeof *g);
	g->type = s->type;
	g->count = (int32_t)count;
	g->seams = seams;
	geometry_pass(f, g);
	if (f->result == CN_OK)
		cni_file_need(f, g->radius >= 0.0f && g->inner_radius >= 0.0f && extent_spans_points(g), CN_ERROR_FORMAT);
	s->box.proxy = CNI_NONE;
	if (s->type == CN_SHAPE_CHAIN)
		s->box.proxies = 0;
}

static void geometry_write(const cn_world *world, cni_file *f, const cni_shape *s)
{
	cni_geometry *g = (cni_geometry *)cni_blocks_at(&world->blocks, s->geometry); /* which is only read */
	(void)cni_file_word(f, (uint32_t)g->count);
	(void)cni_file_word(f, g->seams);
	geometry_pass(f, g);
}

static void geometries_pass(cn_world *world, cni_file *f)
{
	(void)cni_file_chunk_begin(f, "GEOM", 4);
	for (int32_t k = cni_handles_next(&world->shape_handles, 0); k != CNI_NONE && f->result == CN_OK; k = cni_handles_next(&world->shape_handles, k + 1)) {
		if (f->mode == CNI_FILE_READ)
			geometry_read(world, f, cni_shape_at(world, k));
		else
			geometry_write(world, f, cni_shape_at(world, k));
	}
	cni_file_chunk_end(f, 4);
}

/* ---- materials' user ids: shape, id */

static void material_ids_write(cn_world *world, cni_file *f)
{
	(void)cni_file_chunk_begin(f, "SMAT", 8);
	for (int32_t k = cni_handles_next(&world->shape_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->shape_handles, k + 1)) {
		uint32_t id = cni_shape_material_id(&world->blocks, cni_shape_at(world, k));
		if (id == 0)
			continue;
		(void)cni_file_word(f, (uint32_t)k);
		(void)cni_file_word(f, id);
	}
	cni_file_chunk_end(f, 8);
}

static void material_ids_read(cn_world *world, cni_file *f)
{
	int32_t count = cni_file_chunk_begin(f, "SMAT", 8), k;
	for (k = 0; k < count && f->result == CN_OK; ++k) {
		uint32_t shape = cni_file_word(f, 0), id = cni_file_word(f, 0);
		if (f->result != CN_OK || !cni_handles_alive(&world->shape_handles, (int32_t)shape)) {
			cni_file_fail(f, CN_ERROR_FORMAT);
			return;
		}
		cni_shape *s = cni_shape_at(world, (int32_t)shape);
		if (!cni_shape_reserve_extra(world, s))
			cni_file_fail(f, CN_ERROR_MEMORY);
		else
			cni_shape_extra_of(&world->blocks, s)->material_id = id;
	}
}

/* ---- names: body (4), length (1), letters ---- */

static const char *name_of(const cn_world *world, int32_t body)
{
	cni_ref ref = cni_handles_alive(&world->body_handles, body) ? cni_body_at(world, body)->name : 0;
	return ref != 0 ? (const char *)cni_blocks_at(&world->blocks, ref) : NULL;
}

static void names_write(cn_world *world, cni_file *f)
{
	(void)cni_file_chunk_begin(f, "NAME", 1);
	for (int32_t k = 0; k < world->body_handles.slots.count; ++k) {
		const char *name = name_of(world, k);
		uint8_t length = 0;
		if (name == NULL)
			continue;
		while (name[length] != 0) /* at most CN_NAME_MAX_BYTES */
			++length;
		(void)cni_file_word(f, (uint32_t)k);
		cni_file_raw(f, &length, 1);
		cni_file_raw(f, (uint8_t *)(uintptr_t)name, length); /* which is only read */
	}
	cni_file_chunk_end(f, 1);
}

static void name_read(cn_world *world, cni_file *f)
{
	uint32_t body = cni_file_word(f, 0);
	uint8_t length = 0;
	char name[CN_NAME_MAX_BYTES + 1];
	cn_result named = CN_OK;
	memset(name, 0, sizeof name);
	cni_file_raw(f, &length, 1);
	if (f->result != CN_OK || !cni_handles_alive(&world->body_handles, (int32_t)body) || name_of(world, (int32_t)body) != NULL || length == 0 || length > CN_NAME_MAX_BYTES) {
		cni_file_fail(f, CN_ERROR_FORMAT);
		return;
	}
	cni_file_raw(f, (uint8_t *)name, length);
	if (f->result == CN_OK)
		named = cn_body_set_name(world, cni_handles_of(&world->body_handles, (int32_t)body), name);
	cni_file_need(f, named == CN_OK, named);
}

void cni_file_pieces(cn_world *world, cni_file *f)
{
	geometries_pass(world, f);
	if (f->mode == CNI_FILE_READ) {
		material_ids_read(world, f);
		(void)cni_file_chunk_begin(f, "NAME", 1);
		while (cni_file_left(f) > 0)
			name_read(world, f);
	} else {
		material_ids_write(world, f);
		names_write(world, f);
	}
}

/* ---- counts, and room as there was when the records were made ---- */

static void bodies_count(cn_world *world)
{
	int32_t body;
	world->awake_count = world->awake_id.count;
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->body_handles, k + 1)) {
		world->movable_count += cni_body_at(world, k)->type != CN_BODY_STATIC;
		cni_body_at(world, k)->flags &= ~(uint32_t)CNI_BODY_KICKED;
	}
	for (int32_t k = 0; k < world->kicked.count; ++k)
		if ((body = cni_handles_find(&world->body_handles, ((const cn_body *)world->kicked.data)[k])) != CNI_NONE)
			cni_body_at(world, body)->flags |= CNI_BODY_KICKED;
	for (int32_t k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE; k = cni_handles_next(&world->joint_handles, k + 1))
		world->constraint_count += cni_joint_is_constraint(cni_joint_at(world, k)->type);
}

static void pools_count(cn_world *world)
{
	for (int32_t k = 0; k < world->proxy_used; ++k)
		world->proxy_count += (cni_proxy_at(world, k)->flags & CNI_PROXY_ALIVE) != 0;
	world->proxy_free_count = world->proxy_used - world->proxy_count;
	for (int32_t k = 0; k < world->contact_used; ++k) {
		const cni_contact *c = cni_contact_at(world, k);
		world->contact_count += c->body[0] != CNI_NONE;
		world->contacts_reporting += c->body[0] != CNI_NONE && cni_contact_reports(c->flags);
		world->touching_count += c->body[0] != CNI_NONE && (c->flags & CNI_CONTACT_TOUCHING);
	}
	for (int32_t k = 0; k < world->island_used; ++k)
		world->island_count += cni_island_at(world, k)->first != CNI_NONE;
}

/* See record_take in model/contact.c: a free record has the indices of the five after it. */
static void free_contacts_link(cn_world *world)
{
	int32_t contact = world->contact_free;
	while (contact != CNI_NONE) {
		cni_contact *c = cni_contact_at(world, contact);
		int32_t *const ahead[4] = { &c->next[0], &c->next[1], &c->prev[0], &c->prev[1] }, next = c->slot;
		for (int32_t k = 0; k < 4; ++k) {
			next = next != CNI_NONE ? cni_contact_at(world, next)->slot : CNI_NONE;
			*ahead[k] = next;
		}
		contact = c->slot;
	}
}

void cni_file_counts(cn_world *world, cni_file *f)
{
	int32_t movable, good;
	if (f->mode != CNI_FILE_READ || f->result != CN_OK)
		return;
	bodies_count(world);
	pools_count(world);
	free_contacts_link(world);
	movable = world->movable_count;
	if (world->awake_count < 1 || world->awake_count > movable + 1 || world->motion.count != world->awake_count || world->start.count != world->awake_count ||
	    world->external.count != world->awake_count || world->previous.count > world->body_handles.slots.count) {
		cni_file_fail(f, CN_ERROR_FORMAT);
		return;
	}
	cni_dummy_stand(world);
	good = cni_body_reserve(world, 0) == CN_OK && cni_lane_reserve(world, world->touching_count) && cni_contact_reserve(world, 0) == CN_OK &&
	       (!world->memory.fixed || cni_contact_reserve_reports(world, world->contacts_reporting)) && cni_island_reserve(world, 0) && cni_joint_reserve(world, 0) == CN_OK;
	cni_file_need(f, good, CN_ERROR_MEMORY);
}

/* ---- boxes ---- */

/* Where the shape has the proxy of a child; NULL: it cannot have one. */
static int32_t *proxy_place(cn_world *world, cni_file *f, const cni_proxy *p)
{
	int32_t child = cni_proxy_child(p);
	if (!cni_handles_alive(&world->shape_handles, p->shape))
		return NULL;
	cni_shape *s = cni_shape_at(world, p->shape);
	if (child >= cni_shape_children(&world->blocks, s) || !cni_handles_alive(&world->body_handles, s->body))
		return NULL;
	if (s->type != CN_SHAPE_CHAIN)
		return &s->box.proxy;
	if (s->box.proxies == 0) {
		s->box.proxies = cni_blocks_alloc(&world->blocks, cni_shape_ids_bytes(world, cni_shape_children(&world->blocks, s)));
		if (s->box.proxies == 0) {
			cni_file_fail(f, CN_ERROR_MEMORY);
			return NULL;
		}
		for (int32_t k = 0; k < cni_shape_children(&world->blocks, s); ++k)
			((int32_t *)cni_blocks_at(&world->blocks, s->box.proxies))[k] = CNI_NONE;
	}
	return (int32_t *)cni_blocks_at(&world->blocks, s->box.proxies) + child;
}

static void proxy_read(cn_world *world, cni_file *f, int32_t proxy)
{
	cni_proxy *p = cni_proxy_at(world, proxy);
	if (!(p->flags & CNI_PROXY_ALIVE))
		return;
	int32_t *place = proxy_place(world, f, p);
	if (place == NULL || *place != CNI_NONE || (p->flags & CNI_PROXY_AGAIN)) {
		cni_file_fail(f, CN_ERROR_FORMAT);
		return;
	}
	*place = proxy;
	p->geometry = cni_shape_at(world, p->shape)->geometry;
}

static int32_t no_pair(const void *context, int32_t proxy_a, int32_t proxy_b)
{
	(void)context;
	(void)proxy_a;
	(void)proxy_b;
	return 0;
}

/* As after an update that saw all boxes that are at rest, with those added since that have moved. */
static void broadphase_fill(cn_world *world)
{
	const cni_broadphase_ops *ops = world->broadphase_ops;
	cni_broadphase_pairs none;
	memset(&none, 0, sizeof none);
	cni_array_init(&none.list, (int32_t)sizeof(cni_pair));
	for (int32_t moved = 0; moved < 2; ++moved) {
		for (int32_t k = 0; k < world->proxy_used; ++k) {
			cni_proxy *p = cni_proxy_at(world, k);
			cni_aabb old = p->old;
			if (!(p->flags & CNI_PROXY_ALIVE) || ((p->flags & CNI_PROXY_MOVED) != 0) != moved)
				continue;
			ops->add(world->broadphase, k);
			if (moved)
				p->old = old;
		}
		if (!moved)
			ops->update(world->broadphase, no_pair, NULL, &none); /* all of them are old boxes now */
	}
	ops->settle(world->broadphase);
	cni_array_deinit(&none.list, &world->memory);
}

void cni_file_broadphase(cn_world *world, cni_file *f)
{
	if (f->result != CN_OK || world->proxy_used == 0)
		return;
	if (cni_proxy_reserve(world, 0) != CN_OK || !world->broadphase_ops->reserve(world->broadphase, world->proxy_count))
		cni_file_fail(f, CN_ERROR_MEMORY);
	else
		broadphase_fill(world);
}

/* Files of earlier versions have contacts in any order, and not this flag. */
static void contact_set_static(cn_world *world, cni_contact *c)
{
	cni_body *a = cni_body_at(world, c->body[0]), *b = cni_body_at(world, c->body[1]);
	if ((c->flags & CNI_CONTACT_STATIC) || (a->type != CN_BODY_STATIC && b->type != CN_BODY_STATIC))
		return;
	c->flags |= CNI_CONTACT_STATIC;
	a->flags |= CNI_BODY_MIXED;
	b->flags |= CNI_BODY_MIXED;
}

int32_t cni_file_needs_extra(const cn_world *world)
{
	for (int32_t k = 0; k < world->sleep_lanes.count; ++k)
		if (cni_sleep_lane_needs_extra((const cni_sleep_lane *)world->sleep_lanes.data + k))
			return 1;
	return 0;
}

void cni_file_contacts(cn_world *world, cni_file *f)
{
	for (int32_t k = 0; k < world->contact_used && f->result == CN_OK; ++k)
		if (cni_contact_at(world, k)->body[0] != CNI_NONE)
			contact_set_static(world, cni_contact_at(world, k));
	if (f->result == CN_OK && cni_file_needs_extra(world))
		cni_file_need(f, cni_lane_reserve_extra(world), CN_ERROR_MEMORY);
}

void cni_file_boxes(cn_world *world, cni_file *f)
{
	for (int32_t k = 0; k < world->proxy_used && f->result == CN_OK; ++k)
		proxy_read(world, f, k);
}
