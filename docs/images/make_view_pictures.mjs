// Makes docs/images/view.png, view-obstacles.png, view-plots.png and view-sights.png from the live view itself:
// node docs/images/make_view_pictures.mjs, after ./check has built everything. Takes a minute where a processor has to draw.
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

const simulators = [];

/** Runs a scenario; the address of its view. */
function run(scenario) {
  const simulator = spawn(`${root}build/release/bin/ccmorse`,
    ["run", scenario, "--port", "0", "--stream-port", "0", "--view-port", "0", "--no-player"]);
  simulators.push(simulator);
  return new Promise((resolve) => {
    let output = "";
    simulator.stdout.on("data", (data) => {
      output += data;
      const found = /^View at (\S+)$/m.exec(output);
      if (found !== null) resolve(found[1]);
    });
  });
}

const address = await run("docks");
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
  const placeRobots = async () => {
    for (const [robot, [x, y, yaw]] of Object.entries(PLACES)) {
      await page.evaluate((args) => window.ccmorse.call("simulation", "set_object_position", args),
        [robot, [x, y, 0], [0, 0, yaw]]);
    }
  };
  await placeRobots();
  await page.evaluate(() => window.ccmorse.look([1.05, 0.15, 1.75], [1.62, 2.1, 0]));
  const from = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 4, from);
  await page.screenshot({ path: `${root}docs/images/view.png` });

  // Obstacles are changed: some stand, one waits for a robot to leave, a rubber band is drawn.
  await page.evaluate(async () => {
    const arena = (service, args) => window.ccmorse.call("arena", service, args);
    await arena("raise", [[66, 67, 68, 74]]);
    await arena("save_preset", ["corner"]);
    await arena("move", [71, 1.3, 2.03]);
    await arena("raise", [[71, 73]]);
    window.ccmorse.look([1.4, 0.3, 2.6], [1.72, 2.05, 0]);
  });
  await page.keyboard.press("o");
  await page.locator("#obstacles").evaluate((section) => section.scrollIntoView());
  const before = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 2, before);
  const [at, to] = await page.evaluate(() => [window.ccmorse.findBox(70), window.ccmorse.findBox(69)]);
  await page.mouse.move(Math.min(at.x, to.x) - 60, Math.min(at.y, to.y) - 45);
  await page.mouse.down();
  await page.mouse.move(Math.max(at.x, to.x) + 60, Math.max(at.y, to.y) + 40);
  await page.waitForTimeout(1000);
  await page.screenshot({ path: `${root}docs/images/view-obstacles.png` });
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await page.evaluate(() => window.ccmorse.call("simulation", "reset_objects", []));

  // Dark, plain, and a robot that drives, with plots and devices open.
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto(`${address}?quality=low`);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  await placeRobots();
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

  // What a camera and a radar see into.
  await page.emulateMedia({ colorScheme: "light" });
  await page.goto(`${await run(`${root}docs/images/sights.json`)}?quality=high`);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  await page.evaluate(() => window.ccmorse.look([0.75, 0.75, 1.15], [1.6, 2.3, 0.05]));
  const sightsFrom = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 4, sightsFrom);
  await page.screenshot({ path: `${root}docs/images/view-sights.png` });
} finally {
  await browser.close();
  for (const simulator of simulators) simulator.kill("SIGINT");
}
