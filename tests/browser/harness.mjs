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
    if (message.type() === "error") faults.push(`console: ${message.text()}`);
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

// Opens a file; if it is `scripted`, waits until its own script has set data-ready on the root and its
// charts are drawn. Close `page.context()` after use.
// `faults` is filled while the page lives: console errors, refusals of its security policy, dialogs,
// requests for anything but itself.
export async function open(browser, file, options = {}) {
  const { width = desktop, colorScheme = "light", javaScriptEnabled = true } = options;
  const { scripted = false, address = "" } = options;
  const context = await browser.newContext({
    viewport: { width, height: 900 },
    colorScheme,
    javaScriptEnabled,
    acceptDownloads: true,
    reducedMotion: "reduce",
    locale: "en-US",
  });
  context.setDefaultTimeout(30_000);
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  const faults = noteFaults(page, url);
  await page.goto(url + address);
  if (javaScriptEnabled && scripted) {
    await page.waitForSelector("html[data-ready]", { state: "attached" });
  }
  if (javaScriptEnabled && scripted) await settled(page);
  return { page, faults };
}

// When nothing more is drawn or laid out: live charts are drawn anew when colours, width or choices
// change, and say so to nobody. A page without them has nothing to wait for.
export const settled = (page) =>
  page.evaluate(async () => {
    if (!document.querySelector(".live")) return;
    const moment = () => new Promise((resolve) => setTimeout(resolve, 60));
    const inks = () => [...document.querySelectorAll(".live text")].map((t) => t.getAttribute("fill"));
    const seen = () =>
      [
        document.querySelectorAll(".live *").length,
        document.documentElement.scrollHeight,
        inks().join(),
      ].join(" ");
    let before = "";
    for (let same = 0; same < 4; ) {
      await moment();
      const now = seen();
      same = now === before ? same + 1 : 0;
      before = now;
    }
  });

// With what can be unfolded unfolded: it has to be as good as the rest.
export const unfold = (page) =>
  page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
  });

export const fold = (page) =>
  page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = false;
  });

// What cannot be seen of what is in folds.
export const foldedAway = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("details > :not(summary)")]
      .filter((element) => !element.closest(".controls"))
      .filter((element) => getComputedStyle(element).display !== "none" && !element.hidden)
      .filter((element) => element.childElementCount + element.textContent.trim().length > 0)
      .filter((element) => element.tagName !== "NOSCRIPT" && !element.checkVisibility({ contentVisibilityAuto: true }))
      .map((element) => element.id || element.textContent.trim().slice(0, 40)));

export const scrollWidth = (page) => page.evaluate(() => document.documentElement.scrollWidth);

// What is wider than its place, so that it has to be scrolled.
export const cut = (page, places) =>
  page.locator(places).evaluateAll((all) =>
    all.filter((one) => one.clientWidth > 0 && one.scrollWidth > one.clientWidth + 1)
      .map((one) => `${one.getAttribute("aria-label")}: ${one.scrollWidth} in ${one.clientWidth}`));

// What stands out to the right of the window, or holds text that does, for who looks for the culprit.
export const tooWide = (page, width) =>
  page.evaluate((limit) => {
    const visible = (element) => getComputedStyle(element).overflowX === "visible";
    const inScroller = (element) => {
      const at = element.parentElement;
      return at !== null && at !== document.body && (!visible(at) || inScroller(at));
    };
    const end = (element) => {
      const { left, right } = element.getBoundingClientRect();
      return visible(element) ? Math.max(right, left + element.scrollWidth) : right;
    };
    return [...document.body.querySelectorAll("*")]
      .filter((element) => end(element) > limit + 1 && !inScroller(element))
      .slice(0, 8)
      .map((element) => `<${element.tagName.toLowerCase()} id="${element.id}">`);
  }, width);

// Thousands of elements that are parts of one figure and have no text of their own.
const marks = ".reeve-points, .reeve-bars, .reeve-spans, .reeve-paths, .live .mark-symbol, .live .mark-line";

// axe's serious and critical violations, a line for each; of all its rules, or of those named.
export async function accessibilityFaults(page, rules = null) {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axeSource);
  const { violations } = await page.evaluate(
    ([exclude, runOnly]) =>
      axe.run({ exclude }, { resultTypes: ["violations"], ...(runOnly && { runOnly }) }),
    [marks.split(", "), rules],
  );
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, help, nodes }) => {
      const where = nodes.slice(0, 4).map((node) => `${node.target} ${node.failureSummary}`);
      return `${id}: ${help} (${nodes.length}): ${where.join(" | ")}`;
    });
}

// Pictures for people, which no assertion reads: they take longer than all that is asserted.
const isDrawn = Boolean(process.env.REEVE_SCREENSHOTS);

export async function screenshot(page, name, variant) {
  if (!isDrawn) return;
  mkdirSync(screenshots, { recursive: true });
  await page.screenshot({ path: join(screenshots, `${name}-${variant}.png`), fullPage: true });
}

export async function print(page, name) {
  if (!isDrawn) return;
  mkdirSync(screenshots, { recursive: true });
  await page.pdf({ path: join(screenshots, `${name}-print.pdf`), format: "A4" });
}
