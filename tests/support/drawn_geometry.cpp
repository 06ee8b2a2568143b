#include "tests/support/drawn_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "drawing/schematic/schematic_layout.hpp"
#include "drawing/schematic/schematic_measures.hpp"
#include "tests/support/drawn_lines.hpp"

namespace reeve::testing {
namespace {

using namespace measures;

// What a symbol covers.
Box bounds(const DrawnContact& contact) {
  const Point& at = contact.centre;
  if (contact.place == ContactPlace::sheath) {
    constexpr double ferrule = sleeve + 2;
    constexpr double arrow = sleeve + 13;
    const bool right = contact.arrow_side > 0;
    return {at.x - (right ? ferrule : arrow), at.y - contact.length / 2,
            at.x + (right ? arrow : ferrule), at.y + contact.length / 2};
  }
  const bool wheel = contact.kind == ContactKind::bearing || contact.kind == ContactKind::block;
  const double reach = contact.radius + (wheel ? thickest / 2 : sleeve);
  const double inner = wheel ? contact.radius - thickest / 2 : 4;
  return {at.x - reach, at.y - (contact.apex > 0 ? inner : reach), at.x + reach,
          at.y + (contact.apex > 0 ? reach : inner)};
}

Box bounds(const DrawnEnd& end) {
  if (end.hold != EndHold::fixed) {
    return {end.at.x - knot_size / 2, end.at.y - knot_size / 2, end.at.x + knot_size / 2,
            end.at.y + knot_size / 2};
  }
  const double deep = end.away * fixation_depth;
  return {end.at.x - fixation_width / 2, end.at.y + std::min(0.0, deep),
          end.at.x + fixation_width / 2, end.at.y + std::max(0.0, deep)};
}

std::vector<Box> bounds(const DrawnBlock& block) {
  std::vector<Box> found;
  Box beam{block.tails.front().x, block.beam, block.tails.front().x, block.beam};
  const auto widen = [&](const Point& at) {
    beam.left = std::min(beam.left, at.x);
    beam.right = std::max(beam.right, at.x);
  };
  const auto add = [&](const Point& at, double half, double to) {
    found.push_back(
        {at.x - half, std::min(at.y - half, to), at.x + half, std::max(at.y + half, to)});
    widen(at);
  };
  for (const Point& axle : block.axles) add(axle, block.sheave, block.beam);
  for (const Point& eye : block.eyes) add(eye, eye_radius, block.beam);
  for (const Point& tail : block.tails) add(tail, eye_radius, block.beam);
  const double half = block.is_bar ? bar_half : beam_half;
  found.push_back({beam.left - half, beam.top - half, beam.right + half, beam.bottom + half});
  found.push_back(block.motion);
  return found;
}

std::vector<Item> texts(const SchematicLayout& layout) {
  std::vector<Item> items;
  for (const DrawnSegment& segment : layout.segments)
    items.push_back({segment.name, segment.label});
  for (const DrawnText& drawn : layout.texts) items.push_back({drawn.text, drawn.box});
  for (const DrawnText& drawn : layout.legend.texts) items.push_back({drawn.text, drawn.box});
  for (const DrawnCarriage& carriage : layout.carriages) {
    items.push_back({"motor " + std::to_string(carriage.motor), carriage.text.box});
  }
  return items;
}

std::vector<Item> symbols(const SchematicLayout& layout) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < layout.contacts.size(); ++i) {
    if (layout.contacts[i].place == ContactPlace::block) continue;
    items.push_back({"contact " + std::to_string(i), bounds(layout.contacts[i])});
  }
  for (std::size_t i = 0; i < layout.blocks.size(); ++i) {
    for (const Box& box : bounds(layout.blocks[i])) {
      items.push_back({"block " + std::to_string(i), box});
    }
  }
  for (std::size_t i = 0; i < layout.ends.size(); ++i) {
    if (layout.ends[i].hold == EndHold::block) continue;
    items.push_back({"end " + std::to_string(i), bounds(layout.ends[i])});
  }
  for (std::size_t i = 0; i < layout.fingers.size(); ++i) {
    if (!layout.fingers[i].held) continue;
    items.push_back({"object " + std::to_string(i), layout.fingers[i].object});
  }
  for (std::size_t i = 0; i < layout.legend.items.size(); ++i) {
    items.push_back({"legend " + std::to_string(i), layout.legend.items[i].box});
  }
  for (const DrawnCarriage& carriage : layout.carriages) {
    items.push_back({"motor arrow", carriage.arrow});
  }
  return items;
}

void expect_apart(const std::vector<Item>& some, const std::vector<Item>& others) {
  for (const Item& one : some) {
    for (const Item& other : others) {
      if (&one == &other || (one.name == other.name && one.name.starts_with("block"))) continue;
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
      items.push_back({segment.name, around(edge, thickest / 2)});
    }
  }
  items.push_back({"hand", layout.hand});
  for (const DrawnCarriage& carriage : layout.carriages) {
    items.push_back({"carriage", carriage.box});
  }
  for (const DrawnFinger& finger : layout.fingers) items.push_back({"finger", finger.outline});
  for (const Item& item : items) {
    EXPECT_GE(item.box.left, 0) << item.name;
    EXPECT_GE(item.box.top, 0) << item.name;
    EXPECT_LE(item.box.right, layout.width) << item.name;
    EXPECT_LE(item.box.bottom, layout.height) << item.name;
  }
}

// A line that ends at one part of a block may run over its other parts.
bool ends_at(Point at, const Item& item, const std::vector<Item>& parts) {
  return std::any_of(parts.begin(), parts.end(), [&](const Item& part) {
    return part.name == item.name && overlap(around({at, at}, 1), part.box);
  });
}

