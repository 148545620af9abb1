// The live view in a real browser against a real simulator: what each control does is read from the
// page and from the simulator. node --test view_test.mjs, with the program's path in $CCMORSE.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { request } from "node:http";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import nodeTest from "node:test";
import { chromium } from "playwright-core";

const PROGRAM = process.env.CCMORSE ?? "build/release/bin/ccmorse";
const LAYERS = process.env.LAYERS ?? join(dirname(PROGRAM), "layers"); // of examples/canvas
const LONG = Number(process.env.LONG ?? 60_000); // ms: software rendering on a busy machine is slow

/** A program with a view. */
class Program {
  constructor(...words) {
    this.process = spawn(PROGRAM, words);
    this.output = "";
    this.address = new Promise((resolve, reject) => {
      this.process.stdout.on("data", (data) => {
        this.output += data;
        const found = /^View at (\S+)$/m.exec(this.output);
        if (found !== null && /SCENE INITIALIZED|Ctrl-C/.test(this.output)) resolve(found[1]);
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

class Simulator extends Program {
  constructor(scenario, ...more) {
    super("run", scenario, "--port", "0", "--stream-port", "0", ...more);
  }
}

let browser;
const cases = [];

/** One of the cases that run one after the other, in one browser, at the end of this file. */
function test(name, body) {
  cases.push({ name, body });
}

async function look(address, options = {}) {
  // Small, as every pixel is the processor's.
  const page = await browser.newPage({ viewport: { width: 640, height: 400 }, ...options });
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
function view(name, scenario, body, options = {}, ...more) {
  test(name, async (context) => {
    const simulator = new Simulator(scenario, ...more);
    context.after(() => simulator.stop());
    const page = await look(await simulator.address, options);
    context.after(() => page.close());
    await body(page, context);
    assert.deepEqual(page.problems, []);
  });
}

const time = (page) => page.evaluate(() => window.ccmorse.frame().time);
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

view("P15 P16 P17 P18 P19: Left Ctrl + Up and Down and the buttons switch where the canvas is shown", "syrotek", async (page) => {
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
  // Switches of what no robot has are off limits.
  for (const layer of ["rings", "sights"]) {
    assert.equal(await page.locator(`input[name=${layer}]`).isDisabled(), true, layer);
  }
  for (const layer of ["lasers", "trails", "speeds", "names"]) {
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

view("time: pause, one step, and on, by key and by button", "syrotek", async (page) => {
  const paused = (wanted) => page.waitForFunction((p) => window.ccmorse.frame().paused === p, wanted);
  await page.keyboard.press("k");
  await paused(true);
  assert.equal(await page.textContent("#rate"), "paused");
  const from = await time(page);
  await page.waitForTimeout(300);
  assert.equal(await time(page), from);
  await page.keyboard.press(".");
  await page.waitForFunction((t) => window.ccmorse.frame().time > t, from);
  assert.ok(Math.abs((await time(page)) - from - 1 / 60) < 1e-9);
  await page.locator("#step").click();
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.03, from);
  assert.ok(Math.abs((await time(page)) - from - 2 / 60) < 1e-9);
  await page.locator("#play").click();
  await paused(false);
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.3, from);
});

view("time: the speed is chosen in the list and by - and +", "syrotek", async (page) => {
  const wanted = (speed) => page.waitForFunction((s) => window.ccmorse.frame().speed === s, speed);
  await page.locator("#speed").selectOption("0.1");
  await wanted(0.1);
  await page.waitForFunction(() => Math.abs(window.ccmorse.frame().rate - 0.1) < 0.05);
  await page.locator("#stage").focus();
  await page.keyboard.press("+");
  await wanted(0.25);
  assert.equal(await page.locator("#speed").inputValue(), "0.25");
  await page.keyboard.press("-");
  await wanted(0.1);
  await page.locator("#speed").selectOption("Infinity");
  await wanted(Infinity);
  await page.waitForFunction(() => window.ccmorse.frame().rate > 5);
});

view("time: reset puts the robots where they started", "syrotek", async (page) => {
  const from = await robot(page);
  await page.evaluate(() => window.ccmorse.call("s1r.motion", "set_speed", [0.2, 0]));
  await page.waitForFunction((y) => Math.abs(window.ccmorse.frame().robots[0].y - y) > 0.05, from.y);
  await page.locator("#reset").click();
  await page.waitForFunction((y) => Math.abs(window.ccmorse.frame().robots[0].y - y) < 0.005, from.y);
});

test("a record has a time line, jumps both ways, and is not changed", async (context) => {
  const folder = await mkdtemp(join(tmpdir(), "ccmorse-view-"));
  context.after(() => rm(folder, { recursive: true }));
  const file = join(folder, "drive.mcap");
  const made = new Simulator("two_robots", "--pace", "max", "--for", "20", "--record", file);
  await made.ended;
  const replay = new Program("replay", file, "--view-port", "0", "--speed", "0.5");
  context.after(() => replay.stop());
  const page = await look(await replay.address);
  context.after(() => page.close());
  assert.equal(await page.textContent("#record-name"), "drive.mcap");
  assert.equal(await page.textContent("#record-end"), "20.0 s");
  assert.equal(await page.locator("#reset").isVisible(), false);
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.ccmorse.frame().paused);
  const jump = async (to) => {
    await page.locator("#timeline").fill(String(to));
    await page.waitForFunction((t) => Math.abs(window.ccmorse.frame().time - t) < 0.02, to);
  };
  await jump(15);
  await jump(3);
  await page.locator("#stage").focus();
  await page.keyboard.press("l");
  await page.waitForFunction(() => Math.abs(window.ccmorse.frame().time - 8) < 0.02);
  await page.keyboard.press("j");
  await page.waitForFunction(() => Math.abs(window.ccmorse.frame().time - 3) < 0.02);
  await page.keyboard.press("w"); // nobody can drive
  await page.locator("#notice").waitFor();
  assert.match(await page.textContent("#notice"), /record/);
  await jump(20);
  await page.waitForFunction(() => document.getElementById("rate").textContent === "at the end");
  await page.locator("#play").click(); // from the start again
  await page.waitForFunction(() => !window.ccmorse.frame().paused && window.ccmorse.frame().time < 10);
  assert.deepEqual(page.problems, []);
});

view("a read-only view shows and changes nothing", "syrotek", async (page) => {
  assert.equal(await page.locator("#time").isVisible(), false);
  assert.match(await page.textContent("#drive-hint"), /read-only/);
  await page.keyboard.press("k");
  await page.keyboard.press("w");
  assert.match(await page.textContent("#notice"), /read-only/);
  const from = await time(page);
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.3, from);
  const refused = await page.evaluate(() =>
    window.ccmorse.call("ccmorse", "pause", []).then(() => "", (error) => error.message));
  assert.equal(refused, "this view is read-only");
}, {}, "--view-read-only");

view("plots show the chosen robot's speed, odometry's error and nearest range", "syrotek", async (page) => {
  assert.equal(await page.evaluate(() => window.ccmorse.points().length), 0); // nothing is open
  await page.locator("#plots summary").click();
  await page.evaluate(() => window.ccmorse.call("s1r.motion", "set_speed", [0.1, 0]));
  const last = () => page.evaluate(() =>
    window.ccmorse.points().map(({ name, values }) => [name, values.at(-1)]));
  await page.waitForFunction(() => window.ccmorse.points().every(({ values }) => values.length > 3) &&
    Math.abs(window.ccmorse.points()[0].values.at(-1) - 0.1) < 1e-6);
  const [speed, error, near] = await last();
  assert.deepEqual([speed[0], error[0], near[0]], ["Speed", "Odometry off by", "Nearest range"]);
  assert.ok(error[1] < 1e-6, `the odometry of this scenario is right, not ${error[1]} off`);
  assert.ok(near[1] > 0.05 && near[1] < 5, String(near[1]));
  assert.equal(await page.locator("#plots canvas").count(), 3);
});

view("devices that are open show their values, others are not asked for", "two_robots", async (page) => {
  let asked = 0;
  const socket = await page.context().newCDPSession(page);
  await socket.send("Network.enable");
  socket.on("Network.webSocketFrameSent", ({ response }) => {
    if (response.payloadData.includes("get_local_data")) ++asked;
  });
  await page.locator("#devices > summary").click();
  await page.waitForTimeout(600);
  assert.equal(asked, 0);
  const pose = page.locator("#device-tree details details", { has: page.locator("summary", { hasText: /^pose/ }) }).first();
  await pose.locator("summary").click();
  const value = async (name) =>
    Number(await pose.locator(`dt:text-is("${name}") + dd`).textContent());
  await pose.locator("dd").first().waitFor();
  const state = await robot(page);
  assert.ok(Math.abs((await value("x")) - state.x) < 0.002, `${await value("x")} ${state.x}`);
  const before = await value("timestamp");
  await page.waitForFunction(([b]) => Number(document.querySelector("#device-tree dd").textContent) > b, [before]);
  assert.ok(asked > 1);
});

view("the log shows what the simulator says", "syrotek", async (page) => {
  await page.locator("#log summary").click();
  await page.locator("#log-empty").waitFor();
  // A page of another site is refused, and that is worth a line.
  request(new URL("/view", page.url()), {
    headers: {
      Origin: "http://elsewhere.example", Connection: "Upgrade", Upgrade: "websocket",
      "Sec-WebSocket-Version": 13, "Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==",
    },
  }, (answer) => answer.resume()).end();
  const line = page.locator("#log-lines li.warning");
  await line.waitFor();
  assert.match(await line.textContent(), /elsewhere\.example/);
  assert.equal(await page.locator("#log-empty").isVisible(), false);
});

view("what is shown is saved as a picture and as a film", "syrotek", async (page) => {
  await page.locator("#panel").evaluate((panel) => (panel.scrollTop = 9999));
  const saved = async (act) => {
    const [download] = await Promise.all([page.waitForEvent("download"), act()]);
    return [download.suggestedFilename(), await readFile(await download.path())];
  };
  const [pictureName, picture] = await saved(() => page.locator("#picture").click());
  assert.match(pictureName, /^syrotek-\d+\.\ds\.png$/);
  assert.deepEqual([...picture.subarray(1, 4)], [...Buffer.from("PNG")]);
  assert.ok(picture.length > 5000, String(picture.length));
  await page.locator("#film").click();
  assert.match(await page.textContent("#film"), /^Stop/);
  await page.waitForTimeout(2500);
  const [filmName, film] = await saved(() => page.locator("#film").click());
  assert.match(filmName, /\.webm$/);
  assert.deepEqual([...film.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3]); // EBML
  assert.ok(film.length > 2000, String(film.length));
  assert.equal(await page.textContent("#film"), "Film");
});

/** A test on a page that looks at a scenario of its own. */
function viewOf(name, scenario, body, ...more) {
  test(name, async (context) => {
    const folder = await mkdtemp(join(tmpdir(), "ccmorse-view-"));
    context.after(() => rm(folder, { recursive: true }));
    const file = join(folder, "obstacles.json");
    await writeFile(file, JSON.stringify(scenario));
    const simulator = new Simulator(file, ...more);
    context.after(() => simulator.stop());
    const page = await look(await simulator.address);
    context.after(() => page.close());
    await body(page, context, folder);
    assert.deepEqual(page.problems, []);
  });
}

// --- Fields of view

const FOOTPRINT = [[0.1, -0.1], [0.1, 0.1], [-0.1, 0.1], [-0.1, -0.1]];
const EYE = { cam_near: 0.1, cam_far: 0.9, cam_width: 320, cam_height: 240, cam_focal: 20 };
const WATCHERS = {
  robots: [
    {
      name: "rover", type: "Custom", pose: { x: 1.2, y: 2.0, yaw: 0.7 },
      body: { footprint: FOOTPRINT, hull: [{ outline: FOOTPRINT, bottom: 0, top: 0.2 }] },
      components: [
        { name: "eye", type: "SemanticCamera", position: [0.1, 0.02, 0.3], rotation: [0.1, 0.3, -0.2],
          properties: EYE },
        { name: "plain", type: "SemanticCamera" },
        { name: "ptu", type: "PTU", position: [-0.05, 0, 0.2], properties: { Speed: 20 } },
        { name: "ptu.eye", type: "SemanticCamera", position: [0, 0, 0.3],
          properties: { ...EYE, cam_far: 0.5 } },
        { name: "radar", type: "SearchAndRescue", position: [0, 0, 0.25], rotation: [0, 0, 1],
          properties: { Angle: 40, Distance: 1.1 } },
      ],
    },
    { name: "s1r", pose: { x: 2.1, y: 2.5, yaw: 0 }, ir: {} },
  ],
};

/** Rz(yaw) Ry(pitch) Rx(roll) of a point, then moved. */
function placed([x, y, z], [roll, pitch, yaw], [dx, dy, dz]) {
  [y, z] = [y * Math.cos(roll) - z * Math.sin(roll), y * Math.sin(roll) + z * Math.cos(roll)];
  [x, z] = [x * Math.cos(pitch) + z * Math.sin(pitch), -x * Math.sin(pitch) + z * Math.cos(pitch)];
  [x, y] = [x * Math.cos(yaw) - y * Math.sin(yaw), x * Math.sin(yaw) + y * Math.cos(yaw)];
  return [x + dx, y + dy, z + dz];
}

/** The corners of what a camera sees into, in its frame: a lens on 32 units of the longer side. */
function pyramid(properties) {
  const { cam_near: near, cam_far: far, cam_width: width, cam_height: height } = properties;
  const side = 16 / properties.cam_focal / Math.max(width, height);
  return [[0, 0, 0], ...[near, far].flatMap((x) => [[1, 1], [1, -1], [-1, 1], [-1, -1]]
    .map(([y, z]) => [x, y * x * side * width, z * x * side * height]))];
}

/** Each of the points is there, and where `all`, no others. */
function assertPoints(found, wanted, within, all = true) {
  if (all) assert.equal(found.length, wanted.length, JSON.stringify(found));
  for (const point of wanted) {
    const off = Math.min(...found.map((each) => Math.hypot(...each.map((v, i) => v - point[i]))));
    assert.ok(off < within, `${point} is ${off} m off ${JSON.stringify(found)}`);
  }
}

viewOf("camera frusta and radar cones are drawn as their components' properties say, and are switched",
  WATCHERS, async (page) => {
    const sights = async () => Object.fromEntries((await page.evaluate(() => window.ccmorse.sights()))
      .map(({ name, ...rest }) => [name, rest]));
    const [ROVER] = WATCHERS.robots;
    const robotAt = async () => {
      const { x, y, z, yaw } = await robot(page, 0);
      return (point) => placed(point, [0, 0, yaw], [x, y, z]);
    };
    const asDescribed = async (carried) => {
      const inWorld = await robotAt();
      const found = await sights();
      assert.deepEqual(Object.keys(found).sort(),
        ["rover.eye", "rover.plain", "rover.ptu.eye", "rover.radar"]);
      const eye = ROVER.components[0];
      assertPoints(found["rover.eye"].corners, pyramid(EYE).map((point) =>
        inWorld(placed(point, eye.rotation, eye.position))), 1e-5);
      // MORSE's defaults; what is far away is there, too.
      const plain = { cam_near: 0.1, cam_far: 100, cam_width: 256, cam_height: 256, cam_focal: 25 };
      assertPoints(found["rover.plain"].corners, pyramid(plain).map(inWorld), 1e-3, false);
      assertPoints(found["rover.ptu.eye"].corners,
        pyramid({ ...EYE, cam_far: 0.5 }).map((point) => inWorld(carried(point))), 1e-5);
      // The edge of the cone, and its tip.
      const [, , , , radar] = ROVER.components;
      const tip = inWorld(radar.position);
      const ahead = inWorld(placed([1, 0, 0], radar.rotation, radar.position)).map((v, i) => v - tip[i]);
      const cone = found["rover.radar"].corners.map((corner) => corner.map((v, i) => v - tip[i]))
        .filter((way) => Math.hypot(...way) > 1e-5);
      assert.equal(cone.length, found["rover.radar"].corners.length - 1, "the tip is a corner");
      let rim = 0;
      for (const way of cone) {
        assert.ok(Math.abs(Math.hypot(...way) - 1.1) < 1e-5, String(way));
        const cosine = way.reduce((sum, v, i) => sum + v * ahead[i], 0) / 1.1;
        const angle = Math.acos(Math.min(1, cosine)) * 180 / Math.PI;
        assert.ok(angle < 20 + 1e-2, `${angle} degrees off`);
        if (angle > 20 - 1e-2) ++rim;
      }
      assert.ok(rim >= 24, `${rim} corners on the rim`);
    };
    await asDescribed((point) => placed(point, [0, 0, 0], [0, 0, 0.3]));

    // They go along, with the robot and with what carries them.
    await page.evaluate(() => Promise.all([
      window.ccmorse.call("simulation", "set_object_position", ["rover", [1.65, 2.25, 0], [0, 0, 1.9]]),
      window.ccmorse.call("rover.ptu", "set_pan_tilt", [0.8, 0.5])]));
    await page.waitForFunction(() => Math.abs(window.ccmorse.frame().robots[0].yaw - 1.9) < 1e-6);
    const arrived = await time(page);
    await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.1, arrived);
    assert.equal(await page.evaluate(() => window.ccmorse.frame().movedSensors.length), 1);
    const [pan, tilt] = await page.evaluate(() => window.ccmorse.call("rover.ptu", "get_pan_tilt", []));
    assert.ok(Math.abs(pan - 0.8) < 0.02 && Math.abs(tilt - 0.5) < 0.02, `${pan} ${tilt}`);
    await asDescribed((point) => placed(placed(point, [0, 0, 0], [0.05, 0, 0.1]),
      [0, tilt, pan], ROVER.components[2].position));

    // The switch: what is drawn changes, and is the same as before when it is back.
    await page.evaluate(() => window.ccmorse.call("ccmorse", "pause", []));
    await page.waitForFunction(() => window.ccmorse.frame().paused);
    const drawn = async () => {
      const before = await page.evaluate(() => window.ccmorse.frames());
      await page.waitForFunction((n) => window.ccmorse.frames() > n + 4, before);
    };
    const picture = async () => {
      await drawn();
      return page.evaluate(() => document.getElementById("stage").toDataURL());
    };
    const box = page.locator("input[name=sights]");
    const shown = async () => {
      await drawn(); // what is chosen counts with the next frame
      return [...new Set(Object.values(await sights()).map((sight) => sight.shown))];
    };
    assert.equal(await box.isChecked(), true);
    assert.deepEqual(await shown(), [true]);
    const on = await picture();
    await box.click();
    assert.deepEqual(await shown(), [false]);
    assert.notEqual(await picture(), on);
    await box.click();
    assert.deepEqual(await shown(), [true]);
    assert.equal(await picture(), on);
    await page.locator("input[name=rings]").click(); // of the other robot, so that it can be
    // Through the robot's own eyes they would tint all.
    await page.keyboard.press("4");
    assert.deepEqual(await shown(), [false]);
    await page.keyboard.press("1");
    assert.deepEqual(await shown(), [true]);
  });

// --- Lasers

const SCANS = { laser: { range: 4, scan_window_deg: 120, samples: 61, resolution_deg: 2 }, frequency: 20 };
viewOf("scans are drawn as their lasers are turned on the robot, by a PTU, too", {
  robots: [{
    name: "rover", type: "Custom", pose: { x: 1.2, y: 2.0, yaw: 0.7 },
    body: { footprint: FOOTPRINT },
    components: [
      { name: "aside", type: "LaserScanner", position: [0.05, 0.02, 0.1], rotation: [0, 0, 1.3], ...SCANS },
      { name: "down", type: "LaserScanner", position: [0, 0, 0.3], rotation: [0, 0.4, 0.2], ...SCANS },
      { name: "ptu", type: "PTU", position: [-0.05, 0, 0.2], properties: { Speed: 20 } },
      { name: "ptu.sick", type: "LaserScanner", position: [0, 0, 0.3], ...SCANS },
    ],
  }],
}, async (page) => {
  await page.evaluate(() => window.ccmorse.call("rover.ptu", "set_pan_tilt", [0.8, 0.3]));
  const [pan, tilt] = await page.evaluate(() => window.ccmorse.call("rover.ptu", "get_pan_tilt", []));
  const now = await time(page);
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.3, now);
  const { x, y, yaw } = await robot(page);
  const mounts = {
    aside: (point) => placed(point, [0, 0, 1.3], [0.05, 0.02, 0.1]),
    down: (point) => placed(point, [0, 0.4, 0.2], [0, 0, 0.3]),
    "ptu.sick": (point) => placed(placed(point, [0, 0, 0], [0.05, 0, 0.1]), [0, tilt, pan], [-0.05, 0, 0.2]),
  };
  for (const [name, mounted] of Object.entries(mounts)) {
    const { range_list: ranges } = JSON.parse(JSON.stringify(await page.evaluate((of) =>
      window.ccmorse.call(of, "get_local_data", []), `rover.${name}`)));
    const drawn = await page.evaluate((of) => window.ccmorse.beams(of), `rover.${name}`);
    assert.equal(drawn.length, 61, name);
    assert.ok(ranges.some((range) => range < 3.9), name);
    drawn.forEach((end, i) => {
      const bearing = (-60 + 2 * i) * Math.PI / 180;
      const point = [ranges[i] * Math.cos(bearing), ranges[i] * Math.sin(bearing), 0];
      const wanted = placed(mounted(point), [0, 0, yaw], [x, y, 0]);
      const off = Math.hypot(...end.map((v, k) => v - wanted[k]));
      assert.ok(off < 2e-4, `${name}, beam ${i}: ${end}, not ${wanted}`);
    });
  }
});

// --- The scenario's camera

// Blender's angles: first about x, then y, then z. Its middle is that of what the panel leaves free.
const TURNED = [0.7, 0, 0.9];
viewOf("at first the page looks where the scenario's camera does, turned as MORSE has it", {
  camera: { position: placed([0, 0, 2.5], TURNED, [1.2, 2.0, 0]), rotation: TURNED },
  robots: [{ name: "s1r", pose: { x: 1.2, y: 2.0, yaw: 0 } }],
}, async (page) => {
  const drawn = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 2, drawn);
  const [at, free] = await page.evaluate(() => [
    window.ccmorse.find(0), innerWidth - document.getElementById("panel").offsetWidth]);
  assertNear(at, { x: free / 2, y: 200 }, 12);
});

viewOf("the camera that follows goes with a robot in the air", {
  robots: [{
    name: "kite", type: "Custom", pose: { x: 1.2, y: 2.0, yaw: 0 },
    body: {
      footprint: FOOTPRINT, hull: [{ outline: FOOTPRINT, bottom: 5, top: 5.2 }], origin_height: 5,
    },
  }],
}, async (page) => {
  await page.keyboard.press("2");
  const drawn = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 2, drawn);
  const [at, free] = await page.evaluate(() => [
    window.ccmorse.find(0), innerWidth - document.getElementById("panel").offsetWidth]);
  assertNear(at, { x: free / 2, y: 200 }, 12);
});

// --- Things

// A wedge, of which one can see how it is turned.
const WEDGE = [[0, 0, 0], [0.2, 0, 0], [0, 0.06, 0], [0, 0, 0.1]];
const CARRIER = {
  robots: [{
    name: "porter", type: "Custom", pose: { x: 1.2, y: 2.0, yaw: 0.3 },
    body: { footprint: FOOTPRINT, hull: [{ outline: FOOTPRINT, bottom: 0, top: 0.2 }] },
    components: [
      { name: "hand", type: "Gripper", position: [0.1, 0, 0.2], properties: { Angle: 180, Distance: 0.5 } },
      { name: "motion", type: "MotionVW" },
    ],
  }],
  props: ["cup", "other"].map((name, i) => ({
    name, file: "", position: [1.4 + i, 2.1, 0.25], rotation: [0.2, -0.1, 0.6],
    properties: { Graspable: true },
    shape: [{ vertices: WEDGE, triangles: [[0, 1, 2], [0, 1, 3], [1, 2, 3], [0, 2, 3]] }],
  })),
};

/** Asks on MORSE's service port, as a user's program does; the answer's value. */
async function askMorse(port, component, service, ...args) {
  const socket = connect(Number(port), "127.0.0.1");
  try {
    socket.write(`id1 ${component} ${service} ${JSON.stringify(args)}\n`);
    const line = await new Promise((resolve, reject) => {
      let text = "";
      socket.on("data", (data) => {
        text += data;
        if (text.includes("\n")) resolve(text.trim());
      });
      socket.on("error", reject);
    });
    const [, status, value] = /^id1 (\S+) ?(.*)$/.exec(line);
    assert.equal(status, "SUCCESS", line);
    return value === "" ? null : JSON.parse(value);
  } finally {
    socket.destroy();
  }
}

/** Low and high corner of the box around points. */
const boxAround = (points) => [Math.min, Math.max].map((best) =>
  [0, 1, 2].map((i) => best(...points.map((point) => point[i]))));

test("what a gripper holds goes along in the view, is left where it is let go, and a record shows it", async (context) => {
  const folder = await mkdtemp(join(tmpdir(), "ccmorse-view-"));
  context.after(() => rm(folder, { recursive: true }));
  const scenario = join(folder, "carrier.json");
  await writeFile(scenario, JSON.stringify(CARRIER));
  const file = join(folder, "carrier.mcap");
  const simulator = new Simulator(scenario, "--record", file);
  context.after(() => simulator.stop());
  const page = await look(await simulator.address);
  context.after(() => page.close());
  const ask = (...words) => askMorse(/^MORSE services on \S+ port (\d+)/m.exec(simulator.output)[1], ...words);
  const moved = () => page.evaluate(() => window.ccmorse.frame().movedThings);
  const drawn = (name) => page.evaluate((of) => window.ccmorse.boxAround(of), name);
  const [cup, other] = CARRIER.props;
  // Its corners as it stands in the scenario, then taken along from the robot's first pose to another.
  const atStart = WEDGE.map((point) => placed(point, cup.rotation, cup.position));
  const start = await robot(page);
  const along = (points, to) => points.map(([x, y, z]) => placed(
    placed([x - start.x, y - start.y, z], [0, 0, -start.yaw], [0, 0, 0]),
    [0, 0, to.yaw], [to.x, to.y, 0]));
  const assertBox = async (name, points, where) => {
    const [found, wanted] = [await drawn(name), boxAround(points)];
    const off = Math.max(...found.flat().map((v, i) => Math.abs(v - wanted.flat()[i])));
    assert.ok(off < 1e-4, `${where}: ${JSON.stringify(found)}, not ${JSON.stringify(wanted)}`);
  };
  const stands = async () => { // driven somewhere, and it is all in a frame
    await ask("porter.motion", "set_speed", 0, 0);
    const now = await time(page);
    await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.2, now);
    return robot(page);
  };
  await assertBox("cup", atStart, "at the start");
  assert.deepEqual(await moved(), []);

  assert.equal(await ask("porter.hand", "grab"), "cup");
  await ask("porter.motion", "set_speed", 0.1, 0.8);
  await page.waitForFunction((yaw) => window.ccmorse.frame().robots[0].yaw > yaw + 1, start.yaw);
  const carried = await stands();
  const [one, ...more] = await moved();
  assert.deepEqual(more, []); // only what has moved is told of
  assert.equal(await page.evaluate((i) => window.ccmorse.scene().things[i].name, one.thing), "cup");
  const [origin] = along([cup.position], carried);
  assert.ok(Math.hypot(...one.position.map((v, i) => v - origin[i])) < 1e-5, JSON.stringify(one));
  assert.ok(Math.hypot(origin[0] - cup.position[0], origin[1] - cup.position[1]) > 0.1);
  const there = along(atStart, carried);
  await assertBox("cup", there, "carried");
  await assertBox("other", WEDGE.map((point) => placed(point, other.rotation, other.position)), "the other");

  assert.equal(await ask("porter.hand", "release"), true);
  await ask("porter.motion", "set_speed", -0.1, 0);
  await page.waitForFunction(({ x, y }) => Math.hypot(window.ccmorse.frame().robots[0].x - x,
    window.ccmorse.frame().robots[0].y - y) > 0.05, carried);
  await stands();
  await assertBox("cup", there, "let go");
  const end = await time(page);
  // Who comes later sees the same.
  await page.reload();
  await page.waitForFunction(() => window.ccmorse?.frame() !== null);
  await assertBox("cup", there, "after a reload");
  await page.locator("#reset").click();
  await page.waitForFunction(() => window.ccmorse.frame().movedThings.length === 0);
  await assertBox("cup", atStart, "reset");
  await simulator.stop();
  assert.deepEqual(page.problems.filter((problem) => !/WebSocket/.test(problem)), []);

  const replay = new Program("replay", file, "--view-port", "0");
  context.after(() => replay.stop());
  const again = await look(await replay.address);
  context.after(() => again.close());
  const inRecord = (wanted) => again.waitForFunction((t) =>
    window.ccmorse.frame().paused && Math.abs(window.ccmorse.frame().time - t) < 0.02, wanted);
  await again.keyboard.press("Space");
  await again.waitForFunction(() => window.ccmorse.frame().paused);
  await again.locator("#timeline").fill(String(Math.round(100 * end) / 100));
  await inRecord(end);
  const [found, wanted] = [await again.evaluate(() => window.ccmorse.boxAround("cup")), boxAround(there)];
  assert.ok(found.flat().every((v, i) => Math.abs(v - wanted.flat()[i]) < 1e-4), JSON.stringify(found));
  assert.deepEqual(again.problems, []);
});

// --- Obstacles

const ROBOTS = [{ name: "s1r", pose: { x: 1.2, y: 2.0, yaw_deg: 90 } }];
const UP = 1;
const WAITING = 2;

const flags = (page, id) => page.evaluate((wanted) =>
  window.ccmorse.frame().boxes[window.ccmorse.scene().boxes.findIndex((box) => box.id === wanted)], id);
const becomes = (page, ids, wanted) => page.waitForFunction(([all, value]) => all.every((id) =>
  window.ccmorse.frame().boxes[window.ccmorse.scene().boxes.findIndex((box) => box.id === id)] === value),
[ids, wanted]);
const whereBox = (page, id) => page.evaluate((wanted) => window.ccmorse.findBox(wanted), id);

const assertNear = (a, b, most = 0.5) => // px
  assert.ok(Math.hypot(a.x - b.x, a.y - b.y) <= most, `${JSON.stringify(a)} ${JSON.stringify(b)}`);

/** From above, all to be seen, obstacles being changed: by keys only. */
async function changeFromAbove(page) {
  await page.keyboard.press("h");
  await page.keyboard.press("3");
  await page.keyboard.press("o");
  const from = await page.evaluate(() => window.ccmorse.frames());
  await page.waitForFunction((n) => window.ccmorse.frames() > n + 3, from);
}

async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
  await page.mouse.move(to.x, to.y);
  await page.mouse.up();
}

