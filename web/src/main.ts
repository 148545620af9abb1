import { CanvasLayers } from "./canvas_layers";
import { Connection, type LinkState } from "./connection";
import { Devices } from "./devices";
import { Export } from "./export";
import { LogView } from "./log_view";
import { Obstacles } from "./obstacles";
import { Pad } from "./pad";
import { element } from "./page";
import { Plots } from "./plots";
import type { CanvasMode, Frame, Scene } from "./protocol";
import { type CameraKind, type Layers, Stage } from "./stage";
import { TimeBar } from "./time_bar";
import "./view.css";

const CAMERAS: { kind: CameraKind; name: string; title: string }[] = [
  { kind: "orbit", name: "Orbit", title: "As the scenario says; drag to turn (1)" },
  { kind: "follow", name: "Follow", title: "Behind the chosen robot (2)" },
  { kind: "top", name: "Top", title: "From above (3)" },
  { kind: "robot", name: "Robot", title: "Through the chosen robot's eyes (4)" },
];
// `sensors`: whose; without any in the scene there is nothing to be switched.
const LAYERS: { key: keyof Layers; name: string; sensors?: (scene: Scene) => unknown[] }[] = [
  { key: "lasers", name: "Laser scans", sensors: ({ lasers }) => lasers },
  { key: "rings", name: "Sonar and infra-red", sensors: ({ rings }) => rings },
  { key: "sights", name: "Fields of view", sensors: ({ frusta, radars }) => [...frusta, ...radars] },
  { key: "trails", name: "Trails" },
  { key: "speeds", name: "Speeds" },
  { key: "names", name: "Names" },
];
const MODES: { mode: CanvasMode; name: string }[] = [
  { mode: "ground", name: "Ground" },
  { mode: "minimap", name: "Mini-map" },
  { mode: "fullscreen", name: "Full" },
];
const DRIVE_PERIOD_MS = 100;

const SEEK_STEP = 5; // s, by key

const stageCanvas = element<HTMLCanvasElement>("stage");
const stage = makeStage();
const map = element<HTMLCanvasElement>("map");
let scene: Scene | null = null;
let frame: Frame | null = null;
let chosen = 0;
let mode: CanvasMode = "ground";
let noticeTimer = 0;
let robotButtons: HTMLButtonElement[] = []; // one a robot, in the scene's order

function makeStage(): Stage {
  try {
    return new Stage(stageCanvas);
  } catch (error) {
    element("curtain-title").textContent = "This browser cannot draw in 3-D";
    element("curtain-text").textContent =
      "The view needs WebGL 2. Another browser, or hardware acceleration in this one's settings, may help.";
    throw error;
  }
}

function notice(text: string): void {
  const box = element("notice");
  box.textContent = text;
  box.hidden = false;
  clearTimeout(noticeTimer);
  noticeTimer = window.setTimeout(() => (box.hidden = true), 6000);
}

// One of several buttons is on.
function radioRow<T extends string>(
  id: string, items: { value: T; name: string; title?: string }[], choose: (value: T) => void,
): (value: T) => void {
  const buttons = new Map<T, HTMLButtonElement>();
  for (const { value, name, title } of items) {
    const button = document.createElement("button");
    button.textContent = name;
    button.setAttribute("role", "radio");
    if (title !== undefined) button.title = title;
    button.onclick = () => choose(value);
    buttons.set(value, button);
    element(id).append(button);
  }
  return (value) => {
    for (const [each, button] of buttons) button.setAttribute("aria-checked", String(each === value));
  };
}

// --- Camera, layers, canvas

const markCamera = radioRow(
  "cameras", CAMERAS.map(({ kind, name, title }) => ({ value: kind, name, title })), setCamera);

function setCamera(kind: CameraKind): void {
  stage.setCamera(kind);
  markCamera(kind);
}

for (const { key, name } of LAYERS) {
  const label = document.createElement("label");
  const box = document.createElement("input");
  box.type = "checkbox";
  box.name = key;
  box.checked = stage.layers[key];
  box.onchange = () => {
    stage.layers[key] = box.checked;
    if (frame !== null) stage.show({ ...frame, scans: [], rows: [] });
  };
  label.append(box, name);
  element("layers").append(label);
}

