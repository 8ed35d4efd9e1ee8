// Equations in MathML, from a line of text: symbols with _ and ^ for what is below and above, separated by spaces.

import { make } from "./dom";

const NS = "http://www.w3.org/1998/Math/MathML";

function element(tag: string, ...children: (Node | string)[]): Element {
  const made = document.createElementNS(NS, tag);
  made.append(...children);
  return made;
}

function symbol(text: string): Element {
  if (/^[\d.]+$/.test(text)) return element("mn", text);
  if (/^[\p{L}\p{M}]+$/u.test(text)) return element("mi", text);
  const operator = element("mo", text);
  operator.setAttribute("stretchy", "false");
  return operator;
}

/** A little space, as around the name of a function. */
function space(): Element {
  const made = element("mspace");
  made.setAttribute("width", "0.17em");
  return made;
}

/** For example "q̈_1 = b_1 cos q_2 sin q_3 v_1 − c_1 q̇_1". */
export function equation(text: string): HTMLElement {
  const parts = text.split(" ").flatMap((part) => {
    if (/^(sin|cos|sgn)$/.test(part)) return [space(), element("mi", part), space()];
    const [, base, below, above] = /^([^_^]+)(?:_([^^]+))?(?:\^(.+))?$/.exec(part)!;
    if (below && above) return element("msubsup", symbol(base), symbol(below), symbol(above));
    if (below) return element("msub", symbol(base), symbol(below));
    return above ? element("msup", symbol(base), symbol(above)) : symbol(base);
  });
  const math = element("math", element("mrow", ...parts));
  math.setAttribute("display", "block");
  return make("div", { class: "equation" }, math);
}
