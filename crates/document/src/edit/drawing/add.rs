//! Adds elements, and a scene for them.

use super::arrange::{expect_beside, indent};
use super::distance::Measure;
use super::expect::drawing;
use crate::BlockKind;
use crate::drawing::{Drawing, Part, shows_text};
use crate::edit::{Edit, EditError, insert_block, line_end};
use crate::scene::part_of;
use crate::text::outline::Outline;
use model::Span;
use units::Language;

/// Stroke of a new line.
const LINE: &str = "stroke=\"text\" stroke-width=\"2\"";

/// Attributes that determine the position of an element.
const PLACING: [&str; 11] = ["at", "from", "to", "x", "y", "x1", "y1", "cx", "cy", "points", "d"];

/// Adds an element of size `length` centred at `at`, both in the lengths of its place (SI, or units of the drawing). It is
/// on top, in the first frame of the drawing, or else in the drawing itself. If another element is at `at`, it is placed
/// beside. Also returns its index.
///
/// # Errors
///
/// [`EditError::NoDrawing`], [`EditError::TooLong`].
pub fn add_element(
    outline: &Outline,
    kind: &Part,
    (at, length): ([f64; 2], f64),
    measure: &Measure,
    language: Language,
) -> Result<(Edit, usize), EditError> {
    let source = outline.source();
    let drawing = drawing(outline)?;
    let frame = drawing.items.iter().position(|item| item.is_frame());
    let (opening, end) = match frame.and_then(|frame| drawing.items.get(frame)) {
        Some(frame) => (frame.opening, frame.span.end),
        None => (drawing.opening, drawing.end),
    };
    let text = written_beside(&drawing, source, |aside| {
        let aside = 2.0 * measure.step * f64::from(aside);
        let at = [at[0] + aside, at[1] + if frame.is_some() { -aside } else { aside }];
        written(kind, at, length, measure, frame.is_some(), language)
    });
    let holder = if frame.is_some() { "frame" } else { "svg" };
    let edit = match source[opening.range()].strip_suffix("/>") {
        // A self-closed frame is opened for it.
        Some(open) => {
            let at = opening.start + open.trim_end().len();
            let (line, blanks) = (line_end(source), indent(source, opening.start));
            Edit { span: Span::new(at, opening.end), text: format!(">{line}{blanks}  {text}{line}{blanks}</{holder}>") }
        }
        None => {
            let closing = source[opening.end..end].rfind("</").map_or(end, |length| opening.end + length);
            let at = source[..closing].trim_end().len().max(opening.end);
            let blanks = indent(source, opening.start);
            let line = line_end(source);
            let behind = if source[at..closing].contains('\n') { String::new() } else { format!("{line}{blanks}") };
            Edit { span: Span::new(at, at), text: format!("{line}{blanks}  {text}{behind}") }
        }
    };
    let place = drawing.items.iter().filter(|item| item.span.start < edit.span.end).count();
    expect_beside(outline, &drawing, &edit, place, 1)?;
    Ok((edit, place))
}

/// Adds a scene with an empty frame of 40 by 30 centimetres, after the first model.
///
/// # Errors
///
/// [`EditError::TooLong`], [`EditError::ChangesOthers`].
pub fn add_scene(outline: &Outline, title: &str) -> Result<Edit, EditError> {
    let model = outline.blocks().iter().position(|block| block.kind == BlockKind::Model);
    let title: String = title.chars().filter(|letter| !matches!(letter, '<' | '>' | '&' | '{' | '}')).collect();
    let text = format!(
        "<svg viewBox=\"0 0 400 300\">\n  <title>{}</title>\n  <frame x=\"-20..20 [cm]\" y=\"-15..15 [cm]\">\n  </frame>\n</svg>\n",
        title.trim()
    );
    let mut edit = insert_block(outline, model, BlockKind::Scene, &text)?;
    // Blank lines around it.
    let end = line_end(outline.source());
    edit.text = format!("{end}{}", edit.text);
    Ok(edit)
}

/// Attributes of an SVG shape outside frames.
fn plain(name: &str, [x, y]: [f64; 2], length: f64, measure: &Measure) -> String {
    let across = |part: f64| measure.moved("0", x + part * length);
    let along = |part: f64| measure.moved("0", y + part * length);
    let size = |part: f64| measure.grown("0", part * length);
    let (left, right, top, middle) = (across(-0.5), across(0.5), along(-0.5), along(0.0));
    match name {
        "line" => format!("x1=\"{left}\" y1=\"{middle}\" x2=\"{right}\" y2=\"{middle}\" {LINE}"),
        "rect" => {
            let (x, y, width, height) = (across(-0.25), along(-0.15), size(0.5), size(0.3));
            format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"accent\"")
        }
        "circle" => format!("cx=\"{}\" cy=\"{middle}\" r=\"{}\" fill=\"accent\"", across(0.0), size(0.2)),
        "ellipse" => {
            let (x, rx, ry) = (across(0.0), size(0.4), size(0.2));
            format!("cx=\"{x}\" cy=\"{middle}\" rx=\"{rx}\" ry=\"{ry}\" fill=\"accent\"")
        }
        "path" => format!("d=\"M {left} {middle} Q {} {top} {right} {middle}\" fill=\"none\" {LINE}", across(0.0)),
        "text" => format!("x=\"{}\" y=\"{middle}\" fill=\"text\"", across(0.0)),
        _ => format!("points=\"{left},{middle} {},{top} {right},{middle}\" fill=\"none\" {LINE}", across(0.0)),
    }
}

