//! A program as bytes, for a page that plays it without the parsers of the language.
//!
//! A bundle is a signature, a version, and the program in the format of [postcard](https://postcard.jamesmunns.com).
//! Reading checks everything that running relies on: a bundle that is read cannot make the engine reach beyond its model.

use crate::{
    Aggregate, Choices, Compiled, Drag, Dragged, Drawing, Drawn, Members, Model, Node, NodeId, OfDrawing, Parameter,
    Piece, Program, Scene, Sweep, Taken, Trail,
};

/// What a bundle begins with.
const SIGNATURE: &[u8] = b"meniscus";
/// The version of the format; raised whenever a program of an earlier version would be misread.
const VERSION: u8 = 8;
/// The longest bundle, in bytes. Documents are at most 1 MiB long.
const LONGEST: usize = 16 << 20;

/// Why bytes are not a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BundleError {
    /// They do not begin as a bundle does.
    NoBundle,
    /// They are a bundle of this other version.
    OtherVersion(u8),
    /// There are more of them than a bundle may have.
    TooLong,
    /// They end too early, go on too long, or contradict themselves.
    Damaged,
}

/// Writes a program.
///
/// # Errors
/// [`BundleError::TooLong`], and [`BundleError::Damaged`] for a program that could not be read again.
pub fn write(program: &Program) -> Result<Vec<u8>, BundleError> {
    check(program)?;
    let mut bytes = [SIGNATURE, &[VERSION]].concat();
    bytes.extend(postcard::to_allocvec(program).map_err(|_| BundleError::Damaged)?);
    if bytes.len() > LONGEST { Err(BundleError::TooLong) } else { Ok(bytes) }
}

/// Reads a program that [`write`] has written.
///
/// # Errors
/// Every [`BundleError`].
pub fn read(bytes: &[u8]) -> Result<Program, BundleError> {
    if bytes.len() > LONGEST {
        return Err(BundleError::TooLong);
    }
    let rest = bytes.strip_prefix(SIGNATURE).ok_or(BundleError::NoBundle)?;
    let (version, rest) = rest.split_first().ok_or(BundleError::NoBundle)?;
    if *version != VERSION {
        return Err(BundleError::OtherVersion(*version));
    }
    let (program, rest) = postcard::take_from_bytes::<Program>(rest).map_err(|_| BundleError::Damaged)?;
    if !rest.is_empty() {
        return Err(BundleError::Damaged);
    }
    check(&program)?;
    Ok(program)
}

/// Whether everything that the program refers to by number is there.
fn check(program: &Program) -> Result<(), BundleError> {
    let model = &program.model;
    let runs = of_runs(model);
    let known = |node: &NodeId| runs.get(node.0 as usize) == Some(&false);
    let compiled = |value: &Compiled| known(&value.node);
    let parameter = |index: &usize| *index < model.parameters.len();
    let assignments =
        |values: &[crate::Assignment]| values.iter().all(|one| parameter(&one.parameter) && compiled(&one.value));
    let nodes = model.states.iter().flat_map(|state| [&state.initial, &state.derivative]);
    let good = model.sensitive.is_none()
        && inputs_exist(model)
        && model.parameters.iter().all(|one| one.takes(one.value) && texts_exist(one, model.texts.len()))
        && nodes.into_iter().all(known)
        && orders_ascend(model)
        && model.tables.iter().all(|table| (table.interpolation as usize) < model.graph.interpolations().len())
        && drawings_exist(model)
        && model.quantities.iter().all(|quantity| compiled(&quantity.value))
        && model.events.iter().all(|event| {
            let targets = event.actions.iter();
            let mut targets = targets.map(|(state, value)| (*state as usize) < model.states.len() && known(value));
            known(&event.condition) && targets.all(|good| good) && event.jump.is_none()
        })
        && model.buttons.iter().all(|button| (button.event as usize) < model.events.len())
        && program.speed.as_ref().is_none_or(|speed| speed.per_second.is_finite() && speed.per_second > 0.0)
        && program.vary.iter().all(parameter)
        && program.plots.iter().all(|plot| plot.expressions().all(|curve| compiled(&curve.value)))
        && program.plots.iter().all(|plot| drawing_exists(&plot.drawing, plot.curves.len(), model, &known))
        && program.presets.iter().all(|preset| assignments(&preset.values))
        && program.questions.iter().enumerate().all(|(number, question)| {
            let hidden = |index: &usize| *index < model.quantities.len();
            assignments(&question.setup)
                && compiled(&question.answer)
                && question.hides.iter().all(hidden)
                && question.after.iter().all(|earlier| *earlier < number)
        })
        && program.checks.iter().all(|check| {
            let claim = |claim: &crate::Claim| {
                claim.values().into_iter().all(compiled) && claim.condition().is_none_or(|node| known(&node))
            };
            assignments(&check.setup) && check.claims.iter().all(claim)
        })
        && program.editions.first().is_some_and(|first| first.questions.len() == program.questions.len())
        && program.editions.iter().filter_map(|edition| edition.scene.as_ref()).all(|scene| {
            let drawn = scene.values.iter().all(compiled);
            let mut named = scene.trails.iter().flat_map(Trail::values).chain(scene.length);
            let named = named.all(|index| index < scene.values.len());
            drawn && named && element_exists(&scene.root, scene, model)
        });
    if good { Ok(()) } else { Err(BundleError::Damaged) }
}

