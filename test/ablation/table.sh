#!/bin/sh
# usage: table.sh build-folder
# Writes build-folder/ablation/table.md, of all mechanisms of mechanisms.txt that run.sh has measured, and prints it.
set -u
cd "$(dirname "$0")/../.." || exit 2
[ $# -eq 1 ] || { echo "usage: table.sh build-folder"; exit 2; }
out=$1/ablation
results=$out/results
mechanisms=test/ablation/mechanisms.txt

# Lines of whole files, and of functions: from the line with the name to the } in the first column.
lines_of() { # files
	for file in $1; do
		case $file in
		*'#'*) awk -v name="${file#*#}" '
			$0 ~ "^[a-zA-Z].*[ *]" name "\\(" && !/;$/ { inside = 1 }
			inside { ++lines }
			/^\}/ { inside = 0 }
			END { if (!lines) exit 1; print lines }' "src/${file%#*}" || { echo "ablation: no function $file" >&2; return 1; } ;;
		*) wc -l < "src/$file" ;;
		esac
	done | awk '{ sum += $1 } END { print sum }'
}

{
	echo "| mechanism | lines | bounds lost (the farthest) | seeds worse | tests that fail | time, off over on |"
	echo "|---|---|---|---|---|---|"
	awk -F ' *[|] *' '!/^#/' "$mechanisms" | while IFS= read -r line; do
		name=${line%% *}
		[ -f "$results/$name.bounds" ] || continue
		title=$(echo "$line" | awk -F ' *[|] *' '{ print $2 }')
		files=$(echo "$line" | awk -F ' *[|] *' '{ print $5 }')
		bounds=$(awk -F'|' '{ print ($1 == 0 ? "none" : $1 ($2 != "" ? " (" $2 ")" : "")) }' "$results/$name.bounds")
		tests=$(cat "$results/$name.tests" 2>/dev/null)
		seeds=$(awk -F'|' '{ print ($1 == 0 ? "none" : $1 " (" $2 ")") }' "$results/$name.families")
		echo "| $title | $(lines_of "$files") | $bounds | $seeds | ${tests:-none} | $(cat "$results/$name.time" 2>/dev/null || echo -) |"
	done
} > "$out/table.md"
cat "$out/table.md"
