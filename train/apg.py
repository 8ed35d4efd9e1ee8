"""Analytic policy gradient: training of a recurrent correction by gradients through the simulator.

Each update flies whole maneuvers of `LANES` random helicopters and takes an Adam step along the exact gradient of their
mean loss (APG in Freeman et al., "Brax", 2021). The interface is that of Stable-Baselines3's algorithms. Files are
safetensors and JSON, read without unpickling.
"""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import torch
from gymnasium.utils.seeding import np_random
from threadpoolctl import threadpool_limits

from heli_gym.baselines.control.residual import (
    CELL,
    Network,
    RecurrentNetwork,
    ResidualPolicy,
)
from heli_gym.baselines.control.residual.step import FLIGHT_FEATURES, SINGLE_GROUPS, time_features
from heli_gym.baselines.control.tracking import TrackingPolicy
from heli_gym.parameters import Coupling
from heli_gym.plant import ThrustDrift, lowest
from heli_gym.rigid_body import RigidBodyParameters
from heli_gym.simulation import layout, motion
from heli_gym.simulation.layout import (
    AMOUNT,
    BACK,
    COULOMB,
    COUNTS,
    COUPLING,
    DELAY_PERIODS,
    DELAY_REST,
    DISTURBANCE,
    DISTURBANCES,
    DURATION,
    FRONT,
    LAG_DECAY,
    LOSS,
    MEASURED,
    PARAMETERS,
    REST_DECAY,
    RIG,
    ROTOR,
    SHARE,
    TRAVEL_LIFT,
    VISCOUS,
    ZEROS,
    X,
)
from heli_gym.thrust_map import PowerCurve
from heli_gym.train.checkpoint import read_checkpoint, write_state
from heli_gym.train.flight_gradient import (
    LANES,
    PITCH_PENALTY,
    SUBSTEPS,
    Batch,
    Outcome,
    Rollout,
    Settings,
    Task,
    Weights,
)
from heli_gym.vector_env import Heli3DOFVectorEnv

AHEAD = (0.0, 0.2, 0.4, 0.8, 1.6)  # s, previews of the reference
UNBOUNDED = 1e9  # V


