//! Texts around a simulation in every language. Texts of the document are translated by the document, texts of playing
//! by `play`.

/// Declares a table of English texts by name. With `@beside`, the texts of another table can be read like own ones.
#[macro_export]
macro_rules! table_of_words {
    ($(@beside $other:ident;)? $($name:ident: $english:literal;)*) => {
        /// Texts of the interface in one language. Each is named after its English text.
        #[derive(Debug)]
        #[allow(missing_docs, reason = "each says itself")]
        pub struct Words { $(other: &'static $other::Words,)? $(pub $name: &'static str,)* }

        /// Texts in one language; its catalogue must be installed before.
        pub fn words_in(language: units::Language) -> &'static Words {
            static TABLES: [std::sync::OnceLock<Words>; units::Language::ALL.len()] =
                [const { std::sync::OnceLock::new() }; units::Language::ALL.len()];
            TABLES[language as usize].get_or_init(|| {
                let [$($name),*] = language.say_all([$($english),*]);
                Words { $(other: $other::words_in(language),)? $($name),* }
            })
        }

        $(impl std::ops::Deref for Words {
            type Target = $other::Words;

            fn deref(&self) -> &$other::Words {
                self.other
            }
        })?
    };
}

table_of_words! {
    // Page.
    skip: "Skip to the apparatus";
    skip_to_panel: "Skip to the panel";
    skip_links: "Skip links";
    language: "Language";
    translated: "# % of the interface is translated.";
    document_untranslated: "This simulation is not translated.";
    theme_system: "Colours: as the system";
    theme_light: "Colours: light";
    theme_dark: "Colours: dark";
    projector: "Projector's view";
    menu: "Open a file, colours, language";
    library: "Simulations";
    first_steps: "First steps";
    guide: "60-second start";
    film_own: "Film your own";
    see_measured: "See it measured";
    see_measured_note: "A film of this tube: watch the curve come out of it. Half a minute.";
    open: "Open";
    publish: "Share";
    document: "Document";
    document_title: "Save the document of this simulation; the laboratory of Meniscus opens it";
    all_simulations: "All simulations";
    open_in_laboratory: "Open in the laboratory";
    laboratory_title: "Open this simulation as it is now in the laboratory, to measure and to fit";
    question_awaits: "Answer this first";
    answers_not_saved: "The browser does not let this page store anything: your answers will be lost when it is closed";
    damaged: "This file is damaged. Download it again.";
    locked: "The values are fixed in this page.";
    share: "Copy link";
    share_title: "Copy a link that reopens this state";
    link_copied: "Link copied";
    link_not_copied: "The link could not be copied; it is in the address bar";
    link_without: "Not in the link";
    close: "Close";
    messages: "Messages";
    undo: "Undo";
    show: "Show";
    dismiss: "Dismiss";
    footer: "Made with Meniscus. This page works offline and sends nothing to anyone.";
    footer_of_class: "Made with Meniscus. This page is connected to the server of the class.";

    // Apparatus.
    apparatus: "Apparatus";
    scene: "Scene";
    no_scene: "This document draws no scene.";
    outline: "Dotted: measured";
    drag_hint: "Drag in the scene, or use the arrow keys.";
    drag_hint_touch: "Drag in the scene with a finger.";
    drag_here: "Drag it, then let go";
    drag_keys: "Or use the arrow keys.";
    drag_role: "handle";

    instruments: "Instruments";
    stopwatch: "Stopwatch";
    stopwatch_start: "Start the stopwatch";
    stopwatch_started: "Stopwatch started";
    stopwatch_stop: "Stop the stopwatch";
    stopwatch_reset: "Reset the stopwatch";
    ruler: "Ruler";
    ruler_end: "End of the ruler";

    // Transport.
    transport: "Transport";
    play: "Play";
    pause: "Pause";
    step_back: "Step back";
    step_forward: "Step forward";
    back_to_start: "Back to start";
    speed: "Speed";
    time: "Time";
    time_line: "Time line";
    sound: "Sound";
    sound_title: "Hear the displacement as a pitch";
    slow: "The computation cannot keep up with the clock at this speed.";
    full: "The recording is full. Go back to the start, or scrub back and continue from there.";

    go_on: "Go on";

    // Keys.
    keys_title: "Keyboard shortcuts";
    keys_switch: "Single-key shortcuts";
    keys_where: "They act while the focus is in the apparatus or nowhere, never while you type.";
    keys_anywhere: "Apparatus";
    keys_plot: "In a plot";
    keys_scene: "On a handle of the scene";
    key_space: "Space";
    key_play: "Play or pause";
    key_step: "Step back, step forward";
    key_speed: "Slower, faster";
    key_keep: "Keep this run";
    key_projector: "Leave the projector's view";
    key_undo: "Undo the last removal or reset of parameters";
    key_help: "This list";
    key_cursor: "Move the read-out (with Shift: ten rows)";
    key_zoom: "Zoom in, zoom out";
    key_pan: "Pan (with Ctrl)";
    key_pin: "Pin the reading, unpin all";
    key_fit: "Show all of the data";
    key_handle: "Move it (with Shift: five times as far)";

    // Controls.
    controls: "Controls";
    index: "index";
    seat: "Seat";
    seat_unknown: "Type the number of your seat to work with values of your own. Until then the values of the document are set.";
    seat_known: "The values of this seat are set.";
    size_title: "Another size builds the model again";
    size_fixed: "Fixed in this page; the laboratory can change it.";
    parameters: "Parameters";
    buttons: "Actions";
    clear_drawing: "Clear";
    drawing_hint: "Draw the curve in the field; the run starts again. Keys: left and right choose a point, up and down move it.";
    further_parameters: "Further parameters";
    more: "More";
    choose: "Choose ...";
    presets: "Presets";
    restore_defaults: "Restore defaults";
    restore_defaults_title: "Give all parameters and the start of the run the values of the document";
    restarts: "A change starts the run again";
    state: "State";
    state_hint: "Pause to edit; the run then begins from there.";
    started_by_hand: "The run starts from a state that was set by hand. Restore defaults brings the document's start back.";
    method: "Method";
    step: "Step";
    settings: "State and method";
    numerics: "Numerical method";

    // Hand-in.
    hand_in: "Hand in";
    hand_in_name: "Name, group or pseudonym";
    hand_in_save: "Save hand-in";
    hand_in_unnamed: "Type a name first.";
    hand_in_computing: "The results are being computed again ...";
    hand_in_saved: "Saved {file} with # values.";
    hand_in_meaning: "The results are computed again from the data when the file is verified. A result that does not follow from the data is listed.";

    // Readouts.
    readouts: "Values";
    further_readouts: "Further values";
    constants: "Derived quantities";
    changing: "Changing with time";
    show_hidden: "Show the values that questions ask for";

    // Plots.
    plots: "Plots";
    plot: "plot";
    plots_shown: "Plots shown";
    no_plots: "All plots are hidden.";
    plot_keys: "Arrow keys read values, Enter pins a reading, plus and minus zoom, 0 shows everything.";
    zoom_in: "Zoom in";
    zoom_out: "Zoom out";
    fit: "Show all";
    save_svg: "Download SVG";
    save_png: "Download PNG";

    save_plot_csv: "Download CSV of this plot";
    plot_menu: "Zoom, download and full screen";
    full_screen: "Full screen";
    legend: "Legend";
    pinned: "Pinned";
    unpin: "Unpin the readings";
    unpinned: "Reading removed";
    difference: "Difference";
    difference_sign: "B − A";

    // Runs.
    runs: "Kept runs";
    keep: "Keep run";
    keep_title: "Keep this run and draw the next one over it";
    remove_run: "Remove";
    ghost: "Previous run";

    // Panel.
    panel: "Panel";
    tab_explore: "Explore";
    tab_questions: "Questions";
    tab_measure: "Measure";
    tab_theory: "Theory";
    tab_write: "Write";
    tab_class: "Class";
    everything: "For teachers";
    tab_waits: "The laboratory is loading ...";
    contents: "Contents";
    equations: "Model";
    equations_intro: "The equations as the document states them; the program solves exactly these.";
    checks: "Checks of this simulation";
    checks_intro: "What the author claims about runs with the values of the document. Your own run is not changed.";
    run_checks: "Run the checks";
    checks_running: "Running";
    checks_hold: "All claims hold";
    checks_fail: "Claims that do not hold:";
    checks_with: "With";
    check_plot_show: "Show in the present run";
    check_plot_hide: "Hide the plot";
    check_plot_waits: "Play the simulation first.";
    check_open: "not checked";
    check_holds: "holds";
    check_fails: "does not hold";
    copy: "Copy";
    copied: "Copied";
    not_copied: "The browser did not allow copying";
    table: "Recorded values";
    rows: "rows";
    follow: "Follow the present";
    row_first: "First rows";
    row_previous: "Earlier rows";
    row_next: "Later rows";
    row_last: "Last rows";
    save_csv: "Download CSV";
    copy_csv: "Copy CSV";

    // Worksheet.
    sheet_name: "Name";
    sheet_date: "Date";
    sheet_answer: "Answer";
    sheet_made: "Made with Meniscus.";

    // Questions.
    question: "Question";
    answer: "Your answer";
    check: "Check";
    choose_one: "Choose one answer.";
    choose_several: "Choose all that are right.";
    hint: "Hint";
    reveal: "Show the answer";
    right_answer: "Answer";
    attempts_allowed: "Attempts allowed: {allowed}.";
    attempts_left: "Attempts left: {left} of {allowed}.";
    attempts_used: "All {allowed} attempts are used. The answer can be shown.";
    attempts_beyond: "Only the first {allowed} of your {made} attempts count.";
    supposes: "This question is about";
    set_up: "Set these values";
    is_set_up: "set";

    // Survey.
    survey: "Survey";
    survey_note: "Your answers stay in this page until you save them as a file, which has neither your name nor the time. They are part of no hand-in and no link.";
    survey_none: "No answer";
    survey_save: "Save answers";
    survey_saved: "The answers are saved as a file. Send it as the course asks.";
    survey_empty: "Nothing is answered yet.";
}
