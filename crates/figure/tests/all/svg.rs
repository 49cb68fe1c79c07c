//! The SVG file: well-formed, accessible, harmless.

use figure::{Axis, Palette, Plot, Series, Settings, Style, layout};

fn svg(title: &str, label: &str) -> String {
    let (x, y) = ([0.0, 1.0, 2.0], [0.0, 0.5, -0.25]);
    let plot = Plot {
        title,
        description: "Displacement against time",
        x: Axis { label: "t", unit: "s", ..Axis::default() },
        y: vec![Axis { label, unit: "m", ..Axis::default() }],
        series: vec![
            Series { label, x: &x, y: &y, present: Some((1.0, 0.5)), ..Series::default() },
            Series { label: "kept", style: Style::Kept(2), x: &x, y: &y, ..Series::default() },
            Series { label: "data", style: Style::Points, x: &x, y: &y, ..Series::default() },
        ],
        ordered: true,
        marker: Some(1.0),
        ..Plot::default()
    };
    layout(&plot, &Settings { width: 400.0, height: 250.0, ..Settings::default() }).svg(&Palette::LIGHT)
}

#[test]
fn it_is_well_formed_and_says_what_it_shows() {
    let text = svg("Oscillation", "y");
    let document = roxmltree::Document::parse(&text).unwrap();
    let root = document.root_element();
    assert_eq!(root.tag_name().namespace(), Some("http://www.w3.org/2000/svg"));
    assert_eq!(root.attribute("role"), Some("img"));
    assert_eq!(root.attribute("viewBox"), Some("0 0 400 250"));
    let child = |name: &str| root.children().find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", name)));
    assert_eq!(child("title").unwrap().text(), Some("Oscillation"));
    assert_eq!(child("desc").unwrap().text(), Some("Displacement against time"));
    assert_eq!(child("rect").unwrap().attribute("fill"), Some("#ffffff"));
    let texts: Vec<&str> =
        root.children().filter(|node| node.tag_name().name() == "text").filter_map(|node| node.text()).collect();
    for expected in ["Oscillation", "t [s]", "y [m]", "−0.2", "1.0", "kept", "data"] {
        assert!(texts.contains(&expected), "{expected} in {texts:?}");
    }
    assert_eq!(root.descendants().filter(|node| node.tag_name().name() == "circle").count(), 5);
    let dashed = root.children().filter(|node| node.has_attribute("stroke-dasharray")).count();
    assert_eq!(dashed, 2, "the line and its sample in the legend");
}

#[test]
fn texts_are_escaped() {
    let hostile = "</text><script>alert('1')</script>&amp;\u{0}\u{1b}";
    let text = svg(hostile, hostile);
    assert!(!text.contains("<script"));
    let document = roxmltree::Document::parse(&text).unwrap();
    let title = document.root_element().first_element_child().unwrap();
    assert_eq!(title.text(), Some("</text><script>alert('1')</script>&amp;\u{fffd}\u{fffd}"));
}
