"use strict";

// Data of a design besides its values: schematics, tensions and contacts, packed together with
// those of other designs.
const explorationDetails = (() => {
  const packs = new Map(); // chunk -> promise of its designs and of their schematics' lines

  async function opened({ pack }) {
    const [designs, ...lines] = (await explorationState.unpacked(pack)).split("\n");
    return { designs: JSON.parse(designs), lines };
  }

  // null if the page has none of it.
  async function of(word) {
    const chunk = reeve.data.chunks.find(({ words }) => words.includes(word));
    if (!chunk) return null;
    if (!packs.has(chunk)) packs.set(chunk, opened(chunk));
    const { designs, lines } = await packs.get(chunk);
    return { lines, ...designs[chunk.words.indexOf(word)] };
  }

  // In that grasp, with ids of its own; null if the page has none.
  function schematic({ lines, grasps }, grasp, id) {
    const runs = grasps[grasp].schematic;
    if (runs === undefined) return null;
    const text = runs.split(" ").flatMap((run) => {
      const [first, last = first] = run.split("-").map(Number);
      return lines.slice(first, last + 1);
    });
    const parsed = new DOMParser().parseFromString(text.join("\n"), "image/svg+xml");
    const svg = document.importNode(parsed.documentElement, true);
    for (const named of svg.querySelectorAll("[id]")) {
      named.id = named.id.replace("schematic", id);
    }
    svg.setAttribute("aria-labelledby", `${id}-title ${id}-desc`);
    return svg;
  }

  const heldText = (held) => (held === "none" ? "none held" : `${held} held`);

  // [{strand, tension}] in the order of their numbers.
  const strands = ({ grasps, strands: which, segments }, grasp) =>
    which
      .map((segment) => ({ strand: segments[segment], tension: grasps[grasp].tensions[segment] }))
      .sort((a, b) => Number(a.strand.slice(1)) - Number(b.strand.slice(1)));

  return { of, schematic, heldText, strands };
})();
