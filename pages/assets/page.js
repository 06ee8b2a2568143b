"use strict";

// What all pages share: charts that come alive, saving of figures, tables that sort.
const reeve = (() => {
  const themes = JSON.parse(document.getElementById("chart-theme").textContent);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const charts = new Map(); // figure -> {spec, view, onView}

  const parsed = (spec, theme) =>
    vega.parse(vegaLite.compile({ ...spec, config: theme, background: "transparent" }).spec);

  const axisWidth = 70;
  function room() {
    const main = document.getElementById("main");
    const style = getComputedStyle(main);
    return main.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  }

  // Panels of a facet go into as many columns as the window has room for.
  function fitted(spec) {
    if (spec.vconcat) return { ...spec, vconcat: spec.vconcat.map(fitted) };
    const panel = spec.usermeta?.panel_px;
    if (!spec.columns || !panel) return spec;
    const columns = Math.max(1, Math.floor((room() - axisWidth) / panel));
    return { ...spec, columns: Math.min(spec.columns, columns) };
  }

  // Draws, or draws anew with another specification; the figure keeps its static picture for print.
  // `onView` is called for each new view, so that it can listen to it.
  async function draw(figure, spec, onView = charts.get(figure)?.onView) {
    charts.get(figure)?.view.finalize();
    const container = figure.querySelector(".live");
    figure.classList.add("is-live"); // first: a hidden container has no width
    const shown = fitted(spec);
    const view = new vega.View(parsed(shown, dark.matches ? themes.dark : themes.light), {
      renderer: "svg",
      container,
      hover: true,
    });
    charts.set(figure, { spec, shown, view, onView });
    await view.runAsync();
    onView?.(view);
    return view;
  }

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

  // As the reader sees it, but on white: saved figures go into papers.
  async function chartSvg(figure) {
    const { shown, view } = charts.get(figure);
    const width = view.width();
    const sized = shown.width === "container" ? { ...shown, width } : shown;
    const copy = new vega.View(parsed(sized, themes.light), { renderer: "none" });
    await copy.runAsync(); // first: a chart that never ran has no parts to take a state
    copy.setState(view.getState());
    copy.background("white"); // last: the background is part of the state
    const svg = await copy.toSVG();
    copy.finalize();
    return svg;
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

  const schematicSvg = (figure) =>
    new XMLSerializer().serializeToString(figure.querySelector("svg"));

  // Of a figure that was put into the page later, too: a schematic, or a chart that was drawn.
  function savable(figure, name = figure.id) {
    addSaving(figure, name, () => (charts.has(figure) ? chartSvg(figure) : schematicSvg(figure)));
  }

  // Before the figure is taken out of the page.
  function forget(figure) {
    charts.get(figure)?.view.finalize();
    charts.delete(figure);
  }

  const key = (cell) => {
    const text = cell?.dataset.value ?? cell?.textContent.trim() ?? "";
    // A number may bear a unit: "0.12 N".
    const [, digits] = /^([-+]?[\d.]+(?:e[-+]?\d+)?)(?: \S+)?$/i.exec(text) ?? [];
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

  const ready = Promise.all(
    [...document.querySelectorAll("figure.chart")].map(async (figure) => {
      const spec = JSON.parse(figure.querySelector("script.spec").textContent);
      if (spec === null) return; // the page's own script draws it
      await draw(figure, spec);
      addSaving(figure, figure.id, () => chartSvg(figure));
    }),
  );
  for (const figure of document.querySelectorAll("figure.schematic")) savable(figure);
  for (const table of document.querySelectorAll("table.sortable")) sortable(table);
  dark.addEventListener("change", () => {
    for (const [figure, chart] of charts) draw(figure, chart.spec);
  });

  addEventListener("resize", () => {
    for (const [figure, { spec, shown }] of charts) {
      if (JSON.stringify(fitted(spec)) !== JSON.stringify(shown)) draw(figure, spec);
    }
  });

  return {
    data: JSON.parse(document.getElementById("page-data").textContent),
    ready, // when all charts of the page are drawn
    draw,
    view: (figure) => charts.get(figure)?.view,
    savable,
    forget,
    sortable,
  };
})();
