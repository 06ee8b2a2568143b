"use strict";

// The selected designs side by side: schematic, tensions, contacts, ranks, commands.
const explorationCards = (() => {
  const state = explorationState;
  const { element } = explorationTable;
  const { heldText } = explorationDetails;
  const place = document.getElementById("selection");
  let grasp = 0;
  let shown = 0; // counts drawings, so that a late one does not overwrite a newer one
  let drawn = []; // figures with charts

  function table(caption, headings, rows) {
    const head = element("tr", {}, ...headings.map((text, i) =>
      element("th", { scope: "col", textContent: text, className: i === 0 ? "left" : "" })));
    const body = rows.map(([first, ...rest]) =>
      element("tr", {},
        element("th", { scope: "row", className: "left", textContent: first }),
        ...rest.map((text) => element("td", { textContent: text }))));
    const made = element("table", {},
      element("caption", { textContent: caption }),
      element("thead", {}, head), element("tbody", {}, ...body));
    const scroll = element("div", { className: "scroll", tabIndex: 0 }, made);
    scroll.setAttribute("role", "region");
    scroll.setAttribute("aria-label", caption);
    return scroll;
  }

  const slideText = (slides) => (slides === "no" ? "no slip" : slides.replace("->", "→"));

  function tensionsFigure(design, word, letter, most, width) {
    const tensions = design.grasps.flatMap(({ held, tensions: values, jams }) =>
      design.strands.map((segment) => ({
        held: heldText(held) + (jams ? " (jams)" : ""),
        strand: design.segments[segment],
        tension: values[segment],
      })),
    ).sort((a, b) => Number(a.strand.slice(1)) - Number(b.strand.slice(1)));
    const inOrder = design.grasps.flatMap(({ held }) =>
      tensions.filter((each) => each.held.startsWith(heldText(held))));
    const live = element("div", { className: "live" });
    live.setAttribute("role", "img");
    live.setAttribute("aria-label", `Tensions of the strands of ${word} in each grasp`);
    const figure = element("figure", { className: "chart tensions", id: `tensions-${letter}` }, live,
      element("figcaption", {}, element("strong", { textContent: "Strand tensions" }),
        ", N per N of motor tension, by which fingers are held."));
    const columns = Math.max(1, Math.min(design.grasps.length, Math.floor((width - 10) / 165)));
    return { figure, spec: explorationCharts.tensions({ tensions: inOrder, columns, most }) };
  }

  function contactsTable(design) {
    return table("Contacts: which way the tendon slides",
      ["contact", "kind", ...design.grasps.map(({ held }) => heldText(held))],
      design.contacts.map(({ between, kind, slides }) => [between, kind, ...slides.map(slideText)]));
  }

  function valuesTable(row) {
    const designs = state.designs();
    return table("Objectives",
      ["objective", "value", "unit", "better"],
      state.objectives.map(({ name, title, unit, better }, column) =>
        [title, explorationCharts.cell({ name, unit }, designs.values[column][row]) +
          explorationCharts.bandText(designs, column, row), unit, better]));
  }

  function standing(row) {
    const { rank, front, kind } = state.designs();
    if (rank[row] > 0) return `Rank ${rank[row]}, front ${front[row]}.`;
    return kind[row] === 3
      ? "One of the random sample of all ranked designs; not among the listed."
      : reeve.data.standings[state.designs().word[row]];
  }

  function drawsText(row) {
    const { first, median, low, high, constraints_met: met } = state.designs().distribution;
    if (!first || first[row] === null || first[row] === undefined) return [];
    const { number, shareText } = explorationCharts;
    const constraints = met ? ` It meets all constraints in ${shareText(met[row])}.` : "";
    return [element("p", { className: "draws", textContent:
      `With drawn coefficients: first in ${shareText(first[row])} of the draws, median ` +
      `rank ${number(median[row])}, from ${number(low[row])} (5 %) to ${number(high[row])} (95 %).${constraints}` })];
  }

  function commands(word) {
    const { show, held, options, one } = reeve.data.commands;
    return [
      element("p", { className: "soft", textContent: "To see this design again, and to draw it:" }),
      element("pre", { className: "command",
        textContent: `${show} ${word}${held}${options}\n${show} ${word} --held ${one[grasp]} ` +
          `--svg ${word}.svg${options}` }),
    ];
  }

  function drawing(design, letter) {
    const id = `schematic-${letter}`;
    const svg = explorationDetails.schematic(design, grasp, id);
    if (svg) return element("figure", { className: "schematic", id }, svg);
    return element("p", { textContent:
      "The page holds the schematic of this design in the first grasp only; the command below draws it." });
  }

  function card(row, design, most, width) {
    const letter = state.letter(row);
    const word = state.designs().word[row];
    const remove = element("button", { type: "button", textContent: "Remove" });
    remove.setAttribute("aria-label", `Remove ${state.label(row)} from the selection`);
    remove.addEventListener("click", () => state.toggle(row));
    const made = element("article", { className: "card" },
      element("h3", { textContent: `${letter}  ${state.label(row)}` }), remove,
      element("p", { className: "standing", textContent: standing(row) }), ...drawsText(row));
    made.dataset.word = word;
    let tensions = null;
    const parts = element("div", { className: "parts" });
    if (design) {
      tensions = tensionsFigure(design, word, letter, most, width);
      parts.append(drawing(design, letter), tensions.figure, contactsTable(design));
    } else {
      parts.append(element("p", { textContent:
        "The page holds the values of this design only; the command draws it." }));
    }
    parts.append(valuesTable(row));
    if (design?.shared) parts.append(element("p", { className: "soft", textContent: `${design.shared}.` }));
    made.append(parts, ...commands(word));
    return { made, tensions };
  }

  function rankChart(rows) {
    const { low, median, high } = state.designs().distribution;
    const figure = document.getElementById("rank-ranges");
    const known = rows.filter((row) => low && low[row] !== null && low[row] !== undefined);
    figure.hidden = known.length === 0;
    if (figure.hidden) return null;
    const ranks = known.map((row) => ({
      design: `${state.letter(row)} ${state.label(row)}`, low: low[row], median: median[row], high: high[row] }));
    return { figure, spec: explorationCharts.ranks({ ranks }) };
  }

  // Selects the grasp of the schematics: the same for all designs, to compare them.
  function graspChoice() {
    const select = document.getElementById("grasp");
    reeve.data.commands.one.forEach((held, i) =>
      select.append(element("option", { value: i, textContent: heldText(held) })));
    select.addEventListener("change", () => {
      grasp = Number(select.value);
      show();
    });
  }

  async function show() {
    shown += 1;
    const now = shown;
    const rows = state.selected();
    const designs = await Promise.all(rows.map((row) => explorationDetails.of(state.designs().word[row])));
    if (now !== shown) return;
    const tensions = designs.flatMap((design) =>
      design ? design.grasps.flatMap((each) => design.strands.map((i) => each.tensions[i])) : []);
    const width = Math.min(place.clientWidth, Math.max(330, place.clientWidth / Math.max(1, rows.length)));
    const cards = rows.map((row, i) => card(row, designs[i], Math.max(0.01, ...tensions), width - 40));
    drawn.forEach((figure) => liveCharts.forget(figure));
    place.replaceChildren(...cards.map(({ made }) => made));
    place.style.setProperty("--cards", rows.length);
    document.getElementById("selection-empty").hidden = rows.length > 0;
    const charts = [...cards.map(({ tensions: chart }) => chart)].filter(Boolean);
    drawn = charts.map(({ figure }) => figure);
    for (const figure of place.querySelectorAll("figure.schematic")) {
      reeve.savable(figure, figure.closest(".card").dataset.word);
    }
    for (const { figure, spec } of charts) {
      await liveCharts.draw(figure, spec);
      liveCharts.savable(figure, `${figure.closest(".card")?.dataset.word}-tensions`);
    }
    const ranks = rankChart(rows);
    if (ranks) {
      await liveCharts.draw(ranks.figure, ranks.spec);
      if (!ranks.figure.querySelector(".save")) liveCharts.savable(ranks.figure);
    }
  }

  function start() {
    graspChoice();
    state.onChange((what) => {
      if (what === "selection" || what === "all") show();
    });
    // How wide cards are is known only where they are seen.
    document.getElementById("comparison").addEventListener("toggle", ({ target }) => target.open && show());
    return show();
  }

  return { start };
})();
