#!/bin/sh
# usage: variants.sh build-folder [part...]    all parts without a name; BUT='plain cross': all but those
# The test suite as `make test` builds and runs it, then in other builds, then checks of the sources. Parts run two at a
# time, as each has a time in which it keeps one core busy only. A suite has a build folder of its own, but the first, which
# has that of `make test`: what that built is not built again.
#
# Every fault is looked for once: the address and undefined-behaviour sanitizers run the whole suite; the memory sanitizer those of kernels, memory, random scenes,
# calls and arguments; -O3 with the processor's own instructions those of bits, a block of memory and threads, without threads; the thread
# sanitizer and helgrind those of threads; the other builds must give the same bits (tests hold golden hashes).
# Ends with a line of each part with its seconds, and one summed line "N passed, N failed, N skipped".
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL # a make of its own, not a part of the one that called
build=$1
shift
cores=$(nproc 2>/dev/null || echo 2)
at_a_time=2
amalgamated=$build/amalgamation/cairn.c
command -v python3 >/dev/null 2>&1 || amalgamated=
results=$build/parts
# The longest first, so that the last two end together; amalgamation and release, which write the same file, apart.
parts='clang-address cross plain amalgamation clang-memory release embedded clang-thread native helgrind
	ablation work header-cxx header-padding check-links check-peers check-docs testbed-web mutations-apply'

# ---------------------------------------------------------------- of one part

add() { echo "$1 $2 $3 $4" >> "$results/$part.counts"; } # label passed failed skipped

