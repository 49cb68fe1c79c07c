//! What tests and benchmarks run inside WebAssembly.
