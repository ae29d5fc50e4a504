//! What the page asks about: a problem file as text, with the files that it names.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use shtaerman::document::{Attached, Document};
use shtaerman::equation::EquationFile;
use shtaerman::file::ProblemFile;
use shtaerman::quantity::Dimension;
use shtaerman_study::Study;

use crate::Failure;

const LIMIT: &str = "solver.time_limit";

/// A problem file that is on no disk.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(default)]
pub(super) struct Asked {
    /// What to call it in messages and commands.
    pub(super) name: String,
    /// The text.
    pub(super) toml: String,
    /// The files that it names, each byte a character of the same number.
    pub(super) files: BTreeMap<String, String>,
    /// The time (s) that a solve may take which states no limit of its own, or a longer one.
    #[serde(rename = "time_limit_of_the_program")]
    limit: f64,
}

impl Asked {
    /// The document.
    pub(super) fn document(&self) -> Result<Document, Failure> {
        let document = Document::from_bytes(self.toml.as_bytes(), &self.name)?;
        Ok(document.with_attached(Attached::new(self.contents())))
    }

    /// The document with a limit of time. There is no clock in a browser, which ends what takes too long by itself.
    fn limited(&self) -> Result<Document, Failure> {
        let mut document = self.document()?;
        if cfg!(target_family = "wasm") {
            document.remove(LIMIT);
            return Ok(document);
        }
        let table = document.reader().table("solver")?;
        let stated = table.map(|table| table.quantity("time_limit", Dimension::TIME));
        // A fault of the file is told by whoever reads the problem.
        let is_shorter = match stated {
            Some(Ok(Some(stated))) => stated <= self.limit,
            Some(Err(_)) => true,
            Some(Ok(None)) | None => false,
        };
        if !is_shorter {
            document.set(LIMIT, &format!("{:?}", self.limit))?;
        }
        Ok(document)
    }

    /// The files and their bytes.
    pub(super) fn contents(&self) -> impl Iterator<Item = (String, Vec<u8>)> {
        self.files.iter().map(|(name, text)| (name.clone(), bytes(text)))
    }

    /// Its name without the suffix.
    pub(super) fn stem(&self) -> &str {
        self.name.strip_suffix(".toml").unwrap_or(&self.name)
    }

    /// The problem, which ends in time.
    pub(super) fn problem(&self) -> Result<ProblemFile, Failure> {
        Ok(ProblemFile::from_document(self.limited()?, Path::new(""))?)
    }

    /// The problem as it is stated, without the limit of time of the page.
    pub(super) fn stated(&self) -> Result<ProblemFile, Failure> {
        Ok(ProblemFile::from_document(self.document()?, Path::new(""))?)
    }

    /// The study.
    pub(super) fn study(&self) -> Result<Study, Failure> {
        Ok(Study::from_document(self.limited()?, Path::new(""), &[])?)
    }

    /// The equation.
    pub(super) fn equation(&self) -> Result<EquationFile, Failure> {
        Ok(EquationFile::from_bytes(self.toml.as_bytes(), &self.name, &[])?)
    }
}

/// The bytes that characters up to 255 stand for; others are no bytes, and left as they are in UTF-8.
fn bytes(text: &str) -> Vec<u8> {
    let narrow: Result<Vec<u8>, _> = text.chars().map(u8::try_from).collect();
    narrow.unwrap_or_else(|_| text.as_bytes().to_vec())
}

/// What was posted, with the limit of time that the program has for it, whatever the page says.
pub(super) fn read<T: DeserializeOwned>(body: &[u8], limit: Duration) -> Result<T, Failure> {
    let read = serde_json::from_slice(body).and_then(|mut posted: Value| {
        if let Some(posted) = posted.as_object_mut() {
            posted.insert("time_limit_of_the_program".to_owned(), json!(limit.as_secs_f64()));
        }
        serde_json::from_value(posted)
    });
    read.map_err(|error| {
        Failure::Usage(format!("the question of the page makes no sense: {error}"))
    })
}

/// An answer that cannot be JSON.
#[expect(clippy::needless_pass_by_value, reason = "as map_err hands it over")]
pub(super) fn unwritable(error: serde_json::Error) -> Failure {
    Failure::Check(format!("the answer cannot be written: {error}"))
}

/// What is wrong, for the page: what the command line would say, and where it belongs.
pub(super) fn fault(failure: &Failure) -> Value {
    let said = failure.message();
    let message = said.strip_prefix("error: ").unwrap_or(&said).trim_end();
    let mut fault = json!({ "message": message, "exit_code": failure.exit_code() });
    if let Failure::Problem(shtaerman::Error::File(error) | shtaerman::Error::Beyond(error)) =
        failure
    {
        fault["what"] = json!(error.message());
        fault["field"] = json!(error.field());
        fault["help"] = json!(error.help());
        fault["line"] = json!(error.line());
        fault["column"] = json!(error.column());
        fault["within"] = json!(error.inner_span().map(|span| [span.start, span.end]));
    }
    json!({ "fault": fault })
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLAT: &str = "[dimensionless]\ntheta0 = 1\nprofile = \"0\"\nforce = 1\nmoment = 0\n";

    fn asked(toml: &str) -> Asked {
        Asked { name: "x.toml".to_owned(), toml: toml.to_owned(), limit: 10.0, ..Asked::default() }
    }

    #[test]
    fn every_solve_ends_in_time() {
        let limit = |toml: &str| asked(toml).problem().unwrap().problem().solver().time_limit();
        assert_eq!(limit(FLAT), Some(Duration::from_secs(10)));
        let with = |text: &str| limit(&format!("{FLAT}[solver]\ntime_limit = {text}\n"));
        assert_eq!(with("\"2 s\""), Some(Duration::from_secs(2)));
        assert_eq!(with("3600"), Some(Duration::from_secs(10)));
        let wrong =
            asked(&format!("{FLAT}[solver]\ntime_limit = \"2 m\"\n")).problem().unwrap_err();
        assert!(wrong.to_string().contains("x.toml:7: solver.time_limit"), "{wrong}");
    }

    #[test]
    fn the_page_cannot_set_the_limit_of_the_program() {
        let posted = json!({ "name": "x.toml", "toml": FLAT, "time_limit_of_the_program": 1e9 });
        let asked: Asked = read(posted.to_string().as_bytes(), Duration::from_secs(3)).unwrap();
        assert_eq!(asked.limit, 3.0);
    }

    #[test]
    fn files_are_bytes() {
        assert_eq!(bytes("a\u{e9}\u{ff}"), [b'a', 0xe9, 0xff]);
        assert_eq!(bytes("µ→"), "µ→".as_bytes());
    }

    #[test]
    fn a_fault_names_its_place() {
        let wrong = FLAT.replace("\"0\"", "\"x^^2\"");
        let told = fault(&asked(&wrong).problem().unwrap_err());
        let told = &told["fault"];
        assert_eq!((&told["field"], &told["line"]), (&json!("dimensionless.profile"), &json!(3)));
        assert_eq!(told["exit_code"], 2);
        assert!(told["message"].as_str().unwrap().contains("╭"), "{told}");
    }
}
