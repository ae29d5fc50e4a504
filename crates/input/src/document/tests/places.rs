use super::*;
use crate::quantity::Dimension;

#[test]
fn values_know_their_place() {
    let document = document(FILE);
    let places = [
        ("title", 2, 9, "\"plain\""),
        ("punch", 4, 1, "[punch]"),
        ("punch.half_width", 5, 14, "\"5 mm\""),
        ("load.settlement", 9, 14, "1e-6"),
    ];
    for (key, line, column, text) in places {
        let origin = document.get(key).unwrap().origin();
        assert_eq!((origin.line(), origin.column()), (line, column), "{key}");
        assert_eq!(&document.source_text()[origin.span()], text);
        assert_eq!(origin.file_name(), Some("punch.toml"));
        assert!(!origin.is_override());
    }
    assert!(document.get("punch.nothing").is_none());
    assert!(document.get("title.nothing").is_none());
    assert!(document.get("").is_none());
}

#[test]
fn columns_count_characters_and_skip_the_byte_order_mark() {
    let document = document("\u{feff}a = 1\r\n\"é\" = { b = 2 }\r\n");
    let a = document.get("a").unwrap().origin();
    assert_eq!((a.line(), a.column(), a.span()), (1, 5, 7..8));
    let b = document.get("é.b").unwrap().origin();
    assert_eq!((b.line(), b.column()), (2, 13));
}

#[test]
fn faults_of_quantities_point_into_the_string() {
    let document =
        document("[punch]\nhalf_width = \"5 Pa\"\nheight = 'x 7'\nwidth = '''\n5 mpa'''\n");
    let punch = document.reader().required("punch").unwrap().table().unwrap();
    let fault = |key| punch.quantity(key, Dimension::LENGTH).unwrap_err();

    let error = fault("half_width");
    assert_eq!(
        error.to_string(),
        "punch.toml:2: punch.half_width: is a length (like \"5 mm\"), got Pa, a pressure"
    );
    assert_eq!(caret(&error), "Pa");
    assert_eq!((error.line(), error.column(), error.inner_span()), (Some(2), Some(17), Some(2..4)));
    assert_eq!((error.field(), error.file_name()), (Some("punch.half_width"), Some("punch.toml")));

    assert_eq!(caret(&fault("height")), "x 7");
    let error = fault("width");
    assert_eq!((caret(&error), error.line()), ("mpa", Some(5)));
    assert!(error.message().ends_with("did you mean MPa?"));
}

#[test]
fn carets_into_escaped_strings_fall_back_to_the_value() {
    let document = document(r#"a = "5\u0020Pa""#);
    let error = document.reader().quantity("a", Dimension::LENGTH).unwrap_err();
    assert_eq!(caret(&error), r#""5\u0020Pa""#);
    assert_eq!(error.inner_span(), Some(2..4));
    let field = document.reader().required("a").unwrap();
    assert_eq!(caret(&field.error_within("x", 900..901)), r#""5\u0020Pa""#);
}
