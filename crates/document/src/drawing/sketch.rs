//! Places of the elements of a drawing in its picture.

use super::grip::Grip;
use super::item::{Drawing, Item, read};
use crate::BlockKind;
use crate::expressions::Expressions;
use crate::open::File;
use crate::scene::{Marks, build_marked};
use model::Span;
use program::{Model, NodeId};
use std::collections::BTreeMap;
use units::{Dimension, Language, Unit};

/// Distance of the turning grip from the edge, in units of the drawing.
const LEVER: f64 = 22.0;

/// A drawing with the expressions of its places in the picture.
#[derive(Clone, Debug)]
pub struct Sketch {
    /// Elements of the drawing.
    pub drawing: Drawing,
    /// The model; its graph contains the nodes of the places.
    pub model: Model,
    /// Nodes of the graph from whose values the places are computed.
    pub nodes: Vec<NodeId>,
    places: Vec<Place>,
    ground: Option<GroundNodes>,
}

/// Nodes of the first frame, as indices into [`Sketch::nodes`].
#[derive(Clone, Debug)]
struct GroundNodes {
    origin: [usize; 2],
    scale: usize,
    dimension: Dimension,
    unit: String,
}

/// Coordinate system for new elements: the first frame, or the drawing itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// Position of its origin in the drawing.
    pub origin: [f64; 2],
    /// Units of the drawing per SI unit of length.
    pub scale: f64,
    /// Unit for writing lengths, without brackets.
    pub unit: String,
    /// Dimension of its lengths.
    pub dimension: Dimension,
    /// True for a frame, in which y points up.
    pub framed: bool,
}

/// Nodes of an element, as indices into [`Sketch::nodes`].
#[derive(Clone, Debug, Default)]
struct Place {
    paths: Vec<Vec<usize>>,
    scale: Option<usize>,
    unit: String,
    spots: BTreeMap<String, [usize; 2]>,
    numbers: BTreeMap<String, usize>,
}

/// Place of an element in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Located {
    /// Paths of child indices from the `svg` element to each copy of the element; text nodes count as children.
    pub paths: Vec<Vec<usize>>,
    /// Units of the drawing per SI unit of length.
    pub scale: f64,
    /// Unit of its lengths, without brackets.
    pub unit: String,
    /// Grips with their positions, in the units in which the element itself is drawn. The position of [`Grip::Whole`] has
    /// no meaning.
    pub grips: Vec<(Grip, [f64; 2])>,
    /// Position given by `at`, the centre of rotation.
    pub middle: Option<[f64; 2]>,
    /// Rotation in the drawing, clockwise, in radians.
    pub turn: f64,
}

impl Sketch {
    /// Reads the drawing of a document. `None` if it has none, or if its model has errors.
    pub fn read(source: &str) -> Option<Self> {
        let mut file = File::new(source);
        let drawing = read(&file.outline)?;
        let checked = file.model()?;
        let mut model = checked.model;
        let marks = {
            let block = file.outline.blocks_of(BlockKind::Scene).next()?;
            let mut expressions = Expressions::new(source, &mut model, &checked.places, &checked.functions);
            build_marked(&mut expressions, block.content.range(), Language::default())?
        };
        let mut nodes = Vec::new();
        let places = drawing.items.iter().enumerate();
        let places = places.map(|(number, item)| place(source, (&drawing, number), item, &marks, &mut nodes)).collect();
        let frame = drawing.items.iter().position(super::item::Item::is_frame);
        let ground = marks.ground().zip(frame).map(|(space, frame)| {
            let mut index = |node| kept(&mut nodes, node);
            let si = || Unit::si(space.dimension).to_string();
            GroundNodes {
                origin: [index(space.origin.x), index(space.origin.y)],
                scale: index(space.scale),
                dimension: space.dimension,
                unit: drawing.unit_of(source, frame).map_or_else(si, str::to_owned),
            }
        });
        Some(Self { drawing, model, nodes, places, ground })
    }

    /// Coordinate system for new elements, from the values of [`Self::nodes`], one each.
    pub fn ground(&self, values: &[f64]) -> Ground {
        let value = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
        match &self.ground {
            Some(nodes) => Ground {
                origin: nodes.origin.map(value),
                scale: value(nodes.scale),
                unit: nodes.unit.clone(),
                dimension: nodes.dimension,
                framed: true,
            },
            None => {
                Ground { origin: [0.0; 2], scale: 1.0, unit: String::new(), dimension: Dimension::NONE, framed: false }
            }
        }
    }

