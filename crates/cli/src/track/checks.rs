//! What is refused before the first frame is decoded.

use super::arguments::{Place, Point, Track as Arguments, TrackFormat};
use super::clock;
use super::opened::{Opened, refused_with};
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use units::words;

/// Surfaces and bodies that are tracked at once.
const MOST_SURFACES: usize = 2;
const MOST_BODIES: usize = 4;

/// Refuses what no film could satisfy.
pub fn arguments(arguments: &Arguments) -> Result<(), Failure> {
    let (surfaces, bodies, tubes) = (arguments.surface.len(), arguments.body.len(), arguments.tube.len());
    if surfaces + bodies == 0 {
        return Err(Failure::in_words(
            words("it is not said what to track", "no se dice qué seguir"),
            words(
                "click a liquid's surface, --surface X,Y, or a body, --body X,Y, in pixels of the first frame",
                "indica la superficie de un líquido, --surface X,Y, o un cuerpo, --body X,Y, en píxeles del primer fotograma",
            ),
        ));
    }
    if surfaces > MOST_SURFACES || bodies > MOST_BODIES {
        return Err(Failure::in_words(
            words("too many surfaces or bodies", "demasiadas superficies o cuerpos"),
            words!(
                "track at most {MOST_SURFACES} surfaces or {MOST_BODIES} bodies at once, and the others in a second call",
                "sigue como máximo {MOST_SURFACES} superficies o {MOST_BODIES} cuerpos a la vez, y los demás en otra llamada"
            ),
        ));
    }
    if tubes > 0 && tubes != surfaces {
        return Err(Failure::in_words(
            words!(
                "--tube is given {tubes} times for {surfaces} surfaces",
                "--tube aparece {tubes} veces para {surfaces} superficies"
            ),
            words(
                "write --tube once for each --surface, in the same order, or not at all for upright tubes",
                "escribe --tube una vez por cada --surface, en el mismo orden, o ninguna si los tubos son verticales",
            ),
        ));
    }
    clock::part(arguments)?;
    Ok(())
}

/// Where the table and the report of a film go.
#[derive(Clone, Debug, Default)]
pub struct Targets {
    /// Without one the standard output.
    pub table: Option<PathBuf>,
    /// Without one there is none.
    pub report: Option<PathBuf>,
}

/// Where the results of each film go.
pub fn outputs(arguments: &Arguments, format: TrackFormat) -> Result<Vec<Targets>, Failure> {
    let (output, report) = (arguments.output.as_deref(), arguments.report.as_deref());
    if let [_] = arguments.films.as_slice() {
        if let Some(report) = report.filter(|report| !is_page(report)) {
            let name = report.display();
            return Err(Failure::in_words(
                words!("--report {name}: a report is an HTML page", "--report {name}: un informe es una página HTML"),
                words("end its name in .html", "termina su nombre en .html"),
            ));
        }
        if report.is_some() && report == output {
            return Err(Failure::in_words(
                words("--output and --report name one file", "--output y --report nombran un mismo archivo"),
                words("give the table another name", "da otro nombre a la tabla"),
            ));
        }
        return Ok(vec![Targets { table: arguments.output.clone(), report: arguments.report.clone() }]);
    }
    let ending = match format {
        TrackFormat::Csv => ".csv",
        TrackFormat::Xlsx => ".xlsx",
        TrackFormat::Json => ".json",
    };
    let tables = several(arguments, "--output", output, ending)?;
    let reports = match report {
        None => vec![None; tables.len()],
        Some(_) => several(arguments, "--report", report, ".html")?.into_iter().map(Some).collect(),
    };
    Ok(tables.into_iter().map(Some).zip(reports).map(|(table, report)| Targets { table, report }).collect())
}

fn is_page(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    ["html", "htm"].iter().any(|page| ending.eq_ignore_ascii_case(page))
}

/// A file for each film, beside it or in a folder that an option names.
fn several(
    arguments: &Arguments,
    option: &'static str,
    folder: Option<&Path>,
    ending: &str,
) -> Result<Vec<PathBuf>, Failure> {
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        let name = folder.display();
        return Err(Failure::in_words(
            words!("{option} {name}: there is no such folder", "{option} {name}: no hay tal carpeta"),
            words!(
                "for several films {option} is a folder, in which each gets its file; make it first",
                "para varios vídeos {option} es una carpeta, en la que cada uno recibe su archivo; créala antes"
            ),
        ));
    }
    let targets: Vec<PathBuf> = arguments.films.iter().map(|film| beside(film, folder, ending)).collect();
    let mut sorted = targets.clone();
    sorted.sort();
    if let Some([same, _]) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        let name = same.display();
        return Err(Failure::in_words(
            words!("two films would write {name}", "dos vídeos escribirían {name}"),
            words("leave one of them out, or rename it", "excluye uno de ellos o cámbiale el nombre"),
        ));
    }
    Ok(targets)
}

/// The file beside a film, or in a folder.
fn beside(film: &Path, folder: Option<&Path>, ending: &str) -> PathBuf {
    let mut name = film.file_name().unwrap_or_default().to_owned();
    name.push(ending);
    folder.map_or_else(|| film.with_file_name(&name), |folder| folder.join(&name))
}

/// Refuses points outside the picture.
pub fn points(film: &Opened, arguments: &Arguments) -> Result<(), Failure> {
    let [width, height] = film.upright_size();
    let clicked = |places: &[Place]| places.iter().map(|place| place.position).collect::<Vec<Point>>();
    let named = |name: &'static str, points: Vec<Point>| points.into_iter().map(move |point| (name, point));
    let all = named("--surface", arguments.surface.iter().flat_map(|surface| clicked(&surface.places)).collect())
        .chain(named("--tube", arguments.tube.concat()))
        .chain(named("--body", arguments.body.iter().flat_map(|body| clicked(&body.places)).collect()))
        .chain(named("--marks", arguments.marks.iter().flat_map(|marks| marks.0.clone()).collect()))
        .chain(named("--scale", arguments.scale.iter().flat_map(|ruler| ruler.marks).collect()));
    for (name, [x, y]) in all {
        if !((0.0..=width).contains(&x) && (0.0..=height).contains(&y)) {
            let why = words!(
                "{name} {x},{y} lies outside the picture, which is {width} pixels wide and {height} high",
                "{name} {x},{y} está fuera de la imagen, que mide {width} píxeles de ancho y {height} de alto"
            );
            let hint = words(
                "points count from the top left corner of the upright picture, x to the right and y down",
                "los puntos se cuentan desde la esquina superior izquierda de la imagen derecha, x hacia la derecha e y hacia abajo",
            );
            return Err(refused_with(&film.path, why, hint));
        }
    }
    Ok(())
}
