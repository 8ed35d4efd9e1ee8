"""Write src/equations.ts: the equations of motion and of the plant, translated from their Python functions.

Run it after a change of one of these functions: `python web/translate.py`; with `--check`, it only reports by its
exit status whether the file is up to date. It knows the Python of pure functions of
numbers and tuples: assignments, arithmetic, subscripts, calls of each other, and one return.
"""

import ast
import inspect
import re
import sys
from pathlib import Path
from textwrap import dedent
from types import ModuleType

from heli_gym import model, plant, rigid_body
from heli_gym.baselines.paper import normal_form
from heli_gym.baselines.planning import spline_kernel
from heli_gym.parameters import HelicopterParameters

OUT = Path(__file__).parent / "src" / "equations.ts"
FUNCTIONS: dict[ModuleType, tuple[str, ...]] = {
    model: (
        "thrust",
        "power_thrust",
        "virtual_input",
        "fan_thrusts",
        "dynamics",
        "solve_2x2",
        "inverse_dynamics",
        "thrust_vector",
    ),
    rigid_body: (
        "mass_matrix",
        "coriolis",
        "gravity",
        "generalised_forces",
        "solve_symmetric",
        "rigid_dynamics",
    ),
    plant: (
        "friction",
        "with_friction_and_disturbances",
        "with_lift",
        "with_coupling",
        "foot_force",
        "with_contact",
        "quantise",
    ),
    normal_form: ("internal_dynamics",),
    spline_kernel: ("basis",),
}
RECORDS = {"Parameters": HelicopterParameters, "RigidBody": rigid_body.RigidBodyParameters}
ANNOTATIONS = {"HelicopterParameters": "Parameters", "RigidBodyParameters": "RigidBody"}
PASSED = {"sin": "Math.sin", "cos": "Math.cos", "floor": "Math.floor", "power": "Math.pow"}  # arguments in Python
BUILT_IN = {"abs": "Math.abs"}
OPERATORS = {ast.Add: ("+", 1), ast.Sub: ("-", 1), ast.Mult: ("*", 2), ast.Div: ("/", 2), ast.Pow: ("**", 4)}
NEGATION, ATOM = 3, 5  # precedences


def camel(name: str) -> str:
    """The name as TypeScript spells it; names with a capital or a leading underscore are symbols and stay."""
    return name if name[0].isupper() else re.sub(r"_([a-z])", lambda match: match[1].upper(), name)


