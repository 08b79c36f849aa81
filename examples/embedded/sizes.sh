#!/bin/sh
# usage: sizes.sh build-folder
# Prints a table of the bytes of code that each part of the library takes, for a Cortex-M4F and for x86-64, both with gcc -Os: what the
# image of the example (main.c, configuration least of run.sh) is larger with the part than without it. A part is a definition less, or
# functions more that a program calls. Then the code of the whole library for x86-64. Six minutes of processor time.
set -u
build=$1
cd "$(dirname "$0")/../.."
. examples/embedded/definitions.sh
least="$bare_metal $without_solvers $without_joints $without_rest"
common='-std=c99 -Os -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -Iinclude -Isrc -Iexamples'
cortex='-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -ffreestanding -Iexamples/embedded/freestanding'

compile() { # folder compiler flags...: all of src/
	folder=$1
	shift
	rm -rf "$folder"
	mkdir -p "$folder"
	ls src/*/*.c | xargs -P2 -I{} sh -c "$* -c {} -o $folder/\$(echo {} | tr / _ | sed 's/c\$/o/')"
}

code_of() { # size-program file: bytes of code and constants
	"$1" -A "$2" | awk '/^\.(text|rodata|data\.rel\.ro|init_array|ARM\.exidx)/ { sum += $2 } END { print sum }'
}

image() { # target folder definitions linker-options...: prints the bytes of the linked example
	target=$1 folder=$2 definitions=$3
	shift 3
	case $target in
	cortex)
		arm-none-eabi-gcc $common $cortex $definitions -fno-tree-loop-distribute-patterns examples/embedded/main.c examples/embedded/board_cortex_m.c \
			examples/embedded/board_memory.c "$folder"/*.o "$@" -Wl,--gc-sections -nostdlib -nostartfiles -L examples/embedded -T cortex_m.ld -lgcc -o "$folder/image" &&
			code_of arm-none-eabi-size "$folder/image" ;;
	*)
		gcc $common $definitions examples/embedded/main.c examples/embedded/board_host.c "$folder"/*.o "$@" -Wl,--gc-sections -o "$folder/image" &&
			code_of size "$folder/image" ;;
	esac
}

compiler_of() { if [ "$1" = cortex ]; then echo "arm-none-eabi-gcc $common $cortex"; else echo "gcc $common"; fi; }

roots() { for function in $1; do printf ' -Wl,-u,%s' "$function"; done; }

row() { # text functions...
	text=$1
	shift
	printf '| %s |' "$text"
	for target in cortex x86; do
		eval "base=\$base_$target"
		# shellcheck disable=SC2046
		with=$(image $target "$build/$target-least" "$least" $(roots "$*"))
		printf ' %s |' $((with - base))
	done
	echo
}

part() { # text definition: without this definition
	printf '| %s (without `%s`) |' "$1" "$2"
	definitions=$(echo "$least" | sed "s/-D$2\\b//")
	for target in cortex x86; do
		eval "base=\$base_$target"
		compile "$build/$target-part" "$(compiler_of $target)" "$definitions"
		with=$(image $target "$build/$target-part" "$definitions")
		printf ' %s |' $((with - base))
	done
	echo
}

for target in cortex x86; do
	compile "$build/$target-least" "$(compiler_of $target)" "$least" || exit 1
	eval "base_$target=$(image $target "$build/$target-least" "$least")"
done
echo '| part | Cortex-M4F | x86-64 |'
echo '|---|---|---|'
echo "| 50 boxes, \`CN_SOLVER_SOFT\`, all definitions | $base_cortex | $base_x86 |"
part 'exact joints and piles' CN_NO_DIRECT
part 'sequential solver' CN_NO_SEQUENTIAL
part 'sweep-and-prune beside the tree' CN_NO_SWEEP
part 'joints and constraints, all types' CN_NO_JOINTS
part 'continuous collision' CN_NO_CONTINUOUS
part 'events, sensors, callbacks' CN_NO_EVENTS
part 'areas, without events' CN_NO_AREAS
part 'restitution' CN_NO_RESTITUTION
part 'chains' CN_NO_CHAINS
part 'circles' CN_NO_CIRCLES
part 'sentences about errors' CN_NO_MESSAGES
row '`cn_world_cast_ray`' cn_world_cast_ray
row 'all rays and shape casts' cn_world_cast_ray cn_world_cast_ray_all cn_world_cast_ray_any cn_world_cast_rays cn_world_cast_shape
row 'overlaps, closest point' cn_world_overlap_aabb cn_world_overlap_point cn_world_overlap_circle cn_world_overlap_polygon cn_world_closest_point
row 'two shapes without a world' cn_polygon_distance cn_polygon_collide cn_polygon_cast cn_polygon_time_of_impact
row 'character mover' cn_mover_move
row 'explosions' cn_world_explode
row 'convex hulls' cn_polygon_make_hull
row 'outlines into convex pieces' cn_outline_decompose cn_outline_simplify
row 'destroying bodies and shapes' cn_body_destroy cn_shape_destroy
row 'pose, velocity, forces of bodies' cn_body_set_pose cn_body_set_velocity cn_body_apply_force cn_body_apply_impulse cn_body_get_pose
row 'variable time, interpolation' cn_world_update
row 'saving and restoring' cn_world_save cn_world_restore
row 'files' cn_world_write cn_world_read
row 'debug draw' cn_world_draw
row 'checks of every invariant' cn_world_validate
row '`cn_tree`' cn_tree_create cn_tree_insert cn_tree_move cn_tree_remove cn_tree_query cn_tree_cast_ray
echo
for simd in -DCN_NO_SIMD ''; do
	compile "$build/x86-whole" gcc "$common" "$simd"
	size -A "$build"/x86-whole/*.o | awk -v simd="${simd:-with kernels for all vectors}" \
		'/^\.text/ { text += $2 } /^\.rodata/ { data += $2 } END { printf "Whole library for x86-64, %s: %d bytes of code, %d of constants.\n", simd, text, data }'
done
