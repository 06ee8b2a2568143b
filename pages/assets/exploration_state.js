"use strict";

// What an exploration's page knows and what the reader chose: the designs, the selection, the axes
// and the filter. Whoever shows them asks to be told of changes.
const explorationState = (() => {
  const most = 4; // designs side by side
  const { objectives, ranking } = reeve.data;
  const listeners = [];
  const rowOf = new Map(); // word -> row
  const filter = { text: "", which: "all", bounds: [] };
  let designs = null;
  let selected = []; // rows
  let putAway = []; // by the last choice, for want of room
  let axes = [0, 2];
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
      front: designs.front[row] === 1,
      known: kind === 2,
      sample: kind === 3,
      all: true,
    };
    if (!has[filter.which]) return false;
    const text = filter.text.trim().toLowerCase();
    if (text && !explorationCharts.label(designs, row).toLowerCase().includes(text)) return false;
    return filter.bounds.every(({ column, least, value }) => {
      const own = designs.values[column][row];
      return least ? own >= value : own <= value;
    });
  }

  function applyFilter() {
    rows = designs.word.map((_, row) => row).filter(passes);
    tell("rows");
  }

  // The address holds what can be mailed: which designs, along which axes.
  function writeAddress() {
    const parts = new URLSearchParams();
    parts.set("select", selected.map((row) => designs.word[row]).join(","));
    parts.set("x", objectives[axes[0]].name);
    parts.set("y", objectives[axes[1]].name);
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
    return true;
  }

  // The first design and, beside it, the best of the known routings or else the next that
  // differs in what the ranking counts.
  function firstSelection() {
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
      if (readAddress()) tell("all");
    });
    rows = designs.word.map((_, row) => row).filter(passes);
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
    applyFilter();
  }

  return {
    load,
    unpacked,
    toggle,
    clear,
    setAxis,
    setFilter,
    filter,
    onChange: (listener) => listeners.push(listener),
    data: () => ({ objectives, ranking, designs }),
    designs: () => designs,
    objectives,
    selected: () => selected,
    putAway: () => putAway,
    letter: (row) => explorationCharts.letters[selected.indexOf(row)] ?? "",
    axes: () => axes,
    rows: () => rows,
    label: (row) => explorationCharts.label(designs, row),
  };
})();
