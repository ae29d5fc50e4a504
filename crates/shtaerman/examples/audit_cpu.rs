//! Temporary: processor time of solve and audit, best of N.
fn cpu() -> u64 {
    std::fs::read_to_string("/proc/thread-self/schedstat")
        .unwrap()
        .split_whitespace()
        .next()
        .unwrap()
        .parse()
        .unwrap()
}
fn main() {
    let mut args = std::env::args().skip(1);
    let n: usize = args.next().unwrap().parse().unwrap();
    for path in args {
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let geometry = ["circular", "pair", "periodic"]
            .into_iter()
            .find(|g| text.contains(&format!("\"{g}\"")))
            .unwrap_or("plane");
        let geometry =
            if geometry == "periodic" && text.contains("half_width") { "row" } else { geometry };
        let Ok(problem) = shtaerman::file::open(std::path::Path::new(&path), &[]) else {
            println!("{path} unread");
            continue;
        };
        let start = cpu();
        let Ok(contact) = problem.solve() else {
            println!("{path} {geometry} refused");
            continue;
        };
        let solved = cpu() - start;
        let (mut wall, mut count) = (f64::INFINITY, 0);
        let begin = cpu();
        let mut found;
        loop {
            let start = std::time::Instant::now();
            found = Some(contact.audit());
            wall = wall.min(start.elapsed().as_secs_f64() * 1e9);
            count += 1;
            let total = cpu() - begin;
            if count >= n && (total > 100_000_000 || count >= 30 * n) {
                break;
            }
        }
        let mean = (cpu() - begin) as f64 / f64::from(count as u32);
        let best = if mean > 0.0 { mean.min(wall) } else { wall };
        let law = if text.contains("exponent = ") && text.contains("displacement") {
            "bent"
        } else {
            "linear"
        };
        let ground = if text.contains("grading") { "graded" } else { "plain" };
        match found.unwrap() {
            Ok(a) => println!(
                "{path} {geometry} {ground} {law} solve {:.3} audit {:.3} pressure {:e} mean {:e} residual {:e} panels {} windows {} kind {}",
                solved as f64 * 1e-6,
                best * 1e-6,
                a.pressure() / contact.dimensionless().peak_pressure().abs(),
                a.mean_square,
                a.residual,
                a.panels,
                a.windows,
                a.kind.name()
            ),
            Err(e) => println!(
                "{path} {geometry} {ground} {law} solve {:.3} none {:.3} {}",
                solved as f64 * 1e-6,
                best * 1e-6,
                e
            ),
        }
    }
}
