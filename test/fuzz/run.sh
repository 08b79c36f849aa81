#!/bin/sh
# usage: run.sh build-folder [target...]    FUZZ_SECONDS each (default 600)
# Runs libFuzzer (clang) with the address and undefined-behaviour sanitizers on every target, or on those named, beginning with the
# inputs of corpus.txt. What it finds stays in build-folder/fuzz/<target>: inputs in corpus/, failures in failures/. A failure goes into
# corpus.txt when it is mended: (printf '<target> '; xxd -p FILE | tr -d '\n'; echo) >> test/fuzz/corpus.txt
# Ends with one line "N passed, N failed, N skipped".
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL
build=$1/fuzz
shift
seconds=${FUZZ_SECONDS:-600}
cores=$(nproc 2>/dev/null || echo 2)
compiler=${FUZZ_CC:-clang-19}
flags='-O1 -gline-tables-only -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined'
passed=0 failed=0
mkdir -p "$build"

if ! command -v "$compiler" >/dev/null 2>&1 || ! command -v python3 >/dev/null 2>&1; then
	echo "$compiler or python3 is not installed (see .ci/deps)"
	echo "0 passed, 0 failed, 1 skipped"
	exit 0
fi
# One lane at a time: the same bits, and kernels of vectors take a sanitizer minutes to compile.
${MAKE:-make} -s -j"$cores" BUILD="$build" CC="${FUZZ_CACHE:-} $compiler" CFLAGS= WERROR= TEST_CFLAGS="$flags" TEST_DEFINES='-DCNI_DEBUG -DCN_NO_SIMD' \
	"$build/libfuzz-checked.a" > "$build.log" 2>&1 || { tail -n 20 "$build.log"; echo "0 passed, 1 failed, 0 skipped"; exit 1; }

# The inputs of a target in corpus.txt as files.
seeds() { # target folder
	python3 - "$1" "$2" <<'END'
import os
import sys
with open("test/fuzz/corpus.txt") as file:
    for number, line in enumerate(file):
        name, digits = line.split()
        if name == sys.argv[1]:
            with open(os.path.join(sys.argv[2], "seed%d" % number), "wb") as seed:
                seed.write(bytes.fromhex(digits))
END
}

for target in ${*:-calls file recording geometry}; do
	folder=$build/$target
	mkdir -p "$folder/corpus" "$folder/failures"
	seeds "$target" "$folder/corpus"
	$compiler -std=c99 $flags -fsanitize=fuzzer -Iinclude -Iexamples "-DFUZZ_TARGET=fuzz_$target" test/fuzz/entry.c "$build/libfuzz-checked.a" \
		"$build/libexamples-checked.a" "$build/libcairn-checked.a" -lm -lpthread -o "$folder/fuzz" || exit 1
	largest=4096
	[ "$target" = file ] || [ "$target" = recording ] && largest=40000
	if "$folder/fuzz" -max_total_time="$seconds" -max_len=$largest -timeout=20 -rss_limit_mb=1500 -artifact_prefix="$folder/failures/" -print_final_stats=1 "$folder/corpus" > "$folder/log" 2>&1; then
		passed=$((passed + 1))
		echo "$target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log") inputs in $seconds s, nothing found"
	else
		failed=$((failed + 1))
		grep -aE -B 4 'ERROR: |runtime error|invariant broken|fuzz_.*: ' "$folder/log" | tail -n 40
		echo "$target: failed, input in $folder/failures"
	fi
done
echo "$passed passed, $failed failed, 0 skipped"
[ $failed = 0 ]
