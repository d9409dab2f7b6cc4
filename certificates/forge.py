#!/usr/bin/env python3
"""Forges certificates, one for each thing that the checker demands, and asks that this demand is what refuses it.

    python3 forge.py FOLDER

`corrupt.py` spoils files at random; these are meant to be right in all but one respect. Exit code 0 if each is refused for its own reason.
"""
import contextlib
import copy
import io
import json
import os
import shutil
import sys
import tempfile

import check
from field import identity
from formula import Wrong
from intervals import Interval, coefficients, dyadic, range_, root

HERE = os.path.dirname(os.path.abspath(__file__))
SEVEN, FOUR, TWO, HALF = ({"above": [[n, []]], "number": below, "below": []} for n, below in (("7", "1"), ("4", "1"), ("2", "1"), ("1", "2")))


def of_kind(kind, fits=lambda w: True):
    """The first witness of a kind, if it is fit."""
    return lambda c: next((w for w in c["witnesses"] if w["kind"] == kind and fits(w)), None)


def moved(text, by):
    """A number as it is written, and so many of its units more."""
    n, *power = text.split("*2^")
    return "*2^".join([str(int(n) + by), *power])


def finer(text, by, bits):
    """The same in units of 2 to the minus `bits`, so many more."""
    return f"{int(dyadic(text) * 2**bits) + by}*2^-{bits}"


# On witnesses: which, what is done to it, and why it has to be refused.

def idle_part(w):
    w["parts"].append({"read": "7"})
    w["gives"].append(None)


def idle_power(w):
    w["powers"].append({"of": FOUR, "to": HALF, "is": TWO})


def disproved(w):
    w["fails"] = True


def worked_out(w):
    i = next(i for i, x in enumerate(w["gives"]) if x not in (None, SEVEN))
    w["gives"][i] = SEVEN


def not_there(w):
    w["given"].append("a proof that nobody made")


def with_itself(w):
    w["equal"][0]["right"] = w["equal"][0]["left"]


def other_inverse(w):
    inverse = w["inverses"][0]
    inverse["function"] = {"arcsin": "arccos", "arccos": "arcsin"}[inverse["function"]]


def volume(part):
    size = 1
    for low, high in part["at"]:
        size *= dyadic(high) - dyadic(low)
    return size


def alike(w):
    """Two parts of the same size that ask for the same: the numbers of both."""
    parts = w["parts"]
    return next(((i, j) for i, p in enumerate(parts) for j, q in enumerate(parts) if 0 < i < j and volume(p) == volume(q) and p["by"] == q["by"]), None)


def gap(w):
    i, j = alike(w)
    w["parts"][j] = copy.deepcopy(w["parts"][i])


def overlap(w):
    w["parts"].append(copy.deepcopy(w["parts"][-1]))


def idle_condition(w):
    """Of parts of which there are none."""
    w["cases"].insert(0, {**copy.deepcopy(w["cases"][0]), "of": {"below": [0, "-1000"]}})


def other_sign(w):
    condition = w["cases"][0]["conditions"][0]
    condition["sign"] = -condition["sign"]


def other_corner(w):
    w["corners"][0][0] = moved(w["corners"][0][0], 3)


def other_matrix(w):
    w["preconditioner"][0][0] = finer(w["preconditioner"][0][0], 3, 20)


def other_root(w):
    w["root"][0] = moved(w["root"][0], 2)


def wide_number(w):
    """What is stated is off by 1, and is written so that its bounds are wide."""
    nothing = ["-", w["found"], w["found"]]
    w["stated"] = ["+", ["+", w["found"], "1"], ["*", "1" + "0" * 90, nothing]]


def decimal(w):
    return w["stated"][0] == "/" and str(w["stated"][2]).strip("0") == "1"


def digit(by):
    """What is stated, a decimal, with another last digit."""
    def spoil(w):
        w["stated"][1] = str(int(w["stated"][1]) + by)
    return spoil


def other_law(w):
    w["law"][0] = ["-", w["law"][0]]


def elsewhere(w):
    w["start"][0] = [finer(end, 8, 44) for end in w["start"][0]]


def nearer_walls(w):
    wall = w["steps"][0]["walls"][0]
    wall[0] = finer(wall[0], 1, 20)


def narrower(w):
    side = w["steps"][-1]["state"][0]
    side[0] = finer(side[0], 2, 44)


def too_early(w):
    w["steps"].pop()


def other_end(w):
    w["end"] = {"rest": "escape", "escape": "rest"}[w["end"]]


def emptied(w):
    """What is compared is 0 times what it was."""
    n, [first, *_] = len(w["parts"]), w["equal"]
    w["parts"] += [{"element": SEVEN}, {"difference": [n, n]}, {"product": [n + 1, first["left"]]}, {"product": [n + 1, first["right"]]}]
    w["gives"] += [None] * 4
    first["left"], first["right"] = n + 2, n + 3


