// Cairn for C#: the safe layer. Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//
//     using (var world = new World())
//     {
//         var def = BodyDef.Default;
//         def.PositionM = new Vec2 { X = 0, Y = 4 };
//         Body body = world.BodyCreate(def);
//         world.Step(1f / 60);
//         Pose pose = world.BodyGetPose(body);
//     }
//
// A method is C's function without cn_ and without the world: cn_body_get_pose(world, body, &out) is world.BodyGetPose(body).
// A failed call throws CairnException. An empty span of bodies stands for all bodies. Structs have C's layout; pointers in them are
// private and stay null. Calls need no unsafe; this file and Cairn.cs are compiled with it.
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Cairn
{
	/// <summary>A call that failed; then nothing has changed. The message is the library's sentence.</summary>
	public sealed class CairnException : Exception
	{
		public readonly int Code;

		public CairnException(int code, string message) : base(message)
		{
			Code = code;
		}
	}

	internal static unsafe class Call
	{
		public static void Check(int code, cn_world* world)
		{
			if (code == Native.CN_OK)
				return;
			string text = world != null ? Native.Text(Native.cn_world_error_text(world)) : "";
			throw new CairnException(code, text != "" ? text : Native.Text(Native.cn_result_text(code)));
		}

		public static void Even(int a, int b)
		{
			if (a != b)
				throw new ArgumentException("spans of " + a + " and " + b + " elements");
		}

		public static byte[] Utf8(string text)
		{
			return text == null ? null : System.Text.Encoding.UTF8.GetBytes(text + "\0");
		}

		public static T[] Copy<T>(void* data, int count)
		{
			return new ReadOnlySpan<T>(data, count).ToArray();
		}
	}

	/// <summary>handle of a body; 0: none</summary>
	public enum Body : uint { None = 0 }

	/// <summary>handle of a shape; 0: none</summary>
	public enum Shape : uint { None = 0 }

	/// <summary>handle of a joint; 0: none</summary>
	public enum Joint : uint { None = 0 }

	/// <summary>handle of a constraint on one body; 0: none</summary>
	public enum Constraint : uint { None = 0 }

	/// <summary>A point, vector or pair of numbers.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Vec2
	{
		/// <summary>to the right</summary>
		public float X;
		/// <summary>upwards</summary>
		public float Y;
	}

	/// <summary>Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
	/// uploaded to a GPU directly.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Pose
	{
		/// <summary>of the body's origin</summary>
		public Vec2 PositionM;
		/// <summary>of the angle</summary>
		public float Cosine;
		/// <summary>of the angle</summary>
		public float Sine;
	}

	/// <summary>Velocity of a body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Velocity
	{
		/// <summary>of the centre of mass</summary>
		public Vec2 LinearMps;
		/// <summary>counter-clockwise is positive</summary>
		public float AngularRadps;
	}

	/// <summary>Axis-aligned bounding box, lower_m &lt;= upper_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Aabb
	{
		/// <summary>left and bottom</summary>
		public Vec2 LowerM;
		/// <summary>right and top</summary>
		public Vec2 UpperM;
	}

	/// <summary>Mass, inertia and centre of mass.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct MassData
	{
		/// <summary>of all shapes, or as set</summary>
		public float MassKg;
		/// <summary>about the centre of mass</summary>
		public float InertiaKgm2;
		/// <summary>in the body's local frame</summary>
		public Vec2 CenterM;
	}

	/// <summary>Definition of a world.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct WorldDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS</summary>
		public uint Flags;
		/// <summary>default (0, -10)</summary>
		public Vec2 GravityMps2;
		/// <summary>a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1</summary>
		public float LengthUnitM;
		/// <summary>CN_SOLVER_*; default CN_SOLVER_AUTO</summary>
		public int Solver;
		/// <summary>CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP</summary>
		public int Broadphase;
		/// <summary>1 to 64; default 4</summary>
		public int SubstepCount;
		/// <summary>CN_SOLVER_AUTO aims at errors below this, &gt;= 0; CN_DEFAULT (default): 0.005 x length unit</summary>
		public float AccuracyM;
		/// <summary>limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps
		/// included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with
		/// CN_SOLVER_AUTO 512 contacts of a world</summary>
		public int WorkBudget;
		/// <summary>slower impacts do not bounce, &gt;= 0; CN_DEFAULT (default): 1 x length unit</summary>
		public float RestitutionThresholdMps;
		/// <summary>greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved joint
		/// closes (of its angles: rad/s, for each length unit), &gt; 0; in a crowd the speeds of neighbours add up:
		/// n bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which pushes them
		/// upwards, at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit</summary>
		public float PushSpeedMaxMps;
		/// <summary>faster bodies are slowed to it, &gt; 0; CN_DEFAULT (default): 400 x length unit</summary>
		public float LinearSpeedMaxMps;
		/// <summary>faster bodies are slowed to it, &gt; 0; default 400</summary>
		public float AngularSpeedMaxRadps;
		/// <summary>bodies slower than this may sleep, &gt;= 0; CN_DEFAULT (default): 0.05 x length unit</summary>
		public float SleepSpeedMps;
		/// <summary>... after this time, &gt;= 0; default 0.5</summary>
		public float SleepDelayS;
		/// <summary>hints for a growing world; one in a block has room for these, and for more as memory permits; &gt;= 0;
		/// default 0</summary>
		public int BodyCapacity;
		/// <summary>counts every edge of a chain</summary>
		public int ShapeCapacity;
		/// <summary>pairs whose fat AABBs overlap</summary>
		public int ContactCapacity;
		/// <summary>counts constraints too</summary>
		public int JointCapacity;
		/// <summary>a number for the user; default 0</summary>
		public ulong UserData;
		/// <summary>size of memory; 0: use alloc and free</summary>
		public ulong MemoryBytes;
		/// <summary>NULL, or one block aligned to 64 bytes that holds the whole world</summary>
		internal IntPtr Memory;
		/// <summary>NULL: malloc; set both or none</summary>
		internal IntPtr Alloc;
		/// <summary>NULL: free</summary>
		internal IntPtr Free;
		/// <summary>last argument of alloc and free</summary>
		internal IntPtr AllocatorUser;
		/// <summary>NULL: the world's own threads; set both or none</summary>
		internal IntPtr Enqueue;
		/// <summary>see cn_finish_fn</summary>
		internal IntPtr Finish;
		/// <summary>last argument of enqueue and finish</summary>
		internal IntPtr TaskUser;
		/// <summary>threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no
		/// tasks</summary>
		public int WorkerCount;
		/// <summary>blows at least this fast are reported by CN_EVENT_HIT, &gt;= 0; CN_DEFAULT (default): 1 x length unit</summary>
		public float HitSpeedMps;
		/// <summary>Of a world in one block (memory); others ignore them. pairs that touch at once, &gt;= 0; further ones do
		/// not collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity</summary>
		public int TouchingCapacity;
		/// <summary>pairs that report events (event_mask of a shape, sensors), &gt;= 0; further ones report none, which
		/// cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity</summary>
		public int EventCapacity;
		/// <summary>vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block; default
		/// CN_POLYGON_MAX_VERTICES</summary>
		public int VertexCapacity;
		/// <summary>CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all</summary>
		public uint Reserve;

		/// <summary>The defaults of the fields.</summary>
		public static WorldDef Default
		{
			get
			{
				WorldDef value;
				Native.cn_world_def_init((cn_world_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Counts of objects, and problems of the last step.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Counters
	{
		/// <summary>alive</summary>
		public int Bodies;
		/// <summary>dynamic and kinematic bodies that are simulated</summary>
		public int BodiesAwake;
		/// <summary>alive</summary>
		public int Shapes;
		/// <summary>boxes in the broadphase: one per shape, one per edge of a chain</summary>
		public int Proxies;
		/// <summary>pairs whose fat boxes overlap</summary>
		public int Contacts;
		/// <summary>with an awake body</summary>
		public int ContactsAwake;
		/// <summary>pairs with a manifold, asleep or awake</summary>
		public int ContactsTouching;
		/// <summary>and constraints</summary>
		public int Joints;
		/// <summary>and constraints, with an awake body</summary>
		public int JointsAwake;
		/// <summary>awake and asleep; a single dynamic body counts</summary>
		public int Islands;
		/// <summary>of them</summary>
		public int IslandsAwake;
		/// <summary>groups of contacts that share no dynamic body</summary>
		public int ColorsUsed;
		/// <summary>contacts that fit no colour: solved one by one</summary>
		public int OverflowContacts;
		/// <summary>cells of the broadphase</summary>
		public int BroadphaseTiles;
		/// <summary>steps taken since creation, modulo 2^32</summary>
		public uint Steps;
		/// <summary>Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try again.
		/// CN_WARNING_*</summary>
		public uint Warnings;
		/// <summary>new pairs without a contact</summary>
		public int PairsNotAdded;
		/// <summary>events without a place in a log</summary>
		public int EventsNotReported;
		/// <summary>of several bodies, solved directly in the last step, contacts included</summary>
		public int IslandsDirect;
		/// <summary>planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1</summary>
		public int DirectWork;
		/// <summary>of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET</summary>
		public int IslandsUnsolved;
	}

	/// <summary>Report on one island.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct IslandReport
	{
		/// <summary>its body of least slot</summary>
		public Body Body;
		/// <summary>dynamic</summary>
		public int Bodies;
		/// <summary>touching</summary>
		public int Contacts;
		/// <summary>and constraints</summary>
		public int Joints;
		/// <summary>CN_TIER_*, after the last step</summary>
		public int Tier;
		/// <summary>CN_TIER_REASON_*</summary>
		public int Reason;
		/// <summary>of the last step with dt &gt; 0: the world's, or 1 at rest; freely swinging joints may take more</summary>
		public int Substeps;
		/// <summary>at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints
		/// that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count</summary>
		public float ResidualM;
	}

	/// <summary>Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Profile
	{
		/// <summary>the whole step</summary>
		public float StepS;
		/// <summary>waking</summary>
		public float WakeS;
		/// <summary>pairs</summary>
		public float BroadphaseS;
		/// <summary>manifolds</summary>
		public float NarrowphaseS;
		/// <summary>islands</summary>
		public float IslandsS;
		/// <summary>constraints, plans</summary>
		public float PrepareS;
		/// <summary>all substeps</summary>
		public float SubstepsS;
		/// <summary>poses and boxes</summary>
		public float FinalizeS;
		/// <summary>callbacks</summary>
		public float EventsS;
		/// <summary>falling asleep</summary>
		public float SleepS;
	}

	/// <summary>Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block
	/// allocator serves small variable-size pieces from free lists of size classes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct MemoryStats
	{
		/// <summary>taken from the user's allocator or carved from the fixed block</summary>
		public ulong BytesInUse;
		/// <summary>most bytes_in_use since creation</summary>
		public ulong BytesPeak;
		/// <summary>calls of the user's alloc (or of the fixed block's) since creation</summary>
		public ulong AllocatorCalls;
		/// <summary>of the frame arena</summary>
		public ulong ArenaCapacity;
		/// <summary>most bytes in use at once since creation</summary>
		public ulong ArenaPeak;
		/// <summary>entries that did not fit: the allocator served them; since creation</summary>
		public ulong ArenaFallbacks;
		/// <summary>bytes in chunks</summary>
		public ulong BlocksCapacity;
		/// <summary>bytes handed out of them</summary>
		public ulong BlocksInUse;
		/// <summary>blocks above the largest class, served by the allocator</summary>
		public ulong BlocksLarge;
	}

	/// <summary>Definition of a body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct BodyDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic</summary>
		public int Type;
		/// <summary>of the origin; |x|, |y| &lt;= 1e6 x length unit</summary>
		public Vec2 PositionM;
		/// <summary>|angle| &lt;= 1e4</summary>
		public float AngleRad;
		/// <summary>of the centre of mass; both velocities are ignored without CN_BODY_AWAKE</summary>
		public Vec2 LinearVelocityMps;
		/// <summary>default 0</summary>
		public float AngularVelocityRadps;
		/// <summary>v' = -damping v; &gt;= 0, default 0</summary>
		public float LinearDampingPerS;
		/// <summary>&gt;= 0, default 0</summary>
		public float AngularDampingPerS;
		/// <summary>default 1</summary>
		public float GravityScale;
		/// <summary>&gt;= 0; CN_DEFAULT (default): the world's</summary>
		public float SleepSpeedMps;
		/// <summary>CN_BODY_*; default ENABLED | SLEEP | AWAKE</summary>
		public uint Flags;
		/// <summary>as in cn_body_set_solver; default CN_SOLVER_AUTO</summary>
		public int Solver;
		/// <summary>a number for the user; default 0</summary>
		public ulong UserData;
		/// <summary>NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied</summary>
		internal IntPtr Name;

		/// <summary>The defaults of the fields.</summary>
		public static BodyDef Default
		{
			get
			{
				BodyDef value;
				Native.cn_body_def_init((cn_body_def*)&value);
				return value;
			}
		}
	}

	/// <summary>A body that moved or fell asleep in the last step.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct BodyMoved
	{
		/// <summary>after the step</summary>
		public Pose Pose;
		/// <summary>the body's</summary>
		public ulong UserData;
		/// <summary>that moved</summary>
		public Body Body;
		/// <summary>1 in the step in which it fell asleep</summary>
		public uint FellAsleep;
	}

	/// <summary>Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
	/// collide if the category of each has a bit in the mask of the other.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Filter
	{
		/// <summary>default 1</summary>
		public ulong Category;
		/// <summary>default all ones</summary>
		public ulong Mask;
		/// <summary>default 0</summary>
		public int Group;
		/// <summary>0</summary>
		public uint Reserved;
	}

	/// <summary>Surface of a shape.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Material
	{
		/// <summary>coefficient while sticking, [0, 100], default 0.6</summary>
		public float StaticFriction;
		/// <summary>coefficient while sliding, [0, static_friction], default 0.6</summary>
		public float DynamicFriction;
		/// <summary>[0, 1], default 0</summary>
		public float Restitution;
		/// <summary>metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0</summary>
		public float RollingResistance;
		/// <summary>conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0</summary>
		public float TangentSpeedMps;
		/// <summary>CN_MIX_*; default CN_MIX_GEOMETRIC</summary>
		public int FrictionMix;
		/// <summary>CN_MIX_*; default CN_MIX_MAXIMUM</summary>
		public int RestitutionMix;
		/// <summary>a number for the user, reported in contact events; default 0</summary>
		public uint UserId;
	}

	/// <summary>Definition of a shape.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct ShapeDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>0: create unattached, for cn_shape_attach</summary>
		public Body Body;
		/// <summary>of the shape in the body's local frame</summary>
		public Vec2 OffsetM;
		/// <summary>of the shape in the body's local frame</summary>
		public float AngleRad;
		/// <summary>&gt;= 0, giving 0 or 1e-20 to 1e20 kg; default 1</summary>
		public float DensityKgpm2;
		/// <summary>defaults: see cn_material</summary>
		public Material Material;
		/// <summary>defaults: see cn_filter</summary>
		public Filter Filter;
		/// <summary>bits 1 &lt;&lt; CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE</summary>
		public uint EventMask;
		/// <summary>CN_SHAPE_SENSOR ...; default 0</summary>
		public uint Flags;
		/// <summary>a number for the user; default 0</summary>
		public ulong UserData;

		/// <summary>The defaults of the fields.</summary>
		public static ShapeDef Default
		{
			get
			{
				ShapeDef value;
				Native.cn_shape_def_init((cn_shape_def*)&value);
				return value;
			}
		}
	}

	/// <summary>A disc.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Circle
	{
		/// <summary>in the body's frame</summary>
		public Vec2 CenterM;
		/// <summary>&gt; 0</summary>
		public float RadiusM;
	}

	/// <summary>All points within radius_m of the segment.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Capsule
	{
		/// <summary>one end of the segment, in the body's frame</summary>
		public Vec2 AM;
		/// <summary>the other end</summary>
		public Vec2 BM;
		/// <summary>around the segment, &gt; 0</summary>
		public float RadiusM;
	}

	/// <summary>A two-sided segment without mass.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Edge
	{
		/// <summary>one end, in the body's frame</summary>
		public Vec2 AM;
		/// <summary>the other end</summary>
		public Vec2 BM;
	}

	/// <summary>Convex polygon. Either winding is accepted; points are stored counter-clockwise.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Polygon
	{
		/// <summary>3 to CN_POLYGON_MAX_VERTICES</summary>
		public int Count;
		/// <summary>rounding added outside the points, &gt;= 0</summary>
		public float RadiusM;
		/// <summary>the first count of them; in the body's frame</summary>
		public Vec2Array16 PointsM;
	}

	/// <summary>One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is
	/// on the left of the order of points and surface normals point to the right: points that run from +x to -x
	/// collide from above, a counter-clockwise loop collides from outside.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Chain
	{
		/// <summary>copied</summary>
		internal IntPtr PointsM;
		/// <summary>an open chain: &gt;= 2; a loop: &gt;= 3; at most 65535</summary>
		public int Count;
		/// <summary>1: the last point joins the first</summary>
		public uint Loop;
	}

	/// <summary>One point of a contact.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct ManifoldPoint
	{
		/// <summary>world, midway between the surfaces</summary>
		public Vec2 PointM;
		/// <summary>negative when overlapping</summary>
		public float SeparationM;
		/// <summary>of the last substep</summary>
		public float NormalImpulseNs;
		/// <summary>the same while the same features touch</summary>
		public uint FeatureId;
	}

	/// <summary>How two shapes touch.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Manifold
	{
		/// <summary>unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the faces'
		/// by up to 0.1 rad, so that piles stand</summary>
		public Vec2 Normal;
		/// <summary>of the last substep, on body b along (normal.y, -normal.x)</summary>
		public float FrictionImpulseNs;
		/// <summary>0, 1 or 2</summary>
		public int PointCount;
		/// <summary>the first point_count of them</summary>
		public ManifoldPointArray2 Points;
	}

	/// <summary>A contact event, or the present state of a contact.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct ContactEvent
	{
		/// <summary>one shape of the pair</summary>
		public Shape ShapeA;
		/// <summary>the other</summary>
		public Shape ShapeB;
		/// <summary>of shape_a</summary>
		public Body BodyA;
		/// <summary>of shape_b</summary>
		public Body BodyB;
		/// <summary>edge number within a chain, else 0</summary>
		public int ChildA;
		/// <summary>the same of shape b</summary>
		public int ChildB;
		/// <summary>the same from CREATED to DESTROYED, then reused</summary>
		public uint ContactId;
		/// <summary>CN_EVENT_*</summary>
		public int Kind;
		/// <summary>ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0</summary>
		public float ApproachSpeedMps;
		/// <summary>geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT</summary>
		public Manifold Manifold;
		/// <summary>Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of
		/// cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact that
		/// its shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean force
		/// is normal_impulse_Ns / dt_s</summary>
		public float NormalImpulseNs;
		/// <summary>along (normal.y, -normal.x), on body b</summary>
		public float FrictionImpulseNs;
		/// <summary>HIT: where, in the world; else (0, 0)</summary>
		public Vec2 HitPointM;
		/// <summary>cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED</summary>
		public uint MaterialA;
		/// <summary>the same of shape_b</summary>
		public uint MaterialB;
	}

	/// <summary>A shape entered or left a sensor.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct SensorEvent
	{
		/// <summary>the sensor</summary>
		public Shape Sensor;
		/// <summary>the shape that it met</summary>
		public Shape Visitor;
		/// <summary>the sensor's body</summary>
		public Body SensorBody;
		/// <summary>the visitor's body</summary>
		public Body VisitorBody;
		/// <summary>CN_EVENT_ENTER or CN_EVENT_LEAVE</summary>
		public int Kind;
		/// <summary>0</summary>
		public uint Reserved;
	}

	/// <summary>First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and
	/// limits in place; springs and motors are not rigid parts.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct JointBase
	{
		/// <summary>of the whole definition</summary>
		public uint StructSize;
		/// <summary>CN_JOINT_*; default 0; a type ignores flags that it does not use</summary>
		public uint Flags;
		/// <summary>0: the world</summary>
		public Body BodyA;
		/// <summary>0: the world; one of the two must be dynamic</summary>
		public Body BodyB;
		/// <summary>in body a's local frame, or in world coordinates</summary>
		public Vec2 AnchorAM;
		/// <summary>the same for body b</summary>
		public Vec2 AnchorBM;
		/// <summary>of the rigid parts, &gt; 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of
		/// all springs; CN_DEFAULT (default): as stiff as the substeps permit</summary>
		public float StiffnessHertz;
		/// <summary>used with a stiffness_hertz; 0 to 1e6, default 0</summary>
		public float StiffnessDampingRatio;
		/// <summary>greatest force of each: anchor, axis, limit; &gt; 0; CN_DEFAULT (default): unbounded</summary>
		public float ForceMaxN;
		/// <summary>greatest torque of angles, &gt; 0; CN_DEFAULT (default): unbounded</summary>
		public float TorqueMaxNm;
		/// <summary>a reaction above this in any substep is reported (cn_world_joint_events), &gt; 0; CN_DEFAULT (default):
		/// never</summary>
		public float BreakForceN;
		/// <summary>the same for the torque</summary>
		public float BreakTorqueNm;
		/// <summary>a number for the user; default 0</summary>
		public ulong UserData;
	}

	/// <summary>Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct RevoluteDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>angle b - angle a at joint angle 0</summary>
		public float ReferenceAngleRad;
		/// <summary>CN_JOINT_LIMIT: -pi &lt;= lower &lt;= upper &lt;= pi</summary>
		public float LowerAngleRad;
		/// <summary>the upper limit</summary>
		public float UpperAngleRad;
		/// <summary>CN_JOINT_MOTOR</summary>
		public float MotorSpeedRadps;
		/// <summary>&gt;= 0</summary>
		public float MotorTorqueMaxNm;
		/// <summary>CN_JOINT_SPRING: pulls the joint angle to this</summary>
		public float SpringTargetRad;
		/// <summary>0 to 1e6</summary>
		public float SpringHertz;
		/// <summary>0 to 1e6</summary>
		public float SpringDampingRatio;

		/// <summary>The defaults of the fields.</summary>
		public static RevoluteDef Default
		{
			get
			{
				RevoluteDef value;
				Native.cn_revolute_def_init((cn_revolute_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
	/// length_m. With a spring, length_m is its rest length, and limits keep the distance within [min, max];
	/// limits alone make a rope (min 0).</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct DistanceDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>&gt; 0; default 1</summary>
		public float LengthM;
		/// <summary>CN_JOINT_LIMIT: 0 &lt;= min &lt;= max; default 0 and 1</summary>
		public float LengthMinM;
		/// <summary>the upper limit</summary>
		public float LengthMaxM;
		/// <summary>CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only</summary>
		public float MotorSpeedMps;
		/// <summary>&gt;= 0</summary>
		public float MotorForceMaxN;
		/// <summary>0 to 1e6</summary>
		public float SpringHertz;
		/// <summary>0 to 1e6</summary>
		public float SpringDampingRatio;
		/// <summary>0</summary>
		public float Reserved;

		/// <summary>The defaults of the fields.</summary>
		public static DistanceDef Default
		{
			get
			{
				DistanceDef value;
				Native.cn_distance_def_init((cn_distance_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct FixedDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>angle b - angle a</summary>
		public float ReferenceAngleRad;
		/// <summary>stiffness of the angle alone, &gt; 0, to 1e6; CN_DEFAULT (default): the base's</summary>
		public float AngularHertz;
		/// <summary>0 to 1e6</summary>
		public float AngularDampingRatio;
		/// <summary>0</summary>
		public float Reserved;

		/// <summary>The defaults of the fields.</summary>
		public static FixedDef Default
		{
			get
			{
				FixedDef value;
				Native.cn_fixed_def_init((cn_fixed_def*)&value);
				return value;
			}
		}
	}

	/// <summary>b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct PrismaticDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>in body a's frame, any length &gt; 0 (read back with length 1); default (1, 0)</summary>
		public Vec2 Axis;
		/// <summary>angle b - angle a</summary>
		public float ReferenceAngleRad;
		/// <summary>CN_JOINT_LIMIT: lower &lt;= upper</summary>
		public float LowerM;
		/// <summary>the upper limit</summary>
		public float UpperM;
		/// <summary>CN_JOINT_MOTOR</summary>
		public float MotorSpeedMps;
		/// <summary>&gt;= 0</summary>
		public float MotorForceMaxN;
		/// <summary>CN_JOINT_SPRING: pulls the translation to this</summary>
		public float SpringTargetM;
		/// <summary>0 to 1e6</summary>
		public float SpringHertz;
		/// <summary>0 to 1e6</summary>
		public float SpringDampingRatio;

		/// <summary>The defaults of the fields.</summary>
		public static PrismaticDef Default
		{
			get
			{
				PrismaticDef value;
				Native.cn_prismatic_def_init((cn_prismatic_def*)&value);
				return value;
			}
		}
	}

	/// <summary>A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
	/// by the motor.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct WheelDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>in body a's frame, any length &gt; 0 (read back with length 1); default (0, 1)</summary>
		public Vec2 Axis;
		/// <summary>CN_JOINT_LIMIT: lower &lt;= upper</summary>
		public float LowerM;
		/// <summary>the upper limit</summary>
		public float UpperM;
		/// <summary>CN_JOINT_MOTOR</summary>
		public float MotorSpeedRadps;
		/// <summary>&gt;= 0</summary>
		public float MotorTorqueMaxNm;
		/// <summary>CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1</summary>
		public float SpringHertz;
		/// <summary>0 to 1e6, default 0.7</summary>
		public float SpringDampingRatio;

		/// <summary>The defaults of the fields.</summary>
		public static WheelDef Default
		{
			get
			{
				WheelDef value;
				Native.cn_wheel_def_init((cn_wheel_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
	/// base.torque_max_Nm must be &gt; 0.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct MotorDef
	{
		/// <summary>anchor b is driven to anchor a + offset</summary>
		public JointBase Base;
		/// <summary>in body a's frame</summary>
		public Vec2 OffsetM;
		/// <summary>angle b - angle a</summary>
		public float AngleRad;
		/// <summary>frequency of the spring, &gt; 0, to 1e6; default 5</summary>
		public float Hertz;
		/// <summary>0 to 1e6, default 1</summary>
		public float DampingRatio;
		/// <summary>0</summary>
		public float Reserved;

		/// <summary>The defaults of the fields.</summary>
		public static MotorDef Default
		{
			get
			{
				MotorDef value;
				Native.cn_motor_def_init((cn_motor_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
	/// base.force_max_N must be &gt; 0.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct MouseDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>world</summary>
		public Vec2 TargetM;
		/// <summary>&gt; 0, to 1e6; default 5</summary>
		public float Hertz;
		/// <summary>0 to 1e6, default 0.7</summary>
		public float DampingRatio;

		/// <summary>The defaults of the fields.</summary>
		public static MouseDef Default
		{
			get
			{
				MouseDef value;
				Native.cn_mouse_def_init((cn_mouse_def*)&value);
				return value;
			}
		}
	}

	/// <summary>angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
	/// and count whole turns from there.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct GearDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>size 1e-4 to 1e4, negative: they turn against each other; default 1</summary>
		public float Ratio;
		/// <summary>default 0</summary>
		public float PhaseRad;

		/// <summary>The defaults of the fields.</summary>
		public static GearDef Default
		{
			get
			{
				GearDef value;
				Native.cn_gear_def_init((cn_gear_def*)&value);
				return value;
			}
		}
	}

	/// <summary>A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| &lt;= length. It pulls and
	/// never pushes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct PulleyDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>world</summary>
		public Vec2 GroundAM;
		/// <summary>world</summary>
		public Vec2 GroundBM;
		/// <summary>1e-4 to 1e4; default 1</summary>
		public float Ratio;
		/// <summary>&gt; 0: must be set</summary>
		public float LengthM;

		/// <summary>The defaults of the fields.</summary>
		public static PulleyDef Default
		{
			get
			{
				PulleyDef value;
				Native.cn_pulley_def_init((cn_pulley_def*)&value);
				return value;
			}
		}
	}

	/// <summary>b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at
	/// phase + n * click_rad for every whole number n, over whole turns.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct RatchetDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>default 0</summary>
		public float PhaseRad;
		/// <summary>size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise</summary>
		public float ClickRad;

		/// <summary>The defaults of the fields.</summary>
		public static RatchetDef Default
		{
			get
			{
				RatchetDef value;
				Native.cn_ratchet_def_init((cn_ratchet_def*)&value);
				return value;
			}
		}
	}

	/// <summary>A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
	/// the two bodies.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct RotarySpringDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>default 0</summary>
		public float RestAngleRad;
		/// <summary>&gt; 0, to 1e6; default 1</summary>
		public float Hertz;
		/// <summary>0 to 1e6, default 0</summary>
		public float DampingRatio;
		/// <summary>0</summary>
		public float Reserved;

		/// <summary>The defaults of the fields.</summary>
		public static RotarySpringDef Default
		{
			get
			{
				RotarySpringDef value;
				Native.cn_rotary_spring_def_init((cn_rotary_spring_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Anchor b slides in a slot of body a from anchor a to end_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct GrooveDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;
		/// <summary>in body a's frame; not equal to anchor a; default (1, 0)</summary>
		public Vec2 EndM;

		/// <summary>The defaults of the fields.</summary>
		public static GrooveDef Default
		{
			get
			{
				GrooveDef value;
				Native.cn_groove_def_init((cn_groove_def*)&value);
				return value;
			}
		}
	}

	/// <summary>The two bodies do not collide; no other effect.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct FilterJointDef
	{
		/// <summary>what every joint has</summary>
		public JointBase Base;

		/// <summary>The defaults of the fields.</summary>
		public static FilterJointDef Default
		{
			get
			{
				FilterJointDef value;
				Native.cn_filter_joint_def_init((cn_filter_joint_def*)&value);
				return value;
			}
		}
	}

	/// <summary>A joint or constraint exceeded a break threshold or was destroyed with a body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct JointEvent
	{
		/// <summary>0: it was a constraint; stale when destroyed is 1</summary>
		public Joint Joint;
		/// <summary>0: it was a joint; stale when destroyed is 1</summary>
		public Constraint Constraint;
		/// <summary>0: the world</summary>
		public Body BodyA;
		/// <summary>0: the world</summary>
		public Body BodyB;
		/// <summary>largest reaction of the step; 0 when a body was destroyed</summary>
		public float ForceN;
		/// <summary>the same for the torque</summary>
		public float TorqueNm;
		/// <summary>1: it broke, or one of its bodies was destroyed</summary>
		public uint Destroyed;
		/// <summary>0</summary>
		public uint Reserved;
		/// <summary>the joint's or constraint's</summary>
		public ulong UserData;
	}

	/// <summary>Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
	/// there.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct AngleConstraintDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_CONSTRAINT_*; default 0</summary>
		public uint Flags;
		/// <summary>must be dynamic</summary>
		public Body Body;
		/// <summary>lower &lt;= upper; equal: locked</summary>
		public float LowerRad;
		/// <summary>the upper limit</summary>
		public float UpperRad;
		/// <summary>&gt; 0, to 1e6; CN_DEFAULT (default): rigid</summary>
		public float Hertz;
		/// <summary>used with a hertz; 0 to 1e6</summary>
		public float DampingRatio;
		/// <summary>a reaction above this is reported (cn_world_joint_events), &gt; 0; CN_DEFAULT (default): never</summary>
		public float BreakTorqueNm;
		/// <summary>a number for the user; default 0</summary>
		public ulong UserData;

		/// <summary>The defaults of the fields.</summary>
		public static AngleConstraintDef Default
		{
			get
			{
				AngleConstraintDef value;
				Native.cn_angle_constraint_def_init((cn_angle_constraint_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits
	/// along the line.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct LineConstraintDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_CONSTRAINT_*; default 0</summary>
		public uint Flags;
		/// <summary>must be dynamic</summary>
		public Body Body;
		/// <summary>in the body's frame</summary>
		public Vec2 AnchorM;
		/// <summary>of the line, world</summary>
		public Vec2 OriginM;
		/// <summary>world, any length &gt; 0 (read back with length 1); default (1, 0)</summary>
		public Vec2 Axis;
		/// <summary>&gt;= 0: free play across the axis</summary>
		public float ToleranceM;
		/// <summary>CN_CONSTRAINT_LIMIT: along the axis from origin; lower &lt;= upper</summary>
		public float LowerM;
		/// <summary>the upper limit</summary>
		public float UpperM;
		/// <summary>&gt; 0, to 1e6; CN_DEFAULT (default): rigid</summary>
		public float Hertz;
		/// <summary>used with a hertz; 0 to 1e6</summary>
		public float DampingRatio;
		/// <summary>a reaction above this is reported (cn_world_joint_events), &gt; 0; CN_DEFAULT (default): never</summary>
		public float BreakForceN;
		/// <summary>0</summary>
		public uint Reserved;
		/// <summary>a number for the user; default 0</summary>
		public ulong UserData;

		/// <summary>The defaults of the fields.</summary>
		public static LineConstraintDef Default
		{
			get
			{
				LineConstraintDef value;
				Native.cn_line_constraint_def_init((cn_line_constraint_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Result of cn_world_update.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct UpdateReport
	{
		/// <summary>fixed steps taken</summary>
		public int Steps;
		/// <summary>time kept for the next update</summary>
		public float LeftoverS;
		/// <summary>time discarded because of steps_max</summary>
		public float DroppedS;
		/// <summary>leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated</summary>
		public float Interpolation;
	}

	/// <summary>A ray with an end.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Ray
	{
		/// <summary>world</summary>
		public Vec2 OriginM;
		/// <summary>at most 2e6 length units each way; 0 hits only shapes around the origin</summary>
		public Vec2 TranslationM;
	}

	/// <summary>What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that
	/// shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up to a
	/// depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct RayHit
	{
		/// <summary>0: nothing was hit</summary>
		public Shape Shape;
		/// <summary>the shape's</summary>
		public Body Body;
		/// <summary>edge of a chain</summary>
		public int Child;
		/// <summary>of the translation, [0, 1]; 1 when nothing was hit</summary>
		public float Fraction;
		/// <summary>on the surface of the shape that was hit</summary>
		public Vec2 PointM;
		/// <summary>unit, out of the shape that was hit</summary>
		public Vec2 Normal;
		/// <summary>depth of the start inside it, 0 outside</summary>
		public float DepthM;
		/// <summary>0</summary>
		public uint Reserved;
	}

	/// <summary>Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
	/// bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between
	/// steps.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct QueryFilter
	{
		/// <summary>default 1</summary>
		public ulong Category;
		/// <summary>default all ones</summary>
		public ulong Mask;
		/// <summary>its shapes are ignored; 0 (default): none. A stale handle is an error</summary>
		public Body IgnoredBody;
		/// <summary>CN_QUERY_IGNORE_JOINED ...; default 0</summary>
		public uint Flags;
		/// <summary>NULL (default): take all shapes</summary>
		internal IntPtr Visit;
		/// <summary>last argument of visit</summary>
		internal IntPtr User;

		/// <summary>The defaults of the fields.</summary>
		public static QueryFilter Default
		{
			get
			{
				QueryFilter value;
				Native.cn_query_filter_init((cn_query_filter*)&value);
				return value;
			}
		}
	}

	/// <summary>The shape nearest to a point.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Closest
	{
		/// <summary>0: nothing within the distance</summary>
		public Shape Shape;
		/// <summary>the shape's</summary>
		public Body Body;
		/// <summary>edge of a chain</summary>
		public int Child;
		/// <summary>negative: depth inside a shape with area</summary>
		public float DistanceM;
		/// <summary>on the surface</summary>
		public Vec2 PointM;
		/// <summary>outward there; of edges and chains towards the point</summary>
		public Vec2 Normal;
	}

	/// <summary>Distance of two shapes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Distance
	{
		/// <summary>on the surface of a, in the world</summary>
		public Vec2 PointAM;
		/// <summary>on the surface of b</summary>
		public Vec2 PointBM;
		/// <summary>unit, from a to b</summary>
		public Vec2 Normal;
		/// <summary>of the surfaces; negative: the depth, the shortest translation of b out of a</summary>
		public float DistanceM;
		/// <summary>0</summary>
		public uint Reserved;
	}

	/// <summary>A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about
	/// it at a constant rate.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Sweep
	{
		/// <summary>of the shape, before the motion</summary>
		public Pose Start;
		/// <summary>that point, in the shape's frame: the centre of mass of a body</summary>
		public Vec2 CenterM;
		/// <summary>of it; at most 2e6 m each way</summary>
		public Vec2 TranslationM;
		/// <summary>counter-clockwise, |turn| &lt;= 1e4</summary>
		public float TurnRad;
		/// <summary>0</summary>
		public uint Reserved;
	}

	/// <summary>Result of cn_polygon_time_of_impact.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Impact
	{
		/// <summary>CN_IMPACT_*</summary>
		public int State;
		/// <summary>of both motions, [0, 1]</summary>
		public float Fraction;
		/// <summary>HIT only, as are the next two: between the surfaces</summary>
		public Vec2 PointM;
		/// <summary>unit, from a to b</summary>
		public Vec2 Normal;
		/// <summary>of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it</summary>
		public float DistanceM;
		/// <summary>0</summary>
		public uint Reserved;
	}

	/// <summary>A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t &gt;= 0,
	/// unless that needs a push of more than push_max_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Plane
	{
		/// <summary>unit, from the surface to the shape</summary>
		public Vec2 Normal;
		/// <summary>world point of least distance</summary>
		public Vec2 PointM;
		/// <summary>of the surfaces along the normal; negative: they overlap</summary>
		public float SeparationM;
		/// <summary>greatest push of this plane, &gt;= 0; FLT_MAX: rigid</summary>
		public float PushMaxM;
		/// <summary>its push in the last cn_mover_solve</summary>
		public float PushM;
		/// <summary>whose surface it is</summary>
		public Shape Shape;
		/// <summary>the shape's</summary>
		public Body Body;
		/// <summary>edge of a chain</summary>
		public int Child;
	}

	/// <summary>How a character moves. It may change between moves: crouching is another shape.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct MoverDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_MOVER_DROP; default 0</summary>
		public uint Flags;
		/// <summary>around its position, never turned; 1 or 2 points with radius &gt; 0: circle, capsule. Default: a capsule
		/// of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly</summary>
		public Polygon Shape;
		/// <summary>shapes that it collides with; sensors never, one-way shapes from above</summary>
		public QueryFilter Filter;
		/// <summary>any length &gt; 0; default (0, 1)</summary>
		public Vec2 Up;
		/// <summary>greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees)</summary>
		public float SlopeLimitRad;
		/// <summary>greatest height of steps that it climbs, &gt;= 0; default 0.3</summary>
		public float StepHeightM;
		/// <summary>a walking character follows ground that falls by up to this in a move, &gt;= 0; default 0.3</summary>
		public float SnapM;
		/// <summary>of the world's gravity in the air; default 1</summary>
		public float GravityScale;
		/// <summary>greatest push on a dynamic body, &gt;= 0; default 200</summary>
		public float PushForceN;
		/// <summary>of sliding, 1 to 64; default 8</summary>
		public int IterationsMax;

		/// <summary>The defaults of the fields.</summary>
		public static MoverDef Default
		{
			get
			{
				MoverDef value;
				Native.cn_mover_def_init((cn_mover_def*)&value);
				return value;
			}
		}
	}

	/// <summary>State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The
	/// world does not know it, and bodies do not collide with it: for that give it a kinematic body that is
	/// filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the
	/// position.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Mover
	{
		/// <summary>of the shape's origin, world</summary>
		public Vec2 PositionM;
		/// <summary>in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its
		/// component across up; the one along up is 0, and a jump when the caller makes it &gt; 0</summary>
		public Vec2 VelocityMps;
		/// <summary>of the ground with CN_MOVER_ON_GROUND, else (0, 0)</summary>
		public Vec2 GroundNormal;
		/// <summary>in the world, after the move</summary>
		public Vec2 GroundPointM;
		/// <summary>... in the frame of ground_body</summary>
		public Vec2 GroundLocalM;
		/// <summary>of the ground there</summary>
		public Vec2 GroundVelocityMps;
		/// <summary>0: none; a stale handle counts as none</summary>
		public Body GroundBody;
		/// <summary>the same for its shape</summary>
		public Shape GroundShape;
		/// <summary>CN_MOVER_ON_*, after the last move</summary>
		public uint Flags;
		/// <summary>overlap with surfaces that leave it no room; else 0 up to rounding</summary>
		public float SqueezedM;
	}

	/// <summary>What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without
	/// gravity. Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes;
	/// their accelerations, damping and forces add up.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct AreaDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_AREA_REPLACE; default 0</summary>
		public uint Flags;
		/// <summary>default 0</summary>
		public int Priority;
		/// <summary>acceleration in the axes of the world, times the body's gravity_scale; default (0, 0)</summary>
		public Vec2 GravityMps2;
		/// <summary>of pull_mps2, in the frame of the sensor's body; default (0, 0)</summary>
		public Vec2 CenterM;
		/// <summary>acceleration towards center_m; negative pushes; default 0</summary>
		public float PullMps2;
		/// <summary>CN_DEFAULT (default): pull_mps2 at every distance; &gt; 0, to 1e6 length units: at this distance, with
		/// its inverse square outside, and falling to 0 at the centre: a homogeneous planet</summary>
		public float PullDistanceM;
		/// <summary>of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with
		/// density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0</summary>
		public float LinearDampingPerS;
		/// <summary>... of the rotation; 0 to 1e9, default 0</summary>
		public float AngularDampingPerS;
		/// <summary>of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default 0</summary>
		public float DensityKgpm2;
		/// <summary>density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0</summary>
		public float DragKgpm2;
		/// <summary>density times lift coefficient; 0 to 1e9, default 0</summary>
		public float LiftKgpm2;
		/// <summary>velocity of the medium relative to the sensor, in the axes of the world; default (0, 0)</summary>
		public Vec2 FlowMps;

		/// <summary>The defaults of the fields.</summary>
		public static AreaDef Default
		{
			get
			{
				AreaDef value;
				Native.cn_area_def_init((cn_area_def*)&value);
				return value;
			}
		}
	}

	/// <summary>Definition of an explosion.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct ExplosionDef
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1</summary>
		public float RadiusM;
		/// <summary>then linearly to 0 over this distance, 0 to 1e6 length units; default 0</summary>
		public float FalloffM;
		/// <summary>per metre of the shape's width seen from the centre; negative pulls; default 0</summary>
		public float ImpulseNspm;
		/// <summary>world</summary>
		public Vec2 CenterM;
		/// <summary>which shapes; defaults: see cn_query_filter</summary>
		public QueryFilter Filter;

		/// <summary>The defaults of the fields.</summary>
		public static ExplosionDef Default
		{
			get
			{
				ExplosionDef value;
				Native.cn_explosion_def_init((cn_explosion_def*)&value);
				return value;
			}
		}
	}

	/// <summary>The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
	/// coordinates.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct DebugDraw
	{
		/// <summary>set by the init function</summary>
		public uint StructSize;
		/// <summary>CN_DRAW_*; default SHAPES | JOINTS | CONTACTS</summary>
		public uint Flags;
		/// <summary>things outside are not drawn; default everything</summary>
		public Aabb View;
		/// <summary>count points, counter-clockwise</summary>
		internal IntPtr Polygon;
		/// <summary>rim_m: a point on the rim that turns with the body</summary>
		internal IntPtr Circle;
		/// <summary>a disc swept from a to b</summary>
		internal IntPtr Capsule;
		/// <summary>a line from a to b</summary>
		internal IntPtr Segment;
		/// <summary>size in pixels</summary>
		internal IntPtr Point;
		/// <summary>zero-terminated, valid during the call</summary>
		internal IntPtr Text;
		/// <summary>last argument of the functions</summary>
		internal IntPtr User;
		/// <summary>0</summary>
		internal IntPtr Reserved;

		/// <summary>The defaults of the fields.</summary>
		public static DebugDraw Default
		{
			get
			{
				DebugDraw value;
				Native.cn_debug_draw_init((cn_debug_draw*)&value);
				return value;
			}
		}
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct Vec2Array16
	{
		public Vec2 e0, e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11, e12, e13, e14, e15;

		public Vec2 this[int index]
		{
			get
			{
				if ((uint)index >= 16)
					throw new IndexOutOfRangeException();
				fixed (Vec2* first = &e0)
					return first[index];
			}
			set
			{
				if ((uint)index >= 16)
					throw new IndexOutOfRangeException();
				fixed (Vec2* first = &e0)
					first[index] = value;
			}
		}
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct ManifoldPointArray2
	{
		public ManifoldPoint e0, e1;

		public ManifoldPoint this[int index]
		{
			get
			{
				if ((uint)index >= 2)
					throw new IndexOutOfRangeException();
				fixed (ManifoldPoint* first = &e0)
					return first[index];
			}
			set
			{
				if ((uint)index >= 2)
					throw new IndexOutOfRangeException();
				fixed (ManifoldPoint* first = &e0)
					first[index] = value;
			}
		}
	}

	/// <summary>A world with everything in it. Dispose of it, or the finalizer does.</summary>
	public sealed unsafe partial class World : IDisposable
	{
		private cn_world* pointer;
		private readonly Dictionary<int, cn_contact_event_fn> callbacks = new Dictionary<int, cn_contact_event_fn>();

		public World() : this(WorldDef.Default) { }

		public World(WorldDef def)
		{
			Native.Check();
			cn_world* made;
			Call.Check(Native.cn_world_create((cn_world_def*)&def, &made), null);
			pointer = made;
		}

		private World(cn_world* made)
		{
			pointer = made;
		}

		/// <summary>A world from the bytes of Write. Of the definition only workers and capacities are used.</summary>
		public static World Read(ReadOnlySpan<byte> file, WorldDef? def = null)
		{
			WorldDef given = def ?? WorldDef.Default;
			cn_world* made;
			fixed (byte* from = file)
				Call.Check(Native.cn_world_read((cn_world_def*)&given, from, (ulong)file.Length, &made), null);
			return new World(made);
		}

		~World()
		{
			Native.cn_world_destroy(pointer);
		}

		/// <summary>For functions of Native.</summary>
		public cn_world* Pointer
		{
			get
			{
				if (pointer == null)
					throw new ObjectDisposedException("World");
				return pointer;
			}
		}

		public void Dispose()
		{
			Native.cn_world_destroy(pointer);
			pointer = null;
			GC.SuppressFinalize(this);
		}

		/// <summary>Calls the function for contact events of one kind, while the world is locked; null ends that. It must not throw.</summary>
		public void OnContact(int kind, Action<ContactEvent> function)
		{
			cn_contact_event_fn callback = function == null ? (cn_contact_event_fn)null : (world, contact, user) => function(*(ContactEvent*)contact);
			IntPtr address = callback == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(callback);
			Call.Check(Native.cn_world_set_contact_callback(Pointer, kind, address, null), Pointer);
			callbacks[kind] = callback; // the library keeps a pointer that C# does not see
		}

		/// <summary>Creates a chain through points in the body's frame; closed: the last joins the first.</summary>
		public Shape ShapeCreateChain(ShapeDef def, ReadOnlySpan<Vec2> pointsM, bool closed)
		{
			cn_shape shape;
			fixed (Vec2* points = pointsM)
			{
				var chain = new cn_chain { points_m = (cn_vec2*)points, count = pointsM.Length, loop = closed ? 1u : 0 };
				Call.Check(Native.cn_shape_create_chain(Pointer, (cn_shape_def*)&def, &chain, &shape), Pointer);
			}
			return (Shape)shape;
		}

		/// <summary>Takes one fixed step of dt_s seconds, 0 &lt;= dt_s &lt;= 1; 0 updates contacts and events without
		/// motion. O(awake bodies and their contacts and joints).</summary>
		public void Step(float dtS)
		{
			Call.Check(Native.cn_world_step(Pointer, dtS), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).</summary>
		public void SetGravity(float gravityXMps2, float gravityYMps2)
		{
			Call.Check(Native.cn_world_set_gravity(Pointer, gravityXMps2, gravityYMps2), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads gravity in m/s^2.</summary>
		public Vec2 GetGravity()
		{
			cn_vec2 out0;
			Call.Check(Native.cn_world_get_gravity(Pointer, &out0), null);
			GC.KeepAlive(this);
			return *(Vec2*)&out0;
		}

		/// <summary>Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.</summary>
		public void SetSubstepCount(int count)
		{
			Call.Check(Native.cn_world_set_substep_count(Pointer, count), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the substeps of a step.</summary>
		public int GetSubstepCount()
		{
			int out0;
			Call.Check(Native.cn_world_get_substep_count(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
		/// memory of the solver it was created with; a solver that needs more works without direct solving
		/// (CN_WARNING_FRAME_MEMORY).</summary>
		public void SetSolver(int solver)
		{
			Call.Check(Native.cn_world_set_solver(Pointer, solver), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the solver (CN_SOLVER_*).</summary>
		public int GetSolver()
		{
			int out0;
			Call.Check(Native.cn_world_get_solver(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Sets accuracy_m and work_budget as in cn_world_def: metres &gt;= 0 and 1 to 1e9, or CN_DEFAULT.</summary>
		public void SetAccuracy(float accuracyM, int workBudget)
		{
			Call.Check(Native.cn_world_set_accuracy(Pointer, accuracyM, workBudget), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
		/// (CN_DEFAULT: none).</summary>
		public (float AccuracyM, int WorkBudget) GetAccuracy()
		{
			float out0;
			int out1;
			Call.Check(Native.cn_world_get_accuracy(Pointer, &out0, &out1), null);
			GC.KeepAlive(this);
			return (out0, out1);
		}

		/// <summary>Reads how many workers a step can use: 1, or worker_count where the library supports threads.</summary>
		public int GetWorkerCount()
		{
			int out0;
			Call.Check(Native.cn_world_get_worker_count(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).</summary>
		public void SetFlags(uint flags)
		{
			Call.Check(Native.cn_world_set_flags(Pointer, flags), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the CN_WORLD_ flags.</summary>
		public uint GetFlags()
		{
			uint out0;
			Call.Check(Native.cn_world_get_flags(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Impacts slower than this, in m/s, do not bounce; &gt;= 0.</summary>
		public void SetRestitutionThreshold(float speedMps)
		{
			Call.Check(Native.cn_world_set_restitution_threshold(Pointer, speedMps), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; &gt;= 0.</summary>
		public void SetHitSpeed(float speedMps)
		{
			Call.Check(Native.cn_world_set_hit_speed(Pointer, speedMps), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Sets the greatest linear (m/s) and angular (rad/s) speed, both &gt; 0. The end of a step slows faster
		/// bodies down to them and keeps the direction.</summary>
		public void SetSpeedLimits(float linearMps, float angularRadps)
		{
			Call.Check(Native.cn_world_set_speed_limits(Pointer, linearMps, angularRadps), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Sets the speed in m/s, &gt;= 0, below which bodies may sleep, and the delay in seconds, &gt;= 0, after
		/// which they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays,
		/// those others that no joint holds and that are slower than four times the speed lose theirs within a
		/// second or two: what rocks in a hollow would keep all of a heap awake.</summary>
		public void SetSleep(float speedMps, float delayS)
		{
			Call.Check(Native.cn_world_set_sleep(Pointer, speedMps, delayS), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Stores a number for the user.</summary>
		public void SetUserData(ulong userData)
		{
			Call.Check(Native.cn_world_set_user_data(Pointer, userData), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the user's number.</summary>
		public ulong GetUserData()
		{
			ulong out0;
			Call.Check(Native.cn_world_get_user_data(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Handles of all bodies, ordered by slot. Writes at most capacity (&gt;= 0) of them; out may be NULL when
		/// capacity is 0. out_count is their number. O(slots).</summary>
		public Body[] GetBodies()
		{
			int count_;
			Call.Check(Native.cn_world_get_bodies(Pointer, null, 0, &count_), null);
			var result_ = new Body[count_];
			if (count_ > 0)
				fixed (Body* to = result_)
					Call.Check(Native.cn_world_get_bodies(Pointer, (cn_body*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
		/// O(slots).</summary>
		public Shape[] GetShapes()
		{
			int count_;
			Call.Check(Native.cn_world_get_shapes(Pointer, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_world_get_shapes(Pointer, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
		/// cn_world_get_bodies. O(slots).</summary>
		public Joint[] GetJoints()
		{
			int count_;
			Call.Check(Native.cn_world_get_joints(Pointer, null, 0, &count_), null);
			var result_ = new Joint[count_];
			if (count_ > 0)
				fixed (Joint* to = result_)
					Call.Check(Native.cn_world_get_joints(Pointer, (cn_joint*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Reads counts of objects and what the last step reported. O(bodies + islands).</summary>
		public Counters GetCounters()
		{
			cn_counters out0;
			Call.Check(Native.cn_world_get_counters(Pointer, &out0), null);
			GC.KeepAlive(this);
			return *(Counters*)&out0;
		}

		/// <summary>Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in
		/// a deterministic order, then single bodies. Writes at most capacity (&gt;= 0); *out_count is their
		/// number. A step does no work for it. O(bodies + contacts and joints of the islands written).</summary>
		public IslandReport[] GetIslands()
		{
			int count_;
			Call.Check(Native.cn_world_get_islands(Pointer, null, 0, &count_), null);
			var result_ = new IslandReport[count_];
			if (count_ > 0)
				fixed (IslandReport* to = result_)
					Call.Check(Native.cn_world_get_islands(Pointer, (cn_island_report*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Reads the seconds of the last step by stage.</summary>
		public Profile GetProfile()
		{
			cn_profile out0;
			Call.Check(Native.cn_world_get_profile(Pointer, &out0), null);
			GC.KeepAlive(this);
			return *(Profile*)&out0;
		}

		/// <summary>Reads the memory statistics.</summary>
		public MemoryStats GetMemoryStats()
		{
			cn_memory_stats out0;
			Call.Check(Native.cn_world_get_memory_stats(Pointer, &out0), null);
			GC.KeepAlive(this);
			return *(MemoryStats*)&out0;
		}

		/// <summary>Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| &lt;= 1e6 length units: every position
		/// p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes,
		/// world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay, and
		/// no event is reported. Distances between bodies keep their digits; world anchors are rounded to floats at
		/// the new place. Arrays returned before become invalid; the user moves their own points (movers, rays,
		/// cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all
		/// pairs again.</summary>
		public void ShiftOrigin(float xM, float yM)
		{
			Call.Check(Native.cn_world_shift_origin(Pointer, xM, yM), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
		/// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on
		/// every compiler, CPU and thread count. O(bodies + contacts + joints).</summary>
		public ulong Hash()
		{
			ulong out0;
			Call.Check(Native.cn_world_hash(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).</summary>
		public ulong SaveSize()
		{
			ulong out0;
			Call.Check(Native.cn_world_save_size(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
		/// number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
		/// about 1 KB per body.</summary>
		public byte[] Save()
		{
			ulong bytes_;
			Call.Check(Native.cn_world_save_size(Pointer, &bytes_), null);
			var result_ = new byte[bytes_];
			fixed (byte* to = result_)
				Call.Check(Native.cn_world_save(Pointer, to, bytes_, &bytes_), null);
			GC.KeepAlive(this);
			Array.Resize(ref result_, (int)bytes_);
			return result_;
		}

		/// <summary>Restores a saved state, into the saved world or one created with the same definition (broadphase, length
		/// unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT
		/// for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the objects alive then
		/// (a world in a caller's block has room for its own saves). Arrays returned before become invalid. Handles
		/// of objects alive at the save are valid again, also of objects destroyed since; handles created since are
		/// refused until the same handle is given to a new object: with the same calls to the same object. O(memory
		/// of the world).</summary>
		public void Restore(ReadOnlySpan<byte> save)
		{
			fixed (byte* p_save = save)
			{
				Call.Check(Native.cn_world_restore(Pointer, p_save, (ulong)save.Length), Pointer);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).</summary>
		public ulong WriteSize()
		{
			ulong out0;
			Call.Check(Native.cn_world_write_size(Pointer, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number
		/// of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1
		/// KB per body.</summary>
		public byte[] Write()
		{
			ulong bytes_;
			Call.Check(Native.cn_world_write_size(Pointer, &bytes_), null);
			var result_ = new byte[bytes_];
			fixed (byte* to = result_)
				Call.Check(Native.cn_world_write(Pointer, to, bytes_, &bytes_), null);
			GC.KeepAlive(this);
			Array.Resize(ref result_, (int)bytes_);
			return result_;
		}

		/// <summary>Creates a body. O(1) amortized.</summary>
		public Body BodyCreate(BodyDef def)
		{
			cn_body out0;
			Call.Check(Native.cn_body_create(Pointer, (cn_body_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Body*)&out0;
		}

		/// <summary>Creates count (&gt;= 0) bodies from an array of definitions, all or none. O(count).</summary>
		public void BodyCreateMany(ReadOnlySpan<BodyDef> defs, Span<Body> outBodies)
		{
			Call.Even(defs.Length, outBodies.Length);
			fixed (BodyDef* p_defs = defs)
			fixed (Body* p_out_bodies = outBodies)
			{
				Call.Check(Native.cn_body_create_many(Pointer, (cn_body_def*)p_defs, outBodies.Length, (cn_body*)p_out_bodies), Pointer);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
		/// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts +
		/// joints + shapes).</summary>
		public void BodyDestroy(Body body)
		{
			Call.Check(Native.cn_body_destroy(Pointer, (cn_body)body), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Destroys count (&gt;= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice.
		/// O(their contacts + joints + shapes).</summary>
		public void BodyDestroyMany(ReadOnlySpan<Body> bodies)
		{
			fixed (Body* p_bodies = bodies)
			{
				Call.Check(Native.cn_body_destroy_many(Pointer, (cn_body*)p_bodies, bodies.Length), Pointer);
				GC.KeepAlive(this);
			}
		}

		/// <summary>1 if the handle names a living body of this world, else 0 (also for a NULL world).</summary>
		public bool BodyIsValid(Body body)
		{
			var result_ = Native.cn_body_is_valid(Pointer, (cn_body)body) != 0;
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that
		/// still overlap begin again in the next step), with its forces and any mass override; a body made static
		/// stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints + shapes).</summary>
		public void BodySetType(Body body, int type)
		{
			Call.Check(Native.cn_body_set_type(Pointer, (cn_body)body, type), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the type (CN_BODY_*).</summary>
		public int BodyGetType(Body body)
		{
			int out0;
			Call.Check(Native.cn_body_get_type(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
		/// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints
		/// are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.</summary>
		public void BodySetFlags(Body body, uint flags)
		{
			Call.Check(Native.cn_body_set_flags(Pointer, (cn_body)body, flags), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.</summary>
		public uint BodyGetFlags(Body body)
		{
			uint out0;
			Call.Check(Native.cn_body_get_flags(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled
		/// bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).</summary>
		public void BodySetAwake(Body body, int awake)
		{
			Call.Check(Native.cn_body_set_awake(Pointer, (cn_body)body, awake), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Teleports the body: origin in metres (|x|, |y| &lt;= 1e6 length units), angle in radians (|angle| &lt;=
		/// 1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
		/// them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
		/// neighbours. O(contacts + joints + shapes).</summary>
		public void BodySetPose(Body body, float positionXM, float positionYM, float angleRad)
		{
			Call.Check(Native.cn_body_set_pose(Pointer, (cn_body)body, positionXM, positionYM, angleRad), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the position of the origin and the rotation.</summary>
		public Pose BodyGetPose(Body body)
		{
			cn_pose out0;
			Call.Check(Native.cn_body_get_pose(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return *(Pose*)&out0;
		}

		/// <summary>Reads the position of the origin as the sum of two floats: the high part is within rounding that of
		/// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in double
		/// is more precise; so is a difference of two bodies, taken high from high and low from low, in floats.</summary>
		public (Vec2 HighM, Vec2 LowM) BodyGetPositionParts(Body body)
		{
			cn_vec2 out0;
			cn_vec2 out1;
			Call.Check(Native.cn_body_get_position_parts(Pointer, (cn_body)body, &out0, &out1), null);
			GC.KeepAlive(this);
			return (*(Vec2*)&out0, *(Vec2*)&out1);
		}

		/// <summary>Reads the angle in radians, in (-pi, pi].</summary>
		public float BodyGetAngle(Body body)
		{
			float out0;
			Call.Check(Native.cn_body_get_angle(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Reads the world position of the centre of mass, in metres.</summary>
		public Vec2 BodyGetCenter(Body body)
		{
			cn_vec2 out0;
			Call.Check(Native.cn_body_get_center(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return *(Vec2*)&out0;
		}

		/// <summary>Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
		/// CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.</summary>
		public void BodySetVelocity(Body body, float linearXMps, float linearYMps, float angularRadps)
		{
			Call.Check(Native.cn_body_set_velocity(Pointer, (cn_body)body, linearXMps, linearYMps, angularRadps), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).</summary>
		public Velocity BodyGetVelocity(Body body)
		{
			cn_velocity out0;
			Call.Check(Native.cn_body_get_velocity(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return *(Velocity*)&out0;
		}

		/// <summary>Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes
		/// it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike
		/// after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this before
		/// every step, or stop the body after it.</summary>
		public void BodySetTargetPose(Body body, float positionXM, float positionYM, float angleRad, float dtS)
		{
			Call.Check(Native.cn_body_set_target_pose(Pointer, (cn_body)body, positionXM, positionYM, angleRad, dtS), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Velocity in m/s of the body's material at a world point in metres.</summary>
		public Vec2 BodyGetVelocityAt(Body body, float pointXM, float pointYM)
		{
			cn_vec2 out0;
			Call.Check(Native.cn_body_get_velocity_at(Pointer, (cn_body)body, pointXM, pointYM, &out0), null);
			GC.KeepAlive(this);
			return *(Vec2*)&out0;
		}

		/// <summary>World position of a point given in the body's frame, both in metres.</summary>
		public Vec2 BodyGetWorldPoint(Body body, float localXM, float localYM)
		{
			cn_vec2 out0;
			Call.Check(Native.cn_body_get_world_point(Pointer, (cn_body)body, localXM, localYM, &out0), null);
			GC.KeepAlive(this);
			return *(Vec2*)&out0;
		}

		/// <summary>Position in the body's frame of a world point, both in metres.</summary>
		public Vec2 BodyGetLocalPoint(Body body, float worldXM, float worldYM)
		{
			cn_vec2 out0;
			Call.Check(Native.cn_body_get_local_point(Pointer, (cn_body)body, worldXM, worldYM, &out0), null);
			GC.KeepAlive(this);
			return *(Vec2*)&out0;
		}

		/// <summary>Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
		/// O(shapes).</summary>
		public Aabb BodyGetAabb(Body body)
		{
			cn_aabb out0;
			Call.Check(Native.cn_body_get_aabb(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return *(Aabb*)&out0;
		}

		/// <summary>Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic
		/// and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.</summary>
		public void BodyApplyForce(Body body, float forceXN, float forceYN)
		{
			Call.Check(Native.cn_body_apply_force(Pointer, (cn_body)body, forceXN, forceYN), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
		/// cn_body_apply_force.</summary>
		public void BodyApplyForceAt(Body body, float forceXN, float forceYN, float pointXM, float pointYM)
		{
			Call.Check(Native.cn_body_apply_force_at(Pointer, (cn_body)body, forceXN, forceYN, pointXM, pointYM), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Adds a torque in newton metres; otherwise as cn_body_apply_force.</summary>
		public void BodyApplyTorque(Body body, float torqueNm)
		{
			Call.Check(Native.cn_body_apply_torque(Pointer, (cn_body)body, torqueNm), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
		/// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
		/// overflows.</summary>
		public void BodyApplyImpulse(Body body, float impulseXNs, float impulseYNs)
		{
			Call.Check(Native.cn_body_apply_impulse(Pointer, (cn_body)body, impulseXNs, impulseYNs), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too;
		/// otherwise as cn_body_apply_impulse.</summary>
		public void BodyApplyImpulseAt(Body body, float impulseXNs, float impulseYNs, float pointXM, float pointYM)
		{
			Call.Check(Native.cn_body_apply_impulse_at(Pointer, (cn_body)body, impulseXNs, impulseYNs, pointXM, pointYM), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
		/// cn_body_apply_impulse.</summary>
		public void BodyApplyAngularImpulse(Body body, float impulseNms)
		{
			Call.Check(Native.cn_body_apply_angular_impulse(Pointer, (cn_body)body, impulseNms), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
		/// shapes have no mass weighs 1 kg; without shapes it does not rotate.</summary>
		public MassData BodyGetMassData(Body body)
		{
			cn_mass_data out0;
			Call.Check(Native.cn_body_get_mass_data(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return *(MassData*)&out0;
		}

		/// <summary>Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
		/// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes
		/// the body.</summary>
		public void BodySetMassData(Body body, MassData mass)
		{
			Call.Check(Native.cn_body_set_mass_data(Pointer, (cn_body)body, (cn_mass_data*)&mass), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).</summary>
		public void BodyResetMassData(Body body)
		{
			Call.Check(Native.cn_body_reset_mass_data(Pointer, (cn_body)body), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Sets the linear and angular damping in 1/s (v' = -damping v), both &gt;= 0.</summary>
		public void BodySetDamping(Body body, float linearPerS, float angularPerS)
		{
			Call.Check(Native.cn_body_set_damping(Pointer, (cn_body)body, linearPerS, angularPerS), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the linear and angular damping in 1/s.</summary>
		public (float LinearPerS, float AngularPerS) BodyGetDamping(Body body)
		{
			float out0;
			float out1;
			Call.Check(Native.cn_body_get_damping(Pointer, (cn_body)body, &out0, &out1), null);
			GC.KeepAlive(this);
			return (out0, out1);
		}

		/// <summary>Sets the factor on gravity for this body, finite. A change wakes the body.</summary>
		public void BodySetGravityScale(Body body, float scale)
		{
			Call.Check(Native.cn_body_set_gravity_scale(Pointer, (cn_body)body, scale), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the factor on gravity.</summary>
		public float BodyGetGravityScale(Body body)
		{
			float out0;
			Call.Check(Native.cn_body_get_gravity_scale(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Sets the body's own sleep speed in m/s, &gt;= 0; CN_DEFAULT restores the world's.</summary>
		public void BodySetSleepSpeed(Body body, float speedMps)
		{
			Call.Check(Native.cn_body_set_sleep_speed(Pointer, (cn_body)body, speedMps), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
		/// (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other
		/// bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
		/// within the work_budget. Takes effect with the next step; does not wake.</summary>
		public void BodySetSolver(Body body, int solver)
		{
			Call.Check(Native.cn_body_set_solver(Pointer, (cn_body)body, solver), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).</summary>
		public int BodyGetSolver(Body body)
		{
			int out0;
			Call.Check(Native.cn_body_get_solver(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Stores a number for the user.</summary>
		public void BodySetUserData(Body body, ulong userData)
		{
			Call.Check(Native.cn_body_set_user_data(Pointer, (cn_body)body, userData), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the user's number.</summary>
		public ulong BodyGetUserData(Body body)
		{
			ulong out0;
			Call.Check(Native.cn_body_get_user_data(Pointer, (cn_body)body, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
		/// O(length).</summary>
		public void BodySetName(Body body, string name)
		{
			fixed (byte* p_name = Call.Utf8(name))
			{
				Call.Check(Native.cn_body_set_name(Pointer, (cn_body)body, p_name), Pointer);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.</summary>
		public string BodyGetName(Body body)
		{
			byte* text;
			Call.Check(Native.cn_body_get_name(Pointer, (cn_body)body, &text), null);
			var result_ = Native.Text(text);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).</summary>
		public Shape[] BodyGetShapes(Body body)
		{
			int count_;
			Call.Check(Native.cn_body_get_shapes(Pointer, (cn_body)body, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_body_get_shapes(Pointer, (cn_body)body, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Handles of the body's joints without constraints; out, capacity and *out_count as in
		/// cn_world_get_bodies. O(joints).</summary>
		public Joint[] BodyGetJoints(Body body)
		{
			int count_;
			Call.Check(Native.cn_body_get_joints(Pointer, (cn_body)body, null, 0, &count_), null);
			var result_ = new Joint[count_];
			if (count_ > 0)
				fixed (Joint* to = result_)
					Call.Check(Native.cn_body_get_joints(Pointer, (cn_body)body, (cn_joint*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be
		/// their number. One bad handle fails the whole call. O(count).</summary>
		public void ReadPoses(ReadOnlySpan<Body> bodies, Span<Pose> @out)
		{
			if (!bodies.IsEmpty)
				Call.Even(bodies.Length, @out.Length);
			fixed (Body* p_bodies = bodies)
			fixed (Pose* p_out = @out)
			{
				Call.Check(Native.cn_world_read_poses(Pointer, (cn_body*)p_bodies, @out.Length, (cn_pose*)p_out), null);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Reads count velocities; bodies and count as in cn_world_read_poses. O(count).</summary>
		public void ReadVelocities(ReadOnlySpan<Body> bodies, Span<Velocity> @out)
		{
			if (!bodies.IsEmpty)
				Call.Even(bodies.Length, @out.Length);
			fixed (Body* p_bodies = bodies)
			fixed (Velocity* p_out = @out)
			{
				Call.Check(Native.cn_world_read_velocities(Pointer, (cn_body*)p_bodies, @out.Length, (cn_velocity*)p_out), null);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
		/// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).</summary>
		public void WriteVelocities(ReadOnlySpan<Body> bodies, ReadOnlySpan<Velocity> velocities)
		{
			if (!bodies.IsEmpty)
				Call.Even(bodies.Length, velocities.Length);
			fixed (Body* p_bodies = bodies)
			fixed (Velocity* p_velocities = velocities)
			{
				Call.Check(Native.cn_world_write_velocities(Pointer, (cn_body*)p_bodies, velocities.Length, (cn_velocity*)p_velocities), Pointer);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The
		/// first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.</summary>
		public BodyMoved[] Moved()
		{
			cn_body_moved* data;
			int count_;
			Call.Check(Native.cn_world_moved(Pointer, &data, &count_), Pointer);
			var result_ = Call.Copy<BodyMoved>(data, count_);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Creates a circle; 0 &lt; radius_m &lt;= 1e6. Wakes the body. out_shape may be NULL.</summary>
		public Shape ShapeCreateCircle(ShapeDef def, Circle circle)
		{
			cn_shape out0;
			Call.Check(Native.cn_shape_create_circle(Pointer, (cn_shape_def*)&def, (cn_circle*)&circle, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Shape*)&out0;
		}

		/// <summary>Creates a capsule; ends at least 0.05% of the length unit apart, radius_m &gt; 0. Wakes the body.
		/// out_shape may be NULL.</summary>
		public Shape ShapeCreateCapsule(ShapeDef def, Capsule capsule)
		{
			cn_shape out0;
			Call.Check(Native.cn_shape_create_capsule(Pointer, (cn_shape_def*)&def, (cn_capsule*)&capsule, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Shape*)&out0;
		}

		/// <summary>Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.</summary>
		public Shape ShapeCreateEdge(ShapeDef def, Edge edge)
		{
			cn_shape out0;
			Call.Check(Native.cn_shape_create_edge(Pointer, (cn_shape_def*)&def, (cn_edge*)&edge, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Shape*)&out0;
		}

		/// <summary>Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
		/// out_shape may be NULL.</summary>
		public Shape ShapeCreatePolygon(ShapeDef def, Polygon polygon)
		{
			cn_shape out0;
			Call.Check(Native.cn_shape_create_polygon(Pointer, (cn_shape_def*)&def, (cn_polygon*)&polygon, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Shape*)&out0;
		}

		/// <summary>Creates a box of half sizes &gt; 0; the rounding radius_m &gt;= 0 is added outside. Wakes the body.
		/// out_shape may be NULL.</summary>
		public Shape ShapeCreateBox(ShapeDef def, float halfWidthM, float halfHeightM, float radiusM)
		{
			cn_shape out0;
			Call.Check(Native.cn_shape_create_box(Pointer, (cn_shape_def*)&def, halfWidthM, halfHeightM, radiusM, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Shape*)&out0;
		}

		/// <summary>Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one.
		/// CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).</summary>
		public void ShapeAttach(Shape shape, Body body)
		{
			Call.Check(Native.cn_shape_attach(Pointer, (cn_shape)shape, (cn_body)body), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body.
		/// O(contacts + shapes of the body).</summary>
		public void ShapeDetach(Shape shape)
		{
			Call.Check(Native.cn_shape_detach(Pointer, (cn_shape)shape), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).</summary>
		public void ShapeDestroy(Shape shape)
		{
			Call.Check(Native.cn_shape_destroy(Pointer, (cn_shape)shape), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>1 if the handle names a living shape of this world, else 0 (also for a NULL world).</summary>
		public bool ShapeIsValid(Shape shape)
		{
			var result_ = Native.cn_shape_is_valid(Pointer, (cn_shape)shape) != 0;
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Reads the type (CN_SHAPE_CIRCLE to _CHAIN).</summary>
		public int ShapeGetType(Shape shape)
		{
			int out0;
			Call.Check(Native.cn_shape_get_type(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Reads the body; 0 if unattached.</summary>
		public Body ShapeGetBody(Shape shape)
		{
			cn_body out0;
			Call.Check(Native.cn_shape_get_body(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Body*)&out0;
		}

		/// <summary>Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
		/// body).</summary>
		public void ShapeSetMaterial(Shape shape, Material material)
		{
			Call.Check(Native.cn_shape_set_material(Pointer, (cn_shape)shape, (cn_material*)&material), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the material.</summary>
		public Material ShapeGetMaterial(Shape shape)
		{
			cn_material out0;
			Call.Check(Native.cn_shape_get_material(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Material*)&out0;
		}

		/// <summary>Sets the density in kg/m^2, &gt;= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and
		/// wakes the body. O(shapes of the body).</summary>
		public void ShapeSetDensity(Shape shape, float densityKgpm2)
		{
			Call.Check(Native.cn_shape_set_density(Pointer, (cn_shape)shape, densityKgpm2), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the density in kg/m^2.</summary>
		public float ShapeGetDensity(Shape shape)
		{
			float out0;
			Call.Check(Native.cn_shape_get_density(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
		/// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).</summary>
		public void ShapeSetFilter(Shape shape, Filter filter)
		{
			Call.Check(Native.cn_shape_set_filter(Pointer, (cn_shape)shape, (cn_filter*)&filter), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the filter.</summary>
		public Filter ShapeGetFilter(Shape shape)
		{
			cn_filter out0;
			Call.Check(Native.cn_shape_get_filter(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Filter*)&out0;
		}

		/// <summary>Sets the reported events, bits 1 &lt;&lt; CN_EVENT_*; applies at once, to present contacts too.
		/// O(contacts of the body).</summary>
		public void ShapeSetEventMask(Shape shape, uint eventMask)
		{
			Call.Check(Native.cn_shape_set_event_mask(Pointer, (cn_shape)shape, eventMask), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the event mask.</summary>
		public uint ShapeGetEventMask(Shape shape)
		{
			uint out0;
			Call.Check(Native.cn_shape_get_event_mask(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next
		/// step. Wakes the body, or the bodies near a static shape. O(contacts of the body).</summary>
		public void ShapeSetFlags(Shape shape, uint flags)
		{
			Call.Check(Native.cn_shape_set_flags(Pointer, (cn_shape)shape, flags), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the CN_SHAPE_ flags.</summary>
		public uint ShapeGetFlags(Shape shape)
		{
			uint out0;
			Call.Check(Native.cn_shape_get_flags(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Stores a number for the user.</summary>
		public void ShapeSetUserData(Shape shape, ulong userData)
		{
			Call.Check(Native.cn_shape_set_user_data(Pointer, (cn_shape)shape, userData), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the user's number.</summary>
		public ulong ShapeGetUserData(Shape shape)
		{
			ulong out0;
			Call.Check(Native.cn_shape_get_user_data(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>AABB without margin, in the world (in the shape's own space when unattached). O(points).</summary>
		public Aabb ShapeGetAabb(Shape shape)
		{
			cn_aabb out0;
			Call.Check(Native.cn_shape_get_aabb(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Aabb*)&out0;
		}

		/// <summary>Mass at the present density, centre in the body's frame, inertia about the shape's own centre.
		/// O(points).</summary>
		public MassData ShapeGetMassData(Shape shape)
		{
			cn_mass_data out0;
			Call.Check(Native.cn_shape_get_mass_data(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(MassData*)&out0;
		}

		/// <summary>Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		public Circle ShapeGetCircle(Shape shape)
		{
			cn_circle out0;
			Call.Check(Native.cn_shape_get_circle(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Circle*)&out0;
		}

		/// <summary>Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		public Capsule ShapeGetCapsule(Shape shape)
		{
			cn_capsule out0;
			Call.Check(Native.cn_shape_get_capsule(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Capsule*)&out0;
		}

		/// <summary>Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		public Edge ShapeGetEdge(Shape shape)
		{
			cn_edge out0;
			Call.Check(Native.cn_shape_get_edge(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Edge*)&out0;
		}

		/// <summary>Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		public Polygon ShapeGetPolygon(Shape shape)
		{
			cn_polygon out0;
			Call.Check(Native.cn_shape_get_polygon(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(Polygon*)&out0;
		}

		/// <summary>Reads a chain's points in the body's frame, offset applied. Writes at most capacity (&gt;= 0); out may
		/// be NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points
		/// written).</summary>
		public Vec2[] ShapeGetChainPoints(Shape shape)
		{
			int count_;
			Call.Check(Native.cn_shape_get_chain_points(Pointer, (cn_shape)shape, null, 0, &count_), null);
			var result_ = new Vec2[count_];
			if (count_ > 0)
				fixed (Vec2* to = result_)
					Call.Check(Native.cn_shape_get_chain_points(Pointer, (cn_shape)shape, (cn_vec2*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks
		/// of creation: the handle and all other properties stay. Mass and box are those of the new geometry at
		/// once; contacts stay unless the boxes no longer overlap, and the next step computes them anew, without
		/// the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
		/// meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most.
		/// CN_ERROR_STATE for another type. O(contacts + shapes of the body).</summary>
		public void ShapeSetCircle(Shape shape, Circle circle)
		{
			Call.Check(Native.cn_shape_set_circle(Pointer, (cn_shape)shape, (cn_circle*)&circle), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Replaces a capsule in place; otherwise as cn_shape_set_circle.</summary>
		public void ShapeSetCapsule(Shape shape, Capsule capsule)
		{
			Call.Check(Native.cn_shape_set_capsule(Pointer, (cn_shape)shape, (cn_capsule*)&capsule), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Replaces an edge in place; otherwise as cn_shape_set_circle.</summary>
		public void ShapeSetEdge(Shape shape, Edge edge)
		{
			Call.Check(Native.cn_shape_set_edge(Pointer, (cn_shape)shape, (cn_edge*)&edge), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.</summary>
		public void ShapeSetPolygon(Shape shape, Polygon polygon)
		{
			Call.Check(Native.cn_shape_set_polygon(Pointer, (cn_shape)shape, (cn_polygon*)&polygon), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>out_inside is 1 if the shape contains a world point in metres (in the shape's own space when
		/// unattached), else 0. Edges and chains contain no point. O(points).</summary>
		public int ShapeTestPoint(Shape shape, float pointXM, float pointYM)
		{
			int out0;
			Call.Check(Native.cn_shape_test_point(Pointer, (cn_shape)shape, pointXM, pointYM, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
		/// for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
		/// inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
		/// apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
		/// pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
		/// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of the
		/// step, and got an impulse; bodies that pass a blow on to others that already touch them, without closing,
		/// have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which they begin),
		/// STAY or HIT.</summary>
		public ContactEvent[] ContactEvents(int kind)
		{
			cn_contact_event* data;
			int count_;
			Call.Check(Native.cn_world_contact_events(Pointer, kind, &data, &count_), Pointer);
			var result_ = Call.Copy<ContactEvent>(data, count_);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
		/// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
		/// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or
		/// chains. A pair without an awake body reports nothing until one wakes.</summary>
		public SensorEvent[] SensorEvents()
		{
			cn_sensor_event* data;
			int count_;
			Call.Check(Native.cn_world_sensor_events(Pointer, &data, &count_), null);
			var result_ = Call.Copy<SensorEvent>(data, count_);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
		/// sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
		/// impulses of the last substep. At rest their force is that of the points times substep_count (with
		/// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (&gt;= 0); out may be NULL when capacity is 0.
		/// *out_count is their number. O(contacts).</summary>
		public ContactEvent[] BodyGetContacts(Body body)
		{
			int count_;
			Call.Check(Native.cn_body_get_contacts(Pointer, (cn_body)body, null, 0, &count_), null);
			var result_ = new ContactEvent[count_];
			if (count_ > 0)
				fixed (ContactEvent* to = result_)
					Call.Check(Native.cn_body_get_contacts(Pointer, (cn_body)body, (cn_contact_event*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
		/// cn_body_get_contacts. O(contacts of its body).</summary>
		public ContactEvent[] ShapeGetContacts(Shape shape)
		{
			int count_;
			Call.Check(Native.cn_shape_get_contacts(Pointer, (cn_shape)shape, null, 0, &count_), null);
			var result_ = new ContactEvent[count_];
			if (count_ > 0)
				fixed (ContactEvent* to = result_)
					Call.Check(Native.cn_shape_get_contacts(Pointer, (cn_shape)shape, (cn_contact_event*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
		/// and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of
		/// its body), squared for chains.</summary>
		public Shape[] ShapeGetVisitors(Shape sensor)
		{
			int count_;
			Call.Check(Native.cn_shape_get_visitors(Pointer, (cn_shape)sensor, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_shape_get_visitors(Pointer, (cn_shape)sensor, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
		/// destroyed since are stale.</summary>
		public Body[] FellAsleep()
		{
			cn_body* data;
			int count_;
			Call.Check(Native.cn_world_fell_asleep(Pointer, &data, &count_), null);
			var result_ = Call.Copy<Body>(data, count_);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateRevolute(RevoluteDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_revolute(Pointer, (cn_revolute_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateDistance(DistanceDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_distance(Pointer, (cn_distance_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateFixed(FixedDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_fixed(Pointer, (cn_fixed_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		public Joint JointCreatePrismatic(PrismaticDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_prismatic(Pointer, (cn_prismatic_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateWheel(WheelDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_wheel(Pointer, (cn_wheel_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateMotor(MotorDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_motor(Pointer, (cn_motor_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic, or body_a is not 0. O(contacts of body_a).</summary>
		public Joint JointCreateMouse(MouseDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_mouse(Pointer, (cn_mouse_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateGear(GearDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_gear(Pointer, (cn_gear_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		public Joint JointCreatePulley(PulleyDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_pulley(Pointer, (cn_pulley_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateRatchet(RatchetDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_ratchet(Pointer, (cn_ratchet_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		public Joint JointCreateRotarySpring(RotarySpringDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_rotary_spring(Pointer, (cn_rotary_spring_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic, or the slot has no length. O(contacts of body_a).</summary>
		public Joint JointCreateGroove(GrooveDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_groove(Pointer, (cn_groove_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
		/// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
		/// body_a).</summary>
		public Joint JointCreateFilter(FilterJointDef def)
		{
			cn_joint out0;
			Call.Check(Native.cn_joint_create_filter(Pointer, (cn_filter_joint_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Joint*)&out0;
		}

		/// <summary>Destroys a joint and wakes its bodies. No event is reported.</summary>
		public void JointDestroy(Joint joint)
		{
			Call.Check(Native.cn_joint_destroy(Pointer, (cn_joint)joint), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).</summary>
		public bool JointIsValid(Joint joint)
		{
			var result_ = Native.cn_joint_is_valid(Pointer, (cn_joint)joint) != 0;
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Reads the type (CN_JOINT_REVOLUTE to _FILTER).</summary>
		public int JointGetType(Joint joint)
		{
			int out0;
			Call.Check(Native.cn_joint_get_type(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Reads both bodies; 0 stands for the world.</summary>
		public (Body A, Body B) JointGetBodies(Joint joint)
		{
			cn_body out0;
			cn_body out1;
			Call.Check(Native.cn_joint_get_bodies(Pointer, (cn_joint)joint, &out0, &out1), null);
			GC.KeepAlive(this);
			return (*(Body*)&out0, *(Body*)&out1);
		}

		/// <summary>Reads the world positions of both anchors, in metres.</summary>
		public (Vec2 WorldAM, Vec2 WorldBM) JointGetAnchors(Joint joint)
		{
			cn_vec2 out0;
			cn_vec2 out1;
			Call.Check(Native.cn_joint_get_anchors(Pointer, (cn_joint)joint, &out0, &out1), null);
			GC.KeepAlive(this);
			return (*(Vec2*)&out0, *(Vec2*)&out1);
		}

		/// <summary>Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
		/// after a change of type or of CN_BODY_ENABLED of one of its bodies.</summary>
		public (Vec2 ForceN, float TorqueNm) JointGetReaction(Joint joint)
		{
			cn_vec2 out0;
			float out1;
			Call.Check(Native.cn_joint_get_reaction(Pointer, (cn_joint)joint, &out0, &out1), null);
			GC.KeepAlive(this);
			return (*(Vec2*)&out0, out1);
		}

		/// <summary>Error of the joint's rigid parts, both &gt;= 0: metres (anchors apart, lengths beyond limits) and
		/// radians (angles beyond limits).</summary>
		public (float M, float Rad) JointGetError(Joint joint)
		{
			float out0;
			float out1;
			Call.Check(Native.cn_joint_get_error(Pointer, (cn_joint)joint, &out0, &out1), null);
			GC.KeepAlive(this);
			return (out0, out1);
		}

		/// <summary>Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
		/// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
		/// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a
		/// world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step;
		/// does not wake.</summary>
		public void JointSetSolver(Joint joint, int solver)
		{
			Call.Check(Native.cn_joint_set_solver(Pointer, (cn_joint)joint, solver), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).</summary>
		public int JointGetSolver(Joint joint)
		{
			int out0;
			Call.Check(Native.cn_joint_get_solver(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Stores a number for the user.</summary>
		public void JointSetUserData(Joint joint, ulong userData)
		{
			Call.Check(Native.cn_joint_set_user_data(Pointer, (cn_joint)joint, userData), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the user's number.</summary>
		public ulong JointGetUserData(Joint joint)
		{
			ulong out0;
			Call.Check(Native.cn_joint_get_user_data(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		public void JointSetFlags(Joint joint, uint flags)
		{
			Call.Check(Native.cn_joint_set_flags(Pointer, (cn_joint)joint, flags), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the CN_JOINT_ flags.</summary>
		public uint JointGetFlags(Joint joint)
		{
			uint out0;
			Call.Check(Native.cn_joint_get_flags(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Reads the definition of a revolute joint. CN_ERROR_STATE for another type.</summary>
		public RevoluteDef JointGetRevolute(Joint joint)
		{
			cn_revolute_def out0;
			Call.Check(Native.cn_joint_get_revolute(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(RevoluteDef*)&out0;
		}

		/// <summary>Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetRevolute(Joint joint, RevoluteDef def)
		{
			Call.Check(Native.cn_joint_set_revolute(Pointer, (cn_joint)joint, (cn_revolute_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a distance joint. CN_ERROR_STATE for another type.</summary>
		public DistanceDef JointGetDistance(Joint joint)
		{
			cn_distance_def out0;
			Call.Check(Native.cn_joint_get_distance(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(DistanceDef*)&out0;
		}

		/// <summary>Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetDistance(Joint joint, DistanceDef def)
		{
			Call.Check(Native.cn_joint_set_distance(Pointer, (cn_joint)joint, (cn_distance_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a fixed joint. CN_ERROR_STATE for another type.</summary>
		public FixedDef JointGetFixed(Joint joint)
		{
			cn_fixed_def out0;
			Call.Check(Native.cn_joint_get_fixed(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(FixedDef*)&out0;
		}

		/// <summary>Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetFixed(Joint joint, FixedDef def)
		{
			Call.Check(Native.cn_joint_set_fixed(Pointer, (cn_joint)joint, (cn_fixed_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.</summary>
		public PrismaticDef JointGetPrismatic(Joint joint)
		{
			cn_prismatic_def out0;
			Call.Check(Native.cn_joint_get_prismatic(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(PrismaticDef*)&out0;
		}

		/// <summary>Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetPrismatic(Joint joint, PrismaticDef def)
		{
			Call.Check(Native.cn_joint_set_prismatic(Pointer, (cn_joint)joint, (cn_prismatic_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a wheel joint. CN_ERROR_STATE for another type.</summary>
		public WheelDef JointGetWheel(Joint joint)
		{
			cn_wheel_def out0;
			Call.Check(Native.cn_joint_get_wheel(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(WheelDef*)&out0;
		}

		/// <summary>Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetWheel(Joint joint, WheelDef def)
		{
			Call.Check(Native.cn_joint_set_wheel(Pointer, (cn_joint)joint, (cn_wheel_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a motor joint. CN_ERROR_STATE for another type.</summary>
		public MotorDef JointGetMotorTo(Joint joint)
		{
			cn_motor_def out0;
			Call.Check(Native.cn_joint_get_motor_to(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(MotorDef*)&out0;
		}

		/// <summary>Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetMotorTo(Joint joint, MotorDef def)
		{
			Call.Check(Native.cn_joint_set_motor_to(Pointer, (cn_joint)joint, (cn_motor_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a mouse joint. CN_ERROR_STATE for another type.</summary>
		public MouseDef JointGetMouse(Joint joint)
		{
			cn_mouse_def out0;
			Call.Check(Native.cn_joint_get_mouse(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(MouseDef*)&out0;
		}

		/// <summary>Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
		/// CN_JOINT_COLLIDE changes.</summary>
		public void JointSetMouse(Joint joint, MouseDef def)
		{
			Call.Check(Native.cn_joint_set_mouse(Pointer, (cn_joint)joint, (cn_mouse_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a gear joint. CN_ERROR_STATE for another type.</summary>
		public GearDef JointGetGear(Joint joint)
		{
			cn_gear_def out0;
			Call.Check(Native.cn_joint_get_gear(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(GearDef*)&out0;
		}

		/// <summary>Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
		/// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		public void JointSetGear(Joint joint, GearDef def)
		{
			Call.Check(Native.cn_joint_set_gear(Pointer, (cn_joint)joint, (cn_gear_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a pulley joint. CN_ERROR_STATE for another type.</summary>
		public PulleyDef JointGetPulley(Joint joint)
		{
			cn_pulley_def out0;
			Call.Check(Native.cn_joint_get_pulley(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(PulleyDef*)&out0;
		}

		/// <summary>Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetPulley(Joint joint, PulleyDef def)
		{
			Call.Check(Native.cn_joint_set_pulley(Pointer, (cn_joint)joint, (cn_pulley_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.</summary>
		public RatchetDef JointGetRatchet(Joint joint)
		{
			cn_ratchet_def out0;
			Call.Check(Native.cn_joint_get_ratchet(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(RatchetDef*)&out0;
		}

		/// <summary>Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both
		/// bodies. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		public void JointSetRatchet(Joint joint, RatchetDef def)
		{
			Call.Check(Native.cn_joint_set_ratchet(Pointer, (cn_joint)joint, (cn_ratchet_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a rotary spring. CN_ERROR_STATE for another type.</summary>
		public RotarySpringDef JointGetRotarySpring(Joint joint)
		{
			cn_rotary_spring_def out0;
			Call.Check(Native.cn_joint_get_rotary_spring(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(RotarySpringDef*)&out0;
		}

		/// <summary>Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetRotarySpring(Joint joint, RotarySpringDef def)
		{
			Call.Check(Native.cn_joint_set_rotary_spring(Pointer, (cn_joint)joint, (cn_rotary_spring_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a groove joint. CN_ERROR_STATE for another type.</summary>
		public GrooveDef JointGetGroove(Joint joint)
		{
			cn_groove_def out0;
			Call.Check(Native.cn_joint_get_groove(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(GrooveDef*)&out0;
		}

		/// <summary>Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		public void JointSetGroove(Joint joint, GrooveDef def)
		{
			Call.Check(Native.cn_joint_set_groove(Pointer, (cn_joint)joint, (cn_groove_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the base of a joint of any type.</summary>
		public JointBase JointGetBase(Joint joint)
		{
			cn_joint_base out0;
			Call.Check(Native.cn_joint_get_base(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return *(JointBase*)&out0;
		}

		/// <summary>Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as
		/// in cn_joint_base. Wakes both bodies.</summary>
		public void JointSetBase(Joint joint, JointBase @base)
		{
			Call.Check(Native.cn_joint_set_base(Pointer, (cn_joint)joint, (cn_joint_base*)&@base), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE
		/// for another type. Wakes the body.</summary>
		public void JointSetTarget(Joint joint, float targetXM, float targetYM)
		{
			Call.Check(Native.cn_joint_set_target(Pointer, (cn_joint)joint, targetXM, targetYM), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
		/// reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the translation
		/// along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet, rotary
		/// spring: angle b - angle a; these three over whole turns.</summary>
		public float JointGetPosition(Joint joint)
		{
			float out0;
			Call.Check(Native.cn_joint_get_position(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A
		/// positive motor speed has the same sign.</summary>
		public float JointGetSpeed(Joint joint)
		{
			float out0;
			Call.Check(Native.cn_joint_get_speed(Pointer, (cn_joint)joint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, &gt;= 0) of a revolute,
		/// distance, prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.</summary>
		public void JointSetMotor(Joint joint, float speed, float forceOrTorqueMax)
		{
			Call.Check(Native.cn_joint_set_motor(Pointer, (cn_joint)joint, speed, forceOrTorqueMax), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Sets the limits, lower &lt;= upper, of a revolute (radians in [-pi, pi]), distance (metres &gt;= 0),
		/// prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.</summary>
		public void JointSetLimits(Joint joint, float lower, float upper)
		{
			Call.Check(Native.cn_joint_set_limits(Pointer, (cn_joint)joint, lower, upper), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body
		/// in that step or between it and the step before.</summary>
		public JointEvent[] JointEvents()
		{
			cn_joint_event* data;
			int count_;
			Call.Check(Native.cn_world_joint_events(Pointer, &data, &count_), null);
			var result_ = Call.Copy<JointEvent>(data, count_);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
		/// not dynamic. Wakes the body.</summary>
		public Constraint ConstraintCreateAngle(AngleConstraintDef def)
		{
			cn_constraint out0;
			Call.Check(Native.cn_constraint_create_angle(Pointer, (cn_angle_constraint_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Constraint*)&out0;
		}

		/// <summary>Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
		/// dynamic. Wakes the body.</summary>
		public Constraint ConstraintCreateLine(LineConstraintDef def)
		{
			cn_constraint out0;
			Call.Check(Native.cn_constraint_create_line(Pointer, (cn_line_constraint_def*)&def, &out0), Pointer);
			GC.KeepAlive(this);
			return *(Constraint*)&out0;
		}

		/// <summary>Destroys a constraint and wakes its body. No event is reported.</summary>
		public void ConstraintDestroy(Constraint constraint)
		{
			Call.Check(Native.cn_constraint_destroy(Pointer, (cn_constraint)constraint), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).</summary>
		public bool ConstraintIsValid(Constraint constraint)
		{
			var result_ = Native.cn_constraint_is_valid(Pointer, (cn_constraint)constraint) != 0;
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Reads the type (CN_CONSTRAINT_ANGLE or _LINE).</summary>
		public int ConstraintGetType(Constraint constraint)
		{
			int out0;
			Call.Check(Native.cn_constraint_get_type(Pointer, (cn_constraint)constraint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Reads the body.</summary>
		public Body ConstraintGetBody(Constraint constraint)
		{
			cn_body out0;
			Call.Check(Native.cn_constraint_get_body(Pointer, (cn_constraint)constraint, &out0), null);
			GC.KeepAlive(this);
			return *(Body*)&out0;
		}

		/// <summary>Reads the definition of an angle constraint. CN_ERROR_STATE for another type.</summary>
		public AngleConstraintDef ConstraintGetAngle(Constraint constraint)
		{
			cn_angle_constraint_def out0;
			Call.Check(Native.cn_constraint_get_angle(Pointer, (cn_constraint)constraint, &out0), null);
			GC.KeepAlive(this);
			return *(AngleConstraintDef*)&out0;
		}

		/// <summary>Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
		/// body.</summary>
		public void ConstraintSetAngle(Constraint constraint, AngleConstraintDef def)
		{
			Call.Check(Native.cn_constraint_set_angle(Pointer, (cn_constraint)constraint, (cn_angle_constraint_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the definition of a line constraint. CN_ERROR_STATE for another type.</summary>
		public LineConstraintDef ConstraintGetLine(Constraint constraint)
		{
			cn_line_constraint_def out0;
			Call.Check(Native.cn_constraint_get_line(Pointer, (cn_constraint)constraint, &out0), null);
			GC.KeepAlive(this);
			return *(LineConstraintDef*)&out0;
		}

		/// <summary>Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
		/// body.</summary>
		public void ConstraintSetLine(Constraint constraint, LineConstraintDef def)
		{
			Call.Check(Native.cn_constraint_set_line(Pointer, (cn_constraint)constraint, (cn_line_constraint_def*)&def), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
		/// along the axis, in metres from origin.</summary>
		public float ConstraintGetPosition(Constraint constraint)
		{
			float out0;
			Call.Check(Native.cn_constraint_get_position(Pointer, (cn_constraint)constraint, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Force in newtons and torque in newton metres that the constraint applied to the body in the last
		/// substep.</summary>
		public (Vec2 ForceN, float TorqueNm) ConstraintGetReaction(Constraint constraint)
		{
			cn_vec2 out0;
			float out1;
			Call.Check(Native.cn_constraint_get_reaction(Pointer, (cn_constraint)constraint, &out0, &out1), null);
			GC.KeepAlive(this);
			return (*(Vec2*)&out0, out1);
		}

		/// <summary>Distance beyond the allowed range, &gt;= 0: metres for a line constraint, radians for an angle
		/// constraint.</summary>
		public (float M, float Rad) ConstraintGetError(Constraint constraint)
		{
			float out0;
			float out1;
			Call.Check(Native.cn_constraint_get_error(Pointer, (cn_constraint)constraint, &out0, &out1), null);
			GC.KeepAlive(this);
			return (out0, out1);
		}

		/// <summary>Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
		/// O(slots).</summary>
		public Constraint[] GetConstraints()
		{
			int count_;
			Call.Check(Native.cn_world_get_constraints(Pointer, null, 0, &count_), null);
			var result_ = new Constraint[count_];
			if (count_ > 0)
				fixed (Constraint* to = result_)
					Call.Check(Native.cn_world_get_constraints(Pointer, (cn_constraint*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
		/// constraints of the body).</summary>
		public Constraint[] BodyGetConstraints(Body body)
		{
			int count_;
			Call.Check(Native.cn_body_get_constraints(Pointer, (cn_body)body, null, 0, &count_), null);
			var result_ = new Constraint[count_];
			if (count_ > 0)
				fixed (Constraint* to = result_)
					Call.Check(Native.cn_body_get_constraints(Pointer, (cn_body)body, (cn_constraint*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an
		/// update, 1 to 1000, default 8.</summary>
		public void SetFixedStep(float stepS, int stepsMax)
		{
			Call.Check(Native.cn_world_set_fixed_step(Pointer, stepS, stepsMax), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
		/// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.</summary>
		public UpdateReport Update(float elapsedS)
		{
			cn_update_report out0;
			Call.Check(Native.cn_world_update(Pointer, elapsedS, &out0), Pointer);
			GC.KeepAlive(this);
			return *(UpdateReport*)&out0;
		}

		/// <summary>Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step,
		/// 1 after it. Bodies that did not take part in the last step have their present pose. bodies and count as
		/// in cn_world_read_poses. O(count).</summary>
		public void ReadPosesInterpolated(ReadOnlySpan<Body> bodies, float factor, Span<Pose> @out)
		{
			if (!bodies.IsEmpty)
				Call.Even(bodies.Length, @out.Length);
			fixed (Body* p_bodies = bodies)
			fixed (Pose* p_out = @out)
			{
				Call.Check(Native.cn_world_read_poses_interpolated(Pointer, (cn_body*)p_bodies, @out.Length, factor, (cn_pose*)p_out), null);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Nearest hit of a ray; out-&gt;shape is 0 when there is none. Edges are hit from both sides, chains from
		/// their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child. filter
		/// may be NULL: the defaults. O(log shapes) to O(shapes along the ray).</summary>
		public RayHit CastRay(Ray ray, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			cn_ray_hit out0;
			Call.Check(Native.cn_world_cast_ray(Pointer, (cn_ray*)&ray, filter.HasValue ? (cn_query_filter*)&v_filter : null, &out0), null);
			GC.KeepAlive(this);
			return *(RayHit*)&out0;
		}

		/// <summary>out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log
		/// shapes) to O(shapes along the ray).</summary>
		public int CastRayAny(Ray ray, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int out0;
			Call.Check(Native.cn_world_cast_ray_any(Pointer, (cn_ray*)&ray, filter.HasValue ? (cn_query_filter*)&v_filter : null, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Hits of a ray, nearest first: the nearest capacity (&gt;= 0) are written, *out_count is the number
		/// found. A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log
		/// capacity).</summary>
		public RayHit[] CastRayAll(Ray ray, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int count_;
			Call.Check(Native.cn_world_cast_ray_all(Pointer, (cn_ray*)&ray, filter.HasValue ? (cn_query_filter*)&v_filter : null, null, 0, &count_), null);
			var result_ = new RayHit[count_];
			if (count_ > 0)
				fixed (RayHit* to = result_)
					Call.Check(Native.cn_world_cast_ray_all(Pointer, (cn_ray*)&ray, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_ray_hit*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Nearest hit of each of count (&gt;= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
		/// filter may be NULL. O(sum of the rays).</summary>
		public void CastRays(ReadOnlySpan<Ray> rays, QueryFilter? filter, Span<RayHit> @out)
		{
			Call.Even(rays.Length, @out.Length);
			QueryFilter v_filter = filter.GetValueOrDefault();
			fixed (Ray* p_rays = rays)
			fixed (RayHit* p_out = @out)
			{
				Call.Check(Native.cn_world_cast_rays(Pointer, (cn_ray*)p_rays, @out.Length, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_ray_hit*)p_out), null);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
		/// O(points of the shape).</summary>
		public RayHit ShapeCastRay(Shape shape, Ray ray)
		{
			cn_ray_hit out0;
			Call.Check(Native.cn_shape_cast_ray(Pointer, (cn_shape)shape, (cn_ray*)&ray, &out0), null);
			GC.KeepAlive(this);
			return *(RayHit*)&out0;
		}

		/// <summary>First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
		/// way) without turning. shape is a polygon in world coordinates; with radius_m &gt; 0 its count may be 1
		/// or 2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of
		/// the moving points is in front of it. filter may be NULL. O(shapes along the way).</summary>
		public RayHit CastShape(Polygon shape, float translationXM, float translationYM, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			cn_ray_hit out0;
			Call.Check(Native.cn_world_cast_shape(Pointer, (cn_polygon*)&shape, translationXM, translationYM, filter.HasValue ? (cn_query_filter*)&v_filter : null, &out0), null);
			GC.KeepAlive(this);
			return *(RayHit*)&out0;
		}

		/// <summary>Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
		/// cn_world_get_shapes, each once. The first capacity (&gt;= 0) are written; *out_count is the number
		/// found. filter may be NULL. O(log shapes) to O(boxes in the region).</summary>
		public Shape[] OverlapAabb(Aabb box, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int count_;
			Call.Check(Native.cn_world_overlap_aabb(Pointer, (cn_aabb*)&box, filter.HasValue ? (cn_query_filter*)&v_filter : null, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_world_overlap_aabb(Pointer, (cn_aabb*)&box, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb.
		/// Edges and chains are lines here, seen from both sides.</summary>
		public Shape[] OverlapCircle(Circle circle, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int count_;
			Call.Check(Native.cn_world_overlap_circle(Pointer, (cn_circle*)&circle, filter.HasValue ? (cn_query_filter*)&v_filter : null, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_world_overlap_circle(Pointer, (cn_circle*)&circle, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as
		/// in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.</summary>
		public Shape[] OverlapPolygon(Polygon polygon, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int count_;
			Call.Check(Native.cn_world_overlap_polygon(Pointer, (cn_polygon*)&polygon, filter.HasValue ? (cn_query_filter*)&v_filter : null, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_world_overlap_polygon(Pointer, (cn_polygon*)&polygon, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Shapes that contain a world point in metres; order, capacity, filter and cost as in
		/// cn_world_overlap_aabb. Edges and chains contain no point.</summary>
		public Shape[] OverlapPoint(float xM, float yM, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int count_;
			Call.Check(Native.cn_world_overlap_point(Pointer, xM, yM, filter.HasValue ? (cn_query_filter*)&v_filter : null, null, 0, &count_), null);
			var result_ = new Shape[count_];
			if (count_ > 0)
				fixed (Shape* to = result_)
					Call.Check(Native.cn_world_overlap_point(Pointer, xM, yM, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_shape*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
		/// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.</summary>
		public Closest ClosestPoint(float xM, float yM, float distanceMaxM, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			cn_closest out0;
			Call.Check(Native.cn_world_closest_point(Pointer, xM, yM, distanceMaxM, filter.HasValue ? (cn_query_filter*)&v_filter : null, &out0), null);
			GC.KeepAlive(this);
			return *(Closest*)&out0;
		}

		/// <summary>Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved
		/// by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of least
		/// separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way
		/// shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the length unit
		/// plus its rise in the last step. Shapes wholly behind the plane of another shape are left out, so that
		/// seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby, squared).</summary>
		public Plane[] MoverCollide(Polygon shape, float positionXM, float positionYM, float marginM, QueryFilter? filter = null)
		{
			QueryFilter v_filter = filter.GetValueOrDefault();
			int count_;
			Call.Check(Native.cn_mover_collide(Pointer, (cn_polygon*)&shape, positionXM, positionYM, marginM, filter.HasValue ? (cn_query_filter*)&v_filter : null, null, 0, &count_), null);
			var result_ = new Plane[count_];
			if (count_ > 0)
				fixed (Plane* to = result_)
					Call.Check(Native.cn_mover_collide(Pointer, (cn_polygon*)&shape, positionXM, positionYM, marginM, filter.HasValue ? (cn_query_filter*)&v_filter : null, (cn_plane*)to, count_, &count_), null);
			GC.KeepAlive(this);
			return result_;
		}

		/// <summary>Moves a character by dt_s (0 &lt; dt_s &lt;= 1). Call it after each cn_world_step, else it lags one step
		/// behind the ground that carries it. 1. carried   by the motion of its ground since the last move: of the
		/// point of ground_body under it, and of conveyors 2. walking   on the ground: velocity_mps across up,
		/// along the ground, at the same speed uphill and downhill; no gravity, so that it does not creep. A step
		/// up where a too steep surface blocks it: up by step_height_m, forward, down on walkable ground flying
		/// in the air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off keep
		/// ground_velocity_mps 3. sliding   both by collision planes, cn_mover_solve and casts, up to
		/// iterations_max times: no speed passes through a wall 4. pushing   dynamic bodies in the way get a force
		/// for the next step that brings them to the character's velocity, of at most push_force_N each 5. ground
		/// ground that it touches, or that lies within snap_m below a walking character; velocity_mps loses blocked
		/// components The result depends on the world, def and mover alone: equal calls give equal bits. The loop
		/// of planes, solver and cast is that of Box2D 3's sample of a character mover (Catto, 2025). Pushed bodies
		/// wake; nothing else in the world changes. O(shapes nearby x iterations_max): about 1 us standing, 3 us
		/// walking, 10 us against a wall.</summary>
		public void MoverMove(MoverDef def, float dtS, ref Mover mover)
		{
			fixed (Mover* p_mover = &mover)
			{
				Call.Check(Native.cn_mover_move(Pointer, (cn_mover_def*)&def, dtS, (cn_mover*)p_mover), Pointer);
				GC.KeepAlive(this);
			}
		}

		/// <summary>Makes a sensor an area or changes it. def may be NULL: it is an area no longer. The sensor's filter says
		/// which shapes it has. CN_ERROR_STATE for a shape without CN_SHAPE_SENSOR, an edge or a chain; an area
		/// that loses the flag later does nothing while it is without. Gravity, and damping without density, act on
		/// bodies whose centre of mass is in the area (on its border too) while one of their shapes touches it: on
		/// a body half in it in full or not at all. The medium acts on the part of each shape that is in the area,
		/// exactly for polygons; parts of round shapes are computed as those of polygons of 16 sides, to 1%. The
		/// surface of a circle or capsule is flat across a body, as of a planet. Shapes of a body do not shade each
		/// other. The area's body feels no reaction. Between steps nothing happens: the acceleration is that in the
		/// middle of the next step (leapfrog), so bodies on orbits and floating bodies keep their energy. Damping
		/// and drag are implicit: stable at any strength, mass and time step, with exact terminal speeds. Bodies
		/// that enter or leave, that are in an area that moves, and those in it now, wake; bodies at rest in it may
		/// sleep. Areas are in saves and files. Floats whose draught is less than about g dt^2 (3 mm at 60 steps a
		/// second) are damped, and carry less under a load. An area takes 64 bytes of the world's memory; a step
		/// takes about 0.15 us for each shape in an area, 0.35 us in a medium. Best on a body of its own:
		/// O(contacts of the body).</summary>
		public void ShapeSetArea(Shape shape, AreaDef? def = null)
		{
			AreaDef v_def = def.GetValueOrDefault();
			Call.Check(Native.cn_shape_set_area(Pointer, (cn_shape)shape, def.HasValue ? (cn_area_def*)&v_def : null), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).</summary>
		public AreaDef ShapeGetArea(Shape shape)
		{
			cn_area_def out0;
			Call.Check(Native.cn_shape_get_area(Pointer, (cn_shape)shape, &out0), null);
			GC.KeepAlive(this);
			return *(AreaDef*)&out0;
		}

		/// <summary>The effect of dt_s (0 to 1; the next step's) in a wind on one shape, at once: call it before each step.
		/// flow: velocity of the air in m/s. On each part of the outline that faces the flow, of width w across it,
		/// with u the velocity relative to that point: drag drag_kgpm2 / 2 w |u| u, the law of Newton (1687), and
		/// across the flow the lift of flat plates, lift_kgpm2 / 2 w cos(a) u^2 with a the angle between surface
		/// and flow (Hoerner, 1985). Both 0 to 1e9: densities times coefficients. Exact for the whole outline,
		/// round parts included, and drag along straight edges also for turning bodies; edges and chains are plates
		/// with two sides. Solved implicitly, so that wind never reverses the motion relative to it, at any speed,
		/// mass and time; a pure drag is the exact solution of m v' = -k v^2. wake 0: sleeping bodies stay asleep
		/// and unchanged; else they wake. Static, kinematic and disabled bodies are unchanged. CN_ERROR_STATE for a
		/// shape without a body. O(points).</summary>
		public void ShapeApplyWind(Shape shape, float flowXMps, float flowYMps, float dragKgpm2, float liftKgpm2, float dtS, int wake)
		{
			Call.Check(Native.cn_shape_apply_wind(Pointer, (cn_shape)shape, flowXMps, flowYMps, dragKgpm2, liftKgpm2, dtS, wake), Pointer);
			GC.KeepAlive(this);
		}

		/// <summary>Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
		/// them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).</summary>
		public void Explode(ExplosionDef def)
		{
			Call.Check(Native.cn_world_explode(Pointer, (cn_explosion_def*)&def), Pointer);
			GC.KeepAlive(this);
		}
	}

	/// <summary>A dynamic AABB tree apart from any world.</summary>
	public sealed unsafe partial class Tree : IDisposable
	{
		private cn_tree* pointer;

		public Tree(float marginM)
		{
			cn_tree* made;
			Call.Check(Native.cn_tree_create(marginM, IntPtr.Zero, IntPtr.Zero, null, &made), null);
			pointer = made;
		}

		~Tree()
		{
			Native.cn_tree_destroy(pointer);
		}

		/// <summary>For functions of Native.</summary>
		public cn_tree* Pointer
		{
			get
			{
				if (pointer == null)
					throw new ObjectDisposedException("Tree");
				return pointer;
			}
		}

		public void Dispose()
		{
			Native.cn_tree_destroy(pointer);
			pointer = null;
			GC.SuppressFinalize(this);
		}

		/// <summary>Inserts a finite box with lower_m &lt;= upper_m; *out_item, its handle, is never 0. O(log n).</summary>
		public uint Insert(Aabb box, ulong userData)
		{
			uint out0;
			Call.Check(Native.cn_tree_insert(Pointer, (cn_aabb*)&box, userData, &out0), null);
			GC.KeepAlive(this);
			return out0;
		}

		/// <summary>Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).</summary>
		public void Remove(uint item)
		{
			Call.Check(Native.cn_tree_remove(Pointer, item), null);
			GC.KeepAlive(this);
		}

		/// <summary>Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n).
		/// CN_ERROR_HANDLE for a stale item.</summary>
		public void Move(uint item, Aabb box)
		{
			Call.Check(Native.cn_tree_move(Pointer, item, (cn_aabb*)&box), null);
			GC.KeepAlive(this);
		}

		/// <summary>Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.</summary>
		public Aabb GetBox(uint item)
		{
			cn_aabb out0;
			Call.Check(Native.cn_tree_get_box(Pointer, item, &out0), null);
			GC.KeepAlive(this);
			return *(Aabb*)&out0;
		}

		/// <summary>Reads the number of items and the height of the tree.</summary>
		public (int Count, int Height) GetStats()
		{
			int out0;
			int out1;
			Call.Check(Native.cn_tree_get_stats(Pointer, &out0, &out1), null);
			GC.KeepAlive(this);
			return (out0, out1);
		}
	}

	public static unsafe class Functions
	{

		/// <summary>Version of the library as major * 1000000 + minor * 1000 + patch.</summary>
		public static int Version()
		{
			var result_ = Native.cn_version();
			return result_;
		}

		/// <summary>CN_ABI_VERSION of the library that was linked; a binding compares it with its own.</summary>
		public static int AbiVersion()
		{
			var result_ = Native.cn_abi_version();
			return result_;
		}

		/// <summary>English text for a result code: static, never NULL.</summary>
		public static string ResultText(int result)
		{
			var result_ = Native.Text(Native.cn_result_text(result));
			return result_;
		}

		/// <summary>Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).</summary>
		public static ulong SaveDeltaSize(ReadOnlySpan<byte> @base, ReadOnlySpan<byte> save)
		{
			fixed (byte* p_base = @base)
			fixed (byte* p_save = save)
			{
				ulong out0;
				Call.Check(Native.cn_save_delta_size(p_base, (ulong)@base.Length, p_save, (ulong)save.Length, &out0), null);
				return out0;
			}
		}

		/// <summary>Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
		/// out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).</summary>
		public static byte[] SaveDelta(ReadOnlySpan<byte> @base, ReadOnlySpan<byte> save)
		{
			fixed (byte* p_base = @base)
			fixed (byte* p_save = save)
			{
				ulong bytes_;
				Call.Check(Native.cn_save_delta_size(p_base, (ulong)@base.Length, p_save, (ulong)save.Length, &bytes_), null);
				var result_ = new byte[bytes_];
				fixed (byte* to = result_)
					Call.Check(Native.cn_save_delta(p_base, (ulong)@base.Length, p_save, (ulong)save.Length, to, bytes_, &bytes_), null);
				Array.Resize(ref result_, (int)bytes_);
				return result_;
			}
		}

		/// <summary>Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
		/// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
		/// CN_ERROR_CAPACITY if out is too small. O(bytes).</summary>
		public static byte[] SaveApply(ReadOnlySpan<byte> @base, ReadOnlySpan<byte> delta)
		{
			fixed (byte* p_base = @base)
			fixed (byte* p_delta = delta)
			{
				ulong bytes_;
				bytes_ = (ulong)(@base.Length + delta.Length);
				var result_ = new byte[bytes_];
				fixed (byte* to = result_)
					Call.Check(Native.cn_save_apply(p_base, (ulong)@base.Length, p_delta, (ulong)delta.Length, to, bytes_, &bytes_), null);
				Array.Resize(ref result_, (int)bytes_);
				return result_;
			}
		}

		/// <summary>Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
		/// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
		/// area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
		/// mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m &gt;= 0.
		/// O(count^2) at worst.</summary>
		public static Polygon PolygonMakeHull(ReadOnlySpan<Vec2> pointsM, float radiusM)
		{
			fixed (Vec2* p_points_m = pointsM)
			{
				cn_polygon out0;
				Call.Check(Native.cn_polygon_make_hull((cn_vec2*)p_points_m, pointsM.Length, radiusM, &out0), null);
				return *(Polygon*)&out0;
			}
		}

		/// <summary>A box of half sizes &gt; 0 in metres, with its centre in metres, turned about its own centre by
		/// angle_rad (|angle| &lt;= 1e4); radius_m &gt;= 0.</summary>
		public static Polygon PolygonMakeBox(float halfWidthM, float halfHeightM, float centerXM, float centerYM, float angleRad, float radiusM)
		{
			cn_polygon out0;
			Call.Check(Native.cn_polygon_make_box(halfWidthM, halfHeightM, centerXM, centerYM, angleRad, radiusM, &out0), null);
			return *(Polygon*)&out0;
		}

		/// <summary>Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
		/// in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
		/// without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
		/// Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and
		/// pieces thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself
		/// or has no area. Writes at most capacity pieces (&gt;= 0; count - 2 always suffice); out may be NULL when
		/// capacity is 0. *out_count is the number of all. 34 KB of stack. O(count^2).</summary>
		public static Polygon[] OutlineDecompose(ReadOnlySpan<Vec2> pointsM, float lengthUnitM)
		{
			fixed (Vec2* p_points_m = pointsM)
			{
				int count_;
				Call.Check(Native.cn_outline_decompose((cn_vec2*)p_points_m, pointsM.Length, lengthUnitM, null, 0, &count_), null);
				var result_ = new Polygon[count_];
				if (count_ > 0)
					fixed (Polygon* to = result_)
						Call.Check(Native.cn_outline_decompose((cn_vec2*)p_points_m, pointsM.Length, lengthUnitM, (cn_polygon*)to, count_, &count_), null);
				return result_;
			}
		}

		/// <summary>Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
		/// tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
		/// 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
		/// afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (&gt;= 0); out may
		/// be points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at
		/// worst.</summary>
		public static Vec2[] OutlineSimplify(ReadOnlySpan<Vec2> pointsM, int closed, float toleranceM)
		{
			fixed (Vec2* p_points_m = pointsM)
			{
				int count_;
				Call.Check(Native.cn_outline_simplify((cn_vec2*)p_points_m, pointsM.Length, closed, toleranceM, null, 0, &count_), null);
				var result_ = new Vec2[count_];
				if (count_ > 0)
					fixed (Vec2* to = result_)
						Call.Check(Native.cn_outline_simplify((cn_vec2*)p_points_m, pointsM.Length, closed, toleranceM, (cn_vec2*)to, count_, &count_), null);
				return result_;
			}
		}

		/// <summary>An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to
		/// 4096), squares of side cell_m &gt; 0 with the lower left corner of the first at the origin. cells[row *
		/// columns + column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0;
		/// *out_count is 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on
		/// its left: counter-clockwise around solids, clockwise around holes. Its points are corners of cells.
		/// Solid cells that touch at a corner only are apart; an outline may pass such a corner twice. Writes at
		/// most capacity points (&gt;= 0); out may be NULL when capacity is 0. *out_count is the number of all.
		/// O(cells + n log n) for a boundary of n edges.</summary>
		public static Vec2[] OutlineFromCells(ReadOnlySpan<byte> cells, int columns, float originXM, float originYM, float cellM, int outline)
		{
			fixed (byte* p_cells = cells)
			{
				int count_;
				Call.Check(Native.cn_outline_from_cells((byte*)p_cells, cells.Length, columns, originXM, originYM, cellM, outline, null, 0, &count_), null);
				var result_ = new Vec2[count_];
				if (count_ > 0)
					fixed (Vec2* to = result_)
						Call.Check(Native.cn_outline_from_cells((byte*)p_cells, cells.Length, columns, originXM, originYM, cellM, outline, (cn_vec2*)to, count_, &count_), null);
				return result_;
			}
		}

		/// <summary>The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
		/// finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
		/// columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation,
		/// at least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
		/// another one. cn_outline_simplify removes its collinear points. O(values + n log n).</summary>
		public static Vec2[] OutlineFromField(ReadOnlySpan<float> values, int columns, float threshold, float originXM, float originYM, float spacingM, int outline)
		{
			fixed (float* p_values = values)
			{
				int count_;
				Call.Check(Native.cn_outline_from_field((float*)p_values, values.Length, columns, threshold, originXM, originYM, spacingM, outline, null, 0, &count_), null);
				var result_ = new Vec2[count_];
				if (count_ > 0)
					fixed (Vec2* to = result_)
						Call.Check(Native.cn_outline_from_field((float*)p_values, values.Length, columns, threshold, originXM, originYM, spacingM, outline, (cn_vec2*)to, count_, &count_), null);
				return result_;
			}
		}

		/// <summary>Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
		/// radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).</summary>
		public static Distance PolygonDistance(Polygon a, Pose poseA, Polygon b, Pose poseB)
		{
			cn_distance out0;
			Call.Check(Native.cn_polygon_distance((cn_polygon*)&a, (cn_pose*)&poseA, (cn_polygon*)&b, (cn_pose*)&poseB, &out0), null);
			return *(Distance*)&out0;
		}

		/// <summary>Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0;
		/// *out as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).</summary>
		public static (RayHit Out, int Hit) PolygonCast(Polygon a, Pose poseA, Polygon b, Pose poseB, float translationXM, float translationYM)
		{
			cn_ray_hit out0;
			int out1;
			Call.Check(Native.cn_polygon_cast((cn_polygon*)&a, (cn_pose*)&poseA, (cn_polygon*)&b, (cn_pose*)&poseB, translationXM, translationYM, &out0, &out1), null);
			return (*(RayHit*)&out0, out1);
		}

		/// <summary>Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m
		/// (0 to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
		/// O(points).</summary>
		public static Manifold PolygonCollide(Polygon a, Pose poseA, Polygon b, Pose poseB, float marginM)
		{
			cn_manifold out0;
			Call.Check(Native.cn_polygon_collide((cn_polygon*)&a, (cn_pose*)&poseA, (cn_polygon*)&b, (cn_pose*)&poseB, marginM, &out0), null);
			return *(Manifold*)&out0;
		}

		/// <summary>First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
		/// start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
		/// hit. Needs no world; runs in any thread.</summary>
		public static Impact PolygonTimeOfImpact(Polygon a, Sweep sweepA, Polygon b, Sweep sweepB, float distanceM)
		{
			cn_impact out0;
			Call.Check(Native.cn_polygon_time_of_impact((cn_polygon*)&a, (cn_sweep*)&sweepA, (cn_polygon*)&b, (cn_sweep*)&sweepB, distanceM, &out0), null);
			return *(Impact*)&out0;
		}

		/// <summary>The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
		/// dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
		/// finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least
		/// sum of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below
		/// their limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.</summary>
		public static (Vec2 TranslationM, float OverlapM) MoverSolve(Span<Plane> planes, float translationXM, float translationYM)
		{
			fixed (Plane* p_planes = planes)
			{
				cn_vec2 out0;
				float out1;
				Call.Check(Native.cn_mover_solve((cn_plane*)p_planes, planes.Length, translationXM, translationYM, &out0, &out1), null);
				return (*(Vec2*)&out0, out1);
			}
		}

		/// <summary>The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
		/// cn_mover_solve. Needs no world. O(count^2).</summary>
		public static Vec2 MoverClip(ReadOnlySpan<Plane> planes, float velocityXMps, float velocityYMps)
		{
			fixed (Plane* p_planes = planes)
			{
				cn_vec2 out0;
				Call.Check(Native.cn_mover_clip((cn_plane*)p_planes, planes.Length, velocityXMps, velocityYMps, &out0), null);
				return *(Vec2*)&out0;
			}
		}
	}
}
