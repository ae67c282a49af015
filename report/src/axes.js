// The little cross of axes in a corner of the view.
import { Vector3 } from "three";

const colours = ["#d2493f", "#3c9a57", "#3f79d0"];

export function drawAxes(svg, camera) {
  const turned = camera.quaternion.clone().invert();
  const ends = ["x", "y", "z"].map((name, axis) => {
    const end = new Vector3().setComponent(axis, 1).applyQuaternion(turned);
    return { name, colour: colours[axis], x: 25 * end.x, y: -25 * end.y, depth: end.z };
  });
  ends.sort((a, b) => a.depth - b.depth);
  svg.innerHTML = ends
    .map(({ name, colour, x, y }) =>
      `<line x2="${x.toFixed(1)}" y2="${y.toFixed(1)}" stroke="${colour}"/><text x="${(1.3 * x).toFixed(1)}" y="${(1.3 * y).toFixed(1)}" fill="${colour}">${name}</text>`)
    .join("");
}
