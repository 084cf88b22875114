# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the tables of a run into a page, between the lines that name them: insert_tables.py DATA_FOLDER PAGE"""
import os
import re
import sys

data_folder, page = sys.argv[1:]


def table(match):
    with open(os.path.join(data_folder, match[2] + ".md"), encoding="utf-8") as file:
        return match[1] + "\n\n" + file.read() + "\n" + match[3]


with open(page, encoding="utf-8") as file:
    text = file.read()
text = re.sub(r"(<!-- table (\w+) -->)\n.*?(<!-- end -->)", table, text, flags=re.DOTALL)
with open(page, "w", encoding="utf-8") as file:
    file.write(text)
