// Frames of a recording: in pieces, as the slider needs them, and thinned over the whole run, as charts draw them.
import { History } from "./history.js";

const kPiece = 200;     // frames: ten seconds
const kMostWhole = 800; // frames of the whole recording, beside the last
const kAgain_ms = 1500; // after a failure

async function fetchFrames(from, to, every = 1) {
  const answer = await fetch(`/api/frames?from=${from}&to=${to}&every=${every}`);
  if (!answer.ok) {
    throw new Error(answer.statusText);
  }
  return answer.json();
}

export class Recording {
  constructor(overview) {
    this.overview = overview;
    this.pieces = new Map(); // by number: array of frames, or the promise of one
    this.playing = false;
    this.speed = 1;
    this.time = overview.opens_at_s;
    this.opening = true; // nobody has chosen a time yet
    this.every = Math.ceil(overview.frames / kMostWhole);
    this.whole = null;   // History of every `every`-th frame and the last; null until they are fetched
  }

  static async open() {
    return new Recording(await (await fetch("/api/recording")).json());
  }

  frameAt(time) {
    const index = Math.round(time * this.overview.frames_per_s) - 1;
    return Math.max(0, Math.min(this.overview.frames - 1, index));
  }

  piece(number) {
    const first = number * kPiece;
    if (first < 0 || first >= this.overview.frames) {
      return [];
    }
    if (!this.pieces.has(number)) {
      const promise = fetchFrames(first, first + kPiece)
        .then((frames) => this.pieces.set(number, frames))
        .catch(() => this.pieces.delete(number));
      this.pieces.set(number, promise);
      if (this.pieces.size > 30) {
        this.pieces.delete(this.pieces.keys().next().value);
      }
    }
    return this.pieces.get(number);
  }

  /// Fetches the frames of the whole recording; asks again after a failure.
  async fetchWhole(robot) {
    const { frames: count } = this.overview;
    const step = kPiece * this.every;
    const ranges = Array.from({ length: Math.ceil(count / step) }, (_, i) => [i * step, (i + 1) * step]);
    ranges.push([count - 1, count]);
    while (!this.whole) {
      try {
        const pieces = await Promise.all(ranges.map(([from, to]) => fetchFrames(from, to, this.every)));
        this.whole = new History(robot, Infinity);
        this.whole.frames = pieces.flat();
      } catch {
        await new Promise((resolve) => setTimeout(resolve, kAgain_ms));
      }
    }
  }

  /// The frames of the piece of a time and of the one before; null while they are fetched.
  around(time) {
    const number = Math.floor(this.frameAt(time) / kPiece);
    const now = this.piece(number), before = this.piece(number - 1);
    this.piece(number + 1);
    return Array.isArray(now) && Array.isArray(before) ? [...before, ...now] : null;
  }

  go(time) {
    this.opening = false;
    this.time = Math.max(0, Math.min(this.overview.duration_s, time));
  }

  /// `elapsed` seconds of the page have passed.
  pass(elapsed) {
    if (this.playing) {
      this.go(this.time + elapsed * this.speed);
      this.playing = this.time < this.overview.duration_s;
    }
  }
}
