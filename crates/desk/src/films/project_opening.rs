//! Opening the film of a Tracker project. Its times replace those of the record.

use crate::films::plan::by_hand;
use crate::films::project::ProjectFilm;
use crate::films::subject::{FilmedBody, MOST_BODIES, POINT_SIGMA, Subject};
use crate::films::work::Found;
use crate::films::{Films, no_film, refused};
use crate::records::record::Record;
use crate::{Changes, Refusal};
use analysis::finding::Finding;
use analysis::tracker::Remark;
use play::Play;
use units::order::sort_by_key;
use units::{Words, words};

impl Films {
    /// Removes and returns the film in the archive of the last imported project, for [`crate::Desk::open_project_film`].
    pub fn take_project_film(&mut self) -> (Option<ProjectFilm>, Changes) {
        (self.project.take(), Changes::NONE)
    }

    /// Gives the open film the positions, scale and used part of the project. Returns a remark on its times. Results of a
    /// fit do not remain valid for the new record.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if the project has features that are not supported.
    pub(crate) fn take_project(&mut self, play: &Play, own: &ProjectFilm) -> Result<Option<Remark>, Refusal> {
        let style = play.basis().style();
        let Some((open, work)) = self.current() else { return Err(no_film(play)) };
        let clip = &open.clip;
        let masses = own.clicks(clip);
        let form = own.form(clip, style).map_err(|why| refused(play, &why))?;
        let calibration = self.calibration_of(play, &form, None)?;
        let (part, factor) = (own.part(clip), own.factor(clip, work.stated_factor));
        let subject = match masses.as_slice() {
            [(_, clicks)] => Subject::Points { clicks: clicks.clone(), sigma: POINT_SIGMA },
            several => Subject::Bodies(
                several
                    .iter()
                    .map(|(mass, clicks)| FilmedBody { keys: own.keys(mass, clicks), radius: None })
                    .collect(),
            ),
        }
        .settled();
        if masses.len() > MOST_BODIES {
            return Err(refused(
                play,
                &words!(
                    "it has {count} masses, and at most {MOST_BODIES} are followed in a film",
                    count = Words::same(masses.len().to_string())
                ),
            ));
        }
        subject.check(clip).map_err(|refusal| refused(play, &refusal.words()))?;
        let mut found = Found { factor: factor.unwrap_or(work.stated_factor), ..Found::default() };
        for (_, clicks) in &masses {
            let one = by_hand(clicks, POINT_SIGMA, clip, found.factor);
            found.tracks.extend(one.tracks);
            found.frames.extend(one.frames);
        }
        sort_by_key(&mut found.frames, |frame| frame.0);
        found.frames.dedup_by_key(|frame| frame.0);
        let ends = clip.ends(part);
        let step = own.project.clip.stretch().is_none().then_some(1000.0 * own.project.clip.interval);
        let times = step.map(|step| Remark::FilmTimes { milliseconds: Some(step).filter(|step| step.is_finite()) });
        let note = times.clone().map(|times| Words::each(move |language| times.text(language)));
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        open.notes.extend(note);
        (work.form, work.calibration, work.subject, work.found) = (form, calibration, subject, Some(found));
        (work.part, work.ends, work.factor, work.record) = (part, ends, factor, Some(own.record()));
        Ok(times)
    }
}

/// Findings to keep before those of the film: the remark on its times, and remarks on the project that still apply to its
/// record.
pub(crate) fn remarks(record: Option<&Record>, times: Option<Remark>) -> Vec<Finding> {
    let of_project = |finding: &&Finding| match finding {
        Finding::Project(remark) => !matches!(
            remark,
            Remark::ConstantStep { .. }
                | Remark::FrameNumbers { .. }
                | Remark::NoClipControl { .. }
                | Remark::NoClip
                | Remark::ListedTimes { .. }
                | Remark::Calibration { .. }
        ),
        _ => false,
    };
    let findings = record.map_or(&[][..], Record::findings);
    times.map(Finding::Project).into_iter().chain(findings.iter().filter(of_project).cloned()).collect()
}
