// How much of a mode's energy is in each motion, as a small bar of three colours.

import { element } from "../lib/dom.js";
import { sharesWords } from "../lib/format.js";

/** In the bar's own units. */
const [LENGTH, HEIGHT] = [100, 24];

/** Shows the shares in a cell; what is copied of it, and read out, are the words. */
export function showShares(cell, shares) {
  const words = sharesWords(shares);
  if (cell.dataset.full === words) return;
  cell.dataset.full = words;
  let from = 0;
  const parts = Object.entries(shares).map(([dof, share]) => {
    const width = LENGTH * Math.max(0, share); // the rounding of none may be below 0
    const part = element("rect", { x: from, y: 0, width, height: HEIGHT, "data-dof": dof });
    from += width;
    return part;
  });
  const bar = element("svg", { viewBox: `0 0 ${LENGTH} ${HEIGHT}`, preserveAspectRatio: "none", class: "shares", role: "img", "aria-label": words });
  bar.append(element("title", {}, words), ...parts);
  cell.replaceChildren(bar);
}
