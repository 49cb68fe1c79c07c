//! Texts of the film views in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    // The stage.
    film: "Film";
    scene: "Scene";
    show_scene: "Show the scene";
    close: "Close the film";
    not_opened: "The film could not be opened:";
    no_document: "A film needs a document that runs. Open one from the list of documents first";
    taken_up: "Film recognised: your earlier work is restored";
    same_name: "Another film has the same name; the work on that one is kept apart";
    project_film_not_opened: "The positions of the project are a record; its film was not opened:";
    project_film_opened: "The film of the project is open, with its positions and its scale. Times are now those of the film's frames";
    unpacked_too_large: "it is too large to be unpacked here; unpack the project and open the film itself";
    opening: "Opening";
    frames: "frames";
    frame: "frame";
    film_time: "Frame of the film";
    film_transport: "Frames of the film";
    previous: "Previous frame";
    next: "Next frame";
    next_doubtful: "Next doubtful frame";
    picture_keys: "Arrow keys: previous and next frame, with Shift ten frames. Period: next doubtful frame. Enter: place a point by keys; then arrows move it by a pixel, with Shift by ten, Enter sets it, Escape leaves it.";
    space_time: "Space-time picture, surface";
    space_time_hint: "A strip along the tube from every frame. Drag the curve up or down where it is wrong";
    space_time_keys: "Left and right: frames. Up and down: move the surface in this frame, with Shift ten rows; Enter sets it, Escape leaves it, Delete forgets a correction.";
    from_model: "from the model";
    model_far: "the model is far away: fit it to the record";
    model_far_without_origin: "the model is far away: set the origin, or fit";
    play: "Play the film";
    pause: "Pause the film";

    // The sample film.
    story_film: "A tube, dyed water, a camera. The surface is being found in each frame.";
    story_curve: "While the liquid swings, its curve is drawn out of the surface.";
    story_theory: "The drawn tube swings, too, but not like the filmed one: its curve misses the points.";
    story_fit: "The fit changes damping and start until the curve meets the points, and gives the period with its error.";
    story_skip: "Skip";
    story_close: "Stay with the film";
    your_turn: "Your turn: drag the liquid";

    // Prompts for the next click.
    leave: "Skip";
    ask_surface: "Click the surface of the liquid";
    ask_second_surface: "Click the surface in the other arm";
    ask_body: "Click the body";
    ask_hand: "Click the point; the next frame follows";
    ask_tube: "Click one end of the tube's axis";
    ask_other_end: "Click the other end";
    ask_still: "Click marks that rest, up to four";
    ask_ruler: "Click a mark of the ruler";
    ask_second_mark: "Click another mark of the ruler";
    ask_origin: "Click the point that becomes zero";
    ask_axis: "Click a point to which the x axis leads from the origin";
    ask_corner: "Click the four corners of the rectangle";
    remove: "Remove";
    remove_key: "Remove (Delete)";
    surface: "Surface";
    tube_end: "End of the tube";
    body: "Body";
    point: "Point";
    fixed_mark: "Fixed mark";
    ruler_mark: "Mark of the ruler";
    origin: "Origin";
    axis: "Direction of the x axis";
    corner: "Corner";

    // The four steps.
    record_film: "Record film";
    stop_recording: "Stop recording";
    no_camera: "The browser gives no camera to this page: it was refused, or none is there";
    film_simulation: "Film this simulation";
    film_again: "Film again";
    filming: "Filming the simulation";
    filmed: "The simulation was filmed";
    filming_note: "A virtual camera films the simulation with its present parameters from its start. The film is tracked like any other, and nothing leaves the page. Frames have no compression.";
    filming_seconds: "Duration";
    filming_rate: "Frame rate";
    filming_exposure: "Exposure";
    filming_noise: "Noise";
    filming_seed: "Noise seed";
    filming_ruler: "In the picture, 640 × 360 px, stands a ruler of";
    filming_no_ruler: "The drawing has no scale of lengths: the record stays in pixels. The picture has 640 × 360 px.";
    start_filming: "Film";
    not_drawn: "The browser did not draw the scene. Try again, or another browser.";
    compare_truth: "Compare with the true values";
    truth: "Deviation from the true values";
    rms: "RMS";
    truth_scale: "Error of the scale";
    truth_legend: "Found minus true over time";
    truth_legend_body: "Found minus true over time, to the right (solid) and down (dashed)";
    ruler_is: "The ruler in the picture is";
    camera_picture: "Picture of the camera";
    acts: "From film to record";
    act_film: "Film";
    act_follow: "Click what moves";
    act_lengths: "Click the ruler and the origin";
    act_record: "Record";
    times: "Times and part";
    factor: "Slow motion, factor";
    factor_note: "How many times slower the film plays than things happened: 8, or 240/30 as a quotient of rates. Compare a known time.";
    from: "From";
    until: "Until";
    from_here: "From this frame";
    until_here: "Until this frame";
    kinds: "What to track";
    kind_surface: "Surface in a tube";
    kind_arms: "Both arms";
    kind_body: "Body";
    kind_hand: "By hand";
    hint_surface: "One click on the surface in any frame; the curve follows.";
    hint_arms: "One click on the surface in each arm.";
    hint_body: "One click on the body in the first frame of its motion; where it is lost, click it again.";
    hint_hand: "A click in each frame, for what nothing else can follow.";
    click_it: "Click in the film";
    another_body: "Another body";
    radius: "Radius";
    radius_found: "found from the click";
    find_radius: "Find from the click";
    radius_note: "The circle around the click shows it. If the circle does not fit the body, enter its radius: the film is tracked again.";
    difficult: "Tilted tube, shaking camera";
    tube: "Axis of the tube";
    fixed_marks: "Fixed marks";
    difficult_note: "A tube that is not upright: two points of its axis. A camera that shakes: two to four marks that rest, in the first frame of the part.";
    forget_marks: "Forget the fixed marks";
    hint_ruler: "Two marks and the length between them; without a ruler the record stays in pixels. The origin is the point at which the quantity of the model is zero.";
    click_ruler: "Two marks";
    set_origin: "Origin";
    lacks_origin: "The origin is missing: choose Origin and click the height that is zero in the model, such as the level of rest. Until then heights count from the bottom of the picture.";
    set_axis: "x axis";
    length: "Length";
    intervals: "Intervals on it";
    in_pixels: "Stay in pixels";
    more_lengths: "Perspective, ruler behind the tube";
    rectangle: "Corners of a rectangle";
    width: "Width";
    height: "Height";
    parallax_note: "A ruler that is not where the motion is:";
    behind: "Behind it by";
    distance: "Camera at";
    following: "Following";
    computing: "computing the positions";
    cancel: "Cancel";
    no_record: "The record appears here once something has been clicked.";
    doubtful: "Doubtful frames";
    doubts_note: "The period key leads from one to the next. Drag the curve under the film where it is wrong.";
    doubts_note_bodies: "The period key leads from one to the next. Click the body again where it is lost or wrong.";
    show_record: "Show the record";
    insecure: "This browser decodes films only in a page that comes over https or from a disk: open this page so.";
}

/// Texts in the current language, without tracking the signal.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}
