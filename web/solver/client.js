// Calls into the solver's worker: numbered requests, one at a time, the newest of each kind only,
// and a worker that hangs or breaks is replaced.

/** A request that takes longer than this is given up. */
const STUCK_MS = 20_000;
/** A running request that a newer one has made useless may run on this long. */
const SUPERSEDED_MS = 1_000;
/** Work shorter than this is not shown as such. */
const BUSY_MS = 150;

/** An answer in place of the package's: why there is none. */
export function stopped(message) {
  return { status: "error", faults: [{ code: "stopped", path: "", value: null, rule: "", message, line: null, column: null }] };
}

export class Client {
  #startWorker;
  #onBusy;
  #limits;
  #late;
  #worker = null;
  #ready = false;
  #failure = null;
  #waiting = [];
  #running = null;
  #lastId = 0;
  #stuckTimer;
  #busyTimer;

  /**
   * @param startWorker makes a new worker (a function, so that tests can hand in their own)
   * @param onBusy called with true when work takes a while, with false when it is over
   * @param late lanes whose running call still gets its answer when a newer one waits, so that
   *   results keep coming while inputs change faster than they are solved
   */
  constructor(startWorker, { onBusy = () => {}, stuckMs = STUCK_MS, supersededMs = SUPERSEDED_MS, late = [] } = {}) {
    this.#startWorker = startWorker;
    this.#onBusy = onBusy;
    this.#limits = { stuckMs, supersededMs };
    this.#late = late;
    this.#start();
  }

  /**
   * Calls an export of the wasm package. Of calls in the same lane only the newest counts: the
   * others resolve to null. A call resolves to the package's own tagged result.
   */
  call(lane, name, ...args) {
    return new Promise((resolve) => {
      if (this.#failure !== null) return resolve(stopped(this.#failure));
      this.#empty(lane);
      this.#waiting.push({ id: ++this.#lastId, lane, name, args, resolve });
      this.#busyTimer ??= setTimeout(() => this.#onBusy(true), BUSY_MS);
      if (this.#running?.lane === lane) this.#supersede(this.#running);
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

  /** The worker could not be loaded. */
  get failed() {
    return this.#failure !== null;
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
    worker.onmessage = ({ data }) => {
      if (worker === this.#worker) this.#receive(data);
    };
    worker.onerror = (event) => {
      event.preventDefault?.();
      if (worker !== this.#worker) return;
      const message = event.message || "the worker could not be started";
      this.#receive(this.#ready && this.#running ? { id: this.#running.id, crashed: message } : { failed: message });
    };
  }

  #replace() {
    this.#worker.terminate();
    this.#running = null;
    this.#start();
  }

  #receive(message) {
    if (message.ready) {
      this.#ready = true;
      this.#next();
      return;
    }
    if (message.failed !== undefined) {
      this.#fail(`the solver could not be loaded: ${message.failed}`);
      return;
    }
    const request = this.#running;
    if (request === null || message.id !== request.id) return;
    this.#finish();
    if (message.crashed !== undefined) {
      request.resolve(request.stale ? null : stopped(`the solver broke off: ${message.crashed}`));
      this.#replace(); // after a panic the old instance cannot be trusted
    } else {
      this.#running = null;
      request.resolve(request.dropped || (request.stale && !this.#late.includes(request.lane)) ? null : message.result);
    }
    this.#next();
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
    if (this.#waiting.length > 0) return;
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

  #fail(message) {
    this.#failure = message;
    const requests = this.#waiting.splice(0);
    if (this.#running !== null) requests.unshift(this.#running);
    this.#running = null;
    this.#finish();
    for (const request of requests) request.resolve(stopped(message));
  }
}
