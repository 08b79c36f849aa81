# test/targets.sh - other processors and systems: their compilers, and how their programs run. Sourced by cross.sh and arch/run.sh.
#
#   target_of name    sets compiler, runner, flags, defines (of tests), libs and packages (Debian's, for messages)
#   target_lacks      prints the first of the target's tools that is not installed; 1 if there is none such
#
# A target is there for:
#
#   aarch64   kernels on NEON           s390x     most significant byte first, no vectors
#   wasm32    kernels on WASM SIMD,     i686      pointers of 32 bits, kernels on SSE2
#             no threads                armhf     pointers of 32 bits, no vectors
#   wasm32-scalar  without SIMD         riscv64   no vectors, another rounding of conversions
#   x86-64-sse2    a processor          windows   long of 32 bits, another C library and threads
#                  without AVX

wasm_compiler='clang-19 --target=wasm32-wasi --sysroot=/usr -isystem /usr/include/wasm32-wasi'

target_of() {
	libs='-lm -lpthread' defines=-DTEST_EMULATED=2 flags=-static packages=qemu-user-static
	case $1 in
	aarch64) compiler=aarch64-linux-gnu-gcc runner=qemu-aarch64-static packages="$packages gcc-aarch64-linux-gnu libc6-dev-arm64-cross" ;;
	s390x) compiler=s390x-linux-gnu-gcc runner=qemu-s390x-static flags='-static -fexcess-precision=fast' packages="$packages gcc-s390x-linux-gnu libc6-dev-s390x-cross" ;;
	i686) compiler=i686-linux-gnu-gcc runner=qemu-i386-static flags='-static -msse2 -mfpmath=sse' packages="$packages gcc-i686-linux-gnu libc6-dev-i386-cross" ;;
	armhf) compiler=arm-linux-gnueabihf-gcc runner=qemu-arm-static packages="$packages gcc-arm-linux-gnueabihf libc6-dev-armhf-cross" ;;
	riscv64) compiler=riscv64-linux-gnu-gcc runner=qemu-riscv64-static packages="$packages gcc-riscv64-linux-gnu libc6-dev-riscv64-cross" ;;
	x86-64-sse2) compiler=gcc runner='qemu-x86_64-static -cpu Nehalem' ;;
	wasm32*)
		compiler=$wasm_compiler runner='node --no-warnings test/wasi.js' flags=-msimd128 defines='-DTEST_EMULATED -DCN_NO_THREADS' libs=-lm
		[ "$1" = wasm32 ] || flags=
		packages='lld-19 wasi-libc libclang-rt-19-dev-wasm32 nodejs'
		;;
	windows)
		compiler=x86_64-w64-mingw32-gcc flags='-static' libs=-lm packages='gcc-mingw-w64-x86-64-win32 wine64'
		runner=$(command -v wine64 || echo /usr/lib/wine/wine64) # Debian's package puts it outside of PATH
		;;
	*) return 1 ;;
	esac
}

target_lacks() {
	for tool in ${compiler%% *} ${runner%% *}; do
		command -v "$tool" >/dev/null 2>&1 || { echo "$tool"; return 0; }
	done
	return 1
}
