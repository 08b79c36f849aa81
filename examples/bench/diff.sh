#!/bin/sh
# usage: diff.sh build-folder revision [--quick] [--rounds n] [--scene name]
# Times the library as of a revision (before) and as it is here (after) on the benchmark's scenes. Writes diff.csv and
# diff.md into build-folder/diff; the exit code is 1 when something became slower by more than 3%.
#
# Both are linked with the same program and scenes, those of this tree, compiled against each one's own header; scenes
# that the old header does not allow are taken from the revision. The two run in turn on one core. A run repeats to
# the bit, so the least time of each step over all rounds is added up, which little else on the machine disturbs. What
# looks slower is measured again with as many rounds before it is called so. Instructions are counted by callgrind in the
# first steps after the first, half a second of processor time at most (QUICK: a tenth).
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL # makes of their own, not parts of the one that called
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 2 ] || { echo "usage: diff.sh build-folder revision [--quick] [--rounds n] [--scene name]"; exit 2; }
mkdir -p "$1/diff" || exit 2
build=$(cd "$1" && pwd)
out=$build/diff
asked=$2
shift 2
CC=${CC:-gcc}
flags='-std=c99 -Werror=implicit-function-declaration -O3 -ffp-contract=off -ffunction-sections -fdata-sections'

quick= rounds= scene=
while [ $# -gt 0 ]; do
	case $1 in
	--quick) quick=1 ;;
	--rounds) shift; rounds=${1:-} ;;
	--scene) shift; scene=${1:-} ;;
	*) echo "diff: what is $1?"; exit 2 ;;
	esac
	shift
done
rounds=${rounds:-$([ -n "$quick" ] && echo 2 || echo 3)}
count_ms=$([ -n "$quick" ] && echo 100 || echo 500)

# ---------------------------------------------------------------- two libraries, one program

revision=$(git rev-parse --verify --quiet "$asked^{commit}") || { echo "diff: git knows no revision $asked"; exit 2; }
short=$(git rev-parse --short "$revision")
# A revision's files and its library are kept: the next comparison with it begins at once.
before=$out/$revision
if [ ! -f "$before/complete" ]; then
	rm -rf "$before" && mkdir -p "$before/tree" || exit 2
	git archive "$revision" | tar xf - -C "$before/tree" && : > "$before/complete" || exit 2
fi

library() { # tree build log
	"${MAKE:-make}" -s -j2 -C "$1" BUILD="$2" CC="$CC" "$2/libcairn.a" > "$3" 2>&1 || { cat "$3"; echo "diff: $1 does not build"; exit 2; }
}
library "$before/tree" "$before/build" "$out/before.log"
library . "$build" "$out/after.log"

