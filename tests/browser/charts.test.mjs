// What the script of an exploration makes of designs before Vega draws it (exploration_charts.js
// needs no page, so none is opened). The program draws the still figures by the same rules, which
// tests/pages/exploration_figures_test.cpp holds to the same cases.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import vm from "node:vm";
import { sources } from "./places.mjs";

const pages = join(sources, "pages");
const names = ["pareto", "parallel", "tensions", "ranks"];
const read = (name) => JSON.parse(readFileSync(join(pages, "charts", `${name}.json`), "utf8"));
const specifications = Object.fromEntries(names.map((name) => [name, read(name)]));
const script = ["labels", "window", "charts", "parallel"]
  .map((part) => readFileSync(join(pages, `assets/exploration_${part}.js`), "utf8"))
  .join("\n");
const { charts, lines: parallels, labels } = vm.runInNewContext(
  `${script}; ({ charts: explorationCharts, lines: explorationParallel, labels: explorationLabels })`,
  { reeve: { data: { specifications } }, structuredClone },
);
// Out of the script's world, whose arrays are none of ours.
const plain = (value) => JSON.parse(JSON.stringify(value));

const objectives = ["higher", "higher", "lower"].map((better, i) => ({
  title: `objective ${i}`,
  unit: "1",
  better,
  least: i === 2 ? null : 0,
  greatest: i === 2 ? null : 1,
  count: false,
}));

// `count` designs, each hundredth on the front, no two values alike.
function many(count) {
  const rows = Array.from({ length: count }, (_, i) => i);
  return {
    objectives,
    ranking: [0, 1],
    designs: {
      word: rows.map((i) => `M-${i}-F`),
      name: rows.map(() => ""),
      rank: rows.map((i) => i + 1),
      front: rows.map((i) => (i < count / 100 ? 1 : 2)),
      kind: rows.map((i) => (i < count / 100 ? 1 : 0)),
      values: objectives.map((_, k) => rows.map((i) => ((i * (7919 + 2 * k)) % count) / count)),
    },
  };
}

test("the edge of the front goes through what none beats, whichever way is better", () => {
  const points = [[1, 3], [2, 2], [3, 1], [1.5, 1.5], [2.5, 2.5]];
  const edge = (x, y) =>
    plain(charts.frontLine(points, [{ better: x }, { better: y }], [[0, 4], [0, 5]])).map(
      ({ x: across, y: up }) => [across, up],
    );
  assert.deepEqual(edge("higher", "higher"), [[3, 0], [3, 1], [2.5, 2.5], [1, 3], [0, 3]]);
  assert.deepEqual(edge("lower", "lower"), [[1, 5], [1, 3], [1.5, 1.5], [3, 1], [4, 1]]);
  assert.deepEqual(edge("higher", "lower"), [[3, 5], [3, 1], [0, 1]]);
  assert.deepEqual(edge("lower", "higher"), [[1, 0], [1, 3], [4, 3]]);
});

test("of many designs a part is drawn, and the front whole", () => {
  const data = many(20_000);
  const { drawn, of, spec } = charts.pareto({ data, axes: [0, 1] });
  const rows = new Set(spec.datasets.points.map(({ row }) => row));
  assert.equal(of, 20_000);
  assert.equal(drawn, rows.size);
  assert.ok(drawn < 9500, `${drawn} drawn`);
  for (let row = 0; row < 200; ++row) assert.ok(rows.has(row), `${row}`);
});

test("the edge is drawn only where the ranking counts both axes", () => {
  const corners = (axes) => charts.pareto({ data: many(300), axes }).spec.datasets.edge.length;
  assert.ok(corners([0, 1]) >= 3);
  assert.ok(corners([1, 0]) >= 3);
  assert.equal(corners([0, 2]), 0);
});

