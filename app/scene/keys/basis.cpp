// Keys of the basis that a body moves in.
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

// A member of a basis that is there as soon as one of its keys is.
template <auto member>
constexpr Binding of_basis = {[](const Document& d, const Indices& i) -> std::optional<Value> {
                                const auto& basis = body_of(d, i).basis;
                                return basis ? to_optional((*basis).*member) : std::nullopt;
                              },
                              [](Document& d, const Indices& i, const Value& value) {
                                auto& basis = body_of(d, i).basis;
                                from_value(value, (basis ? *basis : basis.emplace()).*member);
                              }};

std::vector<std::string_view> basis_names() {
  std::vector<std::string_view> names = names_of<sim::BasisKind>();
  names.push_back("none");
  return names;
}

// What a basis of kind "none" says is given up when all keys are read.
constexpr Binding kind = {[](const Document& d, const Indices& i) {
                            if (d.without_basis[static_cast<std::size_t>(i[0])])
                              return std::optional<Value>(std::string("none"));
                            return of_basis<&sim::Basis::kind>.get(d, i);
                          },
                          [](Document& d, const Indices& i, const Value& value) {
                            char& without = d.without_basis[static_cast<std::size_t>(i[0])];
                            without = std::get<std::string>(value) == "none";
                            if (!without) of_basis<&sim::Basis::kind>.set(d, i, value);
                          }};

constexpr Binding folder = {[](const Document& d, const Indices& i) {
                              const std::filesystem::path& held = d.basis_folders[static_cast<std::size_t>(i[0])];
                              return held.empty() ? std::nullopt : std::optional<Value>(held.string());
                            },
                            [](Document& d, const Indices& i, const Value& value) {
                              from_value(value, d.basis_folders[static_cast<std::size_t>(i[0])]);
                            }};

}  // namespace

std::vector<Key> basis_keys() {
  return {
      {"body[].basis",
       Form(Kind::table).tells(Effect::motion),
       {},
       "Moves the body in a few numbers, x = X + U c, instead of in all of its nodes; sim/reduce/README.md has what "
       "that "
       "costs. Every body of the scene has a basis then, and pins that hold it."},
      {"body[].basis.kind", Form(Kind::choice).of(basis_names).needed(), kind,
       "What the vectors are: \"modes\", the slowest vibration modes; \"derivatives\", modes and how they change where "
       "the body is bent; \"snapshots\", what the states of a run have in common; \"none\", all of its nodes."},
      {"body[].basis.count", Form(Kind::integer, "", between(1, 1000)).otherwise("20"), of_basis<&sim::Basis::count>,
       "How many vectors there are."},
      {"body[].basis.cubature", Form(Kind::number, "", between(0, 0.5)).otherwise("0: all elements are summed"),
       of_basis<&sim::Basis::cubature>,
       "Sums forces over a few elements, with weights, so that steps cost the same whatever the mesh: the error of the "
       "forces that this may make, a share of them."},
      {"body[].basis.from", Form(Kind::text).otherwise("none"), folder,
       "Folder of a run with VTU files (`--vtu`), whose states make a basis of kind \"snapshots\" and train a "
       "cubature."},
  };
}

}  // namespace app
