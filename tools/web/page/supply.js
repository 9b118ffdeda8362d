// The hydraulic supply: its pressure and flows, the valve currents and chamber pressures of one leg, and where the work
// of the pump has gone.
import { Chart } from "./charts.js";
import { fill, fixed, make, say } from "./text.js";

const kRest_ms = 200;  // between drawings of the charts: twelve charts of forces are drawn with every frame already
const kColours = ["blue", "orange", "green", "purple"];
const kDashes = [undefined, [7, 3], [2, 2], [10, 3, 2, 3]];
const kLeastSpan_bar = 10;

/// Time and columns of rows [tick, ...] that read(frame) gives; `pick` makes the columns' values of a row.
export function columns(frames, period, read, pick, count) {
  const time = [], values = Array.from({ length: count }, () => []);
  let last = -1;
  for (const frame of frames) {
    for (const row of read(frame) ?? []) {
      if (row[0] > last) {
        time.push(row[0] * period);
        pick(row).forEach((value, i) => values[i].push(value));
        last = row[0];
      }
    }
  }
  return [time, ...values];
}

/// The account between the first and the last of the frames, by term; null: not known.
export function account(frames) {
  const known = frames.filter((frame) => frame.supply?.energy);
  if (known.length < 2) {
    return null;
  }
  const first = known[0].supply.energy;
  return known.at(-1).supply.energy.map((energy, i) => energy - first[i]);
}

/// Whole tens of bar around the pressures: a supply that holds its pressure is a straight line.
function spanOfPressure(_, least, largest) {
  return least === null ? [0, kLeastSpan_bar]
    : [kLeastSpan_bar * Math.floor((least - 1) / kLeastSpan_bar), kLeastSpan_bar * Math.ceil((largest + 1) / kLeastSpan_bar)];
}

/// A piece of a line and its name, for the key of a chart.
function keyOf({ name, colour, dash }) {
  const key = make("span", { className: "key line", textContent: name });
  key.style.color = `var(--${colour})`;
  key.classList.toggle("dashed", dash !== undefined);
  return key;
}

export class Supply {
  /// chosen(): the user has picked a leg.
  constructor(section, robot, chosen) {
    this.robot = robot;
    this.section = section;
    section.hidden = !robot.supply;
    if (!robot.supply) {
      return;
    }
    this.numbers = section.querySelector("#supply-numbers");
    this.words = section.querySelector("#supply-text");
    this.picker = section.querySelector("#supply-leg");
    robot.legs.forEach((name, leg) => this.picker.append(make("option", { value: leg, textContent: name })));
    this.picker.addEventListener("change", () => {
      this.label();
      chosen();
    });
    const lines = (names) => names.map((name, i) => ({ name, colour: kColours[i], dash: kDashes[i] }));
    const chart = (box, id, height, of, range) => {
      const title = make("span");
      const place = make("div", { id: `chart-${id}`, className: "plot" });
      box.append(make("div", {}, make("h3", {}, title, ...(of.length > 1 ? of.map(keyOf) : [])), place));
      return { title, chart: new Chart(place, { lines: of, height, range }) };
    };
    const shared = section.querySelector("#supply-charts"), leg = section.querySelector("#leg-charts");
    this.pressure = chart(shared, "pressure", 96, lines(["pressure"]), spanOfPressure);
    this.flow = chart(shared, "flow", 96, lines(["pump", "actuators"]));
    const most = Math.max(...robot.legs.map((_, i) => this.jointsOf(i).length));
    this.chambers = Array.from({ length: most }, (_, i) => chart(leg, `chambers-${i}`, 96, lines(["A", "B"])));
    this.currents = chart(leg, "currents", 96, lines(this.jointsOf(0).map((joint) => robot.joints[joint].name.replace(/^.*_/, ""))));
    this.bars = robot.supply.terms.slice(1).map((name) => {
      const bar = make("span", { className: "bar" }), value = make("span", { className: "value" });
      section.querySelector("#energy").append(make("li", {}, make("span", { textContent: name }),
                                                   make("span", { className: "track" }, bar), value));
      return { bar, value };
    });
    this.energyTitle = section.querySelector("#energy-title");
    say(this.pressure.title, "Pressure, bar");
    say(this.flow.title, "Flow, l/min");
    say(this.currents.title, "Currents, mA");
    this.label();
    new IntersectionObserver((entries) => {
      this.seen = entries.at(-1).isIntersecting;
      this.ask();
    }).observe(section);
  }

