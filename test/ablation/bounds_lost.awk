# usage: awk -F, -f bounds_lost.awk on.csv off.csv, of the stability suite. Bounds that hold in the first file and not in the second:
# "count|scene metric: on -> off, bound", of the bound exceeded by the largest factor.
{
	key = $1 "," $4 "," $6
	key = key "," ++times[FILENAME "," key] # cases of one name differ in their parameters
}
NR == FNR { if ($7 == 1) { held[key] = 1; value[key] = $5 } next }
{ seen[key] = 1 }
$7 == 0 && held[key] {
	++lost
	most = substr($6, 3) + 0
	beyond = $6 ~ /^</ ? (most > 0 ? $5 / most : 1e9) : ($5 > 0 ? most / $5 : 1e9)
	if ($5 ~ /nan|inf/) beyond = 1e12
	if (beyond > farthest) { farthest = beyond; worst = sprintf("`%s` %s: %.3g -> %.3g, bound %s", $1, $4, value[key], $5, $6) }
}
END {
	for (key in held) if (!(key in seen)) ++lost # refused, or given up
	printf "%d|%s\n", lost, worst
}
