//! Reading of files with a hand-in.

use desk::saved::hand_in::{HandIn, HandInError, LONGEST_HAND_IN};
use view::browser;
use web_sys::File;

/// The hand-in of a file, or why there is none; `None` if the browser does not provide the file. The browser begins to read
/// before the result is awaited. Too large files are refused without reading them.
pub fn read(file: &File) -> impl Future<Output = Option<Result<HandIn, HandInError>>> + use<> {
    let buffer = (file.size() <= LONGEST_HAND_IN as f64).then(|| file.array_buffer());
    async move {
        let Some(buffer) = buffer else { return Some(Err(HandInError::TooLarge)) };
        let buffer = browser::wait(buffer).await.ok()?;
        Some(HandIn::open(&js_sys::Uint8Array::new(&buffer).to_vec()))
    }
}
