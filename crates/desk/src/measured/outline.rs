//! The outline: the scene with measured values in place of computed ones.

use crate::measured::MeasuredData;
use crate::measured::data::Outline;
use document::Document;
use engine::Routine;
use play::{Follows, Play};
use program::{Graph, Node};

impl MeasuredData {
    /// Builds the outline of the measured columns. Only undifferentiated quantities are used.
    pub(crate) fn begin_outline(&mut self, play: &mut Play, document: &Document) {
        self.outline = self.make_outline(play, document);
        let outline = self.outline.as_ref().map(|(outline, follows)| {
            let columns = outline.columns.iter().filter_map(|column| self.columns.get(*column));
            let mut sources: Vec<String> = columns.map(|measured| measured.record_name.clone()).collect();
            sources.dedup();
            play::Outline { follows: follows.clone(), sources, values: None }
        });
        play.change_values(|values| values.set_outline(outline));
    }

    /// Evaluates the outline at the shown time. It has no values if a column has none at that time.
    pub(crate) fn follow_outline(&mut self, play: &mut Play) {
        let Some((outline, _)) = &mut self.outline else { return };
        let course = play.course();
        outline.inputs.clear();
        outline.inputs.extend_from_slice(course.parameters());
        let mut there = true;
        for column in &outline.columns {
            let value = self.columns.get(*column).and_then(|measured| measured.at(course.time()));
            outline.inputs.push(value.unwrap_or(f64::NAN));
            there &= value.is_some();
        }
        if there {
            outline.routine.prepare(&outline.inputs, course.initial());
            outline.routine.evaluate(course.time(), course.state(), &mut outline.values);
        }
        let values = there.then_some(&outline.values[..]);
        play.change_values(|shown| shown.set_outline_values(values));
    }

    fn make_outline(&self, play: &Play, document: &Document) -> Option<(Outline, Vec<Follows>)> {
        let model = play.model();
        let scene = document.program.scene(play.basis().tag())?;
        let roots: Vec<_> = scene.values.iter().map(|value| value.node).collect();
        let (mut columns, mut inputs) = (Vec::new(), Vec::new());
        for (index, measured) in self.columns.iter().enumerate() {
            let node = measured.observed.node;
            if !measured.name.ends_with('\'') && inputs.iter().all(|(other, _)| *other != node) {
                inputs.push((node, Node::Parameter((model.parameters.len() + columns.len()) as u32)));
                columns.push(index);
            }
        }
        let mut graph = Graph::default();
        let roots = model.graph.rebuild_from_inputs(&mut graph, &roots, &inputs);
        let follows = |root| {
            let reached = graph.reachable(&[root]);
            let any = |test: &dyn Fn(Node) -> bool| reached.iter().any(|id| test(graph.node(*id)));
            if any(&|node| matches!(node, Node::State(_))) {
                Follows::Computed
            } else if any(&|node| inputs.iter().any(|(_, input)| *input == node)) {
                Follows::Measured
            } else {
                Follows::Nothing
            }
        };
        let follows: Vec<Follows> = roots.iter().map(|root| follows(*root)).collect();
        follows.contains(&Follows::Measured).then(|| {
            let outline = Outline {
                routine: Routine::from_graph(&graph, model.states.len(), &roots),
                columns,
                values: vec![0.0; follows.len()],
                inputs: Vec::new(),
            };
            (outline, follows)
        })
    }
}
