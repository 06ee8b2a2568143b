"use strict";

// Columns of the table that are shown: the reader's choice, and always those that name a design.
const explorationColumns = (() => {
  const state = explorationState;
  const table = document.getElementById("designs");
  const always = ["select", "rank", "name", "word"];

  // By name, which the address holds: objectives by theirs.
  const nameOf = (heading) => {
    const { column } = heading.dataset;
    return /^\d+$/.test(column) ? state.objectives[Number(column)].name : column;
  };

  // As they are chosen, and with those that name a design frozen at the left.
  function apply() {
    const headings = [...table.tHead.rows[0].cells];
    const put = headings.map((heading) => state.hidden().has(nameOf(heading)));
    for (const row of table.rows) {
      if (row.cells.length !== headings.length) continue;
      [...row.cells].forEach((cell, i) => (cell.hidden = put[i]));
    }
    let left = 0;
    headings.slice(0, always.length).forEach((heading, i) => {
      table.style.setProperty(`--left-${i + 1}`, `${left}px`);
      left += heading.getBoundingClientRect().width;
    });
  }

  function boxes() {
    return [...table.tHead.rows[0].cells]
      .filter((heading) => !always.includes(heading.dataset.column))
      .map((heading) => {
        const box = Object.assign(document.createElement("input"), { type: "checkbox" });
        box.dataset.column = nameOf(heading);
        box.addEventListener("change", () => state.showColumn(box.dataset.column, box.checked));
        const label = document.createElement("label");
        label.append(box, ` ${heading.textContent}`);
        return label;
      });
  }

  function check() {
    for (const box of document.querySelectorAll("#column-boxes input")) {
      box.checked = !state.hidden().has(box.dataset.column);
    }
  }

  function start() {
    document.getElementById("column-boxes").append(...boxes());
    check();
    state.onChange((what) => {
      if (what === "columns" || what === "all") {
        check();
        apply();
      }
    });
    addEventListener("resize", apply);
  }

  return { start, apply };
})();
