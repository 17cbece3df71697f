// In the page: fragment shaders over a whole target, in WebGL2.

const CORNERS =
  "#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }";

/** A context of its own: nothing that was compiled before is known in it. */
export function newContext() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) throw new Error("there is no WebGL2");
  return gl;
}

/** What draws the pictures, in its own words. */
export function driver() {
  const gl = newContext();
  const name = gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL);
  lose(gl);
  return name;
}

/** Gives a context's memory back: the page may have but 16. */
export function lose(gl) {
  gl.getExtension("WEBGL_lose_context")?.loseContext();
}

/** A program of `fragment`, compiled and linked, ready to draw with; throws what the compilers say. */
export function program(gl, fragment) {
  const made = gl.createProgram();
  const stages = [
    [gl.VERTEX_SHADER, CORNERS],
    [gl.FRAGMENT_SHADER, fragment],
  ].map(([stage, source]) => {
    const shader = gl.createShader(stage);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
    return shader;
  });
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) {
    const said = [...stages.map((shader) => gl.getShaderInfoLog(shader)), gl.getProgramInfoLog(made)];
    // The translator's log ends in a NUL.
    throw new Error(said.filter(Boolean).join("\n").replaceAll("\0", "").trim() || "refused without a word");
  }
  stages.forEach((shader) => gl.deleteShader(shader));
  return made;
}

/** What `made`, its uniforms set, draws into a target of the format `internal`: the bytes, from the bottom left. */
export function drawn(gl, made, { width, height, internal, format, component, pixels }) {
  const target = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, target);
  gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
  const frame = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  gl.viewport(0, 0, width, height);
  gl.useProgram(made);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  gl.readPixels(0, 0, width, height, format, component, pixels);
  const code = gl.getError();
  gl.deleteFramebuffer(frame);
  gl.deleteTexture(target);
  if (gl.isContextLost()) throw new Error("the context was lost");
  if (code) throw new Error(`GL error 0x${code.toString(16)}`);
  return new Uint8Array(pixels.buffer);
}

/** `bytes` as the driver of the browser takes them. */
export function base64(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(text);
}
