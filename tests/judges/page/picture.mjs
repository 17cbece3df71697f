// In the page: what a fragment shader draws, as 8 bits a channel, through WebGL2 or WebGPU.

import { base64, drawn, lose, newContext, program } from "./webgl2.mjs";

/** Rows of `bytes` in the opposite order. */
function flipped(bytes, row) {
  const turned = new Uint8Array(bytes.length);
  for (let at = 0; at < bytes.length; at += row) turned.set(bytes.subarray(at, at + row), bytes.length - row - at);
  return turned;
}

/** Sets what Shadertoy tells a shader. */
function setShadertoy(gl, made, { width, height, time, delta, index, mouse }) {
  const at = (name) => gl.getUniformLocation(made, name);
  gl.useProgram(made);
  gl.uniform3f(at("iResolution"), width, height, 1);
  gl.uniform1f(at("iTime"), time);
  gl.uniform1f(at("iTimeDelta"), delta);
  gl.uniform1f(at("iFrameRate"), 1 / delta);
  gl.uniform1i(at("iFrame"), index);
  gl.uniform4f(at("iMouse"), ...mouse);
}

/** Sets the frame's uniforms. */
function setFrame(gl, made, { width, height, time, delta, index, mouse }) {
  const at = (name) => gl.getUniformLocation(made, name);
  gl.useProgram(made);
  gl.uniform2f(at("u_resolution"), width, height);
  gl.uniform1f(at("u_time"), time);
  gl.uniform1f(at("u_delta"), delta);
  gl.uniform1i(at("u_frame"), index);
  gl.uniform4f(at("u_mouse"), ...mouse);
}

/** Binds the one uniform block of `made`, where it has one, with the values of `fields`, which are members of `variable`. */
function bindBlock(gl, made, variable, fields) {
  if (gl.getProgramParameter(made, gl.ACTIVE_UNIFORM_BLOCKS) === 0) return;
  const size = gl.getActiveUniformBlockParameter(made, 0, gl.UNIFORM_BLOCK_DATA_SIZE);
  const bytes = new DataView(new ArrayBuffer(size));
  const indices = gl.getUniformIndices(made, fields.map(({ name }) => `${variable}.${name}`));
  const offsets = gl.getActiveUniforms(made, indices.filter((index) => index !== gl.INVALID_INDEX), gl.UNIFORM_OFFSET);
  let at = 0;
  fields.forEach(({ name, type, value }, n) => {
    if (indices[n] === gl.INVALID_INDEX) throw new Error(`the block has no field ${variable}.${name}`);
    const set = { u32: "setUint32", i32: "setInt32" }[type] ?? "setFloat32";
    [value].flat().forEach((number, i) => bytes[set](offsets[at] + 4 * i, Number(number), true));
    at++;
  });
  gl.uniformBlockBinding(made, 0, 0);
  gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, gl.createBuffer());
  gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.STATIC_DRAW);
}

/**
 * Draws `shader`, GLSL ES 3.00, once for each of `shots`. `{ compile, draw, pictures }`: milliseconds until it was linked and
 * until all was drawn, and RGBA in base64 from the top left; or `{ error }`. A shot is a frame; with
 * `fields`, values of members of the uniform block's `variable`, its uniforms are those of a GLSL file, else Shadertoy's.
 */
export function webgl2({ shader, width, height, shots }) {
  let gl;
  try {
    gl = newContext();
    const start = performance.now();
    const made = program(gl, shader);
    const linked = performance.now();
    const pictures = shots.map((shot) => {
      if (shot.fields) {
        setFrame(gl, made, { width, height, ...shot });
        bindBlock(gl, made, shot.variable, shot.fields);
      } else setShadertoy(gl, made, { width, height, ...shot });
      const pixels = new Uint8Array(4 * width * height);
      const target = { internal: gl.RGBA8, format: gl.RGBA, component: gl.UNSIGNED_BYTE, pixels };
      return base64(flipped(drawn(gl, made, { width, height, ...target }), 4 * width));
    });
    return { compile: linked - start, draw: performance.now() - linked, pictures };
  } catch (error) {
    return { error: error.message };
  } finally {
    if (gl) lose(gl);
  }
}

/** As `webgl2`, of a WGSL module with a vertex and a fragment entry point; `uniform` is where its uniform buffer is bound. */
export async function webgpu({ shader, width, height, shots, uniform, entryPoints }) {
  try {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) throw new Error("there is no WebGPU adapter");
    const device = await adapter.requestDevice();
    const start = performance.now();
    const module = device.createShaderModule({ code: shader });
    const pipeline = await device.createRenderPipelineAsync({
      layout: "auto",
      vertex: { module, entryPoint: entryPoints.vertex },
      fragment: { module, entryPoint: entryPoints.fragment, targets: [{ format: "rgba8unorm" }] },
    });
    const linked = performance.now();
    const size = [width, height];
    const row = Math.ceil((4 * width) / 256) * 256; // as WebGPU wants rows of a buffer aligned
    const pictures = [];
    for (const { block } of shots) {
      device.pushErrorScope("validation");
      const texture = device.createTexture({ size, format: "rgba8unorm", usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC });
      const copy = device.createBuffer({ size: row * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
      const commands = device.createCommandEncoder();
      const pass = commands.beginRenderPass({ colorAttachments: [{ view: texture.createView(), loadOp: "clear", storeOp: "store" }] });
      pass.setPipeline(pipeline);
      if (uniform) {
        const buffer = device.createBuffer({ size: block.length, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
        device.queue.writeBuffer(buffer, 0, new Uint8Array(block));
        const entries = [{ binding: uniform.binding, resource: { buffer } }];
        pass.setBindGroup(uniform.group, device.createBindGroup({ layout: pipeline.getBindGroupLayout(uniform.group), entries }));
      }
      pass.draw(3);
      pass.end();
      commands.copyTextureToBuffer({ texture }, { buffer: copy, bytesPerRow: row }, size);
      device.queue.submit([commands.finish()]);
      const refused = await device.popErrorScope();
      if (refused) throw new Error(refused.message);
      await copy.mapAsync(GPUMapMode.READ);
      const rows = new Uint8Array(copy.getMappedRange());
      const bytes = new Uint8Array(4 * width * height);
      for (let y = 0; y < height; y++) bytes.set(rows.subarray(row * y, row * y + 4 * width), 4 * width * y);
      pictures.push(base64(bytes));
    }
    const drawn = performance.now() - linked;
    device.destroy();
    return { compile: linked - start, draw: drawn, pictures };
  } catch (error) {
    return { error: error.message };
  }
}
