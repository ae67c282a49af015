// The decoded frames that were looked at last, and the next one while there is time.
import { decodeFrame, decoderReady } from "./frame.js";
import { readFrame } from "./source.js";

const kept = 48;

export function createFrames(manifest, cell) {
  const cache = new Map(); // step -> promise of a frame, the oldest first
  const load = (step) => {
    let frame = cache.get(step);
    if (frame) cache.delete(step);
    else
      frame = Promise.all([readFrame(manifest, step), decoderReady]).then(([bytes]) => decodeFrame(bytes, cell));
    frame.catch(() => cache.delete(step));
    cache.set(step, frame);
    if (cache.size > kept) cache.delete(cache.keys().next().value);
    return frame;
  };
  return { load };
}
