#!/bin/sh
# usage: current.sh
# One test of `make test`: the files of bindings/ are what the header says. Needs python3, else it is skipped.
if ! python3 -c '' >/dev/null 2>&1; then
	echo "SKIP python3 does not run (see .ci/deps)"
	echo "0 passed, 0 failed, 1 skipped"
elif python3 "$(dirname "$0")/../generate.py" --check; then
	echo "1 passed, 0 failed, 0 skipped"
else
	echo "FAIL bindings are not what the header says"
	echo "0 passed, 1 failed, 0 skipped"
	exit 1
fi
