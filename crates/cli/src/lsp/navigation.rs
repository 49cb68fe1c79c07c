//! Where a name is declared, where it stands, and what a document contains.

use super::open_files::OpenFiles;
use super::positions::{offset, range};
use document::assist::{Symbol, SymbolKind, Uses, named, outer_places, uses, uses_of};
use lsp_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, GotoDefinitionParams, GotoDefinitionResponse,
    Location, ReferenceParams, TextDocumentPositionParams, Uri,
};
use model::Span;
use units::Language;

/// Places that declare the name at the cursor. A translation has them in its document.
pub fn definition(files: &OpenFiles, asked: &GotoDefinitionParams) -> Option<GotoDefinitionResponse> {
    let found = Found::at(files, &asked.text_document_position_params)?;
    Some(GotoDefinitionResponse::Array(found.locations(&found.uses.declared)))
}

/// Places of the name at the cursor in the document and in its translations. Those that declare it are left out if they are not
/// wanted.
pub fn references(files: &OpenFiles, asked: &ReferenceParams) -> Option<Vec<Location>> {
    let found = Found::at(files, &asked.text_document_position)?;
    let Uses { name, declared, places, is_local } = &found.uses;
    let wanted = |place: &Span| asked.context.include_declaration || !declared.contains(place);
    let mut locations = found.locations(places.iter().filter(|place| wanted(place)));
    for (uri, text) in files.translations(&found.uri).iter().filter(|_| !is_local) {
        let places = outer_places(&document::read(text), name);
        locations.extend(places.into_iter().map(|place| Location::new(uri.clone(), range(text, place))));
    }
    Some(locations)
}

/// A name at the cursor with its places in the document.
struct Found {
    uri: Uri,
    text: String,
    uses: Uses,
}

impl Found {
    fn at(files: &OpenFiles, asked: &TextDocumentPositionParams) -> Option<Self> {
        let own = &asked.text_document.uri;
        let file = files.get(own)?;
        let at = offset(&file.text, asked.position);
        let (uri, text) = files.document_of(own)?;
        let outline = document::read(&text);
        let uses = if uri == *own {
            uses(&outline, at)?
        } else {
            uses_of(&outline, &named(&document::read(&file.text), at)?)?
        };
        Some(Self { uri, text, uses })
    }

    fn locations<'a>(&self, places: impl IntoIterator<Item = &'a Span>) -> Vec<Location> {
        places.into_iter().map(|place| Location::new(self.uri.clone(), range(&self.text, *place))).collect()
    }
}

/// The blocks of a document with what they declare.
pub fn symbols(files: &OpenFiles, asked: &DocumentSymbolParams) -> Option<DocumentSymbolResponse> {
    let text = &files.get(&asked.text_document.uri)?.text;
    let symbols = document::assist::symbols(&document::read(text)).into_iter();
    Some(DocumentSymbolResponse::Nested(symbols.map(|symbol| listed(symbol, text, files.language())).collect()))
}

fn listed(symbol: Symbol, text: &str, language: Language) -> DocumentSymbol {
    let children = symbol.children.into_iter().map(|child| listed(child, text, language));
    // The protocol's type has a field that is deprecated, and no other way to make it.
    #[allow(deprecated)]
    DocumentSymbol {
        name: symbol.name,
        detail: Some(symbol.meaning.text(language).into_owned()).filter(|text| !text.is_empty()),
        kind: match symbol.kind {
            SymbolKind::Block => lsp_types::SymbolKind::NAMESPACE,
            SymbolKind::Name => lsp_types::SymbolKind::VARIABLE,
            SymbolKind::Function => lsp_types::SymbolKind::FUNCTION,
            SymbolKind::Equation => lsp_types::SymbolKind::OPERATOR,
            SymbolKind::Event => lsp_types::SymbolKind::EVENT,
            SymbolKind::Entry => lsp_types::SymbolKind::STRING,
        },
        range: range(text, symbol.span),
        selection_range: range(text, symbol.named),
        children: Some(children.collect()),
        tags: None,
        deprecated: None,
    }
}
