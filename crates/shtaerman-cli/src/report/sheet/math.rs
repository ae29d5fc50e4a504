//! Formulas as `MathML`, which browsers draw by themselves.

/// Text as HTML holds it.
pub(super) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            other => safe.push(other),
        }
    }
    safe
}

/// A name.
pub(super) fn name(text: &str) -> String {
    format!("<mi>{}</mi>", escaped(text))
}

/// A name that stands upright, such as that of a function.
pub(super) fn upright(text: &str) -> String {
    format!("<mi mathvariant=\"normal\">{}</mi>", escaped(text))
}

/// A number.
pub(super) fn number(text: &str) -> String {
    format!("<mn>{}</mn>", escaped(text))
}

/// A sign.
pub(super) fn sign(text: &str) -> String {
    format!("<mo>{}</mo>", escaped(text))
}

/// Parts in a row.
pub(super) fn row(parts: &[&str]) -> String {
    format!("<mrow>{}</mrow>", parts.concat())
}

/// A quotient.
pub(super) fn over(top: &str, bottom: &str) -> String {
    format!("<mfrac><mrow>{top}</mrow><mrow>{bottom}</mrow></mfrac>")
}

/// A part with an index.
pub(super) fn sub(base: &str, index: &str) -> String {
    format!("<msub><mrow>{base}</mrow><mrow>{index}</mrow></msub>")
}

/// A part with an exponent.
pub(super) fn power(base: &str, exponent: &str) -> String {
    format!("<msup><mrow>{base}</mrow><mrow>{exponent}</mrow></msup>")
}

/// An integral over a zone.
pub(super) fn integral(over: &str) -> String {
    format!("<msub><mo largeop=\"true\">∫</mo><mrow>{over}</mrow></msub>")
}

/// Magnitude bars.
pub(super) fn magnitude(inner: &str) -> String {
    format!("<mrow><mo stretchy=\"false\">|</mo>{inner}<mo stretchy=\"false\">|</mo></mrow>")
}

/// An argument in parentheses.
pub(super) fn of(inner: &str) -> String {
    format!("<mrow><mo stretchy=\"false\">(</mo>{inner}<mo stretchy=\"false\">)</mo></mrow>")
}

/// Some space.
pub(super) const SPACE: &str = "<mspace width=\"1.5em\"/>";
/// A little space.
pub(super) const THIN: &str = "<mspace width=\"0.17em\"/>";

/// A formula on a line of its own.
pub(super) fn display(inner: &str) -> String {
    format!("<math display=\"block\"><mrow>{inner}</mrow></math>")
}

/// A formula in a line of text.
pub(super) fn inline(inner: &str) -> String {
    format!("<math><mrow>{inner}</mrow></math>")
}

/// A formula as the program writes kernels, such as `K_mu(kappa |x - s|)/|x - s|^mu`, letter by letter: names of Greek letters become these, `_` and `^` move what follows.
pub(super) fn plain(formula: &str) -> String {
    let mut rest = formula;
    let mut parts: Vec<String> = Vec::new();
    while let Some(first) = rest.chars().next() {
        let (token, after) = token(rest);
        rest = after;
        if (first == '_' || first == '^') && !parts.is_empty() {
            let (argument, after) = argument(rest);
            rest = after;
            let base = parts.pop().unwrap_or_default();
            let moved = plain(argument);
            parts.push(if first == '_' { sub(&base, &moved) } else { power(&base, &moved) });
        } else if !token.trim().is_empty() {
            parts.push(atom(token));
        }
    }
    parts.concat()
}

/// The first token: a word, a number, or one sign.
fn token(text: &str) -> (&str, &str) {
    let kind = |c: char| (c.is_alphabetic(), c.is_ascii_digit() || c == '.');
    let first = text.chars().next().unwrap_or(' ');
    let end = match kind(first) {
        (false, false) => first.len_utf8(),
        known => text.find(|c| kind(c) != known).unwrap_or(text.len()),
    };
    text.split_at(end)
}

/// What `_` or `^` moves: what is in parentheses, or a token with its sign.
fn argument(text: &str) -> (&str, &str) {
    if let Some(inner) = text.strip_prefix('(')
        && let Some(end) = inner.find(')')
    {
        return (&inner[..end], &inner[end + 1..]);
    }
    let sign = usize::from(text.starts_with('-'));
    let (word, _) = token(&text[sign..]);
    text.split_at(sign + word.len())
}

fn atom(token: &str) -> String {
    const GREEK: [(&str, &str); 14] = [
        ("kappa", "κ"),
        ("gamma", "γ"),
        ("alpha", "α"),
        ("lambda", "λ"),
        ("delta", "δ"),
        ("theta", "θ"),
        ("chi", "χ"),
        ("phi", "φ"),
        ("mu", "μ"),
        ("nu", "ν"),
        ("xi", "ξ"),
        ("pi", "π"),
        ("rho", "ρ"),
        ("inf", "∞"),
    ];
    if token == "int" {
        return "<mo largeop=\"true\">∫</mo>".to_owned();
    }
    if token == "-" {
        return sign("−");
    }
    if let Some((_, letter)) = GREEK.iter().find(|(word, _)| *word == token) {
        return name(letter);
    }
    let first = token.chars().next().unwrap_or(' ');
    if first.is_ascii_digit() {
        number(token)
    } else if first.is_alphabetic()
        && token.len() > 1
        && ["ln", "sin", "cos", "exp", "sqrt"].contains(&token)
    {
        upright(token) + THIN
    } else if first.is_alphabetic() {
        name(token)
    } else if "|()".contains(first) {
        format!("<mo stretchy=\"false\">{}</mo>", escaped(token))
    } else {
        sign(token)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_of_kernels_become_markup() {
        assert_eq!(
            plain("|x - s|^-mu"),
            format!(
                "<mo stretchy=\"false\">|</mo>{}{}{}{}",
                name("x"),
                sign("−"),
                name("s"),
                power("<mo stretchy=\"false\">|</mo>", &format!("{}{}", sign("−"), name("μ")))
            )
        );
        assert!(
            plain("int_0^inf J_mu(t x) t^(2 gamma) dt")
                .contains(&power(&name("t"), &format!("{}{}", number("2"), name("γ"))))
        );
        for family in shtaerman::equation::Family::all() {
            let markup = display(&plain(family.formula));
            assert!(roxmltree::Document::parse(&markup).is_ok(), "{}: {markup}", family.formula);
        }
    }

    #[test]
    fn text_cannot_become_markup() {
        assert_eq!(escaped("<a href=\"x\">&"), "&lt;a href=&quot;x&quot;&gt;&amp;");
        assert!(!plain("<script>").contains("<script"));
    }
}
