// Measured points, or another code's: typed, pasted, opened or dropped as CSV, drawn and compared.

import { at, make } from "../lib/dom.js";
import { listFaults } from "../lib/faults.js";
import { fieldNumber, figures, percentWords } from "../lib/format.js";
import { labelAt } from "../lib/labels.js";
import { inUnit } from "./frame.js";

const LARGEST = 200_000;
const TYPING_MS = 300;
const COMPARE_MS = 150;

/** Points a little off this chart's branches, as an example of the columns. */
function example(fan) {
  const [first, last] = [0.5, 1].map((share) => Math.round(share * (fan.speeds_rad_s.length - 1)));
  const whole = fan.branches.filter((branch) => [first, last].every((i) => Number.isFinite(branch.frequency_rad_s[i])));
  const rows = whole.slice(0, 2).flatMap((branch, n) =>
    [first, last].map((i) => {
      const rpm = inUnit(fan.speeds_rad_s[i], 0, "rpm").toFixed(0);
      const hz = inUnit(branch.frequency_rad_s[i] * (n === 0 ? 1.02 : 0.97), 0, "Hz").toPrecision(4);
      return `${labelAt(branch, fan.speeds_rad_s[i])},${rpm},${Number(hz)},made up`;
    }),
  );
  return ["label,speed [rpm],frequency [Hz],source", ...rows, ""].join("\n");
}

