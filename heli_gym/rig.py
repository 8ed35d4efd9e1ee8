"""Rig: coefficients of (3), thrust map, amplifier and sensors; an immutable value in plans, policies and results.

A rig file is TOML in one of two forms: with the coefficients of (3), or with the masses and lengths that determine
them. `docs/rigs.md` describes both. Packaged rigs are in the folder `rigs`.
"""

import math
import os
import re
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import tomli_w

from heli_gym import model
from heli_gym.model import hover_input
from heli_gym.parameters import NO_COUPLING, PATH_LIMITS, Coupling, HelicopterParameters, Limits
from heli_gym.rigid_body import RigidBodyParameters, solve_rigid_body
from heli_gym.storage import atomic_write, parse_toml
from heli_gym.thrust_map import PowerCurve, TableCurve, ThrustCurve, ThrustMap
from heli_gym.validation import as_path, is_number, require, shown

RIGS = Path(__file__).parent / "rigs"
TABLE_I = HelicopterParameters()
GRAVITY = 9.81  # m/s²
COEFFICIENTS = ("a1", "a2", "a3", "b1", "b2", "b3", "c1", "c2", "c3")
LEAST_COEFFICIENT, LARGEST_COEFFICIENT = 1e-6, 1e4  # of (3), and of masses and lengths, in SI units
LONGEST_DELAY = 0.5  # s
LEAST_STOP = 1e-3  # rad, of the pitch axis
RESERVE = 1.0 / 12.0  # share of the amplifier's range unused by plans at each end, as in (9) for 0 to 12 V
PITCH_SHARE = 5.0 / 8.0  # share of the pitch limit used by plans, as in (9) for 80 degrees


class Masses(NamedTuple):
    """Masses and lengths that determine a rig's coefficients of (3); see `coefficients_from_masses`."""

    body: float  # kg, all parts that pitch: rotors, motors, frame
    counterweight: float  # kg
    arm: float  # m, from the travel axis to the pitch axis
    counterweight_arm: float  # m, from the travel axis to the counterweight
    rotor_arm: float  # m, from the pitch axis to a rotor
    gyration_radius: float | None = None  # m, of the body about the pitch axis; None: all of its mass is at the rotors
    body_drop: float = 0.0  # m, centre of mass of the body below the pitch axis
    counterweight_drop: float = 0.0  # m, counterweight below the arm
    hinge_height: float = 0.0  # m, pitch axis above the arm
    gravity: float = GRAVITY  # m/s²
    c1: float = 0.0  # 1/s, viscous friction of travel
    c2: float = 0.0  # 1/s, of elevation
    c3: float = 0.0  # 1/s, of pitch


def coefficients_from_masses(masses: Masses) -> dict[str, float]:
    """Coefficients of (3) by name, of a rig with these masses and lengths.

    With m and M the masses of body and counterweight, l, L and p the arms of body, counterweight and rotors, r the
    radius of gyration, d, D and e the drops of body and counterweight and the height of the hinge, the inertias are

        J1 = M L² + m (l² + r²),   J2 = M (L² + D²) + m (l² + (e - d)²),   J3 = m (r² + d²)

    and a1 = g (m (e - d) - M D) / J2, a2 = g (m l - M L) / J2, a3 = -g m d / J3, b1 = -l / J1, b2 = -l / J2,
    b3 = p / J3: the rigid body of `heli_gym.rigid_body` linearised about level hover, axis by axis.

    Raises ValueError for masses or lengths that are not positive, or values that are not finite.
    """
    for name, value in masses._asdict().items():
        if name == "gyration_radius" and value is None:
            continue
        positive = name in ("body", "counterweight", "arm", "counterweight_arm", "rotor_arm", "gravity")
        if positive or name == "gyration_radius":
            unit = {"body": "kg", "counterweight": "kg", "gravity": "m/s²"}.get(name, "m")
            allowed = is_number(value) and LEAST_COEFFICIENT <= value <= LARGEST_COEFFICIENT
            require(
                f"masses.{name}",
                value,
                allowed,
                f"a positive number of {unit}, {LEAST_COEFFICIENT:g} to {LARGEST_COEFFICIENT:g}",
            )
        else:
            allowed = is_number(value) and abs(value) <= LARGEST_COEFFICIENT
            require(f"masses.{name}", value, allowed, f"a number, at most {LARGEST_COEFFICIENT:g} in magnitude")
    m, M, l, L, p, radius, d, D, e, g, c1, c2, c3 = masses  # noqa: E741
    r = p if radius is None else radius
    J1, J2, J3 = M * L**2 + m * (l**2 + r**2), M * (L**2 + D**2) + m * (l**2 + (e - d) ** 2), m * (r**2 + d**2)
    return {
        "a1": g * (m * (e - d) - M * D) / J2,
        "a2": g * (m * l - M * L) / J2,
        "a3": 0.0 - g * m * d / J3,
        "b1": -l / J1,
        "b2": -l / J2,
        "b3": p / J3,
        "c1": c1,
        "c2": c2,
        "c3": c3,
    }


