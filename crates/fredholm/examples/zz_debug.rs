use fredholm::*;
use fredholm::kernel::*;
fn main() {
    let k = WeberSonine::new(1.0, 1.0, 0.45).unwrap();
    for x in [1e-10f64, 1e-40, 1e-80,1e-120] {
        for r in [0.5, 1e-1, 1e-3, 1e-8, 1e-16,1e-30] {
            let s = x / r;
            let p = k.pair(x, s, s - x);
            // W ~ C x^mu s^{-mu-1-2g}
            println!("x {x:e} s {s:e} W*s^(1+2g)*(s/x)^mu = {:e} A {:e}", p.value * s.powf(1.9) / r, p.factor * s.powf(1.9));
        }
        let d = k.split(x,x,0.0);
        println!("diag {:e} {:e}", d.factor*x.powf(1.0), d.rest*x.powf(1.9));
    }
    let op = SincOperator::new(&k, 80).unwrap();
    let f = |x: f64| k.mass_function(x) * (1.0 + x * x);
    let s = &op.solve(1.0, &[op.sample(f).unwrap()]).unwrap()[0];
    let pos: Vec<f64> = op.positions().collect();
    for i in 0..60 { println!("{i} {:e} {:e} {:e}", pos[i], s.potential()[i], s.values()[i]); }
}
