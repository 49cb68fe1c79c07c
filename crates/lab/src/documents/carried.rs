//! Large parts of the laboratory that few visits need: deflated inside the page, or separate files in a site.

use crate::documents::packing;
use js_sys::Promise;
use view::browser;
use view::views::{document, window};
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

/// Maximum length of an inflated part, in bytes.
const LONGEST: usize = 4_000_000;

/// Element of a part. Only `script` elements are searched, because a heading of a document may have the same id.
pub fn part(id: &str) -> Option<Element> {
    document().query_selector(&format!("script#{id}")).ok()?
}

/// True if the laboratory belongs to a site, where parts are separate files.
pub fn is_in_site() -> bool {
    part("player").is_some_and(|part| part.has_attribute("data-script"))
}

/// Inflated text of a part.
pub async fn inflated(part: &Element) -> Option<String> {
    let letters = window().atob(&part.text_content()?).ok()?;
    let bytes: Vec<u8> = letters.chars().map(|letter| letter as u8).collect();
    packing::inflate(&bytes, LONGEST).await
}

/// Runs the script at this address.
pub async fn run_file(address: &str) -> Option<()> {
    let script = script()?;
    let loaded = Promise::new(&mut |done, failed| {
        script.set_onload(Some(&done));
        script.set_onerror(Some(&failed));
    });
    script.set_attribute("src", address).ok()?;
    document().head()?.append_child(&script).ok()?;
    browser::wait(loaded).await.ok().map(drop)
}

/// Runs a text as a script.
pub fn run(text: &str) -> Option<()> {
    let script = script()?;
    script.set_text_content(Some(text));
    document().head()?.append_child(&script).ok().map(drop)
}

fn script() -> Option<HtmlElement> {
    document().create_element("script").ok()?.dyn_into().ok()
}