@dataclass(frozen=True)
class Rig:
    """Model and data of a rig. Angles in rad, elevation positive down; voltages and thrusts are (front, back).

    Args:
        name: name of the rig.
        parameters: coefficients of (3). Their k_plus and k_minus are set to those of the `thrust_map` if that is (2),
            otherwise to zero.
        thrust_map: curves of both rotors; by default (2) with the parameters' coefficients.
        voltage_limits: (min, max) in V of the amplifiers.
        pitch_limit: rad, where a flight ends: the stop of the pitch axis.
        table_elevation: rad, of the body on the table before take-off, positive down whatever the sign of elevation.
        encoder_counts: per revolution of travel, elevation and pitch.
        sample_time: s, of the rig's own controllers.
        lag: s, nominal, first order, of the rotor speed behind the voltage.
        delay: s, nominal, from a measurement to the voltage computed from it.
        sensor_signs: +1 or -1 of travel, elevation and pitch.
        sensor_zeros: rad, likewise: angle = sign * (sensor's angle - zero).
        coupling: moments that (3) neglects. Plans and controllers do not use them; `Plant.from_rig` does.
        limits: limits of plans; by default they leave a reserve of voltage and pitch in the proportions of (9).
        mass_data: masses and lengths from which the parameters follow, for the plant "rigid"; None if unknown, or
            if the parameters are others.
        source: origin of the numbers.

    Raises:
        ValueError: if a value is invalid, values contradict each other, or the rig cannot hover; names the field, its
            value and the allowed ones.
    """

    name: str
    parameters: HelicopterParameters = TABLE_I
    thrust_map: ThrustMap = None  # type: ignore[assignment]
    voltage_limits: tuple[float, float] = (0.0, 12.0)
    pitch_limit: float = math.radians(80.0)
    table_elevation: float = math.radians(27.5)
    encoder_counts: tuple[int, int, int] = (8192, 4096, 4096)
    sample_time: float = 0.001
    lag: float = 0.1
    delay: float = 0.02
    sensor_signs: tuple[int, int, int] = (1, 1, 1)
    sensor_zeros: tuple[float, float, float] = (0.0, 0.0, 0.0)
    limits: Limits = None  # type: ignore[assignment]
    coupling: Coupling = NO_COUPLING
    mass_data: Masses | None = None
    source: str = field(default="", compare=False, repr=False)

    def __post_init__(self) -> None:
        for name in ("name", "source"):
            if not isinstance(getattr(self, name), str):
                raise ValueError(f"{name} = {shown(getattr(self, name))}: must be text")
        p = self.parameters
        if not isinstance(p, HelicopterParameters):
            raise ValueError(f"parameters = {shown(p)}: must be HelicopterParameters")
        if self.thrust_map is None:
            curve = PowerCurve(p.k_plus, p.k_minus)
            self._set("thrust_map", ThrustMap(curve, curve))
        if not isinstance(self.thrust_map, ThrustMap):
            raise ValueError(f"thrust_map = {self.thrust_map!r}: must be a ThrustMap")
        self.thrust_map.check("thrust_map")
        k_plus, k_minus = self.thrust_map.front[:2] if self.thrust_map.is_quadratic else (0.0, 0.0)  # type: ignore
        self._set("parameters", p._replace(k_plus=float(k_plus), k_minus=float(k_minus)))
        for name in COEFFICIENTS:
            value = getattr(p, name)
            within = is_number(value) and abs(value) <= LARGEST_COEFFICIENT
            most = f", at most {LARGEST_COEFFICIENT:g} in magnitude" if is_number(value) else ""
            if name.startswith("b"):
                within = within and abs(value) >= LEAST_COEFFICIENT
                require(f"parameters.{name}", value, within, f"a number other than 0{most}")
            elif name.startswith("c"):
                require(f"parameters.{name}", value, within and value >= 0.0, f"a number, at least 0{most}")
            else:
                require(f"parameters.{name}", value, within, f"a number{most}")
        if self.mass_data is not None:
            if not isinstance(self.mass_data, Masses):
                raise ValueError(f"mass_data = {self.mass_data!r}: must be Masses or None")
            if p._replace(**coefficients_from_masses(self.mass_data)) != p:
                self._set("mass_data", None)
        self._check_coupling()
        self._check_actuator()
        self._check_sensors()
        self._check_limits()

    def _set(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)

    def _triple(self, name: str, what: str, allowed: Any = lambda value: True, kind: type = float) -> None:
        values = getattr(self, name)
        if not isinstance(values, tuple | list) or len(values) != 3:
            raise ValueError(f"{name} = {shown(values)}: must be {what}, of travel, elevation and pitch")
        for value in values:
            require(name, value, is_number(value) and allowed(value), f"{what}, of travel, elevation and pitch")
        self._set(name, tuple(kind(value) for value in values))

    def _check_coupling(self) -> None:
        if not isinstance(self.coupling, tuple) or len(self.coupling) != len(Coupling._fields):
            raise ValueError(f"coupling = {self.coupling!r}: must be a Coupling")
        for name, value in Coupling(*self.coupling)._asdict().items():
            largest = math.pi / 4 if name == "centre" else 10.0
            allowed = is_number(value) and abs(value) <= largest
            require(f"coupling.{name}", value, allowed, f"a number of magnitude {largest:g} at most")
        self._set("coupling", Coupling(*map(float, self.coupling)))

    def _check_actuator(self) -> None:
        limits = self.voltage_limits
        if not isinstance(limits, tuple | list) or len(limits) != 2 or not all(map(is_number, limits)):
            raise ValueError(f"voltage_limits = {shown(limits)}: must be two finite numbers (min, max) in V")
        low, high = (float(value) for value in limits)
        if not (-1000.0 <= low < high <= 1000.0):
            raise ValueError(f"voltage_limits = {limits!r}: must be (min, max) in V with -1000 <= min < max <= 1000")
        self._set("voltage_limits", (low, high))
        for name in ("lag", "delay"):
            value = getattr(self, name)
            longest = 10.0 if name == "lag" else LONGEST_DELAY
            allowed = is_number(value) and 0.0 <= value <= longest
            require(name, value, allowed, f"at least 0 and at most {longest:g} s")
            self._set(name, float(value))

    def _check_sensors(self) -> None:
        self._triple(
            "encoder_counts", "positive whole numbers", lambda value: 1 <= value <= 2**31 and value == int(value), int
        )
        self._triple("sensor_signs", "three of 1 and -1", lambda value: value in (1, -1), int)
        self._triple("sensor_zeros", "three numbers in rad")
        value = self.sample_time
        require("sample_time", value, is_number(value) and 0.0 < value <= 1.0, "more than 0 and at most 1 s")

    def _check_limits(self) -> None:
        value = self.pitch_limit
        allowed = is_number(value) and LEAST_STOP <= value < math.pi / 2
        require("pitch_limit", value, allowed, f"more than 0 and less than pi/2 rad, at least {LEAST_STOP:g}")
        value = self.table_elevation
        allowed = is_number(value) and abs(value) < math.pi / 2
        require("table_elevation", value, allowed, "more than -pi/2 and less than pi/2 rad")
        low, high = self.voltage_limits
        if self.limits is None:
            reserve, pitch = RESERVE * (high - low), PITCH_SHARE * self.pitch_limit
            self._set("limits", Limits(low + reserve, high - reserve, -pitch, pitch))
        if not isinstance(self.limits, Limits):
            raise ValueError(f"limits = {self.limits!r}: must be Limits")
        if not low <= self.limits.u_min < self.limits.u_max <= high:
            raise ValueError(
                f"limits = {self.limits}: must be within the amplifier's voltage_limits, {low:g} to {high:g} V"
            )
        if max(self.limits.pitch_max, -self.limits.pitch_min) > self.pitch_limit:
            raise ValueError(
                f"limits = {self.limits}: must be within pitch_limit = {math.degrees(self.pitch_limit):g} deg"
            )
        for name, window in (("voltage_limits", self.voltage_limits), ("limits", self.limits.u)):
            least, most = self.thrust_bounds(window)
            lift = float(hover_input(0.0, self.parameters)[0])
            if not 2.0 * least < lift < 2.0 * most:
                raise ValueError(
                    f"{name} = {window[0]:g} to {window[1]:g} V: must permit hover, which takes a thrust of "
                    f"{0.5 * lift:.4g} N of each rotor by a2 = {self.parameters.a2:g} and b2 = {self.parameters.b2:g}, "
                    f"and thrust_map, {_curves(self.thrust_map)}, gives {least:.4g} to {most:.4g} N"
                )

    @property
    def sensor_offsets(self) -> tuple[float, ...]:
        """Readings (3,) in rad at angles of zero, times the signs: sign * reading = angle + offset."""
        return tuple(sign * zero for sign, zero in zip(self.sensor_signs, self.sensor_zeros))

    # Thrust and voltage

    def thrust(self, u: Any) -> Any:
        """Thrusts (2, ...) in N of the rotors at the voltages u (2, ...) in V, (front, back)."""
        if self.thrust_map.is_quadratic:
            return model.thrust(np.asarray(u, dtype=float), self.parameters)
        if self.thrust_map.front == self.thrust_map.back:
            return self.thrust_map.front.thrust(np.asarray(u, dtype=float))
        return np.stack((self.thrust_map.front.thrust(u[0]), self.thrust_map.back.thrust(u[1])))

    def voltage(self, f: Any) -> Any:
        """The inverse: voltages (2, ...) in V at which the rotors thrust f (2, ...) in N."""
        if self.thrust_map.is_quadratic:
            return model.voltage(np.stack(f) if isinstance(f, tuple) else f, self.parameters)
        return np.stack((self.thrust_map.front.voltage(f[0]), self.thrust_map.back.voltage(f[1])))

    def thrust_slope(self, u: Any) -> Any:
        """Slopes (2, ...) in N/V of the thrust map at the voltages u (2, ...) in V."""
        return np.stack((self.thrust_map.front.slope(u[0]), self.thrust_map.back.slope(u[1])))

    def thrust_bounds(self, window: tuple[float, float]) -> tuple[float, float]:
        """Equations (15), (16): range of thrust in N that both rotors reach within a voltage window (min, max) in V."""
        low, high = self.thrust(np.array(window) * np.ones((2, 1))).T
        return float(low.max()), float(high.min())

    def hover_voltage(self, elevation: float = 0.0) -> np.ndarray:
        """Voltages (2,) in V that hold the rig at rest at an elevation in rad; NaN if there are none."""
        return self.voltage(0.5 * hover_input(elevation, self.parameters)[0] * np.ones(2))

    # Other forms

    @classmethod
    def from_masses(cls, name: str, masses: Masses | None = None, **values: Any) -> "Rig":
        """Make a rig from masses and lengths: `Masses` or its fields by name, and other fields of `Rig` by name.

        Raises ValueError as `Rig`, TypeError for an unknown name.
        """
        if masses is None:
            masses = Masses(**{key: values.pop(key) for key in Masses._fields if key in values})
        parameters = values.pop("parameters", HelicopterParameters())._replace(**coefficients_from_masses(masses))
        return cls(name, parameters, mass_data=masses, **values)

    def masses(
        self, arm: float, counterweight_arm: float, rotor_arm: float, gravity: float = GRAVITY, variant: str = "A"
    ) -> Masses:
        """Masses and lengths that give this rig's coefficients of (3): the inverse of `from_masses`.

        The arms, in m, must be known. Variant "A" has the pitch axis above the arm, variant "B" below it; see
        `rigid_body.solve_rigid_body`. Raises ValueError if there is no solution.
        """
        p = self.parameters
        body = solve_rigid_body(variant, p, l_h=arm, l_p=rotor_arm, l_c=counterweight_arm, g=gravity)
        return Masses(
            body=body.m_h,
            counterweight=body.m_c,
            arm=arm,
            counterweight_arm=counterweight_arm,
            rotor_arm=rotor_arm,
            gyration_radius=body.r,
            body_drop=body.d_h,
            counterweight_drop=body.d_c,
            hinge_height=body.e_h,
            gravity=gravity,
            c1=p.c1,
            c2=p.c2,
            c3=p.c3,
        )

    # Files

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Rig":
        """Read a rig from a TOML file in either form.

        Raises OSError if the file cannot be read, ValueError with the line if a key is missing, unknown or invalid.
        """
        data = as_path("path", path).read_bytes()
        try:
            return cls.from_toml(data.decode())
        except ValueError as error:
            raise ValueError(f"{str(path)!r}: {error}") from error

    @classmethod
    def from_toml(cls, text: str) -> "Rig":
        """Parse a rig from the text of a rig file."""
        file = _RigFile(text)
        try:
            return cls(**file.rig_fields())
        except ValueError as error:
            if re.match(r"line \d+: ", str(error)):
                raise
            raise ValueError(f"line {file.line_of(str(error))}: {error}") from error

    def save(self, path: str | os.PathLike) -> None:
        """Write the rig to a TOML file, atomically; `load` returns the same rig."""
        path = Path(path)
        if path.suffix != ".toml":
            raise ValueError(f"path = {str(path)!r}: must end in .toml")
        with atomic_write(path) as file:
            file.write(self.to_toml().encode())

    def to_toml(self) -> str:
        """The text that `save` writes."""
        fronts, backs = self.thrust_map.front, self.thrust_map.back
        thrust = (
            _curve_table(fronts) if fronts == backs else {"front": _curve_table(fronts), "back": _curve_table(backs)}
        )
        limits: dict[str, Any] = {"u_min": self.limits.u_min, "u_max": self.limits.u_max}
        limits |= _angle("pitch_min", self.limits.pitch_min) | _angle("pitch_max", self.limits.pitch_max)
        for key, unit in PATH_LIMITS.items():
            value = getattr(self.limits, key)
            if value is not None:
                limits |= _angle(key, value) if unit else {key: float(value)}
        tables: dict[str, Any] = {"name": self.name, "source": self.source}
        tables |= _angle("pitch_limit", self.pitch_limit) | _angle("table_elevation", self.table_elevation)
        if self.mass_data is None:
            tables["coefficients"] = {name: float(getattr(self.parameters, name)) for name in COEFFICIENTS}
        else:
            masses = self.mass_data._asdict()
            tables["masses"] = {name: float(value) for name, value in masses.items() if value is not None}
        tables["thrust"] = thrust
        tables["actuator"] = {"voltage_limits": list(self.voltage_limits), "lag": self.lag, "delay": self.delay}
        tables["sensors"] = {
            "encoder_counts": list(self.encoder_counts),
            "sample_time": float(self.sample_time),
            "signs": list(self.sensor_signs),
            "zeros": list(map(float, self.sensor_zeros)),
        }
        tables["limits"] = limits
        if self.coupling != NO_COUPLING:
            tables["coupling"] = self.coupling._asdict()
        return tomli_w.dumps(tables)

    def differences(self, other: "Rig") -> list[str]:
        """Differences to another rig, for messages: one entry per field, with both values."""
        found = []
        for f in fields(self):
            mine, theirs = getattr(self, f.name), getattr(other, f.name)
            if f.name in ("name", "source", "limits", "mass_data") or mine == theirs:
                continue
            if f.name == "parameters":
                pairs = zip(HelicopterParameters._fields, mine, theirs)
                found += [f"{key} {a:g} and {b:g}" for key, a, b in pairs if a != b and key in COEFFICIENTS]
            elif f.name == "thrust_map":
                found.append(f"thrust map {_describe(mine)} and {_describe(theirs)}")
            else:
                found.append(f"{f.name} {_plain(mine)} and {_plain(theirs)}")
        return found

    def __str__(self) -> str:
        return self.name


