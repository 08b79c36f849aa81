-- The falling-hinges scene through the module of bindings/lua, for Lua 5.4 and LuaJIT; prints what bindings/test/hinges.c prints, after
-- checks of what the layer adds. With the word times: nanoseconds per body for reading 1,000 poses, into a table that is kept.
local cairn = require "cairn"

-- Rounding to float, and a float's 32 bits: Lua's numbers are doubles.
local f, bits
if string.pack then
	function f(number) return (string.unpack("<f", string.pack("<f", number))) end
	function bits(number) return (string.unpack("<I4", string.pack("<f", number))) end
else
	local ffi = require "ffi"
	local cell = ffi.new "union { float number; uint32_t bits; }"
	function f(number) cell.number = number return cell.number end
	function bits(number) cell.number = number return cell.bits end
end

local half, radius, lean, pi = f(0.25), f(0.025), f(0.06), f(3.14159265)

local function add_box(world, body, friction, half_width, half_height, corner)
	local material = { static_friction = friction, dynamic_friction = friction }
	return world:shape_create_box({ body = body, material = material }, half_width, half_height, corner)
end

local function join(world, below, body)
	world:joint_create_revolute {
		base = { body_a = below, body_b = body, anchor_a_m = { half, half }, anchor_b_m = { x = f(half - lean), y = -half }, flags = cairn.JOINT_LIMIT },
		lower_angle_rad = f(-f(0.3) * pi),
		upper_angle_rad = f(f(0.1) * pi),
	}
end

