//! Changes of the texts from outside the editor. They pass through the editor, so that they are part of its undo
//! history.

use crate::app::App;
use desk::text_changes;
use document::Outline;
use document::edit::EditError;
use model::Edit;
use view::pieces::icons;
use view::views::*;

/// Present text of a file in the editor, even if its last change has not been checked.
pub fn text(app: App, file: usize) -> String {
    let editor = app.with(|lab| lab.editor.clone().filter(|_| lab.editor_is_current)).flatten();
    match editor {
        Some(editor) => editor.text(file),
        None => app.read_writing(|writing| writing.texts().get(file).cloned().unwrap_or_default()),
    }
}

/// Changes a file as by typing into a field. Returns the edits made.
///
/// # Errors
///
/// The error of `edit`, in the language of the page.
pub fn change<'a>(
    app: App,
    file: usize,
    text: &'a str,
    edit: impl FnOnce(&Outline<'a>) -> Result<Vec<Edit>, EditError>,
) -> Result<Vec<Edit>, String> {
    edited(app, (file, text), true, edit)
}

/// Changes a file by a single action, such as a button, as one undo step. Returns the edits made.
///
/// # Errors
///
/// The error of `edit`, in the language of the page.
pub fn act<'a>(
    app: App,
    file: usize,
    text: &'a str,
    edit: impl FnOnce(&Outline<'a>) -> Result<Vec<Edit>, EditError>,
) -> Result<Vec<Edit>, String> {
    edited(app, (file, text), false, edit)
}

fn edited<'a>(
    app: App,
    (file, text): (usize, &'a str),
    is_typed: bool,
    edit: impl FnOnce(&Outline<'a>) -> Result<Vec<Edit>, EditError>,
) -> Result<Vec<Edit>, String> {
    let edits = edit(&document::read(text));
    let edits = edits.map_err(|refusal| refusal.words().text(app.language.get_untracked()).into_owned())?;
    let editor = app.with(|lab| lab.editor.clone()).flatten();
    if let Some(editor) = editor.filter(|_| !edits.is_empty()) {
        editor.edit(file, &text_changes(text, &edits), is_typed);
        app.typed.update(|count| *count += 1);
    }
    Ok(edits)
}

/// Changes the document and its translations together. `edit` receives the document and the texts of the translations
/// and returns the edits of each file.
///
/// # Errors
///
/// The error of `edit`, in the language of the page.
pub fn change_all(
    app: App,
    edit: impl FnOnce(&Outline, &[&str]) -> Result<Vec<Vec<Edit>>, EditError>,
) -> Result<(), String> {
    let count = app.read_writing(|writing| writing.texts().len());
    let texts: Vec<String> = (0..count).map(|file| text(app, file)).collect();
    let Some((first, others)) = texts.split_first() else { return Ok(()) };
    let others: Vec<&str> = others.iter().map(String::as_str).collect();
    let edits = edit(&document::read(first), &others);
    let edits = edits.map_err(|refusal| refusal.words().text(app.language.get_untracked()).into_owned())?;
    for (file, (text, edits)) in texts.iter().zip(edits).enumerate() {
        act(app, file, text, |_| Ok(edits))?;
    }
    Ok(())
}

/// Buttons to undo and redo the last change of the document.
pub fn undo_buttons(app: App) -> HtmlDiv {
    let words = app.words();
    let undo = |icon, name: &'static str, forwards| {
        labelled(icon, name).when(events::click, move |_| self::undo(app, 0, forwards))
    };
    div().class("form-tools").child(undo(icons::undo(), words.undo_change, false)).child(undo(
        icons::redo(),
        words.redo_change,
        true,
    ))
}

/// Undoes or, with `forwards`, redoes the last change of a file, wherever it was made.
pub fn undo(app: App, file: usize, forwards: bool) {
    if let Some(editor) = app.with(|lab| lab.editor.clone()).flatten() {
        editor.undo(file, forwards);
        app.typed.update(|count| *count += 1);
    }
}
