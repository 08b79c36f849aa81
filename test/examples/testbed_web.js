// test/examples/testbed_web.js - in the page of the testbed: what a person does, by events of pointer and keyboard, frame by frame. Writes
// "name value" lines into the page; testbed_web.sh compares them with those of a native run.
'use strict';

(async () => {
	const lines = [];
	const say = (name, value) => lines.push(`${name} ${value}`);
	const pointer = (kind, x, y) => cairn.canvas.dispatchEvent(new PointerEvent(kind, { clientX: x, clientY: y, pointerId: 1, bubbles: true }));
	const key = (name) => dispatchEvent(new KeyboardEvent('keydown', { key: name }));
	const frames = (count) => { for (let i = 0; i < count; ++i) cairn.frame(1 / 60); };
	function click(name) {
		const at = cairn.widget(name);
		pointer('pointerdown', at.x, at.y);
		cairn.frame(0);
		pointer('pointerup', at.x, at.y);
		cairn.frame(0);
	}
	try {
		while (!cairn.ready)
			await new Promise((done) => setTimeout(done, 20));
		cairn.manual = true;
		cairn.fit(1280, 760);

		cairn.select('dominoes');
		frames(60);
		say('run', cairn.hash());
		click('pause');
		frames(10);
		say('paused_steps', cairn.steps());
		key('.');
		say('step', cairn.hash());
		click('reset');
		say('reset', cairn.hash());
		key(' ');

		cairn.select('mouse');
		frames(2);
		pointer('pointerdown', 786, 572);
		pointer('pointermove', 900, 400);
		frames(60);
		say('drag', cairn.hash());
		pointer('pointerup', 900, 400);
		frames(20);
		say('release', cairn.hash());

		cairn.select('tumbler');
		frames(60);
		const data = cairn.canvas.getContext('2d').getImageData(0, 0, 1000, 700).data;
		let drawn = 0;
		for (let i = 0; i < data.length; i += 4)
			drawn += data[i + 2] !== 0xf5;
		say('drawn', drawn > 20000 ? 'yes' : `only ${drawn} pixels`);
		say('end', 'good');
	} catch (error) {
		say('error', error);
	}
	const out = document.createElement('pre');
	out.textContent = `\n${lines.join('\n')}\n`;
	document.body.append(out);
})();
