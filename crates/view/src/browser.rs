//! Browser functions that may fail: storage, clipboard, files. A refusal is returned and never causes a panic. Pages
//! opened from `file://`, in private mode or in a frame are refused many of these functions.
//!
//! What stays on the main thread and takes long is divided into tasks of the browser ([`breathe`]): in the laboratory the
//! theories of a ranking (`fit/starting.rs`), the comparison of periods (`fit/theories.rs`), files of records
//! (`measuring/intake.rs`), a dropped document (`documents/opening.rs`). After each pause the work looks whether it is still
//! wanted: by a number or question that the last wish has set, and `is_alive` for the signals of its views.
//! `tests/page/measuring/long-tasks.mjs` measures the tasks.

use crate::views::{document, window};
use js_sys::{Array, Function, Promise, Reflect, Uint8Array};
use std::cell::Cell;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{
    AbortController, AddEventListenerOptions, Blob, BlobPropertyBag, Event, EventTarget, FocusOptions,
    HtmlAnchorElement, HtmlElement, HtmlTextAreaElement, ScrollBehavior, ScrollToOptions, Url,
};

/// Element with this id, if it is of type `T`.
pub fn by_id<T: JsCast>(id: &str) -> Option<T> {
    document().get_element_by_id(id)?.dyn_into().ok()
}

/// Id of the focused element; empty if there is none.
pub fn focused() -> String {
    document().active_element().map(|element| element.id()).unwrap_or_default()
}

/// Moves the focus to an element, and opens the folds around it: nothing in a closed one takes the focus.
pub fn focus(id: &str) {
    if let Some(element) = by_id::<HtmlElement>(id) {
        while let Ok(Some(fold)) = element.closest("details:not([open])") {
            let _ = fold.set_attribute("open", "");
        }
        let _ = element.focus();
    }
}

/// Moves the focus to an element in the next frame, after the views have been rebuilt.
pub fn focus_later(id: String) {
    let focus = Closure::once_into_js(move || focus(&id));
    let _ = window().request_animation_frame(focus.unchecked_ref());
}

/// Moves the focus to an element in the next frame if the focused element no longer exists.
pub fn keep_focus_later(id: String) {
    let keep = Closure::once_into_js(move || {
        let active = document().active_element();
        if active.is_none_or(|active| active.tag_name() == "BODY") {
            focus(&id);
        }
    });
    let _ = window().request_animation_frame(keep.unchecked_ref());
}

/// Moves the focus to an element without scrolling, to replace a focused element that was removed.
pub fn focus_in_place(id: &str) {
    let options = FocusOptions::new();
    options.set_prevent_scroll(true);
    if let Some(element) = by_id::<HtmlElement>(id) {
        let _ = element.focus_with_options(&options);
    }
}

/// In the next frame, scrolls to an element and focuses it.
pub fn reveal_later(id: String) {
    let reveal = Closure::once_into_js(move || {
        if let Some(element) = by_id::<HtmlElement>(&id) {
            element.scroll_into_view();
            focus_in_place(&id);
        }
    });
    let _ = window().request_animation_frame(reveal.unchecked_ref());
}

/// Vertical scroll position of the page, in CSS pixels.
pub fn scrolled() -> f64 {
    window().scroll_y().unwrap_or(0.0)
}

/// Distance of an element from the top of the window, in CSS pixels.
pub fn top_of(id: &str) -> Option<f64> {
    by_id::<HtmlElement>(id).map(|element| element.get_bounding_client_rect().top())
}

/// Scrolls the page to a vertical position in CSS pixels, without animation.
pub fn scroll_to(place: f64) {
    let options = ScrollToOptions::new();
    options.set_top(place);
    options.set_behavior(ScrollBehavior::Instant);
    window().scroll_to_with_scroll_to_options(&options);
}

/// An element that begins below this fraction of the window height is considered out of sight.
const LOW: f64 = 0.6;

