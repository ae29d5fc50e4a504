//! Many threads at once, and other builds: the same answers.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use shtaerman::{Answer, Contact, Error, PressureCurve, file};

use crate::check::{self, Outcome};
use crate::{Random, files};

/// Points of the pressure curve, as the program has them by default.
const POINTS: usize = 201;
/// What takes longer alone is not solved ten times more.
const LONGEST: Duration = Duration::from_secs(1);
/// The program that is compared with, such as one of another build.
const OTHER: &str = "SHTAERMAN_OTHER";

/// The program that is compared with.
pub(super) fn other() -> Option<PathBuf> {
    std::env::var_os(OTHER).map(PathBuf::from)
}

fn solved(text: &str) -> Result<Contact, Error> {
    file::parse(text, "made.toml")?.solve()?.audited()
}

fn answer(contact: &Contact) -> Result<Value, String> {
    let curve = PressureCurve::along(contact, POINTS).map_err(|error| error.to_string())?;
    serde_json::to_value(Answer::new(contact, curve)).map_err(|error| error.to_string())
}

/// The answer, or the message, as one text.
fn said(text: &str) -> Result<String, String> {
    match solved(text) {
        Ok(contact) => Ok(answer(&contact)?.to_string()),
        Err(error) => Ok(error.to_string()),
    }
}

/// Solves a file that was made alone, on two threads at once, and on seven: the same bytes.
pub(super) fn threads(random: &mut Random) -> Result<Outcome, String> {
    let text = files::problem(random);
    let begun = Instant::now();
    let alone = said(&text)?;
    if begun.elapsed() > LONGEST {
        return Ok(Outcome::Refused);
    }
    for count in [2, 7] {
        let all: Vec<_> = std::thread::scope(|scope| {
            let started: Vec<_> = (0..count).map(|_| scope.spawn(|| said(&text))).collect();
            started.into_iter().map(std::thread::ScopedJoinHandle::join).collect()
        });
        for found in all {
            let found = found.map_err(|panic| check::panicked(&*panic))??;
            check::holds(found == alone, &format!("{count} threads differ"), &text)?;
        }
    }
    Ok(Outcome::Accepted)
}

/// Solves a file that was made here and by the other program: they agree within the sum of the errors that they state.
pub(super) fn builds(random: &mut Random) -> Result<Outcome, String> {
    let other = other().ok_or_else(|| format!("{OTHER} names no program to compare with"))?;
    let text = files::problem(random);
    let here = match solved(&text) {
        Ok(contact) => answer(&contact)?,
        Err(error) => return check::refusal(&error.to_string(), &text),
    };
    let mut command = Command::new(other);
    command.args(["solve", "-", "--format", "json"]);
    let piped = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = piped.spawn().map_err(|error| error.to_string())?;
    // Where it reads nothing, it answers nothing.
    let _ = child.stdin.take().map(|mut input| input.write_all(text.as_bytes()));
    let output = child.wait_with_output().map_err(|error| error.to_string())?;
    let there: Value = serde_json::from_slice(&output.stdout)
        .map_err(|error| format!("{error}, {}: {}", output.status, check::excerpt(&text)))?;
    agree(&here, &there, &text)?;
    Ok(Outcome::Accepted)
}

/// Fails where the answers differ by more than they say.
fn agree(here: &Value, there: &Value, text: &str) -> Result<(), String> {
    let number = |answer: &Value, path: &str| answer.pointer(path).and_then(Value::as_f64);
    for name in ["settlement", "tilt", "force", "moment"] {
        let value = format!("/dimensionless/{name}");
        let error = format!("/error/dimensionless/{name}");
        let (Some(a), Some(b)) = (number(here, &value), number(there, &value)) else { continue };
        let errors = [here, there].map(|answer| number(answer, &error));
        let [Some(of_a), Some(of_b)] = errors else { continue };
        // An error of zero is that of a given value, which is rounded when it is made dimensionless.
        let allowed = of_a + of_b + 4.0 * f64::EPSILON * a.abs();
        let what = format!("{name}: {a:e} and {b:e}, with errors {of_a:e} and {of_b:e}");
        check::holds((a - b).abs() <= allowed, &what, text)?;
    }
    Ok(())
}
