// Numbers and units as people read them.
const prefixes = [
  [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"], [1e-15, "f"],
];

export function short(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e6) return minus(String(value));
  if (size >= 1e-3 && size < 1e5) return minus(String(Number(value.toPrecision(digits))));
  const [mantissa, exponent] = value.toExponential(Math.max(0, digits - 2)).split("e");
  return minus(`${Number(mantissa)}e${Number(exponent)}`);
}

const minus = (text) => text.replaceAll("-", "−");

export const grouped = (value) => Math.round(value).toLocaleString("en").replaceAll(",", " ");

// The prefix that brings `size` between 1 and 1000: [factor, prefix].
export function prefixFor(size) {
  const magnitude = Math.abs(size);
  for (const [factor, prefix] of prefixes) if (magnitude >= 0.999 * factor) return [factor, prefix];
  return magnitude > 0 ? prefixes[prefixes.length - 1] : [1, ""];
}

// Seconds as clocks tell them.
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return "–";
  if (seconds < 60) return `${short(seconds, 3)} s`;
  const whole = Math.round(seconds);
  const minutes = Math.floor(whole / 60) % 60;
  const rest = String(whole % 60).padStart(2, "0");
  return whole < 3600 ? `${minutes} min ${rest} s` : `${Math.floor(whole / 3600)} h ${String(minutes).padStart(2, "0")} min`;
}

// How a surface quantity is shown: factor from the file's unit, unit, words.
const shown = {
  mean_curvature: { label: "Mean curvature H", lattice: "1/cell", si: [1e-6, "1/µm"] },
  gaussian_curvature: { label: "Gaussian curvature K", lattice: "1/cell²", si: [1e-12, "1/µm²"] },
  speed: { label: "Speed", lattice: "cells/step", si: [1e6, "µm/s"] },
  total_force: { label: "Membrane force, normal", lattice: "lattice units", si: [1, "Pa"] },
  bending_force: { label: "Bending force, normal", lattice: "lattice units", si: [1, "Pa"] },
  tension_force: { label: "Tension force, normal", lattice: "lattice units", si: [1, "Pa"] },
  area_force: { label: "Area force, normal", lattice: "lattice units", si: [1, "Pa"] },
};

export function quantityText(name, siUnit, hasScales) {
  const known = shown[name] ?? { label: name, lattice: "", si: [1, siUnit] };
  const [factor, unit] = hasScales ? known.si : [1, known.lattice];
  return { label: known.label, factor, unit };
}
