import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { Boxes } from "./boxes";
import type {
  Frame, Laser, Mesh, MovedThing, Robot, RobotState, Scene, Thing,
} from "./protocol";
import { type Quality, prism, surface } from "./shapes";
import { Sight } from "./sights";

export type CameraKind = "orbit" | "follow" | "top" | "robot";

export interface Layers {
  lasers: boolean;
  rings: boolean;
  sights: boolean;
  trails: boolean;
  speeds: boolean;
  names: boolean;
}

const STEPS = 65535; // of a range, protocol.ts
const TRAIL_POINTS = 4000;
const TRAIL_STEP = 0.01; // m
const JUMP = 0.3; // m from frame to frame, more than any drive makes
const LASER_COLOR = 0x1e8bff;
const RING_COLOR = 0xffa028;
const FIELD = 42; // degrees from top to bottom, on a screen that is
const WIDE = 1.5; // times as wide as high, or more
const WIDEST = 80; // degrees
const TINT_REACH = 10; // lengths of a robot, as far as what its cameras see is tinted
const IN_THE_AIR = 0.3; // m: a robot whose body is higher does not stand on the floor
const SHADOWS = 4; // m around where the camera looks, at least, that have shadows
const SLAB_COLOR = 0x5c636b; // beneath the floor

// Of its floor, m.
function middleOf(scene: Scene): THREE.Vector3 {
  return new THREE.Vector3(
    scene.low[0] + scene.size_x / 2, scene.low[1] + scene.size_y / 2, 0);
}

// Low where a processor has to draw, and where the page's address says ?quality=low.
function chooseQuality(): Quality {
  const asked = new URLSearchParams(location.search).get("quality");
  if (asked === "high" || asked === "low") return asked;
  const context = document.createElement("canvas").getContext("webgl2");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(context?.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name) ? "low" : "high";
}

/** A filled fan that a sensor sees, one triangle between two neighbouring beams. */
class Fan {
  readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.MeshBasicMaterial>;
  private readonly positions: THREE.BufferAttribute;

  constructor(
    private readonly bearings: Float32Array,
    private readonly range: number,
    color: number,
  ) {
    const beams = bearings.length;
    const geometry = new THREE.BufferGeometry();
    this.positions = new THREE.BufferAttribute(new Float32Array(3 * (beams + 1)), 3);
    this.positions.setUsage(THREE.DynamicDrawUsage);
    geometry.setAttribute("position", this.positions);
    const indexes: number[] = [];
    for (let i = 1; i < beams; ++i) indexes.push(0, i, i + 1);
    geometry.setIndex(indexes);
    this.mesh = new THREE.Mesh(
      geometry,
      new THREE.MeshBasicMaterial({
        color,
        transparent: true,
        opacity: 0.22,
        side: THREE.DoubleSide,
        depthWrite: false,
      }),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
  }

  /** `only`: all beams have this one range (a cone), in parts of the sensor's. */
  show(ranges: Uint16Array, only = -1): void {
    const array = this.positions.array as Float32Array;
    this.bearings.forEach((bearing, i) => {
      const range = ((only >= 0 ? ranges[only] : ranges[i]) ?? 0) * (this.range / STEPS);
      array[3 * (i + 1)] = range * Math.cos(bearing);
      array[3 * (i + 1) + 1] = range * Math.sin(bearing);
    });
    this.positions.needsUpdate = true;
  }
}

/** The way a robot has come, a line on the floor. */
class Trail {
  readonly line: THREE.Line<THREE.BufferGeometry, THREE.LineBasicMaterial>;
  private readonly positions = new THREE.BufferAttribute(new Float32Array(3 * TRAIL_POINTS), 3);
  private count = 0;
  private last = new THREE.Vector2(Infinity, Infinity);

  constructor(color: number) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", this.positions);
    geometry.setDrawRange(0, 0);
    this.line = new THREE.Line(geometry, new THREE.LineBasicMaterial({ color }));
    this.line.frustumCulled = false;
  }

  clear(): void {
    this.count = 0;
    this.line.geometry.setDrawRange(0, 0);
    this.last.set(Infinity, Infinity);
  }

