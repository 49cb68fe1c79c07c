//! Conversion of the user's calibration form to a map from px to m.

use crate::films::lengths::{CalibrationForm, LengthsForm, ParallaxForm};
use crate::films::record::Kept;
use crate::films::subject::inside;
use crate::{Desk, Refusal, number};
use film::Plane;
use film::calibration::{CLICK, Calibration, Lengths, Parallax, Rectangle, Scale, by_marks};
use units::{Dimension, Unit, Words, words};

impl Desk {
    /// Sets the calibration form and updates the record of the film. `plane`: stored frame that shows the ruler; needed
    /// only for marks between two others, if they or the length have changed.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for an invalid length, marks too close together, a ruler without regular marks, or without an
    /// open film. Nothing changes then.
    pub fn calibrate_film(&mut self, form: CalibrationForm, plane: Option<&Plane>) -> Result<(), Refusal> {
        let calibration = self.calibration_of(&form, plane)?;
        let Some((_, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        (work.form, work.calibration) = (form, calibration);
        self.film_changed(Kept { origin: true, offsets: false })
    }

    pub(super) fn calibration_of(&self, form: &CalibrationForm, plane: Option<&Plane>) -> Result<Calibration, Refusal> {
        let (open, work) = self.films.current().ok_or_else(|| self.no_film())?;
        let size = open.clip.size();
        let points = form.origin.iter().chain(&form.axis);
        for point in points.chain(form.lengths.points()) {
            inside(*point, size).map_err(|refusal| self.film_refusal(&refusal.words()))?;
        }
        let refused = |refusal: film::calibration::Refusal| self.film_refusal(&refusal.words());
        let lengths = match &form.lengths {
            LengthsForm::Pixels => Lengths::Pixels,
            same if *same == work.form.lengths => work.calibration.lengths,
            LengthsForm::Ruler { marks, length, intervals: 0 | 1 } => {
                Lengths::Scale(Scale::between(*marks, self.length(length)?, CLICK).map_err(refused)?)
            }
            LengthsForm::Ruler { marks, length, intervals } => {
                let plane = plane.filter(|plane| [plane.width(), plane.height()] == open.clip.plane_size());
                let plane = plane.ok_or_else(|| self.film_refusal(&no_picture()))?;
                let length = self.length(length)? / f64::from(*intervals);
                let ends = marks.map(|mark| open.clip.stored(mark));
                Lengths::Scale(by_marks(plane, ends, *intervals, length).map_err(refused)?)
            }
            LengthsForm::Rectangle { corners, size: [width, height] } => {
                let size = [self.length(width)?, self.length(height)?];
                Lengths::Rectangle(Rectangle::new(*corners, size, CLICK).map_err(refused)?)
            }
        };
        let parallax = form.parallax.as_ref().map(|parallax| self.parallax(parallax)).transpose()?;
        let origin = form.origin.unwrap_or([0.0, size[1]]);
        let level = Calibration { lengths, origin, parallax, ..Calibration::default() };
        let angle = form.axis.map_or(0.0, |axis| {
            let [x, y] = level.apply(axis);
            libm::atan2(y, x)
        });
        if !angle.is_finite() {
            return Err(refused(film::calibration::Refusal::Close));
        }
        Ok(Calibration { angle, ..level })
    }

    fn parallax(&self, form: &ParallaxForm) -> Result<Parallax, Refusal> {
        let (behind, distance) = (self.length(&form.behind)?, self.length(&form.distance)?);
        if !(distance > 0.0 && distance + behind > 0.0) {
            return Err(
                self.film_refusal(&words("The camera must be further away than the ruler is in front of the motion."))
            );
        }
        Ok(Parallax { behind, distance })
    }

    /// Length in m from text with a unit.
    fn length(&self, typed: &str) -> Result<f64, Refusal> {
        let without_unit = number::parse(typed, self.play.style()).is_some_and(|(_, rest)| rest.is_empty());
        if without_unit {
            let typed: String = typed.trim().chars().take(40).collect();
            return Err(self.film_refusal(&words!("{typed} has no unit. Enter a length such as 10 cm.")));
        }
        Ok(self.play.basis().read_value(typed, &Unit::si(Dimension::LENGTH))?)
    }

    pub(crate) fn film_refusal(&self, why: &Words) -> Refusal {
        Refusal::Film { why: why.text(self.play.language()).into_owned() }
    }

    pub(crate) fn no_film(&self) -> Refusal {
        self.film_refusal(&words("No film is open. Open one first."))
    }
}

impl LengthsForm {
    fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Pixels => &[],
            Self::Ruler { marks, .. } => marks,
            Self::Rectangle { corners, .. } => corners,
        }
    }
}

fn no_picture() -> Words {
    words("The marks between the two need the picture of a frame. Wait until it is shown, or use the two marks alone.")
}