def coarse(w):
    """A root to a unit that says nothing."""
    w["root"][0] = "0*2^40"


def infinite(w):
    w["parts"][next(i for i, part in enumerate(w["parts"]) if "series" in part)]["series"][1][0][1] = float("inf")


def reading(w, old, new):
    """Another formula for the last one that is read so, with nothing said of what comes of it."""
    part = [part for part in w["parts"] if "read" in part and old(part["read"])][-1]
    part["read"], w["gives"] = new, [None] * len(w["parts"])


def spin_in_the_law(w):
    """The spin ω_z drives the centre."""
    reading(w, lambda tree: tree == "A_x", ["+", "A_x", "ω_z"])


def other_speed(w):
    """The path grows as the speed, whatever that is."""
    reading(w, lambda tree: "L" in str(tree) and tree != "L", ["*", "7", ["*", "L", "L"]])


def goes_on(w):
    """The vanishing power of the half tangent does not vanish."""
    put = next(part["put"] for part in w["parts"] if len(part.get("put", [0, []])[1]) == 2)
    put[1][1][1] = 0


def titled(title):
    return of_kind("identity", lambda w: w["title"] == title)


IN_WITNESSES = [
    (titled("ζ₃ is constant and enters nothing else"), spin_in_the_law, "not equal"),
    (titled("(137) in every escape"), other_speed, "not equal"),
    (titled("(20): the time at which the particle stops"), goes_on, "a value against a rule"),
    (of_kind("identity", lambda w: w["equal"] and w["equal"][0]["right"] is not None and not w["fails"]), emptied, "0 times something"),
    (of_kind("root"), coarse, "the root is elsewhere"),
    (of_kind("identity", lambda w: any("series" in part for part in w["parts"])), infinite, "no lowest power"),
    (of_kind("identity"), idle_part, "an idle part"),
    (of_kind("identity"), idle_power, "something known that is not needed"),
    (of_kind("identity", lambda w: not w["fails"] and w["equal"]), disproved, "equal, which it is not to be"),
    (of_kind("identity", lambda w: any(x not in (None, SEVEN) for x in w["gives"])), worked_out, "a part is something else"),
    (of_kind("identity"), not_there, "it rests on a proof that is not there"),
    (of_kind("identity", lambda w: w["equal"]), with_itself, "something is compared with itself"),
    (of_kind("identity", lambda w: w["inverses"]), other_inverse, "an inverse that is none"),
    (of_kind("range", alike), gap, "the parts leave a gap"),
    (of_kind("range"), overlap, "the parts overlap"),
    (of_kind("range"), idle_condition, "an idle condition"),
    (of_kind("range"), other_sign, "a condition that is not fulfilled"),
    (of_kind("root"), other_corner, "another value at a corner"),
    (of_kind("root"), other_matrix, "another preconditioner"),
    (of_kind("root"), other_root, "the root is elsewhere"),
    (of_kind("number"), wide_number, "the numbers differ"),
    (of_kind("number", decimal), digit(1), "the numbers differ"),
    (of_kind("number", decimal), digit(-1), "the numbers differ"),
    (of_kind("motion"), other_law, "another law of motion"),
    (of_kind("motion"), elsewhere, "the start is elsewhere"),
    (of_kind("motion", lambda w: w["steps"]), nearer_walls, "a motion leaves its walls, or they are far"),
    (of_kind("motion", lambda w: w["steps"]), narrower, "the motion ends elsewhere"),
    (of_kind("motion", lambda w: w["steps"]), too_early, "what is to decide is not so"),
    (of_kind("motion"), other_end, "that decides nothing"),
]


# On files.

def other_statement(c, other):
    c["statement"] = other["statement"]


def no_statement(c, other):
    """A string that stands in the sources."""
    c["statement"], c["about"] = "2.1", "as corrected"


def other_sign(c, other):
    c["statement"] = c["statement"].replace("-", "+", 1)


def other_condition(c, other):
    c["conditions"].append("any $x$")


def nothing_shown(c, other):
    c["witnesses"] = [w | {"equal": [], "parts": [], "gives": []} for w in c["witnesses"] if w["kind"] == "identity"]


def own_link_emptied(c, other):
    """An equation that is shown by what it rests on alone."""
    c["witnesses"][-1] |= {"equal": [], "parts": [], "gives": []}


def without_its_end(c, other):
    c["witnesses"].pop()


def other_words(c, other):
    c["says"] = "anything at all"


def whole(c, other):
    c["about"] = "as printed, and all of it"


def other_format(c, other):
    c["format"] = 3.0


def other_name(c, other):
    c["proof"] += 1


