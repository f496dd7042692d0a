// Numbers and words as the page shows them. Full precision is kept everywhere else.

const FOUR_FIGURES = new Intl.NumberFormat("en-GB", {
  minimumSignificantDigits: 4,
  maximumSignificantDigits: 4,
  useGrouping: false,
});

/** Four significant figures, with a real minus sign. */
export function figures(value) {
  if (value === 0) return "0";
  return FOUR_FIGURES.format(value).replace("-", "−");
}

/** A number for an input field: up to `digits` significant figures, no trailing zeros. */
export function fieldNumber(value, digits = 5) {
  return String(Number(value.toPrecision(digits)));
}

/** "0.31 below 3P", with a unit after the number where one is given; nothing is known at rest. */
export function marginWords(margin, unit = "") {
  if (margin === undefined) return "–";
  const { nearest_harmonic: harmonic, margin_per_rev: distance } = margin;
  const size = Math.abs(distance);
  if (size < 5e-5) return `on ${harmonic}P`;
  const words = size < 0.01 ? size.toFixed(4) : size.toFixed(2);
  return `${words}${unit} ${distance < 0 ? "below" : "above"} ${harmonic}P`;
}

/** The place of a fault: "line 12: distribution.mass[3]". */
export function faultPlace(fault) {
  const parts = [];
  if (fault.line !== null) parts.push(`line ${fault.line}`);
  if (fault.path !== "") parts.push(fault.path);
  return parts.join(": ");
}

/** Offset in UTF-16 units of a line and column that count characters from 1. */
export function textOffset(text, line, column) {
  let offset = 0;
  for (let n = 1; n < line; n++) {
    const end = text.indexOf("\n", offset);
    if (end < 0) break;
    offset = end + 1;
  }
  for (let n = 1; n < column && offset < text.length && text[offset] !== "\n"; n++) {
    offset += text.codePointAt(offset) > 0xffff ? 2 : 1;
  }
  return offset;
}

/** TOML or JSON, by the first character that is not blank, as the package takes a text. */
export function textFormat(text) {
  return text.trimStart().startsWith("{") ? "json" : "toml";
}
