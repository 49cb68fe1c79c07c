//! Section about a film in a report.

use super::{Film, FilmPicture, FilmView};
use crate::markup::{Page, escaped};
use crate::png::png;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use units::Language;

/// Colours of the lines over grey pictures: tracked curve, fitted curve, marks. They can be distinguished by
/// colour-blind readers.
const TRACKED: &str = "#ffb000";
const FITTED: &str = "#dc267f";
const MARKS: &str = "#648fff";

/// Adds the sections about the films.
pub fn films(page: &mut Page, films: &[Film], language: Language) {
    for film in films {
        page.heading(&[language.say("The film "), &film.name].concat());
        contents(page, film, language);
    }
}

/// Adds the properties of a film and its pictures.
pub fn contents(page: &mut Page, film: &Film, language: Language) {
    page.raw("<dl class=\"steps\">");
    film.facts.iter().for_each(|(term, value)| page.pair(term, value));
    page.raw("</dl>\n");
    film.notes.iter().for_each(|note| page.element("p class=\"note\"", note));
    for picture in &film.pictures {
        page.raw("<figure>\n");
        let caption = caption(picture, language);
        page.raw(&drawing(picture, &caption));
        page.element("figcaption", &caption);
        page.raw("</figure>\n");
    }
}

fn caption(picture: &FilmPicture, language: Language) -> String {
    let mut text = match picture.view {
        // Frames count from 1 for readers, as on the page.
        FilmView::Frame(frame) => [language.say("Frame "), &(frame + 1).to_string(), "."].concat(),
        FilmView::SpaceTime => {
            language.say("The strip along the tube from every frame, side by side: time to the right.").to_owned()
        }
    };
    let lines = [
        (&picture.tracked, language.say("Yellow: what was tracked.")),
        (&picture.fitted, language.say("Red: the fitted curve.")),
        (&picture.marks, language.say("Blue: the calibration and its zero.")),
    ];
    for (_, words) in lines.iter().filter(|(lines, _)| !lines.is_empty()) {
        text.extend([" ", words]);
    }
    text
}

fn drawing(picture: &FilmPicture, caption: &str) -> String {
    let [width, height] = picture.size.map(short);
    let [columns, rows] = picture.pixels;
    let file = STANDARD.encode(png(columns, rows, &picture.grey));
    let mut out = [
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ",
        &width,
        " ",
        &height,
        "\" style=\"max-width: ",
        &width,
        "px\" role=\"img\" aria-label=\"",
        &escaped(caption),
        "\"><image width=\"",
        &width,
        "\" height=\"",
        &height,
        "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,",
        &file,
        "\"/>",
    ]
    .concat();
    // The fitted curve is thinner than the tracked one, so that both are visible where they coincide.
    let layers = [(&picture.tracked, TRACKED, "3"), (&picture.fitted, FITTED, "1.5"), (&picture.marks, MARKS, "1.5")];
    for (lines, colour, width) in layers {
        out.extend([
            "<g fill=\"none\" stroke-linejoin=\"round\" stroke=\"",
            colour,
            "\" stroke-width=\"",
            width,
            "\">",
        ]);
        for line in lines {
            let points: Vec<String> = line.iter().map(|[x, y]| [&short(*x), ",", &short(*y)].concat()).collect();
            out.extend(["<polyline points=\"", &points.join(" "), "\"/>"]);
        }
        out.push_str("</g>");
    }
    for [x, y] in picture.marks.iter().flatten() {
        out.extend([
            "<circle r=\"4\" fill=\"none\" stroke-width=\"1.5\" stroke=\"",
            MARKS,
            "\" cx=\"",
            &short(*x),
            "\" cy=\"",
            &short(*y),
            "\"/>",
        ]);
    }
    out.push_str("</svg>\n");
    out
}

/// Number rounded to one decimal.
fn short(value: f64) -> String {
    units::number::shortest((value * 10.0).round() / 10.0)
}
