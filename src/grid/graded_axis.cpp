#include "scree/grid/graded_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scree {
namespace {

using Span = GradedAxis::Span;

struct Plane {
  double at;    ///< [m]
  double size;  ///< h there [m]
  bool fine;
};

/// The least and the greatest number of cells in a span, as real numbers.
struct Numbers {
  double least, most;
};

/// Rounding of a number of cells.
double rounding(double number) { return 1e-9 * (1 + number); }

double least_whole(const Numbers& numbers) { return std::max(1.0, std::ceil(numbers.least - rounding(numbers.least))); }

bool has_whole(const Numbers& numbers) { return least_whole(numbers) <= numbers.most + rounding(numbers.most); }

/// The last of [works, fails] at which `condition` holds, which it does at `works`.
template <class Condition>
double last(double works, double fails, const Condition& condition) {
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (works + fails);
    (condition(middle) ? works : fails) = middle;
  }
  return works;
}

double length(const Span& span) { return span.upper - span.lower; }

/// From one end of a span to its level: the length, and the cells in it. A flat part belongs to what rises.
struct Ramp {
  double length, number;
};

Ramp ramp(const Span& span, int end, double level, double slope) {
  const double size = span.size[end], flat = level >= size ? span.flat[end] : 0;
  return {flat + std::abs(level - size) / slope, flat / size + std::abs(std::log(level / size)) / slope};
}

/// The integral of dx/h. Sums of the two ends come first: a mirrored span has the same bits.
double number_at(const Span& span, double level, double slope) {
  const Ramp a = ramp(span, 0, level, slope), b = ramp(span, 1, level, slope);
  return (a.number + b.number) + std::max(0.0, length(span) - (a.length + b.length)) / level;
}

/// Distance from an end of the span within which there are `number` cells.
double distance(const Span& span, int end, double number, double slope) {
  struct Piece {
    double from, to, length;
  };
  const double size = span.size[end], other = span.size[1 - end], level = span.level;
  const Ramp here = ramp(span, end, level, slope), there = ramp(span, 1 - end, level, slope);
  const double flat = level >= size ? span.flat[end] : 0, last_flat = level >= other ? span.flat[1 - end] : 0;
  const Piece pieces[] = {{size, size, flat},
                          {size, level, here.length - flat},
                          {level, level, std::max(0.0, length(span) - (here.length + there.length))},
                          {level, other, there.length - last_flat},
                          {other, other, last_flat}};
  double at = 0;
  for (const Piece& piece : pieces) {
    const double rate = piece.to > piece.from ? slope : -slope;
    const bool even = piece.to == piece.from;
    const double cells = even ? piece.length / piece.from : std::log(piece.to / piece.from) / rate;
    if (number <= cells) return at + (even ? number * piece.from : piece.from * std::expm1(rate * number) / rate);
    at += piece.length;
    number -= cells;
  }
  return at;
}

/// The planes with the sizes at them, and what they leave for the spans in between.
class Grading {
 public:
  explicit Grading(const CellSizes& wanted)
      : wanted_(wanted), slope_(std::log(wanted.growth)), least_((1 - finest_slack) * wanted.finest) {
    wanted_.coarsest = std::max(wanted.finest, std::min(wanted.coarsest, wanted.upper - wanted.lower));
    place_planes();
    tie_ends();
    spread_small();
    for (int k = 0; k < most_rounds && make_smaller(); ++k) spread_small();
    for (int k = 0; k < most_rounds && make_greater(); ++k) spread_great();
  }

  std::vector<Span> spans() const {
    std::vector<Span> spans;
    for (std::size_t i = 0; i + 1 < planes_.size(); ++i) {
      spans.push_back(with_level(span_of(i, 0, wanted_.coarsest)));
      if (spans.back().number == 0) throw GradingError(spans.back().lower, spans.back().upper);
    }
    return spans;
  }

 private:
  static constexpr int most_rounds = 1000;

