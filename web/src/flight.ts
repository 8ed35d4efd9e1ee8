// A helicopter in the air: a controller, a plant, and what it did so far. As baselines/evaluation/rollout.py has it.

import { type Pair, clip } from "./model";
import { type Plant, type PlantState, type Prepared, type Push, advance, atRest, measurement, prepared } from "./plant";
import type { Controller } from "./policies";

export interface Rules {
  controlPeriod: number; // s
  amplifier: Pair; // V
  pitchStop: number; // rad
  substep: number; // s
}

/** One flight, control period by control period; states and voltages of every step are stored. */
export class Flight {
  readonly x: number[][];
  readonly u: Pair[] = []; // held from each step to the next
  crashed = false;
  private state: PlantState;
  private readonly ready: Prepared;

  constructor(
    readonly controller: Controller,
    readonly plant: Plant,
    readonly rules: Rules,
    start: readonly number[],
    hover: Pair,
  ) {
    this.ready = prepared(plant, rules.controlPeriod, rules.substep);
    this.state = atRest(this.ready, start, hover);
    this.x = [this.state.x];
  }

  /** The voltages at the motors now. */
  get rotors(): Pair {
    return this.state.rotors;
  }

  step(pushes: Push[]): void {
    if (this.crashed) return;
    const { controlPeriod, amplifier, pitchStop } = this.rules;
    const k = this.x.length - 1;
    const command = this.controller.voltages(k, measurement(this.state));
    const u = command.map((volts) => clip(volts, amplifier)) as Pair;
    const [from, to] = [k * controlPeriod, (k + 1) * controlPeriod];
    const now = pushes.filter(({ time, duration }) => time < to && time + duration > from);
    this.state = advance(this.ready, this.state, u, from, controlPeriod, now, pushes.length > 0);
    this.u.push(u);
    this.x.push(this.state.x);
    this.crashed = Math.abs(this.state.x[4]) > pitchStop;
  }
}
