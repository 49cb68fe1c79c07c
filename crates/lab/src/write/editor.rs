//! The editor: CodeMirror, contained in the page as a deflated script (`crates/lab/editor`) and started on first use.
//! In a site the script is a separate file. Places in a text are counted in UTF-16 units, as in browsers.

use super::phrases::PHRASES;
use crate::documents::carried;
use desk::document::assist::{Suggestion, SuggestionKind};
use desk::{Mark, Proposals, TextChange};
use js_sys::{Array, Function, Object, Reflect};
use model::Severity;
use units::Language;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::Element;

/// Global name of the function that creates the editor.
const MAKER: &str = "meniscusEditor";

/// The editor, as long as the page is open. Failing method calls are ignored, because the script belongs to the page.
#[derive(Clone)]
pub struct Editor(JsValue);

impl Editor {
    /// Starts the editor. `changed` is called with file index and text after a pause in typing, `propose` with the text
    /// shown and a place in it, `moved` likewise when the cursor has come to rest. `None` if the script cannot be
    /// loaded.
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
        // The callbacks are needed as long as the page is open.
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

    /// Inserts the editor into an element.
    pub fn mount(&self, place: &Element) {
        let dom = Reflect::get(&self.0, &"dom".into()).ok().and_then(|dom| dom.dyn_into::<Element>().ok());
        if let Some(dom) = dom {
            let _ = place.append_child(&dom);
        }
    }

    /// Opens other texts and shows the first one.
    pub fn open(&self, texts: &[String]) {
        self.call("open", &[texts.iter().map(JsValue::from).collect::<Array>().into()]);
    }

    /// Opens another text beside the others, whose undo history stays.
    pub fn add(&self, text: &str) {
        self.call("add", &[text.into()]);
    }

    /// Shows the text with this index.
    pub fn select(&self, file: usize) {
        self.call("select", &[(file as f64).into()]);
    }

    /// Sets the accessible name of the text, and the editor's own texts in a language.
    pub fn speak(&self, label: &str, language: Language) {
        let own = Object::new();
        for phrase in PHRASES {
            let _ = Reflect::set(&own, &phrase.english().into(), &(&*phrase.text(language)).into());
        }
        self.call("speak", &[label.into(), own.into()]);
    }

    /// Marks the diagnostics in the text shown.
    pub fn mark(&self, marks: &[Mark], language: Language) {
        let mark = |mark: &Mark| {
            let severity = if mark.severity == Severity::Error { "error" } else { "warning" };
            let sentences: Vec<_> =
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

    /// Changes the text shown, unless it has changed since the check.
    pub fn change(&self, changes: &[TextChange]) {
        self.call("change", &[described(changes)]);
    }

    /// Present text of a file, even if not checked yet.
    pub fn text(&self, file: usize) -> String {
        self.call("text", &[(file as f64).into()]).as_string().unwrap_or_default()
    }

    /// Changes a text, shown or not, without moving the focus. With `is_typed`, consecutive changes form one undo step;
    /// any other change is a step of its own.
    pub fn edit(&self, file: usize, changes: &[TextChange], is_typed: bool) {
        self.call("edit", &[(file as f64).into(), described(changes), is_typed.into()]);
    }

    /// Undoes the last change of a text or, with `forwards`, redoes it, and checks the text.
    pub fn undo(&self, file: usize, forwards: bool) {
        self.call("undo", &[(file as f64).into(), forwards.into()]);
    }

    /// Updates the layout after the editor was hidden.
    pub fn measure(&self) {
        self.call("measure", &[]);
    }

    /// Replaces the text of a file as one undo step, without calling `changed`.
    pub fn take(&self, file: usize, text: &str) {
        self.call("take", &[(file as f64).into(), text.into()]);
    }

    /// Moves the cursor to a place in the text shown, in UTF-16 units.
    pub fn go(&self, place: usize) {
        self.call("go", &[(place as f64).into(), (place as f64).into()]);
    }

    /// Moves the focus into the text.
    pub fn focus(&self) {
        self.call("focus", &[]);
    }

    /// Checks a pending change immediately.
    pub fn flush(&self) {
        self.call("flush", &[]);
    }
}

/// Changes in the format of the editor: `[{ from, to, insert }]`.
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

/// Proposals in the format of the editor: `{ from, options: [{ label, type, detail }] }`.
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
            ("detail", (&*suggestion.meaning.text(language)).into()),
        ])
    };
    let options: Array = proposals.suggestions.iter().map(option).collect();
    object([("from", (proposals.from as f64).into()), ("options", options.into())])
}

/// JavaScript object with these fields.
fn object<const COUNT: usize>(fields: [(&str, JsValue); COUNT]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        let _ = Reflect::set(&object, &name.into(), &value);
    }
    object.into()
}

/// Loads the script, unless it has been loaded.
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
