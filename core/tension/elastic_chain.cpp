#include "core/tension/elastic_chain.hpp"

#include <algorithm>
#include <limits>

namespace reeve::core {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// T_r / T_l of a contact that slides.
double ratio(const ChainContact& contact) {
  return contact.slide == Slide::to_right ? 1 / contact.decay : contact.decay;
}

}  // namespace

// Up to the first still contact the derivative is one piece, which needs no list. Returns the
// number of contacts passed.
std::size_t ElasticChain::start(std::span<const ChainSegment> segments,
                                std::span<const ChainContact> contacts) {
  double slope = 0;
  double offset = 0;
  std::size_t k = 0;
  for (; k < contacts.size() && contacts[k].slide != Slide::no; ++k) {
    slope = (slope + segments[k].length) / ratio(contacts[k]);
    offset += segments[k].take_up;
  }
  pieces_.clear();
  pieces_.push_back({slope, infinity, offset});
  return k;
}

void ElasticChain::add(const ChainSegment& segment) {
  for (Piece& piece : pieces_) {
    piece.slope += segment.length;
    piece.offset += segment.take_up;
  }
}

void ElasticChain::slide(double ratio) {
  for (Piece& piece : pieces_) {
    piece.upto *= ratio;
    piece.slope /= ratio;
  }
}

double ElasticChain::root() const {
  // The derivative is continuous, so rounding alone can put the root below the piece that holds it.
  double from = 0;
  for (const Piece& piece : pieces_) {
    if (piece.slope * piece.upto >= piece.offset) {
      return std::max(from, piece.offset / piece.slope);
    }
    from = piece.upto;
  }
  return from;
}

void ElasticChain::hold(double decay, double rest) {
  previous_.swap(pieces_);
  // Pieces on both sides of the gap, which may cut one in two, and the gap.
  pieces_.resize(previous_.size() + 2);
  Piece* next = pieces_.data();
  auto piece = previous_.begin();
  if (rest > 0) {
    for (; piece->upto < rest; ++piece) {
      *next++ = {piece->slope / decay, piece->upto * decay, piece->offset};
    }
    *next++ = {piece->slope / decay, rest * decay, piece->offset};
    *next++ = {0, rest / decay, 0};
  }
  for (; piece != previous_.end(); ++piece) {
    *next++ = {piece->slope * decay, piece->upto / decay, piece->offset};
  }
  pieces_.resize(static_cast<std::size_t>(next - pieces_.data()));
}

void ElasticChain::solve(std::span<const ChainSegment> segments,
                         std::span<const ChainContact> contacts, std::span<double> tension) {
  rest_.resize(contacts.size());
  for (std::size_t k = start(segments, contacts); k < contacts.size(); ++k) {
    add(segments[k]);
    if (contacts[k].slide == Slide::no) {
      rest_[k] = root();
      hold(contacts[k].decay, rest_[k]);
    } else {
      slide(ratio(contacts[k]));
    }
  }
  add(segments.back());
  tension.back() = root();
  for (std::size_t k = contacts.size(); k-- > 0;) {
    const double right = tension[k + 1];
    tension[k] = contacts[k].slide == Slide::no
                     ? std::clamp(rest_[k], right * contacts[k].decay, right / contacts[k].decay)
                     : right / ratio(contacts[k]);
  }
}

}  // namespace reeve::core
