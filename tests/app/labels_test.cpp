#include "app/picture/labels.h"

#include <gtest/gtest.h>

namespace app {
namespace {

// A square that faces a camera on the z axis.
render::Surface square_surface(const std::string& name, float x, float y, float z, float half) {
  render::Surface surface;
  surface.name = name;
  surface.positions = {x - half, y - half, z, x + half, y - half, z, x + half, y + half, z, x - half, y + half, z};
  return surface;
}

TEST(Labels, StandAboveBodiesAndBelowWhatIsHiddenBySomethingNearer) {
  render::Frame frame;
  frame.camera = {.eye = {0, 0, 10}, .target = {0, 0, 0}};
  // The far one's upper edge is behind the near one; of the third nothing is hidden.
  frame.surfaces = {square_surface("far", 0, 0, 0, 1), square_surface("near", 0, 1, 2, 1),
                    square_surface("aside", 4, 0, 0, 1)};
  add_labels(2, frame);
  ASSERT_EQ(frame.labels.size(), 2U);
  EXPECT_EQ(frame.labels[0].text, "far");
  EXPECT_TRUE(frame.labels[0].below);
  EXPECT_FLOAT_EQ(frame.labels[0].at[1], -1);
  EXPECT_FALSE(frame.labels[1].below);
  EXPECT_FLOAT_EQ(frame.labels[1].at[1], 2);

  // Nearer to the camera, the same place is its own.
  frame.labels.clear();
  std::swap(frame.surfaces[0], frame.surfaces[2]);
  frame.surfaces[1] = square_surface("near", 0, 1, -2, 1);
  add_labels(3, frame);
  for (const render::Label& label : frame.labels) EXPECT_FALSE(label.below) << label.text;
}

// The names of what lies between others in a stack would stand on these.
TEST(Labels, StandOnTheirOwnBodyBetweenOthers) {
  render::Frame frame;
  frame.camera = {.eye = {0, 0, 10}, .target = {0, 0, 0}, .orthographic = true, .height = 8};
  for (const float y : {-2.0F, 0.0F, 2.0F}) frame.surfaces.push_back(square_surface("s", 0, y, 0, 1.01F));
  add_labels(3, frame);
  ASSERT_EQ(frame.labels.size(), 3U);
  EXPECT_TRUE(frame.labels[0].below);
  EXPECT_FLOAT_EQ(frame.labels[1].at[1], 0);
  EXPECT_FLOAT_EQ(frame.labels[2].at[1], 3.01F);
}

}  // namespace
}  // namespace app
