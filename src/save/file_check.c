/*
 * save/file_check.c - is what was read from a file a world? Indices are in range already (file_fields.c); here records, free lists,
 * contacts and lanes must be as the step reads them without a check. cn_world_validate, which trusts that, checks the rest afterwards:
 * lists, bodies, joints.
 */
#include "world/error.h"
#include "save/file.h"

/* ---- handles ---- */

static int32_t aliases_hold(const cni_handles *h)
{
	const cni_alias *by_index = (const cni_alias *)h->aliases.data, *by_slot = (const cni_alias *)h->by_slot.data;
	if (h->aliases.count != h->by_slot.count)
		return 0;
	for (int32_t k = 0; k < h->aliases.count; ++k) {
		if (by_index[k].index <= 0 || by_index[k].index > CN_MAX_HANDLES || by_index[k].slot >= h->slots.count || by_slot[k].slot >= h->slots.count ||
		    by_slot[k].index <= 0 || by_slot[k].index > CN_MAX_HANDLES)
			return 0;
		if (k > 0 && (by_index[k].index <= by_index[k - 1].index || by_slot[k].slot <= by_slot[k - 1].slot))
			return 0;
	}
	for (int32_t k = 0; k < h->aliases.count; ++k) /* a search in the other list, which is in order */
		if (cni_handles_alias_of(h, by_index[k].slot) != by_index[k].index)
			return 0;
	return 1;
}

/* Slot words: base/handles.h. */
static int32_t free_slots_hold(const cni_handles *h)
{
	const uint32_t *slots = (const uint32_t *)h->slots.data;
	int32_t slot = h->free_first, last = CNI_NONE, left = h->slots.count - h->count, worn = 0;
	for (; slot != CNI_NONE; slot = (int32_t)(slots[slot] & 0x1FFFFFu) - 1) {
		if (slot < 0 || slot >= h->slots.count || (slots[slot] >> 21 & 1u) != 0 || left-- <= 0)
			return 0;
		worn += slots[slot] >> 22 == 0;
		last = slot;
	}
	return left == 0 && last == h->free_last && worn == h->worn;
}

int32_t cni_file_handles_hold(const cni_handles *h)
{
	const uint32_t *slots = (const uint32_t *)h->slots.data;
	int32_t alive = 0;
	if (h->slots.count > CN_MAX_HANDLES || h->alias_next > CN_MAX_HANDLES + 1 || !aliases_hold(h))
		return 0;
	for (int32_t k = 0; k < h->slots.count; ++k) {
		if (!(slots[k] >> 21 & 1u))
			continue;
		++alive;
		if (slots[k] >> 22 == 0 || (int32_t)(slots[k] & 0x1FFFFFu) != cni_handles_alias_of(h, k))
			return 0;
	}
	return alive == h->count && free_slots_hold(h);
}

/* ---- numbers that no field's kind bounds ---- */

static int32_t body_alive(const cn_world *world, int32_t body) { return cni_handles_alive(&world->body_handles, body); }

static int32_t world_numbers_hold(const cn_world *world)
{
	/* The step numbers islands anew with step_count + 1, which must not come round to 0. */
	return world->step_count < 0xF0000000u && world->masses_estimated <= CNI_ESTIMATED_MOST && (world->pairs_may_repeat & ~(CNI_PAIRS_ALL | CNI_PAIRS_CROWDED | CNI_PAIRS_CROWDED_FIXED)) == 0 && world->fixed_step > 0.0f && world->fixed_step <= 1.0f && world->time_owed >= 0.0f &&
	       world->time_owed <= 16.0f && world->steps_max >= 1 && world->steps_max <= 1000 && world->step_dt >= 0.0f && world->mean_dt >= 0.0f && world->longest_dt >= 0.0f;
}

static int32_t body_numbers_hold(const cni_body *b)
{
	float length_sq = b->q.c * b->q.c + b->q.s * b->q.s;
	return b->type <= CN_BODY_DYNAMIC && !(b->flags & CNI_BODY_MARK) && length_sq > 0.9f && length_sq < 1.1f && b->extent >= 0.0f && b->core >= 0.0f &&
	       b->inertia >= 0.0f && (b->type == CN_BODY_DYNAMIC ? b->mass > 0.0f : b->mass == 0.0f);
}