viewOf("N01: a click raises an obstacle, another one lowers it", { robots: ROBOTS }, async (page) => {
  await changeFromAbove(page);
  const at = await whereBox(page, 69);
  await page.mouse.click(at.x, at.y);
  await becomes(page, [69], UP);
  assert.equal(await flags(page, 70), 0);
  await page.mouse.click(at.x, at.y);
  await becomes(page, [69], 0);
  await page.keyboard.press("Escape"); // the mode is over: a click changes nothing
  await page.mouse.click(at.x, at.y);
  await page.evaluate(() => window.ccmorse.call("arena", "raise", [70]));
  await becomes(page, [70], UP);
  assert.equal(await flags(page, 69), 0);
});

viewOf("N01: a rubber band raises all in it, then lowers them", { robots: ROBOTS }, async (page) => {
  await changeFromAbove(page);
  const [a, b, c] = await Promise.all([69, 70, 71].map((id) => whereBox(page, id)));
  const low = { x: Math.min(a.x, b.x, c.x) - 12, y: Math.min(a.y, b.y, c.y) - 12 };
  const high = { x: Math.max(a.x, b.x, c.x) + 12, y: Math.max(a.y, b.y, c.y) + 12 };
  await drag(page, low, high);
  await becomes(page, [69, 70, 71], UP);
  assert.equal(await flags(page, 66), 0);
  assertNear(await whereBox(page, 69), a); // the camera was left alone
  // The same with Shift, when the mode is over.
  await page.keyboard.press("o");
  await page.keyboard.down("Shift");
  await drag(page, high, low);
  await page.keyboard.up("Shift");
  await becomes(page, [69, 70, 71], 0);
  assert.equal(await page.locator("#band").isVisible(), false);
});

