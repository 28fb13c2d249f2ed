#include "app/mesh/obj.h"

#include "app/mesh/cursor.h"
#include "app/mesh/face_set.h"

namespace app {
namespace {

// "v x y z", with a weight or a colour behind it perhaps.
Eigen::Vector3d read_vertex(Cursor& in) {
  Eigen::Vector3d X;
  for (double& x : X) {
    if (in.line_finished()) in.fail("a vertex needs three coordinates");
    x = in.real("a coordinate");
  }
  return X;
}

// "7", "7/1", "7/1/3" or "7//3": the vertex comes first, counted from 1, or from the last one backwards (-1).
int read_corner(Cursor& in, std::string_view word, int vertex_count) {
  std::int64_t vertex = 0;
  if (!parse(word.substr(0, word.find('/')), vertex) || vertex == 0) {
    in.fail("a corner of a face is " + quote(word) + "; it should be the number of a vertex, such as 7 or 7/1/3");
  }
  if (vertex > vertex_count || vertex < -vertex_count) {
    in.fail("a face refers to vertex " + std::to_string(vertex) + "; the number of vertices above it is " +
            std::to_string(vertex_count));
  }
  return static_cast<int>(vertex > 0 ? vertex - 1 : vertex + vertex_count);
}

// A line goes on after a backslash at its end.
bool statement_finished(Cursor& in) {
  while (!in.line_finished()) {
    const std::size_t start = in.position();
    if (in.word("a corner of a face") != "\\" || !in.line_finished()) {
      in.go_to(start);
      return false;
    }
    in.rest_of_line();
  }
  return true;
}

void read_face(Cursor& in, FaceSet& faces) {
  std::vector<int> corners;
  while (!statement_finished(in)) {
    std::string_view word = in.word("a corner of a face");
    const bool goes_on = word.size() > 1 && word.ends_with('\\') && in.line_finished();
    if (goes_on) word.remove_suffix(1);
    corners.push_back(read_corner(in, word, static_cast<int>(faces.vertices.size())));
    if (goes_on) in.rest_of_line();
  }
  faces.add(in, corners);
}

// "g low left" and "o table": the faces that follow are in these groups, and belong to that object.
class ObjParts {
 public:
  void read(Cursor& in, std::string_view statement, FaceSet& faces) {
    std::vector<std::string>& names = statement == "o" ? objects_ : groups_;
    names.clear();
    while (!in.line_finished()) names.emplace_back(in.word("a name"));
    std::vector<std::string> all = objects_;
    all.insert(all.end(), groups_.begin(), groups_.end());
    faces.put_in(all);
  }

 private:
  std::vector<std::string> objects_, groups_;
};

}  // namespace

sim::Mesh read_obj(std::string_view content, std::string_view name, std::vector<std::string>& remarks) {
  Cursor in(content, name, '#');
  FaceSet faces(1);
  ObjParts parts;
  while (!in.finished()) {
    const std::string_view statement = in.word("a statement");
    if (statement == "v") {
      faces.vertices.push_back(read_vertex(in));
    } else if (statement == "f") {
      read_face(in, faces);
    } else if (statement == "g" || statement == "o") {
      parts.read(in, statement, faces);
    }
    in.rest_of_line();
  }
  return faces.mesh(in, remarks);
}

}  // namespace app
