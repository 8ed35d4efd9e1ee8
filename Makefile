# make demo: fly the paper's maneuver, leave out/. make test: everything that can fail.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

# The matrices are small: more threads only make them slower.
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1

SEEDS ?= 0 1 2
TUNED := feedforward+tvlqr lqi lag-lqr lag-lqi kalman-lqr
TRAIN = $(BIN)/heli-train --resume
METHOD := apg-feedforward+tvlqr
ON_FLEET := feedforward+tvlqr hover-lqr lqi lag-lqr lag-lqi kalman-lqr gain-scheduled flatness pd-cascade linear-mpc \
  l1-adaptive adaptive-lqr adaptive-mpc

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

# Each seed of lab learns in two stages, and its network begins that of rigid. Then the fleet, one policy for any
# maneuver, and the ablations.
ANY := out/train/lab/$(METHOD)@lab-any-maneuver/0/best.json
SHORT := --steps 5760000 --cell 64 --out out/ablation

reproduce: $(VENV)/dev
	@echo "ten searches for weights, 21 training runs, four tables: some two hours of one idle core; may be interrupted"
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
	$(TRAIN) --plant fleet --rig fleet --cell 64 --steps 24000000 --out out/first
	$(TRAIN) --plant fleet --rig fleet --cell 64 --init out/first/fleet.fleet/$(METHOD)/0/best.json \
	  --steps 36000000 --learning-rate 2e-3 --out out/train
	$(TRAIN) --reference drawn --out out/train
	for seed in 0 1 2; do \
	  $(TRAIN) --seed $$seed $(SHORT) && $(TRAIN) --seed $$seed $(SHORT) --no-memory && \
	  $(TRAIN) --seed $$seed $(SHORT) --law sum && \
	  $(TRAIN) --seed $$seed $(SHORT) --feature-groups error voltages || exit 1; \
	done
	$(TRAIN) --algo ppo --steps 5760000 --out out/ablation
	for plant in lab rigid; do \
	  $(BIN)/heli-results --plant $$plant --methods "out/train/$$plant/$(METHOD)@$$plant-initialised" \
	    --policies feedforward+tvlqr $(TUNED:%=%@PLANT) adaptive-mpc --oracle 20 --out out/results || exit 1; \
	done
	$(BIN)/heli-results --plant fleet --rig fleet --methods out/train/fleet.fleet/$(METHOD)-initialised \
	  --against feedforward+tvlqr --policies $(ON_FLEET) --out out/results
	$(BIN)/heli-results --methods out/ablation/lab/* --policies feedforward+tvlqr@PLANT --out out/results/ablation
	$(BIN)/python -m heli_gym.train.maneuvers --out out/results \
	  --policies feedforward+tvlqr@lab kalman-lqr@lab adaptive-mpc residual "$(ANY)"

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
