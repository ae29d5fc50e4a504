//! The modules of a crate: which file holds what, and which file names what of which other.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Macro, UseTree};

/// A name in scope that stands for a longer path.
type Alias = Vec<String>;

/// Of each file the files that it imports, each with the names that are imported.
pub(crate) type Imports = BTreeMap<PathBuf, BTreeMap<PathBuf, BTreeSet<String>>>;

/// A module, be it a file or a block within one.
#[derive(Default)]
struct Module {
    file: PathBuf,
    children: BTreeSet<String>,
    items: BTreeSet<String>,
    aliases: BTreeMap<String, Alias>,
    globs: Vec<Alias>,
    /// Paths that the code of the module names, each from its first segment on.
    named: BTreeSet<Alias>,
    /// All that is written in it.
    content: Vec<Item>,
}

/// What a path leads to, by the path of the module it stands in and its name.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Found {
    Item(Vec<String>, String),
    Module(Vec<String>),
}

/// All modules of a crate, tests left out, by their paths from the root of the crate.
#[derive(Default)]
pub(crate) struct Modules {
    by_path: BTreeMap<Vec<String>, Module>,
}

impl Modules {
    /// Reads a crate from the file of its root, `lib.rs` or `main.rs`.
    pub(crate) fn read(root: &Path) -> Self {
        let mut modules = Self::default();
        modules.read_file(root, &root.with_file_name(""), &[]);
        modules
    }

    fn read_file(&mut self, file: &Path, folder: &Path, path: &[String]) {
        let text = std::fs::read_to_string(file)
            .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let parsed =
            syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        self.read_items(&parsed.items, file, folder, path);
    }

    fn read_items(&mut self, items: &[Item], file: &Path, folder: &Path, path: &[String]) {
        let mut module = Module { file: file.to_owned(), ..Module::default() };
        let mut reader = Reader { module: &mut module, inner: Vec::new() };
        for item in items {
            reader.visit_item(item);
        }
        let inner = reader.inner;
        for item in items {
            module.items.extend(name_of(item));
        }
        for child in inner {
            let name = child.ident.to_string();
            module.children.insert(name.clone());
            let child_path = [path, std::slice::from_ref(&name)].concat();
            let inside = folder.join(&name);
            match &child.content {
                Some((_, items)) => self.read_items(items, file, &inside, &child_path),
                None => {
                    let own = inside.join("mod.rs");
                    let file = if own.exists() { own } else { inside.with_extension("rs") };
                    self.read_file(&file, &inside, &child_path);
                }
            }
        }
        module.content = items.to_vec();
        self.by_path.insert(path.to_vec(), module);
    }

    /// What is written in each module.
    pub(crate) fn contents(&self) -> impl Iterator<Item = (&[String], &[Item])> {
        self.by_path.iter().map(|(path, module)| (path.as_slice(), module.content.as_slice()))
    }

    /// What is written in a module.
    pub(crate) fn content(&self, path: &[String]) -> &[Item] {
        self.by_path.get(path).map_or(&[], |module| &module.content)
    }

    /// Every file with the files that define what it names, and the paths by which it does.
    pub(crate) fn imports(&self) -> Imports {
        let mut imports = Imports::new();
        for (path, module) in &self.by_path {
            let found = imports.entry(module.file.clone()).or_default();
            for named in module.named.iter().chain(module.aliases.values()).chain(&module.globs) {
                let target = self.resolve(path, named);
                if let Some(target) = target.filter(|target| *target != module.file) {
                    found.entry(target).or_default().insert(named.join("::"));
                }
            }
        }
        imports
    }

    /// The file in which what a path stands for is defined; none for other crates and for modules as a whole.
    fn resolve(&self, from: &[String], path: &[String]) -> Option<PathBuf> {
        let found = self.locate(from, path);
        let place = found.iter().find_map(|found| match found {
            Found::Item(place, _) => self.by_path.get(place),
            Found::Module(_) => None,
        });
        place.map(|module| module.file.clone())
    }

    /// What a path stands for: an item, a module, or both of the same name; nothing for other crates.
    pub(crate) fn locate(&self, from: &[String], path: &[String]) -> Vec<Found> {
        self.follow(from, path, 0)
    }

