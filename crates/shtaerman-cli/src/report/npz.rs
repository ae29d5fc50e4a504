//! Arrays for `NumPy`: an uncompressed ZIP archive of `.npy` files.

use std::io::{self, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::output::Content;

/// An array of numbers, row by row.
pub(crate) struct Array<'a> {
    name: &'a str,
    shape: Vec<usize>,
    values: Box<dyn Iterator<Item = f64> + 'a>,
}

impl<'a> Array<'a> {
    /// The array of this name, with the lengths of its dimensions.
    pub(crate) fn new(
        name: &'a str,
        shape: &[usize],
        values: impl Iterator<Item = f64> + 'a,
    ) -> Self {
        Self { name, shape: shape.to_vec(), values: Box::new(values) }
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
            archive.start_file(format!("{}.npy", array.name), options)?;
            npy(array, &mut archive)?;
        }
        archive.finish().map(drop).map_err(io::Error::from)
    })
}

/// Version 1.0 of the format: magic, length of the header, header, little-endian doubles.
fn npy(array: Array<'_>, out: &mut impl Write) -> io::Result<()> {
    const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
    const ALIGNMENT: usize = 64;
    /// Numbers that are handed on together.
    const PIECE: usize = 4096;
    let shape: String = array.shape.iter().map(|length| format!("{length}, ")).collect();
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    let bare = MAGIC.len() + 2 + header.len() + 1;
    header.push_str(&" ".repeat(bare.next_multiple_of(ALIGNMENT) - bare));
    header.push('\n');
    out.write_all(MAGIC)?;
    out.write_all(&(header.len() as u16).to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    let mut piece = Vec::with_capacity(8 * PIECE);
    for value in array.values {
        piece.extend(value.to_le_bytes());
        if piece.len() == 8 * PIECE {
            out.write_all(&piece)?;
            piece.clear();
        }
    }
    out.write_all(&piece)
}
