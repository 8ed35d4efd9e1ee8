// Guided tasks: each sets the page up, and checks by itself whether its goals are reached by the flights that end.

import { EFFECT_NAMES, Experiment, type LiveData, type Setup, durationOf, effectsOf, gridOf, rigOf } from "./experiment";
import { make, shown } from "./dom";
import type { Flight } from "./flight";

/** A flight of all shown policies that has reached its end. */
export interface Completed {
  experiment: Experiment;
  flights: Record<string, Flight>;
  wasPushed: boolean;
}

interface Goal {
  text: string;
  isReached: (seen: Completed[], data: LiveData) => boolean;
}

export interface GuidedTask {
  id: string;
  title: string;
  text: string;
  setup: Partial<Setup>; // in addition to the paper's values
  policies: string[]; // that are shown
  goals: Goal[];
  /** What the flights so far show, in figures. */
  report: (seen: Completed[], data: LiveData) => string;
  lesson: string; // shown when all goals are reached
}

export const ARRIVED = 2; // deg, when the plan ends
const MISSED = 30; // deg, likewise
const PAPER = "feedforward+tvlqr";
const BETTER = 0.95; // of the paper's error, to count as better

const arrives = ({ experiment, flights }: Completed, policy: string) => policy in flights && experiment.endError(flights[policy]) <= ARRIVED;
const calm = (seen: Completed[]) => seen.filter(({ wasPushed, experiment }) => !wasPushed && !experiment.log);
const error = ({ experiment, flights }: Completed, policy: string) => {
  const value = experiment.rmsError(flights[policy]);
  return Number.isFinite(value) ? `${shown(value, 2)}°` : "no arrival";
};
const seconds = ({ experiment }: Completed, data: LiveData) => `${(durationOf(experiment.setup, data) ?? Number.NaN).toFixed(2)} s`;

/** Whether the plan is the fastest one of its pitch limit that the policy arrives with, in any of the windows. */
function isFastestThatArrives({ experiment }: Completed, policy: string, data: LiveData): boolean {
  const { setup } = experiment;
  const own = durationOf(setup, data)!;
  const { durations, windows } = gridOf(rigOf(data, setup.rig), setup.method);
  const faster = windows
    .flatMap((window) => durations.map((duration) => ({ ...setup, window, duration })))
    .map((other) => ({ other, takes: durationOf(other, data) ?? Infinity }))
    .filter(({ takes }) => takes < own - 1e-6)
    .sort((a, b) => b.takes - a.takes); // those that are likely to arrive first
  return !faster.some(({ other }) => {
    const tried = Experiment.make(other, data);
    const flight = tried?.fly(policy);
    return tried && flight && tried.endError(flight) <= ARRIVED;
  });
}

/** What alone distinguishes a flight from the plan: names of effects, or the start. */
function deviations({ experiment }: Completed): string[] {
  const effects = effectsOf(experiment.plant);
  const found = EFFECT_NAMES.filter((name) => Math.abs(effects[name]) > 1e-9) as string[];
  return experiment.setup.startOff > 0 ? [...found, "start"] : found;
}

const openLoopMisses = (seen: Completed[]) =>
  new Set(
    calm(seen)
      .filter((flight) => "open-loop" in flight.flights && flight.experiment.endError(flight.flights["open-loop"]) > MISSED)
      .map(deviations)
      .filter((names) => names.length === 1)
      .flat(),
  );

const pairsWithReserve = (seen: Completed[]) => {
  const flown = calm(seen).filter(({ flights }) => PAPER in flights);
  return flown.flatMap((wide) =>
    flown.flatMap((narrow) => {
      const [a, b] = [wide.experiment.setup, narrow.experiment.setup];
      const same = JSON.stringify({ ...a, window: 0, method: 0 }) === JSON.stringify({ ...b, window: 0, method: 0 });
      return same && b.window[0] > a.window[0] && b.window[1] < a.window[1] ? [[wide, narrow] as const] : [];
    }),
  );
};

