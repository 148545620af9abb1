import * as THREE from "three";

/** How much the picture may cost. */
export type Quality = "high" | "low";

/** An outline in the plane, m, from `bottom` to `top`, with slightly broken edges. */
export function prism(outline: [number, number][], bottom: number, top: number): THREE.BufferGeometry {
  const shape = new THREE.Shape(outline.map(([x, y]) => new THREE.Vector2(x, y)));
  const bevel = Math.min(0.004, (top - bottom) / 4);
  const geometry = new THREE.ExtrudeGeometry(shape, {
    depth: top - bottom - 2 * bevel,
    bevelEnabled: true,
    bevelThickness: bevel,
    bevelSize: bevel,
    bevelOffset: -bevel,
    bevelSegments: 2,
  });
  geometry.translate(0, 0, bottom + bevel);
  return geometry;
}

/** Physically based where the picture may cost, else plain diffuse. */
export function surface(quality: Quality, options: THREE.MeshStandardMaterialParameters): THREE.Material {
  if (quality === "high") return new THREE.MeshStandardMaterial(options);
  return new THREE.MeshLambertMaterial({
    color: options.color, side: options.side ?? THREE.FrontSide,
    vertexColors: options.vertexColors ?? false,
  });
}
