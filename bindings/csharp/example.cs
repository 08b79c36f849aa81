// Drops eight boxes and prints where they are, four times a second; one call a frame reads all poses.
// mcs -unsafe -out:build/example.exe bindings/csharp/*.cs && LD_LIBRARY_PATH=build mono build/example.exe
using System;
using Cairn;
using static Cairn.Native;
using static System.FormattableString;

static unsafe class Example
{
	static cn_world* world;

	static void Check(int result) { if (result != CN_OK) throw new Exception(Text(cn_world_error_text(world))); }

	static cn_body AddBox(int kind, float x, float y, float halfWidth, float halfHeight)
	{
		cn_body_def bodyDef; cn_shape_def shapeDef; cn_body body;
		cn_body_def_init(&bodyDef);
		bodyDef.type = kind;
		bodyDef.position_m = new cn_vec2 { x = x, y = y };
		Check(cn_body_create(world, &bodyDef, &body));
		cn_shape_def_init(&shapeDef);
		shapeDef.body = body;
		Check(cn_shape_create_box(world, &shapeDef, halfWidth, halfHeight, 0, null));
		return body;
	}

	static void Main()
	{
		const int count = 8;
		cn_body* boxes = stackalloc cn_body[count];
		cn_pose* poses = stackalloc cn_pose[count];
		cn_world_def worldDef;
		Native.Check();
		cn_world_def_init(&worldDef); // gravity (0, -10) m/s^2
		fixed (cn_world** made = &world) { if (cn_world_create(&worldDef, made) != CN_OK) throw new Exception("no world"); }
		AddBox(CN_BODY_STATIC, 0, -1, 20, 1);
		for (int i = 0; i < count; ++i) boxes[i] = AddBox(CN_BODY_DYNAMIC, 5 + 0.25f * i, 2 + 1.5f * i, 0.5f, 0.5f);
		for (int frame = 1; frame <= 120; ++frame) {
			Check(cn_world_step(world, 1.0f / 60));
			Check(cn_world_read_poses(world, boxes, count, poses));
			if (frame % 15 != 0) continue;
			Console.Write(Invariant($"{frame / 60.0:F2} s:"));
			for (int i = 0; i < count; ++i) Console.Write(Invariant($" ({poses[i].position_m.x:F2}, {poses[i].position_m.y:F2})"));
			Console.WriteLine();
		}
		cn_world_destroy(world);
	}
}
