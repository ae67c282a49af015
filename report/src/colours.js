// Colour scales as anchors in sRGB, equally spaced. Values of both signs get the diverging one, with zero in its middle.
const scales = {
  // viridis (van der Walt and Smith 2015)
  sequential: ["#440154", "#482777", "#3f4a8a", "#31678e", "#26838f", "#1f9d8a", "#6cce5a", "#b6de2b", "#fee825"],
  // cool to warm (Moreland 2009), with a lighter middle
  diverging: ["#2b4cb8", "#5a7fe0", "#8fb2f6", "#c3d5f4", "#f0ece8", "#f6c6ad", "#ec9076", "#d1543f", "#a3142c"],
};

// Of vesicles: after Okabe and Ito (2008), which people with colour blindness tell apart; in style.css, as they differ by theme.
const vesicleColours = 8;
export const vesicleVariable = (index) => `var(--vesicle-${index % vesicleColours})`;
export const vesicleColour = (index) => getComputedStyle(document.documentElement).getPropertyValue(`--vesicle-${index % vesicleColours}`).trim();

const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

// Bytes r, g, b, a of `count` steps along a scale, or the part of it from `begin` to `end` (0 to 1).
export function ramp(name, begin = 0, end = 1, count = 256) {
  const anchors = scales[name].map(channels);
  const bytes = new Uint8Array(4 * count);
  for (let i = 0; i < count; ++i) {
    const place = (begin + (end - begin) * (i / (count - 1))) * (anchors.length - 1);
    const lower = Math.min(Math.floor(place), anchors.length - 2);
    for (let k = 0; k < 3; ++k)
      bytes[4 * i + k] = Math.round(anchors[lower][k] + (place - lower) * (anchors[lower + 1][k] - anchors[lower][k]));
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

// The scale for values from low to high: its name, and the part of it they take. Zero keeps the middle of the diverging one.
export function colourRange(low, high) {
  if (!(high > low)) {
    const margin = Math.abs(low) * 1e-3 || 1e-12;
    return { low: low - margin, high: low + margin, scale: "sequential", begin: 0, end: 1 };
  }
  const most = Math.max(Math.abs(low), Math.abs(high));
  const signs = low < 0 && high > 0 && Math.min(-low, high) > 0.05 * most;
  if (!signs) return { low, high, scale: "sequential", begin: 0, end: 1 };
  return { low, high, scale: "diverging", begin: 0.5 + (0.5 * low) / most, end: 0.5 + (0.5 * high) / most };
}
