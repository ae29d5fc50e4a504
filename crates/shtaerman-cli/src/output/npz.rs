//! Arrays for `NumPy`: an uncompressed ZIP archive of `.npy` files (version 1.0 of the format).

use std::io::{self, Cursor, Read, Write};

use shtaerman_study::Column;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::Content;

const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
/// Headers end at multiples of this.
const ALIGNMENT: usize = 64;
/// Numbers that are handed on together.
const PIECE: usize = 4096;
/// Characters of a text take four bytes, UTF-32.
const CHARACTER: usize = 4;

/// An array of values, row by row.
pub(crate) struct Array<'a> {
    name: String,
    shape: Vec<usize>,
    values: Values<'a>,
}

/// The values of an array.
pub(crate) enum Values<'a> {
    /// Doubles.
    Numbers(Box<dyn Iterator<Item = f64> + 'a>),
    /// Whole numbers of 64 bits.
    Whole(Vec<i64>),
    /// Texts, each as long as the longest.
    Texts(Vec<String>),
}

impl<'a> Array<'a> {
    /// The array of this name, with the lengths of its dimensions.
    pub(crate) fn new(name: impl Into<String>, shape: &[usize], values: Values<'a>) -> Self {
        Self { name: name.into(), shape: shape.to_vec(), values }
    }

    /// The same of numbers.
    pub(crate) fn numbers(
        name: &str,
        shape: &[usize],
        values: impl Iterator<Item = f64> + 'a,
    ) -> Self {
        Self::new(name, shape, Values::Numbers(Box::new(values)))
    }
}

/// An `.npz` file; the same arrays give the same bytes.
pub(crate) fn npz(arrays: Vec<Array<'_>>) -> Content<'_> {
    Content::archive(|out| {
        let mut archive = ZipWriter::new(out);
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(zip::DateTime::default());
        for array in arrays {
            archive.start_file(entry(&array.name), options)?;
            npy(array, &mut archive)?;
        }
        archive.finish().map(drop).map_err(io::Error::from)
    })
}

fn entry(name: &str) -> String {
    format!("{name}.npy")
}

/// Magic, length of the header, header, little-endian values.
fn npy(array: Array<'_>, out: &mut impl Write) -> io::Result<()> {
    let width = match &array.values {
        Values::Texts(texts) => {
            texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1)
        }
        Values::Numbers(_) | Values::Whole(_) => 0,
    };
    let kind = match &array.values {
        Values::Numbers(_) => "<f8".to_owned(),
        Values::Whole(_) => "<i8".to_owned(),
        Values::Texts(_) => format!("<U{width}"),
    };
    let shape: String = array.shape.iter().map(|length| format!("{length}, ")).collect();
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    let bare = MAGIC.len() + 2 + header.len() + 1;
    header.push_str(&" ".repeat(bare.next_multiple_of(ALIGNMENT) - bare));
    header.push('\n');
    out.write_all(MAGIC)?;
    out.write_all(&(header.len() as u16).to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    match array.values {
        Values::Numbers(values) => in_pieces(values.map(f64::to_le_bytes), out),
        Values::Whole(values) => in_pieces(values.into_iter().map(i64::to_le_bytes), out),
        Values::Texts(texts) => {
            let padded = texts.iter().flat_map(|text| {
                let characters = text.chars().map(|c| u32::from(c).to_le_bytes());
                characters.chain(std::iter::repeat([0; CHARACTER])).take(width)
            });
            in_pieces(padded, out)
        }
    }
}

fn in_pieces<const N: usize>(
    values: impl Iterator<Item = [u8; N]>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut piece = Vec::with_capacity(N * PIECE);
    for value in values {
        piece.extend(value);
        if piece.len() == N * PIECE {
            out.write_all(&piece)?;
            piece.clear();
        }
    }
    out.write_all(&piece)
}

/// An `.npz` file that was written here: arrays of one dimension.
pub(crate) struct Archive<'b> {
    archive: ZipArchive<Cursor<&'b [u8]>>,
    /// No array is larger than the file.
    most: usize,
}

impl<'b> Archive<'b> {
    /// None unless it is a whole archive.
    pub(crate) fn new(bytes: &'b [u8]) -> Option<Self> {
        let archive = ZipArchive::new(Cursor::new(bytes)).ok()?;
        Some(Self { archive, most: bytes.len() })
    }

    /// The column of this name; none where there is none, its sum of check is another, or it is of another kind.
    pub(crate) fn column(&mut self, name: &str) -> Option<Column> {
        let mut bytes = Vec::new();
        let entry = self.archive.by_name(&entry(name)).ok()?;
        entry.take(self.most as u64 + 1).read_to_end(&mut bytes).ok()?;
        let rest = bytes.strip_prefix(MAGIC)?;
        let (length, rest) = rest.split_first_chunk::<2>()?;
        let (header, values) = rest.split_at_checked(usize::from(u16::from_le_bytes(*length)))?;
        let header = std::str::from_utf8(header).ok()?;
        let kind = header.strip_prefix("{'descr': '<")?.split('\'').next()?;
        let words = || values.chunks_exact(8).filter_map(|word| word.try_into().ok());
        match kind {
            "f8" => Some(Column::Number(words().map(f64::from_le_bytes).collect())),
            "i8" => Some(Column::Whole(words().map(i64::from_le_bytes).collect())),
            _ => {
                let width: usize = kind.strip_prefix('U')?.parse().ok()?;
                let bytes = width.checked_mul(CHARACTER).filter(|bytes| *bytes > 0)?;
                values.chunks_exact(bytes).map(text).collect::<Option<_>>().map(Column::Text)
            }
        }
    }
}

/// The text of its characters, up to those that only fill.
fn text(bytes: &[u8]) -> Option<String> {
    let codes = bytes.chunks_exact(CHARACTER).filter_map(|code| code.try_into().ok());
    codes.map(u32::from_le_bytes).take_while(|code| *code != 0).map(char::from_u32).collect()
}
