//! Curves drawn by the reader.

use crate::support::{bits, go_on, open, set, state};
use play::{Announcement, DrawingView, Extent, Play, Refusal};

const PUSHED: &str = "---
title: Pushed
language: en
step: 0.05 [s]
---

```model
parameter m = 2 [kg] in 1..9 \"Mass\"
table F(t) in [N] \"Push\" drawn in -10..10 until 10 [s]
smooth table c(x) in [m/s^2] drawn in 0..4 from -2 [m] until 3 [m] { -2 1  3 1 }
m*x'' = F(t) - m*c(x)
x(0) = 0 [m] \"Displacement\"
x'(0) = 0 [m/s]
a = F(t)/m \"Acceleration\"
```

```plots
\"Displacement\": x, a against t
```
";
const PUSHED_ES: &str = "---
language: es
translates: pushed.md
---

```translations
\"Mass\" = \"Masa\"
\"Push\" = \"Empujón\"
\"Displacement\" = \"Desplazamiento\"
\"Acceleration\" = \"Aceleración\"
```
";

fn pushed() -> Play {
    open(PUSHED, &[])
}

fn curve(play: &Play, index: usize) -> DrawingView {
    play.basis().drawn_curve(play.course(), index).unwrap()
}

/// Draws a constant height.
fn level(play: &mut Play, index: usize, height: f64) {
    let heights = vec![height; curve(play, index).heights.len()];
    play.change_settings(|settings| settings.draw(index, &heights)).unwrap();
}

fn by_link(play: &Play) -> Play {
    let mut other = pushed();
    other.restore(&play.share()).unwrap_or_else(|refusal| panic!("{}: {refusal:?}", play.share()));
    assert_eq!(other.share(), play.share());
    assert_eq!(bits(&other), bits(play));
    other
}

#[test]
fn the_field_shows_range_and_curve() {
    let mut play = open(PUSHED, &[PUSHED_ES]);
    let views = play.basis().drawn_curves(play.course());
    assert_eq!(views.len(), 2);
    let push = &views[0];
    assert_eq!((push.label.as_str(), push.symbol.as_str(), push.zero), ("Push", "F(t)", Some(0.5)));
    assert_eq!(push.values, ["−10 N", "10 N"]);
    assert_eq!(push.arguments, ["0 s", "10 s"]);
    assert!(push.is_default && push.heights.iter().all(|height| *height == 0.5));
    assert_eq!(views[1].label, "c(x)");
    assert_eq!(play.basis().drawn_text(0, 10, 0.75), "t = 2 s: 5 N");
    play.set_language("es");
    assert_eq!(play.basis().drawn_curves(play.course())[0].label, "Empujón");
}

#[test]
fn a_constant_push_gives_the_parabola() {
    let mut play = pushed();
    level(&mut play, 1, 0.0);
    go_on(&mut play, [1.0]);
    level(&mut play, 0, 0.75);
    assert_eq!(play.course().time(), 0.0, "the run starts again");
    assert_eq!(std::iter::from_fn(|| play.take_announcement()).last(), Some(Announcement::Drawn(0)));
    go_on(&mut play, [4.0]);
    assert!((state(&play)[0] - 2.5 * 16.0 / 2.0).abs() < 1e-9);
    // The displayed value follows, too: the acceleration is 5 N / 2 kg.
    assert_eq!(crate::support::readout(&mut play, "a"), "2.500");
    by_link(&play);
}

