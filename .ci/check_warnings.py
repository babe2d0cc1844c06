#!/usr/bin/env python3
"""Reads the sources of a compile_commands.json again, without writing anything, and fails if there is a warning.
Sources that the build makes, and those whose path matches the second argument, a regular expression, are left out."""

import concurrent.futures
import json
import os
import re
import subprocess
import sys


def compile_only(entry):
    command = re.sub(r" -o \S+", "", entry["command"]) + " -fsyntax-only -Werror"
    return subprocess.run(command, shell=True, cwd=entry["directory"], capture_output=True, text=True)


with open(sys.argv[1], encoding="utf-8") as file:
    entries = [entry for entry in json.load(file)
               if os.path.exists(entry["file"]) and not re.search(sys.argv[2], entry["file"])]
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    failures = [result.stderr for result in pool.map(compile_only, entries) if result.returncode]
print("\n".join(failures) or f"no warning in {len(entries)} sources")
sys.exit(bool(failures))
