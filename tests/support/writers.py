"""Functions for other processes, which have to import them by name."""

from heli_gym.storage import atomic_write


def write_often(path, byte):
    for _ in range(50):
        with atomic_write(path) as file:
            file.write(byte * 100_000)