test("a specification is filled anew each time, and the file's stays as it was", () => {
  const before = plain(specifications);
  const { spec } = charts.pareto({ data: many(300), axes: [0, 2] });
  assert.equal(spec.encoding.x.title, "objective 0 (higher is better)");
  assert.equal(spec.encoding.y.title, "objective 2 (lower is better)");
  const params = Object.fromEntries(spec.params.map(({ name, value }) => [name, value]));
  assert.deepEqual(plain(params.present), ["listed", "on the front"]);
  assert.equal(params.reach.length, 4);
  const narrow = parallels.parallel({ data: many(300), width: 150 }).spec;
  assert.equal(narrow.params.find(({ name }) => name === "narrow").value, true);
  assert.equal(narrow.encoding.x.scale.domain[2], "objective 2 (inverted)");
  assert.deepEqual(specifications, before);
});

test("up is better on every axis", () => {
  const data = many(300);
  const { points } = parallels.parallel({ data });
  const height = (row, axis) => points(row, {}).find((each) => each.axis === axis).at;
  const [low, high] = [0, 1].map((end) => {
    const column = data.designs.values[2];
    return column.indexOf((end === 0 ? Math.min : Math.max)(...column));
  });
  assert.equal(height(low, "objective 2 (inverted)"), 1);
  assert.equal(height(high, "objective 2 (inverted)"), 0);
});

test("lines are those of the best; every design is counted on every axis", () => {
  const { spec, drawn, of } = parallels.parallel({ data: many(20_000) });
  assert.equal(drawn, 30);
  assert.equal(of, 20_000);
  assert.deepEqual([...new Set(spec.datasets.lines.map(({ row }) => row))].sort((a, b) => a - b),
    Array.from({ length: 30 }, (_, row) => row));
  const counted = spec.datasets.density.reduce((sum, { count }) => sum + count, 0);
  assert.equal(counted, 3 * 20_000);
});

// Uniformity is not greater than 1, and there are no half sheaths.
test("no axis reaches beyond what is possible, and counts have whole numbers", () => {
  const data = many(300);
  data.objectives = data.objectives.map((objective, i) => ({ ...objective, count: i === 2 }));
  data.designs.values[0] = data.designs.values[0].map((value) => 0.5 + value / 2);
  data.designs.values[0][7] = 1;
  data.designs.values[2] = data.designs.values[2].map((value) => Math.round(9 * value));
  const { spec } = charts.pareto({ data, axes: [0, 2] });
  const [low, high] = plain(spec.params.find(({ name }) => name === "reach").value);
  assert.equal(high, 1);
  assert.ok(low > 0.4 && low < 0.5, `${low}`);
  assert.equal(plain(spec.encoding.y.axis).tickMinStep, 1);
  assert.equal(plain(spec.encoding.y.axis).format, "d");
  assert.equal(plain(spec.encoding.x.axis).tickMinStep, undefined);
});

// As of a motor force where none is enough.
test("what has no value is a dash, and is drawn nowhere", () => {
  const data = many(300);
  data.designs.values[0][5] = null;
  assert.equal(charts.number(null), "-");
  assert.equal(charts.cell({ unit: "1" }, null), "-");
  const { spec } = charts.pareto({ data, axes: [0, 1] });
  assert.ok(spec.datasets.points.every(({ row }) => row !== 5));
  assert.ok(spec.params.find(({ name }) => name === "reach").value.every(Number.isFinite));
  const { points, spec: lines } = parallels.parallel({ data });
  assert.equal(points(5, {})[0].at, null);
  assert.equal(lines.datasets.density.reduce((sum, { count }) => sum + count, 0), 3 * 300 - 1);
});

