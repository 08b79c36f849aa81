#!/bin/sh
# usage: run.sh build-folder, from the top folder; the shared library is in build-folder
# Tests the bindings: the generator, that its files are up to date, that the compiler agrees with
# api.json, and for each installed language the falling-hinges scene (its line must be the line of
# hinges.c) and the example (all must print the same). What is not installed is counted as skipped. Ends
# with one line "N passed, N failed, N skipped".
set -u
build=$1
out=$build/bindings
mkdir -p "$out"
absolute=$(cd "$build" && pwd)
passed=0 failed=0 skipped=0

export LD_LIBRARY_PATH="$build${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" DYLD_LIBRARY_PATH="$build"
export LUA_PATH='bindings/luajit/?.lua' PYTHONPATH=bindings/python PYTHONDONTWRITEBYTECODE=1
ZIG_GLOBAL_CACHE_DIR=$(cd "$out" && pwd)/zig-cache
export ZIG_GLOBAL_CACHE_DIR ZIG_LOCAL_CACHE_DIR="$ZIG_GLOBAL_CACHE_DIR/local"
unset CAIRN_LIBRARY
compiler=${CC:-cc}
guard=
command -v timeout >/dev/null 2>&1 && guard='timeout 300'

pass() { passed=$((passed + 1)); echo "PASS $1"; }
fail() { # name, file with the output
	failed=$((failed + 1))
	[ -f "$2" ] && cat "$2"
	echo "FAIL $1"
}
skip() { skipped=$((skipped + $1)); echo "SKIP $2 is not installed (see .ci/deps)"; }

check() { # name command...
	name=$1
	shift
	if $guard "$@" > "$out/log.txt" 2>&1; then pass "$name"; else fail "$name" "$out/log.txt"; fi
}

# What a command prints must be what the file holds; the first to come makes the file.
same() { # name file command...
	name=$1 expected=$2
	shift 2
	if ! $guard "$@" > "$out/log.txt" 2>&1; then
		fail "$name" "$out/log.txt"
	elif [ ! -f "$expected" ]; then
		cp "$out/log.txt" "$expected"
		pass "$name"
	elif cmp -s "$out/log.txt" "$expected"; then
		pass "$name"
	else
		diff "$expected" "$out/log.txt" > "$out/diff.txt"
		fail "$name prints something else" "$out/diff.txt"
	fi
}

# A program that ends with a line of counts.
counted() { # name command...
	name=$1
	shift
	$guard "$@" > "$out/log.txt" 2>&1
	# shellcheck disable=SC2046
	set -- $(grep -E '^[0-9]+ passed, [0-9]+ failed, 0 skipped$' "$out/log.txt" || echo "0 passed, 1 failed, 0 skipped")
	passed=$((passed + $1)) failed=$((failed + $3))
	if [ "$3" = 0 ]; then echo "PASS $name ($1)"; else grep -v '^PASS' "$out/log.txt"; fi
}

# Both programs of a language, when it was built.
both() { # language, then the command in front of a program, hinges, example
	language=$1 run=$2
	# shellcheck disable=SC2086
	same "$language hinges" "$hinges" $run "$3"
	# shellcheck disable=SC2086
	same "$language example" "$example" $run "$4"
}

