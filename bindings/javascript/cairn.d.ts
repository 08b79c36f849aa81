// Types of Cairn for JavaScript. Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.

/** C's functions, on the memory of the module. */
export const raw: WebAssembly.Exports & Record<string, any>;
/** A call that failed: code is CN_ERROR_..., the message is the library's sentence. */
export class CairnError extends Error {
	readonly code: number;
}
/** A struct going in: fields that are not given have their defaults. */
export type In<T> = T extends number ? T : T extends object ? { [K in keyof T]?: In<T[K]> } : T;

export const CN_VERSION_MAJOR: 0;
export const CN_VERSION_MINOR: 1;
export const CN_VERSION_PATCH: 0;
export const CN_ABI_VERSION: 3;
export const CN_POLYGON_MAX_VERTICES: 16;
export const CN_NAME_MAX_BYTES: 63;
export const CN_PLANES_MAX: 64;
export const CN_WORKERS_MAX: 64;
export const CN_MAX_HANDLES: 1048575;
export const CN_DEFAULT: -1;
export const CN_OK: 0;
export const CN_ERROR_ARGUMENT: -1;
export const CN_ERROR_HANDLE: -2;
export const CN_ERROR_MEMORY: -3;
export const CN_ERROR_LOCKED: -4;
export const CN_ERROR_CAPACITY: -5;
export const CN_ERROR_STATE: -6;
export const CN_ERROR_INTERNAL: -7;
export const CN_ERROR_FORMAT: -8;
export const CN_TYPE_VEC2: 0;
export const CN_TYPE_POSE: 1;
export const CN_TYPE_VELOCITY: 2;
export const CN_TYPE_AABB: 3;
export const CN_TYPE_MASS_DATA: 4;
export const CN_TYPE_WORLD_DEF: 5;
export const CN_TYPE_BODY_DEF: 6;
export const CN_TYPE_SHAPE_DEF: 7;
export const CN_TYPE_CIRCLE: 8;
export const CN_TYPE_CAPSULE: 9;
export const CN_TYPE_EDGE: 10;
export const CN_TYPE_POLYGON: 11;
export const CN_TYPE_CHAIN: 12;
export const CN_TYPE_FILTER: 13;
export const CN_TYPE_MATERIAL: 14;
export const CN_TYPE_MANIFOLD_POINT: 15;
export const CN_TYPE_MANIFOLD: 16;
export const CN_TYPE_CONTACT_EVENT: 17;
export const CN_TYPE_BODY_MOVED: 18;
export const CN_TYPE_REVOLUTE_DEF: 19;
export const CN_TYPE_DISTANCE_DEF: 20;
export const CN_TYPE_COUNTERS: 21;
export const CN_TYPE_PROFILE: 22;
export const CN_TYPE_MEMORY_STATS: 23;
export const CN_TYPE_SENSOR_EVENT: 24;
export const CN_TYPE_UPDATE_REPORT: 25;
export const CN_TYPE_DEBUG_DRAW: 26;
export const CN_TYPE_QUERY_FILTER: 27;
export const CN_TYPE_RAY: 28;
export const CN_TYPE_RAY_HIT: 29;
export const CN_TYPE_CLOSEST: 30;
export const CN_TYPE_EXPLOSION_DEF: 31;
export const CN_TYPE_FIXED_DEF: 32;
export const CN_TYPE_PRISMATIC_DEF: 33;
export const CN_TYPE_WHEEL_DEF: 34;
export const CN_TYPE_MOTOR_DEF: 35;
export const CN_TYPE_MOUSE_DEF: 36;
export const CN_TYPE_GEAR_DEF: 37;
export const CN_TYPE_PULLEY_DEF: 38;
export const CN_TYPE_RATCHET_DEF: 39;
export const CN_TYPE_ROTARY_SPRING_DEF: 40;
export const CN_TYPE_GROOVE_DEF: 41;
export const CN_TYPE_FILTER_JOINT_DEF: 42;
export const CN_TYPE_JOINT_BASE: 43;
export const CN_TYPE_JOINT_EVENT: 44;
export const CN_TYPE_ANGLE_CONSTRAINT_DEF: 45;
export const CN_TYPE_LINE_CONSTRAINT_DEF: 46;
export const CN_TYPE_ISLAND_REPORT: 47;
export const CN_TYPE_DISTANCE: 48;
export const CN_TYPE_SWEEP: 49;
export const CN_TYPE_IMPACT: 50;
export const CN_TYPE_PLANE: 51;
export const CN_TYPE_MOVER_DEF: 52;
export const CN_TYPE_MOVER: 53;
export const CN_TYPE_AREA_DEF: 54;
export const CN_TYPE_COUNT: 55;
export const CN_WORLD_SLEEP: 1;
export const CN_WORLD_WARM_START: 2;
export const CN_WORLD_PROFILE: 4;
export const CN_WORLD_CONTINUOUS: 8;
export const CN_RESERVE_NAMES: 1;
export const CN_RESERVE_CHAINS: 2;
export const CN_RESERVE_EXTRA_ROWS: 4;
export const CN_RESERVE_MOVED: 8;
export const CN_SOLVER_AUTO: 0;
export const CN_SOLVER_SOFT: 1;
export const CN_SOLVER_DIRECT: 2;
export const CN_SOLVER_SEQUENTIAL: 3;
export const CN_BROADPHASE_SWEEP: 0;
export const CN_BROADPHASE_TREE: 1;
export const CN_WARNING_CONTACT_MEMORY: 1;
export const CN_WARNING_FRAME_MEMORY: 2;
export const CN_WARNING_EVENT_MEMORY: 4;
export const CN_WARNING_CROWD: 8;
export const CN_WARNING_NOT_FINITE: 16;
export const CN_TIER_SOFT: 0;
export const CN_TIER_DIRECT: 1;
export const CN_TIER_FREE: 2;
export const CN_TIER_REASON_NONE: 0;
export const CN_TIER_REASON_SETTLING: 1;
export const CN_TIER_REASON_NEW_CONTACT: 2;
export const CN_TIER_REASON_OVERLAP: 3;
export const CN_TIER_REASON_JOINT: 4;
export const CN_TIER_REASON_STRESSED: 5;
export const CN_TIER_REASON_SOLVER: 6;
export const CN_TIER_REASON_OVERRIDE: 7;
export const CN_TIER_REASON_ALONE: 8;
export const CN_TIER_REASON_MOVING: 9;
export const CN_TIER_REASON_CROWDED: 10;
export const CN_TIER_REASON_WORK: 11;
export const CN_TIER_REASON_KIND: 12;
export const CN_TIER_REASON_NO_SET: 13;
export const CN_TIER_REASON_MEMORY: 14;
export const CN_TIER_REASON_JOINTED: 15;
export const CN_BODY_STATIC: 0;
export const CN_BODY_KINEMATIC: 1;
export const CN_BODY_DYNAMIC: 2;
export const CN_BODY_LOCK_X: 1;
export const CN_BODY_LOCK_Y: 2;
export const CN_BODY_LOCK_ROTATION: 4;
export const CN_BODY_BULLET: 8;
export const CN_BODY_ENABLED: 16;
export const CN_BODY_SLEEP: 32;
export const CN_BODY_AWAKE: 64;
export const CN_SHAPE_CIRCLE: 0;
export const CN_SHAPE_CAPSULE: 1;
export const CN_SHAPE_POLYGON: 2;
export const CN_SHAPE_EDGE: 3;
export const CN_SHAPE_CHAIN: 4;
export const CN_MIX_AVERAGE: 0;
export const CN_MIX_GEOMETRIC: 1;
export const CN_MIX_MINIMUM: 2;
export const CN_MIX_MULTIPLY: 3;
export const CN_MIX_MAXIMUM: 4;
export const CN_SHAPE_SENSOR: 1;
export const CN_SHAPE_SENSOR_SEEN: 2;
export const CN_SHAPE_ONE_WAY: 4;
export const CN_SHAPE_PRE_SOLVE: 8;
export const CN_EVENT_CREATED: 0;
export const CN_EVENT_ENTER: 1;
export const CN_EVENT_STAY: 2;
export const CN_EVENT_LEAVE: 3;
export const CN_EVENT_DESTROYED: 4;
export const CN_EVENT_HIT: 5;
export const CN_EVENT_KINDS: 6;
export const CN_JOINT_REVOLUTE: 0;
export const CN_JOINT_DISTANCE: 1;
export const CN_JOINT_FIXED: 2;
export const CN_JOINT_PRISMATIC: 3;
export const CN_JOINT_WHEEL: 4;
export const CN_JOINT_MOTOR_TO: 5;
export const CN_JOINT_MOUSE: 6;
export const CN_JOINT_GEAR: 7;
export const CN_JOINT_PULLEY: 8;
export const CN_JOINT_RATCHET: 9;
export const CN_JOINT_ROTARY_SPRING: 10;
export const CN_JOINT_GROOVE: 11;
export const CN_JOINT_FILTER: 12;
export const CN_JOINT_COLLIDE: 1;
export const CN_JOINT_LIMIT: 2;
export const CN_JOINT_MOTOR: 4;
export const CN_JOINT_SPRING: 8;
export const CN_JOINT_BREAKS: 16;
export const CN_CONSTRAINT_ANGLE: 0;
export const CN_CONSTRAINT_LINE: 1;
export const CN_CONSTRAINT_LIMIT: 1;
export const CN_CONSTRAINT_BREAKS: 2;
export const CN_QUERY_SKIP: 0;
export const CN_QUERY_TAKE: 1;
export const CN_QUERY_STOP: 2;
export const CN_QUERY_IGNORE_JOINED: 1;
export const CN_QUERY_ONE_WAY: 2;
export const CN_QUERY_LEAVING: 4;
export const CN_IMPACT_NONE: 0;
export const CN_IMPACT_HIT: 1;
export const CN_IMPACT_OVERLAP: 2;
export const CN_IMPACT_FAILED: 3;
export const CN_MOVER_DROP: 1;
export const CN_MOVER_ON_GROUND: 1;
export const CN_MOVER_ON_WALL: 2;
export const CN_MOVER_ON_CEILING: 4;
export const CN_AREA_REPLACE: 1;
export const CN_DRAW_SHAPES: 1;
export const CN_DRAW_JOINTS: 2;
export const CN_DRAW_CONTACTS: 4;
export const CN_DRAW_AABBS: 8;
export const CN_DRAW_CENTERS: 16;
export const CN_DRAW_ISLANDS: 32;

