# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data that Debian packages hold: downloaded and unpacked, not installed."""
import pathlib
import subprocess


def fetch(package, member, folder):
    """Path of a package's file, unpacked into a folder; None, with a message, if it can't be had."""
    folder = pathlib.Path(folder)
    path = folder / member
    if not path.exists():
        folder.mkdir(parents=True, exist_ok=True)
        try:
            subprocess.run(["apt-get", "-qq", "download", package], cwd=folder, check=True)
            archive, = folder.glob(f"{package}_*.deb")
            subprocess.run(["dpkg-deb", "-x", archive, folder], check=True)
            archive.unlink()
        except (OSError, ValueError, subprocess.CalledProcessError) as error:
            print(f"The Debian package {package} cannot be had: {error}")
    return path if path.exists() else None
