// Keys of the state that a body starts from, and of the way out of a tangled one.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto start_of = [](auto& d, const Indices& i) -> auto& {
  return body_of(d, i).start;
};

}  // namespace

std::vector<Key> start_keys() {
  return {
      {.path = "body[].untangle",
       .kind = Kind::number,
       .range = at_least(0),
       .meaning =
           "Strength of a pull towards the rest shape that acts only while the body is folded through itself or has "
           "elements inside out: 1 undoes nearly every tangle, 0.1 is gentler, 0 leaves them.",
       .binding = field<body_of, &sim::Body::untangle>},
      {.path = "body[].start", .kind = Kind::table, .meaning = "How the body is deformed at the start."},
      {.path = "body[].start.shape",
       .kind = Kind::choice,
       .choices = start_names,
       .meaning = "The deformation; app/scene/README.md has a table of them.",
       .binding = field<start_of, &sim::Start::shape>},
      {.path = "body[].start.amount",
       .kind = Kind::number,
       .unit = "depends on the shape",
       .absent = "depends on the shape",
       .meaning = "How far the body is deformed: a factor, degrees (\"twisted\") or body sizes (\"far\").",
       .binding = field<start_of, &sim::Start::amount>},
      {.path = "body[].start.direction",
       .kind = Kind::direction,
       .absent = "the longest axis; \"plane\" and \"squashed\": the thinnest",
       .meaning = "Axis or normal of the deformation.",
       .binding = field<start_of, &sim::Start::direction>},
      {.path = "body[].start.perturbation",
       .kind = Kind::number,
       .unit = "body sizes",
       .range = at_least(0),
       .absent = "1e-3 for \"plane\", \"line\", \"point\", else 0",
       .meaning = "Largest random displacement of each component of each node. It leaves states that a symmetric body "
                  "would never leave.",
       .binding = field<start_of, &sim::Start::perturbation>},
  };
}

}  // namespace app