  add(x: number, y: number, z: number): void {
    const step = Math.hypot(x - this.last.x, y - this.last.y);
    if (step < TRAIL_STEP) return;
    if (step > JUMP) this.count = 0; // it was put there
    if (this.count === TRAIL_POINTS) {
      // The older half goes.
      this.positions.array.copyWithin(0, (3 * TRAIL_POINTS) / 2);
      this.count = TRAIL_POINTS / 2;
    }
    this.positions.setXYZ(this.count++, x, y, z + 0.004);
    this.positions.needsUpdate = true;
    this.line.geometry.setDrawRange(0, this.count);
    this.last.set(x, y);
  }
}

function nameTag(text: string): THREE.Sprite {
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d")!;
  const font = "600 44px system-ui, sans-serif";
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 40;
  canvas.height = 68;
  pen.font = font;
  pen.fillStyle = "rgba(18, 26, 34, 0.78)";
  pen.beginPath();
  pen.roundRect(0, 0, canvas.width, canvas.height, 20);
  pen.fill();
  pen.fillStyle = "#fff";
  pen.textBaseline = "middle";
  pen.fillText(text, 20, 36);
  const map = new THREE.CanvasTexture(canvas);
  map.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(
    new THREE.SpriteMaterial({ map, depthTest: false, sizeAttenuation: false }),
  );
  const height = 0.022;
  sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
  sprite.renderOrder = 5;
  return sprite;
}

// A body of triangles, each flat and of its own colour.
function meshOf(mesh: Mesh, quality: Quality): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(mesh.vertices.flat(), 3));
  geometry.setIndex(mesh.triangles.flat());
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  const own = mesh.color_of.length > 0;
  if (own) {
    const palette = mesh.palette.map((color) => new THREE.Color(color).toArray());
    const colors = mesh.color_of.flatMap((i) => [palette[i]!, palette[i]!, palette[i]!].flat());
    flat.setAttribute("color", new THREE.Float32BufferAttribute(colors, 3));
  }
  const body = new THREE.Mesh(
    flat,
    surface(quality, {
      color: own ? 0xffffff : mesh.color, roughness: 0.7, side: THREE.DoubleSide,
      vertexColors: own,
    }),
  );
  body.position.set(...mesh.position);
  body.rotation.set(...mesh.rotation, "ZYX");
  body.castShadow = true;
  body.receiveShadow = true;
  return body;
}

/** A passive object: its meshes, which stand where they did in the scene until it is moved. */
class ThingModel {
  readonly group = new THREE.Group();
  private readonly back: THREE.Matrix4; // from the world to its frame, as the run began
  private moved = false;

  constructor(readonly thing: Thing) {
    this.group.matrixAutoUpdate = false;
    this.back = pose(thing.position, thing.rotation).invert();
  }

  /** null: where it was when the run began. */
  place(moved: MovedThing | null): void {
    if (moved === null && !this.moved) return;
    this.moved = moved !== null;
    if (moved === null) this.group.matrix.identity();
    else this.group.matrix.multiplyMatrices(pose(moved.position, moved.rotation), this.back);
    this.group.matrixWorldNeedsUpdate = true;
  }
}

function pose(position: [number, number, number], rotation: [number, number, number]): THREE.Matrix4 {
  return new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(...rotation, "ZYX"))
    .setPosition(...position);
}

class RobotModel {
  readonly group = new THREE.Group();
  readonly fans: Fan[] = []; // of lasers
  readonly cones: { fan: Fan; sensor: number; index: number }[] = [];
  readonly sights: Sight[] = []; // of cameras and radars
  readonly trail: Trail;
  readonly foot: number; // m above the floor at first, of its body: one may begin in the air
  readonly tag: THREE.Sprite;
  private readonly wheels: THREE.Group[] = [];
  private readonly arrow: THREE.ArrowHelper;