function allowLayers(of: Scene): void {
  for (const { key, sensors } of LAYERS) {
    const box = document.querySelector<HTMLInputElement>(`#layers input[name=${key}]`)!;
    box.disabled = sensors?.(of).length === 0;
    box.parentElement!.title = box.disabled ? "No robot here has such a sensor" : "";
  }
}

const markMode = radioRow(
  "modes", MODES.map(({ mode: value, name }) => ({ value, name })), (value) => setMode(value));

function setMode(value: CanvasMode): void {
  mode = value;
  markMode(value);
  map.hidden = value === "ground";
  map.className = value;
  stage.setGroundCanvas(value === "ground");
}

function stepMode(by: number): void {
  if (scene?.canvas.mode_switching !== true) return;
  const at = MODES.findIndex((each) => each.mode === mode);
  const next = MODES[(at + by + MODES.length) % MODES.length];
  if (next !== undefined) setMode(next.mode);
}

// The canvas as a flat picture, y up.
function showMap(shown: Frame): void {
  const { canvasWidth: width, canvasHeight: height } = shown;
  if (width === 0) return;
  if (map.width !== width || map.height !== height) {
    map.width = width;
    map.height = height;
  }
  const pen = map.getContext("2d")!;
  for (const row of shown.rows) {
    const pixels = new ImageData(new Uint8ClampedArray(row.rgba), width, 1);
    pen.putImageData(pixels, 0, height - 1 - row.y);
  }
}

// --- Robots

function listRobots(of: Scene): void {
  robotButtons = of.robots.map((robot, i) => {
    const button = document.createElement("button");
    const dot = document.createElement("span");
    dot.className = "dot";
    dot.style.background = `#${robot.color.toString(16).padStart(6, "0")}`;
    const name = document.createElement("span");
    name.textContent = robot.name;
    const state = document.createElement("span");
    state.className = "state";
    button.append(dot, name, state);
    button.onclick = () => choose(i);
    return button;
  });
  const byName = new Intl.Collator(undefined, { numeric: true }).compare;
  const sorted = of.robots.map((_, i) => i).sort((a, b) =>
    byName(of.robots[a]?.name ?? "", of.robots[b]?.name ?? ""));
  element("robots").replaceChildren(...sorted.map((i) => {
    const item = document.createElement("li");
    item.append(robotButtons[i] ?? "");
    return item;
  }));
}

function choose(robot: number): void {
  stop();
  chosen = robot;
  stage.choose(robot);
  plots.choose(scene, robot);
  devices.choose(robot);
  robotButtons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === robot)));
}

function showStates(shown: Frame): void {
  element("clock").textContent = `${shown.time.toFixed(1)} s`;
  element("rate").textContent = rateText(shown);
  shown.robots.forEach((state, i) => {
    const line = robotButtons[i]?.querySelector(".state");
    if (line == null) return;
    line.textContent = state.stalled
      ? "stalled"
      : `${state.x.toFixed(2)}, ${state.y.toFixed(2)}  ${state.v.toFixed(2)} m/s`;
    line.classList.toggle("stalled", state.stalled);
  });
}

function rateText(shown: Frame): string {
  if (shown.paused) {
    return scene?.record != null && shown.time >= scene.record.seconds - 1e-3 ? "at the end" : "paused";
  }
  if (shown.rate < 1e-4) return "waiting";
  const digits = shown.rate < 0.1 ? 3 : shown.rate < 100 ? 2 : 0;
  return `${shown.rate.toFixed(digits)} x real time`;
}

function deviceOf(robot: number, type: string): string | undefined {
  return scene?.robots[robot]?.devices.find((device) => device.type === type)?.name;
}

function call(component: string | undefined, service: string, args: unknown[]): void {
  if (component === undefined) {
    notice("This robot has no device for that.");
    return;
  }
  if (!mayDrive()) {
    notice(scene?.record != null ? "This is a record: it can only be watched." : "This view is read-only.");
    return;
  }
  connection.call(component, service, args).catch((error: Error) => notice(error.message));
}

