// What the diagram of a trade shows, as numbers: errors over what computing takes, both logarithmic.
#pragma once

#include <string>
#include <vector>

#include "app/trade/goal.h"
#include "app/trade/ink.h"
#include "app/trade/score.h"

namespace app {

// What is drawn of one trade.
struct Diagram {
  std::string name;  // of the scene, or of its settings
  Goal goal;
  std::vector<const Score*> scores;
  double uncertainty = 0;          // of time errors
  double total_uncertainty = 0;    // of total errors; 0: none are known
  const Score* advised = nullptr;  // marked
  const Score* found = nullptr;    // the run that checked it
};

// Which error a chart shows.
enum class ErrorShown { time, total };

struct Dot {
  double seconds = 0;  // of computing for a simulated second
  double error = 0;    // %
  std::string label;   // beside it: its step, or what it is
  std::string of;      // the case
  bool below = false;  // on the edge of what cannot be told: its error is smaller
};

struct Line {
  std::string title;
  Ink ink;
  bool joined = true;  // else points alone
  double size = 1;     // of the points
  std::vector<Dot> dots;
};

// A failure: where it is marked at the upper margin, and what it was.
struct Failure {
  double seconds = 0;
  std::string text;
};

struct AxisRange {
  double low = 0, high = 0;
  bool holds(double x) const { return low <= x && x <= high; }
};

struct Chart {
  std::string title, error_name;
  std::vector<Line> lines;  // those in front last; the scene as it is, advice and its check among them
  std::vector<Dot> front;
  std::vector<Failure> failures;
  std::string advice;  // the settings that are advised
  AxisRange seconds, error;
  double floor = 0;               // %: below it nothing can be told
  double pixels = 0;              // for each percent, about
  double target = 0, budget = 0;  // %, s; 0: none
};

Chart make_chart(const Diagram& diagram, ErrorShown shown);
// The fronts of several scenes.
Chart make_chart(const std::vector<Diagram>& diagrams, ErrorShown shown);

// Whether any error of this kind is known.
bool has_errors(const Diagram& diagram, ErrorShown shown);

}  // namespace app
