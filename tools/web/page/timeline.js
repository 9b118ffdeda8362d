// When which joint had which faults: a row a joint, a bar a stretch. Bars of faults that take the joint's force away are
// full, those it bears are hatched.
import { clean, colour } from "./charts.js";
import { faultNames, say, weight } from "./text.js";

const kRow = 15, kLeft = 62, kBottom = 18;

function hatch(context, stroke) {
  const tile = document.createElement("canvas");
  tile.width = tile.height = 6;
  const pen = tile.getContext("2d");
  pen.strokeStyle = stroke;
  pen.lineWidth = 1.6;
  pen.beginPath();
  pen.moveTo(-1, 7);
  pen.lineTo(7, -1);
  pen.stroke();
  return context.createPattern(tile, "repeat");
}

/// rows: by joint, stretches [from, to, bits]; [from, to]: what is shown; now: the moment that the rest of the page shows.
export function drawTimeline(canvas, text, robot, rows, from, to, now) {
  const { context, width, height } = clean(canvas, rows.length * kRow + kBottom);
  const right = width - 8;
  const x = (time) => kLeft + (right - kLeft) * (time - from) / Math.max(1e-9, to - from);
  const bad = colour("red"), mild = hatch(context, colour("orange"));
  context.strokeStyle = colour("rule");
  context.textBaseline = "middle";
  rows.forEach((row, i) => {
    const y = i * kRow;
    context.fillStyle = colour("faint");
    context.fillText(robot.joints[i].name, 0, y + kRow / 2);
    context.beginPath();
    context.moveTo(kLeft, y + kRow - 0.5);
    context.lineTo(right, y + kRow - 0.5);
    context.stroke();
    for (const [begin, end, bits] of row) {
      if (end >= from && begin <= to) {
        const left = Math.max(kLeft, x(begin));
        const span = Math.max(2.5, Math.min(right, x(end)) - left);
        const full = weight(robot, bits) === "bad";
        context.fillStyle = full ? bad : mild;
        context.fillRect(left, y + 2, span, kRow - 4);
        context.strokeStyle = full ? bad : colour("orange");
        context.strokeRect(left, y + 2, span, kRow - 4);
        context.strokeStyle = colour("rule");
      }
    }
  });
  context.fillStyle = colour("faint");
  const bottom = rows.length * kRow + 10;
  const steps = 6;
  for (let i = 0; i <= steps; i += 1) {
    const time = from + (to - from) * i / steps;
    context.textAlign = i === 0 ? "left" : i === steps ? "right" : "center";
    context.fillText(`${time.toFixed(to - from > 20 ? 0 : 1)} s`, x(time), bottom);
  }
  context.textAlign = "left";
  context.strokeStyle = colour("ink");
  context.beginPath();
  context.moveTo(x(now), 0);
  context.lineTo(x(now), rows.length * kRow);
  context.stroke();
  const words = rows.flatMap((row, i) => {
    const holds = row.find(([begin, end]) => begin <= now && end >= now - 0.06);
    return holds ? [`${robot.joints[i].name}: ${faultNames(robot, holds[2])}`] : [];
  });
  say(text, words.length === 0 ? "No faults now." : `Now: ${words.join("; ")}.`);
}
