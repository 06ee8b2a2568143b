"use strict";

// The window of the plot: which part of two axes it shows, as [[low, high], [low, high]]. Near the
// front designs lie so close that among all of them they are one spot.
const explorationWindow = (() => {
  const tenth = 0.1; // of the spread of all values
  const fewest = 5; // places; fewer need no window of their own

  const holds = (window, point) => window.every(([low, high], axis) => point[axis] >= low && point[axis] <= high);

  const extents = (points) =>
    [0, 1].map((axis) => points.map((point) => point[axis]))
      .map((values) => values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]));

  // About the front: what lies in the best tenth of both spreads, or no farther than the front
  // reaches; null if that are only a few places. `chosen`: two objectives; edge and places: points.
  function near(chosen, ranges, edge, places) {
    const reached = extents(edge);
    const best = chosen.map(({ better }, axis) => {
      const [low, high] = ranges[axis];
      const part = tenth * (high - low);
      return better === "higher"
        ? [Math.min(high - part, reached[axis][0]), high]
        : [low, Math.max(low + part, reached[axis][1])];
    });
    const inside = places.filter((point) => holds(best, point));
    return new Set(inside.map((point) => point.join())).size < fewest ? null : extents(inside);
  }

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

  return { near, holds, within, zoomed, moved };
})();
