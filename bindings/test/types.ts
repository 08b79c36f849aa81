// What the types of the JavaScript package must accept and refuse; compiled by tsc, never run.
import { World, Body, Shape, CN_BODY_STATIC } from "./cairn.js";

const world = new World({ substep_count: 8 });
const body: Body = world.bodyCreate({ position_m: { x: 1 }, type: CN_BODY_STATIC });
const shape: Shape = world.shapeCreateBox({ body, material: { restitution: 0.5 } }, 1, 1, 0);
const poses: Float32Array = world.readPoses([body]);
const hash: bigint = world.hash();
const { linear_per_s, angular_per_s } = world.bodyGetDamping(body);
// @ts-expect-error
world.bodyGetPose(shape);
// @ts-expect-error
world.bodyCreate({ mass: 1 });
// @ts-expect-error
world.step();
export { poses, hash, linear_per_s, angular_per_s };
