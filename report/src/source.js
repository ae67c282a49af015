// Where the data come from: the elements of this file, or, while a run goes on, the program that serves the page.
//
// The manifest's members: format, live, made, version, commit, directory, title, state, planned_steps, box {size, ends},
// scales {cell_m, step_s, density_kg_per_m3} or null, quantities [{name, si_unit}], frames [{step, time, triangles,
// spreads [[low, high]]}], notes, metrics {rows, every, columns [{name, data}]}, summary, plan, case, resolved, log.
import { bytesOf } from "./bytes.js";

export const readManifest = () => JSON.parse(document.getElementById("vesica-manifest").textContent);

const embeddedFrame = (step) => bytesOf(document.getElementById(`vesica-frame-${step}`).textContent);

async function servedFrame(step) {
  const answer = await fetch(`frame/${step}`);
  if (!answer.ok) throw new Error(`frame ${step}: ${answer.status} ${answer.statusText}`);
  return new Uint8Array(await answer.arrayBuffer());
}

// The bytes of one frame.
export const readFrame = async (manifest, step) => (manifest.live ? servedFrame(step) : embeddedFrame(step));

// Calls `use` with a new manifest whenever the run has gone on, `lost` when nobody answers any more.
export function follow(manifest, use, lost) {
  const pause = 1500; // under the program's patience with a page that went away (docs/report.md)
  let tag = "";
  let failures = 0;
  const ask = async () => {
    try {
      const answer = await fetch("manifest", { headers: tag ? { "If-None-Match": tag } : {}, cache: "no-store" });
      failures = 0;
      if (answer.status === 200) {
        tag = answer.headers.get("ETag") ?? "";
        use(await answer.json());
      }
    } catch {
      if (++failures === 3) return lost();
    }
    setTimeout(ask, pause);
  };
  if (manifest.live) setTimeout(ask, pause);
}
