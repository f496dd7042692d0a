// The drawing, and what the page lays over it: the line of the rotor speed.

const SVG = "http://www.w3.org/2000/svg";

function parse(text) {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
  const root = parsed.documentElement;
  if (root.localName !== "svg" || root.namespaceURI !== SVG || parsed.querySelector("parsererror") !== null) {
    throw new Error("the drawing is not an SVG");
  }
  return document.importNode(root, true);
}

function element(name, attributes) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

/**
 * Puts a drawing of `chart_svg` in its place; `title` is what a screen reader says of it. A `crop`
 * ({above, below} the first frame) leaves out the drawing's own title and notes.
 */
export function place(host, drawing, title, crop) {
  const svg = parse(drawing.svg);
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", title);
  svg.removeAttribute("width");
  svg.removeAttribute("height");
  let { height } = drawing;
  if (crop) {
    const frame = drawing.plots[0];
    height = crop.above + frame.height + crop.below;
    svg.setAttribute("viewBox", `0 ${frame.top - crop.above} ${drawing.width} ${height}`);
  }
  host.style.aspectRatio = `${drawing.width} / ${height}`;
  host.style.maxWidth = `${drawing.width}px`;
  host.replaceChildren(svg);
}

export class Chart {
  #host;
  #onSpeed;
  #overlay = null;
  #plot = null;

  /** `onSpeed` hears of speeds chosen on the fan chart, in the unit of its axis. */
  constructor(host, onSpeed) {
    this.#host = host;
    this.#onSpeed = onSpeed;
    host.addEventListener("pointerdown", (event) => {
      if (this.#plot === null || event.button !== 0 || !this.#choose(event, false)) return;
      host.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    host.addEventListener("pointermove", (event) => {
      if (host.hasPointerCapture(event.pointerId)) this.#choose(event, true);
    });
  }

  /** Shows a drawing of `chart_svg`; `title` is what a screen reader says of it. */
  show(drawing, title, isFan) {
    place(this.#host, drawing, title);
    this.#host.classList.toggle("draggable", isFan);
    this.#plot = isFan ? drawing.plots[0] : null;
    this.#overlay = null;
    if (!isFan) return;
    this.#overlay = element("svg", { viewBox: `0 0 ${drawing.width} ${drawing.height}`, class: "overlay", "aria-hidden": "true" });
    this.#host.append(this.#overlay);
  }

  /** Draws the line at a rotor speed, with a dot per frequency; both in the units of the axes. */
  mark(speed, frequencies) {
    const plot = this.#plot;
    if (this.#overlay === null || plot === null) return;
    const along = (value, { from, to }) => (value - from) / (to - from);
    const at = along(speed, plot.x);
    if (!(at >= 0 && at <= 1)) {
      this.#overlay.replaceChildren();
      return;
    }
    const x = plot.left + at * plot.width;
    const dots = frequencies
      .map(({ dof, value }) => ({ dof, up: along(value, plot.y) }))
      .filter(({ up }) => up >= 0 && up <= 1)
      .map(({ dof, up }) => element("circle", { cx: x, cy: plot.top + (1 - up) * plot.height, r: 4, "data-dof": dof }));
    this.#overlay.replaceChildren(element("line", { x1: x, x2: x, y1: plot.top, y2: plot.top + plot.height }), ...dots);
  }

  #choose(event, outside) {
    const box = this.#host.getBoundingClientRect();
    const scale = this.#overlay.viewBox.baseVal.width / box.width;
    const plot = this.#plot;
    const at = ((event.clientX - box.left) * scale - plot.left) / plot.width;
    if (!outside && (at < -0.02 || at > 1.02)) return false;
    const { from, to } = plot.x;
    this.#onSpeed(from + Math.min(1, Math.max(0, at)) * (to - from));
    return true;
  }
}
