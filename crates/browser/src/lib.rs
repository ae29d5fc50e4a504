//! The engine of the page, compiled for a browser: `question` makes room for a question, the page writes it there, `answer` computes, and `answer_at` says where the answer is.
//!
//! The three are called one after the other from one thread. A question is the operation, a line feed, and what a server would be posted; an answer is JSON.
#![cfg(target_family = "wasm")]

use std::cell::RefCell;
use std::time::Duration;

use shtaerman_cli::PageEngine;
use shtaerman_explore::Engine;

/// The state of the one thread there is.
struct State {
    engine: PageEngine,
    question: Vec<u8>,
    answer: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::new(State {
        // There is no clock: the page ends what takes too long, and begins anew.
        engine: PageEngine::new(Duration::MAX),
        question: Vec::new(),
        answer: Vec::new(),
    });
}

/// Makes room for a question of this length and tells where it is.
#[expect(unsafe_code, reason = "the browser finds it by this name")]
#[unsafe(no_mangle)]
pub extern "C" fn question(length: usize) -> *mut u8 {
    STATE.with_borrow_mut(|state| {
        state.question.clear();
        state.question.resize(length, 0);
        state.question.as_mut_ptr()
    })
}

/// Answers the question that was written and tells the length of the answer.
#[expect(unsafe_code, reason = "the browser finds it by this name")]
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    STATE.with_borrow_mut(|state| {
        let question = std::mem::take(&mut state.question);
        let cut = question.iter().position(|byte| *byte == b'\n').unwrap_or(question.len());
        let (operation, body) = question.split_at(cut);
        let operation = String::from_utf8_lossy(operation);
        state.answer = state.engine.answer(&operation, body.get(1..).unwrap_or_default());
        state.answer.len()
    })
}

/// Tells where the answer is.
#[expect(unsafe_code, reason = "the browser finds it by this name")]
#[unsafe(no_mangle)]
pub extern "C" fn answer_at() -> *const u8 {
    STATE.with_borrow(|state| state.answer.as_ptr())
}
