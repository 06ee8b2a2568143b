#include "core/canonical_tree.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/walk_image.hpp"

namespace reeve::core {
namespace {

using Rank = int;
// What is compared first stands first.
using Signature = std::vector<Rank>;

Rank shape_code(const Token& token) {
  const auto kind = static_cast<Rank>(token.kind);
  return ((kind * 2 + static_cast<Rank>(token.tip)) << 16) + token.arms.left;
}

template <typename Key>
std::map<Key, Rank> ranked(const std::vector<Key>& keys) {
  std::map<Key, Rank> rank;
  for (const Key& key : keys) rank[key] = 0;
  Rank next = 0;
  for (auto& [key, number] : rank) number = next++;
  return rank;
}

class Refinement {
 public:
  Refinement(const std::vector<Tendon>& tendons, FingerIdentity identity)
      : tendons_(tendons), identity_(identity), tendon_rank_(tendons.size(), 0) {
    block_rank_.fill(0);
    images_.resize(tendons.size());
    std::size_t classes = 0;
    while (true) {
      const std::size_t now = refine_tendons() + refine_blocks();
      if (now == classes) break;
      classes = now;
    }
  }

  Rank rank(std::size_t tendon) const { return tendon_rank_[tendon]; }
  Image image(std::size_t tendon) const { return images_[tendon].front(); }

 private:
  Signature signature(const Tendon& tendon, Image image) const {
    Signature all;
    const std::size_t n = tendon.walk.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Token token = image_token(tendon.walk, image, i);
      all.push_back(shape_code(token));
      all.push_back(token.arms.right);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Token token = image_token(tendon.walk, image, i);
      all.push_back(is_of_block(token.kind) ? block_rank_[block_key(token)] : 0);
    }
    if (identity_ == FingerIdentity::identical) return all;
    for (std::size_t i = 0; i < n; ++i) {
      all.push_back(image_token(tendon.walk, image, i).finger);
    }
    return all;
  }

  // Where a token stands in the least image, the first of these places if several are as little.
  Rank first_place(std::size_t tendon, std::size_t index) const {
    const std::size_t n = tendons_[tendon].walk.size();
    std::size_t first = n;
    for (const Image image : images_[tendon]) {
      const std::size_t place = image.backward ? image.start + n - index : index + n - image.start;
      first = std::min(first, place % n);
    }
    return static_cast<Rank>(first);
  }

  // The number of classes.
  std::size_t refine_tendons() {
    std::vector<std::pair<Rank, Signature>> keys;
    for (std::size_t t = 0; t < tendons_.size(); ++t) {
      Signature least;
      images_[t].clear();
      for_each_image(tendons_[t], [&](Image image) {
        Signature other = signature(tendons_[t], image);
        if (images_[t].empty() || other < least) {
          least = std::move(other);
          images_[t] = {image};
        } else if (other == least) {
          images_[t].push_back(image);
        }
        return true;
      });
      Signature whole{-core::finger_count(tendons_[t]), tendons_[t].closed ? 1 : 0};
      whole.insert(whole.end(), least.begin(), least.end());
      keys.emplace_back(tendon_rank_[t], std::move(whole));
    }
    const auto rank = ranked(keys);
    for (std::size_t t = 0; t < keys.size(); ++t) tendon_rank_[t] = rank.at(keys[t]);
    return rank.size();
  }

  // A block is told by the tendons on it, where on them it is, and how.
  std::size_t refine_blocks() {
    std::array<std::vector<Signature>, block_keys> places;
    for (std::size_t t = 0; t < tendons_.size(); ++t) {
      const Walk& walk = tendons_[t].walk;
      for (std::size_t i = 0; i < walk.size(); ++i) {
        if (!is_of_block(walk[i].kind)) continue;
        places[block_key(walk[i])].push_back({tendon_rank_[t], first_place(t, i)});
      }
    }
    std::vector<std::pair<Rank, std::vector<Signature>>> keys;
    for (std::size_t b = 0; b < block_keys; ++b) {
      std::sort(places[b].begin(), places[b].end());
      keys.emplace_back(block_rank_[b], std::move(places[b]));
    }
    const auto rank = ranked(keys);
    for (std::size_t b = 0; b < block_keys; ++b) block_rank_[b] = rank.at(keys[b]);
    return rank.size();
  }

  const std::vector<Tendon>& tendons_;
  FingerIdentity identity_;
  std::vector<Rank> tendon_rank_;
  std::array<Rank, block_keys> block_rank_{};
  std::vector<std::vector<Image>> images_;  // of each tendon, those with the least signature
};

bool passes_a_block(const Tendon& tendon) {
  return std::any_of(tendon.walk.begin(), tendon.walk.end(), [](const Token& token) {
    return is_of_block(token.kind) && !is_tail(token.kind);
  });
}

bool is_on(const Tendon& tendon, std::size_t key) {
  return std::any_of(tendon.walk.begin(), tendon.walk.end(), [&](const Token& token) {
    return is_of_block(token.kind) && block_key(token) == key;
  });
}

void number_blocks_in_order(std::vector<Tendon>& tendons) {
  std::array<std::uint8_t, block_keys> number{};
  std::uint8_t blocks = 0;
  std::uint8_t bars = 0;
  for (Tendon& tendon : tendons) {
    for (Token& token : tendon.walk) {
      if (!is_of_block(token.kind)) continue;
      std::uint8_t& named = number[block_key(token)];
      if (named == 0) named = is_of_bar(token.kind) ? ++bars : ++blocks;
      token.block = named;
    }
  }
}

}  // namespace

std::vector<Tendon> canonical_tree(const std::vector<Tendon>& tendons, FingerIdentity identity) {
  const Refinement refinement(tendons, identity);
  std::vector<Tendon> result;
  std::vector<std::size_t> to_visit;  // blocks, in the order of their names
  std::set<std::size_t> seen;
  std::vector<bool> listed(tendons.size(), false);
  const auto list_least = [&](auto wanted) {
    std::size_t least = tendons.size();
    for (std::size_t t = 0; t < tendons.size(); ++t) {
      if (listed[t] || !wanted(tendons[t])) continue;
      if (least == tendons.size() || refinement.rank(t) < refinement.rank(least)) least = t;
    }
    if (least == tendons.size()) return false;
    listed[least] = true;
    result.push_back(walked(tendons[least], refinement.image(least)));
    for (const Token& token : result.back().walk) {
      if (!is_of_block(token.kind)) continue;
      if (seen.insert(block_key(token)).second) to_visit.push_back(block_key(token));
    }
    return true;
  };
  list_least([](const Tendon& tendon) { return !passes_a_block(tendon); });
  for (std::size_t i = 0; i < to_visit.size(); ++i) {
    const std::size_t key = to_visit[i];
    while (list_least([key](const Tendon& tendon) { return is_on(tendon, key); })) {
    }
  }
  number_blocks_in_order(result);
  return result;
}

}  // namespace reeve::core
