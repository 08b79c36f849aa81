#!/bin/sh
# usage: lint/run.sh build-folder [tool...]      tidy, cppcheck, analyzer; all three without a name
# Static checks of src/: clang-tidy 19 (clang-tidy.yaml), cppcheck (cppcheck.txt has what is suppressed), gcc -fanalyzer. Prints what they
# find and the processor seconds of each; fails if anything is found, or if a tool is missing.
set -u
build=$1/lint
shift
[ $# -gt 0 ] || set -- cppcheck analyzer tidy
jobs=${JOBS:-2}
mkdir -p "$build"
failed=0

need() {
	command -v "$1" >/dev/null 2>&1 && return
	echo "lint: $1 is not installed (Debian: $2)"
	failed=1
	return 1
}

tidy() {
	need clang-tidy-19 clang-tidy-19 || return
	ls src/*/*.c | xargs -P "$jobs" -n 4 sh -c 'clang-tidy-19 --quiet --config-file=test/lint/clang-tidy.yaml "$@" -- -std=c99 -Iinclude -Isrc -DCN_BUILD' sh 2>/dev/null
}

# cppcheck has no float.h. It reads the code for compilers without vectors.
cppcheck_all() {
	need cppcheck cppcheck || return
	cppcheck -q -j "$jobs" --std=c99 --enable=warning,performance,portability --suppressions-list=test/lint/cppcheck.txt --template='{file}:{line}: warning: {id}: {message}' \
		-Iinclude -Isrc -DCN_BUILD -DFLT_EVAL_METHOD=0 -DFLT_MAX=3.40282347e+38F -D__GNUC__=12 src 2>&1
}

analyzer() {
	need gcc gcc || return
	ls src/*/*.c | xargs -P "$jobs" -n 4 sh -c 'for file; do gcc -std=c99 -O1 -fanalyzer $(sed "/^#/d" test/lint/analyzer.txt) -Iinclude -Isrc -DCN_BUILD -c "$file" -o /dev/null; done' sh 2>&1 |
		grep -E 'warning:|error:'
}

# The processor's, of all that has run so far. `times` must not be in a pipe, which would be a shell of its own.
seconds='FNR == 2 { s = 0; for (i = 1; i <= 2; ++i) { split($i, t, "m"); s += 60 * t[1] + t[2] } print s }'

for tool in "$@"; do
	case $tool in tidy | analyzer) command=$tool ;; cppcheck) command=cppcheck_all ;; *) echo "lint: there is no $tool"; exit 2 ;; esac
	times > "$build/before"
	$command > "$build/$tool.txt"
	times > "$build/after"
	grep -E ': (warning|error): ' "$build/$tool.txt" | sort -u > "$build/$tool.found"
	found=$(wc -l < "$build/$tool.found")
	cat "$build/$tool.found"
	[ "$found" = 0 ] || failed=1
	echo "$tool: $found findings, $(awk "$seconds" "$build/before" "$build/after" | awk '{ s = $1 - s } END { printf "%.0f", s }') s of the processor"
done
exit $failed