IN_FILES = [
    (other_statement, "the statement is not printed so"),
    (no_statement, "the statement is not printed so"),
    (other_condition, "the statement is not printed so"),
    (nothing_shown, "nothing is compared"),
    (own_link_emptied, "nothing is compared"),
    (other_sign, "the statement is not printed so"),
    (without_its_end, "not what is listed"),
    (other_name, "another file's name"),
    (other_words, "not what is listed"),
    (whole, "not what is listed"),
    (other_format, "another version of the format"),
]


# Witnesses of what is false, or not proved by them.

def at_the_end():
    """The root of x, at the end of a box: the image lies in it, and not strictly inside."""
    unit = 1 << 30
    return root, {"kind": "root", "variables": ["x"], "functions": ["x"], "within": [["0", "1"]], "corners": [["0"], [str(unit)]],
                  "preconditioner": [["1"]], "root": ["0*2^-10"]}, "the image is not inside the box"


def at_the_end_of_a_side():
    """The root of x − ½ and y, at the end of a side of the box."""
    half, unit = 1 << 29, 1 << 30
    return root, {"kind": "root", "variables": ["x", "y"], "functions": [["-", "x", "1*2^-1"], "y"], "within": [["0", "1"], ["0", "1"]],
                  "corners": [[str(-half), "0"], [str(half), str(unit)]], "preconditioner": [["1", "0"], ["0", "1"]],
                  "root": ["512*2^-10", "0*2^-10"]}, "the image is not inside the box"


def by_the_slope_along_x():
    """That y − ¼ is positive on a square, as it is in the middle, and does not change along x."""
    square = [["0", "1"], ["0", "1"]]
    condition = {"formula": ["-", "y", "1*2^-2"], "by": 0, "power": 0, "sign": 1, "middle": [str(1 << 28)]}
    return range_, {"kind": "range", "variables": ["x", "y"], "within": square, "parts": [{"at": square, "by": None}],
                    "cases": [{"of": "rest", "choice": False, "conditions": [condition]}]}, "a condition that is not fulfilled"


def above_the_sine():
    """That the sine is below 255/256 between 5/4 and 15/8, where both ends are and the top is not."""
    formula, cell = ["-", "255*2^-8", ["sin", "x"]], [Interval(dyadic("5*2^-2"), dyadic("15*2^-3"))]
    [value] = coefficients(formula, ["x"], [x.middle() for x in cell])
    middle = str((value.low * 2**30 + 0.5).floor().unique_fmpz())
    condition = {"formula": formula, "by": 0, "power": 0, "sign": 1, "middle": [middle]}
    return range_, {"kind": "range", "variables": ["x"], "within": [["5*2^-2", "15*2^-3"]], "parts": [{"at": [["5*2^-2", "15*2^-3"]], "by": None}],
                    "cases": [{"of": "rest", "choice": False, "conditions": [condition]}]}, "a condition that is not fulfilled"


def cube_root():
    """That the cube root has the slope of a square root."""
    generators = [{"rule": "pi"}, {"rule": "free", "name": "x"}, {"rule": "root", "of": {"above": [["1", [0, 1]]], "number": "1", "below": []}, "degree": 3}]
    own, rate = {"above": [["1", [0, 0, 1]]], "number": "1", "below": []}, {"above": [["1", []]], "number": "1", "below": []}
    # x r′ is r/3, and is said to be r/2.
    half = {"above": [["1", [0, 0, 1]]], "number": "2", "below": []}
    parts = [{"element": own}, {"element": rate}, {"derivative": [0, [[1, 1]]]}, {"read": "x"}, {"product": [2, 3]}, {"element": half}]
    return identity, {"kind": "identity", "title": "a slope", "given": [], "generators": generators, "symbols": [], "powers": [], "inverses": [],
                      "parts": parts, "gives": [None] * len(parts), "equal": [{"says": "x r′", "left": 4, "right": 5}], "fails": False}, "not equal"


def other_branch():
    """That the arcsine of 0 is π."""
    zero, pi = ({"above": above, "number": "1", "below": []} for above in ([], [["1", [1]]]))
    return identity, {"kind": "identity", "title": "an angle", "given": [], "generators": [{"rule": "pi"}], "symbols": [], "powers": [],
                      "inverses": [{"function": "arcsin", "of": zero, "is": pi}], "parts": [{"read": ["arcsin", "0"]}, {"element": pi}],
                      "gives": [None, None], "equal": [{"says": "arcsin 0", "left": 0, "right": 1}], "fails": False}, "principal branches"


def of(*terms, number="1", below=()):
    return {"above": [list(term) for term in terms], "number": number, "below": list(below)}


