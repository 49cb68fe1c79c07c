//! Kept runs beside the present one: in legends, in CSV, in figures; and lengths in the drawing.

use crate::support::{go_on, open, utube};
use figure::{Point, Settings};
use play::{Play, PlotId};

#[test]
fn kept_runs_are_named_in_legend_csv_and_figure_and_left_out_of_pins() {
    let mut play = utube();
    go_on(&mut play, [1.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    go_on(&mut play, [1.0]);
    let legend = play.plots().legend(PlotId::at(0));
    let labels: Vec<&str> = legend.iter().map(|entry| entry.label.as_str()).collect();
    assert_eq!(labels, ["initial settings", "y", "y′"]);
    assert_eq!(legend[0].style, figure::Style::Faded(0));
    let csv = play.plots_to_front().csv(PlotId::at(0));
    let head = csv.lines().next().unwrap();
    assert!(head.starts_with("t (initial settings) [s],y (initial settings) [m],"), "{head}");
    assert!(head.ends_with(",t [s],y [m],t [s],y′ [m/s]"), "{head}");
    // The kept run is shorter: the last row contains the present run alone.
    assert!(csv.trim_end().lines().last().unwrap().starts_with(",,,,"), "{csv}");
    assert!(
        play.plots_to_front()
            .svg(PlotId::at(0), &Settings::default(), &figure::Palette::LIGHT)
            .contains(">initial settings<")
    );
    let panel = play.layout_plot(PlotId::at(0), &Settings::default()).unwrap().panel;
    let at = Point { x: panel.x + panel.width / 20.0, y: panel.y + panel.height / 2.0 };
    let hovered = play.change_plots(|plots, run| plots.hover(run, PlotId::at(0), at)).unwrap();
    assert_eq!(hovered.samples.len(), 4);
    assert_eq!(play.plots().own_samples(PlotId::at(0), hovered).samples.len(), 2);
}

#[test]
fn a_label_that_the_plot_gives_stands_in_the_legend() {
    let source = "---\nlanguage: en\n---\n```model\nx = 1 [m]*cos(1 [1/s]*t) \"Distance of the body\"\n```\n\
        ```plots\n\"Motion\": x, x' \"Speed\", 2*x against t\n```\n";
    let spanish = "---\nlanguage: es\n---\n```translations\n\"Distance of the body\" = \"Distancia del cuerpo\"\n\"Motion\" = \"Movimiento\"\n\"Speed\" = \"Velocidad\"\n```\n";
    let mut play = open(source, &[spanish]);
    go_on(&mut play, [1.0]);
    let labels =
        |play: &Play| play.plots().legend(PlotId::at(0)).into_iter().map(|entry| entry.label).collect::<Vec<_>>();
    assert_eq!(labels(&play), ["x", "Speed", "2·x"]);
    let svg = play.plots_to_front().svg(PlotId::at(0), &Settings::default(), &figure::Palette::LIGHT);
    assert!(svg.contains(">Speed<") && svg.contains(">x<"), "{svg}");
    // Read-outs and columns use the name.
    assert!(play.plots_to_front().csv(PlotId::at(0)).starts_with("t [s],x [m],t [s],x′ [m/s],"));
    play.set_language("es");
    assert_eq!(labels(&play), ["x", "Velocidad", "2·x"]);
}

#[test]
fn an_axis_has_the_label_of_its_only_quantity() {
    let source = "---\nlanguage: en\n---\n```model\nx = 1 [m]*cos(1 [1/s]*t) \"Distance\"\nv = x' \"Speed\"\n```\n\
        ```plots\n\"Motion\": x against t\n\"Both\": x, v against t\n\"Plane\": v against x\n```\n";
    let spanish = "---\nlanguage: es\n---\n```translations\n\"Distance\" = \"Distancia\"\n\"Speed\" = \"Rapidez\"\n\
        \"Motion\" = \"Movimiento\"\n\"Both\" = \"Ambas\"\n\"Plane\" = \"Plano\"\n```\n";
    let mut play = open(source, &[spanish]);
    let shows = |play: &mut Play, plot: usize, texts: &[&str]| {
        let svg = play.plots_to_front().svg(PlotId::at(plot), &Settings::default(), &figure::Palette::LIGHT);
        for text in texts {
            assert!(svg.contains(&format!(">{text}<")), "{text}: {svg}");
        }
    };
    shows(&mut play, 0, &["Time t [s]", "Distance x [m]"]);
    shows(&mut play, 1, &["Time t [s]", "x [m]", "v [m/s]"]);
    shows(&mut play, 2, &["Distance x [m]", "Speed v [m/s]"]);
    play.set_language("es");
    shows(&mut play, 0, &["Tiempo t [s]", "Distancia x [m]"]);
}

#[test]
fn a_length_in_the_drawing_is_that_of_its_handles() {
    // 40 scene units are 1 m.
    assert_eq!(utube().grips().length(40.0).as_deref(), Some("1 m"));
}

#[test]
fn a_length_in_the_drawing_is_that_of_its_frame_where_no_handle_changes_one() {
    let source = r#"---
title: A pendulum
language: en
---

It swings.

```model
parameter l = 2 [m] in 1..4 "Length"

theta'' = -9.8 [m/s^2]/l*sin(theta)

theta(0)  = 0.1 [rad] "Angle"
theta'(0) = 0 [rad/s] "Angular velocity"
```

```scene
<svg viewBox="0 0 200 100">
  <frame x="-pi..pi" y="-1..1" box="0 0 10 10"/>
  <frame x="-l..l" y="-l/2..l/2">
    <bob at="(l*sin(theta), -l*cos(theta)/2)" r="9px" drag="theta"/>
  </frame>
</svg>
```
"#;
    let document = document::open(source, &[]).document.unwrap();
    let mut play = play::Play::open(document.program);
    // 4 m are 200 units wide.
    assert_eq!(play.grips().length(50.0).as_deref(), Some("1 m"));
    assert_eq!(play.grips().scale().map(|(metres, _)| metres), Some(0.02));
}
