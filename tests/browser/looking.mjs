// What a reader sees: marks, tables, schematics; and what a reader saves.
import { readFileSync } from "node:fs";

// Symbols of a chart's data; those of its legends and axes are no marks.
export const marks = (figure) => figure.locator(".live .mark-symbol.role-mark > path");

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

// The headline of a schematic, which names its routing.
export const schematicTitle = (schematic) =>
  schematic.locator("svg > title").first().textContent();

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