def body_of_masses(masses: Masses) -> RigidBodyParameters:
    """Rigid body with these masses and lengths; its linearisation is `coefficients_from_masses`."""
    m = masses
    radius = m.rotor_arm if m.gyration_radius is None else m.gyration_radius
    lengths = m.arm, m.rotor_arm, m.counterweight_arm
    heights = m.body_drop, m.counterweight_drop, m.hinge_height
    return RigidBodyParameters(*lengths, m.gravity, m.body, m.counterweight, radius, *heights)


def same_dynamics(one: Rig, other: Rig) -> bool:
    """Whether two rigs have the same coefficients and thrust map; names are ignored."""
    return (one.parameters, one.thrust_map) == (other.parameters, other.thrust_map)


def check_same_rig(what: str, rig: Rig, other: Rig, where: str) -> None:
    """Raise ValueError with the differences unless two rigs have the same coefficients and thrust map.

    `what` names the object made for `rig`, and `where` names the place of `other` in the message.
    """
    if not same_dynamics(rig, other):
        names = f"{rig.name!r}" if rig.name != other.name else f"another {rig.name!r}"
        found = [text for text in rig.differences(other) if text[:2] in COEFFICIENTS or text.startswith("thrust map")]
        raise ValueError(f"{what} is for the rig {names}, and {where} is {other.name!r}: {'; '.join(found)}")


