// Inflates the module that stands in the page and starts it.
(async () => {
  const text = document.getElementById("module").textContent;
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const response = new Response(stream, { headers: { "content-type": "application/wasm" } });
  await wasm_bindgen({ module_or_path: response });
})();
