// Whatever bytes a mesh file has, it is read or refused: soon, and without asking for more memory than it can fill.
#include <sys/resource.h>
#include <unistd.h>

#include <ctime>
#include <fstream>

#include "tests/app/mesh_data.h"
#include "tests/fuzz/mesh_input.h"

namespace app {
namespace {

// While it lives the process cannot take more than 256 MB of address space on top of what it has.
class MemoryLimit {
 public:
  MemoryLimit() {
#if !defined(__SANITIZE_ADDRESS__)
    std::ifstream statm("/proc/self/statm");
    rlim_t pages = 0;
    statm >> pages;
    getrlimit(RLIMIT_AS, &before_);
    rlimit limit = before_;
    // More than a thread that starts late reserves for itself (a stack and 128 MB).
    limit.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (256u << 20);
    setrlimit(RLIMIT_AS, &limit);
#endif
  }
  ~MemoryLimit() {
#if !defined(__SANITIZE_ADDRESS__)
    setrlimit(RLIMIT_AS, &before_);
#endif
  }

 private:
  [[maybe_unused]] rlimit before_{};
};

std::vector<std::string> samples() {
  std::vector<std::string> files;
  for (const auto& file : box_files) files.push_back(read_all(data_folder() / file));
  files.push_back(
      "5 3 1 1\n0 0 0 0 0.5 1\n1 1 0 0 0.5 1\n2 0 1 0 0.5 0\n3 0 0 1 0.5 0\n4 1 1 1 2 2\n%"
      "2 4 1\n0 0 1 2 3 -1\n1 1 2 3 4 7\n");
  for (const char* file : {"box-1.msh", "box-40-text.msh", "box-gmsh-binary.vtk", "box-vtk-51-binary.vtk",
                           "box-meshio.vtu", "box-vtk-raw-zlib.vtu", "box-vtk-base64.vtu", "box-meshio.ply"})
    files.push_back(read_all(data_folder() / "formats" / file));
  files.push_back("stl:" + read_all(data_folder() / "formats" / "box-gmsh-binary.stl"));
  files.push_back(
      "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
      "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nCELL_DATA 1\nSCALARS part int 1\nLOOKUP_TABLE default\n7\n");
  files.push_back(
      "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\nNormals 1 0 0 1\n"
      "Tetrahedra 1\n1 2 3 4 2\nTriangles 1\n1 2 3 5\nEnd\n");
  files.push_back(
      "*VERTICES\n4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n*ELEMENTS\nTET\n1 4 0\n1 1 2 3 4\n*SET all\n1\n");
  files.push_back("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0.5\n4 0 1 2 3\n3 0 2 1\n");
  files.push_back("v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0.5\nf 1/1 2//2 3/3/3 4\nf 1 -2 -3\n");
  return files;
}

// Formats that count nothing end where any item ends.
std::vector<std::string> uncounted_samples() {
  return {
      "*NODE, NSET=n\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*ELEMENT, TYPE=C3D4, ELSET=e\n1, 1, 2, 3, "
      "4\n*ELSET, ELSET=g, GENERATE\n1, 5, 2\n*SURFACE, NAME=s\ne, S2\n*NSET, NSET=m\nn, 3\n",
      "stl:solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendloop\nendfacet\n"
      "endsolid a\n"};
}

// The number with which the items of a text are counted stands alone on its line, or first on it.
std::string with_number(const std::string& text, std::size_t at, const std::string& number) {
  const std::size_t end = text.find_first_of(" \r\n", at);
  return text.substr(0, at) + number + text.substr(std::min(end, text.size()));
}

// Seconds of the processor, so that a busy machine fails no test.
double seconds_of(const auto& call) {
  const std::clock_t start = std::clock();
  call();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(MeshRobustness, FilesCutAtAnyByteAreRefusedOrStillWhole) {
  const MemoryLimit limit;
  std::vector<std::string> files = samples();
  for (const auto& file : second_order_files) files.push_back(read_all(data_folder() / file));
  for (const std::string& file : files) {
    EXPECT_TRUE(try_mesh_input(file));
    std::size_t read = 0;
    for (std::size_t size = 0; size < file.size(); ++size)
      read += try_mesh_input(std::string_view(file).substr(0, size));
    // Only the last line's end, or what is not needed behind the last node (XML's closing tags), can be missed.
    EXPECT_LE(read, 40u) << file.substr(0, 30);
  }
}

TEST(MeshRobustness, FilesWithoutCountsCutAtAnyByteAreReadOrRefused) {
  const MemoryLimit limit;
  for (const std::string& file : uncounted_samples()) {
    EXPECT_TRUE(try_mesh_input(file)) << file;
    for (std::size_t size = 0; size < file.size(); ++size) try_mesh_input(std::string_view(file).substr(0, size));
  }
}

TEST(MeshRobustness, AbsurdNumbersAnywhereAreRefusedSoon) {
  const MemoryLimit limit;
  const std::vector<std::string> absurd = {"-1", "0", "2147483648", "1000000000000000000", "1e18", "nan"};
  std::vector<std::string> files = samples();
  for (const std::string& file : uncounted_samples()) files.push_back(file);
  for (const std::string& file : files) {
    if (file.find('\0') != file.npos) continue;
    for (std::size_t at = 1; at < file.size(); ++at) {
      if (!std::isspace(file[at - 1]) || std::isspace(file[at])) continue;
      for (const auto& number : absurd) {
        const std::string broken = with_number(file, at, number);
        EXPECT_LT(seconds_of([&] { try_mesh_input(broken); }), 1) << number << " at " << at;
      }
    }
  }
}

TEST(MeshRobustness, AbsurdBytesAnywhereAreRefusedSoon) {
  const MemoryLimit limit;
  for (const std::string& file : samples()) {
    if (file.find('\0') == file.npos) continue;
    for (std::size_t at = 0; at + 8 <= file.size(); ++at) {
      for (const std::uint64_t value : {~0ull, 0ull, 1ull << 31, 1ull << 62, 0x7ff0000000000000ull}) {
        std::string broken = file;
        broken.replace(at, 8, reinterpret_cast<const char*>(&value), 8);
        try_mesh_input(broken);
      }
    }
  }
}

TEST(MeshRobustness, CountsAreCheckedAgainstTheFile) {
  for (const char* count : {"-1", "2147483648", "1000000000000000000"}) {
    for (const char* file : {"box-2-text.msh", "box-4-text.msh"}) {
      const std::string text = read_all(data_folder() / file);
      for (const char* section : {"$Nodes\n", "$Elements\n", "$PhysicalNames\n"}) {
        const std::size_t at = text.find(section) + std::string_view(section).size();
        const std::string message = error_of([&] { read_text(with_number(text, at, count), "a.msh"); });
        EXPECT_NE(message.find(std::string(" is ") + count + ", but the "), message.npos) << message;
      }
    }
  }
}

TEST(MeshRobustness, WhatTheFuzzerFoundStaysHarmless) {
  const MemoryLimit limit;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "fuzz")) {
    const std::string input = read_all(entry.path());
    EXPECT_LT(seconds_of([&] { try_mesh_input(input); }), 1) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 5);
}

}  // namespace
}  // namespace app
