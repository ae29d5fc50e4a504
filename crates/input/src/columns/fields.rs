//! The fields of a line.

/// What stands between the fields of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Separator {
    /// A semicolon; a comma is then a decimal one.
    Semicolon,
    /// A tab; a comma is then a decimal one.
    Tab,
    /// A comma.
    Comma,
    /// Blanks.
    Blanks,
}

impl Separator {
    /// What it is called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Semicolon => "semicolons",
            Self::Tab => "tabs",
            Self::Comma => "commas",
            Self::Blanks => "blanks",
        }
    }

    /// That of a line.
    pub(super) fn of(line: &str) -> Self {
        if line.contains(';') {
            Self::Semicolon
        } else if line.trim().contains('\t') {
            Self::Tab
        } else if line.contains(',') {
            Self::Comma
        } else {
            Self::Blanks
        }
    }

    /// Whether it stands in a line.
    pub(super) fn is_in(self, line: &str) -> bool {
        line.trim().contains(|letter| self.is(letter))
    }

    fn is(self, letter: char) -> bool {
        match self {
            Self::Semicolon => letter == ';',
            Self::Tab => letter == '\t',
            Self::Comma => letter == ',',
            Self::Blanks => letter.is_whitespace(),
        }
    }

    /// The parts of a header, in which a separator within quotes is none; words that blanks separate have no comma behind them.
    pub(super) fn parts(self, line: &str) -> Vec<String> {
        let line = line.trim();
        let (mut parts, mut from, mut quoted) = (Vec::new(), 0, false);
        for (at, letter) in line.char_indices() {
            let is_first = line[from..at].trim().is_empty();
            if letter == '"' && (quoted || is_first) {
                quoted = !quoted;
            } else if self.is(letter) && !quoted {
                parts.push(&line[from..at]);
                from = at + letter.len_utf8();
            }
        }
        parts.push(&line[from..]);
        let is_kept = |part: &&str| self != Self::Blanks || !part.is_empty();
        parts.into_iter().filter(is_kept).map(|part| unquoted(part).to_owned()).collect()
    }

    /// What two blanks or more separate.
    pub(super) fn apart(line: &str) -> Vec<String> {
        let line = line.trim().replace('\t', "  ");
        let parts = line.split("  ").map(str::trim).filter(|part| !part.is_empty());
        parts.map(|part| unquoted(part).to_owned()).collect()
    }

    /// The fields of a line, without quotes; decimal commas as points.
    pub(super) fn fields(self, line: &str) -> Vec<String> {
        let separated = |separator: char| line.trim().split(separator).map(unquoted);
        // A number with both has separators of thousands, which are told as they are written.
        let with_point = |field: &str| {
            if field.contains('.') { field.to_owned() } else { field.replace(',', ".") }
        };
        match self {
            Self::Semicolon => separated(';').map(with_point).collect(),
            Self::Tab => separated('\t').map(with_point).collect(),
            Self::Comma => self.parts(line),
            Self::Blanks => {
                line.split_whitespace().map(|field| unquoted(field).to_owned()).collect()
            }
        }
    }
}

fn unquoted(field: &str) -> &str {
    let field = field.trim();
    field.strip_prefix('"').and_then(|field| field.strip_suffix('"')).unwrap_or(field)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_commas_are_points_where_they_separate_nothing() {
        for line in ["1,5;2,25", "1,5\t2,25", "1.5,2.25", "1.5 2.25", "\"1.5\" , \"2.25\""] {
            assert_eq!(Separator::of(line).fields(line), ["1.5", "2.25"], "{line}");
        }
    }
}
