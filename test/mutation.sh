#!/bin/sh
# usage: mutation.sh [--check] [--quick] [--only pattern] [--jobs n] [--folder folder]
# Mutation testing: each line of mutation.list is a small fault, which a test must catch.
#   --check    only whether every line still applies: its text is found exactly once (a second)
#   --quick    only the tests that a line names, not all others after them
#   --only     lines that contain the pattern (grep -E)
#   --jobs     mutations at a time, each on a copy of the tree (1)
#   --folder   where the copies are, and stay; without it in a temporary folder
# A line: file :: text => replacement :: tests. The file is found by its base name under src/; tests are those most likely to
# fail, and run first. Comparisons with golden hashes do not count (CAIRN_NO_GOLDEN): they say that something changed,
# not that it is wrong. A mutation that does not compile, or runs out of time, is caught only where `build` or `timeout`
# stands among its tests. One line each: caught by what, or SURVIVED; exit code 1 when one survives or does not apply.
set -u
cd "$(dirname "$0")/.." || exit 2
list=test/mutation.list
mode=run quick= only=. jobs=1 folder=
while [ $# -gt 0 ]; do
	case $1 in
		--check) mode=check ;;
		--quick) quick=1 ;;
		--only) only=$2; shift ;;
		--jobs) jobs=$2; shift ;;
		--folder) folder=$2; shift ;;
		*) sed -n '2,8s/^# //p' test/mutation.sh; exit 2 ;;
	esac
	shift
done

# ---- lines of the list

# Every line split, one a line: number, and fields between tabs. A line that is not of the form stops the script.
fields() {
	awk -v only="$only" '
		/^#/ || /^[[:space:]]*$/ { next }
		$0 !~ only { next }
		{
			first = index($0, " :: ")
			arrow = index($0, " => ")
			rest = substr($0, arrow + 4)
			last = match(rest, / :: [^:]*$/)
			if (!first || !arrow || !last || first > arrow) {
				printf "mutation.list:%d: not of the form file :: text => replacement :: tests\n", NR > "/dev/stderr"
				exit 2
			}
			print NR "\t" substr($0, 1, first - 1) "\t" substr($0, first + 4, arrow - first - 4) "\t" substr(rest, 1, last - 1) "\t" substr(rest, last + 4)
		}' "$list"
}

# The files of that name in which the text is, one a line and once for each time.
places() { # name text
	find src -name "$1" | sort | while read -r file; do
		TEXT=$2 awk '{
			rest = $0
			while ((at = index(rest, ENVIRON["TEXT"])) > 0) {
				print FILENAME
				rest = substr(rest, at + length(ENVIRON["TEXT"]))
			}
		}' "$file"
	done
}

# The line's only file; nothing, and a message, when the text is not found exactly once.
place() { # number name text
	found=$(places "$2" "$3")
	case $found in
		'') echo "mutation.list:$1: $2 has no text '$3'" >&2 ;;
		*'
'*) echo "mutation.list:$1: $2 has the text '$3' more than once" >&2 ;;
		*) echo "$found" ;;
	esac
}

# ---- check

if [ $mode = check ]; then
	fields > /dev/null || exit 2
	fields | {
		count=0 wrong=0
		while IFS='	' read -r number name text new tests; do
			count=$((count + 1))
			[ -n "$(place "$number" "$name" "$text")" ] || wrong=$((wrong + 1))
			[ "$text" != "$new" ] || { echo "mutation.list:$number: changes nothing"; wrong=$((wrong + 1)); }
			for test in $tests; do
				case $test in build | timeout) continue ;; esac
				[ -f "test/${test}_test.c" ] || { echo "mutation.list:$number: there is no test $test"; wrong=$((wrong + 1)); }
			done
		done
		echo "mutations: $count, $wrong do not apply"
		[ $wrong = 0 ] && [ $count -gt 0 ]
	}
	exit
fi

# ---- copies of the tree

if [ -z "$folder" ]; then
	folder=$(mktemp -d)
	trap 'rm -rf "$folder"' EXIT
	trap 'exit 130' INT TERM
fi
mkdir -p "$folder"
export CAIRN_NO_GOLDEN=1
unset MAKEFLAGS MFLAGS MAKELEVEL

# As make test runs them, optimized. Warnings are no errors: a test is to say what is wrong.
build() { # copy targets...
	copy=$1
	shift
	(cd "$copy" && ${MAKE:-make} -s WERROR= CFLAGS= TEST_CFLAGS=-O1 TEST_DEFINES=-DCNI_DEBUG "$@") > "$copy.log" 2>&1
}

# Only files that differ, so that what was built there before is not built again.
copy_tree() { # copy
	mkdir -p "$1"
	find Makefile README.md src include test examples bindings -type f | while read -r file; do
		cmp -s "$file" "$1/$file" && continue
		mkdir -p "$1/$(dirname "$file")"
		cp "$file" "$1/$file"
	done
	(cd "$1" && find src test examples -type f) | while read -r file; do
		[ -f "$file" ] || rm -f "$1/$file"
	done
}

