// sample_page <folder>: a page with one of everything that pages are made of, and with texts that
// must stay texts. The tests of what all pages share look at it.
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "drawing/chart/chart.hpp"
#include "drawing/schematic/schematic_svg.hpp"
#include "drawing/svg.hpp"
#include "pages/shell/page.hpp"
#include "reports/output/files.hpp"
#include "tests/support/all_floors.hpp"

namespace reeve {
namespace {

const std::vector<std::string> texts{
    "plain",
    "<img src=x onerror=\"window.stolen=1\">",
    "</script><script>window.stolen=1</script>",
    "'\"`${window.stolen=1}\\",
    "{{title}} & &amp; µ \xe2\x80\xa8",
};

// A series for each text.
chart::Chart points_chart() {
  chart::Panel panel;
  panel.x.title = "position";
  panel.y.title = texts[1];
  for (std::size_t k = 0; k < texts.size(); ++k) {
    chart::Points points;
    for (std::size_t i = k; i < 12; i += texts.size()) {
      const auto y = static_cast<double>((i * 5) % 12);
      points.spots.push_back({static_cast<double>(i), y, texts[k], k == 2 ? texts[k] : ""});
    }
    panel.layers.push_back(
        {texts[k], {chart::series_colour(k), chart::series_symbol(k), 4.5}, points});
  }
  chart::Chart chart;
  chart.alt = "Twelve points, none on a line: " + texts[1];
  chart.height = 240;
  chart.panels.push_back(panel);
  return chart;
}

std::string drawn_routing(const std::string& word) {
  const Network network = expand(parse_routing(word));
  const Grasp grasp = hold({1});
  const TensionState state = tensions(network, mechanics(network, Hardware{}), grasp);
  return schematic_svg(schematic(network, word, GraspView{grasp, Direction::pull, state}), "drawn");
}

// The numbers are not in order as texts: 10 < 9 there.
std::string table() {
  std::string rows;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string number = std::to_string((i * 7 + 3) % 11);
    rows += "<tr><th scope=\"row\" class=\"left\">" + svg::escape(texts[i]) + "</th><td>" + number +
            "</td><td data-value=\"" + std::to_string(texts.size() - i) + "\">no. " +
            std::to_string(i) + "</td></tr>\n";
  }
  return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Texts\">\n"
         "<table class=\"sortable\" id=\"texts\"><caption>Texts and numbers</caption>\n"
         "<thead><tr><th scope=\"col\" class=\"left\">text</th><th scope=\"col\">number</th>"
         "<th scope=\"col\">ordered by what is not seen</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table>\n</div>\n";
}

std::string sample() {
  const Figure points{"points", texts[2], texts[3], chart_svg(points_chart())};
  const std::string body = "<h1>Sample</h1>\n<h2>Chart</h2>\n" + figure_html(points) +
                           "<h2>Table</h2>\n" + table() + "<h2>Schematic</h2>\n" +
                           schematic_html("routing", drawn_routing("M-1-P-2-M"));
  return page_html({"Sample " + texts[2], body, "", {{"texts", texts}}});
}

}  // namespace
}  // namespace reeve

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "usage: sample_page <folder>\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = words[1];
    reeve::prepare_directory(folder, "folder");
    reeve::write_file(folder / "index.html", reeve::sample());
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
