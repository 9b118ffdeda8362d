// Frames of a robot that runs: server-sent events, which the browser asks for again by itself when they end.

const kQuiet_ms = 1500; // the server sends a comment at least every 0.2 s, but no page hears those: frames come at 20 Hz

export class Live {
  /// told: frame(frame), gap(frames, events), connection(good), anew(): the server is another one
  constructor(told) {
    this.told = told;
    this.heard = 0;
    this.opened = false;
    setInterval(() => this.judge(), 300);
  }

  open() {
    const source = new EventSource("/api/frames");
    source.onopen = () => {
      this.opened = true;
      this.heard = performance.now();
    };
    source.addEventListener("server", (message) => {
      if (this.server !== undefined && this.server !== message.data) {
        this.told.anew();
      }
      this.server = message.data;
    });
    source.onmessage = (message) => {
      this.heard = performance.now();
      this.told.frame(JSON.parse(message.data));
    };
    source.addEventListener("gap", (message) => {
      const gap = JSON.parse(message.data);
      this.told.gap(gap.frames, gap.events);
    });
    source.onerror = () => {
      this.judge(true);
      if (source.readyState === EventSource.CLOSED) {
        // Refused, by a proxy or for too many pages: the browser does not ask again by itself.
        setTimeout(() => this.open(), 1000);
      }
    };
  }

  judge(broken = false) {
    const quiet = performance.now() - this.heard;
    if (broken || (this.opened && quiet > kQuiet_ms)) {
      this.told.connection(false);
    } else if (this.opened) {
      this.told.connection(true);
    }
  }
}
