"use strict";

// The page of an exploration: its plots, linked with the table, the filter and the selection.
(async () => {
  const state = explorationState;
  const { element } = explorationTable;
  const pareto = document.getElementById("pareto");
  const parallel = document.getElementById("parallel");

  function mark(figure, rows) {
    const view = liveCharts.view(figure);
    view?.data("chosen", rows).runAsync();
  }

  function markSelection() {
    const { values } = state.designs();
    const [x, y] = state.axes();
    const selected = state.selected();
    const spots = new Map();
    for (const row of selected) {
      const spot = { x: values[x][row], y: values[y][row], letter: "" };
      const here = spots.get(`${spot.x} ${spot.y}`) ?? spot;
      here.letter += (here.letter ? ", " : "") + state.letter(row);
      spots.set(`${spot.x} ${spot.y}`, here);
    }
    mark(pareto, [...spots.values()]);
    const lines = explorationCharts.parallel({ data: state.data(), rows: state.rows() }).points;
    mark(parallel, selected.flatMap((row) =>
      lines(row, {}).map((point, i) => ({ ...point, of: state.letter(row), letter: i === 0 ? state.letter(row) : "" }))));
  }

  function selectOnClick(view) {
    view.addEventListener("click", (_, item) => {
      const datum = Array.isArray(item?.datum) ? item.datum[0] : item?.datum;
      const row = datum?.row ?? item?.mark?.group?.datum?.row;
      if (Number.isInteger(row)) state.toggle(row);
    });
  }

  // Views come and go with the axes, the filter and the colours.
  function onView(view) {
    selectOnClick(view);
    markSelection();
  }

  async function drawPlots() {
    const data = state.data();
    const rows = state.rows();
    const points = explorationCharts.pareto({ data, axes: state.axes(), rows });
    const narrow = parallel.clientWidth < 700;
    const lines = explorationCharts.parallel({ data, rows, narrow });
    document.getElementById("pareto-count").textContent =
      `${points.drawn} of ${points.of} designs drawn: of those that lie on one spot, the first.`;
    document.getElementById("parallel-count").textContent = `${lines.drawn} of ${lines.of} designs drawn.`;
    await liveCharts.draw(pareto, points.spec, onView);
    await liveCharts.draw(parallel, lines.spec, onView);
  }

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

  await state.load();
  for (const controls of document.querySelectorAll(".controls[hidden]")) controls.hidden = false;
  axisChoices();
  explorationTable.start();
  document.getElementById("clear").addEventListener("click", state.clear);
  state.onChange((what) => {
    tray();
    if (what === "selection") markSelection();
    else drawPlotsSoon();
    ["x-axis", "y-axis"].forEach((id, which) => {
      document.getElementById(id).value = state.axes()[which];
    });
  });
  tray();
  await drawPlots();
  liveCharts.savable(pareto);
  liveCharts.savable(parallel);
  await explorationCards.start();
  document.documentElement.dataset.ready = "true";
})();