// No text and no symbol lies under a line, but for the contact that a line ends in.
void expect_lines_clear(const SchematicLayout& layout) {
  const std::vector<Item> labels = texts(layout);
  const std::vector<Item> parts = symbols(layout);
  for (const DrawnSegment& segment : layout.segments) {
    const Point front = segment.path.front().at;
    const Point back = segment.path.back().at;
    for (const Edge& edge : edges(segment, true)) {
      const Box line = around(edge, thickest / 2 - 0.1);
      for (const Item& label : labels) {
        EXPECT_FALSE(overlap(line, label.box))
            << segment.name << " " << text(line) << " runs over the text " << label.name << " "
            << text(label.box);
      }
      for (const Item& part : parts) {
        const auto ends_there = [&](Point at) { return ends_at(at, part, parts); };
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
      EXPECT_GE(apart, thickest) << all[i].segment->name << " " << text(one) << " and "
                                 << all[k].segment->name << " " << text(other);
    }
  }
}

// A line comes to its block straight from its lane, and nowhere else near it.
void expect_blocks_clear(const SchematicLayout& layout) {
  for (const DrawnSegment& segment : layout.segments) {
    const std::vector<Edge> straight = edges(segment, false);
    for (std::size_t i = 0; i < straight.size(); ++i) {
      if (straight[i].from.y != straight[i].to.y) continue;
      const bool half_turn = i == 0 || i + 1 == straight.size();
      if (half_turn) continue;
      for (const DrawnBlock& block : layout.blocks) {
        for (const Box& box : bounds(block)) {
          EXPECT_FALSE(overlap(around(straight[i], thickest / 2), box)) << segment.name;
        }
      }
    }
  }
}

// Lines that cross do so away from the bends of both.
void expect_crossings_clear(const SchematicLayout& layout) {
  for_each_meeting(layout, [](const DrawnSegment& one, const DrawnSegment& other, double inside) {
    EXPECT_TRUE(inside < -thickest + 0.01 || inside > measures::bend - 0.01)
        << one.name << " ends on " << other.name;
  });
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
Point median(const DrawnContact& contact) {
  return {contact.centre.x, contact.centre.y + contact.apex * contact.radius};
}

void expect_at_arms(const DrawnBlock& bar, Point left, Point right) {
  ASSERT_EQ(bar.eyes.size(), 2U);
  const bool first_left = same(bar.eyes[0], left) && same(bar.eyes[1], right);
  const bool first_right = same(bar.eyes[0], right) && same(bar.eyes[1], left);
  EXPECT_TRUE(first_left || first_right);
}

// As many sheaves, eyes and tails as tokens of the block; the tails on the side where the passing
// tendons turn, the beckets beside the sheaves.
void expect_whole_blocks(const Network& network, const SchematicLayout& layout) {
  ASSERT_EQ(layout.blocks.size(), network.blocks.size());
  std::vector<std::size_t> passes(network.blocks.size(), 0);
  std::vector<std::size_t> tails(network.blocks.size(), 0);
  std::vector<std::size_t> beckets(network.blocks.size(), 0);
  for (const Contact& contact : network.contacts) {
    if (contact.block != no_block) ++passes[contact.block];
  }
  for (const TendonSpan& tendon : network.tendons) {
    for (const TendonEnd& end : {tendon.left, tendon.right}) {
      if (end.tie != EndTie::none) ++(end.tie == EndTie::tail ? tails : beckets)[end.block];
    }
  }
  for (std::size_t i = 0; i < network.blocks.size(); ++i) {
    const DrawnBlock& block = layout.blocks[i];
    EXPECT_EQ(block.is_bar, network.blocks[i].is_bar);
    EXPECT_EQ(block.axles.size(), block.is_bar ? 0 : passes[i]);
    EXPECT_EQ(block.eyes.size(), block.is_bar ? 2 : beckets[i]);
    EXPECT_EQ(block.tails.size(), tails[i]);
    for (std::size_t k = 0; k < network.contacts.size(); ++k) {
      if (network.contacts[k].block != i || block.is_bar) continue;
      EXPECT_EQ(layout.contacts[k].apex, block.apex);
    }
    for (const Point& tail : block.tails) {
      for (const Point& axle : block.axles) EXPECT_GT((tail.y - axle.y) * block.apex, block.sheave);
      for (const Point& eye : block.eyes) EXPECT_GE((tail.y - eye.y) * block.apex, 0);
    }
  }
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
      if (contact.kind == ContactKind::bar) {
        expect_at_arms(layout.blocks[network.contacts[tendon.first_contact + k].block],
                       layout.segments[left].path.back().at,
                       layout.segments[right].path.front().at);
        continue;
      }
      EXPECT_TRUE(same(layout.segments[left].path.back().at, median(contact)));
      EXPECT_TRUE(same(layout.segments[right].path.front().at, median(contact)));
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

}  // namespace

void expect_sound(const Routing& routing, Grasp held) {
  SCOPED_TRACE(to_word(routing) + ", held " + to_text(held));
  const Network network = expand(routing);
  const SchematicLayout drawn =
      layout(network, {to_word(routing), "held " + to_text(held), held, true, true});
  expect_each_segment_once(network, drawn);
  expect_whole_blocks(network, drawn);
  expect_roundings_fit(drawn);
  expect_lines_apart(drawn);
  expect_lines_clear(drawn);
  expect_blocks_clear(drawn);
  if (!drawn.blocks.empty()) expect_crossings_clear(drawn);
  const std::vector<Item> labels = texts(drawn);
  const std::vector<Item> parts = symbols(drawn);
  expect_apart(labels, labels);
  expect_apart(labels, parts);
  expect_apart(parts, parts);
  expect_inside(drawn);
}

}  // namespace reeve::testing
