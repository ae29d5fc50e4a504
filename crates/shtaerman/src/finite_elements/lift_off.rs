//! The settlement at which the punch first touches.

use crate::{Problem, Rotational};

/// Intervals of a piece of the base between places that are looked at, besides its kinks and measured points.
const INTERVALS: usize = 4096;

/// The settlement under a force that goes to zero (m), the force at an eccentricity or the punch at a tilt: that of the rigid base on a rigid plane. A profile counted from
/// its lowest point lifts off at zero.
///
/// At a tilt `alpha` the base touches where `f + alpha x` is least, and that is the settlement. Under a force at the eccentricity `e` the tilt is free, and the base stands on the two points of its
/// lower convex hull beside `e`: the line through them is `delta - alpha x`.
///
/// The base is looked at in 4097 places, at its kinks and measured points: a smooth profile between them is known to the square of their distance, some `1e-8` of its height.
pub(super) fn lift_off(problem: &Problem, rotational: Rotational) -> f64 {
    let base = places(problem);
    let lowest = |tilt: f64| base.iter().map(|[x, f]| f + tilt * x).fold(f64::INFINITY, f64::min);
    match rotational {
        Rotational::Tilt(tilt) => lowest(tilt),
        // Nothing turns what is the same in all periods.
        _ if problem.is_wave() => lowest(0.0),
        Rotational::Eccentricity(at) => standing(&base, at),
        Rotational::Moment(_) => standing(&base, 0.0),
    }
}

/// Place (m) and height (m) of the base, from left to right.
fn places(problem: &Problem) -> Vec<[f64; 2]> {
    let (profile, half_width) = (problem.profile(), problem.punch().half_width());
    let mut places: Vec<f64> = Vec::new();
    for [left, right] in problem.punch().geometry().pieces(half_width) {
        let step = (right - left) / INTERVALS as f64;
        places.extend((0..=INTERVALS).map(|index| (left + step * index as f64).min(right)));
        let measured = profile.points().map_or(&[][..], |(positions, _)| positions);
        let marked = measured.iter().map(|x| x / half_width);
        places.extend(
            marked.chain(profile.breakpoints(half_width)).filter(|xi| *xi > left && *xi < right),
        );
    }
    let places = crate::order::ascending(places).into_iter();
    places.map(|xi| [xi * half_width, profile.height(xi, half_width)]).collect()
}

/// Where the line on which the base stands under a force at `at` is at `x = 0`.
fn standing(base: &[[f64; 2]], at: f64) -> f64 {
    let hull = lower_hull(base);
    let edge = |index: usize| {
        let [[left, low], [right, high]] = [hull[index], hull[index + 1]];
        (right - left, (high - low) / (right - left))
    };
    let index = hull.partition_point(|[x, _]| *x <= at).clamp(1, hull.len() - 1) - 1;
    let (length, slope) = edge(index);
    let [left, low] = hull[index];
    let from_left = at - left;
    let beside = if 2.0 * from_left < length { index.checked_sub(1) } else { Some(index + 1) };
    // Between the edges of a smooth base the slope is that of a curve through their middles, or it would be off by the length of an edge.
    let turned = beside.filter(|beside| beside + 1 < hull.len()).map_or(slope, |beside| {
        let (other_length, other) = edge(beside);
        let reach = 0.5 * length.min(other_length);
        let distance = from_left.min(length - from_left).max(0.0);
        let share = 0.5 * (1.0 - distance / reach).max(0.0);
        slope + share * (other - slope)
    });
    low + slope * from_left - turned * at
}

/// The lower convex hull of points from left to right.
fn lower_hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut hull: Vec<[f64; 2]> = Vec::new();
    for point in points.iter().copied() {
        while let [.., before, last] = hull.as_slice() {
            // A last point below the line from the one before to this one stays.
            let rise = (last[1] - before[1]) * (point[0] - before[0]);
            if rise < (point[1] - before[1]) * (last[0] - before[0]) {
                break;
            }
            hull.pop();
        }
        hull.push(point);
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Elastic, Foundation, Load, Profile, Punch};

    fn lifted(profile: &str, rotational: Rotational) -> f64 {
        let steel =
            Foundation::new(Elastic::new(2e11, 0.3).unwrap()).with_roughness(1e-14).unwrap();
        let punch = Punch::new(2.0).unwrap().with_profile(Profile::expression(profile).unwrap());
        lift_off(&Problem::new(steel, punch, Load::force(1.0).unwrap()).unwrap(), rotational)
    }

    #[test]
    fn a_base_stands_on_its_convex_hull() {
        use Rotational::{Eccentricity, Moment, Tilt};
        for (profile, rotational, exact) in [
            ("3", Moment(0.0), 3.0),
            ("x^2/8 + 0.1", Moment(0.0), 0.1),
            // The tangents at 1 and 0.7123, at 0.
            ("x^2/8", Eccentricity(1.0), -0.125),
            ("x^2/8", Eccentricity(0.7123), -0.7123 * 0.7123 / 8.0),
            // min x^2/8 - x/4 at 1
            ("x^2/8", Tilt(-0.25), -0.125),
            // Hollow: it stands on its corners, whatever the eccentricity.
            ("-x^2/8", Moment(0.0), -0.5),
            ("-x^2/8", Eccentricity(1.7), -0.5),
            // Two sharp feet at -1 and 1, of heights 0 and 0.2: the line through them at 0.
            ("min(abs(x+1), abs(x-1) + 0.2)", Eccentricity(0.3), 0.1),
        ] {
            let found = lifted(profile, rotational);
            assert!((found - exact).abs() < 2e-7, "{profile} {rotational:?}: {found}");
        }
    }
}
