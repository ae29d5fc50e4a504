//! The side of a worker.

use std::io::{Read, Result, Write};
use std::sync::mpsc::channel;

use crate::frame;

/// What answers the page.
pub trait Engine {
    /// The answer to a question of the page, as JSON: `operation` is the last part of `/api/...`, `body` is what was posted. That a question makes no sense is an answer, too.
    fn answer(&mut self, operation: &str, body: &[u8]) -> Vec<u8>;
}

/// Answers what comes from `input`, each question an operation, a line feed and a body, until that ends; then the process ends, too, whatever it is computing: the server is gone.
///
/// # Errors
/// Those of `output`.
pub fn work(
    mut input: impl Read + Send + 'static,
    mut output: impl Write,
    engine: &mut dyn Engine,
) -> Result<()> {
    let (sender, receiver) = channel::<Vec<u8>>();
    let read = move || {
        while let Ok(message) = frame::read(&mut input) {
            if sender.send(message).is_err() {
                return;
            }
        }
        std::process::exit(0);
    };
    std::thread::Builder::new().name("questions".to_owned()).spawn(read)?;
    for message in receiver {
        let cut = message.iter().position(|byte| *byte == b'\n').unwrap_or(message.len());
        let (operation, body) = message.split_at(cut);
        let operation = String::from_utf8_lossy(operation);
        frame::write(&mut output, &engine.answer(&operation, body.get(1..).unwrap_or_default()))?;
    }
    Ok(())
}
