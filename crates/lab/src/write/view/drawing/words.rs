//! Texts of the drawing editor in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    nothing: "This document has no drawing yet.";
    begin: "Begin a drawing";
    add: "Add part";
    palette: "Parts and shapes";
    canvas: "Drawing: choose an element and move it";
    keys: "Arrow keys move what is chosen by a step of the grid, with Shift by ten. Page up and page down choose the next element. Delete removes, Control with D copies, Control with Z takes back.";
    paused: "The text has errors: the drawing can be changed by hand again when they are gone.";
    layers: "Layers";
    layers_none: "Nothing is drawn yet. Add a part.";
    forward: "Forward";
    backward: "Backward";
    copy: "Copy";
    remove: "Remove";
    snap: "Grid";
    align: "Align";
    align_left: "Left edges";
    align_centre: "Centres";
    align_right: "Right edges";
    align_top: "Upper edges";
    align_middle: "Middles";
    align_bottom: "Lower edges";
    chosen_none: "Choose an element in the drawing or in the list to see what it is made of.";
    chosen_several: "elements are chosen";
    called: "Name";
    shows: "Text";
    follows_across: "to the right with";
    follows_up: "upwards with";
    follows_down: "downwards with";
    follows_nothing: "nothing";
    follows_own: "an expression";
    dragged: "Can be dragged";
    in_text: "Show in the text";
    part_at: "Place";
    part_from: "From";
    part_to: "To";
    part_size: "Size";
    part_r: "Radius";
    part_turn: "Turned by";
    part_width: "Width";
    part_length: "Length";
    part_height: "Height";
    part_turns: "Turns";
    part_depth: "Depth";
    part_vector: "Vector";
    part_step: "Step";
    part_first: "First number";
    part_level: "Level";
    part_spacing: "Spacing";
    part_left: "Left level";
    part_right: "Right level";
    part_last: "Seen for";
    part_every: "A dot every";
    part_closed: "Closed when";
    part_points: "Points";
    part_d: "Path";
    part_visible: "Shown when";
    part_fill: "Fill";
    part_stroke: "Line";
    part_stroke_width: "Line width";
    part_x: "Range to the right";
    part_y: "Range upwards";
    part_box: "Box in the drawing";
}

/// Texts in the language of the page.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}

/// Title of an attribute; its own name if it has none.
pub fn attribute(app: App, name: &'static str) -> &'static str {
    let words = of(app);
    match name {
        "at" => words.part_at,
        "from" => words.part_from,
        "to" => words.part_to,
        "size" => words.part_size,
        "r" => words.part_r,
        "turn" => words.part_turn,
        "width" => words.part_width,
        "length" => words.part_length,
        "height" => words.part_height,
        "turns" => words.part_turns,
        "depth" => words.part_depth,
        "vector" => words.part_vector,
        "step" => words.part_step,
        "first" => words.part_first,
        "level" => words.part_level,
        "spacing" => words.part_spacing,
        "left" => words.part_left,
        "right" => words.part_right,
        "last" => words.part_last,
        "every" => words.part_every,
        "closed" => words.part_closed,
        "points" => words.part_points,
        "d" => words.part_d,
        "visible" => words.part_visible,
        "fill" => words.part_fill,
        "stroke" => words.part_stroke,
        "stroke-width" => words.part_stroke_width,
        "x" => words.part_x,
        "y" => words.part_y,
        "box" => words.part_box,
        "drag" => words.dragged,
        own => own,
    }
}
