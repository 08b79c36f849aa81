-- Drops eight boxes and prints where they are, four times a second; one call a frame reads all poses.
-- CAIRN_LIBRARY=build/libcairn.so LUA_PATH='bindings/luajit/?.lua' luajit bindings/luajit/example.lua
local ffi = require "ffi"
local cn = require "cairn"

local BOXES = 8
local world_def, out = ffi.new "cn_world_def", ffi.new "cn_world *[1]"
cn.cn_world_def_init(world_def) -- gravity (0, -10) m/s^2
assert(cn.cn_world_create(world_def, out) == cn.CN_OK)
local world = out[0]

local function check(result)
	if result ~= cn.CN_OK then error(ffi.string(cn.cn_world_error_text(world))) end
end

local function add_box(kind, x, y, half_width, half_height)
	local body_def, shape_def, body = ffi.new "cn_body_def", ffi.new "cn_shape_def", ffi.new "cn_body[1]"
	cn.cn_body_def_init(body_def)
	body_def.type, body_def.position_m.x, body_def.position_m.y = kind, x, y
	check(cn.cn_body_create(world, body_def, body))
	cn.cn_shape_def_init(shape_def)
	shape_def.body = body[0]
	check(cn.cn_shape_create_box(world, shape_def, half_width, half_height, 0, nil))
	return body[0]
end

add_box(cn.CN_BODY_STATIC, 0, -1, 20, 1)
local boxes, poses = ffi.new("cn_body[?]", BOXES), ffi.new("cn_pose[?]", BOXES)
for i = 0, BOXES - 1 do boxes[i] = add_box(cn.CN_BODY_DYNAMIC, 5 + 0.25 * i, 2 + 1.5 * i, 0.5, 0.5) end
for frame = 1, 120 do
	check(cn.cn_world_step(world, 1 / 60))
	check(cn.cn_world_read_poses(world, boxes, BOXES, poses))
	if frame % 15 == 0 then
		local line = ("%.2f s:"):format(frame / 60)
		for i = 0, BOXES - 1 do line = line .. (" (%.2f, %.2f)"):format(poses[i].position_m.x, poses[i].position_m.y) end
		print(line)
	end
end
cn.cn_world_destroy(world)
