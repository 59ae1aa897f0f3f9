// Reads all symbols of a PLC.
#include "symplant/link/record/image_reader.hpp"

#include <algorithm>

#include "symplant/link/image/numbers.hpp"
#include "symplant/link/image/words.hpp"

namespace symplant::link::record {

ImageReader::ImageReader(client::Dialog& dialog, const tables::PlantTables& tables, const image::Map& map)
    : dialog_(dialog),
      tables_(tables),
      map_(map),
      sides_{Side{Plane::operation_bits, Plane::operation_numbers, {}},
             Side{Plane::event_bits, Plane::event_numbers, {}}} {
  for (Side& side : sides_) {
    side.bits.resize(image::bit_words(map.size(side.bits_plane)));
    side.numbers.resize(map.size(side.numbers_plane));
    side.marked_bits.resize(side.bits.size());
    side.marked_numbers.resize(side.numbers.size());
  }
  readings_.reserve(map.points.size());
  for (std::uint32_t i = 0; i < map.points.size(); ++i) {
    sides_[is_event(map.points[i].plane) ? 1 : 0].points.push_back(i);
    readings_.push_back({map.points[i].symbol});
  }
}

client::Fault ImageReader::read(tables::Time now) {
  for (Reading& reading : readings_) reading.is_read = false;
  first_sent_ = last_answered_ = 0;
  client::Fault fault;
  for (Side& side : sides_) {
    side_ = &side;
    dialog_.observe(this);
    fault = &side == sides_.data() ? dialog_.read(side.words(), now) : dialog_.read_back(side.words(), now);
    dialog_.observe(nullptr);
    if (fault && fault.kind != client::Fault::Kind::rejected) return fault;
  }
  return {};
}

void ImageReader::answered(tables::Time sent, tables::Time answered) {
  if (first_sent_ == 0) first_sent_ = sent;
  last_answered_ = answered;
  const tables::Time middle = sent + (answered - sent) / 2;
  for (const std::uint32_t i : side_->points) {
    const image::Point& point = map_.points[i];
    Reading& reading = readings_[i];
    if (has_bits(point.plane)) {
      if (!image::get_bit(side_->marked_bits, point.position)) continue;
      reading.value = image::get_bit(side_->bits, point.position) ? 1 : 0;
    } else {
      if (side_->marked_numbers[point.position] == 0) continue;  // all registers of a number are in one request
      reading.value = image::value_of(side_->numbers[point.position], tables_.symbols[point.symbol].type());
    }
    reading.time = middle;
    reading.is_read = true;
  }
  std::fill(side_->marked_bits.begin(), side_->marked_bits.end(), 0);
  std::fill(side_->marked_numbers.begin(), side_->marked_numbers.end(), 0);
}

}  // namespace symplant::link::record
