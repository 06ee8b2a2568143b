// The page of an exploration, and what it must show: from the files beside it, never from itself.
import { after, before } from "node:test";
import { open, settled, startBrowser } from "./harness.mjs";
import { csvRecords } from "./csv.mjs";
import { column } from "./looking.mjs";
import { besidePage, jsonBesidePage, pageFile } from "./places.mjs";

export const name = "explore-2";
export const summary = jsonBesidePage(name, "summary.json");
export const designs = csvRecords(besidePage(name, "designs.csv"));
export const byWord = new Map(designs.map((design) => [design.routing, design]));

// As the table has them: those that are alike are one line, of the first.
export const lines = (some) => {
  const firsts = new Set();
  return some.filter(({ routing, same_as }) => {
    const whole = same_as || routing;
    return !firsts.has(whole) && firsts.add(whole);
  });
};

export const openExploration = (browser, options) =>
  open(browser, pageFile(name), { scripted: true, ...options });

// Within describe(): a browser with the page of that exploration, from before the first test until
// after the last; `use` is given {browser, page, faults}.
export function withExploration(use, of = name) {
  let browser;
  before(async () => {
    browser = await startBrowser();
    await use({ browser, ...(await open(browser, pageFile(of), { scripted: true })) });
  });
  after(() => browser.close());
}

// The designs that are drawn, with all that the chart holds of each.
export async function drawn(page) {
  const data = await page
    .locator("#pareto .live .designs_marks > path")
    .evaluateAll((paths) => paths.map((path) => path.__data__.datum));
  return data.map(({ x, y, kind, tip }) => {
    const [label] = tip.split("\n");
    const more = /and (\d+) more in this spot/.exec(tip);
    return { word: label.split(": ").pop(), x, y, kind, designs: 1 + Number(more?.[1] ?? 0) };
  });
}

export const tableWords = (page) => column(page.locator("#designs"), "routing");

export async function filterBy(page, { text = "", which = "listed" }) {
  await page.locator("#filter-which").selectOption(which);
  await page.locator("#filter-text").fill(text);
  await page.waitForTimeout(200); // the page waits whether more is typed
  await settled(page);
}

export async function clearSelection(page) {
  if (await page.locator("#clear").isVisible()) await page.locator("#clear").click();
  await page.locator(".card").first().waitFor({ state: "detached" });
}

export const box = (page, word) => page.locator(`#designs input[data-word="${word}"]`);
export const card = (page, word) => page.locator(`.card[data-word="${word}"]`);
