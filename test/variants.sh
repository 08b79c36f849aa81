#!/bin/sh
# usage: variants.sh build-folder
# The test suite as `make test` builds and runs it, then under sanitizers and under compilers and options
# that must all give the same bits (tests hold golden hashes), then checks of the sources. Every suite has a
# build folder of its own but the first, which has that of `make test`: what that built is not built again.
# The whole suite runs as the caller's options say, with the address, undefined-behaviour and memory sanitizers, and at
# -O3 with the processor's own instructions; the thread sanitizer and helgrind run tests of threads, the other builds those that
# hold bits against bits. Ends with one summed line "N passed, N failed, N skipped".
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL # a make of its own, not a part of the one that called
build=$1
cores=$(nproc 2>/dev/null || echo 2)
passed=0 failed=0 skipped=0
report=
mkdir -p "$build"

add() { # label passed failed skipped
	passed=$((passed + $2)) failed=$((failed + $3)) skipped=$((skipped + $4))
	line=$(printf '%-18s %5d passed, %d failed, %d skipped' "$1" "$2" "$3" "$4")
	report="$report$line
"
	echo "$line"
}

begin() { started=$(date +%s); }
end() { echo "$1: $(($(date +%s) - started)) s"; }

suite() { # name compiler cflags defines [tests]
	name=$1 compiler=$2 cflags=$3 defines=$4
	tests=
	for test in ${5:-}; do tests="$tests $build/$name/test/$test"; done
	if ! command -v "$compiler" >/dev/null 2>&1; then
		echo "$compiler is not installed (see .ci/deps)"
		add "$name" 0 0 1
		return
	fi
	begin
	${MAKE:-make} -s -j"$cores" test BUILD="$build/$name" CC="$compiler" CFLAGS= TEST_CFLAGS="$cflags" TEST_DEFINES="$defines" \
		JOBS="$cores" ${tests:+"TESTS=$tests"} > "$build/$name.log" 2>&1
	read_log "$name" $?
	end "$name"
}

# As a user calls it.
plain() {
	begin
	${MAKE:-make} -s -j"$cores" test BUILD="$build" JOBS="$cores" > "$build/plain.log" 2>&1
	read_log plain $?
	end plain
}

