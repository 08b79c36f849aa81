/*
 * cairn_lua.c - the module "cairn" for Lua 5.1 to 5.4 and LuaJIT, with one API:
 *
 *     local cairn = require "cairn"
 *     local world = cairn.world { substep_count = 4 }
 *     local body = world:body_create { type = cairn.BODY_DYNAMIC, position_m = { 0, 4 } }
 *     world:shape_create_circle({ body = body }, 0.5)
 *     world:step(1 / 60)
 *     print(world:body_get_pose(body).position_m.y)
 *
 * A method is C's function without cn_ and without the world; its outputs are returned. Structs are tables with C's names, where a field
 * that is absent has its default; arrays are tables from 1. The garbage collector destroys worlds, or destroy(). A call that fails is an
 * error with the library's sentence. calls.h, which is generated, has the functions; this file has the conversions.
 */
#include "cairn.h"
#include <lauxlib.h>
#include <lua.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#if LUA_VERSION_NUM < 502
#define lua_setuservalue lua_setfenv
#define lua_getuservalue lua_getfenv
#define lua_rawlen lua_objlen
#endif
#if defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

#define WHOLE_MAX 9007199254740992.0 /* 2^53: whole numbers below it are exact in every Lua */

/* ---------------------------------------------------------------- values */

typedef enum value_kind { FLOAT, INT32, UINT32, UINT64, UINT8, RECORD, TEXT, POINTS, VISITOR } value_kind;

typedef struct record record;

typedef struct field {
	const char *name; /* NULL ends the fields */
	size_t offset;
	value_kind kind;
	int32_t array; /* elements of an array in the struct, else 0 */
	const record *of;
} field;

struct record {
	const char *name;
	size_t size;
	const field *fields;
	void (*init)(void *at); /* NULL: zeros */
	ptrdiff_t count;        /* offset of the int32_t that counts the struct's array, or -1 */
};

static const record record_cn_vec2, record_cn_ray_hit;

static const size_t sizes[] = { sizeof(float), sizeof(int32_t), sizeof(uint32_t), sizeof(uint64_t), sizeof(uint8_t) };

static size_t size_of(value_kind kind, const record *of)
{
	return kind == RECORD ? of->size : sizes[kind];
}

static void *buffer(lua_State *L, int32_t count, size_t size)
{
	return lua_newuserdata(L, count > 0 ? (size_t)count * size : 1);
}

static int absolute(lua_State *L, int index)
{
	return index < 0 ? lua_gettop(L) + 1 + index : index;
}

static void push_whole(lua_State *L, int64_t number)
{
#if LUA_VERSION_NUM >= 503
	lua_pushinteger(L, (lua_Integer)number);
#else
	lua_pushnumber(L, (lua_Number)number);
#endif
}

static void push_hash(lua_State *L, uint64_t hash)
{
	char text[17];
	for (int i = 15; i >= 0; --i, hash >>= 4)
		text[i] = "0123456789abcdef"[hash & 15];
	text[16] = 0;
	lua_pushstring(L, text);
}

/* Numbers of 64 bits that a double does not hold are text, "0x" and 16 digits, in every Lua. */
static void push_uint64(lua_State *L, uint64_t number)
{
	if (number < (uint64_t)WHOLE_MAX) {
		push_whole(L, (int64_t)number);
		return;
	}
	lua_pushliteral(L, "0x");
	push_hash(L, number);
	lua_concat(L, 2);
}

static double read_whole(lua_State *L, int index, double lowest, double highest, const char *name)
{
	if (lua_type(L, index) == LUA_TBOOLEAN)
		return lua_toboolean(L, index);
	if (lua_type(L, index) != LUA_TNUMBER)
		luaL_error(L, "%s: a number is expected, not %s", name, luaL_typename(L, index));
	double number = lua_tonumber(L, index);
	if (!(number >= lowest && number <= highest) || floor(number) != number)
		luaL_error(L, "%s: %f is no whole number from %f to %f", name, number, lowest, highest);
	return number;
}

