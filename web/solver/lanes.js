// The lanes of work, and the solver in two workers that they lead to: one for what follows the sliders, fan
// charts and frequencies, and one for all else, started when that is asked for. Neither its start nor its
// work holds up a chart.

import { Client } from "./client.js";

/** Lanes of what nobody waits for, though it is of modes: a coupled blade would hold up the sliders. */
const UNHURRIED = ["sensitivity"];

/** @type {(lane: string, name: string, args: unknown[]) => boolean} */
const isFanWork = (lane, name, [kind]) =>
  !UNHURRIED.includes(lane) && (["modes", "fan", "at_speed"].includes(name) || (name === "chart_svg" && kind === "fan"));

export class Solver {
  #fan;
  #other = null;
  #makeClient;
  #busy = new Set();
  #troubles = new Map();

  /**
   * `startWorker` makes a worker; the options are those of a client.
   * @param {ConstructorParameters<typeof Client>[0]} startWorker
   * @param {ConstructorParameters<typeof Client>[1]} [options]
   */
  constructor(startWorker, { onBusy = () => {}, onTrouble = () => {}, ...options } = {}) {
    this.#makeClient = (who) =>
      new Client(startWorker, {
        ...options,
        onBusy: (busy) => onBusy(this.#count(who, busy)),
        onTrouble: (words) => onTrouble(this.#worst(who, words)),
      });
    this.#fan = this.#makeClient("fan");
  }

  /** As `Client.call`: of calls in the same lane only the newest counts, whichever worker it is for. */
  call(lane, name, ...args) {
    if (isFanWork(lane, name, args)) {
      this.#other?.drop(lane);
      return this.#fan.call(lane, name, ...args);
    }
    this.#fan.drop(lane);
    this.#other ??= this.#makeClient("other");
    return this.#other.call(lane, name, ...args);
  }

  /** Calls of a lane are no longer wanted, and there is no newer one. */
  drop(lane) {
    this.#fan.drop(lane);
    this.#other?.drop(lane);
  }

  /** Tries again to start what could not be started; what was asked of it is still waiting. */
  again() {
    this.#fan.again();
    this.#other?.again();
  }

  #count(who, busy) {
    if (busy) this.#busy.add(who);
    else this.#busy.delete(who);
    return this.#busy.size > 0;
  }

  /** What keeps one of the workers from its work, in words; null where nothing does. */
  #worst(who, words) {
    this.#troubles.set(who, words);
    return [...this.#troubles.values()].find((trouble) => trouble !== null) ?? null;
  }
}