function mayDrive(): boolean {
  return scene !== null && scene.record === null && !scene.read_only;
}

// --- Driving by keyboard or with a finger: speeds, sent ten times a second

const held = new Set<string>();
const KEYS: Record<string, string> = {
  ArrowUp: "up", KeyW: "up", ArrowDown: "down", KeyS: "down",
  ArrowLeft: "left", KeyA: "left", ArrowRight: "right", KeyD: "right",
};
let driving = 0;
let stick = { v: 0, w: 0 }; // parts of the highest speeds

const pad = new Pad((v, w) => {
  stick = { v, w };
  if (driving === 0) driving = window.setInterval(drive, DRIVE_PERIOD_MS);
  if (v === 0 && w === 0) drive();
});

function drive(): void {
  const robot = scene?.robots[chosen];
  if (robot === undefined) return;
  const axis = (plus: string, minus: string) =>
    (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0);
  const forward = Math.max(-1, Math.min(1, axis("up", "down") + stick.v));
  const left = Math.max(-1, Math.min(1, axis("left", "right") + stick.w));
  const keyboard = deviceOf(chosen, "Keyboard"); // MORSE's, which knows its own speed
  if (keyboard !== undefined) {
    call(keyboard, "drive", [forward, left]);
  } else {
    const v = 0.6 * robot.max_speed * forward;
    const w = 0.5 * robot.max_turn_rate * left;
    call(deviceOf(chosen, "MotionVW"), "set_speed", [v, w]);
  }
  if (held.size === 0 && stick.v === 0 && stick.w === 0) {
    clearInterval(driving);
    driving = 0;
  }
}

function stop(): void {
  if (driving === 0) return;
  pad.release();
  held.clear();
  drive();
}

addEventListener("keydown", (event) => {
  const target = event.target as HTMLElement;
  if (target.closest("input:not([type=checkbox]), select, textarea") !== null) return;
  if (event.ctrlKey && (event.code === "ArrowUp" || event.code === "ArrowDown")) {
    stepMode(event.code === "ArrowUp" ? 1 : -1);
    event.preventDefault();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey || element<HTMLDialogElement>("help").open) return;
  const key = KEYS[event.code];
  if (key !== undefined) {
    event.preventDefault();
    if (held.has(key) || event.repeat) return;
    held.add(key);
    if (driving === 0) driving = window.setInterval(drive, DRIVE_PERIOD_MS);
    drive();
  } else if (event.code === "Space" && target.closest("button, input, summary") === null) {
    event.preventDefault();
    if (scene?.record != null) return timeBar.toggle();
    held.clear();
    drive();
  } else if (event.key === "Escape") {
    obstacles.escape();
  } else if (event.key === "?") {
    showHelp();
  } else if (SHORTCUTS[event.key] !== undefined) {
    SHORTCUTS[event.key]?.();
  } else if (/^Digit[1-4]$/.test(event.code)) {
    const camera = CAMERAS[Number(event.code.slice(5)) - 1];
    if (camera !== undefined) setCamera(camera.kind);
  } else if (event.code === "KeyH") {
    togglePanel();
  }
});
const SHORTCUTS: Record<string, () => void> = {
  k: () => timeBar.toggle(),
  ".": () => timeBar.step(),
  "-": () => timeBar.changeSpeed(-1),
  "+": () => timeBar.changeSpeed(1),
  "=": () => timeBar.changeSpeed(1), // + without Shift
  j: () => timeBar.seekBy(-SEEK_STEP),
  l: () => timeBar.seekBy(SEEK_STEP),
  p: () => files.picture(),
  v: () => files.film(),
  o: () => obstacles.toggle(),
};

addEventListener("keyup", (event) => {
  const key = KEYS[event.code];
  if (key === undefined || !held.delete(key)) return;
  drive();
});
addEventListener("blur", stop);

// --- Mouse and touch: obstacles, drag a robot, or send it somewhere

