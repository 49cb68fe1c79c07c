//! Framing of the messages of the protocol: header lines, an empty line, JSON. A malformed message is answered with an
//! error and skipped, so that it does not end the server.

use lsp_server::{ErrorCode, Message};
use serde_json::{Value, json};
use std::io::{self, BufRead, Read, Write};

/// Maximum length of a message in bytes. Longer ones are skipped.
const LONGEST: usize = 64 << 20;
/// Name of the header that states the length of the message in bytes.
const LENGTH: &str = "content-length:";

/// A message that cannot be parsed.
#[derive(Debug)]
pub struct Malformed {
    /// Id of the request; null if there is none.
    id: Value,
    code: ErrorCode,
    why: String,
}

impl Malformed {
    fn new(code: ErrorCode, why: impl ToString) -> Self {
        Self { id: Value::Null, code, why: why.to_string() }
    }
}

/// Reads the next message; `None` at the end of the stream.
///
/// # Errors
/// The stream cannot be read.
pub fn read(input: &mut impl BufRead) -> io::Result<Option<Result<Message, Malformed>>> {
    let Some(length) = header(input)? else { return Ok(None) };
    let length = match length {
        Some(length) if length <= LONGEST => length,
        Some(length) => {
            io::copy(&mut input.take(length as u64), &mut io::sink())?;
            let why = format!("a message of {length} bytes; at most {LONGEST} are read");
            return Ok(Some(Err(Malformed::new(ErrorCode::InvalidRequest, why))));
        }
        None => return Ok(Some(Err(Malformed::new(ErrorCode::ParseError, "the header has no Content-Length")))),
    };
    let mut bytes = Vec::new();
    if input.take(length as u64).read_to_end(&mut bytes)? < length {
        return Ok(None);
    }
    Ok(Some(parsed(&bytes)))
}

/// Reads header lines up to an empty one. Returns the stated length; `None` at the end of the stream.
fn header(input: &mut impl BufRead) -> io::Result<Option<Option<usize>>> {
    let mut length = None;
    loop {
        let mut line = Vec::new();
        if input.take(LONGEST as u64).read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line).to_ascii_lowercase();
        if line.trim().is_empty() {
            return Ok(Some(length));
        }
        // After a message with a wrong length, the header may not be at the start of a line.
        if let Some((_, value)) = line.rsplit_once(LENGTH) {
            length = value.trim().parse().ok();
        }
    }
}

fn parsed(bytes: &[u8]) -> Result<Message, Malformed> {
    let value: Value = serde_json::from_slice(bytes).map_err(|error| Malformed::new(ErrorCode::ParseError, error))?;
    let id = value.get("id").filter(|id| id.is_string() || id.is_number()).cloned().unwrap_or_default();
    serde_json::from_value(value)
        .map_err(|_| Malformed { id, ..Malformed::new(ErrorCode::InvalidRequest, "this is no message of JSON-RPC") })
}

/// Writes the error response to a malformed message.
///
/// # Errors
/// The stream cannot be written to.
pub fn refuse(output: &mut impl Write, malformed: &Malformed) -> io::Result<()> {
    let Malformed { id, code, why } = malformed;
    let text = json!({ "jsonrpc": "2.0", "id": id, "error": { "code": *code as i32, "message": why } }).to_string();
    write!(output, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    output.flush()
}
