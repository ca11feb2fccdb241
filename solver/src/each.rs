//! Short arrays of what each axis has.

/// `value(0)`, `value(1)`, ...: `std::array::from_fn` for plain numbers, in a fifth of the code, which the pair loops have in every dimension
/// and for every instruction set.
#[inline(always)]
pub fn each<T: Copy, const N: usize>(mut value: impl FnMut(usize) -> T) -> [T; N] {
    const { assert!(N > 0, "there is no first value") };
    let mut values = [value(0); N];
    let mut k = 1;
    while k < N {
        values[k] = value(k);
        k += 1;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::each;

    #[test]
    fn every_value_is_asked_for_once_in_order() {
        let mut asked = Vec::new();
        let values: [usize; 3] = each(|k| {
            asked.push(k);
            10 * k
        });
        assert_eq!((values, asked), ([0, 10, 20], vec![0, 1, 2]));
    }
}
