"""What a certificate says, as text to be read and reviewed: all but what only shows it."""
import re
from decimal import Decimal, localcontext

from formula import demand, dyadic

BINDS = {"+": 1, "-": 1, "*": 2, "/": 2, "^": 4}


def infix(tree, outside=0):
    """A formula, with brackets where they are needed."""
    if isinstance(tree, str):
        return exact(tree) if "*2^" in tree else tree
    sign, *operands = tree
    if len(operands) == 1:
        x = infix(operands[0], 3 if sign == "-" else 0)
        text, binds = (f"-{x}", 1) if sign == "-" else (f"{sign}({x})", 5)
    else:
        binds = BINDS[sign]
        x, y = infix(operands[0], binds + (sign == "^")), infix(operands[1], binds + 1)
        text = f"{x}{sign}{y}" if sign == "^" else f"{x} {sign} {y}"
    return f"({text})" if binds < outside else text


def exact(number):
    """A number m·2^e as a decimal."""
    with localcontext(prec=400):
        x = dyadic(number)
        return format((Decimal(int(x.p)) / int(x.q)).normalize(), "f")


def side(ends):
    return "[{}, {}]".format(*map(exact, ends))


def polynomial(terms, names):
    def term(c, exponents):
        powers = [names[g] + (f"^{k}" if k > 1 else "") for g, k in enumerate(exponents) if k]
        sign, size = ("-", c[1:]) if c[0] == "-" else ("", c)
        return sign + " ".join([size] * (size != "1" or not powers) + powers)

    return " + ".join(term(*of) for of in terms).replace("+ -", "- ") or "0"


def element(x, names):
    over = polynomial(x["above"], names)
    factors = [x["number"]] * (x["number"] != "1")
    factors += [f"({polynomial(f, names)})" + (f"^{k}" if k > 1 else "") for f, k in x["below"]]
    over = f"({over})" if " " in over else over
    return f"{over}/({' '.join(factors)})" if factors else over


def generators(rules):
    """What the generators are called, and what they are."""
    names, lines = [], []
    for g, x in enumerate(rules):
        of = x.get("of")
        match x["rule"]:
            case "pi":
                own = "π"
            case "free":
                own = x["name"]
            case "half-tangent":
                own = f"tan({names[of]}/2)"
            case "half-exponential":
                own = f"exp({names[of]}/2)"
            case rule:
                own, of = f"g{g}", element(of, names)
                if rules[g - 1]["rule"] == "half-tangent":
                    own = f"cos({names[rules[g - 1]['of']]}/2)"
                what = {"root": lambda: f"({of})^(1/{x['degree']})", "power": lambda: f"({of})^({element(x['to'], names)})",
                        "logarithm": lambda: f"ln({of})"}
                lines.append(f"{own} is {what[rule]()}")
        names.append(own)
    return names, lines


def made(w, names):
    """The parts as text, each of earlier ones; and of each a number, the same for the same text."""
    texts, whole, same = [], [], {}

    def of(i):
        return texts[i] if len(texts[i]) < 60 else f"a{i}"

    def bracketed(i):
        text = of(i)
        return text if re.fullmatch(r"[^\s+*/^-]+", text) else f"({text})"

    def put(values, text):
        return "; ".join(f"{names[g]} → {text(j)}" for g, j in values)

    def text(part, of, bracketed):
        (kind, x), = part.items()
        signs = {"sum": "+", "difference": "-", "product": "*", "quotient": "/", "raised": "^"}
        match kind, x:
            case "element", _:
                return element(x, names)
            case "read", _:
                return infix(x)
            case "negative", _:
                return f"-{bracketed(x)}"
            case "derivative", [i, rates]:
                return f"rate of {bracketed(i)} where the rates are {put(rates, of)}"
            case "put", [i, values]:
                return f"{bracketed(i)} at {put(values, of)}"
            case "series", [tree, known]:
                series = [f"{n} = x^{start} [{', '.join(map(of, places))}]" for n, start, places in known]
                # √(x²) is taken to be x.
                sign = " for x > 0" if re.search(r"√|\^|arc", infix(tree)) else ""
                return f"series of {infix(tree)}{sign} with {'; '.join(series)}"
            case "coefficient", [i, power]:
                return f"coefficient of x^{power} in {bracketed(i)}"
        return f" {signs[kind]} ".join(map(bracketed, x))

    for part in w["parts"]:
        key = text(part, lambda i: f"<{whole[i]}>", lambda i: f"<{whole[i]}>")
        whole.append(same.setdefault(key, len(same)))
        texts.append(text(part, of, bracketed))
    return texts, whole, of


