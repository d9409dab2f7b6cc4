"""Reads a formula's LaTeX into nested lists, as certificates have them. Knows nothing of what wrote these."""
import re
import unicodedata

from formula import Wrong, demand

GREEK = ("alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi psi omega Omega "
         "varpi ell").split()
GREEK = dict(zip(GREEK, "αβγδεζηθκλμνξπρστφψωΩϖℓ"))
FUNCTIONS = {"\\" + f for f in "sin cos tan cot sinh cosh tanh coth exp ln".split()}
RELATIONS = set(r"= < > \le \leq \ge \geq \sim \approx \simeq \ll \gg \to \ne \neq".split())
CLOSED_BY = {"(": ")", "[": "]", "{": "}", r"\{": r"\}", r"\vert": r"\vert", r"\lvert": r"\rvert"}
ENDS = RELATIONS | set(CLOSED_BY.values()) | {"+", "-", ",", ".", "|", "&", r"\\", ""}
# What binds closer and closer, and what stands for it.
LEVELS = [{"+": "+", "-": "-"}, {"/": "/", r"\over": "/", r"\cdot": "·"}, {r"\times": "×"}]
ACCENTS = {r"\tilde": "\u0303", r"\mathfrak": "frak"}
DOTS = {r"\dot": "\u0307", r"\ddot": "\u0308"}

TOKEN = r"\\text\{[^{}]*\}|\\[A-Za-z]+|\\.|\S"
PLAIN = [(r"\\left\\vert", r"\\lvert "), (r"\\right\\vert", r"\\rvert "), (r"\\(mbox|mathrm)\{", r"\\text{"),
         (r"\\((left|right|quad|qquad|[bB]ig[lr])(?![A-Za-z])|[,;:! ])", " "),
         (r"\\([A-Za-z]+)", lambda m: GREEK.get(m[1], m[0]))]
# dx/dt, as the rate of x.
RATE = (r"\\[td]?frac { \\text{d} (\^ (?:{ 2 }|2) )?((?:(?!frac|[+*/=]).)*?) } "
        r"{ \\text{d} (?:t|τ|φ) (?:\^ (?:{ 2 }|2) )?}")


def name(text):
    """A name without accents' order, subscripts' signs and spaces: φ̃₁, \\tilde\\phi_1 and φ̃_1 are the same."""
    text = text.replace("ϖ", "varpi").replace("𝔴", "wfrak")
    text = unicodedata.normalize("NFKD", text).replace("−", "-")
    return re.sub(r"[_{}\s]", "", text)


def statements(latex):
    """The formulas of a statement: the rows of cases, without labels, remarks, and what is left out."""
    latex = re.sub(r"^.*\\text\{[^{}]*:\}", "", latex.replace(r"\mbox", r"\text"))
    latex = re.sub(r"\\text\{ ?(at|for|of)[^{}]*\}.*$|[+-]\s*\\cdots|\+\s*[oO]\((\\[a-z]+|[^()])*\)", "", latex)
    cases = re.search(r"\\begin\{cases\}(.*)\\end\{cases\}", latex)
    return [row.split("&")[0].strip().rstrip(",") for row in cases[1].split(r"\\")] if cases else [latex]


def read(latex):
    return Reader(latex).sum()


class Reader:
    def __init__(self, latex):
        for pattern, by in PLAIN:
            latex = re.sub(pattern, by, latex)
        rates = lambda m: (r"\ddot" if m[1] else r"\dot") + " { " + m[2] + " }"
        self.t, self.i = re.findall(TOKEN, re.sub(RATE, rates, " ".join(re.findall(TOKEN, latex)))), 0

    def peek(self):
        """What comes next; nothing at the end."""
        return self.t[self.i] if self.i < len(self.t) else ""

    def next(self):
        demand(self.peek(), "the end")
        self.i += 1
        return self.t[self.i - 1]

    def sides(self):
        """What stands between relations and commas; what cannot be read is None."""
        found = []
        while self.peek():
            begin = self.i
            try:
                side = self.sum()
                demand(self.peek() in RELATIONS | {",", ".", ""}, self.peek())
            except Wrong:
                side, self.i, depth = None, begin, 0
                while self.peek() and (depth or self.peek() not in RELATIONS | {","}):
                    token = self.next()
                    depth += (token in ("(", "[", "{", r"\{")) - (token in (")", "]", "}", r"\}"))
            found.append(side)
            self.i += 1
        return found

    def sum(self, level=0):
        """A sum, a product, or a vector product, which binds closer than others."""
        if level == len(LEVELS):
            return self.power()
        sign = self.next() if level == 0 and self.peek() in LEVELS[0] else "+"
        x = self.sum(level + 1)
        x = ["-", x] if sign == "-" else x
        while self.peek() in LEVELS[level] or level == 1 and self.peek() not in ENDS:
            x = [LEVELS[level][self.next()] if self.peek() in LEVELS[level] else "*", x, self.sum(level + 1)]
        return x

    def power(self):
        x = self.atom()
        while self.peek() == "^":
            self.next()
            x = ["^", x, self.atom(one=True)]
        return x

    def subscript(self):
        """The letters and words in braces, or one."""
        token = self.next()
        letters = "".join(iter(self.next, "}")) if token == "{" else token
        letters = re.sub(r"\\text\{([^{}]*)\}", r"\1", letters)
        demand("\\" not in letters, letters)
        return letters

    def atom(self, one=False):
        """What stands in brackets, a function, a name, a number; or one digit, or letter."""
        token = self.next()
        if token.isdigit():
            while not one and self.peek().isdigit():
                token += self.next()
            return token
        if token in CLOSED_BY:
            x = self.sum()
            demand(self.next() == CLOSED_BY[token], "a bracket")
            return ["| |", x] if "vert" in token else x
        if token in (r"\frac", r"\tfrac", r"\dfrac"):
            return ["/", self.atom(one=True), self.atom(one=True)]
        if token == r"\sqrt":
            return ["√", self.atom(one=True)]
        if token in FUNCTIONS:
            return self.function(token[1:])
        if token in (r"\bm", r"\hat", *DOTS):
            # A vector, or the rate of a letter or vector.
            match token, self.atom(one=True):
                case r"\bm", str(x):
                    return ["vector", x]
                case r"\hat", ["vector", x]:
                    return ["unit", x]
                case (r"\dot" | r"\ddot"), str(x):
                    return name(x + DOTS[token])
                case (r"\dot" | r"\ddot"), ["vector", x]:
                    return ["vector", name(x + DOTS[token])]
            raise Wrong(token)
        letters = self.subscript() + ACCENTS[token] if token in ACCENTS else token
        demand(letters[0].isalpha(), token)
        if self.peek() == "_" and not one and letters != "π":
            self.next()
            letters += self.subscript()
        return name(letters) if letters != "π" else letters

    def function(self, f):
        power = None
        if self.peek() == "^":
            self.next()
            power = self.atom(one=True)
            if power == ["-", "1"] and f in ("sin", "cos"):
                f, power = "arc" + f, None
        x = self.power()
        # sin 2α, sin ϖt: a factor without brackets belongs to the argument.
        if isinstance(x, str) and self.peek().isalpha():
            x = ["*", x, self.power()]
        return [f, x] if power is None else ["^", [f, x], power]
