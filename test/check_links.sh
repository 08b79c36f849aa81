#!/bin/sh
# usage: check_links.sh
# Checks the documentation: every link in a page of this repository names a file that exists and, behind a #, a heading of
# that page; every target of `make` in a page exists. Links to the network are skipped. A heading's anchor is its text in
# lower case, with - for spaces and without other punctuation.
set -u
cd "$(dirname "$0")/.." || exit 2
pages=$(find . -name '*.md' ! -path './build/*' ! -path './.git/*' | sort)
status=0

anchors() { # page
	awk '/^```/ { code = !code } !code && /^#+ / { sub(/^#+ /, ""); print }' "$1" | tr '[:upper:]' '[:lower:]' | sed "s/[^a-z0-9 _-]//g; s/ /-/g"
}

count=0
for page in $pages; do
	# Links outside of code, one a line.
	links=$(awk '/^```/ { code = !code } !code' "$page" | sed 's/`[^`]*`//g' | grep -oE '\]\([^) ]+\)' | sed 's/^](//; s/)$//')
	for link in $links; do
		case $link in http://* | https://* | mailto:*) continue ;; esac
		count=$((count + 1))
		file=${link%%#*}
		target=$page
		[ -z "$file" ] || target=$(dirname "$page")/$file
		if [ ! -e "$target" ]; then
			echo "$page: no file $link"
			status=1
			continue
		fi
		case $link in
			*'#'*)
				if ! anchors "$target" | grep -qxF -- "${link#*#}"; then
					echo "$page: no heading $link"
					status=1
				fi
				;;
		esac
	done
	for goal in $(grep -oE '(^|`)make [a-z][a-z-]*' "$page" | sed 's/.*make //' | sort -u); do
		if ! grep -qE "^([a-z-]+ )*$goal( [a-z-]+)*:" Makefile; then
			echo "$page: Makefile has no target $goal"
			status=1
		fi
	done
done
[ "$count" -gt 0 ] || { echo "no links found"; status=1; }
[ $status = 0 ] && echo "links: $count, good"
exit $status
