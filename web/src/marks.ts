// How lines differ without colour: each policy has a marker and a dash pattern, the same in plots and legends.

import { svg } from "./svg";

/** Outlines in a square from -1 to 1. */
const SHAPES = [
  "M-0.9,0 A0.9,0.9 0 1 0 0.9,0 A0.9,0.9 0 1 0 -0.9,0 Z",
  "M-0.8,-0.8 H0.8 V0.8 H-0.8 Z",
  "M0,-1 L0.95,0.75 H-0.95 Z",
  "M0,-1.1 L1.1,0 L0,1.1 L-1.1,0 Z",
  "M0,1 L0.95,-0.75 H-0.95 Z",
  "M-0.35,-1 H0.35 V-0.35 H1 V0.35 H0.35 V1 H-0.35 V0.35 H-1 V-0.35 H-0.35 Z",
];
const DASHES: number[][] = [[], [9, 3], [2, 3], [9, 3, 2, 3], [5, 3], [12, 4, 2, 4, 2, 4]];

export const shapeOf = (index: number) => SHAPES[index % SHAPES.length];
export const dashOf = (index: number) => DASHES[index % DASHES.length];

/** The marker of a policy as a small picture; `name` is its text alternative, empty where the name stands next to it. */
export function swatch(index: number, colour: string, name = ""): SVGElement {
  const hidden: Record<string, string> = name ? { role: "img", "aria-label": name } : { "aria-hidden": "true" };
  const picture = svg("svg", { viewBox: "-1.3 -1.3 2.6 2.6", class: "swatch", ...hidden });
  picture.append(svg("path", { d: shapeOf(index), fill: colour }));
  return picture;
}
