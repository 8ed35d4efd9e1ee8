"""Export of a policy as self-contained C99: header and source of the whole controller, without allocation.

The files in `c_code` hold the control laws; `controller` writes the constants in front of them. Modules import what
`control` imports.
"""

from heli_gym.baselines.control.export.controller import EXPORTED, c_source
from heli_gym.baselines.control.export.source import PRECISIONS

__all__ = ["EXPORTED", "PRECISIONS", "c_source"]
