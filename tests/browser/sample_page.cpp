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
#include "core/tension.hpp"
#include "pages/page.hpp"
#include "pages/template.hpp"
#include "reports/files.hpp"
#include "reports/schematic_svg.hpp"
#include "reports/svg.hpp"

namespace reeve {
namespace {

const std::vector<std::string> texts{
    "plain",
    "<img src=x onerror=\"window.stolen=1\">",
    "</script><script>window.stolen=1</script>",
    "'\"`${window.stolen=1}\\",
    "{{title}} & &amp; µ \xe2\x80\xa8",
};

Json chart_spec() {
  Json values = Json::array();
  for (std::size_t i = 0; i < 12; ++i) {
    values.push_back({{"x", i}, {"y", (i * 5) % 12}, {"name", texts[i % texts.size()]}});
  }
  return {{"data", {{"values", values}}},
          {"mark", {{"type", "point"}, {"filled", true}, {"size", 80}}},
          {"width", "container"},
          {"height", 240},
          {"encoding",
           {{"x", {{"field", "x"}, {"type", "quantitative"}, {"title", "position"}}},
            {"y", {{"field", "y"}, {"type", "quantitative"}, {"title", texts[1]}}},
            {"shape", {{"field", "name"}, {"type", "nominal"}, {"title", "text"}}},
            {"color", {{"field", "name"}, {"type", "nominal"}}},
            {"tooltip", Json::array({{{"field", "name"}, {"type", "nominal"}}})}}}};
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
  const Figure points = figure({"points", texts[2], texts[3],
                                "Twelve points, none on a line: " + texts[1], chart_spec(), ""});
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
