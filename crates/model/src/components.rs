//! The names of the components of vectors: `r.x`, `r[1].y`.

/// Names of the components, by axis.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// Name of a component of a vector; for an axis beyond the third, the name of the vector.
pub(crate) fn component_name(vector: &str, axis: usize) -> String {
    AXES.get(axis).map_or_else(|| vector.to_owned(), |name| format!("{vector}.{name}"))
}

/// Splits `r.x` into vector and axis (0 to 2). `None` if `name` is not a component.
pub(crate) fn split_component(name: &str) -> Option<(&str, usize)> {
    let (vector, axis) = name.rsplit_once('.')?;
    let axis = AXES.iter().position(|known| *known == axis)?;
    (!vector.is_empty()).then_some((vector, axis))
}

/// Common name of quantities of one dimension: the vector of a component, the family of a member, `r` for `r[1].x`.
pub(crate) fn vector_or_family(name: &str) -> Option<&str> {
    match name.split_once('[') {
        Some((family, _)) => Some(family),
        None => split_component(name).map(|(vector, _)| vector),
    }
}
