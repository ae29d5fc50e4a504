use super::*;
use crate::quantity::Dimension;

#[test]
fn overrides_are_read_as_toml_or_as_text() {
    let mut document = document(FILE);
    for (key, text) in [
        ("load.force", "1 MN/m"),
        ("load.count", "7"),
        ("load.exact", "true"),
        ("load.shape", " \"x\" "),
        ("punch.profile.csv", "a.csv"),
        ("new.deep.key", "[1, 2]"),
        ("punch.half_width", "6 mm"),
        ("broken", "[1, 2"),
    ] {
        document.set(key, text).unwrap();
    }
    let kind = |key| document.get(key).unwrap().kind().clone();
    assert_eq!(kind("load.force"), ValueKind::String("1 MN/m".to_owned()));
    assert_eq!(kind("load.count"), ValueKind::Integer(7));
    assert_eq!(kind("load.exact"), ValueKind::Boolean(true));
    assert_eq!(kind("load.shape"), ValueKind::String("x".to_owned()));
    assert_eq!(kind("punch.profile.csv"), ValueKind::String("a.csv".to_owned()));
    assert_eq!(kind("punch.half_width"), ValueKind::String("6 mm".to_owned()));
    assert_eq!(kind("broken"), ValueKind::String("[1, 2".to_owned()));
    assert!(matches!(kind("new.deep.key"), ValueKind::Array(items) if items.len() == 2));
    assert!(document.get("load.force").unwrap().origin().is_override());
    assert!(!document.get("load.settlement").unwrap().origin().is_override());
}

#[test]
fn faults_of_overrides_show_the_override() {
    let mut document = document(FILE);
    document.set("punch.half_width", "  5 Pa ").unwrap();
    let punch = document.reader().required("punch").unwrap().table().unwrap();
    let error = punch.quantity("half_width", Dimension::LENGTH).unwrap_err();
    assert_eq!(
        error.to_string(),
        "--set punch.half_width=  5 Pa : punch.half_width: is a length (like \"5 mm\"), \
         got Pa, a pressure"
    );
    assert_eq!((caret(&error), error.line(), error.source_name()), ("Pa", None, "--set"));
    document.set("punch.half_width", "\"5 Pa\"").unwrap();
    let punch = document.reader().required("punch").unwrap().table().unwrap();
    assert_eq!(caret(&punch.quantity("half_width", Dimension::LENGTH).unwrap_err()), "Pa");
}

#[test]
fn wrong_overrides_leave_the_document_as_it_was() {
    let mut document = document(FILE);
    let before = document.clone();
    let long = vec!["a"; MAXIMUM_KEY_PARTS + 1].join(".");
    let deep = format!("{}1{}", "[".repeat(40), "]".repeat(40));
    let cases = [
        ("punch", "5", "is a table, got the number 5"),
        ("load.steps.x", "5", "is an array, whose items cannot be set one by one"),
        ("", "5", "has a key with nothing between its dots"),
        ("load..force", "5", "has a key with nothing between its dots"),
        ("lo ad", "5", "has a key with ' ', letters, digits, _ and - are allowed"),
        (&long, "5", "has a key of more than 16 parts between dots"),
        ("load.force", "", "has no value behind the ="),
        ("load.force", "nan", "is nan, a finite number was expected"),
        ("load.force", "-inf", "is -inf, a finite number was expected"),
        ("load.force", "[1, inf]", "is inf, a finite number was expected"),
        ("load.force", "1e999", "is 1e999, beyond 64-bit floats (1.8e308)"),
        (
            "load.force",
            "99999999999999999999",
            "is 99999999999999999999, beyond 64-bit whole numbers",
        ),
        ("load.force", &deep, "is nested more than 32 levels deep"),
    ];
    for (key, text, message) in cases {
        assert_eq!(document.set(key, text).expect_err(key).message(), message, "{key}={text}");
        assert_eq!(document, before, "{key}={text}");
    }
    let error = document.set("punch", "5").unwrap_err();
    assert_eq!(error.help(), Some("set punch.half_width or punch.profile"));
    // Brackets without end are no TOML, and then they are text like any other.
    document.set("x", &"[".repeat(1_000_000)).unwrap();
}

#[test]
fn overrides_take_the_place_of_alternatives() {
    let pair = ["load.force", "load.settlement"];
    let mut document = document(FILE);
    document.prefer_overrides(&pair);
    assert!(document.get("load.settlement").is_some());
    document.set("load.force", "1 MN/m").unwrap();
    document.prefer_overrides(&pair);
    assert!(document.get("load.settlement").is_none());
    document.set("load.settlement", "1 um").unwrap();
    document.prefer_overrides(&pair);
    assert!(pair.iter().all(|key| document.get(key).is_some()));
    assert!(document.remove("load.force").is_some());
    assert!(document.remove("load.force").is_none());
    assert!(document.remove("title.x").is_none());
}

#[test]
fn documents_may_be_made_of_overrides_alone() {
    let mut document = Document::empty();
    document.set("load.force", "5").unwrap();
    assert_eq!(document.file_name(), None);
    let load = document.reader().required("load").unwrap().table().unwrap();
    assert_eq!(load.number("force").unwrap(), Some(5.0));
    assert_eq!(document.reader().required("punch").unwrap_err().to_string(), "punch: is missing");
}
