//! What was found in a film, in words.

use super::clock::displayed;
use film::calibration::{Calibration, Lengths};
use film::table::Table;
use film::tracking::{Exposure, Track};
use units::number::{fixed, plain};
use units::{Words, words};

/// Frames that are listed one by one.
const LISTED: usize = 8;

/// What a person should know about tracks and their lengths. `shown` are the times of all frames of the film, in seconds.
pub fn notes(tracks: &[Track], table: &Table, calibration: &Calibration, shown: &[f64]) -> Vec<Words> {
    let mut notes = Vec::new();
    for (number, track) in (1..).zip(tracks) {
        let found = of_track(track, table, shown);
        let named = |words: Words| {
            words!(
                "track {number}: {what}",
                "trayectoria {number}: {what}",
                number = Words::same(number.to_string()),
                what = words
            )
        };
        notes.extend(found.into_iter().map(|words| if tracks.len() > 1 { named(words) } else { words }));
    }
    if let Lengths::Scale(scale) = &calibration.lengths {
        notes.push(words!(
            "scale: a pixel is {pixel} mm, with a standard error of {sigma} % that all lengths share",
            "escala: un píxel mide {pixel} mm, con un error estándar del {sigma} % común a todas las longitudes",
            pixel = significant(1e3 * scale.pixel, 4),
            sigma = significant(100.0 * scale.relative_sigma, 2)
        ));
    }
    notes
}

fn of_track(track: &Track, table: &Table, shown: &[f64]) -> Vec<Words> {
    let mut notes = Vec::new();
    if track.points.is_empty() {
        notes.push(words("it was found in no frame", "no se encontró en ningún fotograma"));
    }
    match track.exposure {
        Some(Exposure::Seconds(seconds)) => {
            notes.push(words!("exposure: {ms} ms", "exposición: {ms} ms", ms = milliseconds(seconds)));
        }
        Some(Exposure::Under(seconds)) => notes.push(words!(
            "exposure: under {ms} ms, too short to smear the picture",
            "exposición: menos de {ms} ms, demasiado corta para emborronar la imagen",
            ms = milliseconds(seconds)
        )),
        None => {}
    }
    // One that was stated has no error, and stands in the arguments.
    if let Some(readout) = track.readout.filter(|readout| readout.sigma > 0.0) {
        notes.push(words!(
            "rolling shutter: {ms} ± {sigma} ms from the first row to the last; times are corrected for it",
            "obturador rodante: {ms} ± {sigma} ms de la primera fila a la última; los tiempos están corregidos",
            ms = milliseconds(readout.seconds),
            sigma = milliseconds(readout.sigma)
        ));
    }
    let doubtful: Vec<usize> = track.points.iter().filter(|point| point.doubtful).map(|point| point.frame).collect();
    if !doubtful.is_empty() {
        let (count, of) = (doubtful.len(), track.points.len());
        let listed: Vec<String> = doubtful.iter().take(LISTED).map(usize::to_string).collect();
        let listed = listed.join(", ") + if count > LISTED { ", ..." } else { "" };
        notes.push(words!(
            "in doubt: {count} of {of} frames, {listed} (counted from 0); look at them before you use their rows",
            "dudosos: {count} de {of} fotogramas, {listed} (contados desde 0); míralos antes de usar sus filas"
        ));
    }
    if let Some(frame) = track.lost {
        let time = shown.get(frame).copied().unwrap_or(f64::NAN);
        // Rows go on where a key frame finds it again, and for other bodies.
        let then = match track.points.last() {
            Some(last) if last.frame > frame => words("it is found again later", "se vuelve a encontrar después"),
            _ if table.frames.len() > track.points.len() => {
                words("later rows have no value for it", "las filas posteriores no tienen valor para él")
            }
            _ => words("later frames have no row", "los fotogramas posteriores no tienen fila"),
        };
        notes.push(words!(
            "lost from frame {frame} on (counted from 0; {time} s of the film), where nothing resembles what was clicked; {then}",
            "perdido desde el fotograma {frame} (contado desde 0; {time} s del vídeo), donde nada se parece a lo elegido; {then}",
            frame = Words::same(frame.to_string()),
            time = displayed(time),
            then = then
        ));
    }
    notes
}

fn milliseconds(seconds: f64) -> Words {
    Words::each(|language| fixed(1e3 * seconds, 1, language.style()))
}

fn significant(value: f64, digits: usize) -> Words {
    Words::each(|language| plain(value, digits, language.style()))
}
