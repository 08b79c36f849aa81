#!/bin/sh
# usage: run.sh build-folder [configuration...]
# Builds the example for a computer, a Cortex-M4F and a 32-bit RISC-V and runs it (the boards in QEMU). The three hashes of a
# configuration must be equal. Configurations, each without the parts of the one before; without a name all of them:
#
#   whole      everything                         soft    no direct solving, sequential solver or sweep broadphase; small blocks
#   contacts   and no joints                      least   and no continuous collision
#
# Ends with one line "N passed, N failed, N skipped".
set -u
build=$1
shift
examples=$(dirname "$0")/..
cd "$examples/.."
passed=0 failed=0 skipped=0

defines_of() {
	defines=
	[ "$1" = whole ] && return
	defines='-DCN_NO_DIRECT -DCN_NO_SEQUENTIAL -DCN_NO_SWEEP -DCN_NO_AREAS -DCN_SMALL_BLOCKS'
	[ "$1" = soft ] && return
	defines="$defines -DCN_NO_JOINTS"
	[ "$1" = contacts ] && return
	defines="$defines -DCN_NO_CONTINUOUS"
}

# What no program of the configuration reaches; the linker drops the rest.
sources_of() {
	case $1 in
	whole) ls src/*/*.c ;;
	soft) ls src/*/*.c | grep -Ev '^src/(direct|linear|broadphase/sweep)' ;;
	*) ls src/*/*.c | grep -Ev '^src/(direct|linear|joints|broadphase/sweep)' ;;
	esac
}

board() { # name, compiler, emulator, flags, linker script
	board=$1 compiler=$2 emulator=$3 flags=$4 script=$5
	for tool in $compiler ${emulator%% *}; do
		command -v "$tool" >/dev/null 2>&1 && continue
		echo "$board: $tool is not installed (see .ci/deps)"
		skipped=$((skipped + 1))
		return
	done
	out=$build/$board-$configuration
	mkdir -p "$out"
	flags="$flags -std=c99 -pedantic -Wall -Wextra -Werror -Os -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -Iinclude -Isrc -Iexamples $defines"
	flags="$flags -DCN_NO_THREADS -DCN_NO_CLOCK -DCN_NO_MALLOC -DCN_NO_SIMD"
	boards=examples/embedded/board_$board.c
	link=
	if [ "$board" != host ]; then
		flags="$flags -ffreestanding -Iexamples/embedded/freestanding"
		boards="$boards examples/embedded/board_memory.c"
		link="-nostdlib -nostartfiles -L examples/embedded -T $script -lgcc"
	fi
	sources_of "$configuration" | xargs -P2 -I{} sh -c "$compiler $flags -c {} -o $out/\$(echo {} | tr / _ | sed 's/c\$/o/')" || { failed=$((failed + 1)); return; }
	# shellcheck disable=SC2086
	$compiler $flags -fno-tree-loop-distribute-patterns examples/embedded/main.c $boards "$out"/*.o -Wl,--gc-sections $link -o "$out/image" &&
		timeout 120 ${emulator:+$emulator} "$out/image" > "$out/log" 2>&1 || { echo "$board, $configuration: fails"; cat "$out/log"; failed=$((failed + 1)); return; }
	found=$(sed -n 's/^hash //p' "$out/log")
	echo "$board, $configuration: $(tr '\n' ' ' < "$out/log")"
	hash=${hash:-$found}
	if [ -n "$found" ] && [ "$found" = "$hash" ]; then passed=$((passed + 1)); else echo "$board, $configuration: another hash"; failed=$((failed + 1)); fi
}

for configuration in ${*:-whole soft contacts least}; do
	defines_of "$configuration"
	hash=
	board host gcc '' '' ''
	board cortex_m arm-none-eabi-gcc 'qemu-system-arm -M mps2-an386 -nographic -semihosting -icount shift=0 -kernel' \
		'-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16' cortex_m.ld
	board riscv riscv64-unknown-elf-gcc 'qemu-system-riscv32 -M virt -bios none -nographic -semihosting -icount shift=0 -kernel' \
		'-march=rv32imafc -misa-spec=2.2 -mabi=ilp32f -mcmodel=medany -msmall-data-limit=0' riscv.ld
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
