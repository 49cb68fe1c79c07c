//! Geometry of the elements on the screen: edges and grips in picture units, and conversion to their own lengths.

use super::matrix::Matrix;
use desk::DrawingPlaces;
use document::drawing::{Grip, Ground, Located};
use document::edit::Measure;
use wasm_bindgen::JsCast;
use web_sys::{Element, Node, SvgElement, SvgGraphicsElement};

/// Minimum distance of grid lines, and step of moves without the grid, in CSS pixels.
const GRID: f64 = 8.0;
const FREE: f64 = 0.9;

/// Geometry of the whole picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// The `viewBox` of the picture: left, top, width, height.
    pub view_box: [f64; 4],
    /// Size of a CSS pixel, in picture units.
    pub pixel: f64,
    /// Coordinate system of new elements.
    pub ground: Ground,
    /// Geometry of the elements; `None` for one that is not in the picture.
    pub items: Vec<Option<SeenItem>>,
}

/// Geometry of an element.
#[derive(Clone, Debug, PartialEq)]
pub struct SeenItem {
    /// Left, top, right and bottom edge, in picture units.
    pub edges: [f64; 4],
    /// Grips with their places, in picture units; the grip for the whole element has no place.
    pub grips: Vec<(Grip, [f64; 2])>,
    /// Centre of rotation, in picture units.
    pub middle: Option<[f64; 2]>,
    /// Map from picture units to the coordinates of the element's lengths.
    inwards: Matrix,
    /// Rotation angle in these coordinates, clockwise, in radians.
    turn: f64,
    /// Drawing units per SI unit of length.
    scale: f64,
    unit: String,
}

impl SeenItem {
    /// Converts a displacement in picture units to the element's lengths: to the right and downwards, in a frame
    /// (`framed`) upwards; for a corner or edge, along the sides of the element.
    pub fn way(&self, way: [f64; 2], grip: Grip, framed: bool) -> [f64; 2] {
        let [x, y] = self.inwards.way(way);
        let turn = if matches!(grip, Grip::Corner | Grip::Edge) { self.turn } else { 0.0 };
        let (sine, cosine) = (libm::sin(turn), libm::cos(turn));
        let [right, down] = [cosine * x + sine * y, cosine * y - sine * x];
        let up = if framed { -down } else { down };
        [right / self.scale, up / self.scale]
    }

    /// Units of the element's own coordinates per picture unit.
    pub fn inwards_scale(&self) -> f64 {
        self.inwards.scale()
    }

    /// Step of its moves.
    pub fn measure(&self, pixel: f64, on_grid: bool) -> Measure {
        let least = pixel * self.inwards.scale() * if on_grid { GRID } else { FREE };
        Measure::round(&self.unit, least / self.scale, self.scale)
    }
}

impl Seen {
    /// Measures the picture `root`; `None` while it has no layout.
    pub fn measure(root: &SvgElement, places: DrawingPlaces) -> Option<Self> {
        let from_window = from_window(root)?;
        let view_box = root.get_attribute("viewBox")?;
        let numbers = view_box.split([' ', ',']).filter(|text| !text.is_empty()).map(|text| text.parse::<f64>().ok());
        let view_box: [f64; 4] = numbers.collect::<Option<Vec<f64>>>()?.try_into().ok()?;
        let item = |place: &Option<Located>| seen_item(root, &from_window, place.as_ref()?);
        let items = places.elements.iter().map(item).collect();
        Some(Self { view_box, pixel: from_window.scale(), ground: places.ground, items })
    }

    /// Unit and grid step for new elements.
    pub fn ground_measure(&self) -> Measure {
        Measure::round(&self.ground.unit, GRID * self.pixel / self.ground.scale, self.ground.scale)
    }