/** handle of a body; 0: none */
export type Body = number & { readonly __handle: "cn_body" };

/** handle of a shape; 0: none */
export type Shape = number & { readonly __handle: "cn_shape" };

/** handle of a joint; 0: none */
export type Joint = number & { readonly __handle: "cn_joint" };

/** handle of a constraint on one body; 0: none */
export type Constraint = number & { readonly __handle: "cn_constraint" };

/** A point, vector or pair of numbers. */
export interface Vec2 {
	/** to the right */
	x: number;
	/** upwards */
	y: number;
}

/** Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
uploaded to a GPU directly. */
export interface Pose {
	/** of the body's origin */
	position_m: Vec2;
	/** of the angle */
	cosine: number;
	/** of the angle */
	sine: number;
}

/** Velocity of a body. */
export interface Velocity {
	/** of the centre of mass */
	linear_mps: Vec2;
	/** counter-clockwise is positive */
	angular_radps: number;
}

/** Axis-aligned bounding box, lower_m <= upper_m. */
export interface Aabb {
	/** left and bottom */
	lower_m: Vec2;
	/** right and top */
	upper_m: Vec2;
}

/** Mass, inertia and centre of mass. */
export interface MassData {
	/** of all shapes, or as set */
	mass_kg: number;
	/** about the centre of mass */
	inertia_kgm2: number;
	/** in the body's local frame */
	center_m: Vec2;
}

/** Definition of a world. */
export interface WorldDef {
	/** set by the init function */
	struct_size: number;
	/** CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS */
	flags: number;
	/** default (0, -10) */
	gravity_mps2: Vec2;
	/** a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1 */
	length_unit_m: number;
	/** CN_SOLVER_*; default CN_SOLVER_AUTO */
	solver: number;
	/** CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP */
	broadphase: number;
	/** 1 to 64; default 4 */
	substep_count: number;
	/** CN_SOLVER_AUTO aims at errors below this, >= 0; CN_DEFAULT (default): 0.005 x length unit */
	accuracy_m: number;
	/** limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps
	included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with
	CN_SOLVER_AUTO 512 contacts of a world */
	work_budget: number;
	/** slower impacts do not bounce, >= 0; CN_DEFAULT (default): 1 x length unit */
	restitution_threshold_mps: number;
	/** greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved joint
	closes (of its angles: rad/s, for each length unit), > 0; in a crowd the speeds of neighbours add up: n
	bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which pushes them upwards,
	at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit */
	push_speed_max_mps: number;
	/** faster bodies are slowed to it, > 0; CN_DEFAULT (default): 400 x length unit */
	linear_speed_max_mps: number;
	/** faster bodies are slowed to it, > 0; default 400 */
	angular_speed_max_radps: number;
	/** bodies slower than this may sleep, >= 0; CN_DEFAULT (default): 0.05 x length unit */
	sleep_speed_mps: number;
	/** ... after this time, >= 0; default 0.5 */
	sleep_delay_s: number;
	/** hints for a growing world; one in a block has room for these, and for more as memory permits; >= 0;
	default 0 */
	body_capacity: number;
	/** counts every edge of a chain */
	shape_capacity: number;
	/** pairs whose fat AABBs overlap */
	contact_capacity: number;
	/** counts constraints too */
	joint_capacity: number;
	/** a number for the user; default 0 */
	user_data: bigint;
	/** size of memory; 0: use alloc and free */
	memory_bytes: bigint;
	/** threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no
	tasks */
	worker_count: number;
	/** blows at least this fast are reported by CN_EVENT_HIT, >= 0; CN_DEFAULT (default): 1 x length unit */
	hit_speed_mps: number;
	/** Of a world in one block (memory); others ignore them. pairs that touch at once, >= 0; further ones do not
	collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity */
	touching_capacity: number;
	/** pairs that report events (event_mask of a shape, sensors), >= 0; further ones report none, which
	cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity */
	event_capacity: number;
	/** vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block; default
	CN_POLYGON_MAX_VERTICES */
	vertex_capacity: number;
	/** CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all */
	reserve: number;
}

/** Counts of objects, and problems of the last step. */
export interface Counters {
	/** alive */
	bodies: number;
	/** dynamic and kinematic bodies that are simulated */
	bodies_awake: number;
	/** alive */
	shapes: number;
	/** boxes in the broadphase: one per shape, one per edge of a chain */
	proxies: number;
	/** pairs whose fat boxes overlap */
	contacts: number;
	/** with an awake body */
	contacts_awake: number;
	/** pairs with a manifold, asleep or awake */
	contacts_touching: number;
	/** and constraints */
	joints: number;
	/** and constraints, with an awake body */
	joints_awake: number;
	/** awake and asleep; a single dynamic body counts */
	islands: number;
	/** of them */
	islands_awake: number;
	/** groups of contacts that share no dynamic body */
	colors_used: number;
	/** contacts that fit no colour: solved one by one */
	overflow_contacts: number;
	/** cells of the broadphase */
	broadphase_tiles: number;
	/** steps taken since creation, modulo 2^32 */
	steps: number;
	/** Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try again.
	CN_WARNING_* */
	warnings: number;
	/** new pairs without a contact */
	pairs_not_added: number;
	/** events without a place in a log */
	events_not_reported: number;
	/** of several bodies, solved directly in the last step, contacts included */
	islands_direct: number;
	/** planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1 */
	direct_work: number;
	/** of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET */
	islands_unsolved: number;
}

/** Report on one island. */
export interface IslandReport {
	/** its body of least slot */
	body: Body;
	/** dynamic */
	bodies: number;
	/** touching */
	contacts: number;
	/** and constraints */
	joints: number;
	/** CN_TIER_*, after the last step */
	tier: number;
	/** CN_TIER_REASON_* */
	reason: number;
	/** of the last step with dt > 0: the world's, or 1 at rest; freely swinging joints may take more */
	substeps: number;
	/** at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints
	that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count */
	residual_m: number;
}

/** Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set. */
export interface Profile {
	/** the whole step */
	step_s: number;
	/** waking */
	wake_s: number;
	/** pairs */
	broadphase_s: number;
	/** manifolds */
	narrowphase_s: number;
	/** islands */
	islands_s: number;
	/** constraints, plans */
	prepare_s: number;
	/** all substeps */
	substeps_s: number;
	/** poses and boxes */
	finalize_s: number;
	/** callbacks */
	events_s: number;
	/** falling asleep */
	sleep_s: number;
}

/** Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block
allocator serves small variable-size pieces from free lists of size classes. */
export interface MemoryStats {
	/** taken from the user's allocator or carved from the fixed block */
	bytes_in_use: bigint;
	/** most bytes_in_use since creation */
	bytes_peak: bigint;
	/** calls of the user's alloc (or of the fixed block's) since creation */
	allocator_calls: bigint;
	/** of the frame arena */
	arena_capacity: bigint;
	/** most bytes in use at once since creation */
	arena_peak: bigint;
	/** entries that did not fit: the allocator served them; since creation */
	arena_fallbacks: bigint;
	/** bytes in chunks */
	blocks_capacity: bigint;
	/** bytes handed out of them */
	blocks_in_use: bigint;
	/** blocks above the largest class, served by the allocator */
	blocks_large: bigint;
}

/** Definition of a body. */
export interface BodyDef {
	/** set by the init function */
	struct_size: number;
	/** CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic */
	type: number;
	/** of the origin; |x|, |y| <= 1e6 x length unit */
	position_m: Vec2;
	/** |angle| <= 1e4 */
	angle_rad: number;
	/** of the centre of mass; both velocities are ignored without CN_BODY_AWAKE */
	linear_velocity_mps: Vec2;
	/** default 0 */
	angular_velocity_radps: number;
	/** v' = -damping v; >= 0, default 0 */
	linear_damping_per_s: number;
	/** >= 0, default 0 */
	angular_damping_per_s: number;
	/** default 1 */
	gravity_scale: number;
	/** >= 0; CN_DEFAULT (default): the world's */
	sleep_speed_mps: number;
	/** CN_BODY_*; default ENABLED | SLEEP | AWAKE */
	flags: number;
	/** as in cn_body_set_solver; default CN_SOLVER_AUTO */
	solver: number;
	/** a number for the user; default 0 */
	user_data: bigint;
	/** NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied */
	name?: string;
}

/** A body that moved or fell asleep in the last step. */
export interface BodyMoved {
	/** after the step */
	pose: Pose;
	/** the body's */
	user_data: bigint;
	/** that moved */
	body: Body;
	/** 1 in the step in which it fell asleep */
	fell_asleep: number;
}

/** Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
collide if the category of each has a bit in the mask of the other. */
export interface Filter {
	/** default 1 */
	category: bigint;
	/** default all ones */
	mask: bigint;
	/** default 0 */
	group: number;
	/** 0 */
	reserved: number;
}

/** Surface of a shape. */
export interface Material {
	/** coefficient while sticking, [0, 100], default 0.6 */
	static_friction: number;
	/** coefficient while sliding, [0, static_friction], default 0.6 */
	dynamic_friction: number;
	/** [0, 1], default 0 */
	restitution: number;
	/** metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0 */
	rolling_resistance: number;
	/** conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0 */
	tangent_speed_mps: number;
	/** CN_MIX_*; default CN_MIX_GEOMETRIC */
	friction_mix: number;
	/** CN_MIX_*; default CN_MIX_MAXIMUM */
	restitution_mix: number;
	/** a number for the user, reported in contact events; default 0 */
	user_id: number;
}

/** Definition of a shape. */
export interface ShapeDef {
	/** set by the init function */
	struct_size: number;
	/** 0: create unattached, for cn_shape_attach */
	body: Body;
	/** of the shape in the body's local frame */
	offset_m: Vec2;
	/** of the shape in the body's local frame */
	angle_rad: number;
	/** >= 0, giving 0 or 1e-20 to 1e20 kg; default 1 */
	density_kgpm2: number;
	/** defaults: see cn_material */
	material: Material;
	/** defaults: see cn_filter */
	filter: Filter;
	/** bits 1 << CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE */
	event_mask: number;
	/** CN_SHAPE_SENSOR ...; default 0 */
	flags: number;
	/** a number for the user; default 0 */
	user_data: bigint;
}

/** A disc. */
export interface Circle {
	/** in the body's frame */
	center_m: Vec2;
	/** > 0 */
	radius_m: number;
}

/** All points within radius_m of the segment. */
export interface Capsule {
	/** one end of the segment, in the body's frame */
	a_m: Vec2;
	/** the other end */
	b_m: Vec2;
	/** around the segment, > 0 */
	radius_m: number;
}

/** A two-sided segment without mass. */
export interface Edge {
	/** one end, in the body's frame */
	a_m: Vec2;
	/** the other end */
	b_m: Vec2;
}

/** Convex polygon. Either winding is accepted; points are stored counter-clockwise. */
export interface Polygon {
	/** 3 to CN_POLYGON_MAX_VERTICES */
	count: number;
	/** rounding added outside the points, >= 0 */
	radius_m: number;
	/** the first count of them; in the body's frame */
	points_m: Vec2[];
}

/** One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is on
the left of the order of points and surface normals point to the right: points that run from +x to -x collide
from above, a counter-clockwise loop collides from outside. */
export interface Chain {
	/** copied */
	points_m?: Vec2[] | Float32Array;
	/** an open chain: >= 2; a loop: >= 3; at most 65535 */
	count: number;
	/** 1: the last point joins the first */
	loop: number;
}

/** One point of a contact. */
export interface ManifoldPoint {
	/** world, midway between the surfaces */
	point_m: Vec2;
	/** negative when overlapping */
	separation_m: number;
	/** of the last substep */
	normal_impulse_Ns: number;
	/** the same while the same features touch */
	feature_id: number;
}

/** How two shapes touch. */
export interface Manifold {
	/** unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the faces'
	by up to 0.1 rad, so that piles stand */
	normal: Vec2;
	/** of the last substep, on body b along (normal.y, -normal.x) */
	friction_impulse_Ns: number;
	/** 0, 1 or 2 */
	point_count: number;
	/** the first point_count of them */
	points: ManifoldPoint[];
}

/** A contact event, or the present state of a contact. */
export interface ContactEvent {
	/** one shape of the pair */
	shape_a: Shape;
	/** the other */
	shape_b: Shape;
	/** of shape_a */
	body_a: Body;
	/** of shape_b */
	body_b: Body;
	/** edge number within a chain, else 0 */
	child_a: number;
	/** the same of shape b */
	child_b: number;
	/** the same from CREATED to DESTROYED, then reused */
	contact_id: number;
	/** CN_EVENT_* */
	kind: number;
	/** ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0 */
	approach_speed_mps: number;
	/** geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT */
	manifold: Manifold;
	/** Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of
	cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact that its
	shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean force is
	normal_impulse_Ns / dt_s */
	normal_impulse_Ns: number;
	/** along (normal.y, -normal.x), on body b */
	friction_impulse_Ns: number;
	/** HIT: where, in the world; else (0, 0) */
	hit_point_m: Vec2;
	/** cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED */
	material_a: number;
	/** the same of shape_b */
	material_b: number;
}

/** A shape entered or left a sensor. */
export interface SensorEvent {
	/** the sensor */
	sensor: Shape;
	/** the shape that it met */
	visitor: Shape;
	/** the sensor's body */
	sensor_body: Body;
	/** the visitor's body */
	visitor_body: Body;
	/** CN_EVENT_ENTER or CN_EVENT_LEAVE */
	kind: number;
	/** 0 */
	reserved: number;
}

/** First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and
limits in place; springs and motors are not rigid parts. */
export interface JointBase {
	/** of the whole definition */
	struct_size: number;
	/** CN_JOINT_*; default 0; a type ignores flags that it does not use */
	flags: number;
	/** 0: the world */
	body_a: Body;
	/** 0: the world; one of the two must be dynamic */
	body_b: Body;
	/** in body a's local frame, or in world coordinates */
	anchor_a_m: Vec2;
	/** the same for body b */
	anchor_b_m: Vec2;
	/** of the rigid parts, > 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of all
	springs; CN_DEFAULT (default): as stiff as the substeps permit */
	stiffness_hertz: number;
	/** used with a stiffness_hertz; 0 to 1e6, default 0 */
	stiffness_damping_ratio: number;
	/** greatest force of each: anchor, axis, limit; > 0; CN_DEFAULT (default): unbounded */
	force_max_N: number;
	/** greatest torque of angles, > 0; CN_DEFAULT (default): unbounded */
	torque_max_Nm: number;
	/** a reaction above this in any substep is reported (cn_world_joint_events), > 0; CN_DEFAULT (default):
	never */
	break_force_N: number;
	/** the same for the torque */
	break_torque_Nm: number;
	/** a number for the user; default 0 */
	user_data: bigint;
}

/** Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi]. */
export interface RevoluteDef {
	/** what every joint has */
	base: JointBase;
	/** angle b - angle a at joint angle 0 */
	reference_angle_rad: number;
	/** CN_JOINT_LIMIT: -pi <= lower <= upper <= pi */
	lower_angle_rad: number;
	/** the upper limit */
	upper_angle_rad: number;
	/** CN_JOINT_MOTOR */
	motor_speed_radps: number;
	/** >= 0 */
	motor_torque_max_Nm: number;
	/** CN_JOINT_SPRING: pulls the joint angle to this */
	spring_target_rad: number;
	/** 0 to 1e6 */
	spring_hertz: number;
	/** 0 to 1e6 */
	spring_damping_ratio: number;
}

/** Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
length_m. With a spring, length_m is its rest length, and limits keep the distance within [min, max]; limits
alone make a rope (min 0). */
export interface DistanceDef {
	/** what every joint has */
	base: JointBase;
	/** > 0; default 1 */
	length_m: number;
	/** CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1 */
	length_min_m: number;
	/** the upper limit */
	length_max_m: number;
	/** CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only */
	motor_speed_mps: number;
	/** >= 0 */
	motor_force_max_N: number;
	/** 0 to 1e6 */
	spring_hertz: number;
	/** 0 to 1e6 */
	spring_damping_ratio: number;
	/** 0 */
	reserved: number;
}

/** Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy. */
export interface FixedDef {
	/** what every joint has */
	base: JointBase;
	/** angle b - angle a */
	reference_angle_rad: number;
	/** stiffness of the angle alone, > 0, to 1e6; CN_DEFAULT (default): the base's */
	angular_hertz: number;
	/** 0 to 1e6 */
	angular_damping_ratio: number;
	/** 0 */
	reserved: number;
}

/** b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a. */
export interface PrismaticDef {
	/** what every joint has */
	base: JointBase;
	/** in body a's frame, any length > 0 (read back with length 1); default (1, 0) */
	axis: Vec2;
	/** angle b - angle a */
	reference_angle_rad: number;
	/** CN_JOINT_LIMIT: lower <= upper */
	lower_m: number;
	/** the upper limit */
	upper_m: number;
	/** CN_JOINT_MOTOR */
	motor_speed_mps: number;
	/** >= 0 */
	motor_force_max_N: number;
	/** CN_JOINT_SPRING: pulls the translation to this */
	spring_target_m: number;
	/** 0 to 1e6 */
	spring_hertz: number;
	/** 0 to 1e6 */
	spring_damping_ratio: number;
}

/** A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
by the motor. */
export interface WheelDef {
	/** what every joint has */
	base: JointBase;
	/** in body a's frame, any length > 0 (read back with length 1); default (0, 1) */
	axis: Vec2;
	/** CN_JOINT_LIMIT: lower <= upper */
	lower_m: number;
	/** the upper limit */
	upper_m: number;
	/** CN_JOINT_MOTOR */
	motor_speed_radps: number;
	/** >= 0 */
	motor_torque_max_Nm: number;
	/** CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1 */
	spring_hertz: number;
	/** 0 to 1e6, default 0.7 */
	spring_damping_ratio: number;
}

/** Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
base.torque_max_Nm must be > 0. */
export interface MotorDef {
	/** anchor b is driven to anchor a + offset */
	base: JointBase;
	/** in body a's frame */
	offset_m: Vec2;
	/** angle b - angle a */
	angle_rad: number;
	/** frequency of the spring, > 0, to 1e6; default 5 */
	hertz: number;
	/** 0 to 1e6, default 1 */
	damping_ratio: number;
	/** 0 */
	reserved: number;
}

/** Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
base.force_max_N must be > 0. */
export interface MouseDef {
	/** what every joint has */
	base: JointBase;
	/** world */
	target_m: Vec2;
	/** > 0, to 1e6; default 5 */
	hertz: number;
	/** 0 to 1e6, default 0.7 */
	damping_ratio: number;
}

/** angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
and count whole turns from there. */
export interface GearDef {
	/** what every joint has */
	base: JointBase;
	/** size 1e-4 to 1e4, negative: they turn against each other; default 1 */
	ratio: number;
	/** default 0 */
	phase_rad: number;
}

/** A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls and never
pushes. */
export interface PulleyDef {
	/** what every joint has */
	base: JointBase;
	/** world */
	ground_a_m: Vec2;
	/** world */
	ground_b_m: Vec2;
	/** 1e-4 to 1e4; default 1 */
	ratio: number;
	/** > 0: must be set */
	length_m: number;
}

/** b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at phase
+ n * click_rad for every whole number n, over whole turns. */
export interface RatchetDef {
	/** what every joint has */
	base: JointBase;
	/** default 0 */
	phase_rad: number;
	/** size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise */
	click_rad: number;
}

/** A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
the two bodies. */
export interface RotarySpringDef {
	/** what every joint has */
	base: JointBase;
	/** default 0 */
	rest_angle_rad: number;
	/** > 0, to 1e6; default 1 */
	hertz: number;
	/** 0 to 1e6, default 0 */
	damping_ratio: number;
	/** 0 */
	reserved: number;
}

/** Anchor b slides in a slot of body a from anchor a to end_m. */
export interface GrooveDef {
	/** what every joint has */
	base: JointBase;
	/** in body a's frame; not equal to anchor a; default (1, 0) */
	end_m: Vec2;
}

/** The two bodies do not collide; no other effect. */
export interface FilterJointDef {
	/** what every joint has */
	base: JointBase;
}

/** A joint or constraint exceeded a break threshold or was destroyed with a body. */
export interface JointEvent {
	/** 0: it was a constraint; stale when destroyed is 1 */
	joint: Joint;
	/** 0: it was a joint; stale when destroyed is 1 */
	constraint: Constraint;
	/** 0: the world */
	body_a: Body;
	/** 0: the world */
	body_b: Body;
	/** largest reaction of the step; 0 when a body was destroyed */
	force_N: number;
	/** the same for the torque */
	torque_Nm: number;
	/** 1: it broke, or one of its bodies was destroyed */
	destroyed: number;
	/** 0 */
	reserved: number;
	/** the joint's or constraint's */
	user_data: bigint;
}

/** Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
there. */
export interface AngleConstraintDef {
	/** set by the init function */
	struct_size: number;
	/** CN_CONSTRAINT_*; default 0 */
	flags: number;
	/** must be dynamic */
	body: Body;
	/** lower <= upper; equal: locked */
	lower_rad: number;
	/** the upper limit */
	upper_rad: number;
	/** > 0, to 1e6; CN_DEFAULT (default): rigid */
	hertz: number;
	/** used with a hertz; 0 to 1e6 */
	damping_ratio: number;
	/** a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never */
	break_torque_Nm: number;
	/** a number for the user; default 0 */
	user_data: bigint;
}

/** Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits along
the line. */
export interface LineConstraintDef {
	/** set by the init function */
	struct_size: number;
	/** CN_CONSTRAINT_*; default 0 */
	flags: number;
	/** must be dynamic */
	body: Body;
	/** in the body's frame */
	anchor_m: Vec2;
	/** of the line, world */
	origin_m: Vec2;
	/** world, any length > 0 (read back with length 1); default (1, 0) */
	axis: Vec2;
	/** >= 0: free play across the axis */
	tolerance_m: number;
	/** CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper */
	lower_m: number;
	/** the upper limit */
	upper_m: number;
	/** > 0, to 1e6; CN_DEFAULT (default): rigid */
	hertz: number;
	/** used with a hertz; 0 to 1e6 */
	damping_ratio: number;
	/** a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never */
	break_force_N: number;
	/** 0 */
	reserved: number;
	/** a number for the user; default 0 */
	user_data: bigint;
}

/** Result of cn_world_update. */
export interface UpdateReport {
	/** fixed steps taken */
	steps: number;
	/** time kept for the next update */
	leftover_s: number;
	/** time discarded because of steps_max */
	dropped_s: number;
	/** leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated */
	interpolation: number;
}

/** A ray with an end. */
export interface Ray {
	/** world */
	origin_m: Vec2;
	/** at most 2e6 length units each way; 0 hits only shapes around the origin */
	translation_m: Vec2;
}

/** What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that
shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up to a
depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it. */
export interface RayHit {
	/** 0: nothing was hit */
	shape: Shape;
	/** the shape's */
	body: Body;
	/** edge of a chain */
	child: number;
	/** of the translation, [0, 1]; 1 when nothing was hit */
	fraction: number;
	/** on the surface of the shape that was hit */
	point_m: Vec2;
	/** unit, out of the shape that was hit */
	normal: Vec2;
	/** depth of the start inside it, 0 outside */
	depth_m: number;
	/** 0 */
	reserved: number;
}

/** Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between steps. */
export interface QueryFilter {
	/** default 1 */
	category: bigint;
	/** default all ones */
	mask: bigint;
	/** its shapes are ignored; 0 (default): none. A stale handle is an error */
	ignored_body: Body;
	/** CN_QUERY_IGNORE_JOINED ...; default 0 */
	flags: number;
}

/** The shape nearest to a point. */
export interface Closest {
	/** 0: nothing within the distance */
	shape: Shape;
	/** the shape's */
	body: Body;
	/** edge of a chain */
	child: number;
	/** negative: depth inside a shape with area */
	distance_m: number;
	/** on the surface */
	point_m: Vec2;
	/** outward there; of edges and chains towards the point */
	normal: Vec2;
}

/** Distance of two shapes. */
export interface Distance {
	/** on the surface of a, in the world */
	point_a_m: Vec2;
	/** on the surface of b */
	point_b_m: Vec2;
	/** unit, from a to b */
	normal: Vec2;
	/** of the surfaces; negative: the depth, the shortest translation of b out of a */
	distance_m: number;
	/** 0 */
	reserved: number;
}

/** A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about it
at a constant rate. */
export interface Sweep {
	/** of the shape, before the motion */
	start: Pose;
	/** that point, in the shape's frame: the centre of mass of a body */
	center_m: Vec2;
	/** of it; at most 2e6 m each way */
	translation_m: Vec2;
	/** counter-clockwise, |turn| <= 1e4 */
	turn_rad: number;
	/** 0 */
	reserved: number;
}

/** Result of cn_polygon_time_of_impact. */
export interface Impact {
	/** CN_IMPACT_* */
	state: number;
	/** of both motions, [0, 1] */
	fraction: number;
	/** HIT only, as are the next two: between the surfaces */
	point_m: Vec2;
	/** unit, from a to b */
	normal: Vec2;
	/** of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it */
	distance_m: number;
	/** 0 */
	reserved: number;
}

/** A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t >= 0, unless
that needs a push of more than push_max_m. */
export interface Plane {
	/** unit, from the surface to the shape */
	normal: Vec2;
	/** world point of least distance */
	point_m: Vec2;
	/** of the surfaces along the normal; negative: they overlap */
	separation_m: number;
	/** greatest push of this plane, >= 0; FLT_MAX: rigid */
	push_max_m: number;
	/** its push in the last cn_mover_solve */
	push_m: number;
	/** whose surface it is */
	shape: Shape;
	/** the shape's */
	body: Body;
	/** edge of a chain */
	child: number;
}

/** How a character moves. It may change between moves: crouching is another shape. */
export interface MoverDef {
	/** set by the init function */
	struct_size: number;
	/** CN_MOVER_DROP; default 0 */
	flags: number;
	/** around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule of
	radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly */
	shape: Polygon;
	/** shapes that it collides with; sensors never, one-way shapes from above */
	filter: QueryFilter;
	/** any length > 0; default (0, 1) */
	up: Vec2;
	/** greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees) */
	slope_limit_rad: number;
	/** greatest height of steps that it climbs, >= 0; default 0.3 */
	step_height_m: number;
	/** a walking character follows ground that falls by up to this in a move, >= 0; default 0.3 */
	snap_m: number;
	/** of the world's gravity in the air; default 1 */
	gravity_scale: number;
	/** greatest push on a dynamic body, >= 0; default 200 */
	push_force_N: number;
	/** of sliding, 1 to 64; default 8 */
	iterations_max: number;
}

/** State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The
world does not know it, and bodies do not collide with it: for that give it a kinematic body that is
filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the position. */
export interface Mover {
	/** of the shape's origin, world */
	position_m: Vec2;
	/** in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its
	component across up; the one along up is 0, and a jump when the caller makes it > 0 */
	velocity_mps: Vec2;
	/** of the ground with CN_MOVER_ON_GROUND, else (0, 0) */
	ground_normal: Vec2;
	/** in the world, after the move */
	ground_point_m: Vec2;
	/** ... in the frame of ground_body */
	ground_local_m: Vec2;
	/** of the ground there */
	ground_velocity_mps: Vec2;
	/** 0: none; a stale handle counts as none */
	ground_body: Body;
	/** the same for its shape */
	ground_shape: Shape;
	/** CN_MOVER_ON_*, after the last move */
	flags: number;
	/** overlap with surfaces that leave it no room; else 0 up to rounding */
	squeezed_m: number;
}

