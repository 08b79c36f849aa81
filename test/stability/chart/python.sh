#!/bin/sh
# For make bench-scale: prints a python3 that has matplotlib: Debian puts it under its own python3, which need not be the first in PATH.
for candidate in python3 /usr/bin/python3; do
	"$candidate" -c 'import matplotlib' 2>/dev/null && { echo "$candidate"; exit 0; }
done
echo "no python3 here has matplotlib (Debian: python3-matplotlib)" >&2
exit 2
