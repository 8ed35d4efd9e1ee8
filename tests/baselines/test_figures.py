import os
import re
import subprocess
import sys

import matplotlib
import numpy as np
import pytest
from matplotlib.colors import same_color
from matplotlib.image import imread
from matplotlib.text import Text

from heli_gym.baselines.evaluation import figure_style, figures
from heli_gym.baselines.paper.tvlqr import Gains, riccati_gains
from heli_gym.model import thrust
from heli_gym.parameters import HelicopterParameters, Limits
from heli_gym.trajectory import Trajectory

PARAMETERS = HelicopterParameters()
LIMITS = Limits(u_min=2.0, u_max=10.0, pitch_min=-0.6, pitch_max=0.5)


def wave(limits, duration, period, phase):
    """A trajectory with another motion on every axis."""
    t = np.arange(0.0, duration + period / 2, period)
    x = np.array([np.sin(t + phase + row) / (1 + row) for row in range(6)])
    u = np.array([6.0 + 5.5 * np.sin(t + phase), 6.0 + 5.5 * np.cos(t + phase)])
    return Trajectory(t, x, u, limits)


REFERENCE = wave(LIMITS, 4.0, 0.01, 0.0)
FLIGHTS = {
    "feedforward + TV-LQR": wave(Limits(), 4.0, 0.02, 0.3),
    "crashed": wave(Limits(), 1.5, 0.02, 0.6),
    "hover LQR with a long name": wave(Limits(), 4.0, 0.02, 0.9),
}
TITLE = "wave on the plant nominal"
GAINS = Gains(np.linspace(0.0, 4.0, 9), np.arange(108.0).reshape(2, 6, 9), np.zeros((6, 6, 9)))
DRAW = {
    "thrust map": lambda: figures.thrust_map(PARAMETERS, LIMITS),
    "feedforward": lambda: figures.feedforward(REFERENCE, PARAMETERS, "a plan"),
    "input constraints": lambda: figures.input_constraints(LIMITS, PARAMETERS),
    "smooth saturation": lambda: figures.smooth_saturation(LIMITS.pitch),
    "ramp saturation": lambda: figures.ramp_saturation(),
    "gains": lambda: figures.gains(GAINS),
    "angles": lambda: figures.angles(REFERENCE, FLIGHTS, TITLE),
    "voltages": lambda: figures.voltages(REFERENCE, FLIGHTS, TITLE),
    "overview": lambda: figures.overview(REFERENCE, FLIGHTS, TITLE),
    "overview of a plan": lambda: figures.overview(REFERENCE, {}, TITLE),
}


@pytest.fixture(scope="module")
def drawn():
    return {name: draw() for name, draw in DRAW.items()}


def panel(figure, label):
    [axes] = [axes for axes in figure.axes if axes.get_ylabel().startswith(label)]
    return axes


def curve(axes, label):
    [line] = [line for line in axes.lines if line.get_label() == label]
    return line


def limit_lines(axes):
    return [line for line in axes.lines if same_color(line.get_color(), figures.RED)]


def limits_on(axes, coordinate):
    """The values of the limit lines that are constant in this coordinate."""
    values = [np.asarray(line.get_data()["xy".index(coordinate)], dtype=float) for line in limit_lines(axes)]
    return sorted(value[0] for value in values if np.ptp(value) == 0.0)


@pytest.mark.parametrize("name", DRAW)
def test_every_axis_has_a_label_with_a_unit(drawn, name):
    for axes in drawn[name].axes:
        assert re.search(r"\S\s\(\S.*\)$", axes.get_ylabel())
        shared_with_the_panel_below = not axes.xaxis.get_major_ticks()[0].label1.get_visible()
        assert shared_with_the_panel_below or re.search(r"\S \(\S.*\)$", axes.get_xlabel())


@pytest.mark.parametrize("name", ["input constraints", "gains", "voltages"])
def test_nothing_sticks_out_of_the_picture(drawn, name):
    figure = drawn[name]
    figure.draw_without_rendering()
    box = figure.get_tightbbox()
    assert box.x0 >= 0.0 and box.y0 >= 0.0
    width, height = figure.get_size_inches()
    assert box.x1 <= width and box.y1 <= height


@pytest.mark.parametrize("name", ["angles", "voltages", "overview", "overview of a plan"])
def test_a_figure_of_flights_names_the_maneuver(drawn, name):
    assert drawn[name].get_suptitle() == TITLE


@pytest.mark.parametrize("name", ["feedforward", "angles", "overview", "overview of a plan"])
def test_pitch_limits_are_the_reference_s_in_degrees(drawn, name):
    np.testing.assert_allclose(limits_on(panel(drawn[name], "pitch"), "y"), np.degrees([-0.6, 0.5]))


