//! Rendering of the scene to pixels: its nodes are serialized to SVG, which the browser draws. Colours are those of the
//! scene, independent of the theme of the page, so that the same film has the same bits.

use super::ruler::Ruler;
use crate::film::access::drawn;
use desk::FILMED_SIZE;
use film::Plane;
use play::Play;
use program::{Child, Element, Piece};
use std::cell::RefCell;
use view::browser;
use view::scene::picture::Picture;
use view::views::document;
use wasm_bindgen::JsCast;
use web_sys::{
    Blob, BlobPropertyBag, HtmlCanvasElement, HtmlImageElement, SvgElement, SvgGraphicsElement, Url, XmlSerializer,
};

/// Place of the scene in the picture: left, top, width, height, px. The ruler is drawn beside it.
const PLACE: [f64; 4] = [8.0, 8.0, 544.0, 344.0];
/// Background and ink of the picture.
const GROUND: &str = "#f2f0ea";
const INK: &str = "#22303a";
/// SVG elements of a scene with a position.
const SHAPES: &str = "path, circle, ellipse, rect, line, polyline, polygon";
/// Maximum number of shapes with known truth.
const MOST_SHAPES: usize = 300;

/// Invisible copy of the scene.
pub struct Drawing {
    host: web_sys::Element,
    picture: Picture,
    /// Root of the scene in the picture.
    root: SvgElement,
    shapes: Vec<SvgGraphicsElement>,
    canvas: HtmlCanvasElement,
    /// SVG text before and after the scene.
    frame: [String; 2],
    /// Scene drawn last, with its grey values.
    last: RefCell<Option<(String, Plane)>>,
    /// Ruler, if the scene has a scale.
    pub ruler: Option<Ruler>,
}

impl Drop for Drawing {
    fn drop(&mut self) {
        self.host.remove();
    }
}

/// Pixels of the picture per unit of the scene.
pub fn pixels(play: &Play) -> Option<f64> {
    let scene = play.program().scene(play.basis().tag())?;
    let [width, height] = scene.size()?;
    let pixels = (PLACE[2] / width).min(PLACE[3] / height);
    (pixels > 0.0 && pixels.is_finite()).then_some(pixels)
}