static int32_t shape_numbers_hold(const cni_shape *s)
{
	return (s->event_mask & ~CNI_EVENT_MASK) == 0 && (CNI_HAS_EVENTS || (s->flags & ~CNI_SHAPE_FLAGS) == 0) && (CNI_HAS_RESTITUTION || s->restitution == 0.0f) && (s->mix & 15) <= CN_MIX_MAXIMUM && s->mix >> 4 <= CN_MIX_MAXIMUM && s->static_friction >= 0.0f &&
	       s->dynamic_friction >= 0.0f && s->restitution >= 0.0f && s->restitution <= 1.0f && s->rolling_resistance >= 0.0f && s->density >= 0.0f;
}

static int32_t joint_numbers_hold(const cni_joint *j)
{
	return j->type < CNI_JOINT_TYPES && j->solver <= CN_SOLVER_DIRECT && j->linked <= 1 && j->apart <= 1 && j->trust.soft <= 1 && j->trust.direct <= 1 && (j->awake == CNI_NONE || j->awake >= 0);
}

static int32_t records_hold(const cn_world *world)
{
	int32_t good = world_numbers_hold(world);
	for (int32_t k = cni_handles_next(&world->body_handles, 0); k != CNI_NONE && good; k = cni_handles_next(&world->body_handles, k + 1))
		good = body_numbers_hold(cni_body_at(world, k));
	for (int32_t k = cni_handles_next(&world->shape_handles, 0); k != CNI_NONE && good; k = cni_handles_next(&world->shape_handles, k + 1))
		good = shape_numbers_hold(cni_shape_at(world, k));
	for (int32_t k = cni_handles_next(&world->joint_handles, 0); k != CNI_NONE && good; k = cni_handles_next(&world->joint_handles, k + 1))
		good = joint_numbers_hold(cni_joint_at(world, k));
	return good;
}

/* ---- islands ---- */

/* Islands that are solved directly are listed, each once: those that claim to be are as many as the list, and none claims it twice. */
static int32_t direct_list_holds(const cn_world *world)
{
	const int32_t *list = (const int32_t *)world->direct_islands.data;
	int32_t good = 1;
	for (int32_t k = 0; k < world->direct_islands.count && good; ++k) {
		good = list[k] != CNI_NONE && cni_island_at(world, list[k])->number == 0;
		if (good)
			cni_island_at(world, list[k])->number = 1; /* scratch of a step: 0 between steps of a read world */
	}
	for (int32_t k = 0; k < world->island_used; ++k)
		cni_island_at(world, k)->number = 0;
	return good;
}

static int32_t islands_hold(const cn_world *world)
{
	int32_t free_records = 0;
	for (int32_t k = world->island_free; k != CNI_NONE; k = cni_island_at(world, k)->next_free)
		++free_records;
	return free_records == world->island_used - world->island_count && direct_list_holds(world);
}

/* ---- contacts ---- */

static int32_t contact_is_live(const cn_world *world, int32_t contact)
{
	return contact >= 0 && contact < world->contact_used && cni_contact_at(world, contact)->body[0] != CNI_NONE;
}

/* Its shapes may collide, in this order. */
static int32_t contact_pair_holds(const cn_world *world, const cni_contact *c)
{
	const cni_shape *shapes[2];
	int32_t dynamic = 0;
	for (int32_t side = 0; side < 2; ++side) {
		if (c->proxy[side] == CNI_NONE || !body_alive(world, c->body[side]))
			return 0;
		const cni_proxy *p = cni_proxy_at(world, c->proxy[side]);
		if (!(p->flags & CNI_PROXY_ALIVE) || cni_shape_at(world, p->shape)->body != c->body[side])
			return 0;
		shapes[side] = cni_shape_at(world, p->shape);
		dynamic |= cni_body_at(world, c->body[side])->type == CN_BODY_DYNAMIC;
	}
	return c->body[0] != c->body[1] && shapes[0]->type <= shapes[1]->type && cni_manifold_function(shapes[0]->type, shapes[1]->type) != NULL &&
	       (dynamic || (c->flags & CNI_CONTACT_SENSOR));
}

static int32_t box_is_full(const cni_aabb *box) { return box->x0 <= box->x1 && box->y0 <= box->y1; }
static const cni_aabb *old_box(const cni_proxy *p) { return p->flags & CNI_PROXY_MOVED ? &p->old : &p->fat; }

