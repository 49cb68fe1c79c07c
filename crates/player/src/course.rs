//! Course that the page belongs to. The script of a course package (`class/src/course/course.js`) talks to the platform; this
//! side says what is sent, gives the script the state, and restores what is stored.
//!
//! The state is given in texts of which each leaves out more, for platforms with little room.

use crate::answers;
use crate::words::{self, Words};
use js_sys::{Array, Function, Promise, Reflect};
use play::{Answer, Extent, Grade, Play};
use program::Seat;
use std::cell::{Cell, RefCell};
use view::views::*;
use view::{App, browser};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlDialogElement;

/// Id of the dialog that says what is sent.
const ID: &str = "course";

/// Number of texts of the state, each with less than the one before.
const LEVELS: usize = 6;

/// The course, from the page's side.
pub struct Course {
    /// Object of the script in the package.
    script: JsValue,
    stage: Cell<Stage>,
    /// For each question, number of attempts reported, and whether its answer was shown.
    reported: RefCell<Vec<(usize, bool)>>,
}

/// Stage of the work with the course.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// The dialog is open.
    Asking,
    /// The session has begun.
    Begun,
    /// The page works without the course.
    Alone,
}

impl Course {
    /// The course of a page with the script of a package; `None` for other pages.
    pub fn of_page() -> Option<Self> {
        let script = Reflect::get(&js_sys::global(), &"course".into()).ok().filter(JsValue::is_object)?;
        Some(Self { script, stage: Cell::new(Stage::Asking), reported: RefCell::default() })
    }

    /// True if answers are stored in the browser: the course does not keep them.
    pub fn is_alone(&self) -> bool {
        self.stage.get() == Stage::Alone
    }

    /// True if the session has begun: the seat follows from the learner's id.
    pub fn has_begun(&self) -> bool {
        self.stage.get() == Stage::Begun
    }

    /// Dialog that says what is sent to the course. *Start* begins the session; closing it leaves the page without the course.
    pub fn dialog(&'static self, app: App) -> View {
        if self.stage.get() != Stage::Asking {
            return View::new();
        }
        let words = words::of(app);
        let host = Reflect::get(&self.script, &"host".into()).ok().and_then(|host| host.as_string());
        let host = host.filter(|host| !host.is_empty());
        let is_starting = create_signal(false);
        let start = move |_| {
            if !is_starting.get_untracked() {
                is_starting.set(true);
                self.start(app);
            }
        };
        let close = move |_| {
            if self.stage.get() == Stage::Asking && !is_starting.get_untracked() {
                self.leave(app);
            }
        };
        let mut dialog = view::views::dialog(ID, "course-title", words.course, words.course_look);
        let node: HtmlDialogElement = dialog.node();
        let look = node.clone();
        // Shown when it stands in the page.
        let show = Closure::once_into_js(move || drop(node.show_modal()));
        let _ = window().request_animation_frame(show.unchecked_ref());
        let busy = move || is_starting.get().then_some("true");
        let begin = button().class("primary").id("course-start").attr("aria-disabled", busy).child(words.course_start);
        let look = button().class("quiet outlined").when(events::click, move |_| look.close()).child(words.course_look);
        dialog
            .when(events::close, close)
            .child(
                div()
                    .class("publishing")
                    .child(note(words.course_sent))
                    .maybe(host.map(|host| note(format!("{} {host}.", words.course_host))))
                    .child(note(words.course_not_sent))
                    .child(div().class("ways").child(begin.when(events::click, start)).child(look)),
            )
            .into()
    }

    /// Begins the session; without a platform the page works alone.
    fn start(&'static self, app: App) {
        let page =
            Closure::<dyn FnMut(String, JsValue, JsValue) -> JsValue>::new(move |what: String, first, second| {
                self.answer(app, &what, &first, &second)
            });
        let begun = self.call("start", &Array::of1(page.as_ref()));
        // The script calls it as long as the page lives.
        page.forget();
        wasm_bindgen_futures::spawn_local(async move {
            let begun = match begun.and_then(|begun| begun.dyn_into::<Promise>().ok()) {
                Some(begun) => browser::wait(begun).await.ok(),
                None => None,
            };
            let words = words::of(app);
            match begun {
                None => {
                    self.leave(app);
                    app.complain(words.course_missing.to_owned());
                }
                Some(writes) if writes.is_truthy() => app.notify(words.course_started),
                Some(_) => app.notify(words.course_shown),
            }
            if let Some(dialog) = browser::by_id::<HtmlDialogElement>(ID) {
                dialog.close();
            }
        });
    }

    /// Goes on without the course.
    fn leave(&self, app: App) {
        self.stage.set(Stage::Alone);
        answers::restore(app);
        app.rebuild();
    }

    /// Tells the script of new attempts, and that there is something to keep.
    pub fn answers_changed(&self, app: App) {
        if self.stage.get() != Stage::Begun {
            return;
        }
        let before = self.reported.replace(app.read(|play| counts(play)));
        for (question, (now, _)) in self.reported.borrow().iter().enumerate() {
            let (known, _) = before.get(question).copied().unwrap_or_default();
            for number in known..*now {
                let Some(attempt) = app.read(|play| attempt(play, question, number)) else { continue };
                self.call("answered", &attempt);
            }
        }
        if *self.reported.borrow() != before {
            self.call("save", &Array::new());
        }
    }

    /// Calls a function of the script; `None` if it fails.
    fn call(&self, name: &str, arguments: &Array) -> Option<JsValue> {
        let function: Function = Reflect::get(&self.script, &name.into()).ok()?.dyn_into().ok()?;
        function.apply(&self.script, arguments).ok()
    }

