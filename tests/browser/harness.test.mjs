// Can the checks fail? The sample page, spoilt in one way each, must be found out.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { accessibilityFaults, open, phone, scrollWidth, startBrowser, tooWide } from "./harness.mjs";
import { pageFile, written } from "./places.mjs";
import { outlineFaults, figureFaults, staticFaults, textFaults } from "./structure.mjs";

const folder = join(written, "spoilt");

function spoilt(name, from, to) {
  const good = readFileSync(pageFile("sample"), "utf8");
  assert.ok(good.includes(from), `the sample has no ${from}`);
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `${name}.html`);
  writeFileSync(file, good.replace(from, () => to));
  return file;
}

const inserted = (name, markup) => spoilt(name, "<h2>Table</h2>", `<h2>Table</h2>${markup}`);

describe("the checks", () => {
  let browser;
  before(async () => {
    browser = await startBrowser();
  });
  after(() => browser.close());

  async function opened(file, options) {
    const { page, faults } = await open(browser, file, options);
    return { page, faults };
  }

  const some = (faults, pattern) =>
    assert.ok(faults.some((fault) => pattern.test(fault)), `no ${pattern} in [${faults}]`);

  test("see a console error, an uncaught error and a dialog", async () => {
    const script = "<script>console.error('ouch'); setTimeout(() => { throw Error('uh') });</script>";
    const { page, faults } = await opened(inserted("errors", script));
    await page.evaluate(() => alert("hello"));
    some(faults, /console: ouch/);
    some(faults, /uncaught: uh/);
    some(faults, /dialog: hello/);
  });

  test("see what the security policy refuses", async () => {
    const { faults } = await opened(inserted("refused", '<img alt="" src="http://a.invalid/i.png">'));
    some(faults, /console: .*Content Security Policy/);
  });

  test("see a request to the network or to another file", async () => {
    const policy = /<meta http-equiv="Content-Security-Policy"[^>]*>/;
    const file = inserted("requests", '<img alt="" src="http://a.invalid/i.png"><img alt="" src="b.png">');
    writeFileSync(file, readFileSync(file, "utf8").replace(policy, ""));
    const { faults } = await opened(file);
    some(faults, /request: http:\/\/a\.invalid/);
    some(faults, /request: file:.*b\.png/);
  });

  test("see a page that is wider than the phone, and what makes it so", async () => {
    const wide = '<div id="wide" style="width: 500px">wide</div>';
    const { page } = await opened(inserted("wide", wide), { width: phone });
    assert.ok((await scrollWidth(page)) > phone);
    some(await tooWide(page, phone), /wide/);
  });

  test("see grey on grey and a button without a name", async () => {
    const markup = '<p style="color: #999; background: #aaa">faint</p><button></button>';
    const { page } = await opened(inserted("faint", markup));
    const found = await accessibilityFaults(page);
    some(found, /color-contrast/);
    some(found, /button-name/);
  });

  test("see headings out of order, a table without a caption, two equal ids", async () => {
    const markup = '<h4 id="points">deep</h4><table><tr><th>x</th></tr></table>';
    const found = await outlineFaults((await opened(inserted("outline", markup))).page);
    some(found, /h4 after h2/);
    some(found, /no caption/);
    some(found, /th without scope/);
    some(found, /two ids points/);
  });

  test("see a chart that is not drawn, and one that is there twice", async () => {
    const hidden = "<style>.still svg { display: none !important }</style>";
    const gone = await figureFaults((await opened(inserted("figures", hidden))).page);
    some(gone, /points is not drawn/);
    const svg = '<svg role="img" aria-label="again" width="300" height="200"></svg>';
    const again = `<div class="still">${svg}</div><figcaption>`;
    const twice = spoilt("twice", "<figcaption>", again);
    some(await figureFaults((await opened(twice)).page), /points is there twice/);
  });

  test("see a chart that says nothing to who cannot see it", async () => {
    const file = spoilt("mute", 'role="img" aria-label="Twelve', 'role="img" data-label="Twelve');
    const { page } = await opened(file);
    some(await figureFaults(page), /points has no text/);
    some(await staticFaults(page), /points has no text/);
  });

  test("see a still figure that is missing without JavaScript", async () => {
    const file = inserted("static", "<style>.still svg { display: none !important }</style>");
    const { page } = await opened(file, { javaScriptEnabled: false });
    some(await staticFaults(page), /points: no figure/);
  });

  test("see values that are none, and a text that was run", async () => {
    const markup = "<p>gain NaN, undefined</p><script>window.stolen = 1</script>";
    const found = await textFaults((await opened(inserted("texts", markup))).page);
    some(found, /NaN/);
    some(found, /undefined/);
    some(found, /run as a script/);
  });
});
