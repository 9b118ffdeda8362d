// The page's side of the picture of the robot: its canvas, the hand on the camera, and the worker that draws.
import { PerspectiveCamera, Vector3 } from "./three.module.min.js";
import { OrbitControls } from "./OrbitControls.js";
import { colour } from "./charts.js";
import { kAngle_deg } from "./eye.js";

const kLookAt = 0.35;              // m above the ground
const kFrom = [1.1, -1.75, 0.7]; // of the camera, from what it looks at
const kColours = ["ink", "faint", "rule", "blue", "orange", "green", "red", "purple"];

export class View {
  /// failed(why): there will be no picture.
  constructor(stage, shapes, failed) {
    const canvas = document.createElement("canvas");
    if (!canvas.transferControlToOffscreen) {
      throw new Error("this browser cannot draw beside the page (OffscreenCanvas).");
    }
    canvas.setAttribute("aria-hidden", "true");  // what it shows is in words beside it
    stage.append(canvas);
    this.stage = stage;
    this.worker = new Worker("scene.js", { type: "module" });
    this.worker.onmessage = ({ data: { why, triangles } }) => {
      why ? failed(why) : (stage.dataset.triangles = triangles);
    };
    this.worker.onerror = () => failed("its worker does not start.");
    const offscreen = canvas.transferControlToOffscreen();
    this.worker.postMessage({ canvas: offscreen, shapes }, [offscreen]);
    this.camera = new PerspectiveCamera(kAngle_deg);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(...kFrom).add(new Vector3(0, 0, kLookAt));
    this.controls = new OrbitControls(this.camera, canvas);
    Object.assign(this.controls, { enablePan: false, minDistance: 0.6, maxDistance: 15, maxPolarAngle: 1.55 });
    this.controls.target.set(0, 0, kLookAt);
    this.controls.update();
    this.controls.addEventListener("change", () => this.following || this.worker.postMessage({ eye: this.eye() }));
    this.worker.postMessage({ eye: this.eye() });
    this.colour();
    new ResizeObserver(() => this.fit()).observe(stage);
    this.away = new Vector3();
  }

  eye() {
    return { position: this.camera.position.toArray(), target: this.controls.target.toArray() };
  }

  /// Takes the colours of the style sheet.
  colour() {
    this.worker.postMessage({ colours: Object.fromEntries(kColours.map((name) => [name, colour(name)])) });
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.stage;
    if (width > 0 && height > 0) {
      this.worker.postMessage({ size: { width, height, ratio: devicePixelRatio || 1 } });
    }
  }

  /// `things`: of thingsOf() in body.js; `trail`: where the trunk was, three numbers a place.
  show(things, trail) {
    this.follow(things.pose.position);
    this.worker.postMessage({ things, trail, eye: this.eye() });
  }

  /// The camera keeps its place beside the trunk.
  follow([x, y, z]) {
    this.away.copy(this.camera.position).sub(this.controls.target);
    this.controls.target.set(x, y, z > 1 ? z : kLookAt);
    this.camera.position.copy(this.controls.target).add(this.away);
    this.following = true;
    this.controls.update();
    this.following = false;
  }
}
