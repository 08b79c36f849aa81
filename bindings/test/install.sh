#!/bin/sh
# usage: install.sh build-folder, from the top folder of the tree (tree.sh)
# make install, with LIBDIR outside of the prefix: programs find the library by pkg-config, and make uninstall leaves no file.
set -eu
rm -rf "$1/prefix" "$1/libraries"
mkdir -p "$1"
out=$(cd "$1" && pwd)
run() { ${MAKE:-make} -s "$1" WERROR= BUILD="$out" CC="${CC:-cc}" CFLAGS='-O0 -DCN_NO_SIMD' PREFIX="$out/prefix" LIBDIR="$out/libraries" DESTDIR=; }
run install
sh bindings/test/pkg_config.sh "$out" "$out"
run uninstall
left=$(find "$out/prefix" "$out/libraries" ! -type d)
echo "left by make uninstall: ${left:-nothing}"
[ -z "$left" ]