/// Scrolls to the top of an element, without animation, if it begins above the window or so low that little of it is
/// visible.
pub fn bring_into_sight(id: &str) {
    let Some(element) = by_id::<HtmlElement>(id) else { return };
    // The scroll margin is the height of the content that sticks to the top of the window.
    let margin = window().get_computed_style(&element).ok().flatten();
    let margin = margin.and_then(|style| style.get_property_value("scroll-margin-top").ok());
    let margin = margin.and_then(|margin| units::number::decimal(margin.trim_end_matches("px"))).unwrap_or(0.0);
    let top = element.get_bounding_client_rect().top();
    let above = top - margin;
    let height = window().inner_height().ok().and_then(|height| height.as_f64()).unwrap_or(f64::INFINITY);
    if above < 0.0 || top > LOW * height {
        scroll_to(scrolled() + above);
    }
}

/// Scrolls an element to the top of the visible area.
pub fn bring_to_top(id: &str) {
    if let Some(element) = by_id::<HtmlElement>(id) {
        element.scroll_into_view();
    }
}

thread_local! {
    /// Ends the listeners of [`listen`] and [`on_match_change`]; `None` if the browser does not have it.
    static LISTENING: Option<AbortController> = AbortController::new().ok();
}

/// Calls `react` for every event of this type in the window, until [`end_listening`].
pub fn listen<E: JsCast + 'static>(event: &str, mut react: impl FnMut(&E) + 'static) {
    listen_to(&window(), event, Closure::new(move |event: Event| react(event.unchecked_ref())));
}

fn listen_to(target: &EventTarget, event: &str, closure: Closure<dyn FnMut(Event)>) {
    let options = AddEventListenerOptions::new();
    LISTENING.with(|listening| {
        if let Some(listening) = listening {
            options.set_signal(&listening.signal());
        }
    });
    let listener = closure.as_ref().unchecked_ref();
    let _ = target.add_event_listener_with_callback_and_add_event_listener_options(event, listener, &options);
    closure.forget();
}

/// Removes the listeners of [`listen`] and [`on_match_change`].
pub fn end_listening() {
    LISTENING.with(|listening| {
        if let Some(listening) = listening {
            listening.abort();
        }
    });
}

/// True if a media query matches now.
pub fn matches(query: &str) -> bool {
    window().match_media(query).ok().flatten().is_some_and(|list| list.matches())
}

/// Calls `react` whenever the result of a media query changes, until [`end_listening`].
pub fn on_match_change(query: &str, mut react: impl FnMut() + 'static) {
    if let Ok(Some(list)) = window().match_media(query) {
        listen_to(&list, "change", Closure::new(move |_| react()));
        // The list lives as long as the page.
        std::mem::forget(list);
    }
}

/// Stored text; `None` if there is none.
pub fn remembered(key: &str) -> Option<String> {
    window().local_storage().ok().flatten()?.get_item(&format!("meniscus:{key}")).ok().flatten()
}

/// Keys of stored texts with this prefix.
pub fn remembered_keys(prefix: &str) -> Vec<String> {
    let Ok(Some(storage)) = window().local_storage() else { return Vec::new() };
    let read = |index: u32| {
        let key = storage.key(index).ok().flatten()?;
        Some(key.strip_prefix("meniscus:").filter(|own| own.starts_with(prefix))?.to_owned())
    };
    (0..storage.length().unwrap_or(0)).filter_map(read).collect()
}

/// Stored texts with this key prefix: (key, text).
pub fn all_remembered(prefix: &str) -> Vec<(String, String)> {
    let keys = remembered_keys(prefix).into_iter();
    keys.filter_map(|key| remembered(&key).map(|text| (key, text))).collect()
}

thread_local! {
    /// True once the page stores nothing more.
    static HAS_ENDED: Cell<bool> = const { Cell::new(false) };
}

