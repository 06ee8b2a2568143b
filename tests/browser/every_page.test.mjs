// What holds for each page, whatever it shows.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import {
  accessibilityFaults,
  open,
  phone,
  print,
  screenshot,
  scrollWidth,
  fold,
  foldedAway,
  settled,
  startBrowser,
  tooWide,
  unfold,
} from "./harness.mjs";
import { pages } from "./pages.mjs";
import { pageFile } from "./places.mjs";
import { outlineFaults, figureFaults, staticFaults, textFaults } from "./structure.mjs";

// Words and names that go into several lines on paper.
const brokenWords = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("tbody .left:not(.long)")]
      .filter((cell) => cell.checkVisibility() && !cell.closest(".columns"))
      .filter((cell) => {
        const walker = document.createTreeWalker(cell, NodeFilter.SHOW_TEXT);
        const tops = [];
        while (walker.nextNode()) {
          const range = document.createRange();
          range.selectNodeContents(walker.currentNode);
          tops.push(...[...range.getClientRects()].map(({ top }) => top));
        }
        return Math.max(...tops) - Math.min(...tops) > 6;
      })
      .map((cell) => cell.textContent.trim().slice(0, 40)));

// Headings that Chromium leaves blank where a table goes on on the next page.
const blankHeadings = (page) =>
  page.locator("thead button").evaluateAll((buttons) =>
    buttons.filter((button) => getComputedStyle(button).display !== "contents").map((button) => button.textContent));

// The width that an A4 page leaves between the margins of a printer.
const paper = 718;
// Tables of many grasps, which browsers print smaller.
const wideTables = ["show-wide"];

async function fits(page, most) {
  const width = await scrollWidth(page);
  assert.ok(width <= most, `${width} px wide: ${await tooWide(page, most)}`);
}

// Two at a time, for two cores.
describe("every page", { concurrency: 2 }, () => {
  let browser;
  before(async () => {
    browser = await startBrowser();
  });
  after(() => browser.close());

  for (const { name, scripted } of pages) {
    const file = pageFile(name);

    test(`${name}: on a desk, in light and in dark`, async () => {
      const { page, faults } = await open(browser, file, { scripted });
      await screenshot(page, name, "desktop");
      await unfold(page);
      assert.deepEqual(await outlineFaults(page), []);
      assert.deepEqual(await figureFaults(page), []);
      assert.deepEqual(await textFaults(page), []);
      assert.deepEqual(await accessibilityFaults(page), []);
      await page.emulateMedia({ colorScheme: "dark" });
      await settled(page);
      await screenshot(page, name, "dark");
      // The rest does not depend on colours.
      assert.deepEqual(await accessibilityFaults(page, ["color-contrast"]), [], "in dark");
      assert.deepEqual(faults, []);
      await page.context().close();
    });

    test(`${name}: on a phone, and printed`, async () => {
      const { page, faults } = await open(browser, file, { width: phone, scripted });
      await screenshot(page, name, "380");
      const height = await page.evaluate(() => document.documentElement.scrollHeight);
      assert.ok(height < 4000, `${height} px high on a phone`);
      await unfold(page);
      await fits(page, phone);
      await fold(page);
      await page.setViewportSize({ width: paper, height: 1123 });
      await page.emulateMedia({ media: "print" });
      assert.deepEqual(await foldedAway(page), [], "printed");
      assert.deepEqual(await brokenWords(page), [], "printed");
      assert.deepEqual(await blankHeadings(page), [], "printed");
      if (!wideTables.includes(name)) await fits(page, paper);
      await screenshot(page, name, "print");
      assert.deepEqual(await staticFaults(page), []);
      await print(page, name);
      assert.deepEqual(faults, []);
      await page.context().close();
    });

    test(`${name}: without JavaScript`, async () => {
      const { page, faults } = await open(browser, file, { javaScriptEnabled: false });
      await screenshot(page, name, "no-js");
      assert.deepEqual(await staticFaults(page), []);
      await page.setViewportSize({ width: phone, height: 900 });
      await unfold(page);
      await fits(page, phone);
      assert.deepEqual(faults, []);
      await page.context().close();
    });
  }
});
