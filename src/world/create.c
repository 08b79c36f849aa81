/*
 * world/create.c - creates and destroys worlds: definitions, memory, capacities.
 *
 * Memory hooks allocate the world's struct and everything in it. In a caller's block the struct is at the
 * beginning, and the rest serves all allocations; all capacities are then reserved at creation, so that a
 * world within its capacities allocates nothing later.
 */
#include "direct/direct.h"
#include "contacts/contacts.h"
#include "joints/joint_pass.h"
#include "linear/sparse.h"
#include "step/step.h"
#include "world/error.h"

#include <string.h>

void cn_world_def_init(cn_world_def *def)
{
	if (!cni_def_begin(def, sizeof *def))
		return;
	def->flags = CNI_WORLD_FLAGS & ~(uint32_t)CN_WORLD_PROFILE;
	def->gravity_mps2.y = -10.0f;
	def->length_unit_m = 1.0f;
	def->substep_count = 4;
	def->accuracy_m = def->restitution_threshold_mps = def->push_speed_max_mps = def->linear_speed_max_mps = CN_DEFAULT;
	def->angular_speed_max_radps = 400.0f;
	def->sleep_speed_mps = def->hit_speed_mps = CN_DEFAULT;
	def->sleep_delay_s = 0.5f;
	def->worker_count = 1;
	def->work_budget = def->touching_capacity = def->event_capacity = CN_DEFAULT;
	def->vertex_capacity = CN_POLYGON_MAX_VERTICES;
	def->reserve = CNI_RESERVE_ALL;
}

/* ---- checking ---- */

static void def_check_memory(cni_call *call, const cn_world_def *d)
{
	const int32_t most = CN_MAX_HANDLES;
	cni_check_range_int(call, "body_capacity", d->body_capacity, 0, most);
	cni_check_range_int(call, "shape_capacity", d->shape_capacity, 0, most);
	cni_check_range_int(call, "contact_capacity", d->contact_capacity, 0, 16 * most);
	cni_check_range_int(call, "joint_capacity", d->joint_capacity, 0, most);
	cni_check_range_int(call, "touching_capacity", d->touching_capacity, CN_DEFAULT, 16 * most);
	cni_check_range_int(call, "event_capacity", d->event_capacity, CN_DEFAULT, 16 * most);
	cni_check_range_int(call, "vertex_capacity", d->vertex_capacity, 3, CN_POLYGON_MAX_VERTICES);
	cni_check_flags(call, "reserve", d->reserve, CNI_RESERVE_ALL);
	cni_check(call, (d->alloc == NULL) == (d->free == NULL), CN_ERROR_ARGUMENT, "alloc and free; must both be set or both be NULL");
	cni_check(call, (d->enqueue == NULL) == (d->finish == NULL), CN_ERROR_ARGUMENT, "enqueue and finish; must both be set or both be NULL");
	cni_check(call, ((uintptr_t)d->memory & (CNI_MEMORY_ALIGN - 1u)) == 0, CN_ERROR_ARGUMENT, "memory; must be aligned to 64 bytes");
}

static void def_check(cni_call *call, const cn_world_def *d)
{
	if (!cni_check_def(call, d, sizeof *d, "cn_world_def_init"))
		return;
	cni_check_flags(call, "flags", d->flags, CNI_WORLD_FLAGS);
	cni_check_finite2(call, "gravity_mps2", d->gravity_mps2);
	cni_check_range(call, "length_unit_m", d->length_unit_m, 1e-6f, 1e6f);
	cni_check_solver(call, d->solver, CN_SOLVER_SEQUENTIAL);
	cni_check_range_int(call, "broadphase", d->broadphase, CN_BROADPHASE_SWEEP, CN_BROADPHASE_TREE);
	cni_check_range_int(call, "substep_count", d->substep_count, 1, 64);
	cni_check_at_least_or_default(call, "accuracy_m", d->accuracy_m);
	cni_check_work_budget(call, d->work_budget);
	cni_check_at_least_or_default(call, "restitution_threshold_mps", d->restitution_threshold_mps);
	cni_check_positive_or_default(call, "push_speed_max_mps", d->push_speed_max_mps);
	cni_check_positive_or_default(call, "linear_speed_max_mps", d->linear_speed_max_mps);
	cni_check_positive(call, "angular_speed_max_radps", d->angular_speed_max_radps);
	cni_check_at_least_or_default(call, "sleep_speed_mps", d->sleep_speed_mps);
	cni_check_at_least(call, "sleep_delay_s", d->sleep_delay_s, 0.0f);
	cni_check_at_least_or_default(call, "hit_speed_mps", d->hit_speed_mps);
	cni_check_range_int(call, "worker_count", d->worker_count, 1, CN_WORKERS_MAX);
	def_check_memory(call, d);
}

