// The lanes of work, and the solver in two workers that they lead to: one with the small module, for the first chart and the sliders, and one with
// the whole, started when something else is asked for. Neither its loading nor its work holds up a chart.

import { Client } from "./client.js";

/** What the small module answers, beside fan charts without measured points. */
const SMALL = ["modes", "fan"];

function isSmall(name, [kind, , options]) {
  return SMALL.includes(name) || (name === "chart_svg" && kind === "fan" && (options?.measured ?? null) === null);
}

export class Solver {
  #startWorker;
  #options;
  #small;
  #whole = null;
  #busy = new Set();

  /** `startWorker(whole)` makes a worker; the options are those of a client. */
  constructor(startWorker, { onBusy = () => {}, ...options } = {}) {
    this.#startWorker = startWorker;
    this.#options = (who) => ({ ...options, onBusy: (busy) => onBusy(this.#count(who, busy)) });
    this.#small = new Client(() => startWorker(false), this.#options("small"));
  }

  /** As `Client.call`: of calls in the same lane only the newest counts, whichever worker it is for. */
  call(lane, name, ...args) {
    const small = isSmall(name, args);
    if (!small && (this.#whole?.failed ?? true)) this.#whole = new Client(() => this.#startWorker(true), this.#options("whole"));
    (small ? this.#whole : this.#small)?.drop(lane);
    return (small ? this.#small : this.#whole).call(lane, name, ...args);
  }

  /** Calls of a lane are no longer wanted, and there is no newer one. */
  drop(lane) {
    this.#small.drop(lane);
    this.#whole?.drop(lane);
  }

  #count(who, busy) {
    if (busy) this.#busy.add(who);
    else this.#busy.delete(who);
    return this.#busy.size > 0;
  }
}
