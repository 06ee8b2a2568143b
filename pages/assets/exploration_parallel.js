"use strict";

// Parallel coordinates: lines of the best and of the known routings, and behind them in grey how
// many of all designs have a value. The still figure shows the same designs by the same rules.
const explorationParallel = (() => {
  const { number, range, place, label, kinds, layers, specification, present } = explorationCharts;
  const mostLines = 30; // number of best designs; more lines cannot be told apart
  const bins = 24;
  const widest = 0.72; // share of the way from axis to axis
  const known = 2;

  const up = ({ better }) => better === "higher";
  const axis = (objective) => objective.title + (up(objective) ? "" : " (inverted)");

  // From 0, the worst, to 1, the best; null where there is no value.
  function height(objective, extent, value) {
    if (value === null) return null;
    const at = place(value, extent);
    return up(objective) ? at : 1 - at;
  }

  // The value at that height.
  const valueAt = (objective, [low, high], at) => low + (up(objective) ? at : 1 - at) * (high - low);

  function picked(designs, rows) {
    let best = 0;
    return rows.filter((row) => {
      const ranked = designs.rank[row] > 0 && best < mostLines;
      if (ranked) best += 1;
      return ranked || designs.kind[row] === known;
    });
  }

  // Bars across an axis; their width is the square root of the share in the fullest, so that a few
  // show beside thousands.
  function density(designs, rows, objectives, extents, step) {
    return objectives.flatMap((objective, column) => {
      const counts = new Array(bins).fill(0);
      for (const row of rows) {
        const at = height(objective, extents[column], designs.values[column][row]);
        if (at !== null && at >= 0 && at <= 1) counts[Math.min(bins - 1, Math.floor(at * bins))] += 1;
      }
      const most = Math.max(...counts);
      return counts.flatMap((count, bin) => count === 0 ? [] : [{
        axis: axis(objective), at: (bin + 0.5) / bins, count,
        span: widest * step * Math.sqrt(count / most), tip: `${count} design${count === 1 ? "" : "s"}` }]);
    });
  }

  // So many pixels the longest of the numbers takes, turned by a quarter.
  const turnedRoom = (ends) => 14 + 6 * Math.max(...ends.map(({ text }) => text.length));

  // data: {objectives, designs}; rows: which designs; base: those that the axes reach over, which
  // they do whatever range is kept on one; ranges: Map of objective to [low, high]; width: of the
  // figure, px. Gives the specification; `points`, of one design; `extents`, of the axes; and how
  // many of how many designs have lines.
  function parallel({ data, rows, base = rows, ranges = new Map(), width = 760 }) {
    const { designs, objectives } = data;
    const all = rows ?? designs.word.map((_, row) => row);
    const extents = designs.values.map((column) => range(column, base ?? all));
    const narrow = width < 60 * objectives.length;
    const points = (row, more) =>
      objectives.map((objective, column) => ({
        row, axis: axis(objective), at: height(objective, extents[column], designs.values[column][row]), ...more }));
    const chosen = picked(designs, all);
    const above = (row) => layers.indexOf(designs.kind[row]);
    const lines = [...chosen]
      .sort((a, b) => above(a) - above(b) || b - a)
      .flatMap((row) =>
        points(row, {
          kind: kinds[designs.kind[row]],
          width: [1.2, 2.2, 2, 1][designs.kind[row]],
          opacity: [0.7, 1, 1, 1][designs.kind[row]],
          tip: label(designs, row),
        }));
    const end = (at) => objectives.map((objective, column) => {
      const [low, high] = extents[column];
      const text = low <= high ? number(up(objective) === (at === 1) ? high : low) : "";
      return { axis: axis(objective), at, text };
    });
    const [bottom, top] = [end(0), end(1)];
    const step = width / (objectives.length - 0.2);
    const spec = specification(
      "parallel",
      { density: density(designs, all, objectives, extents, step), lines, bottom, top,
        brushes: brushes(objectives, extents, ranges) },
      { narrow, room: narrow ? turnedRoom([...bottom, ...top]) : 20, present: present(lines) },
    );
    spec.encoding.x.scale.domain = objectives.map(axis);
    return { drawn: chosen.length, of: all.length, points, extents, spec };
  }

  const clamped = (at) => Math.min(1, Math.max(0, at));

  // Returns the ranges that are kept of each axis, as marks.
  function brushes(objectives, extents, ranges) {
    return [...ranges].map(([column, kept]) => {
      const ends = kept.map((value) => clamped(height(objectives[column], extents[column], value)));
      return { axis: axis(objectives[column]), at: Math.min(...ends), to: Math.max(...ends) };
    });
  }

  return { parallel, brushes, valueAt, axis, mostLines };
})();
