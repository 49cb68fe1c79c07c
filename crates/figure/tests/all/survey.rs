//! Word clouds and diverging bars: places, sizes and inert texts.

use figure::{Palette, ScaleRow, scale_bars, word_cloud};
use roxmltree::Document;

/// 120 words of 2 to 14 letters with weights that fall as those of a class of 40: 30, 21, 17 .. 2.
fn words() -> Vec<(String, usize)> {
    let letters = "simulaciónamortiguamientooscilacióngráficaslíquidotubo";
    let letters: Vec<char> = letters.chars().collect();
    let word = |index: usize| {
        let length = 2 + (index * 7) % 13;
        let text: String = (0..length).map(|place| letters[(index * 11 + place) % letters.len()]).collect();
        (text, (30.0 / ((index + 1) as f64).sqrt()).round().max(2.0) as usize)
    };
    (0..120).map(word).collect()
}

#[test]
fn a_cloud_holds_120_words_that_do_not_touch() {
    let words = words();
    let words: Vec<(&str, usize)> = words.iter().map(|(word, weight)| (word.as_str(), *weight)).collect();
    for (across, down) in [(752.0, 420.0), (640.0, 480.0)] {
        let cloud = word_cloud(&words, across, down);
        println!("{} of {} words placed in {across} x {down}", cloud.placed().len(), words.len());
        assert!(cloud.placed().len() >= 118);
        assert_eq!(word_cloud(&words, across, down), cloud, "the same places each time");
        // Rectangles by a narrower estimate than that of the layout: 0.3 em for each letter.
        let area = |word: &figure::PlacedWord| {
            let long = 0.3 * word.size * word.text.chars().count() as f64;
            (word.x, word.x + long, word.y - 0.7 * word.size, word.y)
        };
        for (index, one) in cloud.placed().iter().enumerate() {
            let (left, right, top, bottom) = area(one);
            assert!(left >= 0.0 && right <= across && top >= 0.0 && bottom <= down, "{one:?}");
            for other in &cloud.placed()[..index] {
                let (l, r, t, b) = area(other);
                assert!(right <= l || r <= left || bottom <= t || b <= top, "{one:?} {other:?}");
                assert!(other.size >= one.size, "the heaviest first");
            }
        }
    }
}

#[test]
fn clouds_of_odd_input_are_drawn() {
    assert!(word_cloud(&[], 100.0, 50.0).placed().is_empty());
    assert!(word_cloud(&[("incomprehensibilities", 3)], 40.0, 20.0).placed().is_empty(), "wider than the cloud");
    for (across, down) in [(0.0, 0.0), (-1.0, 5.0), (f64::NAN, 1.0), (1e9, f64::INFINITY)] {
        let _ = word_cloud(&[("a", 1), ("b", 0)], across, down);
    }
    let hostile = "<script>alert(1)</script>&\"";
    let svg = word_cloud(&[(hostile, 2)], 900.0, 300.0).svg(hostile, hostile, &Palette::DARK);
    let tree = Document::parse(&svg).unwrap();
    let texts: Vec<_> = tree.descendants().filter(|node| node.has_tag_name("text")).collect();
    assert_eq!(texts.iter().filter_map(|node| node.text()).collect::<Vec<_>>(), [hostile]);
    assert!(!tree.descendants().any(|node| node.has_tag_name("script")));
}

#[test]
fn bars_diverge_from_the_middle() {
    let rows = [
        ScaleRow { asked: "It was clear <b>", low: "no", high: "yes", counts: &[1, 2, 2, 3, 2] },
        ScaleRow { asked: "Again", low: "never", high: "always", counts: &[5, 0, 0, 5] },
    ];
    let svg = scale_bars(&rows, 600.0, "Scales", "", &Palette::LIGHT);
    let tree = Document::parse(&svg).unwrap();
    let number = |node: &roxmltree::Node<'_, '_>, name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let bars: Vec<(f64, f64)> = tree
        .descendants()
        .filter(|node| node.has_tag_name("rect"))
        .map(|node| (number(&node, "x"), number(&node, "width")))
        .collect();
    // The reach is 0.6 of the answers: 5 of 10 above the middle step, and half of its 2. A share of 1 is 500 pixels wide.
    let expected =
        [(100.0, 50.0), (150.0, 100.0), (250.0, 100.0), (350.0, 150.0), (500.0, 100.0), (50.0, 250.0), (300.0, 250.0)];
    assert_eq!(bars, expected);
    let texts: Vec<&str> =
        tree.descendants().filter(|node| node.has_tag_name("text")).filter_map(|node| node.text()).collect();
    assert!(
        texts.contains(&"It was clear <b>") && texts.iter().filter(|text| **text == "n = 10").count() == 2,
        "{texts:?}"
    );
    assert_eq!(scale_bars(&[], 600.0, "", "", &Palette::LIGHT).matches("<rect").count(), 0);
    let _ = scale_bars(&[ScaleRow { asked: "", low: "", high: "", counts: &[] }], 0.0, "", "", &Palette::LIGHT);
}
