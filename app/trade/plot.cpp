#include "app/trade/plot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/number_text.h"
#include "app/trade/advice.h"

namespace app {
namespace {

struct Dot {
  double seconds = 0, error = 0;
  std::string label;
};

// A name for a block of data, and its points.
struct Series {
  std::string title, style;
  std::vector<Dot> dots;
};

double shown_error(const Score& score) {
  if (score.total) return score.total->rms;
  if (score.time) return score.time->rms;
  return score.model ? score.model->rms : 0;
}

bool is_failure(const Score& score) {
  return score.run->status == Status::failed || (score.run->status == Status::done && !(shown_error(score) < 1));
}

bool is_shown(const Score& score, double uncertainty) {
  return score.run->status == Status::done && score.run->which.axis != Axis::reference && !is_failure(score) &&
         shown_error(score) > uncertainty && shown_error(score) > 0;
}

std::string series_name(const Score& score) {
  const Case& which = score.run->which;
  if (which.axis == Axis::time) return which.settings.front().second;
  return which.axis == Axis::mesh    ? "other meshes"
         : which.axis == Axis::scene ? "the scene as it is"
                                     : "other settings";
}

std::vector<Series> series_of(const Diagram& diagram) {
  std::map<std::string, std::vector<Dot>> lines;
  Series failures{"failures", "points pt 2 lc rgb '#c0392b'", {}}, front{"front", "lines lw 6 lc rgb '#55ddaa33'", {}};
  for (const Score* score : diagram.scores) {
    const Dot dot{score->seconds(), shown_error(*score), score->run->which.label};
    if (is_failure(*score) && score->seconds() > 0)
      failures.dots.push_back({dot.seconds, 1, dot.label});
    else if (is_shown(*score, diagram.uncertainty))
      lines[series_name(*score)].push_back(dot);
  }
  for (const Score* score : front_of(diagram.scores))
    if (is_shown(*score, diagram.uncertainty))
      front.dots.push_back({score->seconds(), shown_error(*score), score->run->which.label});
  std::vector<Series> all = {front};
  int number = 0;
  for (auto& [name, dots] : lines) {
    std::ranges::sort(dots, {}, &Dot::seconds);
    const bool line = name.find(' ') == std::string::npos;
    all.push_back({name, std::string(line ? "linespoints" : "points") + " lw 1.5 ps 0.8 lt " + std::to_string(++number),
                   std::move(dots)});
  }
  all.push_back(failures);
  return all;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result.append(c == '\'' ? 2 : 1, c);
  return result;
}

std::string data_block(const std::string& name, const Series& series) {
  std::string text = name + " << EOD\n";
  for (const Dot& dot : series.dots) {
    append_number(text, dot.seconds);
    text += ' ';
    append_number(text, dot.error);
    text += " # " + dot.label + '\n';
  }
  return text + "EOD\n";
}

}  // namespace

std::string plot_script(const std::vector<Diagram>& diagrams, const std::filesystem::path& base) {
  std::string data, plot, title;
  int block = 0;
  for (const Diagram& diagram : diagrams) {
    title += (title.empty() ? "" : " / ") + diagram.name;
    for (const Series& series : series_of(diagram)) {
      if (series.dots.empty()) continue;
      const std::string name = "$data" + std::to_string(++block);
      data += data_block(name, series);
      const std::string prefix = diagrams.size() > 1 ? diagram.name + ": " : "";
      plot += std::string(plot.empty() ? "" : ", \\\n  ") + name + " using 1:2 with " + series.style + " title '" +
              escaped(prefix + series.title) + "'";
    }
  }
  if (plot.empty()) return "# nothing was measured that could be drawn\n";
  const std::string settings =
      "set logscale xy\nset format y '10^{%T}'\nset xlabel 'wall time per simulated second [s]'\n"
      "set ylabel 'error [body size, rms]'\nset grid\nset key outside right noenhanced\nset title '" +
      escaped(title) + "' noenhanced\nset pointsize 0.8\n";
  const auto picture = [&](const std::string& terminal, const std::string& extension) {
    return "set terminal " + terminal + "\nset output '" + escaped(base.string() + extension) + "'\nplot " + plot +
           "\n";
  };
  return data + settings + picture("svg size 900,560 font 'sans,13' background 'white'", ".svg") +
         picture("pngcairo size 1350,840 font 'sans,14'", ".png");
}

bool run_gnuplot(const std::filesystem::path& script) {
  std::string program = "gnuplot", file = script.string();
  char* const arguments[] = {program.data(), file.data(), nullptr};
  pid_t process = 0;
  if (posix_spawnp(&process, "gnuplot", nullptr, nullptr, arguments, environ) != 0) return false;
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace app
