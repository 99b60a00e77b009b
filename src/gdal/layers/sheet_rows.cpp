#include "gdal/layers/sheet_rows.h"

namespace thiessen {

const std::deque<SheetRow>& SheetRows::ahead() {
  while (listener_->rows.empty() && reader_.read_on()) {
  }
  return listener_->rows;
}

const SheetRow* SheetRows::next() {
  if (ahead().empty()) return nullptr;
  SheetRow& front = listener_->rows.front();
  if (front.times > 1) {
    row_ = front;
    ++front.number;
    --front.times;
  } else {
    row_ = std::move(front);
    listener_->rows.pop_front();
  }
  return &row_;
}

}  // namespace thiessen