/* May the next update find the pair again? Such bodies are asleep or marked: narrowphase/pairs.c. */
static int32_t contact_boxes_hold(const cn_world *world, const cni_contact *c)
{
	const cni_aabb *one = old_box(cni_proxy_at(world, c->proxy[0])), *other = old_box(cni_proxy_at(world, c->proxy[1]));
	if ((world->pairs_may_repeat & CNI_PAIRS_ALL) == CNI_PAIRS_ALL || (box_is_full(one) && box_is_full(other) && cni_aabb_overlap(one, other)))
		return 1;
	for (int32_t side = 0; side < 2; ++side) {
		const cni_body *b = cni_body_at(world, c->body[side]);
		if ((b->awake == 0 && b->type != CN_BODY_STATIC) || (world->pairs_may_repeat && (b->flags & CNI_BODY_AGAIN)))
			return 1;
	}
	return 0;
}

/* cn_world_validate compares contacts that are apart or asleep with their places. */
static int32_t contact_place_holds(const cn_world *world, int32_t contact)
{
	const cni_contact *c = cni_contact_at(world, contact);
	if (!(c->flags & CNI_CONTACT_TOUCHING))
		return !(c->flags & CNI_CONTACT_ASLEEP);
	if (c->slot < 0 || (c->flags & CNI_CONTACT_SENSOR))
		return 0;
	if (!CNI_SLEEP_IN_BLOCKS && (c->flags & CNI_CONTACT_ASLEEP))
		return 1;
	return c->slot / CNI_LANES < world->block_used && cni_block_info_at(world, c->slot / CNI_LANES)->color != CNI_NONE &&
	       cni_block_info_at(world, c->slot / CNI_LANES)->contact[c->slot % CNI_LANES] == contact;
}

static int32_t contacts_hold(const cn_world *world)
{
	int32_t free_records = 0;
	for (int32_t k = 0; k < world->contact_used; ++k)
		if (contact_is_live(world, k) && (!contact_pair_holds(world, cni_contact_at(world, k)) || !contact_boxes_hold(world, cni_contact_at(world, k)) || !contact_place_holds(world, k)))
			return 0;
	for (int32_t k = 0; k < world->apart.count; ++k) {
		int32_t contact = ((const int32_t *)world->apart.data)[k];
		if (!contact_is_live(world, contact) || cni_contact_at(world, contact)->slot != k || (cni_contact_at(world, contact)->flags & CNI_CONTACT_TOUCHING))
			return 0;
	}
	for (int32_t k = world->contact_free; k != CNI_NONE; k = cni_contact_at(world, k)->slot)
		++free_records;
	return free_records == world->contact_used - world->contact_count;
}

/* ---- lanes ---- */

/* A lane in use: its contact has it, and an anchor names the body that is not awake. The lane of a contact that sleeps has neither.
   cn_world_validate compares the bodies of others. */
static int32_t lane_holds(const cn_world *world, int32_t block, int32_t lane)
{
	const cni_block_info *info = cni_block_info_at(world, block);
	const cni_contact_block *rows = cni_block_at(world, block);
	int32_t contact = info->contact[lane], flipped;
	if (!contact_is_live(world, contact))
		return 0;
	const cni_contact *c = cni_contact_at(world, contact);
	flipped = (c->flags & CNI_CONTACT_FLIPPED) != 0;
	if (c->slot != block * CNI_LANES + lane || !(c->flags & CNI_CONTACT_TOUCHING) || ((c->flags & CNI_CONTACT_ASLEEP) != 0) != (info->color == CNI_COLOR_ASLEEP))
		return 0;
	if (c->flags & CNI_CONTACT_ASLEEP)
		return rows->ia[lane] == 0 && rows->ib[lane] == 0 && !(info->anchored >> lane & 1u);
	return rows->ib[lane] != 0 || !(info->anchored >> lane & 1u) || cni_block_anchor_at(world, block)->x.body[lane] == c->body[1 - flipped];
}

/* All its rows are zero: passes over blocks compute it, too, and look for no contact of it. */
static int32_t lane_is_empty(const cn_world *world, int32_t block, int32_t lane)
{
	const cni_block_info *info = cni_block_info_at(world, block);
	const float *rows = (const float *)(const void *)cni_block_at(world, block);
	for (int32_t row = 0; row < CNI_ROWS_OF(cni_contact_block); ++row)
		if (!(rows[row * CNI_LANES + lane] == 0.0f))
			return 0;
	return info->contact[lane] == CNI_NONE && !(info->anchored >> lane & 1u);
}

