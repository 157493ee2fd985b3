"""The stubs say what the module has, and no more."""

import ast
import inspect
import pathlib
import re
import types

import refraster

STUBS = pathlib.Path(refraster.__file__).parent / "refraster-stubs"


def stub_names(body):
    """Names in a module or class of a stub: functions with their parameters, attributes with None."""
    names = {}
    for node in body:
        if isinstance(node, ast.FunctionDef):
            names[node.name] = [each.arg for each in node.args.args + node.args.kwonlyargs if each.arg != "self"]
        elif isinstance(node, ast.AnnAssign):
            names[node.target.id] = None
        elif isinstance(node, ast.ClassDef):
            names[node.name] = stub_names(node.body)
    return names


def stub(name):
    return stub_names(ast.parse((STUBS / name).read_text()).body)


def parameters(function):
    """Those of a function of the module, which its docstring begins with."""
    signature = re.match(r"\w+\((.*)\) -> ", function.__doc__)
    names = [part.split(":")[0].split("=")[0].strip() for part in re.split(r", (?![^\[\(]*[\]\)])", signature[1])]
    return [name for name in names if name and name not in ("*", "self") and not name.startswith("**")]


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


def test_every_name_of_the_module_is_in_the_stub_and_the_other_way_round():
    of_stub = stub("__init__.pyi")
    assert public(refraster) == {name for name in of_stub if not name.startswith("_")} | {"brdf"}
    assert public(refraster.brdf) == {name for name in stub("brdf.pyi") if not name.startswith("_")}


def test_every_class_has_the_attributes_of_its_stub():
    for name, members in stub("__init__.pyi").items():
        thing = getattr(refraster, name, None)
        if not isinstance(thing, type) or issubclass(thing, Exception):
            continue
        assert public(thing) == {member for member in members if not member.startswith("_")}, name
        # Keywords of the constructor: attributes that can be set.
        settable = {key for key, value in vars(thing).items() if isinstance(value, property) and value.fset is not None}
        if settable and name not in ("Mesh", "Frame"):
            assert settable <= set(members["__init__"]), name


def test_every_function_has_the_parameters_of_its_stub():
    for module, names in [(refraster, stub("__init__.pyi")), (refraster.brdf, stub("brdf.pyi"))]:
        for name, members in names.items():
            thing = getattr(module, name, None)
            if isinstance(thing, types.BuiltinFunctionType) and "**kwargs" not in thing.__doc__:
                assert parameters(thing) == members, name
    members = stub("__init__.pyi")
    for name, method in [("Scene", "render"), ("Scene", "place"), ("Frame", "save"), ("Mesh", "allocate")]:
        assert parameters(getattr(getattr(refraster, name), method)) == members[name][method], method


def test_everything_has_a_docstring():
    for name in public(refraster) - {"fragment_functions"}:
        thing = getattr(refraster, name)
        assert inspect.getdoc(thing), name
        if isinstance(thing, type):
            for member in public(thing):
                assert inspect.getdoc(getattr(thing, member)), f"{name}.{member}"
