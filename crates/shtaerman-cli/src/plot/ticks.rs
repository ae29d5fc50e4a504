//! Round numbers along an axis and how they are written.

use super::axis::{Range, Scale, usable};
use super::text::superscript;

/// A labelled place on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    /// Place in the units in which the axis is even.
    pub(super) place: f64,
    pub(super) label: String,
}

/// The ticks of an axis.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Ticks {
    pub(super) labelled: Vec<Tick>,
    /// Places of lines without a label.
    pub(super) minor: Vec<f64>,
    /// The labels are to be multiplied by ten to this power.
    pub(super) exponent: i32,
}

impl Ticks {
    /// About `wanted` ticks over a range.
    pub(super) fn new(scale: Scale, range: Range, wanted: usize) -> Self {
        let wanted = wanted.max(2);
        match scale {
            Scale::Linear => linear(range, wanted),
            Scale::Logarithmic => logarithmic(range, wanted),
            Scale::SymmetricLogarithmic { threshold } => {
                symmetric(range, wanted, usable(threshold))
            }
        }
    }

    /// The places 0, 1, 2 and so on with their names.
    pub(super) fn named(names: &[String]) -> Self {
        let named = names.iter().enumerate();
        let labelled =
            named.map(|(place, name)| Tick { place: place as f64, label: name.clone() }).collect();
        Self { labelled, ..Self::default() }
    }

    /// The common power of ten as text; empty when it is one.
    pub(super) fn multiplier(&self) -> String {
        match self.exponent {
            0 => String::new(),
            exponent => format!("×10{}", superscript(exponent)),
        }
    }
}

/// Exponent of the leading digit, within those of floating-point numbers.
fn power_of_ten(size: f64) -> i32 {
    (size.log10().floor() as i32).clamp(-308, 308)
}

/// A step of 1, 2 or 5 times a power of ten: factor and exponent.
fn round_step(width: f64) -> (i64, i32) {
    let exponent = power_of_ten(width);
    match width / 10f64.powi(exponent) {
        part if part < 1.5 => (1, exponent),
        part if part < 3.2 => (2, exponent),
        part if part < 7.1 => (5, exponent),
        _ => (1, exponent + 1),
    }
}

fn linear(range: Range, wanted: usize) -> Ticks {
    let (factor, power) = round_step((range.high - range.low) / wanted as f64);
    let step = factor as f64 * 10f64.powi(power);
    let first = (range.low / step - 1e-6).ceil() as i64;
    let last = (range.high / step + 1e-6).floor() as i64;
    let exponent = common_exponent(range.low.abs().max(range.high.abs()));
    let tick = |index: i64| Tick {
        place: index as f64 * step,
        label: decimal(index.saturating_mul(factor), power - exponent),
    };
    let labelled = (first..=last).take(10 * wanted).map(tick).collect();
    Ticks { labelled, minor: Vec::new(), exponent }
}

/// A multiple of three to take out of numbers too large or small to write in full.
fn common_exponent(size: f64) -> i32 {
    let exponent = power_of_ten(size);
    if (-2..5).contains(&exponent) { 0 } else { 3 * exponent.div_euclid(3) }
}

/// `digits * 10^power` in positional notation.
fn decimal(digits: i64, power: i32) -> String {
    let sign = if digits < 0 { "−" } else { "" };
    let mut text = digits.unsigned_abs().to_string();
    if power >= 0 && digits != 0 {
        text.push_str(&"0".repeat(power as usize));
    } else if power < 0 {
        let decimals = power.unsigned_abs() as usize;
        text = format!("{text:0>width$}", width = decimals + 1);
        text.insert(text.len() - decimals, '.');
    }
    format!("{sign}{text}")
}

fn logarithmic(range: Range, wanted: usize) -> Ticks {
    let decades = range.high - range.low;
    if decades < 0.5 {
        return narrow_logarithmic(range, wanted);
    }
    let stride = stride(decades, wanted);
    let factors: &[i64] = if wanted as f64 > 2.2 * decades { &[1, 2, 5] } else { &[1] };
    let (first, last) = (range.low.floor() as i32, range.high.ceil() as i32);
    let plain = first >= -3 && last <= 5;
    let mut ticks = Ticks::default();
    for power in first..=last {
        for digit in 1..10 {
            let place = f64::from(power) + (digit as f64).log10();
            if place < range.low - 1e-9 || place > range.high + 1e-9 {
                continue;
            }
            if factors.contains(&digit) && power.rem_euclid(stride) == 0 {
                ticks.labelled.push(Tick { place, label: scientific(digit, power, plain) });
            } else if (stride == 1 && decades < 10.0) || digit == 1 {
                ticks.minor.push(place);
            }
        }
    }
    ticks
}

