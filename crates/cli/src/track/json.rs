//! Result of tracking as one JSON object.

use super::arguments::{Body, Given, Place, Surface, Track as Arguments};
use super::clock::Clock;
use super::opened::Opened;
use film::calibration::{Calibration, Lengths};
use film::table::{Quantity, Table};
use film::tracking::{Exposure, Known, Track, doubts};
use serde_json::{Map, Value, json};
use units::{Language, Words};

/// Whole result. Lengths in the unit `unit`, times and exposures in s, clicks in px of the upright picture.
pub fn object(
    film: &Opened,
    arguments: &Arguments,
    clock: &Clock,
    (tracks, table, calibration): (&[Track], &Table, &Calibration),
    notes: &[Words],
    language: Language,
) -> String {
    let notes: Vec<_> = notes.iter().map(|note| note.text(language)).collect();
    let [width, height] = film.upright_size();
    let scale = match &calibration.lengths {
        Lengths::Scale(scale) => json!({ "metres_per_pixel": scale.pixel, "relative_stderr": scale.relative_sigma }),
        _ => Value::Null,
    };
    let size = film.upright_size();
    let doubtful = doubts(tracks, size);
    let rows = tracks.iter().zip(&table.quantities).enumerate();
    let tracks: Vec<Value> = rows
        .map(|(number, (track, quantities))| {
            let doubt = |frame: usize| {
                let at = doubtful.binary_search_by_key(&(frame, number), |one| (one.frame, one.track));
                at.ok().and_then(|at| doubtful.get(at)).map(|one| one.doubt.code())
            };
            of_track(track, quantities, table, (&doubt, size))
        })
        .collect();
    let object = json!({
        "film": film.path.display().to_string(),
        "picture": [width, height],
        "frames": film.times.len(),
        "settings": settings(arguments),
        "time_factor": clock.factor,
        "time_unit": "s",
        "unit": table.unit,
        "scale": scale,
        "notes": notes,
        "tracks": tracks,
    });
    format!("{object:#}\n")
}

fn of_track(
    track: &Track,
    quantities: &[Quantity],
    table: &Table,
    (doubt, size): (&dyn Fn(usize) -> Option<&'static str>, [f64; 2]),
) -> Value {
    let rows = table.frames.iter().enumerate();
    let points = rows.filter_map(|(row, frame)| {
        let at = track.points.binary_search_by_key(frame, |point| point.frame).ok()?;
        let point = track.points.get(at)?;
        let mut object = Map::new();
        let mut add = |name: &str, value: Value| drop(object.insert(name.to_owned(), value));
        add("frame", json!(frame));
        add("t", json!(table.times.get(row)));
        for quantity in quantities {
            // Column names without track numbers, since each track is a separate object.
            let name = quantity.name.split('_').next().unwrap_or_default();
            add(name, json!(quantity.values.get(row)));
            add(&format!("sigma_{name}"), json!(quantity.sigmas.get(row)));
        }
        add("score", json!(point.score));
        add("doubtful", json!(point.doubtful));
        add("doubt", json!(doubt(*frame)));
        Some(Value::Object(object))
    });
    let points: Vec<Value> = points.collect();
    json!({
        "exposure": match track.exposure {
            Some(Exposure::Seconds(seconds)) => json!({ "seconds": seconds }),
            Some(Exposure::Under(seconds)) => json!({ "under": seconds }),
            None => Value::Null,
        },
        "readout": track.readout.map(|readout| json!({ "seconds": readout.seconds, "stderr": readout.sigma })),
        "camera_shift": track.shift.map(|shift| json!({ "pixels": shift.pixels })),
        "radius": track.outline.map(|outline| outline.radius),
        "lost_from_frame": track.lost,
        "lost_because": track.loss(size).map(|loss| loss.reason.code()),
        "points": points,
    })
}

fn settings(arguments: &Arguments) -> Value {
    let known = |given: &Option<Given>| match given {
        Some(Given(Known::Seconds(seconds))) => json!(seconds),
        _ => json!("auto"),
    };
    let click = |place: &Place| json!({ "position": place.position, "time": place.time });
    // First click, and the others under their name on the page.
    let clicked = |places: &[Place], others: &str| {
        let mut object = Map::new();
        if let Some((first, further)) = places.split_first() {
            object.insert("position".to_owned(), json!(first.position));
            object.insert("time".to_owned(), json!(first.time));
            object.insert(others.to_owned(), further.iter().map(click).collect());
        }
        object
    };
    let surface = |surface: &Surface| Value::Object(clicked(&surface.places, "anchors"));
    let body = |body: &Body| {
        let mut object = clicked(&body.places, "keys");
        object.insert("radius".to_owned(), json!(body.radius));
        Value::Object(object)
    };
    json!({
        "surfaces": arguments.surface.iter().map(surface).collect::<Vec<_>>(),
        "tubes": arguments.tube,
        "bodies": arguments.body.iter().map(body).collect::<Vec<_>>(),
        "scale": arguments.scale.as_ref().map(|ruler| json!({ "marks": ruler.marks, "metres": ruler.length })),
        "origin": arguments.origin,
        "marks": arguments.marks.as_ref().map(|marks| &marks.0),
        "rate": arguments.rate,
        "from": arguments.from,
        "until": arguments.until,
        "exposure": known(&arguments.exposure),
        "readout": known(&arguments.readout),
    })
}
