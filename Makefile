# Everything here needs only Python >= 3.11, make and a package index. Say PYTHON=… to choose another Python.
PYTHON ?= $(shell for p in python3 python python3.14 python3.13 python3.12 python3.11; do \
	command -v $$p >/dev/null 2>&1 && $$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$p && break; done)
BIN := .venv/bin
DEMO ?= demo
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1

.DEFAULT_GOAL := help
.PHONY: help demo test test-slow test-all test-quick test-changed test-ray test-train test-vllm test-exports test-endpoint check lint types contracts docs site site-serve format clean

help: ## say what can be made
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 14

.venv/pip:
	@test -n "$(PYTHON)" || { echo "make: no Python 3.11 or newer found; install one, or say: make PYTHON=/path/to/python3.11" >&2; exit 2; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "make: $(PYTHON) is missing or older than Python 3.11; say: make PYTHON=/path/to/python3.11" >&2; exit 2; }
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet 'pip>=25.1'
	@touch $@

.venv/core: .venv/pip pyproject.toml
	$(BIN)/python -m pip install --quiet --editable '.[figures]'
	@touch $@

.venv/dev: .venv/core
	$(BIN)/python -m pip install --quiet --group dev
	@touch $@

demo: .venv/core ## 100 problems over all recipes, one figure, three problems with their answers
	rm -rf $(DEMO)
	$(BIN)/sim2reason generate $(DEMO) --items 100 --recipe all --difficulty all --seed 0
	$(BIN)/sim2reason sample --recipe pulley --difficulty medium --seed 7 --index 0 -o $(DEMO)/scene.yaml
	$(BIN)/sim2reason figure $(DEMO)/scene.yaml -o $(DEMO)/scene.svg
	$(BIN)/sim2reason figure $(DEMO)/scene.yaml -o $(DEMO)/scene.png
	@$(BIN)/sim2reason show $(DEMO) -n 3
	@echo "All 100 problems: $(DEMO)/data/*.parquet, their counts: $(DEMO)/README.md, a figure: $(DEMO)/scene.svg and .png"

# Long statistics are marked slow, and `make test` looks at a fixed sample of each.
PYTEST = $(BIN)/pytest --numprocesses auto --dist worksteal

test: .venv/dev ## the tests that need nothing else, in parallel; 6 minutes on two cores
	$(PYTEST)

test-slow: .venv/dev ## the long statistics alone, which CI runs, too; 10 minutes on two cores
	$(PYTEST) -m slow

test-all: test test-slow ## both

# Unit tests of each package, what all registries share, and an item of each recipe and of each mode.
QUICK := tests/acceptance/test_same_items.py tests/evaluation/benchmarks/test_files.py tests/scenes/bodies tests/cli/test_list.py \
	tests/cli/test_files.py tests/scenes/connections tests/datasets/test_plan.py tests/datasets/test_rows.py \
	tests/datasets/test_store.py tests/scenes/dsl tests/scenes/entities/test_projectile.py tests/scenes/entities/test_touching.py \
	tests/datasets/exports/test_rewards.py tests/figures/scaled/test_scale.py tests/figures/test_vectors.py tests/generation/filters \
	tests/grading/test_cases.py tests/generation/modes/test_assumptions.py tests/generation/modes/test_corners.py \
	tests/generation/modes/test_counterexample.py tests/generation/modes/test_variations.py tests/text/parsing/test_no_gravity.py \
	tests/evaluation/policies/test_samples.py \
	tests/text/prose tests/simulation/quantities tests/questions/test_asked_by_people.py tests/questions/test_moments.py \
	tests/generation/recipes/test_momentum.py tests/evaluation/reports/test_statistics.py tests/scenes/files/test_files.py \
	tests/simulation tests/solutions/algebra tests/solutions/laws tests/test_conventions.py tests/testing/test_spoiled.py \
	tests/training/test_rewards.py

test-quick: .venv/dev ## a cross-section of the tests; a minute on two cores
	$(PYTEST) $(QUICK)

test-changed: .venv/dev ## the tests that run code changed since they last passed; the first time all, three times as long
	$(PYTEST) --testmon --testmon-forceselect

.venv-ray/done: .venv/pip requirements/ray.txt pyproject.toml
	$(PYTHON) -m venv .venv-ray
	.venv-ray/bin/python -m pip install --quiet --requirement requirements/ray.txt
	.venv-ray/bin/python -m pip install --quiet --no-deps --editable .
	@touch $@

test-ray: .venv-ray/done ## the tests that need Ray, on a local cluster, in an environment of their own
	.venv-ray/bin/python -m pytest -m '' tests/datasets/places

.venv-train/done: .venv/pip requirements/train.txt pyproject.toml
	$(PYTHON) -m venv .venv-train
	.venv-train/bin/python -m pip install --quiet --requirement requirements/train.txt
	.venv-train/bin/python -m pip install --quiet --no-deps --editable .
	@touch $@

test-train: .venv-train/done ## the tests that train models, on CPUs, and TRL's example, in an environment of their own
	.venv-train/bin/python -m pytest -m '' --numprocesses auto --dist worksteal tests/training tests/evaluation/policies \
		tests/cli/test_train.py tests/datasets/exports/libraries/test_trl.py
	.venv-train/bin/python tests/support/readme.py docs/training.md

