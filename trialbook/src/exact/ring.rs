//! A differential ring: generators, the relations among them, and the rules by which they are differentiated.
//!
//! | declared | generators | rule |
//! |---|---|---|
//! | symbol x | x | free: the rate of x is whatever a motion gives it |
//! | angle θ | θ, u = tan(θ/2), h = cos(θ/2) | u′ = (1 + u²)/2 θ′, h² = 1/(1 + u²) |
//! | hyperbolic argument α | α, w = exp(α/2) | w′ = w/2 α′ |
//! | power b^e | P | P′ = P (e b′/b + e′ ln b) |
//! | root b^(1/n) | r | rⁿ = b, r′ = r b′/(n b) |
//! | logarithm ln b | L | L′ = b′/b |
//!
//! The generators are otherwise taken to be independent, so that an element is zero exactly if its numerator
//! is, after the relations are used. Were they dependent, a true identity might be missed; none that is
//! false would be proved. Powers of products are split into products of powers, (x y)^e = x^e y^e: all that
//! is proved holds where the declared bases are positive.

use super::error::ExactError;
use super::expr::Function;
use super::polynomial::Polynomial;
use super::rational::Rational;
use dashu_int::IBig;
use std::collections::{BTreeMap, BTreeSet};

#[derive(Debug, Clone)]
pub(super) enum Rule {
    Constant,
    Free,
    HalfTangent { angle: usize },
    HalfExponential { argument: usize },
    Power { base: Rational, exponent: Rational },
    Root { radicand: Rational, degree: u32 },
    Logarithm { of: Rational },
}

#[derive(Debug, Clone)]
pub(super) struct KnownPower {
    pub base: Rational,
    /// What is looked for in a product: the base's numerator without its content; of a number, nothing.
    pub prime: Option<Polynomial>,
    pub exponent: Rational,
    pub value: Rational,
}

#[derive(Debug, Clone)]
pub(super) struct KnownLogarithm {
    pub base: Rational,
    pub prime: Polynomial,
    pub value: Rational,
}

/// An inverse circular function: function(of) = angle.
#[derive(Debug, Clone)]
pub(super) struct KnownInverse {
    pub function: Function,
    pub of: Rational,
    pub angle: Rational,
}

/// A differential ring over ℚ(π).
#[derive(Debug, Clone)]
pub struct Ring {
    pub(super) names: Vec<String>,
    pub(super) rules: Vec<Rule>,
    symbols: BTreeMap<&'static str, Rational>,
    /// Index of each angle, of its half tangent and of its half cosine.
    pub(super) angles: Vec<[usize; 3]>,
    /// Index of each hyperbolic argument and of its half exponential.
    pub(super) arguments: Vec<[usize; 2]>,
    pub(super) powers: Vec<KnownPower>,
    pub(super) logarithms: Vec<KnownLogarithm>,
    pub(super) inverses: Vec<KnownInverse>,
    supposed: Vec<Rational>,
}

impl Default for Ring {
    fn default() -> Self {
        Self::new()
    }
}

pub(super) const PI: usize = 0;

impl Ring {
    /// The ring ℚ(π).
    pub fn new() -> Self {
        Ring {
            names: vec!["π".into()],
            rules: vec![Rule::Constant],
            symbols: BTreeMap::new(),
            angles: Vec::new(),
            arguments: Vec::new(),
            powers: Vec::new(),
            logarithms: Vec::new(),
            inverses: Vec::new(),
            supposed: Vec::new(),
        }
    }

    /// That ring with free symbols.
    pub fn of(symbols: impl IntoIterator<Item = &'static str>) -> Self {
        let mut ring = Self::new();
        for name in symbols {
            ring.symbol(name);
        }
        ring
    }

    fn generator(&mut self, name: String, rule: Rule) -> usize {
        self.names.push(name);
        self.rules.push(rule);
        self.names.len() - 1
    }

    /// Declares a free symbol, or returns the one of this name.
    pub fn symbol(&mut self, name: &'static str) -> Rational {
        if let Some(known) = self.symbols.get(name) {
            return known.clone();
        }
        let symbol = Rational::generator(self.generator(name.into(), Rule::Free));
        self.symbols.insert(name, symbol.clone());
        symbol
    }

