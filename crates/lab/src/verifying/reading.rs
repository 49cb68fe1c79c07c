//! Reading of files with a hand-in.

use desk::saved::hand_in::{HandIn, HandInError, LONGEST_HAND_IN};
use view::browser;
use web_sys::File;

/// The hand-in of a file, or why there is none; `None` if the browser does not provide the file. Too large files are refused
/// without reading them.
pub async fn read(file: &File) -> Option<Result<HandIn, HandInError>> {
    if file.size() > LONGEST_HAND_IN as f64 {
        return Some(Err(HandInError::TooLarge));
    }
    let buffer = browser::wait(file.array_buffer()).await.ok()?;
    Some(HandIn::open(&js_sys::Uint8Array::new(&buffer).to_vec()))
}
