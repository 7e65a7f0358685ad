# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Programs that several processes of pvbatch run together."""
import os
import pathlib
import subprocess


def start(script, count, *arguments):
    """What that many processes print."""
    environment = dict(
        os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1"
    )
    command = ["mpirun", "--oversubscribe", "-np", str(count), os.environ["BRAVAIS_PVBATCH"],
               "--symmetric", script, *arguments]
    return subprocess.run(
        command, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout


def run(script, count):
    """The folder of what that many processes write."""
    script = pathlib.Path(__file__).with_name(script)
    folder = pathlib.Path(os.environ["BRAVAIS_TEMPORARY"], script.stem, str(count))
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        path.unlink()
    print(start(script, count, folder))
    return folder
