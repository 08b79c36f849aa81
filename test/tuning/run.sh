#!/bin/sh
# usage: run.sh build-folder [constant...]
# Builds the stability suite with the tuning constants of src/model/tuning.h as variables (-DCNI_ABLATION) and runs it with each constant, or
# those named, times 0.7 and 1.4. Prints a row of a table per constant: bounds that hold without and not with the change, and the worst.
# Environment: SCENES: words of names of scenes, default a short list; "" means the whole suite. JOBS=2: constants at the same time.
# Results stay in build-folder/tuning/results: a constant that has them is not run again, so a run can be interrupted.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL CAIRN_OFF CAIRN_TUNE
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [constant...]"; exit 2; }
build=$1
shift
out=$build/tuning
CC=${CC:-gcc}
SCENES=${SCENES-incline_0 incline_1. 8_drop 9_cluster 10_bullet_dyn_ collision_chain 2_ 3_chain chain_swing_1:10000 cantilever10 bridge links_of_2 ragdolls 4_stack20 4_heavy stack20_vary heavy_top_x10000 pyramid20 6_arch card_house plank stack100 pyramid50 arch_thick random_30hz}
results=$out/results/$(echo "$SCENES" | cksum | cut -d' ' -f1)
mkdir -p "$results" || exit 2

for part in off tuning; do
	# shellcheck disable=SC2086
	$CC -std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror -O2 -DCNI_ABLATION -Isrc -Iinclude -c "test/ablation/$part.c" -o "$out/$part.o" || exit 2
done
# Not -Werror: as in test/ablation/run.sh.
"${MAKE:-make}" -s -j"${JOBS:-2}" BUILD="$out" CC="$CC" CPPFLAGS=-DCNI_ABLATION WERROR= LDFLAGS="$out/off.o $out/tuning.o" "$out/bin/stability" \
	> "$out/build.log" 2>&1 || { cat "$out/build.log"; echo "tuning: does not build"; exit 2; }

suite() { # setting csv
	[ -f "$2" ] && return
	# shellcheck disable=SC2086
	CAIRN_TUNE=$1 timeout "${TIMEOUT_S:-120}" "$out/bin/stability" $SCENES --csv "$2.part" > "$2.txt" 2>&1
	case $? in 0 | 1) mv "$2.part" "$2" ;; *) echo "tuning: $1: the suite crashed or took too long" >&2 ;; esac
}

# "0" or "count: the bound exceeded by the largest factor".
bounds_lost() { # on.csv changed.csv
	[ -f "$2" ] || { echo "crashed, or took too long"; return; }
	awk -F, -f test/ablation/bounds_lost.awk "$1" "$2" | sed 's/|$//; s/|/: /'
}

suite "" "$results/on.csv"
[ -f "$results/on.csv" ] || exit 1
CAIRN_TUNE=list "$out/bin/stability" > "$out/names"
asked=${*:-$(cut -d' ' -f1 "$out/names")}
for name in $asked; do
	grep -q "^$name " "$out/names" || { echo "tuning: there is no constant $name"; exit 2; }
done
running=0
for name in $asked; do
	{ suite "$name=0.7" "$results/$name.less.csv"; suite "$name=1.4" "$results/$name.more.csv"; } &
	running=$((running + 1))
	[ $((running % ${JOBS:-2})) = 0 ] && wait
done
wait
echo "| constant | value | bounds lost at 0.7 | bounds lost at 1.4 |"
echo "|---|---|---|---|"
for name in $asked; do
	value=$(awk -v name="$name" '$1 == name { print $2 }' "$out/names")
	echo "| \`$name\` | $value | $(bounds_lost "$results/on.csv" "$results/$name.less.csv") | $(bounds_lost "$results/on.csv" "$results/$name.more.csv") |"
done
