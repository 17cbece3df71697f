// In the page: what a fragment shader puts out, word by word.

import { base64, drawn, newContext, program } from "./webgl2.mjs";

let gl;

/** What `shader`, whose output is of `type`, puts out over the grid: `{ words }` in base64, or `{ error }`. */
export function grid({ shader, type, width, height }) {
  try {
    // One context for all files, and a new one after a file that cost us the last.
    if (gl?.isContextLost() ?? true) gl = newContext();
    if (!gl.getExtension("EXT_color_buffer_float")) throw new Error("there is no EXT_color_buffer_float");
    const [internal, format, component, words] = {
      uvec4: [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, Uint32Array],
      ivec4: [gl.RGBA32I, gl.RGBA_INTEGER, gl.INT, Int32Array],
      vec4: [gl.RGBA32F, gl.RGBA, gl.FLOAT, Float32Array],
    }[type];
    const pixels = new words(4 * width * height);
    const made = program(gl, shader);
    const bytes = drawn(gl, made, { width, height, internal, format, component, pixels });
    gl.deleteProgram(made);
    return { words: base64(bytes) };
  } catch (error) {
    return { error: error.message };
  }
}
