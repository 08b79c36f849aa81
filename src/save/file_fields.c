/*
 * save/file_fields.c - what a file holds of each record, field by field, and the order of its chunks. One list serves writing and
 * reading.
 *
 * Every byte of every record is named here; the bytes that follow from others are derived and not in the file. Append only: a field
 * or a chunk that is no longer used stays and is written as zeros.
 *
 * Records that are free are written as zeros, and their order of reuse as a list of indices.
 */
#include "save/file.h"

#include <stddef.h>
#include <string.h>
#define FIELD(type, member, kind) { (uint16_t)offsetof(type, member), (uint16_t)(sizeof(((type *)0)->member) / CNI_FIELD_BYTES(CNI_FIELD_##kind)), CNI_FIELD_##kind }
#define RECORD(fields, type) { fields, (int32_t)(sizeof(fields) / sizeof(fields)[0]), (int32_t)sizeof(type) }

/* ---- the world */

#define S(member, kind) FIELD(cni_settings, member, kind)
static const cni_field settings_fields[] = {
	S(gravity, FLOAT), S(length_unit, FLOAT), S(solver, COUNT), S(broadphase, COUNT), S(substeps, COUNT), S(flags, WORD), S(restitution_threshold, FLOAT),
	S(push_speed_max, FLOAT), S(linear_speed_max, FLOAT), S(angular_speed_max, FLOAT), S(sleep_speed, FLOAT), S(sleep_delay, FLOAT), S(slop, DERIVED),
	S(thickness_least, DERIVED), S(box_margin, DERIVED), S(contact_margin, DERIVED), S(accuracy, FLOAT), S(hit_speed, FLOAT), S(work_budget, COUNT)
};

#define W(member, kind) FIELD(cn_world, member, kind)
#define V(member) FIELD(cn_world, member, SAVED)
#define D(member) FIELD(cn_world, member, DERIVED)
static const cni_field world_fields[] = {
	W(step_count, WORD), W(user_data, LONG), W(step_dt, FLOAT), W(mean_dt, FLOAT), W(longest_dt, FLOAT), W(overridden, HALF), W(fixed_step, FLOAT), W(time_owed, FLOAT),
	W(steps_max, COUNT), W(pairs_may_repeat, COUNT), W(seams_changed, BIT), W(seams_box, WORD), W(split_step, WORD), W(joints_soft_step, WORD),
	W(projects, HALF), W(settled, HALF), W(piles_new, BIT), W(piles_unheld, BIT), W(masses_estimated, COUNT), W(estimated, WORD), W(solvers_asked, BIT), W(direct_work, COUNT), W(direct_failed, BIT),
	W(cone_work, COUNT), W(warnings, WORD), W(pairs_not_added, COUNT), W(bodies_stopped, WORD), W(events_not_reported, COUNT), W(stressed_joints, COUNT),
	/* counted again by a file, settings and colours in chunks of their own */
	V(settings), V(movable_count), V(awake_count), V(proxy_used), V(proxy_free), V(proxy_count), V(proxy_free_count), V(contact_used), V(contact_free),
	V(contact_count), V(contacts_reporting), V(touching_count), V(block_used), V(block_free), V(colors), V(constraint_count), V(island_used),
	V(island_free), V(island_count),
	/* other chunks, and passed by state_pass of save/save.c; memory, scratch, caches, and what stays the world's own */
	D(memory), D(arena), D(blocks), D(team), D(locked), D(body_handles), D(bodies), D(motion), D(start), D(external), D(awake_id), D(awake_islands),
	D(step_islands), D(step_island_count), D(kicked), D(previous), D(reserved_time), D(shape_handles), D(shapes), D(proxies), D(broadphase_ops),
	D(broadphase), D(pairs), D(vertex_capacity), D(contacts), D(apart), D(blocks_hot), D(blocks_info), D(blocks_anchor), D(blocks_extra), D(block_list),
	D(sleep_lanes), D(joint_handles), D(joints), D(awake_joints), D(joint_work), D(joint_blocks), D(joint_blocks_of), D(joint_lanes),
	D(joint_plain_first), D(islands), D(direct_islands), D(set_work),
	D(direct_plans), D(filter), D(filter_user), D(pre_solve), D(pre_solve_user), D(material_mix), D(material_mix_user), D(events), D(profile), D(areas),
	D(readback), D(readback_kept), D(readback_asked), D(sums), D(sums_count), D(sums_active), D(event_capacity), D(error)
};

/* ---- handles */

