// What the simulator sends (docs/protocols/view.md): a scene once, as JSON, then frames in bytes.

export interface Box {
  id: number;
  kind: string;
  x: number;
  y: number;
  yaw: number;
  size_x: number;
  size_y: number;
  height: number;
  color: number;
  dynamic: boolean;
}

export interface Mesh {
  id: number;
  position: [number, number, number];
  rotation: [number, number, number];
  color: number;
  palette: number[];
  color_of: number[]; // index of palette by triangle; empty: all have color
  vertices: [number, number, number][];
  triangles: [number, number, number][];
}

/** A passive object, as the run began. */
export interface Thing {
  name: string;
  position: [number, number, number]; // m
  rotation: [number, number, number]; // roll, pitch, yaw, rad
  meshes: number[]; // ids of those that it is made of
}

export interface Light {
  kind: "sun" | "spot";
  position: [number, number, number];
  energy: number;
  shadows: boolean;
}

export interface Robot {
  name: string;
  type: string;
  color: number;
  hull: { outline: [number, number][]; bottom: number; top: number }[];
  length: number;
  width: number;
  height: number;
  origin: number; // m above the floor
  shape: number; // of scene.shapes, in the robot's own frame; -1: none but the hull
  clearance: number;
  wheel_radius: number;
  wheel_width: number;
  wheel_track: number;
  max_speed: number;
  max_turn_rate: number;
  start: [number, number, number]; // x, y, m; yaw, rad
  devices: { name: string; type: string }[];
}

export interface Laser {
  robot: number;
  name: string;
  position: [number, number, number]; // on the robot; z above the floor, m
  rotation: [number, number, number]; // there: roll, pitch, yaw, rad
  flat: boolean; // all its beams are in the plane of its x and y
  first: number; // rad, bearing of the first beam there
  last: number; // rad
  samples: number;
  range: number; // m
}

export interface Ring {
  robot: number;
  name: string;
  range: number; // m
  cone: number; // rad, full
  poses: [number, number, number, number][]; // x, y, height above the floor, m; yaw, rad
}

/** What a camera sees into: a pyramid along its x without its top. */
export interface Frustum {
  robot: number;
  name: string;
  position: [number, number, number]; // on the robot; z above the floor, m
  rotation: [number, number, number]; // there: roll, pitch, yaw, rad
  near: number; // m
  far: number; // m
  half_width: number; // m to each side at 1 m
  half_height: number; // m up and down at 1 m
}

/** What a radar sees into: a cone around its x, of a ball. */
export interface Radar {
  robot: number;
  name: string;
  position: [number, number, number];
  rotation: [number, number, number];
  angle: number; // rad, full
  range: number; // m
}

export type CanvasMode = "ground" | "minimap" | "fullscreen";

export interface Scene {
  scene: string;
  world: string;
  size_x: number;
  size_y: number;
  low: [number, number]; // of the floor, m
  floor: number | null; // null: meshes are the ground
  boxes: Box[];
  meshes: Mesh[];
  things: Thing[];
  lights: Light[];
  robots: Robot[];
  shapes: Mesh[][];
  lasers: Laser[];
  rings: Ring[];
  frusta: Frustum[];
  radars: Radar[];
  camera: { position: [number, number, number]; rotation: [number, number, number] };
  canvas: { alpha: number; mode: CanvasMode; mode_switching: boolean };
  read_only: boolean;
  record: { file: string; seconds: number } | null; // what is shown is a record
}

export interface RobotState {
  x: number;
  y: number;
  yaw: number;
  v: number;
  w: number;
  stalled: boolean;
  z: number; // m, of the ground beneath it
  roll: number;
  pitch: number;
}

export interface Scan {
  sensor: number; // index into lasers, then rings
  ranges: Uint16Array; // parts of the sensor's range, 65535 is all of it
}

export interface CanvasRow {
  y: number; // from the bottom
  rgba: Uint8Array;
}

export const BOX_UP = 1;
export const BOX_WAITING = 2; // it comes up as soon as no robot stands there

export interface MovedBox {
  box: number; // its place in the scene
  x: number;
  y: number;
  yaw: number;
}

export interface MovedSensor {
  sensor: number; // index into frusta, then radars, then lasers
  position: [number, number, number]; // as in the scene
  rotation: [number, number, number];
}

export interface MovedThing {
  thing: number; // its place in the scene
  position: [number, number, number]; // m
  rotation: [number, number, number]; // rad
}

export interface Frame {
  paused: boolean;
  time: number; // s, simulated
  rate: number; // simulated seconds per second, measured
  speed: number; // wanted; Infinity: as many as can be
  robots: RobotState[];
  boxes: Uint8Array; // one a box: BOX_UP, BOX_WAITING
  moved: MovedBox[]; // those that are elsewhere than in the scene
  arenaEvents: number; // so far
  movedSensors: MovedSensor[]; // those that their robot has elsewhere than in the scene
  movedThings: MovedThing[]; // those that are elsewhere than in the scene
  scans: Scan[];
  canvasWidth: number; // cells
  canvasHeight: number;
  canvasLayers: number; // changes with the list of layers; 0 while there was none
  rows: CanvasRow[]; // those that have changed
}

export function readFrame(buffer: ArrayBuffer): Frame {
  const view = new DataView(buffer);
  let at = 0;
  const word = () => ((at += 4), view.getUint32(at - 4, true));
  const single = () => ((at += 4), view.getFloat32(at - 4, true));
  const pad = () => (at = (at + 3) & ~3);
  if (word() !== 1) throw new Error("unknown message from the simulator");
  const paused = word() === 1;
  const time = view.getFloat64(at, true);
  at += 8;
  const speed = view.getFloat64(at, true);
  at += 8;
  const rate = single();
  const robots: RobotState[] = [];
  for (let left = word(); left > 0; --left) {
    robots.push({
      x: single(),
      y: single(),
      yaw: single(),
      v: single(),
      w: single(),
      stalled: word() === 1,
      z: single(),
      roll: single(),
      pitch: single(),
    });
  }
  const boxCount = word();
  const boxes = new Uint8Array(buffer, at, boxCount);
  at += boxCount;
  pad();
  const moved: MovedBox[] = [];
  for (let left = word(); left > 0; --left) {
    moved.push({ box: word(), x: single(), y: single(), yaw: single() });
  }
  const arenaEvents = word();
  const point = (): [number, number, number] => [single(), single(), single()];
  const movedSensors: MovedSensor[] = [];
  for (let left = word(); left > 0; --left) {
    movedSensors.push({ sensor: word(), position: point(), rotation: point() });
  }
  const movedThings: MovedThing[] = [];
  for (let left = word(); left > 0; --left) {
    movedThings.push({ thing: word(), position: point(), rotation: point() });
  }
  const scans: Scan[] = [];
  for (let left = word(); left > 0; --left) {
    const sensor = word();
    const count = word();
    scans.push({ sensor, ranges: new Uint16Array(buffer, at, count) });
    at += 2 * count;
    pad();
  }
  const canvasWidth = word();
  const canvasHeight = word();
  const canvasLayers = word();
  const rows: CanvasRow[] = [];
  for (let left = word(); left > 0; --left) {
    const y = word();
    rows.push({ y, rgba: new Uint8Array(buffer, at, 4 * canvasWidth) });
    at += 4 * canvasWidth;
  }
  return {
    paused, time, rate, speed, robots, boxes, moved, arenaEvents, movedSensors, movedThings, scans,
    canvasWidth, canvasHeight, canvasLayers, rows,
  };
}
