"""What keeps libraries from choosing their code by the processor: glibc, numpy, OpenBLAS and MKL."""

import platform
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from f1tenth_judge.scenario.scenario import Scenario

# What glibc's mathematics is chosen by, and every processor of 64 bits lacks or has.
_GLIBC = "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX512VL,-AVX512BW,-AVX512DQ"
_BLAS = {"x86_64": "NEHALEM", "aarch64": "ARMV8"}
_FEATURES = {"sse4_2", "avx", "avx2", "fma", "fma4", "avx512f", "avx512bw", "asimd", "sve", "sve2"}


def variables_of(scenario: Scenario, environment: Mapping[str, str]) -> dict[str, str]:
    """Environment variables for every process of a run; none if nothing is pinned.

    Args:
        environment: of this process; tunables that the user has set stay
    """
    if not is_pinned(scenario):
        return {}
    variables = {"OPENBLAS_CORETYPE": _BLAS[platform.machine()]}
    if platform.machine() == "x86_64":
        own = environment.get("GLIBC_TUNABLES")
        variables["GLIBC_TUNABLES"] = ":".join(filter(None, [own, _GLIBC]))
        variables["NPY_DISABLE_CPU_FEATURES"] = " ".join(_numpy_features())
        variables["MKL_CBWR"] = "COMPATIBLE"
    return variables


def is_pinned(scenario: Scenario) -> bool:
    """Whether libraries are kept from choosing; without lockstep no two runs are alike anyway."""
    return scenario.lockstep and scenario.pinned and platform.machine() in _BLAS


def machine(scenario: Scenario) -> dict[str, Any]:
    """What a run was computed by, for its result."""
    return {
        "architecture": platform.machine(),
        "libc": " ".join(platform.libc_ver()),
        "features": sorted(_FEATURES & _flags()),
        "pinned": is_pinned(scenario),
    }


def _flags() -> set[str]:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="ascii", errors="replace").splitlines()
    except OSError:
        return set()
    return {word for line in lines if line.startswith(("flags", "Features")) for word in line.split()}


def _numpy_features() -> list[str]:
    """Those that the processor has and numpy has code for; it warns of others."""
    import numpy as np

    core = getattr(np, "_core", None) or np.core
    umath = core._multiarray_umath
    found = umath.__cpu_features__
    return [name for name in umath.__cpu_dispatch__ if found.get(name) and name.startswith(("AVX", "F"))]