/** What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without gravity.
Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes; their
accelerations, damping and forces add up. */
export interface AreaDef {
	/** set by the init function */
	struct_size: number;
	/** CN_AREA_REPLACE; default 0 */
	flags: number;
	/** default 0 */
	priority: number;
	/** acceleration in the axes of the world, times the body's gravity_scale; default (0, 0) */
	gravity_mps2: Vec2;
	/** of pull_mps2, in the frame of the sensor's body; default (0, 0) */
	center_m: Vec2;
	/** acceleration towards center_m; negative pushes; default 0 */
	pull_mps2: number;
	/** CN_DEFAULT (default): pull_mps2 at every distance; > 0, to 1e6 length units: at this distance, with its
	inverse square outside, and falling to 0 at the centre: a homogeneous planet */
	pull_distance_m: number;
	/** of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with
	density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0 */
	linear_damping_per_s: number;
	/** ... of the rotation; 0 to 1e9, default 0 */
	angular_damping_per_s: number;
	/** of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default 0
	*/
	density_kgpm2: number;
	/** density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0 */
	drag_kgpm2: number;
	/** density times lift coefficient; 0 to 1e9, default 0 */
	lift_kgpm2: number;
	/** velocity of the medium relative to the sensor, in the axes of the world; default (0, 0) */
	flow_mps: Vec2;
}

/** Definition of an explosion. */
export interface ExplosionDef {
	/** set by the init function */
	struct_size: number;
	/** full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1 */
	radius_m: number;
	/** then linearly to 0 over this distance, 0 to 1e6 length units; default 0 */
	falloff_m: number;
	/** per metre of the shape's width seen from the centre; negative pulls; default 0 */
	impulse_Nspm: number;
	/** world */
	center_m: Vec2;
	/** which shapes; defaults: see cn_query_filter */
	filter: QueryFilter;
}

/** The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
coordinates. */
export interface DebugDraw {
	/** set by the init function */
	struct_size: number;
	/** CN_DRAW_*; default SHAPES | JOINTS | CONTACTS */
	flags: number;
	/** things outside are not drawn; default everything */
	view: Aabb;
}

