#!/usr/bin/env python3
"""Checks that every file includes only what its room may.

The rooms and what each may include are read from src/CMakeLists.txt, where they are stated once:
`tlsph_room(name ROOMS …)`. A room that may include `simulation`, which knows every room, may include
all that `simulation` may; so may the programs. Third parties have one door each, listed below.

    rooms.py [SOURCE_DIR]     prints a line for each violation; exit code 1 if there is any
    rooms.py --lines          prints the lines of each room

A room of the library includes no room marked STUDY.

A file longer than 300 lines earns a warning, a header without `#pragma once` is a violation.
"""

import pathlib
import re
import sys

# Third party: what its headers start with, and the rooms that may include them (None: all), never in
# a public header unless all may.
DOORS = {
    "Eigen": (r"Eigen/", None),
    "fmt": (r"fmt/", None),
    "OpenMP": (r"omp\.h$", None),
    "vector instructions": (r"immintrin\.h$", {"sweep"}),
    "POSIX": (r"(unistd|fcntl|spawn)\.h$|sys/", None),
    "toml++": (r"toml", {"scene"}),
    "CLI11": (r"CLI/", {"programs"}),
    "HDF5": (r"hdf5|H5", {"io"}),
    "nanoflann": (r"nanoflann", {"operators"}),
    "Boost": (r"boost/", {"particles"}),
    "SuiteSparse": (r"suitesparse/|cholmod|umfpack|SuiteSparse|spqr|amd\.h|colamd\.h", {"linear"}),
    "Armadillo": (r"armadillo", {"analysis"}),
    "nlohmann-json": (r"nlohmann/", {"io", "studies"}),
}
STANDARD = re.compile(r"[a-z_0-9]+$")  # <vector>, <cmath>: neither folder nor suffix
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
LONGEST = 300


def allowed_rooms(cmake_text):
    """{room: set of rooms it may include}, from the tlsph_room(...) calls; itself is one of them."""
    text = re.sub(r"#.*", "", cmake_text)
    table = {}
    for call in re.findall(r"\btlsph_room\(([^)]*)\)", text):
        name, *words = call.split()
        listed, reading = set(), False
        for word in words:
            if word in ("ROOMS", "LINK", "PRIVATE_LINK"):
                reading = word == "ROOMS"
            elif reading:
                listed.add(word)
        unknown = listed - set(table)
        if unknown:
            raise SystemExit(f"src/CMakeLists.txt: {name} names rooms not declared before it: {unknown}")
        if "simulation" in listed:
            listed |= table["simulation"]
        for inherited in [room for room in listed if "simulation" in table[room]]:
            listed |= table[inherited]
        table[name] = listed | {name}
    table["programs"] = set(table) | {"programs"}
    return table


def studies(cmake_text):
    """The rooms marked STUDY, which the library is without."""
    return set(re.findall(r"\btlsph_room\((\w+)\s+STUDY\b", cmake_text))


def count_lines(root):
    """{room: lines of its headers and sources}."""
    lines = {}
    for top in ("include/tlsph", "src"):
        for path in (root / top).rglob("*.[ch]pp"):
            room = path.relative_to(root / top).parts[0]
            lines[room] = lines.get(room, 0) + len(path.read_text().splitlines())
    return lines


def check_include(quote, target, room, public, folder, table):
    """The complaint about one include line, or None."""
    if target.startswith("tlsph/"):
        other = target.split("/")[1]
        if other not in table:
            return f"includes {target}, and there is no room {other}"
        if other not in table[room]:
            return f"room {room} may not include {other} ({target})"
        return None
    if quote == '"':
        if "/" in target or not (folder / target).is_file():
            return f'includes "{target}", which is neither tlsph/<room>/… nor a file beside it'
        return None
    for party, (pattern, doors) in DOORS.items():
        if re.match(pattern, target):
            if doors is not None and room not in doors:
                return f"includes {party} (<{target}>), whose door is {', '.join(sorted(doors))}"
            if doors is not None and public:
                return f"shows {party} (<{target}>) in a public header"
            return None
    if STANDARD.match(target):
        return None
    return f"includes <{target}>, which is on no list of tests/architecture/rooms.py"


def check(root):
    """(violations, warnings), each a list of printable lines."""
    cmake_text = (root / "src/CMakeLists.txt").read_text()
    table, outside = allowed_rooms(cmake_text), studies(cmake_text)
    violations, warnings = [], []
    for room in set(table) - outside - {"programs"}:
        for study in table[room] & outside:
            violations.append(f"src/CMakeLists.txt: {room}, of the library, may include the study {study}")
    for top in ("include/tlsph", "src"):
        for path in sorted((root / top).rglob("*.[ch]pp")):
            place, room = path.relative_to(root), path.relative_to(root / top).parts[0]
            lines = path.read_text().splitlines()
            if room not in table:
                violations.append(f"{place}: there is no room {room} in src/CMakeLists.txt")
                continue
            for number, line in enumerate(lines, 1):
                match = INCLUDE.match(line)
                if match:
                    complaint = check_include(*match.groups(), room, top != "src", path.parent, table)
                    if complaint:
                        violations.append(f"{place}:{number}: {complaint}")
            if path.suffix == ".hpp" and "#pragma once" not in lines:
                violations.append(f"{place}: has no #pragma once")
            if len(lines) > LONGEST:
                warnings.append(f"{place}: {len(lines)} lines; split it by idea below {LONGEST}")
    return violations, warnings


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--lines"]
    root = pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).parents[2])
    if "--lines" in sys.argv:
        outside = studies((root / "src/CMakeLists.txt").read_text())
        lines = count_lines(root)
        for room, count in sorted(lines.items(), key=lambda entry: -entry[1]):
            print(f"{room:12} {count:6}{'  study' if room in outside else ''}")
        print(f"{'all':12} {sum(lines.values()):6}")
        return 0
    violations, warnings = check(root)
    for line in warnings:
        print(f"warning: {line}")
    for line in violations:
        print(line)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
