//! Statements that take rows from a backup into a store. Both databases understand them.

/// Columns of an event in a backup; the store numbers their arrival again.
const EVENT: &str = "class, seat, seq, at, kind, body";

/// Statement that takes the numbers of erased seats from the tables of one schema to those of another one.
pub fn taking_erased(backup: &str, store: &str) -> String {
    format!("INSERT INTO {store}.erased SELECT * FROM {backup}.erased WHERE true ON CONFLICT DO NOTHING")
}

/// Statements that take everything else but the tokens of teachers, the events last: a backup does not tell which of these tokens were
/// revoked afterwards. Their parameter is the present time.
pub fn taking(backup: &str, store: &str) -> [String; 5] {
    let erased = format!("(SELECT class, seat FROM {store}.erased)");
    // An erased class is seat 0 of it.
    let kept = format!("class IN (SELECT class FROM {backup}.class WHERE expires>$1) AND (class, 0) NOT IN {erased}");
    let take = |into: &str, columns: &str, rest: &str| {
        let table = into.split('(').next().unwrap_or_default();
        format!(
            "INSERT INTO {store}.{into} SELECT {columns} FROM {backup}.{table} WHERE {kept} {rest} ON CONFLICT DO NOTHING"
        )
    };
    let seats = format!("AND (class, seat) NOT IN {erased}");
    [
        take("class", "*", ""),
        take("sheet", "*", ""),
        take("seat", "*", &seats),
        take("token", "*", &format!("AND seat>0 {seats}")),
        take(&format!("event({EVENT})"), EVENT, &format!("{seats} ORDER BY number")),
    ]
}

/// Query for the classes of a schema whose time is over. Its parameter is the present time.
pub fn over(store: &str) -> String {
    format!("SELECT class FROM {store}.class WHERE expires<=$1")
}
