// A helicopter in the air: a policy, a plant, and what it did so far. As baselines/policies.py and flight.py have it.

import { type Pair, type Parameters, hoverInput, virtualInput, voltages } from "./model";
import { type Plant, type PlantState, type Push, advance, atRest, measurement } from "./plant";
import type { Plan } from "./plan";
import { feedback } from "./regulator";

/** A tracking policy on the control grid: K + 1 states, virtual inputs in N, and gains (2 x 6) or null. */
export interface Policy {
  x: number[][];
  v: Pair[];
  gains: number[][][] | null;
}

export interface Rules {
  parameters: Parameters;
  controlPeriod: number; // s
  amplifier: Pair; // V
  pitchStop: number; // rad
  substep: number; // s
}

/** What a policy's data say of it: which feedforward it takes, and which gains. */
export interface PolicyKind {
  name: string;
  label: string;
  feedforward: "plan" | "hover";
  feedback: "none" | "tvlqr" | "hover";
}

/** A policy on the control grid of a plan that is sampled at half the control period. */
export function makePolicy(
  kind: PolicyKind,
  plan: Plan,
  tvlqr: number[][][],
  hoverGain: number[][],
  parameters: Parameters,
): Policy {
  const x = plan.x.filter((_, k) => k % 2 === 0);
  const last = plan.u.length - 1;
  // States at the start of each period, voltages in its middle: a held input is half a period late.
  const v = x.map((_, k) =>
    kind.feedforward === "plan"
      ? virtualInput(plan.u[Math.min(2 * k + 1, last)], parameters)
      : hoverInput(plan.x[last][2], parameters),
  );
  const gains = { none: null, tvlqr, hover: x.map(() => hoverGain) }[kind.feedback];
  return { x, v, gains };
}

/** One flight, control period by control period; what it was and did is kept at every step. */
export class Flight {
  readonly x: number[][];
  readonly u: Pair[] = []; // held from each step to the next
  crashed = false;
  private state: PlantState;

  constructor(
    readonly policy: Policy,
    readonly plant: Plant,
    readonly rules: Rules,
    start: readonly number[],
    hover: Pair,
  ) {
    this.state = atRest(plant, start, hover);
    this.x = [this.state.x];
  }

  /** The voltages at the motors now. */
  get rotors(): Pair {
    return this.state.rotors;
  }

  step(pushes: Push[]): void {
    if (this.crashed) return;
    const { parameters, controlPeriod, amplifier, pitchStop, substep } = this.rules;
    const { policy } = this;
    const time = (this.x.length - 1) * controlPeriod;
    const k = Math.min(this.x.length - 1, policy.x.length - 1);
    const v = policy.gains
      ? feedback(policy.v[k], policy.gains[k], measurement(this.state), policy.x[k])
      : policy.v[k];
    const u = voltages(v, parameters).map((asked) => Math.min(Math.max(asked, amplifier[0]), amplifier[1])) as Pair;
    this.state = advance(this.plant, this.state, u, time, controlPeriod, { pushes, substep });
    this.u.push(u);
    this.x.push(this.state.x);
    this.crashed = Math.abs(this.state.x[4]) > pitchStop;
  }
}
