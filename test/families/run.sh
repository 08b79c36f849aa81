#!/bin/sh
# usage: run.sh build-folder [--peers] [options of build-folder/bin/families]
# With --peers, Box2D runs the same seeds first: the suite's objects are linked with the adapter of test/stability/chart
# and the library that .ci/peers compiled into build-folder/peers.
set -u
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [--peers] [options]"; exit 2; }
build=$1
shift
CC=${CC:-gcc}
chart=test/stability/chart
strict='-Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror'
optimise='-O3 -ffp-contract=off'

if [ "${1:-}" != --peers ]; then
	exec "$build/bin/families" --csv "$build/families.csv" "$@"
fi
shift
[ -d "$build/peers/source/box2d" ] || { [ -x .ci/peers ] && CC=$CC .ci/peers "$build/peers"; }
library=
for width in plain sse2 avx2; do
	[ $width = avx2 ] && ! grep -qw avx2 /proc/cpuinfo 2>/dev/null && continue
	[ -f "$build/peers/$width/libbox2d.a" ] && library=$build/peers/$width/libbox2d.a
done
[ -n "$library" ] || { echo "families: no Box2D in $build/peers"; exit 2; }
mkdir -p "$build/families"
# shellcheck disable=SC2086
$CC -std=c99 $strict $optimise -Iinclude -c $chart/peer.c -o "$build/families/peer.o" &&
	$CC -std=gnu17 $strict $optimise -Iinclude -isystem "$build/peers/source/box2d/include" -c $chart/peer_box2d.c -o "$build/families/peer_box2d.o" &&
	$CC -std=c99 $strict $optimise -Iinclude -c test/families/peer/meddle.c -o "$build/families/peer_meddle.o" &&
	$CC $(ls "$build"/release/test/families/*.o | grep -v /meddle.o) "$build/families/peer_meddle.o" "$build/families/peer.o" "$build/families/peer_box2d.o" "$library" -lpthread -ldl -lm -o "$build/bin/families_box2d" ||
	exit 2
"$build/bin/families_box2d" "$@" --solvers auto --record "$build/families_box2d.csv" || exit 2
exec "$build/bin/families" --csv "$build/families.csv" --peer "Box2D=$build/families_box2d.csv" "$@"
