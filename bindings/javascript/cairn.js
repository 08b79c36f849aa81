// Cairn for JavaScript: WebAssembly with classes above it, for node and browsers.
// Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//
//     import { World } from "./cairn.js";
//     const world = new World();
//     const body = world.bodyCreate({ position_m: { x: 0, y: 4 } });
//     world.shapeCreateBox({ body }, 0.5, 0.5, 0);
//     world.step(1 / 60);
//     console.log(world.bodyGetPose(body));
//
// A method is C's function without cn_ and without the world, in camel case. Structs are objects; where one goes in, fields that are
// not given have their defaults. 64-bit numbers are BigInt. Arrays of poses, points and velocities are Float32Array, 4, 2 and 3 a piece.

async function bytes() {
	const url = new URL("./cairn.wasm", import.meta.url);
	if (url.protocol === "file:")
		return (await import("node:fs/promises")).readFile(url);
	return (await fetch(url)).arrayBuffer();
}
const { instance } = await WebAssembly.instantiate(await bytes());
/** C's functions, on the memory of the module. */
export const raw = instance.exports;

let buffer, view, u8, f32;
function refresh() { // the memory may have grown
	if (buffer !== raw.memory.buffer) {
		buffer = raw.memory.buffer;
		view = new DataView(buffer);
		u8 = new Uint8Array(buffer);
		f32 = new Float32Array(buffer);
	}
}

// Memory for the arguments of one call: a block, and more where that is too small, until the next call.
const SCRATCH = 65536, block = raw.malloc(SCRATCH), more = [];
let top = block;
function begin() {
	top = block;
	while (more.length > 0)
		raw.free(more.pop());
	refresh();
}
function take(size) {
	let at = (top + 7) & ~7;
	if (at + size <= block + SCRATCH) {
		top = at + size;
		return at;
	}
	at = raw.malloc(size + 8);
	if (at === 0)
		throw new CairnError(CN_ERROR_MEMORY, "no memory for the arguments");
	more.push(at);
	refresh();
	return at + 7 & ~7;
}

const decoder = new TextDecoder(), encoder = new TextEncoder();
function text(at) {
	refresh();
	return at === 0 ? "" : decoder.decode(u8.subarray(at, u8.indexOf(0, at)));
}
function string(value) {
	if (value === null || value === undefined)
		return 0;
	const encoded = encoder.encode(value), at = take(encoded.length + 1);
	u8.set(encoded, at);
	u8[at + encoded.length] = 0;
	return at;
}

/** A call that failed: code is CN_ERROR_..., the message is the library's sentence. */
export class CairnError extends Error {
	constructor(code, message) {
		super(message);
		this.name = "CairnError";
		this.code = code;
	}
}
function check(code, world) {
	if (code === 0)
		return;
	throw new CairnError(code, (world && text(raw.cn_world_error_text(world))) || text(raw.cn_result_text(code)));
}

const READ = {
	f32: at => view.getFloat32(at, true), i32: at => view.getInt32(at, true), u32: at => view.getUint32(at, true), u64: at => view.getBigUint64(at, true),
	i8: at => view.getInt8(at), u8: at => view.getUint8(at), i16: at => view.getInt16(at, true), u16: at => view.getUint16(at, true),
	i64: at => view.getBigInt64(at, true), f64: at => view.getFloat64(at, true),
};
const WRITE = {
	f32: (at, x) => view.setFloat32(at, x, true), i32: (at, x) => view.setInt32(at, x, true), u32: (at, x) => view.setUint32(at, x, true),
	u64: (at, x) => view.setBigUint64(at, BigInt(x), true), i8: (at, x) => view.setInt8(at, x), u8: (at, x) => view.setUint8(at, x),
	i16: (at, x) => view.setInt16(at, x, true), u16: (at, x) => view.setUint16(at, x, true), i64: (at, x) => view.setBigInt64(at, BigInt(x), true),
	f64: (at, x) => view.setFloat64(at, x, true),
};

// Fields of a struct are [name, offset, kind, count, length]; kind is a scalar, a struct's name, "string", or "array:" and a struct's
// name, whose number of elements goes into the field length. Callbacks and memory are left out: a zero from init.
function readField([, at, kind, count], base) {
	const one = i => STRUCTS[kind] ? readStruct(kind, base + at + i * STRUCTS[kind].size) : READ[kind](base + at + i * SIZES[kind]);
	return count === 0 ? one(0) : Array.from({ length: count }, (_, i) => one(i));
}
function readStruct(name, base) {
	const value = {};
	for (const field of STRUCTS[name].fields)
		if (field[2] !== "string" && !field[2].startsWith("array:"))
			value[field[0]] = readField(field, base);
	return value;
}
function writeStruct(name, base, value) {
	for (const key in value)
		if (!STRUCTS[name].names.has(key))
			throw new TypeError(`${name} has no field ${key}`);
	for (const [key, at, kind, count, length] of STRUCTS[name].fields) {
		const given = value[key];
		if (given === undefined)
			continue;
		if (kind === "string")
			view.setUint32(base + at, string(given), true);
		else if (kind.startsWith("array:")) {
			const elements = array(kind.slice(6), given);
			view.setUint32(base + at, elements, true);
			writeStruct(name, base, { [length]: size(kind.slice(6), given) });
		} else if (count > 0)
			given.forEach((element, i) => i < count && writeOne(kind, base + at + i * (STRUCTS[kind] ? STRUCTS[kind].size : SIZES[kind]), element));
		else
			writeOne(kind, base + at, given);
	}
}
function writeOne(kind, at, value) {
	if (STRUCTS[kind])
		writeStruct(kind, at, value);
	else
		WRITE[kind](at, value);
}
function struct(name, value) { // with its defaults where there are some
	const at = take(STRUCTS[name].size);
	if (STRUCTS[name].init)
		raw[STRUCTS[name].init](at);
	else
		u8.fill(0, at, at + STRUCTS[name].size);
	writeStruct(name, at, value);
	return at;
}

// Arrays: structs of floats may come as a Float32Array.
const SIZES = { f32: 4, i32: 4, u32: 4, u64: 8, i8: 1, u8: 1, i16: 2, u16: 2, i64: 8, f64: 8 };
const stride = kind => STRUCTS[kind] ? STRUCTS[kind].size : SIZES[kind];
const size = (kind, values) => values instanceof Float32Array && STRUCTS[kind] ? values.length / (stride(kind) / 4) : values.length;
function array(kind, values) {
	const bytes = stride(kind), at = take(bytes * size(kind, values) || 1);
	if (values instanceof Float32Array && STRUCTS[kind])
		f32.set(values, at >> 2);
	else
		for (let i = 0; i < values.length; ++i) {
			if (STRUCTS[kind] && STRUCTS[kind].init)
				raw[STRUCTS[kind].init](at + i * bytes);
			else
				u8.fill(0, at + i * bytes, at + (i + 1) * bytes);
			writeOne(kind, at + i * bytes, values[i]);
		}
	return at;
}
function list(kind, at, count, out) { // out: that array, filled
	refresh();
	const bytes = stride(kind);
	if (STRUCTS[kind] && STRUCTS[kind].floats) {
		const floats = f32.subarray(at >> 2, (at >> 2) + count * bytes / 4);
		if (!out)
			return floats.slice();
		out.set(floats);
		return out;
	}
	out = out || new Array(count);
	for (let i = 0; i < count; ++i)
		out[i] = STRUCTS[kind] ? readStruct(kind, at + i * bytes) : READ[kind](at + i * bytes);
	return out;
}
function even(a, b) {
	if (a !== b)
		throw new RangeError(`arrays of ${a} and ${b} elements`);
}

const worlds = new FinalizationRegistry(pointer => raw.cn_world_destroy(pointer));
const trees = new FinalizationRegistry(pointer => raw.cn_tree_destroy(pointer));

