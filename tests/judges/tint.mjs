// Judges WGSL with Tint, the compiler in Chrome, through Dawn's null back end: no GPU, no browser.
//
//   node tint.mjs FILE.wgsl|FOLDER…
//
// Prints `file:line:column: severity: message` for everything that Tint has to say; columns count UTF-16 units, as
// WebGPU's do. Exit status: 0 when there was something to judge and not one error or warning, else 1.
//
// Each file is judged in three ways:
// 1. as it stands;
// 2. with its overrides turned into constants of their default values, since the null back end does not evaluate an
//    override that a fragment shader reads: a division by zero would only show on a real GPU;
// 3. as pipelines, one for each fragment or compute entry point: only there are bindings, limits and the interface
//    between the stages checked.

import { readFileSync, readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { create, globals } from "webgpu";

/** The files among `paths`, and the `.wgsl` files in the folders among them. */
function wgslFiles(paths) {
  return paths.flatMap((path) => {
    const found = statSync(path, { throwIfNoEntry: false });
    if (!found) {
      console.error(`there is no file or folder ${path}`);
      process.exit(1);
    }
    if (!found.isDirectory()) return [path];
    const inside = readdirSync(path, { recursive: true }).sort();
    return inside.filter((name) => name.endsWith(".wgsl")).map((name) => join(path, name));
  });
}

/** `code` with each comment blanked: what is left keeps its line and column. Block comments nest. */
function withoutComments(code) {
  const blank = (text) => text.replace(/[^\r\n]/g, " ");
  let bare = "";
  for (let at = 0; at < code.length; ) {
    let end = at + 1;
    const comment = code.startsWith("//", at) || code.startsWith("/*", at);
    if (code.startsWith("//", at)) {
      while (end < code.length && !/[\n-\r\u0085\u2028\u2029]/.test(code[end])) end++;
    } else if (code.startsWith("/*", at)) {
      let depth = 0;
      end = at;
      do {
        if (code.startsWith("/*", end)) (depth++, (end += 2));
        else if (code.startsWith("*/", end)) (depth--, (end += 2));
        else end++;
      } while (depth > 0 && end < code.length);
    }
    bare += comment ? blank(code.slice(at, end)) : code.slice(at, end);
    at = end;
  }
  return bare;
}

/** `bare` with its overrides as constants, or null where it has none. An override without a default stays one. */
function withConstants(bare) {
  const override = /(?:@id\s*\([^)]*\)\s*)?\boverride\b(?=[^;]*=)/g;
  const constant = (found) => found.replace(/\S/g, " ").slice(0, -5) + "const";
  return override.test(bare) ? bare.replace(override, constant) : null;
}

/** Line and column of `offset` in `code`, from 1. */
function position(code, offset) {
  const lines = code.slice(0, offset).split("\n");
  return [lines.length, lines.at(-1).length + 1];
}

/** The entry points of `bare`: `{ stage, name, line, column, format }`, the last being what a fragment's colour fits. */
function entryPoints(bare) {
  const found = bare.matchAll(
    /@(vertex|fragment|compute)\b[^{};]*?\bfn\s+([\p{XID_Start}_][\p{XID_Continue}]*)([^{;]*)/gu,
  );
  return [...found].map((at) => {
    const [line, column] = position(bare, at.index);
    const integers = /->\s*@location\(0\)\s*vec4(?:([iu])|<([iu])32>)/.exec(at[3]);
    const format = { i: "rgba32sint", u: "rgba32uint" }[integers?.[1] ?? integers?.[2]] ?? "rgba16float";
    return { stage: at[1], name: at[2], line, column, format };
  });
}

/** What Tint says of `code`: `{ module, messages }`, each message `{ line, column, severity, text }`. */
async function compile(device, code) {
  device.pushErrorScope("validation"); // the same text comes again, with its place, from getCompilationInfo
  const module = device.createShaderModule({ code });
  const { messages } = await module.getCompilationInfo();
  const refused = await device.popErrorScope();
  const said = messages.map((m) => ({ line: m.lineNum, column: m.linePos, severity: m.type, text: m.message }));
  if (refused && !said.some((m) => m.severity === "error")) {
    said.push({ line: 1, column: 1, severity: "error", text: refused.message.trim() });
  }
  return { module, messages: said };
}

/** What Dawn says of the pipelines of `module`, in the form of `compile`'s messages. */
async function buildPipelines(device, module, entries) {
  // A fragment entry point gets the file's own vertex stage, else this one, which passes on the position and no more.
  const bareVertex = device.createShaderModule({
    code: "@vertex fn corner() -> @builtin(position) vec4f { return vec4f(); }",
  });
  const ownVertex = entries.find((entry) => entry.stage === "vertex");
  const vertex = ownVertex ? { module, entryPoint: ownVertex.name } : { module: bareVertex, entryPoint: "corner" };
  const messages = [];
  for (const { stage, name, line, column, format } of entries) {
    const shader = { module, entryPoint: name };
    const targets = [{ format }];
    try {
      if (stage === "compute") await device.createComputePipelineAsync({ layout: "auto", compute: shader });
      if (stage === "fragment") {
        await device.createRenderPipelineAsync({ layout: "auto", vertex, fragment: { ...shader, targets } });
      }
    } catch (error) {
      messages.push({ line, column, severity: "error", text: `no pipeline: ${error.message.trim()}` });
    }
  }
  return messages;
}

/** Everything that is said of `code`, without repeats. */
async function judge(device, code) {
  const bare = withoutComments(code);
  const { module, messages } = await compile(device, code);
  if (messages.some((m) => m.severity === "error")) return messages;
  const constants = withConstants(bare);
  if (constants) {
    for (const said of (await compile(device, constants)).messages) {
      const known = messages.some((m) => m.line === said.line && m.column === said.column && m.text === said.text);
      if (!known) messages.push({ ...said, text: `${said.text} (overrides at their defaults)` });
    }
  }
  return messages.concat(await buildPipelines(device, module, entryPoints(bare)));
}

Object.assign(globalThis, globals);
const files = wgslFiles(process.argv.slice(2));
globalThis.gpu = create(["backend=null"]); // held, since Dawn ends with its last reference and takes the device along
const device = await (await gpu.requestAdapter()).requestDevice();
let wrong = 0;
for (const file of files) {
  const messages = await judge(device, readFileSync(file, "utf8"));
  for (const { line, column, severity, text } of messages) {
    console.log(`${file}:${line}:${column}: ${severity}: ${text.replaceAll("\n", "\n    ")}`);
  }
  if (messages.some((m) => m.severity !== "info")) wrong++;
}
device.destroy();
delete globalThis.gpu;
console.log(`Tint judged ${files.length} WGSL files: ${wrong} with errors or warnings`);
if (files.length === 0) console.log("nothing to judge: name .wgsl files, or folders that hold some");
process.exitCode = files.length === 0 || wrong > 0 ? 1 : 0;
