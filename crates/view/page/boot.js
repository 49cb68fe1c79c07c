// Words in the place of the laboratory, or above it.
const tell = (english, spanish) => {
  const words = document.createElement("p");
  words.className = "waiting";
  words.role = "alert";
  words.textContent = `${english} · ${spanish}`;
  document.querySelector(".waiting")?.remove();
  document.body.prepend(words);
};
// A fault in the module ends in a trap, without words of its own; nothing works after it.
const stopped = (error) => {
  if (error instanceof WebAssembly.RuntimeError) {
    tell(
      "Meniscus has stopped: there is a fault in it. Load the page again.",
      "Meniscus se ha detenido por un fallo suyo. Vuelve a cargar la página.",
    );
  }
};
addEventListener("error", (event) => stopped(event.error));
addEventListener("unhandledrejection", (event) => stopped(event.reason));
// Inflates the module that stands in this page, and the simulation of a page that has one, and starts it. From a disk nothing can be fetched, hence the detour over
// text.
const inflated = async (id) => {
  const text = document.getElementById(id).textContent;
  const bytes = Uint8Array.fromBase64?.(text) ?? Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  // Written to directly: the stream of a blob makes the way through the browser's other processes.
  const inflater = new DecompressionStream("gzip");
  const writer = inflater.writable.getWriter();
  // Of damage one hears where it is read.
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  return new Response(inflater.readable).arrayBuffer();
};
(async () => {
  const parts = ["module", "bundle"].filter((id) => document.getElementById(id));
  const [module, bundle] = await Promise.all(parts.map(inflated)).catch((error) => {
    // The browser knows no DecompressionStream.
    if (error instanceof ReferenceError) throw error;
    return [];
  });
  if (!module) {
    tell("This file is damaged. Download it again.", "Este archivo está dañado. Vuelve a descargarlo.");
    return;
  }
  globalThis.bundle = bundle && new Uint8Array(bundle);
  await wasm_bindgen({ module_or_path: module });
})().catch((error) => {
  if (globalThis.WebAssembly && error instanceof WebAssembly.RuntimeError) throw error;
  console.error(error);
  tell("This browser is too old for Meniscus.", "Este navegador es demasiado antiguo para Meniscus.");
});