local function hinges()
	local columns, rows, steps, called = 4, 30, 480, 0
	local world = cairn.world()
	add_box(world, world:body_create { type = cairn.BODY_STATIC, position_m = { 0, -1 } }, 0.6, 30, 1, 0)
	for j = 0, columns - 1 do
		local x, below = f(f(2.5 * j) - f(1.25 * (columns - 1))), nil
		for i = 0, rows - 1 do
			local body = world:body_create { position_m = { f(x + f(lean * i)), f(half + f(2 * half * i)) } }
			add_box(world, body, 0.3, f(half - radius), f(half - radius), radius)
			if i % 2 == 1 then join(world, below, body) end
			below = body
		end
	end
	world:on_contact(cairn.EVENT_ENTER, function(event)
		if event.kind == cairn.EVENT_ENTER then called = called + 1 end
	end)
	local poses, sum, entered = world:read_poses(), 0, 0
	for _ = 1, steps do
		world:step(1 / 60)
		world:read_poses(nil, poses)
		entered = entered + #world:contact_events(cairn.EVENT_ENTER)
		for _, pose in ipairs(poses) do
			sum = (31 * sum + bits(pose.position_m.x)) % 2 ^ 32
			sum = (31 * sum + bits(pose.position_m.y)) % 2 ^ 32
			sum = (31 * sum + bits(pose.cosine)) % 2 ^ 32
			sum = (31 * sum + bits(pose.sine)) % 2 ^ 32
		end
	end
	print(("falling_hinges: %d steps, %d bodies, %d entered, %d called, poses %08x, hash %s"):format(steps, #poses, entered, called, sum, world:hash()))
end

local function refused(words, call, ...)
	local fine, message = pcall(call, ...)
	assert(not fine and tostring(message):find(words, 1, true), tostring(message))
end

local function values()
	local world = cairn.world { substep_count = 8 }
	assert(world:get_substep_count() == 8 and world:get_gravity().y == -10)
	local body = world:body_create { name = "crate" }
	local shape = add_box(world, body, 0.5, 1, 1, 0)
	assert(world:body_get_name(body) == "crate" and world:body_get_shapes(body)[1] == shape and #world:body_get_shapes(body) == 1)
	refused("dt_s", world.step, world, -1)
	refused("dt_s: a number is expected, not nil", world.step, world)
	refused(cairn.result_text(cairn.ERROR_HANDLE), world.body_get_pose, world, 12345)
	refused("cn_body_def has no field 'mass'", world.body_create, world, { mass = 1 })
	refused("position_m: a table with cn_vec2 is expected, not number", world.body_create, world, { position_m = 1 })
	refused("x: a number is expected, not string", world.body_create, world, { position_m = { x = "1" } })
	refused("type: 0.5", world.body_create, world, { type = 0.5 })
	refused("arrays of different lengths", world.write_velocities, world, { body }, { {}, {} })
	assert(world:body_is_valid(body) and not world:body_is_valid(0))
	assert(world:cast_ray({ origin_m = { -5, 0 }, translation_m = { 10, 0 } }).shape == shape and world:overlap_point(0, 0)[1] == shape)
	local saved, before = world:save(), world:hash()
	world:step(0.1)
	assert(world:hash() ~= before)
	local moved = world:moved()
	world:step(0.1)
	assert(moved[1].body == body) -- a copy, valid behind the next step
	local delta = cairn.save_delta(saved, world:save())
	assert(cairn.save_apply(saved, delta) == world:save() and #delta < #saved)
	world:restore(saved)
	assert(world:hash() == before)
	local read = cairn.read(world:write(), { body_capacity = 4 })
	assert(read:hash() == before and read:body_get_name(body) == "crate")
	refused(cairn.result_text(cairn.ERROR_FORMAT), cairn.read, "no world")

	local poses = world:read_poses { body, body }
	local first = poses[1].position_m
	assert(#poses == 2 and world:read_poses({ body }, poses) == poses and #poses == 1 and poses[1].position_m == first)
	local hull = cairn.polygon_make_hull({ { 0, 0 }, { 1, 0 }, { 0, 1 } }, 0)
	assert(hull.count == 3 and #hull.points_m == 3)
	world:shape_create_polygon({ body = body }, hull)
	local chain = world:shape_create_chain({ body = body }, { points_m = { { -1, 0 }, { 1, 0 }, { 2, 1 } } })
	local points = world:shape_get_chain_points(chain)
	assert(#points == 3 and points[3].x == 2 and points[3].y == 1)
	world:body_set_user_data(body, "0xfedcba9876543210")
	assert(world:body_get_user_data(body) == "0xfedcba9876543210")
	world:body_set_user_data(body, 2 ^ 53 - 1)
	assert(world:body_get_user_data(body) == 2 ^ 53 - 1)
	refused("hexadecimal", world.body_set_user_data, world, body, "crate")
	world:destroy()
	world:destroy()
	refused("destroyed", world.step, world, 0.1)
end

-- Errors and wrong calls in callbacks, and worlds that nothing refers to but their own callbacks.
local function callbacks()
	local world = cairn.world()
	add_box(world, world:body_create { type = cairn.BODY_STATIC, position_m = { 0, -1 } }, 0.5, 10, 1, 0)
	local body, calls = world:body_create { position_m = { 0, 0.4 } }, 0
	add_box(world, body, 0.5, 0.5, 0.5, 0)
	world:on_contact(cairn.EVENT_ENTER, function(event)
		calls = calls + 1
		assert(world:body_get_pose(event.body_a) and #event.manifold.points == event.manifold.point_count)
		refused("inside a callback", world.destroy, world)
		refused(cairn.result_text(cairn.ERROR_LOCKED), world.step, world, 0.1)
		error "from the callback"
	end)
	refused("from the callback", world.step, world, 1 / 60)
	assert(calls == 1)
	world:step(1 / 60)

	local watched = setmetatable({}, { __mode = "k" })
	local owner = cairn.world()
	watched[owner] = true
	owner:on_contact(cairn.EVENT_ENTER, function() return owner end)
	owner = nil
	collectgarbage()
	collectgarbage()
	assert(next(watched) == nil)
	getmetatable(world).__gc(world) -- what the collector calls
	refused("destroyed", world.step, world, 0.1)
end

local function visitors()
	local world, shapes = cairn.world(), {}
	for i = 1, 5 do shapes[i] = add_box(world, world:body_create { type = cairn.BODY_STATIC, position_m = { i, 0 } }, 0.5, 0.4, 0.4, 0) end
	local ray, seen = { origin_m = { 0, 0 }, translation_m = { 10, 0 } }, {}
	local hit = world:cast_ray(ray, { visit = function(at)
		seen[at.shape] = true
		refused("may not change", world.step, world, 0.1)
		refused("inside a callback", world.destroy, world)
		-- a query within a visitor
		assert(world:cast_ray(ray, { visit = function(other) return other.shape == shapes[2] end }).shape == shapes[2])
		return at.shape == shapes[3] and cairn.QUERY_STOP or cairn.QUERY_SKIP
	end })
	assert(hit.shape == shapes[3] and seen[shapes[1]])
	local everything = { lower_m = { -10, -10 }, upper_m = { 10, 10 } }
	local count = 0
	assert(#world:overlap_aabb(everything, { visit = function() return true end }) == 5)
	assert(#world:overlap_aabb(everything, { visit = function() count = count + 1; return count > 5 end }) == 0) -- the second time there is no room
	refused("from the visitor", world.cast_ray, world, ray, { visit = function() error "from the visitor" end })
	refused("a visitor returns", world.cast_ray, world, ray, { visit = function() end })
	refused("function expected", world.cast_ray, world, ray, { visit = 1 })
	world:explode { radius_m = 5, impulse_Nspm = 1, filter = { visit = function() return false end } }
	world:step(0.1)
end

local function trees()
	local tree = cairn.tree(0.1)
	local item = tree:insert({ lower_m = { 0, 0 }, upper_m = { 1, 1 } }, 7)
	assert(item ~= 0 and tree:get_stats() == 1)
end

-- Every function with arguments of every type, also wrong ones: an error or a result, never a crash.
local function any_arguments()
	local calls, body = 0, nil
	local function try(functions, self)
		for name, call in pairs(functions) do
			if type(call) == "function" and name ~= "destroy" then
				for _, value in ipairs { 0, 1, -1, 0.5, 1e300, "text", true, {}, { 1, 2 }, { {} }, { body }, print } do
					local fine, message = pcall(call, self or value, value, value, value, value, value, value)
					assert(fine or type(message) == "string" and #message > 0, name)
					pcall(call, self or value, body, value, value)
					pcall(call, self)
					calls = calls + 3
				end
			end
		end
	end
	local world = cairn.world()
	body = world:body_create {}
	try(getmetatable(world).__index, world)
	local tree = cairn.tree(0.1)
	try(getmetatable(tree).__index, tree)
	try(cairn)
	assert(calls > 5000 and pcall(world.step, world, 1 / 60))
end

local function times()
	local world = cairn.world()
	for i = 1, 1000 do world:body_create { position_m = { i, 0 } } end
	local poses = world:read_poses()
	local start = os.clock()
	for _ = 1, 500 do world:read_poses(nil, poses) end
	print(("%.0f"):format((os.clock() - start) * 1e9 / 500 / 1000))
end

if arg[1] == "times" then
	times()
else
	values()
	callbacks()
	visitors()
	trees()
	any_arguments()
	hinges()
end