/// Whether a plot of so many curves can come about as it says.
fn drawing_exists(drawing: &Drawing, curves: usize, model: &Model, known: &impl Fn(&NodeId) -> bool) -> bool {
    match drawing {
        Drawing::Run => true,
        Drawing::At(count) => known(count),
        Drawing::Profile(profile) => {
            let good = |members: &Members| {
                (1..=Members::MOST).contains(&members.x.len())
                    && members.x.len() == members.y.len()
                    && members.x.iter().chain(&members.y).all(known)
            };
            profile.members.len() == curves && profile.members.iter().all(good)
        }
        Drawing::Histogram(members) => curves == 1 && members.len() <= Members::MOST && members.iter().all(known),
        Drawing::Every(every) => known(&every.period) && every.from.is_none_or(|from| from.is_finite() && from >= 0.0),
        Drawing::Sweep(sweep) => {
            sweep.parameter < model.parameters.len()
                && [sweep.low, sweep.high, sweep.step, sweep.until].iter().all(|number| number.is_finite())
                && sweep.step > 0.0
                && (1..=Sweep::MOST).contains(&sweep.count())
                && sweep.taken.len() == curves
                && sweep.aggregates.len() <= Aggregate::MOST
                && sweep.aggregates.iter().all(|one| known(&one.of) && sweep.counts_from(one.from))
                && sweep.taken.iter().all(|taken| is_taken(*taken, sweep, model))
                && sweep.taken.iter().all(|taken| matches!(taken, Taken::Points(_)) == sweep.is_of_points())
                && sweep.at.as_ref().is_none_or(known)
        }
    }
}

/// Whether a curve over the values of a parameter can be computed: it reads no more numbers of a run than are taken.
fn is_taken(taken: Taken, sweep: &Sweep, model: &Model) -> bool {
    match taken {
        Taken::Value => true,
        Taken::Points(from) => sweep.counts_from(from),
        Taken::Run(node) => {
            let numbers = model.parameters.len() + sweep.aggregates.len();
            (node.0 as usize) < model.graph.len()
                && sweep.counts_from(0.0)
                && model.depends(node).parameters.iter().all(|number| (*number as usize) < numbers)
        }
    }
}

/// For each node whether it is computed from parameters behind those of the model, which only [`Taken::Run`] may be.
fn of_runs(model: &Model) -> Vec<bool> {
    let mut found: Vec<bool> = Vec::with_capacity(model.graph.len());
    for number in 0..model.graph.len() {
        let id = NodeId(number as u32);
        let mut of_run =
            matches!(model.graph.node(id), Node::Parameter(index) if index as usize >= model.parameters.len());
        model.graph.for_each_operand(id, |operand| of_run |= found.get(operand.0 as usize).is_none_or(|one| *one));
        found.push(of_run);
    }
    found
}

/// Whether each curve that the reader draws belongs to a table, and to no other.
fn drawings_exist(model: &Model) -> bool {
    /// No expression is differentiated so often.
    const DEEPEST: u32 = 16;
    let drawn = |number: usize| model.tables.get(number).and_then(|table| table.drawn.as_ref());
    let curves = model.graph.interpolations();
    let own = |number: usize| OfDrawing { table: number as u32, derivative: 0 };
    let tables = model.tables.iter().enumerate().all(|(number, table)| {
        let curve = curves.get(table.interpolation as usize).and_then(|curve| curve.drawing());
        curve == table.drawn.as_ref().map(|_| own(number)) && table.drawn.as_ref().is_none_or(Drawn::is_sound)
    });
    tables
        && curves
            .iter()
            .filter_map(|curve| curve.drawing())
            .all(|of| of.derivative <= DEEPEST && drawn(of.table as usize).is_some())
}

/// Whether the texts of a choice are there.
fn texts_exist(parameter: &Parameter, texts: usize) -> bool {
    match &parameter.choices {
        Choices::Texts(own) => own.iter().all(|&text| (text as usize) < texts),
        Choices::Numbers | Choices::Switch | Choices::Seed => true,
    }
}

/// Whether the graph reads states that there are.
fn inputs_exist(model: &Model) -> bool {
    (0..model.graph.len()).all(|number| match model.graph.node(NodeId(number as u32)) {
        Node::Initial(index) | Node::State(index) => (index as usize) < model.states.len(),
        _ => true,
    })
}

/// Whether the orders of each variable stand together, lowest first.
fn orders_ascend(model: &Model) -> bool {
    let first = model.states.first().is_none_or(|first| first.order == 0);
    first
        && model.states.windows(2).all(|pair| {
            let [before, state] = pair else { return true };
            state.order == if state.variable == before.variable { before.order + 1 } else { 0 }
        })
}

/// Whether an element of a scene shows values and drags states and parameters that there are.
fn element_exists(element: &crate::Element, scene: &Scene, model: &Model) -> bool {
    let value = |index: &usize| *index < scene.values.len();
    let piece = |piece: &Piece| match piece {
        Piece::Trail(index) => *index < scene.trails.len(),
        other => other.value().is_none_or(|index| value(&index)),
    };
    let target = |target: Dragged| match target {
        Dragged::State(index) => index < model.states.len(),
        Dragged::Parameter(index) => index < model.parameters.len(),
    };
    let dragged = |drag: &Drag| target(drag.target) && drag.up.iter().chain(&drag.right).all(value);
    let drag = element.drag.as_ref().is_none_or(dragged);
    drag && element.attributes.iter().all(|attribute| attribute.value.iter().all(piece))
        && element.children.iter().all(|child| match child {
            crate::Child::Element(inner) => element_exists(inner, scene, model),
            crate::Child::Text(text) => text.iter().all(piece),
        })
}
