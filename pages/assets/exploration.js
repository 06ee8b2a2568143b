"use strict";

// The page of an exploration: its plots, linked with the table, the filter and the selection.
(async () => {
  const state = explorationState;
  const { element } = explorationTable;
  const pareto = document.getElementById("pareto");
  const parallel = document.getElementById("parallel");

  let lines = null; // what the parallel coordinates show
  let height = 0; // of the plot, px
  let view = "near"; // the front, "all", or a window

  function markSelection() {
    const { values } = state.designs();
    const [x, y] = state.axes();
    const selected = state.selected();
    const spots = new Map();
    for (const row of selected) {
      if (values[x][row] === null || values[y][row] === null) continue;
      const spot = { x: values[x][row], y: values[y][row], letter: "" };
      const here = spots.get(`${spot.x} ${spot.y}`) ?? spot;
      here.letter += (here.letter ? ", " : "") + state.letter(row);
      spots.set(`${spot.x} ${spot.y}`, here);
    }
    markPlot([...spots.values()]);
    const through = selected.flatMap((row) =>
      lines.points(row, {}).map((point, i) => ({ ...point, of: state.letter(row), letter: i === 0 ? state.letter(row) : "" })));
    liveCharts.view(parallel)?.data("chosen", through).runAsync();
  }

  function rowUnder(item) {
    const datum = Array.isArray(item?.datum) ? item.datum[0] : item?.datum;
    const row = datum?.row ?? item?.mark?.group?.datum?.row;
    return Number.isInteger(row) ? row : null;
  }

  // Views come and go with the axes, the filter and the colours.
  function onView(view) {
    view.addEventListener("click", (_, item) =>
      rowUnder(item) !== null && !explorationMoves.wasDragged() && state.toggle(rowUnder(item)));
    view.addEventListener("mouseover", (_, item) => rowUnder(item) !== null && state.point(rowUnder(item)));
    view.container().onpointerleave = () => state.point(null);
    markSelection();
  }

  function onPlotView(view) {
    onView(view);
    explorationMoves.listen(view, moves);
  }

  function onParallelView(view) {
    onView(view);
    explorationBrushes.listen(view, lines.extents);
  }

  // So high that the plot ends with the first screen, but not so low that it cannot be read.
  function plotHeight() {
    const around = 105; // legend, numbers and title of the axis
    const top = pareto.getBoundingClientRect().top + scrollY;
    return Math.min(430, Math.max(220, Math.floor(innerHeight - top - around)));
  }

  // Where the filter leaves nothing, the plot says so.
  function sayIfNothing(figure) {
    figure.querySelector(".nothing")?.remove();
    if (state.rows().length > 0) return;
    figure.prepend(explorationTable.nothing());
  }

  // Letters beside the selected, and whatever else is named where these leave room.
  let plot = null;
  function markPlot(spots) {
    const view = liveCharts.view(pareto);
    if (!view) return;
    const labels = plot.labelsBeside(spots.map(({ x, y, letter }) => ({ x, y, text: letter })));
    const seen = spots.filter(({ x, y }) => explorationWindow.holds(plot.reach, [x, y]));
    view.data("chosen", seen).data("labels", labels).runAsync();
  }

  // What the ladder marks.
  const advised = () =>
    reeve.data.ladder.advised
      .map(({ word, label }) => ({ row: state.rowOf(word), label }))
      .filter(({ row }) => row !== undefined);

  async function drawPlots() {
    const data = state.data();
    const rows = state.rows();
    height ||= plotHeight();
    const size = { width: pareto.clientWidth - 70, height }; // without the numbers of the axis
    plot = explorationCharts.pareto({ data, axes: state.axes(), rows, advised: advised(), size, view });
    showView();
    const width = parallel.clientWidth || 700;
    lines = explorationParallel.parallel({ data, rows, base: state.base(), ranges: state.ranges(), width });
    [pareto, parallel].forEach(sayIfNothing);
    document.getElementById("pareto-count").textContent =
      `${plot.drawn} of ${plot.of} designs drawn: of those that lie on one spot, the first` +
      (plot.inside < plot.of ? `; ${plot.of - plot.inside} lie outside this view.` : ".") +
      (plot.cut ? " Bars that reach far beyond the points end where the plot does." : "");
    document.getElementById("parallel-count").textContent =
      `Lines: ${lines.drawn} of ${lines.of} designs, the best ${explorationParallel.mostLines} by rank and the ` +
      "known routings. Grey bars: where all of them lie, the wider the more.";
    await liveCharts.draw(pareto, plot.spec, onPlotView);
    await liveCharts.draw(parallel, lines.spec, onParallelView);
  }

  const pressed = (id, is) => document.getElementById(id).setAttribute("aria-pressed", String(is));
  function showView() {
    document.getElementById("view-near").disabled = plot.near === null;
    pressed("view-near", plot.near !== null && view === "near");
    pressed("view-all", view === "all" || (view === "near" && plot.near === null));
  }

  function pointedText({ row, tip }) {
    const values = state.axes().map((column) =>
      `${state.objectives[column].title} ${explorationCharts.number(state.designs().values[column][row])}`);
    return [...tip.split("\n").slice(0, 2), ...values].join("; ");
  }
  const markOf = (row) => plot.spec.datasets.points.find((point) => point.row === row);
  // The plot, for who moves in it.
  const moves = {
    window: () => plot.reach,
    points: () => plot.spec.datasets.points,
    pointed: () => markOf(state.pointed()),
    toggle: ({ row }) => state.toggle(row),
    point(mark) {
      state.point(mark?.row ?? null);
      document.getElementById("pointed").textContent = mark ? pointedText(mark) : "";
      liveCharts.view(pareto)?.data("pointed", mark ? [mark] : []).runAsync();
    },
    choose(which) {
      view = which;
      drawPlots();
    },
    // At once by the axes alone; marks and names follow when the reader stops.
    show(window) {
      plot.reach = view = explorationWindow.within(window, plot.whole);
      showView();
      liveCharts.view(pareto)?.signal("reach", plot.reach.flat()).signal("moving", true).runAsync();
      drawPlotsSoon();
    },
  };

  // Several changes within a moment, such as typing, are one.
  let waiting = null;
  function drawPlotsSoon() {
    clearTimeout(waiting);
    waiting = setTimeout(drawPlots, 150);
  }

  function tray() {
    const { selected, label, letter } = state;
    const chips = selected().map((row) => {
      const chip = element("button", { type: "button", className: "chip",
        textContent: `${letter(row)} ${label(row)} ×`,
        title: `Remove ${label(row)} from the selection` });
      chip.addEventListener("click", () => state.toggle(row));
      return chip;
    });
    document.getElementById("chips").replaceChildren(...chips);
    const gone = state.putAway().map(label);
    document.getElementById("put-away").textContent =
      gone.length > 0 ? `Four fit side by side: ${gone.join(", ")} made room.` : "";
    document.getElementById("tray").hidden = chips.length === 0;
  }

  function axisChoices() {
    ["x-axis", "y-axis"].forEach((id, which) => {
      const select = document.getElementById(id);
      state.objectives.forEach(({ title, better }, column) =>
        select.append(element("option", { value: column, textContent: `${title} (${better} is better)` })));
      select.value = state.axes()[which];
      select.addEventListener("change", () => state.setAxis(which, Number(select.value)));
    });
  }

  // Lines of the ladder are designs, too.
  function ladderRows() {
    for (const line of document.querySelectorAll("#ladder-table tbody tr")) {
      const cell = [...line.cells].findLast(({ textContent }) => state.rowOf(textContent.trim()) !== undefined);
      if (!cell) continue;
      const row = state.rowOf(cell.textContent.trim());
      const button = element("button", { type: "button", className: "plain", textContent: cell.textContent.trim() });
      button.setAttribute("aria-label", `Select ${state.label(row)}`);
      button.addEventListener("click", () => state.toggle(row));
      cell.replaceChildren(button);
      line.classList.toggle("advised", advised().some((design) => design.row === row));
      line.addEventListener("pointerenter", () => state.point(row));
      line.addEventListener("focusin", () => state.point(row));
    }
    const table = document.getElementById("ladder-table");
    table?.addEventListener("pointerleave", () => state.point(null));
    table?.addEventListener("focusout", () => state.point(null));
  }

  await state.load();
  for (const controls of document.querySelectorAll(".controls[hidden]")) controls.hidden = false;
  axisChoices();
  explorationTable.start();
  explorationFinder.start();
  explorationBrushes.start();
  ladderRows();
  explorationMoves.start(moves);
  document.getElementById("clear").addEventListener("click", state.clear);
  state.onChange((what) => {
    if (what === "pointed" || what === "columns") return;
    tray();
    if (what === "axes") view = "near";
    if (what === "selection") markSelection();
    else drawPlotsSoon();
    ["x-axis", "y-axis"].forEach((id, which) => {
      document.getElementById(id).value = state.axes()[which];
    });
  });
  tray();
  await explorationPanel.start();
  document.getElementById("compare").addEventListener("click", () => {
    document.getElementById("comparison").open = true;
  });
  await drawPlots();
  liveCharts.savable(pareto);
  liveCharts.savable(parallel);
  await explorationCards.start();
  reeve.fold();
  document.documentElement.dataset.ready = "true";
})();
