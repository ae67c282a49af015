// The parts of the page that need no browser: node --test.
import assert from "node:assert/strict";
import { test } from "node:test";
import { planSections } from "../src/case.js";
import { colourRange, ramp } from "../src/colours.js";
import { Metrics } from "../src/metrics.js";
import { normalsOf } from "../src/normals.js";
import { duration, prefixFor, short } from "../src/numbers.js";
import { nearestFrame } from "../src/timeline.js";

const column = (name, values) => ({ name, data: Buffer.from(new Float64Array(values).buffer).toString("base64") });

test("numbers are short and lose nothing that matters", () => {
  assert.equal(short(1.7933), "1.793");
  assert.equal(short(-6.5503e-15), "−6.55e−15");
  assert.equal(short(40000), "40000");
  assert.equal(short(null), "–");
  assert.equal(short(NaN), "–");
  assert.deepEqual(prefixFor(0.0021), [1e-3, "m"]);
  assert.deepEqual(prefixFor(0), [1, ""]);
  assert.equal(duration(178.67), "2 min 59 s");
  assert.equal(duration(7325), "2 h 02 min");
});

test("zero keeps the middle of the scale for values of both signs", () => {
  const range = colourRange(-1, 3);
  assert.equal(range.scale, "diverging");
  const middle = range.begin + (range.end - range.begin) * 0.25; // where 0 lies between -1 and 3
  assert.ok(Math.abs(middle - 0.5) < 1e-12);
  assert.equal(colourRange(0, 3).scale, "sequential");
  const flat = colourRange(2, 2);
  assert.ok(flat.low < 2 && flat.high > 2);
  assert.equal(ramp("sequential").length, 1024);
});

test("a table is split by vesicle, and what is no number is a gap", () => {
  const metrics = new Metrics({ rows: 5, every: 1, columns: [
    column("step", [0, 0, 10, 10, 20]), column("time", [0, 0, 1, 1, 2]), column("vesicle", [0, 1, 0, 1, 0]),
    column("area", [1, 2, 3, NaN, 5]), { name: "gap", data: null }] });
  assert.deepEqual(metrics.vesicles, [0, 1]);
  assert.deepEqual(metrics.steps, [0, 10, 20]);
  assert.deepEqual(metrics.series("area", 0), [1, 3, 5]);
  assert.deepEqual(metrics.series("area", 1), [2, null, null]);
  assert.deepEqual(metrics.series("gap", 0), [null, null, null]);
  assert.equal(metrics.nearest(14), 1);
  assert.equal(metrics.nearest(16), 2);
  assert.ok(metrics.empty.has("gap"));
  assert.deepEqual(metrics.usualNames(), ["area"]); // none of the usual ones has numbers
});

test("no table is no trouble", () => {
  const metrics = new Metrics({ rows: 0, every: 1, columns: [] });
  assert.deepEqual(metrics.steps, []);
  assert.deepEqual(metrics.vesicles, []);
});

test("a triangle's normal points to where its corners turn left", () => {
  const normals = normalsOf(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), [0, 1, 2]);
  assert.deepEqual([...normals.slice(0, 3)], [0, 0, 1]);
});

test("the plan's lines become tables", () => {
  const sections = planSections("A title\nlattice units\n\nFluid\n  step            1      6.5 us\n  relaxation time      1.09\n\nNotes\n  one thing: said\n");
  assert.equal(sections.length, 2);
  assert.deepEqual(sections[0], { heading: "Fluid", rows: [["step", "1", "6.5 us"], ["relaxation time", "1.09", ""]], notes: [] });
  assert.deepEqual(sections[1].notes, ["one thing: said"]);
});

test("the nearest frame is the one a click means", () => {
  const frames = [0, 100, 200].map((step) => ({ step }));
  assert.equal(nearestFrame(frames, 140), 1);
  assert.equal(nearestFrame(frames, 1e9), 2);
});
