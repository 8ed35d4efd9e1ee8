"""Agents that learn corrections of the baselines; imports `heli_gym` and `baselines` except its commands."""

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from heli_gym.train.apg import APG
    from heli_gym.train.oracle import Oracle
    from heli_gym.train.vec_env import HeliVecEnv, ResidualVecEnv

__all__ = ["APG", "HeliVecEnv", "Oracle", "ResidualVecEnv"]

# They load torch, or CasADi: when they are first asked for.
LAZY = {"APG": "apg", "HeliVecEnv": "vec_env", "Oracle": "oracle", "ResidualVecEnv": "vec_env"}


def __getattr__(name: str) -> Any:
    if name in LAZY:
        return getattr(importlib.import_module(f"heli_gym.train.{LAZY[name]}"), name)
    raise AttributeError(f"module 'heli_gym.train' has no attribute {name!r}")
