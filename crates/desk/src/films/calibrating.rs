//! Conversion of the user's calibration form to a map from px to m.

use crate::Refusal;
use crate::films::lengths::{CalibrationForm, LengthsForm, ParallaxForm};
use crate::films::record::Kept;
use crate::films::subject::inside;
use crate::films::{Films, no_film, refused};
use film::Plane;
use film::calibration::{CLICK, Calibration, Lengths, Parallax, Rectangle, Scale, by_marks};
use play::Play;
use units::number::typed::{quantity, shortened};
use units::{Dimension, Unit, Words, words};

impl Films {
    /// Sets the calibration form and updates the record of the film. `plane`: stored frame that shows the ruler; needed
    /// only for marks between two others, if they or the length have changed.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for an invalid length, marks too close together, a ruler without regular marks, or without an
    /// open film. Nothing changes then.
    pub fn calibrate(
        &mut self,
        play: &Play,
        form: CalibrationForm,
        plane: Option<&Plane>,
    ) -> Result<Option<Kept>, Refusal> {
        let calibration = self.calibration_of(play, &form, plane)?;
        let Some((_, work)) = self.current_mut() else { return Err(no_film(play)) };
        (work.form, work.calibration) = (form, calibration);
        Ok(Some(Kept { origin: true, offsets: false }))
    }

    pub(super) fn calibration_of(
        &self,
        play: &Play,
        form: &CalibrationForm,
        plane: Option<&Plane>,
    ) -> Result<Calibration, Refusal> {
        let (open, work) = self.current().ok_or_else(|| no_film(play))?;
        let size = open.clip.size();
        let points = form.origin.iter().chain(&form.axis);
        for point in points.chain(form.lengths.points()) {
            inside(*point, size).map_err(|refusal| refused(play, &refusal.words()))?;
        }
        let why = |refusal: film::calibration::Refusal| refused(play, &refusal.words());
        let lengths = match &form.lengths {
            LengthsForm::Pixels => Lengths::Pixels,
            same if *same == work.form.lengths => work.calibration.lengths,
            LengthsForm::Ruler { marks, length, intervals: 0 | 1 } => {
                Lengths::Scale(Scale::between(*marks, metres(play, length)?, CLICK).map_err(why)?)
            }
            LengthsForm::Ruler { marks, length, intervals } => {
                let plane = plane.filter(|plane| [plane.width(), plane.height()] == open.clip.plane_size());
                let plane = plane.ok_or_else(|| refused(play, &no_picture()))?;
                let length = metres(play, length)? / f64::from(*intervals);
                let ends = marks.map(|mark| open.clip.stored(mark));
                Lengths::Scale(by_marks(plane, ends, *intervals, length).map_err(why)?)
            }
            LengthsForm::Rectangle { corners, size: [width, height] } => {
                let size = [metres(play, width)?, metres(play, height)?];
                Lengths::Rectangle(Rectangle::new(*corners, size, CLICK).map_err(why)?)
            }
        };
        let parallax = form.parallax.as_ref().map(|parallax| parallax_of(play, parallax)).transpose()?;
        let origin = form.origin.unwrap_or([0.0, size[1]]);
        let level = Calibration { lengths, origin, parallax, ..Calibration::default() };
        let angle = form.axis.map_or(0.0, |axis| {
            let [x, y] = level.apply(axis);
            libm::atan2(y, x)
        });
        if !angle.is_finite() {
            return Err(why(film::calibration::Refusal::Close));
        }
        Ok(Calibration { angle, ..level })
    }
}

fn parallax_of(play: &Play, form: &ParallaxForm) -> Result<Parallax, Refusal> {
    let (behind, distance) = (metres(play, &form.behind)?, metres(play, &form.distance)?);
    if !(distance > 0.0 && distance + behind > 0.0) {
        return Err(refused(play, &words("The camera must be further away than the ruler is in front of the motion.")));
    }
    Ok(Parallax { behind, distance })
}

/// Length in m from text with a unit.
fn metres(play: &Play, typed: &str) -> Result<f64, Refusal> {
    if quantity(typed, &Unit::dimensionless(), play.basis().style()).is_ok() {
        let typed = shortened(typed);
        return Err(refused(play, &words!("{typed} has no unit. Enter a length such as 10 cm.")));
    }
    Ok(play.basis().read_value(typed, &Unit::si(Dimension::LENGTH))?)
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