static uint64_t read_uint64(lua_State *L, int index, const char *name)
{
	if (lua_type(L, index) == LUA_TSTRING) {
		const char *text = lua_tostring(L, index);
		char *end;
		uint64_t number = strtoull(text, &end, 16);
		if (end == text || *end != 0)
			luaL_error(L, "%s: '%s' is no hexadecimal number", name, text);
		return number;
	}
#if LUA_VERSION_NUM >= 503
	if (lua_isinteger(L, index))
		return (uint64_t)lua_tointeger(L, index);
#endif
	return (uint64_t)read_whole(L, index, 0, WHOLE_MAX, name);
}

static void read_record(lua_State *L, int index, const record *of, void *at);

static void read_value(lua_State *L, int index, value_kind kind, const record *of, void *at, const char *name)
{
	float number = 0;
	int32_t whole = 0;
	uint32_t natural = 0;
	uint64_t wide = 0;
	switch (kind) {
		case FLOAT:
			if (lua_type(L, index) != LUA_TNUMBER)
				luaL_error(L, "%s: a number is expected, not %s", name, luaL_typename(L, index));
			number = (float)lua_tonumber(L, index);
			memcpy(at, &number, sizeof number);
			break;
		case INT32:
			whole = (int32_t)read_whole(L, index, INT32_MIN, INT32_MAX, name);
			memcpy(at, &whole, sizeof whole);
			break;
		case UINT32:
			natural = (uint32_t)read_whole(L, index, 0, UINT32_MAX, name);
			memcpy(at, &natural, sizeof natural);
			break;
		case UINT64:
			wide = read_uint64(L, index, name);
			memcpy(at, &wide, sizeof wide);
			break;
		case UINT8:
			*(uint8_t *)at = (uint8_t)read_whole(L, index, 0, UINT8_MAX, name);
			break;
		case RECORD:
			if (lua_type(L, index) != LUA_TTABLE)
				luaL_error(L, "%s: a table with %s is expected, not %s", name, of->name, luaL_typename(L, index));
			read_record(L, index, of, at);
			break;
		default: break; /* TEXT, POINTS, VISITOR: read_field */
	}
}

/* The elements of a table from 1 into an array. */
static void read_elements(lua_State *L, int index, value_kind kind, const record *of, void *at, int32_t count, const char *name)
{
	index = absolute(L, index);
	luaL_checkstack(L, 8, "tables in tables");
	for (int32_t i = 0; i < count; ++i) {
		lua_rawgeti(L, index, i + 1);
		read_value(L, -1, kind, of, (char *)at + (size_t)i * size_of(kind, of), name);
		lua_pop(L, 1);
	}
}

static int32_t table_count(lua_State *L, int index, const char *name)
{
	if (lua_type(L, index) != LUA_TTABLE)
		luaL_error(L, "%s: a table is expected, not %s", name, luaL_typename(L, index));
	size_t count = lua_rawlen(L, index);
	if (count > INT32_MAX)
		luaL_error(L, "%s: too many elements", name);
	return (int32_t)count;
}

static void read_visitor(lua_State *L, cn_query_filter *filter);

/* The field's value is on top of the stack with its key below. */
static void read_field(lua_State *L, const record *of, const field *to, char *at)
{
	char *place = at + to->offset;
	int32_t count = -1;
	if (to->kind == TEXT) { /* the table keeps the text while the call lasts */
		if (lua_type(L, -1) != LUA_TSTRING)
			luaL_error(L, "%s: a string is expected, not %s", to->name, luaL_typename(L, -1));
		const char *text = lua_tostring(L, -1);
		memcpy(place, &text, sizeof text);
	} else if (to->kind == VISITOR) {
		read_visitor(L, (cn_query_filter *)(void *)at);
	} else if (to->kind == POINTS) {
		count = table_count(L, -1, to->name);
		cn_vec2 *points = buffer(L, count, sizeof(cn_vec2));
		read_elements(L, -2, RECORD, &record_cn_vec2, points, count, to->name);
		lua_insert(L, -3); /* kept below the key */
		memcpy(place, &points, sizeof points);
	} else if (to->array) {
		count = table_count(L, -1, to->name);
		if (count > to->array)
			luaL_error(L, "%s: more than %d elements", to->name, (int)to->array);
		read_elements(L, -1, to->kind, to->of, place, count, to->name);
	} else {
		read_value(L, -1, to->kind, to->of, place, to->name);
	}
	if (count >= 0 && of->count >= 0)
		memcpy(at + of->count, &count, sizeof count);
}

