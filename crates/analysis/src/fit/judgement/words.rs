//! Sentences about the result of a fit.

use super::verdict::{Nearness, Size, Verdict};
use crate::fit::outcome::{Outcome, Scan};
use crate::fit::uncertainty::estimate::Estimate;
use units::number::plain;
use units::{Language, say};

impl Outcome {
    /// Verdict on the model, in a few sentences. The first one says whether the curve meets the data.
    pub fn verdict_text(&self, language: Language) -> String {
        let residuals = self.residuals_text(language);
        self.nearness_text(language).map_or_else(|| residuals.clone(), |nearness| [&nearness, " ", &residuals].concat())
    }

    /// Sentence that says whether the curve meets the data: the residuals as a share of the swing from peak to peak. `None` if
    /// the values do not vary.
    pub fn nearness_text(&self, language: Language) -> Option<String> {
        let share = self.largest_share()?;
        let name = &share.of.name;
        if share.value >= 2.0 {
            let times = plain(share.value, 2, language.style());
            return Some(say!(
                language,
                "The curve misses the data: the RMS residual of {name} is {times} times its swing from peak to peak."
            ));
        }
        let percent = plain(100.0 * share.value, 2, language.style());
        Some(match self.nearness(share) {
            Nearness::Met => say!(
                language,
                "The curve meets the data: the RMS residual of {name} is {percent} % of its swing from peak to peak."
            ),
            Nearness::Scattered => say!(
                language,
                "The curve follows the data within their scatter: the RMS residual of {name} is {percent} % of its swing from \
                 peak to peak."
            ),
            Nearness::Missed => say!(
                language,
                "The curve misses the data: the RMS residual of {name} is {percent} % of its swing from peak to peak."
            ),
        })
    }

    /// [`Outcome::nearness_text`] in one line beside the curve, with the nearness itself.
    pub fn nearness_in_brief(&self, language: Language) -> Option<(Nearness, String)> {
        let share = self.largest_share()?;
        let nearness = self.nearness(share);
        let percent = plain(100.0 * share.value, 2, language.style());
        let text = match nearness {
            Nearness::Met => say!(language, "Hit: off by {percent} % of the swing."),
            Nearness::Scattered => say!(language, "The points scatter by {percent} % of the swing."),
            Nearness::Missed => say!(language, "Miss: off by {percent} % of the swing."),
        };
        Some((nearness, text))
    }

    /// Judgement of the residuals, in a few sentences.
    fn residuals_text(&self, language: Language) -> String {
        let verdict = self.verdict();
        let text = match verdict {
            Verdict::Exact => language.say("The fit is exact: the residuals are less than a billionth of the scatter of the values. AICc and BIC are those \
                 of residuals of that size."),
            Verdict::Saturated => language.say("There are as many values as parameters: the curve can pass through all of them, and the fit is no test of the model."),
            Verdict::Misled => language.say("The residuals cannot be used to judge the model: outliers dominate the fit."),
            Verdict::Compatible => language.say("The residuals look random: the model is compatible with the data."),
            Verdict::TooLarge => language.say("The residuals look random, but they are larger than the given errors: these are too small, or the model misses \
                 something."),
            Verdict::TooSmall => language.say("The residuals look random, but they are smaller than the given errors: these are too large."),
            Verdict::Structured => language.say("The residuals are autocorrelated: the model, or the measurement, misses something. Use the standard errors that \
                 allow for it."),
            Verdict::Alternating => language.say("Neighbouring residuals tend to have opposite signs (negative autocorrelation): the model, or the measurement, \
                 misses something that changes from one value to the next. Use the larger one of the two standard errors."),
            Verdict::Nothing => language.say("The residuals look random, but the curve explains no more of the data than chance would: a constant fits as \
                 well. Its parameters mean nothing."),
            Verdict::Missed => language.say("The curve explains less than half of the variance of the data, and the residuals are autocorrelated: the model \
                 does not describe these data. Begin from values that are nearer, widen the ranges of the parameters, or try \
                 another theory."),
            Verdict::Unknown => language.say("There are too few values to judge the residuals."),
        };
        // Added if the verdict itself is not about the size of the residuals.
        let size = match verdict {
            Verdict::Structured | Verdict::Alternating | Verdict::Nothing => self.size(),
            _ => None,
        };
        let of_size = match size {
            None => "",
            Some(Size::Larger) => language.say(" They are larger than the given errors, too."),
            Some(Size::Smaller) => language.say(" They are smaller than the given errors: these are too large."),
        };
        [text, of_size].concat()
    }
}

impl Outcome {
    /// Sentences about the number of starts, if more than one, a lower minimum found by a profile, and trials that were given up.
    pub fn search_texts(&self, language: Language) -> Vec<String> {
        let mut texts = Vec::new();
        if let Some(Scan { starts, ended }) = self.scan {
            texts.push(say!(language, "The fit was made from {starts} given starts; {ended} of them ended here."));
        } else if self.starts > 1 {
            texts.push(say!(
                language,
                "The search was made from {} starts; these values are the best that were found.",
                self.starts
            ));
        }
        if self.improved > 0 {
            let text =
                language.say("The profile of a parameter met a lower chi-square: the fit was made again from there.");
            texts.push(text.to_owned());
        }
        if self.gave_up {
            let text = language.say("Some trials needed too many steps of the integration and were given up: the search did not look there.");
            texts.push(text.to_owned());
        }
        texts
    }

    /// Sentence about an oscillation that the residuals of a model with several frequencies hold, if there is one. `time` formats
    /// a period in SI with its unit.
    pub fn unexplained_text(&self, language: Language, time: impl Fn(f64) -> String) -> Option<String> {
        let period = time(self.unexplained?);
        Some(say!(
            language,
            "The residuals hold an oscillation with the period {period}: another minimum may fit better. Begin from values \
             of the frequencies that are nearer."
        ))
    }

    /// Sentence about another minimum that fits as well within the noise, if there is one. `quantity` formats a value in SI
    /// of an estimate with its unit.
    pub fn rival_text(&self, language: Language, quantity: impl Fn(&Estimate, f64) -> String) -> Option<String> {
        let rival = self.rival.as_ref()?;
        let values = self.parameters.iter().zip(&rival.values);
        let values: Vec<String> =
            values.map(|(one, value)| format!("{} = {}", one.name, quantity(one, *value))).collect();
        let values = values.join(", ");
        Some(say!(language, "Another minimum fits as well within the noise: {values}."))
    }
}

impl Estimate {
    /// Reason for a missing standard error, if the estimate or all that it depends on is stopped at a bound of its range.
    pub fn stopped_text(&self, language: Language) -> Option<&'static str> {
        self.at_bound.then_some(match self.target {
            Some(_) => language.say("at the end of its range"),
            None => language.say("no error: its parameter is at the end of the range"),
        })
    }
}
