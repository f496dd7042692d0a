// The worker's protocol, with workers of our own in place of real ones.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { callChanged } from "../../web/solver/changed.js";
import { Client } from "../../web/solver/client.js";
import { Solver } from "../../web/solver/lanes.js";

/** A worker that answers when told to. */
class FakeWorker {
  static all = [];
  sent = [];
  terminated = false;
  constructor() {
    FakeWorker.all.push(this);
  }
  postMessage(message) {
    this.sent.push(message);
  }
  terminate() {
    this.terminated = true;
  }
  say(data) {
    this.onmessage({ data });
  }
  answer(result) {
    this.say({ id: this.sent.at(-1).id, result });
  }
}

function setUp(limits) {
  FakeWorker.all = [];
  const busy = [];
  const client = new Client(() => new FakeWorker(), { onBusy: (on) => busy.push(on), ...limits });
  FakeWorker.all[0].say({ ready: true });
  return { client, busy, worker: FakeWorker.all[0], workers: FakeWorker.all };
}

test("a call is sent and resolves to its answer", async () => {
  const { client, worker } = setUp();
  const answer = client.call("modes", "modes", { name: "x" }, { speed: 1 });
  assert.deepEqual(worker.sent, [{ id: 1, name: "modes", args: [{ name: "x" }, { speed: 1 }] }]);
  worker.answer({ status: "ok" });
  assert.deepEqual(await answer, { status: "ok" });
});

test("nothing is sent before the worker is ready", () => {
  FakeWorker.all = [];
  const client = new Client(() => new FakeWorker());
  client.call("a", "a");
  assert.equal(FakeWorker.all[0].sent.length, 0);
  FakeWorker.all[0].say({ ready: true });
  assert.equal(FakeWorker.all[0].sent.length, 1);
  FakeWorker.all[0].answer(null);
});

test("of waiting calls in a lane only the newest is sent, and a superseded answer is dropped", async () => {
  const { client, worker } = setUp();
  const first = client.call("modes", "modes", 1);
  const second = client.call("modes", "modes", 2);
  const third = client.call("modes", "modes", 3);
  assert.equal(await second, null);
  worker.answer("stale");
  assert.equal(await first, null);
  assert.deepEqual(worker.sent.map((message) => message.args[0]), [1, 3]);
  worker.answer("fresh");
  assert.equal(await third, "fresh");
});

test("calls of other lanes all run, one at a time, in order", async () => {
  const { client, worker } = setUp();
  const answers = ["fan", "modes", "draw"].map((lane) => client.call(lane, lane));
  for (const lane of ["fan", "modes", "draw"]) {
    assert.equal(worker.sent.at(-1).name, lane);
    worker.answer(lane);
  }
  assert.deepEqual(await Promise.all(answers), ["fan", "modes", "draw"]);
});

test("a worker that does not answer is replaced and the next call still runs", async () => {
  const { client, workers } = setUp({ stuckMs: 30 });
  const stuck = client.call("fan", "fan");
  const next = client.call("modes", "modes");
  const given = await stuck;
  assert.equal(given.status, "error");
  assert.match(given.faults[0].message, /no answer within/);
  assert.equal(workers[0].terminated, true);
  workers[1].say({ ready: true });
  workers[1].answer("done");
  assert.equal(await next, "done");
});

test("a long run that a newer call has made useless is cut short", async () => {
  const { client, workers } = setUp({ stuckMs: 10_000, supersededMs: 20 });
  const old = client.call("fan", "fan", "old");
  const fresh = client.call("fan", "fan", "new");
  assert.equal(await old, null);
  assert.equal(workers.length, 2);
  workers[1].say({ ready: true });
  assert.equal(workers[1].sent[0].args[0], "new");
  workers[1].answer("done");
  assert.equal(await fresh, "done");
});

test("a late answer of a replaced worker is not heard", async () => {
  const { client, workers } = setUp({ stuckMs: 20 });
  const stuck = client.call("fan", "fan");
  await stuck;
  workers[1].say({ ready: true });
  const next = client.call("fan", "fan");
  workers[0].say({ id: 2, result: "from the dead" });
  workers[1].answer("alive");
  assert.equal(await next, "alive");
});

test("after a crash the worker is replaced and the reason is given", async () => {
  const { client, worker, workers } = setUp();
  const broken = client.call("fan", "fan");
  worker.say({ id: 1, crashed: "unreachable" });
  assert.match((await broken).faults[0].message, /unreachable/);
  assert.equal(worker.terminated, true);
  workers[1].say({ ready: true });
  const next = client.call("fan", "fan");
  workers[1].answer("done");
  assert.equal(await next, "done");
});

