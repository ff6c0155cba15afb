"""Avalanches and landslides on terrain. docs/python.md is the manual.

Arrays of a world have the shape (rows, columns): rows run north from the south, columns run east. They cannot be
written, and share the world's memory: each step changes them. Units are SI.
"""

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, TypedDict, final

import numpy as np
import numpy.typing as npt

__version__: str

_Path = str | os.PathLike[str]
_Floats = npt.NDArray[np.float32]
_Slope = tuple[float, float]
_Model = Literal["bcre", "bcre-inertial", "voellmy"]

class Error(Exception):
    """What the program would print, as one sentence."""

    status: int
    """The exit status of the program: 1 a bad answer, 2 unusable input, 3 the machine fails."""

class _Volumes(TypedDict):
    initial: float
    standing: float
    rolling: float
    out: float
    poured: float
    dug: float
    fallen: float
    melted: float
    error: float

@final
class World:
    """A running world. Two threads cannot use one at the same time: Error says so."""

    def __init__(
        self,
        source: _Path,
        *,
        grid: int | None = None,
        material: str | None = None,
        model: _Model | None = None,
        size_class: str | None = None,
        set: Mapping[str, float] | None = None,
        crs: str | None = None,
        threads: int = 1,
    ) -> None:
        """Opens a scene by its name, a scene file, an elevation raster, or a recording, which begins at its start."""
    @staticmethod
    def of_heights(
        heights: npt.ArrayLike,
        cell: float,
        *,
        cover: npt.ArrayLike = 0.0,
        rolling: npt.ArrayLike = 0.0,
        material: str | None = None,
        model: _Model | None = None,
        size_class: str | None = None,
        set: Mapping[str, float] | None = None,
        name: str = "heights",
        threads: int = 1,
    ) -> World:
        """A world on these heights of its surface, m; NaN where material leaves it. `cell`: m between vertices. `cover`: m
        that can be eroded, a part of the heights. `rolling`: a release at rest upon them, m. Both vertical; one number, or
        one for each height."""

    # Time.
    def step(self, ticks: int = 1) -> None: ...
    def run_until_rest(self, most_seconds: float = 3600.0) -> Literal["energy", "rest", "limit"]:
        """Runs as `couloir run --until-rest` does, and returns what ended it."""
    def record(self, file: _Path) -> None:
        """Records all that follows, before the first step."""
    def finish(self) -> None:
        """Ends the recording; the world goes on unrecorded."""

    # Commands: each acts at the start of the next tick. `help(World.pour)` has units and ranges.
    def pour(
        self, *, x: float, y: float, radius: float, rate: float, duration: float,
        layer: Literal["rolling", "standing"] = "rolling", profile: Literal["disc", "cone"] = "disc",
        of: Literal["upper", "lower"] = "upper", slope: _Slope = (0, 90),
    ) -> None: ...
    def dig(
        self, *, x: float, y: float, radius: float, rate: float, duration: float, slope: _Slope = (0, 90)
    ) -> None: ...
    def blast(self, *, x: float, y: float, radius: float, depth: float, slope: _Slope = (0, 90)) -> None: ...
    def settle(self, *, x: float, y: float, radius: float, slope: _Slope = (0, 90)) -> None: ...
    def set(self, *, param: str, value: float) -> None: ...
    def wet(
        self, *, x: float, y: float, radius: float, rate: float, duration: float,
        profile: Literal["disc", "cone"] = "disc", slope: _Slope = (0, 90),
    ) -> None: ...
    def drain(
        self, *, x: float, y: float, radius: float, rate: float, duration: float,
        profile: Literal["disc", "cone"] = "disc", slope: _Slope = (0, 90),
    ) -> None: ...
    def storm(
        self, *, at: float, hours: float, precipitation: float, wind_from: float, wind_speed: float, warmer: float
    ) -> None: ...
    def wind(self, *, at: float, hours: float, wind_from: float, wind_speed: float) -> None: ...
    def temperature(self, *, at: float, hours: float, warmer: float, cloud: float) -> None: ...
    def cancel(self, *, event: float) -> None: ...
    def sculpt(
        self, *, x: float, y: float, radius: float, rise: float, profile: Literal["disc", "cone"] = "disc",
        slope: _Slope = (0, 90),
    ) -> None: ...
    def smooth(self, *, x: float, y: float, radius: float, rise: float, slope: _Slope = (0, 90)) -> None: ...
    def level(
        self, *, x: float, y: float, radius: float, rise: float, level: float, slope: _Slope = (0, 90)
    ) -> None: ...
    def plant(
        self, *, x: float, y: float, radius: float, stems: float = 400, diameter: float = 0.3, height: float = 22,
        slope: _Slope = (0, 90),
    ) -> None: ...
    def fell(self, *, x: float, y: float, radius: float, slope: _Slope = (0, 90)) -> None: ...
    def house(
        self, *, x: float, y: float, turn: float, length: float = 11, width: float = 9, height: float = 7.5,
        strength: float = 5,
    ) -> None: ...
    def lift(self, *, x: float, y: float, to_x: float, to_y: float) -> None: ...
    def net(
        self, *, x: float, y: float, to_x: float, to_y: float, height: float = 3, strength: float = 30
    ) -> None: ...
    def road(self, *, x: float, y: float, to_x: float, to_y: float, width: float = 6) -> None: ...
    def turn(self, *, x: float, y: float, turn: float) -> None: ...
    def remove(self, *, x: float, y: float, radius: float) -> None: ...

    # The world as it is.
    @property
    def title(self) -> str: ...
    @property
    def material(self) -> str: ...
    @property
    def parameters(self) -> dict[str, float]:
        """Of the (upper) material, those that its model uses, by the names of docs/scenes.md."""
    @property
    def warnings(self) -> list[str]:
        """Of the files that it was read from."""
    @property
    def shape(self) -> tuple[int, int]:
        """Rows, columns."""
    @property
    def cell(self) -> float:
        """m between vertices."""
    @property
    def datum(self) -> float:
        """m; the surface is datum + bedrock + depth + rolling high."""
    @property
    def tick_s(self) -> float:
        """s."""
    @property
    def tick(self) -> int:
        """Ticks done."""
    @property
    def seconds(self) -> float: ...
    @property
    def is_at_rest(self) -> bool: ...
    @property
    def hash(self) -> str:
        """Of its state, as recordings have it."""
    @property
    def volumes(self) -> _Volumes:
        """m³: standing + rolling + out - poured + dug - fallen + melted = initial, and `error` is what is missing from that, always 0."""

    def field(self, name: str) -> _Floats:
        """By its name in the state; an unknown one is an Error with all names."""
    @property
    def bedrock(self) -> _Floats:
        """m above datum."""
    @property
    def depth(self) -> _Floats:
        """m, of what can be eroded."""
    @property
    def rolling(self) -> _Floats:
        """m, of the flow."""
    @property
    def velocity_x(self) -> _Floats:
        """m/s, east."""
    @property
    def velocity_y(self) -> _Floats:
        """m/s, north."""
    @property
    def peak_rolling(self) -> _Floats:
        """m, the greatest since the start."""
    @property
    def peak_speed(self) -> _Floats:
        """m/s along the slope, the greatest where the flow was at least 1 cm deep."""
    @property
    def peak_pressure(self) -> _Floats | None:
        """kPa, the greatest; None if a density is unknown."""
    @property
    def arrival(self) -> _Floats:
        """s after which the flow was first 1 cm deep; NaN where it never was. A copy."""

