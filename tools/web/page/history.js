// Frames in the order in which they came, and what they say of a stretch of time. Charts run on the robot's own time,
// its ticks; faults and events on the monitor's, which goes on when the robot does not.

export class History {
  constructor(robot, longest) {
    this.robot = robot;
    this.longest = longest; // seconds of the monitor's time that are kept; Infinity: all
    this.frames = [];
  }

  clear() {
    this.frames = [];
  }

  push(frame) {
    this.frames.push(frame);
    let old = 0;
    while (frame.t - this.frames[old].t > this.longest) {
      old += 1;
    }
    this.frames.splice(0, old);
  }

  /// Index of the last frame at or before a time; -1: none.
  at(time) {
    let low = 0, high = this.frames.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.frames[middle].t <= time + 1e-6) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low - 1;
  }

  seconds(tick) {
    return tick * this.robot.period_s;
  }

  /// The stretch [from, to] of the robot's time, in seconds, of the whole run of frame `index`; `from` is a whole tenth.
  ends(index) {
    let first = index, last = index;
    while (first > 0 && this.frames[first - 1].tick !== null &&
           this.frames[first - 1].tick <= this.frames[first].tick) {
      first -= 1;
    }
    while (last + 1 < this.frames.length && this.frames[last + 1].tick >= this.frames[last].tick) {
      last += 1;
    }
    const begins = this.frames[first].joints.map((joint) => joint.s[0]?.[0] ?? this.frames[first].tick);
    return [Math.floor(10 * this.seconds(Math.min(...begins))) / 10, this.seconds(this.frames[last].tick)];
  }

  /// Frames of the run of frame `index`, up to it and not older than `span` seconds of the robot's time.
  run(index, span) {
    const end = this.frames[index];
    if (!end || end.tick === null) {
      return [];
    }
    let first = index;
    for (; first > 0; first -= 1) {
      const before = this.frames[first - 1];
      if (before.tick === null || before.tick > this.frames[first].tick ||
          this.seconds(end.tick - before.tick) > span) {
        break;
      }
    }
    return this.frames.slice(first, index + 1);
  }
}

/// Time, reference and measured force of one joint, as a chart takes them.
export function forces(frames, joint, period) {
  const time = [], reference = [], measured = [];
  let last = -1;
  for (const frame of frames) {
    for (const [tick, wanted, is] of frame.joints[joint].s) {
      if (tick > last) {
        time.push(tick * period);
        reference.push(wanted);
        measured.push(is);
        last = tick;
      }
    }
  }
  return [time, reference, measured];
}

/// Time and, for each of `read`, read(joint's frame) at it.
export function tracks(frames, joint, period, read) {
  const time = [];
  const values = read.map(() => []);
  let last = -1;
  for (const frame of frames) {
    if (frame.tick > last) {
      time.push(frame.tick * period);
      read.forEach((one, i) => values[i].push(one(frame.joints[joint]) ?? null));
      last = frame.tick;
    }
  }
  return [time, ...values];
}

/// Stretches [from, to, bits] of a joint's faults in frames.
export function stretches(frames, joint) {
  const found = [];
  let open = null;
  for (const frame of frames) {
    const bits = frame.joints[joint].faults;
    if (open && open[2] !== bits) {
      open[1] = frame.t;
      open = null;
    }
    if (!open && bits !== 0) {
      open = [frame.t, frame.t, bits];
      found.push(open);
    }
    if (open) {
      open[1] = frame.t;
    }
  }
  return found;
}
