// Ranges that are brushed on the parallel axes, and a filter that leaves nothing.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { designs, filterBy, openExploration, tableWords, withExploration } from "./exploration.mjs";
import { settled } from "./harness.mjs";

const count = async (page) => Number((await page.locator("#filter-count").textContent()).split(" ")[0]);
const drawnLater = async (page) => {
  await page.waitForTimeout(250); // the page waits whether more is dragged
  await settled(page);
};

// Where the axis of an objective lies on the screen.
const axis = (page, title) =>
  page.evaluate((wanted) => {
    const view = liveCharts.view(document.getElementById("parallel"));
    const svg = view.container().querySelector("svg");
    svg.scrollIntoView({ block: "center" });
    const { left, top } = svg.getBoundingClientRect();
    const [dx, dy] = view.origin();
    return { x: left + dx + view.scale("x")(wanted), top: top + dy, height: view.height() };
  }, title);

async function drag(page, title, from, to) {
  const { x, top, height } = await axis(page, title);
  await page.mouse.move(x, top + (1 - from) * height);
  await page.mouse.down();
  await page.mouse.move(x, top + (1 - (from + to) / 2) * height);
  await page.mouse.move(x, top + (1 - to) * height);
  await page.mouse.up();
  await drawnLater(page);
}

describe("explore: ranges on the parallel axes", () => {
  let browser;
  let page;
  let faults;
  const values = (key) => designs.map((design) => Number(design[key]));
  const uniformity = values("uniformity_mean");
  const [low, high] = [Math.min(...uniformity), Math.max(...uniformity)];
  withExploration(async (opened) => {
    ({ browser, page, faults } = opened);
    await filterBy(page, { which: "listed" });
  });

  test("a range that is dragged keeps the designs that are in it, and no others", async () => {
    await drag(page, "uniformity mean", 1, 0.5);
    const middle = (low + high) / 2;
    const near = (value) => Math.abs(value - middle) < 0.02 * (high - low);
    const sure = designs.filter((design) => design.uniformity_mean > middle && !near(design.uniformity_mean));
    const words = new Set(await page.evaluate(() =>
      explorationState.rows().map((row) => explorationState.designs().word[row])));
    assert.ok(sure.length > 5 && sure.length < designs.length);
    for (const design of sure) assert.ok(words.has(design.routing), design.routing);
    for (const word of words) {
      const { uniformity_mean } = designs.find(({ routing }) => routing === word);
      assert.ok(Number(uniformity_mean) > middle || near(uniformity_mean), `${word}: ${uniformity_mean}`);
    }
    assert.equal(await count(page), words.size);
    for (const word of await tableWords(page)) assert.ok(words.has(word), word);
    const drawn = await page.locator("#pareto-count").textContent();
    assert.ok(drawn.includes(` of ${words.size} designs`), drawn);
  });

  test("the axes reach as far as before, so that the range can be seen", async () => {
    const ends = await page.locator("#parallel .live .mark-text text").allTextContents();
    assert.ok(ends.includes(String(Number(low.toPrecision(4)))), ends.join());
    const brush = page.locator("#parallel .live .mark-rule line[stroke-width='16']");
    assert.equal(await brush.count(), 1);
    const { height } = await axis(page, "uniformity mean");
    const drawn = await brush.evaluate((line) => Math.abs(line.y2.baseVal.value - line.y1.baseVal.value));
    assert.ok(Math.abs(drawn - height / 2) < 0.04 * height, `${drawn} of ${height}`);
  });

  test("whole numbers are kept whole", async () => {
    await drag(page, "sheaths (inverted)", 1, 0.5);
    const { ranges } = await page.evaluate(() => ({ ranges: [...explorationState.ranges()] }));
    const [, kept] = ranges.at(-1);
    assert.ok(kept.every(Number.isInteger), kept.join());
    const sheaths = await page.evaluate(() => {
      const at = explorationState.objectives.findIndex(({ name }) => name === "sheaths");
      return explorationState.rows().map((row) => explorationState.designs().values[at][row]);
    });
    assert.ok(sheaths.length > 0 && sheaths.every((each) => each >= kept[0] && each <= kept[1]));
  });

  test("the address brings the ranges back", async () => {
    const address = new URL(page.url()).hash;
    const { page: again, faults: new_faults } = await openExploration(browser, { address });
    await filterBy(again, { which: "listed" });
    assert.equal(await count(again), await count(page));
    assert.equal(await again.locator("#ranges button").count(), 2);
    assert.deepEqual(new_faults, []);
    await again.context().close();
  });

  test("a range goes with its button, and with a click on its axis", async () => {
    const both = await count(page);
    await page.locator("#ranges button").last().click();
    await drawnLater(page);
    assert.ok((await count(page)) > both);
    const { x, top, height } = await axis(page, "uniformity mean");
    await page.mouse.click(x, top + 0.4 * height);
    await drawnLater(page);
    assert.equal(await page.locator("#ranges button").count(), 0);
    assert.equal(await count(page), designs.length);
  });

  test("a filter that leaves nothing says so in each place, and is cleared from there", async () => {
    await filterBy(page, { text: "no such thing" });
    for (const place of ["#pareto", "#parallel", "#designs"]) {
      const said = page.locator(`${place} .nothing`);
      assert.equal(await said.count(), 1, place);
      assert.match(await said.textContent(), /^No design passes the filter\./);
    }
    await page.locator("#pareto .nothing button").click();
    await drawnLater(page);
    assert.equal(await page.locator(".nothing").count(), 0);
    assert.equal(await page.locator("#filter-text").inputValue(), "");
    assert.equal((await tableWords(page)).length > 30, true);
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
