import * as THREE from "three";
import { BOX_UP, BOX_WAITING, type Box, type Frame } from "./protocol";
import { type Quality, prism, surface } from "./shapes";

const DOWN_COLOR = 0x6f7d8a;
const WAITING_COLOR = 0xff8c1a;
const LEAST_HIT = 0.14; // m: thinner boxes are hit beside them, too
const CLEAR = 0.004; // m above the floor, so that lines are not fought for

// One box: standing, as an outline on the floor, or as the edges of what is to come up.
interface Model {
  box: Box;
  solid: THREE.Mesh;
  outline: THREE.LineLoop | null; // these only where it is dynamic
  edges: THREE.LineSegments | null;
  ground: THREE.Mesh | null; // not drawn, only hit
  group: THREE.Group;
}

function corners(box: Box): [number, number][] {
  const x = box.size_x / 2;
  const y = box.size_y / 2;
  return [[-x, -y], [x, -y], [x, y], [-x, y]];
}

/** The boxes of a scene, each where the frames say it is. */
export class Boxes {
  readonly group = new THREE.Group();
  private readonly models: Model[];
  private frame: Frame | null = null;
  private editing = false;
  private held: { box: number; x: number; y: number } | null = null;

  constructor(boxes: Box[], quality: Quality) {
    const down = new THREE.LineBasicMaterial({ color: DOWN_COLOR, transparent: true, opacity: 0.75 });
    const waiting = new THREE.LineBasicMaterial({ color: WAITING_COLOR });
    this.models = boxes.map((box) => {
      const solid = new THREE.Mesh(
        prism(corners(box), 0, box.height), surface(quality, { color: box.color, roughness: 0.72 }));
      solid.castShadow = true;
      solid.receiveShadow = true;
      const group = new THREE.Group();
      group.position.set(box.x, box.y, 0);
      group.rotation.z = box.yaw;
      group.add(solid);
      const model: Model = { box, solid, outline: null, edges: null, ground: null, group };
      if (box.dynamic) this.addLines(model, down, waiting);
      this.group.add(group);
      return model;
    });
  }

  show(frame: Frame): void {
    this.frame = frame;
    const moved = new Map(frame.moved.map((each) => [each.box, each]));
    this.models.forEach((model, i) => {
      const flags = frame.boxes[i] ?? 0;
      const up = (flags & BOX_UP) !== 0;
      model.solid.visible = up;
      if (!model.box.dynamic) return;
      const waits = (flags & BOX_WAITING) !== 0;
      if (model.edges !== null) model.edges.visible = waits;
      if (model.outline !== null) model.outline.visible = !up && (waits || this.editing);
      const at = moved.get(i) ?? model.box;
      const held = this.held?.box === i ? this.held : at;
      model.group.position.set(held.x, held.y, 0);
      model.group.rotation.z = at.yaw;
    });
  }

  setEditing(on: boolean): void {
    this.editing = on;
    if (this.frame !== null) this.show(this.frame);
  }

  /** The dynamic box that a ray hits, -1 for none. */
  at(ray: THREE.Raycaster): number {
    const targets = this.models.flatMap(({ solid, ground }) =>
      ground === null ? [] : solid.visible ? [solid, ground] : [ground]);
    const hit = ray.intersectObjects(targets, false)[0]?.object;
    return this.models.findIndex(({ solid, ground }) =>
      hit !== undefined && (solid === hit || ground === hit));
  }

  place(box: number): THREE.Vector3 | null {
    return this.models[box]?.group.position.clone() ?? null;
  }

  hold(box: number, x: number, y: number): void {
    this.held = { box, x, y };
    this.models[box]?.group.position.set(x, y, 0);
  }

  letGo(back: boolean): void {
    this.held = null;
    if (back && this.frame !== null) this.show(this.frame);
  }

  private addLines(
    model: Model, down: THREE.LineBasicMaterial, waiting: THREE.LineBasicMaterial,
  ): void {
    const { box, group } = model;
    const flat = new THREE.BufferGeometry().setFromPoints(
      corners(box).map(([x, y]) => new THREE.Vector3(x, y, CLEAR)));
    model.outline = new THREE.LineLoop(flat, down);
    model.edges = new THREE.LineSegments(
      new THREE.EdgesGeometry(new THREE.BoxGeometry(box.size_x, box.size_y, box.height)), waiting);
    model.edges.position.z = box.height / 2 + CLEAR;
    model.ground = new THREE.Mesh(new THREE.PlaneGeometry(
      Math.max(LEAST_HIT, box.size_x), Math.max(LEAST_HIT, box.size_y)));
    model.ground.visible = false; // a ray hits it all the same
    model.outline.visible = false;
    model.edges.visible = false;
    group.add(model.outline, model.edges, model.ground);
  }
}
