# The commands of the workspace; `make help` lists them.
SHELL := /bin/bash
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
COMMANDS := help setup installed configure build race report test docs sanitize tsan aarch64 coverage lint tidy format pictures bench fuzz wheel clean
.PHONY: $(COMMANDS) judged known-circuit

# Where a command fails, GNU make says `*** Error 1` and ends with 2. A race that did not end as expected is no failure of make:
# as with `make -q`, which runs only lines that begin with `+`, it ends with 1 because a line is left to be run.
ifeq ($(MAKECMDGOALS),race)
MAKEFLAGS += -q
.PHONY: raced
race: raced
	$(if $(filter 1,$(shell cat "$(or $(OUT),.)/build/verdict")),@:)
raced:
	+@MAKEFLAGS="$${MAKEFLAGS/q/}" $(MAKE) --no-print-directory judged

else ifneq ($(words $(CURDIR)),1)
# roslaunch and rostest split paths at blanks: work through a link whose path has none.
LINK := $(or $(XDG_CACHE_HOME),$(HOME)/.cache)/f1tenth_workspace/$(shell pwd | cksum | cut -d ' ' -f 1)
$(COMMANDS) judged:
	@mkdir -p $(dir $(LINK)) && ln -sfn "$(CURDIR)" $(LINK)
	@cd $(LINK) && $(MAKE) --no-print-directory CURDIR=$(LINK) $@
else

# Where build/, devel/, results/ and .venv/ lie: here, unless these files are read-only.
OUT ?= $(CURDIR)
override OUT := $(abspath $(OUT))
BUILD_DIR := $(OUT)/build
DEVEL_DIR = $(OUT)/devel
VENV = $(OUT)/.venv
export F1TENTH_VENV = $(VENV)
export PRE_COMMIT_HOME = $(OUT)/build/pre-commit
export F1TENTH_RESULTS ?= $(OUT)/results
# ROS belongs to the system's Python, whatever stands first on PATH.
export PATH := $(VENV)/bin:/usr/bin:$(PATH)

