#include "tests/support/random_mechanism.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "tests/support/reference_walk.hpp"
#include "tests/support/sound_mechanism.hpp"

namespace reeve::testing {

namespace {

using Words = std::vector<std::string>;

bool is_finger(const std::string& token) {
  return std::isdigit(static_cast<unsigned char>(token.at(0))) != 0;
}

// A tendon before it is written: what ties its ends (nothing yet if empty), what it passes.
struct Sketch {
  std::string front, back;
  Words inner;
  bool loop = false;

  bool has_free_end() const { return front.empty() || back.empty(); }
  void tie(Dice& dice, const std::string& end) {
    (front.empty() && (!back.empty() || dice.chance(0.5)) ? front : back) = end;
  }
};

struct Block {
  std::string tail;
  Words passes;  // tokens as written
};

std::string random_tip(Dice& dice, int finger) {
  return std::to_string(finger) + (dice.chance(0.3) ? "b" : "");
}

std::string random_hand_join(Dice& dice) { return dice.pick<std::string>({"T", "T", "B", "P"}); }

// With both at its sheaves.
bool are_of_one_block(const std::string& a, const std::string& b) {
  return a.starts_with('Y') && a.substr(0, a.find('k')) == b.substr(0, b.find('k'));
}

// A join where two fingers or places of one block meet, sometimes elsewhere.
void add_token(Dice& dice, const std::string& token, Words& walk) {
  const bool need_one = !walk.empty() && ((is_finger(walk.back()) && is_finger(token)) ||
                                          are_of_one_block(walk.back(), token));
  if (need_one || (!walk.empty() && dice.chance(0.08))) walk.push_back(random_hand_join(dice));
  walk.push_back(token);
}

std::string walk_of(Dice& dice, Sketch sketch) {
  dice.shuffle(sketch.inner);
  Words walk;
  if (sketch.loop) {
    const auto first = std::find_if(sketch.inner.begin(), sketch.inner.end(), is_finger);
    std::rotate(sketch.inner.begin(), first, sketch.inner.end());
    sketch.inner.push_back(sketch.inner.front());
  } else {
    walk.push_back(sketch.front);
    sketch.inner.push_back(sketch.back);
  }
  for (const std::string& token : sketch.inner) add_token(dice, token, walk);
  std::string word;
  for (const std::string& token : walk) word += (word.empty() ? "" : "-") + token;
  return word;
}

// The fingers and blocks of one tree, numbered on from those of the trees before it.
class TreeSketch {
 public:
  TreeSketch(Dice& dice, const std::vector<int>& fingers, int first_block, int blocks)
      : dice_(dice), fingers_(fingers), first_block_(first_block), blocks_(blocks) {}

  std::string tree() {
    sketches_.resize(static_cast<std::size_t>(blocks_) + 1);
    for (int b = 0; b < blocks_; ++b) join_by_block(b);
    spread_fingers();
    finish();
    return word();
  }

  std::string tackle() {
    sketches_.resize(static_cast<std::size_t>(dice_.chance(0.9) ? blocks_ + 1 : blocks_ + 2));
    for (int b = 0; b < blocks_; ++b) rig_block(b);
    spread_fingers();
    finish();
    return word();
  }

 private:
  std::string name(int b) const { return "Y" + std::to_string(first_block_ + b); }

  Sketch& any(std::size_t low, std::size_t high) {
    return sketches_[static_cast<std::size_t>(
        dice_.integer(static_cast<int>(low), static_cast<int>(high)))];
  }

  // Joins tendon b + 1 to one before it; the tail is on either.
  void join_by_block(int b) {
    const auto own = static_cast<std::size_t>(b) + 1;
    Sketch* below = &sketches_[own];
    Sketch* above = &any(0, own - 1);
    if (dice_.chance(0.3) || !above->has_free_end()) std::swap(below, above);
    above->tie(dice_, name(b));
    if (dice_.chance(0.1) && below->has_free_end()) {
      below->tie(dice_, name(b) + "k");
      if (dice_.chance(0.5)) return;
    } else if (dice_.chance(0.25)) {
      below->inner.push_back(random_bar(name(b)));
      return;
    }
    below->inner.push_back(name(b));
    if (dice_.chance(0.08)) below->inner.push_back(name(b));
  }

  std::string random_bar(const std::string& block) {
    const std::string bar = "W" + block.substr(1);
    replace_tail(block, bar);
    if (dice_.chance(0.4)) return bar;
    return bar + dice_.pick<std::string>({"/2:1", "/1:2", "/3:1", "/2:3", "/5:4", "/1:9"});
  }

  void replace_tail(const std::string& block, const std::string& bar) {
    for (Sketch& sketch : sketches_)
      for (std::string* end : {&sketch.front, &sketch.back})
        if (*end == block) *end = bar;
  }