/* Blocks of a colour; CNI_NONE: they are not as its lanes want. */
static int32_t blocks_of_color(const cn_world *world, int32_t color)
{
	const cni_color *group = &world->colors[color];
	int32_t block = group->first, before = CNI_NONE, count = 0, lanes = group->lanes;
	for (; block != CNI_NONE; block = cni_block_info_at(world, block)->next) {
		const cni_block_info *info = cni_block_info_at(world, block);
		if (info->color != color || info->prev != before || lanes <= 0)
			return CNI_NONE;
		for (int32_t lane = 0; lane < CNI_LANES; ++lane)
			if (lane < lanes ? !lane_holds(world, block, lane) : !lane_is_empty(world, block, lane))
				return CNI_NONE;
		lanes -= cni_min_i(lanes, CNI_LANES);
		before = block;
		++count;
	}
	return lanes == 0 && group->last == before ? count : CNI_NONE;
}

static int32_t extra_rows_hold(const cn_world *world)
{
	for (int32_t k = 0; k < world->block_used; ++k)
		if (cni_block_info_at(world, k)->color != CNI_NONE && (cni_block_info_at(world, k)->flags & CNI_BLOCK_EXTRA) && cni_block_extra_at(world, k) == NULL)
			return 0;
	return 1;
}

static int32_t blocks_hold(const cn_world *world)
{
	int32_t used = 0, free_blocks = 0;
	for (int32_t color = 0; color < CNI_COLOR_LISTS; ++color) {
		int32_t count = blocks_of_color(world, color);
		if (count == CNI_NONE)
			return 0;
		used += count;
	}
	for (int32_t k = world->block_free; k != CNI_NONE; k = cni_block_info_at(world, k)->next)
		++free_blocks;
	return used + free_blocks == world->block_used && extra_rows_hold(world);
}

/* ---- events ---- */

/* Events have a contact. Of hits users read as many points as they say. */
static int32_t event_holds(const cni_array *log, int32_t kind, int32_t k)
{
	const cn_contact_event *hits = (const cn_contact_event *)log->data;
	if (kind == CN_EVENT_HIT)
		return hits[k].kind == CN_EVENT_HIT && hits[k].manifold.point_count >= 0 && hits[k].manifold.point_count <= 2;
	return (kind == CN_EVENT_STAY ? ((const cni_event_stay *)log->data)[k].contact : ((const cni_event *)log->data)[k].contact) != CNI_NONE;
}

static int32_t log_holds(const cni_array *log, int32_t kind)
{
	for (int32_t k = 0; k < log->count; ++k)
		if (!event_holds(log, kind, k))
			return 0;
	return 1;
}

/* Only in steps contacts stay and hit. */
static int32_t events_hold(const cn_world *world)
{
	for (int32_t kind = 0; kind < CN_EVENT_KINDS; ++kind) {
		const cni_array *pending = &world->events.pending[kind];
		if (!log_holds(&world->events.log[kind], kind) || !(kind == CN_EVENT_STAY || kind == CN_EVENT_HIT ? pending->count == 0 : log_holds(pending, kind)))
			return 0;
	}
	return 1;
}

static int32_t area_holds(const cn_world *world, const cni_area *a)
{
	if (a->shape < 0 || !cni_handles_alive(&world->shape_handles, a->shape))
		return 0;
	const cni_shape *s = cni_shape_at(world, a->shape);
	return s->type != CN_SHAPE_EDGE && s->type != CN_SHAPE_CHAIN && (a->def.flags & ~CNI_AREA_FLAGS) == 0 && a->def.pull_distance_m >= 0.0f && a->def.linear_damping_per_s >= 0.0f &&
	       a->def.angular_damping_per_s >= 0.0f && a->def.density_kgpm2 >= 0.0f && a->def.drag_kgpm2 >= 0.0f && a->def.lift_kgpm2 >= 0.0f;
}

/* A shape with two areas of different priorities would do no harm. */
static int32_t areas_hold(const cn_world *world)
{
	const cni_area *areas = cni_areas(world);
	for (int32_t k = 0; k < world->areas.count; ++k)
		if (!area_holds(world, areas + k) || (k > 0 && !cni_area_is_before(areas + k - 1, areas + k)))
			return 0;
	return 1;
}

int32_t cni_file_world_holds(const cn_world *world)
{
	return areas_hold(world) && records_hold(world) && cni_awake_ids(world)[0] == CNI_NONE && islands_hold(world) && contacts_hold(world) &&
	       blocks_hold(world) && events_hold(world);
}