read_log() { # name code: adds what $build/$name.log counts
	name=$1 code=$2
	line=$(grep -aE '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$build/$name.log" | tail -n 1)
	if [ -z "$line" ] || { [ $code != 0 ] && [ "${line#*, 0 failed}" != "$line" ]; }; then
		tail -n 40 "$build/$name.log"
		line="0 passed, 1 failed, 0 skipped"
	elif [ $code != 0 ]; then
		grep -aE -B 8 '^FAIL|ERROR: .*Sanitizer|runtime error|WARNING: (Memory|Thread)Sanitizer|invariant broken' "$build/$name.log" | head -n 120
		grep -a '^failed in:' "$build/$name.log"
	fi
	# shellcheck disable=SC2086
	set -- $line
	add "$name" "$1" "$3" "$5"
}

check() { # name command...
	name=$1
	shift
	if "$@" > "$build/$name.log" 2>&1; then
		add "$name" 1 0 0
	else
		cat "$build/$name.log"
		add "$name" 0 1 0
	fi
}

# The bindings, with the shared library that exports() built.
bindings() {
	begin
	${MAKE:-make} -s -j"$cores" test-bindings BUILD="$build/release-check" > "$build/bindings.log" 2>&1
	read_log bindings $?
	end bindings
}

# Other processors.
others() {
	begin
	sh test/cross.sh "$build/cross" > "$build/cross.log" 2>&1
	read_log cross $?
	end cross
}

header_in_cxx() {
	for standard in c++11 c++20; do
		g++ -std=$standard -pedantic -Wall -Wextra -Werror -fsyntax-only -x c++ include/cairn.h || return 1
	done
}
header_without_padding() { gcc -std=c99 -pedantic -Wall -Wextra -Wpadded -Werror -fsyntax-only -x c include/cairn.h; }
# Valgrind's word on threads beside the sanitizer's: it sees locks and the order of words that other threads wait for by other means.
helgrind() {
	if ! command -v valgrind >/dev/null 2>&1 || ! echo '#include <valgrind/helgrind.h>' | gcc -E -x c - >/dev/null 2>&1; then
		echo "valgrind is not installed (see .ci/deps)"
		add helgrind 0 0 1
		return
	fi
	export RUNNER='valgrind -q --tool=helgrind --history-level=none --fair-sched=try --error-exitcode=9'
	suite helgrind gcc '-O1 -g' '-DTEST_SLOW -DCNI_HELGRIND' 'base/threads_test world/threads_contacts_test'
	unset RUNNER
}

# The shared library exports what the header declares and nothing else.
exports() {
	${MAKE:-make} -s -j"$cores" all BUILD="$build/release-check" || return 1
	nm -D --defined-only "$build/release-check/libcairn.so" | awk '{ print $3 }' | sed 's/@.*//' | sort > "$build/exported.txt"
	gcc -std=c99 -E -P include/cairn.h | tr '\n' ' ' | tr ';' '\n' | grep 'visibility("default")' |
		sed 's/(("default"))//' | grep -oE 'cn_[a-z0-9_]+ *\(' | sed 's/ *(//' | sort -u > "$build/declared.txt"
	diff "$build/declared.txt" "$build/exported.txt"
}

# No fused multiply-add where the processor has one: gcc's vectoriser makes them from "addsub" pairs even
# with -ffp-contract=off (a x - b y beside b x + a y, as in a rotation), which changes bits.
no_fused_operations() {
	for arch in x86-64-v3 icelake-server; do
		for file in src/*/*.c; do
			gcc -std=c99 -O3 -march=$arch -ffp-contract=off -Iinclude -Isrc -S -o "$build/fused.s" "$file" || return 1
			if grep -qE '[[:space:]]vfn?m(add|sub)' "$build/fused.s"; then
				echo "$file has fused operations for $arch"
				fused=1
			fi
		done
	done
	[ -z "${fused:-}" ]
}

slow='-DCNI_DEBUG -DTEST_SLOW' # a build that is slow: bounds on time do not hold
sanitize='-O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all'
threads='base/threads_test stages/broadphase_threads_test world/threads_test world/threads_contacts_test world/threads_pairs_test'
bits='world/determinism_test world/random_test geometry/manifold_boxes_test stages/integrate_test stages/joint_blocks_test stages/joint_rows_test stages/narrowphase_sift_test'
plain
suite clang-address clang-19 "$sanitize -fsanitize=address,undefined" "$slow"
suite clang-memory clang-19 "$sanitize -fsanitize=memory" "$slow"
suite clang-thread clang-19 "-O1 -g -fno-omit-frame-pointer -fsanitize=thread" "$slow" "$threads"
helgrind
suite no-threads gcc '-O1' '-DCNI_DEBUG -DCN_NO_THREADS' "$threads $bits world/memory_test world/memory_block_test"
suite gcc-O0 gcc '-O0' "$slow" "$bits"
suite gcc-O3-native gcc '-O3 -march=native' ''
suite clang-O2 clang-19 '-O2' -DCNI_DEBUG "$bits"
suite clang-O3 clang-19 '-O3' '' "$bits"
if command -v g++ >/dev/null 2>&1; then check header-cxx header_in_cxx; else add header-cxx 0 0 1; fi
check header-padding header_without_padding
check ablation env JOBS="$cores" sh test/ablation/run.sh "$build" --quick
check exports exports
bindings
others
if [ "$(uname -m)" = x86_64 ]; then check no-fused no_fused_operations; else add no-fused 0 0 1; fi
check check-deps sh test/check_deps.sh
check check-links sh test/check_links.sh
check mutations-apply sh test/mutation.sh --check

echo "---"
printf '%s' "$report"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
