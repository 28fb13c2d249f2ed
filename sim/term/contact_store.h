// What contact keeps between a linearisation and its products, and from step to step.
#pragma once

#include "sim/contact/stick.h"
#include "sim/term/contact.h"

namespace sim {

struct ContactTerm::Contacts : Store {
  // Where the candidates hold: as long as every point is in its box.
  Boxes boxes;
  std::vector<Candidate> candidates;
  Eigen::Matrix3Xd x, way;  // of the points
  std::vector<Touch> touches;
  std::vector<Stick> sticks;
  // Of the last linearisation.
  struct Block {
    std::array<int, 4> point;
    int count;
    PairMatrix K;
  };
  std::vector<Block> blocks;
};

}  // namespace sim
