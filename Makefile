# make demo: fly the paper's maneuver, leave out/. make test: everything that can fail.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

# The matrices are small: more threads only make them slower.
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1

SEEDS := 0 1 2 3 4 5 6 7 8 9
TUNED := feedforward+tvlqr lqi lag-lqr lag-lqi kalman-lqr
TRAIN = $(BIN)/heli-train --resume
METHOD := apg-feedforward+tvlqr

.PHONY: demo test test-slow lint docs build/types reproduce clean

demo: $(VENV)/eval
	$(BIN)/heli-evaluate --out out

test: $(VENV)/dev
	$(BIN)/pytest

test-slow: $(VENV)/dev
	$(BIN)/pytest -m slow

lint: $(VENV)/dev build/types
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy

docs: $(VENV)/docs build/types
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build
	@echo "open site/index.html"

# The packages under the names that they have once installed, for tools that read sources.
build/types:
	rm -rf $@ && mkdir -p $@/heli_gym
	ln -s $(CURDIR)/heli_gym/* $(CURDIR)/baselines $(CURDIR)/train $@/heli_gym

# Each seed of lab learns in two stages, and its network begins that of rigid.
reproduce: $(VENV)/dev
	@echo "ten searches for weights, 30 training runs, two tables: some two hours and a quarter of one idle core; may be interrupted"
	for plant in lab rigid; do \
	  for policy in $(TUNED); do \
	    $(BIN)/heli-tune --policy $$policy --plants $$plant --objective tracking \
	      --candidates 200 --population 20 --store || exit 1; \
	  done; \
	done
	for seed in $(SEEDS); do \
	  $(TRAIN) --seed $$seed --steps 96000000 --cost-weight 0.5 --out out/first && \
	  $(TRAIN) --seed $$seed --init "out/first/lab/$(METHOD)@lab/$$seed/best.json" \
	    --steps 24000000 --learning-rate 2e-3 --out out/train && \
	  $(TRAIN) --seed $$seed --plant rigid --init "out/train/lab/$(METHOD)@lab-initialised/$$seed/best.json" \
	    --steps 24000000 --out out/train || exit 1; \
	done
	for plant in lab rigid; do \
	  $(BIN)/heli-results --plant $$plant --methods "out/train/$$plant/$(METHOD)@$$plant-initialised" \
	    --policies feedforward+tvlqr $(TUNED:%=%@PLANT) adaptive-mpc --oracle 20 --out out/results || exit 1; \
	done

clean:
	rm -rf $(VENV) out build dist site *.egg-info

$(VENV)/bin/python:
	$(PYTHON) -m venv $(VENV)

$(VENV)/eval: pyproject.toml | $(VENV)/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[eval]'
	touch $@

$(VENV)/dev: pyproject.toml | $(VENV)/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[dev,train,sweep]'
	touch $@ $(VENV)/eval

$(VENV)/docs: pyproject.toml | $(VENV)/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[docs]'
	touch $@
