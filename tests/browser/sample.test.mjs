// What all pages share (pages/assets/page.js), at a page made for it by sample_page.cpp.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, startBrowser } from "./harness.mjs";
import {
  column,
  countInSvg,
  marks,
  pngSize,
  pointMarks,
  readMarks,
  saveButton,
  saved,
  sortButton,
  tabTo,
} from "./looking.mjs";
import { pageFile } from "./places.mjs";

const numbers = ["3", "10", "6", "2", "9"]; // as written
const ascending = ["2", "3", "6", "9", "10"];
const points = 12;

describe("what pages share", () => {
  let browser;
  let page;
  let faults;
  before(async () => {
    browser = await startBrowser();
    ({ page, faults } = await open(browser, pageFile("sample")));
  });
  after(() => browser.close());

  test("a chart has a mark for each datum, where its numbers say", async () => {
    const [shown] = await readMarks(page.locator("#points"));
    assert.equal(shown.length, points);
    const expected = Array.from({ length: points }, (_, i) => [i, (i * 5) % points]);
    const places = shown.map(({ x, y }) => [Math.round(x), Math.round(y)]);
    assert.deepEqual(places.sort(([a], [b]) => a - b), expected);
    for (const { x, y } of shown) {
      assert.ok(Math.abs(x - Math.round(x)) < 0.02 && Math.abs(y - Math.round(y)) < 0.05, `${x}, ${y}`);
    }
  });

  test("who points at a mark sees its text", async () => {
    const shown = await marks(page.locator("#points")).locator("title").allTextContents();
    const texts = await page.evaluate(() => reeve.data.texts);
    assert.deepEqual([...new Set(shown)].sort(), [...texts].sort());
  });

  test("a chart is drawn in the colours of the reader's scheme", async () => {
    const colour = (selector, property) =>
      page
        .locator(`#points ${selector}`)
        .first()
        .evaluate((element, name) => getComputedStyle(element)[name], property);
    const colours = async () => [
      await colour(".reeve-axes text", "fill"),
      await colour(".reeve-paper", "fill"),
      await colour(".reeve-grid", "stroke"),
      await colour(".reeve-points > *", "fill"),
    ];
    const light = await colours();
    await page.emulateMedia({ colorScheme: "dark" });
    const dark = await colours();
    for (const [i, one] of light.entries()) assert.notEqual(dark[i], one);
    await page.emulateMedia({ colorScheme: "light" });
    assert.deepEqual(await colours(), light);
  });

  test("a table sorts numbers as numbers, up and down", async () => {
    const table = page.locator("#texts");
    assert.deepEqual(await column(table, "number"), numbers);
    await sortButton(table, "number").click();
    assert.deepEqual(await column(table, "number"), ascending);
    await sortButton(table, "number").click();
    assert.deepEqual(await column(table, "number"), [...ascending].reverse());
  });

  test("a table sorts by what a cell says to sort by", async () => {
    const table = page.locator("#texts");
    await sortButton(table, "ordered by what is not seen").click();
    assert.deepEqual(
      await column(table, "ordered by what is not seen"),
      ["no. 4", "no. 3", "no. 2", "no. 1", "no. 0"],
    );
  });

  test("a table is sorted with the keyboard alone, and says how it is sorted", async () => {
    const table = page.locator("#texts");
    const button = sortButton(table, "number");
    await page.locator("body").click({ position: { x: 1, y: 1 } });
    await tabTo(page, button);
    await page.keyboard.press("Enter");
    assert.deepEqual(await column(table, "number"), ascending);
    await page.keyboard.press("Space");
    assert.deepEqual(await column(table, "number"), [...ascending].reverse());
    assert.equal(await button.locator("xpath=..").getAttribute("aria-sort"), "descending");
  });

  test("Save SVG gives the chart with its marks, on white", async () => {
    await page.emulateMedia({ colorScheme: "dark" }); // which the file does not follow
    const { name, bytes } = await saved(page, saveButton(page.locator("#points"), "SVG"));
    await page.emulateMedia({ colorScheme: "light" });
    assert.equal(name, "points.svg");
    const text = bytes.toString("utf8");
    assert.equal(await countInSvg(page, text, pointMarks), points);
    assert.equal(await countInSvg(page, text, "img, script, foreignObject"), 0);
    assert.match(text, /class="reeve-paper" fill="#ffffff"/);
  });

  test("Save PNG gives three pixels for each of the figure's", async () => {
    const { bytes: svg } = await saved(page, saveButton(page.locator("#points"), "SVG"));
    const width = Number(/<svg[^>]* width="(\d+)/.exec(svg.toString("utf8"))[1]);
    const { name, bytes } = await saved(page, saveButton(page.locator("#points"), "PNG"));
    assert.equal(name, "points.png");
    assert.equal(pngSize(bytes).width, 3 * width);
    assert.ok(pngSize(bytes).height > 3 * 240);
  });

  test("a schematic is saved as it stands", async () => {
    const { name, bytes } = await saved(page, saveButton(page.locator("#routing"), "SVG"));
    assert.equal(name, "routing.svg");
    assert.equal(await countInSvg(page, bytes.toString("utf8"), "svg > title"), 1);
    const png = await saved(page, saveButton(page.locator("#routing"), "PNG"));
    assert.ok(pngSize(png.bytes).width > 600);
  });

  test("texts stay texts", async () => {
    const texts = await page.evaluate(() => reeve.data.texts);
    const shown = await page
      .locator("#texts tbody th")
      .evaluateAll((cells) => cells.map((cell) => cell.textContent));
    assert.deepEqual([...shown].sort(), [...texts].sort());
    assert.equal(await page.evaluate(() => window.stolen), undefined);
    assert.ok((await page.title()).includes("</script>"));
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