viewOf("an obstacle that is dragged stands where it was let go; where a robot is in its way it goes back",
  { robots: ROBOTS, obstacles: { up: [73] } }, async (page) => {
    await changeFromAbove(page);
    const from = await whereBox(page, 73);
    await drag(page, from, { x: from.x + 40, y: from.y });
    await page.waitForFunction(() => window.ccmorse.frame().moved.length === 1);
    const moved = await page.evaluate(() => {
      const { box, x, y } = window.ccmorse.frame().moved[0];
      return { id: window.ccmorse.scene().boxes[box].id, x, y };
    });
    assert.equal(moved.id, 73);
    assert.ok(moved.x > 2.6 && Math.abs(moved.y - 2.94) < 0.03, JSON.stringify(moved));
    const there = await whereBox(page, 73);
    assert.ok(Math.abs(there.x - from.x - 40) < 3, `${from.x} -> ${there.x}`);
    const robotAt = await page.evaluate(() => window.ccmorse.find(0));
    await drag(page, there, robotAt);
    await page.locator("#notice").waitFor();
    assert.match(await page.textContent("#notice"), /box 73 does not fit there/);
    assertNear(await whereBox(page, 73), there);
    // Escape gives a drag up.
    await page.mouse.move(there.x, there.y);
    await page.mouse.down();
    await page.mouse.move(there.x, there.y + 60);
    assert.ok((await whereBox(page, 73)).y > there.y + 40);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    assertNear(await whereBox(page, 73), there);
  });

