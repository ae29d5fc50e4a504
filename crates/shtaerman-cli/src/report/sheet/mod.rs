//! A report: one self-contained page with inputs, model, answer, pictures, error and the command that repeats it.

mod inputs;
mod math;
mod model;
mod told;

use std::fmt::Write;

use sha2::{Digest, Sha256};
use shtaerman::document::Document;
use shtaerman::equation::Equation;
use shtaerman::quantity::OutputUnits;
use shtaerman::{Answer, Contact, PressureCurve, Problem};

use super::Told;
use crate::Failure;
use crate::plot::{Format, Look, Plot, Size, Titled, render_as};
use math::escaped;

pub(crate) use inputs::Entry;

const STYLE: &str = include_str!("style.css");
/// Files up to this size are put into the page, so that it has all that is needed to repeat it.
const ATTACHED: usize = 200_000;

/// A report in the making.
#[derive(Debug, Default)]
pub(crate) struct Sheet {
    title: String,
    command: String,
    words: Vec<String>,
    entries: Vec<Entry>,
    model: String,
    told: told::Told,
    pictures: Vec<(String, String)>,
    /// What the checks of this answer look at.
    checked: &'static str,
    /// Why nothing was looked at.
    unchecked: Option<&'static str>,
    files: Vec<(String, Vec<u8>)>,
}

impl Sheet {
    /// The report of what `command` told about a file: its own text, word by word.
    pub(crate) fn new(title: &str, command: &str, told: &Told) -> Self {
        Self {
            title: title.to_owned(),
            command: command.to_owned(),
            told: told::sorted(told),
            ..Self::default()
        }
    }

    /// The inputs of a document, and the file they were read from.
    pub(crate) fn document(&mut self, document: &Document) {
        self.entries.extend(inputs::of_document(document));
        if let Some(name) = document.file_name() {
            self.file(name, document.source_text().as_bytes());
        }
    }

    /// Inputs of the command line.
    pub(crate) fn options(&mut self, options: impl IntoIterator<Item = Entry>) {
        self.entries.extend(options);
    }

    /// A file that was read.
    pub(crate) fn file(&mut self, name: &str, content: &[u8]) {
        self.files.push((name.to_owned(), content.to_owned()));
    }

    /// The model of a contact, and that its answer was looked at with the eyes of an engineer.
    pub(crate) fn problem(&mut self, problem: &Problem) {
        self.model = model::of_problem(problem);
        self.checked = "steep bases and large tilts (small slopes are assumed), pressures that no solid bears or above the yield stress, settlements beyond the half-width, bases wider than machines have, moduli and yield stresses without a unit that are softer than rubber";
    }

    /// That the numbers of the model are those before anything is varied.
    pub(crate) fn varied(&mut self) {
        self.model.push_str(
            "<p>These numbers are those of the file as it stands, before the study varies any of them.</p>",
        );
    }

    /// That nothing was looked at with the eyes of an engineer, and why.
    pub(crate) fn unchecked(&mut self, why: &'static str) {
        self.unchecked = Some(why);
    }

    /// The model of an equation.
    pub(crate) fn equation(&mut self, equation: &Equation) {
        self.model = model::of_equation(equation);
        self.checked = "kernels that are not square-summable, integrals that do not exist, right-hand sides of which nothing is proved";
    }

    /// The answer in sentences.
    pub(crate) fn words(&mut self, words: Vec<String>) {
        self.words = words;
    }

    /// How a contact was found, and how sure it is, where the command tells only what follows from it.
    pub(crate) fn contact(
        &mut self,
        contact: &Contact,
        units: &OutputUnits,
    ) -> Result<(), Failure> {
        let curve = PressureCurve::along(contact, 2)?;
        self.sure(&super::answer_notes(contact, &Answer::new(contact, curve), units));
        Ok(())
    }

    /// Lines about how sure the answer is, beside those that the command tells.
    pub(crate) fn sure(&mut self, lines: &str) {
        let more = told::sorted(&Told::new(format!("\n{lines}")));
        for line in more.sure {
            if !self.told.sure.contains(&line) {
                self.told.sure.push(line);
            }
        }
    }

