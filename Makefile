# Cairn - build with only gcc (or clang) and make.
#
#   make            static and shared library          make demo       run the demo, pictures in build/demo
#   make test       every test, checked build          make bench      CSV of all benchmark scenes (SCENE=name: one)
#   make hello      the program of the README          make platformer a character in a level: build/platformer.png
#   make test-all   tests under sanitizers and other   make check-deps layers, circles, longest files
#                   compilers and options              make check-links links and make targets in the documentation
#   make test-times times of parts, printed             make readme     runs the commands of every README
#   make install    DESTDIR, PREFIX and LIBDIR; make uninstall; make clean
#   make bindings   writes bindings/ from the header   make test-bindings  in every language that is installed
#   make amalgamation  the library as two files, build/amalgamation/cairn.c and cairn.h
#   make stability  scenes with bounds, and 10 seeds of each family: test/stability/README.md
#   make fuzz       libFuzzer on calls, files, recordings and geometry, FUZZ_SECONDS each: test/README.md
#   make soak       the suite in its long form, and long tests under load
#   make coverage   lines and branches of src/ that the tests run     make lint  clang-tidy, cppcheck, gcc -fanalyzer
#   make test-arch  the same numbers from every compiler and processor that is installed: test/arch
#   make mutation   small faults that tests must catch: test/README.md
#   make families   random scenes, the default solver beside soft constraints: test/families/README.md
#   make bench-peers  time and accuracy beside other engines: see examples/peers/README.md
#   make bench-diff BASE=rev  time and accuracy beside another revision: see examples/README.md
#   make bench-scale  how cost grows with the number of bodies: see examples/README.md
#   make schedule   1 to 64 workers, simulated, and what stays serial: test/schedule/main.c
#   make ablation   each mechanism switched off alone: bounds lost, seeds worse, time: test/ablation/README.md
#   make tuning     each tuning constant of the solver times 0.7 and 1.4: bounds lost: test/tuning/README.md
#   make feature-cost  what each feature costs a step, used and unused: see examples/README.md
#   make embedded   50 boxes on a Cortex-M4F and a 32-bit RISC-V, in emulators: examples/embedded
#   make sizes      bytes of code of each part of the library, for a Cortex-M4F and x86-64; six minutes
#   make testbed    scenes to play with, in a window; make testbed-web in a browser: examples/testbed/README.md
#   make docs       the documentation as a site: build/docs/index.html
#   make rollback   inputs that arrive late: examples/rollback.c    make examples   every small example
#   make replay     a recorded game, played and drawn: examples/replay.c
#
# CC, AR, CFLAGS, LDFLAGS and BUILD (output folder) are honoured; WERROR= turns off -Werror; V=1 shows
# commands.