@final
class Mesh:
    """A triangle mesh in the plane, for Tracker."""

    def __init__(self, positions: npt.ArrayLike, triangles: npt.ArrayLike) -> None:
        """Vertices × 2, m (of three coordinates the third is not used), and triangles × 3 vertices, from 0."""
    @staticmethod
    def read(file: _Path) -> Mesh:
        """From a Wavefront OBJ file."""
    @staticmethod
    def grid(ny: int, nx: int, cell: float) -> Mesh:
        """Of a world's grid; vertices run along rows, so that a world's velocities fit it."""
    @property
    def vertices(self) -> int: ...
    @property
    def edges(self) -> int: ...
    @property
    def positions(self) -> _Floats: ...

@final
class Tracker:
    """Follows the fronts of a flow, step after step, as `couloir track` does."""

    def __init__(
        self,
        mesh: Mesh,
        *,
        dt: float = ...,
        source: Literal["half", "paper", "fit", "level"] = "fit",
        rule: Literal["paper", "relative"] | None = None,
        threshold: float | None = None,
        jump: float | None = None,
        level: float | None = None,
        hold: bool = False,
        threads: int = 1,
    ) -> None:
        """dt: s between flows [1/60]. jump: m/s; threshold: 1/s; level: of the scalar."""
    def advance(self, velocities: npt.ArrayLike, scalar: npt.ArrayLike | None = None) -> npt.NDArray[np.void]:
        """The points at which fronts cross edges: an array with the fields i, j, f, x, y, w. A front crosses the edge from
        vertex i to vertex j > i at x, y (m), the fraction f of the edge from i, with the speed w (m/s) from i to j."""
    @property
    def outrun(self) -> int:
        """Vertices that a front passed in the last step faster than about half a cell: points there are guesses."""

