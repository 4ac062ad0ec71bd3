# Every third-party package Burin uses: named here once, with why. `./dev` installs the Debian
# packages that the `apt` words name; CMake finds them through the lines that follow each.
#
#   burin_dependency(apt PACKAGE... why "...")        of the SDK, the brushes and the command
#   burin_test_dependency(apt PACKAGE... why "...")   of tests and benchmarks besides
function(burin_dependency)
endfunction()
function(burin_test_dependency)
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/BurinFindLibrary.cmake)

burin_dependency(apt g++ cmake ninja-build why "compiler and build")

burin_dependency(apt libeigen3-dev why "vectors, small matrices, sparse solvers")
find_package(Eigen3 3.4 REQUIRED NO_MODULE)

burin_dependency(apt libtbb-dev why "threads: parallel loops and sorts")
find_package(TBB REQUIRED)

burin_dependency(apt libxxhash-dev why "result hashes of replays")
burin_find_library(xxhash::xxhash xxhash.h xxhash REQUIRED)

burin_dependency(apt libfmt-dev why "text formatting")
find_package(fmt REQUIRED)

burin_dependency(apt libnanoflann-dev why "nearest neighbours among the points of a point set; headers only")
find_package(nanoflann 1.4 REQUIRED)

burin_dependency(apt libosd-dev why "Catmull-Clark and Loop refinement")
# Not find_package: Debian's configuration of it names a static library that its package lacks.
burin_find_library(OpenSubdiv::osdCPU opensubdiv/far/topologyRefiner.h osdCPU REQUIRED)

burin_dependency(apt nlohmann-json3-dev why "stroke files, glTF, reports")
find_package(nlohmann_json 3.11 REQUIRED)

burin_dependency(apt libpugixml-dev why "InkML, Xournal and SVG")
find_package(pugixml REQUIRED)

burin_dependency(apt libarchive-dev why "pen files packed by gzip, xz and zip")
find_package(LibArchive 3.6 REQUIRED)

burin_dependency(apt libyaml-cpp-dev why "recordings of libinput")
find_package(yaml-cpp REQUIRED)

burin_dependency(apt libopenvdb-dev why "level sets of solids: their surfaces, distances and .vdb files")
burin_find_library(OpenVDB::openvdb openvdb/openvdb.h openvdb REQUIRED)
find_package(Imath 3 REQUIRED)  # what its headers need besides

burin_dependency(apt libopenmesh-dev why "half-edges of meshes that are cut, joined and remeshed")
# Not find_package: Debian's configuration of it names files beside itself that are elsewhere.
burin_find_library(OpenMesh::core OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh OpenMeshCore REQUIRED)

# The tools because Debian's configuration of the library insists on finding them.
burin_dependency(apt libopenimageio-dev openimageio-tools why "stamps in, baked maps out")
find_package(OpenImageIO 2.4 REQUIRED)
# Debian's configuration of it names a folder of OpenCV that its package does not bring; the headers' own
# folder comes with OpenImageIO_Util.
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "" INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "")

# Not through OpenImageIO, which lets libpng write its complaints to the terminal and moves pictures by where
# they stand on a page.
burin_dependency(apt libpng-dev why "PNG stamps in, as numbers; PNG pictures out")
find_package(PNG REQUIRED)

burin_dependency(apt libtiff-dev why "what OpenImageIO does not tell of TIFF stamps: no-data values, masks")
find_package(TIFF 4.5 REQUIRED)

# Not OpenImageIO's own drawing of text, which knows no kerning.
burin_dependency(apt libfreetype-dev why "outlines of letters")
find_package(Freetype REQUIRED)

burin_dependency(apt libharfbuzz-dev why "choice and places of letters in a line: ligatures, kerning")
burin_find_library(HarfBuzz::harfbuzz harfbuzz/hb.h harfbuzz REQUIRED)

burin_dependency(apt fonts-dejavu-core why "the text brush sets text in it unless told another font")

burin_dependency(apt libcli11-dev why "command line of burin")
find_package(CLI11 REQUIRED)

if(BURIN_TESTS)
  burin_test_dependency(apt libgtest-dev why "tests")
  find_package(GTest REQUIRED)

  # Tests only: its licence (GPL) keeps it out of everything that is installed.
  burin_test_dependency(apt libcgal-dev why "exact geodesic distances, which tests measure charts against; checks of meshes")
  find_package(CGAL 5.5 REQUIRED)

  burin_test_dependency(apt libbenchmark-dev why "benchmarks of single kernels")
  find_package(benchmark 1.7 REQUIRED)

  burin_test_dependency(apt xz-utils why "tests unpack the compressed meshes of ../shared/data")
  find_program(XZ_PROGRAM xz REQUIRED)

  burin_test_dependency(apt qemu-user why "tests run the command as other x86-64 processors would")
  if(CMAKE_SYSTEM_PROCESSOR STREQUAL x86_64)
    find_program(QEMU_PROGRAM qemu-x86_64 REQUIRED)
  endif()

  # Not required: without them the packages are not tested.
  burin_test_dependency(apt dpkg-dev lintian why "the packages of Debian are made and looked at")

  # Not required: without them the headers are not compared with the frozen ones, and the site is not built.
  burin_test_dependency(apt abigail-tools why "the ABI's headers are compared with the frozen ones")
  burin_test_dependency(apt doxygen python3 why "the site of the guide and the reference")

  # Not required: tests/windows is skipped without it.
  burin_test_dependency(apt g++-mingw-w64-x86-64-posix why "a test compiles what is written for Windows")
endif()