viewOf("an obstacle that cannot come up yet is said to wait", { robots: ROBOTS }, async (page) => {
  const place = await robot(page);
  await page.evaluate(({ x, y }) => window.ccmorse.call("arena", "move", [71, x, y]), place);
  await page.locator("#obstacle-list summary").click();
  await page.locator("input[name=obstacle-71]").click();
  await becomes(page, [71], WAITING);
  assert.match(await page.textContent("#notice"), /A robot stands where 71/);
  assert.equal(await page.locator("input[name=obstacle-71]").evaluate((box) => box.indeterminate), true);
  await page.evaluate(() => window.ccmorse.call(
    "simulation", "set_object_position", ["s1r", [1.654, 2.253, 0], [0, 0, -1.6]]));
  await becomes(page, [71], UP);
  assert.equal(await page.locator("input[name=obstacle-71]").isChecked(), true);
});

viewOf("N02: presets are loaded, saved and downloaded for a scenario",
  { robots: ROBOTS, obstacles: { presets: { door: [69, 70], maze: [66, 72] } } },
  async (page, context, folder) => {
    await page.locator("#preset").selectOption("maze");
    await page.locator("#preset-load button").click();
    await becomes(page, [66, 72], UP);
    assert.equal(await flags(page, 69), 0);
    await page.locator("#preset").selectOption("door");
    await page.locator("#preset-load button").click();
    await becomes(page, [69, 70], UP);
    await becomes(page, [66, 72], 0);
    await page.evaluate(() => window.ccmorse.call("arena", "raise", [76]));
    await page.locator("#preset-name").fill("mine: a door & more");
    await page.keyboard.press("Enter");
    await page.locator("#preset option", { hasText: "mine" }).waitFor({ state: "attached" });
    assert.equal(await page.locator("#preset").inputValue(), "mine: a door & more");
    const [download] = await Promise.all([
      page.waitForEvent("download"), page.locator("#preset-download").click()]);
    assert.equal(download.suggestedFilename(), "obstacles-obstacles.json");
    const rules = JSON.parse(await readFile(await download.path(), "utf8"));
    assert.deepEqual(rules, {
      presets: { door: [69, 70], maze: [66, 72], "mine: a door & more": [69, 70, 76] } });
    // It is what a scenario takes.
    const file = join(folder, "again.json");
    await writeFile(file, JSON.stringify({ obstacles: { ...rules, preset: "mine: a door & more" } }));
    const again = new Simulator(file);
    context.after(() => again.stop());
    await page.goto(await again.address);
    await page.waitForFunction(() => window.ccmorse?.frame() != null);
    await becomes(page, [69, 70, 76], UP);
    assert.equal(await flags(page, 66), 0);
  });

