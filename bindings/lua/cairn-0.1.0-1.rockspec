-- In the top folder: luarocks make bindings/lua/cairn-0.1.0-1.rockspec
rockspec_format = "3.0"
package = "cairn"
version = "0.1.0-1"
source = { url = "git+https://example.invalid/cairn.git" } -- where the repository is
description = { summary = "2D rigid-body physics: same input, same bits", license = "MIT" }
dependencies = { "lua >= 5.1, < 5.5" }
build = {
	type = "command",
	build_command = "python3 bindings/amalgamate.py build/lua && $(CC) $(CFLAGS) $(LIBFLAG) -I$(LUA_INCDIR) -Ibuild/lua "
		.. "bindings/lua/cairn_lua.c build/lua/cairn.c -lm -lpthread -o build/lua/cairn.so",
	install = {
		lib = { cairn = "build/lua/cairn.so" },
		lua = { ["cairn.ffi"] = "bindings/luajit/cairn.lua" }, -- for LuaJIT: C's functions, from the system's libcairn
	},
}
