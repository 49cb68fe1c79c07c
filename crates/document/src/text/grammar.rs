//! Words of each kind of sentence.

use super::block::BlockKind;
use model::Grammar;

/// Kind of a plot of single points.
pub const POINTS: &str = "points";

/// Kind of a plot of the counted values of one quantity.
pub const HISTOGRAM: &str = "histogram";

/// Words used elsewhere for `against`.
pub const AGAINST: [&str; 5] = ["vs", "versus", "over", "contra", "frente"];

/// `"Section": points y' against y every 2 [s] from 10 [s], equal axes`.
const PLOTS: Grammar = Grammar {
    kinds: &[POINTS, HISTOGRAM],
    clauses: &["against", "for", "in", "at", "every", "from", "step", "vs", "versus", "over", "contra", "frente"],
    ending: &["equal", "axes"],
    ..Grammar::TITLED
};

/// `"Mercury": rho = 13534 [kg/m^3]` and `group "Liquid"`.
const PRESETS: Grammar = Grammar { heads: &["group"], ..Grammar::TITLED };

/// `scale "It was clear": 5 steps from "no" to "yes"`.
const SURVEY: Grammar =
    Grammar { heads: &["role", "scale", "choice", "text"], clauses: &["from", "to"], ..Grammar::TITLED };

/// `"Energy is kept": E within 1e-6 of E(0) always` and `set: b = 0`.
const CLAIMS: Grammar = Grammar {
    heads: &["set"],
    clauses: &["within", "of", "by", "at", "always"],
    is_list: false,
    joins_indented: true,
    ..Grammar::TITLED
};

/// `2*pi/omega in [s] within 2 %`.
pub const ANSWER: Grammar = Grammar { clauses: &["within"], is_list: false, ..Grammar::LIST };

/// `maximum(y) from 2 [s] in [cm], y at end` and `b in 0..100 [kg/s] step 2`.
pub const OUTCOMES: Grammar = Grammar { clauses: &["in", "from", "at", "step"], ..Grammar::LIST };

/// Grammar of the sentences of a block; `None` for a block without sentences.
pub fn of_block(kind: BlockKind) -> Option<&'static Grammar> {
    match kind {
        BlockKind::Plots => Some(&PLOTS),
        BlockKind::Check => Some(&CLAIMS),
        BlockKind::Presets => Some(&PRESETS),
        BlockKind::Survey => Some(&SURVEY),
        BlockKind::Translations => Some(&Grammar::TITLED),
        BlockKind::Prose | BlockKind::Model | BlockKind::Table | BlockKind::Scene | BlockKind::Question => None,
    }
}