hinges=$out/hinges.txt uncalled=$out/uncalled.txt example=$out/example.txt
rm -f "$hinges" "$example"
# shellcheck disable=SC2086
check "C builds" $compiler -std=c99 -O2 -ffp-contract=off -Iinclude -Iexamples bindings/test/hinges.c examples/scenes/*.c -L"$build" -lcairn -lm -o "$out/hinges"
same "C hinges" "$hinges" "$out/hinges"
[ -f "$hinges" ] && cat "$hinges"
[ -f "$hinges" ] || echo "C gave no line" > "$hinges"
sed 's/, [0-9]* called//' "$hinges" > "$uncalled" # of layers without callbacks
# For packages that compile the library from its one file: flags that take a sixth of the time; and clang takes a third of gcc's.
command -v python3 >/dev/null 2>&1 && python3 bindings/amalgamate.py "$out/source" && sh bindings/test/tree.sh "$out/tree" "$out/source"
tree="cd $absolute/bindings/tree && sh bindings/test"
quick='-O0 -DCN_NO_SIMD' quick_compiler=gcc
command -v clang-19 >/dev/null 2>&1 && quick_compiler=clang-19

if command -v python3 >/dev/null 2>&1; then
	check "files are up to date" python3 bindings/generate.py --check
	CC=$compiler check "compiler agrees with api.json" python3 bindings/generate.py --probe
	CC=$compiler counted generator python3 bindings/test/generate_test.py
	counted "NULL as in api.json" python3 bindings/test/nullable.py
	both python python3 bindings/test/hinges.py bindings/python/example.py
	same "python classes" "$hinges" python3 bindings/test/layer.py
	# The wheel as a user installs it; tcc compiles the library in half a second.
	if command -v tcc >/dev/null 2>&1 && python3 -m pip --version >/dev/null 2>&1; then
		rm -rf "$out/site"
		check "python wheel builds" env CC=tcc python3 -m pip install -q --no-deps --target "$out/site" ./bindings/python
		same "python wheel" "$hinges" env LD_LIBRARY_PATH= PYTHONPATH="$out/site" python3 bindings/test/layer.py
	else
		skip 2 'tcc or pip'
	fi
else
	skip 8 python3
fi

if command -v g++ >/dev/null 2>&1; then
	cxx="g++ -std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion -Werror -Iinclude -Ibindings/cpp"
	# shellcheck disable=SC2086
	check "cpp builds hinges" $cxx bindings/test/hinges.cpp -L"$build" -lcairn -o "$out/hinges-cpp"
	# shellcheck disable=SC2086
	check "cpp builds example without exceptions" $cxx -fno-exceptions bindings/cpp/example.cpp -L"$build" -lcairn -o "$out/example-cpp"
	both cpp '' "$out/hinges-cpp" "$out/example-cpp"
else
	skip 4 g++
fi

if command -v cargo >/dev/null 2>&1; then
	cargo_build="cargo build -q --offline --manifest-path bindings/rust/Cargo.toml --example hinges"
	export CARGO_TARGET_DIR="$absolute/bindings/rust"
	# shellcheck disable=SC2086
	check "rust builds" env CAIRN_LIBRARY_DIR="$absolute" $cargo_build
	same "rust hinges" "$uncalled" "$out/rust/debug/examples/hinges"
	# The crate that compiles the library itself.
	# shellcheck disable=SC2086
	check "rust builds with the library" env CAIRN_SOURCE_DIR="$absolute/bindings/source" CFLAGS="$quick" CC=$quick_compiler $cargo_build
	same "rust hinges with the library" "$uncalled" env LD_LIBRARY_PATH= "$out/rust/debug/examples/hinges"
else
	skip 4 cargo
fi

if command -v node >/dev/null 2>&1 && command -v clang-19 >/dev/null 2>&1 && [ -d /usr/include/wasm32-wasi ]; then
	mkdir -p "$out/javascript"
	cp bindings/javascript/* bindings/test/types.ts "$out/javascript"
	check "javascript builds" env -u CC CAIRN_SOURCE_DIR="$out/source" CFLAGS="$quick" sh "$out/javascript/build.sh"
	same "javascript hinges" "$uncalled" node bindings/test/hinges.mjs "$out/javascript"
	if command -v tsc >/dev/null 2>&1; then
		check "javascript types" tsc --strict --noEmit --target es2022 --lib es2022,dom --module nodenext --moduleResolution nodenext "$out/javascript/types.ts"
	else
		skip 1 'tsc (node-typescript)'
	fi
else
	skip 3 'node, clang-19 or wasi-libc'
fi

if command -v go >/dev/null 2>&1; then # compiles the library; Go's cache knows its flags, not files that they include
	check "go builds" env CC="$quick_compiler" CGO_CFLAGS="$quick -I$absolute/bindings/source -DCAIRN_SUM=$(cksum < "$out/source/cairn.c" | cut -d ' ' -f 1)" \
		go -C bindings/test/go build -gcflags='all=-N -l' -ldflags='-s -w' -o "$absolute/bindings/hinges-go"
	same "go hinges and package" "$uncalled" env LD_LIBRARY_PATH= "$out/hinges-go"
else
	skip 2 go
fi

if command -v luajit >/dev/null 2>&1; then
	both luajit luajit bindings/test/hinges.lua bindings/luajit/example.lua
else
	skip 2 luajit
fi

for lua in lua5.4 luajit; do # one module for both
	headers=$lua
	[ $lua = luajit ] && headers=luajit-2.1
	if command -v $lua >/dev/null 2>&1 && [ -f /usr/include/$headers/lua.h ]; then
		mkdir -p "$out/$lua"
		# shellcheck disable=SC2086
		check "$lua module builds" $compiler -std=c99 -pedantic -O1 -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Werror -fPIC -shared \
			-Iinclude -I/usr/include/$headers bindings/lua/cairn_lua.c -L"$build" -lcairn -o "$out/$lua/cairn.so"
		same "$lua module" "$hinges" env -u LUA_PATH LUA_CPATH="$out/$lua/?.so" $lua bindings/test/layer.lua
	else
		skip 2 "$lua or its headers"
	fi
done
# The rock as a user installs it, for Lua 5.4.
if command -v luarocks >/dev/null 2>&1 && [ -f /usr/include/lua5.4/lua.h ]; then
	rm -rf "$out/rocks"
	check "rock builds" env -u LUA_PATH luarocks --lua-version 5.4 --tree "$out/rocks" make bindings/lua/cairn-0.1.0-1.rockspec CC="$quick_compiler" CFLAGS="$quick -fPIC"
	same "rock" "$hinges" env -u LUA_PATH LD_LIBRARY_PATH= LUA_CPATH="$out/rocks/lib/lua/5.4/?.so" lua5.4 bindings/test/layer.lua
else
	skip 2 'luarocks or liblua5.4-dev'
fi

if command -v mcs >/dev/null 2>&1 && command -v mono >/dev/null 2>&1; then
	for program in bindings/test/hinges.cs bindings/csharp/example.cs; do
		check "csharp builds $program" mcs -unsafe -langversion:7 -warnaserror -out:"$out/$(basename "$program" .cs).exe" bindings/csharp/Cairn.cs "$program"
	done
	both csharp mono "$out/hinges.exe" "$out/example.exe"
	# The safe layer; its user is compiled without -unsafe.
	check "csharp builds the safe layer" mcs -unsafe -langversion:Latest -warnaserror -t:library -out:"$out/Cairn.dll" bindings/csharp/Cairn.cs bindings/csharp/World.cs
	check "csharp builds its user" mcs -langversion:Latest -warnaserror -r:"$out/Cairn.dll" -out:"$out/layer.exe" bindings/test/layer.cs
	same "csharp safe layer" "$hinges" mono "$out/layer.exe"
else
	skip 7 'mono (mcs and mono)'
fi

# Programs of any language are recorded by another library in the place of libcairn; a replay finds no difference.
recorded() { # language command...
	name=$1
	shift
	rm -f "$out"/game.rec*
	same "$name with the recorder" "$hinges" env CAIRN_RECORD="$out/game.rec" "$@"
	check "$name's recording replays" sh -c "grep -lq CairnRec '$out'/game.rec* && for file in '$out'/game.rec*; do '$build/bin/replay' \$file || exit 1; done"
}
recorder=$absolute/record
if command -v objcopy >/dev/null 2>&1 && [ "$(uname -s)" = Linux ]; then
	check "recording library builds" env CC="$compiler" sh bindings/record/library.sh "$build"
	if command -v python3 >/dev/null 2>&1; then recorded Python env CAIRN_LIBRARY="$recorder/libcairn.so" python3 bindings/test/layer.py; else skip 2 python3; fi
	if command -v luajit >/dev/null 2>&1; then recorded LuaJIT env CAIRN_LIBRARY="$recorder/libcairn.so" luajit bindings/test/hinges.lua; else skip 2 luajit; fi
	if command -v mono >/dev/null 2>&1; then recorded 'C#' env LD_LIBRARY_PATH="$recorder" mono "$out/hinges.exe"; else skip 2 mono; fi
else
	skip 7 'objcopy (binutils)'
fi

zig=
if command -v zig >/dev/null 2>&1; then zig=zig; elif python3 -m ziglang version >/dev/null 2>&1; then zig='python3 -m ziglang'; fi
if [ -n "$zig" ]; then
	for program in bindings/test/hinges.zig bindings/zig/example.zig; do
		# shellcheck disable=SC2086
		check "zig builds $program" $zig build-exe -lc -L"$build" -lcairn --dep cairn -Mroot="$program" -Mcairn=bindings/zig/cairn.zig \
			-femit-bin="$out/$(basename "$program" .zig)-zig"
	done
	both zig '' "$out/hinges-zig" "$out/example-zig"
	# shellcheck disable=SC2086
	check "zig builds with error unions and slices" $zig build-exe -lc -L"$build" -lcairn --dep cairn -Mroot=bindings/test/layer.zig \
		-Mcairn=bindings/zig/layer.zig -femit-bin="$out/layer-zig"
	same "zig layer" "$hinges" "$out/layer-zig"
else
	skip 6 zig
fi

if command -v pkg-config >/dev/null 2>&1 && command -v g++ >/dev/null 2>&1; then
	check "make install and uninstall" env CC=$quick_compiler CXX=g++ sh -c "$tree/install.sh '$absolute/bindings/install'"
else
	skip 1 'pkg-config or g++'
fi

if command -v cmake >/dev/null 2>&1 && command -v pkg-config >/dev/null 2>&1 && command -v g++ >/dev/null 2>&1; then
	for kind in static shared; do
		check "cmake builds and finds a $kind library" env CC=$quick_compiler CXX=g++ sh -c "$tree/cmake.sh '$absolute/bindings/cmake' $kind"
		same "cmake $kind hinges" "$hinges" env LD_LIBRARY_PATH= DYLD_LIBRARY_PATH= "$out/cmake/program-$kind/hinges"
	done
else
	skip 4 'cmake, pkg-config or g++'
fi

if command -v meson >/dev/null 2>&1 && command -v ninja >/dev/null 2>&1 && command -v git >/dev/null 2>&1; then
	check "meson builds through the wrap" env CC=$quick_compiler sh -c "$tree/meson.sh '$absolute/bindings/meson' '$quick'"
	same "meson hinges" "$hinges" env LD_LIBRARY_PATH= "$out/meson/build/hinges"
else
	skip 2 'meson, ninja or git'
fi

if command -v x86_64-w64-mingw32-gcc >/dev/null 2>&1; then
	check "Windows DLL" sh -c "$tree/dll.sh '$absolute/bindings/windows'"
	wine=$(command -v wine64 || echo /usr/lib/wine/wine64) # Debian's package puts it outside of PATH
	if command -v "$wine" >/dev/null 2>&1; then
		# Its lines end as Windows' do.
		same "Windows hinges through the DLL" "$hinges" sh -c "WINEPREFIX='$absolute/bindings/wine' WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' \
			'$wine' '$absolute/bindings/windows/hinges.exe' 2>/dev/null | tr -d '\\r'"
	else
		skip 1 wine64
	fi
else
	skip 2 'x86_64-w64-mingw32-gcc (gcc-mingw-w64-x86-64-win32)'
fi

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ]
