// How an exploration uses a wide window, and what a phone shows first.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { name, withExploration } from "./exploration.mjs";
import { cut, settled } from "./harness.mjs";

async function at(page, width, height) {
  await page.setViewportSize({ width, height });
  await page.reload();
  await page.waitForSelector("html[data-ready]", { state: "attached" });
  await settled(page);
}

const top = (page, place) => page.locator(place).first().evaluate((one) => one.getBoundingClientRect().top);

for (const of of [name, "explore-3"]) {
  describe(`explore: layout of ${of}`, () => {
    let page;
    let faults;
    withExploration((opened) => ({ page, faults } = opened), of);

    test("a wide window shows whole tables", async () => {
      await at(page, 1440, 900);
      assert.deepEqual(await cut(page, ".card .scroll, .scroll:has(#designs), #tradeoff .scroll"), []);
    });

    test("a phone has a drawing on its first screen, and one line for the selection", async () => {
      await at(page, 390, 844);
      const drawing = await top(page, "#slots .drawing svg");
      assert.ok(drawing < 560, `${drawing}`);
      const { height } = await page.locator("#tray").boundingBox();
      assert.ok(height < 50, `${height}`);
      assert.deepEqual(await cut(page, "#tradeoff .scroll"), []);
    });

    test("a phone's numbers at the ends of axes stay clear of their names", async () => {
      await page.evaluate(() => (document.querySelector("details:has(#parallel)").open = true));
      await settled(page);
      const over = await page.locator("#parallel .live text").evaluateAll((texts) => {
        const boxes = texts.filter((text) => text.textContent.trim()).map((text) => ({
          text: text.textContent, ...text.getBoundingClientRect().toJSON() }));
        return boxes.flatMap((a, i) => boxes.slice(i + 1)
          .filter((b) => a.left < b.right - 2 && b.left < a.right - 2 && a.top < b.bottom - 2 && b.top < a.bottom - 2)
          .map((b) => `${a.text} over ${b.text}`));
      });
      assert.deepEqual(over, []);
    });

    test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
  });
}
