#!/bin/sh
# usage: library.sh build-folder, from the top folder; the library's objects are in build-folder/release/src, libcairn.so beside them
# Writes build-folder/record/libcairn.so: the shared library with each call that changes a world recorded (environment.c). Programs of any
# language load it in the place of the other, whose name it has. Symbols are renamed in the objects: cn_world_step of the library becomes cnx_world_step, and
# the recorder's cnr_world_step becomes cn_world_step.
set -eu
build=$1
CC=${CC:-gcc}
out=$build/record
mkdir -p "$out"
flags='-std=c99 -pedantic -Wall -Wextra -Werror -O2 -ffp-contract=off -fPIC -Iinclude -Iexamples'

{ sed -n 's/^#define \(cn_[a-z0-9_]*\) cnr_.*/\1/p' bindings/record/cairn_record.h; echo cn_world_create; echo cn_world_read; } | sort -u > "$out/names"
sed 's/^cn_\(.*\)/cn_\1 cnx_\1/' "$out/names" > "$out/real.map"
{ cat "$out/real.map"; sed 's/^cn_\(.*\)/cnr_\1 cn_\1/' "$out/names"; } > "$out/recorder.map"
echo '{ global: cn_*; local: *; };' > "$out/exports"

for file in examples/record/calls.c examples/record/coding.c examples/record/record.c bindings/record/environment.c; do
	# shellcheck disable=SC2086
	$CC $flags -c "$file" -o "$out/$(basename "$file" .c).o"
done
$CC -r -nostdlib -o "$out/real.o" "$build"/release/src/*/*.o "$out/calls.o" "$out/coding.o"
$CC -r -nostdlib -o "$out/recorder.o" "$out/record.o" "$out/environment.o"
objcopy --redefine-syms="$out/real.map" "$out/real.o"
objcopy --redefine-syms="$out/recorder.map" "$out/recorder.o"
name=$(readlink "$build/libcairn.so")
$CC -shared -Wl,--version-script="$out/exports" -Wl,-soname,"$name" "$out/real.o" "$out/recorder.o" -lm -lpthread -o "$out/$name"
ln -sf "$name" "$out/libcairn.so"
