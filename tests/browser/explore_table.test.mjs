// The table of an exploration: filter, order, and all of it with the keyboard alone.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import {
  box,
  byWord,
  card,
  clearSelection,
  designs,
  filterBy,
  openExploration,
  summary,
  tableWords,
} from "./exploration.mjs";
import { settled, startBrowser } from "./harness.mjs";
import { sameToThreeDecimals, schematicTensions, sortButton, tabTo } from "./looking.mjs";
import { reeveJson } from "./places.mjs";

const screenful = 50;
const values = (words, key) => words.map((word) => Number(byWord.get(word)[key]));
const ascending = (numbers) => [...numbers].sort((a, b) => a - b);

describe("explore: the table", () => {
  let browser;
  let page;
  let faults;
  before(async () => {
    browser = await startBrowser();
    ({ page, faults } = await openExploration(browser));
  });
  after(() => browser.close());

  test("it begins in the order of designs.csv", async () => {
    const first = designs.slice(0, screenful).map(({ routing }) => routing);
    assert.deepEqual(await tableWords(page), first);
  });

  test("the next screen shows the rest", async () => {
    await page.locator("#next-page").click();
    const rest = designs.slice(screenful, 2 * screenful).map(({ routing }) => routing);
    assert.deepEqual(await tableWords(page), rest);
    await page.locator("#previous-page").click();
  });

  for (const [heading, key] of [
    ["efficiency worst", "efficiency_worst"],
    ["travel", "travel"],
  ]) {
    test(`it is sorted by ${heading}, up and down`, async () => {
      const all = ascending(designs.map((design) => Number(design[key])));
      const button = sortButton(page.locator("#designs"), heading);
      await button.click();
      assert.deepEqual(values(await tableWords(page), key), all.slice(0, screenful));
      await button.click();
      assert.deepEqual(values(await tableWords(page), key), all.reverse().slice(0, screenful));
      await sortButton(page.locator("#designs"), "rank").click();
    });
  }

  test("a text filters by word and by name", async () => {
    await filterBy(page, { text: "b-p-2" });
    const holding = designs.filter(({ routing }) => routing.toLowerCase().includes("b-p-2"));
    assert.ok(holding.length > 0 && holding.length < designs.length);
    assert.deepEqual(await tableWords(page), holding.map(({ routing }) => routing));
    const said = await page.locator("#filter-count").textContent();
    assert.ok(said.startsWith(`${holding.length} of `), said);
    await filterBy(page, { text: "tr7" });
    assert.deepEqual(await tableWords(page), ["1-P-2-P-1"]);
    await filterBy(page, { text: "no such thing" });
    assert.deepEqual(await tableWords(page), []);
    await filterBy(page, {});
  });

  test("the front and the known routings can be had alone", async () => {
    await filterBy(page, { which: "front" });
    assert.deepEqual(await tableWords(page), summary.front.map(({ routing }) => routing));
    await filterBy(page, { which: "known" });
    const known = summary.known.map(({ routing }) => routing);
    assert.deepEqual((await tableWords(page)).sort(), known.sort());
    await filterBy(page, {});
  });

  test("a bound on an objective filters", async () => {
    const bound = page.locator("#bounds .bound").first();
    await bound.locator("select").first().selectOption({ label: "sheaths" });
    await bound.locator("select").nth(1).selectOption("most");
    await bound.locator("input").fill("2");
    await settled(page);
    const few = designs.filter(({ sheaths }) => Number(sheaths) <= 2).slice(0, screenful);
    assert.deepEqual(await tableWords(page), few.map(({ routing }) => routing));
    await bound.locator("input").fill("");
  });

  test("a row is selected, and the table sorted, with the keyboard alone", async () => {
    await clearSelection(page);
    await filterBy(page, { text: "TR5" });
    const word = "M-1-P-2-M";
    await page.locator("#filter-text").focus();
    await tabTo(page, box(page, word));
    await page.keyboard.press("Space");
    const schematic = card(page, word).locator("figure.schematic");
    await schematic.locator("svg").waitFor();
    sameToThreeDecimals(await schematicTensions(schematic), reeveJson(["show", word]).grasps[0].tensions);
    await filterBy(page, {});
    await page.locator("#filter-text").focus();
    await tabTo(page, sortButton(page.locator("#designs"), "sheaths"));
    await page.keyboard.press("Enter");
    const least = ascending(designs.map(({ sheaths }) => Number(sheaths)));
    assert.deepEqual(values(await tableWords(page), "sheaths"), least.slice(0, screenful));
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
