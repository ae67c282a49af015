// Bundles src/ into one page: node build.mjs [PAGE]. Nothing in it refers to another file or to the network.
import { build } from "esbuild";
import { mkdirSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const target = process.argv[2] ?? join(here, "dist", "report.html");

const bundle = async (entry, format) => {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    format,
    target: ["chrome100", "firefox100", "safari15.4"],
    legalComments: "none",
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
};

// A closing tag inside a string would end the element early.
const script = (await bundle("main.js", "iife")).replaceAll("</script", "<\\/script");
const style = await bundle("style.css");
const licences = ["three/LICENSE", "uplot/LICENSE", "meshoptimizer/LICENSE.md"]
  .map((file) => `${file.split("/")[0]}\n\n${readFileSync(join(here, "node_modules", file), "utf8").trim()}`)
  .join("\n\n\n")
  .replaceAll("<", "&lt;");
const page = readFileSync(join(here, "src", "page.html"), "utf8")
  .replace("<!--style-->", () => `<style>${style}</style>`)
  .replace("<!--licences-->", () => licences)
  .replace("<!--script-->", () => `<script>${script}</script>`);

mkdirSync(dirname(target), { recursive: true });
writeFileSync(`${target}.partial`, page);
renameSync(`${target}.partial`, target);
