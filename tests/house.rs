//! The shape of the sources: what each file takes from others goes one way, and those of the solver are short.

use std::collections::BTreeMap;
use std::path::Path;

use syn::{Attribute, Item, Meta, UseTree, Visibility};

/// Where the sources of each package lie.
const PACKAGES: [&str; 6] = [
    "geometry/src",
    "packer/src",
    "solver/src",
    "src",
    "src/compare",
    "validation/src",
];

/// Most lines of a file of the solver.
const LONGEST: usize = 350;

/// Names from the root of a package on.
type Names = Vec<String>;

/// A file: what it takes from others, by the name under which it has it, and whether it only hands that on.
#[derive(Default)]
struct Module {
    uses: Vec<Use>,
}

struct Use {
    name: String,
    path: Names,
    hands_on: bool,
}

/// The files of a package by their names.
struct Package(BTreeMap<Names, Module>);

impl Package {
    fn read(folder: &Path) -> Self {
        let mut package = Self(BTreeMap::new());
        package.read_folder(folder, &Vec::new());
        package
    }

    fn read_folder(&mut self, folder: &Path, names: &Names) {
        let entries = std::fs::read_dir(folder).unwrap();
        for path in entries.map(|entry| entry.unwrap().path()) {
            let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
            let with = |name: &str| [names.clone(), vec![name.to_owned()]].concat();
            // Of packages within it each is one of its own.
            let is_another = stem == "tests" || path.join("Cargo.toml").exists();
            if path.is_dir() && !is_another {
                self.read_folder(&path, &with(&stem));
            } else if !is_another
                && path.extension().is_some_and(|end| end == "rs")
                && stem != "main"
            {
                let names = match stem.as_str() {
                    "lib" | "mod" => names.clone(),
                    _ => with(&stem),
                };
                self.read_file(&path, names);
            }
        }
    }

    fn read_file(&mut self, path: &Path, names: Names) {
        let source = syn::parse_file(&std::fs::read_to_string(path).unwrap()).unwrap();
        let mut module = Module::default();
        for item in source.items {
            if let Item::Use(item) = item
                && !is_of_tests(&item.attrs)
            {
                let hands_on = !matches!(item.vis, Visibility::Inherited);
                module.take(item.tree, None, &names, hands_on);
            }
        }
        self.0.insert(names, module);
    }

    /// The file that defines what a path leads to, if that is of this package.
    fn source(&self, path: &[String], depth: usize) -> Option<Names> {
        let mut here = Vec::new();
        for (n, name) in path.iter().enumerate() {
            let next = [here.clone(), vec![name.clone()]].concat();
            if self.0.contains_key(&next) {
                here = next;
                continue;
            }
            let handed = self.0.get(&here)?.uses.iter().find(|one| one.name == *name);
            let Some(handed) = handed.filter(|_| depth > 0) else {
                break;
            };
            let path = [&handed.path[..], &path[n + 1..]].concat();
            return self.source(&path, depth - 1);
        }
        Some(here)
    }

    /// What each file takes from others.
    fn arrows(&self) -> BTreeMap<&Names, Vec<Names>> {
        let of = |names: &Names, module: &Module| {
            let taken = module.uses.iter().filter(|one| !one.hands_on);
            let sources = taken.filter_map(|one| self.source(&one.path, 8));
            sources.filter(|source| source != names).collect()
        };
        let all = self.0.iter();
        all.map(|(names, module)| (names, of(names, module)))
            .collect()
    }

    /// Files that take from one another in a circle, if any do.
    fn circle(&self) -> Option<Vec<Names>> {
        let mut left = self.arrows();
        // What takes from nothing that is left is on no circle.
        loop {
            let free: Vec<&Names> = left
                .iter()
                .filter(|(_, sources)| !sources.iter().any(|source| left.contains_key(source)))
                .map(|(names, _)| *names)
                .collect();
            if free.is_empty() {
                break;
            }
            left.retain(|names, _| !free.contains(names));
        }
        let (first, _) = left.first_key_value()?;
        let mut way = vec![(*first).clone()];
        loop {
            let sources = &left[way.last()?];
            let next = sources.iter().find(|source| left.contains_key(source))?;
            if let Some(begin) = way.iter().position(|names| names == next) {
                return Some(way.split_off(begin));
            }
            way.push(next.clone());
        }
    }
}

impl Module {
    /// Adds what a `use` of the file of these names takes, from where its `path` has led so far.
    fn take(&mut self, tree: UseTree, path: Option<Names>, names: &Names, hands_on: bool) {
        let ends = |ident: &syn::Ident| [path.clone().unwrap_or_default(), vec![ident.to_string()]];
        match tree {
            UseTree::Path(step) => {
                let path = match (step.ident.to_string().as_str(), path.clone()) {
                    ("crate", None) => Vec::new(),
                    ("self", None) => names.clone(),
                    ("super", None) => names[..names.len() - 1].to_vec(),
                    ("super", Some(path)) => path[..path.len() - 1].to_vec(),
                    (_, Some(_)) => ends(&step.ident).concat(),
                    // Another package.
                    (_, None) => return,
                };
                self.take(*step.tree, Some(path), names, hands_on);
            }
            UseTree::Name(name) => {
                let full = match (name.ident == "self", &path) {
                    (true, Some(path)) => path.clone(),
                    (_, Some(_)) => ends(&name.ident).concat(),
                    (_, None) => return,
                };
                self.add(full.last().cloned().unwrap_or_default(), full, hands_on);
            }
            UseTree::Rename(rename) if path.is_some() => {
                let full = ends(&rename.ident).concat();
                self.add(rename.rename.to_string(), full, hands_on);
            }
            UseTree::Group(group) => {
                for tree in group.items {
                    self.take(tree, path.clone(), names, hands_on);
                }
            }
            UseTree::Glob(_) | UseTree::Rename(_) => {
                if let Some(path) = path {
                    self.add("*".into(), path, hands_on);
                }
            }
        }
    }

    fn add(&mut self, name: String, path: Names, hands_on: bool) {
        self.uses.push(Use {
            name,
            path,
            hands_on,
        });
    }
}

/// True of what is compiled for tests alone.
fn is_of_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        _ => false,
    })
}

#[test]
fn no_files_take_from_one_another_in_a_circle() {
    for folder in PACKAGES {
        let package = Package::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder));
        assert!(package.0.len() > 5, "{folder}");
        let circle = package.circle().map(|circle| {
            let names = circle.iter().map(|names| names.join("::"));
            names.collect::<Vec<_>>().join(" -> ")
        });
        assert_eq!(circle, None, "{folder}");
    }
}

#[test]
fn files_of_the_solver_are_short() {
    fn check(folder: &Path) {
        for path in std::fs::read_dir(folder).unwrap() {
            let path = path.unwrap().path();
            if path.is_dir() {
                check(&path);
            } else {
                let count = std::fs::read_to_string(&path).unwrap().lines().count();
                assert!(count <= LONGEST, "{}: {count}", path.display());
            }
        }
    }
    check(&Path::new(env!("CARGO_MANIFEST_DIR")).join("solver/src"));
}
