#include "tests/support/read_chart.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

namespace reeve::testing {
namespace {

using Attributes = std::map<std::string, std::string>;

struct Tag {
  std::string name;  // "" at the end; "/g" for an end tag
  Attributes attributes;
  bool is_empty = false;
  std::string text;  // up to the next tag
};

std::string unescaped(std::string text) {
  const std::pair<const char*, const char*> entities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
  for (const auto& [entity, character] : entities) {
    const std::string name = entity;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      text.replace(at, name.size(), character);
    }
  }
  return text;
}

class Tags {
 public:
  explicit Tags(const std::string& svg) : svg_(svg) {}

  Tag next() {
    const std::size_t begin = svg_.find('<', at_);
    if (begin == std::string::npos) return {};
    const std::size_t end = svg_.find('>', begin);
    const std::size_t after = std::min(svg_.find('<', end), svg_.size());
    at_ = after;
    Tag tag;
    std::string inside = svg_.substr(begin + 1, end - begin - 1);
    tag.is_empty = inside.back() == '/';
    tag.name = inside.substr(0, inside.find_first_of(" /", 1));
    for (std::size_t at = inside.find('='); at != std::string::npos; at = inside.find('=', at)) {
      const std::size_t name = inside.rfind(' ', at) + 1;
      const std::size_t close = inside.find('"', at + 2);
      tag.attributes[inside.substr(name, at - name)] =
          unescaped(inside.substr(at + 2, close - at - 2));
      at = close;
    }
    tag.text = unescaped(svg_.substr(end + 1, after - end - 1));
    return tag;
  }

 private:
  const std::string& svg_;
  std::size_t at_ = 0;
};

double number(const Attributes& attributes, const char* name) {
  return std::stod(attributes.at(name));
}

// Of absolute commands: the middle of the corners of a closed path, which symbols have, and of the
// box round a line.
ReadMark of_path(const std::string& commands) {
  std::string plain = commands;
  for (char& c : plain) {
    if (std::string("MLZA").find(c) != std::string::npos) c = ' ';
  }
  std::istringstream in(plain);
  std::vector<double> x;
  std::vector<double> y;
  double number = 0;
  while (in >> number) (x.size() == y.size() ? x : y).push_back(number);
  const auto mean = [](const std::vector<double>& numbers) {
    double sum = 0;
    for (const double each : numbers) sum += each;
    return sum / static_cast<double>(numbers.size());
  };
  const auto middle = [](const std::vector<double>& numbers) {
    const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
    return (*low + *high) / 2;
  };
  const double bottom = *std::max_element(y.begin(), y.end());
  if (commands.back() == 'Z') return {mean(x), mean(y), bottom, ""};
  return {middle(x), middle(y), bottom, ""};
}

ReadMark read_mark(const Tag& tag) {
  if (tag.name == "circle") {
    return {number(tag.attributes, "cx"), number(tag.attributes, "cy"), 0, ""};
  }
  if (tag.name == "rect") {
    const double y = number(tag.attributes, "y");
    return {number(tag.attributes, "x") + number(tag.attributes, "width") / 2, y,
            y + number(tag.attributes, "height"), ""};
  }
  return of_path(tag.attributes.at("d"));
}

double value(std::string text) {
  const std::size_t minus = text.find("\xe2\x88\x92");
  if (minus != std::string::npos) text.replace(minus, 3, "-");
  const double number = std::stod(text);
  return text.ends_with("%") ? number / 100 : number;
}

double along(const std::vector<ReadTick>& ticks, double at) {
  if (ticks.size() < 2) throw std::runtime_error("fewer than two ticks");
  const ReadTick& a = ticks.front();
  const ReadTick& b = ticks.back();
  return value(a.text) + (at - a.at) / (b.at - a.at) * (value(b.text) - value(a.text));
}

// Ticks at the y axis are texts that end there; those at the x axis are centred below the frame.
// What is turned, bold or larger is a title.
void sort_in(const Tag& tag, ReadPanel& panel) {
  panel.texts.push_back(tag.text);
  if (!tag.attributes.contains("x") || tag.attributes.at("font-size") != "12") return;
  const double x = number(tag.attributes, "x");
  const double y = number(tag.attributes, "y") - 0.36 * 12;
  const bool ends = tag.attributes.contains("text-anchor");
  if (ends && tag.attributes.at("text-anchor") == "end") panel.y.push_back({y, tag.text});
  if (ends && tag.attributes.at("text-anchor") == "middle") panel.x.push_back({x, tag.text});
}

class Reader {
 public:
  std::vector<ReadPanel> read(const std::string& svg) {
    Tags tags(svg);
    for (Tag tag = tags.next(); !tag.name.empty(); tag = tags.next()) take(tag);
    return std::move(panels_);
  }

