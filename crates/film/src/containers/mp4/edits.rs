//! Edit list of a track: the shown intervals of the media and their presentation times (ISO/IEC 14496-12, 8.6.6).

use super::super::FilmError;
use super::super::bytes::Bytes;
use super::super::film::{Sample, order};
use super::boxes::{rows, version_and_flags};

/// Maximum number of edits, beyond any camera or phone editor. Each edit costs a pass over the frames.
const MOST: usize = 100;

/// Row of the edit list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Edit {
    /// Duration in units of the movie time scale; 0 for the rest of the film.
    duration: u64,
    /// Start in the media, in units of the media time scale; -1 for a pause.
    media: i64,
    /// Playback rate times 65536; 0 for a frozen frame.
    rate: i32,
}

/// Playback rate 1.
const NORMAL: i32 = 1 << 16;

/// Reads the content of `elst`.
///
/// # Errors
///
/// [`FilmError::Damaged`] for an incomplete or too long list.
pub(super) fn edits(content: &[u8]) -> Result<Vec<Edit>, FilmError> {
    let damaged = FilmError::Damaged { part: "elst" };
    let Some((version, _)) = version_and_flags(&mut Bytes(content)) else { return Err(damaged) };
    let row = if version == 1 { 20 } else { 12 };
    let edits = rows(content, row, "elst")?.chunks_exact(row).map(|row| {
        let mut row = Bytes(row);
        let (duration, media) = if version == 1 {
            (row.u64()?, row.u64()?.cast_signed())
        } else {
            (u64::from(row.u32()?), i64::from(row.i32()?))
        };
        Some(Edit { duration, media, rate: row.i32()? })
    });
    let edits: Vec<Edit> = edits.take(MOST + 1).collect::<Option<_>>().ok_or(damaged)?;
    if edits.len() > MOST { Err(FilmError::Damaged { part: "elst" }) } else { Ok(edits) }
}

/// Converts composition times to presentation times. `movie` and `media`: ticks per second of the edit durations and of
/// the media. Returns true if a part plays at another rate than 1.
///
/// An edit shows the frames whose composition time is at or after its start and before its end. A frame in several
/// edits is shown in the first of them.
pub(super) fn apply(edits: &[Edit], movie: u32, media: u32, samples: &mut [Sample]) -> bool {
    let Some(first) = edits.iter().find(|edit| edit.media >= 0) else { return false };
    let to_media = |ticks: u64| {
        let (movie, media) = (u64::from(movie.max(1)), u64::from(media));
        let rest = (ticks % movie * media + movie / 2) / movie;
        i64::try_from((ticks / movie).saturating_mul(media).saturating_add(rest)).unwrap_or(i64::MAX)
    };
    let order = order(samples);
    let compositions: Vec<i64> = order.iter().map(|&at| samples[at].ticks).collect();
    let pause =
        edits.iter().take_while(|edit| edit.media < 0).fold(0_u64, |sum, edit| sum.saturating_add(edit.duration));
    for sample in samples.iter_mut() {
        sample.shown = false;
        sample.ticks = sample.ticks.saturating_sub(first.media).saturating_add(to_media(pause));
    }
    let (mut start, mut other_rate) = (0_u64, false);
    for edit in edits {
        let mut lasts = edit.duration;
        let range = match edit.rate {
            _ if edit.media < 0 => 0..0,
            0 => {
                let after = compositions.partition_point(|&ticks| ticks <= edit.media);
                after.saturating_sub(1)..after
            }
            rate => {
                if rate > 0 && rate != NORMAL {
                    other_rate = true;
                    lasts = lasts.saturating_mul(rate.unsigned_abs().into()) >> 16;
                }
                let end = if lasts == 0 { i64::MAX } else { edit.media.saturating_add(to_media(lasts)) };
                let from = compositions.partition_point(|&ticks| ticks < edit.media);
                from..compositions.partition_point(|&ticks| ticks < end).max(from)
            }
        };
        for at in range {
            let sample = &mut samples[order[at]];
            if !sample.shown {
                let within = if edit.rate == 0 { 0 } else { compositions[at] - edit.media };
                sample.ticks = to_media(start).saturating_add(within);
                sample.shown = true;
            }
        }
        start = start.saturating_add(lasts);
    }
    other_rate
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten frames at 10 ticks; the movie has 100 ticks in a second, the media 1000.
    fn shown(edits: &[(u64, i64, i32)]) -> Vec<(i64, i64)> {
        let edits: Vec<Edit> =
            edits.iter().map(|&(duration, media, rate)| Edit { duration, media, rate: rate << 16 }).collect();
        let mut samples: Vec<Sample> =
            (0..10).map(|n| Sample { offset: 0, size: 1, ticks: 10 * n, key: true, shown: true }).collect();
        assert!(!apply(&edits, 100, 1000, &mut samples));
        let numbered = samples.iter().zip(0..);
        numbered.filter(|(sample, _)| sample.shown).map(|(sample, number)| (number, sample.ticks)).collect()
    }

    #[test]
    fn frames_are_shown_where_edits_say() {
        let from = |first: i64, last: i64, start: i64| {
            (first..last).map(|n| (n, start + 10 * (n - first))).collect::<Vec<_>>()
        };
        assert_eq!(shown(&[]), from(0, 10, 0), "none");
        assert_eq!(shown(&[(0, 30, 1)]), from(3, 10, 0), "to the end");
        assert_eq!(shown(&[(4, 30, 1)]), from(3, 7, 0), "40 ticks");
        assert_eq!(shown(&[(5, -1, 1), (4, 30, 1)]), from(3, 7, 50), "after a pause");
        assert_eq!(shown(&[(2, 0, 1), (2, 60, 1)]), [from(0, 2, 0), from(6, 8, 20)].concat(), "two parts");
        assert_eq!(shown(&[(5, 0, 0), (0, 0, 1)]), [vec![(0, 0)], from(1, 10, 60)].concat(), "the first frame is held");
        assert_eq!(shown(&[(0, 25, 1)]), (3..10).map(|n| (n, 10 * n - 25)).collect::<Vec<_>>(), "between two frames");
    }

    #[test]
    fn a_slower_part_keeps_the_times_of_the_recording() {
        let edit = |duration, media, rate| Edit { duration, media, rate };
        let mut samples: Vec<Sample> =
            (0..10).map(|n| Sample { offset: 0, size: 1, ticks: 10 * n, key: true, shown: true }).collect();
        assert!(apply(&[edit(4, 0, NORMAL / 2), edit(8, 20, NORMAL)], 100, 1000, &mut samples));
        assert!(samples.iter().zip(0..).all(|(sample, n)| sample.shown && sample.ticks == 10 * n), "{samples:?}");
    }
}
