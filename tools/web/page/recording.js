// Frames of a recording, in pieces, as the slider needs them.

const kPiece = 200; // frames: ten seconds

export class Recording {
  constructor(overview) {
    this.overview = overview;
    this.pieces = new Map(); // by number: array of frames, or the promise of one
    this.playing = false;
    this.speed = 1;
    this.time = 0;
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
      const promise = fetch(`/api/frames?from=${first}&to=${first + kPiece}`)
        .then((answer) => (answer.ok ? answer.json() : Promise.reject(new Error(answer.statusText))))
        .then((frames) => this.pieces.set(number, frames))
        .catch(() => this.pieces.delete(number));
      this.pieces.set(number, promise);
      if (this.pieces.size > 30) {
        this.pieces.delete(this.pieces.keys().next().value);
      }
    }
    return this.pieces.get(number);
  }

  /// The frames of the piece of a time and of the one before; null while they are fetched.
  around(time) {
    const number = Math.floor(this.frameAt(time) / kPiece);
    const now = this.piece(number), before = this.piece(number - 1);
    this.piece(number + 1);
    return Array.isArray(now) && Array.isArray(before) ? [...before, ...now] : null;
  }

  go(time) {
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