function sendTo(x: number, y: number): void {
  const place = stage.floorAt(x, y);
  if (place === null) return;
  call(deviceOf(chosen, "Waypoint"), "goto", [place.x, place.y, 0, 0.05, 0.2]);
}

const obstacles = new Obstacles(
  stage, (service, args) => connection.call("arena", service, args), notice, sendTo);

let dragged = -1;
stageCanvas.addEventListener("pointerdown", (event) => {
  if (event.button !== 0 || !event.isPrimary) return;
  if (event.shiftKey || stage.robotAt(event.clientX, event.clientY) < 0) {
    if (obstacles.down(event)) {
      stageCanvas.setPointerCapture(event.pointerId);
      return;
    }
  }
  if (event.shiftKey) {
    sendTo(event.clientX, event.clientY);
    return;
  }
  const robot = stage.robotAt(event.clientX, event.clientY);
  if (robot < 0) return;
  choose(robot);
  if (!mayDrive()) return;
  dragged = robot;
  stage.setControls(false);
  stageCanvas.setPointerCapture(event.pointerId);
});
stageCanvas.addEventListener("pointermove", (event) => {
  if (event.isPrimary) obstacles.move(event);
});
stageCanvas.addEventListener("pointercancel", () => obstacles.cancel());
stageCanvas.addEventListener("pointerup", (event) => {
  if (event.isPrimary && obstacles.up(event)) return;
  if (dragged < 0) return;
  const robot = scene?.robots[dragged];
  const from = frame?.robots[dragged];
  const place = stage.floorAt(event.clientX, event.clientY);
  dragged = -1;
  stage.setControls(true);
  if (robot === undefined || from === undefined || place === null) return;
  if (Math.hypot(place.x - from.x, place.y - from.y) < 0.1) return;  // a click
  call("simulation", "set_object_position", [robot.name, [place.x, place.y, 0], [0, 0, from.yaw]]);
});

// --- The panel

function togglePanel(): void {
  const panel = element("panel");
  showPanel(panel.hidden);
}
function showPanel(shown: boolean): void {
  const panel = element("panel");
  panel.hidden = !shown;
  element("panel-button").setAttribute("aria-expanded", String(shown));
  document.documentElement.classList.toggle("beside-panel", shown);
  stage.setCovered(shown && !SMALL.matches ? panel.offsetWidth : 0);
}
element("panel-button").onclick = togglePanel;
const SMALL = matchMedia("(max-width: 600px)");
showPanel(!SMALL.matches); // it would cover all
SMALL.addEventListener("change", () => showPanel(!SMALL.matches));

function showHelp(): void {
  element<HTMLDialogElement>("help").showModal();
}
element("help-button").onclick = showHelp;

// --- Time, plots, devices, log, files

const timeBar = new TimeBar((service, args) => {
  connection.call("ccmorse", service, args).catch((error: Error) => notice(error.message));
});
element("reset").onclick = () => call("simulation", "reset_objects", []);
const ask = (component: string, service: string) => connection.call(component, service, []);
const plots = new Plots(ask);
const devices = new Devices(ask);
const log = new LogView(
  (args) => connection.call("ccmorse", "log", args),
  (args) => connection.call("arena", "events", args));
const canvasLayers = new CanvasLayers(
  (component, service, args) => connection.call(component, service, args), notice);
const files = new Export(
  () => (mode === "fullscreen" ? map : stageCanvas),
  () => `${scene?.scene ?? "ccmorse"}-${(frame?.time ?? 0).toFixed(1)}s`,
  notice);

// Pictures a second, over the last second.
let framesBefore = 0;
let countedAt = performance.now();
let perSecond = 0;
setInterval(() => {
  const now = performance.now();
  perSecond = ((stage.frames - framesBefore) * 1000) / (now - countedAt);
  framesBefore = stage.frames;
  countedAt = now;
  element("fps").textContent = `${perSecond.toFixed(0)} pictures/s`;
}, 1000);

// --- The simulator

const DRIVE_HINTS = {
  drive: "Choose one and drive it with the arrow keys or W A S D; Space stops. Drag a robot to move it; Shift + click sends it to a place.",
  look: "This view is read-only: choose a robot to look at.",
  record: "This is a record: choose a robot to look at.",
};