static const cni_field word_fields[] = { { 0, 1, CNI_FIELD_WORD } };
#define A(member, kind) FIELD(cni_alias, member, kind)
static const cni_field alias_fields[] = { A(index, COUNT), A(slot, COUNT) };
#define H(member, kind) FIELD(cni_handles, member, kind)
static const cni_field handles_fields[] = {
	H(slots, DERIVED), H(aliases, DERIVED), H(by_slot, DERIVED), H(kind, DERIVED), H(count, COUNT), H(free_first, WORD), H(free_last, WORD),
	H(worn, COUNT), H(alias_next, COUNT)
};

/* ---- bodies */

#define B(member, kind) FIELD(cni_body, member, kind)
static const cni_field body_fields[] = {
	B(cx, FLOAT), B(cy, FLOAT), B(cx_low, FLOAT), B(cy_low, FLOAT), B(q, FLOAT), B(local_center, FLOAT), B(extent, FLOAT), B(flags, WORD),
	B(awake, COUNT), B(type, BYTE), B(turn_reach, BYTE), B(room, HALF), B(vx, FLOAT), B(vy, FLOAT), B(w, FLOAT), B(mass, FLOAT), B(inertia, FLOAT),
	B(linear_damping, FLOAT), B(angular_damping, FLOAT), B(gravity_scale, FLOAT), B(sleep_speed, FLOAT), B(sleep_time, FLOAT), B(gain, WORD),
	B(core, FLOAT), B(island, ISLAND), B(island_next, BODY), B(island_prev, BODY), B(shape_first, SHAPE), B(joint_first, JOINT_KEY),
	B(contact_first, CONTACT_KEY), B(contact_count, COUNT), B(colors, WORD), B(lanes, COUNT), B(name, DERIVED), B(user_data, LONG)
};
#define M(member, kind) FIELD(cni_motion, member, kind)
static const cni_field motion_fields[] = {
	M(vx, FLOAT), M(vy, FLOAT), M(w, FLOAT), M(inv_mass, FLOAT), M(dpx, FLOAT), M(dpy, FLOAT), M(theta, FLOAT), M(inv_inertia, FLOAT)
};
#define O(member, kind) FIELD(cni_velocity_start, member, kind)
static const cni_field start_fields[] = { O(vx, WORD), O(vy, WORD), O(w, WORD), O(jumped, WORD) };
#define E(member, kind) FIELD(cni_external, member, kind)
static const cni_field external_fields[] = { E(ax, WORD), E(ay, WORD), E(alpha, WORD), E(flags, DRIVE) };
#define P(member, kind) FIELD(cni_previous, member, kind)
static const cni_field previous_fields[] = { P(x, FLOAT), P(y, FLOAT), P(c, FLOAT), P(s, FLOAT), P(body, WORD), P(step, WORD) };
static const cni_field body_index_fields[] = { { 0, 1, CNI_FIELD_BODY } };

/* ---- shapes */

#define G(member, kind) FIELD(cni_shape, member, kind)
static const cni_field shape_fields[] = {
	G(body, BODY), G(next, SHAPE), G(prev, SHAPE), G(type, BYTE), G(event_mask, BYTE), G(flags, BYTE), G(mix, BYTE), G(geometry, DERIVED),
	G(extra, DERIVED), G(box, DERIVED), G(density, FLOAT), G(static_friction, FLOAT), G(dynamic_friction, FLOAT), G(restitution, FLOAT),
	G(rolling_resistance, FLOAT), G(tangent_speed, FLOAT), G(group, WORD), G(category, LONG), G(mask, LONG), G(user_data, LONG)
};
#define X(member, kind) FIELD(cni_proxy, member, kind)
static const cni_field proxy_fields[] = { X(fat, WORD), X(old, WORD), X(shape, SHAPE), X(geometry, DERIVED), X(cell, DERIVED), X(flags, WORD) };

#define R(member, kind) FIELD(cni_area, member, kind)
static const cni_field area_fields[] = {
	R(shape, SHAPE), R(def.struct_size, DERIVED), R(def.priority, WORD), R(def.flags, WORD), R(def.gravity_mps2, FLOAT), R(def.center_m, FLOAT),
	R(def.pull_mps2, FLOAT), R(def.pull_distance_m, FLOAT), R(def.linear_damping_per_s, FLOAT), R(def.angular_damping_per_s, FLOAT),
	R(def.density_kgpm2, FLOAT), R(def.drag_kgpm2, FLOAT), R(def.lift_kgpm2, FLOAT), R(def.flow_mps, FLOAT)
};

