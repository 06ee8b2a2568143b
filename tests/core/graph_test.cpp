#include "core/graph.hpp"

#include <boost/graph/graph_traits.hpp>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "core/network_graph.hpp"
#include "tests/core/network_of.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

using testing::network_of;

std::vector<std::string> lines_with(const std::string& text, const std::string& part) {
  std::vector<std::string> found;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    if (line.find(part) != std::string::npos) found.push_back(line);
    begin = end + 1;
  }
  return found;
}

TEST(Graph, HasAVertexForEachSegmentAndAnEdgeForEachContact) {
  const Network net = network_of("M-1-T-2-M+3-P-3");
  const NetworkGraph g = graph(net);
  ASSERT_EQ(boost::num_vertices(g), net.segments.size());
  EXPECT_EQ(boost::num_edges(g), net.contacts.size());
  for (std::size_t i = 0; i < net.segments.size(); ++i) {
    EXPECT_EQ(segment_name(g[i]), segment_name(net.segments[i]));
  }
}

TEST(Graph, EdgesJoinTheNeighboursOfTheirContact) {
  const Network net = network_of("1-T-1");  // two segments, joined twice
  const NetworkGraph g = graph(net);
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> ends;  // by contact: left, right
  for (const auto& edge : boost::make_iterator_range(boost::edges(g))) {
    const std::size_t left = g[edge].left;
    const bool forward = boost::source(edge, g) == left;
    ends[g[edge].index] = {left, forward ? boost::target(edge, g) : boost::source(edge, g)};
  }
  EXPECT_EQ(ends.at(0), std::make_pair(std::size_t{0}, std::size_t{1}));
  EXPECT_EQ(ends.at(1), std::make_pair(std::size_t{1}, std::size_t{0}));
}

TEST(Graph, ItsConnectedComponentsAreTheTendons) {
  for (const char* word :
       {"M-1-T-2-F", "1-P-2-P-1+M-3-F", "M-1-F+M-2-F+3-P-4-B-3+M-F", "F-F+M-1-F"}) {
    const Network net = network_of(word);
    const std::vector<std::size_t> component = tendons(graph(net));
    ASSERT_EQ(component.size(), net.segments.size());
    for (std::size_t t = 0; t < net.tendons.size(); ++t) {
      for (std::size_t i = 0; i < net.tendons[t].segments; ++i) {
        EXPECT_EQ(component[net.tendons[t].first_segment + i], t) << word;
      }
    }
  }
}

TEST(Graph, NamesTheTendonThatHangsOnNoMotor) {
  const auto message = [](const std::string& word) {
    return testing::input_error([&] { require_actuated(network_of(word), word); });
  };
  EXPECT_EQ(message("M-1-F+F-2-T-3-F"),
            "routing 'M-1-F+F-2-T-3-F': the tendon with T3 is not actuated: it has no M and no P, "
            "so the motor cannot pull it");
  EXPECT_EQ(message("1-B-1"),
            "routing '1-B-1': the tendon with T2 is not actuated: it has no M and no P, so the "
            "motor cannot pull it");
  EXPECT_EQ(message("F-1-P-2-F+M-3-F"), "no such error was thrown");
}

TEST(Dot, HoldsEverySegmentAndEveryContactOnce) {
  const Network net = network_of("M-1-T-2b-P-T-B-3-F+4-P-4");
  const std::string dot = to_dot(net, "title");
  for (const Segment& segment : net.segments) {
    EXPECT_EQ(lines_with(dot, "[label=\"" + segment_name(segment) + "\"").size(), 1U)
        << segment_name(segment);
  }
  EXPECT_EQ(lines_with(dot, "--").size(), net.contacts.size());
  for (const TendonSpan& tendon : net.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const std::string edge = std::to_string(left) + "--" + std::to_string(right) + " ";
      EXPECT_EQ(lines_with(dot, edge).size(), 1U) << edge;
    }
  }
}

TEST(Dot, LabelsContactsByTheirPlaceAndDrawsThemByTheirKind) {
  const std::string dot = to_dot(network_of("M-1-T-2b-P-F"), "t");
  EXPECT_EQ(lines_with(dot, "[label=\"sheath\", style=bold]").size(), 3U);
  EXPECT_EQ(lines_with(dot, "[label=\"tip 1 (tube)\", style=solid]").size(), 1U);
  EXPECT_EQ(lines_with(dot, "[label=\"tube\", style=solid]").size(), 1U);
  EXPECT_EQ(lines_with(dot, "[label=\"tip 2 (bearing)\", style=dashed]").size(), 1U);
  EXPECT_EQ(lines_with(dot, "[label=\"movable pulley\", style=dashed]").size(), 1U);
  EXPECT_EQ(lines_with(dot, "shape=box").size(), 4U);
  EXPECT_EQ(lines_with(dot, "shape=ellipse").size(), 3U);
  EXPECT_EQ(lines_with(dot, "shape=plain").size(), 1U);
}

TEST(Dot, TiesTheTailOfABlockToEachStrandThatPassesIt) {
  const std::string dot = to_dot(network_of("M-Y1+1x-Y1-2x"), "t");  // a h1, T1 T3
  EXPECT_EQ(lines_with(dot, "[label=\"Y1\", style=dotted]"),
            (std::vector<std::string>{"1--2 [label=\"Y1\", style=dotted];",
                                      "1--3 [label=\"Y1\", style=dotted];"}));
}

TEST(Dot, CarriesItsTitle) {
  EXPECT_EQ(lines_with(to_dot(network_of("M-1-F"), "TR0: M-1-F"), "label=\"TR0: M-1-F\";").size(),
            1U);
}

TEST(Dot, WithAStateShowsTensionsAndSlidingDirections) {
  const Network net = network_of("M-1-F");
  TensionState state;
  state.tension = {1, 0.3227, 0.18333};
  state.slip = {-1, 0};
  const std::string dot = to_dot(net, "t", &state);
  EXPECT_EQ(lines_with(dot, "[label=\"a\\n1.000\"").size(), 1U);
  EXPECT_EQ(lines_with(dot, "[label=\"T1\\n0.323\"").size(), 1U);
  EXPECT_EQ(lines_with(dot, "[label=\"T2\\n0.183\"").size(), 1U);
  EXPECT_EQ(lines_with(dot, "0--1 [label=\"sheath\", style=bold, dir=back]").size(), 1U);
  EXPECT_EQ(lines_with(dot, "1--2 [label=\"tip 1 (tube)\", style=solid]").size(), 1U);
}

TEST(Dot, TheArrowOfTheContactThatClosesALoopPointsAlongTheWalk) {
  const Network net = network_of("1-P-1");  // T2 a b T1, and back to T2
  TensionState state;
  state.tension = {1, 1, 1, 1};
  state.slip = {0, 0, 0, 2};
  EXPECT_EQ(lines_with(to_dot(net, "t", &state), "3--0 ").at(0),
            "3--0 [label=\"tip 1 (tube)\", style=solid, dir=forward];");
}

}  // namespace
}  // namespace reeve
