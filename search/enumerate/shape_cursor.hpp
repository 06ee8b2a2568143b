// The tendons that a set of parts allows, without finger numbers, one after the other.
#pragma once

#include <boost/container/static_vector.hpp>

#include <cstddef>
#include <cstdint>

#include "core/routing.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve::search {

// Tendon shapes through a given number of fingers in canonical order: open ones, then loops. An
// anchored tip takes the place of a finger and of the end beside it.
class ShapeCursor {
 public:
  // Moves to the first shape; false if there is none.
  bool start(const PartSet& parts, int fingers);
  bool next(const PartSet& parts);
  // Passes the shapes, so many from this one on, that begin with the first `tokens` of its walk.
  bool next_beyond(const PartSet& parts, std::size_t tokens, std::uint64_t shapes);

  int fingers() const { return fingers_; }
  std::uint64_t index() const { return index_; }  // among the shapes of this size
  const Tendon& shape() const { return shape_; }

 private:
  // Choices at one place: at most an anchored tip, two tips, two ends and three joins.
  using Choices = boost::container::static_vector<Token, 8>;

  Choices choices(const PartSet& parts) const;
  bool is_whole() const;
  void push(const Token& token);
  void pop();
  void shorten(std::size_t tokens);
  void complete(const PartSet& parts);
  bool start_family(const PartSet& parts, bool closed);
  bool next_walk(const PartSet& parts);
  bool settle(const PartSet& parts);

  Tendon shape_;
  int fingers_ = 0;
  int passed_ = 0;  // number of fingers on the walk so far
  std::uint64_t index_ = 0;
};

}  // namespace reeve::search
