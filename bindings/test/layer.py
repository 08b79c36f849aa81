"""The falling-hinges scene through the classes of the Python binding; prints what bindings/test/hinges.c prints, after checks of what
the layer adds. With the word times: nanoseconds per body for reading 1,000 poses, into an array that is kept.
"""
import ctypes
import gc
import sys
import time

import cairn


def f(number):
    return ctypes.c_float(number).value


HALF, RADIUS, LEAN, PI = f(0.25), f(0.025), f(0.06), f(3.14159265)


def add_box(world, body, friction, half_width, half_height, radius):
    shape = cairn.ShapeDef(body=body)
    shape.material.static_friction = shape.material.dynamic_friction = friction
    return world.shape_create_box(shape, half_width, half_height, radius)


def join(world, below, body):
    joint = cairn.RevoluteDef(lower_angle_rad=f(-f(0.3) * PI), upper_angle_rad=f(f(0.1) * PI))
    joint.base.body_a, joint.base.body_b, joint.base.flags = below, body, cairn.CN_JOINT_LIMIT
    joint.base.anchor_a_m, joint.base.anchor_b_m = (HALF, HALF), (f(HALF - LEAN), -HALF)
    world.joint_create_revolute(joint)


def hinges():
    columns, rows, steps = 4, 30, 480
    called = 0

    def on_enter(event):
        nonlocal called
        called += event.kind == cairn.CN_EVENT_ENTER

    with cairn.World() as world:
        add_box(world, world.body_create(cairn.BodyDef(type=cairn.CN_BODY_STATIC, position_m=(0, -1))), 0.6, 30, 1, 0)
        for j in range(columns):
            x, below = f(f(2.5 * j) - f(1.25 * (columns - 1))), 0
            for i in range(rows):
                body = world.body_create(cairn.BodyDef(position_m=(f(x + f(LEAN * i)), f(HALF + f(2 * HALF * i)))))
                add_box(world, body, 0.3, f(HALF - RADIUS), f(HALF - RADIUS), RADIUS)
                if i % 2 == 1:
                    join(world, below, body)
                below = body
        world.on_contact(cairn.CN_EVENT_ENTER, on_enter)
        poses = world.read_poses()
        words = memoryview(poses).cast("B").cast("I")
        total = entered = 0
        for _ in range(steps):
            world.step(1 / 60)
            world.read_poses(out=poses)
            entered += len(world.contact_events(cairn.CN_EVENT_ENTER))
            for word in words:
                total = (31 * total + word) % 2**32
        print("falling_hinges: %d steps, %d bodies, %d entered, %d called, poses %08x, hash %016x" % (steps, len(poses), entered, called, total, world.hash()))


def refused(call, error, words):
    try:
        call()
    except error as found:
        assert words in str(found), str(found)
        return found
    raise AssertionError("not refused: " + words)


def layer():
    world = cairn.World(substep_count=8)
    assert world.get_substep_count() == 8 and world.get_gravity().y == -10
    body = world.body_create(cairn.BodyDef(name=b"crate"))
    shape = add_box(world, body, 0.5, 1, 1, 0)
    assert world.body_get_name(body) == "crate" and list(world.body_get_shapes(body)) == [shape]
    assert refused(lambda: world.step(-1), cairn.Error, "dt_s").code == cairn.CN_ERROR_ARGUMENT
    assert refused(lambda: world.body_get_pose(shape), cairn.Error, "").code == cairn.CN_ERROR_HANDLE
    refused(lambda: cairn.BodyDef(mass=1), AttributeError, "mass")
    refused(lambda: world.read_poses([body], (cairn.cn_pose * 2)()), ValueError, "arrays of 1 and 2")
    assert len(world.read_poses([body, body])) == 2 and world.body_is_valid(body) and not world.body_is_valid(0)
    hit = world.cast_ray(cairn.cn_ray((-5, 0), (10, 0)))
    assert hit.shape == shape and list(world.overlap_point(0, 0)) == [shape]
    saved, before = world.save(), world.hash()
    world.step(0.1)
    moved = world.moved()
    world.step(0.1)
    assert moved[0].body == body  # a copy, valid behind the next step
    delta = cairn.save_delta(saved, world.save())
    assert cairn.save_apply(saved, delta) == world.save() and len(delta) < len(saved)
    world.restore(saved)
    assert world.hash() == before
    read = cairn.World.read(world.write(), body_capacity=4)
    assert read.hash() == before and read.body_get_name(body) == "crate"
    read.close()
    assert refused(lambda: cairn.World.read(b"no world"), cairn.Error, "").code == cairn.CN_ERROR_FORMAT
    assert cairn.polygon_make_hull([(0, 0), (1, 0), (0, 1)], 0).count == 3
    assert cairn.World.step.__doc__.startswith("Takes one fixed step") and cairn.cn_world_step.__doc__.startswith("Takes one fixed step")
    world.close()
    refused(lambda: world.step(0.1), ValueError, "closed")
    destroyed = []
    destroy = cairn.cn_world_destroy
    cairn.cn_world_destroy = lambda pointer: destroyed.append(destroy(pointer))
    del world
    cairn.World()
    gc.collect()
    assert len(destroyed) == 1  # the closed one is not destroyed again
    cairn.cn_world_destroy = destroy


def times():
    world = cairn.World()
    for i in range(1000):
        world.body_create(cairn.BodyDef(position_m=(i, 0)))
    poses = world.read_poses()
    start = time.process_time_ns()
    for _ in range(5000):
        world.read_poses(out=poses)
    print("%.2f" % ((time.process_time_ns() - start) / 5000 / 1000))


if sys.argv[1:] == ["times"]:
    times()
else:
    layer()
    hinges()
