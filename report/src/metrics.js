// The table of metrics.csv: by column, by vesicle.
import { doublesOf } from "./bytes.js";

const words = {
  area: ["Area", "cells²"], area_ratio: ["Area / target", ""], volume: ["Volume", "cells³"],
  reduced_volume: ["Reduced volume", ""], bending_energy: ["Bending energy / 8πκ", ""],
  mean_curvature_integral: ["∫ H dA", "cells"], gaussian_curvature_over_pi: ["∫ K dA / π", ""],
  inertia_1: ["Inertia, least", ""], inertia_2: ["Inertia, middle", ""], inertia_3: ["Inertia, largest", ""],
  x: ["Centre x", "cells"], y: ["Centre y", "cells"], z: ["Centre z", "cells"],
  vx: ["Velocity x", "cells/step"], vy: ["Velocity y", "cells/step"], vz: ["Velocity z", "cells/step"],
  deformation_index: ["Deformation index", ""], taylor_deformation: ["Taylor deformation", ""],
  inclination: ["Inclination", "°"], tension: ["Tension", ""], max_speed: ["Largest speed", "cells/step"],
  mass_drift: ["Mass drift", ""], gap: ["Gap", "cells"], tank_treading_frequency: ["Tank-treading frequency", "1/step"],
  particle_stress: ["Particle stress", ""], effective_viscosity: ["Effective viscosity", ""], wall_stress: ["Wall stress", ""],
};

const usual = ["bending_energy", "reduced_volume", "area_ratio", "deformation_index", "taylor_deformation", "inclination",
  "tank_treading_frequency", "gap", "effective_viscosity", "tension", "max_speed", "mass_drift"];

export const labelOf = (name) => words[name]?.[0] ?? name.replaceAll("_", " ");
export const unitOf = (name) => words[name]?.[1] ?? "";

export class Metrics {
  constructor(table) {
    this.rows = table.rows;
    this.every = table.every;
    this.data = new Map();
    this.names = [];
    this.empty = new Set(); // columns without a number
    for (const { name, data } of table.columns) {
      if (data === null) this.empty.add(name);
      else this.data.set(name, data);
      if (!["step", "time", "vesicle"].includes(name)) this.names.push(name);
    }
    this.split();
  }

  column(name) {
    const found = this.data.get(name);
    if (typeof found !== "string") return found;
    const values = doublesOf(found);
    this.data.set(name, values);
    return values;
  }

  // Rows of each vesicle; the steps of all, ascending.
  split() {
    const steps = this.column("step") ?? [];
    const vesicles = this.column("vesicle") ?? new Float64Array(this.rows);
    this.vesicles = [...new Set(vesicles)].sort((a, b) => a - b);
    this.steps = [];
    this.place = new Int32Array(this.rows); // of each row among the steps
    for (let row = 0; row < this.rows; ++row) {
      if (row === 0 || steps[row] !== steps[row - 1]) this.steps.push(steps[row]);
      this.place[row] = this.steps.length - 1;
    }
    this.owner = vesicles;
  }

  usualNames() {
    const there = usual.filter((name) => this.names.includes(name) && !this.empty.has(name));
    return there.length > 0 ? there : this.names.filter((name) => !this.empty.has(name)).slice(0, 9);
  }

  // A column of one vesicle along the steps; null where it has none.
  series(name, vesicle) {
    const values = this.column(name);
    const line = new Array(this.steps.length).fill(null);
    if (values)
      for (let row = 0; row < this.rows; ++row)
        if (this.owner[row] === vesicle && Number.isFinite(values[row])) line[this.place[row]] = values[row];
    return line;
  }

  // The sample next to a step.
  nearest(step) {
    const steps = this.steps;
    let low = 0, high = steps.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (steps[middle] <= step) low = middle;
      else high = middle;
    }
    return Math.abs(steps[high] - step) < Math.abs(steps[low] - step) ? high : low;
  }
}
