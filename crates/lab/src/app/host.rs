//! The laboratory as the page around the views of the simulation: its announcements, views and storage.

use super::{Lab, Store};
use crate::{documents::saved, documents::visited, film, fit, measuring::data, welcome, write};
use desk::{Announcement, Desk};
use play::{Embedding, Play};
use units::Language;
use view::browser;
use view::page::{message::Message, texts};
use view::panel::tabs;
use view::stage::brush::Part;
use view::views::*;
use view::{Host, News};

impl Host for Store {
    fn with_play(&self, work: &mut dyn FnMut(&mut Play)) {
        if let Some(mut desk) = self.desk() {
            work(desk.play_mut());
        }
    }

    fn follow(&self) -> bool {
        self.desk().is_some_and(|mut desk| {
            desk.follow();
            desk.measured().lags(desk.play())
        })
    }

    fn work_on_plots(&self) -> bool {
        let Some(mut lab) = self.lab() else { return false };
        let Lab { desk: Some(desk), sweeps, .. } = &mut *lab else { return false };
        desk.play_mut().change_plots(|plots, run| plots.work_beside(run, sweeps))
    }

    fn news(&self, by_slider: bool) -> Vec<News> {
        let mut news = Vec::new();
        let mut added = None;
        let begun = self.app.get().and_then(|app| app.guide.get_untracked());
        let mut step = begun;
        if let Some(mut desk) = self.desk() {
            while let Some(announcement) = desk.take_announcement() {
                if let (Some(step), Announcement::Play(of_play)) = (&mut step, &announcement) {
                    *step = step.after(of_play, desk.play());
                }
                match &announcement {
                    Announcement::Play(play::Announcement::ParameterSet(..)) if by_slider => {}
                    // The editor already shows that the text runs.
                    Announcement::Play(play::Announcement::Replaced(lost)) if lost.is_empty() => {}
                    Announcement::Play(of_play) => news.push(News::of_play(desk.play(), of_play)),
                    own => {
                        if matches!(own, Announcement::RecordAdded(_)) {
                            added = desk.records().newest();
                        }
                        news.push(self.news_of(&desk, own));
                    }
                }
            }
        }
        if let (Some(app), Some(_)) = (self.app.get(), added) {
            app.new_record.set(added);
        }
        if let Some(app) = self.app.get().filter(|_| step != begun) {
            app.guide.set(step);
        }
        news
    }

    fn raise(&self) {
        let (Some(app), Some(revision)) = (self.app.get(), self.desk().map(|desk| desk.revision())) else { return };
        let now = (revision.records, revision.fits, revision.play.answers, revision.films);
        let before = self.seen.replace(now);
        if before != now {
            saved::later(*app);
        }
        if before.3 != now.3 {
            film::refresh(*app);
        }
        for (changed, counter) in [(before.0 != now.0, app.records), (before.1 != now.1, app.fits)] {
            if changed {
                counter.update(|count| *count += 1);
            }
        }
    }

    fn picture(&self) -> [View; 2] {
        self.app.get().map_or_else(Default::default, |app| [film::stage::picture(*app), film::stage::transport(*app)])
    }

    fn strip(&self) -> View {
        self.app.get().map_or_else(View::new, |app| fit::strip(*app))
    }

    fn door(&self) -> View {
        self.app.get().map_or_else(View::new, |app| welcome::door(*app))
    }

    fn look_at(&self, time: &mut dyn FnMut() -> Option<f64>) {
        if let Some(app) = self.app.get() {
            film::look_at(*app, time);
        }
    }

    fn leaves_points_out(&self) -> bool {
        let asked = self
            .app
            .get()
            .is_some_and(|app| app.leaving_out.get_untracked() && app.tab.get_untracked() == tabs::MEASURE);
        asked && self.desk().is_some_and(|desk| desk.measured().has_points())
    }

    fn leave_out(&self, column: usize, place: usize) {
        if let Some(app) = self.app.get() {
            app.act_on_desk(|desk| desk.leave_out(column, place));
        }
    }

    fn part(&self) -> Option<Part> {
        let is_measuring = self.app.get().is_some_and(|app| app.tab.get_untracked() == tabs::MEASURE);
        self.desk()
            .filter(|desk| is_measuring && !desk.records().list().is_empty())
            .map(|desk| desk.fits().fitted_part())
    }

    fn set_part(&self, part: Part) {
        if let Some(mut desk) = self.desk() {
            desk.change_fits(|fits, _| fits.set_fitted_part(part));
        }
    }

    fn undo(&self, number: u32) -> bool {
        self.desk().is_some_and(|mut desk| desk.undo(number))
    }

    fn restore(&self, version: &str) {
        if let Some(app) = self.app.get() {
            write::restore(*app, version);
        }
    }

    fn embedding(&self) -> Embedding {
        self.embedding.borrow().clone()
    }

    fn can_resize(&self) -> bool {
        true
    }

    fn resize(&self, name: &str, value: u32) -> Option<String> {
        let mut desk = self.desk()?;
        let refused = desk.resize(&[(name, value)]).err();
        refused.map(|refusal| refusal.text(desk.play()))
    }

    fn set_language(&self, language: Language) {
        if let Some(mut desk) = self.desk() {
            desk.set_language(language.tag());
        }
    }

    fn texts(&self) -> &'static str {
        texts::LABORATORY
    }

    fn stem(&self) -> String {
        self.app.get().map_or_else(String::new, |app| visited::stem(*app))
    }

    fn save_buttons(&self) -> View {
        self.app.get().map_or_else(View::new, |app| data::workbook_button(*app).into())
    }

    fn show(&self, place: &str) {
        if let Some(app) = self.app.get() {
            app.tab.set(match place {
                write::FINDINGS => tabs::WRITE,
                _ => tabs::MEASURE,
            });
            if place == fit::RESULTS {
                fit::unfold_results(*app);
            }
        }
        browser::reveal_later(place.to_owned());
    }
}

impl Store {
    /// News for an announcement of the desk.
    fn news_of(&self, desk: &Desk, announcement: &Announcement) -> News {
        let news = News::new(announcement.text(desk.play()), announcement.prominence());
        let lead = |message: Message| match announcement {
            Announcement::RecordAdded(_) => match desk.records().newest() {
                Some(id) => Some(message.leading_to(format!("record-{id}"))),
                None => Some(message),
            },
            // The results are visible where the fit was started.
            Announcement::FitFinished(None)
                if self.app.get().is_some_and(|app| app.tab.get_untracked() == tabs::MEASURE) =>
            {
                None
            }
            Announcement::FitFinished(_) => Some(message.leading_to(fit::RESULTS.to_owned())),
            own if own.can_be_undone() => Some(message.undone_by(desk.undo_number())),
            _ => Some(message),
        };
        News { message: news.message.and_then(lead), ..news }
    }
}
