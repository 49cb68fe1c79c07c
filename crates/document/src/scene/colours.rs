//! Colours of the page's theme and of CSS.

use super::allowed::danger;
use model::{Diagnostic, Span};
use units::{nearest, words};

/// Colours of the theme by the names used in documents, each with a fallback for pages without a theme.
pub const PALETTE: [(&str, &str); 6] = [
    ("text", "currentColor"),
    ("liquid", "var(--liquid, #3f9fc0)"),
    ("liquid-deep", "var(--liquid-deep, #1c7699)"),
    ("glass", "var(--glass, #6d7d86)"),
    ("accent", "var(--accent, #0a6076)"),
    ("mark", "var(--mark, #c4551d)"),
];

/// The named colours of CSS Color Module Level 4, section 6.1.
#[rustfmt::skip]
const NAMED: [&str; 148] = [
    "aliceblue", "antiquewhite", "aqua", "aquamarine", "azure", "beige", "bisque", "black", "blanchedalmond", "blue", "blueviolet",
    "brown", "burlywood", "cadetblue", "chartreuse", "chocolate", "coral", "cornflowerblue", "cornsilk", "crimson", "cyan",
    "darkblue", "darkcyan", "darkgoldenrod", "darkgray", "darkgreen", "darkgrey", "darkkhaki", "darkmagenta", "darkolivegreen",
    "darkorange", "darkorchid", "darkred", "darksalmon", "darkseagreen", "darkslateblue", "darkslategray", "darkslategrey",
    "darkturquoise", "darkviolet", "deeppink", "deepskyblue", "dimgray", "dimgrey", "dodgerblue", "firebrick", "floralwhite",
    "forestgreen", "fuchsia", "gainsboro", "ghostwhite", "gold", "goldenrod", "gray", "green", "greenyellow", "grey", "honeydew",
    "hotpink", "indianred", "indigo", "ivory", "khaki", "lavender", "lavenderblush", "lawngreen", "lemonchiffon", "lightblue",
    "lightcoral", "lightcyan", "lightgoldenrodyellow", "lightgray", "lightgreen", "lightgrey", "lightpink", "lightsalmon",
    "lightseagreen", "lightskyblue", "lightslategray", "lightslategrey", "lightsteelblue", "lightyellow", "lime", "limegreen",
    "linen", "magenta", "maroon", "mediumaquamarine", "mediumblue", "mediumorchid", "mediumpurple", "mediumseagreen",
    "mediumslateblue", "mediumspringgreen", "mediumturquoise", "mediumvioletred", "midnightblue", "mintcream", "mistyrose",
    "moccasin", "navajowhite", "navy", "oldlace", "olive", "olivedrab", "orange", "orangered", "orchid", "palegoldenrod",
    "palegreen", "paleturquoise", "palevioletred", "papayawhip", "peachpuff", "peru", "pink", "plum", "powderblue", "purple",
    "rebeccapurple", "red", "rosybrown", "royalblue", "saddlebrown", "salmon", "sandybrown", "seagreen", "seashell", "sienna",
    "silver", "skyblue", "slateblue", "slategray", "slategrey", "snow", "springgreen", "steelblue", "tan", "teal", "thistle",
    "tomato", "turquoise", "violet", "wheat", "white", "whitesmoke", "yellow", "yellowgreen",
];

/// Keywords of CSS in place of a colour.
const KEYWORDS: [&str; 9] =
    ["none", "transparent", "currentcolor", "inherit", "initial", "unset", "revert", "context-fill", "context-stroke"];

/// Spanish names of colours.
#[rustfmt::skip]
const SPANISH: [(&str, &str); 19] = [
    ("amarillo", "yellow"), ("azul", "blue"), ("blanco", "white"), ("celeste", "skyblue"), ("cian", "cyan"), ("dorado", "gold"),
    ("granate", "maroon"), ("gris", "gray"), ("lila", "orchid"), ("marrón", "brown"), ("morado", "purple"),
    ("naranja", "orange"), ("negro", "black"), ("ninguno", "none"), ("plateado", "silver"), ("rojo", "red"), ("rosa", "pink"),
    ("turquesa", "turquoise"), ("verde", "green"),
];

/// True if the value of an attribute is a colour.
pub fn is_colour(attribute: &str) -> bool {
    matches!(attribute, "fill" | "stroke" | "color" | "stop-color")
}

/// CSS value of a colour of the theme.
pub fn palette(name: &str) -> Option<&'static str> {
    PALETTE.iter().find(|(known, _)| *known == name.trim()).map(|(_, colour)| *colour)
}

/// CSS value of a colour of the theme or of CSS; `None` if the text is not a colour.
pub fn colour(text: &str) -> Option<String> {
    let text = text.trim();
    palette(text).or_else(|| (is_css(text) && danger(text).is_none()).then_some(text)).map(str::to_owned)
}

fn is_css(text: &str) -> bool {
    let text = text.trim().to_ascii_lowercase();
    if let Some(digits) = text.strip_prefix('#') {
        return matches!(digits.len(), 3 | 4 | 6 | 8) && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    }
    match text.strip_suffix(')').and_then(|text| text.split_once('(')) {
        Some(("var", inner)) => {
            let (name, otherwise) = inner.split_once(',').unwrap_or((inner, "none"));
            name.trim().starts_with("--") && is_css(otherwise)
        }
        // Only checked as far as every browser rejects the same values.
        Some(("color" | "color-mix" | "light-dark", inner)) => !inner.trim().is_empty(),
        Some(("rgb" | "rgba" | "hsl" | "hsla" | "hwb" | "lab" | "lch" | "oklab" | "oklch", inner)) => {
            let numbers: Vec<&str> =
                inner.split([' ', ',', '/']).map(str::trim).filter(|number| !number.is_empty()).collect();
            matches!(numbers.len(), 3 | 4) && numbers.into_iter().all(is_component)
        }
        Some(_) => false,
        None => KEYWORDS.contains(&text.as_str()) || NAMED.contains(&text.as_str()),
    }
}

/// True for a component of a colour: `30`, `50%`, `120deg`.
fn is_component(text: &str) -> bool {
    let number = ["%", "deg", "rad", "turn"].into_iter().find_map(|unit| text.strip_suffix(unit)).unwrap_or(text);
    text == "none" || number.parse::<f64>().is_ok_and(f64::is_finite)
}

/// Reports an invalid colour, with the colour that was probably meant.
pub fn misfit(text: &str, span: Span) -> Option<Diagnostic> {
    if colour(text).is_some() {
        return None;
    }
    let found = no_colour(text, span);
    Some(match meant(text) {
        Some(meant) => found.with_fix(span, meant),
        None => found,
    })
}

/// Error for a text that is not a colour.
pub fn no_colour(text: &str, span: Span) -> Diagnostic {
    let text = text.trim();
    let palette = PALETTE.map(|(name, _)| name).join(", ");
    let message = words!("\"{text}\" is not a colour");
    let mut found = Diagnostic::error("scene-refused", message, span);
    found.hints.extend(meant(text).map(|meant| words!("did you mean `{meant}`?")));
    found.with_hint(words!("colours are those of the page ({palette}), the names of CSS, such as red, and `#c4551d`"))
}

fn meant(text: &str) -> Option<&'static str> {
    let text = text.trim().to_lowercase();
    let translated = SPANISH.into_iter().find(|(spanish, _)| *spanish == text).map(|(_, name)| name);
    translated.or_else(|| nearest(&text, PALETTE.map(|(name, _)| name).into_iter().chain(NAMED)))
}
