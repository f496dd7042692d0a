/** A result, or everything that is wrong with the input. Calls do not throw. */
export type Reply<T> =
  | { status: "ok"; value: T; warnings: Warning[] }
  | { status: "error"; faults: Fault[] };

/** One thing wrong with an input. */
export interface Fault {
  /** Stable kind, e.g. "out-of-range". */
  code: string;
  /** Path in the blade file (`distribution.mass[3]`) or name of an option; empty for the whole text. */
  path: string;
  /** The value as given. */
  value: string | null;
  /** The rule that it breaks. */
  rule: string;
  /** One line for a person, without the path. */
  message: string;
  /** From 1; null where the input was no text. */
  line: number | null;
  /** In characters, from 1. */
  column: number | null;
}

/** Something in a legal blade that does not act as its author may expect. */
export interface Warning {
  path: string;
  message: string;
}

export type Dof = "flap" | "lag" | "torsion";
export type ChartKind = "fan" | "shapes" | "converge";

/** A property along the span: one number, a list on `distribution.r`, or values on radii of its own. */
export type Property = number | number[] | { r: number[]; values: number[] };

/** Names of units, as `about()` lists them. In a blade an absent one is SI, in `convert_blade` it stays. */
export interface Units {
  length?: string;
  mass?: string;
  force?: string;
  angle?: string;
  speed?: string;
}

/** A blade as `parse_blade` returns it: the keys and units of the blade file. */
export interface Blade {
  schema: "bladefan-blade/1";
  name?: string;
  notes?: string;
  source?: { citation?: string; quality?: "published" | "estimated" | "example" };
  units?: Units;
  rotor: {
    radius: number;
    nominal_speed: number;
    blades?: number;
    /** + nose up, added to the twist everywhere. */
    pitch?: number;
    /** + tip up. */
    precone?: number;
    /** Of the elastic axis, + toward the leading edge. */
    torque_offset?: number;
    /** Of the springs of flap and lag, + nose up; "pitch" turns them with the blade at their radius. */
    spring_angle?: number | "pitch";
  };
  flap: BladeRoot<"hingeless" | "hinged" | "spring-hinged">;
  lag: BladeRoot<"hingeless" | "hinged" | "spring-hinged">;
  /** Absent, with `torsion_stiffness` and the inertias: flap and lag alone. */
  torsion?: BladeRoot<"rigid" | "spring">;
  distribution: {
    r?: number[];
    mass: Property;
    flap_stiffness: Property;
    lag_stiffness: Property;
    torsion_stiffness?: Property;
    /** The sum of the next two where it is absent and they are not. */
    polar_inertia?: Property;
    flap_inertia?: Property;
    lag_inertia?: Property;
    mass_offset?: Property;
    twist?: Property;
    tension_offset?: Property;
    axial_stiffness?: Property;
    trapeze_radius?: Property;
  };
  point_mass?: PointMass[];
}
/** A mass at one radius. */
export interface PointMass {
  r: number;
  mass: number;
  /** + toward the leading edge. */
  offset?: number;
  flap_inertia?: number;
  /** Absent: mass·offset². */
  lag_inertia?: number;
}
export interface BladeRoot<Kind> {
  root: Kind;
  offset?: number;
  offset_ratio?: number;
  spring?: number;
}

/** One change of a blade: one of `scale`, `set` and `add`. */
export interface Change {
  /** A path of the blade file: "distribution.mass" and the other properties, "flap.offset", "lag.spring", "rotor.nominal_speed". */
  what: string;
  /** Times this. A mass that is scaled takes its inertias and the point masses there along. */
  scale?: number | null;
  /** To this, in `units`. */
  set?: number | null;
  /** By this, in `units`. */
  add?: number | null;
  /** Inner and outer end of the part of the span that is changed, in `units`; absent: to the end on that side. Properties only. */
  from?: number | null;
  to?: number | null;
  /** Units of the numbers here; absent ones are the blade's. */
  units?: Units | null;
  /** Leaves inertias and point masses as they are where mass is scaled. */
  mass_alone?: boolean | null;
}
/** A blade after changes, in its own units. */
export interface ChangedBlade {
  blade: Blade;
  /** What was changed along with what was asked for. */
  notes: Warning[];
}

/** A rotor speed: a number in rad/s, or text with a unit ("660rpm", "11Hz", "69.1rad/s"). */
export type Speed = number | string;

