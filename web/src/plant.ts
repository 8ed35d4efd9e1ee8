// A plant between voltage and measurement, as heli_gym/plant.py describes it. Its equations are Python's; noise and
// gusts, which no preset has, are left out.

import {
  type Parameters,
  type RigidBody,
  dynamics,
  quantise,
  rigidDynamics,
  virtualInput,
  withContact,
  withCoupling,
  withFrictionAndDisturbances,
  withLift,
} from "./equations";
import { type Model, type Pair, rk4Step, thrusts } from "./model";
import type { Curve } from "./thrust";

/** A drawn plant. Python writes the presets with ranges; `drawn` draws from them. */
export interface Plant {
  parameters: Parameters;
  rig: RigidBody | null;
  rotors: { lag: number; thrust_loss: number; slew: number | null; delay: number; gains: Pair }; // s, V/s
  friction: { viscous: number[]; coulomb: number[] };
  sensors: { counts: number[]; rate_filter: number; zeros: number[] } | null;
  disturbances: { loss: number; time: number; duration: number }[]; // drifts of the thrust
  thrust_map: Curve | { front: Curve; back: Curve } | null; // null: (2)
  hover_voltage: number | null; // V
  travel_lift: number; // 1/rad
  table: { elevation: number; friction: number } | null;
  coupling: { centrifugal: number; centre: number; spin: number; gyro: number; airflow: number };
}

/** An acceleration of one axis (0 travel, 1 elevation, 2 pitch) from a time on, for a while. */
export interface Push {
  axis: number;
  acceleration: number; // rad/s²
  time: number; // s
  duration: number; // s
}

/** All that a plant remembers of a flight. */
export interface PlantState {
  x: number[];
  motors: Pair; // V, of the amplifiers
  rotors: Pair; // V, to which the rotor speeds correspond
  arrived: Pair; // V, the latest command at the amplifiers
  pending: Pair[]; // V, delayed commands
  angles: number[]; // rad, as measured last
  rates: number[]; // rad/s, as estimated from these
}

const NO_TABLE = 1e3; // rad, an elevation that is never reached
const NEARLY = 1e-4; // control periods, within which a delay is a whole number of them

/**
 * The value with every range {low, high} and choice {options} in it, however deep, replaced by a draw.
 * Choices with the same name in `together` draw the same position; `places` are those drawn so far, in [0, 1).
 */
export function drawn(value: unknown, random: () => number, places = new Map<unknown, number>()): unknown {
  if (value === null || typeof value !== "object") return value;
  if (Array.isArray(value)) return value.map((part) => drawn(part, random, places));
  if ("options" in value && Array.isArray(value.options)) {
    const { options, together } = value as { options: unknown[]; together?: string };
    const place = (together ? places.get(together) : undefined) ?? random();
    if (together) places.set(together, place);
    return drawn(options[Math.floor(place * options.length)], random, places);
  }
  if ("low" in value && "high" in value) {
    const { low, high } = value as { low: number; high: number };
    return low + (high - low) * random();
  }
  return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, drawn(part, random, places)]));
}

/** The coefficients and thrust curves of a plant. */
export function modelOf({ parameters, thrust_map }: Plant): Model {
  const quadratic = { k_plus: parameters.k_plus, k_minus: parameters.k_minus, exponent: 2, dead_zone: 0 };
  const map = thrust_map ?? quadratic;
  return { ...parameters, ...("front" in map ? map : { front: map, back: map }) };
}

function isCoupled({ coupling }: Plant): boolean {
  return Object.values(coupling).some((value) => value !== 0);
}

/** A plant with what follows from it. */
export interface Prepared {
  plant: Plant;
  model: Model;
  shares: Pair; // of each rotor's thrust
  periods: number; // whole control periods of delay
  rest: number; // s, of the delay beyond these
  steps: (isPushed: boolean) => number;
}

/** What follows from a plant; the integration takes steps of at most `substep` s where there is more than (3). */
export function prepared(plant: Plant, period: number, substep: number): Prepared {
  const { rotors, friction, parameters, sensors } = plant;
  const model = modelOf(plant);
  let scale = 1 - rotors.thrust_loss;
  if (plant.hover_voltage) {
    const [front, back] = thrusts([plant.hover_voltage, plant.hover_voltage], model);
    scale *= -parameters.a2 / (parameters.b2 * (front + back));
  }
  const periods = Math.floor(rotors.delay / period + NEARLY);
  const over = Math.max(rotors.delay - period * periods, 0);
  const rest = over > NEARLY * period ? over : 0;
  const isPlain =
    plant.rig === null && rotors.thrust_loss === 0 && rotors.delay === 0 && rotors.gains.every((gain) => gain === 1) &&
    [...friction.viscous, ...friction.coulomb].every((f) => f === 0) && plant.thrust_map === null && !plant.table &&
    plant.travel_lift === 0 && !isCoupled(plant) && plant.disturbances.length === 0 && !sensors?.zeros.some((zero) => zero !== 0);
  const shares: Pair = [scale * rotors.gains[0], scale * rotors.gains[1]];
  return { plant, model, shares, periods, rest, steps: (isPushed) => (isPlain && !isPushed ? 1 : Math.ceil(period / substep - 1e-9)) };
}

