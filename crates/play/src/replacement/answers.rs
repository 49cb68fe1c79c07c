//! Transfer of the user's answers to another program, by the texts of the questions.

use super::names::Names;
use crate::{Play, words};
use program::{NodeId, Question};

impl Play {
    /// Takes over answers. Returns those whose questions no longer exist, in the chosen language.
    pub(super) fn adopt_answers(&mut self, before: &Play, names: &Names) -> Vec<String> {
        let own = self.question_names();
        let mut lost = Vec::new();
        for ((former, name), (answer, &solved)) in
            before.question_names().iter().enumerate().zip(before.answers.iter().zip(&before.solved))
        {
            let Some(place) = own.iter().position(|own| own == name) else {
                if !answer.typed.is_empty() {
                    lost.push(words::answer(self.basis.language(), &answer.typed));
                }
                continue;
            };
            let same = self.asks_the_same(place, before, former, names);
            // The right answer has changed: the typed text is unchecked, and the answer shown is outdated.
            let answer = if same { answer.clone() } else { answer.unchecked() };
            self.note_answer(place, |own| *own = answer);
            if same && solved {
                self.solve(place);
            }
        }
        lost
    }

    /// True if the answer to a question is the same expression as that of a former question.
    fn asks_the_same(&self, index: usize, before: &Play, former: usize, names: &Names) -> bool {
        let (Some(asked), Some(other)) =
            (self.basis.program().questions.get(index), before.basis.program().questions.get(former))
        else {
            return false;
        };
        let nodes = |question: &Question| -> Vec<NodeId> {
            let setup = question.setup.iter().map(|assignment| assignment.value.node);
            setup.chain([question.answer.node]).collect()
        };
        let (mut own, mut others) = (nodes(asked), nodes(other));
        // Initial values in an answer are compared by their expressions in the model.
        for state in others.clone().into_iter().flat_map(|node| before.model().depends(node).initial) {
            let now = names.state(state as usize).and_then(|state| self.model().states.get(state));
            let (Some(now), Some(then)) = (now, before.model().states.get(state as usize)) else { return false };
            own.push(now.initial);
            others.push(then.initial);
        }
        let sets = asked.setup.iter().map(|assignment| Some(assignment.parameter));
        asked.unit == other.unit
            && asked.tolerance == other.tolerance
            && sets.eq(other.setup.iter().map(|assignment| names.parameter(assignment.parameter)))
            && before.model().graph.same(&others, &self.model().graph, &own, |node| names.input(node))
    }
}
