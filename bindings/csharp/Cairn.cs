// Cairn for C#, one to one with cairn.h.
// Generated from include/cairn.h by bindings/generate.py (make bindings). Do not edit.
//
//     using Cairn;
//     using static Cairn.Native;
//     cn_world_def def;
//     cn_world_def_init(&def);
//     cn_world* world;
//     if (cn_world_create(&def, &world) != CN_OK) ...
//
// Compile with -unsafe. The library is found as "cairn" (libcairn.so, cairn.dll).
using System;
using System.Runtime.InteropServices;

namespace Cairn
{
	public enum cn_body : uint { none = 0 }
	public enum cn_shape : uint { none = 0 }
	public enum cn_joint : uint { none = 0 }
	public enum cn_constraint : uint { none = 0 }
	public struct cn_world { }
	public struct cn_tree { }

	/// <summary>Memory hooks. Return NULL when there is none; align is a power of two, at most 64. Called only from
	/// inside functions that take a non-const world.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void* cn_alloc_fn(ulong bytes, uint align, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_free_fn(void* memory, ulong bytes, void* user);

	/// <summary>A user's own task system, for worlds with worker_count of 2 or more; without one they start threads of
	/// their own. Within cn_world_step a world that has enough to do asks for help with enqueue, works itself,
	/// and then calls finish; some 3 to 10 times a step. It does not matter where tasks run, in which order, or
	/// whether side by side. cn_task_fn     the library's: call it for ranges [begin, end) that cover 0 to
	/// item_count - 1, each item once, on any threads. A call may last as long as the step, and may wait for
	/// others that have already begun, never for one that has not. Its thread must have the floating-point mode
	/// of the one that steps. cn_enqueue_fn  the user's: makes a task of item_count items (one less than
	/// worker_count) in ranges of at least min_range, and returns what finish knows it by. It may also run all
	/// of it at once, and must do so if it cannot keep it; NULL then says that there is nothing to finish.
	/// cn_finish_fn   the user's: returns when every item of the task has run. Called once for each enqueue that
	/// did not return NULL, in the thread that enqueued. It may run items itself. enqueue and finish are called
	/// in the thread that steps, while no callback runs, and must not call the library.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_task_fn(int begin, int end, void* context);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void* cn_enqueue_fn(IntPtr task, void* context, int item_count, int min_range, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_finish_fn(void* task, void* user);

	/// <summary>Called at the end of cn_world_step for each event of this kind, in the order of the array.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_contact_event_fn(cn_world* world, cn_contact_event* @event, void* user);

	/// <summary>Decides whether two shapes that pass their filters may touch: 1 yes, 0 no. Asked when their boxes begin
	/// to overlap. The world is locked.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_filter_fn(cn_world* world, cn_shape shape_a, cn_shape shape_b, void* user);

	/// <summary>Asked in every step for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE, before solving: 0
	/// makes the pair pass through each other in this step. Event kind is STAY or ENTER.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_pre_solve_fn(cn_world* world, cn_contact_event* contact, void* user);

	/// <summary>Mixes two materials in place of the CN_MIX_ rules: fills *mixed, which holds what the rules gave. Asked
	/// when a pair begins to touch and when a material changes.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_material_mix_fn(cn_world* world, cn_shape shape_a, cn_shape shape_b, cn_material* mixed, void* user);

	/// <summary>Asked by a query for each shape (edge of a chain) that it would find, in no particular order and perhaps
	/// more than once: the answer must depend on the shape alone. hit is what is known of it: all of it in
	/// casts, else shape, body and child. Returns CN_QUERY_*. May call functions that take a const world, of the
	/// same world too, and no others.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_query_fn(cn_world* world, cn_ray_hit* hit, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_polygon_fn(cn_vec2* points_m, int count, float radius_m, uint color, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_circle_fn(cn_vec2* center_m, float radius_m, cn_vec2* rim_m, uint color, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_capsule_fn(cn_vec2* a_m, cn_vec2* b_m, float radius_m, uint color, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_segment_fn(cn_vec2* a_m, cn_vec2* b_m, uint color, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_point_fn(cn_vec2* point_m, float size_px, uint color, void* user);

	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_text_fn(cn_vec2* point_m, byte* text, uint color, void* user);

	/// <summary>Return 0 to stop, anything else to go on.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_tree_query_fn(uint item, ulong user_data, void* user);