/* ---- contacts */

#define C(member, kind) FIELD(cni_contact, member, kind)
static const cni_field contact_fields[] = {
	C(proxy, PROXY), C(body, BODY), C(flags, WORD), C(slot, WORD), C(next, CONTACT_KEY), C(prev, CONTACT_KEY), C(id, HALF), C(cache, BYTE)
};
static const cni_field contact_index_fields[] = { { 0, 1, CNI_FIELD_CONTACT } };
#define K(member, kind) FIELD(cni_contact_block, member, kind)
static const cni_field block_fields[] = {
	K(ia, COUNT), K(ib, COUNT), K(nx, WORD), K(ny, WORD), K(static_friction, WORD), K(dynamic_friction, WORD), K(dn, WORD), K(dt, WORD), K(fa, WORD),
	K(fb, WORD), K(tm, WORD), K(jt, WORD), K(p, WORD)
};
#define CNI_FIELD_LANE_BITS (sizeof(cni_lane_bits) == 2 ? CNI_FIELD_HALF : CNI_FIELD_BYTE)
#define I(member, kind) FIELD(cni_block_info, member, kind)
static const cni_field info_fields[] = {
	I(contact, CONTACT), I(restitution, WORD), I(prev, BLOCK), I(next, BLOCK), I(color, HALF), I(flags, HALF), I(sums, DERIVED), I(fresh_step, STAMP), I(fresh, HALF),
	I(anchored, HALF), I(of_b, LANE_BITS), I(face, LANE_BITS), I(points_of_b, LANE_BITS), I(again, DERIVED)
};
static const cni_field anchor_fields[] = { { 0, sizeof(cni_block_anchor) / 4, CNI_FIELD_WORD } };
static const cni_field extra_fields[] = { { 0, sizeof(cni_block_extra) / 4, CNI_FIELD_WORD } };
#define L(member, kind) FIELD(cni_sleep_lane, member, kind)
static const cni_field sleep_lane_fields[] = {
	L(rows, WORD), L(restitution, WORD), L(extra, WORD), L(contact, CONTACT)
};
#define Q(member, kind) FIELD(cni_color, member, kind)
static const cni_field color_fields[] = { Q(first, BLOCK), Q(last, BLOCK), Q(lanes, COUNT), Q(listed, DERIVED), Q(listed_count, DERIVED) };

/* ---- joints and islands */

#define J(member, kind) FIELD(cni_joint, member, kind)
static const cni_field joint_fields[] = {
	J(type, COUNT), J(flags, WORD), J(body, BODY), J(next, JOINT_KEY), J(prev, JOINT_KEY), J(awake, WORD), J(linked, HALF), J(apart, HALF), J(solver, COUNT),
	J(anchor, FLOAT), J(impulse, WORD), J(inv_h, WORD), J(stiffness_hertz, FLOAT), J(stiffness_damping, FLOAT), J(force_max, FLOAT),
	J(torque_max, FLOAT), J(break_force, FLOAT), J(break_torque, FLOAT), J(p, FLOAT), J(trust.surplus, WORD), J(trust.until, WORD),
	J(trust.span, HALF), J(trust.soft, BYTE), J(trust.direct, BYTE), J(user_data, LONG)
};
static const cni_field joint_index_fields[] = { { 0, 1, CNI_FIELD_JOINT } };
#define N(member, kind) FIELD(cni_island, member, kind)
static const cni_field island_fields[] = {
	N(first, BODY), N(last, BODY), N(count, COUNT), N(losses, COUNT), N(awake, BIT), N(next_free, DERIVED), N(rest_time, WORD), N(rest_step, DERIVED), N(movers, DERIVED), N(number, DERIVED),
	N(numbered_step, DERIVED), N(limited_step, DERIVED), N(tier, BIT), N(good_steps, COUNT), N(stay_steps, COUNT), N(given_step, STAMP), N(looked_step, STAMP),
	N(refused_step, STAMP), N(refused_steps, COUNT), N(reason, COUNT), N(solver, HALF), N(joints_solver, HALF), N(new_step, STAMP),
	N(new_contacts, COUNT), N(unheld_step, STAMP), N(cone_step, STAMP), N(cone_spent, COUNT), N(cone_paid_step, STAMP), N(gives_step, STAMP),
	N(falls_steps, COUNT), N(asked_step, STAMP), N(asked_steps, COUNT), N(projected_step, STAMP),
	N(projected_steps, COUNT), N(frame_step, DERIVED), N(frame, DERIVED)
};
static const cni_field island_index_fields[] = { { 0, 1, CNI_FIELD_ISLAND } };

