#include "tests/support/planting_seizure.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <stdexcept>

#include "tests/support/reference_walk.hpp"

namespace reeve::testing {
namespace {

// A part of a cut tendon, with the routing's segments in its order; "" is a stand-in.
struct Piece {
  std::string word;
  std::vector<std::string> segments;

  bool on_motor() const { return word.find_first_of("MP") != std::string::npos; }
};

std::vector<std::string> names_of(const reference::Tendon& walk) {
  std::vector<std::string> names;
  for (const reference::Segment& segment : walk.segments) names.push_back(segment.name);
  return names;
}

std::string joined(const std::vector<std::string>& tokens) {
  std::string word;
  for (const std::string& token : tokens) word += (word.empty() ? "" : "-") + token;
  return word;
}

Piece piece_before(const reference::Tendon& walk, std::size_t k,
                   const std::vector<std::string>& end, bool stand_in) {
  std::vector<std::string> tokens = walk.tokens;
  tokens.resize(walk.places[k]);
  tokens.insert(tokens.end(), end.begin(), end.end());
  Piece piece{joined(tokens), names_of(walk)};
  piece.segments.resize(k + 1);
  if (stand_in) piece.segments.emplace_back();
  return piece;
}

Piece piece_after(const reference::Tendon& walk, std::size_t k, std::vector<std::string> tokens,
                  bool stand_in) {
  tokens.insert(tokens.end(), walk.tokens.begin() + static_cast<std::ptrdiff_t>(walk.places[k] + 1),
                walk.tokens.end());
  Piece piece{joined(tokens), names_of(walk)};
  piece.segments.erase(piece.segments.begin(),
                       piece.segments.begin() + static_cast<std::ptrdiff_t>(k + 1));
  if (stand_in) piece.segments.insert(piece.segments.begin(), std::string());
  return piece;
}

std::vector<Piece> pieces_of(const reference::Tendon& walk, std::size_t k) {
  if (walk.tokens[walk.places[k]] != "P")
    return {piece_before(walk, k, {"F"}, false), piece_after(walk, k, {"F"}, false)};
  if (walk.kinds[k] == "bearing")
    return {piece_before(walk, k, {"M"}, false), piece_after(walk, k, {"M"}, false)};
  const bool is_before_pulley = walk.places[k + 1] == walk.places[k];
  if (is_before_pulley)
    return {piece_before(walk, k, {"F"}, false), piece_after(walk, k, {"F", "P"}, true)};
  return {piece_before(walk, k, {"P", "F"}, true), piece_after(walk, k, {"F"}, false)};
}

void lock_stand_ins(const reference::Tendon& walk, CutRouting& cut) {
  for (std::size_t k = 0; k < walk.kinds.size(); ++k) {
    const auto [left, right] = walk.sides(k);
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
  for (const reference::Tendon& walk : reference::read_tendons(cut.word)) {
    for (const std::string& segment : names_of(walk)) {
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

bool one_end_pulls(const reference::Tendon& walk) {
  return !walk.loop && std::count(walk.tokens.begin(), walk.tokens.end(), "M") == 1 &&
         std::count(walk.tokens.begin(), walk.tokens.end(), "P") == 0;
}

CutRouting locked_at(const std::string& word, const reference::Tendon& walk, std::size_t k) {
  CutRouting cut = whole(word);
  cut.locked.insert(walk.sides(k));
  if (walk.loop) return cut;
  const bool motor_first = walk.tokens.front() == "M";
  for (std::size_t i = 0; i < walk.segments.size(); ++i) {
    if ((i <= k) != motor_first) cut.segment.erase(walk.segments[i].name);
  }
  return cut;
}

bool is_tip(const reference::Tendon& walk, std::size_t k) {
  return std::isdigit(static_cast<unsigned char>(walk.tokens[walk.places[k]].at(0))) != 0;
}

bool is_seizable(const reference::Tendon& walk, std::size_t k) {
  return !is_tip(walk, k) || walk.loop || one_end_pulls(walk);
}

std::string contact_name(const reference::Tendon& walk, std::size_t k) {
  const auto [left, right] = walk.sides(k);
  return left + "-" + right;
}

}  // namespace

CutRouting whole(const std::string& word) {
  CutRouting cut;
  cut.word = word;
  for (const reference::Tendon& walk : reference::read_tendons(word)) {
    for (const std::string& segment : names_of(walk)) cut.segment[segment] = segment;
  }
  return cut;
}

CutRouting cut_at(const std::string& word, const std::string& contact) {
  const std::vector<reference::Tendon> walks = reference::read_tendons(word);
  if (walks.size() != 1) throw std::invalid_argument("cut_at: " + word + " has several tendons");
  const reference::Tendon& walk = walks.front();
  for (std::size_t k = 0; k < walk.kinds.size(); ++k) {
    if (contact_name(walk, k) != contact || !is_seizable(walk, k)) continue;
    if (walk.loop || is_tip(walk, k)) return locked_at(word, walk, k);
    if (walk.tokens[walk.places[k]] != "M") return from_pieces(pieces_of(walk, k));
    CutRouting cut;
    cut.blocked = (walk.places[k] == 0 ? walk.segments.front() : walk.segments.back()).name;
    return cut;
  }
  throw std::invalid_argument("cut_at: " + word + " cannot be cut at " + contact);
}

std::vector<std::string> seizable_contacts(const std::string& word) {
  std::vector<std::string> names;
  const std::vector<reference::Tendon> walks = reference::read_tendons(word);
  if (walks.size() != 1) return names;
  for (std::size_t k = 0; k < walks.front().kinds.size(); ++k) {
    if (is_seizable(walks.front(), k)) names.push_back(contact_name(walks.front(), k));
  }
  return names;
}

}  // namespace reeve::testing
