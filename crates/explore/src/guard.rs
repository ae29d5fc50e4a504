//! Who may ask, and what an answer may do in the browser.
//!
//! A server on the loopback is reached by every site that the user visits: by a form or a script that posts to it, or by a name that was made to lead to 127.0.0.1 (DNS rebinding). Both are told by what
//! the browser says of itself: `Host` is the name by which the page was asked for, `Origin` the site whose script asks.

use hyper::header::{
    ALLOW, CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HOST, HeaderMap, HeaderName,
    HeaderValue, ORIGIN, REFERRER_POLICY, X_CONTENT_TYPE_OPTIONS, X_FRAME_OPTIONS,
};
use hyper::{Method, StatusCode};

/// What the page may do: load its own files, ask its own server, show pictures that it made itself; nothing in line, nothing from elsewhere, in no frame of another page.
pub const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; require-trusted-types-for 'script'";

/// Where questions are posted.
pub const API: &str = "/api/";

const FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Why a request is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Refused {
    /// The name by which it was asked for is not that of this server.
    #[error("this server answers to 127.0.0.1 and localhost alone")]
    Host,
    /// The script of another site asks.
    #[error("only the page of this server may ask")]
    Origin,
    /// There is no such file.
    #[error("there is no such page")]
    Missing,
    /// There is something else to be done here.
    #[error("this is not done here")]
    Method(&'static str),
    /// What is posted is not JSON.
    #[error("questions are application/json")]
    Kind,
}

impl Refused {
    /// The status that says so.
    #[must_use]
    pub fn status(self) -> StatusCode {
        match self {
            Self::Host => StatusCode::MISDIRECTED_REQUEST,
            Self::Origin => StatusCode::FORBIDDEN,
            Self::Missing => StatusCode::NOT_FOUND,
            Self::Method(_) => StatusCode::METHOD_NOT_ALLOWED,
            Self::Kind => StatusCode::UNSUPPORTED_MEDIA_TYPE,
        }
    }

    /// What the status is told with.
    pub(crate) fn headers(self, headers: &mut HeaderMap) {
        if let Self::Method(allowed) = self {
            headers.insert(ALLOW, HeaderValue::from_static(allowed));
        }
    }
}

/// Refuses a request that the page of the server on `port` would not make.
///
/// # Errors
/// [`Refused`].
pub fn check(method: &Method, path: &str, headers: &HeaderMap, port: u16) -> Result<(), Refused> {
    let host = only(headers, &HOST).ok_or(Refused::Host)?;
    if ![format!("127.0.0.1:{port}"), format!("localhost:{port}")].iter().any(|own| own == host) {
        return Err(Refused::Host);
    }
    let origin = only(headers, &ORIGIN);
    let is_asking = path.starts_with(API);
    let is_foreign = origin.is_some_and(|origin| origin != format!("http://{host}"));
    // A link on another site may lead here, to the page itself, where it can do nothing.
    let site = only(headers, &FETCH_SITE);
    let is_from_elsewhere = is_asking && site.is_some_and(|site| site != "same-origin");
    if headers.contains_key(ORIGIN) && origin.is_none() || is_foreign || is_from_elsewhere {
        return Err(Refused::Origin);
    }
    if !is_asking {
        let is_read = matches!(*method, Method::GET | Method::HEAD);
        return if is_read { Ok(()) } else { Err(Refused::Method("GET, HEAD")) };
    }
    if *method != Method::POST {
        return Err(Refused::Method("POST"));
    }
    if origin.is_none() {
        return Err(Refused::Origin);
    }
    // Forms of other sites cannot send this without asking first, which is not answered.
    if only(headers, &CONTENT_TYPE) != Some("application/json") {
        return Err(Refused::Kind);
    }
    Ok(())
}

/// The value of a header that is there once.
fn only<'h>(headers: &'h HeaderMap, name: &HeaderName) -> Option<&'h str> {
    let mut values = headers.get_all(name).iter();
    let value = values.next()?.to_str().ok()?;
    values.next().is_none().then_some(value)
}

