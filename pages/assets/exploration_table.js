"use strict";

// The table of an exploration's designs, of which the page holds one screen at a time, and its
// filter. Designs that are alike are one line, which opens.
const explorationTable = (() => {
  const perPage = 50;
  const state = explorationState;
  const table = document.getElementById("designs");
  const order = { column: "rank", down: false };
  const opened = new Set(); // first rows of those that are alike
  let page = 0;
  let sorted = [];
  let alike = new Map(); // first row that passes the filter -> the others that do

  const element = (tag, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
  };

  // Returns the sort key: a name of designs' columns, or the number of an objective.
  function key(column) {
    const designs = state.designs();
    if (typeof column === "number") return (row) => designs.values[column][row];
    if (column in designs.distribution) return (row) => designs.distribution[column][row];
    if (column === "alike") return (row) => alike.get(row).length;
    return (row) => designs[column][row];
  }

  // Missing values come last, in either direction.
  function compare(a, b, down) {
    const missing = (value) => value === null || value === "" || value === undefined;
    if (missing(a) !== missing(b)) return missing(a) ? 1 : -1;
    const difference = typeof a === "string" ? (a < b ? -1 : a > b ? 1 : 0) : a - b;
    return down ? -difference : difference;
  }

  // The best that passes the filter stands for all that are alike.
  function group() {
    const firsts = new Map();
    alike = new Map();
    for (const row of state.rows()) {
      const same = state.designs().same_as[row];
      const whole = same < 0 ? row : same;
      if (firsts.has(whole)) {
        alike.get(firsts.get(whole)).push(row);
      } else {
        firsts.set(whole, row);
        alike.set(row, []);
      }
    }
  }

  function sort() {
    group();
    const value = key(order.column);
    const rank = state.designs().rank;
    const last = (row) => (order.column === "rank" && rank[row] === 0 ? null : value(row));
    sorted = [...alike.keys()].sort((a, b) => compare(last(a), last(b), order.down) || a - b);
  }

  function cell(text, className = "") {
    return element("td", { textContent: text, className });
  }

  function selector(row) {
    const box = element("input", { type: "checkbox", className: "select-design" });
    box.checked = state.selected().includes(row);
    box.dataset.word = state.designs().word[row];
    box.setAttribute("aria-label", `Select ${state.label(row)}`);
    box.addEventListener("change", () => state.toggle(row));
    return element("td", { className: "left" }, box, ` ${state.letter(row)}`);
  }

  // How many more are alike, as a button that shows them.
  function alikeCell(row) {
    const others = alike.get(row) ?? [];
    if (others.length === 0) return cell("");
    const open = opened.has(row);
    const button = element("button", { type: "button", textContent: `+${others.length}`,
      title: "Further designs with other bearings, which change nothing" });
    button.setAttribute("aria-expanded", String(open));
    button.setAttribute("aria-label", `${others.length} more like ${state.label(row)}`);
    button.dataset.alike = row;
    button.addEventListener("click", () => {
      if (!opened.delete(row)) opened.add(row);
      show();
      table.querySelector(`button[data-alike="${row}"]`).focus();
    });
    return element("td", {}, button);
  }

  function rowElement(row) {
    const designs = state.designs();
    const { number, kinds, shareText } = explorationCharts;
    const line = element("tr");
    line.dataset.word = designs.word[row];
    if (state.selected().includes(row)) line.setAttribute("aria-selected", "true");
    const rank = designs.rank[row] || (designs.kind[row] === 3 ? "sample" : "–");
    const routing = element("th", { scope: "row", className: "left", textContent: designs.word[row] });
    if (!alike.has(row)) line.className = "alike";
    line.dataset.kind = designs.kind[row];
    if (reeve.data.tradeoff.advised.some(({ word }) => word === designs.word[row])) line.classList.add("advised");
    line.append(selector(row), cell(rank), cell(designs.name[row] || "–", "left"), routing);
    line.append(alikeCell(row), cell(designs.front[row] || "–"));
    line.addEventListener("pointerenter", () => state.point(row));
    line.addEventListener("focusin", () => state.point(row));
    state.objectives.forEach((objective, column) =>
      line.append(cell(explorationCharts.cell(objective, designs.values[column][row]))),
    );
    const drawn = designs.distribution;
    if (drawn.first) {
      const has = drawn.first[row] !== null && drawn.first[row] !== undefined;
      line.append(cell(has ? shareText(drawn.first[row]) : "–"));
      line.append(cell(has ? number(drawn.median[row]) : "–"));
      line.append(cell(has ? `${number(drawn.low[row])}–${number(drawn.high[row])}` : "–"));
      const met = drawn.constraints_met?.[row];
      if (drawn.constraints_met) line.append(cell(met === null || met === undefined ? "–" : shareText(met)));
    }
    line.title = kinds[designs.kind[row]];
    return line;
  }

  // A note in place of the table if no design passes the filter.
  function nothing() {
    const clear = element("button", { type: "button", textContent: "Clear the filter" });
    clear.addEventListener("click", state.clearFilter);
    return element("p", { className: "nothing" }, "No design passes the filter. ", clear);
  }

  function nothingLine() {
    const cell = element("td", { className: "left", colSpan: table.tHead.rows[0].cells.length }, nothing());
    return element("tr", {}, cell);
  }

  function show() {
    const pages = Math.max(1, Math.ceil(sorted.length / perPage));
    page = Math.min(Math.max(page, 0), pages - 1);
    const rows = sorted
      .slice(page * perPage, (page + 1) * perPage)
      .flatMap((row) => (opened.has(row) ? [row, ...alike.get(row)] : [row]));
    const focused = document.activeElement?.dataset?.word;
    table.tBodies[0].replaceChildren(...(rows.length > 0 ? rows.map(rowElement) : [nothingLine()]));
    explorationColumns.apply();
    if (focused) table.querySelector(`input[data-word="${CSS.escape(focused)}"]`)?.focus();
    document.getElementById("page-number").textContent = `page ${page + 1} of ${pages}`;
    document.getElementById("previous-page").disabled = page === 0;
    document.getElementById("next-page").disabled = page + 1 === pages;
    const some = state.rows().length;
    const lines = sorted.length < some ? ` in ${sorted.length} lines` : "";
    document.getElementById("filter-count").textContent =
      `${some} of ${state.designs().word.length} designs${lines}`;
  }

  function update() {
    sort();
    page = 0;
    show();
  }

  function sortBy(heading, column) {
    order.down = order.column === column && !order.down;
    order.column = column;
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", order.down ? "descending" : "ascending");
    update();
  }

  function addHeadings() {
    for (const heading of [...table.tHead.rows[0].cells]) {
      const named = heading.dataset.column;
      const column = /^\d+$/.test(named) ? Number(named) : named;
      const button = element("button", { type: "button" }, ...heading.childNodes);
      button.addEventListener("click", () => sortBy(heading, column));
      heading.append(button);
      if (named === "rank") heading.setAttribute("aria-sort", "ascending");
    }
    const select = element("th", { scope: "col", className: "left", textContent: "Select" });
    select.dataset.column = "select";
    table.tHead.rows[0].prepend(select);
  }

  function readBounds() {
    const bounds = [];
    for (const line of document.querySelectorAll("#bounds .bound")) {
      const [column, side, value] = line.querySelectorAll("select, input");
      if (value.value === "" || Number.isNaN(Number(value.value))) continue;
      bounds.push({ column: Number(column.value), least: side.value === "least", value: Number(value.value) });
    }
    state.setFilter({ bounds });
  }

  function option(value, text) {
    return element("option", { value, textContent: text });
  }

  function addBound() {
    const column = element("select", {}, ...state.objectives.map((o, i) => option(i, o.title)));
    column.setAttribute("aria-label", "Objective of the bound");
    const side = element("select", {}, option("least", "at least"), option("most", "at most"));
    side.setAttribute("aria-label", "Side of the bound");
    const value = element("input", { type: "number", step: "any" });
    value.setAttribute("aria-label", "Value of the bound");
    const remove = element("button", { type: "button", textContent: "Remove" });
    remove.setAttribute("aria-label", "Remove this bound");
    const line = element("div", { className: "bound" }, column, side, value, remove);
    line.addEventListener("input", readBounds);
    remove.addEventListener("click", () => {
      line.remove();
      readBounds();
      document.getElementById("add-bound").focus();
    });
    document.getElementById("bounds").append(line);
    return column;
  }

  function showBound(bound) {
    const [column, side, value] = addBound().parentElement.querySelectorAll("select, input");
    column.value = bound.column;
    side.value = bound.least ? "least" : "most";
    value.value = bound.value;
  }

  // Shows the filter if it was changed elsewhere.
  function showFilter() {
    document.getElementById("filter-text").value = state.filter.text;
    document.getElementById("filter-which").value = state.filter.which;
    document.getElementById("bounds").replaceChildren();
    state.filter.bounds.forEach(showBound);
    if (state.filter.bounds.length === 0) addBound();
  }

  function start() {
    addHeadings();
    document.getElementById("filter-text").addEventListener("input", (event) =>
      state.setFilter({ text: event.target.value }),
    );
    document.getElementById("filter-which").addEventListener("change", (event) =>
      state.setFilter({ which: event.target.value }),
    );
    document.getElementById("add-bound").addEventListener("click", () => addBound().focus());
    document.getElementById("previous-page").addEventListener("click", () => ((page -= 1), show()));
    document.getElementById("next-page").addEventListener("click", () => ((page += 1), show()));
    showFilter();
    table.addEventListener("pointerleave", () => state.point(null));
    table.addEventListener("focusout", () => state.point(null));
    explorationColumns.start();
    update();
    state.onChange((what) => {
      if (what === "all") showFilter();
      if (what === "rows" || what === "all") update();
      if (what === "selection") show();
    });
  }

  return { start, element, nothing };
})();