viewOf("N03, N04: what timers and traps do is in the log", {
  robots: ROBOTS,
  obstacles: {
    timers: [{ at: 0.3, up: [69, 70] }, { at: 0.4, say: "half time" }],
    traps: [{ name: "gate", region: [0.5, 0.5, 3, 3], down: [70], once: true }],
  },
}, async (page) => {
  await page.locator("#log summary").click();
  const events = page.locator("#log-lines li.event");
  await events.nth(1).waitFor();
  assert.deepEqual(await events.allTextContents(), ["0.0 s: trap gate by s1r: down 70", "0.3 s: timer: up 69, 70"]);
  // What is said is there once.
  const said = page.locator("#log-lines li", { hasText: "half time" });
  await said.first().waitFor();
  assert.equal(await said.count(), 1);
  await page.evaluate(() => window.ccmorse.call("arena", "lower", [70])); // of which there is no line
  await page.evaluate(() => window.ccmorse.call("arena", "add_timer", [{ at: 0, toggle: [76] }]));
  await events.nth(2).waitFor();
  assert.match(await events.nth(2).textContent(), /timer: toggle 76$/);
});

viewOf("a read-only view changes no obstacles", { robots: ROBOTS }, async (page) => {
  assert.equal(await page.locator("#obstacles").isVisible(), false);
  await page.keyboard.press("o");
  assert.match(await page.textContent("#notice"), /read-only/);
  await page.keyboard.press("h");
  await page.keyboard.press("3");
  const at = await whereBox(page, 69);
  await page.mouse.click(at.x, at.y);
  const from = await time(page);
  await page.waitForFunction((t) => window.ccmorse.frame().time > t + 0.3, from);
  assert.equal(await flags(page, 69), 0);
}, "--view-read-only");

