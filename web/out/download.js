// Files for the user: chart, numbers, blade. Everything is made in the page.

import { cellText, percent } from "../lib/format.js";
import { shapeColumns } from "../lib/shape-columns.js";

/** Hands `content` (text or Blob) to the browser as a file. */
export function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** A file name from a blade's name and what the file holds: "tm-4760-research-blade-fan.svg". */
export function fileName(blade, what, extension) {
  const stem = blade
    .normalize("NFKD")
    .replace(/[^A-Za-z0-9]+/g, "-")
    .replace(/^-+|-+$/g, "")
    .toLowerCase()
    .slice(0, 60);
  return `${stem || "blade"}${what ? `-${what}` : ""}.${extension}`;
}

const quote = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** CSV of rows of numbers and texts, which no spreadsheet takes for formulas; null is an empty cell. Numbers keep every digit. */
export function csv(header, rows) {
  return [header, ...rows].map((row) => row.map((value) => quote(cellText(value))).join(",") + "\n").join("");
}

/** One row per rotor speed, one column per branch. */
export function fanCsv(fan) {
  const header = ["rotor speed [rad/s]", ...fan.branches.map((branch) => `${branch.label} [rad/s]`)];
  return csv(
    header,
    fan.speeds_rad_s.map((speed, i) => [speed, ...fan.branches.map((branch) => branch.frequency_rad_s[i])]),
  );
}

/** One row per radius; displacement, slope and moment of each mode, of a coupled one in each motion. */
export function shapesCsv(report) {
  const columns = report.shapes.flatMap((shape) =>
    shapeColumns(report).map(({ name, of }) => ({ name: `${shape.label} ${name}`, values: of(shape) })),
  );
  return csv(
    ["r [m]", ...columns.map(({ name }) => name)],
    report.r_m.map((r, i) => [r, ...columns.map(({ values }) => values[i])]),
  );
}

/** One row per mode, family and number of functions; the error is against the converged frequency. */
export function convergeCsv(report) {
  const rows = report.series.flatMap((series) =>
    [
      ["classical", report.functions, series.classical_rad_s],
      ["piecewise", series.piecewise_functions, series.piecewise_rad_s],
    ].flatMap(([family, counts, values]) =>
      counts.map((count, i) => [series.label, family, count, values[i], percent(values[i], series.converged_rad_s)]),
    ),
  );
  return csv(["mode", "family", "functions", "frequency [rad/s]", "error [%]"], rows);
}

/** The drawing as a PNG, `width` pixels wide. */
export async function png(drawing, width) {
  const scale = width / drawing.width;
  const image = new Image();
  const url = URL.createObjectURL(new Blob([drawing.svg], { type: "image/svg+xml" }));
  try {
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = Math.round(width);
    canvas.height = Math.round(drawing.height * scale);
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the picture could not be made"))), "image/png");
    });
  } finally {
    URL.revokeObjectURL(url);
  }
}
