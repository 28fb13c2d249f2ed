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
       "Numbers that can be dragged: values at nodes, collocation points, numbers of rows."},
      {"exhibit[].basis", Form(Kind::text).otherwise("as the exhibit chooses"),
       unless_empty<exhibit_of, &ExhibitSpec::basis>, "Functions or elements that it approximates with."},
      {"exhibit[].method", Form(Kind::text).otherwise("one after the other"),
       unless_empty<exhibit_of, &ExhibitSpec::method>,
       "The method that is shown: one of `ritz residuals`; of \"five-vectors\" rows, least-squares, galerkin, energy "
       "or "
       "projection."},
      {"exhibit[].rows", Form(Kind::text).otherwise("equal"), unless_empty<exhibit_of, &ExhibitSpec::rows>,
       "Which rows of a large system are kept: \"equal\" (equally spaced), \"first\", or \"pivoted\" (those that a QR "
       "decomposition takes first)."},
      {"exhibit[].wind", Form(Kind::number), field<exhibit_of, &ExhibitSpec::wind>,
       "Of the large system: how much of a central difference is added to its matrix, which is symmetric with 0 only."},
      {"exhibit[].problem", Form(Kind::text).otherwise("as the exhibit chooses"),
       unless_empty<exhibit_of, &ExhibitSpec::problem>,
       "A problem file, as `ritz residuals` reads it; relative to the scene file."},
      {"exhibit[].eps", Form(Kind::number, "", between(1e-3, 10)).otherwise("slides from 1 to 0.01"),
       field<exhibit_of, &ExhibitSpec::eps>, "Diffusion in -eps u'' + u' = 1; a ring is dragged."},
      {"exhibit[].anyway", Kind::boolean, field<exhibit_of, &ExhibitSpec::anyway>,
       "Ritz's method is used although the problem is not self-adjoint."},
  };
}

}  // namespace app