    /// Place of an element, from the values of [`Self::nodes`], one each. `None` if the element is not in the picture.
    pub fn locate(&self, number: usize, values: &[f64]) -> Option<Located> {
        let (place, item) = (self.places.get(number)?, self.drawing.items.get(number)?);
        if place.paths.is_empty() {
            return None;
        }
        let value = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
        let known = Values {
            item,
            spot: |name: &str| place.spots.get(name).map(|spot| spot.map(value)),
            number: |name: &str| place.numbers.get(name).map(|index| value(*index)),
        };
        let grips = item.grips().into_iter().filter_map(|grip| Some((grip, known.grip(grip)?)));
        let is_drawn = |(_, spot): &(Grip, [f64; 2])| spot.iter().all(|value| value.is_finite());
        Some(Located {
            paths: place.paths.clone(),
            scale: place.scale.map_or(1.0, value),
            unit: place.unit.clone(),
            grips: grips.filter(is_drawn).collect(),
            middle: known.middle(),
            turn: known.turn(),
        })
    }
}

/// Appends a node and returns its index.
fn kept(nodes: &mut Vec<NodeId>, node: NodeId) -> usize {
    nodes.push(node);
    nodes.len() - 1
}

fn place(
    source: &str,
    (drawing, number): (&Drawing, usize),
    item: &Item,
    marks: &Marks,
    nodes: &mut Vec<NodeId>,
) -> Place {
    let mut index = |node| kept(nodes, node);
    let mut place = Place::default();
    for marked in marks.copies(item.span.start) {
        place.paths.push(marked.path.clone());
        if place.scale.is_none() {
            place.scale = Some(index(marked.scale));
            let si = || Unit::si(marked.dimension).to_string();
            place.unit = drawing.unit_of(source, number).filter(|_| item.framed).map_or_else(si, str::to_owned);
        }
    }
    for attribute in &item.attributes {
        let Span { start, .. } = attribute.value;
        if let Some(spot) = marks.spot(start) {
            place.spots.insert(attribute.name.clone(), [index(spot.x), index(spot.y)]);
        }
        if let Some(node) = marks.number(start) {
            place.numbers.insert(attribute.name.clone(), index(node));
        }
    }
    place
}

/// Values of the attributes of an element, in units of the drawing.
struct Values<'a, S, N> {
    item: &'a Item,
    spot: S,
    number: N,
}

impl<S, N> Values<'_, S, N>
where
    S: Fn(&str) -> Option<[f64; 2]>,
    N: Fn(&str) -> Option<f64>,
{
    fn pair(&self, x: &str, y: &str) -> Option<[f64; 2]> {
        Some([(self.number)(x)?, (self.number)(y)?])
    }

    fn middle(&self) -> Option<[f64; 2]> {
        (self.spot)("at").or_else(|| self.pair("cx", "cy"))
    }

    /// Half of its width and height, if they are known.
    fn half(&self) -> Option<[f64; 2]> {
        let size = (self.spot)("size").or_else(|| self.pair("width", "height"));
        size.map(|[width, height]| [width / 2.0, height / 2.0])
    }

    fn radius(&self) -> f64 {
        (self.number)("r").unwrap_or(self.item.usual_radius())
    }

    /// Rotation in the drawing, clockwise, in radians.
    fn turn(&self) -> f64 {
        let turn = (self.number)("turn").unwrap_or(0.0);
        if self.item.framed { -turn } else { turn }
    }

    /// Position at an offset from the middle, rotated with the element.
    fn beside(&self, middle: [f64; 2], [right, down]: [f64; 2]) -> [f64; 2] {
        let angle = self.turn();
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        [middle[0] + cosine * right - sine * down, middle[1] + sine * right + cosine * down]
    }

    fn grip(&self, grip: Grip) -> Option<[f64; 2]> {
        match grip {
            Grip::Whole => Some([0.0; 2]),
            Grip::Beginning => (self.spot)("from").or_else(|| self.pair("x1", "y1")),
            Grip::End => (self.spot)("to").or_else(|| self.pair("x2", "y2")),
            Grip::Corner => {
                let half = self.half()?;
                if let Some(middle) = self.middle() {
                    return Some(self.beside(middle, half));
                }
                let [x, y] = self.pair("x", "y")?;
                // In a frame, `y` is the lower edge.
                let height = if self.item.framed { -2.0 * half[1] } else { 2.0 * half[1] };
                Some([x + 2.0 * half[0], y + height])
            }
            Grip::Edge => Some(self.beside(self.middle()?, [self.radius(), 0.0])),
            Grip::Turn => {
                let reach = self.half().map(|[_, height]| height).unwrap_or_else(|| self.radius());
                Some(self.beside(self.middle()?, [0.0, -reach - LEVER]))
            }
        }
    }
}
