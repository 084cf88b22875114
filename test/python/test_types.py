# SPDX-License-Identifier: GPL-3.0-or-later
"""Type hints and docstrings: that they are there, and tell of the functions that there are."""

import ast
import dataclasses
import inspect
import pathlib

import pytest

import balanced_flow as bf

PACKAGE = pathlib.Path(bf.__file__).parent
STUB = ast.parse((PACKAGE / "__init__.pyi").read_text())


def test_the_package_is_marked_as_typed():
    assert (PACKAGE / "py.typed").exists()


def test_the_stub_has_the_public_names():
    defined = {node.name for node in STUB.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    assert {name for name in defined if not name.startswith("_")} == set(bf.__all__)


@pytest.mark.parametrize("name", ["smooth", "analyze", "estimate_noise"])
def test_the_stub_has_the_parameters(name):
    parameters = inspect.signature(getattr(bf, name)).parameters.values()
    definitions = [node for node in STUB.body if isinstance(node, ast.FunctionDef) and node.name == name]
    assert definitions
    for definition in definitions:
        arguments = definition.args
        assert not arguments.vararg and not arguments.kwarg
        assert {a.arg for a in arguments.args} >= {
            p.name for p in parameters if p.kind == p.POSITIONAL_OR_KEYWORD}
        assert ({a.arg for a in arguments.args + arguments.kwonlyargs} == {p.name for p in parameters})
        assert all(a.annotation for a in arguments.args + arguments.kwonlyargs) and definition.returns


def test_the_stub_has_the_report():
    report, = [node for node in STUB.body if isinstance(node, ast.ClassDef) and node.name == "Report"]
    fields = {node.target.id: node.annotation.id for node in report.body if isinstance(node, ast.AnnAssign)}
    assert fields == {field.name: field.type for field in dataclasses.fields(bf.Report)}


@pytest.mark.parametrize("name", bf.__all__)
def test_docstrings(name):
    assert len(inspect.getdoc(getattr(bf, name))) > 40


@pytest.mark.parametrize("name", ["smooth", "estimate_noise"])
def test_each_parameter_is_described(name):
    text = inspect.getdoc(getattr(bf, name))
    for parameter in inspect.signature(getattr(bf, name)).parameters:
        assert f"\n{parameter} : " in text, parameter
