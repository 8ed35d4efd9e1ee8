// The reader's choices in the address, so that a link shows a flight.

import { EFFECTS, EFFECT_NAMES, type LiveData, type Setup, WEIGHTS, initialSetup, rigOf, snapped } from "./experiment";

/** The choices that differ from those of a page that has just been opened, and the policies that are shown. */
export function toHash(setup: Setup, shown: string[], data: LiveData): string {
  const initial = initialSetup(data, rigOf(data, setup.rig));
  const parts = new URLSearchParams();
  const put = (name: string, value: unknown, other: unknown) => {
    if (`${value}` !== `${other}`) parts.set(name, `${value}`);
  };
  put("rig", setup.rig, data.rigs[0].name);
  put("plan", setup.method, initial.method);
  put("T", setup.duration ?? "fastest", initial.duration);
  put("pitch", setup.pitchLimit, initial.pitchLimit);
  put("window", setup.window.join("~"), initial.window.join("~"));
  put("off", setup.startOff, initial.startOff);
  put("plant", setup.plant, initial.plant);
  put("draw", setup.draw, initial.draw);
  for (const name of EFFECT_NAMES) if (setup.effects[name] !== undefined) parts.set(name, `${setup.effects[name]}`);
  put("weights", WEIGHTS.map((name) => setup.weights[name]).join("~"), WEIGHTS.map(() => 0).join("~"));
  put("show", shown.join("~"), shownAtFirst(data).join("~"));
  const text = parts.toString();
  return text ? `#${text}` : "";
}

export const shownAtFirst = (data: LiveData) => data.policies.filter(({ shown }) => shown).map(({ name }) => name);

const clamped = (value: number, min: number, max: number) => Math.min(Math.max(value, min), max);

/** The choices and policies of an address: the nearest that the page offers; whatever is missing or no number is as at first. */
export function fromHash(hash: string, data: LiveData): { setup: Setup; shown: string[] } {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const initial = initialSetup(data, rigOf(data, parts.get("rig") ?? ""));
  const number = (name: string, otherwise: number) => {
    const value = Number(parts.get(name)?.trim() || Number.NaN); // an empty text would be 0
    return Number.isFinite(value) ? value : otherwise;
  };
  const numbers = (name: string, length: number) => {
    const values = (parts.get(name) ?? "").split("~").map(Number);
    return values.length === length && values.every(Number.isFinite) ? values : null;
  };
  const powers = numbers("weights", WEIGHTS.length) ?? WEIGHTS.map(() => 0);
  const setup: Setup = {
    ...initial,
    method: parts.get("plan") === "spline" ? "spline" : parts.get("plan") === "paper" ? "paper" : initial.method,
    duration: parts.get("T") === "fastest" ? null : number("T", initial.duration ?? Number.NaN) || initial.duration,
    pitchLimit: number("pitch", initial.pitchLimit),
    window: (numbers("window", 2) as Setup["window"] | null) ?? initial.window,
    startOff: number("off", initial.startOff),
    plant: parts.get("plant") ?? initial.plant,
    draw: Math.max(1, Math.round(number("draw", initial.draw))),
    effects: Object.fromEntries(
      EFFECT_NAMES.map((name) => [name, number(name, Number.NaN)] as const)
        .filter(([, value]) => Number.isFinite(value))
        .map(([name, value]) => [name, clamped(value, EFFECTS[name].min, EFFECTS[name].max)]),
    ),
    weights: Object.fromEntries(WEIGHTS.map((name, i) => [name, clamped(powers[i], -2, 2)])) as Setup["weights"],
  };
  const names = data.policies.map(({ name }) => name);
  const shown = parts.has("show") ? parts.get("show")!.split("~").filter((name) => names.includes(name)) : shownAtFirst(data);
  return { setup: snapped(setup, data), shown };
}
