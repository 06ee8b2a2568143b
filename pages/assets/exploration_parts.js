"use strict";

// Parts of a routing, read from its word, and the filter by them: for who knows what a routing has,
// and not its word. The first that pass are drawn.
const explorationParts = (() => {
  const mostDrawn = 12;
  // A key for the state, words for the reader, and whether a word has it.
  const kinds = [
    ["tied", "an end tied at the hand", (word) => /(^|[-+])F([-+]|$)/.test(word)],
    ["tip_end", "a tendon tied at a fingertip", (word) => /\dx/.test(word)],
    ["tip_bearing", "a bearing at a fingertip", (word) => /\db/.test(word)],
    ["tube", "a tube at the hand", (word) => /-T-/.test(word)],
    ["pulley", "a fixed pulley at the hand", (word) => /-B-/.test(word)],
    ["carriage_pulley", "a movable pulley on the carriage", (word) => /-P-/.test(word)],
    ["floating", "a floating block", (word) => /Y\d/.test(word)],
    ["bar", "a rigid bar", (word) => /W\d/.test(word)],
    ["loop", "a closed loop", (word) => word.split("+").some(isLoop)],
    ["several", "several tendons", (word) => word.includes("+")],
  ];
  const count = (word, pattern) => (word.match(pattern) ?? []).length;
  const isLoop = (walk) => /^(\d+b?)-(?:.*-)?\1$/.test(walk);

  // One for each end tied to the carriage, two for each movable pulley on it.
  const sheaths = (word) => count(word, /(?<![^-+])M(?![^-+])/g) + 2 * count(word, /(?<![^-+])P(?![^-+])/g);

  const test = new Map(kinds.map(([key, , has]) => [key, has]));
  // wanted: {key: "with" or "without", sheaths: a number}, of those that matter.
  const has = (word, wanted) =>
    Object.entries(wanted).every(([key, want]) =>
      key === "sheaths" ? sheaths(word) === Number(want) : test.get(key)(word) === (want === "with"));

  // "sheaths:1,tied:with", as the address has it; what is no choice is left out.
  function read(text) {
    const pairs = (text ?? "").split(",").map((part) => part.split(":"));
    return Object.fromEntries(pairs.filter(([key, want]) =>
      key === "sheaths" ? /^\d+$/.test(want) : test.has(key) && ["with", "without"].includes(want)));
  }

  return { kinds, sheaths, has, read, mostDrawn };
})();