cn_result cn_world_def_check(const cn_world_def *def, char *text, int32_t text_bytes)
{
	char sentence[CNI_ERROR_TEXT_BYTES] = "";
	cni_call call = cni_enter_free();
	if (text_bytes < 0 || (text == NULL && text_bytes > 0))
		return CN_ERROR_ARGUMENT;
	call.function = "cn_world_def_check";
	call.sentence = sentence;
	def_check(&call, def);
	cni_text out = cni_text_begin(text, text_bytes);
	cni_text_string(&out, sentence);
	return call.result;
}

/* ---- settings ---- */

static float or_default(float value, float by_default)
{
	return value == (float)CN_DEFAULT ? by_default : value;
}

static void settings_resolve(cni_settings *set, const cn_world_def *d)
{
	float unit = d->length_unit_m;
	set->gravity = d->gravity_mps2;
	set->length_unit = unit;
	set->solver = d->solver;
	set->broadphase = d->broadphase;
	set->substeps = d->substep_count;
	set->flags = d->flags;
	set->restitution_threshold = or_default(d->restitution_threshold_mps, unit);
	set->push_speed_max = or_default(d->push_speed_max_mps, 3.0f * unit);
	set->linear_speed_max = or_default(d->linear_speed_max_mps, 400.0f * unit);
	set->angular_speed_max = d->angular_speed_max_radps;
	set->sleep_speed = or_default(d->sleep_speed_mps, 0.05f * unit);
	set->sleep_delay = d->sleep_delay_s;
	set->hit_speed = or_default(d->hit_speed_mps, unit);
	set->slop = 0.005f * unit;
	set->thickness_least = CNI_THICKNESS_LEAST * unit;
	set->accuracy = or_default(d->accuracy_m, set->slop);
	set->work_budget = d->work_budget == CN_DEFAULT ? 0 : d->work_budget;
	set->contact_margin = 4.0f * set->slop;
	set->box_margin = 0.1f * unit;
}

/* ---- tables ---- */

/* How many items a world of given capacities has room for. */
enum {
	ROOM_NONE, /* on demand, or in the arena */
	ROOM_BODIES,
	ROOM_SHAPES,
	ROOM_JOINTS,
	ROOM_CONTACTS,
	ROOM_DENSE,  /* awake bodies and the dummy */
	ROOM_ISLANDS,
	ROOM_BLOCKS, /* of contacts in any colours: cni_lane_reserve */
	ROOM_JOINT_BLOCKS,
	/* In a fixed block only; growing worlds make these on demand. */
	ROOM_KICKED,
	ROOM_MOVED,
	ROOM_PAIRS,
	ROOM_SLEEP_LANES,
	ROOM_DIRECT_ISLANDS,
	ROOM_PLAN,
	ROOM_EVENTS,
	ROOM_JOINT_EVENTS,
	ROOM_MOVED_EVENTS,
	ROOMS
};

/* Tables and arrays of the world: where they are, the size of an item, and their room. */
typedef struct table_of_world {
	uint16_t offset, item_bytes, page_shift, room;
} table_of_world;

typedef struct array_of_world {
	uint16_t offset, item_bytes, room;
} array_of_world;

