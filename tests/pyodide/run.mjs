// Runs a program of Python in Pyodide with a wheel: `node run.mjs WHEEL FOLDER PROGRAM`. FOLDER is the current one there, and the
// program finds the files beside it.

import { readFileSync } from "node:fs";
import { basename, dirname, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Worker } from "node:worker_threads";
import { loadPyodide } from "pyodide";

const [wheel, folder, program] = process.argv.slice(2);
const pyodide = await loadPyodide();

// The signal of an interrupt, set from another thread while Python is busy.
const signal = new Uint8Array(new SharedArrayBuffer(1));
pyodide.setInterruptBuffer(signal);
const interrupt = `
  const { workerData: { signal, milliseconds } } = require("node:worker_threads");
  setTimeout(() => { signal[0] = 2; }, milliseconds);
`;
globalThis.interruptAfter = (milliseconds) => {
  new Worker(interrupt, { eval: true, workerData: { signal, milliseconds } });
};

try {
  await pyodide.loadPackage(pathToFileURL(wheel).href, { messageCallback: () => {} });
  pyodide.FS.mkdir("/project");
  pyodide.FS.mount(pyodide.FS.filesystems.NODEFS, { root: resolve(folder) }, "/project");
  pyodide.FS.chdir("/project");
  pyodide.globals.set("beside", relative(folder, dirname(program)));
  pyodide.runPython(`import sys; sys.path.insert(0, "/project/" + beside); sys.dont_write_bytecode = True`);
  pyodide.runPython(readFileSync(program, "utf8"), { filename: basename(program) });
} catch (error) {
  // Without the line of Pyodide's own program, which is a megabyte long.
  console.error(error.message);
  process.exitCode = 1;
}
