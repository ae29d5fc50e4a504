use super::*;
use crate::quantity::Dimension;

#[test]
fn types_are_checked() {
    let document = document(
        "n = 1\nf = 1.5\nb = true\ns = \"7\"\nt = {}\na = [1, \"2 mm\"]\nd = 2020-01-01\ny = 'true'\n",
    );
    let root = document.reader();
    assert_eq!(root.number("n").unwrap(), Some(1.0));
    assert_eq!(root.number("f").unwrap(), Some(1.5));
    assert_eq!(root.integer("n").unwrap(), Some(1));
    assert_eq!(root.boolean("b").unwrap(), Some(true));
    assert_eq!(root.string("s").unwrap(), Some("7"));
    assert_eq!(root.number("absent").unwrap(), None);
    assert_eq!(root.quantity("n", Dimension::PRESSURE).unwrap(), Some(1.0));
    assert_eq!(root.quantity("s", Dimension::PRESSURE).unwrap(), Some(7.0));
    assert_eq!(root.required("n").unwrap().count(1..=9).unwrap(), 1);
    let items = root.required("a").unwrap().items().unwrap();
    assert_eq!(items[1].quantity(Dimension::LENGTH).unwrap(), 0.002);
    let messages = [
        (root.number("s").unwrap_err(), "is a number, got the string \"7\""),
        (root.integer("f").unwrap_err(), "is a whole number, got the number 1.5"),
        (root.boolean("n").unwrap_err(), "is true or false, got the number 1"),
        (root.string("d").unwrap_err(), "is a string (in quotes), got the date 2020-01-01"),
        (root.table("n").unwrap_err(), "is a table ([n]), got the number 1"),
        (
            root.quantity("b", Dimension::LENGTH).unwrap_err(),
            "is a length (like \"5 mm\"), got true",
        ),
        (
            root.required("n").unwrap().items().unwrap_err(),
            "is an array (in square brackets), got the number 1",
        ),
        (
            root.required("n").unwrap().count(2..=9).unwrap_err(),
            "is a whole number from 2 to 9, got 1",
        ),
        (items[0].string().unwrap_err(), "is a string (in quotes), got the number 1"),
    ];
    for (error, message) in messages {
        assert_eq!(error.message(), message);
    }
    assert_eq!(items[0].name(), "a[0]");
    assert_eq!(root.number("s").unwrap_err().help(), Some("write 7 without quotes"));
    assert_eq!(root.boolean("y").unwrap_err().help(), Some("write true without quotes"));
    let choice = root.required("s").unwrap().one_of(&["8", "9"]).unwrap_err();
    assert_eq!(choice.message(), "is one of \"8\", \"9\", got the string \"7\"");
}

#[test]
fn choices_propose_the_nearest() {
    let document = document("profile = 'parabla'");
    let field = document.reader().required("profile").unwrap();
    let error = field.one_of(&["flat", "parabola"]).unwrap_err();
    assert_eq!(error.help(), Some("did you mean \"parabola\"?"));
}

#[test]
fn unknown_keys_are_reported_in_the_order_of_the_file() {
    let document = document(
        "[punch]\nzzz = 1\nhalf_witdh = 2\nforce = 3\n[load]\nforce = 1\n[other]\nx = 1\n",
    );
    let read = |skip: &[&str]| {
        let mut document = document.clone();
        for key in skip {
            document.remove(key);
        }
        let root = document.reader();
        let punch = root.table("punch").unwrap().unwrap();
        assert!(!punch.has("half_width") && !punch.has("profile"));
        let load = root.table("load").unwrap().unwrap();
        load.number("force").unwrap();
        root.finish().map_err(|error| (error.to_string(), error.help().map(str::to_owned)))
    };
    let (message, help) = read(&[]).unwrap_err();
    assert_eq!(message, "punch.toml:2: punch.zzz: is not a known key");
    assert_eq!(
        help.unwrap(),
        "known keys of [punch]: half_width, profile; \
         also unknown: punch.half_witdh, punch.force, other"
    );
    let (message, _) = read(&["punch.zzz"]).unwrap_err();
    assert_eq!(
        message,
        "punch.toml:3: punch.half_witdh: is not a known key, did you mean half_width?"
    );
    let (message, _) = read(&["punch.zzz", "punch.half_witdh"]).unwrap_err();
    assert_eq!(message, "punch.toml:4: punch.force: belongs in [load], not in [punch]");
    let (message, _) = read(&["punch.zzz", "punch.half_witdh", "punch.force"]).unwrap_err();
    assert_eq!(message, "punch.toml:7: other: is not a known key");
    assert_eq!(read(&["punch.zzz", "punch.half_witdh", "punch.force", "other"]), Ok(()));
}

