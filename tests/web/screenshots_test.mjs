// What the live view draws, beside the pictures in references/: the arena, the canvas in its three
// modes, and a map in layers. node --test screenshots_test.mjs, with $CCMORSE, the program's path,
// and $LAYERS, that of examples/canvas/layers.cpp. UPDATE_REFERENCES=1 renews the references; look
// at them before they are committed.
//
// Only what is drawn is compared: all that has text is hidden, the simulation is paused, and the
// picture is the plain one (?quality=low), drawn by the processor. The tolerance leaves room for
// edges that another version of the browser rounds otherwise, and not for a robot that stands
// elsewhere, which the last test makes sure of.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import nodeTest from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const HERE = dirname(fileURLToPath(import.meta.url));
const REFERENCES = join(HERE, "references");
const FAILED = join(HERE, "../../out/screenshots"); // what differs is put here
const PROGRAM = process.env.CCMORSE ?? "build/release/bin/ccmorse";
const LAYERS = process.env.LAYERS ?? "build/release/bin/layers";
const UPDATE = process.env.UPDATE_REFERENCES === "1";
const LONG = Number(process.env.LONG ?? 60_000); // ms: software rendering on a busy machine is slow

const SIZE = { width: 480, height: 300 };
const MOST_MEAN = 1.5; // mean absolute difference of the channels, of 255
const CHANGED = 40; // a pixel differs when one of its channels does by more than this, of 255
const MOST_CHANGED = 0.004; // share of pixels that differ

let browser;
let comparer; // an empty page, which decodes PNGs

/** `ccmorse run`; ready() has the ports. */
class Simulator {
  constructor(scenario, ...more) {
    this.process = spawn(PROGRAM, ["run", scenario, "--port", "0", "--stream-port", "0",
      "--view-port", "0", "--no-player", ...more]);
    this.ended = new Promise((resolve) => this.process.on("exit", resolve));
  }
  ready() {
    return new Promise((resolve, reject) => {
      let output = "";
      this.process.stdout.on("data", (data) => {
        output += data;
        const port = /^MORSE services on \S+ port (\d+)/m.exec(output);
        const address = /^View at (\S+)$/m.exec(output);
        if (port !== null && address !== null && output.includes("SCENE INITIALIZED"))
          resolve({ port: port[1], address: address[1] });
      });
      this.process.on("exit", () => reject(new Error(`it ended: ${output}`)));
    });
  }
  async stop() {
    this.process.kill("SIGINT");
    await this.ended;
  }
}

/** A page that shows nothing but what is drawn. */
async function look(address, { from, at }) {
  const page = await browser.newPage({ viewport: SIZE, colorScheme: "light" });
  page.setDefaultTimeout(LONG);
  await page.goto(`${address}?quality=low`);
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  await page.addStyleTag({ content: "body > *:not(#stage, #map) { visibility: hidden !important }" });
  await page.evaluate(([f, a]) => window.ccmorse.look(f, a), [from, at]);
  return page;
}

/** The page as PNG, when it has drawn what has changed up to now. */
async function shot(page) {
  const drawn = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 4, drawn);
  return page.screenshot();
}

/** How far two PNGs differ; the difference as PNG: red where a pixel does. */
async function compare(one, other) {
  return comparer.evaluate(async ([a, b, changed]) => {
    const pixels = async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const pen = canvas.getContext("2d");
      pen.drawImage(image, 0, 0);
      return { canvas, pen, data: pen.getImageData(0, 0, image.width, image.height) };
    };
    const left = await pixels(a);
    const right = await pixels(b);
    if (left.canvas.width !== right.canvas.width || left.canvas.height !== right.canvas.height)
      throw new Error("the pictures are not of one size");
    const size = left.canvas.width * left.canvas.height;
    let sum = 0;
    let count = 0;
    for (let i = 0; i < 4 * size; i += 4) {
      let most = 0;
      for (let k = i; k < i + 3; ++k) {
        const off = Math.abs(left.data.data[k] - right.data.data[k]);
        sum += off;
        most = Math.max(most, off);
      }
      if (most > changed) ++count;
      left.data.data.set(most > changed ? [255, 0, 0]
        : [0, 1, 2].map((k) => 170 + left.data.data[i + k] / 3), i);
    }
    left.pen.putImageData(left.data, 0, 0);
    return {
      mean: sum / (3 * size),
      changed: count / size,
      picture: left.canvas.toDataURL("image/png").split(",")[1],
    };
  }, [one.toString("base64"), other.toString("base64"), CHANGED]);
}

const within = ({ mean, changed }) => mean <= MOST_MEAN && changed <= MOST_CHANGED;
const percent = (share) => `${(100 * share).toFixed(2)} %`;

