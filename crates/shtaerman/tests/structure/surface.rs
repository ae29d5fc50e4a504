//! What a user of a crate can name, one line each.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use quote::ToTokens;
use syn::punctuated::Punctuated;
use syn::{
    Attribute, Fields, ImplItem, Item, ItemImpl, ItemTrait, ItemUse, Meta, Token, TraitItem, Type,
    UseTree, Visibility,
};

use crate::modules::{Found, Modules, attributes, name_of};

/// The lines of a crate: every public item that a path of public names leads to, with its signature, its fields, methods and traits. What a macro of the crate
/// makes is not seen.
pub(crate) fn surface(name: &str, root: &Path) -> BTreeSet<String> {
    let modules = Modules::read(root);
    let mut surface = Surface { modules, paths: BTreeMap::new(), lines: BTreeSet::new() };
    surface.walk(name, &[], &mut Vec::new());
    surface.write();
    surface.lines
}

/// A name by which something is exported, and the path that it stands for.
type Export = (String, Vec<String>);

struct Surface {
    modules: Modules,
    /// The public paths of each item.
    paths: BTreeMap<Found, BTreeSet<String>>,
    lines: BTreeSet<String>,
}

impl Surface {
    /// Notes what the module offers under the path `shown`.
    fn walk(&mut self, shown: &str, module: &[String], above: &mut Vec<Vec<String>>) {
        if above.iter().any(|other| other == module) {
            return;
        }
        above.push(module.to_vec());
        for item in self.modules.content(module).to_vec() {
            if !is_shown(attributes(&item)) {
                continue;
            }
            match &item {
                Item::Use(export) if is_public(&export.vis) => {
                    self.follow(shown, module, export, above);
                }
                Item::Mod(child) if is_public(&child.vis) && is_shown(&child.attrs) => {
                    let name = child.ident.to_string();
                    let path = [module, std::slice::from_ref(&name)].concat();
                    self.walk(&format!("{shown}::{name}"), &path, above);
                }
                other => {
                    if let Some(name) = name_of(other).filter(|_| is_public(visibility(other))) {
                        let path = format!("{shown}::{name}");
                        let found = Found::Item(module.to_vec(), name);
                        self.paths.entry(found).or_default().insert(path);
                    }
                }
            }
        }
        above.pop();
    }

    /// Notes what `pub use` offers.
    fn follow(
        &mut self,
        shown: &str,
        module: &[String],
        export: &ItemUse,
        above: &mut Vec<Vec<String>>,
    ) {
        let (mut exports, mut globs) = (Vec::new(), Vec::new());
        flatten(&export.tree, &[], &mut exports, &mut globs);
        for (name, path) in exports {
            let found = self.modules.locate(module, &path);
            if found.is_empty() {
                self.lines.insert(format!("pub use {shown}::{name} = {}", path.join("::")));
            }
            for found in found {
                if !self.is_public(&found) {
                    continue;
                }
                let shown = format!("{shown}::{name}");
                match found {
                    Found::Module(path) => self.walk(&shown, &path, above),
                    item @ Found::Item(..) => {
                        self.paths.entry(item).or_default().insert(shown);
                    }
                }
            }
        }
        for path in globs {
            for found in self.modules.locate(module, &path) {
                if let Found::Module(path) = found {
                    self.walk(shown, &path, above);
                }
            }
        }
    }

    /// Of two things of one name only the public one is exported.
    fn is_public(&self, found: &Found) -> bool {
        match found {
            Found::Item(..) => self.items(found).any(|item| is_public(visibility(item))),
            Found::Module(path) => path.split_last().is_some_and(|(name, above)| {
                self.modules.content(above).iter().any(|item| {
                    matches!(item, Item::Mod(child) if child.ident == name.as_str() && is_public(&child.vis))
                })
            }),
        }
    }

    fn items(&self, found: &Found) -> impl Iterator<Item = &Item> {
        let (module, name) = match found {
            Found::Item(module, name) => (module.as_slice(), name.as_str()),
            Found::Module(_) => (&[] as &[String], ""),
        };
        let items = self.modules.content(module).iter();
        items.filter(move |item| name_of(item).is_some_and(|own| own == name))
    }

    /// The path that stands for an item: the shortest.
    fn path(&self, found: &Found) -> Option<&str> {
        let paths = self.paths.get(found)?;
        paths.iter().map(String::as_str).min_by_key(|path| (path.matches("::").count(), *path))
    }

