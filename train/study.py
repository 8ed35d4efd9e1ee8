"""Studies of training runs: TOML in, trials out.

A study has settings of `heli-train` under `[settings]`, and lists of values under `[grid]`: every combination is a
trial. `{seed}` in a text stands for the trial's seed, and likewise for the other names of the grid.

    [settings]
    plant = "lab"
    steps = 100_000

    [grid]
    seed = [0, 1, 2]
    algo = ["ppo", "td3"]

With `[search]`, Optuna proposes candidates: values of further settings, in batches. Each candidate is trained with
every combination of the grid, and its value is the mean of a metric over them.

    [search]
    trials = 24        # number of candidates
    batch = 4          # candidates proposed together; the next ones know the values of all before
    metric = "score"   # or one of METRICS
    seed = 0

    [search.space]
    learning_rate = { low = 1e-4, high = 1e-2, log = true }
    cell = { low = 32, high = 128, step = 32 }
    objective = ["tracking", "environment"]
"""

import json
import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, fields, replace
from functools import cached_property
from hashlib import sha256
from itertools import product
from pathlib import Path
from tempfile import gettempdir
from types import UnionType
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

from heli_gym.plant import find_plant
from heli_gym.storage import parse_toml
from heli_gym.train import train

MOST_TRIALS = 10_000
OURS = ("out", "resume", "progress")  # settings of heli-train that the sweep sets itself
IN_FOLDER = ("plant", "rig", "algo", "mode", "base", "feature_groups", "privileged", "seed")  # named by `run_folder`
METRICS: dict[str, Literal["minimize", "maximize"]] = {
    "score": "maximize",
    "episode_return": "maximize",
    "success": "maximize",
    "rms_travel_deg": "minimize",
    "rms_elevation_deg": "minimize",
    "cost": "minimize",
}
RANGE = ("low", "high", "log", "step")


@dataclass(frozen=True)
class Search:
    """Search by Optuna for the best values of some settings."""

    trials: int
    space: dict[str, Any]
    batch: int = 4
    metric: str = "score"
    seed: int = 0


@dataclass(frozen=True)
class Study:
    """Settings common to all trials, values to combine, and a search, if any."""

    settings: dict[str, Any] = field(default_factory=dict)
    grid: dict[str, list] = field(default_factory=dict)
    search: Search | None = None

    @property
    def varied(self) -> list[str]:
        """Names of the settings that differ between trials."""
        return [*self.grid, *(self.search.space if self.search else ())]

    def to_json(self) -> str:
        """The study as JSON."""
        return json.dumps(asdict(self), indent=1, default=str) + "\n"


@dataclass(frozen=True)
class Trial:
    """A training run of a study."""

    args: train.CompleteArgs
    values: dict[str, Any]  # of the settings that differ between trials
    folder: str  # relative to the study's

    @cached_property
    def key(self) -> str:
        """Digest of all settings and files that determine the run."""
        return sha256(json.dumps(train.settings_and_files(self.args), sort_keys=True).encode()).hexdigest()[:16]


