// What the robot's processes and the monitor itself had to say, newest first.
import { make } from "./text.js";

const kMost = 300;
const kWords = ["● info", "▲ warning", "✖ error"];

export class Events {
  constructor(list) {
    this.list = list;
    this.seen = new Set();
  }

  clear() {
    this.list.replaceChildren();
    this.seen.clear();
  }

  add(events) {
    for (const event of events) {
      if (!this.seen.has(event.n)) {
        this.seen.add(event.n);
        this.list.prepend(this.row(event));
      }
    }
    while (this.list.children.length > kMost) {
      this.list.lastElementChild.remove();
    }
  }

  row(event) {
    const row = make("li", { className: `severity-${event.severity}` },
                     make("span", { textContent: `${event.t.toFixed(2)} s` }),
                     make("b", { textContent: kWords[event.severity] ?? "?" }),
                     make("span", { textContent: event.who }), make("span", { textContent: event.joint }),
                     make("span", { textContent: event.text }));
    row.dataset.time = event.t;
    return row;
  }
}
