//! Numbers of the read-outs that are rounding errors.

use crate::support::{go_on, open};

#[test]
fn what_cancels_is_shown_as_zero_and_what_is_small_is_not() {
    let mut play = open(
        "---\ntitle: Cancelling\nuntil: 10\n---\n\n```model\nindependent t in [s]\n\
         parameter L = 0.2 [m] in 0..1 \"Length\"\n\
         constant_zero = L*sin(pi) \"Cancels\"\n\
         moving_zero = (L + x) - x - L \"Cancels while it moves\"\n\
         small = 1e-12*L \"Small\"\n\
         x'' = -4 [1/s^2]*x\nx(0) = 0.1 [m] \"Place\"\nx'(0) = 0 [m/s]\n```\n",
        &[],
    );
    for _ in 0..3 {
        let shown = |label: &str, play: &mut play::Play| {
            let all = play.readouts();
            let one = all.iter().find(|readout| readout.label == label).unwrap();
            format!("{} {}", one.value, one.unit)
        };
        assert_eq!(shown("Cancels", &mut play), "0 m");
        let moving = shown("Cancels while it moves", &mut play);
        assert_eq!(moving.trim_matches(|c: char| !c.is_ascii_digit()).trim_matches(['0', '.']), "", "{moving}");
        assert_eq!(shown("Small", &mut play), "0.2 pm");
        go_on(&mut play, [0.37]);
    }
}