PAPER = Rig("paper", limits=Limits(), source="Kiefer, Graichen, Kugi (2010), Table I and (9)")
UNNAMED = "unnamed"  # name of rigs with only the coefficients known


def rig_of(parameters: HelicopterParameters, limits: Limits = Limits()) -> Rig:
    """The paper's rig with other coefficients and (2) as its thrust map, for callers that only have coefficients.

    Its amplifiers and pitch stop are wide enough for the limits.
    """
    if not isinstance(parameters, HelicopterParameters):
        raise ValueError(f"parameters = {shown(parameters)}: must be HelicopterParameters")
    if parameters == PAPER.parameters and limits == PAPER.limits:
        return PAPER
    low, high = PAPER.voltage_limits
    pitch = max(PAPER.pitch_limit, limits.pitch_max, -limits.pitch_min)
    wide = (min(low, limits.u_min), max(high, limits.u_max))
    name = PAPER.name if parameters == PAPER.parameters else UNNAMED
    return Rig(name, parameters, voltage_limits=wide, pitch_limit=pitch, limits=limits)


def assumed_rig(reference: Any, rig: "str | os.PathLike | Rig | HelicopterParameters | None" = None) -> Rig:
    """Rig for the design of a controller: the given one, the paper's with given parameters, or the reference's."""
    if rig is None or rig == reference.rig.parameters:
        return reference.rig
    return rig_of(rig) if isinstance(rig, HelicopterParameters) else find_rig(rig)


