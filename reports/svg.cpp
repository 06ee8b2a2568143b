#include "reports/svg.hpp"

#include <fmt/format.h>

#include <cmath>

namespace reeve::svg {
namespace {

Point step(Point from, Point to, double length) {
  const double distance = std::hypot(to.x - from.x, to.y - from.y);
  if (distance == 0) return from;
  return {from.x + (to.x - from.x) / distance * length,
          from.y + (to.y - from.y) / distance * length};
}

}  // namespace

std::string escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return escaped;
}

std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string line(Point from, Point to) { return path(move_to(from) + line_to(to)); }

std::string circle(Point centre, double radius, const std::string& attributes) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(centre.x),
                     number(centre.y), number(radius), attributes);
}

std::string rectangle(const Box& box, double rounding, const std::string& attributes) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"{}/>\n",
                     number(box.left), number(box.top), number(box.right - box.left),
                     number(box.bottom - box.top), number(rounding), attributes);
}

std::string path(const std::string& commands, const std::string& attributes) {
  return fmt::format("<path d=\"{}\"{}/>\n", commands, attributes);
}

std::string group(const std::string& attributes, const std::string& content) {
  return content.empty() ? "" : fmt::format("<g{}>\n{}</g>\n", attributes, content);
}

std::string text(const DrawnText& text) {
  const double baseline = (text.box.top + text.box.bottom) / 2 + 0.36 * text.size;
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}>{}</text>\n",
                     number(anchor(text.box, text.align)), number(baseline), number(text.size),
                     anchor(text.align), text.weight == Weight::bold ? " font-weight=\"bold\"" : "",
                     escape(text.text));
}

double anchor(const Box& box, Align align) {
  switch (align) {
    case Align::start:
      return box.left;
    case Align::middle:
      return (box.left + box.right) / 2;
    case Align::end:
      return box.right;
  }
  return box.left;
}

const char* anchor(Align align) {
  switch (align) {
    case Align::start:
      return "";
    case Align::middle:
      return " text-anchor=\"middle\"";
    case Align::end:
      return " text-anchor=\"end\"";
  }
  return "";
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

std::string move_to(Point at) { return fmt::format("M{} {}", number(at.x), number(at.y)); }

std::string line_to(Point at) { return fmt::format("L{} {}", number(at.x), number(at.y)); }

std::string arc_to(Point at, double radius, bool clockwise) {
  return fmt::format("A{0} {0} 0 0 {1} {2} {3}", number(radius), clockwise ? 1 : 0, number(at.x),
                     number(at.y));
}

}  // namespace reeve::svg
