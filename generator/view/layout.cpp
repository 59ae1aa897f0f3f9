// The built-in layout of a chart.
#include "view/layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "diag/visible_text.hpp"
#include "text/utf8.hpp"

namespace symplant::view {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMostWithCare = 400;  // arrows
constexpr int kMargin = 14;
constexpr int kGap = 6;              // between labels, and between labels and states
constexpr double kEveryLength = 34;  // of an arrow from every other state
constexpr int kInitialMark = 24;     // above a box, at its left

struct Vector {
  double x = 0;
  double y = 0;
};
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(Vector a, double factor) { return {a.x * factor, a.y * factor}; }
double length(Vector a) { return std::hypot(a.x, a.y); }
Point rounded(Vector a) { return {static_cast<int>(std::lround(a.x)), static_cast<int>(std::lround(a.y))}; }

/// By its middle and its half extents.
struct Box {
  Vector middle;
  double half_width = 0;
  double half_height = 0;
};
double overlap(const Box& a, const Box& b) {
  const double x = a.half_width + b.half_width + kGap - std::abs(a.middle.x - b.middle.x);
  const double y = a.half_height + b.half_height + kGap - std::abs(a.middle.y - b.middle.y);
  return x > 0 && y > 0 ? x * y : 0;
}
bool inside(const Box& box, Vector point) {
  return std::abs(point.x - box.middle.x) <= box.half_width && std::abs(point.y - box.middle.y) <= box.half_height;
}

struct Curve {
  Vector begin;
  Vector control;
  Vector end;

  Vector at(double t) const { return begin * ((1 - t) * (1 - t)) + control * (2 * t * (1 - t)) + end * (t * t); }
  /// The part between two parameters.
  Curve part(double from, double to) const {
    const Vector blossom =
        begin * ((1 - from) * (1 - to)) + control * ((1 - from) * to + from * (1 - to)) + end * (from * to);
    return {at(from), blossom, at(to)};
  }
};

/// From the edge of one box to the edge of another, bent to the left of its direction.
Curve between(const Box& from, const Box& to, double bend) {
  const Vector transition = to.middle - from.middle;
  const Vector side{transition.y, -transition.x};
  const Vector control = (from.middle + to.middle) * 0.5 + side * (bend / std::max(1.0, length(transition)));
  const Curve whole{from.middle, control, to.middle};
  constexpr int kSteps = 256;
  int first = 0;
  int last = kSteps;
  while (first < kSteps && inside(from, whole.at(static_cast<double>(first) / kSteps))) ++first;
  while (last > first && inside(to, whole.at(static_cast<double>(last) / kSteps))) --last;
  return whole.part(static_cast<double>(first) / kSteps, static_cast<double>(last + 1) / kSteps);
}

class Placer {
 public:
  Placer(const LayoutKey& key, double spread) : key_(key), spread_(spread) {
    box_width_ = static_cast<int>(key.columns) * kLetterWidth + 24;
    box_height_ = 2 * kLineHeight + 12;
    place_states();
    place_arrows();
  }

  double overlapping() const { return overlapping_; }