  constructor(
    readonly robot: Robot,
    private readonly index: number,
    private readonly quality: Quality,
    shape: Mesh[] | undefined,
  ) {
    this.group.rotation.order = "ZYX";
    const bottom = Math.min(...robot.hull.map((part) => part.bottom));
    this.foot = Number.isFinite(bottom) && bottom > IN_THE_AIR ? bottom : 0;
    const body =
      quality === "high"
        ? new THREE.MeshPhysicalMaterial({
            color: robot.color,
            roughness: 0.42,
            metalness: 0.05,
            clearcoat: 0.5,
            clearcoatRoughness: 0.3,
          })
        : surface(quality, { color: robot.color });
    const dark = surface(quality, { color: 0x22262b, roughness: 0.6 });
    if (shape !== undefined) {
      const holder = new THREE.Group();
      holder.position.z = robot.origin;
      for (const mesh of shape) holder.add(meshOf(mesh, quality));
      this.group.add(holder);
    }
    (shape === undefined ? robot.hull : []).forEach((part, i) => {
      // Where the lower part is wider it is the chassis, dark; the upper one wears the colour.
      const chassis = robot.hull.length > 1 && i === 0;
      const bottom = Math.max(part.bottom, robot.clearance);
      this.add(new THREE.Mesh(prism(part.outline, bottom, part.top), chassis ? dark : body));
    });
    if (robot.wheel_radius > 0) this.addWheels(robot, dark);
    this.trail = new Trail(robot.color);
    this.tag = nameTag(robot.name);
    this.tag.position.z = robot.height + 0.12;
    this.group.add(this.tag);
    this.arrow = new THREE.ArrowHelper(
      new THREE.Vector3(1, 0, 0), new THREE.Vector3(0, 0, robot.height + 0.01), 0.1, 0x18a058);
    this.group.add(this.arrow);
    this.group.traverse((object) => (object.userData["robot"] = index));
  }

  addLaser(fan: Fan): THREE.Group {
    const box = new THREE.Mesh(
      new THREE.CylinderGeometry(0.024, 0.026, 0.045, 32).rotateX(Math.PI / 2),
      surface(this.quality, { color: 0x111417, roughness: 0.25, metalness: 0.3 }),
    );
    box.userData["robot"] = this.index;
    box.castShadow = true;
    box.receiveShadow = true;
    const scanner = new THREE.Group();
    scanner.add(box, fan.mesh);
    this.group.add(scanner);
    this.fans.push(fan);
    return scanner;
  }

  show(state: RobotState, seconds: number, layers: Layers): void {
    this.group.rotation.set(state.roll, state.pitch, state.yaw, "ZYX");
    this.group.position.set(state.x, state.y, state.z);
    if (state.roll !== 0 || state.pitch !== 0) {
      // It leans about its own origin, not about its foot.
      const up = new THREE.Vector3(0, 0, this.robot.origin);
      this.group.position.add(up).sub(up.clone().applyEuler(this.group.rotation));
    }
    this.wheels.forEach((wheel, side) => {
      const turn = ((side === 0 ? -1 : 1) * state.w * this.robot.wheel_track) / 2;
      wheel.rotation.y += ((state.v + turn) * seconds) / this.robot.wheel_radius;
    });
    this.trail.add(state.x, state.y, state.z + this.foot);
    this.trail.line.visible = layers.trails;
    this.tag.visible = layers.names;
    this.arrow.visible = layers.speeds && Math.abs(state.v) > 1e-3;
    this.arrow.setDirection(new THREE.Vector3(Math.sign(state.v) || 1, 0, 0));
    this.arrow.setLength(0.05 + Math.abs(state.v), 0.04, 0.03);
    for (const fan of this.fans) fan.mesh.visible = layers.lasers;
    for (const { fan } of this.cones) fan.mesh.visible = layers.rings;
  }

  showBody(on: boolean): void {
    this.group.traverse((object) => {
      if (object instanceof THREE.Mesh && object.material.depthWrite !== false) object.visible = on;
    });
  }

  showSights(on: boolean): void {
    for (const sight of this.sights) sight.group.visible = on;
  }

  private add(mesh: THREE.Mesh): void {
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    this.group.add(mesh);
  }