/** A plant in the state x, its rotors turning at the voltages u. The first rates are the true ones. */
export function atRest({ plant, periods }: Prepared, x: readonly number[], u: Pair): PlantState {
  return {
    x: [...x],
    motors: u,
    rotors: u,
    arrived: u,
    pending: Array.from({ length: periods }, () => u),
    angles: measuredAngles(plant, x),
    rates: [x[1], x[3], x[5]],
  };
}

export function measurement(state: PlantState): number[] {
  return state.angles.flatMap((angle, i) => [angle, state.rates[i]]);
}

/** The plant dt seconds later, commanded at the given time. */
export function advance(
  { plant, model, shares, rest, steps }: Prepared,
  state: PlantState,
  command: Pair,
  time: number,
  dt: number,
  pushes: Push[],
  isPushed = pushes.length > 0, // at any time of the flight
): PlantState {
  const { rotors, friction, rig, table } = plant;
  const count = steps(isPushed);
  const contact = table ? [table.elevation, table.friction] : [NO_TABLE, 0];
  const { centrifugal, centre, spin, gyro, airflow } = plant.coupling;
  const coupling = isCoupled(plant) && [centrifugal, centre, spin, gyro, airflow];
  const [arriving, ...pending] = [...state.pending, command];
  let { x, motors, rotors: speeds } = state;

  /** Flies a part of the period in `count` steps, with the command u at the amplifiers. */
  function fly(u: Pair, since: number, duration: number): void {
    const most = rotors.slew === null ? Infinity : rotors.slew * duration;
    motors = u.map((volts, i) => Math.min(Math.max(volts, motors[i] - most), motors[i] + most)) as Pair;
    const h = duration / count;
    const decay = rotors.lag ? Math.exp((-0.5 * h) / rotors.lag) : 0;
    const later = (w: Pair): Pair => [motors[0] + decay * (w[0] - motors[0]), motors[1] + decay * (w[1] - motors[1])];
    if (!rotors.lag) speeds = motors;
    for (let k = 0; k < count; k++) {
      const [middle, end] = [later(speeds), later(later(speeds))];
      const now = since + k * h;
      const torques = [...disturb(pushes, now, h), 0];
      const effect = plant.disturbances.reduce(
        (left, { loss, time: begin, duration: over }) => left * (1 - loss * Math.min(Math.max((now - begin + 0.5 * h) / over, 0), 1)), 1);
      const input = (w: Pair): Pair => {
        const [front, back] = thrusts(w, model);
        return virtualInput([shares[0] * effect * front, shares[1] * effect * back]);
      };
      const derivative = (at: readonly number[], v: Pair) => {
        const free = rig === null ? dynamics(at, v, plant.parameters) : rigidDynamics(at, v, rig);
        const dx = withFrictionAndDisturbances(at, free, friction.viscous, friction.coulomb, torques);
        if (!table && plant.travel_lift === 0 && !coupling) return dx;
        const lifted = withLift(withContact(at, dx, plant.parameters, contact), plant.travel_lift);
        return coupling ? withCoupling(at, lifted, Math.abs(at[1]), plant.parameters, coupling) : lifted;
      };
      x = rk4Step(derivative, x, [input(speeds), input(middle), input(end)], h);
      speeds = end;
    }
  }

  if (rest > 0) fly(state.arrived, time, rest); // what arrived last stays until the next arrives
  fly(arriving, time + rest, dt - rest);
  return measure(plant, { ...state, x, motors, rotors: speeds, arrived: arriving, pending }, dt);
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

/** What the encoders read of the angles. */
function measuredAngles({ sensors }: Plant, x: readonly number[]): number[] {
  return [x[0], x[2], x[4]].map((angle, i) => (sensors === null ? angle : quantise(angle - sensors.zeros[i], sensors.counts[i])));
}

/** The next angles, and the rates, which are the filtered difference quotients of the encoders' angles. */
function measure(plant: Plant, state: PlantState, dt: number): PlantState {
  const { x } = state;
  const angles = measuredAngles(plant, x);
  if (plant.sensors === null) return { ...state, angles, rates: [x[1], x[3], x[5]] };
  const decay = Math.exp(-dt / plant.sensors.rate_filter);
  const rates = angles.map((angle, i) => decay * state.rates[i] + ((1 - decay) * (angle - state.angles[i])) / dt);
  return { ...state, angles, rates };
}