/* ---- events */

#define T(member, kind) FIELD(cni_event, member, kind)
static const cni_field event_fields[] = {
	T(shape_a, WORD), T(shape_b, WORD), T(body_a, WORD), T(body_b, WORD), T(child, WORD), T(contact, CONTACT), T(approach_speed, WORD)
};
#define U(member, kind) FIELD(cni_event_stay, member, kind)
static const cni_field stay_fields[] = { U(contact, CONTACT), U(normal_impulse, WORD), U(friction_impulse, WORD) };
static const cni_field hit_fields[] = { { 0, sizeof(cn_contact_event) / 4, CNI_FIELD_WORD } };
#define Y(member, kind) FIELD(cn_sensor_event, member, kind)
static const cni_field sensor_event_fields[] = {
	Y(sensor, WORD), Y(visitor, WORD), Y(sensor_body, WORD), Y(visitor_body, WORD), Y(kind, COUNT), Y(reserved, DERIVED)
};
#define Z(member, kind) FIELD(cn_joint_event, member, kind)
static const cni_field joint_event_fields[] = {
	Z(joint, WORD), Z(constraint, WORD), Z(body_a, WORD), Z(body_b, WORD), Z(force_N, WORD), Z(torque_Nm, WORD), Z(destroyed, BIT),
	Z(reserved, DERIVED), Z(user_data, LONG)
};

enum {
	OF_WORLD, OF_SETTINGS, OF_WORDS, OF_ALIAS, OF_HANDLES, OF_BODY, OF_MOTION, OF_START, OF_EXTERNAL, OF_PREVIOUS, OF_BODY_INDEX, OF_SHAPE, OF_PROXY, OF_CONTACT, OF_CONTACT_INDEX, OF_BLOCK, OF_INFO,
	OF_ANCHOR, OF_EXTRA, OF_SLEEP_LANE, OF_COLOR, OF_JOINT, OF_JOINT_INDEX, OF_ISLAND, OF_ISLAND_INDEX, OF_EVENT, OF_STAY, OF_HIT, OF_SENSOR_EVENT, OF_JOINT_EVENT, OF_AREA, RECORDS
};

static const cni_record records[RECORDS] = {
	RECORD(world_fields, cn_world), RECORD(settings_fields, cni_settings), RECORD(word_fields, uint32_t), RECORD(alias_fields, cni_alias),
	RECORD(handles_fields, cni_handles), RECORD(body_fields, cni_body), RECORD(motion_fields, cni_motion), RECORD(start_fields, cni_velocity_start),
	RECORD(external_fields, cni_external), RECORD(previous_fields, cni_previous), RECORD(body_index_fields, int32_t), RECORD(shape_fields, cni_shape),
	RECORD(proxy_fields, cni_proxy), RECORD(contact_fields, cni_contact), RECORD(contact_index_fields, int32_t),
	RECORD(block_fields, cni_contact_block), RECORD(info_fields, cni_block_info), RECORD(anchor_fields, cni_block_anchor),
	RECORD(extra_fields, cni_block_extra), RECORD(sleep_lane_fields, cni_sleep_lane), RECORD(color_fields, cni_color),
	RECORD(joint_fields, cni_joint), RECORD(joint_index_fields, int32_t), RECORD(island_fields, cni_island), RECORD(island_index_fields, int32_t),
	RECORD(event_fields, cni_event), RECORD(stay_fields, cni_event_stay), RECORD(hit_fields, cn_contact_event), RECORD(sensor_event_fields, cn_sensor_event), RECORD(joint_event_fields, cn_joint_event),
	RECORD(area_fields, cni_area)
};

const cni_record *cni_file_kind(int32_t k) { return k < RECORDS ? &records[k] : NULL; }

/* ---- single records, arrays, tables ---- */

static void single_pass(cni_file *f, const char *tag, int32_t record, void *item)
{
	uint32_t stride;
	int32_t count = cni_file_chunk(f, tag, cni_record_file_bytes(&records[record]), 1, &stride);
	cni_file_need(f, count == 1, CN_ERROR_FORMAT);
	cni_file_record(f, &records[record], item, stride);
}

void cni_file_settings(cni_file *f, cni_settings *settings)
{
	single_pass(f, "SETT", OF_SETTINGS, settings);
}

