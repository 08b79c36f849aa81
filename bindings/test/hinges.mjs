// The falling-hinges scene of examples/scenes/joints.c through the JavaScript package in the folder given first; prints what
// bindings/test/hinges.c prints, but for callbacks. Math.fround rounds to float after every operation, as C does. With the word times:
// nanoseconds per body for reading 1,000 poses, into an array that is kept.
import assert from "node:assert";
import { pathToFileURL } from "node:url";

const cairn = await import(pathToFileURL(process.argv[2] + "/cairn.js"));
const { World, CN_BODY_STATIC, CN_JOINT_LIMIT, CN_EVENT_ENTER } = cairn;
const f = Math.fround;
const HALF = f(0.25), RADIUS = f(0.025), LEAN = f(0.06), PI = f(3.14159265);

function addBox(world, body, friction, halfWidth, halfHeight, radius) {
	return world.shapeCreateBox({ body, material: { static_friction: friction, dynamic_friction: friction } }, halfWidth, halfHeight, radius);
}

function join(world, below, body) {
	world.jointCreateRevolute({
		base: { body_a: below, body_b: body, anchor_a_m: { x: HALF, y: HALF }, anchor_b_m: { x: f(HALF - LEAN), y: -HALF }, flags: CN_JOINT_LIMIT },
		lower_angle_rad: f(-f(0.3) * PI), upper_angle_rad: f(f(0.1) * PI),
	});
}

function hinges() {
	const columns = 4, rows = 30, steps = 480, world = new World();
	addBox(world, world.bodyCreate({ type: CN_BODY_STATIC, position_m: { x: 0, y: -1 } }), 0.6, 30, 1, 0);
	for (let j = 0; j < columns; ++j) {
		const x = f(f(2.5 * j) - f(1.25 * (columns - 1)));
		for (let i = 0, below = 0; i < rows; ++i) {
			const body = world.bodyCreate({ position_m: { x: f(x + f(LEAN * i)), y: f(HALF + f(2 * HALF * i)) } });
			addBox(world, body, 0.3, f(HALF - RADIUS), f(HALF - RADIUS), RADIUS);
			if (i % 2 === 1)
				join(world, below, body);
			below = body;
		}
	}
	const poses = world.readPoses(), words = new Uint32Array(poses.buffer);
	let entered = 0, sum = 0;
	for (let step = 0; step < steps; ++step) {
		world.step(1 / 60);
		world.readPoses(null, poses);
		entered += world.contactEvents(CN_EVENT_ENTER).length;
		for (const word of words)
			sum = (Math.imul(31, sum) + word) >>> 0;
	}
	const hex = (number, digits) => number.toString(16).padStart(digits, "0");
	console.log(`falling_hinges: ${steps} steps, ${poses.length / 4} bodies, ${entered} entered, poses ${hex(sum, 8)}, hash ${hex(world.hash(), 16)}`);
	world.destroy();
}

function layer() {
	const world = new World({ substep_count: 8 }), body = world.bodyCreate({ name: "crate", user_data: 2n ** 63n });
	const shape = addBox(world, body, 0.5, 1, 1, 0);
	assert.equal(world.getSubstepCount(), 8);
	assert.equal(world.bodyGetName(body), "crate");
	assert.equal(world.bodyGetUserData(body), 2n ** 63n);
	assert.deepEqual(world.bodyGetShapes(body), [shape]);
	assert.deepEqual(world.overlapPoint(0, 0), [shape]);
	assert.equal(world.castRay({ origin_m: { x: -5, y: 0 }, translation_m: { x: 10, y: 0 } }).shape, shape);
	assert.throws(() => world.step(-1), error => error.code === cairn.CN_ERROR_ARGUMENT && error.message.includes("dt_s"));
	assert.throws(() => world.bodyGetPose(shape), error => error.code === cairn.CN_ERROR_HANDLE);
	assert.throws(() => world.bodyCreate({ mass: 1 }), /no field mass/);
	assert.throws(() => world.readPoses([body], new Float32Array(8)), RangeError);
	const chain = world.shapeCreateChain({ body }, { points_m: [{ x: -1, y: 0 }, { x: 1, y: 0 }, { x: 2, y: 1 }] });
	assert.deepEqual([...world.shapeGetChainPoints(chain)], [-1, 0, 1, 0, 2, 1]);
	const bodies = world.bodyCreateMany(Array.from({ length: 3000 }, (_, i) => ({ position_m: { x: i, y: 50 } }))); // more than the scratch block holds
	assert.equal(world.readPoses(bodies).at(-4), 2999);
	const saved = world.save(), before = world.hash();
	world.step(0.1);
	assert.notEqual(world.hash(), before);
	const later = world.save(), delta = cairn.saveDelta(saved, later);
	assert.deepEqual(cairn.saveApply(saved, delta), later);
	assert(delta.length < saved.length);
	world.restore(saved);
	assert.equal(world.hash(), before);
	const read = World.read(world.write());
	assert.equal(read.hash(), before);
	read.destroy();
	assert.throws(() => World.read(delta), { code: cairn.CN_ERROR_FORMAT });
	assert.equal(cairn.polygonMakeHull([{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0, y: 1 }], 0).count, 3);
	const mover = { position_m: { x: 0, y: 30 } };
	world.moverMove({}, 0.1, mover);
	assert(mover.velocity_mps.y < 0);
	world.destroy();
	assert.throws(() => world.step(0.1), /destroyed/);
}

function times() {
	const world = new World();
	for (let i = 0; i < 1000; ++i)
		world.bodyCreate({ position_m: { x: i, y: 0 } });
	const poses = world.readPoses(), rounds = 5000;
	const start = process.cpuUsage();
	for (let i = 0; i < rounds; ++i)
		world.readPoses(null, poses);
	const spent = process.cpuUsage(start);
	console.log(((spent.user + spent.system) * 1000 / rounds / 1000).toFixed(2));
}

if (process.argv[3] === "times")
	times();
else {
	layer();
	hinges();
}
