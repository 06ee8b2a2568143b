// The page of a ranking, of the catalogue's routings: what it shows is what the command prints.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, startBrowser } from "./harness.mjs";
import {
  bars,
  column,
  countInSvg,
  marks,
  pointMarks,
  readMarks,
  sameToThreeDecimals,
  saveButton,
  saved,
  schematicTensions,
  schematicTitle,
  sortButton,
} from "./looking.mjs";
import { jsonBesidePage, pageFile, reeveJson } from "./places.mjs";

const mean = (design, objective) => design[objective].mean;

describe("rank", () => {
  const { designs } = reeveJson(["rank", "--catalogue"]);
  const label = (design) => `${design.name}: ${design.routing}`;
  let browser;
  let page;
  let faults;
  let json;
  before(async () => {
    browser = await startBrowser();
    ({ page, faults } = await open(browser, pageFile("rank")));
    json = jsonBesidePage("rank", "ranking.json");
  });
  after(() => browser.close());

  test("the first of the ranking is named first", async () => {
    const answer = await page.locator("#answer").textContent();
    assert.ok(answer.trim().startsWith(`${designs[0].name} comes first`), answer);
  });

  test("the table is in the order of the ranking, and sorts", async () => {
    const table = page.locator("#ranking-table");
    assert.deepEqual(
      await column(table, "word"),
      designs.map((design) => design.routing),
    );
    const least = [...designs].sort((a, b) => mean(a, "efficiency") - mean(b, "efficiency"));
    await sortButton(table, "efficiency mean").click();
    const shown = await column(table, "efficiency mean");
    assert.deepEqual(
      shown,
      least.map((design) => mean(design, "efficiency").toFixed(3)),
    );
  });

  test("the plot has a mark wherever a design is, and nowhere else", async () => {
    const places = new Set(
      designs.map((design) => `${mean(design, "uniformity")} ${mean(design, "efficiency")}`),
    );
    const [shown] = await readMarks(page.locator("#pareto"));
    assert.equal(shown.length, places.size);
    for (const { x, y, title } of shown) {
      const near = designs.filter(
        (design) =>
          Math.abs(mean(design, "uniformity") - x) < 6e-4 &&
          Math.abs(mean(design, "efficiency") - y) < 6e-4,
      );
      assert.ok(near.length > 0, `${title}: ${x}, ${y}`);
      for (const { name } of near) assert.ok(title.split("\n")[0].includes(name), `${name}: ${title}`);
    }
  });

  test("the ranks' medians are the file's", async () => {
    const [shown] = await readMarks(page.locator("#ranks"));
    assert.equal(shown.length, json.designs.length);
    for (const { x, title } of shown) {
      const { rank_distribution: drawn } = json.designs.find(({ name }) => title.startsWith(name));
      assert.ok(Math.abs(x - drawn.median) < 0.01, `${title}: ${x}, is ${drawn.median}`);
    }
  });

  test("the tension distributions have a symbol for each strand, and one for each published share", async () => {
    const strands = json.tension_distributions.flatMap(({ routings }) =>
      routings.flatMap((routing) => routing.strands),
    );
    const figure = page.locator("#figure-9");
    assert.equal(strands.length, 2 * 7 * 4); // coefficients, routings, strands
    const published = strands.filter((strand) => strand.published !== null);
    const all = strands.length + published.length;
    assert.equal(await marks(figure).count(), all);
    assert.equal(await bars(figure).count(), 0);
    const { bytes } = await saved(page, saveButton(figure, "SVG"));
    assert.equal(await countInSvg(page, bytes.toString("utf8"), pointMarks), all);
    // In the order of the file: rows of panels, in each the strands.
    const drawn = (await readMarks(figure)).flat().filter(({ title }) => /, model: /.test(title));
    for (const [i, { model }] of strands.entries()) {
      assert.ok(Math.abs(drawn[i].y - model) < 0.002, `${drawn[i].title}: is ${model}`);
    }
  });

  // The capstan ratios of TR1 by hand: each turn of the tube takes exp(-0.18 pi), or exp(-0.09 pi).
  test("the model's shares of TR1 are those of the closed form", () => {
    for (const { mu, routings } of json.tension_distributions) {
      const left = [0, 1, 2, 3].map((turns) => Math.exp(-mu * Math.PI * turns));
      const sum = left.reduce((a, b) => a + b);
      const { strands } = routings.find((routing) => routing.name === "TR1");
      strands.forEach((strand, i) => assert.ok(Math.abs(strand.model - left[i] / sum) < 1e-9));
    }
  });

  test("a chosen grasp shows each routing's schematic with its tensions, and no other grasp", async () => {
    await page.locator("#grasp").selectOption("held-1");
    assert.ok(await page.locator("#held-1").isVisible());
    assert.ok(!(await page.locator("#held-none").isVisible()));
    for (const [i, design] of designs.entries()) {
      const schematic = page.locator(`#schematic-${i + 1}-held-1`);
      assert.equal(await schematicTitle(schematic), label(design));
      const { grasps } = reeveJson(["show", design.routing, "--held", "1"]);
      sameToThreeDecimals(await schematicTensions(schematic), grasps[0].tensions);
    }
  });

  test("the trade-off is the file's", async () => {
    const table = page.locator("#tradeoff-table");
    assert.deepEqual(await column(table, "routing"), json.tradeoff.steps.map(({ routing }) => routing));
    const kept = await column(table, "kept");
    json.tradeoff.steps.forEach((step, i) => assert.equal(kept[i], `${(100 * step.kept).toFixed(1)} %`));
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
