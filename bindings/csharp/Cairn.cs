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

	/// <summary>Memory hook: allocates bytes aligned to align, a power of two of at most 64; returns NULL when there is
	/// no memory. Called only from inside functions that take a non-const world.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void* cn_alloc_fn(ulong bytes, uint align, void* user);

	/// <summary>Memory hook: frees memory of cn_alloc_fn; bytes is the size it was allocated with.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_free_fn(void* memory, ulong bytes, void* user);

	/// <summary>The library's part of a user's task system (cn_world_def.enqueue and finish, for worlds with worker_count
	/// of 2 or more; without them the world starts its own threads). Call it for ranges [begin, end) that
	/// together cover 0 to item_count - 1, each item once, on any threads, in any order. A call may last as long
	/// as the step and may wait for calls that have begun, never for one that has not. Its thread must have the
	/// floating-point mode of the stepping thread.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_task_fn(int begin, int end, void* context);

	/// <summary>Starts a task of item_count items (worker_count - 1) in ranges of at least min_range and returns a handle
	/// for finish. It may run the whole task at once, and must do so if it cannot store the task; it then
	/// returns NULL, and finish is not called. A step with enough work enqueues 3 to 10 tasks; enqueue and
	/// finish run in the stepping thread, never during a callback, and must not call the library.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void* cn_enqueue_fn(IntPtr task, void* context, int item_count, int min_range, void* user);

	/// <summary>Returns when every item of the task has run; it may run items itself. Called once for each enqueue that
	/// did not return NULL, in the thread that enqueued.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_finish_fn(void* task, void* user);

	/// <summary>Called at the end of cn_world_step for each event of this kind, in the order of the array.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_contact_event_fn(cn_world* world, cn_contact_event* @event, void* user);

	/// <summary>Returns 1 if two shapes that pass their filters may touch, else 0. Called when their boxes begin to
	/// overlap; the world is locked.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_filter_fn(cn_world* world, cn_shape shape_a, cn_shape shape_b, void* user);

	/// <summary>Called in every step, before solving, for each touching pair in which a shape has CN_SHAPE_PRE_SOLVE; the
	/// event's kind is STAY or ENTER. Returns 0 to let the pair pass through each other in this step, else 1.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_pre_solve_fn(cn_world* world, cn_contact_event* contact, void* user);

	/// <summary>Mixes two materials instead of the CN_MIX_ rules: *mixed holds the rules' result and takes the new one.
	/// Called when a pair begins to touch and when a material changes.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_material_mix_fn(cn_world* world, cn_shape shape_a, cn_shape shape_b, cn_material* mixed, void* user);

	/// <summary>Called by a query for each shape (edge of a chain) found, in no particular order and perhaps more than
	/// once: the result, CN_QUERY_*, must depend on the shape alone. hit is complete in casts; other queries set
	/// shape, body and child. May call only functions that take a const world, also of the same world.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_query_fn(cn_world* world, cn_ray_hit* hit, void* user);

	/// <summary>count points, counter-clockwise</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_polygon_fn(cn_vec2* points_m, int count, float radius_m, uint color, void* user);

	/// <summary>rim_m: a point on the rim that turns with the body</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_circle_fn(cn_vec2* center_m, float radius_m, cn_vec2* rim_m, uint color, void* user);

	/// <summary>a disc swept from a to b</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_capsule_fn(cn_vec2* a_m, cn_vec2* b_m, float radius_m, uint color, void* user);

	/// <summary>a line from a to b</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_segment_fn(cn_vec2* a_m, cn_vec2* b_m, uint color, void* user);

	/// <summary>size in pixels</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_point_fn(cn_vec2* point_m, float size_px, uint color, void* user);

	/// <summary>zero-terminated, valid during the call</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate void cn_debug_draw_text_fn(cn_vec2* point_m, byte* text, uint color, void* user);

	/// <summary>Returns 0 to stop the search, any other value to continue.</summary>
	[UnmanagedFunctionPointer(CallingConvention.Cdecl)]
	public unsafe delegate int cn_tree_query_fn(uint item, ulong user_data, void* user);

	/// <summary>Returns the fraction at which the ray now ends: the given one to ignore the item, 0 to stop.</summary>
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

	/// <summary>A point, vector or pair of numbers.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_vec2
	{
		/// <summary>to the right</summary>
		public float x;
		/// <summary>upwards</summary>
		public float y;
	}

	/// <summary>Position of a body's origin and its rotation as (cosine, sine). 16 bytes: an array of poses can be
	/// uploaded to a GPU directly.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_pose
	{
		/// <summary>of the body's origin</summary>
		public cn_vec2 position_m;
		/// <summary>of the angle</summary>
		public float cosine;
		/// <summary>of the angle</summary>
		public float sine;
	}

	/// <summary>Velocity of a body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_velocity
	{
		/// <summary>of the centre of mass</summary>
		public cn_vec2 linear_mps;
		/// <summary>counter-clockwise is positive</summary>
		public float angular_radps;
	}

	/// <summary>Axis-aligned bounding box, lower_m &lt;= upper_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_aabb
	{
		/// <summary>left and bottom</summary>
		public cn_vec2 lower_m;
		/// <summary>right and top</summary>
		public cn_vec2 upper_m;
	}

	/// <summary>Mass, inertia and centre of mass.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mass_data
	{
		/// <summary>of all shapes, or as set</summary>
		public float mass_kg;
		/// <summary>about the centre of mass</summary>
		public float inertia_kgm2;
		/// <summary>in the body's local frame</summary>
		public cn_vec2 center_m;
	}

	/// <summary>Definition of a world.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_world_def
	{
		/// <summary>set by the init function</summary>
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
		/// <summary>CN_SOLVER_AUTO aims at errors below this, &gt;= 0; CN_DEFAULT (default): 0.005 x length unit</summary>
		public float accuracy_m;
		/// <summary>limit of direct solving in a step, in factored blocks (joints, contacts and their fill), substeps
		/// included, about 10 ns each; 1 to 1e9; CN_DEFAULT (default): the limits of single islands, and with
		/// CN_SOLVER_AUTO 512 contacts of a world</summary>
		public int work_budget;
		/// <summary>slower impacts do not bounce, &gt;= 0; CN_DEFAULT (default): 1 x length unit</summary>
		public float restitution_threshold_mps;
		/// <summary>greatest speed at which the overlap of two shapes is pushed apart, and a gap of a directly solved joint
		/// closes (of its angles: rad/s, for each length unit), &gt; 0; in a crowd the speeds of neighbours add up:
		/// n bodies made in one spot leave it at some sqrt(n) / 2 times as much, on the ground, which pushes them
		/// upwards, at some sqrt(n) times; CN_DEFAULT (default): 3 x length unit</summary>
		public float push_speed_max_mps;
		/// <summary>faster bodies are slowed to it, &gt; 0; CN_DEFAULT (default): 400 x length unit</summary>
		public float linear_speed_max_mps;
		/// <summary>faster bodies are slowed to it, &gt; 0; default 400</summary>
		public float angular_speed_max_radps;
		/// <summary>bodies slower than this may sleep, &gt;= 0; CN_DEFAULT (default): 0.05 x length unit</summary>
		public float sleep_speed_mps;
		/// <summary>... after this time, &gt;= 0; default 0.5</summary>
		public float sleep_delay_s;
		/// <summary>hints for a growing world; one in a block has room for these, and for more as memory permits; &gt;= 0;
		/// default 0</summary>
		public int body_capacity;
		/// <summary>counts every edge of a chain</summary>
		public int shape_capacity;
		/// <summary>pairs whose fat AABBs overlap</summary>
		public int contact_capacity;
		/// <summary>counts constraints too</summary>
		public int joint_capacity;
		/// <summary>a number for the user; default 0</summary>
		public ulong user_data;
		/// <summary>size of memory; 0: use alloc and free</summary>
		public ulong memory_bytes;
		/// <summary>NULL, or one block aligned to 64 bytes that holds the whole world</summary>
		public void* memory;
		/// <summary>NULL: malloc; set both or none</summary>
		public IntPtr alloc;
		/// <summary>NULL: free</summary>
		public IntPtr free;
		/// <summary>last argument of alloc and free</summary>
		public void* allocator_user;
		/// <summary>NULL: the world's own threads; set both or none</summary>
		public IntPtr enqueue;
		/// <summary>see cn_finish_fn</summary>
		public IntPtr finish;
		/// <summary>last argument of enqueue and finish</summary>
		public void* task_user;
		/// <summary>threads that share a step, including the calling one; 1 to CN_WORKERS_MAX; default 1: no threads, no
		/// tasks</summary>
		public int worker_count;
		/// <summary>blows at least this fast are reported by CN_EVENT_HIT, &gt;= 0; CN_DEFAULT (default): 1 x length unit</summary>
		public float hit_speed_mps;
		/// <summary>Of a world in one block (memory); others ignore them. pairs that touch at once, &gt;= 0; further ones do
		/// not collide: CN_WARNING_CONTACT_MEMORY; CN_DEFAULT (default): contact_capacity</summary>
		public int touching_capacity;
		/// <summary>pairs that report events (event_mask of a shape, sensors), &gt;= 0; further ones report none, which
		/// cn_counters.events_not_reported counts; CN_DEFAULT (default): contact_capacity</summary>
		public int event_capacity;
		/// <summary>vertices of a polygon, 3 to CN_POLYGON_MAX_VERTICES; larger ones take what is left of the block; default
		/// CN_POLYGON_MAX_VERTICES</summary>
		public int vertex_capacity;
		/// <summary>CN_RESERVE_*: what else the block has room for; the rest takes what is left of it; default all</summary>
		public uint reserve;
	}

	/// <summary>Counts of objects, and problems of the last step.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_counters
	{
		/// <summary>alive</summary>
		public int bodies;
		/// <summary>dynamic and kinematic bodies that are simulated</summary>
		public int bodies_awake;
		/// <summary>alive</summary>
		public int shapes;
		/// <summary>boxes in the broadphase: one per shape, one per edge of a chain</summary>
		public int proxies;
		/// <summary>pairs whose fat boxes overlap</summary>
		public int contacts;
		/// <summary>with an awake body</summary>
		public int contacts_awake;
		/// <summary>pairs with a manifold, asleep or awake</summary>
		public int contacts_touching;
		/// <summary>and constraints</summary>
		public int joints;
		/// <summary>and constraints, with an awake body</summary>
		public int joints_awake;
		/// <summary>awake and asleep; a single dynamic body counts</summary>
		public int islands;
		/// <summary>of them</summary>
		public int islands_awake;
		/// <summary>groups of contacts that share no dynamic body</summary>
		public int colors_used;
		/// <summary>contacts that fit no colour: solved one by one</summary>
		public int overflow_contacts;
		/// <summary>cells of the broadphase</summary>
		public int broadphase_tiles;
		/// <summary>steps taken since creation, modulo 2^32</summary>
		public uint steps;
		/// <summary>Work that the last step skipped for lack of memory or in a crowd, 0 for none. The next steps try again.
		/// CN_WARNING_*</summary>
		public uint warnings;
		/// <summary>new pairs without a contact</summary>
		public int pairs_not_added;
		/// <summary>events without a place in a log</summary>
		public int events_not_reported;
		/// <summary>of several bodies, solved directly in the last step, contacts included</summary>
		public int islands_direct;
		/// <summary>planned direct solving of the last step, in the units of work_budget; at most 2^31 - 1</summary>
		public int direct_work;
		/// <summary>of several bodies, soft for a time as no solution was found: CN_TIER_REASON_NO_SET</summary>
		public int islands_unsolved;
	}

	/// <summary>Report on one island.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_island_report
	{
		/// <summary>its body of least slot</summary>
		public cn_body body;
		/// <summary>dynamic</summary>
		public int bodies;
		/// <summary>touching</summary>
		public int contacts;
		/// <summary>and constraints</summary>
		public int joints;
		/// <summary>CN_TIER_*, after the last step</summary>
		public int tier;
		/// <summary>CN_TIER_REASON_*</summary>
		public int reason;
		/// <summary>of the last step with dt &gt; 0: the world's, or 1 at rest; freely swinging joints may take more</summary>
		public int substeps;
		/// <summary>at the present poses: largest overlap, or gap of a rigid joint (angles times its bodies' extent); joints
		/// that may yield (stiffness_hertz, force_max_N, torque_max_Nm) do not count</summary>
		public float residual_m;
	}

	/// <summary>Seconds of the last step by stage, all 0 unless CN_WORLD_PROFILE is set.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_profile
	{
		/// <summary>the whole step</summary>
		public float step_s;
		/// <summary>waking</summary>
		public float wake_s;
		/// <summary>pairs</summary>
		public float broadphase_s;
		/// <summary>manifolds</summary>
		public float narrowphase_s;
		/// <summary>islands</summary>
		public float islands_s;
		/// <summary>constraints, plans</summary>
		public float prepare_s;
		/// <summary>all substeps</summary>
		public float substeps_s;
		/// <summary>poses and boxes</summary>
		public float finalize_s;
		/// <summary>callbacks</summary>
		public float events_s;
		/// <summary>falling asleep</summary>
		public float sleep_s;
	}

	/// <summary>Memory, in bytes. The frame arena is a stack allocator whose entries live within one step; the block
	/// allocator serves small variable-size pieces from free lists of size classes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_memory_stats
	{
		/// <summary>taken from the user's allocator or carved from the fixed block</summary>
		public ulong bytes_in_use;
		/// <summary>most bytes_in_use since creation</summary>
		public ulong bytes_peak;
		/// <summary>calls of the user's alloc (or of the fixed block's) since creation</summary>
		public ulong allocator_calls;
		/// <summary>of the frame arena</summary>
		public ulong arena_capacity;
		/// <summary>most bytes in use at once since creation</summary>
		public ulong arena_peak;
		/// <summary>entries that did not fit: the allocator served them; since creation</summary>
		public ulong arena_fallbacks;
		/// <summary>bytes in chunks</summary>
		public ulong blocks_capacity;
		/// <summary>bytes handed out of them</summary>
		public ulong blocks_in_use;
		/// <summary>blocks above the largest class, served by the allocator</summary>
		public ulong blocks_large;
	}

	/// <summary>Definition of a body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_body_def
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>CN_BODY_STATIC, _KINEMATIC, _DYNAMIC; default dynamic</summary>
		public int type;
		/// <summary>of the origin; |x|, |y| &lt;= 1e6 x length unit</summary>
		public cn_vec2 position_m;
		/// <summary>|angle| &lt;= 1e4</summary>
		public float angle_rad;
		/// <summary>of the centre of mass; both velocities are ignored without CN_BODY_AWAKE</summary>
		public cn_vec2 linear_velocity_mps;
		/// <summary>default 0</summary>
		public float angular_velocity_radps;
		/// <summary>v' = -damping v; &gt;= 0, default 0</summary>
		public float linear_damping_per_s;
		/// <summary>&gt;= 0, default 0</summary>
		public float angular_damping_per_s;
		/// <summary>default 1</summary>
		public float gravity_scale;
		/// <summary>&gt;= 0; CN_DEFAULT (default): the world's</summary>
		public float sleep_speed_mps;
		/// <summary>CN_BODY_*; default ENABLED | SLEEP | AWAKE</summary>
		public uint flags;
		/// <summary>as in cn_body_set_solver; default CN_SOLVER_AUTO</summary>
		public int solver;
		/// <summary>a number for the user; default 0</summary>
		public ulong user_data;
		/// <summary>NULL, or at most CN_NAME_MAX_BYTES bytes of text, copied</summary>
		public byte* name;
	}

	/// <summary>A body that moved or fell asleep in the last step.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_body_moved
	{
		/// <summary>after the step</summary>
		public cn_pose pose;
		/// <summary>the body's</summary>
		public ulong user_data;
		/// <summary>that moved</summary>
		public cn_body body;
		/// <summary>1 in the step in which it fell asleep</summary>
		public uint fell_asleep;
	}

	/// <summary>Two shapes of one group other than 0 collide if it is positive and do not if it is negative. Others
	/// collide if the category of each has a bit in the mask of the other.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_filter
	{
		/// <summary>default 1</summary>
		public ulong category;
		/// <summary>default all ones</summary>
		public ulong mask;
		/// <summary>default 0</summary>
		public int group;
		/// <summary>0</summary>
		public uint reserved;
	}

	/// <summary>Surface of a shape.</summary>
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
		/// <summary>conveyor: the surface moves along (normal.y, -normal.x) of its outward normal; [-1e4, 1e4], default 0</summary>
		public float tangent_speed_mps;
		/// <summary>CN_MIX_*; default CN_MIX_GEOMETRIC</summary>
		public int friction_mix;
		/// <summary>CN_MIX_*; default CN_MIX_MAXIMUM</summary>
		public int restitution_mix;
		/// <summary>a number for the user, reported in contact events; default 0</summary>
		public uint user_id;
	}

	/// <summary>Definition of a shape.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_shape_def
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>0: create unattached, for cn_shape_attach</summary>
		public cn_body body;
		/// <summary>of the shape in the body's local frame</summary>
		public cn_vec2 offset_m;
		/// <summary>of the shape in the body's local frame</summary>
		public float angle_rad;
		/// <summary>&gt;= 0, giving 0 or 1e-20 to 1e20 kg; default 1</summary>
		public float density_kgpm2;
		/// <summary>defaults: see cn_material</summary>
		public cn_material material;
		/// <summary>defaults: see cn_filter</summary>
		public cn_filter filter;
		/// <summary>bits 1 &lt;&lt; CN_EVENT_*; a pair reports the events of either shape; default ENTER and LEAVE</summary>
		public uint event_mask;
		/// <summary>CN_SHAPE_SENSOR ...; default 0</summary>
		public uint flags;
		/// <summary>a number for the user; default 0</summary>
		public ulong user_data;
	}

	/// <summary>A disc.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_circle
	{
		/// <summary>in the body's frame</summary>
		public cn_vec2 center_m;
		/// <summary>&gt; 0</summary>
		public float radius_m;
	}

	/// <summary>All points within radius_m of the segment.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_capsule
	{
		/// <summary>one end of the segment, in the body's frame</summary>
		public cn_vec2 a_m;
		/// <summary>the other end</summary>
		public cn_vec2 b_m;
		/// <summary>around the segment, &gt; 0</summary>
		public float radius_m;
	}

	/// <summary>A two-sided segment without mass.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_edge
	{
		/// <summary>one end, in the body's frame</summary>
		public cn_vec2 a_m;
		/// <summary>the other end</summary>
		public cn_vec2 b_m;
	}

	/// <summary>Convex polygon. Either winding is accepted; points are stored counter-clockwise.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_polygon
	{
		/// <summary>3 to CN_POLYGON_MAX_VERTICES</summary>
		public int count;
		/// <summary>rounding added outside the points, &gt;= 0</summary>
		public float radius_m;
		/// <summary>the first count of them; in the body's frame</summary>
		public cn_vec2_array16 points_m;
	}

	/// <summary>One-sided ground without mass; bodies slide over its inner vertices without catching. The solid side is
	/// on the left of the order of points and surface normals point to the right: points that run from +x to -x
	/// collide from above, a counter-clockwise loop collides from outside.</summary>
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

	/// <summary>One point of a contact.</summary>
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

	/// <summary>How two shapes touch.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_manifold
	{
		/// <summary>unit, from shape a to shape b; impulses act along it. Between slow bodies it may differ from the faces'
		/// by up to 0.1 rad, so that piles stand</summary>
		public cn_vec2 normal;
		/// <summary>of the last substep, on body b along (normal.y, -normal.x)</summary>
		public float friction_impulse_Ns;
		/// <summary>0, 1 or 2</summary>
		public int point_count;
		/// <summary>the first point_count of them</summary>
		public cn_manifold_point_array2 points;
	}

	/// <summary>A contact event, or the present state of a contact.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_contact_event
	{
		/// <summary>one shape of the pair</summary>
		public cn_shape shape_a;
		/// <summary>the other</summary>
		public cn_shape shape_b;
		/// <summary>of shape_a</summary>
		public cn_body body_a;
		/// <summary>of shape_b</summary>
		public cn_body body_b;
		/// <summary>edge number within a chain, else 0</summary>
		public int child_a;
		/// <summary>the same of shape b</summary>
		public int child_b;
		/// <summary>the same from CREATED to DESTROYED, then reused</summary>
		public uint contact_id;
		/// <summary>CN_EVENT_*</summary>
		public int kind;
		/// <summary>ENTER: closing speed along the normal before the impact; HIT: of the blow; else 0</summary>
		public float approach_speed_mps;
		/// <summary>geometry at the step's beginning, impulses at its end; points only for ENTER, STAY and HIT</summary>
		public cn_manifold manifold;
		/// <summary>Impulses of the whole step, all substeps and points together, in ENTER, STAY and HIT of
		/// cn_world_contact_events; else 0, as in cn_body_get_contacts. In the substeps of a predicted contact that
		/// its shapes do not reach in this step, they are 0 too. along manifold.normal, on body b; its mean force
		/// is normal_impulse_Ns / dt_s</summary>
		public float normal_impulse_Ns;
		/// <summary>along (normal.y, -normal.x), on body b</summary>
		public float friction_impulse_Ns;
		/// <summary>HIT: where, in the world; else (0, 0)</summary>
		public cn_vec2 hit_point_m;
		/// <summary>cn_material.user_id of the shapes; 0 for CREATED, LEAVE and DESTROYED</summary>
		public uint material_a;
		/// <summary>the same of shape_b</summary>
		public uint material_b;
	}

	/// <summary>A shape entered or left a sensor.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_sensor_event
	{
		/// <summary>the sensor</summary>
		public cn_shape sensor;
		/// <summary>the shape that it met</summary>
		public cn_shape visitor;
		/// <summary>the sensor's body</summary>
		public cn_body sensor_body;
		/// <summary>the visitor's body</summary>
		public cn_body visitor_body;
		/// <summary>CN_EVENT_ENTER or CN_EVENT_LEAVE</summary>
		public int kind;
		/// <summary>0</summary>
		public uint reserved;
	}

	/// <summary>First field of every joint definition. The rigid parts of a joint hold anchors, axes, angles, lengths and
	/// limits in place; springs and motors are not rigid parts.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_joint_base
	{
		/// <summary>of the whole definition</summary>
		public uint struct_size;
		/// <summary>CN_JOINT_*; default 0; a type ignores flags that it does not use</summary>
		public uint flags;
		/// <summary>0: the world</summary>
		public cn_body body_a;
		/// <summary>0: the world; one of the two must be dynamic</summary>
		public cn_body body_b;
		/// <summary>in body a's local frame, or in world coordinates</summary>
		public cn_vec2 anchor_a_m;
		/// <summary>the same for body b</summary>
		public cn_vec2 anchor_b_m;
		/// <summary>of the rigid parts, &gt; 0, to 1e6, of which an eighth of the substeps in a second acts at most, as of
		/// all springs; CN_DEFAULT (default): as stiff as the substeps permit</summary>
		public float stiffness_hertz;
		/// <summary>used with a stiffness_hertz; 0 to 1e6, default 0</summary>
		public float stiffness_damping_ratio;
		/// <summary>greatest force of each: anchor, axis, limit; &gt; 0; CN_DEFAULT (default): unbounded</summary>
		public float force_max_N;
		/// <summary>greatest torque of angles, &gt; 0; CN_DEFAULT (default): unbounded</summary>
		public float torque_max_Nm;
		/// <summary>a reaction above this in any substep is reported (cn_world_joint_events), &gt; 0; CN_DEFAULT (default):
		/// never</summary>
		public float break_force_N;
		/// <summary>the same for the torque</summary>
		public float break_torque_Nm;
		/// <summary>a number for the user; default 0</summary>
		public ulong user_data;
	}

	/// <summary>Two bodies share a point. The joint angle is angle b - angle a - reference, in (-pi, pi].</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_revolute_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>angle b - angle a at joint angle 0</summary>
		public float reference_angle_rad;
		/// <summary>CN_JOINT_LIMIT: -pi &lt;= lower &lt;= upper &lt;= pi</summary>
		public float lower_angle_rad;
		/// <summary>the upper limit</summary>
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

	/// <summary>Two points keep a distance. Without CN_JOINT_SPRING and CN_JOINT_LIMIT the joint is a rigid rod of
	/// length_m. With a spring, length_m is its rest length, and limits keep the distance within [min, max];
	/// limits alone make a rope (min 0).</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_distance_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>&gt; 0; default 1</summary>
		public float length_m;
		/// <summary>CN_JOINT_LIMIT: 0 &lt;= min &lt;= max; default 0 and 1</summary>
		public float length_min_m;
		/// <summary>the upper limit</summary>
		public float length_max_m;
		/// <summary>CN_JOINT_MOTOR: along the axis, positive lengthens; with spring or limit only</summary>
		public float motor_speed_mps;
		/// <summary>&gt;= 0</summary>
		public float motor_force_max_N;
		/// <summary>0 to 1e6</summary>
		public float spring_hertz;
		/// <summary>0 to 1e6</summary>
		public float spring_damping_ratio;
		/// <summary>0</summary>
		public float reserved;
	}

	/// <summary>Two welded bodies: no relative motion. base.stiffness_hertz makes the weld springy.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_fixed_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>angle b - angle a</summary>
		public float reference_angle_rad;
		/// <summary>stiffness of the angle alone, &gt; 0, to 1e6; CN_DEFAULT (default): the base's</summary>
		public float angular_hertz;
		/// <summary>0 to 1e6</summary>
		public float angular_damping_ratio;
		/// <summary>0</summary>
		public float reserved;
	}

	/// <summary>b slides along an axis fixed in a, without turning. The translation is along the axis from anchor a.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_prismatic_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>in body a's frame, any length &gt; 0 (read back with length 1); default (1, 0)</summary>
		public cn_vec2 axis;
		/// <summary>angle b - angle a</summary>
		public float reference_angle_rad;
		/// <summary>CN_JOINT_LIMIT: lower &lt;= upper</summary>
		public float lower_m;
		/// <summary>the upper limit</summary>
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

	/// <summary>A wheel b on a suspension: b slides along an axis fixed in a, with spring and limits, and turns freely or
	/// by the motor.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_wheel_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>in body a's frame, any length &gt; 0 (read back with length 1); default (0, 1)</summary>
		public cn_vec2 axis;
		/// <summary>CN_JOINT_LIMIT: lower &lt;= upper</summary>
		public float lower_m;
		/// <summary>the upper limit</summary>
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
		/// <summary>frequency of the spring, &gt; 0, to 1e6; default 5</summary>
		public float hertz;
		/// <summary>0 to 1e6, default 1</summary>
		public float damping_ratio;
		/// <summary>0</summary>
		public float reserved;
	}

	/// <summary>Drags anchor b of body b to a world point by a spring. body_a must be 0, anchor_a_m is ignored, and
	/// base.force_max_N must be &gt; 0.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mouse_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>world</summary>
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
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>size 1e-4 to 1e4, negative: they turn against each other; default 1</summary>
		public float ratio;
		/// <summary>default 0</summary>
		public float phase_rad;
	}

	/// <summary>A rope over two pulleys: |anchor a - ground a| + ratio |anchor b - ground b| &lt;= length. It pulls and
	/// never pushes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_pulley_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>world</summary>
		public cn_vec2 ground_a_m;
		/// <summary>world</summary>
		public cn_vec2 ground_b_m;
		/// <summary>1e-4 to 1e4; default 1</summary>
		public float ratio;
		/// <summary>&gt; 0: must be set</summary>
		public float length_m;
	}

	/// <summary>b may turn against a in one direction, and back only to the last click that it passed. Clicks lie at
	/// phase + n * click_rad for every whole number n, over whole turns.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_ratchet_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>default 0</summary>
		public float phase_rad;
		/// <summary>size 1e-4 to 1e4: must be set; positive: b may turn counter-clockwise</summary>
		public float click_rad;
	}

	/// <summary>A torque that pulls angle b - angle a to the rest angle, over whole turns. hertz refers to the inertia of
	/// the two bodies.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_rotary_spring_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>default 0</summary>
		public float rest_angle_rad;
		/// <summary>&gt; 0, to 1e6; default 1</summary>
		public float hertz;
		/// <summary>0 to 1e6, default 0</summary>
		public float damping_ratio;
		/// <summary>0</summary>
		public float reserved;
	}

	/// <summary>Anchor b slides in a slot of body a from anchor a to end_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_groove_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
		/// <summary>in body a's frame; not equal to anchor a; default (1, 0)</summary>
		public cn_vec2 end_m;
	}

	/// <summary>The two bodies do not collide; no other effect.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_filter_joint_def
	{
		/// <summary>what every joint has</summary>
		public cn_joint_base @base;
	}

	/// <summary>A joint or constraint exceeded a break threshold or was destroyed with a body.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_joint_event
	{
		/// <summary>0: it was a constraint; stale when destroyed is 1</summary>
		public cn_joint joint;
		/// <summary>0: it was a joint; stale when destroyed is 1</summary>
		public cn_constraint constraint;
		/// <summary>0: the world</summary>
		public cn_body body_a;
		/// <summary>0: the world</summary>
		public cn_body body_b;
		/// <summary>largest reaction of the step; 0 when a body was destroyed</summary>
		public float force_N;
		/// <summary>the same for the torque</summary>
		public float torque_Nm;
		/// <summary>1: it broke, or one of its bodies was destroyed</summary>
		public uint destroyed;
		/// <summary>0</summary>
		public uint reserved;
		/// <summary>the joint's or constraint's</summary>
		public ulong user_data;
	}

	/// <summary>Keeps a body's angle within limits. The angle begins in (-pi, pi] at creation and counts whole turns from
	/// there.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_angle_constraint_def
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>CN_CONSTRAINT_*; default 0</summary>
		public uint flags;
		/// <summary>must be dynamic</summary>
		public cn_body body;
		/// <summary>lower &lt;= upper; equal: locked</summary>
		public float lower_rad;
		/// <summary>the upper limit</summary>
		public float upper_rad;
		/// <summary>&gt; 0, to 1e6; CN_DEFAULT (default): rigid</summary>
		public float hertz;
		/// <summary>used with a hertz; 0 to 1e6</summary>
		public float damping_ratio;
		/// <summary>a reaction above this is reported (cn_world_joint_events), &gt; 0; CN_DEFAULT (default): never</summary>
		public float break_torque_Nm;
		/// <summary>a number for the user; default 0</summary>
		public ulong user_data;
	}

	/// <summary>Keeps a point of a body on a line in the world, within a tolerance on both sides, and between limits
	/// along the line.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_line_constraint_def
	{
		/// <summary>set by the init function</summary>
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
		/// <summary>the upper limit</summary>
		public float upper_m;
		/// <summary>&gt; 0, to 1e6; CN_DEFAULT (default): rigid</summary>
		public float hertz;
		/// <summary>used with a hertz; 0 to 1e6</summary>
		public float damping_ratio;
		/// <summary>a reaction above this is reported (cn_world_joint_events), &gt; 0; CN_DEFAULT (default): never</summary>
		public float break_force_N;
		/// <summary>0</summary>
		public uint reserved;
		/// <summary>a number for the user; default 0</summary>
		public ulong user_data;
	}

	/// <summary>Result of cn_world_update.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_update_report
	{
		/// <summary>fixed steps taken</summary>
		public int steps;
		/// <summary>time kept for the next update</summary>
		public float leftover_s;
		/// <summary>time discarded because of steps_max</summary>
		public float dropped_s;
		/// <summary>leftover_s / fixed step, [0, 1): factor for cn_world_read_poses_interpolated</summary>
		public float interpolation;
	}

	/// <summary>A ray with an end.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_ray
	{
		/// <summary>world</summary>
		public cn_vec2 origin_m;
		/// <summary>at most 2e6 length units each way; 0 hits only shapes around the origin</summary>
		public cn_vec2 translation_m;
	}

	/// <summary>What a ray or a moved shape hit. If it starts in contact (overlapping or just touching), it hits that
	/// shape at fraction 0, with the shortest way out: depth_m along the normal. A shape that it touches up to a
	/// depth of 0.5% of the length unit is no hit if the translation leads along the surface or away from it.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_ray_hit
	{
		/// <summary>0: nothing was hit</summary>
		public cn_shape shape;
		/// <summary>the shape's</summary>
		public cn_body body;
		/// <summary>edge of a chain</summary>
		public int child;
		/// <summary>of the translation, [0, 1]; 1 when nothing was hit</summary>
		public float fraction;
		/// <summary>on the surface of the shape that was hit</summary>
		public cn_vec2 point_m;
		/// <summary>unit, out of the shape that was hit</summary>
		public cn_vec2 normal;
		/// <summary>depth of the start inside it, 0 outside</summary>
		public float depth_m;
		/// <summary>0</summary>
		public uint reserved;
	}

	/// <summary>Which shapes a query sees: those of enabled bodies whose category has a bit in mask and whose mask has a
	/// bit in category; sensors only with CN_SHAPE_SENSOR_SEEN. Queries use the present poses, also between
	/// steps.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_query_filter
	{
		/// <summary>default 1</summary>
		public ulong category;
		/// <summary>default all ones</summary>
		public ulong mask;
		/// <summary>its shapes are ignored; 0 (default): none. A stale handle is an error</summary>
		public cn_body ignored_body;
		/// <summary>CN_QUERY_IGNORE_JOINED ...; default 0</summary>
		public uint flags;
		/// <summary>NULL (default): take all shapes</summary>
		public IntPtr visit;
		/// <summary>last argument of visit</summary>
		public void* user;
	}

	/// <summary>The shape nearest to a point.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_closest
	{
		/// <summary>0: nothing within the distance</summary>
		public cn_shape shape;
		/// <summary>the shape's</summary>
		public cn_body body;
		/// <summary>edge of a chain</summary>
		public int child;
		/// <summary>negative: depth inside a shape with area</summary>
		public float distance_m;
		/// <summary>on the surface</summary>
		public cn_vec2 point_m;
		/// <summary>outward there; of edges and chains towards the point</summary>
		public cn_vec2 normal;
	}

	/// <summary>Distance of two shapes.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_distance
	{
		/// <summary>on the surface of a, in the world</summary>
		public cn_vec2 point_a_m;
		/// <summary>on the surface of b</summary>
		public cn_vec2 point_b_m;
		/// <summary>unit, from a to b</summary>
		public cn_vec2 normal;
		/// <summary>of the surfaces; negative: the depth, the shortest translation of b out of a</summary>
		public float distance_m;
		/// <summary>0</summary>
		public uint reserved;
	}

	/// <summary>A motion from fraction 0 to 1: a point of the shape moves in a straight line, and the shape turns about
	/// it at a constant rate.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_sweep
	{
		/// <summary>of the shape, before the motion</summary>
		public cn_pose start;
		/// <summary>that point, in the shape's frame: the centre of mass of a body</summary>
		public cn_vec2 center_m;
		/// <summary>of it; at most 2e6 m each way</summary>
		public cn_vec2 translation_m;
		/// <summary>counter-clockwise, |turn| &lt;= 1e4</summary>
		public float turn_rad;
		/// <summary>0</summary>
		public uint reserved;
	}

	/// <summary>Result of cn_polygon_time_of_impact.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_impact
	{
		/// <summary>CN_IMPACT_*</summary>
		public int state;
		/// <summary>of both motions, [0, 1]</summary>
		public float fraction;
		/// <summary>HIT only, as are the next two: between the surfaces</summary>
		public cn_vec2 point_m;
		/// <summary>unit, from a to b</summary>
		public cn_vec2 normal;
		/// <summary>of the surfaces at fraction: distance_m to 0.1 mm (or the resolution of floats) above it</summary>
		public float distance_m;
		/// <summary>0</summary>
		public uint reserved;
	}

	/// <summary>A surface that limits the motion of a shape: a translation t keeps separation_m + normal . t &gt;= 0,
	/// unless that needs a push of more than push_max_m.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_plane
	{
		/// <summary>unit, from the surface to the shape</summary>
		public cn_vec2 normal;
		/// <summary>world point of least distance</summary>
		public cn_vec2 point_m;
		/// <summary>of the surfaces along the normal; negative: they overlap</summary>
		public float separation_m;
		/// <summary>greatest push of this plane, &gt;= 0; FLT_MAX: rigid</summary>
		public float push_max_m;
		/// <summary>its push in the last cn_mover_solve</summary>
		public float push_m;
		/// <summary>whose surface it is</summary>
		public cn_shape shape;
		/// <summary>the shape's</summary>
		public cn_body body;
		/// <summary>edge of a chain</summary>
		public int child;
	}

	/// <summary>How a character moves. It may change between moves: crouching is another shape.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mover_def
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>CN_MOVER_DROP; default 0</summary>
		public uint flags;
		/// <summary>around its position, never turned; 1 or 2 points with radius &gt; 0: circle, capsule. Default: a capsule
		/// of radius 0.3 from -0.5 to 0.5 along y: 1.6 high. Round shapes move more smoothly</summary>
		public cn_polygon shape;
		/// <summary>shapes that it collides with; sensors never, one-way shapes from above</summary>
		public cn_query_filter filter;
		/// <summary>any length &gt; 0; default (0, 1)</summary>
		public cn_vec2 up;
		/// <summary>greatest slope of walkable ground, 0 to pi / 2; default 0.87 (50 degrees)</summary>
		public float slope_limit_rad;
		/// <summary>greatest height of steps that it climbs, &gt;= 0; default 0.3</summary>
		public float step_height_m;
		/// <summary>a walking character follows ground that falls by up to this in a move, &gt;= 0; default 0.3</summary>
		public float snap_m;
		/// <summary>of the world's gravity in the air; default 1</summary>
		public float gravity_scale;
		/// <summary>greatest push on a dynamic body, &gt;= 0; default 200</summary>
		public float push_force_N;
		/// <summary>of sliding, 1 to 64; default 8</summary>
		public int iterations_max;
	}

	/// <summary>State of a character between two moves. It belongs to the caller, who may copy, store and restore it. The
	/// world does not know it, and bodies do not collide with it: for that give it a kinematic body that is
	/// filter.ignored_body and follows by cn_body_set_target_pose. Initially all fields are 0 except the
	/// position.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_mover
	{
		/// <summary>of the shape's origin, world</summary>
		public cn_vec2 position_m;
		/// <summary>in the air: of the world. On the ground: walking speed along the ground, relative to the ground, as its
		/// component across up; the one along up is 0, and a jump when the caller makes it &gt; 0</summary>
		public cn_vec2 velocity_mps;
		/// <summary>of the ground with CN_MOVER_ON_GROUND, else (0, 0)</summary>
		public cn_vec2 ground_normal;
		/// <summary>in the world, after the move</summary>
		public cn_vec2 ground_point_m;
		/// <summary>... in the frame of ground_body</summary>
		public cn_vec2 ground_local_m;
		/// <summary>of the ground there</summary>
		public cn_vec2 ground_velocity_mps;
		/// <summary>0: none; a stale handle counts as none</summary>
		public cn_body ground_body;
		/// <summary>the same for its shape</summary>
		public cn_shape ground_shape;
		/// <summary>CN_MOVER_ON_*, after the last move</summary>
		public uint flags;
		/// <summary>overlap with surfaces that leave it no room; else 0 up to rounding</summary>
		public float squeezed_m;
	}

	/// <summary>What a sensor shape does to the dynamic bodies in it: water, wind tunnels, planets, rooms without
	/// gravity. Several areas act in the order of their priority, equal ones in that of cn_world_get_shapes;
	/// their accelerations, damping and forces add up.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_area_def
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>CN_AREA_REPLACE; default 0</summary>
		public uint flags;
		/// <summary>default 0</summary>
		public int priority;
		/// <summary>acceleration in the axes of the world, times the body's gravity_scale; default (0, 0)</summary>
		public cn_vec2 gravity_mps2;
		/// <summary>of pull_mps2, in the frame of the sensor's body; default (0, 0)</summary>
		public cn_vec2 center_m;
		/// <summary>acceleration towards center_m; negative pushes; default 0</summary>
		public float pull_mps2;
		/// <summary>CN_DEFAULT (default): pull_mps2 at every distance; &gt; 0, to 1e6 length units: at this distance, with
		/// its inverse square outside, and falling to 0 at the centre: a homogeneous planet</summary>
		public float pull_distance_m;
		/// <summary>of the velocity relative to flow_mps, added to the body's own; of the displaced mass in a medium with
		/// density (which is the body's mass where it floats), else of the body's; 0 to 1e9, default 0</summary>
		public float linear_damping_per_s;
		/// <summary>... of the rotation; 0 to 1e9, default 0</summary>
		public float angular_damping_per_s;
		/// <summary>of the medium: buoyancy of the parts of shapes in it, against all gravity that acts; 0 to 1e9, default 0</summary>
		public float density_kgpm2;
		/// <summary>density times drag coefficient, as in cn_shape_apply_wind; 0 to 1e9, default 0</summary>
		public float drag_kgpm2;
		/// <summary>density times lift coefficient; 0 to 1e9, default 0</summary>
		public float lift_kgpm2;
		/// <summary>velocity of the medium relative to the sensor, in the axes of the world; default (0, 0)</summary>
		public cn_vec2 flow_mps;
	}

	/// <summary>Definition of an explosion.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_explosion_def
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>full strength up to this distance of a shape's nearest point, 0 to 1e6 length units; default 1</summary>
		public float radius_m;
		/// <summary>then linearly to 0 over this distance, 0 to 1e6 length units; default 0</summary>
		public float falloff_m;
		/// <summary>per metre of the shape's width seen from the centre; negative pulls; default 0</summary>
		public float impulse_Nspm;
		/// <summary>world</summary>
		public cn_vec2 center_m;
		/// <summary>which shapes; defaults: see cn_query_filter</summary>
		public cn_query_filter filter;
	}

	/// <summary>The user's drawing functions; NULL ones are not called. Colours are 0xRRGGBB. Points are in world
	/// coordinates.</summary>
	[StructLayout(LayoutKind.Sequential)]
	public unsafe struct cn_debug_draw
	{
		/// <summary>set by the init function</summary>
		public uint struct_size;
		/// <summary>CN_DRAW_*; default SHAPES | JOINTS | CONTACTS</summary>
		public uint flags;
		/// <summary>things outside are not drawn; default everything</summary>
		public cn_aabb view;
		/// <summary>count points, counter-clockwise</summary>
		public IntPtr polygon;
		/// <summary>rim_m: a point on the rim that turns with the body</summary>
		public IntPtr circle;
		/// <summary>a disc swept from a to b</summary>
		public IntPtr capsule;
		/// <summary>a line from a to b</summary>
		public IntPtr segment;
		/// <summary>size in pixels</summary>
		public IntPtr point;
		/// <summary>zero-terminated, valid during the call</summary>
		public IntPtr text;
		/// <summary>last argument of the functions</summary>
		public void* user;
		/// <summary>0</summary>
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
			CheckSize("cn_area_def", sizeof(cn_area_def), CN_TYPE_AREA_DEF);
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
		public const int CN_ABI_VERSION = 3;
		public const int CN_POLYGON_MAX_VERTICES = 16;
		public const int CN_NAME_MAX_BYTES = 63;
		public const int CN_PLANES_MAX = 64;
		public const int CN_WORKERS_MAX = 64;
		public const int CN_MAX_HANDLES = 1048575;

		// In a definition: the default of a field whose comment names CN_DEFAULT; other fields refuse it where it
		// is out of their range.
		/// <summary>In a definition: the default of a field whose comment names CN_DEFAULT; other fields refuse it where it
		/// is out of their range.</summary>
		public const int CN_DEFAULT = -1;

		// Result codes.
		/// <summary>success</summary>
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
		/// <summary>the object is in a state that does not permit the call</summary>
		public const int CN_ERROR_STATE = -6;
		/// <summary>cn_world_validate found a broken invariant: a bug in Cairn</summary>
		public const int CN_ERROR_INTERNAL = -7;
		/// <summary>the bytes are no saved world, or are damaged</summary>
		public const int CN_ERROR_FORMAT = -8;

		// Structs, for cn_sizeof.
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
		public const int CN_TYPE_AREA_DEF = 54;
		public const int CN_TYPE_COUNT = 55;

		// Flags of a world.
		/// <summary>islands at rest fall asleep (default on)</summary>
		public const uint CN_WORLD_SLEEP = 1;
		/// <summary>start solving from the last step's impulses (default on)</summary>
		public const uint CN_WORLD_WARM_START = 2;
		/// <summary>measure cn_profile (default off: reading a clock costs time)</summary>
		public const uint CN_WORLD_PROFILE = 4;
		/// <summary>fast bodies stop at surfaces instead of passing through (default on)</summary>
		public const uint CN_WORLD_CONTINUOUS = 8;

		// What a block of fixed capacities (cn_world_def.memory) has room for from the beginning.
		/// <summary>a name of each body</summary>
		public const uint CN_RESERVE_NAMES = 1;
		/// <summary>chains; cn_material.user_id of each shape</summary>
		public const uint CN_RESERVE_CHAINS = 2;
		/// <summary>rolling resistance, conveyors, locked axes</summary>
		public const uint CN_RESERVE_EXTRA_ROWS = 4;
		/// <summary>lists of moved bodies, interpolated poses</summary>
		public const uint CN_RESERVE_MOVED = 8;

		// Solvers: see examples/docs/solvers.md.
		/// <summary>soft constraints with substeps, and direct solving of joints, leaning piles and heavily loaded piles</summary>
		public const int CN_SOLVER_AUTO = 0;
		/// <summary>soft contact and joint constraints with substeps only (Catto, Solver2D, 2024)</summary>
		public const int CN_SOLVER_SOFT = 1;
		/// <summary>direct solving of all joints, and of all piles without joints, at any cost</summary>
		public const int CN_SOLVER_DIRECT = 2;
		/// <summary>the paper's twelve steps, once a step: a baseline (limits: examples/docs/limits.md)</summary>
		public const int CN_SOLVER_SEQUENTIAL = 3;

		// Broadphases.
		/// <summary>tiled sweep-and-prune</summary>
		public const int CN_BROADPHASE_SWEEP = 0;
		/// <summary>dynamic AABB tree: for worlds of very mixed sizes with many region queries</summary>
		public const int CN_BROADPHASE_TREE = 1;

		// Warnings of a step that lacked memory or skipped work.
		/// <summary>new contacts were not added: pairs_not_added</summary>
		public const uint CN_WARNING_CONTACT_MEMORY = 1;
		/// <summary>the step worked around missing scratch memory</summary>
		public const uint CN_WARNING_FRAME_MEMORY = 2;
		/// <summary>events_not_reported</summary>
		public const uint CN_WARNING_EVENT_MEMORY = 4;
		/// <summary>thousands of boxes overlap in one spot: contacts of the most crowded bodies come over several steps, and
		/// pairs_not_added counts what the last step left out</summary>
		public const uint CN_WARNING_CROWD = 8;
		/// <summary>forces or impulses gave bodies a speed that floats cannot hold: these bodies were stopped at their
		/// poses, and the others go on</summary>
		public const uint CN_WARNING_NOT_FINITE = 16;

		// How an island is solved. In each tier joints may be solved together with their neighbours.
		/// <summary>contacts by soft constraints</summary>
		public const int CN_TIER_SOFT = 0;
		/// <summary>contacts and joints in one system, exactly</summary>
		public const int CN_TIER_DIRECT = 1;
		/// <summary>no contacts and no joints: nothing to solve</summary>
		public const int CN_TIER_FREE = 2;

		// Why an island has its tier. "A problem" is one of CN_TIER_REASON_NEW_CONTACT, _OVERLAP and _STRESSED.
		/// <summary>no problem</summary>
		public const int CN_TIER_REASON_NONE = 0;
		/// <summary>direct: the problem has ended, but not for long enough</summary>
		public const int CN_TIER_REASON_SETTLING = 1;
		/// <summary>direct: a contact began to carry load in a leaning or heavily loaded island</summary>
		public const int CN_TIER_REASON_NEW_CONTACT = 2;
		/// <summary>direct: an overlap exceeds the accuracy</summary>
		public const int CN_TIER_REASON_OVERLAP = 3;
		/// <summary>no longer used</summary>
		public const int CN_TIER_REASON_JOINT = 4;
		/// <summary>direct: a body carries so many times its weight that soft contacts would yield</summary>
		public const int CN_TIER_REASON_STRESSED = 5;
		/// <summary>the world's solver is not CN_SOLVER_AUTO</summary>
		public const int CN_TIER_REASON_SOLVER = 6;
		/// <summary>a body's own solver: cn_body_set_solver</summary>
		public const int CN_TIER_REASON_OVERRIDE = 7;
		/// <summary>soft: a single body</summary>
		public const int CN_TIER_REASON_ALONE = 8;
		/// <summary>soft: a problem, but the island moves too fast, bounces, or did a short time ago</summary>
		public const int CN_TIER_REASON_MOVING = 9;
		/// <summary>soft: a problem, but the island or the sum of such islands is too large</summary>
		public const int CN_TIER_REASON_CROWDED = 10;
		/// <summary>soft for a time: the system exceeds the work limit or the work_budget</summary>
		public const int CN_TIER_REASON_WORK = 11;
		/// <summary>soft for a time: a conveyor, a locked axis, or rolling resistance at a single point</summary>
		public const int CN_TIER_REASON_KIND = 12;
		/// <summary>soft for a time: no solution was found for its contacts; it stays awake while it moves at all</summary>
		public const int CN_TIER_REASON_NO_SET = 13;
		/// <summary>soft: no scratch memory (CN_WARNING_FRAME_MEMORY)</summary>
		public const int CN_TIER_REASON_MEMORY = 14;
		/// <summary>soft contacts: a problem, but the island has joints (which are solved directly)</summary>
		public const int CN_TIER_REASON_JOINTED = 15;

		// Types of bodies.
		/// <summary>never moves, infinite mass</summary>
		public const int CN_BODY_STATIC = 0;
		/// <summary>moves by its velocity alone, infinite mass</summary>
		public const int CN_BODY_KINEMATIC = 1;
		/// <summary>moves by forces, contacts and joints</summary>
		public const int CN_BODY_DYNAMIC = 2;

		// Flags of a body.
		/// <summary>the centre of mass keeps its world x</summary>
		public const uint CN_BODY_LOCK_X = 1;
		/// <summary>... its world y</summary>
		public const uint CN_BODY_LOCK_Y = 2;
		/// <summary>the body keeps its angle</summary>
		public const uint CN_BODY_LOCK_ROTATION = 4;
		/// <summary>continuous collision against dynamic bodies too</summary>
		public const uint CN_BODY_BULLET = 8;
		/// <summary>takes part in the simulation (default on)</summary>
		public const uint CN_BODY_ENABLED = 16;
		/// <summary>may fall asleep (default on)</summary>
		public const uint CN_BODY_SLEEP = 32;
		/// <summary>starts awake (default on)</summary>
		public const uint CN_BODY_AWAKE = 64;

		// Types of shapes.
		public const int CN_SHAPE_CIRCLE = 0;
		public const int CN_SHAPE_CAPSULE = 1;
		public const int CN_SHAPE_POLYGON = 2;
		public const int CN_SHAPE_EDGE = 3;
		public const int CN_SHAPE_CHAIN = 4;

		// How the values of two materials are mixed. If the materials have different rules, the later one of this
		// list applies.
		/// <summary>half the sum</summary>
		public const int CN_MIX_AVERAGE = 0;
		/// <summary>square root of the product; default for friction</summary>
		public const int CN_MIX_GEOMETRIC = 1;
		/// <summary>the smaller one</summary>
		public const int CN_MIX_MINIMUM = 2;
		/// <summary>the product</summary>
		public const int CN_MIX_MULTIPLY = 3;
		/// <summary>the greater one; default for restitution</summary>
		public const int CN_MIX_MAXIMUM = 4;

		// Flags of a shape.
		/// <summary>detects shapes that enter and leave, collides with nothing: cn_world_sensor_events</summary>
		public const uint CN_SHAPE_SENSOR = 1;
		/// <summary>queries see this sensor (default: they do not)</summary>
		public const uint CN_SHAPE_SENSOR_SEEN = 2;
		/// <summary>collides only with shapes that come from the side of its local +y axis</summary>
		public const uint CN_SHAPE_ONE_WAY = 4;
		/// <summary>the pre-solve callback is called for its contacts</summary>
		public const uint CN_SHAPE_PRE_SOLVE = 8;

		// Kinds of contact events.
		/// <summary>the fat boxes of two shapes began to overlap</summary>
		public const int CN_EVENT_CREATED = 0;
		/// <summary>they began to touch</summary>
		public const int CN_EVENT_ENTER = 1;
		/// <summary>they still touch</summary>
		public const int CN_EVENT_STAY = 2;
		/// <summary>they stopped touching, or one is gone</summary>
		public const int CN_EVENT_LEAVE = 3;
		/// <summary>the fat boxes no longer overlap, or one is gone</summary>
		public const int CN_EVENT_DESTROYED = 4;
		/// <summary>a blow at hit_speed_mps of cn_world_def or faster, at the beginning of touching or within it</summary>
		public const int CN_EVENT_HIT = 5;
		/// <summary>number of kinds</summary>
		public const int CN_EVENT_KINDS = 6;

		// Types of joints: see their definitions.
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

		// Flags of a joint.
		/// <summary>the connected bodies' shapes collide with each other (default off)</summary>
		public const uint CN_JOINT_COLLIDE = 1;
		/// <summary>the limits hold</summary>
		public const uint CN_JOINT_LIMIT = 2;
		/// <summary>the motor runs</summary>
		public const uint CN_JOINT_MOTOR = 4;
		/// <summary>the spring pulls</summary>
		public const uint CN_JOINT_SPRING = 8;
		/// <summary>destroyed beyond its break force or torque, not only reported</summary>
		public const uint CN_JOINT_BREAKS = 16;

		// Types of constraints.
		/// <summary>cn_angle_constraint_def</summary>
		public const int CN_CONSTRAINT_ANGLE = 0;
		/// <summary>cn_line_constraint_def</summary>
		public const int CN_CONSTRAINT_LINE = 1;

		// Flags of a constraint.
		/// <summary>line: the limits along the axis hold</summary>
		public const uint CN_CONSTRAINT_LIMIT = 1;
		/// <summary>destroyed beyond its break force or torque, not only reported</summary>
		public const uint CN_CONSTRAINT_BREAKS = 2;

		// Results of a cn_query_fn.
		/// <summary>ignore the shape</summary>
		public const int CN_QUERY_SKIP = 0;
		/// <summary>take it</summary>
		public const int CN_QUERY_TAKE = 1;
		/// <summary>take it, and nothing after it in the order of results</summary>
		public const int CN_QUERY_STOP = 2;

		// Flags of a query.
		/// <summary>also ignore bodies that a joint connects to ignored_body</summary>
		public const uint CN_QUERY_IGNORE_JOINED = 1;
		/// <summary>casts meet one-way shapes from their upper side (45 degrees) only, and not those that they start in by
		/// more than 0.5% of the length unit; all other queries do not see one-way shapes. Default: they are like
		/// others</summary>
		public const uint CN_QUERY_ONE_WAY = 2;
		/// <summary>casts do not hit shapes that they start in, at any depth, unless they lead farther in</summary>
		public const uint CN_QUERY_LEAVING = 4;

		// States of a time of impact.
		/// <summary>the shapes never come that close; fraction is 1</summary>
		public const int CN_IMPACT_NONE = 0;
		/// <summary>they do, at fraction</summary>
		public const int CN_IMPACT_HIT = 1;
		/// <summary>the shapes without their radii overlap at the start: fraction 0, no normal</summary>
		public const int CN_IMPACT_OVERLAP = 2;
		/// <summary>no hit before fraction, perhaps one after it: the search ended early</summary>
		public const int CN_IMPACT_FAILED = 3;

		// Flags of a mover's definition.
		/// <summary>ignore one-way shapes: set it while the character drops through one</summary>
		public const uint CN_MOVER_DROP = 1;

		// State flags of a mover.
		/// <summary>stands on walkable ground</summary>
		public const uint CN_MOVER_ON_GROUND = 1;
		/// <summary>touches a surface too steep to walk on</summary>
		public const uint CN_MOVER_ON_WALL = 2;
		/// <summary>touches a surface above it</summary>
		public const uint CN_MOVER_ON_CEILING = 4;

		// Flags of an area.
		/// <summary>bodies whose centre of mass is in it: the world's gravity and areas of lower order do not act on them</summary>
		public const uint CN_AREA_REPLACE = 1;

		// What cn_world_draw draws.
		/// <summary>coloured by type and sleep</summary>
		public const uint CN_DRAW_SHAPES = 1;
		/// <summary>and constraints: anchors, axes, limits</summary>
		public const uint CN_DRAW_JOINTS = 2;
		/// <summary>points and normals</summary>
		public const uint CN_DRAW_CONTACTS = 4;
		/// <summary>without margin</summary>
		public const uint CN_DRAW_AABBS = 8;
		/// <summary>of mass, with the bodies' names</summary>
		public const uint CN_DRAW_CENTERS = 16;
		/// <summary>colours by island</summary>
		public const uint CN_DRAW_ISLANDS = 32;

		/// <summary>Version of the library as major * 1000000 + minor * 1000 + patch.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_version();

		/// <summary>CN_ABI_VERSION of the library that was linked; a binding compares it with its own.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_abi_version();

		/// <summary>English text for a result code: static, never NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern byte* cn_result_text(int result);

		/// <summary>sizeof the struct that a CN_TYPE_ constant names, 0 for an unknown constant; bindings check their
		/// layouts with it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_sizeof(int type);

		/// <summary>Sets struct_size and the defaults given beside the fields. NULL does nothing. Defaults that scale with
		/// the length unit are stored as CN_DEFAULT, which cn_world_create resolves.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_world_def_init(cn_world_def* def);

		/// <summary>Checks a definition. Writes one sentence about its first error, at most text_bytes (&gt;= 0) bytes with
		/// the terminating zero; text may be NULL when text_bytes is 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_def_check(cn_world_def* def, byte* text, int text_bytes);

		/// <summary>Bytes that def.memory must have so that the capacities in def never run out. def.memory may be NULL
		/// here.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_bytes_needed(cn_world_def* def, ulong* out_bytes);

		/// <summary>Creates a world. CN_ERROR_MEMORY also when a thread cannot be started. Each worker takes about 150 bytes
		/// of the world's memory; its stack comes from the system, even for a world in a caller's block. Without
		/// thread support (CN_NO_THREADS, or an unknown system) the world has one worker: see
		/// cn_world_get_worker_count. O(capacities).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_create(cn_world_def* def, cn_world** out_world);

		/// <summary>Destroys a world, everything in it and its threads. A caller's block is free for other use afterwards.
		/// NULL, and a call from a callback, do nothing. O(memory blocks).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_world_destroy(cn_world* world);

		/// <summary>Takes one fixed step of dt_s seconds, 0 &lt;= dt_s &lt;= 1; 0 updates contacts and events without
		/// motion. O(awake bodies and their contacts and joints).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_step(cn_world* world, float dt_s);

		/// <summary>One sentence about the last call that failed on this world; "" if none failed or world is NULL. Valid
		/// until the next failing call.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern byte* cn_world_error_text(cn_world* world);

		/// <summary>Sets gravity in m/s^2, both finite. A change wakes every body: O(bodies).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_gravity(cn_world* world, float gravity_x_mps2, float gravity_y_mps2);

		/// <summary>Reads gravity in m/s^2.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_gravity(cn_world* world, cn_vec2* out_mps2);

		/// <summary>Sets the substeps of a step, 1 to 64. More substeps make contacts and joints stiffer and cost more.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_substep_count(cn_world* world, int count);

		/// <summary>Reads the substeps of a step.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_substep_count(cn_world* world, int* out_count);

		/// <summary>Chooses the solver (CN_SOLVER_*) from the next step on. A world in a caller's block keeps the scratch
		/// memory of the solver it was created with; a solver that needs more works without direct solving
		/// (CN_WARNING_FRAME_MEMORY).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_solver(cn_world* world, int solver);

		/// <summary>Reads the solver (CN_SOLVER_*).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_solver(cn_world* world, int* out_solver);

		/// <summary>Sets accuracy_m and work_budget as in cn_world_def: metres &gt;= 0 and 1 to 1e9, or CN_DEFAULT.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_accuracy(cn_world* world, float accuracy_m, int work_budget);

		/// <summary>Reads the accuracy in metres (the resolved default where CN_DEFAULT was set) and the work budget
		/// (CN_DEFAULT: none).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_accuracy(cn_world* world, float* out_accuracy_m, int* out_work_budget);

		/// <summary>Reads how many workers a step can use: 1, or worker_count where the library supports threads.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_worker_count(cn_world* world, int* out_count);

		/// <summary>Replaces the CN_WORLD_ flags. Clearing CN_WORLD_SLEEP wakes every body: O(bodies).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_flags(cn_world* world, uint flags);

		/// <summary>Reads the CN_WORLD_ flags.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_flags(cn_world* world, uint* out_flags);

		/// <summary>Impacts slower than this, in m/s, do not bounce; &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_restitution_threshold(cn_world* world, float speed_mps);

		/// <summary>Blows at this speed or faster, in m/s, are reported by CN_EVENT_HIT; &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_hit_speed(cn_world* world, float speed_mps);

		/// <summary>Sets the greatest linear (m/s) and angular (rad/s) speed, both &gt; 0. The end of a step slows faster
		/// bodies down to them and keeps the direction.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_speed_limits(cn_world* world, float linear_mps, float angular_radps);

		/// <summary>Sets the speed in m/s, &gt;= 0, below which bodies may sleep, and the delay in seconds, &gt;= 0, after
		/// which they do. Where all but one in 64 bodies of an island, or but one, have rested for four delays,
		/// those others that no joint holds and that are slower than four times the speed lose theirs within a
		/// second or two: what rocks in a hollow would keep all of a heap awake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_sleep(cn_world* world, float speed_mps, float delay_s);

		/// <summary>Stores a number for the user.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_user_data(cn_world* world, ulong user_data);

		/// <summary>Reads the user's number.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_user_data(cn_world* world, ulong* out_user_data);

		/// <summary>Handles of all bodies, ordered by slot. Writes at most capacity (&gt;= 0) of them; out may be NULL when
		/// capacity is 0. out_count is their number. O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_bodies(cn_world* world, cn_body* @out, int capacity, int* out_count);

		/// <summary>Handles of all shapes, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
		/// O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_shapes(cn_world* world, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Handles of all joints without constraints, ordered by slot; out, capacity and *out_count as in
		/// cn_world_get_bodies. O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_joints(cn_world* world, cn_joint* @out, int capacity, int* out_count);

		/// <summary>Reads counts of objects and what the last step reported. O(bodies + islands).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_counters(cn_world* world, cn_counters* @out);

		/// <summary>Reports every awake island, as cn_counters.islands_awake counts them: first those of several bodies, in
		/// a deterministic order, then single bodies. Writes at most capacity (&gt;= 0); *out_count is their
		/// number. A step does no work for it. O(bodies + contacts and joints of the islands written).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_islands(cn_world* world, cn_island_report* @out, int capacity, int* out_count);

		/// <summary>Reads the seconds of the last step by stage.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_profile(cn_world* world, cn_profile* @out);

		/// <summary>Reads the memory statistics.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_memory_stats(cn_world* world, cn_memory_stats* @out);

		/// <summary>Moves the origin of coordinates to the point (x_m, y_m), |x|, |y| &lt;= 1e6 length units: every position
		/// p becomes p - (x_m, y_m), so that a large world stays precise near its player. Moves bodies, boxes,
		/// world anchors of joints, and poses for interpolation; velocities, impulses, sleep and contacts stay, and
		/// no event is reported. Distances between bodies keep their digits; world anchors are rounded to floats at
		/// the new place. Arrays returned before become invalid; the user moves their own points (movers, rays,
		/// cached poses). CN_ERROR_LOCKED in callbacks. O(bodies + boxes + joints), and the next step looks at all
		/// pairs again.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_shift_origin(cn_world* world, float x_m, float y_m);

		/// <summary>64-bit hash (FNV-1a: Fowler, Noll, Vo, 1991) of every body's pose, velocity and sleep state, every
		/// contact's impulses and the solver's memory of joints, by slot. Equal histories give equal hashes on
		/// every compiler, CPU and thread count. O(bodies + contacts + joints).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_hash(cn_world* world, ulong* out_hash);

		/// <summary>Checks every invariant between the tables. CN_ERROR_INTERNAL, and one sentence in text, for the first
		/// that is broken. text holds at most text_bytes (&gt;= 0) bytes with the zero and may be NULL when
		/// text_bytes is 0. O(everything).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_validate(cn_world* world, byte* text, int text_bytes);

		/// <summary>Bytes that cn_world_save needs now. CN_ERROR_LOCKED in callbacks. O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_save_size(cn_world* world, ulong* out_bytes);

		/// <summary>Writes the world's state to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the
		/// number of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world),
		/// about 1 KB per body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_save(cn_world* world, void* @out, ulong capacity, ulong* out_bytes);

		/// <summary>Restores a saved state, into the saved world or one created with the same definition (broadphase, length
		/// unit, caller's block or not; else CN_ERROR_STATE). bytes as written by cn_world_save; CN_ERROR_FORMAT
		/// for damaged bytes or another version or machine; CN_ERROR_MEMORY without room for the objects alive then
		/// (a world in a caller's block has room for its own saves). Arrays returned before become invalid. Handles
		/// of objects alive at the save are valid again, also of objects destroyed since; handles created since are
		/// refused until the same handle is given to a new object: with the same calls to the same object. O(memory
		/// of the world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_restore(cn_world* world, void* save, ulong bytes);

		/// <summary>Bytes of the delta. CN_ERROR_FORMAT if base or save is no save. O(bytes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_save_delta_size(void* @base, ulong base_bytes, void* save, ulong save_bytes, ulong* out_bytes);

		/// <summary>Writes the delta to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and its bytes to
		/// out_bytes, which may be NULL. CN_ERROR_FORMAT as above. O(bytes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_save_delta(void* @base, ulong base_bytes, void* save, ulong save_bytes, void* @out, ulong capacity, ulong* out_bytes);

		/// <summary>Makes the save again from its base and the delta, byte for byte: writes it to out, and its bytes to
		/// out_bytes, which may be NULL. CN_ERROR_FORMAT if the delta is damaged or of another base,
		/// CN_ERROR_CAPACITY if out is too small. O(bytes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_save_apply(void* @base, ulong base_bytes, void* delta, ulong delta_bytes, void* @out, ulong capacity, ulong* out_bytes);

		/// <summary>Bytes that cn_world_write needs now. CN_ERROR_LOCKED in callbacks. O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_write_size(cn_world* world, ulong* out_bytes);

		/// <summary>Writes the world to out (any alignment, capacity bytes; CN_ERROR_CAPACITY if too small) and the number
		/// of bytes to out_bytes, which may be NULL. CN_ERROR_LOCKED in callbacks. O(memory of the world), about 1
		/// KB per body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_write(cn_world* world, void* @out, ulong capacity, ulong* out_bytes);

		/// <summary>Creates a world from bytes of cn_world_write (bytes: exactly as many). def, which may be NULL for
		/// defaults, gives memory, workers and capacities (which a caller's block needs); its settings are not
		/// used, the file's are. CN_ERROR_FORMAT for damaged or forged bytes, CN_ERROR_MEMORY without room,
		/// CN_ERROR_ARGUMENT for a definition that cn_world_create refuses. O(memory of the world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read(cn_world_def* def, void* file, ulong bytes, cn_world** out_world);

		/// <summary>Sets struct_size and the defaults given beside the fields. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_body_def_init(cn_body_def* def);

		/// <summary>Creates a body. O(1) amortized.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_create(cn_world* world, cn_body_def* def, cn_body* out_body);

		/// <summary>Creates count (&gt;= 0) bodies from an array of definitions, all or none. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_create_many(cn_world* world, cn_body_def* defs, int count, cn_body* out_bodies);

		/// <summary>Destroys a body with its shapes, contacts, joints and constraints, and wakes its neighbours. Touching
		/// contacts get their LEAVE event; joints and constraints get theirs (cn_world_joint_events). O(contacts +
		/// joints + shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_destroy(cn_world* world, cn_body body);

		/// <summary>Destroys count (&gt;= 0) bodies as cn_body_destroy does; none if a handle is bad or appears twice.
		/// O(their contacts + joints + shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_destroy_many(cn_world* world, cn_body* bodies, int count);

		/// <summary>1 if the handle names a living body of this world, else 0 (also for a NULL world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_is_valid(cn_world* world, cn_body body);

		/// <summary>Changes the type (CN_BODY_STATIC, _KINEMATIC, _DYNAMIC) and wakes the body. Its contacts end (those that
		/// still overlap begin again in the next step), with its forces and any mass override; a body made static
		/// stops. CN_ERROR_STATE if a joint would be left without a dynamic body. O(contacts + joints + shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_type(cn_world* world, cn_body body, int type);

		/// <summary>Reads the type (CN_BODY_*).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_type(cn_world* world, cn_body body, int* out_type);

		/// <summary>Replaces all CN_BODY_ flags except CN_BODY_AWAKE, which it ignores: see cn_body_set_awake. Without
		/// CN_BODY_ENABLED a body keeps its shapes but does not move or collide; its contacts end and its joints
		/// are inactive. O(contacts + joints + shapes) when CN_BODY_ENABLED changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_flags(cn_world* world, cn_body body, uint flags);

		/// <summary>Reads the CN_BODY_ flags; CN_BODY_AWAKE is set while the body is awake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_flags(cn_world* world, cn_body body, uint* out_flags);

		/// <summary>0 puts the body and its island to sleep and stops them; any other value wakes them. Static and disabled
		/// bodies are unchanged. 0 can return CN_ERROR_MEMORY. O(island).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_awake(cn_world* world, cn_body body, int awake);

		/// <summary>Teleports the body: origin in metres (|x|, |y| &lt;= 1e6 length units), angle in radians (|angle| &lt;=
		/// 1e4). Velocities stay. Contacts whose boxes no longer overlap end at once, and the next step reports
		/// them. Gaps of its joints close at some 15 length units a second. Wakes the body and its new and old
		/// neighbours. O(contacts + joints + shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_pose(cn_world* world, cn_body body, float position_x_m, float position_y_m, float angle_rad);

		/// <summary>Reads the position of the origin and the rotation.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_pose(cn_world* world, cn_body body, cn_pose* @out);

		/// <summary>Reads the position of the origin as the sum of two floats: the high part is within rounding that of
		/// cn_body_get_pose, the low part holds the digits that do not fit. Far from the origin their sum in double
		/// is more precise; so is a difference of two bodies, taken high from high and low from low, in floats.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_position_parts(cn_world* world, cn_body body, cn_vec2* out_high_m, cn_vec2* out_low_m);

		/// <summary>Reads the angle in radians, in (-pi, pi].</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_angle(cn_world* world, cn_body body, float* out_rad);

		/// <summary>Reads the world position of the centre of mass, in metres.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_center(cn_world* world, cn_body body, cn_vec2* out_m);

		/// <summary>Sets the velocity of the centre of mass (m/s) and the angular velocity (rad/s), all finite.
		/// CN_ERROR_STATE for static bodies. Wakes the body unless all are 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_velocity(cn_world* world, cn_body body, float linear_x_mps, float linear_y_mps, float angular_radps);

		/// <summary>Reads the velocity of the centre of mass (m/s) and the angular velocity (rad/s).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_velocity(cn_world* world, cn_body body, cn_velocity* @out);

		/// <summary>Sets the velocity of a kinematic body (others: CN_ERROR_STATE) so that a step of dt_s (1e-6 to 1) takes
		/// it to a pose (metres, radians) by the shorter turn, up to rounding and the world's speed limits. Unlike
		/// after cn_body_set_pose, bodies on it or in its way move along. The velocity stays: call this before
		/// every step, or stop the body after it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_target_pose(cn_world* world, cn_body body, float position_x_m, float position_y_m, float angle_rad, float dt_s);

		/// <summary>Velocity in m/s of the body's material at a world point in metres.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_velocity_at(cn_world* world, cn_body body, float point_x_m, float point_y_m, cn_vec2* out_mps);

		/// <summary>World position of a point given in the body's frame, both in metres.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_world_point(cn_world* world, cn_body body, float local_x_m, float local_y_m, cn_vec2* out_m);

		/// <summary>Position in the body's frame of a world point, both in metres.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_local_point(cn_world* world, cn_body body, float world_x_m, float world_y_m, cn_vec2* out_m);

		/// <summary>Union of the AABBs of the body's shapes, without margin; the origin as a point if it has no shapes.
		/// O(shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_aabb(cn_world* world, cn_body body, cn_aabb* @out);

		/// <summary>Adds a force in newtons at the centre of mass for the next step only; wakes the body. Static, kinematic
		/// and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the sum of forces overflows.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_force(cn_world* world, cn_body body, float force_x_N, float force_y_N);

		/// <summary>Adds a force in newtons at a world point in metres, hence a torque too; otherwise as
		/// cn_body_apply_force.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_force_at(cn_world* world, cn_body body, float force_x_N, float force_y_N, float point_x_m, float point_y_m);

		/// <summary>Adds a torque in newton metres; otherwise as cn_body_apply_force.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_torque(cn_world* world, cn_body body, float torque_Nm);

		/// <summary>Changes the velocity at once by an impulse in newton seconds at the centre of mass; wakes the body.
		/// Static, kinematic and disabled bodies are unchanged (CN_OK). CN_ERROR_ARGUMENT if the velocity
		/// overflows.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_impulse(cn_world* world, cn_body body, float impulse_x_Ns, float impulse_y_Ns);

		/// <summary>Applies an impulse in newton seconds at a world point in metres, which changes the angular velocity too;
		/// otherwise as cn_body_apply_impulse.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_impulse_at(cn_world* world, cn_body body, float impulse_x_Ns, float impulse_y_Ns, float point_x_m, float point_y_m);

		/// <summary>Changes the angular velocity at once by an angular impulse in newton metre seconds; otherwise as
		/// cn_body_apply_impulse.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_apply_angular_impulse(cn_world* world, cn_body body, float impulse_Nms);

		/// <summary>Reads mass, inertia and centre: sums over the attached shapes unless overridden. A dynamic body whose
		/// shapes have no mass weighs 1 kg; without shapes it does not rotate.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_mass_data(cn_world* world, cn_body body, cn_mass_data* @out);

		/// <summary>Overrides the mass data of a dynamic body (others: CN_ERROR_STATE) until cn_body_reset_mass_data or a
		/// change of type: mass_kg from 1e-20 to 1e20; inertia_kgm2 0 (never rotates) or from 1e-35 to 1e35. Wakes
		/// the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_mass_data(cn_world* world, cn_body body, cn_mass_data* mass);

		/// <summary>Ends a mass override: mass data come from the shapes again. Wakes the body. O(shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_reset_mass_data(cn_world* world, cn_body body);

		/// <summary>Sets the linear and angular damping in 1/s (v' = -damping v), both &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_damping(cn_world* world, cn_body body, float linear_per_s, float angular_per_s);

		/// <summary>Reads the linear and angular damping in 1/s.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_damping(cn_world* world, cn_body body, float* out_linear_per_s, float* out_angular_per_s);

		/// <summary>Sets the factor on gravity for this body, finite. A change wakes the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_gravity_scale(cn_world* world, cn_body body, float scale);

		/// <summary>Reads the factor on gravity.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_gravity_scale(cn_world* world, cn_body body, float* out_scale);

		/// <summary>Sets the body's own sleep speed in m/s, &gt;= 0; CN_DEFAULT restores the world's.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_sleep_speed(cn_world* world, cn_body body, float speed_mps);

		/// <summary>Chooses how the body's island is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO
		/// (default): the world chooses. _SOFT: contacts and joints are never solved directly, whatever other
		/// bodies ask for. _DIRECT: the island is solved directly at any speed, where its contacts permit it and
		/// within the work_budget. Takes effect with the next step; does not wake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_solver(cn_world* world, cn_body body, int solver);

		/// <summary>Reads the body's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_solver(cn_world* world, cn_body body, int* out_solver);

		/// <summary>Stores a number for the user.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_user_data(cn_world* world, cn_body body, ulong user_data);

		/// <summary>Reads the user's number.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_user_data(cn_world* world, cn_body body, ulong* out_user_data);

		/// <summary>Copies a name of at most CN_NAME_MAX_BYTES bytes (CN_ERROR_ARGUMENT beyond); NULL or "" removes it.
		/// O(length).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_set_name(cn_world* world, cn_body body, byte* name);

		/// <summary>Reads the name, "" if there is none. Valid until the name changes or the body is destroyed.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_name(cn_world* world, cn_body body, byte** out_name);

		/// <summary>Handles of the body's shapes; out, capacity and *out_count as in cn_world_get_bodies. O(shapes).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_shapes(cn_world* world, cn_body body, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Handles of the body's joints without constraints; out, capacity and *out_count as in
		/// cn_world_get_bodies. O(joints).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_joints(cn_world* world, cn_body body, cn_joint* @out, int capacity, int* out_count);

		/// <summary>Reads count poses. bodies NULL means every body in the order of cn_world_get_bodies; count must then be
		/// their number. One bad handle fails the whole call. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_poses(cn_world* world, cn_body* bodies, int count, cn_pose* @out);

		/// <summary>Reads count cn_pose at intervals of stride_bytes (0, tightly packed, or &gt;= 16); otherwise as
		/// cn_world_read_poses. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_poses_strided(cn_world* world, cn_body* bodies, int count, void* @out, int stride_bytes);

		/// <summary>Reads count velocities; bodies and count as in cn_world_read_poses. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_velocities(cn_world* world, cn_body* bodies, int count, cn_velocity* @out);

		/// <summary>Sets count velocities as cn_body_set_velocity does; bodies and count as in cn_world_read_poses. Static
		/// bodies take zero only (CN_ERROR_STATE). One bad entry fails the whole call. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_write_velocities(cn_world* world, cn_body* bodies, int count, cn_velocity* velocities);

		/// <summary>Bodies whose pose changed in the last step or that fell asleep in it, except bodies destroyed since. The
		/// first call after a step builds the array, O(awake bodies), and can return CN_ERROR_MEMORY.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_moved(cn_world* world, cn_body_moved** out_moved, int* out_count);

		/// <summary>Sets struct_size and the defaults given beside the fields. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_shape_def_init(cn_shape_def* def);

		/// <summary>Creates a circle; 0 &lt; radius_m &lt;= 1e6. Wakes the body. out_shape may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_circle(cn_world* world, cn_shape_def* def, cn_circle* circle, cn_shape* out_shape);

		/// <summary>Creates a capsule; ends at least 0.05% of the length unit apart, radius_m &gt; 0. Wakes the body.
		/// out_shape may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_capsule(cn_world* world, cn_shape_def* def, cn_capsule* capsule, cn_shape* out_shape);

		/// <summary>Creates an edge; ends at least 0.05% of the length unit apart. Wakes the body. out_shape may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_edge(cn_world* world, cn_shape_def* def, cn_edge* edge, cn_shape* out_shape);

		/// <summary>Creates a convex polygon; consecutive points at least 0.05% of the length unit apart. Wakes the body.
		/// out_shape may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_polygon(cn_world* world, cn_shape_def* def, cn_polygon* polygon, cn_shape* out_shape);

		/// <summary>Creates a box of half sizes &gt; 0; the rounding radius_m &gt;= 0 is added outside. Wakes the body.
		/// out_shape may be NULL.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_box(cn_world* world, cn_shape_def* def, float half_width_m, float half_height_m, float radius_m, cn_shape* out_shape);

		/// <summary>Creates a chain; consecutive points at least 0.05% of the length unit apart. Wakes the body. out_shape
		/// may be NULL. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_create_chain(cn_world* world, cn_shape_def* def, cn_chain* chain, cn_shape* out_shape);

		/// <summary>Attaches an unattached shape to a body and wakes the body, or those that meet the shape of a static one.
		/// CN_ERROR_STATE if the shape has a body. O(shapes of the body + edges of a chain).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_attach(cn_world* world, cn_shape shape, cn_body body);

		/// <summary>Detaches a shape from its body, ends its contacts and wakes the body. CN_ERROR_STATE if it has no body.
		/// O(contacts + shapes of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_detach(cn_world* world, cn_shape shape);

		/// <summary>Destroys a shape, ends its contacts and wakes its body. O(contacts + shapes of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_destroy(cn_world* world, cn_shape shape);

		/// <summary>1 if the handle names a living shape of this world, else 0 (also for a NULL world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_is_valid(cn_world* world, cn_shape shape);

		/// <summary>Reads the type (CN_SHAPE_CIRCLE to _CHAIN).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_type(cn_world* world, cn_shape shape, int* out_type);

		/// <summary>Reads the body; 0 if unattached.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_body(cn_world* world, cn_shape shape, cn_body* out_body);

		/// <summary>Replaces the material; applies at once, to touching contacts too, whose bodies wake. O(contacts of the
		/// body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_material(cn_world* world, cn_shape shape, cn_material* material);

		/// <summary>Reads the material.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_material(cn_world* world, cn_shape shape, cn_material* @out);

		/// <summary>Sets the density in kg/m^2, &gt;= 0, giving 0 or 1e-20 to 1e20 kg. Updates the body's mass at once and
		/// wakes the body. O(shapes of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_density(cn_world* world, cn_shape shape, float density_kgpm2);

		/// <summary>Reads the density in kg/m^2.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_density(cn_world* world, cn_shape shape, float* out_kgpm2);

		/// <summary>Replaces the filter. Contacts that it forbids end at once, with their events; contacts that it permits
		/// begin in the next step. Wakes the body, or the bodies near a static shape. O(contacts of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_filter(cn_world* world, cn_shape shape, cn_filter* filter);

		/// <summary>Reads the filter.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_filter(cn_world* world, cn_shape shape, cn_filter* @out);

		/// <summary>Sets the reported events, bits 1 &lt;&lt; CN_EVENT_*; applies at once, to present contacts too.
		/// O(contacts of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_event_mask(cn_world* world, cn_shape shape, uint event_mask);

		/// <summary>Reads the event mask.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_event_mask(cn_world* world, cn_shape shape, uint* out_event_mask);

		/// <summary>Replaces the CN_SHAPE_ flags. The shape's contacts end; those that still overlap begin again in the next
		/// step. Wakes the body, or the bodies near a static shape. O(contacts of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_flags(cn_world* world, cn_shape shape, uint flags);

		/// <summary>Reads the CN_SHAPE_ flags.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_flags(cn_world* world, cn_shape shape, uint* out_flags);

		/// <summary>Stores a number for the user.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_user_data(cn_world* world, cn_shape shape, ulong user_data);

		/// <summary>Reads the user's number.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_user_data(cn_world* world, cn_shape shape, ulong* out_user_data);

		/// <summary>AABB without margin, in the world (in the shape's own space when unattached). O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_aabb(cn_world* world, cn_shape shape, cn_aabb* @out);

		/// <summary>Mass at the present density, centre in the body's frame, inertia about the shape's own centre.
		/// O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_mass_data(cn_world* world, cn_shape shape, cn_mass_data* @out);

		/// <summary>Reads a circle in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_circle(cn_world* world, cn_shape shape, cn_circle* @out);

		/// <summary>Reads a capsule in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_capsule(cn_world* world, cn_shape shape, cn_capsule* @out);

		/// <summary>Reads an edge in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_edge(cn_world* world, cn_shape shape, cn_edge* @out);

		/// <summary>Reads a polygon in the body's frame, offset applied. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_polygon(cn_world* world, cn_shape shape, cn_polygon* @out);

		/// <summary>Reads a chain's points in the body's frame, offset applied. Writes at most capacity (&gt;= 0); out may
		/// be NULL when capacity is 0. *out_count is their number. CN_ERROR_STATE for another type. O(points
		/// written).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_chain_points(cn_world* world, cn_shape shape, cn_vec2* @out, int capacity, int* out_count);

		/// <summary>Replaces a circle in place, given in the body's frame as cn_shape_get_circle reads it, with the checks
		/// of creation: the handle and all other properties stay. Mass and box are those of the new geometry at
		/// once; contacts stay unless the boxes no longer overlap, and the next step computes them anew, without
		/// the impulses of features that are gone. Wakes the body, touching bodies and bodies that the new box
		/// meets. A shape that grows into others is pushed out of them at push_speed_max_mps at most.
		/// CN_ERROR_STATE for another type. O(contacts + shapes of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_circle(cn_world* world, cn_shape shape, cn_circle* circle);

		/// <summary>Replaces a capsule in place; otherwise as cn_shape_set_circle.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_capsule(cn_world* world, cn_shape shape, cn_capsule* capsule);

		/// <summary>Replaces an edge in place; otherwise as cn_shape_set_circle.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_edge(cn_world* world, cn_shape shape, cn_edge* edge);

		/// <summary>Replaces the points of a polygon in place, their number too; otherwise as cn_shape_set_circle.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_polygon(cn_world* world, cn_shape shape, cn_polygon* polygon);

		/// <summary>Replaces the points of a chain in place, their number too. Its contacts end; those that still overlap
		/// begin again in the next step. Otherwise as cn_shape_set_circle. O(contacts + shapes of the body +
		/// count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_chain(cn_world* world, cn_shape shape, cn_chain* chain);

		/// <summary>out_inside is 1 if the shape contains a world point in metres (in the shape's own space when
		/// unattached), else 0. Edges and chains contain no point. O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_test_point(cn_world* world, cn_shape shape, float point_x_m, float point_y_m, int* out_inside);

		/// <summary>Convex hull of count (3 to 65536) points with at most CN_POLYGON_MAX_VERTICES vertices: it inserts
		/// farthest points, as Quickhull does (Barber, Dobkin, Huhdanpaa, 1996), and keeps those that add the most
		/// area. CN_ERROR_ARGUMENT for fewer than three distinct points or collinear ones. It drops details below 5
		/// mm (below 5% of the half size for hulls under 0.1 m, below 0.5% for those over 1 m). radius_m &gt;= 0.
		/// O(count^2) at worst.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_make_hull(cn_vec2* points_m, int count, float radius_m, cn_polygon* @out);

		/// <summary>A box of half sizes &gt; 0 in metres, with its centre in metres, turned about its own centre by
		/// angle_rad (|angle| &lt;= 1e4); radius_m &gt;= 0.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_make_box(float half_width_m, float half_height_m, float center_x_m, float center_y_m, float angle_rad, float radius_m, cn_polygon* @out);

		/// <summary>Divides a simple polygon (either winding, 3 to 1024 points) into convex ones for cn_shape_create_polygon
		/// in worlds of this length unit ((1e-6 to 1e6); 1 by default), counter-clockwise, with radius_m 0 and
		/// without new points: ears are clipped (Meisters, 1975) and triangles merged (Hertel, Mehlhorn, 1983).
		/// Points nearer than 0.05% of the length unit to the one before and collinear points are dropped, and
		/// pieces thinner than that are left out. CN_ERROR_ARGUMENT for an outline that crosses or touches itself
		/// or has no area. Writes at most capacity pieces (&gt;= 0; count - 2 always suffice); out may be NULL when
		/// capacity is 0. *out_count is the number of all. 34 KB of stack. O(count^2).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_outline_decompose(cn_vec2* points_m, int count, float length_unit_m, cn_polygon* @out, int capacity, int* out_count);

		/// <summary>Keeps those of count (2 to 65536; closed: 3) points from which the simplified line deviates by more than
		/// tolerance_m (0 to 1e6), by Douglas and Peucker (1973). closed: 1 if the last point joins the first, else
		/// 0. A closed outline within tolerance_m of a segment has 0 points left. A simple outline can cross itself
		/// afterwards if parts of it are nearer than tolerance_m. Writes at most capacity points (&gt;= 0); out may
		/// be points_m, or NULL when capacity is 0. *out_count is the number of all. O(count * *out_count) at
		/// worst.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_outline_simplify(cn_vec2* points_m, int count, int closed, float tolerance_m, cn_vec2* @out, int capacity, int* out_count);

		/// <summary>An outline of the solid cells of a grid: count cells, columns (1 to 4096) in each of its rows (1 to
		/// 4096), squares of side cell_m &gt; 0 with the lower left corner of the first at the origin. cells[row *
		/// columns + column] is not 0 where solid; row 0 is the lowest. outline is the outline's number, from 0;
		/// *out_count is 0 where there are not so many. The outline is a loop for cn_shape_create_chain, solid on
		/// its left: counter-clockwise around solids, clockwise around holes. Its points are corners of cells.
		/// Solid cells that touch at a corner only are apart; an outline may pass such a corner twice. Writes at
		/// most capacity points (&gt;= 0); out may be NULL when capacity is 0. *out_count is the number of all.
		/// O(cells + n log n) for a boundary of n edges.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_outline_from_cells(byte* cells, int count, int columns, float origin_x_m, float origin_y_m, float cell_m, int outline, cn_vec2* @out, int capacity, int* out_count);

		/// <summary>The same for a field by marching squares (Lorensen, Cline, 1987): values[row * columns + column], all
		/// finite, is the value at the origin + spacing_m * (column, row), solid from threshold, with at least 2
		/// columns and rows. A point of an outline lies between two neighbouring samples, by linear interpolation,
		/// at least spacing_m / 64 from both; the grid's border closes outlines. An outline never touches itself or
		/// another one. cn_outline_simplify removes its collinear points. O(values + n log n).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_outline_from_field(float* values, int count, int columns, float threshold, float origin_x_m, float origin_y_m, float spacing_m, int outline, cn_vec2* @out, int capacity, int* out_count);

		/// <summary>The contact events of one kind (CN_EVENT_*) of the last step, in a deterministic order. The first call
		/// for a kind after a step builds the array, O(events), and can return CN_ERROR_MEMORY; CN_ERROR_LOCKED
		/// inside callbacks. Every CREATED gets a DESTROYED and every ENTER a LEAVE, however the pair ends (moved
		/// apart, body or shape destroyed, detached or disabled, filter or type changed). The next step reports
		/// pairs that end between two steps; their handles may be stale. A sleeping pair reports nothing, and
		/// continues when it wakes. HIT: in some substep a point closed at approach_speed_mps, the greatest of the
		/// step, and got an impulse; bodies that pass a blow on to others that already touch them, without closing,
		/// have no HIT. Impulses are summed only for contacts that report ENTER (in the step in which they begin),
		/// STAY or HIT.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_contact_events(cn_world* world, int kind, cn_contact_event** out_events, int* out_count);

		/// <summary>Sets the callback for contact events of one kind (CN_EVENT_*); NULL removes it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_contact_callback(cn_world* world, int kind, IntPtr function, void* user);

		/// <summary>Sets the callback that decides whether two shapes may touch; NULL removes it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_filter_callback(cn_world* world, IntPtr function, void* user);

		/// <summary>Sets the pre-solve callback; NULL removes it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_pre_solve_callback(cn_world* world, IntPtr function, void* user);

		/// <summary>Sets the callback that mixes materials; NULL removes it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_material_mix_callback(cn_world* world, IntPtr function, void* user);

		/// <summary>The sensor events of the last step, in a deterministic order; every ENTER gets a LEAVE as for contact
		/// events; a chain has one of each for all its edges. Sensors detect non-sensor shapes of dynamic and
		/// kinematic bodies by exact overlap: a chain is a line with two sides here, which meets no edges or
		/// chains. A pair without an awake body reports nothing until one wakes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_sensor_events(cn_world* world, cn_sensor_event** out_events, int* out_count);

		/// <summary>The body's contacts as events of kind STAY (touching) or CREATED (not touching), without those of
		/// sensors: see cn_shape_get_visitors. Only events have the sums of a step; here the manifold has the
		/// impulses of the last substep. At rest their force is that of the points times substep_count (with
		/// CN_SOLVER_SEQUENTIAL 1) / dt_s. Writes at most capacity (&gt;= 0); out may be NULL when capacity is 0.
		/// *out_count is their number. O(contacts).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_contacts(cn_world* world, cn_body body, cn_contact_event* @out, int capacity, int* out_count);

		/// <summary>The shape's contacts, a chain with all its edges; out, capacity, *out_count and kinds as in
		/// cn_body_get_contacts. O(contacts of its body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_contacts(cn_world* world, cn_shape shape, cn_contact_event* @out, int capacity, int* out_count);

		/// <summary>The shapes in a sensor, each once: those with an ENTER and no LEAVE up to the last step. out, capacity
		/// and *out_count as in cn_world_get_bodies. CN_ERROR_STATE for a shape that is no sensor. O(contacts of
		/// its body), squared for chains.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_visitors(cn_world* world, cn_shape sensor, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Bodies that fell asleep in the last step, or since then through cn_body_set_awake. Handles of bodies
		/// destroyed since are stale.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_fell_asleep(cn_world* world, cn_body** out_bodies, int* out_count);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_revolute_def_init(cn_revolute_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_distance_def_init(cn_distance_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_fixed_def_init(cn_fixed_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_prismatic_def_init(cn_prismatic_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_wheel_def_init(cn_wheel_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_motor_def_init(cn_motor_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_mouse_def_init(cn_mouse_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_gear_def_init(cn_gear_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_pulley_def_init(cn_pulley_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_ratchet_def_init(cn_ratchet_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_rotary_spring_def_init(cn_rotary_spring_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_groove_def_init(cn_groove_def* def);

		/// <summary>Sets base.struct_size and the defaults given beside the fields (0 where none is given). NULL does
		/// nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_filter_joint_def_init(cn_filter_joint_def* def);

		/// <summary>Creates a revolute joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_revolute(cn_world* world, cn_revolute_def* def, cn_joint* out_joint);

		/// <summary>Creates a distance joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_distance(cn_world* world, cn_distance_def* def, cn_joint* out_joint);

		/// <summary>Creates a fixed joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_fixed(cn_world* world, cn_fixed_def* def, cn_joint* out_joint);

		/// <summary>Creates a prismatic joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_prismatic(cn_world* world, cn_prismatic_def* def, cn_joint* out_joint);

		/// <summary>Creates a wheel joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_wheel(cn_world* world, cn_wheel_def* def, cn_joint* out_joint);

		/// <summary>Creates a motor joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_motor(cn_world* world, cn_motor_def* def, cn_joint* out_joint);

		/// <summary>Creates a mouse joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic, or body_a is not 0. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_mouse(cn_world* world, cn_mouse_def* def, cn_joint* out_joint);

		/// <summary>Creates a gear joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_gear(cn_world* world, cn_gear_def* def, cn_joint* out_joint);

		/// <summary>Creates a pulley joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_pulley(cn_world* world, cn_pulley_def* def, cn_joint* out_joint);

		/// <summary>Creates a ratchet joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_ratchet(cn_world* world, cn_ratchet_def* def, cn_joint* out_joint);

		/// <summary>Creates a rotary spring and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither
		/// is dynamic. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_rotary_spring(cn_world* world, cn_rotary_spring_def* def, cn_joint* out_joint);

		/// <summary>Creates a groove joint and wakes both bodies. CN_ERROR_ARGUMENT if the bodies are the same or neither is
		/// dynamic, or the slot has no length. O(contacts of body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_groove(cn_world* world, cn_groove_def* def, cn_joint* out_joint);

		/// <summary>Creates a filter joint, ends the contacts between its bodies and wakes both. CN_ERROR_ARGUMENT if the
		/// bodies are the same or neither is dynamic. It has a base only: see cn_joint_get_base. O(contacts of
		/// body_a).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_create_filter(cn_world* world, cn_filter_joint_def* def, cn_joint* out_joint);

		/// <summary>Destroys a joint and wakes its bodies. No event is reported.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_destroy(cn_world* world, cn_joint joint);

		/// <summary>1 if the handle names a living joint of this world, else 0 (also for a constraint and a NULL world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_is_valid(cn_world* world, cn_joint joint);

		/// <summary>Reads the type (CN_JOINT_REVOLUTE to _FILTER).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_type(cn_world* world, cn_joint joint, int* out_type);

		/// <summary>Reads both bodies; 0 stands for the world.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_bodies(cn_world* world, cn_joint joint, cn_body* out_a, cn_body* out_b);

		/// <summary>Reads the world positions of both anchors, in metres.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_anchors(cn_world* world, cn_joint joint, cn_vec2* out_world_a_m, cn_vec2* out_world_b_m);

		/// <summary>Force in newtons and torque in newton metres that the joint applied to body b in the last substep; 0
		/// after a change of type or of CN_BODY_ENABLED of one of its bodies.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_reaction(cn_world* world, cn_joint joint, cn_vec2* out_force_N, float* out_torque_Nm);

		/// <summary>Error of the joint's rigid parts, both &gt;= 0: metres (anchors apart, lengths beyond limits) and
		/// radians (angles beyond limits).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_error(cn_world* world, cn_joint joint, float* out_m, float* out_rad);

		/// <summary>Chooses how the joint is solved in worlds of CN_SOLVER_AUTO and _DIRECT. CN_SOLVER_AUTO (default):
		/// together with its neighbours where that is cheap. _SOFT: always alone. _DIRECT: together with all
		/// connected joints, up to the work limits of CN_SOLVER_DIRECT and the work_budget; the same as _AUTO for a
		/// world in a caller's block that was not created with CN_SOLVER_DIRECT. Takes effect with the next step;
		/// does not wake.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_solver(cn_world* world, cn_joint joint, int solver);

		/// <summary>Reads the joint's own solver (CN_SOLVER_AUTO, _SOFT, _DIRECT).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_solver(cn_world* world, cn_joint joint, int* out_solver);

		/// <summary>Stores a number for the user.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_user_data(cn_world* world, cn_joint joint, ulong user_data);

		/// <summary>Reads the user's number.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_user_data(cn_world* world, cn_joint joint, ulong* out_user_data);

		/// <summary>Replaces the CN_JOINT_ flags and wakes both bodies. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_flags(cn_world* world, cn_joint joint, uint flags);

		/// <summary>Reads the CN_JOINT_ flags.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_flags(cn_world* world, cn_joint joint, uint* out_flags);

		/// <summary>Reads the definition of a revolute joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_revolute(cn_world* world, cn_joint joint, cn_revolute_def* @out);

		/// <summary>Replaces the definition of a revolute joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_revolute(cn_world* world, cn_joint joint, cn_revolute_def* def);

		/// <summary>Reads the definition of a distance joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_distance(cn_world* world, cn_joint joint, cn_distance_def* @out);

		/// <summary>Replaces the definition of a distance joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_distance(cn_world* world, cn_joint joint, cn_distance_def* def);

		/// <summary>Reads the definition of a fixed joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_fixed(cn_world* world, cn_joint joint, cn_fixed_def* @out);

		/// <summary>Replaces the definition of a fixed joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_fixed(cn_world* world, cn_joint joint, cn_fixed_def* def);

		/// <summary>Reads the definition of a prismatic joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_prismatic(cn_world* world, cn_joint joint, cn_prismatic_def* @out);

		/// <summary>Replaces the definition of a prismatic joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_prismatic(cn_world* world, cn_joint joint, cn_prismatic_def* def);

		/// <summary>Reads the definition of a wheel joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_wheel(cn_world* world, cn_joint joint, cn_wheel_def* @out);

		/// <summary>Replaces the definition of a wheel joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_wheel(cn_world* world, cn_joint joint, cn_wheel_def* def);

		/// <summary>Reads the definition of a motor joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_motor_to(cn_world* world, cn_joint joint, cn_motor_def* @out);

		/// <summary>Replaces the definition of a motor joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_motor_to(cn_world* world, cn_joint joint, cn_motor_def* def);

		/// <summary>Reads the definition of a mouse joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_mouse(cn_world* world, cn_joint joint, cn_mouse_def* @out);

		/// <summary>Replaces the definition of a mouse joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. Sets the target too. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when
		/// CN_JOINT_COLLIDE changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_mouse(cn_world* world, cn_joint joint, cn_mouse_def* def);

		/// <summary>Reads the definition of a gear joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_gear(cn_world* world, cn_joint joint, cn_gear_def* @out);

		/// <summary>Replaces the definition of a gear joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. A new ratio starts the count of whole turns again. CN_ERROR_STATE for another type. Wakes
		/// both bodies. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_gear(cn_world* world, cn_joint joint, cn_gear_def* def);

		/// <summary>Reads the definition of a pulley joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_pulley(cn_world* world, cn_joint joint, cn_pulley_def* @out);

		/// <summary>Replaces the definition of a pulley joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_pulley(cn_world* world, cn_joint joint, cn_pulley_def* def);

		/// <summary>Reads the definition of a ratchet joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_ratchet(cn_world* world, cn_joint joint, cn_ratchet_def* @out);

		/// <summary>Replaces the definition of a ratchet joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. The ratchet starts again at its present click. CN_ERROR_STATE for another type. Wakes both
		/// bodies. O(contacts) when CN_JOINT_COLLIDE changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_ratchet(cn_world* world, cn_joint joint, cn_ratchet_def* def);

		/// <summary>Reads the definition of a rotary spring. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_rotary_spring(cn_world* world, cn_joint joint, cn_rotary_spring_def* @out);

		/// <summary>Replaces the definition of a rotary spring, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_rotary_spring(cn_world* world, cn_joint joint, cn_rotary_spring_def* def);

		/// <summary>Reads the definition of a groove joint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_groove(cn_world* world, cn_joint joint, cn_groove_def* @out);

		/// <summary>Replaces the definition of a groove joint, flags and user data included; ignores bodies, anchors and
		/// struct_size. CN_ERROR_STATE for another type. Wakes both bodies. O(contacts) when CN_JOINT_COLLIDE
		/// changes.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_groove(cn_world* world, cn_joint joint, cn_groove_def* def);

		/// <summary>Reads the base of a joint of any type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_base(cn_world* world, cn_joint joint, cn_joint_base* @out);

		/// <summary>Replaces stiffness, greatest force and torque, and break thresholds; ignores the rest of base. Ranges as
		/// in cn_joint_base. Wakes both bodies.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_base(cn_world* world, cn_joint joint, cn_joint_base* @base);

		/// <summary>Sets the target of a mouse joint, a world point in metres; cheap enough for every frame. CN_ERROR_STATE
		/// for another type. Wakes the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_target(cn_world* world, cn_joint joint, float target_x_m, float target_y_m);

		/// <summary>Reads the joint coordinate. Revolute, fixed, motor: angle b - angle a - reference (motor: without
		/// reference) in (-pi, pi]. Distance, pulley: the present length. Prismatic, wheel, groove: the translation
		/// along the axis. Mouse: the distance to the target. Gear: angle b - ratio * angle a; ratchet, rotary
		/// spring: angle b - angle a; these three over whole turns.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_position(cn_world* world, cn_joint joint, float* out_position);

		/// <summary>Rate of change of cn_joint_get_position; of a wheel joint the angular velocity of b against a. A
		/// positive motor speed has the same sign.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_get_speed(cn_world* world, cn_joint joint, float* out_speed);

		/// <summary>Sets motor speed (rad/s or m/s) and greatest torque or force (N m or N, &gt;= 0) of a revolute,
		/// distance, prismatic or wheel joint (others: CN_ERROR_STATE). Wakes both bodies.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_motor(cn_world* world, cn_joint joint, float speed, float force_or_torque_max);

		/// <summary>Sets the limits, lower &lt;= upper, of a revolute (radians in [-pi, pi]), distance (metres &gt;= 0),
		/// prismatic or wheel joint (metres); others: CN_ERROR_STATE. Wakes both bodies.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_joint_set_limits(cn_world* world, cn_joint joint, float lower, float upper);

		/// <summary>Joints and constraints that exceeded a break threshold in the last step, and those destroyed with a body
		/// in that step or between it and the step before.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_joint_events(cn_world* world, cn_joint_event** out_events, int* out_count);

		/// <summary>Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_angle_constraint_def_init(cn_angle_constraint_def* def);

		/// <summary>Sets struct_size and the defaults given beside the fields (0 where none is given). NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_line_constraint_def_init(cn_line_constraint_def* def);

		/// <summary>Creates an angle constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is
		/// not dynamic. Wakes the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_create_angle(cn_world* world, cn_angle_constraint_def* def, cn_constraint* out_constraint);

		/// <summary>Creates a line constraint, solved with the joints, before contacts. CN_ERROR_ARGUMENT if the body is not
		/// dynamic. Wakes the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_create_line(cn_world* world, cn_line_constraint_def* def, cn_constraint* out_constraint);

		/// <summary>Destroys a constraint and wakes its body. No event is reported.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_destroy(cn_world* world, cn_constraint constraint);

		/// <summary>1 if the handle names a living constraint of this world, else 0 (also for a joint and a NULL world).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_is_valid(cn_world* world, cn_constraint constraint);

		/// <summary>Reads the type (CN_CONSTRAINT_ANGLE or _LINE).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_type(cn_world* world, cn_constraint constraint, int* out_type);

		/// <summary>Reads the body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_body(cn_world* world, cn_constraint constraint, cn_body* out_body);

		/// <summary>Reads the definition of an angle constraint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_angle(cn_world* world, cn_constraint constraint, cn_angle_constraint_def* @out);

		/// <summary>Replaces the definition of an angle constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
		/// body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_set_angle(cn_world* world, cn_constraint constraint, cn_angle_constraint_def* def);

		/// <summary>Reads the definition of a line constraint. CN_ERROR_STATE for another type.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_line(cn_world* world, cn_constraint constraint, cn_line_constraint_def* @out);

		/// <summary>Replaces the definition of a line constraint; ignores body. CN_ERROR_STATE for another type. Wakes the
		/// body.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_set_line(cn_world* world, cn_constraint constraint, cn_line_constraint_def* def);

		/// <summary>Angle constraint: the angle in radians over whole turns. Line constraint: the coordinate of the point
		/// along the axis, in metres from origin.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_position(cn_world* world, cn_constraint constraint, float* out_position);

		/// <summary>Force in newtons and torque in newton metres that the constraint applied to the body in the last
		/// substep.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_reaction(cn_world* world, cn_constraint constraint, cn_vec2* out_force_N, float* out_torque_Nm);

		/// <summary>Distance beyond the allowed range, &gt;= 0: metres for a line constraint, radians for an angle
		/// constraint.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_constraint_get_error(cn_world* world, cn_constraint constraint, float* out_m, float* out_rad);

		/// <summary>Handles of all constraints, ordered by slot; out, capacity and *out_count as in cn_world_get_bodies.
		/// O(slots).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_get_constraints(cn_world* world, cn_constraint* @out, int capacity, int* out_count);

		/// <summary>Handles of the body's constraints; out, capacity and *out_count as in cn_world_get_bodies. O(joints +
		/// constraints of the body).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_body_get_constraints(cn_world* world, cn_body body, cn_constraint* @out, int capacity, int* out_count);

		/// <summary>Sets the fixed step of cn_world_update: step_s in (0, 1], default 1/60; at most steps_max steps an
		/// update, 1 to 1000, default 8.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_set_fixed_step(cn_world* world, float step_s, int steps_max);

		/// <summary>Adds elapsed_s (0 to 10) to the time owed and takes as many fixed steps as fit, at most steps_max. The
		/// event arrays hold the last step; callbacks see every step. out may be NULL. Costs as the steps.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_update(cn_world* world, float elapsed_s, cn_update_report* @out);

		/// <summary>Reads count poses between the last two steps of cn_world_update: factor 0 to 1, 0 before the last step,
		/// 1 after it. Bodies that did not take part in the last step have their present pose. bodies and count as
		/// in cn_world_read_poses. O(count).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_read_poses_interpolated(cn_world* world, cn_body* bodies, int count, float factor, cn_pose* @out);

		/// <summary>Sets the defaults given beside the fields. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_query_filter_init(cn_query_filter* filter);

		/// <summary>Nearest hit of a ray; out-&gt;shape is 0 when there is none. Edges are hit from both sides, chains from
		/// their front. Of equal hits the first by shape (in the order of cn_world_get_shapes), then child. filter
		/// may be NULL: the defaults. O(log shapes) to O(shapes along the ray).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_ray(cn_world* world, cn_ray* ray, cn_query_filter* filter, cn_ray_hit* @out);

		/// <summary>out_hit is 1 if the ray hits any shape, else 0; cheaper than the nearest hit. filter may be NULL. O(log
		/// shapes) to O(shapes along the ray).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_ray_any(cn_world* world, cn_ray* ray, cn_query_filter* filter, int* out_hit);

		/// <summary>Hits of a ray, nearest first: the nearest capacity (&gt;= 0) are written, *out_count is the number
		/// found. A chain counts once for each edge hit. filter may be NULL. O(shapes along the ray * log
		/// capacity).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_ray_all(cn_world* world, cn_ray* ray, cn_query_filter* filter, cn_ray_hit* @out, int capacity, int* out_count);

		/// <summary>Nearest hit of each of count (&gt;= 0) rays, as cn_world_cast_ray. One bad ray fails the whole call.
		/// filter may be NULL. O(sum of the rays).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_rays(cn_world* world, cn_ray* rays, int count, cn_query_filter* filter, cn_ray_hit* @out);

		/// <summary>Nearest hit of a ray against one shape, whatever its filter; in the shape's own space when unattached.
		/// O(points of the shape).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_cast_ray(cn_world* world, cn_shape shape, cn_ray* ray, cn_ray_hit* @out);

		/// <summary>First shape that a convex shape meets when moved by translation (metres, at most 2e6 length units each
		/// way) without turning. shape is a polygon in world coordinates; with radius_m &gt; 0 its count may be 1
		/// or 2: circle, capsule. A shape in contact at the start: see cn_ray_hit. A chain is met if the mean of
		/// the moving points is in front of it. filter may be NULL. O(shapes along the way).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_cast_shape(cn_world* world, cn_polygon* shape, float translation_x_m, float translation_y_m, cn_query_filter* filter, cn_ray_hit* @out);

		/// <summary>Shapes whose AABBs, without margin, overlap a box (of a chain: those of its edges), in the order of
		/// cn_world_get_shapes, each once. The first capacity (&gt;= 0) are written; *out_count is the number
		/// found. filter may be NULL. O(log shapes) to O(boxes in the region).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_aabb(cn_world* world, cn_aabb* box, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Shapes that exactly overlap a circle; order, capacity, filter and cost as in cn_world_overlap_aabb.
		/// Edges and chains are lines here, seen from both sides.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_circle(cn_world* world, cn_circle* circle, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Shapes that exactly overlap a polygon (as in cn_world_cast_shape); order, capacity, filter and cost as
		/// in cn_world_overlap_aabb. Edges and chains are lines here, seen from both sides.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_polygon(cn_world* world, cn_polygon* polygon, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Shapes that contain a world point in metres; order, capacity, filter and cost as in
		/// cn_world_overlap_aabb. Edges and chains contain no point.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_overlap_point(cn_world* world, float x_m, float y_m, cn_query_filter* filter, cn_shape* @out, int capacity, int* out_count);

		/// <summary>Shape nearest to a world point within distance_max_m (0 to 4e6 length units); the deepest if several
		/// contain the point. filter may be NULL. Cost grows with the shapes nearby, not with distance_max_m.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_closest_point(cn_world* world, float x_m, float y_m, float distance_max_m, cn_query_filter* filter, cn_closest* @out);

		/// <summary>Distance of two shapes in metres: by GJK (Gilbert, Johnson, Keerthi, 1988) when the shapes without their
		/// radii are apart, else by their Minkowski difference. Needs no world; runs in any thread. O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_distance(cn_polygon* a, cn_pose* pose_a, cn_polygon* b, cn_pose* pose_b, cn_distance* @out);

		/// <summary>Moves b by translation (at most 2e6 m each way) without turning: *out_hit is 1 if it hits a, else 0;
		/// *out as cn_ray_hit, without shape, body and child. Needs no world; runs in any thread. O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_cast(cn_polygon* a, cn_pose* pose_a, cn_polygon* b, cn_pose* pose_b, float translation_x_m, float translation_y_m, cn_ray_hit* @out, int* out_hit);

		/// <summary>Contact of two shapes as in a step, with impulses 0: no points if they are farther apart than margin_m
		/// (0 to 1e6). A single point of radius 0 gives CN_ERROR_ARGUMENT. Needs no world; runs in any thread.
		/// O(points).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_collide(cn_polygon* a, cn_pose* pose_a, cn_polygon* b, cn_pose* pose_b, float margin_m, cn_manifold* @out);

		/// <summary>First time at which two moving and turning shapes come within distance_m (0 to 1e6); fraction 0 if they
		/// start closer. Conservative advancement (Mirtich, 1996) along fixed axes (Catto, GDC 2013) never misses a
		/// hit. Needs no world; runs in any thread.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_polygon_time_of_impact(cn_polygon* a, cn_sweep* sweep_a, cn_polygon* b, cn_sweep* sweep_b, float distance_m, cn_impact* @out);

		/// <summary>Collision planes of all shapes within margin_m (0 to 1e6) of a polygon (as in cn_world_cast_shape) moved
		/// by position, from the same manifolds as in a step, rigid. Writes at most capacity, those of least
		/// separation first; *out_count is their number. Sensors have no planes. With CN_QUERY_ONE_WAY a one-way
		/// shape has a plane only on its upper side, and only for an overlap of at most 0.5% of the length unit
		/// plus its rise in the last step. Shapes wholly behind the plane of another shape are left out, so that
		/// seams of tiles do not catch (not if capacity is too small for all). O(shapes nearby, squared).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_collide(cn_world* world, cn_polygon* shape, float position_x_m, float position_y_m, float margin_m, cn_query_filter* filter, cn_plane* @out, int capacity, int* out_count);

		/// <summary>The translation nearest to a wanted one that count (0 to CN_PLANES_MAX) planes permit; exact, as in two
		/// dimensions at most two planes hold it. A plane pushes by at most push_max_m; Hildreth's method (1957)
		/// finds the planes at their limit. Sets push_m. If the surfaces leave no room, the result has the least
		/// sum of squared overlaps (Cimmino, 1938); *out_overlap_m is the deepest remaining overlap of planes below
		/// their limit, else 0 up to rounding. Needs no world. O(count^2), O(count^3) where two planes hold it.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_solve(cn_plane* planes, int count, float translation_x_m, float translation_y_m, cn_vec2* out_translation_m, float* out_overlap_m);

		/// <summary>The velocity nearest to a given one (m/s) that leads into none of the planes that pushed in the last
		/// cn_mover_solve. Needs no world. O(count^2).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_clip(cn_plane* planes, int count, float velocity_x_mps, float velocity_y_mps, cn_vec2* out_mps);

		/// <summary>Sets struct_size and the defaults given beside the fields. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_mover_def_init(cn_mover_def* def);

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
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_mover_move(cn_world* world, cn_mover_def* def, float dt_s, cn_mover* mover);

		/// <summary>Sets struct_size and the defaults given beside the fields. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_area_def_init(cn_area_def* def);

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
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_set_area(cn_world* world, cn_shape shape, cn_area_def* def);

		/// <summary>Reads the area of a sensor. CN_ERROR_STATE if it is none. O(areas).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_get_area(cn_world* world, cn_shape shape, cn_area_def* @out);

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
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_shape_apply_wind(cn_world* world, cn_shape shape, float flow_x_mps, float flow_y_mps, float drag_kgpm2, float lift_kgpm2, float dt_s, int wake);

		/// <summary>Sets struct_size and the defaults given beside the fields. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_explosion_def_init(cn_explosion_def* def);

		/// <summary>Pushes dynamic bodies away from the centre, each shape at its point nearest to the centre, and wakes
		/// them. CN_ERROR_ARGUMENT if a velocity would overflow. O(shapes in reach * log of that).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_explode(cn_world* world, cn_explosion_def* def);

		/// <summary>Sets struct_size and the defaults given beside the fields, every function to NULL. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_debug_draw_init(cn_debug_draw* draw);

		/// <summary>Draws the world through the given functions, in the calling thread. Reads only. O(bodies + shapes +
		/// contacts + joints).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_world_draw(cn_world* world, cn_debug_draw* draw);

		/// <summary>Creates a dynamic AABB tree; margin_m &gt;= 0 is added around every box. alloc and free: both NULL for
		/// malloc, or both set.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_create(float margin_m, IntPtr alloc, IntPtr free, void* allocator_user, cn_tree** out_tree);

		/// <summary>Destroys a tree. NULL does nothing.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern void cn_tree_destroy(cn_tree* tree);

		/// <summary>Inserts a finite box with lower_m &lt;= upper_m; *out_item, its handle, is never 0. O(log n).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_insert(cn_tree* tree, cn_aabb* box, ulong user_data, uint* out_item);

		/// <summary>Removes an item. CN_ERROR_HANDLE for a stale one. O(log n).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_remove(cn_tree* tree, uint item);

		/// <summary>Gives an item a new box. Nothing changes while it lies within the item's box with margin; else O(log n).
		/// CN_ERROR_HANDLE for a stale item.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_move(cn_tree* tree, uint item, cn_aabb* box);

		/// <summary>Reads the item's box with its margin. CN_ERROR_HANDLE for a stale item.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_get_box(cn_tree* tree, uint item, cn_aabb* @out);

		/// <summary>Calls visit for every item whose box with margin overlaps box, until visit returns 0. visit must not
		/// change the tree. O(log n + items visited).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_query(cn_tree* tree, cn_aabb* box, IntPtr visit, void* user);

		/// <summary>Calls visit for items whose box with margin a ray crosses; visit shortens or stops the ray by its result
		/// and must not change the tree. O(log n + items visited).</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_cast_ray(cn_tree* tree, cn_ray* ray, IntPtr visit, void* user);

		/// <summary>Reads the number of items and the height of the tree.</summary>
		[DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
		public static extern int cn_tree_get_stats(cn_tree* tree, int* out_count, int* out_height);
	}
}
