// One experiment of the live page: a rig, a plan, a plant and the controllers along the plan, from the reader's choices.

import { type ControlData, type Maker, controllersAlong } from "./controllers";
import { deg, rad } from "./dom";
import type { RigidBody } from "./equations";
import { Flight, type Rules } from "./flight";
import { type Model, type Pair, hoverInput, voltages } from "./model";
import { type Plan, integratePlan } from "./plan";
import { type Plant, type Push, drawn } from "./plant";
import { type Reference, controlGrid } from "./policies";
import { type FeatureSettings, type Network, type StoredNetwork, unpacked } from "./residual";
import { type StoredSpline, splinePlan } from "./spline";
import { type Weights, withStationaryCost } from "./tvlqr";

/** Plans by pitch limit, window of voltages and duration: plans[pitch limit][window][duration], null where there is none. */
export interface Grid<T> {
  durations: (number | null)[]; // s; null stands for the fastest
  pitch_limits_deg: number[];
  windows: Pair[]; // V
  plans: (T | null)[][][];
}

export type Method = "paper" | "spline";

/** A rig, with everything that Python computes for it. */
export interface RigData {
  name: string;
  source: string;
  parameters: Model;
  amplifier: Pair; // V
  pitch_stop: number; // rad
  encoder_counts: number[];
  weights: Weights;
  hover_gain: number[][];
  networks: Record<string, StoredNetwork>; // by the plant that each was trained on
  network_for: Record<string, string>; // by plant
  plants: Record<string, unknown>; // with ranges
  body: RigidBody;
  grids: { spline: Grid<StoredSpline>; paper?: Grid<number[]> }; // the paper's: parameters of (39)
}

export interface LiveData {
  paper: { duration: number; pitch_limit_deg: number; window: Pair };
  goal: Pair; // rad
  pitch_reserve: number;
  kappa: Pair;
  control_period: number; // s
  substep: number; // s
  features: FeatureSettings;
  policies: { name: string; label: string; colour: string; shown: boolean }[];
  rigs: RigData[];
}

/** Effects of the plant that the reader can set; null where the draw decides. */
export const EFFECTS = {
  lag: { name: "rotor lag", unit: "s", digits: 2, min: 0, max: 0.3, step: 0.01 },
  friction: { name: "friction", unit: "1/s", digits: 2, min: 0, max: 0.6, step: 0.02 },
  loss: { name: "thrust loss", unit: "%", digits: 0, min: 0, max: 30, step: 1 },
  delay: { name: "delay", unit: "s", digits: 2, min: 0, max: 0.2, step: 0.01 },
  zero: { name: "pitch zero", unit: "°", digits: 0, min: -8, max: 8, step: 1 },
} as const;
export type Effect = keyof typeof EFFECTS;
export const EFFECT_NAMES = Object.keys(EFFECTS) as Effect[];

/** Weights of (49) that the reader can multiply by powers of ten. */
export const WEIGHTS = ["travel", "elevation", "pitch", "effort"] as const;
export type WeightName = (typeof WEIGHTS)[number];

/** All choices of the reader that determine a flight. */
export interface Setup {
  rig: string;
  method: Method;
  duration: number | null; // s; null: the fastest
  pitchLimit: number; // deg
  window: Pair; // V
  startOff: number; // deg
  plant: string;
  draw: number;
  effects: Partial<Record<Effect, number>>;
  weights: Record<WeightName, number>; // powers of ten
}

export const HOLD = 4; // s, for which the goal is held
const REMEMBERED = 40; // plans

export const rigOf = (data: LiveData, name: string) => data.rigs.find((rig) => rig.name === name) ?? data.rigs[0];

/** The choices of a page that has just been opened, or of another rig: the paper's, or the fastest plan with a reserve. */
export function initialSetup(data: LiveData, rig: RigData): Setup {
  const { spline, paper } = rig.grids;
  const limits = paper
    ? { method: "paper" as const, duration: data.paper.duration, pitchLimit: data.paper.pitch_limit_deg, window: data.paper.window }
    : { method: "spline" as const, duration: spline.durations[3], pitchLimit: 50, window: spline.windows[Math.min(1, spline.windows.length - 1)] };
  const weights = { travel: 0, elevation: 0, pitch: 0, effort: 0 };
  return snapped({ rig: rig.name, ...limits, startOff: 3, plant: Object.keys(rig.plants)[0], draw: 1, effects: {}, weights }, data);
}

const nearest = <T>(values: T[], distance: (value: T) => number): number =>
  values.reduce((best, value, i) => (distance(value) < distance(values[best]) ? i : best), 0);

/** Where the choices are in the grid. */
export function placeOf(setup: Setup, grid: Grid<unknown>) {
  const far = (a: number | null, b: number | null) => (a === null || b === null ? (a === b ? 0 : 1e3) : Math.abs(a - b));
  return {
    duration: nearest(grid.durations, (value) => far(value, setup.duration)),
    pitch: nearest(grid.pitch_limits_deg, (value) => Math.abs(value - setup.pitchLimit)),
    window: nearest(grid.windows, ([low, high]) => Math.abs(low - setup.window[0]) + Math.abs(high - setup.window[1])),
  };
}

