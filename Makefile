# make demo: fly the paper's maneuver, leave out/. make test: everything that can fail.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

# The matrices are small: more threads only make them slower.
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1

SEEDS := 0 1 2 3 4 5 6 7 8 9

.PHONY: demo test lint reproduce clean

demo: $(VENV)/eval
	$(BIN)/heli-evaluate --out out

test: $(VENV)/dev
	$(BIN)/pytest

lint: $(VENV)/dev
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy

reproduce: $(VENV)/dev
	@echo "twenty training runs of about three minutes each on an idle core, then the tables: an hour or two"
	for plant in lab rigid; do \
	  for seed in $(SEEDS); do $(BIN)/heli-train --plant $$plant --seed $$seed --out out/train --resume || exit 1; done; \
	  $(BIN)/python -m train.results --plant $$plant --methods out/train/$$plant/* --out out/results || exit 1; \
	done

clean:
	rm -rf $(VENV) out build dist *.egg-info

$(VENV)/bin/python:
	$(PYTHON) -m venv $(VENV)

$(VENV)/eval: pyproject.toml | $(VENV)/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[eval]'
	touch $@

$(VENV)/dev: pyproject.toml | $(VENV)/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[dev,train]'
	touch $@ $(VENV)/eval
