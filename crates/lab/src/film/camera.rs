//! Recording of a film by the camera of the device, if the browser allows it.

use super::access::object;
use super::{opening, words};
use crate::app::App;
use js_sys::{Array, Promise, Reflect};
use std::cell::RefCell;
use std::rc::Rc;
use view::views::*;
use view::{browser, pieces::icons};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{File, HtmlElement};

#[wasm_bindgen]
extern "C" {
    /// `navigator.mediaDevices`.
    type MediaDevices;

    #[wasm_bindgen(method, catch, js_name = getUserMedia)]
    fn get_user_media(this: &MediaDevices, wanted: &JsValue) -> Result<Promise, JsValue>;

    type MediaStream;

    #[wasm_bindgen(method, js_name = getTracks)]
    fn get_tracks(this: &MediaStream) -> Array;

    type MediaTrack;

    #[wasm_bindgen(method)]
    fn stop(this: &MediaTrack);

    type MediaRecorder;

    #[wasm_bindgen(constructor, catch)]
    fn new(stream: &MediaStream) -> Result<MediaRecorder, JsValue>;

    #[wasm_bindgen(method, catch)]
    fn start(this: &MediaRecorder) -> Result<(), JsValue>;

    #[wasm_bindgen(method, catch, js_name = stop)]
    fn finish(this: &MediaRecorder) -> Result<(), JsValue>;

    #[wasm_bindgen(method, setter)]
    fn set_ondataavailable(this: &MediaRecorder, react: &js_sys::Function);

    type DataEvent;

    #[wasm_bindgen(method, getter)]
    fn data(this: &DataEvent) -> web_sys::Blob;
}

/// Recording in progress.
struct Filming {
    stream: MediaStream,
    recorder: MediaRecorder,
    _taken: Closure<dyn FnMut(DataEvent)>,
}

impl Drop for Filming {
    fn drop(&mut self) {
        self.stream.get_tracks().iter().for_each(|track| track.unchecked_into::<MediaTrack>().stop());
    }
}

fn devices() -> Option<MediaDevices> {
    let devices = Reflect::get(&window().navigator(), &"mediaDevices".into()).ok()?;
    let recorder = Reflect::has(&js_sys::global(), &"MediaRecorder".into()).unwrap_or_default();
    (recorder && devices.is_truthy()).then(|| devices.unchecked_into())
}

/// Button that starts and stops a recording; empty if the browser offers no camera.
pub fn button(app: App) -> View {
    if devices().is_none() {
        return View::new();
    }
    let words = words::of(app);
    let filming: Rc<RefCell<Option<Filming>>> = Rc::default();
    let on = create_signal(false);
    let mut video = tags::video().class("film-camera").attr("aria-label", words.camera_picture);
    let screen: HtmlElement = video.node();
    let turn = move |_| {
        let now = filming.borrow_mut().take();
        if let Some(now) = now {
            // The film is delivered before the camera is released.
            let _ = now.recorder.finish();
            *filming.borrow_mut() = Some(now);
            return;
        }
        let (filming, screen) = (filming.clone(), screen.clone());
        wasm_bindgen_futures::spawn_local(async move {
            let began = begin(app, filming.clone(), &screen, on).await;
            if began.is_none() {
                app.complain(words.no_camera.to_owned());
            }
        });
    };
    let name = move || if on.get() { words.stop_recording } else { words.record_film };
    View::from((
        view::views::button()
            .class("quiet with-icon")
            .id("record-film")
            .attr("aria-pressed", move || on.get().to_string())
            .when(events::click, turn)
            .child(icons::camera())
            .child(span().child(text(move || name().to_owned()))),
        div().class("film-camera-place").hidden(move || !on.get()).child(video),
    ))
}

async fn begin(app: App, filming: Rc<RefCell<Option<Filming>>>, screen: &HtmlElement, on: Signal<bool>) -> Option<()> {
    let back = object(&[("facingMode", "environment".into()), ("frameRate", object(&[("ideal", 60.into())]))]);
    let wanted = object(&[("video", back), ("audio", false.into())]);
    let stream: MediaStream = browser::wait(devices()?.get_user_media(&wanted).ok()?).await.ok()?.unchecked_into();
    let recorder = MediaRecorder::new(&stream).ok()?;
    let place = filming.clone();
    let shown = screen.clone();
    let taken = Closure::<dyn FnMut(DataEvent)>::new(move |event: DataEvent| {
        let blob = event.data();
        let kind = blob.type_();
        let ending = if kind.contains("mp4") { "mp4" } else { "webm" };
        let now = js_sys::Date::new_0().to_iso_string().as_string().unwrap_or_default();
        let name = format!("film-{}.{ending}", now.get(..19).unwrap_or_default().replace(':', "-"));
        let options = web_sys::FilePropertyBag::new();
        options.set_type(&kind);
        let file = File::new_with_blob_sequence_and_options(&Array::of1(&blob), &name, &options);
        let _ = Reflect::set(&shown, &"srcObject".into(), &JsValue::NULL);
        on.set(false);
        let place = place.clone();
        wasm_bindgen_futures::spawn_local(async move {
            // A callback must not drop itself.
            browser::breathe().await;
            drop(place.borrow_mut().take());
        });
        if let Ok(file) = file {
            opening::open(app, file);
        }
    });
    recorder.set_ondataavailable(taken.as_ref().unchecked_ref());
    let _ = Reflect::set(screen, &"srcObject".into(), stream.as_ref());
    let _ = Reflect::set(screen, &"muted".into(), &true.into());
    if let Ok(play) = Reflect::get(screen, &"play".into()).and_then(|play| play.dyn_into::<js_sys::Function>()) {
        let _ = play.call0(screen);
    }
    recorder.start().ok()?;
    *filming.borrow_mut() = Some(Filming { stream, recorder, _taken: taken });
    on.set(true);
    Some(())
}