  Layout result() const {
    Vector least{1e9, 1e9};
    Vector most{-1e9, -1e9};
    const auto grow = [&](Vector point) {
      least = {std::min(least.x, point.x), std::min(least.y, point.y)};
      most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    };
    const auto grow_box = [&](const Box& box) {
      grow(box.middle - Vector{box.half_width, box.half_height});
      grow(box.middle + Vector{box.half_width, box.half_height});
    };
    for (const Box& box : boxes_) {
      grow_box(box);
      grow(box.middle - Vector{box.half_width, box.half_height + kInitialMark});
    }
    for (const Box& label : labels_) grow_box(label);
    for (const Curve& curve : curves_) {
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) grow(curve.at(t));
    }
    const Vector shift = Vector{kMargin, kMargin} - least;
    Layout layout;
    const Point extent = rounded(most - least + Vector{2 * kMargin, 2 * kMargin});
    layout.width = extent.x;
    layout.height = extent.y;
    layout.box_width = box_width_;
    layout.box_height = box_height_;
    for (const Box& box : boxes_) layout.states.push_back(rounded(box.middle + shift));
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const Curve& curve = curves_[i];
      layout.arrows.push_back({rounded(curve.begin + shift), rounded(curve.control + shift), rounded(curve.end + shift),
                               rounded(labels_[i].middle + shift)});
    }
    return layout;
  }

 private:
  Vector direction(std::size_t state) const {
    const double angle = 2 * kPi * static_cast<double>(state) / static_cast<double>(key_.states) - kPi / 2;
    return {std::cos(angle), std::sin(angle)};
  }

  void place_states() {
    const double half_width = box_width_ / 2.0;
    const double half_height = box_height_ / 2.0;
    if (key_.states == 2) {
      double widest = 60;
      for (const LayoutKey::Arrow& arrow : key_.arrows) widest = std::max(widest, 1.0 * arrow.columns * kLetterWidth);
      const double distance = (box_width_ + widest + 60) * std::sqrt(spread_);
      boxes_ = {{{0, 0}, half_width, half_height}, {{distance, 0}, half_width, half_height}};
      return;
    }
    // Wide enough that adjacent boxes do not touch, even at the same height.
    const double chord = key_.states > 1 ? std::sin(kPi / key_.states) * 2 : 1;
    const double radius = key_.states > 1 ? std::max(100.0, (box_height_ + 40) / chord) * spread_ : 0;
    const double wide = std::max(radius * 1.3, key_.states > 1 ? (box_width_ * 0.75 + 30) / chord * spread_ : 0);
    for (std::size_t s = 0; s < key_.states; ++s) {
      const Vector to = direction(s);
      boxes_.push_back({{to.x * wide, to.y * radius}, half_width, half_height});
    }
  }

  Box label_box(const LayoutKey::Arrow& arrow, Vector middle) const {
    return {middle, arrow.columns * kLetterWidth / 2.0 + 2, arrow.lines * kLineHeight / 2.0};
  }

  void place_arrows() {
    curves_.resize(key_.arrows.size());
    labels_.resize(key_.arrows.size());
    for (std::size_t i = 0; i < key_.arrows.size(); ++i) {
      if (key_.arrows[i].from == kEveryOther) place_outside(i);
    }
    for (std::size_t i = 0; i < key_.arrows.size(); ++i) {
      if (key_.arrows[i].from != kEveryOther) place_between(i);
    }
  }

  /// Places an arrow from outside the ellipse, its label at the outer end.
  void place_outside(std::size_t i) {
    const LayoutKey::Arrow& arrow = key_.arrows[i];
    const Box& box = boxes_[arrow.to];
    const Vector out = direction(arrow.to);
    double reach = 0;
    while (inside(box, box.middle + out * reach)) reach += 1;
    const Vector end = box.middle + out * reach;
    const Vector begin = box.middle + out * (reach + kEveryLength);
    curves_[i] = {begin, (begin + end) * 0.5, end};
    Box label = label_box(arrow, begin);
    label.middle = begin + Vector{out.x * (label.half_width + kGap), out.y * (label.half_height + kGap)};
    labels_[i] = label;
    note(label);
  }

  bool goes_back(const LayoutKey::Arrow& arrow) const {
    return std::any_of(key_.arrows.begin(), key_.arrows.end(),
                       [&](const LayoutKey::Arrow& other) { return other.from == arrow.to && other.to == arrow.from; });
  }

  void place_between(std::size_t i) {
    const LayoutKey::Arrow& arrow = key_.arrows[i];
    const Box& from = boxes_[arrow.from];
    const Box& to = boxes_[arrow.to];
    const double distance = length(to.middle - from.middle);
    const bool careful = key_.arrows.size() <= kMostWithCare;
    const double bend = key_.states == 2              ? 44 + arrow.lines * kLineHeight
                        : careful && goes_back(arrow) ? std::max(36.0, distance * 0.3)
                                                      : distance * 0.12;
    const Curve curve = between(from, to, bend);
    curves_[i] = curve;
    labels_[i] = label_box(arrow, curve.at(0.5));
    if (!careful) return;
    double least = -1;
    for (const double t : {0.5, 0.42, 0.58, 0.34, 0.66, 0.27, 0.73}) {
      const Box label = label_box(arrow, curve.at(t));
      const double covered = covering(label);
      if (least >= 0 && covered >= least) continue;
      least = covered;
      labels_[i] = label;
    }
    note(labels_[i]);
  }

  double covering(const Box& label) const {
    double area = 0;
    for (const Box& box : boxes_) area += overlap(label, box);
    for (const Box& other : placed_) area += overlap(label, other);
    return area;
  }

  void note(const Box& label) {
    overlapping_ += covering(label);
    placed_.push_back(label);
  }

  const LayoutKey& key_;
  const double spread_;
  int box_width_ = 0;
  int box_height_ = 0;
  std::vector<Box> boxes_;
  std::vector<Box> placed_;  // labels so far
  std::vector<Curve> curves_;
  std::vector<Box> labels_;
  double overlapping_ = 0;
};

std::uint32_t rounded_up(std::uint32_t columns) { return (columns + 3) / 4 * 4; }

}  // namespace

std::uint32_t columns(const std::string& as_it_is) {
  const std::string text = diag::visible(as_it_is);
  std::uint32_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    width += static_cast<std::uint32_t>(diag::display_width(point.value));
    at += point.length;
  }
  return width;
}

LayoutKey layout_key(const Chart& chart) {
  LayoutKey key;
  key.states = static_cast<std::uint32_t>(chart.states.size());
  for (const ChartState& state : chart.states) {
    key.columns = std::max({key.columns, columns(state.name), columns(state.symbols)});
  }
  key.columns = rounded_up(key.columns);
  for (const ChartEdge& edge : chart.edges) {
    std::uint32_t widest = 0;
    for (const std::string& line : edge.label) widest = std::max(widest, columns(line));
    key.arrows.push_back({edge.from, edge.to, static_cast<std::uint32_t>(edge.label.size()), rounded_up(widest)});
  }
  return key;
}

Layout lay_out(const LayoutKey& key) {
  constexpr int kMostTries = 14;
  double spread = 1;
  for (int tries = 1;; ++tries) {
    const Placer placer(key, spread);
    if (placer.overlapping() == 0 || tries == kMostTries || key.arrows.size() > kMostWithCare) return placer.result();
    spread *= 1.15;
  }
}

}  // namespace symplant::view
