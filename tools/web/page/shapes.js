// Shapes that the picture of the robot is made of, by three.js: copies of one shape, rods, arrows, changing lines.
import * as three from "./three.module.min.js";

export const kUp = new three.Vector3(0, 1, 0);  // along which three.js makes its cylinders and cones
const kNowhere = new three.Matrix4().makeScale(0, 0, 0);
const kLeast = 0.02;  // m: a shorter arrow is hidden

/// Copies of one shape, in one call of the graphics system.
export class Copies {
  constructor(parent, count, geometry, material) {
    this.mesh = new three.InstancedMesh(geometry, material, count);
    this.mesh.frustumCulled = false;  // they move
    this.matrix = new three.Matrix4();
    this.turn = new three.Quaternion();
    this.size = new three.Vector3();
    for (let i = 0; i < count; i += 1) {
      this.mesh.setMatrixAt(i, kNowhere);
    }
    parent.add(this.mesh);
  }

  hide(i) {
    this.mesh.setMatrixAt(i, kNowhere);
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  /// Turned from the axis of three.js's shapes to a direction of unit length.
  put(i, middle, direction, width, length) {
    this.turn.setFromUnitVectors(kUp, direction);
    this.mesh.setMatrixAt(i, this.matrix.compose(middle, this.turn, this.size.set(width, length, width)));
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}

/// Rods between two points.
export class Rods {
  constructor(parent, count, radius, material) {
    this.copies = new Copies(parent, count, new three.CylinderGeometry(radius, radius, 1, 12), material);
    this.middle = new three.Vector3();
    this.along = new three.Vector3();
  }

  put(i, from, to) {
    const length = this.along.subVectors(to, from).length();
    if (length < 1e-6) {
      this.copies.hide(i);
    } else {
      this.copies.put(i, this.middle.addVectors(from, to).multiplyScalar(0.5), this.along.divideScalar(length), 1, length);
    }
  }

  hide(i) {
    this.copies.hide(i);
  }
}

export class Arrows {
  constructor(parent, count, radius, material) {
    this.head = 5 * radius;
    this.rods = new Rods(parent, count, radius, material);
    this.heads = new Copies(parent, count, new three.ConeGeometry(2.6 * radius, this.head, 14), material);
    this.count = count;
    [this.end, this.neck, this.along] = [1, 2, 3].map(() => new three.Vector3());
  }

  /// From a point along a vector, in m.
  put(i, from, vector) {
    const length = vector.length();
    if (length < kLeast) {
      this.hide(i);
      return;
    }
    this.along.copy(vector).divideScalar(length);
    this.neck.copy(from).addScaledVector(this.along, Math.max(0, length - this.head));
    this.end.copy(this.neck).addScaledVector(this.along, this.head / 2);
    this.rods.put(i, from, this.neck);
    this.heads.put(i, this.end, this.along, 1, 1);
  }

  hide(i) {
    this.rods.hide(i);
    this.heads.hide(i);
  }
}

/// Points that change, as a line or as triangles from the first of them.
export function changing(most, make) {
  const geometry = new three.BufferGeometry();
  const points = new three.BufferAttribute(new Float32Array(3 * most), 3).setUsage(three.DynamicDrawUsage);
  geometry.setAttribute("position", points);
  const thing = make(geometry);
  thing.frustumCulled = false;
  /// Three numbers a point; the last `most` points.
  thing.set = (numbers) => {
    points.array.set(numbers.slice(-3 * most));
    points.needsUpdate = true;
    const count = Math.min(most, numbers.length / 3);
    geometry.setDrawRange(0, geometry.index ? 3 * Math.max(0, count - 2) : count);
  };
  return thing;
}
