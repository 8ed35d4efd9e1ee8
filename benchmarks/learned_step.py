"""Time of one control step of learned and classical policies, by numpy and by exported C.

    python benchmarks/learned_step.py [POLICY ...]    # by default residual, residual-any, adaptive-mpc and their base

Times are for one helicopter, along `travel-360` with 0.01 rad and rad/s of noise on the measurements, on one thread in
double precision: by numpy the median step of the best of 20 flights, by C the mean step of the best of 40. The C code
is compiled by `cc` with each of FLAGS. Policies that have no C code have a row without it.
"""

import argparse
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from heli_gym.baselines import make_policy
from heli_gym.baselines.control.export import c_source
from heli_gym.env import find_reference
from heli_gym.rig import find_rig

FLAGS = ("-O2", "-O3", "-O3 -march=native", "-O3 -march=native -ffast-math")
PERIOD = 0.02  # s
MAIN = """
#include "heli_controller.h"
#include <stdio.h>
#include <time.h>

static const double measurements[][6] = {
%s
};

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

int main(void) {
    int steps = sizeof measurements / sizeof measurements[0], flight, k;
    double u[2], best = 1e9, sum = 0.0;
    for (flight = 0; flight < 40; flight++) {
        double began, took;
        heli_reset();
        began = seconds();
        for (k = 0; k < steps; k++) {
            heli_step(%r * k, measurements[k], u);
            sum += u[0]; /* keeps the call */
        }
        took = (seconds() - began) / steps;
        if (took < best) best = took;
    }
    printf("%%.3f %%g", 1e6 * best, sum);
    return 0;
}
"""


def numpy_microseconds(policy: Any, measurements: np.ndarray) -> float:
    """Time in µs of a step by numpy on measurements (6, K)."""
    best = np.inf
    for _ in range(20):
        policy.reset(np.random.default_rng(0))
        took = []
        for k, measurement in enumerate(measurements.T):
            began = time.perf_counter()
            policy(PERIOD * k, measurement)
            took.append(time.perf_counter() - began)
        best = min(best, float(np.median(took)))
    return 1e6 * best


def c_microseconds(policy: Any, name: str, measurements: np.ndarray) -> list[float]:
    """Times in µs of a step by C for each of FLAGS. Raises ValueError for a policy without C code."""
    files = c_source(policy, find_rig("paper"), name, "double")
    rows = ",\n".join("{" + ", ".join(map(repr, row)) + "}" for row in measurements.T.tolist())
    files["main.c"] = MAIN % (rows, PERIOD)
    times = []
    with tempfile.TemporaryDirectory() as folder:
        for file, text in files.items():
            Path(folder, file).write_text(text)
        for flags in FLAGS:
            made = ["cc", "-std=c99", "-D_POSIX_C_SOURCE=199309L", *flags.split(), "main.c", "heli_controller.c"]
            subprocess.run([*made, "-o", "main", "-lm"], cwd=folder, check=True)
            shown = subprocess.run([f"{folder}/main"], capture_output=True, text=True, check=True).stdout
            times.append(float(shown.split()[0]))
    return times


def main() -> None:
    """Print a row per policy."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = ["residual", "residual-any", "feedforward+tvlqr@lab", "adaptive-mpc"]
    parser.add_argument("policies", nargs="*", default=names)
    reference = find_reference("travel-360")
    t = PERIOD * np.arange(round(reference.duration / PERIOD))
    noise = 0.01 * np.random.default_rng(0).standard_normal((6, len(t)))
    measurements = reference(t)[0] + noise
    print(f"| policy | numpy, µs | {' | '.join(f'C {flags}, µs' for flags in FLAGS)} |")
    print("|---" * (2 + len(FLAGS)) + "|")
    for name in parser.parse_args().policies:
        policy = make_policy(name, reference, PERIOD)
        cells = [f"{numpy_microseconds(policy, measurements):.0f}"]
        try:
            cells += [f"{each:.2f}" for each in c_microseconds(policy, name, measurements)]
        except ValueError:
            cells += [""] * len(FLAGS)
        print(f"| `{name}` | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