  private addWheels(robot: Robot, rubber: THREE.Material): void {
    const rim = surface(this.quality, { color: 0xb9c0c7, roughness: 0.35, metalness: 0.8 });
    for (const side of [1, -1]) {
      const wheel = new THREE.Group();
      const tyre = new THREE.Mesh(
        new THREE.CylinderGeometry(robot.wheel_radius, robot.wheel_radius, robot.wheel_width, 40),
        rubber,
      );
      // Spokes, so that one sees it turn.
      for (const angle of [0, Math.PI / 2]) {
        const spoke = new THREE.Mesh(
          new THREE.BoxGeometry(1.5 * robot.wheel_radius, robot.wheel_width * 1.15, 0.006), rim);
        spoke.rotation.y = angle;
        wheel.add(spoke);
      }
      tyre.castShadow = true;
      wheel.add(tyre);
      wheel.position.set(0, (side * robot.wheel_track) / 2, robot.wheel_radius);
      this.wheels.push(wheel);
      this.group.add(wheel);
    }
  }
}

/** The 3-D picture: the scene as sent, moved by frames. */
export class Stage {
  readonly layers: Layers = {
    lasers: true, rings: true, sights: true, trails: true, speeds: false, names: false,
  };
  private readonly quality = chooseQuality();
  private readonly renderer: THREE.WebGLRenderer;
  private readonly world = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(FIELD, 1, 0.02, 500);
  private readonly controls: OrbitControls;
  private content = new THREE.Group();
  private scene: Scene | null = null;
  private robots: RobotModel[] = [];
  private sun: { light: THREE.DirectionalLight; from: THREE.Vector3; half: number } | null = null;
  private things: ThingModel[] = []; // in the scene's order
  private scanners: { laser: Laser; fan: Fan; group: THREE.Group }[] = []; // in the scene's order
  private sights: Sight[] = []; // in the scene's order: frusta, then radars
  private boxes = new Boxes([], "low");
  private editing = false;
  private canvasPixels: Uint8Array = new Uint8Array(4);
  private canvasTexture: THREE.DataTexture | null = null;
  private canvasPlane: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial> | null = null;
  private states: RobotState[] = [];
  private lastTime = 0;
  private kind: CameraKind = "orbit";
  private chosen = 0;
  private groundCanvas = true;
  private covered = 0; // px, of the right side
  frames = 0; // drawn so far, for those who measure

