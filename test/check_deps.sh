#!/bin/sh
# Checks the layers of src/ by its #include lines and lists the longest files and functions.
#
#   base < geometry < model < stages < world    a file includes its own layer or a lower one
#
#  - Stages do not know each other: a file in stages/ includes a header of stages/ only if that header
#    is of its own family (same first word of the name) or is shared, that is, there is no .c file of
#    the header's whole name.
#  - Examples use the public header only, but for the benchmark of the broadphases.
set -u
cd "$(dirname "$0")/.." || exit 2

awk_rules='
function layer(path) {
	if (path ~ /^base\//) return 1
	if (path ~ /^geometry\//) return 2
	if (path ~ /^model\//) return 3
	if (path ~ /^stages\//) return 4
	if (path ~ /^world\//) return 5
	return 0
}
function family(path) { sub(/^.*\//, "", path); sub(/[_.].*$/, "", path); return path }
function complain(why) { printf "%s:%d: includes %s: %s\n", FILENAME, FNR, included, why; broken = 1 }
BEGIN {
	count = split(sources, list, " ")
	for (i = 1; i <= count; ++i) exists[list[i]] = 1
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
	split($0, part, "\"")
	included = part[2]
	file = FILENAME
	sub(/^src\//, "", file)
	if (included == "cairn.h") next
	mine = layer(file)
	theirs = layer(included)
	if (theirs == 0) {
		complain("write the path from src/")
		next
	}
	if (theirs > mine) complain("a higher layer")
	source = included
	sub(/\.h$/, ".c", source)
	if (mine == 4 && theirs == 4 && family(file) != family(included) && (("src/" source) in exists))
		complain("another stage")
}
END { exit broken }
'
status=0
sources=$(find src -name '*.c' | sort | tr '\n' ' ')
# shellcheck disable=SC2046
awk -v sources="$sources" "$awk_rules" $(find src -name '*.[ch]' | sort) || status=1
if grep -nE '#[ 	]*include[ 	]*"(base|geometry|model|stages|world)/' $(find examples -name '*.[ch]' ! -path examples/bench/broadphase.c); then
	echo "examples include the public header only"
	status=1
fi

echo "ten longest files (lines):"
find src include examples test -name '*.[ch]' | xargs wc -l | awk '$2 != "total"' | sort -rn | head -n 10
# A function starts at a { in the first column and ends at a } there; its name stands before the first
# ( of the lines before.
echo "ten longest functions (lines):"
find src examples -name '*.c' | sort | xargs awk '
FNR == 1 { head = ""; start = 0 }
/^[A-Za-z_].*\(/ { head = $0 }
/^\{/ { start = FNR }
/^\}/ && start > 0 {
	name = head
	sub(/\(.*/, "", name)
	sub(/^.*[ *]/, "", name)
	printf "%7d %s: %s\n", FNR - start + 1, FILENAME, name
	start = 0
}' | sort -rn | head -n 10
[ $status = 0 ] && echo "layers: good"
exit $status
