#!/bin/sh
# usage: natives.sh, from the top folder
# Builds the libraries of the NuGet package into bindings/csharp/runtimes/RID/native, for each system whose compiler is installed, and
# prints their names. CFLAGS as in make.
set -eu
here=bindings/csharp/runtimes
native() { # RID compiler library
	command -v "$2" >/dev/null 2>&1 || { echo "$1: $2 is not installed"; return; }
	${MAKE:-make} -s all WERROR= BUILD="build/nuget/$1" CC="$2" > "build/nuget-$1.log" 2>&1 || { cat "build/nuget-$1.log"; exit 1; }
	mkdir -p "$here/$1/native"
	cp -L "build/nuget/$1/$3" "$here/$1/native/"
	echo "$here/$1/native/$3"
}
mkdir -p build
case $(uname -sm) in
'Linux x86_64') native linux-x64 gcc libcairn.so; native linux-arm64 aarch64-linux-gnu-gcc libcairn.so ;;
'Linux aarch64') native linux-arm64 gcc libcairn.so ;;
'Darwin arm64') native osx-arm64 cc libcairn.dylib ;;
'Darwin x86_64') native osx-x64 cc libcairn.dylib ;;
esac
native win-x64 x86_64-w64-mingw32-gcc cairn.dll
