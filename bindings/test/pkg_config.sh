#!/bin/sh
# usage: pkg_config.sh prefix program-folder, from the top folder of the tree (tree.sh)
# Builds and runs hello.c and the program of C++'s page with what pkg-config says of the library that is installed below the prefix.
set -eu
PKG_CONFIG_PATH=$(dirname "$(find "$1" -name cairn.pc)")
export PKG_CONFIG_PATH
flags=$(pkg-config --static --cflags --libs cairn)
echo "pkg-config: $flags"
path=$(pkg-config --variable=libdir cairn)
sed -n '/^```cpp$/,/^```$/p' bindings/cpp/README.md | grep -v '^```' > "$2/page.cpp"
# shellcheck disable=SC2086
${CC:-cc} examples/hello.c $flags "-Wl,-rpath,$path" -o "$2/hello-pkg-config"
# shellcheck disable=SC2086
${CXX:-c++} -std=c++17 "$2/page.cpp" $flags "-Wl,-rpath,$path" -o "$2/page-pkg-config"
"$2/hello-pkg-config" && "$2/page-pkg-config"
