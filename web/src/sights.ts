import * as THREE from "three";
import type { Frustum, Radar } from "./protocol";

const COLOR = 0x8b5cf6;
// Opacities: of the tint near the sensor, of lines before it begins, there, where the tint ends, and at the far end.
const TINT = 0.16;
const FIRST_LINE = 0.35;
const NEAR_LINE = 0.95;
const MIDDLE_LINE = 0.5;
const FAR_LINE = 0.16;
const RIM = 48; // points around a radar's cone
const RINGS = 4; // from its axis to its edge

type Point = [number, number, number];

// Points with an opacity each.
class Points {
  private readonly positions: number[] = [];
  private readonly colors: number[] = [];
  private readonly color = new THREE.Color(COLOR);

  add(opacity: number, ...points: Point[]): this {
    for (const point of points) {
      this.positions.push(...point);
      this.colors.push(this.color.r, this.color.g, this.color.b, opacity);
    }
    return this;
  }

  /** As attributes of a geometry. */
  geometry(): THREE.BufferGeometry {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(this.positions, 3));
    geometry.setAttribute("color", new THREE.Float32BufferAttribute(this.colors, 4));
    return geometry;
  }
}

/**
 * What a camera or a radar takes in, on its robot: thin lines to the far end, and faces whose tint
 * fades, so that what reaches beyond the world does not cover it.
 */
export class Sight {
  readonly group = new THREE.Group();

  private constructor(
    readonly name: string,
    private readonly rest: { position: Point; rotation: Point },
    lines: Points,
    faces: Points,
  ) {
    const options = { vertexColors: true, transparent: true, depthWrite: false };
    this.group.add(
      new THREE.LineSegments(lines.geometry(), new THREE.LineBasicMaterial(options)),
      new THREE.Mesh(faces.geometry(), new THREE.MeshBasicMaterial({
        ...options, side: THREE.DoubleSide,
      })),
    );
    for (const child of this.group.children) {
      child.frustumCulled = false;
      child.renderOrder = 2;
    }
    this.place(null);
  }

  /** A camera's pyramid, whose top is drawn only as lines; `reach`: m, how far it is tinted. */
  static ofCamera(frustum: Frustum, reach: number): Sight {
    const corners = (distance: number): Point[] => {
      const y = distance * frustum.half_width;
      const z = distance * frustum.half_height;
      return [[distance, y, z], [distance, -y, z], [distance, -y, -z], [distance, y, -z]];
    };
    const far = Math.max(frustum.near, frustum.far);
    const middle = Math.min(far, Math.max(frustum.near, reach));
    const [low, mid, high] = [corners(frustum.near), corners(middle), corners(far)];
    const lines = new Points();
    const faces = new Points();
    const end = middle < far ? 0 : TINT / 2;
    for (let i = 0; i < 4; ++i) {
      const next = (i + 1) % 4;
      lines.add(FIRST_LINE, [0, 0, 0], low[i]!);
      lines.add(NEAR_LINE, low[i]!, low[next]!, low[i]!).add(MIDDLE_LINE, mid[i]!, mid[i]!);
      const opacity = middle < far ? FAR_LINE : MIDDLE_LINE;
      lines.add(opacity, high[i]!, high[i]!, high[next]!);
      faces.add(TINT, low[i]!, low[next]!).add(end, mid[next]!);
      faces.add(TINT, low[i]!).add(end, mid[next]!, mid[i]!);
    }
    if (end > 0) faces.add(end, high[0]!, high[1]!, high[2]!, high[0]!, high[2]!, high[3]!);
    return new Sight(frustum.name, frustum, lines, faces);
  }

  /** A part of a ball around the sensor. */
  static ofRadar(radar: Radar, reach: number): Sight {
    const half = Math.min(Math.PI, radar.angle / 2);
    const at = (off: number, round: number, distance: number): Point => [
      distance * Math.cos(off),
      distance * Math.sin(off) * Math.cos(round),
      distance * Math.sin(off) * Math.sin(round),
    ];
    const middle = Math.min(radar.range, reach);
    const end = middle < radar.range ? 0 : TINT / 2;
    const edge = middle < radar.range ? FAR_LINE : MIDDLE_LINE;
    const lines = new Points();
    const faces = new Points();
    for (let i = 0; i < RIM; ++i) {
      const [from, to] = [(2 * Math.PI * i) / RIM, (2 * Math.PI * (i + 1)) / RIM];
      faces.add(TINT, [0, 0, 0]).add(end, at(half, from, middle), at(half, to, middle));
      lines.add(edge, at(half, from, radar.range), at(half, to, radar.range));
      for (let ring = 0; ring < RINGS; ++ring) {
        const [inner, outer] = [(half * ring) / RINGS, (half * (ring + 1)) / RINGS];
        const corners = [at(inner, from, middle), at(outer, from, middle),
          at(outer, to, middle), at(inner, to, middle)] as const;
        if (end > 0) faces.add(end, corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]);
        // Four lines from the tip to the edge, and over the end from edge to edge.
        if (i % (RIM / 4) === 0) {
          lines.add(edge, at(inner, from, radar.range), at(outer, from, radar.range));
        }
      }
      if (i % (RIM / 4) === 0) {
        lines.add(NEAR_LINE, [0, 0, 0]).add(MIDDLE_LINE, at(half, from, middle));
        lines.add(MIDDLE_LINE, at(half, from, middle)).add(edge, at(half, from, radar.range));
      }
    }
    return new Sight(radar.name, radar, lines, faces);
  }

  /** Where the sensor is on its robot; null: where it was when the run began. */
  place(mount: { position: Point; rotation: Point } | null): void {
    const { position, rotation } = mount ?? this.rest;
    this.group.position.set(...position);
    this.group.rotation.set(...rotation, "ZYX");
  }

  /** The ends of its lines in the world, m, each once, as drawn. */
  corners(): Point[] {
    this.group.updateWorldMatrix(true, true);
    const lines = this.group.children[0] as THREE.LineSegments;
    const positions = lines.geometry.getAttribute("position");
    const found = new Map<string, Point>();
    for (let i = 0; i < positions.count; ++i) {
      const point = new THREE.Vector3().fromBufferAttribute(positions, i);
      found.set(point.toArray().join(), point.applyMatrix4(lines.matrixWorld).toArray());
    }
    return [...found.values()];
  }
}
