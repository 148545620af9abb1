// The live view in a real browser against a real simulator: what each control does is read from the
// page and from the simulator. node --test view_test.mjs, with the program's path in $CCMORSE.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import nodeTest from "node:test";
import { chromium } from "playwright-core";

const PROGRAM = process.env.CCMORSE ?? "build/release/bin/ccmorse";
const LONG = 60_000; // ms: software rendering on a busy machine is slow

/** A `ccmorse run`; ready() gives its view's address. */
class Simulator {
  constructor(scenario, ...more) {
    this.process = spawn(PROGRAM, ["run", scenario, "--port", "0", "--stream-port", "0", ...more]);
    this.output = "";
    this.address = new Promise((resolve, reject) => {
      this.process.stdout.on("data", (data) => {
        this.output += data;
        const found = /^View at (\S+)$/m.exec(this.output);
        if (found !== null && this.output.includes("SCENE INITIALIZED")) resolve(found[1]);
      });
      this.process.on("exit", () => reject(new Error(`it ended: ${this.output}`)));
    });
    this.ended = new Promise((resolve) => this.process.on("exit", resolve));
  }
  async stop() {
    this.process.kill("SIGINT"); // nothing where it has ended
    await this.ended;
  }
}

let browser;
const cases = [];

/** One of the cases that run one after the other, in one browser, at the end of this file. */
function test(name, body) {
  cases.push({ name, body });
}

async function look(address) {
  // Small, as every pixel is the processor's.
  const page = await browser.newPage({ viewport: { width: 640, height: 400 } });
  page.setDefaultTimeout(LONG);
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "warning" || message.type() === "error") page.problems.push(message.text());
  });
  await page.goto(address);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  return page;
}

/** A test on a page that looks at a simulation of `scenario`; both end with it, however it ends. */
function view(name, scenario, body) {
  test(name, async (context) => {
    const simulator = new Simulator(scenario);
    context.after(() => simulator.stop());
    const page = await look(await simulator.address);
    context.after(() => page.close());
    await body(page);
    assert.deepEqual(page.problems, []);
  });
}

const robot = (page, i = 0) => page.evaluate((n) => window.ccmorse.frame().robots[n], i);

view("the page shows the scenario and its time goes on", "two_robots", async (page) => {
  assert.equal(await page.textContent("#scene"), "two_robots");
  assert.equal(await page.title(), "two_robots - CCMorse");
  assert.equal(await page.locator("#robots li").count(), 2);
  const time = () => page.evaluate(() => window.ccmorse.frame().time);
  const from = await time();
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.5, from);
  assert.match(await page.textContent("#clock"), /^\d+\.\d s$/);
});

view("S12: a held key drives the chosen robot, and it stops when the key is released", "syrotek", async (page) => {
  const from = await robot(page);
  await page.keyboard.down("w");
  await page.waitForFunction(
    (x) => Math.hypot(window.ccmorse.frame().robots[0].x - x.x,
      window.ccmorse.frame().robots[0].y - x.y) > 0.1, from);
  await page.keyboard.up("w");
  await page.waitForFunction(() => window.ccmorse.frame().robots[0].v === 0);
  await page.keyboard.down("ArrowLeft");
  await page.waitForFunction(() => window.ccmorse.frame().robots[0].w > 0.5);
  await page.keyboard.up("ArrowLeft");
  await page.waitForFunction(() => window.ccmorse.frame().robots[0].w === 0);
});

view("P15-P19: Left Ctrl + Up and Down and the buttons switch where the canvas is shown", "syrotek", async (page) => {
  const shown = () => page.evaluate(() => {
    const map = document.getElementById("map");
    return map.hidden ? "ground" : map.className;
  });
  assert.equal(await shown(), "ground");
  await page.keyboard.press("Control+ArrowUp");
  assert.equal(await shown(), "minimap");
  await page.keyboard.press("Control+ArrowUp");
  assert.equal(await shown(), "fullscreen");
  await page.keyboard.press("Control+ArrowDown");
  assert.equal(await shown(), "minimap");
  await page.evaluate(() => document.querySelector("#modes button").click());
  assert.equal(await shown(), "ground");
});

view("cameras, layers and the panel switch by button and by key", "syrotek", async (page) => {
  const camera = () => page.textContent('#cameras [aria-checked="true"]');
  assert.equal(await camera(), "Orbit");
  for (const [key, name] of [["2", "Follow"], ["3", "Top"], ["4", "Robot"], ["1", "Orbit"]]) {
    await page.keyboard.press(key);
    assert.equal(await camera(), name);
  }
  await page.getByRole("radio", { name: "Top" }).click();
  assert.equal(await camera(), "Top");
  for (const layer of ["lasers", "rings", "trails", "speeds", "names"]) {
    const box = page.locator(`input[name=${layer}]`);
    const was = await box.isChecked();
    await box.click();
    assert.equal(await box.isChecked(), !was, layer);
  }
  await page.keyboard.press("h");
  assert.equal(await page.locator("#panel").isVisible(), false);
  await page.locator("#panel-button").click();
  assert.equal(await page.locator("#panel").isVisible(), true);
});

view("a robot that is dragged stands where it was let go", "syrotek", async (page) => {
  await page.keyboard.press("h"); // the panel covers a part
  await page.keyboard.press("3"); // from above
  await page.waitForFunction(() => window.ccmorse.frames() > 3);
  const from = await robot(page);
  // Where it is on the page: found by asking, as a user's eye would.
  const at = await page.evaluate(() => window.ccmorse.find(0));
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 30, at.y);
  await page.mouse.up();
  await page.waitForFunction((x) => window.ccmorse.frame().robots[0].x > x + 0.1, from.x);
  const to = await robot(page);
  assert.ok(Math.abs(to.y - from.y) < 0.1, `${from.y} -> ${to.y}`);
});

test("a lost connection is said, and the page comes back by itself", async (context) => {
  const first = new Simulator("syrotek");
  context.after(() => first.stop());
  const address = await first.address;
  const page = await look(address);
  context.after(() => page.close());
  await first.stop();
  await page.waitForFunction(() => document.getElementById("link").textContent !== "");
  const second = new Simulator("two_robots", "--view-port", new URL(address).port);
  context.after(() => second.stop());
  await second.address;
  await page.waitForFunction(() => window.ccmorse.scene().scene === "two_robots");
  await page.waitForFunction(() => document.getElementById("link").textContent === "");
  assert.equal(await page.locator("#robots li").count(), 2);
});

nodeTest("the live view", async (context) => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader"],
  });
  context.after(() => browser.close());
  for (const { name, body } of cases) await context.test(name, body);
});
