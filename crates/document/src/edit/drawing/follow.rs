//! Makes points follow quantities.

use super::attribute::{attribute_edit, expect_attributes};
use super::distance::split_distance;
use super::expect::{drawing, item};
use crate::drawing::{Axis, at_axis};
use crate::edit::{Edit, EditError};
use crate::text::outline::Outline;

/// Makes one component of a point follow a quantity, from its present place: `3 [cm]` becomes `y + 3 [cm]`. A quantity
/// followed before is replaced; with an empty name only the distance remains.
///
/// # Errors
///
/// The errors of [`set_attribute`](super::set_attribute), and [`EditError::NotAPoint`].
pub fn follow(
    outline: &Outline,
    number: usize,
    attribute: &str,
    axis: Axis,
    name: &str,
) -> Result<Vec<Edit>, EditError> {
    let drawing = drawing(outline)?;
    let item = item(&drawing, number)?;
    let source = outline.source();
    let value = item.attribute(attribute).ok_or(EditError::NotAPoint)?.value;
    let range = at_axis(source, value, axis).ok_or(EditError::NotAPoint)?;
    let (_, distance) = split_distance(&source[range.clone()]);
    let component = match (name, distance) {
        ("", "") => "0".to_owned(),
        ("", distance) => distance.trim_start_matches('+').trim_start().replace("- ", "-"),
        (name, "" | "0") => name.to_owned(),
        (name, distance) => match distance.strip_prefix(['-', '+']) {
            Some(length) => format!("{name} {} {}", &distance[..1], length.trim_start()),
            None => format!("{name} + {distance}"),
        },
    };
    let text = format!("{}{component}{}", &source[value.start..range.start], &source[range.end..value.end]);
    let edit = attribute_edit(source, item, attribute, &text);
    expect_attributes(outline, &drawing, vec![edit], number, &[(attribute, &text)])
}
