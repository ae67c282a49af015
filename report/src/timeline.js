// Play, the slider, and the keys that do the same.
import { byId } from "./elements.js";

export function createTimeline(store, frames, textOf) {
  const slider = byId("frame"), play = byId("play"), text = byId("frame-text"), speed = byId("speed");
  let next = null; // when the next frame is due
  let asked = 0; // the animation frame that will look

  const say = () => {
    const index = store.get("frame");
    slider.max = String(Math.max(0, frames().length - 1));
    slider.value = String(index);
    slider.disabled = play.disabled = frames().length < 2;
    const words = frames().length ? textOf(frames()[index]) : "no frames";
    text.textContent = words;
    slider.setAttribute("aria-valuetext", words);
    slider.style.setProperty("--done", frames().length > 1 ? index / (frames().length - 1) : 0);
  };
  const go = (index) => store.set("frame", Math.max(0, Math.min(frames().length - 1, index)));

  const tick = (now) => {
    if (!store.get("playing")) return;
    const pause = 1000 / Number(speed.value);
    if (next === null) next = now;
    if (now >= next && !store.get("loading")) {
      next = Math.max(next + pause, now - pause);
      store.set("frame", (store.get("frame") + 1) % frames().length);
    }
    asked = requestAnimationFrame(tick);
  };
  store.on("playing", (isPlaying) => {
    play.textContent = isPlaying ? "❚❚" : "▶";
    play.setAttribute("aria-label", isPlaying ? "Pause" : "Play");
    cancelAnimationFrame(asked);
    next = null;
    if (isPlaying) asked = requestAnimationFrame(tick);
  });
  const toggle = () => frames().length > 1 && store.set("playing", !store.get("playing"));
  const pauseAt = (index) => {
    store.set("playing", false);
    go(index);
  };

  play.addEventListener("click", toggle);
  slider.addEventListener("input", () => pauseAt(Number(slider.value)));
  store.on("frame", say);
  return { say, go, pauseAt, toggle };
}

// The frame nearest to a step.
export function nearestFrame(frames, step) {
  let best = 0;
  frames.forEach((frame, index) => {
    if (Math.abs(frame.step - step) < Math.abs(frames[best].step - step)) best = index;
  });
  return best;
}
