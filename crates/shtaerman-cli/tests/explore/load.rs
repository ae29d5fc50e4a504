//! Many at once.

use std::io::{BufReader, Write};
use std::thread::scope;

use serde_json::{Value, json};

use crate::explore::client::{PUNCH, Page, Response};

const AT_ONCE: usize = 50;
const EACH: usize = 20;

/// 1,000 questions, 50 at once, each answered with its own answer.
#[test]
fn a_thousand_questions_at_fifty_at_once_and_none_is_lost() {
    let page = Page::open(&[]);
    let answered: usize = scope(|threads| {
        let clients: Vec<_> = (0..AT_ONCE)
            .map(|client| {
                let page = &page;
                threads.spawn(move || {
                    let mut stream = page.connect();
                    let mut input = BufReader::new(stream.try_clone().unwrap());
                    (0..EACH)
                        .filter(|index| {
                            let force = 1e5 + 1e3 * (client * EACH + index) as f64;
                            let toml = PUNCH.replace("\"0.8 MN/m\"", &force.to_string());
                            let body = json!({ "name": "x.toml", "toml": toml }).to_string();
                            stream.write_all(page.question("solve", &body).as_bytes()).unwrap();
                            let told = Response::read(&mut input).unwrap();
                            assert_eq!(told.status, 200, "{}", told.body);
                            let answer: Value = serde_json::from_str(&told.body).unwrap();
                            answer["answer"]["physical"]["force"] == json!(force)
                        })
                        .count()
                })
            })
            .collect();
        clients.into_iter().map(|client| client.join().unwrap()).sum()
    });
    assert_eq!(answered, AT_ONCE * EACH);
}

/// More connections than are kept at once wait, and are served.
#[test]
fn more_connections_than_there_are_places_wait() {
    let page = Page::open(&[]);
    let streams: Vec<_> = (0..200).map(|_| page.connect()).collect();
    let request = format!(
        "GET /icon.svg HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n\r\n",
        page.port
    );
    let served = streams.into_iter().filter_map(|mut stream| {
        stream.write_all(request.as_bytes()).unwrap();
        Response::read(&mut BufReader::new(stream)).filter(|told| told.status == 200)
    });
    assert_eq!(served.count(), 200);
}
