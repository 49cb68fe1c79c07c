//! The editor: CodeMirror, which the page carries as a deflated script (`crates/lab/editor`) and starts when it is first needed. In
//! a site the script is a file of its own. Places in a text are counted in UTF-16, as browsers do.

use crate::carried;
use desk::document::assist::{Suggestion, SuggestionKind};
use desk::{Mark, Proposals, TextChange};
use js_sys::{Array, Function, Object, Reflect};
use model::Severity;
use units::Language;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::Element;

/// What the script calls itself.
const MAKER: &str = "meniscusEditor";

/// The editor, as long as the page is open. A call of a method that fails is ignored: the script is the page's own.
#[derive(Clone)]
pub struct Editor(JsValue);

impl Editor {
    /// Starts the editor. `changed` is called with the number of a text and the text when its writer rests, `propose` with the text
    /// shown and a place in it, `moved` with them when the cursor has come to rest.
    pub async fn start(
        mut changed: impl FnMut(usize, String) + 'static,
        propose: impl Fn(String, usize) -> (Proposals, Language) + 'static,
        mut moved: impl FnMut(String, usize) + 'static,
    ) -> Option<Self> {
        load().await?;
        let maker: Function = Reflect::get(&js_sys::global(), &MAKER.into()).ok()?.dyn_into().ok()?;
        let changed = Closure::<dyn FnMut(f64, String)>::new(move |file: f64, text| changed(file as usize, text));
        let propose = Closure::<dyn Fn(String, f64) -> JsValue>::new(move |text, place: f64| {
            let (proposals, language) = propose(text, place as usize);
            proposed(&proposals, language)
        });
        let moved = Closure::<dyn FnMut(String, f64)>::new(move |text, place: f64| moved(text, place as usize));
        let editor = maker.call3(&JsValue::UNDEFINED, changed.as_ref(), propose.as_ref(), moved.as_ref()).ok()?;
        // They are called as long as the page is open.
        changed.forget();
        propose.forget();
        moved.forget();
        Some(Self(editor))
    }

    fn call(&self, method: &str, arguments: &[JsValue]) -> JsValue {
        let method = Reflect::get(&self.0, &method.into()).ok().and_then(|method| method.dyn_into::<Function>().ok());
        let answer = method.and_then(|method| method.apply(&self.0, &arguments.iter().collect::<Array>()).ok());
        answer.unwrap_or_default()
    }

    /// Puts the editor into an element.
    pub fn mount(&self, place: &Element) {
        let dom = Reflect::get(&self.0, &"dom".into()).ok().and_then(|dom| dom.dyn_into::<Element>().ok());
        if let Some(dom) = dom {
            let _ = place.append_child(&dom);
        }
    }

    /// Opens other texts and shows the first.
    pub fn open(&self, texts: &[String]) {
        self.call("open", &[texts.iter().map(JsValue::from).collect::<Array>().into()]);
    }

    /// Opens one more text beside the others, which keep what can be undone in them.
    pub fn add(&self, text: &str) {
        self.call("add", &[text.into()]);
    }

    /// Shows another text.
    pub fn select(&self, file: usize) {
        self.call("select", &[(file as f64).into()]);
    }

    /// Names the text for screen readers, and chooses the language of the editor's own words.
    pub fn speak(&self, label: &str, language: Language) {
        self.call("speak", &[label.into(), language.tag().into()]);
    }

    /// Marks what was found in the text shown.
    pub fn mark(&self, marks: &[Mark], language: Language) {
        let mark = |mark: &Mark| {
            let severity = if mark.severity == Severity::Error { "error" } else { "warning" };
            let sentences: Vec<&str> =
                std::iter::once(&mark.message).chain(&mark.remedies).map(|words| words.text(language)).collect();
            object([
                ("from", (mark.from as f64).into()),
                ("to", (mark.to as f64).into()),
                ("severity", severity.into()),
                ("message", sentences.join("\n").into()),
            ])
        };
        self.call("mark", &[marks.iter().map(mark).collect::<Array>().into()]);
    }

    /// Changes the text shown, unless it has changed since it was checked.
    pub fn change(&self, changes: &[TextChange]) {
        self.call("change", &[described(changes)]);
    }

    /// A text as it stands, also where it has not been checked.
    pub fn text(&self, file: usize) -> String {
        self.call("text", &[(file as f64).into()]).as_string().unwrap_or_default()
    }

    /// Changes a text that need not be the one shown; the focus stays where it is. What is typed joins with what was typed just before
    /// into one step of the history; anything else is a step of its own.
    pub fn edit(&self, file: usize, changes: &[TextChange], is_typed: bool) {
        self.call("edit", &[(file as f64).into(), described(changes), is_typed.into()]);
    }

    /// Takes back the last change of a text, or makes again what was taken back, and has the text checked.
    pub fn undo(&self, file: usize, forwards: bool) {
        self.call("undo", &[(file as f64).into(), forwards.into()]);
    }

    /// Measures the text again, which was out of sight.
    pub fn measure(&self) {
        self.call("measure", &[]);
    }

    /// Takes another text for a file, as a step that can be undone. It is not told as a change of the writer's.
    pub fn take(&self, file: usize, text: &str) {
        self.call("take", &[(file as f64).into(), text.into()]);
    }

    /// Goes to a place in the text shown.
    pub fn go(&self, place: usize) {
        self.call("go", &[(place as f64).into(), (place as f64).into()]);
    }

    /// Moves the focus into the text.
    pub fn focus(&self) {
        self.call("focus", &[]);
    }

    /// Has a change checked now that is waiting for its writer to rest.
    pub fn flush(&self) {
        self.call("flush", &[]);
    }
}

/// Changes as the editor takes them: `[{ from, to, insert }]`.
fn described(changes: &[TextChange]) -> JsValue {
    let change = |change: &TextChange| {
        object([
            ("from", (change.from as f64).into()),
            ("to", (change.to as f64).into()),
            ("insert", change.text.as_str().into()),
        ])
    };
    changes.iter().map(change).collect::<Array>().into()
}

/// Proposals as the editor takes them: `{ from, options: [{ label, type, detail }] }`.
fn proposed(proposals: &Proposals, language: Language) -> JsValue {
    let option = |suggestion: &Suggestion| {
        let kind = match suggestion.kind {
            SuggestionKind::Word => "keyword",
            SuggestionKind::Name => "variable",
            SuggestionKind::Function => "function",
            SuggestionKind::Unit => "constant",
            SuggestionKind::Part => "property",
        };
        object([
            ("label", suggestion.text.as_str().into()),
            ("type", kind.into()),
            ("detail", suggestion.meaning.text(language).into()),
        ])
    };
    let options: Array = proposals.suggestions.iter().map(option).collect();
    object([("from", (proposals.from as f64).into()), ("options", options.into())])
}

/// An object with these fields.
fn object<const COUNT: usize>(fields: [(&str, JsValue); COUNT]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        let _ = Reflect::set(&object, &name.into(), &value);
    }
    object.into()
}

/// Loads the script, unless it is there already.
async fn load() -> Option<()> {
    if Reflect::has(&js_sys::global(), &MAKER.into()).ok()? {
        return Some(());
    }
    let part = carried::part("editor")?;
    match part.get_attribute("data-script") {
        Some(address) => carried::run_file(&address).await,
        None => carried::run(&carried::inflated(&part).await?),
    }
}
