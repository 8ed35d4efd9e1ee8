# make demo: fly the paper's maneuver, leave out/. make test: everything that can fail.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

# The matrices are small: more threads only make them slower.
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1

TUNED := feedforward+tvlqr lqi lag-lqr lag-lqi kalman-lqr
# `make reproduce ENGINE=ray ADDRESS=auto`, or WORKERS=8 on this machine, trains the same networks.
ENGINE := local
ADDRESS :=
WORKERS := 1
PARALLEL = --engine $(ENGINE) --workers $(WORKERS) $(if $(ADDRESS),--address $(ADDRESS))
SWEEP = $(BIN)/heli-sweep --resume $(PARALLEL)
METHOD := apg-feedforward+tvlqr
ON_FLEET := feedforward+tvlqr hover-lqr lqi lag-lqr lag-lqi kalman-lqr gain-scheduled flatness pd-cascade linear-mpc \
  l1-adaptive adaptive-lqr adaptive-mpc

.PHONY: demo test test-slow lint docs pictures build/types reproduce tune leaderboard clean

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

# The pictures of README and manual that need neither training runs nor measured logs; live.png needs node and Chromium.
pictures: $(VENV)/dev
	$(BIN)/heli-evaluate --out out/pictures
	cp out/pictures/overview.png docs/overview.png
	$(BIN)/heli-film --out docs/flight.gif
	npm ci --prefix web
	$(BIN)/python web/picture.py

# The packages under the names that they have once installed, for tools that read sources.
build/types:
	rm -rf $@ && mkdir -p $@/heli_gym
	ln -s $(CURDIR)/heli_gym/* $(CURDIR)/baselines $(CURDIR)/train $@/heli_gym

# Each seed of lab learns in two stages, and its network begins that of rigid. Then the fleet, one policy for any
# maneuver, and the ablations.
ANY := out/train/runs/lab/$(METHOD)@lab-any-maneuver/0/best.json

reproduce: $(VENV)/dev
	@echo "64 training runs on the stored weights of the controllers, four tables; may be interrupted"
	@echo "with WORKERS=2 on two cores 2 h 24 min, of one core 3 h 40 min"
	for study in first-lab first-fleet; do \
	  $(SWEEP) results/studies/$$study.toml --out out/first || exit 1; \
	done
	for study in lab rigid fleet any-maneuver; do \
	  $(SWEEP) results/studies/$$study.toml --out out/train || exit 1; \
	done
	for study in whole memory law features learners; do \
	  $(SWEEP) results/studies/ablation-$$study.toml --out out/ablation || exit 1; \
	done
	for plant in lab rigid; do \
	  $(BIN)/heli-results --plant $$plant --methods "out/train/runs/$$plant/$(METHOD)@$$plant-initialised" \
	    --policies feedforward+tvlqr $(TUNED:%=%@PLANT) adaptive-mpc --oracle 100 --workers $(WORKERS) \
	    --out out/results || exit 1; \
	done
	$(BIN)/heli-results --plant fleet --methods out/train/runs/fleet.fleet/$(METHOD)-initialised \
	  --against linear-mpc --policies $(ON_FLEET) --out out/results
	$(BIN)/heli-results --methods out/ablation/runs/lab/* --policies feedforward+tvlqr@PLANT --out out/results/ablation
	$(BIN)/python -m heli_gym.train.maneuvers --out out/results \
	  --policies feedforward+tvlqr@lab kalman-lqr@lab adaptive-mpc residual "$(ANY)"

# Ten searches for weights, on one core, because several learn from batches of candidates, and end elsewhere. It
# replaces the stored weights, of an earlier version, by others: the networks were trained on the stored ones.
tune: $(VENV)/dev
	for plant in lab rigid; do \
	  for policy in $(TUNED); do \
	    $(BIN)/heli-tune --policy $$policy --plants $$plant --objective tracking \
	      --candidates 200 --population 20 --store || exit 1; \
	  done; \
	done

# The table of docs/evaluation.md: an hour or more of one idle core; may be interrupted.
leaderboard: $(VENV)/dev
	$(BIN)/python benchmarks/field.py --run out/field --workers $(WORKERS)
	$(BIN)/python benchmarks/field.py out/field/* --docs

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
