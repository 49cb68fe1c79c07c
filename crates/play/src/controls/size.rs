//! Sizes of families. Another size requires another model, which only a page that contains the parser can build.

use crate::Basis;

/// The size of families, for its control.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SizeView {
    /// ASCII name.
    pub name: String,
    /// Label in the chosen language; the name if there is none.
    pub label: String,
    /// Present value.
    pub value: u32,
    /// Least and greatest value; `None` without a range.
    pub range: Option<(u32, u32)>,
    /// True if it is the value stated in the document.
    pub is_default: bool,
}

impl Basis {
    /// All sizes, in the order of the text.
    pub fn sizes(&self) -> Vec<SizeView> {
        let view = |size: &program::Size| SizeView {
            name: size.name.clone(),
            label: size.label.as_deref().map_or(size.name.as_str(), |label| self.text(label)).to_owned(),
            value: size.value,
            range: size.range,
            is_default: size.value == size.stated,
        };
        self.model().sizes.iter().map(view).collect()
    }

    /// Sizes, by name, with which the program must be built before restoring a state written by [`crate::Play::share`]. Empty
    /// if they are those of this program.
    pub fn sizes_for(&self, fragment: &str) -> Vec<(String, u32)> {
        let field = fragment.split('&').find_map(|field| field.strip_prefix("n=")).unwrap_or_default();
        let linked = |name: &str| {
            let value = field.split(',').find_map(|pair| pair.strip_prefix(name)?.strip_prefix(':'))?;
            value.parse::<u32>().ok()
        };
        let sizes = &self.model().sizes;
        let wanted = sizes.iter().map(|size| (size, linked(&size.name).unwrap_or(size.stated)));
        let wanted: Vec<(&program::Size, u32)> = wanted.collect();
        if wanted.iter().all(|(size, value)| size.value == *value) {
            return Vec::new();
        }
        wanted.into_iter().map(|(size, value)| (size.name.clone(), value)).collect()
    }
}