    /// Answer to a request of the script.
    fn answer(&self, app: App, what: &str, first: &JsValue, second: &JsValue) -> JsValue {
        let words = words::of(app);
        let level = first.as_f64().map_or(0, |level| level as usize);
        match what {
            "state" if level < LEVELS => return app.read(|play| state(play, level)).into(),
            "score" => return app.read(|play| play.answers().score(play.basis())).unwrap_or(f64::NAN).into(),
            "done" => return app.read(|play| play.answers().are_complete()).into(),
            "restore" => self.restore(app, &first.as_string().unwrap_or_default(), second),
            "left" => {
                let left = app.read(|play| left_out(play, level, words)).join(", ");
                app.complain(format!("{} {left}. {}", words.course_left_out, words.course_way_out));
            }
            "cut" => app.complain(format!("{} {}", words.course_cut, words.course_way_out)),
            "refused" => {
                let what = first.as_string().unwrap_or_default();
                app.complain(format!("{} ({what}). {}", words.course_refused, words.course_way_out));
            }
            _ => {}
        }
        JsValue::UNDEFINED
    }

    /// Restores a stored state. The seat follows from the learner's id.
    fn restore(&self, app: App, text: &str, learner: &JsValue) {
        let learner = learner.as_string().unwrap_or_default();
        let (link, given) = text.split_once('#').unwrap_or((text, ""));
        let seat = |play: &mut Play| {
            let Some(seat) = play.basis().seat() else { return };
            let own = Seat::of_learner(&seat.assignment, &learner).number();
            if seat.number != Some(own) {
                let _ = play.set_seat(&own.to_string());
            }
        };
        app.read(seat);
        let refusal = if link.is_empty() { None } else { app.attempt(|play| play.restore(link)) };
        app.read(|play| {
            // A link has the seat that was set when it was made.
            seat(play);
            for (name, lines) in given.split('&').filter_map(|one| one.split_once('=')) {
                let lines = js_sys::decode_uri_component(lines).ok().and_then(|lines| lines.as_string());
                if let Some(answer) = lines.and_then(|lines| Answer::of_lines(&lines)) {
                    play.change_answers(|answers, run| answers.restore(run, name, &answer));
                }
            }
        });
        self.reported.replace(app.read(|play| counts(play)));
        self.stage.set(Stage::Begun);
        app.rebuild();
        if refusal.is_some() {
            app.complain(words::of(app).course_unread.to_owned());
        }
    }
}

/// Number of attempts at each question, and whether its answer was shown.
fn counts(play: &Play) -> Vec<(usize, bool)> {
    let answers = (0..play.program().questions.len()).map(|index| play.answers().answer(play.basis(), index));
    answers.map(|answer| (answer.attempts.len(), answer.shown.is_some())).collect()
}

/// An attempt as arguments of the script: id, type of the interaction, response, and result. The type is `choice` with letters, `numeric`
/// for a plain number in the unit that is asked for, or `fill-in`. The result is a word, or a share of the credit.
fn attempt(play: &Play, question: usize, number: usize) -> Option<Array> {
    let given = play.answers().answer(play.basis(), question).attempts.into_iter().nth(number)?;
    let (grade, typed) = (given.grade(), given.typed);
    let plain = play.answers().number(play.basis(), question, &typed).map(|number| number.to_string());
    let (kind, response) = match plain.filter(|text| is_plain(text)) {
        Some(number) => ("numeric", number),
        None if play.program().questions.get(question)?.number().is_some() => ("fill-in", typed),
        None if grade.is_attempt() => ("choice", typed.to_lowercase().replace(' ', "")),
        None => ("fill-in", typed),
    };
    let result = match grade {
        Grade::Correct => "correct".to_owned(),
        Grade::Partly(_) => grade.credit().to_string(),
        Grade::Unreadable | Grade::Unanswerable => "neutral".to_owned(),
        _ => "wrong".to_owned(),
    };
    let id = format!("q{}_{}", question + 1, number + 1);
    Some(Array::of4(&id.into(), &kind.into(), &response.into(), &result.into()))
}

/// True for a number with at most 5 digits before the point and 18 after it, as SCORM 2004 takes it.
fn is_plain(number: &str) -> bool {
    let (whole, fraction) =
        number.trim_start_matches('-').split_once('.').unwrap_or((number.trim_start_matches('-'), ""));
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    (1..=5).contains(&whole.len()) && fraction.len() <= 18 && digits(whole) && digits(fraction)
}

/// State as a text: link, `#`, answers. Each level leaves out more: the texts of earlier attempts, the kept runs, the changes on
/// the way, the texts of the answers, the whole link.
fn state(play: &Play, level: usize) -> String {
    let link = match level {
        0 | 1 => play.share(),
        2 => play.share_within(Extent::WithoutKept),
        3 | 4 => play.share_within(Extent::Moment),
        _ => String::new(),
    };
    let answers = play.answers().saved(play.basis()).into_iter().map(|(name, answer)| {
        let answer = if level > 0 { answer.without_texts(level > 3) } else { answer };
        format!("{name}={}", String::from(js_sys::encode_uri_component(&answer.lines())))
    });
    let answers: Vec<String> = answers.collect();
    if answers.is_empty() { link } else { format!("{link}#{}", answers.join("&")) }
}

/// Names of what a state of this level lacks.
fn left_out(play: &Play, level: usize, words: &Words) -> Vec<&'static str> {
    let names = [words.left_attempts, words.left_kept, words.left_changes, words.left_texts, words.left_values];
    let lacks = |level: &usize| state(play, *level) != state(play, level - 1);
    (1..=level).filter(lacks).filter_map(|level| names.get(level - 1).copied()).collect()
}
