// The geometry of schematics of random routings: every segment once and from contact to contact,
// nothing over anything else.
#include "reports/schematic/schematic_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "reports/schematic/schematic_measures.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve {
namespace {

struct Edge {
  Point from;
  Point to;
};

struct Item {
  std::string name;
  Box box;
};

std::string text(const Box& box) {
  return "[" + std::to_string(box.left) + ", " + std::to_string(box.top) + " – " +
         std::to_string(box.right) + ", " + std::to_string(box.bottom) + "]";
}

bool overlap(const Box& a, const Box& b) {
  constexpr double touch = 0.01;
  return a.left < b.right - touch && b.left < a.right - touch && a.top < b.bottom - touch &&
         b.top < a.bottom - touch;
}

bool same(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y) < 0.01; }

Box around(const Edge& edge, double room) {
  return {std::min(edge.from.x, edge.to.x) - room, std::min(edge.from.y, edge.to.y) - room,
          std::max(edge.from.x, edge.to.x) + room, std::max(edge.from.y, edge.to.y) + room};
}

Point between(Point a, Point b, double distance) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return {a.x + (b.x - a.x) / length * distance, a.y + (b.y - a.y) / length * distance};
}

// The straight pieces alone, or with the roundings as short chords.
std::vector<Edge> edges(const DrawnSegment& segment, bool rounded) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < segment.path.size(); ++i) {
    const Corner& corner = segment.path[i];
    if (!rounded || corner.radius == 0) {
      points.push_back(corner.at);
      continue;
    }
    const Point in = between(corner.at, segment.path[i - 1].at, corner.radius);
    const Point out = between(corner.at, segment.path[i + 1].at, corner.radius);
    const Point centre{in.x + out.x - corner.at.x, in.y + out.y - corner.at.y};
    constexpr int chords = 8;
    for (int k = 0; k <= chords; ++k) {
      const double angle = std::acos(0.0) * k / chords;
      points.push_back(
          {centre.x + (in.x - centre.x) * std::cos(angle) + (out.x - centre.x) * std::sin(angle),
           centre.y + (in.y - centre.y) * std::cos(angle) + (out.y - centre.y) * std::sin(angle)});
    }
  }
  std::vector<Edge> found;
  for (std::size_t i = 1; i < points.size(); ++i) found.push_back({points[i - 1], points[i]});
  return found;
}

std::vector<Item> texts(const SchematicLayout& layout) {
  std::vector<Item> items;
  for (const DrawnSegment& segment : layout.segments)
    items.push_back({segment.name, segment.label});
  for (const DrawnText& drawn : layout.texts) items.push_back({drawn.text, drawn.box});
  for (const DrawnText& drawn : layout.legend.texts) items.push_back({drawn.text, drawn.box});
  if (layout.motor.bottom > 0) items.push_back({"motor", layout.motor_text.box});
  return items;
}

std::vector<Item> symbols(const SchematicLayout& layout) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < layout.contacts.size(); ++i) {
    items.push_back({"contact " + std::to_string(i), bounds(layout.contacts[i])});
  }
  for (const DrawnEnd& end : layout.ends) items.push_back({"end", bounds(end)});
  for (const DrawnFinger& finger : layout.fingers) {
    if (finger.held) items.push_back({"object", finger.object});
  }
  for (const LegendItem& item : layout.legend.items) items.push_back({"legend", item.box});
  if (layout.motor.bottom > 0) items.push_back({"motor arrow", layout.motor});
  return items;
}

void expect_apart(const std::vector<Item>& some, const std::vector<Item>& others) {
  for (const Item& one : some) {
    for (const Item& other : others) {
      if (&one == &other) continue;
      EXPECT_FALSE(overlap(one.box, other.box)) << one.name << " " << text(one.box) << " lies over "
                                                << other.name << " " << text(other.box);
    }
  }
}

