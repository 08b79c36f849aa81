#!/bin/sh
# usage: run.sh build-folder [--peers]      ROUNDS=n: costs are the least of so many rounds
# Draws build-folder/chart from build-folder/bin/stability. With --peers, other engines run the same suite in the
# same rounds: .ci/peers fetches and compiles them into build-folder/peers, and each is linked under the suite's objects.
set -u
cd "$(dirname "$0")/../../.." || exit 2
[ $# -ge 1 ] || { echo "usage: run.sh build-folder [--peers]"; exit 2; }
build=$1
CC=${CC:-gcc}
mkdir -p "$build/chart" || exit 2

. test/stability/chart/link.sh

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
