//! Projects of Tracker of other kinds: without a clip or its control, sets of tabs, pictures in place of a film.

use crate::tracker::{FIXED, MOVING, PIXELS, read, refused, shown, zip};
use analysis::tracker::TrackerError;
use units::Language::{English, Spanish};

/// A project without the object of a property: `videoclip`, `clipcontrol`.
fn without(project: &str, name: &str) -> String {
    let begin = project.find(&format!("    <property name=\"{name}\" type=\"object\">\n")).expect("it is there");
    let end = begin + project[begin..].find("\n    </property>\n").expect("it ends") + "\n    </property>\n".len();
    format!("{}{}", &project[..begin], &project[end..])
}

#[test]
fn a_project_without_a_clip_control_is_read_without_an_invented_duration() {
    let uncontrolled = without(PIXELS, "clipcontrol");
    let expected = "\
frame []: 0.00000 1.00000 2.00000
x [px]: 1.00000 2.00000 3.00000
y [px]: 10.00000 20.00000 25.00000
- the project does not state how long a frame lasts, and no duration is assumed: the first column is the number of the frame, and not a time; set the frame rate in Tracker and save the project
- the project has no scale: positions are in pixels, y upwards; the origin is at the pixel (10.0; 100.0), the x axis at 0.00°
- `frames`, the unit of frame, is not known; until one is stated, its numbers have none
";
    let contents = read(uncontrolled.clone().into());
    assert_eq!(shown(&contents, English), expected);
    // Frame numbers are not read as seconds.
    assert_eq!(contents.import.table.columns[0].origin.unit.unknown(), Some("frames"));
    for none in [PIXELS.replace("name=\"delta_t\"", "name=\"rate_t\""), PIXELS.replace(">33.333333333333336<", ">0<")] {
        assert_eq!(shown(&read(none.into()), English), expected);
    }
    // A sequence of pictures states its own frame duration.
    let pictures =
        uncontrolled.replace("a00.jpg</property>", "a00.jpg</property><property name=\"delta_t\">40.0</property>");
    let pictures = shown(&read(pictures.into()), English);
    assert!(
        pictures.starts_with("t [s]: 0.00000 0.04000 0.08000\n") && pictures.contains("the one of its pictures"),
        "{pictures}"
    );
    // Listed times are used unchanged; without listed times, those of the film are needed.
    let listed = without(MOVING, "clipcontrol");
    let found = shown(&read(listed.clone().into()), Spanish);
    assert!(
        found.starts_with("t [s]: 0.00000 0.06670 0.11670 0.15000\n") && found.contains("se tomaron tal cual"),
        "{found}"
    );
    let still = shown(&read(listed.replace("66.7,100.0,150.0,183.3", "0.0,0.0,0.0,0.0").into()), English);
    assert!(
        still.starts_with("frame []: 1.00000 3.00000") && still.contains("in the tab Measure of the page"),
        "{still}"
    );
    // Without a video clip all marked frames are used, and there is no film.
    let unclipped = shown(&read(without(PIXELS, "videoclip").into()), Spanish);
    assert!(
        unclipped.starts_with("t [s]: 0.00000 0.03333 0.06667\n") && unclipped.contains("no tiene corte"),
        "{unclipped}"
    );
}

#[test]
fn a_set_of_tabs_names_its_files() {
    let tab = |path: &str, relative: &str| {
        format!(
            "<property name=\"[0]\" type=\"array\" class=\"[Ljava.lang.String;\">\
             <property name=\"[0]\" type=\"string\">{path}</property>\
             <property name=\"[1]\" type=\"string\">{relative}</property></property>"
        )
    };
    let tabs = |tabs: &str| {
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<object class=\"org.opensourcephysics.cabrillo.tracker.TFrame\">\n\
             <property name=\"tabs\" type=\"array\" class=\"[[Ljava.lang.String;\">{tabs}</property></object>"
        )
    };
    let error = refused(&tabs(&[tab("C:/lab/fall.trk", "fall.trk"), tab("C:/films/b.mp4", "")].concat()));
    assert_eq!(error, TrackerError::Tabs { files: vec!["fall.trk".into(), "C:/films/b.mp4".into()] });
    let message = error.message(English);
    assert_eq!(message, "this is a set of tabs of Tracker, and not a project; it names fall.trk, C:/films/b.mp4");
    assert_eq!((error.hint(English), error.hint(Spanish)), ("open them one by one", "ábrelos uno por uno"));
    assert!(matches!(refused(&tabs("")), TrackerError::NotAProject { .. }));
    assert!(matches!(refused(&tabs(&tab("a", "b").repeat(5000))), TrackerError::Tabs { files } if files.len() == 200));
    // In an archive the project beside it is read.
    let both = read(zip(&[("all.trk", &tabs(&tab("", "b.trk"))), ("b.trk", PIXELS)]));
    assert_eq!(both.import.table.rows(), 3);
}

#[test]
fn a_film_that_cannot_be_tracked_is_not_recommended() {
    let unmarked = |project: &str| project.replace("tracker.PointMass\"", "tracker.Vector\"");
    let hint = |project: &str| refused(&unmarked(project)).hint(English);
    assert!(hint(FIXED).contains("track its film: in the tab Measure of the page"));
    let gif = FIXED.replace("media.xuggle.XuggleVideo", "media.gif.GifVideo");
    for project in [PIXELS, &without(FIXED, "videoclip"), &gif] {
        assert!(!hint(project).contains("track its film: in the tab Measure of the page"), "{}", hint(project));
    }
    let remarks = shown(&read(gif.into()), English);
    assert!(remarks.contains("constant step") && !remarks.contains("meniscus track"), "{remarks}");
}
