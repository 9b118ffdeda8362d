// The page: where frames come from, which one is shown, and what shows it.
import { Body } from "./body.js";
import { Detail } from "./detail.js";
import { Events } from "./events.js";
import { History, stretches } from "./history.js";
import { Joints } from "./joints.js";
import { listenToKeys } from "./keys.js";
import { Legs } from "./legs.js";
import { Live } from "./live.js";
import { Recording } from "./recording.js";
import { Supply } from "./supply.js";
import { fill, say, seconds } from "./text.js";
import { drawTimeline } from "./timeline.js";

const kKept = 60;        // seconds of a live robot
const kSpan = 10;        // seconds of the robot's time in charts, unless they show a whole run
const kQuiet = 1;        // seconds after which a robot that says nothing is said to say nothing
const kCalm_ms = 500;    // between drawings for who asks for little motion
const $ = (id) => document.getElementById(id);

class Page {
  constructor(robot) {
    this.robot = robot;
    this.history = new History(robot, robot.recorded ? Infinity : kKept);
    this.pausedAt = null; // seconds of the monitor's time
    this.recording = null;
    this.passedOver = 0;
    this.events = new Events($("events"));
    this.body = new Body($("body"), robot);
    this.legs = new Legs($("legs"), robot);
    this.detail = new Detail($("detail"), robot);
    this.supply = new Supply($("supply"), robot, () => this.draw());
    this.joints = new Joints($("joints"), robot, () => this.draw());
    say($("robot"), robot.name);
    document.title = `${robot.name} – Farrier monitor`;
    listenToKeys({
      joint: (step) => this.joints.choose(this.joints.selected + step),
      leg: (step) => this.joints.otherLeg(step),
      end: (joint) => this.joints.choose(joint),
      pause: () => this.pause(),
      step: (frames) => this.step(frames),
    }, $("help"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.body.rebuild();
      this.joints.rebuild();
      this.detail.rebuild();
      this.supply.rebuild();
      this.draw();
    });
    addEventListener("resize", () => this.draw());
  }

  watch() {
    new Live({
      frame: (frame) => {
        this.history.push(frame);
        this.events.add(frame.events);
        this.draw();
      },
      gap: (frames, events) => {
        this.passedOver += this.history.frames.length > 0 ? frames : 0;  // before the first none was ours
        this.events.add(events);
      },
      anew: () => {
        this.history.clear();
        this.events.clear();
        this.pausedAt = null;
      },
      connection: (good) => {
        $("connection").className = good ? "good" : "bad";
        say($("connection"), !good ? "not connected" : this.pausedAt !== null ? "paused; the robot goes on" : "live");
        this.unheard = good ? null : "The monitor does not answer; trying again. What is shown is old.";
        this.draw();
      },
    }).open();
  }

  async replay() {
    this.recording = await Recording.open();
    this.recording.fetchWhole(this.robot).then(() => this.draw());
    const { duration_s: duration, events, ending } = this.recording.overview;
    this.events.add(events);
    $("player").hidden = false;
    $("slider").max = duration;
    $("connection").className = ending ? "bad" : "good";
    say($("connection"), ending ? `recording; ${ending}` : "recording");
    $("slider").addEventListener("input", () => this.recording.go(Number($("slider").value)));
    $("speed").addEventListener("change", () => (this.recording.speed = Number($("speed").value)));
    $("span").addEventListener("change", () => this.draw());
    $("play").addEventListener("click", () => this.pause());
    let before = performance.now(), shown = -1;
    setInterval(() => {
      const now = performance.now();
      this.recording.pass((now - before) / 1000);
      before = now;
      const time = this.recording.time;
      const frames = this.recording.around(time);
      if (frames && time !== shown) {
        shown = time;
        this.history.frames = frames;
        this.draw();
      }
      say($("play"), this.recording.playing ? "Pause" : "Play");
    }, 50);
  }

  pause() {
    if (this.recording) {
      const { recording } = this;
      recording.playing = !recording.playing;
      if (recording.playing && (recording.opening || recording.time >= recording.overview.duration_s)) {
        recording.go(0);
      }
    } else {
      this.pausedAt = this.pausedAt === null ? this.history.frames.at(-1)?.t ?? null : null;
    }
    this.draw();
  }

  step(frames) {
    if (this.recording) {
      this.recording.go(this.recording.time + frames / this.recording.overview.frames_per_s);
    } else if (this.pausedAt !== null) {
      const index = this.history.at(this.pausedAt) + frames;
      this.pausedAt = this.history.frames[index]?.t ?? this.pausedAt;
      this.draw();
    }
  }

