// Builds ../static from the sources here: the same byte for byte from the same sources, so that what
// is committed can be checked. `npm ci && node build.mjs`.
import { build } from "esbuild";
import { copyFile, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "..", "static");
await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });

const { metafile } = await build({
  absWorkingDir: here,
  entryPoints: { viewer: "main.js" },
  outdir: out,
  bundle: true,
  format: "esm",
  target: ["chrome109", "firefox115", "safari16"],
  minify: true,
  // The notices stand in LICENSES.txt instead, whole.
  legalComments: "none",
  // An exported page holds the bundle in a script element, which this would end.
  charset: "ascii",
  metafile: true,
});
await build({
  absWorkingDir: here,
  entryPoints: { viewer: "style/main.css" },
  outdir: out,
  bundle: true,
  minify: true,
  target: ["chrome109", "firefox115", "safari16"],
});
for (const name of ["index.html", "icon.svg"]) await copyFile(join(here, name), join(out, name));

// Every package of which something is in the bundle, with its license.
const packages = new Set();
for (const input of Object.keys(metafile.inputs)) {
  const match = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
  if (match) packages.add(match[1]);
}
let licenses = "What is in viewer.js besides bodymeasure itself, which is under the MIT License.\n";
for (const name of [...packages].sort()) {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  const text = await readFile(join(folder, "LICENSE"), "utf8");
  licenses += `\n${"-".repeat(78)}\n${name} ${version} (${license})\n\n${text.replace(/\r\n/g, "\n").trim()}\n`;
}
await writeFile(join(out, "LICENSES.txt"), licenses);
