//! The program with its page, and a client of bare sockets that says what it likes.

use std::io::{BufRead, BufReader, ErrorKind, Write};
use std::net::{Shutdown, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_shtaerman");

/// A crowned punch.
pub(crate) const PUNCH: &str = include_str!("../../../../examples/crowned_punch.toml");

/// The page on a port of its own, until it is dropped.
pub(crate) struct Page {
    pub(crate) process: Child,
    pub(crate) port: u16,
}

impl Page {
    pub(crate) fn open(arguments: &[&str]) -> Self {
        let mut command = Command::new(PROGRAM);
        command.args(["explore", "--no-browser"]).args(arguments);
        Self::of(command)
    }

    /// The page of a command.
    pub(crate) fn of(mut command: Command) -> Self {
        let mut process = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(process.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.split('/').nth(2).unwrap();
        let port = address.strip_prefix("127.0.0.1:").unwrap().parse().unwrap();
        Self { process, port }
    }

    /// A connection.
    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream
    }

    /// What comes back for these bytes on a connection of their own.
    pub(crate) fn raw(&self, request: &str) -> Response {
        let mut stream = self.connect();
        stream.write_all(request.as_bytes()).unwrap();
        Response::read(&mut BufReader::new(stream)).unwrap()
    }

    /// What the page itself would ask.
    pub(crate) fn question(&self, operation: &str, body: &str) -> String {
        let port = self.port;
        format!(
            "POST /api/{operation} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        )
    }

    /// The answer to a question of the page.
    pub(crate) fn ask(&self, operation: &str, body: &Value) -> Value {
        let response = self.raw(&self.question(operation, &body.to_string()));
        assert_eq!(response.status, 200, "{}", response.body);
        serde_json::from_str(&response.body).unwrap()
    }

    pub(crate) fn get(&self, path: &str) -> Response {
        self.raw(&format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", self.port))
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// What came back.
#[derive(Debug)]
pub(crate) struct Response {
    pub(crate) status: u16,
    pub(crate) headers: Vec<(String, String)>,
    pub(crate) body: String,
}

impl Response {
    /// None where the connection was ended without one.
    pub(crate) fn read(input: &mut impl BufRead) -> Option<Self> {
        let mut line = String::new();
        let read = input.read_line(&mut line);
        if matches!(&read, Err(error) if error.kind() == ErrorKind::ConnectionReset) {
            return None;
        }
        if read.unwrap() == 0 {
            return None;
        }
        let status = line.split(' ').nth(1).unwrap().parse().unwrap();
        let mut headers = Vec::new();
        loop {
            let mut line = String::new();
            input.read_line(&mut line).unwrap();
            let Some((name, value)) = line.trim_end().split_once(": ") else { break };
            headers.push((name.to_ascii_lowercase(), value.to_owned()));
        }
        let mut response = Self { status, headers, body: String::new() };
        let length = response.header("content-length").map_or(0, |length| length.parse().unwrap());
        let mut body = vec![0; length];
        input.read_exact(&mut body).unwrap();
        response.body = String::from_utf8_lossy(&body).into_owned();
        Some(response)
    }

    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }
}

/// Ends the writing side.
pub(crate) fn finish(stream: &TcpStream) {
    stream.shutdown(Shutdown::Write).unwrap();
}
