// Keeps the files of this site, so that every page of it opens without a network. It answers for the folder it lies in, and
// for nothing else; what it does not keep, it asks of the host of that folder.

"use strict";

/** The SHA-256 of each file, by its address from here. */
const FILES = {};
const VERSION = "";

/** The copies of each version of this site have a name that begins so. Another site of the same host has another scope. */
const SITE = `meniscus ${registration.scope} `;
const CURRENT = SITE + VERSION;

const addressOf = (path) => new URL(path, registration.scope).href;
const hexadecimal = (bytes) => Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, "0")).join("");

/** A file of this version. Names in `assets/` contain the hash of what they name, so that a copy of any version will do. */
async function fetched(path, hash) {
  const isShared = path.startsWith("assets/");
  const copy = isShared && (await caches.match(addressOf(path)));
  if (copy) return copy;
  const response = await fetch(addressOf(path), { cache: isShared ? "default" : "no-cache" });
  const content = await response.arrayBuffer();
  // While a site is being uploaded, a host gives files of both versions.
  if (hexadecimal(await crypto.subtle.digest("SHA-256", content)) !== hash) throw new Error(`${path} is not of this version of the site`);
  // Made anew: hosts that leave out `.html` lead on to another address, and such an answer cannot be shown as a page.
  return new Response(content, { headers: { "Content-Type": response.headers.get("Content-Type") ?? "application/octet-stream" } });
}

/** All files or none: a version of which a file is missing is given up, and the one before goes on. */
async function install() {
  try {
    const cache = await caches.open(CURRENT);
    const files = Object.entries(FILES);
    await Promise.all(files.map(async ([path, hash]) => cache.put(addressOf(path), await fetched(path, hash))));
  } catch (failure) {
    await caches.delete(CURRENT);
    throw failure;
  }
  // Pages that are open have what they need, or find it in the version before.
  await skipWaiting();
}

/** Takes over from the version before, whose copies stay for the pages of it that are being opened. Older ones go. */
async function activate() {
  const others = (await caches.keys()).filter((name) => name.startsWith(SITE) && name !== CURRENT);
  await Promise.all(others.slice(0, -1).map((name) => caches.delete(name)));
  await clients.claim();
}

/** The copy of this version, also where the address is written without `.html` or `index.html`. */
async function answer(request) {
  const { origin, pathname } = new URL(request.url);
  const address = origin + pathname;
  const current = await caches.open(CURRENT);
  for (const name of [address, `${address}.html`, `${address}index.html`]) {
    const copy = await current.match(name);
    if (copy) return copy;
  }
  const ofAnyVersion = address.startsWith(addressOf("assets/")) && (await caches.match(address));
  return ofAnyVersion || fetch(request);
}

addEventListener("install", (event) => event.waitUntil(install()));
addEventListener("activate", (event) => event.waitUntil(activate()));
addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  if (method === "GET" && url.startsWith(registration.scope)) event.respondWith(answer(event.request));
});
