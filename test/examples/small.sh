#!/bin/sh
# Runs every small example (examples/*.c), compiled into the folder BUILD. Each prints its result, checks it and returns 0.
# RUNNER: an emulator. Ends with one line "N passed, N failed, N skipped".
set -u
cd "$(dirname "$0")/../.." || exit 2
passed=0 failed=0
for source in examples/*.c; do
	name=$(basename "$source" .c)
	arguments=
	[ "$name" != replay ] || arguments="-demo $BUILD/demo.rec" # records a game; test/examples/record_test.c plays recordings
	# shellcheck disable=SC2086
	if ${RUNNER:-} "$BUILD/$name" $arguments; then
		echo "ok   $name"
		passed=$((passed + 1))
	else
		echo "FAIL $name"
		failed=$((failed + 1))
	fi
done
[ $passed -gt 0 ] || failed=1
# A character on moving platforms within 100 lines, as the documentation says.
[ "$(wc -l < examples/walker.c)" -lt 100 ] || { echo "FAIL walker.c is longer than 99 lines"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed, 0 skipped"
[ $failed = 0 ]
