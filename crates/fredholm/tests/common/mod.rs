//! What several tests share.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]
#![allow(unreachable_pub, reason = "a module of tests")]

use fredholm::Interval;
use fredholm::kernel::{Kernel, Singularity, Split};

/// Runs all cases at once: a test that is alone in the end leaves no core idle. What panics in a case is the panic of the test.
pub fn together<T: Send>(cases: impl IntoIterator<Item = T>, run: impl Fn(T) + Sync) {
    let run = &run;
    std::thread::scope(|scope| {
        for case in cases {
            scope.spawn(move || run(case));
        }
    });
}

/// `exp(-(x - s)^2) - ln|x - s|` on `(-1, 1)`: a kernel of a user's own.
pub struct Layered;

impl Kernel for Layered {
    fn interval(&self) -> Interval {
        Interval::unit()
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, _x: f64, _s: f64, distance: f64) -> Split {
        Split { factor: -1.0, rest: (-distance * distance).exp() }
    }

    fn is_even(&self) -> bool {
        true
    }
}

/// Another kernel with its parity kept secret, or on a shifted interval.
pub struct Disguised<K> {
    pub kernel: K,
    pub shift: f64,
    pub even: bool,
}

impl<K: Kernel> Kernel for Disguised<K> {
    fn interval(&self) -> Interval {
        let interval = self.kernel.interval();
        Interval::new(interval.left() + self.shift, interval.right() + self.shift).unwrap()
    }

    fn singularity(&self) -> Singularity {
        self.kernel.singularity()
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        self.kernel.split(x - self.shift, s - self.shift, distance)
    }

    fn is_even(&self) -> bool {
        self.even
    }
}

/// A right-hand side of the reference files by its name.
pub fn right_hand_side(name: &str) -> fn(f64) -> f64 {
    match name {
        "1" => |_| 1.0,
        "x" => |x| x,
        "x2" => |x| x * x,
        "exp" => f64::exp,
        "abs" => f64::abs,
        other => panic!("unknown right-hand side {other}"),
    }
}

/// One line of a reference file: `int phi`, `int x phi`, `phi(-1)`, `phi(0.3)`, `phi(1)`.
pub struct Reference {
    pub kernel: String,
    pub parameter: f64,
    pub name: String,
    pub values: [f64; 5],
}

/// The lines of a reference file with the kernel named on each line, or on none.
pub fn references(text: &str, default_kernel: &str) -> Vec<Reference> {
    text.lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| {
            let mut fields: Vec<&str> = line.split_whitespace().collect();
            if fields.len() == 7 {
                fields.insert(0, default_kernel);
            }
            let number = |k: usize| fields[k].parse::<f64>().unwrap();
            Reference {
                kernel: fields[0].to_owned(),
                parameter: number(1),
                name: fields[2].to_owned(),
                values: std::array::from_fn(|k| number(k + 3)),
            }
        })
        .collect()
}
