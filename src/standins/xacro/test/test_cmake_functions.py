"""The CMake functions must generate files when the build runs and install them where asked."""

import subprocess

import pytest

CMAKE_LISTS = """cmake_minimum_required(VERSION 3.16)
project(some_description LANGUAGES CXX)
find_package(catkin REQUIRED COMPONENTS xacro)
catkin_package()
xacro_add_files(urdf/car.urdf.xacro REMAP colour:=red TARGET car_urdf INSTALL DESTINATION urdf)
"""
PACKAGE_XML = """<package format="3"><name>some_description</name><version>0.1.0</version>
<description>d</description><maintainer email="a@b.invalid">a</maintainer><license>BSD</license>
<buildtool_depend>catkin</buildtool_depend><build_depend>xacro</build_depend></package>
"""
CAR = """<robot name="car" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="wheel.xacro"/><xacro:arg name="colour" default="blue"/>
  <link name="$(arg colour)_${wheel}"/>
</robot>
"""
WHEEL = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="wheel" value="WHEEL"/>
</robot>
"""


def run(*command):
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.fixture
def package(tmp_path):
    source = tmp_path / "some_description"
    (source / "urdf").mkdir(parents=True)
    (source / "CMakeLists.txt").write_text(CMAKE_LISTS)
    (source / "package.xml").write_text(PACKAGE_XML)
    (source / "urdf/car.urdf.xacro").write_text(CAR)
    (source / "urdf/wheel.xacro").write_text(WHEEL.replace("WHEEL", "round"))
    run(
        *("cmake", "-S", source, "-B", tmp_path / "build", f"-DCMAKE_INSTALL_PREFIX={tmp_path}/install"),
        "-DCATKIN_ENABLE_TESTING=OFF",
    )
    return source


def test_files_are_generated_and_installed(package, tmp_path):
    run("cmake", "--build", tmp_path / "build", "--target", "install")
    installed = tmp_path / "install/share/some_description/urdf/car.urdf"
    assert '<link name="red_round"/>' in installed.read_text()


def test_a_changed_include_is_seen_by_the_next_build(package, tmp_path):
    run("cmake", "--build", tmp_path / "build")
    (package / "urdf/wheel.xacro").write_text(WHEEL.replace("WHEEL", "square"))
    run("cmake", "--build", tmp_path / "build")
    assert "red_square" in (tmp_path / "build/urdf/car.urdf").read_text()
