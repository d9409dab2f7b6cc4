use super::formula;

#[test]
fn plain_formulas_become_latex() {
    for (plain, latex) in [
        ("tan(θ/2)^2 λ by (1)", r"\tan^{2} (\theta/2) \lambda"),
        ("μ₊ g/A₀ = λ₀, so", r"\frac{\mu_{+} g}{A_{0}} = \lambda_{0}"),
        ("dv_x/dt by", r"\mathrm dv_{x}/\mathrm dt"),
        ("d²x/dτ² is", r"\mathrm d^{2}x/\mathrm d\tau^{2}"),
        ("A dt/dθ by", r"A\, \mathrm dt/\mathrm d\theta"),
        ("tan(θ/2)^λ/2", r"\frac{\tan^{\lambda} (\theta/2)}{2}"),
        ("√(R/(μ g)) ω_z", r"\sqrt{\frac{R}{\mu g}} \omega_{z}"),
        ("p (cos χ, sin χ)", r"p (\cos \chi, \sin \chi)"),
        ("(σ − 1)^(−2) 0", r"(\sigma - 1)^{-2}\cdot 0"),
        ("φ̃₂ + π", r"\tilde{\phi}_{2} + \pi"),
        ("sin²K of", r"\sin^{2} K"),
        ("v₀y", r"v_{0y}"),
        ("w/|w| at", r"w/\lvert w\rvert "),
        ("θ = -2.5", r"\theta = -2.5"),
        ("x₂ₖ t²ᵏ", r"x_{2k} t^{2k}"),
        ("e^(2α)", r"e^{2 \alpha}"),
        ("1e-20 < λ", r"10^{-20} < \lambda"),
        ("ψ a word", r"\psi"),
    ] {
        let read = formula(plain).map(|(sides, _)| sides.join(" "));
        assert_eq!(read.as_deref(), Some(latex), "{plain}");
    }
}

#[test]
fn words_are_no_formulas() {
    for plain in [
        "a sine",
        "A rest",
        "(13)",
        "(6) or (7)",
        "12 points",
        "s2-x",
        "eq20_stop_time(λ)",
        "e.g. λ",
        "x-axis",
        "do",
        "B, positive",
        "3.5",
        "sine",
        "I see",
        "−1",
        "it's",
        "",
    ] {
        assert_eq!(formula(plain), None, "{plain}");
    }
}

#[test]
fn whatever_is_given_is_read_soon() {
    for part in ["d(", "√", "sin ", "x(", "[", "−", "|", "^(", "∂(d(", "λ^"] {
        formula(&part.repeat(3000));
    }
}
