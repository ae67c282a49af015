// The page from start to end: what there is, the stage, the plots, the tables.
import { showFiles, showGroups } from "./case.js";
import { createColumns } from "./columns.js";
import { byId, element } from "./elements.js";
import { listenToKeys } from "./keys.js";
import { Metrics } from "./metrics.js";
import { grouped, prefixFor, short } from "./numbers.js";
import { Plots } from "./plots.js";
import { follow, readManifest } from "./source.js";
import { showVesicles, Stage } from "./stage.js";
import { createStore } from "./store.js";
import { createTheme } from "./theme.js";
import { createTimeline, nearestFrame } from "./timeline.js";
import { showTimings, showVerdicts } from "./verdicts.js";

const states = { finished: "finished", steady: "steady", stopped: "stopped early", failed: "failed", running: "running", interrupted: "interrupted" };

function showHeader(manifest) {
  byId("title").textContent = manifest.title || manifest.directory;
  byId("directory").textContent = manifest.directory;
  document.title = `${manifest.title || manifest.directory} – Vesica`;
  const badges = [element("span", { class: `badge state-${manifest.state}` }, states[manifest.state] ?? manifest.state)];
  const verdicts = manifest.summary?.verdicts ?? [];
  if (verdicts.length) {
    const passed = verdicts.filter((verdict) => verdict.passed).length;
    badges.push(element("a", { href: "#verdicts", class: `badge ${passed === verdicts.length ? "good" : "bad"}` }, `${passed} of ${verdicts.length} verdicts passed`));
  }
  byId("badges").replaceChildren(...badges);
  byId("notes").replaceChildren(...manifest.notes.map((note) => element("p", { class: "notice" }, note)));
  byId("made").textContent = `Made ${manifest.made.replace("T", " ").replace("Z", " UTC")} by vesica ${manifest.version} (${manifest.commit}). Numbers of plots are in lattice units.`;
}

// Times beside steps, where the case has scales.
function clockOf(manifest) {
  if (!manifest.scales) return { factor: 1, unit: "", text: () => "" };
  const last = Math.max(manifest.planned_steps ?? 0, ...manifest.frames.map(({ step }) => step), 1);
  const [size, prefix] = prefixFor(last * manifest.scales.step_s);
  const factor = manifest.scales.step_s / size;
  return { factor, unit: `${prefix}s`, text: ({ step }) => ` · ${short(step * factor, 4)} ${prefix}s` };
}

function start() {
  performance.mark("vesica-start"); // the file is read and parsed
  let manifest = readManifest();
  let metrics = new Metrics(manifest.metrics);
  const clock = clockOf(manifest);
  const store = createStore({ frame: 0, step: 0, playing: false, loading: false, colour: "mean_curvature", range: "run", hidden: new Set(), against: "step", dark: false });
  const theme = createTheme(store);
  showHeader(manifest);

  const frames = () => manifest.frames;
  const stage = new Stage(store, manifest, clock.text);
  const timeline = createTimeline(store, frames, (frame) => `${grouped(frame.step)}${clock.text(frame)}`);
  store.on("frame", (index) => frames()[index] && store.set("step", frames()[index].step));

  const plots = new Plots(byId("cards"), store, clock, (step) => frames().length && timeline.pauseAt(nearestFrame(frames(), step)));
  if (clock.unit) byId("against").append(element("option", { value: "time" }, `time, ${clock.unit}`));
  byId("against").addEventListener("change", () => store.set("against", byId("against").value));
  if (metrics.steps.length) {
    plots.use(metrics);
    createColumns(metrics, (names) => plots.choose(names));
  } else {
    byId("plots").classList.add("bare");
    byId("cards").append(element("p", { class: "empty" }, "There is no sample in metrics.csv yet."));
  }
  showVesicles(store, metrics.vesicles);
  listenToKeys({ store, timeline, frames, view: () => stage.view, nextColour: () => stage.nextColour(), toggleBox: () => stage.view && stage.toggleBox(), toggleDark: theme.toggle });

  store.set("frame", Math.max(0, frames().length - 1));
  timeline.say();
  const tables = () => {
    showVerdicts(byId("verdicts-body"), manifest);
    showTimings(byId("timings-body"), manifest);
    showGroups(byId("groups-body"), manifest);
    showFiles(byId("files-body"), manifest);
  };
  tables();

  const grow = (newer) => {
    const index = store.get("frame");
    const step = frames()[index]?.step;
    const wasLast = index >= frames().length - 1;
    const hadSamples = metrics.steps.length > 0;
    if (!manifest.box && newer.box) return location.reload(); // the page was opened before the run had begun
    Object.assign(manifest, newer);
    metrics = new Metrics(manifest.metrics);
    showHeader(manifest);
    plots.use(metrics);
    if (!hadSamples && metrics.steps.length) {
      byId("plots").classList.remove("bare");
      byId("cards").replaceChildren();
      createColumns(metrics, (names) => plots.choose(names));
      showVesicles(store, metrics.vesicles);
    }
    // Long runs offer every n-th frame, with n growing: a reader stays at the step, wherever it is among them now.
    if (wasLast && !store.get("playing")) timeline.go(frames().length - 1);
    else if (step !== undefined) timeline.go(nearestFrame(frames(), step));
    if (store.get("frame") === index && frames()[index]?.step !== step) { // the first there is, or another in its place
      store.set("step", frames()[index].step);
      stage.showFrame();
    }
    timeline.say();
    if (manifest.summary) tables();
  };
  follow(manifest, grow, () => {
    const words = manifest.summary ? "The run has ended. " : "The program that runs this no longer answers. ";
    byId("notes").prepend(element("p", { class: "notice" }, `${words}\`vesica report DIR\` makes a page that stays.`));
  });

  // For tests and the curious: what the page holds.
  window.vesica = { store, manifest, get metrics() { return metrics; }, plots, stage, grow };
  performance.mark("vesica-tables");
  // Everything else is on the screen before the 3D view asks for the graphics.
  requestAnimationFrame(() => setTimeout(() => {
    stage.open();
    performance.mark("vesica-usable");
  }));
}

try {
  start();
} catch (error) {
  byId("notes").append(element("p", { class: "notice" }, `This page cannot be shown: ${error.message}`));
  throw error;
}