def plain(w, sides):
    """Whether the sides have the same text, or are both numbers that nothing was done to."""
    _, whole, of = made(w, generators(w["generators"])[0])
    numbers = [next(iter(w["parts"][i])) in ("read", "element") and re.fullmatch(r"[-\d/ ()]+", of(i)) for i in sides]
    return all(numbers) or len(sides) == 2 and len({whole[i] for i in sides}) == 1


def identity(w):
    names, lines = generators(w["generators"])
    texts, _, of = made(w, names)
    lines += [f"{name} stands for {element(x, names)}" for name, x in w["symbols"]]
    lines += [f"({element(x['of'], names)})^({element(x['to'], names)}) is {element(x['is'], names)}" for x in w["powers"]]
    lines += [f"{x['function']}({element(x['of'], names)}) is {element(x['is'], names)}" for x in w["inverses"]]
    lines += [f"a{i} = {text}" for i, text in enumerate(texts) if of(i) != text]
    for i, equal in enumerate(w["equal"]):
        relation = "≠" if w["fails"] and i + 1 == len(w["equal"]) else "=="
        right = "0" if equal["right"] is None else of(equal["right"])
        lines.append(f"{equal['says']}: {of(equal['left'])} {relation} {right}")
    return [f"identity: {w['title']}"] + [f"by {title}" for title in w["given"]] + lines


def box(w):
    return ", ".join(f"{name} in {side(ends)}" for name, ends in zip(w["variables"], w["within"]))


def root(w):
    return [f"root: one in {box(w)}", *(f"{infix(f)} == 0" for f in w["functions"])]


def number(w):
    return [f"number: at the root of witness {w['root']}", f"{infix(w['stated'])} == {infix(w['found'])}"]


def range_(w):
    lines = [f"range: {box(w)}"]
    for case in w["cases"]:
        of = case["of"] if case["of"] == "rest" else " ".join(f"{k} {w['variables'][i]} = {exact(at)}" for k, (i, at) in case["of"].items())
        lines.append(f"of what is {of}, {'one' if case['choice'] else 'all'} of")
        for c in case["conditions"]:
            by = f", coefficient {c['power']} by {w['variables'][c['by']]}" if c["power"] else ""
            lines.append(f"  {infix(c['formula'])}{by} {'>' if c['sign'] > 0 else '<'} 0")
    return lines


def motion(w):
    lines = [f"motion: to {w['end']}"]
    lines += [f"d{x}/dt = {infix(f)}" for x, f in zip(w["variables"], w["law"])]
    lines += [f"{x} = {infix(f)}" for x, f in w["numbers"]]
    lines += [f"{x} from {infix(f)} in {side(ends)}" for x, f, ends in zip(w["variables"], w["from"], w["start"])]
    return lines + [f"in the end {infix(f)} {'>' if sign > 0 else '<'} 0" for f, sign in w["decides"]]


KINDS = {"identity": identity, "root": root, "number": number, "range": range_, "motion": motion}


def witness(w):
    first, *lines = KINDS[w["kind"]](w)
    demand(not any("\n" in line for line in [first, *lines]), "a text of two lines")
    return "\n".join([first, *("  " + line for line in lines)])


class Transcript:
    """The record: of each file a paragraph, in which a witness that stands before is named by its place there."""

    def __init__(self, text):
        self.files, self.known = {}, {}
        for paragraph in text.split("\n\n") if text.strip() else []:
            head, *of = re.split(r"\n(?=\d+ )", paragraph.rstrip("\n"))
            name, texts = head.split(": ", 1)[0], []
            for i, own in enumerate(of):
                text = own.split(" ", 1)[1]
                texts.append(self.known[text[3:]] if text.startswith("as ") else text)
                self.known[f"{name} {i}"] = texts[-1]
            self.files[name] = head, texts

    @staticmethod
    def written(files):
        places, paragraphs = {}, []
        for head, texts in files:
            lines = [head]
            for i, text in enumerate(texts):
                place = places.setdefault(text, f"{head.split(': ', 1)[0]} {i}")
                first = place == f"{head.split(': ', 1)[0]} {i}"
                lines.append(f"{i} {text if first else f'as {place}'}")
            paragraphs.append("\n".join(lines))
        return "\n\n".join(paragraphs) + "\n"
