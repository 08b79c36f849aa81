#!/bin/sh
# usage: tree.sh folder folder-of-cairn.c, from the top folder
# Writes a copy of the tree in which the library's one file (bindings/amalgamate.py) is the only source: the build files of CMake,
# Meson and make find it in src/*/ and compile it in a sixth of the time of all sources.
set -eu
rm -rf "$1"
mkdir -p "$1/src/all" "$1/bindings" "$1/examples"
cp "$2/cairn.c" "$1/src/all"
cp -R Makefile include "$1"
cp -R bindings/cmake bindings/cpp bindings/meson bindings/test bindings/api.json "$1/bindings"
cp -R examples/hello.c examples/scenes "$1/examples"
