#!/bin/sh
# usage: work.sh build-folder
# Bounds on work, as instructions executed (valgrind), which are the same on a busy machine: of the functions of
# test/world/growth_time_test.c and read_time_test.c, in the build folder. Ends with one line "N passed, N failed, N skipped".
set -u
folder=$1/test/world
passed=0 failed=0
command -v valgrind >/dev/null 2>&1 || { echo "valgrind is not installed (see .ci/deps)"; echo "0 passed, 0 failed, 13 skipped"; exit 0; }

instructions() { # function [program]
	valgrind --tool=callgrind --callgrind-out-file=/dev/null "$folder/${2:-growth}_time_test" "$1" 2>&1 |
		awk '/^1 passed, 0 failed/ { good = 1 } /Collected *:/ { count = $NF } END { print good ? count : 0 }'
}

bound() { # what value bound
	if awk -v value="$2" -v bound="$3" 'BEGIN { exit !(value > 0 && value <= bound) }'; then
		passed=$((passed + 1))
		echo "ok   $1: $2, bound <= $3"
	else
		failed=$((failed + 1))
		echo "FAIL $1: $2, bound <= $3"
	fi
}

growth() { # what function function_of_eight_times_the_size
	few=$(instructions "$2")
	many=$(instructions "$3")
	bound "eight times the $1, times the instructions" "$(awk -v a="$many" -v b="$few" 'BEGIN { print (b > 0 ? a / b : 0) }')" 12
}

growth "tiles" level_of_1000_tiles level_of_8000_tiles
growth "shapes of a moving body" compound_of_500_shapes compound_of_4000_shapes
growth "shapes changed and removed" changed_500_shapes changed_4000_shapes
growth "bodies and joints destroyed" bodies_gone_1000 bodies_gone_8000
growth "points of a moved chain, sweep" chain_moved_6000_sweep chain_moved_48000_sweep
growth "points of a moved chain, tree" chain_moved_6000_tree chain_moved_48000_tree
asleep=$(($(instructions sleepers_stepped) - $(instructions sleepers_made)))
empty=$(($(instructions empty_stepped) - $(instructions empty_made)))
bound "a step with 2,000 bodies asleep over an empty step" "$(awk -v a="$asleep" -v b="$empty" 'BEGIN { print (b > 0 ? a / b : 0) }')" 2
bound "an empty step, instructions" "$(awk -v steps="$empty" 'BEGIN { print steps / 200 }')" 3000
bound "steps 6 to 20 of a long bridge over the first five, instructions a step" "$(awk -v a="$(instructions bridge_falls_for_20_steps)" -v b="$(instructions bridge_falls_for_5_steps)" \
	'BEGIN { print (b > 0 ? (a - b) / 3 / b : 0) }')" 2
# Each reads 10,000 bodies 100 times.
nothing=$(instructions nothing_read read)
per_body() { # function without_it
	awk -v a="$(instructions "$1" read)" -v b="$2" 'BEGIN { print (b > 0 ? (a - b) / 1e6 : 0) }'
}
bound "all poses, instructions a body" "$(per_body all_read "$nothing")" 20
bound "poses by handle, instructions a body" "$(per_body listed_read "$nothing")" 45
bound "a getter each, instructions a body" "$(per_body each_read "$nothing")" 90
bound "moved bodies, instructions a body" "$(per_body moved_read "$(instructions unread_stepped read)")" 40
echo "$passed passed, $failed failed, 0 skipped"
[ $failed = 0 ]
