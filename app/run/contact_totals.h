// What all contacts of a scene come to at a moment.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim/contact/contact_report.h"

namespace app {

struct ContactTotals {
  int pairs = 0;                                         // that push
  double gap = std::numeric_limits<double>::infinity();  // m, the least
};

ContactTotals totals_of(const std::vector<sim::ContactReport>& contacts);

// "34 contacts, least gap 0.00021 m"
std::string contact_text(const ContactTotals& totals);

}  // namespace app
