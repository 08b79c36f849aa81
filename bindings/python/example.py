"""Drops eight boxes and prints where they are, four times a second; one call a frame reads all poses.

CAIRN_LIBRARY=build/libcairn.so PYTHONPATH=bindings/python python3 bindings/python/example.py
"""
import ctypes

from cairn import *

BOXES = 8
world, world_def = ctypes.POINTER(cn_world)(), cn_world_def()
cn_world_def_init(world_def)  # gravity (0, -10) m/s^2
if cn_world_create(world_def, world) != CN_OK:
    raise SystemExit("no world")


def check(result):
    if result != CN_OK:
        raise RuntimeError(cn_world_error_text(world).decode())


def add_box(kind, x, y, half_width, half_height):
    body_def, shape_def, body = cn_body_def(), cn_shape_def(), cn_body()
    cn_body_def_init(body_def)
    body_def.type, body_def.position_m = kind, cn_vec2(x, y)
    check(cn_body_create(world, body_def, body))
    cn_shape_def_init(shape_def)
    shape_def.body = body
    check(cn_shape_create_box(world, shape_def, half_width, half_height, 0, None))
    return body.value


add_box(CN_BODY_STATIC, 0, -1, 20, 1)
boxes = (cn_body * BOXES)(*[add_box(CN_BODY_DYNAMIC, 5 + 0.25 * i, 2 + 1.5 * i, 0.5, 0.5) for i in range(BOXES)])
poses = (cn_pose * BOXES)()
for frame in range(1, 121):
    check(cn_world_step(world, 1 / 60))
    check(cn_world_read_poses(world, boxes, BOXES, poses))
    if frame % 15 == 0:
        print("%.2f s:" % (frame / 60), *["(%.2f, %.2f)" % (pose.position_m.x, pose.position_m.y) for pose in poses])
cn_world_destroy(world)
