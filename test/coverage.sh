#!/bin/sh
# usage: coverage.sh build-folder
# Which lines and branches of src/ the tests of `make test` run, as clang's source-based coverage counts them: a branch is one outcome of one
# condition, `a && b` has four. The library is that of users, without the checks of -DCNI_DEBUG. Headers that several files include
# (kernels, once a vector width) count once, as their best covered instance.
#
# Prints a line per folder and the total; fails below 95% of lines or 85% of branches. build-folder/coverage/uncovered.txt: every
# line that no test runs; .../html: the sources with counts.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL
build=$1/coverage
for tool in clang-19 llvm-profdata-19 llvm-cov-19; do
	command -v $tool >/dev/null 2>&1 || { echo "coverage: $tool is not installed (Debian: clang-19 llvm-19)"; exit 1; }
done
mkdir -p "$build"
build=$(cd "$build" && pwd)
rm -rf "$build/profiles"
LLVM_PROFILE_FILE=$build/profiles/%m_%p.profraw ${MAKE:-make} -s test BUILD="$build" CC="${CC_COVERAGE:-clang-19}" CFLAGS= TEST_DEFINES= JOBS="${JOBS:-2}" \
	TEST_CFLAGS='-O1 -gline-tables-only -fprofile-instr-generate -fcoverage-mapping' > "$build/test.log" 2>&1 ||
	{ tail -n 20 "$build/test.log"; exit 1; }
tail -n 1 "$build/test.log"

# A program with the whole library: a test is linked with what it calls only.
echo 'int main(void) { return 0; }' > "$build/all.c"
clang-19 -fprofile-instr-generate -fcoverage-mapping "$build/all.c" -Wl,--whole-archive "$build/libcairn-checked.a" -Wl,--no-whole-archive \
	-lm -lpthread -o "$build/all" &&
	llvm-profdata-19 merge -sparse "$build"/profiles/*.profraw -o "$build/all.profdata" || exit 1
cov() { # llvm-cov command options...
	command=$1
	shift
	llvm-cov-19 "$command" "$build/all" -instr-profile="$build/all.profdata" -ignore-filename-regex="$build/all.c" "$@" 2>/dev/null
}
cov show -show-instantiations=false | awk '/^\/.*:$/ { file = $0; sub(/:$/, "", file); sub(/.*\/src\//, "src/", file); next }
	/^ *[0-9]+\| *0\|/ { print file ":" $0 }' > "$build/uncovered.txt"
cov show -show-instantiations=false -show-branches=count -format=html -output-dir="$build/html"
cov report -show-region-summary=false | awk -v lines_least=95 -v branches_least=85 '
	function percent(all, missed) { return all == 0 ? 100 : 100 * (all - missed) / all }
	function row(name) {
		printf "%-12s lines %6d, %6.2f%% run   branches %6d, %6.2f%% taken\n", name, lines[name], percent(lines[name], lines_missed[name]),
			branches[name], percent(branches[name], branches_missed[name])
	}
	NF == 10 && $1 ~ /\.[ch]$/ {
		n = split($1, path, "/")
		folder = n > 1 ? path[n - 1] : "."
		if (!(folder in lines)) order[++folders] = folder
		lines[folder] += $5; lines_missed[folder] += $6; branches[folder] += $8; branches_missed[folder] += $9
		lines["total"] += $5; lines_missed["total"] += $6; branches["total"] += $8; branches_missed["total"] += $9
	}
	END {
		for (k = 1; k <= folders; ++k) if (lines[order[k]] > 0) row(order[k])
		row("total")
		bad = percent(lines["total"], lines_missed["total"]) < lines_least || percent(branches["total"], branches_missed["total"]) < branches_least
		if (bad || lines["total"] == 0) { printf "below %d%% of lines or %d%% of branches\n", lines_least, branches_least; exit 1 }
	}'
