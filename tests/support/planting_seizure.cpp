#include "tests/support/planting_seizure.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

// A part of a cut tendon, with the routing's segments in its order; "" is a stand-in.
struct Piece {
  std::string word;
  std::vector<std::string> segments;

  bool on_motor() const { return word.find_first_of("MP") != std::string::npos; }
};

std::string joined(const std::vector<std::string>& tokens) {
  std::string word;
  for (const std::string& token : tokens) word += (word.empty() ? "" : "-") + token;
  return word;
}

Piece piece_before(const Walk& walk, std::size_t k, const std::vector<std::string>& end,
                   bool stand_in) {
  std::vector<std::string> tokens(
      walk.tokens.begin(), walk.tokens.begin() + static_cast<std::ptrdiff_t>(walk.links[k].token));
  tokens.insert(tokens.end(), end.begin(), end.end());
  Piece piece{joined(tokens),
              {walk.segments.begin(), walk.segments.begin() + static_cast<std::ptrdiff_t>(k + 1)}};
  if (stand_in) piece.segments.emplace_back();
  return piece;
}

Piece piece_after(const Walk& walk, std::size_t k, std::vector<std::string> tokens, bool stand_in) {
  tokens.insert(tokens.end(),
                walk.tokens.begin() + static_cast<std::ptrdiff_t>(walk.links[k].token + 1),
                walk.tokens.end());
  Piece piece{joined(tokens),
              {walk.segments.begin() + static_cast<std::ptrdiff_t>(k + 1), walk.segments.end()}};
  if (stand_in) piece.segments.insert(piece.segments.begin(), std::string());
  return piece;
}

std::vector<Piece> pieces_of(const Walk& walk, std::size_t k) {
  switch (walk.links[k].kind) {
    case LinkKind::join:
      return {piece_before(walk, k, {"F"}, false), piece_after(walk, k, {"F"}, false)};
    case LinkKind::pulley:
      return {piece_before(walk, k, {"M"}, false), piece_after(walk, k, {"M"}, false)};
    case LinkKind::sheath_before_pulley:
      return {piece_before(walk, k, {"F"}, false), piece_after(walk, k, {"F", "P"}, true)};
    case LinkKind::sheath_after_pulley:
      return {piece_before(walk, k, {"P", "F"}, true), piece_after(walk, k, {"F"}, false)};
    default:
      throw std::logic_error("pieces_of: this contact is not cut by words");
  }
}

void lock_stand_ins(const Walk& walk, CutRouting& cut) {
  for (std::size_t k = 0; k < walk.links.size(); ++k) {
    const std::string& left = walk.segments[k];
    const std::string& right = walk.segments[(k + 1) % walk.segments.size()];
    if (cut.stand_ins.contains(left) || cut.stand_ins.contains(right)) {
      cut.locked.emplace(left, right);
    }
  }
}

CutRouting from_pieces(const std::vector<Piece>& pieces) {
  CutRouting cut;
  std::vector<std::string> originals;
  for (const Piece& piece : pieces) {
    if (!piece.on_motor()) continue;
    cut.word += (cut.word.empty() ? "" : "+") + piece.word;
    originals.insert(originals.end(), piece.segments.begin(), piece.segments.end());
  }
  std::size_t next = 0;
  for (const Walk& walk : walks_of(cut.word)) {
    for (const std::string& segment : walk.segments) {
      const std::string& original = originals.at(next++);
      if (original.empty()) {
        cut.stand_ins.insert(segment);
      } else {
        cut.segment[segment] = original;
      }
    }
    lock_stand_ins(walk, cut);
  }
  return cut;
}

bool one_end_pulls(const Walk& walk) {
  return !walk.loop && std::count(walk.tokens.begin(), walk.tokens.end(), "M") == 1 &&
         std::count(walk.tokens.begin(), walk.tokens.end(), "P") == 0;
}

CutRouting locked_at(const std::string& word, const Walk& walk, std::size_t k) {
  CutRouting cut = whole(word);
  cut.locked.emplace(walk.segments[k], walk.segments[(k + 1) % walk.segments.size()]);
  if (walk.loop) return cut;
  const bool motor_first = walk.tokens.front() == "M";
  for (std::size_t i = 0; i < walk.segments.size(); ++i) {
    if ((i <= k) != motor_first) cut.segment.erase(walk.segments[i]);
  }
  return cut;
}

bool is_seizable(const Walk& walk, std::size_t k) {
  return walk.links[k].kind != LinkKind::tip || walk.loop || one_end_pulls(walk);
}

}  // namespace

CutRouting whole(const std::string& word) {
  CutRouting cut;
  cut.word = word;
  for (const Walk& walk : walks_of(word)) {
    for (const std::string& segment : walk.segments) cut.segment[segment] = segment;
  }
  return cut;
}

CutRouting cut_at(const std::string& word, const std::string& contact) {
  const std::vector<Walk> walks = walks_of(word);
  if (walks.size() != 1) throw std::invalid_argument("cut_at: " + word + " has several tendons");
  const Walk& walk = walks.front();
  for (std::size_t k = 0; k < walk.links.size(); ++k) {
    if (walk.link_name(k) != contact || !is_seizable(walk, k)) continue;
    if (walk.loop || walk.links[k].kind == LinkKind::tip) return locked_at(word, walk, k);
    if (walk.links[k].kind != LinkKind::end_sheath) return from_pieces(pieces_of(walk, k));
    CutRouting cut;
    cut.blocked = walk.links[k].token == 0 ? walk.segments.front() : walk.segments.back();
    return cut;
  }
  throw std::invalid_argument("cut_at: " + word + " cannot be cut at " + contact);
}

std::vector<std::string> seizable_contacts(const std::string& word) {
  std::vector<std::string> names;
  const std::vector<Walk> walks = walks_of(word);
  if (walks.size() != 1) return names;
  for (std::size_t k = 0; k < walks.front().links.size(); ++k) {
    if (is_seizable(walks.front(), k)) names.push_back(walks.front().link_name(k));
  }
  return names;
}

}  // namespace reeve::testing
