// The falling-hinges scene of examples/scenes/joints.c through the safe layer of C#, without unsafe; prints what bindings/test/hinges.c
// prints, after checks of what the layer adds. With the word times: nanoseconds per body for reading 1,000 poses, into an array that
// is kept. Casts round to float after every operation, as C does.
using System;
using System.Diagnostics;
using System.Runtime.InteropServices;
using Cairn;
using static Cairn.Native;

static class Layer
{
	const float Half = 0.25f, Radius = 0.025f, Lean = 0.06f, Pi = 3.14159265f;

	static Body BodyAt(World world, int kind, float x, float y)
	{
		var def = BodyDef.Default;
		def.Type = kind;
		def.PositionM = new Vec2 { X = x, Y = y };
		return world.BodyCreate(def);
	}

	static Shape AddBox(World world, Body body, float friction, float halfWidth, float halfHeight, float radius)
	{
		var def = ShapeDef.Default;
		def.Body = body;
		def.Material.StaticFriction = def.Material.DynamicFriction = friction;
		return world.ShapeCreateBox(def, halfWidth, halfHeight, radius);
	}

	static void Join(World world, Body below, Body body)
	{
		var def = RevoluteDef.Default;
		def.Base.BodyA = below;
		def.Base.BodyB = body;
		def.Base.AnchorAM = new Vec2 { X = Half, Y = Half };
		def.Base.AnchorBM = new Vec2 { X = (float)(Half - Lean), Y = -Half };
		def.Base.Flags = CN_JOINT_LIMIT;
		def.LowerAngleRad = (float)(-0.3f * Pi);
		def.UpperAngleRad = (float)(0.1f * Pi);
		world.JointCreateRevolute(def);
	}

	static void Hinges()
	{
		const int columns = 4, rows = 30, steps = 480;
		int entered = 0, called = 0;
		uint sum = 0;
		using (var world = new World()) {
			AddBox(world, BodyAt(world, CN_BODY_STATIC, 0, -1), 0.6f, 30, 1, 0);
			for (int j = 0; j < columns; ++j) {
				float x = (float)((float)(2.5f * j) - (float)(0.5f * 2.5f * (columns - 1)));
				Body below = Body.None;
				for (int i = 0; i < rows; ++i) {
					Body body = BodyAt(world, CN_BODY_DYNAMIC, (float)(x + (float)(Lean * i)), (float)(Half + (float)(2.0f * Half * i)));
					AddBox(world, body, 0.3f, (float)(Half - Radius), (float)(Half - Radius), Radius);
					if (i % 2 == 1)
						Join(world, below, body);
					below = body;
				}
			}
			var poses = new Pose[world.GetBodies().Length];
			world.OnContact(CN_EVENT_ENTER, contact => called += contact.Kind == CN_EVENT_ENTER ? 1 : 0);
			for (int step = 0; step < steps; ++step) {
				world.Step(1f / 60);
				world.ReadPoses(default(ReadOnlySpan<Body>), poses);
				entered += world.ContactEvents(CN_EVENT_ENTER).Length;
				foreach (uint word in MemoryMarshal.Cast<Pose, uint>(poses))
					sum = 31 * sum + word;
			}
			Console.WriteLine("falling_hinges: {0} steps, {1} bodies, {2} entered, {3} called, poses {4:x8}, hash {5:x16}", steps, poses.Length, entered, called, sum, world.Hash());
		}
	}

	static void Require(bool condition, string what)
	{
		if (!condition)
			throw new Exception(what);
	}

	static T Refused<T>(Action call) where T : Exception
	{
		try {
			call();
		} catch (T error) {
			return error;
		}
		throw new Exception("not refused: " + typeof(T).Name);
	}

	static void Checks()
	{
		var def = WorldDef.Default;
		def.SubstepCount = 8;
		var world = new World(def);
		Body body = BodyAt(world, CN_BODY_DYNAMIC, 0, 0);
		Shape shape = AddBox(world, body, 0.5f, 1, 1, 0);
		Require(world.GetSubstepCount() == 8 && world.BodyGetShapes(body)[0] == shape && world.OverlapPoint(0, 0)[0] == shape, "what was set is not what is read");
		var error = Refused<CairnException>(() => world.Step(-1));
		Require(error.Code == CN_ERROR_ARGUMENT && error.Message.Contains("dt_s"), error.Message);
		Refused<ArgumentException>(() => world.ReadPoses(new[] { body }, new Pose[2]));
		world.BodySetName(body, "crate");
		Require(world.BodyGetName(body) == "crate" && world.BodyIsValid(body) && !world.BodyIsValid(Body.None), "name or validity");
		world.BodySetDamping(body, 1, 2);
		var damping = world.BodyGetDamping(body);
		Require(damping.LinearPerS == 1 && damping.AngularPerS == 2, "damping");
		var shapeDef = ShapeDef.Default;
		shapeDef.Body = body;
		var points = new[] { new Vec2 { X = -1 }, new Vec2 { X = 1 }, new Vec2 { X = 2, Y = 1 } };
		Require(world.ShapeGetChainPoints(world.ShapeCreateChain(shapeDef, points, false))[2].X == 2, "chain");
		Require(Functions.PolygonMakeHull(points, 0).PointsM[0].X == -1, "hull");
		byte[] saved = world.Save();
		ulong before = world.Hash();
		world.Step(0.1f);
		Require(world.Hash() != before, "a step changed nothing");
		byte[] later = world.Save(), delta = Functions.SaveDelta(saved, later);
		Require(Functions.SaveApply(saved, delta).AsSpan().SequenceEqual(later) && delta.Length < saved.Length, "delta");
		world.Restore(saved);
		Require(world.Hash() == before, "restore gave another world");
		using (var read = World.Read(world.Write()))
			Require(read.Hash() == before && read.BodyGetName(body) == "crate", "the file has another world");
		Require(Refused<CairnException>(() => World.Read(new byte[9])).Code == CN_ERROR_FORMAT, "no world is refused");
		world.Dispose();
		world.Dispose();
		Refused<ObjectDisposedException>(() => world.Step(0.1f));
		for (int i = 0; i < 100; ++i)
			new World();
		GC.Collect();
		GC.WaitForPendingFinalizers();
	}

	static void Times()
	{
		var world = new World();
		var poses = new Pose[1000];
		for (int i = 0; i < poses.Length; ++i)
			BodyAt(world, CN_BODY_DYNAMIC, i, 0);
		TimeSpan start = Process.GetCurrentProcess().TotalProcessorTime;
		for (int i = 0; i < 5000; ++i)
			world.ReadPoses(default(ReadOnlySpan<Body>), poses);
		Console.WriteLine("{0:F2}", (Process.GetCurrentProcess().TotalProcessorTime - start).TotalMilliseconds * 1e6 / 5000 / 1000);
	}

	static void Main(string[] words)
	{
		if (words.Length > 0 && words[0] == "times") {
			Times();
			return;
		}
		Checks();
		Hinges();
	}
}
