# Only delegates: to tools/, to the CMake presets, to ninja.
PRESET ?= release
PREFIX ?= /usr/local
CASE ?= cases/discocyte.toml
OUT ?= out/$(basename $(notdir $(CASE)))

.PHONY: help setup build demo test python check-deep install format clean

help:
	@echo "make demo                 install what is missing, build, run $(CASE), plot it"
	@echo "make test                 the same set-up, then all tests"
	@echo "make build                the same set-up, stops after building"
	@echo "make python               the Python package, in a virtual environment in build/python-venv"
	@echo "make check-deep           layout, sanitizers, the second compiler, lint"
	@echo "make install PREFIX=...   program, library, CMake package, man page, completion"
	@echo "make format               lay out the sources with clang-format"
	@echo "make clean                remove build/ and out/"
	@echo "PRESET=... chooses another build: $(shell sed -n 's/.*{"name": "\([a-z0-9]*\)", "configurePreset".*/\1/p' CMakePresets.json | tr '\n' ' ')"

setup:
	@tools/install-dependencies

build: setup
	@cmake --preset $(PRESET) --log-level=WARNING
	@cmake --build --preset $(PRESET)

# The program alone: whoever wants to see it run need not wait for the tests to compile.
demo: setup
	@cmake --preset $(PRESET) --log-level=WARNING
	@cmake --build --preset $(PRESET) --target vesica_program
	build/$(PRESET)/bin/vesica run $(CASE) -o $(OUT) --overwrite
	tools/plot-run $(OUT)

test: build
	ctest --preset $(PRESET)

# Without the tests, as for the demo.
python: setup
	@cmake --preset $(PRESET) --log-level=WARNING
	@cmake --build --preset $(PRESET) --target vesica_program vesica_python
	@tools/make-python build/$(PRESET)

check-deep: setup
	@tools/check-deep

install: build
	cmake --install build/$(PRESET) --prefix $(PREFIX)

format:
	@tools/format

clean:
	rm -rf build out
