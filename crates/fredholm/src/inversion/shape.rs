//! The slope `h = df0/dr` of the base along a radius, or of its even or odd part about the middle of a strip, and its integrals over the contact.

use std::cell::Cell;
use std::collections::VecDeque;
use std::f64::consts::FRAC_PI_2;

use super::accuracy::{DEEPEST, NOISE, OF_A_VALUE};
use super::powers::Powers;
use super::rule::{ORDER, RULE, integral};

/// Panels of an integral at most, and its accuracy over that of what is made of it. At half or twice 6 of 27 answers change, within what they state (survey).
const MOST_PANELS: usize = 512;
const INNER: f64 = 1e-2;

/// A panel at the axis that does not settle in so many halvings is integrated by the logarithm of the distance, this far. At half or twice 2 of 27 answers change, within what they state (survey).
const BESIDE_AXIS: u32 = 8;
const FARTHEST: f64 = 500.0;

/// What the slope is multiplied by, `r = x cos t`, besides `sin^mu t`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weight {
    /// 1.
    One,
    /// `sin^2 t`.
    SineSquared,
    /// `cos^2 t`.
    CosineSquared,
    /// `mu sin t S(t)`, `S = int_0^t sin^mu`, without `sin^mu t`.
    Lever,
    /// `cos t sin^mu t + mu sin t S(t)`.
    Level,
}

/// Which displacements a transform is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symmetry {
    /// Those of a disk that do not depend on the angle.
    Revolution,
    /// In the plane, even.
    Even,
    /// In the plane, odd.
    Odd,
}

impl Symmetry {
    /// The power of `t` in the displacement beside the contact, besides `t^mu`.
    pub fn lever(self) -> i32 {
        match self {
            Self::Revolution => 0,
            Self::Even => -1,
            Self::Odd => 1,
        }
    }
}

/// The base of revolution, or half of an even or odd one.
pub struct Shape<'p> {
    /// `h(r)`, at a kink on either side.
    pub slope: &'p dyn Fn(f64) -> f64,
    /// Where it bends, increasing, all positive.
    pub breaks: Vec<f64>,
    /// Where one polynomial ends and another begins, increasing, all positive: integrals are cut there.
    pub joints: Vec<f64>,
    /// To which share integrals are wanted.
    pub tolerance: f64,
    /// Rounding of the slope beyond that of its size.
    pub noise: f64,
    /// How far `r = 0` lies from where places are counted from: they are rounded, which is felt where the slope is steep.
    pub remote: f64,
    /// Those of the kernel.
    pub powers: Powers,
    /// Which displacements it is of.
    pub part: Symmetry,
    /// Whether nothing is to be halved any more, as the time is over.
    pub is_over: &'p dyn Fn() -> bool,
}

