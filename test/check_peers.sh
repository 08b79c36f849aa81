#!/bin/sh
# usage: check_peers.sh        Every call of the library that the stability suite and the families make has an adapter (peer.c and the
# file of each engine), so that they link with other engines, which few machines have.
set -eu
cd "$(dirname "$0")/.."
chart=test/stability/chart
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
calls() { cat "$@" | grep -oE '\bcn_[a-z0-9_]+\(' | sort -u; }
definitions() {
	{
		grep -hE '^[a-z].*\bcn_[a-z0-9_]+\(' "$@" | grep -oE '\bcn_[a-z0-9_]+\('
		awk -F '[(,)]' '/^LACKS_JOINT\(/ { print "cn_" $2 "_def_init("; print "cn_joint_create_" $2 "(" }
			/^LACKS_CONSTRAINT\(/ { print "cn_" $2 "_constraint_def_init("; print "cn_constraint_create_" $2 "(" }' "$@"
	} | sort -u
}
wanting=0
check() { # engine files...
	engine=$1
	shift
	definitions $chart/peer.c $chart/peer_"$engine".c > "$work/defined"
	calls "$@" | comm -23 - "$work/defined" > "$work/missing"
	[ ! -s "$work/missing" ] || { echo "peer_$engine.c and peer.c lack, for $1:"; cat "$work/missing"; wanting=1; }
}
for engine in box2d chipmunk rapier; do
	# shellcheck disable=SC2046
	check $engine $(ls test/stability/*.c)
done
# shellcheck disable=SC2046
check box2d $(ls test/families/*.c | grep -v /meddle.c)
exit $wanting