static void array_pass(cn_world *world, cni_file *f, const char *tag, int32_t record, cni_array *array)
{
	uint32_t stride;
	int32_t count = cni_file_chunk(f, tag, cni_record_file_bytes(&records[record]), array->count, &stride);
	if (f->mode == CNI_FILE_READ) {
		if (!cni_array_reserve(array, &world->memory, count)) {
			cni_file_fail(f, CN_ERROR_MEMORY);
			return;
		}
		if (count > 0)
			memset(array->data, 0, (size_t)count * (size_t)array->item_bytes);
		array->count = count;
	}
	for (int32_t k = 0; k < count; ++k)
		cni_file_record(f, &records[record], (uint8_t *)array->data + (size_t)k * (size_t)array->item_bytes, stride);
}

/* The arrays of the world, in the order of their chunks, by the part of the file that they are in. */
enum { BODIES_PART, AREAS_PART, CONTACTS_PART, JOINTS_PART, ISLANDS_PART, EVENTS_PART };

typedef struct world_array {
	char tag[5];
	uint8_t part, record;
	uint16_t offset;
} world_array;

#define ARRAY(part, tag, member, record) { tag, part, record, (uint16_t)offsetof(cn_world, member) }
#define EVENTS(tag, member, record) ARRAY(EVENTS_PART, tag, events.member, record)
static const world_array world_arrays[] = {
	ARRAY(BODIES_PART, "MOTI", motion, OF_MOTION), ARRAY(BODIES_PART, "STAR", start, OF_START),
	ARRAY(BODIES_PART, "EXTE", external, OF_EXTERNAL), ARRAY(BODIES_PART, "AWAK", awake_id, OF_BODY_INDEX),
	ARRAY(BODIES_PART, "KICK", kicked, OF_WORDS), ARRAY(BODIES_PART, "PREV", previous, OF_PREVIOUS),
	ARRAY(AREAS_PART, "AREA", areas, OF_AREA), ARRAY(CONTACTS_PART, "APAR", apart, OF_CONTACT_INDEX),
	ARRAY(CONTACTS_PART, "SLEE", sleep_lanes, OF_SLEEP_LANE), ARRAY(JOINTS_PART, "JAWA", awake_joints, OF_JOINT_INDEX),
	ARRAY(ISLANDS_PART, "DIRE", direct_islands, OF_ISLAND_INDEX), EVENTS("ELG0", log[0], OF_EVENT),
	EVENTS("EPN0", pending[0], OF_EVENT), EVENTS("ELG1", log[1], OF_EVENT), EVENTS("EPN1", pending[1], OF_EVENT),
	EVENTS("ELG2", log[CN_EVENT_STAY], OF_STAY), EVENTS("EPN2", pending[2], OF_EVENT), EVENTS("ELG3", log[3], OF_EVENT),
	EVENTS("EPN3", pending[3], OF_EVENT), EVENTS("ELG4", log[4], OF_EVENT), EVENTS("EPN4", pending[4], OF_EVENT),
	EVENTS("ELG5", log[CN_EVENT_HIT], OF_HIT), EVENTS("EPN5", pending[5], OF_EVENT), EVENTS("SLOG", sensor_log, OF_SENSOR_EVENT),
	EVENTS("SPEN", sensor_pending, OF_SENSOR_EVENT), EVENTS("JLOG", joint_log, OF_JOINT_EVENT),
	EVENTS("JPEN", joint_pending, OF_JOINT_EVENT), EVENTS("ASLP", asleep, OF_WORDS)
};
#define WORLD_ARRAYS ((int32_t)(sizeof world_arrays / sizeof world_arrays[0]))

cni_array *cni_file_array(cn_world *world, int32_t k)
{
	return k < WORLD_ARRAYS ? (cni_array *)(void *)((uint8_t *)world + world_arrays[k].offset) : NULL;
}

static void arrays_pass(cn_world *world, cni_file *f, int32_t part)
{
	for (int32_t k = 0; k < WORLD_ARRAYS; ++k)
		if (world_arrays[k].part == part)
			array_pass(world, f, world_arrays[k].tag, world_arrays[k].record, cni_file_array(world, k));
}

typedef int32_t live_fn(const cn_world *world, int32_t index);

static void table_pass(cn_world *world, cni_file *f, const char *tag, int32_t record, cni_table *table, int32_t used, live_fn *live)
{
	uint32_t stride;
	int32_t count = cni_file_chunk(f, tag, cni_record_file_bytes(&records[record]), used, &stride);
	cni_file_need(f, count == used, CN_ERROR_FORMAT);
	if (f->mode == CNI_FILE_READ && f->result == CN_OK)
		cni_file_need(f, cni_table_reserve(table, &world->memory, count), CN_ERROR_MEMORY);
	if (f->result != CN_OK)
		return;
	for (int32_t k = 0; k < count; ++k)
		cni_file_record(f, &records[record], live(world, k) ? cni_table_at(table, k) : NULL, stride);
}

