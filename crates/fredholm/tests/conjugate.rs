//! The conjugate of a slope against closed forms.

use std::f64::consts::PI;

use fredholm::inversion::{Angular, Conjugate};

/// `max(0, |x| - c)^n` on `-b .. b`.
struct Power {
    b: f64,
    c: f64,
    n: f64,
}

impl Power {
    fn place(&self, angle: f64) -> f64 {
        let folded = angle.min(PI - angle);
        (self.b - 2.0 * self.b * (0.5 * folded).sin().powi(2)).copysign(0.5 * PI - angle)
    }

    fn beyond(&self, angle: f64) -> f64 {
        (self.place(angle).abs() - self.c).max(0.0)
    }
}

impl Angular for Power {
    fn height(&self, angle: f64) -> f64 {
        self.beyond(angle).powf(self.n)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let slope = self.n * self.beyond(angle).powf(self.n - 1.0);
        Some(-self.b * angle.sin() * slope.copysign(self.place(angle)))
    }
}

#[test]
fn a_root_beside_a_flat_is_integrated() {
    // (2/pi) int_c^b x n (x - c)^(n - 1) / sqrt(b^2 - x^2) dx, by mpmath. The panel of the flat is long, that of the root beside it next to nothing.
    for (n, b, exact) in [
        (1.2, 0.93, 0.079_573_017_936_124_18),
        (1.2, 0.901, 0.007_293_040_207_205_176),
        (1.2, 0.90001, 0.000_290_251_965_055_277_2),
        (1.5, 0.93, 0.030_499_680_465_350_25),
        (1.5, 0.901, 0.001_006_579_912_436_621),
        (1.5, 0.90001, 1.006_234_083_720_232_5e-5),
    ] {
        let power = Power { b, c: 0.9, n };
        let bend = 2.0 * ((b - 0.9) / (2.0 * b)).sqrt().asin();
        let slopes = Conjugate::resolve(&power, [&[bend, PI - bend], &[]], [8, 1], 0.0);
        // Heights beyond the bend are rounded to this share.
        let tolerance = 1e-14 + f64::EPSILON / (b - 0.9);
        for angle in [0.0, PI] {
            let found = slopes.conjugate(angle);
            assert!((found / exact - 1.0).abs() < tolerance, "{n} {b} {angle}: {found:e}");
        }
    }
}

/// A base on `-1 .. 1` with the slope `x + n |x - b|^(n - 1)`, the second times a factor on either side of the bend `b`, which is at this angle.
struct Bent {
    bend: f64,
    sides: [f64; 2],
    n: f64,
}

impl Bent {
    /// `x - b`.
    fn beyond(&self, angle: f64) -> f64 {
        -2.0 * (0.5 * (angle + self.bend)).sin() * (0.5 * (angle - self.bend)).sin()
    }

    fn side(&self, beyond: f64) -> f64 {
        self.sides[usize::from(beyond > 0.0)]
    }
}

impl Angular for Bent {
    fn height(&self, angle: f64) -> f64 {
        let beyond = self.beyond(angle);
        0.5 * angle.cos().powi(2) + self.side(beyond) * beyond.abs().powf(self.n).copysign(beyond)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let beyond = self.beyond(angle);
        let power = self.side(beyond) * self.n * beyond.abs().powf(self.n - 1.0);
        Some(-angle.sin() * (angle.cos() + power))
    }
}