/** A world with everything in it. It is destroyed by destroy(), else some time after nothing refers to it. */
export class World {
	constructor(def?: Partial<WorldDef>);
	/** For functions of raw. */
	readonly pointer: number;
	destroy(): void;
	/** A world from the bytes of write. Of the definition only workers and capacities are used. */
	static read(file: Uint8Array, def?: Partial<WorldDef>): World;
	/** Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
	O(awake bodies and their contacts and joints). */
	step(dt_s: number): void;
	/** Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies). */
	setGravity(gravity_x_mps2: number, gravity_y_mps2: number): void;
	/** Reads gravity in m/s^2. */
	getGravity(): Vec2;
	/** Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more. */
	setSubstepCount(count: number): void;
	/** Reads the substeps of a step. */
	getSubstepCount(): number;
	/** Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
	memory of the solver it was created with; a solver that needs more works without direct solving
	(CN_WARNING_FRAME_MEMORY). */
	setSolver(solver: number): void;
	/** Reads the solver (CN_SOLVER_*). */
	getSolver(): number;
	/** Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT. */
	setAccuracy(accuracy_m: number, work_budget: number): void;
	/** Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
	(CN_DEFAULT: none). */
	getAccuracy(): { accuracy_m: number; work_budget: number };
	/** Reads how many workers a step can use: 1, or worker_count where the library supports threads. */
	getWorkerCount(): number;
	/** Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies). */
	setFlags(flags: number): void;
	/** Reads the CN_WORLD_ flags. */
	getFlags(): number;
	/** Impacts slower than this, in m/s, do not bounce; >= 0. */
	setRestitutionThreshold(speed_mps: number): void;
	/** Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0. */
	setHitSpeed(speed_mps: number): void;
	/** Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows faster bodies
	down to them and keeps the direction. */
	setSpeedLimits(linear_mps: number, angular_radps: number): void;
	/** Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after which
	they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those others
	that no joint holds and that are slower than four times the speed lose theirs within a second or two: what
	rocks in a hollow would keep all of a heap awake. */
	setSleep(speed_mps: number, delay_s: number): void;
	/** Stores a number for the user. */
	setUserData(user_data: number | bigint): void;
	/** Reads the user's number. */
	getUserData(): bigint;
	/** Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL when
	capacity is 0. out_count is their number. O(slots). */
	getBodies(): Body[];
	/** Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies. O(slots).
	*/
	getShapes(): Shape[];
	/** Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
	cn_world_get_bodies. O(slots). */
	getJoints(): Joint[];
	/** Reads counts of objects and what the last step reported. O(bodies + islands). */
	getCounters(): Counters;
	/** Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in a
	deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their number. A step
	does no work for it. O(bodies + contacts and joints of the islands written). */
	getIslands(): IslandReport[];
	/** Reads the seconds of the last step by stage. */
	getProfile(): Profile;
	/** Reads the memory statistics. */
	getMemoryStats(): MemoryStats;
	/** Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every position p
	becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes, world
	anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay, and no event
	is reported. Distances between bodies keep their digits; world anchors are rounded to floats at the new
	place. Arrays returned before become invalid; the user moves their own points (movers, rays, cached poses).
	CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all pairs again. */
	shiftOrigin(x_m: number, y_m: number): void;
	/** 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
	contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on every
	compiler, CPU and thread count. O(bodies + contacts + joints). */
	hash(): bigint;
	/** Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots). */
	saveSize(): bigint;
	/** Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
	number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about
	1 KB per body. */
	save(): Uint8Array;
	/** Restores a saved state, into the saved world or one created with the same definition (broadphase, length
	unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT for
	damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the objects alive then (a world
	in a caller's block has room for its own saves). Arrays returned before become invalid. Handles of objects
	alive at the save are valid again, also of objects destroyed since; handles created since are refused until
	the same handle is given to a new object: with the same calls to the same object. O(memory of the world). */
	restore(save: Uint8Array): void;
	/** Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots). */
	writeSize(): bigint;
	/** Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number of
	bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1 KB per
	body. */
	write(): Uint8Array;
	/** Creates a body. O(1) amortized. */
	bodyCreate(def: In<BodyDef>): Body;
	/** Creates count (>= 0) bodies from an array of definitions, all or none. O(count). */
	bodyCreateMany(defs: In<BodyDef>[], out_bodies?: Body[] | null): Body[];
	/** Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
	contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts +
	joints + shapes). */
	bodyDestroy(body: Body): void;
	/** Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice. O(their
	contacts + joints + shapes). */
	bodyDestroyMany(bodies: In<Body>[]): void;
	/** 1 if the handle names a living body of this world, else 0 (also for a NULL world). */
	bodyIsValid(body: Body): boolean;
	/** Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that
	still overlap begin again in the next step), with its forces and any mass override; a body made static stops.
	CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints + shapes). */
	bodySetType(body: Body, type: number): void;
	/** Reads the type (CN_BODY_*). */
	bodyGetType(body: Body): number;
	/** Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
	CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints are
	inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes. */
	bodySetFlags(body: Body, flags: number): void;
	/** Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake. */
	bodyGetFlags(body: Body): number;
	/** 0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled
	bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island). */
	bodySetAwake(body: Body, awake: number): void;
	/** Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle| <= 1e4).
	Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports them. Gaps of
	its joints close at some 15 length units a second. Wakes the body and its new and old neighbours. O(contacts
	+ joints + shapes). */
	bodySetPose(body: Body, position_x_m: number, position_y_m: number, angle_rad: number): void;
	/** Reads the position of the origin and the rotation. */
	bodyGetPose(body: Body): Pose;
	/** Reads the position of the origin as the sum of two floats: the high part is within rounding that of
	cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in double is
	more precise; so is a difference of two bodies, taken high from high and low from low, in floats. */
	bodyGetPositionParts(body: Body): { high_m: Vec2; low_m: Vec2 };
	/** Reads the angle in radians, in (-pi, pi]. */
	bodyGetAngle(body: Body): number;
	/** Reads the world position of the centre of mass, in metres. */
	bodyGetCenter(body: Body): Vec2;
	/** Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
	CN_ERROR_STATE for static bodies. Wakes the body unless all are 0. */
	bodySetVelocity(body: Body, linear_x_mps: number, linear_y_mps: number, angular_radps: number): void;
	/** Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s). */
	bodyGetVelocity(body: Body): Velocity;
	/** Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes
	it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike after
	cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this before every step, or
	stop the body after it. */
	bodySetTargetPose(body: Body, position_x_m: number, position_y_m: number, angle_rad: number, dt_s: number): void;
	/** Velocity in m/s of the body's material at a world point in metres. */
	bodyGetVelocityAt(body: Body, point_x_m: number, point_y_m: number): Vec2;
	/** World position of a point given in the body's frame, both in metres. */
	bodyGetWorldPoint(body: Body, local_x_m: number, local_y_m: number): Vec2;
	/** Position in the body's frame of a world point, both in metres. */
	bodyGetLocalPoint(body: Body, world_x_m: number, world_y_m: number): Vec2;
	/** Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
	O(shapes). */
	bodyGetAabb(body: Body): Aabb;
	/** Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic
	and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows. */
	bodyApplyForce(body: Body, force_x_N: number, force_y_N: number): void;
	/** Adds a force in newtons at a world point in metres, hence a torque too; otherwise as cn_body_apply_force.
	*/
	bodyApplyForceAt(body: Body, force_x_N: number, force_y_N: number, point_x_m: number, point_y_m: number): void;
	/** Adds a torque in newton metres; otherwise as cn_body_apply_force. */
	bodyApplyTorque(body: Body, torque_Nm: number): void;
	/** Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
	Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity overflows. */
	bodyApplyImpulse(body: Body, impulse_x_Ns: number, impulse_y_Ns: number): void;
	/** Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too;
	otherwise as cn_body_apply_impulse. */
	bodyApplyImpulseAt(body: Body, impulse_x_Ns: number, impulse_y_Ns: number, point_x_m: number, point_y_m: number): void;
	/** Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
	cn_body_apply_impulse. */
	bodyApplyAngularImpulse(body: Body, impulse_Nms: number): void;
	/** Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
	shapes have no mass weighs 1 kg; without shapes it does not rotate. */
	bodyGetMassData(body: Body): MassData;
	/** Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
	change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes the
	body. */
	bodySetMassData(body: Body, mass: In<MassData>): void;
	/** Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes). */
	bodyResetMassData(body: Body): void;
	/** Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0. */
	bodySetDamping(body: Body, linear_per_s: number, angular_per_s: number): void;
	/** Reads the linear and angular damping in 1/s. */
	bodyGetDamping(body: Body): { linear_per_s: number; angular_per_s: number };
	/** Sets the factor on gravity for this body, finite. A change wakes the body. */
	bodySetGravityScale(body: Body, scale: number): void;
	/** Reads the factor on gravity. */
	bodyGetGravityScale(body: Body): number;
	/** Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's. */
	bodySetSleepSpeed(body: Body, speed_mps: number): void;
	/** Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
	(default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other bodies ask
	for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and within the
	work_budget. Takes effect with the next step; does not wake. */
	bodySetSolver(body: Body, solver: number): void;
	/** Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT). */
	bodyGetSolver(body: Body): number;
	/** Stores a number for the user. */
	bodySetUserData(body: Body, user_data: number | bigint): void;
	/** Reads the user's number. */
	bodyGetUserData(body: Body): bigint;
	/** Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
	O(length). */
	bodySetName(body: Body, name?: string | null): void;
	/** Reads the name, "" if there is none. Valid until the name changes or the body is destroyed. */
	bodyGetName(body: Body): string;
	/** Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes). */
	bodyGetShapes(body: Body): Shape[];
	/** Handles of the body's joints without constraints; out, capacity and *out_count as in cn_world_get_bodies.
	O(joints). */
	bodyGetJoints(body: Body): Joint[];
	/** Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be
	their number. One bad handle fails the whole call. O(count). */
	readPoses(bodies?: In<Body>[] | null, out?: Float32Array | null): Float32Array;
	/** Reads count velocities; bodies and count as in cn_world_read_poses. O(count). */
	readVelocities(bodies?: In<Body>[] | null, out?: Float32Array | null): Float32Array;
	/** Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
	bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count). */
	writeVelocities(velocities: In<Velocity>[] | Float32Array, bodies?: In<Body>[] | null): void;
	/** Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The
	first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY. */
	moved(): BodyMoved[];
	/** Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL. */
	shapeCreateCircle(def: In<ShapeDef>, circle: In<Circle>): Shape;
	/** Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes the body. out_shape
	may be NULL. */
	shapeCreateCapsule(def: In<ShapeDef>, capsule: In<Capsule>): Shape;
	/** Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL. */
	shapeCreateEdge(def: In<ShapeDef>, edge: In<Edge>): Shape;
	/** Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
	out_shape may be NULL. */
	shapeCreatePolygon(def: In<ShapeDef>, polygon: In<Polygon>): Shape;
	/** Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the body. out_shape
	may be NULL. */
	shapeCreateBox(def: In<ShapeDef>, half_width_m: number, half_height_m: number, radius_m: number): Shape;
	/** Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape
	may be NULL. O(count). */
	shapeCreateChain(def: In<ShapeDef>, chain: In<Chain>): Shape;
	/** Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one.
	CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain). */
	shapeAttach(shape: Shape, body: Body): void;
	/** Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body.
	O(contacts + shapes of the body). */
	shapeDetach(shape: Shape): void;
	/** Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body). */
	shapeDestroy(shape: Shape): void;
	/** 1 if the handle names a living shape of this world, else 0 (also for a NULL world). */
	shapeIsValid(shape: Shape): boolean;
	/** Reads the type (CN_SHAPE_CIRCLE to _CHAIN). */
	shapeGetType(shape: Shape): number;
	/** Reads the body; 0 if unattached. */
	shapeGetBody(shape: Shape): Body;
	/** Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
	body). */
	shapeSetMaterial(shape: Shape, material: In<Material>): void;
	/** Reads the material. */
	shapeGetMaterial(shape: Shape): Material;
	/** Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and wakes
	the body. O(shapes of the body). */
	shapeSetDensity(shape: Shape, density_kgpm2: number): void;
	/** Reads the density in kg/m^2. */
	shapeGetDensity(shape: Shape): number;
	/** Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
	begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body). */
	shapeSetFilter(shape: Shape, filter: In<Filter>): void;
	/** Reads the filter. */
	shapeGetFilter(shape: Shape): Filter;
	/** Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts too. O(contacts of
	the body). */
	shapeSetEventMask(shape: Shape, event_mask: number): void;
	/** Reads the event mask. */
	shapeGetEventMask(shape: Shape): number;
	/** Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next
	step. Wakes the body, or the bodies near a static shape. O(contacts of the body). */
	shapeSetFlags(shape: Shape, flags: number): void;
	/** Reads the CN_SHAPE_ flags. */
	shapeGetFlags(shape: Shape): number;
	/** Stores a number for the user. */
	shapeSetUserData(shape: Shape, user_data: number | bigint): void;
	/** Reads the user's number. */
	shapeGetUserData(shape: Shape): bigint;
	/** AABB without margin, in the world (in the shape's own space when unattached). O(points). */
	shapeGetAabb(shape: Shape): Aabb;
	/** Mass at the present density, centre in the body's frame, inertia about the shape's own centre. O(points).
	*/
	shapeGetMassData(shape: Shape): MassData;
	/** Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type. */
	shapeGetCircle(shape: Shape): Circle;
	/** Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type. */
	shapeGetCapsule(shape: Shape): Capsule;
	/** Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type. */
	shapeGetEdge(shape: Shape): Edge;
	/** Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type. */
	shapeGetPolygon(shape: Shape): Polygon;
	/** Reads a chain's points in the body's frame, offset applied. Writes at most capacity (>= 0); out may be
	NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points written). */
	shapeGetChainPoints(shape: Shape): Float32Array;
	/** Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks of
	creation: the handle and all other properties stay. Mass and box are those of the new geometry at once;
	contacts stay unless the boxes no longer overlap, and the next step computes them anew, without the impulses
	of features that are gone. Wakes the body, touching bodies and bodies that the new box meets. A shape that
	grows into others is pushed out of them at push_speed_max_mps at most. CN_ERROR_STATE for another type.
	O(contacts + shapes of the body). */
	shapeSetCircle(shape: Shape, circle: In<Circle>): void;
	/** Replaces a capsule in place; otherwise as cn_shape_set_circle. */
	shapeSetCapsule(shape: Shape, capsule: In<Capsule>): void;
	/** Replaces an edge in place; otherwise as cn_shape_set_circle. */
	shapeSetEdge(shape: Shape, edge: In<Edge>): void;
	/** Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle. */
	shapeSetPolygon(shape: Shape, polygon: In<Polygon>): void;
	/** Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
	begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body + count). */
	shapeSetChain(shape: Shape, chain: In<Chain>): void;
	/** out_inside is 1 if the shape contains a world point in metres (in the shape's own space when unattached),
	else 0. Edges and chains contain no point. O(points). */
	shapeTestPoint(shape: Shape, point_x_m: number, point_y_m: number): number;
	/** The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
	for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED inside
	callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved apart, body
	or shape destroyed, detached or disabled, filter or type changed). The next step reports pairs that end
	between two steps; their handles may be stale. A sleeping pair reports nothing, and continues when it wakes.
	HIT: in some substep a point closed at approach_speed_mps, the greatest of the step, and got an impulse;
	bodies that pass a blow on to others that already touch them, without closing, have no HIT. Impulses are
	summed only for contacts that report ENTER (in the step in which they begin), STAY or HIT. */
	contactEvents(kind: number): ContactEvent[];
	/** The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
	events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and kinematic
	bodies by exact overlap: a chain is a line with two sides here, which meets no edges or chains. A pair
	without an awake body reports nothing until one wakes. */
	sensorEvents(): SensorEvent[];
	/** The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
	sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the impulses
	of the last substep. At rest their force is that of the points times substep_count (with CN_SOLVER_SEQUENTIAL
	1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0. *out_count is their number.
	O(contacts). */
	bodyGetContacts(body: Body): ContactEvent[];
	/** The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
	cn_body_get_contacts. O(contacts of its body). */
	shapeGetContacts(shape: Shape): ContactEvent[];
	/** The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
	and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of its
	body), squared for chains. */
	shapeGetVisitors(sensor: Shape): Shape[];
	/** Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
	destroyed since are stale. */
	fellAsleep(): Body[];
	/** Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
	is dynamic. O(contacts of body_a). */
	jointCreateRevolute(def: In<RevoluteDef>): Joint;
	/** Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
	is dynamic. O(contacts of body_a). */
	jointCreateDistance(def: In<DistanceDef>): Joint;
	/** Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreateFixed(def: In<FixedDef>): Joint;
	/** Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
	is dynamic. O(contacts of body_a). */
	jointCreatePrismatic(def: In<PrismaticDef>): Joint;
	/** Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreateWheel(def: In<WheelDef>): Joint;
	/** Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreateMotor(def: In<MotorDef>): Joint;
	/** Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic, or body_a is not 0. O(contacts of body_a). */
	jointCreateMouse(def: In<MouseDef>): Joint;
	/** Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreateGear(def: In<GearDef>): Joint;
	/** Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreatePulley(def: In<PulleyDef>): Joint;
	/** Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreateRatchet(def: In<RatchetDef>): Joint;
	/** Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic. O(contacts of body_a). */
	jointCreateRotarySpring(def: In<RotarySpringDef>): Joint;
	/** Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
	dynamic, or the slot has no length. O(contacts of body_a). */
	jointCreateGroove(def: In<GrooveDef>): Joint;
	/** Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
	bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of body_a).
	*/
	jointCreateFilter(def: In<FilterJointDef>): Joint;
	/** Destroys a joint and wakes its bodies. No event is reported. */
	jointDestroy(joint: Joint): void;
	/** 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world). */
	jointIsValid(joint: Joint): boolean;
	/** Reads the type (CN_JOINT_REVOLUTE to _FILTER). */
	jointGetType(joint: Joint): number;
	/** Reads both bodies; 0 stands for the world. */
	jointGetBodies(joint: Joint): { a: Body; b: Body };
	/** Reads the world positions of both anchors, in metres. */
	jointGetAnchors(joint: Joint): { world_a_m: Vec2; world_b_m: Vec2 };
	/** Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
	after a change of type or of CN_BODY_ENABLED of one of its bodies. */
	jointGetReaction(joint: Joint): { force_N: Vec2; torque_Nm: number };
	/** Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits) and radians
	(angles beyond limits). */
	jointGetError(joint: Joint): { m: number; rad: number };
	/** Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
	together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all connected
	joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a world in a
	caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step; does not wake. */
	jointSetSolver(joint: Joint, solver: number): void;
	/** Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT). */
	jointGetSolver(joint: Joint): number;
	/** Stores a number for the user. */
	jointSetUserData(joint: Joint, user_data: number | bigint): void;
	/** Reads the user's number. */
	jointGetUserData(joint: Joint): bigint;
	/** Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
	jointSetFlags(joint: Joint, flags: number): void;
	/** Reads the CN_JOINT_ flags. */
	jointGetFlags(joint: Joint): number;
	/** Reads the definition of a revolute joint. CN_ERROR_STATE for another type. */
	jointGetRevolute(joint: Joint): RevoluteDef;
	/** Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetRevolute(joint: Joint, def: In<RevoluteDef>): void;
	/** Reads the definition of a distance joint. CN_ERROR_STATE for another type. */
	jointGetDistance(joint: Joint): DistanceDef;
	/** Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetDistance(joint: Joint, def: In<DistanceDef>): void;
	/** Reads the definition of a fixed joint. CN_ERROR_STATE for another type. */
	jointGetFixed(joint: Joint): FixedDef;
	/** Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetFixed(joint: Joint, def: In<FixedDef>): void;
	/** Reads the definition of a prismatic joint. CN_ERROR_STATE for another type. */
	jointGetPrismatic(joint: Joint): PrismaticDef;
	/** Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetPrismatic(joint: Joint, def: In<PrismaticDef>): void;
	/** Reads the definition of a wheel joint. CN_ERROR_STATE for another type. */
	jointGetWheel(joint: Joint): WheelDef;
	/** Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetWheel(joint: Joint, def: In<WheelDef>): void;
	/** Reads the definition of a motor joint. CN_ERROR_STATE for another type. */
	jointGetMotorTo(joint: Joint): MotorDef;
	/** Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetMotorTo(joint: Joint, def: In<MotorDef>): void;
	/** Reads the definition of a mouse joint. CN_ERROR_STATE for another type. */
	jointGetMouse(joint: Joint): MouseDef;
	/** Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
	struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
	CN_JOINT_COLLIDE changes. */
	jointSetMouse(joint: Joint, def: In<MouseDef>): void;
	/** Reads the definition of a gear joint. CN_ERROR_STATE for another type. */
	jointGetGear(joint: Joint): GearDef;
	/** Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
	struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes both
	bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
	jointSetGear(joint: Joint, def: In<GearDef>): void;
	/** Reads the definition of a pulley joint. CN_ERROR_STATE for another type. */
	jointGetPulley(joint: Joint): PulleyDef;
	/** Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetPulley(joint: Joint, def: In<PulleyDef>): void;
	/** Reads the definition of a ratchet joint. CN_ERROR_STATE for another type. */
	jointGetRatchet(joint: Joint): RatchetDef;
	/** Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
	struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both
	bodies. O(contacts) when CN_JOINT_COLLIDE changes. */
	jointSetRatchet(joint: Joint, def: In<RatchetDef>): void;
	/** Reads the definition of a rotary spring. CN_ERROR_STATE for another type. */
	jointGetRotarySpring(joint: Joint): RotarySpringDef;
	/** Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetRotarySpring(joint: Joint, def: In<RotarySpringDef>): void;
	/** Reads the definition of a groove joint. CN_ERROR_STATE for another type. */
	jointGetGroove(joint: Joint): GrooveDef;
	/** Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
	struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
	*/
	jointSetGroove(joint: Joint, def: In<GrooveDef>): void;
	/** Reads the base of a joint of any type. */
	jointGetBase(joint: Joint): JointBase;
	/** Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as
	in cn_joint_base. Wakes both bodies. */
	jointSetBase(joint: Joint, base: In<JointBase>): void;
	/** Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE
	for another type. Wakes the body. */
	jointSetTarget(joint: Joint, target_x_m: number, target_y_m: number): void;
	/** Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
	reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the translation
	along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet, rotary spring:
	angle b - angle a; these three over whole turns. */
	jointGetPosition(joint: Joint): number;
	/** Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A positive
	motor speed has the same sign. */
	jointGetSpeed(joint: Joint): number;
	/** Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute, distance,
	prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies. */
	jointSetMotor(joint: Joint, speed: number, force_or_torque_max: number): void;
	/** Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >= 0), prismatic
	or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies. */
	jointSetLimits(joint: Joint, lower: number, upper: number): void;
	/** Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body
	in that step or between it and the step before. */
	jointEvents(): JointEvent[];
	/** Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
	not dynamic. Wakes the body. */
	constraintCreateAngle(def: In<AngleConstraintDef>): Constraint;
	/** Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
	dynamic. Wakes the body. */
	constraintCreateLine(def: In<LineConstraintDef>): Constraint;
	/** Destroys a constraint and wakes its body. No event is reported. */
	constraintDestroy(constraint: Constraint): void;
	/** 1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world). */
	constraintIsValid(constraint: Constraint): boolean;
	/** Reads the type (CN_CONSTRAINT_ANGLE or _LINE). */
	constraintGetType(constraint: Constraint): number;
	/** Reads the body. */
	constraintGetBody(constraint: Constraint): Body;
	/** Reads the definition of an angle constraint. CN_ERROR_STATE for another type. */
	constraintGetAngle(constraint: Constraint): AngleConstraintDef;
	/** Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
	body. */
	constraintSetAngle(constraint: Constraint, def: In<AngleConstraintDef>): void;
	/** Reads the definition of a line constraint. CN_ERROR_STATE for another type. */
	constraintGetLine(constraint: Constraint): LineConstraintDef;
	/** Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
	body. */
	constraintSetLine(constraint: Constraint, def: In<LineConstraintDef>): void;
	/** Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
	along the axis, in metres from origin. */
	constraintGetPosition(constraint: Constraint): number;
	/** Force in newtons and torque in newton metres that the constraint applied to the body in the last substep.
	*/
	constraintGetReaction(constraint: Constraint): { force_N: Vec2; torque_Nm: number };
	/** Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an angle constraint.
	*/
	constraintGetError(constraint: Constraint): { m: number; rad: number };
	/** Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
	O(slots). */
	getConstraints(): Constraint[];
	/** Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
	constraints of the body). */
	bodyGetConstraints(body: Body): Constraint[];
	/** Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an
	update, 1 to 1000, default 8. */
	setFixedStep(step_s: number, steps_max: number): void;
	/** Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
	event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps. */
	update(elapsed_s: number): UpdateReport;
	/** Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step, 1
	after it. Bodies that did not take part in the last step have their present pose. bodies and count as in
	cn_world_read_poses. O(count). */
	readPosesInterpolated(factor: number, bodies?: In<Body>[] | null, out?: Float32Array | null): Float32Array;
	/** Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains from
	their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child. filter may
	be NULL: the defaults. O(log shapes) to O(shapes along the ray). */
	castRay(ray: In<Ray>, filter?: In<QueryFilter> | null): RayHit;
	/** out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log
	shapes) to O(shapes along the ray). */
	castRayAny(ray: In<Ray>, filter?: In<QueryFilter> | null): number;
	/** Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number found. A
	chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity). */
	castRayAll(ray: In<Ray>, filter?: In<QueryFilter> | null): RayHit[];
	/** Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call. filter
	may be NULL. O(sum of the rays). */
	castRays(rays: In<Ray>[], filter?: In<QueryFilter> | null, out?: RayHit[] | null): RayHit[];
	/** Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
	O(points of the shape). */
	shapeCastRay(shape: Shape, ray: In<Ray>): RayHit;
	/** First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
	way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may be 1 or 2:
	circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of the moving
	points is in front of it. filter may be NULL. O(shapes along the way). */
	castShape(shape: In<Polygon>, translation_x_m: number, translation_y_m: number, filter?: In<QueryFilter> | null): RayHit;
	/** Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
	cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number found. filter
	may be NULL. O(log shapes) to O(boxes in the region). */
	overlapAabb(box: In<Aabb>, filter?: In<QueryFilter> | null): Shape[];
	/** Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb. Edges
	and chains are lines here, seen from both sides. */
	overlapCircle(circle: In<Circle>, filter?: In<QueryFilter> | null): Shape[];
	/** Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as in
	cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides. */
	overlapPolygon(polygon: In<Polygon>, filter?: In<QueryFilter> | null): Shape[];
	/** Shapes that contain a world point in metres; order, capacity, filter and cost as in
	cn_world_overlap_aabb. Edges and chains contain no point. */
	overlapPoint(x_m: number, y_m: number, filter?: In<QueryFilter> | null): Shape[];
	/** Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
	contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m. */
	closestPoint(x_m: number, y_m: number, distance_max_m: number, filter?: In<QueryFilter> | null): Closest;
	/** Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved
	by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of least separation
	first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way shape has a plane
	only on its upper side, and only for an overlap of at most 0.5% of the length unit plus its rise in the last
	step. Shapes wholly behind the plane of another shape are left out, so that seams of tiles do not catch (not
	if capacity is too small for all). O(shapes nearby, squared). */
	moverCollide(shape: In<Polygon>, position_x_m: number, position_y_m: number, margin_m: number, filter?: In<QueryFilter> | null): Plane[];
	/** Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one step behind
	the ground that carries it. 1. carried   by the motion of its ground since the last move: of the point of
	ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across up, along the ground,
	at the same speed uphill and downhill; no gravity, so that it does not creep. A step up where a too steep
	surface blocks it: up by step_height_m, forward, down on walkable ground flying    in the air: velocity_mps
	and gravity (exact for constant gravity). Jumping and walking off keep ground_velocity_mps 3. sliding   both
	by collision planes, cn_mover_solve and casts, up to iterations_max times: no speed passes through a wall 4.
	pushing   dynamic bodies in the way get a force for the next step that brings them to the character's
	velocity, of at most push_force_N each 5. ground    ground that it touches, or that lies within snap_m below
	a walking character; velocity_mps loses blocked components The result depends on the world, def and mover
	alone: equal calls give equal bits. The loop of planes, solver and cast is that of Box2D 3's sample of a
	character mover (Catto, 2025). Pushed bodies wake; nothing else in the world changes. O(shapes nearby x
	iterations_max): about 1 us standing, 3 us walking, 10 us against a wall. */
	moverMove(def: In<MoverDef>, dt_s: number, mover: Mover): void;
	/** Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter says
	which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an area that
	loses the flag later does nothing while it is without. Gravity, and damping without density, act on bodies
	whose centre of mass is in the area (on its border too) while one of their shapes touches it: on a body half
	in it in full or not at all. The medium acts on the part of each shape that is in the area, exactly for
	polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The surface of a circle
	or capsule is flat across a body, as of a planet. Shapes of a body do not shade each other. The area's body
	feels no reaction. Between steps nothing happens: the acceleration is that in the middle of the next step
	(leapfrog), so bodies on orbits and floating bodies keep their energy. Damping and drag are implicit: stable
	at any strength, mass and time step, with exact terminal speeds. Bodies that enter or leave, that are in an
	area that moves, and those in it now, wake; bodies at rest in it may sleep. Areas are in saves and files.
	Floats whose draught is less than about g dt^2 (3 mm at 60 steps a second) are damped, and carry less under a
	load. An area takes 64 bytes of the world's memory; a step takes about 0.15 us for each shape in an area,
	0.35 us in a medium. Best on a body of its own: O(contacts of the body). */
	shapeSetArea(shape: Shape, def?: In<AreaDef> | null): void;
	/** Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas). */
	shapeGetArea(shape: Shape): AreaDef;
	/** The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each step.
	flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w across it, with
	u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton (1687), and across the
	flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle between surface and flow (Hoerner,
	1985). Both 0 to 1e9: densities times coefficients. Exact for the whole outline, round parts included, and
	drag along straight edges also for turning bodies; edges and chains are plates with two sides. Solved
	implicitly, so that wind never reverses the motion relative to it, at any speed, mass and time; a pure drag
	is the exact solution of m v' = -k v^2. wake 0: sleeping bodies stay asleep and unchanged; else they wake.
	Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE for a shape without a body. O(points). */
	shapeApplyWind(shape: Shape, flow_x_mps: number, flow_y_mps: number, drag_kgpm2: number, lift_kgpm2: number, dt_s: number, wake: number): void;
	/** Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
	them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that). */
	explode(def: In<ExplosionDef>): void;
}

