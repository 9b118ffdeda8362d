// uPlot as this page uses it: no legend, colours of the style sheet, nothing that moves by itself.
import uPlot from "./uPlot.esm.js";

export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

function brief(value) {
  const size = Math.abs(value);
  if (size > 0 && size < 1e-3) {
    return value.toExponential(0); // or it would be cut off
  }
  return size >= 1000 ? `${Number((value / 1000).toPrecision(3))}k` : String(Number(value.toPrecision(3)));
}

/// Lines: [{name, colour, dash}] over time, in `place`. What its data is, set() says.
export class Chart {
  constructor(place, { lines, height, axis = true, range }) {
    this.place = place;
    this.options = { lines, height, axis, range };
    this.data = [[], ...lines.map(() => [])];
    this.build();
    new ResizeObserver(() => this.fit()).observe(place);
  }

  build() {
    this.plot?.destroy();
    const { lines, height, axis, range } = this.options;
    const grid = { stroke: colour("rule"), width: 1 };
    const text = { stroke: colour("faint"), font: "11px system-ui", grid, ticks: { show: false } };
    this.plot = new uPlot({
      width: Math.max(80, this.place.clientWidth),
      height,
      pxAlign: 0,
      padding: [8, 16, 4, 0],
      cursor: { show: false },
      legend: { show: false },
      scales: { x: { time: false }, y: range ? { range } : {} },
      axes: [{ ...text, show: axis, size: 20, gap: 6, space: 60, values: (_, at) => at.map((s) => `${Number(s.toFixed(2))} s`) },
             { ...text, size: 46, gap: 3, space: 22, values: (_, at) => at.map(brief) }],
      series: [{}, ...lines.map((line) => ({ label: line.name, stroke: colour(line.colour), width: line.width ?? 1.5,
                                             dash: line.dash, points: { show: false } }))],
    }, this.data, this.place);
    this.plot.root.setAttribute("aria-hidden", "true"); // its numbers are beside it
  }

  fit() {
    const width = Math.max(80, this.place.clientWidth);
    if (width !== this.plot.width) {
      this.plot.setSize({ width, height: this.options.height });
    }
  }

  /// `from`, `to`: the stretch of time that is shown.
  set(data, from, to) {
    this.data = data;
    this.plot.batch(() => {
      this.plot.setData(data, false);
      this.plot.setScale("x", { min: from, max: to });
    });
  }
}

/// A canvas in the pixels of the screen, cleared; its context works in those of the style sheet.
export function clean(canvas, height) {
  const ratio = devicePixelRatio || 1;
  const width = canvas.clientWidth;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.height = `${height}px`;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "12px system-ui, sans-serif";
  return { context, width, height };
}
