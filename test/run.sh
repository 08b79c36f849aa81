#!/bin/sh
# usage: run.sh output-folder executable...
# Runs every test executable from the top folder, JOBS at a time, shows their output in a fixed
# order, and ends with the programs that took most processor time and one line "N passed, N failed, N skipped"
# summed over all. An executable that crashes, runs out of time or does not print its own final line counts as one
# failure. output-folder/seconds.txt: processor seconds of each, the most first; they grow little on a busy machine.
# RUNNER: an emulator to run them by; scripts (.sh) run without.
set -u
output=$1
shift
jobs=${JOBS:-1}
limit=${TEST_TIMEOUT_S:-600}
rm -rf "$output"
mkdir -p "$output"
[ $# -gt 0 ] || { echo "0 passed, 0 failed, 0 skipped"; exit 0; }

command -v timeout >/dev/null 2>&1 && guard="timeout $limit" || guard=
# Each run leaves <name>.txt, <name>.code and <name>.times, which holds what `times` prints.
printf '%s\n' "$@" | GUARD="$guard" OUTPUT="$output" RUNNER="${RUNNER:-}" xargs -P "$jobs" -n 1 sh -c '
	name=$(echo "$1" | tr / _)
	case $1 in
		*.sh) $GUARD sh "$1" ;;
		*) $GUARD $RUNNER "$1" ;;
	esac > "$OUTPUT/$name.txt" 2>&1
	echo $? > "$OUTPUT/$name.code"
	times > "$OUTPUT/$name.times"
' sh

passed=0 failed=0 skipped=0
broken=
for test in "$@"; do
	name=$(echo "$test" | tr / _)
	code=$(cat "$output/$name.code")
	echo "== $test"
	cat "$output/$name.txt"
	line=$(grep -aE '^[0-9]+ passed, [0-9]+ failed, [0-9]+ skipped$' "$output/$name.txt" | tail -n 1)
	if [ -z "$line" ]; then
		echo "FAIL $test ended with code $code before its last line"
		line="0 passed, 1 failed, 0 skipped"
	fi
	# shellcheck disable=SC2086
	set_counts() { p=$1 f=$3 s=$5; }
	set_counts $line
	if [ "$code" != 0 ] && [ "$f" = 0 ]; then
		echo "FAIL $test ended with code $code"
		f=1
	fi
	[ "$f" = 0 ] || broken="$broken $test"
	passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
done
# The second line of `times` is of the children: user and system time, as 0m1.234s.
for test in "$@"; do
	awk -v test="$test" 'NR == 2 {
		for (i = 1; i <= 2; ++i) { split($i, part, "m"); seconds += 60 * part[1] + part[2] }
		printf "%.2f %s\n", seconds, test
	}' "$output/$(echo "$test" | tr / _).times"
done | sort -rn > "$output/seconds.txt"
awk '{ sum += $1; if (NR <= 8) list = list (NR > 1 ? ", " : "") $2 " " $1 }
	END { printf "processor time: %.0f s; most: %s\n", sum, list }' "$output/seconds.txt"
[ -z "$broken" ] || echo "failed in:$broken"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
