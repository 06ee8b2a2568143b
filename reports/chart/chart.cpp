#include "reports/chart/chart.hpp"

namespace reeve::reports::chart {

Colour series_colour(std::size_t i) { return static_cast<Colour>(i % 7); }

Symbol series_symbol(std::size_t i) { return static_cast<Symbol>(i % 6); }

}  // namespace reeve::reports::chart
