// Code generated from include/cairn.h by bindings/generate.py (make bindings). DO NOT EDIT.

package cairn

/*
#include "cairn.h"
#include <stdlib.h>
*/
import "C"
import (
	"runtime"
	"unsafe"
)

// Constants of cairn.h.
const (
	VersionMajor = 0
	VersionMinor = 1
	VersionPatch = 0
	HeaderAbiVersion = 3
	PolygonMaxVertices = 16
	NameMaxBytes = 63
	PlanesMax = 64
	WorkersMax = 64
	MaxHandles = 1048575
	Default = -1
	OK = 0
	ErrorArgument = -1
	ErrorHandle = -2
	ErrorMemory = -3
	ErrorLocked = -4
	ErrorCapacity = -5
	ErrorState = -6
	ErrorInternal = -7
	ErrorFormat = -8
	TypeVec2 = 0
	TypePose = 1
	TypeVelocity = 2
	TypeAabb = 3
	TypeMassData = 4
	TypeWorldDef = 5
	TypeBodyDef = 6
	TypeShapeDef = 7
	TypeCircle = 8
	TypeCapsule = 9
	TypeEdge = 10
	TypePolygon = 11
	TypeChain = 12
	TypeFilter = 13
	TypeMaterial = 14
	TypeManifoldPoint = 15
	TypeManifold = 16
	TypeContactEvent = 17
	TypeBodyMoved = 18
	TypeRevoluteDef = 19
	TypeDistanceDef = 20
	TypeCounters = 21
	TypeProfile = 22
	TypeMemoryStats = 23
	TypeSensorEvent = 24
	TypeUpdateReport = 25
	TypeDebugDraw = 26
	TypeQueryFilter = 27
	TypeRay = 28
	TypeRayHit = 29
	TypeClosest = 30
	TypeExplosionDef = 31
	TypeFixedDef = 32
	TypePrismaticDef = 33
	TypeWheelDef = 34
	TypeMotorDef = 35
	TypeMouseDef = 36
	TypeGearDef = 37
	TypePulleyDef = 38
	TypeRatchetDef = 39
	TypeRotarySpringDef = 40
	TypeGrooveDef = 41
	TypeFilterJointDef = 42
	TypeJointBase = 43
	TypeJointEvent = 44
	TypeAngleConstraintDef = 45
	TypeLineConstraintDef = 46
	TypeIslandReport = 47
	TypeDistance = 48
	TypeSweep = 49
	TypeImpact = 50
	TypePlane = 51
	TypeMoverDef = 52
	TypeMover = 53
	TypeAreaDef = 54
	TypeCount = 55
	WorldSleep = 1
	WorldWarmStart = 2
	WorldProfile = 4
	WorldContinuous = 8
	ReserveNames = 1
	ReserveChains = 2
	ReserveExtraRows = 4
	ReserveMoved = 8
	SolverAuto = 0
	SolverSoft = 1
	SolverDirect = 2
	SolverSequential = 3
	BroadphaseSweep = 0
	BroadphaseTree = 1
	WarningContactMemory = 1
	WarningFrameMemory = 2
	WarningEventMemory = 4
	WarningCrowd = 8
	WarningNotFinite = 16
	TierSoft = 0
	TierDirect = 1
	TierFree = 2
	TierReasonNone = 0
	TierReasonSettling = 1
	TierReasonNewContact = 2
	TierReasonOverlap = 3
	TierReasonJoint = 4
	TierReasonStressed = 5
	TierReasonSolver = 6
	TierReasonOverride = 7
	TierReasonAlone = 8
	TierReasonMoving = 9
	TierReasonCrowded = 10
	TierReasonWork = 11
	TierReasonKind = 12
	TierReasonNOSet = 13
	TierReasonMemory = 14
	TierReasonJointed = 15
	BodyStatic = 0
	BodyKinematic = 1
	BodyDynamic = 2
	BodyLockX = 1
	BodyLockY = 2
	BodyLockRotation = 4
	BodyBullet = 8
	BodyEnabled = 16
	BodySleep = 32
	BodyAwake = 64
	ShapeCircle = 0
	ShapeCapsule = 1
	ShapePolygon = 2
	ShapeEdge = 3
	ShapeChain = 4
	MixAverage = 0
	MixGeometric = 1
	MixMinimum = 2
	MixMultiply = 3
	MixMaximum = 4
	ShapeSensor = 1
	ShapeSensorSeen = 2
	ShapeOneWay = 4
	ShapePreSolve = 8
	EventCreated = 0
	EventEnter = 1
	EventStay = 2
	EventLeave = 3
	EventDestroyed = 4
	EventHit = 5
	EventKinds = 6
	JointRevolute = 0
	JointDistance = 1
	JointFixed = 2
	JointPrismatic = 3
	JointWheel = 4
	JointMotorTO = 5
	JointMouse = 6
	JointGear = 7
	JointPulley = 8
	JointRatchet = 9
	JointRotarySpring = 10
	JointGroove = 11
	JointFilter = 12
	JointCollide = 1
	JointLimit = 2
	JointMotor = 4
	JointSpring = 8
	JointBreaks = 16
	ConstraintAngle = 0
	ConstraintLine = 1
	ConstraintLimit = 1
	ConstraintBreaks = 2
	QuerySkip = 0
	QueryTake = 1
	QueryStop = 2
	QueryIgnoreJoined = 1
	QueryOneWay = 2
	QueryLeaving = 4
	ImpactNone = 0
	ImpactHit = 1
	ImpactOverlap = 2
	ImpactFailed = 3
	MoverDrop = 1
	MoverONGround = 1
	MoverONWall = 2
	MoverONCeiling = 4
	AreaReplace = 1
	DrawShapes = 1
	DrawJoints = 2
	DrawContacts = 4
	DrawAabbs = 8
	DrawCenters = 16
	DrawIslands = 32
)

// Body: handle of a body; 0: none
type Body uint32

// Shape: handle of a shape; 0: none
type Shape uint32

// Joint: handle of a joint; 0: none
type Joint uint32

// Constraint: handle of a constraint on one body; 0: none
type Constraint uint32

// Vec2: A point, vector or pair of numbers.
type Vec2 struct {
	// to the right
	X float32
	// upwards
	Y float32
}

var _ [unsafe.Sizeof(Vec2{})]byte = [C.sizeof_cn_vec2]byte{}

// Pose: Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
// uploaded to a GPU directly.
type Pose struct {
	// of the body's origin
	PositionM Vec2
	// of the angle
	Cosine float32
	// of the angle
	Sine float32
}

var _ [unsafe.Sizeof(Pose{})]byte = [C.sizeof_cn_pose]byte{}

// Velocity: Velocity of a body.
type Velocity struct {
	// of the centre of mass
	LinearMps Vec2
	// counter-clockwise is positive
	AngularRadps float32
}

var _ [unsafe.Sizeof(Velocity{})]byte = [C.sizeof_cn_velocity]byte{}

// Aabb: Axis-aligned bounding box, lower_m <= upper_m.
type Aabb struct {
	// left and bottom
	LowerM Vec2
	// right and top
	UpperM Vec2
}

var _ [unsafe.Sizeof(Aabb{})]byte = [C.sizeof_cn_aabb]byte{}

// MassData: Mass, inertia and centre of mass.
type MassData struct {
	// of all shapes, or as set
	MassKg float32
	// about the centre of mass
	InertiaKgm2 float32
	// in the body's local frame
	CenterM Vec2
}

var _ [unsafe.Sizeof(MassData{})]byte = [C.sizeof_cn_mass_data]byte{}

// WorldDef: Definition of a world.
type WorldDef struct {
	// set by the init function
	StructSize uint32
	// CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS
	Flags uint32
	// default (0, -10)
	GravityMps2 Vec2
	// a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1
	LengthUnitM float32
	// CN_SOLVER_*; default CN_SOLVER_AUTO
	Solver int32
	// CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP
	Broadphase int32
	// 1 to 64; default 4
	SubstepCount int32
	// CN_SOLVER_AUTO aims at errors below this, >= 0; CN_DEFAULT (default): 0.005 x length unit
	AccuracyM float32
	// limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps
	// included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with
	// CN_SOLVER_AUTO 512 contacts of a world
	WorkBudget int32
	// slower impacts do not bounce, >= 0; CN_DEFAULT (default): 1 x length unit
	RestitutionThresholdMps float32
	// greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved joint
	// closes (of its angles: rad/s, for each length unit), > 0; in a crowd the speeds of neighbours add up: n
	// bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which pushes them
	// upwards, at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit
	PushSpeedMaxMps float32
	// faster bodies are slowed to it, > 0; CN_DEFAULT (default): 400 x length unit
	LinearSpeedMaxMps float32
	// faster bodies are slowed to it, > 0; default 400
	AngularSpeedMaxRadps float32
	// bodies slower than this may sleep, >= 0; CN_DEFAULT (default): 0.05 x length unit
	SleepSpeedMps float32
	// ... after this time, >= 0; default 0.5
	SleepDelayS float32
	// hints for a growing world; one in a block has room for these, and for more as memory permits; >= 0;
	// default 0
	BodyCapacity int32
	// counts every edge of a chain
	ShapeCapacity int32
	// pairs whose fat AABBs overlap
	ContactCapacity int32
	// counts constraints too
	JointCapacity int32
	// a number for the user; default 0
	UserData uint64
	// size of memory; 0: use alloc and free
	MemoryBytes uint64
	// NULL, or one block aligned to 64 bytes that holds the whole world
	c_memory unsafe.Pointer
	// NULL: malloc; set both or none
	c_alloc unsafe.Pointer
	// NULL: free
	c_free unsafe.Pointer
	// last argument of alloc and free
	c_allocator_user unsafe.Pointer
	// NULL: the world's own threads; set both or none
	c_enqueue unsafe.Pointer
	// see cn_finish_fn
	c_finish unsafe.Pointer
	// last argument of enqueue and finish
	c_task_user unsafe.Pointer
	// threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no tasks
	WorkerCount int32
	// blows at least this fast are reported by CN_EVENT_HIT, >= 0; CN_DEFAULT (default): 1 x length unit
	HitSpeedMps float32
	// Of a world in one block (memory); others ignore them. pairs that touch at once, >= 0; further ones do not
	// collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity
	TouchingCapacity int32
	// pairs that report events (event_mask of a shape, sensors), >= 0; further ones report none, which
	// cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity
	EventCapacity int32
	// vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block; default
	// CN_POLYGON_MAX_VERTICES
	VertexCapacity int32
	// CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all
	Reserve uint32
}

var _ [unsafe.Sizeof(WorldDef{})]byte = [C.sizeof_cn_world_def]byte{}

// DefaultWorldDef has the defaults of the fields.
func DefaultWorldDef() WorldDef {
	var value WorldDef
	C.cn_world_def_init((*C.cn_world_def)(unsafe.Pointer(&value)))
	return value
}

// Counters: Counts of objects, and problems of the last step.
type Counters struct {
	// alive
	Bodies int32
	// dynamic and kinematic bodies that are simulated
	BodiesAwake int32
	// alive
	Shapes int32
	// boxes in the broadphase: one per shape, one per edge of a chain
	Proxies int32
	// pairs whose fat boxes overlap
	Contacts int32
	// with an awake body
	ContactsAwake int32
	// pairs with a manifold, asleep or awake
	ContactsTouching int32
	// and constraints
	Joints int32
	// and constraints, with an awake body
	JointsAwake int32
	// awake and asleep; a single dynamic body counts
	Islands int32
	// of them
	IslandsAwake int32
	// groups of contacts that share no dynamic body
	ColorsUsed int32
	// contacts that fit no colour: solved one by one
	OverflowContacts int32
	// cells of the broadphase
	BroadphaseTiles int32
	// steps taken since creation, modulo 2^32
	Steps uint32
	// Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try again.
	// CN_WARNING_*
	Warnings uint32
	// new pairs without a contact
	PairsNotAdded int32
	// events without a place in a log
	EventsNotReported int32
	// of several bodies, solved directly in the last step, contacts included
	IslandsDirect int32
	// planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1
	DirectWork int32
	// of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET
	IslandsUnsolved int32
}

var _ [unsafe.Sizeof(Counters{})]byte = [C.sizeof_cn_counters]byte{}

// IslandReport: Report on one island.
type IslandReport struct {
	// its body of least slot
	Body Body
	// dynamic
	Bodies int32
	// touching
	Contacts int32
	// and constraints
	Joints int32
	// CN_TIER_*, after the last step
	Tier int32
	// CN_TIER_REASON_*
	Reason int32
	// of the last step with dt > 0: the world's, or 1 at rest; freely swinging joints may take more
	Substeps int32
	// at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints
	// that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count
	ResidualM float32
}

var _ [unsafe.Sizeof(IslandReport{})]byte = [C.sizeof_cn_island_report]byte{}

// Profile: Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.
type Profile struct {
	// the whole step
	StepS float32
	// waking
	WakeS float32
	// pairs
	BroadphaseS float32
	// manifolds
	NarrowphaseS float32
	// islands
	IslandsS float32
	// constraints, plans
	PrepareS float32
	// all substeps
	SubstepsS float32
	// poses and boxes
	FinalizeS float32
	// callbacks
	EventsS float32
	// falling asleep
	SleepS float32
}

var _ [unsafe.Sizeof(Profile{})]byte = [C.sizeof_cn_profile]byte{}

// MemoryStats: Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the
// block allocator serves small variable-size pieces from free lists of size classes.
type MemoryStats struct {
	// taken from the user's allocator or carved from the fixed block
	BytesInUse uint64
	// most bytes_in_use since creation
	BytesPeak uint64
	// calls of the user's alloc (or of the fixed block's) since creation
	AllocatorCalls uint64
	// of the frame arena
	ArenaCapacity uint64
	// most bytes in use at once since creation
	ArenaPeak uint64
	// entries that did not fit: the allocator served them; since creation
	ArenaFallbacks uint64
	// bytes in chunks
	BlocksCapacity uint64
	// bytes handed out of them
	BlocksInUse uint64
	// blocks above the largest class, served by the allocator
	BlocksLarge uint64
}

var _ [unsafe.Sizeof(MemoryStats{})]byte = [C.sizeof_cn_memory_stats]byte{}

// BodyDef: Definition of a body.
type BodyDef struct {
	// set by the init function
	StructSize uint32
	// CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic
	Type int32
	// of the origin; |x|, |y| <= 1e6 x length unit
	PositionM Vec2
	// |angle| <= 1e4
	AngleRad float32
	// of the centre of mass; both velocities are ignored without CN_BODY_AWAKE
	LinearVelocityMps Vec2
	// default 0
	AngularVelocityRadps float32
	// v' = -damping v; >= 0, default 0
	LinearDampingPerS float32
	// >= 0, default 0
	AngularDampingPerS float32
	// default 1
	GravityScale float32
	// >= 0; CN_DEFAULT (default): the world's
	SleepSpeedMps float32
	// CN_BODY_*; default ENABLED | SLEEP | AWAKE
	Flags uint32
	// as in cn_body_set_solver; default CN_SOLVER_AUTO
	Solver int32
	// a number for the user; default 0
	UserData uint64
	// NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied
	c_name unsafe.Pointer
}

var _ [unsafe.Sizeof(BodyDef{})]byte = [C.sizeof_cn_body_def]byte{}

// DefaultBodyDef has the defaults of the fields.
func DefaultBodyDef() BodyDef {
	var value BodyDef
	C.cn_body_def_init((*C.cn_body_def)(unsafe.Pointer(&value)))
	return value
}

// BodyMoved: A body that moved or fell asleep in the last step.
type BodyMoved struct {
	// after the step
	Pose Pose
	// the body's
	UserData uint64
	// that moved
	Body Body
	// 1 in the step in which it fell asleep
	FellAsleep uint32
}

var _ [unsafe.Sizeof(BodyMoved{})]byte = [C.sizeof_cn_body_moved]byte{}

// Filter: Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
// collide if the category of each has a bit in the mask of the other.
type Filter struct {
	// default 1
	Category uint64
	// default all ones
	Mask uint64
	// default 0
	Group int32
	// 0
	Reserved uint32
}

var _ [unsafe.Sizeof(Filter{})]byte = [C.sizeof_cn_filter]byte{}

// Material: Surface of a shape.
type Material struct {
	// coefficient while sticking, [0, 100], default 0.6
	StaticFriction float32
	// coefficient while sliding, [0, static_friction], default 0.6
	DynamicFriction float32
	// [0, 1], default 0
	Restitution float32
	// metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0
	RollingResistance float32
	// conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0
	TangentSpeedMps float32
	// CN_MIX_*; default CN_MIX_GEOMETRIC
	FrictionMix int32
	// CN_MIX_*; default CN_MIX_MAXIMUM
	RestitutionMix int32
	// a number for the user, reported in contact events; default 0
	UserId uint32
}

var _ [unsafe.Sizeof(Material{})]byte = [C.sizeof_cn_material]byte{}

// ShapeDef: Definition of a shape.
type ShapeDef struct {
	// set by the init function
	StructSize uint32
	// 0: create unattached, for cn_shape_attach
	Body Body
	// of the shape in the body's local frame
	OffsetM Vec2
	// of the shape in the body's local frame
	AngleRad float32
	// >= 0, giving 0 or 1e-20 to 1e20 kg; default 1
	DensityKgpm2 float32
	// defaults: see cn_material
	Material Material
	// defaults: see cn_filter
	Filter Filter
	// bits 1 << CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE
	EventMask uint32
	// CN_SHAPE_SENSOR ...; default 0
	Flags uint32
	// a number for the user; default 0
	UserData uint64
}

