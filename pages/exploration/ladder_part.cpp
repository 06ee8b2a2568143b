#include "pages/exploration/ladder_part.hpp"

#include "pages/shell/glossary.hpp"
#include "pages/shell/html_table.hpp"
#include "pages/shell/template.hpp"
#include "reports/exploration/ladder_report.hpp"

namespace reeve::pages {

std::string ladder_html(const ListedLadder& ladder) {
  const Section section = ladder_section(ladder);
  if (!section.table) return "";
  return render("ladder.mustache",
                {{"title", section.title},
                 {"table", html({"ladder-table",
                                 "Gains over the line above; kept of the first in what loses most.",
                                 *section.table})},
                 {"glossary", glossary_html("Gain, kept, knee: what they mean", ladder_terms())}});
}

}  // namespace reeve::pages
