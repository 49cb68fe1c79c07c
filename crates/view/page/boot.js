// The syntax of this script is that of ES2018, so that browsers that are too old for the others can say so.
// Words in the place of the laboratory, or above it.
const tell = (...languages) => {
  const words = document.createElement("p");
  words.className = "waiting";
  words.role = "alert";
  words.textContent = languages.join(" · ");
  document.querySelectorAll(".waiting").forEach((before) => before.remove());
  document.body.prepend(words);
};
// A fault in the module ends in a trap, without words of its own; nothing works after it.
const stopped = (error) => {
  if (error instanceof WebAssembly.RuntimeError) {
    tell(
      "Meniscus has stopped: there is a fault in it. Load the page again.",
      "Meniscus se ha detenido por un fallo suyo. Vuelve a cargar la página.",
      "O Meniscus parou por uma falha sua. Recarregue a página.",
    );
  }
};
addEventListener("error", (event) => stopped(event.error));
addEventListener("unhandledrejection", (event) => stopped(event.reason));
// The packed bytes of a part. It stands in the page as text, or in a file of its own in a site. From a disk nothing can be
// fetched; there a script puts the text of that file into the page.
const packed = async (part) => {
  const file = part.href || part.dataset.file;
  if (file && location.protocol !== "file:") return new Uint8Array(await (await fetch(file)).arrayBuffer());
  if (file && !part.textContent) {
    await new Promise((done, failed) => {
      document.head.append(Object.assign(document.createElement("script"), { src: part.dataset.text, onload: done, onerror: failed }));
    });
  }
  const text = part.textContent;
  return Uint8Array.fromBase64 ? Uint8Array.fromBase64(text) : Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
};
// False if a part of the page is missing or damaged: then the file or the network is at fault, and not the browser.
let isWhole = true;
const broken = (error) => {
  isWhole = false;
  throw error;
};
// Inflates a part. With `rest` in portions, between which the page answers: browsers inflate what is written at once in one task.
const inflated = async (part, format = "gzip", rest) => {
  // Written to directly: the stream of a blob makes the way through the browser's other processes.
  const inflater = new DecompressionStream(format);
  const bytes = await packed(part).catch(broken);
  const writer = inflater.writable.getWriter();
  const portion = rest ? 1 << 17 : bytes.length;
  const write = async () => {
    for (let at = 0; at < bytes.length; at += portion) {
      if (at) await rest();
      await writer.write(bytes.subarray(at, at + portion));
    }
    await writer.close();
  };
  // Of damage one hears where it is read.
  write().catch(() => {});
  return new Response(inflater.readable).arrayBuffer().catch(broken);
};
// Texts of the languages, packed in elements behind this script and further on: inflated once, and kept for the module.
let textsArrived;
const textsBehind = new Promise((done) => (textsArrived = done));
globalThis.texts = {
  ready: {},
  async load(id) {
    await textsBehind;
    const part = document.getElementById(id);
    if (part && !texts.ready[id]) texts.ready[id] = new Uint8Array(await inflated(part));
    return texts.ready[id];
  },
};
// Says why a part cannot be started.
const failed = (error) => {
  if (globalThis.WebAssembly && error instanceof WebAssembly.RuntimeError) throw error;
  if (isWhole) {
    console.error(error);
    tell(
      "This browser is too old for Meniscus. Update it, or use another one.",
      "Este navegador es demasiado antiguo para Meniscus. Actualízalo o usa otro.",
      "Este navegador é antigo demais para o Meniscus. Atualize-o ou use outro.",
      "Chrome 111, Edge 111, Firefox 121, Safari 16.4",
    );
  } else if (document.querySelector("#module[href], [data-file]")) {
    tell(
      "A part of this page could not be loaded. Load the page again.",
      "No se ha podido cargar una parte de esta página. Vuelve a cargarla.",
      "Uma parte desta página não pôde ser carregada. Recarregue a página.",
    );
  } else {
    tell(
      "This file is damaged. Download it again.",
      "Este archivo está dañado. Vuelve a descargarlo.",
      "Este arquivo está danificado. Baixe-o de novo.",
    );
  }
};
// Starts the player with the simulation of the page.
const start = async () => {
  // A page in the frame of an element gets what the simulations around it share, and its own.
  const given = globalThis.frameElement && frameElement.given;
  // A page without a simulation has no bundle.
  const parts = ["module", "bundle"].map((id) => document.getElementById(id)).filter((part, place) => part || !place);
  const [module, bundle] = await (given || Promise.all(parts.map((part) => inflated(part))));
  await firstFrame;
  globalThis.bundle = bundle && new Uint8Array(bundle);
  await wasm_bindgen({ module_or_path: module });
};
if (globalThis.opening) opening.begin();
else start().catch(failed);
