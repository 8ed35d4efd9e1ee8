"""Tables of leaderboards: printed, as Markdown, and as a page."""

import html
import platform
import shlex
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from heli_gym.baselines.evaluation.conditions import nominal_rig
from heli_gym.baselines.evaluation.leaderboard import Condition, Settings
from heli_gym.rig import find_rig

COLUMNS = (
    "rank",
    "policy",
    "RMS error (deg)",
    "travel (deg)",
    "elevation (deg)",
    "cost (s)",
    "crashed (%)",
    "success (%)",
    "within limits (%)",
    "better than {} (%)",
    "µs per step",
    "must know",
)
CAPTION = (
    "Interquartile means over the draws and, in brackets, 95 % intervals of paired resamples. RMS error: distance in "
    "travel and elevation together, to the end of the maneuver; a crashed flight counts at its last error, and as the "
    "worst. Cost: excess over the planned limits, in their widths times s. Within limits: share of flights that never "
    "left (9). Better: probability of a smaller error on the same draw."
)


def columns_of(table: dict[str, Any]) -> list[str]:
    """Headings of a table."""
    return [name.format(table["against"] or "–") for name in COLUMNS]


def cells(entry: dict[str, Any]) -> list[str]:
    """Cells of a row under COLUMNS."""

    def with_interval(value: dict[str, Any]) -> str:
        low, high = value["interval"]
        return f"{value['iqm']:.3g} [{low:.3g}, {high:.3g}]"

    low, high = entry["rank"]["interval"]
    better = entry["probability_of_improvement"]
    return [
        f"{entry['rank']['value']:g} [{low:.0f}, {high:.0f}]",
        f"{entry['label']} ({entry['policy']})" if entry["label"] != entry["policy"] else entry["policy"],
        *(with_interval(entry[key]) for key in ("rms_error_deg", "rms_travel_deg", "rms_elevation_deg", "cost")),
        f"{100 * entry['crashed']:.1f}",
        f"{100 * entry['success']:.1f}",
        f"{100 * entry['within_limits']:.1f}",
        "–" if better is None else f"{100 * better:.0f}",
        f"{entry['microseconds_per_step']:.0f}",
        entry["must_know"],
    ]


def heading(table: dict[str, Any]) -> str:
    """Title of a table, with the number of draws common to all its policies."""
    draws = table["policies"][0]["draws"] if table["policies"] else 0
    return f"{table['title']}, {draws} draws"


def print_table(table: dict[str, Any], console: Console) -> None:
    """Print a table without its last column."""
    shown = Table(title=heading(table))
    for name in columns_of(table)[:-1]:
        shown.add_column(name, justify="left" if name == "policy" else "right")
    for entry in table["policies"]:
        rank, _, *rest, _ = cells(entry)
        shown.add_row(rank, entry["policy"], *rest)
    console.print(shown)


def note(settings: Settings) -> str:
    """Sentence on the common settings of all tables."""
    return (
        f"heli-gym {version('heli-gym')}; seeds from {settings.seed} on; starts up to {settings.start_spread_deg:g}° "
        f"off; control period {1e3 * settings.control_period:g} ms; times on {platform.machine()}."
        + (f" Rig: {find_rig(settings.rig).name}." if settings.rig else "")
    )


def markdown(tables: Sequence[dict[str, Any]], settings: Settings) -> str:
    """Markdown text of all tables."""

    def line(values: Sequence[str]) -> str:
        return f"| {' | '.join(value.replace('|', chr(92) + '|') for value in values)} |"

    parts = ["# Leaderboard", "", note(settings), "", CAPTION]
    for table in tables:
        names = columns_of(table)
        parts += ["", f"## {heading(table)}", "", line(names), line(["---"] * len(names))]
        parts += [line(cells(entry)) for entry in table["policies"]]
    return "\n".join(parts) + "\n"


STYLE = (
    "body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:90rem;padding:0 1rem;color:#1d242d;"
    "background:#fff}div{overflow-x:auto}table{border-collapse:collapse;font-size:14px}"
    "th,td{padding:.35rem .7rem;text-align:right;border-bottom:1px solid #dfe4ea;white-space:nowrap}"
    "th{vertical-align:bottom}td:nth-child(2),th:nth-child(2),td:last-child,th:last-child{text-align:left}"
    "code{font-size:12px}summary{cursor:pointer;min-height:24px}"
    "@media(prefers-color-scheme:dark){body{color:#e8ecf1;background:#14181d}a{color:#7cc4ff}th,td{border-color:#39424d}}"
)


def page(tables: Sequence[dict[str, Any]], settings: Settings, pages: bool) -> str:
    """HTML page of all tables, without scripts and external resources."""
    escape = html.escape
    parts = [
        '<!doctype html><html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">",
        f"<title>heli_gym: leaderboard</title><style>{STYLE}</style></head><body><h1>Leaderboard</h1>",
        f"<p>{escape(note(settings))}</p><p>{escape(CAPTION)}</p>",
    ]
    for table in tables:
        condition = Condition(table["plant"], table["reference"])
        link = f' <a href="{escape(page_name(condition))}">flights in plots and 3D</a>' if pages else ""
        parts.append(f"<h2>{escape(heading(table))}</h2><p>{link}</p><div><table><thead><tr>")
        parts += [f'<th scope="col">{escape(name)}</th>' for name in columns_of(table)]
        parts.append("</tr></thead><tbody>")
        for entry in table["policies"]:
            parts.append("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells(entry)) + "</tr>")
        parts.append("</tbody></table></div><details><summary>Single flights</summary><ul>")
        for entry in table["policies"]:
            for name in ("median", "worst"):
                order = flight_order(entry["policy"], condition, entry[f"{name}_seed"], settings)
                parts.append(f"<li>{name} of {escape(entry['label'])}: <code>{escape(order)}</code></li>")
        parts.append("</ul></details>")
    return "".join((*parts, "</body></html>\n"))


def flight_order(policy: str, condition: Condition, seed: int, settings: Settings) -> str:
    """Command that flies one flight of the leaderboard and writes its page."""
    arguments = {
        "policies": policy,
        "plant": condition.plant,
        "rig": nominal_rig(condition.plant, settings.rig),
        "reference": condition.reference,
        "episodes": 1,
        "seed": seed,
        "control-period": settings.control_period,
        "start-spread-deg": settings.start_spread_deg,
        "report": "flight.html",
    }
    return shlex.join(["heli-evaluate", "--no-figures", *(f"--{name}={value}" for name, value in arguments.items())])


def page_name(condition: Condition) -> str:
    """Path of a condition's page, relative to the leaderboard's folder."""
    return f"pages/{condition.plant}-{Path(condition.reference).name.removesuffix('.npz')}.html"
