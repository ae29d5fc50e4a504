use shtaerman::*;
fn main() {
    let cases: Vec<(&str, &str, f64, Option<f64>)> = vec![
        ("parabola", "8*xi^2", 0.0, None),
        ("wedge", "2*abs(xi)", 0.1, None),
        ("flat", "0*xi", 0.2, None),
        ("ecc", "0*xi", 0.7, None),
        ("pair", "0.1*xi^2", 0.05, Some(0.3)),
    ];
    for (name, f, m, gap) in cases {
        println!("## {name}");
        for k in 0..24 {
            let theta = 10f64.powf(5.4 + 0.3 * k as f64);
            let t = std::time::Instant::now();
            let geometry = gap.map_or(Geometry::Plane, |g| Geometry::Pair { inner_half_gap: g });
            // E* = 1 (nu=0), a = 1: theta0 = 2/(pi chi); f in metres so that f0 = f/chi
            let chi = 2.0 / (std::f64::consts::PI * theta);
            let frame =
                Frame::physical_in(geometry, Elastic::new(1.0, 0.0).unwrap(), chi, 1.0, None)
                    .unwrap();
            let frame_s =
                Frame::physical_in(geometry, Elastic::new(1.0, 0.0).unwrap(), 0.0, 1.0, None)
                    .unwrap();
            let profile = Profile::expression(&format!("{}", f.replace("xi", "x"))).unwrap();
            let load = Load::new(Vertical::Force(1.0), Rotational::Moment(m)).unwrap();
            let c = Problem::new(frame, profile.clone(), load, Solver::default()).unwrap().solve();
            let s =
                Problem::new(frame_s, profile, load, Solver::default()).unwrap().solve().unwrap();
            match c {
                Ok(c) => {
                    let x = s.edges().last().map(|e| 0.3 * e[0] + 0.7 * e[1]).unwrap();
                    let d = |a: f64, b: f64| (a - b) * theta;
                    println!(
                        "{theta:9.3e} n {} d {:.10} t {:.8} eL {:.8} eR {:.8} p {:.8} edge {:.9} | rel {:.1e} acc {:?} edge {:?} {:?}",
                        c.method().n,
                        d(c.settlement(), s.settlement()),
                        d(c.tilt(), s.tilt()),
                        d(c.edges().last().unwrap()[0], s.edges().last().unwrap()[0]),
                        d(c.edges().last().unwrap()[1], s.edges().last().unwrap()[1]),
                        d(c.pressure(x).unwrap(), s.pressure(x).unwrap()),
                        c.peak_pressure().0,
                        c.relative_error(),
                        c.accuracy().map(|a| (a.pressure, a.settlement / theta, a.tilt / theta)),
                        c.edge_error0(),
                        t.elapsed()
                    );
                }
                Err(e) => println!("{theta:e} {e}"),
            }
        }
    }
}
