"""Builds the wheel: cairn.py as a package with the shared library beside it. A build backend as in PEP 517, without dependencies.

The library is compiled from one file: the cairn.c beside this file, as in the sdist, or what bindings/amalgamate.py makes of src/.
"""
import base64
import hashlib
import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))
LIBRARY = {"darwin": "libcairn.dylib", "win32": "cairn.dll"}.get(sys.platform, "libcairn.so")


def sources(folder):
    """The folder with cairn.c and cairn.h."""
    if os.path.exists(os.path.join(HERE, "cairn.c")):
        return HERE
    subprocess.run([sys.executable, os.path.join("bindings", "amalgamate.py"), os.path.abspath(folder)], cwd=TOP, check=True)
    return folder


def version(folder):
    with open(os.path.join(folder, "cairn.h"), encoding="utf-8") as file:
        return ".".join(re.findall(r"define CN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", file.read()))


def compile_library(folder, output):
    compiler, flags = shlex.split(os.environ.get("CC", "cc")), shlex.split(os.environ.get("CFLAGS", "-O3"))
    subprocess.run([*compiler, "-std=c99", *flags, "-DCN_SHARED", "-fPIC", "-shared", os.path.join(folder, "cairn.c"), "-o", output, "-lm", *([] if sys.platform == "win32" else ["-lpthread"])], check=True)


def metadata(number):
    return "Metadata-Version: 2.1\nName: cairn-physics\nVersion: %s\nSummary: Cairn, 2D rigid-body physics: same input, same bits\nRequires-Python: >=3.8\n" % number


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        source, library = sources(folder), os.path.join(folder, LIBRARY)
        compile_library(source, library)
        number, tag = version(source), "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())
        name, info = "cairn_physics-%s-%s.whl" % (number, tag), "cairn_physics-%s.dist-info/" % number
        records = []
        with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:

            def add(path, content):
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                records.append("%s,sha256=%s,%d" % (path, digest, len(content)))
                wheel.writestr(path, content)

            for path, file in (("cairn/__init__.py", os.path.join(HERE, "cairn.py")), ("cairn/" + LIBRARY, library)):
                with open(file, "rb") as content:
                    add(path, content.read())
            add(info + "METADATA", metadata(number).encode())
            add(info + "WHEEL", ("Wheel-Version: 1.0\nGenerator: cairn\nRoot-Is-Purelib: false\nTag: %s\n" % tag).encode())
            wheel.writestr(info + "RECORD", "\n".join([*records, info + "RECORD,,"]) + "\n")
        return name


def build_sdist(sdist_directory, config_settings=None):
    with tempfile.TemporaryDirectory() as folder:
        source = sources(folder)
        number = version(source)
        base = "cairn_physics-%s" % number
        with open(os.path.join(folder, "PKG-INFO"), "w", encoding="utf-8") as file:
            file.write(metadata(number))
        with tarfile.open(os.path.join(sdist_directory, base + ".tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
            for file in ("cairn.py", "backend.py", "pyproject.toml"):
                archive.add(os.path.join(HERE, file), base + "/" + file)
            for file in (os.path.join(source, "cairn.c"), os.path.join(source, "cairn.h"), os.path.join(folder, "PKG-INFO")):
                archive.add(file, base + "/" + os.path.basename(file))
        return base + ".tar.gz"
