"use strict";

// Moves of the reader in the plot. By pointer: drag to move, ctrl and wheel to zoom. By keyboard:
// arrows go from mark to mark, Enter selects, + and - zoom, shift and arrows move. By buttons: all
// that a finger on a phone needs, where dragging scrolls the page.
const explorationMoves = (() => {
  const still = 4; // px: what moves less is a click
  const step = 0.2; // of the window
  const closer = 0.6;
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const { zoomed, moved } = explorationWindow;
  let from = null; // where a drag began; it goes on where the plot is drawn anew
  let dragged = false;

  // Where a pointer is, as shares of both axes.
  function shares(view, event) {
    const svg = view.container().querySelector("svg");
    const box = svg.getBoundingClientRect();
    const shrunk = svg.width.baseVal.value / box.width;
    const [left, top] = view.origin();
    return [((event.clientX - box.left) * shrunk - left) / view.width(),
      1 - ((event.clientY - box.top) * shrunk - top) / view.height()];
  }

  // The nearest mark in the direction of an arrow: what lies aside counts double.
  function next(points, from, [right, up], [[x0, x1], [y0, y1]]) {
    if (!from) return points.at(-1);
    const far = (point) => {
      const along = [(point.x - from.x) / (x1 - x0), (point.y - from.y) / (y1 - y0)];
      const ahead = right ? right * along[0] : up * along[1];
      return ahead > 1e-9 ? ahead + 2 * Math.abs(right ? along[1] : along[0]) : Infinity;
    };
    const nearest = points.reduce((best, point) => (far(point) < far(best) ? point : best));
    return far(nearest) < Infinity ? nearest : from;
  }

  function listenToPointer(view, plot) {
    const container = view.container();
    container.onpointerdown = (event) => {
      dragged = false;
      if (event.pointerType === "touch" || event.button !== 0) return;
      const at = shares(view, event);
      if (at.every((share) => share >= 0 && share <= 1)) from = { at, x: event.clientX, y: event.clientY, window: plot.window() };
    };
    container.onpointermove = (event) => {
      if (!from) return;
      if (!dragged && Math.hypot(event.clientX - from.x, event.clientY - from.y) < still) return;
      if (!dragged) container.setPointerCapture(event.pointerId);
      dragged = true;
      plot.show(moved(from.window, shares(view, event).map((share, axis) => from.at[axis] - share)));
    };
    container.onpointerup = container.onpointercancel = () => (from = null);
    container.onwheel = (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      plot.show(zoomed(plot.window(), event.deltaY < 0 ? closer : 1 / closer, shares(view, event)));
    };
  }

  function listenToKeys(view, plot) {
    const container = view.container();
    container.tabIndex = 0;
    container.onkeydown = (event) => {
      const arrow = arrows[event.key];
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.key === "+" || event.key === "-") plot.show(zoomed(plot.window(), event.key === "+" ? closer : 1 / closer));
      else if (arrow && event.shiftKey) plot.show(moved(plot.window(), arrow.map((way) => step * way)));
      else if (arrow) plot.point(next(plot.points(), plot.pointed(), arrow, plot.window()));
      else if (event.key === "Enter" && plot.pointed()) plot.toggle(plot.pointed());
      else return;
      event.preventDefault();
    };
    container.onblur = () => plot.point(null);
  }

  function listen(view, plot) {
    listenToPointer(view, plot);
    listenToKeys(view, plot);
  }

  // Buttons, whichever view there is.
  function start(plot) {
    const on = (id, act) => document.getElementById(id).addEventListener("click", act);
    on("view-near", () => plot.choose("near"));
    on("view-all", () => plot.choose("all"));
    on("zoom-in", () => plot.show(zoomed(plot.window(), closer)));
    on("zoom-out", () => plot.show(zoomed(plot.window(), 1 / closer)));
  }

  return { listen, start, next, wasDragged: () => dragged };
})();