  void place_planes() {
    std::vector<double> inside;
    const double close = same_plane * wanted_.finest;
    for (const std::vector<double>* list : {&wanted_.planes, &wanted_.fine})
      for (const double x : *list)
        if (x > wanted_.lower + close && x < wanted_.upper - close) inside.push_back(x);
    std::sort(inside.begin(), inside.end());
    planes_.push_back({wanted_.lower, wanted_.coarsest, false});
    for (const double x : inside) {
      Plane& before = planes_.back();
      if (x - before.at > close)
        planes_.push_back({x, wanted_.coarsest, false});
      else if (std::abs(x) < std::abs(before.at))  // of two that differ by rounding, alike on both sides of 0
        before.at = x;
    }
    planes_.push_back({wanted_.upper, wanted_.coarsest, false});
    for (const double x : wanted_.fine)
      for (Plane& plane : planes_)
        if (std::abs(plane.at - x) <= 2 * close) plane = {plane.at, wanted_.finest, true};
  }

  /// The ends of a periodic axis are one plane.
  void tie_ends() {
    if (!wanted_.periodic) return;
    Plane &first = planes_.front(), &end = planes_.back();
    first.fine = end.fine = first.fine || end.fine;
    if (first.fine) first.size = end.size = wanted_.finest;
  }

  /// Length beside a plane over which h stays.
  double flat(bool fine, double size) const { return fine && size <= wanted_.finest ? wanted_.finest : 0; }

  /// h(x) grows by its slope at most, beginning behind the flat part.
  void spread_small() {
    spread([&](const Plane& from, Plane& to) {
      const double way = std::abs(to.at - from.at) - flat(from.fine, from.size);
      to.size = std::min(to.size, from.size + slope_ * std::max(0.0, way));
    });
  }

  void spread_great() {
    spread([&](const Plane& from, Plane& to) {
      to.size = std::max(to.size, from.size - slope_ * std::abs(to.at - from.at));
    });
  }

  /// From each plane to the next, up and down; round a periodic axis twice.
  template <class Pass>
  void spread(const Pass& pass) {
    for (int round = 0; round < (wanted_.periodic ? 2 : 1); ++round) {
      for (std::size_t i = 1; i < planes_.size(); ++i) pass(planes_[i - 1], planes_[i]);
      if (wanted_.periodic) pass({planes_.front().at, planes_.back().size, planes_.back().fine}, planes_.front());
      for (std::size_t i = planes_.size() - 1; i > 0; --i) pass(planes_[i], planes_[i - 1]);
      if (wanted_.periodic) pass({planes_.back().at, planes_.front().size, planes_.front().fine}, planes_.back());
    }
  }

  /// The span above plane i, with the sizes at its ends brought into [lower, upper].
  Span span_of(std::size_t i, double lower, double upper) const {
    Span span{planes_[i].at, planes_[i + 1].at, {}, {}};
    for (std::size_t end : {0, 1}) {
      const Plane& plane = planes_[i + end];
      span.size[end] = std::min(std::max(plane.size, lower), upper);
      span.flat[end] = flat(plane.fine, span.size[end]);
    }
    const double room = std::max(0.0, length(span) - std::abs(span.size[1] - span.size[0]) / slope_);
    const double flats = span.flat[0] + span.flat[1];
    if (flats > room)
      for (double& one : span.flat) one *= room / flats;
    return span;
  }

  double lowest(const Span& span) const {
    const double trough = 0.5 * ((span.size[0] + span.size[1]) - slope_ * length(span));
    return std::min({span.size[0], span.size[1], std::max(least_, trough)});
  }

  double highest(const Span& span) const {
    const double way = length(span) - (span.flat[0] + span.flat[1]);
    const double peak = 0.5 * ((span.size[0] + span.size[1]) + slope_ * way);
    return std::max({span.size[0], span.size[1], std::min(wanted_.coarsest, peak)});
  }

