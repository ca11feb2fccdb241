//! The types of the scene file, read from their source.

use std::collections::BTreeMap;
use std::path::Path;

use syn::{Attribute, Expr, Fields, GenericArgument, Item, Lit, Meta, PathArguments, Type};

/// A key of a table, or a word of a choice.
pub struct Key {
    /// As a scene spells it.
    pub name: String,
    /// What it takes; none for a word.
    pub value: Option<Value>,
    /// Its comment.
    pub text: String,
}

/// What a key takes.
#[derive(Clone)]
pub enum Value {
    /// A type by its name.
    Named(String),
    /// It may be left out.
    Optional(Box<Value>),
    /// So many of it, where that is fixed.
    List(Box<Value>, Option<String>),
}

impl Value {
    /// The type inside lists and options.
    pub fn name(&self) -> &str {
        match self {
            Self::Named(name) => name,
            Self::Optional(inner) | Self::List(inner, _) => inner.name(),
        }
    }
}

/// A type that scenes are read into.
struct Entry {
    text: String,
    keys: Vec<Key>,
    /// One of its keys stands, not all.
    is_choice: bool,
}

/// All of them, by name.
pub struct Types(BTreeMap<String, Entry>);

impl Types {
    /// Reads the sources in a folder and those below it.
    pub fn read(folder: &Path) -> Self {
        let mut types = Self(BTreeMap::new());
        types.read_folder(folder);
        types
    }

    fn read_folder(&mut self, folder: &Path) {
        let mut paths: Vec<_> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .collect();
        paths.sort();
        for path in paths {
            if path.is_dir() {
                self.read_folder(&path);
            } else {
                let source = std::fs::read_to_string(&path).unwrap();
                syn::parse_file(&source)
                    .unwrap()
                    .items
                    .into_iter()
                    .for_each(|item| self.add(item));
            }
        }
    }

    fn add(&mut self, item: Item) {
        let is_choice = matches!(item, Item::Enum(_));
        let (name, text, keys) = match item {
            Item::Struct(item) => {
                let Fields::Named(fields) = item.fields else {
                    let text = comment(&item.attrs);
                    self.insert(&item.ident, text, Vec::new(), false);
                    return;
                };
                let keys = fields.named.into_iter().map(|field| Key {
                    name: renamed(&field.attrs).unwrap_or_else(|| field.ident.unwrap().to_string()),
                    value: Some(if has_default(&field.attrs) {
                        Value::Optional(Box::new(value(&field.ty)))
                    } else {
                        value(&field.ty)
                    }),
                    text: comment(&field.attrs),
                });
                let keys = keys_of(&item.attrs, keys.collect());
                (item.ident, comment(&item.attrs), keys)
            }
            Item::Enum(item) => {
                let separator = separator(&item.attrs);
                let keys = item.variants.iter().map(|variant| Key {
                    name: spelled(&variant.ident.to_string(), separator),
                    value: variant.fields.iter().next().map(|field| value(&field.ty)),
                    text: comment(&variant.attrs),
                });
                let keys = keys_of(&item.attrs, keys.collect());
                (item.ident, comment(&item.attrs), keys)
            }
            // Numbers within a range: `/// comment` and a name.
            Item::Macro(item) if item.mac.path.is_ident("ranged") => {
                let tokens = item.mac.tokens.to_string();
                let text = tokens
                    .split('"')
                    .nth(1)
                    .unwrap_or_default()
                    .trim()
                    .to_owned();
                let (_, rest) = tokens.split_once(']').unwrap();
                let name = rest.split(',').next().unwrap().trim().to_owned();
                self.0.insert(
                    name,
                    Entry {
                        text,
                        keys: Vec::new(),
                        is_choice: false,
                    },
                );
                return;
            }
            _ => return,
        };
        self.insert(&name, text, keys, is_choice);
    }

    fn insert(&mut self, name: &syn::Ident, text: String, keys: Vec<Key>, is_choice: bool) {
        self.0.entry(name.to_string()).or_insert(Entry {
            text,
            keys,
            is_choice,
        });
    }

