//! JSON with measured data, as text with tabs: an array of records, records line by line (NDJSON), arrays of numbers by
//! name, as phyphox and pandas write them.

mod collect;
mod scan;

use crate::import::refusal::Refusal;
use collect::Collector;
pub(super) use collect::JsonTable;
use scan::Scanner;

/// Reads a text that is JSON throughout; `None` for any other.
///
/// # Errors
/// It has no records and not several arrays of numbers of one length.
pub(super) fn read(text: &str) -> Option<Result<JsonTable, Refusal>> {
    let text = text.trim_start_matches('\u{feff}').trim();
    if !text.starts_with(['{', '[']) {
        return None;
    }
    let mut scanner = Scanner::new(text);
    let mut collector = Collector::default();
    collector.document(&mut scanner)?;
    Some(collector.table().ok_or(Refusal::Json))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_becomes_rows() {
        for (text, expected) in [
            ("[{\"t\":0,\"x\":1.5},{\"t\":1,\"x\":null}]", "t\tx\n0.0\t1.5\n1.0\t\n"),
            ("{\"t\":0,\"a\":{\"x\":1}}\n{\"t\":1,\"a\":{\"x\":2}}\n", "t\ta.x\n0.0\t1.0\n1.0\t2.0\n"),
            ("{\"t\":[0,1],\"x\":[2,3],\"n\":[1]}", "t\tx\n0.0\t2.0\n1.0\t3.0\n"),
            ("[[\"t\",\"x\"],[0,1],[2,3]]", "t\tx\n0.0\t1.0\n2.0\t3.0\n"),
            ("{\"columns\":[\"t\",\"x\"],\"index\":[0,1],\"data\":[[0,1],[2,3]]}", "t\tx\n0.0\t1.0\n2.0\t3.0\n"),
            ("{\"meta\":{\"n\":1},\"data\":[{\"t\":\"a\\tb\",\"x\":1},{\"x\":2}]}", "t\tx\na b\t1.0\n\t2.0\n"),
            (
                "{\"buffer\":{\"acc_time\":{\"size\":0,\"buffer\":[0,0.5]},\"accX\":{\"size\":0,\"buffer\":[1,2]}}}",
                "acc_time\taccX\n0.0\t1.0\n0.5\t2.0\n",
            ),
        ] {
            match read(text) {
                Some(Ok(table)) => assert_eq!(table.cells, expected, "{text}"),
                other => panic!("{text}: {other:?}"),
            }
        }
        assert!(matches!(read("{\"a\":1}"), Some(Err(Refusal::Json))));
        for text in ["[s]\n1 2", "{\"t\":[0,1}", "t,x", "[1,2] 3"] {
            assert!(read(text).is_none(), "{text}");
        }
    }
}