test("a replay shows where obstacles went, and changes none", async (context) => {
  const folder = await mkdtemp(join(tmpdir(), "ccmorse-view-"));
  context.after(() => rm(folder, { recursive: true }));
  const scenario = join(folder, "path.json");
  await writeFile(scenario, JSON.stringify({ obstacles: { up: [73], paths: [{ box: 73, points: [
    { at: 0, x: 2.4, y: 2.94 }, { at: 4, x: 2.6, y: 2.5, yaw_deg: 45 }] }] } }));
  const file = join(folder, "path.mcap");
  const made = new Simulator(scenario, "--pace", "max", "--for", "6", "--record", file);
  await made.ended;
  const replay = new Program("replay", file, "--view-port", "0");
  context.after(() => replay.stop());
  const page = await look(await replay.address);
  context.after(() => page.close());
  assert.equal(await page.locator("#obstacles").isVisible(), false);
  await page.keyboard.press("o");
  assert.match(await page.textContent("#notice"), /record/);
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.ccmorse.frame().paused);
  await page.locator("#timeline").fill("5");
  await page.waitForFunction(() => Math.abs(window.ccmorse.frame().moved[0]?.x - 2.6) < 1e-5);
  const [end] = await page.evaluate(() => window.ccmorse.frame().moved);
  assert.ok(Math.abs(end.yaw - Math.PI / 4) < 1e-5, String(end.yaw));
  await page.locator("#timeline").fill("0");
  await page.waitForFunction(() => window.ccmorse.frame().moved.length === 0);
  assert.deepEqual(page.problems, []);
});