	/// <summary>Return the fraction to go on with: the given one to ignore the item, 0 to stop.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate float cn_tree_ray_fn(uint item, ulong user_data, float fraction, void* user);

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_vec2_array16
	{
		public cn_vec2 e0, e1, e2, e3, e4, e5, e6, e7, e8, e9, e10, e11, e12, e13, e14, e15;

		public cn_vec2 this[int index]
		{
			get
			{
				if ((uint)index >= 16)
					throw new IndexOutOfRangeException();
				fixed (cn_vec2* first = &e0)
					return first[index];
			}
			set
			{
				if ((uint)index >= 16)
					throw new IndexOutOfRangeException();
				fixed (cn_vec2* first = &e0)
					first[index] = value;
			}
		}
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_manifold_point_array2
	{
		public cn_manifold_point e0, e1;

		public cn_manifold_point this[int index]
		{
			get
			{
				if ((uint)index >= 2)
					throw new IndexOutOfRangeException();
				fixed (cn_manifold_point* first = &e0)
					return first[index];
			}
			set
			{
				if ((uint)index >= 2)
					throw new IndexOutOfRangeException();
				fixed (cn_manifold_point* first = &e0)
					first[index] = value;
			}
		}
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_vec2
	{
		public float x;
		public float y;
	}

	/// <summary>Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of these can be
	/// uploaded to a GPU as it is.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_pose
	{
		public cn_vec2 position_m;
		public float cosine;
		public float sine;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_velocity
	{
		/// <summary>of the centre of mass</summary>
		public cn_vec2 linear_mps;
		public float angular_radps;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_aabb
	{
		public cn_vec2 lower_m;
		public cn_vec2 upper_m;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mass_data
	{
		public float mass_kg;
		/// <summary>about the centre of mass</summary>
		public float inertia_kgm2;
		/// <summary>in the body's local frame</summary>
		public cn_vec2 center_m;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_world_def
	{
		public uint struct_size;
		/// <summary>CN_WORLD_*; default SLEEP | WARM_START | CONTINUOUS</summary>
		public uint flags;
		/// <summary>default (0, -10)</summary>
		public cn_vec2 gravity_mps2;
		/// <summary>a typical object's size, (0, 1e6]; slop, margins and speed limits scale with it; default 1</summary>
		public float length_unit_m;
		/// <summary>CN_SOLVER_*; default CN_SOLVER_AUTO</summary>
		public int solver;
		/// <summary>CN_BROADPHASE_*; default CN_BROADPHASE_SWEEP</summary>
		public int broadphase;
		/// <summary>1 to 64; default 4</summary>
		public int substep_count;
		/// <summary>CN_SOLVER_AUTO works towards errors below this, &gt;= 0; default 0.005 x length unit</summary>
		public float accuracy_m;
		/// <summary>... but spends no more than this on direct solving in a step, in blocks (joints, contacts and the fill
		/// between them) factored, substeps included: some 10 ns each; 0 to 1e9; default 0: no bound but those of
		/// single islands</summary>
		public int work_budget;
		/// <summary>slower impacts do not bounce, &gt;= 0; default 1 x length unit</summary>
		public float restitution_threshold_mps;
		/// <summary>fastest speed at which overlap is pushed apart, &gt; 0; default 3 x length unit</summary>
		public float push_speed_max_mps;
		/// <summary>&gt; 0; default 400 x length unit</summary>
		public float linear_speed_max_mps;
		/// <summary>&gt; 0; default 400</summary>
		public float angular_speed_max_radps;
		/// <summary>bodies slower than this may sleep, &gt;= 0; default 0.05 x length unit</summary>
		public float sleep_speed_mps;
		/// <summary>... after this long, &gt;= 0; default 0.5</summary>
		public float sleep_delay_s;
		/// <summary>hints for a growing world, exact for a fixed one; &gt;= 0; default 0</summary>
		public int body_capacity;
		/// <summary>counts every edge of a chain</summary>
		public int shape_capacity;
		public int contact_capacity;
		/// <summary>counts constraints too</summary>
		public int joint_capacity;
		public ulong user_data;
		/// <summary>size of memory; 0: use alloc and free</summary>
		public ulong memory_bytes;
		/// <summary>NULL, or one block aligned to 64 bytes that the world lives in, whole</summary>
		public void* memory;
		/// <summary>NULL: malloc; set both or none</summary>
		public IntPtr alloc;
		public IntPtr free;
		public void* allocator_user;
		/// <summary>NULL: threads of the world's own; set both or none</summary>
		public IntPtr enqueue;
		public IntPtr finish;
		public void* task_user;
		/// <summary>how many may work on a step at once, the calling thread one of them; 0 to CN_WORKERS_MAX; default 0: as
		/// 1, which starts no threads and enqueues no tasks</summary>
		public int worker_count;
		public uint reserved;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_counters
	{
		public int bodies;
		/// <summary>dynamic and kinematic bodies that are simulated</summary>
		public int bodies_awake;
		public int shapes;
		/// <summary>boxes in the broadphase: one a shape, one an edge of a chain</summary>
		public int proxies;
		/// <summary>pairs whose fat boxes overlap</summary>
		public int contacts;
		public int contacts_awake;
		/// <summary>pairs that share a manifold, asleep or awake</summary>
		public int contacts_touching;
		/// <summary>and constraints</summary>
		public int joints;
		public int joints_awake;
		/// <summary>awake and asleep, of two or more bodies or one</summary>
		public int islands;
		public int islands_awake;
		/// <summary>groups of contacts that are solved without sharing a body</summary>
		public int colors_used;
		/// <summary>contacts that fit no colour and are solved one by one</summary>
		public int overflow_contacts;
		public int broadphase_tiles;
		/// <summary>steps taken since creation, modulo 2^32</summary>
		public uint steps;
		/// <summary>What the last step could not do for want of memory; 0 when all is well. It tries again. CN_WARNING_*</summary>
		public uint warnings;
		public int pairs_not_added;
		public int events_not_reported;
		/// <summary>of several bodies, solved directly in the last step, contacts and all</summary>
		public int islands_direct;
		/// <summary>planned for all that is solved directly in it, in the units of work_budget; at most 2^31 - 1</summary>
		public int direct_work;
		/// <summary>of several bodies, left to soft constraints for a time because no solution was found:
		/// CN_TIER_REASON_NO_SET</summary>
		public int islands_unsolved;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_island_report
	{
		/// <summary>one of it: of least slot</summary>
		public cn_body body;
		public int bodies;
		/// <summary>touching</summary>
		public int contacts;
		/// <summary>and constraints</summary>
		public int joints;
		/// <summary>CN_TIER_*, after the last step</summary>
		public int tier;
		/// <summary>CN_TIER_REASON_*</summary>
		public int reason;
		/// <summary>of the world, 1 while it rests, as after the last step that took time; joints that swing freely may take
		/// more</summary>
		public int substeps;
		/// <summary>where bodies are now: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints
		/// that may give way (stiffness_hertz, force_max_N, torque_max_Nm) do not count</summary>
		public float residual_m;
	}

	/// <summary>Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_profile
	{
		public float step_s;
		public float wake_s;
		public float broadphase_s;
		public float narrowphase_s;
		public float islands_s;
		public float prepare_s;
		public float substeps_s;
		public float finalize_s;
		public float events_s;
		public float sleep_s;
	}

	/// <summary>Memory, in bytes. The frame arena is the stack allocator whose entries live within one step; the block
	/// allocator serves small variable-size pieces from free lists of size classes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_memory_stats
	{
		/// <summary>taken from the user's allocator or carved from the fixed block</summary>
		public ulong bytes_in_use;
		public ulong bytes_peak;
		/// <summary>calls of the user's alloc (or of the fixed block's) since creation</summary>
		public ulong allocator_calls;
		public ulong arena_capacity;
		/// <summary>most bytes in use at once since creation</summary>
		public ulong arena_peak;
		/// <summary>entries that did not fit and came from the allocator, since creation</summary>
		public ulong arena_fallbacks;
		/// <summary>bytes in chunks</summary>
		public ulong blocks_capacity;
		public ulong blocks_in_use;
		/// <summary>blocks above the largest class, served by the allocator</summary>
		public ulong blocks_large;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_body_def
	{
		public uint struct_size;
		/// <summary>CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic</summary>
		public int type;
		/// <summary>of the origin; |x|, |y| &lt;= 1e6 x length unit</summary>
		public cn_vec2 position_m;
		/// <summary>|angle| &lt;= 1e4</summary>
		public float angle_rad;
		/// <summary>of the centre of mass; both velocities count only with CN_BODY_AWAKE: what sleeps does not move</summary>
		public cn_vec2 linear_velocity_mps;
		public float angular_velocity_radps;
		/// <summary>v' = -damping v; &gt;= 0, default 0</summary>
		public float linear_damping_per_s;
		public float angular_damping_per_s;
		/// <summary>default 1</summary>
		public float gravity_scale;
		/// <summary>&gt;= 0; default 0: the world's</summary>
		public float sleep_speed_mps;
		/// <summary>CN_BODY_*; default ENABLED | SLEEP | AWAKE</summary>
		public uint flags;
		/// <summary>as in cn_body_set_solver; default CN_SOLVER_AUTO</summary>
		public int solver;
		public ulong user_data;
		/// <summary>NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied</summary>
		public byte* name;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_body_moved
	{
		public cn_pose pose;
		public ulong user_data;
		public cn_body body;
		/// <summary>1 in the step in which it fell asleep</summary>
		public uint fell_asleep;
	}

	/// <summary>Two shapes collide when group is equal and not 0: positive yes, negative no; otherwise when each one's
	/// category has a bit in the other's mask.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_filter
	{
		/// <summary>default 1</summary>
		public ulong category;
		/// <summary>default all ones</summary>
		public ulong mask;
		/// <summary>default 0</summary>
		public int group;
		public uint reserved;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_material
	{
		/// <summary>coefficient while sticking, [0, 100], default 0.6</summary>
		public float static_friction;
		/// <summary>coefficient while sliding, [0, static_friction], default 0.6</summary>
		public float dynamic_friction;
		/// <summary>[0, 1], default 0</summary>
		public float restitution;
		/// <summary>metres, [0, 1e3]: lever arm that resists rolling; the pair takes the greater; default 0</summary>
		public float rolling_resistance;
		/// <summary>conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; default 0</summary>
		public float tangent_speed_mps;
		/// <summary>CN_MIX_*</summary>
		public int friction_mix;
		/// <summary>CN_MIX_*</summary>
		public int restitution_mix;
		public uint reserved;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_shape_def
	{
		public uint struct_size;
		/// <summary>0: create unattached, for cn_shape_attach</summary>
		public cn_body body;
		/// <summary>of the shape in the body's local frame</summary>
		public cn_vec2 offset_m;
		public float angle_rad;
		/// <summary>&gt;= 0, giving 0 or 1e-20 to 1e20 kg; default 1</summary>
		public float density_kgpm2;
		public cn_material material;
		public cn_filter filter;
		/// <summary>bit 1 &lt;&lt; CN_EVENT_*; a pair reports what either shape asks for; default ENTER and LEAVE</summary>
		public uint event_mask;
		/// <summary>CN_SHAPE_SENSOR ...; default 0</summary>
		public uint flags;
		public ulong user_data;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_circle
	{
		public cn_vec2 center_m;
		public float radius_m;
	}

	/// <summary>All points within radius_m of the segment.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_capsule
	{
		public cn_vec2 a_m;
		public cn_vec2 b_m;
		public float radius_m;
	}

	/// <summary>A two-sided segment without mass.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_edge
	{
		public cn_vec2 a_m;
		public cn_vec2 b_m;
	}

	/// <summary>Convex; counter-clockwise or clockwise in, always stored counter-clockwise.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_polygon
	{
		/// <summary>3 to CN_POLYGON_MAX_VERTICES</summary>
		public int count;
		/// <summary>rounding added outside of the points, &gt;= 0</summary>
		public float radius_m;
		public cn_vec2_array16 points_m;
	}

	/// <summary>One-sided, massless ground without catches at its inner vertices. The solid side is on the left of the
	/// direction of travel: surface normals point to the right of it, so ground whose points run from +x to -x
	/// collides from above and a counter-clockwise loop collides from outside.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_chain
	{
		/// <summary>copied</summary>
		public cn_vec2* points_m;
		/// <summary>an open chain: &gt;= 2; a loop: &gt;= 3; at most 65535</summary>
		public int count;
		/// <summary>1: the last point joins the first</summary>
		public uint loop;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_manifold_point
	{
		/// <summary>world, midway between the surfaces</summary>
		public cn_vec2 point_m;
		/// <summary>negative when overlapping</summary>
		public float separation_m;
		/// <summary>of the last substep</summary>
		public float normal_impulse_Ns;
		/// <summary>the same while the same features touch</summary>
		public uint feature_id;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_manifold
	{
		/// <summary>unit, from shape a to shape b</summary>
		public cn_vec2 normal;
		/// <summary>of the last substep, on body b along (normal.y, -normal.x)</summary>
		public float friction_impulse_Ns;
		/// <summary>0, 1 or 2</summary>
		public int point_count;
		public cn_manifold_point_array2 points;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_contact_event
	{
		public cn_shape shape_a;
		public cn_shape shape_b;
		public cn_body body_a;
		public cn_body body_b;
		/// <summary>edge number within a chain, else 0</summary>
		public int child_a;
		public int child_b;
		/// <summary>the same from CREATED to DESTROYED, then reused</summary>
		public uint contact_id;
		/// <summary>CN_EVENT_*</summary>
		public int kind;
		/// <summary>ENTER: closing speed along the normal before the impact; else 0</summary>
		public float approach_speed_mps;
		/// <summary>geometry as the step found it, impulses as it left them; points only for ENTER and STAY</summary>
		public cn_manifold manifold;
	}

	/// <summary>A shape entered or left a sensor.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_sensor_event
	{
		public cn_shape sensor;
		public cn_shape visitor;
		public cn_body sensor_body;
		public cn_body visitor_body;
		/// <summary>CN_EVENT_ENTER or CN_EVENT_LEAVE</summary>
		public int kind;
		public uint reserved;
	}

	/// <summary>First field of every joint definition. A joint's rigid parts are what holds anchors, axes, angles,
	/// lengths and limits in place; springs and motors are not.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_joint_base
	{
		/// <summary>of the whole definition</summary>
		public uint struct_size;
		/// <summary>CN_JOINT_*; default 0; a type ignores those it has no use for</summary>
		public uint flags;
		/// <summary>0: the world</summary>
		public cn_body body_a;
		/// <summary>0: the world; one of the two must be dynamic</summary>
		public cn_body body_b;
		/// <summary>in body a's local frame, or in world coordinates</summary>
		public cn_vec2 anchor_a_m;
		public cn_vec2 anchor_b_m;
		/// <summary>of the rigid parts, 0 to 1e6; 0 (default): as stiff as the substeps allow</summary>
		public float stiffness_hertz;
		/// <summary>used when stiffness_hertz &gt; 0; 0 to 1e6</summary>
		public float stiffness_damping_ratio;
		/// <summary>anchors and axes never pull harder, nor does a limit; 0 (default): no bound</summary>
		public float force_max_N;
		/// <summary>the same for angles</summary>
		public float torque_max_Nm;
		/// <summary>a reaction above this in any substep is reported (cn_world_joint_events); 0 (default): never</summary>
		public float break_force_N;
		public float break_torque_Nm;
		public ulong user_data;
	}

	/// <summary>Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_revolute_def
	{
		public cn_joint_base @base;
		public float reference_angle_rad;
		/// <summary>CN_JOINT_LIMIT: -pi &lt;= lower &lt;= upper &lt;= pi</summary>
		public float lower_angle_rad;
		public float upper_angle_rad;
		/// <summary>CN_JOINT_MOTOR</summary>
		public float motor_speed_radps;
		/// <summary>&gt;= 0</summary>
		public float motor_torque_max_Nm;
		/// <summary>CN_JOINT_SPRING: pulls the joint angle to this</summary>
		public float spring_target_rad;
		/// <summary>0 to 1e6</summary>
		public float spring_hertz;
		/// <summary>0 to 1e6</summary>
		public float spring_damping_ratio;
	}

	/// <summary>Two points keep a distance. Without CN_JOINT_SPRING and without CN_JOINT_LIMIT it is a rigid rod of
	/// length_m. With a spring, length_m is its rest length and the distance stays within [min, max] when limits
	/// are on; limits alone make a rope (min 0).</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_distance_def
	{
		public cn_joint_base @base;
		/// <summary>&gt; 0; default 1</summary>
		public float length_m;
		/// <summary>CN_JOINT_LIMIT: 0 &lt;= min &lt;= max; default 0 and 1</summary>
		public float length_min_m;
		public float length_max_m;
		/// <summary>CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only</summary>
		public float motor_speed_mps;
		/// <summary>&gt;= 0</summary>
		public float motor_force_max_N;
		/// <summary>0 to 1e6</summary>
		public float spring_hertz;
		/// <summary>0 to 1e6</summary>
		public float spring_damping_ratio;
		public float reserved;
	}

	/// <summary>Welded: no relative motion. base.stiffness_hertz makes it springy.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_fixed_def
	{
		public cn_joint_base @base;
		/// <summary>angle b - angle a</summary>
		public float reference_angle_rad;
		/// <summary>stiffness of the angle alone, 0 to 1e6; 0: as the base's</summary>
		public float angular_hertz;
		/// <summary>0 to 1e6</summary>
		public float angular_damping_ratio;
		public float reserved;
	}

	/// <summary>b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_prismatic_def
	{
		public cn_joint_base @base;
		/// <summary>in body a's frame, any length &gt; 0 (read back with length 1); default (1, 0)</summary>
		public cn_vec2 axis;
		/// <summary>angle b - angle a</summary>
		public float reference_angle_rad;
		/// <summary>CN_JOINT_LIMIT: lower &lt;= upper</summary>
		public float lower_m;
		public float upper_m;
		/// <summary>CN_JOINT_MOTOR</summary>
		public float motor_speed_mps;
		/// <summary>&gt;= 0</summary>
		public float motor_force_max_N;
		/// <summary>CN_JOINT_SPRING: pulls the translation to this</summary>
		public float spring_target_m;
		/// <summary>0 to 1e6</summary>
		public float spring_hertz;
		/// <summary>0 to 1e6</summary>
		public float spring_damping_ratio;
	}

	/// <summary>A wheel b on suspension: slides along an axis fixed in a (springy, with limits), turns freely; the motor
	/// turns it.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_wheel_def
	{
		public cn_joint_base @base;
		/// <summary>in body a's frame, any length &gt; 0 (read back with length 1); default (0, 1)</summary>
		public cn_vec2 axis;
		/// <summary>CN_JOINT_LIMIT: lower &lt;= upper</summary>
		public float lower_m;
		public float upper_m;
		/// <summary>CN_JOINT_MOTOR</summary>
		public float motor_speed_radps;
		/// <summary>&gt;= 0</summary>
		public float motor_torque_max_Nm;
		/// <summary>CN_JOINT_SPRING: pulls anchor b to anchor a; 0 to 1e6, default 1</summary>
		public float spring_hertz;
		/// <summary>0 to 1e6, default 0.7</summary>
		public float spring_damping_ratio;
	}

	/// <summary>Drives b to an offset and angle from a by a spring with bounded force and torque: base.force_max_N and
	/// base.torque_max_Nm must be &gt; 0.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_motor_def
	{
		/// <summary>anchor b is driven to anchor a + offset</summary>
		public cn_joint_base @base;
		/// <summary>in body a's frame</summary>
		public cn_vec2 offset_m;
		/// <summary>angle b - angle a</summary>
		public float angle_rad;
		/// <summary>how briskly, &gt; 0, to 1e6; default 5</summary>
		public float hertz;
		/// <summary>0 to 1e6, default 1</summary>
		public float damping_ratio;
		public float reserved;
	}

	/// <summary>Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
	/// base.force_max_N must be &gt; 0.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mouse_def
	{
		public cn_joint_base @base;
		public cn_vec2 target_m;
		/// <summary>&gt; 0, to 1e6; default 5</summary>
		public float hertz;
		/// <summary>0 to 1e6, default 0.7</summary>
		public float damping_ratio;
	}

	/// <summary>angle b = ratio * angle a + phase. Angles begin in (-pi, pi] at creation (or when the ratio is changed)
	/// and count whole turns from there.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_gear_def
	{
		public cn_joint_base @base;
		/// <summary>size 1e-4 to 1e4, negative: they turn against each other; default 1</summary>
		public float ratio;
		public float phase_rad;
	}

	/// <summary>|anchor a - ground a| + ratio |anchor b - ground b| &lt;= length: a rope over two pulleys (never pushes).</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_pulley_def
	{
		public cn_joint_base @base;
		/// <summary>world</summary>
		public cn_vec2 ground_a_m;
		public cn_vec2 ground_b_m;
		/// <summary>1e-4 to 1e4; default 1</summary>
		public float ratio;
		/// <summary>&gt; 0</summary>
		public float length_m;
	}

	/// <summary>b may turn against a in one direction only, and back no farther than to the last click that it passed.
	/// Clicks are at phase + any whole number of click_rad, over whole turns.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_ratchet_def
	{
		public cn_joint_base @base;
		public float phase_rad;
		/// <summary>size 1e-4 to 1e4; positive: b may turn counter-clockwise</summary>
		public float click_rad;
	}

	/// <summary>A torque that pulls angle b - angle a to rest, over whole turns. hertz is that of the two bodies' own
	/// inertia.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_rotary_spring_def
	{
		public cn_joint_base @base;
		public float rest_angle_rad;
		/// <summary>&gt; 0, to 1e6; default 1</summary>
		public float hertz;
		/// <summary>0 to 1e6, default 0</summary>
		public float damping_ratio;
		public float reserved;
	}

	/// <summary>anchor b slides in a slot of body a from anchor a to end.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_groove_def
	{
		public cn_joint_base @base;
		/// <summary>in body a's frame; not equal to anchor a; default (1, 0)</summary>
		public cn_vec2 end_m;
	}

	/// <summary>Nothing but: the two bodies do not collide.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_filter_joint_def
	{
		public cn_joint_base @base;
	}

	/// <summary>Something happened to a joint or to a constraint on one body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_joint_event
	{
		/// <summary>0: it was a constraint; stale when destroyed is 1</summary>
		public cn_joint joint;
		/// <summary>0: it was a joint; stale when destroyed is 1</summary>
		public cn_constraint constraint;
		/// <summary>0: the world</summary>
		public cn_body body_a;
		public cn_body body_b;
		/// <summary>largest reaction of the step; 0 when a body was destroyed</summary>
		public float force_N;
		public float torque_Nm;
		/// <summary>1: it is gone (it breaks, or a body of it was destroyed)</summary>
		public uint destroyed;
		public uint reserved;
		public ulong user_data;
	}

	/// <summary>Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
	/// there.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_angle_constraint_def
	{
		public uint struct_size;
		/// <summary>CN_CONSTRAINT_*; default 0</summary>
		public uint flags;
		/// <summary>must be dynamic</summary>
		public cn_body body;
		/// <summary>lower &lt;= upper; equal: locked</summary>
		public float lower_rad;
		public float upper_rad;
		/// <summary>0 (default): rigid; to 1e6</summary>
		public float hertz;
		/// <summary>used when hertz &gt; 0; 0 to 1e6</summary>
		public float damping_ratio;
		/// <summary>a reaction above this is reported (cn_world_joint_events); 0: never</summary>
		public float break_torque_Nm;
		public ulong user_data;
	}

	/// <summary>Keeps a point of a body on a line in the world, within a tolerance to either side, and between limits
	/// along it.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_line_constraint_def
	{
		public uint struct_size;
		/// <summary>CN_CONSTRAINT_*; default 0</summary>
		public uint flags;
		/// <summary>must be dynamic</summary>
		public cn_body body;
		/// <summary>in the body's frame</summary>
		public cn_vec2 anchor_m;
		/// <summary>of the line, world</summary>
		public cn_vec2 origin_m;
		/// <summary>world, any length &gt; 0 (read back with length 1); default (1, 0)</summary>
		public cn_vec2 axis;
		/// <summary>&gt;= 0: free play across the axis</summary>
		public float tolerance_m;
		/// <summary>CN_CONSTRAINT_LIMIT: along the axis from origin; lower &lt;= upper</summary>
		public float lower_m;
		public float upper_m;
		/// <summary>0 (default): rigid; to 1e6</summary>
		public float hertz;
		/// <summary>used when hertz &gt; 0; 0 to 1e6</summary>
		public float damping_ratio;
		/// <summary>a reaction above this is reported (cn_world_joint_events); 0: never</summary>
		public float break_force_N;
		public uint reserved;
		public ulong user_data;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_update_report
	{
		/// <summary>fixed steps taken</summary>
		public int steps;
		/// <summary>time kept for the next update</summary>
		public float leftover_s;
		/// <summary>time given up because of the step cap</summary>
		public float dropped_s;
		/// <summary>leftover / fixed step, [0, 1): between the last two poses</summary>
		public float interpolation;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_ray
	{
		public cn_vec2 origin_m;
		/// <summary>may be 0: then only shapes around the origin are hit; at most 2e6 length units each way</summary>
		public cn_vec2 translation_m;
	}

	/// <summary>What a ray or a moved shape meets. One that starts in contact, overlapping or just touching, meets that
	/// shape at fraction 0, with the shortest way out: depth_m along the normal. It does not meet what it
	/// touches, up to a depth of 0.5% of the length unit, when its translation does not lead in: along the
	/// surface or away from it.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_ray_hit
	{
		/// <summary>0: nothing was hit</summary>
		public cn_shape shape;
		public cn_body body;
		/// <summary>edge of a chain</summary>
		public int child;
		/// <summary>of the translation, [0, 1]; 1 when nothing was hit</summary>
		public float fraction;
		/// <summary>on the surface of the shape that was hit</summary>
		public cn_vec2 point_m;
		/// <summary>unit, out of the shape that was hit</summary>
		public cn_vec2 normal;
		/// <summary>how deep the start is in it, 0 when it is outside</summary>
		public float depth_m;
		public uint reserved;
	}

	/// <summary>A query sees shapes of enabled bodies whose category has a bit in mask and whose mask has one in
	/// category, and of sensors only those with CN_SHAPE_SENSOR_SEEN. Bodies are seen where they are now, also
	/// between steps.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_query_filter
	{
		/// <summary>default 1</summary>
		public ulong category;
		/// <summary>default all ones</summary>
		public ulong mask;
		/// <summary>its shapes are not seen; 0 (default): none. A stale handle is an error</summary>
		public cn_body ignored_body;
		/// <summary>CN_QUERY_IGNORE_JOINED ...; default 0</summary>
		public uint flags;
		/// <summary>NULL (default): all are taken</summary>
		public IntPtr visit;
		public void* user;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_closest
	{
		/// <summary>0: nothing within the distance</summary>
		public cn_shape shape;
		public cn_body body;
		public int child;
		/// <summary>negative: depth inside a shape with area</summary>
		public float distance_m;
		/// <summary>on the surface</summary>
		public cn_vec2 point_m;
		/// <summary>outward there; of edges and chains towards the point</summary>
		public cn_vec2 normal;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_distance
	{
		/// <summary>on the surface of a, in the world</summary>
		public cn_vec2 point_a_m;
		public cn_vec2 point_b_m;
		/// <summary>unit, from a to b</summary>
		public cn_vec2 normal;
		/// <summary>of the surfaces; negative: the depth, the shortest way that moves b out of a</summary>
		public float distance_m;
		public uint reserved;
	}

	/// <summary>A motion from fraction 0 to 1: a point of the shape goes in a straight line, and the shape turns evenly
	/// about it.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_sweep
	{
		public cn_pose start;
		/// <summary>that point, in the shape's frame: the centre of mass of a body</summary>
		public cn_vec2 center_m;
		/// <summary>of it; at most 2e6 m each way</summary>
		public cn_vec2 translation_m;
		/// <summary>counter-clockwise, |turn| &lt;= 1e4</summary>
		public float turn_rad;
		public uint reserved;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_impact
	{
		/// <summary>CN_IMPACT_*</summary>
		public int state;
		public float fraction;
		/// <summary>HIT only, as are the next two: between the surfaces</summary>
		public cn_vec2 point_m;
		/// <summary>unit, from a to b</summary>
		public cn_vec2 normal;
		/// <summary>of the surfaces at fraction, from distance_m to 0.1 mm (or what floats can tell) above</summary>
		public float distance_m;
		public uint reserved;
	}

	/// <summary>A surface that bounds where a shape may move: after a translation t of the shape, separation_m + normal .
	/// t is &gt;= 0, unless that takes more than push_max_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_plane
	{
		/// <summary>unit, from the surface to the shape</summary>
		public cn_vec2 normal;
		/// <summary>where they are nearest, in the world</summary>
		public cn_vec2 point_m;
		/// <summary>of the surfaces along the normal; negative: they overlap</summary>
		public float separation_m;
		/// <summary>&gt;= 0: the farthest that this plane pushes; FLT_MAX: rigid</summary>
		public float push_max_m;
		/// <summary>of the last cn_mover_solve: how far it pushed</summary>
		public float push_m;
		public cn_shape shape;
		public cn_body body;
		/// <summary>edge of a chain</summary>
		public int child;
	}

	/// <summary>How a character moves. The same for every move, or changed from move to move: crouching is another shape.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mover_def
	{
		public uint struct_size;
		/// <summary>CN_MOVER_DROP; default 0</summary>
		public uint flags;
		/// <summary>around its position, never turned; 1 or 2 points with radius &gt; 0: circle, capsule. Default: a capsule
		/// of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly</summary>
		public cn_polygon shape;
		/// <summary>what it collides with; sensors never, one-way shapes from above</summary>
		public cn_query_filter filter;
		/// <summary>any length &gt; 0; default (0, 1)</summary>
		public cn_vec2 up;
		/// <summary>steeper ground cannot be stood on or walked up, 0 to pi / 2; default 0.87 (50 degrees)</summary>
		public float slope_limit_rad;
		/// <summary>climbs steps up to this high while it walks, &gt;= 0; default 0.3</summary>
		public float step_height_m;
		/// <summary>walking, keeps to ground that falls away by up to this in a move, &gt;= 0; default 0.3</summary>
		public float snap_m;
		/// <summary>of the world's gravity in the air; default 1</summary>
		public float gravity_scale;
		/// <summary>the most it pushes a dynamic body with, &gt;= 0; default 200</summary>
		public float push_force_N;
		/// <summary>of sliding, 1 to 64; default 8</summary>
		public int iterations_max;
	}

	/// <summary>A character between two moves. It belongs to the caller, who may copy it, keep it and go back to it: the
	/// world knows nothing of it, and other bodies do not collide with it: for that give it a kinematic body
	/// that is filter.ignored_body and follows by cn_body_set_target_pose. Begin with all 0 but the position.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mover
	{
		public cn_vec2 position_m;
		/// <summary>in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its
		/// component across up; the one along up is 0, and a jump when the caller makes it &gt; 0</summary>
		public cn_vec2 velocity_mps;
		/// <summary>of what it stands on, with CN_MOVER_ON_GROUND; else (0, 0)</summary>
		public cn_vec2 ground_normal;
		/// <summary>in the world, after the move</summary>
		public cn_vec2 ground_point_m;
		/// <summary>... in the frame of ground_body</summary>
		public cn_vec2 ground_local_m;
		/// <summary>of the ground there</summary>
		public cn_vec2 ground_velocity_mps;
		/// <summary>0: none; may become stale, which is as none</summary>
		public cn_body ground_body;
		public cn_shape ground_shape;
		/// <summary>CN_MOVER_ON_*, after the last move</summary>
		public uint flags;
		/// <summary>by how much it overlaps what left it no room; 0 but for rounding</summary>
		public float squeezed_m;
	}

	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_explosion_def
	{
		public uint struct_size;
		/// <summary>full strength within, to the nearest point of a shape; &gt;= 0, default 1</summary>
		public float radius_m;
		/// <summary>then linearly to none over this distance; &gt;= 0</summary>
		public float falloff_m;
		/// <summary>per metre of the shape's width seen from the centre; negative pulls</summary>
		public float impulse_Nspm;
		public cn_vec2 center_m;
		public cn_query_filter filter;
	}

	/// <summary>Functions that are NULL are not called. Colours are 0xRRGGBB. Points are in world coordinates.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_debug_draw
	{
		public uint struct_size;
		/// <summary>CN_DRAW_*; default SHAPES | JOINTS | CONTACTS</summary>
		public uint flags;
		/// <summary>only what overlaps it is drawn; default everything</summary>
		public cn_aabb view;
		public IntPtr polygon;
		/// <summary>axis: a point on the rim that turns with the body</summary>
		public IntPtr circle;
		public IntPtr capsule;
		public IntPtr segment;
		public IntPtr point;
		public IntPtr text;
		public void* user;
		public void* reserved;
	}

	public static unsafe class Native
	{
		private const string Library = "cairn";

		/// <summary>A library of another version would read other structs: call this once before anything else.</summary>
		public static void Check()
		{
			if (cn_abi_version() != CN_ABI_VERSION)
				throw new DllNotFoundException("Cairn.cs is for ABI " + CN_ABI_VERSION + ", the library has " + cn_abi_version());
			CheckSize("cn_vec2", sizeof(cn_vec2), CN_TYPE_VEC2);
			CheckSize("cn_pose", sizeof(cn_pose), CN_TYPE_POSE);
			CheckSize("cn_velocity", sizeof(cn_velocity), CN_TYPE_VELOCITY);
			CheckSize("cn_aabb", sizeof(cn_aabb), CN_TYPE_AABB);
			CheckSize("cn_mass_data", sizeof(cn_mass_data), CN_TYPE_MASS_DATA);
			CheckSize("cn_world_def", sizeof(cn_world_def), CN_TYPE_WORLD_DEF);
			CheckSize("cn_counters", sizeof(cn_counters), CN_TYPE_COUNTERS);
			CheckSize("cn_island_report", sizeof(cn_island_report), CN_TYPE_ISLAND_REPORT);
			CheckSize("cn_profile", sizeof(cn_profile), CN_TYPE_PROFILE);
			CheckSize("cn_memory_stats", sizeof(cn_memory_stats), CN_TYPE_MEMORY_STATS);
			CheckSize("cn_body_def", sizeof(cn_body_def), CN_TYPE_BODY_DEF);
			CheckSize("cn_body_moved", sizeof(cn_body_moved), CN_TYPE_BODY_MOVED);
			CheckSize("cn_filter", sizeof(cn_filter), CN_TYPE_FILTER);
			CheckSize("cn_material", sizeof(cn_material), CN_TYPE_MATERIAL);
			CheckSize("cn_shape_def", sizeof(cn_shape_def), CN_TYPE_SHAPE_DEF);
			CheckSize("cn_circle", sizeof(cn_circle), CN_TYPE_CIRCLE);
			CheckSize("cn_capsule", sizeof(cn_capsule), CN_TYPE_CAPSULE);
			CheckSize("cn_edge", sizeof(cn_edge), CN_TYPE_EDGE);
			CheckSize("cn_polygon", sizeof(cn_polygon), CN_TYPE_POLYGON);
			CheckSize("cn_chain", sizeof(cn_chain), CN_TYPE_CHAIN);
			CheckSize("cn_manifold_point", sizeof(cn_manifold_point), CN_TYPE_MANIFOLD_POINT);
			CheckSize("cn_manifold", sizeof(cn_manifold), CN_TYPE_MANIFOLD);
			CheckSize("cn_contact_event", sizeof(cn_contact_event), CN_TYPE_CONTACT_EVENT);
			CheckSize("cn_sensor_event", sizeof(cn_sensor_event), CN_TYPE_SENSOR_EVENT);
			CheckSize("cn_joint_base", sizeof(cn_joint_base), CN_TYPE_JOINT_BASE);
			CheckSize("cn_revolute_def", sizeof(cn_revolute_def), CN_TYPE_REVOLUTE_DEF);
			CheckSize("cn_distance_def", sizeof(cn_distance_def), CN_TYPE_DISTANCE_DEF);
			CheckSize("cn_fixed_def", sizeof(cn_fixed_def), CN_TYPE_FIXED_DEF);
			CheckSize("cn_prismatic_def", sizeof(cn_prismatic_def), CN_TYPE_PRISMATIC_DEF);
			CheckSize("cn_wheel_def", sizeof(cn_wheel_def), CN_TYPE_WHEEL_DEF);
			CheckSize("cn_motor_def", sizeof(cn_motor_def), CN_TYPE_MOTOR_DEF);
			CheckSize("cn_mouse_def", sizeof(cn_mouse_def), CN_TYPE_MOUSE_DEF);
			CheckSize("cn_gear_def", sizeof(cn_gear_def), CN_TYPE_GEAR_DEF);
			CheckSize("cn_pulley_def", sizeof(cn_pulley_def), CN_TYPE_PULLEY_DEF);
			CheckSize("cn_ratchet_def", sizeof(cn_ratchet_def), CN_TYPE_RATCHET_DEF);
			CheckSize("cn_rotary_spring_def", sizeof(cn_rotary_spring_def), CN_TYPE_ROTARY_SPRING_DEF);
			CheckSize("cn_groove_def", sizeof(cn_groove_def), CN_TYPE_GROOVE_DEF);
			CheckSize("cn_filter_joint_def", sizeof(cn_filter_joint_def), CN_TYPE_FILTER_JOINT_DEF);
			CheckSize("cn_joint_event", sizeof(cn_joint_event), CN_TYPE_JOINT_EVENT);
			CheckSize("cn_angle_constraint_def", sizeof(cn_angle_constraint_def), CN_TYPE_ANGLE_CONSTRAINT_DEF);
			CheckSize("cn_line_constraint_def", sizeof(cn_line_constraint_def), CN_TYPE_LINE_CONSTRAINT_DEF);
			CheckSize("cn_update_report", sizeof(cn_update_report), CN_TYPE_UPDATE_REPORT);
			CheckSize("cn_ray", sizeof(cn_ray), CN_TYPE_RAY);
			CheckSize("cn_ray_hit", sizeof(cn_ray_hit), CN_TYPE_RAY_HIT);
			CheckSize("cn_query_filter", sizeof(cn_query_filter), CN_TYPE_QUERY_FILTER);
			CheckSize("cn_closest", sizeof(cn_closest), CN_TYPE_CLOSEST);
			CheckSize("cn_distance", sizeof(cn_distance), CN_TYPE_DISTANCE);
			CheckSize("cn_sweep", sizeof(cn_sweep), CN_TYPE_SWEEP);
			CheckSize("cn_impact", sizeof(cn_impact), CN_TYPE_IMPACT);
			CheckSize("cn_plane", sizeof(cn_plane), CN_TYPE_PLANE);
			CheckSize("cn_mover_def", sizeof(cn_mover_def), CN_TYPE_MOVER_DEF);
			CheckSize("cn_mover", sizeof(cn_mover), CN_TYPE_MOVER);
			CheckSize("cn_explosion_def", sizeof(cn_explosion_def), CN_TYPE_EXPLOSION_DEF);
			CheckSize("cn_debug_draw", sizeof(cn_debug_draw), CN_TYPE_DEBUG_DRAW);
		}

		private static void CheckSize(string name, int bytes, int type)
		{
			if (bytes != cn_sizeof(type))
				throw new DllNotFoundException(name + " has " + bytes + " bytes here, " + cn_sizeof(type) + " in the library");
		}

		/// <summary>The string at a const char* of the library.</summary>
		public static string Text(byte* text)
		{
			int length = 0;
			while (text != null && text[length] != 0)
				++length;
			return length == 0 ? "" : System.Text.Encoding.UTF8.GetString(text, length);
		}

		public const int CN_VERSION_MAJOR = 0;
		public const int CN_VERSION_MINOR = 1;
		public const int CN_VERSION_PATCH = 0;
		public const int CN_ABI_VERSION = 2;
		public const int CN_POLYGON_MAX_VERTICES = 16;
		public const int CN_NAME_MAX_BYTES = 63;
		public const int CN_PLANES_MAX = 64;
		public const int CN_WORKERS_MAX = 64;
		public const int CN_MAX_HANDLES = 1048575;

		public const int CN_OK = 0;
		/// <summary>a value is NaN, infinite, out of range, NULL or degenerate</summary>
		public const int CN_ERROR_ARGUMENT = -1;
		/// <summary>a handle is stale, of the wrong kind or 0</summary>
		public const int CN_ERROR_HANDLE = -2;
		/// <summary>the allocator or the fixed block has no room</summary>
		public const int CN_ERROR_MEMORY = -3;
		/// <summary>called from inside a callback</summary>
		public const int CN_ERROR_LOCKED = -4;
		/// <summary>more than CN_MAX_HANDLES things, or an output array too small</summary>
		public const int CN_ERROR_CAPACITY = -5;
		/// <summary>the object is in a state in which this makes no sense</summary>
		public const int CN_ERROR_STATE = -6;
		/// <summary>cn_world_validate found a broken invariant: a bug in Cairn</summary>
		public const int CN_ERROR_INTERNAL = -7;
		public const int CN_ERROR_FORMAT = -8;

		public const int CN_TYPE_VEC2 = 0;
		public const int CN_TYPE_POSE = 1;
		public const int CN_TYPE_VELOCITY = 2;
		public const int CN_TYPE_AABB = 3;
		public const int CN_TYPE_MASS_DATA = 4;
		public const int CN_TYPE_WORLD_DEF = 5;
		public const int CN_TYPE_BODY_DEF = 6;
		public const int CN_TYPE_SHAPE_DEF = 7;
		public const int CN_TYPE_CIRCLE = 8;
		public const int CN_TYPE_CAPSULE = 9;
		public const int CN_TYPE_EDGE = 10;
		public const int CN_TYPE_POLYGON = 11;
		public const int CN_TYPE_CHAIN = 12;
		public const int CN_TYPE_FILTER = 13;
		public const int CN_TYPE_MATERIAL = 14;
		public const int CN_TYPE_MANIFOLD_POINT = 15;
		public const int CN_TYPE_MANIFOLD = 16;
		public const int CN_TYPE_CONTACT_EVENT = 17;
		public const int CN_TYPE_BODY_MOVED = 18;
		public const int CN_TYPE_REVOLUTE_DEF = 19;
		public const int CN_TYPE_DISTANCE_DEF = 20;
		public const int CN_TYPE_COUNTERS = 21;
		public const int CN_TYPE_PROFILE = 22;
		public const int CN_TYPE_MEMORY_STATS = 23;
		public const int CN_TYPE_SENSOR_EVENT = 24;
		public const int CN_TYPE_UPDATE_REPORT = 25;
		public const int CN_TYPE_DEBUG_DRAW = 26;
		public const int CN_TYPE_QUERY_FILTER = 27;
		public const int CN_TYPE_RAY = 28;
		public const int CN_TYPE_RAY_HIT = 29;
		public const int CN_TYPE_CLOSEST = 30;
		public const int CN_TYPE_EXPLOSION_DEF = 31;
		public const int CN_TYPE_FIXED_DEF = 32;
		public const int CN_TYPE_PRISMATIC_DEF = 33;
		public const int CN_TYPE_WHEEL_DEF = 34;
		public const int CN_TYPE_MOTOR_DEF = 35;
		public const int CN_TYPE_MOUSE_DEF = 36;
		public const int CN_TYPE_GEAR_DEF = 37;
		public const int CN_TYPE_PULLEY_DEF = 38;
		public const int CN_TYPE_RATCHET_DEF = 39;
		public const int CN_TYPE_ROTARY_SPRING_DEF = 40;
		public const int CN_TYPE_GROOVE_DEF = 41;
		public const int CN_TYPE_FILTER_JOINT_DEF = 42;
		public const int CN_TYPE_JOINT_BASE = 43;
		public const int CN_TYPE_JOINT_EVENT = 44;
		public const int CN_TYPE_ANGLE_CONSTRAINT_DEF = 45;
		public const int CN_TYPE_LINE_CONSTRAINT_DEF = 46;
		public const int CN_TYPE_ISLAND_REPORT = 47;
		public const int CN_TYPE_DISTANCE = 48;
		public const int CN_TYPE_SWEEP = 49;
		public const int CN_TYPE_IMPACT = 50;
		public const int CN_TYPE_PLANE = 51;
		public const int CN_TYPE_MOVER_DEF = 52;
		public const int CN_TYPE_MOVER = 53;
		public const int CN_TYPE_COUNT = 54;

		/// <summary>islands at rest fall asleep (default on)</summary>
		public const uint CN_WORLD_SLEEP = 1;
		/// <summary>start solving from the last step's impulses (default on)</summary>
		public const uint CN_WORLD_WARM_START = 2;
		/// <summary>measure cn_profile (default off: reading a clock costs time)</summary>
		public const uint CN_WORLD_PROFILE = 4;
		public const uint CN_WORLD_CONTINUOUS = 8;

		/// <summary>soft constraints with substeps; directly solved where that is worth its cost</summary>
		public const int CN_SOLVER_AUTO = 0;
		/// <summary>soft contact and joint constraints with substeps alone (Catto, Solver2D, 2024)</summary>
		public const int CN_SOLVER_SOFT = 1;
		/// <summary>directly solved wherever it can be, whatever it costs: all joints, all piles without joints</summary>
		public const int CN_SOLVER_DIRECT = 2;
		public const int CN_SOLVER_SEQUENTIAL = 3;

		/// <summary>tiled sweep-and-prune</summary>
		public const int CN_BROADPHASE_SWEEP = 0;
		public const int CN_BROADPHASE_TREE = 1;

		/// <summary>new contacts were not added: pairs_not_added</summary>
		public const uint CN_WARNING_CONTACT_MEMORY = 1;
		/// <summary>the step worked around missing scratch memory</summary>
		public const uint CN_WARNING_FRAME_MEMORY = 2;
		public const uint CN_WARNING_EVENT_MEMORY = 4;

		// How an island is solved. Joints of either may be solved together with their neighbours.
		/// <summary>contacts by soft constraints</summary>
		public const int CN_TIER_SOFT = 0;
		/// <summary>contacts and joints in one system, exactly</summary>
		public const int CN_TIER_DIRECT = 1;
		public const int CN_TIER_FREE = 2;

		// Why.
		/// <summary>nothing is wrong</summary>
		public const int CN_TIER_REASON_NONE = 0;
		/// <summary>direct: nothing is wrong any more, but not yet for long enough</summary>
		public const int CN_TIER_REASON_SETTLING = 1;
		/// <summary>direct: a contact began to bear where much is borne or things lean</summary>
		public const int CN_TIER_REASON_NEW_CONTACT = 2;
		/// <summary>direct: an overlap that the accuracy does not allow</summary>
		public const int CN_TIER_REASON_OVERLAP = 3;
		/// <summary>no longer given</summary>
		public const int CN_TIER_REASON_JOINT = 4;
		/// <summary>direct: something bears so many times its weight that soft contacts would give way</summary>
		public const int CN_TIER_REASON_STRESSED = 5;
		/// <summary>the world's solver is not CN_SOLVER_AUTO</summary>
		public const int CN_TIER_REASON_SOLVER = 6;
		/// <summary>a body's own solver: cn_body_set_solver</summary>
		public const int CN_TIER_REASON_OVERRIDE = 7;
		/// <summary>soft: a single body</summary>
		public const int CN_TIER_REASON_ALONE = 8;
		/// <summary>soft: something is wrong, but it moves too fast</summary>
		public const int CN_TIER_REASON_MOVING = 9;
		/// <summary>soft: something is wrong, but it or the sum of such islands is too large</summary>
		public const int CN_TIER_REASON_CROWDED = 10;
		/// <summary>soft for a time: its system is beyond the limit of work or the work_budget</summary>
		public const int CN_TIER_REASON_WORK = 11;
		/// <summary>soft for a time: restitution, a conveyor, rolling resistance or a locked axis</summary>
		public const int CN_TIER_REASON_KIND = 12;
		/// <summary>soft for a time: no solution was found for its contacts; it stays awake while it moves at all</summary>
		public const int CN_TIER_REASON_NO_SET = 13;
		/// <summary>soft: no scratch memory (CN_WARNING_FRAME_MEMORY)</summary>
		public const int CN_TIER_REASON_MEMORY = 14;
		public const int CN_TIER_REASON_JOINTED = 15;

		/// <summary>never moves, infinite mass</summary>
		public const int CN_BODY_STATIC = 0;
		/// <summary>moves by its velocity alone, infinite mass</summary>
		public const int CN_BODY_KINEMATIC = 1;
		public const int CN_BODY_DYNAMIC = 2;

		/// <summary>the centre of mass keeps its world x</summary>
		public const uint CN_BODY_LOCK_X = 1;
		public const uint CN_BODY_LOCK_Y = 2;
		public const uint CN_BODY_LOCK_ROTATION = 4;
		/// <summary>continuous collision against dynamic bodies too (stored)</summary>
		public const uint CN_BODY_BULLET = 8;
		/// <summary>takes part in the simulation (default on)</summary>
		public const uint CN_BODY_ENABLED = 16;
		/// <summary>may fall asleep (default on)</summary>
		public const uint CN_BODY_SLEEP = 32;
		public const uint CN_BODY_AWAKE = 64;

		public const int CN_SHAPE_CIRCLE = 0;
		public const int CN_SHAPE_CAPSULE = 1;
		public const int CN_SHAPE_POLYGON = 2;
		public const int CN_SHAPE_EDGE = 3;
		public const int CN_SHAPE_CHAIN = 4;

		// How two materials' numbers become a pair's. When the two ask for different rules, the later one of this
		// list is taken.
		public const int CN_MIX_AVERAGE = 0;
		/// <summary>square root of the product; default for friction</summary>
		public const int CN_MIX_GEOMETRIC = 1;
		public const int CN_MIX_MINIMUM = 2;
		public const int CN_MIX_MULTIPLY = 3;
		public const int CN_MIX_MAXIMUM = 4;

		/// <summary>reports who enters and leaves and touches nothing; see cn_world_sensor_events</summary>
		public const uint CN_SHAPE_SENSOR = 1;
		/// <summary>queries see this sensor (default: they do not)</summary>
		public const uint CN_SHAPE_SENSOR_SEEN = 2;
		/// <summary>collides only with what comes from the side its local +y axis points to</summary>
		public const uint CN_SHAPE_ONE_WAY = 4;
		public const uint CN_SHAPE_PRE_SOLVE = 8;

		/// <summary>the fat boxes of two shapes began to overlap</summary>
		public const int CN_EVENT_CREATED = 0;
		/// <summary>they began to touch</summary>
		public const int CN_EVENT_ENTER = 1;
		/// <summary>they still touch</summary>
		public const int CN_EVENT_STAY = 2;
		/// <summary>they stopped touching, or one went away</summary>
		public const int CN_EVENT_LEAVE = 3;
		/// <summary>the fat boxes no longer overlap, or one went away</summary>
		public const int CN_EVENT_DESTROYED = 4;
		public const int CN_EVENT_KINDS = 5;

		public const int CN_JOINT_REVOLUTE = 0;
		public const int CN_JOINT_DISTANCE = 1;
		public const int CN_JOINT_FIXED = 2;
		public const int CN_JOINT_PRISMATIC = 3;
		public const int CN_JOINT_WHEEL = 4;
		public const int CN_JOINT_MOTOR_TO = 5;
		public const int CN_JOINT_MOUSE = 6;
		public const int CN_JOINT_GEAR = 7;
		public const int CN_JOINT_PULLEY = 8;
		public const int CN_JOINT_RATCHET = 9;
		public const int CN_JOINT_ROTARY_SPRING = 10;
		public const int CN_JOINT_GROOVE = 11;
		public const int CN_JOINT_FILTER = 12;

		/// <summary>the connected bodies' shapes collide with each other (default off)</summary>
		public const uint CN_JOINT_COLLIDE = 1;
		public const uint CN_JOINT_LIMIT = 2;
		public const uint CN_JOINT_MOTOR = 4;
		public const uint CN_JOINT_SPRING = 8;
		public const uint CN_JOINT_BREAKS = 16;

		public const int CN_CONSTRAINT_ANGLE = 0;
		public const int CN_CONSTRAINT_LINE = 1;

		/// <summary>line: the limits along the axis hold</summary>
		public const uint CN_CONSTRAINT_LIMIT = 1;
		public const uint CN_CONSTRAINT_BREAKS = 2;

		/// <summary>the shape is not there</summary>
		public const int CN_QUERY_SKIP = 0;
		public const int CN_QUERY_TAKE = 1;
		public const int CN_QUERY_STOP = 2;

		/// <summary>bodies that a joint connects to ignored_body are not seen either</summary>
		public const uint CN_QUERY_IGNORE_JOINED = 1;
		/// <summary>casts meet one-way shapes from their upper side (45 degrees) only, and not those that they start in by
		/// more than 0.5% of the length unit; all other queries do not see one-way shapes. Default: they are like
		/// others</summary>
		public const uint CN_QUERY_ONE_WAY = 2;
		public const uint CN_QUERY_LEAVING = 4;

		/// <summary>they never come so near; fraction is 1</summary>
		public const int CN_IMPACT_NONE = 0;
		public const int CN_IMPACT_HIT = 1;
		/// <summary>the shapes without their radii overlap at the start: fraction 0, no normal</summary>
		public const int CN_IMPACT_OVERLAP = 2;
		public const int CN_IMPACT_FAILED = 3;

		public const uint CN_MOVER_DROP = 1;

		public const uint CN_MOVER_ON_GROUND = 1;
		/// <summary>touches what is too steep to walk on</summary>
		public const uint CN_MOVER_ON_WALL = 2;
		public const uint CN_MOVER_ON_CEILING = 4;

		public const uint CN_DRAW_SHAPES = 1;
		/// <summary>and constraints: anchors, axes, limits</summary>
		public const uint CN_DRAW_JOINTS = 2;
		public const uint CN_DRAW_CONTACTS = 4;
		public const uint CN_DRAW_AABBS = 8;
		public const uint CN_DRAW_CENTERS = 16;
		public const uint CN_DRAW_ISLANDS = 32;

		/// <summary>Version as major * 1000000 + minor * 1000 + patch.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_version();

		/// <summary>CN_ABI_VERSION of the library that was linked; a binding compares it with its own.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_abi_version();

		/// <summary>Static English text for a result code, never NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern byte* cn_result_text(int result);

		/// <summary>sizeof the struct named by a CN_TYPE_ constant, 0 for an unknown one: bindings check themselves.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_sizeof(int type);

		/// <summary>Defaults as given beside the fields (those that scale with the length unit are stored as 0 and resolved
		/// by cn_world_create: 0 means the default there).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_world_def_init(cn_world_def* def);

		/// <summary>Says in one sentence what is wrong with a definition; writes at most text_bytes bytes including the
		/// terminating zero; text may be NULL when text_bytes is 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_def_check(cn_world_def* def, byte* text, int text_bytes);

		/// <summary>Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL
		/// here.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_bytes_needed(cn_world_def* def, ulong* out_bytes);

		/// <summary>Threads that cannot be started are CN_ERROR_MEMORY. A world's memory holds some 150 bytes for each;
		/// their stacks, and whatever else a thread needs, are the system's, for a world in a caller's block too. A
		/// library built with CN_NO_THREADS, or on a system whose threads it does not know, makes the same world
		/// without them: see cn_world_get_worker_count.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_create(cn_world_def* def, cn_world** out_world);

		/// <summary>NULL is allowed. Frees everything; a world in a caller's block just stops using it. Its own threads have
		/// ended when this returns. Not from callbacks.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_world_destroy(cn_world* world);

		/// <summary>One fixed step of dt_s seconds, 0 &lt;= dt_s &lt;= 1; 0 updates contacts and events without motion, and
		/// so does less than 1e-9. Cost grows with the number of awake bodies and their contacts.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_step(cn_world* world, float dt_s);

		/// <summary>One sentence on the last call that failed on this world; "" if none did. world may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern byte* cn_world_error_text(cn_world* world);

		/// <summary>A change wakes every body: O(bodies) then.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_gravity(cn_world* world, float gravity_x_mps2, float gravity_y_mps2);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_gravity(cn_world* world, cn_vec2* out_mps2);

		/// <summary>1 to 64; more substeps are stiffer and dearer.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_substep_count(cn_world* world, int count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_substep_count(cn_world* world, int* out_count);

		/// <summary>CN_SOLVER_*, from the next step on. A world in a caller's block has scratch memory for the solver that
		/// it was made with: a dearer one may have to do without direct solving there (CN_WARNING_FRAME_MEMORY).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_solver(cn_world* world, int solver);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_solver(cn_world* world, int* out_solver);

		/// <summary>Both as in cn_world_def; 0 metres: the default. get gives the accuracy in metres that this stands for.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_accuracy(cn_world* world, float accuracy_m, int work_budget);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_accuracy(cn_world* world, float* out_accuracy_m, int* out_work_budget);

		/// <summary>Workers that a step may have: 1, or worker_count where the library can have several.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_worker_count(cn_world* world, int* out_count);

		/// <summary>Replaces the CN_WORLD_ flags. Turning CN_WORLD_SLEEP off wakes everything: O(bodies) then.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_flags(cn_world* world, uint flags);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_flags(cn_world* world, uint* out_flags);

		/// <summary>Metres a second, &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_restitution_threshold(cn_world* world, float speed_mps);

		/// <summary>Both &gt; 0: bodies are slowed to these at the end of each step (direction kept).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_speed_limits(cn_world* world, float linear_mps, float angular_radps);

		/// <summary>speed_mps &gt;= 0, delay_s &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_sleep(cn_world* world, float speed_mps, float delay_s);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_user_data(cn_world* world, ulong user_data);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_user_data(cn_world* world, ulong* out_user_data);

		/// <summary>Handles of everything alive, in a fixed order (by slot). Writes at most capacity of them (out may be
		/// NULL when capacity is 0) and always sets *out_count to how many there are. O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_bodies(cn_world* world, cn_body* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_shapes(cn_world* world, cn_shape* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_joints(cn_world* world, cn_joint* @out, int capacity, int* out_count);

		/// <summary>O(bodies + islands).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_counters(cn_world* world, cn_counters* @out);

		/// <summary>Of every awake island, as cn_counters.islands_awake counts them: those of several bodies first, in a
		/// deterministic order, then bodies alone. Writes at most capacity; *out_count is how many there are. Costs
		/// nothing when it is not called. O(bodies + what touches in the islands written).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_islands(cn_world* world, cn_island_report* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_profile(cn_world* world, cn_profile* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_memory_stats(cn_world* world, cn_memory_stats* @out);

		/// <summary>64-bit hash (FNV-1a, Fowler/Noll/Vo) of every body's pose, velocity and sleep state and every contact's
		/// impulses in handle order: equal for equal histories on every compiler, CPU and thread count. O(bodies +
		/// contacts).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_hash(cn_world* world, ulong* out_hash);

		/// <summary>Checks every invariant between the tables. CN_OK, or CN_ERROR_INTERNAL with a sentence in text (at most
		/// text_bytes bytes with the zero; may be NULL when text_bytes is 0). O(everything).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_validate(cn_world* world, byte* text, int text_bytes);

		/// <summary>Bytes that cn_world_save needs now. From callbacks CN_ERROR_LOCKED. O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_save_size(cn_world* world, ulong* out_bytes);

		/// <summary>Writes the state to out, which may have any alignment, and how many bytes that took to out_bytes (may be
		/// NULL). capacity: bytes that out has; too few are CN_ERROR_CAPACITY. From callbacks CN_ERROR_LOCKED.
		/// O(memory of the world), about 1 KB a body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_save(cn_world* world, void* @out, ulong capacity, ulong* out_bytes);

		/// <summary>Puts a state back: into the world that was saved, or one that was made by the same definition
		/// (broadphase, length unit, whether it lives in a caller's block; else CN_ERROR_STATE). bytes: as many as
		/// cn_world_save wrote. CN_ERROR_FORMAT: not a save of this version and machine, or damaged.
		/// CN_ERROR_MEMORY: no room for what was alive then; a growing world takes what it needs, a world in a
		/// caller's block has room for what it had. Arrays handed out before are void. O(memory of the world).
		/// Handles of what was alive when the world was saved are valid again, also of what was destroyed since.
		/// Those made since are refused, until the same handle is given to something new: with the same calls to
		/// the same thing. A game rolls its own state back with the world, and so keeps none of them.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_restore(cn_world* world, void* save, ulong bytes);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_body_def_init(cn_body_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_create(cn_world* world, cn_body_def* def, cn_body* out_body);

		/// <summary>count bodies from an array of definitions; all of them or none. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_create_many(cn_world* world, cn_body_def* defs, int count, cn_body* out_bodies);

		/// <summary>Also destroys its shapes, contacts, joints and constraints; touching contacts get their leave event,
		/// joints and constraints theirs (cn_world_joint_events).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_destroy(cn_world* world, cn_body body);

		/// <summary>Destroys all or, if any handle is bad or appears twice, none.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_destroy_many(cn_world* world, cn_body* bodies, int count);

		/// <summary>1 if the handle names a body that is alive in this world, else 0 (also for a NULL world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_is_valid(cn_world* world, cn_body body);

		/// <summary>Changing the type ends the body's contacts (those that still overlap begin again in the next step), its
		/// forces and any mass override, and wakes it; a body made static stops. CN_ERROR_STATE if a joint would be
		/// left without a dynamic body. O(contacts + joints + shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_type(cn_world* world, cn_body body, int type);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_type(cn_world* world, cn_body body, int* out_type);

		/// <summary>Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which is cn_body_set_awake's and is ignored here. A
		/// body without CN_BODY_ENABLED keeps its shapes but collides with nothing and does not move; its contacts
		/// end, its joints rest. O(contacts + joints + shapes) when that changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_flags(cn_world* world, cn_body body, uint flags);

		/// <summary>CN_BODY_AWAKE is set in the result when the body is awake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_flags(cn_world* world, cn_body body, uint* out_flags);

		/// <summary>0 puts the body and everything connected to it to sleep, at rest; anything else wakes. Does nothing to
		/// static and disabled bodies. O(island).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_awake(cn_world* world, cn_body body, int awake);

		/// <summary>Teleport: origin and angle; velocities stay. Contacts that are no longer near end (the next step reports
		/// it). Wakes the body and what is near it. O(contacts + shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_pose(cn_world* world, cn_body body, float position_x_m, float position_y_m, float angle_rad);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_pose(cn_world* world, cn_body body, cn_pose* @out);

		/// <summary>In (-pi, pi].</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_angle(cn_world* world, cn_body body, float* out_rad);

		/// <summary>World position of the centre of mass.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_center(cn_world* world, cn_body body, cn_vec2* out_m);

		/// <summary>Static bodies refuse this with CN_ERROR_STATE. Wakes when not zero.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_velocity(cn_world* world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_velocity(cn_world* world, cn_body body, cn_velocity* @out);

		/// <summary>Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes
		/// it to this pose, the shorter way round, up to rounding and the world's speed limits: what stands on it
		/// or is in its way moves along, as nothing does with cn_body_set_pose. It goes on with that velocity: call
		/// it before every step, or stop it after.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_target_pose(cn_world* world, cn_body body, float position_x_m, float position_y_m, float angle_rad, float dt_s);

		/// <summary>Velocity of the body's material at a world point.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_velocity_at(cn_world* world, cn_body body, float point_x_m, float point_y_m, cn_vec2* out_mps);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_world_point(cn_world* world, cn_body body, float local_x_m, float local_y_m, cn_vec2* out_m);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_local_point(cn_world* world, cn_body body, float world_x_m, float world_y_m, cn_vec2* out_m);

		/// <summary>Union of its shapes' boxes, without margin; the origin as a point if it has none. O(shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_aabb(cn_world* world, cn_body body, cn_aabb* @out);

		/// <summary>Forces and torques act for the next step only and are then cleared. All of these wake a dynamic body and
		/// do nothing to static, kinematic and disabled ones (CN_OK). Sums of forces and velocities after impulses
		/// must stay finite (CN_ERROR_ARGUMENT).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_force(cn_world* world, cn_body body, float force_x_N, float force_y_N);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_force_at(cn_world* world, cn_body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_torque(cn_world* world, cn_body body, float torque_Nm);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_impulse(cn_world* world, cn_body body, float impulse_x_Ns, float impulse_y_Ns);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_impulse_at(cn_world* world, cn_body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_angular_impulse(cn_world* world, cn_body body, float impulse_Nms);

		/// <summary>Sums over the attached shapes unless overridden. A dynamic body whose shapes have no mass weighs 1 kg
		/// (and, having no shape, does not rotate).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_mass_data(cn_world* world, cn_body body, cn_mass_data* @out);

		/// <summary>Override for a dynamic body (others: CN_ERROR_STATE): mass_kg from 1e-20 to 1e20, inertia_kgm2 0 (never
		/// rotates) or from 1e-35 to 1e35. Kept until cn_body_reset_mass_data or until the type changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_mass_data(cn_world* world, cn_body body, cn_mass_data* mass);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_reset_mass_data(cn_world* world, cn_body body);

		/// <summary>Both &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_damping(cn_world* world, cn_body body, float linear_per_s, float angular_per_s);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_damping(cn_world* world, cn_body body, float* out_linear_per_s, float* out_angular_per_s);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_gravity_scale(cn_world* world, cn_body body, float scale);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_gravity_scale(cn_world* world, cn_body body, float* out_scale);

		/// <summary>&gt;= 0; 0 restores the world's.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_sleep_speed(cn_world* world, cn_body body, float speed_mps);

		/// <summary>How the island of a dynamic body is solved, in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
		/// (default): as the world chooses. _SOFT: never directly, contacts and all, whatever its other bodies ask
		/// for. _DIRECT: always, however fast it moves, as far as its contacts can be, and within the work_budget.
		/// From the next step on; does not wake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_solver(cn_world* world, cn_body body, int solver);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_solver(cn_world* world, cn_body body, int* out_solver);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_user_data(cn_world* world, cn_body body, ulong user_data);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_user_data(cn_world* world, cn_body body, ulong* out_user_data);

		/// <summary>NULL or "" removes the name.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_name(cn_world* world, cn_body body, byte* name);

		/// <summary>"" if it has none; valid until the name changes or the body is destroyed.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_name(cn_world* world, cn_body body, byte** out_name);

		/// <summary>As cn_world_get_bodies, for one body. O(shapes), O(joints).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_shapes(cn_world* world, cn_body body, cn_shape* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_joints(cn_world* world, cn_body body, cn_joint* @out, int capacity, int* out_count);

		/// <summary>Bulk forms: bodies NULL means every body in the order of cn_world_get_bodies, of which there must be
		/// exactly count. stride_bytes 0 means tightly packed. One bad handle fails the whole call. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_poses(cn_world* world, cn_body* bodies, int count, cn_pose* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_poses_strided(cn_world* world, cn_body* bodies, int count, void* @out, int stride_bytes);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_velocities(cn_world* world, cn_body* bodies, int count, cn_velocity* @out);

		/// <summary>cn_body_set_velocity for many; nothing is written if one is bad. Static bodies take zero only.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_write_velocities(cn_world* world, cn_body* bodies, int count, cn_velocity* velocities);

		/// <summary>Bodies whose pose changed in the last step, and those that fell asleep in it, without the ones destroyed
		/// since. Built on the first call after a step: O(awake bodies) then.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_moved(cn_world* world, cn_body_moved** out_moved, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_shape_def_init(cn_shape_def* def);

		/// <summary>out_shape may be NULL in all of these. Points closer than 0.05% of the length unit are degenerate.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_circle(cn_world* world, cn_shape_def* def, cn_circle* circle, cn_shape* out_shape);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_capsule(cn_world* world, cn_shape_def* def, cn_capsule* capsule, cn_shape* out_shape);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_edge(cn_world* world, cn_shape_def* def, cn_edge* edge, cn_shape* out_shape);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_polygon(cn_world* world, cn_shape_def* def, cn_polygon* polygon, cn_shape* out_shape);

		/// <summary>Half sizes &gt; 0; radius_m &gt;= 0 is added outside of them.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_box(cn_world* world, cn_shape_def* def, float half_width_m, float half_height_m, float radius_m, cn_shape* out_shape);

		/// <summary>O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_chain(cn_world* world, cn_shape_def* def, cn_chain* chain, cn_shape* out_shape);

		/// <summary>An unattached shape joins a body (CN_ERROR_STATE if it already has one), an attached one leaves it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_attach(cn_world* world, cn_shape shape, cn_body body);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_detach(cn_world* world, cn_shape shape);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_destroy(cn_world* world, cn_shape shape);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_is_valid(cn_world* world, cn_shape shape);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_type(cn_world* world, cn_shape shape, int* out_type);

		/// <summary>0 if unattached.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_body(cn_world* world, cn_shape shape, cn_body* out_body);

		/// <summary>Takes effect at once, on resting contacts too (their bodies wake).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_material(cn_world* world, cn_shape shape, cn_material* material);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_material(cn_world* world, cn_shape shape, cn_material* @out);

		/// <summary>&gt;= 0; the body's mass follows at once.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_density(cn_world* world, cn_shape shape, float density_kgpm2);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_density(cn_world* world, cn_shape shape, float* out_kgpm2);

		/// <summary>Contacts that it forbids end at once (with their events); ones that it allows begin in the next step.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_filter(cn_world* world, cn_shape shape, cn_filter* filter);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_filter(cn_world* world, cn_shape shape, cn_filter* @out);

		/// <summary>Takes effect at once, for present contacts too.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_event_mask(cn_world* world, cn_shape shape, uint event_mask);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_event_mask(cn_world* world, cn_shape shape, uint* out_event_mask);

		/// <summary>Replaces the CN_SHAPE_ flags (SENSOR ...). Contacts end and begin anew as needed.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_flags(cn_world* world, cn_shape shape, uint flags);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_flags(cn_world* world, cn_shape shape, uint* out_flags);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_user_data(cn_world* world, cn_shape shape, ulong user_data);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_user_data(cn_world* world, cn_shape shape, ulong* out_user_data);

		/// <summary>Without margin, in world space (in shape space when unattached). O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_aabb(cn_world* world, cn_shape shape, cn_aabb* @out);

		/// <summary>In the body's local frame, at the present density; inertia about the shape's own centre. O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_mass_data(cn_world* world, cn_shape shape, cn_mass_data* @out);

		/// <summary>The shape's geometry in its body's local frame, offset applied. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_circle(cn_world* world, cn_shape shape, cn_circle* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_capsule(cn_world* world, cn_shape shape, cn_capsule* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_edge(cn_world* world, cn_shape shape, cn_edge* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_polygon(cn_world* world, cn_shape shape, cn_polygon* @out);

		/// <summary>Writes at most capacity points (out may be NULL when capacity is 0); *out_count is how many there are.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_chain_points(cn_world* world, cn_shape shape, cn_vec2* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_test_point(cn_world* world, cn_shape shape, float point_x_m, float point_y_m, int* out_inside);

		/// <summary>Convex hull of 1 or more points (farthest points inserted, as in Quickhull: Barber, Dobkin, Huhdanpaa
		/// 1996) of at most CN_POLYGON_MAX_VERTICES, those that add the most area. CN_ERROR_ARGUMENT for fewer than
		/// three distinct points or collinear ones. Details below 5 mm are dropped (below 5% of the half size for
		/// hulls under 0.1 m, below 0.5% for those over 1 m). O(count^2) at worst, count &lt;= 65536.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_make_hull(cn_vec2* points_m, int count, float radius_m, cn_polygon* @out);

		/// <summary>A box of half sizes &gt; 0, moved and then turned about its own centre.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m, cn_polygon* @out);

		/// <summary>The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. They are always
		/// bookended: every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved away,
		/// body or shape destroyed, detached or disabled, filter or type changed). Pairs that end through a call
		/// between two steps are reported by the next step; handles in such events may be stale. Falling asleep is
		/// not leaving: a sleeping pair reports nothing until it wakes, and then goes on where it was. The array is
		/// built on the first request after a step, O(events) then: that may return CN_ERROR_MEMORY, and inside
		/// callbacks CN_ERROR_LOCKED.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_contact_events(cn_world* world, int kind, cn_contact_event** out_events, int* out_count);

		/// <summary>function NULL removes it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_contact_callback(cn_world* world, int kind, IntPtr function, void* user);

		/// <summary>function NULL removes it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_filter_callback(cn_world* world, IntPtr function, void* user);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_pre_solve_callback(cn_world* world, IntPtr function, void* user);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_material_mix_callback(cn_world* world, IntPtr function, void* user);

		/// <summary>Of the last step, in a deterministic order; bookended like contact events. Sensors see dynamic and
		/// kinematic bodies' shapes that are not sensors, by exact overlap.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_sensor_events(cn_world* world, cn_sensor_event** out_events, int* out_count);

		/// <summary>The contacts of a body, touching or not, as events of kind STAY (touching) or CREATED. Writes at most
		/// capacity; *out_count is how many there are. O(contacts).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_contacts(cn_world* world, cn_body body, cn_contact_event* @out, int capacity, int* out_count);

		/// <summary>As cn_body_get_contacts, of one shape, a chain with all its edges. O(contacts of its body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_contacts(cn_world* world, cn_shape shape, cn_contact_event* @out, int capacity, int* out_count);

		/// <summary>The shapes that are in a sensor, each once: those whose ENTER had no LEAVE up to the last step.
		/// CN_ERROR_STATE for a shape that is no sensor. O(contacts of its body), for chains squared.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_visitors(cn_world* world, cn_shape sensor, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Bodies that fell asleep in the last step, or since by cn_body_set_awake; ones destroyed since are stale
		/// handles.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_fell_asleep(cn_world* world, cn_body** out_bodies, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_revolute_def_init(cn_revolute_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_distance_def_init(cn_distance_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_fixed_def_init(cn_fixed_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_prismatic_def_init(cn_prismatic_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_wheel_def_init(cn_wheel_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_motor_def_init(cn_motor_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_mouse_def_init(cn_mouse_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_gear_def_init(cn_gear_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_pulley_def_init(cn_pulley_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_ratchet_def_init(cn_ratchet_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_rotary_spring_def_init(cn_rotary_spring_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_groove_def_init(cn_groove_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_filter_joint_def_init(cn_filter_joint_def* def);

		/// <summary>Wake both bodies. CN_ERROR_ARGUMENT for a body with itself or without a dynamic body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_revolute(cn_world* world, cn_revolute_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_distance(cn_world* world, cn_distance_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_fixed(cn_world* world, cn_fixed_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_prismatic(cn_world* world, cn_prismatic_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_wheel(cn_world* world, cn_wheel_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_motor(cn_world* world, cn_motor_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_mouse(cn_world* world, cn_mouse_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_gear(cn_world* world, cn_gear_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_pulley(cn_world* world, cn_pulley_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_ratchet(cn_world* world, cn_ratchet_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_rotary_spring(cn_world* world, cn_rotary_spring_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_groove(cn_world* world, cn_groove_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_filter(cn_world* world, cn_filter_joint_def* def, cn_joint* out_joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_destroy(cn_world* world, cn_joint joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_is_valid(cn_world* world, cn_joint joint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_type(cn_world* world, cn_joint joint, int* out_type);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_bodies(cn_world* world, cn_joint joint, cn_body* out_a, cn_body* out_b);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_anchors(cn_world* world, cn_joint joint, cn_vec2* out_world_a_m, cn_vec2* out_world_b_m);

		/// <summary>Force in newtons and torque in newton metres that the joint put on body b in the last substep.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_reaction(cn_world* world, cn_joint joint, cn_vec2* out_force_N, float* out_torque_Nm);

		/// <summary>How far the joint's rigid parts are from being satisfied: metres (anchors, lengths beyond limits) and
		/// radians (angles beyond limits), both &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_error(cn_world* world, cn_joint joint, float* out_m, float* out_rad);

		/// <summary>In worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default): the joint is solved together with its
		/// neighbours where that is cheap. _SOFT: always by itself. _DIRECT: together with all joints that it hangs
		/// together with, for as much work as CN_SOLVER_DIRECT takes, within the work_budget. In a world in a
		/// caller's block that was not made with CN_SOLVER_DIRECT, _DIRECT is _AUTO. From the next step on; does
		/// not wake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_solver(cn_world* world, cn_joint joint, int solver);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_solver(cn_world* world, cn_joint joint, int* out_solver);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_user_data(cn_world* world, cn_joint joint, ulong user_data);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_user_data(cn_world* world, cn_joint joint, ulong* out_user_data);

		/// <summary>Replaces the CN_JOINT_ flags. Wakes. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_flags(cn_world* world, cn_joint joint, uint flags);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_flags(cn_world* world, cn_joint joint, uint* out_flags);

		/// <summary>Read back or replace a definition. set leaves bodies and anchors as they are and ignores struct_size;
		/// all else is taken, flags and user data too. CN_ERROR_STATE for a joint of another type. set wakes. A
		/// filter joint has nothing but its base.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_revolute(cn_world* world, cn_joint joint, cn_revolute_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_revolute(cn_world* world, cn_joint joint, cn_revolute_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_distance(cn_world* world, cn_joint joint, cn_distance_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_distance(cn_world* world, cn_joint joint, cn_distance_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_fixed(cn_world* world, cn_joint joint, cn_fixed_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_fixed(cn_world* world, cn_joint joint, cn_fixed_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_prismatic(cn_world* world, cn_joint joint, cn_prismatic_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_prismatic(cn_world* world, cn_joint joint, cn_prismatic_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_wheel(cn_world* world, cn_joint joint, cn_wheel_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_wheel(cn_world* world, cn_joint joint, cn_wheel_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_motor_to(cn_world* world, cn_joint joint, cn_motor_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_motor_to(cn_world* world, cn_joint joint, cn_motor_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_mouse(cn_world* world, cn_joint joint, cn_mouse_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_mouse(cn_world* world, cn_joint joint, cn_mouse_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_gear(cn_world* world, cn_joint joint, cn_gear_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_gear(cn_world* world, cn_joint joint, cn_gear_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_pulley(cn_world* world, cn_joint joint, cn_pulley_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_pulley(cn_world* world, cn_joint joint, cn_pulley_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_ratchet(cn_world* world, cn_joint joint, cn_ratchet_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_ratchet(cn_world* world, cn_joint joint, cn_ratchet_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_rotary_spring(cn_world* world, cn_joint joint, cn_rotary_spring_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_rotary_spring(cn_world* world, cn_joint joint, cn_rotary_spring_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_groove(cn_world* world, cn_joint joint, cn_groove_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_groove(cn_world* world, cn_joint joint, cn_groove_def* def);

		/// <summary>The base of any joint.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_base(cn_world* world, cn_joint joint, cn_joint_base* @out);

		/// <summary>Takes stiffness, most force and torque, and break thresholds; the rest of base is ignored. Wakes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_base(cn_world* world, cn_joint joint, cn_joint_base* @base);

		/// <summary>Mouse joint: where to drag to; called each frame. CN_ERROR_STATE for another type. Wakes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_target(cn_world* world, cn_joint joint, float target_x_m, float target_y_m);

		/// <summary>Revolute, fixed, motor: the angle b - angle a - reference (motor: without one), in (-pi, pi]. Distance,
		/// pulley: the present length. Prismatic, wheel, groove: the translation along the axis. Mouse: distance to
		/// the target. Gear: angle b - ratio * angle a; ratchet, rotary spring: angle b - angle a, these three over
		/// whole turns.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_position(cn_world* world, cn_joint joint, float* out_position);

		/// <summary>How fast that changes; but of a wheel how fast b turns against a. With CN_JOINT_MOTOR, positive follows
		/// these.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_speed(cn_world* world, cn_joint joint, float* out_speed);

		/// <summary>The two setters that games call each frame, for revolute, distance, prismatic and wheel (others:
		/// CN_ERROR_STATE). Wake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_motor(cn_world* world, cn_joint joint, float speed, float force_or_torque_max);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_limits(cn_world* world, cn_joint joint, float lower, float upper);

		/// <summary>Those that exceeded a break threshold in the last step, and those destroyed with a body in or since the
		/// step before (by calls between two steps: reported by the next step).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_joint_events(cn_world* world, cn_joint_event** out_events, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_angle_constraint_def_init(cn_angle_constraint_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_line_constraint_def_init(cn_line_constraint_def* def);

		/// <summary>They are solved with the joints, before contacts. Wake the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_create_angle(cn_world* world, cn_angle_constraint_def* def, cn_constraint* out_constraint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_create_line(cn_world* world, cn_line_constraint_def* def, cn_constraint* out_constraint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_destroy(cn_world* world, cn_constraint constraint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_is_valid(cn_world* world, cn_constraint constraint);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_type(cn_world* world, cn_constraint constraint, int* out_type);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_body(cn_world* world, cn_constraint constraint, cn_body* out_body);

		/// <summary>Read back or replace a definition; set ignores body. CN_ERROR_STATE for the other type. set wakes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_angle(cn_world* world, cn_constraint constraint, cn_angle_constraint_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_set_angle(cn_world* world, cn_constraint constraint, cn_angle_constraint_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_line(cn_world* world, cn_constraint constraint, cn_line_constraint_def* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_set_line(cn_world* world, cn_constraint constraint, cn_line_constraint_def* def);

		/// <summary>Angle: the angle over whole turns. Line: where along the axis the point is, from origin.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_position(cn_world* world, cn_constraint constraint, float* out_position);

		/// <summary>Force in newtons and torque in newton metres that it put on the body in the last substep.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_reaction(cn_world* world, cn_constraint constraint, cn_vec2* out_force_N, float* out_torque_Nm);

		/// <summary>How far beyond what is allowed, &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_error(cn_world* world, cn_constraint constraint, float* out_m, float* out_rad);

		/// <summary>As cn_world_get_joints and cn_body_get_joints, which do not list constraints.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_constraints(cn_world* world, cn_constraint* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_constraints(cn_world* world, cn_body body, cn_constraint* @out, int capacity, int* out_count);

		/// <summary>step_s in (0, 1], default 1/60; steps_max &gt;= 1, default 8.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_fixed_step(cn_world* world, float step_s, int steps_max);

		/// <summary>Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max.
		/// Events of all steps but the last are only seen by callbacks. out may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_update(cn_world* world, float elapsed_s, cn_update_report* @out);

		/// <summary>Poses between the last two steps of cn_world_update: factor 0 the one before, 1 the last. bodies as in
		/// cn_world_read_poses. Bodies that did not take part in the last step have their present pose.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_poses_interpolated(cn_world* world, cn_body* bodies, int count, float factor, cn_pose* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_query_filter_init(cn_query_filter* filter);

		/// <summary>Nearest hit; out-&gt;shape is 0 when there is none. An edge is hit from both sides, a chain from its
		/// front only. Of equal hits the first by shape (as in cn_world_get_shapes), then child. filter may be NULL
		/// in all queries: the defaults. O(log) to O(shapes along the ray).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_ray(cn_world* world, cn_ray* ray, cn_query_filter* filter, cn_ray_hit* @out);

		/// <summary>1 if anything is hit: cheaper than the nearest.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_ray_any(cn_world* world, cn_ray* ray, cn_query_filter* filter, int* out_hit);

		/// <summary>Up to capacity hits, nearest first (the nearest ones if there are more); *out_count is how many were
		/// found. A chain is hit once by each edge on the way.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_ray_all(cn_world* world, cn_ray* ray, cn_query_filter* filter, cn_ray_hit* @out, int capacity, int* out_count);

		/// <summary>count rays, the nearest hit of each; nothing is written if one of them is bad.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_rays(cn_world* world, cn_ray* rays, int count, cn_query_filter* filter, cn_ray_hit* @out);

		/// <summary>Against one shape alone, whatever its filter, in shape space when unattached. O(edges of a chain).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_cast_ray(cn_world* world, cn_shape shape, cn_ray* ray, cn_ray_hit* @out);

		/// <summary>A polygon (its points in world coordinates; count may be 1 or 2 too, with radius &gt; 0: circle,
		/// capsule) moved by translation without turning: the first shape it meets. A chain is met by what has the
		/// mean of its points in front.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_shape(cn_world* world, cn_polygon* shape, float translation_x_m, float translation_y_m, cn_query_filter* filter, cn_ray_hit* @out);

		/// <summary>Shapes that overlap a region: at most capacity handles are written (the first ones), *out_count is how
		/// many there are, in the order of cn_world_get_shapes. The first is by the shapes' boxes without margin,
		/// the others exact. A chain is listed once; edges and chains are lines here, seen from both sides, and
		/// contain no point. Polygons as in cn_world_cast_shape. O(log) to O(boxes in the region).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_aabb(cn_world* world, cn_aabb* box, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_circle(cn_world* world, cn_circle* circle, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_polygon(cn_world* world, cn_polygon* polygon, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_point(cn_world* world, float x_m, float y_m, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		/// <summary>The shape nearest to a point within distance_max_m (0 to 4e6 length units), the deepest if the point is
		/// in several. Cost grows with what is near, not with distance_max_m.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_closest_point(cn_world* world, float x_m, float y_m, float distance_max_m, cn_query_filter* filter, cn_closest* @out);

		/// <summary>By GJK (Gilbert, Johnson, Keerthi 1988) when the shapes without their radii are apart, else by their
		/// Minkowski difference.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_distance(cn_polygon* a, cn_pose* pose_a, cn_polygon* b, cn_pose* pose_b, cn_distance* @out);

		/// <summary>b is moved by translation (at most 2e6 m each way) without turning: where it meets a, as cn_ray_hit
		/// says, without shape, body and child; 1 in *out_hit, or 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_cast(cn_polygon* a, cn_pose* pose_a, cn_polygon* b, cn_pose* pose_b, float translation_x_m, float translation_y_m, cn_ray_hit* @out, int* out_hit);

		/// <summary>The contact of a step: no points when they are farther apart than margin_m (0 to 1e6). Impulses are 0.
		/// Not for a single point of radius 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_collide(cn_polygon* a, cn_pose* pose_a, cn_polygon* b, cn_pose* pose_b, float margin_m, cn_manifold* @out);

		/// <summary>When two shapes that move and turn first come within distance_m (0 to 1e6) of each other; fraction 0 for
		/// those that start nearer. Conservative advancement (Mirtich 1996) along fixed axes (Catto, GDC 2013) that
		/// never passes by a hit.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_time_of_impact(cn_polygon* a, cn_sweep* sweep_a, cn_polygon* b, cn_sweep* sweep_b, float distance_m, cn_impact* @out);

		/// <summary>The planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved by
		/// position: how they touch it, as in a step, rigid. At most capacity, those of least separation first;
		/// *out_count is how many there are. Sensors are no surfaces. With CN_QUERY_ONE_WAY a one-way shape is one
		/// only from its upper side, and only for what is no deeper in it than 0.5% of the length unit and what it
		/// rose by in the last step. A shape wholly behind another one's plane is left out: it cannot be met while
		/// that plane holds, so that the seams of tiles do not catch (not done when capacity is too small for all).
		/// O(shapes near, squared).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_collide(cn_world* world, cn_polygon* shape, float position_x_m, float position_y_m, float margin_m, cn_query_filter* filter, cn_plane* @out, int capacity, int* out_count);

		/// <summary>The translation nearest to a wanted one that the planes allow: exactly, for in two dimensions it lies on
		/// at most two of them. A plane pushes by no more than push_max_m: which ones push their most, Hildreth's
		/// method (1957) tells. Sets push_m. Between surfaces that leave no room it is that of the least sum of
		/// squared overlaps (Cimmino 1938), and *out_overlap_m, else 0 up to rounding, says how deep the deepest of
		/// them remains that did not push its most. count 0 to CN_PLANES_MAX. No world. O(count^2), O(count^3)
		/// where two planes hold it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_solve(cn_plane* planes, int count, float translation_x_m, float translation_y_m, cn_vec2* out_translation_m, float* out_overlap_m);

		/// <summary>The velocity nearest to a given one that leads into none of the planes that pushed in the last
		/// cn_mover_solve. No world.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_clip(cn_plane* planes, int count, float velocity_x_mps, float velocity_y_mps, cn_vec2* out_mps);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_mover_def_init(cn_mover_def* def);

		/// <summary>Moves a character by dt_s (0 &lt; dt_s &lt;= 1). Call it after each cn_world_step, or it is a step
		/// behind what carries it. 1. carried   by what its ground did since the last move: the change of the place
		/// in ground_body where it stood, conveyors too 2. walking   on the ground: velocity_mps across up, along
		/// the ground, as fast uphill as downhill; no gravity, so that it does not creep. Where something too steep
		/// is in the way, a step up: up by step_height_m, forward, down on what can be walked on flying    in the
		/// air: velocity_mps and gravity (exact for constant gravity). Jumping and walking off take
		/// ground_velocity_mps along 3. sliding   both by collision planes, cn_mover_solve and casts, up to
		/// iterations_max times: no speed passes through a wall 4. pushing   dynamic bodies in the way get a force
		/// for the next step that brings them to the character's velocity, of at most push_force_N each 5. ground
		/// what it touches and can stand on, or finds within snap_m below when it walked; velocity_mps loses what
		/// is blocked Depends on the world, def and mover alone: the same calls give the same bits. The loop of
		/// planes, solver and cast is that of Box2D 3's sample of a character mover (Catto 2025). Bodies pushed
		/// wake up; nothing else of the world changes. O(shapes near x iterations_max): some 1 us standing, 3 us
		/// walking, 10 us against a wall.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_move(cn_world* world, cn_mover_def* def, float dt_s, cn_mover* mover);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_explosion_def_init(cn_explosion_def* def);

		/// <summary>Pushes dynamic bodies away from the centre, each shape at its point nearest to it, and wakes them.
		/// Velocities must stay finite (CN_ERROR_ARGUMENT). O(shapes in reach).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_explode(cn_world* world, cn_explosion_def* def);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_debug_draw_init(cn_debug_draw* draw);

		/// <summary>Reads only. O(what is drawn).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_draw(cn_world* world, cn_debug_draw* draw);

		/// <summary>Dynamic AABB tree. alloc and free NULL: malloc. margin_m &gt;= 0 is added around every box.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_create(float margin_m, IntPtr alloc, IntPtr free, void* allocator_user, cn_tree** out_tree);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_tree_destroy(cn_tree* tree);

		/// <summary>O(log n). *out_item is never 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_insert(cn_tree* tree, cn_aabb* box, ulong user_data, uint* out_item);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_remove(cn_tree* tree, uint item);

		/// <summary>Nothing happens while the box stays within its margin. O(log n) else.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_move(cn_tree* tree, uint item, cn_aabb* box);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_get_box(cn_tree* tree, uint item, cn_aabb* @out);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_query(cn_tree* tree, cn_aabb* box, IntPtr visit, void* user);

		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_cast_ray(cn_tree* tree, cn_ray* ray, IntPtr visit, void* user);

		/// <summary>Number of items and height of the tree.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_get_stats(cn_tree* tree, int* out_count, int* out_height);
	}
}
