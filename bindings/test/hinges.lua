-- The falling-hinges scene of examples/scenes/joints.c through the LuaJIT binding; prints what
-- bindings/test/hinges.c prints. Lua's numbers are doubles: f rounds to float after every operation,
-- as C does.
local ffi = require "ffi"
local cn = require "cairn"

local world

local function check(result)
	if result ~= cn.CN_OK then
		error(ffi.string(cn.cn_result_text(result)) .. ": " .. ffi.string(cn.cn_world_error_text(world)))
	end
end

local cell = ffi.new "float[1]"
local function f(number)
	cell[0] = number
	return cell[0]
end

local function create_body(kind, x, y)
	local def, body = ffi.new "cn_body_def", ffi.new "cn_body[1]"
	cn.cn_body_def_init(def)
	def.type = kind
	def.position_m.x, def.position_m.y = x, y
	check(cn.cn_body_create(world, def, body))
	return body[0]
end

local function add_box(body, friction, half_width, half_height, radius)
	local def = ffi.new "cn_shape_def"
	cn.cn_shape_def_init(def)
	def.body = body
	def.material.static_friction, def.material.dynamic_friction = friction, friction
	check(cn.cn_shape_create_box(world, def, half_width, half_height, radius, nil))
end

local half, radius, lean, pi = f(0.25), f(0.025), f(0.06), f(3.14159265)

local function join(below, body)
	local def, joint = ffi.new "cn_revolute_def", ffi.new "cn_joint[1]"
	cn.cn_revolute_def_init(def)
	def.base.body_a, def.base.body_b = below, body
	def.base.anchor_a_m.x, def.base.anchor_a_m.y = half, half
	def.base.anchor_b_m.x, def.base.anchor_b_m.y = f(half - lean), -half
	def.base.flags = cn.CN_JOINT_LIMIT
	def.lower_angle_rad = f(-f(0.3) * pi)
	def.upper_angle_rad = f(f(0.1) * pi)
	check(cn.cn_joint_create_revolute(world, def, joint))
end

local function add_column(x, rows)
	local below
	for i = 0, rows - 1 do
		local body = create_body(cn.CN_BODY_DYNAMIC, f(x + f(lean * i)), f(half + f(2 * half * i)))
		add_box(body, 0.3, f(half - radius), f(half - radius), radius)
		if i % 2 == 1 then
			join(below, body)
		end
		below = body
	end
end

local def, out = ffi.new "cn_world_def", ffi.new "cn_world *[1]"
cn.cn_world_def_init(def)
check(cn.cn_world_create(def, out))
world = out[0]

local columns, rows, steps = 4, 30, 480
add_box(create_body(cn.CN_BODY_STATIC, 0, -1), 0.6, 30, 1, 0)
for j = 0, columns - 1 do
	add_column(f(f(2.5 * j) - f(1.25 * (columns - 1))), rows)
end

local count = ffi.new "int32_t[1]"
check(cn.cn_world_get_bodies(world, nil, 0, count))
local poses = ffi.new("cn_pose[?]", count[0])
local words = ffi.cast("const uint32_t *", poses)
local events, event_count = ffi.new "const cn_contact_event *[1]", ffi.new "int32_t[1]"
local sum, entered, called = 0, 0, 0
local on_enter = ffi.cast("cn_contact_event_fn *", function(_, event)
	if event.kind == cn.CN_EVENT_ENTER then
		called = called + 1
	end
end)
check(cn.cn_world_set_contact_callback(world, cn.CN_EVENT_ENTER, on_enter, nil))

-- Compiled code may not call a function that calls back into Lua.
local function step()
	check(cn.cn_world_step(world, 1 / 60))
end
jit.off(step)

for _ = 1, steps do
	step()
	check(cn.cn_world_read_poses(world, nil, count[0], poses))
	check(cn.cn_world_contact_events(world, cn.CN_EVENT_ENTER, events, event_count))
	entered = entered + event_count[0]
	for i = 0, 4 * count[0] - 1 do
		sum = (31 * sum + words[i]) % 2 ^ 32
	end
end

local hash = ffi.new "uint64_t[1]"
check(cn.cn_world_hash(world, hash))
print(("falling_hinges: %d steps, %d bodies, %d entered, %d called, poses %08x, hash %s"):format(steps, count[0], entered, called, sum, bit.tohex(hash[0])))
cn.cn_world_destroy(world)
on_enter:free()
