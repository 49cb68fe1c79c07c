//! Claims proposed for a document, each run before it is shown.

use document::proposals::{Declined, Evaluation, Point, Proposal, declined, propose, untested};
use engine::checks::{Checking, Outcome, Verdict, claim_outcome};
use engine::{Advance, Readings, Run, Setup};
use program::{Check, Claim, Model, NodeId, Program, Test};
use units::Words;

/// Number of points of the run at which equations are evaluated.
const POINTS: usize = 12;
/// Work limit of that run, in floating-point operations.
const RUN_WORK: u64 = 100_000_000;
/// Work limit of all proposals together, in floating-point operations: about a second.
const WORK: u64 = 500_000_000;

/// Proposals for a document.
#[derive(Clone, Debug, Default)]
pub struct Proposed {
    /// Proposals that are worth a look: those that hold and that no claim of the document says already, and those that do
    /// not hold and should.
    pub proposals: Vec<JudgedProposal>,
    /// Proposals that the author has declined, with the reasons.
    pub declined: Vec<Declined>,
    /// Values that questions ask for and no claim tests.
    pub untested: Vec<Words>,
    /// Number of proposals that the work limit left untested.
    pub unjudged: usize,
}

/// A proposal and what a run says of it.
#[derive(Clone, Debug)]
pub struct JudgedProposal {
    /// The proposal.
    pub proposal: Proposal,
    /// True if the claim holds; otherwise it is a suspicion.
    pub held: bool,
    /// Description of the result.
    pub text: Words,
}

impl Proposed {
    /// Number of proposals that do not hold.
    pub fn suspicions(&self) -> usize {
        self.proposals.iter().filter(|judged| !judged.held).count()
    }
}

/// Proposals for the text of a document. `None` if it has errors.
pub fn proposed(source: &str) -> Option<Proposed> {
    let document = document::open(source, &[]).sound()?;
    let declined = declined(source);
    let is_open = |proposal: &Proposal| !declined.iter().any(|declined| declined.key == proposal.key());
    let proposals: Vec<Proposal> =
        propose(&document, &Engine { program: &document.program }).into_iter().filter(is_open).collect();
    let (proposals, unjudged) = judged(source, &document.program, proposals);
    Some(Proposed { proposals, unjudged, untested: untested(&document.program), declined })
}

/// Runs proposals; those that are not worth a look are left out. Also returns the number of those for which no work was left.
fn judged(source: &str, stated: &Program, proposals: Vec<Proposal>) -> (Vec<JudgedProposal>, usize) {
    let mut text = source.to_owned();
    let mut ends = Vec::new();
    for proposal in &proposals {
        text.push_str(&format!("\n\n```check\n{}\n```\n", proposal.lines()));
        ends.push(text.len());
    }
    // A proposal that cannot be compiled is an error in this text, and is left out.
    let Some(document) = document::open(&text, &[]).document else { return (Vec::new(), 0) };
    let mut program = document.program;
    let checks = std::mem::take(&mut program.checks);
    let claims = checks.iter().flat_map(|check| check.claims.iter().map(move |claim| (&check.setup, claim)));
    let mut own: Vec<usize> = Vec::new();
    for ((setup, claim), place) in claims.zip(&document.claims).filter(|(_, place)| place.start >= source.len()) {
        own.push(ends.partition_point(|end| *end <= place.start));
        match program.checks.last_mut() {
            Some(last) if last.setup == *setup => last.claims.push(claim.clone()),
            _ => program.checks.push(Check { setup: setup.clone(), claims: vec![claim.clone()] }),
        }
    }
    let mut checking = Checking::within(WORK);
    while !checking.advance(&program, u64::MAX) {}
    let outcomes = checking.outcomes().iter().flatten();
    let claims = program.checks.iter().flat_map(|check| &check.claims);
    let mut proposals: Vec<Option<Proposal>> = proposals.into_iter().map(Some).collect();
    let unjudged = checking.outcomes().iter().flatten().filter(|outcome| outcome.verdict == Verdict::TooLong).count();
    let worth = (own.into_iter().zip(claims.zip(outcomes)))
        .filter_map(|(index, (claim, outcome))| {
            let proposal = proposals.get_mut(index)?.take()?;
            let text = claim_outcome(&program, claim, outcome);
            is_worth(&proposal, claim, outcome, stated).then(|| JudgedProposal { held: outcome.held(), proposal, text })
        })
        .collect();
    (worth, unjudged)
}

/// True if the author should look at a proposal.
fn is_worth(proposal: &Proposal, claim: &Claim, outcome: &Outcome, stated: &Program) -> bool {
    match outcome.verdict {
        Verdict::Held => !proposal.routine && !is_claimed(claim, stated),
        Verdict::Failed => proposal.suspicion.is_some(),
        _ => false,
    }
}

/// True if the document compares the same values already.
fn is_claimed(claim: &Claim, stated: &Program) -> bool {
    let nodes = |claim: &Claim| match &claim.test {
        Test::Near { value, expected, .. } => Some((value.node, expected.node)),
        _ => None,
    };
    let mut claims = stated.checks.iter().flat_map(|check| &check.claims);
    nodes(claim).is_some_and(|own| claims.any(|other| nodes(other) == Some(own)))
}

/// Runs and evaluates a program.
struct Engine<'a> {
    program: &'a Program,
}

impl Evaluation for Engine<'_> {
    fn run(&self) -> Vec<Point> {
        let model = &self.program.model;
        let Ok(mut run) = Run::start(model, Setup::of(self.program)) else { return Vec::new() };
        let end = self.program.end();
        while run.time() < end && run.work() < RUN_WORK {
            match run.advance_within(RUN_WORK) {
                Ok(Advance::Step | Advance::Event | Advance::Partial) => {}
                Ok(Advance::Full) | Err(_) => break,
            }
        }
        let history = run.history();
        let rows = history.len();
        let point = |number: usize| {
            let row = number * rows.saturating_sub(1) / (POINTS - 1);
            let mut states = vec![0.0; model.states.len()];
            history.state(row, &mut states);
            Point { time: history.time(row), states }
        };
        (0..POINTS).map(point).filter(|point| point.states.iter().all(|value| value.is_finite())).collect()
    }

    fn values(
        &self,
        model: &Model,
        nodes: &[NodeId],
        parameters: &[f64],
        initial: &[f64],
        points: &[Point],
    ) -> Vec<Vec<f64>> {
        let mut readings = Readings::new(model, nodes);
        let mut values = vec![Vec::with_capacity(points.len()); nodes.len()];
        for point in points {
            let read = readings.at(parameters, initial, point.time, &point.states);
            values.iter_mut().zip(read).for_each(|(values, value)| values.push(*value));
        }
        values
    }
}
