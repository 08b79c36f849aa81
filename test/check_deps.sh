#!/bin/sh
# usage: check_deps.sh [build-folder]    build: its release/ holds the objects; `make check-deps` makes them
# Checks the layers of src/ and lists the longest files and functions.
#
#  - A file includes its own folder or a lower one, and an object uses symbols of its own folder or a lower one
#    (`nm`: what a header declares in one folder may be defined in another).
#  - Files of a folder use each other in one direction: no circle among the objects of a folder. CIRCLES=1 in the
#    environment lists who uses what in one.
#  - Other folders include only the headers in `public` of the folders that solve (contacts and above).
#  - Examples use the public header only, but for the benchmark of the broadphases.
set -u
cd "$(dirname "$0")/.." || exit 2

folders='base geometry collision linear broadphase model contacts narrowphase joints direct step world query save' # the lowest first
one_way=$folders
closed='contacts narrowphase joints direct step world query save' # folders whose other headers are private
public='contacts/contacts.h contacts/contact_pass.h contacts/deep_lanes.h narrowphase/narrowphase.h narrowphase/touch.h joints/joints.h joints/joint_type.h joints/joint_constraint.h joints/joint_pass.h joints/joint_kernel.h direct/direct.h step/step.h world/error.h'
build=${1:-build}
status=0
sources=$(find src -name '*.c' | sort | tr '\n' ' ')

# ---------------------------------------------------------------- includes

include_rules='
function layer(path) { sub(/\/.*/, "", path); return path in level ? level[path] : 0 }
function folder(path) { sub(/\/.*/, "", path); return path }
function complain(why) { printf "%s:%d: includes %s: %s\n", FILENAME, FNR, included, why; broken = 1 }
BEGIN {
	count = split(folders, list, " ")
	for (i = 1; i <= count; ++i) level[list[i]] = i
	count = split(closed, list, " ")
	for (i = 1; i <= count; ++i) is_closed[list[i]] = 1
	count = split(public, list, " ")
	for (i = 1; i <= count; ++i) is_public[list[i]] = 1
}
FNR == 1 {
	file = FILENAME
	sub(/^src\//, "", file)
	if (!layer(file)) { printf "%s: its folder is not in the list of folders\n", FILENAME; broken = 1 }
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
	split($0, part, "\"")
	included = part[2]
	if (included == "cairn.h") next
	mine = layer(file)
	theirs = layer(included)
	if (theirs == 0) {
		complain("write the path from src/")
		next
	}
	if (theirs > mine) complain("a higher layer")
	if (folder(file) != folder(included) && (folder(included) in is_closed) && !(included in is_public))
		complain("a private header of another folder")
}
END { exit broken }
'
# shellcheck disable=SC2046
awk -v folders="$folders" -v closed="$closed" -v public="$public" "$include_rules" $(find src -name '*.[ch]' | sort) || status=1
if grep -nE "#[ 	]*include[ 	]*\"($(echo "$folders" | tr ' ' '|'))/" $(find examples -name '*.[ch]' ! -path examples/bench/broadphase.c); then
	echo "examples include the public header only"
	status=1
fi

# ---------------------------------------------------------------- symbols

# One line a symbol: file from src/, D (defines) or U (uses), symbol.
symbols() {
	for source in $sources; do
		object=$build/release/${source%.c}.o
		[ -f "$object" ] || { echo "missing $object"; return; }
		nm -g "$object" | awk -v file="${source#src/}" '
			{ type = $(NF - 1); name = $NF; sub(/^_/, "", name) }
			NF >= 2 && name ~ /^cni?_/ { print file, type == "U" ? "U" : "D", name }'
	done
}

# Strongly connected components by Tarjan, Depth-first search and linear graph algorithms, 1972: a circle is one of more than one file.
symbol_rules='
function folder(file) { sub(/\/.*/, "", file); return file }
function short(file) { sub(/^.*\//, "", file); sub(/\.c$/, "", file); return file }
function visit(v,    i, w) {
	at[v] = low[v] = ++visited
	stack[++depth] = v
	on_stack[v] = 1
	for (i = 1; i <= used[v]; ++i) {
		w = uses[v, i]
		if (!(w in at)) {
			visit(w)
			if (low[w] < low[v]) low[v] = low[w]
		} else if (on_stack[w] && at[w] < low[v])
			low[v] = at[w]
	}
	if (low[v] == at[v]) take_component(v)
}
function take_component(v,    w, size, names) {
	++components
	do {
		w = stack[depth--]
		on_stack[w] = 0
		component[w] = components
		names = short(w) (size++ ? " " : "") names
	} while (w != v)
	if (size > 1) {
		held = (" " one_way " ") ~ (" " folder(v) " ")
		printf "%s: circle of %d files: %s\n", folder(v) "/", size, names
		if (held) broken = 1
		++circles
		in_circles += size
		is_circle[components] = 1
	}
}
BEGIN {
	count = split(folders, list, " ")
	for (i = 1; i <= count; ++i) level[list[i]] = i
}
$1 == "missing" { print $2 " is missing: run make"; broken = 1; next }
!($1 in seen) { seen[$1] = 1; files[++file_count] = $1 }
$2 == "D" { home[$3] = $1 }
$2 == "U" { user[++use_count] = $1; symbol[use_count] = $3 }
END {
	for (i = 1; i <= use_count; ++i) {
		if (!(symbol[i] in home) || (from = user[i]) == (to = home[symbol[i]])) continue
		if (level[folder(to)] > level[folder(from)]) {
			printf "src/%s: uses %s of src/%s: a higher layer\n", from, symbol[i], to
			broken = 1
		}
		if (folder(to) != folder(from)) continue
		if (!((from, to) in edge)) uses[from, ++used[from]] = to
		edge[from, to] = edge[from, to] " " symbol[i]
	}
	for (i = 1; i <= file_count; ++i) if (!(files[i] in at)) visit(files[i])
	for (i = 1; show && i <= file_count; ++i)
		for (k = 1; k <= used[files[i]]; ++k) {
			to = uses[files[i], k]
			if (component[to] == component[files[i]] && is_circle[component[to]]) printf "  %s -> %s:%s\n", short(files[i]), short(to), edge[files[i], to]
		}
	printf "symbols: %d files, %d uses, %d circles of %d files together; held to one direction: %s\n", file_count, use_count, circles, in_circles, one_way
	exit broken
}
'
if command -v nm >/dev/null 2>&1; then
	symbols | awk -v folders="$folders" -v one_way="$one_way" -v show="${CIRCLES:+1}" "$symbol_rules" || status=1
else
	echo "nm is not installed: symbols are not checked"
fi

# ---------------------------------------------------------------- lengths

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