var _ [unsafe.Sizeof(ShapeDef{})]byte = [C.sizeof_cn_shape_def]byte{}

// DefaultShapeDef has the defaults of the fields.
func DefaultShapeDef() ShapeDef {
	var value ShapeDef
	C.cn_shape_def_init((*C.cn_shape_def)(unsafe.Pointer(&value)))
	return value
}

// Circle: A disc.
type Circle struct {
	// in the body's frame
	CenterM Vec2
	// > 0
	RadiusM float32
}

var _ [unsafe.Sizeof(Circle{})]byte = [C.sizeof_cn_circle]byte{}

// Capsule: All points within radius_m of the segment.
type Capsule struct {
	// one end of the segment, in the body's frame
	AM Vec2
	// the other end
	BM Vec2
	// around the segment, > 0
	RadiusM float32
}

var _ [unsafe.Sizeof(Capsule{})]byte = [C.sizeof_cn_capsule]byte{}

// Edge: A two-sided segment without mass.
type Edge struct {
	// one end, in the body's frame
	AM Vec2
	// the other end
	BM Vec2
}

var _ [unsafe.Sizeof(Edge{})]byte = [C.sizeof_cn_edge]byte{}

// Polygon: Convex polygon. Either winding is accepted; points are stored counter-clockwise.
type Polygon struct {
	// 3 to CN_POLYGON_MAX_VERTICES
	Count int32
	// rounding added outside the points, >= 0
	RadiusM float32
	// the first count of them; in the body's frame
	PointsM [16]Vec2
}

var _ [unsafe.Sizeof(Polygon{})]byte = [C.sizeof_cn_polygon]byte{}

// Chain: One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side
// is on the left of the order of points and surface normals point to the right: points that run from +x to -x
// collide from above, a counter-clockwise loop collides from outside.
type Chain struct {
	// copied
	c_points_m unsafe.Pointer
	// an open chain: >= 2; a loop: >= 3; at most 65535
	Count int32
	// 1: the last point joins the first
	Loop uint32
}

var _ [unsafe.Sizeof(Chain{})]byte = [C.sizeof_cn_chain]byte{}

// ManifoldPoint: One point of a contact.
type ManifoldPoint struct {
	// world, midway between the surfaces
	PointM Vec2
	// negative when overlapping
	SeparationM float32
	// of the last substep
	NormalImpulseNs float32
	// the same while the same features touch
	FeatureId uint32
}

var _ [unsafe.Sizeof(ManifoldPoint{})]byte = [C.sizeof_cn_manifold_point]byte{}

// Manifold: How two shapes touch.
type Manifold struct {
	// unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the faces' by
	// up to 0.1 rad, so that piles stand
	Normal Vec2
	// of the last substep, on body b along (normal.y, -normal.x)
	FrictionImpulseNs float32
	// 0, 1 or 2
	PointCount int32
	// the first point_count of them
	Points [2]ManifoldPoint
}

var _ [unsafe.Sizeof(Manifold{})]byte = [C.sizeof_cn_manifold]byte{}

// ContactEvent: A contact event, or the present state of a contact.
type ContactEvent struct {
	// one shape of the pair
	ShapeA Shape
	// the other
	ShapeB Shape
	// of shape_a
	BodyA Body
	// of shape_b
	BodyB Body
	// edge number within a chain, else 0
	ChildA int32
	// the same of shape b
	ChildB int32
	// the same from CREATED to DESTROYED, then reused
	ContactId uint32
	// CN_EVENT_*
	Kind int32
	// ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0
	ApproachSpeedMps float32
	// geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT
	Manifold Manifold
	// Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of
	// cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact that
	// its shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean force is
	// normal_impulse_Ns / dt_s
	NormalImpulseNs float32
	// along (normal.y, -normal.x), on body b
	FrictionImpulseNs float32
	// HIT: where, in the world; else (0, 0)
	HitPointM Vec2
	// cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED
	MaterialA uint32
	// the same of shape_b
	MaterialB uint32
}

var _ [unsafe.Sizeof(ContactEvent{})]byte = [C.sizeof_cn_contact_event]byte{}

// SensorEvent: A shape entered or left a sensor.
type SensorEvent struct {
	// the sensor
	Sensor Shape
	// the shape that it met
	Visitor Shape
	// the sensor's body
	SensorBody Body
	// the visitor's body
	VisitorBody Body
	// CN_EVENT_ENTER or CN_EVENT_LEAVE
	Kind int32
	// 0
	Reserved uint32
}

var _ [unsafe.Sizeof(SensorEvent{})]byte = [C.sizeof_cn_sensor_event]byte{}

// JointBase: First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles,
// lengths and limits in place; springs and motors are not rigid parts.
type JointBase struct {
	// of the whole definition
	StructSize uint32
	// CN_JOINT_*; default 0; a type ignores flags that it does not use
	Flags uint32
	// 0: the world
	BodyA Body
	// 0: the world; one of the two must be dynamic
	BodyB Body
	// in body a's local frame, or in world coordinates
	AnchorAM Vec2
	// the same for body b
	AnchorBM Vec2
	// of the rigid parts, > 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of all
	// springs; CN_DEFAULT (default): as stiff as the substeps permit
	StiffnessHertz float32
	// used with a stiffness_hertz; 0 to 1e6, default 0
	StiffnessDampingRatio float32
	// greatest force of each: anchor, axis, limit; > 0; CN_DEFAULT (default): unbounded
	ForceMaxN float32
	// greatest torque of angles, > 0; CN_DEFAULT (default): unbounded
	TorqueMaxNm float32
	// a reaction above this in any substep is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
	BreakForceN float32
	// the same for the torque
	BreakTorqueNm float32
	// a number for the user; default 0
	UserData uint64
}

var _ [unsafe.Sizeof(JointBase{})]byte = [C.sizeof_cn_joint_base]byte{}

// RevoluteDef: Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].
type RevoluteDef struct {
	// what every joint has
	Base JointBase
	// angle b - angle a at joint angle 0
	ReferenceAngleRad float32
	// CN_JOINT_LIMIT: -pi <= lower <= upper <= pi
	LowerAngleRad float32
	// the upper limit
	UpperAngleRad float32
	// CN_JOINT_MOTOR
	MotorSpeedRadps float32
	// >= 0
	MotorTorqueMaxNm float32
	// CN_JOINT_SPRING: pulls the joint angle to this
	SpringTargetRad float32
	// 0 to 1e6
	SpringHertz float32
	// 0 to 1e6
	SpringDampingRatio float32
}

var _ [unsafe.Sizeof(RevoluteDef{})]byte = [C.sizeof_cn_revolute_def]byte{}

// DefaultRevoluteDef has the defaults of the fields.
func DefaultRevoluteDef() RevoluteDef {
	var value RevoluteDef
	C.cn_revolute_def_init((*C.cn_revolute_def)(unsafe.Pointer(&value)))
	return value
}

// DistanceDef: Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid
// rod of length_m. With a spring, length_m is its rest length, and limits keep the distance within [min,
// max]; limits alone make a rope (min 0).
type DistanceDef struct {
	// what every joint has
	Base JointBase
	// > 0; default 1
	LengthM float32
	// CN_JOINT_LIMIT: 0 <= min <= max; default 0 and 1
	LengthMinM float32
	// the upper limit
	LengthMaxM float32
	// CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only
	MotorSpeedMps float32
	// >= 0
	MotorForceMaxN float32
	// 0 to 1e6
	SpringHertz float32
	// 0 to 1e6
	SpringDampingRatio float32
	// 0
	Reserved float32
}

var _ [unsafe.Sizeof(DistanceDef{})]byte = [C.sizeof_cn_distance_def]byte{}

// DefaultDistanceDef has the defaults of the fields.
func DefaultDistanceDef() DistanceDef {
	var value DistanceDef
	C.cn_distance_def_init((*C.cn_distance_def)(unsafe.Pointer(&value)))
	return value
}

// FixedDef: Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy.
type FixedDef struct {
	// what every joint has
	Base JointBase
	// angle b - angle a
	ReferenceAngleRad float32
	// stiffness of the angle alone, > 0, to 1e6; CN_DEFAULT (default): the base's
	AngularHertz float32
	// 0 to 1e6
	AngularDampingRatio float32
	// 0
	Reserved float32
}

var _ [unsafe.Sizeof(FixedDef{})]byte = [C.sizeof_cn_fixed_def]byte{}

// DefaultFixedDef has the defaults of the fields.
func DefaultFixedDef() FixedDef {
	var value FixedDef
	C.cn_fixed_def_init((*C.cn_fixed_def)(unsafe.Pointer(&value)))
	return value
}

// PrismaticDef: b slides along an axis fixed in a, without turning. The translation is along the axis from
// anchor a.
type PrismaticDef struct {
	// what every joint has
	Base JointBase
	// in body a's frame, any length > 0 (read back with length 1); default (1, 0)
	Axis Vec2
	// angle b - angle a
	ReferenceAngleRad float32
	// CN_JOINT_LIMIT: lower <= upper
	LowerM float32
	// the upper limit
	UpperM float32
	// CN_JOINT_MOTOR
	MotorSpeedMps float32
	// >= 0
	MotorForceMaxN float32
	// CN_JOINT_SPRING: pulls the translation to this
	SpringTargetM float32
	// 0 to 1e6
	SpringHertz float32
	// 0 to 1e6
	SpringDampingRatio float32
}

var _ [unsafe.Sizeof(PrismaticDef{})]byte = [C.sizeof_cn_prismatic_def]byte{}

// DefaultPrismaticDef has the defaults of the fields.
func DefaultPrismaticDef() PrismaticDef {
	var value PrismaticDef
	C.cn_prismatic_def_init((*C.cn_prismatic_def)(unsafe.Pointer(&value)))
	return value
}

// WheelDef: A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns
// freely or by the motor.
type WheelDef struct {
	// what every joint has
	Base JointBase
	// in body a's frame, any length > 0 (read back with length 1); default (0, 1)
	Axis Vec2
	// CN_JOINT_LIMIT: lower <= upper
	LowerM float32
	// the upper limit
	UpperM float32
	// CN_JOINT_MOTOR
	MotorSpeedRadps float32
	// >= 0
	MotorTorqueMaxNm float32
	// CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1
	SpringHertz float32
	// 0 to 1e6, default 0.7
	SpringDampingRatio float32
}

var _ [unsafe.Sizeof(WheelDef{})]byte = [C.sizeof_cn_wheel_def]byte{}

// DefaultWheelDef has the defaults of the fields.
func DefaultWheelDef() WheelDef {
	var value WheelDef
	C.cn_wheel_def_init((*C.cn_wheel_def)(unsafe.Pointer(&value)))
	return value
}

// MotorDef: Drives b to an offset and angle from a by a spring with bounded force and torque:
// base.force_max_N and base.torque_max_Nm must be > 0.
type MotorDef struct {
	// anchor b is driven to anchor a + offset
	Base JointBase
	// in body a's frame
	OffsetM Vec2
	// angle b - angle a
	AngleRad float32
	// frequency of the spring, > 0, to 1e6; default 5
	Hertz float32
	// 0 to 1e6, default 1
	DampingRatio float32
	// 0
	Reserved float32
}

var _ [unsafe.Sizeof(MotorDef{})]byte = [C.sizeof_cn_motor_def]byte{}

// DefaultMotorDef has the defaults of the fields.
func DefaultMotorDef() MotorDef {
	var value MotorDef
	C.cn_motor_def_init((*C.cn_motor_def)(unsafe.Pointer(&value)))
	return value
}

// MouseDef: Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored,
// and base.force_max_N must be > 0.
type MouseDef struct {
	// what every joint has
	Base JointBase
	// world
	TargetM Vec2
	// > 0, to 1e6; default 5
	Hertz float32
	// 0 to 1e6, default 0.7
	DampingRatio float32
}

var _ [unsafe.Sizeof(MouseDef{})]byte = [C.sizeof_cn_mouse_def]byte{}

// DefaultMouseDef has the defaults of the fields.
func DefaultMouseDef() MouseDef {
	var value MouseDef
	C.cn_mouse_def_init((*C.cn_mouse_def)(unsafe.Pointer(&value)))
	return value
}

// GearDef: angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is
// changed) and count whole turns from there.
type GearDef struct {
	// what every joint has
	Base JointBase
	// size 1e-4 to 1e4, negative: they turn against each other; default 1
	Ratio float32
	// default 0
	PhaseRad float32
}

var _ [unsafe.Sizeof(GearDef{})]byte = [C.sizeof_cn_gear_def]byte{}

// DefaultGearDef has the defaults of the fields.
func DefaultGearDef() GearDef {
	var value GearDef
	C.cn_gear_def_init((*C.cn_gear_def)(unsafe.Pointer(&value)))
	return value
}

// PulleyDef: A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| <= length. It pulls
// and never pushes.
type PulleyDef struct {
	// what every joint has
	Base JointBase
	// world
	GroundAM Vec2
	// world
	GroundBM Vec2
	// 1e-4 to 1e4; default 1
	Ratio float32
	// > 0: must be set
	LengthM float32
}

var _ [unsafe.Sizeof(PulleyDef{})]byte = [C.sizeof_cn_pulley_def]byte{}

// DefaultPulleyDef has the defaults of the fields.
func DefaultPulleyDef() PulleyDef {
	var value PulleyDef
	C.cn_pulley_def_init((*C.cn_pulley_def)(unsafe.Pointer(&value)))
	return value
}

// RatchetDef: b may turn against a in one direction, and back only to the last click that it passed. Clicks
// lie at phase + n * click_rad for every whole number n, over whole turns.
type RatchetDef struct {
	// what every joint has
	Base JointBase
	// default 0
	PhaseRad float32
	// size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise
	ClickRad float32
}

var _ [unsafe.Sizeof(RatchetDef{})]byte = [C.sizeof_cn_ratchet_def]byte{}

// DefaultRatchetDef has the defaults of the fields.
func DefaultRatchetDef() RatchetDef {
	var value RatchetDef
	C.cn_ratchet_def_init((*C.cn_ratchet_def)(unsafe.Pointer(&value)))
	return value
}

// RotarySpringDef: A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to
// the inertia of the two bodies.
type RotarySpringDef struct {
	// what every joint has
	Base JointBase
	// default 0
	RestAngleRad float32
	// > 0, to 1e6; default 1
	Hertz float32
	// 0 to 1e6, default 0
	DampingRatio float32
	// 0
	Reserved float32
}

var _ [unsafe.Sizeof(RotarySpringDef{})]byte = [C.sizeof_cn_rotary_spring_def]byte{}

// DefaultRotarySpringDef has the defaults of the fields.
func DefaultRotarySpringDef() RotarySpringDef {
	var value RotarySpringDef
	C.cn_rotary_spring_def_init((*C.cn_rotary_spring_def)(unsafe.Pointer(&value)))
	return value
}

// GrooveDef: Anchor b slides in a slot of body a from anchor a to end_m.
type GrooveDef struct {
	// what every joint has
	Base JointBase
	// in body a's frame; not equal to anchor a; default (1, 0)
	EndM Vec2
}

var _ [unsafe.Sizeof(GrooveDef{})]byte = [C.sizeof_cn_groove_def]byte{}

// DefaultGrooveDef has the defaults of the fields.
func DefaultGrooveDef() GrooveDef {
	var value GrooveDef
	C.cn_groove_def_init((*C.cn_groove_def)(unsafe.Pointer(&value)))
	return value
}

// FilterJointDef: The two bodies do not collide; no other effect.
type FilterJointDef struct {
	// what every joint has
	Base JointBase
}

var _ [unsafe.Sizeof(FilterJointDef{})]byte = [C.sizeof_cn_filter_joint_def]byte{}

// DefaultFilterJointDef has the defaults of the fields.
func DefaultFilterJointDef() FilterJointDef {
	var value FilterJointDef
	C.cn_filter_joint_def_init((*C.cn_filter_joint_def)(unsafe.Pointer(&value)))
	return value
}

// JointEvent: A joint or constraint exceeded a break threshold or was destroyed with a body.
type JointEvent struct {
	// 0: it was a constraint; stale when destroyed is 1
	Joint Joint
	// 0: it was a joint; stale when destroyed is 1
	Constraint Constraint
	// 0: the world
	BodyA Body
	// 0: the world
	BodyB Body
	// largest reaction of the step; 0 when a body was destroyed
	ForceN float32
	// the same for the torque
	TorqueNm float32
	// 1: it broke, or one of its bodies was destroyed
	Destroyed uint32
	// 0
	Reserved uint32
	// the joint's or constraint's
	UserData uint64
}

var _ [unsafe.Sizeof(JointEvent{})]byte = [C.sizeof_cn_joint_event]byte{}

// AngleConstraintDef: Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and
// counts whole turns from there.
type AngleConstraintDef struct {
	// set by the init function
	StructSize uint32
	// CN_CONSTRAINT_*; default 0
	Flags uint32
	// must be dynamic
	Body Body
	// lower <= upper; equal: locked
	LowerRad float32
	// the upper limit
	UpperRad float32
	// > 0, to 1e6; CN_DEFAULT (default): rigid
	Hertz float32
	// used with a hertz; 0 to 1e6
	DampingRatio float32
	// a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
	BreakTorqueNm float32
	// a number for the user; default 0
	UserData uint64
}

var _ [unsafe.Sizeof(AngleConstraintDef{})]byte = [C.sizeof_cn_angle_constraint_def]byte{}

// DefaultAngleConstraintDef has the defaults of the fields.
func DefaultAngleConstraintDef() AngleConstraintDef {
	var value AngleConstraintDef
	C.cn_angle_constraint_def_init((*C.cn_angle_constraint_def)(unsafe.Pointer(&value)))
	return value
}