    fn write(&mut self) {
        let mut lines = Vec::new();
        for (found, paths) in &self.paths {
            let Some(path) = self.path(found) else { continue };
            let others = paths.iter().filter(|other| *other != path);
            lines.extend(others.map(|other| format!("pub use {other} = {path}")));
            for item in self.items(found) {
                write_item(&mut lines, path, item);
            }
        }
        for (module, items) in self.modules.contents() {
            for item in items {
                if let Item::Impl(block) = item {
                    self.write_impl(&mut lines, module, block);
                }
            }
        }
        self.lines.extend(lines);
    }

    /// The public methods of a type, or the trait that it has.
    fn write_impl(&self, lines: &mut Vec<String>, module: &[String], block: &ItemImpl) {
        let own = self.path_of(module, named(&block.self_ty));
        let Some(path) = own.as_deref() else {
            // A trait of the crate for what is not of it.
            let of = block.trait_.as_ref().and_then(|(name, _)| self.path_of(module, Some(name)));
            if of.is_some() {
                lines.push(header(block, &text(&block.self_ty)));
            }
            return;
        };
        if block.trait_.is_some() {
            lines.push(header(block, path));
            return;
        }
        let (generics, _, bounds) = block.generics.split_for_impl();
        let around = format!("{}{}", text(generics), text(bounds));
        let around = if around.is_empty() { around } else { format!("impl{around} ") };
        for item in &block.items {
            let (attributes, visibility, shown) = match item {
                ImplItem::Fn(item) => (&item.attrs, &item.vis, text(&item.sig)),
                ImplItem::Const(item) => {
                    (&item.attrs, &item.vis, format!("const {}: {}", item.ident, text(&item.ty)))
                }
                _ => continue,
            };
            if is_public(visibility) && is_shown(attributes) {
                lines.push(format!("{path}: {around}pub {shown}"));
            }
        }
    }

    fn path_of(&self, module: &[String], path: Option<&syn::Path>) -> Option<String> {
        let names: Vec<String> =
            path?.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let found = self.modules.locate(module, &names);
        found.iter().find_map(|found| self.path(found)).map(str::to_owned)
    }
}

/// The lines of an item without what `impl` blocks add.
fn write_item(lines: &mut Vec<String>, path: &str, item: &Item) {
    let traits = derived(attributes(item));
    if !traits.is_empty() {
        lines.push(format!("{path}: derive({traits})"));
    }
    let closed = attributes(item).iter().any(|found| found.path().is_ident("non_exhaustive"));
    let closed = if closed { "#[non_exhaustive] " } else { "" };
    match item {
        Item::Fn(item) => lines.push(format!("{path}: pub {}", text(&item.sig))),
        Item::Const(item) => lines.push(format!("{path}: pub const {}", text(&item.ty))),
        Item::Static(item) => lines.push(format!("{path}: pub static {}", text(&item.ty))),
        Item::Type(item) => {
            lines.push(format!("{path}: pub type {}{}", text(&item.generics), text(&item.ty)));
        }
        Item::Struct(item) => {
            let (generics, _, bounds) = item.generics.split_for_impl();
            let kind = format!("{closed}pub struct{}{}", text(generics), text(bounds));
            lines.push(format!("{path}: {kind}"));
            write_fields(lines, path, &item.fields, is_public);
        }
        Item::Enum(item) => {
            let (generics, _, bounds) = item.generics.split_for_impl();
            lines.push(format!("{path}: {closed}pub enum{}{}", text(generics), text(bounds)));
            for variant in &item.variants {
                let place = format!("{path}::{}", variant.ident);
                lines.push(format!("{place}: variant"));
                write_fields(lines, &place, &variant.fields, |_| true);
            }
        }
        Item::Trait(item) => write_trait(lines, path, item),
        _ => {}
    }
}

fn write_fields(
    lines: &mut Vec<String>,
    path: &str,
    fields: &Fields,
    is_seen: impl Fn(&Visibility) -> bool,
) {
    for (index, field) in fields.iter().enumerate().filter(|(_, field)| is_seen(&field.vis)) {
        let name = field.ident.as_ref().map_or_else(|| index.to_string(), ToString::to_string);
        lines.push(format!("{path}.{name}: {}", text(&field.ty)));
    }
}

