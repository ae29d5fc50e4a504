//! A PNG with smooth edges.
//!
//! The rasteriser leaves lines that are nearly level as staircases and turned letters jagged, so the
//! picture is drawn larger and every pixel is the mean of a square of finer ones.

use std::io::Cursor;

use kuva::backend::raster::RasterBackend;
use kuva::render::render::Scene;

use super::error::PlotError;
use super::format::{PNG_PIXELS_PER_UNIT, Size};

/// Fine pixels that are held at once, at most: 4 bytes each.
const MOST_FINE_PIXELS: u64 = 80_000_000;

/// Fine pixels along the side of a pixel.
fn fineness(size: Size) -> u32 {
    let pixels =
        u64::from(size.width) * u64::from(size.height) * u64::from(PNG_PIXELS_PER_UNIT).pow(2);
    let fits = |side: &u32| pixels * u64::from(*side).pow(2) <= MOST_FINE_PIXELS;
    [3, 2].into_iter().find(fits).unwrap_or(1)
}

/// The scene as a PNG of [`PNG_PIXELS_PER_UNIT`] pixels for each unit of its size.
pub(super) fn png(scene: &Scene, size: Size) -> Result<Vec<u8>, PlotError> {
    let fineness = fineness(size);
    let scale = (fineness * PNG_PIXELS_PER_UNIT) as f32;
    let fine =
        RasterBackend::new().with_scale(scale).render_scene(scene).map_err(PlotError::Encoding)?;
    let (fine, width) = decode(&fine).map_err(|error| PlotError::Encoding(error.to_string()))?;
    let pixels = means(&fine, width, fineness as usize);
    let size = (PNG_PIXELS_PER_UNIT * size.width, PNG_PIXELS_PER_UNIT * size.height);
    encode(&pixels, size).map_err(|error| PlotError::Encoding(error.to_string()))
}

/// Pixels of four bytes and their number in a row.
fn decode(bytes: &[u8]) -> Result<(Vec<u8>, usize), png::DecodingError> {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info()?;
    let length = reader.output_buffer_size().ok_or(png::DecodingError::LimitsExceeded)?;
    let mut pixels = vec![0; length];
    let info = reader.next_frame(&mut pixels)?;
    Ok((pixels, info.width as usize))
}

/// Mean red, green and blue of squares of pixels.
fn means(fine: &[u8], width: usize, side: usize) -> Vec<u8> {
    let count = (side * side) as u32;
    let mut pixels = Vec::with_capacity(fine.len() / (side * side) * 3 / 4);
    for rows in fine.chunks_exact(4 * width * side) {
        for column in 0..width / side {
            let mut sums = [0_u32; 3];
            for row in rows.chunks_exact(4 * width) {
                for pixel in row[4 * side * column..4 * side * (column + 1)].chunks_exact(4) {
                    sums.iter_mut().zip(pixel).for_each(|(sum, part)| *sum += u32::from(*part));
                }
            }
            pixels.extend(sums.map(|sum| ((sum + count / 2) / count) as u8));
        }
    }
    pixels
}

fn encode(pixels: &[u8], size: (u32, u32)) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.0, size.1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_is_the_mean_of_its_square() {
        let fine = [
            [0, 0, 0, 255],
            [100, 40, 8, 255],
            [9, 9, 9, 255],
            [9, 9, 9, 255],
            [0, 0, 0, 255],
            [100, 40, 8, 255],
            [9, 9, 9, 255],
            [9, 9, 9, 255],
        ];
        assert_eq!(means(fine.as_flattened(), 4, 2), [50, 20, 4, 9, 9, 9]);
    }

    #[test]
    fn the_largest_picture_stays_within_memory() {
        for size in [Size::SMALLEST, Size::default(), Size::LARGEST] {
            let side = u64::from(fineness(size) * PNG_PIXELS_PER_UNIT);
            assert!(
                u64::from(size.width) * u64::from(size.height) * side * side <= MOST_FINE_PIXELS
            );
        }
        assert_eq!(fineness(Size::default()), 3);
    }
}