    fn follow(&self, from: &[String], path: &[String], depth: usize) -> Vec<Found> {
        const DEEPEST: usize = 32;
        if depth > DEEPEST {
            return Vec::new();
        }
        let mut place = from.to_vec();
        let mut rest = path;
        loop {
            match rest.first().map(String::as_str) {
                Some("crate") => place.clear(),
                Some("self") => {}
                Some("super") => drop(place.pop()),
                _ => break,
            }
            rest = &rest[1..];
        }
        while let Some((name, after)) = rest.split_first() {
            let Some(module) = self.by_path.get(&place) else { return Vec::new() };
            let child = [place.as_slice(), std::slice::from_ref(name)].concat();
            let is_child = module.children.contains(name);
            let is_item = module.items.contains(name);
            // An associated item or a variant is found by its type.
            if is_item && (after.is_empty() || !is_child) {
                let also = is_child.then_some(Found::Module(child));
                return also.into_iter().chain([Found::Item(place, name.clone())]).collect();
            }
            if is_child {
                place = child;
                rest = after;
                continue;
            }
            if let Some(alias) = module.aliases.get(name).filter(|alias| *alias != path) {
                return self.follow(&place, &[alias, after].concat(), depth + 1);
            }
            let through = |glob: &Alias| self.follow(&place, &[glob, rest].concat(), depth + 1);
            let globs = module.globs.iter().filter(|glob| *glob != path);
            let found = globs.map(through).find(|found| !found.is_empty());
            return found.unwrap_or_default();
        }
        vec![Found::Module(place)]
    }
}

/// Collects what one module names, without what only tests see.
struct Reader<'m, 's> {
    module: &'m mut Module,
    inner: Vec<&'s ItemMod>,
}

impl<'s> Visit<'s> for Reader<'_, 's> {
    fn visit_item(&mut self, item: &'s Item) {
        if attributes(item).iter().any(is_for_tests) {
            return;
        }
        match item {
            Item::Mod(child) => self.inner.push(child),
            other => visit::visit_item(self, other),
        }
    }

    fn visit_item_use(&mut self, item: &'s ItemUse) {
        self.add(&item.tree, &[]);
    }

    fn visit_path(&mut self, path: &'s syn::Path) {
        if path.leading_colon.is_none() && path.segments.len() > 1 {
            let names = path.segments.iter().map(|segment| segment.ident.to_string());
            self.module.named.insert(names.collect());
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, found: &'s Macro) {
        self.add_tokens(&found.tokens);
    }
}

impl Reader<'_, '_> {
    fn add(&mut self, tree: &UseTree, before: &[String]) {
        let longer = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            UseTree::Path(path) => self.add(&path.tree, &longer(&path.ident)),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.add(tree, before)),
            UseTree::Glob(_) => self.module.globs.push(before.to_vec()),
            UseTree::Name(name) if name.ident == "self" => {
                if let Some(last) = before.last() {
                    self.module.aliases.insert(last.clone(), before.to_vec());
                }
            }
            UseTree::Name(name) => {
                self.module.aliases.insert(name.ident.to_string(), longer(&name.ident));
            }
            UseTree::Rename(name) => {
                self.module.aliases.insert(name.rename.to_string(), longer(&name.ident));
            }
        }
    }

    /// Paths inside a macro, which is not parsed: names with `::` between them.
    fn add_tokens(&mut self, tokens: &TokenStream) {
        let mut path = Alias::new();
        let mut colons = 0;
        let finish = |path: &mut Alias, named: &mut BTreeSet<Alias>| {
            let path = std::mem::take(path);
            if path.len() > 1 {
                named.insert(path);
            }
        };
        for token in tokens.clone() {
            match token {
                TokenTree::Punct(sign) if sign.as_char() == ':' => colons += 1,
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        finish(&mut path, &mut self.module.named);
                    }
                    path.push(name.to_string());
                    colons = 0;
                }
                other => {
                    finish(&mut path, &mut self.module.named);
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.add_tokens(&group.stream());
                    }
                }
            }
        }
        finish(&mut path, &mut self.module.named);
    }
}

fn is_for_tests(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg")
        && attribute.parse_args::<syn::Ident>().is_ok_and(|condition| condition == "test")
}

pub(crate) fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

pub(crate) fn name_of(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}
