//! Texts refused before the TOML parser sees them.

use std::sync::Arc;

use super::error::FileError;
use super::source::{BYTE_ORDER_MARK, Origin, Source};

/// The most parts a dotted key may have.
///
/// The parser allows 80 parts in each of 80 braces inside one another, so 6400 tables; dropping them
/// overflows a stack of 1 MB (measured), which is what the main thread has on some systems.
pub const MAXIMUM_KEY_PARTS: usize = 16;

/// The most words, numbers, strings and signs a text may have.
///
/// The parser takes up to 80 bytes of memory for each (measured on `1,1,1,...`), so this bounds it to
/// some 400 MB, while long strings cost little more than themselves.
pub const MAXIMUM_TOKENS: usize = 5_000_000;

/// What the parser would not survive, and where.
#[derive(Debug, PartialEq, Eq)]
enum Excess {
    Parts(usize),
    Tokens(usize),
}

/// Refuses keys of too many parts and texts of too many tokens; `source` holds `text` at byte
/// `offset`.
pub(super) fn check_text(source: &Arc<Source>, text: &str, offset: usize) -> Result<(), FileError> {
    let Some(excess) = excess(text) else { return Ok(()) };
    let (at, fault) = match excess {
        Excess::Parts(at) => {
            let message = format!("has a key of more than {MAXIMUM_KEY_PARTS} parts between dots");
            (at, FileError::new(message))
        }
        Excess::Tokens(at) => {
            let message = format!("has more than {MAXIMUM_TOKENS} words, numbers and signs");
            let help = "keep long tables of numbers in a CSV file";
            (at, FileError::new(message).with_help(help))
        }
    };
    Err(fault.at(&Origin::new(source, offset + at..offset + at + 1)))
}

/// Takes strings, comments and bare words apart exactly as the lexer of the TOML parser does, faults
/// included, because the parser builds its tables before it reports a fault.
fn excess(text: &str) -> Option<Excess> {
    let bytes = text.as_bytes();
    let mut dots = 0;
    let mut tokens = 0;
    let mut at = if text.starts_with(BYTE_ORDER_MARK) { BYTE_ORDER_MARK.len_utf8() } else { 0 };
    while let Some(&byte) = bytes.get(at) {
        tokens += 1;
        if tokens > MAXIMUM_TOKENS {
            return Some(Excess::Tokens(at));
        }
        match byte {
            b'.' => {
                dots += 1;
                if dots >= MAXIMUM_KEY_PARTS {
                    return Some(Excess::Parts(at));
                }
                at += 1;
            }
            b'"' | b'\'' => at = end_of_string(bytes, at),
            b'#' => at = end_of_line(bytes, at),
            b'\n' | b'\r' | b'=' | b',' | b'[' | b']' | b'{' | b'}' => {
                dots = 0;
                at += 1;
            }
            b' ' | b'\t' => at = end_of_space(bytes, at),
            _ => at = end_of_word(bytes, at),
        }
    }
    None
}

fn end_of_space(bytes: &[u8], start: usize) -> usize {
    let length = bytes[start..].iter().position(|byte| !matches!(byte, b' ' | b'\t'));
    length.map_or(bytes.len(), |length| start + length)
}

fn end_of_line(bytes: &[u8], start: usize) -> usize {
    let length = bytes[start..].iter().position(|byte| matches!(byte, b'\n' | b'\r'));
    length.map_or(bytes.len(), |length| start + length)
}

/// A quote inside a bare word begins no string.
fn end_of_word(bytes: &[u8], start: usize) -> usize {
    let length = bytes[start..].iter().position(|byte| b".=,[]{} \t#\r\n".contains(byte));
    length.map_or(bytes.len(), |length| start + length)
}

/// The first byte behind the string whose quote is at `start`, closed or not.
fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let quote = bytes[start];
    let multiline = bytes[start..].starts_with(&[quote; 3]);
    let escapes = quote == b'"';
    let mut at = start + if multiline { 3 } else { 1 };
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\\' if escapes => {
                let escaped = matches!(bytes.get(at + 1), Some(b'\\' | b'"'));
                at += if escaped { 2 } else { 1 };
            }
            b'\n' if !multiline => return at,
            _ if byte == quote && !multiline => return at + 1,
            _ if byte == quote && bytes[at..].starts_with(&[quote; 3]) => {
                let extra = bytes[at + 3..].iter().take(2).take_while(|byte| **byte == quote);
                return at + 3 + extra.count();
            }
            _ => at += 1,
        }
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::{Excess, MAXIMUM_KEY_PARTS, MAXIMUM_TOKENS, excess};

    fn is_long(text: &str) -> bool {
        matches!(excess(text), Some(Excess::Parts(_)))
    }

    #[test]
    fn counts_tokens_but_not_the_length_of_strings() {
        let pairs = MAXIMUM_TOKENS / 2;
        assert_eq!(excess(&"1,".repeat(pairs)), None);
        assert!(matches!(excess(&"1,".repeat(pairs + 1)), Some(Excess::Tokens(_))));
        assert_eq!(excess(&format!("a = '{}'", "1,".repeat(pairs + 1))), None);
    }

    #[test]
    fn counts_parts_of_keys_alone() {
        let most = vec!["a"; MAXIMUM_KEY_PARTS].join(".");
        let more = format!("{most}.a");
        assert_eq!(excess(&format!("{most} = 1\n{most} = 2")), None);
        assert!(is_long(&format!("{more} = 1")));
        assert!(is_long(&format!("[{more}]")));
        assert!(is_long(&format!("b = {{ {more} = 1 }}")));
        assert!(is_long(&format!("b = \"\"\"x\"\"\"\n{more} = 1")));
        assert!(is_long(&"\"x\" . ".repeat(20)));
        assert!(is_long(&format!("x\"\"\" = 1\n{more} = 1")));
        assert!(is_long(&format!("b = \"\\\n{more} = 1")));
        assert!(is_long(&format!("\u{feff}\"\"\"\n\"\"\".{more} = 1")));
    }

    #[test]
    fn passes_over_dots_in_strings_and_comments() {
        for text in [
            "a = \"................................\"",
            "a = '................................'",
            "a = \"\"\"................................\n..................\"\"\"",
            "a = '''................................'.................'''''",
            "a = \"\\\"................................\"",
            "# ................................",
            "a = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]",
            "a = 1.0\nb = 2.0",
        ] {
            assert_eq!(excess(text), None, "{text}");
        }
    }
}
