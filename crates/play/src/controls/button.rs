//! Buttons of the document. A press is an event at the moment shown and becomes part of the run.

use crate::Basis;
use engine::Press;
use program::Button;
use units::number::compact;

/// Maximum number of presses in one run, so that they fit into a link.
pub(crate) const MOST_PRESSES: usize = 300;

/// A button of the document, for display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ButtonView {
    /// Index into [`program::Model::buttons`].
    pub index: usize,
    /// Title in the chosen language.
    pub title: String,
}

impl Basis {
    /// The buttons of the document, in the order of the text.
    pub fn buttons(&self) -> Vec<ButtonView> {
        let buttons = self.model().buttons.iter().enumerate();
        buttons.map(|(index, button)| ButtonView { index, title: self.text(&button.title).to_owned() }).collect()
    }
}

impl Basis {
    /// Maps the presses of a run of the former program to the buttons of this one. Adds the names of lost presses to
    /// `lost`.
    pub(crate) fn presses_from(&self, presses: &[Press], before: &Basis, lost: &mut Vec<String>) -> Vec<Press> {
        let same = |old: &Button, new: &Button| match (&old.name, &new.name) {
            (Some(old), Some(new)) => old == new,
            _ => old.title == new.title,
        };
        let place = |old: &Button| self.model().buttons.iter().position(|new| same(old, new));
        let mut kept = Vec::new();
        for press in presses {
            let Some(old) = before.model().buttons.get(press.button) else { continue };
            match place(old) {
                Some(button) => kept.push(Press { button, ..*press }),
                None => {
                    let title = before.text(&old.title).to_owned();
                    if !lost.contains(&title) {
                        lost.push(title);
                    }
                }
            }
        }
        kept
    }
}

/// Text form of presses for a link: `kick:3.2:4.1,stop:5`. Consecutive presses of the same button share one entry.
pub(crate) fn written(presses: &[Press], buttons: &[Button], encode: impl Fn(&str) -> String) -> String {
    let mut text = String::new();
    let mut last = None;
    for press in presses {
        let Some(button) = buttons.get(press.button) else { continue };
        if last != Some(press.button) {
            if last.is_some() {
                text.push(',');
            }
            text.push_str(&encode(key(button)));
            last = Some(press.button);
        }
        text.push(':');
        text.push_str(&compact(press.time));
    }
    text
}

/// Parses the output of [`written`]; `None` if a part does not match the buttons.
pub(crate) fn read(text: &str, buttons: &[Button], encode: impl Fn(&str) -> String) -> Option<Vec<Press>> {
    let mut presses: Vec<Press> = Vec::new();
    for part in text.split(',') {
        let mut parts = part.split(':');
        let name = parts.next()?;
        let button = buttons.iter().position(|button| encode(key(button)) == name)?;
        for time in parts {
            let time = units::number::decimal(time)?;
            let follows = presses.last().is_none_or(|last| last.time <= time);
            if !(time >= 0.0 && time.is_finite() && follows) || presses.len() >= MOST_PRESSES {
                return None;
            }
            presses.push(Press { time, button });
        }
    }
    Some(presses)
}

/// Identifier of a button in a link: its name, or its title if it has no name.
fn key(button: &Button) -> &str {
    button.name.as_deref().unwrap_or(&button.title)
}