#[test]
fn beside_a_bend_with_a_power_it_is_as_exact_as_stated() {
    // (1/pi) p.v. int sqrt(1 - x^2) f'(x)/(y - x) dx at y = cos(1.2 + offset), of the power by mpmath; of x it is y^2 - 1/2. On one side of a bend panels are long, on the other next to nothing.
    const OFFSETS: [f64; 6] = [0.0, 1e-13, -3e-12, 1e-9, -1e-9, 0.1];
    for (sides, n, exact) in [
        (
            [0.0, 1.0],
            1.1,
            [
                -2.985038346085516,
                -2.81992284042029,
                -2.7643871378293188,
                -2.570286949471855,
                -2.590586324370218,
                -0.44462003880495593,
            ],
        ),
        (
            [0.0, 1.0],
            1.5,
            [
                -0.5891723525444797,
                -0.5891719257268989,
                -0.589172352540142,
                -0.5891296722178265,
                -0.5891723510985749,
                -0.28495968375118663,
            ],
        ),
        (
            [0.0, 1.0],
            1.8,
            [
                -0.3548120632422005,
                -0.35481206313509506,
                -0.35481206455348746,
                -0.354811896034385,
                -0.3548121979390427,
                -0.2134796340578076,
            ],
        ),
        (
            [-1.0, 1.0],
            1.1,
            [
                -6.341772364813746,
                -6.019622681544141,
                -5.889114746347072,
                -5.53256894884715,
                -5.5325689441389985,
                -1.2860748275499607,
            ],
        ),
        (
            [-1.0, 1.0],
            1.5,
            [
                -1.585878181584672,
                -1.5858777547670335,
                -1.5858758438050986,
                -1.5858355006827682,
                -1.585835498941501,
                -1.2132104633433922,
            ],
        ),
        (
            [-1.0, 1.0],
            1.8,
            [
                -1.143274735573304,
                -1.143274735552863,
                -1.1432747352594534,
                -1.1432747037815656,
                -1.143274702343096,
                -1.1146572387323963,
            ],
        ),
        (
            [1.0, 1.0],
            1.1,
            [
                0.3716956726427143,
                0.3797770007035617,
                0.36034047068843506,
                0.3919950499034394,
                0.3513962953985623,
                0.3968347499400489,
            ],
        ),
        (
            [1.0, 1.0],
            1.5,
            [
                0.4075334764957125,
                0.40753390331323575,
                0.40753113872481467,
                0.4075761562471151,
                0.4074907967443514,
                0.6432910958410191,
            ],
        ),
        (
            [1.0, 1.0],
            1.8,
            [
                0.433650609088903,
                0.43365060928267285,
                0.43365060615247847,
                0.43365091171279563,
                0.43365030646501074,
                0.6876979706167811,
            ],
        ),
    ] {
        let bent = Bent { bend: 1.2, sides, n };
        let [bend, joint] = [[&[1.2][..], &[]], [&[], &[1.2]]]
            .map(|places| Conjugate::resolve(&bent, places, [8, 1], 0.0));
        for (offset, exact) in OFFSETS.into_iter().zip(exact) {
            assert_eq!(joint.conjugate(1.2 + offset), bend.conjugate(1.2 + offset));
            let exact = exact + (1.2 + offset).cos().powi(2) - 0.5;
            let off = (bend.conjugate(1.2 + offset) - exact).abs();
            // An angle is rounded, and the conjugate changes for that.
            let rounded =
                if offset == 0.0 || offset > 0.01 { 0.0 } else { f64::EPSILON / offset.abs() };
            let blurred = 10.0 * rounded * offset.abs().powf(n - 1.0);
            let stated = bend.error() + blurred;
            println!("{sides:?} {n} {offset:e}: off {off:.1e}, stated {stated:.1e}");
            assert!(off <= stated, "{sides:?} {n} {offset:e}: off {off:e}, stated {stated:e}");
            assert!(stated < 1e-2 * 1e-12f64.powf(n - 1.0) + 1e-13 + blurred, "{n}: {stated:e}");
        }
    }
}

/// The flat side is one panel then, up to the end.
#[test]
fn a_bend_with_a_power_may_be_the_first_from_an_end() {
    // (1/pi) int sqrt(1 - x^2) n (b - x)^(n - 2) dx below b = cos(0.2), by mpmath.
    for (n, exact) in
        [(1.1, 1.3899135739602797), (1.5, 0.929618850689914), (1.8, 0.9523502236521822)]
    {
        for (bend, sides, side) in [(0.2, [1.0, 0.0], 1.0), (PI - 0.2, [0.0, 1.0], -1.0)] {
            let slopes = Conjugate::resolve(&Bent { bend, sides, n }, [&[bend], &[]], [8, 1], 0.0);
            let off = (slopes.conjugate(bend) - side * exact - bend.cos().powi(2) + 0.5).abs();
            println!("{n} {bend}: off {off:.1e}, stated {:.1e}", slopes.error());
            assert!(off <= slopes.error(), "{n} {bend}: {off:e} {:e}", slopes.error());
        }
    }
}
