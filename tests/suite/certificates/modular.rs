//! Equations hold for numbers modulo a prime, at random points.
//!
//! Nothing of the ring is used. Each formula is read again, each step is made again, with whole numbers modulo p; a
//! derivative is the part of ε in numbers a + bε with ε² = 0. What is false holds at such a point by chance only, about once
//! in 10¹⁸.

use serde_json::Value;
use std::collections::{BTreeMap, HashMap};

/// Primes that are 3 modulo 4: of squares, x^((p+1)/4) is a root.
const PRIMES: [u64; 3] = [(1 << 61) - 1, (1 << 63) - 25, (1 << 32) - 5];

/// Whole roots that are looked for beside declared ones.
const SQUARES: &[u64] = &[1, 2, 3, 4, 5, 6, 8, 9];

/// What this small checker does not know: series, powers beyond products of a few declared ones.
#[derive(Debug)]
pub struct Unknown;

pub type Known<T> = Result<T, Unknown>;

/// Numbers modulo p with several ε: the parts without and with the last ε, each with the others.
type Dual = Vec<u64>;

/// A number; and where it is a sum of multiples of generators, these, as twice the multiple, with the number 1 under `None`.
#[derive(Clone)]
struct Number {
    value: Dual,
    linear: Option<BTreeMap<Option<usize>, i64>>,
}

struct Checker<'a> {
    p: u64,
    witness: &'a Value,
    /// Values of the generators, without and with more and more ε or with values put in.
    worlds: Vec<Vec<Dual>>,
    made: HashMap<(usize, usize), Number>,
}

pub fn list(x: &Value) -> &[Value] {
    x.as_array().map_or(&[], Vec::as_slice)
}

pub fn place(x: &Value) -> usize {
    x.as_u64().unwrap() as usize
}

