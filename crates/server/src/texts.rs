//! Texts of the pages, in every language, for their scripts.

use serde_json::{Value, json};
use units::Language;

/// Texts of all languages by their tags.
pub fn all() -> Value {
    let mut all = serde_json::Map::new();
    for language in Language::ALL {
        let own: serde_json::Map<String, Value> = [student, handing_in, teacher]
            .into_iter()
            .filter_map(|texts| match texts(language) {
                Value::Object(texts) => Some(texts),
                _ => None,
            })
            .flatten()
            .collect();
        all.insert(language.tag().to_owned(), own.into());
    }
    Value::Object(all)
}

fn student(language: Language) -> Value {
    json!({
        "region": language.say("Class"),
        "code": language.say("Code of the class"),
        "join": language.say("Join"),
        "joining": language.say(
            "Joining sends your answers, runs, records and fits to your teacher's computer, under a pseudonym. No name, no address."),
        "stored": language.say("What is stored"),
        "code_wrong": language.say("No class has this code. Look at the board again."),
        "code_wait": language.say("Too many wrong codes were sent from here. Wait a minute and try again."),
        "unreachable": language.say("The class cannot be reached. Check the network; your work stays here."),
        "full": language.say("The class gives no more seats. Ask your teacher."),
        "many": language.say("Too many have joined from this network. Ask your teacher, or try again in an hour."),
        "token": language.say("This seat does not exist any more. Join again."),
        "earlier": language.say("This seat belongs to an earlier class. Type the code of the present one to join it."),
        "paused": language.say("Your teacher has paused the class."),
        "pace": language.say("The class works on"),
        "closes": language.say("Closes in # min"),
        "file": language.say("Get the file for this class"),
        "file_why": language.say(
            "It opens from disk, so that the camera works, also without a network, and hands in when it reaches the class."),
        "more": language.say("My seat"),
        "key": language.say("Key for another device"),
        "download": language.say("Save what is stored of me"),
        "erase": language.say("Erase what is stored of me"),
        "erase_sure": language.say("Everything that you handed in to this class will be erased. Go on?"),
        "erased": language.say("Erased."),
        "leave": language.say("Leave this computer"),
        "leave_sure": language.say(
            "What is left is handed in. Then your seat, your key and all of your work are removed from this browser; the class keeps what is handed in. Note the key first if you want to go on elsewhere, and delete the file for this class if you have saved it here. Go on?"),
        "leaving": language.say("Handing in ..."),
        "leave_lost": language.say("Not handed in yet: #. This is lost if you leave now. Leave nevertheless?"),
        "sheet": language.say("Your answers to the survey are sent without your seat, at a random time within ten minutes."),
        "others": language.say("Answers of the class"),
        "question": language.say("Question"),
        "right": language.say("right: # of $"),
    })
}

/// What is said of the parts that wait, with a sentence for each reason of a refusal.
fn handing_in(language: Language) -> Value {
    json!({
        "waits_one": language.say("1 part is not handed in yet."),
        "waits": language.say("# parts are not handed in yet."),
        "all_in": language.say("Everything is handed in."),
        "nothing": language.say("Nothing is handed in yet."),
        "closed": language.say("The class is closed; your work stays here and in the file."),
        "approval": language.say("Wait until your teacher lets you in."),
        "refused": language.say("The class refused a part. Press Hand in and send the file to your teacher."),
        "slow": language.say("Sending took too long. Check the network; your work stays here, and less is sent at once."),
        "large": language.say(
            "A part of your work is too large for the class (8 MB). Press Hand in and send the file to your teacher."),
        "seat_full": language.say("Your seat has no more room. Press Hand in and send the file to your teacher."),
        "class_full": language.say("The class has no more room. Tell your teacher; your work stays here and is sent again."),
        "store": language.say("The teacher's computer cannot store anything at the moment; it is tried again."),
        "keep_open": language.say("This browser stores nothing: keep the page open until everything is handed in."),
    })
}

fn teacher(language: Language) -> Value {
    json!({
        "link": language.say("Open the teacher's link from the terminal. It works once; a new start of the server prints another one."),
        "address": language.say("Join at"),
        "with": language.say("with the code"),
        "qr": language.say("Show the code large"),
        "hide": language.say("Hide"),
        "open": language.say("Class open"),
        "pause": language.say("Class paused"),
        "joining_open": language.say("New seats"),
        "new_code": language.say("New code"),
        "new_code_sure": language.say("Give the class a new code? The present one opens nothing any more; seats stay."),
        "revoke": language.say("Revoke other teachers' devices"),
        "revoke_sure": language.say("Revoke all other devices of teachers and the links that nobody has used? This device goes on; the next start of the server prints a new link."),
        "erase_unused": language.say("Erase seats without work"),
        "erase_unused_sure": language.say("Erase all seats that have handed in nothing?"),
        "approve_late": language.say("Approve late joiners"),
        "results": language.say("Show results"),
        "others_after": language.say("Others' answers after one's own"),
        "pace_at": language.say("Pace"),
        "free": language.say("everyone chooses"),
        "close_in": language.say("Close in (min)"),
        "settings": language.say("Settings of the class"),
        "dashboard": language.say("Open the class"),
        "first": language.say(
            "Students scan the code with the camera of their phone, or open the address and type the code. Their answers and results appear here by themselves."),
        "seats": language.say("Seats"),
        "seats_joined": language.say("# joined, $ have handed in"),
        "let_in": language.say("Let in"),
        "erase_seat": language.say("Erase"),
        "erase_seat_sure": language.say("Erase everything that # has handed in?"),
        "waiting": language.say("waits"),
        "live": language.say("Live"),
        "lost": language.say("No connection to the server; it is tried again."),
        "room_near": language.say("The class has used # % of its room."),
        "room_full": language.say(
            "The class has no more room (# MB): what students hand in waits in their browsers. Erase seats, or start the server again with a larger --room."),
        "sheets": language.say("Show the survey"),
    })
}

/// Title and lines of *What is stored*.
pub fn stored(language: Language) -> [&'static str; 8] {
    language.say_all(
        [
            "What is stored",
            "Stored: a pseudonym, the number of the seat, the document, the answers with all attempts, settings of runs, records and measured points of films with the names of their files, fits, and the time of arrival of each part. What you type is stored as it is: leave names out.",
            "Not stored, nor written to any log: name, mail, network address, kind of browser, films.",
            "Answers to surveys are stored apart, without seat and without time. The server cannot tell which are yours, so they are erased with the class only.",
            "It is stored on the computer on which the class was started, or in a database that this computer uses. After the number of days that the teacher chose (30 if nothing was said) everything is erased there as soon as the server runs, and a backup that is restored later does not bring it back. Backups and copies that the teacher has made last until they are deleted.",
            "My seat saves what is stored of you as a file, and erases it from the server at any time. Backups, copies, and a dashboard that is open meanwhile keep it.",
            "The browser keeps your work, the parts that are not handed in yet, and the key of your seat; the work stays there after erasing. On a computer that others use, press Leave this computer in My seat at the end: it removes all of this. There are no cookies.",
            "Names stay on the teacher's device, if the teacher types them beside the pseudonyms.",
        ],
    )
}