// LineConstraintDef: Keeps a point of a body on a line in the world, within a tolerance on both sides, and
// between limits along the line.
type LineConstraintDef struct {
	// set by the init function
	StructSize uint32
	// CN_CONSTRAINT_*; default 0
	Flags uint32
	// must be dynamic
	Body Body
	// in the body's frame
	AnchorM Vec2
	// of the line, world
	OriginM Vec2
	// world, any length > 0 (read back with length 1); default (1, 0)
	Axis Vec2
	// >= 0: free play across the axis
	ToleranceM float32
	// CN_CONSTRAINT_LIMIT: along the axis from origin; lower <= upper
	LowerM float32
	// the upper limit
	UpperM float32
	// > 0, to 1e6; CN_DEFAULT (default): rigid
	Hertz float32
	// used with a hertz; 0 to 1e6
	DampingRatio float32
	// a reaction above this is reported (cn_world_joint_events), > 0; CN_DEFAULT (default): never
	BreakForceN float32
	// 0
	Reserved uint32
	// a number for the user; default 0
	UserData uint64
}

var _ [unsafe.Sizeof(LineConstraintDef{})]byte = [C.sizeof_cn_line_constraint_def]byte{}

// DefaultLineConstraintDef has the defaults of the fields.
func DefaultLineConstraintDef() LineConstraintDef {
	var value LineConstraintDef
	C.cn_line_constraint_def_init((*C.cn_line_constraint_def)(unsafe.Pointer(&value)))
	return value
}

// UpdateReport: Result of cn_world_update.
type UpdateReport struct {
	// fixed steps taken
	Steps int32
	// time kept for the next update
	LeftoverS float32
	// time discarded because of steps_max
	DroppedS float32
	// leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated
	Interpolation float32
}

var _ [unsafe.Sizeof(UpdateReport{})]byte = [C.sizeof_cn_update_report]byte{}

// Ray: A ray with an end.
type Ray struct {
	// world
	OriginM Vec2
	// at most 2e6 length units each way; 0 hits only shapes around the origin
	TranslationM Vec2
}

var _ [unsafe.Sizeof(Ray{})]byte = [C.sizeof_cn_ray]byte{}

// RayHit: What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits
// that shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up
// to a depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it.
type RayHit struct {
	// 0: nothing was hit
	Shape Shape
	// the shape's
	Body Body
	// edge of a chain
	Child int32
	// of the translation, [0, 1]; 1 when nothing was hit
	Fraction float32
	// on the surface of the shape that was hit
	PointM Vec2
	// unit, out of the shape that was hit
	Normal Vec2
	// depth of the start inside it, 0 outside
	DepthM float32
	// 0
	Reserved uint32
}

var _ [unsafe.Sizeof(RayHit{})]byte = [C.sizeof_cn_ray_hit]byte{}

// QueryFilter: Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose
// mask has a bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also
// between steps.
type QueryFilter struct {
	// default 1
	Category uint64
	// default all ones
	Mask uint64
	// its shapes are ignored; 0 (default): none. A stale handle is an error
	IgnoredBody Body
	// CN_QUERY_IGNORE_JOINED ...; default 0
	Flags uint32
	// NULL (default): take all shapes
	c_visit unsafe.Pointer
	// last argument of visit
	c_user unsafe.Pointer
}

var _ [unsafe.Sizeof(QueryFilter{})]byte = [C.sizeof_cn_query_filter]byte{}

// DefaultQueryFilter has the defaults of the fields.
func DefaultQueryFilter() QueryFilter {
	var value QueryFilter
	C.cn_query_filter_init((*C.cn_query_filter)(unsafe.Pointer(&value)))
	return value
}

// Closest: The shape nearest to a point.
type Closest struct {
	// 0: nothing within the distance
	Shape Shape
	// the shape's
	Body Body
	// edge of a chain
	Child int32
	// negative: depth inside a shape with area
	DistanceM float32
	// on the surface
	PointM Vec2
	// outward there; of edges and chains towards the point
	Normal Vec2
}

var _ [unsafe.Sizeof(Closest{})]byte = [C.sizeof_cn_closest]byte{}

// Distance: Distance of two shapes.
type Distance struct {
	// on the surface of a, in the world
	PointAM Vec2
	// on the surface of b
	PointBM Vec2
	// unit, from a to b
	Normal Vec2
	// of the surfaces; negative: the depth, the shortest translation of b out of a
	DistanceM float32
	// 0
	Reserved uint32
}

var _ [unsafe.Sizeof(Distance{})]byte = [C.sizeof_cn_distance]byte{}

// Sweep: A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns
// about it at a constant rate.
type Sweep struct {
	// of the shape, before the motion
	Start Pose
	// that point, in the shape's frame: the centre of mass of a body
	CenterM Vec2
	// of it; at most 2e6 m each way
	TranslationM Vec2
	// counter-clockwise, |turn| <= 1e4
	TurnRad float32
	// 0
	Reserved uint32
}

var _ [unsafe.Sizeof(Sweep{})]byte = [C.sizeof_cn_sweep]byte{}

// Impact: Result of cn_polygon_time_of_impact.
type Impact struct {
	// CN_IMPACT_*
	State int32
	// of both motions, [0, 1]
	Fraction float32
	// HIT only, as are the next two: between the surfaces
	PointM Vec2
	// unit, from a to b
	Normal Vec2
	// of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it
	DistanceM float32
	// 0
	Reserved uint32
}

var _ [unsafe.Sizeof(Impact{})]byte = [C.sizeof_cn_impact]byte{}

// Plane: A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t >= 0,
// unless that needs a push of more than push_max_m.
type Plane struct {
	// unit, from the surface to the shape
	Normal Vec2
	// world point of least distance
	PointM Vec2
	// of the surfaces along the normal; negative: they overlap
	SeparationM float32
	// greatest push of this plane, >= 0; FLT_MAX: rigid
	PushMaxM float32
	// its push in the last cn_mover_solve
	PushM float32
	// whose surface it is
	Shape Shape
	// the shape's
	Body Body
	// edge of a chain
	Child int32
}

var _ [unsafe.Sizeof(Plane{})]byte = [C.sizeof_cn_plane]byte{}

// MoverDef: How a character moves. It may change between moves: crouching is another shape.
type MoverDef struct {
	// set by the init function
	StructSize uint32
	// CN_MOVER_DROP; default 0
	Flags uint32
	// around its position, never turned; 1 or 2 points with radius > 0: circle, capsule. Default: a capsule of
	// radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly
	Shape Polygon
	// shapes that it collides with; sensors never, one-way shapes from above
	Filter QueryFilter
	// any length > 0; default (0, 1)
	Up Vec2
	// greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees)
	SlopeLimitRad float32
	// greatest height of steps that it climbs, >= 0; default 0.3
	StepHeightM float32
	// a walking character follows ground that falls by up to this in a move, >= 0; default 0.3
	SnapM float32
	// of the world's gravity in the air; default 1
	GravityScale float32
	// greatest push on a dynamic body, >= 0; default 200
	PushForceN float32
	// of sliding, 1 to 64; default 8
	IterationsMax int32
}

var _ [unsafe.Sizeof(MoverDef{})]byte = [C.sizeof_cn_mover_def]byte{}

// DefaultMoverDef has the defaults of the fields.
func DefaultMoverDef() MoverDef {
	var value MoverDef
	C.cn_mover_def_init((*C.cn_mover_def)(unsafe.Pointer(&value)))
	return value
}

// Mover: State of a character between two moves. It belongs to the caller, who may copy, store and restore
// it. The world does not know it, and bodies do not collide with it: for that give it a kinematic body that
// is filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the
// position.
type Mover struct {
	// of the shape's origin, world
	PositionM Vec2
	// in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its
	// component across up; the one along up is 0, and a jump when the caller makes it > 0
	VelocityMps Vec2
	// of the ground with CN_MOVER_ON_GROUND, else (0, 0)
	GroundNormal Vec2
	// in the world, after the move
	GroundPointM Vec2
	// ... in the frame of ground_body
	GroundLocalM Vec2
	// of the ground there
	GroundVelocityMps Vec2
	// 0: none; a stale handle counts as none
	GroundBody Body
	// the same for its shape
	GroundShape Shape
	// CN_MOVER_ON_*, after the last move
	Flags uint32
	// overlap with surfaces that leave it no room; else 0 up to rounding
	SqueezedM float32
}

var _ [unsafe.Sizeof(Mover{})]byte = [C.sizeof_cn_mover]byte{}

// AreaDef: What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without
// gravity. Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes; their
// accelerations, damping and forces add up.
type AreaDef struct {
	// set by the init function
	StructSize uint32
	// CN_AREA_REPLACE; default 0
	Flags uint32
	// default 0
	Priority int32
	// acceleration in the axes of the world, times the body's gravity_scale; default (0, 0)
	GravityMps2 Vec2
	// of pull_mps2, in the frame of the sensor's body; default (0, 0)
	CenterM Vec2
	// acceleration towards center_m; negative pushes; default 0
	PullMps2 float32
	// CN_DEFAULT (default): pull_mps2 at every distance; > 0, to 1e6 length units: at this distance, with its
	// inverse square outside, and falling to 0 at the centre: a homogeneous planet
	PullDistanceM float32
	// of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with
	// density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0
	LinearDampingPerS float32
	// ... of the rotation; 0 to 1e9, default 0
	AngularDampingPerS float32
	// of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default 0
	DensityKgpm2 float32
	// density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0
	DragKgpm2 float32
	// density times lift coefficient; 0 to 1e9, default 0
	LiftKgpm2 float32
	// velocity of the medium relative to the sensor, in the axes of the world; default (0, 0)
	FlowMps Vec2
}

var _ [unsafe.Sizeof(AreaDef{})]byte = [C.sizeof_cn_area_def]byte{}

// DefaultAreaDef has the defaults of the fields.
func DefaultAreaDef() AreaDef {
	var value AreaDef
	C.cn_area_def_init((*C.cn_area_def)(unsafe.Pointer(&value)))
	return value
}

// ExplosionDef: Definition of an explosion.
type ExplosionDef struct {
	// set by the init function
	StructSize uint32
	// full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1
	RadiusM float32
	// then linearly to 0 over this distance, 0 to 1e6 length units; default 0
	FalloffM float32
	// per metre of the shape's width seen from the centre; negative pulls; default 0
	ImpulseNspm float32
	// world
	CenterM Vec2
	// which shapes; defaults: see cn_query_filter
	Filter QueryFilter
}

var _ [unsafe.Sizeof(ExplosionDef{})]byte = [C.sizeof_cn_explosion_def]byte{}

// DefaultExplosionDef has the defaults of the fields.
func DefaultExplosionDef() ExplosionDef {
	var value ExplosionDef
	C.cn_explosion_def_init((*C.cn_explosion_def)(unsafe.Pointer(&value)))
	return value
}

// DebugDraw: The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in
// world coordinates.
type DebugDraw struct {
	// set by the init function
	StructSize uint32
	// CN_DRAW_*; default SHAPES | JOINTS | CONTACTS
	Flags uint32
	// things outside are not drawn; default everything
	View Aabb
	// count points, counter-clockwise
	c_polygon unsafe.Pointer
	// rim_m: a point on the rim that turns with the body
	c_circle unsafe.Pointer
	// a disc swept from a to b
	c_capsule unsafe.Pointer
	// a line from a to b
	c_segment unsafe.Pointer
	// size in pixels
	c_point unsafe.Pointer
	// zero-terminated, valid during the call
	c_text unsafe.Pointer
	// last argument of the functions
	c_user unsafe.Pointer
	// 0
	c_reserved unsafe.Pointer
}

var _ [unsafe.Sizeof(DebugDraw{})]byte = [C.sizeof_cn_debug_draw]byte{}

// DefaultDebugDraw has the defaults of the fields.
func DefaultDebugDraw() DebugDraw {
	var value DebugDraw
	C.cn_debug_draw_init((*C.cn_debug_draw)(unsafe.Pointer(&value)))
	return value
}

// Step: Takes one fixed step of dt_s seconds, 0 <= dt_s <= 1; 0 updates contacts and events without motion.
// O(awake bodies and their contacts and joints).
func (w *World) Step(dt_s float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_step(w.c(), C.float(dt_s)))
}

// SetGravity: Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).
func (w *World) SetGravity(gravity_x_mps2 float32, gravity_y_mps2 float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_gravity(w.c(), C.float(gravity_x_mps2), C.float(gravity_y_mps2)))
}

// GetGravity: Reads gravity in m/s^2.
func (w *World) GetGravity() (Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	if err := check(C.cn_world_get_gravity(w.c(), (*C.cn_vec2)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Vec2), err
	}
	return out0, nil
}

// SetSubstepCount: Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and
// cost more.
func (w *World) SetSubstepCount(count int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_substep_count(w.c(), C.int32_t(count)))
}

// GetSubstepCount: Reads the substeps of a step.
func (w *World) GetSubstepCount() (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_world_get_substep_count(w.c(), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// SetSolver: Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the
// scratch memory of the solver it was created with; a solver that needs more works without direct solving
// (CN_WARNING_FRAME_MEMORY).
func (w *World) SetSolver(solver int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_solver(w.c(), C.int32_t(solver)))
}

// GetSolver: Reads the solver (CN_SOLVER_*).
func (w *World) GetSolver() (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_world_get_solver(w.c(), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// SetAccuracy: Sets accuracy_m and work_budget as in cn_world_def: metres >= 0 and 1 to 1e9, or CN_DEFAULT.
func (w *World) SetAccuracy(accuracy_m float32, work_budget int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_accuracy(w.c(), C.float(accuracy_m), C.int32_t(work_budget)))
}

// GetAccuracy: Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work
// budget (CN_DEFAULT: none).
func (w *World) GetAccuracy() (float32, int32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	var out1 int32
	if err := check(C.cn_world_get_accuracy(w.c(), (*C.float)(unsafe.Pointer(&out0)), (*C.int32_t)(unsafe.Pointer(&out1)))); err != nil {
		return *new(float32), *new(int32), err
	}
	return out0, out1, nil
}

// GetWorkerCount: Reads how many workers a step can use: 1, or worker_count where the library supports
// threads.
func (w *World) GetWorkerCount() (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_world_get_worker_count(w.c(), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// SetFlags: Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).
func (w *World) SetFlags(flags uint32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_flags(w.c(), C.uint32_t(flags)))
}

// GetFlags: Reads the CN_WORLD_ flags.
func (w *World) GetFlags() (uint32, error) {
	defer runtime.KeepAlive(w)
	var out0 uint32
	if err := check(C.cn_world_get_flags(w.c(), (*C.uint32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint32), err
	}
	return out0, nil
}

// SetRestitutionThreshold: Impacts slower than this, in m/s, do not bounce; >= 0.
func (w *World) SetRestitutionThreshold(speed_mps float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_restitution_threshold(w.c(), C.float(speed_mps)))
}

// SetHitSpeed: Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; >= 0.
func (w *World) SetHitSpeed(speed_mps float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_hit_speed(w.c(), C.float(speed_mps)))
}

// SetSpeedLimits: Sets the greatest linear (m/s) and angular (rad/s) speed, both > 0. The end of a step slows
// faster bodies down to them and keeps the direction.
func (w *World) SetSpeedLimits(linear_mps float32, angular_radps float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_speed_limits(w.c(), C.float(linear_mps), C.float(angular_radps)))
}

// SetSleep: Sets the speed in m/s, >= 0, below which bodies may sleep, and the delay in seconds, >= 0, after
// which they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays, those
// others that no joint holds and that are slower than four times the speed lose theirs within a second or
// two: what rocks in a hollow would keep all of a heap awake.
func (w *World) SetSleep(speed_mps float32, delay_s float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_sleep(w.c(), C.float(speed_mps), C.float(delay_s)))
}

// SetUserData: Stores a number for the user.
func (w *World) SetUserData(user_data uint64) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_user_data(w.c(), C.uint64_t(user_data)))
}

// GetUserData: Reads the user's number.
func (w *World) GetUserData() (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_world_get_user_data(w.c(), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// GetBodies: Handles of all bodies, ordered by slot. Writes at most capacity (>= 0) of them; out may be NULL
// when capacity is 0. out_count is their number. O(slots).
func (w *World) GetBodies() ([]Body, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_get_bodies(w.c(), nil, 0, &count)); err != nil {
		return *new([]Body), err
	}
	out := make([]Body, count)
	if count > 0 {
		if err := check(C.cn_world_get_bodies(w.c(), (*C.cn_body)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Body), err
		}
	}
	return out, nil
}

// GetShapes: Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
// O(slots).
func (w *World) GetShapes() ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_get_shapes(w.c(), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_world_get_shapes(w.c(), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// GetJoints: Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
// cn_world_get_bodies. O(slots).
func (w *World) GetJoints() ([]Joint, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_get_joints(w.c(), nil, 0, &count)); err != nil {
		return *new([]Joint), err
	}
	out := make([]Joint, count)
	if count > 0 {
		if err := check(C.cn_world_get_joints(w.c(), (*C.cn_joint)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Joint), err
		}
	}
	return out, nil
}

// GetCounters: Reads counts of objects and what the last step reported. O(bodies + islands).
func (w *World) GetCounters() (Counters, error) {
	defer runtime.KeepAlive(w)
	var out0 Counters
	if err := check(C.cn_world_get_counters(w.c(), (*C.cn_counters)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Counters), err
	}
	return out0, nil
}

// GetIslands: Reports every awake island, as cn_counters.islands_awake counts them: first those of several
// bodies, in a deterministic order, then single bodies. Writes at most capacity (>= 0); *out_count is their
// number. A step does no work for it. O(bodies + contacts and joints of the islands written).
func (w *World) GetIslands() ([]IslandReport, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_get_islands(w.c(), nil, 0, &count)); err != nil {
		return *new([]IslandReport), err
	}
	out := make([]IslandReport, count)
	if count > 0 {
		if err := check(C.cn_world_get_islands(w.c(), (*C.cn_island_report)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]IslandReport), err
		}
	}
	return out, nil
}

