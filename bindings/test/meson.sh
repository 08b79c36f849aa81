#!/bin/sh
# usage: meson.sh build-folder flags, from the top folder of the tree (tree.sh)
# Builds hinges.c against Cairn as the subproject that bindings/meson/cairn.wrap fetches from a git repository made of this tree, with
# the given flags alone. A setup without options, which builds programs for debugging, must optimise the library.
set -eu
rm -rf "$1"
mkdir -p "$1/project/subprojects" "$1/origin/bindings"
out=$(cd "$1" && pwd)
cp -R include src "$out/origin"
cp -R bindings/cpp "$out/origin/bindings"
git -C "$out/origin" init -q
git -C "$out/origin" add .
git -C "$out/origin" -c user.name=test -c user.email=test@example.invalid commit -qm 'the tree under test'
cp -R bindings/meson/packagefiles "$out/project/subprojects"
sed "s|^url = .*|url = file://$out/origin|" bindings/meson/cairn.wrap > "$out/project/subprojects/cairn.wrap"
cp bindings/test/meson/meson.build bindings/test/hinges.c "$out/project"
cp -R examples/scenes "$out/project/scenes"
meson setup -Dbuildtype=plain -Dc_args="$2" "$out/build" "$out/project"
ninja -C "$out/build"
meson setup "$out/default" "$out/project"
python3 - "$out/default/compile_commands.json" <<'END'
import json, sys
options = {entry['file'].rpartition('/')[2]: set(entry['command'].split()) for entry in json.load(open(sys.argv[1]))}
library = [name for name in options if '-DCN_BUILD' in options[name]]
optimised = [name for name in library if '-O3' in options[name]]
print('-O3 in the default setup:', len(optimised), 'of', len(library), 'files of the library')
sys.exit(not library or optimised != library)
END
