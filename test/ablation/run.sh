#!/bin/sh
# usage: run.sh build-folder [--quick] [mechanism...]
# Builds the library, stability, families and the benchmark's scenes with switches (src/base/ablation.h), checks that with all
# mechanisms on they do what the ordinary build does, and measures each mechanism of mechanisms.txt, or those named, off alone:
#   bounds   of make stability that held and do not, the one that is farthest beyond first
#   families seeds of 10 a family that are worse than with the mechanism on
#   tests    those that are about the mechanism, and what of them fails
#   time     of scenes, off over on: least processor time of each step over runs in turn, in one program
# Results are kept in build-folder/ablation/results: a run with names measures those anew. Writes build-folder/ablation/table.md, of all
# that have results. --quick: builds, checks, and one mechanism must lose bounds (test/variants.sh).
# JOBS=2: so many at a time, but for times.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL CAIRN_OFF # makes of their own, not parts of the one that called
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [--quick] [mechanism...]"; exit 2; }
build=$1
out=$build/ablation
results=$out/results
mechanisms=test/ablation/mechanisms.txt
CC=${CC:-gcc}
shift
quick=
[ "${1:-}" = --quick ] && { quick=1; shift; }
switches="$out/off.o $out/tuning.o"
mkdir -p "$results" || exit 2

# ---------------------------------------------------------------- build

for part in off tuning; do
	# shellcheck disable=SC2086
	$CC -std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror -O2 -DCNI_ABLATION -Isrc -c "test/ablation/$part.c" -o "$out/$part.o" || exit 2
done
# Not -Werror: compilers do not know that counts of rounds, variables here, are above zero.
variant() { # targets
	"${MAKE:-make}" -s -j"${JOBS:-2}" BUILD="$out" CC="$CC" CPPFLAGS=-DCNI_ABLATION WERROR= LDFLAGS="$switches" "$@" > "$out/build.log" 2>&1 ||
		{ cat "$out/build.log"; echo "ablation: does not build"; exit 2; }
}
[ -n "$quick" ] || variant "$out/bin/stability"
stability() { # name file: without what the name says
	CAIRN_OFF=$1 "$out/bin/stability" ${3:-} ${4:-} --csv "$2.csv" > "$2.txt" 2>&1
	case $? in 0 | 1) ;; *) tail -n 5 "$2.txt"; echo "ablation: stability failed without $1" ; return 1 ;; esac
}

if [ -n "$quick" ]; then
	out=$out/quick
	mkdir -p "$out"
	variant CFLAGS=-O1 "$out/bin/stability"
	CAIRN_OFF= "$out/bin/stability" 9_cluster > "$out/quick_on.txt" || { tail -n 20 "$out/quick_on.txt"; exit 1; }
	CAIRN_OFF=angular_momentum "$out/bin/stability" 9_cluster > "$out/quick_off.txt" && { echo "ablation: the switch of ANGULAR_MOMENTUM does nothing"; exit 1; }
	tail -n 1 "$out/quick_off.txt"
	exit 0
fi

# ---------------------------------------------------------------- all on: as the ordinary build

tests=$(awk -F ' *[|] *' '!/^#/ { print $4 }' "$mechanisms" | tr ' ' '\n' | sort -u | sed "s|.*|$out/test/&_test|")
# shellcheck disable=SC2086
variant "$out/bin/families" "$out/bin/bench_once" "$out/test/world/determinism_test" $tests
"${MAKE:-make}" -s -j"${JOBS:-2}" BUILD="$build" CC="$CC" "$build/bin/stability" > "$out/build.log" 2>&1 || { cat "$out/build.log"; exit 2; }
values() { cut -d, -f1-7 "$1"; } # of a CSV of stability: no times
"$out/test/world/determinism_test" > "$out/golden.txt" || { cat "$out/golden.txt"; echo "ablation: with everything on, golden hashes differ"; exit 1; }
"$build/bin/stability" --csv "$out/ordinary.csv" > "$out/ordinary.txt"
stability "" "$out/on" || exit 1
values "$out/ordinary.csv" > "$out/ordinary.values"
values "$out/on.csv" > "$out/on.values"
cmp "$out/ordinary.values" "$out/on.values" || { echo "ablation: with everything on, results differ from the ordinary build"; exit 1; }
stability "" "$out/on_soft" --solver soft || exit 1
echo "all on: golden hashes and all metrics as in the ordinary build"

# ---------------------------------------------------------------- one off

