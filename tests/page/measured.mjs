// What a person does with measured data in the page.

import assert from "node:assert/strict";
import { inflateRawSync } from "node:zlib";
import { eventually, number } from "./lab.mjs";

export const LENGTH = 0.21;
export const DAMPING = 0.4;

/** A film of a swinging column: the truth and a noise that is the same each time. */
export function film(length = LENGTH, seed = 1) {
  const [omega, rows] = [Math.sqrt((2 * 9.8) / length - DAMPING ** 2), ["t;y [cm]"]];
  for (let frame = 0; frame < 240; frame += 1) {
    seed = (seed * 16807) % 2147483647;
    const time = frame / 30;
    const level = 5 * Math.exp(-DAMPING * time) * Math.cos(omega * time) + 0.03 * (seed / 2147483647 - 0.5);
    rows.push(`${time.toFixed(5)};${level.toFixed(4)}`.replaceAll(".", ","));
  }
  return rows.join("\r\n");
}

/** Opens a document that the page carries. */
export async function openTheory(lab, title) {
  await lab.page.locator("#browse").click();
  await lab.page.getByRole("dialog").getByRole("link", { name: title, exact: true }).click();
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), title));
}

export const records = (lab) => lab.page.locator("article.record");

/** Unfolds a step of fitting in the tab *Measure*: `record`, `theory`, or `fit` with all numbers. */
export async function unfold(lab, step) {
  const card = lab.page.locator(`#${step}-step`);
  await card.waitFor();
  if (!(await card.evaluate((card) => card.open))) await card.locator("> summary").click();
  await lab.drawn();
}

/** Fits and waits; the estimates by their symbols' names. */
export async function fit(lab, button = "#fit") {
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator(button).click();
  return fitted(lab);
}

/** Waits until a fit that was started has ended. */
export async function fitted(lab) {
  await lab.page.locator(".estimates").waitFor({ state: "attached", timeout: 60_000 });
  await eventually(async () => assert.equal(await lab.page.locator("#cancel-fit").count(), 0), 60);
  await unfold(lab, "fit");
  return estimates(lab);
}

/** What was found; of several records, each one's own under `record: label`. */
export async function estimates(lab) {
  const rows = await lab.page.locator(".estimates tr").evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.innerText.trim())));
  const found = new Map();
  let record = "";
  for (const [label, value, unit, remark] of rows) {
    if (value === undefined) {
      record = /^(All records|Todos los registros)$/.test(label) ? "" : `${label}: `;
      continue;
    }
    const [middle, spread] = value.replace(/[()]/g, "").split("±").map(number);
    const power = value.match(/×10(\S+)/)?.[1].replace(/./g, (sign) => "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(sign) >= 0 ? "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(sign) : "-");
    const scale = value.includes("(") && power ? 10 ** Number(power) : 1;
    found.set(record + label.split("\n")[0].trim(), { value: middle * scale, spread: spread * scale, unit, remark });
  }
  return found;
}

/** The files of a ZIP archive, by its central directory. */
export function unzip(bytes) {
  const end = bytes.lastIndexOf(Buffer.from([0x50, 0x4b, 5, 6]));
  let at = bytes.readUInt32LE(end + 16);
  const files = new Map();
  for (let entry = bytes.readUInt16LE(end + 10); entry > 0; entry -= 1) {
    const [method, packed, name, extra, comment, start] = [
      bytes.readUInt16LE(at + 10), bytes.readUInt32LE(at + 20), bytes.readUInt16LE(at + 28),
      bytes.readUInt16LE(at + 30), bytes.readUInt16LE(at + 32), bytes.readUInt32LE(at + 42),
    ];
    const body = start + 30 + bytes.readUInt16LE(start + 26) + bytes.readUInt16LE(start + 28);
    const content = bytes.subarray(body, body + packed);
    files.set(bytes.toString("utf8", at + 46, at + 46 + name), (method === 0 ? content : inflateRawSync(content)).toString("utf8"));
    at += 46 + name + extra + comment;
  }
  return files;
}
