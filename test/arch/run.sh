#!/bin/sh
# usage: run.sh build-folder [configuration...]      all of them without a name
# The eight scenes of scenes.h on every processor and with every compiler: each configuration compiles the library as one file (make
# amalgamation) and hashes_test.c, and must give the golden numbers of scenes.h. Two configurations run at a time.
#
#   gcc-O0 ... clang-Os      this processor, compilers and options     scalar    without vectors; x86-64-sse2 and others: ../targets.sh
#   cortex-m4f, -m7, rv32    no operating system, in QEMU (board.c)
#
# A configuration whose compiler or emulator is missing is named and skipped. Ends with one line "N passed, N failed, N skipped",
# which counts configurations.
set -u
build=$1
shift
. test/targets.sh
options='-std=c99 -ffp-contract=off -fno-math-errno -Iinclude -Itest'

natives='gcc-O0 gcc-O1 gcc-O2 gcc-O3 gcc-Os gcc-native clang-O0 clang-O1 clang-O2 clang-O3 clang-Os clang-native scalar'
targets='x86-64-sse2 i686 aarch64 armhf riscv64 s390x wasm32 wasm32-scalar windows'
boards='cortex-m4f cortex-m7 rv32'

# ---------------------------------------------------------------- one configuration

skip() { # tool packages: ends the configuration
	echo "$name: skipped, $1 is not installed (Debian: $2)"
	exit 0
}

hosted() { # compile and run with compiler, flags, libs, runner
	# shellcheck disable=SC2086
	$compiler $options $flags "$build/amalgamation/cairn.c" test/arch/hashes_test.c $libs -o "$program" || return 1
	$runner "$program"
}

native() {
	runner= flags= libs='-lm -lpthread' packages=$1
	compiler=$1
	case $name in
	scalar) flags='-O2 -DCN_NO_SIMD' ;;
	*-native) flags='-O3 -march=native' ;;
	*) flags=-${name#*-} ;;
	esac
	if tool=$(target_lacks); then skip "$tool" "$packages"; fi
	hosted
}

# The boards of examples/embedded, with more memory.
board() { # compiler emulator flags board packages
	compiler=$1 runner=$2 flags=$3 packages=$5
	if tool=$(target_lacks); then skip "$tool" "$packages"; fi
	flags="$options $flags -O2 -ffreestanding -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns -Iexamples -Iexamples/embedded/freestanding"
	flags="$flags -DCN_NO_THREADS -DCN_NO_CLOCK -DCN_NO_MALLOC -DCN_NO_SIMD"
	# shellcheck disable=SC2086
	$compiler $flags "$build/amalgamation/cairn.c" test/arch/board.c "examples/embedded/board_$4.c" examples/embedded/board_memory.c \
		-Wl,--gc-sections -nostdlib -nostartfiles -L examples/embedded -T "test/arch/$4.ld" -lgcc -o "$program" || return 1
	$runner "$program"
}

configuration() {
	program=$build/$name.program
	case $name in
	gcc-* | scalar) native gcc ;;
	clang-*) native clang-19 ;;
	cortex-m4f | cortex-m7)
		machine=mps2-an386 processor='-mcpu=cortex-m4 -mfpu=fpv4-sp-d16'
		[ $name = cortex-m4f ] || machine=mps2-an500 processor='-mcpu=cortex-m7 -mfpu=fpv5-sp-d16'
		board arm-none-eabi-gcc "qemu-system-arm -M $machine -nographic -semihosting -kernel" "$processor -mthumb -mfloat-abi=hard" cortex_m \
			'gcc-arm-none-eabi qemu-system-arm'
		;;
	rv32)
		board riscv64-unknown-elf-gcc 'qemu-system-riscv32 -M virt -bios none -nographic -semihosting -kernel' \
			'-march=rv32imafc -misa-spec=2.2 -mabi=ilp32f -mcmodel=medany -mno-relax -msmall-data-limit=0' riscv 'gcc-riscv64-unknown-elf qemu-system-misc'
		;;
	*)
		target_of "$name" || { echo "there is no configuration $name"; return 1; }
		if tool=$(target_lacks); then skip "$tool" "$packages"; fi
		flags="$flags $defines -O2"
		[ "$name" != windows ] || export WINEPREFIX="$build/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
		hosted
		;;
	esac
}

if [ -n "${ARCH_CONFIGURATION:-}" ]; then
	name=$ARCH_CONFIGURATION
	configuration
	exit
fi

# ---------------------------------------------------------------- all

[ $# -gt 0 ] || set -- $natives $targets $boards
mkdir -p "$build" || exit 2
build=$(cd "$build" && pwd)
python3 bindings/amalgamate.py "$build/amalgamation" || exit 2
for name in "$@"; do rm -f "$build/$name.log" "$build/$name.code"; done
printf '%s\n' "$@" | SCRIPT=$0 BUILD_FOLDER=$build xargs -P "${JOBS:-2}" -n 1 sh -c '
	ARCH_CONFIGURATION=$1 timeout 900 sh "$SCRIPT" "$BUILD_FOLDER" > "$BUILD_FOLDER/$1.log" 2>&1 < /dev/null
	echo $? > "$BUILD_FOLDER/$1.code"
' sh

passed=0 failed=0 skipped=0
for name in "$@"; do
	log=$build/$name.log
	right=$(awk '/, golden / { sub(/\r$/, ""); if ($2 == $NF ",") ++n } END { print n + 0 }' "$log")
	if grep -q "^$name: skipped, " "$log"; then
		cat "$log"
		skipped=$((skipped + 1))
	elif [ "$(cat "$build/$name.code")" = 0 ] && [ "$right" = 8 ]; then
		echo "$name: 8 of 8"
		passed=$((passed + 1))
	else
		tail -n 20 "$log"
		echo "$name: $right of 8"
		failed=$((failed + 1))
	fi
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