// GetProfile: Reads the seconds of the last step by stage.
func (w *World) GetProfile() (Profile, error) {
	defer runtime.KeepAlive(w)
	var out0 Profile
	if err := check(C.cn_world_get_profile(w.c(), (*C.cn_profile)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Profile), err
	}
	return out0, nil
}

// GetMemoryStats: Reads the memory statistics.
func (w *World) GetMemoryStats() (MemoryStats, error) {
	defer runtime.KeepAlive(w)
	var out0 MemoryStats
	if err := check(C.cn_world_get_memory_stats(w.c(), (*C.cn_memory_stats)(unsafe.Pointer(&out0)))); err != nil {
		return *new(MemoryStats), err
	}
	return out0, nil
}

// ShiftOrigin: Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| <= 1e6 length units: every
// position p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies,
// boxes, world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay,
// and no event is reported. Distances between bodies keep their digits; world anchors are rounded to floats
// at the new place. Arrays returned before become invalid; the user moves their own points (movers, rays,
// cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all
// pairs again.
func (w *World) ShiftOrigin(x_m float32, y_m float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_shift_origin(w.c(), C.float(x_m), C.float(y_m)))
}

// Hash: 64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on every
// compiler, CPU and thread count. O(bodies + contacts + joints).
func (w *World) Hash() (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_world_hash(w.c(), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// SaveSize: Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).
func (w *World) SaveSize() (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_world_save_size(w.c(), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// Save: Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and
// the number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
// about 1 KB per body.
func (w *World) Save() ([]byte, error) {
	defer runtime.KeepAlive(w)
	var bytes C.uint64_t
	if err := check(C.cn_world_save_size(w.c(), &bytes)); err != nil {
		return *new([]byte), err
	}
	out := make([]byte, bytes)
	if err := check(C.cn_world_save(w.c(), unsafe.Pointer(unsafe.SliceData(out)), bytes, &bytes)); err != nil {
		return *new([]byte), err
	}
	return out[:bytes], nil
}

// Restore: Restores a saved state, into the saved world or one created with the same definition (broadphase,
// length unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save;
// CN_ERROR_FORMAT for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the
// objects alive then (a world in a caller's block has room for its own saves). Arrays returned before become
// invalid. Handles of objects alive at the save are valid again, also of objects destroyed since; handles
// created since are refused until the same handle is given to a new object: with the same calls to the same
// object. O(memory of the world).
func (w *World) Restore(save []byte) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_restore(w.c(), unsafe.Pointer(unsafe.SliceData(save)), C.uint64_t(len(save))))
}

// WriteSize: Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).
func (w *World) WriteSize() (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_world_write_size(w.c(), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// Write: Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
// number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
// about 1 KB per body.
func (w *World) Write() ([]byte, error) {
	defer runtime.KeepAlive(w)
	var bytes C.uint64_t
	if err := check(C.cn_world_write_size(w.c(), &bytes)); err != nil {
		return *new([]byte), err
	}
	out := make([]byte, bytes)
	if err := check(C.cn_world_write(w.c(), unsafe.Pointer(unsafe.SliceData(out)), bytes, &bytes)); err != nil {
		return *new([]byte), err
	}
	return out[:bytes], nil
}

// BodyCreate: Creates a body. O(1) amortized.
func (w *World) BodyCreate(def *BodyDef) (Body, error) {
	defer runtime.KeepAlive(w)
	var out0 Body
	if err := w.check(C.cn_body_create(w.c(), (*C.cn_body_def)(unsafe.Pointer(def)), (*C.cn_body)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Body), err
	}
	return out0, nil
}

// BodyCreateMany: Creates count (>= 0) bodies from an array of definitions, all or none. O(count).
func (w *World) BodyCreateMany(defs []BodyDef, out_bodies []Body) error {
	defer runtime.KeepAlive(w)
	if len(defs) != len(out_bodies) {
		return errUneven
	}
	return w.check(C.cn_body_create_many(w.c(), (*C.cn_body_def)(unsafe.Pointer(unsafe.SliceData(defs))), C.int32_t(len(out_bodies)), (*C.cn_body)(unsafe.Pointer(unsafe.SliceData(out_bodies)))))
}

// BodyDestroy: Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours.
// Touching contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events).
// O(contacts + joints + shapes).
func (w *World) BodyDestroy(body Body) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_destroy(w.c(), C.cn_body(body)))
}

// BodyDestroyMany: Destroys count (>= 0) bodies as cn_body_destroy does; none if a handle is bad or appears
// twice. O(their contacts + joints + shapes).
func (w *World) BodyDestroyMany(bodies []Body) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_destroy_many(w.c(), (*C.cn_body)(unsafe.Pointer(unsafe.SliceData(bodies))), C.int32_t(len(bodies))))
}

// BodyIsValid: 1 if the handle names a living body of this world, else 0 (also for a NULL world).
func (w *World) BodyIsValid(body Body) bool {
	defer runtime.KeepAlive(w)
	return C.cn_body_is_valid(w.c(), C.cn_body(body)) != 0
}

// BodySetType: Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end
// (those that still overlap begin again in the next step), with its forces and any mass override; a body made
// static stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints +
// shapes).
func (w *World) BodySetType(body Body, kind int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_type(w.c(), C.cn_body(body), C.int32_t(kind)))
}

// BodyGetType: Reads the type (CN_BODY_*).
func (w *World) BodyGetType(body Body) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_body_get_type(w.c(), C.cn_body(body), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// BodySetFlags: Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake.
// Without CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its
// joints are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.
func (w *World) BodySetFlags(body Body, flags uint32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_flags(w.c(), C.cn_body(body), C.uint32_t(flags)))
}

// BodyGetFlags: Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.
func (w *World) BodyGetFlags(body Body) (uint32, error) {
	defer runtime.KeepAlive(w)
	var out0 uint32
	if err := check(C.cn_body_get_flags(w.c(), C.cn_body(body), (*C.uint32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint32), err
	}
	return out0, nil
}

// BodySetAwake: 0 puts the body and its island to sleep and stops them; any other value wakes them. Static
// and disabled bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).
func (w *World) BodySetAwake(body Body, awake int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_awake(w.c(), C.cn_body(body), C.int32_t(awake)))
}

// BodySetPose: Teleports the body: origin in metres (|x|, |y| <= 1e6 length units), angle in radians (|angle|
// <= 1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
// them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
// neighbours. O(contacts + joints + shapes).
func (w *World) BodySetPose(body Body, position_x_m float32, position_y_m float32, angle_rad float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_pose(w.c(), C.cn_body(body), C.float(position_x_m), C.float(position_y_m), C.float(angle_rad)))
}

// BodyGetPose: Reads the position of the origin and the rotation.
func (w *World) BodyGetPose(body Body) (Pose, error) {
	defer runtime.KeepAlive(w)
	var out0 Pose
	if err := check(C.cn_body_get_pose(w.c(), C.cn_body(body), (*C.cn_pose)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Pose), err
	}
	return out0, nil
}

// BodyGetPositionParts: Reads the position of the origin as the sum of two floats: the high part is within
// rounding that of cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their
// sum in double is more precise; so is a difference of two bodies, taken high from high and low from low, in
// floats.
func (w *World) BodyGetPositionParts(body Body) (Vec2, Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	var out1 Vec2
	if err := check(C.cn_body_get_position_parts(w.c(), C.cn_body(body), (*C.cn_vec2)(unsafe.Pointer(&out0)), (*C.cn_vec2)(unsafe.Pointer(&out1)))); err != nil {
		return *new(Vec2), *new(Vec2), err
	}
	return out0, out1, nil
}

// BodyGetAngle: Reads the angle in radians, in (-pi, pi].
func (w *World) BodyGetAngle(body Body) (float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	if err := check(C.cn_body_get_angle(w.c(), C.cn_body(body), (*C.float)(unsafe.Pointer(&out0)))); err != nil {
		return *new(float32), err
	}
	return out0, nil
}

// BodyGetCenter: Reads the world position of the centre of mass, in metres.
func (w *World) BodyGetCenter(body Body) (Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	if err := check(C.cn_body_get_center(w.c(), C.cn_body(body), (*C.cn_vec2)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Vec2), err
	}
	return out0, nil
}

// BodySetVelocity: Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all
// finite. CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.
func (w *World) BodySetVelocity(body Body, linear_x_mps float32, linear_y_mps float32, angular_radps float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_velocity(w.c(), C.cn_body(body), C.float(linear_x_mps), C.float(linear_y_mps), C.float(angular_radps)))
}

// BodyGetVelocity: Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).
func (w *World) BodyGetVelocity(body Body) (Velocity, error) {
	defer runtime.KeepAlive(w)
	var out0 Velocity
	if err := check(C.cn_body_get_velocity(w.c(), C.cn_body(body), (*C.cn_velocity)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Velocity), err
	}
	return out0, nil
}

// BodySetTargetPose: Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s
// (1e-6 to 1) takes it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed
// limits. Unlike after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this
// before every step, or stop the body after it.
func (w *World) BodySetTargetPose(body Body, position_x_m float32, position_y_m float32, angle_rad float32, dt_s float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_target_pose(w.c(), C.cn_body(body), C.float(position_x_m), C.float(position_y_m), C.float(angle_rad), C.float(dt_s)))
}

// BodyGetVelocityAt: Velocity in m/s of the body's material at a world point in metres.
func (w *World) BodyGetVelocityAt(body Body, point_x_m float32, point_y_m float32) (Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	if err := check(C.cn_body_get_velocity_at(w.c(), C.cn_body(body), C.float(point_x_m), C.float(point_y_m), (*C.cn_vec2)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Vec2), err
	}
	return out0, nil
}

// BodyGetWorldPoint: World position of a point given in the body's frame, both in metres.
func (w *World) BodyGetWorldPoint(body Body, local_x_m float32, local_y_m float32) (Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	if err := check(C.cn_body_get_world_point(w.c(), C.cn_body(body), C.float(local_x_m), C.float(local_y_m), (*C.cn_vec2)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Vec2), err
	}
	return out0, nil
}

// BodyGetLocalPoint: Position in the body's frame of a world point, both in metres.
func (w *World) BodyGetLocalPoint(body Body, world_x_m float32, world_y_m float32) (Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	if err := check(C.cn_body_get_local_point(w.c(), C.cn_body(body), C.float(world_x_m), C.float(world_y_m), (*C.cn_vec2)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Vec2), err
	}
	return out0, nil
}

// BodyGetAabb: Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no
// shapes. O(shapes).
func (w *World) BodyGetAabb(body Body) (Aabb, error) {
	defer runtime.KeepAlive(w)
	var out0 Aabb
	if err := check(C.cn_body_get_aabb(w.c(), C.cn_body(body), (*C.cn_aabb)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Aabb), err
	}
	return out0, nil
}

// BodyApplyForce: Adds a force in newtons at the centre of mass for the next step only; wakes the body.
// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces
// overflows.
func (w *World) BodyApplyForce(body Body, force_x_N float32, force_y_N float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_apply_force(w.c(), C.cn_body(body), C.float(force_x_N), C.float(force_y_N)))
}

// BodyApplyForceAt: Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
// cn_body_apply_force.
func (w *World) BodyApplyForceAt(body Body, force_x_N float32, force_y_N float32, point_x_m float32, point_y_m float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_apply_force_at(w.c(), C.cn_body(body), C.float(force_x_N), C.float(force_y_N), C.float(point_x_m), C.float(point_y_m)))
}

// BodyApplyTorque: Adds a torque in newton metres; otherwise as cn_body_apply_force.
func (w *World) BodyApplyTorque(body Body, torque_Nm float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_apply_torque(w.c(), C.cn_body(body), C.float(torque_Nm)))
}

// BodyApplyImpulse: Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes
// the body. Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
// overflows.
func (w *World) BodyApplyImpulse(body Body, impulse_x_Ns float32, impulse_y_Ns float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_apply_impulse(w.c(), C.cn_body(body), C.float(impulse_x_Ns), C.float(impulse_y_Ns)))
}

// BodyApplyImpulseAt: Applies an impulse in newton seconds at a world point in metres, which changes the
// angular velocity too; otherwise as cn_body_apply_impulse.
func (w *World) BodyApplyImpulseAt(body Body, impulse_x_Ns float32, impulse_y_Ns float32, point_x_m float32, point_y_m float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_apply_impulse_at(w.c(), C.cn_body(body), C.float(impulse_x_Ns), C.float(impulse_y_Ns), C.float(point_x_m), C.float(point_y_m)))
}

// BodyApplyAngularImpulse: Changes the angular velocity at once by an angular impulse in newton metre
// seconds; otherwise as cn_body_apply_impulse.
func (w *World) BodyApplyAngularImpulse(body Body, impulse_Nms float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_apply_angular_impulse(w.c(), C.cn_body(body), C.float(impulse_Nms)))
}

// BodyGetMassData: Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic
// body whose shapes have no mass weighs 1 kg; without shapes it does not rotate.
func (w *World) BodyGetMassData(body Body) (MassData, error) {
	defer runtime.KeepAlive(w)
	var out0 MassData
	if err := check(C.cn_body_get_mass_data(w.c(), C.cn_body(body), (*C.cn_mass_data)(unsafe.Pointer(&out0)))); err != nil {
		return *new(MassData), err
	}
	return out0, nil
}

// BodySetMassData: Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until
// cn_body_reset_mass_data or a change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or
// from 1e-35 to 1e35. Wakes the body.
func (w *World) BodySetMassData(body Body, mass *MassData) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_mass_data(w.c(), C.cn_body(body), (*C.cn_mass_data)(unsafe.Pointer(mass))))
}

// BodyResetMassData: Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).
func (w *World) BodyResetMassData(body Body) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_reset_mass_data(w.c(), C.cn_body(body)))
}

// BodySetDamping: Sets the linear and angular damping in 1/s (v' = -damping v), both >= 0.
func (w *World) BodySetDamping(body Body, linear_per_s float32, angular_per_s float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_damping(w.c(), C.cn_body(body), C.float(linear_per_s), C.float(angular_per_s)))
}

// BodyGetDamping: Reads the linear and angular damping in 1/s.
func (w *World) BodyGetDamping(body Body) (float32, float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	var out1 float32
	if err := check(C.cn_body_get_damping(w.c(), C.cn_body(body), (*C.float)(unsafe.Pointer(&out0)), (*C.float)(unsafe.Pointer(&out1)))); err != nil {
		return *new(float32), *new(float32), err
	}
	return out0, out1, nil
}

// BodySetGravityScale: Sets the factor on gravity for this body, finite. A change wakes the body.
func (w *World) BodySetGravityScale(body Body, scale float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_gravity_scale(w.c(), C.cn_body(body), C.float(scale)))
}

// BodyGetGravityScale: Reads the factor on gravity.
func (w *World) BodyGetGravityScale(body Body) (float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	if err := check(C.cn_body_get_gravity_scale(w.c(), C.cn_body(body), (*C.float)(unsafe.Pointer(&out0)))); err != nil {
		return *new(float32), err
	}
	return out0, nil
}

// BodySetSleepSpeed: Sets the body's own sleep speed in m/s, >= 0; CN_DEFAULT restores the world's.
func (w *World) BodySetSleepSpeed(body Body, speed_mps float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_sleep_speed(w.c(), C.cn_body(body), C.float(speed_mps)))
}

// BodySetSolver: Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT.
// CN_SOLVER_AUTO (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever
// other bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
// within the work_budget. Takes effect with the next step; does not wake.
func (w *World) BodySetSolver(body Body, solver int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_solver(w.c(), C.cn_body(body), C.int32_t(solver)))
}

// BodyGetSolver: Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
func (w *World) BodyGetSolver(body Body) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_body_get_solver(w.c(), C.cn_body(body), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// BodySetUserData: Stores a number for the user.
func (w *World) BodySetUserData(body Body, user_data uint64) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_body_set_user_data(w.c(), C.cn_body(body), C.uint64_t(user_data)))
}

