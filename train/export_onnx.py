"""`heli-export-onnx --policy best.json --out best.onnx`: a learned network for other runtimes.

Only the network, from features (N, F) to actions (N, 2) in single precision: what makes the features and what is done
with the actions is `heli_gym.baselines.control.residual.ResidualPolicy`.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from heli_gym.baselines.control.residual import LEARNED, Network, load_learned
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.storage import atomic_write, check_folder

OPSET, IR_VERSION = 17, 8  # of 2022, which runtimes have learned to read


@dataclass
class Args:
    """Export a learned policy's network."""

    policy: Path = LEARNED / "lab.json"
    out: Path = Path("out/residual.onnx")


def onnx_model(network: Network) -> onnx.ModelProto:
    """The network as an ONNX graph."""
    nodes, tensors, value = [], [], "features"
    last = len(network.weights) - 1
    for layer, (weight, bias) in enumerate(zip(network.weights, network.biases)):
        for name, array in (("weight", weight), ("bias", bias)):
            tensors.append(numpy_helper.from_array(array.astype(np.float32), f"{layer}.{name}"))
        squashed = layer < last or network.tanh_output
        result = f"{layer}.sum" if squashed or layer < last else "actions"
        nodes.append(helper.make_node("Gemm", [value, f"{layer}.weight", f"{layer}.bias"], [result], transB=1))
        value = result
        if squashed:
            value = f"{layer}.tanh" if layer < last else "actions"
            nodes.append(helper.make_node("Tanh", [result], [value]))
    graph = helper.make_graph(
        nodes,
        "residual",
        [helper.make_tensor_value_info("features", TensorProto.FLOAT, ["N", network.weights[0].shape[1]])],
        [helper.make_tensor_value_info("actions", TensorProto.FLOAT, ["N", 2])],
        tensors,
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=IR_VERSION)
    onnx.checker.check_model(model)
    return model


def main(args: Args | None = None) -> None:
    """The command `heli-export-onnx`."""
    with command("heli-export-onnx"):
        run(args or parse(Args, "heli-export-onnx", __doc__))


def run(args: Args) -> None:
    """Read, export, write."""
    if args.out.is_dir():
        raise ValueError(f"out = {str(args.out)!r}: must be a file")
    check_folder("out", args.out.parent)
    _, network = load_learned(args.policy)
    announce_replaced("heli-export-onnx", args.out)
    with atomic_write(args.out) as file:
        file.write(onnx_model(network).SerializeToString())
    print(f"written to {args.out}")


if __name__ == "__main__":
    main()
