#!/bin/sh
# usage: testbed_web.sh build-folder
# The testbed in a real browser without a window (Chromium): events of pointer and keyboard, and the same hashes as in a native run.
# build-folder/testbed-web.png is a picture of it. Ends with one line "N passed, N failed, N skipped".
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$1
browser=
for name in chromium chromium-browser google-chrome; do
	command -v $name >/dev/null 2>&1 && { browser=$name; break; }
done
skip() { echo "testbed in a browser: $1 is not installed"; echo "0 passed, 0 failed, 1 skipped"; exit 0; }
[ -n "$browser" ] || skip chromium
command -v clang-19 >/dev/null 2>&1 || skip clang-19
command -v python3 >/dev/null 2>&1 || skip python3
${MAKE:-make} -s testbed-web-files "$build/test/examples/testbed_test" BUILD="$build" || { echo "0 passed, 1 failed, 0 skipped"; exit 1; }

folder=$build/testbed-test
mkdir -p "$folder"
cp "$build"/testbed/* test/examples/testbed_web.js "$folder/"
sed 's|</html>|<script src="testbed_web.js"></script></html>|' "$folder/index.html" > "$folder/test.html"
"$build/test/examples/testbed_test" t_browser | grep -E '^[a-z]+ [0-9a-f]{16}$' > "$folder/native.txt"

rm -f "$folder/server.log" && : > "$folder/server.log"
python3 -u -m http.server --bind 127.0.0.1 0 --directory "$folder" > "$folder/server.log" 2>&1 &
server=$!
trap 'kill $server 2>/dev/null' EXIT
for _ in 1 2 3 4 5 6 7 8 9 10; do
	port=$(sed -n 's/.* port \([0-9]*\).*/\1/p' "$folder/server.log")
	[ -n "$port" ] && break
	sleep 0.3
done
run_browser() { # arguments...
	timeout 120 "$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1280,760 --virtual-time-budget=60000 \
		--user-data-dir="$folder/profile" "$@" 2> "$folder/browser.log"
}
run_browser --dump-dom "http://127.0.0.1:$port/test.html" | sed 's/<[^>]*>//g' | grep -E '^[a-z_]+ ' > "$folder/web.txt"
run_browser --screenshot="$build/testbed-web.png" "http://127.0.0.1:$port/?scene=machines" > /dev/null

passed=0 failed=0
expect() { # line
	if grep -qxF -- "$1" "$folder/web.txt"; then
		echo "ok   $1"
		passed=$((passed + 1))
	else
		echo "FAIL expected: $1; the browser says: $(grep "^${1%% *} " "$folder/web.txt" || echo nothing)"
		failed=$((failed + 1))
	fi
}
while read -r line; do expect "$line"; done < "$folder/native.txt"
expect 'paused_steps 60'
expect 'drawn yes'
expect 'end good'
grep '^error' "$folder/web.txt"
[ "$passed" -ge 8 ] || failed=$((failed + 1))
echo "$passed passed, $failed failed, 0 skipped"
[ $failed = 0 ]
