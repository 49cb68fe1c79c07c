//! Messages of the browser between this page and a page around it, such as a notebook: `{ meniscus: { parameters: { b: 250 } } }`,
//! numbers in declared units, and words of choices. This page answers each message with all its values, and afterwards tells
//! each change, `{ meniscus: { run: { status, time } } }` whenever the run starts or stops (time in the unit of the independent
//! variable), and `{ meniscus: { answer: { question, typed, grade } } }` for each answer that is checked (questions from 1). A page
//! around it that says nothing hears nothing of them.

use js_sys::{Object, Reflect};
use play::{Play, Status};
use program::Parameter;
use std::cell::{Cell, RefCell};
use view::App;
use view::browser;
use view::views::{effect, window};
use wasm_bindgen::JsValue;
use web_sys::{MessageEvent, Window};

/// The page around this one.
pub struct Surrounding {
    window: Window,
    /// True once it has sent a message.
    is_asked: Cell<bool>,
    /// For each question, number of checked answers that it knows of.
    known: RefCell<Vec<usize>>,
}

/// Listens to the page around this one, if there is one. What it returns lives as long as the page.
pub fn follow(app: App) -> Option<&'static Surrounding> {
    // The window of a page that nothing surrounds is its own parent.
    let parent = window().parent().ok().flatten().filter(|parent| *parent != window())?;
    let known = RefCell::new(app.read(|play| counts(play)));
    let around: &'static Surrounding =
        Box::leak(Box::new(Surrounding { window: parent, is_asked: Cell::new(false), known }));
    browser::listen("message", move |event: &MessageEvent| {
        let wanted = part(&event.data(), "meniscus").and_then(|said| part(&said, "parameters"));
        let is_parent = event.source().is_some_and(|source| Object::is(&source, &around.window));
        let Some(wanted) = wanted.filter(|_| is_parent) else { return };
        set(app, &wanted);
        tell(app, &around.window);
        if !around.is_asked.replace(true) {
            around.tell_run(app);
        }
    });
    effect(move || {
        app.changes.parameters.track();
        if around.is_asked.get() {
            tell(app, &around.window);
        }
    });
    let told = Cell::new(None);
    effect(move || {
        app.changes.transport.track();
        let status = app.read(|play| Some(play.time_line().status()));
        if told.replace(status) != status && around.is_asked.get() {
            around.tell_run(app);
        }
    });
    Some(around)
}

impl Surrounding {
    /// Sends status and time of the run.
    fn tell_run(&self, app: App) {
        let run = app.read(|play| {
            let status = match play.time_line().status() {
                Status::Paused => "paused",
                Status::Playing => "playing",
                Status::Full => "full",
                Status::Failed => "failed",
                Status::Ended => "ended",
            };
            let time = play.model().independent.unit.from_si(play.course().time());
            object(&[("status", status.into()), ("time", time.into())])
        });
        say(&self.window, "run", &run);
    }

    /// Sends the answers that have been checked since the last call.
    pub fn answers_changed(&self, app: App) {
        let now = app.read(|play| counts(play));
        let before = self.known.replace(now.clone());
        if !self.is_asked.get() {
            return;
        }
        for (question, count) in now.into_iter().enumerate() {
            let known = before.get(question).copied().unwrap_or_default();
            for number in known..count {
                say(&self.window, "answer", &app.read(|play| answer(play, question, number)));
            }
        }
    }
}

/// Number of checked answers to each question.
fn counts(play: &Play) -> Vec<usize> {
    let questions = 0..play.program().questions.len();
    questions.map(|question| play.answers().answer(play.basis(), question).attempts.len()).collect()
}

/// A checked answer.
fn answer(play: &Play, question: usize, number: usize) -> Object {
    let attempts = play.answers().answer(play.basis(), question).attempts;
    let (typed, grade) =
        attempts.get(number).map_or_else(Default::default, |attempt| (attempt.typed.clone(), attempt.grade().code()));
    let question = JsValue::from((question + 1) as f64);
    object(&[("question", question), ("typed", typed.into()), ("grade", grade.as_ref().into())])
}

/// Object with these members.
fn object(members: &[(&str, JsValue)]) -> Object {
    let object = Object::new();
    for (name, value) in members {
        let _ = Reflect::set(&object, &(*name).into(), value);
    }
    object
}

/// Member of an object that is an object itself.
fn part(value: &JsValue, name: &str) -> Option<JsValue> {
    Reflect::get(value, &name.into()).ok().filter(JsValue::is_object)
}

/// Sets the parameters that have a number or a word among these members. A refusal is shown in the page.
fn set(app: App, wanted: &JsValue) {
    let values: Vec<(usize, f64)> = app.read(|play| {
        let model = play.model();
        let value = |(index, parameter): (usize, &Parameter)| {
            let value = Reflect::get(wanted, &parameter.name.as_str().into()).ok()?;
            let value = match value.as_string() {
                Some(word) => parameter.chosen(&word, &model.texts),
                None => value.as_f64().map(|number| parameter.unit.to_si(number)),
            };
            value.map(|value| (index, value))
        };
        let shown = model.parameters.iter().enumerate().filter(|(_, parameter)| parameter.is_shown());
        shown.filter_map(value).collect()
    });
    for (index, value) in values {
        let set = app.attempt(|play| play.change_settings(|settings| settings.set_parameter(index, value)));
        if let Some(refusal) = set {
            app.complain(refusal);
        }
    }
}

/// Sends the values of all parameters.
fn tell(app: App, parent: &Window) {
    let values = Object::new();
    app.read(|play| {
        let model = play.model();
        let all = model.parameters.iter().zip(play.course().parameters());
        for (parameter, value) in all.filter(|(parameter, _)| parameter.is_shown()) {
            let value = match parameter.word(*value, &model.texts) {
                Some(word) => word.into(),
                None => parameter.unit.from_si(*value).into(),
            };
            let _ = Reflect::set(&values, &parameter.name.as_str().into(), &value);
        }
    });
    say(parent, "parameters", &values);
}

/// Sends `{ meniscus: { name: value } }` to a page around this one, whoever it is: nothing in it may be confidential.
pub fn say(parent: &Window, name: &str, value: &JsValue) {
    let said = object(&[(name, value.clone())]);
    let _ = parent.post_message(&object(&[("meniscus", said.into())]), "*");
}
