#!/bin/sh
# usage: dll.sh build-folder, from the top folder
# What make writes for Windows: cairn.dll, which exports what cairn.h declares and nothing else, and an import library that programs link.
set -eu
cross=x86_64-w64-mingw32
${MAKE:-make} -s all BUILD="$1" CC=$cross-gcc CFLAGS='-O0 -DCN_NO_SIMD'
$cross-objdump -p "$1/cairn.dll" | awk '/Name Pointer. Table/ { found = 1; next } found && NF == 0 { exit } found { print $NF }' | sort > "$1/exported.txt"
python3 -c 'import json; print(*sorted(f["name"] for f in json.load(open("bindings/api.json"))["functions"]), sep="\n")' > "$1/declared.txt"
diff "$1/declared.txt" "$1/exported.txt"
$cross-gcc -DCN_SHARED -Iinclude -Iexamples bindings/test/hinges.c examples/scenes/*.c "$1/libcairn.dll.a" -o "$1/hinges.exe"
$cross-objdump -p "$1/hinges.exe" | grep 'DLL Name: cairn.dll'
