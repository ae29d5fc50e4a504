//! What goes through the pipes between server and worker: a length in four bytes, least first, then as many bytes.

use std::io::{Error, ErrorKind, Read, Result, Write};

/// The largest message (64 MB).
const LARGEST: u32 = 64 << 20;

/// Writes a message.
///
/// # Errors
/// Those of `out`; [`ErrorKind::InvalidInput`] for a message that is too large.
pub(crate) fn write(out: &mut impl Write, message: &[u8]) -> Result<()> {
    let length = u32::try_from(message.len()).ok().filter(|length| *length <= LARGEST);
    let length = length.ok_or_else(|| {
        Error::new(ErrorKind::InvalidInput, format!("{} bytes are too many", message.len()))
    })?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(message)?;
    out.flush()
}

/// Reads a message.
///
/// # Errors
/// Those of `input`, [`ErrorKind::UnexpectedEof`] where it has ended, [`ErrorKind::InvalidData`] for a length that no message has.
pub(crate) fn read(input: &mut impl Read) -> Result<Vec<u8>> {
    let mut length = [0; 4];
    input.read_exact(&mut length)?;
    let length = u32::from_le_bytes(length);
    if length > LARGEST {
        return Err(Error::new(ErrorKind::InvalidData, "no message is that long"));
    }
    let mut message = vec![0; length as usize];
    input.read_exact(&mut message)?;
    Ok(message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_come_out_as_they_went_in_and_wrong_lengths_are_refused() {
        let mut pipe = Vec::new();
        for message in [&b"one"[..], b"", b"three"] {
            write(&mut pipe, message).unwrap();
        }
        let mut rest = &pipe[..];
        assert_eq!(read(&mut rest).unwrap(), b"one");
        assert_eq!(read(&mut rest).unwrap(), b"");
        assert_eq!(read(&mut rest).unwrap(), b"three");
        assert_eq!(read(&mut rest).unwrap_err().kind(), ErrorKind::UnexpectedEof);
        assert_eq!(read(&mut &[255; 8][..]).unwrap_err().kind(), ErrorKind::InvalidData);
        assert_eq!(read(&mut &[9, 0, 0, 0, 1][..]).unwrap_err().kind(), ErrorKind::UnexpectedEof);
    }
}
