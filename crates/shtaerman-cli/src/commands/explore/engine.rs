//! What the page can ask, and how it is answered.

use std::time::Duration;

use serde_json::{Value, json};
use shtaerman::document::Document;
use shtaerman::equation::is_equation;

use super::asked::{self, Asked};
use super::map::AskedMap;
use super::{contact, kernel, map, paper, start, study};
use crate::Failure;

/// Answers the page, with the numbers that the command line gives.
pub struct PageEngine {
    stressed: Option<map::Stressed>,
    /// The last contact that was solved, whose stresses are asked for next.
    solved: contact::Kept,
    limit: Duration,
}

impl PageEngine {
    /// An engine that gives each solve this time.
    #[must_use]
    pub fn new(limit: Duration) -> Self {
        Self { stressed: None, solved: None, limit }
    }
}

impl shtaerman_explore::Engine for PageEngine {
    fn answer(&mut self, operation: &str, body: &[u8]) -> Vec<u8> {
        let answer = self.told(operation, body).unwrap_or_else(|failure| asked::fault(&failure));
        answer.to_string().into_bytes()
    }
}

/// A problem, whether its answer is to be audited, and the map that is to come with it.
#[derive(Debug, serde::Deserialize)]
struct AskedSolve {
    #[serde(flatten)]
    problem: Asked,
    #[serde(default)]
    audit: bool,
    #[serde(default)]
    map: Option<map::View>,
}

impl PageEngine {
    fn told(&mut self, operation: &str, body: &[u8]) -> Result<Value, Failure> {
        match operation {
            "start" => Ok(start::without_file(self.limit)),
            "read" => read(&asked::read(body, self.limit)?),
            "solve" => {
                let AskedSolve { problem, audit, map } = asked::read(body, self.limit)?;
                let mut told = contact::told(&mut self.solved, &problem, audit)?;
                // What was not kept would have to be solved once more.
                let has_map = self.solved.is_some() && contact::has_stresses(&told);
                if let Some(view) = map.filter(|_| has_map) {
                    let known = (&mut self.stressed, &mut self.solved);
                    let map = map::told(known, &AskedMap::new(problem, view));
                    told["map"] = map.unwrap_or_else(|failure| asked::fault(&failure));
                }
                Ok(told)
            }
            "csv" => contact::csv(&asked::read(body, self.limit)?),
            "svg" => contact::svg(&asked::read(body, self.limit)?),
            "report" => contact::report(&asked::read(body, self.limit)?),
            "map" => {
                let asked = asked::read(body, self.limit)?;
                map::told((&mut self.stressed, &mut self.solved), &asked)
            }
            "map-svg" => {
                let asked = asked::read(body, self.limit)?;
                map::svg((&mut self.stressed, &mut self.solved), &asked)
            }
            "study" => study::told(&asked::read(body, self.limit)?),
            "study-doubts" => study::doubts(&asked::read(body, self.limit)?),
            "kernel" => kernel::told(&asked::read(body, self.limit)?),
            "equation" => kernel::equation(&asked::read(body, self.limit)?),
            "paper" => paper::tables(),
            "curve" => paper::curve(&asked::read(body, self.limit)?),
            other => Err(Failure::Usage(format!("the page has no question {other:?}"))),
        }
    }
}

impl std::fmt::Debug for PageEngine {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("PageEngine").finish_non_exhaustive()
    }
}

/// The kind and the tree of a file, and its values in SI units.
fn read(asked: &Asked) -> Result<Value, Failure> {
    let document = asked.document()?;
    let checked = match kind(&document) {
        "study" => asked.study().map(drop),
        "equation" => asked.equation().map(drop),
        _ => asked.problem().map(drop),
    };
    let mut told = json!({
        "kind": kind(&document),
        "tree": contact::tree(document.root()),
        "inputs": contact::inputs(&document),
    });
    // A file that makes no sense is shown all the same.
    if let Err(failure) = checked {
        told["fault"] = asked::fault(&failure)["fault"].take();
    }
    Ok(told)
}