// The same cases as in exploration_figures_test.cpp.
test("about the front are the nearest places, as far as the front reaches", () => {
  const near = (places, better = "higher") => {
    const [xs, ys] = [0, 1].map((axis) => places.map((place) => place[axis]));
    const data = { objectives: objectives.map((one) => ({ ...one, better, least: null, greatest: null })), ranking: [0, 1], designs: {
      word: places.map((_, i) => `M-${i + 1}-F`), name: places.map(() => ""), rank: places.map((_, i) => i + 1),
      front: places.map(() => 2), kind: places.map(() => 0), values: [xs, ys, xs] } };
    const { inside, near: window } = charts.pareto({ data, axes: [0, 1], view: "near" });
    return window && inside;
  };
  const best = [[1, 1], [0.95, 0.95], [0.92, 0.99], [0.99, 0.91], [0.9, 0.93], [0.97, 0.9], [0.93, 0.9], [0.9, 0.9]];
  const others = [[0, 0], [0.95, 0.5], [0.5, 0.95], [0.89, 0.99]];
  const turned = (places) => places.map(([x, y]) => [-x, -y]);
  assert.equal(near([...best, ...others]), 8);
  assert.equal(near(turned([...best, ...others]), "lower"), 8);
  assert.equal(near([[1, 0.5], [0.6, 1], [0.8, 0.8], [0.7, 0.6], [0.65, 0.55], [0.61, 0.9], [0.75, 0.7], [0.8, 0.55],
    [0.62, 0.52], [0, 0], [0.55, 0.9], [0.9, 0.45]]), 9);
  assert.equal(near([[1, 1], [0.95, 0.95], [0, 0], [0.2, 0.1]]), null);
});

const labelBox = ({ x, y, dx, dy, align, text }) => {
  const width = 7 * text.length;
  const left = x + dx - (align === "left" ? 0 : align === "right" ? width : width / 2);
  return { left, right: left + width, top: y + dy - 7, bottom: y + dy + 7 };
};
const farFrom = ({ left, right, top, bottom }, { x, y }) =>
  Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));

test("a label is nearer to its own mark than to another that has one", () => {
  const frame = { width: 400, height: 200 };
  for (let i = 0; i < 16; ++i) {
    const [a, b] = [{ x: 200, y: 100, text: "A" },
      { x: 200 + 16 * Math.cos(i * Math.PI / 8), y: 100 + 16 * Math.sin(i * Math.PI / 8), text: "B" }];
    const placed = plain(labels.place([a, b], frame)).map((label) => ({ label, box: labelBox(label) }));
    assert.deepEqual(placed.map(({ label }) => label.text), ["A", "B"]);
    assert.ok(farFrom(placed[0].box, a) < farFrom(placed[0].box, b) && farFrom(placed[1].box, b) < farFrom(placed[1].box, a));
  }
});

test("marks on one spot have one label, and other marks are left uncovered", () => {
  const frame = { width: 400, height: 200 };
  const spot = { x: 200, y: 100 };
  assert.deepEqual(plain(labels.place([{ ...spot, text: "A" }, { x: 203, y: 101, text: "TR7" }], frame))
    .map(({ text }) => text), ["A, TR7"]);
  const marks = Array.from({ length: 30 }, (_, i) => ({ x: 205 + 3 * i, y: 100 - (i % 5) }));
  const [label] = plain(labels.place([{ ...spot, text: "within 2 %" }], frame, marks));
  for (const { x, y } of marks) assert.ok(farFrom(labelBox(label), { x, y }) > 0, `over ${x}, ${y}`);
});

test("what lies outside the view stands at its edge with an arrow", () => {
  const { labelsBeside } = charts.pareto({ data: many(300), axes: [0, 1], view: [[0.4, 0.6], [0.4, 0.6]] });
  const texts = plain(labelsBeside([{ x: 0.1, y: 0.5, text: "A" }, { x: 0.9, y: 0.9, text: "B" }])).map(({ text }) => text);
  assert.deepEqual(texts, ["← A", "↗ B"]);
});

test("labels lie neither over each other nor beyond the frame", () => {
  const frame = { width: 400, height: 200 };
  const wanted = Array.from({ length: 40 }, (_, i) => ({
    x: (i * 97) % 400, y: (i * 53) % 200, text: `label ${i}` }));
  const placed = plain(labels.place(wanted, frame));
  assert.ok(placed.length > 15 && placed.length <= 40, `${placed.length}`);
  const boxes = placed.map(labelBox);
  boxes.forEach((a, i) => {
    assert.ok(a.left >= 0 && a.right <= 400 && a.top >= 0 && a.bottom <= 200);
    for (const b of boxes.slice(i + 1)) {
      assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top);
    }
    for (const { x, y } of wanted) {
      assert.ok(a.right <= x - 10 || x + 10 <= a.left || a.bottom <= y - 10 || y + 10 <= a.top, "over a mark");
    }
  });
});
