"""Functions that other processes import by name."""

from heli_gym.storage import atomic_write, locked


def write_often(path, byte):
    for _ in range(50):
        with atomic_write(path) as file:
            file.write(byte * 100_000)


def count_up(path, times):
    """Read a number, add one and write it back, so often."""
    for _ in range(times):
        with locked(path):
            number = int(path.read_text()) if path.is_file() else 0
            with atomic_write(path) as file:
                file.write(str(number + 1).encode())
