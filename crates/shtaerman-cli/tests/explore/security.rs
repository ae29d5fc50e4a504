//! Only the page itself is answered, only with its own files, and they may load nothing from elsewhere.

use std::net::{Ipv4Addr, SocketAddr, TcpStream, UdpSocket};
use std::time::Duration;

use crate::explore::client::Page;

#[test]
fn only_the_page_itself_is_answered() {
    let page = Page::open(&[]);
    let port = page.port;
    let status = |request: &str| page.raw(request).status;
    let post = |head: &str| {
        status(&format!("POST /api/start HTTP/1.1\r\n{head}Content-Length: 2\r\n\r\n{{}}"))
    };
    let own = format!("Host: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\n");
    let json = "Content-Type: application/json\r\n";
    assert_eq!(post(&format!("{own}{json}")), 200);
    let local = own.replace("127.0.0.1", "localhost");
    assert_eq!(post(&format!("{local}{json}")), 200);
    // A name that was made to lead here.
    let rebound = own.replace("127.0.0.1", "evil.example");
    assert_eq!(post(&format!("{rebound}{json}")), 421);
    assert_eq!(status(&format!("GET / HTTP/1.1\r\nHost: evil.example:{port}\r\n\r\n")), 421);
    assert_eq!(status("GET / HTTP/1.1\r\n\r\n"), 421);
    // The script or the form of another site.
    for origin in ["http://evil.example", "null", "http://127.0.0.1:1", "http://localhost"] {
        let head = format!("Host: 127.0.0.1:{port}\r\nOrigin: {origin}\r\n{json}");
        assert_eq!(post(&head), 403, "{origin}");
    }
    assert_eq!(post(&format!("Host: 127.0.0.1:{port}\r\n{json}")), 403);
    assert_eq!(post(&format!("{own}{json}Sec-Fetch-Site: cross-site\r\n")), 403);
    assert_eq!(post(&format!("{own}Content-Type: text/plain\r\n")), 415);
    // No other site is told that it may.
    let preflight = format!(
        "OPTIONS /api/solve HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://evil.example\r\nAccess-Control-Request-Method: POST\r\n\r\n"
    );
    let told = page.raw(&preflight);
    assert_eq!(told.status, 403);
    assert!(!told.headers.iter().any(|(name, _)| name.starts_with("access-control")));
}

#[test]
fn only_files_of_its_own_are_served() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/crowned_punch.toml");
    let page = Page::open(&[file]);
    for path in [
        "/../../../../etc/passwd",
        "/..%2f..%2fetc/passwd",
        "/%2e%2e/Cargo.toml",
        "//etc/passwd",
        "/etc/passwd",
        "/index.html",
        "/main.js/",
        "/MAIN.JS",
        "/style.css\\..\\x",
        "/api",
        "/crowned_punch.toml",
    ] {
        let told = page.get(path);
        assert_eq!(told.status, 404, "{path}");
        assert!(told.body.len() < 100, "{path}");
    }
    for path in ["/", "/main.js", "/style.css", "/icon.svg"] {
        assert_eq!(page.get(path).status, 200, "{path}");
    }
    assert_eq!(page.get("/?a=b").status, 200, "a question behind a path is no other path");
    // Nor does a problem read a file of the machine.
    let toml =
        crate::explore::client::PUNCH.replace("\"x^2 / (2*20)\"", "{ csv = \"/etc/hostname\" }");
    let told = page.ask("solve", &serde_json::json!({ "name": "x.toml", "toml": toml }));
    let said = told["fault"]["message"].as_str().unwrap();
    assert!(said.contains("/etc/hostname is not there"), "{said}");
}

#[test]
fn every_answer_forbids_what_the_page_does_not_need() {
    let page = Page::open(&[]);
    for told in [
        page.get("/"),
        page.get("/main.js"),
        page.get("/missing"),
        page.raw("GET / HTTP/1.1\r\n\r\n"),
    ] {
        let policy = told.header("content-security-policy").unwrap();
        assert!(
            policy.starts_with("default-src 'none'; script-src 'self'; style-src 'self';"),
            "{policy}"
        );
        assert!(!policy.contains("unsafe") && policy.contains("frame-ancestors 'none'"));
        for (name, value) in [
            ("x-content-type-options", "nosniff"),
            ("x-frame-options", "DENY"),
            ("referrer-policy", "no-referrer"),
            ("cross-origin-resource-policy", "same-origin"),
            ("cross-origin-opener-policy", "same-origin"),
            ("cache-control", "no-store"),
        ] {
            assert_eq!(told.header(name), Some(value), "{name}");
        }
    }
    // What the policy allows is all that the files ask for.
    let html = page.get("/").body;
    let lower = html.to_ascii_lowercase();
    assert!(
        !lower.contains("http://")
            && !lower.contains("https://")
            && !lower.contains(" style=\"")
            && !lower.contains(" onclick")
    );
}

#[test]
fn it_listens_on_the_loopback_alone() {
    let page = Page::open(&[]);
    // The address by which this machine would be reached from elsewhere; nothing is sent.
    let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0)).unwrap();
    let Ok(()) = socket.connect("192.0.2.1:9") else { return };
    let own = socket.local_addr().unwrap().ip();
    if own.is_loopback() || own.is_unspecified() {
        return;
    }
    let from_elsewhere = SocketAddr::new(own, page.port);
    assert!(TcpStream::connect_timeout(&from_elsewhere, Duration::from_secs(2)).is_err());
}
