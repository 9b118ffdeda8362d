// One joint in full: its numbers, gains, estimator, and poles.
import { Chart } from "./charts.js";
import { tracks } from "./history.js";
import { drawPoles } from "./poles.js";
import { fill, make, number, say } from "./text.js";

const kGains = [["position", "blue", undefined], ["velocity", "orange", [6, 4]], ["force", "green", [2, 3]],
                ["integral", "purple", [10, 3, 2, 3]]];

/// What each line of the gains is: a piece of the line itself, and its name.
function keyOfGains() {
  const key = make("p", { id: "gains-key" });
  for (const [name, colour, dash] of kGains) {
    const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    picture.setAttribute("viewBox", "0 0 26 8");
    const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
    line.setAttribute("d", "M0 4H26");
    line.setAttribute("stroke", `var(--${colour})`);
    line.setAttribute("stroke-width", "2");
    line.setAttribute("stroke-dasharray", (dash ?? []).join(" "));
    picture.append(line);
    key.append(make("span", {}, picture, name));
  }
  return key;
}

export class Detail {
  constructor(section, robot) {
    this.robot = robot;
    this.title = section.querySelector("h2");
    this.numbers = section.querySelector("#numbers");
    this.canvas = section.querySelector("#poles");
    this.words = section.querySelector("#poles-text");
    const box = section.querySelector("#charts");
    const chart = (id, height, lines, read, options = {}) => {
      const title = make("h3");
      const place = make("div", { id: `chart-${id}`, className: "plot" });
      box.append(title, place);
      return { title, read, chart: new Chart(place, { lines, height, ...options }) };
    };
    const gain = (slot) => kGains.map((_, i) => (joint) => joint.gains[slot]?.[i + 1]);
    const gainLines = kGains.map(([name, colour, dash]) => ({ name, colour, dash }));
    const one = (name, colour) => [{ name, colour }];
    box.append(keyOfGains());
    this.charts = {
      stance: chart("stance", 92, gainLines, gain(1), { axis: false }),
      swing: chart("swing", 92, gainLines, gain(0), { axis: false }),
      validity: chart("validity", 62, one("validity", "blue"), [(joint) => joint.estimate?.validity], { axis: false, range: [0, 1.05] }),
      excitation: chart("excitation", 62, one("excitation", "green"), [(joint) => joint.estimate?.excitation], { axis: false }),
      error: chart("error", 62, one("prediction error", "orange"), [(joint) => joint.estimate?.error], { axis: false }),
      mass: chart("mass", 82, one("mass", "purple"), [(joint) => joint.estimate?.mass]),
    };
  }

  rebuild() {
    Object.values(this.charts).forEach(({ chart }) => chart.build());
  }

  /// `frames`: what charts draw; `from`, `to`: the stretch of the robot's time that they show.
  show(frame, { frames, from, to }, selected) {
    const joint = frame.joints[selected], known = this.robot.joints[selected];
    const period = this.robot.period_s;
    say(this.title, `Joint ${known.name}`);
    const estimate = joint.estimate, decision = joint.decision;
    fill(this.numbers, [
      ["state", joint.state === null ? "–" : this.robot.states[joint.state] ?? "?"],
      ["phase", joint.state === null ? "–" : this.robot.phases[joint.phase] ?? "?"],
      ["rate", joint.rate ? `${joint.rate.toFixed(0)} Hz` : "–"],
      ["missed", String(joint.missed)],
      ["force error", joint.nrmse === null ? "–" : `${number(100 * joint.nrmse)} %`],
      ["gains", joint.generation ? `no. ${joint.generation}` : "–"],
      ["redesigns", String(joint.redesigns)],
      ["decided last", decision ? decision.verdict : "–"],
    ]);
    const titles = {
      stance: "Gains in stance",
      swing: "Gains in swing",
      validity: `Estimate’s validity ${number(estimate?.validity)}`,
      excitation: `Excitation ${number(estimate?.excitation)}`,
      error: `Prediction error ${number(estimate?.error)} times the noise`,
      mass: `Load ${number(estimate?.mass)} ${known.mass_unit}`,
    };
    for (const [name, { title, read, chart }] of Object.entries(this.charts)) {
      say(title, titles[name]);
      chart.set(tracks(frames, selected, period, read), from, to);
    }
    drawPoles(this.canvas, this.words, frames, selected, period);
  }
}