impl Shape<'_> {
    /// `G(x) = x^(1-mu) int_0^x h(r) dr/(x^2 - r^2)^((1-mu)/2)`: the height above `f0(0)` that a disk of the radius `x` with a free edge settles by. Of an odd part in the
    /// plane `G/x`, of an even one `x int_0^{pi/2} h(x cos t) (cos t sin^mu t + mu sin t S(t)) dt`.
    pub fn transform(&self, x: f64) -> f64 {
        self.transformed(x, |at| ((x - at) * (x + at)).sqrt())[0]
    }

    /// The share to which a transform is exact beside its rounding.
    pub fn inexactness(&self) -> f64 {
        INNER * self.tolerance
    }

    /// With what rounded places make of it.
    fn transformed(&self, x: f64, leg: impl Fn(f64) -> f64) -> [f64; 2] {
        match self.part {
            Symmetry::Revolution => self.integrated(x, Weight::One, leg).map(|sum| x * sum),
            Symmetry::Even => self.integrated(x, Weight::Level, leg).map(|sum| x * sum),
            Symmetry::Odd => self.integrated(x, Weight::One, leg),
        }
    }

    fn weight(&self, weight: Weight, angle: f64) -> f64 {
        let powers = &self.powers;
        let lever = || powers.exponent() * angle.sin() * powers.sines().at(angle);
        let power = || powers.power(angle.sin());
        match weight {
            Weight::One => power(),
            Weight::SineSquared => power() * angle.sin().powi(2),
            Weight::CosineSquared => power() * angle.cos().powi(2),
            Weight::Lever => lever(),
            Weight::Level => power() * angle.cos() + lever(),
        }
    }

    /// `G(x)` at `x = sqrt(b^2 + s^2)`, however small `s` is against the kink `b`, and what rounded places make of it.
    pub(super) fn transform_beyond(&self, kink: f64, s: f64) -> [f64; 2] {
        let x = kink.hypot(s);
        self.transformed(x, |at| ((kink - at) * (kink + at) + s * s).sqrt())
    }

    /// `int_0^{pi/2} h(x cos t) w(t) dt`.
    pub fn integral(&self, x: f64, weight: Weight) -> f64 {
        self.integrated(x, weight, |at| ((x - at) * (x + at)).sqrt())[0]
    }

    /// The same by the distances `sqrt(x^2 - b^2)` from the kinks, with what rounded places make of it.
    fn integrated(&self, x: f64, weight: Weight, leg: impl Fn(f64) -> f64) -> [f64; 2] {
        let mut cuts = vec![(FRAC_PI_2, 0.0)];
        let places = self.breaks.iter().chain(&self.joints);
        let inside = places.map(|&at| (at, leg(at))).filter(|(_, leg)| *leg > 0.0);
        cuts.extend(inside.map(|(at, leg)| (leg.atan2(at), at)));
        if !self.joints.is_empty() {
            cuts.sort_by(|one, two| one.1.total_cmp(&two.1));
            cuts.dedup();
        }
        cuts.push((0.0, x));
        let felt = Felt::new(self.remote);
        let value = |angle: f64, ends: [f64; 2]| {
            // Rounding must not pass a kink.
            let r = (x * angle.cos()).clamp(ends[0], ends[1]);
            felt.with((self.slope)(r), r, angle) * self.weight(weight, angle)
        };
        let pieces: Vec<([f64; 2], [f64; 2])> = (cuts.windows(2))
            .map(|pair| {
                let to = if pair[1].1 < x { pair[1].1.next_down() } else { x };
                let from = pair[0].1.next_up().min(to);
                ([pair[1].0, pair[0].0], [from, to])
            })
            .collect();
        let mut size = 0.0;
        let mut panels: VecDeque<Panel> = (pieces.iter().enumerate())
            .map(|(piece, &(turn, ends))| {
                let (mut whole, mut values) = (0.0, [0.0; ORDER]);
                for ((angle, weight), kept) in self.powers.nodes(turn).into_iter().zip(&mut values)
                {
                    *kept = value(angle, ends);
                    let term = weight * *kept;
                    whole += term;
                    size += term.abs();
                }
                // Between joints the slope is one polynomial, and nothing hides from the nodes.
                let is_told = !self.joints.is_empty() && self.powers.is_plain(turn);
                let tail =
                    if is_told { RULE.last(&values) * (turn[1] - turn[0]) } else { f64::INFINITY };
                let blur = felt.taken();
                Panel { piece, ends: turn, whole, blur, tail, depth: 0, before: f64::INFINITY }
            })
            .collect();
        let agreed = self.inexactness().max(OF_A_VALUE) * size + self.noise;
        // The first in, the first out: where there is an end to it, no place is left out.
        let (mut sum, mut blurred, mut halved) = (0.0, 0.0, 0);
        while let Some(panel) = panels.pop_front() {
            if panel.tail <= agreed {
                sum += panel.whole;
                blurred += panel.blur;
                continue;
            }
            let own = |angle: f64| value(angle, pieces[panel.piece].1);
            let halves = panel.halves(&self.powers, own, || felt.taken());
            let both = halves[0].whole + halves[1].whole;
            let blur = halves[0].blur + halves[1].blur;
            let agreed = agreed + blur;
            let difference = (both - panel.whole).abs();
            let is_noise =
                difference >= 0.5 * panel.before && difference <= NOISE * size + self.noise;
            let is_last = panel.depth >= DEEPEST || halved >= MOST_PANELS || (self.is_over)();
            let is_beside_axis = panel.ends[1] == FRAC_PI_2 && panel.depth >= BESIDE_AXIS;
            if difference <= agreed || is_noise || is_last || !difference.is_finite() {
                sum += both;
                blurred += blur;
            } else if is_beside_axis {
                let beside = self.beside_axis(x, FRAC_PI_2 - panel.ends[0], weight, agreed);
                sum += beside[0];
                blurred += beside[1];
            } else {
                halved += 1;
                panels.extend(halves.map(|half| Panel { before: difference, ..half }));
            }
        }
        [sum, blurred]
    }

    /// `int_0^turn h(x sin u) w(pi/2 - u) du`, where a power of `u` leaves no digits to halves of the interval: in `ln u` it is smooth.
    fn beside_axis(&self, x: f64, turn: f64, weight: Weight, agreed: f64) -> [f64; 2] {
        let felt = Felt::new(self.remote);
        let f = |z: f64| {
            let u = turn * (-z).exp();
            let r = x * u.sin();
            felt.with((self.slope)(r), r, u) * self.weight(weight, FRAC_PI_2 - u) * u
        };
        let [sum, blurred] = adaptive([0.0, FARTHEST], agreed, &f, &|| felt.taken());
        // What is left falls as a power.
        let last = f(FARTHEST);
        let power = (f(FARTHEST - 1.0) / last).ln();
        let rest = if power > 0.0 && last != 0.0 { last / power } else { 0.0 };
        [sum + rest, blurred]
    }
}

