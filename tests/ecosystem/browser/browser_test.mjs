// The page in a real browser: node browser_test.mjs <page_server> <page> <robot file> <folder for pictures>
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";

const [, , program, pageFolder, robot, pictures] = process.argv;
const kSkipped = 77;
const kMostScript_ms = 10;

const { Server, drawnPixels, findBrowser, launch, openPage, shadesOf, until } = await import("./page_under_test.mjs");
const executable = findBrowser();
if (!executable) {
  console.log("skipped: no Chromium here; apt-get install chromium");
  process.exit(kSkipped);
}

const browser = await launch(executable);
const server = new Server(program, pageFolder, robot);
let passed = 0, failed = 0;

async function check(sentence, act) {
  try {
    const more = await act();
    passed += 1;
    console.log(`pass: ${sentence}${more ? ` (${more})` : ""}`);
  } catch (problem) {
    failed += 1;
    console.log(`FAIL: ${sentence}\n  ${problem.stack}`);
  }
}

const shoot = (page, name) => page.screenshot({ path: join(pictures, `${name}.png`), fullPage: true });
const text = (page, selector) => page.$eval(selector, (element) => element.textContent);
const drawsTwelve = async (page) => {
  await until(page, () => document.body.dataset.tick > 2000, 10000);
  const pixels = await drawnPixels(page);
  assert.equal(pixels.length, 12);
  pixels.forEach(([measured, reference], joint) => {
    assert.ok(measured > 30, `joint ${joint}: ${measured} pixels of force`);
    assert.ok(reference > 10, `joint ${joint}: ${reference} pixels of reference`);
  });
  return `least ${Math.min(...pixels.map((counts) => counts[0]))} pixels of force`;
};
const staysHere = (account) => {
  const hosts = new Set(account.requests.filter((url) => !url.startsWith("data:")).map((url) => new URL(url).hostname));
  assert.deepEqual([...hosts], ["127.0.0.1"]);
};