    /// Warnings, beside those that the command tells.
    pub(crate) fn warnings<'w>(&mut self, warnings: impl IntoIterator<Item = &'w str>) {
        for warning in warnings {
            if !self.told.warnings.iter().any(|known| known == warning) {
                self.told.warnings.push(warning.to_owned());
            }
        }
    }

    /// How far the answer is from what was aimed at: beside how sure it is, and not among the warnings.
    pub(crate) fn accuracy(&mut self, message: &str) {
        self.told.warnings.retain(|known| known != message);
        self.told.sure.push(("accuracy".to_owned(), message.to_owned()));
    }

    /// A picture with its caption.
    pub(crate) fn picture(
        &mut self,
        caption: &str,
        plot: &dyn Plot,
        size: Option<Size>,
    ) -> Result<(), Failure> {
        let look = Look::default();
        let bytes = render_as(&Titled { figure: plot.figure(), size }, Format::Svg, look)?;
        let svg = String::from_utf8_lossy(&bytes).into_owned();
        self.pictures.push((caption.to_owned(), inlined(&svg, self.pictures.len(), caption)));
        Ok(())
    }

    /// The page.
    pub(crate) fn html(&self) -> String {
        let title = escaped(&self.title);
        let mut page = format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\">\n<title>{title}</title>\n<style>\n{STYLE}</style></head><body><main>\n<header><p class=\"brand\">Shtaerman {}</p><h1>{title}</h1><p class=\"lead\">{}</p></header>\n",
            env!("CARGO_PKG_VERSION"),
            escaped(&self.told.heading),
        );
        if !self.words.is_empty() {
            let words: Vec<String> = self.words.iter().map(|said| escaped(said)).collect();
            let _ = writeln!(page, "<p class=\"words\">{}</p>", words.join(" "));
        }
        section(&mut page, "inputs", "Inputs", &inputs::table(&self.entries));
        if !self.model.is_empty() {
            section(&mut page, "model", "Model", &self.model);
        }
        section(&mut page, "answer", "Answer", &self.told.answer);
        let pictures: String = self
            .pictures
            .iter()
            .map(|(caption, svg)| {
                format!("<figure>{svg}<figcaption>{}</figcaption></figure>", escaped(caption))
            })
            .collect();
        if !pictures.is_empty() {
            section(&mut page, "pictures", "Pictures", &pictures);
        }
        section(&mut page, "sure", "How sure this is", &self.certainty());
        section(&mut page, "checks", "Sense checks", &self.checks());
        section(&mut page, "repeat", "To repeat it", &self.repetition());
        page.push_str("<footer><p>Checked by <span class=\"blank\"></span> Date <span class=\"blank\"></span></p></footer>\n</main></body></html>\n");
        page
    }

    fn certainty(&self) -> String {
        let line = |(name, text): &(String, String)| {
            format!("<div><dt>{}</dt><dd>{}</dd></div>", escaped(name), escaped(text))
        };
        format!("<dl>{}</dl>", self.told.sure.iter().map(line).collect::<String>())
    }

    fn checks(&self) -> String {
        if let Some(why) = self.unchecked {
            return format!("<p>Nothing was looked for: {}</p>", escaped(why));
        }
        let checked = if self.checked.is_empty() {
            String::new()
        } else {
            format!("<p class=\"note\">Looked for: {}.</p>", self.checked)
        };
        if self.told.warnings.is_empty() {
            return format!("<p>Nothing was found that an engineer would doubt.</p>{checked}");
        }
        let found: String =
            self.told.warnings.iter().map(|said| format!("<li>{}</li>", escaped(said))).collect();
        format!("<ul class=\"warnings\">{found}</ul>{checked}")
    }

    fn repetition(&self) -> String {
        let mut text = format!(
            "<p>Shtaerman {}:</p><pre>{}</pre>",
            env!("CARGO_PKG_VERSION"),
            escaped(&self.command)
        );
        for (name, content) in &self.files {
            let sum: String =
                Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect();
            let _ = write!(
                text,
                "<p class=\"note\"><b>{}</b>, {} bytes, SHA-256 <code>{sum}</code></p>",
                escaped(name),
                content.len()
            );
            if content.len() <= ATTACHED {
                let shown = String::from_utf8_lossy(content);
                let _ = write!(
                    text,
                    "<details><summary>{}</summary><pre>{}</pre></details>",
                    escaped(name),
                    escaped(&shown)
                );
            }
        }
        text
    }
}

fn section(page: &mut String, kind: &str, name: &str, content: &str) {
    let _ = writeln!(page, "<section class=\"{kind}\"><h2>{name}</h2>{content}</section>");
}

/// A picture within a page: it takes the width there is, and its names are told apart from those of other pictures.
fn inlined(svg: &str, index: usize, caption: &str) -> String {
    let named = svg
        .replace("id=\"", &format!("id=\"picture{index}-"))
        .replace("url(#", &format!("url(#picture{index}-"))
        .replace("href=\"#", &format!("href=\"#picture{index}-"));
    let Some(rest) = named.split_once("<svg ").map(|(_, rest)| rest) else { return String::new() };
    let size = |side: &str| {
        let text = rest.split_once(&format!("{side}=\""))?.1;
        text.split_once('"')?.0.parse::<f64>().ok()
    };
    let seen = match (size("width"), size("height")) {
        (Some(width), Some(height)) if !rest.contains("viewBox") => {
            format!("viewBox=\"0 0 {width} {height}\" ")
        }
        _ => String::new(),
    };
    let role = if rest.contains("role=\"img\"") {
        String::new()
    } else {
        format!("role=\"img\" aria-label=\"{}\" ", escaped(caption))
    };
    format!("<svg {role}{seen}{rest}")
}
