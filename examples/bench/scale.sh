#!/bin/sh
# usage: scale.sh build-folder [kind]
# Runs build-folder/bin/bench_scale, fits an exponent to each kind and draws. Writes scale.csv, exponents.csv and scale.svg into
# build-folder/scale.
#
# The exponent is the slope of log ms over log bodies by least squares, from 1,000 to 100,000 bodies; beside each row
# stands the local one, from the row before. Kinds above 1.1 are marked; times depend on the machine and what else it runs, so the exit
# code does not.
set -u
cd "$(dirname "$0")/../.." || exit 2
[ $# -ge 1 ] || { echo "usage: scale.sh build-folder [kind]"; exit 2; }
out=$1/scale
mkdir -p "$out" || exit 2

"$1/bin/bench_scale" ${2:+"$2"} > "$out/scale.csv" || exit 2

awk -F, -v fits="$out/exponents.csv" '
function close_kind() {
	if (kind == "")
		return
	exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx)
	verdict = exponent > 1.1 ? "  ABOVE 1.1" : ""
	last = last sprintf("%s: N^%.2f%s\n", kind, exponent, verdict)
	printf "%s,%.4f\n", kind, exponent > fits
}
BEGIN {
	print "kind,exponent" > fits
	printf "%-7s %8s %11s %10s %9s %7s\n", "kind", "bodies", "ms a step", "ns a body", "contacts", "local"
}
NR > 1 {
	if ($1 != kind) {
		close_kind()
		kind = $1
		n = sx = sy = sxx = sxy = before = 0
	}
	x = log($2)
	y = log($3)
	printf "%-7s %8d %11.3f %10.1f %9d %7s\n", $1, $2, $3, $4, $5, before ? sprintf("%.2f", (y - y0) / (x - x0)) : ""
	x0 = x
	y0 = y
	before = 1
	if ($2 <= 100000) {
		n += 1
		sx += x
		sy += y
		sxx += x * x
		sxy += x * y
	}
}
END {
	close_kind()
	printf "%s", last
}' "$out/scale.csv" > "$out/scale.txt"
[ $? = 0 ] || exit 2

if command -v python3 >/dev/null 2>&1; then
	python3 examples/bench/scale_plot.py "$out" || exit 2
	echo "picture: $out/scale.svg"
fi
cat "$out/scale.txt"
