//! Opening the film of a Tracker project. Its times replace those of the record.

use crate::films::identity::FilmIdentity;
use crate::films::opening::FilmOpening;
use crate::films::plan::by_hand;
use crate::films::project::ProjectFilm;
use crate::films::record::Kept;
use crate::films::subject::{FilmedBody, MOST_BODIES, POINT_SIGMA, Subject};
use crate::films::work::Found;
use crate::{Desk, Refusal};
use analysis::finding::Finding;
use analysis::tracker::Remark;
use units::order::sort_by_key;
use units::{Words, words};

impl Desk {
    /// Removes and returns the film in the archive of the last imported project, for [`Desk::open_project_film`].
    pub fn take_project_film(&mut self) -> Option<ProjectFilm> {
        self.films.project.take()
    }

    /// Opens the film of a project in place of the open one, with positions, scale and used part of the project. The
    /// record of the project gets the times of the film. If the film is known, its stored work is continued instead.
    ///
    /// # Errors
    ///
    /// As [`Desk::open_film`], and [`Refusal::Film`] if the project has features that are not supported. No film is
    /// open then, and the record of the project is unchanged.
    pub fn open_project_film(
        &mut self,
        own: &ProjectFilm,
        identity: FilmIdentity,
        container: film::containers::Film,
    ) -> Result<FilmOpening, Refusal> {
        let opening = self.open_film(identity, container)?;
        if opening == FilmOpening::TakenUp {
            return Ok(opening);
        }
        let taken = self.take_project(own);
        if taken.is_err() {
            self.close_film();
        }
        taken.map(|()| opening)
    }

    fn take_project(&mut self, own: &ProjectFilm) -> Result<(), Refusal> {
        let style = self.play.style();
        let Some((open, work)) = self.films.current() else { return Err(self.no_film()) };
        let clip = &open.clip;
        let masses = own.clicks(clip);
        let form = own.form(clip, style).map_err(|why| self.film_refusal(&why))?;
        let calibration = self.calibration_of(&form, None)?;
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
            return Err(self.film_refusal(&words!(
                "it has {count} masses, and at most {MOST_BODIES} are followed in a film",
                count = Words::same(masses.len().to_string())
            )));
        }
        subject.check(clip).map_err(|refusal| self.film_refusal(&refusal.words()))?;
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
        let Some((open, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        open.notes.extend(note);
        (work.form, work.calibration, work.subject, work.found) = (form, calibration, subject, Some(found));
        (work.part, work.ends, work.factor, work.record) = (part, ends, factor, Some(own.record));
        self.keep_remarks(own.record, times)
    }

    /// Replaces the record of the project by that of the film. Remarks that still apply are kept.
    fn keep_remarks(&mut self, id: u32, times: Option<Remark>) -> Result<(), Refusal> {
        let of_project = |finding: &Finding| match finding {
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
        let before: Vec<Finding> = times.map(Finding::Project).into_iter().collect();
        let before = before.into_iter().chain(
            self.record(id)
                .into_iter()
                .flat_map(|record| record.findings.iter().filter(|one| of_project(one)).cloned()),
        );
        let before: Vec<Finding> = before.collect();
        self.film_changed(Kept { origin: false, offsets: false })?;
        if let Some(record) = self.data.records.iter_mut().find(|record| record.id == id) {
            record.findings.splice(0..0, before);
        }
        Ok(())
    }
}
