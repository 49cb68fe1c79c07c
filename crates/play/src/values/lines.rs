//! Grouping of values into lines: the components of a vector together; for a family, the member selected by the reader.

/// A name split into parts: `u[1,2]'` is u with the indices 1 and 2 and a prime, `r.y` is the second component of r.
#[derive(Debug, PartialEq, Eq)]
struct Parts<'a> {
    stem: &'a str,
    indices: Vec<i64>,
    axis: Option<usize>,
    primes: &'a str,
}

impl<'a> Parts<'a> {
    fn of(name: &'a str) -> Self {
        let (rest, primes) = name.split_at(name.trim_end_matches('\'').len());
        let axis = |axis: &str| ["x", "y", "z"].iter().position(|known| *known == axis);
        let component = rest.rsplit_once('.').and_then(|(vector, last)| Some((vector, axis(last)?)));
        let (rest, axis) = component.map_or((rest, None), |(vector, axis)| (vector, Some(axis)));
        let numbers =
            |text: &str| text.split(',').map(|number| number.trim().parse().ok()).collect::<Option<Vec<i64>>>();
        let member = rest.strip_suffix(']').and_then(|rest| rest.split_once('['));
        let member = member.and_then(|(stem, text)| Some((stem, numbers(text)?)));
        let (stem, indices) = member.unwrap_or((rest, Vec::new()));
        Self { stem, indices, axis, primes }
    }
}

/// A line: a single item, or a family of which one member is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line<T> {
    /// Name without index, component and primes.
    pub stem: String,
    /// Component such as `.x`, if components have separate lines; otherwise empty.
    component: &'static str,
    /// Primes of the name.
    pub primes: String,
    /// Members in the order of their indices.
    pub members: Vec<Member<T>>,
    /// Indices of the member shown initially: the first one of the text.
    first: Vec<i64>,
}

/// A member of a family, or a single item.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Member<T> {
    /// Indices of the member; empty for a single item.
    pub indices: Vec<i64>,
    /// Contents: the components of a vector, or one number, text or truth value.
    pub parts: Vec<T>,
    /// True if the parts are components of a vector.
    pub is_vector: bool,
}

/// Groups items (item, name, unit) into lines. A family stands at the place of its first member. Components form one
/// line if `joined` and if their units are equal.
pub(crate) fn in_lines<T>(things: impl Iterator<Item = (T, String, String)>, joined: bool) -> Vec<Line<T>> {
    let mut lines: Vec<Line<T>> = Vec::new();
    let mut places = std::collections::HashMap::new();
    for (thing, name, unit) in things {
        let Parts { stem, indices, axis, primes } = Parts::of(&name);
        let is_vector = axis.is_some() && joined;
        let alone = axis.filter(|_| !joined);
        let unit = if is_vector { unit } else { String::new() };
        let key = (stem.to_owned(), primes.to_owned(), indices.len(), alone, is_vector.then_some(unit));
        let place = *places.entry(key).or_insert_with(|| {
            let (stem, primes) = (stem.to_owned(), primes.to_owned());
            let component = alone.and_then(|axis| [".x", ".y", ".z"].get(axis)).copied().unwrap_or_default();
            lines.push(Line { stem, component, primes, members: Vec::new(), first: indices.clone() });
            lines.len() - 1
        });
        let Some(Line { members, .. }) = lines.get_mut(place) else { continue };
        let at = members.partition_point(|member| member.indices < indices);
        match members.get_mut(at) {
            Some(member) if member.indices == indices => member.parts.push(thing),
            _ => members.insert(at, Member { indices, parts: vec![thing], is_vector }),
        }
    }
    lines
}

/// Distance of two lists of indices, ordered lexicographically: the first index has priority.
fn distance(one: &[i64], other: &[i64]) -> Vec<u64> {
    one.iter().zip(other).map(|(one, other)| one.abs_diff(*other)).collect()
}

impl<T> Line<T> {
    /// Name without index: `x'`, `r.x`.
    pub fn name(&self) -> String {
        [self.stem.as_str(), self.component, &self.primes].concat()
    }

