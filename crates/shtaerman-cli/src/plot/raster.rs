//! A PNG with smooth edges.
//!
//! The rasteriser leaves lines that are nearly level as staircases and turned letters jagged, so the
//! picture is drawn larger and every pixel is the mean of a square of finer ones.

use std::io::Cursor;

use kuva::backend::raster::RasterBackend;
use kuva::render::render::Scene;

use super::error::PlotError;
use super::format::{MOST_PIXELS, Size, UNITS_PER_INCH};

/// Fine pixels that are held at once, at most: 4 bytes each.
const MOST_FINE_PIXELS: u64 = MOST_PIXELS;

/// Pixels for each unit of a size.
fn pixels_per_unit(dots_per_inch: u32) -> f64 {
    f64::from(dots_per_inch) / f64::from(UNITS_PER_INCH)
}

/// Fine pixels along the side of a pixel.
fn fineness(size: Size, dots_per_inch: u32) -> u32 {
    let pixels =
        f64::from(size.width) * f64::from(size.height) * pixels_per_unit(dots_per_inch).powi(2);
    let fits = |side: &u32| pixels * f64::from(side.pow(2)) <= MOST_FINE_PIXELS as f64;
    [3, 2].into_iter().find(fits).unwrap_or(1)
}

/// The scene as a PNG of so many pixels for an inch (96 units of its size).
pub(super) fn png(scene: &Scene, size: Size, dots_per_inch: u32) -> Result<Vec<u8>, PlotError> {
    let fineness = fineness(size, dots_per_inch);
    let scale = (f64::from(fineness) * pixels_per_unit(dots_per_inch)) as f32;
    let fine =
        RasterBackend::new().with_scale(scale).render_scene(scene).map_err(PlotError::Encoding)?;
    let (fine, width) = decode(&fine).map_err(|error| PlotError::Encoding(error.to_string()))?;
    let side = fineness as usize;
    let pixels = means(&fine, width, side);
    let columns = width / side;
    let rows = pixels.len() / (3 * columns.max(1));
    let size = (columns as u32, rows as u32);
    encode(&pixels, size, dots_per_inch).map_err(|error| PlotError::Encoding(error.to_string()))
}

/// Pixels of four bytes and their number in a row.
fn decode(bytes: &[u8]) -> Result<(Vec<u8>, usize), png::DecodingError> {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info()?;
    let length = reader.output_buffer_size().ok_or(png::DecodingError::LimitsExceeded)?;
    let mut pixels = vec![0; length];
    let info = reader.next_frame(&mut pixels)?;
    Ok((pixels, info.width as usize))
}

/// Mean red, green and blue of squares of pixels. Written as plain loops: this is most of the time of a picture where the program is not optimised.
fn means(fine: &[u8], width: usize, side: usize) -> Vec<u8> {
    let count = (side * side) as u32;
    let columns = width / side;
    let mut pixels = Vec::with_capacity(fine.len() / (side * side) * 3 / 4);
    let mut sums = vec![[0_u32; 3]; columns];
    for rows in fine.chunks_exact(4 * width * side) {
        sums.fill([0; 3]);
        for row in rows.chunks_exact(4 * width) {
            let mut at = 0;
            for sum in &mut sums {
                let end = at + 4 * side;
                while at < end {
                    sum[0] += u32::from(row[at]);
                    sum[1] += u32::from(row[at + 1]);
                    sum[2] += u32::from(row[at + 2]);
                    at += 4;
                }
            }
        }
        for sum in &sums {
            for part in sum {
                pixels.push(((part + count / 2) / count) as u8);
            }
        }
    }
    pixels
}

fn encode(
    pixels: &[u8],
    size: (u32, u32),
    dots_per_inch: u32,
) -> Result<Vec<u8>, png::EncodingError> {
    /// Inches in a metre.
    const INCHES: f64 = 1.0 / 0.0254;
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.0, size.1);
    let dots_per_metre = (INCHES * f64::from(dots_per_inch)).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: dots_per_metre,
        yppu: dots_per_metre,
        unit: png::Unit::Meter,
    }));
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
        for (size, dots) in [(Size::SMALLEST, 1200), (Size::default(), 192), (Size::LARGEST, 192)] {
            let side = f64::from(fineness(size, dots)) * pixels_per_unit(dots);
            let fine = f64::from(size.width) * f64::from(size.height) * side * side;
            assert!(fine <= MOST_FINE_PIXELS as f64);
        }
        assert_eq!(fineness(Size::default(), 192), 3);
    }
}
