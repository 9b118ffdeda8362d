// The picture of the robot: a ground that scrolls, trunk, legs, forces and velocities, by three.js. A worker draws it, so
// that charts do not wait where a computer has no graphics processor. Axes are the world's: z up. One metre of an arrow
// is 1 m/s, or the robot's weight.
import * as three from "./three.module.min.js";
import { kAngle_deg } from "./eye.js";
import { Arrows, Copies, Rods, changing, kUp } from "./shapes.js";

const kGrid = 12;             // m
const kLeg = 0.03;            // m, radius of a link
const kMostTrail = 400;
const kBeside = 0.04;         // m, between the arrows of what is and of what is felt
const kSlow_ms = 200;         // between drawings that a processor makes, at least
const kRest = 9;              // of a processor that draws: nine times as long as it has drawn
const kMostRatio = 1.5;       // pixels of the picture per pixel of the style sheet

const at = ([x, y, z], to = new three.Vector3()) => to.set(x, y, z);

/// Sides of squares of a metre: drawing by the processor loses longer lines, which end behind the camera.
function groundLines() {
  const points = [], half = kGrid / 2;
  for (let x = -half; x <= half; x += 1) {
    for (let y = -half; y < half; y += 1) {
      points.push(x, y, 0, x, y + 1, 0, y, x, 0, y + 1, x, 0);
    }
  }
  return new three.BufferGeometry().setAttribute("position", new three.Float32BufferAttribute(points, 3));
}

/// True where a graphics processor draws. Otherwise the processor does.
function isFast() {
  const probe = new OffscreenCanvas(1, 1).getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  probe?.getExtension("WEBGL_lose_context")?.loseContext();
  return probe !== null;
}

class Scene {
  /// Refuses, with the reason, where a browser has no WebGL. `canvas`: an OffscreenCanvas.
  constructor(canvas, shapes) {
    const fast = isFast();
    const context = canvas.getContext("webgl2", { alpha: true, antialias: fast });
    if (!context) {
      throw new Error("this browser has no WebGL 2.");
    }
    this.shapes = shapes;
    this.fast = fast;
    this.rest = 0;
    this.drawn = -Infinity;
    this.ratio = fast ? kMostRatio : 1;
    this.renderer = new three.WebGLRenderer({ canvas, context, alpha: true });
    this.root = new three.Scene();
    this.camera = new three.PerspectiveCamera(kAngle_deg, 1, 0.05, 60);
    this.camera.up.set(0, 0, 1);
    this.build();
  }

  build() {
    const { trunk, legs } = this.shapes, { root } = this;
    const sun = new three.DirectionalLight(0xffffff, 2.2);
    sun.position.set(1, -2, 4);
    root.add(new three.HemisphereLight(0xffffff, 0x999999, 2.4), sun);
    const painted = (name, more = {}) => Object.assign(new three.MeshLambertMaterial(more), { name });
    const flat = (name, more = {}) => Object.assign(new three.MeshBasicMaterial(more), { name });
    this.grid = new three.LineSegments(groundLines(), Object.assign(new three.LineBasicMaterial(), { name: "rule" }));

    this.robot = new three.Group();
    const box = new three.BoxGeometry(...trunk.size);
    this.trunk = new three.Mesh(box, painted("rule", { transparent: true, opacity: 0.6 }));
    this.trunk.position.set(...trunk.centre);
    this.trunk.add(new three.LineSegments(new three.EdgesGeometry(box), Object.assign(new three.LineBasicMaterial(), { name: "ink" })));
    const nose = new three.Mesh(new three.ConeGeometry(0.05, 0.12, 16), painted("ink"));
    nose.rotation.z = -Math.PI / 2;
    nose.position.x = trunk.size[0] / 2 + 0.06;
    this.trunk.add(nose);
    this.robot.add(this.trunk);
    const bodywork = painted("faint");
    this.links = new Rods(this.robot, 3 * legs.length, kLeg, bodywork);
    this.joints = new Copies(this.robot, 2 * legs.length, new three.SphereGeometry(1.35 * kLeg, 16, 12), bodywork);
    const foot = new three.SphereGeometry(1, 16, 12);
    this.standing = new Copies(this.robot, legs.length, foot, painted("blue"));
    this.lifted = new Copies(this.robot, legs.length, foot, painted("orange"));

    this.trueForces = new Arrows(root, legs.length, 0.014, painted("green"));
    this.feltForces = new Arrows(root, legs.length, 0.008, painted("orange"));
    this.command = new Arrows(root, 1, 0.014, painted("purple"));
    this.velocity = new Arrows(root, 1, 0.008, painted("blue"));
    this.push = new Arrows(root, 1, 0.02, painted("red"));
    this.footholds = new Copies(root, legs.length, new three.TorusGeometry(0.04, 0.006, 8, 24), flat("purple"));
    this.com = new three.Mesh(new three.CircleGeometry(0.025, 20), flat("ink"));
    const line = (name) => Object.assign(new three.LineBasicMaterial(), { name });
    this.trail = changing(kMostTrail, (geometry) => new three.Line(geometry, line("purple")));
    this.edge = changing(legs.length, (geometry) => new three.LineLoop(geometry, line("blue")));
    this.area = changing(legs.length, (geometry) => {
      geometry.setIndex(Array.from({ length: Math.max(0, legs.length - 2) }, (_, i) => [0, i + 1, i + 2]).flat());
      return new three.Mesh(geometry, flat("blue", { transparent: true, opacity: 0.22, side: three.DoubleSide, depthWrite: false }));
    });
    root.add(this.grid, this.robot, this.com, this.trail, this.edge, this.area);
    [this.from, this.to, this.vector] = [1, 2, 3].map(() => new three.Vector3());
  }