#define TABLE(member, item, page_shift, room) { offsetof(cn_world, member), sizeof(item), page_shift, room }
static const table_of_world world_tables[] = {
	TABLE(bodies, cni_body, CNI_PAGE_BODIES, ROOM_BODIES),
	TABLE(readback, cn_body_moved, CNI_PAGE_READBACK, ROOM_MOVED),
	TABLE(shapes, cni_shape, CNI_PAGE_SHAPES, ROOM_SHAPES),
	TABLE(proxies, cni_proxy, CNI_PAGE_PROXIES, ROOM_SHAPES),
	TABLE(contacts, cni_contact, CNI_PAGE_CONTACTS, ROOM_CONTACTS),
	TABLE(blocks_hot, cni_contact_block, CNI_PAGE_BLOCKS, ROOM_BLOCKS),
	TABLE(blocks_info, cni_block_info, CNI_PAGE_BLOCKS, ROOM_BLOCKS),
	TABLE(blocks_anchor, cni_block_anchor, CNI_PAGE_BLOCKS, ROOM_BLOCKS),
	TABLE(blocks_extra, cni_block_extra, CNI_PAGE_BLOCKS, ROOM_NONE),
	TABLE(joints, cni_joint, CNI_PAGE_JOINTS, ROOM_JOINTS),
	TABLE(islands, cni_island, CNI_PAGE_ISLANDS, ROOM_ISLANDS),
};

#define ARRAY(member, item_bytes, room) { offsetof(cn_world, member), item_bytes, room }
static const array_of_world world_arrays[] = {
	ARRAY(motion, sizeof(cni_motion), ROOM_DENSE),
	ARRAY(start, sizeof(cni_velocity_start), ROOM_DENSE),
	ARRAY(external, sizeof(cni_external), ROOM_DENSE),
	ARRAY(awake_id, sizeof(int32_t), ROOM_DENSE),
	ARRAY(kicked, sizeof(cn_body), ROOM_KICKED),
	ARRAY(previous, sizeof(cni_previous), ROOM_MOVED),
	ARRAY(apart, sizeof(int32_t), ROOM_CONTACTS),
	ARRAY(awake_joints, sizeof(int32_t), ROOM_JOINTS),
	ARRAY(direct_islands, sizeof(int32_t), ROOM_DIRECT_ISLANDS),
	ARRAY(direct_plans[0], CNI_KEPT_BYTES, ROOM_PLAN),
	ARRAY(direct_plans[1], CNI_KEPT_BYTES, ROOM_NONE),
	ARRAY(joint_work, CNI_JOINT_CONSTRAINT_BYTES, ROOM_JOINTS),
	ARRAY(block_list, sizeof(cni_listed_block), ROOM_BLOCKS),
	ARRAY(joint_blocks, sizeof(cni_joint_block), ROOM_JOINT_BLOCKS),
	ARRAY(sleep_lanes, sizeof(cni_sleep_lane), ROOM_SLEEP_LANES),
	ARRAY(pairs.list, sizeof(cni_pair), ROOM_PAIRS),
	ARRAY(areas, sizeof(cni_area), ROOM_NONE),
	ARRAY(events.log[CN_EVENT_ENTER], sizeof(cni_event), ROOM_EVENTS), ARRAY(events.pending[CN_EVENT_ENTER], sizeof(cni_event), ROOM_NONE),
	ARRAY(events.log[CN_EVENT_LEAVE], sizeof(cni_event), ROOM_EVENTS), ARRAY(events.pending[CN_EVENT_LEAVE], sizeof(cni_event), ROOM_EVENTS),
	ARRAY(events.log[CN_EVENT_STAY], sizeof(cni_event_stay), ROOM_EVENTS), ARRAY(events.pending[CN_EVENT_STAY], sizeof(cni_event), ROOM_NONE),
	ARRAY(events.log[CN_EVENT_CREATED], sizeof(cni_event), ROOM_EVENTS), ARRAY(events.pending[CN_EVENT_CREATED], sizeof(cni_event), ROOM_NONE),
	ARRAY(events.log[CN_EVENT_DESTROYED], sizeof(cni_event), ROOM_EVENTS), ARRAY(events.pending[CN_EVENT_DESTROYED], sizeof(cni_event), ROOM_EVENTS),
	ARRAY(events.log[CN_EVENT_HIT], sizeof(cn_contact_event), ROOM_EVENTS), ARRAY(events.pending[CN_EVENT_HIT], sizeof(cni_event), ROOM_NONE),
	ARRAY(events.seen[0], sizeof(cn_contact_event), ROOM_NONE), ARRAY(events.seen[1], sizeof(cn_contact_event), ROOM_NONE),
	ARRAY(events.seen[2], sizeof(cn_contact_event), ROOM_NONE), ARRAY(events.seen[3], sizeof(cn_contact_event), ROOM_NONE),
	ARRAY(events.seen[4], sizeof(cn_contact_event), ROOM_NONE), ARRAY(events.seen[5], sizeof(cn_contact_event), ROOM_NONE),
	ARRAY(events.sensor_log, sizeof(cn_sensor_event), ROOM_EVENTS), ARRAY(events.sensor_pending, sizeof(cn_sensor_event), ROOM_EVENTS),
	ARRAY(events.joint_log, sizeof(cn_joint_event), ROOM_JOINT_EVENTS), ARRAY(events.joint_pending, sizeof(cn_joint_event), ROOM_JOINT_EVENTS),
	ARRAY(events.moved, sizeof(cn_body_moved), ROOM_MOVED_EVENTS), ARRAY(events.asleep, sizeof(cn_body), ROOM_KICKED),
};

