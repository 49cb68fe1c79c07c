//! Responses to requests of an editor.

use super::open_files::{OpenFile, OpenFiles};
use super::positions::{offset, range};
use document::assist::{SuggestionKind, complete, explain};
use document::edit::Edit;
use lsp_types::{
    CodeAction, CodeActionKind, CodeActionOrCommand, CodeActionParams, CodeActionResponse, CompletionItem,
    CompletionItemKind, CompletionParams, CompletionResponse, CompletionTextEdit, Diagnostic,
    DiagnosticRelatedInformation, DiagnosticSeverity, DocumentFormattingParams, Hover, HoverContents, HoverParams,
    Location, MarkupContent, MarkupKind, NumberOrString, RenameParams, TextDocumentPositionParams, TextEdit, Uri,
    WorkspaceEdit,
};
use model::Severity;
use std::collections::HashMap;
use units::Language;

/// Diagnostics of a file.
pub fn diagnostics(file: &OpenFile, language: Language, uri: &Uri) -> Vec<Diagnostic> {
    let own = file.opened.diagnostics.iter().filter(|(number, _)| *number == 0);
    own.map(|(_, finding)| diagnostic(file, finding, language, uri)).collect()
}

fn diagnostic(file: &OpenFile, finding: &model::Diagnostic, language: Language, uri: &Uri) -> Diagnostic {
    let text = &file.text;
    let primary = finding.labels.first().map(|label| label.text.text(language)).filter(|text| !text.is_empty());
    let message = finding.message.text(language);
    let first = match primary {
        Some(primary) => format!("{message} ({primary})"),
        None => message.into_owned(),
    };
    let rest = finding.notes.iter().chain(&finding.hints).map(|words| words.text(language).into_owned());
    let related = finding.labels.iter().skip(1).map(|label| DiagnosticRelatedInformation {
        location: Location::new(uri.clone(), range(text, label.span)),
        message: label.text.text(language).into_owned(),
    });
    Diagnostic {
        range: range(text, finding.span()),
        severity: Some(match finding.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
        }),
        code: Some(NumberOrString::String(finding.code.to_owned())),
        source: Some("meniscus".to_owned()),
        message: std::iter::once(first).chain(rest).collect::<Vec<_>>().join("\n"),
        related_information: Some(related.collect()),
        ..Diagnostic::default()
    }
}

/// Quick fixes for findings at the cursor or selection.
pub fn remedies(files: &OpenFiles, asked: &CodeActionParams) -> Option<CodeActionResponse> {
    let uri = &asked.text_document.uri;
    let file = files.get(uri)?;
    let language = files.language();
    let chosen = [asked.range.start, asked.range.end].map(|at| offset(&file.text, at));
    let touches = |span: model::Span| span.start <= chosen[1] && chosen[0] <= span.end;
    let own = file.opened.diagnostics.iter().filter(|(number, _)| *number == 0);
    let touched = own.map(|(_, finding)| finding).filter(|finding| touches(finding.span()));
    let actions = touched.flat_map(|finding| {
        finding.fixes.iter().map(|fix| {
            CodeActionOrCommand::CodeAction(CodeAction {
                title: fix.title(&file.text).text(language).replace('\n', " "),
                kind: Some(CodeActionKind::QUICKFIX),
                diagnostics: Some(vec![diagnostic(file, finding, language, uri)]),
                edit: Some(edited(uri, &file.text, &fix.edits)),
                is_preferred: Some(finding.fixes.len() == 1),
                ..CodeAction::default()
            })
        })
    });
    Some(actions.collect())
}

fn text_edits(text: &str, edits: &[Edit]) -> Vec<TextEdit> {
    edits.iter().map(|edit| TextEdit::new(range(text, edit.span), edit.text.clone())).collect()
}

