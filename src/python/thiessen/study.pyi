import datetime
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Protocol, Union

import numpy
import numpy.typing

class _HasGeoInterface(Protocol):
    @property
    def __geo_interface__(self) -> Mapping[str, Any]: ...

_Path = Union[str, os.PathLike[str]]
_Shape = Union[Mapping[str, Any], _HasGeoInterface, bytes, str]
_Place = Union[Sequence[float], _Shape]
_Stations = Union[
    _Path, Mapping[Any, _Place], Mapping[str, Any], _HasGeoInterface, Iterable[_Place], numpy.typing.ArrayLike, Any
]
_Basins = Union[_Path, Mapping[Any, _Shape], Mapping[str, Any], _HasGeoInterface, Iterable[_Shape]]
_Readings = Union[_Path, Sequence[_Path], Mapping[Any, Any], numpy.typing.ArrayLike, Any]
_Progress = Callable[[int, int], object]
_Keyword = Union[None, bool, int, float, str, os.PathLike[str], Sequence[Union[int, float, str]], Any]
_Points = Union[None, Sequence[float], Sequence[Sequence[float]], numpy.typing.ArrayLike]
_Time = Union[None, int, str, datetime.date, numpy.datetime64, Any]
_Table = Any  # a pandas.DataFrame, or a structured array where pandas is not installed

class ThiessenWarning(UserWarning): ...

class Study:
    def __init__(
        self,
        stations: _Stations,
        basins: _Basins | None = ...,
        rainfall: _Readings | None = ...,
        *,
        ids: Iterable[Any] | None = ...,
        basin_ids: Iterable[Any] | None = ...,
        progress: _Progress | None = ...,
        **keywords: _Keyword,
    ) -> None: ...
    @property
    def stations(self) -> list[str]: ...
    @property
    def positions(self) -> numpy.ndarray[Any, numpy.dtype[numpy.float64]]: ...
    @property
    def never_reporting(self) -> list[str]: ...
    @property
    def basins(self) -> list[str]: ...
    @property
    def metric(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def notices(self) -> list[str]: ...
    def weights(self, *, without: str | Sequence[str] | None = ..., with_: _Points = ...) -> _Table: ...
    def cells(self, *, time: _Time = ...) -> dict[str, Any]: ...
    def rain(self, readings: _Readings | None = ..., *, progress: _Progress | None = ..., **keywords: _Keyword) -> _Table: ...
    def standard_errors(
        self, readings: _Readings | None = ..., *, progress: _Progress | None = ..., **keywords: _Keyword
    ) -> _Table: ...
    def influence(
        self, readings: _Readings | None = ..., *, progress: _Progress | None = ..., **keywords: _Keyword
    ) -> _Table: ...