  constructor(private readonly canvas: HTMLCanvasElement) {
    const fine = this.quality === "high";
    document.documentElement.classList.toggle("plain", !fine); // for view.css
    this.renderer = new THREE.WebGLRenderer({
      canvas, antialias: fine, preserveDrawingBuffer: true,
    });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = fine ? THREE.PCFSoftShadowMap : THREE.BasicShadowMap;
    this.renderer.shadowMap.autoUpdate = fine;
    this.renderer.toneMapping = THREE.ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 1.0;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    if (fine) {
      const light = new THREE.PMREMGenerator(this.renderer);
      this.world.environment = light.fromScene(new RoomEnvironment(), 0.04).texture;
      this.world.environmentIntensity = 0.45;
    } else {
      const sky = new THREE.HemisphereLight(0xffffff, 0xb0a898, 1.5);
      sky.position.set(0, 0, 1);
      this.world.add(sky);
    }
    this.world.add(this.content);
    this.setDark(matchMedia("(prefers-color-scheme: dark)").matches);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) =>
      this.setDark(event.matches));
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    this.renderer.setAnimationLoop(() => this.draw());
  }

  setScene(scene: Scene): void {
    const again = this.scene !== null;
    this.scene = scene;
    this.world.remove(this.content);
    this.content = new THREE.Group();
    this.robots = [];
    this.canvasTexture = null;
    this.canvasPlane = null;
    this.lastTime = 0;
    this.addFloor(scene);
    this.addLights(scene);
    this.boxes = new Boxes(scene.boxes, this.quality);
    this.boxes.setEditing(this.editing);
    this.content.add(this.boxes.group);
    this.things = scene.things.map((thing) => new ThingModel(thing));
    const holders = new Map<number, THREE.Group>(); // by a mesh's id
    for (const { thing, group } of this.things) {
      this.content.add(group);
      for (const id of thing.meshes) holders.set(id, group);
    }
    for (const mesh of scene.meshes) {
      (holders.get(mesh.id) ?? this.content).add(meshOf(mesh, this.quality));
    }
    scene.robots.forEach((robot, i) => {
      const model = new RobotModel(robot, i, this.quality, scene.shapes[robot.shape]);
      this.robots.push(model);
      this.content.add(model.group, model.trail.line);
    });
    this.scanners = [];
    for (const laser of scene.lasers) {
      const bearings = new Float32Array(laser.samples);
      const step = (laser.last - laser.first) / Math.max(1, laser.samples - 1);
      for (let i = 0; i < laser.samples; ++i) bearings[i] = laser.first + i * step;
      const fan = new Fan(laser.flat ? bearings : new Float32Array(0), laser.range, LASER_COLOR);
      this.scanners.push({ laser, fan, group: this.robots[laser.robot]!.addLaser(fan) });
    }
    scene.rings.forEach((ring, number) => {
      const robot = this.robots[ring.robot];
      ring.poses.forEach(([x, y, z, yaw], index) => {
        const bearings = new Float32Array(9);
        bearings.forEach((_, i) => (bearings[i] = ring.cone * (i / 8 - 0.5)));
        const fan = new Fan(bearings, ring.range, RING_COLOR);
        fan.mesh.position.set(x, y, z);
        fan.mesh.rotation.z = yaw;
        robot?.group.add(fan.mesh);
        robot?.cones.push({ fan, sensor: scene.lasers.length + number, index });
      });
    });
    this.sights = [
      ...scene.frusta.map((frustum) => Sight.ofCamera(frustum, this.tintReach(frustum.robot))),
      ...scene.radars.map((radar) => Sight.ofRadar(radar, this.tintReach(radar.robot))),
    ];
    [...scene.frusta, ...scene.radars].forEach(({ robot }, i) => {
      const sight = this.sights[i]!;
      this.robots[robot]?.group.add(sight.group);
      this.robots[robot]?.sights.push(sight);
    });
    this.world.add(this.content);
    if (!again) this.setCamera("orbit");
  }

  show(frame: Frame): void {
    if (this.scene === null) return;
    const seconds = Math.min(0.2, Math.max(0, frame.time - this.lastTime));
    // A jump back in a record.
    if (frame.time < this.lastTime) for (const robot of this.robots) robot.trail.clear();
    this.lastTime = frame.time;
    this.states = frame.robots;
    frame.robots.forEach((state, i) => this.robots[i]?.show(state, seconds, this.layers));
    this.boxes.show(frame);
    const moved = new Map(frame.movedThings.map((each) => [each.thing, each]));
    this.things.forEach((thing, i) => thing.place(moved.get(i) ?? null));
    const carried = new Map(frame.movedSensors.map((each) => [each.sensor, each]));
    this.sights.forEach((sight, i) => sight.place(carried.get(i) ?? null));
    this.scanners.forEach(({ laser, group }, i) => {
      const { position, rotation } = carried.get(this.sights.length + i) ?? laser;
      group.position.set(...position);
      group.rotation.set(...rotation, "ZYX");
    });
    for (const scan of frame.scans) {
      const laser: Laser | undefined = this.scene.lasers[scan.sensor];
      if (laser !== undefined) {
        const robot = this.robots[laser.robot];
        const own = this.scene.lasers.filter((other) => other.robot === laser.robot).indexOf(laser);
        robot?.fans[own]?.show(scan.ranges);
        continue;
      }
      const ring = this.scene.rings[scan.sensor - this.scene.lasers.length];
      if (ring === undefined) continue;
      for (const cone of this.robots[ring.robot]?.cones ?? []) {
        if (cone.sensor === scan.sensor) cone.fan.show(scan.ranges, cone.index);
      }
    }
    this.showCanvas(frame);
  }

  setGroundCanvas(shown: boolean): void {
    this.groundCanvas = shown;
    if (this.canvasPlane !== null) this.canvasPlane.visible = shown;
  }

  setCamera(kind: CameraKind): void {
    this.kind = kind;
    this.controls.enabled = kind !== "robot";
    const scene = this.scene;
    if (scene === null) return;
    const middle = middleOf(scene);
    if (kind === "orbit") {
      // The scenario's camera: MORSE's Euler angles XYZ, which are three's ZYX; (0, 0, 0) looks
      // straight down.
      const { position, rotation } = scene.camera;
      const looks = new THREE.Vector3(0, 0, -1).applyEuler(new THREE.Euler(...rotation, "ZYX"));
      this.camera.position.set(...position);
      const reach = looks.z < -0.05 ? position[2] / -looks.z : middle.distanceTo(this.camera.position);
      this.controls.target.copy(this.camera.position).addScaledVector(looks, reach);
    } else if (kind === "top") {
      const half = Math.tan((this.camera.fov * Math.PI) / 360);
      const high = Math.max(scene.size_y, scene.size_x / this.camera.aspect) / 2 / half;
      this.camera.position.set(middle.x, middle.y - 0.001, 1.06 * high);
      this.controls.target.copy(middle);
    } else if (kind === "follow") {
      const state = this.states[this.chosen];
      if (state !== undefined) {
        // As far behind as the robot is large.
        const far = Math.max(0.9, 2.5 * (this.robots[this.chosen]?.robot.length ?? 0));
        const foot = state.z + (this.robots[this.chosen]?.foot ?? 0);
        this.controls.target.set(state.x, state.y, foot + 0.1);
        this.camera.position.set(
          state.x - far * Math.cos(state.yaw), state.y - far * Math.sin(state.yaw),
          foot + (0.65 / 0.9) * far);
      }
    }
    this.controls.update();
  }

  /** Looks from one point to another, m. */
  look(from: [number, number, number], at: [number, number, number]): void {
    this.setCamera("orbit");
    this.camera.position.set(...from);
    this.controls.target.set(...at);
    this.controls.update();
  }

  choose(robot: number): void {
    this.robots[this.chosen]?.showBody(true); // to the eyes of the next one
    this.chosen = robot;
  }

  /** The robot under a place of the page, -1 for none. */
  robotAt(x: number, y: number): number {
    const groups = this.robots.map((robot) => robot.group);
    for (const hit of this.ray(x, y).intersectObjects(groups, true)) {
      const robot: unknown = hit.object.userData["robot"];
      if (typeof robot === "number" && hit.object.type === "Mesh") return robot;
    }
    return -1;
  }

  /** Where a robot is on the page. */
  find(robot: number): { x: number; y: number } {
    const model = this.robots[robot];
    const at = new THREE.Vector3(0, 0, ((model?.foot ?? 0) + (model?.robot.height ?? 0)) / 2);
    return this.placeOf(model === undefined ? at : at.add(model.group.position));
  }

  /** Where a point, m, is on the page. */
  placeOf(point: THREE.Vector3): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const at = point.clone().project(this.camera);
    return {
      x: box.left + ((at.x + 1) / 2) * box.width,
      y: box.top + ((1 - at.y) / 2) * box.height,
    };
  }

  // --- Dynamic boxes, by their place in the scene

  /** Whether they are to be changed: then those that are down are to be seen, too. */
  setEditing(on: boolean): void {
    this.editing = on;
    this.boxes.setEditing(on);
  }

  /** The one under a place of the page, up or, while they are changed, down; -1 for none. */
  boxAt(x: number, y: number): number {
    return this.boxes.at(this.ray(x, y));
  }

  /** Where the middle of a box is on the floor, m. */
  boxPlace(box: number): THREE.Vector3 | null {
    return this.boxes.place(box);
  }

  /** Shows a box at another place than the simulator says, until the next frame after letGoOfBox(). */
  holdBox(box: number, x: number, y: number): void {
    this.boxes.hold(box, x, y);
  }

  /** `back`: at once to where the simulator has it. */
  letGoOfBox(back: boolean): void {
    this.boxes.letGo(back);
  }

  /** The point of the floor under a place of the page. */
  floorAt(x: number, y: number): THREE.Vector3 | null {
    const floor = new THREE.Plane(new THREE.Vector3(0, 0, 1), 0);
    return this.ray(x, y).ray.intersectPlane(floor, new THREE.Vector3());
  }

  /** So much of the right side is covered, px: the middle of the picture moves out from under it. */
  setCovered(width: number): void {
    this.covered = width;
    this.resize();
  }

  /** Corners of the box around a passive object in the world, low and high, m, as drawn. */
  thingBox(thing: number): [number, number, number][] {
    const group = this.things[thing]?.group;
    if (group === undefined) return [];
    group.updateWorldMatrix(true, true);
    const { min, max } = new THREE.Box3().setFromObject(group, true);
    return [min.toArray(), max.toArray()];
  }

  /** Where a laser's beams end, m, in the world, as drawn. */
  beamEnds(laser: number): [number, number, number][] {
    const mesh = this.scanners[laser]?.fan.mesh;
    if (mesh === undefined) return [];
    mesh.updateWorldMatrix(true, false);
    const ends = mesh.geometry.getAttribute("position");
    return Array.from({ length: ends.count - 1 }, (_, i) =>
      new THREE.Vector3().fromBufferAttribute(ends, i + 1).applyMatrix4(mesh.matrixWorld).toArray());
  }

  /** What cameras and radars see into: the ends of the lines, m, in the world, as drawn. */
  sightLines(): { name: string; shown: boolean; corners: [number, number, number][] }[] {
    return this.sights.map((sight) => ({
      name: sight.name, shown: sight.group.visible, corners: sight.corners(),
    }));
  }

  setControls(on: boolean): void {
    this.controls.enabled = on && this.kind !== "robot";
  }

  private tintReach(robot: number): number {
    return TINT_REACH * (this.robots[robot]?.robot.length ?? 1);
  }

  private ray(x: number, y: number): THREE.Raycaster {
    const box = this.canvas.getBoundingClientRect();
    const place = new THREE.Vector2(
      ((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(place, this.camera);
    return ray;
  }

  private addFloor(scene: Scene): void {
    if (scene.floor === null) return;
    const slab = surface(this.quality, { color: SLAB_COLOR, roughness: 0.9 });
    const top = surface(this.quality, { color: scene.floor, roughness: 0.9 });
    const floor = new THREE.Mesh(
      new THREE.BoxGeometry(scene.size_x, scene.size_y, 0.04), [slab, slab, slab, slab, top, slab]);
    floor.position.copy(middleOf(scene)).setZ(-0.02);
    floor.receiveShadow = true;
    this.content.add(floor);
    const around = new THREE.Mesh(
      new THREE.CircleGeometry(40 * Math.max(1, scene.size_x, scene.size_y), 64),
      new THREE.ShadowMaterial({ opacity: 0.16 }),
    );
    around.position.copy(middleOf(scene)).setZ(-0.04);
    around.receiveShadow = true;
    this.content.add(around);
  }

  private addLights(scene: Scene): void {
    const middle = middleOf(scene);
    const sunAt = scene.lights.find((light) => light.kind === "sun")?.position;
    const sun = new THREE.DirectionalLight(0xfff4e2, 2.1);
    const from = new THREE.Vector3(...(sunAt ?? [-0.5, -0.7, 1.4])).normalize();
    if (from.x === 0 && from.y === 0) from.set(-0.35, -0.5, 1).normalize();
    sun.castShadow = true;
    const texels = this.quality === "high" ? 2048 : 1024;
    sun.shadow.mapSize.set(texels, texels);
    sun.shadow.radius = 4;
    this.content.add(sun, sun.target);
    this.sun = { light: sun, from, half: 0 };
    this.aimSun();
    for (const light of scene.lights) {
      if (light.kind !== "spot" || this.quality === "low") continue;
      const spot = new THREE.SpotLight(0xffffff, 2.5 * light.energy, 0, Math.PI / 4, 0.8, 1.6);
      spot.position.set(...light.position);
      spot.target.position.copy(middle);
      this.content.add(spot, spot.target);
    }
  }

  /** Its shadows are as fine as they are many: those of a large world are around where one looks. */
  private aimSun(): void {
    if (this.sun === null || this.scene === null) return;
    const { light, from } = this.sun;
    const size = Math.max(this.scene.size_x, this.scene.size_y);
    const far = this.camera.position.distanceTo(this.controls.target);
    // In steps, so that what stands still keeps its shadow's edge.
    const near = SHADOWS * 2 ** Math.max(0, Math.ceil(Math.log2((2 * far) / SHADOWS)));
    const half = Math.min(0.75 * size, near);
    const to = middleOf(this.scene);
    if (near < 0.75 * size) {
      const step = half / 4;
      to.copy(this.controls.target).divideScalar(step).round().multiplyScalar(step);
    }
    if (half === this.sun.half && to.equals(light.target.position)) return;
    this.sun.half = half;
    light.position.copy(to).addScaledVector(from, 2.5 * size);
    light.target.position.copy(to);
    light.target.updateMatrixWorld();
    Object.assign(light.shadow.camera, {
      left: -half, right: half, top: half, bottom: -half, near: 0.1, far: 6 * size,
    });
    light.shadow.camera.updateProjectionMatrix();
    // As wide as what one of its points covers, or surfaces shade themselves in stripes.
    light.shadow.normalBias = Math.max(0.01, (3 * half) / light.shadow.mapSize.x);
  }

  private showCanvas(frame: Frame): void {
    const scene = this.scene;
    if (scene === null || frame.canvasWidth === 0) return;
    const { canvasWidth: width, canvasHeight: height } = frame;
    if (this.canvasTexture === null || this.canvasTexture.image.width !== width ||
        this.canvasTexture.image.height !== height) {
      this.canvasPixels = new Uint8Array(4 * width * height);
      this.canvasTexture = new THREE.DataTexture(this.canvasPixels, width, height);
      this.canvasTexture.colorSpace = THREE.SRGBColorSpace;
      this.canvasTexture.magFilter = THREE.NearestFilter;
      if (this.canvasPlane !== null) this.content.remove(this.canvasPlane);
      // Square cells that cover the whole world (canvas.h).
      const cell = Math.max(scene.size_x / width, scene.size_y / height);
      this.canvasPlane = new THREE.Mesh(
        new THREE.PlaneGeometry(cell * width, cell * height),
        new THREE.MeshBasicMaterial({
          map: this.canvasTexture, transparent: true, opacity: scene.canvas.alpha,
          depthWrite: false, toneMapped: false,
        }),
      );
      this.canvasPlane.position.set(
        scene.low[0] + (cell * width) / 2, scene.low[1] + (cell * height) / 2, 0.002);
      this.canvasPlane.renderOrder = 1;
      this.canvasPlane.visible = this.groundCanvas;
      this.content.add(this.canvasPlane);
    }
    if (frame.rows.length === 0) return;
    for (const row of frame.rows) this.canvasPixels.set(row.rgba, 4 * width * row.y);
    this.canvasTexture.needsUpdate = true;
  }

  private setDark(dark: boolean): void {
    this.world.background = new THREE.Color(dark ? 0x151c24 : 0xdfe6ec);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    this.renderer.setPixelRatio(this.quality === "high" ? Math.min(2, devicePixelRatio) : 0.75);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / Math.max(1, clientHeight);
    const free = Math.max(0.3 * clientWidth, clientWidth - this.covered);
    this.camera.setViewOffset(
      clientWidth, clientHeight, (clientWidth - free) / 2, 0, clientWidth, clientHeight);
    // An upright screen shows as much from side to side as a wide one.
    const half = Math.tan((FIELD * Math.PI) / 360) * Math.max(1, (WIDE * clientHeight) / free);
    this.camera.fov = Math.min(WIDEST, (Math.atan(half) * 360) / Math.PI);
    this.camera.updateProjectionMatrix();
  }

  private draw(): void {
    const state = this.states[this.chosen];
    const robot = this.robots[this.chosen];
    if (state !== undefined && robot !== undefined) {
      if (this.kind === "follow") {
        const to = new THREE.Vector3(state.x, state.y, state.z + robot.foot + 0.1);
        this.camera.position.add(to.clone().sub(this.controls.target));
        this.controls.target.copy(to);
      } else if (this.kind === "robot") {
        const eye = state.z + robot.robot.height + 0.03;
        this.camera.position.set(state.x, state.y, eye);
        this.camera.lookAt(
          state.x + Math.cos(state.yaw), state.y + Math.sin(state.yaw), eye - 0.12);
      }
    }
    if (this.kind !== "robot") this.controls.update();
    // From its own eyes a robot does not see itself, and what it sees into would tint all of it.
    robot?.showBody(this.kind !== "robot");
    for (const each of this.robots) {
      each.showSights(this.layers.sights && (each !== robot || this.kind !== "robot"));
    }
    this.aimSun();
    // Shadows of what moves little may be a few frames late where each costs.
    if (this.quality === "low" && this.frames % 4 === 0) this.renderer.shadowMap.needsUpdate = true;
    this.renderer.render(this.world, this.camera);
    ++this.frames;
  }
}