fn write_trait(lines: &mut Vec<String>, path: &str, item: &ItemTrait) {
    let above = if item.supertraits.is_empty() { String::new() } else { text(&item.supertraits) };
    let (generics, _, bounds) = item.generics.split_for_impl();
    lines.push(format!("{path}: pub trait{}: {above}{}", text(generics), text(bounds)));
    for item in &item.items {
        let shown = match item {
            TraitItem::Fn(item) => {
                let kind = if item.default.is_some() { "provided" } else { "required" };
                format!("{kind} {}", text(&item.sig))
            }
            TraitItem::Const(item) => format!("const {}: {}", item.ident, text(&item.ty)),
            TraitItem::Type(item) => format!("type {}", item.ident),
            _ => continue,
        };
        lines.push(format!("{path}: {shown}"));
    }
}

/// `impl Trait for path`.
fn header(block: &ItemImpl, path: &str) -> String {
    let (generics, _, bounds) = block.generics.split_for_impl();
    let of = block.trait_.as_ref().map_or_else(String::new, |(name, _)| text(name));
    format!("{path}: impl{} {of}{}", text(generics), text(bounds))
}

/// The path of a type that has one, behind references.
fn named(kind: &Type) -> Option<&syn::Path> {
    match kind {
        Type::Path(path) if path.qself.is_none() => Some(&path.path),
        _ => None,
    }
}

/// The traits that are derived, sorted.
fn derived(attributes: &[Attribute]) -> String {
    let mut names = BTreeSet::new();
    for attribute in attributes.iter().filter(|found| found.path().is_ident("derive")) {
        let parse = Punctuated::<Meta, Token![,]>::parse_terminated;
        let found = attribute.parse_args_with(parse).into_iter().flatten();
        names.extend(found.map(|name| text(&name)));
    }
    names.into_iter().collect::<Vec<_>>().join(", ")
}

fn flatten(
    tree: &UseTree,
    before: &[String],
    exports: &mut Vec<Export>,
    globs: &mut Vec<Vec<String>>,
) {
    let longer = |name: &syn::Ident| [before, &[name.to_string()]].concat();
    match tree {
        UseTree::Path(path) => flatten(&path.tree, &longer(&path.ident), exports, globs),
        UseTree::Group(group) => {
            group.items.iter().for_each(|tree| flatten(tree, before, exports, globs));
        }
        UseTree::Glob(_) => globs.push(before.to_vec()),
        UseTree::Name(name) if name.ident == "self" => {
            exports.extend(before.last().map(|last| (last.clone(), before.to_vec())));
        }
        UseTree::Name(name) => exports.push((name.ident.to_string(), longer(&name.ident))),
        UseTree::Rename(name) => exports.push((name.rename.to_string(), longer(&name.ident))),
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// Whether the documentation shows it.
fn is_shown(attributes: &[Attribute]) -> bool {
    !attributes.iter().any(|attribute| {
        attribute.path().is_ident("doc")
            && attribute.parse_args::<syn::Ident>().is_ok_and(|said| said == "hidden")
    })
}

fn visibility(item: &Item) -> &Visibility {
    match item {
        Item::Const(item) => &item.vis,
        Item::Enum(item) => &item.vis,
        Item::Fn(item) => &item.vis,
        Item::Static(item) => &item.vis,
        Item::Struct(item) => &item.vis,
        Item::Trait(item) => &item.vis,
        Item::Type(item) => &item.vis,
        _ => &Visibility::Inherited,
    }
}

/// The spaces that tokens have between them and people do not write, in the order in which they are taken away.
const SPACES: &[(&str, &str)] = &[
    (" ::", "::"),
    (":: ", "::"),
    (" <", "<"),
    ("< ", "<"),
    (" >", ">"),
    (" ,", ","),
    (" :", ":"),
    (" ;", ";"),
    ("& ", "&"),
    (" (", "("),
    ("( ", "("),
    (" )", ")"),
    ("[ ", "["),
    (" ]", "]"),
    (" &", "&"),
    (",)", ")"),
    (",>", ">"),
    (":&", ": &"),
    ("->(", "-> ("),
    ("->&", "-> &"),
    (",(", ", ("),
    (",&", ", &"),
    (":(", ": ("),
    ("'a(", "'a ("),
    ("? S", "?S"),
];

/// Tokens as one line.
fn text(tokens: impl ToTokens) -> String {
    let line = tokens.to_token_stream().to_string().replace('\n', " ");
    SPACES.iter().fold(line, |line, (from, to)| line.replace(from, to))
}
