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

  // The designs that none beats in both, and those on the nearest places, of what designs.csv has.
  const near = () => {
    const place = (one) => [one.uniformity_mean, one.efficiency_mean].map((value) => Number(Number(value).toPrecision(8)));
    const places = designs.map(place);
    const edge = places.filter((one) => !places.some((other) =>
      other[0] >= one[0] && other[1] >= one[1] && (other[0] > one[0] || other[1] > one[1])));
    const bounds = (some, axis) => [Math.min(...some.map((one) => one[axis])), Math.max(...some.map((one) => one[axis]))];
    const far = (one) => Math.max(...[0, 1].map((axis) => {
      const [low, high] = bounds(places, axis);
      return Math.max(0, bounds(edge, axis)[0] - one[axis]) / (high - low);
    }));
    const distances = [...new Map(places.map((one) => [one.join(), far(one)])).values()].sort((a, b) => a - b);
    return designs.filter((one) => far(place(one)) <= distances[7]);
  };

  test("it opens about the front, and all is one button away", async () => {
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

  test("arrows reach each design in the order of the ranking, and Enter selects", async () => {
    await page.locator("#clear").click();
    await page.locator("#pareto .live").focus();
    const at = async () => (await page.locator("#pointed").textContent()).split("; ")[0].split(": ").pop();
    const reached = [];
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press("ArrowRight");
      reached.push(await at());
    }
    assert.deepEqual(reached, words.slice(0, 60));
    await page.keyboard.press("End");
    assert.equal(await at(), words.at(-1));
    const value = (key) => Number(designs.at(-1)[key]);
    const [left, right, low, high] = await reach();
    assert.ok(left <= value("uniformity_mean") && value("uniformity_mean") <= right, "in view across");
    assert.ok(low <= value("efficiency_mean") && value("efficiency_mean") <= high, "in view upwards");
    await page.keyboard.press("ArrowLeft");
    assert.equal(await at(), words.at(-2));
    await page.keyboard.press("Enter");
    await page.locator(`.card[data-word="${words.at(-2)}"]`).waitFor();
    await page.locator("#clear").click();
    await page.locator("#view-near").click();
    await still(page);
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
    const address = await page.evaluate(() => location.hash);
    const anyPart = async () => {
      for (const select of await page.locator("#part-choices select").all()) await select.selectOption("");
      await still(page);
      assert.equal(await page.locator("#gallery .found").count(), 0);
    };
    await anyPart();
    await page.evaluate((hash) => (location.hash = hash), address);
    await still(page);
    assert.equal(await page.locator("#gallery .found").count(), firsts.length, "the address has the parts");
    await anyPart();
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
