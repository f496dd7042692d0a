// Calls into the solver's worker: numbered requests, one at a time, the newest of each kind only,
// and a worker that hangs or breaks is replaced. Where none can be started, what was asked waits for
// another try.

/** A worker that is not ready after this has most likely lost its connection. */
const START_MS = 40_000;
/** A request that takes longer than this is given up. */
const STUCK_MS = 20_000;
/** A running request that a newer one has made useless may run on this long: a fan chart of a coupled blade comes still. */
const SUPERSEDED_MS = 3_000;
/** Work shorter than this is not shown as such. */
const BUSY_MS = 150;

/** An answer in place of the package's: why there is none. */
function stopped(message) {
  return { status: "error", faults: [{ code: "stopped", path: "", value: null, rule: "", message, line: null, column: null }] };
}

const text = (error) => (error instanceof Error ? error.message : String(error));

export class Client {
  #startWorker;
  #onBusy;
  #onTrouble;
  #limits;
  #late;
  #worker = null;
  #ready = false;
  #failed = false;
  /** Whether the worker was started in place of one that died before it was ready. */
  #second = false;
  #waiting = [];
  #running = null;
  #lastId = 0;
  #startTimer;
  #stuckTimer;
  #busyTimer;

  /**
   * @param {() => Pick<Worker, "postMessage" | "terminate" | "onmessage" | "onerror">} startWorker makes a new worker (a function, so that tests can hand in their own)
   * @param {object} options
   * @param {(busy: boolean) => void} [options.onBusy] called with true when work takes a while, with false when it is over
   * @param {(words: string | null) => void} [options.onTrouble] called with words for the user when no worker could be started, with null when it is tried again
   * @param {number} [options.startMs] most time for a worker to become ready
   * @param {number} [options.stuckMs] most time for an answer
   * @param {number} [options.supersededMs] most time for an answer that nobody wants any more
   * @param {string[]} [options.late] lanes whose running call still gets its answer when a newer one waits, so that
   *   results keep coming while inputs change faster than they are solved
   */
  constructor(
    startWorker,
    { onBusy = () => {}, onTrouble = () => {}, startMs = START_MS, stuckMs = STUCK_MS, supersededMs = SUPERSEDED_MS, late = [] } = {},
  ) {
    this.#startWorker = startWorker;
    this.#onBusy = onBusy;
    this.#onTrouble = onTrouble;
    this.#limits = { startMs, stuckMs, supersededMs };
    this.#late = late;
    this.#start();
  }

  /**
   * Calls an export of the wasm package. Of calls in the same lane only the newest counts: the
   * others resolve to null. A call resolves to the package's own tagged result, once there is a worker.
   */
  call(lane, name, ...args) {
    return new Promise((resolve) => {
      this.#empty(lane);
      this.#waiting.push({ id: ++this.#lastId, lane, name, args, resolve });
      this.#busyTimer ??= setTimeout(() => this.#onBusy(true), BUSY_MS);
      if (this.#running?.lane === lane) this.#supersede(this.#running);
      this.again();
      this.#next();
    });
  }

  /** Calls of a lane are no longer wanted, and there is no newer one. */
  drop(lane) {
    this.#empty(lane);
    if (this.#running === null) this.#finish();
    if (this.#running?.lane !== lane) return;
    this.#running.dropped = true;
    this.#supersede(this.#running);
  }

  /** Tries again where no worker could be started. */
  again() {
    if (!this.#failed) return;
    this.#failed = false;
    this.#onTrouble(null);
    if (this.#waiting.length > 0) this.#busyTimer ??= setTimeout(() => this.#onBusy(true), BUSY_MS);
    this.#start();
  }

  #empty(lane) {
    this.#waiting = this.#waiting.filter((request) => {
      if (request.lane === lane) request.resolve(null);
      return request.lane !== lane;
    });
  }

  #start() {
    this.#ready = false;
    const worker = this.#startWorker();
    this.#worker = worker;
    const { startMs } = this.#limits;
    clearTimeout(this.#startTimer);
    this.#startTimer = setTimeout(() => this.#fail(`it did not start within ${startMs / 1000} seconds`), startMs);
    worker.onmessage = ({ data }) => {
      if (worker === this.#worker) this.#receive(data);
    };
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (worker === this.#worker) this.#died(event.message || "the worker could not be started");
    };
  }

  #replace() {
    this.#worker.terminate();
    this.#running = null;
    this.#start();
  }

  #receive(message) {
    if (message.ready) {
      clearTimeout(this.#startTimer);
      this.#ready = true;
      this.#second = false;
      this.#next();
      return;
    }
    if (message.failed !== undefined) {
      this.#fail(message.failed);
      return;
    }
    const request = this.#running;
    if (request === null || message.id !== request.id) return;
    if (message.crashed !== undefined) {
      this.#died(message.crashed);
      return;
    }
    this.#running = null;
    this.#finish();
    request.resolve(request.dropped || (request.stale && !this.#late.includes(request.lane)) ? null : message.result);
    this.#next();
  }

  /** The worker is started anew, once without a word; after a panic the old one cannot be trusted. */
  #died(why) {
    if (!this.#ready) {
      if (this.#second) return this.#fail(why);
      this.#second = true;
      return this.#replace();
    }
    const request = this.#running;
    if (request !== null) {
      clearTimeout(this.#stuckTimer);
      if (request.stale) request.resolve(null);
      else if (request.again) request.resolve(stopped(`the solver broke off: ${why}`));
      else this.#waiting.unshift(Object.assign(request, { again: true }));
    }
    this.#replace();
    this.#finish();
  }

  #next() {
    if (!this.#ready || this.#running !== null || this.#waiting.length === 0) return;
    const request = this.#waiting.shift();
    this.#running = request;
    request.started = performance.now();
    this.#stuckTimer = setTimeout(() => this.#giveUp(request), this.#limits.stuckMs);
    this.#worker.postMessage({ id: request.id, name: request.name, args: request.args });
  }

  #finish() {
    clearTimeout(this.#stuckTimer);
    if (this.#waiting.length > 0 && !this.#failed) return;
    clearTimeout(this.#busyTimer);
    this.#busyTimer = undefined;
    this.#onBusy(false);
  }

  /** The running request's answer is no longer wanted; a slow one is not waited for. */
  #supersede(request) {
    request.stale = true;
    clearTimeout(this.#stuckTimer);
    const ran = performance.now() - request.started;
    this.#stuckTimer = setTimeout(() => this.#giveUp(request), Math.max(0, this.#limits.supersededMs - ran));
  }

  #giveUp(request) {
    if (this.#running !== request) return;
    this.#finish();
    const seconds = this.#limits.stuckMs / 1000;
    request.resolve(request.stale ? null : stopped(`no answer within ${seconds} seconds; the solver was started anew`));
    this.#replace();
  }

  /** No worker could be started: what waits, waits for another try. */
  #fail(why) {
    clearTimeout(this.#startTimer);
    this.#worker.terminate();
    this.#failed = true;
    this.#second = false;
    this.#finish();
    this.#onTrouble(`the solver could not be loaded: ${text(why)}`);
  }
}

/**
 * A worker made by `make`, which gets the module that `module` promises. A module that does not come is
 * told as if the worker had said so.
 */
export function withModule(make, module) {
  const worker = make();
  module().then(
    (compiled) => worker.postMessage({ module: compiled }),
    (error) => worker.onmessage?.({ data: { failed: text(error) } }),
  );
  return worker;
}