static const field *find_field(lua_State *L, const record *of)
{
	if (lua_type(L, -2) == LUA_TNUMBER && of == &record_cn_vec2) { /* { x, y } */
		lua_Number i = lua_tonumber(L, -2);
		return i == 1 ? &of->fields[0] : i == 2 ? &of->fields[1] : NULL;
	}
	if (lua_type(L, -2) != LUA_TSTRING)
		return NULL;
	const char *name = lua_tostring(L, -2);
	const field *to = of->fields;
	while (to->name && strcmp(to->name, name) != 0)
		++to;
	return to->name ? to : NULL;
}

static void read_record(lua_State *L, int index, const record *of, void *at)
{
	index = absolute(L, index);
	luaL_checkstack(L, 8, "tables in tables");
	for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
		const field *to = find_field(L, of);
		if (!to) {
			lua_pop(L, 1);
			luaL_error(L, "%s has no field '%s'", of->name, lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : luaL_typename(L, -1));
		} else if ((ptrdiff_t)to->offset != of->count) { /* the array has its count */
			read_field(L, of, to, at);
		}
	}
}

static void *read_struct(lua_State *L, int index, const record *of, void *at, int nullable, const char *name)
{
	if (nullable && lua_isnoneornil(L, index))
		return NULL;
	memset(at, 0, of->size);
	if (of->init)
		of->init(at);
	read_value(L, index, RECORD, of, at, name);
	return at;
}

/* A copy of a table's elements, which the stack keeps. */
static void *read_array(lua_State *L, int index, value_kind kind, const record *of, int nullable, const char *name, int32_t *count)
{
	size_t size = size_of(kind, of);
	*count = 0;
	if (nullable && lua_isnoneornil(L, index))
		return NULL;
	*count = table_count(L, index, name);
	char *array = buffer(L, *count, size);
	memset(array, 0, (size_t)*count * size);
	for (int32_t i = 0; of && of->init && i < *count; ++i)
		of->init(array + (size_t)i * size);
	read_elements(L, index, kind, of, array, *count, name);
	return array;
}

static void even(lua_State *L, int index, int condition)
{
	luaL_argcheck(L, condition, index, "arrays of different lengths");
}

static void write_record(lua_State *L, const record *of, const void *at);

static void push_value(lua_State *L, value_kind kind, const record *of, const void *at)
{
	float number;
	int32_t whole;
	uint32_t natural;
	uint64_t wide;
	switch (kind) {
		case FLOAT:
			memcpy(&number, at, sizeof number);
			lua_pushnumber(L, (lua_Number)number);
			break;
		case INT32:
			memcpy(&whole, at, sizeof whole);
			push_whole(L, whole);
			break;
		case UINT32:
			memcpy(&natural, at, sizeof natural);
			push_whole(L, natural);
			break;
		case UINT64:
			memcpy(&wide, at, sizeof wide);
			push_uint64(L, wide);
			break;
		case UINT8: push_whole(L, *(const uint8_t *)at); break;
		case RECORD:
			lua_newtable(L);
			write_record(L, of, at);
			break;
		default: lua_pushnil(L); break;
	}
}

