//! How vectors are added.

use super::*;

#[test]
fn vectors_are_added_component_by_component() {
    let [a, b, c] = Expr::symbols(["a", "b", "c"]);
    assert_eq!(body::sum([a, b, c], [c, a, b]), [a + c, b + a, c + b]);
}
