// One step's surfaces, from the bytes that src/io/surface_packing.cpp wrote.
import { MeshoptDecoder } from "meshoptimizer/meshopt_decoder.module.js";
import { normalsOf } from "./normals.js";

export const decoderReady = MeshoptDecoder.ready;

const positionColumns = 3;

class Surface {
  constructor(header, points, triangles, cell, valueSteps) {
    this.vesicle = header.vesicle;
    this.count = header.points;
    this.triangles = triangles;
    this.header = header;
    this.valueSteps = valueSteps;
    this.points = points;
    this.columns = header.stride / 2;
    this.positions = new Float32Array(3 * this.count);
    for (let i = 0; i < this.count; ++i)
      for (let axis = 0; axis < 3; ++axis)
        this.positions[3 * i + axis] = (header.origin[axis] + points[i * this.columns + axis] * header.unit) / cell;
    this.normals = normalsOf(this.positions, triangles);
  }

  // Texture coordinates that lead from the quantity's value to its place between low and high.
  placesBetween(quantity, low, high) {
    const from = this.header.low[quantity];
    const step = (this.header.high[quantity] - from) / this.valueSteps;
    const scale = high > low ? 1 / (high - low) : 0;
    const places = new Float32Array(2 * this.count).fill(0.5);
    if (scale > 0)
      for (let i = 0; i < this.count; ++i)
        places[2 * i] = (from + step * this.points[i * this.columns + positionColumns + quantity] - low) * scale;
    return places;
  }
}

// `cell`: the length of a cell in the unit of the surface files, so that positions come out in cells.
export function decodeFrame(bytes, cell) {
  const length = new DataView(bytes.buffer, bytes.byteOffset, 4).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  let at = 4 + length;
  const take = (count) => bytes.subarray(at, (at += count));
  const surfaces = [];
  for (const one of header.surfaces) {
    const points = new Uint8Array(one.points * one.stride);
    const triangles = new Uint8Array(one.triangles * 12);
    const pointBytes = take(one.point_bytes);
    const triangleBytes = take(one.triangle_bytes);
    if (one.points === 0 || one.triangles === 0) continue;
    MeshoptDecoder.decodeVertexBuffer(points, one.points, one.stride, pointBytes);
    MeshoptDecoder.decodeIndexBuffer(triangles, one.triangles * 3, 4, triangleBytes);
    surfaces.push(new Surface(one, new Uint16Array(points.buffer), new Uint32Array(triangles.buffer), cell, header.value_steps));
  }
  return { step: header.step, time: header.time, spreads: header.spreads, surfaces };
}
