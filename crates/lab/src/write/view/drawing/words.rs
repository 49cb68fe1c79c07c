//! Texts of the drawing editor in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    nothing: "This document has no drawing yet.", "Este documento aún no tiene dibujo.";
    begin: "Begin a drawing", "Empezar un dibujo";
    add: "Add part", "Añadir pieza";
    palette: "Parts and shapes", "Piezas y formas";
    canvas: "Drawing: choose an element and move it", "Dibujo: elige un elemento y muévelo";
    keys: "Arrow keys move what is chosen by a step of the grid, with Shift by ten. Page up and page down choose the next element. Delete removes, Control with D copies, Control with Z takes back.", "Las flechas mueven lo elegido un paso de la cuadrícula, con Mayús diez. Retroceder y avanzar página eligen el elemento siguiente. Suprimir quita, Control con D copia, Control con Z deshace.";
    paused: "The text has errors: the drawing can be changed by hand again when they are gone.", "El texto tiene errores: el dibujo se podrá cambiar a mano cuando desaparezcan.";
    layers: "Layers", "Capas";
    layers_none: "Nothing is drawn yet. Add a part.", "Aún no hay nada dibujado. Añade una pieza.";
    forward: "Forward", "Adelante";
    backward: "Backward", "Atrás";
    copy: "Copy", "Copiar";
    remove: "Remove", "Quitar";
    snap: "Grid", "Cuadrícula";
    align: "Align", "Alinear";
    align_left: "Left edges", "Bordes izquierdos";
    align_centre: "Centres", "Centros";
    align_right: "Right edges", "Bordes derechos";
    align_top: "Upper edges", "Bordes superiores";
    align_middle: "Middles", "Medios";
    align_bottom: "Lower edges", "Bordes inferiores";
    chosen_none: "Choose an element in the drawing or in the list to see what it is made of.", "Elige un elemento en el dibujo o en la lista para ver de qué está hecho.";
    chosen_several: "elements are chosen", "elementos elegidos";
    called: "Name", "Nombre";
    shows: "Text", "Texto";
    follows_across: "to the right with", "a la derecha con";
    follows_up: "upwards with", "hacia arriba con";
    follows_down: "downwards with", "hacia abajo con";
    follows_nothing: "nothing", "nada";
    follows_own: "an expression", "una expresión";
    dragged: "Can be dragged", "Se puede arrastrar";
    in_text: "Show in the text", "Ver en el texto";
    part_at: "Place", "Lugar";
    part_from: "From", "Desde";
    part_to: "To", "Hasta";
    part_size: "Size", "Tamaño";
    part_r: "Radius", "Radio";
    part_turn: "Turned by", "Girado";
    part_width: "Width", "Ancho";
    part_length: "Length", "Largo";
    part_height: "Height", "Alto";
    part_turns: "Turns", "Vueltas";
    part_depth: "Depth", "Profundidad";
    part_vector: "Vector", "Vector";
    part_step: "Step", "Paso";
    part_first: "First number", "Primer número";
    part_level: "Level", "Nivel";
    part_spacing: "Spacing", "Separación";
    part_left: "Left level", "Nivel izquierdo";
    part_right: "Right level", "Nivel derecho";
    part_last: "Seen for", "Visible durante";
    part_every: "A dot every", "Un punto cada";
    part_closed: "Closed when", "Cerrado si";
    part_points: "Points", "Puntos";
    part_d: "Path", "Trazo";
    part_visible: "Shown when", "Visible si";
    part_fill: "Fill", "Relleno";
    part_stroke: "Line", "Línea";
    part_stroke_width: "Line width", "Grosor de línea";
    part_x: "Range to the right", "Intervalo a la derecha";
    part_y: "Range upwards", "Intervalo hacia arriba";
    part_box: "Box in the drawing", "Recuadro en el dibujo";
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
