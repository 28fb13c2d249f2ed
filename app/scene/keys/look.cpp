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
      {.path = "look", .kind = Kind::table, .meaning = "What the picture shows."},
      {.path = "look.colour",
       .kind = Kind::choice,
       .choices = colour_names,
       .meaning =
           "Colours of the bodies: \"plain\", or by von Mises stress, largest principal stretch, energy density, or "
           "J = det F.",
       .binding = field<look_of, &Look::colour>},
      {.path = "look.range",
       .kind = Kind::numbers,
       .unit = "of the values",
       .size = {2, 2},
       .absent = "from the scene, and grows in round steps with the values of the frames so far",
       .meaning = "Values at the two ends of the colour map.",
       .binding = field<look_of, &Look::range>},
      {.path = "look.colour_map",
       .kind = Kind::choice,
       .choices = colour_map_choices,
       .absent = "\"viridis\"; \"blue-red\" for stretch and J, white at 1",
       .meaning = "Colours from low to high values; the colour-blind can tell them apart in every map.",
       .binding = field<look_of, &Look::colour_map>},
      {.path = "look.finish",
       .kind = Kind::choice,
       .choices = finish_names,
       .dimension = 3,
       .meaning =
           "How bodies reflect light: \"rubber\" is dull and opaque, \"jelly\" is glossy and lets light through.",
       .binding = field<look_of, &Look::finish>},
      {.path = "look.smooth",
       .kind = Kind::boolean,
       .dimension = 3,
       .meaning = "Draw surfaces of linear elements rounded where they are smooth; false draws their flat faces.",
       .binding = field<look_of, &Look::smooth>},
  };
}

std::vector<Key> stage_keys() {
  return {
      {.path = "look.background",
       .kind = Kind::choice,
       .choices = background_names,
       .absent = "\"studio\" in 3D, \"paper\" in 2D",
       .meaning = "What is behind the bodies: \"studio\" is a light room, \"paper\" is white.",
       .binding = field<look_of, &Look::background>},
      {.path = "look.shadows",
       .kind = Kind::boolean,
       .dimension = 3,
       .meaning = "Draw soft shadows, and darken creases.",
       .binding = field<look_of, &Look::shadows>},
      {.path = "look.ground",
       .kind = Kind::boolean,
       .dimension = 3,
       .meaning =
           "Draw a floor, on which shadows fall. It holds nothing: bodies fall through it unless there is an obstacle.",
       .binding = field<look_of, &Look::ground>},
      {.path = "look.ground_height",
       .kind = Kind::number,
       .unit = "m",
       .dimension = 3,
       .absent = "below the lowest body; no floor over an obstacle that is one",
       .meaning = "Height of the floor along camera.up.",
       .binding = field<look_of, &Look::ground_height>},
      {.path = "look.obstacles",
       .kind = Kind::boolean,
       .meaning = "Draw the obstacles.",
       .binding = field<look_of, &Look::obstacles>},
  };
}

std::vector<Key> mark_keys() {
  return {
      {.path = "look.wireframe",
       .kind = Kind::boolean,
       .meaning = "Draw the edges of the elements.",
       .binding = field<look_of, &Look::wireframe>},
      {.path = "look.ghost",
       .kind = Kind::boolean,
       .meaning = "Draw the rest shape, translucent.",
       .binding = field<look_of, &Look::ghost>},
      {.path = "look.pins",
       .kind = Kind::boolean,
       .meaning = "Draw a dot at every pinned node of the surface.",
       .binding = field<look_of, &Look::pins>},
      {.path = "look.forces",
       .kind = Kind::boolean,
       .meaning = "Draw forces as arrows: blue for tractions, springs and obstacles, red for what holds pinned nodes. "
                  "Forces of neighbouring nodes are joined into one arrow.",
       .binding = field<look_of, &Look::forces>},
      {.path = "look.force_scale",
       .kind = Kind::number,
       .unit = "m/N",
       .range = above(0),
       .absent = "weight and loads together make half the size of the scene",
       .meaning = "Length of an arrow for each newton.",
       .binding = field<look_of, &Look::force_scale>},
      {.path = "look.velocities",
       .kind = Kind::boolean,
       .meaning = "Draw velocities as arrows, each the mean over neighbouring nodes.",
       .binding = field<look_of, &Look::velocities>},
      {.path = "look.velocity_scale",
       .kind = Kind::number,
       .unit = "s",
       .range = above(0),
       .absent = "a fall over the size of the scene makes an arrow of 0.4 times that size",
       .meaning = "Length of an arrow for each m/s: an arrow is as long as the way of its point in this time.",
       .binding = field<look_of, &Look::velocity_scale>},
  };
}

std::vector<Key> text_keys() {
  return {
      {.path = "look.caption",
       .kind = Kind::text,
       .meaning = "Text below the picture; {t}, {frame}, {steps}, {step} = h, {energy}, {kinetic}, {elastic}, "
                  "{potential}, {iterations}, {min_J}, {nodes}, {elements} stand for their values.",
       .binding = field<look_of, &Look::caption>},
      {.path = "look.labels",
       .kind = Kind::boolean,
       .absent = "when there are several bodies",
       .meaning = "Write the name of each body above it.",
       .binding = field<look_of, &Look::labels>},
      {.path = "look.energies",
       .kind = Kind::boolean,
       .meaning = "Plot kinetic, elastic, potential and total energy over time.",
       .binding = field<look_of, &Look::energies>},
      {.path = "look.axes",
       .kind = Kind::boolean,
       .dimension = 2,
       .meaning = "Draw axes with numbers at the left and the lower edge.",
       .binding = field<look_of, &Look::axes>},
      {.path = "look.scale_bar",
       .kind = Kind::boolean,
       .dimension = 2,
       .meaning = "Draw a scale bar of a round length.",
       .binding = field<look_of, &Look::scale_bar>},
  };
}

}  // namespace

std::vector<Key> look_keys() {
  std::vector<Key> table = colour_keys();
  for (const auto& part : {stage_keys(), mark_keys(), text_keys()}) append(table, part);
  return table;
}

}  // namespace app
