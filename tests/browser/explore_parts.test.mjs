// The plot's view about the front, and the filter by parts, of an exploration of three fingers.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { csvRecords } from "./csv.mjs";
import { drawn, withExploration } from "./exploration.mjs";
import { settled } from "./harness.mjs";
import { besidePage } from "./places.mjs";

const name = "explore-3";
const designs = csvRecords(besidePage(name, "designs.csv"));
const words = designs.map(({ routing }) => routing);

async function still(page) {
  await page.waitForTimeout(250); // the page waits whether more is typed, or moved
  await settled(page);
}

describe("explore: about the front and by parts", () => {
  let page;
  let faults;
  withExploration((opened) => ({ page, faults } = opened), name);

  // The best tenth of both spreads, of what designs.csv has.
  const near = () => {
    const values = ["uniformity_mean", "efficiency_mean"].map((key) => designs.map((one) => Number(one[key])));
    const least = values.map((column) => Math.max(...column) - 0.1 * (Math.max(...column) - Math.min(...column)));
    return designs.filter((one) =>
      Number(one.uniformity_mean) >= least[0] && Number(one.efficiency_mean) >= least[1]);
  };

  test("it opens with the best tenth, and all is one button away", async () => {
    await page.locator("#filter-which").selectOption("listed");
    await still(page);
    assert.equal(await page.locator("#view-near").getAttribute("aria-pressed"), "true");
    const shown = await drawn(page);
    assert.equal(shown.reduce((sum, mark) => sum + mark.designs, 0), near().length);
    assert.match(await page.locator("#pareto-count").textContent(),
      new RegExp(`; ${designs.length - near().length} lie outside this view`));
    await page.locator("#view-all").click();
    await still(page);
    assert.equal((await drawn(page)).reduce((sum, mark) => sum + mark.designs, 0), designs.length);
    await page.locator("#view-near").click();
    await still(page);
  });

  const reach = () => page.evaluate(() => liveCharts.view(document.getElementById("pareto")).signal("reach"));

  test("it zooms by button, key and wheel, and moves by dragging", async () => {
    const [left, right] = await reach();
    await page.locator("#zoom-in").click();
    await still(page);
    const [closer, far] = await reach();
    assert.ok(closer > left && far < right, `${closer} ${far}`);
    const box = await page.locator("#pareto .live svg").boundingBox();
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(...middle);
    await page.mouse.down();
    await page.mouse.move(middle[0] + 80, middle[1], { steps: 4 });
    await page.mouse.up();
    await still(page);
    const [moved] = await reach();
    assert.ok(moved < closer, `${moved}`);
    await page.mouse.move(...middle);
    await page.keyboard.down("Control");
    await page.mouse.wheel(0, 100);
    await page.keyboard.up("Control");
    await still(page);
    const [wide, end] = await reach();
    assert.ok(end - wide > (far - closer) * 1.2, `${wide} ${end}`);
    await page.locator("#pareto .live").focus();
    await page.keyboard.press("+");
    await still(page);
    const [again, last] = await reach();
    assert.ok(last - again < end - wide);
    await page.locator("#view-near").click();
    await still(page);
    assert.equal(await page.locator(".card").count(), 2, "dragging selects nothing");
  });

  test("arrows reach the marks, and Enter selects", async () => {
    await page.locator("#clear").click();
    await page.locator("#pareto .live").focus();
    await page.keyboard.press("ArrowLeft");
    const at = async () => (await page.locator("#pointed").textContent()).split("; ")[0].split(": ").pop();
    const first = await at();
    assert.ok(words.includes(first), first);
    await page.keyboard.press("ArrowLeft");
    const second = await at();
    const x = (word) => Number(designs.find(({ routing }) => routing === word).uniformity_mean);
    assert.ok(x(second) < x(first), `${second} is not left of ${first}`);
    await page.keyboard.press("Enter");
    await page.locator(`.card[data-word="${second}"]`).waitFor();
    await page.locator("#clear").click();
  });

  // What designs.csv counts is counted by the program, and not from the word.
  test("parts that the page reads from a word are those that the program counts", async () => {
    const read = await page.evaluate((all) => all.map((word) => ({
      sheaths: explorationParts.sheaths(word),
      ...Object.fromEntries(explorationParts.kinds.map(([key, , has]) => [key, has(word)])),
    })), words);
    designs.forEach((design, i) => {
      assert.equal(read[i].sheaths, Number(design.sheaths), words[i]);
      assert.equal(read[i].loop, Number(design.knots) > 0, words[i]);
      assert.equal(read[i].floating, Number(design.blocks ?? 0) > 0, words[i]);
      assert.equal(read[i].tip_bearing || read[i].pulley || read[i].carriage_pulley, Number(design.pulleys) > 0, words[i]);
    });
  });

  test("choices of parts narrow table, plot and drawings", async () => {
    const choice = (text) => page.locator("#part-choices label").filter({ hasText: text }).locator("select");
    await choice("sheaths").selectOption("1");
    await choice("an end tied at the hand").selectOption("with");
    await choice("several tendons").selectOption("without");
    await choice("a bearing at a fingertip").selectOption("without");
    await still(page);
    const left = designs.filter(({ routing, sheaths }) =>
      sheaths === "1" && /^F-|-F$/.test(routing) && !routing.includes("+") && !routing.includes("b"));
    assert.ok(left.length > 1 && left.length < 12, `${left.length}`);
    const table = await page.locator("#designs tbody tr").evaluateAll((rows) => rows.map((row) => row.dataset.word));
    const firsts = left.filter(({ same_as }) => !left.some(({ routing }) => routing === same_as));
    assert.deepEqual(table, firsts.map(({ routing }) => routing));
    const found = await page.locator("#gallery .found").evaluateAll((all) =>
      all.map((one) => ({ word: one.textContent, drawn: one.querySelector("svg") !== null })));
    assert.equal(found.length, firsts.length);
    assert.ok(found.every((one) => one.drawn));
    await page.locator("#gallery .found").first().click();
    await page.locator(`.card[data-word="${table[0]}"]`).waitFor();
    for (const select of await page.locator("#part-choices select").all()) await select.selectOption("");
    await still(page);
    assert.equal(await page.locator("#gallery .found").count(), 0);
  });

  test("every listed design can be drawn", async () => {
    const missing = await page.evaluate(async (all) => {
      const without = [];
      for (const word of all) {
        const design = await explorationDetails.of(word);
        const svg = design && explorationDetails.schematic(design, 0, "test");
        if (!svg?.textContent.includes(word)) without.push(word);
      }
      return without;
    }, words);
    assert.deepEqual(missing, []);
  });

  test("headings are listed at the top, and lead there", async () => {
    const links = await page.locator("#contents a").evaluateAll((all) =>
      all.map((link) => [link.textContent, document.querySelector(link.hash)?.textContent.includes(link.textContent)]));
    assert.ok(links.length >= 5 && links.every(([, leads]) => leads), JSON.stringify(links));
  });

  test("bars of tensions are on paper, too", async () => {
    await page.emulateMedia({ media: "print" });
    const adjust = await page.locator("#slots .bars span").first()
      .evaluate((bar) => getComputedStyle(bar).printColorAdjust);
    assert.equal(adjust, "exact");
    assert.equal(await page.locator("#contents").isVisible(), false);
    await page.emulateMedia({ media: "screen" });
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
