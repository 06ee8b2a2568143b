"use strict";

// The choices of parts that narrow the designs, and the drawings of the first that pass.
const explorationFinder = (() => {
  const state = explorationState;
  const { element } = explorationTable;
  const { kinds, sheaths, mostDrawn } = explorationParts;
  const gallery = document.getElementById("gallery");
  const choices = new Map(); // key -> its select
  let asked = 0; // counts drawings, so that a late one does not overwrite a newer one

  function want(key, value) {
    const parts = { ...state.filter.parts };
    if (value === "") delete parts[key];
    else parts[key] = value;
    state.setFilter({ parts });
  }

  function choice(key, text, values) {
    const select = element("select", {}, element("option", { value: "", textContent: "any" }),
      ...values.map((value) => element("option", { value })));
    select.addEventListener("change", () => want(key, select.value));
    choices.set(key, select);
    return element("label", {}, `${text} `, select);
  }

  // Parts that some designs have and others have not.
  function addChoices() {
    const words = state.designs().word;
    const numbers = [...new Set(words.map(sheaths))].sort((a, b) => a - b);
    const telling = kinds.filter(([, , has]) => new Set(words.map(has)).size > 1);
    document.getElementById("part-choices").append(
      ...(numbers.length > 1 ? [choice("sheaths", "sheaths", numbers)] : []),
      ...telling.map(([key, text]) => choice(key, text, ["with", "without"])));
  }

  // Each choice says how many designs it would leave of those that pass the others.
  function showChoices() {
    const words = state.rows().map((row) => state.designs().word[row]);
    for (const [key, select] of choices) {
      select.value = state.filter.parts[key] ?? "";
      for (const option of select.options) {
        if (option.value === "") continue;
        const left = words.filter((word) => explorationParts.has(word, { [key]: option.value })).length;
        option.textContent = `${option.value} (${left})`;
      }
    }
  }

  async function drawing(row, number) {
    const word = state.designs().word[row];
    const design = await explorationDetails.of(word);
    const svg = design && explorationDetails.schematic(design, 0, `found-${number}`);
    const button = element("button", { type: "button", className: "found" }, ...(svg ? [svg] : []),
      element("span", { textContent: state.label(row) }));
    button.setAttribute("aria-label", `Select ${state.label(row)}`);
    button.addEventListener("click", () => state.toggle(row));
    return button;
  }

  async function showDrawings() {
    asked += 1;
    const now = asked;
    const wanted = Object.keys(state.filter.parts).length > 0;
    const rows = wanted ? state.rows().filter((row) => !state.rows().includes(state.designs().same_as[row])) : [];
    const drawings = await Promise.all(rows.slice(0, mostDrawn).map(drawing));
    if (now !== asked) return;
    gallery.replaceChildren(...drawings);
    document.getElementById("found-count").textContent = wanted
      ? `${rows.length} design${rows.length === 1 ? "" : "s"}${rows.length > mostDrawn ? `, the first ${mostDrawn} drawn` : ""}.`
      : "";
  }

  function show() {
    showChoices();
    showDrawings();
  }

  function start() {
    addChoices();
    show();
    state.onChange((what) => {
      if (what === "rows" || what === "all") show();
    });
  }

  return { start };
})();