/// From now on the page stores nothing: somebody leaves a computer that others use.
pub fn end_remembering() {
    HAS_ENDED.set(true);
}

/// Stores a text for the next visit; an empty text removes the entry. Returns false if the storage is full or
/// forbidden.
pub fn remember(key: &str, text: &str) -> bool {
    if HAS_ENDED.get() {
        return true;
    }
    let Ok(Some(storage)) = window().local_storage() else { return text.is_empty() };
    let key = format!("meniscus:{key}");
    if text.is_empty() { storage.remove_item(&key) } else { storage.set_item(&key, text) }.is_ok()
}

/// Text stored for this browser tab; it survives a reload of the page.
pub fn remembered_in_tab(key: &str) -> Option<String> {
    window().session_storage().ok().flatten()?.get_item(&format!("meniscus:{key}")).ok().flatten()
}

/// Stores a text for this browser tab, if the browser allows it.
pub fn remember_in_tab(key: &str, text: &str) {
    if let Ok(Some(storage)) = window().session_storage() {
        let _ = storage.set_item(&format!("meniscus:{key}"), text);
    }
}

/// Removes a stored text.
pub fn forget(key: &str) {
    remember(key, "");
}

/// Saves a text as a file through the browser; `kind` is the media type.
pub fn save_text(name: &str, kind: &str, text: &str) {
    save_bytes(name, kind, text.as_bytes());
}

/// Saves bytes as a file through the browser; `kind` is the media type.
pub fn save_bytes(name: &str, kind: &str, bytes: &[u8]) {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    let parts = Array::of1(&Uint8Array::from(bytes));
    if let Ok(blob) = Blob::new_with_u8_array_sequence_and_options(&parts, &options)
        && let Ok(url) = Url::create_object_url_with_blob(&blob)
    {
        save_url(name, &url);
        // The download needs the address for a while after the click.
        let release = Closure::once_into_js(move || {
            let _ = Url::revoke_object_url(&url);
        });
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(release.unchecked_ref(), 10_000);
    }
}

/// Saves the content of an address of this page as a file.
pub fn save_url(name: &str, url: &str) {
    if let Some(link) =
        document().create_element("a").ok().and_then(|element| element.dyn_into::<HtmlAnchorElement>().ok())
    {
        link.set_href(url);
        link.set_download(name);
        link.click();
    }
}

/// Copies a text to the clipboard and calls `done` with true if that was allowed.
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

/// Fallback for browsers without clipboard access. Returns true on success.
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

/// Awaits a promise.
pub async fn wait(promise: Promise) -> Result<JsValue, JsValue> {
    wasm_bindgen_futures::JsFuture::from(promise).await
}

/// Yields to the browser: drawing, keys and pointers.
pub async fn breathe() {
    pause(0).await;
}

/// Waits for this number of milliseconds.
pub async fn pause(milliseconds: i32) {
    let promise = Promise::new(&mut |resolve, _| {
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, milliseconds);
    });
    let _ = wait(promise).await;
}

/// Fragment of the address, without `#`.
pub fn fragment() -> String {
    window().location().hash().unwrap_or_default().trim_start_matches('#').to_owned()
}

/// Address of this page with another fragment.
pub fn address(fragment: &str) -> String {
    let address = window().location().href().unwrap_or_default();
    let base = address.split('#').next().unwrap_or_default();
    if fragment.is_empty() { base.to_owned() } else { format!("{base}#{fragment}") }
}

/// Replaces the address in the present history entry, if the browser allows it.
pub fn replace_address(address: &str) {
    if let Ok(history) = window().history() {
        let state = history.state().unwrap_or(JsValue::NULL);
        let _ = history.replace_state_with_url(&state, "", Some(address));
    }
}

/// True if a fragment is empty or the id of a heading, and not a state; `1` is the shortest state.
pub fn is_heading(fragment: &str) -> bool {
    !fragment.contains(['&', '=']) && fragment != "1"
}
