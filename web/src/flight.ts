// A helicopter in the air: a controller, a plant, and what it did so far. As baselines/evaluation/rollout.py has it.

import { type Pair, clip } from "./model";
import { type Plant, type PlantState, type Push, advance, atRest, measurement } from "./plant";
import type { Controller } from "./policies";

export interface Rules {
  controlPeriod: number; // s
  amplifier: Pair; // V
  pitchStop: number; // rad
  substep: number; // s
}

/** One flight, control period by control period; what it was and did is kept at every step. */
export class Flight {
  readonly x: number[][];
  readonly u: Pair[] = []; // held from each step to the next
  crashed = false;
  private state: PlantState;

  constructor(
    readonly controller: Controller,
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
    const { controlPeriod, amplifier, pitchStop, substep } = this.rules;
    const k = this.x.length - 1;
    const asked = this.controller.voltages(k, measurement(this.state));
    const u = asked.map((volts) => clip(volts, amplifier)) as Pair;
    this.state = advance(this.plant, this.state, u, k * controlPeriod, controlPeriod, { pushes, substep });
    this.u.push(u);
    this.x.push(this.state.x);
    this.crashed = Math.abs(this.state.x[4]) > pitchStop;
  }
}