def read_study(path: Path) -> Study:
    """Read a study. Raises ValueError that names the file and the error in it, OSError for an unreadable file."""
    try:
        tables = parse_toml(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise ValueError(f"study = {str(path)!r}: must be TOML: {error}") from error
    try:
        return study_of(tables)
    except ValueError as error:
        raise ValueError(f"study = {str(path)!r}: {error}") from error


def study_of(tables: dict[str, Any]) -> Study:
    """Study of the tables in its file. Raises ValueError that names the error in it."""
    settings, grid, search = (tables.pop(name, {}) for name in ("settings", "grid", "search"))
    if tables:
        raise ValueError(f"{', '.join(tables)}: must be within [settings], [grid] or [search]")
    if not all(isinstance(table, dict) for table in (settings, grid, search)):
        raise ValueError("settings, grid and search must be tables")
    study = Study(settings, grid, read_search(search) if search else None)
    known = {field.name for field in fields(train.Args)} - set(OURS)
    names = [*settings, *study.varied]
    for name in names:
        if name not in known:
            raise ValueError(f"{name!r} must be a setting of heli-train: {', '.join(sorted(known))}")
        if names.count(name) > 1:
            raise ValueError(f"{name!r}: must be in one of [settings], [grid] and [search.space], not in both")
    for name, values in grid.items():
        if not isinstance(values, list) or not values:
            raise ValueError(f"grid.{name} = {values!r}: must be a list of values")
    trials = math.prod(map(len, grid.values())) * (study.search.trials if study.search else 1)
    if trials > MOST_TRIALS:
        raise ValueError(f"{trials} trials: must be at most {MOST_TRIALS}")
    return study


def read_search(table: dict[str, Any]) -> Search:
    """Search of a study. Raises ValueError that names the error in it."""
    known = [field.name for field in fields(Search)]
    for name in table:
        if name not in known:
            raise ValueError(f"search.{name} must be one of {', '.join(known)}")
    if "trials" not in table or not isinstance(table.get("space"), dict) or not table["space"]:
        raise ValueError("search must have trials, and a space with at least one setting")
    for name, least in (("trials", 1), ("batch", 1), ("seed", 0)):
        value = table.get(name, least)
        if not isinstance(value, int) or isinstance(value, bool) or value < least:
            raise ValueError(f"search.{name} = {value!r}: must be an integer of at least {least}")
    search = Search(**table)
    if search.metric not in METRICS:
        raise ValueError(f"search.metric = {search.metric!r}: must be one of {', '.join(METRICS)}")
    for name, space in search.space.items():
        check_space(f"search.space.{name} = {space!r}", space)
    return search


def check_space(name: str, space: Any) -> None:
    """Raise ValueError unless a space is a list of choices or a range."""
    if isinstance(space, list):
        if not space or not all(isinstance(value, str | int | float | bool) for value in space):
            raise ValueError(f"{name}: must be a list of texts, numbers or booleans, not empty")
        return
    if not isinstance(space, dict) or set(space) - set(RANGE) or not {"low", "high"} <= set(space):
        raise ValueError(f"{name}: must be a list of choices, or a range with low, high and, if wanted, log or step")
    numbers = [space[part] for part in ("low", "high", "step") if part in space]
    if not all(isinstance(value, int | float) and not isinstance(value, bool) for value in numbers):
        raise ValueError(f"{name}: low, high and step must be numbers")
    log = space.get("log", False)
    if not isinstance(log, bool) or (log and "step" in space):
        raise ValueError(f"{name}: log must be true or false, and without step if true")
    if not (all(map(math.isfinite, numbers)) and space["low"] < space["high"] and space.get("step", 1) > 0):
        raise ValueError(f"{name}: low must be less than high, and step positive")
    if log and space["low"] <= 0:
        raise ValueError(f"{name}: low must be positive with log")


def trials_of(study: Study, candidate: dict[str, Any] | None = None, label: str = "study") -> list[Trial]:
    """Trials for every combination of the grid, with a candidate's values if the study has a search.

    Applies the checks of `heli-train`. Raises ValueError for the first invalid trial, with its number.
    """
    trials = []
    for number, combination in enumerate(product(*study.grid.values()), 1):
        values = {**dict(zip(study.grid, combination)), **(candidate or {})}
        try:
            trials.append(make_trial(study, values))
        except (ValueError, TypeError) as error:
            raise ValueError(f"{label}, trial {number}: {error}") from error
    return trials


def make_trial(study: Study, values: dict[str, Any]) -> Trial:
    """Trial with the values of the varied settings. Raises ValueError for invalid settings."""
    settings = {name: substitute(value, values) for name, value in {**study.settings, **values}.items()}
    args = train.Args(**to_settings(settings))
    check_types(args)
    complete = train.with_defaults(replace(args, out=Path(gettempdir()), resume=True, progress=False))
    find_plant(complete.plant)
    train.check(complete)
    train.references_of(complete)
    if complete.init and not complete.init.is_file():
        raise ValueError(f"init = {str(complete.init)!r}: must be a file")
    plant, method, seed = train.run_folder(complete).relative_to(complete.out).parts
    others = {name: value for name, value in values.items() if name not in IN_FOLDER}
    suffix = "".join(f",{name}={readable(value)}" for name, value in others.items())
    return Trial(complete, values, f"runs/{plant}/{method}{suffix}/{seed}")


def readable(value: Any) -> str:
    """Part of a file name for a value."""
    text = Path(value).stem if isinstance(value, str) else str(value)
    return re.sub(r"[^\w.+@-]+", "_", text)


def substitute(value: Any, values: dict[str, Any]) -> Any:
    """Replace {name} in a text by the value of that name."""
    if isinstance(value, str):
        for name, other in values.items():
            value = value.replace(f"{{{name}}}", str(other))
    return value


def check_distinct(trials: Sequence[Trial]) -> None:
    """Raise ValueError if two trials share a folder."""
    numbers: dict[str, int] = {}
    for number, trial in enumerate(trials, 1):
        if trial.folder in numbers:
            raise ValueError(f"study: trials {numbers[trial.folder]} and {number} have the same folder {trial.folder}")
        numbers[trial.folder] = number


def corners(study: Study) -> Iterator[dict[str, Any]]:
    """Extreme candidates of a search: all choices, with all ranges at their low or at their high ends."""
    assert study.search is not None
    space = study.search.space
    choices = {name: values for name, values in space.items() if isinstance(values, list)}
    ranges = {name: values for name, values in space.items() if isinstance(values, dict)}
    for end in ("low", "high") if ranges else ("low",):
        numbers = {name: values[end] for name, values in ranges.items()}
        for combination in product(*choices.values()):
            yield {**dict(zip(choices, combination)), **numbers}


class Proposals:
    """Candidates by Optuna's tree-structured Parzen estimator.

    They depend on the study and the values of the earlier candidates only: a search that starts again with these values
    proposes the same candidates. Raises ValueError without Optuna.
    """

    def __init__(self, search: Search) -> None:
        try:
            import optuna
        except ImportError as error:
            raise ValueError('study: search must have Optuna: `pip install "heli-gym[sweep]"` brings it') from error
        optuna.logging.set_verbosity(optuna.logging.WARNING)
        self.search, self.failed = search, optuna.trial.TrialState.FAIL
        self.distributions: dict[str, Any] = {
            name: optuna.distributions.CategoricalDistribution(space)
            if isinstance(space, list)
            else optuna.distributions.IntDistribution(**space)
            if all(isinstance(space[part], int) for part in ("low", "high", "step") if part in space)
            else optuna.distributions.FloatDistribution(**space)
            for name, space in search.space.items()
        }
        sampler = optuna.samplers.TPESampler(seed=search.seed)
        self.study = optuna.create_study(direction=METRICS[search.metric], sampler=sampler)
        self.proposed: list[Any] = []

    def propose(self) -> list[dict[str, Any]]:
        """Next batch of candidates; empty at the end of the search."""
        left = self.search.trials - len(self.study.trials)
        self.proposed = [self.study.ask(self.distributions) for _ in range(min(left, self.search.batch))]
        return [trial.params for trial in self.proposed]

    def learn(self, values: Sequence[float | None]) -> None:
        """Learn the values of the last batch; None for a candidate that failed."""
        for trial, value in zip(self.proposed, values):
            if value is None or not math.isfinite(value):
                self.study.tell(trial, state=self.failed)
            else:
                self.study.tell(trial, value)

    def best(self) -> tuple[dict[str, Any], float] | None:
        """Best candidate and its value, or None if all failed."""
        with suppress(ValueError):
            return self.study.best_params, self.study.best_value
        return None


def to_settings(values: dict[str, Any]) -> dict[str, Any]:
    """Convert values of TOML or JSON to types of the settings: lists to tuples, names of paths to Path."""
    hints = get_type_hints(train.Args)
    paths = {name for name, hint in hints.items() if hint is Path or Path in get_args(hint)}
    return {
        name: tuple(value) if isinstance(value, list) else Path(value) if name in paths and value else value
        for name, value in values.items()
    }


def check_types(trial: train.Args) -> None:
    """Raise ValueError for a value of another type than its setting."""
    hints = get_type_hints(train.Args)
    for name, value in vars(trial).items():
        kinds = get_args(hints[name]) if get_origin(hints[name]) in (UnionType, Union) else (hints[name],)
        if not any(has_type(value, kind) for kind in kinds):
            raise ValueError(
                f"{name} = {value!r}: must be {' or '.join(getattr(k, '__name__', str(k)) for k in kinds)}"
            )


def has_type(value: Any, kind: Any) -> bool:
    """Whether a value has the type of a setting."""
    if get_origin(kind) is Literal:
        return value in get_args(kind)
    if get_origin(kind) is tuple:
        return isinstance(value, tuple) and all(has_type(part, get_args(kind)[0]) for part in value)
    if kind is float:
        return isinstance(value, float | int) and not isinstance(value, bool)
    return isinstance(value, kind) and (kind is bool or not isinstance(value, bool))
