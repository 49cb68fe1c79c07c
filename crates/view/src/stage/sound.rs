//! The displacement as a pitch.

use play::Play;
use web_sys::{AudioContext, GainNode, OscillatorNode};

/// Loudness, from 0 to 1.
const LOUDNESS: f32 = 0.08;
/// Time constant of changes of pitch and loudness, in seconds: short enough to follow the motion, long enough to avoid
/// clicks.
const GLIDE: f64 = 0.02;

/// An oscillator, created when sound is first switched on: browsers allow it only then.
#[derive(Default)]
pub struct Sound {
    voice: Option<Voice>,
    on: bool,
}

struct Voice {
    context: AudioContext,
    oscillator: OscillatorNode,
    gain: GainNode,
}

impl Voice {
    fn new() -> Option<Self> {
        let context = AudioContext::new().ok()?;
        let oscillator = context.create_oscillator().ok()?;
        let gain = context.create_gain().ok()?;
        gain.gain().set_value(0.0);
        oscillator.connect_with_audio_node(&gain).ok()?;
        gain.connect_with_audio_node(&context.destination()).ok()?;
        oscillator.start().ok()?;
        Some(Self { context, oscillator, gain })
    }
}

impl Sound {
    /// True if sound is on.
    pub fn is_on(&self) -> bool {
        self.on
    }

    /// Switches sound on or off. Returns false if that failed because the browser has no sound.
    pub fn turn(&mut self, on: bool) -> bool {
        if on && self.voice.is_none() {
            self.voice = Voice::new();
        }
        self.on = on && self.voice.is_some();
        if let Some(voice) = &self.voice {
            let _ = if self.on { voice.context.resume() } else { voice.context.suspend() };
        }
        self.on == on
    }

    /// Updates pitch and loudness to the simulation; silent while it is paused.
    pub fn follow(&mut self, play: &Play) {
        let Some(voice) = self.voice.as_ref().filter(|_| self.on) else { return };
        let now = voice.context.current_time();
        let pitch = play.controls().pitch(play.time_line());
        if let Some(pitch) = pitch {
            let _ = voice.oscillator.frequency().set_target_at_time(pitch as f32, now, GLIDE);
        }
        let loudness = if pitch.is_some() { LOUDNESS } else { 0.0 };
        let _ = voice.gain.gain().set_target_at_time(loudness, now, GLIDE);
    }
}
