// Axes over which a term's partial residuals (partial_residuals.hpp) are drawn.
//
//   law, or a cause that follows something   x: its covariate   y: f(x), a relative change of
//                                                               exponents or gains, or N
//   cause of a constant size      x: what it acts through, load at its contacts, tension at its
//                                 sensor or motor tension       y: size − nominal size
//   cause that is there or not               x: p − q, N        y: T − q, N
//
// p is the forecast with the term, q the one without it. A reading that runs through several
// contacts of the site stands at the mean of their loads. A product of two covariates is drawn over
// the product of their factors, where it is a straight line.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "causes/model_solver.hpp"
#include "causes/term.hpp"
#include "diagnosis/fit/forecast.hpp"

namespace reeve::diagnosis {

struct AxisName {
  std::string name;
  std::string unit;  // "1" of a number; "" where the name says it
};

enum class DrawnOver : std::uint8_t {
  contacts,  // load at the contacts of the site
  sensor,    // tension at the term's own sensor
  other,     // tension at another sensor of the row
  beside,    // sum of the tensions at the sensors beside its own
  recorded,  // a covariate that the row records
  product,   // product of the factors of two covariates
  row,       // sum of the readings, where no motor tension is recorded
  change,    // p − q
};

struct TermAxes {
  AxisName x;
  AxisName y;
  DrawnOver over = DrawnOver::recorded;
  causes::Covariate covariate{};  // recorded, other
  causes::Term product{};         // the term whose factors x is the product of
  // Sites of the term: its contacts, its sensor or the motor.
  std::vector<causes::Site> sites;
  // Laws whose constant is one more of y; none of a constant cause, whose own size is.
  std::vector<causes::Term> levers;
  bool multiplies = false;  // a lever acts on what the law has made of it, (1 + f)(1 + a)
  // y by the term's own values at x.
  std::function<double(const std::vector<double>& values, double x)> law;

  bool is_of_sensors() const {
    return sites.front().place == causes::SitePlace::channel ||
           sites.front().place == causes::SitePlace::channels;
  }
};

// `has_motor_tension`: of the data.
TermAxes term_axes(const Effect& effect, const Hardware& hardware, bool has_motor_tension);

// A cell, and the forecasts of all cells.
struct DrawnCell {
  const Dataset& dataset;
  const RowContacts& contacts;
  const Forecast& with;
  const Forecast& without;
  std::size_t cell = 0;

  std::size_t row() const { return dataset.cells[cell].row; }
};

struct PlaceOnAxes {
  double x = 0;
  double y = 0;  // the law's value
};

// NaN where the row does not say x.
PlaceOnAxes place_on(const TermAxes& axes, const std::vector<double>& values,
                     const DrawnCell& cell);

}  // namespace reeve::diagnosis