@pytest.mark.parametrize("name", ["feedforward", "voltages", "overview", "overview of a plan"])
def test_voltage_limits_are_the_reference_s(drawn, name):
    for motor in ("front", "back"):
        assert limits_on(panel(drawn[name], f"{motor} motor"), "y") == [2.0, 10.0]


def test_thrust_map_marks_the_voltage_limits_and_hover(drawn):
    [axes] = drawn["thrust map"].axes
    assert limits_on(axes, "x") == [2.0, 10.0]
    [(u, f)] = [line.get_xydata()[0] for line in axes.lines if line.get_marker() == "o"]
    lift = 2.0 * f * PARAMETERS.b2 + PARAMETERS.a2
    assert lift == pytest.approx(0.0, abs=1e-12)
    assert u == pytest.approx(7.893, abs=1e-3)


def test_thrust_difference_is_limited_by_one_fan_at_its_highest_and_one_at_its_lowest_voltage(drawn):
    most = PARAMETERS.k_plus * (10.0**2 - 2.0**2)
    np.testing.assert_allclose(limits_on(panel(drawn["feedforward"], "thrust difference"), "y"), [-most, most])
    np.testing.assert_allclose(limits_on(panel(drawn["input constraints"], "thrust sum"), "x"), [-most, most])


def test_thrust_sum_is_limited_by_the_voltages_at_the_thrust_difference(drawn):
    axes = panel(drawn["feedforward"], "thrust sum")
    lower, upper = (line.get_ydata()[100] for line in limit_lines(axes))
    f = thrust(np.linspace(2.0, 10.0, 20001), PARAMETERS)
    back = f - curve(panel(drawn["feedforward"], "thrust difference"), "plan").get_ydata()[100]
    allowed = (f + back)[(back >= f[0]) & (back <= f[-1])]
    assert (allowed.min(), allowed.max()) == pytest.approx((lower, upper), abs=1e-4)


def test_both_planes_of_the_input_constraints_show_the_same_corners(drawn):
    thrusts, virtual = drawn["input constraints"].axes
    corners = [
        {text.get_text(): np.array(text.xy) for text in axes.texts if text.get_text() in "ABCD"}
        for axes in (thrusts, virtual)
    ]
    assert set(corners[0]) == set(corners[1]) == set("ABCD")
    for letter, (front, back) in corners[0].items():
        np.testing.assert_allclose(corners[1][letter], (front - back, front + back), atol=1e-12)


def test_smooth_saturation_has_a_tangent_of_slope_1_and_asymptotes_at_its_bounds(drawn):
    [axes] = drawn["smooth saturation"].axes
    [tangent] = [line for line in axes.lines if line.get_label().startswith("slope")]
    assert tangent.get_slope() == pytest.approx(1.0)
    low, high = limits_on(axes, "y")
    assert (low, high) == pytest.approx(tuple(np.degrees([-0.6, 0.5])))
    y = axes.lines[0].get_ydata()
    assert low < y[0] < 0.99 * low and 0.99 * high < y[-1] < high


def test_ramp_is_the_identity_between_its_limits(drawn):
    [axes] = drawn["ramp saturation"].axes
    low, high = limits_on(axes, "y")
    x, y = axes.lines[0].get_data()
    np.testing.assert_array_equal(y, np.minimum(np.maximum(x, low), high))
    assert x[0] < low and x[-1] > high


def test_gains_are_drawn_row_by_row_in_the_paper_s_line_styles(drawn):
    for row, axes in enumerate(drawn["gains"].axes):
        assert [line.get_linestyle() for line in axes.lines] == ["-", "-", "--", "--", ":", ":"]
        np.testing.assert_array_equal([line.get_ydata() for line in axes.lines], GAINS.K[row])
        assert len({(line.get_linestyle(), line.get_color()) for line in axes.lines}) == 6


@pytest.mark.parametrize("name", FLIGHTS)
def test_angles_and_their_errors_are_those_of_the_flight_while_it_lasts(drawn, name):
    flight = FLIGHTS[name]
    for row, angle in enumerate(("travel", "elevation", "pitch")):
        flown = curve(panel(drawn["angles"], angle), name)
        error = curve(panel(drawn["angles"], f"error of {angle}"), name)
        nominal = REFERENCE.x[2 * row, ::2][: len(flight.t)]
        np.testing.assert_array_equal(flown.get_xdata(), flight.t)
        np.testing.assert_allclose(flown.get_ydata(), np.rad2deg(flight.x[2 * row]))
        np.testing.assert_allclose(error.get_ydata(), np.rad2deg(flight.x[2 * row] - nominal), atol=1e-9)


@pytest.mark.parametrize("name", FLIGHTS)
def test_flown_voltages_are_held_until_the_next_sample(drawn, name):
    flight = FLIGHTS[name]
    for figure in (drawn["voltages"], drawn["overview"]):
        for row, motor in enumerate(("front", "back")):
            line = curve(panel(figure, f"{motor} motor"), name)
            assert line.get_drawstyle() == "steps-post"
            np.testing.assert_array_equal(line.get_data(), (flight.t, flight.u[row]))


