#include "drawing/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace reeve::drawing::svg {
namespace {

Point step(Point from, Point to, double length) {
  const double distance = std::hypot(to.x - from.x, to.y - from.y);
  if (distance == 0) return from;
  return {from.x + (to.x - from.x) / distance * length,
          from.y + (to.y - from.y) / distance * length};
}

std::string command(char letter, Point at) {
  std::string text(1, letter);
  text += number(at.x);
  text += ' ';
  text += number(at.y);
  return text;
}

}  // namespace

std::string escape(const std::string& text) {
  static constexpr std::array<std::pair<char, const char*>, 5> entities{
      {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};
  std::string escaped;
  for (const char c : text) {
    const auto* const found =
        std::ranges::find_if(entities, [&](const auto& entity) { return entity.first == c; });
    if (found != entities.end()) {
      escaped += found->second;
    } else {
      escaped += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return escaped;
}

// A page has millions of these, and nearly all of them are small.
std::string number(double value) {
  const double hundredths = std::nearbyint(value * 100);
  if (!(std::abs(hundredths) < 1e15)) return fmt::format("{:.0f}", value);
  auto rest = static_cast<long long>(std::abs(hundredths));
  std::array<char, 24> digits;
  char* const end = digits.data() + digits.size();
  char* at = end;
  if (rest % 100 != 0) {
    if (rest % 10 != 0) *--at = static_cast<char>('0' + rest % 10);
    *--at = static_cast<char>('0' + rest / 10 % 10);
    *--at = '.';
  }
  rest /= 100;
  do {
    *--at = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest > 0);
  if (hundredths < 0) *--at = '-';
  return {at, end};
}

std::string attribute(const char* name, const std::string& value) {
  std::string text(" ");
  text += name;
  text += "=\"";
  text += value;
  text += '"';
  return text;
}

std::string line(Point from, Point to) { return path(move_to(from) + line_to(to)); }

std::string circle(Point centre, double radius, const std::string& attributes) {
  return "<circle" + attribute("cx", number(centre.x)) + attribute("cy", number(centre.y)) +
         attribute("r", number(radius)) + attributes + "/>\n";
}

std::string rectangle(const Box& box, double rounding, const std::string& attributes) {
  return "<rect" + attribute("x", number(box.left)) + attribute("y", number(box.top)) +
         attribute("width", number(box.right - box.left)) +
         attribute("height", number(box.bottom - box.top)) + attribute("rx", number(rounding)) +
         attributes + "/>\n";
}

std::string path(const std::string& commands, const std::string& attributes) {
  return "<path" + attribute("d", commands) + attributes + "/>\n";
}

std::string group(const std::string& attributes, const std::string& content) {
  return content.empty() ? "" : "<g" + attributes + ">\n" + content + "</g>\n";
}

std::string text(const DrawnText& text) {
  const double baseline = (text.box.top + text.box.bottom) / 2 + 0.36 * text.size;
  return "<text" + attribute("x", number(anchor(text.box, text.align))) +
         attribute("y", number(baseline)) + attribute("font-size", number(text.size)) +
         anchor(text.align) + (text.weight == Weight::bold ? " font-weight=\"bold\"" : "") + ">" +
         escape(text.text) + "</text>\n";
}

double anchor(const Box& box, Align align) {
  if (align == Align::middle) return (box.left + box.right) / 2;
  return align == Align::start ? box.left : box.right;
}

const char* anchor(Align align) {
  if (align == Align::middle) return " text-anchor=\"middle\"";
  return align == Align::start ? "" : " text-anchor=\"end\"";
}

std::string rounded(const std::vector<Corner>& path) {
  if (path.empty()) return "";
  std::string commands = move_to(path.front().at);
  Point last = path.front().at;
  const auto draw_to = [&](Point at) {
    if (at.x != last.x || at.y != last.y) commands += line_to(at);
    last = at;
  };
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Point before = path[i - 1].at;
    const Point at = path[i].at;
    const Point after = path[i + 1].at;
    const double radius = path[i].radius;
    const double turn = (at.x - before.x) * (after.y - at.y) - (at.y - before.y) * (after.x - at.x);
    draw_to(step(at, before, radius));
    last = step(at, after, radius);
    if (radius > 0) commands += arc_to(last, radius, turn > 0);
  }
  draw_to(path.back().at);
  return commands;
}

std::string move_to(Point at) { return command('M', at); }

std::string line_to(Point at) { return command('L', at); }

std::string arc_to(Point at, double radius, bool clockwise) {
  const std::string size = number(radius);
  return "A" + size + " " + size + " 0 0 " + (clockwise ? "1 " : "0 ") + number(at.x) + " " +
         number(at.y);
}

}  // namespace reeve::drawing::svg