class Function:
    """One Python function and its translation."""

    def __init__(self, module: ModuleType, name: str, vectors: dict[str, list[bool]]):
        self.module, self.name, self.vectors = module, name, vectors
        tree = ast.parse(dedent(inspect.getsource(getattr(module, name)))).body[0]
        assert isinstance(tree, ast.FunctionDef)
        self.tree = tree
        self.arguments = [argument for argument in tree.args.args if argument.arg not in PASSED]
        self.constants: dict[str, float] = {}
        vectors[name] = [self.is_vector(argument.arg) for argument in self.arguments]

    def is_vector(self, name: str) -> bool:
        """Whether an argument is a tuple: subscripted, unpacked, or passed on as one."""

        def unpacked(target: ast.expr, value: ast.expr) -> bool:
            if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
                return any(map(unpacked, target.elts, value.elts))
            return isinstance(target, ast.Tuple) and is_name(value)

        def is_name(node: ast.expr) -> bool:
            return isinstance(node, ast.Name) and node.id == name

        for node in ast.walk(self.tree):
            if isinstance(node, ast.Subscript) and is_name(node.value):
                return True
            if isinstance(node, ast.Assign) and unpacked(node.targets[0], node.value):
                return True
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                flags = self.vectors.get(node.func.id, [])
                if any(flag and is_name(argument) for flag, argument in zip(flags, node.args)):
                    return True
        return False

    def text(self) -> str:
        """The function in TypeScript, with the summary of its docstring."""
        summary = (ast.get_docstring(self.tree) or "").partition("\n\n")[0].replace("\n", " ")
        *body, last = [node for node in self.tree.body if not isinstance(node, ast.Expr)]
        assert isinstance(last, ast.Return) and last.value is not None
        lines = [f"  const {', '.join(self.declarations(node))};" for node in body]
        arguments = ", ".join(map(self.argument, self.arguments, self.vectors[self.name]))
        head = f"export function {camel(self.name)}({arguments}): {self.kind(last.value)} {{"
        return "\n".join([f"/** {summary} */", head, *lines, f"  return {self.expression(last.value)};", "}"])

    def argument(self, argument: ast.arg, is_vector: bool) -> str:
        kind = "readonly number[]" if is_vector else "number"
        annotation = argument.annotation.id if isinstance(argument.annotation, ast.Name) else ""
        record = ANNOTATIONS.get(annotation, "Parameters" if argument.arg == "parameters" else "")
        if record:
            used = {node.attr for node in ast.walk(self.tree) if isinstance(node, ast.Attribute)}
            direct = {"k_plus", "k_minus"} == used
            kind = f'Pick<{record}, "k_plus" | "k_minus">' if direct else record
        return f"{camel(argument.arg)}: {kind}"

    def kind(self, value: ast.expr) -> str:
        """The type of a returned value."""
        if isinstance(value, ast.Tuple):
            nested = isinstance(value.elts[0], ast.Tuple)
            return "number[][]" if nested else "[number, number]" if len(value.elts) == 2 else "number[]"
        if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and value.func.id == "solve_2x2":
            return "[number, number]"
        return "number"

    def declarations(self, node: ast.stmt) -> list[str]:
        assert isinstance(node, ast.Assign) and len(node.targets) == 1, ast.dump(node)
        return self.pairs(node.targets[0], node.value)

    def pairs(self, target: ast.expr, value: ast.expr) -> list[str]:
        if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
            return [text for pair in zip(target.elts, value.elts) for text in self.pairs(*pair)]
        return [f"{self.pattern(target)} = {self.expression(value)}"]

    def pattern(self, target: ast.expr) -> str:
        if isinstance(target, ast.Tuple):
            return f"[{', '.join(map(self.pattern, target.elts))}]"
        assert isinstance(target, ast.Name)
        return "" if target.id == "_" else camel(target.id)

    def expression(self, node: ast.expr, outer: int = 0) -> str:
        """An expression, in parentheses where the precedence around it is higher."""
        text, precedence = self.translated(node)
        return f"({text})" if precedence < outer else text

    def translated(self, node: ast.expr) -> tuple[str, int]:
        if isinstance(node, ast.BinOp):
            operator, precedence = OPERATORS[type(node.op)]
            is_power = operator == "**"
            left = self.expression(node.left, ATOM if is_power else precedence)
            right = self.expression(node.right, precedence if is_power else precedence + 1)
            return f"{left} {operator} {right}", precedence
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return f"-{self.expression(node.operand, NEGATION + 1)}", NEGATION
        if isinstance(node, ast.Tuple):
            return f"[{', '.join(map(self.expression, node.elts))}]", ATOM
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            given = [a for a in node.args if not (isinstance(a, ast.Name) and a.id in PASSED)]
            name = PASSED.get(node.func.id) or BUILT_IN.get(node.func.id) or camel(node.func.id)
            assert name.startswith("Math.") or node.func.id in self.vectors, node.func.id
            return f"{name}({', '.join(map(self.expression, given))})", ATOM
        if isinstance(node, ast.Subscript):
            return f"{self.expression(node.value, ATOM)}[{self.expression(node.slice)}]", ATOM
        if ast.unparse(node) == "np.pi":
            return "Math.PI", ATOM
        if isinstance(node, ast.Attribute):
            return f"{self.expression(node.value, ATOM)}.{node.attr}", ATOM
        if isinstance(node, ast.Constant):
            return repr(node.value).removesuffix(".0"), ATOM
        assert isinstance(node, ast.Name), ast.dump(node)
        if node.id.isupper() and hasattr(self.module, node.id):
            self.constants[node.id] = getattr(self.module, node.id)
        return camel(node.id), ATOM


def translation() -> str:
    """The text of src/equations.ts."""
    vectors: dict[str, list[bool]] = {}
    functions = [Function(module, name, vectors) for module, names in FUNCTIONS.items() for name in names]
    texts = [function.text() for function in functions]
    constants = {name: value for function in functions for name, value in function.constants.items()}
    records = [
        f"export interface {name} {{\n" + "".join(f"  {field}: number;\n" for field in record._fields) + "}"
        for name, record in RECORDS.items()
    ]
    head = "// Written by web/translate.py from the Python functions of these names; change those, and run it again."
    values = "\n".join(f"const {name} = {value!r};" for name, value in constants.items())
    return "\n\n".join([head, *records, values, *texts]) + "\n"


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        sys.exit(OUT.read_text() != translation())
    OUT.write_text(translation())