/** Makes the disclosure. The state holds the last text without faults. */
export function startMeasured(store, client) {
  const text = make("textarea", {
    id: "measured-text",
    rows: 5,
    spellcheck: false,
    wrap: "off",
    placeholder: "label,speed [rpm],frequency [Hz],source\n1F,660,11.5,whirl test",
  });
  text.setAttribute("aria-describedby", "measured-note");
  const label = make("label", { htmlFor: "measured-text", textContent: "Points as CSV: label, speed, frequency, source" });
  const note = make("p", {
    id: "measured-note",
    className: "note",
    textContent: "Units stand in the header: speed in rpm, Hz or rad/s, frequency in Hz or rad/s. The points stay in this page.",
  });
  const paste = make("button", { type: "button", id: "measured-example", textContent: "Paste an example" });
  const open = make("button", { type: "button", id: "measured-open", textContent: "Open CSV…" });
  const clear = make("button", { type: "button", id: "measured-clear", textContent: "Clear" });
  const file = make("input", {
    type: "file",
    id: "measured-file",
    accept: ".csv,text/csv,text/plain",
    ariaLabel: "Measured points, CSV",
    hidden: true,
  });
  const faults = make("ul", { id: "measured-faults", className: "fault-list", ariaLabel: "Faults in the measured points", hidden: true });
  const body = document.createElement("tbody");
  const header = ["point", "speed", "measured", "computed", "error", "source"].map((name) =>
    Object.assign(make("th", { textContent: name }), { scope: "col" }),
  );
  const table = make("table", { id: "measured-table", hidden: true }, make("thead", {}, make("tr", {}, ...header)), body);
  const scroll = make("div", { className: "scroll", tabIndex: 0, role: "region", ariaLabel: "Measured points compared" }, table);
  const summary = make("summary", { textContent: "Measured points" });
  const details = make(
    "details",
    { id: "measured-details" },
    summary,
    label,
    text,
    make("div", { className: "measured-buttons" }, paste, open, clear),
    file,
    note,
    faults,
    scroll,
  );
  at("measured").append(details);

  let typing;
  let comparing;
  let sent = ""; // what the state has, or is about to get, of this textarea
  let points = []; // compared

  const complain = (message) => listFaults(faults, [{ line: null, path: "", message }]);

  async function take() {
    const given = text.value;
    if (given.length > LARGEST)
      return complain(`The text has ${Math.ceil(given.length / 1000)} kB; at most ${LARGEST / 1000} kB of points are taken.`);
    if (given.trim() === "") {
      sent = "";
      listFaults(faults, []);
      store.set({ measured: "" });
      return;
    }
    const result = await client.call("measured", "measured", given);
    if (result === null || text.value !== given) return;
    listFaults(faults, result.status === "ok" ? [] : result.faults);
    if (result.status !== "ok") return; // the last good points stay
    sent = given;
    store.set({ measured: given });
  }

  async function openFile(chosen) {
    if (!chosen) return;
    details.open = true;
    if (chosen.size > LARGEST)
      return complain(`${chosen.name} has ${Math.ceil(chosen.size / 1000)} kB; at most ${LARGEST / 1000} kB of points are taken.`);
    text.value = (await chosen.text()).replaceAll("\r\n", "\n");
    await take();
  }

  async function compare() {
    const { blade, measured, model, options } = store.get();
    if (blade === null || measured === "" || !details.open) return;
    const { modes, functions, basis } = options;
    const result = await client.call("compare", "compare", blade, measured, { model, modes, functions, basis });
    if (result?.status !== "ok" || store.get().measured !== measured) return;
    points = result.value;
    show();
  }

  function show() {
    const { measured, speedUnit, frequencyUnit } = store.get();
    const rows = measured === "" ? [] : points;
    table.hidden = rows.length === 0;
    summary.textContent = measured === "" ? "Measured points" : "Measured points: drawn on the chart";
    const unit = frequencyUnit === "per-rev" ? "/rev" : frequencyUnit;
    header[1].textContent = `speed [${speedUnit}]`;
    header[2].textContent = `measured [${unit}]`;
    header[3].textContent = `computed [${unit}]`;
    body.replaceChildren(
      ...rows.map((point) => {
        const speed = point.speed_rad_s;
        const frequency = (value) => (value === null || Number.isNaN(inUnit(value, speed, unit)) ? "–" : figures(inUnit(value, speed, unit)));
        const cells = [
          fieldNumber(inUnit(speed, 0, speedUnit)),
          frequency(point.frequency_rad_s),
          frequency(point.computed_rad_s),
          percentWords(point.error_percent),
          point.source,
        ];
        return make(
          "tr",
          {},
          Object.assign(make("th", { textContent: point.label }), { scope: "row" }),
          ...cells.map((textContent) => make("td", { textContent })),
        );
      }),
    );
  }

  text.addEventListener("input", () => {
    clearTimeout(typing);
    typing = setTimeout(take, TYPING_MS);
  });
  paste.addEventListener("click", () => {
    const { fan } = store.get();
    if (fan === null) return;
    text.value = example(fan);
    take();
  });
  clear.addEventListener("click", () => {
    text.value = "";
    take();
    text.focus();
  });
  open.addEventListener("click", () => file.click());
  file.addEventListener("change", async () => {
    await openFile(file.files[0]);
    file.value = ""; // the same file may be opened again
  });
  // A file dropped here is points, not a blade.
  const holdsFile = (event) => event.dataTransfer?.types.includes("Files");
  details.addEventListener("dragover", (event) => {
    if (!holdsFile(event)) return;
    event.preventDefault();
    event.stopPropagation();
    document.body.classList.remove("dropping");
    details.classList.add("dropping");
  });
  details.addEventListener("dragleave", () => details.classList.remove("dropping"));
  details.addEventListener("drop", (event) => {
    details.classList.remove("dropping");
    if (!holdsFile(event)) return;
    event.preventDefault();
    event.stopPropagation();
    openFile(event.dataTransfer.files[0]);
  });
  details.addEventListener("toggle", compare);

  store.subscribe((state, changed) => {
    const any = (...keys) => keys.some((key) => changed.has(key));
    if (any("measured") && state.measured !== sent) {
      // From a link or the last visit.
      sent = state.measured;
      text.value = state.measured;
      listFaults(faults, []);
      details.open ||= state.measured !== "";
    }
    if (any("measured", "speedUnit", "frequencyUnit")) show();
    if (any("measured", "blade", "model", "options") && details.open) {
      clearTimeout(comparing);
      comparing = setTimeout(compare, COMPARE_MS);
    }
  });
}
