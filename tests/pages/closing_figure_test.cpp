#include "pages/closing_figure.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/example_hand.hpp"
#include "tests/support/read_chart.hpp"

namespace reeve {
namespace {

studies::ShownClosing example_closing() {
  const std::vector<FingerJoint> joints = testing::three_joint_finger().joints;
  return {{1}, joints, close_finger(joints, 20)};
}

TEST(ClosingFigures, DrawTheAnglesInClosingAndInOpening) {
  const auto figures = pages::closing_figures(example_closing(), 2);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].id, "closing-2");
  const auto panels = testing::read_chart(figures[0].svg);
  ASSERT_EQ(panels.size(), 1U);
  EXPECT_EQ(panels[0].marks("paths").size(), 6U);
}

TEST(ClosingFigures, DrawPosturesInAStrip) {
  const auto figures = pages::closing_figures(example_closing(), 1);
  EXPECT_EQ(figures[1].id, "postures-1");
  const auto panels = testing::read_chart(figures[1].svg);
  ASSERT_EQ(panels.size(), 6U);
  for (const auto& panel : panels) EXPECT_EQ(panel.marks("points").size(), 4U);
}

}  // namespace
}  // namespace reeve
