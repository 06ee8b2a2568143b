// An exploration with a hand: where no motor force is enough there is no number, which is a dash, as
// in the terminal, and comes last.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { csvRecords } from "./csv.mjs";
import { filterBy, withExploration } from "./exploration.mjs";
import { column, sortButton } from "./looking.mjs";
import { besidePage } from "./places.mjs";

describe("explore: a hand", () => {
  const designs = csvRecords(besidePage("explore-hand", "designs.csv"));
  const none = designs.filter(({ motor_force }) => motor_force === "");
  let page;
  let faults;
  withExploration(async (opened) => {
    ({ page, faults } = opened);
    await filterBy(page, { which: "listed" });
  }, "explore-hand");

  test("what there is none of is a dash, and a bound leaves it out", async () => {
    assert.ok(none.length > 0 && none.length < designs.length, `${none.length} of ${designs.length}`);
    await filterBy(page, { text: none[0].routing, which: "listed" });
    assert.ok((await column(page.locator("#designs"), "motor force, N")).includes("-"));
    const bound = page.locator("#bounds .bound").first();
    await bound.locator("select").first().selectOption({ label: "motor force" });
    await bound.locator("select").nth(1).selectOption("most");
    await bound.locator("input").fill("1e9");
    await filterBy(page, { which: "listed" });
    const said = await page.locator("#filter-count").textContent();
    assert.ok(said.startsWith(`${designs.length - none.length} of `), said);
    await bound.locator("input").fill("");
    await filterBy(page, { which: "listed" });
  });

  test("sorted, it comes last both ways", async () => {
    const button = sortButton(page.locator("#designs"), "motor force, N");
    for (const _ of ["up", "down"]) {
      await button.click();
      const first = await column(page.locator("#designs"), "motor force, N");
      assert.ok(!first.slice(0, 10).includes("-"), first.slice(0, 10).join());
    }
  });

  test("the axes of the plots are of numbers", async () => {
    await page.locator("#x-axis").selectOption({ label: "motor force (lower is better)" });
    await page.waitForTimeout(400);
    const texts = await page.locator("#pareto .live text, #parallel .live text").allTextContents();
    for (const text of texts) assert.ok(!/NaN|Infinity|null|undefined|inf/.test(text), text);
    const numbers = await page.locator("#pareto .live .role-axis-label text").allTextContents();
    assert.ok(numbers.length > 5, numbers.join());
  });

  test("the hand is named among what was explored", async () => {
    const said = await page.locator("#explored").textContent();
    assert.match(said, /Hand: finger 1: 2 joints, arms 11\/8 mm/);
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
