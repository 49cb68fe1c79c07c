// A learning platform for tests: a server with a package and what was stored of its student, and `scorm-again` in the page around it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { after } from "node:test";
import { Lab, eventually, meniscus, number, program, temporary } from "./lab.mjs";

const again = dirname(createRequire(import.meta.url).resolve("scorm-again/scorm12/min"));
const servers = [];

after(() => servers.forEach((server) => server.close()));

/** Files of a ZIP archive without compression: names and bytes. */
export function unzipped(archive) {
  const files = new Map();
  let at = 0;
  while (archive.readUInt32LE(at) === 0x04034b50) {
    const [size, name, extra] = [archive.readUInt32LE(at + 22), archive.readUInt16LE(at + 26), archive.readUInt16LE(at + 28)];
    const start = at + 30 + name + extra;
    files.set(archive.toString("utf8", at + 30, at + 30 + name), archive.subarray(start, start + size));
    at = start + size;
  }
  return files;
}

/** The files in the package of a document for a kind of platform. */
export function packaged(document, kind) {
  const file = temporary(`${document.replace(/\W/g, "-")}.${kind}.zip`);
  meniscus("export", document, "--for", kind, "--output", file);
  return unzipped(readFileSync(file));
}

/** Starts a server. Its address, with a slash at the end. */
export async function served(answer) {
  const server = createServer((request, response) => {
    let body = "";
    request.on("data", (part) => (body += part));
    request.on("end", () => answer({ request, body, url: new URL(request.url, "http://host") }, response));
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  servers.push(server);
  return `http://127.0.0.1:${server.address().port}/`;
}

/** The platform of `scorm-again`. Calls are noted in `calls`, and those that were not answered with "true" in `refused`. */
const scormAgain = (kind, stored, mode) => `</script><script src="/${kind}.js"></script><script>
const api = new ${kind === "scorm12" ? "Scorm12API" : "Scorm2004API"}({ lmsCommitUrl: "/commit", logLevel: 5 });
api.loadFromJSON(${JSON.stringify(stored).replaceAll("<", "\\u003c")});
api.loadFromJSON(${JSON.stringify({ cmi: kind === "scorm12" ? { core: { lesson_mode: mode } } : { mode } })});
const [calls, refused, prefix] = [[], [], "${kind === "scorm12" ? "LMS" : ""}"];
for (const name of ["Initialize", "SetValue", "Commit", "Finish", "Terminate"]) {
  const own = api[prefix + name]?.bind(api);
  if (own) api[prefix + name] = (...words) => {
    const answer = own(...words);
    calls.push([name, ...words]);
    if (String(answer) !== "true") refused.push([name, ...words, String(api[prefix + "GetLastError"]())]);
    return answer;
  };
}
window[prefix ? "API" : "API_1484_11"] = api;`;

/** A platform with one package. `stored` is what it keeps of its student, `mode` how it opens the work; `script` replaces `scorm-again`. */
export class Platform {
  static async begin(document, kind, script) {
    const platform = Object.assign(new Platform(), { mode: "normal" });
    platform.stored = { cmi: kind === "scorm12" ? { core: { student_id: "s1042" } } : { learner_id: "s1042" } };
    const files = packaged(document, kind);
    platform.address = await served(({ url: { pathname, searchParams }, body }, response) => {
      const send = (type, content) => response.writeHead(200, { "Content-Type": `${type}; charset=utf-8` }).end(content);
      const frame = `<iframe src="${searchParams.get("from") ?? ""}/index.html" style="width:1300px;height:800px"></iframe>`;
      const inside = searchParams.has("window") ? "<button onclick=\"window.open('/index.html')\">Open</button>" : frame;
      if (pathname === "/commit") {
        platform.stored = { cmi: JSON.parse(body).cmi };
        send("application/json", '{"result":"true","errorCode":0}');
      } else if (pathname === `/${kind}.js`) {
        send("text/javascript", readFileSync(join(again, `${kind}.min.js`)));
      } else if (files.has(pathname.slice(1))) {
        send("text/html", files.get(pathname.slice(1)));
      } else {
        const code = script ?? scormAgain(kind, platform.stored, platform.mode);
        send("text/html", `<!doctype html><link rel="icon" href="data:,"><title>Course</title><h1>Course</h1><script>${code}</script>${inside}`);
      }
    });
    return platform;
  }

  /** The values that are in `cmi.core` in SCORM 1.2. */
  get core() {
    return this.stored.cmi.core ?? this.stored.cmi;
  }
}

/** A student or a teacher at the page of a package, in a profile of their own. */
export class Visit {
  static async open({ address }, options = {}) {
    const lab = await Lab.open({ address: () => address, ...options });
    return new Visit(lab, lab.page.frameLocator("iframe"));
  }

  /** `page`: what contains the page of the package. */
  constructor(lab, page) {
    [this.lab, this.page] = [lab, page];
  }

  async start() {
    await this.page.locator("#course-start").click();
    await eventually(async () => assert.equal(await this.page.locator("#course").count(), 0));
  }

  async tab(id) {
    await this.page.locator(`#tab-${id}`).click();
  }

  async enter(name, text) {
    await this.tab("explore");
    const field = this.page.getByRole("textbox", { name, exact: true });
    await field.fill(text);
    await field.press("Enter");
  }

  async value(name) {
    await this.tab("explore");
    return number(await this.page.getByRole("textbox", { name, exact: true }).inputValue());
  }

  async answer(question, text) {
    await this.tab("questions");
    const field = this.page.locator(`#answer-${question}`);
    await field.fill(text);
    await field.press("Enter");
    await eventually(async () => assert.notEqual(await this.page.locator(`#verdict-${question}`).innerText(), ""));
  }

  /** Text and grade of the answers to the first questions. */
  async answers(count) {
    await this.tab("questions");
    const one = async (question) => [
      await this.page.locator(`#answer-${question}`).inputValue(),
      await this.page.locator(`#verdict-${question}`).getAttribute("data-grade"),
    ];
    return Promise.all(Array.from({ length: count }, (_, question) => one(question)));
  }

  /** Hands in: the file. */
  async handIn(name) {
    await this.page.locator("#hand-in").click();
    await this.page.locator("#hand-in-name").fill(name);
    const saved = await this.lab.save(this.page.locator("#save-hand-in"));
    await this.page.locator("#hand-in-dialog .dialog-head button").click();
    return saved;
  }

  /** What the page of the platform has noted under this name. */
  noted(name) {
    return this.lab.page.evaluate(name);
  }

  async close() {
    assert.deepEqual(this.lab.faults, [], "errors in the page");
    await this.lab.context.close();
  }
}

/** Exit code and result of `meniscus verify`. */
export function verified(text) {
  const file = temporary("a.hand-in");
  writeFileSync(file, text);
  try {
    return { code: 0, found: JSON.parse(execFileSync(program, ["verify", file, "--format", "json"], { encoding: "utf8" })) };
  } catch (failure) {
    return { code: failure.status, found: JSON.parse(failure.stdout) };
  }
}
