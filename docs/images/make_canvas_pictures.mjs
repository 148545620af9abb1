// Makes docs/images/canvas_*.png, figures 4.5 to 4.7 of the thesis as the live view shows them:
// node docs/images/make_canvas_pictures.mjs, after ./check has built everything. The robot and its
// layers are examples/canvas/layers.cpp. Takes some minutes where a processor has to draw.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";

const require = createRequire(new URL("../../tests/web/package.json", import.meta.url));
const { chromium } = require("playwright-core");
const root = new URL("../../", import.meta.url).pathname;
const SECONDS = "34"; // of simulated time

const simulator = spawn(`${root}build/release/bin/ccmorse`,
  ["run", "syrotek", "--pace", "lockstep", "--port", "0", "--no-player",
    "--out", tmpdir()]);
const [port, address] = await new Promise((resolve) => {
  let output = "";
  simulator.stdout.on("data", (data) => {
    output += data;
    const services = /^MORSE services on \S+ port (\d+)/m.exec(output);
    const view = /^View at (\S+)$/m.exec(output);
    if (services !== null && view !== null) resolve([services[1], view[1]]);
  });
});
const program = spawn(`${root}build/release/bin/layers`, [port, SECONDS], { stdio: "inherit" });
await new Promise((resolve) => program.on("exit", resolve));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader"],
});
try {
  const page = await browser.newPage({ viewport: { width: 960, height: 600 } });
  page.setDefaultTimeout(300_000);
  await page.goto(`${address}?quality=high`);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  await page.evaluate(() => window.ccmorse.look([1.72, -1.1, 3.6], [1.72, 1.75, 0]));
  await page.keyboard.press("h"); // the panel is not what this is about
  for (const mode of ["ground", "minimap", "fullscreen"]) {
    if (mode !== "ground") await page.keyboard.press("Control+ArrowUp");
    const from = await page.evaluate(() => window.ccmorse.frames());
    await page.waitForFunction((n) => window.ccmorse.frames() > n + 2, from);
    await page.screenshot({ path: `${root}docs/images/canvas_${mode}.png` });
  }
} finally {
  await browser.close();
  simulator.kill("SIGINT");
}
