//! Where a file's changes stand in its syntax, and what is written there so that they can be switched.

use crate::list::Mutant;
use proc_macro2::Span;
use std::collections::BTreeMap;
use std::ops::Range;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, Pat};

/// What a place becomes. The numbers are those of its changes, with what each puts there.
pub enum Kind {
    /// `l op r`, numbers or what behaves so: both sides once.
    Arithmetic(String),
    /// `l < r` and its kin: both sides once, by reference.
    Comparison(String),
    /// `l && r`, `l || r`: the right side only where it counts.
    Logic { and: bool },
    /// `l op= r`.
    Assignment(String),
    /// `-x`, `!x`.
    Unary(String),
    /// The start of a function's body.
    Body,
    /// The start of the body of a function that returns some iterator: the hole is the body without its braces.
    Iterator,
    /// The end of an arm's pattern, where no guard follows.
    Arm,
    /// A guard. The first numbers are of the arm itself.
    Guard,
    /// The value of a field, where another struct gives the rest.
    Field {
        name: String,
        rest: String,
        shorthand: bool,
    },
    /// Other text: a constant with changes in it becomes a function.
    Text(String),
    /// A `match` some of whose arms can be taken out; nothing changes there.
    Match,
}

/// A place of changes.
pub struct Site {
    pub kind: Kind,
    /// All of it, in bytes.
    pub range: Range<usize>,
    /// The parts that stay, in which there may be more places.
    pub holes: Vec<Range<usize>>,
    pub ids: Vec<(u32, String)>,
}

/// A field of a claim's row, which is constant: the claim is changed when the list of topics is made.
pub struct Row {
    pub id: u32,
    pub claim: String,
    pub field: String,
}

#[derive(Default)]
pub struct Found {
    pub sites: Vec<Site>,
    pub rows: Vec<Row>,
    /// Changes in constants.
    pub constant: Vec<u32>,
    /// Changes that the compiler rejects wherever they are made: `||` after `let`.
    pub chains: Vec<u32>,
    /// Values of functions whose type is hidden within another.
    pub hidden: Vec<u32>,
}

type Place = (usize, usize);

struct Finder<'a> {
    text: &'a str,
    /// The changes of the file by place.
    open: BTreeMap<(Place, bool), Vec<&'a Mutant>>,
    constant: bool,
    /// The constants that became functions.
    lifted: Vec<String>,
    found: Found,
}

/// The places of the changes of a file; what is left of them was not found.
pub fn find<'a>(text: &'a str, mutants: &[&'a Mutant]) -> syn::Result<(Found, Vec<&'a Mutant>)> {
    let mut open = BTreeMap::<_, Vec<_>>::new();
    for m in mutants {
        open.entry((m.start, m.genre == "FnValue"))
            .or_default()
            .push(*m);
    }
    let mut finder = Finder {
        text,
        open,
        constant: false,
        lifted: Vec::new(),
        found: Found::default(),
    };
    let file = syn::parse_file(text)?;
    finder.visit_file(&file);
    Uses {
        names: &finder.lifted,
        sites: &mut finder.found.sites,
    }
    .visit_file(&file);
    let left = finder.open.into_values().flatten().collect();
    Ok((finder.found, left))
}

/// Line and column as the list has them.
fn place(span: Span) -> Place {
    let start = span.start();
    (start.line, start.column + 1)
}

/// True if a condition of `if` or `while` binds names.
fn binds(expr: &Expr) -> bool {
    match expr {
        Expr::Let(_) => true,
        Expr::Binary(b) if matches!(b.op, BinOp::And(_)) => binds(&b.left) || binds(&b.right),
        _ => false,
    }
}

impl<'a> Finder<'a> {
    fn take(&mut self, span: Span, value: bool, genres: &[&str]) -> Vec<(u32, String)> {
        let key = (place(span), value);
        let Some(here) = self.open.remove(&key) else {
            return Vec::new();
        };
        let (mine, other): (Vec<_>, Vec<_>) = here
            .into_iter()
            .partition(|m| genres.contains(&m.genre.as_str()));
        if !other.is_empty() {
            self.open.insert(key, other);
        }
        mine.iter().map(|m| (m.id, m.replacement.clone())).collect()
    }

    fn add(
        &mut self,
        kind: Kind,
        range: Range<usize>,
        holes: Vec<Range<usize>>,
        ids: Vec<(u32, String)>,
    ) {
        if ids.is_empty() {
        } else if self.constant {
            self.found.constant.extend(ids.iter().map(|(id, _)| id));
        } else {
            self.found.sites.push(Site {
                kind,
                range,
                holes,
                ids,
            });
        }
    }