def claimed(generators, parts, pairs, fails=False, **known):
    """An identity of these generators, besides π: that pairs of parts are equal."""
    equal = [{"says": "", "left": left, "right": right} for left, right in pairs]
    return identity, {"kind": "identity", "title": "what is false", "given": [], "generators": [{"rule": "pi"}, *generators],
                      "symbols": [], "powers": [], "inverses": [], "parts": parts, "gives": [None] * len(parts), "equal": equal,
                      "fails": fails, **known}


X, ONE = {"rule": "free", "name": "x"}, of(["1", []])
ROOT_OF_X = [X, {"rule": "root", "of": of(["1", [0, 1]]), "degree": 2}]
LOGARITHM = [X, {"rule": "logarithm", "of": of(["1", [0, 1]])}]
ANGLE = [{"rule": "free", "name": "θ"}, {"rule": "half-tangent", "of": 1},
         {"rule": "root", "of": of(["1", []], below=[[[["1", []], ["1", [0, 0, 2]]], 1]]), "degree": 2}]


def roots_of_what_is_negative():
    """√(x²) = −(√x)², by the roots of −x and −1."""
    roots = [{"rule": "root", "of": x, "degree": 2} for x in (of(["-1", [0, 1]]), of(["-1", []]))]
    parts = [{"read": ["√", ["*", "x", "x"]]}, {"read": ["-", ["*", ["√", "x"], ["√", "x"]]]}]
    return *claimed([X, *roots], parts, [(0, 1)]), "no declared power"


def root_beside_the_angle():
    """arccos cos θ = −(√(−θ))²."""
    cosine = of(["1", []], ["-1", [0, 0, 2]], below=[[[["1", []], ["1", [0, 0, 2]]], 1]])
    angle = {"function": "arccos", "of": cosine, "is": of(["1", [0, 1]])}
    parts = [{"read": ["+", ["arccos", ["cos", "θ"]], ["*", ["√", ["-", "θ"]], ["√", ["-", "θ"]]]]}]
    return *claimed([*ANGLE, {"rule": "root", "of": of(["-1", [0, 1]]), "degree": 2}], parts, [(0, None)], inverses=[angle]), "principal"


def by_the_root_of_a_square():
    """5 (√4 − 2)/(√4 − 2) = 5."""
    parts = [{"element": of(["5", []])}, {"element": of(["1", [0, 1]], ["-2", []])}, {"product": [0, 1]}, {"quotient": [2, 1]}]
    return *claimed([{"rule": "root", "of": FOUR, "degree": 2}], parts, [(3, 0)]), "division by zero"


def by_an_imaginary_zero():
    """The same with √−1 beside the divisor."""
    roots = [{"rule": "root", "of": x, "degree": 2} for x in (FOUR, of(["-1", []]))]
    parts = [{"element": of(["5", []])}, {"element": of(["1", [0, 1, 1]], ["-2", [0, 0, 1]])}, {"product": [0, 1]}, {"quotient": [2, 1]}]
    return *claimed(roots, parts, [(3, 0)]), "division by zero"


def over_zero_as_written():
    """(√4 − 2)·5/(√4 − 2) = 5, as an element."""
    zero = [[["-2", []], ["1", [0, 1]]], 1]
    parts = [{"element": of(["5", [0, 2]], ["-20", []], below=[zero])}, {"element": of(["5", [0, 1]], ["10", []])}]
    return *claimed([{"rule": "root", "of": FOUR, "degree": 2}], parts, [(0, 1)]), "division by zero"


def other_logarithm():
    """x + ln x at 1 is 8."""
    parts = [{"read": ["+", "x", ["ln", "x"]]}, {"read": "1"}, {"read": "7"}, {"put": [0, [[1, 1], [2, 2]]]}, {"read": "8"}]
    return *claimed(LOGARITHM, parts, [(3, 4)]), "a value against a rule"


def other_cosine():
    """θ + cos θ at 0 is 0, by tan(θ/2) = 1."""
    parts = [{"read": ["+", "θ", ["cos", "θ"]]}, {"read": "0"}, {"read": "1"}, {"put": [0, [[1, 1], [2, 2]]]}]
    return *claimed(ANGLE, parts, [(3, None)]), "a value against a rule"


def negative_root():
    """x + √x at 4 is 2."""
    parts = [{"read": ["+", "x", ["√", "x"]]}, {"read": "4"}, {"read": ["-", "2"]}, {"put": [0, [[1, 1], [2, 2]]]}, {"read": "2"}]
    return *claimed(ROOT_OF_X, parts, [(3, 4)]), "a value against a rule"


