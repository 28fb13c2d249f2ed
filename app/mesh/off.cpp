#include "app/mesh/off.h"

#include "app/mesh/face_set.h"

namespace app {
namespace {

// "OFF", "COFF", "NOFF", "STOFF", ...: what the letters before it announce stands behind the coordinates. The word may
// be missing; four dimensions (4OFF, nOFF) are none of a surface.
void read_off_header(Cursor& in) {
  const std::size_t start = in.position();
  const std::string_view word = in.word("OFF");
  std::int64_t number = 0;
  if (parse(word, number)) return in.go_to(start);
  if (!word.ends_with("OFF")) in.fail(quote(word) + " stands where OFF should be");
  if (word.find_first_of("4n") != word.npos) in.fail(quote(word) + " has other than three coordinates a vertex");
  const std::size_t behind = in.position();
  if (!in.line_finished() && in.word("a count") == "BINARY") in.fail("binary OFF is not read: save it as text");
  in.go_to(behind);
}

}  // namespace

sim::Mesh read_off(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name, '#');
  read_off_header(in);
  const int vertices = in.checked_count(in.whole("the number of vertices"), 6, "the number of vertices");
  const int faces = in.checked_count(in.whole("the number of faces"), 8, "the number of faces");
  in.rest_of_line();  // the number of edges, which nobody needs
  FaceSet set(0);
  for (int i = 0; i < vertices; ++i) {
    Eigen::Vector3d& X = set.vertices.emplace_back();
    for (double& x : X) x = in.real("a coordinate");
    in.rest_of_line();
  }
  for (int i = 0; i < faces; ++i) {
    const int count = in.checked_count(in.whole("the number of corners"), 2, "the number of corners");
    std::vector<int> corners;
    for (int k = 0; k < count; ++k) corners.push_back(set.checked_vertex(in, in.whole("a corner of a face")));
    set.add(in, corners);
    in.rest_of_line();
  }
  return set.mesh(in, remarks);
}

}  // namespace app
