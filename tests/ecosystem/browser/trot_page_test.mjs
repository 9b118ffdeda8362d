// The page beside a trot in real time: node trot_page_test.mjs <farrier> <folder for pictures>
// Draws its joints, shows a process that stands still, says when the robot has gone, and shows the next one.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { drawnPixels, findBrowser, launch, openPage, until } from "./page_under_test.mjs";

const [, , farrier, pictures] = process.argv;
const kSkipped = 77;
const kSilence = 500;  // ms after which a process says nothing
const executable = findBrowser();
if (!executable) {
  console.log("skipped: no Chromium here; apt-get install chromium");
  process.exit(kSkipped);
}

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function start(argumentsOfIt, words) {
  const child = spawn(farrier, argumentsOfIt, { stdio: ["ignore", "pipe", "pipe"] });
  child.said = new Promise((resolve, reject) => {
    for (const stream of [child.stdout, child.stderr]) {
      createInterface({ input: stream }).on("line", (line) => line.includes(words) && resolve(line));
    }
    child.once("exit", (status) => reject(new Error(`farrier ${argumentsOfIt[0]} ended with ${status}`)));
  });
  child.ended = new Promise((resolve) => child.once("exit", resolve));
  return child;
}

/// Process of a trot by a word of its command line: [its number, its arguments].
function processOf(trot, word) {
  for (const number of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      const parent = readFileSync(`/proc/${number}/stat`, "latin1").split(") ").at(-1).split(" ")[1];
      const words = readFileSync(`/proc/${number}/cmdline`, "latin1").split("\0");
      if (Number(parent) === trot.pid && words.includes(word)) {
        return [Number(number), words];
      }
    } catch {
      // has ended meanwhile
    }
  }
  throw new Error(`the trot has no process ${word}`);
}

const startTrot = async () => {
  const trot = start(["trot", "--clock", "realtime", "--nodes", "per-leg", "--duration", "120", "--out", join(pictures, "trot")],
                     "trot: tick 0 of");
  await trot.said;
  const [, words] = processOf(trot, "supervisor");
  return [trot, words[words.indexOf("--domain") + 1]];
};
const freePort = () => new Promise((resolve) => {
  const probe = createServer().listen(0, "127.0.0.1", () => {
    const { port } = probe.address();
    probe.close(() => resolve(port));
  });
});
const drawsTwelve = async (page) => {
  await until(page, () => Number(document.body.dataset.tick) > 1500, 20000);
  const pixels = await drawnPixels(page);
  assert.equal(pixels.length, 12);
  pixels.forEach(([measured], joint) => assert.ok(measured > 30, `joint ${joint}: ${measured} pixels of force`));
};

const browser = await launch(executable);
let [trot, domain] = await startTrot();
const port = await freePort();
const monitor = start(["monitor", "--web", String(port), "--domain", domain], "page at");
let status = 1;
try {
  await monitor.said;
  const { page, complaints } = await openPage(browser, `http://127.0.0.1:${port}/`);
  await drawsTwelve(page);
  await page.screenshot({ path: join(pictures, "trot_light.png"), fullPage: true });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await sleep(200);
  await page.screenshot({ path: join(pictures, "trot_dark.png"), fullPage: true });

  // A computer that others use stands still now and then: the best of three legs counts.
  let took = Infinity;
  for (const leg of ["lf", "rf", "lh"]) {
    const [node] = processOf(trot, `joint_node_${leg}`);
    const begin = performance.now();
    process.kill(node, "SIGSTOP");
    await until(page, (of) => document.querySelector(`#joint-${of}_kfe.bad`), 5000, leg);
    took = Math.min(took, performance.now() - begin);
    await page.screenshot({ path: join(pictures, "trot_stopped.png"), fullPage: true });
    process.kill(node, "SIGCONT");
    if (took < kSilence + 1000) {
      break;
    }
  }
  assert.ok(took < kSilence + 1000, `a process that stands still is shown after ${took.toFixed(0)} ms`);
  console.log(`pass: shows a process that stands still (${took.toFixed(0)} ms)`);

  trot.kill("SIGINT");
  await trot.ended;
  await until(page, () => /say nothing/.test(document.querySelector("#alarm:not([hidden])")?.textContent), 10000);
  console.log("pass: says when the robot has gone");
  const [next, where] = await startTrot();
  trot = next;
  assert.equal(where, domain, "the next trot has taken another domain: nothing can be said");
  await until(page, () => document.querySelector("#alarm").hidden && Number(document.body.dataset.tick) < 20000, 20000);
  await drawsTwelve(page);
  console.log("pass: shows the next run");
  assert.deepEqual(complaints, []);
  status = 0;
} catch (problem) {
  console.log(`FAIL: ${problem.stack}`);
} finally {
  await browser.close();
  monitor.kill("SIGINT");
  trot.kill("SIGINT");
  await Promise.all([monitor.ended, trot.ended]);
}
console.log(`pictures: ${pictures}\n${status === 0 ? 1 : 0} passed, ${status} failed`);
process.exit(status);