impl Drawing {
    /// Copy of the scene of a simulation; `None` without a scene.
    pub fn of(play: &mut Play) -> Option<Self> {
        let mut scene = play.program().scene(play.basis().tag())?.clone();
        let quantities: Vec<bool> = scene.values.iter().map(|value| !value.unit.text.is_empty()).collect();
        remove_signs(&mut scene.root, &quantities);
        let ruler = pixels(play).and_then(|pixels| Ruler::of(play, pixels));
        let host = document().create_element("div").ok()?;
        let [width, height] = FILMED_SIZE;
        let style = format!(
            "position:fixed;left:0;top:0;width:{width}px;height:{height}px;visibility:hidden;pointer-events:none;contain:strict"
        );
        let _ = host.set_attribute("style", &style);
        let _ = host.set_attribute("aria-hidden", "true");
        let picture = Picture::build(&scene, &host)?;
        let root = picture.root().clone();
        for (name, value) in ["x", "y", "width", "height"].into_iter().zip(PLACE) {
            let _ = root.set_attribute(name, &value.to_string());
        }
        document().body()?.append_child(&host).ok()?;
        let nodes = root.query_selector_all(SHAPES).ok()?;
        let nodes = (0..nodes.length()).filter_map(|place| nodes.get(place)?.dyn_into::<SvgGraphicsElement>().ok());
        let seen = |node: &SvgGraphicsElement| node.closest("defs, clipPath").ok().flatten().is_none();
        let shapes = nodes.filter(seen).take(MOST_SHAPES).collect();
        let open = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" color=\"{INK}\" \
             font-family=\"system-ui, sans-serif\"><rect width=\"{width}\" height=\"{height}\" fill=\"{GROUND}\"/>"
        );
        let close = format!("<g fill=\"{INK}\">{}</g></svg>", ruler.as_ref().map(Ruler::drawn).unwrap_or_default());
        let canvas = document().create_element("canvas").ok()?.dyn_into().ok()?;
        Some(Self { host, picture, root, shapes, canvas, frame: [open, close], last: RefCell::default(), ruler })
    }

    /// Updates the nodes to the time shown.
    pub fn follow(&mut self, play: &mut Play) {
        self.picture.draw(play);
    }

    /// Centre of each shape in px of the picture; NaN if it is not visible.
    pub fn places(&self) -> Vec<[f64; 2]> {
        let corner = self.root.get_bounding_client_rect();
        let place = |shape: &SvgGraphicsElement| {
            let around = shape.get_b_box().ok()?;
            let to_screen = shape.get_screen_ctm()?;
            let [x, y] = [around.x() + around.width() / 2.0, around.y() + around.height() / 2.0].map(f64::from);
            let [a, b, c, d, e, f] =
                [to_screen.a(), to_screen.b(), to_screen.c(), to_screen.d(), to_screen.e(), to_screen.f()]
                    .map(f64::from);
            Some([a * x + c * y + e - corner.left() + PLACE[0], b * x + d * y + f - corner.top() + PLACE[1]])
        };
        self.shapes.iter().map(|shape| place(shape).unwrap_or([f64::NAN; 2])).collect()
    }

    /// Grey values of the picture.
    pub async fn plane(&self) -> Option<Plane> {
        let scene = XmlSerializer::new().ok()?.serialize_to_string(&self.root).ok()?;
        if let Some((last, plane)) = &*self.last.borrow()
            && *last == scene
        {
            return Some(plane.clone());
        }
        let [open, close] = &self.frame;
        let kind = BlobPropertyBag::new();
        kind.set_type("image/svg+xml");
        let parts = js_sys::Array::of1(&format!("{open}{scene}{close}").into());
        let blob = Blob::new_with_str_sequence_and_options(&parts, &kind).ok()?;
        let url = Url::create_object_url_with_blob(&blob).ok()?;
        let image = HtmlImageElement::new().ok()?;
        image.set_src(&url);
        let decoded = browser::wait(image.decode()).await;
        let _ = Url::revoke_object_url(&url);
        decoded.ok()?;
        let plane = drawn(&image, &self.canvas, FILMED_SIZE)?;
        *self.last.borrow_mut() = Some((scene, plane.clone()));
        Some(plane)
    }
}

/// Removes arrows, trails, and readings of quantities, which a camera would not see. Numbers of scales are kept.
/// `quantities`: true for each value of the scene with a unit.
fn remove_signs(element: &mut Element, quantities: &[bool]) {
    let is_sign = |element: &Element| {
        let arrow =
            |piece: &Piece| matches!(piece, Piece::Literal(text) if text.split(' ').any(|class| class == "arrow"));
        let trail = |piece: &Piece| matches!(piece, Piece::Trail(_));
        let mut attributes = element.attributes.iter();
        attributes.any(|one| one.name == "class" && one.value.iter().any(arrow) || one.value.iter().any(trail))
    };
    element.children.retain_mut(|child| match child {
        Child::Element(child) if is_sign(child) || child.name == "text" && reads(child, quantities) => false,
        Child::Element(child) => {
            remove_signs(child, quantities);
            true
        }
        Child::Text(_) => true,
    });
}

/// True if a text shows a value with a unit.
fn reads(element: &Element, quantities: &[bool]) -> bool {
    let is_quantity = |piece: &Piece| piece.value().is_some_and(|index| quantities.get(index) == Some(&true));
    element.children.iter().any(|child| match child {
        Child::Element(child) => reads(child, quantities),
        Child::Text(template) => template.iter().any(is_quantity),
    })
}
