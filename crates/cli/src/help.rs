//! What `--help` says after the options: an example for every command.

/// Of the program.
pub(crate) const NOTES: &str = "\
BLADE is a built-in name (`bladefan blades` lists them), a .toml or .json file, or - for standard
input; at most 64 MB. Speeds are in rad/s, or in the unit that follows without a space: 660rpm,
11Hz, 69.1rad/s.
Exit codes: 0 done, 2 bad usage or bad input, 1 anything else.

Example:
  bladefan fan tm4760 --svg fan.svg";

/// Of `modes`.
pub(crate) const MODES: &str = "\
Examples:
  bladefan modes tm4760
  bladefan modes my-blade.toml --speed 600rpm --modes 3 --format json
  cat my-blade.toml | bladefan modes -";

/// Of `fan`.
pub(crate) const FAN: &str = "\
Examples:
  bladefan fan tm4760 --svg fan.svg
  bladefan fan tm4760 --speeds 0:800rpm:201 --band 0.95:1.05 --format csv --output fan.csv
  bladefan fan tm4760 --measured test.csv --png fan.png
  bladefan fan tm4760 --frequency-unit per-rev --frequencies 0:6 --height 500 --svg fan.svg

Measured points: a CSV file with the columns label, speed, frequency, source, units in the header
row: `label,speed [rpm],frequency [Hz],source`; at most 100000 points. CSV output holds the branches;
crossings, margins and Southwell coefficients are in the table and in the JSON.";

/// Of `shapes`.
pub(crate) const SHAPES: &str = "\
Examples:
  bladefan shapes sa330 --dof flap --png shapes.png
  bladefan shapes tm4760 --speed 0 --points 201 --format csv --output shapes.csv

The table holds displacements at some radii; slopes and moments are in the CSV and the JSON.";

/// Of `converge`.
pub(crate) const CONVERGE: &str = "\
Example:
  bladefan converge tm4760 --up-to 30 --dof flap --svg converge.svg";

/// Of `check`.
pub(crate) const CHECK: &str = "\
Examples:
  bladefan check my-blade.toml
  bladefan blades tm4760 | bladefan check -";

/// Of `blades`.
pub(crate) const BLADES: &str = "\
Examples:
  bladefan blades
  bladefan blades tm4760 > my-blade.toml";
