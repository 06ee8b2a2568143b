"use strict";

// The panel that stays in view: the selected designs beside each other, and in the place of the last
// of them the one that is pointed at; each with drawing, tensions and parts.
const explorationPanel = (() => {
  const state = explorationState;
  const { element } = explorationTable;
  const place = document.getElementById("slots");
  const preview = document.getElementById("preview"); // beside the table, where the panel is out of view
  const parts = { sheaths: "sheath", pulleys: "pulley", knots: "knot", blocks: "floating block" };
  let asked = 0; // counts drawings, so that a late one does not overwrite a newer one

  // The first selected one stays, to compare with.
  function shown() {
    const selected = state.selected();
    const pointed = state.pointed();
    if (pointed === null || selected.includes(pointed)) return selected;
    return selected.length > 0 ? [selected[0], pointed] : [pointed];
  }

  function heading(row) {
    const { first, heading: affordable, affordable: word, knee } = reeve.data.tradeoff;
    const own = state.designs().word[row];
    const roles = [
      own === first && "Best", own === word && affordable, own === knee && "knee of the trade-off"].filter(Boolean);
    if (roles.length === 0) roles.push(explorationCharts.kinds[state.designs().kind[row]]);
    return [state.letter(row) || "Pointed at", roles.join(", ")].join(" · ");
  }

  // "0.985 (-1.0 %)", against the design beside it.
  function valueText(column, row, against) {
    const { values } = state.designs();
    const [own, other] = [values[column][row], values[column][against]];
    const { unit, count } = state.objectives[column];
    const text = explorationCharts.cell(state.objectives[column], own) +
      (unit === "1" || count || own === null ? "" : ` ${unit}`);
    if (row === against || own === null || !other || own === other) return text;
    const change = ((100 * (own - other)) / Math.abs(other)).toFixed(1);
    return Number(change) === 0 ? text : `${text} (${change > 0 ? "+" : ""}${change} %)`;
  }

  function values(row, against) {
    const { objectives } = state;
    const { ranking } = state.data();
    const lines = ranking.map((column) => `${objectives[column].title} ${valueText(column, row, against)}`);
    const counts = objectives.flatMap(({ name }, column) => {
      const count = state.designs().values[column][row];
      return name in parts && (count > 0 || name === "sheaths") ? [`${count} ${parts[name]}${count === 1 ? "" : "s"}`] : [];
    });
    const rank = state.designs().rank[row];
    return element("ul", { className: "values" },
      ...[...lines, counts.join(", "), rank > 0 ? `rank ${rank}` : ""].filter(Boolean)
        .map((textContent) => element("li", { textContent })));
  }

  // As high as the tension over the greatest of all that stand beside each other.
  function bars(design, most) {
    const tensions = explorationDetails.strands(design, 0);
    const held = explorationDetails.heldText(design.grasps[0].held);
    const text = tensions.map(({ strand, tension }) => `${strand} ${tension.toFixed(2)}`).join(", ");
    const made = element("div", { className: "bars" }, ...tensions.map(({ strand, tension }) => {
      const bar = element("span", { title: `${strand}: ${tension.toFixed(3)}` });
      bar.style.height = `${Math.max(2, (100 * tension) / most)}%`;
      return bar;
    }));
    made.setAttribute("role", "img");
    made.setAttribute("aria-label", `Strand tensions, ${held}: ${text}`);
    const [least, greatest] = explorationCharts.range(tensions.map(({ tension }) => tension), tensions.map((_, i) => i));
    return [made, element("p", { className: "soft", textContent:
      `Strand tensions, ${held}: ${least.toFixed(3)} to ${greatest.toFixed(3)} N per N of motor tension` })];
  }

  function slot(row, design, most, against, number) {
    const word = state.designs().word[row];
    const made = element("article", { className: "slot" },
      element("h2", { textContent: heading(row) }),
      element("p", { className: "word", textContent: state.label(row) }));
    made.dataset.word = word;
    const drawn = design && explorationDetails.schematic(design, 0, `panel-${number}`);
    made.append(element("div", { className: "drawing" }, drawn ||
      element("p", { className: "soft", textContent: `No drawing here: reeve show ${word} draws it.` })));
    made.append(values(row, against));
    if (design && most > 0) made.append(...bars(design, most));
    return made;
  }

  async function show() {
    asked += 1;
    const now = asked;
    const rows = shown();
    const designs = await Promise.all(rows.map((row) => explorationDetails.of(state.designs().word[row])));
    if (now !== asked) return;
    const most = Math.max(0, ...designs.flatMap((design) =>
      design ? explorationDetails.strands(design, 0).map(({ tension }) => tension) : []));
    place.replaceChildren(...rows.map((row, i) => slot(row, designs[i], most, rows[0], i)));
    const pointed = Math.max(0, rows.indexOf(state.pointed()));
    preview.replaceChildren(
      ...rows.slice(pointed, pointed + 1).map((row) => slot(row, designs[pointed], most, rows[0], "preview")));
  }

  function start() {
    state.onChange((what) => {
      if (what === "selection" || what === "pointed" || what === "all") show();
    });
    return show();
  }

  return { start };
})();
