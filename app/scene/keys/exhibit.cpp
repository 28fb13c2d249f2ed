// Keys of [[exhibit]]: flat, as many kinds share them; which kind has which is told by the table of exhibits.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto exhibit_of = [](auto& d, const Indices& i) -> auto& {
  return d.exhibits[static_cast<std::size_t>(i[0])];
};

}  // namespace

std::vector<Key> exhibit_keys() {
  return {
      {"exhibit[]", Form(Kind::list).tells(Effect::look), length<whole_document, &Document::exhibits>,
       "What a page of a lecture shows beside the bodies: drawings and numbers, which go to numbers.csv."},
      {"exhibit[].kind", Form(Kind::choice).of(exhibit_names).needed(), field<exhibit_of, &ExhibitSpec::kind>,
       "Which; assets/lectures/README.md shows them."},
      {"exhibit[].body", Form(Kind::text).otherwise("the first body"), unless_empty<exhibit_of, &ExhibitSpec::body>,
       "Name of the body that it is about."},
      {"exhibit[].element", Form(Kind::integer, "", between(0, 1e9)), field<exhibit_of, &ExhibitSpec::element>,
       "Which element of the body's mesh, from 0."},
      {"exhibit[].node", Form(Kind::integer, "", between(-1, 1e9)), field<exhibit_of, &ExhibitSpec::node>,
       "Which node, from 0; -1 shows one after the other."},
      {"exhibit[].count", Form(Kind::integer, "", between(1, 1000)), field<exhibit_of, &ExhibitSpec::count>,
       "How many of what the exhibit counts: cells along an edge, terms of a basis, number of a mode."},
      {"exhibit[].pace", Form(Kind::number, "s", above(0)), field<exhibit_of, &ExhibitSpec::pace>,
       "Time from one thing shown to the next."},
      {"exhibit[].nodes", Form(Kind::points, "m").otherwise("where the body has them"),
       unless_empty<exhibit_of, &ExhibitSpec::nodes>, "Where the nodes of the element are held; a ring is dragged."},
      {"exhibit[].values", Form(Kind::numbers).of_size(1, 1000).otherwise("as the exhibit chooses"),
       unless_empty<exhibit_of, &ExhibitSpec::values>,
       "Numbers that can be dragged: values at nodes, collocation points."},
      {"exhibit[].basis", Form(Kind::text).otherwise("as the exhibit chooses"),
       unless_empty<exhibit_of, &ExhibitSpec::basis>, "Functions or elements that it interpolates with."},
  };
}

}  // namespace app