#define COUNT_OF(list) ((int32_t)(sizeof(list) / sizeof((list)[0])))

static cni_table *table_at(cn_world *world, int32_t k) { return (cni_table *)(void *)((uint8_t *)world + world_tables[k].offset); }
static cni_array *array_at(cn_world *world, int32_t k) { return (cni_array *)(void *)((uint8_t *)world + world_arrays[k].offset); }

static void tables_init(cn_world *world)
{
	cni_arena_init(&world->arena, &world->memory);
	cni_blocks_init(&world->blocks, &world->memory);
	cni_handles_init(&world->body_handles, CNI_KIND_BODY);
	cni_handles_init(&world->shape_handles, CNI_KIND_SHAPE);
	cni_handles_init(&world->joint_handles, CNI_KIND_JOINT);
	for (int32_t k = 0; k < COUNT_OF(world_tables); ++k)
		cni_table_init(table_at(world, k), world_tables[k].item_bytes, world_tables[k].page_shift);
	for (int32_t k = 0; k < COUNT_OF(world_arrays); ++k)
		cni_array_init(array_at(world, k), world_arrays[k].item_bytes);
	for (int32_t k = 0; k < CNI_COLOR_LISTS; ++k)
		world->colors[k].first = world->colors[k].last = CNI_NONE;
	world->proxy_free = world->contact_free = world->block_free = world->island_free = CNI_NONE;
}

static void tables_deinit(cn_world *world)
{
	cni_memory *memory = &world->memory;
	if (world->broadphase != NULL)
		world->broadphase_ops->destroy(world->broadphase);
	cni_arena_deinit(&world->arena);
	cni_blocks_deinit(&world->blocks);
	cni_handles_deinit(&world->body_handles, memory);
	cni_handles_deinit(&world->shape_handles, memory);
	cni_handles_deinit(&world->joint_handles, memory);
	for (int32_t k = 0; k < COUNT_OF(world_tables); ++k)
		cni_table_deinit(table_at(world, k), memory);
	for (int32_t k = 0; k < COUNT_OF(world_arrays); ++k)
		cni_array_deinit(array_at(world, k), memory);
}

/* Creates the dummy body at dense index 0, in reserved memory: infinite mass, never moves. */
static void dummy_create(cn_world *world)
{
	world->awake_count = 1;
	world->motion.count = world->start.count = world->external.count = world->awake_id.count = 1;
	memset(cni_motions(world), 0, sizeof(cni_motion));
	memset(cni_starts(world), 0, sizeof(cni_velocity_start));
	memset(cni_externals(world), 0, sizeof(cni_external));
	cni_awake_ids(world)[0] = CNI_NONE;
}

static const cni_broadphase_ops *broadphase_choice(int32_t broadphase)
{
	return CNI_HAS_TREE && (!CNI_HAS_SWEEP || broadphase == CN_BROADPHASE_TREE || !CNI_ON(SWEEP)) ? &cni_broadphase_tree : &cni_broadphase_sweep;
}

static int32_t broadphase_create(cn_world *world, int32_t capacity)
{
	const cni_broadphase_context context = { &world->memory, &world->arena, &world->proxies, &world->team };
	world->broadphase_ops = broadphase_choice(world->settings.broadphase);
	world->broadphase = world->broadphase_ops->create(&context, capacity);
	return world->broadphase != NULL;
}