def beyond_the_exponent():
    """A coefficient of (1 + t)^(1/2 + t)/t², of which 1/2 + t is known only so far."""
    series = [["/", ["^", "x", ["+", ["/", "1", "2"], "t"]], ["*", "t", "t"]], [["x", 0, [0, 0, 1, 1, 1, 1]], ["t", 1, [0, 1, 1, 1, 1]]]]
    parts = [{"read": "1"}, {"read": "0"}, {"series": series}, {"coefficient": [2, 0]}, {"read": ["-", ["/", "1", "8"]]}]
    return *claimed([], parts, [(3, 4)]), "a varying exponent"


def disproof_elsewhere():
    """√(x²) is not x, as −x is a root of x² too."""
    minus = {"of": of(["1", [0, 2]]), "to": HALF, "is": of(["-1", [0, 1]])}
    parts = [{"read": ["√", ["*", "x", "x"]]}, {"read": ["√", "x"]}, {"product": [1, 1]}]
    return *claimed(ROOT_OF_X, parts, [(0, 2)], fails=True, powers=[minus]), "principal"


ANY_POWER = [X, {"rule": "free", "name": "b"}, {"rule": "power", "of": of(["1", [0, 1]]), "to": of(["1", [0, 0, 1]])}]
TO_ANY = ["+", "x", ["^", "x", "b"]]


def at(tree, *values):
    """A formula where generators have values, and what that is said to be."""
    *values, result = values
    parts = [{"read": tree}, *({"read": value} for _, value in values), {"read": result}]
    n = len(values)
    return [*parts, {"put": [0, [[g, i + 1] for i, (g, _) in enumerate(values)]]}], [(n + 2, n + 1)]


def logarithm_of_zero():
    """x + ln x at 0 is 7."""
    return *claimed(LOGARITHM, *at(["+", "x", ["ln", "x"]], (1, "0"), (2, "7"), "7")), "no declared logarithm"


def power_of_a_negative_number():
    """x + x^b at −1 is 41."""
    return *claimed(ANY_POWER, *at(TO_ANY, (1, ["-", "1"]), (3, "42"), "41")), "no declared power"


def power_of_zero():
    """x + x^b at 0 is 0, also for b < 0."""
    return *claimed(ANY_POWER, *at(TO_ANY, (1, "0"), (3, "0"), "0")), "a value against a rule"


def another_condition():
    """The same for b > −1."""
    _, witness, why = power_of_zero()
    return lambda w, _: identity(w, [], ["$b>-1$"]), witness, why


def excepted_condition():
    """The same where b > 0 is what is excepted."""
    _, witness, why = power_of_zero()
    return lambda w, _: identity(w, [], ["$b>0$ is excepted: there it is not so"]), witness, why


def power_of_zero_that_is_not():
    """x + x^b at 0 is 7, for b > 0."""
    witness = claimed(ANY_POWER, *at(TO_ANY, (1, "0"), (3, "7"), "7"))[1]
    return lambda w, _: identity(w, [], ["$b>0$"]), witness, "a value against a rule"


def tangent_at_its_pole():
    """θ + tan(θ/2) at π is π + 7."""
    return *claimed(ANGLE, *at(["+", "θ", ["tan", ["/", "θ", "2"]]], (1, "π"), (2, "7"), ["+", "π", "7"])), "a value against a rule"


def at_a_known_place():
    """(10 x)^b is 1, as it is at x = 1/10."""
    generators = [*ANY_POWER[:2], {"rule": "power", "of": of(["10", [0, 1]]), "to": of(["1", [0, 0, 1]])}]
    return *claimed(generators, *at(["*", "x", ["^", ["*", "10", "x"], "b"]], (3, "1"), "x")), "a value against a rule"


def root_left_as_it_is():
    """x + √x at 1/10 is 1/10 + √x."""
    return *claimed(ROOT_OF_X, *at(["+", "x", ["√", "x"]], (1, ["/", "1", "10"]), ["+", ["/", "1", "10"], ["√", "x"]])), "a value against a rule"


def touch_at_another_point():
    """The same under the title of a proof of what is so at one point alone."""
    _, witness, why = root_left_as_it_is()
    return identity, {**witness, "title": "B and C touch at Y"}, why


def root_below_left_as_it_is():
    """x + (√x)^b at 4 is 4 + (√x)^b."""
    generators = [*ROOT_OF_X, {"rule": "free", "name": "b"}, {"rule": "power", "of": of(["1", [0, 0, 1]]), "to": of(["1", [0, 0, 0, 1]])}]
    power = ["^", ["√", "x"], "b"]
    return *claimed(generators, *at(["+", "x", power], (1, "4"), ["+", "4", power])), "a value against a rule"


def root_turned():
    """√x is −√x."""
    return *claimed(ROOT_OF_X, *at(["√", "x"], (2, ["-", ["√", "x"]]), ["-", ["√", "x"]])), "a value against a rule"


