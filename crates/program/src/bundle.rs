//! A program as bytes, for a page that runs it without the parsers of the language.
//!
//! A bundle is a signature, a version, and the program in the format of [postcard](https://postcard.jamesmunns.com).
//! Reading checks everything the engine relies on: a damaged bundle cannot make it access anything outside its model.

use crate::{
    Aggregate, Choices, Compiled, Drag, Dragged, Drawing, Drawn, Members, Model, Node, NodeId, OfDrawing, Parameter,
    Piece, Program, Scene, SurveyItem, Sweep, Taken, Trail,
};

/// Signature at the start of a bundle.
const SIGNATURE: &[u8] = b"meniscus";
/// Format version; raised whenever a program of an earlier version would be misread.
const VERSION: u8 = 13;
/// Maximum length of a bundle, in bytes. Documents are at most 1 MiB long.
const LONGEST: usize = 16 << 20;

/// Reason why bytes are not a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BundleError {
    /// The signature is missing.
    NoBundle,
    /// The bundle has this other version.
    OtherVersion(u8),
    /// The bundle is longer than the limit (16 MiB).
    TooLong,
    /// The bundle is cut, has trailing bytes, or is inconsistent.
    Damaged,
}

/// Serializes a program.
///
/// # Errors
/// [`BundleError::TooLong`], or [`BundleError::Damaged`] for a program that [`read`] would refuse.
pub fn write(program: &Program) -> Result<Vec<u8>, BundleError> {
    check(program)?;
    let mut bytes = [SIGNATURE, &[VERSION]].concat();
    bytes.extend(postcard::to_allocvec(program).map_err(|_| BundleError::Damaged)?);
    if bytes.len() > LONGEST { Err(BundleError::TooLong) } else { Ok(bytes) }
}

/// Reads a program written by [`write()`].
///
/// # Errors
/// Any [`BundleError`].
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

/// Checks that every index in the program refers to something that exists.
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
        && model
            .parameters
            .iter()
            .all(|one| one.takes(one.value) && assigned_exist(one) && texts_exist(one, model.texts.len()))
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
        && program.vary.iter().chain(&program.main).all(parameter)
        && program.main.len() <= Program::MOST_MAIN
        && program.plots.iter().all(|plot| plot.expressions().all(|curve| compiled(&curve.value)))
        && program.plots.iter().all(|plot| drawing_exists(&plot.drawing, plot.curves.len(), model, &known))
        && program.presets.iter().all(|preset| assignments(&preset.values))
        && program.questions.iter().enumerate().all(|(number, question)| {
            let hidden = |index: &usize| *index < model.quantities.len();
            assignments(&question.setup)
                && question.values().all(compiled)
                && question.hides.iter().all(hidden)
                && question.after.iter().all(|earlier| *earlier < number)
        })
        && program.checks.iter().all(|check| {
            let claim = |claim: &crate::Claim| {
                claim.values().into_iter().all(compiled) && claim.condition().is_none_or(|node| known(&node))
            };
            assignments(&check.setup) && check.claims.iter().all(claim)
        })
        && program.editions.first().is_some_and(|first| {
            first.questions.len() == program.questions.len() && first.survey.len() == program.survey.len()
        })
        && program.survey.len() <= SurveyItem::MOST
        && program.editions.iter().all(|edition| {
            let mut items = program.survey.iter().zip(&edition.survey);
            let mut questions = program.questions.iter().zip(&edition.questions);
            items.all(|(item, text)| item.is_sound(text)) && questions.all(|(question, text)| question.is_sound(text))
        })
        && program.editions.iter().filter_map(|edition| edition.scene.as_ref()).all(|scene| {
            let drawn = scene.values.iter().all(compiled);
            let mut named = scene.trails.iter().flat_map(Trail::values).chain(scene.length);
            let named = named.all(|index| index < scene.values.len());
            drawn && named && element_exists(&scene.root, scene, model)
        });
    if good { Ok(()) } else { Err(BundleError::Damaged) }
}

/// True if a plot with `curves` curves is consistent with its kind of drawing.
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

/// True if a curve of a sweep can be computed: it reads only aggregates that exist.
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

/// True for each node that depends on parameters beyond those of the model, which only [`Taken::Run`] may do; one value per
/// node.
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

/// True if each curve drawn by the reader belongs to exactly one table.
fn drawings_exist(model: &Model) -> bool {
    /// Upper bound of the order of a derivative.
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

/// True if the assigned values of a parameter are consistent.
fn assigned_exist(parameter: &Parameter) -> bool {
    let Some(assigned) = &parameter.assigned else { return true };
    parameter.choices == Choices::Numbers && assigned.grid.is_sound() && assigned.stated.is_finite()
}

/// True if the texts of a choice exist.
fn texts_exist(parameter: &Parameter, texts: usize) -> bool {
    match &parameter.choices {
        Choices::Texts(own) => own.iter().all(|&text| (text as usize) < texts),
        Choices::Numbers | Choices::Switch | Choices::Seed => true,
    }
}

/// True if the graph refers only to existing states.
fn inputs_exist(model: &Model) -> bool {
    (0..model.graph.len()).all(|number| match model.graph.node(NodeId(number as u32)) {
        Node::Initial(index) | Node::State(index) => (index as usize) < model.states.len(),
        _ => true,
    })
}

/// True if the states of each variable are adjacent, in ascending order.
fn orders_ascend(model: &Model) -> bool {
    let first = model.states.first().is_none_or(|first| first.order == 0);
    first
        && model.states.windows(2).all(|pair| {
            let [before, state] = pair else { return true };
            state.order == if state.variable == before.variable { before.order + 1 } else { 0 }
        })
}

/// True if an element of a scene refers only to existing values, trails, states and parameters.
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
    let dragged = |drag: &Drag| target(drag.target) && drag.up.iter().chain(&drag.right).chain(&drag.zero).all(value);
    let drag = element.drag.as_ref().is_none_or(dragged);
    drag && element.attributes.iter().all(|attribute| attribute.value.iter().all(piece))
        && element.children.iter().all(|child| match child {
            crate::Child::Element(inner) => element_exists(inner, scene, model),
            crate::Child::Text(text) => text.iter().all(piece),
        })
}
