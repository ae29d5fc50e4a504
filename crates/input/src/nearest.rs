//! The nearest of a set of known names, for "did you mean".

/// Names less alike than this are not worth proposing (Jaro-Winkler similarity, 0 to 1).
///
/// At 0.8 a swap, a dropped letter and a wrong ending of a short name are found, and two names
/// that share no more than a first letter are not.
const LEAST_SIMILARITY: f64 = 0.8;

/// Longer texts are hostile or not a name; comparing them costs time quadratic in their length.
const LONGEST_NAME: usize = 64;

/// The name most like `written`, letter case counting less than letters; none if nothing is near.
///
/// Of equally near names the first wins, so the answer depends on the order of `known` alone.
pub fn nearest<'a>(written: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if written.len() > LONGEST_NAME {
        return None;
    }
    let lower = written.to_lowercase();
    let mut best: Option<(f64, &str)> = None;
    for name in known {
        // The mean of both readings: "mpa" is nearer to MPa than to mPa only by this tie-break.
        let similarity = 0.75 * strsim::jaro_winkler(&lower, &name.to_lowercase())
            + 0.25 * strsim::jaro_winkler(written, name);
        if best.is_none_or(|(score, _)| similarity > score) {
            best = Some((similarity, name));
        }
    }
    let (_, name) = best?;
    let likeness = strsim::jaro_winkler(&lower, &name.to_lowercase());
    (likeness >= LEAST_SIMILARITY).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn finds_slips_of_the_pen_and_no_strangers() {
        let known = ["half_width", "profile", "compliance", "force"];
        assert_eq!(nearest("half_witdh", known), Some("half_width"));
        assert_eq!(nearest("Force", known), Some("force"));
        assert_eq!(nearest("complaince", known), Some("compliance"));
        assert_eq!(nearest("temperature", known), None);
        assert_eq!(nearest("", known), None);
        assert_eq!(nearest("force", []), None);
    }

    #[test]
    fn refuses_to_compare_hostile_lengths() {
        assert_eq!(nearest(&"force".repeat(100_000), ["force"]), None);
    }
}