def imaginary_root():
    """x + √(1 − x²) at 2 is 2 − √−3."""
    generators = [X, {"rule": "root", "of": of(["1", []], ["-1", [0, 2]]), "degree": 2}, {"rule": "root", "of": of(["-3", []]), "degree": 2}]
    parts = [{"read": ["+", "x", ["√", ["-", "1", ["*", "x", "x"]]]]}, {"read": "2"}, {"element": of(["-1", [0, 0, 0, 1]])},
             {"element": of(["2", []], ["-1", [0, 0, 0, 1]])}, {"put": [0, [[1, 1], [2, 2]]]}]
    return *claimed(generators, parts, [(4, 3)]), "a value against a rule"


def two_angles_in_one():
    """tan(θ/2) + exp(θ/2), where the one is 1 and the other 3, is 4."""
    generators = [*ANGLE, {"rule": "half-exponential", "of": 1}]
    return *claimed(generators, *at(["+", ["tan", ["/", "θ", "2"]], ["exp", ["/", "θ", "2"]]], (2, "1"), (4, "3"), "4")), "a value against a rule"


def root_of_a_square():
    """√(x²) at −1 is −1, as it is x where x > 0."""
    itself = {"of": of(["1", [0, 2]]), "to": HALF, "is": of(["1", [0, 1]])}
    return *claimed([X], *at(["√", ["*", "x", "x"]], (1, ["-", "1"]), ["-", "1"]), powers=[itself]), "a value beyond a branch"


def arcsine_of_a_sine():
    """arcsin sin θ at 3 is 3."""
    sine = of(["2", [0, 0, 1]], below=[[[["1", []], ["1", [0, 0, 2]]], 1]])
    angle = {"function": "arcsin", "of": sine, "is": of(["1", [0, 1]])}
    return *claimed(ANGLE, *at(["arcsin", ["sin", "θ"]], (1, "3"), "3"), inverses=[angle]), "a value beyond a branch"


def rate_by_nothing():
    """x does not change."""
    return *claimed([X], [{"read": "x"}, {"derivative": [0, []]}], [(1, None)]), "an idle value"


def hidden_rate():
    """x² + y does not change with x, as it does not with z."""
    names = [X, {"rule": "free", "name": "y"}, {"rule": "free", "name": "z"}]
    parts = [{"read": ["+", ["*", "x", "x"], "y"]}, {"read": "1"}, {"derivative": [0, [[3, 1], [2, 1]]]}]
    return *claimed(names, parts, [(2, None)]), "an idle value"


TWO_SINES = {"above": [["2", [0, 0, 1, 2]]], "number": "1", "below": []}


def touch_in_another_claim():
    """α + sin α is 3π/2 − cot α + sin α everywhere, though α is that at Y alone."""
    there = ["-", ["/", ["*", "3", "π"], "2"], ["cot", "α"]]
    _, witness = claimed([{"rule": "free", "name": "α"}, *ANGLE[1:]], *at(["+", "α", ["sin", "α"]], (1, there), ["+", there, ["sin", "α"]]))
    return identity, {**witness, "title": "B and C touch at Y"}, "a value against a rule"


def angle_turned():
    """θ cos(θ/2) at θ + 2π is (θ + 2π) cos(θ/2)."""
    turned = ["+", "θ", ["*", "2", "π"]]
    return *claimed(ANGLE, *at(["*", "θ", ["cos", ["/", "θ", "2"]]], (1, turned), ["*", turned, ["cos", ["/", "θ", "2"]]])), "a value against a rule"


def root_of_what_goes_along():
    """θ √(sin² θ)/sin θ at −θ is −θ, as the root is sin θ where that is positive."""
    square = {"above": [["4", [0, 0, 2, 4]]], "number": "1", "below": []}
    tree = ["*", ["/", ["√", ["*", ["sin", "θ"], ["sin", "θ"]]], ["sin", "θ"]], "θ"]
    known = [{"of": square, "to": HALF, "is": TWO_SINES}]
    return *claimed(ANGLE, *at(tree, (1, ["-", "θ"]), ["-", "θ"]), powers=known), "a value beyond a branch"


def root_beside_its_angle():
    """The same by another half tangent, with nothing said of the angle."""
    square = {"above": [["4", [0, 0, 2, 4]]], "number": "1", "below": []}
    tree = ["/", ["√", ["*", ["sin", "θ"], ["sin", "θ"]]], ["sin", "θ"]]
    parts, equal = at(["*", ["tan", ["/", "θ", "2"]], tree], (2, ["-", "1"]), ["-", "1"])
    return *claimed(ANGLE, parts, equal, powers=[{"of": square, "to": HALF, "is": TWO_SINES}]), "a value beyond a branch"