/** Options have the names of the command line, with `_` for `-`; null and undefined are not given. */
export interface SolverOptions {
  modes?: number | string | null;
  dof?: Dof[] | string | null;
  /** Default "piecewise": as many functions as it takes. "classical": the paper's, as many as `functions` says. */
  basis?: "piecewise" | "classical" | null;
}
/** An angle: a number in rad, or text with a unit ("8deg", "0.14rad"). */
export type Angle = number | string;
/** What is solved; all but `model` act in the coupled model alone. */
export interface ModelOptions extends SolverOptions {
  /** Default "auto": coupled where twist, pitch, precone or an offset couples the motions. */
  model?: "auto" | "uncoupled" | "coupled" | null;
  pitch?: Angle | null;
  precone?: Angle | null;
  trapeze?: "on" | "off" | null;
  rotary?: "on" | "off" | null;
  /** Coriolis terms, in `modes` alone. */
  gyroscopic?: "on" | "off" | null;
  /** Absent: full in the coupled model, paper in the uncoupled one. */
  propeller_moment?: "full" | "paper" | null;
}
export interface ModesOptions extends ModelOptions {
  speed?: Speed | null;
  functions?: number | string | null;
}
export interface FanOptions extends ModelOptions {
  /** `[from, to, count]` or "FROM:TO:COUNT". */
  speeds?: [Speed, Speed, number] | string | null;
  functions?: number | string | null;
  harmonics?: number | string | null;
  /** `[from, to]` or "FROM:TO", as ratios of nominal speed. */
  band?: [number, number] | string | null;
}
export interface ShapesOptions extends ModesOptions {
  points?: number | string | null;
  normalise?: "max" | "mass" | null;
}
export interface ConvergeOptions extends ModelOptions {
  speed?: Speed | null;
  up_to?: number | string | null;
}
export interface CompareOptions extends ModelOptions {
  functions?: number | string | null;
}
/** Options of a drawing, beside those of its analysis. */
export interface Looks {
  theme?: "light" | "dark" | null;
  /** In pixels, held to 320 … 8000. */
  width?: number | null;
  /** In pixels, held to 0.4 … 1.6 of the width; without it as suits the width. More than fits makes it higher. */
  height?: number | null;
  speed_unit?: "rad/s" | "rpm" | "Hz" | null;
  frequency_unit?: "rad/s" | "Hz" | "rpm" | "per-rev" | null;
}
/** Options of a fan chart's drawing, beside those of its analysis. */
export interface FanLooks {
  /** CSV text as `measured()` reads it. */
  measured?: string | null;
  /** What the frequency axis shows in its unit, `[from, to]` or "FROM:TO"; without it from 0 to what the rays can meet. */
  frequencies?: [number, number] | string | null;
}
export type ChartOptions = Looks & ((FanOptions & FanLooks) | ShapesOptions | ConvergeOptions);

/** Numbers of assumed functions; null for a degree of freedom that was not asked for. */
export interface Basis {
  family: "piecewise" | "classical";
  functions: { flap: number | null; lag: number | null; torsion: number | null };
}

export interface ModesReport {
  schema: "bladefan-modes/1";
  blade: string;
  speed_rad_s: number;
  model: Model<"uncoupled">;
  basis: Basis;
  /** How many of the paper's functions are behind `classical_rad_s`. */
  classical_functions: number;
  /** In the order flap, lag, torsion, ascending within each. */
  modes: Mode[];
  warnings: Warning[];
}
export interface Mode {
  /** "1F", "2F", "1L", "1T", … */
  label: string;
  dof: Dof;
  number: number;
  frequency_rad_s: number;
  frequency_hz: number;
  /** Null at rest, as are the next two. */
  per_rev: number | null;
  /** Integer nearest to `per_rev`, at least 1. */
  nearest_harmonic: number | null;
  /** `per_rev` less `nearest_harmonic`. */
  margin_per_rev: number | null;
  /** The frequency lies between these bounds. */
  lower_rad_s: number | null;
  upper_rad_s: number | null;
  /** The bounds of this degree of freedom hold if the mode after the last one listed is not below it; null without any. */
  separation_rad_s: number | null;
  /** The paper's functions, as many as `functions` says; null where that is fewer than the mode's number. */
  classical_rad_s: number | null;
  /** The piecewise functions. */
  converged_rad_s: number | null;
  residual: number;
}

