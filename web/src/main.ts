// The program of the report and of the live page, which share it. Loaded without a document, it only offers the model.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import { showLive } from "./live";
import { showReport } from "./report";

export * from "./controllers";
export * from "./experiment";
export * from "./files";
export * from "./link";
export * from "./tasks";
export * from "./equations";
export * from "./flight";
export * from "./model";
export * from "./plan";
export * from "./plant";
export * from "./policies";
export * from "./residual";
export * from "./spline";
export * from "./thrust";
export * from "./tvlqr";

if (typeof document !== "undefined") {
  const data = JSON.parse(document.getElementById("data")!.textContent!);
  const main = document.querySelector("main")!;
  if (document.body.dataset.kind === "live") showLive(data, main);
  else showReport(data, main);
}