// A robot.
let live = await openPage(browser, await server.start());
const { page } = live;
await check("draws twelve joints", () => drawsTwelve(page));
await check("says what the robot is and does", async () => {
  assert.match(await text(page, "#robot"), /hyq/);
  assert.match(await text(page, "#facts"), /armed/);
  assert.equal(await text(page, "#connection"), "live");
});
await shoot(page, "live_light");
await check("shows a fault within a second", async () => {
  const begin = performance.now();
  server.say("faults lf_kfe 512");
  await until(page, () => document.querySelector("#joint-lf_kfe.bad")?.textContent.includes("force lost") &&
                          document.querySelector("#faults-text").textContent.includes("lf_kfe: force lost") &&
                          [...document.querySelectorAll("#events li")].some((event) => event.textContent.includes("force lost")), 5000);
  const took = performance.now() - begin;
  assert.ok(took < 1000, `${took} ms`);
  return `${took.toFixed(0)} ms`;
});
await check("is used by keys alone", async () => {
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.$eval(".joint[aria-selected=true]", (joint) => joint.id), "joint-rf_hfe");
  await until(page, () => document.querySelector("#detail-title").textContent === "Joint rf_hfe", 2000);
  await page.keyboard.press("Space");
  await new Promise((resolve) => setTimeout(resolve, 200));
  const paused = await page.evaluate(() => document.body.dataset.time);
  await new Promise((resolve) => setTimeout(resolve, 400));
  assert.equal(await page.evaluate(() => document.body.dataset.time), paused);
  await page.keyboard.press("Space");
  await until(page, (time) => Number(document.body.dataset.time) > Number(time) + 0.3, 2000, paused);
  await page.keyboard.press("?");
  assert.ok(await page.$eval("#help", (dialog) => dialog.open));
  await shoot(page, "help");
  await page.keyboard.press("Escape");
  assert.ok(!(await page.$eval("#help", (dialog) => dialog.open)));
});
await check("draws the robot in three dimensions", async () => {
  await until(page, () => Number(document.querySelector("#stage").dataset.triangles) > 1000, 10000);
  assert.equal(await page.$eval("#body", (section) => section.dataset.pose), "truth");
  assert.match(await text(page, "#body-numbers"), /motiontrot.*0\.30 m\/s forward.*0\.02 m, 0°/);
  const shades = await shadesOf(browser, await page.$("#stage"));
  assert.ok(shades > 30, `${shades} colours`);
  return `${await page.$eval("#stage", (stage) => stage.dataset.triangles)} triangles, ${shades} colours`;
});
await check("shows the supply of the run, and a leg that is chosen", async () => {
  await page.$eval("#supply", (section) => section.scrollIntoView());
  await until(page, () => /^open valves\d+ J/m.test([...document.querySelectorAll("#energy li")].map((item) => item.textContent).join("\n")), 5000);
  await until(page, () => /pump12\.0 l\/min/.test(document.querySelector("#supply-numbers").textContent), 5000);
  assert.match(await text(page, "#supply-numbers"), /pressure1[45]\d\.\d bar.*actuators\d+\.\d l\/min.*relief valve3\.0 l\/min/);
  const energy = await page.$$eval("#energy li", (items) => items.map((item) => item.textContent));
  assert.equal(energy.length, 9);
  assert.ok(energy.some((item) => /^open valves\d+ J, 50\.0 %$/.test(item)), energy.join("; "));
  assert.ok(energy.some((item) => /^gained by the accumulator-\d+ J, -2\.0 %$/.test(item)), energy.join("; "));
  await page.select("#supply-leg", "2");
  assert.match(await text(page, "#leg-charts"), /lh_haa, chambers, bar.*lh_kfe, chambers, bar/);
  const drawn = await drawnPixels(page, "#supply canvas");
  assert.equal(drawn.length, 6);
  drawn.forEach(([blue], chart) => assert.ok(blue > 30, `chart ${chart}: ${blue} pixels`));
});
await check("draws a robot on a bench by its joints alone", async () => {
  server.say("bench");
  await until(page, () => document.querySelector("#body").dataset.pose === "unknown", 5000);
  assert.match(await text(page, "#body-text"), /No process says where the trunk is/);
  await until(page, () => /No process says the pressure/.test(document.querySelector("#supply-text").textContent), 5000);
  await shoot(page, "live_bench");
  server.say("ground");
  await until(page, () => document.querySelector("#body").dataset.pose === "truth", 5000);
});
await check("draws at twenty frames a second without falling behind, with at most ten milliseconds of script a frame", async () => {
  // Of the page's thread, in time of the processor: others who use this computer do not count.
  const session = await page.createCDPSession();
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  const script = async () => (await session.send("Performance.getMetrics")).metrics
    .find(({ name }) => name === "ScriptDuration").value;
  const before = await script();
  const counted = await page.evaluate(() => new Promise((resolve) => {
    const seen = new Set(), begin = performance.now();
    let longest = 0, before = begin;
    const look = (now) => {
      longest = Math.max(longest, now - before);
      before = now;
      seen.add(document.body.dataset.time);
      if (now - begin < 3000) {
        requestAnimationFrame(look);
      } else {
        resolve({ frames: seen.size, longest });
      }
    };
    requestAnimationFrame(look);
  }));
  const rate = counted.frames / 3, each = 1000 * (await script() - before) / counted.frames;
  const words = `${rate.toFixed(1)} frames/s, longest pause ${counted.longest.toFixed(0)} ms, ${each.toFixed(1)} ms a frame`;
  assert.ok(rate > 10, words);
  assert.ok(each > 0 && each <= kMostScript_ms, words);
  return words;
});
await check("says when the robot has gone, and goes on with its next run", async () => {
  server.say("quiet");
  await until(page, () => /say nothing/.test(document.querySelector("#alarm:not([hidden])")?.textContent), 5000);
  await shoot(page, "robot_gone");
  server.say("begin");
  await until(page, () => document.querySelector("#alarm").hidden && Number(document.body.dataset.tick) < 3000, 5000);
  await drawsTwelve(page);
});
await check("asks nobody but its server, and complains of nothing", () => {
  staysHere(live);
  assert.deepEqual(live.complaints, []);
});
await check("says when its monitor has gone, and recovers when it is back", async () => {
  const port = new URL(server.url).port;
  const took = await server.stop();
  assert.ok(took < 1000, `the server took ${took} ms to end`);
  await until(page, () => /monitor does not answer/.test(document.querySelector("#alarm:not([hidden])")?.textContent), 5000);
  await shoot(page, "monitor_gone");
  await server.start(port);
  await until(page, () => document.querySelector("#alarm").hidden &&
                          document.querySelector("#connection").textContent === "live" &&
                          document.body.dataset.tick < 2000, 10000);
  await drawsTwelve(page);
  return `ended in ${took.toFixed(0)} ms`;
});
await page.close();
live = await openPage(browser, server.url, "dark");
await check("draws twelve joints in the dark, for a page that comes late", () => drawsTwelve(live.page));
server.say("faults rh_hfe 64");
server.say("faults lf_kfe 512");
await until(live.page, () => document.querySelector("#joint-lf_kfe.bad"), 5000);
await shoot(live.page, "live_dark");
await live.page.setViewport({ width: 800, height: 900 });
await shoot(live.page, "live_narrow");
await live.page.close();
await server.stop();

