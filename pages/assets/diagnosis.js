"use strict";

// Panels side by side where there is room, below each other where there is not.
(() => {
  const axis = 75; // room that a panel's axis takes beside it
  const figures = [...document.querySelectorAll("figure.chart")];
  const widths = new Map();

  async function fit(figure, spec) {
    const room = figure.clientWidth;
    if (room === 0 || widths.get(figure) === room) return;
    widths.set(figure, room);
    const { columns: most, greatest_px: greatest } = spec.usermeta;
    const columns = room / most > 250 + axis ? most : 1;
    const panel = Math.round(Math.min(greatest, Math.max(200, room / columns - axis)));
    const square = spec.concat[0].height === spec.concat[0].width;
    const sized = (one) => ({ ...one, width: panel, ...(square && { height: panel }) });
    await reeve.draw(figure, { ...spec, columns, concat: spec.concat.map(sized) });
  }

  reeve.ready.then(() => {
    for (const figure of figures) {
      const spec = JSON.parse(figure.querySelector("script.spec").textContent);
      if (!spec?.usermeta?.greatest_px) continue;
      new ResizeObserver(() => fit(figure, spec)).observe(figure);
    }
  });
})();
