"""Figures of docs/reliability.md: `python benchmarks/reliability PART [--quick] [--share S] [--seed N]`.

PART is one of fuzz, invocations, mutations, determinism, kills, soak, numerics, caches. Each prints its figures, and
ends with status 1 if one of them is not as it must be. --quick takes about a minute; without it, the figures are those
of the manual.
"""

import argparse
import importlib
import sys

PARTS = ("fuzz", "invocations", "mutations", "determinism", "kills", "soak", "numerics", "caches")

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=PARTS)
    parser.add_argument("--quick", action="store_true", help="fewer of everything")
    parser.add_argument("--seed", type=int, default=0, help="of the random numbers")
    parser.add_argument("--share", type=float, default=1.0, help="of the numbers of a full run")
    parser.add_argument("--only", default="", help="one piece of a part")
    args = parser.parse_args()
    module = importlib.import_module(args.part)
    module.SHARE = args.share
    sys.exit(module.main(args.quick, args.seed, args.only))
