//! Texts of the dashboard of a class in every language.

use crate::app::App;
use view::table_of_words;

table_of_words! {
    title: "Class";
    close: "Close";
    intro: "See what all groups have measured, fitted and answered. Drop their hand-ins or a folder of them here, or choose them. Everything is computed again from the raw values, on this device alone.";
    open: "Open the class";
    choose_files: "Choose hand-ins";
    choose_folder: "Choose a folder";
    save_report: "Save report";
    save_workbook: "Save as XLSX";
    clear: "Remove all";
    no_hand_in: "No hand-in is among these files. Their names end in .hand-in";

    curves: "Measured curves";
    curves_quantity: "Quantity";
    collect: "Collect curves for the wall";
    results: "Fitted quantities";
    against: "Results against a parameter";
    against_note: "If the groups held a parameter fixed at values of their own, their results can be set against it, with a straight line. Powers and reciprocals can be typed.";
    against_x: "Parameter";
    against_y: "Quantity (empty: all)";
    against_none: "No such result has # held fixed in its fit.";
    answers: "Answers";
    collect_answers: "Collect answers for the wall";
    stuck: "Stuck";
    stuck_rules: "A group is stuck if it gives three answers wrong in the same way, if it has kept the same run five times, if a fit does not determine its parameters, or if a result is far from the others.";
    nothing: "None.";

    snapshots: "For the projector";
    snapshots_none: "Nothing is collected yet. Choose curves, or answers below their question; a projector then shows them without names.";
    wall_show: "Show on the wall";
    wall_title: "Wall";
    wall_previous: "Previous";
    wall_next: "Next";
    wall_answer: "Answer";
    move_up: "Show earlier";
    remove: "Remove";

    hand_ins: "Hand-ins";
    number: "No.";
    pseudonym: "Handed in as";
    name: "Name (on this device only)";
    name_of: "Name of";
    seat: "Seat";
    file: "File";
    verification: "Verification";
    work: "Work";
    table: "Table of the hand-ins";
    open_work: "Open the work";
    show_all: "Show all #";
}

/// Texts in the chosen language.
pub fn of(app: App) -> &'static Words {
    words_in(app.language.get_untracked())
}
