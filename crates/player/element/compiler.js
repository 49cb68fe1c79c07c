// Inflates the laboratory's module in this worker, which then compiles the texts that it is sent (`crates/lab/src/workers`).
fetch("laboratory.bin")
  .then(({ body }) => new Response(body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer())
  .then((module) => laboratory({ module_or_path: module }));