class Actor(torch.nn.Module):
    """GRU cell and linear layer: maps features (N, F) to actions (N, 2) in [-1, 1]."""

    def __init__(self, features: int, hidden: int, memory: bool = True) -> None:
        super().__init__()
        self.cell = torch.nn.GRUCell(features, hidden)
        self.head = torch.nn.Linear(hidden, 2)
        torch.nn.init.zeros_(self.head.bias)
        with torch.no_grad():
            self.head.weight.mul_(0.01)  # the first flights are close to the base policy's
        if not memory:
            forget_always(self.cell)

    def forward(self, features: torch.Tensor, hidden: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """Actions (N, 2) and next hidden state (N, H) for features (N, F) and hidden state (N, H)."""
        hidden = self.cell(features, hidden)
        return torch.tanh(self.head(hidden)), hidden


CLOSED = -40.0  # argument of the sigmoid of a gate that is never open


def forget_always(cell: torch.nn.GRUCell) -> None:
    """Make a cell a layer without memory, new = tanh(W x + b), and let no gradient change that."""
    n = cell.hidden_size

    def fixed(rows: slice) -> Any:
        def hook(gradient: torch.Tensor) -> torch.Tensor:
            gradient = gradient.clone()
            gradient[rows] = 0.0
            return gradient

        return hook

    update, every = slice(n, 2 * n), slice(None)
    with torch.no_grad():
        cell.weight_hh.zero_(), cell.bias_hh.zero_()
        cell.weight_ih[update], cell.bias_ih[update] = 0.0, CLOSED
    for tensor, rows in (
        (cell.weight_hh, every),
        (cell.bias_hh, every),
        (cell.weight_ih, update),
        (cell.bias_ih, update),
    ):
        tensor.register_hook(fixed(rows))


def network_of(actor: Actor) -> RecurrentNetwork:
    """Copy of the actor's network in numpy."""
    *cell, weight, bias = (tensor.detach().numpy().astype(float) for tensor in actor.parameters())
    return RecurrentNetwork(**dict(zip(CELL, cell)), head=Network((weight,), (bias,), tanh_output=True))


def set_network(actor: Actor, network: Network | RecurrentNetwork) -> None:
    """Copy a network into the actor. Raises ValueError for other shapes."""
    cell, head = actor.cell, actor.head
    arrays: list[np.ndarray] = []
    if isinstance(network, RecurrentNetwork):
        arrays = [*network[:4], *network.head.weights, *network.head.biases]
    if [array.shape for array in arrays] != [tuple(tensor.shape) for tensor in actor.parameters()]:
        raise ValueError(
            f"init: must be a network with {cell.input_size} features, a GRU cell of {cell.hidden_size} states and "
            f"{head.out_features} outputs"
        )
    with torch.no_grad():
        for tensor, array in zip(actor.parameters(), arrays):
            tensor.copy_(torch.from_numpy(array))


class FlightLoss(torch.autograd.Function):
    """Mean loss of a batch of flights as a function of the actor's parameters."""

    @staticmethod
    def forward(
        ctx: Any,
        rollout: Rollout,
        batch: Batch,
        outcomes: list[Outcome],
        hidden: torch.Tensor | None,
        *tensors: torch.Tensor,
    ) -> torch.Tensor:
        """Fly the batch from first hidden states (H, LANES), append its outcome to `outcomes` and return the loss."""
        first = None if hidden is None else hidden.detach().numpy()
        outcome = rollout.forward(weights_of(tensors), batch._replace(hidden=first))
        outcomes.append(outcome)
        ctx.rollout, ctx.outcome = rollout, outcome
        return torch.tensor(rollout.loss(outcome))

    @staticmethod
    def backward(ctx: Any, *grad_outputs: Any) -> Any:
        """Gradient with respect to the tensors."""
        g = ctx.rollout.backward(ctx.outcome)
        weight_input = np.empty((len(g.input_bias), g.seen.shape[1] + g.preview.shape[1]), np.float32)
        weight_input[:, FLIGHT_FEATURES], weight_input[:, time_features(weight_input.shape[1])] = g.seen, g.preview
        d_hidden = ctx.rollout.d_hidden if ctx.needs_input_grad[3] else None
        arrays = d_hidden, weight_input, g.hidden, g.input_bias, g.hidden_bias, g.output, g.output_bias
        scale = grad_outputs[0]
        return None, None, None, *(None if array is None else scale * torch.from_numpy(array) for array in arrays)


def weights_of(tensors: Any) -> Weights:
    """Parameters of the actor for the compiled flights."""
    weight_input, hidden, input_bias, hidden_bias, output, output_bias = (t.detach().numpy() for t in tensors)
    seen, preview = weight_input[:, FLIGHT_FEATURES], weight_input[:, time_features(weight_input.shape[1])]
    return Weights(np.ascontiguousarray(seen), preview, hidden, input_bias, hidden_bias, output, output_bias)


def task_of(
    policy: ResidualPolicy,
    envs: Heli3DOFVectorEnv,
    cost_weight: float,
    elevation_weight: float,
    pitch_penalty: float = PITCH_PENALTY,
    after_crash: bool = False,
) -> Task:
    """Common task of all flights of the helicopters, with the policy's base and law.

    Raises ValueError for a base, law or plant that the compiled flights do not support.
    """
    base = policy.base
    if not isinstance(base, TrackingPolicy):
        raise ValueError(f"base: must be a feedforward with state feedback, not {type(base).__name__}")
    simulation = envs.simulation
    shared = layout.shared(simulation.settings.tolist())
    first = simulation.plants[0].alternatives[0]
    general = simulation.fly is motion.step_general
    curve = base.rig.thrust_map.front
    usual = shared.substeps == SUBSTEPS and not shared.is_noisy and not shared.pieces
    usual = usual and (general or (simulation.fly is motion.step_plant and not shared.disturbances))
    plants = [one for own in simulation.plants for one in own.alternatives]
    for plant in plants:
        usual = usual and math.isinf(plant.rotors.slew)
        if general:
            usual = usual and plant.rig is None and all(isinstance(d, ThrustDrift) for d in plant.disturbances)
        else:
            usual = usual and not any(plant.friction.coulomb) and plant.rotors.gains == (1.0, 1.0)
    usual = usual and base.rig.thrust_map.back == curve
    if not (usual and isinstance(curve, PowerCurve) and curve.dead_zone == 0.0 and first.sensors is not None):
        raise ValueError(
            "plant: must have encoders, no noise, no slew limit, power curves of thrust, and no disturbances but a "
            "drift of thrust; the base's rotors must be alike"
        )
    for drift in (d for plant in plants for d in plant.disturbances if isinstance(d, ThrustDrift)):
        if drift.time != 0.0 or lowest(drift.duration) < policy.reference.duration:
            raise ValueError(
                f"plant: {drift} must have time = 0 and a duration of at least {policy.reference.duration:g} s, that "
                "of the reference"
            )
    if not general and curve.exponent != 2.0:
        raise ValueError("base: its thrust map must be (2) on a plant whose thrust map is (2)")
    T = policy.x.shape[1] - 1
    policy.reset(np.random.default_rng(0))
    _, features = policy.observe(envs.control_period * np.arange(T), policy.x[:, :T])
    policy.reset(np.random.default_rng(0))
    low, high = envs.voltage_limits
    limits = policy.reference.limits
    bounds = (low, high) if policy.law == "saturated" else (-UNBOUNDED, UNBOUNDED)
    decay = np.exp(-envs.control_period / first.sensors.rate_filter)
    settings = (
        envs.control_period, low, high, envs.pitch_limit, *limits.u, *limits.pitch, decay, policy.scale, curve.k_plus,
        curve.k_minus, cost_weight, elevation_weight, *bounds, curve.exponent, pitch_penalty,
    )  # fmt: skip
    return Task(
        np.ascontiguousarray(base.x.T),
        np.ascontiguousarray(base.v.T[:T]),
        np.ascontiguousarray(base.gains.transpose(2, 0, 1)[:T]),
        np.ascontiguousarray(features[time_features(len(features))].T.astype(np.float32)),
        Settings(*map(float, settings)),
        int(shared.delay) + general,
        after_crash,
    )


def batch_of(envs: Heli3DOFVectorEnv, seed: int) -> Batch:
    """Starts and draws of the helicopters after a reset with a seed."""
    simulation = envs.simulation
    for j in range(envs.num_envs):  # like `envs.reset`, without observations and infos
        simulation.draw(j, np_random(seed + j)[0])
    simulation.reset(np.arange(envs.num_envs))
    rows = simulation.rows
    k_plus, _, a1, a2, a3, b1, b2, b3, *c = rows(PARAMETERS, 11)
    viscous, counts = rows(VISCOUS, 3), rows(COUNTS, 3)
    motion_rows = [a1, a2, a3, b1, b2, b3, *(np.array(c) + viscous)]
    if simulation.plants[0].alternatives[0].rig is not None:
        motion_rows = [*rows(RIG, len(RigidBodyParameters._fields)), *viscous]
    start = rows(X, 6).copy(), rows(MEASURED, 6).copy(), rows(ROTOR, 2).copy()
    decay = rows(LAG_DECAY, 1)[0]
    if simulation.fly is not motion.step_general:
        share = 1.0 - rows(LOSS, 1)[0]
        return Batch(np.array([share * k_plus, decay, *counts, *motion_rows]), *start)
    thrusts, exponents = [], []
    for share, curve in zip(rows(SHARE, 2), (FRONT, BACK)):
        forward, backward, exponent, _ = rows(curve, 4)
        thrusts += [share * forward, share * backward]
        exponents.append(exponent)
    drift = np.zeros(envs.num_envs)
    for d in range(int(layout.shared(simulation.settings.tolist()).disturbances)):
        values = rows(DISTURBANCES + DISTURBANCE * d, DISTURBANCE)
        drift += 0.5 * values[AMOUNT] / values[DURATION]  # there is one for each rotor
    body = [
        np.zeros(envs.num_envs), decay**SUBSTEPS, *counts, *motion_rows, *thrusts, *exponents, np.ones(envs.num_envs),
        rows(DELAY_REST, 1)[0], rows(REST_DECAY, 1)[0] ** SUBSTEPS, *rows(COULOMB, 3), rows(TRAVEL_LIFT, 1)[0],
        *rows(ZEROS, 3), *rows(COUPLING, len(Coupling._fields)),
    ]  # fmt: skip
    return Batch(np.array(body), *start, rows(DELAY_PERIODS, 1)[0].astype(int), drift)


class APG:
    """Analytic policy gradient with the interface of Stable-Baselines3's algorithms.

    Args:
        policy: residual policy that defines reference, base, scale and law; its feature groups must be
            `SINGLE_GROUPS`, or those without the preview. With several, each update flies the next one's reference.
        envs: `LANES` helicopters, from which each update draws, on the policy's reference; or several, one for each
            policy.
        learning_rate: learning rate of Adam.
        hidden: number of states of the GRU cell.
        max_grad_norm: greatest norm of the clipped gradient.
        cost_weight: weight of the cost in the loss, in degrees of travel error per second.
        elevation_weight: weight of the elevation error in the loss; the travel error has weight 1.
        pitch_penalty: penalty in 1/(s rad²) of the squared pitch beyond `SAFE_PITCH`.
        after_crash: whether a crashed flight counts to the end of the maneuver, as in `Metrics`; otherwise a crash ends
            its errors and its cost.
        memory: whether the cell remembers; without, only the last action, a feature, comes from the past.
        seed: of the initial weights and of the helicopters.
        first: module that gives the first hidden states (H, `LANES`) of the flights that helicopters have drawn, and
            learns too; by default they are zero. `save` does not keep it.

    Raises:
        ValueError: for a policy, plant or number of helicopters that the compiled flights do not support.
    """

    def __init__(
        self,
        policy: ResidualPolicy | Sequence[ResidualPolicy],
        envs: Heli3DOFVectorEnv | Sequence[Heli3DOFVectorEnv],
        learning_rate: float = 2e-3,
        hidden: int = 96,
        max_grad_norm: float = 1.0,
        cost_weight: float = 0.5,
        elevation_weight: float = 1.0,
        pitch_penalty: float = PITCH_PENALTY,
        after_crash: bool = False,
        memory: bool = True,
        seed: int = 0,
        first: torch.nn.Module | None = None,
    ) -> None:
        policies = [policy] if isinstance(policy, ResidualPolicy) else list(policy)
        fleets = [envs] if isinstance(envs, Heli3DOFVectorEnv) else list(envs)
        if len(policies) != len(fleets) or any(own.num_envs != LANES for own in fleets):
            raise ValueError(f"envs: must be {LANES} helicopters for each policy, not {[e.num_envs for e in fleets]}")
        for groups in {own.feature_groups for own in policies} - {SINGLE_GROUPS, SINGLE_GROUPS[:2]}:
            raise ValueError(f"feature_groups = {groups!r}: must be {SINGLE_GROUPS!r}, or without the last")
        self.arguments = {
            "learning_rate": learning_rate,
            "hidden": hidden,
            "max_grad_norm": max_grad_norm,
            "cost_weight": cost_weight,
            "elevation_weight": elevation_weight,
            "pitch_penalty": pitch_penalty,
            "after_crash": after_crash,
            "memory": memory,
            "seed": seed,
        }
        torch.manual_seed(seed)
        self.fleets, self.seed, self.max_grad_norm = fleets, seed, max_grad_norm
        self.envs, self.residual = fleets[0], policies[0]
        self.tasks = [
            task_of(policy, own, cost_weight, elevation_weight, pitch_penalty, after_crash)
            for policy, own in zip(policies, fleets)
        ]
        self.policy = Actor(len(FLIGHT_FEATURES) + self.tasks[0].preview.shape[1], hidden, memory)
        self.first = first
        learned = [*self.policy.parameters(), *(first.parameters() if first else ())]
        self.optimizer = torch.optim.Adam(learned, lr=learning_rate)
        self.rollout = Rollout(max(self.tasks, key=lambda task: len(task.v_ref)), hidden)
        self.device = torch.device("cpu")
        self.lr_schedule: Any = lambda _: learning_rate
        self.num_timesteps = self._n_updates = 0
        self.next_seed = seed * 10**6
        self.logger: Any = None
        self.outcomes: list[Outcome] = []  # of the last call of `learn`

    def set_logger(self, logger: Any) -> None:
        """Set the Stable-Baselines3 logger."""
        self.logger = logger

    def get_env(self) -> Heli3DOFVectorEnv:
        """Helicopters of the training."""
        return self.envs

    def learn(
        self,
        total_timesteps: int,
        callback: Any = None,
        log_interval: int = 1,
        reset_num_timesteps: bool = True,
        **ignored: Any,
    ) -> "APG":
        """Update until all helicopters together have flown a number of control periods."""
        if reset_num_timesteps:
            self.num_timesteps = 0
        end = self.num_timesteps + total_timesteps
        if callback is not None:
            callback.init_callback(self)
            callback.on_training_start({}, {})
        self.outcomes = []
        while self.num_timesteps < end:
            norm = self.update()
            if callback is not None and not callback.on_step():
                break
            if self.logger is not None and self._n_updates % log_interval == 0:
                self.log(norm)
        if callback is not None:
            callback.on_training_end()
        return self

    def update(self) -> float:
        """Fly one batch, take an optimiser step and return the norm of the gradient."""
        with threadpool_limits(1):  # more threads slow down small matrices
            return self._update()

    def _update(self) -> float:
        for group in self.optimizer.param_groups:
            group["lr"] = self.lr_schedule(1.0)
        number = self._n_updates % len(self.tasks)
        batch = batch_of(self.fleets[number], self.next_seed)
        self.next_seed += LANES
        self.optimizer.zero_grad()
        self.rollout.task = self.tasks[number]
        hidden = self.first(self.fleets[number]) if self.first else None
        FlightLoss.apply(self.rollout, batch, self.outcomes, hidden, *self.policy.parameters()).backward()
        norm = float(torch.nn.utils.clip_grad_norm_(self.policy.parameters(), self.max_grad_norm))
        if np.isfinite(norm):
            self.optimizer.step()
        self.num_timesteps += LANES * len(self.rollout.task.v_ref)
        self._n_updates += 1
        return norm

    def log(self, norm: float) -> None:
        """Log the outcome of the last update."""
        outcome = self.outcomes[-1]
        for name in Outcome._fields:
            self.logger.record(f"train/{name}", float(getattr(outcome, name).mean()))
        self.logger.record("train/gradient_norm", norm)
        self.logger.dump(self.num_timesteps)

    def predict(
        self,
        observation: np.ndarray,
        state: tuple[np.ndarray, ...] | None = None,
        episode_start: np.ndarray | None = None,
        deterministic: bool = True,
    ) -> tuple[np.ndarray, tuple[np.ndarray, ...]]:
        """Actions (N, 2) for features (N, F), and next hidden state (N, H) in a tuple; without N for one helicopter."""
        batch = np.atleast_2d(observation)
        hidden = (
            np.zeros((len(batch), self.policy.cell.hidden_size)) if state is None else np.atleast_2d(state[0]).copy()
        )
        if episode_start is not None:
            hidden[np.asarray(episode_start, bool)] = 0.0
        with torch.no_grad():
            tensors = (torch.as_tensor(values, dtype=torch.float32) for values in (batch, hidden))
            action, following = self.policy(*tensors)
        shape = np.shape(observation)[:-1]
        return action.numpy().reshape(*shape, 2), (following.numpy().reshape(*shape, -1),)

    def save(self, path: str | Path) -> None:
        """Write path.safetensors and path.sha256."""
        write_state(Path(path), {**self.arguments, "steps": self.num_timesteps, **self.get_parameters()})

    @classmethod
    def load(cls, path: str | Path, policy: ResidualPolicy, envs: Heli3DOFVectorEnv) -> "APG":
        """Load an agent that `save` wrote. Raises ValueError for a missing or damaged file."""
        state = read_checkpoint(Path(path).with_suffix(".safetensors"))
        parameters = {name: state.pop(name) for name in ("policy", "policy.optimizer")}
        steps = state.pop("steps")
        agent = cls(policy, envs, **state)
        agent.set_parameters(parameters)
        agent.num_timesteps = steps
        return agent

    def get_parameters(self) -> dict[str, dict]:
        """States of network and optimiser."""
        return {"policy": self.policy.state_dict(), "policy.optimizer": self.optimizer.state_dict()}

    def set_parameters(self, parameters: dict[str, dict]) -> None:
        """Restore the states from `get_parameters`."""
        self.policy.load_state_dict(parameters["policy"])
        self.optimizer.load_state_dict(parameters["policy.optimizer"])
