//! Examples of the language: code blocks that are documents, or parts of one beside the first model of their page.

use crate::page::gzip;
use anyhow::{Context, Result, bail};
use engine::Setup;
use figure::{Palette, Settings};
use play::{Play, scene_svg};
use program::{Program, bundle};
use std::fs;
use std::path::Path;
use units::markup::escaped;

/// Kinds of blocks that are parts of a document.
const PARTS: [&str; 7] = ["model", "scene", "plots", "presets", "question", "survey", "check"];
/// Parts of the page that an example with a scene shows.
const SHOWN: &str = "scene plots parameters";
/// Greatest number of plots of an example that has none.
const PLOTS: usize = 2;
/// Width and height of the picture of a plot.
const PLOT: (f64, f64) = (560.0, 240.0);
/// Number of steps that a picture without an end shows.
const STEPS: f64 = 500.0;

/// An example.
#[derive(Debug)]
pub struct Example {
    /// Name of its files.
    name: String,
    kind: String,
    text: String,
    /// Parts of the page that are shown, of the element's attribute `show`.
    shown: &'static str,
    /// Block with plots, for an example that shows nothing by itself; empty otherwise.
    plots: String,
    /// Compiled simulation, gzipped, and picture, if there is something to be drawn. `None` for an example that is wrong on
    /// purpose.
    played: Option<(Vec<u8>, Option<String>)>,
}

impl Example {
    /// The example in a block of this kind; `None` for blocks of another kind. `model`: first model of the page; `is_wrong`: the
    /// block is followed by what is said of it.
    pub fn of(name: String, kind: &str, text: &str, model: &str, is_wrong: bool) -> Result<Option<Self>> {
        let source = match kind {
            "markdown" => text.to_owned(),
            "model" => format!("```model\n{text}```\n"),
            kind if PARTS.contains(&kind) => format!("```model\n{model}```\n\n```{kind}\n{text}```\n"),
            _ => return Ok(None),
        };
        let (kind, text) = (kind.to_owned(), text.to_owned());
        let mut example = Self { name, kind, text, shown: SHOWN, plots: String::new(), played: None };
        if is_wrong {
            return Ok(Some(example));
        }
        let name = &example.name;
        let mut program = opened(name, &source)?;
        let has_scene = program.scene(&program.language).is_some();
        example.shown = match example.kind.as_str() {
            "question" | "survey" => "activities",
            _ if has_scene => SHOWN,
            _ => "plots parameters",
        };
        if !has_scene && program.plots.is_empty() {
            example.plots = plots(&source, &program);
            program = opened(name, &(source + &example.plots))?;
        }
        let bundle = bundle::write(&program).ok().with_context(|| format!("{name} is too large"))?;
        let picture = picture(program).with_context(|| name.clone())?;
        example.played = Some((gzip(&bundle)?, picture));
        Ok(Some(example))
    }

    /// The example in its page: text, picture, and the element that takes the picture's place.
    pub fn html(&self) -> String {
        let Self { name, kind, text, shown, plots, played } = self;
        let code = format!("<pre tabindex=\"0\"><code>{}</code></pre>", escaped(text));
        let image = format!("<img src=\"examples/{name}.svg\" alt=\"Picture of this example\" loading=\"lazy\">");
        let element = played.as_ref().map_or_else(String::new, |(_, picture)| {
            let image = picture.as_ref().map_or("", |_| &image);
            format!(
                "<meniscus-simulation src=\"examples/{name}.bin\" show=\"{shown}\" title=\"{name}\">{image}</meniscus-simulation>"
            )
        });
        let plots = if plots.is_empty() { String::new() } else { format!(" data-plots=\"{}\"", escaped(plots)) };
        format!("<figure class=\"example\" data-kind=\"{kind}\"{plots}>{code}{element}</figure>\n")
    }

    /// Writes its files.
    pub fn write(&self, folder: &Path) -> Result<()> {
        if let Some((bundle, picture)) = &self.played {
            fs::write(folder.join(&self.name).with_extension("bin"), bundle)?;
            if let Some(picture) = picture {
                fs::write(folder.join(&self.name).with_extension("svg"), picture)?;
            }
        }
        Ok(())
    }
}

/// The program of a document without errors and warnings.
fn opened(name: &str, source: &str) -> Result<Program> {
    let opened = document::open(source, &[]);
    if let Some((_, found)) = opened.diagnostics.first() {
        bail!("{name}: {}\n{source}", found.message.english());
    }
    Ok(opened.document.with_context(|| format!("{name} gives no document"))?.program)
}

/// Block with a plot for each of the first variables and varying quantities that can be plotted; empty if there are none.
fn plots(source: &str, program: &Program) -> String {
    let model = &program.model;
    let states = model.states.iter().filter(|state| state.order == 0).map(|state| (&state.variable, &state.label));
    let quantities =
        model.quantities.iter().filter(|quantity| quantity.varies && !quantity.hidden && !quantity.remembered);
    let all = states.chain(quantities.map(|quantity| (&quantity.name, &quantity.label)));
    let line = |(name, label): (&String, &Option<String>)| {
        format!("\"{}\": {name} against {}\n", label.as_ref().unwrap_or(name), model.independent.name)
    };
    let block = |lines: &str| format!("\n```plots\n{lines}```\n");
    let can_be_plotted = |line: &String| document::open(&[source, &block(line)].concat(), &[]).diagnostics.is_empty();
    let lines: String = all.map(line).filter(can_be_plotted).take(PLOTS).collect();
    if lines.is_empty() { lines } else { block(&lines) }
}

/// Scene at the start, or else the first plot, as SVG; `None` if there is neither. The run is made in any case.
fn picture(program: Program) -> Result<Option<String>> {
    let end = program.until.unwrap_or(STEPS * Setup::of(&program).step);
    let mut play = Play::open(program);
    let scene = scene_svg(&mut play, &Palette::LIGHT.text.to_string());
    while play.change_run(|line, _| line.compute_on(end)) {}
    // A ball that bounces ever faster ends in an error, too, and is an example nevertheless.
    if let Some(error) = play.course().error().filter(|_| play.course().front() <= 0.0) {
        bail!("its run fails: {}", error.message(play.model()).english());
    }
    if scene.is_some() {
        return Ok(scene);
    }
    let Some(plot) = play.plots().list().into_iter().next() else { return Ok(None) };
    while play.change_plots(|plots, run| plots.work(run)) {}
    let settings = Settings { width: PLOT.0, height: PLOT.1, ..Settings::default() };
    play.layout_plot(plot.id, &settings);
    Ok(Some(play.plots().svg(plot.id, &settings, &Palette::LIGHT)))
}
