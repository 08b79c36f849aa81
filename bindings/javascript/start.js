// Cairn for JavaScript: WebAssembly with classes above it, for node and browsers.
// @NOTICE@
//
//     import { World } from "./cairn.js";
//     const world = new World();
//     const body = world.bodyCreate({ position_m: { x: 0, y: 4 } });
//     world.shapeCreateBox({ body }, 0.5, 0.5, 0);
//     world.step(1 / 60);
//     console.log(world.bodyGetPose(body));
//
// A method is C's function without cn_ and without the world, in camel case. Structs are objects; where one goes in, fields that are
// not given have their defaults. 64-bit numbers are BigInt. Arrays of poses, points and velocities are Float32Array, 4, 2 and 3 a piece.

async function bytes() {
	const url = new URL("./cairn.wasm", import.meta.url);
	if (url.protocol === "file:")
		return (await import("node:fs/promises")).readFile(url);
	return (await fetch(url)).arrayBuffer();
}
const { instance } = await WebAssembly.instantiate(await bytes());
/** C's functions, on the memory of the module. */
export const raw = instance.exports;

let buffer, view, u8, f32;
function refresh() { // the memory may have grown
	if (buffer !== raw.memory.buffer) {
		buffer = raw.memory.buffer;
		view = new DataView(buffer);
		u8 = new Uint8Array(buffer);
		f32 = new Float32Array(buffer);
	}
}

// Memory for the arguments of one call: a block, and more where that is too small, until the next call.
const SCRATCH = 65536, block = raw.malloc(SCRATCH), more = [];
let top = block;
function begin() {
	top = block;
	while (more.length > 0)
		raw.free(more.pop());
	refresh();
}
function take(size) {
	let at = (top + 7) & ~7;
	if (at + size <= block + SCRATCH) {
		top = at + size;
		return at;
	}
	at = raw.malloc(size + 8);
	if (at === 0)
		throw new CairnError(CN_ERROR_MEMORY, "no memory for the arguments");
	more.push(at);
	refresh();
	return at + 7 & ~7;
}

const decoder = new TextDecoder(), encoder = new TextEncoder();
function text(at) {
	refresh();
	return at === 0 ? "" : decoder.decode(u8.subarray(at, u8.indexOf(0, at)));
}
function string(value) {
	if (value === null || value === undefined)
		return 0;
	const encoded = encoder.encode(value), at = take(encoded.length + 1);
	u8.set(encoded, at);
	u8[at + encoded.length] = 0;
	return at;
}

/** A call that failed: code is CN_ERROR_..., the message is the library's sentence. */
export class CairnError extends Error {
	constructor(code, message) {
		super(message);
		this.name = "CairnError";
		this.code = code;
	}
}
function check(code, world) {
	if (code === 0)
		return;
	throw new CairnError(code, (world && text(raw.cn_world_error_text(world))) || text(raw.cn_result_text(code)));
}

const READ = {
	f32: at => view.getFloat32(at, true), i32: at => view.getInt32(at, true), u32: at => view.getUint32(at, true), u64: at => view.getBigUint64(at, true),
	i8: at => view.getInt8(at), u8: at => view.getUint8(at), i16: at => view.getInt16(at, true), u16: at => view.getUint16(at, true),
	i64: at => view.getBigInt64(at, true), f64: at => view.getFloat64(at, true),
};
const WRITE = {
	f32: (at, x) => view.setFloat32(at, x, true), i32: (at, x) => view.setInt32(at, x, true), u32: (at, x) => view.setUint32(at, x, true),
	u64: (at, x) => view.setBigUint64(at, BigInt(x), true), i8: (at, x) => view.setInt8(at, x), u8: (at, x) => view.setUint8(at, x),
	i16: (at, x) => view.setInt16(at, x, true), u16: (at, x) => view.setUint16(at, x, true), i64: (at, x) => view.setBigInt64(at, BigInt(x), true),
	f64: (at, x) => view.setFloat64(at, x, true),
};