/* ---- handles, and the records that they have ---- */

static void handles_pass(cn_world *world, cni_file *f, char letter, cni_handles *handles)
{
	char slots[5] = { letter, 'S', 'L', 'T', 0 }, aliases[5] = { letter, 'A', 'L', 'I', 0 }, by_slot[5] = { letter, 'A', 'L', 'S', 0 };
	char state[5] = { letter, 'H', 'A', 'N', 0 };
	array_pass(world, f, slots, OF_WORDS, &handles->slots);
	array_pass(world, f, aliases, OF_ALIAS, &handles->aliases);
	array_pass(world, f, by_slot, OF_ALIAS, &handles->by_slot);
	single_pass(f, state, OF_HANDLES, handles);
	if (f->mode != CNI_FILE_READ || f->result != CN_OK)
		return;
	if (!cni_file_handles_hold(handles))
		cni_file_fail(f, CN_ERROR_FORMAT);
	else
		cni_file_need(f, cni_handles_reserve(handles, &world->memory, 0) == CN_OK, CN_ERROR_MEMORY);
}

static int32_t body_is_live(const cn_world *world, int32_t body) { return cni_handles_alive(&world->body_handles, body); }
static int32_t shape_is_live(const cn_world *world, int32_t shape) { return cni_handles_alive(&world->shape_handles, shape); }
static int32_t joint_is_live(const cn_world *world, int32_t joint) { return cni_handles_alive(&world->joint_handles, joint); }

/* ---- pools: records with a list of free ones ---- */

static int32_t proxy_is_live(const cn_world *world, int32_t proxy) { return (cni_proxy_at(world, proxy)->flags & CNI_PROXY_ALIVE) != 0; }
static int32_t contact_is_live(const cn_world *world, int32_t contact) { return cni_contact_at(world, contact)->body[0] != CNI_NONE; }
static int32_t island_is_live(const cn_world *world, int32_t island) { return cni_island_at(world, island)->first != CNI_NONE; }
static int32_t block_is_live(const cn_world *world, int32_t block) { return cni_block_info_at(world, block)->color != CNI_NONE; }

static int32_t *proxy_link(const cn_world *world, int32_t proxy) { return &cni_proxy_at(world, proxy)->shape; }
static int32_t *contact_link(const cn_world *world, int32_t contact) { return &cni_contact_at(world, contact)->slot; }
static int32_t *island_link(const cn_world *world, int32_t island) { return &cni_island_at(world, island)->next_free; }
static int32_t *block_link(const cn_world *world, int32_t block) { return &cni_block_info_at(world, block)->next; }

/* A free record, from one of zeros. */
static void free_proxy(const cn_world *world, int32_t proxy) { cni_proxy_at(world, proxy)->flags = 0; }
static void free_contact(const cn_world *world, int32_t contact) { cni_contact_at(world, contact)->body[0] = cni_contact_at(world, contact)->body[1] = CNI_NONE; }
static void free_island(const cn_world *world, int32_t island) { cni_island_at(world, island)->first = cni_island_at(world, island)->last = CNI_NONE; }

static void free_block(const cn_world *world, int32_t block)
{
	cni_block_info *info = cni_block_info_at(world, block);
	for (int32_t l = 0; l < CNI_LANES; ++l)
		info->contact[l] = CNI_NONE;
	info->color = CNI_NONE;
}

typedef struct pool {
	const char *tag;
	live_fn *live;
	int32_t *(*link)(const cn_world *world, int32_t index); /* where a free record has the next one */
	void (*free)(const cn_world *world, int32_t index);
} pool;

static const pool pools[] = {
	{ "PFRE", proxy_is_live, proxy_link, free_proxy },
	{ "CFRE", contact_is_live, contact_link, free_contact },
	{ "IFRE", island_is_live, island_link, free_island },
	{ "BFRE", block_is_live, block_link, free_block }
};
enum { PROXY_POOL, CONTACT_POOL, ISLAND_POOL, BLOCK_POOL };