  /// Numbers of a leg's joints.
  jointsOf(leg) {
    return this.robot.joints.flatMap((joint, i) => (joint.leg === leg ? [i] : []));
  }

  label() {
    const joints = this.jointsOf(Number(this.picker.value));
    this.chambers.forEach(({ title }, i) => say(title, `${this.robot.joints[joints[i]]?.name ?? "–"}, chambers, bar`));
  }

  rebuild() {
    if (this.robot.supply) {
      [this.pressure, this.flow, this.currents, ...this.chambers].forEach(({ chart }) => chart.build());
    }
  }

  /// `frames`: what charts draw; `from`, `to`: the stretch of the robot's time that they show, `words` say which.
  show(frame, { frames, from, to, words }) {
    const { robot } = this;
    if (!robot.supply) {
      return;
    }
    const now = frame.supply;
    const low = now && robot.supply.low !== null && now.pressure < robot.supply.low;
    this.section.classList.toggle("low", Boolean(low));
    fill(this.numbers, [
      ["pressure", now ? `${now.pressure.toFixed(1)} bar` : "–"],
      ["pump", now ? `${now.pump.toFixed(1)} l/min` : "–"],
      ["actuators", now ? `${now.drawn.toFixed(1)} l/min` : "–"],
      ["relief valve", now ? `${now.relief.toFixed(1)} l/min` : "–"],
      ["leakage", now ? `${now.leakage.toFixed(1)} l/min` : "–"],
      ["power", now ? `${(now.power / 1000).toFixed(2)} kW` : "–"],
    ]);
    say(this.words, !now ? "No process says the pressure of the supply."
      : low ? `▲ The supply is low: below ${robot.supply.low} bar.` : "");
    this.act = () => this.draw(frames, from, to, words);
    this.ask();
  }

  /// Draws the charts soon, if the window shows them.
  ask() {
    if (!this.seen || !this.act) {
      return;
    }
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      this.drawn = performance.now();
      this.act();
    }, Math.max(0, (this.drawn ?? 0) + kRest_ms - performance.now()));
  }

  draw(frames, from, to, words) {
    const period = this.robot.period_s;
    const states = (one) => one.supply?.s;
    this.pressure.chart.set(columns(frames, period, states, (row) => [row[1]], 1), from, to);
    this.flow.chart.set(columns(frames, period, states, (row) => [row[2], row[3]], 2), from, to);
    const joints = this.jointsOf(Number(this.picker.value));
    this.chambers.forEach(({ chart }, i) => {
      chart.set(columns(frames, period, (one) => one.supply?.chambers,
                        ([, a, b]) => [a[joints[i]] ?? null, b[joints[i]] ?? null], 2), from, to);
    });
    this.showCurrents(frames, joints, from, to);
    this.showEnergy(frames, words);
  }

  /// Summaries of a leg's joints are of the same ticks.
  showCurrents(frames, joints, from, to) {
    const each = joints.map((joint) => columns(frames, this.robot.period_s, (one) => one.joints[joint].s,
                                               (row) => [1000 * row[3]], 1));
    const [time] = each[0];
    this.currents.chart.set([time, ...each.map(([, values]) => time.map((_, i) => values[i] ?? null))], from, to);
  }

  showEnergy(frames, words) {
    const all = account(frames);
    say(this.energyTitle, all ? `Work of the pump ${(all[0] / 1000).toFixed(1)} kJ, ${words}` : "Work of the pump: not known");
    const [pump, ...terms] = all ?? [];
    const most = Math.max(pump ?? 0, ...terms.map(Math.abs), 1);
    this.bars.forEach(({ bar, value }, i) => {
      const energy = terms[i] ?? 0;
      bar.style.width = `${(100 * Math.abs(energy) / most).toFixed(1)}%`;
      bar.classList.toggle("given", energy < 0);
      say(value, !all ? "–" : `${fixed(energy, 0)} J${pump > 0 ? `, ${fixed(100 * energy / pump, 1)} %` : ""}`);
    });
  }
}