export const TASKS: GuidedTask[] = [
  {
    id: "fastest",
    title: "Find the fastest plan that arrives on lab",
    text: "The fastest plan uses all of the voltage, and a real plant has lag, friction and weaker rotors. Change duration and voltage window: with which plan is the paper's controller within 2° of the goal the soonest, at the moment when the plan ends?",
    setup: { method: "spline", duration: 10, pitchLimit: 50, window: [0, 12], plant: "lab", draw: 2, startOff: 3 },
    policies: [PAPER],
    goals: [
      { text: "Fly a plan that arrives", isReached: (seen) => calm(seen).some((flight) => arrives(flight, PAPER)) },
      { text: "Fly one that does not", isReached: (seen) => calm(seen).some((flight) => PAPER in flight.flights && !arrives(flight, PAPER)) },
      {
        text: "Fly the fastest that arrives, of all windows",
        isReached: (seen, data) =>
          calm(seen).some((flight) => flight.experiment.setup.plant === "lab" && flight.experiment.setup.pitchLimit === 50 && arrives(flight, PAPER) && isFastestThatArrives(flight, PAPER, data)),
      },
    ],
    report: (seen, data) =>
      calm(seen)
        .slice(-4)
        .map((flight) => `${seconds(flight, data)}, ${flight.experiment.setup.window.join(" to ")} V: ${shown(flight.experiment.endError(flight.flights[PAPER]), 1)}° off`)
        .join("; "),
    lesson: "A plan with a reserve may arrive sooner than a faster one without: feedback takes voltage too. Try another draw.",
  },
  {
    id: "open-loop",
    title: "Why does the open loop fail?",
    text: "The plan is exact for equation (3). See that its voltages alone arrive on the nominal plant from the right start. Then change one thing only, and find two different things, each of which alone takes the open loop more than 30° off.",
    setup: { method: "paper", duration: 10, pitchLimit: 50, window: [1, 11], plant: "nominal", startOff: 0 },
    policies: ["open-loop"],
    goals: [
      {
        text: "Open loop on the nominal plant from the right start: it arrives",
        isReached: (seen) => calm(seen).some((flight) => deviations(flight).length === 0 && arrives(flight, "open-loop")),
      },
      { text: "One thing alone makes it miss", isReached: (seen) => openLoopMisses(seen).size >= 1 },
      { text: "A second one does too", isReached: (seen) => openLoopMisses(seen).size >= 2 },
    ],
    report: (seen) => {
      const found = [...openLoopMisses(seen)];
      return found.length ? `Alone enough: ${found.join(", ")}.` : "";
    },
    lesson: "Nothing pulls the travel back: an acceleration that is slightly wrong is integrated twice. Feedback (51) closes that gap.",
  },
  {
    id: "reserve",
    title: "What does the reserve buy?",
    text: "Plan twice with the same duration: once with all of the voltage (0 to 12 V), once with a reserve (1 to 11 V). Fly both on lab with the paper's controller, and compare the errors.",
    setup: { method: "spline", duration: 8.5, pitchLimit: 50, window: [0, 12], plant: "lab", draw: 1, startOff: 3 },
    policies: [PAPER],
    goals: [
      { text: "Fly a plan without reserve", isReached: (seen) => calm(seen).some(({ experiment, flights }) => PAPER in flights && experiment.setup.window.join() === experiment.rig.amplifier.join()) },
      { text: "Fly one with a reserve, all else equal", isReached: (seen) => pairsWithReserve(seen).length > 0 },
      {
        text: "Find a duration at which the reserve changes the error by more than a tenth",
        isReached: (seen) =>
          pairsWithReserve(seen).some(([wide, narrow]) => {
            const [a, b] = [wide, narrow].map(({ experiment, flights }) => experiment.rmsError(flights[PAPER]));
            return Math.abs(a - b) > 0.1 * Math.min(a, b);
          }),
      },
    ],
    report: (seen) =>
      pairsWithReserve(seen)
        .slice(-2)
        .map(([wide, narrow]) =>
          [wide, narrow]
            .map((flight) => {
              const { experiment, flights } = flight;
              return `${experiment.setup.window.join(" to ")} V: ${error(flight, PAPER)} RMS, ${shown(100 * experiment.saturation(flights[PAPER]), 0)} % of the time at the amplifier's limits`;
            })
            .join("; "),
        )
        .join(". "),
    lesson: "A plan inside its limits leaves voltage to the feedback, which would otherwise saturate. The price is a longer fastest plan.",
  },
  {
    id: "weights",
    title: "Beat the paper's controller with your weights",
    text: "Both fly the same feedforward. Change the weights of (49), and track travel and elevation on lab with an RMS error at least 5 % smaller than that of the paper's controller.",
    setup: { method: "paper", duration: 10, pitchLimit: 50, window: [1, 11], plant: "lab", draw: 1, startOff: 3 },
    policies: [PAPER, "yours"],
    goals: [
      {
        text: "Fly your weights next to the paper's",
        isReached: (seen) => calm(seen).some(({ flights, experiment }) => PAPER in flights && "yours" in flights && Object.values(experiment.setup.weights).some((power) => power !== 0)),
      },
      {
        text: "Error at least 5 % smaller",
        isReached: (seen) =>
          calm(seen).some(({ flights, experiment }) => PAPER in flights && "yours" in flights && experiment.setup.plant === "lab" && experiment.rmsError(flights.yours) < BETTER * experiment.rmsError(flights[PAPER])),
      },
    ],
    report: (seen) =>
      calm(seen)
        .filter(({ flights }) => PAPER in flights && "yours" in flights)
        .slice(-3)
        .map((flight) => `yours ${error(flight, "yours")}, the paper's ${error(flight, PAPER)}`)
        .join("; "),
    lesson: "Stiffer is better only until lag and delay answer: more weight on travel makes the pitch swing. The gains are below.",
  },
];

