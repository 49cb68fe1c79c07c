//! `meniscus lsp`: a language server for documents. Any editor can report errors, offer fixes, complete, explain, find what
//! declares a name and where it stands, list what a document contains, rename and format.

mod answers;
mod navigation;
mod open_files;
mod positions;
mod transport;

use crate::failure::Failure;
use lsp_server::{ErrorCode, Message, Notification, Request, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, Exit, Notification as _, PublishDiagnostics,
};
use lsp_types::request::{
    CodeActionRequest, Completion, DocumentSymbolRequest, Formatting, GotoDefinition, HoverRequest, Initialize,
    References, Rename, Request as _, Shutdown,
};
use lsp_types::{
    CodeActionProviderCapability, CompletionOptions, HoverProviderCapability, OneOf, PublishDiagnosticsParams,
    ServerCapabilities, TextDocumentSyncCapability, TextDocumentSyncKind, Uri,
};
use open_files::OpenFiles;
use serde::Serialize;
use std::io::{self, BufRead, Write};
use units::{Language, say};

/// Serves an editor until it sends `exit`.
///
/// # Errors
/// The streams to the editor cannot be read or written.
pub fn serve(language: Language) -> Result<(), Failure> {
    answer(&mut io::stdin().lock(), &mut io::stdout().lock(), language)
        .map_err(|error| Failure::request(say!(language, "the connection to the editor is broken: {error}")))
}

fn capabilities() -> ServerCapabilities {
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncCapability::Kind(TextDocumentSyncKind::INCREMENTAL)),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(["[", "<", "`", "{"].map(str::to_owned).to_vec()),
            ..CompletionOptions::default()
        }),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        code_action_provider: Some(CodeActionProviderCapability::Simple(true)),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        document_symbol_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Left(true)),
        document_formatting_provider: Some(OneOf::Left(true)),
        ..ServerCapabilities::default()
    }
}

fn answer(input: &mut impl BufRead, output: &mut impl Write, language: Language) -> io::Result<()> {
    let mut files = OpenFiles::new(language);
    let mut state = State::New;
    while let Some(message) = transport::read(input)? {
        match message {
            Ok(Message::Request(request)) => Message::Response(respond(&files, &mut state, request)).write(output)?,
            Ok(Message::Notification(notification)) if notification.method == Exit::METHOD => return Ok(()),
            Ok(Message::Notification(notification)) if state == State::Ready => {
                for published in note(&mut files, notification) {
                    let method = PublishDiagnostics::METHOD.to_owned();
                    Message::Notification(Notification::new(method, published)).write(output)?;
                }
            }
            Ok(_) => {}
            Err(malformed) => transport::refuse(output, &malformed)?,
        }
    }
    Ok(())
}

/// State of the session.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// Before `initialize`.
    New,
    /// Between `initialize` and `shutdown`.
    Ready,
    /// After `shutdown`.
    Done,
}

/// Processes the opening, change or closing of a file. Returns the diagnostics of this file and of those that depend on
/// it.
fn note(files: &mut OpenFiles, notification: Notification) -> Vec<PublishDiagnosticsParams> {
    noted(files, notification).into_iter().flatten().map(|uri| published(files, uri)).collect()
}

/// Files whose diagnostics may have changed. `None` for other or malformed notifications.
fn noted(files: &mut OpenFiles, notification: Notification) -> Option<Vec<Uri>> {
    Some(match notification.method.as_str() {
        DidOpenTextDocument::METHOD => {
            let opened = parameters::<DidOpenTextDocument>(notification.params)?.text_document;
            files.set(opened.uri, opened.text)
        }
        DidChangeTextDocument::METHOD => {
            let changed = parameters::<DidChangeTextDocument>(notification.params)?;
            files.change(changed.text_document.uri, changed.content_changes)?
        }
        DidCloseTextDocument::METHOD => {
            files.close(parameters::<DidCloseTextDocument>(notification.params)?.text_document.uri)
        }
        _ => return None,
    })
}

fn published(files: &OpenFiles, uri: Uri) -> PublishDiagnosticsParams {
    let diagnostics = files.get(&uri).map(|file| answers::diagnostics(file, files.language(), &uri));
    PublishDiagnosticsParams { diagnostics: diagnostics.unwrap_or_default(), uri, version: None }
}

/// Parameters of a notification; `None` if they do not match the protocol.
fn parameters<N: lsp_types::notification::Notification>(value: serde_json::Value) -> Option<N::Params> {
    serde_json::from_value(value).ok()
}

fn respond(files: &OpenFiles, state: &mut State, request: Request) -> Response {
    let Request { id, method, params } = request;
    let answered = match method.as_str() {
        Initialize::METHOD if *state == State::New => {
            *state = State::Ready;
            Ok(serde_json::json!({ "capabilities": capabilities() }))
        }
        _ if *state == State::New => {
            return Response::new_err(
                id,
                ErrorCode::ServerNotInitialized as i32,
                format!("{method} before initialize"),
            );
        }
        Shutdown::METHOD => {
            *state = State::Done;
            Ok(serde_json::Value::Null)
        }
        _ if *state == State::Done => {
            return Response::new_err(id, ErrorCode::InvalidRequest as i32, format!("{method} after shutdown"));
        }
        Completion::METHOD => answered::<Completion>(params, |asked| answers::completion(files, &asked)),
        HoverRequest::METHOD => answered::<HoverRequest>(params, |asked| answers::hover(files, &asked)),
        CodeActionRequest::METHOD => answered::<CodeActionRequest>(params, |asked| answers::remedies(files, &asked)),
        GotoDefinition::METHOD => answered::<GotoDefinition>(params, |asked| navigation::definition(files, &asked)),
        References::METHOD => answered::<References>(params, |asked| navigation::references(files, &asked)),
        DocumentSymbolRequest::METHOD => {
            answered::<DocumentSymbolRequest>(params, |asked| navigation::symbols(files, &asked))
        }
        Formatting::METHOD => answered::<Formatting>(params, |asked| answers::formatting(files, &asked)),
        Rename::METHOD => match serde_json::from_value(params) {
            Ok(asked) => match answers::rename(files, &asked) {
                Ok(edit) => written(&edit),
                Err(refusal) => return Response::new_err(id, ErrorCode::RequestFailed as i32, refusal),
            },
            Err(error) => Err(error.to_string()),
        },
        _ => return Response::new_err(id, ErrorCode::MethodNotFound as i32, method),
    };
    match answered {
        Ok(value) => Response::new_ok(id, value),
        Err(error) => Response::new_err(id, ErrorCode::InvalidParams as i32, error),
    }
}

fn answered<R: lsp_types::request::Request>(
    parameters: serde_json::Value,
    answer: impl FnOnce(R::Params) -> R::Result,
) -> Result<serde_json::Value, String> {
    let asked = serde_json::from_value(parameters).map_err(|error| error.to_string())?;
    written(&answer(asked))
}

fn written(value: &impl Serialize) -> Result<serde_json::Value, String> {
    serde_json::to_value(value).map_err(|error| error.to_string())
}