export const CN_VERSION_MAJOR = 0;
export const CN_VERSION_MINOR = 1;
export const CN_VERSION_PATCH = 0;
export const CN_ABI_VERSION = 3;
export const CN_POLYGON_MAX_VERTICES = 16;
export const CN_NAME_MAX_BYTES = 63;
export const CN_PLANES_MAX = 64;
export const CN_WORKERS_MAX = 64;
export const CN_MAX_HANDLES = 1048575;
export const CN_DEFAULT = -1;
export const CN_OK = 0;
export const CN_ERROR_ARGUMENT = -1;
export const CN_ERROR_HANDLE = -2;
export const CN_ERROR_MEMORY = -3;
export const CN_ERROR_LOCKED = -4;
export const CN_ERROR_CAPACITY = -5;
export const CN_ERROR_STATE = -6;
export const CN_ERROR_INTERNAL = -7;
export const CN_ERROR_FORMAT = -8;
export const CN_TYPE_VEC2 = 0;
export const CN_TYPE_POSE = 1;
export const CN_TYPE_VELOCITY = 2;
export const CN_TYPE_AABB = 3;
export const CN_TYPE_MASS_DATA = 4;
export const CN_TYPE_WORLD_DEF = 5;
export const CN_TYPE_BODY_DEF = 6;
export const CN_TYPE_SHAPE_DEF = 7;
export const CN_TYPE_CIRCLE = 8;
export const CN_TYPE_CAPSULE = 9;
export const CN_TYPE_EDGE = 10;
export const CN_TYPE_POLYGON = 11;
export const CN_TYPE_CHAIN = 12;
export const CN_TYPE_FILTER = 13;
export const CN_TYPE_MATERIAL = 14;
export const CN_TYPE_MANIFOLD_POINT = 15;
export const CN_TYPE_MANIFOLD = 16;
export const CN_TYPE_CONTACT_EVENT = 17;
export const CN_TYPE_BODY_MOVED = 18;
export const CN_TYPE_REVOLUTE_DEF = 19;
export const CN_TYPE_DISTANCE_DEF = 20;
export const CN_TYPE_COUNTERS = 21;
export const CN_TYPE_PROFILE = 22;
export const CN_TYPE_MEMORY_STATS = 23;
export const CN_TYPE_SENSOR_EVENT = 24;
export const CN_TYPE_UPDATE_REPORT = 25;
export const CN_TYPE_DEBUG_DRAW = 26;
export const CN_TYPE_QUERY_FILTER = 27;
export const CN_TYPE_RAY = 28;
export const CN_TYPE_RAY_HIT = 29;
export const CN_TYPE_CLOSEST = 30;
export const CN_TYPE_EXPLOSION_DEF = 31;
export const CN_TYPE_FIXED_DEF = 32;
export const CN_TYPE_PRISMATIC_DEF = 33;
export const CN_TYPE_WHEEL_DEF = 34;
export const CN_TYPE_MOTOR_DEF = 35;
export const CN_TYPE_MOUSE_DEF = 36;
export const CN_TYPE_GEAR_DEF = 37;
export const CN_TYPE_PULLEY_DEF = 38;
export const CN_TYPE_RATCHET_DEF = 39;
export const CN_TYPE_ROTARY_SPRING_DEF = 40;
export const CN_TYPE_GROOVE_DEF = 41;
export const CN_TYPE_FILTER_JOINT_DEF = 42;
export const CN_TYPE_JOINT_BASE = 43;
export const CN_TYPE_JOINT_EVENT = 44;
export const CN_TYPE_ANGLE_CONSTRAINT_DEF = 45;
export const CN_TYPE_LINE_CONSTRAINT_DEF = 46;
export const CN_TYPE_ISLAND_REPORT = 47;
export const CN_TYPE_DISTANCE = 48;
export const CN_TYPE_SWEEP = 49;
export const CN_TYPE_IMPACT = 50;
export const CN_TYPE_PLANE = 51;
export const CN_TYPE_MOVER_DEF = 52;
export const CN_TYPE_MOVER = 53;
export const CN_TYPE_AREA_DEF = 54;
export const CN_TYPE_COUNT = 55;
export const CN_WORLD_SLEEP = 1;
export const CN_WORLD_WARM_START = 2;
export const CN_WORLD_PROFILE = 4;
export const CN_WORLD_CONTINUOUS = 8;
export const CN_RESERVE_NAMES = 1;
export const CN_RESERVE_CHAINS = 2;
export const CN_RESERVE_EXTRA_ROWS = 4;
export const CN_RESERVE_MOVED = 8;
export const CN_SOLVER_AUTO = 0;
export const CN_SOLVER_SOFT = 1;
export const CN_SOLVER_DIRECT = 2;
export const CN_SOLVER_SEQUENTIAL = 3;
export const CN_BROADPHASE_SWEEP = 0;
export const CN_BROADPHASE_TREE = 1;
export const CN_WARNING_CONTACT_MEMORY = 1;
export const CN_WARNING_FRAME_MEMORY = 2;
export const CN_WARNING_EVENT_MEMORY = 4;
export const CN_WARNING_CROWD = 8;
export const CN_WARNING_NOT_FINITE = 16;
export const CN_TIER_SOFT = 0;
export const CN_TIER_DIRECT = 1;
export const CN_TIER_FREE = 2;
export const CN_TIER_REASON_NONE = 0;
export const CN_TIER_REASON_SETTLING = 1;
export const CN_TIER_REASON_NEW_CONTACT = 2;
export const CN_TIER_REASON_OVERLAP = 3;
export const CN_TIER_REASON_JOINT = 4;
export const CN_TIER_REASON_STRESSED = 5;
export const CN_TIER_REASON_SOLVER = 6;
export const CN_TIER_REASON_OVERRIDE = 7;
export const CN_TIER_REASON_ALONE = 8;
export const CN_TIER_REASON_MOVING = 9;
export const CN_TIER_REASON_CROWDED = 10;
export const CN_TIER_REASON_WORK = 11;
export const CN_TIER_REASON_KIND = 12;
export const CN_TIER_REASON_NO_SET = 13;
export const CN_TIER_REASON_MEMORY = 14;
export const CN_TIER_REASON_JOINTED = 15;
export const CN_BODY_STATIC = 0;
export const CN_BODY_KINEMATIC = 1;
export const CN_BODY_DYNAMIC = 2;
export const CN_BODY_LOCK_X = 1;
export const CN_BODY_LOCK_Y = 2;
export const CN_BODY_LOCK_ROTATION = 4;
export const CN_BODY_BULLET = 8;
export const CN_BODY_ENABLED = 16;
export const CN_BODY_SLEEP = 32;
export const CN_BODY_AWAKE = 64;
export const CN_SHAPE_CIRCLE = 0;
export const CN_SHAPE_CAPSULE = 1;
export const CN_SHAPE_POLYGON = 2;
export const CN_SHAPE_EDGE = 3;
export const CN_SHAPE_CHAIN = 4;
export const CN_MIX_AVERAGE = 0;
export const CN_MIX_GEOMETRIC = 1;
export const CN_MIX_MINIMUM = 2;
export const CN_MIX_MULTIPLY = 3;
export const CN_MIX_MAXIMUM = 4;
export const CN_SHAPE_SENSOR = 1;
export const CN_SHAPE_SENSOR_SEEN = 2;
export const CN_SHAPE_ONE_WAY = 4;
export const CN_SHAPE_PRE_SOLVE = 8;
export const CN_EVENT_CREATED = 0;
export const CN_EVENT_ENTER = 1;
export const CN_EVENT_STAY = 2;
export const CN_EVENT_LEAVE = 3;
export const CN_EVENT_DESTROYED = 4;
export const CN_EVENT_HIT = 5;
export const CN_EVENT_KINDS = 6;
export const CN_JOINT_REVOLUTE = 0;
export const CN_JOINT_DISTANCE = 1;
export const CN_JOINT_FIXED = 2;
export const CN_JOINT_PRISMATIC = 3;
export const CN_JOINT_WHEEL = 4;
export const CN_JOINT_MOTOR_TO = 5;
export const CN_JOINT_MOUSE = 6;
export const CN_JOINT_GEAR = 7;
export const CN_JOINT_PULLEY = 8;
export const CN_JOINT_RATCHET = 9;
export const CN_JOINT_ROTARY_SPRING = 10;
export const CN_JOINT_GROOVE = 11;
export const CN_JOINT_FILTER = 12;
export const CN_JOINT_COLLIDE = 1;
export const CN_JOINT_LIMIT = 2;
export const CN_JOINT_MOTOR = 4;
export const CN_JOINT_SPRING = 8;
export const CN_JOINT_BREAKS = 16;
export const CN_CONSTRAINT_ANGLE = 0;
export const CN_CONSTRAINT_LINE = 1;
export const CN_CONSTRAINT_LIMIT = 1;
export const CN_CONSTRAINT_BREAKS = 2;
export const CN_QUERY_SKIP = 0;
export const CN_QUERY_TAKE = 1;
export const CN_QUERY_STOP = 2;
export const CN_QUERY_IGNORE_JOINED = 1;
export const CN_QUERY_ONE_WAY = 2;
export const CN_QUERY_LEAVING = 4;
export const CN_IMPACT_NONE = 0;
export const CN_IMPACT_HIT = 1;
export const CN_IMPACT_OVERLAP = 2;
export const CN_IMPACT_FAILED = 3;
export const CN_MOVER_DROP = 1;
export const CN_MOVER_ON_GROUND = 1;
export const CN_MOVER_ON_WALL = 2;
export const CN_MOVER_ON_CEILING = 4;
export const CN_AREA_REPLACE = 1;
export const CN_DRAW_SHAPES = 1;
export const CN_DRAW_JOINTS = 2;
export const CN_DRAW_CONTACTS = 4;
export const CN_DRAW_AABBS = 8;
export const CN_DRAW_CENTERS = 16;
export const CN_DRAW_ISLANDS = 32;

