// The page of an exploration begins with the answer, and what is pointed at stays in view.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { box, clearSelection, filterBy, name, summary, withExploration } from "./exploration.mjs";
import { settled } from "./harness.mjs";
import { sameToThreeDecimals, schematicTensions, schematicTitle } from "./looking.mjs";
import { reeveJson } from "./places.mjs";

const slot = (page, word) => page.locator(`#slots .slot[data-word="${word}"]`);
const shownWords = (page) =>
  page.locator("#slots .slot").evaluateAll((slots) => slots.map((one) => one.dataset.word));
const { first, affordable } = {
  first: summary.top[0].routing,
  affordable: summary.tradeoff.affordable.routing,
};

for (const [page_name, fingers] of [[name, 2], ["explore-3", 3]]) {
  describe(`explore: the first screen of ${fingers} fingers`, () => {
    let page;
    withExploration(async (opened) => {
      ({ page } = opened);
      await page.setViewportSize({ width: 1280, height: 800 });
      await page.reload();
      await page.waitForSelector("html[data-ready]", { state: "attached" });
      await settled(page);
    }, page_name);

    test("it holds the answer, both drawings, the trade-off and the plot", async () => {
      const parts = ["#answer", "#slots .slot:nth-child(1) .drawing svg", "#slots .slot:nth-child(2) .drawing svg",
        "#tradeoff-table", "#pareto .live svg"];
      for (const part of parts) {
        const { top, left, bottom, right } = await page.locator(part).evaluate((one) => {
          const { top, left, bottom, right } = one.getBoundingClientRect();
          return { top, left, bottom, right };
        });
        assert.ok(top >= 0 && left >= 0 && right <= 1280 && bottom <= 800, `${part}: to ${right}, ${bottom}`);
      }
    });

    test("the drawings stand beside each other and are large enough to be seen", async () => {
      const places = await page.locator("#slots .drawing svg").evaluateAll((drawings) =>
        drawings.map((one) => one.getBoundingClientRect().toJSON()));
      assert.equal(places.length, 2);
      assert.ok(places[0].right <= places[1].left);
      for (const { width, height } of places) assert.ok(width > 200 && height > 150, `${width} x ${height}`);
    });

    test("the plot is high enough to be read", async () => {
      const height = await page.locator("#pareto .live .mark-group.role-frame > g > path").first()
        .evaluate((frame) => frame.getBoundingClientRect().height);
      assert.ok(height >= 215, `${height}`);
    });
  });
}

describe("explore: the panel", () => {
  let page;
  let faults;
  withExploration((opened) => ({ page, faults } = opened));

  test("it begins with the first and the affordable design, as the summary has them", async () => {
    assert.deepEqual(await shownWords(page), [first, affordable]);
    assert.match(await slot(page, first).locator("h2").textContent(), /Best/);
    assert.match(await slot(page, affordable).locator("h2").textContent(), /Fewest sheaths within 2 %/);
    for (const word of [first, affordable]) {
      const drawing = slot(page, word).locator(".drawing");
      assert.ok((await schematicTitle(drawing)).includes(word));
      sameToThreeDecimals(await schematicTensions(drawing), reeveJson(["show", word]).grasps[0].tensions);
    }
  });

  test("it says values, parts and what is lost against the first", async () => {
    const { losses, ...values } = summary.tradeoff.affordable;
    const lines = await slot(page, affordable).locator(".values li").allTextContents();
    const change = (-100 * losses.uniformity_mean).toFixed(1);
    assert.equal(lines[0], `uniformity mean ${values.uniformity.mean.toFixed(4)} (${change} %)`);
    assert.ok(lines[2].startsWith(`${values.sheaths} sheath`), lines[2]);
  });

  test("bars are as high as the tensions", async () => {
    const bars = slot(page, affordable).locator(".bars span");
    const heights = await bars.evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
    const { tensions } = reeveJson(["show", affordable]).grasps[0];
    const strands = ["T1", "T2", "T3", "T4"].map((strand) => tensions[strand]);
    const most = Math.max(...strands);
    heights.forEach((height, i) =>
      assert.ok(Math.abs(height / Math.max(...heights) - strands[i] / most) < 0.03, `${height}`));
  });

  test("a design that is pointed at in the table stands beside it, in view, however far down", async () => {
    await filterBy(page, { which: "listed" });
    const row = page.locator("#designs tbody tr").nth(25);
    await row.scrollIntoViewIfNeeded();
    const word = await row.getAttribute("data-word");
    await row.locator("td").last().scrollIntoViewIfNeeded();
    await row.locator("th").hover();
    const drawing = page.locator(`#preview .slot[data-word="${word}"] .drawing svg`);
    await drawing.waitFor();
    assert.deepEqual(await shownWords(page), [first, word]);
    const { top, bottom } = await drawing.evaluate((svg) => {
      const { top, bottom } = svg.getBoundingClientRect();
      return { top, bottom };
    });
    assert.ok((await page.evaluate(() => scrollY)) > 800);
    assert.ok(top >= 0 && bottom <= 900, `${top} to ${bottom}`);
    await page.mouse.move(5, 5);
    await slot(page, affordable).waitFor();
  });

  test("the keyboard points, too", async () => {
    const word = "M-1-P-2-M";
    await filterBy(page, { text: "TR5", which: "known" });
    await box(page, word).focus();
    await slot(page, word).waitFor();
    await page.locator("#filter-text").focus();
    await slot(page, affordable).waitFor();
    await filterBy(page, { which: "listed" });
  });

  test("a mark that is pointed at stands in it", async () => {
    await filterBy(page, { which: "known" });
    const marks = page.locator("#pareto .live .designs_marks > path");
    const words = await marks.evaluateAll((all) => all.map((one) => one.__data__.datum.tip.split("\n")[0].split(": ").pop()));
    const at = words.indexOf("M-1-T-2-F");
    await marks.nth(at).hover();
    await slot(page, "M-1-T-2-F").waitFor();
    await page.mouse.move(5, 5);
    await filterBy(page, { which: "listed" });
  });

  test("four that are selected are all in it", async () => {
    await clearSelection(page);
    await page.locator("#slots .slot").first().waitFor({ state: "detached" });
    const words = summary.top.slice(0, 4).map(({ routing }) => routing);
    await filterBy(page, {});
    for (const button of await page.locator("#designs button[data-alike]").all()) {
      if ((await button.getAttribute("aria-expanded")) === "false") await button.click();
    }
    for (const word of words) await box(page, word).check();
    await page.mouse.move(5, 5);
    await page.locator("#filter-text").focus();
    await slot(page, words[3]).waitFor();
    assert.deepEqual(await shownWords(page), words);
  });

  test("each design that the answer names is drawn with a click", async () => {
    const buttons = await page.locator("#answer button").all();
    assert.ok(buttons.length >= 3, `${buttons.length}`);
    for (const button of buttons) {
      await clearSelection(page);
      await button.click();
      const word = await button.textContent();
      assert.ok((await schematicTitle(slot(page, word).locator(".drawing"))).includes(word));
    }
  });

  test("lines of the trade-off are selected with a click", async () => {
    await clearSelection(page);
    await page.locator("#tradeoff-table button").first().click();
    assert.deepEqual(await page.locator(".card").evaluateAll((cards) => cards.map((one) => one.dataset.word)),
      [summary.tradeoff.steps[0].routing]);
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