    fn body(&mut self, output: &syn::ReturnType, block: &syn::Block) {
        let Some(first) = block.stmts.first() else {
            return;
        };
        let ids = self.take(first.span(), true, &["FnValue"]);
        let at = first.span().byte_range().start;
        let end = block.brace_token.span.close().byte_range().start;
        let (some, inside) = match output {
            syn::ReturnType::Type(_, t) => (
                matches!(**t, syn::Type::ImplTrait(_)),
                self.text[bytes(t)].contains("impl "),
            ),
            syn::ReturnType::Default => (false, false),
        };
        if inside && !some {
            self.found.hidden.extend(ids.iter().map(|(id, _)| id));
        } else if some {
            self.add(
                Kind::Iterator,
                at..end,
                std::iter::once(at..end).collect(),
                ids,
            );
        } else {
            self.add(Kind::Body, at..at, vec![], ids);
        }
    }

    fn within(&mut self, constant: bool, visit: impl FnOnce(&mut Self)) {
        let before = std::mem::replace(&mut self.constant, constant);
        visit(self);
        self.constant = before;
    }

    fn row(&self, s: &syn::ExprStruct, ids: &[(u32, String)], field: &str) -> Vec<Row> {
        let named = |f: &&syn::FieldValue| matches!(&f.member, syn::Member::Named(n) if n == "id");
        let claim = s.fields.iter().find(named).and_then(|f| match &f.expr {
            Expr::Lit(syn::ExprLit {
                lit: syn::Lit::Str(text),
                ..
            }) => Some(text.value()),
            _ => None,
        });
        let of_claim = s.path.is_ident("Claim") && self.constant;
        let Some(claim) = claim.filter(|_| of_claim) else {
            return Vec::new();
        };
        let row = |(id, _): &(u32, String)| Row {
            id: *id,
            claim: claim.clone(),
            field: field.to_owned(),
        };
        ids.iter().map(row).collect()
    }
}

