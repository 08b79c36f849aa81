// usage: node wasi.js program [argument...] - runs a WebAssembly program of the system interface WASI, preview 1.
const { WASI } = require('node:wasi');
const { readFileSync } = require('node:fs');

(async () => {
	const wasi = new WASI({ version: 'preview1', args: process.argv.slice(2), preopens: { '.': '.' } });
	const module = await WebAssembly.compile(readFileSync(process.argv[2]));
	process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
})();
