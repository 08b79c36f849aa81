#!/bin/sh
# usage: run.sh build-folder [--quick] [--rounds n] [--workers n] [--scene name]
# Fetches the engines, compiles everything with the same options - once for SSE2, once for AVX2 - and runs each
# scene in both builds in turn on one core (with several workers: on all). Writes peers.csv, peers.md and peers.svg into
# build-folder/peers, with 2 workers peers-2.csv and so on.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL # a make of its own, not a part of the one that called
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [--quick] [--rounds n] [--workers n] [--scene name]"; exit 2; }
mkdir -p "$1/peers" || exit 2
out=$(cd "$1/peers" && pwd)
shift
CC=${CC:-gcc}
strict='-std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror'
optimise='-O3 -ffp-contract=off -fno-math-errno'

quick= scene= workers=1
arguments=$*
while [ $# -gt 0 ]; do
	case $1 in
	--quick) quick=1 ;;
	--scene) shift; scene=${1:-} ;;
	--workers) shift; workers=${1:-1} ;;
	esac
	shift
done

CC=$CC .ci/peers "$out"

builds=plain
if [ "$(uname -m)" = x86_64 ]; then
	builds=sse2
	if grep -qw avx2 /proc/cpuinfo; then
		builds='sse2 avx2'
	else
		echo "peers: this processor has no AVX2: SSE2 only"
	fi
fi

has() { [ -f "$out/$1/lib$2.a" ]; }

compile() { # build options...: out/build/peers
	build=$1
	shift
	cairn=$out/$build/cairn
	"${MAKE:-make}" -s BUILD="$cairn" CC="$CC" CFLAGS="$optimise $*" "$cairn/libcairn.a" > "$out/log/cairn-$build.log" 2>&1 || { cat "$out/log/cairn-$build.log"; return 1; }
	common="$optimise $* -Iinclude -Iexamples"
	engines= libraries=
	objects=$out/$build/objects
	rm -rf "$objects" && mkdir -p "$objects"
	if has "$build" box2d; then
		engines="$engines -DPEERS_BOX2D" libraries="$libraries $out/$build/libbox2d.a"
		# shellcheck disable=SC2086
		"$CC" ${strict#-std=c99 -pedantic} -std=gnu17 $common -isystem "$out/source/box2d/include" -c examples/peers/engine_box2d.c -o "$objects/engine_box2d.o" || return 1
	fi
	if has "$build" chipmunk; then
		engines="$engines -DPEERS_CHIPMUNK" libraries="$libraries $out/$build/libchipmunk.a"
		# shellcheck disable=SC2086
		"$CC" $strict $common -isystem "$out/source/chipmunk/include" -c examples/peers/engine_chipmunk.c -o "$objects/engine_chipmunk.o" || return 1
	fi
	narrow=
	[ "$build" = sse2 ] && narrow=examples/peers/narrow.c
	for file in main world scene_list scenes_piles scenes_joints scenes_crowds engine_cairn; do
		# shellcheck disable=SC2086
		"$CC" $strict $common $engines -c "examples/peers/$file.c" -o "$objects/$file.o" || return 1
	done
	# shellcheck disable=SC2086
	"$CC" $strict $common "$objects"/*.o examples/measure/measure.c examples/measure/clock.c $narrow "$cairn/libcairn.a" $libraries \
		-lpthread -lm -o "$out/$build/peers"
}

for build in $builds; do
	option=
	[ "$build" = avx2 ] && option=-mavx2
	compile "$build" $option || { echo "peers: the $build build failed"; exit 1; }
done
# shellcheck disable=SC2086
"$CC" $strict -O2 examples/peers/report.c -lm -o "$out/report" || exit 1

# The last core: the first is the one that others are put on.
pin= clock="CPU milliseconds a step on one core"
if [ "$workers" != 1 ]; then
	clock="Milliseconds a step that pass with $workers workers"
elif command -v taskset >/dev/null 2>&1; then
	pin="taskset -c $(($(nproc) - 1))"
else
	echo "peers: taskset is not installed: times are of whatever core it runs on"
fi
[ -n "$quick" ] && echo "peers: QUICK: a quarter of the steps, fewer rounds; times and errors are not those of a whole run"

first=${builds%% *}
name_of=peers
[ "$workers" = 1 ] || name_of=peers-$workers
csv=$out/$name_of.csv
: > "$csv.new"
header=--header
for name in ${scene:-$("$out/$first/peers" "$first" --list)}; do
	for build in $builds; do
		# shellcheck disable=SC2086
		$pin "$out/$build/peers" "$build" $header $arguments --scene "$name" >> "$csv.new" || exit 1
		header=
	done
	echo "peers: $name"
done
mv "$csv.new" "$csv"
"$out/report" "$csv" "$out/$name_of.md" "$out/$name_of.svg" "$clock" ${quick:+quick}
