// Draws fragment shaders in Chromium (WebGL2 on Mesa) and writes down what they put out, bit by bit.
//
//   node matrix.mjs IN_FOLDER OUT_FOLDER [WIDTHxHEIGHT]
//
// Each NAME.frag of IN_FOLDER is a complete GLSL ES 3.00 fragment shader that reads nothing but gl_FragCoord and writes one
// `uvec4`, `ivec4` or `vec4`. It is drawn once for every pixel of a grid (64x64 if not told), into a target of 32 bits a
// channel, and goes to OUT_FOLDER/NAME.bin: 4 little-endian words a pixel, from the bottom left, row by row upward. What does
// not compile, or cannot be drawn, goes to OUT_FOLDER/NAME.err: the browser's own words.
//
// Exit status: 0 when there was something to draw and all of it was drawn, else 1.

import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { inChromium, inPage, within } from "./chromium.mjs";

/** Seconds that one file may take. */
const PATIENCE = 60;

/** `uvec4`, `ivec4` or `vec4`: the type of the first output that `shader` declares; undefined if there is none. */
function outputType(shader) {
  const bare = shader.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, " ");
  return bare.match(/\bout\s+(?:(?:lowp|mediump|highp)\s+)?([ui]?vec4)\s+\w+\s*;/)?.[1];
}

const [from, to, grid = "64x64"] = process.argv.slice(2);
const size = grid.match(/^([1-9]\d{0,3})x([1-9]\d{0,3})$/);
if (!from || !to || !size) {
  console.error("usage: node matrix.mjs IN_FOLDER OUT_FOLDER [WIDTHxHEIGHT]");
  process.exit(2);
}
const names = readdirSync(from).filter((name) => name.endsWith(".frag")).sort().map((name) => name.slice(0, -5));
mkdirSync(to, { recursive: true });
let refused = 0;
const start = performance.now();
await inChromium(async (page, driver) => {
  console.log(`Chromium draws with ${driver}`);
  for (const name of names) {
    const [bin, err] = [join(to, `${name}.bin`), join(to, `${name}.err`)];
    rmSync(bin, { force: true });
    rmSync(err, { force: true });
    const shader = readFileSync(join(from, `${name}.frag`), "utf8");
    const type = outputType(shader);
    const drawn = type
      ? await within(PATIENCE, inPage(page, "grid.mjs", "grid", { shader, type, width: +size[1], height: +size[2] }))
      : { error: "there is no output: `out uvec4`, `out ivec4` or `out vec4`" };
    if (drawn.words) writeFileSync(bin, Buffer.from(drawn.words, "base64"));
    else {
      refused++;
      writeFileSync(err, `${drawn.error.trim()}\n`);
      console.log(`${name}.frag: ${drawn.error.trim()}`);
    }
  }
});
const seconds = ((performance.now() - start) / 1000).toFixed(1);
console.log(`Chromium drew ${names.length - refused} of ${names.length} shaders in ${seconds} s`);
if (names.length === 0) console.log(`nothing to draw: there is no .frag file in ${from}`);
process.exitCode = names.length === 0 || refused > 0 ? 1 : 0;
