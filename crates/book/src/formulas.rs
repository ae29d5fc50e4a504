//! Formulas `$..$` and `$$..$$` of a chapter, set by `KaTeX` when the book is built.

use std::fmt::Write as _;

use katex::{KatexContext, Settings, StrictMode, StrictSetting, render_to_string};
use pulldown_cmark::{Event, Options, Parser};

/// A formula that `KaTeX` does not set.
#[derive(Debug, thiserror::Error)]
#[error("line {line}: the formula `{formula}`: {reason}")]
pub struct BadFormula {
    /// Line of the chapter, from 1.
    pub line: usize,
    /// What was written between the dollar signs.
    pub formula: String,
    /// What `KaTeX` says.
    pub reason: String,
}

/// The extensions of Markdown that mdBook reads, and formulas.
fn options() -> Options {
    Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH
}

/// Sets formulas; its tables are made once.
pub struct Setter {
    context: KatexContext,
    inline: Settings,
    display: Settings,
}

impl Default for Setter {
    fn default() -> Self {
        let settings = |display: bool| {
            Settings::builder()
                .display_mode(display)
                .throw_on_error(true)
                .strict(StrictSetting::Mode(StrictMode::Error))
                .build()
        };
        Self { context: KatexContext::default(), inline: settings(false), display: settings(true) }
    }
}

impl Setter {
    /// The chapter with HTML and `MathML` in place of its formulas.
    ///
    /// # Errors
    ///
    /// The first formula that `KaTeX` does not take.
    pub fn chapter(&self, markdown: &str) -> Result<String, BadFormula> {
        let mut set = String::with_capacity(markdown.len());
        let mut copied = 0;
        for (event, range) in Parser::new_ext(markdown, options()).into_offset_iter() {
            let (formula, settings) = match event {
                Event::InlineMath(formula) => (formula, &self.inline),
                Event::DisplayMath(formula) => (formula, &self.display),
                _ => continue,
            };
            let html = render_to_string(&self.context, &formula, settings).map_err(|reason| {
                BadFormula {
                    line: 1 + markdown[..range.start].matches('\n').count(),
                    formula: formula.to_string(),
                    reason: reason.to_string(),
                }
            })?;
            set.push_str(&markdown[copied..range.start]);
            set.push_str(&as_markdown(&without_source(&html)));
            copied = range.end;
        }
        set.push_str(&markdown[copied..]);
        Ok(set)
    }
}

/// `MathML` without the source of the formula, which `KaTeX` keeps as an annotation: nobody reads it, and a search of the book would find it.
fn without_source(html: &str) -> String {
    let mut rest = html;
    let mut kept = String::with_capacity(html.len());
    while let Some((before, after)) = rest.split_once("<annotation") {
        kept.push_str(before);
        rest = after.split_once("</annotation>").map_or("", |(_, after)| after);
    }
    kept + rest
}

/// HTML that Markdown passes on as it is: on one line, and no sign of its text means anything in Markdown, nor a bar the end of a cell.
fn as_markdown(html: &str) -> String {
    let mut text = String::with_capacity(2 * html.len());
    let (mut in_tag, mut in_entity) = (false, false);
    for sign in html.chars() {
        match sign {
            '<' => in_tag = true,
            '>' if in_tag => {
                in_tag = false;
                text.push('>');
                continue;
            }
            '&' if !in_tag => in_entity = true,
            _ => {}
        }
        let is_plain = in_tag || in_entity || !sign.is_ascii_punctuation();
        match sign {
            '\n' => text.push(' '),
            _ if is_plain && sign != '|' => text.push(sign),
            _ => {
                // Writing to a string does not fail.
                let _ = write!(text, "&#{};", u32::from(sign));
            }
        }
        in_entity &= sign != ';';
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(markdown: &str) -> String {
        Setter::default().chapter(markdown).unwrap()
    }

    #[test]
    fn what_is_no_formula_stays_as_it_is() {
        let text = "Costs 5 $ and 6 $.\n\n`$x$`\n\n```console\n$ shtaerman solve $FILE\n```\n";
        assert_eq!(set(text), text);
    }

    #[test]
    fn formulas_are_set_on_one_line_without_their_source() {
        let html = set("With $\\chi$ is\n\n$$ \\frac{a}{b}\\, p\n= |x|_* $$\n\nthe end");
        assert!(html.starts_with("With <span class=\"katex\">") && html.ends_with("\n\nthe end"));
        assert!(html.contains("<span class=\"katex-display\">") && html.contains("<mfrac>"));
        assert!(!html.contains('\\') && !html.contains('$') && !html.contains("annotation"));
        assert_eq!(html.lines().count(), 5);
        // A bar ends no cell of a table, a star begins no emphasis.
        assert!(!html.contains('|') && !html.contains('*'));
    }

    #[test]
    fn a_broken_formula_is_told_with_its_line() {
        let told = Setter::default().chapter("a\n\nb $\\frac{1}$ c").unwrap_err();
        assert_eq!((told.line, told.formula.as_str()), (3, "\\frac{1}"));
        assert!(Setter::default().chapter("$$ \\nonsense $$").is_err());
    }
}