impl Checker<'_> {
    fn times(&self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.p)) as u64
    }

    fn raised(&self, a: u64, mut n: u64) -> u64 {
        let (mut power, mut square) = (1, a);
        while n > 0 {
            if n & 1 == 1 {
                power = self.times(power, square);
            }
            square = self.times(square, square);
            n >>= 1;
        }
        power
    }

    /// A root of this degree, if there is one.
    fn root(&self, x: u64, degree: u64) -> Option<u64> {
        let p = self.p;
        if degree.is_multiple_of(2) {
            let root = self.raised(x, (p >> 2) + 1);
            // Of a number and its negative one is a square.
            let roots = [root, (p - root) % p].into_iter();
            let roots = roots.filter(|root| self.times(*root, *root) == x);
            return match degree {
                2 => roots.into_iter().next(),
                _ => roots
                    .into_iter()
                    .find_map(|root| self.root(root, degree / 2)),
            };
        }
        // A power that undoes the one to the degree, modulo p − 1.
        let undone = (1..degree).find_map(|k| {
            let n = u128::from(p - 1) * u128::from(k) + 1;
            (n % u128::from(degree) == 0).then_some((n / u128::from(degree)) as u64)
        });
        if degree == 1 {
            Some(x)
        } else {
            undone.map(|n| self.raised(x, n))
        }
    }

    fn whole(&self, text: &str) -> u64 {
        let digits = text.trim_start_matches('-').bytes();
        let size = digits.fold(0, |n, d| (self.times(n, 10) + u64::from(d - b'0')) % self.p);
        if text.starts_with('-') {
            (self.p - size) % self.p
        } else {
            size
        }
    }

    fn add(&self, a: &[u64], b: &[u64]) -> Dual {
        let sum =
            |(a, b): (&u64, &u64)| ((u128::from(*a) + u128::from(*b)) % u128::from(self.p)) as u64;
        a.iter().zip(b).map(sum).collect()
    }

    fn neg(&self, a: &[u64]) -> Dual {
        a.iter().map(|a| (self.p - a) % self.p).collect()
    }

    fn mul(&self, a: &[u64], b: &[u64]) -> Dual {
        if let ([a], [b]) = (a, b) {
            return vec![self.times(*a, *b)];
        }
        let ((a, da), (b, db)) = (a.split_at(a.len() / 2), b.split_at(b.len() / 2));
        let slope = self.add(&self.mul(a, db), &self.mul(da, b));
        [self.mul(a, b), slope].concat()
    }

    fn inverse(&self, a: &[u64]) -> Known<Dual> {
        if let [a] = a {
            return if *a == 0 {
                Err(Unknown)
            } else {
                Ok(vec![self.raised(*a, self.p - 2)])
            };
        }
        let (a, da) = a.split_at(a.len() / 2);
        let inverse = self.inverse(a)?;
        let slope = self.neg(&self.mul(&self.mul(&inverse, &inverse), da));
        Ok([inverse, slope].concat())
    }

    fn power(&self, a: &[u64], n: i64) -> Known<Dual> {
        let one = self.constant(1, a.len());
        let product = (0..n.abs()).fold(one, |power, _| self.mul(&power, a));
        if n < 0 {
            self.inverse(&product)
        } else {
            Ok(product)
        }
    }

    fn constant(&self, n: u64, size: usize) -> Dual {
        let mut dual = vec![0; size];
        dual[0] = n % self.p;
        dual
    }

    fn size(&self, world: usize) -> usize {
        self.worlds[world].first().map_or(1, Vec::len)
    }

    fn polynomial(&self, terms: &Value, of: &[Dual], size: usize) -> Known<Dual> {
        let mut sum = vec![0; size];
        for term in list(terms) {
            let mut product = self.constant(self.whole(term[0].as_str().unwrap()), size);
            for (g, k) in list(&term[1]).iter().enumerate() {
                let k = k.as_u64().unwrap() as i64;
                if k > 0 {
                    product = self.mul(&product, &self.power(of.get(g).ok_or(Unknown)?, k)?);
                }
            }
            sum = self.add(&sum, &product);
        }
        Ok(sum)
    }

    fn element(&self, x: &Value, of: &[Dual], size: usize) -> Known<Number> {
        let number = x["number"].as_str().unwrap();
        let mut below = self.constant(self.whole(number), size);
        for factor in list(&x["below"]) {
            let value = self.polynomial(&factor[0], of, size)?;
            below = self.mul(&below, &self.power(&value, factor[1].as_i64().unwrap())?);
        }
        let above = self.polynomial(&x["above"], of, size)?;
        let simple = list(&x["below"]).is_empty();
        let linear = simple.then(|| linear(&x["above"], number)).flatten();
        Ok(Number {
            value: self.mul(&above, &self.inverse(&below)?),
            linear,
        })
    }

    fn int(&self, n: i64, size: usize) -> Number {
        let linear = Some(BTreeMap::from([(None, 2 * n)]));
        Number {
            value: self.constant(self.whole(&n.to_string()), size),
            linear,
        }
    }

    /// cos and sin, or cosh and sinh, of a sum of half angles.
    fn pair(&self, x: &Number, world: usize, sign: i64) -> Known<[Dual; 2]> {
        let size = self.size(world);
        let (mut c, mut s) = (self.constant(1, size), vec![0; size]);
        let half = self.inverse(&self.constant(2, size))?;
        let rule = if sign < 0 {
            "half-tangent"
        } else {
            "half-exponential"
        };
        for (g, k) in x.linear.as_ref().ok_or(Unknown)? {
            let Some(g) = g else {
                if *k == 0 {
                    continue;
                } else {
                    return Err(Unknown);
                }
            };
            let known = list(&self.witness["generators"]);
            let of = known
                .iter()
                .position(|x| x["rule"] == rule && place(&x["of"]) == *g);
            let (c1, s1) = match of {
                Some(of) if sign < 0 => {
                    let h = self.worlds[world][of + 1].clone();
                    let s = self.mul(&h, &self.worlds[world][of]);
                    (h, s)
                }
                Some(of) => {
                    let up = self.worlds[world][of].clone();
                    let down = self.inverse(&up)?;
                    let both = [self.add(&up, &down), self.add(&up, &self.neg(&down))];
                    let [c, s] = both.map(|x| self.mul(&x, &half));
                    (c, s)
                }
                None if *g == 0 && sign < 0 => (vec![0; size], self.constant(1, size)),
                None => return Err(Unknown),
            };
            let s1 = if *k < 0 { self.neg(&s1) } else { s1 };
            for _ in 0..k.abs() {
                let ss = self.mul(&s, &s1);
                let next = self.add(
                    &self.mul(&c, &c1),
                    &if sign < 0 { self.neg(&ss) } else { ss },
                );
                s = self.add(&self.mul(&c, &s1), &self.mul(&s, &c1));
                c = next;
            }
        }
        Ok([c, s])
    }

    fn read(&self, tree: &Value, world: usize) -> Known<Number> {
        let size = self.size(world);
        if let Some(leaf) = tree.as_str() {
            if let Ok(n) = leaf.parse::<i64>() {
                return Ok(self.int(n, size));
            }
            let own = |x: &Value| x["name"] == leaf || leaf == "π" && x["rule"] == "pi";
            let generators = list(&self.witness["generators"]);
            if let Some(g) = generators.iter().position(own) {
                let linear = Some(BTreeMap::from([(Some(g), 2)]));
                return Ok(Number {
                    value: self.worlds[world][g].clone(),
                    linear,
                });
            }
            let mut symbols = list(&self.witness["symbols"]).iter();
            let symbol = symbols.find(|x| x[0] == leaf).ok_or(Unknown)?;
            return self.element(&symbol[1], &self.worlds[world], size);
        }
        let name = tree[0].as_str().unwrap();
        let x = self.read(&tree[1], world)?;
        if let Some(y) = tree.get(2) {
            return self.joined(name, &x, &self.read(y, world)?, world);
        }
        let plain = |value| Number {
            value,
            linear: None,
        };
        let over = |a: &Dual, b: &Dual| Ok(plain(self.mul(a, &self.inverse(b)?)));
        match name {
            "-" => self.joined("-", &self.int(0, size), &x, world),
            "sin" | "cos" | "tan" | "cot" | "sinh" | "cosh" | "tanh" | "coth" | "exp" => {
                let circular = ["sin", "cos", "tan", "cot"].contains(&name);
                let [c, s] = self.pair(&x, world, if circular { -1 } else { 1 })?;
                match name {
                    "sin" | "sinh" => Ok(plain(s)),
                    "cos" | "cosh" => Ok(plain(c)),
                    "tan" | "tanh" => over(&s, &c),
                    "exp" => Ok(plain(self.add(&c, &s))),
                    _ => over(&c, &s),
                }
            }
            "√" => {
                let half = self.inverse(&self.constant(2, size))?;
                Ok(plain(self.declared(&x.value, &half, world)?))
            }
            "ln" => {
                let known = list(&self.witness["generators"]).iter().enumerate();
                let logarithms = known.filter(|(_, x)| x["rule"] == "logarithm");
                let bases: Known<Vec<_>> = logarithms
                    .map(|(g, of)| {
                        let base = self.element(&of["of"], &self.worlds[world], size)?.value;
                        Ok((base, self.worlds[world][g].clone()))
                    })
                    .collect();
                let bases = bases?;
                let powers = self.product(&x.value, bases.iter().map(|(base, _)| base), &[])?;
                let terms = powers.0.iter().zip(&bases);
                let sum = terms.fold(vec![0; size], |sum, (k, (_, ln))| {
                    self.add(&sum, &self.mul(&self.int(*k, size).value, ln))
                });
                Ok(plain(sum))
            }
            "arcsin" | "arccos" => {
                for known in list(&self.witness["inverses"])
                    .iter()
                    .filter(|k| k["function"] == name)
                {
                    if self.element(&known["of"], &self.worlds[world], size)?.value == x.value {
                        return self.element(&known["is"], &self.worlds[world], size);
                    }
                }
                Err(Unknown)
            }
            _ => Err(Unknown),
        }
    }

    fn joined(&self, name: &str, x: &Number, y: &Number, world: usize) -> Known<Number> {
        let size = self.size(world);
        let constant = |x: &Number| {
            let linear = x.linear.as_ref()?;
            let only = linear.keys().all(Option::is_none);
            only.then(|| linear.get(&None).copied().unwrap_or(0))
        };
        let scaled = |x: &Number, n: i64, m: i64| {
            let terms = x.linear.as_ref()?.iter();
            let scale = |(g, k): (&Option<usize>, &i64)| {
                (m != 0 && k * n % m == 0).then(|| (*g, k * n / m))
            };
            terms.map(scale).collect::<Option<BTreeMap<_, _>>>()
        };
        let sum = |sign: i64| {
            let mut sum = x.linear.clone()?;
            for (g, k) in y.linear.as_ref()? {
                *sum.entry(*g).or_insert(0) += sign * k;
            }
            Some(sum)
        };
        let (value, linear) = match name {
            "+" => (self.add(&x.value, &y.value), sum(1)),
            "-" => (self.add(&x.value, &self.neg(&y.value)), sum(-1)),
            "*" => {
                let linear = match (constant(x), constant(y)) {
                    (Some(n), _) => scaled(y, n, 2),
                    (_, Some(n)) => scaled(x, n, 2),
                    _ => None,
                };
                (self.mul(&x.value, &y.value), linear)
            }
            "/" => {
                let linear = constant(y).and_then(|n| scaled(x, 2, n));
                (self.mul(&x.value, &self.inverse(&y.value)?), linear)
            }
            "^" => match constant(y) {
                Some(n) if n % 2 == 0 && n.abs() < 200 => (self.power(&x.value, n / 2)?, None),
                _ => (self.declared(&x.value, &y.value, world)?, None),
            },
            _ => return Err(Unknown),
        };
        debug_assert_eq!(value.len(), size);
        Ok(Number { value, linear })
    }

    /// x^e by the powers that are declared: e = n t + m with their exponent t, and x a product of their bases and of a number
    /// whose root is whole.
    fn declared(&self, x: &[u64], e: &[u64], world: usize) -> Known<Dual> {
        let size = self.size(world);
        if *x == self.constant(1, size) {
            return Ok(x.to_vec());
        }
        let values = &self.worlds[world];
        let half = self.inverse(&self.constant(2, size))?;
        let mut known: Vec<[Dual; 3]> = Vec::new();
        for (g, x) in list(&self.witness["generators"]).iter().enumerate() {
            let of = |key: &str| Ok::<_, Unknown>(self.element(&x[key], values, size)?.value);
            let to = match (x["rule"].as_str(), x["degree"].as_u64()) {
                (Some("root"), Some(degree)) => self.inverse(&self.constant(degree, size))?,
                (Some("power"), _) => of("to")?,
                _ => continue,
            };
            known.push([of("of")?, to, values[g].clone()]);
        }
        for x in list(&self.witness["powers"]) {
            let of = |key: &str| Ok::<_, Unknown>(self.element(&x[key], values, size)?.value);
            known.push([of("of")?, of("to")?, of("is")?]);
        }
        let exponents: Vec<_> = known.iter().map(|[_, to, _]| to.clone()).collect();
        for to in exponents {
            for n in (1..=4).flat_map(|n| [n, -n]) {
                let rest = self.add(e, &self.neg(&self.mul(&self.int(n, size).value, &to)));
                let Some(m) = (-8..=8).find(|m| self.int(*m, size).value == rest) else {
                    continue;
                };
                let of: Vec<_> = known.iter().filter(|[_, t, _]| *t == to).collect();
                let squares = if to == half { SQUARES } else { &[1] };
                let bases = of.iter().map(|[base, ..]| base);
                if let Ok((powers, number)) = self.product(x, bases, squares) {
                    let mut roots = powers.iter().zip(&of);
                    let product =
                        roots.try_fold(number, |product, (k, [.., is])| -> Known<Dual> {
                            Ok(self.mul(&product, &self.power(is, *k)?))
                        })?;
                    return Ok(self.mul(&self.power(&product, n)?, &self.power(x, m)?));
                }
            }
        }
        Err(Unknown)
    }

    /// Powers of the bases whose product is x, but for the square of a ratio of the numbers in `roots`, and that ratio.
    fn product<'b>(
        &self,
        x: &[u64],
        bases: impl Iterator<Item = &'b Dual>,
        roots: &[u64],
    ) -> Known<(Vec<i64>, Dual)> {
        let bases: Vec<_> = bases.collect();
        let few = if bases.len() > 4 { 1 } else { 2 };
        let mut powers = vec![-few; bases.len()];
        let one = vec![1];
        let roots = if roots.is_empty() { &one } else { roots };
        loop {
            let mut product = self.constant(1, x.len());
            for (base, k) in bases.iter().zip(&powers) {
                product = self.mul(&product, &self.power(base, *k)?);
            }
            let rest = self.mul(x, &self.inverse(&product)?);
            if rest[1..].iter().all(|x| *x == 0) {
                for (n, m) in roots
                    .iter()
                    .flat_map(|n| roots.iter().map(move |m| (*n, *m)))
                {
                    if self.times(rest[0], m * m) == n * n % self.p {
                        let [n, m] = [n, m].map(|n| self.constant(n, x.len()));
                        return Ok((powers, self.mul(&n, &self.inverse(&m)?)));
                    }
                }
            }
            let Some(i) = powers.iter().position(|k| *k < few) else {
                return Err(Unknown);
            };
            powers[i] += 1;
            powers[..i].fill(-few);
        }
    }

    /// A world in which the generators move with these rates.
    fn moving(&mut self, world: usize, rates: &[(usize, Dual)]) -> Known<usize> {
        let size = self.size(world);
        let mut all: Vec<Dual> = Vec::new();
        for (g, x) in list(&self.witness["generators"]).iter().enumerate() {
            let own = self.worlds[world][g].clone();
            let of = |key: &str| Ok::<_, Unknown>(self.element(&x[key], &all, 2 * size)?.value);
            let half = self.inverse(&self.constant(2, size))?;
            let slope = |x: &Dual| x[size..].to_vec();
            let relative =
                |x: &Dual| Ok::<_, Unknown>(self.mul(&slope(x), &self.inverse(&x[..size])?));
            let rate = match x["rule"].as_str().unwrap() {
                "free" => rates
                    .iter()
                    .find(|(free, _)| *free == g)
                    .map_or(vec![0; size], |(_, rate)| rate.clone()),
                "half-tangent" => {
                    let turn = self.add(&self.constant(1, size), &self.mul(&own, &own));
                    self.mul(&self.mul(&turn, &half), &slope(&all[place(&x["of"])]))
                }
                "half-exponential" => {
                    self.mul(&self.mul(&own, &half), &slope(&all[place(&x["of"])]))
                }
                "root" => {
                    let degree = self.constant(x["degree"].as_u64().unwrap(), size);
                    self.mul(
                        &self.mul(&own, &relative(&of("of")?)?),
                        &self.inverse(&degree)?,
                    )
                }
                "logarithm" => relative(&of("of")?)?,
                "power" => {
                    let to = of("to")?;
                    if slope(&to).iter().any(|x| *x != 0) {
                        return Err(Unknown);
                    }
                    self.mul(&own, &self.mul(&to[..size], &relative(&of("of")?)?))
                }
                _ => vec![0; size],
            };
            all.push([own, rate].concat());
        }
        self.worlds.push(all);
        Ok(self.worlds.len() - 1)
    }

    fn part(&mut self, i: usize, world: usize) -> Known<Number> {
        if let Some(known) = self.made.get(&(world, i)) {
            return Ok(known.clone());
        }
        let (name, of) = self.witness["parts"][i]
            .as_object()
            .unwrap()
            .iter()
            .next()
            .unwrap();
        let plain = |value| Number {
            value,
            linear: None,
        };
        let number = match name.as_str() {
            "element" => self.element(of, &self.worlds[world], self.size(world))?,
            "read" => self.read(of, world)?,
            "negative" => {
                let x = self.part(place(of), world)?;
                plain(self.neg(&x.value))
            }
            "sum" | "difference" | "product" | "quotient" | "raised" => {
                let [x, y] = [0, 1].map(|side| self.part(place(&of[side]), world));
                let sign = match name.as_str() {
                    "sum" => "+",
                    "difference" => "-",
                    "product" => "*",
                    "quotient" => "/",
                    _ => "^",
                };
                self.joined(sign, &x?, &y?, world)?
            }
            "derivative" => {
                let values: Known<Vec<_>> = list(&of[1])
                    .iter()
                    .map(|pair| Ok((place(&pair[0]), self.part(place(&pair[1]), world)?.value)))
                    .collect();
                let (values, size) = (values?, self.size(world));
                let moving = self.moving(world, &values)?;
                plain(self.part(place(&of[0]), moving)?.value[size..].to_vec())
            }
            "put" => {
                let mut values = self.worlds[world].clone();
                let put: Vec<_> = list(&of[1]).iter().map(|pair| place(&pair[0])).collect();
                for (g, x) in list(&self.witness["generators"]).iter().enumerate() {
                    // What is made of them would have to change too.
                    if !put.contains(&g) && put.iter().any(|g| occurs(&x["of"], *g)) {
                        return Err(Unknown);
                    }
                }
                for pair in list(&of[1]) {
                    values[place(&pair[0])] = self.part(place(&pair[1]), world)?.value;
                }
                self.worlds.push(values);
                plain(self.part(place(&of[0]), self.worlds.len() - 1)?.value)
            }
            _ => return Err(Unknown),
        };
        self.made.insert((world, i), number.clone());
        Ok(number)
    }
}

