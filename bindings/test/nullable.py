"""Asks the library whether api.json is right about NULL. Each pointer of each function is NULL once, in a world with two bodies, a
shape and a joint and with good values elsewhere: where api.json says nullable, the result must be the same as with a pointer;
elsewhere it must be CN_ERROR_ARGUMENT. Ends with "N passed, N failed, N skipped".
"""
import ctypes
import json
import os

import cairn

HERE = os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(HERE, "..", "api.json"), encoding="utf-8") as file:
    API = json.load(file)
STRUCTS = {struct["name"]: struct for struct in API["structs"]}
CALLBACKS = {callback["name"] for callback in API["callbacks"]}
COUNT = 2


def initialised(name):
    """A struct with its defaults, and two points in its arrays."""
    value = getattr(cairn, name)()
    init = getattr(cairn, name + "_init", None)
    if init:
        init(value)
    for field in STRUCTS[name]["fields"]:
        if field["pointers"] and field["length"] == "count":
            points = (cairn.cn_vec2 * 4)(cairn.cn_vec2(0, 0), cairn.cn_vec2(1, 0), cairn.cn_vec2(1, 1), cairn.cn_vec2(0, 1))
            setattr(value, field["name"], points)
            value.count = 4
    return value


class Call:
    """A world, and arguments for one function."""

    def __init__(self, function):
        world, tree = ctypes.POINTER(cairn.cn_world)(), ctypes.POINTER(cairn.cn_tree)()
        assert cairn.cn_world_create(initialised("cn_world_def"), world) == cairn.CN_OK
        assert cairn.cn_tree_create(0.1, cairn.cn_alloc_fn(), cairn.cn_free_fn(), None, tree) == cairn.CN_OK
        self.objects = {"cn_world": world, "cn_tree": tree}
        self.handles = {"cn_body": [cairn.cn_body(), cairn.cn_body()], "cn_shape": [cairn.cn_shape()], "cn_joint": [cairn.cn_joint()], "cn_constraint": [cairn.cn_constraint()]}
        for body in self.handles["cn_body"]:
            assert cairn.cn_body_create(world, initialised("cn_body_def"), body) == cairn.CN_OK
        shape = initialised("cn_shape_def")
        shape.body = self.handles["cn_body"][0].value
        assert cairn.cn_shape_create_box(world, shape, 0.5, 0.5, 0, self.handles["cn_shape"][0]) == cairn.CN_OK
        self.function = function
        self.add_joint("cn_joint", "revolute")
        self.add_joint("cn_constraint", "angle")

    def with_bodies(self, value):
        """A definition that names the world's bodies."""
        for owner, field, i in ((getattr(value, "base", value), "body_a", 0), (getattr(value, "base", value), "body_b", 1), (value, "body", 0)):
            if hasattr(owner, field):
                setattr(owner, field, self.handles["cn_body"][i].value)
        return value

    def add_joint(self, kind, default):
        """Of the type that the function is about, if it is about one."""
        about = self.function["name"].split("_", 3)[-1].replace("motor_to", "motor")
        create = getattr(cairn, "%s_create_%s" % (kind, about), None) or getattr(cairn, "%s_create_%s" % (kind, default))
        definition = self.with_bodies(initialised(create.argtypes[1]._type_.__name__))
        for owner in (definition, getattr(definition, "base", definition)):
            for field in ("length_m", "click_rad", "force_max_N", "torque_max_Nm"):  # without a default in some
                if getattr(owner, field, 1) in (0, cairn.CN_DEFAULT):
                    setattr(owner, field, 1)
        if definition.__class__ is cairn.cn_mouse_def:
            definition.base.body_a = 0
        result = create(self.objects["cn_world"], definition, self.handles[kind][0])
        assert result == cairn.CN_OK, cairn.cn_world_error_text(self.objects["cn_world"])

    def argument(self, part):
        base = part["base"]
        if part["pointers"] == 0:
            if base in self.handles:
                return self.handles[base][0]
            return COUNT if part["name"] in ("count", "capacity") else 100 if part["name"].endswith("_bytes") else 0
        if base in self.objects and part["pointers"] == 1:
            return self.objects[base]
        if base in CALLBACKS:
            return getattr(cairn, base)(lambda *_: 0)
        if part["pointers"] == 2:
            inner = ctypes.c_char_p if base == "char" else ctypes.POINTER(getattr(cairn, base))
            return ctypes.byref(inner())
        if base in ("void", "char"):
            return ctypes.create_string_buffer(100000)
        count = COUNT if part["length"] else 1
        kind = getattr(cairn, base, None) or getattr(ctypes, "c_" + base.replace("_t", ""))
        array = (kind * count)()
        for i in range(count):
            if base in STRUCTS:
                array[i] = self.with_bodies(initialised(base))
            elif base in self.handles and part["direction"] == "in":
                array[i] = self.handles[base][i].value
        return array

    def result(self, null):
        arguments = []
        for part in self.function["parameters"]:
            if part is null:
                arguments.append(getattr(cairn, part["base"])() if part["base"] in CALLBACKS else None)
            elif null is not None and not part["pointers"] and part["name"] == null["length"] != "count":
                arguments.append(0)
            else:
                arguments.append(self.argument(part))
        result = getattr(cairn, self.function["name"])(*arguments)
        if self.function["name"] != "cn_world_destroy":
            cairn.cn_world_destroy(self.objects["cn_world"])
        if self.function["name"] != "cn_tree_destroy":
            cairn.cn_tree_destroy(self.objects["cn_tree"])
        return result


def main():
    passed = failed = 0
    for function in API["functions"]:
        for part in function["parameters"]:
            if not part["pointers"] or part["name"] in ("user", "allocator_user"):
                continue
            result = Call(function).result(part)
            if function["returns"]["type"] != "cn_result":
                good = part["nullable"]  # and no crash
            elif part["nullable"]:
                good = result == Call(function).result(None) or "alloc" in part["name"] or part["base"] == "cn_free_fn"
            else:
                good = result == cairn.CN_ERROR_ARGUMENT
            passed, failed = passed + good, failed + (not good)
            if not good:
                print("FAIL %s: NULL for %s gives %d, nullable is %s" % (function["name"], part["name"], result, part["nullable"]))
    print("%d passed, %d failed, 0 skipped" % (passed, failed))


main()
