# SPDX-License-Identifier: GPL-3.0-or-later
# A Conan 2 recipe for the tree in which it lies: conan create cmake/packaging/conan
import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import copy, load, rmdir

required_conan_version = ">=2.0"

TREE = os.path.join("..", "..", "..")
CONFIG_DIR = "share/PointSetFlow"


class PointSetFlowConan(ConanFile):
    name = "point-set-flow"
    description = "Smoothing of 3D point sets by dynamic balanced flow, in the style of CGAL"
    license = "GPL-3.0-or-later"
    topics = ("cgal", "geometry", "point-cloud", "smoothing", "denoising")
    settings = "os", "compiler", "build_type", "arch"
    options = {"with_tbb": [True, False], "with_program": [True, False]}
    default_options = {"with_tbb": True, "with_program": False}
    generators = "CMakeDeps"

    def set_version(self):
        text = load(self, os.path.join(self.recipe_folder, TREE, "CMakeLists.txt"))
        self.version = re.search(r"project\(PointSetFlow VERSION ([0-9.]+)", text).group(1)

    def export_sources(self):
        tree = os.path.join(self.recipe_folder, TREE)
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "examples/*"):
            copy(self, pattern, src=tree, dst=self.export_sources_folder)

    def layout(self):
        self.folders.root = TREE
        self.folders.source = "."
        self.folders.build = os.path.join("build", "conan")
        self.folders.generators = os.path.join("build", "conan", "generators")

    def requirements(self):
        # CGAL's recipe brings Eigen, Boost, MPFR and GMP, in the versions that it is made for
        self.requires("cgal/[>=5.5]", transitive_headers=True)
        if self.options.with_tbb:
            self.requires("onetbb/[>=2021.3]", transitive_headers=True, transitive_libs=True)
        if self.options.with_program:
            self.requires("nlohmann_json/[>=3.9]", visible=False)

    def validate(self):
        check_min_cppstd(self, 17)

    def package_id(self):
        if not self.info.options.with_program:
            self.info.clear()  # headers only

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.user_presets_path = False  # leaves the tree as it is
        toolchain.cache_variables["POINT_SET_FLOW_BUILD_TESTS"] = False
        toolchain.cache_variables["POINT_SET_FLOW_BUILD_EXAMPLES"] = False
        toolchain.cache_variables["POINT_SET_FLOW_BUILD_PROGRAM"] = bool(self.options.with_program)
        toolchain.cache_variables["POINT_SET_FLOW_WITH_LASZIP"] = False  # not in ConanCenter
        toolchain.cache_variables["POINT_SET_FLOW_WITH_LZF"] = False  # must not slip in
        toolchain.cache_variables["POINT_SET_FLOW_WITH_TBB"] = bool(self.options.with_tbb)
        toolchain.cache_variables["POINT_SET_FLOW_CONFIG_DIR"] = CONFIG_DIR
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        rmdir(self, os.path.join(self.package_folder, "share", "pkgconfig"))  # PkgConfigDeps writes one

    def package_info(self):
        # CMake finds the package by its own configuration file, which knows the components
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [CONFIG_DIR]
        self.cpp_info.set_property("pkg_config_name", "point-set-flow")
        self.cpp_info.defines = ["CGAL_EIGEN3_ENABLED"]
        if self.options.with_tbb:
            self.cpp_info.defines += ["CGAL_LINKED_WITH_TBB", "NOMINMAX"]
        self.cpp_info.libdirs = []
        if not self.options.with_program:
            self.cpp_info.bindirs = []