program() { # header-tree scenes-tree library program
	objects=$4.objects
	rm -rf "$objects" && mkdir -p "$objects/include"
	# Measuring is always this tree's: a revision may have folders of the same names.
	ln -s "$(pwd)/examples/measure" "$objects/include/measure" || return 1
	ln -s "$(cd "$2" && pwd)/examples/scenes" "$objects/include/scenes" || return 1
	for file in examples/bench/once.c examples/measure/measure.c examples/measure/clock.c "$2"/examples/scenes/*.c; do
		# shellcheck disable=SC2086
		"$CC" $flags -I"$1/include" -I"$objects/include" -c "$file" -o "$objects/$(basename "$file" .c).o" || return 1
	done
	"$CC" "$objects"/*.o "$3" -lpthread -lm -o "$4"
}
program . . "$build/libcairn.a" "$out/after" || exit 2
if ! program "$before/tree" . "$before/build/libcairn.a" "$out/before" 2> "$out/program.log"; then
	program "$before/tree" "$before/tree" "$before/build/libcairn.a" "$out/before" 2>> "$out/program.log" ||
		{ echo "diff: nothing here can be compiled against the header of $short: see $out/program.log"; exit 2; }
	echo "diff: the scenes of $short, since its header is too old for those of this tree"
fi

# ---------------------------------------------------------------- runs

pin=
if command -v taskset >/dev/null 2>&1; then
	pin="taskset -c $(($(nproc) - 1))" # the first core is the one that others are put on
else
	echo "diff: taskset is not installed: times are of whatever core it runs on"
fi
count=1
command -v valgrind >/dev/null 2>&1 || { count=; echo "diff: valgrind is not installed: no instructions"; }

# Keeps in $2 the least of each line of the two files.
keep_least() {
	[ -f "$2" ] || { mv "$1" "$2"; return; }
	paste "$1" "$2" | awk '{ print $1 < $2 ? $1 : $2 }' > "$2.new" && mv "$2.new" "$2"
}
total() { awk '{ sum += $1 } END { printf "%.4f", sum }' "$1"; }

once() { # side scene steps
	# shellcheck disable=SC2086
	$pin "$out/$1" "$2" --steps "$3" --times "$out/times" > "$out/$1.row" 2> "$out/$1.error" ||
		{ cat "$out/$1.error"; echo "diff: $2 failed"; exit 2; }
	keep_least "$out/times" "$out/$1.least"
}

in_turn() { # scene steps rounds
	round=0
	while [ $round -lt "$3" ]; do
		once before "$1" "$2"
		once after "$1" "$2"
		once after "$1" "$2"
		once before "$1" "$2"
		round=$((round + 2))
	done
}

instructions() { # side scene steps
	valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=measure_step "$out/$1" "$2" --steps "$3" 2>&1 >/dev/null |
		awk '/Collected/ { print $4 }'
}

# As many steps as fit, but two at least: the first is not counted.
steps_to_count() {
	awk -v most="$count_ms" '{ sum += $1; if (sum > most) exit; ++steps } END { print steps < 1 ? 2 : steps + 1 }' "$out/before.least"
}

is_slower() {
	awk -v before="$(total "$out/before.least")" -v after="$(total "$out/after.least")" 'BEGIN { exit !(after > 1.03 * before) }'
}

compare() { # scene steps
	rm -f "$out/before.least" "$out/after.least"
	in_turn "$1" "$2" "$rounds"
	# What is over in a moment is noisier, and cheap to repeat.
	awk -v ms="$(total "$out/before.least")" 'BEGIN { exit !(ms < 200) }' && in_turn "$1" "$2" $((4 * rounds))
	is_slower && in_turn "$1" "$2" $((2 * rounds))
	before_count= after_count=
	if [ -n "$count" ]; then
		counted=$(steps_to_count)
		before_count=$(instructions before "$1" "$counted")
		after_count=$(instructions after "$1" "$counted")
	fi
	times=$(total "$out/before.least"),$(total "$out/after.least")
	echo "$(cat "$out/before.row"),$(cut -d, -f4- "$out/after.row"),$times,$before_count,$after_count" |
		awk -F, -v OFS=, '{ print $1, $2, $12 / ($2 - 1), $13 / ($2 - 1), $14, $15, $4, $8, $5, $9, $6, $10, $7, $11 }'
}

scenes=$("$out/after" --list | awk -v only="$scene" 'only == "" || $1 == only')
[ -n "$scenes" ] || { echo "diff: the benchmark has no scene $scene; it has:"; "$out/after" --list; exit 2; }
csv=$out/diff.csv
echo scene,steps,ms_before,ms_after,instructions_before,instructions_after,displacement_m_before,displacement_m_after,\
joint_m_before,joint_m_after,penetration_m_before,penetration_m_after,hash_before,hash_after > "$csv"
echo "$scenes" | while read -r name steps; do
	[ -n "$quick" ] && steps=$((steps / 4 > 60 ? steps / 4 : 60))
	"$out/before" --list | grep -q "^$name " || { echo "diff: $short has no scene $name"; continue; }
	compare "$name" "$steps" > "$out/line" || { cat "$out/line"; exit 2; }
	cat "$out/line" >> "$csv"
	echo "diff: $name" >&2
done || exit 2

# ---------------------------------------------------------------- table

awk -F, -v short="$short" -v quick="$quick" '
function pair(before, after) { return before == "" ? "" : sprintf((before == after) ? "%.3g" : "%.3g -> %.3g", 1000 * before, 1000 * after) }
BEGIN {
	print "before: " short ", after: this tree; least processor time of a step, errors in mm" (quick ? "; QUICK: a part of the steps" : "") "\n"
	print "| scene | ms before | ms after | ratio | instructions | joint error | penetration | displacement | |"
	print "|---|---|---|---|---|---|---|---|---|"
}
NR > 1 {
	ratio = $4 / $3
	slow = ratio > 1.03
	slower += slow
	sum += log(ratio)
	++rows
	instructions = $5 > 0 ? sprintf("%.4f", $6 / $5) : ""
	note = ($13 == $14 ? "same bits" : "other bits") (slow ? ", SLOWER" : "")
	printf "| %s | %.4f | %.4f | %.3f | %s | %s | %s | %s | %s |\n", $1, $3, $4, ratio, instructions, pair($9, $10), pair($11, $12), pair($7, $8), note
}
END {
	printf "\ngeometric mean of the ratios: %.3f; slower by more than 3%%: %d of %d\n", exp(sum / rows), slower, rows
	exit slower > 0
}' "$csv" > "$out/diff.md"
result=$?
cat "$out/diff.md"
exit $result
