// The segments and contacts of a walk, in order, for planting only.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace reeve::testing {

enum class LinkKind { tip, join, end_sheath, sheath_before_pulley, pulley, sheath_after_pulley };

// Contact k lies between segments k and k + 1; a loop's last one leads back to the first.
struct Link {
  LinkKind kind;
  std::size_t token;
};

struct Walk {
  std::vector<std::string> tokens;
  std::vector<std::string> segments;
  std::vector<Link> links;
  bool loop = false;

  std::string link_name(std::size_t k) const;
};

// One for each tendon; motor-side letters and hand numbers count over all of them.
std::vector<Walk> walks_of(const std::string& word);

bool is_strand(const std::string& segment);
bool is_motor_side(const std::string& segment);
int finger_of_strand(const std::string& segment);  // 0 if it is none
std::set<int> fingers_of(const std::string& word);
bool has_bearing(const std::string& word);

}  // namespace reeve::testing
