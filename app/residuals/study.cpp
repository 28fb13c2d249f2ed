#include "app/residuals/study.h"

#include <algorithm>
#include <sstream>

namespace app {
namespace {

using sim::residual::Asymmetry;
using sim::residual::Basis;
using sim::residual::Method;

// x (1-x) and x^power times it
std::string asymmetry_text(const Asymmetry& asymmetry) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(10);
  text << "int v L u - int u L v = " << asymmetry.difference << " for u = x (1-x), v = x^" << asymmetry.power + 1
       << " (1-x)";
  return text.str();
}

class Contest {
 public:
  Contest(ResidualStudy& study, bool anyway) : study_(study), anyway_(anyway) {}

  void run() {
    for (const Basis* const basis : study_.file.bases)
      for (const Method* const method : study_.file.methods) run(*basis, *method);
  }

 private:
  bool self_adjoint() const { return study_.asymmetry.power == 0; }

  void refuse(const std::string& why) {
    if (std::ranges::find(study_.refusals, why) == study_.refusals.end()) study_.refusals.push_back(why);
  }

  void run(const Basis& basis, const Method& method) {
    const std::string unfit = refusal(method, basis);
    if (!unfit.empty()) return refuse(unfit);
    const bool applies = self_adjoint() || !method.needs_functional;
    std::string name(method.name);
    if (!applies && !anyway_) {
      return refuse(name + " needs a self-adjoint L, and " + asymmetry_text(study_.asymmetry) +
                    ", not 0; --anyway does it all the same");
    }
    if (!applies) name += "-anyway";
    for (const int n : study_.file.n) {
      const auto answer = method.solve(study_.file.problem, basis, n);
      if (!answer.refusal.empty()) {
        refuse(name + " with " + std::to_string(n) + " " + std::string(basis.name) + ": " + answer.refusal);
        continue;
      }
      const sim::residual::Trial u(basis, answer.c);
      study_.attempts.push_back({name, u, measure(study_.file.problem, u, self_adjoint())});
    }
  }

  ResidualStudy& study_;
  bool anyway_;
};

}  // namespace

ResidualStudy study_residuals(ProblemFile file, bool anyway) {
  ResidualStudy study{std::move(file), {}, {}, {}};
  study.asymmetry = asymmetry(study.file.problem);
  Contest(study, anyway).run();
  return study;
}

}  // namespace app