row() { awk -F ' *[|] *' -v name="$1" '$1 == name' "$mechanisms"; }
# The list has what base/ablation.h has, and no more.
CAIRN_OFF=list "$out/bin/stability" | sort > "$out/names"
awk -F ' *[|] *' '!/^#/ { print $1 }' "$mechanisms" | sort | diff "$out/names" - || { echo "ablation: $mechanisms and src/base/ablation.h differ"; exit 1; }

bounds_lost() { awk -F, -f test/ablation/bounds_lost.awk "$1" "$2"; } # on.csv off.csv

# "seeds worse|family n, family n": the most first.
families_worse() { # output
	awk '/ seeds, [0-9]+ worse/ && $2 ~ /^[0-9]+$/ { sub(/,/, "", $4); if ($4 > 0) print $4, $1 }' "$1" | sort -rn |
		awk '{ sum += $1; list = list (NR > 1 ? ", " : "") $2 " " $1 } END { printf "%d|%s\n", sum, list }'
}

# Cases of the tests that are about it which fail: "file case, file case".
tests_failed() { # mechanism
	for test in $(row "$1" | awk -F ' *[|] *' '{ print $4 }'); do
		CAIRN_OFF=$1 timeout "${TEST_TIMEOUT_S:-600}" "$out/test/${test}_test" > "$results/$1.test" 2>&1
		[ $? -ge 124 ] && echo "$test crashed, or took too long"
		awk -v test="$test" '/^FAIL / { sub(/^t_/, "", $2); print test " " $2 }' "$results/$1.test"
	done | awk '{ list = list (NR > 1 ? ", " : "") $0 } END { print list }'
}

measure_one() { # mechanism
	on=$out/on.csv solver= solvers=auto,auto
	[ "$1" = NORMAL_LAG ] && { on=$out/on_soft.csv solver='--solver soft' solvers=soft,soft; }
	# shellcheck disable=SC2086
	stability "$1" "$results/$1" $solver || return 1
	bounds_lost "$on" "$results/$1.csv" > "$results/$1.bounds"
	CAIRN_OFF=$1 "$out/bin/families" --seeds "${SEEDS:-10}" --solvers $solvers > "$results/$1.families.txt" 2>&1
	families_worse "$results/$1.families.txt" > "$results/$1.families"
	tests_failed "$1" > "$results/$1.tests"
	rm -f "$results/$1.time"
	echo "ablation: $1: $(cat "$results/$1.bounds"), families $(cat "$results/$1.families"), tests $(cat "$results/$1.tests")" >&2
}

# ---------------------------------------------------------------- times

pin=
command -v taskset >/dev/null 2>&1 && pin="taskset -c $(($(nproc) - 1))" # the first core is the one that others are put on
keep_least() { # times least
	[ -f "$2" ] || { mv "$1" "$2"; return; }
	paste "$1" "$2" | awk '{ print $1 < $2 ? $1 : $2 }' > "$2.new" && mv "$2.new" "$2"
}
once() { # mechanism-or-nothing scene steps least-file
	# shellcheck disable=SC2086
	CAIRN_OFF=$1 $pin "$out/bin/bench_once" "$2" --steps "$3" --times "$out/times" > /dev/null || return 1
	keep_least "$out/times" "$4"
}
time_one() { # mechanism
	list=
	for scene in $(row "$1" | awk -F ' *[|] *' '{ print $3 }'); do
		[ "$scene" = - ] && continue
		rm -f "$out/least_on" "$out/least_off"
		for round in $(seq "${ROUNDS:-2}"); do
			once "" "${scene%:*}" "${scene#*:}" "$out/least_on" || return 1
			once "$1" "${scene%:*}" "${scene#*:}" "$out/least_off" || return 1
			once "$1" "${scene%:*}" "${scene#*:}" "$out/least_off" || return 1
			once "" "${scene%:*}" "${scene#*:}" "$out/least_on" || return 1
		done
		ratio=$(paste "$out/least_off" "$out/least_on" | awk '{ off += $1; on += $2 } END { printf "%.2f", off / on }')
		list="$list${list:+, }${scene%:*} $ratio"
	done
	echo "${list:--}" > "$results/$1.time"
	echo "ablation: $1: $list" >&2
}

asked=${*:-$(cat "$out/names")}
asked=$(echo "$asked" | tr '[:lower:]' '[:upper:]')
running=0
for name in $asked; do
	grep -qx "$name" "$out/names" || { echo "ablation: there is no mechanism $name"; exit 2; }
	measure_one "$name" &
	running=$((running + 1))
	[ $((running % ${JOBS:-1})) = 0 ] && wait
done
wait
for name in $asked; do time_one "$name" || echo "ablation: no time of $name"; done

sh test/ablation/table.sh "$build"
