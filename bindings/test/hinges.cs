// The falling-hinges scene of examples/scenes/joints.c through the C# binding; prints what
// bindings/test/hinges.c prints. C# may compute with more than float: casts round after every
// operation, as C does.
using System;
using System.Runtime.InteropServices;
using Cairn;
using static Cairn.Native;

static unsafe class Hinges
{
	const float Half = 0.25f, Radius = 0.025f, Lean = 0.06f, Pi = 3.14159265f;
	static cn_world* world;
	static int called;
	static readonly cn_contact_event_fn onEnter = OnEnter; // the library keeps a pointer that C# does not see

	static void OnEnter(cn_world* from, cn_contact_event* contact, void* user)
	{
		called += contact->kind == CN_EVENT_ENTER ? 1 : 0;
	}

	static void Check(int result)
	{
		if (result != CN_OK)
			throw new InvalidOperationException(Text(cn_result_text(result)) + ": " + Text(cn_world_error_text(world)));
	}

	static cn_body CreateBody(int kind, float x, float y)
	{
		cn_body_def def;
		cn_body body;
		cn_body_def_init(&def);
		def.type = kind;
		def.position_m.x = x;
		def.position_m.y = y;
		Check(cn_body_create(world, &def, &body));
		return body;
	}

	static void AddBox(cn_body body, float friction, float halfWidth, float halfHeight, float radius)
	{
		cn_shape_def def;
		cn_shape_def_init(&def);
		def.body = body;
		def.material.static_friction = friction;
		def.material.dynamic_friction = friction;
		Check(cn_shape_create_box(world, &def, halfWidth, halfHeight, radius, null));
	}

	static void Join(cn_body below, cn_body body)
	{
		cn_revolute_def def;
		cn_joint joint;
		cn_revolute_def_init(&def);
		def.@base.body_a = below;
		def.@base.body_b = body;
		def.@base.anchor_a_m = new cn_vec2 { x = Half, y = Half };
		def.@base.anchor_b_m = new cn_vec2 { x = (float)(Half - Lean), y = -Half };
		def.@base.flags = CN_JOINT_LIMIT;
		def.lower_angle_rad = (float)(-0.3f * Pi);
		def.upper_angle_rad = (float)(0.1f * Pi);
		Check(cn_joint_create_revolute(world, &def, &joint));
	}

	static void AddColumn(float x, int rows)
	{
		cn_body below = cn_body.none;
		for (int i = 0; i < rows; ++i) {
			cn_body body = CreateBody(CN_BODY_DYNAMIC, (float)(x + (float)(Lean * i)), (float)(Half + (float)(2.0f * Half * i)));
			AddBox(body, 0.3f, (float)(Half - Radius), (float)(Half - Radius), Radius);
			if (i % 2 == 1)
				Join(below, body);
			below = body;
		}
	}

	static void Main()
	{
		const int columns = 4, rows = 30, steps = 480;
		cn_world_def def;
		cn_world* made;
		Native.Check();
		Marshal.PrelinkAll(typeof(Native)); // fails if the library lacks a function
		cn_world_def_init(&def);
		Check(cn_world_create(&def, &made));
		world = made;
		AddBox(CreateBody(CN_BODY_STATIC, 0.0f, -1.0f), 0.6f, 30.0f, 1.0f, 0.0f);
		for (int j = 0; j < columns; ++j)
			AddColumn((float)((float)(2.5f * j) - (float)(1.25f * (columns - 1))), rows);

		int count;
		Check(cn_world_get_bodies(world, null, 0, &count));
		var poses = new cn_pose[count];
		uint sum = 0;
		cn_contact_event* events;
		int entered = 0, eventCount;
		Check(cn_world_set_contact_callback(world, CN_EVENT_ENTER, Marshal.GetFunctionPointerForDelegate(onEnter), null));
		fixed (cn_pose* first = poses) {
			for (int step = 0; step < steps; ++step) {
				Check(cn_world_step(world, 1.0f / 60.0f));
				Check(cn_world_read_poses(world, null, count, first));
				Check(cn_world_contact_events(world, CN_EVENT_ENTER, &events, &eventCount));
				entered += eventCount;
				for (int i = 0; i < 4 * count; ++i)
					sum = unchecked(31 * sum + ((uint*)first)[i]);
			}
		}

		ulong hash;
		Check(cn_world_hash(world, &hash));
		Console.WriteLine("falling_hinges: {0} steps, {1} bodies, {2} entered, {3} called, poses {4:x8}, hash {5:x16}", steps, count, entered, called, sum, hash);
		cn_world_destroy(world);
	}
}