#[test]
fn unknown_keys_are_found_in_tables_of_arrays_but_not_in_tables_nobody_read() {
    let document = document("[[layer]]\nmodulus = 1\n[[layer]]\nmodulsu = 2\n[raw]\nx = 1\n");
    let root = document.reader();
    assert!(root.has("raw"));
    for layer in root.required("layer").unwrap().items().unwrap() {
        layer.table().unwrap().number("modulus").unwrap();
    }
    let error = root.finish().unwrap_err();
    assert_eq!(
        error.to_string(),
        "punch.toml:4: layer[1].modulsu: is not a known key, did you mean modulus?"
    );
    assert_eq!(caret(&error), "modulsu");
}

#[test]
fn known_keys_tell_where_a_key_belongs() {
    let document = document("[punch]\ncompliance = 1\nforec = 1\n[foundation]\n[load]\n");
    let asked = |document: &Document| {
        let root = document.reader();
        let [foundation, load] = ["foundation", "load"].map(|name| root.table(name).unwrap());
        assert!(foundation.unwrap().optional("compliance").is_none());
        assert!(load.unwrap().optional("force").is_none());
        root.table("punch").unwrap();
        root.finish().unwrap_err()
    };
    assert_eq!(
        asked(&document).to_string(),
        "punch.toml:2: punch.compliance: belongs in [foundation], not in [punch]"
    );
    let mut document = document.clone();
    document.remove("punch.compliance");
    assert!(asked(&document).message().ends_with("did you mean load.force?"));
}

#[test]
fn missing_keys_name_what_is_written_instead() {
    let document = document(
        "compliance = 1\n[punch]\nhalf_witdh = 2\n[foundation]\nmodulus = 1\n[moment]\nforce = 1\n",
    );
    let root = document.reader();
    let punch = root.required("punch").unwrap().table().unwrap();
    let error = punch.required("half_width").unwrap_err();
    assert_eq!(error.to_string(), "punch.toml:3: punch.half_width: is missing");
    assert_eq!(error.help(), Some("half_witdh is written, did you mean half_width?"));
    let foundation = root.required("foundation").unwrap().table().unwrap();
    let error = foundation.required("compliance").unwrap_err();
    assert_eq!(error.help(), Some("move it from the top of the file to [foundation]"));
    assert_eq!(error.line(), Some(1));
    // Nobody has read [moment] yet, so a force in it may well be at home there.
    let error = foundation.required("force").unwrap_err();
    assert_eq!(error.help(), None);
    let error = punch.required("profile").unwrap_err();
    assert_eq!(
        (error.to_string(), error.help()),
        ("punch.toml:2: punch.profile: is missing".to_owned(), None)
    );
    let error = root.required("load").unwrap_err();
    assert_eq!(error.to_string(), "punch.toml: load: is missing");
}

#[test]
fn keys_that_exclude_each_other() {
    let document = document("[load]\nforce = 1\nsettlement = 2\n[moment]\n");
    let root = document.reader();
    let load = root.required("load").unwrap().table().unwrap();
    let error = load.exactly_one(&["force", "settlement"]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "punch.toml:3: load.settlement: is written besides load.force, one of them is allowed"
    );
    let field = load.exactly_one(&["tilt", "force"]).unwrap();
    assert_eq!(field.name(), "load.force");
    let moment = root.required("moment").unwrap().table().unwrap();
    let error = moment.exactly_one(&["tilt", "moment"]).unwrap_err();
    assert_eq!(error.to_string(), "punch.toml:4: tilt or moment is missing in [moment]");
    assert_eq!(
        moment.at_most_one(&["tilt", "moment"]).unwrap().map(|field| field.name().len()),
        None
    );
}

#[test]
fn a_document_with_files_reads_no_other() {
    let text = "here = \"a.csv\"\nmissing = \"/etc/hostname\"\n";
    let files = Attached::new([("a.csv".to_owned(), b"1,2".to_vec())]);
    let document = Document::parse(text, "x.toml").unwrap().with_attached(files);
    let reader = document.reader();
    let load = |key| reader.required(key).unwrap().load(std::path::Path::new("/"));
    assert_eq!(load("here").unwrap(), ("a.csv".to_owned(), b"1,2".to_vec()));
    assert_eq!(
        load("missing").unwrap_err().to_string(),
        "x.toml:2: missing: /etc/hostname is not there: give this file, too"
    );
}