export const gridOf = (rig: RigData, method: Method): Grid<StoredSpline | number[]> => (method === "paper" && rig.grids.paper) || rig.grids.spline;

/** The choices, each replaced by the nearest one that the page has. */
export function snapped(setup: Setup, data: LiveData): Setup {
  const rig = rigOf(data, setup.rig);
  const method: Method = setup.method === "paper" && rig.grids.paper ? "paper" : "spline";
  const grid = gridOf(rig, method);
  const at = placeOf(setup, grid);
  return {
    ...setup,
    rig: rig.name,
    method,
    duration: grid.durations[at.duration],
    pitchLimit: grid.pitch_limits_deg[at.pitch],
    window: grid.windows[at.window],
    plant: setup.plant in rig.plants ? setup.plant : Object.keys(rig.plants)[0],
    startOff: Math.min(Math.max(Math.round(setup.startOff), 0), 10),
  };
}

/** The plan that was found for the choices. */
export const storedPlan = (setup: Setup, data: LiveData): StoredSpline | number[] | null => {
  const grid = gridOf(rigOf(data, setup.rig), setup.method);
  const at = placeOf(setup, grid);
  return grid.plans[at.pitch][at.window][at.duration];
};

/** Duration in s of the plan for the choices. */
export function durationOf(setup: Setup, data: LiveData): number | null {
  const stored = storedPlan(setup, data);
  return stored === null ? null : Array.isArray(stored) ? setup.duration : stored.duration;
}

/** A flight recorded on a real rig, on a uniform grid. */
export interface Log {
  name: string;
  step: number; // s
  x: number[][];
  u: Pair[];
}

/** The plant of the choices: a preset, its draw, and what the reader set. */
export function plantOf(setup: Setup, data: LiveData): { plant: Plant; isRandom: boolean } {
  const rig = rigOf(data, setup.rig);
  const preset = rig.plants[setup.plant];
  const plant = drawn(preset, generator(setup.draw)) as Plant;
  const isRandom = JSON.stringify(plant) !== JSON.stringify(preset);
  const { lag, friction, loss, delay, zero } = setup.effects;
  const changed: Plant = {
    ...plant,
    rotors: {
      ...plant.rotors,
      ...(lag !== undefined && { lag }),
      ...(loss !== undefined && { thrust_loss: loss / 100 }),
      ...(delay !== undefined && { delay }),
    },
    friction: friction === undefined ? plant.friction : { ...plant.friction, viscous: [friction, friction, friction] },
  };
  if (zero !== undefined) {
    const sensors = plant.sensors ?? { counts: rig.encoder_counts, rate_filter: 0.03, zeros: [0, 0, 0] };
    changed.sensors = { ...sensors, zeros: sensors.zeros.with(2, rad(zero)) };
  }
  return { plant: changed, isRandom };
}

/** The effects of a plant, as the sliders show them. */
export function effectsOf({ rotors, friction, sensors }: Plant): Record<Effect, number> {
  return {
    lag: rotors.lag,
    friction: friction.viscous.reduce((sum, f) => sum + f / 3, 0),
    loss: 100 * rotors.thrust_loss,
    delay: rotors.delay,
    zero: deg(sensors?.zeros[2] ?? 0),
  };
}

interface Planned {
  plan: Plan;
  controllers: Record<string, Maker>;
  networks: Record<string, Network>;
}
const planned = new Map<string, Planned>();

const numbers = new WeakMap<Log, number>();
let opened = 0;

/** A number of its own for each log: a corrected file may have the name and the length of the one before. */
function numberOf(log: Log): number {
  if (!numbers.has(log)) numbers.set(log, opened++);
  return numbers.get(log)!;
}

/** The paper's weights, each multiplied by the reader's power of ten. */
export function weightsOf({ weights }: Setup, rig: RigData, goal: Pair): Weights {
  const scales = [weights.travel, weights.travel, weights.elevation, weights.elevation, weights.pitch, weights.pitch].map((power) => 10 ** power);
  const Q = rig.weights.Q.map((row, i) => row.map((value) => scales[i] * value));
  const R = rig.weights.R.map((row) => row.map((value) => 10 ** weights.effort * value));
  return withStationaryCost({ Q, R }, goal[1], rig.parameters);
}