export interface FanChart {
  schema: "bladefan-fan/1";
  blade: string;
  blades: number | null;
  harmonics: number;
  basis: Basis;
  speeds_rad_s: number[];
  branches: Branch[];
  /** Each with what the branch is called there, and its place among the branches. */
  crossings: { label: string; branch: number; harmonic: number; speed_rad_s: number; frequency_rad_s: number }[];
  /** Branches that lie on a ray at every speed. */
  coincident: { label: string; branch: number; harmonic: number }[];
  nominal: { speed_rad_s: number; margins: Margin[] };
  warnings: Warning[];
  model: Model;
  /** Where branches come near one another, by rotor speed; coupled alone. */
  veerings?: {
    /** Indices of the branches, the lower one first. */
    branches: number[];
    kind: "crossing" | "veering";
    speed_rad_s: number;
    gap_rad_s: number;
    frequency_rad_s: number;
  }[];
}
/** One mode over all speeds of a chart. */
export interface Branch {
  label: string;
  dof: Dof;
  number: number;
  /** Not a number where a coupled blade is unstable. */
  frequency_rad_s: number[];
  southwell: { k0: number; k1: number };
  /** What it is called from a rotor speed on; coupled alone, as are its bounds. */
  labels?: { from_rad_s: number; label: string }[];
  lower_rad_s?: (number | null)[];
  upper_rad_s?: (number | null)[];
}
/** How much of a mode's kinetic energy about the mass centre is in each motion; in sum 1. */
export interface Shares {
  flap: number;
  lag: number;
  torsion: number;
}
/** One mode of a coupled blade. */
export interface CoupledMode {
  /** "2F", "1T"; "3F/T" where it is mixed. */
  label: string;
  dof: Dof;
  number: number;
  mixed: boolean;
  shares: Shares;
  /** Null where unstable. */
  frequency_rad_s: number | null;
  frequency_hz: number | null;
  per_rev: number | null;
  nearest_harmonic: number | null;
  margin_per_rev: number | null;
  /** ω², negative where unstable. */
  eigenvalue_s2: number;
  unstable: boolean;
  lower_rad_s: number | null;
  upper_rad_s: number | null;
  lower_eigenvalue_s2: number | null;
  upper_eigenvalue_s2: number | null;
  /** Why there are no bounds. */
  bounds_missing: "separation not proven" | "no shift" | "statically unstable" | null;
  /** Where there are none: an estimate, which is no bound. */
  error_estimate_rad_s: number | null;
  separation_rad_s: number | null;
  /** The paper's functions, as many of each motion as `functions` says. */
  classical_rad_s: number | null;
  /** The piecewise functions. */
  converged_rad_s: number | null;
}
/** Modes of a coupled blade at one rotor speed, ascending. */
export interface CoupledModesReport {
  schema: "bladefan-modes/1";
  blade: string;
  speed_rad_s: number;
  model: Model<"coupled">;
  basis: Basis;
  /** How many of the paper's functions of each motion are behind `classical_rad_s`. */
  classical_functions: number;
  modes: CoupledMode[];
  warnings: Warning[];
}
export interface BendingComponent {
  displacement: number[];
  slope: number[];
  moment: number[];
  force: number[];
}
/** One mode shape of a coupled blade. */
export interface CoupledShape {
  label: string;
  dof: Dof;
  number: number;
  shares: Shares;
  frequency_rad_s: number | null;
  nodes_m: number[];
  components: { flap: BendingComponent; lag: BendingComponent; torsion: { twist: number[]; moment: number[] } };
}
export interface CoupledShapesReport {
  schema: "bladefan-shapes/1";
  blade: string;
  speed_rad_s: number;
  model: Model<"coupled">;
  basis: Basis;
  r_m: number[];
  radius_m: number;
  shapes: CoupledShape[];
  warnings: Warning[];
}
/** What is solved. */
export interface Model<K extends "uncoupled" | "coupled" = "uncoupled" | "coupled"> {
  kind: K;
  pitch_rad: number;
  precone_rad: number;
  trapeze: boolean;
  rotary: boolean;
  gyroscopic: boolean;
  steady: boolean;
  cone: "held";
  propeller_moment: "full" | "paper";
  /** Paths of what the blade gives and the model does not use. */
  unused: string[];
  /** The same in one plain line. */
  words: string;
}
/** One branch at one speed of a chart, as `at_speed` reads it off; there is none where it is unstable. */
export interface ModeAtSpeed {
  /** What the branch is called there. */
  label: string;
  /** Its place among the branches. */
  branch: number;
  frequency_rad_s: number;
  /** Null at rest, as are the next two. */
  per_rev: number | null;
  nearest_harmonic: number | null;
  margin_per_rev: number | null;
}
export interface Margin {
  label: string;
  /** Its place among the branches of a fan chart. */
  branch?: number;
  per_rev: number;
  nearest_harmonic: number;
  /** `per_rev` less `nearest_harmonic`. */
  margin_per_rev: number;
}

