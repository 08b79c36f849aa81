#!/bin/sh
# usage: dll.sh build-folder, from the top folder of the tree (tree.sh)
# What make writes for Windows: cairn.dll, which exports what cairn.h declares and nothing else, and an import library that programs link.
set -eu
cross=x86_64-w64-mingw32 compiler=x86_64-w64-mingw32-gcc
# clang takes half of the time, where it finds mingw's headers (it does not behind a ccache that stands for mingw's gcc).
echo '#include <math.h>' | clang-19 --target=$cross -E -x c - >/dev/null 2>&1 && compiler="clang-19 --target=$cross"
${MAKE:-make} -s all WERROR= BUILD="$1" CC="$compiler" CFLAGS='-O0 -DCN_NO_SIMD'
$cross-objdump -p "$1/cairn.dll" | awk '/Name Pointer. Table/ { found = 1; next } found && NF == 0 { exit } found { print $NF }' | sort > "$1/exported.txt"
python3 -c 'import json; print(*sorted(f["name"] for f in json.load(open("bindings/api.json"))["functions"]), sep="\n")' > "$1/declared.txt"
diff "$1/declared.txt" "$1/exported.txt"
$compiler -DCN_SHARED -Iinclude -Iexamples bindings/test/hinges.c examples/scenes/*.c "$1/libcairn.dll.a" -o "$1/hinges.exe"
$cross-objdump -p "$1/hinges.exe" | grep 'DLL Name: cairn.dll'
