"use strict";

// The page of an exploration: its plots, linked with the table, the filter and the selection.
(async () => {
  const state = explorationState;
  const { element } = explorationTable;
  const pareto = document.getElementById("pareto");
  const parallel = document.getElementById("parallel");

  let lines = null; // values that the parallel coordinates show
  let height = 0; // height of the plot, px
  let view = "near"; // the front, "all", or a window

  function markSelection() {
    const { values } = state.designs();
    const [x, y] = state.axes();
    const selected = state.selected();
    markPlot(selected.filter((row) => plot.hasPlace(row)).map((row) =>
      ({ x: values[x][row], y: values[y][row], text: state.letter(row) })));
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
    if (document.activeElement === view.container()) markPointed();
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

  // If no design passes the filter, the plot says so.
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
    const labels = plot.labelsBeside(spots);
    const seen = spots.filter(({ x, y }) => explorationWindow.holds(plot.reach, [x, y]));
    view.data("chosen", seen).data("labels", labels).runAsync();
  }

  // Returns the designs that the trade-off marks.
  const advised = () =>
    reeve.data.tradeoff.advised
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

  function pointedText(row) {
    const { rank, kind, values } = state.designs();
    const texts = state.axes().map((column) =>
      `${state.objectives[column].title} ${explorationCharts.number(values[column][row])}`);
    const standing = rank[row] > 0 ? `rank ${rank[row]}` : explorationCharts.kinds[kind[row]];
    return [state.label(row), standing, ...texts].join("; ");
  }

  const placeOf = (row) => state.axes().map((column) => state.designs().values[column][row]);

  // The design that the keyboard points at.
  function markPointed() {
    const row = state.pointed();
    const [x, y] = row === null ? [] : placeOf(row);
    document.getElementById("pointed").textContent = row === null ? "" : pointedText(row);
    liveCharts.view(pareto)?.data("pointed", row === null ? [] : [{ row, x, y }]).runAsync();
  }

  // The plot, for who moves in it.
  const moves = {
    window: () => plot.reach,
    pointed: state.pointed,
    toggle: state.toggle,
    point(row) {
      state.point(row);
      markPointed();
    },
    // To the next design in the order of the ranking, or back; the view follows.
    step(by) {
      const rows = state.rows().filter((row) => plot.hasPlace(row));
      if (rows.length === 0) return;
      const next = rows.indexOf(state.pointed()) + by;
      const row = rows[Math.min(Math.max(next, 0), rows.length - 1)];
      moves.point(row);
      const place = placeOf(row);
      if (!explorationWindow.holds(plot.reach, place)) moves.show(explorationWindow.showing(plot.reach, place));
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

  function designButton(row, textContent) {
    const button = element("button", { type: "button", className: "plain", textContent });
    button.setAttribute("aria-label", `Select ${state.label(row)}`);
    button.addEventListener("click", () => state.toggle(row));
    return button;
  }

  // Lines of the trade-off are designs, too.
  function tradeoffRows() {
    for (const line of document.querySelectorAll("#tradeoff-table tbody tr")) {
      const cell = [...line.cells].findLast(({ textContent }) => state.rowOf(textContent.trim()) !== undefined);
      if (!cell) continue;
      const row = state.rowOf(cell.textContent.trim());
      cell.replaceChildren(designButton(row, cell.textContent.trim()));
      line.classList.toggle("advised", advised().some((design) => design.row === row));
      line.addEventListener("pointerenter", () => state.point(row));
      line.addEventListener("focusin", () => state.point(row));
    }
    const table = document.getElementById("tradeoff-table");
    table?.addEventListener("pointerleave", () => state.point(null));
    table?.addEventListener("focusout", () => state.point(null));
  }

  // Words of designs in a text become buttons that select them.
  function linkDesigns(place) {
    const rowOf = (word) => (state.designs().word[state.rowOf(word)] === word ? state.rowOf(word) : undefined);
    const part = (text) => (rowOf(text) === undefined ? text : designButton(rowOf(text), text));
    const walker = document.createTreeWalker(place, NodeFilter.SHOW_TEXT);
    const texts = [];
    while (walker.nextNode()) texts.push(walker.currentNode);
    for (const text of texts) text.replaceWith(...text.data.split(/([\w+-]+)/).map(part));
  }

  await state.load();
  if (state.designs().word.length === 0) {
    reeve.fold();
    document.documentElement.dataset.ready = "true";
    return;
  }
  for (const controls of document.querySelectorAll(".controls[hidden]")) controls.hidden = false;
  axisChoices();
  explorationTable.start();
  explorationFinder.start();
  explorationBrushes.start();
  tradeoffRows();
  for (const place of document.querySelectorAll("#answer p, #won, #changes, #bests tbody")) linkDesigns(place);
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