/* Pushes a table with the elements: the one at index if there is one, whose tables are written into, else a new one. */
static void write_array(lua_State *L, int index, value_kind kind, const record *of, const void *array, int32_t count)
{
	size_t size = size_of(kind, of);
	if (index && lua_type(L, index) == LUA_TTABLE)
		lua_pushvalue(L, index);
	else
		lua_createtable(L, count, 0);
	luaL_checkstack(L, 8, "tables in tables");
	for (int32_t i = 0; i < count; ++i) {
		const char *at = (const char *)array + (size_t)i * size;
		if (kind == RECORD) {
			lua_rawgeti(L, -1, i + 1);
			if (lua_type(L, -1) == LUA_TTABLE) {
				write_record(L, of, at);
				lua_pop(L, 1);
				continue;
			}
			lua_pop(L, 1);
		}
		push_value(L, kind, of, at);
		lua_rawseti(L, -2, i + 1);
	}
	for (int32_t i = count; index && i < (int32_t)lua_rawlen(L, -1);) { /* a kept table that is longer */
		lua_pushnil(L);
		lua_rawseti(L, -2, (int)lua_rawlen(L, -2));
	}
}

/* Sets the fields of the table on top of the stack; tables in it are written into. */
static void write_record(lua_State *L, const record *of, const void *at)
{
	luaL_checkstack(L, 8, "tables in tables");
	for (const field *from = of->fields; from->name; ++from) {
		const char *place = (const char *)at + from->offset;
		if (from->kind == TEXT || from->kind == POINTS || from->kind == VISITOR)
			continue;
		if (from->array) {
			int32_t count = from->array;
			if (of->count >= 0)
				memcpy(&count, (const char *)at + of->count, sizeof count);
			write_array(L, 0, from->kind, from->of, place, count < from->array ? count : from->array);
		} else if (from->kind == RECORD) {
			lua_getfield(L, -1, from->name);
			if (lua_type(L, -1) == LUA_TTABLE) {
				write_record(L, from->of, place);
				lua_pop(L, 1);
				continue;
			}
			lua_pop(L, 1);
			push_value(L, RECORD, from->of, place);
		} else {
			push_value(L, from->kind, from->of, place);
		}
		lua_setfield(L, -2, from->name);
	}
}

/* ---------------------------------------------------------------- worlds and trees */

typedef struct world_object {
	cn_world *pointer;
	lua_State *L; /* of the call that runs, with the world as its first argument */
	int inside;   /* callbacks that run */
	int visiting; /* of them: visitors of queries, in which the world may not change */
	int failed;   /* a callback had an error, which is in the world's values at 0 */
} world_object;

typedef struct tree_object {
	cn_tree *pointer;
} tree_object;

static world_object *to_world(lua_State *L)
{
	world_object *self = luaL_checkudata(L, 1, "cairn.world");
	luaL_argcheck(L, self->pointer, 1, "the world is destroyed");
	self->L = L;
	return self;
}

/* For calls that change the world, which the library does not refuse in a visitor. */
static world_object *to_changed_world(lua_State *L)
{
	world_object *self = to_world(L);
	if (self->visiting)
		luaL_error(L, "the world may not change in a visitor");
	return self;
}

static tree_object *to_tree(lua_State *L)
{
	tree_object *self = luaL_checkudata(L, 1, "cairn.tree");
	luaL_argcheck(L, self->pointer, 1, "the tree is destroyed");
	return self;
}

/* Raises the error of a callback. */
static void raise_failed(lua_State *L, world_object *self)
{
	self->failed = 0;
	lua_getuservalue(L, 1);
	lua_rawgeti(L, -1, 0);
	lua_error(L);
}

/* self: the world whose sentence says what was wrong, or NULL. */
static void check(lua_State *L, world_object *self, cn_result result)
{
	if (self && self->failed && !self->inside)
		raise_failed(L, self);
	if (result == CN_OK)
		return;
	const char *text = self ? cn_world_error_text(self->pointer) : NULL;
	luaL_error(L, "%s", text && *text ? text : cn_result_text(result));
}

static int32_t body_count(const world_object *self)
{
	int32_t count = 0;
	cn_world_get_bodies(self->pointer, NULL, 0, &count);
	return count;
}

/* ---------------------------------------------------------------- visitors of queries */

