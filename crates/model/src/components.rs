//! The names of the components of vectors: `r.x`, `r[1].y`.

/// The components, in their order.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// The name of a component of a vector; of a component beyond the third, the vector's.
pub(crate) fn component_name(vector: &str, axis: usize) -> String {
    AXES.get(axis).map_or_else(|| vector.to_owned(), |name| format!("{vector}.{name}"))
}

/// The vector and the number of the component whose name this is, if it has the form of one.
pub(crate) fn split_component(name: &str) -> Option<(&str, usize)> {
    let (vector, axis) = name.rsplit_once('.')?;
    let axis = AXES.iter().position(|known| *known == axis)?;
    (!vector.is_empty()).then_some((vector, axis))
}

/// What all of the same dimension have in their names: the vector of a component, the family of a member, `r` of `r[1].x`.
pub(crate) fn vector_or_family(name: &str) -> Option<&str> {
    match name.split_once('[') {
        Some((family, _)) => Some(family),
        None => split_component(name).map(|(vector, _)| vector),
    }
}
