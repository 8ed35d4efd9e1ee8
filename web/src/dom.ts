// What both pages build their elements with.

import { swatch } from "./marks";

type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

/** An element; attributes that are functions listen to the event of their name. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (typeof value === "boolean") element.toggleAttribute(name, value);
    else element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

export const deg = (rad: number) => (rad * 180) / Math.PI;
export const rad = (degrees: number) => (degrees * Math.PI) / 180;

/** A number with a true minus sign. */
export const shown = (value: number, digits: number) => value.toFixed(digits).replace(/^-(?=.*[1-9])/, "\u2212").replace(/^-/, "");

/** A colour of the style sheet, as it is now: it follows the reader's preference for light or dark. */
export function themed(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** Whether the page is being printed: pictures then stay as they were drawn for the screen. */
export const printing = () => matchMedia("print").matches;

/** Draws everything before printing, and gives a stage the proportions that it has on the screen. */
export function onPrint(stage: HTMLElement, drawAll: () => void): void {
  window.addEventListener("beforeprint", () => {
    stage.style.setProperty("--aspect", `${stage.clientWidth} / ${stage.clientHeight}`);
    stage.style.setProperty("--columns", `${getComputedStyle(stage).gridTemplateColumns.split(" ").length}`);
    drawAll();
  });
}

/** Calls back when the reader's preference for light or dark changes, and for printing, which is always light. */
export function onTheme(change: () => void): void {
  for (const query of ["(prefers-color-scheme: dark)", "print"]) matchMedia(query).addEventListener("change", change);
}

/** Whether a key belongs to the control that has the focus. */
export function isForControl(event: KeyboardEvent): boolean {
  const focused = event.target as HTMLElement;
  if (event.ctrlKey || event.metaKey || event.altKey) return true;
  if (focused.matches("select, textarea, input[type=text]")) return true;
  if (focused.matches("input[type=range], input[type=radio], [role=slider], [role=application], .scroll")) {
    return /^(Arrow|Home|End|Page|[-+=0])/.test(event.key);
  }
  return focused.matches("button, summary, a, input") && [" ", "Enter"].includes(event.key);
}

/** A table of keys and what they do, that a button unfolds. */
export function keyHelp(keys: [string, string][]): HTMLElement {
  const rows = keys.flatMap(([key, what]) => [
    make("dt", {}, ...key.split(" ").map((part) => make("kbd", {}, part))),
    make("dd", {}, what),
  ]);
  return make("details", { class: "help" }, make("summary", {}, "Keyboard"), make("dl", {}, ...rows));
}

/** A wide element that scrolls sideways by itself, with a hint where there is more of it than fits. */
export function scrollable(label: string, content: HTMLElement): HTMLElement {
  const box = make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, content);
  const hint = make("p", { class: "small hint", hidden: true }, "Scroll sideways for all columns →");
  new ResizeObserver(() => (hint.hidden = box.scrollWidth <= box.clientWidth + 1)).observe(box);
  return make("div", {}, hint, box);
}

/** Counts frames, and the time that scripts take in them, which it shows once a second. */
export class FrameMeter {
  readonly element = make("span", { class: "meter" });
  private frames = 0;
  private busy = 0;
  private since = performance.now();

  measure(frame: () => void): void {
    const began = performance.now();
    frame();
    queueMicrotask(() => this.count(began)); // after the plots, which draw in microtasks
  }

  private count(began: number): void {
    const now = performance.now();
    this.busy += now - began;
    this.frames += 1;
    if (now - this.since >= 1000) {
      const rate = (1000 * this.frames) / (now - this.since);
      const script = this.busy / this.frames;
      this.element.textContent = `${rate.toFixed(0)} frames/s, ${script.toFixed(1)} ms of script each`;
      Object.assign(this.element.dataset, { rate, script });
      [this.frames, this.busy, this.since] = [0, 0, now];
    }
  }
}

/** The label and the numbers over one helicopter, and the rectangle in which the stage draws it. */
export class View {
  readonly element: HTMLElement;
  private readonly numbers = ["travel", "elevation", "pitch", "front", "back"].map((name) => make("span", { title: name }));
  private readonly note = make("div", { class: "note" });

  constructor(label: string, colour: string, index: number) {
    const name = make("div", { class: "name" }, swatch(index, colour), label);
    this.element = make("div", { class: "view" }, name, this.note, make("div", { class: "numbers" }, ...this.numbers));
  }

  show(x: readonly number[], u: readonly number[], note: string): void {
    [x[0], x[2], x[4]].forEach((angle, i) => this.write(i, `${shown(deg(angle), 1)}°`));
    u.forEach((volts, i) => this.write(3 + i, `${shown(volts, 1)} V`));
    this.note.textContent = note;
    this.note.hidden = note === "";
  }

  private write(i: number, value: string): void {
    const text = `${this.numbers[i].title} ${value}`;
    if (this.numbers[i].textContent !== text) this.numbers[i].textContent = text;
  }
}
