//! Numbers in the sources of `contact/`: those with a name, and those that stand bare in a comparison.

use std::path::Path;

use syn::visit::{self, Visit};
use syn::{
    Attribute, BinOp, Expr, ExprBinary, ExprMethodCall, ImplItemConst, ItemConst, ItemMod, Lit,
    Meta, TraitItemConst,
};

/// Numbers that need no name.
const PLAIN: [f64; 4] = [0.0, 0.5, 1.0, 2.0];
/// Methods that compare.
const COMPARING: [&str; 4] = ["min", "max", "clamp", "total_cmp"];

/// What a file holds; its tests are left out.
#[derive(Debug, Default)]
pub(crate) struct Numbers {
    /// Names of constants whose value is written with a number: one that is made of others alone is not another.
    pub(crate) named: Vec<String>,
    /// Comparisons with a bare number.
    pub(crate) bare: Vec<String>,
}

impl Numbers {
    /// Those of a source.
    pub(crate) fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path).unwrap();
        Self::of(&text)
    }

    fn of(text: &str) -> Self {
        let mut numbers = Self::default();
        numbers.visit_file(&syn::parse_file(text).unwrap());
        numbers
    }

    fn constant(&mut self, name: &syn::Ident, value: &Expr) {
        if !literals(value).is_empty() {
            self.named.push(name.to_string());
        }
    }

    fn compared<'e>(&mut self, sides: impl IntoIterator<Item = &'e Expr>) {
        let numbers: Vec<f64> = sides.into_iter().flat_map(literals).collect();
        self.bare.extend(
            numbers
                .iter()
                .filter(|number| !number.is_nan() && !PLAIN.contains(number))
                .map(f64::to_string),
        );
    }
}

impl<'a> Visit<'a> for Numbers {
    fn visit_item_mod(&mut self, module: &'a ItemMod) {
        if !module.attrs.iter().any(is_for_tests) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_const(&mut self, constant: &'a ItemConst) {
        self.constant(&constant.ident, &constant.expr);
    }

    fn visit_impl_item_const(&mut self, constant: &'a ImplItemConst) {
        self.constant(&constant.ident, &constant.expr);
    }

    fn visit_trait_item_const(&mut self, constant: &'a TraitItemConst) {
        if let Some((_, value)) = &constant.default {
            self.constant(&constant.ident, value);
        }
    }

    fn visit_expr_binary(&mut self, binary: &'a ExprBinary) {
        use BinOp::{Eq, Ge, Gt, Le, Lt, Ne};
        if matches!(binary.op, Eq(_) | Ge(_) | Gt(_) | Le(_) | Lt(_) | Ne(_)) {
            self.compared([&*binary.left, &*binary.right]);
        }
        visit::visit_expr_binary(self, binary);
    }

    fn visit_expr_method_call(&mut self, call: &'a ExprMethodCall) {
        if COMPARING.iter().any(|name| call.method == name) {
            self.compared(&call.args);
        }
        visit::visit_expr_method_call(self, call);
    }
}

/// The numbers in an expression; one that the standard library has a name for is none that could stand bare.
fn literals(expression: &Expr) -> Vec<f64> {
    struct Literals(Vec<f64>);
    impl<'a> Visit<'a> for Literals {
        fn visit_lit(&mut self, literal: &'a Lit) {
            match literal {
                Lit::Int(number) => self.0.extend(number.base10_parse::<f64>()),
                Lit::Float(number) => self.0.extend(number.base10_parse::<f64>()),
                _ => {}
            }
        }

        fn visit_expr_path(&mut self, path: &'a syn::ExprPath) {
            // One of the standard library is a number as another is.
            if path.path.segments.iter().any(|segment| segment.ident == "consts") {
                self.0.push(f64::NAN);
            }
        }

        // Exponents belong to formulas.
        fn visit_expr_method_call(&mut self, call: &'a ExprMethodCall) {
            if call.method == "powi" {
                self.visit_expr(&call.receiver);
            } else {
                visit::visit_expr_method_call(self, call);
            }
        }

        // Places in arrays and tuples are no thresholds.
        fn visit_expr_index(&mut self, index: &'a syn::ExprIndex) {
            self.visit_expr(&index.expr);
        }

        fn visit_member(&mut self, _: &'a syn::Member) {}
    }
    let mut found = Literals(Vec::new());
    found.visit_expr(expression);
    found.0
}

fn is_for_tests(attribute: &Attribute) -> bool {
    let Meta::List(list) = &attribute.meta else { return false };
    list.path.is_ident("cfg") && list.tokens.to_string() == "test"
}

#[test]
fn numbers_are_found() {
    let found = Numbers::of(
        "const A: f64 = 1e-3; struct S; impl S { const B: [u8; 2] = [3, 4]; } const OTHER: f64 = A; const PI: f64 = std::f64::consts::PI;
         fn f(x: [f64; 4]) -> bool { x[3] < 0.5 && x[0] > 7.0 * A && x[1].max(9.0) == x[2] }
         #[cfg(test)] mod tests { const C: u8 = 3; }",
    );
    assert_eq!(found.named, ["A", "B", "PI"]);
    assert_eq!(found.bare, ["7", "9", "9"]);
}
