// The page of a diagnosis: what it answers and draws is what diagnosis.json and residuals.csv hold.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, describe, test } from "node:test";
import { csvRecords } from "./csv.mjs";
import { cut, open, phone, startBrowser, unfold } from "./harness.mjs";
import {
  barMarks,
  cell,
  column,
  countInSvg,
  pngSize,
  pointMarks,
  readMarks,
  saveButton,
  saved,
  schematicTitle,
} from "./looking.mjs";
import { theSeven } from "./pages.mjs";
import { besidePage, jsonBesidePage, pageFile } from "./places.mjs";

const verdicts = { seven: "indistinguishable", cause: "cause", none: "none", alike: "indistinguishable" };

for (const [kind, verdict] of Object.entries(verdicts)) {
  describe(`diagnose: ${kind}`, () => {
    const name = `diagnose-${kind}`;
    const diagnosis = jsonBesidePage(name, "diagnosis.json");
    const residuals = csvRecords(besidePage(name, "residuals.csv"));
    const panels = diagnosis.causes.length > 0 ? 2 : 1; // before, and after
    let browser;
    let page;
    let faults;
    before(async () => {
      browser = await startBrowser();
      ({ page, faults } = await open(browser, pageFile(name)));
    });
    after(() => browser.close());

    test("the verdict is the file's", async () => {
      assert.equal(diagnosis.verdict, verdict);
      assert.equal(await page.locator("#verdict").getAttribute("data-verdict"), verdict);
    });

    test("simulated data are called simulated", async () => {
      assert.equal(await page.locator("#simulated").count(), diagnosis.simulated ? 1 : 0);
    });

    test("the plot has a mark for each compared value, before and after, where the file says", async () => {
      assert.ok(residuals.length > 0);
      const shown = await readMarks(page.locator("#compared"));
      assert.equal(shown.length, panels);
      const greatest = Math.max(...residuals.map(({ measured_N }) => Number(measured_N)));
      for (const [panel, marks] of shown.entries()) {
        assert.equal(marks.length, residuals.length);
        const predicted = ["before_N", "after_N"][panel];
        const byName = new Map(residuals.map((row) => [`${row.line} ${row.channel}`, row]));
        for (const { x, y, title } of marks) {
          const [, channel, line] = / (\S+), run .*, line (\d+)/.exec(title);
          const row = byName.get(`${line} ${channel}`);
          assert.ok(Math.abs(y - row.measured_N) < 0.002 * greatest, `${title}: ${y}`);
          assert.ok(Math.abs(x - row[predicted]) < 0.005 * greatest, `${title}: ${x}`);
          assert.equal(title.includes("held out"), row.held_out === "true", title);
        }
      }
    });

    test("residuals by routing have a mark for each value", async () => {
      const [shown] = await readMarks(page.locator("#residuals-routing"));
      const of_values = shown.filter(({ title }) => title.includes("line "));
      assert.equal(of_values.length, residuals.length);
      for (const { title } of of_values) {
        const [, channel, line] = / (\S+), run .*, line (\d+)/.exec(title);
        const row = residuals.find((one) => one.line === line && one.channel === channel);
        const [, said] = /\n([-+][\d.e+-]+) sd$/.exec(title);
        const exact = Number(row.residual_before);
        assert.ok(Math.abs(said - exact) <= 0.006 * Math.abs(exact), `${title}: ${exact}`);
      }
    });

    test("the plot is saved with its marks", async () => {
      const figure = page.locator("#compared");
      const svg = await saved(page, saveButton(figure, "SVG"));
      const text = svg.bytes.toString("utf8");
      assert.equal(await countInSvg(page, text, pointMarks), panels * residuals.length);
      const png = await saved(page, saveButton(figure, "PNG"));
      assert.ok(pngSize(png.bytes).width > 600);
    });

    test("the named causes are the file's, with their sizes", async () => {
      const table = page.locator("#named-causes");
      const rows = diagnosis.causes.filter(({ parameters }) => parameters.length > 0);
      assert.equal(await table.count(), rows.length > 0 ? 1 : 0);
      for (const { name: cause, parameters } of rows) {
        const shown = Number(await cell(table, cause, "estimate"));
        assert.ok(Math.abs(shown - parameters[0].value) < 0.001, `${cause}: ${shown}`);
      }
    });

    test("the next measurement has the schematic of its routing", async () => {
      const next = diagnosis.next_measurement ?? diagnosis.separating_measurement;
      const schematic = page.locator("figure.schematic");
      assert.equal(await schematic.count(), next ? 1 : 0);
      if (!next) return;
      assert.ok((await schematicTitle(schematic)).includes(next.routing));
      const lead = await page.locator("details:has(#next) p.lead").first().textContent();
      assert.ok(lead.includes(next.routing), lead);
    });

    test("nothing went wrong meanwhile", () => assert.deepEqual(faults, []));
  });
}

