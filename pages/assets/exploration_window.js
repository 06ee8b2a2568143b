"use strict";

// The window of the plot: which part of two axes it shows, as [[low, high], [low, high]]. Near the
// front designs lie so close that among all of them they are one spot.
const explorationWindow = (() => {
  const opened = 8; // places; fewer need no window of their own

  const holds = (window, point) => window.every(([low, high], axis) => point[axis] >= low && point[axis] <= high);

  const extents = (points) =>
    [0, 1].map((axis) => points.map((point) => point[axis]))
      .map((values) => values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]));

  // About the front: the edge and the places nearest to it, by shares of what all span; null if
  // there are only a few, or if they are all. Edge and places: points.
  function near(edge, places) {
    const reached = extents(edge);
    const spans = extents(places).map(([low, high]) => high - low || 1);
    const distance = (point) => Math.max(...point.map((value, axis) =>
      Math.max(0, reached[axis][0] - value, value - reached[axis][1]) / spans[axis]));
    const distances = [...new Map(places.map((point) => [point.join(), distance(point)])).values()];
    if (distances.length <= opened) return null;
    const limit = distances.sort((a, b) => a - b)[opened - 1];
    const inside = places.filter((point) => distance(point) <= limit);
    return inside.length === places.length ? null : extents(inside);
  }

  // An arrow to where a point lies beyond a window; "" within it.
  function arrow(window, point) {
    const [across, up] = window.map(([low, high], axis) => (point[axis] < low ? -1 : point[axis] > high ? 1 : 0));
    return ["↙←↖", "↓ ↑", "↘→↗"][across + 1][up + 1].trim();
  }

  // The nearest point of a window.
  const nearest = (window, point) =>
    window.map(([low, high], axis) => Math.min(Math.max(point[axis], low), high));

  // Moved only as far as shows a point, with room about it.
  const showing = (window, point) =>
    window.map(([low, high], axis) => {
      const room = 0.1 * (high - low);
      const by = Math.min(0, point[axis] - room - low) + Math.max(0, point[axis] + room - high);
      return [low + by, high + by];
    });

  // No wider than the whole, and not beyond it.
  function within(window, whole) {
    return window.map(([low, high], axis) => {
      const [first, last] = whole[axis];
      const span = Math.min(high - low, last - first);
      const begin = Math.min(Math.max(low, first), last - span);
      return [begin, begin + span];
    });
  }

  // `at`: what stays where it is, as shares of the axes; a factor below 1 shows less.
  const zoomed = (window, factor, at = [0.5, 0.5]) =>
    window.map(([low, high], axis) => {
      const still = low + at[axis] * (high - low);
      return [still - factor * (still - low), still + factor * (high - still)];
    });

  // By shares of the axes.
  const moved = (window, by) =>
    window.map(([low, high], axis) => [low + by[axis] * (high - low), high + by[axis] * (high - low)]);

  return { near, holds, arrow, nearest, showing, within, zoomed, moved };
})();
