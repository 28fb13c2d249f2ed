// JSON as far as the reference files need it: tests only, so malformed files throw.
#pragma once

#include <Eigen/Core>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace sim::test {

struct Json {
  double number = 0;
  std::string text;
  std::vector<Json> list;
  std::map<std::string, Json> table;

  const Json& operator[](const std::string& key) const { return table.at(key); }
  const Json& operator[](std::size_t k) const { return list.at(k); }
  // Rows of numbers.
  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd A(list.size(), list.at(0).list.size());
    for (Eigen::Index i = 0; i < A.rows(); ++i)
      for (Eigen::Index j = 0; j < A.cols(); ++j)
        A(i, j) = list[static_cast<std::size_t>(i)].list.at(static_cast<std::size_t>(j)).number;
    return A;
  }
  Eigen::VectorXd vector() const {
    Eigen::VectorXd v(static_cast<Eigen::Index>(list.size()));
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = list[static_cast<std::size_t>(i)].number;
    return v;
  }
};

class JsonReader {
 public:
  explicit JsonReader(std::string text) : text_(std::move(text)) {}
  Json read() {
    Json value;
    const char c = next();
    if (c == '{') {
      if (next() == '}') return value;
      --at_;
      do {
        const std::string key = read().text;
        next();  // the colon
        value.table[key] = read();
      } while (next() == ',');
    } else if (c == '[') {
      if (next() == ']') return value;
      --at_;
      do value.list.push_back(read());
      while (next() == ',');
    } else if (c == '"') {
      while (text_.at(at_) != '"') value.text += text_[at_++];
      ++at_;
    } else {
      const std::size_t end = text_.find_first_of(",]} \n", at_);
      const std::string word = text_.substr(at_ - 1, end - at_ + 1);
      at_ = end;
      if (std::isalpha(static_cast<unsigned char>(word[0])))
        value.text = word;  // null, true
      else
        value.number = std::stod(word);
    }
    return value;
  }

 private:
  char next() {
    while (std::isspace(static_cast<unsigned char>(text_.at(at_)))) ++at_;
    return text_[at_++];
  }
  std::string text_;
  std::size_t at_ = 0;
};

// A file of tests/data/lecture.
inline Json lecture_data(const std::string& name) {
  std::ifstream file(std::string(RITZ_SOURCE_DIR) + "/tests/data/lecture/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  if (text.str().empty()) throw std::runtime_error("no tests/data/lecture/" + name);
  return JsonReader(text.str()).read();
}

}  // namespace sim::test