fn kind(document: &Document) -> &'static str {
    match (document.get("study").is_some(), is_equation(document)) {
        (true, _) => "study",
        (false, true) => "equation",
        (false, false) => "problem",
    }
}

#[cfg(test)]
mod tests {
    use shtaerman_explore::Engine;

    use super::*;

    const CROWNED: &str = "[foundation]\nyoung_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nroughness = \"1 um/GPa\"\n\
        [punch]\nhalf_width = \"5 mm\"\nprofile = \"x^2/(2*50)\"\n[load]\nforce = \"1 MN/m\"\nmoment = 0\n";

    fn solved(toml: &str, is_audited: bool) -> Value {
        let body = json!({ "name": "x.toml", "toml": toml, "files": {}, "audit": is_audited });
        let mut engine = PageEngine::new(Duration::from_secs(20));
        serde_json::from_slice(&engine.answer("solve", body.to_string().as_bytes())).unwrap()
    }

    fn settlement(told: &Value) -> f64 {
        told["answer"]["physical"]["settlement"].as_f64().unwrap_or_else(|| panic!("{told}"))
    }

    #[test]
    fn what_moves_is_near_what_is_audited() {
        let [moving, audited] = [false, true].map(|is_audited| solved(CROWNED, is_audited));
        let error = (settlement(&moving) / settlement(&audited) - 1.0).abs();
        assert!(error < 1e-6, "{error:e}");
        assert_eq!(moving["python"], audited["python"], "the file is shown as it is written");
    }

    #[test]
    fn a_map_that_comes_with_an_answer_is_the_one_that_is_asked_for_alone() {
        let problem = json!({ "name": "x.toml", "toml": CROWNED, "files": {} });
        let view = json!({ "component": "von-mises", "points": [9, 5] });
        let (mut alone, mut together) = (problem.clone(), problem);
        alone.as_object_mut().unwrap().extend(view.as_object().unwrap().clone());
        together["map"] = view;
        let asked = |engine: &mut PageEngine, operation: &str, body: &Value| -> Value {
            serde_json::from_slice(&engine.answer(operation, body.to_string().as_bytes())).unwrap()
        };
        let mut engine = PageEngine::new(Duration::from_secs(20));
        let answer = asked(&mut engine, "solve", &together);
        let mut other = PageEngine::new(Duration::from_secs(20));
        asked(&mut other, "solve", &json!({ "audit": false, "name": "x.toml", "toml": CROWNED }));
        let map = asked(&mut other, "map", &alone);
        assert_eq!(answer["map"], map);
        assert_eq!(map["values"].as_array().map(Vec::len), Some(9 * 5), "{map}");
        // Stresses under a disk are not known: the answer comes without a map.
        let disk = CROWNED
            .replace("half_width", "geometry = \"circular\"\nradius")
            .replace("1 MN/m", "1 kN")
            .replace("x^2", "r^2");
        together["toml"] = json!(disk);
        let answer = asked(&mut engine, "solve", &together);
        assert!(answer["cards"].is_array() && answer["map"].is_null(), "{answer}");
    }

    #[test]
    fn what_cannot_be_met_while_something_moves_is_answered_all_the_same() {
        let few =
            format!("{CROWNED}[solver]\ncontact = \"bilateral\"\nmethod = \"spectral\"\nn = 6\n");
        let moving = solved(&few, false);
        let error = moving["answer"]["error"]["physical"]["settlement"].as_f64().unwrap();
        assert!(error > 1e-6 * settlement(&moving), "{error:e}");
    }

    #[test]
    fn a_tolerance_of_the_file_counts() {
        let stated = format!(
            "{CROWNED}[solver]\ncontact = \"bilateral\"\nmethod = \"spectral\"\nn = 6\ntolerance = 1e-9\n"
        );
        let fault = &solved(&stated, false)["fault"];
        assert_eq!(fault["exit_code"], 3, "{fault}");
    }
}