# Other compilers than clang take the library as one file, in half the time. Sanitizers of clang take longer then.
suite() { # name compiler cflags defines [tests]
	name=$1 compiler=$2 cflags=$3 defines=$4 whole= linker=
	[ "$compiler" = clang-19 ] || whole=$amalgamated
	# A sanitizer's library is linked into each test: a third of the time with lld.
	[ "$compiler" != clang-19 ] || ! command -v ld.lld-19 >/dev/null 2>&1 || linker=-fuse-ld=lld
	tests= examples= own=
	for test in ${5:-}; do tests="$tests $build/$name/test/${test}_test"; done
	# Of the examples the tests that a list names use the scenes alone. Optimised is the library; tests are, too, where a sanitizer slows them.
	[ -z "$tests" ] || examples=$(echo examples/scenes/*.c)
	[ "$compiler" = clang-19 ] || own=-O0
	if ! command -v "$compiler" >/dev/null 2>&1; then
		echo "$compiler is not installed (see .ci/deps)"
		add "$name" 0 0 1
		return
	fi
	${MAKE:-make} -s -j"$cores" test BUILD="$build/$name" CC="$compiler" CFLAGS= TEST_CFLAGS="$cflags" OWN_CFLAGS="$own" TEST_DEFINES="$defines" \
		LDFLAGS="$linker" JOBS="$cores" AMALGAMATED="$whole" ${tests:+"TESTS=$tests" "EXAMPLE_SRC=$examples"} > "$build/$name.log" 2>&1
	read_log "$name" $?
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
	grep -a '^processor time:' "$build/$name.log" | tail -n 1 | sed "s|^|$name: |; s|$build/$name/test/||g; s|$build/test/||g"
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

# As a user calls it.
plain() {
	${MAKE:-make} -s -j"$cores" test BUILD="$build" JOBS="$cores" > "$build/plain.log" 2>&1
	read_log plain $?
}

# Valgrind's word on the team of threads beside the sanitizer's: it sees locks and the order of words that other threads wait for by
# other means. It takes a minute for a world's step with threads, which the sanitizer runs.
helgrind() {
	if ! command -v valgrind >/dev/null 2>&1 || ! echo '#include <valgrind/helgrind.h>' | gcc -E -x c - >/dev/null 2>&1; then
		echo "valgrind is not installed (see .ci/deps)"
		add helgrind 0 0 1
		return
	fi
	mkdir -p "$build/helgrind"
	gcc -std=c99 -O1 -g -ffp-contract=off -Iinclude -Isrc -Itest -Iexamples -DTEST_SLOW -DCNI_HELGRIND test/base/threads_test.c src/base/*.c \
		-lm -lpthread -o "$build/helgrind/threads_test" > "$build/helgrind.log" 2>&1 &&
		valgrind -q --tool=helgrind --history-level=none --fair-sched=try --error-exitcode=9 "$build/helgrind/threads_test" >> "$build/helgrind.log" 2>&1
	read_log helgrind $?
}

# Work that is bounded, as instructions that valgrind counts: no other program disturbs them.
work() {
	${MAKE:-make} -s -j"$cores" BUILD="$build" "$build/test/world/growth_time_test" "$build/test/world/read_time_test" > "$build/work.log" 2>&1 && sh test/work.sh "$build" >> "$build/work.log" 2>&1
	read_log work $?
}

# The library as users build it: layers of its objects, what the shared one exports, golden hashes, AVX2 in the kernels of eight lanes only, and
# the bindings with it.
release() {
	if ! ${MAKE:-make} -s -j"$cores" all BUILD="$build" > "$build/release.log" 2>&1; then
		tail -n 40 "$build/release.log"
		add release 0 1 0
		return
	fi
	check check-deps sh test/check_deps.sh "$build"
	check exports exports
	check schedule schedule
	check release-golden release_golden
	if [ "$(uname -m)" = x86_64 ]; then check release-avx avx_in_eights "$build/libcairn.a"; else add release-avx 0 0 1; fi
	${MAKE:-make} -s -j"$cores" test-bindings BUILD="$build" > "$build/bindings.log" 2>&1
	read_log bindings $?
}

# Steps with up to 64 simulated workers: the same hash in any order of chunks, and what one worker runs alone.
schedule() {
	${MAKE:-make} -s BUILD="$build" "$build/bin/schedule" && "$build/bin/schedule" tumbler smash --steps 5 || return 1
	# As other programs disturb times, the first of three runs that is below: 0.07; 0.28 where one worker solves all joints.
	for run in 1 2 3; do
		"$build/bin/schedule" workshop --steps 20 > "$build/schedule.csv" || return 1
		awk -F, '/^workshop,serial:substeps/ { share = $4; print share } END { exit !(share > 0 && share < 0.15) }' "$build/schedule.csv" && return 0
	done
	return 1
}

release_golden() {
	mkdir -p "$build/golden-release"
	golden_with gcc "$build/golden-release" all "$build/libcairn.a"
}

# AVX2 in the kernels of eight lanes only: in functions, or files of an archive, with _8 in their names.
avx_in_eights() { # object or archive
	# Names of AVX instructions begin with v.
	objdump -d --no-show-raw-insn "$1" | awk '/file format/ { file = $1; sub(/.*\//, "", file) }
		/^[0-9a-f]+ <.*>:$/ { name = $2 }
		$2 ~ /^v[a-z]/ { found = 1; if (file !~ /_8/ && name !~ /_8/) { print file, name, $0; bad = 1 } }
		END { if (!found) print "no AVX at all"; exit bad || !found }'
}

# The shared library exports what the header declares and nothing else.
exports() {
	nm -D --defined-only "$build/libcairn.so" | awk '{ print $3 }' | sed 's/@.*//' | sort > "$build/exported.txt"
	gcc -std=c99 -E -P include/cairn.h | tr '\n' ' ' | tr ';' '\n' | grep 'visibility("default")' |
		sed 's/(("default"))//' | grep -oE 'cn_[a-z0-9_]+ *\(' | sed 's/ *(//' | sort -u > "$build/declared.txt"
	diff "$build/declared.txt" "$build/exported.txt"
}

# The library as one file (make amalgamation): no warning in C99, C11 and C++17; the same golden hashes in C with clang, which contracts
# unless it is told not to, and with tcc, and as C++. With gcc `native` runs it, and `release` the library of many files. The library file by
# file with tcc, and without GNU extensions.
amalgamation() {
	if ! command -v clang-19 >/dev/null 2>&1 || ! command -v python3 >/dev/null 2>&1; then
		echo "clang-19 or python3 is not installed (see .ci/deps)"
		add amalgamation 0 0 1
		return
	fi
	check amalgamation-compiles amalgamation_compiles
	check no-gnu-compiles no_gnu_compiles
	if command -v g++ >/dev/null 2>&1; then check amalgamation-cxx amalgamation_cxx; else add amalgamation-cxx 0 0 1; fi
	if command -v tcc >/dev/null 2>&1; then check tcc-files tcc_files; else add tcc-files 0 0 1; fi
	for compiler in clang-19 tcc; do # tcc: no GNU vectors, so plain C
		if command -v $compiler >/dev/null 2>&1; then check "amalgamation-$compiler" amalgamation_golden $compiler; else add "amalgamation-$compiler" 0 0 1; fi
	done
}
amalgamation_compiles() {
	for choice in gcc,c11,CNI_DEBUG clang-19,c99,CN_NO_THREADS; do
		compiler=${choice%%,*} flags=${choice#*,}
		"$compiler" -std=${flags%,*} -pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror -D${flags#*,} -fsyntax-only \
			"$amalgamated" || return 1
	done
}
no_gnu_compiles() {
	for compiler in gcc clang-19; do
		"$compiler" -std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Wno-unused-function -Werror -include bindings/test/no_gnu.h -fsyntax-only "$amalgamated" || return 1
	done
}
golden_with() { # compiler folder scenes object...: the golden scenes, all or small, with these objects of the library
	compiler=$1 folder=$2 scenes=
	[ "$3" = all ] || scenes=-DTEST_EMULATED=2
	shift 3
	# shellcheck disable=SC2086
	"$compiler" -std=c99 -O1 -ffp-contract=off $scenes -Iinclude -Isrc -Itest -Iexamples test/world/determinism_test.c examples/scenes/*.c "$@" \
		-lm -lpthread -o "$folder/determinism_test" && "$folder/determinism_test" golden
}
# What differs in C++ differs without optimization, for which clang takes half of g++'s time.
amalgamation_cxx() {
	g++ -std=c++17 -pedantic -Wall -Wextra -Werror -fsyntax-only -x c++ "$amalgamated" || return 1
	mkdir -p "$build/amalgamation/cxx"
	clang++-19 -std=c++17 -pedantic -Wall -Wextra -Werror -O0 -c -x c++ "$amalgamated" -o "$build/amalgamation/cxx/cairn.o" &&
		golden_with gcc "$build/amalgamation/cxx" small "$build/amalgamation/cxx/cairn.o"
}
tcc_files() {
	mkdir -p "$build/tcc"
	for file in src/*/*.c; do
		tcc -std=c99 -Iinclude -Isrc -c "$file" -o "$build/tcc/$(echo "$file" | tr / _).o" || return 1
	done
}
amalgamation_golden() { # compiler; without optimization small scenes
	folder=$build/amalgamation/$1 which=all
	[ "$1" != tcc ] || which=small
	mkdir -p "$folder"
	"$1" -std=c99 -O2 -c "$amalgamated" -o "$folder/cairn.o" &&
		golden_with "$1" "$folder" $which "$folder/cairn.o" || return 1
	[ "$(uname -m)" = x86_64 ] && [ "$1" != tcc ] || return 0
	avx_in_eights "$folder/cairn.o"
}

# Bare metal: the smallest configuration on three processors, with bounds on its flash, RAM and stack; what it refuses; and tests of a
# library with small blocks, whose sleeping contacts are kept in another way.
embedded() {
	sh examples/embedded/run.sh "$build/embedded" least plain > "$build/embedded.log" 2>&1
	read_log embedded $?
	check embedded-refused embedded_refused
	suite small-blocks gcc '-O1' "$slow -DCN_SMALL_BLOCKS -DCN_NO_THREADS" "$small"
}
embedded_refused() {
	. examples/embedded/definitions.sh
	mkdir -p "$build/embedded/refused"
	for file in ${amalgamated:-src/*/*.c}; do echo "$file"; done | OUT=$build/embedded/refused FLAGS="-std=c99 -O0 -DCNI_DEBUG -DCN_NO_SIMD -ffp-contract=off -Iinclude -Isrc -DCN_NO_THREADS $without_solvers $without_joints $without_rest" \
		xargs -P "$cores" -n 1 sh -c 'gcc $FLAGS -c "$1" -o "$OUT/$(echo "$1" | tr / _).o"' sh || return 1
	gcc -std=c99 -pedantic -Wall -Wextra -Werror -Iinclude test/embedded/refused.c "$build"/embedded/refused/*.o -lm -o "$build/embedded/refused/refused" &&
		"$build/embedded/refused/refused"
}

# Every C block of the documentation compiles and runs: examples/docs/site/check.py
check_docs() {
	if ! command -v python3 >/dev/null 2>&1; then
		echo "python3 is not installed (see .ci/deps)"
		add check-docs 0 0 1
		return
	fi
	check check-docs ${MAKE:-make} -s -j"$cores" check-docs BUILD="$build"
}

# The testbed in a headless browser.
testbed_web() {
	sh test/examples/testbed_web.sh "$build" > "$build/testbed-web.log" 2>&1
	read_log testbed-web $?
	grep 'is not installed' "$build/testbed-web.log"
}

# Other processors.
cross() {
	AMALGAMATED=$amalgamated sh test/cross.sh "$build/cross" > "$build/cross.log" 2>&1
	read_log cross $?
	grep -E '^[a-z0-9]+: .* s$' "$build/cross.log"
}

header_in_cxx() {
	for standard in c++11 c++20; do
		g++ -std=$standard -pedantic -Wall -Wextra -Werror -fsyntax-only -x c++ include/cairn.h || return 1
		strict_handles $standard || return 1
	done
}
# Distinct handles: good code compiles, and no misuse does.
strict_handles() { # standard
	g++ -std=$1 -pedantic -Wall -Wextra -Werror -Iinclude -fsyntax-only test/header/strict_handles.cpp || return 1
	for misuse in $(sed -n 's/^#\(el\)\{0,1\}if MISUSE == //p' test/header/strict_handles.cpp); do
		if g++ -std=$1 -Iinclude -DMISUSE=$misuse -fsyntax-only test/header/strict_handles.cpp 2>/dev/null; then
			echo "misuse $misuse of a handle compiles"
			return 1
		fi
	done
}
header_without_padding() { gcc -std=c99 -pedantic -Wall -Wextra -Wpadded -Werror -fsyntax-only -x c include/cairn.h; }

# No fused multiply-add where the processor has one: gcc's vectoriser makes them from "addsub" pairs even
# with -ffp-contract=off (a x - b y beside b x + a y, as in a rotation), which changes bits.
no_fused_operations() { # object
	if objdump -d --no-show-raw-insn "$1" | grep -m 3 -E "[[:space:]]vfn?m(add|sub)"; then return 1; fi
	objdump -d --no-show-raw-insn "$1" | grep -q '%ymm' # for a processor that has them
}
# Without threads, with all instructions of this processor, or of one that has fused operations.
native() {
	object=$build/native/checked/cairn.o arch=-march=native
	grep -qw fma /proc/cpuinfo || arch=
	suite native gcc "-O3 $arch" '-DCNI_DEBUG -DCN_NO_THREADS' "$bits $threads world/memory_block"
	if [ -z "$arch" ]; then
		object=$build/native/fused.o
		gcc -std=c99 -O3 -march=x86-64-v3 -ffp-contract=off -c "$amalgamated" -o "$object"
	fi
	if [ "$(uname -m)" = x86_64 ] && [ -n "$amalgamated" ]; then check no-fused no_fused_operations "$object"; else add no-fused 0 0 1; fi
}

sanitize='-O1 -gline-tables-only -fno-omit-frame-pointer -fno-sanitize-recover=all'
# A null pointer that is read ends a program anyway, and these checks are at every access: a third of the build's time and a quarter of the tests'.
address='-fsanitize=address,undefined -fno-sanitize=null,object-size,pointer-overflow'
slow='-DCNI_DEBUG -DTEST_SLOW' # the slow form of the suite: test.h
threads='base/threads broadphase/broadphase_threads world/threads world/threads_contacts world/threads_pairs'
kernels='collision/manifold_batch step/integrate joints/joint_blocks joints/joint_nets narrowphase/cull'
bits="world/determinism world/random $kernels"
# What sleeps, wakes, is saved or checked.
small='world/sleep world/sleep_slow world/wake world/body_state world/events_pair world/validate save/save save/save_delta save/file_hostile
	world/memory_block world/calls world/random world/determinism'
# What reads and writes each struct of the library at least once.
calls='base/memory base/arena base/blocks base/table base/handles collision/manifold broadphase/tree collision/cast broadphase/sweep
	linear/sparse world/memory world/memory_block world/calls world/arguments world/joint_all world/joint_life world/body_state world/shape
	world/sensor world/events query/query world/direct_contacts world/update world/draw'

run_part() {
	case $part in
		plain) plain ;;
		clang-address) suite clang-address clang-19 "$sanitize $address" "$slow" ;;
		clang-memory) suite clang-memory clang-19 "$sanitize -fsanitize=memory" "$slow -DTEST_EMULATED" "$kernels world/random $calls" ;;
		clang-thread) suite clang-thread clang-19 "-O1 -gline-tables-only -fno-omit-frame-pointer -fsanitize=thread" "$slow" "$threads" ;;
		helgrind) helgrind ;;
		native) native ;;
		header-cxx) if command -v g++ >/dev/null 2>&1; then check header-cxx header_in_cxx; else add header-cxx 0 0 1; fi ;;
		header-padding) check header-padding header_without_padding ;;
		ablation) check ablation env JOBS="$cores" sh test/ablation/run.sh "$build" --quick ;;
		release) release ;;
		amalgamation) amalgamation ;;
		work) work ;;
		embedded) embedded ;;
		cross) cross ;;
		check-docs) check_docs ;;
		testbed-web) testbed_web ;;
		check-links) check check-links sh test/check_links.sh ;;
		check-peers) check check-peers sh test/check_peers.sh ;;
		mutations-apply) check mutations-apply sh test/mutation.sh --check ;;
		*) echo "there is no part $part"; add "$part" 0 1 0 ;;
	esac
}

if [ -n "${VARIANTS_PART:-}" ]; then
	part=$VARIANTS_PART
	: > "$results/$part.counts"
	started=$(date +%s)
	run_part > "$results/$part.txt" 2>&1
	[ -s "$results/$part.counts" ] || add "$part" 0 1 0
	seconds=$(($(date +%s) - started))
	# The processor's, too: it does not grow when others use the machine.
	times > "$results/$part.times" # not in a pipe, which would be a shell of its own
	awk -v wall=$seconds 'NR == 2 { for (i = 1; i <= 2; ++i) { split($i, t, "m"); s += 60 * t[1] + t[2] } printf "%d %.0f\n", wall, s }' \
		"$results/$part.times" > "$results/$part.seconds"
	exit 0
fi

# ---------------------------------------------------------------- all

[ $# -gt 0 ] || for part in $parts; do
	case " ${BUT:-} " in *" $part "*) ;; *) set -- "$@" "$part" ;; esac
done
[ $# -gt 0 ] || exit 2
rm -rf "$results"
mkdir -p "$results"
started=$(date +%s)
[ -z "$amalgamated" ] || ${MAKE:-make} -s amalgamation BUILD="$build" || exit 1
printf '%s\n' "$@" | SCRIPT=$0 BUILD_FOLDER=$build RESULTS=$results xargs -P $at_a_time -n 1 sh -c '
	VARIANTS_PART=$1 sh "$SCRIPT" "$BUILD_FOLDER"
	{ cat "$RESULTS/$1.txt"; awk "{ printf \"%s: %d passed, %d failed, %d skipped\n\", \$1, \$2, \$3, \$4 }" "$RESULTS/$1.counts"; } > "$RESULTS/$1.shown"
	cat "$RESULTS/$1.shown"
' sh

echo "---"
for part in "$@"; do
	read -r wall processor < "$results/$part.seconds"
	awk -v wall="$wall" -v processor="$processor" '{
		printf "%-18s %5d passed, %d failed, %d skipped%s\n", $1, $2, $3, $4, (NR > 1 ? "" : sprintf("%6d s, of the processor %d s", wall, processor))
	}' "$results/$part.counts"
done
cat "$results"/*.seconds | awk -v wall=$(($(date +%s) - started)) '{ sum += $2 } END { printf "%d s in all, of the processor %d s\n", wall, sum }'
set -- "$results"/*.counts
cat "$@" | awk '{ passed += $2; failed += $3; skipped += $4 } END { printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped; exit failed != 0 }'
