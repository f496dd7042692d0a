// What a report of mode shapes has of each mode along the span.

const UNCOUPLED = [
  { name: "displacement", of: (shape) => shape.displacement },
  { name: "slope [1/m]", of: (shape) => shape.slope },
  { name: "moment [N·m]", of: (shape) => shape.moment },
];
const bending = (motion) => [
  { name: motion, of: (shape) => shape.components[motion].displacement },
  { name: `${motion} slope [1/m]`, of: (shape) => shape.components[motion].slope },
  { name: `${motion} moment [N·m]`, of: (shape) => shape.components[motion].moment },
  { name: `${motion} force [N]`, of: (shape) => shape.components[motion].force },
];
const COUPLED = [
  ...bending("flap"),
  ...bending("lag"),
  { name: "torsion [rad]", of: (shape) => shape.components.torsion.twist },
  { name: "torsion moment [N·m]", of: (shape) => shape.components.torsion.moment },
];

/** Its columns: their names, as the command line calls them, and where a shape has them. */
export const shapeColumns = ({ model }) => (model.kind === "coupled" ? COUPLED : UNCOUPLED);