/// What every answer is told with.
pub(crate) fn secure(headers: &mut HeaderMap) {
    for (name, value) in [
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (X_FRAME_OPTIONS, "DENY"),
        (REFERRER_POLICY, "no-referrer"),
        (CACHE_CONTROL, "no-store"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
        (
            HeaderName::from_static("permissions-policy"),
            "camera=(), geolocation=(), microphone=(), usb=()",
        ),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(
        method: &Method,
        path: &str,
        headers: &[(&'static str, &'static str)],
    ) -> Result<(), Refused> {
        let mut map = HeaderMap::new();
        for (name, value) in headers {
            map.append(*name, HeaderValue::from_static(value));
        }
        check(method, path, &map, 4117)
    }

    const OWN: (&str, &str) = ("host", "127.0.0.1:4117");
    const ORIGIN: (&str, &str) = ("origin", "http://127.0.0.1:4117");
    const JSON: (&str, &str) = ("content-type", "application/json");

    #[test]
    fn the_page_itself_is_answered() {
        assert_eq!(asked(&Method::GET, "/", &[OWN]), Ok(()));
        assert_eq!(asked(&Method::HEAD, "/", &[("host", "localhost:4117")]), Ok(()));
        assert_eq!(asked(&Method::POST, "/api/solve", &[OWN, ORIGIN, JSON]), Ok(()));
        let own = ("sec-fetch-site", "same-origin");
        assert_eq!(asked(&Method::POST, "/api/solve", &[OWN, ORIGIN, JSON, own]), Ok(()));
        // A link in a letter, or on another site.
        assert_eq!(asked(&Method::GET, "/", &[OWN, ("sec-fetch-site", "cross-site")]), Ok(()));
    }

    #[test]
    fn other_names_are_refused() {
        for host in
            ["evil.example:4117", "127.0.0.1", "127.0.0.1:80", "127.0.0.1.evil.example:4117"]
        {
            assert_eq!(asked(&Method::GET, "/", &[("host", host)]), Err(Refused::Host), "{host}");
        }
        assert_eq!(asked(&Method::GET, "/", &[]), Err(Refused::Host));
        assert_eq!(asked(&Method::GET, "/", &[OWN, ("host", "a")]), Err(Refused::Host));
    }

    #[test]
    fn other_sites_are_refused() {
        let post = |headers: &[(&'static str, &'static str)]| {
            asked(&Method::POST, "/api/solve", &[&[OWN, JSON], headers].concat())
        };
        for origin in
            ["http://evil.example", "null", "http://localhost:4117", "https://127.0.0.1:4117"]
        {
            assert_eq!(post(&[("origin", origin)]), Err(Refused::Origin), "{origin}");
        }
        assert_eq!(post(&[]), Err(Refused::Origin), "who does not say where from is not the page");
        assert_eq!(post(&[ORIGIN, ORIGIN]), Err(Refused::Origin));
        assert_eq!(post(&[ORIGIN, ("sec-fetch-site", "cross-site")]), Err(Refused::Origin));
        let foreign = [OWN, ("origin", "http://evil.example")];
        assert_eq!(asked(&Method::GET, "/", &foreign), Err(Refused::Origin));
    }

    #[test]
    fn other_ways_to_ask_are_refused() {
        let get = asked(&Method::GET, "/api/solve", &[OWN, ORIGIN]);
        assert_eq!(get, Err(Refused::Method("POST")));
        assert_eq!(asked(&Method::POST, "/", &[OWN, ORIGIN]), Err(Refused::Method("GET, HEAD")));
        assert_eq!(
            asked(&Method::OPTIONS, "/api/solve", &[OWN, ORIGIN]),
            Err(Refused::Method("POST"))
        );
        let plain = [OWN, ORIGIN, ("content-type", "text/plain")];
        assert_eq!(asked(&Method::POST, "/api/solve", &plain), Err(Refused::Kind));
        assert_eq!(asked(&Method::POST, "/api/solve", &[OWN, ORIGIN]), Err(Refused::Kind));
    }
}
