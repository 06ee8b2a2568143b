#include "drawing/chart/chart.hpp"

namespace reeve::drawing::chart {

Colour series_colour(std::size_t i) { return static_cast<Colour>(i % 7); }

Symbol series_symbol(std::size_t i) { return static_cast<Symbol>(i % 6); }

}  // namespace reeve::drawing::chart