// BodyGetUserData: Reads the user's number.
func (w *World) BodyGetUserData(body Body) (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_body_get_user_data(w.c(), C.cn_body(body), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// BodySetName: Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or ""
// removes it. O(length).
func (w *World) BodySetName(body Body, name string) error {
	defer runtime.KeepAlive(w)
	c_name := C.CString(name)
	defer C.free(unsafe.Pointer(c_name))
	return w.check(C.cn_body_set_name(w.c(), C.cn_body(body), c_name))
}

// BodyGetName: Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.
func (w *World) BodyGetName(body Body) (string, error) {
	defer runtime.KeepAlive(w)
	var text *C.char
	if err := check(C.cn_body_get_name(w.c(), C.cn_body(body), &text)); err != nil {
		return *new(string), err
	}
	return C.GoString(text), nil
}

// BodyGetShapes: Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies.
// O(shapes).
func (w *World) BodyGetShapes(body Body) ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_body_get_shapes(w.c(), C.cn_body(body), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_body_get_shapes(w.c(), C.cn_body(body), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// BodyGetJoints: Handles of the body's joints without constraints; out, capacity and *out_count as in
// cn_world_get_bodies. O(joints).
func (w *World) BodyGetJoints(body Body) ([]Joint, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_body_get_joints(w.c(), C.cn_body(body), nil, 0, &count)); err != nil {
		return *new([]Joint), err
	}
	out := make([]Joint, count)
	if count > 0 {
		if err := check(C.cn_body_get_joints(w.c(), C.cn_body(body), (*C.cn_joint)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Joint), err
		}
	}
	return out, nil
}

// ReadPoses: Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must
// then be their number. One bad handle fails the whole call. O(count).
func (w *World) ReadPoses(bodies []Body, out []Pose) error {
	defer runtime.KeepAlive(w)
	if bodies != nil && len(bodies) != len(out) {
		return errUneven
	}
	return check(C.cn_world_read_poses(w.c(), (*C.cn_body)(unsafe.Pointer(unsafe.SliceData(bodies))), C.int32_t(len(out)), (*C.cn_pose)(unsafe.Pointer(unsafe.SliceData(out)))))
}

// ReadVelocities: Reads count velocities; bodies and count as in cn_world_read_poses. O(count).
func (w *World) ReadVelocities(bodies []Body, out []Velocity) error {
	defer runtime.KeepAlive(w)
	if bodies != nil && len(bodies) != len(out) {
		return errUneven
	}
	return check(C.cn_world_read_velocities(w.c(), (*C.cn_body)(unsafe.Pointer(unsafe.SliceData(bodies))), C.int32_t(len(out)), (*C.cn_velocity)(unsafe.Pointer(unsafe.SliceData(out)))))
}

// WriteVelocities: Sets count velocities as cn_body_set_velocity does; bodies and count as in
// cn_world_read_poses. Static bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call.
// O(count).
func (w *World) WriteVelocities(bodies []Body, velocities []Velocity) error {
	defer runtime.KeepAlive(w)
	if bodies != nil && len(bodies) != len(velocities) {
		return errUneven
	}
	return w.check(C.cn_world_write_velocities(w.c(), (*C.cn_body)(unsafe.Pointer(unsafe.SliceData(bodies))), C.int32_t(len(velocities)), (*C.cn_velocity)(unsafe.Pointer(unsafe.SliceData(velocities)))))
}

// Moved: Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since.
// The first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.
func (w *World) Moved() ([]BodyMoved, error) {
	defer runtime.KeepAlive(w)
	var data *C.cn_body_moved
	var count C.int32_t
	if err := w.check(C.cn_world_moved(w.c(), &data, &count)); err != nil {
		return *new([]BodyMoved), err
	}
	return append([]BodyMoved(nil), unsafe.Slice((*BodyMoved)(unsafe.Pointer(data)), count)...), nil
}

// ShapeCreateCircle: Creates a circle; 0 < radius_m <= 1e6. Wakes the body. out_shape may be NULL.
func (w *World) ShapeCreateCircle(def *ShapeDef, circle *Circle) (Shape, error) {
	defer runtime.KeepAlive(w)
	var out0 Shape
	if err := w.check(C.cn_shape_create_circle(w.c(), (*C.cn_shape_def)(unsafe.Pointer(def)), (*C.cn_circle)(unsafe.Pointer(circle)), (*C.cn_shape)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Shape), err
	}
	return out0, nil
}

// ShapeCreateCapsule: Creates a capsule; ends at least 0.05% of the length unit apart, radius_m > 0. Wakes
// the body. out_shape may be NULL.
func (w *World) ShapeCreateCapsule(def *ShapeDef, capsule *Capsule) (Shape, error) {
	defer runtime.KeepAlive(w)
	var out0 Shape
	if err := w.check(C.cn_shape_create_capsule(w.c(), (*C.cn_shape_def)(unsafe.Pointer(def)), (*C.cn_capsule)(unsafe.Pointer(capsule)), (*C.cn_shape)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Shape), err
	}
	return out0, nil
}

// ShapeCreateEdge: Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape
// may be NULL.
func (w *World) ShapeCreateEdge(def *ShapeDef, edge *Edge) (Shape, error) {
	defer runtime.KeepAlive(w)
	var out0 Shape
	if err := w.check(C.cn_shape_create_edge(w.c(), (*C.cn_shape_def)(unsafe.Pointer(def)), (*C.cn_edge)(unsafe.Pointer(edge)), (*C.cn_shape)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Shape), err
	}
	return out0, nil
}

// ShapeCreatePolygon: Creates a convex polygon; consecutive points at least 0.05% of the length unit apart.
// Wakes the body. out_shape may be NULL.
func (w *World) ShapeCreatePolygon(def *ShapeDef, polygon *Polygon) (Shape, error) {
	defer runtime.KeepAlive(w)
	var out0 Shape
	if err := w.check(C.cn_shape_create_polygon(w.c(), (*C.cn_shape_def)(unsafe.Pointer(def)), (*C.cn_polygon)(unsafe.Pointer(polygon)), (*C.cn_shape)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Shape), err
	}
	return out0, nil
}

// ShapeCreateBox: Creates a box of half sizes > 0; the rounding radius_m >= 0 is added outside. Wakes the
// body. out_shape may be NULL.
func (w *World) ShapeCreateBox(def *ShapeDef, half_width_m float32, half_height_m float32, radius_m float32) (Shape, error) {
	defer runtime.KeepAlive(w)
	var out0 Shape
	if err := w.check(C.cn_shape_create_box(w.c(), (*C.cn_shape_def)(unsafe.Pointer(def)), C.float(half_width_m), C.float(half_height_m), C.float(radius_m), (*C.cn_shape)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Shape), err
	}
	return out0, nil
}

// ShapeAttach: Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a
// static one. CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).
func (w *World) ShapeAttach(shape Shape, body Body) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_attach(w.c(), C.cn_shape(shape), C.cn_body(body)))
}

// ShapeDetach: Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has
// no body. O(contacts + shapes of the body).
func (w *World) ShapeDetach(shape Shape) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_detach(w.c(), C.cn_shape(shape)))
}

// ShapeDestroy: Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).
func (w *World) ShapeDestroy(shape Shape) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_destroy(w.c(), C.cn_shape(shape)))
}

// ShapeIsValid: 1 if the handle names a living shape of this world, else 0 (also for a NULL world).
func (w *World) ShapeIsValid(shape Shape) bool {
	defer runtime.KeepAlive(w)
	return C.cn_shape_is_valid(w.c(), C.cn_shape(shape)) != 0
}

// ShapeGetType: Reads the type (CN_SHAPE_CIRCLE to _CHAIN).
func (w *World) ShapeGetType(shape Shape) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_shape_get_type(w.c(), C.cn_shape(shape), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// ShapeGetBody: Reads the body; 0 if unattached.
func (w *World) ShapeGetBody(shape Shape) (Body, error) {
	defer runtime.KeepAlive(w)
	var out0 Body
	if err := check(C.cn_shape_get_body(w.c(), C.cn_shape(shape), (*C.cn_body)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Body), err
	}
	return out0, nil
}

// ShapeSetMaterial: Replaces the material; applies at once, to touching contacts too, whose bodies wake.
// O(contacts of the body).
func (w *World) ShapeSetMaterial(shape Shape, material *Material) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_material(w.c(), C.cn_shape(shape), (*C.cn_material)(unsafe.Pointer(material))))
}

// ShapeGetMaterial: Reads the material.
func (w *World) ShapeGetMaterial(shape Shape) (Material, error) {
	defer runtime.KeepAlive(w)
	var out0 Material
	if err := check(C.cn_shape_get_material(w.c(), C.cn_shape(shape), (*C.cn_material)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Material), err
	}
	return out0, nil
}

// ShapeSetDensity: Sets the density in kg/m^2, >= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at
// once and wakes the body. O(shapes of the body).
func (w *World) ShapeSetDensity(shape Shape, density_kgpm2 float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_density(w.c(), C.cn_shape(shape), C.float(density_kgpm2)))
}

// ShapeGetDensity: Reads the density in kg/m^2.
func (w *World) ShapeGetDensity(shape Shape) (float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	if err := check(C.cn_shape_get_density(w.c(), C.cn_shape(shape), (*C.float)(unsafe.Pointer(&out0)))); err != nil {
		return *new(float32), err
	}
	return out0, nil
}

// ShapeSetFilter: Replaces the filter. Contacts that it forbids end at once, with their events; contacts that
// it permits begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the
// body).
func (w *World) ShapeSetFilter(shape Shape, filter *Filter) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_filter(w.c(), C.cn_shape(shape), (*C.cn_filter)(unsafe.Pointer(filter))))
}

// ShapeGetFilter: Reads the filter.
func (w *World) ShapeGetFilter(shape Shape) (Filter, error) {
	defer runtime.KeepAlive(w)
	var out0 Filter
	if err := check(C.cn_shape_get_filter(w.c(), C.cn_shape(shape), (*C.cn_filter)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Filter), err
	}
	return out0, nil
}

// ShapeSetEventMask: Sets the reported events, bits 1 << CN_EVENT_*; applies at once, to present contacts
// too. O(contacts of the body).
func (w *World) ShapeSetEventMask(shape Shape, event_mask uint32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_event_mask(w.c(), C.cn_shape(shape), C.uint32_t(event_mask)))
}

// ShapeGetEventMask: Reads the event mask.
func (w *World) ShapeGetEventMask(shape Shape) (uint32, error) {
	defer runtime.KeepAlive(w)
	var out0 uint32
	if err := check(C.cn_shape_get_event_mask(w.c(), C.cn_shape(shape), (*C.uint32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint32), err
	}
	return out0, nil
}

// ShapeSetFlags: Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again
// in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).
func (w *World) ShapeSetFlags(shape Shape, flags uint32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_flags(w.c(), C.cn_shape(shape), C.uint32_t(flags)))
}

// ShapeGetFlags: Reads the CN_SHAPE_ flags.
func (w *World) ShapeGetFlags(shape Shape) (uint32, error) {
	defer runtime.KeepAlive(w)
	var out0 uint32
	if err := check(C.cn_shape_get_flags(w.c(), C.cn_shape(shape), (*C.uint32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint32), err
	}
	return out0, nil
}

// ShapeSetUserData: Stores a number for the user.
func (w *World) ShapeSetUserData(shape Shape, user_data uint64) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_user_data(w.c(), C.cn_shape(shape), C.uint64_t(user_data)))
}

// ShapeGetUserData: Reads the user's number.
func (w *World) ShapeGetUserData(shape Shape) (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_shape_get_user_data(w.c(), C.cn_shape(shape), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// ShapeGetAabb: AABB without margin, in the world (in the shape's own space when unattached). O(points).
func (w *World) ShapeGetAabb(shape Shape) (Aabb, error) {
	defer runtime.KeepAlive(w)
	var out0 Aabb
	if err := check(C.cn_shape_get_aabb(w.c(), C.cn_shape(shape), (*C.cn_aabb)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Aabb), err
	}
	return out0, nil
}

// ShapeGetMassData: Mass at the present density, centre in the body's frame, inertia about the shape's own
// centre. O(points).
func (w *World) ShapeGetMassData(shape Shape) (MassData, error) {
	defer runtime.KeepAlive(w)
	var out0 MassData
	if err := check(C.cn_shape_get_mass_data(w.c(), C.cn_shape(shape), (*C.cn_mass_data)(unsafe.Pointer(&out0)))); err != nil {
		return *new(MassData), err
	}
	return out0, nil
}

// ShapeGetCircle: Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.
func (w *World) ShapeGetCircle(shape Shape) (Circle, error) {
	defer runtime.KeepAlive(w)
	var out0 Circle
	if err := check(C.cn_shape_get_circle(w.c(), C.cn_shape(shape), (*C.cn_circle)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Circle), err
	}
	return out0, nil
}

// ShapeGetCapsule: Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.
func (w *World) ShapeGetCapsule(shape Shape) (Capsule, error) {
	defer runtime.KeepAlive(w)
	var out0 Capsule
	if err := check(C.cn_shape_get_capsule(w.c(), C.cn_shape(shape), (*C.cn_capsule)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Capsule), err
	}
	return out0, nil
}

// ShapeGetEdge: Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.
func (w *World) ShapeGetEdge(shape Shape) (Edge, error) {
	defer runtime.KeepAlive(w)
	var out0 Edge
	if err := check(C.cn_shape_get_edge(w.c(), C.cn_shape(shape), (*C.cn_edge)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Edge), err
	}
	return out0, nil
}

// ShapeGetPolygon: Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.
func (w *World) ShapeGetPolygon(shape Shape) (Polygon, error) {
	defer runtime.KeepAlive(w)
	var out0 Polygon
	if err := check(C.cn_shape_get_polygon(w.c(), C.cn_shape(shape), (*C.cn_polygon)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Polygon), err
	}
	return out0, nil
}

// ShapeGetChainPoints: Reads a chain's points in the body's frame, offset applied. Writes at most capacity
// (>= 0); out may be NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type.
// O(points written).
func (w *World) ShapeGetChainPoints(shape Shape) ([]Vec2, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_shape_get_chain_points(w.c(), C.cn_shape(shape), nil, 0, &count)); err != nil {
		return *new([]Vec2), err
	}
	out := make([]Vec2, count)
	if count > 0 {
		if err := check(C.cn_shape_get_chain_points(w.c(), C.cn_shape(shape), (*C.cn_vec2)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Vec2), err
		}
	}
	return out, nil
}

// ShapeSetCircle: Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with
// the checks of creation: the handle and all other properties stay. Mass and box are those of the new
// geometry at once; contacts stay unless the boxes no longer overlap, and the next step computes them anew,
// without the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
// meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most. CN_ERROR_STATE
// for another type. O(contacts + shapes of the body).
func (w *World) ShapeSetCircle(shape Shape, circle *Circle) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_circle(w.c(), C.cn_shape(shape), (*C.cn_circle)(unsafe.Pointer(circle))))
}

// ShapeSetCapsule: Replaces a capsule in place; otherwise as cn_shape_set_circle.
func (w *World) ShapeSetCapsule(shape Shape, capsule *Capsule) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_capsule(w.c(), C.cn_shape(shape), (*C.cn_capsule)(unsafe.Pointer(capsule))))
}

// ShapeSetEdge: Replaces an edge in place; otherwise as cn_shape_set_circle.
func (w *World) ShapeSetEdge(shape Shape, edge *Edge) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_edge(w.c(), C.cn_shape(shape), (*C.cn_edge)(unsafe.Pointer(edge))))
}

// ShapeSetPolygon: Replaces the points of a polygon in place, their number too; otherwise as
// cn_shape_set_circle.
func (w *World) ShapeSetPolygon(shape Shape, polygon *Polygon) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_polygon(w.c(), C.cn_shape(shape), (*C.cn_polygon)(unsafe.Pointer(polygon))))
}

// ShapeTestPoint: out_inside is 1 if the shape contains a world point in metres (in the shape's own space
// when unattached), else 0. Edges and chains contain no point. O(points).
func (w *World) ShapeTestPoint(shape Shape, point_x_m float32, point_y_m float32) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_shape_test_point(w.c(), C.cn_shape(shape), C.float(point_x_m), C.float(point_y_m), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// ContactEvents: The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The
// first call for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY;
// CN_ERROR_LOCKED inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair
// ends (moved apart, body or shape destroyed, detached or disabled, filter or type changed). The next step
// reports pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of the
// step, and got an impulse; bodies that pass a blow on to others that already touch them, without closing,
// have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which they begin),
// STAY or HIT.
func (w *World) ContactEvents(kind int32) ([]ContactEvent, error) {
	defer runtime.KeepAlive(w)
	var data *C.cn_contact_event
	var count C.int32_t
	if err := w.check(C.cn_world_contact_events(w.c(), C.int32_t(kind), &data, &count)); err != nil {
		return *new([]ContactEvent), err
	}
	return append([]ContactEvent(nil), unsafe.Slice((*ContactEvent)(unsafe.Pointer(data)), count)...), nil
}

// SensorEvents: The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for
// contact events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or chains. A
// pair without an awake body reports nothing until one wakes.
func (w *World) SensorEvents() ([]SensorEvent, error) {
	defer runtime.KeepAlive(w)
	var data *C.cn_sensor_event
	var count C.int32_t
	if err := check(C.cn_world_sensor_events(w.c(), &data, &count)); err != nil {
		return *new([]SensorEvent), err
	}
	return append([]SensorEvent(nil), unsafe.Slice((*SensorEvent)(unsafe.Pointer(data)), count)...), nil
}

// BodyGetContacts: The body's contacts as events of kind STAY (touching) or CREATED (not touching), without
// those of sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
// impulses of the last substep. At rest their force is that of the points times substep_count (with
// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (>= 0); out may be NULL when capacity is 0.
// *out_count is their number. O(contacts).
func (w *World) BodyGetContacts(body Body) ([]ContactEvent, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_body_get_contacts(w.c(), C.cn_body(body), nil, 0, &count)); err != nil {
		return *new([]ContactEvent), err
	}
	out := make([]ContactEvent, count)
	if count > 0 {
		if err := check(C.cn_body_get_contacts(w.c(), C.cn_body(body), (*C.cn_contact_event)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]ContactEvent), err
		}
	}
	return out, nil
}

// ShapeGetContacts: The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as
// in cn_body_get_contacts. O(contacts of its body).
func (w *World) ShapeGetContacts(shape Shape) ([]ContactEvent, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_shape_get_contacts(w.c(), C.cn_shape(shape), nil, 0, &count)); err != nil {
		return *new([]ContactEvent), err
	}
	out := make([]ContactEvent, count)
	if count > 0 {
		if err := check(C.cn_shape_get_contacts(w.c(), C.cn_shape(shape), (*C.cn_contact_event)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]ContactEvent), err
		}
	}
	return out, nil
}