  /// With its number of cells, the smallest that there is, and the level that gives it; 0 cells where none fits.
  Span with_level(Span span) const {
    const Numbers numbers = numbers_of(span);
    if (!has_whole(numbers)) return span;
    span.number = least_whole(numbers);
    const auto enough = [&](double level) { return number_at(span, level, slope_) >= span.number; };
    span.level = last(lowest(span), highest(span), enough);
    return span;
  }

  Numbers numbers_of(const Span& span) const {
    return {number_at(span, highest(span), slope_), number_at(span, lowest(span), slope_)};
  }

  /// Where a whole number of cells would need h to dip between two planes, it becomes smaller at these; not below
  /// `finest`. Returns whether a size has changed. All spans are asked before: so symmetry stays.
  bool make_smaller() {
    const std::vector<Plane> before = planes_;
    std::vector<Plane> after = planes_;
    bool changed = false;
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
      const double greater = std::max(before[i].size, before[i + 1].size);
      const double wanted = least_whole(numbers_of(span_of(i, 0, wanted_.coarsest)));
      const auto fits = [&](double size) { return number_at(span_of(i, 0, size), size, slope_) >= wanted; };
      if (fits(greater * (1 - 1e-9)) || !fits(wanted_.finest)) continue;
      const double size = last(wanted_.finest, greater, fits);
      for (std::size_t end : {i, i + 1}) after[end].size = std::min(after[end].size, size);
      changed = true;
    }
    planes_ = after;
    return changed;
  }

  /// Sizes at the ends of spans without a whole number of cells, made greater for the next smaller one. Throws
  /// GradingError where there is none.
  bool make_greater() {
    const std::vector<Plane> before = planes_;
    std::vector<Plane> after = planes_;
    bool changed = false;
    for (std::size_t i = 0; i + 1 < before.size(); ++i) {
      const Numbers numbers = numbers_of(span_of(i, 0, wanted_.coarsest));
      if (has_whole(numbers)) continue;
      const double wanted = std::floor(numbers.most + rounding(numbers.most));
      const auto fits = [&](double size) {
        return numbers_of(span_of(i, size, wanted_.coarsest)).least <= wanted + rounding(wanted);
      };
      if (wanted < 1 || !fits(wanted_.coarsest)) throw GradingError(before[i].at, before[i + 1].at);
      const double size = last(wanted_.coarsest, std::min(before[i].size, before[i + 1].size), fits);
      for (std::size_t end : {i, i + 1}) after[end].size = std::max(after[end].size, size);
      changed = true;
    }
    planes_ = after;
    return changed;
  }

  CellSizes wanted_;  ///< with a coarsest that is no longer than the axis
  double slope_, least_;
  std::vector<Plane> planes_;
};

}  // namespace

GradingError::GradingError(double lower_, double upper_)
    : std::runtime_error("no cells of the wanted sizes fit between two planes"), lower(lower_), upper(upper_) {}

GradedAxis::GradedAxis(const CellSizes& wanted) : slope_(std::log(wanted.growth)), spans_(Grading(wanted).spans()) {}

double GradedAxis::cells() const {
  return std::accumulate(spans_.begin(), spans_.end(), 0.0,
                         [](double sum, const Span& span) { return sum + span.number; });
}

std::vector<double> GradedAxis::faces(int refine) const {
  std::vector<double> faces{spans_.front().lower};
  for (const Span& span : spans_) {
    const int number = static_cast<int>(span.number) * refine;
    const auto from = [&](int end, int cells) {
      const double part = distance(span, end, static_cast<double>(cells) / refine, slope_);
      return end == 0 ? span.lower + part : span.upper - part;
    };
    for (int i = 1; i < number; ++i) {
      if (2 * i == number)
        faces.push_back(0.5 * (from(0, i) + from(1, i)));
      else
        faces.push_back(2 * i < number ? from(0, i) : from(1, number - i));
    }
    faces.push_back(span.upper);
  }
  return faces;
}

}  // namespace scree
