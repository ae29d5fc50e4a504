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
                "{name}: {t:?} edges {:?} d {:.15} al {:.15} P {:.15} M {:.15} p(0) {:.15} p(.5) {:.15} p(1) {:.15} nodes {} err {:.1e} {:?} {:?}",
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
                c.complementarity(),
                c.stiffness0()
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
    let g = Geometry::Periodic { period: 2.0 };
    for theta in [1e-6, 1.0, 100.0, 1e4] {
        for kappa in [1.0, 0.5, 0.2] {
            println!("theta {theta} kappa {kappa}");
            run("wave full", g, theta, kappa, "0.1*cos(pi*xi)", Force(1.0), Moment(0.0), false);
            run("wave bil", g, theta, kappa, "0.1*cos(pi*xi)", Force(1.0), Moment(0.0), true);
            run(
                "wave partial 0",
                g,
                theta,
                kappa,
                "20*(1-cos(pi*xi))",
                Force(1.0),
                Tilt(0.0),
                false,
            );
            run(
                "wave partial 1",
                g,
                theta,
                kappa,
                "20*(1+cos(pi*xi))",
                Force(1.0),
                Moment(0.0),
                false,
            );
            run(
                "wave partial s",
                g,
                theta,
                kappa,
                "20*(1+sin(pi*xi+1))",
                Settlement(3.0),
                Moment(0.0),
                false,
            );
            run(
                "wave two",
                g,
                theta,
                kappa,
                "20*(1+sin(pi*xi+1))+12*cos(3*pi*xi)",
                Force(1.0),
                Moment(0.0),
                false,
            );
            run("kink", g, theta, kappa, "0.01*abs(xi)", Force(1.0), Moment(0.0), false);
            run(
                "disk flat M",
                Geometry::Circular,
                theta,
                kappa,
                "0",
                Force(1.0),
                Moment(0.1),
                false,
            );
            run(
                "disk flat M large",
                Geometry::Circular,
                theta,
                kappa,
                "0",
                Force(1.0),
                Moment(0.5),
                false,
            );
            run(
                "disk flat tilt bil",
                Geometry::Circular,
                theta,
                kappa,
                "0",
                Settlement(1.0),
                Tilt(0.5),
                true,
            );
            run("disk odd", Geometry::Circular, theta, kappa, "xi", Force(1.0), Moment(0.0), false);
        }
    }
    // golden: h = 0.01, L = 1, E*=1, pbar = 0.3 p*, p* = pi h/L; chi E*/L = 0.1
    let body = Elastic::new(1.0, 0.0).unwrap();
    let frame =
        Frame::physical_in(Geometry::Periodic { period: 1.0 }, body, 0.1, 0.5, None).unwrap();
    let pstar = std::f64::consts::PI * 0.01;
    for (prof, at) in [("0.01*(1-cos(2*pi*x))/1", 0.0), ("0.01*(1+cos(2*pi*x))", 0.5)] {
        let p = Problem::new(
            frame.clone(),
            Profile::expression(prof).unwrap(),
            Load::new(Force(0.3 * pstar), Moment(0.0)).unwrap(),
            Solver::default(),
        )
        .unwrap();
        let t = Instant::now();
        let c = p.solve_unilateral().unwrap();
        println!(
            "golden {:?} {:.10} edges {:?}",
            t.elapsed(),
            c.pressure(at).unwrap() / pstar,
            c.edges()
        );
    }
}