def root_by_chance():
    """√(x²) at y is y, whatever the sign of y."""
    itself = {"of": of(["1", [0, 2]]), "to": HALF, "is": of(["1", [0, 1]])}
    names = [X, {"rule": "free", "name": "y"}]
    return *claimed(names, *at(["√", ["*", "x", "x"]], (1, "y"), "y"), powers=[itself]), "a value beyond a branch"


def three_for_pi():
    """π x at π = 3 is 3 x."""
    return *claimed([X], *at(["*", "π", "x"], (0, "3"), ["*", "3", "x"])), "π is no other number"


def in_series(generators, tree, known, values, power, result, why, **more):
    """A coefficient of a series, and what that is said to be."""
    parts = [*({"read": value} for value in values), {"series": [tree, known]}, {"coefficient": [len(values), power]}, {"read": result}]
    return *claimed(generators, parts, [(len(values) + 1, len(values) + 2)], **more), why


def exponential_of_a_number():
    """exp 0 is 7."""
    return in_series([], ["exp", "0"], [["exp 0", 0, [0]]], ["7"], 0, ["+", "3", "4"], "a series of no name")


def exponential_beside_its_symbol():
    """exp t is 5 at t = 0."""
    return in_series([], ["+", ["exp", "t"], "t"], [["t", 0, [0, 1]], ["exp t", 0, [2, 1]]], ["0", "1", "5"], 0, ["+", "3", "2"], "a series of no name")


def exponential_of_a_constant():
    """exp x is 5."""
    return in_series([X], ["exp", "x"], [["exp x", 0, [0]]], ["5"], 0, ["+", "3", "2"], "a series of no name")


def left_constant():
    """w − x² has the coefficient −1 of x², where w is x²."""
    why = "something constant that is made of what varies"
    return in_series([X], ["-", "w", ["*", "x", "x"]], [["x", 0, [0, 1, 0]]], ["0", "1"], 2, ["-", "0", "1"], why, symbols=[["w", of(["1", [0, 2]])]])


def exponent_to_no_order():
    """x^n does not change with n, which is 2 to the order 0."""
    parts = [{"read": "2"}, {"series": [["^", "x", "n"], [["n", 0, [0]]]]}, {"coefficient": [1, 1]}]
    return *claimed([X], parts, [(2, None)]), "a coefficient that is not known"


def symbol_over_zero():
    """2 s is −1/2, where s is 1/(√4 − 2)."""
    zero = of(["1", []], below=[[[["-2", []], ["1", [0, 1]]], 1]])
    parts = [{"read": ["+", "s", "s"]}, {"read": ["-", ["/", "1", "2"]]}]
    return *claimed([{"rule": "root", "of": FOUR, "degree": 2}], parts, [(0, 1)], symbols=[["s", zero]]), "division by zero"


def two_for_the_price_of_one():
    """2 is 2."""
    return *claimed([], [{"read": "2"}, {"element": of(["2", []])}], [(0, 1)]), "something is compared with itself"


def read_twice():
    """πx is πx."""
    return *claimed([X], [{"read": ["*", "π", "x"]}, {"read": ["*", "π", "x"]}], [(0, 1)]), "something is compared with itself"


def numbers_that_differ():
    """What is to be disproved is not true, as 1 is not 2."""
    return *claimed([], [{"read": "1"}, {"read": "2"}], [(0, 1)], fails=True), "something is compared with itself"


def one_point():
    """That x is positive on [1, 1]."""
    condition = {"formula": "x", "by": 0, "power": 0, "sign": 1, "middle": [str(1 << 30)]}
    return range_, {"kind": "range", "variables": ["x"], "within": [["1", "1"]], "parts": [{"at": [["1", "1"]], "by": None}],
                    "cases": [{"of": "rest", "choice": False, "conditions": [condition]}]}, "no range"


def root_with_itself():
    from intervals import number
    where = (["x"], [Interval(dyadic("1*2^-1"))])
    return lambda w, _: number(w, [where]), {"kind": "number", "root": 0, "stated": "x", "found": "x"}, "something is compared with itself"


def name_like_a_formula():
    """y is not y, where y is what "x + 1" is called."""
    odd = {"rule": "free", "name": "x + 1"}
    return *claimed([X, odd], [{"read": ["+", "x", "1"]}, {"read": "x + 1"}], [(0, 1)], fails=True), "no name"


def name_alike(sign):
    """x differs from what looks like x."""
    def odd():
        return *claimed([X, {"rule": "free", "name": sign}], [{"read": "x"}, {"read": sign}], [(0, 1)], fails=True), "no name"
    return odd


def no_decimal():
    """x + ¼ for x, as if it were a decimal with no digits behind the point."""
    from intervals import number
    at = (["x"], [Interval(dyadic("1*2^-1"))])
    return lambda w, _: number(w, [at]), {"kind": "number", "root": 0, "stated": ["/", ["+", "x", "1*2^-2"], "1"], "found": "x"}, "the numbers differ"


