#!/bin/sh
# usage: run.sh build-folder [words]
# Measures every feature (or those whose names contain the words) in its four forms (cost.h) and writes
# feature_cost.csv and feature_cost.md into build-folder. Instructions of 60 steps by callgrind; without valgrind, the
# least processor time of three runs, which is good to some percent only and not held to the 1%.
#
# The exit code is 1 when a feature that nothing uses costs 1% or more of the base scene's step, or changes where bodies go.
set -u
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [words]"; exit 2; }
build=$1
words=${2:-}
program=$build/bin/feature_cost
steps=60
csv=$build/feature_cost.csv
kept=$build/feature_cost.kept
rm -rf "$kept" && mkdir -p "$kept" || exit 2

unit=instructions
command -v valgrind >/dev/null 2>&1 || { unit=ns; echo "cost: valgrind is not installed: processor time instead of instructions"; }

# Cost of a step, and the hash of the drum's bodies.
measure() { # name form
	if [ $unit = instructions ]; then
		row=$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=cost_step "$program" "$1" "$2" $steps 2> "$kept/log") ||
			{ cat "$kept/log" >&2; return 1; }
		echo "$(awk -v steps=$steps '/Collected/ { printf "%.0f", $4 / steps }' "$kept/log") ${row#* }"
	else
		row=$("$program" "$1" "$2") || return 1
		echo "$row" | awk '{ printf "%.0f %s\n", 1000 * $1, $2 }'
	fi
}

# Worlds that several features share are measured once.
shared() { # world name form
	file="$kept/$(echo "$1" | tr ' ' _).$3"
	[ "$1" = base ] && file="$kept/base"
	[ -s "$file" ] || measure "$2" "$3" > "$file" || return 1
	cat "$file"
}

echo "feature,used,units,${unit}_without,${unit}_unused,${unit}_plain,${unit}_used,same_motion_unused" > "$csv"
"$program" --list | awk -v words="$words" 'index($0, words)' > "$kept/list"
[ -s "$kept/list" ] || { echo "cost: no feature has $words in its name; there are:"; "$program" --list | cut -d'|' -f1; exit 2; }
while IFS='|' read -r name has_unused used units without_world plain_world; do
	without=$(shared "$without_world" "$name" 0) || exit 2
	unused= plain= used_cost=
	[ "$has_unused" = 1 ] && { unused=$(measure "$name" 1) || exit 2; }
	[ -n "$used" ] && { plain=$(shared "$plain_world" "$name" 2) || exit 2; used_cost=$(measure "$name" 3) || exit 2; }
	same=
	[ -n "$unused" ] && { [ "${unused#* }" = "${without#* }" ] && same=yes || same=no; }
	echo "$name,$used,$units,${without% *},${unused% *},${plain% *},${used_cost% *},$same" >> "$csv"
	echo "cost: $name" >&2
done < "$kept/list"
rm -rf "$kept"

awk -F, -v unit="$unit" '
function percent(with, without) { return with == "" ? "" : sprintf("%+.2f%%", 100 * (with / without - 1)) }
NR == 1 {
	print "Cost of a step by " unit ", beside the same scene without the feature (see examples/cost/cost.h).\n"
	print "| feature | there, unused | used | of what | " unit " each |"
	print "|---|---|---|---|---|"
}
NR > 1 {
	bad = $5 != "" && ((unit == "instructions" && $5 >= 1.01 * $4) || $8 == "no")
	failed += bad
	each = ($3 > 0 && $7 != "") ? sprintf("%.0f", ($7 - $6) / $3) : ""
	note = bad ? ($8 == "no" ? " MOVES OTHERWISE" : " TOO MUCH") : ""
	printf "| %s | %s%s | %s | %s | %s |\n", $1, percent($5, $4), note, percent($7, $6), $2, each
}
END {
	printf "\nfeatures that cost 1%% or more unused: %d\n", failed
	exit failed > 0
}' "$csv" > "$build/feature_cost.md"
result=$?
cat "$build/feature_cost.md"
exit $result