def rig_names() -> list[str]:
    """Names of the packaged rigs."""
    return sorted(path.stem for path in RIGS.glob("*.toml"))


def fleet_rig_names() -> list[str]:
    """Names of the rigs that were identified from measured flights, such as "fleet/ntnu-f"."""
    return sorted(f"fleet/{path.stem}" for path in RIGS.glob("fleet/*.toml"))


def find_rig(rig: "str | os.PathLike | Rig") -> Rig:
    """Return a rig by the name of a packaged one, by the path of a .toml file, or the rig itself.

    Raises ValueError for an unknown name, a missing file, or a file that describes no rig.
    """
    if isinstance(rig, Rig):
        return rig
    if not isinstance(rig, str | os.PathLike):
        raise ValueError(f"rig = {shown(rig)}: must be a Rig, a name or the path of a .toml file")
    is_path = str(rig).endswith(".toml")
    if not is_path and str(rig) not in [*rig_names(), *fleet_rig_names()]:
        names = ", ".join(map(repr, [*rig_names(), *fleet_rig_names()]))
        raise ValueError(f"rig = {str(rig)!r}: must be a Rig, the path of a .toml file or one of {names}")
    path = Path(rig) if is_path else RIGS / f"{rig}.toml"
    if not path.is_file():
        raise ValueError(f"rig = {str(rig)!r}: there is no such file")
    try:
        return Rig.load(path)
    except ValueError as error:
        raise ValueError(f"rig = {error}") from error


