// WebKit, driven by classic WebDriver over HTTP: Debian's WebKitGTK in a virtual screen with a message bus of its own, so that it runs
// where there is neither. A driver has one session.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { createServer } from "node:net";
import { basename } from "node:path";
import { eventually } from "./lab.mjs";

/** Key under which WebDriver names an element. */
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";

/** What this file has started. */
const started = [];

/** Starts a program in a group of its own, which `stop` ends as a whole. */
function start(program, words, options) {
  const child = spawn(program, words, { detached: true, ...options });
  child.on("error", (failure) => (child.failure = failure));
  started.push(child);
  return child;
}

/** Ends what this file has started. */
function stop() {
  for (const child of started.splice(0)) if (child.pid && child.exitCode === null) process.kill(-child.pid, "SIGTERM");
}
process.on("exit", stop);

/** A port on which nothing listens. */
const freePort = () =>
  new Promise((done) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });

/** Starts a virtual screen of this size, px; its name. */
async function screen(width, height) {
  const server = start("Xvfb", ["-displayfd", "3", "-screen", "0", `${width}x${height}x24`, "-nolisten", "tcp"], { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  let number = "";
  server.stdio[3].on("data", (text) => (number += text));
  await eventually(() => {
    assert.ok(!server.failure && server.exitCode === null, `Xvfb has not started: ${server.failure ?? server.exitCode}`);
    assert.match(number, /^\d+\n/);
  });
  return `:${number.trim()}`;
}

/** WebKit with one window. */
export class WebKit {
  /** Starts the browser with a window of this size, px. No window is narrower than 447 px. */
  static async open(width, height) {
    const driver = process.env.WEBKIT ?? assert.fail("WEBKIT must name WebKitWebDriver; `cargo xtask test` finds it");
    const port = await freePort();
    const env = { ...process.env, DISPLAY: await screen(width, height), GDK_BACKEND: "x11", LIBGL_ALWAYS_SOFTWARE: "1", NO_AT_BRIDGE: "1", LC_ALL: "C.UTF-8" };
    start("dbus-run-session", ["--", driver, `--port=${port}`], { env, stdio: "ignore" });
    const webkit = new WebKit(`http://127.0.0.1:${port}`);
    await eventually(() => webkit.ask("GET", "/status"));
    // Without a name in its options, the driver takes the browser that comes with it.
    const { sessionId } = await webkit.ask("POST", "/session", { capabilities: {} });
    webkit.address += `/session/${sessionId}`;
    await webkit.ask("POST", "/window/rect", { x: 0, y: 0, width, height });
    return webkit;
  }

  constructor(address) {
    this.address = address;
  }

  /** Ends the browser and all that was started for it. */
  async close() {
    await this.ask("DELETE", "").catch(() => {});
    stop();
  }

  /** Sends a command to the driver; its value. */
  async ask(method, path, body) {
    const response = await fetch(this.address + path, { method, body: body && JSON.stringify(body) });
    const { value } = await response.json();
    if (!response.ok) throw new Error(`${path}: ${value.error}: ${value.message}`);
    return value;
  }

  go(url) {
    return this.ask("POST", "/url", { url });
  }

  /** Calls a function in the page; what it returns, or what its promise comes to. */
  run(does, ...args) {
    return this.ask("POST", "/execute/sync", { script: `return (${does})(...arguments)`, args });
  }

  /** Until a function in the page returns something true; what that is. `what` is named where it never does. */
  until(what, does, ...args) {
    return eventually(async () => (await this.run(does, ...args)) || assert.fail(`not in WebKit: ${what}`));
  }

  /** The command of an element that a selector names, as soon as it is there and can be reached. */
  element(selector, command, body) {
    return eventually(async () => {
      const found = await this.ask("POST", "/element", { using: "css selector", value: selector });
      // The driver does not scroll panels.
      await this.run((element) => element.scrollIntoView({ block: "center", behavior: "instant" }), found);
      await this.ask("POST", `/element/${found[ELEMENT]}/${command}`, body);
    });
  }

  /** Presses what a selector names with the mouse. */
  press(selector) {
    return this.element(selector, "click", {});
  }

  /** Types into the field that a selector names, instead of what stands there. */
  async type(selector, text) {
    await this.element(selector, "clear", {});
    await this.element(selector, "value", { text });
  }

  /** Clicks a point of the window, px. */
  click([x, y]) {
    const move = { type: "pointerMove", duration: 0, x: Math.round(x), y: Math.round(y) };
    const actions = [move, { type: "pointerDown", button: 0 }, { type: "pointerUp", button: 0 }];
    return this.ask("POST", "/actions", { actions: [{ type: "pointer", id: "mouse", actions }] });
  }

  /** Lets a file fall on the page, as a hand does. */
  drop(path) {
    const does = (name, bytes) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0))], name));
      document.querySelector("#apparatus").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    };
    return this.run(does, basename(path), readFileSync(path, "base64"));
  }

  /** Colours `[red, green, blue]` of the window at points of the page, px. */
  async pixels(points) {
    const picture = await this.ask("GET", "/screenshot");
    const does = async (picture, points) => {
      const image = Object.assign(new Image(), { src: `data:image/png;base64,${picture}` });
      await image.decode();
      const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const scale = image.width / innerWidth;
      return points.map(([x, y]) => [...context.getImageData(Math.round(x * scale), Math.round(y * scale), 1, 1).data].slice(0, 3));
    };
    return this.run(does, picture, points);
  }
}