BUILD ?= build
PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
WERROR ?= -Werror
ifeq ($(origin CC),default)
CC := gcc
endif
# Tests take the user's CFLAGS if there are any, else a build that compiles soon (TEST_CFLAGS='-O0 -g': for a debugger).
# OWN_CFLAGS: for the tests and the examples that they use, whose compilation takes 0.4 of the time without optimization.
ifndef TEST_CFLAGS
TEST_CFLAGS := $(if $(CFLAGS),$(CFLAGS),-O2)
OWN_CFLAGS := $(if $(CFLAGS),,-O0)
endif
TEST_DEFINES ?= -DCNI_DEBUG
CFLAGS ?= -O3
# Builds and tests use every processor; `make -j1` and JOBS=1 use one.
CPUS := $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
JOBS ?= $(CPUS)
ifeq ($(MAKELEVEL)$(filter -j%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(CPUS)
endif
say = $(if $(V),,@echo '$(1)' $(patsubst $(BUILD)/%,%,$@);)

STRICT := -std=c99 -pedantic -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion $(WERROR)
MODE := -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -fvisibility=hidden -MMD -MP
LIB_FLAGS = $(STRICT) $(MODE) -Iinclude -Isrc -DCN_BUILD $(if $(WINDOWS),-DCN_SHARED,-fPIC)
EXAMPLE_FLAGS = $(STRICT) $(MODE) -Iinclude -Iexamples
TEST_FLAGS = $(STRICT) $(MODE) -Iinclude -Isrc -Itest -Iexamples

VERSION := $(shell awk '/define CN_VERSION_(MAJOR|MINOR|PATCH)/ { printf "%s%s", dot, $$3; dot = "." }' include/cairn.h)
SOVERSION := $(firstword $(subst ., ,$(VERSION)))
ifeq ($(shell uname -s),Darwin)
SHARED := libcairn.$(SOVERSION).dylib
SHARED_LINK := libcairn.dylib
SHARED_FLAGS := -dynamiclib -install_name $(LIBDIR)/$(SHARED)
STRIP_UNUSED := -Wl,-dead_strip
else ifneq (,$(findstring mingw,$(CC))$(filter Windows_NT,$(OS)))
# The DLL, its import library, and nothing exported but what cairn.h declares.
WINDOWS := 1
SHARED := cairn.dll
SHARED_LINK := libcairn.dll.a
SHARED_FLAGS = -shared -static-libgcc -Wl,--out-implib,$(BUILD)/$(SHARED_LINK)
STRIP_UNUSED := -Wl,--gc-sections
else
SHARED := libcairn.so.$(SOVERSION)
SHARED_LINK := libcairn.so
SHARED_FLAGS := -shared -Wl,-soname,$(SHARED)
STRIP_UNUSED := -Wl,--gc-sections
endif
# What a program that holds the library is linked with; threads are a part of Windows.
LIBS := -lm $(if $(WINDOWS),,-lpthread)

# The one example that looks inside of the library.
%/examples/bench/broadphase.o: EXAMPLE_FLAGS += -Isrc

# New files are found by themselves.
LIB_SRC := $(sort $(wildcard src/*/*.c))
SMALL_SRC := $(sort $(wildcard examples/*.c))
MAIN_SRC := $(SMALL_SRC) examples/demo/demo.c examples/bench/bench.c examples/bench/once.c examples/bench/scale.c examples/cost/cost.c
EXAMPLE_SRC := $(filter-out $(MAIN_SRC) examples/peers/% examples/embedded/%,$(sort $(wildcard examples/*/*.c)))
TEST_SRC := $(sort $(wildcard test/*/*_test.c))

LIB_OBJ := $(LIB_SRC:%.c=$(BUILD)/release/%.o)
EXAMPLE_OBJ := $(EXAMPLE_SRC:%.c=$(BUILD)/release/%.o)
MAIN_OBJ := $(MAIN_SRC:%.c=$(BUILD)/release/%.o)
# AMALGAMATED=build/amalgamation/cairn.c: tests of the library as one file, which compiles in half the time of all its files.
CHECKED_OBJ := $(if $(AMALGAMATED),$(BUILD)/checked/cairn.o,$(LIB_SRC:%.c=$(BUILD)/checked/%.o))
CHECKED_EXAMPLE_OBJ := $(EXAMPLE_SRC:%.c=$(BUILD)/checked/%.o)
TEST_OBJ := $(TEST_SRC:%.c=$(BUILD)/checked/%.o)
# Those that only print times are not among them: make test-times.
TIMES_SRC := $(sort $(wildcard test/*/*_time_test.c))
TESTS := $(patsubst %.c,$(BUILD)/%,$(filter-out $(TIMES_SRC),$(TEST_SRC))) bindings/test/current.sh test/examples/small.sh
SMALL_CHECKED := $(SMALL_SRC:examples/%.c=$(BUILD)/checked/bin/%)

.PHONY: all bindings amalgamation demo test test-all test-times mutation stability test-bindings bench bench-peers bench-diff bench-scale feature-cost hello platformer rollback replay fuzz embedded sizes check-deps check-links install uninstall clean soak FORCE
.DELETE_ON_ERROR:
.SECONDARY:

all: $(BUILD)/libcairn.a $(BUILD)/$(SHARED_LINK)

# ---------------------------------------------------------------- library

# Objects depend on these files, which change only when the compiler or its flags do.
RELEASE_KEY := $(CC) $(LIB_FLAGS) $(CFLAGS) $(CPPFLAGS)
CHECKED_KEY := $(CC) $(TEST_FLAGS) $(TEST_CFLAGS) $(OWN_CFLAGS) $(TEST_DEFINES) $(CPPFLAGS)
$(BUILD)/release/flags: FORCE
	@mkdir -p $(@D); echo '$(RELEASE_KEY)' | cmp -s - $@ || echo '$(RELEASE_KEY)' > $@
$(BUILD)/checked/flags: FORCE
	@mkdir -p $(@D); echo '$(CHECKED_KEY)' | cmp -s - $@ || echo '$(CHECKED_KEY)' > $@

$(BUILD)/release/src/%.o: src/%.c $(BUILD)/release/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(LIB_FLAGS) $(CPPFLAGS) $(CFLAGS) -c $< -o $@
$(BUILD)/release/examples/%.o: examples/%.c $(BUILD)/release/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(EXAMPLE_FLAGS) $(CPPFLAGS) $(CFLAGS) -c $< -o $@

$(BUILD)/libcairn.a: $(LIB_OBJ)
	@rm -f $@
	$(call say,ar)$(AR) rcs $@ $^
$(BUILD)/$(SHARED): $(LIB_OBJ)
	$(call say,link)$(CC) $(SHARED_FLAGS) $(CFLAGS) $(LDFLAGS) $^ $(LIBS) -o $@
$(BUILD)/$(SHARED_LINK): $(BUILD)/$(SHARED)
	@$(if $(WINDOWS),touch $@,ln -sf $(SHARED) $@)

# ---------------------------------------------------------------- examples

SMALL := $(SMALL_SRC:examples/%.c=$(BUILD)/bin/%)
$(SMALL): $(BUILD)/bin/%: $(BUILD)/release/examples/%.o
$(BUILD)/bin/platformer $(BUILD)/bin/replay: $(EXAMPLE_OBJ)
$(BUILD)/bin/demo: $(BUILD)/release/examples/demo/demo.o $(EXAMPLE_OBJ)
$(BUILD)/bin/bench: $(BUILD)/release/examples/bench/bench.o $(EXAMPLE_OBJ)
$(BUILD)/bin/bench_once: $(BUILD)/release/examples/bench/once.o $(EXAMPLE_OBJ)
$(BUILD)/bin/bench_scale: $(BUILD)/release/examples/bench/scale.o $(EXAMPLE_OBJ)
$(BUILD)/bin/feature_cost: $(BUILD)/release/examples/cost/cost.o $(EXAMPLE_OBJ)
$(SMALL) $(BUILD)/bin/demo $(BUILD)/bin/bench $(BUILD)/bin/bench_once $(BUILD)/bin/bench_scale $(BUILD)/bin/feature_cost: $(BUILD)/libcairn.a
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(CFLAGS) $(LDFLAGS) $(STRIP_UNUSED) $(filter %.o,$^) $(BUILD)/libcairn.a $(LIBS) -o $@

hello: $(BUILD)/bin/hello
	@$(BUILD)/bin/hello

# Plays a level by a script, prints what happens and draws it.
platformer: $(BUILD)/bin/platformer
	@$(BUILD)/bin/platformer $(BUILD)/platformer.png

rollback: $(BUILD)/bin/rollback
	@$(BUILD)/bin/rollback

# Needs cross compilers and QEMU (.ci/deps).
embedded:
	@sh examples/embedded/run.sh $(BUILD)/embedded $(CONFIGURATION)

sizes:
	@sh examples/embedded/sizes.sh $(BUILD)/sizes

# Every small program, one task a file: each prints its result and checks it.
.PHONY: examples
examples: $(SMALL)
	@BUILD='$(BUILD)/bin' sh test/examples/small.sh

# The shared library that records: examples/docs/replay.md.
.PHONY: record-library
record-library: $(BUILD)/record/libcairn.so
$(BUILD)/record/libcairn.so: $(BUILD)/$(SHARED_LINK) bindings/record/library.sh bindings/record/environment.c $(wildcard bindings/record/*.h examples/record/*)
	@CC='$(CC)' sh bindings/record/library.sh $(BUILD)

# Records a small game, plays the recording and draws it.
replay: $(BUILD)/bin/replay
	@$(BUILD)/bin/replay -demo $(BUILD)/demo.rec && $(BUILD)/bin/replay $(BUILD)/demo.rec -o $(BUILD)/replay.png

# PEERS=1: other engines run the scenes in which they are shown anew (.ci/peers).
demo: $(BUILD)/bin/demo $(BUILD)/bin/stability
	@mkdir -p $(BUILD)/demo
	@CC='$(CC)' sh examples/demo/films.sh $(BUILD) $(BUILD)/demo/films $(if $(PEERS),--peers)
	@$(BUILD)/bin/demo $(BUILD)/demo $(SCENE)

# Scenes to play with. In a window by SDL 2; in a browser by WebAssembly, from the same source: examples/testbed/README.md.
.PHONY: testbed testbed-web testbed-web-files
TESTBED := examples/testbed/platform
testbed: $(BUILD)/bin/testbed
	@$(BUILD)/bin/testbed $(SCENE)
$(BUILD)/bin/testbed: $(TESTBED)/sdl.c $(EXAMPLE_OBJ) $(BUILD)/libcairn.a
	@mkdir -p $(@D)
	@pkg-config --exists sdl2 || { echo 'testbed: SDL 2 is not installed (Debian: libsdl2-dev, pkg-config)'; exit 1; }
	$(call say,link)$(CC) $(STRICT) $(MODE) -Iinclude -Iexamples $$(pkg-config --cflags-only-I --cflags-only-other sdl2) $(CFLAGS) $(LDFLAGS) $(STRIP_UNUSED) $^ $(LIBS) \
		$$(pkg-config --libs sdl2) -o $@

# One call of the compiler for library and testbed. WebAssembly has no threads here, and so neither have the examples that need them.
WASM_CC ?= clang-19 --target=wasm32-wasi --sysroot=/usr -isystem /usr/include/wasm32-wasi
WASM_SRC = $(LIB_SRC) $(wildcard examples/testbed/*.c examples/scenes/*.c) examples/demo/canvas.c examples/demo/draw.c examples/demo/draw_group.c \
	examples/demo/draw_joint.c examples/demo/palette.c examples/demo/png.c examples/measure/clock.c examples/measure/measure.c $(TESTBED)/web.c
$(BUILD)/wasm/%.o: %.c
	@mkdir -p $(@D)
	$(call say,wasm)$(WASM_CC) -std=c99 -O3 -msimd128 -ffp-contract=off -fvisibility=hidden -DCN_BUILD -DCN_NO_THREADS -Iinclude -Isrc -Iexamples -MMD -MP -c $< -o $@
$(BUILD)/testbed/testbed.wasm: $(WASM_SRC:%.c=$(BUILD)/wasm/%.o)
	@mkdir -p $(@D)
	$(call say,link)$(WASM_CC) -mexec-model=reactor -Wl,--export-dynamic -Wl,--gc-sections $^ -o $@
-include $(wildcard $(BUILD)/wasm/*/*/*.d $(BUILD)/wasm/*/*/*/*.d)
testbed-web-files: $(BUILD)/testbed/testbed.wasm
	@cp $(TESTBED)/index.html $(TESTBED)/testbed.js $(BUILD)/testbed/
testbed-web: testbed-web-files
	@echo 'http://127.0.0.1:8080 (end it with control and C)'; cd $(BUILD)/testbed && python3 -m http.server --bind 127.0.0.1 8080

bench: $(BUILD)/bin/bench
	@$(BUILD)/bin/bench $(SCENE)

bench-peers:
	@CC='$(CC)' sh examples/peers/run.sh $(BUILD) $(if $(QUICK),--quick) $(if $(ROUNDS),--rounds $(ROUNDS)) $(if $(WORKERS),--workers $(WORKERS)) $(if $(SCENE),--scene $(SCENE))

# Two revisions of the library: BASE beside this tree. examples/README.md
bench-diff:
	@CC='$(CC)' sh examples/bench/diff.sh $(BUILD) '$(or $(BASE),HEAD)' $(if $(QUICK),--quick) $(if $(ROUNDS),--rounds $(ROUNDS)) $(if $(SCENE),--scene $(SCENE))

# Cost against the number of bodies at fixed density. KIND=field: one kind.
bench-scale: $(BUILD)/bin/bench_scale
	@sh examples/bench/scale.sh $(BUILD) $(KIND)

# What each feature costs a step, used and unused. FEATURE: those whose names contain it.
feature-cost: $(BUILD)/bin/feature_cost
	@sh examples/cost/run.sh $(BUILD) $(if $(FEATURE),'$(FEATURE)')

# ---------------------------------------------------------------- tests

$(BUILD)/checked/src/%.o: src/%.c $(BUILD)/checked/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(LIB_FLAGS) $(CPPFLAGS) $(TEST_CFLAGS) $(TEST_DEFINES) $(FILE_CFLAGS) -c $< -o $@
$(BUILD)/checked/cairn.o: $(AMALGAMATED) $(BUILD)/checked/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(LIB_FLAGS) $(CPPFLAGS) $(TEST_CFLAGS) $(TEST_DEFINES) $(FILE_CFLAGS) -c $< -o $@
$(BUILD)/checked/examples/%.o: examples/%.c $(BUILD)/checked/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(EXAMPLE_FLAGS) $(CPPFLAGS) $(TEST_CFLAGS) $(OWN_CFLAGS) $(TEST_DEFINES) -c $< -o $@
$(BUILD)/checked/test/%.o: test/%.c $(BUILD)/checked/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(TEST_FLAGS) $(CPPFLAGS) $(TEST_CFLAGS) $(OWN_CFLAGS) $(TEST_DEFINES) $(FILE_CFLAGS) -c $< -o $@

# The undefined-behaviour sanitizer takes 20 s for each of these, whose code it checks in contact_kernel_plain.o; and -O1 as long for a test
# that calls every function.
$(BUILD)/checked/src/contacts/contact_kernel_4.o $(BUILD)/checked/src/contacts/contact_kernel_8.o: FILE_CFLAGS = $(if $(findstring undefined,$(TEST_CFLAGS)),-fno-sanitize=undefined)
$(BUILD)/checked/test/world/arguments_test.o: FILE_CFLAGS = -O0
# Tests that do much themselves.
$(BUILD)/checked/test/broadphase/%.o $(addprefix $(BUILD)/checked/test/,collision/toi_test.o world/calls_test.o world/memory_test.o world/memory_block_test.o) $(TIMES_SRC:%.c=$(BUILD)/checked/%.o): OWN_CFLAGS =

$(BUILD)/libcairn-checked.a: $(CHECKED_OBJ)
	@rm -f $@
	$(call say,ar)$(AR) rcs $@ $^
$(BUILD)/libexamples-checked.a: $(CHECKED_EXAMPLE_OBJ)
	@rm -f $@
	$(call say,ar)$(AR) rcs $@ $^

# The fuzz targets, as a plain test and under libFuzzer: test/fuzz/run.sh
FUZZ_OBJ := $(patsubst %.c,$(BUILD)/checked/%.o,$(sort $(wildcard test/fuzz/fuzz_*.c)))
$(BUILD)/libfuzz-checked.a: $(FUZZ_OBJ) $(BUILD)/libexamples-checked.a $(BUILD)/libcairn-checked.a
	@rm -f $@
	$(call say,ar)$(AR) rcs $@ $(FUZZ_OBJ)
$(BUILD)/test/fuzz/corpus_test: $(BUILD)/checked/test/fuzz/corpus_test.o $(BUILD)/libfuzz-checked.a $(BUILD)/libexamples-checked.a $(BUILD)/libcairn-checked.a
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(TEST_CFLAGS) $(LDFLAGS) $^ $(LIBS) -o $@

$(BUILD)/test/%: $(BUILD)/checked/test/%.o $(BUILD)/libexamples-checked.a $(BUILD)/libcairn-checked.a
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(TEST_CFLAGS) $(LDFLAGS) $< $(BUILD)/libexamples-checked.a $(BUILD)/libcairn-checked.a $(LIBS) -o $@

# The small examples with the checked library.
$(SMALL_CHECKED): $(BUILD)/checked/bin/%: $(BUILD)/checked/examples/%.o $(BUILD)/libexamples-checked.a $(BUILD)/libcairn-checked.a
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(TEST_CFLAGS) $(LDFLAGS) $< $(BUILD)/libexamples-checked.a $(BUILD)/libcairn-checked.a $(LIBS) -o $@

test: $(TESTS) $(if $(filter test/examples/small.sh,$(TESTS)),$(SMALL_CHECKED))
	@JOBS=$(JOBS) RUNNER='$(RUNNER)' BUILD='$(BUILD)/checked/bin' sh test/run.sh $(BUILD)/test-output $(TESTS)

# PARTS='clang-thread cross': those; BUT=plain: all others.
test-all:
	@BUT='$(BUT)' sh test/variants.sh $(BUILD) $(PARTS)

# Times of parts of the library, printed and not bounded; on an idle machine.
test-times: $(TIMES_SRC:%.c=$(BUILD)/%) $(BUILD)/test/broadphase/sweep_test $(BUILD)/test/broadphase/broadphase_tree_test
	@sh test/run.sh $(BUILD)/times-output $(TIMES_SRC:%.c=$(BUILD)/%)
	@$(BUILD)/test/broadphase/sweep_test t_times && $(BUILD)/test/broadphase/broadphase_tree_test t_times

# Random inputs under sanitizers, FUZZ_SECONDS=600 a target. TARGET='calls file': those
fuzz:
	@sh test/fuzz/run.sh $(BUILD) $(TARGET)

# The suite in its long form, then long tests under load, some ten minutes: an hour of simulated churn, 1,000 histories of 2,000 steps with both
# broadphases, crowds.
soak:
	@$(MAKE) test BUILD=$(BUILD)/long TEST_DEFINES='$(TEST_DEFINES) -DTEST_LONG'
	@for t in soak crowd pressed sleep_residual broadphase_histories; do $(BUILD)/long/test/world/$${t}_test t_soak || exit 1; done

# Lines and branches of src/ that the tests run: test/coverage.sh
.PHONY: coverage lint test-arch
coverage:
	@JOBS=$(JOBS) sh test/coverage.sh $(BUILD)

# Static checks of src/. TOOL='tidy cppcheck analyzer': those. test/lint
lint:
	@JOBS=$(JOBS) sh test/lint/run.sh $(BUILD) $(TOOL)

# Eight scenes on every processor and with every compiler. CONFIGURATION='riscv64 windows': those; test/arch/run.sh
test-arch:
	@JOBS=$(JOBS) sh test/arch/run.sh $(BUILD)/arch $(CONFIGURATION)

# Small faults, one at a time: test/README.md. ONLY=pattern QUICK=1 JOBS=2 FOLDER=dir
mutation:
	@sh test/mutation.sh --jobs $(JOBS) $(if $(QUICK),--quick) $(if $(ONLY),--only '$(ONLY)') $(if $(FOLDER),--folder '$(FOLDER)')

# ---------------------------------------------------------------- stability suite: release build, test/stability/README.md

STABILITY_OBJ := $(patsubst %.c,$(BUILD)/release/%.o,$(sort $(wildcard test/stability/*.c)))

$(BUILD)/release/test/stability/%.o: test/stability/%.c $(BUILD)/release/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(STRICT) $(MODE) -Iinclude $(CPPFLAGS) $(CFLAGS) -c $< -o $@
$(BUILD)/bin/stability: $(STABILITY_OBJ) $(BUILD)/libcairn.a
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(CFLAGS) $(LDFLAGS) $(STABILITY_OBJ) $(BUILD)/libcairn.a $(LIBS) -o $@

# STABILITY: arguments of the program instead of the whole list, for example STABILITY='--family stack --set boxes=30'.
# Without arguments also 10 seeds of each family of test/families.
stability: $(BUILD)/bin/stability $(BUILD)/bin/families
	@$(BUILD)/bin/stability --csv $(BUILD)/stability.csv $(STABILITY); suite=$$?; \
		$(if $(STABILITY),exit $$suite,$(BUILD)/bin/families --seeds 10 --csv $(BUILD)/families.csv && exit $$suite)
-include $(STABILITY_OBJ:.o=.d)

# Families of random scenes, the default solver beside another: test/families/README.md.
# SEEDS=10 FAMILY=name SEED_FIRST=17 SOLVERS=auto,soft SUBSTEPS=n NOISE=1 MONOTONE=1 PEERS=1
FAMILIES_OBJ := $(patsubst %.c,$(BUILD)/release/%.o,$(sort $(wildcard test/families/*.c)))
$(BUILD)/release/test/families/%.o: test/families/%.c $(BUILD)/release/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(STRICT) $(MODE) -Iinclude $(CPPFLAGS) $(CFLAGS) -c $< -o $@
$(BUILD)/bin/families: $(FAMILIES_OBJ) $(BUILD)/libcairn.a
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(CFLAGS) $(LDFLAGS) $(FAMILIES_OBJ) $(BUILD)/libcairn.a $(LIBS) -o $@
-include $(FAMILIES_OBJ:.o=.d)

.PHONY: families
families: $(BUILD)/bin/families
	@CC='$(CC)' sh test/families/run.sh $(BUILD) $(if $(PEERS),--peers) $(if $(SEEDS),--seeds $(SEEDS)) $(if $(SEED_FIRST),--first $(SEED_FIRST)) \
		$(if $(FAMILY),--family $(FAMILY)) $(if $(SOLVERS),--solvers $(SOLVERS)) $(if $(SUBSTEPS),--substeps $(SUBSTEPS)) \
		$(if $(NOISE),--noise $(NOISE)) $(if $(MEDDLE),--meddle $(MEDDLE)) $(if $(DRIFT),--drift $(DRIFT)) $(if $(PACE),--pace $(PACE)) $(if $(SURFACE),--surface $(SURFACE)) $(if $(MONOTONE),--monotone $(MONOTONE))

# Times of a step with 1 to 64 workers by a simulated schedule, and what stays serial: test/schedule/main.c. SCENE='smash rain': those.
SCHEDULE_OBJ := $(patsubst %.c,$(BUILD)/release/%.o,$(sort $(wildcard test/schedule/*.c)))
$(SCHEDULE_OBJ): $(BUILD)/release/%.o: %.c $(BUILD)/release/flags
	@mkdir -p $(@D)
	$(call say,cc)$(CC) $(STRICT) $(MODE) -Iinclude -Isrc -Iexamples $(CPPFLAGS) $(CFLAGS) -c $< -o $@
$(BUILD)/bin/schedule: $(SCHEDULE_OBJ) $(EXAMPLE_OBJ) $(LIB_OBJ)
	@mkdir -p $(@D)
	$(call say,link)$(CC) $(CFLAGS) $(LDFLAGS) $(filter-out %/base/threads.o %/base/clock.o,$^) $(LIBS) -o $@
-include $(SCHEDULE_OBJ:.o=.d)

.PHONY: schedule
schedule: $(BUILD)/bin/schedule
	@$(BUILD)/bin/schedule $(SCENE)

# Error against cost, drawn: test/stability/chart/README.md. PEERS=1: other engines run the same scenes; ROUNDS=3.
.PHONY: chart
chart: $(BUILD)/bin/stability
	@CC='$(CC)' ROUNDS='$(ROUNDS)' sh test/stability/chart/run.sh $(BUILD) $(if $(PEERS),--peers)

# Each mechanism off alone: test/ablation/README.md. MECHANISM='ANGULAR_MOMENTUM EARLY_REST': those; ROUNDS=4, SEEDS=20, JOBS=2.
.PHONY: ablation
ablation:
	@CC='$(CC)' JOBS=$(JOBS) ROUNDS='$(ROUNDS)' SEEDS='$(SEEDS)' sh test/ablation/run.sh $(BUILD) $(MECHANISM)

# Each tuning constant times 0.7 and 1.4: test/tuning/README.md. CONSTANT='CNI_SNAP_RAD': those; SCENES='stack arch', empty for all; JOBS=2.
.PHONY: tuning
tuning:
	@CC='$(CC)' JOBS=$(JOBS) $(if $(filter undefined,$(origin SCENES)),,SCENES='$(SCENES)') sh test/tuning/run.sh $(BUILD) $(CONSTANT)

bindings:
	@python3 bindings/generate.py

# The library as two files for programs that compile it with their own: bindings/README.md.
amalgamation:
	@python3 bindings/amalgamate.py $(BUILD)/amalgamation

test-bindings: $(BUILD)/$(SHARED_LINK) $(BUILD)/bin/replay
	@CC='$(CC)' sh bindings/test/run.sh $(BUILD)

# The documentation as a site, build/docs/index.html: mkdocs in a virtual environment of its own. A broken link is an error.
.PHONY: docs check-docs
DOCS_SITE := examples/docs/site
docs: $(BUILD)/docs-venv/ready
	@python3 $(DOCS_SITE)/stage.py $(BUILD)/docs-pages
	@NO_MKDOCS_2_WARNING=1 CAIRN_DOCS='$(abspath $(BUILD)/docs-pages)' CAIRN_SITE='$(abspath $(BUILD)/docs)' \
		$(BUILD)/docs-venv/bin/mkdocs build --strict --clean -f $(BUILD)/docs-pages.yml > $(BUILD)/docs.log 2>&1 || { cat $(BUILD)/docs.log; exit 1; }
	@echo 'site: $(BUILD)/docs/index.html'
$(BUILD)/docs-venv/ready: $(DOCS_SITE)/requirements.txt
	@mkdir -p $(BUILD)
	$(call say,venv)python3 -m venv $(BUILD)/docs-venv && $(BUILD)/docs-venv/bin/pip install -q -r $<
	@touch $@

# Every C block of the pages compiles and runs, names exist: $(DOCS_SITE)/check.py
check-docs: $(BUILD)/libcairn.a
	@CC='$(CC)' python3 $(DOCS_SITE)/check.py $(BUILD)

check-deps: $(LIB_OBJ)
	@sh test/check_deps.sh $(BUILD)

# The commands of every README as a new user runs them: test/readme.py. ALL=1: also those that take minutes; PAGE='go rust': those pages.
.PHONY: readme
readme:
	@python3 test/readme.py $(BUILD) $(if $(ALL),--all) $(PAGE)

check-links:
	@sh test/check_links.sh

# ---------------------------------------------------------------- install, clean

HEADERS := include/cairn.h bindings/cpp/cairn.hpp

install: all
	mkdir -p '$(DESTDIR)$(PREFIX)/include' '$(DESTDIR)$(LIBDIR)/pkgconfig'
	cp $(HEADERS) '$(DESTDIR)$(PREFIX)/include/'
	cp $(BUILD)/libcairn.a $(BUILD)/$(SHARED) '$(DESTDIR)$(LIBDIR)/'
	$(if $(WINDOWS),cp $(BUILD)/$(SHARED_LINK) '$(DESTDIR)$(LIBDIR)/',ln -sf $(SHARED) '$(DESTDIR)$(LIBDIR)/$(SHARED_LINK)')
	printf '%s\n' 'prefix=$(PREFIX)' 'libdir=$(LIBDIR:$(PREFIX)/%=$${prefix}/%)' 'Name: cairn' 'Description: 2D rigid-body physics' 'Version: $(VERSION)' \
		'Cflags: -I$${prefix}/include' 'Libs: -L$${libdir} -lcairn' 'Libs.private: $(LIBS)' \
		> '$(DESTDIR)$(LIBDIR)/pkgconfig/cairn.pc'

uninstall:
	rm -f $(patsubst %,'$(DESTDIR)$(PREFIX)/include/%',$(notdir $(HEADERS))) $(patsubst %,'$(DESTDIR)$(LIBDIR)/%',libcairn.a $(SHARED) $(SHARED_LINK) pkgconfig/cairn.pc)

clean:
	rm -rf $(BUILD)

-include $(LIB_OBJ:.o=.d) $(EXAMPLE_OBJ:.o=.d) $(MAIN_OBJ:.o=.d)
-include $(CHECKED_OBJ:.o=.d) $(CHECKED_EXAMPLE_OBJ:.o=.d) $(TEST_OBJ:.o=.d)
