#include "app/run/contact_totals.h"

#include <algorithm>

#include "app/base/text.h"

namespace app {

ContactTotals totals_of(const std::vector<sim::ContactReport>& contacts) {
  ContactTotals totals;
  for (const sim::ContactReport& contact : contacts) {
    totals.pairs += contact.pairs;
    totals.gap = std::min(totals.gap, contact.gap);
  }
  return totals;
}

std::string contact_text(const ContactTotals& totals) {
  std::string text = std::to_string(totals.pairs) + (totals.pairs == 1 ? " contact" : " contacts");
  if (totals.pairs > 0) text += formatted(", least gap %.2g m", totals.gap);
  return text;
}

}  // namespace app