  // Strands, beckets on tendons before that of its tail.
  void rig_block(int b) {
    const std::size_t last = sketches_.size() - 1;
    std::size_t tail = static_cast<std::size_t>(dice_.integer(1, static_cast<int>(last)));
    for (std::size_t tries = 0; tries < last && !sketches_[tail].has_free_end(); ++tries)
      tail = tail % last + 1;
    if (!sketches_[tail].has_free_end()) return;
    sketches_[tail].tie(dice_, name(b));
    if (Sketch& other = any(tail, last); dice_.chance(0.1) && other.has_free_end())
      other.tie(dice_, name(b));
    bool held = false;
    if (Sketch& becket = any(0, tail - 1); dice_.chance(0.5) && becket.has_free_end()) {
      becket.tie(dice_, name(b) + "k");
      held = true;
    }
    for (int passes = dice_.integer(held ? 0 : 1, 2); passes > 0; --passes)
      any(0, tail - 1).inner.push_back(name(b));
  }

  void spread_fingers() {
    std::vector<int> left = fingers_;
    dice_.shuffle(left);
    for (const int finger : left) {
      Sketch& sketch = any(0, sketches_.size() - 1);
      if (sketch.has_free_end() && dice_.chance(0.5))
        sketch.tie(dice_, std::to_string(finger) + "x");
      else
        sketch.inner.push_back(random_tip(dice_, finger));
    }
  }

  void finish() {
    for (Sketch& sketch : sketches_) {
      const bool fingers = std::any_of(sketch.inner.begin(), sketch.inner.end(), is_finger);
      sketch.loop = fingers && sketch.front.empty() && sketch.back.empty() && dice_.chance(0.4);
      while (!sketch.loop && sketch.has_free_end())
        sketch.tie(dice_, dice_.chance(0.4) ? "M" : "F");
    }
  }

  std::string word() {
    dice_.shuffle(sketches_);
    std::string word;
    for (const Sketch& sketch : sketches_)
      word += (word.empty() ? "" : "+") + walk_of(dice_, sketch);
    if (word.find('M') == std::string::npos && word.find('P') == std::string::npos) {
      const std::size_t fixed = word.find('F');
      if (fixed != std::string::npos) word[fixed] = 'M';
    }
    return word;
  }

  Dice& dice_;
  std::vector<int> fingers_;
  int first_block_, blocks_;
  std::vector<Sketch> sketches_;
};

std::string one_tree(Dice& dice, const MechanismRange& range, int& fingers, int& blocks) {
  const int more_fingers = dice.integer(1, range.most_fingers - fingers);
  const int more_blocks = dice.integer(fingers == 0 ? 1 : 0, range.most_blocks - blocks);
  std::vector<int> numbers;
  for (int i = 1; i <= more_fingers; ++i) numbers.push_back(fingers + i);
  TreeSketch sketch(dice, numbers, blocks + 1, more_blocks);
  fingers += more_fingers;
  blocks += more_blocks;
  return more_blocks > 0 && dice.chance(range.tackles) ? sketch.tackle() : sketch.tree();
}

}  // namespace

std::string random_mechanism(Dice& dice, const MechanismRange& range) {
  for (;;) {
    int fingers = 0, blocks = 0;
    std::string word = one_tree(dice, range, fingers, blocks);
    while (fingers < range.most_fingers && dice.chance(range.further))
      word += "+" + one_tree(dice, range, fingers, blocks);
    if (is_sound_mechanism(word, blocks)) return word;
  }
}

namespace {

double some_friction(Dice& dice) { return dice.chance(0.15) ? 0 : dice.log_real(1e-4, 0.4); }

ReferenceLaw some_law(Dice& dice) { return {some_friction(dice), dice.real(0, 6)}; }

}  // namespace

ReferenceHardware random_reference_hardware(Dice& dice, const std::string& word) {
  ReferenceHardware hardware{some_law(dice),
                             some_law(dice),
                             some_law(dice),
                             dice.log_real(20, 500),
                             dice.log_real(20, 500),
                             dice.log_real(20, 500),
                             {},
                             {},
                             {},
                             {}};
  if (dice.chance(0.5)) hardware.block = some_law(dice);
  std::map<ContactName, double> phi;
  std::map<std::string, double> length;
  for (const reference::Tendon& tendon : reference::read_tendons(word)) {
    for (std::size_t k = 0; k < tendon.kinds.size(); ++k)
      if (dice.chance(0.3)) phi[tendon.sides(k)] = some_friction(dice) * dice.real(0, 6);
    for (const auto& segment : tendon.segments)
      if (dice.chance(0.3)) length[segment.name] = dice.log_real(20, 500);
    for (const int finger : tendon.fingers)
      if (dice.chance(0.3)) hardware.closing_weight[finger] = dice.log_real(0.1, 10);
  }
  hardware.phi_override = [phi](const std::string& left, const std::string& right, double nominal) {
    const auto own = phi.find({left, right});
    return own == phi.end() ? nominal : own->second;
  };
  hardware.length_override = [length](const std::string& segment, double nominal) {
    const auto own = length.find(segment);
    return own == length.end() ? nominal : own->second;
  };
  return hardware;
}

}  // namespace reeve::testing
