// The drawing, and what the page lays over it: layers in the drawing's own pixels, and handles.

import { element } from "../lib/dom.js";
import { fieldNumber } from "../lib/format.js";
import { Frame } from "./frame.js";
import { Drawing } from "./patch.js";

/** In the order of painting. */
const LAYERS = ["before", "edges", "mark", "hover", "box"];
/** A finger that has moved this far drags. */
const SLACK = 4;

/** The drawing is as wide as its place, and one picture to a screen reader. */
function fit(svg, title) {
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", title);
  svg.removeAttribute("width");
  svg.removeAttribute("height");
}

export class Chart {
  host;
  /** The frame of the fan chart that is drawn; null while another chart is. */
  frame = null;
  layers;
  #onSpeed;
  #overlay;
  #clip = element("rect", {});
  #size = "";
  #drawing = null;
  #listeners = [];
  #takers = [];
  #drag = null;
  #speed = null;
  #handle;

  /** `onSpeed` hears of speeds chosen on the fan chart, in the unit of its axis. */
  constructor(host, onSpeed) {
    this.host = host;
    this.#onSpeed = onSpeed;
    this.#overlay = element("svg", { class: "overlay", "aria-hidden": "true" });
    const clip = element("clipPath", { id: "chart-frame" });
    clip.append(this.#clip);
    this.layers = Object.fromEntries(LAYERS.map((name) => [name, element("g", { class: name })]));
    this.layers.before.setAttribute("clip-path", "url(#chart-frame)");
    this.#overlay.append(clip, ...Object.values(this.layers));
    this.#handle = this.handle("speed-handle", "Rotor speed on the chart", {
      drag: (point) => this.#choose(point),
      step: (steps) => this.#onSpeed(this.frame.shown(this.#speed) + steps * this.#step()),
      end: (first) => this.#onSpeed(this.frame.shown(this.frame.speeds[first ? 0 : 1])),
    });
    this.#listen();
  }

  /** Shows a drawing of `chart_svg`; `title` is what a screen reader says of it, `words` what it says of the place. */
  show(drawing, { title, words, isFan }) {
    this.#draw(drawing.svg, title);
    this.#describe(words, isFan);
    const size = `${drawing.width} ${drawing.height}`;
    if (size !== this.#size) {
      this.#size = size;
      this.host.style.aspectRatio = `${drawing.width} / ${drawing.height}`;
      this.host.style.maxWidth = `${drawing.width}px`;
      this.#overlay.setAttribute("viewBox", `0 0 ${size}`);
    }
    this.host.classList.toggle("draggable", isFan);
    this.frame = isFan ? new Frame(drawing) : null;
    this.#overlay.classList.toggle("off", !isFan);
    if (isFan) {
      const { left, top, width, height } = this.frame.plot;
      for (const [key, value] of Object.entries({ x: left, y: top, width, height })) this.#clip.setAttribute(key, value);
    }
    this.mark(this.#speed);
    for (const listener of this.#listeners) listener(this.frame);
  }

  #draw(text, title) {
    if (!this.#drawing?.become(text)) {
      const old = this.#drawing?.root;
      this.#drawing = new Drawing(text);
      if (old) old.replaceWith(this.#drawing.root);
      else this.host.prepend(this.#drawing.root, this.#overlay);
    }
    fit(this.#drawing.root, title);
  }

  #describe(words, isFan) {
    const said = isFan ? `${words} Arrow keys read the branches.` : words;
    if (this.host.getAttribute("aria-label") === said) return;
    // An application gets the arrow keys from screen readers.
    this.host.setAttribute("role", isFan ? "application" : "group");
    this.host.setAttribute("aria-label", said);
    if (isFan) this.host.tabIndex = 0;
    else this.host.removeAttribute("tabindex");
  }

  /** Hears of every new drawing: its frame, null where it is no fan chart. */
  onShow(listener) {
    this.#listeners.push(listener);
  }

  /** `taker(point, event)` may answer a press on the chart with what follows it: {move, end, cancel}. */
  onPress(taker) {
    this.#takers.push(taker);
  }

  /** Draws the line at a rotor speed [rad/s], with a dot on each branch. */
  mark(speed) {
    this.#speed = speed;
    const { frame } = this;
    const [from, to] = frame?.speeds ?? [];
    const seen = frame !== null && speed !== null && speed >= from * (1 - 1e-9) && speed <= to * (1 + 1e-9);
    this.#handle.hidden = !seen;
    if (!seen) {
      this.layers.mark.replaceChildren();
      return;
    }
    const x = frame.x(speed);
    const dots = frame.points(speed).map(({ dof, y }) => element("circle", { cx: x, cy: y, r: 4, "data-dof": dof }));
    this.layers.mark.replaceChildren(element("line", { x1: x, x2: x, y1: frame.top, y2: frame.bottom }), ...dots);
    this.put(this.#handle, x, frame.bottom);
    this.value(this.#handle, {
      from: frame.shown(from),
      to: frame.shown(to),
      now: frame.shown(speed),
      words: `${fieldNumber(frame.shown(speed))} ${frame.speedUnit}`,
    });
  }

  /** Puts an element at a place of the drawing, in its pixels. */
  put(item, x, y) {
    item.style.left = `${(100 * x) / this.frame.width}%`;
    item.style.top = `${(100 * y) / this.frame.height}%`;
  }

  /** What a slider says of its value. */
  value(item, { from, to, now, words }) {
    item.setAttribute("aria-valuemin", fieldNumber(from));
    item.setAttribute("aria-valuemax", fieldNumber(to));
    item.setAttribute("aria-valuenow", fieldNumber(now));
    item.setAttribute("aria-valuetext", words);
  }

  /** A handle on the chart that is dragged, or moved by keys: `drag(point)`, `step(count)`, `end(isFirst)`. */
  handle(className, label, { drag, step, end }) {
    const item = document.createElement("div");
    item.className = `handle ${className}`;
    Object.assign(item, { tabIndex: 0, role: "slider", ariaLabel: label, hidden: true });
    item.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      event.stopPropagation();
      item.setPointerCapture(event.pointerId);
      item.focus({ preventScroll: true });
      item.classList.add("dragging");
    });
    item.addEventListener("pointermove", (event) => {
      if (!item.hasPointerCapture(event.pointerId)) return;
      event.stopPropagation();
      drag(this.point(event));
    });
    item.addEventListener("lostpointercapture", () => item.classList.remove("dragging"));
    item.addEventListener("keydown", (event) => {
      const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (steps) step(event.shiftKey && Math.abs(steps) === 1 ? 10 * steps : steps);
      else if (event.key === "Home" || event.key === "End") end(event.key === "Home");
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    this.host.append(item);
    return item;
  }

  /** Where an event is, in the drawing's pixels. */
  point(event) {
    const box = this.host.getBoundingClientRect();
    const scale = this.frame.width / box.width;
    return { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
  }

  #listen() {
    const { host } = this;
    // What takes presses first: tools, then the line of the speed.
    const press = (point, event) => {
      for (const taker of this.#takers) {
        const drag = taker(point, event);
        if (drag) return drag;
      }
      if (!this.frame.holds(point, 0.02 * this.frame.plot.width)) return null;
      // A finger may be about to scroll: it chooses once it moves sideways, or is lifted.
      if (event.pointerType !== "touch") this.#choose(point);
      const still = ({ x }) => event.pointerType === "touch" && Math.abs(x - point.x) < SLACK;
      return { move: (to) => still(to) || this.#choose(to), end: (to) => event.pointerType === "touch" && this.#choose(to) };
    };
    host.addEventListener("pointerdown", (event) => {
      if (this.frame === null || event.button !== 0) return;
      const drag = press(this.point(event), event);
      if (!drag) return;
      this.#drag?.cancel?.();
      this.#drag = { ...drag, id: event.pointerId };
      host.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    host.addEventListener("pointermove", (event) => {
      if (this.#drag?.id === event.pointerId && this.frame !== null) this.#drag.move?.(this.point(event), event);
    });
    const finish = (event) => {
      const drag = this.#drag;
      if (drag?.id !== event.pointerId) return;
      this.#drag = null;
      if (event.type === "pointerup" && this.frame !== null) drag.end?.(this.point(event), event);
      else drag.cancel?.();
    };
    host.addEventListener("pointerup", finish);
    host.addEventListener("pointercancel", finish);
  }

  /** A step of the keys: one part in two hundred of the axis, rounded down to a round number. */
  #step() {
    const { from, to } = this.frame.plot.x;
    const power = 10 ** Math.floor(Math.log10((to - from) / 200));
    return [5, 2, 1].map((n) => n * power).find((step) => (to - from) / step >= 200) ?? power;
  }

  #choose({ x }) {
    this.#onSpeed(this.frame.shown(this.frame.speed(x)));
  }
}
