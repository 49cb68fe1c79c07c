//! Tool `picture`: the scene at a time and the plots as PNG.

use super::answer::{Answer, Refused};
use super::given::RunSettings;
use super::runs::prepared;
use super::workplace::Call;
use figure::{Palette, Settings};
use play::{Play, PlotView, scene_svg};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};
use rmcp::schemars::{self, JsonSchema};
use serde::Deserialize;
use serde_json::{Value, json};
use std::sync::{Arc, LazyLock};

/// Width of pictures in pixels unless another one is asked for, and its range.
const WIDTH: u32 = 640;
const WIDTHS: std::ops::RangeInclusive<u32> = 100..=2000;
/// Largest number of plots in an answer.
const PLOTS: usize = 8;
/// Plots that are drawn unless they are named.
const FIRST_PLOTS: usize = 3;
/// Width of a plot in its own units, and its height.
const PLOT: (f64, f64) = (640.0, 360.0);

/// Families for the texts of drawings, the first that is there.
const FAMILIES: [&str; 7] =
    ["DejaVu Sans", "Noto Sans", "Liberation Sans", "Segoe UI", "Helvetica Neue", "Helvetica", "Arial"];

/// Fonts of this computer.
static FONTS: LazyLock<Arc<fontdb::Database>> = LazyLock::new(|| {
    let mut fonts = fontdb::Database::new();
    fonts.load_system_fonts();
    let has = |name: &&&str| fonts.faces().any(|face| face.families.iter().any(|(family, _)| family == **name));
    let any = || fonts.faces().next().and_then(|face| Some(face.families.first()?.0.clone()));
    // The families that drawings name in general, which need not be those that the library supposes.
    if let Some(family) = FAMILIES.iter().find(has).map(|name| (*name).to_owned()).or_else(any) {
        fonts.set_sans_serif_family(family.clone());
        fonts.set_serif_family(family.clone());
        fonts.set_monospace_family(family);
    }
    Arc::new(fonts)
});

/// Arguments of `picture`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    /// Path of the document below the folder.
    document: Option<String>,
    /// The document itself, in place of a path.
    text: Option<String>,
    /// Settings of the run in place of the document's own.
    #[serde(default)]
    settings: RunSettings,
    /// Moment of the scene and end of the plots, in the unit of the independent variable; without it the end of the run.
    time: Option<f64>,
    /// Titles of plots; without it the first three. An empty list: only the scene.
    plots: Option<Vec<String>>,
    /// Width of each picture in pixels, 640 without it.
    width: Option<u32>,
}

/// Draws the scene and plots of a document.
pub fn picture(call: Call, asked: Asked) -> Result<Answer, Refused> {
    let width = asked.width.unwrap_or(WIDTH).clamp(*WIDTHS.start(), *WIDTHS.end());
    let source = (asked.document.as_ref(), asked.text.as_ref());
    let (document, setup, until) = prepared(call, source, &asked.settings)?;
    let unit = document.program.model.independent.unit.clone();
    let time = asked.time.map_or(until, |time| unit.to_si(time));
    if !time.is_finite() || time < 0.0 {
        return Err(Refused::because("`time` must not be negative"));
    }
    let mut play = Play::open(document.program);
    play.change_run(|line, basis| line.start(basis, setup));
    while play.change_run(|line, _| line.compute_on(time)) {
        if !call.goes_on() {
            return Err(super::runs::too_long(call, unit.from_si(play.course().front())));
        }
    }
    play.change_run(|line, _| line.show_time(time));
    let mut pictures = Vec::new();
    let mut shown = Vec::new();
    if let Some(svg) = scene_svg(&mut play, &Palette::LIGHT.text.to_string()) {
        pictures.push(png(&svg, width)?);
        shown.push("the scene".to_owned());
    }
    for plot in chosen(&play, asked.plots.as_deref())? {
        while play.change_plots(|plots, run| plots.work(run)) && call.goes_on() {}
        let settings = Settings { width: PLOT.0, height: PLOT.1, ..Settings::default() };
        play.layout_plot(plot.id, &settings);
        pictures.push(png(&play.plots().svg(plot.id, &settings, &Palette::LIGHT), width)?);
        shown.push(plot.title);
    }
    let mut answer = json!({ "pictures": shown, "time": unit.from_si(play.course().time()), "unit": unit.text });
    if let Some(error) = play.course().error() {
        answer["stopped"] = error.message(play.model()).text(call.language).into();
    }
    if FONTS.is_empty() {
        answer["remark"] = Value::from("this computer has no fonts: texts are missing in the pictures");
    }
    Ok(Answer::Pictures(pictures, answer))
}

/// The plots with these titles, or the first ones.
fn chosen(play: &Play, titles: Option<&[String]>) -> Result<Vec<PlotView>, Refused> {
    let all = play.plots().list();
    let Some(titles) = titles else { return Ok(all.into_iter().take(FIRST_PLOTS).collect()) };
    if titles.len() > PLOTS {
        return Err(Refused::because(format!("at most {PLOTS} plots are drawn at once")));
    }
    let find = |title: &String| {
        let names: Vec<&str> = all.iter().map(|plot| plot.title.as_str()).collect();
        let place = names.iter().position(|name| name == title);
        let missing = || Refused::because(format!("there is no plot `{title}`; there are: {}", names.join(", ")));
        place.map(|place| all[place].clone()).ok_or_else(missing)
    };
    titles.iter().map(find).collect()
}

/// An SVG file as PNG on white, scaled to a width in pixels.
fn png(svg: &str, width: u32) -> Result<Vec<u8>, Refused> {
    let failed = |error: &dyn std::fmt::Display| Refused::because(format!("the picture cannot be drawn: {error}"));
    let mut options = Options { fontdb: FONTS.clone(), ..Options::default() };
    // No file and no address is read: a scene embeds its images.
    options.image_href_resolver.resolve_string = Box::new(|_, _| None);
    let tree = Tree::from_str(svg, &options).map_err(|error| failed(&error))?;
    let scale = width as f32 / tree.size().width();
    let height = (tree.size().height() * scale).ceil().clamp(1.0, 4.0 * width as f32) as u32;
    let mut pixels = Pixmap::new(width, height).ok_or_else(|| failed(&"it is too large"))?;
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| failed(&error))
}