// --- Layers of the canvas

test("the layers of a program's canvas are switched in a list", async (context) => {
  const simulator = new Simulator("syrotek");
  context.after(() => simulator.stop());
  const page = await look(await simulator.address);
  context.after(() => page.close());
  assert.equal(await page.locator("#canvas-layers input").count(), 0);
  const port = /port (\d+)/.exec(simulator.output)[1];
  const program = spawn(LAYERS, [port, "600"], { stdio: "ignore" });
  context.after(() => program.kill());
  const layer = (name) => page.getByRole("checkbox", { name, exact: true });
  await layer("scan").waitFor();
  assert.deepEqual(await page.locator("#canvas-layers label").allTextContents(),
    ["trace", "way back", "scan", "inflated obstacles", "map"]); // the topmost first
  // Cells of the scan's green over what is free.
  const green = () => page.evaluate(() => {
    const map = document.getElementById("map");
    const copy = new OffscreenCanvas(map.width, map.height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(map, 0, 0);
    const { data } = copy.getImageData(0, 0, map.width, map.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 1] === 255 && data[i] < 255 && data[i] === data[i + 2]) ++count;
    }
    return count;
  });
  const until = async (good) => {
    const end = Date.now() + LONG;
    while (!good(await green())) {
      assert.ok(Date.now() < end, `${await green()} green cells`);
      await page.waitForTimeout(100);
    }
  };
  await until((count) => count > 500);
  await layer("scan").focus(); // by keyboard
  await page.keyboard.press("Space");
  await until((count) => count === 0);
  assert.equal(await layer("scan").isChecked(), false);
  assert.equal(await layer("scan").evaluate((box) => box === document.activeElement), true);
  await page.reload(); // the simulator knows it
  await layer("scan").waitFor();
  assert.equal(await layer("scan").isChecked(), false);
  assert.equal(await layer("trace").isChecked(), true);
  await layer("scan").click();
  await until((count) => count > 500);
  assert.deepEqual(page.problems, []);
});

