#include "search/limits/limited_tendons.hpp"

#include <algorithm>
#include <numeric>

#include "core/canonical.hpp"
#include "search/enumerate/checked.hpp"
#include "search/enumerate/counting.hpp"
#include "search/enumerate/numbering.hpp"
#include "search/limits/class_counts.hpp"

namespace reeve::search {

LimitedTendons::LimitedTendons(const PartClasses& classes, const PartSet& parts, int fingers,
                               bool one_tendon, std::uint64_t longest_list)
    : classes_(classes),
      parts_(parts),
      one_tendon_(one_tendon),
      shapes_(tendon_counts(parts, fingers, FingerIdentity::identical)),
      shape_counts_(shape_counts(classes, parts, fingers)),
      set_counts_(shape_sets(
          classes, one_tendon ? std::vector<ClassCounts>{shape_counts_.front()} : shape_counts_)),
      listed_(classes, parts, shapes_, longest_list) {
  for (ClassCounts& counts : shape_counts_) counts = of_trees(classes, counts);
  for (int largest = 0; largest <= (one_tendon ? 0 : fingers); ++largest) {
    sets_.push_back(tendon_sets(shapes_, largest, FingerIdentity::identical));
    std::vector<ClassSet>& sums = can_be_filled_.emplace_back();
    for (const ClassCounts& counts : set_counts_[static_cast<std::size_t>(largest)]) {
      sums.push_back(completed_sums(classes, counts, classes.admitted_classes()));
    }
  }
  at_.levels.resize(static_cast<std::size_t>(fingers));
}

std::uint64_t LimitedTendons::total(int fingers) const {
  const auto n = static_cast<std::size_t>(fingers);
  return one_tendon_ ? shapes_[n] : sets_[n][n];
}

const ClassCounts& LimitedTendons::counts(int fingers) const {
  const auto n = static_cast<std::size_t>(fingers);
  return one_tendon_ ? shape_counts_[n] : set_counts_[n][n];
}

std::uint64_t LimitedTendons::from(const ListedShape& shape, int open) const {
  const auto size = static_cast<std::size_t>(shape.size);
  const auto fingers = static_cast<std::size_t>(open);
  const std::uint64_t shapes = shapes_[size] - shape.index;
  if (one_tendon_) return shapes;
  std::uint64_t sum = 0;
  for (std::size_t many = 0; many * size <= fingers; ++many) {
    sum = plus(sum, times(multichoose(shapes, many), sets_[size - 1][fingers - many * size]));
  }
  return sum;
}

ClassCounts LimitedTendons::counts_from(const ListedShape& shape, int open) {
  ClassCounts shapes = shape_counts_[static_cast<std::size_t>(shape.size)];
  subtract(shapes, listed_.counts_before(shape.size, shape.index));
  if (one_tendon_) return shapes;
  const std::vector<ClassCounts>& smaller = set_counts_[static_cast<std::size_t>(shape.size) - 1];
  ClassCounts sum = no_counts(classes_);
  for (int many = 0; many * shape.size <= open; ++many) {
    const ClassCounts& others = smaller[static_cast<std::size_t>(open - many * shape.size)];
    add(sum, product(classes_, multisets(classes_, shapes, many), others));
  }
  return sum;
}

bool LimitedTendons::start_at_most(ListedShape& shape, int size) {
  for (; size > 0; --size) {
    if (listed_.start(shape, size)) return true;
    if (one_tendon_) return false;
  }
  return false;
}

// A level with the first shape that the one before it leaves; it is not yet in use.
bool LimitedTendons::enter() {
  Level& level = at_.levels[at_.depth];
  level.open = open();
  level.base = at_.depth == 0 ? at_.beside : at_.levels[at_.depth - 1].sum;
  const ListedShape* const last = at_.depth == 0 ? nullptr : &at_.levels[at_.depth - 1].shape;
  if (last != nullptr && last->size <= level.open) {
    level.first = *last;
  } else if (!start_at_most(level.first, level.open)) {
    return false;
  }
  level.shape = level.first;
  return true;
}

bool LimitedTendons::step(Level& level) {
  check_.step();
  ++steps_;
  if (listed_.next(level.shape)) return true;
  return !one_tendon_ && start_at_most(level.shape, level.shape.size - 1);
}

bool LimitedTendons::can_be_filled(const Level& level) const {
  const int rest = level.rest();
  return can_be_filled_[static_cast<std::size_t>(std::min(level.shape.size, rest))]
                       [static_cast<std::size_t>(rest)]
                           .test(level.sum);
}

bool LimitedTendons::leave_out_unwanted(const Hardware& hardware, IsWanted is_wanted) {
  constexpr std::uint64_t most_short_tendons = 100'000;
  const std::size_t fingers = shapes_.size() - 1;
  if (shapes_[fingers / 2] > most_short_tendons) return false;
  is_wanted_ = std::move(is_wanted);
  outlines_ = std::make_unique<ShapeOutlines>(hardware, listed_, static_cast<int>(fingers));
  bound_walks(hardware);
  return true;
}

void LimitedTendons::bound_walks(const Hardware& hardware) {
  const int fingers = static_cast<int>(shapes_.size()) - 1;
  walk_bounds_.resize(shapes_.size());
  if (parts_.anchored) return;
  beginning_counts_ = std::make_unique<BeginningCounts>(classes_, parts_, fingers);
  for (int size = fingers / 2 + 1; size <= fingers; ++size) {
    if (listed_.is_listed(size)) continue;
    walk_bounds_[static_cast<std::size_t>(size)] = std::make_unique<WalkBounds>(
        hardware, parts_, size, outlines_->most_motor_tension(fingers - size));
  }
}

// Passes the shapes whose walks begin in an unwanted way. False if no other one is left.
bool LimitedTendons::pass_unwanted_walks(Level& level) {
  if (!is_first(level) || !outlines_) return true;
  while (walk_bounds_[static_cast<std::size_t>(level.shape.size)]) {
    const Tendon& tendon = listed_.tendon(level.shape);
    if (level.shape.index == 0) at_.last_walk.clear();
    const std::size_t tokens = tendon.closed ? 0 : unwanted_tokens(level, tendon.walk);
    if (tokens == 0) return true;
    check_.step();
    ++steps_;
    if (listed_.next_beyond(level.shape, tokens, beginning_counts_->count(at_.last_walk, tokens))) {
      continue;
    }
    if (one_tendon_ || !start_at_most(level.shape, level.shape.size - 1)) return false;
  }
  return true;
}

// Looks at beginnings that the shape before does not have, of which this is the first shape.
// Returns the number of tokens of the shortest that is unwanted, or 0.
std::size_t LimitedTendons::unwanted_tokens(const Level& level, const Walk& walk) {
  const auto differs =
      std::mismatch(walk.begin(), walk.end(), at_.last_walk.begin(), at_.last_walk.end(),
                    [](const Token& a, const Token& b) { return a == b; });
  const auto same = static_cast<std::size_t>(differs.first - walk.begin());
  at_.last_walk = walk;
  WalkBounds& bounds = *walk_bounds_[static_cast<std::size_t>(level.shape.size)];
  for (int passed = level.shape.size / 2 + 1; passed < level.shape.size; ++passed) {
    const std::size_t tokens = static_cast<std::size_t>(2 * passed) + 1;
    if (tokens <= same) continue;
    bounds.read(walk, passed);
    if (!has_wanted_walks(level, beginning_counts_->count(walk, tokens))) return tokens;
  }
  return 0;
}

// True if a shape among those that begin as this one may be wanted.
bool LimitedTendons::has_wanted_walks(const Level& level, const ClassCounts& alike) {
  const std::uint64_t shapes = std::accumulate(alike.begin(), alike.end(), std::uint64_t{0});
  WalkBounds& bounds = *walk_bounds_[static_cast<std::size_t>(level.shape.size)];
  for (int m = 1; m <= bounds.most_motor_sides(); ++m) {
    if (bounds.outline(m, bound_) && is_bound_wanted(level, bound_, shapes)) return true;
  }
  return false;
}

// Asks for so many shapes from this one on, which this outline bounds. It is the first tendon.
bool LimitedTendons::is_bound_wanted(const Level& level, const TreeOutline& bound,
                                     std::uint64_t shapes) {
  beginning_ = {{&bound}, level.rest(), 0, true};
  return is_wanted_(beginning_, places(level, shapes));
}

// The places of what begins with the tendons so far, the last of them one of these shapes.
ShardRange LimitedTendons::places(const Level& level, std::uint64_t shapes) const {
  ListedShape next;
  next.size = level.shape.size;
  next.index = level.shape.index + shapes;
  ShardRange places;
  for (const Level* each = at_.levels.data(); each < &level; ++each) places.begin += each->before;
  const std::uint64_t here = from(level.shape, level.open);
  places.begin += from(level.first, level.open) - here;
  places.end = places.begin + here - from(next, level.open);
  return places;
}

// A tendon alone is asked for by few of its states: its reader finds the others while the next one
// is made.
bool LimitedTendons::may_be_wanted(const Level& level) {
  if (!outlines_) return true;
  if (is_first(level) && !listed_.is_listed(level.shape.size)) {
    const TreeOutline* const bound = outlines_->find_bound(level.shape);
    if (bound != nullptr && !is_bound_wanted(level, *bound, 1)) return false;
  }
  if (level.rest() == 0 && is_first(level)) return true;
  beginning_ = {{}, level.rest(), outlines_->most_motor_tension(level.rest()), true};
  for (const Level* each = at_.levels.data(); each <= &level; ++each) {
    beginning_.trees.push_back(outlines_->find(each->shape));
    if (beginning_.trees.back() == nullptr) return true;
  }
  return is_wanted_(beginning_, places(level, 1));
}

// Goes to the first shape, from this one on, that can still be completed. False if there is none.
bool LimitedTendons::settle(Level& level) {
  do {
    if (!pass_unwanted_walks(level)) return false;
    level.sum = classes_.plus(level.base, level.shape.parts);
    if (!can_be_filled(level)) continue;
    level.before = from(level.first, level.open) - from(level.shape, level.open);
    if (may_be_wanted(level)) return true;
  } while (step(level));
  return false;
}

bool LimitedTendons::fill() {
  while (open() > 0) {
    if (!enter() || !settle(at_.levels[at_.depth])) return false;
    ++at_.depth;
  }
  return true;
}

bool LimitedTendons::advance() {
  while (at_.depth > 0) {
    Level& last = at_.levels[at_.depth - 1];
    if (!step(last) || !settle(last)) {
      --at_.depth;
    } else if (fill()) {
      return true;
    }
  }
  return false;
}

// Routings that begin alike and whose next tendon has the size of this shape, from there on.
std::uint64_t LimitedTendons::of_size_from(const ListedShape& shape, int open) const {
  const std::uint64_t smaller =
      one_tendon_ ? 0
                  : sets_[static_cast<std::size_t>(shape.size) - 1][static_cast<std::size_t>(open)];
  return from(shape, open) - smaller;
}

// The shape of which the index is, and what is left of the index.
void LimitedTendons::choose(Level& level, std::uint64_t& index) {
  while (index >= of_size_from(level.shape, level.open)) {
    index -= of_size_from(level.shape, level.open);
    start_at_most(level.shape, level.shape.size - 1);
  }
  const std::uint64_t all = from(level.shape, level.open);
  std::uint64_t low = level.shape.index;
  std::uint64_t high = listed_.count(level.shape.size);
  ListedShape tried;
  tried.size = level.shape.size;
  while (index > 0 && high - low > 1) {
    tried.index = low + (high - low) / 2;
    (all - from(tried, level.open) <= index ? low : high) = tried.index;
  }
  listed_.advance_to(level.shape, low);
  index -= all - from(level.shape, level.open);
}

// Goes to the routing of this index, within limits or not.
void LimitedTendons::descend(std::uint64_t index) {
  for (at_.depth = 0; open() > 0; ++at_.depth) {
    Level& level = at_.levels[at_.depth];
    enter();
    choose(level, index);
    if (at_.depth == 0) at_.last_walk = listed_.tendon(level.shape).walk;
    level.sum = classes_.plus(level.base, level.shape.parts);
    level.before = from(level.first, level.open) - from(level.shape, level.open);
  }
}

void LimitedTendons::seek(int fingers, PartClass beside, std::uint64_t index) {
  at_.fingers = fingers;
  at_.beside = beside;
  at_.position = Position::behind_last;
  if (index >= total(fingers)) return;
  descend(index);
  const auto first_that_leads_nowhere =
      std::find_if(at_.levels.begin(), at_.levels.begin() + static_cast<std::ptrdiff_t>(at_.depth),
                   [&](const Level& level) { return !can_be_filled(level); });
  const auto fit = static_cast<std::size_t>(first_that_leads_nowhere - at_.levels.begin());
  const bool is_within = fit == at_.depth;
  if (!is_within) at_.depth = fit + 1;
  if (is_within || advance()) at_.position = Position::at_unread;
}

bool LimitedTendons::next(Routing& routing, std::uint64_t& place) {
  if (at_.position == Position::at_read && !advance()) at_.position = Position::behind_last;
  if (at_.position == Position::behind_last) return false;
  at_.position = Position::at_read;
  place = this->place();
  write(routing);
  return true;
}

std::uint64_t LimitedTendons::place() const {
  std::uint64_t sum = 0;
  for (std::size_t d = 0; d < at_.depth; ++d) sum += at_.levels[d].before;
  return sum;
}

void LimitedTendons::write(Routing& routing) const {
  routing.tendons.resize(at_.depth);
  for (std::size_t t = 0; t < at_.depth; ++t)
    routing.tendons[t] = listed_.tendon(at_.levels[t].shape);
  number_in_order(routing);
}

ClassCounts LimitedTendons::counts_before(int fingers, std::uint64_t index) {
  if (index == 0) return no_counts(classes_);
  if (index >= total(fingers)) return counts(fingers);
  const State kept = at_;
  at_.fingers = fingers;
  at_.beside = PartClasses::none;
  descend(index);
  ClassCounts sum = no_counts(classes_);
  for (std::size_t d = 0; d < at_.depth; ++d) {
    const Level& level = at_.levels[d];
    ClassCounts earlier = counts_from(level.first, level.open);
    subtract(earlier, counts_from(level.shape, level.open));
    add(sum, shifted(classes_, earlier, level.base));
  }
  at_ = kept;
  return sum;
}

std::optional<std::uint64_t> LimitedTendons::place_of(const Routing& routing) {
  if (one_tendon_ && routing.tendons.size() != 1) return std::nullopt;
  std::uint64_t sum = 0;
  int open = finger_count(routing);
  ListedShape last;
  last.size = open;
  for (const Tendon& tendon : routing.tendons) {
    ListedShape shape;
    ListedShape first = last;
    if (last.size > open) {
      first.size = open;
      first.index = 0;
    }
    if (!listed_.start(shape, finger_count(tendon))) return std::nullopt;
    while (!same_shape(listed_.tendon(shape), tendon)) {
      if (!listed_.next(shape)) return std::nullopt;
    }
    sum += from(first, open) - from(shape, open);
    open -= shape.size;
    last = shape;
  }
  return sum;
}

}  // namespace reeve::search
