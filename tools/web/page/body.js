// The robot in three dimensions: where its trunk is said to be, the words about it, and the picture if there can be one.
import { fill, fixed, number, say } from "./text.js";

const kStance = 1;
const kLeastLoad = 1;   // N on a foot that counts as standing, where locomotion does not say which do

/// Vectors of three out of a list of numbers.
export function vectors(numbers) {
  return Array.from({ length: numbers.length / 3 }, (_, i) => numbers.slice(3 * i, 3 * i + 3));
}

/// Turns a vector by a unit quaternion [w, x, y, z].
export function turn([w, x, y, z], [a, b, c]) {
  const s = 2 * (y * c - z * b), t = 2 * (z * a - x * c), u = 2 * (x * b - y * a);
  return [a + w * s + y * u - z * t, b + w * t + z * s - x * u, c + w * u + x * t - y * s];
}

const back = ([w, x, y, z]) => [w, -x, -y, -z];

/// Angle in degrees between two attitudes.
function between(one, other) {
  const cosine = Math.abs(one.reduce((sum, part, i) => sum + part * other[i], 0));
  return 2 * Math.acos(Math.min(1, cosine)) * 180 / Math.PI;
}

/// Where the trunk is drawn: as simulated, else as locomotion estimates it, else level with the lowest foot on the
/// ground. `from` says which.
export function poseOf(body, shapes) {
  for (const from of ["truth", "state"]) {
    if (body[from]) {
      const { position, attitude } = body[from];
      return { from, position, attitude };
    }
  }
  const depths = body.legs.flatMap((leg, i) => leg ? [leg.at(-1)[2] - shapes.legs[i].foot_radius] : []);
  return { from: null, position: [0, 0, depths.length ? -Math.min(...depths) : 0], attitude: [1, 0, 0, 0] };
}

/// Everything that the picture shows of a frame, in the world's axes but for `legs`, which are in the trunk's. What is
/// not known is null.
export function thingsOf(frame, shapes) {
  const { body } = frame, { truth, state } = body;
  const pose = poseOf(body, shapes);
  const forward = turn(pose.attitude, [1, 0, 0]);
  const yaw = Math.atan2(forward[1], forward[0]);
  const ahead = ([x, y]) => [x * Math.cos(yaw) - y * Math.sin(yaw), x * Math.sin(yaw) + y * Math.cos(yaw), 0];
  // Locomotion's axes drift away from the true ones: what it says is seen from its own trunk.
  const seen = (vector) => turn(pose.attitude, turn(back(state.attitude), vector));
  const place = (point) => seen(point.map((part, i) => part - state.position[i])).map((part, i) => part + pose.position[i]);
  const trueForces = truth && vectors(truth.forces);
  const stands = body.legs.map((_, i) => state ? state.stands[i] === 1
    : trueForces ? trueForces[i][2] > kLeastLoad : (frame.phases[i] ?? kStance) === kStance);
  return {
    pose, stands, trueForces,
    legs: body.legs,
    com: body.com.includes(null) ? null : turn(pose.attitude, body.com).map((part, i) => part + pose.position[i]),
    feltForces: state && vectors(state.forces).map(seen),
    footholds: state && vectors(state.footholds).map(place),
    command: state && ahead(state.command),
    velocity: state && seen(state.velocity),
    trueVelocity: truth && truth.velocity,
    push: truth && truth.push,
  };
}

const speed = ([x, y]) => `${fixed(x, 2)} m/s forward, ${fixed(y, 2)} m/s left`;

export class Body {
  constructor(section, robot) {
    this.section = section;
    this.robot = robot;
    this.numbers = section.querySelector("#body-numbers");
    this.words = section.querySelector("#body-text");
    this.stage = section.querySelector("#stage");
    this.picture = null;
    if (robot.body) {
      this.open();
    } else {
      this.hide("No picture: the robot file does not describe the robot as rigid bodies (body.trunk).");
    }
  }

  hide(why) {
    this.section.classList.add("without-picture");
    say(this.words, why);
  }

  fail(why) {
    this.picture = null;
    this.why = `No picture: ${why}`;
    this.hide(this.why);
  }

  async open() {
    try {
      const { View } = await import("./view.js");
      this.picture = new View(this.stage, this.robot.body, (why) => this.fail(why));
      this.act?.();
    } catch (problem) {
      this.fail(problem.message);
    }
  }

  /// Draws again in the colours of the style sheet.
  rebuild() {
    this.picture?.colour();
  }

  /// `past`: frames of the run up to this one, for the trail.
  show(frame, past) {
    this.act = () => this.show(frame, past);  // for a picture that is still being loaded
    const { body: shapes } = this.robot;
    if (!shapes || !frame.body) {
      return;
    }
    const things = thingsOf(frame, shapes);
    this.tell(frame, things);
    const trail = things.pose.from === null ? []
      : past.flatMap((one) => one.body?.[things.pose.from]?.position ?? []);
    this.picture?.show(things, new Float32Array(trail));
  }

  tell({ body: { truth, state } }, { pose, stands, trueForces, feltForces, command, velocity, trueVelocity, push }) {
    const legs = this.robot.legs;
    const forward = turn(pose.attitude, [1, 0, 0]), size = Math.hypot(forward[0], forward[1]) || 1;
    const [c, s] = [forward[0] / size, forward[1] / size];
    const along = ([x, y]) => speed([x * c + y * s, y * c - x * s]);
    const up = (forces) => forces.map((force, i) => `${legs[i]} ${fixed(force[2], 0)}`).join(", ");
    fill(this.numbers, [
      ["motion", state ? state.mode : "–"],
      ["height", pose.from ? `${pose.position[2].toFixed(3)} m` : "–"],
      ["command", command ? `${along(command)}, ${fixed(state.command[2], 2)} rad/s` : "–"],
      ["velocity, estimated", velocity ? along(velocity) : "–"],
      ...(truth ? [["velocity, true", along(trueVelocity)]] : []),
      ["load felt, N", feltForces ? up(feltForces) : "–"],
      ...(truth ? [["load, N", up(trueForces)]] : []),
      ...(truth && state ? [["estimate is off by", `${number(Math.hypot(...state.position.map((part, i) => part - truth.position[i])))} m, ` +
                             `${number(between(truth.attitude, state.attitude), 2)}°`]] : []),
      ...(truth ? [["push", `${Math.hypot(...push).toFixed(0)} N`]] : []),
    ]);
    const standing = legs.filter((_, i) => stands[i]);
    const words = {
      truth: "The trunk is where the simulation has it.",
      state: "The trunk is where locomotion estimates it.",
      null: "No process says where the trunk is: it is drawn level, with the lowest foot on the ground.",
    }[pose.from];
    this.section.dataset.pose = pose.from ?? "unknown";
    say(this.words, this.why ?? `${words} On the ground: ${standing.length ? standing.join(", ") : "no foot"}.`);
  }
}
