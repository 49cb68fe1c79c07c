use super::{Draws, Grid, GridFault, Seat};

/// Four ranges of usual documents, with few and many values, and numbers of values that eight does not divide.
fn grids() -> [(&'static str, Grid); 4] {
    [("b", (0.01, 0.05, 0.002)), ("L", (20.0, 60.0, 0.5)), ("gamma", (0.2, 0.9, 0.05)), ("x_0", (-3.5, 3.5, 1.0))]
        .map(|(name, (low, high, step))| (name, Grid::new(low, high, step).unwrap()))
}

fn draws<'a>(assignment: &str, grids: &'a [(&'static str, Grid)]) -> Draws<'a> {
    Draws::new(assignment, grids.iter().map(|(name, grid)| (*name, grid)))
}

#[test]
fn forty_seats_are_spread_evenly_and_all_different() {
    let grids = grids();
    for number in 0..500 {
        let seats = draws(&format!("course-{number}"), &grids).seats(5);
        assert_eq!(seats.len(), 40);
        for (place, (name, grid)) in grids.iter().enumerate() {
            let mut quarters = [0; 4];
            for seat in &seats {
                assert!(seat[place] < grid.count());
                // In integers: 0.02 lies exactly on a quarter of 0.01..0.05.
                quarters[(4 * seat[place] / (grid.count() - 1)).min(3) as usize] += 1;
            }
            assert_eq!(quarters, [10; 4], "course-{number}, {name}");
        }
        let mut different = seats.clone();
        different.sort();
        different.dedup();
        assert_eq!(different.len(), 40, "course-{number}");
    }
}

/// Two parameters with 21 and 15 values give 315 pairs. Draws without comparison would repeat some in nearly every class.
#[test]
fn seats_differ_as_long_as_there_are_values() {
    let grids = grids();
    let two: Vec<_> = [0, 2].map(|place| grids[place].clone()).into();
    let mut repeated = 0;
    for number in 0..200 {
        let draws = draws(&format!("{number}"), &two);
        let mut seats = draws.seats(5);
        let mut plain: Vec<_> = (0..5).flat_map(|block| draws.block(block, 0)).collect();
        for seats in [&mut seats, &mut plain] {
            seats.sort();
            seats.dedup();
        }
        assert_eq!(seats.len(), 40, "{number}");
        repeated += usize::from(plain.len() < 40);
    }
    assert!(repeated > 100, "the comparison is needed: {repeated} of 200");
}

#[test]
fn one_seat_has_the_values_of_the_list() {
    let grids = grids();
    let draws = draws("tube-2026", &grids);
    let list = draws.seats(13);
    for (number, values) in (1..).zip(&list) {
        assert_eq!(draws.seat(Seat::new(number).unwrap()), *values);
    }
    let last = draws.seat(Seat::new(Seat::MOST).unwrap());
    assert!(last.iter().zip(&grids).all(|(index, (_, grid))| *index < grid.count()));
}

/// The values of these seats are published with documents: they must never change.
#[test]
fn values_stay_as_they_are() {
    let grids = grids();
    let values = |assignment: &str, seat: u32| -> Vec<f64> {
        let indices = draws(assignment, &grids).seat(Seat::new(seat).unwrap());
        indices.into_iter().zip(&grids).map(|(index, (_, grid))| grid.value(index)).collect()
    };
    let published = [("tube-2026", 1), ("tube-2026", 40), ("tube-2027", 1), ("tube-2026", u32::MAX)];
    let found = published.map(|(assignment, seat)| values(assignment, seat));
    assert_eq!(
        found,
        [[0.032, 29.5, 0.75, 3.5], [0.044, 31.0, 0.2, -3.5], [0.018, 53.0, 0.8, -2.5], [0.044, 22.5, 0.85, -2.5]]
    );
}

#[test]
fn a_learner_has_one_seat_above_the_numbered_ones() {
    let seat = |learner: &str| Seat::of_learner("tube-2026", learner);
    assert_eq!(seat("ana@example.org"), seat("ana@example.org"));
    assert_ne!(seat("ana@example.org"), Seat::of_learner("tube-2027", "ana@example.org"));
    let mut seats: Vec<Seat> = (0..2000).map(|number| seat(&format!("learner {number}"))).collect();
    assert!(seats.iter().all(|seat| seat.number() > Seat::MOST));
    seats.sort();
    seats.dedup();
    assert!(seats.len() >= 1999, "one pair in 2000 is improbable, two are an error");
}

#[test]
fn values_are_those_of_their_digits() {
    for (low, high, step) in
        [(0.01, 0.05, 0.002), (1e-9, 9e-9, 1e-12), (-1.05, 2.0, 0.05), (2e15, 9e15, 1e12), (0.1, 0.9, 0.1)]
    {
        let grid = Grid::new(low, high, step).unwrap();
        assert_eq!((grid.value(0), grid.value(grid.count() - 1)), (low, high));
        for index in 0..grid.count() {
            // A power of ten is exact, so the text has the digits of the value.
            let digits = format!("{:.1$}", grid.value(index), grid.decimals as usize);
            assert_eq!(digits.parse(), Ok(grid.value(index)));
        }
    }
    let grid = Grid::new(0.01, 0.05, 0.002).unwrap();
    let values: Vec<f64> = (0..5).map(|index| grid.value(index)).collect();
    assert_eq!(values, [0.01, 0.012, 0.014, 0.016, 0.018]);
}

#[test]
fn ranges_without_a_grid_are_refused() {
    for ((low, high, step), fault) in [
        ((1.0, 1.0, 0.1), GridFault::Empty),
        ((2.0, 1.0, 0.1), GridFault::Empty),
        ((0.0, 1.0, 0.0), GridFault::Empty),
        ((0.0, 1.0, -0.1), GridFault::Empty),
        ((0.0, 1.0, 0.3), GridFault::Uneven),
        ((0.0, 6.0, 1.0), GridFault::TooFew),
        ((0.0, 1_000_000.0, 1.0), GridFault::TooMany),
        ((0.0, 1.0, 1e-30), GridFault::TooExact),
        ((0.0, 1e300, 1e299), GridFault::TooExact),
        ((0.123_456_789_012_345_67, 1.0, 0.1), GridFault::TooExact),
        ((f64::NAN, 1.0, 0.1), GridFault::TooExact),
        ((0.0, f64::INFINITY, 0.1), GridFault::TooExact),
    ] {
        assert_eq!(Grid::new(low, high, step), Err(fault), "{low}..{high} step {step}");
    }
    assert_eq!(Grid::new(0.0, 7.0, 1.0).unwrap().count(), Grid::LEAST);
    assert_eq!(Grid::new(1.0, 1_000_000.0, 1.0).unwrap().count(), Grid::MOST);
}

#[test]
fn seats_are_whole_numbers_from_one() {
    for text in ["", "0", "-1", "+1", "1.0", "seven", "4294967296", " 7", "٧"] {
        assert_eq!(text.parse::<Seat>(), Err(()), "{text}");
    }
    assert_eq!("007".parse(), Ok(Seat::new(7).unwrap()));
}
