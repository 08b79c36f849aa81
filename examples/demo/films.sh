#!/bin/sh
# usage: films.sh build-folder output-folder [--peers]
# Films of the scenes that duel.c draws: this library's by build-folder/bin/stability, other engines' from films/ beside this script. With
# --peers, .ci/peers fetches and compiles the other engines, and they run anew: copy what they write to films/ by hand.
set -eu
cd "$(dirname "$0")/../.."
build=$1 out=$2
CC=${CC:-gcc}
. test/stability/chart/link.sh
mkdir -p "$out"

film() { # program engine
	while read -r name case; do
		"$1" "$case" --seconds 6 --film "$out/${name}_$2.film" > "$out/log" 2>&1 || [ $? = 1 ] # a bound that is broken
	done <<-SCENES
		chain 3_chain_swing_1:1000
		top 4_heavy_top_x1000
		beam 11_cantilever10_tip100
		arch 6_arch
	SCENES
}

film "$build/bin/stability" cairn
if [ "${3:-}" != --peers ]; then
	cp examples/demo/films/*.film "$out"
	exit 0
fi
CC=$CC .ci/peers "$build/peers"
if link_peer box2d gnu17; then film "$build/bin/stability_box2d" box2d; fi
if link_peer chipmunk gnu99; then film "$build/bin/stability_chipmunk" chipmunk; fi
