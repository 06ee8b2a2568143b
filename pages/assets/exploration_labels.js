"use strict";

// Labels beside the marks of a plot: none over another, over a mark that has one, or beyond the
// frame; each nearer to its own mark than to another that has one, or further off with a line to its
// own; and over as few other marks as can be. The first are placed first, and one for which there is no room is left out; its mark says
// the same to who points at it.
const explorationLabels = (() => {
  const letter = 7; // px, of a bold letter
  const line = 14;
  const mark = 11; // px, of the ring about a mark
  const one = 8; // px: marks no farther apart are one to the eye
  const clearly = 2; // px
  // Beside the mark, then further off, with a line to it.
  const sides = [9, 25, 41].flatMap((off, i) => [
    { dx: off + 5, dy: 0, align: "left" },
    { dx: -off - 5, dy: 0, align: "right" },
    { dx: 11, dy: -off, align: "left" },
    { dx: -11, dy: -off, align: "right" },
    { dx: 11, dy: off + 3, align: "left" },
    { dx: -11, dy: off + 3, align: "right" },
    { dx: 0, dy: -off - 9, align: "center" },
    { dx: 0, dy: off + 12, align: "center" },
    { dx: 3, dy: off + 12, align: "right" },
    { dx: -3, dy: off + 12, align: "left" },
    { dx: 3, dy: -off - 9, align: "right" },
    { dx: -3, dy: -off - 9, align: "left" },
  ].map((side) => ({ ...side, far: i > 0 })));

  // dy is where the text's middle lies.
  function box({ x, y, text }, { dx, dy, align }) {
    const width = letter * text.length;
    const left = x + dx - { left: 0, center: width / 2, right: width }[align];
    return { left, right: left + width, top: y + dy - line / 2, bottom: y + dy + line / 2 };
  }

  const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
  const within = (a, { width, height }) => a.left >= 0 && a.right <= width && a.top >= 0 && a.bottom <= height;

  const clear = ({ left, right, top, bottom }, { x, y }) =>
    right <= x - mark || x + mark <= left || bottom <= y - mark || y + mark <= top;

  const covers = ({ left, right, top, bottom }, { x, y }) => left - 3 < x && x < right + 3 && top - 3 < y && y < bottom + 3;

  const clamped = (value, low, high) => Math.min(Math.max(value, low), high);
  // The point of a box that is nearest to a spot.
  const nearest = ({ left, right, top, bottom }, { x, y }) => [clamped(x, left, right), clamped(y, top, bottom)];
  const distance = (own, spot) => {
    const [x, y] = nearest(own, spot);
    return Math.hypot(x - spot.x, y - spot.y);
  };

  // Spots that are one to the eye have one label; `texts` are what it says, the first in any case.
  function merged(wanted) {
    const spots = [];
    for (const label of wanted) {
      const same = spots.find(({ x, y }) => Math.hypot(x - label.x, y - label.y) <= one);
      if (same) same.texts.push(label.text);
      else spots.push({ ...label, texts: [label.text] });
    }
    return spots;
  }

  // A line from the ring to a label that is far off; of no length where it is not.
  function leader(spot, own, far) {
    const [x, y] = nearest(own, spot);
    const share = far && !spot.beyond ? mark / distance(own, spot) : 1;
    return { from: [spot.x + share * (x - spot.x), spot.y + share * (y - spot.y)], to: [x, y] };
  }

  // True if the line from a spot to its label passes by another spot.
  function passes(spot, own, other) {
    const { from: [x, y], to: [toX, toY] } = leader(spot, own, true);
    const [right, down] = [toX - x, toY - y];
    const along = clamped(((other.x - x) * right + (other.y - y) * down) / (right * right + down * down), 0, 1);
    return Math.hypot(x + along * right - other.x, y + along * down - other.y) < mark - clearly;
  }

  // wanted: [{x, y, text, beyond}], marks: [{x, y}], in pixels of a frame of that width and height;
  // `beyond`: an arrow to where the mark is, which the frame does not show. Gives those that have a
  // place, with text, dx, dy, align and leader.
  function place(wanted, frame, marks = []) {
    const taken = [];
    const spots = merged(wanted);
    const rings = spots.filter(({ beyond }) => !beyond);
    const isToldApart = ({ own, far }, spot) => rings.every((other) => other === spot ||
      (far ? !passes(spot, own, other) : distance(own, other) > distance(own, spot) + clearly));
    const fits = (side, spot) =>
      within(side.own, frame) && rings.every((other) => clear(side.own, other)) &&
      taken.every((other) => apart(side.own, other)) && (spot.beyond || isToldApart(side, spot));
    const best = (spot, text) =>
      sides.map((side) => ({ ...side, text, own: box({ ...spot, text }, side) }))
        .filter((side) => fits(side, spot))
        .map((side) => ({ ...side, covered: marks.filter((each) => covers(side.own, each)).length }))
        .reduce((least, side) => (least && least.covered <= side.covered ? least : side), null);
    return spots.flatMap(({ texts, ...spot }, i) => {
      const [whole, first] = [texts.join(", "), texts[0]].map((text) => (spot.beyond ? `${spot.beyond} ${text}` : text));
      const chosen = best(spots[i], whole) ?? best(spots[i], first);
      if (!chosen) return [];
      const { text, dx, dy, align, own, far } = chosen;
      taken.push(own);
      return [{ ...spot, text, dx, dy, align, leader: leader(spot, own, far) }];
    });
  }

  return { place };
})();