    /// Place of a new element, in picture units: the given place or the centre, shifted by grid steps while an element
    /// of its size is there.
    pub fn spot(&self, pointed: Option<[f64; 2]>) -> [f64; 2] {
        let [left, top, width, height] = self.view_box;
        let holds = |[x, y]: &[f64; 2]| (left..=left + width).contains(x) && (top..=top + height).contains(y);
        let [mut x, mut y] = pointed.filter(holds).unwrap_or([left + width / 2.0, top + height / 2.0]);
        let step = self.ground_measure().step * self.ground.scale;
        let largest = 1.2 * self.good_length() * self.ground.scale;
        let edges = self.items.iter().flatten().map(|item| item.edges);
        let middle = |[left, top, right, bottom]: [f64; 4]| {
            (right - left <= largest && bottom - top <= largest).then_some([(left + right) / 2.0, (top + bottom) / 2.0])
        };
        let middles: Vec<[f64; 2]> = edges.filter_map(middle).collect();
        for _ in &middles {
            if middles.iter().any(|other| (other[0] - x).abs() < step && (other[1] - y).abs() < step) {
                (x, y) = (x + 2.0 * step, y + 2.0 * step);
            }
        }
        [x, y]
    }

    /// Converts a place in picture units to lengths of the ground.
    pub fn on_ground(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Ground { origin, scale, framed, .. } = &self.ground;
        let (right, down) = ((x - origin[0]) / scale, (y - origin[1]) / scale);
        [right, if *framed { -down } else { down }]
    }

    /// Length of an easily visible element, in lengths of the ground.
    pub fn good_length(&self) -> f64 {
        let [_, _, width, height] = self.view_box;
        width.min(height) / 3.0 / self.ground.scale
    }

    /// Element at a place that hits none directly: the smallest one whose edges, extended by `margin`, contain it.
    pub fn near(&self, [x, y]: [f64; 2], margin: f64) -> Option<usize> {
        let area = |[left, top, right, bottom]: [f64; 4]| (right - left + margin) * (bottom - top + margin);
        let holds = |[left, top, right, bottom]: [f64; 4]| {
            (left - margin..=right + margin).contains(&x) && (top - margin..=bottom + margin).contains(&y)
        };
        let items = self.items.iter().enumerate().filter_map(|(number, item)| Some((number, item.as_ref()?.edges)));
        let held = items.filter(|(_, edges)| holds(*edges));
        held.min_by(|(_, one), (_, other)| area(*one).total_cmp(&area(*other))).map(|(number, _)| number)
    }
}

fn seen_item(root: &SvgElement, from_window: &Matrix, place: &Located) -> Option<SeenItem> {
    let node = at_path(root, place.paths.first()?)?;
    let parent: SvgGraphicsElement = node.parent_element()?.dyn_into().ok()?;
    let outwards = Matrix::of(&parent.get_screen_ctm()?);
    let to_picture = |spot: [f64; 2]| from_window.point(outwards.point(spot));
    let bounds = node.get_bounding_client_rect();
    let [left, top] = from_window.point([bounds.left(), bounds.top()]);
    let [right, bottom] = from_window.point([bounds.right(), bounds.bottom()]);
    let inverse = outwards.inverse()?;
    // From the picture via the window to the element.
    let back = from_window.inverse()?;
    let inwards = inverse.after(&back);
    Some(SeenItem {
        edges: [left, top, right, bottom],
        grips: place.grips.iter().map(|(grip, spot)| (*grip, to_picture(*spot))).collect(),
        middle: place.middle.map(to_picture),
        inwards,
        turn: place.turn,
        scale: place.scale,
        unit: place.unit.clone(),
    })
}

/// Map from the window to a picture, at the present scroll position.
pub fn from_window(root: &SvgElement) -> Option<Matrix> {
    let root: &SvgGraphicsElement = root.dyn_ref()?;
    Matrix::of(&root.get_screen_ctm()?).inverse()
}

/// Node of an element, from its child indices starting at the root.
fn at_path(root: &SvgElement, path: &[usize]) -> Option<Element> {
    let mut node: Node = root.clone().into();
    for number in path {
        node = node.child_nodes().get(u32::try_from(*number).ok()?)?;
    }
    node.dyn_into().ok()
}

/// Child indices of a node, starting at the root; `None` for a node outside it.
pub fn path_of(root: &SvgElement, node: &Node) -> Option<Vec<usize>> {
    let root: &Node = root.as_ref();
    let mut path = Vec::new();
    let mut at = node.clone();
    while !at.is_same_node(Some(root)) {
        let mut number = 0;
        let mut before = at.previous_sibling();
        while let Some(sibling) = before {
            number += 1;
            before = sibling.previous_sibling();
        }
        path.push(number);
        at = at.parent_node()?;
    }
    path.reverse();
    Some(path)
}