// Heights of a chart's smallest figures, of those that are less than that.
const smallerThan = (page, least) =>
  page.locator(".chart .still svg").evaluateAll((all, limit) =>
    all.map((svg) => [svg.closest("figure").id, (12 * svg.getBoundingClientRect().width) / svg.viewBox.baseVal.width])
      .filter(([, px]) => px > 0 && px < limit), least);

for (const kind of Object.keys(verdicts)) {
  test(`diagnose: ${kind} on a phone has whole tables and charts that can be read`, async () => {
    const browser = await startBrowser();
    const { page, faults } = await open(browser, pageFile(`diagnose-${kind}`), { width: phone });
    await unfold(page);
    await page.waitForTimeout(300); // what is unfolded is fitted when the browser tells of it
    assert.deepEqual(await cut(page, ".scroll"), []);
    // Seven routings beside each other, as the paper has them.
    const small = (await smallerThan(page, 7.5)).filter(([id]) => !(kind === "seven" && id === "figure-9"));
    assert.deepEqual(small, []);
    assert.deepEqual(faults, []);
    await browser.close();
  });
}

// From the file of the readings and from the forecasts beside the page.
describe("diagnose: the tension distributions of TR1 to TR7", () => {
  const strands = ["T1", "T2", "T3", "T4"];
  const shares = (tensions) => {
    const sum = tensions.reduce((a, b) => a + b);
    return tensions.map((tension) => tension / sum);
  };
  const measured = csvRecords(readFileSync(theSeven, "utf8")).map((row) =>
    shares(strands.map((strand) => Number(row[`${strand}_N`]))),
  );
  const residuals = csvRecords(besidePage("diagnose-seven", "residuals.csv"));
  const forecast = (key) =>
    measured.map((_, i) => shares(residuals.slice(4 * i, 4 * i + 4).map((row) => Number(row[key]))));
  let browser;
  let page;
  before(async () => {
    browser = await startBrowser();
    ({ page } = await open(browser, pageFile("diagnose-seven")));
  });
  after(() => browser.close());

  test("the bars are the readings' shares, the same in each of three rows", async () => {
    const panels = await readMarks(page.locator("#figure-9"), barMarks);
    assert.equal(panels.length, 3 * 7);
    for (const [i, panel] of panels.entries()) {
      for (const [strand, { top }] of panel.entries()) {
        assert.ok(Math.abs(top - measured[i % 7][strand]) < 0.002, `${i}, ${strand}: ${top}`);
      }
    }
  });

  test("the line of the last row is the extended model's forecast", async () => {
    const panels = await readMarks(page.locator("#figure-9"));
    const after = forecast("after_N");
    for (const [i, panel] of panels.slice(14).entries()) {
      assert.equal(panel.length, 4);
      for (const [strand, { y }] of panel.entries()) {
        assert.ok(Math.abs(y - after[i][strand]) < 0.002, `${i}, ${strand}: ${y}`);
      }
    }
  });

  test("the table has the error of each routing", async () => {
    const table = page.locator("#share-errors");
    for (const [heading, key] of [
      ["nominal", "before_N"],
      ["extended", "after_N"],
    ]) {
      const shown = await column(table, heading);
      const errors = forecast(key).map((model, i) => Math.hypot(...model.map((s, k) => s - measured[i][k])));
      errors.push(errors.reduce((a, b) => a + b) / errors.length);
      assert.equal(shown.length, errors.length);
      for (const [i, error] of errors.entries()) {
        assert.ok(Math.abs(parseFloat(shown[i]) - 100 * error) < 0.051, `${heading} ${i}: ${shown[i]}`);
      }
    }
  });
});