/// Edits that give the file the standard layout. Formatting options of the editor are ignored.
pub fn formatting(files: &OpenFiles, asked: &DocumentFormattingParams) -> Option<Vec<TextEdit>> {
    let text = &files.get(&asked.text_document.uri)?.text;
    Some(text_edits(text, &document::format(&document::read(text)).edits))
}

fn edited(uri: &Uri, text: &str, edits: &[Edit]) -> WorkspaceEdit {
    let edits = text_edits(text, edits);
    // The protocol demands the address as key; it is not changed afterwards.
    #[allow(clippy::mutable_key_type)]
    let changes = HashMap::from([(uri.clone(), edits)]);
    WorkspaceEdit::new(changes)
}

/// File and byte offset of a request.
fn place<'a>(files: &'a OpenFiles, asked: &TextDocumentPositionParams) -> Option<(&'a OpenFile, usize)> {
    let file = files.get(&asked.text_document.uri)?;
    Some((file, offset(&file.text, asked.position)))
}

/// Completions at the cursor.
pub fn completion(files: &OpenFiles, asked: &CompletionParams) -> Option<CompletionResponse> {
    let (file, at) = place(files, &asked.text_document_position)?;
    let found = complete(&document::read(&file.text), file.program.as_ref(), at);
    let replaced = range(&file.text, found.span);
    let items = found.suggestions.into_iter().enumerate().map(|(number, suggestion)| CompletionItem {
        kind: Some(match suggestion.kind {
            SuggestionKind::Word => CompletionItemKind::KEYWORD,
            SuggestionKind::Name => CompletionItemKind::VARIABLE,
            SuggestionKind::Function => CompletionItemKind::FUNCTION,
            SuggestionKind::Unit => CompletionItemKind::UNIT,
            SuggestionKind::Part => CompletionItemKind::PROPERTY,
        }),
        detail: Some(suggestion.meaning.text(files.language()).into_owned()),
        // The order of the suggestions is kept: names come before functions.
        sort_text: Some(format!("{number:05}")),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit::new(replaced, suggestion.text.clone()))),
        label: suggestion.text,
        ..CompletionItem::default()
    });
    Some(CompletionResponse::Array(items.collect()))
}

/// Explanation of the word under the cursor.
pub fn hover(files: &OpenFiles, asked: &HoverParams) -> Option<Hover> {
    let (file, at) = place(files, &asked.text_document_position_params)?;
    let found = explain(&document::read(&file.text), file.program.as_ref(), at)?;
    let value = found.meaning.text(files.language()).into_owned();
    Some(Hover {
        contents: HoverContents::Markup(MarkupContent { kind: MarkupKind::PlainText, value }),
        range: Some(range(&file.text, found.span)),
    })
}

/// Renames the name under the cursor everywhere in the document and its translations.
///
/// # Errors
/// There is no name of the model at the cursor, or the new name is not allowed; as text for users.
pub fn rename(files: &OpenFiles, asked: &RenameParams) -> Result<Option<WorkspaceEdit>, String> {
    let Some((file, at)) = place(files, &asked.text_document_position) else { return Ok(None) };
    let uri = &asked.text_document_position.text_document.uri;
    let others = files.translations(uri);
    let texts: Vec<&str> = others.iter().map(|(_, text)| text.as_str()).collect();
    let edits = document::edit::rename_with(&document::read(&file.text), at, asked.new_name.trim(), &texts)
        .map_err(|refusal| refusal.words().text(files.language()).into_owned())?;
    let all = std::iter::once((uri, file.text.as_str())).chain(others.iter().map(|(uri, text)| (uri, text.as_str())));
    let changed = all.zip(&edits).filter(|(_, edits)| !edits.is_empty());
    // The protocol demands the address as key; it is not changed afterwards.
    #[allow(clippy::mutable_key_type)]
    let changes: HashMap<Uri, Vec<TextEdit>> =
        changed.map(|((uri, text), edits)| (uri.clone(), text_edits(text, edits))).collect();
    Ok(Some(WorkspaceEdit::new(changes)))
}
