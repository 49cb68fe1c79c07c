//! Everything of a class as files.

use crate::fold::{Folded, sender};
use crate::store::{Fault, Store};
use std::collections::BTreeSet;

/// Hand-ins of a class as `(name, content)`, then the answers to surveys in no order.
///
/// # Errors
/// The store cannot be read.
pub async fn files(store: &Store, class: &str) -> Result<Vec<(String, String)>, Fault> {
    let mut folded = Vec::new();
    for seat in store.seats(class.to_owned()).await? {
        let events = store.events_of_seat(class.to_owned(), seat.seat).await?;
        folded.push((seat.pseudonym, Folded::of(&events)));
    }
    let documents: BTreeSet<&str> = folded.iter().flat_map(|(_, folded)| folded.documents()).collect();
    let mut files = Vec::new();
    for (pseudonym, folded) in &folded {
        for document in folded.documents() {
            let name = sender(pseudonym, document, documents.len());
            if let Some(hand_in) = folded.hand_in(document, &name) {
                files.push((format!("{name}.hand-in"), hand_in));
            }
        }
    }
    let sheets = store.sheets(class.to_owned()).await?;
    files.extend(sheets.into_iter().zip(1..).map(|(sheet, number)| (format!("{number}.survey"), sheet)));
    Ok(files)
}