# Reading a file


TABLES = ("coefficients", "masses", "thrust", "actuator", "sensors", "limits", "coupling")
TOP = ("name", "source", "pitch_limit", "pitch_limit_deg", "table_elevation", "table_elevation_deg")


class _RigFile:
    """Parsed text of a rig file, with the line numbers of its keys."""

    def __init__(self, text: str) -> None:
        self.lines = text.splitlines()
        try:
            self.data = parse_toml(text)
        except ValueError as error:  # its message has the line
            raise ValueError(f"no TOML: {error}") from error

    def line(self, key: str, table: str = "") -> int:
        """Line number, from 1 on, of a key of a table; that of the table's heading if the key is missing."""
        current, heading = "", 1
        for number, line in enumerate(self.lines, 1):
            title = re.match(r"\s*\[+\s*([^\]]+?)\s*\]+", line)
            if title:
                current = title[1].replace(" ", "").replace('"', "")
                if current == table:
                    heading = number
                if not table and current.split(".")[0] == key:
                    return number
                if f"{table}.{key}".lstrip(".") == current:
                    return number
            elif current == table and re.match(rf"""\s*["']?{re.escape(key)}["']?\s*[=.]""", line):
                return number
        return heading

    def line_of(self, message: str) -> int:
        """Line number of the field of a `Rig` that an error message begins with."""
        named = re.match(r"[\w.]+", message)
        table, _, key = (named[0] if named else "").rpartition(".")
        key = {"sensor_signs": "signs", "sensor_zeros": "zeros"}.get(key, key)
        own = "thrust" if "front" not in self.data.get("thrust", ()) else table.replace("thrust_map", "thrust")
        tables = {
            "parameters": "masses" if "masses" in self.data else "coefficients",
            "thrust_map.front": own,
            "thrust_map.back": own,
        }.get(table, table)
        for where in [tables] if table else ["", "actuator", "sensors", "limits"]:
            data: Any = self.data
            for part in filter(None, where.split(".")):
                data = data.get(part, {}) if isinstance(data, dict) else {}
            for name in (key, f"{key}_deg"):
                if name in data:
                    return self.line(name, where)
        return self.line("", tables)

    def table(self, name: str, known: tuple[str, ...], required: tuple[str, ...], where: Any = None) -> dict[str, Any]:
        """Return a table. Raises ValueError for missing or unknown keys."""
        data = self.data[name] if where is None else where
        if not isinstance(data, dict):
            above, _, last = name.rpartition(".")
            raise ValueError(f"line {self.line(last, above)}: {name} = {data!r}: must be a table, [{name}]")
        for key in data:
            if key not in known:
                raise ValueError(
                    f"line {self.line(key, name)}: unknown key {key!r} in [{name}]; must be one of {', '.join(known)}"
                )
        for key in required:
            if key not in data:
                raise ValueError(f"line {self.line('', name)}: [{name}] lacks the key {key!r}")
        return data

    def angle(self, data: dict[str, Any], key: str, table: str = "") -> float | None:
        """Value in rad of a key in rad, or in degrees if the key ends in `_deg`; None without the key."""
        in_degrees = f"{key}_deg"
        if key in data and in_degrees in data:
            raise ValueError(f"line {self.line(in_degrees, table)}: {in_degrees!r}: must not stand with {key!r}")
        if in_degrees in data:
            value = data[in_degrees]
            require(f"line {self.line(in_degrees, table)}: {in_degrees}", value, True, "a number of degrees")
            return math.radians(value)
        return data.get(key)

    def rig_fields(self) -> dict[str, Any]:
        """Arguments of `Rig` by name."""
        for key in self.data:
            if key not in TABLES + TOP:
                raise ValueError(
                    f"line {self.line(key)}: unknown key {key!r}; must be one of {', '.join(TOP)}, "
                    f"or a table of {', '.join(TABLES)}"
                )
        for key in ("name", "thrust"):
            if key not in self.data:
                raise ValueError(f"line 1: the file lacks the {'table' if key in TABLES else 'key'} {key!r}")
        given = [name for name in ("coefficients", "masses") if name in self.data]
        if len(given) != 1:
            line = self.line(given[1]) if given else 1
            raise ValueError(f"line {line}: the file must have one of the tables 'coefficients' and 'masses'")
        found: dict[str, Any] = {"name": self.data["name"], "source": self.data.get("source", "")}
        if given == ["coefficients"]:
            coefficients = self.table("coefficients", COEFFICIENTS, COEFFICIENTS[:6])
        else:
            required = tuple(name for name in Masses._fields if name not in Masses._field_defaults)
            found["mass_data"] = Masses(**self.table("masses", Masses._fields, required))
            coefficients = coefficients_from_masses(found["mass_data"])
        for key, value in coefficients.items():
            require(f"line {self.line(key, given[0])}: {key}", value, True, "a number")
        found["parameters"] = HelicopterParameters()._replace(**{k: float(v) for k, v in coefficients.items()})
        found["thrust_map"] = self.thrust_map()
        for key in ("pitch_limit", "table_elevation"):
            found[key] = self.angle(self.data, key)
        if "actuator" in self.data:
            actuator = self.table("actuator", ("voltage_limits", "lag", "delay"), ())
            found |= actuator | {"voltage_limits": _as_tuple(actuator.get("voltage_limits"))}
        if "sensors" in self.data:
            sensors = self.table("sensors", ("encoder_counts", "sample_time", "signs", "zeros", "zeros_deg"), ())
            found |= {key: _as_tuple(sensors.get(key)) for key in ("encoder_counts", "sample_time")}
            found["sensor_signs"] = _as_tuple(sensors.get("signs"))
            if "zeros_deg" in sensors:
                zeros = sensors["zeros_deg"]
                if not isinstance(zeros, list):
                    raise ValueError(
                        f"line {self.line('zeros_deg', 'sensors')}: zeros_deg = {zeros!r}: must be three numbers of "
                        "degrees, of travel, elevation and pitch"
                    )
                for value in zeros:
                    require(f"line {self.line('zeros_deg', 'sensors')}: zeros_deg", value, True, "numbers of degrees")
                found["sensor_zeros"] = tuple(map(math.radians, zeros))
            else:
                found["sensor_zeros"] = _as_tuple(sensors.get("zeros"))
        if "limits" in self.data:
            required, optional = ("pitch_min", "pitch_max"), tuple(key for key, unit in PATH_LIMITS.items() if unit)
            known = ("u_min", "u_max", *required, *optional, *(f"{key}_deg" for key in required + optional), "slew")
            limits = self.table("limits", known, ("u_min", "u_max"))
            values = {key: self.angle(limits, key, "limits") for key in required + optional}
            for key in required:
                if values[key] is None:
                    raise ValueError(f"line {self.line('', 'limits')}: [limits] lacks the key '{key}_deg'")
            given_limits = limits | {key: value for key, value in values.items() if value is not None}
            for key, value in given_limits.items():
                require(f"line {self.line(key, 'limits')}: {key}", value, True, "a number")
            found["limits"] = Limits(
                **{key: float(value) for key, value in given_limits.items() if not key.endswith("_deg")}
            )
        if "coupling" in self.data:
            found["coupling"] = Coupling(**self.table("coupling", Coupling._fields, ()))
        return {key: value for key, value in found.items() if value is not None}

    def thrust_map(self) -> ThrustMap:
        """Thrust map of the table [thrust], or of [thrust.front] and [thrust.back]."""
        data = self.data["thrust"]
        if isinstance(data, dict) and ("front" in data or "back" in data):
            both = self.table("thrust", ("front", "back"), ("front", "back"))
            return ThrustMap(*(self.curve(f"thrust.{rotor}", both[rotor]) for rotor in ("front", "back")))
        curve = self.curve("thrust", data)
        return ThrustMap(curve, curve)

    def curve(self, name: str, data: Any) -> ThrustCurve:
        """Thrust curve of one rotor, from a table of coefficients or of points."""
        points = ("voltages", "thrusts")
        if isinstance(data, dict) and set(points) & set(data):
            table = self.table(name, points, points, data)
            for key in points:
                if not isinstance(table[key], list) or not all(map(is_number, table[key])):
                    raise ValueError(f"line {self.line(key, name)}: {key} = {table[key]!r}: must be finite numbers")
            return TableCurve(*(tuple(map(float, table[key])) for key in points))
        table = self.table(name, PowerCurve._fields, ("k_plus",), data)
        for key, value in table.items():
            require(f"line {self.line(key, name)}: {key}", value, True, "a number")
        return PowerCurve(**{key: float(value) for key, value in table.items()})


