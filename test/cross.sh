#!/bin/sh
# usage: cross.sh build-folder
# The same bits on other processors (targets.sh): compiled for each target and run by an emulator, the numbers of arch/hashes_test (which has
# each shape, joint, solver, query, event and the bytes of a file), the bytes of save/file_test, and the tests of base/; for WebAssembly,
# which is quick, those of geometry/ instead. What differs between processors is in
#
#   aarch64   kernels on NEON, fused operations: golden scenes and base/maths too
#   s390x     the order of bytes: no golden scenes, as a step that depends on it changes arch/hashes, too
#   i686      pointers of 32 bits with threads, numbers of 64 bits aligned to 4: so -O0
#   wasm32    kernels on WASM SIMD: golden scenes
#
# Golden scenes that are large run on wasm32 only: they take as long as all others together, and an emulator twenty times as long.
# 32-bit ARM is a part of `embedded`, and of `make test-arch` as i686 and s390x are.
# Two targets run at a time. Ends with one line "N passed, N failed, N skipped". A target whose compiler or emulator is missing is skipped.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL
build=$1
. test/targets.sh
cores=$(nproc 2>/dev/null || echo 2)
passed=0 failed=0 skipped=0 running=0 begun=

golden=test/world/determinism_test.c
units="$(ls test/base/*_test.c | grep -Ev 'time_test|maths_test') test/save/file_test.c test/arch/hashes_test.c" # which also has threads
geometry="$(grep -L 'hooks\.h' test/geometry/*_test.c | grep -v time_test) test/arch/hashes_test.c" # WASI has no setjmp, which hooks need

# Leaves $build/<target>.log, .code and .seconds. Emulators are slow: TEST_SLOW.
run() { # target optimization tests, as source files
	target=$1 optimization=$2
	shift 2
	tests=
	for test in "$@"; do tests="$tests $build/$target/${test%.c}"; done
	(
		started=$(date +%s)
		${MAKE:-make} -s -j"$cores" test BUILD="$build/$target" CC="$compiler" CFLAGS= TEST_CFLAGS="$optimization $flags" OWN_CFLAGS=-O0 JOBS="$cores" \
			TEST_DEFINES="-DCNI_DEBUG -DTEST_SLOW $defines" LIBS="$libs" RUNNER="$runner" TESTS="$tests" \
			EXAMPLE_SRC="$(echo examples/scenes/*.c)" AMALGAMATED="${AMALGAMATED:-}" > "$build/$target.log" 2>&1
		echo $? > "$build/$target.code"
		echo $(($(date +%s) - started)) > "$build/$target.seconds"
	) &
	begun="$begun $target"
	running=$((running + 1))
	[ $((running % 2)) != 0 ] || wait
}

target() { # name optimization tests
	target_of "$1"
	if tool=$(target_lacks); then
		echo "$1: $tool is not installed (see .ci/deps)"
		skipped=$((skipped + 1))
		return
	fi
	# shellcheck disable=SC2086
	run $1 $2 $3
}

read_logs() {
	for target in $begun; do
		line=$(grep -aE '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$build/$target.log" | tail -n 1)
		if [ -z "$line" ] || [ "$(cat "$build/$target.code")" != 0 ]; then
			tail -n 40 "$build/$target.log"
			line=${line:-0 passed, 1 failed, 0 skipped}
		fi
		echo "$target: $line, $(cat "$build/$target.seconds") s"
		grep -a '^processor time:' "$build/$target.log" | tail -n 1 | sed "s|^|$target: |; s|$build/$target/test/||g"
		# shellcheck disable=SC2086
		set -- $line
		passed=$((passed + $1)) failed=$((failed + $3)) skipped=$((skipped + $5))
	done
}

mkdir -p "$build"
target aarch64 -O1 "$golden test/base/maths_test.c $units"
target s390x -O1 "$units"
target i686 -O0 "$units"
target wasm32 -O1 "$golden $geometry"
wait
read_logs
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