view("a read-only view shows the layers of the canvas and switches none", "syrotek", async (page) => {
  const refused = await page.evaluate(() =>
    window.ccmorse.call("s1r.pen", "set_layers", [[["base", 0, true]]]).then(() => "", (error) => error.message));
  assert.equal(refused, "this view is read-only");
  assert.deepEqual(await page.evaluate(() => window.ccmorse.call("s1r.pen", "get_layers", [])), []);
}, {}, "--view-read-only");

view("? lists the keys, and Escape closes the list", "syrotek", async (page) => {
  await page.keyboard.press("?");
  assert.equal(await page.locator("#help").isVisible(), true);
  assert.match(await page.textContent("#help"), /pause or go on/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#help").isVisible(), false);
});

view("touch: a stick drives, and letting it go stops", "syrotek", async (page) => {
  const box = await page.locator("#pad").boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0], middle[1] - 60);
  await page.waitForFunction(() => window.ccmorse.frame().robots[0].v > 0.1);
  await page.mouse.up();
  await page.waitForFunction(() => window.ccmorse.frame().robots[0].v === 0);
}, { hasTouch: true, isMobile: true, viewport: { width: 700, height: 500 } });

// The requirement: ten pictures a second in headless Chromium, drawn by the processor, of 13 robots.
view("thirteen robots are drawn ten times a second without a graphics card", "docks", async (page, context) => {
  assert.equal(await page.locator("#robots li").count(), 13);
  let best = 0;
  for (let i = 0; i < 20 && best < 10; ++i) { // other programs may take the processor for a while
    await page.waitForTimeout(1000);
    best = Math.max(best, await page.evaluate(() => window.ccmorse.framesPerSecond()));
  }
  context.diagnostic(`${best.toFixed(1)} pictures a second`);
  assert.ok(best >= 10, `${best} pictures a second`);
});

// The requirement: the first paint within a second; and the first picture of the scene is not far.
view("the page paints within a second", "docks", async (page, context) => {
  let best = Infinity;
  for (let i = 0; i < 20 && best >= 1000; ++i) { // other programs may take the processor for a while
    await page.reload();
    await page.waitForFunction(() => window.ccmorse?.frame() !== null);
    const paints = () => page.evaluate(() =>
      performance.getEntriesByName("first-contentful-paint").map((entry) => entry.startTime));
    await page.waitForFunction(() =>
      performance.getEntriesByName("first-contentful-paint").length > 0);
    best = Math.min(best, ...await paints());
  }
  const picture = await page.evaluate(() => performance.now());
  context.diagnostic(`first paint after ${best.toFixed(0)} ms, all there within ${picture.toFixed(0)} ms`);
  assert.ok(best < 1000, `${best} ms`);
});

test("a lost connection is said, and the page comes back by itself", async (context) => {
  const first = new Simulator("syrotek");
  context.after(() => first.stop());
  const address = await first.address;
  const page = await look(address);
  context.after(() => page.close());
  await first.stop();
  await page.waitForFunction(() => document.getElementById("link").textContent !== "");
  assert.equal(await page.locator("#curtain").isVisible(), true);
  const second = new Simulator("two_robots", "--view-port", new URL(address).port);
  context.after(() => second.stop());
  await second.address;
  await page.waitForFunction(() => window.ccmorse.scene().scene === "two_robots");
  await page.waitForFunction(() => document.getElementById("link").textContent === "");
  assert.equal(await page.locator("#robots li").count(), 2);
  assert.equal(await page.locator("#curtain").isVisible(), false);
});

// ONLY=WORDS runs those whose names have the words.
nodeTest("the live view", async (context) => {
  browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
      "--enable-unsafe-swiftshader"],
  });
  context.after(() => browser.close());
  for (const { name, body } of cases) {
    if (name.includes(process.env.ONLY ?? "")) await context.test(name, body);
  }
});