test("where the solver cannot be loaded every call says so", async () => {
  FakeWorker.all = [];
  const client = new Client(() => new FakeWorker());
  const early = client.call("a", "a");
  FakeWorker.all[0].say({ failed: "no WebAssembly" });
  for (const answer of [await early, await client.call("b", "b")]) {
    assert.match(answer.faults[0].message, /could not be loaded: no WebAssembly/);
  }
});

test("only work that takes a while is shown as such", async () => {
  const { client, busy, worker } = setUp();
  const quick = client.call("modes", "modes");
  worker.answer("done");
  await quick;
  await sleep(200);
  assert.deepEqual(busy, [false]);
  const slow = client.call("modes", "modes");
  await sleep(200);
  worker.answer("done");
  await slow;
  assert.deepEqual(busy, [false, true, false]);
});

/** A solver whose workers are told apart by what they were started for. */
function solver() {
  const workers = [];
  const busy = [];
  const made = new Solver(
    (whole) => {
      const worker = new FakeWorker();
      worker.whole = whole;
      workers.push(worker);
      return worker;
    },
    { onBusy: (on) => busy.push(on), late: ["draw"] },
  );
  workers[0].say({ ready: true });
  return { solver: made, workers, busy };
}

test("the whole module's worker is started by the first call that needs it, and holds up nothing", async () => {
  const { solver: both, workers } = solver();
  both.call("modes", "modes", {});
  both.call("draw", "chart_svg", "fan", {}, { measured: null });
  assert.deepEqual(workers.map(({ whole }) => whole), [false]);
  const parsed = both.call("parse", "parse_blade", "x");
  assert.deepEqual(workers.map(({ whole }) => whole), [false, true]);
  assert.equal(workers[1].sent.length, 0, "it is not loaded yet");
  workers[0].answer("modes");
  workers[0].answer("drawing");
  assert.deepEqual(workers[0].sent.map(({ name }) => name), ["modes", "chart_svg"]);
  workers[1].say({ ready: true });
  workers[1].answer("blade");
  assert.equal(await parsed, "blade");
  for (const args of [["fan", {}, { measured: "label" }], ["shapes", {}], ["converge", {}]]) both.call(args.join(), "chart_svg", ...args);
  assert.equal(workers[0].sent.length, 2, "the small one draws no other chart");
});

test("a lane is one, whichever worker its newest call is for", async () => {
  const { solver: both, workers } = solver();
  const fan = both.call("draw", "chart_svg", "fan", {});
  const converge = both.call("draw", "chart_svg", "converge", {});
  workers[0].answer("fan"); // late answers of this lane are taken, but not of the other chart
  assert.equal(await fan, null);
  workers[1].say({ ready: true });
  const back = both.call("draw", "chart_svg", "fan", {});
  workers[1].answer("converge");
  assert.equal(await converge, null);
  workers[0].answer("fan again");
  assert.equal(await back, "fan again");
});

test("a whole module that cannot be loaded is said, and tried again by the next call", async () => {
  const { solver: both, workers, busy } = solver();
  const first = both.call("parse", "parse_blade", "x");
  workers[1].say({ failed: "gone" });
  assert.match((await first).faults[0].message, /could not be loaded: gone/);
  const second = both.call("parse", "parse_blade", "x");
  assert.equal(workers.length, 3);
  workers[2].say({ ready: true });
  workers[2].answer("blade");
  assert.equal(await second, "blade");
  // What is waited for while it loads is shown as work, until nobody waits.
  const { solver: slow, workers: small, busy: shown } = solver();
  slow.call("draw", "chart_svg", "converge", {});
  await sleep(200);
  assert.equal(shown.at(-1), true);
  slow.call("draw", "chart_svg", "fan", {});
  small[0].answer("fan");
  assert.equal(shown.at(-1), false);
  assert.ok(!busy.includes(true));
});

test("a blade with changes is changed and solved in one call, and its faults are told", () => {
  const asked = [];
  const bladefan = {
    change_blade: (blade, changes) => (changes.length === 0 ? { status: "error", faults: ["none"] } : { status: "ok", value: { blade: { ...blade, changes: changes.length }, notes: [] } }),
    chart_svg: (...args) => {
      asked.push(args);
      return { status: "ok", value: 7 };
    },
  };
  const blade = { name: "a" };
  assert.deepEqual(callChanged(bladefan, "chart_svg", ["fan", { blade, changes: [{}] }, { width: 9 }]), { status: "ok", value: 7, blade: { name: "a", changes: 1 } });
  assert.deepEqual(callChanged(bladefan, "chart_svg", ["fan", blade, null]), { status: "ok", value: 7 });
  assert.deepEqual(callChanged(bladefan, "chart_svg", ["fan", { blade, changes: [] }]), { status: "error", faults: ["none"] });
  assert.deepEqual(asked, [["fan", { name: "a", changes: 1 }, { width: 9 }], ["fan", blade, null]]);
});
