//! Dependencies between the files of a crate, from the imports and paths in the syntax trees of its modules.

use proc_macro2::{Spacing, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, UseTree};

/// A path as written, or the path of a module below the root of its crate.
type Names = Vec<String>;

/// Names that one file uses of another. The key is the using file and the used one.
pub type Uses = BTreeMap<(String, String), BTreeSet<String>>;

/// Modules of a crate by path.
#[derive(Default)]
struct Modules(BTreeMap<Names, Module>);

/// Content of a module. Modules inside a file have the same `file`.
#[derive(Default)]
struct Module {
    file: String,
    /// Names of its own items.
    items: BTreeSet<String>,
    /// Names imported by `use`, public or not, with the path of each.
    imports: BTreeMap<String, Names>,
    /// Modules of which it imports everything.
    globs: Vec<Names>,
    /// All other paths in it, and the paths of its private imports. A public import alone is a re-export and not a use.
    paths: BTreeSet<Names>,
}

/// Uses between the files of a crate, without unit tests. `root`: first file of the crate, such as `src/lib.rs`. `read`
/// returns the text of a file, `None` if it does not exist.
///
/// # Panics
/// A file is not Rust.
pub fn uses(root: &str, read: &dyn Fn(&str) -> Option<String>) -> Uses {
    let mut modules = Modules::default();
    let directory = root.rsplit_once('/').map_or("", |(directory, _)| directory);
    let text = read(root).unwrap_or_else(|| panic!("no file {root}"));
    let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("{root}: {error}"));
    Reader { read, modules: &mut modules, path: Vec::new(), file: root, children: directory.to_owned() }
        .module(&file.items);
    modules.uses()
}

impl Modules {
    fn uses(&self) -> Uses {
        let mut uses = Uses::new();
        for (path, module) in &self.0 {
            let globs = module.globs.iter().filter_map(|glob| self.module_at(path, glob));
            let names = module.paths.iter().filter_map(|used| self.item(path, used, 0));
            let all = globs.map(|module| (module, "*".to_owned())).chain(names);
            for (from, name) in all.filter(|(from, _)| from.file != module.file) {
                uses.entry((module.file.clone(), from.file.clone())).or_default().insert(name);
            }
        }
        uses
    }

    /// Module at which `path`, written in the module `at`, starts, and the rest of the path. `None` for other crates
    /// and for names of the module itself.
    fn start<'a>(&self, at: &[String], path: &'a [String]) -> Option<(Names, &'a [String])> {
        let mut start = at.to_vec();
        match path.first()?.as_str() {
            "crate" => Some((Vec::new(), &path[1..])),
            "self" => Some((start, &path[1..])),
            "super" => {
                let mut rest = path;
                while rest.first().is_some_and(|name| name == "super") {
                    start.pop();
                    rest = &rest[1..];
                }
                Some((start, rest))
            }
            first => {
                start.push(first.to_owned());
                let known = self.0.contains_key(&start);
                start.pop();
                known.then_some((start, path))
            }
        }
    }

    /// Module that defines the item at the end of `path`, and the name of the item. Follows at most 16 re-exports.
    /// `None` for modules and for items of other crates.
    fn item(&self, at: &[String], path: &[String], followed: usize) -> Option<(&Module, String)> {
        if followed > 16 {
            return None;
        }
        let through = |at: &[String], import: &Names, rest: &[String]| {
            let whole: Names = import.iter().chain(rest).cloned().collect();
            self.item(at, &whole, followed + 1)
        };
        let Some((mut place, mut rest)) = self.start(at, path) else {
            let import = self.0.get(at)?.imports.get(path.first()?)?;
            return through(at, import, &path[1..]);
        };
        loop {
            let module = self.0.get(&place)?;
            let (name, after) = rest.split_first()?;
            // If a module and an item have the same name, the last part of a path refers to the item.
            if let Some(import) = module.imports.get(name)
                && (after.is_empty() || !self.0.contains_key(&[place.as_slice(), &rest[..1]].concat()))
            {
                return through(&place, import, after);
            }
            place.push(name.clone());
            if !self.0.contains_key(&place) {
                place.pop();
                if !module.items.contains(name)
                    && let Some(found) = module.globs.iter().find_map(|glob| {
                        let from = self.module_at(&place, glob)?;
                        from.items.contains(name).then_some(from)
                    })
                {
                    return Some((found, name.clone()));
                }
                return Some((module, name.clone()));
            }
            rest = after;
        }
    }

    /// Module with this path, written in the module `at`.
    fn module_at(&self, at: &[String], path: &[String]) -> Option<&Module> {
        let (start, rest) = self.start(at, path)?;
        self.0.get(&[start.as_slice(), rest].concat())
    }
}

