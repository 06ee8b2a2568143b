"use strict";

// Common parts of all pages: saving of figures, tables that sort, folds.
const reeve = (() => {
  function download(name, url) {
    const link = document.createElement("a");
    link.download = name;
    link.href = url;
    link.click();
  }

  const svgUrl = (text) => URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));

  function savePng(name, text) {
    const image = new Image();
    image.onload = () => {
      const scale = 3;
      const canvas = document.createElement("canvas");
      canvas.width = scale * image.width;
      canvas.height = scale * image.height;
      const context = canvas.getContext("2d");
      context.fillStyle = "white";
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => download(name, URL.createObjectURL(blob)), "image/png");
    };
    image.src = svgUrl(text);
  }

  function addSaving(figure, name, svgText) {
    const bar = document.createElement("div");
    bar.className = "save";
    const add = (kind, save) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = `Save ${kind}`;
      button.setAttribute("aria-label", `Save ${kind} of the figure ${name}`);
      button.addEventListener("click", async () => save(await svgText()));
      bar.append(button);
    };
    add("SVG", (text) => download(`${name}.svg`, svgUrl(text)));
    add("PNG", (text) => savePng(`${name}.png`, text));
    figure.append(bar);
  }

  // As it stands in the page, where styles that are none of its own follow the reader's scheme: a
  // saved figure has its own colours, on white, for papers.
  const stillSvg = (figure) => new XMLSerializer().serializeToString(figure.querySelector("svg"));

  // Adds saving to a figure, also to one that was put into the page later. The result of `svgText`,
  // or of its promise, is saved.
  function savable(figure, name = figure.dataset.file || figure.id, svgText = () => stillSvg(figure)) {
    addSaving(figure, name, svgText);
  }

  const key = (cell) => {
    const text = cell?.dataset.value ?? cell?.textContent.trim() ?? "";
    // A number may bear a unit, and a remark behind a comma: "0.12 N", "4.0 %, shared".
    const [, digits] = /^([-+]?[\d.]+(?:e[-+]?\d+)?)(?: \S+)?(?:, .*)?$/i.exec(text) ?? [];
    return digits === undefined || Number.isNaN(Number(digits)) ? text : Number(digits);
  };

  function compare(a, b) {
    const numbers = [typeof a === "number", typeof b === "number"];
    if (numbers[0] && numbers[1]) return a - b;
    if (numbers[0] !== numbers[1]) return numbers[0] ? -1 : 1;
    return a.localeCompare(b);
  }

  // Headings become buttons that sort by their column; cells may say what to sort by in data-value.
  function sortable(table) {
    const headings = [...table.tHead.rows[0].cells];
    headings.forEach((heading, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.append(...heading.childNodes);
      heading.append(button);
      button.addEventListener("click", () => {
        const down = heading.getAttribute("aria-sort") === "ascending";
        for (const other of headings) other.removeAttribute("aria-sort");
        heading.setAttribute("aria-sort", down ? "descending" : "ascending");
        const body = table.tBodies[0];
        const rows = [...body.rows].map((row) => [key(row.cells[column]), row]);
        rows.sort(([a], [b]) => (down ? compare(b, a) : compare(a, b)));
        body.append(...rows.map(([, row]) => row));
      });
    });
  }

  const phone = matchMedia("(max-width: 40rem)");

  // On a phone a table that is too wide has its rows one below the other, each value behind its heading.
  // Of more columns a row would fill the screen.
  function wrapTables() {
    for (const table of document.querySelectorAll(".scroll > table:not(.wraps)")) {
      const { clientWidth, scrollWidth } = table.parentElement;
      const labels = [...(table.tHead?.rows[0].cells ?? [])].map((heading) => heading.textContent);
      if (scrollWidth <= clientWidth || labels.length > 12) continue;
      table.classList.add("wraps");
      for (const { cells } of table.tBodies[0].rows) {
        for (const cell of cells) cell.dataset.label = labels[cell.cellIndex] ?? "";
      }
    }
  }

  // The keys of a legend, each of symbols and a text, in rows of that width. Returns their height.
  function flow(legend, left, width) {
    let [x, y, key] = [left, 0, []];
    for (const part of legend?.children ?? []) {
      key.push(part);
      if (part.tagName !== "text") continue;
      const from = key[0].getBBox().x;
      const { x: at, width: wide } = part.getBBox();
      if (x > left && x + at + wide - from > left + width) [x, y] = [left, y + 20];
      const down = y - Number(part.getAttribute("y"));
      for (const each of key) each.setAttribute("transform", `translate(${x - from} ${down})`);
      x += at + wide - from + 16;
      key = [];
    }
    return legend?.getBBox().height ?? 0;
  }

  // There panels that stand beside each other, too small to read, go below each other, unless they
  // share the numbers of an axis.
  function stackPanels() {
    for (const svg of document.querySelectorAll(".chart .still > svg:not([data-stacked])")) {
      const panels = [...svg.querySelectorAll(".reeve-panel")];
      const scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
      const isWhole = (panel) => panel.querySelector('text[text-anchor="end"]');
      if (panels.length < 2 || scale === 0 || scale > 0.8 || !panels.every(isWhole)) continue;
      svg.dataset.stacked = "";
      const widths = panels.map((panel) => panel.getBBox().width);
      const { x: left, y: top } = panels[0].getBBox();
      const width = Math.max(330, ...widths);
      let [x, y, bottom] = [left, top, top];
      panels.forEach((panel, i) => {
        if (x > left && x + widths[i] > left + width) [x, y] = [left, bottom];
        const box = panel.getBBox();
        panel.setAttribute("transform", `translate(${x - box.x} ${y - box.y})`);
        x += box.width + 8;
        bottom = Math.max(bottom, y + box.height + 16);
      });
      const legend = svg.querySelector(".reeve-legend");
      const height = bottom + flow(legend, left, width) + 8;
      legend?.setAttribute("transform", `translate(0 ${bottom - legend.getBBox().y})`);
      svg.setAttribute("viewBox", `0 0 ${left + width + 8} ${height}`);
      for (const each of [svg, svg.querySelector(".reeve-paper")]) {
        each.setAttribute("width", left + width + 8);
        each.setAttribute("height", height);
      }
    }
  }

  function fitPhone() {
    if (!phone.matches) return;
    wrapTables();
    stackPanels();
  }

  // On a phone what is below the first screen begins folded; what an address points at is open.
  function fold() {
    if (!phone.matches) return;
    for (const details of document.querySelectorAll("details.fold")) details.open = false;
    unfoldTarget();
  }

  function unfoldTarget() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    for (let at = target; at; at = at.parentElement) if (at.tagName === "DETAILS") at.open = true;
  }

  // Paper has everything.
  let closed = [];
  function unfoldAll() {
    closed = [...document.querySelectorAll("details:not([open])")];
    for (const details of closed) details.open = true;
  }
  function foldAgain() {
    for (const details of closed) details.open = false;
    closed = [];
  }
  addEventListener("beforeprint", unfoldAll);
  addEventListener("afterprint", foldAgain);
  matchMedia("print").addEventListener("change", ({ matches }) => (matches ? unfoldAll() : foldAgain()));
  addEventListener("hashchange", unfoldTarget);
  // Charts that are as wide as their place have to see it.
  document.addEventListener("toggle", () => dispatchEvent(new Event("resize")), true);
  addEventListener("resize", fitPhone);

  // Links to the headings, where a page is longer than three screens.
  function addContents() {
    if (document.documentElement.scrollHeight <= 3 * innerHeight) return;
    const headings = [...document.querySelectorAll("main h2")].filter((each) => !each.closest(".slot, .answer"));
    if (headings.length < 3) return;
    const links = headings.map((heading, i) => {
      const place = heading.closest("section[id], details[id]") ?? heading;
      place.id ||= `contents-${i + 1}`;
      const link = document.createElement("a");
      link.href = `#${place.id}`;
      link.textContent = heading.textContent;
      return link;
    });
    const contents = document.createElement("nav");
    contents.id = "contents";
    contents.className = "controls";
    contents.setAttribute("aria-label", "On this page");
    const list = document.createElement("details");
    list.open = !document.querySelector("main.wide") && !phone.matches;
    const summary = document.createElement("summary");
    summary.textContent = "On this page";
    list.append(summary, ...links);
    contents.append(list);
    document.querySelector("main h1").after(contents);
  }

  addContents();
  for (const figure of document.querySelectorAll("figure.schematic, figure.chart")) {
    if (!figure.querySelector(".live")) savable(figure);
  }
  for (const table of document.querySelectorAll("table.sortable")) sortable(table);
  fitPhone();
  // Live charts are drawn first, while their places can be seen.
  if (!document.querySelector(".live")) fold();

  return {
    data: JSON.parse(document.getElementById("page-data").textContent),
    savable,
    sortable,
    fold,
  };
})();
