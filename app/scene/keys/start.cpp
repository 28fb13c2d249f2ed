// Keys of the state that a body starts from, and of the way out of a tangled one.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto start_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).start;
};

constexpr Binding file = {[](const Document& d, const Indices& i) {
                            const std::filesystem::path& held = d.start_files[static_cast<std::size_t>(i[0])];
                            return held.empty() ? std::nullopt : std::optional<Value>(held.string());
                          },
                          [](Document& d, const Indices& i, const Value& value) {
                            from_value(value, d.start_files[static_cast<std::size_t>(i[0])]);
                          }};

// Nodes that come from a file are told by its name.
constexpr Binding nodes = {[](const Document& d, const Indices& i) {
                             const bool listed = d.start_files[static_cast<std::size_t>(i[0])].empty();
                             return listed ? unless_empty<start_of, &sim::Start::nodes>.get(d, i) : std::nullopt;
                           },
                           field<start_of, &sim::Start::nodes>.set};

std::vector<Key> given_keys() {
  return {
      {"body[].start.matrix", Form(Kind::matrix).otherwise("none"), unless_empty<start_of, &sim::Start::matrix>,
       "Of shape = \"affine\": the rows of A in x = A X, about the origin."},
      {"body[].start.nodes", Form(Kind::points, "m").otherwise("none"), nodes,
       "Of shape = \"nodes\": where every node of the mesh is, in their order."},
      {"body[].start.file", Form(Kind::text).otherwise("none"), file,
       "Of shape = \"nodes\", instead of nodes: a text file with a node on each line."},
      {"body[].start.mode", Form(Kind::integer, "", between(1, 1e6)), field<start_of, &sim::Start::mode>,
       "Of shape = \"mode\": which vibration mode of the body, pinned as it is, at rest; the slowest is 1. `ritz "
       "modes` "
       "lists them."},
  };
}

}  // namespace

std::vector<Key> start_keys() {
  std::vector<Key> table = {
      {"body[].untangle", Form(Kind::number, "", at_least(0)), field<body_of, &sim::Body::untangle>,
       "Strength of a pull towards the rest shape that acts only while the body is folded through itself or has "
       "elements inside out: 1 undoes nearly every tangle, 0.1 is gentler, 0 leaves them."},
      {"body[].start", Form(Kind::table).tells(Effect::start), {}, "How the body is deformed at the start."},
      {"body[].start.shape", Form(Kind::choice).of(start_names), field<start_of, &sim::Start::shape>,
       "The deformation; app/scene/README.md has a table of them."},
      {"body[].start.amount", Form(Kind::number, "depends on the shape").otherwise("depends on the shape"),
       field<start_of, &sim::Start::amount>,
       "How far the body is deformed: a factor, degrees (\"twisted\") or body sizes (\"far\"), or m "
       "(\"mode\": its largest displacement)."},
      {"body[].start.direction",
       Form(Kind::direction).otherwise("the longest axis; \"plane\" and \"squashed\": the thinnest"),
       field<start_of, &sim::Start::direction>, "Axis or normal of the deformation."},
      {"body[].start.perturbation",
       Form(Kind::number, "body sizes", at_least(0)).otherwise("1e-3 for \"plane\", \"line\", \"point\", else 0"),
       field<start_of, &sim::Start::perturbation>,
       "Largest random displacement of each component of each node. It leaves states that a symmetric body would never "
       "leave."},
  };
  append(table, given_keys());
  return table;
}

}  // namespace app