    /// The same for several.
    pub fn symbols<const N: usize>(&mut self, names: [&'static str; N]) -> [Rational; N] {
        names.map(|name| self.symbol(name))
    }

    /// Lets a name stand for an element.
    ///
    /// # Errors
    /// [`ExactError::DeclaredTwice`] if the name has a meaning already.
    pub fn define(&mut self, name: &'static str, value: Rational) -> Result<(), ExactError> {
        if self.symbols.contains_key(name) {
            return Err(ExactError::DeclaredTwice(name.into()));
        }
        self.symbols.insert(name, value);
        Ok(())
    }

    /// Declares an angle, with the tangent and the cosine of its half; a name that is taken keeps what it
    /// stands for.
    pub fn angle(&mut self, name: &'static str) -> Rational {
        let angle = self.symbol(name);
        let Ok(index) = self.free_index(name) else {
            return angle;
        };
        if !self.angles.iter().any(|[known, ..]| *known == index) {
            let tangent =
                self.generator(format!("tan({name}/2)"), Rule::HalfTangent { angle: index });
            let u = Rational::generator(tangent);
            let radicand = (&Rational::int(1) + &u * &u)
                .reciprocal()
                .unwrap_or_else(|| Rational::int(0));
            let root = Rule::Root {
                radicand,
                degree: 2,
            };
            let cosine = self.generator(format!("cos({name}/2)"), root);
            self.angles.push([index, tangent, cosine]);
        }
        angle
    }

    /// The tangent of half an angle that is declared.
    ///
    /// # Errors
    /// [`ExactError::UnknownSymbol`] if there is no such angle.
    pub fn half_tangent(&self, angle: &str) -> Result<Rational, ExactError> {
        let index = self.free_index(angle)?;
        let known = self.angles.iter().find(|[known, ..]| *known == index);
        known
            .map(|[_, tangent, _]| Rational::generator(*tangent))
            .ok_or_else(|| ExactError::UnknownSymbol(angle.into()))
    }

    /// Declares an argument of hyperbolic functions, with the exponential of its half; a name that is taken
    /// keeps what it stands for.
    pub fn hyperbolic(&mut self, name: &'static str) -> Rational {
        let argument = self.symbol(name);
        let Ok(index) = self.free_index(name) else {
            return argument;
        };
        if !self.arguments.iter().any(|[known, _]| *known == index) {
            let rule = Rule::HalfExponential { argument: index };
            let exponential = self.generator(format!("exp({name}/2)"), rule);
            self.arguments.push([index, exponential]);
        }
        argument
    }

    /// Declares base^exponent, for a positive base that is not a number; returns it.
    ///
    /// # Errors
    /// [`ExactError::BadDeclaration`] for a base that is a number.
    pub fn power(&mut self, base: &Rational, exponent: &Rational) -> Result<Rational, ExactError> {
        let [of, to] = [base, exponent].map(|x| self.operand(x));
        let name = format!("{of}^{to}");
        self.prime(base, &name)?;
        let rule = Rule::Power {
            base: base.clone(),
            exponent: exponent.clone(),
        };
        let value = Rational::generator(self.generator(name, rule));
        self.push_power(base, exponent.clone(), value.clone());
        Ok(value)
    }

    /// Declares the positive root of this degree of a positive radicand, which may be a number and has no
    /// root in the ring as it is.
    ///
    /// # Errors
    /// [`ExactError::BadDeclaration`] for degree 0, the radicand 0, and a product of powers of that degree.
    pub fn root(&mut self, radicand: &Rational, degree: u32) -> Result<Rational, ExactError> {
        let name = match degree {
            2 => format!("√{}", self.operand(radicand)),
            _ => format!("{}^(1/{degree})", self.operand(radicand)),
        };
        let rule = Rule::Root {
            radicand: radicand.clone(),
            degree,
        };
        let exponent = self.one_over(degree, &name)?;
        let numerator = radicand.numerator();
        let mut powers = numerator.degrees().into_values().peekable();
        let is_power =
            numerator.len() == 1 && powers.peek().is_some() && powers.all(|k| k % degree == 0);
        if self.is_zero(radicand)? || is_power && radicand.factors().is_empty() {
            return Err(ExactError::BadDeclaration(name));
        }
        let own = Rational::generator(self.generator(name, rule));
        self.push_power(radicand, exponent.clone(), own.clone());
        Ok(own.formed())
    }

    /// Says which element of the ring is the positive root of a radicand.
    ///
    /// # Errors
    /// [`ExactError::BadDeclaration`] for degree 0, or if the value's power is not the radicand.
    pub fn root_is(
        &mut self,
        radicand: &Rational,
        degree: u32,
        value: &Rational,
    ) -> Result<(), ExactError> {
        let name = format!("{}^(1/{degree})", self.operand(radicand));
        let exponent = self.one_over(degree, &name)?;
        if !self.is_zero(&(value.pow(degree) - radicand))? {
            return Err(ExactError::BadDeclaration(name));
        }
        self.push_power(radicand, exponent, value.clone());
        Ok(())
    }

    /// Supposes that an element is positive; what is shown says so.
    pub fn suppose_positive(&mut self, x: Rational) {
        self.supposed.push(x);
    }

    /// By its form: a product of what is supposed to be and of sums that have no negative term.
    pub(super) fn is_positive(&self, x: &Rational) -> Result<bool, ExactError> {
        let mut rest = self.normal(x);
        for of in &self.supposed {
            let prime = self.prime(of, "");
            let k = prime.map_or(0, |prime| rest.valuation(&prime));
            rest = self.divide(&rest, &self.whole_power(of, k)?)?;
        }
        Ok(self.has_positive_terms(&rest))
    }

    fn has_positive_terms(&self, x: &Rational) -> bool {
        let free = |g: usize| {
            let rule = &self.rules[g];
            let own = Rational::generator(g);
            !self.supposed.iter().any(|x| x.is_written_as(&own))
                && matches!(
                    rule,
                    Rule::Free | Rule::HalfTangent { .. } | Rule::Logarithm { .. }
                )
        };
        let of = |p: &Polynomial| {
            p.terms().all(|(powers, c)| {
                let mut powers = powers.iter().enumerate();
                *c > IBig::ZERO && powers.all(|(g, k)| k % 2 == 0 || !free(g))
            })
        };
        let mut below = x.factors().iter();
        !x.is_literally_zero() && of(x.numerator()) && below.all(|(f, k)| k % 2 == 0 || of(f))
    }

    /// What has to be positive for all that is proved. An angle that is there to name another symbol by its
    /// sine or cosine is within the range because it is chosen so.
    pub(super) fn positive(&self) -> BTreeSet<String> {
        let base = |rule: &Rule| match rule {
            Rule::Power { base, .. } | Rule::Logarithm { of: base } => Some(self.text(base)),
            Rule::Root { radicand, .. } => {
                Some(self.text(radicand)).filter(|text| !text.contains(' '))
            }
            _ => None,
        };
        let same = |x: &Rational, y: &Rational| self.is_zero(&(x - y)).unwrap_or(false);
        let named = |x: &Rational| self.symbols.iter().find(|(_, of)| same(x, of));
        let text = |x: &Rational| named(x).map_or_else(|| self.text(x), |(name, _)| (*name).into());
        // A cosine or sine is positive with an angle that is an arcsine or arccosine.
        let beside = |x: &Rational| {
            let mut known = self.inverses.iter();
            known.any(|known| {
                let both = self.circular(&known.angle);
                both.is_ok_and(|(cosine, sine)| match known.function {
                    Function::Asin => same(x, &cosine),
                    _ => same(x, &sine),
                })
            })
        };
        let roots = self.powers.iter().map(|known| &known.value);
        let roots = roots.filter(|x| !self.has_positive_terms(x) && !beside(x));
        let values = roots.chain(&self.supposed).map(text);
        let chosen = |known: &&KnownInverse| named(&known.of).is_none();
        let ends = self.inverses.iter().filter(chosen).flat_map(|known| {
            let (pi, twice) = (Rational::generator(PI), &known.angle * &Rational::int(2));
            let [low, high] = match known.function {
                Function::Asin => [&pi + &twice, &pi - &twice],
                _ => [known.angle.clone(), &pi - &known.angle],
            };
            [low, high].map(|x| self.text(&x))
        });
        let all = self.rules.iter().filter_map(base).chain(values).chain(ends);
        let varies = |base: &String| base.contains(|c: char| c.is_alphabetic() && c != 'π');
        all.filter(varies).collect()
    }

    fn operand(&self, x: &Rational) -> String {
        let text = self.text(x);
        if text.contains([' ', '^', '−']) || text.contains('/') && !text.ends_with(')') {
            format!("({text})")
        } else {
            text
        }
    }

    fn push_power(&mut self, base: &Rational, exponent: Rational, value: Rational) {
        self.powers.push(KnownPower {
            base: base.clone(),
            prime: self.prime(base, "").ok(),
            exponent,
            value,
        });
    }

    fn one_over(&self, degree: u32, name: &str) -> Result<Rational, ExactError> {
        let reciprocal = Rational::int(i64::from(degree)).reciprocal();
        reciprocal.ok_or_else(|| ExactError::BadDeclaration(name.into()))
    }

    /// Declares the logarithm of a positive base that is not a number; returns it.
    ///
    /// # Errors
    /// [`ExactError::BadDeclaration`] for a base that is a number.
    pub fn logarithm(&mut self, base: &Rational) -> Result<Rational, ExactError> {
        let name = format!("ln({})", self.text(base));
        let prime = self.prime(base, &name)?;
        let rule = Rule::Logarithm { of: base.clone() };
        let value = Rational::generator(self.generator(name, rule));
        self.logarithms.push(KnownLogarithm {
            base: base.clone(),
            prime,
            value: value.clone(),
        });
        Ok(value)
    }

    /// Lets arcsin (`Function::Asin`) or arccos (`Function::Acos`) of an element be an angle.
    ///
    /// # Errors
    /// [`ExactError::BadDeclaration`] if the sine or cosine of the angle is not the element.
    pub fn inverse(
        &mut self,
        function: Function,
        of: &Rational,
        angle: &Rational,
    ) -> Result<(), ExactError> {
        let what = format!("{}({})", function.name(), self.text(of));
        let (cosine, sine) = self.circular(angle)?;
        let value = match function {
            Function::Asin => sine,
            Function::Acos => cosine,
            _ => return Err(ExactError::BadDeclaration(what)),
        };
        if !self.is_zero(&(&value - of))? {
            return Err(ExactError::BadDeclaration(what));
        }
        self.inverses.push(KnownInverse {
            function,
            of: of.clone(),
            angle: angle.clone(),
        });
        Ok(())
    }

    fn prime(&self, base: &Rational, name: &str) -> Result<Polynomial, ExactError> {
        let numerator = base.numerator();
        let bad = || ExactError::BadDeclaration(name.into());
        if numerator.as_constant().is_some() {
            return Err(bad());
        }
        let content = Polynomial::constant(numerator.content());
        numerator.divide_exact(&content).ok_or_else(bad)
    }

    /// What a name stands for.
    ///
    /// # Errors
    /// [`ExactError::UnknownSymbol`] if it is not declared.
    pub fn named(&self, name: &str) -> Result<Rational, ExactError> {
        let known = self.symbols.get(name).cloned();
        known.ok_or_else(|| ExactError::UnknownSymbol(name.into()))
    }

    pub(super) fn free_index(&self, name: &str) -> Result<usize, ExactError> {
        let known = self.named(name)?;
        let index = known.generators().next();
        index
            .filter(|g| matches!(self.rules[*g], Rule::Free) && self.names[*g] == name)
            .ok_or_else(|| ExactError::NotFree(name.into()))
    }

    /// Plain text in the names of the generators.
    pub fn text(&self, x: &Rational) -> String {
        x.text(&self.names)
    }
}
