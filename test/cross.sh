#!/bin/sh
# usage: cross.sh build-folder
# The same bits on other processors: the golden scenes of world/determinism_test, and the tests of base/ and geometry/,
# compiled for each target and run by an emulator. What a target is there for:
#
#   aarch64   kernels on NEON           s390x   most significant byte first, no vectors
#   wasm32    kernels on WASM SIMD,     i686    pointers of 32 bits, kernels on SSE2
#             no threads                armhf   pointers of 32 bits, no vectors
#
# Ends with one line "N passed, N failed, N skipped". A target whose compiler or emulator is missing is skipped.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL
build=$1
cores=$(nproc 2>/dev/null || echo 2)
passed=0 failed=0 skipped=0

# Tests that measure time say nothing here.
units=$(ls test/base/*_test.c test/geometry/*_test.c | grep -v time_test)

run() { # target
	target=$1 tests="$build/$target/test/world/determinism_test"
	for test in $units; do tests="$tests $build/$target/${test%.c}"; done
	${MAKE:-make} -s -j"$cores" test BUILD="$build/$target" CC="$compiler" CFLAGS= TEST_CFLAGS="-O2 $flags" \
		TEST_DEFINES="-DCNI_DEBUG -DTEST_EMULATED $defines" LIBS="$libs" JOBS="$cores" RUNNER="$runner" TESTS="$tests" > "$build/$target.log" 2>&1
	code=$?
	line=$(grep -aE '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$build/$target.log" | tail -n 1)
	if [ -z "$line" ] || [ $code != 0 ]; then
		tail -n 40 "$build/$target.log"
		line=${line:-0 passed, 1 failed, 0 skipped}
	fi
	# shellcheck disable=SC2086
	set -- $line
	passed=$((passed + $1)) failed=$((failed + $3)) skipped=$((skipped + $5))
	echo "$target: $line"
}

target() { # name compiler runner flags defines libs
	compiler=$2 runner=$3 flags=$4 defines=$5 libs=$6
	for tool in ${compiler%% *} ${runner%% *}; do
		command -v "$tool" >/dev/null 2>&1 && continue
		echo "$1: $tool is not installed (see .ci/deps)"
		skipped=$((skipped + 1))
		return
	done
	run "$1"
}

mkdir -p "$build"
target aarch64 aarch64-linux-gnu-gcc qemu-aarch64-static -static '' '-lm -lpthread'
target s390x s390x-linux-gnu-gcc qemu-s390x-static '-static -fexcess-precision=fast' '' '-lm -lpthread'
target i686 i686-linux-gnu-gcc qemu-i386-static '-static -msse2 -mfpmath=sse' '' '-lm -lpthread'
target armhf arm-linux-gnueabihf-gcc qemu-arm-static -static '' '-lm -lpthread'
target wasm32 'clang-19 --target=wasm32-wasi --sysroot=/usr -isystem /usr/include/wasm32-wasi' 'node --no-warnings test/wasi.js' -msimd128 -DCN_NO_THREADS -lm
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
