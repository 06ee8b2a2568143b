// What a reader sees: marks, tables, schematics; and what a reader saves.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

// Symbols and bars of a chart's data; those of its legend are no marks.
export const pointMarks = ".reeve-points > *";
export const barMarks = ".reeve-bars > *";
export const marks = (figure) => figure.locator(`.still ${pointMarks}`);
export const bars = (figure) => figure.locator(`.still ${barMarks}`);

// What a chart shows who reads it with a ruler: for each panel its marks of that kind, with the values
// that they have by the numbers at the two outermost ticks of each axis. A panel without numbers at
// its y axis has those of the panel before it. An axis without numbers gives none.
export const readMarks = (figure, selector = pointMarks) =>
  figure.locator(".still svg").evaluate((svg, wanted) => {
    const number = (text) => {
      const plain = text.replace("−", "-").replace("+", "");
      return plain.endsWith("%") ? parseFloat(plain) / 100 : Number(plain);
    };
    // Of a symbol with corners their middle, which is not that of the box round a triangle.
    const middle = (element) => {
      const { x, y, width, height } = element.getBBox();
      const path = element.getAttribute("d") ?? "";
      if (!path.endsWith("Z")) return { x: x + width / 2, y: y + height / 2, top: y };
      const corners = path.slice(1, -1).split("L").map((corner) => corner.split(" ").map(Number));
      const mean = (axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / corners.length;
      return { x: mean(0), y: mean(1), top: y };
    };
    const scale = (ticks) => {
      if (ticks.length < 2) return () => undefined;
      const [a, b] = [ticks[0], ticks[ticks.length - 1]];
      return (at) => a.value + ((at - a.at) / (b.at - a.at)) * (b.value - a.value);
    };
    let upright = [];
    let above = 0;
    return [...svg.querySelectorAll(".reeve-panel")].map((panel) => {
      const frame = middle(panel.querySelector(":scope > rect")).top;
      const texts = [...panel.querySelectorAll('.reeve-axes > text[font-size="12"][x]')];
      const ticks = (anchor, along) =>
        texts
          .filter((text) => text.getAttribute("text-anchor") === anchor)
          .map((text) => ({ at: along(text), value: number(text.textContent) }))
          .filter(({ value }) => !Number.isNaN(value));
      // The middle of a figure's height, as the program puts it there.
      const y = ticks("end", (text) => Number(text.getAttribute("y")) - 0.36 * 12);
      upright = y.length > 0 ? y : upright.map(({ at, value }) => ({ at: at + frame - above, value }));
      above = frame;
      const [xOf, yOf] = [scale(ticks("middle", (text) => Number(text.getAttribute("x")))), scale(upright)];
      return [...panel.querySelectorAll(wanted)].map((mark) => {
        const place = middle(mark);
        const title = mark.querySelector("title")?.textContent ?? "";
        return { x: xOf(place.x), y: yOf(place.y), top: yOf(place.top), title };
      });
    });
  }, selector);

// The texts of a column of a table, from its heading; rows that are hidden are left out.
export async function column(table, heading) {
  return table.evaluate((element, text) => {
    const headings = [...element.tHead.rows[element.tHead.rows.length - 1].cells];
    const index = headings.findIndex((cell) => cell.textContent.trim() === text);
    if (index < 0) {
      throw new Error(`no column '${text}' among ${headings.map((cell) => cell.textContent)}`);
    }
    return [...element.tBodies[0].rows]
      .filter((row) => row.getClientRects().length > 0)
      .map((row) => row.cells[index].textContent.trim());
  }, heading);
}

export const sortButton = (table, heading) =>
  table.locator("thead").getByRole("button", { name: heading, exact: true });

// A cell of the row with that heading, under that column's heading.
export const cell = (table, row, heading) =>
  table.evaluate(
    (element, [rowText, columnText]) => {
      const text = (node) => node.textContent.trim();
      const index = [...element.tHead.rows[0].cells].map(text).indexOf(columnText);
      const rows = [...element.tBodies[0].rows].filter((one) => text(one.cells[0]) === rowText);
      if (index < 0 || rows.length !== 1) throw new Error(`no ${rowText}, ${columnText}`);
      return text(rows[0].cells[index]);
    },
    [row, heading],
  );

// The headline of a schematic, which names its routing.
export const schematicTitle = (schematic) =>
  schematic.locator("svg > title").first().textContent();

// The tensions that a schematic tells who cannot see it: {a: 0.868, T1: 0.28, …}.
export async function schematicTensions(schematic) {
  const description = await schematic.locator("svg > desc").first().textContent();
  const [, list] = /Tensions: (.*)$/.exec(description);
  const words = list.split(" ");
  const tensions = {};
  for (let i = 0; i < words.length; i += 2) tensions[words[i]] = Number(words[i + 1]);
  return tensions;
}

// Of tables and drawings, which show three decimals.
export function sameToThreeDecimals(shown, exact) {
  assert.deepEqual(Object.keys(shown).sort(), Object.keys(exact).sort());
  for (const [name, value] of Object.entries(exact)) {
    const off = Math.abs(shown[name] - value);
    assert.ok(off < 0.000501, `${name}: shown ${shown[name]}, is ${value}`);
  }
}

// Presses the button and returns the file that the page gives.
export async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

export const saveButton = (figure, kind) =>
  figure.locator(".save").getByText(`Save ${kind}`, { exact: true });

// Throws if the text is no XML. Counts elements by a selector.
export const countInSvg = (page, text, selector) =>
  page.evaluate(
    ([markup, wanted]) => {
      const parsed = new DOMParser().parseFromString(markup, "image/svg+xml");
      const error = parsed.querySelector("parsererror");
      if (error) throw new Error(error.textContent);
      return parsed.querySelectorAll(wanted).length;
    },
    [text, selector],
  );

// Width and height of a PNG, from its header; throws if it is none.
export function pngSize(bytes) {
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  if (!bytes.subarray(0, 8).equals(signature)) throw new Error("not a PNG");
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}

// Moves the focus with the Tab key alone until it is on `target`.
export async function tabTo(page, target, most = 400) {
  for (let i = 0; i < most; ++i) {
    await page.keyboard.press("Tab");
    if (await target.evaluate((element) => element === document.activeElement)) return;
  }
  throw new Error(`not reached with ${most} presses of Tab`);
}