static int32_t team_create(cn_world *world, const cn_world_def *d)
{
	if (!cni_team_possible(d->worker_count, d->enqueue))
		return 1;
	world->team = cni_team_create(&world->memory, d->worker_count, d->enqueue, d->finish, d->task_user);
	return world->team != NULL;
}

/* ---- capacities ---- */

static int32_t or_contacts(int32_t capacity, const cn_world_def *d)
{
	return capacity == CN_DEFAULT ? d->contact_capacity : cni_min_i(capacity, d->contact_capacity);
}

static int32_t touching_of(const cn_world_def *d) { return or_contacts(d->touching_capacity, d); }
static int32_t events_of(const cn_world_def *d) { return or_contacts(d->event_capacity, d); }
static int32_t reserves(const cn_world_def *d, uint32_t what) { return (d->reserve & what) != 0; }

/* Pieces of the block allocator that a fixed world reserves (see model/shape.h). */
enum { PIECE_KINDS = 3 };

static void pieces_make(const cn_world_def *d, cni_pieces out[PIECE_KINDS])
{
	out[0].bytes = (uint64_t)cni_geometry_bytes(CN_SHAPE_POLYGON, d->vertex_capacity);
	out[0].count = d->shape_capacity;
	out[1].bytes = CNI_SHAPE_IDS_BYTES;
	out[1].count = reserves(d, CN_RESERVE_CHAINS) ? 2 * d->shape_capacity : 0;
	out[2].bytes = CN_NAME_MAX_BYTES + 1;
	out[2].count = reserves(d, CN_RESERVE_NAMES) ? d->body_capacity : 0;
}

/* Most islands: bodies that touch nothing have none. */
static int32_t islands_for(int32_t bodies)
{
	return bodies / 2 + 2;
}

static uint64_t solver_bytes(const cn_world_def *d)
{
	uint64_t bytes = 0;
	if (CNI_HAS_DIRECT && CNI_ON(OVERLAP_PROJECTION)) /* takes more than gravity preload */
		bytes += cni_project_overlaps_bytes(d->body_capacity, islands_for(d->body_capacity), touching_of(d));
	else if (CNI_HAS_DIRECT && d->solver == CN_SOLVER_AUTO)
		bytes += cni_gravity_preload_bytes(d->body_capacity);
	if (CNI_HAS_DIRECT)
		bytes += cni_direct_bytes(d->solver, d->joint_capacity, d->contact_capacity, d->body_capacity);
	return bytes;
}

/* Bytes of the frame arena: the larger of the broadphase's pass over boxes, the list of new pairs, and the solver's scratch (direct
   solving, rows, gravity preload, projection of overlaps), with the search of an island. */
static uint64_t arena_bytes(const cn_world_def *d)
{
	uint64_t box = cni_team_possible(d->worker_count, d->enqueue) ? 80u : 40u; /* workers also store their pairs */
	uint64_t boxes = (CNI_HAS_SWEEP ? 2048u : 64u) + box * (uint64_t)d->shape_capacity, pairs = 64u + sizeof(cni_pair) * (uint64_t)d->contact_capacity; /* or changes of the narrowphase */
	uint64_t island = 64u + 8u * (uint64_t)d->body_capacity;
	uint64_t joints = solver_bytes(d), scratch = boxes > pairs ? boxes : pairs;
	joints += 128u + (uint64_t)islands_for(d->body_capacity) + 3u * sizeof(int32_t) * ((uint64_t)d->body_capacity + 1u); /* cni_angular_momentum_restore; cni_rest_find takes less */
	joints += 64u + sizeof(int32_t) * ((uint64_t)d->body_capacity + 1u) * 3u / 2u; /* the islands of awake bodies */
	joints += 64u + sizeof(cni_block_sums) * (uint64_t)cni_min_i(cni_lane_blocks_for(touching_of(d)), events_of(d));
	return (scratch > joints ? scratch : joints) + island;
}

