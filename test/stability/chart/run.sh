#!/bin/sh
# usage: run.sh build-folder [--peers]      ROUNDS=n: costs are the least of so many rounds
# Draws build-folder/chart from build-folder/bin/stability. With --peers, other engines run the same suite in the
# same rounds: .ci/peers fetches and compiles them into build-folder/peers, and each is linked under the suite's objects.
set -u
cd "$(dirname "$0")/../../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [--peers]"; exit 2; }
build=$1
CC=${CC:-gcc}
here=test/stability/chart
strict='-pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror'
optimise='-O3 -ffp-contract=off'
mkdir -p "$build/chart" || exit 2

# The widest build of an engine that this processor runs, as the library chooses at run time.
library_of() {
	for width in avx2 sse2 plain; do
		[ $width = avx2 ] && ! grep -qw avx2 /proc/cpuinfo 2>/dev/null && continue
		[ -f "$build/peers/$width/lib$1.a" ] && { echo "$build/peers/$width/lib$1.a"; return; }
	done
}

link_peer() { # engine standard
	library=$(library_of "$1")
	[ -n "$library" ] || { echo "chart: no $1 in $build/peers: drawn from peers.csv, if it is there"; return 1; }
	program=$build/bin/stability_$1
	# shellcheck disable=SC2086
	"$CC" -std=c99 $strict $optimise -Iinclude -c $here/peer.c -o "$build/chart/peer.o" &&
		"$CC" -std="$2" ${strict#-pedantic} $optimise -Iinclude -isystem "$build/peers/source/$1/include" -c "$here/peer_$1.c" -o "$build/chart/peer_$1.o" &&
		"$CC" "$build"/release/test/stability/*.o "$build/chart/peer.o" "$build/chart/peer_$1.o" "$library" -lpthread -ldl -lm -o "$program" ||
		{ echo "chart: $1 does not link under the suite"; exit 1; }
}

peers=
if [ "${2:-}" = --peers ]; then
	if [ -x .ci/peers ]; then
		CC=$CC .ci/peers "$build/peers" rapier
	else
		echo "chart: .ci/peers is not there, which fetches the other engines"
	fi
	link_peer box2d gnu17 && peers="$peers --peer box2d=$build/bin/stability_box2d"
	link_peer chipmunk gnu99 && peers="$peers --peer chipmunk=$build/bin/stability_chipmunk"
	link_peer rapier gnu99 && peers="$peers --peer rapier=$build/bin/stability_rapier"
fi
# shellcheck disable=SC2086
python3 $here/chart.py "$build/bin/stability" "$build/chart" $peers --rounds "${ROUNDS:-3}"
