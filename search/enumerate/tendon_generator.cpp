#include "search/enumerate/tendon_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "search/enumerate/checked.hpp"

namespace reeve::search {

TendonGenerator::TendonGenerator(GeneratorOptions options) : options_(std::move(options)) {
  validate(options_.parts);
  if (options_.fingers < 1 || options_.fingers > max_fingers) {
    throw InputError({.what = fmt::format("fingers {}", options_.fingers),
                      .expected = fmt::format("a number from 1 to {}", max_fingers)});
  }
  const int n = options_.fingers;
  const TendonCounts tendons = tendon_counts(options_.parts, n, options_.identity);
  total_ = options_.one_tendon ? tendons.back() : tendon_sets(tendons, n, options_.identity).back();
  if (options_.identity == FingerIdentity::identical && !options_.one_tendon) {
    shapes_ = tendons;
    for (int largest = 0; largest <= n; ++largest) {
      sets_.push_back(tendon_sets(shapes_, largest, FingerIdentity::identical));
    }
  }
  tendons_.resize(static_cast<std::size_t>(n));
}

bool TendonGenerator::continues_last(int size) const {
  return depth_ > 0 && tendons_[depth_ - 1].fingers() == size;
}

void TendonGenerator::push(int largest) {
  ShapeCursor& tendon = tendons_[depth_];
  for (int size = largest; size > 0; --size) {
    if (continues_last(size)) {
      tendon = tendons_[depth_ - 1];
    } else if (!tendon.start(options_.parts, size)) {
      continue;
    }
    ++depth_;
    open_fingers_ -= size;
    return;
  }
}

void TendonGenerator::fill() {
  while (open_fingers_ > 0) {
    const int largest = depth_ == 0 ? open_fingers_ : tendons_[depth_ - 1].fingers();
    push(std::min(largest, open_fingers_));
  }
}

bool TendonGenerator::start_shapes() {
  depth_ = 0;
  open_fingers_ = options_.fingers;
  if (total_ == 0) return false;
  fill();
  return true;
}

bool TendonGenerator::advance_shapes() {
  while (depth_ > 0) {
    ShapeCursor& last = tendons_[depth_ - 1];
    const int size = last.fingers();
    bool moved = last.next(options_.parts);
    for (int smaller = size - 1; !moved && !options_.one_tendon && smaller > 0; --smaller) {
      moved = last.start(options_.parts, smaller);
    }
    open_fingers_ += moved ? size - last.fingers() : size;
    if (moved) {
      fill();
      return true;
    }
    --depth_;
  }
  return false;
}

void TendonGenerator::write(Routing& routing) const {
  routing.tendons.resize(depth_);
  for (std::size_t t = 0; t < depth_; ++t) routing.tendons[t] = tendons_[t].shape();
  number_in_order(routing);
}

bool TendonGenerator::next(Routing& routing) {
  const bool distinct = options_.identity == FingerIdentity::distinct;
  if (position_ == Position::behind_last) return false;
  if (position_ != Position::at_unread) {
    if (distinct && position_ == Position::at_read && numbering_.next(current_)) {
      routing = current_;
      return true;
    }
    const bool found = position_ == Position::before_first ? start_shapes() : advance_shapes();
    if (!found) {
      position_ = Position::behind_last;
      return false;
    }
    write(current_);
    if (distinct) numbering_.start(current_);
  }
  position_ = Position::at_read;
  routing = current_;
  return true;
}

// Routings that begin with the tendons in use, the last of them at `last`: from there on, each
// further tendon of its size is at its shape or a later one, and smaller ones follow.
std::uint64_t TendonGenerator::completions(const ShapeCursor& last) const {
  const auto size = static_cast<std::size_t>(last.fingers());
  const auto open = static_cast<std::size_t>(open_fingers_ - last.fingers());
  const std::uint64_t shapes = shapes_[size] - last.index();
  std::uint64_t sum = 0;
  for (std::size_t many = 0; many * size <= open; ++many) {
    sum = plus(sum, times(multichoose(shapes, many), sets_[size - 1][open - many * size]));
  }
  return sum;
}

// Tries to place the next tendon with `size` fingers; otherwise takes those routings off the index.
bool TendonGenerator::seek_size(int size, std::uint64_t& index) {
  ShapeCursor& tendon = tendons_[depth_];
  if (continues_last(size)) {
    tendon = tendons_[depth_ - 1];
  } else {
    const auto open = static_cast<std::size_t>(open_fingers_);
    const auto largest = static_cast<std::size_t>(size);
    const std::uint64_t here = sets_[largest][open] - sets_[largest - 1][open];
    if (index >= here) {
      index -= here;
      return false;
    }
    tendon.start(options_.parts, size);
  }
  do {
    check_.step();
    const std::uint64_t here = completions(tendon);
    if (index < here) {
      ++depth_;
      open_fingers_ -= size;
      return true;
    }
    index -= here;
  } while (tendon.next(options_.parts));
  return false;
}

void TendonGenerator::seek_by_subtrees(std::uint64_t index) {
  depth_ = 0;
  open_fingers_ = options_.fingers;
  while (open_fingers_ > 0) {
    int size =
        depth_ == 0 ? open_fingers_ : std::min(tendons_[depth_ - 1].fingers(), open_fingers_);
    while (!seek_size(size, index)) --size;
  }
  write(current_);
}

std::uint64_t TendonGenerator::numberings() const {
  if (options_.identity == FingerIdentity::identical) return 1;
  std::uint64_t symmetries_of_all = 1;
  std::uint64_t twins = 1;
  for (std::size_t t = 0; t < depth_; ++t) {
    const Tendon& tendon = tendons_[t].shape();
    twins = t > 0 && same_shape(tendons_[t - 1].shape(), tendon) ? twins + 1 : 1;
    symmetries_of_all =
        times(symmetries_of_all, times(twins, static_cast<std::uint64_t>(symmetries(tendon))));
  }
  return factorial(options_.fingers) / symmetries_of_all;
}

void TendonGenerator::seek_step_by_step(std::uint64_t index) {
  start_shapes();
  for (std::uint64_t here = numberings(); index >= here; here = numberings()) {
    index -= here;
    check_.step();
    advance_shapes();
  }
  write(current_);
  if (options_.identity == FingerIdentity::identical) return;
  numbering_.start(current_);
  for (; index > 0; --index) numbering_.next(current_);
}

void TendonGenerator::seek(std::uint64_t index) {
  if (index >= total_) {
    position_ = Position::behind_last;
    return;
  }
  if (options_.identity == FingerIdentity::identical && !options_.one_tendon) {
    seek_by_subtrees(index);
  } else {
    seek_step_by_step(index);
  }
  position_ = Position::at_unread;
}

}  // namespace reeve::search
