// Faults of the stations: the cells they name, and the list below the sheet that leads there.

import { make } from "../lib/dom.js";
import { RADIUS, column } from "./columns.js";
import { COMMON, WHOLE, placeOf } from "./span.js";

/** Faults that the list shows. */
const MOST_LISTED = 50;

/** Faults of the distribution with their places; null where a fault names no cell. */
export function placedFaults({ doc, faults }) {
  return faults.filter(({ path }) => path.startsWith("distribution")).map((fault) => ({ ...fault, place: placeOf(doc, fault.path) }));
}

function words({ place, message }) {
  if (place === null) return message;
  const name = column(place.id).name;
  if (place.row === WHOLE) return `${name}: ${message}`;
  const own = place.sheet !== COMMON && place.id === RADIUS ? ` of the ${column(place.sheet).name}` : "";
  return `station ${place.row + 1}, ${name}${own}: ${message}`;
}

/** Fills the list; a click leads to the cell. */
export function listPlaced(list, count, faults, jump) {
  const shown = faults.slice(0, MOST_LISTED);
  list.replaceChildren(
    ...shown.map((fault) => {
      const button = make("button", { type: "button", textContent: words(fault), dataset: { path: fault.path } });
      button.addEventListener("click", () => jump(fault.place ?? { sheet: COMMON, row: WHOLE, id: RADIUS }));
      return make("li", {}, button);
    }),
  );
  list.hidden = faults.length === 0;
  const many = faults.length === 1 ? "1 fault" : `${faults.length} faults`;
  const said = faults.length === 0 ? "" : `${many}${faults.length > shown.length ? `; the first ${shown.length} are listed` : ""}`;
  if (count.textContent !== said) count.textContent = said;
}
