//! Edits of a document that leave all other bytes unchanged.
//!
//! Each function takes the [`Outline`](crate::Outline) of a text and returns edits for [`apply`]. An edit is refused if it
//! would change the meaning of the rest of the text: a closing fence inside a block, for example, would end the block
//! early.
//!
//! [`set_cell`] refuses a text that would not be read back as that one cell. [`set_translation`] writes one text of a
//! translation; [`set_plot`], [`set_label`] and others change plots, controls with their groups, and values.

mod blocks;
mod cell;
mod columns;
mod drawing;
mod error;
mod layout;
mod lines;
mod obstacle;
mod parameter;
mod plots;
mod question;
mod rename;
mod settings;
mod shown;
mod statements;
mod translation;

pub use blocks::{insert_block, remove_block, replace_block};
pub use cell::{set_cell, set_name};
pub(crate) use drawing::split_distance;
pub use drawing::{
    Measure, Order, add_element, add_scene, duplicate_element, follow, remove_elements, reorder_element, set_attribute,
    set_text, shift,
};
pub use error::EditError;
pub(crate) use layout::line_end;
pub use model::Edit;
pub use obstacle::Obstacle;
pub use parameter::set_parameter;
pub use plots::{NewPlot, add_plot, exchange_plots, remove_plot, set_plot};
pub use question::{NewQuestion, add_question, remove_question, set_question};
pub use rename::{rename, rename_with};
pub use settings::set_front_matter;
pub use shown::{add_group, exchange_statements, set_hidden, set_label};
pub use statements::{add_statement, remove_statement};
pub use translation::set_translation;
use units::order::sort_by_key;

/// Applies edits, in any order; their spans are byte ranges of `source`. Insertions at the same place keep the order of
/// `edits`.
///
/// # Errors
///
/// [`EditError::Place`] if a span is outside the text or cuts a character, [`EditError::Overlap`] if two spans share bytes.
pub fn apply(source: &str, edits: &[Edit]) -> Result<String, EditError> {
    let mut ordered: Vec<&Edit> = edits.iter().collect();
    sort_by_key(&mut ordered, |edit| (edit.span.start, edit.span.end));
    let mut result = String::with_capacity(source.len());
    let mut at = 0;
    for edit in ordered {
        if source.get(edit.span.range()).is_none() {
            return Err(EditError::Place(edit.span));
        }
        let Some(before) = source.get(at..edit.span.start) else {
            return Err(EditError::Overlap(edit.span));
        };
        result.push_str(before);
        result.push_str(&edit.text);
        at = edit.span.end;
    }
    result.push_str(source.get(at..).unwrap_or_default());
    Ok(result)
}
