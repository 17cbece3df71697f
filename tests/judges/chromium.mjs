// A headless Chromium that draws with Mesa's software GL, on a page of its own at http://localhost.
//
// Everything that asks for a picture goes through one browser: it takes a second to start, a page next to nothing.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { chromium } from "playwright-core";

const FLAGS = [
  "--no-sandbox", // containers and root have none to offer; nothing but our own pages is opened
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  // WebGL2 on Mesa; SwiftShader, the default, is ten times slower. Other systems have a GL of their own.
  ...(process.platform === "linux" ? ["--use-angle=gl-egl"] : []),
  "--ignore-gpu-blocklist",
  "--disable-gpu-watchdog", // a picture may take a software GPU longer than the ten seconds that it allows
  "--enable-unsafe-webgpu",
];

/** `cargo xtask judge` sets the variable to what it finds in PATH. */
const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";

const BLANK = '<!doctype html><html lang="en"><meta charset="utf-8"><title>Orogen\'s judges</title></html>';

/** Serves a blank page, and the modules of `page/`. */
function serve(request, answer) {
  const name = request.url.match(/^\/(\w+\.mjs)$/)?.[1];
  if (request.url === "/") answer.setHeader("content-type", "text/html").end(BLANK);
  else if (name) answer.setHeader("content-type", "text/javascript").end(readFileSync(new URL(`page/${name}`, import.meta.url)));
  else answer.writeHead(404).end();
}

/** What the function `name` of `page/module` comes to in the page. */
export function inPage(page, module, name, argument) {
  return page.evaluate(async ([module, name, argument]) => (await import(`/${module}`))[name](argument), [module, name, argument]);
}

/**
 * Runs `work(page, driver)` on a blank page at http://localhost (WebGPU asks for a secure origin), then closes everything.
 * `driver` is what draws WebGL2's pictures, in its own words.
 */
export async function inChromium(work) {
  const server = createServer(serve);
  await new Promise((ready) => server.listen(0, "localhost", ready));
  const env = { ...process.env, MESA_SHADER_CACHE_DISABLE: "true" }; // so that compile times are those of a first visit
  const browser = await chromium.launch({ executablePath: CHROMIUM, args: FLAGS, chromiumSandbox: false, env });
  try {
    const page = await browser.newPage();
    page.on("crash", () => console.error("the page crashed"));
    await page.goto(`http://localhost:${server.address().port}/`);
    const driver = await inPage(page, "webgl2.mjs", "driver");
    if (driver.includes("SwiftShader")) {
      throw new Error(`WebGL2 in Chromium is to draw with the system's GL, but has ${driver}: is Mesa's EGL here?`);
    }
    return await work(page, driver);
  } finally {
    await browser.close();
    server.close();
  }
}

/** What `promise` comes to, or an error once `seconds` have passed: a shader may never end. */
export async function within(seconds, promise) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no answer within ${seconds} s`)), 1000 * seconds);
  });
  try {
    return await Promise.race([promise, late]);
  } finally {
    clearTimeout(timer);
  }
}
