"""Libraries that are no ROS packages of the workspace: which a page can have, and which none can.

CMake finds all of them where a package requires them. Those that no page can have are empty, so
that a program that needs one does not stop the others of its package.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sitegen.shipped import CLIENTS

# Headers that sitegen adds to those of the compiler.
SYSTEM = CLIENTS / "cpp" / "system"


@dataclass(frozen=True)
class Library:
    """A library, as its CMake packages describe it on a robot.

    `headers` is a regular expression for the first part of the paths of its headers. `packages` are
    the names that find_package() knows, each with its targets; `{}` in a target stands for each
    component. `version` answers packages that compare it. `install` says how to get its headers, if
    these are all that a program needs. `marks` are files, relative to the folder of headers, of
    which one tells the version that is installed. `definitions` and `options` of the compiler are
    those of its targets.
    """

    name: str
    headers: str
    packages: Mapping[str, str]
    version: str = "1.0.0"
    install: str = ""
    marks: tuple[str, ...] = ()
    definitions: tuple[str, ...] = ()
    options: tuple[str, ...] = ()


def _each(names: str, target: str = "{0}::{0}") -> dict[str, str]:
    """Return the packages of `names`, each with one target."""
    return {name: target.format(name) for name in names.split()}


def _ros(name: str) -> Library:
    return Library(name, re.escape(name), _each(name))


_OPENCV = (
    "calib3d core dnn features2d flann highgui imgcodecs imgproc ml objdetect photo stitching "
    "video videoio"
)
_QT = (
    "Charts Concurrent Core Gui LinguistTools Multimedia Network OpenGL OpenGLWidgets PrintSupport "
    "Qml Quick QuickWidgets SerialPort Sql Svg SvgWidgets Test UiTools WebSockets Widgets Xml"
)
# The libraries of Gazebo, each a package, a vendor package and one with a version in its name.
_GZ = "cmake common fuel_tools gui launch math msgs physics plugin rendering sensors sim transport"
_GZ_VERSIONS = (
    "common5 common6 math7 math8 msgs9 msgs10 msgs11 plugin2 plugin3 sensors8 sensors9 sim7 sim8 "
    "sim9 transport12 transport13 transport14"
)
_BOOST = (
    "asio atomic chrono container context contract coroutine date_time exception fiber filesystem "
    "graph headers iostreams json locale log log_setup math nowide program_options random regex "
    "serialization stacktrace_basic system test thread timer type_erasure unit_test_framework "
    "url wave wserialization"
)

_OF_ROS = (
    "backward_ros cv_bridge image_geometry gazebo_dev gazebo_ros pcl_conversions pcl_ros "
    "qt_gui_cpp rmw_fastrtps_cpp rosbag2_compression rosbag2_cpp rosbag2_storage "
    "rosbag2_storage_mcap rosbag2_transport rqt_gui_cpp rttest rviz_common rviz_default_plugins "
    "rviz_rendering rviz_visual_tools tlsf_cpp"
)

# These are too large, or need hardware, a screen, a middleware or an interpreter.
UNAVAILABLE = (
    Library(
        "OpenCV",
        "opencv[24]?",
        {"OpenCV": " ".join(f"opencv_{o}" for o in _OPENCV.split())},
        "4.6.0",
    ),
    Library("PCL", "pcl", {"PCL": "pcl_{}"}, "1.13.0"),
    *(
        Library(
            name,
            headers,
            {name: f"{name}::{{}}", **{f"{name}{part}": f"{name}::{part}" for part in _QT.split()}},
            version,
        )
        # The headers of both have the same names.
        for name, version, headers in (
            ("Qt5", "5.15.8", r"Q[A-Z]\w*|ui_\w+\.h"),
            ("Qt6", "6.4.2", ""),
        )
    ),
    *map(_ros, _OF_ROS.split()),
    Library("Ogre", r"Ogre.*", _each("rviz_ogre_vendor", "rviz_ogre_vendor::OgreMain")),
    Library(
        "Gazebo",
        "gazebo(_plugins)?|gz|ignition|ros_gz_(bridge|image|sim)|sdf",
        {
            **_each("gazebo gazebo_plugins ignition-gazebo6 ros_gz_bridge ros_gz_image ros_gz_sim"),
            **_each(" ".join(f"gz-{name}" for name in f"{_GZ} {_GZ_VERSIONS}".split())),
            **_each(" ".join(f"gz_{name}_vendor" for name in _GZ.split()), ""),
            **_each("sdformat_vendor", ""),
        },
    ),
    # A page has no devices.
    Library("Linux drivers", r"bluetooth|gpiod\.hp{0,2}|i2c|libudev\.h|linux|pigpiod?_?\w*\.h", {}),
    Library("Ceres", "ceres", {"Ceres": "ceres Ceres::ceres"}, "2.1.0"),
    Library(
        "SuiteSparse",
        r"suitesparse|SuiteSparse\w*\.h|(cholmod|umfpack)\w*\.h",
        _each("SuiteSparse CHOLMOD CSparse CXSparse UMFPACK SPQR", ""),
        "5.12.0",
    ),
    Library("LAPACK", r"lapacke?\.h", {"LAPACK": "LAPACK::LAPACK", "BLAS": "BLAS::BLAS"}),
    Library("g2o", "g2o", {"g2o": "g2o::core", "G2O": ""}),
    Library("GTSAM", "gtsam", {"GTSAM": "gtsam"}, "4.2.0"),
    Library("glog", "glog", _each("glog Glog GLOG", "glog::glog"), "0.6.0"),
    Library("gflags", "gflags", _each("gflags GFlags", "gflags")),
    Library("ImageMagick", r"ImageMagick.*|MagickCore|MagickWand", {"ImageMagick": ""}),
    Library(
        "ZeroMQ",
        r"zmq.*",
        {
            "ZeroMQ": "libzmq libzmq-static",
            "libzmq": "libzmq",
            "cppzmq": "cppzmq cppzmq-static",
            "libzmq_vendor": "",
            "ZMQ": "",
        },
        "4.3.4",
    ),
    Library("SQLite", r"sqlite3.*", {"SQLite3": "SQLite::SQLite3", "sqlite3_vendor": ""}, "3.40.1"),
    Library(
        "Python's C API",
        r"Python\.h|pybind11|numpy|boost_python",
        {
            **{
                name: f"{name}::Python {name}::Module {name}::NumPy {name}::Interpreter"
                for name in ("Python", "Python3")
            },
            **_each("PythonExtra PythonInterp PythonLibs pybind11_vendor python_cmake_module", ""),
            "pybind11": "pybind11::pybind11 pybind11::module pybind11::embed pybind11::headers",
        },
        "3.12.0",
    ),
    Library("OpenSSL", "openssl", {"OpenSSL": "OpenSSL::SSL OpenSSL::Crypto"}, "3.0.0"),
    Library("libcurl", "curl", {"CURL": "CURL::libcurl", "libcurl_vendor": ""}, "7.88.1"),
    # Programs include its header only where the compiler supports it.
    Library("OpenMP", "", {"OpenMP": "OpenMP::OpenMP_C OpenMP::OpenMP_CXX"}, "4.5"),
    Library("TBB", "tbb|oneapi", {"TBB": "TBB::tbb TBB::tbbmalloc"}, "2021.8.0"),
    Library("OpenGL", "GL|GLES[23]?|EGL", {"OpenGL": "OpenGL::GL OpenGL::OpenGL OpenGL::GLU"}),
    Library("GLUT", "", {"GLUT": "GLUT::GLUT"}),
    Library("GLEW", "", {"GLEW": "GLEW::GLEW"}),
    Library("GLFW", "GLFW", {"glfw3": "glfw"}, "3.3.8"),
    Library("SDL", "SDL2?", {"SDL2": "SDL2::SDL2", "SDL": "SDL::SDL"}, "2.26.5"),
    Library("X11", "X11", {"X11": "X11::X11 X11::Xext"}),
    Library("VTK", r"vtk\w+\.h", {"VTK": "VTK::{}"}, "9.1.0"),
    Library("librealsense", "librealsense2", {"realsense2": "realsense2::realsense2"}, "2.54.0"),
    Library("libusb", r"libusb.*", _each("libusb LIBUSB", "")),
)

# Its own CMake package, `Eigen3`, adds the folder of its headers, which are in `eigen3/`.
EIGEN = Library(
    "Eigen",
    "Eigen|eigen3|unsupported",
    {},
    install="pip install 'ros-sitegen[eigen]', or apt-get install libeigen3-dev",
)

# Programs need only the headers of these, which are taken from the computer of the author.
HEADER_ONLY = (
    EIGEN,
    Library(
        "Boost",
        "boost",
        {"Boost": "Boost::boost " + " ".join(f"Boost::{part}" for part in _BOOST.split())},
        "1.74.0",
        "apt-get install libboost-dev",
        ("boost/version.hpp",),
        # Its own list of what other platforms lack knows nothing of this one.
        ("BOOST_ERROR_CODE_HEADER_ONLY",),
    ),
    Library(
        "fmt",
        "fmt",
        {"fmt": "fmt::fmt fmt::fmt-header-only"},
        "9.1.0",
        "apt-get install libfmt-dev",
        ("fmt/core.h", "fmt/base.h"),
        ("FMT_HEADER_ONLY=1",),
    ),
    Library(
        "spdlog",
        "spdlog",
        {"spdlog": "spdlog::spdlog spdlog::spdlog_header_only", "spdlog_vendor": ""},
        "1.10.0",
        "apt-get install libspdlog-dev",
        ("spdlog/version.h",),
        ("FMT_HEADER_ONLY=1",),
    ),
    Library(
        "nlohmann_json",
        "nlohmann",
        {
            "nlohmann_json": "nlohmann_json::nlohmann_json",
            "nlohmann_json_schema_validator_vendor": "",
        },
        "3.11.2",
        "apt-get install nlohmann-json3-dev",
        ("nlohmann/json.hpp",),
    ),
    Library(
        "tl-expected",
        "tl",
        _each("tl-expected", "tl::expected"),
        "1.0.0",
        "apt-get install libexpected-dev",
        ("tl/expected.hpp",),
    ),
    Library(
        "nanoflann",
        r"nanoflann\.hpp",
        _each("nanoflann", "nanoflann::nanoflann"),
        "1.4.3",
        "apt-get install libnanoflann-dev",
        ("nanoflann.hpp",),
    ),
    Library(
        "xtl",
        "xtl",
        _each("xtl", "xtl xtl::xtl"),
        "0.7.2",
        "apt-get install xtl-dev",
        ("xtl/xtl_config.hpp",),
    ),
    Library(
        "xtensor",
        "xtensor",
        _each("xtensor", "xtensor xtensor::xtensor xtensor::optimize xtensor::use_xsimd"),
        "0.24.3",
        "apt-get install libxtensor-dev",
        ("xtensor/xtensor_config.hpp", "xtensor/core/xtensor_config.hpp"),
        # Before version 9.1, xsimd has no instructions of WebAssembly; the compiler knows them.
        options=("-UXTENSOR_USE_XSIMD", "-mvectors"),
    ),
    Library(
        "xsimd",
        "xsimd",
        _each("xsimd", "xsimd xsimd::xsimd"),
        "8.1.0",
        "apt-get install libxsimd-dev",
        ("xsimd/config/xsimd_config.hpp",),
    ),
    Library(
        "magic_enum",
        r"magic_enum.*",
        {"magic_enum": "magic_enum::magic_enum"},
        "0.8.2",
        "put its headers into /usr/local/include",
        ("magic_enum.hpp", "magic_enum/magic_enum.hpp"),
    ),
)


@dataclass(frozen=True)
class Compiled:
    """A library that is compiled for the page, from its source of Debian or Ubuntu.

    `package` is the package that comes with sitegen and compiles it; a package of the workspace
    with this name takes precedence. `source` is Debian's name of the source, `parts` are the
    folders and files in it that are needed; names of files can be patterns. `headers` is a regular
    expression for the first part of the paths of its headers. `names` are other ones, by which
    find_package(), pkg-config or rosdep know it. `licence` is a part with its licence that is not
    named so.
    """

    package: str
    source: str
    parts: tuple[str, ...]
    headers: str
    names: tuple[str, ...]
    licence: str = ""


COMPILED = (
    Compiled(
        "yaml-cpp",
        "yaml-cpp",
        ("include", "src"),
        "yaml-cpp",
        ("yaml_cpp_vendor", "YAML_CPP", "YamlCpp", "yaml_cpp", "libyaml-cpp-dev"),
    ),
    Compiled(
        "tinyxml2",
        "tinyxml2",
        ("tinyxml2.cpp", "tinyxml2.h"),
        r"tinyxml2\.h",
        ("TinyXML2", "tinyxml2_vendor", "libtinyxml2-dev"),
    ),
    Compiled(
        "GeographicLib",
        "geographiclib",
        ("include", "src"),
        "GeographicLib",
        ("geographiclib", "Geographic", "libgeographiclib-dev", "libgeographic-dev"),
    ),
    Compiled(
        "orocos_kdl",
        "orocos-kdl",
        ("orocos_kdl/src",),
        "kdl",
        ("orocos_kdl_vendor", "orocos-kdl", "OrocosKDL", "liborocos-kdl-dev"),
    ),
    Compiled(
        "console_bridge",
        "console-bridge",
        ("include", "src"),
        "console_bridge",
        ("console_bridge_vendor", "libconsole-bridge-dev"),
    ),
    Compiled(
        "tinyxml",
        "tinyxml",
        (".",),
        r"tiny(xml|str)\.h",
        ("TinyXML", "tinyxml_vendor", "libtinyxml-dev"),
        "readme.txt",
    ),
    Compiled(
        "urdfdom_headers",
        "urdfdom-headers",
        (".",),
        r"urdf_(exception|model|model_state|sensor|world)",
        ("liburdfdom-headers-dev",),
    ),
    Compiled(
        "urdfdom", "urdfdom", ("urdf_parser",), "urdf_parser", ("urdf_parser", "liburdfdom-dev")
    ),
    Compiled(
        "zlib",
        "zlib",
        ("*.c", "*.h", "README"),
        r"z(lib|conf)\.h",
        ("ZLIB", "z", "zlib1g-dev"),
        "README",
    ),
    Compiled(
        "libpng",
        "libpng1.6",
        ("*.c", "*.h", "scripts/pnglibconf.h.prebuilt"),
        r"png(conf)?\.h",
        ("PNG", "png", "png16", "libpng16", "libpng-dev"),
    ),
    Compiled(
        "graphicsmagick",
        "graphicsmagick",
        ("Magick++/lib", "coders", "filters", "magick", "version.sh"),
        r"Magick\+\+(\.h)?|GraphicsMagick|magick",
        (
            *("GRAPHICSMAGICKCPP", "GraphicsMagick", "GraphicsMagick++"),
            *("libgraphicsmagick1-dev", "libgraphicsmagick++1-dev"),
        ),
    ),
)

LIBRARIES = (*UNAVAILABLE, *HEADER_ONLY)
# The packages that compile a library, by all of its names.
COMPILED_BY = {name: one.package for one in COMPILED for name in (one.package, *one.names)}
# The packages that no page can have.
NEVER = frozenset(package for library in UNAVAILABLE for package in library.packages)
# The names that find_package() finds.
PACKAGES = {*COMPILED_BY, *(package for library in LIBRARIES for package in library.packages)}


def compiled(names: Iterable[str]) -> list[str]:
    """Return the packages that compile the libraries among `names`."""
    return [COMPILED_BY[name] for name in names if name in COMPILED_BY]


def of_header(header: str) -> Library | None:
    """Return the library that a header, such as `opencv2/core.hpp`, is one of."""
    if (SYSTEM / header).is_file():
        return None
    first = header.partition("/")[0]
    found = (one for one in LIBRARIES if one.headers and re.fullmatch(one.headers, first))
    return next(found, None)


def compiled_for(header: str) -> str:
    """Return the package that compiles the library of a header; "" if there is none."""
    first = header.partition("/")[0]
    return next((one.package for one in COMPILED if re.fullmatch(one.headers, first)), "")