 private:
  void take(const Tag& tag) {
    if (tag.name == "g" && !tag.is_empty) {
      open_.push_back(tag.attributes.contains("class") ? tag.attributes.at("class") : "");
      begin_group(tag);
    } else if (tag.name == "/g") {
      open_.pop_back();
    } else if (!panels_.empty() && !open_.empty()) {
      add(tag);
    }
  }

  void begin_group(const Tag& tag) {
    const std::string& name = open_.back();
    if (name == "reeve-panel") panels_.emplace_back();
    if (open_.size() != 2 || name == "reeve-axes" || name == "reeve-labels") return;
    ReadGroup group;
    group.kind = name.substr(6, name.find(' ') - 6);
    if (tag.attributes.contains("data-series")) group.series = tag.attributes.at("data-series");
    for (const auto& [key, given] : tag.attributes) group.attributes += key + "=" + given + ";";
    if (open_.front() == "reeve-panel") panels_.back().groups.push_back(group);
  }

  void add(const Tag& tag) {
    ReadPanel& panel = panels_.back();
    if (open_.front() != "reeve-panel") return;
    if (open_.size() == 1 && tag.name == "rect") {
      panel.top = number(tag.attributes, "y");
      panel.bottom = panel.top + number(tag.attributes, "height");
    } else if (open_.back() == "reeve-axes" && tag.name == "text") {
      sort_in(tag, panel);
    } else if (open_.back() == "reeve-labels" && tag.name == "text") {
      panel.texts.push_back(tag.text);
    } else if (open_.size() == 2 && open_.back().starts_with("reeve-") && !panel.groups.empty()) {
      std::vector<ReadMark>& marks = panel.groups.back().marks;
      const bool is_mark = tag.name == "circle" || tag.name == "rect" || tag.name == "path";
      if (is_mark && open_.back() != "reeve-axes") marks.push_back(read_mark(tag));
      if (tag.name == "title" && !marks.empty()) marks.back().title = tag.text;
    }
  }

  std::vector<std::string> open_;  // classes of the groups around
  std::vector<ReadPanel> panels_;
};

}  // namespace

double ReadPanel::x_of(const ReadMark& mark) const { return along(x, mark.x); }

double ReadPanel::y_of(const ReadMark& mark) const { return along(y, mark.y); }

std::string ReadPanel::category_of(const ReadMark& mark) const {
  const auto nearest = std::min_element(x.begin(), x.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.at - mark.x) < std::abs(b.at - mark.x);
  });
  return nearest == x.end() ? "" : nearest->text;
}

std::vector<ReadMark> ReadPanel::marks(const std::string& kind, const std::string& series) const {
  std::vector<ReadMark> found;
  for (const ReadGroup& group : groups) {
    if (group.kind != kind || (!series.empty() && group.series != series)) continue;
    found.insert(found.end(), group.marks.begin(), group.marks.end());
  }
  return found;
}

std::vector<ReadPanel> read_chart(const std::string& svg) {
  std::vector<ReadPanel> panels = Reader().read(svg);
  for (std::size_t i = 1; i < panels.size(); ++i) {
    if (!panels[i].y.empty()) continue;
    panels[i].y = panels[i - 1].y;
    for (ReadTick& tick : panels[i].y) tick.at += panels[i].top - panels[i - 1].top;
  }
  return panels;
}

}  // namespace reeve::testing
