//! Link and its QR code.

use super::words;
use crate::app::App;
use crate::documents::links;
use crate::documents::visited::stem;
use qrcodegen::{QrCode, QrCodeEcc};
use std::fmt::Write as _;
use view::browser;
use view::views::*;

/// Maximum length of an address for a QR code, in bytes: version 20 with 97 modules per side, which phones can read
/// from a screen and from paper.
const LONGEST: usize = 858;

/// Width of the quiet zone in modules, as required by ISO 18004.
const MARGIN: usize = 4;

/// Content of the QR code section.
#[derive(Clone, PartialEq)]
enum Shown {
    Nothing,
    /// The code as an SVG.
    Code(String),
    /// Reason why the link has no code; a field accepts another address.
    Refused(&'static str),
}

/// Section of the dialog: the link, and its QR code on demand.
pub fn view(app: App) -> View {
    let words = words::of(app);
    let copy =
        button().class("action").id("copy-link").title(app.page.words().share_title).child(app.page.words().share);
    let copied = create_signal(String::new());
    let copy = copy.when(events::click, move |_| {
        links::share(app, move |sentences| {
            // The dialog may have been closed meanwhile.
            if copied.is_alive() {
                copied.set(sentences);
            }
        });
    });
    let copied = p().class("note").role("status").id("link-copied").child(text(move || copied.get_clone()));
    let shown = create_signal(Shown::Nothing);
    let make = move |_| {
        if shown.get_clone_untracked() != Shown::Nothing {
            return shown.set(Shown::Nothing);
        }
        wasm_bindgen_futures::spawn_local(async move {
            let (address, _) = links::present(app).await;
            if shown.is_alive() {
                shown.set(code_of_link(app, &address));
            }
        });
    };
    let code = button()
        .class("quiet outlined")
        .id("qr")
        .attr("aria-expanded", move || (shown.get_clone() != Shown::Nothing).to_string())
        .attr("aria-controls", "qr-code")
        .when(events::click, make)
        .child(words.qr_code);
    let place = div().id("qr-code").attr("aria-live", "polite").child(changing(move || match shown.get_clone() {
        Shown::Nothing => View::new(),
        Shown::Code(svg) => code_view(app, svg),
        Shown::Refused(why) => other_address(app, why),
    }));
    View::from((note(words.link_intro), div().class("ways").child(copy).child(code), copied, place))
}

fn code_of_link(app: App, address: &str) -> Shown {
    let words = words::of(app);
    if links::is_local(address) {
        return Shown::Refused(words.qr_local);
    }
    code(address).map_or(Shown::Refused(words.qr_too_long), Shown::Code)
}

/// The QR code with a button that saves it.
fn code_view(app: App, svg: String) -> View {
    let words = words::of(app);
    let picture = div().class("qr").role("img").attr("aria-label", words.qr_label).inner_html(svg.clone());
    let save = button().class("quiet outlined").id("save-qr").child(words.qr_save);
    let save = save.when(events::click, move |_| {
        browser::save_text(&format!("{}-qr.svg", stem(app)), "image/svg+xml", &svg);
    });
    View::from((picture, div().class("ways").child(save)))
}

/// Reason why the link has no code, and a field for another address.
fn other_address(app: App, why: &'static str) -> View {
    let words = words::of(app);
    let typed = create_signal(String::new());
    let field = input()
        .r#type("url")
        .id("qr-address")
        .class("address")
        .attr("placeholder", "https://")
        .when(events::input, move |event| typed.set(value_of(&event)));
    let made = move || {
        let address = typed.get_clone();
        match (address.trim(), code(address.trim())) {
            ("", _) => View::new(),
            (_, Some(svg)) => code_view(app, svg),
            (_, None) => p().class("refusal").child(words.qr_not_made).into(),
        }
    };
    let field = label().class("field").child(span().child(words.qr_address)).child(field);
    View::from((p().class("note").child(why), field, changing(made)))
}

/// QR code as an SVG: black on white, independent of the theme of the page. `None` if the text is too long.
fn code(text: &str) -> Option<String> {
    // The error correction level is raised if the size of the code stays the same.
    let code = QrCode::encode_text(text, QrCodeEcc::Low).ok().filter(|_| text.len() <= LONGEST)?;
    let size = usize::try_from(code.size()).ok()?;
    let mut path = String::new();
    for row in 0..code.size() {
        for column in (0..code.size()).filter(|column| code.get_module(*column, row)) {
            // Writing to a string cannot fail.
            let _ = write!(path, "M{column} {row}h1v1h-1z");
        }
    }
    let (whole, start) = (size + 2 * MARGIN, -(MARGIN as i64));
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{start} {start} {whole} {whole}\" width=\"{0}\" height=\"{0}\" \
         shape-rendering=\"crispEdges\"><path fill=\"#fff\" d=\"M{start} {start}h{whole}v{whole}h-{whole}z\"/>\
         <path d=\"{path}\"/></svg>",
        4 * whole
    ))
}
