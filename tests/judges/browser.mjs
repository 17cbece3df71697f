// Draws shaders in Chromium: GLSL ES 3.00 through WebGL2 (Mesa), WGSL through WebGPU (SwiftShader).
//
//   node browser.mjs JOBS.json OUT_FOLDER
//
// JOBS.json is `{ width, height, jobs: [{ name, api, shader, interface?, shots, limit? }] }`:
//   api        "webgl2" or "webgpu"
//   shader     the file: a complete fragment shader in GLSL, or a WGSL module with a vertex and a fragment entry point
//   interface  what `orogen export --target json` says of it: where its uniform buffer is bound and what is in it. Without one
//              the shader has the uniforms of a Shadertoy page
//   shots      `{ time, delta, index, mouse }` each: seconds, seconds, the frame's number, and the mouse as iMouse
//   limit      milliseconds within which it is to compile. On a busy machine it gets three tries
//
// Picture number N goes to OUT_FOLDER/NAME.N.rgba: 8 bits a channel, row by row from the top, as the target holds them.
// OUT_FOLDER/results.json has `{ name, compile, draw }` of each job, in milliseconds, or `{ name, error }`.
// Exit status: 0 when there was something to draw and all of it was drawn, else 1.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";
import { inChromium, inPage, within } from "./chromium.mjs";

/** Seconds that one shader may take, with all its shots. */
const PATIENCE = 300;
const TRIES = 3;

/** The bytes of the uniform buffer `uniform` in a frame: its fields' own values, but for what the frame says. */
function block(uniform, { width, height }, { time, delta, index, mouse }) {
  const bytes = new DataView(new ArrayBuffer(Math.ceil(uniform.size / 16) * 16));
  const frame = {
    "frame.resolution": [width, height],
    "frame.time": time,
    "frame.delta": delta,
    "frame.index": index,
    "frame.mouse": mouse,
    "frame.jitter": [0, 0],
  };
  for (const { parameter, type, offset, value } of uniform.fields) {
    const set = { u32: "setUint32", i32: "setInt32" }[type] ?? "setFloat32";
    [frame[parameter] ?? value].flat().forEach((number, i) => bytes[set](offset + 4 * i, Number(number), true));
  }
  return [...new Uint8Array(bytes.buffer)];
}

/** What the page is told of `job`. */
function told(job, size) {
  const shader = readFileSync(job.shader, "utf8");
  if (!job.interface) return { ...size, shader, shots: job.shots };
  const { uniform, entry_points } = JSON.parse(readFileSync(job.interface, "utf8"));
  // In GLSL, the frame is uniforms of their own, and the page asks WebGL where in the block each field lies.
  const fields = (uniform?.fields ?? []).filter(({ parameter }) => !parameter.startsWith("frame."));
  const inGlsl = (shot) => ({ ...shot, variable: uniform?.name, fields });
  const inWgsl = (shot) => ({ block: uniform ? block(uniform, size, shot) : [] });
  const shots = job.shots.map(job.api === "webgl2" ? inGlsl : inWgsl);
  const entryPoints = Object.fromEntries(entry_points.map(({ stage, name }) => [stage, name]));
  return { ...size, shader, shots, uniform, entryPoints };
}

/** Draws `job`, again where it took longer to compile than it may: a machine has other things to do. */
async function drawn(page, job, size) {
  let best;
  for (let tries = 0; tries < TRIES; tries++) {
    const one = await within(PATIENCE, inPage(page, "picture.mjs", job.api, told(job, size)));
    if (!best || one.error || one.compile < best.compile) best = one;
    if (best.error || best.compile <= (job.limit ?? Infinity)) break;
  }
  return best;
}

const [list, to] = process.argv.slice(2);
if (!list || !to) {
  console.error("usage: node browser.mjs JOBS.json OUT_FOLDER");
  process.exit(2);
}
const { width, height, jobs } = JSON.parse(readFileSync(list, "utf8"));
mkdirSync(to, { recursive: true });
const results = [];
const begun = performance.now();
const queue = [...jobs];
/** Draws what is left of the queue, in a browser of its own: each compiles on one core. */
const worker = (isFirst) =>
  inChromium(async (page, driver) => {
    if (isFirst) console.log(`Chromium draws with ${driver}`);
    for (let job = queue.shift(); job; job = queue.shift()) {
      const start = performance.now();
      const { pictures = [], ...result } = await drawn(page, job, { width, height }).catch((error) => ({ error: error.message }));
      pictures.forEach((picture, i) => writeFileSync(join(to, `${job.name}.${i}.rgba`), Buffer.from(picture, "base64")));
      results.push({ name: job.name, ...result });
      const seconds = ((performance.now() - start) / 1000).toFixed(1);
      console.log(`${job.name}: ${result.error ?? `${Math.round(result.compile)} ms to compile, ${seconds} s in all`}`);
    }
  });
const browsers = Math.max(1, Math.min(availableParallelism(), jobs.length));
await Promise.all(Array.from({ length: browsers }, (_, i) => worker(i === 0)));
writeFileSync(join(to, "results.json"), JSON.stringify(results, null, 2));
const refused = results.filter((result) => result.error).length;
const seconds = ((performance.now() - begun) / 1000).toFixed(1);
console.log(`Chromium drew ${results.length - refused} of ${results.length} shaders in ${seconds} s`);
process.exitCode = results.length === 0 || refused > 0 ? 1 : 0;