export interface ShapesReport {
  schema: "bladefan-shapes/1";
  blade: string;
  speed_rad_s: number;
  model: Model<"uncoupled">;
  basis: Basis;
  r_m: number[];
  radius_m: number;
  shapes: ShapeReport[];
  warnings: Warning[];
}
export interface ShapeReport {
  label: string;
  dof: Dof;
  number: number;
  frequency_rad_s: number;
  /** Largest share of another listed shape of its degree of freedom, by mass or inertia: 0 where orthogonal to all. */
  orthogonality: number;
  /** Radii where the displacement passes through zero between root and tip [m], ascending. */
  nodes_m: number[];
  displacement: number[];
  slope: number[];
  moment: number[];
}

export interface ConvergeReport {
  schema: "bladefan-converge/1";
  blade: string;
  speed_rad_s: number;
  model: Model;
  /** Numbers of classical functions. */
  functions: number[];
  series: ConvergeSeries[];
  warnings: Warning[];
}

export interface ConvergeSeries {
  label: string;
  dof: Dof;
  number: number;
  /** One per number of `functions`; null where they are fewer than the mode's number. */
  classical_rad_s: (number | null)[];
  converged_rad_s: number | null;
  lower_rad_s: number | null;
  upper_rad_s: number | null;
  /** One polynomial per element, two, … until converged. */
  piecewise_functions: number[];
  /** One per number of `piecewise_functions`. */
  piecewise_rad_s: (number | null)[];
}

export interface BladeSummary {
  schema: "bladefan-check/1";
  blade: string;
  radius_m: number;
  nominal_speed_rad_s: number;
  blades: number | null;
  stations: number;
  dofs: {
    dof: Dof;
    root: string;
    offset_m: number;
    spring_n_m: number | null;
    mass_kg: number;
    static_moment_kg_m: number | null;
    inertia_kg_m2: number;
  }[];
  warnings: Warning[];
}

/** What a chart may show; `schema` tells which. */
export type ChartReport = FanChart | ShapesReport | CoupledShapesReport | ConvergeReport;

export interface Drawing<Report extends ChartReport = ChartReport> {
  svg: string;
  width: number;
  height: number;
  plots: PlotArea[];
  /** What is drawn: the value that `fan`, `shapes` or `converge` gives for the same options. */
  report: Report;
}
/** Where a frame stands in its drawing, in units of the viewBox, y downwards. */
export interface PlotArea {
  name: string;
  left: number;
  top: number;
  width: number;
  height: number;
  x: Axis;
  y: Axis;
}
export interface Axis {
  from: number;
  to: number;
  /** "/rev" for the frequency unit "per-rev"; empty for a pure number. */
  unit: string;
  log: boolean;
}

export interface MeasuredPoint {
  label: string;
  speed_rad_s: number;
  frequency_rad_s: number;
  source: string;
}

/** A measured point and what the solver gives at its rotor speed. */
export interface ComparedPoint extends MeasuredPoint {
  /** Null where the point's branch was not asked for: raise `modes`, or name its degree of freedom. */
  computed_rad_s: number | null;
  /** `computed_rad_s` less the measured frequency, in percent of the measured one. */
  error_percent: number | null;
}

export interface BuiltInBlade {
  name: string;
  title: string | null;
  quality: "published" | "estimated" | "example" | null;
  citation: string | null;
  /** The blade file. */
  toml: string;
}

export interface About {
  version: string;
  /** What the model is, in one line. */
  model: string;
  /** Each with how many rad/s it is. */
  speed_units: { name: string; rad_s: number }[];
  /** Names for the option `frequency_unit`. */
  frequency_units: string[];
  /** Names of a blade file's units, SI first. */
  units: Record<"length" | "mass" | "force" | "angle" | "speed", string[]>;
}