/// Reader of one module.
struct Reader<'a> {
    read: &'a dyn Fn(&str) -> Option<String>,
    modules: &'a mut Modules,
    path: Names,
    file: &'a str,
    /// Folder of the files of its child modules.
    children: String,
}

impl Reader<'_> {
    fn module(&mut self, items: &[Item]) {
        self.here().file = self.file.to_owned();
        for item in items {
            if let Some(name) = name_of(item) {
                self.here().items.insert(name);
            }
            self.visit_item(item);
        }
    }

    fn here(&mut self) -> &mut Module {
        self.modules.0.entry(self.path.clone()).or_default()
    }

    fn import(&mut self, tree: &UseTree, before: &mut Names, public: bool) {
        let (name, alias) = match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.import(&path.tree, before, public);
                before.pop();
                return;
            }
            UseTree::Group(group) => {
                for tree in &group.items {
                    self.import(tree, before, public);
                }
                return;
            }
            UseTree::Glob(_) => {
                let path = before.clone();
                self.here().globs.push(path);
                return;
            }
            UseTree::Name(name) => (name.ident.to_string(), name.ident.to_string()),
            UseTree::Rename(rename) => (rename.ident.to_string(), rename.rename.to_string()),
        };
        let mut path = before.clone();
        let alias = if name == "self" && alias == "self" { path.last().cloned().unwrap_or_default() } else { alias };
        if name != "self" {
            path.push(name);
        }
        if !public {
            self.here().paths.insert(path.clone());
        }
        // `use name;` of a child module adds no further name.
        if path.as_slice() != [alias.clone()] {
            self.here().imports.insert(alias, path);
        }
    }

    /// Collects the paths in the arguments of a macro.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path = Names::new();
        // Number of colons after the last name of the path.
        let mut colons = 0;
        for tree in tokens {
            match tree {
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.path(std::mem::take(&mut path));
                    }
                    path.push(name.to_string());
                    colons = 0;
                }
                TokenTree::Punct(mark) if mark.as_char() == ':' && !path.is_empty() => {
                    colons = if colons == 0 && mark.spacing() == Spacing::Joint { 1 } else { 2 * colons };
                    if colons == 0 {
                        self.path(std::mem::take(&mut path));
                    }
                }
                other => {
                    self.path(std::mem::take(&mut path));
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.tokens(group.stream());
                    }
                }
            }
        }
        self.path(path);
    }

    fn path(&mut self, path: Names) {
        if !path.is_empty() {
            self.here().paths.insert(path);
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if !attributes_of(item).iter().any(is_for_tests) {
            visit::visit_item(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if !item.attrs.iter().any(is_for_tests) {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        let name = item.ident.to_string();
        let path = [self.path.as_slice(), std::slice::from_ref(&name)].concat();
        let children = format!("{}/{name}", self.children);
        if let Some((_, items)) = &item.content {
            Reader { read: self.read, modules: self.modules, path, file: self.file, children }.module(items);
            return;
        }
        let files = [format!("{children}.rs"), format!("{children}/mod.rs")];
        let found = files.iter().find_map(|file| (self.read)(file).map(|text| (file, text)));
        let (file, text) = found.unwrap_or_else(|| panic!("{} declares `{name}`, which has no file", self.file));
        let items = syn::parse_file(&text).unwrap_or_else(|error| panic!("{file}: {error}")).items;
        Reader { read: self.read, modules: self.modules, path, file, children }.module(&items);
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.import(&item.tree, &mut Names::new(), !matches!(item.vis, syn::Visibility::Inherited));
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.path(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        self.visit_path(&called.path);
        self.tokens(called.tokens.clone());
    }

    // `pub(in crate::fits)` and attributes are not uses.
    fn visit_vis_restricted(&mut self, _: &'ast syn::VisRestricted) {}
    fn visit_attribute(&mut self, _: &'ast Attribute) {}
}

fn is_for_tests(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg")
        && attribute
            .meta
            .require_list()
            .is_ok_and(|list| list.tokens.to_string().replace("all (", "").starts_with("test"))
}

fn attributes_of(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Name under which other modules find an item.
fn name_of(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}
