# test/stability/chart/link.sh - links other engines under the objects of the stability suite. Sourced by run.sh and examples/demo/films.sh,
# from the top folder, with build and CC set.
#
#   link_peer engine standard     writes build/bin/stability_<engine> from build/peers (.ci/peers); 1 if that has no such engine

here=test/stability/chart
strict='-pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror'
optimise='-O3 -ffp-contract=off'

# The widest build of an engine that this processor runs, as the library chooses at run time.
library_of() {
	for width in avx2 sse2 plain; do
		[ $width = avx2 ] && ! grep -qw avx2 /proc/cpuinfo 2>/dev/null && continue
		[ -f "$build/peers/$width/lib$1.a" ] && { echo "$build/peers/$width/lib$1.a"; return; }
	done
}

link_peer() { # engine standard
	library=$(library_of "$1")
	[ -n "$library" ] || { echo "$1 is not in $build/peers"; return 1; }
	program=$build/bin/stability_$1
	mkdir -p "$build/chart" "$build/bin"
	# shellcheck disable=SC2086
	"$CC" -std=c99 $strict $optimise -Iinclude -c $here/peer.c -o "$build/chart/peer.o" &&
		"$CC" -std="$2" ${strict#-pedantic} $optimise -Iinclude -isystem "$build/peers/source/$1/include" -c "$here/peer_$1.c" -o "$build/chart/peer_$1.o" &&
		"$CC" "$build"/release/test/stability/*.o "$build/chart/peer.o" "$build/chart/peer_$1.o" "$library" -lpthread -ldl -lm -o "$program" ||
		{ echo "$1 does not link under the suite"; exit 1; }
}
