"""Read by catkin_python_setup()."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(
    **generate_distutils_setup(
        packages=[
            "f1tenth_studies",
            "f1tenth_studies.faults",
            "f1tenth_studies.optimum",
            "f1tenth_studies.studies",
        ],
        package_dir={"": "src"},
    )
)