const STRUCTS = {
	cn_vec2: { size: 8, init: null, floats: true, fields: [["x", 0, "f32", 0], ["y", 4, "f32", 0]] },
	cn_pose: { size: 16, init: null, floats: true, fields: [["position_m", 0, "cn_vec2", 0], ["cosine", 8, "f32", 0], ["sine", 12, "f32", 0]] },
	cn_velocity: { size: 12, init: null, floats: true, fields: [["linear_mps", 0, "cn_vec2", 0], ["angular_radps", 8, "f32", 0]] },
	cn_aabb: { size: 16, init: null, floats: false, fields: [["lower_m", 0, "cn_vec2", 0], ["upper_m", 8, "cn_vec2", 0]] },
	cn_mass_data: { size: 16, init: null, floats: false, fields: [["mass_kg", 0, "f32", 0], ["inertia_kgm2", 4, "f32", 0], ["center_m", 8, "cn_vec2", 0]] },
	cn_world_def: { size: 152, init: "cn_world_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["gravity_mps2", 8, "cn_vec2", 0], ["length_unit_m", 16, "f32", 0], ["solver", 20, "i32", 0], ["broadphase", 24, "i32", 0], ["substep_count", 28, "i32", 0], ["accuracy_m", 32, "f32", 0], ["work_budget", 36, "i32", 0], ["restitution_threshold_mps", 40, "f32", 0], ["push_speed_max_mps", 44, "f32", 0], ["linear_speed_max_mps", 48, "f32", 0], ["angular_speed_max_radps", 52, "f32", 0], ["sleep_speed_mps", 56, "f32", 0], ["sleep_delay_s", 60, "f32", 0], ["body_capacity", 64, "i32", 0], ["shape_capacity", 68, "i32", 0], ["contact_capacity", 72, "i32", 0], ["joint_capacity", 76, "i32", 0], ["user_data", 80, "u64", 0], ["memory_bytes", 88, "u64", 0], ["worker_count", 124, "i32", 0], ["hit_speed_mps", 128, "f32", 0], ["touching_capacity", 132, "i32", 0], ["event_capacity", 136, "i32", 0], ["vertex_capacity", 140, "i32", 0], ["reserve", 144, "u32", 0]] },
	cn_counters: { size: 84, init: null, floats: false, fields: [["bodies", 0, "i32", 0], ["bodies_awake", 4, "i32", 0], ["shapes", 8, "i32", 0], ["proxies", 12, "i32", 0], ["contacts", 16, "i32", 0], ["contacts_awake", 20, "i32", 0], ["contacts_touching", 24, "i32", 0], ["joints", 28, "i32", 0], ["joints_awake", 32, "i32", 0], ["islands", 36, "i32", 0], ["islands_awake", 40, "i32", 0], ["colors_used", 44, "i32", 0], ["overflow_contacts", 48, "i32", 0], ["broadphase_tiles", 52, "i32", 0], ["steps", 56, "u32", 0], ["warnings", 60, "u32", 0], ["pairs_not_added", 64, "i32", 0], ["events_not_reported", 68, "i32", 0], ["islands_direct", 72, "i32", 0], ["direct_work", 76, "i32", 0], ["islands_unsolved", 80, "i32", 0]] },
	cn_island_report: { size: 32, init: null, floats: false, fields: [["body", 0, "u32", 0], ["bodies", 4, "i32", 0], ["contacts", 8, "i32", 0], ["joints", 12, "i32", 0], ["tier", 16, "i32", 0], ["reason", 20, "i32", 0], ["substeps", 24, "i32", 0], ["residual_m", 28, "f32", 0]] },
	cn_profile: { size: 40, init: null, floats: false, fields: [["step_s", 0, "f32", 0], ["wake_s", 4, "f32", 0], ["broadphase_s", 8, "f32", 0], ["narrowphase_s", 12, "f32", 0], ["islands_s", 16, "f32", 0], ["prepare_s", 20, "f32", 0], ["substeps_s", 24, "f32", 0], ["finalize_s", 28, "f32", 0], ["events_s", 32, "f32", 0], ["sleep_s", 36, "f32", 0]] },
	cn_memory_stats: { size: 72, init: null, floats: false, fields: [["bytes_in_use", 0, "u64", 0], ["bytes_peak", 8, "u64", 0], ["allocator_calls", 16, "u64", 0], ["arena_capacity", 24, "u64", 0], ["arena_peak", 32, "u64", 0], ["arena_fallbacks", 40, "u64", 0], ["blocks_capacity", 48, "u64", 0], ["blocks_in_use", 56, "u64", 0], ["blocks_large", 64, "u64", 0]] },
	cn_body_def: { size: 72, init: "cn_body_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["type", 4, "i32", 0], ["position_m", 8, "cn_vec2", 0], ["angle_rad", 16, "f32", 0], ["linear_velocity_mps", 20, "cn_vec2", 0], ["angular_velocity_radps", 28, "f32", 0], ["linear_damping_per_s", 32, "f32", 0], ["angular_damping_per_s", 36, "f32", 0], ["gravity_scale", 40, "f32", 0], ["sleep_speed_mps", 44, "f32", 0], ["flags", 48, "u32", 0], ["solver", 52, "i32", 0], ["user_data", 56, "u64", 0], ["name", 64, "string", 0]] },
	cn_body_moved: { size: 32, init: null, floats: false, fields: [["pose", 0, "cn_pose", 0], ["user_data", 16, "u64", 0], ["body", 24, "u32", 0], ["fell_asleep", 28, "u32", 0]] },
	cn_filter: { size: 24, init: null, floats: false, fields: [["category", 0, "u64", 0], ["mask", 8, "u64", 0], ["group", 16, "i32", 0], ["reserved", 20, "u32", 0]] },
	cn_material: { size: 32, init: null, floats: false, fields: [["static_friction", 0, "f32", 0], ["dynamic_friction", 4, "f32", 0], ["restitution", 8, "f32", 0], ["rolling_resistance", 12, "f32", 0], ["tangent_speed_mps", 16, "f32", 0], ["friction_mix", 20, "i32", 0], ["restitution_mix", 24, "i32", 0], ["user_id", 28, "u32", 0]] },
	cn_shape_def: { size: 96, init: "cn_shape_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["body", 4, "u32", 0], ["offset_m", 8, "cn_vec2", 0], ["angle_rad", 16, "f32", 0], ["density_kgpm2", 20, "f32", 0], ["material", 24, "cn_material", 0], ["filter", 56, "cn_filter", 0], ["event_mask", 80, "u32", 0], ["flags", 84, "u32", 0], ["user_data", 88, "u64", 0]] },
	cn_circle: { size: 12, init: null, floats: false, fields: [["center_m", 0, "cn_vec2", 0], ["radius_m", 8, "f32", 0]] },
	cn_capsule: { size: 20, init: null, floats: false, fields: [["a_m", 0, "cn_vec2", 0], ["b_m", 8, "cn_vec2", 0], ["radius_m", 16, "f32", 0]] },
	cn_edge: { size: 16, init: null, floats: false, fields: [["a_m", 0, "cn_vec2", 0], ["b_m", 8, "cn_vec2", 0]] },
	cn_polygon: { size: 136, init: null, floats: false, fields: [["count", 0, "i32", 0], ["radius_m", 4, "f32", 0], ["points_m", 8, "cn_vec2", 16]] },
	cn_chain: { size: 12, init: null, floats: false, fields: [["points_m", 0, "array:cn_vec2", 0, "count"], ["count", 4, "i32", 0], ["loop", 8, "u32", 0]] },
	cn_manifold_point: { size: 20, init: null, floats: false, fields: [["point_m", 0, "cn_vec2", 0], ["separation_m", 8, "f32", 0], ["normal_impulse_Ns", 12, "f32", 0], ["feature_id", 16, "u32", 0]] },
	cn_manifold: { size: 56, init: null, floats: false, fields: [["normal", 0, "cn_vec2", 0], ["friction_impulse_Ns", 8, "f32", 0], ["point_count", 12, "i32", 0], ["points", 16, "cn_manifold_point", 2]] },
	cn_contact_event: { size: 116, init: null, floats: false, fields: [["shape_a", 0, "u32", 0], ["shape_b", 4, "u32", 0], ["body_a", 8, "u32", 0], ["body_b", 12, "u32", 0], ["child_a", 16, "i32", 0], ["child_b", 20, "i32", 0], ["contact_id", 24, "u32", 0], ["kind", 28, "i32", 0], ["approach_speed_mps", 32, "f32", 0], ["manifold", 36, "cn_manifold", 0], ["normal_impulse_Ns", 92, "f32", 0], ["friction_impulse_Ns", 96, "f32", 0], ["hit_point_m", 100, "cn_vec2", 0], ["material_a", 108, "u32", 0], ["material_b", 112, "u32", 0]] },
	cn_sensor_event: { size: 24, init: null, floats: false, fields: [["sensor", 0, "u32", 0], ["visitor", 4, "u32", 0], ["sensor_body", 8, "u32", 0], ["visitor_body", 12, "u32", 0], ["kind", 16, "i32", 0], ["reserved", 20, "u32", 0]] },
	cn_joint_base: { size: 64, init: null, floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["body_a", 8, "u32", 0], ["body_b", 12, "u32", 0], ["anchor_a_m", 16, "cn_vec2", 0], ["anchor_b_m", 24, "cn_vec2", 0], ["stiffness_hertz", 32, "f32", 0], ["stiffness_damping_ratio", 36, "f32", 0], ["force_max_N", 40, "f32", 0], ["torque_max_Nm", 44, "f32", 0], ["break_force_N", 48, "f32", 0], ["break_torque_Nm", 52, "f32", 0], ["user_data", 56, "u64", 0]] },
	cn_revolute_def: { size: 96, init: "cn_revolute_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["reference_angle_rad", 64, "f32", 0], ["lower_angle_rad", 68, "f32", 0], ["upper_angle_rad", 72, "f32", 0], ["motor_speed_radps", 76, "f32", 0], ["motor_torque_max_Nm", 80, "f32", 0], ["spring_target_rad", 84, "f32", 0], ["spring_hertz", 88, "f32", 0], ["spring_damping_ratio", 92, "f32", 0]] },
	cn_distance_def: { size: 96, init: "cn_distance_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["length_m", 64, "f32", 0], ["length_min_m", 68, "f32", 0], ["length_max_m", 72, "f32", 0], ["motor_speed_mps", 76, "f32", 0], ["motor_force_max_N", 80, "f32", 0], ["spring_hertz", 84, "f32", 0], ["spring_damping_ratio", 88, "f32", 0], ["reserved", 92, "f32", 0]] },
	cn_fixed_def: { size: 80, init: "cn_fixed_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["reference_angle_rad", 64, "f32", 0], ["angular_hertz", 68, "f32", 0], ["angular_damping_ratio", 72, "f32", 0], ["reserved", 76, "f32", 0]] },
	cn_prismatic_def: { size: 104, init: "cn_prismatic_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["axis", 64, "cn_vec2", 0], ["reference_angle_rad", 72, "f32", 0], ["lower_m", 76, "f32", 0], ["upper_m", 80, "f32", 0], ["motor_speed_mps", 84, "f32", 0], ["motor_force_max_N", 88, "f32", 0], ["spring_target_m", 92, "f32", 0], ["spring_hertz", 96, "f32", 0], ["spring_damping_ratio", 100, "f32", 0]] },
	cn_wheel_def: { size: 96, init: "cn_wheel_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["axis", 64, "cn_vec2", 0], ["lower_m", 72, "f32", 0], ["upper_m", 76, "f32", 0], ["motor_speed_radps", 80, "f32", 0], ["motor_torque_max_Nm", 84, "f32", 0], ["spring_hertz", 88, "f32", 0], ["spring_damping_ratio", 92, "f32", 0]] },
	cn_motor_def: { size: 88, init: "cn_motor_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["offset_m", 64, "cn_vec2", 0], ["angle_rad", 72, "f32", 0], ["hertz", 76, "f32", 0], ["damping_ratio", 80, "f32", 0], ["reserved", 84, "f32", 0]] },
	cn_mouse_def: { size: 80, init: "cn_mouse_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["target_m", 64, "cn_vec2", 0], ["hertz", 72, "f32", 0], ["damping_ratio", 76, "f32", 0]] },
	cn_gear_def: { size: 72, init: "cn_gear_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["ratio", 64, "f32", 0], ["phase_rad", 68, "f32", 0]] },
	cn_pulley_def: { size: 88, init: "cn_pulley_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["ground_a_m", 64, "cn_vec2", 0], ["ground_b_m", 72, "cn_vec2", 0], ["ratio", 80, "f32", 0], ["length_m", 84, "f32", 0]] },
	cn_ratchet_def: { size: 72, init: "cn_ratchet_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["phase_rad", 64, "f32", 0], ["click_rad", 68, "f32", 0]] },
	cn_rotary_spring_def: { size: 80, init: "cn_rotary_spring_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["rest_angle_rad", 64, "f32", 0], ["hertz", 68, "f32", 0], ["damping_ratio", 72, "f32", 0], ["reserved", 76, "f32", 0]] },
	cn_groove_def: { size: 72, init: "cn_groove_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0], ["end_m", 64, "cn_vec2", 0]] },
	cn_filter_joint_def: { size: 64, init: "cn_filter_joint_def_init", floats: false, fields: [["base", 0, "cn_joint_base", 0]] },
	cn_joint_event: { size: 40, init: null, floats: false, fields: [["joint", 0, "u32", 0], ["constraint", 4, "u32", 0], ["body_a", 8, "u32", 0], ["body_b", 12, "u32", 0], ["force_N", 16, "f32", 0], ["torque_Nm", 20, "f32", 0], ["destroyed", 24, "u32", 0], ["reserved", 28, "u32", 0], ["user_data", 32, "u64", 0]] },
	cn_angle_constraint_def: { size: 40, init: "cn_angle_constraint_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["body", 8, "u32", 0], ["lower_rad", 12, "f32", 0], ["upper_rad", 16, "f32", 0], ["hertz", 20, "f32", 0], ["damping_ratio", 24, "f32", 0], ["break_torque_Nm", 28, "f32", 0], ["user_data", 32, "u64", 0]] },
	cn_line_constraint_def: { size: 72, init: "cn_line_constraint_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["body", 8, "u32", 0], ["anchor_m", 12, "cn_vec2", 0], ["origin_m", 20, "cn_vec2", 0], ["axis", 28, "cn_vec2", 0], ["tolerance_m", 36, "f32", 0], ["lower_m", 40, "f32", 0], ["upper_m", 44, "f32", 0], ["hertz", 48, "f32", 0], ["damping_ratio", 52, "f32", 0], ["break_force_N", 56, "f32", 0], ["reserved", 60, "u32", 0], ["user_data", 64, "u64", 0]] },
	cn_update_report: { size: 16, init: null, floats: false, fields: [["steps", 0, "i32", 0], ["leftover_s", 4, "f32", 0], ["dropped_s", 8, "f32", 0], ["interpolation", 12, "f32", 0]] },
	cn_ray: { size: 16, init: null, floats: false, fields: [["origin_m", 0, "cn_vec2", 0], ["translation_m", 8, "cn_vec2", 0]] },
	cn_ray_hit: { size: 40, init: null, floats: false, fields: [["shape", 0, "u32", 0], ["body", 4, "u32", 0], ["child", 8, "i32", 0], ["fraction", 12, "f32", 0], ["point_m", 16, "cn_vec2", 0], ["normal", 24, "cn_vec2", 0], ["depth_m", 32, "f32", 0], ["reserved", 36, "u32", 0]] },
	cn_query_filter: { size: 32, init: "cn_query_filter_init", floats: false, fields: [["category", 0, "u64", 0], ["mask", 8, "u64", 0], ["ignored_body", 16, "u32", 0], ["flags", 20, "u32", 0]] },
	cn_closest: { size: 32, init: null, floats: false, fields: [["shape", 0, "u32", 0], ["body", 4, "u32", 0], ["child", 8, "i32", 0], ["distance_m", 12, "f32", 0], ["point_m", 16, "cn_vec2", 0], ["normal", 24, "cn_vec2", 0]] },
	cn_distance: { size: 32, init: null, floats: false, fields: [["point_a_m", 0, "cn_vec2", 0], ["point_b_m", 8, "cn_vec2", 0], ["normal", 16, "cn_vec2", 0], ["distance_m", 24, "f32", 0], ["reserved", 28, "u32", 0]] },
	cn_sweep: { size: 40, init: null, floats: false, fields: [["start", 0, "cn_pose", 0], ["center_m", 16, "cn_vec2", 0], ["translation_m", 24, "cn_vec2", 0], ["turn_rad", 32, "f32", 0], ["reserved", 36, "u32", 0]] },
	cn_impact: { size: 32, init: null, floats: false, fields: [["state", 0, "i32", 0], ["fraction", 4, "f32", 0], ["point_m", 8, "cn_vec2", 0], ["normal", 16, "cn_vec2", 0], ["distance_m", 24, "f32", 0], ["reserved", 28, "u32", 0]] },
	cn_plane: { size: 40, init: null, floats: false, fields: [["normal", 0, "cn_vec2", 0], ["point_m", 8, "cn_vec2", 0], ["separation_m", 16, "f32", 0], ["push_max_m", 20, "f32", 0], ["push_m", 24, "f32", 0], ["shape", 28, "u32", 0], ["body", 32, "u32", 0], ["child", 36, "i32", 0]] },
	cn_mover_def: { size: 208, init: "cn_mover_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["shape", 8, "cn_polygon", 0], ["filter", 144, "cn_query_filter", 0], ["up", 176, "cn_vec2", 0], ["slope_limit_rad", 184, "f32", 0], ["step_height_m", 188, "f32", 0], ["snap_m", 192, "f32", 0], ["gravity_scale", 196, "f32", 0], ["push_force_N", 200, "f32", 0], ["iterations_max", 204, "i32", 0]] },
	cn_mover: { size: 64, init: null, floats: false, fields: [["position_m", 0, "cn_vec2", 0], ["velocity_mps", 8, "cn_vec2", 0], ["ground_normal", 16, "cn_vec2", 0], ["ground_point_m", 24, "cn_vec2", 0], ["ground_local_m", 32, "cn_vec2", 0], ["ground_velocity_mps", 40, "cn_vec2", 0], ["ground_body", 48, "u32", 0], ["ground_shape", 52, "u32", 0], ["flags", 56, "u32", 0], ["squeezed_m", 60, "f32", 0]] },
	cn_area_def: { size: 64, init: "cn_area_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["priority", 8, "i32", 0], ["gravity_mps2", 12, "cn_vec2", 0], ["center_m", 20, "cn_vec2", 0], ["pull_mps2", 28, "f32", 0], ["pull_distance_m", 32, "f32", 0], ["linear_damping_per_s", 36, "f32", 0], ["angular_damping_per_s", 40, "f32", 0], ["density_kgpm2", 44, "f32", 0], ["drag_kgpm2", 48, "f32", 0], ["lift_kgpm2", 52, "f32", 0], ["flow_mps", 56, "cn_vec2", 0]] },
	cn_explosion_def: { size: 56, init: "cn_explosion_def_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["radius_m", 4, "f32", 0], ["falloff_m", 8, "f32", 0], ["impulse_Nspm", 12, "f32", 0], ["center_m", 16, "cn_vec2", 0], ["filter", 24, "cn_query_filter", 0]] },
	cn_debug_draw: { size: 56, init: "cn_debug_draw_init", floats: false, fields: [["struct_size", 0, "u32", 0], ["flags", 4, "u32", 0], ["view", 8, "cn_aabb", 0]] },
};
for (const name in STRUCTS)
	STRUCTS[name].names = new Set(STRUCTS[name].fields.map(field => field[0]));
if (raw.cn_abi_version() !== CN_ABI_VERSION)
	throw new Error(`cairn.js is for ABI ${CN_ABI_VERSION}, cairn.wasm has ${raw.cn_abi_version()}`);
for (const [name, type] of [["cn_vec2", CN_TYPE_VEC2], ["cn_pose", CN_TYPE_POSE], ["cn_velocity", CN_TYPE_VELOCITY], ["cn_aabb", CN_TYPE_AABB], ["cn_mass_data", CN_TYPE_MASS_DATA], ["cn_world_def", CN_TYPE_WORLD_DEF], ["cn_counters", CN_TYPE_COUNTERS], ["cn_island_report", CN_TYPE_ISLAND_REPORT], ["cn_profile", CN_TYPE_PROFILE], ["cn_memory_stats", CN_TYPE_MEMORY_STATS], ["cn_body_def", CN_TYPE_BODY_DEF], ["cn_body_moved", CN_TYPE_BODY_MOVED], ["cn_filter", CN_TYPE_FILTER], ["cn_material", CN_TYPE_MATERIAL], ["cn_shape_def", CN_TYPE_SHAPE_DEF], ["cn_circle", CN_TYPE_CIRCLE], ["cn_capsule", CN_TYPE_CAPSULE], ["cn_edge", CN_TYPE_EDGE], ["cn_polygon", CN_TYPE_POLYGON], ["cn_chain", CN_TYPE_CHAIN], ["cn_manifold_point", CN_TYPE_MANIFOLD_POINT], ["cn_manifold", CN_TYPE_MANIFOLD], ["cn_contact_event", CN_TYPE_CONTACT_EVENT], ["cn_sensor_event", CN_TYPE_SENSOR_EVENT], ["cn_joint_base", CN_TYPE_JOINT_BASE], ["cn_revolute_def", CN_TYPE_REVOLUTE_DEF], ["cn_distance_def", CN_TYPE_DISTANCE_DEF], ["cn_fixed_def", CN_TYPE_FIXED_DEF], ["cn_prismatic_def", CN_TYPE_PRISMATIC_DEF], ["cn_wheel_def", CN_TYPE_WHEEL_DEF], ["cn_motor_def", CN_TYPE_MOTOR_DEF], ["cn_mouse_def", CN_TYPE_MOUSE_DEF], ["cn_gear_def", CN_TYPE_GEAR_DEF], ["cn_pulley_def", CN_TYPE_PULLEY_DEF], ["cn_ratchet_def", CN_TYPE_RATCHET_DEF], ["cn_rotary_spring_def", CN_TYPE_ROTARY_SPRING_DEF], ["cn_groove_def", CN_TYPE_GROOVE_DEF], ["cn_filter_joint_def", CN_TYPE_FILTER_JOINT_DEF], ["cn_joint_event", CN_TYPE_JOINT_EVENT], ["cn_angle_constraint_def", CN_TYPE_ANGLE_CONSTRAINT_DEF], ["cn_line_constraint_def", CN_TYPE_LINE_CONSTRAINT_DEF], ["cn_update_report", CN_TYPE_UPDATE_REPORT], ["cn_ray", CN_TYPE_RAY], ["cn_ray_hit", CN_TYPE_RAY_HIT], ["cn_query_filter", CN_TYPE_QUERY_FILTER], ["cn_closest", CN_TYPE_CLOSEST], ["cn_distance", CN_TYPE_DISTANCE], ["cn_sweep", CN_TYPE_SWEEP], ["cn_impact", CN_TYPE_IMPACT], ["cn_plane", CN_TYPE_PLANE], ["cn_mover_def", CN_TYPE_MOVER_DEF], ["cn_mover", CN_TYPE_MOVER], ["cn_area_def", CN_TYPE_AREA_DEF], ["cn_explosion_def", CN_TYPE_EXPLOSION_DEF], ["cn_debug_draw", CN_TYPE_DEBUG_DRAW]])
	if (STRUCTS[name].size !== raw.cn_sizeof(type))
		throw new Error(`${name} has another size in cairn.wasm`);

export class World {
	#pointer;
	constructor(def = {}, file = null) {
		begin();
		const out = take(4), given = struct("cn_world_def", def);
		check(file ? raw.cn_world_read(given, array("u8", file), BigInt(file.length), out) : raw.cn_world_create(given, out));
		refresh();
		this.#pointer = view.getUint32(out, true);
		worlds.register(this, this.#pointer, this);
	}
	static read(file, def = {}) {
		return new World(def, file);
	}
	get pointer() {
		if (this.#pointer === 0)
			throw new TypeError("the world is destroyed");
		return this.#pointer;
	}
	destroy() {
		worlds.unregister(this);
		raw.cn_world_destroy(this.#pointer);
		this.#pointer = 0;
	}

	step(dt_s) {
		begin();
		check(raw.cn_world_step(this.pointer, dt_s), this.pointer);
	}

	setGravity(gravity_x_mps2, gravity_y_mps2) {
		begin();
		check(raw.cn_world_set_gravity(this.pointer, gravity_x_mps2, gravity_y_mps2), this.pointer);
	}

	getGravity() {
		begin();
		const o_mps2 = take(stride("cn_vec2"));
		check(raw.cn_world_get_gravity(this.pointer, o_mps2));
		refresh();
		return readStruct("cn_vec2", o_mps2);
	}

	setSubstepCount(count) {
		begin();
		check(raw.cn_world_set_substep_count(this.pointer, count), this.pointer);
	}

	getSubstepCount() {
		begin();
		const o_count = take(stride("i32"));
		check(raw.cn_world_get_substep_count(this.pointer, o_count));
		refresh();
		return READ.i32(o_count);
	}

	setSolver(solver) {
		begin();
		check(raw.cn_world_set_solver(this.pointer, solver), this.pointer);
	}

	getSolver() {
		begin();
		const o_solver = take(stride("i32"));
		check(raw.cn_world_get_solver(this.pointer, o_solver));
		refresh();
		return READ.i32(o_solver);
	}

	setAccuracy(accuracy_m, work_budget) {
		begin();
		check(raw.cn_world_set_accuracy(this.pointer, accuracy_m, work_budget), this.pointer);
	}

	getAccuracy() {
		begin();
		const o_accuracy_m = take(stride("f32"));
		const o_work_budget = take(stride("i32"));
		check(raw.cn_world_get_accuracy(this.pointer, o_accuracy_m, o_work_budget));
		refresh();
		return { accuracy_m: READ.f32(o_accuracy_m), work_budget: READ.i32(o_work_budget) };
	}

	getWorkerCount() {
		begin();
		const o_count = take(stride("i32"));
		check(raw.cn_world_get_worker_count(this.pointer, o_count));
		refresh();
		return READ.i32(o_count);
	}

	setFlags(flags) {
		begin();
		check(raw.cn_world_set_flags(this.pointer, flags), this.pointer);
	}

	getFlags() {
		begin();
		const o_flags = take(stride("u32"));
		check(raw.cn_world_get_flags(this.pointer, o_flags));
		refresh();
		return READ.u32(o_flags);
	}

	setRestitutionThreshold(speed_mps) {
		begin();
		check(raw.cn_world_set_restitution_threshold(this.pointer, speed_mps), this.pointer);
	}

	setHitSpeed(speed_mps) {
		begin();
		check(raw.cn_world_set_hit_speed(this.pointer, speed_mps), this.pointer);
	}

	setSpeedLimits(linear_mps, angular_radps) {
		begin();
		check(raw.cn_world_set_speed_limits(this.pointer, linear_mps, angular_radps), this.pointer);
	}

	setSleep(speed_mps, delay_s) {
		begin();
		check(raw.cn_world_set_sleep(this.pointer, speed_mps, delay_s), this.pointer);
	}

	setUserData(user_data) {
		begin();
		check(raw.cn_world_set_user_data(this.pointer, BigInt(user_data)), this.pointer);
	}

	getUserData() {
		begin();
		const o_user_data = take(stride("u64"));
		check(raw.cn_world_get_user_data(this.pointer, o_user_data));
		refresh();
		return READ.u64(o_user_data);
	}

	getBodies() {
		begin();
		const number = take(4);
		check(raw.cn_world_get_bodies(this.pointer, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_get_bodies(this.pointer, out, found, number));
		return list("u32", out, found);
	}

	getShapes() {
		begin();
		const number = take(4);
		check(raw.cn_world_get_shapes(this.pointer, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_get_shapes(this.pointer, out, found, number));
		return list("u32", out, found);
	}

	getJoints() {
		begin();
		const number = take(4);
		check(raw.cn_world_get_joints(this.pointer, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_get_joints(this.pointer, out, found, number));
		return list("u32", out, found);
	}

	getCounters() {
		begin();
		const o_out = take(stride("cn_counters"));
		check(raw.cn_world_get_counters(this.pointer, o_out));
		refresh();
		return readStruct("cn_counters", o_out);
	}

	getIslands() {
		begin();
		const number = take(4);
		check(raw.cn_world_get_islands(this.pointer, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("cn_island_report") * found || 1);
		if (found > 0)
			check(raw.cn_world_get_islands(this.pointer, out, found, number));
		return list("cn_island_report", out, found);
	}

	getProfile() {
		begin();
		const o_out = take(stride("cn_profile"));
		check(raw.cn_world_get_profile(this.pointer, o_out));
		refresh();
		return readStruct("cn_profile", o_out);
	}

	getMemoryStats() {
		begin();
		const o_out = take(stride("cn_memory_stats"));
		check(raw.cn_world_get_memory_stats(this.pointer, o_out));
		refresh();
		return readStruct("cn_memory_stats", o_out);
	}

	shiftOrigin(x_m, y_m) {
		begin();
		check(raw.cn_world_shift_origin(this.pointer, x_m, y_m), this.pointer);
	}

	hash() {
		begin();
		const o_hash = take(stride("u64"));
		check(raw.cn_world_hash(this.pointer, o_hash));
		refresh();
		return READ.u64(o_hash);
	}

	saveSize() {
		begin();
		const o_bytes = take(stride("u64"));
		check(raw.cn_world_save_size(this.pointer, o_bytes));
		refresh();
		return READ.u64(o_bytes);
	}

	save() {
		begin();
		const number = take(8);
		check(raw.cn_world_save_size(this.pointer, number));
		refresh();
		const bytes = view.getBigUint64(number, true), out = take(Number(bytes) || 1);
		check(raw.cn_world_save(this.pointer, out, bytes, number));
		refresh();
		return u8.slice(out, out + Number(view.getBigUint64(number, true)));
	}

	restore(save) {
		begin();
		const p_save = array("u8", save);
		check(raw.cn_world_restore(this.pointer, p_save, BigInt(save.length)), this.pointer);
	}

	writeSize() {
		begin();
		const o_bytes = take(stride("u64"));
		check(raw.cn_world_write_size(this.pointer, o_bytes));
		refresh();
		return READ.u64(o_bytes);
	}

	write() {
		begin();
		const number = take(8);
		check(raw.cn_world_write_size(this.pointer, number));
		refresh();
		const bytes = view.getBigUint64(number, true), out = take(Number(bytes) || 1);
		check(raw.cn_world_write(this.pointer, out, bytes, number));
		refresh();
		return u8.slice(out, out + Number(view.getBigUint64(number, true)));
	}

	bodyCreate(def) {
		begin();
		const p_def = struct("cn_body_def", def);
		const o_body = take(stride("u32"));
		check(raw.cn_body_create(this.pointer, p_def, o_body), this.pointer);
		refresh();
		return READ.u32(o_body);
	}

	bodyCreateMany(defs, out_bodies) {
		begin();
		const count = size("cn_body_def", defs);
		if (out_bodies)
			even(size("u32", out_bodies), count);
		const p_defs = array("cn_body_def", defs);
		const p_out_bodies = take(stride("u32") * count || 1);
		check(raw.cn_body_create_many(this.pointer, p_defs, count, p_out_bodies), this.pointer);
		return list("u32", p_out_bodies, count, out_bodies);
	}

	bodyDestroy(body) {
		begin();
		check(raw.cn_body_destroy(this.pointer, body), this.pointer);
	}

	bodyDestroyMany(bodies) {
		begin();
		const count = size("u32", bodies);
		const p_bodies = array("u32", bodies);
		check(raw.cn_body_destroy_many(this.pointer, p_bodies, count), this.pointer);
	}

	bodyIsValid(body) {
		begin();
		return raw.cn_body_is_valid(this.pointer, body) !== 0;
	}

	bodySetType(body, type) {
		begin();
		check(raw.cn_body_set_type(this.pointer, body, type), this.pointer);
	}

	bodyGetType(body) {
		begin();
		const o_type = take(stride("i32"));
		check(raw.cn_body_get_type(this.pointer, body, o_type));
		refresh();
		return READ.i32(o_type);
	}

	bodySetFlags(body, flags) {
		begin();
		check(raw.cn_body_set_flags(this.pointer, body, flags), this.pointer);
	}

	bodyGetFlags(body) {
		begin();
		const o_flags = take(stride("u32"));
		check(raw.cn_body_get_flags(this.pointer, body, o_flags));
		refresh();
		return READ.u32(o_flags);
	}

	bodySetAwake(body, awake) {
		begin();
		check(raw.cn_body_set_awake(this.pointer, body, awake), this.pointer);
	}

	bodySetPose(body, position_x_m, position_y_m, angle_rad) {
		begin();
		check(raw.cn_body_set_pose(this.pointer, body, position_x_m, position_y_m, angle_rad), this.pointer);
	}

	bodyGetPose(body) {
		begin();
		const o_out = take(stride("cn_pose"));
		check(raw.cn_body_get_pose(this.pointer, body, o_out));
		refresh();
		return readStruct("cn_pose", o_out);
	}

	bodyGetPositionParts(body) {
		begin();
		const o_high_m = take(stride("cn_vec2"));
		const o_low_m = take(stride("cn_vec2"));
		check(raw.cn_body_get_position_parts(this.pointer, body, o_high_m, o_low_m));
		refresh();
		return { high_m: readStruct("cn_vec2", o_high_m), low_m: readStruct("cn_vec2", o_low_m) };
	}

	bodyGetAngle(body) {
		begin();
		const o_rad = take(stride("f32"));
		check(raw.cn_body_get_angle(this.pointer, body, o_rad));
		refresh();
		return READ.f32(o_rad);
	}

	bodyGetCenter(body) {
		begin();
		const o_m = take(stride("cn_vec2"));
		check(raw.cn_body_get_center(this.pointer, body, o_m));
		refresh();
		return readStruct("cn_vec2", o_m);
	}

	bodySetVelocity(body, linear_x_mps, linear_y_mps, angular_radps) {
		begin();
		check(raw.cn_body_set_velocity(this.pointer, body, linear_x_mps, linear_y_mps, angular_radps), this.pointer);
	}

	bodyGetVelocity(body) {
		begin();
		const o_out = take(stride("cn_velocity"));
		check(raw.cn_body_get_velocity(this.pointer, body, o_out));
		refresh();
		return readStruct("cn_velocity", o_out);
	}

	bodySetTargetPose(body, position_x_m, position_y_m, angle_rad, dt_s) {
		begin();
		check(raw.cn_body_set_target_pose(this.pointer, body, position_x_m, position_y_m, angle_rad, dt_s), this.pointer);
	}

	bodyGetVelocityAt(body, point_x_m, point_y_m) {
		begin();
		const o_mps = take(stride("cn_vec2"));
		check(raw.cn_body_get_velocity_at(this.pointer, body, point_x_m, point_y_m, o_mps));
		refresh();
		return readStruct("cn_vec2", o_mps);
	}

	bodyGetWorldPoint(body, local_x_m, local_y_m) {
		begin();
		const o_m = take(stride("cn_vec2"));
		check(raw.cn_body_get_world_point(this.pointer, body, local_x_m, local_y_m, o_m));
		refresh();
		return readStruct("cn_vec2", o_m);
	}

	bodyGetLocalPoint(body, world_x_m, world_y_m) {
		begin();
		const o_m = take(stride("cn_vec2"));
		check(raw.cn_body_get_local_point(this.pointer, body, world_x_m, world_y_m, o_m));
		refresh();
		return readStruct("cn_vec2", o_m);
	}

	bodyGetAabb(body) {
		begin();
		const o_out = take(stride("cn_aabb"));
		check(raw.cn_body_get_aabb(this.pointer, body, o_out));
		refresh();
		return readStruct("cn_aabb", o_out);
	}

	bodyApplyForce(body, force_x_N, force_y_N) {
		begin();
		check(raw.cn_body_apply_force(this.pointer, body, force_x_N, force_y_N), this.pointer);
	}

	bodyApplyForceAt(body, force_x_N, force_y_N, point_x_m, point_y_m) {
		begin();
		check(raw.cn_body_apply_force_at(this.pointer, body, force_x_N, force_y_N, point_x_m, point_y_m), this.pointer);
	}

	bodyApplyTorque(body, torque_Nm) {
		begin();
		check(raw.cn_body_apply_torque(this.pointer, body, torque_Nm), this.pointer);
	}

	bodyApplyImpulse(body, impulse_x_Ns, impulse_y_Ns) {
		begin();
		check(raw.cn_body_apply_impulse(this.pointer, body, impulse_x_Ns, impulse_y_Ns), this.pointer);
	}

	bodyApplyImpulseAt(body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m) {
		begin();
		check(raw.cn_body_apply_impulse_at(this.pointer, body, impulse_x_Ns, impulse_y_Ns, point_x_m, point_y_m), this.pointer);
	}

	bodyApplyAngularImpulse(body, impulse_Nms) {
		begin();
		check(raw.cn_body_apply_angular_impulse(this.pointer, body, impulse_Nms), this.pointer);
	}

	bodyGetMassData(body) {
		begin();
		const o_out = take(stride("cn_mass_data"));
		check(raw.cn_body_get_mass_data(this.pointer, body, o_out));
		refresh();
		return readStruct("cn_mass_data", o_out);
	}

	bodySetMassData(body, mass) {
		begin();
		const p_mass = struct("cn_mass_data", mass);
		check(raw.cn_body_set_mass_data(this.pointer, body, p_mass), this.pointer);
	}

	bodyResetMassData(body) {
		begin();
		check(raw.cn_body_reset_mass_data(this.pointer, body), this.pointer);
	}

	bodySetDamping(body, linear_per_s, angular_per_s) {
		begin();
		check(raw.cn_body_set_damping(this.pointer, body, linear_per_s, angular_per_s), this.pointer);
	}

	bodyGetDamping(body) {
		begin();
		const o_linear_per_s = take(stride("f32"));
		const o_angular_per_s = take(stride("f32"));
		check(raw.cn_body_get_damping(this.pointer, body, o_linear_per_s, o_angular_per_s));
		refresh();
		return { linear_per_s: READ.f32(o_linear_per_s), angular_per_s: READ.f32(o_angular_per_s) };
	}

	bodySetGravityScale(body, scale) {
		begin();
		check(raw.cn_body_set_gravity_scale(this.pointer, body, scale), this.pointer);
	}

	bodyGetGravityScale(body) {
		begin();
		const o_scale = take(stride("f32"));
		check(raw.cn_body_get_gravity_scale(this.pointer, body, o_scale));
		refresh();
		return READ.f32(o_scale);
	}

	bodySetSleepSpeed(body, speed_mps) {
		begin();
		check(raw.cn_body_set_sleep_speed(this.pointer, body, speed_mps), this.pointer);
	}

	bodySetSolver(body, solver) {
		begin();
		check(raw.cn_body_set_solver(this.pointer, body, solver), this.pointer);
	}

	bodyGetSolver(body) {
		begin();
		const o_solver = take(stride("i32"));
		check(raw.cn_body_get_solver(this.pointer, body, o_solver));
		refresh();
		return READ.i32(o_solver);
	}

	bodySetUserData(body, user_data) {
		begin();
		check(raw.cn_body_set_user_data(this.pointer, body, BigInt(user_data)), this.pointer);
	}

	bodyGetUserData(body) {
		begin();
		const o_user_data = take(stride("u64"));
		check(raw.cn_body_get_user_data(this.pointer, body, o_user_data));
		refresh();
		return READ.u64(o_user_data);
	}

	bodySetName(body, name) {
		begin();
		const p_name = string(name);
		check(raw.cn_body_set_name(this.pointer, body, p_name), this.pointer);
	}

	bodyGetName(body) {
		begin();
		const o_name = take(8);
		check(raw.cn_body_get_name(this.pointer, body, o_name));
		refresh();
		return text(view.getUint32(o_name, true));
	}

	bodyGetShapes(body) {
		begin();
		const number = take(4);
		check(raw.cn_body_get_shapes(this.pointer, body, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_body_get_shapes(this.pointer, body, out, found, number));
		return list("u32", out, found);
	}

	bodyGetJoints(body) {
		begin();
		const number = take(4);
		check(raw.cn_body_get_joints(this.pointer, body, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_body_get_joints(this.pointer, body, out, found, number));
		return list("u32", out, found);
	}

	readPoses(bodies, out) {
		begin();
		const count = bodies ? size("u32", bodies) : out ? size("cn_pose", out) : this.getBodies().length;
		begin();
		if (out)
			even(size("cn_pose", out), count);
		const p_bodies = bodies ? array("u32", bodies) : 0;
		const p_out = take(stride("cn_pose") * count || 1);
		check(raw.cn_world_read_poses(this.pointer, p_bodies, count, p_out));
		return list("cn_pose", p_out, count, out);
	}

	readVelocities(bodies, out) {
		begin();
		const count = bodies ? size("u32", bodies) : out ? size("cn_velocity", out) : this.getBodies().length;
		begin();
		if (out)
			even(size("cn_velocity", out), count);
		const p_bodies = bodies ? array("u32", bodies) : 0;
		const p_out = take(stride("cn_velocity") * count || 1);
		check(raw.cn_world_read_velocities(this.pointer, p_bodies, count, p_out));
		return list("cn_velocity", p_out, count, out);
	}

	writeVelocities(velocities, bodies) {
		begin();
		const count = size("cn_velocity", velocities);
		if (bodies)
			even(size("u32", bodies), count);
		const p_bodies = bodies ? array("u32", bodies) : 0;
		const p_velocities = array("cn_velocity", velocities);
		check(raw.cn_world_write_velocities(this.pointer, p_bodies, count, p_velocities), this.pointer);
	}

	moved() {
		begin();
		const o_moved = take(8);
		check(raw.cn_world_moved(this.pointer, o_moved, o_moved + 4), this.pointer);
		refresh();
		return list("cn_body_moved", view.getUint32(o_moved, true), view.getInt32(o_moved + 4, true));
	}

	shapeCreateCircle(def, circle) {
		begin();
		const p_def = struct("cn_shape_def", def);
		const p_circle = struct("cn_circle", circle);
		const o_shape = take(stride("u32"));
		check(raw.cn_shape_create_circle(this.pointer, p_def, p_circle, o_shape), this.pointer);
		refresh();
		return READ.u32(o_shape);
	}

	shapeCreateCapsule(def, capsule) {
		begin();
		const p_def = struct("cn_shape_def", def);
		const p_capsule = struct("cn_capsule", capsule);
		const o_shape = take(stride("u32"));
		check(raw.cn_shape_create_capsule(this.pointer, p_def, p_capsule, o_shape), this.pointer);
		refresh();
		return READ.u32(o_shape);
	}

	shapeCreateEdge(def, edge) {
		begin();
		const p_def = struct("cn_shape_def", def);
		const p_edge = struct("cn_edge", edge);
		const o_shape = take(stride("u32"));
		check(raw.cn_shape_create_edge(this.pointer, p_def, p_edge, o_shape), this.pointer);
		refresh();
		return READ.u32(o_shape);
	}

	shapeCreatePolygon(def, polygon) {
		begin();
		const p_def = struct("cn_shape_def", def);
		const p_polygon = struct("cn_polygon", polygon);
		const o_shape = take(stride("u32"));
		check(raw.cn_shape_create_polygon(this.pointer, p_def, p_polygon, o_shape), this.pointer);
		refresh();
		return READ.u32(o_shape);
	}

	shapeCreateBox(def, half_width_m, half_height_m, radius_m) {
		begin();
		const p_def = struct("cn_shape_def", def);
		const o_shape = take(stride("u32"));
		check(raw.cn_shape_create_box(this.pointer, p_def, half_width_m, half_height_m, radius_m, o_shape), this.pointer);
		refresh();
		return READ.u32(o_shape);
	}

	shapeCreateChain(def, chain) {
		begin();
		const p_def = struct("cn_shape_def", def);
		const p_chain = struct("cn_chain", chain);
		const o_shape = take(stride("u32"));
		check(raw.cn_shape_create_chain(this.pointer, p_def, p_chain, o_shape), this.pointer);
		refresh();
		return READ.u32(o_shape);
	}

	shapeAttach(shape, body) {
		begin();
		check(raw.cn_shape_attach(this.pointer, shape, body), this.pointer);
	}

	shapeDetach(shape) {
		begin();
		check(raw.cn_shape_detach(this.pointer, shape), this.pointer);
	}

	shapeDestroy(shape) {
		begin();
		check(raw.cn_shape_destroy(this.pointer, shape), this.pointer);
	}

	shapeIsValid(shape) {
		begin();
		return raw.cn_shape_is_valid(this.pointer, shape) !== 0;
	}

	shapeGetType(shape) {
		begin();
		const o_type = take(stride("i32"));
		check(raw.cn_shape_get_type(this.pointer, shape, o_type));
		refresh();
		return READ.i32(o_type);
	}

	shapeGetBody(shape) {
		begin();
		const o_body = take(stride("u32"));
		check(raw.cn_shape_get_body(this.pointer, shape, o_body));
		refresh();
		return READ.u32(o_body);
	}

	shapeSetMaterial(shape, material) {
		begin();
		const p_material = struct("cn_material", material);
		check(raw.cn_shape_set_material(this.pointer, shape, p_material), this.pointer);
	}

	shapeGetMaterial(shape) {
		begin();
		const o_out = take(stride("cn_material"));
		check(raw.cn_shape_get_material(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_material", o_out);
	}

	shapeSetDensity(shape, density_kgpm2) {
		begin();
		check(raw.cn_shape_set_density(this.pointer, shape, density_kgpm2), this.pointer);
	}

	shapeGetDensity(shape) {
		begin();
		const o_kgpm2 = take(stride("f32"));
		check(raw.cn_shape_get_density(this.pointer, shape, o_kgpm2));
		refresh();
		return READ.f32(o_kgpm2);
	}

	shapeSetFilter(shape, filter) {
		begin();
		const p_filter = struct("cn_filter", filter);
		check(raw.cn_shape_set_filter(this.pointer, shape, p_filter), this.pointer);
	}

	shapeGetFilter(shape) {
		begin();
		const o_out = take(stride("cn_filter"));
		check(raw.cn_shape_get_filter(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_filter", o_out);
	}

	shapeSetEventMask(shape, event_mask) {
		begin();
		check(raw.cn_shape_set_event_mask(this.pointer, shape, event_mask), this.pointer);
	}

	shapeGetEventMask(shape) {
		begin();
		const o_event_mask = take(stride("u32"));
		check(raw.cn_shape_get_event_mask(this.pointer, shape, o_event_mask));
		refresh();
		return READ.u32(o_event_mask);
	}

	shapeSetFlags(shape, flags) {
		begin();
		check(raw.cn_shape_set_flags(this.pointer, shape, flags), this.pointer);
	}

	shapeGetFlags(shape) {
		begin();
		const o_flags = take(stride("u32"));
		check(raw.cn_shape_get_flags(this.pointer, shape, o_flags));
		refresh();
		return READ.u32(o_flags);
	}

	shapeSetUserData(shape, user_data) {
		begin();
		check(raw.cn_shape_set_user_data(this.pointer, shape, BigInt(user_data)), this.pointer);
	}

	shapeGetUserData(shape) {
		begin();
		const o_user_data = take(stride("u64"));
		check(raw.cn_shape_get_user_data(this.pointer, shape, o_user_data));
		refresh();
		return READ.u64(o_user_data);
	}

	shapeGetAabb(shape) {
		begin();
		const o_out = take(stride("cn_aabb"));
		check(raw.cn_shape_get_aabb(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_aabb", o_out);
	}

	shapeGetMassData(shape) {
		begin();
		const o_out = take(stride("cn_mass_data"));
		check(raw.cn_shape_get_mass_data(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_mass_data", o_out);
	}

	shapeGetCircle(shape) {
		begin();
		const o_out = take(stride("cn_circle"));
		check(raw.cn_shape_get_circle(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_circle", o_out);
	}

	shapeGetCapsule(shape) {
		begin();
		const o_out = take(stride("cn_capsule"));
		check(raw.cn_shape_get_capsule(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_capsule", o_out);
	}

	shapeGetEdge(shape) {
		begin();
		const o_out = take(stride("cn_edge"));
		check(raw.cn_shape_get_edge(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_edge", o_out);
	}

	shapeGetPolygon(shape) {
		begin();
		const o_out = take(stride("cn_polygon"));
		check(raw.cn_shape_get_polygon(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_polygon", o_out);
	}

	shapeGetChainPoints(shape) {
		begin();
		const number = take(4);
		check(raw.cn_shape_get_chain_points(this.pointer, shape, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("cn_vec2") * found || 1);
		if (found > 0)
			check(raw.cn_shape_get_chain_points(this.pointer, shape, out, found, number));
		return list("cn_vec2", out, found);
	}

	shapeSetCircle(shape, circle) {
		begin();
		const p_circle = struct("cn_circle", circle);
		check(raw.cn_shape_set_circle(this.pointer, shape, p_circle), this.pointer);
	}

	shapeSetCapsule(shape, capsule) {
		begin();
		const p_capsule = struct("cn_capsule", capsule);
		check(raw.cn_shape_set_capsule(this.pointer, shape, p_capsule), this.pointer);
	}

	shapeSetEdge(shape, edge) {
		begin();
		const p_edge = struct("cn_edge", edge);
		check(raw.cn_shape_set_edge(this.pointer, shape, p_edge), this.pointer);
	}

	shapeSetPolygon(shape, polygon) {
		begin();
		const p_polygon = struct("cn_polygon", polygon);
		check(raw.cn_shape_set_polygon(this.pointer, shape, p_polygon), this.pointer);
	}

	shapeSetChain(shape, chain) {
		begin();
		const p_chain = struct("cn_chain", chain);
		check(raw.cn_shape_set_chain(this.pointer, shape, p_chain), this.pointer);
	}

	shapeTestPoint(shape, point_x_m, point_y_m) {
		begin();
		const o_inside = take(stride("i32"));
		check(raw.cn_shape_test_point(this.pointer, shape, point_x_m, point_y_m, o_inside));
		refresh();
		return READ.i32(o_inside);
	}

	contactEvents(kind) {
		begin();
		const o_events = take(8);
		check(raw.cn_world_contact_events(this.pointer, kind, o_events, o_events + 4), this.pointer);
		refresh();
		return list("cn_contact_event", view.getUint32(o_events, true), view.getInt32(o_events + 4, true));
	}

	sensorEvents() {
		begin();
		const o_events = take(8);
		check(raw.cn_world_sensor_events(this.pointer, o_events, o_events + 4));
		refresh();
		return list("cn_sensor_event", view.getUint32(o_events, true), view.getInt32(o_events + 4, true));
	}

	bodyGetContacts(body) {
		begin();
		const number = take(4);
		check(raw.cn_body_get_contacts(this.pointer, body, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("cn_contact_event") * found || 1);
		if (found > 0)
			check(raw.cn_body_get_contacts(this.pointer, body, out, found, number));
		return list("cn_contact_event", out, found);
	}

	shapeGetContacts(shape) {
		begin();
		const number = take(4);
		check(raw.cn_shape_get_contacts(this.pointer, shape, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("cn_contact_event") * found || 1);
		if (found > 0)
			check(raw.cn_shape_get_contacts(this.pointer, shape, out, found, number));
		return list("cn_contact_event", out, found);
	}

	shapeGetVisitors(sensor) {
		begin();
		const number = take(4);
		check(raw.cn_shape_get_visitors(this.pointer, sensor, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_shape_get_visitors(this.pointer, sensor, out, found, number));
		return list("u32", out, found);
	}

	fellAsleep() {
		begin();
		const o_bodies = take(8);
		check(raw.cn_world_fell_asleep(this.pointer, o_bodies, o_bodies + 4));
		refresh();
		return list("u32", view.getUint32(o_bodies, true), view.getInt32(o_bodies + 4, true));
	}

	jointCreateRevolute(def) {
		begin();
		const p_def = struct("cn_revolute_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_revolute(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateDistance(def) {
		begin();
		const p_def = struct("cn_distance_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_distance(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateFixed(def) {
		begin();
		const p_def = struct("cn_fixed_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_fixed(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreatePrismatic(def) {
		begin();
		const p_def = struct("cn_prismatic_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_prismatic(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateWheel(def) {
		begin();
		const p_def = struct("cn_wheel_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_wheel(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateMotor(def) {
		begin();
		const p_def = struct("cn_motor_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_motor(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateMouse(def) {
		begin();
		const p_def = struct("cn_mouse_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_mouse(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateGear(def) {
		begin();
		const p_def = struct("cn_gear_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_gear(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreatePulley(def) {
		begin();
		const p_def = struct("cn_pulley_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_pulley(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateRatchet(def) {
		begin();
		const p_def = struct("cn_ratchet_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_ratchet(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateRotarySpring(def) {
		begin();
		const p_def = struct("cn_rotary_spring_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_rotary_spring(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateGroove(def) {
		begin();
		const p_def = struct("cn_groove_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_groove(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointCreateFilter(def) {
		begin();
		const p_def = struct("cn_filter_joint_def", def);
		const o_joint = take(stride("u32"));
		check(raw.cn_joint_create_filter(this.pointer, p_def, o_joint), this.pointer);
		refresh();
		return READ.u32(o_joint);
	}

	jointDestroy(joint) {
		begin();
		check(raw.cn_joint_destroy(this.pointer, joint), this.pointer);
	}

	jointIsValid(joint) {
		begin();
		return raw.cn_joint_is_valid(this.pointer, joint) !== 0;
	}

	jointGetType(joint) {
		begin();
		const o_type = take(stride("i32"));
		check(raw.cn_joint_get_type(this.pointer, joint, o_type));
		refresh();
		return READ.i32(o_type);
	}

	jointGetBodies(joint) {
		begin();
		const o_a = take(stride("u32"));
		const o_b = take(stride("u32"));
		check(raw.cn_joint_get_bodies(this.pointer, joint, o_a, o_b));
		refresh();
		return { a: READ.u32(o_a), b: READ.u32(o_b) };
	}

	jointGetAnchors(joint) {
		begin();
		const o_world_a_m = take(stride("cn_vec2"));
		const o_world_b_m = take(stride("cn_vec2"));
		check(raw.cn_joint_get_anchors(this.pointer, joint, o_world_a_m, o_world_b_m));
		refresh();
		return { world_a_m: readStruct("cn_vec2", o_world_a_m), world_b_m: readStruct("cn_vec2", o_world_b_m) };
	}

	jointGetReaction(joint) {
		begin();
		const o_force_N = take(stride("cn_vec2"));
		const o_torque_Nm = take(stride("f32"));
		check(raw.cn_joint_get_reaction(this.pointer, joint, o_force_N, o_torque_Nm));
		refresh();
		return { force_N: readStruct("cn_vec2", o_force_N), torque_Nm: READ.f32(o_torque_Nm) };
	}

	jointGetError(joint) {
		begin();
		const o_m = take(stride("f32"));
		const o_rad = take(stride("f32"));
		check(raw.cn_joint_get_error(this.pointer, joint, o_m, o_rad));
		refresh();
		return { m: READ.f32(o_m), rad: READ.f32(o_rad) };
	}

	jointSetSolver(joint, solver) {
		begin();
		check(raw.cn_joint_set_solver(this.pointer, joint, solver), this.pointer);
	}

	jointGetSolver(joint) {
		begin();
		const o_solver = take(stride("i32"));
		check(raw.cn_joint_get_solver(this.pointer, joint, o_solver));
		refresh();
		return READ.i32(o_solver);
	}

	jointSetUserData(joint, user_data) {
		begin();
		check(raw.cn_joint_set_user_data(this.pointer, joint, BigInt(user_data)), this.pointer);
	}

	jointGetUserData(joint) {
		begin();
		const o_user_data = take(stride("u64"));
		check(raw.cn_joint_get_user_data(this.pointer, joint, o_user_data));
		refresh();
		return READ.u64(o_user_data);
	}

	jointSetFlags(joint, flags) {
		begin();
		check(raw.cn_joint_set_flags(this.pointer, joint, flags), this.pointer);
	}

	jointGetFlags(joint) {
		begin();
		const o_flags = take(stride("u32"));
		check(raw.cn_joint_get_flags(this.pointer, joint, o_flags));
		refresh();
		return READ.u32(o_flags);
	}

	jointGetRevolute(joint) {
		begin();
		const o_out = take(stride("cn_revolute_def"));
		check(raw.cn_joint_get_revolute(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_revolute_def", o_out);
	}

	jointSetRevolute(joint, def) {
		begin();
		const p_def = struct("cn_revolute_def", def);
		check(raw.cn_joint_set_revolute(this.pointer, joint, p_def), this.pointer);
	}

	jointGetDistance(joint) {
		begin();
		const o_out = take(stride("cn_distance_def"));
		check(raw.cn_joint_get_distance(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_distance_def", o_out);
	}

	jointSetDistance(joint, def) {
		begin();
		const p_def = struct("cn_distance_def", def);
		check(raw.cn_joint_set_distance(this.pointer, joint, p_def), this.pointer);
	}

	jointGetFixed(joint) {
		begin();
		const o_out = take(stride("cn_fixed_def"));
		check(raw.cn_joint_get_fixed(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_fixed_def", o_out);
	}

	jointSetFixed(joint, def) {
		begin();
		const p_def = struct("cn_fixed_def", def);
		check(raw.cn_joint_set_fixed(this.pointer, joint, p_def), this.pointer);
	}

	jointGetPrismatic(joint) {
		begin();
		const o_out = take(stride("cn_prismatic_def"));
		check(raw.cn_joint_get_prismatic(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_prismatic_def", o_out);
	}

	jointSetPrismatic(joint, def) {
		begin();
		const p_def = struct("cn_prismatic_def", def);
		check(raw.cn_joint_set_prismatic(this.pointer, joint, p_def), this.pointer);
	}

	jointGetWheel(joint) {
		begin();
		const o_out = take(stride("cn_wheel_def"));
		check(raw.cn_joint_get_wheel(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_wheel_def", o_out);
	}

	jointSetWheel(joint, def) {
		begin();
		const p_def = struct("cn_wheel_def", def);
		check(raw.cn_joint_set_wheel(this.pointer, joint, p_def), this.pointer);
	}

	jointGetMotorTo(joint) {
		begin();
		const o_out = take(stride("cn_motor_def"));
		check(raw.cn_joint_get_motor_to(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_motor_def", o_out);
	}

	jointSetMotorTo(joint, def) {
		begin();
		const p_def = struct("cn_motor_def", def);
		check(raw.cn_joint_set_motor_to(this.pointer, joint, p_def), this.pointer);
	}

	jointGetMouse(joint) {
		begin();
		const o_out = take(stride("cn_mouse_def"));
		check(raw.cn_joint_get_mouse(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_mouse_def", o_out);
	}

	jointSetMouse(joint, def) {
		begin();
		const p_def = struct("cn_mouse_def", def);
		check(raw.cn_joint_set_mouse(this.pointer, joint, p_def), this.pointer);
	}

	jointGetGear(joint) {
		begin();
		const o_out = take(stride("cn_gear_def"));
		check(raw.cn_joint_get_gear(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_gear_def", o_out);
	}

	jointSetGear(joint, def) {
		begin();
		const p_def = struct("cn_gear_def", def);
		check(raw.cn_joint_set_gear(this.pointer, joint, p_def), this.pointer);
	}

	jointGetPulley(joint) {
		begin();
		const o_out = take(stride("cn_pulley_def"));
		check(raw.cn_joint_get_pulley(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_pulley_def", o_out);
	}

	jointSetPulley(joint, def) {
		begin();
		const p_def = struct("cn_pulley_def", def);
		check(raw.cn_joint_set_pulley(this.pointer, joint, p_def), this.pointer);
	}

	jointGetRatchet(joint) {
		begin();
		const o_out = take(stride("cn_ratchet_def"));
		check(raw.cn_joint_get_ratchet(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_ratchet_def", o_out);
	}

	jointSetRatchet(joint, def) {
		begin();
		const p_def = struct("cn_ratchet_def", def);
		check(raw.cn_joint_set_ratchet(this.pointer, joint, p_def), this.pointer);
	}

	jointGetRotarySpring(joint) {
		begin();
		const o_out = take(stride("cn_rotary_spring_def"));
		check(raw.cn_joint_get_rotary_spring(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_rotary_spring_def", o_out);
	}

	jointSetRotarySpring(joint, def) {
		begin();
		const p_def = struct("cn_rotary_spring_def", def);
		check(raw.cn_joint_set_rotary_spring(this.pointer, joint, p_def), this.pointer);
	}

	jointGetGroove(joint) {
		begin();
		const o_out = take(stride("cn_groove_def"));
		check(raw.cn_joint_get_groove(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_groove_def", o_out);
	}

	jointSetGroove(joint, def) {
		begin();
		const p_def = struct("cn_groove_def", def);
		check(raw.cn_joint_set_groove(this.pointer, joint, p_def), this.pointer);
	}

	jointGetBase(joint) {
		begin();
		const o_out = take(stride("cn_joint_base"));
		check(raw.cn_joint_get_base(this.pointer, joint, o_out));
		refresh();
		return readStruct("cn_joint_base", o_out);
	}

	jointSetBase(joint, base) {
		begin();
		const p_base = struct("cn_joint_base", base);
		check(raw.cn_joint_set_base(this.pointer, joint, p_base), this.pointer);
	}

	jointSetTarget(joint, target_x_m, target_y_m) {
		begin();
		check(raw.cn_joint_set_target(this.pointer, joint, target_x_m, target_y_m), this.pointer);
	}

	jointGetPosition(joint) {
		begin();
		const o_position = take(stride("f32"));
		check(raw.cn_joint_get_position(this.pointer, joint, o_position));
		refresh();
		return READ.f32(o_position);
	}

	jointGetSpeed(joint) {
		begin();
		const o_speed = take(stride("f32"));
		check(raw.cn_joint_get_speed(this.pointer, joint, o_speed));
		refresh();
		return READ.f32(o_speed);
	}

	jointSetMotor(joint, speed, force_or_torque_max) {
		begin();
		check(raw.cn_joint_set_motor(this.pointer, joint, speed, force_or_torque_max), this.pointer);
	}

	jointSetLimits(joint, lower, upper) {
		begin();
		check(raw.cn_joint_set_limits(this.pointer, joint, lower, upper), this.pointer);
	}

	jointEvents() {
		begin();
		const o_events = take(8);
		check(raw.cn_world_joint_events(this.pointer, o_events, o_events + 4));
		refresh();
		return list("cn_joint_event", view.getUint32(o_events, true), view.getInt32(o_events + 4, true));
	}

	constraintCreateAngle(def) {
		begin();
		const p_def = struct("cn_angle_constraint_def", def);
		const o_constraint = take(stride("u32"));
		check(raw.cn_constraint_create_angle(this.pointer, p_def, o_constraint), this.pointer);
		refresh();
		return READ.u32(o_constraint);
	}

	constraintCreateLine(def) {
		begin();
		const p_def = struct("cn_line_constraint_def", def);
		const o_constraint = take(stride("u32"));
		check(raw.cn_constraint_create_line(this.pointer, p_def, o_constraint), this.pointer);
		refresh();
		return READ.u32(o_constraint);
	}

	constraintDestroy(constraint) {
		begin();
		check(raw.cn_constraint_destroy(this.pointer, constraint), this.pointer);
	}

	constraintIsValid(constraint) {
		begin();
		return raw.cn_constraint_is_valid(this.pointer, constraint) !== 0;
	}

	constraintGetType(constraint) {
		begin();
		const o_type = take(stride("i32"));
		check(raw.cn_constraint_get_type(this.pointer, constraint, o_type));
		refresh();
		return READ.i32(o_type);
	}

	constraintGetBody(constraint) {
		begin();
		const o_body = take(stride("u32"));
		check(raw.cn_constraint_get_body(this.pointer, constraint, o_body));
		refresh();
		return READ.u32(o_body);
	}

	constraintGetAngle(constraint) {
		begin();
		const o_out = take(stride("cn_angle_constraint_def"));
		check(raw.cn_constraint_get_angle(this.pointer, constraint, o_out));
		refresh();
		return readStruct("cn_angle_constraint_def", o_out);
	}

	constraintSetAngle(constraint, def) {
		begin();
		const p_def = struct("cn_angle_constraint_def", def);
		check(raw.cn_constraint_set_angle(this.pointer, constraint, p_def), this.pointer);
	}

	constraintGetLine(constraint) {
		begin();
		const o_out = take(stride("cn_line_constraint_def"));
		check(raw.cn_constraint_get_line(this.pointer, constraint, o_out));
		refresh();
		return readStruct("cn_line_constraint_def", o_out);
	}

	constraintSetLine(constraint, def) {
		begin();
		const p_def = struct("cn_line_constraint_def", def);
		check(raw.cn_constraint_set_line(this.pointer, constraint, p_def), this.pointer);
	}

	constraintGetPosition(constraint) {
		begin();
		const o_position = take(stride("f32"));
		check(raw.cn_constraint_get_position(this.pointer, constraint, o_position));
		refresh();
		return READ.f32(o_position);
	}

	constraintGetReaction(constraint) {
		begin();
		const o_force_N = take(stride("cn_vec2"));
		const o_torque_Nm = take(stride("f32"));
		check(raw.cn_constraint_get_reaction(this.pointer, constraint, o_force_N, o_torque_Nm));
		refresh();
		return { force_N: readStruct("cn_vec2", o_force_N), torque_Nm: READ.f32(o_torque_Nm) };
	}

	constraintGetError(constraint) {
		begin();
		const o_m = take(stride("f32"));
		const o_rad = take(stride("f32"));
		check(raw.cn_constraint_get_error(this.pointer, constraint, o_m, o_rad));
		refresh();
		return { m: READ.f32(o_m), rad: READ.f32(o_rad) };
	}

	getConstraints() {
		begin();
		const number = take(4);
		check(raw.cn_world_get_constraints(this.pointer, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_get_constraints(this.pointer, out, found, number));
		return list("u32", out, found);
	}

	bodyGetConstraints(body) {
		begin();
		const number = take(4);
		check(raw.cn_body_get_constraints(this.pointer, body, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_body_get_constraints(this.pointer, body, out, found, number));
		return list("u32", out, found);
	}

	setFixedStep(step_s, steps_max) {
		begin();
		check(raw.cn_world_set_fixed_step(this.pointer, step_s, steps_max), this.pointer);
	}

	update(elapsed_s) {
		begin();
		const o_out = take(stride("cn_update_report"));
		check(raw.cn_world_update(this.pointer, elapsed_s, o_out), this.pointer);
		refresh();
		return readStruct("cn_update_report", o_out);
	}

	readPosesInterpolated(factor, bodies, out) {
		begin();
		const count = bodies ? size("u32", bodies) : out ? size("cn_pose", out) : this.getBodies().length;
		begin();
		if (out)
			even(size("cn_pose", out), count);
		const p_bodies = bodies ? array("u32", bodies) : 0;
		const p_out = take(stride("cn_pose") * count || 1);
		check(raw.cn_world_read_poses_interpolated(this.pointer, p_bodies, count, factor, p_out));
		return list("cn_pose", p_out, count, out);
	}

	castRay(ray, filter) {
		begin();
		const p_ray = struct("cn_ray", ray);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const o_out = take(stride("cn_ray_hit"));
		check(raw.cn_world_cast_ray(this.pointer, p_ray, p_filter, o_out));
		refresh();
		return readStruct("cn_ray_hit", o_out);
	}

	castRayAny(ray, filter) {
		begin();
		const p_ray = struct("cn_ray", ray);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const o_hit = take(stride("i32"));
		check(raw.cn_world_cast_ray_any(this.pointer, p_ray, p_filter, o_hit));
		refresh();
		return READ.i32(o_hit);
	}

	castRayAll(ray, filter) {
		begin();
		const p_ray = struct("cn_ray", ray);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const number = take(4);
		check(raw.cn_world_cast_ray_all(this.pointer, p_ray, p_filter, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("cn_ray_hit") * found || 1);
		if (found > 0)
			check(raw.cn_world_cast_ray_all(this.pointer, p_ray, p_filter, out, found, number));
		return list("cn_ray_hit", out, found);
	}

	castRays(rays, filter, out) {
		begin();
		const count = size("cn_ray", rays);
		if (out)
			even(size("cn_ray_hit", out), count);
		const p_rays = array("cn_ray", rays);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const p_out = take(stride("cn_ray_hit") * count || 1);
		check(raw.cn_world_cast_rays(this.pointer, p_rays, count, p_filter, p_out));
		return list("cn_ray_hit", p_out, count, out);
	}

	shapeCastRay(shape, ray) {
		begin();
		const p_ray = struct("cn_ray", ray);
		const o_out = take(stride("cn_ray_hit"));
		check(raw.cn_shape_cast_ray(this.pointer, shape, p_ray, o_out));
		refresh();
		return readStruct("cn_ray_hit", o_out);
	}

	castShape(shape, translation_x_m, translation_y_m, filter) {
		begin();
		const p_shape = struct("cn_polygon", shape);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const o_out = take(stride("cn_ray_hit"));
		check(raw.cn_world_cast_shape(this.pointer, p_shape, translation_x_m, translation_y_m, p_filter, o_out));
		refresh();
		return readStruct("cn_ray_hit", o_out);
	}

	overlapAabb(box, filter) {
		begin();
		const p_box = struct("cn_aabb", box);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const number = take(4);
		check(raw.cn_world_overlap_aabb(this.pointer, p_box, p_filter, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_overlap_aabb(this.pointer, p_box, p_filter, out, found, number));
		return list("u32", out, found);
	}

	overlapCircle(circle, filter) {
		begin();
		const p_circle = struct("cn_circle", circle);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const number = take(4);
		check(raw.cn_world_overlap_circle(this.pointer, p_circle, p_filter, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_overlap_circle(this.pointer, p_circle, p_filter, out, found, number));
		return list("u32", out, found);
	}

	overlapPolygon(polygon, filter) {
		begin();
		const p_polygon = struct("cn_polygon", polygon);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const number = take(4);
		check(raw.cn_world_overlap_polygon(this.pointer, p_polygon, p_filter, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_overlap_polygon(this.pointer, p_polygon, p_filter, out, found, number));
		return list("u32", out, found);
	}

	overlapPoint(x_m, y_m, filter) {
		begin();
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const number = take(4);
		check(raw.cn_world_overlap_point(this.pointer, x_m, y_m, p_filter, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("u32") * found || 1);
		if (found > 0)
			check(raw.cn_world_overlap_point(this.pointer, x_m, y_m, p_filter, out, found, number));
		return list("u32", out, found);
	}

	closestPoint(x_m, y_m, distance_max_m, filter) {
		begin();
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const o_out = take(stride("cn_closest"));
		check(raw.cn_world_closest_point(this.pointer, x_m, y_m, distance_max_m, p_filter, o_out));
		refresh();
		return readStruct("cn_closest", o_out);
	}

	moverCollide(shape, position_x_m, position_y_m, margin_m, filter) {
		begin();
		const p_shape = struct("cn_polygon", shape);
		const p_filter = filter ? struct("cn_query_filter", filter) : 0;
		const number = take(4);
		check(raw.cn_mover_collide(this.pointer, p_shape, position_x_m, position_y_m, margin_m, p_filter, 0, 0, number));
		refresh();
		const found = view.getInt32(number, true), out = take(stride("cn_plane") * found || 1);
		if (found > 0)
			check(raw.cn_mover_collide(this.pointer, p_shape, position_x_m, position_y_m, margin_m, p_filter, out, found, number));
		return list("cn_plane", out, found);
	}

	moverMove(def, dt_s, mover) {
		begin();
		const p_def = struct("cn_mover_def", def);
		const p_mover = struct("cn_mover", mover);
		check(raw.cn_mover_move(this.pointer, p_def, dt_s, p_mover), this.pointer);
		refresh();
		Object.assign(mover, readStruct("cn_mover", p_mover));
	}

	shapeSetArea(shape, def) {
		begin();
		const p_def = def ? struct("cn_area_def", def) : 0;
		check(raw.cn_shape_set_area(this.pointer, shape, p_def), this.pointer);
	}

	shapeGetArea(shape) {
		begin();
		const o_out = take(stride("cn_area_def"));
		check(raw.cn_shape_get_area(this.pointer, shape, o_out));
		refresh();
		return readStruct("cn_area_def", o_out);
	}

	shapeApplyWind(shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake) {
		begin();
		check(raw.cn_shape_apply_wind(this.pointer, shape, flow_x_mps, flow_y_mps, drag_kgpm2, lift_kgpm2, dt_s, wake), this.pointer);
	}

	explode(def) {
		begin();
		const p_def = struct("cn_explosion_def", def);
		check(raw.cn_world_explode(this.pointer, p_def), this.pointer);
	}
}

export class Tree {
	#pointer;
	constructor(margin_m) {
		begin();
		const out = take(4);
		check(raw.cn_tree_create(margin_m, 0, 0, 0, out));
		refresh();
		this.#pointer = view.getUint32(out, true);
		trees.register(this, this.#pointer, this);
	}
	get pointer() { return this.#pointer; }

	insert(box, user_data) {
		begin();
		const p_box = struct("cn_aabb", box);
		const o_item = take(stride("u32"));
		check(raw.cn_tree_insert(this.pointer, p_box, BigInt(user_data), o_item));
		refresh();
		return READ.u32(o_item);
	}

	remove(item) {
		begin();
		check(raw.cn_tree_remove(this.pointer, item));
	}

	move(item, box) {
		begin();
		const p_box = struct("cn_aabb", box);
		check(raw.cn_tree_move(this.pointer, item, p_box));
	}

	getBox(item) {
		begin();
		const o_out = take(stride("cn_aabb"));
		check(raw.cn_tree_get_box(this.pointer, item, o_out));
		refresh();
		return readStruct("cn_aabb", o_out);
	}

	getStats() {
		begin();
		const o_count = take(stride("i32"));
		const o_height = take(stride("i32"));
		check(raw.cn_tree_get_stats(this.pointer, o_count, o_height));
		refresh();
		return { count: READ.i32(o_count), height: READ.i32(o_height) };
	}
}

export function version() {
	begin();
	return raw.cn_version();
}

export function abiVersion() {
	begin();
	return raw.cn_abi_version();
}

export function resultText(result) {
	begin();
	return text(raw.cn_result_text(result));
}

export function saveDeltaSize(base, save) {
	begin();
	const p_base = array("u8", base);
	const p_save = array("u8", save);
	const o_bytes = take(stride("u64"));
	check(raw.cn_save_delta_size(p_base, BigInt(base.length), p_save, BigInt(save.length), o_bytes));
	refresh();
	return READ.u64(o_bytes);
}

export function saveDelta(base, save) {
	begin();
	const p_base = array("u8", base);
	const p_save = array("u8", save);
	const number = take(8);
	check(raw.cn_save_delta_size(p_base, BigInt(base.length), p_save, BigInt(save.length), number));
	refresh();
	const bytes = view.getBigUint64(number, true), out = take(Number(bytes) || 1);
	check(raw.cn_save_delta(p_base, BigInt(base.length), p_save, BigInt(save.length), out, bytes, number));
	refresh();
	return u8.slice(out, out + Number(view.getBigUint64(number, true)));
}

export function saveApply(base, delta) {
	begin();
	const p_base = array("u8", base);
	const p_delta = array("u8", delta);
	const number = take(8);
	const bytes = BigInt(base.length + delta.length), out = take(Number(bytes) || 1);
	check(raw.cn_save_apply(p_base, BigInt(base.length), p_delta, BigInt(delta.length), out, bytes, number));
	refresh();
	return u8.slice(out, out + Number(view.getBigUint64(number, true)));
}

export function polygonMakeHull(points_m, radius_m) {
	begin();
	const count = size("cn_vec2", points_m);
	const p_points_m = array("cn_vec2", points_m);
	const o_out = take(stride("cn_polygon"));
	check(raw.cn_polygon_make_hull(p_points_m, count, radius_m, o_out));
	refresh();
	return readStruct("cn_polygon", o_out);
}

export function polygonMakeBox(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m) {
	begin();
	const o_out = take(stride("cn_polygon"));
	check(raw.cn_polygon_make_box(half_width_m, half_height_m, center_x_m, center_y_m, angle_rad, radius_m, o_out));
	refresh();
	return readStruct("cn_polygon", o_out);
}

export function outlineDecompose(points_m, length_unit_m) {
	begin();
	const count = size("cn_vec2", points_m);
	const p_points_m = array("cn_vec2", points_m);
	const number = take(4);
	check(raw.cn_outline_decompose(p_points_m, count, length_unit_m, 0, 0, number));
	refresh();
	const found = view.getInt32(number, true), out = take(stride("cn_polygon") * found || 1);
	if (found > 0)
			check(raw.cn_outline_decompose(p_points_m, count, length_unit_m, out, found, number));
	return list("cn_polygon", out, found);
}

export function outlineSimplify(points_m, closed, tolerance_m) {
	begin();
	const count = size("cn_vec2", points_m);
	const p_points_m = array("cn_vec2", points_m);
	const number = take(4);
	check(raw.cn_outline_simplify(p_points_m, count, closed, tolerance_m, 0, 0, number));
	refresh();
	const found = view.getInt32(number, true), out = take(stride("cn_vec2") * found || 1);
	if (found > 0)
			check(raw.cn_outline_simplify(p_points_m, count, closed, tolerance_m, out, found, number));
	return list("cn_vec2", out, found);
}

export function outlineFromCells(cells, columns, origin_x_m, origin_y_m, cell_m, outline) {
	begin();
	const count = size("u8", cells);
	const p_cells = array("u8", cells);
	const number = take(4);
	check(raw.cn_outline_from_cells(p_cells, count, columns, origin_x_m, origin_y_m, cell_m, outline, 0, 0, number));
	refresh();
	const found = view.getInt32(number, true), out = take(stride("cn_vec2") * found || 1);
	if (found > 0)
			check(raw.cn_outline_from_cells(p_cells, count, columns, origin_x_m, origin_y_m, cell_m, outline, out, found, number));
	return list("cn_vec2", out, found);
}

export function outlineFromField(values, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline) {
	begin();
	const count = size("f32", values);
	const p_values = array("f32", values);
	const number = take(4);
	check(raw.cn_outline_from_field(p_values, count, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, 0, 0, number));
	refresh();
	const found = view.getInt32(number, true), out = take(stride("cn_vec2") * found || 1);
	if (found > 0)
			check(raw.cn_outline_from_field(p_values, count, columns, threshold, origin_x_m, origin_y_m, spacing_m, outline, out, found, number));
	return list("cn_vec2", out, found);
}

export function polygonDistance(a, pose_a, b, pose_b) {
	begin();
	const p_a = struct("cn_polygon", a);
	const p_pose_a = struct("cn_pose", pose_a);
	const p_b = struct("cn_polygon", b);
	const p_pose_b = struct("cn_pose", pose_b);
	const o_out = take(stride("cn_distance"));
	check(raw.cn_polygon_distance(p_a, p_pose_a, p_b, p_pose_b, o_out));
	refresh();
	return readStruct("cn_distance", o_out);
}

export function polygonCast(a, pose_a, b, pose_b, translation_x_m, translation_y_m) {
	begin();
	const p_a = struct("cn_polygon", a);
	const p_pose_a = struct("cn_pose", pose_a);
	const p_b = struct("cn_polygon", b);
	const p_pose_b = struct("cn_pose", pose_b);
	const o_out = take(stride("cn_ray_hit"));
	const o_hit = take(stride("i32"));
	check(raw.cn_polygon_cast(p_a, p_pose_a, p_b, p_pose_b, translation_x_m, translation_y_m, o_out, o_hit));
	refresh();
	return { out: readStruct("cn_ray_hit", o_out), hit: READ.i32(o_hit) };
}

export function polygonCollide(a, pose_a, b, pose_b, margin_m) {
	begin();
	const p_a = struct("cn_polygon", a);
	const p_pose_a = struct("cn_pose", pose_a);
	const p_b = struct("cn_polygon", b);
	const p_pose_b = struct("cn_pose", pose_b);
	const o_out = take(stride("cn_manifold"));
	check(raw.cn_polygon_collide(p_a, p_pose_a, p_b, p_pose_b, margin_m, o_out));
	refresh();
	return readStruct("cn_manifold", o_out);
}

export function polygonTimeOfImpact(a, sweep_a, b, sweep_b, distance_m) {
	begin();
	const p_a = struct("cn_polygon", a);
	const p_sweep_a = struct("cn_sweep", sweep_a);
	const p_b = struct("cn_polygon", b);
	const p_sweep_b = struct("cn_sweep", sweep_b);
	const o_out = take(stride("cn_impact"));
	check(raw.cn_polygon_time_of_impact(p_a, p_sweep_a, p_b, p_sweep_b, distance_m, o_out));
	refresh();
	return readStruct("cn_impact", o_out);
}

export function moverSolve(planes, translation_x_m, translation_y_m) {
	begin();
	const count = size("cn_plane", planes);
	const p_planes = array("cn_plane", planes);
	const o_translation_m = take(stride("cn_vec2"));
	const o_overlap_m = take(stride("f32"));
	check(raw.cn_mover_solve(p_planes, count, translation_x_m, translation_y_m, o_translation_m, o_overlap_m));
	refresh();
	list("cn_plane", p_planes, count, planes);
	return { translation_m: readStruct("cn_vec2", o_translation_m), overlap_m: READ.f32(o_overlap_m) };
}

export function moverClip(planes, velocity_x_mps, velocity_y_mps) {
	begin();
	const count = size("cn_plane", planes);
	const p_planes = array("cn_plane", planes);
	const o_mps = take(stride("cn_vec2"));
	check(raw.cn_mover_clip(p_planes, count, velocity_x_mps, velocity_y_mps, o_mps));
	refresh();
	return readStruct("cn_vec2", o_mps);
}
