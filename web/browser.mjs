// Opens pages in headless Chromium and runs scripts on them: each line of the input describes a page and a script in
// JSON, and each line of the output is the answer. One Chromium serves all; every page has a context of its own.

import { createInterface } from "node:readline";
import { chromium } from "playwright-core";

const quiet = ["disable-quic", "no-first-run", "disable-background-networking", "disable-component-update", "disable-sync"];
const software = ["use-gl=angle", "use-angle=swiftshader", "enable-unsafe-swiftshader"]; // WebGL without a GPU
const args = ["no-sandbox", "disable-gpu", ...quiet, ...software].map((name) => `--${name}`);
let browser;

async function answer({ url, width, height, script, executable }) {
  browser ??= await chromium.launch({ executablePath: executable, headless: true, args });
  const context = await browser.newContext({ viewport: { width, height } });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(600_000); // pictures are slow to draw without a GPU
    const errors = [];
    const requests = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(error.stack));
    page.on("request", (request) => /^https?:/.test(request.url()) && requests.push(request.url()));
    await page.goto(url);
    const run = Object.getPrototypeOf(async () => {}).constructor("page", script);
    return { result: await run(page), errors, requests };
  } catch (error) {
    return { failure: error.stack };
  } finally {
    await context.close();
  }
}

for await (const line of createInterface({ input: process.stdin })) {
  process.stdout.write(`${JSON.stringify(await answer(JSON.parse(line)))}\n`);
}
await browser?.close();
