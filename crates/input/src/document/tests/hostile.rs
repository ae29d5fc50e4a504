use proptest::prelude::*;

use super::*;
use crate::quantity::Dimension;

#[test]
fn broken_files_give_errors_with_lines() {
    let cases = [
        ("a = 1\nb = \n", 2),
        ("a = 1\n\n[x", 3),
        ("a = 1\na = 2", 2),
        ("a = \"open", 1),
        ("a = 1\nb = nan", 2),
        ("a = 1\nb = [[1, inf]]", 2),
        ("a = 1\nb = 1e400", 2),
        ("a = 1\nb = 99999999999999999999", 2),
        ("= 1", 1),
    ];
    for (text, line) in cases {
        let error = fault(text);
        assert_eq!(error.line(), Some(line), "{text:?}: {error}");
        assert!(!error.to_string().contains('\n'), "{error}");
    }
    let error = fault("a = 1\nb = [[1, inf]]");
    assert_eq!(error.to_string(), "punch.toml:2: b[0][1]: is inf, a finite number was expected");
    assert!(fault("x = 1\n[").to_string().starts_with("punch.toml:2: is not valid TOML: "));
}

#[test]
fn files_without_content_or_of_other_encodings() {
    let bytes = |bytes: &[u8]| Document::from_bytes(bytes, "a.toml").unwrap_err();
    assert_eq!(bytes(b"").to_string(), "a.toml: the file is empty");
    assert_eq!(bytes(b" \n\t\r\n").to_string(), "a.toml: the file is empty");
    assert_eq!(bytes(b"# x\n").to_string(), "a.toml: the file has comments but no keys");
    let error = bytes(b"a = 1\nb = \"\xff\"");
    assert_eq!(error.to_string(), "a.toml: the file is not UTF-8: byte 0xff at offset 11, line 2");
    assert!(bytes(b"\xff\xfea\0").help().unwrap().contains("UTF-16"));
    assert!(bytes(b"a = \0").to_string().contains("not valid TOML"));
    assert!(Document::from_bytes("µ = 1".as_bytes(), "a.toml").is_err());
    assert!(Document::from_bytes(b"a = 1", "a.toml").is_ok());
}

#[test]
fn files_over_the_limit_are_refused() {
    let error = Document::from_bytes(&vec![b' '; MAXIMUM_BYTES + 1], "a.toml").unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.toml: the file has 200000001 bytes, more than the 200000000 that are read"
    );
    let many = format!("a = [{}]", "1,".repeat(MAXIMUM_TOKENS / 2));
    assert_eq!(fault(&many).message(), "has more than 5000000 words, numbers and signs");
}

/// In a thread with little stack, so that an overflow would show.
#[test]
fn deep_nesting_gives_errors() {
    let work = || {
        let n = 1_000_000;
        let towers = [
            format!("a = {}", "[".repeat(n)),
            format!("a = {}", "{a=".repeat(n)),
            format!("a = {}1{}", "[".repeat(n), "]".repeat(n)),
            "[".repeat(n),
            "a.".repeat(n),
            format!("{}a = 1", "a.".repeat(n)),
            format!("[{}a]", "a.".repeat(n)),
            format!("{}a = 1", "\"\".".repeat(n)),
            format!("{}a = 1", "a.\n".repeat(n)),
            format!("{}a = 1", "'a' . ".repeat(n)),
            format!("x\"\"\" = 1\n{}a = 1", "a.".repeat(n)),
            format!("\u{feff}\"\"\"\n\"\"\"{}.a = 1", ".a".repeat(n)),
        ];
        for text in towers {
            assert!(Document::parse(&text, "a.toml").is_err());
        }
        // As deep as the parser itself allows, and as deep as the guard before it allows.
        for (parts, message) in [(79, "parts between dots"), (MAXIMUM_KEY_PARTS, "nested more")] {
            let key = vec!["a"; parts].join(".");
            let (open, close) = (format!("{{{key}=").repeat(79), "}".repeat(79));
            let text = format!("[{key}]\nx = {open}1{close}");
            let error = Document::parse(&text, "a.toml").unwrap_err();
            assert!(error.message().contains(message), "{error}");
        }
    };
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(work).unwrap();
    thread.join().unwrap();
}

proptest! {
    #[test]
    fn arbitrary_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = Document::from_bytes(&bytes, "a.toml");
    }

    #[test]
    fn texts_of_the_grammar_never_panic(text in "([ab\"'.=,#\\[\\]{}\n\\\\ 1-]|\"\"\"|'''|é){0,60}") {
        match Document::parse(&text, "a.toml") {
            Ok(document) => {
                for key in document.root().keys() {
                    let origin = document.root().get(key).unwrap().origin();
                    prop_assert!(text.get(origin.span()).is_some());
                }
            }
            Err(error) => {
                let _ = (error.to_string(), error.line(), error.column());
                prop_assert!(error.span().is_none_or(|span| text.get(span).is_some()));
            }
        }
    }

    #[test]
    fn arbitrary_overrides_never_panic(key in "[a-c. é-]{0,12}", text in ".{0,40}") {
        let mut document = document("a = 1\n[b]\nc = [1, { a = 2 }]\n");
        let before = document.clone();
        match document.set(&key, &text) {
            Ok(()) => prop_assert!(document.get(&key).is_some()),
            Err(error) => {
                let _ = (error.to_string(), error.source_text(), error.span());
                prop_assert_eq!(document, before);
            }
        }
    }

    #[test]
    fn numbers_keep_their_bits(value in any::<f64>()) {
        prop_assume!(value.is_finite());
        let mut document = Document::empty();
        document.set("x", &format!("{value:e}")).unwrap();
        document.set("y", &format!("{value:e} Pa")).unwrap();
        let root = document.reader();
        prop_assert_eq!(root.number("x").unwrap(), Some(value));
        prop_assert_eq!(root.quantity("y", Dimension::PRESSURE).unwrap(), Some(value));
    }
}

#[test]
fn streams_without_an_end_are_read_to_the_limit() {
    let said = "has more than the 200000000 bytes that are read";
    assert_eq!(read_bytes(std::io::repeat(b'#')).unwrap_err(), said);
    assert_eq!(read_bytes(b"a = 1".as_slice()).unwrap(), b"a = 1");
    #[cfg(unix)]
    assert_eq!(load_bytes(std::path::Path::new("/dev/zero")).unwrap_err(), said);
}