/* Marks the free records and links them. */
static void free_read(cn_world *world, cni_file *f, const pool *p, int32_t used, int32_t *head)
{
	int32_t count = cni_file_chunk_begin(f, p->tag, 4), *to = head;
	*to = CNI_NONE;
	for (int32_t k = 0; k < count; ++k) {
		uint32_t index = cni_file_word(f, 0);
		if (f->result != CN_OK || index >= (uint32_t)used || !p->live(world, (int32_t)index)) {
			cni_file_fail(f, CN_ERROR_FORMAT);
			return;
		}
		*to = (int32_t)index;
		p->free(world, (int32_t)index);
		to = p->link(world, (int32_t)index);
		*to = CNI_NONE;
	}
}

static void free_write(cn_world *world, cni_file *f, const pool *p, int32_t head)
{
	(void)cni_file_chunk_begin(f, p->tag, 4);
	for (int32_t k = head; k != CNI_NONE; k = *p->link(world, k))
		(void)cni_file_word(f, (uint32_t)k);
	cni_file_chunk_end(f, 4);
}

/* Makes room for the records of a pool and says which are free. */
static void pool_pass(cn_world *world, cni_file *f, int32_t which, cni_table *table, int32_t limit, int32_t *used, int32_t *head)
{
	if (f->mode != CNI_FILE_READ) {
		free_write(world, f, &pools[which], *head);
		return;
	}
	if (f->result == CN_OK)
		cni_file_need(f, cni_table_reserve(table, &world->memory, f->limits[limit]), CN_ERROR_MEMORY);
	if (f->result != CN_OK)
		return;
	*used = f->limits[limit];
	for (int32_t k = 0; k < *used && which == PROXY_POOL; ++k)
		cni_proxy_at(world, k)->flags = CNI_PROXY_ALIVE; /* in other tables a record of zeros looks alive */
	free_read(world, f, &pools[which], *used, head);
}

/* ---- contacts ---- */

typedef union lane_words {
	cni_contact_block rows;
	cni_block_anchor anchor;
	cni_block_extra extra;
	uint32_t words[sizeof(cni_contact_block) / 4];
} lane_words;

/* Rows by lanes. Kernels of several widths leave 0 or -0 in lanes without a contact: these are written as 0. */
static void lanes_pass(cn_world *world, cni_file *f, const char *tag, int32_t record, cni_table *table, int32_t used)
{
	uint32_t stride, words = (uint32_t)records[record].bytes / 4u;
	if (f->mode == CNI_FILE_READ) {
		table_pass(world, f, tag, record, table, used, block_is_live);
		return;
	}
	int32_t count = cni_file_chunk(f, tag, cni_record_file_bytes(&records[record]), used, &stride);
	for (int32_t k = 0; k < count; ++k) {
		lane_words copy;
		if (f->mode == CNI_FILE_WRITE && block_is_live(world, k)) {
			memcpy(copy.words, cni_table_at(table, k), words * 4u);
			for (uint32_t word = 0; word < words; ++word)
				if (cni_block_info_at(world, k)->contact[word % CNI_LANES] == CNI_NONE)
					copy.words[word] = 0;
		}
		cni_file_record(f, &records[record], block_is_live(world, k) ? copy.words : NULL, stride);
	}
}

int32_t cni_file_extra_count(const cn_world *world)
{
	for (int32_t k = 0; k < world->block_used && cni_table_capacity(&world->blocks_extra) > 0; ++k)
		if (block_is_live(world, k) && (cni_block_info_at(world, k)->flags & CNI_BLOCK_EXTRA))
			return world->block_used;
	return 0;
}

static void extra_pass(cn_world *world, cni_file *f)
{
	int32_t count = f->mode == CNI_FILE_READ ? cni_file_count(f, "EXTR") : cni_file_extra_count(world);
	if (f->mode == CNI_FILE_READ && count != 0 && count != world->block_used)
		cni_file_fail(f, CN_ERROR_FORMAT);
	else if (f->mode == CNI_FILE_READ && count > 0 && !cni_lane_reserve_extra(world))
		cni_file_fail(f, CN_ERROR_MEMORY);
	else
		lanes_pass(world, f, "EXTR", OF_EXTRA, &world->blocks_extra, count);
}

