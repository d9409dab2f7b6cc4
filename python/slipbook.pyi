from array import array
from collections.abc import Collection, Sequence
from os import PathLike
from typing import Final, Literal, TypeAlias, TypedDict, final

from typing_extensions import Unpack

# A number in SI, or a text with its unit.
_Value: TypeAlias = str | float
_Values: TypeAlias = _Value | Sequence[_Value]
# Any sequence of numbers: a list, an array of NumPy.
_Column: TypeAlias = Collection[float]
# A file, or the time and up to three accelerations.
_Recording: TypeAlias = str | PathLike[str] | Sequence[_Column]

class _Words(TypedDict, total=False):
    mu: _Value | None
    mu_s: _Value | None
    mu_back: _Value | None
    g: _Value | None
    radius: _Value | None
    kappa: _Value | None
    tilt: _Value | None
    pull: _Values | None
    accelerate: _Values | None
    record: _Recording | None
    columns: str | None
    towards: _Value | None
    turn: _Value | None
    belt: _Value | None
    at: _Values | None
    throw: _Value | None
    throw_in_room: _Value | None
    set_down: bool
    spin: _Values | None
    units: Literal["mu g", "mu g Omega", "mu g R"] | None
    width: _Value | None
    within: _Value | None
    until: str | None

class _Measured(TypedDict):
    mu_k: tuple[float, float] | None
    mu_s: tuple[float, float] | None
    why: tuple[str | None, str | None]
    coulomb: bool
    verdict: str
    noise: float
    assumed: str | None
    zeroed: bool
    normal: bool
    stretches: list[tuple[float, float, Literal["sticks", "slips", "is pushed"]]]
    units: dict[str, str]

class _Claim(TypedDict):
    id: str
    title: str
    section: str
    equation: int | None
    plain: str
    verdict: Literal[
        "confirmed", "degenerate", "conditional", "misprint", "misderived", "inherited", "refuted", "definition", "undecided"
    ]
    wrong: str | None
    ground: str
    standing: Literal["proved", "argued", "measured", "defined"] | None
    correction: str | None

class _Ends(TypedDict):
    outcome: list[Literal["rest", "far", "late", "unfinished", "refused"]]
    sigma: array[float]
    sigma_error: array[float]
    tau: array[float]
    tau_error: array[float]

__all__ = [
    "WORDS",
    "__version__",
    "Answer",
    "Scene",
    "ball",
    "block",
    "claims",
    "find",
    "measure",
    "scene",
    "sheet",
    "turntable_ends",
]

WORDS: dict[str, str]
__version__: str

@final
class Answer:
    t: Final[float]
    x: Final[float]
    y: Final[float]
    v_x: Final[float]
    v_y: Final[float]
    # Of a ball alone.
    omega_x: Final[float]
    omega_y: Final[float]
    omega_z: Final[float]
    path: Final[float]
    heat: Final[float]
    numbers: Final[dict[str, float]]
    errors: Final[dict[str, float]]
    units: Final[dict[str, str]]
    events: Final[list[tuple[float, Literal["slides", "rests", "rolls"]]]]
    second: Final[tuple[str, dict[str, float]] | None]
    def at(self, t: _Value) -> dict[str, float]: ...
    def table(self, dt: _Value) -> dict[str, array[float]]: ...

@final
class Scene:
    words: Final[dict[str, object]]
    def with_(self, **words: Unpack[_Words]) -> Scene: ...
    def on(self, record: _Recording, /, **words: Unpack[_Words]) -> Scene: ...
    def run(self, until: str | None = None) -> Answer: ...

def block(**words: Unpack[_Words]) -> Scene: ...
def ball(**words: Unpack[_Words]) -> Scene: ...
def scene(body: Literal["block", "ball"], **words: Unpack[_Words]) -> Scene: ...
def claims() -> list[_Claim]: ...
def sheet(id: str) -> str: ...
def find(scene: Scene, word: str, low: _Value, high: _Value, **number: _Value) -> list[float]: ...
def measure(
    recording: _Recording,
    /,
    *,
    columns: str | None = None,
    rest: Sequence[_Value] | None = None,
    g: _Value | None = None,
) -> _Measured: ...
def turntable_ends(
    rho: _Column, p: _Column, psi: _Column, *, far: float = 100.0, late: float = 50.0
) -> _Ends: ...
