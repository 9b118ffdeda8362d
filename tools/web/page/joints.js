// The small multiples: of every joint the force that is wanted and the one that is there, and what ails it.
import { Chart } from "./charts.js";
import { forces } from "./history.js";
import { faultNames, make, number, say, weight } from "./text.js";

export class Joints {
  /// chosen(number): the user has picked a joint.
  constructor(box, robot, chosen) {
    this.robot = robot;
    this.chosen = chosen;
    this.selected = 0;
    this.joints = robot.joints.map((joint, i) => {
      const state = make("span", { className: "state" });
      const place = make("div", { className: "plot" });
      const element = make("div", { className: "joint", id: `joint-${joint.name}`, onclick: () => this.choose(i) },
                           make("p", {}, make("b", { textContent: joint.name }), make("small", { textContent: joint.unit }), state),
                           place);
      element.setAttribute("role", "option");
      box.append(element);
      return { element, state, place };
    });
    for (const joint of this.joints) {
      joint.chart = new Chart(joint.place, {
        lines: [{ name: "measured", colour: "blue", width: 1.8 },
                { name: "reference", colour: "orange", width: 1.4, dash: [6, 4] }],
        height: 92 });
    }
    this.choose(0, false);
  }

  choose(joint, focus = true) {
    this.selected = Math.max(0, Math.min(this.joints.length - 1, joint));
    this.joints.forEach(({ element }, i) => {
      element.setAttribute("aria-selected", String(i === this.selected));
      element.tabIndex = i === this.selected ? 0 : -1;
    });
    if (focus) {
      this.joints[this.selected].element.focus({ preventScroll: false });
    }
    this.chosen(this.selected);
  }

  /// Same place in another leg.
  otherLeg(step) {
    const { joints } = this.robot;
    const leg = joints[this.selected].leg;
    const place = joints.slice(0, this.selected).filter((joint) => joint.leg === leg).length;
    const others = joints.map((joint, i) => ({ ...joint, i })).filter((joint) => joint.leg === leg + step);
    if (others.length > 0) {
      this.choose(others[Math.min(place, others.length - 1)].i);
    }
  }

  rebuild() {
    this.joints.forEach(({ chart }) => chart.build());
  }

  /// `frames`: what charts draw; `from`, `to`: the stretch of the robot's time that they show.
  show(frame, { frames, from, to }) {
    const period = this.robot.period_s;
    this.joints.forEach(({ element, state, chart }, i) => {
      const [time, reference, measured] = forces(frames, i, period);
      chart.set([time, measured, reference], from, to);
      const joint = frame.joints[i];
      const heard = joint.state !== null;
      const silent = heard && (joint.age === null || joint.age > this.robot.silent_s);
      const ill = silent ? "bad" : weight(this.robot, joint.faults);
      element.classList.toggle("bad", ill === "bad");
      element.classList.toggle("warning", ill === "warning");
      const words = !heard ? "not heard yet"
        : silent ? "▲ silent"
        : joint.faults ? `▲ ${faultNames(this.robot, joint.faults)}`
        : `error ${joint.nrmse === null ? "–" : `${number(100 * joint.nrmse, 2)} %`}`;
      say(state, words);
      state.title = words;
    });
  }
}
