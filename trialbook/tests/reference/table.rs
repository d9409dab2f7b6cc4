//! The answers: comma-separated text below a line of headings.

/// The fields of each row.
pub fn rows<const N: usize>(text: &'static str) -> impl Iterator<Item = [&'static str; N]> {
    text.lines().skip(1).map(|line| {
        let fields: Vec<_> = line.split(',').collect();
        fields.try_into().expect("as many fields as columns")
    })
}

/// A double.
pub fn number(field: &str) -> f64 {
    field.parse().expect("a number")
}