.venv-vllm/done: .venv/pip requirements/vllm.txt pyproject.toml
	$(PYTHON) -m venv .venv-vllm
	.venv-vllm/bin/python -m pip install --quiet --no-deps --requirement requirements/vllm.txt
	.venv-vllm/bin/python -m pip install --quiet --no-deps --editable .
	@touch $@

test-vllm: .venv-vllm/done ## rollouts by vLLM, and evaluation against its server, on CPUs, in an environment of its own
	.venv-vllm/bin/python -m pytest -m '' tests/training/gspo/test_vllm.py tests/endpoint

# Each library that exports are for has an environment of its own in .exports, 0.6 to 2 GB large. For one of them alone:
# make test-exports-verl. NeMo Gym needs a newer Python than others; without one it is left out, and says so.
LIBRARIES := $(patsubst tests/datasets/exports/requirements/%.txt,%,$(wildcard tests/datasets/exports/requirements/*.txt))
NEWER := $(shell for p in $(PYTHON) python3.12 python3.13 python3.14 $(wildcard $(HOME)/.pyenv/versions/3.1[2-9].*/bin/python); do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 12))' 2>/dev/null && echo $$p && break; done)
NEED_NEWER := nemo_gym

test-exports: $(LIBRARIES:%=test-exports-%) ## exports in the libraries that they are for, each in its own environment

.PHONY: $(LIBRARIES:%=test-exports-%)
$(filter-out $(NEED_NEWER:%=test-exports-%),$(LIBRARIES:%=test-exports-%)): test-exports-%: .exports/%.made .exports/problems
	$(TEST_EXPORTS)

$(NEED_NEWER:%=test-exports-%): test-exports-%: $(if $(NEWER),.exports/%.made .exports/problems)
	$(if $(NEWER),$(TEST_EXPORTS),@echo "make: $* needs Python 3.12 or newer, and there is none: left out")

TEST_EXPORTS = SIM2REASON_PROBLEMS=$(abspath .exports/problems) .exports/$*/bin/python -m pytest -m '' -W ignore \
	tests/datasets/exports/libraries/test_$*.py

.exports/%.made: tests/datasets/exports/requirements/%.txt
	rm -rf .exports/$*
	$(if $(filter $*,$(NEED_NEWER)),$(NEWER),$(PYTHON)) -m venv .exports/$*
	.exports/$*/bin/python -m pip install --quiet --requirement $<
	.exports/$*/bin/python -m pip install --quiet --no-deps --editable .
	@touch $@

test-endpoint: .venv/dev .endpoint/made ## evaluation against a real server, llama.cpp, in an environment of its own
	SIM2REASON_LLAMA_PYTHON=$(abspath .endpoint/bin/python) $(BIN)/pytest -m '' tests/endpoint

.endpoint/made: tests/endpoint/requirements.txt
	rm -rf .endpoint
	$(PYTHON) -m venv .endpoint
	.endpoint/bin/python -m pip install --quiet --requirement $<
	@touch $@

.exports/problems: | .venv/core
	$(BIN)/sim2reason generate $@ --items 103 --mode all --seed 1 --split train=0.8,test=0.2

check: lint types contracts ## style, types and contracts

lint: .venv/dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: .venv/dev
	$(BIN)/pyright

contracts: .venv/dev
	$(BIN)/lint-imports --no-logo

docs: .venv/dev ## write anew what the docs show: outputs, tables and pictures
	$(BIN)/sim2reason sample --recipe hybrid --difficulty medium --seed 7 --index 8 -o docs/images/scene.yaml
	$(BIN)/sim2reason figure docs/images/scene.yaml -o docs/images/scene.svg --numbers
	$(BIN)/sim2reason plot docs/images/scene.yaml -o docs/images/traces.png
	$(BIN)/sim2reason schema --page -o docs/scene-format.md
	$(BIN)/sim2reason schema --reference -o docs/questions.md
	$(BIN)/python docs/grading_examples.py
	$(BIN)/python docs/gallery.py
	$(BIN)/python docs/commands.py
	$(BIN)/python tests/support/readme.py README.md docs/for-language-models.md --write
	$(BIN)/python tests/support/readme.py docs/index.md --write
	$(BIN)/python tests/support/readme.py docs/tutorial.md --write
	$(BIN)/python tests/support/readme.py docs/howto/*.md --write

.venv-site/done: .venv/pip requirements/site.txt
	$(PYTHON) -m venv .venv-site
	.venv-site/bin/python -m pip install --quiet --no-deps --requirement requirements/site.txt
	@touch $@

site: .venv-site/done ## build the documentation site in site/, in an environment of its own
	NO_MKDOCS_2_WARNING=1 .venv-site/bin/mkdocs build --strict

site-serve: .venv-site/done ## serve the documentation site on this machine and rebuild it after changes
	NO_MKDOCS_2_WARNING=1 .venv-site/bin/mkdocs serve

format: .venv/dev ## mend what can be mended by itself
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

clean: ## remove what was made, but not the virtual environment
	rm -rf $(DEMO) build dist site .pytest_cache .testmondata* .ruff_cache .hypothesis .import_linter_cache
