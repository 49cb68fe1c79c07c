// Inflates the module that stands in this page and starts it. From a disk nothing can be fetched, hence the detour
// over text; streaming compiles while it inflates.
(async () => {
  const text = document.getElementById("module").textContent;
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const response = new Response(stream, { headers: { "content-type": "application/wasm" } });
  await wasm_bindgen({ module_or_path: response });
})().catch((error) => {
  console.error(error);
  document.getElementById("lab").innerHTML =
    '<p class="waiting" role="alert">This browser is too old for Meniscus. · Este navegador es demasiado antiguo para Meniscus.</p>';
});
