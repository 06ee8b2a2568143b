// The plot of an exploration, and the designs that are selected in it.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import {
  byWord,
  card,
  clearSelection,
  designs,
  drawn,
  filterBy,
  openExploration,
  summary,
  withExploration,
} from "./exploration.mjs";
import { settled } from "./harness.mjs";
import {
  countInSvg,
  pngSize,
  sameToThreeDecimals,
  saveButton,
  saved,
  schematicTensions,
  schematicTitle,
} from "./looking.mjs";
import { reeveJson } from "./places.mjs";

const near = (a, b) => Math.abs(a - b) <= 1e-5 * Math.max(1, Math.abs(b));

// How many differ in what these columns say.
const different = (some, keys) => new Set(some.map((one) => keys.map((key) => one[key]).join())).size;

describe("explore: the plot", () => {
  const axes = ["uniformity_mean", "efficiency_mean"];
  let browser;
  let page;
  let faults;
  withExploration((opened) => ({ browser, page, faults } = opened));

  test("all designs are one button away", async () => {
    await page.locator("#view-all").click();
    await settled(page);
    assert.equal(await page.locator("#view-all").getAttribute("aria-pressed"), "true");
  });

  async function lieWhereTheFileSays(marks, [x, y]) {
    for (const mark of marks) {
      const design = byWord.get(mark.word);
      assert.ok(design, `${mark.word} is not in designs.csv`);
      assert.ok(near(mark.x, Number(design[x])), `${mark.word}: x ${mark.x}, is ${design[x]}`);
      assert.ok(near(mark.y, Number(design[y])), `${mark.word}: y ${mark.y}, is ${design[y]}`);
    }
  }

  test("every listed design is in a mark, and every mark where designs.csv says", async () => {
    await filterBy(page, { which: "listed" });
    const marks = await drawn(page);
    await lieWhereTheFileSays(marks, axes);
    const shown = marks.reduce((sum, mark) => sum + mark.designs, 0);
    assert.equal(shown, summary.top.length);
    assert.ok(marks.length <= different(designs, ["routing"]));
    assert.ok(marks.length > 0.5 * different(designs, axes), `${marks.length} marks`);
    const said = await page.locator("#pareto-count").textContent();
    assert.ok(said.startsWith(`${marks.length} of ${summary.top.length} designs drawn`), said);
  });

  test("each known routing has a mark of its own", async () => {
    await filterBy(page, { which: "known" });
    const words = (await drawn(page)).map(({ word }) => word).sort();
    assert.deepEqual(words, summary.known.map(({ routing }) => routing).sort());
  });

  test("the front has as many marks as places", async () => {
    await filterBy(page, { which: "front" });
    const marks = await drawn(page);
    const known = new Set(summary.known.map(({ routing }) => routing));
    const words = summary.front.map(({ routing }) => routing);
    const others = words.filter((word) => !known.has(word)).map((word) => byWord.get(word));
    assert.equal(marks.length, words.length - others.length + different(others, axes));
    assert.equal(marks.reduce((sum, mark) => sum + mark.designs, 0), summary.front.length);
  });

  // A busy machine may take long until the plot is drawn anew; its axes then have these titles.
  async function chooseAxes(x, y) {
    await page.locator("#x-axis").selectOption({ label: x });
    await page.locator("#y-axis").selectOption({ label: y });
    for (const label of [x, y]) {
      const title = page.locator("#pareto .live .role-axis-title text");
      await title.filter({ hasText: label.split(" (")[0] }).first().waitFor({ state: "attached" });
    }
    await settled(page);
  }

  test("other axes show other columns", async () => {
    await filterBy(page, { which: "listed" });
    await chooseAxes("sheaths (lower is better)", "force transmission (higher is better)");
    await lieWhereTheFileSays(await drawn(page), ["sheaths", "force_transmission"]);
    const titles = await page.locator("#pareto .live .role-axis-title text").allTextContents();
    assert.ok(titles.some((title) => title.startsWith("sheaths")), titles.join());
    assert.ok(titles.some((title) => title.startsWith("force transmission")), titles.join());
    await chooseAxes("uniformity mean (higher is better)", "efficiency mean (higher is better)");
  });

  const ticks = (which) =>
    page.locator(`#pareto .live .role-axis:has(.role-axis-title) .role-axis-label text`).evaluateAll(
      (texts, wanted) => {
        const axis = texts.map((text) => ({ text: text.textContent, of: text.closest(".role-axis") }));
        const axes = [...new Set(axis.map(({ of }) => of))];
        return axis.filter(({ of }) => axes.indexOf(of) === wanted).map(({ text }) => text);
      },
      which,
    );

  test("no axis has numbers beyond what is possible, and counts have whole ones", async () => {
    const across = (await ticks(0)).map(Number);
    assert.ok(across.length > 3 && across.every((value) => value >= 0 && value <= 1), across.join());
    await chooseAxes("sheaths (lower is better)", "knots (lower is better)");
    for (const which of [0, 1]) {
      const texts = await ticks(which);
      assert.ok(texts.length > 0 && texts.every((text) => /^\d+$/.test(text)), texts.join());
      assert.equal(new Set(texts).size, texts.length);
    }
    await chooseAxes("uniformity mean (higher is better)", "efficiency mean (higher is better)");
  });

  test("names in the plot lie neither over each other nor over the letters", async () => {
    await page.locator("#view-all").click();
    await settled(page);
    const boxes = await page.locator("#pareto .live .mark-text.role-mark text").evaluateAll((texts) =>
      texts.filter((text) => text.textContent.trim()).map((text) => {
        const { left, right, top, bottom } = text.getBoundingClientRect();
        return { text: text.textContent, left, right, top, bottom };
      }));
    const said = boxes.map(({ text }) => text).join(" ");
    for (const part of ["TR1", "knee", "within 2 %", "A", "B"]) assert.ok(said.includes(part), said);
    boxes.forEach((a, i) => {
      for (const b of boxes.slice(i + 1)) {
        const apart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top + 2 || b.bottom <= a.top + 2;
        assert.ok(apart, `${a.text} over ${b.text}`);
      }
    });
  });

  test("words are explained below their headings, by keyboard", async () => {
    for (const [place, words] of [
      ["#tradeoff", ["gain", "kept", "knee"]],
      ["#plots", ["front", "alike", "jams", "knots", "travel"]],
    ]) {
      const summary = page.locator(`${place} .glossary summary`);
      await summary.focus();
      await page.keyboard.press("Enter");
      const terms = await page.locator(`${place} .glossary dt`).allTextContents();
      for (const word of words) assert.ok(terms.includes(word), `${place}: ${terms}`);
      assert.ok(await page.locator(`${place} .glossary dd`).first().isVisible());
      await page.keyboard.press("Enter");
    }
  });

  test("a click on a mark shows its design: schematic, tensions of each grasp", async () => {
    await clearSelection(page);
    await filterBy(page, { which: "known" });
    const word = "M-1-T-2-F";
    const at = (await drawn(page)).findIndex((mark) => mark.word === word);
    await page.locator("#pareto .live .designs_marks > path").nth(at).click();
    const shown = card(page, word);
    await shown.locator("figure.schematic svg").waitFor();
    assert.equal(await page.locator(".card").count(), 1);
    const expected = reeveJson(["show", word]);
    const choice = page.locator("#grasp");
    for (const [i, grasp] of expected.grasps.entries()) {
      await choice.selectOption({ index: i });
      await settled(page);
      const schematic = shown.locator("figure.schematic");
      assert.ok((await schematicTitle(schematic)).includes(word));
      sameToThreeDecimals(await schematicTensions(schematic), grasp.tensions);
    }
    await choice.selectOption({ index: 0 });
  });

  test("two designs stand side by side, each with its own schematic", async () => {
    await filterBy(page, { which: "known" });
    const word = "M-1-P-2-M";
    const at = (await drawn(page)).findIndex((mark) => mark.word === word);
    await page.locator("#pareto .live .designs_marks > path").nth(at).click();
    await card(page, word).locator("figure.schematic svg").waitFor();
    await settled(page);
    const places = await page.locator(".card").evaluateAll((cards) =>
      cards.map((one) => {
        const { left, right, top } = one.getBoundingClientRect();
        return { word: one.dataset.word, left, right, top };
      }),
    );
    assert.deepEqual(places.map((place) => place.word), ["M-1-T-2-F", word]);
    assert.ok(places[0].right <= places[1].left && places[0].top === places[1].top);
    for (const { word: each } of places) {
      assert.ok((await schematicTitle(card(page, each).locator(".schematic"))).includes(each));
    }
  });

  test("the address brings the selection back", async () => {
    const address = new URL(page.url()).hash;
    const { page: again, faults: new_faults } = await openExploration(browser, { address });
    const words = await again.locator(".card").evaluateAll((cards) =>
      cards.map((one) => one.dataset.word),
    );
    assert.deepEqual(words, ["M-1-T-2-F", "M-1-P-2-M"]);
    assert.deepEqual(new_faults, []);
    await again.context().close();
  });

  test("Save SVG and Save PNG give the plot with its marks", async () => {
    const count = (await drawn(page)).length;
    const svg = await saved(page, saveButton(page.locator("#pareto"), "SVG"));
    const text = svg.bytes.toString("utf8");
    assert.equal(await countInSvg(page, text, ".designs_marks > path"), count);
    const png = await saved(page, saveButton(page.locator("#pareto"), "PNG"));
    assert.ok(pngSize(png.bytes).width > 1000 && pngSize(png.bytes).height > 1000);
  });

  test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
});
