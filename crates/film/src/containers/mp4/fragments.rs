//! Frames of a fragmented film, in boxes `moof` (ISO/IEC 14496-12, 8.8).

use super::super::FilmError;
use super::super::bytes::Bytes;
use super::super::film::{Sample, Samples};
use super::super::limits::MOST_SAMPLES;
use super::boxes::{Boxes, find, version_and_flags};

/// Default values for the frames of a track. Duration in units of the media time scale, size in bytes.
#[derive(Clone, Copy, Debug, Default)]
struct Defaults {
    duration: u32,
    size: u32,
    flags: u32,
}

/// State of reading the fragments of one track.
#[derive(Debug, Default)]
pub(super) struct Fragments {
    track: u32,
    /// Track number and defaults of each track.
    defaults: Vec<(u32, Defaults)>,
    /// Decoding time of the next frame if the fragment does not state it, in units of the media time scale.
    decoding: i64,
    /// Number of listed frames, with empty ones.
    listed: usize,
}

/// Content of `tfhd`.
struct Header {
    track: u32,
    base: Option<u64>,
    defaults: Defaults,
    base_is_fragment: bool,
}

/// Maximum number of tracks. Each fragment searches all of them.
const MOST_TRACKS: usize = 100;
/// Frame flag: not a key frame.
const NOT_A_KEY: u32 = 0x1_0000;

impl Fragments {
    /// Reads the content of `mvex`. `listed`: number of frames of the track in `moov`; `decoding`: decoding time after
    /// the last of them.
    pub(super) fn new(content: &[u8], track: u32, listed: usize, decoding: i64) -> Self {
        let defaults = Boxes(content).filter(|(kind, _)| kind == b"trex").filter_map(|(_, content)| {
            let mut bytes = Bytes(content);
            bytes.take(4)?;
            let track = bytes.u32()?;
            bytes.take(4)?;
            Some((track, Defaults { duration: bytes.u32()?, size: bytes.u32()?, flags: bytes.u32()? }))
        });
        Self { track, defaults: defaults.take(MOST_TRACKS).collect(), decoding, listed }
    }

    /// Adds the frames of a `moof` that begins at offset `start` in a file of `file` bytes.
    ///
    /// # Errors
    ///
    /// [`FilmError::Damaged`] for an invalid box, [`FilmError::TooLarge`] for too many frames.
    pub(super) fn add(
        &mut self,
        content: &[u8],
        start: u64,
        file: u64,
        samples: &mut Samples,
    ) -> Result<(), FilmError> {
        let mut data = start;
        for (_, content) in Boxes(content).filter(|(kind, _)| kind == b"traf") {
            let header = find(content, b"tfhd").and_then(|content| self.header(content));
            let header = header.ok_or(FilmError::Damaged { part: "tfhd" })?;
            let base = header.base.unwrap_or(if header.base_is_fragment { start } else { data });
            if header.track == self.track
                && let Some(time) = find(content, b"tfdt").and_then(decoding_time)
            {
                self.decoding = time;
            }
            data = base;
            for (_, content) in Boxes(content).filter(|(kind, _)| kind == b"trun") {
                data = self.run(content, &header, base, data, file, samples)?;
            }
        }
        Ok(())
    }

    fn header(&self, content: &[u8]) -> Option<Header> {
        let mut bytes = Bytes(content);
        let (_, flags) = version_and_flags(&mut bytes)?;
        let track = bytes.u32()?;
        let general = self.defaults.iter().find(|(other, _)| *other == track).map(|(_, defaults)| *defaults);
        let mut defaults = general.unwrap_or_default();
        let base = if flags & 1 == 0 { None } else { Some(bytes.u64()?) };
        if flags & 2 != 0 {
            bytes.take(4)?;
        }
        for (flag, field) in [(8, &mut defaults.duration), (0x10, &mut defaults.size), (0x20, &mut defaults.flags)] {
            if flags & flag != 0 {
                *field = bytes.u32()?;
            }
        }
        Some(Header { track, base, defaults, base_is_fragment: flags & 0x2_0000 != 0 })
    }

    /// Adds the frames of one `trun`. Returns the offset of the end of its data.
    fn run(
        &mut self,
        content: &[u8],
        header: &Header,
        base: u64,
        data: u64,
        file: u64,
        samples: &mut Samples,
    ) -> Result<u64, FilmError> {
        let damaged = FilmError::Damaged { part: "trun" };
        let mut bytes = Bytes(content);
        let mut start = || {
            let (_, flags) = version_and_flags(&mut bytes)?;
            let count = bytes.u32()?;
            let data = if flags & 1 == 0 { data } else { base.checked_add_signed(bytes.i32()?.into())? };
            let first = if flags & 4 == 0 { None } else { Some(bytes.u32()?) };
            let row = u64::from((flags & 0xf00).count_ones()) * 4;
            (row * u64::from(count) <= bytes.0.len() as u64).then_some((flags, count, data, first))
        };
        let Some((flags, count, mut data, first)) = start() else { return Err(damaged) };
        let ours = header.track == self.track;
        if !ours && flags & 0x200 == 0 {
            return Ok(data.saturating_add(u64::from(count) * u64::from(header.defaults.size)));
        }
        for number in 0..count {
            // The rows fit into the box: no field is missing.
            let mut field =
                |flag: u32, default: u32| if flags & flag == 0 { default } else { bytes.u32().unwrap_or(default) };
            let duration = field(0x100, header.defaults.duration);
            let size = field(0x200, header.defaults.size);
            let general = first.filter(|_| number == 0).unwrap_or(header.defaults.flags);
            let kind = field(0x400, general);
            let offset = field(0x800, 0).cast_signed();
            if ours {
                self.listed += 1;
                if self.listed > MOST_SAMPLES {
                    return Err(FilmError::TooLarge);
                }
                let ticks = self.decoding.saturating_add(offset.into());
                samples.add(Sample { offset: data, size, ticks, key: kind & NOT_A_KEY == 0, shown: true }, file);
                self.decoding = self.decoding.saturating_add(duration.into());
            }
            data = data.saturating_add(size.into());
        }
        Ok(data)
    }
}

/// Reads the content of `tfdt`.
fn decoding_time(content: &[u8]) -> Option<i64> {
    let mut bytes = Bytes(content);
    let (version, _) = version_and_flags(&mut bytes)?;
    i64::try_from(if version == 1 { bytes.u64()? } else { bytes.u32()?.into() }).ok()
}
