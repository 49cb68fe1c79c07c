//! `meniscus lsp`: a language server for documents, so that any editor reports their errors, offers the remedies, completes,
//! explains, renames and formats.

mod answers;
mod open_files;
mod positions;

use crate::failure::Failure;
use lsp_server::{Connection, ErrorCode, Message, Notification, Request, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, Notification as _, PublishDiagnostics,
};
use lsp_types::request::{CodeActionRequest, Completion, Formatting, HoverRequest, Rename, Request as _};
use lsp_types::{
    CodeActionProviderCapability, CompletionOptions, HoverProviderCapability, OneOf, PublishDiagnosticsParams,
    ServerCapabilities, TextDocumentSyncCapability, TextDocumentSyncKind, Uri,
};
use open_files::OpenFiles;
use serde::Serialize;
use std::error::Error;
use units::Language;

/// Answers an editor until it says that it is done.
///
/// # Errors
/// The editor says something that is not the protocol, or hangs up.
pub fn serve(language: Language) -> Result<(), Failure> {
    let (connection, threads) = Connection::stdio();
    let served = answer(&connection, language);
    // The thread that writes ends when the last sender is gone.
    drop(connection);
    let ended = threads.join().map_err(|error| error.to_string());
    let problem = |error: String| {
        Failure::request(match language {
            Language::English => format!("the editor and the language server do not understand one another: {error}"),
            Language::Spanish => format!("el editor y el servidor de lenguaje no se entienden: {error}"),
        })
    };
    served.map_err(|error| problem(error.to_string())).and(ended.map_err(problem))
}

fn capabilities() -> ServerCapabilities {
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncCapability::Kind(TextDocumentSyncKind::FULL)),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(["[", "<", "`", "{"].map(str::to_owned).to_vec()),
            ..CompletionOptions::default()
        }),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        code_action_provider: Some(CodeActionProviderCapability::Simple(true)),
        rename_provider: Some(OneOf::Left(true)),
        document_formatting_provider: Some(OneOf::Left(true)),
        ..ServerCapabilities::default()
    }
}

fn answer(connection: &Connection, language: Language) -> Result<(), Box<dyn Error + Send + Sync>> {
    connection.initialize(serde_json::to_value(capabilities())?)?;
    let mut files = OpenFiles::new(language);
    for message in &connection.receiver {
        match message {
            Message::Request(request) => {
                if connection.handle_shutdown(&request)? {
                    return Ok(());
                }
                connection.sender.send(Message::Response(respond(&files, request)))?;
            }
            Message::Notification(notification) => {
                if let Some(published) = note(&mut files, notification) {
                    let method = PublishDiagnostics::METHOD.to_owned();
                    connection.sender.send(Message::Notification(Notification::new(method, published)))?;
                }
            }
            Message::Response(_) => {}
        }
    }
    Ok(())
}

/// Notes what the editor has opened, changed or closed, and what is wrong with it now.
fn note(files: &mut OpenFiles, notification: Notification) -> Option<PublishDiagnosticsParams> {
    let uri = match notification.method.as_str() {
        DidOpenTextDocument::METHOD => {
            let opened = parameters::<DidOpenTextDocument>(notification.params)?.text_document;
            files.set(opened.uri.clone(), opened.text);
            opened.uri
        }
        DidChangeTextDocument::METHOD => {
            let mut changed = parameters::<DidChangeTextDocument>(notification.params)?;
            // The whole text comes each time.
            files.set(changed.text_document.uri.clone(), changed.content_changes.pop()?.text);
            changed.text_document.uri
        }
        DidCloseTextDocument::METHOD => {
            let uri = parameters::<DidCloseTextDocument>(notification.params)?.text_document.uri;
            files.close(&uri);
            uri
        }
        _ => return None,
    };
    Some(published(files, uri))
}

fn published(files: &OpenFiles, uri: Uri) -> PublishDiagnosticsParams {
    let diagnostics = files.get(&uri).map(|file| answers::diagnostics(file, files.language(), &uri));
    PublishDiagnosticsParams { diagnostics: diagnostics.unwrap_or_default(), uri, version: None }
}

/// What a notification says; none if it is not what the protocol has there.
fn parameters<N: lsp_types::notification::Notification>(value: serde_json::Value) -> Option<N::Params> {
    serde_json::from_value(value).ok()
}

fn respond(files: &OpenFiles, request: Request) -> Response {
    let Request { id, method, params } = request;
    let answered = match method.as_str() {
        Completion::METHOD => answered::<Completion>(params, |asked| answers::completion(files, &asked)),
        HoverRequest::METHOD => answered::<HoverRequest>(params, |asked| answers::hover(files, &asked)),
        CodeActionRequest::METHOD => answered::<CodeActionRequest>(params, |asked| answers::remedies(files, &asked)),
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
