"use strict";

// The charts of an exploration: from its designs to the data of its Vega-Lite specifications
// (pages/charts). No document is needed here. The still figures are drawn by the program itself,
// from the same designs by the same rules.
//
// `designs` has columns, all of one length: word, name, rank (0: none), kind, and values, a column
// for each of `objectives`. The best come first. `bands`, where there are any, has for each objective
// null or {low, high}: columns of the 5 % and the 95 % quantile, null where there is none.
const explorationCharts = (() => {
  const kinds = ["listed", "on the front", "known routing", "random sample", "named, not listed"];
  const front = 1;
  const known = 2;
  const sample = 3;
  const named = 4;
  const layers = [3, 0, 1, 2, 4]; // kinds, drawn one above the other
  const letters = "ABCD";
  const grid = { columns: 110, lines: 75 }; // cells of the plot, each with one design at most
  const mostLines = 500;
  const mostBands = 16;

  // A missing value, such as a motor force if no force is enough, is null.
  const number = (value) => {
    if (value === null) return "-";
    return Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(4)));
  };
  // A share of the draws: some or most do not read as none or all.
  const shareText = (share) => {
    const text = (100 * share).toFixed(1);
    if (share > 0 && text === "0.0") return "under 0.1 %";
    if (share < 1 && text === "100.0") return "over 99.9 %";
    return `${text} %`;
  };
  // Shares are aligned in a column. A cost without a unit is no share.
  const cell = ({ name, unit }, value) =>
    unit === "1" && name !== "cost" && value !== null ? value.toFixed(4) : number(value);
  const axisTitle = (objective) =>
    `${objective.title}${objective.unit === "1" ? "" : `, ${objective.unit}`}` +
    ` (${objective.better} is better)`;
  const label = (designs, row) =>
    designs.name[row] ? `${designs.name[row]}: ${designs.word[row]}` : designs.word[row];

  function range(column, rows) {
    let low = Infinity;
    let high = -Infinity;
    for (const row of rows) {
      if (column[row] === null) continue;
      low = Math.min(low, column[row]);
      high = Math.max(high, column[row]);
    }
    return [low, high];
  }

  const place = (value, [low, high]) => (high > low ? (value - low) / (high - low) : 0.5);

  // Only the first of the designs in one cell of the figure is drawn. Designs on the front that
  // differ by more than a dot, and the known routings, always are.
  function thinned(designs, rows, [xs, ys], { columns, lines }) {
    const ranges = [range(xs, rows), range(ys, rows)];
    const cells = new Map();
    for (const row of rows) {
      if (xs[row] === null || ys[row] === null) continue;
      const kind = designs.kind[row];
      const finer = kind === front ? 5 : 1;
      const across = Math.round(place(xs[row], ranges[0]) * columns * finer);
      const up = Math.round(place(ys[row], ranges[1]) * lines * finer);
      const cell = kind === known || kind === named ? `${row}` : `${kind === front} ${kind === sample} ${across} ${up}`;
      const here = cells.get(cell);
      if (here) here.count += 1;
      else cells.set(cell, { row, count: 1 });
    }
    return [...cells.values()];
  }

  // The edge of what the front attains in two objectives: through the designs that none beats in
  // both, out to the worst values shown. From point to point first across, then up or down,
  // whichever direction is better.
  function frontLine(points, axes, ranges) {
    const up = axes.map((objective) => (objective.better === "higher" ? 1 : -1));
    const sorted = points
      .map((point) => [up[0] * point[0], up[1] * point[1]])
      .sort((a, b) => b[0] - a[0] || b[1] - a[1]);
    const edge = [];
    for (const point of sorted) {
      if (edge.length === 0 || point[1] > edge.at(-1)[1]) edge.push(point);
    }
    if (edge.length === 0) return [];
    const worst = ranges.map(([low, high], axis) => (up[axis] > 0 ? low : -high));
    const line = [[edge[0][0], worst[1]], ...edge, [worst[0], edge.at(-1)[1]]];
    return line.map((point, order) => ({ x: up[0] * point[0], y: up[1] * point[1], order }));
  }

  // " (0.281–0.700 in 90 % of the draws)", or nothing.
  function bandText(designs, column, row) {
    const band = designs.bands?.[column];
    if (!band || band.low[row] === null || band.low[row] === band.high[row]) return "";
    return ` (${number(band.low[row])}–${number(band.high[row])} in 90 % of the draws)`;
  }

  // Bars both ways, of the front and of known routings: of more they would hide each other.
  function bandBars(designs, points, axes) {
    const bars = [];
    const some = points.filter(({ row }) => [front, known].includes(designs.kind[row]))
      .sort((a, b) => a.row - b.row).slice(0, mostBands);
    for (const { row, x, y } of some) {
      const [across, up] = axes.map((axis) => designs.bands?.[axis]);
      const has = (band) => band && band.low[row] !== null;
      if (has(across)) bars.push({ x: across.low[row], x2: across.high[row], y, y2: y });
      if (has(up)) bars.push({ x, x2: x, y: up.low[row], y2: up.high[row] });
    }
    return bars;
  }

  // Bars no longer than half of what the points span beyond these, so that the points stay apart;
  // of one place alone they are whole.
  function cutBars(bars, ranges) {
    const reaches = ranges.map(([low, high]) =>
      high > low ? [low - (high - low) / 2, high + (high - low) / 2] : [-Infinity, Infinity]);
    const within = (value, [low, high]) => Math.min(Math.max(value, low), high);
    return bars.map(({ x, x2, y, y2 }) => ({
      x: within(x, reaches[0]), x2: within(x2, reaches[0]),
      y: within(y, reaches[1]), y2: within(y2, reaches[1]) }));
  }

  // A range of the axis (0: x, 1: y) that holds the bars, too.
  const withBars = ([low, high], bars, axis) => [
    Math.min(low, ...bars.map((bar) => (axis === 0 ? bar.x : bar.y))),
    Math.max(high, ...bars.map((bar) => (axis === 0 ? bar.x2 : bar.y2))),
  ];

  function tip(data, row, count) {
    const { designs, objectives } = data;
    const lines = [label(designs, row)];
    lines.push(designs.rank[row] > 0 ? `rank ${designs.rank[row]}` : kinds[designs.kind[row]]);
    objectives.forEach((objective, column) =>
      lines.push(`${objective.title} ${number(designs.values[column][row])}${bandText(designs, column, row)}`),
    );
    if (count > 1) lines.push(`and ${count - 1} more in this spot`);
    return lines.join("\n");
  }

  // One text for all that lies so near that the marks are one to the eye: the names of known
  // routings, and what is advised.
  function namedSpots(data, points, [xRange, yRange], advised) {
    const { designs } = data;
    const groups = [];
    const groupAt = (x, y) => {
      const near = groups.find(
        (group) =>
          Math.abs(place(x, xRange) - place(group.x, xRange)) < 0.006 &&
          Math.abs(place(y, yRange) - place(group.y, yRange)) < 0.01,
      );
      if (near) return near;
      groups.push({ x, y, names: [], notes: [] });
      return groups.at(-1);
    };
    for (const { x, y, row, label: note } of advised) {
      const name = designs.name[row];
      groupAt(x, y).notes.push(name ? `${name}: ${note}` : note);
    }
    const told = new Set(advised.filter(({ row }) => designs.name[row]).map(({ row }) => row));
    for (const { x, y, row } of points.filter((each) => each.kind === kinds[known] && !told.has(each.row))) {
      groupAt(x, y).names.push(designs.name[row] || designs.word[row]);
    }
    return groups.map(({ x, y, names, notes }) => ({
      x, y, text: [names.sort().join(", "), ...notes].filter(Boolean).join("; ") }));
  }

  // Returns the range of an axis: a little beyond the marks, and never beyond the possible values.
  function domain([low, high], { least, greatest, count }) {
    if (!(low <= high)) return [least ?? 0, greatest ?? (least ?? 0) + 1];
    const beyond = high > low ? 0.04 * (high - low) : count ? 1 : Math.max(0.05 * Math.abs(high), 0.01);
    return [Math.max(low - beyond, least ?? -Infinity), Math.min(high + beyond, greatest ?? Infinity)];
  }

  function axis(channel, objective) {
    channel.title = axisTitle(objective);
    channel.axis = objective.count ? { tickMinStep: 1, format: "d" } : {};
  }

  // The specification of that name, of which a part can be changed.
  const specification = (name, datasets, params = {}) => {
    const spec = structuredClone(reeve.data.specifications[name]);
    spec.datasets = { ...spec.datasets, ...datasets };
    for (const param of spec.params ?? []) param.value = params[param.name] ?? param.value;
    return spec;
  };
  // Returns the kinds that some of the marks have, in the order of all kinds.
  const present = (marks) => {
    const found = new Set(marks.map(({ kind }) => kind));
    return kinds.filter((kind) => found.has(kind));
  };
  const sizes = [30, 80, 110, 22, 90];
  const opacities = [0.55, 1, 1, 0.35, 1];

  // The designs of a plot, as its marks.
  function marks(data, rows, columns) {
    const { designs } = data;
    const above = (point) => layers.indexOf(designs.kind[point.row]);
    return thinned(designs, rows, columns, grid)
      .map(({ row, count }) => ({
        row,
        x: columns[0][row],
        y: columns[1][row],
        kind: kinds[designs.kind[row]],
        size: sizes[designs.kind[row]],
        opacity: opacities[designs.kind[row]],
        tip: tip(data, row, count),
      }))
      .sort((a, b) => above(a) - above(b) || b.row - a.row);
  }

  // Returns the ranges of the axes: `whole` holds all; `near` is about the designs that none beats
  // in both objectives, or null if hardly anything lies there.
  function windows(chosen, ranges, bars, places) {
    const whole = chosen.map((objective, i) => domain(withBars(ranges[i], bars, i), objective));
    const edge = frontLine(places, chosen, ranges).slice(1, -1).map(({ x, y }) => [x, y]);
    const near = explorationWindow.near(edge, places);
    return { whole, near: near && chosen.map((objective, i) => domain(near[i], objective)) };
  }

  // Places the labels of a plot: more texts, [{x, y, text}], go before the others. One that lies
  // outside the view stands at its edge, with an arrow.
  function labeller(texts, points, reach, { width, height }) {
    const pixels = ({ x, y }) => ({ x: place(x, reach[0]) * width, y: (1 - place(y, reach[1])) * height });
    const values = ([x, y]) => [[x / width, reach[0]], [1 - y / height, reach[1]]].map(([share, [low, high]]) => low + share * (high - low));
    const seen = ({ x, y, text }) => {
      const [across, up] = explorationWindow.nearest(reach, [x, y]);
      const arrow = explorationWindow.arrow(reach, [x, y]);
      return { x: across, y: up, text, beyond: arrow };
    };
    const marks = points.map(pixels);
    return (more) => {
      const spots = [...more, ...texts].map(seen).map((spot) => ({ ...spot, at: spot, ...pixels(spot) }));
      return explorationLabels.place(spots, { width, height }, marks).map(({ at, text, dx, dy, align, leader }) => {
        const [[fromX, fromY], [toX, toY]] = [leader.from, leader.to].map(values);
        return { x: at.x, y: at.y, text, dx, dy, align, fromX, fromY, toX, toY };
      });
    };
  }

  // data: {objectives, ranking, designs}; axes: indices of two objectives; rows: which designs;
  // advised: [{row, label}]; size: of the frame, in pixels; view: "near" the front, "all", or a
  // window. Gives the specification, its window and the windows there are, and how many of how many
  // designs it draws.
  function pareto({ data, axes, rows, advised = [], size = { width: 600, height: 430 }, view = "all" }) {
    const { designs, objectives, ranking } = data;
    const columns = axes.map((axis) => designs.values[axis]);
    const all = rows ?? designs.word.map((_, row) => row);
    const placeOf = (row) => columns.map((column) => column[row]);
    const hasPlace = (row) => !placeOf(row).includes(null);
    const onFront = designs.word.map((_, row) => row).filter((row) => designs.front[row] === 1 && hasPlace(row));
    const ranges = columns.map((column) => range(column, [...all, ...onFront]));
    const chosen = axes.map((axis) => objectives[axis]);
    const line = axes.every((axis) => ranking.includes(axis)) ? frontLine(onFront.map(placeOf), chosen, ranges) : [];
    const longBars = bandBars(designs, marks(data, all, columns), axes);
    const bars = cutBars(longBars, ranges);
    const cut = bars.some((bar, i) => Object.keys(bar).some((key) => bar[key] !== longBars[i][key]));
    const { whole, near } = windows(chosen, ranges, bars, all.filter(hasPlace).map(placeOf));
    const reach = Array.isArray(view) ? explorationWindow.within(view, whole) : (view === "near" && near) || whole;
    const inside = all.filter((row) => hasPlace(row) && explorationWindow.holds(reach, placeOf(row)));
    const points = marks(data, inside, columns);
    const among = new Set(inside);
    const rings = advised
      .filter(({ row }) => among.has(row))
      .map(({ row, label: note }) => ({ row, label: note, x: columns[0][row], y: columns[1][row], tip: tip(data, row, 1) }));
    const outside = advised.filter(({ row }) => all.includes(row) && hasPlace(row) && !among.has(row)).map(({ row, label: text }) =>
      ({ x: columns[0][row], y: columns[1][row], text }));
    const texts = [...namedSpots(data, points, reach, rings), ...outside];
    const labelsBeside = labeller(texts, points, reach, size);
    const spec = specification(
      "pareto",
      { edge: line, bands: bars, points, labels: labelsBeside([]), advised: rings },
      { present: present(points), reach: reach.flat() },
    );
    axis(spec.encoding.x, chosen[0]);
    axis(spec.encoding.y, chosen[1]);
    spec.height = size.height;
    return { drawn: points.length, inside: inside.length, of: all.length, cut, hasPlace, labelsBeside, reach, whole, near, spec };
  }

  // tensions: [{held, strand, tension}]
  function tensions({ tensions: values, columns, most }) {
    const spec = specification("tensions", { tensions: values });
    spec.facet.sort = [...new Set(values.map(({ held }) => held))];
    spec.columns = columns;
    spec.spec.encoding.y.scale.domain = [0, most];
    return spec;
  }

  // ranks: [{design, low, median, high}]
  const ranks = ({ ranks: values }) => ({
    ...specification("ranks", { ranks: values }),
    height: 34 * values.length,
  });

  return {
    kinds, layers, letters, number, shareText, bandText, cell, label, axisTitle, range, place, specification, present,
    frontLine, thinned, pareto, tensions, ranks,
  };
})();
