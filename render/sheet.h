// What a page of a lecture shows beside, or instead of, the bodies: diagrams, blocks of numbers, a formula, and the one
// number that proves the page. Plain data; lengths on the page are shares of the frame's width and height, y downwards.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace render {

// Colours that can be read on paper and by a washed-out projector: see ink_colour.
enum class Ink { black, blue, red, purple };
// sRGB, 0 to 255. Blended 40 % towards white, each still has a contrast of 4.5 to paper.
std::array<int, 3> ink_colour(Ink ink);

// A number that is shown, as it is printed; its name says what it is in a table of all numbers.
struct Number {
  std::string name = {}, text = {}, unit = {};
};

// In the coordinates of a diagram.
using Spot = std::array<double, 2>;

struct Stroke {
  std::vector<Spot> points = {};
  Ink ink = Ink::black;
  bool closed = false, dashed = false;
  float width = 1;  // times a line's
};
// A filled polygon without inlets.
struct Patch {
  std::vector<Spot> points = {};
  std::array<int, 3> colour{225, 231, 242};
};
struct Dart {
  Spot from = {}, to = {};
  Ink ink = Ink::black;
};
struct Dot {
  Spot at = {};
  Ink ink = Ink::black;
  bool ring = false;  // it can be dragged
};
enum class Side { left, right, above, below, middle };
struct Word {
  Spot at = {};
  std::string text = {};
  Ink ink = Ink::black;
  Side side = Side::right;  // of the spot
};

struct Box {
  double left = 0, top = 0, right = 1, bottom = 1;
};

struct Tick {
  double at = 0;
  std::string label = {};
};

// A plot, or a drawing to scale. What lies beyond its place is not drawn; words are moved inside.
struct Diagram {
  Box place = {};                          // on the page
  std::string title = {};                  // above it
  std::array<double, 2> x{0, 1}, y{0, 1};  // what is shown; y upwards
  bool equal = false;                      // the same scale along both; more is shown along one of them
  bool axes = false;                       // with ticks and numbers
  bool logarithmic = false;                // y holds powers of ten: ticks say 10^y
  std::string x_label = {}, y_label = {};
  std::vector<Tick> x_ticks = {};   // where there are none: round numbers
  std::vector<Patch> patches = {};  // in the order of their drawing
  std::vector<Stroke> strokes = {};
  std::vector<Dart> darts = {};
  std::vector<Dot> dots = {};
  std::vector<Word> words = {};
};

// "E   1.000e+05 Pa"
struct Line {
  std::string label = {};
  Number number = {};
  Ink ink = Ink::black;
};
// "F = [ 1.200 -0.333 ; 0.150 1.150 ]", brackets drawn.
struct Matrix {
  std::string label = {};
  int columns = 2;
  std::vector<Number> entries = {};  // row by row
  std::string unit = {};
};
// Rows of numbers under a head; `boxed`: the entries (row, column) that are framed.
struct Table {
  std::vector<std::string> head = {};  // of every column, the labels' first
  struct Row {
    std::string label = {};
    std::vector<Number> numbers = {};
    Ink ink = Ink::black;
  };
  std::vector<Row> rows = {};
  std::vector<std::array<int, 2>> boxed = {};
};
struct Block {
  std::string title = {};
  std::vector<std::variant<Line, Matrix, Table>> items = {};
};

struct Sheet {
  bool bodies = true;                   // the bodies are drawn, in `picture`
  Box picture{0.01, 0.10, 0.64, 0.86};  // where they are
  std::vector<Diagram> diagrams = {};
  double column = 0.66;            // left edge of the blocks
  std::vector<Block> blocks = {};  // three at most
  std::string formula = {};        // below, in Unicode
  std::string proof_label = {};    // "|F Dm - Ds| ="
  Number proof = {};               // in a box; none where the text is empty
};

// Every number of the sheet, in the order in which they are read.
std::vector<Number> numbers_of(const Sheet& sheet);

// The side that letters and margins are in proportion to: the height; of a page that is narrower than 16:9, what its
// height would be at that width, so that nothing overlaps there either.
double measure_of(double width, double height);

// The part of a page of width x height pixels that the ranges of a diagram fill, in pixels.
Box area_of(const Diagram& diagram, double width, double height);

// Where a spot of a diagram is on a page of width x height pixels, and the spot that is there.
Spot to_page(const Diagram& diagram, const Spot& spot, double width, double height);
Spot from_page(const Diagram& diagram, const Spot& pixel, double width, double height);

}  // namespace render
