//! What is written: made before, or piece by piece while it is written.

use std::fmt;
use std::fs::File;
use std::io::{self, BufWriter, Cursor, Seek, Write};
use std::path::Path;

use serde::Serialize;

use crate::Failure;
use crate::terminal::{folded, painted};

/// Bytes that are handed to the system together.
const BUFFER: usize = 1 << 16;

/// Text, a picture, or a way to write what may be larger than memory should hold.
pub(crate) enum Content<'a> {
    /// Made before.
    Bytes(Vec<u8>),
    /// For people: a terminal shows it in colours.
    Page(String),
    /// Written piece by piece.
    Stream(Writer<'a>),
    /// The same by who goes back in it, as in an archive whose entries begin with their lengths.
    Archive(Archiver<'a>),
}

type Writer<'a> = Box<dyn FnOnce(&mut dyn Write) -> io::Result<()> + 'a>;
type Archiver<'a> = Box<dyn FnOnce(&mut dyn Place) -> io::Result<()> + 'a>;

/// What can be gone back in.
pub(crate) trait Place: Write + Seek {}

impl<T: Write + Seek> Place for T {}

impl<'a> Content<'a> {
    /// Text for people, its lines not too long for a terminal.
    pub(crate) fn page(text: &str) -> Self {
        Self::Page(folded(text))
    }

    /// The same in colours, if it is for people.
    pub(super) fn painted(self) -> Self {
        match self {
            Self::Page(text) => Self::Bytes(painted(&text).into_bytes()),
            other => other,
        }
    }

    /// Content that `write` writes.
    pub(crate) fn stream(write: impl FnOnce(&mut dyn Write) -> io::Result<()> + 'a) -> Self {
        Self::Stream(Box::new(write))
    }

    /// Content that `write` writes, going back in it.
    pub(crate) fn archive(write: impl FnOnce(&mut dyn Place) -> io::Result<()> + 'a) -> Self {
        Self::Archive(Box::new(write))
    }

    /// Pretty JSON with a final newline.
    pub(crate) fn json(value: impl Serialize + 'a) -> Self {
        Self::stream(move |out| {
            serde_json::to_writer_pretty(&mut *out, &value)?;
            out.write_all(b"\n")
        })
    }

    /// What it writes.
    pub(crate) fn bytes(self) -> Result<Vec<u8>, Failure> {
        let mut bytes = Vec::new();
        self.write_to(&mut bytes).map_err(|error| in_memory(&error))?;
        Ok(bytes)
    }

    /// What it writes, as text.
    pub(crate) fn text(self) -> Result<String, Failure> {
        String::from_utf8(self.bytes()?).map_err(|error| in_memory(&io::Error::other(error)))
    }

    /// CSV with a header.
    pub(crate) fn csv(
        header: &[impl AsRef<str>],
        rows: impl IntoIterator<Item = Vec<String>> + 'a,
    ) -> Self {
        let header: Vec<String> = header.iter().map(|head| head.as_ref().to_owned()).collect();
        Self::stream(move |out| {
            let mut writer = csv::Writer::from_writer(out);
            writer.write_record(&header).map_err(unwrapped)?;
            for row in rows {
                writer.write_record(row).map_err(unwrapped)?;
            }
            writer.flush()
        })
    }

    /// Writes it all.
    pub(super) fn write_to(self, out: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Bytes(bytes) => out.write_all(&bytes)?,
            Self::Page(text) => out.write_all(text.as_bytes())?,
            Self::Stream(write) => {
                let mut buffered = BufWriter::with_capacity(BUFFER, &mut *out);
                write(&mut buffered)?;
                buffered.flush()?;
            }
            // A device or a pipe goes forward only.
            Self::Archive(write) => {
                let mut whole = Cursor::new(Vec::new());
                write(&mut whole)?;
                out.write_all(whole.get_ref())?;
            }
        }
        out.flush()
    }

    /// The same to a file.
    pub(super) fn write_to_file(self, file: &mut File) -> io::Result<()> {
        match self {
            Self::Archive(write) => {
                let mut buffered = BufWriter::with_capacity(BUFFER, file);
                write(&mut buffered)?;
                buffered.flush()
            }
            other => other.write_to(file),
        }
    }
}

fn in_memory(error: &io::Error) -> Failure {
    Failure::unwritten(Path::new("memory"), error)
}

/// The error of the system, which says whether a pipe was closed.
fn unwrapped(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

impl From<String> for Content<'_> {
    fn from(text: String) -> Self {
        Self::Bytes(text.into_bytes())
    }
}

impl From<&str> for Content<'_> {
    fn from(text: &str) -> Self {
        Self::Bytes(text.as_bytes().to_vec())
    }
}

impl From<Vec<u8>> for Content<'_> {
    fn from(bytes: Vec<u8>) -> Self {
        Self::Bytes(bytes)
    }
}

impl fmt::Debug for Content<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Bytes(_) => "Bytes",
            Self::Page(_) => "Page",
            Self::Stream(_) => "Stream",
            Self::Archive(_) => "Archive",
        })
    }
}
