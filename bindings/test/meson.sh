#!/bin/sh
# usage: meson.sh build-folder folder-of-cairn.c flags, from the top folder
# Builds hinges.c against Cairn as the subproject that bindings/meson/cairn.wrap fetches from a git repository made of this tree, with
# the library's one file as its only source, which saves time.
set -eu
rm -rf "$1"
mkdir -p "$1/project/subprojects" "$1/origin/bindings" "$1/origin/src/all"
out=$(cd "$1" && pwd)
cp -R include "$out/origin"
cp "$2/cairn.c" "$out/origin/src/all"
cp -R bindings/cpp "$out/origin/bindings"
git -C "$out/origin" init -q
git -C "$out/origin" add .
git -C "$out/origin" -c user.name=test -c user.email=test@example.invalid commit -qm 'the tree under test'
cp -R bindings/meson/packagefiles "$out/project/subprojects"
sed "s|^url = .*|url = file://$out/origin|" bindings/meson/cairn.wrap > "$out/project/subprojects/cairn.wrap"
cp bindings/test/meson/meson.build bindings/test/hinges.c "$out/project"
cp -R examples/scenes "$out/project/scenes"
meson setup -Dbuildtype=plain -Dc_args="$3" "$out/build" "$out/project"
ninja -C "$out/build"
