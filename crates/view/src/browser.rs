//! The few things the laboratory asks of the browser that may fail: storage, clipboard, files. A refusal is an answer,
//! never a panic; a page opened from `file://`, in private mode or inside a frame is refused many of them.

use crate::views::{document, window};
use js_sys::{Array, Function, Promise, Reflect, Uint8Array};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{
    Blob, BlobPropertyBag, Event, FocusOptions, HtmlAnchorElement, HtmlElement, HtmlTextAreaElement, ScrollBehavior,
    ScrollToOptions, Url,
};

/// The element with this id, if it is of type `T`.
pub fn by_id<T: JsCast>(id: &str) -> Option<T> {
    document().get_element_by_id(id)?.dyn_into().ok()
}

/// The id of what has the focus; empty where nothing has.
pub fn focused() -> String {
    document().active_element().map(|element| element.id()).unwrap_or_default()
}

/// Moves the focus to an element.
pub fn focus(id: &str) {
    if let Some(element) = by_id::<HtmlElement>(id) {
        let _ = element.focus();
    }
}

/// The same in the next frame, when the views have been rebuilt.
pub fn focus_later(id: String) {
    let focus = Closure::once_into_js(move || focus(&id));
    let _ = window().request_animation_frame(focus.unchecked_ref());
}

/// Moves the focus to an element in the next frame, if what had it is gone by then.
pub fn keep_focus_later(id: String) {
    let keep = Closure::once_into_js(move || {
        let active = document().active_element();
        if active.is_none_or(|active| active.tag_name() == "BODY") {
            focus(&id);
        }
    });
    let _ = window().request_animation_frame(keep.unchecked_ref());
}

/// Moves the focus to an element without scrolling to it: where what had the focus is gone.
pub fn focus_in_place(id: &str) {
    let options = FocusOptions::new();
    options.set_prevent_scroll(true);
    if let Some(element) = by_id::<HtmlElement>(id) {
        let _ = element.focus_with_options(&options);
    }
}

/// Scrolls to an element and gives it the focus, once it is there.
pub fn reveal_later(id: String) {
    let reveal = Closure::once_into_js(move || {
        if let Some(element) = by_id::<HtmlElement>(&id) {
            element.scroll_into_view();
            focus_in_place(&id);
        }
    });
    let _ = window().request_animation_frame(reveal.unchecked_ref());
}

/// How far the page is scrolled.
pub fn scrolled() -> f64 {
    window().scroll_y().unwrap_or(0.0)
}

/// Scrolls the page, at once.
pub fn scroll_to(place: f64) {
    let options = ScrollToOptions::new();
    options.set_top(place);
    options.set_behavior(ScrollBehavior::Instant);
    window().scroll_to_with_scroll_to_options(&options);
}

/// Below this part of the window's height too little of an element is seen.
const LOW: f64 = 0.6;

/// Scrolls to the top of an element, at once, where it reaches beyond the top of the window or begins so low that little of it would be
/// seen.
pub fn bring_into_sight(id: &str) {
    let Some(element) = by_id::<HtmlElement>(id) else { return };
    // Where it begins below what sticks to the top of the window: its scroll margin.
    let margin = window().get_computed_style(&element).ok().flatten();
    let margin = margin.and_then(|style| style.get_property_value("scroll-margin-top").ok());
    let margin: f64 = margin.and_then(|margin| margin.trim_end_matches("px").parse().ok()).unwrap_or(0.0);
    let top = element.get_bounding_client_rect().top();
    let above = top - margin;
    let height = window().inner_height().ok().and_then(|height| height.as_f64()).unwrap_or(f64::INFINITY);
    if above < 0.0 || top > LOW * height {
        scroll_to(scrolled() + above);
    }
}

/// Scrolls an element to the top of what is in sight.
pub fn bring_to_top(id: &str) {
    if let Some(element) = by_id::<HtmlElement>(id) {
        element.scroll_into_view();
    }
}

/// Calls `react` whenever this happens in the window, as long as the page lives.
pub fn listen<E: JsCast + 'static>(event: &str, mut react: impl FnMut(&E) + 'static) {
    let closure = Closure::<dyn FnMut(Event)>::new(move |event: Event| react(event.unchecked_ref()));
    let _ = window().add_event_listener_with_callback(event, closure.as_ref().unchecked_ref());
    closure.forget();
}

/// Whether a media query matches now.
pub fn matches(query: &str) -> bool {
    window().match_media(query).ok().flatten().is_some_and(|list| list.matches())
}

/// Calls `react` with the answer whenever a media query's answer changes.
pub fn on_match_change(query: &str, react: impl FnMut() + 'static) {
    if let Ok(Some(list)) = window().match_media(query) {
        let closure = Closure::<dyn FnMut()>::new(react);
        list.set_onchange(Some(closure.as_ref().unchecked_ref()));
        // The page listens as long as it lives.
        closure.forget();
        std::mem::forget(list);
    }
}

/// A remembered text.
pub fn remembered(key: &str) -> Option<String> {
    window().local_storage().ok().flatten()?.get_item(&format!("meniscus:{key}")).ok().flatten()
}

/// The keys of remembered texts that begin like this.
pub fn remembered_keys(prefix: &str) -> Vec<String> {
    let Ok(Some(storage)) = window().local_storage() else { return Vec::new() };
    let read = |index: u32| {
        let key = storage.key(index).ok().flatten()?;
        Some(key.strip_prefix("meniscus:").filter(|own| own.starts_with(prefix))?.to_owned())
    };
    (0..storage.length().unwrap_or(0)).filter_map(read).collect()
}