/** The list of tasks with their goals. */
export class TaskList {
  readonly element: HTMLElement;
  private readonly goals: HTMLElement[][] = [];
  private readonly notes: { report: HTMLElement; lesson: HTMLElement }[] = [];
  private readonly seen: Completed[][] = TASKS.map(() => []);
  private readonly reached = TASKS.map(({ goals }) => goals.map(() => false));
  private active = -1;

  constructor(private readonly data: LiveData, begin: (task: GuidedTask) => void) {
    const items = TASKS.map((task, i) => {
      this.goals.push(task.goals.map(({ text }) => make("li", {}, text)));
      this.notes.push({ report: make("p", { class: "small" }), lesson: make("p", { class: "lesson", hidden: true }, task.lesson) });
      const start = make("button", { "data-task": task.id, click: () => {
        this.active = i;
        this.seen[i] = [];
        begin(task);
      } }, "set it up");
      const { report, lesson } = this.notes[i];
      return make("details", { class: "task", name: "task" }, make("summary", {}, task.title), make("p", { class: "small" }, task.text), start,
        make("ul", { class: "goals" }, ...this.goals[i]), make("div", { role: "status" }, report, lesson));
    });
    this.element = make("div", { class: "tasks" }, ...items);
  }

  /** Takes note of flights that have reached their end, for the task that was begun last. */
  complete(flights: Completed): void {
    if (this.active < 0) return;
    const [task, i] = [TASKS[this.active], this.active];
    this.seen[i].push(flights);
    task.goals.forEach(({ isReached }, n) => {
      this.reached[i][n] ||= isReached(this.seen[i], this.data);
      this.goals[i][n].classList.toggle("done", this.reached[i][n]);
    });
    this.notes[i].report.textContent = task.report(this.seen[i], this.data);
    this.notes[i].lesson.hidden = !this.reached[i].every(Boolean);
  }
}
