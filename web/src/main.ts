import { Connection, type LinkState } from "./connection";
import type { CanvasMode, Frame, Scene } from "./protocol";
import { type CameraKind, type Layers, Stage } from "./stage";

const CAMERAS: { kind: CameraKind; name: string; title: string }[] = [
  { kind: "orbit", name: "Orbit", title: "As the scenario says; drag to turn (1)" },
  { kind: "follow", name: "Follow", title: "Behind the chosen robot (2)" },
  { kind: "top", name: "Top", title: "From above (3)" },
  { kind: "robot", name: "Robot", title: "Through the chosen robot's eyes (4)" },
];
const LAYERS: { key: keyof Layers; name: string }[] = [
  { key: "lasers", name: "Laser scans" },
  { key: "rings", name: "Sonar and infra-red" },
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

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`the page has no #${id}`);
  return found as T;
}

const stageCanvas = element<HTMLCanvasElement>("stage");
const stage = new Stage(stageCanvas);
const map = element<HTMLCanvasElement>("map");
let scene: Scene | null = null;
let frame: Frame | null = null;
let chosen = 0;
let mode: CanvasMode = "ground";
let noticeTimer = 0;

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
  const list = element("robots");
  list.replaceChildren();
  of.robots.forEach((robot, i) => {
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
    const item = document.createElement("li");
    item.append(button);
    list.append(item);
  });
}

function choose(robot: number): void {
  stop();
  chosen = robot;
  stage.choose(robot);
  element("robots")
    .querySelectorAll("button")
    .forEach((button, i) => button.setAttribute("aria-pressed", String(i === robot)));
}

function showStates(shown: Frame): void {
  element("clock").textContent = `${shown.time.toFixed(1)} s`;
  element("rate").textContent = shown.rate > 0 ? `${shown.rate.toPrecision(3)} x real time` : "waiting";
  const lines = element("robots").querySelectorAll<HTMLElement>(".state");
  shown.robots.forEach((state, i) => {
    const line = lines[i];
    if (line === undefined) return;
    line.textContent = state.stalled
      ? "stalled"
      : `${state.x.toFixed(2)}, ${state.y.toFixed(2)}  ${state.v.toFixed(2)} m/s`;
    line.classList.toggle("stalled", state.stalled);
  });
}

function deviceOf(robot: number, type: string): string | undefined {
  return scene?.robots[robot]?.devices.find((device) => device.type === type)?.name;
}

function call(component: string | undefined, service: string, args: unknown[]): void {
  if (component === undefined) {
    notice("This robot has no device for that.");
    return;
  }
  connection.call(component, service, args).catch((error: Error) => notice(error.message));
}

// --- Driving by keyboard: held keys are speeds, sent ten times a second

const held = new Set<string>();
const KEYS: Record<string, string> = {
  ArrowUp: "up", KeyW: "up", ArrowDown: "down", KeyS: "down",
  ArrowLeft: "left", KeyA: "left", ArrowRight: "right", KeyD: "right",
};
let driving = 0;

function drive(): void {
  const robot = scene?.robots[chosen];
  if (robot === undefined) return;
  const axis = (plus: string, minus: string) =>
    (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0);
  const v = 0.6 * robot.max_speed * axis("up", "down");
  const w = 0.5 * robot.max_turn_rate * axis("left", "right");
  call(deviceOf(chosen, "MotionVW"), "set_speed", [v, w]);
  if (held.size === 0) {
    clearInterval(driving);
    driving = 0;
  }
}

function stop(): void {
  if (driving === 0) return;
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
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const key = KEYS[event.code];
  if (key !== undefined) {
    event.preventDefault();
    if (held.has(key)) return;
    held.add(key);
    if (driving === 0) driving = window.setInterval(drive, DRIVE_PERIOD_MS);
    drive();
  } else if (event.code === "Space" && target.closest("button, input") === null) {
    held.clear();
    drive();
    event.preventDefault();
  } else if (/^Digit[1-4]$/.test(event.code)) {
    const camera = CAMERAS[Number(event.code.slice(5)) - 1];
    if (camera !== undefined) setCamera(camera.kind);
  } else if (event.code === "KeyH") {
    togglePanel();
  }
});
addEventListener("keyup", (event) => {
  const key = KEYS[event.code];
  if (key === undefined || !held.delete(key)) return;
  drive();
});
addEventListener("blur", stop);

// --- Mouse and touch: drag a robot, or send it somewhere

let dragged = -1;
stageCanvas.addEventListener("pointerdown", (event) => {
  if (event.button !== 0) return;
  if (event.shiftKey) {
    const place = stage.floorAt(event.clientX, event.clientY);
    if (place !== null) {
      call(deviceOf(chosen, "Waypoint"), "goto", [place.x, place.y, 0, 0.05, 0.2]);
    }
    return;
  }
  const robot = stage.robotAt(event.clientX, event.clientY);
  if (robot < 0) return;
  choose(robot);
  dragged = robot;
  stage.setControls(false);
  stageCanvas.setPointerCapture(event.pointerId);
});
stageCanvas.addEventListener("pointerup", (event) => {
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
  panel.hidden = !panel.hidden;
  element("panel-button").setAttribute("aria-expanded", String(!panel.hidden));
}
element("panel-button").onclick = togglePanel;

// --- The simulator

const STATES: Record<LinkState, string> = {
  connecting: "connecting ...",
  connected: "",
  lost: "connection lost, trying again ...",
};

const connection = new Connection({
  scene(sent) {
    const first = scene === null;
    scene = sent;
    document.title = `${sent.scene} - CCMorse`;
    element("scene").textContent = sent.scene;
    stage.setScene(sent);
    listRobots(sent);
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
  },
  state(state) {
    const link = element("link");
    link.textContent = STATES[state];
    link.classList.toggle("lost", state === "lost");
  },
});

type Point = [number, number, number];

// For tests, measurements and scripts.
declare global {
  interface Window {
    ccmorse: {
      frames(): number;
      scene(): Scene | null;
      frame(): Frame | null;
      find(robot: number): { x: number; y: number };
      look(from: Point, at: Point): void;
      call(component: string, service: string, args: unknown[]): Promise<unknown>;
    };
  }
}
window.ccmorse = {
  frames: () => stage.frames,
  scene: () => scene,
  frame: () => frame,
  find: (robot) => stage.find(robot),
  look: (from, at) => stage.look(from, at),
  call: (component, service, args) => connection.call(component, service, args),
};