JOBS ?= $(shell nproc)
# Every test has its own ROS master, display and folders, so that several can run side by side. Most of them wait for
# processes that start and for messages: two for each processor keep it busy.
TEST_JOBS ?= $(shell expr 2 \* $(JOBS))
CIRCUIT ?= circuit1
CIRCUITS = $(basename $(notdir $(wildcard src/f1tenth_gazebo/circuits/*.yaml)))
LAPS ?= 1
FUZZ_SECONDS ?= 600
# Whether sources are compiled several at a time: a fresh build takes a third of the processor time, an incremental one up to
# twice. Decided when the workspace is first configured: ON for CI and for whoever begins with a race or the tests, OFF for a developer who
# begins with `make build`; `make configure UNITY=OFF` changes it.
FRESH_UNITY := $(if $(CI)$(filter race judged test bench report,$(MAKECMDGOALS)),ON,OFF)
UNITY ?= $(if $(wildcard $(BUILD_DIR)/CMakeCache.txt),,$(FRESH_UNITY))
# What tools/setup is told: --yes lets it use sudo without asking.
SETUP ?=

IN_WORKSPACE = source "$(DEVEL_DIR)/setup.bash" $(EXTEND) &&
CPP_FILES = $(shell git ls-files '*.cpp' '*.h')
PYTHON_FILES = $(shell git ls-files '*.py'; git grep -lI '^\#!/usr/bin/\(env python3\|python3\)' -- ':!*.py')

# Two of these at once would install, or configure, twice at once; what they call runs side by side by itself.
.NOTPARALLEL:

help: ## list the commands
	@sed -n 's/^\([a-z0-9]*\):.*## /  make \1\t/p' $(MAKEFILE_LIST) | expand -t 16
	@echo "  Variables: CIRCUIT=$(CIRCUIT), of $(CIRCUITS);"
	@echo "  PLANNER=LAUNCH FILE, with LAPS=1, INTERFACE=native or f1tenth; WATCH=1 shows it in a browser;"
	@echo "  JOBS=$(JOBS); TEST_JOBS=$(TEST_JOBS);"
	@echo "  OUT=FOLDER for everything that is written, when these files are read-only; SETUP=--yes"

setup: ## install what is missing from Debian and PyPI
	@tools/setup --tests $(SETUP)

# Without what only tests need (a browser and such): a quarter of all, that nobody has to wait for before the first race.
installed:
	@tools/setup $(SETUP)

# CMake notices by itself what has changed in known files, but neither a new package nor a newly installed original
# of a stand-in; `make configure` looks for both.
CONFIGURED := $(BUILD_DIR)/configured
PACKAGES := $(wildcard src/*/package.xml src/standins/*/package.xml)

configure: installed ## configure the workspace anew
	@rm -f $(CONFIGURED)
	@$(MAKE) --no-print-directory $(CONFIGURED)

$(CONFIGURED): $(PACKAGES) CMakeLists.txt $(wildcard cmake/*) $(wildcard setup/*) | installed
	@mkdir -p $(BUILD_DIR)
	@cmake -S $(CURDIR) -B $(BUILD_DIR) -DPYTHON_EXECUTABLE=/usr/bin/python3 -DWORKSPACE_VENV="$(VENV)" \
	  -DCATKIN_DEVEL_PREFIX="$(DEVEL_DIR)" $(addprefix -DWORKSPACE_UNITY=,$(UNITY)) \
	  $(if $(CI),-DCMAKE_COMPILE_WARNING_AS_ERROR=ON) > $(BUILD_DIR)/configure.log 2>&1 \
	  || { cat $(BUILD_DIR)/configure.log; exit 1; }
	@touch $@

build: installed $(CONFIGURED) ## build the workspace
	@cmake --build $(BUILD_DIR) -j $(JOBS) -- --no-print-directory

# Without a planner, ours drives: a circuit from goal to goal, another place for laps.
OURS = $(if $(filter %_map.yaml %.world %.sdf,$(CIRCUIT)),race)
RACE = $(if $(or $(PLANNER),$(OURS)),race "$(CIRCUIT)" --planner "$(or $(PLANNER),race)" --laps $(LAPS),run "$(CIRCUIT)") $(addprefix --interface ,$(INTERFACE))

# A planner of somebody else may lie in an overlay that has been sourced: --extend leaves it there.
judged: EXTEND = $(if $(PLANNER),--extend)
judged: known-circuit build
	@$(IN_WORKSPACE) { F1TENTH_TYPED=make rosrun f1tenth_scenarios scenario $(RACE) --report $(if $(WATCH),--watch); echo $$? > "$(BUILD_DIR)/verdict"; } && \
	  grep -q '^[01]$$' "$(BUILD_DIR)/verdict" || exit 2

race: judged ## one headless race, judged: make race CIRCUIT=circuit3 PLANNER=my.launch
	@exit $$(cat "$(BUILD_DIR)/verdict")

# Refused before minutes of building. An overlay may bring circuits of its own, which only the command that races can find.
known-circuit:
	@[ -n "$(wildcard $(CIRCUIT) src/f1tenth_*/*/$(CIRCUIT).*)$(F1TENTH_SCENARIO_PATH)$(ROS_PACKAGE_PATH)" ] || \
	  { echo "CIRCUIT=$(CIRCUIT): no such file, and no such circuit; there are: $(CIRCUITS)" >&2; exit 1; }

report: build ## one HTML file of all results: results/report.html
	@$(IN_WORKSPACE) exec rosrun f1tenth_scenarios scenario report

test: setup build ## every test; ends with `N passed, N failed, N skipped`
	@rm -rf $(BUILD_DIR)/test_results
	@cmake --build $(BUILD_DIR) -j $(JOBS) --target tests -- --no-print-directory
	@-$(IN_WORKSPACE) /usr/bin/python3 -m pytest -q tools/test --junitxml=$(BUILD_DIR)/test_results/workspace/pytest-tools.xml
	@cmake --build $(BUILD_DIR) -j $(TEST_JOBS) --target run_tests -- --no-print-directory --output-sync=target
	@tools/test_summary $(BUILD_DIR)/test_results

sanitize: installed ## tests of the simulator's core and loaders under AddressSanitizer and UBSan
	@tools/sanitize address $(BUILD_DIR)/sanitize

tsan: setup ## the simulator's node and Python module under ThreadSanitizer
	@tools/sanitize thread $(BUILD_DIR)/tsan

docs: ## the documents as a searchable site, links checked: results/site/index.html
	@tools/setup --docs $(SETUP)
	@NO_MKDOCS_2_WARNING=1 "$(VENV)/bin/python3" -m mkdocs build --site-dir "$(OUT)/results/site"
	@echo "$(OUT)/results/site/index.html"

aarch64: installed ## the same bits on aarch64, which is emulated: trajectories, pictures, judged runs
	@tools/aarch64 $(BUILD_DIR)/aarch64

coverage: setup ## which lines the tests run: results/coverage/
	@tools/coverage $(BUILD_DIR)/coverage

lint: setup ## check format, style and types of all files
	@pre-commit run --all-files --show-diff-on-failure

tidy: installed ## clang-tidy over the C++ files: make tidy FILES=src/f1tenth_sim2d/src/node
	@tools/tidy $(BUILD_DIR)/tidy $(FILES)

format: setup ## format all files
	@clang-format -i $(CPP_FILES)
	@ruff check --fix-only -q $(PYTHON_FILES)
	@ruff format -q $(PYTHON_FILES)

pictures: build ## make the pictures of the documents anew
	@$(IN_WORKSPACE) exec tools/pictures

bench: build ## measure simulator and planner: results/bench.json; make bench KEYS="core_rtf walls"
	@cmake --build $(BUILD_DIR) -j $(JOBS) --target f1tenth_bench_programs -- --no-print-directory
	@$(IN_WORKSPACE) exec /usr/bin/python3 -m f1tenth_bench $(KEYS)

fuzz: installed ## fuzz the simulator's loaders: make fuzz FUZZ_SECONDS=60 TARGETS="world car"
	@command -v clang++ >/dev/null || { echo "fuzz: needs clang++: apt-get install clang" >&2; exit 1; }
	@mkdir -p $(BUILD_DIR)
	@cmake -S src/f1tenth_sim2d/fuzz -B $(BUILD_DIR)/fuzz -DCMAKE_CXX_COMPILER=clang++ > $(BUILD_DIR)/fuzz.log
	@cmake --build $(BUILD_DIR)/fuzz -j $(JOBS) -- --no-print-directory
	@src/f1tenth_sim2d/fuzz/run $(BUILD_DIR)/fuzz $(FUZZ_SECONDS) $(TARGETS)

wheel: installed ## wheels of simulator and judge: results/*.whl; make wheel PYTHON=python3.13
	@tools/make_wheel $(BUILD_DIR)/wheel $(OUT)/results $(PYTHON)

clean: ## remove everything that was built
	@rm -rf $(BUILD_DIR) $(OUT)/devel install logs .catkin_tools
	@git clean -fdXq -- src

endif
