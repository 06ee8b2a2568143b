// The shipped publications checked, and copies of them with a word changed.
#pragma once

#include <stdexcept>
#include <string>

#include "reports/check_report.hpp"
#include "studies/catalogue_check.hpp"
#include "tests/studies/shipped_catalogue.hpp"
#include "tests/support/edited_catalogue.hpp"

namespace reeve::testing {

struct Edited : EditedCatalogue {
  using EditedCatalogue::EditedCatalogue;

  CheckReport check() const {
    return check_all(read_catalogue(path()), CatalogueFiles::in(path()));
  }
  std::string error() const {
    return folder().error_of([&] { check(); });
  }
};

inline const CheckReport& shipped() {
  static const CheckReport report =
      check_all(shipped_catalogue(), CatalogueFiles::in(shipped_folder));
  return report;
}

inline const CheckItem& item(const CheckReport& report, const std::string& routing,
                             CheckedQuantity quantity) {
  for (const CheckItem& item : report.items) {
    if (item.routing == routing && item.quantity == quantity) return item;
  }
  throw std::runtime_error("no item " + routing + " " + quantity_text(quantity));
}

inline constexpr CheckedQuantity balance{CheckedKind::indicator, 2};
inline constexpr CheckedQuantity efficiency{CheckedKind::indicator, 4};
inline constexpr CheckedQuantity mean{CheckedKind::indicator_mean, 0};

}  // namespace reeve::testing
