// Pages with and without workers.

import { readFileSync, writeFileSync } from "node:fs";
import { labPage, temporary } from "./lab.mjs";

/** The page in a browser that refuses workers. */
export function withoutWorkers() {
  const file = temporary("without-workers.html");
  writeFileSync(file, readFileSync(labPage, "utf8").replace("worker-src data:; ", ""));
  return file;
}