fn bytes(of: &impl Spanned) -> Range<usize> {
    of.span().byte_range()
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_item_fn(&mut self, f: &'ast syn::ItemFn) {
        self.within(f.sig.constness.is_some(), |me| {
            me.body(&f.sig.output, &f.block);
            visit::visit_item_fn(me, f);
        });
    }

    fn visit_impl_item_fn(&mut self, f: &'ast syn::ImplItemFn) {
        self.within(f.sig.constness.is_some(), |me| {
            me.body(&f.sig.output, &f.block);
            visit::visit_impl_item_fn(me, f);
        });
    }

    fn visit_trait_item_fn(&mut self, f: &'ast syn::TraitItemFn) {
        self.within(false, |me| {
            if let Some(block) = &f.default {
                me.body(&f.sig.output, block);
            }
            visit::visit_trait_item_fn(me, f);
        });
    }

    fn visit_item_const(&mut self, c: &'ast syn::ItemConst) {
        let lines = c.expr.span().start().line..=c.expr.span().end().line;
        let changes = self.open.keys().any(|((line, _), _)| lines.contains(line));
        let private = matches!(c.vis, syn::Visibility::Inherited);
        let ty = &self.text[bytes(&c.ty)];
        let lift =
            changes && private && !self.constant && !ty.contains('&') && !ty.contains("Statement");
        if lift {
            self.lifted.push(c.ident.to_string());
            let text = |range: Range<usize>, text: String| Site {
                kind: Kind::Text(text),
                range,
                holes: vec![],
                ids: vec![],
            };
            let until = bytes(&c.expr).start;
            self.found.sites.extend([
                text(bytes(&c.const_token), "fn".into()),
                text(
                    bytes(&c.colon_token).start..until,
                    format!("() -> {ty} {{ "),
                ),
                text(bytes(&c.semi_token), " }".into()),
            ]);
        }
        self.within(!lift, |me| visit::visit_item_const(me, c));
    }

    fn visit_impl_item_const(&mut self, c: &'ast syn::ImplItemConst) {
        self.within(true, |me| visit::visit_impl_item_const(me, c));
    }

    fn visit_trait_item_const(&mut self, c: &'ast syn::TraitItemConst) {
        self.within(true, |me| visit::visit_trait_item_const(me, c));
    }

    fn visit_item_static(&mut self, s: &'ast syn::ItemStatic) {
        self.within(true, |me| visit::visit_item_static(me, s));
    }

    fn visit_variant(&mut self, v: &'ast syn::Variant) {
        self.within(true, |me| visit::visit_variant(me, v));
    }

    fn visit_type_array(&mut self, t: &'ast syn::TypeArray) {
        self.within(true, |me| visit::visit_type_array(me, t));
    }

    fn visit_expr_repeat(&mut self, r: &'ast syn::ExprRepeat) {
        self.visit_expr(&r.expr);
        self.within(true, |me| me.visit_expr(&r.len));
    }

    fn visit_generic_argument(&mut self, g: &'ast syn::GenericArgument) {
        self.within(true, |me| visit::visit_generic_argument(me, g));
    }

    fn visit_expr_const(&mut self, c: &'ast syn::ExprConst) {
        self.within(true, |me| visit::visit_expr_const(me, c));
    }

    fn visit_pat(&mut self, p: &'ast Pat) {
        self.within(true, |me| visit::visit_pat(me, p));
    }

    fn visit_expr_closure(&mut self, c: &'ast syn::ExprClosure) {
        self.within(false, |me| visit::visit_expr_closure(me, c));
    }

    fn visit_expr_binary(&mut self, b: &'ast syn::ExprBinary) {
        let ids = self.take(b.op.span(), false, &["BinaryOperator"]);
        let op = self.text[bytes(&b.op)].to_owned();
        let kind = match b.op {
            BinOp::And(_) | BinOp::Or(_) => Kind::Logic { and: op == "&&" },
            BinOp::Eq(_)
            | BinOp::Ne(_)
            | BinOp::Lt(_)
            | BinOp::Le(_)
            | BinOp::Gt(_)
            | BinOp::Ge(_) => Kind::Comparison(op),
            _ if op.ends_with('=') => Kind::Assignment(op),
            _ => Kind::Arithmetic(op),
        };
        if binds(&b.left) || binds(&b.right) {
            self.found.chains.extend(ids.iter().map(|(id, _)| id));
        } else {
            let holes = vec![bytes(&b.left), bytes(&b.right)];
            self.add(kind, bytes(b), holes, ids);
        }
        visit::visit_expr_binary(self, b);
    }

    fn visit_expr_unary(&mut self, u: &'ast syn::ExprUnary) {
        let ids = self.take(u.op.span(), false, &["UnaryOperator"]);
        let op = self.text[bytes(&u.op)].to_owned();
        self.add(Kind::Unary(op), bytes(u), vec![bytes(&u.expr)], ids);
        visit::visit_expr_unary(self, u);
    }

    fn visit_expr_match(&mut self, m: &'ast syn::ExprMatch) {
        let mut all = Vec::new();
        for arm in &m.arms {
            let mut ids = self.take(arm.span(), false, &["MatchArm"]);
            if ids.is_empty() {
                ids = self.take(arm.pat.span(), false, &["MatchArm"]);
            }
            all.extend(ids.clone());
            match &arm.guard {
                None => {
                    let at = bytes(&arm.pat).end;
                    self.add(Kind::Arm, at..at, vec![], ids);
                }
                Some((_, guard)) => {
                    ids.extend(self.take(guard.span(), false, &["MatchArmGuard"]));
                    self.add(Kind::Guard, bytes(guard), vec![bytes(guard)], ids);
                }
            }
        }
        self.add(Kind::Match, bytes(m), vec![bytes(m)], all);
        visit::visit_expr_match(self, m);
    }

    fn visit_expr_struct(&mut self, s: &'ast syn::ExprStruct) {
        let rest = s.rest.as_ref().map(|r| self.text[bytes(r)].to_owned());
        for f in &s.fields {
            let ids = self.take(f.span(), false, &["StructField"]);
            let syn::Member::Named(name) = &f.member else {
                continue;
            };
            let rows = self.row(s, &ids, &name.to_string());
            if !rows.is_empty() {
                self.found.rows.extend(rows);
            } else if let Some(rest) = &rest {
                let kind = Kind::Field {
                    name: name.to_string(),
                    rest: rest.clone(),
                    shorthand: f.colon_token.is_none(),
                };
                self.add(kind, bytes(&f.expr), vec![bytes(&f.expr)], ids);
            }
        }
        visit::visit_expr_struct(self, s);
    }
}

/// The uses of constants that became functions.
struct Uses<'a> {
    names: &'a [String],
    sites: &'a mut Vec<Site>,
}

impl<'ast> Visit<'ast> for Uses<'_> {
    fn visit_expr_path(&mut self, p: &'ast syn::ExprPath) {
        let name = p.path.get_ident().map(ToString::to_string);
        if let Some(name) = name.filter(|n| self.names.contains(n)) {
            self.sites.push(Site {
                kind: Kind::Text(format!("{name}()")),
                range: bytes(p),
                holes: vec![],
                ids: vec![],
            });
        }
    }
}
