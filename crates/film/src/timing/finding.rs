//! What was noticed about the times of a film, in words.

use units::number::{fixed, plain};
use units::{Words, words};

/// Something a person should know about the times of their film. Rates in frames a second, times in seconds.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// The frames come at a regular rate.
    Rate {
        /// The rate.
        rate: f64,
        /// Standard deviation of the intervals.
        spread: f64,
    },
    /// The rate changes during the film.
    Variable {
        /// The mean rate.
        rate: f64,
        /// One over the longest interval.
        slowest: f64,
        /// One over the shortest interval.
        fastest: f64,
    },
    /// The container stores whole milliseconds.
    Rounded,
    /// Frames are missing.
    Gap {
        /// How many.
        missing: usize,
        /// The time of the frame before.
        time: f64,
    },
    /// Further gaps, which are not listed.
    MoreGaps {
        /// How many gaps.
        gaps: usize,
        /// How many frames are missing in them.
        missing: usize,
    },
    /// Frames with the time of the frame before.
    Doubled {
        /// How many.
        count: usize,
        /// The first such time.
        time: f64,
    },
    /// The container states another rate than its times have.
    Stated {
        /// The one that it states.
        stated: f64,
        /// The one of the times.
        measured: f64,
    },
    /// The camera took frames at another rate than they are shown.
    SlowMotion {
        /// The rate at which they were taken.
        captured: f64,
        /// The rate at which they are shown.
        shown: f64,
        /// By which times are divided.
        factor: f64,
    },
    /// Frames that repeat the picture before.
    Repeated {
        /// How many.
        count: usize,
        /// Of how many frames.
        of: usize,
    },
}

impl Finding {
    /// It in a sentence.
    pub fn words(&self) -> Words {
        let number = |value: f64| Words::each(|language| fixed(value, 2, language.style()));
        match *self {
            Self::Rate { rate, spread } => words!(
                "{rate} frames/s, intervals spread by {spread} ms",
                "{rate} fotogramas/s, con una dispersión de los intervalos de {spread} ms",
                rate = number(rate),
                spread =
                    Words::each(|language| fixed(spread * 1e3, if spread < 9.5e-5 { 2 } else { 1 }, language.style()))
            ),
            Self::Variable { rate, slowest, fastest } => words!(
                "variable frame rate: {rate} frames/s in the mean, from {slowest} to {fastest}; each frame keeps its own time",
                "frecuencia variable: {rate} fotogramas/s de media, de {slowest} a {fastest}; cada fotograma conserva su propio tiempo",
                rate = number(rate),
                slowest = number(slowest),
                fastest = number(fastest)
            ),
            Self::Rounded => words(
                "the file stores times in whole milliseconds, a standard error of 0.3 ms for each frame",
                "el archivo guarda los tiempos en milisegundos enteros, un error estándar de 0,3 ms para cada fotograma",
            ),
            Self::Gap { missing: 1, time } => {
                words!("a gap of 1 frame at {time} s", "falta 1 fotograma en {time} s", time = number(time))
            }
            Self::Gap { missing, time } => words!(
                "a gap of {missing} frames at {time} s",
                "faltan {missing} fotogramas en {time} s",
                missing = Words::same(missing.to_string()),
                time = number(time)
            ),
            Self::MoreGaps { gaps, missing } => words!(
                "further gaps: {gaps}, with {missing} missing frames in all",
                "más huecos: {gaps}, en los que faltan {missing} fotogramas en total"
            ),
            Self::Doubled { count: 1, time } => words!(
                "a frame has the same time as the one before, {time} s; leave one of them out",
                "un fotograma tiene el mismo tiempo que el anterior, {time} s; excluye uno de los dos",
                time = number(time)
            ),
            Self::Doubled { count, time } => words!(
                "{count} frames have the same time as the one before, the first at {time} s; leave them out",
                "{count} fotogramas tienen el mismo tiempo que el anterior, el primero en {time} s; exclúyelos",
                count = Words::same(count.to_string()),
                time = number(time)
            ),
            Self::Stated { stated, measured } => words!(
                "the file states {stated} frames/s, its times give {measured}; the times are used",
                "el archivo declara {stated} fotogramas/s y sus tiempos dan {measured}; se usan los tiempos",
                stated = number(stated),
                measured = number(measured)
            ),
            Self::SlowMotion { captured, shown, factor } if factor >= 1.0 => words!(
                "slow motion: taken at {captured} frames/s, shown at {shown}; times are divided by {factor}. Check it against a known time, such as a fall",
                "cámara lenta: grabado a {captured} fotogramas/s y mostrado a {shown}; los tiempos se dividen por {factor}. Compruébalo con un tiempo conocido, como el de una caída",
                captured = number(captured),
                shown = number(shown),
                factor = Words::each(|language| plain(factor, 4, language.style()))
            ),
            Self::SlowMotion { captured, shown, factor } => words!(
                "time lapse: taken at {captured} frames/s, shown at {shown}; times are multiplied by {factor}",
                "cámara rápida: grabado a {captured} fotogramas/s y mostrado a {shown}; los tiempos se multiplican por {factor}",
                captured = Words::each(|language| plain(captured, 3, language.style())),
                shown = number(shown),
                factor = Words::each(|language| plain(1.0 / factor, 4, language.style()))
            ),
            Self::Repeated { count, of } => words!(
                "{count} of {of} frames repeat the picture before, with wrong times; leave them out, or use the original film",
                "{count} de {of} fotogramas repiten la imagen anterior, con tiempos erróneos; exclúyelos o usa el vídeo original"
            ),
        }
    }
}