    /// The comment of a type.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(|entry| entry.text.as_str())
    }

    /// Keys or words of a type.
    pub fn keys(&self, name: &str) -> &[Key] {
        self.0.get(name).map_or(&[], |entry| &entry.keys)
    }

    /// True for a choice, of which one key stands.
    pub fn is_choice(&self, name: &str) -> bool {
        self.0.get(name).is_some_and(|entry| entry.is_choice)
    }

    /// True for a choice between words alone.
    pub fn is_words(&self, name: &str) -> bool {
        let keys = self.keys(name);
        !keys.is_empty() && keys.iter().all(|key| key.value.is_none())
    }

    /// The types with keys that a scene can hold, from one on.
    pub fn reached_from(&self, name: &str) -> Vec<String> {
        let mut names = vec![name.to_owned()];
        let mut number = 0;
        while number < names.len() {
            for key in self.keys(&names[number].clone()) {
                let inner = key.value.as_ref().map_or("", Value::name).to_owned();
                let is_table = !self.keys(&inner).is_empty() && !self.is_words(&inner);
                if is_table && !names.contains(&inner) {
                    names.push(inner);
                }
            }
            number += 1;
        }
        names
    }
}

fn comment(attributes: &[Attribute]) -> String {
    let lines = attributes
        .iter()
        .filter_map(|attribute| match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Str(text) => Some(text.value().trim().to_owned()),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        });
    lines.collect::<Vec<_>>().join(" ")
}

/// What a scene spells of a type's keys: all where it is read as it stands, and none otherwise.
fn keys_of(attributes: &[Attribute], keys: Vec<Key>) -> Vec<Key> {
    if derives_reading(attributes) && !is_converted(attributes) {
        keys
    } else {
        Vec::new()
    }
}

fn derives_reading(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("derive") => {
            list.tokens.to_string().contains("Deserialize")
        }
        _ => false,
    })
}

/// True of what is read as something else, a number or a word, and made from that.
fn is_converted(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("serde") => {
            list.tokens.to_string().contains("try_from")
        }
        _ => false,
    })
}

/// The word that a field is spelled as where that is not its name.
fn renamed(attributes: &[Attribute]) -> Option<String> {
    attributes
        .iter()
        .find_map(|attribute| match &attribute.meta {
            Meta::List(list) if list.path.is_ident("serde") => {
                let tokens = list.tokens.to_string();
                let (_, word) = tokens.split_once("rename = \"")?;
                Some(word.split_once('"')?.0.to_owned())
            }
            _ => None,
        })
}

/// True of a field that has a value where a scene has none for it.
fn has_default(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("serde") => {
            list.tokens.to_string().starts_with("default")
        }
        _ => false,
    })
}

fn separator(attributes: &[Attribute]) -> char {
    let is_kebab = attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) => list.tokens.to_string().contains("kebab-case"),
        _ => false,
    });
    if is_kebab { '-' } else { '_' }
}

/// `FreeStream` as `free-stream` or `free_stream`.
fn spelled(name: &str, separator: char) -> String {
    let mut text = String::new();
    for (n, letter) in name.chars().enumerate() {
        if letter.is_uppercase() && n > 0 {
            text.push(separator);
        }
        text.extend(letter.to_lowercase());
    }
    text
}

fn value(ty: &Type) -> Value {
    match ty {
        Type::Array(array) => {
            let count = match &array.len {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Int(count) => Some(count.to_string()),
                    _ => None,
                },
                _ => None,
            };
            Value::List(Box::new(value(&array.elem)), count)
        }
        Type::Path(path) => {
            let last = path.path.segments.last().unwrap();
            let inner = match &last.arguments {
                PathArguments::AngleBracketed(arguments) => arguments.args.first(),
                _ => None,
            };
            match (last.ident.to_string().as_str(), inner) {
                ("Option", Some(GenericArgument::Type(inner))) => {
                    Value::Optional(Box::new(value(inner)))
                }
                ("Vec", Some(GenericArgument::Type(inner))) => {
                    Value::List(Box::new(value(inner)), None)
                }
                (name, _) => Value::Named(name.to_owned()),
            }
        }
        _ => Value::Named("?".into()),
    }
}
