//! Formulas.

use shtaerman_input::expression::{Expression, Interval, Line, Verdict};

use crate::broken::broken;
use crate::check::Outcome;
use crate::{Random, check, written};

/// Searches over a range take many enclosures: one case in so many has them.
const SEARCHED: usize = 200;

/// Parses a formula; its enclosures hold its values, and what is proved finite is finite.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let size = 1 + random.below(24);
    let mut text = written::formula(random, &["x", "xi"], size);
    if random.one_in(2) {
        text = broken(random, &text);
    }
    let formula = match Expression::parse(&text, &["x", "xi"]) {
        Ok(formula) => formula,
        Err(error) => {
            let place = text.get(error.span.clone());
            check::holds(place.is_some(), "the place lies outside the text", &text)?;
            let help = error.help().unwrap_or_default();
            let pointed = error.pointed_at(&text);
            return check::refusal(&format!("{error} {help} {}", pointed.len()), &text);
        }
    };
    let ends = [random.between(-2.0, 2.0), random.between(-2.0, 2.0)];
    let range = Interval::ends(ends[0].min(ends[1]), ends[0].max(ends[1]));
    let line = Line::new(&[(random.between(-1.0, 1.0), random.power(-3.0, 3.0)), (0.0, 1.0)]);
    let enclosed = formula.enclose_along(&line, range);
    let searched = random.one_in(SEARCHED);
    let verdict = searched.then(|| formula.finiteness(&line, range));
    for _ in 0..4 {
        let t = random.between(range.lower(), range.upper());
        let value = formula.evaluate_at(&line, t);
        let is_held = enclosed.interval.contains(value);
        let is_excused = value.is_nan() && enclosed.may_be_undefined;
        let what = format!("the enclosure {enclosed:?} lacks {value:e} at {t:e} of {line:?}");
        check::holds(is_held || is_excused, &what, &text)?;
        let is_finite = verdict != Some(Verdict::ProvedFinite) || value.is_finite();
        check::holds(is_finite, &format!("proved finite, {value} at {t:e} of {line:?}"), &text)?;
        let (same, _) = formula.derivative_along(&line, t);
        let agrees =
            same.to_bits() == value.to_bits() || same == value || same.is_nan() && value.is_nan();
        check::holds(agrees, &format!("{value:e}, with its derivative {same:e}, at {t:e}"), &text)?;
        let _ = formula.rise_along(&line, t, random.power(-9.0, 0.0));
    }
    if searched {
        let found = formula.breakpoints(&line, range);
        let is_inside = found.places.iter().all(|&place| range.contains(place));
        let is_rising = found.places.windows(2).all(|pair| pair[0] < pair[1]);
        check::holds(is_inside && is_rising, "breaks out of order or range", &text)?;
        let _ = formula.reflection(&line);
    }
    Ok(Outcome::Accepted)
}