# Fails it every time? Threads may meet or not.
fails() { # copy test limit
	run_test "$1" "$2" "$3" && return 1
	run_test "$1" "$2" "$3" && return 1
	run_test "$1" "$2" "$3" && return 1
	return 0
}

seconds() { date +%s.%N 2>/dev/null || date +%s; }

# 0: passed, 1: failed, 124: out of time.
run_test() { # copy test limit
	(cd "$1" && timeout "$3" "build/test/$2_test" > "$1.out" 2>&1) 2>/dev/null # the shell reports crashes
	case $? in
		0) return 0 ;;
		124) return 124 ;;
		*) return 1 ;;
	esac
}

copy_tree "$folder/1"
build "$folder/1" -j"$jobs" build/libcairn-checked.a build/libexamples-checked.a || { cat "$folder/1.log"; exit 2; }

# Without a mutation every test passes, or nothing that follows means anything. Quickest first.
if [ -n "$quick" ]; then
	all=$(fields | cut -f 5 | tr ' ' '\n' | grep / | sort -u)
else
	all=$(find test -name '*_test.c' ! -name '*_time_test.c' | sed 's/^test\///; s/_test\.c$//' | sort)
fi
: > "$folder/times"
targets=
for test in $all; do targets="$targets build/test/${test}_test"; done
# shellcheck disable=SC2086
build "$folder/1" -j"$jobs" $targets || { cat "$folder/1.log"; exit 2; }
for test in $all; do
	started=$(seconds)
	if fails "$folder/1" "$test" 600; then
		cat "$folder/1.out"
		echo "$test fails without a mutation"
		exit 2
	fi
	echo "$(seconds) $started $test" | awk '{ printf "%.2f %s\n", $1 - $2, $3 }' >> "$folder/times"
done
sort -n "$folder/times" | cut -d ' ' -f 2 > "$folder/order"
k=2
while [ $k -le "$jobs" ]; do
	[ -d "$folder/$k" ] || cp -pR "$folder/1" "$folder/$k"
	copy_tree "$folder/$k"
	k=$((k + 1))
done

# ---- one mutation

limit_of() { # test: ten times what it takes, and half a minute
	awk -v test="$1" '$2 == test { print int(10 * $1 + 30) }' "$folder/times"
}

# Prints what a mutated copy is caught by.
judge() { # copy tests
	copy=$1 named=$2 verdict=SURVIVED
	if ! build "$copy" build/libcairn-checked.a; then
		case " $named " in *' build '*) echo 'caught by build' ;; *) echo 'DOES NOT COMPILE' ;; esac
		return
	fi
	rest=
	[ -n "$quick" ] || rest=$(cat "$folder/order")
	seen=' '
	for test in $named $rest; do
		case $test in build | timeout) continue ;; esac
		case $seen in *" $test "*) continue ;; esac
		seen="$seen$test "
		build "$copy" "build/test/${test}_test" || { echo "DOES NOT COMPILE with $test"; return; }
		run_test "$copy" "$test" "$(limit_of "$test")"
		case $? in
			0) ;;
			124)
				case " $named " in *' timeout '*) echo "caught by timeout of $test"; return ;; esac
				verdict="OUT OF TIME in $test" ;;
			*)
				fails "$copy" "$test" "$(limit_of "$test")" || continue
				echo "caught by $test$(grep -a -m 1 '^FAIL' "$copy.out" | sed 's/^FAIL/,/')"; return ;;
		esac
	done
	echo "$verdict"
}

mutate() { # copy number name text new tests
	file=$(place "$2" "$3" "$4")
	[ -n "$file" ] || { echo "$2	$3: $4 => $5	DOES NOT APPLY"; return; }
	TEXT=$4 NEW=$5 awk '{
		at = index($0, ENVIRON["TEXT"])
		print (at > 0 ? substr($0, 1, at - 1) ENVIRON["NEW"] substr($0, at + length(ENVIRON["TEXT"])) : $0)
	}' "$file" > "$1/$file"
	echo "$2	$3: $4 => $5	$(judge "$1" "$6")"
	cp "$file" "$1/$file"
}

worker() { # slot
	awk -v jobs="$jobs" -v slot="$1" 'NR % jobs == slot % jobs' "$folder/list" | while IFS='	' read -r number name text new tests; do
		mutate "$folder/$1" "$number" "$name" "$text" "$new" "$tests" </dev/null
	done
}

fields > "$folder/list" || exit 2
: > "$folder/verdicts"
k=1
while [ $k -le "$jobs" ]; do
	worker $k | while read -r line; do
		printf '%s\n' "$line" >> "$folder/verdicts"
		printf '%s\n' "$line" | awk -F '\t' '{ print $2 ": " $3 }'
	done &
	k=$((k + 1))
done
wait
awk -F '\t' '
	{ caught += $3 ~ /^caught by / }
	END { printf "%d mutations, %d caught, %d not\n", NR, caught, NR - caught; exit NR == 0 || caught < NR }' "$folder/verdicts"