const STATES: Record<LinkState, string> = {
  connecting: "connecting ...",
  connected: "",
  lost: "connection lost, trying again ...",
};

// Over the stage while there is nothing to be seen, or nothing new.
function showCurtain(state: LinkState): void {
  const curtain = element("curtain");
  if (state === "connected" && scene !== null) {
    curtain.hidden = true;
    return;
  }
  if (state === "connected" || (state === "connecting" && !curtain.hidden)) return;
  curtain.hidden = false;
  curtain.classList.toggle("lost", scene !== null);
  if (scene === null && state === "connecting") return; // index.html says it
  element("curtain-title").textContent =
    scene === null ? "There is no simulation at this address" : "The simulation is gone";
  element("curtain-text").textContent =
    "It has ended, or the connection is broken. This page looks for it every second and comes back by itself.";
}

const connection = new Connection({
  scene(sent) {
    const first = scene === null;
    scene = sent;
    document.title = `${sent.scene} - CCMorse`;
    element("scene").textContent = sent.scene;
    showCurtain("connected");
    log.clear();
    timeBar.setScene(sent);
    stage.setScene(sent);
    allowLayers(sent);
    listRobots(sent);
    devices.setScene(sent);
    canvasLayers.setScene(sent);
    obstacles.setScene(sent);
    pad.allow(mayDrive());
    element("drive-hint").textContent = DRIVE_HINTS[
      sent.record !== null ? "record" : sent.read_only ? "look" : "drive"];
    choose(Math.min(chosen, Math.max(0, sent.robots.length - 1)));
    if (first) setCamera("orbit");
    setMode(first ? sent.canvas.mode : mode);
    const fixed = !sent.canvas.mode_switching;
    element("modes")
      .querySelectorAll("button")
      .forEach((button) => (button.disabled = fixed));
    element("mode-hint").textContent = fixed
      ? "The scenario fixes where the canvas is shown."
      : "Left Ctrl + Up or Down switches, too.";
  },
  frame(sent) {
    frame = sent;
    stage.show(sent);
    showMap(sent);
    showStates(sent);
    timeBar.show(sent);
    plots.show(sent);
    canvasLayers.showFrame(sent);
    obstacles.showFrame(sent);
    log.setEvents(mayDrive() ? sent.arenaEvents : 0);
  },
  state(state) {
    const link = element("link");
    link.textContent = STATES[state];
    link.classList.toggle("lost", state === "lost");
    showCurtain(state);
  },
});

type Point = [number, number, number];

// For tests, measurements and scripts.
declare global {
  interface Window {
    ccmorse: {
      frames(): number;
      framesPerSecond(): number;
      points(): { name: string; times: number[]; values: number[] }[];
      scene(): Scene | null;
      frame(): Frame | null;
      find(robot: number): { x: number; y: number };
      findBox(id: number): { x: number; y: number } | null;
      boxAround(thing: string): Point[];
      beams(laser: string): Point[];
      sights(): { name: string; shown: boolean; corners: Point[] }[];
      look(from: Point, at: Point): void;
      call(component: string, service: string, args: unknown[]): Promise<unknown>;
    };
  }
}
window.ccmorse = {
  frames: () => stage.frames,
  framesPerSecond: () => perSecond,
  points: () => plots.points(),
  scene: () => scene,
  frame: () => frame,
  find: (robot) => stage.find(robot),
  findBox: (id) => {
    const place = stage.boxPlace(scene?.boxes.findIndex((box) => box.id === id) ?? -1);
    return place === null ? null : stage.placeOf(place);
  },
  boxAround: (name) =>
    stage.thingBox(scene?.things.findIndex((thing) => thing.name === name) ?? -1),
  beams: (name) => stage.beamEnds(scene?.lasers.findIndex((laser) => laser.name === name) ?? -1),
  sights: () => stage.sightLines(),
  look: (from, at) => stage.look(from, at),
  call: (component, service, args) => connection.call(component, service, args),
};