/// Whether a generator occurs in an element.
fn occurs(x: &Value, g: usize) -> bool {
    let has = |terms: &Value| {
        let exponents = list(terms).iter().map(|term| &term[1][g]);
        exponents
            .into_iter()
            .any(|k| k.as_u64().is_some_and(|k| k > 0))
    };
    has(&x["above"]) || list(&x["below"]).iter().any(|factor| has(&factor[0]))
}

/// Twice the multiples of generators in a polynomial over a number, if it is a sum of such.
fn linear(terms: &Value, number: &str) -> Option<BTreeMap<Option<usize>, i64>> {
    let number: i64 = number.parse().ok()?;
    let term = |term: &Value| {
        let exponents: Vec<_> = list(&term[1]).iter().map(|k| k.as_u64().unwrap()).collect();
        let g = exponents.iter().position(|k| *k > 0);
        let twice = 2 * term[0].as_str().unwrap().parse::<i64>().ok()?;
        let whole = exponents.iter().sum::<u64>() <= 1 && twice % number == 0;
        whole.then_some((g, twice / number))
    };
    list(terms).iter().map(term).collect()
}

/// A checker at a random point, where all roots have values.
fn checker<'a>(witness: &'a Value, random: &mut fastrand::Rng) -> Option<Checker<'a>> {
    for attempt in 0..3000 {
        let p = PRIMES[attempt / 1000];
        let mut checker = Checker {
            p,
            witness,
            worlds: vec![Vec::new()],
            made: HashMap::new(),
        };
        let mut values: Vec<Dual> = Vec::new();
        for x in list(&witness["generators"]) {
            let value = match (x["rule"].as_str()?, x["degree"].as_u64()) {
                ("root", Some(degree)) => {
                    let radicand = checker.element(&x["of"], &values, 1).ok();
                    radicand.and_then(|x| checker.root(x.value[0], degree))
                }
                _ => Some(random.u64(1..p)),
            };
            match value {
                Some(value) => values.push(vec![value]),
                None => break,
            }
        }
        if values.len() == list(&witness["generators"]).len() {
            checker.worlds = vec![values];
            return Some(checker);
        }
    }
    None
}

/// Whether all that is said to be equal is; `Err` if that is beyond this checker.
pub fn holds(witness: &Value, random: &mut fastrand::Rng) -> Known<bool> {
    let mut checker = checker(witness, random).ok_or(Unknown)?;
    let all = list(&witness["equal"]);
    for (i, equal) in all.iter().enumerate() {
        let left = checker.part(place(&equal["left"]), 0)?.value;
        let right = match equal["right"].as_u64() {
            Some(right) => checker.part(right as usize, 0)?.value,
            None => vec![0],
        };
        // A disproof ends with what is not equal.
        let fails = witness["fails"] == true && i + 1 == all.len();
        if (left == right) == fails {
            return Ok(false);
        }
    }
    Ok(true)
}