#[test]
fn the_link_is_short_and_repeats_it() {
    let mut play = pushed();
    let heights: Vec<f64> = (0..51).map(|point| f64::from(point) / 50.0).collect();
    play.change_settings(|settings| settings.draw(0, &heights)).unwrap();
    set(&mut play, "m", 3.0);
    go_on(&mut play, [2.0]);
    let link = play.share();
    assert!(link.starts_with("1&p=m:3&a=F:AABQCgDwFAGQ") && link.len() < 140, "{link}");
    let other = by_link(&play);
    assert_eq!(curve(&other, 0), curve(&play, 0));
    assert!(play.share_within(Extent::Start).starts_with("1&p=m:3&a=F:"), "a film of the run has its curves");
    for wrong in
        ["a=F:AAA", "a=G:AAAA", "a=F", &format!("a=F:{}", "_".repeat(104)), &format!("a=F:{}", "A".repeat(105))]
    {
        let refused = pushed().restore(&format!("1&{wrong}&t=1"));
        assert!(matches!(refused, Err(Refusal::PartlyRestored { .. })), "{wrong}");
    }
}

#[test]
fn kept_runs_and_the_ghost_keep_theirs() {
    let mut play = pushed();
    level(&mut play, 0, 1.0);
    go_on(&mut play, [2.0]);
    play.change_run(|line, basis| line.keep(basis)).unwrap();
    assert_eq!(play.time_line().kept(play.basis())[0].name, "Push");
    let kept = play.values().csv();
    level(&mut play, 0, 0.0);
    assert!(play.time_line().has_ghost());
    go_on(&mut play, [2.0]);
    let other = by_link(&play);
    assert_eq!(other.time_line().kept(other.basis()).len(), 1);
    assert_ne!(play.values().csv(), kept);
    // Both kept runs draw the same curve.
    play.change_run(|line, _| line.clear_ghost());
    let drawn = |mut play: Play| play.plots_to_front().csv(play::PlotId::at(0));
    assert_eq!(drawn(play), drawn(other));
}

#[test]
fn clearing_puts_the_document_s_curve_back_and_can_be_undone() {
    let mut play = pushed();
    level(&mut play, 1, 1.0);
    let drawn = curve(&play, 1);
    assert!(!drawn.is_default);
    play.change_settings(|settings| settings.clear_drawing(1));
    assert!(curve(&play, 1).is_default);
    assert_eq!(curve(&play, 1).heights[7], 0.25);
    let number = play.removals().number().unwrap();
    assert!(play.undo(number));
    assert_eq!(curve(&play, 1), drawn);
    play.change_settings(|settings| settings.restore_defaults());
    assert_eq!(play.share(), "");
    assert!(play.undo(play.removals().number().unwrap()));
    assert_eq!(curve(&play, 1), drawn);
}

#[test]
fn what_is_drawn_is_bounded() {
    let mut play = pushed();
    let mut heights = vec![7.0; 51];
    heights[0] = -3.0;
    play.change_settings(|settings| settings.draw(0, &heights)).unwrap();
    assert_eq!(curve(&play, 0).heights[..2], [0.0, 1.0]);
    assert!(play.change_settings(|settings| settings.draw(0, &[1.0; 50])).is_err());
    assert!(play.change_settings(|settings| settings.draw(0, &[f64::NAN; 51])).is_err());
    assert!(play.change_settings(|settings| settings.draw(2, &[1.0; 51])).is_err());
}

#[test]
fn a_changed_document_keeps_what_fits() {
    let mut play = pushed();
    level(&mut play, 0, 0.75);
    level(&mut play, 1, 0.0);
    go_on(&mut play, [2.0]);
    let drawn = curve(&play, 0);
    let changed = PUSHED.replace("0..4 from", "1..4 from").replace("m = 2 [kg]", "m = 4 [kg]");
    play.replace_program(document::open(&changed, &[]).document.unwrap().program);
    assert_eq!(curve(&play, 0), drawn);
    assert!(curve(&play, 1).is_default);
    let told = std::iter::from_fn(|| play.take_announcement()).last();
    assert_eq!(told, Some(Announcement::Replaced(vec!["c(x)".to_owned()])));
    let mut by_hand = open(&changed, &[]);
    by_hand.restore(&play.share()).unwrap();
    assert_eq!(bits(&by_hand), bits(&play));
}
