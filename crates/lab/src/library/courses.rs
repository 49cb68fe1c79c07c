//! Courses of the library: the simulations that the page carries, in the order in which a course takes them, with their levels.

use units::{Words, words};

/// Level of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    School,
    FirstYear,
    Advanced,
}

impl Level {
    /// All levels, the easiest first.
    pub const ALL: [Self; 3] = [Self::School, Self::FirstYear, Self::Advanced];

    /// Name of the level.
    pub fn words(self) -> Words {
        match self {
            Self::School => words("School"),
            Self::FirstYear => words("First year"),
            Self::Advanced => words("Advanced"),
        }
    }
}

/// A course.
pub struct Course {
    pub title: Words,
    /// Common subject of its simulations.
    pub note: Words,
    /// File names of its simulations, with their levels.
    simulations: &'static [(&'static str, Level)],
}

use Level::{Advanced, FirstYear, School};

/// The courses. The browser tests of the library ask that each shipped simulation stands in one of them.
pub static COURSES: [Course; 8] = [
    Course {
        title: words("Oscillations 1"),
        note: words("one thing swings: period, amplitude, energy"),
        simulations: &[
            ("tube.md", School),
            ("mass-on-spring.md", School),
            ("pendulum.md", School),
            ("ruchardt.md", FirstYear),
            ("utube.md", FirstYear),
        ],
    },
    Course {
        title: words("Oscillations 2"),
        note: words("damped, driven, coupled"),
        simulations: &[
            ("driven-oscillator.md", FirstYear),
            ("coupled-oscillators.md", FirstYear),
            ("utube-push.md", FirstYear),
            ("utube-arms.md", FirstYear),
            ("stick-slip.md", FirstYear),
            ("van-der-pol.md", Advanced),
        ],
    },
    Course {
        title: words("Waves"),
        note: words("modes of strings and chains, sums of sines"),
        simulations: &[("string.md", FirstYear), ("chain.md", FirstYear), ("fourier.md", FirstYear)],
    },
    Course {
        title: words("Mechanics"),
        note: words("flight, friction, collisions, orbits"),
        simulations: &[
            ("projectile.md", School),
            ("inclined-plane.md", School),
            ("bouncing-ball.md", School),
            ("kepler.md", FirstYear),
            ("three-bodies.md", Advanced),
        ],
    },
    Course {
        title: words("Heat and flow"),
        note: words("what evens out"),
        simulations: &[("cooling.md", School), ("two-tanks.md", School), ("gas.md", FirstYear)],
    },
    Course {
        title: words("Electricity"),
        note: words("circuits and charges"),
        simulations: &[("rlc.md", FirstYear), ("charge.md", FirstYear)],
    },
    Course {
        title: words("Chance and chaos"),
        note: words("what cannot be foreseen, and why"),
        simulations: &[
            ("random-walk.md", FirstYear),
            ("decay-chain.md", FirstYear),
            ("logistic-map.md", FirstYear),
            ("double-pendulum.md", Advanced),
            ("driven-pendulum.md", Advanced),
            ("lorenz.md", Advanced),
        ],
    },
    Course {
        title: words("Populations"),
        note: words("growth, prey and infection"),
        simulations: &[("epidemic.md", School), ("predator-prey.md", FirstYear)],
    },
];

/// Place of a file in the courses: index of the course, index in the course, and level. `None` for files of no course.
pub fn place_of(file: &str) -> Option<(usize, usize, Level)> {
    COURSES.iter().enumerate().find_map(|(course, Course { simulations, .. })| {
        let place = simulations.iter().position(|(own, _)| *own == file)?;
        Some((course, place, simulations.get(place)?.1))
    })
}
