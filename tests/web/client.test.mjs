// The worker's protocol, with workers of our own in place of real ones.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { callChanged } from "../../web/solver/changed.js";
import { Client, withModule } from "../../web/solver/client.js";
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
  const client = new Client(() => new FakeWorker(), { onBusy: (on) => busy.push(on), startMs: 2_000, ...limits });
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
  assert.deepEqual(
    worker.sent.map((message) => message.args[0]),
    [1, 3],
  );
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

test("a worker that dies is started again once, and the question is asked again", async () => {
  const { client, worker, workers } = setUp();
  const asked = client.call("fan", "fan", 7);
  worker.onerror({ message: "out of memory" });
  assert.equal(worker.terminated, true);
  workers[1].say({ ready: true });
  assert.deepEqual(
    workers[1].sent.map(({ name, args }) => [name, args]),
    [["fan", [7]]],
  );
  workers[1].answer("done");
  assert.equal(await asked, "done");
});

test("a question that kills the worker twice is answered with the reason, and the next one is heard", async () => {
  const { client, worker, workers } = setUp();
  const broken = client.call("fan", "fan");
  worker.say({ id: 1, crashed: "unreachable" });
  workers[1].say({ ready: true });
  workers[1].say({ id: 1, crashed: "unreachable" });
  assert.match((await broken).faults[0].message, /broke off: unreachable/);
  assert.equal(workers[1].terminated, true);
  workers[2].say({ ready: true });
  const next = client.call("fan", "fan");
  workers[2].answer("done");
  assert.equal(await next, "done");
});

test("a question that was superseded while its worker died is not asked again", async () => {
  const { client, worker, workers } = setUp();
  const old = client.call("fan", "fan", "old");
  const fresh = client.call("fan", "fan", "new");
  worker.say({ id: 1, crashed: "unreachable" });
  assert.equal(await old, null);
  workers[1].say({ ready: true });
  assert.deepEqual(
    workers[1].sent.map(({ args }) => args[0]),
    ["new"],
  );
  workers[1].answer("done");
  assert.equal(await fresh, "done");
});

/** A client whose worker is not ready, and what it says of its troubles. */
function starting(limits) {
  FakeWorker.all = [];
  const troubles = [];
  const busy = [];
  const client = new Client(() => new FakeWorker(), {
    onTrouble: (words) => troubles.push(words),
    onBusy: (on) => busy.push(on),
    startMs: 2_000,
    ...limits,
  });
  return { client, troubles, busy, workers: FakeWorker.all };
}

test("where the solver cannot be loaded that is said, and what was asked waits for another try", async () => {
  const { client, troubles, workers } = starting();
  const early = client.call("a", "a");
  workers[0].say({ failed: "no WebAssembly" });
  assert.deepEqual(troubles, ["the solver could not be loaded: no WebAssembly"]);
  assert.equal(workers.length, 1, "it is not tried again by itself");
  client.again();
  client.again();
  assert.equal(workers.length, 2);
  workers[1].say({ ready: true });
  workers[1].answer("late, but there");
  assert.equal(await early, "late, but there");
  assert.deepEqual(troubles.slice(1), [null]);
});

test("a new question is another try", async () => {
  const { client, troubles, workers } = starting();
  const early = client.call("a", "a");
  workers[0].say({ failed: "offline" });
  const next = client.call("a", "a");
  assert.equal(await early, null);
  workers[1].say({ ready: true });
  workers[1].answer("done");
  assert.equal(await next, "done");
  assert.equal(troubles.at(-1), null);
});

test("a worker that never becomes ready is not waited for without end", async () => {
  const { client, troubles, busy, workers } = starting({ startMs: 200 });
  client.call("a", "a");
  await sleep(300);
  assert.match(troubles[0], /^the solver could not be loaded: it did not start within 0.2 seconds$/);
  assert.equal(workers[0].terminated, true);
  assert.equal(busy.at(-1), false, "nothing is under way");
  client.again();
  workers[1].say({ ready: true });
  await sleep(300);
  assert.deepEqual(troubles.slice(1), [null]);
  workers[1].answer("done");
});

