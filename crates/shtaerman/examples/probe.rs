use shtaerman::*;
use std::time::Instant;
fn run(
    name: &str,
    g: Geometry,
    theta: f64,
    kappa: f64,
    f: &str,
    v: Vertical,
    r: Rotational,
    full: bool,
) -> Option<UnilateralContact> {
    let frame = Frame::dimensionless_in(g, theta, kappa).unwrap();
    let p = match Problem::new(
        frame,
        Profile::expression(f).unwrap(),
        Load::new(v, r).unwrap(),
        Solver::default(),
    ) {
        Ok(p) => p,
        Err(e) => {
            println!("{name}: problem {e}");
            return None;
        }
    };
    let t = Instant::now();
    let c = if full { p.solve_full_contact() } else { p.solve_unilateral() };
    let t = t.elapsed();
    match c {
        Ok(c) => {
            println!(
                "{name}: {t:?} edges {:?} d {:.15} al {:.15} P {:.15} M {:.15} p(0) {:.15} p(.5) {:.15} p(1) {:.15} nodes {} err {:.1e} {:?}",
                c.edges0(),
                c.settlement0(),
                c.tilt0(),
                c.force0(),
                c.moment0(),
                c.pressure0(0.0),
                c.pressure0(0.5),
                c.pressure0(1.0),
                c.nodes(),
                c.relative_error(),
                c.complementarity()
            );
            Some(c)
        }
        Err(e) => {
            println!("{name}: {t:?} ERR {e}");
            None
        }
    }
}
fn main() {
    use Rotational::*;
    use Vertical::*;
    let pair = Geometry::Pair { inner_half_gap: 0.4 };
    let g = Geometry::Plane;
    for theta in [1e-9, 1.0, 100.0, 1e4] {
        println!("theta {theta}");
        for kappa in [0.999999, 0.9, 0.5, 0.2, 0.1, 0.03] {
            println!("kappa {kappa}");
            run("plane flat", g, theta, kappa, "0", Force(1.0), Moment(0.0), false);
            run("plane tip", g, theta, kappa, "0", Force(1.0), Moment(0.6), false);
            run("plane parabola", g, theta, kappa, "10*xi^2", Force(0.2), Moment(0.02), false);
            run(
                "plane parabola small",
                g,
                theta,
                kappa,
                "10*xi^2",
                Force(0.0002),
                Moment(0.00002),
                false,
            );
            run("plane waves", g, theta, kappa, "3*cos(14*xi)", Force(0.2), Moment(0.02), false);
            run("plane settle", g, theta, kappa, "10*xi^2", Settlement(0.2), Tilt(0.02), false);
            run("pair tipped", pair, theta, kappa, "0", Force(1.0), Moment(0.85), false);
            run("pair full", pair, theta, kappa, "0", Force(1.0), Moment(0.15), true);
            run(
                "row parabola",
                Geometry::Periodic { period: 3.0 },
                theta,
                kappa,
                "xi^2*10",
                Force(0.1),
                Moment(0.0),
                false,
            );
            run("disk flat", Geometry::Circular, theta, kappa, "0", Force(1.0), Moment(0.0), false);
            run(
                "disk sphere",
                Geometry::Circular,
                theta,
                kappa,
                "50*xi^2",
                Force(0.5),
                Moment(0.0),
                false,
            );
            run(
                "disk ring",
                Geometry::Circular,
                theta,
                kappa,
                "100*(abs(xi)-0.5)^2",
                Force(0.5),
                Moment(0.0),
                false,
            );
        }
    }
}