def track(
    mesh: Mesh,
    velocities: Sequence[npt.ArrayLike] | npt.ArrayLike,
    scalars: Sequence[npt.ArrayLike] | npt.ArrayLike | None = None,
    *,
    dt: float = ...,
    source: Literal["half", "paper", "fit", "level"] = "fit",
    rule: Literal["paper", "relative"] | None = None,
    threshold: float | None = None,
    jump: float | None = None,
    level: float | None = None,
    hold: bool = False,
    threads: int = 1,
) -> list[npt.NDArray[np.void]]:
    """The points of every frame: velocities are frames × vertices × 2, scalars frames × vertices."""

@final
class Verdict:
    """True if the replay met every recorded state."""

    @property
    def kind(self) -> Literal["exact", "differs", "nothing proven", "not comparable"]: ...
    @property
    def compared(self) -> int:
        """States."""
    @property
    def proven_tick(self) -> int:
        """Every recorded state up to here was met; -1: none."""
    @property
    def parted(self) -> str | None:
        """Where and how the two first differ."""
    def __bool__(self) -> bool: ...

@final
class Replay:
    @property
    def title(self) -> str: ...
    @property
    def ticks(self) -> int: ...
    @property
    def warning(self) -> str | None: ...
    def verify(self, *, threads: int = 1) -> Verdict:
        """Plays it, and compares each recorded state, as `couloir replay --verify` does."""
    def world(self, *, threads: int = 1) -> World:
        """At its start, with its commands."""

def replay(file: _Path) -> Replay:
    """Reads a recording: a shipped one by its name, or a file."""

@final
class Member:
    """What a finished run of an ensemble came to. If `fault` says why it could not run, the numbers are 0."""

    @property
    def number(self) -> int:
        """From 1."""
    @property
    def sample(self) -> dict[str, float]:
        """The value of each variable."""
    @property
    def fault(self) -> str | None: ...
    @property
    def ended(self) -> str:
        """energy, rest or limit."""
    @property
    def seconds(self) -> float: ...
    @property
    def released(self) -> float:
        """m³."""
    @property
    def run_out(self) -> float:
        """m."""
    @property
    def fall(self) -> float:
        """m."""
    @property
    def extent(self) -> float:
        """m²."""
    @property
    def eroded(self) -> float:
        """m³."""
    @property
    def top_speed(self) -> float:
        """m/s, along the slope."""
    @property
    def thickness(self) -> float:
        """m, normal to the slope, the greatest."""
    @property
    def toe_x(self) -> float:
        """m east of the south-west vertex: the farthest place that it reached."""
    @property
    def toe_y(self) -> float:
        """m north of it."""
    @property
    def hash(self) -> str:
        """Of its last state."""

@final
class Members:
    def __iter__(self) -> Members: ...
    def __next__(self) -> Member: ...

@final
class Ensemble:
    """Many runs of one world with other numbers (docs/ensembles.md). Iterating plays all, in order, some at a time."""

    @property
    def title(self) -> str: ...
    @property
    def identity(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def variables(self) -> list[str]: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Member]: ...
    def sample(self, member: int) -> dict[str, float]: ...
    def world(self, member: int, *, threads: int = 1) -> World:
        """The world of a member, at its start."""
    def play(self, member: int, *, record: _Path | None = None) -> Member: ...

def ensemble(spec: _Path, *, threads: int | None = None) -> Ensemble:
    """Reads a file of an ensemble. `threads`: members at a time [one for each processor]."""