  /// `colours` of the style sheet by name.
  paint(colours) {
    this.root.traverse(({ material }) => material?.color.set(colours[material.name]));
  }

  fit({ width, height, ratio }) {
    this.renderer.setPixelRatio(Math.min(this.ratio, ratio));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  look({ position, target }) {
    this.camera.position.set(...position);
    this.camera.lookAt(...target);
  }

  /// Draws before the screen shows the next picture, or later where drawing is slow.
  ask() {
    if (this.waiting) {
      return;
    }
    this.waiting = true;
    const draw = () => requestAnimationFrame(() => {
      this.waiting = false;
      const begin = performance.now();
      this.newest && this.arrange(this.newest);
      this.newest = null;
      this.renderer.render(this.root, this.camera);
      if (!this.fast) {
        this.renderer.getContext().finish();
      }
      this.drawn = performance.now();
      this.rest = this.fast ? 0 : Math.max(kSlow_ms, kRest * (this.drawn - begin));
      postMessage({ triangles: this.renderer.info.render.triangles });
    });
    const left = this.rest - (performance.now() - this.drawn);
    left > 0 ? setTimeout(draw, left) : draw();
  }

  /// `things`: of thingsOf() in body.js; `trail`: where the trunk was, three numbers a place.
  arrange({ things, trail }) {
    const { pose, legs, stands } = things;
    const [w, x, y, z] = pose.attitude;
    at(pose.position, this.robot.position);
    this.robot.quaternion.set(x, y, z, w);
    this.robot.updateMatrixWorld();
    this.trunk.material.opacity = pose.from ? 0.6 : 0.25;
    const feet = legs.map((leg, i) => this.showLeg(leg, i, stands[i]));
    this.showForces(this.trueForces, things.trueForces, feet);
    feet.forEach((foot) => foot?.setX(foot.x + kBeside));
    this.showForces(this.feltForces, things.feltForces, feet);
    feet.forEach((foot) => foot?.setX(foot.x - kBeside));
    const top = this.from.copy(this.trunk.position).setZ(this.trunk.position.z + this.shapes.trunk.size[2] / 2 + 0.05)
      .applyMatrix4(this.robot.matrixWorld);
    for (const [arrow, vector] of [[this.command, things.command], [this.velocity, things.velocity]]) {
      vector ? arrow.put(0, top, at(vector, this.vector)) : arrow.hide(0);
    }
    things.push ? this.push.put(0, top, at(things.push, this.vector).multiplyScalar(1 / this.shapes.weight)) : this.push.hide(0);
    legs.forEach((_, i) => {
      const hold = stands[i] ? null : things.footholds?.[i];
      hold ? this.footholds.put(i, at(hold, this.vector), kUp, 1, 1) : this.footholds.hide(i);
    });
    this.showSupport(feet, stands, things.com);
    this.trail.set(trail);
    this.grid.position.set(Math.round(pose.position[0]), Math.round(pose.position[1]), 0);
  }

  /// Returns where the foot touches the ground, in the world; null: not known.
  showLeg(leg, i, stands) {
    const { hinge, foot_radius: radius } = this.shapes.legs[i];
    const points = leg ? [hinge, ...leg].map((point) => at(point)) : [];
    for (let k = 0; k < 3; k += 1) {
      leg ? this.links.put(3 * i + k, points[k], points[k + 1]) : this.links.hide(3 * i + k);
    }
    for (let k = 0; k < 2; k += 1) {
      leg ? this.joints.put(2 * i + k, points[k + 1], kUp, 1, 1) : this.joints.hide(2 * i + k);
    }
    for (const feet of [this.standing, this.lifted]) {
      leg && (feet === this.standing) === stands ? feet.put(i, points[3], kUp, radius, radius) : feet.hide(i);
    }
    if (!leg) {
      return null;
    }
    const bottom = points[3].applyMatrix4(this.robot.matrixWorld);
    return bottom.setZ(bottom.z - radius);
  }

  showForces(arrows, forces, feet) {
    feet.forEach((foot, i) => {
      foot && forces ? arrows.put(i, foot, at(forces[i], this.vector).multiplyScalar(1 / this.shapes.weight)) : arrows.hide(i);
    });
  }

  /// The polygon of the standing feet, ordered around its middle, and the centre of mass above it.
  showSupport(feet, stands, com) {
    const all = feet.filter((foot, i) => foot && stands[i]).map((foot) => [foot.x, foot.y, foot.z + 0.004]);
    const middle = [0, 1].map((axis) => all.reduce((sum, foot) => sum + foot[axis], 0) / Math.max(1, all.length));
    const angle = (foot) => Math.atan2(foot[1] - middle[1], foot[0] - middle[0]);
    all.sort((one, other) => angle(one) - angle(other));
    this.edge.set(all.flat());
    this.area.set(all.flat());
    this.com.visible = com !== null;
    if (com) {
      const ground = all.length ? Math.max(...all.map((foot) => foot[2])) : 0;
      this.com.position.set(com[0], com[1], ground + 0.004);
    }
  }
}

let scene = null;

/// Messages of view.js; one may carry several of these.
onmessage = ({ data: { canvas, shapes, colours, size, eye, things, trail } }) => {
  try {
    scene = canvas ? new Scene(canvas, shapes) : scene;
  } catch (problem) {
    postMessage({ why: problem.message });
  }
  if (scene) {
    colours && scene.paint(colours);
    size && scene.fit(size);
    eye && scene.look(eye);
    scene.newest = things ? { things, trail } : scene.newest;
    scene.ask();
  }
};
