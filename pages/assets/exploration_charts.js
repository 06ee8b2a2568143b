"use strict";

// The charts of an exploration: from its designs to the data of its Vega-Lite specifications
// (pages/charts). No document is needed here. The static pictures are drawn by the program itself,
// from the same designs by the same rules.
//
// `designs` has columns, all of one length: word, name, rank (0: none), kind, and values, a column
// for each of `objectives`. The best come first. `bands`, where there are any, has for each objective
// null or {low, high}: columns of the 5 % and the 95 % quantile, null where there is none.
const explorationCharts = (() => {
  const kinds = ["listed", "on the front", "known routing", "random sample"];
  const front = 1;
  const known = 2;
  const sample = 3;
  const layers = [3, 0, 1, 2]; // kinds, drawn one above the other
  const letters = "ABCD";
  const grid = { columns: 110, lines: 75 }; // cells of the plot, each with one design at most
  const mostLines = 500;
  const mostBands = 16;

  const number = (value) =>
    Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(4)));
  // Aligned in a column.
  const cell = (objective, value) => (objective.unit === "1" ? value.toFixed(4) : number(value));
  const axisTitle = (objective) =>
    `${objective.title}${objective.unit === "1" ? "" : `, ${objective.unit}`}` +
    ` (${objective.better} is better)`;
  const label = (designs, row) =>
    designs.name[row] ? `${designs.name[row]}: ${designs.word[row]}` : designs.word[row];

  function range(column, rows) {
    let low = Infinity;
    let high = -Infinity;
    for (const row of rows) {
      low = Math.min(low, column[row]);
      high = Math.max(high, column[row]);
    }
    return [low, high];
  }

  const place = (value, [low, high]) => (high > low ? (value - low) / (high - low) : 0.5);

  // Of designs that lie in one cell of the picture only the first is drawn; those on the front that
  // differ by more than a dot, and the known routings, always are.
  function thinned(designs, rows, [xs, ys], { columns, lines }) {
    const ranges = [range(xs, rows), range(ys, rows)];
    const cells = new Map();
    for (const row of rows) {
      const kind = designs.kind[row];
      const finer = kind === front ? 5 : 1;
      const across = Math.round(place(xs[row], ranges[0]) * columns * finer);
      const up = Math.round(place(ys[row], ranges[1]) * lines * finer);
      const cell = kind === known ? `known ${row}` : `${kind === front} ${kind === sample} ${across} ${up}`;
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

  // One text for all known routings that lie so near each other that their names would overlap.
  function knownLabels(designs, points, [xRange, yRange]) {
    const groups = [];
    for (const point of points.filter((each) => each.kind === kinds[known])) {
      const near = groups.find(
        (group) =>
          Math.abs(place(point.x, xRange) - place(group.x, xRange)) < 0.05 &&
          Math.abs(place(point.y, yRange) - place(group.y, yRange)) < 0.035,
      );
      const name = designs.name[point.row] || designs.word[point.row];
      if (near) near.names.push(name);
      else groups.push({ x: point.x, y: point.y, names: [name], right: place(point.x, xRange) > 0.8 });
    }
    for (const group of groups) group.text = group.names.sort().join(", ");
    return groups;
  }

  // The specification of that name, of which a part can be changed.
  const specification = (name, datasets, params = {}) => {
    const spec = structuredClone(reeve.data.specifications[name]);
    spec.datasets = { ...spec.datasets, ...datasets };
    for (const param of spec.params ?? []) param.value = params[param.name] ?? param.value;
    return spec;
  };
  // Of the kinds those that some of the marks have, in their order.
  const present = (marks) => {
    const found = new Set(marks.map(({ kind }) => kind));
    return kinds.filter((kind) => found.has(kind));
  };
  const sizes = [30, 80, 110, 22];
  const opacities = [0.55, 1, 1, 0.35];

  // data: {objectives, ranking, designs}; axes: indices of two objectives; rows: which designs.
  // Gives the specification, and how many of how many designs it draws.
  function pareto({ data, axes, rows }) {
    const { designs, objectives, ranking } = data;
    const columns = axes.map((axis) => designs.values[axis]);
    const all = rows ?? designs.word.map((_, row) => row);
    const drawn = thinned(designs, all, columns, grid);
    const points = drawn.map(({ row, count }) => ({
      row,
      x: columns[0][row],
      y: columns[1][row],
      kind: kinds[designs.kind[row]],
      size: sizes[designs.kind[row]],
      opacity: opacities[designs.kind[row]],
      tip: tip(data, row, count),
    }));
    const above = (point) => layers.indexOf(designs.kind[point.row]);
    points.sort((a, b) => above(a) - above(b) || b.row - a.row);
    const onFront = designs.word.map((_, row) => row).filter((row) => designs.front[row] === 1);
    const shown = [...all, ...onFront];
    const ranges = columns.map((column) => range(column, shown));
    const chosen = axes.map((axis) => objectives[axis]);
    const line = axes.every((axis) => ranking.includes(axis))
      ? frontLine(onFront.map((row) => columns.map((column) => column[row])), chosen, ranges)
      : [];
    const spec = specification(
      "pareto",
      { edge: line, bands: bandBars(designs, points, axes), points, labels: knownLabels(designs, points, ranges) },
      {
        least_x: chosen[0].least,
        greatest_x: chosen[0].greatest,
        least_y: chosen[1].least,
        greatest_y: chosen[1].greatest,
        present: present(points),
      },
    );
    spec.encoding.x.title = axisTitle(chosen[0]);
    spec.encoding.y.title = axisTitle(chosen[1]);
    return { drawn: points.length, of: all.length, spec };
  }

  // The first ones, all that are known, and of the rest evenly what fits.
  function someOf(designs, rows, most) {
    const always = rows.filter((row) => designs.kind[row] === known);
    const others = rows.filter((row) => designs.kind[row] !== known);
    const half = Math.max(0, Math.floor((most - always.length) / 2));
    const step = Math.max(1, Math.ceil((others.length - half) / Math.max(1, most - always.length - half)));
    const picked = others.filter((_, i) => i < half || (i - half) % step === 0);
    return { picked: [...picked, ...always], of: rows.length };
  }

  // Up is better on every axis: where less is better, the axis is turned round.
  // narrow: whether the figure is, so that the numbers at the axes must be turned.
  function parallel({ data, rows, narrow }) {
    const { designs, objectives } = data;
    const all = rows ?? designs.word.map((_, row) => row);
    const { picked, of } = someOf(designs, all, mostLines);
    const ranges = designs.values.map((column) => range(column, all));
    const above = (row) => layers.indexOf(designs.kind[row]);
    const sorted = [...picked].sort((a, b) => above(a) - above(b) || b - a);
    const axis = (column) =>
      objectives[column].title + (objectives[column].better === "higher" ? "" : " (turned)");
    const height = (column, row) => {
      const at = place(designs.values[column][row], ranges[column]);
      return objectives[column].better === "higher" ? at : 1 - at;
    };
    const points = (row, more) =>
      objectives.map((_, column) => ({ row, axis: axis(column), at: height(column, row), ...more }));
    const ends = objectives.map((objective, column) => {
      const [low, high] = all.length > 0 ? ranges[column].map(number) : ["", ""];
      return objective.better === "higher" ? [low, high] : [high, low];
    });
    const lines = sorted.flatMap((row) =>
      points(row, {
        kind: kinds[designs.kind[row]],
        width: [0.8, 2.2, 2, 0.7][designs.kind[row]],
        opacity: [0.4, 1, 1, 0.35][designs.kind[row]],
        tip: label(designs, row),
      }),
    );
    const end = (at) => ends.map((texts, column) => ({ axis: axis(column), at, text: texts[at] }));
    const spec = specification(
      "parallel",
      { lines, bottom: end(0), top: end(1) },
      { narrow: narrow ?? false, present: present(lines) },
    );
    spec.encoding.x.scale.domain = objectives.map((_, column) => axis(column));
    return { drawn: picked.length, of, points, spec };
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

  return { kinds, letters, number, bandText, cell, label, axisTitle, frontLine, thinned, pareto, parallel, tensions, ranks };
})();
