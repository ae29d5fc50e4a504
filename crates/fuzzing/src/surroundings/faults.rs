//! Surroundings in which nothing goes well.

use std::ffi::OsString;
use std::process::Command;
use std::sync::OnceLock;

use super::program::{Files, Folder, told};
use crate::check::Outcome;
use crate::{Random, check};

const PROBLEM: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"
[punch]
half_width = "5 mm"
profile = "x^2 / (2*20)"
[load]
force = "0.8 MN/m"
moment = "100 N"
"#;

/// The command, of which surroundings are a part: `$0` is the program.
const SOLVE: &str =
    r#""$0" solve p.toml --format json --output out.json --plot out.svg --title contact"#;

/// What comes of surroundings.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    /// The same bytes as elsewhere.
    Same,
    /// This exit code, and not one file more or less.
    Refused(i32),
    /// One of both.
    Either(i32),
}

/// Lines of the shell.
const FAULTS: &[(&str, End)] = &[
    ("exec env -i FUZZING_RUNS_AS_SHTAERMAN=1 SOLVE", End::Same),
    ("unset HOME USER PATH TMPDIR; exec SOLVE", End::Same),
    ("export HOME=/nowhere TMPDIR=/nowhere; exec SOLVE", End::Same),
    ("export LC_ALL=tr_TR.UTF-8 LANG=tr_TR.UTF-8; exec SOLVE", End::Same),
    ("export LC_ALL=de_DE.ISO-8859-1 LC_NUMERIC=de_DE; exec SOLVE", End::Same),
    ("export LC_ALL=\u{1b}[31m TERM=dumb COLUMNS=1 NO_COLOR=; exec SOLVE", End::Same),
    ("export RUST_BACKTRACE=full RUST_MIN_STACK=1 RUST_LOG=trace; exec SOLVE", End::Same),
    // One processor, and a gigabyte.
    ("ulimit -v 1000000; exec taskset -c 0 SOLVE", End::Same),
    ("ulimit -v 1000000; ulimit -s 1024; exec SOLVE", End::Same),
    ("umask 777; exec SOLVE", End::Same),
    ("ulimit -n 12; exec SOLVE", End::Same),
    ("exec SOLVE <&- >&- 2>&-", End::Same),
    ("exec SOLVE >/dev/full 2>/dev/full", End::Same),
    ("exec SOLVE --time-limit '1 h'", End::Same),
    // What was started so that it ignores signals (`nohup`) does.
    (
        "trap '' INT HUP QUIT; (for i in 1 2 3 4 5 6 7 8 9; do kill -INT $$; kill -HUP $$; sleep 0.003; done) & exec SOLVE",
        End::Same,
    ),
    // Too little memory even to begin is the end of a process by the system, not seen here.
    ("ulimit -v 150000; exec SOLVE", End::Either(3)),
    ("ulimit -f 1; exec SOLVE", End::Refused(1)),
    ("ulimit -f 0; exec SOLVE", End::Refused(1)),
    ("exec \"$0\" solve p.toml >/dev/full", End::Refused(1)),
    ("exec \"$0\" solve p.toml --output /dev/full", End::Refused(1)),
    ("exec \"$0\" solve p.toml --output /proc/out.txt", End::Refused(2)),
    ("exec \"$0\" solve p.toml --output nowhere/out.txt", End::Refused(2)),
    ("exec \"$0\" solve p.toml --output p.toml/out.txt", End::Refused(2)),
    ("exec \"$0\" solve p.toml --output .", End::Refused(2)),
    ("exec \"$0\" solve p.toml --output p.toml", End::Refused(2)),
    ("exec \"$0\" solve - <&-", End::Refused(2)),
    ("exec \"$0\" solve - </dev/full", End::Refused(2)),
    ("exec \"$0\" solve .", End::Refused(2)),
    ("exec \"$0\" solve /proc/self/mem", End::Refused(2)),
    // Who reads a pipe may leave: that is no error.
    (
        "{ { \"$0\" regularity --theta0 1 --rows 100000; echo $? >&3; } | head -c 10 >/dev/null; } 3>&1 | grep -qx 0",
        End::Refused(0),
    ),
    // The end of the processor time ends a process as a signal does.
    (
        "ulimit -S -t 1; exec \"$0\" stress p.toml --grid 2000x2000 --format csv --output out.csv",
        End::Refused(130),
    ),
];