/// Text of the element in the first place that no other element occupies, so that neither hides the other.
fn written_beside(drawing: &Drawing, source: &str, written: impl Fn(u32) -> String) -> String {
    let is_free = |text: &String| {
        let pieces: Vec<&str> = text.split('"').collect();
        let attributes = pieces.chunks_exact(2).filter_map(|pair| Some((pair[0].strip_suffix('=')?, pair[1])));
        let named = attributes.filter_map(|(before, value)| Some((before.rsplit(' ').next()?, value)));
        let place: Vec<(&str, &str)> = named.filter(|(name, _)| PLACING.contains(name)).collect();
        !drawing.items.iter().any(|item| place.iter().all(|(name, value)| item.value(source, name) == Some(value)))
    };
    // Each element occupies one place, so one of these is free.
    let last = drawing.items.len() as u32;
    (0..last).map(&written).find(is_free).unwrap_or_else(|| written(last))
}

/// Text of a new element.
fn written(kind: &Part, [x, y]: [f64; 2], length: f64, measure: &Measure, framed: bool, language: Language) -> String {
    let name = kind.name;
    let point = |right: f64, up: f64| {
        let up = if framed { up } else { -up };
        measure.point([x + right * length, y + up * length])
    };
    let size = |part: f64| measure.grown("0", part * length);
    let (at, from, to) = (point(0.0, 0.0), point(-0.5, 0.0), point(0.5, 0.0));
    let between = format!("from=\"{from}\" to=\"{to}\"");
    let attributes = match name {
        "ramp" => format!("from=\"{from}\" to=\"{}\"", point(0.5, 0.4)),
        "arrow" => format!("at=\"{at}\" vector=\"({}, 0)\"", size(0.5)),
        "block" | "image" => format!("at=\"{at}\" size=\"({}, {})\"", size(0.5), size(0.3)),
        "bob" => format!("at=\"{at}\""),
        "wheel" | "pulley" => format!("at=\"{at}\" r=\"{}\"", size(0.25)),
        "protractor" => format!("at=\"{at}\" r=\"{}\"", size(0.5)),
        "angle" => format!("at=\"{at}\" from=\"0\" to=\"45 [deg]\""),
        "ruler" => format!("{between} step=\"{}\"", size(0.1)),
        "axes" => {
            let range = |middle: f64| {
                let (low, high) = (measure.moved("0", middle - length), measure.moved("0", middle + length));
                format!("{}..{high}", low.split_once(" [").map_or(low.as_str(), |(number, _)| number))
            };
            format!("x=\"{}\" y=\"{}\" step=\"{}\"", range(x), range(y), size(0.5))
        }
        "tube" => format!(
            "from=\"{}\" to=\"{}\" width=\"{}\" level=\"{}\"",
            point(0.0, -0.5),
            point(0.0, 0.5),
            size(0.2),
            size(0.5)
        ),
        "utube" => {
            let level = size(0.5);
            format!(
                "at=\"{}\" spacing=\"{}\" height=\"{}\" left=\"{level}\" right=\"{level}\"",
                point(0.0, -0.5),
                size(0.6),
                size(1.0)
            )
        }
        shape if !framed && part_of(name).is_none() => plain(shape, [x, y], length, measure),
        "line" => format!("{between} {LINE}"),
        "rect" => format!("at=\"{at}\" size=\"({}, {})\" fill=\"accent\"", size(0.5), size(0.3)),
        "circle" => format!("at=\"{at}\" r=\"{}\" fill=\"accent\"", size(0.2)),
        "ellipse" => format!("at=\"{at}\" rx=\"{}\" ry=\"{}\" fill=\"accent\"", size(0.4), size(0.2)),
        "polyline" | "polygon" => {
            let points = format!("{from} {} {to}", point(0.0, 0.5));
            format!("points=\"{points}\" fill=\"none\" {LINE}")
        }
        "path" => format!("d=\"M {from} Q {} {to}\" fill=\"none\" {LINE}", point(0.0, 0.5)),
        "text" => format!("at=\"{at}\" fill=\"text\""),
        "label" | "trail" => format!("at=\"{at}\""),
        _ => between,
    };
    if shows_text(kind) {
        let text = language.say("Text");
        return format!("<{name} {attributes}>{text}</{name}>");
    }
    format!("<{name} {attributes}/>")
}