/// Less than half a decade: the even steps of a linear axis read better.
fn narrow_logarithmic(range: Range, wanted: usize) -> Ticks {
    let values = Range { low: 10f64.powf(range.low), high: 10f64.powf(range.high) };
    let mut ticks = linear(values, wanted);
    for tick in &mut ticks.labelled {
        tick.place = tick.place.log10();
    }
    ticks.labelled.retain(|tick| tick.place.is_finite());
    ticks
}

/// Every how many decades a label is written.
fn stride(decades: f64, wanted: usize) -> i32 {
    let least = (decades / wanted as f64).ceil().max(1.0) as i32;
    [1, 2, 3, 5, 10, 20, 50, 100].into_iter().find(|&stride| stride >= least).unwrap_or(200)
}

/// `digit * 10^power`, written out where `plain`.
fn scientific(digit: i64, power: i32, plain: bool) -> String {
    if plain {
        decimal(digit, power)
    } else {
        let sign = if digit < 0 { "−" } else { "" };
        match digit.abs() {
            1 => format!("{sign}10{}", superscript(power)),
            digit => format!("{sign}{digit}·10{}", superscript(power)),
        }
    }
}

fn symmetric(range: Range, wanted: usize, threshold: f64) -> Ticks {
    let scale = Scale::SymmetricLogarithmic { threshold };
    let first = threshold.log10().round() as i32;
    let reach = range.low.abs().max(range.high.abs());
    let last = first + reach.floor() as i32;
    let stride = stride(range.high - range.low, wanted);
    let apart = 0.5 * (range.high - range.low) / wanted as f64;
    let plain = first >= -4 && last <= 5;
    let inside = |place: &f64| (range.low - 1e-9..=range.high + 1e-9).contains(place);
    let mut ticks = Ticks::default();
    if inside(&0.0) {
        ticks.labelled.push(Tick { place: 0.0, label: "0".to_owned() });
    }
    for power in first..=last {
        for sign in [-1, 1] {
            let value = sign as f64 * 10f64.powi(power);
            let Some(place) = scale.place(value).filter(inside) else { continue };
            if (last - power) % stride == 0 && place.abs() > apart {
                ticks.labelled.push(Tick { place, label: scientific(sign, power, plain) });
            } else {
                ticks.minor.push(place);
            }
        }
    }
    ticks.labelled.sort_by(|a, b| a.place.total_cmp(&b.place));
    ticks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, low: f64, high: f64) -> Vec<String> {
        let ticks = Ticks::new(scale, Range { low, high }, 6);
        ticks.labelled.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_labels_are_exact_decimals() {
        assert_eq!(
            labels(Scale::Linear, 0.0, 1.2),
            ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0", "1.2"]
        );
        assert_eq!(labels(Scale::Linear, -21.0, 42.0), ["−20", "−10", "0", "10", "20", "30", "40"]);
    }

    #[test]
    fn a_common_power_of_ten_is_taken_out_of_tiny_and_huge_numbers() {
        for (size, exponent) in [(3e-15, -15), (4e20, 18), (2e5, 3), (0.02, 0), (3e4, 0)] {
            let ticks = Ticks::new(Scale::Linear, Range { low: 0.0, high: size }, 5);
            assert_eq!(ticks.exponent, exponent);
            for tick in &ticks.labelled {
                let value = tick.label.parse::<f64>().unwrap() * 10f64.powi(exponent);
                assert!((value - tick.place).abs() <= 1e-12 * size, "{tick:?}");
            }
        }
    }

    #[test]
    fn logarithmic_labels_are_powers_of_ten() {
        assert_eq!(labels(Scale::Logarithmic, 0.0, 2.0), ["1", "2", "5", "10", "20", "50", "100"]);
        assert_eq!(labels(Scale::Logarithmic, -13.0, -2.0)[0], "10⁻¹²");
        assert_eq!(labels(Scale::Logarithmic, 0.01, 0.2).first().map(String::as_str), Some("1.1"));
    }

    #[test]
    fn symmetric_labels_mirror_about_zero() {
        let scale = Scale::SymmetricLogarithmic { threshold: 0.01 };
        let expected = ["−1", "−0.1", "0", "0.1", "1"];
        assert_eq!(labels(scale, -2.1, 2.1), expected);
    }
}
