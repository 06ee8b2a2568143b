// The page of one routing, at TR5.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { open, startBrowser } from "./harness.mjs";
import {
  barMarks,
  bars,
  cell,
  countInSvg,
  pngSize,
  readMarks,
  sameToThreeDecimals,
  saveButton,
  saved,
  schematicTensions,
  schematicTitle,
} from "./looking.mjs";
import { jsonBesidePage, pageFile, reeveJson } from "./places.mjs";

const words = (held) => (held.length === 0 ? "no finger held" : `finger ${held} held`);

describe("show", () => {
  const expected = reeveJson(["show", "TR5"]);
  const barCount = expected.grasps.length * Object.keys(expected.grasps[0].shares).length;
  let browser;
  let page;
  let faults;
  before(async () => {
    browser = await startBrowser();
    ({ page, faults } = await open(browser, pageFile("show")));
  });
  after(() => browser.close());

  test("the file beside the page is what the command prints", () => {
    assert.deepEqual(jsonBesidePage("show", "routing.json"), expected);
  });

  test("the heading is the routing's name and word", async () => {
    assert.equal(await page.locator("h1").textContent(), "TR5: M-1-P-2-M");
  });

  test("each grasp has a schematic of this routing with its tensions", async () => {
    assert.equal(await page.locator("figure.schematic").count(), expected.grasps.length);
    for (const grasp of expected.grasps) {
      const schematic = page.locator(`#schematic-held-${grasp.held.join("-") || "none"}`);
      assert.equal(await schematicTitle(schematic), "TR5: M-1-P-2-M");
      sameToThreeDecimals(await schematicTensions(schematic), grasp.tensions);
      const description = await schematic.locator("svg > desc").textContent();
      assert.ok(description.startsWith(words(grasp.held)), description);
    }
  });

  test("the chart has a bar for each strand in each grasp, as high as its tension", async () => {
    assert.equal(await bars(page.locator("#tensions")).count(), barCount);
    const shown = await readMarks(page.locator("#tensions"), barMarks);
    for (const [i, { tensions }] of expected.grasps.entries()) {
      for (const { top, title } of shown[i]) {
        const strand = title.split(":")[0];
        assert.ok(Math.abs(top - tensions[strand]) < 0.002, `${title}: ${top}`);
      }
    }
  });

  test("the tables hold the numbers of the file", async () => {
    const table = page.locator("#tensions-table");
    for (const grasp of expected.grasps) {
      const shown = {};
      for (const segment of Object.keys(grasp.tensions)) {
        shown[segment] = Number(await cell(table, words(grasp.held), segment));
      }
      sameToThreeDecimals(shown, grasp.tensions);
      const uniformity = Number(await cell(table, words(grasp.held), "uniformity"));
      sameToThreeDecimals({ uniformity }, { uniformity: grasp.uniformity });
    }
  });

  test("the sliding directions are those of the file", async () => {
    const table = page.locator("#contacts-table");
    for (const grasp of expected.grasps) {
      for (const { between, slides } of grasp.contacts) {
        assert.equal(await cell(table, between.join("-"), words(grasp.held)), slides);
      }
    }
  });

  test("figures are saved with what they show", async () => {
    const chart = await saved(page, saveButton(page.locator("#tensions"), "SVG"));
    const drawn = await countInSvg(page, chart.bytes.toString("utf8"), barMarks);
    assert.equal(drawn, barCount);
    const schematic = page.locator("#schematic-held-1");
    const { name, bytes } = await saved(page, saveButton(schematic, "SVG"));
    assert.equal(name, "TR5-held-1.svg");
    assert.equal(await countInSvg(page, bytes.toString("utf8"), "svg > desc"), 1);
    const file = await saved(page, saveButton(schematic, "PNG"));
    assert.ok(pngSize(file.bytes).height > 1000);
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
