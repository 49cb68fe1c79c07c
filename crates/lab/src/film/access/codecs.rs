//! Part of WebCodecs (W3C Working Draft) used for films. `web-sys` requires an unstable compiler flag for it.

use js_sys::{Function, Promise};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::ImageData;

#[wasm_bindgen]
extern "C" {
    /// Decoder: takes encoded frames and calls back with pictures.
    pub type VideoDecoder;

    #[wasm_bindgen(constructor, catch)]
    pub fn new(callbacks: &JsValue) -> Result<VideoDecoder, JsValue>;

    #[wasm_bindgen(static_method_of = VideoDecoder, catch, js_name = isConfigSupported)]
    pub fn is_config_supported(config: &JsValue) -> Result<Promise, JsValue>;

    #[wasm_bindgen(method, catch)]
    pub fn configure(this: &VideoDecoder, config: &JsValue) -> Result<(), JsValue>;

    #[wasm_bindgen(method, catch)]
    pub fn decode(this: &VideoDecoder, chunk: &EncodedVideoChunk) -> Result<(), JsValue>;

    /// Delivers all pending frames. The next chunk must be a key frame.
    #[wasm_bindgen(method, catch)]
    pub fn flush(this: &VideoDecoder) -> Result<Promise, JsValue>;

    #[wasm_bindgen(method, catch)]
    pub fn close(this: &VideoDecoder) -> Result<(), JsValue>;

    #[wasm_bindgen(method, getter, js_name = decodeQueueSize)]
    pub fn decode_queue_size(this: &VideoDecoder) -> u32;

    #[wasm_bindgen(method, setter)]
    pub fn set_ondequeue(this: &VideoDecoder, react: Option<&Function>);

    /// Encoded frame.
    pub type EncodedVideoChunk;

    #[wasm_bindgen(constructor, catch)]
    pub fn new(parts: &JsValue) -> Result<EncodedVideoChunk, JsValue>;

    /// Decoded picture. Holds memory of the decoder until it is closed.
    #[derive(Clone)]
    pub type VideoFrame;

    #[wasm_bindgen(method, getter)]
    pub fn timestamp(this: &VideoFrame) -> f64;

    #[wasm_bindgen(method, getter)]
    pub fn format(this: &VideoFrame) -> Option<String>;

    #[wasm_bindgen(method, getter, js_name = visibleRect)]
    pub fn visible_rect(this: &VideoFrame) -> Option<Rect>;

    #[wasm_bindgen(method, catch, js_name = allocationSize)]
    pub fn allocation_size(this: &VideoFrame) -> Result<u32, JsValue>;

    #[wasm_bindgen(method, catch, js_name = copyTo)]
    pub fn copy_to(this: &VideoFrame, into: &JsValue) -> Result<Promise, JsValue>;

    #[wasm_bindgen(method)]
    pub fn close(this: &VideoFrame);

    /// Part of a picture (`DOMRectReadOnly`), px.
    pub type Rect;

    #[wasm_bindgen(method, getter)]
    pub fn width(this: &Rect) -> f64;

    #[wasm_bindgen(method, getter)]
    pub fn height(this: &Rect) -> f64;

    /// Layout of a plane in memory, bytes.
    pub type PlaneLayout;

    #[wasm_bindgen(method, getter)]
    pub fn offset(this: &PlaneLayout) -> u32;

    #[wasm_bindgen(method, getter)]
    pub fn stride(this: &PlaneLayout) -> u32;

    /// Context of a canvas that draws a `VideoFrame`, which `web-sys` does not support.
    #[wasm_bindgen(js_name = CanvasRenderingContext2D)]
    pub type Painter;

    #[wasm_bindgen(method, catch, js_name = drawImage)]
    pub fn draw_image(
        this: &Painter,
        picture: &JsValue,
        x: f64,
        y: f64,
        width: f64,
        height: f64,
    ) -> Result<(), JsValue>;

    #[wasm_bindgen(method, js_name = setTransform)]
    pub fn set_transform(this: &Painter, a: f64, b: f64, c: f64, d: f64, e: f64, f: f64);

    #[wasm_bindgen(method, js_name = fillRect)]
    pub fn fill_rect(this: &Painter, x: f64, y: f64, width: f64, height: f64);

    #[wasm_bindgen(method, setter, js_name = imageSmoothingEnabled)]
    pub fn set_image_smoothing_enabled(this: &Painter, smooth: bool);

    #[wasm_bindgen(method, catch, js_name = putImageData)]
    pub fn put_image_data(this: &Painter, data: &ImageData, x: f64, y: f64) -> Result<(), JsValue>;

    #[wasm_bindgen(method, catch, js_name = getImageData)]
    pub fn image_data(this: &Painter, x: f64, y: f64, width: f64, height: f64) -> Result<ImageData, JsValue>;

    #[wasm_bindgen(catch, js_name = createImageBitmap)]
    pub fn create_image_bitmap(source: &JsValue) -> Result<Promise, JsValue>;
}

/// True if the browser offers decoders. It does so only in secure contexts.
pub fn are_offered() -> bool {
    js_sys::Reflect::has(&js_sys::global(), &"VideoDecoder".into()).unwrap_or_default()
}
