//! Large parts of the laboratory that few visits need: they stand in the page deflated, or in a site in files of their own.

use crate::packing;
use js_sys::Promise;
use view::browser;
use view::views::{document, window};
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement};

/// No part is longer when it is inflated.
const LONGEST: usize = 4_000_000;

/// The element of a part. A heading of a document may have its id, too; a script it cannot be.
pub fn part(id: &str) -> Option<Element> {
    document().query_selector(&format!("script#{id}")).ok()?
}

/// Whether the laboratory belongs to a site, where a part is a file.
pub fn is_in_site() -> bool {
    part("player").is_some_and(|part| part.has_attribute("data-script"))
}

/// The text that stands in a part.
pub async fn inflated(part: &Element) -> Option<String> {
    let letters = window().atob(&part.text_content()?).ok()?;
    let bytes: Vec<u8> = letters.chars().map(|letter| letter as u8).collect();
    packing::inflate(&bytes, LONGEST).await
}

/// Runs the script of this address.
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
