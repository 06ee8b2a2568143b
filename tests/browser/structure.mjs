// What a page is made of: headings, tables, figures. Each function returns what is wrong.

// Headings in order, one of the first level, ids that are unique, tables that say what they show.
export const outlineFaults = (page) =>
  page.evaluate(() => {
    const faults = [];
    const levels = [...document.querySelectorAll("h1, h2, h3, h4, h5, h6")].map((heading) =>
      Number(heading.tagName[1]),
    );
    if (levels[0] !== 1) faults.push("the first heading is no h1");
    if (levels.filter((level) => level === 1).length !== 1) faults.push("not one h1");
    levels.forEach((level, i) => {
      if (i > 0 && level > levels[i - 1] + 1) faults.push(`h${level} after h${levels[i - 1]}`);
    });
    const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
    for (const id of ids.filter((id, i) => ids.indexOf(id) !== i)) faults.push(`two ids ${id}`);
    for (const table of document.querySelectorAll("table")) {
      const name = table.id || table.caption?.textContent || "a table";
      if (!table.caption?.textContent.trim()) faults.push(`${name}: no caption`);
      if (table.querySelector("th:not([scope])")) faults.push(`${name}: th without scope`);
      if (!table.querySelector("th")) faults.push(`${name}: no headings`);
    }
    if (!document.title.trim()) faults.push("no title");
    return faults;
  });

// With JavaScript: every chart is drawn once, says in words what it shows, and can be saved.
export const figureFaults = (page) =>
  page.evaluate(() => {
    const faults = [];
    // Live charts have their text on what holds them.
    const alt = (svg) =>
      [svg, svg.closest(".live")].some((one) => one?.getAttribute("aria-label")?.trim());
    const size = (element) => element?.getBoundingClientRect() ?? { width: 0, height: 0 };
    const visible = (figure) => figure.getClientRects().length > 0;
    for (const figure of [...document.querySelectorAll("figure.chart")].filter(visible)) {
      const drawn = [...figure.querySelectorAll(".still svg, .live svg")]
        .filter((svg) => size(svg).width > 100 && size(svg).height > 40);
      if (drawn.length === 0) faults.push(`${figure.id} is not drawn`);
      if (drawn.length > 1) faults.push(`${figure.id} is there twice`);
      if (drawn.length > 0 && !alt(drawn[0])) faults.push(`${figure.id} has no text`);
    }
    const figures = [...document.querySelectorAll("figure.chart, figure.schematic")];
    for (const figure of figures.filter(visible)) {
      const buttons = figure.querySelectorAll(".save button").length;
      if (buttons !== 2) faults.push(`${figure.id} has ${buttons} buttons to save it`);
    }
    return faults;
  });

// Printed, or without JavaScript: the still figure of every chart, and that alone. A chart that
// only a choice of the reader brings up has none: it shows as it is, or not at all.
export const staticFaults = (page) =>
  page.evaluate(() => {
    const faults = [];
    const alt = (svg) =>
      [svg, svg.closest(".live")].some((one) => one?.getAttribute("aria-label")?.trim());
    const wide = (element) => element?.getBoundingClientRect().width > 100;
    const visible = (figure) => figure.getClientRects().length > 0;
    for (const figure of [...document.querySelectorAll("figure.chart")].filter(visible)) {
      const still = figure.querySelector(".still");
      const svg = (still ?? figure.querySelector(".live")).querySelector("svg");
      if (!wide(svg)) faults.push(`${figure.id}: no figure`);
      if (still && wide(figure.querySelector(".live"))) faults.push(`${figure.id} is there twice`);
      if (svg && !alt(svg)) faults.push(`${figure.id} has no text`);
    }
    return faults;
  });

// Values that escaped from a program, and texts that became more than texts.
export const textFaults = (page) =>
  page.evaluate(() => {
    const faults = [];
    const text = document.body.innerText;
    for (const slip of ["undefined", "NaN", "[object Object]", "-nan", "null"]) {
      const at = text.search(new RegExp(`(^|[\\s(=:])${slip.replace(/[[\]]/g, "\\$&")}($|[\\s,;.)])`));
      if (at >= 0) faults.push(`'${slip}' in: ${text.slice(Math.max(0, at - 40), at + 40)}`);
    }
    if (window.stolen) faults.push("a text was run as a script");
    if (document.querySelector("img, iframe, object, embed, link")) faults.push("a foreign element");
    return faults;
  });
