//! Filming the simulation of the open document.

use crate::films::opening::FilmOpening;
use crate::films::recipe::{CameraSettings, FilmRecipe, hash};
use crate::films::truth::{FilmTruth, TruthComparison, compared};
use crate::films::{Films, ShownFilms, refused};
use crate::{Changes, Refusal};
use play::{Extent, Play};
use units::{Dimension, Words, words};

impl Films {
    /// Opens the film of a recipe with this number of frames in place of the open film. Work on a film of the same
    /// recipe is continued.
    ///
    /// # Errors
    ///
    /// As [`Films::open`].
    pub fn open_filmed(
        &mut self,
        play: &Play,
        recipe: FilmRecipe,
        frames: usize,
        truth: FilmTruth,
    ) -> Result<(FilmOpening, Changes), Refusal> {
        let (opening, changes) = self.open(play, recipe.identity(), recipe.film(frames))?;
        if let Some((open, work)) = self.current_mut() {
            open.truth = Some(truth);
            work.recipe = Some(recipe);
        }
        // Each recipe is another film, even with the same name.
        let opening = if opening == FilmOpening::SameName { FilmOpening::New } else { opening };
        Ok((opening, changes))
    }
}

impl ShownFilms<'_> {
    /// Initial settings of the virtual camera.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if the simulation has no scene or no time in seconds.
    pub fn usual_camera(self) -> Result<CameraSettings, Refusal> {
        let program = self.play.program();
        if program.scene(self.play.basis().tag()).is_none() {
            return Err(refused(self.play, &words("This document has no scene, so there is nothing to film.")));
        }
        if self.play.model().independent.unit.dimension != Dimension::TIME {
            return Err(refused(
                self.play,
                &words("A camera films in seconds, and this simulation does not run in time."),
            ));
        }
        Ok(CameraSettings::usual(program.pace().per_second, program.until.unwrap_or(f64::INFINITY)))
    }

    /// Recipe of a film of the simulation from its start, with the present parameters.
    ///
    /// # Errors
    ///
    /// As [`ShownFilms::usual_camera`], and for invalid settings.
    pub fn recipe(self, settings: CameraSettings) -> Result<FilmRecipe, Refusal> {
        self.usual_camera()?;
        settings.check().map_err(|why| refused(self.play, &why))?;
        Ok(FilmRecipe {
            document: self.play.program().edition(self.play.basis().tag()).title.clone(),
            source: hash(&self.document.source),
            state: self.play.share_within(Extent::Start),
            language: self.play.basis().tag().to_owned(),
            settings,
        })
    }

    /// Simulation of a recipe, at its start.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for invalid settings, or a recipe of another document or another version of this one.
    pub fn filmed_play(self, recipe: &FilmRecipe) -> Result<Play, Refusal> {
        recipe.settings.check().map_err(|why| refused(self.play, &why))?;
        let mut play = Play::open(self.play.program().clone());
        play.set_language(&recipe.language);
        let restored = recipe.source == hash(&self.document.source) && play.restore(&recipe.state).is_ok();
        if restored { Ok(play) } else { Err(refused(self.play, &other_document(&recipe.document))) }
    }

    /// Recipes of this document's films with stored work, the latest first, without that of the open film.
    pub fn recipes(self) -> Vec<FilmRecipe> {
        let source = hash(&self.document.source);
        let open = self.films.open.as_ref().map(|open| open.work);
        let others = self.films.works.iter().enumerate().filter(|(place, _)| Some(*place) != open);
        let recipes = others.rev().filter_map(|(_, work)| work.recipe.clone());
        recipes.filter(|recipe| recipe.source == source).collect()
    }

    /// Comparison of the tracks of the open film with the truth; empty unless it is a film of a simulation.
    pub fn compare_with_truth(self) -> Vec<TruthComparison> {
        let Some((open, work)) = self.films.current() else { return Vec::new() };
        open.truth.as_ref().map(|truth| compared(&work.tracks(), truth, &work.calibration)).unwrap_or_default()
    }
}

fn other_document(title: &str) -> Words {
    words!("The film shows {title} in another version or with other sizes. Open that document to film it again.")
}
