// The routings without floating blocks whose parts are within limits, in the order and at the
// places of all of them (enumerate/tendon_generator.hpp), for identical fingers.
//
// A routing is a sequence of tendons, none before the one in front of it, so this is an odometer of
// tendons: the last one moves to its next shape, and when it has no more, it goes and the one
// before moves. As soon as the tendons that are chosen leave no way to fill the other fingers
// within the limits, none is tried: which sums of parts any number of fingers can still come to is
// counted beforehand (class_counts.hpp).
//
// What is passed over is not made either to know how much it is: of the sequences that begin alike,
// those whose next tendon is shape i of size s or a later one are
//   N(s, i) = Σ_m multichoose(shapes(s) - i, m) sets(tendons below s, fingers - m s),
// so the place of a routing is the sum over its tendons of N(first choice) - N(this choice).
//
// The reader may also say that nothing is wanted of what begins in some way
// (evaluate/routing_beginning.hpp): it is passed over likewise. A first tendon with more than half
// of the fingers is asked for when half of it is chosen (walk_bounds.hpp), and all that begin so
// are passed over by their number (beginning_counts.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/hardware.hpp"
#include "core/routing.hpp"
#include "search/enumerate/generator_options.hpp"
#include "search/evaluate/routing_beginning.hpp"
#include "search/limits/beginning_counts.hpp"
#include "search/limits/listed_shapes.hpp"
#include "search/limits/shape_outlines.hpp"
#include "search/limits/walk_bounds.hpp"
#include "search/stop_check.hpp"

namespace reeve::search {

// True if something that begins so is wanted, at one of these places of the tendons without blocks.
using IsWanted = std::function<bool(const RoutingBeginning&, const ShardRange& places)>;

class LimitedTendons {
 public:
  // Lists routings of up to this many fingers; if `one_tendon`, of exactly this many. Keeps a
  // reference to the classes.
  LimitedTendons(const PartClasses& classes, const PartSet& parts, int fingers, bool one_tendon,
                 std::uint64_t longest_list = ListedShapes::default_longest);

  std::uint64_t total(int fingers) const;
  const ClassCounts& counts(int fingers) const;
  // Counts the routings with an index below this one.
  ClassCounts counts_before(int fingers, std::uint64_t index);

  // The next call of next() gives the first routing from this index on that is within the limits
  // together with what is beside it.
  void seek(int fingers, PartClass beside, std::uint64_t index);
  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& place);

  // Gives no routing of this hardware that begins in an unwanted way. False if the fingers are too
  // many for a table of the short tendons.
  bool leave_out_unwanted(const Hardware& hardware, IsWanted is_wanted);

  // Returns the place of a canonical routing, whatever its parts, if it is in the enumeration.
  std::optional<std::uint64_t> place_of(const Routing& routing);

  // Returns the number of tendons examined.
  std::uint64_t steps() const { return steps_ + listed_.steps(); }

  // The check is read on each step from tendon to tendon.
  void stop_with(const StopCheck& check) {
    check_ = check;
    listed_.stop_with(check);
  }

 private:
  struct Level {
    ListedShape first;  // first possible choice
    ListedShape shape;
    int open = 0;                        // fingers for this tendon and those after it
    PartClass base = PartClasses::none;  // class of the tendons chosen before
    PartClass sum = PartClasses::none;   // base plus this tendon
    std::uint64_t before = 0;            // number of routings that begin alike, up to this choice

    int rest() const { return open - shape.size; }
  };

  enum class Position { at_unread, at_read, behind_last };
  struct State {
    int fingers = 0;
    PartClass beside = PartClasses::none;
    std::vector<Level> levels;  // the first `depth` are in use
    std::size_t depth = 0;
    Position position = Position::behind_last;
    Walk last_walk;  // walk of the first shape whose beginnings were looked at last
  };

  std::uint64_t from(const ListedShape& shape, int open) const;
  std::uint64_t of_size_from(const ListedShape& shape, int open) const;
  ClassCounts counts_from(const ListedShape& shape, int open);
  int open() const { return at_.depth == 0 ? at_.fingers : at_.levels[at_.depth - 1].rest(); }
  bool start_at_most(ListedShape& shape, int size);
  bool enter();
  bool step(Level& level);
  bool is_first(const Level& level) const { return &level == at_.levels.data(); }
  bool can_be_filled(const Level& level) const;
  bool may_be_wanted(const Level& level);
  void bound_walks(const Hardware& hardware);
  bool pass_unwanted_walks(Level& level);
  std::size_t unwanted_tokens(const Level& level, const Walk& walk);
  bool has_wanted_walks(const Level& level, const ClassCounts& alike);
  bool is_bound_wanted(const Level& level, const TreeOutline& bound, std::uint64_t shapes);
  ShardRange places(const Level& level, std::uint64_t shapes) const;
  bool settle(Level& level);
  bool fill();
  bool advance();
  void descend(std::uint64_t index);
  void choose(Level& level, std::uint64_t& index);
  std::uint64_t place() const;
  void write(Routing& routing) const;

  const PartClasses& classes_;
  PartSet parts_;
  bool one_tendon_;
  std::vector<std::uint64_t> shapes_;             // [size]
  std::vector<std::vector<std::uint64_t>> sets_;  // [largest][fingers]
  std::vector<ClassCounts> shape_counts_;
  std::vector<std::vector<ClassCounts>> set_counts_;
  std::vector<std::vector<ClassSet>> can_be_filled_;  // [largest][fingers]: sums before
  ListedShapes listed_;
  std::unique_ptr<ShapeOutlines> outlines_;  // set if what is unwanted is left out
  // [size], of tendons with more than half of the fingers that are in no list.
  std::vector<std::unique_ptr<WalkBounds>> walk_bounds_;
  std::unique_ptr<BeginningCounts> beginning_counts_;
  TreeOutline bound_;  // of the tendons that begin alike
  IsWanted is_wanted_;
  RoutingBeginning beginning_;

  State at_;
  std::uint64_t steps_ = 0;
  StopCheck check_;
};

}  // namespace reeve::search