def nothing_times_anything():
    """That 1 + 0/x is positive about 0."""
    condition = {"formula": ["+", "1", ["*", "0", ["/", "1", "x"]]], "by": 0, "power": 0, "sign": 1, "middle": [str(1 << 30)]}
    return range_, {"kind": "range", "variables": ["x"], "within": [["-1", "2"]], "parts": [{"at": [["-1", "2"]], "by": None}],
                    "cases": [{"of": "rest", "choice": False, "conditions": [condition]}]}, "0 times something"


def named_as_pi():
    """That π is above 4."""
    condition = {"formula": ["-", "5", "π"], "by": 0, "power": 0, "sign": 1, "middle": [str(2 << 29)]}
    return range_, {"kind": "range", "variables": ["π"], "within": [["4", "5"]], "parts": [{"at": [["4", "5"]], "by": None}],
                    "cases": [{"of": "rest", "choice": False, "conditions": [condition]}]}, "no names"


FALSE = [other_branch, at_the_end, at_the_end_of_a_side, by_the_slope_along_x, above_the_sine, cube_root, roots_of_what_is_negative,
         root_beside_the_angle, by_the_root_of_a_square, by_an_imaginary_zero, over_zero_as_written, other_logarithm, other_cosine, negative_root, beyond_the_exponent,
         disproof_elsewhere, no_decimal,
         nothing_times_anything, named_as_pi, logarithm_of_zero, power_of_a_negative_number, power_of_zero, another_condition, excepted_condition,
         power_of_zero_that_is_not, tangent_at_its_pole, at_a_known_place, root_left_as_it_is, root_below_left_as_it_is, root_turned, touch_at_another_point,
         imaginary_root, two_angles_in_one, root_of_a_square, arcsine_of_a_sine, touch_in_another_claim, angle_turned,
         root_of_what_goes_along, root_beside_its_angle, root_by_chance, three_for_pi, exponential_of_a_number, exponential_beside_its_symbol,
         exponential_of_a_constant, left_constant, exponent_to_no_order, symbol_over_zero, rate_by_nothing, hidden_rate,
         two_for_the_price_of_one, read_twice, name_like_a_formula, name_alike("x\u034f"), name_alike("\u0445"), numbers_that_differ, one_point,
         root_with_itself]


def refused(reason, call):
    """Nothing if it is refused for this reason; else what became of it."""
    try:
        call()
    except Wrong as wrong:
        return None if reason in str(wrong) else f"refused, as {wrong}"
    except Exception as error:  # a checker that breaks off has not refused
        return f"{type(error).__name__}: {error}"
    return "accepted"


def forged(whole, files, prints):
    """What each forgery is called, and what became of it if that is not as it has to be."""
    for pick, spoil, reason in IN_WITNESSES:
        i = next(i for i, c in enumerate(whole) if pick(c))
        c = copy.deepcopy(whole[i])
        spoil(pick(c))
        yield reason, refused(reason, lambda: check.check(c, files[i], prints))
    for spoil, reason in IN_FILES:
        numbers = (i for i, c in enumerate(whole) if [w["kind"] for w in c["witnesses"]][1:] == ["number", "number"])
        fits = {other_sign: lambda c: "-" in c["statement"], own_link_emptied: lambda c: c["claim"] == "eq-81"}
        i = next((i for i, c in enumerate(whole) if fits[spoil](c)) if spoil in fits else numbers)
        c = copy.deepcopy(whole[i])
        spoil(c, next(other for other in whole if other["claim"] not in (c["claim"], "s24-X") and "$" not in other["statement"]))
        yield reason, refused(reason, lambda: check.check(c, files[i], prints))
    for make in FALSE:
        by, witness, reason = make()
        yield make.__name__, refused(reason, lambda: by(witness, []))


def incomplete(folder, file):
    """What becomes of a folder with this one file alone, which is right."""
    with tempfile.TemporaryDirectory() as few, contextlib.redirect_stdout(io.StringIO()) as said:
        shutil.copy(os.path.join(folder, file), few)
        code = check.main([few])
    return None if code == 1 and "1 of 1 files accepted" in said.getvalue() else "accepted"


def main(folder):
    prints = check.Prints(os.path.join(HERE, ".."))
    files = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    whole = [json.load(open(os.path.join(folder, name), encoding="utf-8")) for name in files]
    all_ = [*forged(whole, files, prints), ("all files but one missing", incomplete(folder, files[0]))]
    wrong = [f"{name}: {what}" for name, what in all_ if what]
    print("\n".join(wrong + [f"{len(all_)} forged, {len(wrong)} not refused for their own reason"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
