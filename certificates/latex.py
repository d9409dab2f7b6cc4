"""Reads a formula's LaTeX into nested lists, as certificates have them. Knows nothing of what wrote the certificates."""
import re
import unicodedata

GREEK = dict(zip("alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi psi omega Omega varpi ell".split(),
                 "αβγδεζηθκλμνξπρστφψωΩϖℓ"))
FUNCTIONS = {"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "coth", "exp", "ln"}
RELATIONS = {"=", "<", ">", r"\le", r"\leq", r"\ge", r"\geq", r"\sim", r"\approx", r"\simeq", r"\ll", r"\gg", r"\to", r"\ne", r"\neq"}
SKIP = {r"\left", r"\right", r"\,", r"\;", r"\:", r"\!", r"\ ", r"\quad", r"\qquad", r"\bigl", r"\bigr", r"\Bigl", r"\Bigr"}
DOTS = {r"\dot": "\u0307", r"\ddot": "\u0308"}
OPEN, CLOSE = {"(": ")", "[": "]", "{": "}", r"\{": r"\}"}, {")", "]", "}", r"\}"}


class Unread(Exception):
    """What this reader does not know."""


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


def tokens(latex):
    latex = latex.replace(r"\left\vert", r"\lvert").replace(r"\right\vert", r"\rvert")
    latex = re.sub(r"\\(?:text|mbox|mathrm)\{([^{}]*)\}", lambda m: "\\text{" + m[1] + "}", latex)
    for token in re.findall(r"\\text\{[^{}]*\}|\\[A-Za-z]+|\\.|\d+|\S", latex):
        if token not in SKIP:
            yield token


class Reader:
    def __init__(self, latex):
        self.t, self.i = list(tokens(latex)), 0

    def peek(self):
        return self.t[self.i] if self.i < len(self.t) else None

    def next(self):
        token = self.peek()
        if token is None:
            raise Unread("the end")
        self.i += 1
        return token

    def sides(self):
        """Statements that commas divide, each a list of sides; what cannot be read is None."""
        found, sides = [], []
        while self.peek() is not None:
            begin = self.i
            try:
                side = self.sum()
                if self.peek() is not None and self.peek() not in RELATIONS | {",", "."}:
                    raise Unread(self.peek())
            except Unread:
                side, self.i = None, begin
                depth = 0
                while self.peek() is not None and (depth or self.peek() not in RELATIONS | {","}):
                    token = self.next()
                    depth += (token in OPEN) - (token in CLOSE)
            sides.append(side)
            if self.peek() in (",", ".", None):
                found.append(sides)
                sides = []
            if self.peek() is not None:
                self.next()
        return found + ([sides] if sides else [])

    def sum(self):
        sign = self.next() if self.peek() in ("-", "+") else "+"
        x = self.product()
        x = ["-", x] if sign == "-" else x
        while self.peek() in ("+", "-"):
            x = [self.next(), x, self.product()]
        return x

    def product(self):
        x = self.cross()
        while self.peek() is not None and self.peek() not in RELATIONS | CLOSE | {"+", "-", ",", ".", "|", r"\vert", r"\rvert", "&", r"\\"}:
            sign = self.next() if self.peek() in ("/", r"\over", r"\cdot") else "*"
            x = [{r"\over": "/", r"\cdot": "·"}.get(sign, sign), x, self.cross()]
        return x

    def cross(self):
        """A vector product binds closer than others."""
        x = self.power()
        while self.peek() == r"\times":
            self.next()
            x = ["×", x, self.power()]
        return x

    def power(self):
        x = self.atom()
        while self.peek() == "^":
            self.next()
            x = ["^", x, self.group()]
        return x

    def group(self):
        """What stands in braces, or one token."""
        if self.peek() == "{":
            self.next()
            x = self.sum()
            if self.next() != "}":
                raise Unread("}")
            return x
        return self.atom(one=True)

    def text(self):
        """The letters of a subscript."""
        if self.peek() != "{":
            return self.letter(self.next())
        self.next()
        out = ""
        while self.peek() != "}":
            out += self.letter(self.next())
        self.next()
        return out

    def letter(self, token):
        found = re.fullmatch(r"\\text\{(.*)\}", token)
        if found:
            return found[1]
        if token.startswith("\\"):
            if token[1:] not in GREEK:
                raise Unread(token)
            return GREEK[token[1:]]
        return token

    def atom(self, one=False):
        token = self.next()
        if token.isdigit():
            return token[0] if one and len(token) > 1 and self.back(len(token) - 1) else token
        if token in OPEN:
            x = self.sum()
            if self.next() not in CLOSE:
                raise Unread("a bracket")
            return x
        if token in (r"\frac", r"\tfrac", r"\dfrac"):
            return self.derivative() or ["/", self.group(), self.group()]
        if token in (r"\vert", r"\lvert"):
            x = self.sum()
            if self.next() != token.replace("l", "r"):
                raise Unread("a bar")
            return ["| |", x]
        if token in DOTS or token in (r"\bm", r"\hat"):
            return self.dotted(token)
        if token == r"\sqrt":
            return ["√", self.group()]
        if token[1:] in FUNCTIONS and token[0] == "\\":
            return self.function(token[1:])
        accent = ""
        if token in (r"\tilde", r"\mathfrak"):
            inner = self.next()
            if inner == "{":
                inner = self.next()
                self.next()
            token, accent = inner, "\u0303" if token == r"\tilde" else "frak"
        if not (token.isalpha() or token[1:] in GREEK):
            raise Unread(token)
        letter = self.letter(token) + accent
        if letter == "π":
            return letter
        if self.peek() == "_" and not one:
            self.next()
            letter += self.text()
        return name(letter)

    def dotted(self, token):
        """A vector, or the rate of a letter or vector."""
        begin = self.i
        x = self.group()
        if token == r"\bm" and isinstance(x, str):
            return ["vector", x]
        if token == r"\hat" and x[0] == "vector":
            return ["unit", x[1]]
        dot = DOTS.get(token)
        if dot and isinstance(x, str):
            return name(x + dot)
        if dot and x[0] == "vector":
            return ["vector", name(x[1] + dot)]
        self.i = begin
        raise Unread(token)

    def derivative(self):
        """dx/dt as the rate of x, if that is what comes."""
        found = re.match(r"\{ \\text\{d\} (\^ (?:\{ 2 \}|2) )?(.*?) \} \{ \\text\{d\} (t|\\tau|\\phi) (?:\^ (?:\{ 2 \}|2) )?\}", " ".join(self.t[self.i:]))
        if not found or re.search(r"[+*/=]|frac", found[2]):
            return None
        dot = r"\ddot" if found[1] else r"\dot"
        x = Reader(f"{dot}{{{found[2]}}}").atom()
        self.i += len(found[0].split(" "))
        return x

    def back(self, n):
        """Leaves all digits but the first of the last token to be read."""
        token = self.t[self.i - 1]
        self.t[self.i - 1:self.i] = [token[0], token[1:]]
        return True

    def function(self, f):
        power = None
        if self.peek() == "^":
            self.next()
            power = self.group()
            if power == ["-", "1"] and f in ("sin", "cos"):
                f, power = "arc" + f, None
        x = self.atom_of_function()
        return [f, x] if power is None else ["^", [f, x], power]

    def atom_of_function(self):
        x = self.power()
        # sin 2α, sin ϖt: factors without brackets belong to the argument.
        while isinstance(x, str) and self.peek() is not None and (self.peek().isalpha() or self.peek()[1:] in GREEK):
            x = ["*", x, self.power()]
        return x
