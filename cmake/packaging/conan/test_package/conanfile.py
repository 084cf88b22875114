# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and runs test/packaging/consumer with the package.
import os

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout


class PointSetFlowTestConan(ConanFile):
    settings = "os", "compiler", "build_type", "arch"
    generators = "CMakeDeps", "VirtualRunEnv"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        options = self.dependencies["point-set-flow"].options
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["WITH_TBB"] = str(options.with_tbb).upper()
        toolchain.cache_variables["WITH_PROGRAM"] = str(options.with_program).upper()
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure(build_script_folder=os.path.join("..", "..", "..", "..", "test", "packaging", "consumer"))
        cmake.build()

    def test(self):
        if can_run(self):
            self.run(os.path.join(self.cpp.build.bindir, "consumer"), env="conanrun")