function planFor(setup: Setup, data: LiveData, rig: RigData, log: Log | null): Planned | null {
  const stored = log ? null : storedPlan(setup, data);
  if (!log && stored === null) return null;
  const key = JSON.stringify([rig.name, setup.method, setup.duration, setup.pitchLimit, setup.window, setup.weights, log && numberOf(log)]);
  const known = planned.get(key);
  if (known) return known;
  const limits = limitsOf(setup);
  const step = data.control_period / 2;
  const plan = log
    ? { step: log.step, x: log.x, u: log.u }
    : Array.isArray(stored)
      ? integratePlan(
          { duration: setup.duration!, goal: data.goal, limits },
          [stored.slice(0, data.kappa[0]), stored.slice(data.kappa[0])],
          data.pitch_reserve,
          rig.parameters,
          step,
        )
      : splinePlan(stored!, data.goal, rig.parameters, step);
  let yours: Weights | undefined;
  const control: ControlData = {
    ...rig,
    control_period: data.control_period,
    features: data.features,
    get yours() {
      return (yours ??= weightsOf(setup, rig, data.goal));
    },
  };
  const networks = Object.fromEntries(Object.entries(rig.networks).map(([name, network]) => [name, unpacked(network)]));
  const made = { plan, controllers: controllersAlong(plan, limits.pitch, control), networks };
  planned.set(key, made);
  if (planned.size > REMEMBERED) planned.delete(planned.keys().next().value!);
  return made;
}

export function limitsOf({ pitchLimit, window }: Setup): { u: Pair; pitch: Pair } {
  return { u: window, pitch: [-rad(pitchLimit), rad(pitchLimit)] };
}

/** What is flown along a plan, or along a recorded flight. */
export class Experiment {
  readonly rig: RigData;
  readonly plant: Plant;
  readonly isRandom: boolean; // whether the plant is one draw of several
  readonly reference: Reference; // on the control grid, the goal being held at the end
  readonly duration: number; // s, of the plan
  readonly rules: Rules;
  readonly start: readonly number[];
  private readonly rest: Pair; // V, of the rotors at the start

  /** Null where there is no plan for the choices. */
  static make(setup: Setup, data: LiveData, log: Log | null = null): Experiment | null {
    const ready = planFor(setup, data, rigOf(data, setup.rig), log);
    return ready && new Experiment(setup, data, log, ready);
  }

  private constructor(readonly setup: Setup, data: LiveData, readonly log: Log | null, private readonly ready: Planned) {
    this.rig = rigOf(data, setup.rig);
    ({ plant: this.plant, isRandom: this.isRandom } = plantOf(setup, data));
    const period = data.control_period;
    const flown = controlGrid(ready.plan);
    const last = flown.x.length - 1;
    this.duration = period * last;
    const onGrid = Array.from({ length: last + 1 + (log ? 0 : Math.round(HOLD / period)) }, (_, k) => Math.min(k, last));
    this.reference = { x: onGrid.map((k) => flown.x[k]), u: onGrid.map((k) => flown.u[k]), middle: onGrid.map((k) => flown.middle[k]) };
    this.rules = { controlPeriod: period, amplifier: this.rig.amplifier, pitchStop: this.rig.pitch_stop, substep: data.substep };
    const off = log ? 0 : rad(setup.startOff);
    this.start = this.reference.x[0].map((value, i) => value + (i === 0 ? -off : i === 2 ? off : 0));
    this.rest = log ? log.u[0] : voltages(hoverInput(0, this.rig.parameters), this.rig.parameters);
  }

  get steps(): number {
    return this.reference.x.length - 1;
  }

  /** What was trained for the plant. */
  get network(): Network {
    return this.ready.networks[this.rig.network_for[this.setup.plant]];
  }

  offers(policy: string): boolean {
    return policy !== "residual" || this.network.learned !== null;
  }

  /** A flight at its start; null for a policy that is not for this rig. */
  begin(policy: string): Flight | null {
    const controller = this.ready.controllers[policy](this.network);
    return controller && new Flight(controller, this.plant, this.rules, this.start, this.rest);
  }

  /** A whole flight. */
  fly(policy: string, pushes: Push[] = []): Flight | null {
    const flight = this.begin(policy);
    while (flight && !flight.crashed && flight.x.length <= this.steps) flight.step(pushes);
    return flight;
  }

  gains(policy: string): number[][][] | null {
    const { controller } = this.begin(policy) ?? {};
    return (controller && "tracking" in controller && (controller.tracking as { gains: number[][][] | null }).gains) || null;
  }

  /** Distance in deg of travel and elevation from the goal at the time when the plan ends. */
  endError(flight: Flight): number {
    if (flight.crashed) return Infinity;
    const [x, goal] = [flight.x[Math.round(this.duration / this.rules.controlPeriod)], this.reference.x.at(-1)!];
    return deg(Math.hypot(x[0] - goal[0], x[2] - goal[2]));
  }

  /** RMS error in deg of travel and elevation over a whole flight. */
  rmsError(flight: Flight): number {
    if (flight.crashed) return Infinity;
    const squares = flight.x.map((x, k) => (x[0] - this.reference.x[k][0]) ** 2 + (x[2] - this.reference.x[k][2]) ** 2);
    return deg(Math.sqrt(squares.reduce((sum, value) => sum + value, 0) / squares.length));
  }

  /** Share of a flight's periods in which a motor is at a limit of the amplifier. */
  saturation(flight: Flight): number {
    const [low, high] = this.rig.amplifier;
    const at = flight.u.filter((u) => u.some((volts) => volts <= low + 1e-9 || volts >= high - 1e-9));
    return at.length / Math.max(flight.u.length, 1);
  }
}

/** Uniform numbers in [0, 1) from a seed (mulberry32). */
function generator(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
