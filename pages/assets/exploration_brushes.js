"use strict";

// Ranges that are brushed on the parallel axes: dragged along an axis, and let go with a click on
// it. Not by touch, which scrolls there; bounds do the same.
const explorationBrushes = (() => {
  const state = explorationState;
  const near = 12; // px from an axis
  const still = 4; // px: what moves less is a click

  // Rounded outward, so that what lies at the end is in; whole numbers where there are no others.
  function rounded(objective, [low, high], extent) {
    if (objective.count) {
      const inside = [Math.ceil(low - 0.25), Math.floor(high + 0.25)];
      return inside[0] <= inside[1] ? inside : [Math.round((low + high) / 2), Math.round((low + high) / 2)];
    }
    const step = 10 ** (Math.floor(Math.log10(extent[1] - extent[0])) - 2);
    return [Math.floor(low / step) * step, Math.ceil(high / step) * step].map((value) => Number(value.toPrecision(8)));
  }

  // Returns a pointer's position in a view: the objective whose axis is near, and the height from 0
  // to 1.
  function placeIn(view, event) {
    const svg = view.container().querySelector("svg");
    const box = svg.getBoundingClientRect();
    const shrunk = svg.width.baseVal.value / box.width;
    const [left, top] = view.origin();
    const x = (event.clientX - box.left) * shrunk - left;
    const y = (event.clientY - box.top) * shrunk - top;
    const across = view.scale("x");
    const column = state.objectives.findIndex((objective) =>
      Math.abs(across(explorationParallel.axis(objective)) - x) <= near);
    return { column, y, at: Math.min(1, Math.max(0, 1 - y / view.height())), inside: y > -near && y < view.height() + near };
  }

  // `extents`: of the axes of what that view shows.
  function listen(view, extents) {
    let drag = null;
    const container = view.container();
    const kept = (at) => {
      const objective = state.objectives[drag.column];
      const extent = extents[drag.column];
      const ends = [drag.at, at].map((each) => explorationParallel.valueAt(objective, extent, each));
      return rounded(objective, [Math.min(...ends), Math.max(...ends)], extent);
    };
    container.onpointerdown = (event) => {
      const { column, y, at, inside } = placeIn(view, event);
      if (event.pointerType === "touch" || event.button !== 0 || column < 0 || !inside) return;
      if (!(extents[column][1] > extents[column][0])) return;
      drag = { column, y, at, moved: false };
      event.preventDefault();
    };
    container.onpointermove = (event) => {
      if (!drag) {
        const { column, inside } = placeIn(view, event);
        container.style.cursor = column >= 0 && inside ? "ns-resize" : "";
        return;
      }
      const { y, at } = placeIn(view, event);
      if (!drag.moved && Math.abs(y - drag.y) < still) return;
      if (!drag.moved) container.setPointerCapture(event.pointerId);
      drag.moved = true;
      const ranges = new Map(state.ranges()).set(drag.column, kept(at));
      view.data("brushes", explorationParallel.brushes(state.objectives, extents, ranges)).runAsync();
    };
    container.onpointerup = (event) => {
      if (!drag) return;
      const { column, moved } = drag;
      const range = moved ? kept(placeIn(view, event).at) : null;
      drag = null;
      if (moved || state.ranges().has(column)) state.setRange(column, range);
    };
    container.onpointercancel = () => (drag = null);
  }

  // The ranges as buttons that let them go.
  function showChips() {
    const { element } = explorationTable;
    const { number } = explorationCharts;
    const chips = [...state.ranges()].map(([column, [low, high]]) => {
      const { title } = state.objectives[column];
      const text = `${title} ${number(low)} to ${number(high)}`;
      const chip = element("button", { type: "button", className: "chip", textContent: `${text} ×` });
      chip.setAttribute("aria-label", `Let go of the range ${text}`);
      chip.addEventListener("click", () => state.setRange(column, null));
      return chip;
    });
    const place = document.getElementById("ranges");
    place.hidden = chips.length === 0;
    place.replaceChildren(...chips);
  }

  function start() {
    state.onChange((what) => {
      if (what === "rows" || what === "all") showChips();
    });
    showChips();
  }

  return { listen, start };
})();
