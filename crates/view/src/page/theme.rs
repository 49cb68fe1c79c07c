//! Light or dark theme: chosen by the user, or that of the system.

use crate::app::App;
use crate::browser;
use crate::pieces::colours::Colours;
use crate::views::*;
use figure::{Ink, Palette, SERIES_COLOURS};
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;

/// The chosen theme.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theme {
    /// Theme of the system.
    System,
    /// Light.
    Light,
    /// Dark.
    Dark,
}

/// Colours of figures in the present theme.
pub fn palette() -> &'static Palette {
    let shown = document().document_element().and_then(|root| root.get_attribute("data-theme"));
    if shown.as_deref() == Some(Theme::Dark.name()) { &Palette::DARK } else { &Palette::LIGHT }
}

impl Theme {
    /// Choice of the last visit.
    pub fn remembered() -> Self {
        match browser::remembered("theme").as_deref() {
            Some("light") => Self::Light,
            Some("dark") => Self::Dark,
            _ => Self::System,
        }
    }

    /// Next theme in cyclic order.
    pub fn next(self) -> Self {
        match self {
            Self::System => Self::Light,
            Self::Light => Self::Dark,
            Self::Dark => Self::System,
        }
    }

    /// Applies and stores the choice.
    pub fn choose(self, app: App) {
        browser::remember("theme", self.name());
        self.apply(app);
    }

    /// Sets the attribute used by the style sheet, and the colours of the canvases.
    pub fn apply(self, app: App) {
        let dark = self == Self::Dark || (self == Self::System && browser::matches("(prefers-color-scheme: dark)"));
        if let Some(root) = document().document_element() {
            let palette = if dark { &Palette::DARK } else { &Palette::LIGHT };
            let root: HtmlElement = root.unchecked_into();
            let style = root.style();
            // For legends.
            for number in 0..SERIES_COLOURS as u8 {
                let colour = palette.colour(Ink::Series(number)).to_string();
                let _ = style.set_property(&format!("--series-{number}"), &colour);
            }
            for number in 0..SERIES_COLOURS as u8 {
                let faded = palette.colour(Ink::Faded(number)).to_string();
                let _ = style.set_property(&format!("--faded-{number}"), &faded);
            }
            let _ = root.set_attribute("data-theme", if dark { Self::Dark } else { Self::Light }.name());
        }
        app.nodes(|nodes| {
            nodes.colours = Colours::new(if dark { &Palette::DARK } else { &Palette::LIGHT });
            for plot in nodes.plots.iter_mut().flatten() {
                plot.invalidate();
            }
        });
        app.wake();
    }

    fn name(self) -> &'static str {
        match self {
            Self::System => "",
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }
}
