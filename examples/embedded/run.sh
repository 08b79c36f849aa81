#!/bin/sh
# usage: run.sh build-folder [configuration...]
# Builds the example for a computer, a Cortex-M4F and a 32-bit RISC-V and runs it (the boards in QEMU). The three hashes of a
# configuration must be equal. Configurations, each without the parts of the one before; without a name all of them:
#
#   whole      everything                         soft    no direct solving, sequential solver or sweep broadphase; small blocks
#   contacts   and no joints                      least   and no continuous collision, events, restitution, chains, circles, messages
#   plain      and the step of a textbook engine (CN_PLAIN_STEP), optimised when it is linked (-flto)
#
# Checks the bounds on flash, RAM and stack of `plain` and `least` on the boards (see bounds). The library is compiled without unused parts by
# definitions.sh, which sizes.sh uses too.
# Ends with one line "N passed, N failed, N skipped".
set -u
build=$1
shift
examples=$(dirname "$0")/..
cd "$examples/.."
passed=0 failed=0 skipped=0

. examples/embedded/definitions.sh

defines_of() {
	case $1 in
	whole) defines= ;;
	soft) defines=$without_solvers ;;
	contacts) defines="$without_solvers $without_joints" ;;
	least) defines="$without_solvers $without_joints $without_rest" ;;
	*) defines="$without_solvers $without_joints $without_rest $without_refinements" ;;
	esac
}

# Bytes of flash, RAM and stack that a configuration may take: 64 KiB, 64 KiB and 4 KiB are what a world of 50 boxes is to need on a
# Cortex-M4F, and `plain` does.
bounds() {
	case $1-$configuration in
	cortex_m-plain) echo 65536 65536 4096 ;;
	riscv-plain) echo 77824 65536 4096 ;;
	cortex_m-least) echo 86016 65536 4096 ;;
	riscv-least) echo 98304 65536 4096 ;;
	esac
}

number() { sed -n "s/^$1 //p" "$out/log"; }

within() { # what bound
	if [ "$(number "$1")" -le "$2" ]; then passed=$((passed + 1)); else echo "$board, $configuration: $1 $(number "$1"), bound <= $2"; failed=$((failed + 1)); fi
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
	optimization=-Os # of a host the hash counts alone: no bounds on its size, and no -flto
	[ "$board" != host ] || optimization=-O1
	flags="$flags -std=c99 -pedantic -Wall -Wextra -Werror $optimization -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -Iinclude -Isrc -Iexamples $defines"
	flags="$flags $bare_metal"
	[ "$configuration" = plain ] && [ "$board" != host ] && flags="$flags -flto -flto-partition=one"
	boards=board_$board link=
	if [ "$board" != host ]; then
		flags="$flags -ffreestanding -Iexamples/embedded/freestanding"
		boards="$boards board_memory"
		link="-nostdlib -nostartfiles -L examples/embedded -T $script -lgcc"
	fi
	sources_of "$configuration" | xargs -P2 -I{} sh -c "$compiler $flags -c {} -o $out/\$(echo {} | tr / _ | sed 's/c\$/o/')" || { failed=$((failed + 1)); return; }
	# start-up code and functions that the compiler adds calls of are not optimised with the rest
	for name in $boards; do
		# shellcheck disable=SC2086
		$compiler $flags -fno-lto -fno-tree-loop-distribute-patterns -c "examples/embedded/$name.c" -o "$out/$name.o" || { failed=$((failed + 1)); return; }
	done
	# shellcheck disable=SC2086
	$compiler $flags examples/embedded/main.c "$out"/*.o -Wl,--gc-sections $link -o "$out/image" &&
		timeout 120 ${emulator:+$emulator} "$out/image" > "$out/log" 2>&1 || { echo "$board, $configuration: fails"; cat "$out/log"; failed=$((failed + 1)); return; }
	found=$(sed -n 's/^hash //p' "$out/log")
	echo "$board, $configuration: $(tr '\n' ' ' < "$out/log")"
	hash=${hash:-$found}
	if [ -n "$found" ] && [ "$found" = "$hash" ]; then passed=$((passed + 1)); else echo "$board, $configuration: another hash"; failed=$((failed + 1)); fi
	# shellcheck disable=SC2046
	set -- $(bounds "$board")
	[ $# -gt 0 ] || return 0
	within "flash bytes" "$1"
	within "bytes needed" "$2"
	within "stack bytes" "$3"
}

for configuration in ${*:-whole soft contacts least plain}; do
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
