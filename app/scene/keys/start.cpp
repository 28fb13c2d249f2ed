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
      {"body[].untangle", Form(Kind::number, "", at_least(0)), field<body_of, &sim::Body::untangle>,
       "Strength of a pull towards the rest shape that acts only while the body is folded through itself or has "
       "elements inside out: 1 undoes nearly every tangle, 0.1 is gentler, 0 leaves them."},
      {"body[].start", Form(Kind::table).tells(Effect::start), {}, "How the body is deformed at the start."},
      {"body[].start.shape", Form(Kind::choice).of(start_names), field<start_of, &sim::Start::shape>,
       "The deformation; app/scene/README.md has a table of them."},
      {"body[].start.amount", Form(Kind::number, "depends on the shape").otherwise("depends on the shape"),
       field<start_of, &sim::Start::amount>,
       "How far the body is deformed: a factor, degrees (\"twisted\") or body sizes (\"far\")."},
      {"body[].start.direction",
       Form(Kind::direction).otherwise("the longest axis; \"plane\" and \"squashed\": the thinnest"),
       field<start_of, &sim::Start::direction>, "Axis or normal of the deformation."},
      {"body[].start.perturbation",
       Form(Kind::number, "body sizes", at_least(0)).otherwise("1e-3 for \"plane\", \"line\", \"point\", else 0"),
       field<start_of, &sim::Start::perturbation>,
       "Largest random displacement of each component of each node. It leaves states that a symmetric body would never "
       "leave."},
  };
}

}  // namespace app
