#!/bin/sh
# usage: cmake.sh build-folder static|shared, from the top folder of the tree (tree.sh)
# Builds hello.c, hinges.c and the program of C++'s page against the CMake package, in build-folder/program-KIND, and runs hello and the
# page's; then both with pkg-config's flags. static: first with the library's sources as a subdirectory, then against what that build
# installed. shared: against the library that bindings/cmake/README.md's commands build and install, without threads and vectors, which
# must give the same bits. -O0 and no vectors save time.
set -eu
mkdir -p "$1"
out=$(cd "$1" && pwd) kind=$2
program=$out/program-$kind prefix=$out/installed-$kind
unset LD_LIBRARY_PATH DYLD_LIBRARY_PATH # the library under test is the one in the prefix
rm -rf "$prefix" "$program" # a package of an earlier run would be found, too
cores=$(nproc 2>/dev/null || echo 2)
case $kind in
	static)
		cmake -S bindings/test/cmake -B "$out/static" -DCAIRN_FROM_SOURCE=ON -DCAIRN_NO_SIMD=ON -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE=-O0
		cmake --build "$out/static" --parallel "$cores"
		"$out/static/hello"
		cmake --install "$out/static" --prefix "$prefix"
		;;
	shared)
		cmake -S bindings/cmake -B "$out/shared" -DBUILD_SHARED_LIBS=ON -DCAIRN_NO_THREADS=ON -DCAIRN_NO_SIMD=ON -DCMAKE_C_FLAGS_RELEASE=-O0
		cmake --build "$out/shared" --parallel "$cores"
		cmake --install "$out/shared" --prefix "$prefix"
		;;
esac
cmake -S bindings/test/cmake -B "$program" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE=-O0
grep "^cairn_DIR:PATH=$prefix/" "$program/CMakeCache.txt"
cmake --build "$program" --parallel "$cores"
"$program/hello"
"$program/page"
sh bindings/test/pkg_config.sh "$prefix" "$program"
