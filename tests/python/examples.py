"""Runs the examples of docs/python.md, one after another in one interpreter, in an empty folder."""

import os
import pathlib
import re
import tempfile

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"

blocks = list(re.finditer(r"^```python\n(.*?)^```$", PAGE.read_text(), re.M | re.S))
assert len(blocks) >= 7, "the page has lost its examples"
names = {}
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for block in blocks:
        line = PAGE.read_text()[: block.start(1)].count("\n")
        exec(compile("\n" * line + block.group(1), PAGE, "exec"), names)
    os.chdir("/")
