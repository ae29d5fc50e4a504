//! Potentials and solutions against closed forms.

mod potentials;
mod rough;
mod smooth;
