"use strict";

// Moves of the reader in the plot. By pointer: drag to move, ctrl and wheel to zoom. By keyboard:
// arrows go from design to design, Enter selects, + and - zoom, shift and arrows move. By buttons: all
// that a finger on a phone needs, where dragging scrolls the page.
const explorationMoves = (() => {
  const still = 4; // px: what moves less is a click
  const step = 0.2; // share of the window
  const closer = 0.6;
  const steps = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1, Home: -Infinity, End: Infinity };
  const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const { zoomed, moved } = explorationWindow;
  let from = null; // start of a drag, which goes on if the plot is drawn anew
  let dragged = false;

  // Returns a pointer's position, as shares of both axes.
  function shares(view, event) {
    const svg = view.container().querySelector("svg");
    const box = svg.getBoundingClientRect();
    const shrunk = svg.width.baseVal.value / box.width;
    const [left, top] = view.origin();
    return [((event.clientX - box.left) * shrunk - left) / view.width(),
      1 - ((event.clientY - box.top) * shrunk - top) / view.height()];
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
      else if (event.key in steps) plot.step(steps[event.key]);
      else if (event.key === "Enter" && plot.pointed() !== null) plot.toggle(plot.pointed());
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

  return { listen, start, wasDragged: () => dragged };
})();
