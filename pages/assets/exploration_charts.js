"use strict";

// The charts of an exploration: from its designs to Vega-Lite. No document is needed here, so that
// the program draws the static pictures with the same functions.
//
// `designs` has columns, all of one length: word, name, rank (0: none), kind, and values, a column
// for each of `objectives`. The best come first.
const explorationCharts = (() => {
  const kinds = ["listed", "on the front", "known routing", "random sample"];
  const front = 1;
  const known = 2;
  const sample = 3;
  const layers = [3, 0, 1, 2]; // kinds, drawn one above the other
  const letters = "ABCD";

  const number = (value) =>
    Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(4)));
  // Aligned in a column.
  const cell = (objective, value) => (objective.unit === "1" ? value.toFixed(4) : number(value));
  const arrow = (objective) => (objective.better === "higher" ? "↑" : "↓");
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

  function tip(data, row, count) {
    const { designs, objectives } = data;
    const lines = [label(designs, row)];
    lines.push(designs.rank[row] > 0 ? `rank ${designs.rank[row]}` : kinds[designs.kind[row]]);
    objectives.forEach((objective, column) =>
      lines.push(`${objective.title} ${number(designs.values[column][row])}`),
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

  const kindScale = (values) => ({ domain: kinds, ...(values && { range: values }) });
  const legend = (present, more) => ({
    title: null,
    orient: "top",
    columns: 4,
    values: kinds.filter((kind) => present.has(kind)),
    ...more,
  });
  // Neither is a reader's business: it only keeps the many from covering the few.
  const plain = (field) => ({ field, type: "quantitative", scale: null });
  const sizes = [30, 80, 110, 22];
  const opacities = [0.55, 1, 1, 0.35];

  function paretoLayers(points, labels, line) {
    const present = new Set(points.map(({ kind }) => kind));
    return [
      {
        data: { name: "edge", values: line },
        mark: { type: "line", interpolate: "step-after", strokeDash: [5, 3], strokeWidth: 1.5 },
        encoding: { order: { field: "order", type: "quantitative" }, color: { value: { expr: "scale('color', 'on the front')" } } },
      },
      {
        data: { name: "points", values: points },
        mark: { type: "point", filled: true, cursor: "pointer" },
        encoding: {
          color: { field: "kind", scale: kindScale(), legend: legend(present) },
          shape: { field: "kind", scale: kindScale(), legend: legend(present) },
          size: plain("size"),
          opacity: plain("opacity"),
          tooltip: { field: "tip" },
        },
      },
      {
        data: { name: "labels", values: labels },
        mark: {
          type: "text",
          align: { expr: "datum.right ? 'right' : 'left'" },
          dx: { expr: "datum.right ? -9 : 9" },
          dy: -8,
          fontWeight: "bold",
        },
        encoding: { text: { field: "text" } },
      },
      {
        data: { name: "chosen", values: [] },
        mark: { type: "point", filled: false, size: 320, strokeWidth: 2.5, shape: "circle", style: "chosen" },
      },
      {
        data: { name: "chosen" },
        mark: {
          type: "text",
          align: "right",
          dx: -12,
          dy: { expr: `9 + 16 * indexof('${letters}', slice(datum.letter, 0, 1))` },
          fontSize: 15,
          fontWeight: "bold",
        },
        encoding: { text: { field: "letter" } },
      },
    ];
  }

  // data: {objectives, ranking, designs}; axes: indices of two objectives; rows: which designs.
  // Gives the specification, and how many of how many designs it draws.
  function pareto({ data, axes, rows, grid }) {
    const { designs, objectives, ranking } = data;
    const columns = axes.map((axis) => designs.values[axis]);
    const all = rows ?? designs.word.map((_, row) => row);
    const drawn = thinned(designs, all, columns, grid ?? { columns: 110, lines: 75 });
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
    const axis = (which) => ({
      field: which === 0 ? "x" : "y",
      type: "quantitative",
      title: axisTitle(chosen[which]),
      scale: { zero: false, nice: false, padding: 16 },
    });
    return {
      drawn: points.length,
      of: all.length,
      spec: {
        width: "container",
        height: 430,
        encoding: { x: axis(0), y: axis(1) },
        layer: paretoLayers(points, knownLabels(designs, points, ranges), line),
      },
    };
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
  function parallel({ data, rows, most, narrow }) {
    const { designs, objectives } = data;
    const all = rows ?? designs.word.map((_, row) => row);
    const { picked, of } = someOf(designs, all, most ?? 500);
    const ranges = designs.values.map((column) => range(column, all));
    const above = (row) => layers.indexOf(designs.kind[row]);
    const sorted = [...picked].sort((a, b) => above(a) - above(b) || b - a);
    const axis = (column) => `${objectives[column].title} ${arrow(objectives[column])}`;
    const height = (column, row) => {
      const at = place(designs.values[column][row], ranges[column]);
      return objectives[column].better === "higher" ? at : 1 - at;
    };
    const points = (row, more) =>
      objectives.map((_, column) => ({ row, axis: axis(column), at: height(column, row), ...more }));
    const ends = objectives.map((objective, column) => {
      const [low, high] = all.length > 0 ? ranges[column].map(number) : ["", ""];
      const up = objective.better === "higher";
      return { axis: axis(column), top: up ? high : low, bottom: up ? low : high };
    });
    return {
      drawn: picked.length,
      of,
      points,
      spec: parallelSpec(
        sorted.flatMap((row) =>
          points(row, {
            kind: kinds[designs.kind[row]],
            width: [0.8, 2.2, 2, 0.7][designs.kind[row]],
            opacity: [0.4, 1, 1, 0.35][designs.kind[row]],
            tip: label(designs, row),
          }),
        ),
        ends,
        objectives.map((_, column) => axis(column)),
        narrow,
      ),
    };
  }

  function parallelSpec(lines, ends, axes, narrow) {
    const upright = { type: "text", fontSize: 10.5 };
    const turned = { ...upright, angle: -90 };
    const end = (field, height, dy) => ({
      data: { name: field, values: ends.map((each) => ({ ...each, at: height })) },
      mark: narrow
        ? { ...turned, dx: -dy / 2, align: height === 1 ? "left" : "right" }
        : { ...upright, dy },
      encoding: { text: { field } },
    });
    const key = legend(new Set(lines.map(({ kind }) => kind)), { offset: narrow ? 50 : 24, columns: narrow ? 2 : 4 });
    const at = { field: "at", type: "quantitative", axis: null, scale: { domain: [0, 1] } };
    return {
      width: "container",
      height: 330,
      padding: { top: 22, left: 6, right: 6, bottom: 6 },
      encoding: {
        x: {
          field: "axis",
          type: "nominal",
          sort: null,
          scale: { type: "point", domain: axes, padding: 0.4 },
          axis: { title: null, labelAngle: narrow ? -90 : -40, grid: true, labelPadding: narrow ? 48 : 20, labelLimit: 140 },
        },
        y: at,
      },
      layer: [
        {
          data: { name: "lines", values: lines },
          mark: { type: "line", strokeJoin: "round", cursor: "pointer" },
          encoding: {
            detail: { field: "row" },
            color: { field: "kind", scale: kindScale(), legend: key },
            strokeDash: { field: "kind", scale: kindScale([[1, 0], [1, 0], [6, 3], [2, 3]]), legend: key },
            strokeWidth: plain("width"),
            opacity: plain("opacity"),
            tooltip: { field: "tip" },
          },
        },
        {
          data: { name: "chosen", values: [] },
          mark: {
            type: "line",
            clip: true, // a filter may leave designs behind that are selected
            strokeWidth: 3.5,
            strokeJoin: "round",
            style: "chosen",
            strokeDash: { expr: "({A: [1, 0], B: [9, 4], C: [2, 3], D: [10, 3, 2, 3]})[datum.of]" },
          },
          encoding: { detail: { field: "row" } },
        },
        {
          data: { name: "chosen" },
          mark: {
            type: "text",
            fontWeight: "bold",
            fontSize: 14,
            align: "right",
            dx: { expr: `-8 - 12 * indexof('${letters}', datum.letter)` },
          },
          encoding: { text: { field: "letter" } },
        },
        end("top", 1, -12),
        end("bottom", 0, 12),
      ],
    };
  }

  // tensions: [{held, strand, tension}]
  const tensions = ({ tensions: values, columns, most }) => ({
    data: { values },
    facet: {
      field: "held",
      type: "nominal",
      sort: [...new Set(values.map(({ held }) => held))],
      header: { title: null, labelLimit: 150 },
    },
    columns,
    spacing: 12,
    spec: {
      width: 112,
      height: 84,
      mark: { type: "bar" },
      encoding: {
        x: { field: "strand", type: "nominal", sort: null, axis: { title: null, labelAngle: 0, labelOverlap: true } },
        y: {
          field: "tension",
          type: "quantitative",
          scale: { domain: [0, most] },
          axis: { title: "N per N", tickCount: 3 },
        },
        tooltip: [{ field: "strand" }, { field: "tension" }],
      },
    },
  });

  // ranks: [{design, low, median, high}]
  const ranks = ({ ranks: values }) => ({
    width: "container",
    height: 34 * values.length,
    data: { values },
    encoding: {
      y: { field: "design", type: "nominal", sort: null, axis: { title: null, labelLimit: 190 } },
      x: { type: "quantitative", scale: { zero: false, padding: 12 }, axis: { title: "rank (1 is best)", tickMinStep: 1 } },
    },
    layer: [
      {
        mark: { type: "rule", strokeWidth: 5, opacity: 0.5 },
        encoding: { x: { field: "low", type: "quantitative" }, x2: { field: "high" } },
      },
      { mark: { type: "point", filled: true, size: 110 }, encoding: { x: { field: "median" } } },
    ],
  });

  return { kinds, letters, number, cell, label, axisTitle, frontLine, thinned, pareto, parallel, tensions, ranks };
})();
