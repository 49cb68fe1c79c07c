//! Places of the elements of a drawing in its picture.

use super::drawing::{document_of, framed};
use crate::editing::edit::documents;
use document::drawing::{Grip, Sketch, read};
use document::edit::{Measure, apply, shift};
use engine::Readings;

/// Places of the elements of a drawing at the start of a run.
fn located(text: &str) -> Vec<Option<document::drawing::Located>> {
    let sketch = Sketch::read(text).unwrap();
    let mut readings = Readings::new(&sketch.model, &sketch.nodes);
    let parameters: Vec<f64> = sketch.model.parameters.iter().map(|parameter| parameter.value).collect();
    let values = readings.at(&parameters, &[0.02], 0.0, &[0.02]).to_vec();
    let ground = sketch.ground(&values);
    let expected = if ground.framed { ([200.0, 150.0], 1000.0, "cm") } else { ([0.0, 0.0], 1.0, "") };
    assert_eq!((ground.origin, ground.scale, ground.unit.as_str()), expected);
    (0..sketch.drawing.items.len()).map(|number| sketch.locate(number, &values)).collect()
}

#[test]
fn grips_stand_where_the_picture_has_them() {
    let near = |one: [f64; 2], other: [f64; 2]| libm::hypot(one[0] - other[0], one[1] - other[1]) < 1e-9;
    let cases = [
        ("<spring from=\"(0, 5 [cm])\" to=\"(a, y)\"/>", Grip::Beginning, [200.0, 100.0]),
        ("<spring from=\"(0, 5 [cm])\" to=\"(a, y)\"/>", Grip::End, [220.0, 130.0]),
        ("<block at=\"(0, y)\" size=\"(4 [cm], 30px)\"/>", Grip::Corner, [220.0, 145.0]),
        ("<block at=\"(0, y)\" size=\"(4 [cm], 30px)\" turn=\"90 [deg]\"/>", Grip::Corner, [215.0, 110.0]),
        ("<rect x=\"0\" y=\"0\" width=\"4 [cm]\" height=\"2 [cm]\"/>", Grip::Corner, [240.0, 130.0]),
        ("<circle cx=\"1 [cm]\" cy=\"y\" r=\"5px\"/>", Grip::Edge, [215.0, 130.0]),
        ("<line x1=\"0\" y1=\"0\" x2=\"a\" y2=\"y\"/>", Grip::End, [220.0, 130.0]),
    ];
    for (element, grip, expected) in cases {
        let places = located(&framed(element));
        let place = places[1].as_ref().unwrap();
        assert_eq!((place.unit.as_str(), place.scale, &place.paths), ("cm", 1000.0, &vec![vec![0, 0]]), "{element}");
        let (_, found) = place.grips.iter().find(|(one, _)| *one == grip).unwrap();
        assert!(near(*found, expected), "{element}: {found:?} for {expected:?}");
    }
    // Outside frames, beside a title, in a group, repeated.
    let places = located(&document_of(
        "<title>T</title>\n  <rect x=\"5\" y=\"{10*phi}\" width=\"20\" height=\"10\"/>\n  <g><bob repeat=\"i in 1..3\" at=\"(10*i, 20)\" r=\"4\"/></g>",
    ));
    let [rect, group, bob] = [0, 1, 2].map(|number| places[number].as_ref().unwrap());
    assert_eq!(rect.grips[1], (Grip::Corner, [25.0, 15.0]));
    assert_eq!((&rect.paths, &group.paths), (&vec![vec![1]], &vec![vec![2]]));
    assert_eq!(bob.paths, [vec![2, 0], vec![2, 1], vec![2, 2]]);
    assert!(near(bob.grips[1].1, [14.0, 20.0]));
}

/// Moving a grip by a distance moves it by that distance in the picture, for all elements of all documents.
#[test]
fn grips_of_the_gallery_follow_the_hand() {
    let mut moved = 0;
    for text in documents() {
        let Some(drawing) = read(&document::read(&text)) else { continue };
        let Some(sketch) = Sketch::read(&text) else { continue };
        let parameters: Vec<f64> = sketch.model.parameters.iter().map(|parameter| parameter.value).collect();
        let states = vec![0.0; sketch.model.states.len()];
        let values = |sketch: &Sketch| {
            Readings::new(&sketch.model, &sketch.nodes).at(&parameters, &states, 0.0, &states).to_vec()
        };
        let before = values(&sketch);
        let mut seen = Vec::new();
        for number in 0..drawing.items.len() {
            let Some(place) = sketch.locate(number, &before) else { continue };
            let item = &drawing.items[number];
            let step = 8.0 / place.scale;
            let measure = Measure { unit: place.unit.clone(), step: step / 1e6, scale: place.scale };
            for (grip, at) in place.grips.iter().filter(|(grip, _)| matches!(grip, Grip::Beginning | Grip::End)) {
                // One element of each kind per document, because reading the document again takes time.
                if seen.contains(&(item.kind.name, *grip)) {
                    continue;
                }
                seen.push((item.kind.name, *grip));
                let Ok(edits) = shift(&document::read(&text), number, *grip, [step, step], &measure) else { continue };
                let after = Sketch::read(&apply(&text, &edits).unwrap()).unwrap();
                let place = after.locate(number, &values(&after)).unwrap();
                let (_, now) = place.grips.iter().find(|(one, _)| one == grip).unwrap();
                let up = if item.framed { -8.0 } else { 8.0 };
                let away = libm::hypot(now[0] - at[0] - 8.0, now[1] - at[1] - up);
                assert!(away < 1e-3, "{text}: {} {grip:?} {at:?} {now:?}", item.kind.name);
                moved += 1;
            }
        }
    }
    assert!(moved > 20, "{moved}");
}
