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
import { inChromium, within } from "./chromium.mjs";

/** Seconds that one file may take. */
const PATIENCE = 60;

/** `uvec4`, `ivec4` or `vec4`: the type of the first output that `shader` declares; undefined if there is none. */
function outputType(shader) {
  const bare = shader.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, " ");
  return bare.match(/\bout\s+(?:(?:lowp|mediump|highp)\s+)?([ui]?vec4)\s+\w+\s*;/)?.[1];
}

/** Runs in the page: what `shader` puts out over the grid, `{ words }` in base64, or `{ error }`. */
function draw({ shader, type, width, height }) {
  // One context for all files, and a new one after a file that cost us the last.
  if (globalThis.gl?.isContextLost() ?? true) globalThis.gl = document.createElement("canvas").getContext("webgl2");
  const gl = globalThis.gl;
  if (!gl) return { error: "there is no WebGL2" };
  if (!gl.getExtension("EXT_color_buffer_float")) return { error: "there is no EXT_color_buffer_float" };
  const program = gl.createProgram();
  const corners = "#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }";
  const stages = [
    [gl.VERTEX_SHADER, corners],
    [gl.FRAGMENT_SHADER, shader],
  ].map(([stage, source]) => {
    const compiled = gl.createShader(stage);
    gl.shaderSource(compiled, source);
    gl.compileShader(compiled);
    gl.attachShader(program, compiled);
    return compiled;
  });
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
    const said = [...stages.map((stage) => gl.getShaderInfoLog(stage)), gl.getProgramInfoLog(program)];
    return { error: said.filter(Boolean).join("\n") || "refused without a word" };
  }
  const [internal, format, component, words] = {
    uvec4: [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array],
    ivec4: [gl.RGBA32I, gl.RGBA_INTEGER, gl.INT, Int32Array],
    vec4: [gl.RGBA32F, gl.RGBA, gl.FLOAT, Float32Array],
  }[type];
  const target = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, target);
  gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  gl.viewport(0, 0, width, height);
  gl.useProgram(program);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new words(4 * width * height);
  gl.readPixels(0, 0, width, height, format, component, pixels);
  const fault = gl.isContextLost() ? "the context was lost" : gl.getError();
  gl.deleteFramebuffer(frame);
  gl.deleteTexture(target);
  stages.forEach((stage) => gl.deleteShader(stage));
  gl.deleteProgram(program);
  if (fault) return { error: `drawn as ${type}: ${fault}` };
  let bytes = "";
  for (const byte of new Uint8Array(pixels.buffer)) bytes += String.fromCharCode(byte);
  return { words: btoa(bytes) };
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
      ? await within(PATIENCE, page.evaluate(draw, { shader, type, width: +size[1], height: +size[2] }))
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