  /// At most once in what the screen shows of it.
  draw() {
    if (!this.waiting) {
      this.waiting = true;
      const act = () => requestAnimationFrame(() => {
        this.waiting = false;
        this.drawNow();
      });
      matchMedia("(prefers-reduced-motion: reduce)").matches ? setTimeout(act, kCalm_ms) : act();
    }
  }

  /// The frames that charts draw at frame `index`, and the stretch [from, to] of the robot's time that they show, in
  /// seconds, with words for it.
  stretch(index) {
    const { history, robot } = this;
    const frame = history.frames[index];
    const whole = $("span").value === "whole" ? this.recording?.whole : null;
    if (whole && frame.tick !== null) {
      const newest = whole.at(frame.t);
      const frames = whole.run(newest, Infinity);
      if (frames.length > 0 && frames.at(-1).tick <= frame.tick) {
        const [from, to] = whole.ends(newest);
        const thinned = this.recording.every > 1 ? `, one frame in ${this.recording.every}` : "";
        return { frames: [...frames, frame], from, to,
                 words: `${from.toFixed(1)} to ${to.toFixed(1)} s of the robot’s time${thinned}` };
      }
    }
    const to = frame.tick === null ? kSpan : Math.max(kSpan, frame.tick * robot.period_s);
    return { frames: history.run(index, kSpan), from: to - kSpan, to, words: `last ${kSpan} s of the robot’s time` };
  }

  drawNow() {
    const { history, robot } = this;
    const time = this.recording ? Math.max(this.recording.time, history.frames[0]?.t ?? 0) : this.pausedAt ?? Infinity;
    const index = history.at(time);
    const frame = history.frames[index];
    if (!frame) {
      return;
    }
    const stretch = this.stretch(index);
    this.head(frame);
    this.body.show(frame, history.run(index, kSpan));
    this.legs.show(frame);
    say($("forces-span"), stretch.words);
    this.joints.show(frame, stretch);
    this.detail.show(frame, stretch, this.joints.selected);
    this.supply.show(frame, stretch);
    if (this.recording) {
      const { duration_s: duration, faults } = this.recording.overview;
      say($("faults-span"), "of the whole recording");
      drawTimeline($("timeline"), $("faults-text"), robot, faults, 0, duration, frame.t);
      $("slider").value = this.recording.time;
      say($("time"), `${frame.t.toFixed(2)} of ${duration.toFixed(2)} s`);
      for (const row of $("events").children) {
        row.hidden = Number(row.dataset.time) > frame.t;
      }
    } else {
      const past = history.frames.slice(0, index + 1);
      const to = Math.max(frame.t, 20);
      const from = Math.max(0, to - kKept);
      say($("faults-span"), `last ${(to - from).toFixed(0)} s of the monitor’s time`);
      drawTimeline($("timeline"), $("faults-text"), robot,
                   robot.joints.map((_, i) => stretches(past, i)), from, to, frame.t);
    }
    document.body.dataset.time = frame.t;
    document.body.dataset.tick = frame.tick ?? "";
  }

  head(frame) {
    const rates = frame.joints.map((joint) => joint.rate ?? 0).filter((rate) => rate > 0);
    fill($("facts"), [
      ["mode", frame.mode ?? "–"],
      ["tick", frame.tick === null ? "–" : String(frame.tick)],
      ["rate", rates.length ? `${Math.min(...rates).toFixed(0)} Hz` : "–"],
      ["heard", frame.age === null ? "nothing yet" : `${seconds(frame.age)} ago`],
      ["processes", String(frame.processes.length)],
      ["lost", String(frame.lost + frame.processes.reduce((sum, one) => sum + one.lost, 0))],
      ...(this.passedOver ? [["frames this page missed", String(this.passedOver)]] : []),
      ["missed", String(frame.joints.reduce((sum, joint) => sum + joint.missed, 0))],
    ]);
    const words = this.unheard ??
      (frame.age === null ? "The robot’s processes have said nothing yet."
        : frame.age > kQuiet && !this.recording ? `The robot’s processes say nothing; the last was heard at ${(frame.t - frame.age).toFixed(1)} s.`
        : "");
    $("alarm").hidden = words === "";
    say($("alarm"), words);
  }
}

async function open() {
  try {
    const page = new Page(await (await fetch("/api/robot")).json());
    await (page.robot.recorded ? page.replay() : page.watch());
  } catch (problem) {
    // Not there yet, or no longer: the address stays good.
    say($("connection"), "The monitor does not answer; trying again.");
    $("connection").className = "bad";
    setTimeout(() => location.reload(), 1500);
    throw problem;
  }
}

open();
