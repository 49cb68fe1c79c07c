//! One scale for the drawing and the plot beside it: the plot has the scale of the drawing, and a dotted line leads from what is drawn
//! to the present point of the curve. A ring shows what can be dragged until it has been dragged once.

use super::invitation;
use crate::app::App;
use crate::scene::SceneNodes;
use crate::views::*;
use figure::Point;
use play::Play;
use web_sys::{DomRect, Element, HtmlElement};

/// Height that the bubble needs above the ring, in CSS pixels.
const BUBBLE: f64 = 84.0;

/// Sides in CSS pixels, relative to the body of the stage.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sides {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Sides {
    fn of(rect: &DomRect, body: &DomRect) -> Self {
        Self {
            left: rect.left() - body.left(),
            top: rect.top() - body.top(),
            width: rect.width(),
            height: rect.height(),
        }
    }

    fn middle(self) -> [f64; 2] {
        [self.left + self.width / 2.0, self.top + self.height / 2.0]
    }
}

/// Where the drawing, one of its handles and a plot beside it stand.
#[derive(Clone, Copy, Debug)]
pub struct Beside {
    /// CSS pixels per unit of the drawing, and height of its origin.
    scale: f64,
    origin: f64,
    handle: Sides,
    canvas: Sides,
}

impl Beside {
    /// Measures; `None` unless the plot stands at the right of the drawing.
    pub fn measure(scene: &SceneNodes, handle: usize, canvas: &Element) -> Option<Self> {
        let body = canvas.closest(".stage-body").ok().flatten()?.get_bounding_client_rect();
        let (drawing, matrix) = (scene.root(), scene.root().get_screen_ctm()?);
        let [canvas, drawn] =
            [canvas, drawing.as_ref()].map(|node: &Element| Sides::of(&node.get_bounding_client_rect(), &body));
        let handle = Sides::of(&scene.handle(handle)?.get_bounding_client_rect(), &body);
        let is_beside = canvas.left >= drawn.left + drawn.width && canvas.top < drawn.top + drawn.height;
        let scale = f64::from(matrix.d());
        (is_beside && scale > 0.0).then(|| Self { scale, origin: f64::from(matrix.f()) - body.top(), handle, canvas })
    }

    /// Scale of the drawing for the plot.
    pub fn level(&self, level: play::SceneLevel) -> figure::Level {
        figure::Level { zero: self.origin + self.scale * level.zero - self.canvas.top, unit: self.scale * level.unit }
    }

    /// The line to a point of the plot.
    pub fn lead(&self, to: Point) -> Lead {
        let from = self.handle.left + self.handle.width;
        Lead {
            middle: self.handle.left + self.handle.width / 2.0,
            from,
            width: self.canvas.left + f64::from(to.x) - from,
            height: self.canvas.top + f64::from(to.y),
        }
    }
}

/// Line from a handle to the curve, in CSS pixels relative to the body of the stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lead {
    /// Middle of the handle.
    middle: f64,
    from: f64,
    width: f64,
    height: f64,
}

/// Line and ring over the stage.
pub struct LevelNodes {
    line: HtmlElement,
    ring: HtmlElement,
    shown: Option<Lead>,
    /// Middle of the ring where it was drawn last.
    ringed: Option<[f64; 2]>,
}

impl LevelNodes {
    /// Shows the line, and the ring while the run has not begun. `invites`: nothing has been dragged yet.
    pub fn draw(&mut self, play: &mut Play, lead: Option<Lead>, scene: Option<&SceneNodes>, invites: bool) {
        let rests = !play.time_line().is_playing() && play.course().time() == 0.0;
        if self.shown != lead {
            self.shown = lead;
            let style = self.line.style();
            if let Some(Lead { from, width, height, .. }) = lead {
                let _ = style.set_property("width", &format!("{width:.1}px"));
                let _ = style.set_property("transform", &format!("translate({from:.1}px, {height:.1}px)"));
            }
            self.line.set_hidden(lead.is_none());
        }
        let place = (invites && rests).then(|| match lead {
            Some(lead) => Some([lead.middle, lead.height]),
            None => self.invitation(play, scene?),
        });
        let place = place.flatten();
        if self.ringed != place {
            self.ringed = place;
            if let Some([x, y]) = place {
                let _ = self.ring.style().set_property("transform", &format!("translate({x:.1}px, {y:.1}px)"));
                let _ = self.ring.class_list().toggle_with_force("below", y < BUBBLE);
            }
            self.ring.set_hidden(place.is_none());
        }
    }

    /// What to drag where no line leads to it: the height of the present value, or else the middle of the first handle.
    fn invitation(&self, play: &mut Play, scene: &SceneNodes) -> Option<[f64; 2]> {
        let level = play.grips().level();
        let body = self.ring.parent_element()?.get_bounding_client_rect();
        let handle = scene.handle(level.map_or(0, |level| level.handle))?;
        let [x, y] = Sides::of(&handle.get_bounding_client_rect(), &body).middle();
        let matrix = scene.root().get_screen_ctm()?;
        let height =
            |level: play::SceneLevel| f64::from(matrix.f()) + f64::from(matrix.d()) * level.present - body.top();
        Some([x, level.map_or(y, height)])
    }
}

/// Nodes of line and ring, hidden.
pub fn view(app: App) -> View {
    let words = app.words();
    let mut line = div().class("level-line").attr("aria-hidden", "true").attr("hidden", "");
    let mut ring = div().class("level-ring").attr("aria-hidden", "true").attr("hidden", "");
    let ring_node: HtmlElement = ring.node();
    let bubble = div()
        .class("bubble")
        .child(strong().child(words.drag_here))
        .child(span().class("for-keys").child(words.drag_keys));
    let nodes = LevelNodes { line: line.node(), ring: ring_node, shown: None, ringed: None };
    app.nodes(|all| {
        all.level = Some(nodes);
        all.invites = invitation::stands();
    });
    View::from((line, ring.child(bubble)))
}
