// What is run on every blade: each command in each format, both families of functions, several
// speeds, drawings, measured points.

/** A measured file for any blade. */
export const MEASURED = "label,speed [rpm],frequency [Hz],source\n1F,0,1.5,bench\n1F,60,2.5,rotor\n2L,120,9,rotor\n1T,30,20,rotor\n";

const FORMATS = ["table", "json", "csv"];
const BASES = ["piecewise", "classical"];

// Of the uncoupled model, whose numbers do not move.
const MODEL = ["--model", "uncoupled"];
const SOLVERS = ["modes", "fan", "shapes", "converge"];

const run = (command, ...args) => ({
  command,
  args: [command, ...args, ...(SOLVERS.includes(command) ? MODEL : [])],
  files: args.filter((arg) => /^drawn\./.test(arg)),
});

/** Runs on one blade, by its name or file. `whole` adds what is slow or the same on all blades. */
export function runsOf(blade, measured, whole) {
  const runs = [];
  for (const basis of BASES) {
    for (const speed of [[], ["--speed", "0"], ["--speed", "97rpm"]]) {
      runs.push(run("modes", blade, "--basis", basis, ...speed, "--format", "json"));
    }
    runs.push(run("modes", blade, "--basis", basis, "--modes", "9", "--dof", "flap,torsion", "--functions", "25"));
    runs.push(run("fan", blade, "--basis", basis, "--format", "json", "--svg", "drawn.svg"));
    runs.push(run("shapes", blade, "--basis", basis, "--format", "json", "--svg", "drawn.svg"));
    runs.push(run("shapes", blade, "--basis", basis, "--speed", "0", "--points", "21", "--normalise", "mass", "--format", "csv"));
  }
  runs.push(run("modes", blade, "--format", "csv"));
  runs.push(run("fan", blade, "--format", "csv", "--speeds", "0:120rpm:7", "--modes", "3", "--harmonics", "4"));
  const drawing = ["--svg", "drawn.svg", "--theme", "dark", "--width", "700", "--speed-unit", "rpm", "--frequency-unit", "per-rev"];
  runs.push(run("fan", blade, "--measured", measured, "--band", "0.8:1.3", ...drawing));
  runs.push(run("fan", blade, "--measured", measured, "--speeds", "0:120rpm:11", "--format", "json"));
  runs.push(run("shapes", blade, "--modes", "2"));
  runs.push(run("converge", blade, "--format", "json", "--svg", "drawn.svg"));
  runs.push(run("converge", blade, "--speed", "0", "--up-to", "8", "--modes", "3", "--format", "csv"));
  runs.push(run("converge", blade, "--up-to", "6", "--basis", "classical"));
  runs.push(...FORMATS.map((format) => run("check", blade, "--format", format)));
  if (whole) {
    runs.push(run("fan", blade, "--png", "drawn.png", "--speeds", "0:1000rpm:201", "--frequencies", "0:300"));
    runs.push(run("modes", blade, "--modes", "20", "--format", "json"));
    runs.push(run("modes", blade, "--functions", "60", "--basis", "classical", "--format", "json"));
    runs.push(run("blades", blade), run("blades", blade, "--format", "json"));
  }
  return runs;
}

/** Runs without a blade: the list, what help says, and what is refused. */
export function otherRuns(faulty) {
  const commands = ["modes", "fan", "shapes", "converge", "check", "blades"];
  const wrong = [
    ["modes", "nowhere"],
    ["modes", "uniform", "--speed", "-3", "--modes", "0"],
    ["modes", "uniform", "--basis", "cubic"],
    ["fan", "uniform", "--speeds", "9:3:1", "--band", "2:1"],
    ["fan", "uniform", "--theme", "dark"],
    ["shapes", "uniform", "--points", "1"],
    ["converge", "uniform", "--up-to", "999"],
    ["check", "uniform", "--format", "xml"],
  ];
  return [
    ...FORMATS.map((format) => run("blades", "--format", format)),
    ...[[], ...commands.map((command) => [command])].map((args) => ({ command: "help", args: [...args, "--help"], files: [] })),
    ...[...wrong, ...faulty.map((file) => ["check", file])].map((args) => ({ command: "refused", args, files: [] })),
  ];
}