static void blocks_pass(cn_world *world, cni_file *f)
{
	uint32_t stride;
	if (f->mode == CNI_FILE_READ)
		cni_file_need(f, cni_table_reserve(&world->blocks_hot, &world->memory, f->limits[CNI_FIELD_BLOCK]), CN_ERROR_MEMORY);
	pool_pass(world, f, BLOCK_POOL, &world->blocks_info, CNI_FIELD_BLOCK, &world->block_used, &world->block_free);
	table_pass(world, f, "INFO", OF_INFO, &world->blocks_info, world->block_used, block_is_live);
	lanes_pass(world, f, "BLOK", OF_BLOCK, &world->blocks_hot, world->block_used);
	lanes_pass(world, f, "ANCH", OF_ANCHOR, &world->blocks_anchor, world->block_used);
	extra_pass(world, f);
	int32_t count = cni_file_chunk(f, "COLR", cni_record_file_bytes(&records[OF_COLOR]), CNI_COLOR_LISTS, &stride);
	cni_file_need(f, count == CNI_COLOR_LISTS, CN_ERROR_FORMAT);
	for (int32_t color = 0; color < CNI_COLOR_LISTS; ++color)
		cni_file_record(f, &records[OF_COLOR], &world->colors[color], stride);
}

static void contacts_pass(cn_world *world, cni_file *f)
{
	pool_pass(world, f, CONTACT_POOL, &world->contacts, CNI_FIELD_CONTACT, &world->contact_used, &world->contact_free);
	table_pass(world, f, "CONT", OF_CONTACT, &world->contacts, world->contact_used, contact_is_live);
	arrays_pass(world, f, CONTACTS_PART);
	blocks_pass(world, f);
}

/* ---- the whole ---- */

static void limits_read(cni_file *f)
{
	f->limits[CNI_FIELD_BODY] = cni_file_count(f, "BSLT");
	f->limits[CNI_FIELD_SHAPE] = cni_file_count(f, "SSLT");
	f->limits[CNI_FIELD_JOINT] = cni_file_count(f, "JSLT");
	f->limits[CNI_FIELD_PROXY] = cni_file_count(f, "PROX");
	f->limits[CNI_FIELD_CONTACT] = cni_file_count(f, "CONT");
	f->limits[CNI_FIELD_ISLAND] = cni_file_count(f, "ISLA");
	f->limits[CNI_FIELD_BLOCK] = cni_file_count(f, "BLOK");
	f->limits[CNI_FIELD_JOINT_KEY] = 2 * (f->limits[CNI_FIELD_JOINT] & CN_MAX_HANDLES);
	f->limits[CNI_FIELD_CONTACT_KEY] = f->limits[CNI_FIELD_CONTACT] < 1 << 30 ? 2 * f->limits[CNI_FIELD_CONTACT] : 0;
}

static void joints_pass(cn_world *world, cni_file *f)
{
	table_pass(world, f, "JOIN", OF_JOINT, &world->joints, world->joint_handles.slots.count, joint_is_live);
	arrays_pass(world, f, JOINTS_PART);
	pool_pass(world, f, ISLAND_POOL, &world->islands, CNI_FIELD_ISLAND, &world->island_used, &world->island_free);
	table_pass(world, f, "ISLA", OF_ISLAND, &world->islands, world->island_used, island_is_live);
	arrays_pass(world, f, ISLANDS_PART);
}

static void areas_pass(cn_world *world, cni_file *f)
{
	if (!CNI_HAS_AREAS && f->mode == CNI_FILE_READ)
		cni_file_fail(f, CN_ERROR_FORMAT);
	else
		arrays_pass(world, f, AREAS_PART);
}

void cni_file_world(cn_world *world, cni_file *f)
{
	if (f->mode == CNI_FILE_READ)
		limits_read(f);
	else
		cni_file_settings(f, &world->settings);
	single_pass(f, "WRLD", OF_WORLD, world);
	f->step_count = world->step_count;
	handles_pass(world, f, 'B', &world->body_handles);
	handles_pass(world, f, 'S', &world->shape_handles);
	handles_pass(world, f, 'J', &world->joint_handles);
	table_pass(world, f, "BODY", OF_BODY, &world->bodies, world->body_handles.slots.count, body_is_live);
	arrays_pass(world, f, BODIES_PART);
	table_pass(world, f, "SHAP", OF_SHAPE, &world->shapes, world->shape_handles.slots.count, shape_is_live);
	pool_pass(world, f, PROXY_POOL, &world->proxies, CNI_FIELD_PROXY, &world->proxy_used, &world->proxy_free);
	table_pass(world, f, "PROX", OF_PROXY, &world->proxies, world->proxy_used, proxy_is_live);
	if (f->mode == CNI_FILE_READ ? cni_file_has(f, "AREA") : world->areas.count > 0) /* files of earlier versions have none */
		areas_pass(world, f);
	contacts_pass(world, f);
	joints_pass(world, f);
	arrays_pass(world, f, EVENTS_PART);
	cni_file_pieces(world, f);
	cni_file_counts(world, f);
}
