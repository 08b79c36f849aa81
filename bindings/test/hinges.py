"""The falling-hinges scene of examples/scenes/joints.c through the Python binding; prints what
bindings/test/hinges.c prints. Python's numbers are doubles: f rounds to float after every operation,
as C does.
"""
import ctypes

from cairn import *

world = ctypes.POINTER(cn_world)()


def check(result):
    if result != CN_OK:
        raise RuntimeError(cn_result_text(result).decode() + ": " + cn_world_error_text(world).decode())


def f(number):
    return ctypes.c_float(number).value


def create_body(kind, x, y):
    definition, body = cn_body_def(), cn_body()
    cn_body_def_init(definition)
    definition.type = kind
    definition.position_m = cn_vec2(x, y)
    check(cn_body_create(world, definition, body))
    return body.value


def add_box(body, friction, half_width, half_height, radius):
    definition = cn_shape_def()
    cn_shape_def_init(definition)
    definition.body = body
    definition.material.static_friction = definition.material.dynamic_friction = friction
    check(cn_shape_create_box(world, definition, half_width, half_height, radius, None))


HALF, RADIUS, LEAN, PI = f(0.25), f(0.025), f(0.06), f(3.14159265)


def join(below, body):
    definition, joint = cn_revolute_def(), cn_joint()
    cn_revolute_def_init(definition)
    definition.base.body_a, definition.base.body_b = below, body
    definition.base.anchor_a_m = cn_vec2(HALF, HALF)
    definition.base.anchor_b_m = cn_vec2(f(HALF - LEAN), -HALF)
    definition.base.flags = CN_JOINT_LIMIT
    definition.lower_angle_rad = f(-f(0.3) * PI)
    definition.upper_angle_rad = f(f(0.1) * PI)
    check(cn_joint_create_revolute(world, definition, joint))


def add_column(x, rows):
    below = 0
    for i in range(rows):
        body = create_body(CN_BODY_DYNAMIC, f(x + f(LEAN * i)), f(HALF + f(2 * HALF * i)))
        add_box(body, 0.3, f(HALF - RADIUS), f(HALF - RADIUS), RADIUS)
        if i % 2 == 1:
            join(below, body)
        below = body


called = 0


@cn_contact_event_fn
def on_enter(_world, event, _user):
    global called
    called += event.contents.kind == CN_EVENT_ENTER


def main():
    columns, rows, steps = 4, 30, 480
    definition = cn_world_def()
    cn_world_def_init(definition)
    check(cn_world_create(definition, world))
    add_box(create_body(CN_BODY_STATIC, 0, -1), 0.6, 30, 1, 0)
    for j in range(columns):
        add_column(f(f(2.5 * j) - f(1.25 * (columns - 1))), rows)

    count = ctypes.c_int32()
    check(cn_world_get_bodies(world, None, 0, count))
    poses = (cn_pose * count.value)()
    words = memoryview(poses).cast("B").cast("I")
    events, event_count = ctypes.POINTER(cn_contact_event)(), ctypes.c_int32()
    total = entered = 0
    check(cn_world_set_contact_callback(world, CN_EVENT_ENTER, on_enter, None))
    for _ in range(steps):
        check(cn_world_step(world, 1 / 60))
        check(cn_world_read_poses(world, None, count, poses))
        check(cn_world_contact_events(world, CN_EVENT_ENTER, events, event_count))
        entered += event_count.value
        for word in words:
            total = (31 * total + word) % 2**32

    check(cn_world_set_contact_callback(world, CN_EVENT_ENTER, cn_contact_event_fn(), None))  # removes it
    state = ctypes.c_uint64()
    check(cn_world_hash(world, state))
    print("falling_hinges: %d steps, %d bodies, %d entered, %d called, poses %08x, hash %016x" % (steps, count.value, entered, called, total, state.value))
    cn_world_destroy(world)


main()
