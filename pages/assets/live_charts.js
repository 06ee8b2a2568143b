"use strict";

// Charts that the page's script draws with Vega, in the colours of the reader's scheme.
const liveCharts = (() => {
  const themes = JSON.parse(document.getElementById("chart-theme").textContent);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const charts = new Map(); // figure -> {spec, view, onView}

  const parsed = (spec, theme) =>
    vega.parse(vegaLite.compile({ ...spec, config: theme, background: "transparent" }).spec);

  // Draws, or draws anew with another specification; the figure keeps its still for print.
  // `onView` is called for each new view, so that it can listen to it.
  async function draw(figure, spec, onView = charts.get(figure)?.onView) {
    charts.get(figure)?.view.finalize();
    const container = figure.querySelector(".live");
    figure.classList.add("is-live"); // first: a hidden container has no width
    const view = new vega.View(parsed(spec, dark.matches ? themes.dark : themes.light), {
      renderer: "svg",
      container,
      hover: true,
    });
    charts.set(figure, { spec, view, onView });
    await view.runAsync();
    onView?.(view);
    return view;
  }

  // As the reader sees it, but on white: saved figures go into papers.
  async function chartSvg(figure) {
    const { spec, view } = charts.get(figure);
    const width = view.width();
    const sized = spec.width === "container" ? { ...spec, width } : spec;
    const copy = new vega.View(parsed(sized, themes.light), { renderer: "none" });
    await copy.runAsync(); // first: a chart that never ran has no parts to take a state
    copy.setState(view.getState());
    copy.background("white"); // last: the background is part of the state
    const svg = await copy.toSVG();
    copy.finalize();
    return svg;
  }

  // Before the figure is taken out of the page.
  function forget(figure) {
    charts.get(figure)?.view.finalize();
    charts.delete(figure);
  }

  dark.addEventListener("change", () => {
    for (const [figure, chart] of charts) draw(figure, chart.spec);
  });

  return {
    draw,
    view: (figure) => charts.get(figure)?.view,
    savable: (figure, name) => reeve.savable(figure, name, () => chartSvg(figure)),
    forget,
  };
})();
