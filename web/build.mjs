// Bundles src/ into ../baselines/evaluation/web/. The first line of heli.js names the sources that it was made of.

import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { build } from "esbuild";

const inputs = ["build.mjs", "package-lock.json", ...readdirSync("src").map((name) => `src/${name}`)].sort();
const hash = createHash("sha256");
for (const name of inputs) hash.update(`${name}\n`).update(readFileSync(name)).update("\n");

const licences = ["three", "uplot"].map((name) => `/* ${name}\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim()}\n*/`);

await build({
  entryPoints: { heli: "src/main.ts" },
  outdir: process.argv[2] ?? "../baselines/evaluation/web",
  bundle: true,
  minify: true,
  format: "iife",
  globalName: "heli",
  target: "es2022",
  legalComments: "none",
  banner: { js: `// built from web/, sources sha256:${hash.digest("hex")}` },
  footer: { js: licences.join("\n") },
});