def _curve_table(curve: ThrustCurve) -> dict[str, Any]:
    """Table of a rig file that describes a curve."""
    if isinstance(curve, TableCurve):
        return {"voltages": list(curve.voltages), "thrusts": list(curve.thrusts)}
    return {key: float(value) for key, value in curve._asdict().items()}


def _angle(key: str, value: float) -> dict[str, float]:
    """Entry of a rig file for an angle in rad: in degrees if that converts back to exactly the same number."""
    rounded = round(math.degrees(value), 9)
    return {f"{key}_deg": rounded} if math.radians(rounded) == value else {key: float(value)}


def _describe(thrust_map: ThrustMap) -> str:
    """Short description of a thrust map, for messages."""

    def words(curve: ThrustCurve) -> str:
        if isinstance(curve, TableCurve):
            return f"of {len(curve.voltages)} points"
        zone = f", dead zone {curve.dead_zone:g} V" if curve.dead_zone else ""
        return f"{curve.k_plus:g} u^{curve.exponent:g}{zone}"

    front, back = words(thrust_map.front), words(thrust_map.back)
    return front if front == back else f"{front} (front), {back} (back)"


def _curves(thrust_map: ThrustMap) -> str:
    """Names of the fields of both curves, with the coefficients of power laws, for messages."""
    curves = (thrust_map.front,) if thrust_map.front == thrust_map.back else (thrust_map.front, thrust_map.back)
    return " and ".join(
        f"{len(curve.thrusts)} thrusts" if isinstance(curve, TableCurve) else f"k_plus = {curve.k_plus:g}"
        for curve in curves
    )


def _plain(value: Any) -> str:
    return f"({', '.join(f'{part:g}' for part in value)})" if isinstance(value, tuple) else f"{value:g}"


def _as_tuple(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