static void rooms_make(const cn_world_def *d, int32_t fixed, int32_t rooms[ROOMS])
{
	int32_t bodies = d->body_capacity, contacts = d->contact_capacity, joints = d->joint_capacity;
	memset(rooms, 0, ROOMS * sizeof rooms[0]);
	rooms[ROOM_BODIES] = bodies;
	rooms[ROOM_SHAPES] = d->shape_capacity;
	rooms[ROOM_JOINTS] = joints;
	rooms[ROOM_CONTACTS] = contacts;
	rooms[ROOM_DENSE] = bodies + 1;
	rooms[ROOM_ISLANDS] = islands_for(bodies);
	rooms[ROOM_BLOCKS] = cni_lane_blocks_for(touching_of(d));
	rooms[ROOM_JOINT_BLOCKS] = cni_joint_blocks_for(joints);
	if (!fixed)
		return;
	rooms[ROOM_KICKED] = 2 * bodies;
	rooms[ROOM_MOVED] = reserves(d, CN_RESERVE_MOVED) ? bodies : 0;
	rooms[ROOM_PAIRS] = contacts;
	rooms[ROOM_SLEEP_LANES] = CNI_SLEEP_IN_BLOCKS ? 0 : touching_of(d);
	rooms[ROOM_DIRECT_ISLANDS] = CNI_HAS_DIRECT ? bodies / 2 : 0;
	rooms[ROOM_EVENTS] = events_of(d);
	rooms[ROOM_JOINT_EVENTS] = joints;
	rooms[ROOM_MOVED_EVENTS] = reserves(d, CN_RESERVE_MOVED) ? 2 * bodies + 1 : 0;
	rooms[ROOM_PLAN] = CNI_HAS_DIRECT ? (int32_t)(cni_direct_kept_bytes(d->solver, joints, contacts) / CNI_KEPT_BYTES) : 0;
}

/* Slots that have worn out their index are found by a list of aliases, which a fixed world has beforehand. */
static int32_t reserve_handles(cn_world *world, cni_handles *handles, int32_t capacity)
{
	return cni_handles_reserve(handles, &world->memory, capacity) == CN_OK &&
	       (!world->memory.fixed || cni_handles_reserve_aliases(handles, &world->memory, capacity));
}

static int32_t reserve_rooms(cn_world *world, const cn_world_def *d)
{
	int32_t rooms[ROOMS], good;
	rooms_make(d, d->memory != NULL, rooms);
	good = reserve_handles(world, &world->body_handles, d->body_capacity) && reserve_handles(world, &world->shape_handles, d->shape_capacity) &&
	       reserve_handles(world, &world->joint_handles, d->joint_capacity);
	for (int32_t k = 0; k < COUNT_OF(world_tables) && good; ++k)
		good = cni_table_reserve(table_at(world, k), &world->memory, rooms[world_tables[k].room]);
	for (int32_t k = 0; k < COUNT_OF(world_arrays) && good; ++k)
		good = cni_array_reserve(array_at(world, k), &world->memory, rooms[world_arrays[k].room]);
	return good;
}

/* What a fixed world has beside its rooms. */
static int32_t reserve_rest(cn_world *world, const cn_world_def *d)
{
	cni_pieces pieces[PIECE_KINDS];
	pieces_make(d, pieces);
	return cni_blocks_reserve_exact(&world->blocks, pieces, PIECE_KINDS) && cni_arena_reserve(&world->arena, arena_bytes(d));
}

static uint64_t array_bytes(int32_t count, size_t item)
{
	return cni_memory_rounded((uint64_t)count * item);
}

/* Bytes of the pieces that are reserved, and of chains of more than 32 edges: 12 bytes per edge beyond that, half as much again for size
   classes, the least chunk, and a larger table of chunks. */
static uint64_t pieces_bytes(const cn_world_def *d)
{
	cni_pieces pieces[PIECE_KINDS];
	pieces_make(d, pieces);
	uint64_t bytes = cni_blocks_bytes_for(pieces, PIECE_KINDS);
	return reserves(d, CN_RESERVE_CHAINS) ? bytes + bytes / 512u + 18u * (uint64_t)d->shape_capacity + 8192u : bytes;
}

static uint64_t handles_bytes(int32_t n)
{
	return array_bytes(n, sizeof(uint32_t)) + 2u * array_bytes(n, sizeof(cni_alias));
}

