use super::*;

/// x² − 2.
fn square(x: &Ball) -> Option<[Ball; 2]> {
    Some([x * x - Ball::int(2, x.bits()), x + x])
}

#[test]
fn a_root_has_its_digits() {
    let root = refine(square, Interval::new(1.0, 2.0), 400).unwrap();
    assert_eq!(
        root.value.decimal(60).unwrap(),
        "1.414213562373095048801688724209698078569671875376948073176680"
    );
    assert!(root.value.known_bits() > 390);
    let same = Ball::int(2, 400).sqrt().unwrap();
    assert!(same.meets(&root.value));
}

#[test]
fn no_root_no_proof() {
    for (lo, hi) in [(1.5, 2.0), (-1.0, 2.0), (0.0, 1.4), (1.25, 1.25)] {
        assert!(
            refine(square, Interval::new(lo, hi), 100).is_err(),
            "{lo} {hi}"
        );
    }
}