static int visit(lua_State *L)
{
	const cn_ray_hit *hit = lua_touserdata(L, 2);
	lua_settop(L, 1);
	push_value(L, RECORD, &record_cn_ray_hit, hit);
	lua_call(L, 1, 1);
	if (lua_type(L, -1) == LUA_TBOOLEAN)
		push_whole(L, lua_toboolean(L, -1) ? CN_QUERY_TAKE : CN_QUERY_SKIP);
	else if (lua_type(L, -1) != LUA_TNUMBER)
		luaL_error(L, "a visitor returns QUERY_SKIP, QUERY_TAKE, QUERY_STOP, true or false, not %s", luaL_typename(L, -1));
	return 1;
}

/* The visitor is in the world's values at -1 for a query outside of callbacks, at -2 for one within a callback, and so on. An error
   may not leave through the library: visited raises it behind the query. */
static int32_t visit_callback(const cn_world *world, const cn_ray_hit *hit, void *user)
{
	world_object *self = user;
	lua_State *L = self->L;
	int32_t result = CN_QUERY_SKIP;
	(void)world;
	if (self->failed || !lua_checkstack(L, 8))
		return result;
	lua_getuservalue(L, 1);
	lua_pushcfunction(L, visit);
	lua_rawgeti(L, -2, -1 - self->inside);
	lua_pushlightuserdata(L, (void *)hit);
	++self->inside;
	++self->visiting;
	if (lua_pcall(L, 2, 1, 0) != 0) {
		self->failed = 1;
		lua_rawseti(L, -2, 0);
	} else {
		result = (int32_t)lua_tonumber(L, -1);
		lua_pop(L, 1);
	}
	--self->visiting;
	--self->inside;
	self->L = L;
	lua_pop(L, 1);
	return result;
}

static void read_visitor(lua_State *L, cn_query_filter *filter)
{
	world_object *self = to_world(L);
	luaL_checktype(L, -1, LUA_TFUNCTION);
	lua_getuservalue(L, 1);
	lua_pushvalue(L, -2);
	lua_rawseti(L, -2, -1 - self->inside);
	lua_pop(L, 1);
	filter->visit = visit_callback;
	filter->user = self;
}

static cn_result visited(lua_State *L, world_object *self, cn_result result)
{
	if (self->failed)
		raise_failed(L, self);
	return result;
}

#include "calls.h"

static void read_world_def(lua_State *L, int index, cn_world_def *def)
{
	if (lua_isnil(L, index)) {
		lua_newtable(L);
		lua_replace(L, index);
	}
	read_struct(L, index, &record_cn_world_def, def, 0, "def");
}

/* Pushes an object without a world. */
static world_object *world_new(lua_State *L)
{
	world_object *self = lua_newuserdata(L, sizeof *self);
	memset(self, 0, sizeof *self);
	lua_newtable(L);
	lua_setuservalue(L, -2);
	luaL_getmetatable(L, "cairn.world");
	lua_setmetatable(L, -2);
	return self;
}

static int world_create(lua_State *L)
{
	cn_world_def def;
	lua_settop(L, 1);
	read_world_def(L, 1, &def);
	world_object *self = world_new(L);
	check(L, NULL, cn_world_create(&def, &self->pointer));
	return 1;
}

/* cairn.read(file, def): a world from the string of world:write(). Of the definition only workers and capacities are used. */
static int world_read(lua_State *L)
{
	cn_world_def def;
	size_t bytes;
	lua_settop(L, 2);
	const char *file = luaL_checklstring(L, 1, &bytes);
	read_world_def(L, 2, &def);
	world_object *self = world_new(L);
	check(L, NULL, cn_world_read(&def, file, bytes, &self->pointer));
	return 1;
}

static int world_destroy(lua_State *L)
{
	world_object *self = luaL_checkudata(L, 1, "cairn.world");
	if (self->inside)
		return luaL_error(L, "destroy: called from inside a callback");
	cn_world_destroy(self->pointer);
	self->pointer = NULL;
	return 0;
}

static int deliver(lua_State *L)
{
	const cn_contact_event *event = lua_touserdata(L, 2);
	lua_settop(L, 1);
	push_value(L, RECORD, &record_cn_contact_event, event);
	lua_call(L, 1, 0);
	return 0;
}

