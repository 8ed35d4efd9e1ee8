"""`heli-export-onnx --policy best.json --out best.onnx`: a learned network for other runtimes.

The graph is the network alone, in single precision. It maps features (N, F) to actions (N, 2); a recurrent network also
maps hidden (N, H), zero at the start of a flight, to next_hidden (N, H). Features and use of the actions are those of
`heli_gym.baselines.control.residual.ResidualPolicy`.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

from heli_gym.baselines.control.residual import LEARNED, Network, RecurrentNetwork, load_learned
from heli_gym.cli import announce_replaced, command, parse
from heli_gym.storage import atomic_write, check_folder

OPSET, IR_VERSION = 17, 8  # of 2022, which current runtimes support


@dataclass
class Args:
    """Export the network of a learned policy as ONNX."""

    policy: Path = LEARNED / "lab.json"
    out: Path = Path("out/residual.onnx")


def onnx_model(network: Network | RecurrentNetwork) -> onnx.ModelProto:
    """ONNX model of a network."""
    head = network.head if isinstance(network, RecurrentNetwork) else network
    tensors: list[onnx.TensorProto] = []
    nodes: list[onnx.NodeProto] = []
    inputs: dict[str, int] = {}
    outputs = {"actions": 2}
    value = "features"

    def constant(name: str, array: np.ndarray) -> str:
        tensors.append(numpy_helper.from_array(array.astype(np.float32), name))
        return name

    def node(operator: str, *arguments: str, to: str, **attributes: Any) -> str:
        nodes.append(helper.make_node(operator, arguments, [to], **attributes))
        return to

    if isinstance(network, RecurrentNetwork):
        n = network.size
        inputs["features"], inputs["hidden"] = network.weight_input.shape[1], n
        for name, gate in (("reset", slice(n)), ("update", slice(n, 2 * n)), ("new", slice(2 * n, None))):
            for source, weight, bias in (
                ("features", network.weight_input, network.bias_input),
                ("hidden", network.weight_hidden, network.bias_hidden),
            ):
                parts = constant(f"{name}.{source}.weight", weight[gate]), constant(f"{name}.{source}.bias", bias[gate])
                node("Gemm", source, *parts, to=f"{name}.{source}", transB=1)
        for name in ("reset", "update"):
            node("Sigmoid", node("Add", f"{name}.features", f"{name}.hidden", to=f"{name}.sum"), to=name)
        node("Add", "new.features", node("Mul", "reset", "new.hidden", to="new.old"), to="new.sum")
        node("Tanh", "new.sum", to="new")
        change = node("Mul", "update", node("Sub", "hidden", "new", to="difference"), to="change")
        value = node("Add", "new", change, to="next_hidden")
        outputs["next_hidden"] = n
    else:
        inputs["features"] = network.weights[0].shape[1]
    last = len(head.weights) - 1
    for layer, (weight, bias) in enumerate(zip(head.weights, head.biases)):
        squashed = layer < last or head.tanh_output
        result = "actions" if layer == last else f"{layer}.tanh"
        parts = constant(f"{layer}.weight", weight), constant(f"{layer}.bias", bias)
        value = node("Gemm", value, *parts, to=f"{layer}.sum" if squashed else result, transB=1)
        if squashed:
            value = node("Tanh", value, to=result)
    described_inputs, described_outputs = (
        [helper.make_tensor_value_info(name, TensorProto.FLOAT, ["N", size]) for name, size in sizes.items()]
        for sizes in (inputs, outputs)
    )
    graph = helper.make_graph(nodes, "residual", described_inputs, described_outputs, tensors)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", OPSET)], ir_version=IR_VERSION)
    onnx.checker.check_model(model)
    return model


def main(args: Args | None = None) -> None:
    """Run the command `heli-export-onnx`."""
    with command("heli-export-onnx"):
        run(args or parse(Args, "heli-export-onnx", __doc__))


def run(args: Args) -> None:
    """Read the network and write the ONNX file."""
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
