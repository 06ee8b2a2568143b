// Listed designs as JSON text, without the tree of JSON values in between: the same bytes as
// to_json (design_list.hpp) gives when printed, at a fraction of the work where a list is long.
#pragma once

#include <string>
#include <vector>

#include "reports/output/number_texts.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

class ListedDesignText {
 public:
  ListedDesignText();

  // As an entry of a list that is a member of the outermost object (json_text.hpp).
  void append(std::string& text, const ListedDesign& design);

 private:
  struct Member {
    const ObjectiveRow* row;
    std::string before;  // all that stands between the value before and this one's
  };
  struct Members {
    std::vector<Member> list;
    std::string after;
  };

  static Members members(bool hand);
  void append_objectives(std::string& text, const ObjectiveValues& values);

  Members without_hand_;
  Members with_hand_;
  NumberTexts numbers_;
};

}  // namespace reeve::reports
