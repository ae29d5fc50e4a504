//! Bytes of a text file as text, in whatever encoding can be told.

use std::borrow::Cow;

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

/// Bytes that are looked at for the zeros of UTF-16.
const SAMPLE: usize = 4096;

/// The text of a file and the name of its encoding.
///
/// The encoding is the one that `label` names, such as `windows-1252`, `utf-16` or `shift_jis` ([WHATWG's names](https://encoding.spec.whatwg.org/#names-and-labels)).
/// Without a label it is told by a byte order mark, by the zeros of UTF-16, or by being UTF-8; the rest is read as Windows-1252, whose numbers are those of every encoding that
/// contains ASCII: only letters beyond ASCII, as in a header, may then be others.
///
/// Lines that end with carriage returns alone, as those of some instruments do, end with line feeds in the text.
///
/// # Errors
/// What is wrong, as a text that reads on after the name of the file: a label that names no encoding, bytes that the named encoding does not have, UTF-32.
pub fn decode<'b>(
    bytes: &'b [u8],
    label: Option<&str>,
) -> Result<(Cow<'b, str>, &'static str), String> {
    let encoding = match label {
        Some(label) => Encoding::for_label(label.as_bytes()).ok_or_else(|| {
            format!(
                "has no encoding `{}`: write one such as \"utf-8\", \"utf-16\", \"windows-1252\" or \"shift_jis\"",
                crate::shortened(label, 40)
            )
        })?,
        None if is_utf_32(bytes) => {
            return Err("is UTF-32, which is not read: save it as UTF-8".to_owned());
        }
        None => told(bytes),
    };
    let (text, used, is_faulty) = encoding.decode(bytes);
    if is_faulty {
        return Err(format!("is not text in the encoding {}", used.name()));
    }
    let has_returns_alone = text.contains('\r') && !text.contains('\n');
    let text = if has_returns_alone { text.replace('\r', "\n").into() } else { text };
    Ok((text, used.name()))
}

/// Whether of each four bytes two beside each other are zero, as those of ASCII in UTF-32 are, and of no other text: that of UTF-16 has zeros at every second place.
fn is_utf_32(bytes: &[u8]) -> bool {
    let sample = &bytes[..bytes.len().min(SAMPLE)];
    let are_zero = |places: [usize; 2]| {
        sample.chunks_exact(4).all(|four| places.iter().all(|&at| four[at] == 0))
    };
    sample.len() >= 4 && (are_zero([2, 3]) || are_zero([0, 1]))
}

/// The encoding by what the bytes show.
fn told(bytes: &[u8]) -> &'static Encoding {
    if let Some((encoding, _)) = Encoding::for_bom(bytes) {
        return encoding;
    }
    // Half of the bytes of ASCII in UTF-16 are zero, and none of any other text.
    let sample = &bytes[..bytes.len().min(SAMPLE)];
    let zeros = |parity: usize| {
        sample.iter().enumerate().filter(|(at, byte)| at % 2 == parity && **byte == 0).count()
    };
    let (even, odd) = (zeros(0), zeros(1));
    let most = sample.len() / 4;
    if bytes.len() >= 4 && odd > most && even == 0 {
        return UTF_16LE;
    }
    if bytes.len() >= 4 && even > most && odd == 0 {
        return UTF_16BE;
    }
    if std::str::from_utf8(bytes).is_ok() { UTF_8 } else { WINDOWS_1252 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encodings_are_told_by_what_they_show() {
        let text = "x [mm];Höhe [µm]\n1;2,5\n";
        let little: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        let (latin, ..) = WINDOWS_1252.encode(text);
        let marked = [&[0xff, 0xfe], little.as_slice()].concat();
        for (bytes, name) in [
            (text.as_bytes(), "UTF-8"),
            (&[b"\xef\xbb\xbf", text.as_bytes()].concat(), "UTF-8"),
            (&little, "UTF-16LE"),
            (&big, "UTF-16BE"),
            (&marked, "UTF-16LE"),
            (&latin, "windows-1252"),
        ] {
            let (read, told) = decode(bytes, None).unwrap();
            assert_eq!((read.as_ref(), told), (text, name));
        }
    }

    #[test]
    fn returns_alone_end_lines_and_utf_32_is_told() {
        let (text, _) = decode(b"x,f\r1,2\r3,4\r", None).unwrap();
        assert_eq!(text.lines().collect::<Vec<_>>(), ["x,f", "1,2", "3,4"]);
        // A return before a line feed belongs to it.
        assert_eq!(decode(b"x\r\n1\r\n", None).unwrap().0, "x\r\n1\r\n");
        let wide = |bytes: fn(u32) -> [u8; 4], mark: &[char]| -> Vec<u8> {
            let text = mark.iter().copied().chain("Höhe\n1,2\n".chars());
            text.flat_map(|letter| bytes(letter as u32)).collect()
        };
        for mark in [&[][..], &['\u{feff}']] {
            for bytes in [u32::to_le_bytes, u32::to_be_bytes] {
                let said = decode(&wide(bytes, mark), None).unwrap_err();
                assert_eq!(said, "is UTF-32, which is not read: save it as UTF-8");
            }
        }
    }

    #[test]
    fn a_named_encoding_is_kept_to() {
        let (japanese, ..) = encoding_rs::SHIFT_JIS.encode("位置,高さ\n1,2\n");
        let (text, name) = decode(&japanese, Some("shift_jis")).unwrap();
        assert_eq!((text.as_ref(), name), ("位置,高さ\n1,2\n", "Shift_JIS"));
        let said = decode(b"1,2\n", Some("ebcdic")).unwrap_err();
        assert!(said.contains("no encoding `ebcdic`"), "{said}");
        let said = decode(b"\xff1,2\n", Some("utf-8")).unwrap_err();
        assert_eq!(said, "is not text in the encoding UTF-8");
    }
}