// A recording.
const recording = join(pictures, "made_up.mcap");
execFileSync(program, ["--record", robot, recording]);
const replay = await openPage(browser, await server.start(0, recording));
await check("opens a recording where data are, with the whole run drawn", async () => {
  await until(replay.page, () => document.body.dataset.time &&
                                 document.querySelector("#forces-span").textContent.startsWith("0.0 to 12.0 s"), 10000);
  assert.ok(Number(await replay.page.evaluate(() => document.body.dataset.time)) > 11.9);
  const states = await replay.page.$$eval(".joint .state", (all) => all.map((state) => state.textContent));
  assert.equal(states.length, 12);
  assert.deepEqual(states.filter((state) => !/^error \d/.test(state)), []);
  assert.match(await text(replay.page, "#poles-text"), /^Poles of the estimated model/);
  return drawsTwelve(replay.page);
});
await shoot(replay.page, "recording_opened");
await check("draws the ten seconds before an instant of a recording", async () => {
  await replay.page.select("#span", "last");
  await until(replay.page, () => document.querySelector("#forces-span").textContent.startsWith("last 10 s"), 2000);
  await drawsTwelve(replay.page);
  await replay.page.select("#span", "whole");
});
await check("scrubs through a recording", async () => {
  await until(replay.page, () => document.querySelectorAll("#events li").length > 1, 10000);
  await replay.page.focus("#slider");
  await replay.page.$eval("#slider", (slider) => {
    slider.value = 7;
    slider.dispatchEvent(new Event("input"));
  });
  await until(replay.page, () => Math.abs(document.body.dataset.time - 7) < 0.06, 5000);
  await until(replay.page, () => document.querySelector("#joint-lf_kfe.bad"), 2000);
  const drawn = await drawsTwelve(replay.page);
  await replay.page.keyboard.press("ArrowRight");
  await until(replay.page, () => Number(document.body.dataset.time) > 7.01, 2000);
  return drawn;
});
await shoot(replay.page, "recording");
await check("plays it", async () => {
  const before = Number(await replay.page.evaluate(() => document.body.dataset.time));
  await replay.page.keyboard.press("Space");
  await until(replay.page, (time) => Number(document.body.dataset.time) > time + 0.8, 4000, before);
});
await check("plays a recording that has just been opened from its beginning", async () => {
  const again = await openPage(browser, server.url);
  await until(again.page, () => Number(document.body.dataset.time) > 11.9, 10000);
  await again.page.keyboard.press("Space");
  await until(again.page, () => Number(document.body.dataset.time) > 0.3 && Number(document.body.dataset.time) < 5, 4000);
  await again.page.close();
});
await check("asks nobody but its server, and complains of nothing, in a recording too", () => {
  staysHere(replay);
  assert.deepEqual(replay.complaints, []);
});
await browser.close();
await server.stop();

console.log(`pictures: ${pictures}`);
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed === 0 ? 0 : 1);