/// All remembered texts whose keys begin like this, with their keys.
pub fn all_remembered(prefix: &str) -> Vec<(String, String)> {
    let keys = remembered_keys(prefix).into_iter();
    keys.filter_map(|key| remembered(&key).map(|text| (key, text))).collect()
}

/// Remembers a text for the next visit; forgets it when there is none. Whether the browser has taken it: it refuses where the
/// storage is full or forbidden.
pub fn remember(key: &str, text: &str) -> bool {
    let Ok(Some(storage)) = window().local_storage() else { return text.is_empty() };
    let key = format!("meniscus:{key}");
    if text.is_empty() { storage.remove_item(&key) } else { storage.set_item(&key, text) }.is_ok()
}

/// A text that is remembered as long as this tab of the browser is open, also while the page is loaded again.
pub fn remembered_in_tab(key: &str) -> Option<String> {
    window().session_storage().ok().flatten()?.get_item(&format!("meniscus:{key}")).ok().flatten()
}

/// Remembers a text as long as this tab of the browser is open, if the browser lets the page do so.
pub fn remember_in_tab(key: &str, text: &str) {
    if let Ok(Some(storage)) = window().session_storage() {
        let _ = storage.set_item(&format!("meniscus:{key}"), text);
    }
}

/// Forgets a remembered text.
pub fn forget(key: &str) {
    remember(key, "");
}

/// Lets the browser save a text as a file.
pub fn save_text(name: &str, kind: &str, text: &str) {
    save_bytes(name, kind, text.as_bytes());
}

/// Lets the browser save bytes as a file.
pub fn save_bytes(name: &str, kind: &str, bytes: &[u8]) {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let parts = Array::of1(&Uint8Array::from(bytes));
    if let Ok(blob) = Blob::new_with_u8_array_sequence_and_options(&parts, &options)
        && let Ok(url) = Url::create_object_url_with_blob(&blob)
    {
        save_url(name, &url);
        // The download has begun by the time the next task runs.
        let release = Closure::once_into_js(move || {
            let _ = Url::revoke_object_url(&url);
        });
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(release.unchecked_ref(), 10_000);
    }
}

/// Lets the browser save what an address of this page holds.
pub fn save_url(name: &str, url: &str) {
    if let Some(link) =
        document().create_element("a").ok().and_then(|element| element.dyn_into::<HtmlAnchorElement>().ok())
    {
        link.set_href(url);
        link.set_download(name);
        link.click();
    }
}

/// Copies a text to the clipboard and calls `done` with whether that was allowed.
pub fn copy(text: &str, done: impl FnOnce(bool) + 'static) {
    // Missing in frames and on hosts without https.
    let clipboard = Reflect::get(&window().navigator(), &"clipboard".into()).unwrap_or(JsValue::UNDEFINED);
    if clipboard.is_undefined() {
        return done(copy_by_selection(text));
    }
    let text = text.to_owned();
    let promise: Promise = window().navigator().clipboard().write_text(&text);
    wasm_bindgen_futures::spawn_local(async move {
        let allowed = wait(promise).await.is_ok();
        done(allowed || copy_by_selection(&text));
    });
}

/// The old way, which works where the clipboard is not offered.
fn copy_by_selection(text: &str) -> bool {
    let document = document();
    let focused = document.active_element().and_then(|element| element.dyn_into::<HtmlElement>().ok());
    let Some(area) =
        document.create_element("textarea").ok().and_then(|element| element.dyn_into::<HtmlTextAreaElement>().ok())
    else {
        return false;
    };
    area.set_value(text);
    let _ = area.set_attribute("style", "position:fixed;opacity:0");
    let Some(body) = document.body() else { return false };
    if body.append_child(&area).is_err() {
        return false;
    }
    area.select();
    let copied = Reflect::get(&document, &"execCommand".into())
        .ok()
        .and_then(|command| command.dyn_into::<Function>().ok())
        .and_then(|command| command.call1(&document, &"copy".into()).ok())
        .is_some_and(|answer| answer.is_truthy());
    area.remove();
    if let Some(element) = focused {
        let _ = element.focus();
    }
    copied
}

/// The outcome of a promise.
pub async fn wait(promise: Promise) -> Result<JsValue, JsValue> {
    wasm_bindgen_futures::JsFuture::from(promise).await
}

/// Lets the browser do what is waiting: draw, react to keys and pointers.
pub async fn breathe() {
    pause(0).await;
}

/// Waits so many milliseconds.
pub async fn pause(milliseconds: i32) {
    let promise = Promise::new(&mut |resolve, _| {
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, milliseconds);
    });
    let _ = wait(promise).await;
}

/// The fragment of the address, without `#`.
pub fn fragment() -> String {
    window().location().hash().unwrap_or_default().trim_start_matches('#').to_owned()
}

/// The address of this page with another fragment.
pub fn address(fragment: &str) -> String {
    let address = window().location().href().unwrap_or_default();
    let base = address.split('#').next().unwrap_or_default();
    if fragment.is_empty() { base.to_owned() } else { format!("{base}#{fragment}") }
}

/// Whether a fragment leads to a heading and not to a state.
pub fn is_heading(fragment: &str) -> bool {
    !fragment.contains(['&', '='])
}
