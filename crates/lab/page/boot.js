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
// Inflates the module that stands in this page and starts it. From a disk nothing can be fetched, hence the detour
// over text; streaming compiles while it inflates.
(async () => {
  const text = document.getElementById("module").textContent;
  const bytes = Uint8Array.fromBase64?.(text) ?? Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const response = new Response(stream, { headers: { "content-type": "application/wasm" } });
  await wasm_bindgen({ module_or_path: response });
})().catch((error) => {
  if (error instanceof WebAssembly.RuntimeError) throw error;
  console.error(error);
  tell("This browser is too old for Meniscus.", "Este navegador es demasiado antiguo para Meniscus.");
});