void expect_inside(const SchematicLayout& layout) {
  std::vector<Item> items = texts(layout);
  for (const Item& item : symbols(layout)) items.push_back(item);
  for (const DrawnSegment& segment : layout.segments) {
    for (const Edge& edge : edges(segment, false)) {
      items.push_back({segment.name, around(edge, measures::thickest / 2)});
    }
  }
  items.push_back({"hand", layout.hand});
  items.push_back({"carriage", layout.carriage});
  for (const DrawnFinger& finger : layout.fingers) items.push_back({"finger", finger.outline});
  for (const Item& item : items) {
    EXPECT_GE(item.box.left, 0) << item.name;
    EXPECT_GE(item.box.top, 0) << item.name;
    EXPECT_LE(item.box.right, layout.width) << item.name;
    EXPECT_LE(item.box.bottom, layout.height) << item.name;
  }
}

// No text and no symbol lies under a line, but for the contact that a line ends in.
void expect_lines_clear(const SchematicLayout& layout) {
  const std::vector<Item> labels = texts(layout);
  const std::vector<Item> parts = symbols(layout);
  for (const DrawnSegment& segment : layout.segments) {
    const Point front = segment.path.front().at;
    const Point back = segment.path.back().at;
    for (const Edge& edge : edges(segment, true)) {
      const Box line = around(edge, measures::thickest / 2 - 0.1);
      for (const Item& label : labels) {
        EXPECT_FALSE(overlap(line, label.box))
            << segment.name << " " << text(line) << " runs over the text " << label.name << " "
            << text(label.box);
      }
      for (const Item& part : parts) {
        const auto ends_there = [&](Point at) { return overlap(around({at, at}, 1), part.box); };
        if (ends_there(front) || ends_there(back)) continue;
        EXPECT_FALSE(overlap(line, part.box)) << segment.name << " " << text(line) << " runs over "
                                              << part.name << " " << text(part.box);
      }
    }
  }
}

// Parallel lines keep a line's width between them wherever they run side by side.
void expect_lines_apart(const SchematicLayout& layout) {
  struct Named {
    const DrawnSegment* segment;
    Edge edge;
  };
  std::vector<Named> all;
  for (const DrawnSegment& segment : layout.segments) {
    for (const Edge& edge : edges(segment, false)) {
      EXPECT_TRUE(edge.from.x == edge.to.x || edge.from.y == edge.to.y) << segment.name;
      all.push_back({&segment, edge});
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Edge& a = all[i].edge;
      const Edge& b = all[k].edge;
      if ((a.from.x == a.to.x) != (b.from.x == b.to.x)) continue;
      const bool upright = a.from.x == a.to.x;
      const Box one = around(a, 0);
      const Box other = around(b, 0);
      const double shared = upright
                                ? std::min(one.bottom, other.bottom) - std::max(one.top, other.top)
                                : std::min(one.right, other.right) - std::max(one.left, other.left);
      if (shared < 0.01) continue;
      const double apart =
          upright ? std::abs(one.left - other.left) : std::abs(one.top - other.top);
      EXPECT_GE(apart, measures::thickest) << all[i].segment->name << " " << text(one) << " and "
                                           << all[k].segment->name << " " << text(other);
    }
  }
}

void expect_roundings_fit(const SchematicLayout& layout) {
  for (const DrawnSegment& segment : layout.segments) {
    ASSERT_GE(segment.path.size(), 2U);
    EXPECT_EQ(segment.path.front().radius, 0);
    EXPECT_EQ(segment.path.back().radius, 0);
    for (std::size_t i = 1; i < segment.path.size(); ++i) {
      const Corner& a = segment.path[i - 1];
      const Corner& b = segment.path[i];
      EXPECT_LE(a.radius + b.radius, std::hypot(b.at.x - a.at.x, b.at.y - a.at.y) + 0.01)
          << segment.name;
    }
  }
}

// Where the tendon touches a contact at its middle.
Point middle_of(const DrawnContact& contact) {
  return {contact.centre.x, contact.centre.y + contact.apex * contact.radius};
}