/* An error may not leave through the library: check raises it behind the step. */
static void contact_callback(cn_world *world, const cn_contact_event *event, void *user)
{
	world_object *self = user;
	lua_State *L = self->L;
	(void)world;
	if (self->failed || !lua_checkstack(L, 8))
		return;
	lua_getuservalue(L, 1);
	lua_pushcfunction(L, deliver);
	lua_rawgeti(L, -2, event->kind + 1);
	lua_pushlightuserdata(L, (void *)event);
	++self->inside;
	if (lua_pcall(L, 2, 0, 0) != 0) {
		self->failed = 1;
		lua_rawseti(L, -2, 0);
	}
	--self->inside;
	self->L = L;
	lua_pop(L, 1);
}

/* world:on_contact(kind, function or nil): called with each event of the kind (EVENT_*) while the world is locked. */
static int world_on_contact(lua_State *L)
{
	world_object *self = to_changed_world(L);
	int32_t kind;
	read_value(L, 2, INT32, NULL, &kind, "kind");
	if (!lua_isnoneornil(L, 3))
		luaL_checktype(L, 3, LUA_TFUNCTION);
	lua_settop(L, 3);
	check(L, self, cn_world_set_contact_callback(self->pointer, kind, lua_isnil(L, 3) ? NULL : contact_callback, self));
	lua_getuservalue(L, 1);
	lua_pushvalue(L, 3);
	lua_rawseti(L, -2, kind + 1);
	return 0;
}

static int tree_create(lua_State *L)
{
	float margin_m;
	read_value(L, 1, FLOAT, NULL, &margin_m, "margin_m");
	tree_object *self = lua_newuserdata(L, sizeof *self);
	self->pointer = NULL;
	luaL_getmetatable(L, "cairn.tree");
	lua_setmetatable(L, -2);
	check(L, NULL, cn_tree_create(margin_m, NULL, NULL, NULL, &self->pointer));
	return 1;
}

static int tree_destroy(lua_State *L)
{
	tree_object *self = luaL_checkudata(L, 1, "cairn.tree");
	cn_tree_destroy(self->pointer);
	self->pointer = NULL;
	return 0;
}

static const luaL_Reg world_methods[] = {
	{ "destroy", world_destroy },
	{ "on_contact", world_on_contact },
	{ NULL, NULL },
};

static void add_calls(lua_State *L, const luaL_Reg *calls)
{
	for (; calls->name; ++calls) {
		lua_pushcfunction(L, calls->func);
		lua_setfield(L, -2, calls->name);
	}
}

static void add_type(lua_State *L, const char *name, const luaL_Reg *calls, const luaL_Reg *more, lua_CFunction destroy)
{
	luaL_newmetatable(L, name);
	lua_newtable(L);
	add_calls(L, calls);
	if (more)
		add_calls(L, more);
	lua_setfield(L, -2, "__index");
	lua_pushcfunction(L, destroy);
	lua_setfield(L, -2, "__gc");
	lua_pushcfunction(L, destroy);
	lua_setfield(L, -2, "__close");
	lua_pop(L, 1);
}

EXPORTED int luaopen_cairn(lua_State *L);

EXPORTED int luaopen_cairn(lua_State *L)
{
	if (cn_abi_version() != CN_ABI_VERSION)
		return luaL_error(L, "cairn_lua.c is for ABI %d, the library has %d", CN_ABI_VERSION, (int)cn_abi_version());
	add_type(L, "cairn.world", world_calls, world_methods, world_destroy);
	add_type(L, "cairn.tree", tree_calls, NULL, tree_destroy);
	lua_newtable(L);
	add_calls(L, library_calls);
	for (size_t i = 0; i < sizeof constants / sizeof constants[0]; ++i) {
		push_whole(L, constants[i].value);
		lua_setfield(L, -2, constants[i].name);
	}
	lua_pushcfunction(L, world_create);
	lua_setfield(L, -2, "world");
	lua_pushcfunction(L, world_read);
	lua_setfield(L, -2, "read");
	lua_pushcfunction(L, tree_create);
	lua_setfield(L, -2, "tree");
	return 1;
}
