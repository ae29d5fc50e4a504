//! Lets the linker of macOS leave the interpreter's own functions open: they are there when the module is loaded.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
