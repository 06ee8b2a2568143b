// Medians, bands and places of designs under uncertainty, and the most robust design: as text,
// table, CSV and JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// "0.961–0.993", "-1.20 to 0.35", "38.0 or more"; "" where the band is no wider than the last
// decimal.
std::string range_text(const Band& band, int decimals);

// "0.985 (0.961–0.993)"; the median alone where the band is no wider than the last decimal.
std::string band_text(const Band& band, int decimals);

// "100.0 %", or how much of it is shared: "100.0 %, shared", "64.0 %, 12.0 % shared".
std::string first_share_text(const RankDistribution& ranks);

// Rank, name, word, these objectives with their bands, and how the place is spread.
Table band_table(const std::vector<ListedDesign>& designs,
                 const std::vector<Objective>& objectives);

// The ranked objectives of the lines that are shown. Nothing where nothing was drawn.
Section band_section(const std::vector<ListedDesign>& shown, const Order& order,
                     const UncertaintyOptions& options);

// True unless all contacts of the kind have friction coefficients of their own in these designs.
bool is_drawn(ContactKind kind, const Hardware& hardware, const std::vector<ListedDesign>& designs);

// Lists the designs that share the first place, if that says more than that bearings change
// nothing. Without draws it lists them only if other designs do.
std::vector<DocumentLine> shared_first_lines(const std::vector<ListedDesign>& designs);

// ",uniformity_mean_median,uniformity_mean_p5,uniformity_mean_p95,…" and ",0.98,0.97,0.99,…".
std::string band_headings(const Bands& bands);
std::string band_cells(const Bands& bands);

// {"uniformity_mean":{"median","p5","p95"},…}
Json bands_json(const Bands& bands);

// Returns no lines if there is no most robust design.
std::vector<DocumentLine> robust_lines(const std::optional<RobustFirst>& first);

Json robust_json(const std::optional<RobustFirst>& first);

}  // namespace reeve::reports
