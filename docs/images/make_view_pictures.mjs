// Makes docs/images/view.png and view-plots.png from the live view itself: node docs/images/make_view_pictures.mjs, after
// ./check has built everything. Takes a minute where a processor has to draw.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";

const require = createRequire(new URL("../../tests/web/package.json", import.meta.url));
const { chromium } = require("playwright-core");
const root = new URL("../../", import.meta.url).pathname;

// Where robots stand for the picture: x, y in m, yaw in rad.
const PLACES = {
  s1r_1: [1.2, 2.0, 2.6],
  s1r_2: [0.75, 2.75, -0.6],
  s1r_3: [2.1, 2.5, -2.4],
  s1r_4: [1.95, 1.85, 1.2],
  s1r_5: [2.65, 2.0, 2.0],
};

const simulator = spawn(`${root}build/release/bin/ccmorse`, ["run", "docks", "--port", "0"]);
const address = await new Promise((resolve) => {
  let output = "";
  simulator.stdout.on("data", (data) => {
    output += data;
    const found = /^View at (\S+)$/m.exec(output);
    if (found !== null) resolve(found[1]);
  });
});
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader"],
});
try {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  page.setDefaultTimeout(300_000);
  await page.goto(`${address}?quality=high`);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  for (const [robot, [x, y, yaw]] of Object.entries(PLACES)) {
    await page.evaluate((args) => window.ccmorse.call("simulation", "set_object_position", args),
      [robot, [x, y, 0], [0, 0, yaw]]);
  }
  await page.evaluate(() => window.ccmorse.look([1.05, 0.15, 1.75], [1.62, 2.1, 0]));
  const from = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 4, from);
  await page.screenshot({ path: `${root}docs/images/view.png` });

  // Dark, plain, and a robot that drives, with plots and devices open.
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto(`${address}?quality=low`);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  await page.evaluate(() => {
    window.ccmorse.look([1.05, 0.15, 1.75], [1.62, 2.1, 0]);
    document.getElementById("plots").open = true;
    return window.ccmorse.call("s1r_1.motion", "set_speed", [0.12, -0.6]);
  });
  await page.locator("#devices > summary").click();
  await page.locator("#device-tree summary", { hasText: /^pose/ }).first().click();
  const start = await page.evaluate(() => window.ccmorse.frame().time);
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 6, start);
  await page.evaluate(() => window.ccmorse.call("s1r_1.motion", "set_speed", [0.05, 0.6]));
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 12, start);
  await page.locator("#plots").evaluate((plots) => plots.scrollIntoView());
  await page.waitForTimeout(500);
  await page.screenshot({ path: `${root}docs/images/view-plots.png` });
} finally {
  await browser.close();
  simulator.kill("SIGINT");
}
