// A page in Chromium, and whatever it does that no page may do.
//
// One Chromium for each test file. It finds no host at all, so that nothing of a test can come from
// the network; what a page asks for is noted all the same.
import { createRequire } from "node:module";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromiumExecutable, modules, screenshots } from "./places.mjs";

const require = createRequire(`${modules}/`);
const { chromium } = require("playwright-core");
const { source: axeSource } = require("axe-core");

export const desktop = 1280;
export const phone = 380;

// Without its sandbox, which root has not and many containers forbid: it opens files of ours only.
export function startBrowser() {
  return chromium.launch({
    executablePath: chromiumExecutable,
    chromiumSandbox: false,
    args: [
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
      "--host-resolver-rules=MAP * ~NOTFOUND",
    ],
  });
}

function noteFaults(page, url) {
  const faults = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") {
      faults.push(`console: ${message.text()}`);
    }
  });
  page.on("pageerror", (error) => faults.push(`uncaught: ${error.message}`));
  page.on("dialog", async (dialog) => {
    faults.push(`dialog: ${dialog.message()}`);
    await dialog.dismiss();
  });
  page.on("request", (request) => {
    const asked = request.url();
    const own = asked.split("#")[0] === url || /^(data|blob):/.test(asked);
    if (!own) faults.push(`request: ${asked.slice(0, 200)}`);
  });
  return faults;
}

// Opens a file; with JavaScript, waits until its charts are drawn. Close `page.context()` after use.
// `faults` is filled while the page lives: console errors, refusals of its security policy, dialogs,
// requests for anything but itself.
export async function open(browser, file, options = {}) {
  const { width = desktop, colorScheme = "light", javaScriptEnabled = true } = options;
  const context = await browser.newContext({
    viewport: { width, height: 900 },
    colorScheme,
    javaScriptEnabled,
    acceptDownloads: true,
    reducedMotion: "reduce",
    locale: "en-US",
  });
  context.setDefaultTimeout(10_000);
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  const faults = noteFaults(page, url);
  await page.goto(url);
  if (javaScriptEnabled) await settled(page);
  return { page, faults };
}

// When all charts are drawn; those, too, that are drawn anew since the colours or the width changed.
export async function settled(page) {
  await page.evaluate(async () => {
    await reeve.ready;
    const figures = [...document.querySelectorAll("figure.chart")];
    await Promise.all(figures.map((figure) => reeve.view(figure)?.runAsync()));
  });
}

// With what can be unfolded unfolded: it has to be as good as the rest.
export const unfold = (page) =>
  page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
  });

export const scrollWidth = (page) => page.evaluate(() => document.documentElement.scrollWidth);

// Elements that stand out to the right of the window, for who looks for the culprit.
export const tooWide = (page, width) =>
  page.evaluate((limit) => {
    const scrolls = (element) =>
      element !== document.documentElement &&
      element !== document.body &&
      getComputedStyle(element).overflowX !== "visible";
    const inScroller = (element) => {
      for (let at = element; at; at = at.parentElement) if (scrolls(at)) return true;
      return false;
    };
    return [...document.body.querySelectorAll("*")]
      .filter((element) => element.getBoundingClientRect().right > limit + 1)
      .filter((element) => !inScroller(element))
      .map((element) => `<${element.tagName.toLowerCase()} id="${element.id}">`)
      .slice(0, 10);
  }, width);

// axe's serious and critical violations, a line for each.
export async function accessibilityFaults(page) {
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => axe.run({ resultTypes: ["violations"] }));
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, help, nodes }) => {
      const where = nodes.slice(0, 4).map((node) => `${node.target} ${node.failureSummary}`);
      return `${id}: ${help} (${nodes.length}): ${where.join(" | ")}`;
    });
}

export async function screenshot(page, name, variant) {
  mkdirSync(screenshots, { recursive: true });
  await page.screenshot({ path: join(screenshots, `${name}-${variant}.png`), fullPage: true });
}

export async function print(page, name) {
  mkdirSync(screenshots, { recursive: true });
  await page.pdf({ path: join(screenshots, `${name}-print.pdf`), format: "A4" });
}
