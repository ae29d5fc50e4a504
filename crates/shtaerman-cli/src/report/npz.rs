//! Arrays for `NumPy`: an uncompressed ZIP archive of `.npy` files.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::Failure;

/// An array of numbers, row by row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Array<'a> {
    /// Name.
    pub(crate) name: &'a str,
    /// Lengths of its dimensions.
    pub(crate) shape: &'a [usize],
    /// Its numbers.
    pub(crate) values: &'a [f64],
}

/// The bytes of an `.npz` file; the same arrays give the same bytes.
///
/// # Errors
/// [`Failure::Usage`] should writing to memory fail.
pub(crate) fn npz(arrays: &[Array<'_>]) -> Result<Vec<u8>, Failure> {
    let failure = |error: &dyn std::fmt::Display| Failure::Usage(error.to_string());
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(zip::DateTime::default());
    for array in arrays {
        let name = format!("{}.npy", array.name);
        archive.start_file(name, options).map_err(|error| failure(&error))?;
        archive.write_all(&npy(array)).map_err(|error| failure(&error))?;
    }
    Ok(archive.finish().map_err(|error| failure(&error))?.into_inner())
}

/// Version 1.0 of the format: magic, length of the header, header, little-endian doubles.
fn npy(array: &Array<'_>) -> Vec<u8> {
    const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
    const ALIGNMENT: usize = 64;
    let shape: String = array.shape.iter().map(|length| format!("{length}, ")).collect();
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({shape}), }}");
    let bare = MAGIC.len() + 2 + header.len() + 1;
    header.push_str(&" ".repeat(bare.next_multiple_of(ALIGNMENT) - bare));
    header.push('\n');
    let mut bytes = MAGIC.to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(array.values.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}
