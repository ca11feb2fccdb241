//! What somebody may have meant.

/// The most alike that is still a slip of the finger: Jaro and Winkler's measure.
const ALIKE: f64 = 0.8;

/// ` (did you mean ...?)` where one of `names` is much like `word`; nothing where none is.
pub fn nearest(word: &str, names: &[&str]) -> String {
    names
        .iter()
        .map(|name| (strsim::jaro_winkler(word, name), name))
        .filter(|(alike, _)| *alike > ALIKE)
        .max_by(|(a, _), (b, _)| a.total_cmp(b))
        .map_or(String::new(), |(_, name)| {
            format!(" (did you mean `{name}`?)")
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_finds_its_word_and_nonsense_finds_none() {
        let names = ["wedge", "cylinder", "sod"];
        assert_eq!(nearest("wegde", &names), " (did you mean `wedge`?)");
        assert_eq!(nearest("cilinder", &names), " (did you mean `cylinder`?)");
        assert_eq!(nearest("zzz", &names), "");
    }
}
