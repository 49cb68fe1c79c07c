// A learning platform for tests: a server with the package and what was stored of each student, and `scorm-again` in the page around it.

import { createServer } from "node:http";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { meniscus, temporary } from "./lab.mjs";

const again = dirname(createRequire(import.meta.url).resolve("scorm-again/scorm12/min"));

/** Files of a ZIP archive without compression: name and bytes. */
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

/** The package of a document for a kind of platform. */
export function packaged(document, kind) {
  const file = temporary(`${document.replace(/\W/g, "-")}.${kind}.zip`);
  meniscus("export", document, "--for", kind, "--output", file);
  return unzipped(readFileSync(file));
}

/** The page of a platform. Everything that the page in the frame sets is in `set`, what was refused in `refused`. */
const around = (kind, stored, how) => `<!doctype html><link rel="icon" href="data:,"><title>Course</title><h1>Course</h1>
<script src="/${kind}.js"></script>
<script>
const api = new ${kind === "scorm12" ? "Scorm12API" : "Scorm2004API"}({ lmsCommitUrl: "/commit", logLevel: 5 });
api.loadFromJSON(${JSON.stringify(stored).replaceAll("<", "\\u003c")});
const [set, refused] = [[], []];
for (const name of ["Initialize", "SetValue", "Commit", "Finish", "Terminate"].map((name) => "${kind === "scorm12" ? "LMS" : ""}" + name)) {
  const own = api[name]?.bind(api);
  if (own) api[name] = (...words) => {
    const answer = own(...words);
    set.push([name.replace("LMS", ""), ...words]);
    if (String(answer) !== "true") refused.push([name, ...words, String(api[name.startsWith("LMS") ? "LMSGetLastError" : "GetLastError"]())]);
    return answer;
  };
}
window.${kind === "scorm12" ? "API" : "API_1484_11"} = api;
</script>
${how === "window" ? '<button onclick="open(\'/index.html\')">Open</button>' : '<iframe src="/index.html" style="width:1300px;height:800px"></iframe>'}`;

/** A platform with one package. `stored` is what it keeps of its student. */
export class Platform {
  static async begin(document, kind) {
    const platform = new Platform(packaged(document, kind), kind);
    await new Promise((listening) => platform.server.listen(0, "127.0.0.1", listening));
    platform.address = `http://127.0.0.1:${platform.server.address().port}/`;
    return platform;
  }

  constructor(files, kind) {
    [this.files, this.kind] = [files, kind];
    this.stored = { cmi: kind === "scorm12" ? { core: { student_id: "s1042" } } : { learner_id: "s1042" } };
    this.server = createServer((request, response) => {
      const { pathname, searchParams } = new URL(request.url, "http://host");
      const send = (type, body) => response.writeHead(200, { "Content-Type": type }).end(body);
      if (pathname === "/commit") {
        let body = "";
        request.on("data", (part) => (body += part));
        request.on("end", () => {
          this.stored = { cmi: JSON.parse(body).cmi };
          send("application/json", '{"result":"true","errorCode":0}');
        });
      } else if (pathname === "/") {
        send("text/html; charset=utf-8", around(kind, this.stored, searchParams.get("how")));
      } else if (pathname === `/${kind}.js`) {
        send("text/javascript", readFileSync(join(again, `${kind}.min.js`)));
      } else if (files.has(pathname.slice(1))) {
        send("text/html; charset=utf-8", files.get(pathname.slice(1)));
      } else {
        response.writeHead(404).end();
      }
    });
  }
}