// ShapeGetVisitors: The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step.
// out, capacity and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor.
// O(contacts of its body), squared for chains.
func (w *World) ShapeGetVisitors(sensor Shape) ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_shape_get_visitors(w.c(), C.cn_shape(sensor), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_shape_get_visitors(w.c(), C.cn_shape(sensor), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// FellAsleep: Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of
// bodies destroyed since are stale.
func (w *World) FellAsleep() ([]Body, error) {
	defer runtime.KeepAlive(w)
	var data *C.cn_body
	var count C.int32_t
	if err := check(C.cn_world_fell_asleep(w.c(), &data, &count)); err != nil {
		return *new([]Body), err
	}
	return append([]Body(nil), unsafe.Slice((*Body)(unsafe.Pointer(data)), count)...), nil
}

// JointCreateRevolute: Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are
// the same or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateRevolute(def *RevoluteDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_revolute(w.c(), (*C.cn_revolute_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateDistance: Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are
// the same or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateDistance(def *DistanceDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_distance(w.c(), (*C.cn_distance_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateFixed: Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same
// or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateFixed(def *FixedDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_fixed(w.c(), (*C.cn_fixed_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreatePrismatic: Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are
// the same or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreatePrismatic(def *PrismaticDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_prismatic(w.c(), (*C.cn_prismatic_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateWheel: Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same
// or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateWheel(def *WheelDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_wheel(w.c(), (*C.cn_wheel_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateMotor: Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same
// or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateMotor(def *MotorDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_motor(w.c(), (*C.cn_motor_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateMouse: Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same
// or neither is dynamic, or body_a is not 0. O(contacts of body_a).
func (w *World) JointCreateMouse(def *MouseDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_mouse(w.c(), (*C.cn_mouse_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateGear: Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same
// or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateGear(def *GearDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_gear(w.c(), (*C.cn_gear_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreatePulley: Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the
// same or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreatePulley(def *PulleyDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_pulley(w.c(), (*C.cn_pulley_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateRatchet: Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the
// same or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateRatchet(def *RatchetDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_ratchet(w.c(), (*C.cn_ratchet_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateRotarySpring: Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are
// the same or neither is dynamic. O(contacts of body_a).
func (w *World) JointCreateRotarySpring(def *RotarySpringDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_rotary_spring(w.c(), (*C.cn_rotary_spring_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateGroove: Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the
// same or neither is dynamic, or the slot has no length. O(contacts of body_a).
func (w *World) JointCreateGroove(def *GrooveDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_groove(w.c(), (*C.cn_groove_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointCreateFilter: Creates a filter joint, ends the contacts between its bodies and wakes both.
// CN_ERROR_ARGUMENT if the bodies are the same or neither is dynamic. It has a base only: see
// cn_joint_get_base. O(contacts of body_a).
func (w *World) JointCreateFilter(def *FilterJointDef) (Joint, error) {
	defer runtime.KeepAlive(w)
	var out0 Joint
	if err := w.check(C.cn_joint_create_filter(w.c(), (*C.cn_filter_joint_def)(unsafe.Pointer(def)), (*C.cn_joint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Joint), err
	}
	return out0, nil
}

// JointDestroy: Destroys a joint and wakes its bodies. No event is reported.
func (w *World) JointDestroy(joint Joint) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_destroy(w.c(), C.cn_joint(joint)))
}

// JointIsValid: 1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL
// world).
func (w *World) JointIsValid(joint Joint) bool {
	defer runtime.KeepAlive(w)
	return C.cn_joint_is_valid(w.c(), C.cn_joint(joint)) != 0
}

// JointGetType: Reads the type (CN_JOINT_REVOLUTE to _FILTER).
func (w *World) JointGetType(joint Joint) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_joint_get_type(w.c(), C.cn_joint(joint), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// JointGetBodies: Reads both bodies; 0 stands for the world.
func (w *World) JointGetBodies(joint Joint) (Body, Body, error) {
	defer runtime.KeepAlive(w)
	var out0 Body
	var out1 Body
	if err := check(C.cn_joint_get_bodies(w.c(), C.cn_joint(joint), (*C.cn_body)(unsafe.Pointer(&out0)), (*C.cn_body)(unsafe.Pointer(&out1)))); err != nil {
		return *new(Body), *new(Body), err
	}
	return out0, out1, nil
}

// JointGetAnchors: Reads the world positions of both anchors, in metres.
func (w *World) JointGetAnchors(joint Joint) (Vec2, Vec2, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	var out1 Vec2
	if err := check(C.cn_joint_get_anchors(w.c(), C.cn_joint(joint), (*C.cn_vec2)(unsafe.Pointer(&out0)), (*C.cn_vec2)(unsafe.Pointer(&out1)))); err != nil {
		return *new(Vec2), *new(Vec2), err
	}
	return out0, out1, nil
}

// JointGetReaction: Force in newtons and torque in newton metres that the joint applied to body b in the last
// substep; 0 after a change of type or of CN_BODY_ENABLED of one of its bodies.
func (w *World) JointGetReaction(joint Joint) (Vec2, float32, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	var out1 float32
	if err := check(C.cn_joint_get_reaction(w.c(), C.cn_joint(joint), (*C.cn_vec2)(unsafe.Pointer(&out0)), (*C.float)(unsafe.Pointer(&out1)))); err != nil {
		return *new(Vec2), *new(float32), err
	}
	return out0, out1, nil
}

// JointGetError: Error of the joint's rigid parts, both >= 0: metres (anchors apart, lengths beyond limits)
// and radians (angles beyond limits).
func (w *World) JointGetError(joint Joint) (float32, float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	var out1 float32
	if err := check(C.cn_joint_get_error(w.c(), C.cn_joint(joint), (*C.float)(unsafe.Pointer(&out0)), (*C.float)(unsafe.Pointer(&out1)))); err != nil {
		return *new(float32), *new(float32), err
	}
	return out0, out1, nil
}

// JointSetSolver: Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
// (default): together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with
// all connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for
// a world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step;
// does not wake.
func (w *World) JointSetSolver(joint Joint, solver int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_solver(w.c(), C.cn_joint(joint), C.int32_t(solver)))
}

// JointGetSolver: Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).
func (w *World) JointGetSolver(joint Joint) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_joint_get_solver(w.c(), C.cn_joint(joint), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// JointSetUserData: Stores a number for the user.
func (w *World) JointSetUserData(joint Joint, user_data uint64) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_user_data(w.c(), C.cn_joint(joint), C.uint64_t(user_data)))
}

// JointGetUserData: Reads the user's number.
func (w *World) JointGetUserData(joint Joint) (uint64, error) {
	defer runtime.KeepAlive(w)
	var out0 uint64
	if err := check(C.cn_joint_get_user_data(w.c(), C.cn_joint(joint), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// JointSetFlags: Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
// changes.
func (w *World) JointSetFlags(joint Joint, flags uint32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_flags(w.c(), C.cn_joint(joint), C.uint32_t(flags)))
}

// JointGetFlags: Reads the CN_JOINT_ flags.
func (w *World) JointGetFlags(joint Joint) (uint32, error) {
	defer runtime.KeepAlive(w)
	var out0 uint32
	if err := check(C.cn_joint_get_flags(w.c(), C.cn_joint(joint), (*C.uint32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint32), err
	}
	return out0, nil
}

// JointGetRevolute: Reads the definition of a revolute joint. CN_ERROR_STATE for another type.
func (w *World) JointGetRevolute(joint Joint) (RevoluteDef, error) {
	defer runtime.KeepAlive(w)
	var out0 RevoluteDef
	if err := check(C.cn_joint_get_revolute(w.c(), C.cn_joint(joint), (*C.cn_revolute_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(RevoluteDef), err
	}
	return out0, nil
}

// JointSetRevolute: Replaces the definition of a revolute joint, flags and user data included; ignores
// bodies, anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetRevolute(joint Joint, def *RevoluteDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_revolute(w.c(), C.cn_joint(joint), (*C.cn_revolute_def)(unsafe.Pointer(def))))
}

// JointGetDistance: Reads the definition of a distance joint. CN_ERROR_STATE for another type.
func (w *World) JointGetDistance(joint Joint) (DistanceDef, error) {
	defer runtime.KeepAlive(w)
	var out0 DistanceDef
	if err := check(C.cn_joint_get_distance(w.c(), C.cn_joint(joint), (*C.cn_distance_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(DistanceDef), err
	}
	return out0, nil
}

// JointSetDistance: Replaces the definition of a distance joint, flags and user data included; ignores
// bodies, anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetDistance(joint Joint, def *DistanceDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_distance(w.c(), C.cn_joint(joint), (*C.cn_distance_def)(unsafe.Pointer(def))))
}

// JointGetFixed: Reads the definition of a fixed joint. CN_ERROR_STATE for another type.
func (w *World) JointGetFixed(joint Joint) (FixedDef, error) {
	defer runtime.KeepAlive(w)
	var out0 FixedDef
	if err := check(C.cn_joint_get_fixed(w.c(), C.cn_joint(joint), (*C.cn_fixed_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(FixedDef), err
	}
	return out0, nil
}

// JointSetFixed: Replaces the definition of a fixed joint, flags and user data included; ignores bodies,
// anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetFixed(joint Joint, def *FixedDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_fixed(w.c(), C.cn_joint(joint), (*C.cn_fixed_def)(unsafe.Pointer(def))))
}

// JointGetPrismatic: Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.
func (w *World) JointGetPrismatic(joint Joint) (PrismaticDef, error) {
	defer runtime.KeepAlive(w)
	var out0 PrismaticDef
	if err := check(C.cn_joint_get_prismatic(w.c(), C.cn_joint(joint), (*C.cn_prismatic_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(PrismaticDef), err
	}
	return out0, nil
}

// JointSetPrismatic: Replaces the definition of a prismatic joint, flags and user data included; ignores
// bodies, anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetPrismatic(joint Joint, def *PrismaticDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_prismatic(w.c(), C.cn_joint(joint), (*C.cn_prismatic_def)(unsafe.Pointer(def))))
}

// JointGetWheel: Reads the definition of a wheel joint. CN_ERROR_STATE for another type.
func (w *World) JointGetWheel(joint Joint) (WheelDef, error) {
	defer runtime.KeepAlive(w)
	var out0 WheelDef
	if err := check(C.cn_joint_get_wheel(w.c(), C.cn_joint(joint), (*C.cn_wheel_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(WheelDef), err
	}
	return out0, nil
}

// JointSetWheel: Replaces the definition of a wheel joint, flags and user data included; ignores bodies,
// anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetWheel(joint Joint, def *WheelDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_wheel(w.c(), C.cn_joint(joint), (*C.cn_wheel_def)(unsafe.Pointer(def))))
}

// JointGetMotorTo: Reads the definition of a motor joint. CN_ERROR_STATE for another type.
func (w *World) JointGetMotorTo(joint Joint) (MotorDef, error) {
	defer runtime.KeepAlive(w)
	var out0 MotorDef
	if err := check(C.cn_joint_get_motor_to(w.c(), C.cn_joint(joint), (*C.cn_motor_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(MotorDef), err
	}
	return out0, nil
}

// JointSetMotorTo: Replaces the definition of a motor joint, flags and user data included; ignores bodies,
// anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetMotorTo(joint Joint, def *MotorDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_motor_to(w.c(), C.cn_joint(joint), (*C.cn_motor_def)(unsafe.Pointer(def))))
}

// JointGetMouse: Reads the definition of a mouse joint. CN_ERROR_STATE for another type.
func (w *World) JointGetMouse(joint Joint) (MouseDef, error) {
	defer runtime.KeepAlive(w)
	var out0 MouseDef
	if err := check(C.cn_joint_get_mouse(w.c(), C.cn_joint(joint), (*C.cn_mouse_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(MouseDef), err
	}
	return out0, nil
}

// JointSetMouse: Replaces the definition of a mouse joint, flags and user data included; ignores bodies,
// anchors and struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies.
// O(contacts) when CN_JOINT_COLLIDE changes.
func (w *World) JointSetMouse(joint Joint, def *MouseDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_mouse(w.c(), C.cn_joint(joint), (*C.cn_mouse_def)(unsafe.Pointer(def))))
}

// JointGetGear: Reads the definition of a gear joint. CN_ERROR_STATE for another type.
func (w *World) JointGetGear(joint Joint) (GearDef, error) {
	defer runtime.KeepAlive(w)
	var out0 GearDef
	if err := check(C.cn_joint_get_gear(w.c(), C.cn_joint(joint), (*C.cn_gear_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(GearDef), err
	}
	return out0, nil
}

// JointSetGear: Replaces the definition of a gear joint, flags and user data included; ignores bodies,
// anchors and struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another
// type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
func (w *World) JointSetGear(joint Joint, def *GearDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_gear(w.c(), C.cn_joint(joint), (*C.cn_gear_def)(unsafe.Pointer(def))))
}

// JointGetPulley: Reads the definition of a pulley joint. CN_ERROR_STATE for another type.
func (w *World) JointGetPulley(joint Joint) (PulleyDef, error) {
	defer runtime.KeepAlive(w)
	var out0 PulleyDef
	if err := check(C.cn_joint_get_pulley(w.c(), C.cn_joint(joint), (*C.cn_pulley_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(PulleyDef), err
	}
	return out0, nil
}

// JointSetPulley: Replaces the definition of a pulley joint, flags and user data included; ignores bodies,
// anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetPulley(joint Joint, def *PulleyDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_pulley(w.c(), C.cn_joint(joint), (*C.cn_pulley_def)(unsafe.Pointer(def))))
}

// JointGetRatchet: Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.
func (w *World) JointGetRatchet(joint Joint) (RatchetDef, error) {
	defer runtime.KeepAlive(w)
	var out0 RatchetDef
	if err := check(C.cn_joint_get_ratchet(w.c(), C.cn_joint(joint), (*C.cn_ratchet_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(RatchetDef), err
	}
	return out0, nil
}

// JointSetRatchet: Replaces the definition of a ratchet joint, flags and user data included; ignores bodies,
// anchors and struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type.
// Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.
func (w *World) JointSetRatchet(joint Joint, def *RatchetDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_ratchet(w.c(), C.cn_joint(joint), (*C.cn_ratchet_def)(unsafe.Pointer(def))))
}

// JointGetRotarySpring: Reads the definition of a rotary spring. CN_ERROR_STATE for another type.
func (w *World) JointGetRotarySpring(joint Joint) (RotarySpringDef, error) {
	defer runtime.KeepAlive(w)
	var out0 RotarySpringDef
	if err := check(C.cn_joint_get_rotary_spring(w.c(), C.cn_joint(joint), (*C.cn_rotary_spring_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(RotarySpringDef), err
	}
	return out0, nil
}

// JointSetRotarySpring: Replaces the definition of a rotary spring, flags and user data included; ignores
// bodies, anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetRotarySpring(joint Joint, def *RotarySpringDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_rotary_spring(w.c(), C.cn_joint(joint), (*C.cn_rotary_spring_def)(unsafe.Pointer(def))))
}

// JointGetGroove: Reads the definition of a groove joint. CN_ERROR_STATE for another type.
func (w *World) JointGetGroove(joint Joint) (GrooveDef, error) {
	defer runtime.KeepAlive(w)
	var out0 GrooveDef
	if err := check(C.cn_joint_get_groove(w.c(), C.cn_joint(joint), (*C.cn_groove_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(GrooveDef), err
	}
	return out0, nil
}

// JointSetGroove: Replaces the definition of a groove joint, flags and user data included; ignores bodies,
// anchors and struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
// CN_JOINT_COLLIDE changes.
func (w *World) JointSetGroove(joint Joint, def *GrooveDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_groove(w.c(), C.cn_joint(joint), (*C.cn_groove_def)(unsafe.Pointer(def))))
}

// JointGetBase: Reads the base of a joint of any type.
func (w *World) JointGetBase(joint Joint) (JointBase, error) {
	defer runtime.KeepAlive(w)
	var out0 JointBase
	if err := check(C.cn_joint_get_base(w.c(), C.cn_joint(joint), (*C.cn_joint_base)(unsafe.Pointer(&out0)))); err != nil {
		return *new(JointBase), err
	}
	return out0, nil
}

// JointSetBase: Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of
// base. Ranges as in cn_joint_base. Wakes both bodies.
func (w *World) JointSetBase(joint Joint, base *JointBase) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_base(w.c(), C.cn_joint(joint), (*C.cn_joint_base)(unsafe.Pointer(base))))
}

// JointSetTarget: Sets the target of a mouse joint, a world point in metres; cheap enough for every frame.
// CN_ERROR_STATE for another type. Wakes the body.
func (w *World) JointSetTarget(joint Joint, target_x_m float32, target_y_m float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_target(w.c(), C.cn_joint(joint), C.float(target_x_m), C.float(target_y_m)))
}

// JointGetPosition: Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor:
// without reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the
// translation along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet,
// rotary spring: angle b - angle a; these three over whole turns.
func (w *World) JointGetPosition(joint Joint) (float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	if err := check(C.cn_joint_get_position(w.c(), C.cn_joint(joint), (*C.float)(unsafe.Pointer(&out0)))); err != nil {
		return *new(float32), err
	}
	return out0, nil
}

// JointGetSpeed: Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against
// a. A positive motor speed has the same sign.
func (w *World) JointGetSpeed(joint Joint) (float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	if err := check(C.cn_joint_get_speed(w.c(), C.cn_joint(joint), (*C.float)(unsafe.Pointer(&out0)))); err != nil {
		return *new(float32), err
	}
	return out0, nil
}

// JointSetMotor: Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, >= 0) of a revolute,
// distance, prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.
func (w *World) JointSetMotor(joint Joint, speed float32, force_or_torque_max float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_motor(w.c(), C.cn_joint(joint), C.float(speed), C.float(force_or_torque_max)))
}

// JointSetLimits: Sets the limits, lower <= upper, of a revolute (radians in [-pi, pi]), distance (metres >=
// 0), prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.
func (w *World) JointSetLimits(joint Joint, lower float32, upper float32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_joint_set_limits(w.c(), C.cn_joint(joint), C.float(lower), C.float(upper)))
}

// JointEvents: Joints and constraints that exceeded a break threshold in the last step, and those destroyed
// with a body in that step or between it and the step before.
func (w *World) JointEvents() ([]JointEvent, error) {
	defer runtime.KeepAlive(w)
	var data *C.cn_joint_event
	var count C.int32_t
	if err := check(C.cn_world_joint_events(w.c(), &data, &count)); err != nil {
		return *new([]JointEvent), err
	}
	return append([]JointEvent(nil), unsafe.Slice((*JointEvent)(unsafe.Pointer(data)), count)...), nil
}

// ConstraintCreateAngle: Creates an angle constraint, solved with the joints, before contacts.
// CN_ERROR_ARGUMENT if the body is not dynamic. Wakes the body.
func (w *World) ConstraintCreateAngle(def *AngleConstraintDef) (Constraint, error) {
	defer runtime.KeepAlive(w)
	var out0 Constraint
	if err := w.check(C.cn_constraint_create_angle(w.c(), (*C.cn_angle_constraint_def)(unsafe.Pointer(def)), (*C.cn_constraint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Constraint), err
	}
	return out0, nil
}

// ConstraintCreateLine: Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT
// if the body is not dynamic. Wakes the body.
func (w *World) ConstraintCreateLine(def *LineConstraintDef) (Constraint, error) {
	defer runtime.KeepAlive(w)
	var out0 Constraint
	if err := w.check(C.cn_constraint_create_line(w.c(), (*C.cn_line_constraint_def)(unsafe.Pointer(def)), (*C.cn_constraint)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Constraint), err
	}
	return out0, nil
}

// ConstraintDestroy: Destroys a constraint and wakes its body. No event is reported.
func (w *World) ConstraintDestroy(constraint Constraint) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_constraint_destroy(w.c(), C.cn_constraint(constraint)))
}

// ConstraintIsValid: 1 if the handle names a living constraint of this world, else 0 (also for a joint and a
// NULL world).
func (w *World) ConstraintIsValid(constraint Constraint) bool {
	defer runtime.KeepAlive(w)
	return C.cn_constraint_is_valid(w.c(), C.cn_constraint(constraint)) != 0
}

// ConstraintGetType: Reads the type (CN_CONSTRAINT_ANGLE or _LINE).
func (w *World) ConstraintGetType(constraint Constraint) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_constraint_get_type(w.c(), C.cn_constraint(constraint), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// ConstraintGetBody: Reads the body.
func (w *World) ConstraintGetBody(constraint Constraint) (Body, error) {
	defer runtime.KeepAlive(w)
	var out0 Body
	if err := check(C.cn_constraint_get_body(w.c(), C.cn_constraint(constraint), (*C.cn_body)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Body), err
	}
	return out0, nil
}

// ConstraintGetAngle: Reads the definition of an angle constraint. CN_ERROR_STATE for another type.
func (w *World) ConstraintGetAngle(constraint Constraint) (AngleConstraintDef, error) {
	defer runtime.KeepAlive(w)
	var out0 AngleConstraintDef
	if err := check(C.cn_constraint_get_angle(w.c(), C.cn_constraint(constraint), (*C.cn_angle_constraint_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(AngleConstraintDef), err
	}
	return out0, nil
}

// ConstraintSetAngle: Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for
// another type. Wakes the body.
func (w *World) ConstraintSetAngle(constraint Constraint, def *AngleConstraintDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_constraint_set_angle(w.c(), C.cn_constraint(constraint), (*C.cn_angle_constraint_def)(unsafe.Pointer(def))))
}

// ConstraintGetLine: Reads the definition of a line constraint. CN_ERROR_STATE for another type.
func (w *World) ConstraintGetLine(constraint Constraint) (LineConstraintDef, error) {
	defer runtime.KeepAlive(w)
	var out0 LineConstraintDef
	if err := check(C.cn_constraint_get_line(w.c(), C.cn_constraint(constraint), (*C.cn_line_constraint_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(LineConstraintDef), err
	}
	return out0, nil
}

// ConstraintSetLine: Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another
// type. Wakes the body.
func (w *World) ConstraintSetLine(constraint Constraint, def *LineConstraintDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_constraint_set_line(w.c(), C.cn_constraint(constraint), (*C.cn_line_constraint_def)(unsafe.Pointer(def))))
}

// ConstraintGetPosition: Angle constraint: the angle in radians over whole turns. Line constraint: the
// coordinate of the point along the axis, in metres from origin.
func (w *World) ConstraintGetPosition(constraint Constraint) (float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	if err := check(C.cn_constraint_get_position(w.c(), C.cn_constraint(constraint), (*C.float)(unsafe.Pointer(&out0)))); err != nil {
		return *new(float32), err
	}
	return out0, nil
}

// ConstraintGetReaction: Force in newtons and torque in newton metres that the constraint applied to the body
// in the last substep.
func (w *World) ConstraintGetReaction(constraint Constraint) (Vec2, float32, error) {
	defer runtime.KeepAlive(w)
	var out0 Vec2
	var out1 float32
	if err := check(C.cn_constraint_get_reaction(w.c(), C.cn_constraint(constraint), (*C.cn_vec2)(unsafe.Pointer(&out0)), (*C.float)(unsafe.Pointer(&out1)))); err != nil {
		return *new(Vec2), *new(float32), err
	}
	return out0, out1, nil
}

// ConstraintGetError: Distance beyond the allowed range, >= 0: metres for a line constraint, radians for an
// angle constraint.
func (w *World) ConstraintGetError(constraint Constraint) (float32, float32, error) {
	defer runtime.KeepAlive(w)
	var out0 float32
	var out1 float32
	if err := check(C.cn_constraint_get_error(w.c(), C.cn_constraint(constraint), (*C.float)(unsafe.Pointer(&out0)), (*C.float)(unsafe.Pointer(&out1)))); err != nil {
		return *new(float32), *new(float32), err
	}
	return out0, out1, nil
}

// GetConstraints: Handles of all constraints, ordered by slot; out, capacity and *out_count as in
// cn_world_get_bodies. O(slots).
func (w *World) GetConstraints() ([]Constraint, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_get_constraints(w.c(), nil, 0, &count)); err != nil {
		return *new([]Constraint), err
	}
	out := make([]Constraint, count)
	if count > 0 {
		if err := check(C.cn_world_get_constraints(w.c(), (*C.cn_constraint)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Constraint), err
		}
	}
	return out, nil
}

// BodyGetConstraints: Handles of the body's constraints; out, capacity and *out_count as in
// cn_world_get_bodies. O(joints + constraints of the body).
func (w *World) BodyGetConstraints(body Body) ([]Constraint, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_body_get_constraints(w.c(), C.cn_body(body), nil, 0, &count)); err != nil {
		return *new([]Constraint), err
	}
	out := make([]Constraint, count)
	if count > 0 {
		if err := check(C.cn_body_get_constraints(w.c(), C.cn_body(body), (*C.cn_constraint)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Constraint), err
		}
	}
	return out, nil
}

// SetFixedStep: Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max
// steps an update, 1 to 1000, default 8.
func (w *World) SetFixedStep(step_s float32, steps_max int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_set_fixed_step(w.c(), C.float(step_s), C.int32_t(steps_max)))
}

// Update: Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max.
// The event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.
func (w *World) Update(elapsed_s float32) (UpdateReport, error) {
	defer runtime.KeepAlive(w)
	var out0 UpdateReport
	if err := w.check(C.cn_world_update(w.c(), C.float(elapsed_s), (*C.cn_update_report)(unsafe.Pointer(&out0)))); err != nil {
		return *new(UpdateReport), err
	}
	return out0, nil
}

// ReadPosesInterpolated: Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0
// before the last step, 1 after it. Bodies that did not take part in the last step have their present pose.
// bodies and count as in cn_world_read_poses. O(count).
func (w *World) ReadPosesInterpolated(bodies []Body, factor float32, out []Pose) error {
	defer runtime.KeepAlive(w)
	if bodies != nil && len(bodies) != len(out) {
		return errUneven
	}
	return check(C.cn_world_read_poses_interpolated(w.c(), (*C.cn_body)(unsafe.Pointer(unsafe.SliceData(bodies))), C.int32_t(len(out)), C.float(factor), (*C.cn_pose)(unsafe.Pointer(unsafe.SliceData(out)))))
}

// CastRay: Nearest hit of a ray; out->shape is 0 when there is none. Edges are hit from both sides, chains
// from their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child.
// filter may be NULL: the defaults. O(log shapes) to O(shapes along the ray).
func (w *World) CastRay(ray *Ray, filter *QueryFilter) (RayHit, error) {
	defer runtime.KeepAlive(w)
	var out0 RayHit
	if err := check(C.cn_world_cast_ray(w.c(), (*C.cn_ray)(unsafe.Pointer(ray)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_ray_hit)(unsafe.Pointer(&out0)))); err != nil {
		return *new(RayHit), err
	}
	return out0, nil
}

// CastRayAny: out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be
// NULL. O(log shapes) to O(shapes along the ray).
func (w *World) CastRayAny(ray *Ray, filter *QueryFilter) (int32, error) {
	defer runtime.KeepAlive(w)
	var out0 int32
	if err := check(C.cn_world_cast_ray_any(w.c(), (*C.cn_ray)(unsafe.Pointer(ray)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.int32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(int32), err
	}
	return out0, nil
}

// CastRayAll: Hits of a ray, nearest first: the nearest capacity (>= 0) are written, *out_count is the number
// found. A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log capacity).
func (w *World) CastRayAll(ray *Ray, filter *QueryFilter) ([]RayHit, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_cast_ray_all(w.c(), (*C.cn_ray)(unsafe.Pointer(ray)), (*C.cn_query_filter)(unsafe.Pointer(filter)), nil, 0, &count)); err != nil {
		return *new([]RayHit), err
	}
	out := make([]RayHit, count)
	if count > 0 {
		if err := check(C.cn_world_cast_ray_all(w.c(), (*C.cn_ray)(unsafe.Pointer(ray)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_ray_hit)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]RayHit), err
		}
	}
	return out, nil
}

// CastRays: Nearest hit of each of count (>= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
// filter may be NULL. O(sum of the rays).
func (w *World) CastRays(rays []Ray, filter *QueryFilter, out []RayHit) error {
	defer runtime.KeepAlive(w)
	if len(rays) != len(out) {
		return errUneven
	}
	return check(C.cn_world_cast_rays(w.c(), (*C.cn_ray)(unsafe.Pointer(unsafe.SliceData(rays))), C.int32_t(len(out)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_ray_hit)(unsafe.Pointer(unsafe.SliceData(out)))))
}

// ShapeCastRay: Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when
// unattached. O(points of the shape).
func (w *World) ShapeCastRay(shape Shape, ray *Ray) (RayHit, error) {
	defer runtime.KeepAlive(w)
	var out0 RayHit
	if err := check(C.cn_shape_cast_ray(w.c(), C.cn_shape(shape), (*C.cn_ray)(unsafe.Pointer(ray)), (*C.cn_ray_hit)(unsafe.Pointer(&out0)))); err != nil {
		return *new(RayHit), err
	}
	return out0, nil
}

// CastShape: First shape that a convex shape meets when moved by translation (metres, at most 2e6 length
// units each way) without turning. shape is a polygon in world coordinates; with radius_m > 0 its count may
// be 1 or 2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of
// the moving points is in front of it. filter may be NULL. O(shapes along the way).
func (w *World) CastShape(shape *Polygon, translation_x_m float32, translation_y_m float32, filter *QueryFilter) (RayHit, error) {
	defer runtime.KeepAlive(w)
	var out0 RayHit
	if err := check(C.cn_world_cast_shape(w.c(), (*C.cn_polygon)(unsafe.Pointer(shape)), C.float(translation_x_m), C.float(translation_y_m), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_ray_hit)(unsafe.Pointer(&out0)))); err != nil {
		return *new(RayHit), err
	}
	return out0, nil
}

// OverlapAabb: Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the
// order of cn_world_get_shapes, each once. The first capacity (>= 0) are written; *out_count is the number
// found. filter may be NULL. O(log shapes) to O(boxes in the region).
func (w *World) OverlapAabb(box *Aabb, filter *QueryFilter) ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_overlap_aabb(w.c(), (*C.cn_aabb)(unsafe.Pointer(box)), (*C.cn_query_filter)(unsafe.Pointer(filter)), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_world_overlap_aabb(w.c(), (*C.cn_aabb)(unsafe.Pointer(box)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// OverlapCircle: Shapes that exactly overlap a circle; order, capacity, filter and cost as in
// cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
func (w *World) OverlapCircle(circle *Circle, filter *QueryFilter) ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_overlap_circle(w.c(), (*C.cn_circle)(unsafe.Pointer(circle)), (*C.cn_query_filter)(unsafe.Pointer(filter)), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_world_overlap_circle(w.c(), (*C.cn_circle)(unsafe.Pointer(circle)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// OverlapPolygon: Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter
// and cost as in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.
func (w *World) OverlapPolygon(polygon *Polygon, filter *QueryFilter) ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_overlap_polygon(w.c(), (*C.cn_polygon)(unsafe.Pointer(polygon)), (*C.cn_query_filter)(unsafe.Pointer(filter)), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_world_overlap_polygon(w.c(), (*C.cn_polygon)(unsafe.Pointer(polygon)), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// OverlapPoint: Shapes that contain a world point in metres; order, capacity, filter and cost as in
// cn_world_overlap_aabb. Edges and chains contain no point.
func (w *World) OverlapPoint(x_m float32, y_m float32, filter *QueryFilter) ([]Shape, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_world_overlap_point(w.c(), C.float(x_m), C.float(y_m), (*C.cn_query_filter)(unsafe.Pointer(filter)), nil, 0, &count)); err != nil {
		return *new([]Shape), err
	}
	out := make([]Shape, count)
	if count > 0 {
		if err := check(C.cn_world_overlap_point(w.c(), C.float(x_m), C.float(y_m), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_shape)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Shape), err
		}
	}
	return out, nil
}

// ClosestPoint: Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if
// several contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.
func (w *World) ClosestPoint(x_m float32, y_m float32, distance_max_m float32, filter *QueryFilter) (Closest, error) {
	defer runtime.KeepAlive(w)
	var out0 Closest
	if err := check(C.cn_world_closest_point(w.c(), C.float(x_m), C.float(y_m), C.float(distance_max_m), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_closest)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Closest), err
	}
	return out0, nil
}

// MoverCollide: Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in
// cn_world_cast_shape) moved by position, from the same manifolds as in a step, rigid. Writes at most
// capacity, those of least separation first; *out_count is their number. Sensors have no planes. With
// CN_QUERY_ONE_WAY a one-way shape has a plane only on its upper side, and only for an overlap of at most
// 0.5% of the length unit plus its rise in the last step. Shapes wholly behind the plane of another shape are
// left out, so that seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby,
// squared).
func (w *World) MoverCollide(shape *Polygon, position_x_m float32, position_y_m float32, margin_m float32, filter *QueryFilter) ([]Plane, error) {
	defer runtime.KeepAlive(w)
	var count C.int32_t
	if err := check(C.cn_mover_collide(w.c(), (*C.cn_polygon)(unsafe.Pointer(shape)), C.float(position_x_m), C.float(position_y_m), C.float(margin_m), (*C.cn_query_filter)(unsafe.Pointer(filter)), nil, 0, &count)); err != nil {
		return *new([]Plane), err
	}
	out := make([]Plane, count)
	if count > 0 {
		if err := check(C.cn_mover_collide(w.c(), (*C.cn_polygon)(unsafe.Pointer(shape)), C.float(position_x_m), C.float(position_y_m), C.float(margin_m), (*C.cn_query_filter)(unsafe.Pointer(filter)), (*C.cn_plane)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Plane), err
		}
	}
	return out, nil
}

// MoverMove: Moves a character by dt_s (0 < dt_s <= 1). Call it after each cn_world_step, else it lags one
// step behind the ground that carries it. 1. carried   by the motion of its ground since the last move: of
// the point of ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across up,
// along the ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A step up
// where a too steep surface blocks it: up by step_height_m, forward, down on walkable ground flying    in the
// air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off keep
// ground_velocity_mps 3. sliding   both by collision planes, cn_mover_solve and casts, up to iterations_max
// times: no speed passes through a wall 4. pushing   dynamic bodies in the way get a force for the next step
// that brings them to the character's velocity, of at most push_force_N each 5. ground    ground that it
// touches, or that lies within snap_m below a walking character; velocity_mps loses blocked components The
// result depends on the world, def and mover alone: equal calls give equal bits. The loop of planes, solver
// and cast is that of Box2D 3's sample of a character mover (Catto, 2025). Pushed bodies wake; nothing else
// in the world changes. O(shapes nearby x iterations_max): about 1 us standing, 3 us walking, 10 us against a
// wall.
func (w *World) MoverMove(def *MoverDef, dt_s float32, mover *Mover) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_mover_move(w.c(), (*C.cn_mover_def)(unsafe.Pointer(def)), C.float(dt_s), (*C.cn_mover)(unsafe.Pointer(mover))))
}

// ShapeSetArea: Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's
// filter says which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an
// area that loses the flag later does nothing while it is without. Gravity, and damping without density, act
// on bodies whose centre of mass is in the area (on its border too) while one of their shapes touches it: on
// a body half in it in full or not at all. The medium acts on the part of each shape that is in the area,
// exactly for polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The
// surface of a circle or capsule is flat across a body, as of a planet. Shapes of a body do not shade each
// other. The area's body feels no reaction. Between steps nothing happens: the acceleration is that in the
// middle of the next step (leapfrog), so bodies on orbits and floating bodies keep their energy. Damping and
// drag are implicit: stable at any strength, mass and time step, with exact terminal speeds. Bodies that
// enter or leave, that are in an area that moves, and those in it now, wake; bodies at rest in it may sleep.
// Areas are in saves and files. Floats whose draught is less than about g dt^2 (3 mm at 60 steps a second)
// are damped, and carry less under a load. An area takes 64 bytes of the world's memory; a step takes about
// 0.15 us for each shape in an area, 0.35 us in a medium. Best on a body of its own: O(contacts of the body).
func (w *World) ShapeSetArea(shape Shape, def *AreaDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_set_area(w.c(), C.cn_shape(shape), (*C.cn_area_def)(unsafe.Pointer(def))))
}

// ShapeGetArea: Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).
func (w *World) ShapeGetArea(shape Shape) (AreaDef, error) {
	defer runtime.KeepAlive(w)
	var out0 AreaDef
	if err := check(C.cn_shape_get_area(w.c(), C.cn_shape(shape), (*C.cn_area_def)(unsafe.Pointer(&out0)))); err != nil {
		return *new(AreaDef), err
	}
	return out0, nil
}

// ShapeApplyWind: The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it
// before each step. flow: velocity of the air in m/s. On each part of the outline that faces the flow, of
// width w across it, with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of
// Newton (1687), and across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle
// between surface and flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the whole
// outline, round parts included, and drag along straight edges also for turning bodies; edges and chains are
// plates with two sides. Solved implicitly, so that wind never reverses the motion relative to it, at any
// speed, mass and time; a pure drag is the exact solution of m v' = -k v^2. wake 0: sleeping bodies stay
// asleep and unchanged; else they wake. Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE
// for a shape without a body. O(points).
func (w *World) ShapeApplyWind(shape Shape, flow_x_mps float32, flow_y_mps float32, drag_kgpm2 float32, lift_kgpm2 float32, dt_s float32, wake int32) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_shape_apply_wind(w.c(), C.cn_shape(shape), C.float(flow_x_mps), C.float(flow_y_mps), C.float(drag_kgpm2), C.float(lift_kgpm2), C.float(dt_s), C.int32_t(wake)))
}

// Explode: Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and
// wakes them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).
func (w *World) Explode(def *ExplosionDef) error {
	defer runtime.KeepAlive(w)
	return w.check(C.cn_world_explode(w.c(), (*C.cn_explosion_def)(unsafe.Pointer(def))))
}

// Insert: Inserts a finite box with lower_m <= upper_m; *out_item, its handle, is never 0. O(log n).
func (t *Tree) Insert(box *Aabb, user_data uint64) (uint32, error) {
	defer runtime.KeepAlive(t)
	var out0 uint32
	if err := check(C.cn_tree_insert(t.c(), (*C.cn_aabb)(unsafe.Pointer(box)), C.uint64_t(user_data), (*C.uint32_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint32), err
	}
	return out0, nil
}

// Remove: Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).
func (t *Tree) Remove(item uint32) error {
	defer runtime.KeepAlive(t)
	return check(C.cn_tree_remove(t.c(), C.uint32_t(item)))
}

// Move: Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log
// n). CN_ERROR_HANDLE for a stale item.
func (t *Tree) Move(item uint32, box *Aabb) error {
	defer runtime.KeepAlive(t)
	return check(C.cn_tree_move(t.c(), C.uint32_t(item), (*C.cn_aabb)(unsafe.Pointer(box))))
}

// GetBox: Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.
func (t *Tree) GetBox(item uint32) (Aabb, error) {
	defer runtime.KeepAlive(t)
	var out0 Aabb
	if err := check(C.cn_tree_get_box(t.c(), C.uint32_t(item), (*C.cn_aabb)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Aabb), err
	}
	return out0, nil
}

// GetStats: Reads the number of items and the height of the tree.
func (t *Tree) GetStats() (int32, int32, error) {
	defer runtime.KeepAlive(t)
	var out0 int32
	var out1 int32
	if err := check(C.cn_tree_get_stats(t.c(), (*C.int32_t)(unsafe.Pointer(&out0)), (*C.int32_t)(unsafe.Pointer(&out1)))); err != nil {
		return *new(int32), *new(int32), err
	}
	return out0, out1, nil
}

// Version: Version of the library as major * 1000000 + minor * 1000 + patch.
func Version() int32 {
	return int32(C.cn_version())
}

// AbiVersion: CN_ABI_VERSION of the library that was linked; a binding compares it with its own.
func AbiVersion() int32 {
	return int32(C.cn_abi_version())
}

// ResultText: English text for a result code: static, never NULL.
func ResultText(result int32) string {
	return C.GoString(C.cn_result_text(C.cn_result(result)))
}

// SaveDeltaSize: Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).
func SaveDeltaSize(base []byte, save []byte) (uint64, error) {
	var out0 uint64
	if err := check(C.cn_save_delta_size(unsafe.Pointer(unsafe.SliceData(base)), C.uint64_t(len(base)), unsafe.Pointer(unsafe.SliceData(save)), C.uint64_t(len(save)), (*C.uint64_t)(unsafe.Pointer(&out0)))); err != nil {
		return *new(uint64), err
	}
	return out0, nil
}

// SaveDelta: Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its
// bytes to out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).
func SaveDelta(base []byte, save []byte) ([]byte, error) {
	var bytes C.uint64_t
	if err := check(C.cn_save_delta_size(unsafe.Pointer(unsafe.SliceData(base)), C.uint64_t(len(base)), unsafe.Pointer(unsafe.SliceData(save)), C.uint64_t(len(save)), &bytes)); err != nil {
		return *new([]byte), err
	}
	out := make([]byte, bytes)
	if err := check(C.cn_save_delta(unsafe.Pointer(unsafe.SliceData(base)), C.uint64_t(len(base)), unsafe.Pointer(unsafe.SliceData(save)), C.uint64_t(len(save)), unsafe.Pointer(unsafe.SliceData(out)), bytes, &bytes)); err != nil {
		return *new([]byte), err
	}
	return out[:bytes], nil
}

// SaveApply: Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes
// to out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
// CN_ERROR_CAPACITY if out is too small. O(bytes).
func SaveApply(base []byte, delta []byte) ([]byte, error) {
	var bytes C.uint64_t
	bytes = C.uint64_t(len(base) + len(delta))
	out := make([]byte, bytes)
	if err := check(C.cn_save_apply(unsafe.Pointer(unsafe.SliceData(base)), C.uint64_t(len(base)), unsafe.Pointer(unsafe.SliceData(delta)), C.uint64_t(len(delta)), unsafe.Pointer(unsafe.SliceData(out)), bytes, &bytes)); err != nil {
		return *new([]byte), err
	}
	return out[:bytes], nil
}

// PolygonMakeHull: Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it
// inserts farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the
// most area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below
// 5 mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m >= 0.
// O(count^2) at worst.
func PolygonMakeHull(points_m []Vec2, radius_m float32) (Polygon, error) {
	var out0 Polygon
	if err := check(C.cn_polygon_make_hull((*C.cn_vec2)(unsafe.Pointer(unsafe.SliceData(points_m))), C.int32_t(len(points_m)), C.float(radius_m), (*C.cn_polygon)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Polygon), err
	}
	return out0, nil
}

// PolygonMakeBox: A box of half sizes > 0 in metres, with its centre in metres, turned about its own centre
// by angle_rad (|angle| <= 1e4); radius_m >= 0.
func PolygonMakeBox(half_width_m float32, half_height_m float32, center_x_m float32, center_y_m float32, angle_rad float32, radius_m float32) (Polygon, error) {
	var out0 Polygon
	if err := check(C.cn_polygon_make_box(C.float(half_width_m), C.float(half_height_m), C.float(center_x_m), C.float(center_y_m), C.float(angle_rad), C.float(radius_m), (*C.cn_polygon)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Polygon), err
	}
	return out0, nil
}

// OutlineDecompose: Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for
// cn_shape_create_polygon in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise,
// with radius_m 0 and without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel,
// Mehlhorn, 1983). Points nearer than 0.05% of the length unit to the one before and collinear points are
// dropped, and pieces thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or
// touches itself or has no area. Writes at most capacity pieces (>= 0; count - 2 always suffice); out may be
// NULL when capacity is 0. *out_count is the number of all. 34 KB of stack. O(count^2).
func OutlineDecompose(points_m []Vec2, length_unit_m float32) ([]Polygon, error) {
	var count C.int32_t
	if err := check(C.cn_outline_decompose((*C.cn_vec2)(unsafe.Pointer(unsafe.SliceData(points_m))), C.int32_t(len(points_m)), C.float(length_unit_m), nil, 0, &count)); err != nil {
		return *new([]Polygon), err
	}
	out := make([]Polygon, count)
	if count > 0 {
		if err := check(C.cn_outline_decompose((*C.cn_vec2)(unsafe.Pointer(unsafe.SliceData(points_m))), C.int32_t(len(points_m)), C.float(length_unit_m), (*C.cn_polygon)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Polygon), err
		}
	}
	return out, nil
}

// OutlineSimplify: Keeps those of count (2 to 65536; closed: 3) points from which the simplified line
// deviates by more than tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point
// joins the first, else 0. A closed outline within tolerance_m of a segment has 0 points left. A simple
// outline can cross itself afterwards if parts of it are nearer than tolerance_m. Writes at most capacity
// points (>= 0); out may be points_m, or NULL when capacity is 0. *out_count is the number of all. O(count *
// *out_count) at worst.
func OutlineSimplify(points_m []Vec2, closed int32, tolerance_m float32) ([]Vec2, error) {
	var count C.int32_t
	if err := check(C.cn_outline_simplify((*C.cn_vec2)(unsafe.Pointer(unsafe.SliceData(points_m))), C.int32_t(len(points_m)), C.int32_t(closed), C.float(tolerance_m), nil, 0, &count)); err != nil {
		return *new([]Vec2), err
	}
	out := make([]Vec2, count)
	if count > 0 {
		if err := check(C.cn_outline_simplify((*C.cn_vec2)(unsafe.Pointer(unsafe.SliceData(points_m))), C.int32_t(len(points_m)), C.int32_t(closed), C.float(tolerance_m), (*C.cn_vec2)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Vec2), err
		}
	}
	return out, nil
}

// OutlineFromCells: An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its
// rows (1 to 4096), squares of side cell_m > 0 with the lower left corner of the first at the origin.
// cells[row * columns + column] is not 0 where solid; row 0 is the lowest. outline is the outline's number,
// from 0; *out_count is 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid
// on its left: counter-clockwise around solids, clockwise around holes. Its points are corners of cells.
// Solid cells that touch at a corner only are apart; an outline may pass such a corner twice. Writes at most
// capacity points (>= 0); out may be NULL when capacity is 0. *out_count is the number of all. O(cells + n
// log n) for a boundary of n edges.
func OutlineFromCells(cells []uint8, columns int32, origin_x_m float32, origin_y_m float32, cell_m float32, outline int32) ([]Vec2, error) {
	var count C.int32_t
	if err := check(C.cn_outline_from_cells((*C.uint8_t)(unsafe.Pointer(unsafe.SliceData(cells))), C.int32_t(len(cells)), C.int32_t(columns), C.float(origin_x_m), C.float(origin_y_m), C.float(cell_m), C.int32_t(outline), nil, 0, &count)); err != nil {
		return *new([]Vec2), err
	}
	out := make([]Vec2, count)
	if count > 0 {
		if err := check(C.cn_outline_from_cells((*C.uint8_t)(unsafe.Pointer(unsafe.SliceData(cells))), C.int32_t(len(cells)), C.int32_t(columns), C.float(origin_x_m), C.float(origin_y_m), C.float(cell_m), C.int32_t(outline), (*C.cn_vec2)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Vec2), err
		}
	}
	return out, nil
}

// OutlineFromField: The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns +
// column], all finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at
// least 2 columns and rows. A point of an outline lies between two neighbouring samples, by linear
// interpolation, at least spacing_m / 64 from both; the grid's border closes outlines. An outline never
// touches itself or another one. cn_outline_simplify removes its collinear points. O(values + n log n).
func OutlineFromField(values []float32, columns int32, threshold float32, origin_x_m float32, origin_y_m float32, spacing_m float32, outline int32) ([]Vec2, error) {
	var count C.int32_t
	if err := check(C.cn_outline_from_field((*C.float)(unsafe.Pointer(unsafe.SliceData(values))), C.int32_t(len(values)), C.int32_t(columns), C.float(threshold), C.float(origin_x_m), C.float(origin_y_m), C.float(spacing_m), C.int32_t(outline), nil, 0, &count)); err != nil {
		return *new([]Vec2), err
	}
	out := make([]Vec2, count)
	if count > 0 {
		if err := check(C.cn_outline_from_field((*C.float)(unsafe.Pointer(unsafe.SliceData(values))), C.int32_t(len(values)), C.int32_t(columns), C.float(threshold), C.float(origin_x_m), C.float(origin_y_m), C.float(spacing_m), C.int32_t(outline), (*C.cn_vec2)(unsafe.Pointer(&out[0])), count, &count)); err != nil {
			return *new([]Vec2), err
		}
	}
	return out, nil
}

// PolygonDistance: Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes
// without their radii are apart, else by their Minkowski difference. Needs no world; runs in any thread.
// O(points).
func PolygonDistance(a *Polygon, pose_a *Pose, b *Polygon, pose_b *Pose) (Distance, error) {
	var out0 Distance
	if err := check(C.cn_polygon_distance((*C.cn_polygon)(unsafe.Pointer(a)), (*C.cn_pose)(unsafe.Pointer(pose_a)), (*C.cn_polygon)(unsafe.Pointer(b)), (*C.cn_pose)(unsafe.Pointer(pose_b)), (*C.cn_distance)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Distance), err
	}
	return out0, nil
}

// PolygonCast: Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a,
// else 0; *out as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).
func PolygonCast(a *Polygon, pose_a *Pose, b *Polygon, pose_b *Pose, translation_x_m float32, translation_y_m float32) (RayHit, int32, error) {
	var out0 RayHit
	var out1 int32
	if err := check(C.cn_polygon_cast((*C.cn_polygon)(unsafe.Pointer(a)), (*C.cn_pose)(unsafe.Pointer(pose_a)), (*C.cn_polygon)(unsafe.Pointer(b)), (*C.cn_pose)(unsafe.Pointer(pose_b)), C.float(translation_x_m), C.float(translation_y_m), (*C.cn_ray_hit)(unsafe.Pointer(&out0)), (*C.int32_t)(unsafe.Pointer(&out1)))); err != nil {
		return *new(RayHit), *new(int32), err
	}
	return out0, out1, nil
}

// PolygonCollide: Contact of two shapes as in a step, with impulses 0: no points if they are farther apart
// than margin_m (0 to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any
// thread. O(points).
func PolygonCollide(a *Polygon, pose_a *Pose, b *Polygon, pose_b *Pose, margin_m float32) (Manifold, error) {
	var out0 Manifold
	if err := check(C.cn_polygon_collide((*C.cn_polygon)(unsafe.Pointer(a)), (*C.cn_pose)(unsafe.Pointer(pose_a)), (*C.cn_polygon)(unsafe.Pointer(b)), (*C.cn_pose)(unsafe.Pointer(pose_b)), C.float(margin_m), (*C.cn_manifold)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Manifold), err
	}
	return out0, nil
}

// PolygonTimeOfImpact: First time at which two moving and turning shapes come within distance_m (0 to 1e6);
// fraction 0 if they start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC
// 2013) never misses a hit. Needs no world; runs in any thread.
func PolygonTimeOfImpact(a *Polygon, sweep_a *Sweep, b *Polygon, sweep_b *Sweep, distance_m float32) (Impact, error) {
	var out0 Impact
	if err := check(C.cn_polygon_time_of_impact((*C.cn_polygon)(unsafe.Pointer(a)), (*C.cn_sweep)(unsafe.Pointer(sweep_a)), (*C.cn_polygon)(unsafe.Pointer(b)), (*C.cn_sweep)(unsafe.Pointer(sweep_b)), C.float(distance_m), (*C.cn_impact)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Impact), err
	}
	return out0, nil
}

// MoverSolve: The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact,
// as in two dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method
// (1957) finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the
// least sum of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes
// below their limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.
func MoverSolve(planes []Plane, translation_x_m float32, translation_y_m float32) (Vec2, float32, error) {
	var out0 Vec2
	var out1 float32
	if err := check(C.cn_mover_solve((*C.cn_plane)(unsafe.Pointer(unsafe.SliceData(planes))), C.int32_t(len(planes)), C.float(translation_x_m), C.float(translation_y_m), (*C.cn_vec2)(unsafe.Pointer(&out0)), (*C.float)(unsafe.Pointer(&out1)))); err != nil {
		return *new(Vec2), *new(float32), err
	}
	return out0, out1, nil
}

// MoverClip: The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the
// last cn_mover_solve. Needs no world. O(count^2).
func MoverClip(planes []Plane, velocity_x_mps float32, velocity_y_mps float32) (Vec2, error) {
	var out0 Vec2
	if err := check(C.cn_mover_clip((*C.cn_plane)(unsafe.Pointer(unsafe.SliceData(planes))), C.int32_t(len(planes)), C.float(velocity_x_mps), C.float(velocity_y_mps), (*C.cn_vec2)(unsafe.Pointer(&out0)))); err != nil {
		return *new(Vec2), err
	}
	return out0, nil
}