/// Names of files; the system takes them, and so does the program.
const NAMES: &[&[u8]] = &[
    b"a b.toml",
    b"-p.toml",
    b"--help",
    b"line\nbreak.toml",
    b"\x1b[31mred.toml",
    "пуансон.toml".as_bytes(),
    "\u{202e}lmot.p".as_bytes(),
    b"\xff\xfe.toml",
    b"p",
    b"$(echo).toml",
    b"a'b\"c\\d.toml",
    &[b'x'; 255],
];

/// The results of a run that nothing disturbs.
fn undisturbed() -> Result<&'static Files, String> {
    static FILES: OnceLock<Result<Files, String>> = OnceLock::new();
    let run = || {
        let folder = prepared()?;
        let status = folder.shell(&format!("exec {SOLVE}"))?.status().map_err(told)?;
        check::holds(status.success(), "an undisturbed run failed", &status.to_string())?;
        folder.files()
    };
    FILES.get_or_init(run).as_ref().map_err(Clone::clone)
}

fn prepared() -> Result<Folder, String> {
    let folder = Folder::new()?;
    folder.write("p.toml", PROBLEM)?;
    Ok(folder)
}

/// One run in surroundings, or of a file with a name, that are chosen at random.
pub(crate) fn case(random: &mut Random) -> Result<Outcome, String> {
    let index = random.below(FAULTS.len() + NAMES.len());
    match FAULTS.get(index) {
        Some((line, end)) => disturbed(line, *end),
        None => named(NAMES[index - FAULTS.len()]),
    }
}

fn disturbed(line: &str, end: End) -> Result<Outcome, String> {
    let (done, folder) = (undisturbed()?, prepared()?);
    let before = folder.files()?;
    let status = folder.shell(&line.replace("SOLVE", SOLVE))?.status().map_err(told)?;
    let after = folder.files()?;
    let seen = format!("{line}: {status}, {:?}", after.keys().collect::<Vec<_>>());
    let is_same = status.success() && after == *done;
    let is_refused = |code| status.code() == Some(code) && after == before;
    let (holds, what) = match end {
        End::Same => (is_same, "not the same files as elsewhere"),
        End::Refused(code) => (is_refused(code), "another end, or something left"),
        End::Either(code) => {
            (status.success() || is_refused(code), "another end, or something left")
        }
    };
    check::holds(holds, what, &seen)?;
    Ok(if status.success() { Outcome::Accepted } else { Outcome::Refused })
}

/// A problem file of this name, whose answer has the bytes of any other.
#[cfg(unix)]
fn named(name: &[u8]) -> Result<Outcome, String> {
    use std::os::unix::ffi::OsStringExt;
    let name = OsString::from_vec(name.to_vec());
    let folder = Folder::new()?;
    folder.write(&name, PROBLEM)?;
    let mut command: Command = folder.command(&[
        "solve", "--format", "json", "--output", "out.json", "--plot", "out.svg", "--title",
        "contact",
    ])?;
    let status = command.arg("--").arg(&name).status().map_err(told)?;
    let after = folder.files()?;
    let done = undisturbed()?;
    let is_same = |file: &str| {
        after.get(file.as_ref() as &std::ffi::OsStr) == done.get(file.as_ref() as &std::ffi::OsStr)
    };
    let seen = format!("{}: {status}", name.display());
    let holds = status.success() && is_same("out.json") && is_same("out.svg") && after.len() == 3;
    check::holds(holds, "not the same files as elsewhere", &seen)?;
    Ok(Outcome::Accepted)
}

#[cfg(not(unix))]
fn named(_name: &[u8]) -> Result<Outcome, String> {
    Ok(Outcome::Accepted)
}
