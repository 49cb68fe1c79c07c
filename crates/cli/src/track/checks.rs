//! What is refused before the first frame is decoded.

use super::arguments::{Place, Point, Track as Arguments, TrackFormat};
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
    Ok(())
}

/// Where the result of each film goes: `None` is the standard output.
pub fn outputs(arguments: &Arguments, format: TrackFormat) -> Result<Vec<Option<PathBuf>>, Failure> {
    let folder = arguments.output.as_deref();
    if arguments.films.len() < 2 {
        return Ok(vec![arguments.output.clone()]);
    }
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        let name = folder.display();
        return Err(Failure::in_words(
            words!("--output {name}: there is no such folder", "--output {name}: no hay tal carpeta"),
            words(
                "for several films --output is a folder, in which each gets its table; make it first",
                "para varios vídeos --output es una carpeta, en la que cada uno recibe su tabla; créala antes",
            ),
        ));
    }
    let targets: Vec<PathBuf> = arguments.films.iter().map(|film| beside(film, folder, format)).collect();
    let mut sorted = targets.clone();
    sorted.sort();
    if let Some([same, _]) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        let name = same.display();
        return Err(Failure::in_words(
            words!("two films would write {name}", "dos vídeos escribirían {name}"),
            words("leave one of them out, or rename it", "excluye uno de ellos o cámbiale el nombre"),
        ));
    }
    Ok(targets.into_iter().map(Some).collect())
}

/// The file beside a film, or in a folder.
fn beside(film: &Path, folder: Option<&Path>, format: TrackFormat) -> PathBuf {
    let mut name = film.file_name().unwrap_or_default().to_owned();
    name.push(match format {
        TrackFormat::Csv => ".csv",
        TrackFormat::Xlsx => ".xlsx",
        TrackFormat::Json => ".json",
    });
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