// Fields of a struct are [name, offset, kind, count, length]; kind is a scalar, a struct's name, "string", or "array:" and a struct's
// name, whose number of elements goes into the field length. Callbacks and memory are left out: a zero from init.
function readField([, at, kind, count], base) {
	const one = i => STRUCTS[kind] ? readStruct(kind, base + at + i * STRUCTS[kind].size) : READ[kind](base + at + i * SIZES[kind]);
	return count === 0 ? one(0) : Array.from({ length: count }, (_, i) => one(i));
}
function readStruct(name, base) {
	const value = {};
	for (const field of STRUCTS[name].fields)
		if (field[2] !== "string" && !field[2].startsWith("array:"))
			value[field[0]] = readField(field, base);
	return value;
}
function writeStruct(name, base, value) {
	for (const key in value)
		if (!STRUCTS[name].names.has(key))
			throw new TypeError(`${name} has no field ${key}`);
	for (const [key, at, kind, count, length] of STRUCTS[name].fields) {
		const given = value[key];
		if (given === undefined)
			continue;
		if (kind === "string")
			view.setUint32(base + at, string(given), true);
		else if (kind.startsWith("array:")) {
			const elements = array(kind.slice(6), given);
			view.setUint32(base + at, elements, true);
			writeStruct(name, base, { [length]: size(kind.slice(6), given) });
		} else if (count > 0)
			given.forEach((element, i) => i < count && writeOne(kind, base + at + i * (STRUCTS[kind] ? STRUCTS[kind].size : SIZES[kind]), element));
		else
			writeOne(kind, base + at, given);
	}
}
function writeOne(kind, at, value) {
	if (STRUCTS[kind])
		writeStruct(kind, at, value);
	else
		WRITE[kind](at, value);
}
function struct(name, value) { // with its defaults where there are some
	const at = take(STRUCTS[name].size);
	if (STRUCTS[name].init)
		raw[STRUCTS[name].init](at);
	else
		u8.fill(0, at, at + STRUCTS[name].size);
	writeStruct(name, at, value);
	return at;
}

// Arrays: structs of floats may come as a Float32Array.
const SIZES = { f32: 4, i32: 4, u32: 4, u64: 8, i8: 1, u8: 1, i16: 2, u16: 2, i64: 8, f64: 8 };
const stride = kind => STRUCTS[kind] ? STRUCTS[kind].size : SIZES[kind];
const size = (kind, values) => values instanceof Float32Array && STRUCTS[kind] ? values.length / (stride(kind) / 4) : values.length;
function array(kind, values) {
	const bytes = stride(kind), at = take(bytes * size(kind, values) || 1);
	if (values instanceof Float32Array && STRUCTS[kind])
		f32.set(values, at >> 2);
	else
		for (let i = 0; i < values.length; ++i) {
			if (STRUCTS[kind] && STRUCTS[kind].init)
				raw[STRUCTS[kind].init](at + i * bytes);
			else
				u8.fill(0, at + i * bytes, at + (i + 1) * bytes);
			writeOne(kind, at + i * bytes, values[i]);
		}
	return at;
}
function list(kind, at, count, out) { // out: that array, filled
	refresh();
	const bytes = stride(kind);
	if (STRUCTS[kind] && STRUCTS[kind].floats) {
		const floats = f32.subarray(at >> 2, (at >> 2) + count * bytes / 4);
		if (!out)
			return floats.slice();
		out.set(floats);
		return out;
	}
	out = out || new Array(count);
	for (let i = 0; i < count; ++i)
		out[i] = STRUCTS[kind] ? readStruct(kind, at + i * bytes) : READ[kind](at + i * bytes);
	return out;
}
function even(a, b) {
	if (a !== b)
		throw new RangeError(`arrays of ${a} and ${b} elements`);
}

const worlds = new FinalizationRegistry(pointer => raw.cn_world_destroy(pointer));
const trees = new FinalizationRegistry(pointer => raw.cn_tree_destroy(pointer));
