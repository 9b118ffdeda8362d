// Poles of the joint's estimated model in the z-plane, with where they were: crosses, and a trail that fades.
import { clean, colour } from "./charts.js";
import { number, say } from "./text.js";

const kHeight = 260;
const kTrail = 60; // places, over the stretch that is shown

/// period: seconds of a tick. A pole is marked where what it stands for grows e-fold within a second: the position of a
/// load that nothing holds has its pole on the circle, and an estimate of it on either side.
export function drawPoles(canvas, text, frames, joint, period) {
  const { context, width, height } = clean(canvas, kHeight);
  const now = frames.at(-1)?.joints[joint].estimate;
  const radius = height / 2 - 18, x0 = width / 2, y0 = height / 2;
  const scale = radius / 1.1;
  const place = ([re, im]) => [x0 + re * scale, y0 - im * scale];
  context.strokeStyle = colour("rule");
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(x0 - radius - 14, y0);
  context.lineTo(x0 + radius + 14, y0);
  context.moveTo(x0, 4);
  context.lineTo(x0, height - 4);
  context.stroke();
  context.strokeStyle = colour("ink");
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(x0, y0, scale, 0, 2 * Math.PI);
  context.stroke();
  context.fillStyle = colour("faint");
  context.fillText("1", x0 + scale + 4, y0 - 8);
  context.fillText("Re", x0 + radius + 4, y0 + 16);
  context.fillText("Im", x0 + 4, 12);
  if (!now) {
    canvas.setAttribute("aria-label", "Poles: no estimate yet");
    say(text, "No estimate yet.");
    return;
  }
  const step = Math.max(1, Math.floor(frames.length / kTrail));
  context.fillStyle = colour("purple");
  for (let i = 0; i < frames.length; i += step) {
    context.globalAlpha = 0.08 + 0.5 * (i / frames.length);
    for (const pole of frames[i].joints[joint].estimate?.poles ?? []) {
      const [x, y] = place(pole);
      context.fillRect(x - 1.5, y - 1.5, 3, 3);
    }
  }
  context.globalAlpha = 1;
  context.lineWidth = 2.2;
  for (const pole of now.poles) {
    const outside = Math.log(Math.hypot(...pole)) > period;
    const [x, y] = place(pole);
    context.strokeStyle = colour(outside ? "red" : "blue");
    context.beginPath();
    context.moveTo(x - 5, y - 5);
    context.lineTo(x + 5, y + 5);
    context.moveTo(x + 5, y - 5);
    context.lineTo(x - 5, y + 5);
    if (outside) {
      context.moveTo(x + 9, y);
      context.arc(x, y, 9, 0, 2 * Math.PI);
    }
    context.stroke();
  }
  const words = now.poles.map(([re, im]) => `${number(re, 4)}${im === 0 ? "" : `${im < 0 ? " − " : " + "}${number(Math.abs(im), 3)} i`}`);
  const largest = Math.max(...now.poles.map((pole) => Math.hypot(...pole)));
  const sentence = `Poles of the estimated model, before control: ${words.join(", ")}. Largest modulus ${number(largest, 5)}.`;
  canvas.setAttribute("aria-label", sentence);
  say(text, sentence);
}
