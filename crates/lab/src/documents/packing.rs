//! Compression and decompression by the browser, for documents inside links and parts of pages.

use js_sys::{Array, Function, Reflect, Uint8Array};
use view::browser;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{ReadableStream, ReadableStreamDefaultReader, WritableStream, WritableStreamDefaultWriter};

/// Deflates a text; `None` if the browser does not support it.
pub async fn deflate(text: &str) -> Option<Vec<u8>> {
    through("CompressionStream", "deflate-raw", text.as_bytes(), usize::MAX).await
}

/// Compresses bytes in gzip format; `None` if the browser does not support it.
pub async fn gzip(bytes: &[u8]) -> Option<Vec<u8>> {
    through("CompressionStream", "gzip", bytes, usize::MAX).await
}

/// Deflates bytes with a zlib header; `None` if the browser does not support it.
pub async fn zlib(bytes: &[u8]) -> Option<Vec<u8>> {
    through("CompressionStream", "deflate", bytes, usize::MAX).await
}

/// Inflates a text of at most `most` bytes; `None` if it is longer. The limit protects against decompression bombs in
/// links.
pub async fn inflate(bytes: &[u8], most: usize) -> Option<String> {
    String::from_utf8(through("DecompressionStream", "deflate-raw", bytes, most).await?).ok()
}

/// Inflates a file of at most `most` bytes into parts that stay in browser memory.
pub async fn inflate_parts(bytes: &Uint8Array, most: usize) -> Option<Array> {
    let parts = Array::new();
    let keep = |part: &Uint8Array| {
        parts.push(part);
    };
    stream("DecompressionStream", "deflate-raw", bytes, most, keep).await?;
    Some(parts)
}

/// Output of a transform stream of the browser; `None` if it fails or is longer than `most` bytes.
async fn through(kind: &str, format: &str, bytes: &[u8], most: usize) -> Option<Vec<u8>> {
    let mut result = Vec::new();
    stream(kind, format, &Uint8Array::from(bytes), most, |part| result.extend(part.to_vec())).await?;
    Some(result)
}

/// Runs a transform stream of the browser and passes each part of the output to `take`.
async fn stream(
    kind: &str,
    format: &str,
    bytes: &Uint8Array,
    most: usize,
    mut take: impl FnMut(&Uint8Array),
) -> Option<()> {
    // Constructed by name: in `web_sys` these classes require an unstable flag.
    let maker: Function = Reflect::get(&js_sys::global(), &kind.into()).ok()?.dyn_into().ok()?;
    let stream = Reflect::construct(&maker, &Array::of1(&format.into())).ok()?;
    let end = |name: &str| Reflect::get(&stream, &name.into()).ok();
    let writable: WritableStream = end("writable")?.dyn_into().ok()?;
    let readable: ReadableStream = end("readable")?.dyn_into().ok()?;
    let writer = WritableStreamDefaultWriter::new(&writable).ok()?;
    let reader = ReadableStreamDefaultReader::new(&readable).ok()?;
    // Errors of the input appear when the output is read.
    for promise in [writer.write_with_chunk(bytes), writer.close()] {
        wasm_bindgen_futures::spawn_local(async move { drop(browser::wait(promise).await) });
    }
    let mut length = 0;
    loop {
        let next = browser::wait(reader.read()).await.ok()?;
        let part = |name: &str| Reflect::get(&next, &name.into()).unwrap_or(JsValue::UNDEFINED);
        if part("done").is_truthy() {
            return Some(());
        }
        let chunk: Uint8Array = part("value").dyn_into().ok()?;
        length += chunk.length() as usize;
        if length > most {
            drop(browser::wait(reader.cancel()).await);
            return None;
        }
        take(&chunk);
    }
}
