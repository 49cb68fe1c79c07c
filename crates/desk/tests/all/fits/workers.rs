//! Fits by workers elsewhere: results do not depend on who computes, nor on who is ready first.

use super::{film, fit, theory, three};
use desk::{Desk, FitNews, FitWork, Workers};

/// Several workers that know a fit by its bytes only, and report the last one first.
#[derive(Default)]
struct Elsewhere {
    /// Fits in work: number and bytes.
    given: Vec<(u32, Vec<u8>)>,
    issued: u32,
    /// Greatest number of fits at the same time.
    most: usize,
    /// True if all are lost at first, and a single one is left.
    is_lost: bool,
    /// True if a single one is left.
    is_alone: bool,
    /// Number of fits that were ended.
    ended: usize,
}

impl Workers for Elsewhere {
    fn count(&self) -> usize {
        if self.is_alone { 1 } else { 3 }
    }

    fn begin(&mut self, work: FitWork) -> u32 {
        assert!(self.given.len() < self.count());
        self.issued += 1;
        self.given.push((self.issued, postcard::to_allocvec(&work).unwrap()));
        self.most = self.most.max(self.given.len());
        self.issued
    }

    fn news(&mut self) -> Vec<(u32, FitNews)> {
        let Some((number, bytes)) = self.given.pop() else { return Vec::new() };
        if std::mem::take(&mut self.is_lost) {
            self.is_alone = true;
            let others = std::mem::take(&mut self.given);
            let lost = others.into_iter().map(|(other, _)| other).chain([number]);
            return lost.map(|number| (number, FitNews::Lost)).collect();
        }
        let mut computation = postcard::from_bytes::<FitWork>(&bytes).unwrap().start();
        let mut news = computation.advance();
        while !matches!(news, FitNews::Found(_)) {
            news = computation.advance();
        }
        let bytes = postcard::to_allocvec(&news).unwrap();
        vec![(number, postcard::from_bytes(&bytes).unwrap())]
    }

    fn keep(&mut self, wanted: &[u32]) {
        let before = self.given.len();
        self.given.retain(|(number, _)| wanted.contains(number));
        self.ended += before - self.given.len();
    }
}

fn ranked() -> Desk {
    let mut desk = Desk::open(theory("linear"));
    desk.add_record("tube.txt", film(0.2, 0.4, 7).as_bytes()).unwrap();
    let theories =
        ["quadratic", "linear", "cosine", "linear-quadratic"].map(|name| (format!("theories/{name}.md"), theory(name)));
    desk.change_fits(|fits, data| fits.begin_ranking(data, theories.to_vec())).unwrap();
    desk
}

fn announced(desk: &mut Desk) -> Vec<String> {
    std::iter::from_fn(|| desk.take_announcement()).map(|one| format!("{one:?}")).collect()
}

#[test]
fn workers_find_what_is_found_here() {
    let mut here = ranked();
    while here.advance_fit() {}
    let told = announced(&mut here);
    assert_eq!(told.last().map(String::as_str), Some("FitFinished(None)"));
    for is_lost in [false, true] {
        let mut desk = ranked();
        let mut workers = Elsewhere { is_lost, ..Elsewhere::default() };
        assert_eq!(desk.fits().progress().unwrap().finished, (0, 4));
        while desk.advance_fits(&mut workers) {}
        assert_eq!((workers.most, workers.ended), (3, 0));
        assert_eq!(desk.fits().list(), here.fits().list());
        assert_eq!(desk::facts(&desk), desk::facts(&here), "equal bits");
        assert_eq!(announced(&mut desk), told);
        for fit in desk.fits().list() {
            assert_eq!(desk.fits().detail(fit.id), here.fits().detail(fit.id));
        }
    }
}

#[test]
fn what_is_not_wanted_any_more_is_ended() {
    let mut workers = Elsewhere::default();
    let mut desk = ranked();
    assert!(desk.advance_fits(&mut workers));
    let given = workers.given.len();
    desk.change_fits(|fits, _| fits.cancel());
    assert!(!desk.advance_fits(&mut workers));
    assert_eq!((workers.given.len(), workers.ended), (0, given));
    assert_eq!(desk.fits().list(), []);
    // Another document takes the records over; a fit of the one before ends.
    desk.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    assert!(desk.advance_fits(&mut Idle(1)));
    let mut other = Desk::open(theory("cosine"));
    other.adopt(&mut desk);
    assert!(!other.advance_fits(&mut workers));
    assert_eq!(other.fits().list(), []);
}

#[test]
fn a_new_fit_comes_before_what_is_made_again() {
    let mut desk = three();
    fit(&mut desk);
    let (records, fits) = (desk.records().saved(), desk.fits().saved());
    let mut later = Desk::open(theory("linear"));
    crate::support::bring_back_records(&mut later, &records);
    crate::support::bring_back_fits(&mut later, &fits);
    assert!(later.advance_fits(&mut Idle(1)));
    later.choose_record(0);
    later.change_fits(|fits, data| fits.begin(data, "theories/linear.md")).unwrap();
    assert!(later.fits().progress().is_some());
    while later.advance_fit() {}
    let names: Vec<_> = later.fits().list().into_iter().map(|fit| fit.records[0].clone()).collect();
    assert_eq!(names, ["tube 1.txt", "tube 3.txt"]);
}

/// A worker that never reports.
struct Idle(u32);

impl Workers for Idle {
    fn count(&self) -> usize {
        1
    }

    fn begin(&mut self, _: FitWork) -> u32 {
        self.0
    }

    fn news(&mut self) -> Vec<(u32, FitNews)> {
        Vec::new()
    }

    fn keep(&mut self, _: &[u32]) {}
}
