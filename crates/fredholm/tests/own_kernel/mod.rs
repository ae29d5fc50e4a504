//! Kernels of a user's own: the two examples against published values, limits and closed forms.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]
#![allow(unreachable_pub, reason = "modules of examples")]

#[path = "../../examples/layer/main.rs"]
mod layer_example;
#[path = "../../examples/love/main.rs"]
mod love_example;

mod layer;
mod love;

#[test]
fn the_examples_run() {
    layer_example::main().unwrap();
    love_example::main().unwrap();
}