    /// True if there are several members.
    pub fn is_family(&self) -> bool {
        self.members.len() > 1
    }

    /// Member with these indices, or the nearest one.
    pub fn member(&self, chosen: Option<&[i64]>) -> Option<&Member<T>> {
        let wanted = chosen.filter(|chosen| chosen.len() == self.first.len()).unwrap_or(&self.first);
        match self.members.binary_search_by(|member| member.indices.as_slice().cmp(wanted)) {
            Ok(place) => self.members.get(place),
            Err(_) => self.members.iter().min_by_key(|member| distance(&member.indices, wanted)),
        }
    }

    /// Least and greatest value of the index at position `place`, for the given values of the preceding indices.
    pub fn range(&self, indices: &[i64], place: usize) -> (i64, i64) {
        let beside = self.members.iter().filter(|member| member.indices.get(..place) == indices.get(..place));
        let values = beside.filter_map(|member| member.indices.get(place).copied());
        values.fold((i64::MAX, i64::MIN), |(least, greatest), value| (least.min(value), greatest.max(value)))
    }

    /// Indices of the member shown after setting the index at position `place` to `value`. If there is none, the next
    /// one in the direction of the change.
    pub fn moved(&self, indices: &[i64], place: usize, value: i64) -> Option<Vec<i64>> {
        let now = *indices.get(place)?;
        let beside = self.members.iter().filter(|member| member.indices.get(..place) == indices.get(..place));
        let further = |member: &&Member<T>| {
            let &own = member.indices.get(place)?;
            // A member on the other side is chosen only if none lies ahead.
            let behind = if value >= now { own < value } else { own > value };
            Some((behind, own.abs_diff(value), distance(&member.indices, indices)))
        };
        let nearest = beside.filter_map(|member| Some((further(&member)?, member))).min_by_key(|(far, _)| far.clone());
        nearest.map(|(_, member)| member.indices.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::{Parts, in_lines};

    #[test]
    fn names_have_parts() {
        let parts = |stem, indices: &[i64], axis, primes| Parts { stem, indices: indices.to_vec(), axis, primes };
        for (name, expected) in [
            ("omega_0", parts("omega_0", &[], None, "")),
            ("x[12]''", parts("x", &[12], None, "''")),
            ("u[0,-1]", parts("u", &[0, -1], None, "")),
            ("r.y'", parts("r", &[], Some(1), "'")),
            ("r[3].x", parts("r", &[3], Some(0), "")),
            ("landing.time", parts("landing.time", &[], None, "")),
        ] {
            assert_eq!(Parts::of(name), expected);
        }
    }

    #[test]
    fn an_index_goes_over_gaps_and_keeps_the_others_near() {
        let names = ["u[1,1]", "u[1,2]", "u[1,5]", "u[2,2]", "u[4,9]"];
        let lines = in_lines(names.iter().map(|name| (*name, (*name).to_owned(), String::new())), true);
        assert_eq!(lines.len(), 1);
        let line = &lines[0];
        assert_eq!(line.range(&[1, 2], 1), (1, 5));
        assert_eq!(line.range(&[1, 2], 0), (1, 4));
        for (from, place, value, to) in [
            ([1, 2], 1, 3, [1, 5]),
            ([1, 5], 1, 4, [1, 2]),
            ([1, 5], 1, 9, [1, 5]),
            ([1, 5], 0, 2, [2, 2]),
            ([2, 2], 0, 3, [4, 9]),
            ([4, 9], 0, 3, [2, 2]),
            ([4, 9], 0, 1, [1, 5]),
        ] {
            assert_eq!(line.moved(&from, place, value), Some(to.to_vec()), "{from:?}, {place}, {value}");
        }
        assert_eq!(line.member(None).map(|member| member.parts[0]), Some("u[1,1]"));
        assert_eq!(line.member(Some(&[3, 9])).map(|member| member.parts[0]), Some("u[4,9]"));
    }
}
