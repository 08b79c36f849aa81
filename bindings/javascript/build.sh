#!/bin/sh
# usage: build.sh [output-folder]; the default is this folder
# Compiles cairn.wasm from the library's one file: cairn.c beside this script, else build/amalgamation/cairn.c (make amalgamation),
# or that of the folder CAIRN_SOURCE_DIR. CC: a clang that has WASI's libc (default clang-19 with Debian's); CFLAGS: default -O3 -msimd128.
set -eu
here=$(dirname "$0")
out=${1:-$here}
for folder in "${CAIRN_SOURCE_DIR:-$here}" "$here/../../build/amalgamation"; do
	[ -f "$folder/cairn.c" ] && break
done
[ -f "$folder/cairn.c" ] || { echo "no cairn.c: run make amalgamation in the top folder"; exit 1; }
${CC:-clang-19 --sysroot=/usr -isystem /usr/include/wasm32-wasi} --target=wasm32-wasi -std=c99 ${CFLAGS:--O3 -msimd128} -DCN_NO_THREADS -DCN_NO_CLOCK \
	-nostartfiles -Wl,--no-entry -Wl,--export-dynamic -Wl,--export=malloc -Wl,--export=free -Wl,--strip-all "$folder/cairn.c" -lm -o "$out/cairn.wasm"
