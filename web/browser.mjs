// Opens a page in headless Chromium and runs a script on it; the tests describe both in JSON, and read the answer.

import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const { url, width, height, script, executable } = JSON.parse(readFileSync(0, "utf8"));
const profile = mkdtempSync(join(tmpdir(), "heli-browser-"));
const quiet = ["disable-quic", "no-first-run", "disable-background-networking", "disable-component-update", "disable-sync"];
const software = ["use-gl=angle", "use-angle=swiftshader", "enable-unsafe-swiftshader"]; // WebGL without a GPU
const context = await chromium.launchPersistentContext(profile, {
  executablePath: executable,
  headless: true,
  args: ["no-sandbox", "disable-gpu", ...quiet, ...software].map((name) => `--${name}`),
  viewport: { width, height },
});
try {
  const page = context.pages()[0] ?? (await context.newPage());
  page.setDefaultTimeout(120_000); // pictures are slow to draw without a GPU
  const errors = [];
  const requests = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(error.stack));
  page.on("request", (request) => /^https?:/.test(request.url()) && requests.push(request.url()));
  await page.goto(url);
  const run = Object.getPrototypeOf(async () => {}).constructor("page", script);
  const result = await run(page);
  process.stdout.write(JSON.stringify({ result, errors, requests }));
} finally {
  await context.close();
  rmSync(profile, { recursive: true, force: true });
}