/** A dynamic AABB tree apart from any world. */
export class Tree {
	constructor(margin_m: number);
	readonly pointer: number;
	/** Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n). */
	insert(box: In<Aabb>, user_data: number | bigint): number;
	/** Removes an item. CN_ERROR_HANDLE for a stale one. O(log n). */
	remove(item: number): void;
	/** Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n).
	CN_ERROR_HANDLE for a stale item. */
	move(item: number, box: In<Aabb>): void;
	/** Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item. */
	getBox(item: number): Aabb;
	/** Reads the number of items and the height of the tree. */
	getStats(): { count: number; height: number };
}

/** Version of the library as major * 1000000 + minor * 1000 + patch. */
export function version(): number;
/** CN_ABI_VERSION of the library that was linked; a binding compares it with its own. */
export function abiVersion(): number;
/** English text for a result code: static, never NULL. */
export function resultText(result: number): string;
/** Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes). */
export function saveDeltaSize(base: Uint8Array, save: Uint8Array): bigint;
/** Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes). */
export function saveDelta(base: Uint8Array, save: Uint8Array): Uint8Array;
/** Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base, CN_ERROR_CAPACITY if
out is too small. O(bytes). */
export function saveApply(base: Uint8Array, delta: Uint8Array): Uint8Array;
/** Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most area.
CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5 mm (below
5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0. O(count^2) at worst.
*/
export function polygonMakeHull(points_m: In<Vec2>[] | Float32Array, radius_m: number): Polygon;
/** A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre by angle_rad
(|angle| <= 1e4); radius_m >= 0. */
export function polygonMakeBox(half_width_m: number, half_height_m: number, center_x_m: number, center_y_m: number, angle_rad: number, radius_m: number): Polygon;
/** Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and without
new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983). Points nearer
than 0.05% of the length unit to the one before and collinear points are dropped, and pieces thinner than that
are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself or has no area. Writes at most
capacity pieces (>= 0; count - 2 always suffice); out may be NULL when capacity is 0. *out_count is the number
of all. 34 KB of stack. O(count^2). */
export function outlineDecompose(points_m: In<Vec2>[] | Float32Array, length_unit_m: number): Polygon[];
/** Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else 0. A
closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself afterwards
if parts of it are nearer than tolerance_m. Writes at most capacity points (>= 0); out may be points_m, or
NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at worst. */
export function outlineSimplify(points_m: In<Vec2>[] | Float32Array, closed: number, tolerance_m: number): Float32Array;
/** An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to 4096),
squares of side cell_m > 0 with the lower left corner of the first at the origin. cells[row * columns +
column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0; *out_count is 0
where there are not so many. The outline is a loop for cn_shape_create_chain, solid on its left:
counter-clockwise around solids, clockwise around holes. Its points are corners of cells. Solid cells that
touch at a corner only are apart; an outline may pass such a corner twice. Writes at most capacity points (>=
0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n log n) for a boundary of
n edges. */
export function outlineFromCells(cells: In<number>[], columns: number, origin_x_m: number, origin_y_m: number, cell_m: number, outline: number): Float32Array;
/** The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2 columns
and rows. A point of an outline lies between two neighbouring samples, by linear interpolation, at least
spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or another one.
cn_outline_simplify removes its collinear points. O(values + n log n). */
export function outlineFromField(values: In<number>[], columns: number, threshold: number, origin_x_m: number, origin_y_m: number, spacing_m: number, outline: number): Float32Array;
/** Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points). */
export function polygonDistance(a: In<Polygon>, pose_a: In<Pose>, b: In<Polygon>, pose_b: In<Pose>): Distance;
/** Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0; *out
as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points). */
export function polygonCast(a: In<Polygon>, pose_a: In<Pose>, b: In<Polygon>, pose_b: In<Pose>, translation_x_m: number, translation_y_m: number): { out: RayHit; hit: number };
/** Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m (0
to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread. O(points). */
export function polygonCollide(a: In<Polygon>, pose_a: In<Pose>, b: In<Polygon>, pose_b: In<Pose>, margin_m: number): Manifold;
/** First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a hit.
Needs no world; runs in any thread. */
export function polygonTimeOfImpact(a: In<Polygon>, sweep_a: In<Sweep>, b: In<Polygon>, sweep_b: In<Sweep>, distance_m: number): Impact;
/** The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957) finds
the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least sum of squared
overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below their limit, else 0
up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it. */
export function moverSolve(planes: Plane[], translation_x_m: number, translation_y_m: number): { translation_m: Vec2; overlap_m: number };
/** The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
cn_mover_solve. Needs no world. O(count^2). */
export function moverClip(planes: In<Plane>[], velocity_x_mps: number, velocity_y_mps: number): Vec2;
