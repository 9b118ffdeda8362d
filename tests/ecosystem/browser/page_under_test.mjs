// A server of the page, a browser on it, and what the browser sees.
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { createInterface } from "node:readline";
import puppeteer from "puppeteer-core";

export function findBrowser() {
  const places = [process.env.FARRIER_BROWSER, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
  return places.find((place) => place && existsSync(place));
}

export class Server {
  constructor(program, page, robot) {
    Object.assign(this, { program, page, robot });
  }

  /// Starts it; port 0: any. `recording`: of that instead of a robot.
  async start(port = 0, recording = undefined) {
    this.child = spawn(this.program, [this.page, this.robot, String(port), ...(recording ? [recording] : [])],
                       { stdio: ["pipe", "pipe", "inherit"] });
    this.url = await new Promise((resolve, reject) => {
      createInterface({ input: this.child.stdout }).once("line", resolve);
      this.child.once("exit", (status) => reject(new Error(`the server ended with ${status}`)));
    });
    return this.url;
  }

  say(line) {
    this.child.stdin.write(`${line}\n`);
  }

  /// Milliseconds it took to end.
  async stop(signal = "SIGTERM") {
    const begin = performance.now();
    const ended = new Promise((resolve) => this.child.once("exit", resolve));
    this.child.kill(signal);
    await ended;
    return performance.now() - begin;
  }
}

export async function launch(executablePath) {
  return puppeteer.launch({
    executablePath,
    headless: true,
    args: ["--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
  });
}

/// Opens a page that keeps account of what it asks for and complains of.
export async function openPage(browser, url, scheme = "light") {
  const page = await browser.newPage();
  const account = { page, requests: [], complaints: [] };
  await page.setViewport({ width: 1440, height: 1180 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  page.on("request", (request) => account.requests.push(request.url()));
  page.on("console", (message) => {
    if (["error", "warn"].includes(message.type())) {
      account.complaints.push(message.text());
    }
  });
  page.on("pageerror", (problem) => account.complaints.push(String(problem)));
  await page.goto(url, { waitUntil: "domcontentloaded" });
  return account;
}

/// Of each joint's plot, or the canvases that `selector` finds, how many of its pixels carry the colour of the measured force; and of the reference.
export function drawnPixels(page, selector = ".joint canvas") {
  return page.evaluate((selector) => {
    const style = getComputedStyle(document.documentElement);
    const rgb = (name) => style.getPropertyValue(name).trim().match(/[0-9a-f]{2}/gi).map((part) => parseInt(part, 16));
    const wanted = [rgb("--blue"), rgb("--orange")];
    return [...document.querySelectorAll(selector)].map((canvas) => {
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      const counts = [0, 0];
      for (let i = 0; i < data.length; i += 4) {
        wanted.forEach((one, k) => {
          const distance = Math.max(...one.map((part, c) => Math.abs(part - data[i + c])));
          counts[k] += data[i + 3] > 128 && distance < 40 ? 1 : 0;
        });
      }
      return counts;
    });
  }, selector);
}

/// Number of colours in a picture of an element: an empty one has few.
export async function shadesOf(browser, element) {
  const picture = await element.screenshot({ encoding: "base64" });
  const blank = await browser.newPage();
  const count = await blank.evaluate(async (bytes) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${bytes}`)).blob());
    const copy = new OffscreenCanvas(image.width, image.height).getContext("2d");
    copy.drawImage(image, 0, 0);
    return new Set(new Uint32Array(copy.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, picture);
  await blank.close();
  return count;
}

export function until(page, words, limit, ...values) {
  return page.waitForFunction(words, { timeout: limit, polling: 50 }, ...values);
}
