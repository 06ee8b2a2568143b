"use strict";

// Panels side by side where there is room, below each other where there is not; and the tensions on
// a linear or a logarithmic scale.
(() => {
  const axis = 75; // room that a panel's axis takes beside it

  function fitted(spec, room) {
    const { columns: most, greatest_px: greatest } = spec.usermeta;
    const columns = room / most > 250 + axis ? most : 1;
    const panel = Math.round(Math.min(greatest, Math.max(200, room / columns - axis)));
    const square = spec.concat[0].height === spec.concat[0].width;
    const sized = (one) => ({ ...one, width: panel, ...(square && { height: panel }) });
    return { ...spec, columns, concat: spec.concat.map(sized) };
  }

  // Linear about 0, since a slack strand reads 0.
  function logarithmic(spec) {
    const ticks = [0, 0.1, 0.3, 1, 3, 10, 30, 100, 300, 1000, 3000];
    const scaled = (channel) => ({
      ...channel,
      axis: { ...channel.axis, values: ticks },
      scale: { ...channel.scale, type: "symlog", constant: 0.1 },
    });
    const points = ({ encoding, ...rest }) => ({
      ...rest,
      encoding: { ...encoding, x: scaled(encoding.x), y: scaled(encoding.y) },
    });
    const panel = (one) => ({ ...one, layer: one.layer.map(points) });
    return { ...spec, concat: spec.concat.map(panel) };
  }

  function scaleControl(figure, redraw) {
    const bar = document.createElement("p");
    bar.className = "controls";
    const label = document.createElement("label");
    const box = document.createElement("input");
    box.type = "checkbox";
    box.id = `${figure.id}-logarithmic`;
    label.append(box, " logarithmic scale, which shows the small tensions");
    bar.append(label);
    box.addEventListener("change", redraw);
    figure.prepend(bar);
    return box;
  }

  reeve.ready.then(() => {
    for (const figure of document.querySelectorAll("figure.chart")) {
      const spec = JSON.parse(figure.querySelector("script.spec").textContent);
      if (!spec?.usermeta?.greatest_px) continue;
      let drawn = "";
      const fit = () => {
        const shown = fitted(box?.checked ? logarithmic(spec) : spec, figure.clientWidth);
        const key = `${figure.clientWidth} ${box?.checked}`;
        if (figure.clientWidth === 0 || key === drawn) return;
        drawn = key;
        reeve.draw(figure, shown);
      };
      const box = figure.id === "compared" ? scaleControl(figure, fit) : null;
      new ResizeObserver(fit).observe(figure);
    }
  });
})();
