"use strict";

// Labels beside the marks of a plot: none over another, over a mark that has one, or beyond the
// frame. The first are placed first, and one for which there is no room is left out; its mark says
// the same to who points at it.
const explorationLabels = (() => {
  const letter = 7; // px, of a bold letter
  const line = 14;
  const mark = 11; // px, of the ring about a mark
  // Beside the mark, then further off.
  const sides = [9, 25, 41].flatMap((off) => [
    { dx: 11, dy: -off, align: "left" },
    { dx: -11, dy: -off, align: "right" },
    { dx: 11, dy: off + 3, align: "left" },
    { dx: -11, dy: off + 3, align: "right" },
    { dx: 0, dy: -off - 9, align: "center" },
    { dx: 0, dy: off + 12, align: "center" },
  ]);

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

  // wanted: [{x, y, text}], in pixels of a frame of that width and height. Gives those that have a
  // place, with dx, dy and align.
  function place(wanted, frame) {
    const taken = [];
    return wanted.flatMap((label) => {
      const side = sides.find((each) => {
        const own = box(label, each);
        return within(own, frame) && wanted.every((spot) => clear(own, spot)) &&
          taken.every((other) => apart(own, other));
      });
      if (!side) return [];
      taken.push(box(label, side));
      return [{ ...label, ...side }];
    });
  }

  return { place };
})();
