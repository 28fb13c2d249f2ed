#include "app/record/expectation.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "app/base/folder.h"
#include "app/base/output_file.h"
#include "app/base/text.h"
#include "render/compare.h"
#include "render/png.h"

namespace app {
namespace {

namespace fs = std::filesystem;

// "frame_00012.png" -> 12
std::optional<std::int64_t> frame_number(const std::string& name) {
  const std::string start = "frame_", end = ".png";
  if (!name.starts_with(start) || !name.ends_with(end) || name.size() <= start.size() + end.size()) return std::nullopt;
  const std::string digits = name.substr(start.size(), name.size() - start.size() - end.size());
  if (digits.find_first_not_of("0123456789") != std::string::npos || digits.size() > 12) return std::nullopt;
  return std::atoll(digits.c_str());
}

render::Image read_picture(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw std::runtime_error(path.string() + ": the expected frame cannot be read");
  try {
    return render::decode_png(bytes);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path.string() + ": the expected frame " + error.what());
  }
}

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

Expectation::Expectation(const Options& options, const RunFolder& folder)
    : stored_(options.expect), folder_(folder), tolerated_(options.expect_difference), share_(options.expect_share) {
  if (const std::string why = why_no_folder(stored_); !why.empty())
    throw std::runtime_error("--expect " + stored_.string() + ": " + why);
  if (fs::exists(folder_.frames()) && fs::equivalent(stored_, folder_.frames())) {
    throw std::runtime_error("--expect " + stored_.string() +
                             ": is where this run writes its own frames; compare with frames that are kept elsewhere");
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(stored_)) {
    if (!entry.is_regular_file()) continue;
    if (const auto number = frame_number(entry.path().filename().string())) results_[*number];
  }
  if (results_.empty()) {
    throw std::runtime_error("--expect " + stored_.string() + ": holds no frame_NNNNN.png to compare with");
  }
  const std::string first = RunFolder::frame_name(results_.begin()->first);
  const render::Image stored = read_picture(stored_ / first);
  if (stored.width != options.width || stored.height != options.height)
    throw std::runtime_error("--expect " + stored_.string() + ": " + first + " is " +
                             size_text(stored.width, stored.height) + ", and this run draws " +
                             size_text(options.width, options.height) + "; take --size " +
                             size_text(stored.width, stored.height));
}

void Expectation::compare(std::int64_t frame, const render::Image& drawn) {
  const auto found = results_.find(frame);
  if (found == results_.end()) return;
  Result& result = found->second;
  result.drawn = true;
  const render::Image stored = read_picture(stored_ / RunFolder::frame_name(frame));
  if (stored.width != drawn.width || stored.height != drawn.height) {
    result.share = 1;
    result.largest = 255;
    result.words =
        "is " + size_text(drawn.width, drawn.height) + ", the stored one " + size_text(stored.width, stored.height);
    return;
  }
  const render::Difference difference = render::compare(drawn, stored, tolerated_);
  result.largest = difference.largest;
  result.share = difference.share;
  result.equal = difference.share <= share_;
  if (result.equal) return;
  make_folder(folder_.differences());
  const fs::path picture = folder_.difference(frame);
  write_atomically(picture, as_text(render::encode_png(render::difference_picture(drawn, stored, tolerated_))), false);
  result.words = formatted("%.3g %% of the pixels differ by more than %d (allowed: %.3g %%), the most by %d; see ",
                           100 * difference.share, tolerated_, 100 * share_, difference.largest) +
                 picture.string();
}

void Expectation::write_table() const {
  std::string text = "frame,largest_difference,share,verdict\n";
  for (const auto& [frame, result] : results_) {
    const char* verdict = !result.drawn ? "not drawn" : result.equal ? "equal" : "differs";
    text += formatted("%lld,%d,%.6g,%s\n", static_cast<long long>(frame), result.largest, result.share, verdict);
  }
  write_atomically(folder_.expect_table(), text, false);
}

bool Expectation::fulfilled() const {
  for (const auto& [frame, result] : results_) {
    if (!result.equal) return false;
  }
  return true;
}

std::string Expectation::summary() const {
  std::size_t equal = 0;
  int largest = 0;
  std::string lines;
  for (const auto& [frame, result] : results_) {
    equal += result.equal ? 1 : 0;
    if (result.equal) largest = std::max(largest, result.largest);
    if (!result.drawn) lines += "\n  frame " + std::to_string(frame) + " was not drawn";
    if (!result.words.empty()) lines += "\n  frame " + std::to_string(frame) + " " + result.words;
  }
  const std::string known =
      equal == 0 ? "" : formatted(" (within them no channel differs by more than %d of 255)", largest);
  return std::to_string(equal) + " of " + std::to_string(results_.size()) + " frames are as in " + stored_.string() +
         known + lines;
}

}  // namespace app
