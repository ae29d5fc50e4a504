//! A signal at a random moment: while the program starts, computes, writes, or is done.

use std::ffi::OsString;
use std::process::{Command, ExitStatus};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::program::{Files, Folder, told};
use crate::check::Outcome;
use crate::{Random, check};

/// What the program answers; `KILL` it cannot answer, and only what is in its place already counts.
const SIGNALS: &[&str] = &["INT", "TERM", "HUP", "QUIT", "XCPU", "USR1", "ALRM", "KILL"];

/// Exit code of an interrupted run.
const INTERRUPTED: i32 = 130;

/// How the names of temporary files begin.
const TEMPORARY: &str = ".shtaerman-";

/// A command that takes its time, and the files that it writes.
#[derive(Debug)]
struct Work {
    arguments: &'static [&'static str],
    outputs: &'static [&'static str],
}

/// Most of the time goes into solving in the first, into writing in the second.
const WORKS: [Work; 2] = [
    Work {
        arguments: &[
            "solve", "p.toml", "--format", "json", "--output", "out.json", "--plot", "out.svg",
        ],
        outputs: &["out.json", "out.svg"],
    },
    Work {
        arguments: &[
            "regularity",
            "--theta0",
            "1",
            "--rows",
            "100000",
            "--format",
            "csv",
            "--output",
            "out.csv",
        ],
        outputs: &["out.csv"],
    },
];

/// Many small zones.
const PROBLEM: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"
[punch]
half_width = "5 mm"
profile = "x^2 / (2*20) + 2e-7*cos(40*pi*xi)"
[load]
force = "0.2 MN/m"
moment = "100 N"
"#;

/// How a run ends that is left alone.
#[derive(Debug, Clone)]
struct Whole {
    took: Duration,
    files: Files,
}

/// Runs a command to its end, once for each of them; the same bytes are asked of every other run.
fn whole(index: usize) -> Result<Whole, String> {
    static WHOLE: Mutex<[Option<Whole>; WORKS.len()]> = Mutex::new([None, None]);
    let mut known = WHOLE.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(whole) = &known[index] {
        return Ok(whole.clone());
    }
    let folder = prepared(false, &WORKS[index])?;
    let begun = Instant::now();
    let status = folder.command(WORKS[index].arguments)?.status().map_err(told)?;
    check::holds(status.success(), "a run that was left alone failed", &format!("{status}"))?;
    let whole = Whole { took: begun.elapsed(), files: folder.files()? };
    known[index] = Some(whole.clone());
    Ok(whole)
}

/// The folder before a run, with results of an older one or without.
fn prepared(is_old: bool, work: &Work) -> Result<Folder, String> {
    let folder = Folder::new()?;
    folder.write("p.toml", PROBLEM)?;
    if is_old {
        work.outputs.iter().try_for_each(|name| folder.write(name, "old\n"))?;
    }
    Ok(folder)
}

/// Sends one signal to one run. [`Outcome::Accepted`] is a run that came to its end, [`Outcome::Refused`] one that the signal ended.
pub(crate) fn case(random: &mut Random) -> Result<Outcome, String> {
    let index = random.below(WORKS.len());
    let work = &WORKS[index];
    let whole = whole(index)?;
    let signal = random.of(SIGNALS);
    // A little beyond the end, so that the last moments are met as well.
    let delay = whole.took.mul_f64(random.between(0.0, 1.1));
    let folder = prepared(random.one_in(2), work)?;
    let before = folder.files()?;
    let mut child = folder.command(work.arguments)?.spawn().map_err(told)?;
    std::thread::sleep(delay);
    // It fails where the run is over and waited for, which it is not.
    let sent = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status();
    let status = child.wait().map_err(told)?;
    sent.map_err(told)?;
    let after = folder.files()?;
    let seen =
        format!("{signal} after {delay:?} of {:?}: {status}, {:?}", whole.took, names(&after));
    ended(signal, status, (&before, &after, &whole.files), &seen)
}

/// What must hold when a run is over.
fn ended(
    signal: &str,
    status: ExitStatus,
    (before, after, done): (&Files, &Files, &Files),
    seen: &str,
) -> Result<Outcome, String> {
    let is_killed = signal == "KILL";
    let is_temporary = |name: &OsString| name.to_string_lossy().starts_with(TEMPORARY);
    for (name, content) in after.iter().filter(|(name, _)| !(is_killed && is_temporary(name))) {
        let is_whole = [before, done].iter().any(|files| files.get(name) == Some(content));
        check::holds(is_whole, &format!("{} is left, or half", name.display()), seen)?;
    }
    // Several results are put in their places together, which only a signal that cannot be answered prevents.
    let is_one = is_killed || after == before || after == done;
    check::holds(is_one, "some results are new and some are old", seen)?;
    if status.success() {
        check::holds(after == done, "a run that succeeded left something else", seen)?;
        return Ok(Outcome::Accepted);
    }
    // The first moments belong to the system: without a handler the signal itself ends the process.
    let is_early = status.code().is_none() && after == before;
    let is_answered = status.code() == Some(INTERRUPTED) || is_killed || is_early;
    check::holds(is_answered, "another end", seen)?;
    Ok(Outcome::Refused)
}

fn names(files: &Files) -> Vec<&OsString> {
    files.keys().collect()
}
