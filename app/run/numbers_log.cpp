#include "app/run/numbers_log.h"

namespace app {

void NumbersLog::add(const Moment& moment) {
  if (!moment.sheet) return;
  if (!table_) table_.emplace(folder_.numbers(), "frame,name,value,unit\n");
  for (const render::Number& number : render::numbers_of(*moment.sheet)) {
    table_->row(std::to_string(moment.frame) + "," + number.name + "," + number.text + "," + number.unit + "\n");
  }
}

void NumbersLog::close() {
  if (table_) table_->close();
}

}  // namespace app
