"""Series and matrices of numbers in text and MATLAB files, by name."""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy.io import loadmat

MOST_NUMBERS = 2**25  # of a matrix in a file


def read_csv(path: Path) -> dict[str, np.ndarray]:
    """Read the columns, by name, of a text file with a header; separated by commas, semicolons, tabs or blanks."""
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError as error:
        raise ValueError(f"{str(path)!r} must be a text file: {error}") from error
    lines = [line for line in lines if line.strip() and not line.lstrip().startswith(("#", "%"))]
    if len(lines) < 4:
        raise ValueError(f"{str(path)!r} must have a line of names and at least three rows of numbers")
    separator = max((",", ";", "\t"), key=lines[0].count)
    separator_or_blanks = separator if separator in lines[0] else None
    names = [name.strip().strip("\"'") for name in lines[0].split(separator_or_blanks)]
    if all(is_number(name) for name in names):
        names = [f"column[{i}]" for i in range(len(names))]
    else:
        lines = lines[1:]
    if separator_or_blanks != ",":
        lines = [line.replace(",", ".") for line in lines]  # decimal commas
    rows = np.empty((len(lines), len(names)))
    for i, line in enumerate(lines):
        cells = line.split(separator_or_blanks)
        if len(cells) != len(names):
            raise ValueError(
                f"{str(path)!r}, row {i + 1}: must have {len(names)} cells, and has {len(cells)}: {line[:60]!r}"
            )
        for j, cell in enumerate(cells):
            try:
                rows[i, j] = float(cell) if cell.strip() else math.nan
            except ValueError:
                raise ValueError(
                    f"{str(path)!r}, row {i + 1}, column {names[j]!r}: must be a number, not {cell.strip()[:40]!r}"
                ) from None
    return {name: rows[:, j] for j, name in enumerate(names)}


def is_number(text: str) -> bool:
    """Whether the text is a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def read_mat(path: Path) -> dict[str, np.ndarray]:
    """Read all series and matrices of numbers in a MATLAB file, by name; fields of structs by dotted names."""
    with open(path, "rb") as file:
        head = file.read(8)
    if head == b"\x89HDF\r\n\x1a\n" or path_is_hdf5(path):
        return read_hdf5(path)
    try:
        contents = loadmat(path, simplify_cells=True)
    except Exception as error:  # scipy raises exceptions of any type for damaged files
        raise ValueError(f"{str(path)!r} must be a .csv or a .mat file: {error}") from error
    found: dict[str, np.ndarray] = {}
    for name, value in contents.items():
        if not name.startswith("__"):
            flatten(name, value, found)
    return found


def flatten(name: str, value: Any, found: dict[str, np.ndarray]) -> None:
    """Add the series and matrices of numbers in a value of a MATLAB file to `found`, under dotted names."""
    if isinstance(value, dict):
        for key, item in value.items():
            flatten(f"{name}.{key}", item, found)
    elif isinstance(value, Sequence | np.ndarray) and not isinstance(value, str):
        array = np.asarray(value)
        if array.dtype == object or array.dtype.kind not in "biuf":
            for i, item in enumerate(array.ravel()):
                if isinstance(item, dict):
                    flatten(f"{name}[{i}]", item, found)
        elif array.size > 2:
            array = array.squeeze()
            if array.ndim in (1, 2):
                found[name] = array.astype(float)


def path_is_hdf5(path: Path) -> bool:
    """Whether the file is a MATLAB 7.3 file: HDF5 after a header of 512 bytes."""
    with open(path, "rb") as file:
        file.seek(512)
        return file.read(8) == b"\x89HDF\r\n\x1a\n"


def read_hdf5(path: Path) -> dict[str, np.ndarray]:
    """Read all series and matrices of numbers in a MATLAB 7.3 file, whose matrices are stored transposed."""
    try:
        import h5py
    except ImportError as error:
        raise ImportError(f"{str(path)!r} is a MATLAB 7.3 file: pip install 'heli-gym[eval]' (h5py)") from error
    found: dict[str, np.ndarray] = {}

    def visit(name: str, item: Any) -> None:
        if isinstance(item, h5py.Dataset) and item.dtype.kind in "biuf" and not name.startswith("#"):
            if item.size > MOST_NUMBERS:
                raise ValueError(f"{str(path)!r}: {name} has {item.size} numbers; must be at most {MOST_NUMBERS}")
            flatten(name.replace("/", "."), item[()].T, found)

    try:
        with h5py.File(path, "r") as file:
            file.visititems(visit)
    except (OSError, RuntimeError) as error:
        raise ValueError(f"{str(path)!r} must be a MATLAB 7.3 file: {error}") from error
    return found
