// Each leg: a foot on the ground, filled, or in the air, hollow; and the word.
import { make, say } from "./text.js";

const kStance = 1;

function svg(tag, attributes) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, value);
  }
  return element;
}

export class Legs {
  constructor(list, robot) {
    this.robot = robot;
    this.legs = robot.legs.map((name) => {
      const picture = svg("svg", { viewBox: "0 0 80 74", "aria-hidden": "true" });
      const lines = [svg("line", {}), svg("line", {})];
      const foot = svg("circle", { class: "foot", r: 5 });
      picture.append(svg("line", { class: "ground", x1: 6, y1: 70, x2: 74, y2: 70 }), ...lines, foot);
      const phase = make("span", { className: "phase" });
      const element = make("li", { className: "leg" }, make("b", { textContent: name }), picture, phase);
      list.append(element);
      return { element, lines, foot, phase };
    });
  }

  show(frame) {
    this.legs.forEach(({ element, lines, foot, phase }, leg) => {
      const stance = (frame.phases[leg] ?? kStance) === kStance;
      if (phase.dataset.stance === String(stance)) {
        return;
      }
      phase.dataset.stance = String(stance);
      element.classList.toggle("stance", stance);
      const knee = stance ? [30, 36] : [24, 30], end = stance ? [42, 64] : [46, 50];
      const place = (line, [x1, y1], [x2, y2]) => {
        Object.entries({ x1, y1, x2, y2 }).forEach(([name, value]) => line.setAttribute(name, value));
      };
      place(lines[0], [42, 5], knee);
      place(lines[1], knee, end);
      foot.setAttribute("cx", end[0]);
      foot.setAttribute("cy", end[1]);
      say(phase, stance ? "■ stance" : "○ swing");
    });
  }
}