/** That a picture is as its reference is. */
async function asReference(context, name, picture) {
  const file = join(REFERENCES, `${name}.png`);
  if (UPDATE) {
    await mkdir(REFERENCES, { recursive: true });
    await writeFile(file, picture);
    context.diagnostic(`${file} is new`);
    return;
  }
  const found = await compare(await readFile(file), picture);
  context.diagnostic(`${name}: mean difference ${found.mean.toFixed(3)} of 255 (at most ${MOST_MEAN}), ` +
    `${percent(found.changed)} of pixels differ (at most ${percent(MOST_CHANGED)})`);
  if (within(found)) return;
  await mkdir(FAILED, { recursive: true });
  const actual = join(FAILED, `${name}_actual.png`);
  const difference = join(FAILED, `${name}_difference.png`);
  await writeFile(actual, picture);
  await writeFile(difference, Buffer.from(found.picture, "base64"));
  assert.fail(`${name} is not as ${file}: see ${actual} and ${difference}`);
}

const ARENA = { from: [0.95, 0.95, 1.55], at: [1.5, 2.35, 0] };
const ABOVE = { from: [1.71, -0.6, 3.4], at: [1.71, 1.8, 0] };

// Strips, a cross and a square: what is mirrored or turned is not the same.
async function drawOnCanvas(page) {
  await page.evaluate(async () => {
    const line = (...args) => window.ccmorse.call("blue.pen", "set_line", args);
    for (let i = 0; i < 30; ++i) await line(20, 20 + i, 60 + i, 20 + i, 30, 120, 255, 1);
    for (let i = 0; i < 6; ++i) {
      await line(70, 95 + i, 140, 165 + i, 220, 30, 30, 1);
      await line(70, 165 + i, 140, 95 + i, 20, 160, 60, 0.5);
    }
    for (let i = 0; i < 24; ++i) await line(120, 60 + i, 150, 60 + i, 250, 190, 20, 0.7);
  });
  await page.waitForFunction(() => window.ccmorse.frame().canvasWidth > 0);
}

async function arena(context) {
  const simulator = new Simulator(join(HERE, "screenshots.json"));
  context.after(() => simulator.stop());
  const { address } = await simulator.ready();
  const page = await look(address, ARENA);
  context.after(() => page.close());
  await page.evaluate(() => window.ccmorse.call("ccmorse", "pause", []));
  await page.waitForFunction(() => window.ccmorse.frame().paused);
  return page;
}

const CASES = {
  "the arena with robots, obstacles and laser scans is drawn as its reference": async (context) => {
    const page = await arena(context);
    await asReference(context, "arena", await shot(page));
  },

  "P15-P19: the canvas is drawn as its references on the ground, as mini-map and full screen": async (context) => {
    const page = await arena(context);
    await drawOnCanvas(page);
    await page.locator("input[name=lasers]").evaluate((box) => box.checked && box.click());
    await page.evaluate(([f, a]) => window.ccmorse.look(f, a), [ABOVE.from, ABOVE.at]);
    await asReference(context, "canvas_ground", await shot(page));
    for (const mode of ["minimap", "fullscreen"]) {
      await page.keyboard.press("Control+ArrowUp");
      await page.waitForFunction((m) => document.getElementById("map").className === m, mode);
      await asReference(context, `canvas_${mode}`, await shot(page));
    }
  },

  "P28: a map in layers is drawn as its reference": async (context) => {
    const out = await mkdtemp(join(tmpdir(), "ccmorse-layers-"));
    const simulator = new Simulator("syrotek", "--pace", "lockstep", "--out", out);
    context.after(async () => {
      await simulator.stop();
      await rm(out, { recursive: true });
    });
    const { port, address } = await simulator.ready();
    // In lock-step the program decides what time it is: the same map each time.
    const program = spawn(LAYERS, [port, "8"], { stdio: "inherit" });
    const status = await new Promise((resolve) => program.on("exit", resolve));
    assert.equal(status, 0);
    const page = await look(address, ABOVE);
    context.after(() => page.close());
    for (const layer of ["lasers", "trails"]) {
      await page.locator(`input[name=${layer}]`).evaluate((box) => box.checked && box.click());
    }
    await asReference(context, "layers", await shot(page));
  },

  "a robot that stands elsewhere is out of tolerance, and the same picture again is not": async (context) => {
    const page = await arena(context);
    const first = await shot(page);
    const again = await compare(first, await shot(page));
    assert.ok(within(again), `${again.mean} ${again.changed}`);
    // As far as it is long, and without what its laser sees.
    await page.locator("input[name=lasers]").evaluate((box) => box.checked && box.click());
    const before = await shot(page);
    await page.evaluate(() =>
      window.ccmorse.call("simulation", "set_object_position", ["blue", [1.3, 2.06, 0], [0, 0, 0.61]]));
    await page.waitForFunction(() =>
      window.ccmorse.frame().robots.some(({ x, y }) => Math.hypot(x - 1.3, y - 2.06) < 1e-3));
    const moved = await compare(before, await shot(page));
    context.diagnostic(`a robot 16 cm aside: mean difference ${moved.mean.toFixed(3)}, ` +
      `${percent(moved.changed)} of pixels`);
    assert.ok(moved.changed > 1.5 * MOST_CHANGED, percent(moved.changed));
    assert.ok(!within(moved));
  },
};

nodeTest("what the live view draws", async (context) => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader", "--force-color-profile=srgb"],
  });
  context.after(() => browser.close());
  comparer = await browser.newPage();
  for (const [name, body] of Object.entries(CASES)) await context.test(name, body);
});