/* Extra rows are made for all blocks, once some contact needs them. */
static uint64_t rooms_bytes(const cn_world_def *d)
{
	int32_t rooms[ROOMS];
	uint64_t bytes = handles_bytes(d->body_capacity) + handles_bytes(d->shape_capacity) + handles_bytes(d->joint_capacity);
	rooms_make(d, 1, rooms);
	for (int32_t k = 0; k < COUNT_OF(world_tables); ++k) {
		int32_t extra = world_tables[k].offset == offsetof(cn_world, blocks_extra) && reserves(d, CN_RESERVE_EXTRA_ROWS);
		cni_table table;
		cni_table_init(&table, world_tables[k].item_bytes, world_tables[k].page_shift);
		bytes += cni_table_bytes_for(&table, rooms[extra ? ROOM_BLOCKS : world_tables[k].room]);
	}
	for (int32_t k = 0; k < COUNT_OF(world_arrays); ++k)
		bytes += array_bytes(rooms[world_arrays[k].room], world_arrays[k].item_bytes);
	return bytes;
}

/* For the event arrays that users request: all events of a contact in a step except its creation, for twice as many contacts, because these
   arrays grow; half of them may have hits. */
static uint64_t seen_bytes(const cn_world_def *d) { return 3u * array_bytes(events_of(d), sizeof(cn_contact_event)); }

cn_result cn_world_bytes_needed(const cn_world_def *def, uint64_t *out_bytes)
{
	cni_call call = cni_enter_free();
	def_check(&call, def);
	cni_check_pointer(&call, "out_bytes", out_bytes);
	if (call.result != CN_OK)
		return call.result;
	*out_bytes = cni_memory_rounded(sizeof(cn_world)) + rooms_bytes(def) + seen_bytes(def) + array_bytes(1, (size_t)arena_bytes(def)) +
	             pieces_bytes(def) + broadphase_choice(def->broadphase)->bytes_needed(def->shape_capacity);
	if (cni_team_possible(def->worker_count, def->enqueue))
		*out_bytes += cni_memory_rounded(cni_team_bytes(def->worker_count));
	*out_bytes = cni_memory_rounded(*out_bytes);
	return CN_OK;
}

/* ---- creating and destroying ---- */

/* Allocates the struct; *memory then serves everything else. */
static cn_world *world_allocate(const cn_world_def *d, cni_memory *memory)
{
	uint64_t bytes = cni_memory_rounded(sizeof(cn_world));
	if (d->memory == NULL) {
		cni_memory_init_hooks(memory, d->alloc, d->free, d->allocator_user);
		return (cn_world *)cni_memory_alloc(memory, bytes);
	}
	if (d->memory_bytes < bytes + CNI_MEMORY_ALIGN)
		return NULL;
	cni_memory_init_block(memory, (uint8_t *)d->memory + bytes, d->memory_bytes - bytes);
	return (cn_world *)d->memory;
}

cn_result cn_world_create(const cn_world_def *def, cn_world **out_world)
{
	cni_call call = cni_enter_free();
	cni_memory memory;
	def_check(&call, def);
	cni_check_pointer(&call, "out_world", out_world);
	if (call.result != CN_OK)
		return call.result;
	memset(&memory, 0, sizeof memory);
	cn_world *world = world_allocate(def, &memory);
	if (world == NULL)
		return CN_ERROR_MEMORY;
	memset(world, 0, sizeof *world);
	world->memory = memory;
	world->user_data = def->user_data;
	world->fixed_step = 1.0f / 60.0f;
	world->steps_max = 8;
	settings_resolve(&world->settings, def);
	tables_init(world);
	world->event_capacity = events_of(def);
	world->vertex_capacity = def->memory != NULL ? def->vertex_capacity : 0;
	int32_t created = broadphase_create(world, def->shape_capacity) && reserve_rooms(world, def) &&
	          (def->memory == NULL || reserve_rest(world, def)) && team_create(world, def);
	if (!created) {
		cn_world_destroy(world);
		return CN_ERROR_MEMORY;
	}
	dummy_create(world);
	*out_world = world;
	return CN_OK;
}

void cn_world_destroy(cn_world *world)
{
	if (world == NULL || world->locked > 0)
		return;
	cni_team_destroy(world->team, &world->memory);
	tables_deinit(world);
	cni_memory memory = world->memory;
	if (!memory.fixed)
		cni_memory_free(&memory, world, cni_memory_rounded(sizeof(cn_world)));
}
