// What stands between the voltage and the measurement, as heli_gym/plant.py and simulation.py have it: the parts that
// the presets use, and pushes.

import { type Pair, type Parameters, dynamics, rk4Step, virtualInput } from "./model";
import { type Rig, rigidDynamics } from "./rigid";

/** A drawn plant. Python writes the presets with ranges; `drawn` draws from them. */
export interface Plant {
  parameters: Parameters;
  rig: Rig | null;
  rotors: { lag: number; thrust_loss: number; delay: number };
  friction: { viscous: number[] };
  sensors: { counts: number[]; rate_filter: number } | null;
}

/** A torque on one axis (0 travel, 1 elevation, 2 pitch) from a time on, for a while. */
export interface Push {
  axis: number;
  acceleration: number; // rad/s²
  time: number; // s
  duration: number; // s
}

/** All that a plant remembers of a flight. */
export interface PlantState {
  x: number[];
  rotors: Pair; // V, to which the rotor speeds correspond
  pending: Pair[]; // V, asked for and delayed
  angles: number[]; // rad, as measured last
  rates: number[]; // rad/s, as estimated from these
}

/** How each axis is pushed around; the integration takes steps of at most `substep` s where there is more than (3). */
export interface Surroundings {
  pushes: Push[];
  substep: number;
}

/** The value with every range {low, high} and choice {options} in it, however deep, replaced by a draw. */
export function drawn(value: unknown, random: () => number): unknown {
  if (value === null || typeof value !== "object") return value;
  if (Array.isArray(value)) return value.map((part) => drawn(part, random));
  if ("options" in value && Array.isArray(value.options)) {
    return drawn(value.options[Math.floor(random() * value.options.length)], random);
  }
  if ("low" in value && "high" in value) {
    const { low, high } = value as { low: number; high: number };
    return low + (high - low) * random();
  }
  return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, drawn(part, random)]));
}

/** A plant in the state x, its rotors turning at the voltages u. The first rates told are the true ones. */
export function atRest(plant: Plant, x: readonly number[], u: Pair): PlantState {
  return {
    x: [...x],
    rotors: u,
    pending: Array.from({ length: plant.rotors.delay }, () => u),
    angles: encoded(plant, x),
    rates: [x[1], x[3], x[5]],
  };
}

export function measurement(state: PlantState): number[] {
  return state.angles.flatMap((angle, i) => [angle, state.rates[i]]);
}

/** The plant dt seconds later, the voltages u having been asked for at the time given. */
export function advance(
  plant: Plant,
  state: PlantState,
  asked: Pair,
  time: number,
  dt: number,
  { pushes, substep }: Surroundings,
): PlantState {
  const [u, ...pending] = [...state.pending, asked];
  const { parameters, rotors, friction, rig } = plant;
  const isPlain = rig === null && rotors.lag === 0 && friction.viscous.every((f) => f === 0) && pushes.length === 0;
  const steps = isPlain ? 1 : Math.ceil(dt / substep - 1e-9);
  const h = dt / steps;
  const kept = rotors.lag ? Math.exp((-0.5 * h) / rotors.lag) : 0;
  const later = (w: Pair): Pair => [u[0] + kept * (w[0] - u[0]), u[1] + kept * (w[1] - u[1])];
  const input = (w: Pair): Pair => virtualInput(w, parameters).map((v) => (1 - rotors.thrust_loss) * v) as Pair;

  let x = state.x;
  let start = rotors.lag ? state.rotors : u;
  for (let k = 0; k < steps; k++) {
    const [middle, end] = [later(start), later(later(start))];
    const accelerations = disturb(pushes, time + k * h, h);
    const derivative = (at: readonly number[], v: Pair) => {
      const dx = rig === null ? dynamics(at, v, parameters) : rigidDynamics(at, v, rig);
      for (let axis = 0; axis < 3; axis++) {
        dx[2 * axis + 1] += accelerations[axis] - friction.viscous[axis] * dx[2 * axis];
      }
      return dx;
    };
    x = rk4Step(derivative, x, [input(start), input(middle), input(end)], h);
    start = end;
  }
  return measure(plant, { ...state, x, rotors: start, pending }, dt);
}

/** Accelerations in the h s from a time on; a push counts for the share of them in which it is on. */
function disturb(pushes: Push[], time: number, h: number): number[] {
  const accelerations = [0, 0, 0];
  for (const push of pushes) {
    const past = (since: number) => Math.min(Math.max(since, 0), push.duration);
    const on = past(time + h - push.time) - past(time - push.time);
    accelerations[push.axis] += (push.acceleration * on) / h;
  }
  return accelerations;
}

/** What the encoders tell of the angles. */
function encoded({ sensors }: Plant, x: readonly number[]): number[] {
  return [x[0], x[2], x[4]].map((angle, i) => {
    if (sensors === null) return angle;
    const count = (2 * Math.PI) / sensors.counts[i];
    return count * Math.floor(angle / count + 0.5);
  });
}

/** The next angles, and the rates, which are the filtered difference quotients of what the encoders tell. */
function measure(plant: Plant, state: PlantState, dt: number): PlantState {
  const { x } = state;
  const angles = encoded(plant, x);
  if (plant.sensors === null) return { ...state, angles, rates: [x[1], x[3], x[5]] };
  const kept = Math.exp(-dt / plant.sensors.rate_filter);
  const rates = angles.map((angle, i) => kept * state.rates[i] + ((1 - kept) * (angle - state.angles[i])) / dt);
  return { ...state, angles, rates };
}
