#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes learned_weights.h from the files of train.py:

    write_weights.py --gate FILE --sheets FILES... --correction FILES... > learned_weights.h
"""
import argparse


HIDDEN, GATES, HEAD = 16, 4, 20  # of Network in train.py
ROWS = [HIDDEN] * 5 + [GATES] * 2 + [HEAD] * 3


def read_columns(file):
    """All weights in the order of Network: of layers column by column, as Learned_network.h multiplies"""
    numbers = []
    for i, line in enumerate(open(file)):
        x = [f"{float(x):.4g}" for x in line.split()]
        rows = ROWS[i] if i < len(ROWS) else 1  # what comes after the layers stays as it is
        columns = len(x) // rows
        numbers += [x[r * columns + c] for c in range(columns) for r in range(rows)]
    return numbers


def array(name, files):
    rounds = [read_columns(f) for f in files]
    count = len(rounds[0]) if rounds else 1
    print(f"inline constexpr unsigned int number_of_{name}_rounds = {len(rounds)};")
    print(f"inline constexpr float {name}_weights[{max(1, len(rounds))}][{count}] = {{")
    for numbers in rounds:
        line = "  {"
        for x in numbers:
            x += ("" if "." in x or "e" in x else ".") + "f,"
            if len(line) + len(x) > 230:
                print(line)
                line = "   "
            line += x
        print(line + "},")
    print("};")


def gate(file):
    numbers = [float(x) for x in open(file).read().split()]
    print(f"inline constexpr float sheet_gate_weights[{len(numbers)}] = {{" + ", ".join(f"{x:#.5g}f" for x in numbers) + "};")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--gate", required=True)
    parser.add_argument("--sheets", nargs="*", default=[])
    parser.add_argument("--correction", nargs="*", default=[])
    options = parser.parse_args()
    guard = "CGAL_POINT_SET_FLOW_INTERNAL_FITTING_LEARNED_WEIGHTS_H"
    print("// SPDX-License-Identifier: GPL-3.0-or-later")
    print("// Generated: see test/benchmark/learned/README.md.")
    print(f"#ifndef {guard}\n#define {guard}\n")
    print("#include <CGAL/license/Point_set_flow.h>\n")
    print("// clang-format off\nnamespace CGAL {\nnamespace Point_set_flow {\nnamespace internal {\n")
    print("/// The weights of each round of `Learned_network`")
    gate(options.gate)
    array("sheet", options.sheets)
    array("correction", options.correction)
    print("\n} // namespace internal\n} // namespace Point_set_flow\n} // namespace CGAL\n// clang-format on")
    print(f"\n#endif // {guard}")


if __name__ == "__main__":
    main()
