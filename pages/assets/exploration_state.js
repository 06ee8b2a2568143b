"use strict";

// State of an exploration's page and the reader's choices: the designs, the selection, the axes,
// the filter and the hidden columns. Its listeners are told of changes: "selection", "pointed",
// "axes", "rows", "columns" or "all".
// "selection", "pointed", "axes", "rows", "columns" or "all".
const explorationState = (() => {
  const most = 4; // designs side by side
  const { objectives, ranking } = reeve.data;
  const listeners = [];
  const rowOf = new Map(); // word -> row
  const filter = { text: "", which: document.getElementById("filter-which").value, bounds: [], parts: {} };
  const unfiltered = { ...filter };
  let ranges = new Map(); // column -> [low, high], brushed on an axis
  let hidden = new Set(); // columns of the table, by name
  let designs = null;
  let selected = []; // rows
  let putAway = []; // by the last choice, for want of room
  let pointed = null; // row
  let axes = [0, 2];
  let base = []; // rows that pass all but the ranges
  let rows = [];

  async function unpacked(text) {
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).text();
  }

  const tell = (what) => listeners.forEach((listener) => listener(what));

  function passes(row) {
    const kind = designs.kind[row];
    const has = {
      listed: designs.rank[row] > 0,
      named: reeve.data.tradeoff.named.includes(designs.word[row]),
      front: designs.front[row] === 1,
      known: kind === 2,
      sample: kind === 3,
      all: true,
    };
    if (!has[filter.which]) return false;
    const text = filter.text.trim().toLowerCase();
    if (text && !explorationCharts.label(designs, row).toLowerCase().includes(text)) return false;
    if (!explorationParts.has(designs.word[row], filter.parts)) return false;
    return filter.bounds.every(({ column, least, value }) => {
      const own = valueOf(column, row);
      return least ? own >= value : own <= value;
    });
  }

  // A missing value, such as a motor force if no force is enough, is the worst.
  const valueOf = (column, row) =>
    designs.values[column][row] ?? (objectives[column].better === "lower" ? Infinity : -Infinity);

  const inRanges = (row) =>
    [...ranges].every(([column, [low, high]]) => {
      const own = valueOf(column, row);
      return own >= low && own <= high;
    });

  function filterRows() {
    base = designs.word.map((_, row) => row).filter(passes);
    rows = base.filter(inRanges);
  }

  function applyFilter() {
    filterRows();
    tell("rows");
  }

  // "sheaths:1:4,travel:1:2"
  const rangesText = () =>
    [...ranges].map(([column, [low, high]]) => `${objectives[column].name}:${low}:${high}`).join(",");

  function readRanges(text) {
    return new Map((text ?? "").split(",").flatMap((part) => {
      const [name, ...ends] = part.split(":");
      const column = objectives.findIndex((objective) => objective.name === name);
      const kept = ends.map(Number);
      return column < 0 || kept.length !== 2 || kept.some(Number.isNaN) ? [] : [[column, kept]];
    }));
  }

  // "sheaths:most:4,travel:least:1"
  const boundsText = () =>
    filter.bounds
      .map(({ column, least, value }) => `${objectives[column].name}:${least ? "least" : "most"}:${value}`)
      .join(",");

  function readBounds(text) {
    return (text ?? "").split(",").flatMap((part) => {
      const [name, side, value] = part.split(":");
      const column = objectives.findIndex((objective) => objective.name === name);
      const isBound = column >= 0 && ["least", "most"].includes(side) && value && !Number.isNaN(Number(value));
      return isBound ? [{ column, least: side === "least", value: Number(value) }] : [];
    });
  }

  function readWhich(text) {
    const { options } = document.getElementById("filter-which");
    return [...options].some(({ value }) => value === text) ? text : unfiltered.which;
  }

  // The address holds what can be mailed: which designs, along which axes, by which filter and
  // ranges, of which parts, and which columns are put away.
  function writeAddress() {
    const parts = new URLSearchParams();
    parts.set("select", selected.map((row) => designs.word[row]).join(","));
    parts.set("x", objectives[axes[0]].name);
    parts.set("y", objectives[axes[1]].name);
    if (filter.text !== "") parts.set("text", filter.text);
    if (filter.which !== unfiltered.which) parts.set("show", filter.which);
    if (filter.bounds.length > 0) parts.set("bounds", boundsText());
    if (ranges.size > 0) parts.set("ranges", rangesText());
    const chosen = Object.entries(filter.parts).map((choice) => choice.join(":"));
    if (chosen.length > 0) parts.set("parts", chosen.join(","));
    if (hidden.size > 0) parts.set("without", [...hidden].join(","));
    history.replaceState(null, "", `#${parts}`);
  }

  function readAddress() {
    const parts = new URLSearchParams(location.hash.slice(1));
    if (!parts.has("select")) return false;
    // A '+' that somebody wrote by hand reads as a blank, and no word has one.
    const words = parts.get("select").replaceAll(" ", "+").split(",");
    selected = words.filter((word) => rowOf.has(word)).map((word) => rowOf.get(word)).slice(0, most);
    axes = ["x", "y"].map((name, which) => {
      const column = objectives.findIndex((objective) => objective.name === parts.get(name));
      return column < 0 ? axes[which] : column;
    });
    filter.text = parts.get("text") ?? "";
    filter.which = readWhich(parts.get("show"));
    filter.bounds = readBounds(parts.get("bounds"));
    ranges = readRanges(parts.get("ranges"));
    filter.parts = explorationParts.read(parts.get("parts"));
    hidden = new Set((parts.get("without") ?? "").split(",").filter(Boolean));
    return true;
  }

  // The first design and, beside it, the affordable one; or else the best of the known routings, or
  // the next that differs in what the ranking counts.
  function firstSelection() {
    const affordable = rowOf.get(reeve.data.tradeoff.affordable);
    if (affordable !== undefined) return [0, affordable];
    const known = designs.kind.findIndex((kind, row) => kind === 2 && row > 0);
    const differs = (row) =>
      ranking.some((column) => designs.values[column][row] !== designs.values[column][0]);
    const next = designs.word.findIndex((_, row) => differs(row));
    const second = known > 0 ? known : next;
    return [0, second].filter((row) => row >= 0 && row < designs.word.length);
  }

  async function load() {
    designs = JSON.parse(await unpacked(reeve.data.columns));
    designs.name.forEach((name, row) => name && rowOf.set(name, row)); // no name is a word
    designs.word.forEach((word, row) => rowOf.set(word, row));
    axes = ranking.length > 1 ? ranking.slice(0, 2) : [ranking[0], ranking[0] === 2 ? 0 : 2];
    if (!readAddress()) selected = firstSelection();
    addEventListener("hashchange", () => {
      if (!readAddress()) return;
      filterRows();
      tell("all");
    });
    filterRows();
  }

  // The design that is pointed at, or null.
  function point(row) {
    if (row === pointed) return;
    pointed = row;
    tell("pointed");
  }

  // null lets the range go.
  function setRange(column, range) {
    ranges = new Map(ranges);
    if (range === null) ranges.delete(column);
    else ranges.set(column, range);
    writeAddress();
    applyFilter();
  }

  function clearFilter() {
    Object.assign(filter, unfiltered);
    ranges = new Map();
    writeAddress();
    filterRows();
    tell("all");
  }

  function showColumn(name, shown) {
    if (shown) hidden.delete(name);
    else hidden.add(name);
    writeAddress();
    tell("columns");
  }

  // In or out; one too many replaces the one that was chosen first, and says so.
  function toggle(row) {
    const chosen = selected.includes(row)
      ? selected.filter((other) => other !== row)
      : [...selected, row];
    putAway = chosen.slice(0, -most);
    selected = chosen.slice(-most);
    writeAddress();
    tell("selection");
  }

  function clear() {
    selected = [];
    putAway = [];
    writeAddress();
    tell("selection");
  }

  function setAxis(which, column) {
    axes = axes.map((old, at) => (at === which ? column : old));
    writeAddress();
    tell("axes");
  }

  function setFilter(changes) {
    Object.assign(filter, changes);
    writeAddress();
    applyFilter();
  }

  return {
    load,
    unpacked,
    toggle,
    clear,
    setAxis,
    setFilter,
    setRange,
    clearFilter,
    showColumn,
    point,
    filter,
    onChange: (listener) => listeners.push(listener),
    data: () => ({ objectives, ranking, designs }),
    designs: () => designs,
    objectives,
    selected: () => selected,
    putAway: () => putAway,
    letter: (row) => explorationCharts.letters[selected.indexOf(row)] ?? "",
    axes: () => axes,
    base: () => base,
    rows: () => rows,
    ranges: () => ranges,
    hidden: () => hidden,
    pointed: () => pointed,
    rowOf: (word) => rowOf.get(word),
    label: (row) => explorationCharts.label(designs, row),
  };
})();
