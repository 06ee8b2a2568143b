// The table of an exploration: filter, order, and all of it with the keyboard alone.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import {
  box,
  byWord,
  card,
  clearSelection,
  designs,
  filterBy,
  lines,
  openExploration,
  summary,
  tableWords,
  withExploration,
} from "./exploration.mjs";
import { settled } from "./harness.mjs";
import { sameToThreeDecimals, schematicTensions, sortButton, tabTo } from "./looking.mjs";
import { reeveJson } from "./places.mjs";

const screenful = 50;
const values = (words, key) => words.map((word) => Number(byWord.get(word)[key]));
const ascending = (numbers) => [...numbers].sort((a, b) => a - b);

describe("explore: the table", () => {
  let browser;
  let page;
  let faults;
  withExploration((opened) => ({ browser, page, faults } = opened));

  test("it begins in the order of designs.csv", async () => {
    const first = lines(designs).slice(0, screenful).map(({ routing }) => routing);
    assert.ok(first.length < designs.length);
    assert.deepEqual(await tableWords(page), first);
  });

  test("designs that are alike are one line with their number, which opens", async () => {
    const first = designs.find(({ routing }) => designs.some(({ same_as }) => same_as === routing));
    const others = designs.filter(({ same_as }) => same_as === first.routing).map(({ routing }) => routing);
    const button = page.locator(`#designs tr[data-word="${first.routing}"] button[data-alike]`);
    assert.equal(await button.textContent(), `+${others.length}`);
    assert.equal(await button.getAttribute("aria-expanded"), "false");
    const before = await tableWords(page);
    await button.focus();
    await page.keyboard.press("Enter");
    const after = await tableWords(page);
    const at = after.indexOf(first.routing);
    assert.deepEqual(after.slice(at + 1, at + 1 + others.length), others);
    assert.equal(await button.evaluate((one) => one === document.activeElement), true);
    await button.click();
    assert.deepEqual(await tableWords(page), before);
  });

  test("the best that a filter leaves stands for those that are alike", async () => {
    await filterBy(page, { text: "1b-p-2b" });
    const holding = designs.filter(({ routing }) => routing.toLowerCase().includes("1b-p-2b"));
    assert.ok(holding.some(({ same_as }) => same_as && !holding.some(({ routing }) => routing === same_as)));
    assert.deepEqual(await tableWords(page), lines(holding).map(({ routing }) => routing));
    await filterBy(page, {});
  });

  test("columns can be put away, and the address remembers which", async () => {
    const headings = () =>
      page.locator("#designs thead th").evaluateAll((all) =>
        all.filter((one) => one.getClientRects().length > 0).map((one) => one.textContent));
    const all = await headings();
    await page.locator("#columns summary").click();
    await page.locator('#column-boxes input[data-column="travel"]').uncheck();
    await page.locator('#column-boxes input[data-column="front"]').uncheck();
    assert.deepEqual(await headings(), all.filter((each) => each !== "travel" && each !== "front"));
    const { page: again } = await openExploration(browser, { address: new URL(page.url()).hash });
    assert.equal(await again.locator('#designs th[data-column="front"]').isVisible(), false);
    assert.equal(await again.locator('#column-boxes input[data-column="front"]').isChecked(), false);
    await again.context().close();
    await page.locator('#column-boxes input[data-column="travel"]').check();
    await page.locator('#column-boxes input[data-column="front"]').check();
    assert.deepEqual(await headings(), all);
  });

  test("names stay where they are while the rest scrolls, and the edge shows that more follows", async () => {
    const region = page.locator(".scroll:has(> #designs)");
    const row = page.locator("#designs tbody tr").first();
    const left = (cell) => cell.evaluate((one) => one.getBoundingClientRect().left);
    const [name, number] = [row.locator("th"), row.locator("td").nth(5)];
    const [before, moving] = [await left(name), await left(number)];
    // How dark the paper is there, beside the caption, where nothing is written.
    const darkness = async () => {
      const { x, y, width } = await region.boundingBox();
      const png = await page.screenshot({ clip: { x: x + width - 6, y: y + 4, width: 4, height: 4 } });
      return page.evaluate(async (bytes) => {
        const image = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
        const context = new OffscreenCanvas(4, 4).getContext("2d");
        context.drawImage(image, 0, 0);
        return 255 - context.getImageData(0, 0, 1, 1).data[0];
      }, [...png]);
    };
    await region.scrollIntoViewIfNeeded();
    await region.evaluate((one) => one.scrollIntoView({ block: "start" }));
    assert.ok((await darkness()) > 10, "shade at the edge");
    const most = await region.evaluate((one) => (one.scrollLeft = 1e6, one.scrollLeft));
    assert.ok(most > 50, `${most}`);
    assert.ok(Math.abs((await left(name)) - before) < 1);
    assert.ok(Math.abs((await left(number)) - (moving - most)) < 1);
    assert.ok((await darkness()) < 4, "no shade at the end");
    await region.evaluate((one) => (one.scrollLeft = 0));
  });

  for (const [heading, key] of [
    ["efficiency worst", "efficiency_worst"],
    ["travel", "travel"],
  ]) {
    test(`it is sorted by ${heading}, up and down`, async () => {
      const all = ascending(lines(designs).map((design) => Number(design[key])));
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
    assert.deepEqual(await tableWords(page), lines(holding).map(({ routing }) => routing));
    const said = await page.locator("#filter-count").textContent();
    assert.ok(said.startsWith(`${holding.length} of `), said);
    await filterBy(page, { text: "tr7" });
    assert.deepEqual(await tableWords(page), ["1-P-2-P-1"]);
    await filterBy(page, { text: "no such thing" });
    assert.equal(await page.locator("#designs tbody tr").count(), 1);
    assert.match(await page.locator("#designs tbody").textContent(), /^No design passes the filter/);
    await filterBy(page, {});
  });

  test("the address remembers the filter, and another page shows it", async () => {
    const bound = page.locator("#bounds .bound").first();
    await bound.locator("select").first().selectOption({ index: await page.evaluate(
      () => explorationState.objectives.findIndex(({ name }) => name === "sheaths")) });
    await bound.locator("select").nth(1).selectOption("most");
    await bound.locator("input").fill("3");
    await filterBy(page, { text: "b-p" });
    const left = lines(designs.filter(({ routing, sheaths }) =>
      routing.toLowerCase().includes("b-p") && Number(sheaths) <= 3)).map(({ routing }) => routing);
    assert.ok(left.length > 0 && left.length < screenful);
    assert.deepEqual(await tableWords(page), left);
    const { page: again } = await openExploration(browser, { address: new URL(page.url()).hash });
    assert.deepEqual(await tableWords(again), left);
    assert.equal(await again.locator("#filter-text").inputValue(), "b-p");
    assert.equal(await again.locator("#filter-which").inputValue(), "listed");
    assert.equal(await again.locator("#bounds .bound input").inputValue(), "3");
    await again.context().close();
    await bound.locator("input").fill("");
    await filterBy(page, {});
  });

  test("the front and the known routings can be had alone", async () => {
    await filterBy(page, { which: "front" });
    const front = lines(designs.filter(({ front: number }) => number === "1"));
    assert.deepEqual(await tableWords(page), front.map(({ routing }) => routing));
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
    const few = lines(designs.filter(({ sheaths }) => Number(sheaths) <= 2));
    assert.deepEqual(await tableWords(page), few.slice(0, screenful).map(({ routing }) => routing));
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
    const least = ascending(lines(designs).map(({ sheaths }) => Number(sheaths)));
    assert.deepEqual(values(await tableWords(page), "sheaths"), least.slice(0, screenful));
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