void expect_each_segment_once(const Network& network, const SchematicLayout& layout) {
  ASSERT_EQ(layout.segments.size(), network.segments.size());
  ASSERT_EQ(layout.contacts.size(), network.contacts.size());
  std::size_t open = 0;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    EXPECT_EQ(layout.segments[i].name, segment_name(network.segments[i]));
  }
  for (const TendonSpan& tendon : network.tendons) {
    open += tendon.closed ? 0 : 2;
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const DrawnContact& contact = layout.contacts[tendon.first_contact + k];
      EXPECT_EQ(contact.kind, network.contacts[tendon.first_contact + k].kind);
      EXPECT_TRUE(same(layout.segments[left].path.back().at, middle_of(contact)));
      EXPECT_TRUE(same(layout.segments[right].path.front().at, middle_of(contact)));
      const DrawnSegment& in = layout.segments[left];
      const Point before = in.path[in.path.size() - 2].at;
      const bool forward = contact.place == ContactPlace::sheath ? before.y < contact.centre.y
                                                                 : before.x < contact.centre.x;
      EXPECT_EQ(contact.forward, forward) << in.name;
    }
  }
  ASSERT_EQ(layout.ends.size(), open);
  for (const DrawnEnd& end : layout.ends) {
    EXPECT_TRUE(std::any_of(
        layout.segments.begin(), layout.segments.end(), [&](const DrawnSegment& segment) {
          return same(segment.path.front().at, end.at) || same(segment.path.back().at, end.at);
        }));
  }
}

void expect_sound(const Routing& routing, Grasp held) {
  SCOPED_TRACE(to_word(routing) + ", held " + to_text(held));
  const Network network = expand(routing);
  const SchematicLayout drawn =
      layout(network, {to_word(routing), "held " + to_text(held), held, true, true});
  expect_each_segment_once(network, drawn);
  expect_roundings_fit(drawn);
  expect_lines_apart(drawn);
  expect_lines_clear(drawn);
  const std::vector<Item> labels = texts(drawn);
  const std::vector<Item> parts = symbols(drawn);
  expect_apart(labels, labels);
  expect_apart(labels, parts);
  expect_apart(parts, parts);
  expect_inside(drawn);
}

TEST(SchematicLayout, OfTheSevenHasNothingOverAnything) {
  for (const char* word : {"M-1-T-2-F", "M-1-T-2-M", "F-1-P-2-F", "M-1-P-2-F", "M-1-P-2-M",
                           "1-T-2-P-1", "1-P-2-P-1"}) {
    expect_sound(parse_routing(word), hold({1}));
  }
}

TEST(SchematicLayout, OfRandomRoutingsHasNothingOverAnything) {
  for (std::uint64_t seed = 1; seed <= 600 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Routing routing = testing::random_routing(dice, {1, 5, dice.chance(0.7), true});
    expect_sound(routing, testing::random_grasp(dice, finger_count(routing)));
  }
}

TEST(SchematicLayout, OfLargeHandsHasNothingOverAnything) {
  for (std::uint64_t seed = 1; seed <= 60 && !::testing::Test::HasFailure(); ++seed) {
    testing::Dice dice(seed);
    const Routing routing = testing::random_routing(dice, {8, 10, true, true});
    expect_sound(routing, testing::random_grasp(dice, finger_count(routing)));
  }
}

TEST(SchematicLayout, KeepsFarJoinsOfManyFingersApart) {
  for (const char* word : {"M-1-T-3-T-2-T-5-T-4-F", "1-T-5-P-2-B-4-T-3-P-1",
                           "M-1b-B-4-T-2-P-5-B-3b-M", "M-F", "F-F", "M-T-M", "M-P-P-F", "1-T-1",
                           "1-P-1", "M-T-B-T-1-B-T-B-F", "M-1-F+M-2-F+M-3-F+M-4-F+M-5-F"}) {
    expect_sound(parse_routing(word), {});
  }
}

// Of five fingers, at 300 pixels across.
TEST(SchematicLayout, IsReadableAtThreeHundredPixels) {
  const SchematicLayout drawn =
      layout(expand(parse_routing("M-1-T-2-T-3-P-4-B-5-F")), {"", "", hold({1}), true, true});
  EXPECT_GE(measures::text_size * 300 / drawn.width, 8);
}

TEST(SchematicLayout, LeavesRoomForEveryNameAndTension) {
  const SchematicLayout drawn =
      layout(expand(parse_routing("M-1-T-2-T-3-P-4-B-5-F")), {"", "", {}, true, true});
  for (const DrawnSegment& segment : drawn.segments) {
    for (const std::string& shown : {segment.name, std::string("0.88"), std::string("<.01")}) {
      EXPECT_LE(measures::text_width(shown, measures::text_size, shown == segment.name),
                segment.label.right - segment.label.left)
          << shown;
    }
  }
}

}  // namespace
}  // namespace reeve
