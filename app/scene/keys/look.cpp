// Keys of [look].
#include "app/scene/keys/binding.h"
#include "app/scene/keys/choices.h"

namespace app {
namespace {

constexpr auto look_of = [](auto& d, const Indices&) -> auto& {
  return d.look;
};

std::vector<Key> colour_keys() {
  return {
      {"look", Form(Kind::table).tells(Effect::look), {}, "What the picture shows."},
      {"look.style", Form(Kind::choice).of(style_names), field<look_of, &Look::style>,
       "\"lecture\": paper, large letters and thick dark lines, for a projector and the last row of a hall."},
      {"look.colour", Form(Kind::choice).of(colour_names), field<look_of, &Look::colour>,
       "Colours of the bodies: \"plain\", or by von Mises stress, largest principal stretch, energy density, J = det "
       "F, "
       "or the pressure of contact and obstacles."},
      {"look.range",
       Form(Kind::numbers, "of the values")
           .of_size(2, 2)
           .otherwise("from the scene, and grows in round steps with the values of the frames so far"),
       field<look_of, &Look::range>, "Values at the two ends of the colour map."},
      {"look.colour_map",
       Form(Kind::choice).of(colour_map_choices).otherwise("\"viridis\"; \"blue-red\" for stretch and J, white at 1"),
       field<look_of, &Look::colour_map>,
       "Colours from low to high values; the colour-blind can tell them apart in every map."},
      {"look.finish", Form(Kind::choice).of(finish_names).only_in(3), field<look_of, &Look::finish>,
       "How bodies reflect light: \"rubber\" is dull and opaque, \"jelly\" is glossy and lets light through."},
      {"look.smooth", Form(Kind::boolean).only_in(3), field<look_of, &Look::smooth>,
       "Draw surfaces of linear elements rounded where they are smooth; false draws their flat faces."},
  };
}

std::vector<Key> stage_keys() {
  return {
      {"look.background", Form(Kind::choice).of(background_names).otherwise("\"studio\" in 3D, \"paper\" in 2D"),
       field<look_of, &Look::background>, "What is behind the bodies: \"studio\" is a light room, \"paper\" is white."},
      {"look.shadows", Form(Kind::boolean).only_in(3), field<look_of, &Look::shadows>,
       "Draw soft shadows, and darken creases."},
      {"look.ground", Form(Kind::boolean).only_in(3), field<look_of, &Look::ground>,
       "Draw a floor, on which shadows fall. It holds nothing: bodies fall through it unless there is an obstacle."},
      {"look.ground_height",
       Form(Kind::number, "m")
           .only_in(3)
           .otherwise(
               "below the lowest body and obstacle; no floor over an obstacle that is one, nor below bodies that "
               "nothing holds"),
       field<look_of, &Look::ground_height>, "Height of the floor along camera.up."},
      {"look.obstacles", Kind::boolean, field<look_of, &Look::obstacles>, "Draw the obstacles."},
  };
}

std::vector<Key> mark_keys() {
  return {
      {"look.wireframe", Kind::boolean, field<look_of, &Look::wireframe>,
       "Draw the edges of the elements, or of the skin that a body wears."},
      {"look.ghost", Kind::boolean, field<look_of, &Look::ghost>,
       "Draw the rest shape, translucent; of bodies that move in a basis, these bodies in all of their nodes, which "
       "are "
       "stepped as well."},
      {"look.pins", Kind::boolean, field<look_of, &Look::pins>, "Draw a dot at every pinned node of the surface."},
      {"look.forces", Kind::boolean, field<look_of, &Look::forces>,
       "Draw forces as arrows: blue for tractions, pressures, point forces and springs, purple for contact and "
       "obstacles, "
       "red for what holds pinned nodes. Forces of neighbouring nodes are joined into one arrow."},
      {"look.contact_forces", Kind::boolean, field<look_of, &Look::contact_forces>,
       "Draw the forces of contact and obstacles alone, with their friction, as purple arrows."},
      {"look.force_scale",
       Form(Kind::number, "m/N", above(0)).otherwise("weight and loads together make half the size of the scene"),
       field<look_of, &Look::force_scale>, "Length of an arrow for each newton."},
      {"look.velocities", Kind::boolean, field<look_of, &Look::velocities>,
       "Draw velocities as arrows, each the mean over neighbouring nodes."},
      {"look.velocity_scale",
       Form(Kind::number, "s", above(0))
           .otherwise("a fall over the size of the scene makes an arrow of 0.4 times that size"),
       field<look_of, &Look::velocity_scale>,
       "Length of an arrow for each m/s: an arrow is as long as the way of its point in this time."},
  };
}

std::vector<Key> text_keys() {
  return {
      {"look.caption", Kind::text, field<look_of, &Look::caption>,
       "Text below the picture; {t}, {frame}, {steps}, {step} = h, {energy}, {kinetic}, {elastic}, {potential}, "
       "{iterations}, {min_J}, {nodes}, {elements} stand for their values."},
      {"look.labels", Form(Kind::boolean).otherwise("when there are several bodies"), field<look_of, &Look::labels>,
       "Write the name of each body above it."},
      {"look.energies", Kind::boolean, field<look_of, &Look::energies>,
       "Plot kinetic, elastic, potential and total energy over time. Left out where a small picture has no room for "
       "it."},
      {"look.axes", Form(Kind::boolean).only_in(2), field<look_of, &Look::axes>,
       "Draw axes with numbers at the left and the lower edge."},
      {"look.scale_bar", Form(Kind::boolean).only_in(2), field<look_of, &Look::scale_bar>,
       "Draw a scale bar of a round length."},
  };
}

}  // namespace

std::vector<Key> look_keys() {
  std::vector<Key> table = colour_keys();
  for (const auto& part : {stage_keys(), mark_keys(), text_keys()}) append(table, part);
  return table;
}

}  // namespace app
