//! Form of the virtual camera, and progress of the filming.

use super::drawing::pixels;
use super::ruler::Ruler;
use super::shooting;
use crate::app::App;
use crate::film::words;
use desk::{CameraSettings, FilmRecipe};
use units::number::plain;
use units::number::typed::{NotRead, counted, quantity, whole};
use units::{Language, Unit};
use view::views::*;
use view::{browser, pieces::icons};

/// Button that opens the form, and one button for each film of this simulation with stored work.
pub fn button(app: App) -> View {
    let words = words::of(app);
    let open = move |_| {
        let refusal = app.read_desk(|desk| desk.films().usual_camera().err().map(|why| why.text(desk.play())));
        match refusal {
            Some(why) => app.complain(why),
            None => {
                let shown = !app.films.camera_form.get_untracked();
                app.films.camera_form.set(shown);
                if shown {
                    browser::focus_later("filming-seconds".to_owned());
                }
            }
        }
    };
    let button = view::views::button()
        .class("quiet with-icon")
        .id("film-simulation")
        .attr("aria-expanded", move || app.films.camera_form.get().to_string())
        .when(events::click, open)
        .child(icons::camera())
        .child(span().child(words.film_simulation));
    let kept = memo(move || {
        app.films.now.track();
        app.read_desk(|desk| desk.films().recipes())
    });
    let again = move |(number, recipe): (usize, FilmRecipe)| {
        let id = format!("film-again-{number}");
        let name = format!("{}: {}", words.film_again, described(app, &recipe.settings));
        let film = move |_| shooting::film(app, recipe.clone());
        view::views::button()
            .class("quiet with-icon")
            .id(id)
            .when(events::click, film)
            .child(icons::film())
            .child(span().child(name))
    };
    View::from((button, changing(move || each(kept.get_clone().into_iter().enumerate(), again))))
}

/// Short description, such as `10 s, 30/s`.
fn described(app: App, settings: &CameraSettings) -> String {
    let style = app.language.get_untracked().style();
    format!("{} s, {}/s", plain(settings.seconds, 4, style), plain(settings.rate, 4, style))
}

/// Form, or progress of the filming.
pub fn view(app: App) -> View {
    let filming = memo(move || app.films.filming.with(Option::is_some));
    changing(move || match (filming.get(), app.films.camera_form.get()) {
        (true, _) => progress(app),
        (false, true) => form(app),
        (false, false) => View::new(),
    })
}

/// Text of a number field, and the reason for which it was refused.
#[derive(Clone, Copy)]
struct Typed {
    text: Signal<String>,
    refused: Signal<Option<String>>,
}

impl Typed {
    /// The number read by `read`; `None` if the text is refused, which is then shown at the field.
    fn read<T>(self, language: Language, read: impl FnOnce(&str) -> Result<T, NotRead>) -> Option<T> {
        let found = self.text.with_untracked(|text| read(text));
        self.refused.set(found.as_ref().err().map(|why| why.words().text(language).into_owned()));
        found.ok()
    }
}

fn form(app: App) -> View {
    let words = words::of(app);
    let style = app.language.get_untracked().style();
    let Some(usual) = app.read_desk(|desk| desk.films().usual_camera().ok()) else { return View::new() };
    let typed = |value: f64| Typed { text: create_signal(plain(value, 4, style)), refused: create_signal(None) };
    let (seconds, rate, exposure) = (typed(usual.seconds), typed(usual.rate), typed(1e3 * usual.exposure));
    let (noise, seed) = (typed(usual.noise), typed(f64::from(usual.seed)));
    let field = |id: &'static str, name: &'static str, Typed { text, refused }: Typed, unit: &'static str| {
        let field = number_field(id, refused)
            .attr("inputmode", "decimal")
            .prop("value", move || text.get_clone())
            .when(events::input, move |event| text.set(value_of(&event)));
        View::from((field_of(id, name).child(with_unit(field, unit)), why_refused(id, refused)))
    };
    let ruler = app.read(|play| pixels(play).and_then(|pixels| Ruler::of(play, pixels))).map(|ruler| ruler.length);
    let known = match ruler {
        Some(length) => format!("{} {length}.", words.filming_ruler),
        None => words.filming_no_ruler.to_owned(),
    };
    let start = move |_| {
        let language = app.language.get_untracked();
        let quantity = |typed: Typed, unit: &str| {
            let unit = Unit::parse(unit).unwrap_or_else(|_| Unit::dimensionless());
            typed.read(language, |text| quantity(text, &unit, style))
        };
        // All fields are read, so that each one shows its own refusal.
        let numbers = (
            quantity(seconds, "s"),
            quantity(rate, "1/s"),
            quantity(exposure, "ms"),
            noise.read(language, |text| counted(text, "/ 255", style)),
            seed.read(language, |text| whole(text, 0..=i64::from(u32::MAX), style)),
        );
        let (Some(seconds), Some(rate), Some(exposure), Some(noise), Some(seed)) = numbers else { return };
        let seed = u32::try_from(seed).unwrap_or_default();
        let settings = CameraSettings { seconds, rate, exposure, noise, seed };
        let recipe = app.with(|lab| {
            let desk = lab.desk.as_ref()?;
            Some(desk.films().recipe(settings).map_err(|why| why.text(desk.play())))
        });
        match recipe.flatten() {
            Some(Ok(recipe)) => {
                app.films.camera_form.set(false);
                shooting::film(app, recipe);
                browser::focus_later("cancel-filming".to_owned());
            }
            Some(Err(why)) => app.complain(why),
            None => {}
        }
    };
    let leave = move |_| {
        app.films.camera_form.set(false);
        browser::focus("film-simulation");
    };
    let buttons = div()
        .class("intake")
        .child(
            view::views::button()
                .class("primary")
                .id("start-filming")
                .when(events::click, start)
                .child(words.start_filming),
        )
        .child(view::views::button().class("quiet").when(events::click, leave).child(words.cancel));
    section()
        .class("card step filming")
        .id("filming")
        .attr("aria-label", words.film_simulation)
        .child(h3().child(words.film_simulation))
        .child(note(words.filming_note))
        .child(
            div()
                .class("fields")
                .child(field("filming-seconds", words.filming_seconds, seconds, "s"))
                .child(field("filming-rate", words.filming_rate, rate, "1/s"))
                .child(field("filming-exposure", words.filming_exposure, exposure, "ms"))
                .child(field("filming-noise", words.filming_noise, noise, "/ 255"))
                .child(field("filming-seed", words.filming_seed, seed, "")),
        )
        .child(note(known).id("filming-ruler"))
        .child(buttons)
        .into()
}

fn progress(app: App) -> View {
    let words = words::of(app);
    let now = move || app.films.filming.get().unwrap_or_default();
    let part = move || {
        let [taken, of] = now();
        (100 * taken).checked_div(of).map(|part| part.to_string())
    };
    let said = move || {
        let [taken, of] = now();
        format!("{}: {} {taken} / {of}", words.filming, words.frame)
    };
    let cancel = move |_| {
        app.films.filming.set(None);
        browser::focus_later("film-simulation".to_owned());
    };
    div()
        .class("intake")
        .child(tags::progress().attr("aria-label", words.filming).max("100").value(part))
        .child(span().class("note").child(text(said)))
        .child(
            view::views::button().class("quiet").id("cancel-filming").when(events::click, cancel).child(words.cancel),
        )
        .into()
}