def test_rounding_errors_do_not_fill_a_panel():
    x = np.zeros((6, 5))
    x[2] = [0.0, 1e-17, -1e-17, 1e-17, 0.0]
    flat = Trajectory(np.arange(5.0), x, np.full((2, 5), 7.9))
    low, high = panel(figures.overview(flat, {}, TITLE), "elevation").get_ylim()
    assert low <= -1.0 and high >= 1.0


@pytest.mark.parametrize("limits, expected", [(Limits(), True), (LIMITS, False)])
def test_the_paper_s_numbers_stand_with_its_own_limits_only(limits, expected):
    figure = figures.input_constraints(limits, PARAMETERS)
    texts = [axes.get_title() for axes in figure.axes] + [text.get_text() for text in figure.legends[0].get_texts()]
    assert ("paper" in " ".join(texts)) == expected


@pytest.fixture
def figure():
    return figures.ramp_saturation()


def test_save_writes_one_picture_of_150_dots_per_inch(tmp_path, figure):
    figure_style.save(figure, tmp_path / "ramp.png")
    figure_style.save(figure, str(tmp_path / "ramp.png"))
    assert [path.name for path in tmp_path.iterdir()] == ["ramp.png"]
    width, height = figure.get_size_inches()
    assert imread(tmp_path / "ramp.png").shape[:2] == (round(150 * height), round(150 * width))


def test_save_that_fails_leaves_the_old_picture_and_no_litter(tmp_path, figure, monkeypatch):
    (tmp_path / "ramp.png").write_bytes(b"old")

    def disk_full(file, **_):
        file.write(b"half")
        raise OSError("disk full")

    monkeypatch.setattr(figure, "savefig", disk_full)
    with pytest.raises(OSError, match="disk full"):
        figure_style.save(figure, tmp_path / "ramp.png")
    assert [(path.name, path.read_bytes()) for path in tmp_path.iterdir()] == [("ramp.png", b"old")]


def test_save_refuses_names_and_columns_that_it_does_not_know(tmp_path, figure):
    with pytest.raises(ValueError, match=r"ramp\.jpg.*\.png"):
        figure_style.save(figure, tmp_path / "ramp.jpg")
    with pytest.raises(ValueError, match="columns = 3"):
        figure_style.save(figure, tmp_path / "ramp.png", 3)
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize(("suffix", "begin"), [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")])
def test_a_figure_is_saved_in_each_format_and_twice_with_the_same_bytes(tmp_path, suffix, begin):
    for name in ("a", "b"):
        figure_style.save(figures.smooth_saturation(Limits().pitch), tmp_path / f"{name}.{suffix}", 1)
    saved = (tmp_path / f"a.{suffix}").read_bytes()
    assert saved.startswith(begin)
    assert saved == (tmp_path / f"b.{suffix}").read_bytes()


@pytest.mark.parametrize(("columns", "width"), [(1, 3.5), (2, 7.16)])
def test_for_print_a_figure_is_as_wide_as_the_columns(tmp_path, columns, width):
    figure = figures.smooth_saturation(Limits().pitch)
    figure_style.save(figure, tmp_path / "a.png", columns)
    assert figure.get_size_inches()[0] == pytest.approx(width)
    assert max(text.get_fontsize() for text in figure.findobj(Text)) <= 8.0


def test_the_lines_of_the_gains_are_named_at_their_ends_without_overlap(paper_plan):
    figure = figures.gains(riccati_gains(paper_plan))
    for axes in figure.axes:
        places = sorted(text.xyann[1] for text in axes.texts)
        assert [len(axes.lines), len(places)] == [6, 6]
        assert np.diff(places).min() > 0.085


def test_the_axis_of_elevation_says_which_way_is_positive(paper_plan):
    figure = figures.overview(paper_plan, {}, "a plan")
    assert any("elevation" in axes.get_ylabel() and "positive down" in axes.get_ylabel() for axes in figure.axes)


def test_figures_leave_matplotlib_s_settings_alone():
    before = dict(matplotlib.rcParams)
    figures.overview(REFERENCE, FLIGHTS, TITLE)
    assert dict(matplotlib.rcParams) == before


def test_figures_need_no_pyplot():
    code = "import sys, heli_gym.baselines.evaluation.figures; sys.exit('matplotlib.pyplot' in sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_only_the_papers_maneuver_is_compared_with_the_papers_duration(paper_plan):
    half = Trajectory(paper_plan.t, paper_plan.x * [[0.5], [0.5], [1.0], [1.0], [1.0], [1.0]], paper_plan.u)
    for trajectory, compared in ((paper_plan, True), (half, False)):
        title = figures.feedforward(trajectory, PARAMETERS, "a plan").get_suptitle()
        assert ("(paper: 10 s)" in title) is compared
