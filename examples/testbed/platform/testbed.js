// examples/testbed/platform/testbed.js - shows testbed.wasm in a canvas and passes events on. `cairn` is for tests: frames by hand.
'use strict';

const cairn = { ready: false, manual: false };

(async () => {
	const MOVE = 0, PRESS = 1, RELEASE = 2, WHEEL = 3, KEY = 4;
	const canvas = document.querySelector('canvas');
	const context = canvas.getContext('2d', { alpha: false });
	let bed; // the module's functions

	// The system interface that the C library asks for: a clock; everything else is refused.
	const system = {
		clock_time_get(id, precision, out) {
			new DataView(bed.memory.buffer).setBigUint64(out, BigInt(Math.round(performance.now() * 1e6)), true);
			return 0;
		},
		proc_exit(code) { throw new Error(`the program ended with ${code}`); },
	};
	const module = await WebAssembly.compile(await (await fetch('testbed.wasm')).arrayBuffer());
	const imports = {};
	for (const { module: from, name } of WebAssembly.Module.imports(module))
		(imports[from] ??= {})[name] = system[name] ?? (() => 52); // not supported
	bed = (await WebAssembly.instantiate(module, imports)).exports;
	bed._initialize?.();

	const text = (pointer) => {
		const bytes = new Uint8Array(bed.memory.buffer);
		let end = pointer;
		while (bytes[end] !== 0)
			++end;
		return new TextDecoder().decode(bytes.subarray(pointer, end));
	};

	function fit(width = Math.floor(innerWidth), height = Math.floor(innerHeight)) {
		bed.web_resize(width, height);
		canvas.width = bed.web_width();
		canvas.height = bed.web_height();
	}

	function frame(elapsed) {
		const pixels = bed.web_frame(elapsed);
		const bytes = new Uint8ClampedArray(bed.memory.buffer, pixels, 4 * canvas.width * canvas.height);
		context.putImageData(new ImageData(bytes, canvas.width, canvas.height), 0, 0);
	}

	const pointer = (kind) => (event) => {
		const box = canvas.getBoundingClientRect();
		bed.web_event(kind, event.clientX - box.left, event.clientY - box.top, 0);
	};
	canvas.addEventListener('pointermove', pointer(MOVE));
	canvas.addEventListener('pointerdown', (event) => {
		try { canvas.setPointerCapture(event.pointerId); } catch { /* an event made by a test */ }
		pointer(PRESS)(event);
	});
	canvas.addEventListener('pointerup', pointer(RELEASE));
	canvas.addEventListener('wheel', (event) => {
		event.preventDefault();
		bed.web_event(WHEEL, event.offsetX, event.offsetY, event.deltaY < 0 ? 1 : -1);
	}, { passive: false });
	addEventListener('keydown', (event) => {
		const key = { ArrowLeft: '[', ArrowRight: ']' }[event.key] ?? event.key;
		if (key.length === 1 && !event.ctrlKey && !event.metaKey)
			bed.web_event(KEY, 0, 0, key.toLowerCase().charCodeAt(0));
	});
	addEventListener('resize', () => fit());

	bed.web_open(1280, 760);
	fit();
	const wanted = new URLSearchParams(location.search).get('scene');
	const names = Array.from({ length: bed.web_count() }, (_, entry) => text(bed.web_name(entry)));
	if (names.includes(wanted))
		bed.web_select(names.indexOf(wanted));

	let before = performance.now();
	function loop(now) {
		if (!cairn.manual)
			frame(Math.max(0, now - before) / 1000);
		before = now;
		requestAnimationFrame(loop);
	}
	requestAnimationFrame(loop);

	Object.assign(cairn, {
		frame, fit, canvas, names,
		select: (name) => bed.web_select(names.indexOf(name)),
		hash: () => BigInt.asUintN(64, bed.web_hash()).toString(16).padStart(16, '0'),
		steps: () => bed.web_steps(),
		// The middle of a button or slider of the panel, as drawn in the last frame.
		widget(name) {
			for (let index = 0; index < bed.web_widgets(); ++index) {
				const at = bed.web_widget_at(index);
				if (text(bed.web_widget_name(index)) === name)
					return { x: at >> 16, y: at & 0xffff };
			}
			return null;
		},
		ready: true,
	});
})().catch((error) => {
	document.body.innerHTML = `<p>The testbed did not start: ${error}</p>`;
});
