mod hostile;
mod overrides;
mod places;
mod reader;

use super::*;

const FILE: &str = r#"# a punch
title = "plain"

[punch]
half_width = "5 mm"
profile = "flat"

[load]
settlement = 1e-6
steps = [1, 2.5, "3 mm"]
"#;

fn document(text: &str) -> Document {
    Document::parse(text, "punch.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn fault(text: &str) -> FileError {
    Document::parse(text, "punch.toml").expect_err(text)
}

/// The text under the caret of an error.
fn caret(error: &FileError) -> &str {
    error.source_text().unwrap().get(error.span().unwrap()).unwrap()
}
