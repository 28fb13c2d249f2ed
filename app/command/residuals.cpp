// `ritz residuals`: weighted residual methods on problems in one dimension.
#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "app/base/exit_code.h"
#include "app/base/gnuplot.h"
#include "app/base/output_file.h"
#include "app/base/shipped.h"
#include "app/command/commands.h"
#include "app/residuals/plot.h"
#include "app/residuals/tables.h"

namespace app {
namespace {

namespace fs = std::filesystem;

// The problems that come with the program.
std::vector<fs::path> shipped_problems() {
  const fs::path folder = shipped_folder() / "lectures/problems";
  std::error_code none;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  if (files.empty())
    throw std::runtime_error("the problems that come with it are not there; name one: ritz residuals PROBLEM.toml");
  std::ranges::sort(files);
  return files;
}

fs::path output_folder(const Options& options) {
  fs::path folder = options.out;
  if (folder.empty())
    folder = options.problem.empty() ? fs::path("out/residuals") : "out/residuals" / options.problem.stem();
  const fs::path file = folder / "residuals.csv";
  if (!options.overwrite && fs::exists(file))
    throw std::runtime_error(file.string() + ": exists already; choose another folder with -o, or --overwrite");
  return folder;
}

}  // namespace

int residuals(const Options& options) {
  const std::vector<fs::path> files = options.problem.empty() ? shipped_problems() : std::vector{options.problem};
  const fs::path folder = output_folder(options);
  std::vector<ResidualStudy> studies;
  for (const fs::path& file : files) {
    studies.push_back(study_residuals(read_problem(file), options.anyway));
    std::cout << study_text(studies.back()) << '\n' << std::flush;
  }
  make_folder(folder);
  write_atomically(folder / "coefficients.csv", coefficients_csv(studies), false);
  write_atomically(folder / "orders.csv", orders_csv(studies), false);
  write_atomically(folder / "residuals.csv", residuals_csv(studies), false);
  std::string not_drawn;
  for (const ResidualStudy& study : studies) {
    const fs::path script = folder / (study.file.name + ".gnuplot");
    write_atomically(script, residual_plot_script(study, folder / study.file.name), false);
    if (const std::string why = run_gnuplot(script); !why.empty()) not_drawn = why;
  }
  std::cout << "numbers in " << folder.string() << "/residuals.csv, coefficients.csv, orders.csv\n"
            << (not_drawn.empty() ? "diagrams beside them, -solutions and -convergence as .svg and .png\n"
                                  : "no diagrams: " + not_drawn + "\n");
  return exit_done;
}

}  // namespace app