test("a worker that dies before it is ready is started again once", () => {
  const { troubles, workers } = starting();
  workers[0].onerror({ message: "" });
  assert.deepEqual([workers.length, troubles], [2, []]);
  workers[1].onerror({ message: "" });
  assert.equal(workers.length, 2);
  assert.match(troubles[0], /the worker could not be started/);
});

test("a worker gets the module that is compiled once, or says why there is none", async () => {
  const troubles = [];
  FakeWorker.all = [];
  let module = Promise.reject(new Error("it has not arrived within 30 seconds"));
  const client = new Client(
    () =>
      withModule(
        () => new FakeWorker(),
        () => module,
      ),
    { onTrouble: (words) => troubles.push(words) },
  );
  await sleep(0);
  assert.deepEqual(troubles, ["the solver could not be loaded: it has not arrived within 30 seconds"]);
  module = Promise.resolve("compiled");
  client.again();
  await sleep(0);
  assert.deepEqual(FakeWorker.all[1].sent, [{ module: "compiled" }]);
  FakeWorker.all[1].say({ ready: true });
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

/** A solver with its workers in the order of their start; the first is ready. */
function solver() {
  FakeWorker.all = [];
  const busy = [];
  const troubles = [];
  const made = new Solver(() => new FakeWorker(), {
    onBusy: (on) => busy.push(on),
    onTrouble: (words) => troubles.push(words),
    startMs: 2_000,
    late: ["draw"],
  });
  FakeWorker.all[0].say({ ready: true });
  return { solver: made, workers: FakeWorker.all, busy, troubles };
}

test("the second worker is started by the first call that is no fan work, and holds up nothing", async () => {
  const { solver: both, workers } = solver();
  both.call("modes", "modes", {});
  both.call("draw", "chart_svg", "fan", {}, { measured: "label" });
  assert.equal(workers.length, 1);
  const parsed = both.call("parse", "parse_blade", "x");
  assert.equal(workers.length, 2);
  assert.equal(workers[1].sent.length, 0, "it is not ready yet");
  workers[0].answer("modes");
  workers[0].answer("drawing");
  assert.deepEqual(
    workers[0].sent.map(({ name }) => name),
    ["modes", "chart_svg"],
  );
  workers[1].say({ ready: true });
  workers[1].answer("blade");
  assert.equal(await parsed, "blade");
  for (const kind of ["shapes", "converge"]) both.call(kind, "chart_svg", kind, {});
  assert.equal(workers[0].sent.length, 2, "sliders do not wait for shapes");
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

test("trouble of either worker is said until neither has any, and what is waited for is shown as work", async () => {
  const { solver: both, workers, busy, troubles } = solver();
  const parsed = both.call("parse", "parse_blade", "x");
  workers[1].say({ failed: "gone" });
  assert.match(troubles.at(-1), /could not be loaded: gone/);
  both.call("modes", "modes", {});
  workers[0].answer("modes");
  assert.match(troubles.at(-1), /gone/, "an answer of the other is no end of it");
  both.again();
  assert.equal(troubles.at(-1), null);
  await sleep(200);
  assert.equal(busy.at(-1), true);
  workers[2].say({ ready: true });
  workers[2].answer("blade");
  assert.equal(await parsed, "blade");
  assert.equal(busy.at(-1), false);
});

test("a blade with changes is changed and solved in one call, and its faults are told", () => {
  const asked = [];
  const bladefan = {
    change_blade: (blade, changes) =>
      changes.length === 0
        ? { status: "error", faults: ["none"] }
        : { status: "ok", value: { blade: { ...blade, changes: changes.length }, notes: [] } },
    chart_svg: (...args) => {
      asked.push(args);
      return { status: "ok", value: 7 };
    },
  };
  const blade = { name: "a" };
  assert.deepEqual(callChanged(bladefan, "chart_svg", ["fan", { blade, changes: [{}] }, { width: 9 }]), {
    status: "ok",
    value: 7,
    blade: { name: "a", changes: 1 },
  });
  assert.deepEqual(callChanged(bladefan, "chart_svg", ["fan", blade, null]), { status: "ok", value: 7 });
  assert.deepEqual(callChanged(bladefan, "chart_svg", ["fan", { blade, changes: [] }]), { status: "error", faults: ["none"] });
  assert.deepEqual(asked, [
    ["fan", { name: "a", changes: 1 }, { width: 9 }],
    ["fan", blade, null],
  ]);
});