/// What rounded places make of an integral of slopes, `int eps (remote + r) |h'(r)| dt`, from the slopes at its nodes one after the other.
struct Felt {
    remote: f64,
    /// Slope, distance and variable of integration.
    last: Cell<Option<[f64; 3]>>,
    sum: Cell<f64>,
}

impl Felt {
    fn new(remote: f64) -> Self {
        Self { remote, last: Cell::new(None), sum: Cell::new(0.0) }
    }

    /// The slope at the next node.
    fn with(&self, slope: f64, r: f64, at: f64) -> f64 {
        if let Some([other, beside, from]) = self.last.replace(Some([slope, r, at])) {
            let share = f64::EPSILON * (self.remote + r.max(beside)) / (r - beside).abs();
            let own = (slope - other).abs() * (at - from).abs() * share.min(1.0);
            self.sum.set(self.sum.get() + if own.is_finite() { own } else { 0.0 });
        }
        slope
    }

    /// For the nodes so far; those to come are of another panel.
    fn taken(&self) -> f64 {
        self.last.set(None);
        self.sum.replace(0.0)
    }
}

/// Gauss's rule on halves of an interval until they agree but for rounding, `blur` of what was integrated last, or so many panels have been halved; with that rounding.
fn adaptive(
    ends: [f64; 2],
    agreed: f64,
    f: &dyn Fn(f64) -> f64,
    blur: &dyn Fn() -> f64,
) -> [f64; 2] {
    let of = |[from, to]: [f64; 2]| (integral(from, to, f), blur(), [from, to]);
    let mut panels = VecDeque::from([of(ends)]);
    let (mut sum, mut blurred, mut halved) = (0.0, 0.0, 0);
    while let Some((whole, _, [from, to])) = panels.pop_front() {
        let middle = 0.5 * (from + to);
        let halves = [of([from, middle]), of([middle, to])];
        let both = halves[0].0 + halves[1].0;
        let blur = halves[0].1 + halves[1].1;
        let difference = (both - whole).abs();
        if difference <= agreed + blur || halved >= MOST_PANELS || !difference.is_finite() {
            sum += both;
            blurred += blur;
        } else {
            halved += 1;
            panels.extend(halves);
        }
    }
    [sum, blurred]
}

/// An interval of the angle with its integral.
struct Panel {
    piece: usize,
    ends: [f64; 2],
    whole: f64,
    /// What rounded places make of it.
    blur: f64,
    /// What its last coefficients add up to, if they tell how well it is known; the rule for polynomials of twice their degree is closer.
    tail: f64,
    depth: u32,
    /// How much the integral of the panel twice as long changed.
    before: f64,
}

impl Panel {
    fn halves(&self, powers: &Powers, f: impl Fn(f64) -> f64, blur: impl Fn() -> f64) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|ends| Self {
            piece: self.piece,
            ends,
            whole: powers.integral(0, ends, &f),
            blur: blur(),
            tail: f64::INFINITY,
            depth: self.depth + 1,
            before: self.before,
        })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn homogeneous(slope: &dyn Fn(f64) -> f64, breaks: Vec<f64>) -> Shape<'_> {
        let powers = Powers::new(0.0).unwrap();
        let (joints, part) = (Vec::new(), Symmetry::Revolution);
        Shape {
            slope,
            breaks,
            joints,
            tolerance: 0.0,
            noise: 0.0,
            remote: 0.0,
            powers,
            part,
            is_over: &|| false,
        }
    }

    #[test]
    fn transforms_of_a_cone_with_a_flat_are_known() {
        // h = 1 beyond b: G = x acos(b/x), int h cos^2 = (t - sin t cos t)/2 .. with t = acos(b/x)
        let b = 0.25;
        let slope = |r: f64| if r < b { 0.0 } else { 1.0 };
        let shape = homogeneous(&slope, vec![b]);
        for x in [0.3f64, 0.7, 1.0] {
            let t = (b / x).acos();
            assert!((shape.transform(x) - x * t).abs() < 1e-15);
            let level = 0.5 * (t + t.sin() * t.cos());
            assert!((shape.integral(x, Weight::CosineSquared) - level).abs() < 1e-15);
            let free = 0.5 * (t - t.sin() * t.cos());
            assert!((shape.integral(x, Weight::SineSquared) - free).abs() < 1e-15);
        }
        for s in [1e-12f64, 1e-5, 0.3] {
            let exact = b.hypot(s) * s.atan2(b);
            assert!((shape.transform_beyond(b, s)[0] / exact - 1.0).abs() < 1e-14, "{s}");
        }
        // h = sqrt(r): int_0^{pi/2} sqrt(cos t) dt = (2 pi)^(3/2)/Gamma(1/4)^2
        let slope = f64::sqrt;
        let shape = homogeneous(&slope, Vec::new());
        let exact = (2.0 * PI).powf(1.5) / 3.625_609_908_221_908f64.powi(2);
        assert!((shape.integral(1.0, Weight::One) - exact).abs() < 1e-14);
    }
}
